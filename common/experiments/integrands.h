// Functions over the hemisphere whose integrals are known, for experiments to estimate.
#pragma once

#include "light/environment.h"
#include "quadrature/model.h"
#include "quadrature/quadrature.h"

#include <functional>
#include <memory>
#include <string>

namespace bmc {
// A function over the hemisphere and its integral w.r.t. solid angle.
struct Integrand {
    std::string formula;
    std::function<double(Vec3)> value;
    double truth;
};

// The integrands that the workbench knows by name.
inline constexpr const char* integrand_names[] = {"cosine", "cosine-cubed", "environment", "constant"};
Integrand integrand_named(std::string_view name);

// The luminance of a light times cos(theta) above a tilted surface. Its truth is reference_integral.
Integrand environment_integrand(const std::shared_ptr<const EnvironmentMap>& light);

// The integral of f by 2^18 directions on the Fibonacci lattice.
double reference_integral(const std::function<double(Vec3)>& f);

// The unknown part of f at each direction: its value divided by the known part.
std::vector<double> unknown_part(const std::function<double(Vec3)>& f, const std::vector<Vec3>& directions,
                                 Known known = Known::nothing);

// The rule's estimate of the integral of f.
double estimate(const QuadratureRule& rule, const std::function<double(Vec3)>& f);

// The directions of each estimate, by its number, with n samples: the same in every experiment with these settings.
std::function<std::vector<Vec3>(std::size_t)> directions_of_estimates(const ModelSettings& settings, std::size_t n);
}  // namespace bmc
