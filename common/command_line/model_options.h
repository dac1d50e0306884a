// The options that both programs take: those of a Gaussian process and of its samples.
#pragma once

#include "command_line/command_line.h"
#include "quadrature/quadrature.h"

namespace bmc {
// The largest Gaussian process that a program accepts: Q has 128 MiB and takes seconds to factor.
inline constexpr std::size_t max_process_samples = 4096;

// covariance, smoothness, length-scale, noise, known, placement, seed.
void add_model_options(Options& options, ModelSettings& settings);
inline constexpr const char* known_remark =
    ": known factor of the integrand; a cosine placement makes it cosine unless given";

// samples: a list such as 10,20,40, each at most max_process_samples.
void add_sample_list(Options& options, std::vector<std::size_t>& samples);
}  // namespace bmc
