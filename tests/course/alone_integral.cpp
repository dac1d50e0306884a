// alone_integral integral: what the functions of the task integral give where Q, its inverse and z are these.
#include "alone.h"

#include "quadrature/gaussian_process.h"
#include "quadrature/hemisphere.h"

#include <array>
#include <numeric>
#include <stdexcept>

using namespace bmc;

namespace {

double first_z = 1.5;
constexpr double z1 = 3.25, last_z = 2.5;  // the second z, and those after it

std::vector<double> products(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> products;
    for (std::size_t i = 0; i < a.size(); ++i) products.push_back(a[i] * b[i]);
    return products;
}
double sum_of(const std::vector<double>& all) { return std::accumulate(all.begin(), all.end(), 0.0); }

Trial weights, subtracted, variances, factors, estimates;
bool linear = true;  // the estimate is, in the values

void print(const char* name, double z0, const std::vector<double>& y) {
    first_z = z0;
    std::vector<Vec3> directions;
    std::vector<double> cosines;
    const std::size_t size = y.size();
    const double n = static_cast<double>(size), two_pi = 2 * portable::pi, zz = Sobolev().integral_of_z();
    for (double i = 1; i <= n; ++i) {
        cosines.push_back(i / std::sqrt(i * i + 9));
        directions.push_back(rotate_around_y({3 / std::sqrt(i * i + 9), cosines.back(), 0}, i / 7));
    }
    const GaussianProcess process(Sobolev(), 0.01, directions);
    const std::vector<double>&w = process.weights(), &z = process.z();
    if (w.size() != size) throw std::runtime_error("there should be a weight for each direction");
    // Of the first two directions and the last one: a matrix times z, which is a block of 2 x 2 and a diagonal.
    using Three = std::array<double, 3>;
    const auto times_z = [&](double a, double b, double c, double d, double last) {
        return Three{a * z0 + b * z1, c * z0 + d * z1, last * last_z};
    };
    constexpr double root = 0.70710678118654752;
    const Three all = times_z(1, -1, -1, 2, 0.25), zs = times_z(1, 0, 0, 1, 1), rows = times_z(0, 0, 0, 1, 0.25);
    const double sum = all[0] + all[1] + (n - 2) * all[2];
    for (std::size_t i = 0; i < 3; ++i)
        weights.add(i < 2 ? w[i] : w.back(),
                    mistakes(all[i],
                             {{{zs[i]}, "the weights are z: Q^-1 is missing"},
                              {{times_z(2, 1, 1, 1, 4)[i]}, "the weights are Q z, not Q^-1 z"},
                              {{times_z(root, 0, -root, 2 * root, 0.5)[i], times_z(root, -root, 0, 2 * root, 0.5)[i]},
                               "the weights are those of solve_lower, half of the way; solve goes it all"},
                              {{times_z(2 * root, root, 0, root, 2)[i], times_z(2 * root, 0, root, root, 2)[i]},
                               "the weights are U z or U^T z, not Q^-1 z"},
                              {{times_z(1, 0, 0, 2, 0.25)[i]}, "of Q^-1 only the diagonal counts"},
                              {{times_z(1, -1, 0, 2, 0.25)[i], times_z(1, 0, -1, 2, 0.25)[i]},
                               "of Q^-1 only a triangle counts"},
                              {{Three{all[0], all[0] + all[1], sum}[i]}, "the sum over j is not set to 0 for each i"},
                              {{rows[i]}, "z_i stands where z_j should"},
                              {{times_z(1, 0, 0, -1, 0)[i], times_z(0, 0, 0, 0, 0.25)[i]},
                               "w_i is one element of Q^-1 times z_i: the sum over j is missing"},
                              {{times_z(2, -3, -3, 5, 0.0625)[i]}, "Q^-1 is applied twice"},
                              {{Three{0, 1, 0.25}[i]}, "the weights are sums of rows of Q^-1: z is missing"},
                              {{all[i] / sum, two_pi * all[i] / sum},
                               "the weights are made to add up to 1 or 2 pi; they are Q^-1 z"},
                              {{two_pi / n}, "the weights are Monte Carlo's: Q and z do not count"}},
                             {{"n", n}, {"z_i", zs[i]}}, i, 3));
    const double variance = process.variance(), zw = sum_of(products(z, w)), estimate = process.integral(y);
    const auto above = [](double v) { return std::max(0.0, v); };
    if (variance > 0) subtracted.add(zz - variance, mistakes(products(z, w), {}, count(n)));
    variances.add(
        variance,
        mistakes(above(zz - zw),
                 {{{zz - zw}, " is below 0: rounding can make it so, and then it is 0"},
                  {{zz}, " is zz alone"},
                  {{std::fabs(zz - zw)}, " loses its sign where it is below 0; it should be 0 there"},
                  {{above(zw - zz)}, " has the other sign"},
                  {{std::min(0.0, zz - zw)}, " is cut off where it is above 0: min in place of max"},
                  {{0}, " is 0 everywhere: is zz missing?"},
                  {{above(zz - sum_of(products(z, z)))}, "the weights are missing in the variance: z counts twice"},
                  {{above(zz - sum_of(products(w, w)))}, "z is missing in the variance"},
                  {{above(zw)}, "zz is missing in the variance"}},
                 {{"zz", zz}}));
    estimates.add(estimate, mistakes(products(w, y), {}));
    double by_factors = 0;
    for (std::size_t i = 0; i < size; ++i) {
        std::vector<double> one(size);
        one[i] = 1;
        const double factor = process.integral(one);
        by_factors += factor * y[i];
        factors.add(
            factor,
            mistakes(w[i],
                     {{{i + 1 < size ? w[i + 1] : 0, w[(i + 1) % size]}, " is the next sample's weight"},
                      {{i > 0 ? w[i - 1] : 0, w[(i + size - 1) % size]}, " is the weight of the sample before"},
                      {{w[size - 1 - i]}, " is a weight counted from the end"},
                      {{w[0], w.back()}, " is the first or the last weight, whichever the sample"},
                      {{1, 1 / n, two_pi / n}, " is the same for all: the estimate does not use the weights"}},
                     angle(cosines[i], {{"n", n}, {"z_i", z[i]}, {"w_i", w[i]}, {"the sum of the weights", sum_of(w)}}),
                     i, size));
    }
    linear = linear && near(estimate, by_factors);
    std::printf("%-20s %.9g %.9g %.9g %.9g %.9g\n", name, w[0], w[1], w.back(), variance, estimate);
}

void integral() {
    std::printf("# samples weight_1 weight_2 last_weight variance integral\n");
    print("ordinary", 1.5, {1, 1, 1});
    print("other_values", 1.5, {0.55, -2.3, 0.7});
    print("other_z", 4.4, {1, 1.2, 0.3});
    print("sixty_samples", 1.5, std::vector<double>(60, 0.1));
    print("variance_not_below_0", -8, {1, 0.5, 1});
    function = "bayesian_weights";
    weights.passes("a weight");
    function = "posterior_variance";
    subtracted.passes("what is subtracted from zz");
    variances.passes("the variance");
    function = "integral";
    if (linear) factors.passes("what Y_i is multiplied by in the estimate");
    estimates.passes("the estimate");
}

}  // namespace

