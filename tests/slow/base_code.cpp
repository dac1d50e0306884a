// The Gaussian process of the sheet's Python base code, written from its description: it shares no line with the
// product. The covariance is Sobolev's of smoothness 1.4, the noise 0.01; z is a mean over 50,000 random directions,
// and the weights are z times the inverse of Q.
//
// Reads lines "x y z value", and prints lines "NAME number standard-error": the elements of Q, z_j, w_j, the estimate.
// Let k_1 ... k_50000 be the covariances of the samples with the random directions, times 2 pi. Then z, the weights and
// the estimate are means of k_m, of Q^-1 k_m and of Y^T Q^-1 k_m, and the scatter of these says how exact each mean is.
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using Vector = std::vector<double>;
constexpr double pi = 3.14159265358979323846, smoothness = 1.4, noise = 0.01;
constexpr int directions = 50000;

static double k(const Vector& a, const Vector& b) {
    const double r = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    return std::pow(2, 2 * smoothness - 1) / smoothness - std::pow(r, 2 * smoothness - 2);
}

// Gauss and Jordan, without pivots: Q is positive definite.
static std::vector<Vector> inverse(std::vector<Vector> q) {
    const std::size_t n = q.size();
    for (std::size_t p = 0; p < n; ++p) {
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
    return q;
}

static Vector product(const std::vector<Vector>& matrix, const Vector& vector) {
    Vector result;
    for (const Vector& row : matrix) {
        result.push_back(0);
        for (std::size_t j = 0; j < row.size(); ++j) result.back() += row[j] * vector[j];
    }
    return result;
}

struct Mean {
    double sum = 0, squares = 0;
    void add(double x) { sum += x, squares += x * x; }
    void print(const char* name) const {
        const double mean = sum / directions;
        std::printf("%s %.17g %.17g\n", name, mean, std::sqrt((squares / directions - mean * mean) / directions));
    }
};

int main() {
    std::vector<Vector> samples, q;
    Vector values;
    for (double x, y, z, value; std::scanf("%lf %lf %lf %lf", &x, &y, &z, &value) == 4;) {
        samples.push_back({x, y, z});
        values.push_back(value);
    }
    const std::size_t n = samples.size();
    for (std::size_t i = 0; i < n; ++i) {
        q.emplace_back();
        for (std::size_t j = 0; j < n; ++j) {
            q[i].push_back(k(samples[i], samples[j]) + (i == j ? noise * noise : 0));
            std::printf("Q %.9g 0\n", q[i][j]);
        }
    }
    const std::vector<Vector> inverse_q = inverse(q);
    const Vector of_estimate = product(inverse_q, values);
    std::vector<Mean> z(n), w(n);
    Mean estimate;
    std::mt19937_64 random(1);
    const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    for (int m = 0; m < directions; ++m) {
        const double height = uniform(), angle = 2 * pi * uniform(), radius = std::sqrt(1 - height * height);
        const Vector direction{radius * std::cos(angle), height, radius * std::sin(angle)};
        Vector k_m;
        for (const Vector& sample : samples) k_m.push_back(2 * pi * k(sample, direction));
        const Vector w_m = product(inverse_q, k_m);
        double estimate_m = 0;
        for (std::size_t j = 0; j < n; ++j) {
            z[j].add(k_m[j]);
            w[j].add(w_m[j]);
            estimate_m += of_estimate[j] * k_m[j];
        }
        estimate.add(estimate_m);
    }
    for (const Mean& z_j : z) z_j.print("z");
    for (const Mean& w_j : w) w_j.print("w");
    estimate.print("estimate");
}
