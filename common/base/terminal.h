// What a person sees on standard error: notes, and how far a long calculation is.
#pragma once

#include <string>
#include <string_view>

namespace bmc {
// Prints a line on stderr, which begins with the program's name. Control characters become question marks: it may quote
// options and files.
inline const char* program_name = "bmc";
void print_note(std::string_view text);

// A phase of a long calculation, which consists of equal parts. After its first second a terminal shows "picture: 43 %,
// 12 s left", until it ends.
class Progress {
public:
    Progress(const std::string& phase, std::size_t parts);
    ~Progress();
    void done();  // one part more; any thread may call this

private:
    const std::string phase_;
    const std::size_t parts_;
    const double start_;  // seconds
    std::size_t done_ = 0, percent_ = 0;
};
}  // namespace bmc
