#include "fingerprint.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/statistics.h"
#include "numerics/cholesky.h"

namespace bmc {
namespace {

double itself(double x) { return x; }
double log_of_positive(double x) { return portable::log(std::max(x, 1e-12)); }

// In a small picture no neighbours may be alike; hence the 0.003.
double log_of_fraction(double x) { return portable::log(0.003 + x); }
double from_log_of_fraction(double t) { return std::clamp(portable::exp(t) - 0.003, 0.0, 1.0); }

// Independent pixels have correlations of about 0, of either sign; hence the 0.1.
double log_odds(double correlation) {
    return portable::log((0.1 + std::max(correlation, -0.09)) / (1.01 - correlation));
}
double from_log_odds(double t) { return std::min(1.0, 1.01 - 1.11 / (1 + portable::exp(t))); }

// A scale on which the spread of a number over seeds is about normal: errors by their logarithms, correlations by those
// of their distances to 0 and 1. The floor is the least deviation that is allowed for: correct programs differ in their
// frames and roundings, and the largest of many errors has a long tail.
struct Scale {
    const char* name;
    double (*to)(double);
    double (*from)(double);
    double floor;
};
constexpr Scale scales[] = {{"rmse", log_of_positive, portable::exp, 0.01},
                            {"brightness", itself, itself, 0.001},
                            {"correlation", log_odds, from_log_odds, 0.1},
                            {"alike", log_of_fraction, from_log_of_fraction, 0.02},
                            {"block", log_of_positive, portable::exp, 0.2},
                            {"near", log_odds, from_log_odds, 0.03},
                            {"part", itself, itself, 0.004},
                            {"repeats", itself, itself, 0.01}};
const Scale& scale_of(std::size_t i) { return scales[std::min(i, i < first_lag ? first_part : first_part + 1)]; }

// One picture in 50,000 exceeds it, were the numbers normal: of n = 40 others and k = 6 numbers, (n - k) / (k (n - 1))
// of the square is distributed as F with k and n - k degrees of freedom (Hotelling, 1931).
constexpr double accepted_joint_deviation = 7;

// How far the first numbers, on their scales, are from the mean of correct ones, in standard deviations along the
// ellipsoid that these scatter in (Mahalanobis, 1936).
double joint_deviation(const Fingerprint& measured, const std::vector<Fingerprint>& correct) {
    const double n = static_cast<double>(correct.size());
    const auto difference = [&](const Fingerprint& from, std::size_t i) {
        return scale_of(i).to(from[i]) - spread_of(correct, i).mean;
    };
    Matrix covariance(first_part, first_part);
    std::vector<double> differences;
    for (std::size_t i = 0; i < first_part; ++i) {
        differences.push_back(difference(measured, i));
        for (std::size_t j = i; j < first_part; ++j)
            for (const Fingerprint& each : correct)
                covariance(i, j) += (1 + 1 / n) / (n - 1) * difference(each, i) * difference(each, j);
        covariance(i, i) += scale_of(i).floor * scale_of(i).floor;
    }
    const std::vector<double> whitened = Cholesky(covariance).solve_lower(differences);
    return std::sqrt(std::inner_product(whitened.begin(), whitened.end(), whitened.begin(), 0.0));
}

// The mean error of each colour on the sphere and on the rectangle, over its mean light.
std::vector<double> part_errors(const Image& picture, const Truth& truth) {
    Color errors[2], light[2];
    for_each_hit(sphere_scene(), {picture.width(), picture.height()}, [&](int x, int y, const Hit& hit) {
        const std::size_t part = hit.object == Object::sphere ? 0 : 1;
        errors[part] += picture(x, y) - truth.image(x, y);
        light[part] += truth.image(x, y);
    });
    std::vector<double> relative;
    for (std::size_t part = 0; part < 2; ++part)
        for (const auto channel : channels)
            relative.push_back(errors[part].*channel / std::max(light[part].*channel, 1e-12));
    return relative;
}

constexpr int near_lags = 12;  // begin with a neighbour's, {1, 0}
std::vector<Lag> all_lags() {
    std::vector<Lag> lags;
    for (int y = 0; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x)
            if (y > 0 || x > 0) lags.push_back({x, y});
    for (const int side : {3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 25, 30, 32, 50, 64, 100, 128})
        for (const Lag lag : {Lag{side, 0}, {0, side}}) lags.push_back(lag);
    return lags;
}

// Calls f(i, j) for all pairs of pixels so far apart that both show an object.
template <class Function>
void each_pair(const Truth& truth, Lag lag, Function f) {
    const int width = truth.image.width(), height = truth.image.height();
    for (int y = 0; y + lag.y < height; ++y)
        for (int x = std::max(0, -lag.x); x < std::min(width, width - lag.x); ++x) {
            const auto i = static_cast<std::size_t>(y * width + x);
            const std::size_t j = i + static_cast<std::size_t>(lag.y * width + lag.x);
            if (truth.mask[i] && truth.mask[j]) f(i, j);
        }
}

double correlation(const std::vector<double>& errors, const Truth& truth, Lag lag) {
    double products = 0, squares = 0;
    each_pair(truth, lag, [&](std::size_t i, std::size_t j) {
        products += errors[i] * errors[j];
        squares += (errors[i] * errors[i] + errors[j] * errors[j]) / 2;
    });
    return squares > 0 ? products / squares : 0;
}

// The fraction of neighbours, side by side or one above the other.
double alike_neighbours(const Image& picture, const Truth& truth, double rmse) {
    double pairs = 0, alike = 0;
    for (const Lag neighbour : {Lag{1, 0}, {0, 1}})
        each_pair(truth, neighbour, [&](std::size_t i, std::size_t j) {
            const Vec3 difference = (picture[i] - truth.image[i]) - (picture[j] - truth.image[j]);
            pairs += 1;
            alike += dot(difference, difference) < 0.03 * rmse * rmse;
        });
    return pairs > 0 ? alike / pairs : 0;
}

}  // namespace

Lag lag_of(std::size_t number) { return all_lags()[number - first_lag]; }

BlockError largest_block_error(const Image& picture, const Truth& truth) {
    const int side = std::max(4, std::min(picture.width(), picture.height()) / 25);
    BlockError largest{0, 0, 0};
    for (int top = 0; top < picture.height(); top += side)
        for (int left = 0; left < picture.width(); left += side) {
            Color sum;
            int count = 0;
            for (int y = top; y < std::min(top + side, picture.height()); ++y)
                for (int x = left; x < std::min(left + side, picture.width()); ++x) {
                    if (!truth.shows_object(x, y)) continue;
                    sum = sum + (picture(x, y) - truth.image(x, y));
                    ++count;
                }
            if (2 * count < side * side) continue;
            const double error = std::sqrt(dot(sum, sum) / 3) / count;
            if (error > largest.error) largest = {error, left + side / 2, top + side / 2};
        }
    return largest;
}

Fingerprint fingerprint(const Image& picture, const Truth& truth) {
    const ImageError error = image_error(picture, truth);
    std::vector<double> errors, correlations;  // less the brightness error that all share
    for (std::size_t i = 0; i < picture.size(); ++i)
        errors.push_back(dot(picture[i] - (1 + error.brightness) * truth.image[i], {1, 1, 1}));
    for (const Lag lag : all_lags())
        if (2 * std::max(lag.x, lag.y) < std::min(picture.width(), picture.height()))
            correlations.push_back(correlation(errors, truth, lag));
    Fingerprint numbers{error.rmse,
                        error.brightness,
                        error.correlation,
                        alike_neighbours(picture, truth, error.rmse),
                        largest_block_error(picture, truth).error,
                        std::accumulate(correlations.begin(), correlations.begin() + near_lags, 0.0) / near_lags};
    for (const double part : part_errors(picture, truth)) numbers.push_back(part);
    RootMeanSquare roughness;
    each_pair(truth, {1, 0}, [&](std::size_t i, std::size_t j) { roughness.add(errors[i] - errors[j]); });
    numbers.push_back(roughness.value());
    for (const double each : correlations) numbers.push_back(each - correlations[0]);
    return numbers;
}

Spread spread_of(const std::vector<Fingerprint>& correct, std::size_t i) {
    Statistics statistics;
    for (const Fingerprint& each : correct) statistics.add(scale_of(i).to(each[i]));
    return {statistics.mean,
            std::max(scale_of(i).floor, statistics.standard_error() * std::sqrt(statistics.count + 1))};
}

const Quantity& Comparison::operator[](const std::string& name) const {
    return *std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& q) { return q.name == name; });
}

bool Comparison::fits() const {
    return std::all_of(quantities.begin(), quantities.end(), [](const Quantity& quantity) { return quantity.fits(); });
}

Comparison compare(const Fingerprint& measured, const std::vector<Fingerprint>& correct, Accepted accepted) {
    Comparison comparison{{}, first_lag};
    const auto add = [&](std::size_t i, double deviations) {
        const auto [mean, deviation] = spread_of(correct, i);
        const auto& [name, to, from, floor] = scale_of(i);
        comparison.quantities.push_back(
            {name, measured[i], from(mean), from(mean - deviations * deviation), from(mean + deviations * deviation)});
    };
    for (std::size_t i = 0; i < first_part; ++i) add(i, accepted.deviations);
    const auto of_lag = [&](std::size_t i) { return std::fabs(spread_of(correct, i).deviations(measured[i])); };
    for (std::size_t i = first_lag; i < measured.size(); ++i)
        if (of_lag(i) > of_lag(comparison.most_deviating_lag)) comparison.most_deviating_lag = i;
    add(comparison.most_deviating_lag, accepted.of_lag);
    comparison.quantities.push_back({"together", joint_deviation(measured, correct), 0, 0, accepted_joint_deviation});
    return comparison;
}
}  // namespace bmc
