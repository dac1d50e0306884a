// alone_rules TASK: what the function of the task table, direct, single, rotated or pool does where rules are made and
// applied by the stand-ins below, which integrate nothing: their numbers tell which directions were taken, and in which
// order.
#include "experiments/error_table.h"
#include "scene/pixel_rules.h"
#include "scene/reflection.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>

using namespace bmc;
using portable::pi;

namespace {

std::size_t rules_made = 0;

double mark(const std::vector<double>& values) {
    double sum = 0.1;
    for (std::size_t i = 0; i < values.size(); ++i) sum += std::sqrt(0.5 + static_cast<double>(i)) * values[i];
    return sum;
}

}  // namespace

namespace bmc {
DirectionSet place_directions(Placement placement, std::size_t n, Random& random) {
    DirectionSet set{placement, {}};
    for (std::size_t i = 0; i < n; ++i) {
        const double y = random.uniform();
        set.directions.push_back(rotate_around_y({0, y, std::sqrt(1 - y * y)}, 0.1 * static_cast<double>(i)));
    }
    return set;
}

QuadratureRule monte_carlo_rule(DirectionSet set) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < set.directions.size(); ++i) weights.push_back(2 - 0.1 * static_cast<double>(i));
    return {set.directions, weights};
}

Cholesky::Cholesky(Matrix a) : upper_(std::move(a)) {}

// The weights of a rule are its number.
GaussianProcess::GaussianProcess(const Covariance&, double noise, std::vector<Vec3> directions, KnownPart)
    : directions_(std::move(directions)), cholesky_(Matrix(0, 0)), variance_(noise) {
    weights_.assign(directions_.size(), static_cast<double>(++rules_made));
}
QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions, KnownPart) {
    const GaussianProcess process(covariance, noise, std::move(directions));
    return {process.directions(), process.weights()};
}
double GaussianProcess::integral(const std::vector<double>& values) const { return mark(values) + variance_; }
double GaussianProcess::standard_error(const std::vector<double>& values) const { return mark(values) / 7; }

CosineRule cosine_rule(const QuadratureRule& rule) {
    CosineRule same;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) same.add(rule.directions[i], rule.weights[i]);
    return same;
}

Color reflected_light(const Scene&, const EnvironmentMap&, const Hit&, const CosineRule&, const Frame&) { return {}; }
}  // namespace bmc

namespace {

void table() {
    ErrorSettings settings;
    settings.samples = {2, 5, 60};
    settings.mc_estimates = 5;
    settings.bmc_estimates = 3;
    settings.noise = 0.25;
    std::printf("# samples mc_error bmc_error bmc_predicted\n");
    const Integrand integrand{"", "", [](Vec3 w) { return w.y; }, 4};
    for (const ErrorRow& row : error_table(integrand, settings))
        std::printf("%zu %.9g %.9g %.9g\n", row.samples, row.mc_error, row.bmc_error, row.bmc_predicted);
}

// A pixel's random numbers, and what the method made of them.
struct Pixel {
    double u, turns;
    const PlacedRule placed;
    Vec3 normal;

    // The turns, in [0, 1), by which direction i was turned about the normal.
    double turned(std::size_t i) const {
        const Vec3 w = local(i);
        const double all = std::atan2(w.x, w.z) / (2 * pi) - 0.1 * static_cast<double>(i);
        return all - std::floor(all);
    }
    Vec3 local(std::size_t i) const {
        const Direction d = placed.frame.to_world(placed.rule->directions.direction(i));
        const Frame frame(normal);
        const Vec3 w{d.x, d.y, d.z};
        return {dot(w, frame.tangent), dot(w, frame.normal), dot(w, frame.bitangent)};
    }
};

const char* angle(const std::vector<Pixel>& pixels) {
    const std::pair<double, const char*> factors[] = {{1, "by the pixel's turns"},
                                                      {0, "not turned"},
                                                      {-1, "by the turns, but the other way round"},
                                                      {1 / (2 * pi), "by so many radians instead of turns"},
                                                      {2 * pi, "by 2 pi as much: turns are no radians"},
                                                      {360, "by 360 times as much: turns are no degrees"},
                                                      {360 / (2 * pi), "by 57.3 times as much: turns are no degrees"},
                                                      {2, "twice as far"},
                                                      {0.5, "half as far"}};
    for (const auto& [factor, words] : factors) {
        bool fits = true;
        for (const Pixel& pixel : pixels)
            for (std::size_t i = 0; i < pixel.placed.rule->directions.size(); ++i) {
                const double apart = pixel.turned(i) - factor * pixel.turns;
                fits = fits && std::fabs(apart - std::floor(apart + 0.5)) < 1e-3;
            }
        if (fits) return words;
    }
    return "by another angle, or directions by different ones";
}

void choices(const std::vector<Pixel>& pixels, const PixelRules& rules) {
    std::map<double, std::size_t> numbers;
    for (const auto& shared : rules.shared()) numbers.emplace(shared->directions.weights.at(0), numbers.size());
    std::map<std::size_t, std::pair<double, double>> chosen;  // the least and the largest u for which it is chosen
    for (const Pixel& pixel : pixels) {
        const std::size_t number = numbers.at(pixel.placed.rule->directions.weights.at(0));
        auto& [least, largest] = chosen.emplace(number, std::pair(pixel.u, pixel.u)).first->second;
        least = std::min(least, pixel.u), largest = std::max(largest, pixel.u);
    }
    std::printf("# rules never chosen:");
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (chosen.count(i) == 0) std::printf(" %zu of %zu", i, numbers.size());
    std::printf("\n# rule chosen_from_u to_u\n");
    for (const auto& [number, u] : chosen) std::printf("%zu %.3f %.3f\n", number, u.first, u.second);
}

void method(Method its) {
    RenderSettings settings;
    settings.method = its;
    settings.samples = 3;
    settings.pool = 7;
    const PixelRules rules(settings);
    const std::size_t shared = rules_made;
    std::vector<Pixel> pixels;
    bool upright = true, own = true;
    for (std::size_t i = 0; i < 2000; ++i) {
        Random random(3, i), same(3, i);
        const double u = same.uniform(), turns = same.uniform();
        const Vec3 normal = normalize({std::sin(static_cast<double>(i)), 0.1 + u, turns - 0.5});
        pixels.push_back({u, turns, rules.rule_for(normal, random), normal});
        const CosineRule& rule = pixels.back().placed.rule->directions;
        for (std::size_t j = 0; j < rule.size(); ++j)
            upright = upright && std::fabs(pixels.back().local(j).y - static_cast<double>(rule.y[j])) < 1e-3;
        own = own && std::fabs(pixels.back().local(0).y - u) < 1e-3;
    }
    std::printf("# directions of a rule: %zu\n", pixels[0].placed.rule->directions.size());
    std::printf("# rules made for 2000 pixels: %zu\n", rules_made - shared);
    std::printf("# their up axis is the normal: %s\n", upright ? "yes" : "no");
    std::printf("# turned: %s\n", angle(pixels));
    if (its == Method::direct) std::printf("# drawn first from the pixel's random numbers: %s\n", own ? "yes" : "no");
    if (its != Method::direct) choices(pixels, rules);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::strcmp(argv[1], "table") == 0) return table(), 0;
        for (const auto& [name, its] : method_names)
            if (argc == 2 && std::strcmp(argv[1], name) == 0) return method(its), 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    std::fprintf(stderr, "usage: alone_rules table, direct, single, rotated or pool\n");
    return 2;
}
