// Where the arithmetic of a Gaussian process breaks: condition numbers and residuals over the extremes of the number of
// samples, the noise, the covariance and the sample set.
#pragma once

#include "experiments/models.h"
#include "numerics/cholesky.h"

#include <string>
#include <vector>

enum class SampleSet { random, duplicates, equator, pole, cluster };
constexpr std::pair<const char*, SampleSet> sample_set_names[] = {{"random", SampleSet::random},
                                                                  {"duplicates", SampleSet::duplicates},
                                                                  {"equator", SampleSet::equator},
                                                                  {"pole", SampleSet::pole},
                                                                  {"cluster", SampleSet::cluster}};

// n directions: random and uniform; half as many, each of them twice; all on the rim; all at the pole; all within 1e-8
// of one direction.
std::vector<Vec3> sample_set(SampleSet set, std::size_t n);

// What LAPACK's test programs look at: residuals divided by what backward stable arithmetic leaves, so that a few at
// most are right whatever the condition number (LAPACK accepts up to 30).
struct Residuals {
    double factor = 0;     // |A - L L^T| / (n eps |A|)
    double inverse = 0;    // |I - A A^-1| / (n eps |A| |A^-1|)
    double condition = 0;  // |A| |A^-1|; all norms are row_sum_norm
};

// The residuals of a factored symmetric n x n matrix.
Residuals residuals_of(const Matrix& a, const Cholesky& cholesky, const Matrix& inverse);

struct StabilityRow {
    SampleSet set;
    std::size_t samples;
    Model model;
    double noise;
    std::string refusal = "";     // why the covariance matrix was refused; then the numbers below are 0
    Residuals residuals{};        // of up to 1000 samples: the inverse of more takes long
    double weight_error = 0;      // of the weights by solve, over the largest; infinite if no digit is right
    double inverse_error = 0;     // of the weights by inverse, of up to 1000 samples
    double absolute_weights = 0;  // sum of |w|
    double cosine_error = 0;      // of the estimate of the integral of cos(theta)
};

// A row for each noise. The errors of the weights are those from the directions on: covariances, z, factor and
// solution.
std::vector<StabilityRow> examine(SampleSet set, std::size_t n, const Model& model, const std::vector<double>& noises);

struct Stability {
    bool all = false;

    std::vector<Option> options();
    std::string report() const;
};
