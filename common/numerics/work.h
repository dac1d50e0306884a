// Long work: rows that several threads compute, how long they take, and what is said meanwhile on standard error.
#pragma once

#include <functional>
#include <string_view>

namespace bmc {
// The number of processors of this machine, at least 1.
std::size_t processors();

// Calls row(y) once for every y from 0 to rows - 1, in any order, on at most this number of threads. An exception of a
// call ends the work of all and reaches the caller.
void for_each_row(int rows, std::size_t threads, const std::function<void(int y)>& row);

// The seconds of one call: the least of four measurements, which take at least 2 ms each.
double time_call(const std::function<void()>& action);

// From one second on a terminal shows "43 %, 12 s left" (standard error). Work inside other work is a part of the
// other, and shows nothing.
class Progress {
public:
    explicit Progress(double parts);
    ~Progress();
    void done(double parts = 1);  // any thread may call this

private:
    const double parts_;
    double done_ = 0;
    const bool outermost_;
};

// Prints a line on stderr, which begins with the program's name. Control characters become question marks, and of a
// long text the middle is left out: it may quote options and files.
inline const char* program_name = "bmc";
void print_note(std::string_view text);
}  // namespace bmc
