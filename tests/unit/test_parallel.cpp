#include "numerics/parallel.h"

#include "test.h"

#include <atomic>
#include <thread>

// Rows take a while, so that each thread gets some.
TEST_CASE("every row is computed once by any number of threads, and one of them tells progress, which ends at 1") {
    for (const unsigned threads : {1u, 3u, 300u}) {
        std::vector<int> calls(100);
        double last = 0;
        for_each_row(
            100, threads,
            [&](int y) {
                ++calls[static_cast<std::size_t>(y)];
                std::this_thread::sleep_for(std::chrono::microseconds(100));
            },
            [&, caller = std::this_thread::get_id()](double done) {
                CHECK((done > last && std::this_thread::get_id() == caller));
                last = done;
            });
        CHECK(calls == std::vector<int>(100, 1));
        CHECK(last == 1);
    }
}

// Short rows, so that threads meet at the counter.
TEST_CASE("no row is computed twice or left out where many threads count short ones") {
    std::vector<std::atomic<int>> calls(200000);
    for_each_row(200000, 8, [&](int y) { ++calls[static_cast<std::size_t>(y)]; });
    CHECK(std::all_of(calls.begin(), calls.end(), [](const std::atomic<int>& count) { return count == 1; }));
}

TEST_CASE("the progress of one row is 1") {
    std::vector<double> told;
    for_each_row(
        1, 1, [](int) {}, [&](double done) { told.push_back(done); });
    CHECK(told == std::vector<double>{1});
}

TEST_CASE("an exception of one row ends the others' work and reaches the caller") {
    for (const unsigned threads : {1u, 2u}) {
        std::atomic<int> calls{0};
        const auto fail = [&](int y) {
            ++calls;
            if (y == 0) throw std::bad_alloc();
        };
        CHECK_THROWS_AS(for_each_row(1 << 28, threads, fail), std::bad_alloc);
        CHECK(calls < 1 << 27);
    }
}
