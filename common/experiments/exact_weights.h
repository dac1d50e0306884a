// The weights of a Gaussian process to the last digit of a double: covariances, z and residuals in double-double
// arithmetic, from the directions.
#pragma once

#include "experiments/double_double.h"
#include "experiments/models.h"
#include "numerics/cholesky.h"
#include "numerics/vec3.h"

#include <optional>
#include <vector>

// The largest absolute value.
double largest(const std::vector<double>& x);

class ExactWeights {
public:
    // n directions in the upper hemisphere. Holds 8 n^2 bytes.
    ExactWeights(const Model& model, const std::vector<Vec3>& directions);

    // w with (Q + noise^2 I) w = z, from a factor of that matrix in doubles: a solution corrected until it stands
    // (Golub & Van Loan, "Matrix Computations", section 3.5.3). Nothing if the corrections do not shrink: then the
    // factor has no correct digit to correct with.
    std::optional<std::vector<double>> weights(double noise, const Cholesky& cholesky) const;

private:
    std::vector<double> residual(const std::vector<double>& weights, double noise) const;

    std::vector<DoubleDouble> upper_;  // of Q without noise, row after row from the diagonal on
    std::vector<DoubleDouble> z_;
};
