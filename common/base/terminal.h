// What a person sees on standard error: notes, and how far a long calculation is.
#pragma once

#include <cstddef>
#include <string_view>

namespace bmc {
// Prints a line on stderr, which begins with the program's name. Control characters become question marks, and of a
// long text the middle is left out: it may quote options and files.
inline const char* program_name = "bmc";
void print_note(std::string_view text);

// The parts of a long calculation that are done. A calculation inside another one is inside a part of that. From the
// second second of the program on a terminal shows "43 %" (standard error) of what was left then. It never goes back.
class Progress {
public:
    explicit Progress(std::size_t parts);
    ~Progress();
    void done();  // one part more; any thread may call this

private:
    Progress* const outer_;
    std::size_t parts_, done_ = 0;
};
}  // namespace bmc
