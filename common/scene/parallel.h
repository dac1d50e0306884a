// Rows of a picture, computed by several threads.
#pragma once

#include <functional>

namespace bmc {
// Called with the fraction of a work that is done, from one thread; it grows to 1.
using Progress = std::function<void(double)>;

// The progress of a part of the work, from one fraction of the whole to another.
Progress part_of(const Progress& whole, double begin, double end);

// Calls row(y) once for every y from 0 to rows - 1, in any order, on so many threads at most. An exception of any call
// ends the work and reaches the caller.
void for_each_row(int rows, unsigned threads, const std::function<void(int)>& row, const Progress& progress = nullptr);
}  // namespace bmc
