// The reports of the workbench: a source for each, whose function takes a command's arguments and returns what it
// prints.
#pragma once

#include "command_line/command_line.h"

namespace bmc {
// error_table.cpp, without a command: the tables of the practice's integrands.
std::string error_tables(Arguments& arguments);

// rule.cpp: the directions of a rule, drawn or from a file, z and the weights; what the weights sum to; with values the
// estimate of their integral.
std::string rule_report(Arguments& arguments);

// belief.cpp: what a Gaussian process believes of the light that arrives at a point of the rectangle. Four discs side
// by side, as PPM, show the light and the samples, the posterior mean, the posterior standard deviation, and the error
// of the mean. stderr has the estimate of the integral.
std::string belief_discs(Arguments& arguments);

// light_file.cpp: an environment as a PFM file, which other programs read.
std::string light_file(Arguments& arguments);

// tradeoff.cpp: what accuracy costs. The time of each step of a rule, and the errors and the time of a picture by every
// method.
std::string tradeoff_report(Arguments& arguments);

// known_light.cpp: what is gained by knowing the light, and by what else renderers do with a light that they know.
std::string known_light_report(Arguments& arguments);

// models.cpp: which covariance and which noise the scene requires. It compares their errors, which takes the truth,
// their evidence, which does not, and the errors that they predict.
std::string models_report(Arguments& arguments);

// stability.cpp: where the arithmetic of a Gaussian process breaks. How many digits of its weights are right at the
// extremes of the number of samples, the noise, the covariance and the sample set. Neither another order of the
// directions nor their rotation about the up axis must change a weight (covariance.h), nor must three times the
// covariance and the squared noise, but they change every rounding error. The digits that stay the same are right: a
// test compares them with weights of 128 bits.
std::string stability_report(Arguments& arguments);
}  // namespace bmc
