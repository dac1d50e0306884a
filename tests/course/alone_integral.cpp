// alone_integral integral: what the functions of the task integral give where Q, its inverse and z are these.
#include "alone.h"

#include "quadrature/gaussian_process.h"
#include "quadrature/hemisphere.h"

#include <stdexcept>

using namespace bmc;

namespace {

double first_z = 1.5;
const double zz = Sobolev().integral_of_z();

// The first, the second or the last weight of a process.
struct Weight {
    double given;
    int place;
    double z0, z1, n;

    // Where these are the first two rows in place of those of Q^-1, and the last element of the diagonal.
    double by(double a, double b, double c, double d, double last) const {
        return place == 0 ? a * z0 + b * z1 : place == 1 ? c * z0 + d * z1 : 2.5 * last;
    }
    double right() const { return by(1, -1, -1, 2, 0.25); }
    double share() const { return right() / (z1 + (n - 2) * 2.5 / 4); }
};

// An estimate or a variance, and sums of the student's own weights w, of z and of the values y.
struct Sum {
    double given, n, last, wy_first, first;
    double w = 0, y = 0, wy = 0, zy = 0, zw = 0, zz = 0, ww = 0, wyy = 0, wyc = 0, wwy = 0, size = 0, above = 0,
           whole = 0;
};

std::vector<Weight> weights;
std::vector<Sum> estimates, variances;

void print(const char* name, double z, const std::vector<double>& y) {
    first_z = z;
    std::vector<Vec3> directions;
    const double n = static_cast<double>(y.size());
    for (double i = 1; i <= n; ++i)
        directions.push_back(rotate_around_y({3 / std::sqrt(i * i + 9), i / std::sqrt(i * i + 9), 0}, i / 7));
    const GaussianProcess process(Sobolev(), 0.01, directions);
    const std::vector<double>&w = process.weights(), &its = process.z();
    if (w.size() != y.size()) throw std::runtime_error("there should be a weight for each direction");
    const double integral = process.integral(y);
    std::printf("%-20s %.9g %.9g %.9g %.9g %.9g\n", name, w[0], w[1], w.back(), process.variance(), integral);
    for (int place = 0; place < 3; ++place) weights.push_back({place < 2 ? w[place] : w.back(), place, z, 3.25, n});
    Sum sum{integral, n, w.back() * y.back(), w[0] * y[0], z * w[0]};
    for (std::size_t i = 0; i < y.size(); ++i) {
        sum.w += w[i], sum.y += y[i], sum.wy += w[i] * y[i], sum.zy += its[i] * y[i], sum.zw += its[i] * w[i];
        sum.zz += its[i] * its[i], sum.ww += w[i] * w[i], sum.wyc += w[i] * y[i] * directions[i].y;
        sum.wwy += w[i] * w[i] * y[i];
        sum.wyy += w[i] * y[i] * y[i], sum.size += w[i] * std::fabs(y[i]), sum.above += w[i] * std::max(0.0, y[i]);
        sum.whole = std::trunc(sum.whole + w[i] * y[i]);
    }
    estimates.push_back(sum);
    sum.given = process.variance();
    variances.push_back(sum);
}

void explain_all() {
    using W = const Weight&;
    using S = const Sum&;
    explain<Weight>(
        weights,
        {{[](W w) { return w.right(); }, nullptr},
         {[](W w) { return w.by(1, 0, 0, 1, 1); }, "the weights are z: Q^-1 is missing"},
         {[](W w) { return w.by(2, 1, 1, 1, 4); }, "the weights are Q z, not Q^-1 z"},
         {[](W w) { return w.by(M_SQRT1_2, 0, -M_SQRT1_2, M_SQRT2, 0.5); },
          "the weights are those of solve_lower, half of the way; solve goes it all"},
         {[](W w) { return w.by(M_SQRT2, M_SQRT1_2, 0, M_SQRT1_2, 2); }, "the weights are U z, not Q^-1 z"},
         {[](W w) { return w.by(M_SQRT2, 0, M_SQRT1_2, M_SQRT1_2, 2); }, "the weights are U^T z, not Q^-1 z"},
         {[](W w) { return w.by(0, 0, -1, 0, 0); }, "of Q^-1 only what is left of the diagonal counts"},
         {[](W w) { return w.by(1, 0, -1, 2, 0.25); }, "of Q^-1 nothing counts that is right of the diagonal"},
         {[](W w) { return w.by(1, -1, 0, 2, 0.25); }, "of Q^-1 nothing counts that is left of the diagonal"},
         {[](W w) { return w.by(1, 0, 0, 2, 0.25); }, "of Q^-1 only the diagonal counts"},
         {[](W w) { return w.by(0, 0, 0, 0, 0.25); }, "the sums over j keep their last terms alone: = in place of +="},
         {[](W w) { return w.by(0, 0, 0, 1, 0.25); }, "z_i stands where z_j should"},
         {[](W w) { return w.place == 2 ? 0.25 : w.place; }, "the weights are sums of rows of Q^-1: z is missing"},
         {[](W w) { return 2 * portable::pi * w.right(); }, "the weights are multiplied by 2 pi; z has that"},
         {[](W) { return 0.0; }, "the weights are all 0: are they set?"},
         {[](W w) { return w.by(2, -3, -3, 5, 0.0625); }, "Q^-1 is applied twice"},
         {[](W w) { return w.by(M_SQRT1_2, 0, 0, M_SQRT2, 0.5); }, "z is divided by the diagonal of U alone"},
         {[](W w) { return w.by(0.5, 0, 0, 1, 0.25); }, "z is divided by the diagonal of Q alone"},
         {[](W w) { return std::fabs(w.right()); }, "a weight below 0 has lost its sign"},
         {[](W w) { return std::max(0.0, w.right()); }, "a weight below 0 is taken for 0"},
         {[](W w) { return -w.right(); }, "the weights have the other sign"},
         {[](W w) { return w.right() / w.n; }, "the weights are divided by the number of samples"},
         {[](W w) { return 2 * portable::pi / w.n * w.right(); }, "the weights are multiplied by Monte Carlo's"},
         {[](W w) { return w.share(); }, "the weights are made to add up to 1; they are Q^-1 z"},
         {[](W w) { return 2 * portable::pi * w.share(); }, "the weights are made to add up to 2 pi; they are Q^-1 z"},
         {[](W w) { return 2 * portable::pi / w.n; }, "the weights are Monte Carlo's: Q and z do not count"}});
    explain<Sum>(
        variances,
        {{[](S s) { return std::max(0.0, zz - s.zw); }, nullptr},
         {[](S s) { return zz - s.zw; }, "the variance is below 0: rounding can make it so, and then it is 0"},
         {[](S) { return zz; }, "the variance is zz alone"},
         {[](S s) { return std::fabs(zz - s.zw); }, "a variance below 0 loses its sign; it should be 0"},
         {[](S s) { return std::max(0.0, zz - s.zw) * std::max(0.0, zz - s.zw); }, "the variance is squared"},
         {[](S s) { return (zz - s.zw) * (zz - s.zw); }, "the variance is squared"},
         {[](S s) { return std::sqrt(std::max(0.0, zz - s.zw)); }, "the variance is a root of what it should be"},
         {[](S s) { return std::max(0.0, s.zw - zz); }, "the variance has the other sign"},
         {[](S) { return 0.0; }, "the variance is 0 everywhere: is zz missing?"},
         {[](S s) { return std::max(0.0, 1 - s.zw / zz); }, "the variance is divided by zz"},
         {[](S s) { return std::max(0.0, zz - s.zz); }, "the weights are missing in the variance: z counts twice"},
         {[](S s) { return std::max(0.0, zz - s.ww); }, "z is missing in the variance: the weights count twice"},
         {[](S s) { return std::max(0.0, zz - s.first); }, "in the variance only the first term of z^T w counts"},
         {[](S s) { return std::max(0.0, zz - s.zw / s.n); }, "in the variance z^T w is divided by n"},
         {[](S s) { return std::max(0.0, s.zw); }, "zz is missing in the variance"},
         {[](S s) { return std::max(0.0, zz + s.zw); }, "z w is added to zz in the variance"},
         {[](S s) { return std::max(0.0, zz - s.w); }, "z is missing in the variance"},
         {[](S s) { return zz - s.w; }, "z is missing in the variance"}});
    explain<Sum>(
        estimates,
        {{[](S s) { return s.wy; }, nullptr},
         {[](S s) { return s.whole; }, "the estimate is a whole number: is the sum an int?"},
         {[](S s) { return s.wy / s.n; },
          "the estimate is divided by the number of samples; the weights do that already"},
         {[](S s) { return s.wy / s.w; }, "the estimate is divided by the sum of the weights"},
         {[](S s) { return 2 * portable::pi * s.wy; },
          "the estimate is multiplied by 2 pi; the weights do that already"},
         {[](S s) { return s.wy - s.last; }, "the last value does not count"},
         {[](S s) { return s.wy - s.wy_first; }, "the first value does not count"},
         {[](S s) { return s.wyc; }, "the values are multiplied by cos(theta)"},
         {[](S s) { return s.w * s.y; }, "the product of two sums; it should be a sum of products"},
         {[](S s) { return s.wwy; }, "the weights are squared"},
         {[](S s) { return s.wy / (2 * portable::pi); }, "the estimate is divided by 2 pi"},
         {[](S s) { return s.w + s.y; }, "weights and values are added, not multiplied"},
         {[](S s) { return s.last; }, "only the last value counts"},
         {[](S s) { return s.zy; }, "the values are weighted by z"},
         {[](S s) { return s.wyy; }, "the values are squared"},
         {[](S s) { return s.size; }, "the sign of the values is lost"},
         {[](S s) { return s.above; }, "values below 0 do not count"},
         {[](S s) { return s.w; }, "the estimate is the sum of the weights: the values are missing"},
         {[](S s) { return 2 * portable::pi / s.n * s.y; },
          "the estimate is Monte Carlo's: it does not use the weights"},
         {[](S s) { return s.y / s.n; }, "the estimate is the mean of the values: it does not use the weights"},
         {[](S s) { return s.y; }, "the estimate is the sum of the values: it does not use the weights"}});
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
