#include "experiments/exact_weights.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace {

const DoubleDouble pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// k and z of a covariance; the formulas are those of common/quadrature/covariance.cpp.
class ExactCovariance {
public:
    explicit ExactCovariance(const Model& model)
        : sobolev_(model.family == CovarianceFamily::sobolev), parameter_(model.parameter) {
        const DoubleDouble s = parameter_;
        constant_ = sobolev_ ? pow(2, s + s - 1) / s : DoubleDouble(1) / (s * s);
    }

    DoubleDouble covariance(DoubleDouble squared_chord) const {
        return sobolev_ ? constant_ - power(squared_chord) : exp(-constant_ * squared_chord * 0.5);
    }
    DoubleDouble hemisphere_integral(double cosine) const {
        return pi * 2 * (sobolev_ ? sobolev_integral(cosine) : squared_exponential_integral(cosine));
    }

private:
    // x^(s - 1).
    DoubleDouble power(DoubleDouble x) const { return parameter_ == 1.5 ? sqrt(x) : pow(x, parameter_ - 1); }
    DoubleDouble sobolev_integral(DoubleDouble cosine) const;
    DoubleDouble squared_exponential_integral(DoubleDouble cosine) const;

    bool sobolev_;
    double parameter_;
    DoubleDouble constant_;  // C, or kappa = 1 / length-scale^2
};

// The error of the trapezoidal rule is e^(-pi^2 / step) = e^-63. The nodes e^u reach to where the integrand is e^-60 of
// its largest value for every q >= 1e-9.
DoubleDouble ExactCovariance::sobolev_integral(DoubleDouble cosine) const {
    if (cosine.high == 0) return constant_ * 0.5;  // half of the sphere
    constexpr double step = 0.15625, first = -60, last = 81;
    const DoubleDouble sine = sqrt((DoubleDouble(1) - cosine) * (cosine + 1)), q = cosine / (sine + 1);
    const DoubleDouble ratio = exp(DoubleDouble(step));
    DoubleDouble sum = 0, y = exp(DoubleDouble(first));
    for (double u = first; u <= last; u += step, y = y * ratio) {
        const DoubleDouble yy = y * y, t = q * y;
        sum = sum + power((sine + 1) * (q * q + yy) / (yy + 1)) * t / (t * t + 1);
    }
    return constant_ - pow(2, DoubleDouble(parameter_)) / (pi * parameter_) * (sum * step);
}

// The part that all directions share, (1 - e^(-2 kappa)) / 2 kappa by the series of sinh, and that which changes sign
// with the cosine: positive terms, no cancellation.
DoubleDouble ExactCovariance::squared_exponential_integral(DoubleDouble cosine) const {
    const DoubleDouble kappa = constant_, squared_sine = DoubleDouble(1) - cosine * cosine;
    DoubleDouble term = exp(-kappa), even = term;
    for (int m = 1; m < kappa.high || term.high > 1e-34 * even.high; ++m)
        even = even + (term = term * kappa * kappa / (2.0 * m * (2 * m + 1)));
    DoubleDouble t = kappa * 0.5 * exp(-kappa), b = cosine, edge = cosine, odd = t * b;
    for (int m = 1; m < kappa.high || (t * b).high > 1e-34 * odd.high; ++m) {
        t = t * kappa * kappa / (4.0 * m * (m + 1));
        edge = edge * squared_sine;
        b = (edge + b * (2.0 * m)) / (2.0 * m + 1);
        odd = odd + t * b;
    }
    return even + odd;
}

DoubleDouble squared_chord(const Vec3& a, const Vec3& b) {
    const DoubleDouble x = DoubleDouble(a.x) - b.x, y = DoubleDouble(a.y) - b.y, z = DoubleDouble(a.z) - b.z;
    return x * x + y * y + z * z;
}

// The largest absolute value.
double largest(const std::vector<double>& x) {
    double size = 0;
    for (const double element : x) size = std::max(size, std::fabs(element));
    return size;
}

}  // namespace

ExactWeights::ExactWeights(const Model& model, const std::vector<Vec3>& directions) {
    const ExactCovariance exact(model);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        z_.push_back(exact.hemisphere_integral(std::min(directions[i].y, 1.0)));
        for (std::size_t j = i; j < directions.size(); ++j)
            upper_.push_back(exact.covariance(squared_chord(directions[i], directions[j])));
    }
}

std::vector<double> ExactWeights::residual(const std::vector<double>& weights, double noise) const {
    std::vector<DoubleDouble> rest = z_;
    const DoubleDouble* q = upper_.data();
    for (std::size_t i = 0; i < rest.size(); ++i) {
        rest[i] = rest[i] - (*q++ + DoubleDouble(noise) * noise) * weights[i];
        for (std::size_t j = i + 1; j < rest.size(); ++j, ++q) {
            rest[i] = rest[i] - *q * weights[j];
            rest[j] = rest[j] - *q * weights[i];
        }
    }
    std::vector<double> rounded;
    for (const DoubleDouble& element : rest) rounded.push_back(element.high);
    return rounded;
}

double ExactWeights::error_of(std::vector<double> weights, double noise, const Cholesky& cholesky) const {
    std::vector<double> exact(z_.size());
    for (double size, last = HUGE_VAL;; last = size) {
        const std::vector<double> correction = cholesky.solve(residual(exact, noise));
        size = largest(correction);
        if (!(size < last / 2)) return INFINITY;
        for (std::size_t i = 0; i < exact.size(); ++i) exact[i] += correction[i];
        if (size <= 2 * DBL_EPSILON * largest(exact)) break;
    }
    for (std::size_t i = 0; i < exact.size(); ++i) weights[i] -= exact[i];
    return largest(weights) / largest(exact);
}
