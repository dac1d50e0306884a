// The exercise of the course with k = exp(-r): z straight up, and Monte Carlo's error over BMC's for the cosine, which
// varies by a hundredth between seeds.
#include "quadrature/gaussian_process.h"

#include <cstdio>

using namespace bmc;

struct Exponential : Covariance {
    double k(double squared_chord) const override { return portable::exp(-std::sqrt(squared_chord)); }
    double cap_mean(double b) const override {
        const double r = std::sqrt(2 * b);
        return r < 0.001 ? 1 - 2 * r / 3 : 2 / (r * r) * (1 - (1 + r) * portable::exp(-r));
    }
};

int main() {
    double mc = 0, bmc = 0;
    for (std::uint64_t e = 0; e < 8000; ++e) {
        Random random(2, e);
        const GaussianProcess process(Exponential(), 0.01, random_directions(40, random));
        std::vector<double> values;
        double sum = 0;
        for (const Vec3& w : process.directions) values.push_back(w.y), sum += w.y;
        mc += std::fabs(2 * portable::pi / 40 * sum - portable::pi);
        bmc += std::fabs(process.integral(values) - portable::pi);
    }
    std::printf("exercise-z %.3f\nexercise-ratio %.3f\n", Exponential().z(1), mc / bmc);
}
