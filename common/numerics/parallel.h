// Rows of a picture, computed by several threads.
#pragma once

#include <functional>

namespace bmc {
// Called with the fraction of the work that is done, which grows to 1, always from one thread.
using Progress = std::function<void(double)>;

// Calls row(y) once for every y from 0 to rows - 1, in any order, on at most this number of threads. An exception of a
// call ends the work of all and reaches the caller.
void for_each_row(int rows, unsigned threads, const std::function<void(int)>& row, const Progress& progress = nullptr);
}  // namespace bmc
