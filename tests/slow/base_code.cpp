// The Gaussian process of the sheet's Python base code, written from its description: it shares no line with the
// product. The covariance is Sobolev's of smoothness 1.4, the noise 0.01; z is a mean over 50,000 random directions,
// and the weights are z times the inverse of Q.
//
// Reads lines "x y z value", and prints lines "NAME number standard-error": the elements of Q and of its inverse, z_j,
// w_j, the estimate.
// Let k_m be the covariances of the samples with random direction m, times 2 pi. Then z, the weights and the estimate
// are means of k_m, of Q^-1 k_m and of Y^T Q^-1 k_m, and the scatter of these says how exact each mean is.
#include <cmath>
#include <cstdio>
#include <random>
#include <valarray>
#include <vector>

using Vector = std::valarray<double>;
constexpr double pi = 3.14159265358979323846, smoothness = 1.4, noise = 0.01, random_directions = 50000;

static double k(const Vector& a, const Vector& b) {
    const double r = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    return std::pow(2, 2 * smoothness - 1) / smoothness - std::pow(r, 2 * smoothness - 2);
}

int main() {
    std::vector<Vector> samples;
    std::vector<double> values;
    for (double x, y, z, value; std::scanf("%lf %lf %lf %lf", &x, &y, &z, &value) == 4; values.push_back(value))
        samples.push_back({x, y, z});
    const std::size_t n = samples.size();
    std::vector<Vector> q(n, Vector(n));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            q[i][j] = k(samples[i], samples[j]) + (i == j ? noise * noise : 0);
            std::printf("Q %.9g 0\n", q[i][j]);
        }
    }
    for (std::size_t p = 0; p < n; ++p) {  // Q becomes its inverse, by Gauss and Jordan's elimination
        const double pivot = q[p][p];
        q[p][p] = 1;
        q[p] /= pivot;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == p) continue;
            const double multiple = q[i][p];
            q[i][p] = 0;
            q[i] -= multiple * q[p];
        }
    }
    for (const Vector& row : q)
        for (const double element : row) std::printf("inverse %.17g 0\n", element);
    Vector x(2 * n + 1), sums(2 * n + 1), squares(2 * n + 1);  // of each z_j, each weight, and the estimate
    std::mt19937_64 random(1);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    for (int m = 0; m < random_directions; ++m) {
        const double height = uniform(), angle = 2 * pi * uniform(), radius = std::sqrt(1 - height * height);
        const Vector direction{radius * std::cos(angle), height, radius * std::sin(angle)};
        Vector k_m(n);
        for (std::size_t j = 0; j < n; ++j) x[j] = k_m[j] = 2 * pi * k(samples[j], direction);
        x[2 * n] = 0;
        for (std::size_t j = 0; j < n; ++j) x[2 * n] += values[j] * (x[n + j] = (q[j] * k_m).sum());
        sums += x;
        squares += x * x;
    }
    const Vector means = sums / random_directions;
    const Vector errors = std::sqrt((squares / random_directions - means * means) / random_directions);
    for (std::size_t i = 0; i <= 2 * n; ++i)
        std::printf("%s %.17g %.17g\n", i < n ? "z" : i < 2 * n ? "w" : "estimate", means[i], errors[i]);
}
