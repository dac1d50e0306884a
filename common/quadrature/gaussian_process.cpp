#include "quadrature/gaussian_process.h"

#include "base/formatted.h"

#include <numeric>

namespace bmc {
static double dot(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size())
        throw std::logic_error(formatted("a process of %zu directions was given %zu values", a.size(), b.size()));
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// w = Q^-1 z, from the factor of Q.
// BEGIN SOLUTION integral
std::vector<double> bayesian_weights(const Cholesky& cholesky, const std::vector<double>& z) {
    return cholesky.solve(z);
}
// END SOLUTION

// zz - z^T Q^-1 z, where weights = Q^-1 z. A variance is not negative; where rounding makes it so, it is 0.
// BEGIN SOLUTION integral
double posterior_variance(double zz, const std::vector<double>& z, const std::vector<double>& weights) {
    const double variance = zz - dot(z, weights);
    return variance > 0 ? variance : 0;
}
// END SOLUTION

static std::vector<Vec3> checked(std::vector<Vec3> directions, double noise) {
    if (directions.empty()) throw std::invalid_argument("a Gaussian process needs at least one direction");
    if (!(noise >= 0 && noise <= DBL_MAX))
        throw std::invalid_argument(formatted("the noise must be at least 0; it is %.9g", noise));
    return directions;
}

// z_j is a function of cos(theta) of direction j, its y, in eight digits at least: covariance.z has them. A mean over
// 50,000 random directions, as the sheet's base code takes, has two or three. Rounding can leave y slightly above 1.
// BEGIN SOLUTION z
std::vector<double> z_of(const Covariance& covariance, const std::vector<Vec3>& directions) {
    std::vector<double> z;
    for (const Vec3& direction : directions) z.push_back(covariance.z(std::min(direction.y, 1.0)));
    return z;
}
// END SOLUTION

// Q_ij = k(omega_i, omega_j) + noise^2 delta_ij, where k is a function of the squared chord |omega_i - omega_j|^2.
// BEGIN SOLUTION inverse
Matrix covariance_matrix(const Covariance& covariance, double noise, const std::vector<Vec3>& directions) {
    const std::size_t n = directions.size();
    Matrix q(n, n);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j)
            q(i, j) = q(j, i) = covariance.k(squared_distance(directions[i], directions[j]));
        q(i, i) += noise * noise;
    }
    return q;
}
// END SOLUTION

// C++ makes members in the order of the header, so that each can be made from those before it.
GaussianProcess::GaussianProcess(const Covariance& covariance, double noise, std::vector<Vec3> unit_directions)
    : known(covariance.known),
      directions(checked(std::move(unit_directions), noise)),
      z(z_of(covariance, directions)),
      cholesky(covariance_matrix(covariance, noise, directions)),
      weights(bayesian_weights(cholesky, z)),
      zz(covariance.zz()),
      variance(posterior_variance(zz, z, weights)) {}

// BEGIN SOLUTION integral
double GaussianProcess::integral(const std::vector<double>& values) const { return dot(weights, values); }
// END SOLUTION

double GaussianProcess::amplitude(const std::vector<double>& values) const {
    const std::vector<double> g = cholesky.forward_substitution(values);  // |g|^2 = Y^T Q^-1 Y
    return std::sqrt(dot(g, g) / static_cast<double>(values.size()));
}

double GaussianProcess::log_evidence(const std::vector<double>& values) const {
    double half_log_determinant = 0;
    for (std::size_t k = 0; k < values.size(); ++k) half_log_determinant += portable::log(cholesky.upper(k, k));
    return -static_cast<double>(values.size()) * portable::log(amplitude(values)) - half_log_determinant;
}
}  // namespace bmc
