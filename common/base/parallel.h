// Rows computed by several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace bmc {
// The number of processors of this machine, at least 1.
std::size_t processors();

// Calls row(y) once for every y from 0 to rows - 1, in any order, on at most this number of threads. If a call throws,
// no thread begins another row, and the exception reaches the caller.
void for_each_row(int rows, std::size_t threads, const std::function<void(int y)>& row);
}  // namespace bmc
