#include "scene/predicted_error.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

// Each colour by itself: (*colour).x, y, z.
static constexpr double Color::*channels[] = {&Color::x, &Color::y, &Color::z};

// BEGIN SOLUTION extra
namespace {

// What a rule of n directions sees from a point: for direction j whether the environment is visible, and the light that
// arrives or, where that is known, the mean over the direction's cap.
struct Samples {
    std::vector<double> visible;
    std::vector<Color> light;
};

Samples samples_of(const Scene& scene, const Light& light, const Hit& hit, const PlacedRule& placed) {
    const auto& [rule, caps, process] = *placed.rule;
    Samples samples;
    for (std::size_t j = 0; j < rule.size(); ++j) {
        const Direction direction = placed.frame.to_world(rule[j].direction);
        const bool visible = !is_shadowed(scene, hit, direction);
        const Color seen = visible ? light.environment().radiance(direction) : Color{};
        samples.visible.push_back(visible);
        samples.light.push_back(caps.empty() ? seen : caps[j]->radiance(direction));
    }
    return samples;
}

double sum_of_squares(const std::vector<double>& values) {
    return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

std::vector<double> deviations(std::vector<double> values) {
    if (values.size() == 1)
        throw std::invalid_argument("one sample says nothing of the error of its mean; take two or more");
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    for (double& value : values) value -= mean;
    return values;
}

// By a process of the light, or by samples whose weights count it already.
PixelError error_of_light(const PixelRule& rule, KnownPart known, const Samples& samples) {
    std::vector<double> values(rule.rule.size());
    const double n = static_cast<double>(values.size());
    PixelError error;
    for (const auto channel : channels) {
        for (std::size_t j = 0; j < values.size(); ++j) {
            const auto& [direction, weight] = rule.rule[j];
            const double factor = !rule.process ? n * weight : known == KnownPart::cosine ? 1 : direction.y;
            values[j] = factor * samples.light[j].*channel;
        }
        if (rule.process) {
            const double amplitude = rule.process->amplitude(values);
            error.amplitude.*channel = amplitude * amplitude;
            error.variance.*channel = rule.process->variance();
        } else {
            error.amplitude.*channel = sum_of_squares(deviations(values)) / (n - 1);
            error.variance.*channel = 1 / n;
        }
    }
    return error;
}

// By a process of the visibility, or by independent samples of it.
PixelError error_of_visibility(const PixelRule& rule, Color irradiance, const Samples& samples) {
    double weights = 0, squared_weights = 0;
    Color parts, squared_parts;
    for (std::size_t j = 0; j < rule.rule.size(); ++j) {
        const double weight = rule.rule[j].weight;
        const Color part = weight * samples.light[j];
        weights += weight;
        squared_weights += weight * weight;
        parts += part;
        squared_parts += part * part;
    }
    std::vector<double> values = deviations(samples.visible);
    double even = 1;  // U of an even light, over the sum of e_j^2
    if (rule.process) {
        values = rule.process->cholesky().solve_lower(values);
        even = rule.process->variance() / (portable::pi * portable::pi) * (weights * weights) / squared_weights;
    }
    PixelError error;
    error.amplitude = sum_of_squares(values) / static_cast<double>(values.size() - 1) * (irradiance * irradiance);
    for (const auto channel : channels)
        if (parts.*channel > 0)
            error.variance.*channel = even * squared_parts.*channel / (parts.*channel * parts.*channel);
    return error;
}

}  // namespace

PixelError pixel_error(const Scene& scene, const Light& light, KnownPart known, const Hit& hit,
                       const PlacedRule& placed) {
    const Samples samples = samples_of(scene, light, hit, placed);
    PixelError error = known == KnownPart::light
                           ? error_of_visibility(*placed.rule, light.averages().sky_irradiance(hit.normal), samples)
                           : error_of_light(*placed.rule, known, samples);
    const Color brdf = 1 / portable::pi * hit.albedo;
    error.amplitude = brdf * brdf * error.amplitude;
    if (placed.sun.count > 1) {
        const Color sun = brdf * light.averages().sun_irradiance(hit.normal);
        const double m = static_cast<double>(placed.sun.count);
        error.sun = visible_sun(scene, light.averages(), hit, placed.sun).changes / (2 * m * (m - 1)) * (sun * sun);
    }
    return error;
}
// END SOLUTION

Color standard_error(const PixelError& error, Color picture_amplitude, std::size_t samples) {
    constexpr double more = 3;
    const double n = static_cast<double>(samples);
    Color result;
    for (const auto channel : channels)
        result.*channel = std::sqrt(error.variance.*channel / (n + more) *
                                        (n * error.amplitude.*channel + more * picture_amplitude.*channel) +
                                    error.sun.*channel);
    return result;
}

double root_mean_square(const Image& errors, double pixels) {
    double sum = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) sum += dot(errors[i], errors[i]);
    return std::sqrt(sum / (3 * pixels));
}

Image grey_scale(const Image& errors, double white) {
    return image_of(errors.width(), errors.height(), [&](int x, int y) {
        const double error = std::sqrt(dot(errors(x, y), errors(x, y)) / 3);
        const double level = white > 0 ? error / white : 0;
        return Color{level, level, level};
    });
}
