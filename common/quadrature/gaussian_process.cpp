#include "quadrature/gaussian_process.h"

#include "numerics/formatted.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace bmc {
namespace {

double sum_of_products(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

// BEGIN SOLUTION integral
// The weights w = Q^-1 z, from the factor of Q.
std::vector<double> bayesian_weights(const Cholesky& cholesky, const std::vector<double>& z) {
    return cholesky.solve(z);
}
// END SOLUTION

// BEGIN SOLUTION integral
// The posterior variance zz - z^T Q^-1 z of the integral. It is not negative, but rounding can make it so.
double posterior_variance(double zz, const std::vector<double>& z, const std::vector<double>& weights) {
    return std::max(0.0, zz - sum_of_products(z, weights));
}
// END SOLUTION

void require_upper_hemisphere(const std::vector<Vec3>& directions) {
    for (const Vec3& direction : directions)
        if (!(direction.y >= 0))
            throw std::invalid_argument(formatted("a direction lies below the horizon: its y is %.9g", direction.y));
}

void require_valid(double noise, const std::vector<Vec3>& directions) {
    if (directions.empty()) throw std::invalid_argument("a Gaussian process needs at least one direction");
    if (!(noise >= 0 && std::isfinite(noise)))
        throw std::invalid_argument(formatted("the noise must be at least 0; it is %.9g", noise));
}

}  // namespace

// BEGIN SOLUTION z
// Each z_j from the closed form that the covariance has for it, a function of the elevation cosine y of the direction;
// rounding can leave y slightly above 1.
std::vector<double> z_of(const Covariance& covariance, const std::vector<Vec3>& directions, Known known) {
    require_upper_hemisphere(directions);
    std::vector<double> z;
    z.reserve(directions.size());
    for (const Vec3& direction : directions) z.push_back(std::min(direction.y, 1.0));
    covariance.integrate(z, known);
    return z;
}
// END SOLUTION

// BEGIN SOLUTION inverse
// Q_ij = k(w_i, w_j) + noise^2 delta_ij. The covariance is a function of the squared chord |w_i - w_j|^2.
Matrix covariance_matrix(const Covariance& covariance, double noise, const std::vector<Vec3>& directions) {
    require_valid(noise, directions);
    Matrix q(directions.size(), directions.size());
    for (std::size_t i = 0; i < q.rows(); ++i) {
        for (std::size_t j = i; j < q.rows(); ++j) q(i, j) = squared_distance(directions[i], directions[j]);
        covariance.evaluate(&q(i, i), q.rows() - i);
        q(i, i) += noise * noise;
    }
    return q;
}
// END SOLUTION

GaussianProcess::GaussianProcess(const Covariance& covariance, double noise, std::vector<Vec3> directions, Known known)
    : directions_(std::move(directions)),
      z_(z_of(covariance, directions_, known)),
      cholesky_(covariance_matrix(covariance, noise, directions_)),
      weights_(bayesian_weights(cholesky_, z_)),
      variance_(posterior_variance(covariance.integral_of_z(known), z_, weights_)) {}

// BEGIN SOLUTION integral
double GaussianProcess::integral(const std::vector<double>& values) const {
    require_one_value_per_direction(values);
    return sum_of_products(weights_, values);
}
// END SOLUTION

double GaussianProcess::amplitude(const std::vector<double>& values) const {
    require_one_value_per_direction(values);
    const std::vector<double> whitened = cholesky_.solve_lower(values);
    return std::sqrt(sum_of_products(whitened, whitened) / static_cast<double>(values.size()));
}

double GaussianProcess::standard_error(const std::vector<double>& values) const {
    return amplitude(values) * std::sqrt(variance());
}

double GaussianProcess::log_evidence(const std::vector<double>& values) const {
    const double n = static_cast<double>(values.size());
    return -n * portable::log(amplitude(values)) - 0.5 * cholesky_.log_determinant();
}

void GaussianProcess::require_one_value_per_direction(const std::vector<double>& values) const {
    if (values.size() != directions_.size())
        throw std::invalid_argument(
            formatted("a Gaussian process of %zu directions was given %zu values", directions_.size(), values.size()));
}
}  // namespace bmc
