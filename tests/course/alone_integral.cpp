// alone_integral integral: what the functions of the task integral give where Q, its inverse and z are these.
#include "alone.h"

#include "quadrature/gaussian_process.h"
#include "quadrature/hemisphere.h"

#include <numeric>
#include <stdexcept>

using namespace bmc;

namespace {

double first_z = 1.5;
constexpr double z1 = 3.25, last_z = 2.5;  // the second z, and those after it

// What an estimate and a variance are made of: values, the student's own weights, z and the cosines.
struct Sum {
    std::vector<double> y, w, z, cosines;
};

std::vector<Sum> sums;
std::vector<double> weights, estimates, variances;  // of a sum the first, the second and the last weight

void print(const char* name, double z, const std::vector<double>& y) {
    first_z = z;
    std::vector<Vec3> directions;
    Sum sum{y, {}, {}, {}};
    const double n = static_cast<double>(y.size());
    for (double i = 1; i <= n; ++i) {
        sum.cosines.push_back(i / std::sqrt(i * i + 9));
        directions.push_back(rotate_around_y({3 / std::sqrt(i * i + 9), sum.cosines.back(), 0}, i / 7));
    }
    const GaussianProcess process(Sobolev(), 0.01, directions);
    sum.w = process.weights(), sum.z = process.z();
    if (sum.w.size() != y.size()) throw std::runtime_error("there should be a weight for each direction");
    weights.insert(weights.end(), {sum.w[0], sum.w[1], sum.w.back()});
    estimates.push_back(process.integral(y)), variances.push_back(process.variance());
    std::printf("%-20s %.9g %.9g %.9g %.9g %.9g\n", name, sum.w[0], sum.w[1], sum.w.back(), variances.back(),
                estimates.back());
    sums.push_back(sum);
}

void explain_all() {
    explain("a weight", weights, [](std::size_t i) {
        const std::size_t place = i % 3;
        const double z0 = sums[i / 3].z[0], n = static_cast<double>(sums[i / 3].y.size());
        // By these first two rows in place of those of Q^-1, and this last element of the diagonal.
        const auto by = [&](double a, double b, double c, double d, double last) {
            return place == 0 ? a * z0 + b * z1 : place == 1 ? c * z0 + d * z1 : last_z * last;
        };
        const double right = by(1, -1, -1, 2, 0.25), share = right / (z1 + (n - 2) * last_z / 4), root = std::sqrt(0.5);
        return mistakes(
            right,
            {{{by(1, 0, 0, 1, 1)}, "the weights are z: Q^-1 is missing"},
             {{by(2, 1, 1, 1, 4)}, "the weights are Q z, not Q^-1 z"},
             {{by(root, 0, -root, 2 * root, 0.5)},
              "the weights are those of solve_lower, half of the way; solve goes it all"},
             {{by(2 * root, root, 0, root, 2), by(2 * root, 0, root, root, 2)},
              "the weights are U z or U^T z, not Q^-1 z"},
             {{by(0, -1, 0, 2, 0.25), by(1, -1, -1, 2, 0)}, "the sum over j lacks its first or its last term"},
             {{right * (place == 0   ? z0
                        : place == 1 ? z1
                                     : last_z)},
              " is multiplied by z once more"},
             {{by(0, 0, -1, 0, 0), by(1, 0, -1, 2, 0.25), by(1, -1, 0, 2, 0.25), by(1, 0, 0, 2, 0.25)},
              "of Q^-1 only a triangle or the diagonal counts"},
             {{by(0, 0, 0, 0, 0.25)}, "the sums over j keep their last terms alone: = in place of +="},
             {{by(0, 0, 0, 1, 0.25)}, "z_i stands where z_j should"},
             {{place == 2   ? 0.25
               : place == 1 ? 1.0
                            : 0.0},
              "the weights are sums of rows of Q^-1: z is missing"},
             {{by(2, -3, -3, 5, 0.0625)}, "Q^-1 is applied twice"},
             {{by(root, 0, 0, 2 * root, 0.5), by(0.5, 0, 0, 1, 0.25)}, "z is divided by the diagonal of U or Q alone"},
             {{share, 2 * portable::pi * share}, "the weights are made to add up to 1 or 2 pi; they are Q^-1 z"},
             {{2 * portable::pi / n}, "the weights are Monte Carlo's: Q and z do not count"}},
            n);
    });
    const auto product = [](const std::vector<double>& a, const std::vector<double>& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    };
    explain("the variance", variances, [&](std::size_t i) {
        const Sum& s = sums[i];
        const double zz = Sobolev().integral_of_z(), zw = product(s.z, s.w),
                     w = product(std::vector<double>(s.w.size(), 1), s.w);
        const auto above = [](double v) { return std::max(0.0, v); };
        return mistakes(above(zz - zw),
                        {{{zz - zw}, " is below 0: rounding can make it so, and then it is 0"},
                         {{zz}, " is zz alone"},
                         {{std::fabs(zz - zw)}, " loses its sign where it is below 0; it should be 0 there"},
                         {{above(zw - zz)}, " has the other sign"},
                         {{std::min(0.0, zz - zw)}, " is cut off where it is above 0: min in place of max"},
                         {{0}, " is 0 everywhere: is zz missing?"},
                         {{above(1 - zw / zz)}, " is divided by zz"},
                         {{above(zz - product(s.z, s.z))}, "the weights are missing in the variance: z counts twice"},
                         {{above(zz - product(s.w, s.w)), above(zz - w), zz - w}, "z is missing in the variance"},
                         {{above(zz - s.z[0] * s.w[0])}, "in the variance only the first term of z^T w counts"},
                         {{above(zz - zw / static_cast<double>(s.w.size())), above(zz - 2 * zw),
                           above(zz - zw / (2 * portable::pi)), above(zz - 2 * portable::pi * zw)},
                          "in the variance z^T w has a factor: n, 2 or 2 pi"},
                         {{above(zw)}, "zz is missing in the variance"},
                         {{above(zz + zw)}, "z w is added to zz in the variance"}});
    });
    explain("the estimate", estimates, [&](std::size_t number) {
        const Sum& s = sums[number];
        const double n = static_cast<double>(s.y.size()), right = product(s.w, s.y);
        double w = 0, y = 0, wyc = 0, wwy = 0, wyy = 0;
        std::vector<double> terms;
        for (std::size_t i = 0; i < s.y.size(); ++i) {
            terms.push_back(s.w[i] * s.y[i]);
            w += s.w[i], y += s.y[i], wyc += terms[i] * s.cosines[i], wwy += s.w[i] * terms[i],
                wyy += terms[i] * s.y[i];
        }
        return mistakes(terms, {

                                   {{right / w}, " is divided by the sum of the weights"},

                                   {{wyc}, "the values are multiplied by cos(theta)"},
                                   {{w * y}, " is the product of two sums; it should be a sum of products"},
                                   {{wwy}, "the weights are squared"},
                                   {{w + y}, "weights and values are added, not multiplied"},
                                   {{w * s.y[0]}, "the first value serves for every sample"},

                                   {{product(s.z, s.y)}, "the values are weighted by z"},
                                   {{wyy}, "the values are squared"},

                                   {{w}, " is the sum of the weights: the values are missing"},
                                   {{y, y / n, 2 * portable::pi / n * y},
                                    " is the mean or the sum of the values: it does not use the weights"}});
    });
}

void integral() {
    std::printf("# samples weight_1 weight_2 last_weight variance integral\n");
    print("ordinary", 1.5, {1, 1, 1});
    print("other_values", 1.5, {0.55, -2.3, 0.7});
    print("other_z", 4.4, {1, 1.2, 0.3});
    print("sixty_samples", 1.5, std::vector<double>(60, 0.1));
    print("variance_not_below_0", -8, {1, 0.5, 1});
    explain_all();
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
