// How far off the weights of a Gaussian process are, beside weights that are right to the last digit of a double:
// covariances, z and residuals in double-double arithmetic, from the directions.
#pragma once

#include "experiments/double_double.h"
#include "experiments/models.h"
#include "numerics/cholesky.h"
#include "numerics/vec3.h"

#include <vector>

class ExactWeights {
public:
    // n directions in the upper hemisphere. Holds 8 n^2 bytes.
    ExactWeights(const Model& model, const std::vector<Vec3>& directions);

    // The largest error of the weights, over the largest of the w with (Q + noise^2 I) w = z. The factor of that matrix
    // in doubles gives w: a solution corrected until it stands (Golub & Van Loan, "Matrix Computations", section
    // 3.5.3). Infinite if the corrections do not shrink: then the factor has no correct digit to correct with.
    double error_of(std::vector<double> weights, double noise, const Cholesky& cholesky) const;

private:
    std::vector<double> residual(const std::vector<double>& weights, double noise) const;

    std::vector<DoubleDouble> upper_;  // of Q without noise, row after row from the diagonal on
    std::vector<DoubleDouble> z_;
};
