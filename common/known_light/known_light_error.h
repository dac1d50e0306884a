// What the samples of a pixel say of its error where the light is known (predicted_error.h). The Gaussian process is
// one of the visibility v, and the estimate (albedo / pi) E(n) sum of m_j v_j, m_j = w_j L_j / sum of w_i L_i. Even
// light would have m_j = e_j = w_j / sum of w_i, and the variance V / pi^2 of an estimate of the mean of v. The error
// of v_j as the mean of v over its cap is nearly independent of those of others, and counts by m_j in place of e_j:
//     a^2 = (albedo / pi)^2 E(n)^2 (v - mean)^T Q^-1 (v - mean) / (n - 1),   U = V / pi^2 sum of m_j^2 / sum of e_j^2.
// (To linearise the quotient instead finds no error where one sample has nearly all the light, as under a sun.)
// Monte Carlo on independent directions has the variance of the v_j, and U = sum of m_j^2.
// A known sun adds (albedo / pi)^2 E_sun(n)^2 c / (2 m (m - 1)), where c counts how often one of its m rays, in their
// order, passes and the next does not, or the other way round: the successive differences of stratified samples
// (Wolter, "Introduction to Variance Estimation", 1985, chapter 7).
#pragma once

#include "known_light/known_light.h"
#include "prediction/predicted_error.h"

namespace bmc {
// A rule for the known light, and the process that gave it its weights; none for Monte Carlo.
struct ModelledLightRule : KnownLightRule {
    std::optional<GaussianProcess> process;
};

// Of the light from the sky, by a rule that the frame carries to the surface. Throws std::invalid_argument for one
// direction.
PixelError error_of_visible_sky(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit,
                                const ModelledLightRule& rule, const Frame& frame);

// The variance that so many rays to the sun add; nothing is known of one.
Color variance_of_visible_sun(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit, std::size_t rays,
                              const Random& random);

// Of a picture by these settings. Scene and light must outlive it.
ErrorOf error_of_known_light(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings,
                             const Progress& progress = nullptr);
}  // namespace bmc