// Q = 2 1 0 0 ..   Q^-1 =  1 -1  0   0  ..
//     1 1 0 0 ..          -1  2  0   0  ..
//     0 0 4 0 ..           0  0 1/4  0  ..
//     0 0 0 4 ..           0  0  0  1/4 ..
Matrix bmc::covariance_matrix(const Covariance&, double, const std::vector<Vec3>& directions) {
    Matrix q(directions.size(), directions.size());
    for (std::size_t i = 2; i < q.rows(); ++i) q(i, i) = 4;
    q(0, 0) = 2, q(0, 1) = 1, q(1, 1) = 1;
    return q;
}

std::vector<double> bmc::z_of(const Covariance&, const std::vector<Vec3>& directions, Known) {
    std::vector<double> z(directions.size(), last_z);
    z[0] = first_z, z[1] = z1;
    return z;
}

NotPositiveDefinite::NotPositiveDefinite(std::size_t, double, double) : std::runtime_error("") {}

Cholesky::Cholesky(Matrix a) : upper_(std::move(a)) {
    for (std::size_t i = 2; i < size(); ++i) upper_(i, i) = 2;
    upper_(0, 0) = std::sqrt(2.0);
    upper_(0, 1) = upper_(1, 1) = std::sqrt(0.5);
}
std::vector<double> Cholesky::solve(std::vector<double> b) const {
    for (std::size_t i = 2; i < size(); ++i) b[i] /= 4;
    b[0] -= b[1];
    b[1] -= b[0];
    return b;
}
std::vector<double> Cholesky::solve_lower(std::vector<double> b) const {
    for (std::size_t i = 2; i < size(); ++i) b[i] /= 2;
    b[1] = std::sqrt(2.0) * b[1] - std::sqrt(0.5) * b[0];
    b[0] *= std::sqrt(0.5);
    return b;
}
double Cholesky::log_determinant() const { return 0; }
Matrix Cholesky::inverse() const {
    Matrix inverse(size(), size());
    for (std::size_t i = 2; i < size(); ++i) inverse(i, i) = 0.25;
    inverse(0, 0) = 1, inverse(0, 1) = inverse(1, 0) = -1, inverse(1, 1) = 2;
    return inverse;
}

int main(int argc, char** argv) { return call(argc, argv, {{"integral", integral}}); }
