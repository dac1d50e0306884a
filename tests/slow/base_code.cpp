// The Gaussian process of the sheet's Python base code, written from its description: it shares no line with the
// product. The covariance is Sobolev's of smoothness 1.4, the noise 0.01; z is a mean over 50,000 random directions,
// and the weights are z times the inverse of Q.
//
// Reads lines "x y z value", and prints lines "NAME number standard-error": the elements of Q, z_j, w_j, the estimate.
// Let k_m be the covariances of the samples with random direction m, times 2 pi. Then z, the weights and the estimate
// are means of k_m, of Q^-1 k_m and of Y^T Q^-1 k_m, and the scatter of these says how exact each mean is.
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using Vector = std::vector<double>;
constexpr double pi = 3.14159265358979323846, smoothness = 1.4, noise = 0.01, random_directions = 50000;

static double k(const Vector& a, const Vector& b) {
    const double r = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    return std::pow(2, 2 * smoothness - 1) / smoothness - std::pow(r, 2 * smoothness - 2);
}

static double dot(const Vector& a, const Vector& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

int main() {
    std::vector<Vector> samples, q;
    Vector values;
    for (double x, y, z, value; std::scanf("%lf %lf %lf %lf", &x, &y, &z, &value) == 4; values.push_back(value))
        samples.push_back({x, y, z});
    const std::size_t n = samples.size();
    for (const Vector& row : samples) {
        q.emplace_back();
        for (const Vector& column : samples) {
            q.back().push_back(k(row, column) + (&row == &column ? noise * noise : 0));
            std::printf("Q %.9g 0\n", q.back().back());
        }
    }
    for (std::size_t p = 0; p < n; ++p) {  // Q becomes its inverse, by Gauss and Jordan's elimination
        const double pivot = q[p][p];
        q[p][p] = 1;
        for (double& element : q[p]) element /= pivot;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == p) continue;
            const double multiple = q[i][p];
            q[i][p] = 0;
            for (std::size_t j = 0; j < n; ++j) q[i][j] -= multiple * q[p][j];
        }
    }
    std::vector<Vector> factors(n, Vector(n));  // of k_m: for each z_j, each weight, and the estimate
    for (std::size_t j = 0; j < n; ++j) factors[j][j] = 1;
    factors.insert(factors.end(), q.begin(), q.end());
    factors.emplace_back();
    for (const Vector& row : q) factors.back().push_back(dot(row, values));  // Q^-1 is symmetric
    Vector sums(2 * n + 1), squares(2 * n + 1);
    std::mt19937_64 random(1);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    for (int m = 0; m < random_directions; ++m) {
        const double height = uniform(), angle = 2 * pi * uniform(), radius = std::sqrt(1 - height * height);
        const Vector direction{radius * std::cos(angle), height, radius * std::sin(angle)};
        Vector k_m;
        for (const Vector& sample : samples) k_m.push_back(2 * pi * k(sample, direction));
        for (std::size_t i = 0; i < factors.size(); ++i) {
            const double x = dot(factors[i], k_m);
            sums[i] += x;
            squares[i] += x * x;
        }
    }
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const double mean = sums[i] / random_directions, variance = squares[i] / random_directions - mean * mean;
        std::printf("%s %.17g %.17g\n",
                    i < n       ? "z"
                    : i < 2 * n ? "w"
                                : "estimate",
                    mean, std::sqrt(variance / random_directions));
    }
}
