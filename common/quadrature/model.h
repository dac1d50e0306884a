// The settings of a model, which the options of both programs set.
#pragma once

#include "quadrature/covariance.h"
#include "quadrature/placement.h"

#include <optional>

namespace bmc {
// The largest Gaussian process that a program accepts: Q has 128 MiB and takes seconds to factor.
inline constexpr std::size_t max_process_samples = 4096;

// All settings of a rule, except its number of directions.
struct ModelSettings {
    CovarianceFamily covariance = CovarianceFamily::sobolev;
    double smoothness = 1.5;  // of sobolev
    double length_scale = 1;  // of any other family
    double noise = 0.01;
    std::optional<Known> known = {};  // unless given, the density of the placement
    Placement placement = {};
    std::uint64_t seed = 1;

    double parameter() const { return covariance == CovarianceFamily::sobolev ? smoothness : length_scale; }
    Known known_or_usual() const { return known.value_or(known_of(placement.density)); }
    std::shared_ptr<const Covariance> make_covariance() const {
        return bmc::make_covariance(covariance, parameter(), known_or_usual());
    }
};
}  // namespace bmc
