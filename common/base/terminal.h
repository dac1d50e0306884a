// What standard C++ cannot ask of the system. The source does where it knows the system, and nothing elsewhere.
#pragma once

namespace bmc {
bool output_is_terminal();
bool is_in_foreground();  // whether stderr goes to a terminal that can go back in a line, and no other program has it
void keep_all_bytes();    // of input and output, as they are; and who reads slowly loses none
}  // namespace bmc
