// alone_integral integral: what the functions of the task integral give where Q, its inverse and z are these.
#include "quadrature/gaussian_process.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

using namespace bmc;

namespace {

double first_z = 1;

void print(const char* name, double z, std::vector<double> values) {
    first_z = z;
    const Sobolev sobolev;
    const GaussianProcess process(sobolev, 0.01, {{0, 1, 0}, {1, 0, 0}});
    if (process.weights().size() != 2) throw std::runtime_error("there should be a weight for each direction");
    std::printf("%-20s %.9g %.9g %.9g %.9g\n", name, process.weights()[0], process.weights()[1], process.variance(),
                process.integral(values));
}

}  // namespace

// Q = 2 1   Q^-1 =  1 -1
//     1 1          -1  2
Matrix bmc::covariance_matrix(const Covariance&, double, const std::vector<Vec3>&) {
    Matrix q(2, 2);
    q(0, 0) = 2, q(0, 1) = 1, q(1, 1) = 1;
    return q;
}

std::vector<double> bmc::z_of(const Covariance&, const std::vector<Vec3>&, KnownPart) { return {first_z, 3}; }

NotPositiveDefinite::NotPositiveDefinite(std::size_t, double, double) : std::runtime_error("") {}

Cholesky::Cholesky(Matrix a) : upper_(std::move(a)) {
    upper_(0, 0) = std::sqrt(2.0);
    upper_(0, 1) = upper_(1, 1) = std::sqrt(0.5);
}
std::vector<double> Cholesky::solve(std::vector<double> b) const { return {b[0] - b[1], 2 * b[1] - b[0]}; }
std::vector<double> Cholesky::solve_lower(std::vector<double> b) const {
    return {std::sqrt(0.5) * b[0], std::sqrt(2.0) * b[1] - std::sqrt(0.5) * b[0]};
}
double Cholesky::log_determinant() const { return 0; }
Matrix Cholesky::inverse() const {
    Matrix inverse(2, 2);
    inverse(0, 0) = 1, inverse(0, 1) = inverse(1, 0) = -1, inverse(1, 1) = 2;
    return inverse;
}

int main() {
    try {
        std::printf("# samples weight_1 weight_2 variance integral\n");
        print("ordinary", 1, {1, 1});
        print("other_values", 1, {0.5, -2});
        print("other_z", 4, {1, 1});
        print("variance_not_below_0", -8, {1, 1});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
