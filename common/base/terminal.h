// What a person sees on standard error: notes, and how far a long calculation is.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace bmc {
// Prints a line on stderr, which begins with the program's name. Control characters become question marks: it may quote
// options and files.
inline const char* program_name = "bmc";
void print_note(std::string_view text);

// A phase of a long calculation, which consists of equal parts. Once the program has run for a second, a terminal shows
// "2. picture: 43 %, 12 s left" until the phase ends; the number counts the phases that it has shown. A phase inside
// another one is a part of it, and shows nothing itself.
class Progress {
public:
    Progress(const std::string& phase, std::size_t parts);
    ~Progress();
    void done();  // one part more; any thread may call this

private:
    const bool inside_another_;
    const std::string phase_;
    const std::size_t parts_;
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::size_t done_ = 0, percent_ = 0;
};
}  // namespace bmc
