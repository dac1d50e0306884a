// How long an action takes.
#pragma once

#include "numerics/portable_math.h"

#include <algorithm>
#include <chrono>
#include <vector>

template <class Action>
double seconds_of(Action action) {
    const auto start = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Median seconds of one call, of seven measurements that take at least 2 ms each.
template <class Action>
double median_seconds(Action action) {
    const double once = seconds_of(action);
    const int calls = 1 + static_cast<int>(2e-3 / once);
    std::vector<double> seconds;
    for (int run = 0; run < 7; ++run)
        seconds.push_back(seconds_of([&] {
                              for (int i = 0; i < calls; ++i) action();
                          }) /
                          calls);
    std::sort(seconds.begin(), seconds.end());
    return seconds[3];
}
