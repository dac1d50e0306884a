// The error of a pixel, predicted by its samples (predicted_error.h), if the light is known. The Gaussian process
// models the visibility v. The estimate is (albedo / pi) E(n) sum of m_j v_j, where m_j = w_j L_j / sum of w_i L_i. For
// an even light m_j = e_j = w_j / sum of w_i, and the mean of v has the variance V / pi^2. v_j stands for the mean of v
// over its cap. The errors of that are nearly independent, and count by m_j in place of e_j:
//     a^2 = (albedo / pi)^2 E(n)^2 (v - mean)^T Q^-1 (v - mean) / (n - 1),   U = V / pi^2 sum of m_j^2 / sum of e_j^2.
// (A linearised quotient would predict no error where one sample has nearly all the light, as under a sun.)
// Monte Carlo on independent directions has the variance of the v_j, and U = sum of m_j^2.
// A known sun adds (albedo / pi)^2 E_sun(n)^2 c / (2 m (m - 1)), where c counts how often the visibilities of one of
// its m rays and of the next differ: the successive differences of stratified samples (Wolter, "Introduction to
// Variance Estimation", 1985, chapter 7).
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

// The variance that so many rays to the sun add. One ray predicts none.
Color variance_of_visible_sun(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit, std::size_t rays,
                              const Random& random);

// Of a picture by these settings. Scene and light must outlive it.
ErrorOf error_of_known_light(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings,
                             const Progress& progress = nullptr);
}  // namespace bmc
