#include "base/progress.h"
#include "test.h"

#include <atomic>
#include <chrono>
#include <thread>

// Each of two threads has a row, and waits with it for the other.
TEST_CASE("an exception of either of two threads reaches the caller") {
    for (const bool of_caller : {true, false}) {
        CAPTURE(of_caller);
        std::atomic<int> begun{0};
        const auto caller = std::this_thread::get_id();
        const auto fail = [&](int) {
            ++begun;
            for (int i = 0; i < 10000 && begun < 2; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
            if ((std::this_thread::get_id() == caller) == of_caller) throw std::bad_alloc();
        };
        CHECK_THROWS_AS(for_each_row(2, 2, fail), std::bad_alloc);
        CHECK(begun == 2);
    }
}

TEST_CASE("after an exception of one thread the other begins no more rows") {
    std::atomic<int> later{0};
    const auto fail_first = [&](int y) {
        if (y == 0) throw std::bad_alloc();
        ++later;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    CHECK_THROWS_AS(for_each_row(300, 2, fail_first), std::bad_alloc);
    CHECK(later < 299);
}
