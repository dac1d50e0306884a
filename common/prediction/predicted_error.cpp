#include "prediction/predicted_error.h"

#include <numeric>
#include <stdexcept>

namespace bmc {
namespace {

// The factor of the light in a sample: for a process cos(theta), or 1 if it is known; for Monte Carlo n times the
// weight.
double factor_of(const ModelledRule& rule, KnownPart known, std::size_t j) {
    if (!rule.process) return static_cast<double>(rule.directions.size()) * rule.directions.weights[j];
    return known == KnownPart::cosine ? 1 : static_cast<double>(rule.directions.y[j]);
}

MakeRule modelled_rules(const RenderSettings& settings) {
    if (settings.method == Method::mc)
        return [](DirectionSet set) {
            return std::make_shared<const ModelledRule>(ModelledRule{{cosine_rule(monte_carlo_rule(set))}, {}});
        };
    const std::shared_ptr<const Covariance> covariance = settings.make_covariance();
    return [=, noise = settings.noise, known = settings.known](DirectionSet set) {
        GaussianProcess process(*covariance, noise, std::move(set.directions), known);
        const QuadratureRule rule{process.directions(), process.weights(), known};
        return std::make_shared<const ModelledRule>(ModelledRule{{cosine_rule(rule)}, std::move(process)});
    };
}

}  // namespace

PixelError error_of_light(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                          const ModelledRule& rule, const Frame& frame, KnownPart known) {
    const std::size_t n = rule.directions.size();
    std::vector<Color> samples;
    for (std::size_t j = 0; j < n; ++j) {
        const Direction direction = frame.to_world(rule.directions.direction(j));
        const Color light = is_shadowed(scene, hit, direction) ? Color{} : environment.radiance(direction);
        samples.push_back(factor_of(rule, known, j) * light);
    }
    PixelError error{{}, {}, n};
    for (const auto channel : channels) {
        std::vector<double> values;
        for (const Color& sample : samples) values.push_back(sample.*channel);
        if (rule.process) {
            const double amplitude = rule.process->amplitude(values);
            error.squared_amplitude.*channel = amplitude * amplitude;
            error.unit_variance.*channel = rule.process->variance();
        } else {
            error.squared_amplitude.*channel = sum_of_squares(deviations(values)) / (static_cast<double>(n) - 1);
            error.unit_variance.*channel = 1 / static_cast<double>(n);
        }
    }
    const Color brdf = 1 / portable::pi * hit.albedo;
    error.squared_amplitude = brdf * brdf * error.squared_amplitude;
    return error;
}

ErrorOf error_of_picture(const Scene& scene, const EnvironmentMap& environment, const RenderSettings& settings,
                         const Progress& progress) {
    const auto rules = std::make_shared<const PixelRules>(settings, modelled_rules(settings), progress);
    return [&scene, &environment, known = settings.known, rules](const Hit& hit, Random& random) {
        const auto [rule, frame] = rules->rule_for(hit.normal, random);
        return error_of_light(scene, environment, hit, static_cast<const ModelledRule&>(*rule), frame, known);
    };
}

bool predicts_error(const RenderSettings& settings) {
    return settings.method != Method::mc || (!is_lattice(settings.placement) && settings.samples > 1);
}

Color standard_error(const PixelError& error, Color picture_squared_amplitude) {
    constexpr double prior_samples = 3;
    const double n = static_cast<double>(error.samples);
    Color result;
    for (const auto channel : channels)
        result.*channel =
            std::sqrt(error.unit_variance.*channel / (n + prior_samples) *
                          (n * error.squared_amplitude.*channel + prior_samples * picture_squared_amplitude.*channel) +
                      error.other_variance.*channel);
    return result;
}

double root_mean_square(const Image& errors, double pixels) {
    double sum = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) sum += dot(errors[i], errors[i]);
    return pixels > 0 ? std::sqrt(sum / (3 * pixels)) : 0;
}

Image grey_scale(const Image& errors, double white) {
    return image_of(errors.width(), errors.height(), [&](int x, int y) {
        const double error = std::sqrt(dot(errors(x, y), errors(x, y)) / 3);
        const double level = white > 0 ? error / white : 0;
        return Color{level, level, level};
    });
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
}  // namespace bmc
