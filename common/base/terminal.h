// What a person sees on standard error, and what standard C++ cannot ask of the system. The source asks where it knows
// the system; elsewhere the answer is no.
#pragma once

#include <string_view>

namespace bmc {
// Prints a line on stderr, which begins with the program's name. Control characters become question marks: it may quote
// options and files.
inline const char* program_name = "bmc";
void print_note(std::string_view text);

// Shows a line on stderr until the next one is shown, or a note; an empty one clears it.
void show_line(std::string_view text);

bool output_is_terminal();
bool is_in_foreground();  // whether stderr goes to a terminal that can go back in a line, and no other program has it
void keep_all_bytes();    // of input and output: binary streams, and writing waits for a slow reader
}  // namespace bmc
