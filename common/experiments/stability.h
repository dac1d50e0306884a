// Where the arithmetic of a Gaussian process breaks: how many digits of its weights are right at the extremes of the
// number of samples, the noise, the covariance and the sample set. Rotating all directions about the up axis must not
// change a weight (covariance.h), nor must three times the covariance and the squared noise, but they change every
// rounding error. The digits that stay the same are right.
#pragma once

#include "command_line/command_line.h"

namespace bmc {
// What `workbench stability` prints.
struct StabilityReport : Experiment {
    std::string report() const override;
};
}  // namespace bmc
