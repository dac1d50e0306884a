#include "experiments/exact_weights.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace {

const DoubleDouble pi{0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53};

// k and z of a covariance; the formulas are those of common/quadrature/covariance.cpp.
class ExactCovariance {
public:
    explicit ExactCovariance(const Model& model);

    DoubleDouble covariance(DoubleDouble squared_chord) const;
    DoubleDouble hemisphere_integral(double cosine) const;

private:
    DoubleDouble power(DoubleDouble x) const { return p_ == 0.5 ? sqrt(x) : pow(x, p_); }
    DoubleDouble rim_integral(DoubleDouble sine, DoubleDouble q) const;
    DoubleDouble odd_part(double cosine) const;

    bool sobolev_;
    double p_ = 0;                 // smoothness less 1
    DoubleDouble c_;               // C
    std::vector<DoubleDouble> y_;  // nodes of the rim integral
    DoubleDouble kappa_;           // 1 / length-scale^2
};

// The error of the trapezoidal rule is e^(-pi^2 / step) = e^-63. The nodes reach to where the integrand is e^-60 of its
// largest value for every q >= 1e-9.
constexpr double rim_step = 0.15625, reach = 60;

ExactCovariance::ExactCovariance(const Model& model)
    : sobolev_(model.family == CovarianceFamily::sobolev), p_(model.parameter - 1) {
    const DoubleDouble s = model.parameter;
    if (!sobolev_) {
        kappa_ = DoubleDouble(1) / (s * s);
        return;
    }
    c_ = pow(2, s + s - 1) / s;
    for (double u = -reach; u <= reach + 21; u += rim_step) y_.push_back(exp(DoubleDouble(u)));
}

DoubleDouble ExactCovariance::covariance(DoubleDouble squared_chord) const {
    return sobolev_ ? c_ - power(squared_chord) : exp(-kappa_ * squared_chord * 0.5);
}

DoubleDouble ExactCovariance::rim_integral(DoubleDouble sine, DoubleDouble q) const {
    DoubleDouble sum = 0;
    for (const DoubleDouble& y : y_) {
        const DoubleDouble yy = y * y, t = q * y;
        sum = sum + power((sine + 1) * (q * q + yy) / (yy + 1)) * t / (t * t + 1);
    }
    return sum * (2 * rim_step);
}

// The part of z that changes sign with the cosine, for the squared exponential.
DoubleDouble ExactCovariance::odd_part(double cosine) const {
    const DoubleDouble squared_sine = DoubleDouble(1) - DoubleDouble(cosine) * cosine;
    DoubleDouble t = kappa_ * 0.5 * exp(-kappa_), b = cosine, edge = cosine, sum = t * b;
    for (int m = 1; m < kappa_.high || (t * b).high > 1e-34 * sum.high; ++m) {
        t = t * kappa_ * kappa_ / (4.0 * m * (m + 1));
        edge = edge * squared_sine;
        b = (edge + b * (2.0 * m)) / (2.0 * m + 1);
        sum = sum + t * b;
    }
    return pi * 2 * sum;
}

DoubleDouble ExactCovariance::hemisphere_integral(double cosine) const {
    if (!sobolev_) {
        // (1 - e^(-2 kappa)) / kappa by the series of sinh: positive terms, no cancellation.
        DoubleDouble term = exp(-kappa_), sum = term;
        for (int m = 1; m < kappa_.high || term.high > 1e-34 * sum.high; ++m)
            sum = sum + (term = term * kappa_ * kappa_ / (2.0 * m * (2 * m + 1)));
        return pi * 2 * sum + odd_part(cosine);
    }
    const DoubleDouble whole = pi * 2 * c_, factor = pow(2, DoubleDouble(p_) + 1) / (DoubleDouble(p_) + 1);
    if (cosine == 0) return whole * 0.5;  // half of the sphere
    const DoubleDouble c = cosine, sine = sqrt((DoubleDouble(1) - c) * (c + 1));
    return whole - factor * rim_integral(sine, c / (sine + 1));
}

DoubleDouble squared_chord(const Vec3& a, const Vec3& b) {
    const DoubleDouble x = DoubleDouble(a.x) - b.x, y = DoubleDouble(a.y) - b.y, z = DoubleDouble(a.z) - b.z;
    return x * x + y * y + z * z;
}

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

std::optional<std::vector<double>> ExactWeights::weights(double noise, const Cholesky& cholesky) const {
    std::vector<double> x(z_.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = z_[i].high;
    x = cholesky.solve(x);
    for (double last = largest(x);;) {
        const std::vector<double> correction = cholesky.solve(residual(x, noise));
        const double size = largest(correction);
        if (!(size < last / 2)) return std::nullopt;
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction[i];
        if (size <= 2 * DBL_EPSILON * largest(x)) return x;
        last = size;
    }
}
