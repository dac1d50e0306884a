#include "experiments/rule.h"

std::string rule_report(const QuadratureRule& rule) {
    std::string text = "#       x         y         z       weight\n";
    double sum = 0;
    std::size_t negative = 0;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        const Vec3 direction = rule.directions[i];
        text += line("%9.6f %9.6f %9.6f %12.6g\n", direction.x, direction.y, direction.z, rule.weights[i]);
        sum += rule.weights[i];
        negative += rule.weights[i] < 0 ? 1 : 0;
    }
    const bool cosine = rule.known == KnownPart::cosine;
    return text + line("# The weights sum to %.6g, the integral of %s is %.6g; %zu weights are negative.\n", sum,
                       cosine ? "cos(theta)" : "1", cosine ? portable::pi : 2 * portable::pi, negative);
}

std::vector<Option> Rule::options() {
    std::vector<Option> options = {
        {"samples", "N", "directions of the rule (default 40)", [this](const std::string& text) {
             samples = static_cast<std::size_t>(parse_integer(text, 1, max_process_samples));
         }}};
    for (Option& option : model.options()) options.push_back(std::move(option));
    return options;
}

std::string Rule::report() const {
    const std::unique_ptr<Covariance> covariance = model.make_covariance();
    Random random(model.seed, 0);
    return rule_report(
        bayesian_rule(*covariance, model.noise, place_directions(model.placement, samples, random), model.prior));
}
