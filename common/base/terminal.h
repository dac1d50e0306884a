// What a person sees on standard error: notes, and how far a long calculation is.
#pragma once

#include <string_view>

namespace bmc {
// Prints a line on stderr, which begins with the program's name. Control characters become question marks, and of a
// long text the middle is left out: it may quote options and files.
inline const char* program_name = "bmc";
void print_note(std::string_view text);

// From one second on a terminal shows "43 %, 12 s left" (standard error), or as much of it as fits on its line. A
// calculation inside another one is a part of the other, and shows nothing.
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
}  // namespace bmc
