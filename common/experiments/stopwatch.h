// How long an action takes.
#pragma once

#include "numerics/portable_math.h"

#include <algorithm>
#include <chrono>
#include <cmath>

// Fewest seconds of one call, of four measurements that take at least 2 ms each.
template <class Action>
double seconds_of(Action action) {
    double fewest = HUGE_VAL;
    for (int runs = 0, calls = 1; runs < 4;) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < calls; ++i) action();
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        if (seconds.count() < 2e-3) {
            calls *= 2;
        } else {
            fewest = std::min(fewest, seconds.count() / calls);
            ++runs;
        }
    }
    return fewest;
}
