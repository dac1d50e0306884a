#include "numerics/parallel.h"

#include "test.h"

#include <atomic>
#include <chrono>
#include <thread>

// Rows take a while, so that each thread gets some.
TEST_CASE(
    "every row is computed once, whatever the number of threads, and one of them tells progress, which grows to 1") {
    for (const auto& [rows, threads] : {std::pair(100, 1u), {100, 3u}, {100, 300u}, {1, 1u}}) {
        std::vector<int> calls(static_cast<std::size_t>(rows));
        double last = 0;
        for_each_row(
            rows, threads,
            [&](int y) {
                ++calls[static_cast<std::size_t>(y)];
                std::this_thread::sleep_for(std::chrono::microseconds(100));
            },
            [&, caller = std::this_thread::get_id()](double done) {
                CHECK((done > last && std::this_thread::get_id() == caller));
                last = done;
            });
        CHECK(calls == std::vector<int>(calls.size(), 1));
        CHECK(last == 1);
    }
}

// Short rows, so that threads meet at the counter.
TEST_CASE("no row is computed twice or left out where many threads count short ones") {
    std::vector<std::atomic<int>> calls(200000);
    for_each_row(200000, 8, [&](int y) { ++calls[static_cast<std::size_t>(y)]; });
    CHECK(std::all_of(calls.begin(), calls.end(), [](const std::atomic<int>& count) { return count == 1; }));
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

// Each of two threads has a row, and waits with it for the other.
TEST_CASE("an exception of another thread reaches the caller") {
    std::atomic<int> begun{0};
    const auto caller = std::this_thread::get_id();
    const auto fail_elsewhere = [&](int) {
        ++begun;
        for (int i = 0; i < 10000 && begun < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (std::this_thread::get_id() != caller) throw std::bad_alloc();
    };
    CHECK_THROWS_AS(for_each_row(2, 2, fail_elsewhere), std::bad_alloc);
}
