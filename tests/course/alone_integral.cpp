// alone_integral integral: what the functions of the task integral give where Q, its inverse and z are these.
#include "alone.h"

#include "quadrature/gaussian_process.h"

#include <stdexcept>

using namespace bmc;

namespace {

double first_z = 1.5;

void print(const char* name, double z, std::vector<double> values, double right) {
    first_z = z;
    const Sobolev sobolev;
    const GaussianProcess process(sobolev, 0.01, std::vector<Vec3>(values.size(), {0, 1, 0}));
    const std::vector<double>& w = process.weights();
    if (w.size() != values.size()) throw std::runtime_error("there should be a weight for each direction");
    const double integral = process.integral(values), zz = sobolev.integral_of_z();
    std::printf("%-20s %.9g %.9g %.9g %.9g %.9g\n", name, w[0], w[1], w.back(), process.variance(), integral);
    explain(w[0], {{z, "the weights are z: Q^-1 is missing"}, {2 * z + 3.25, "the weights are Q z, not Q^-1 z"}});
    explain_if(process.variance() < 0, "the variance is below 0: rounding can make it so, and then it is 0");
    explain(process.variance(), {{zz, "the variance is zz alone"},
                                 {zz * zz, "the variance is squared"},
                                 {zz - w[0] - w[1] - w[2], "z is missing in the variance"}});
    explain_if(integral == std::trunc(integral), "the estimate is a whole number: is the sum an int?");
    const double n = static_cast<double>(values.size());
    double mean = 0;
    for (const double value : values) mean += 2 * portable::pi / n * value;
    explain(integral, {{right / n, "the estimate is divided by the number of samples; the weights do that already"},
                       {z * values[0] + 3.25 * values[1] + 2.5 * (n - 2) * values[2], "the values are weighted by z"},
                       {right - w.back() * values.back(), "the last value does not count"}});
    if (values[0] != values[1])
        explain(integral, {{mean, "the estimate is Monte Carlo's: it does not use the weights"}});
}

void integral() {
    std::printf("# samples weight_1 weight_2 last_weight variance integral\n");
    print("ordinary", 1.5, {1, 1, 1}, 3.875);
    print("other_values", 1.5, {0.55, -2.3, 0.7}, -12.025);
    print("other_z", 4.4, {1, 1.2, 0.3}, 3.8575);
    print("sixty_samples", 1.5, std::vector<double>(60, 0.1), 3.95);
    print("variance_not_below_0", -8, {1, 0.5, 1}, -3.375);
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
    std::vector<double> z(directions.size(), 2.5);
    z[0] = first_z, z[1] = 3.25;
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
