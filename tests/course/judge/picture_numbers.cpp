#include "picture_numbers.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "experiments/statistics.h"
#include "numerics/cholesky.h"

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
double from_log_odds(double t) {
    const double odds = portable::exp(t);
    return std::min(1.0, (1.01 * odds - 0.1) / (1 + odds));
}

// A scale on which the spread of a number over seeds is about normal: errors by their logarithms, correlations by those
// of their distances to 0 and 1. The floor is the least deviation that is allowed for: correct programs differ in their
// frames and roundings, and the largest of many errors has a long tail.
struct Scale {
    const char* name;
    double (*to)(double);
    double (*from)(double);
    double floor;
};
constexpr Scale scales[] = {
    {"rmse", log_of_positive, portable::exp, 0.01}, {"brightness", itself, itself, 0.001},
    {"correlation", log_odds, from_log_odds, 0.1},  {"alike", log_of_fraction, from_log_of_fraction, 0.05},
    {"block", log_of_positive, portable::exp, 0.2}, {"repeats", itself, itself, 0.01}};
const Scale& scale_of(std::size_t i) { return scales[std::min(i, named_numbers)]; }

// The numbers on their scales.
Numbers scaled(Numbers numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = scale_of(i).to(numbers[i]);
    return numbers;
}

// Number i of all: its mean, and the standard deviation of a picture's.
struct Spread {
    double mean, deviation;
};
Spread spread_of(const std::vector<Numbers>& all, std::size_t i) {
    Statistics statistics;
    for (const Numbers& numbers : all) statistics.add(numbers[i]);
    return {statistics.mean, statistics.standard_error() * std::sqrt(statistics.count)};
}

// Of numbers on their scales, with the deviation of a new number from the mean of these.
Spread scaled_spread(const std::vector<Numbers>& all, std::size_t i) {
    const Spread spread = spread_of(all, i);
    const double deviation = spread.deviation * std::sqrt(1 + 1 / static_cast<double>(all.size()));
    return {spread.mean, std::max(scale_of(i).floor, deviation)};
}

// One picture in 50,000 exceeds it, were the numbers normal: of n = 40 others and k = 5 numbers, (n - k) / (k (n - 1))
// of the square is distributed as F with k and n - k degrees of freedom (Hotelling, 1931).
constexpr double accepted_joint_deviation = 7;

// How far the named numbers, on their scales, are from the mean of others, in standard deviations along the ellipsoid
// that these scatter in (Mahalanobis, 1936).
double joint_deviation(const Numbers& here, const std::vector<Numbers>& others) {
    const double n = static_cast<double>(others.size());
    std::vector<double> mean, difference;
    for (std::size_t i = 0; i < named_numbers; ++i) {
        mean.push_back(spread_of(others, i).mean);
        difference.push_back(here[i] - mean[i]);
    }
    Matrix covariance(named_numbers, named_numbers);
    for (std::size_t i = 0; i < named_numbers; ++i) {
        for (std::size_t j = i; j < named_numbers; ++j)
            for (const Numbers& other : others)
                covariance(i, j) += (1 + 1 / n) / (n - 1) * (other[i] - mean[i]) * (other[j] - mean[j]);
        covariance(i, i) += scale_of(i).floor * scale_of(i).floor;
    }
    const std::vector<double> whitened = Cholesky(covariance).solve_lower(difference);
    return std::sqrt(std::inner_product(whitened.begin(), whitened.end(), whitened.begin(), 0.0));
}

// The errors of a picture as one number a pixel, 0 where it shows no object, less the brightness error that all share.
std::vector<double> errors_of(const Image& picture, const Truth& truth, double brightness) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const Color error = picture[i] - (1 + brightness) * truth.image[i];
        errors.push_back(truth.mask[i] ? error.x + error.y + error.z : 0);
    }
    return errors;
}

std::vector<Lag> all_lags() {
    std::vector<Lag> lags;
    for (int y = 0; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x)
            if (y > 0 || x > 1) lags.push_back({x, y});
    for (const int side : {3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 25, 30, 32, 50, 64, 100, 128})
        for (const Lag lag : {Lag{side, 0}, {0, side}}) lags.push_back(lag);
    return lags;
}

