// What the samples of a pixel say of its error, without the truth: the variance a^2 U of each colour, where a^2 is told
// by what the samples are and U by where they are.
// A Gaussian process of amplitude a errs with the variance a^2 V (gaussian_process.h), so that, with the reflected
// light (albedo / pi) I,
//     a^2 = (albedo / pi)^2 Y^T Q^-1 Y / n,   U = V.
// Where the light is known the process is one of the visibility v, and the estimate (albedo / pi) E(n) sum of m_j v_j,
// m_j = w_j L_j / sum of w_i L_i (known_light.h). Even light would have m_j = e_j = w_j / sum of w_i, and the variance
// V / pi^2 of an estimate of the mean of v. What a sample's v_j errs by as the mean of v over its cap is nearly
// independent of what others err by, and counts by m_j in place of e_j:
//     a^2 = (albedo / pi)^2 E(n)^2 (v - mean)^T Q^-1 (v - mean) / (n - 1),   U = V / pi^2 sum of m_j^2 / sum of e_j^2.
// (To linearise the quotient instead finds no error where one sample has nearly all the light, as under a sun.)
// Monte Carlo on independent directions has the variance of its samples in place of Y^T Q^-1 Y / n, and U = 1 / n; for
// a known light the variance of the v_j, and U = sum of m_j^2.
// A known sun adds (albedo / pi)^2 E_sun(n)^2 c / (2 m (m - 1)), c how often one of its m rays, in their order, passes
// and the next does not, or the other way round: the successive differences of stratified samples (Wolter,
// "Introduction to Variance Estimation", 1985, chapter 7).
#pragma once

#include "scene/image.h"
#include "scene/pixel_rules.h"

struct PixelError {
    Color amplitude;  // a^2
    Color variance;   // U
    Color sun{};      // the variance by a known sun
};

// Of what a point reflects by a rule of Monte Carlo, or of a process that was kept. Throws std::invalid_argument for
// one direction, unless the process has a zero mean and models the light.
PixelError pixel_error(const Scene& scene, const Light& light, KnownPart known, const Hit& hit,
                       const PlacedRule& placed);

// The predicted standard error. A pixel all of whose n samples are dark, or visible, has a = 0 and knows nothing: the
// mean square of a over the picture counts as much as three more samples,
//     se^2 = U (n a^2 + 3 a_picture^2) / (n + 3).
Color standard_error(const PixelError& error, Color picture_amplitude, std::size_t samples);

// Of a picture's errors: their root mean square over so many pixels, all others being 0; and the picture that shows the
// root mean square over the colours of each pixel in grey, 0 black and `white` white.
double root_mean_square(const Image& errors, double pixels);
Image grey_scale(const Image& errors, double white);
