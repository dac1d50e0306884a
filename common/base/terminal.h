// What standard C++ cannot tell of the terminal, and what it cannot ask of standard input and output. The source does
// so where the system is known to it, and nothing elsewhere.
#pragma once

namespace bmc {
// Whether standard output goes to a terminal.
bool output_is_terminal();

// Whether standard error goes to a terminal that can go back in a line, and that is not another program's.
bool is_in_foreground();

// Of input and output, the bytes are kept as they are, and who reads slowly loses nothing.
void keep_all_bytes();
}  // namespace bmc
