// The reports of the workbench, a source for each. A report takes the arguments of its command and returns what that
// prints, which says what the columns mean.
#pragma once

#include "command_line/command_line.h"

namespace bmc {
std::string error_tables(Arguments& arguments);      // error_table.cpp: errors of both methods, without a command
std::string rule_report(Arguments& arguments);       // rule.cpp: directions, drawn or from a file, z and weights
std::string belief_discs(Arguments& arguments);      // belief.cpp: a picture of a posterior; its integral on stderr
std::string light_file(Arguments& arguments);        // light_file.cpp: an environment as PFM, for other programs
std::string tradeoff_report(Arguments& arguments);   // tradeoff.cpp: times and errors of rules and pictures
std::string models_report(Arguments& arguments);     // models.cpp: errors and evidence of covariances and noises
std::string stability_report(Arguments& arguments);  // stability.cpp: right digits of weights at the extremes
}  // namespace bmc