// Of all pairs of pixels that show an object.
double correlation(const std::vector<double>& errors, const Truth& truth, Lag lag) {
    const int width = truth.image.width(), height = truth.image.height();
    double products = 0, squares = 0;
    for (int y = 0; y + lag.y < height; ++y)
        for (int x = std::max(0, -lag.x); x < std::min(width, width - lag.x); ++x) {
            const auto i = static_cast<std::size_t>(y * width + x);
            const std::size_t j = i + static_cast<std::size_t>(lag.y * width + lag.x);
            if (!truth.mask[i] || !truth.mask[j]) continue;
            products += errors[i] * errors[j];
            squares += (errors[i] * errors[i] + errors[j] * errors[j]) / 2;
        }
    return squares > 0 ? products / squares : 0;
}

// The fraction of neighbours, side by side or one above the other.
double alike_neighbours(const Image& picture, const Truth& truth, double rmse) {
    const int width = picture.width(), height = picture.height();
    double pairs = 0, alike = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const auto& [right, below] : {std::pair(x + 1, y), {x, y + 1}}) {
                if (right == width || below == height || !truth.shows_object(x, y) || !truth.shows_object(right, below))
                    continue;
                const Vec3 difference =
                    (picture(x, y) - truth.image(x, y)) - (picture(right, below) - truth.image(right, below));
                pairs += 1;
                alike += dot(difference, difference) < 0.03 * rmse * rmse;
            }
    return pairs > 0 ? alike / pairs : 0;
}

}  // namespace

Lag lag_of(std::size_t number) { return all_lags()[number - named_numbers]; }

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

Numbers numbers_of(const Image& picture, const Truth& truth) {
    const ImageError error = image_error(picture, truth);
    Numbers numbers{error.rmse, error.brightness, error.correlation, alike_neighbours(picture, truth, error.rmse),
                    largest_block_error(picture, truth).error};
    const std::vector<double> errors = errors_of(picture, truth, error.brightness);
    const double of_neighbours = correlation(errors, truth, {1, 0});
    for (const Lag lag : all_lags())
        if (2 * std::max(lag.x, lag.y) < std::min(picture.width(), picture.height()))
            numbers.push_back(correlation(errors, truth, lag) - of_neighbours);
    return numbers;
}

const Quantity& Comparison::operator[](const std::string& name) const {
    return *std::find_if(quantities.begin(), quantities.end(), [&](const Quantity& q) { return q.name == name; });
}

bool Comparison::fits() const {
    return std::all_of(quantities.begin(), quantities.end(), [](const Quantity& quantity) { return quantity.fits(); });
}

Comparison compared(const Numbers& here, const std::vector<Numbers>& correct, Accepted accepted) {
    const Numbers scaled_here = scaled(here);
    std::vector<Numbers> scaled_correct;
    std::transform(correct.begin(), correct.end(), std::back_inserter(scaled_correct), scaled);
    Comparison comparison{{}, named_numbers};
    const auto add = [&](std::size_t i, double deviations) {
        const Spread plain = spread_of(correct, i), spread = scaled_spread(scaled_correct, i);
        const double reach = deviations * spread.deviation;
        const auto from = scale_of(i).from;
        comparison.quantities.push_back({scale_of(i).name, here[i], plain.mean, plain.deviation,
                                         from(spread.mean - reach), from(spread.mean + reach)});
    };
    for (std::size_t i = 0; i < named_numbers; ++i) add(i, accepted.deviations);
    double most = 0;
    for (std::size_t i = named_numbers; i < here.size(); ++i) {
        const Spread spread = scaled_spread(scaled_correct, i);
        const double deviation = std::fabs(scaled_here[i] - spread.mean) / spread.deviation;
        if (deviation > most) comparison.strangest = i;
        most = std::max(most, deviation);
    }
    add(comparison.strangest, accepted.of_lag);
    const double together = joint_deviation(scaled_here, scaled_correct);
    comparison.quantities.push_back({"together", together, 0, 0, 0, accepted_joint_deviation});
    return comparison;
}
