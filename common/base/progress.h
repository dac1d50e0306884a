// How a long calculation runs: its rows by several threads, and how far it is.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace bmc {
// The number of processors of this machine, at least 1.
std::size_t processors();

// Calls row(y) once for every y from 0 to rows - 1, in any order, on at most this number of threads. If a call throws,
// no thread begins another row, and the exception reaches the caller.
void for_each_row(int rows, std::size_t threads, const std::function<void(int y)>& row);

// A phase of a long calculation, which consists of equal parts. Every second the terminal shows "picture: 43 %, 12 s
// left", until the phase ends; but not from the background, where another program has the terminal.
class Progress {
public:
    Progress(const std::string& phase, std::size_t parts);
    ~Progress();
    void done();  // one part more; any thread may call this

private:
    const std::string phase_;
    const std::size_t parts_;
    const double start_;  // seconds
    double shown_ = 0;    // seconds from the start
    std::size_t done_ = 0;
};
}  // namespace bmc
