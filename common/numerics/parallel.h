// Rows of a picture, computed by several threads.
#pragma once

#include <functional>

namespace bmc {
// Calls row(y) once for every y from 0 to rows - 1, in any order, on at most this number of threads. An exception of a
// call ends the work of all and reaches the caller.
void for_each_row(int rows, unsigned threads, const std::function<void(int)>& row);
}  // namespace bmc
