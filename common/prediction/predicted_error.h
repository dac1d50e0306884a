// The error of a pixel, predicted by its samples without the truth: the variance a^2 U of each colour. a^2 follows from
// the values of the samples, U from their directions.
// The error of a Gaussian process of amplitude a has the variance a^2 V (gaussian_process.h). The reflected light is
// (albedo / pi) I, so
//     a^2 = (albedo / pi)^2 Y^T Q^-1 Y / n,   U = V.
// Monte Carlo on independent directions has the variance of its samples in place of Y^T Q^-1 Y / n, and U = 1 / n.
#pragma once

#include "scene/render.h"

#include <optional>

namespace bmc {
struct PixelError {
    Color squared_amplitude;  // a^2
    Color unit_variance;      // U
    std::size_t samples;      // n
    Color other_variance{};   // of the part of the light that these samples do not estimate
};

// The error of the light that a point reflects, from its pixel's stream of random numbers. Many threads call it.
using ErrorOf = std::function<PixelError(const Hit&, Random&)>;

// A rule, and the process that gave it its weights; none for Monte Carlo.
struct ModelledRule : PixelRule {
    std::optional<GaussianProcess> process;
};

// By a rule that the frame carries to the surface. Throws std::invalid_argument for one direction without a process.
PixelError error_of_light(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                          const ModelledRule& rule, const Frame& frame, KnownPart known);

// Of a picture by these settings, throwing alike. Scene and environment must outlive it.
ErrorOf error_of_picture(const Scene& scene, const EnvironmentMap& environment, const RenderSettings& settings,
                         const Progress& progress = nullptr);

// Whether a picture's samples predict its error. Those of Monte Carlo have to be independent, and at least two.
bool predicts_error(const RenderSettings& settings);

// The predicted standard error. A pixel whose n samples are all dark has a = 0, though it knows nothing. So the mean of
// a^2 over the picture counts like three samples more,
//     se^2 = U (n a^2 + 3 a_picture^2) / (n + 3) + other_variance.
Color standard_error(const PixelError& error, Color picture_squared_amplitude);

// Of a picture's errors: their root mean square over so many pixels, if all others are 0 (0 of no pixels); and a
// picture that shows the root mean square over each pixel's colours in grey, from black at 0 to white at `white`.
double root_mean_square(const Image& errors, double pixels);
Image grey_scale(const Image& errors, double white);

// Each colour by itself: (*colour).x, y, z.
constexpr double Color::*channels[] = {&Color::x, &Color::y, &Color::z};

double sum_of_squares(const std::vector<double>& values);

// Each value less their mean. Throws std::invalid_argument for one value.
std::vector<double> deviations(std::vector<double> values);
}  // namespace bmc
