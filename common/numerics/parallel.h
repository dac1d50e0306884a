// Rows of a picture, computed by several threads.
#pragma once

#include <functional>

namespace bmc {
// Is told the fraction of the work that is done, which grows to 1; by one thread only.
using Progress = std::function<void(double)>;

// Calls row(y) once for every y from 0 to rows - 1, in any order, on at most so many threads. An exception of a call
// ends the work of all and reaches the caller.
void for_each_row(int rows, unsigned threads, const std::function<void(int)>& row, const Progress& progress = nullptr);
}  // namespace bmc
