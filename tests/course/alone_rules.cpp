// alone_rules TASK: what the function of the task table, direct, single, rotated or pool does where rules are made and
// applied by the stand-ins below, whose numbers tell which directions were taken, and in which order.
#include "alone.h"

#include "experiments/error_table.h"
#include "scene/pixel_rules.h"
#include "scene/reflection.h"

#include <algorithm>
#include <map>
#include <stdexcept>

using namespace bmc;
using portable::pi;

namespace {

std::size_t rules_made = 0;
bool numbered = true;  // the weights of a rule are its number

double integrand_of(Vec3 w) { return 40 * w.y; }

// What a table was made of: the y of the first direction of every set, what was estimated there, and the errors
// predicted.
struct Taken {
    std::vector<double> mc, bmc, mc_estimates, bmc_estimates, predicted;
    double noise = 0, covariance = 0;
} taken;

}  // namespace

DirectionSet bmc::place_directions(Placement placement, std::size_t n, Random& random) {
    DirectionSet set{placement, {}};
    for (std::size_t i = 0; i < n; ++i) {
        const double y = random.uniform();
        set.directions.push_back(rotate_around_y({0, y, std::sqrt(1 - y * y)}, 0.1 * static_cast<double>(i)));
    }
    return set;
}

QuadratureRule bmc::monte_carlo_rule(DirectionSet set) {
    taken.mc.push_back(set.directions.at(0).y);
    const double weight = 2 * pi / static_cast<double>(set.directions.size());
    taken.mc_estimates.push_back(0);
    for (const Vec3& direction : set.directions) taken.mc_estimates.back() += weight * integrand_of(direction);
    return {set.directions, std::vector<double>(set.directions.size(), weight)};
}

Cholesky::Cholesky(Matrix a) : upper_(std::move(a)) {}

GaussianProcess::GaussianProcess(const Covariance& covariance, double noise, std::vector<Vec3> directions, Known)
    : directions_(std::move(directions)), cholesky_(Matrix(0, 0)), variance_(0.3) {
    taken.bmc.push_back(directions_.at(0).y);
    taken.noise = noise;
    taken.covariance = covariance(1);
    ++rules_made;
    const double n = static_cast<double>(directions_.size());
    taken.bmc_estimates.push_back(0);
    for (double i = 0.5; i < n; ++i) {
        weights_.push_back(numbered ? static_cast<double>(rules_made)
                                    : 2 * pi / n * (noise + i) / (taken.covariance + n / 2));
        taken.bmc_estimates.back() += weights_.back() * integrand_of(directions_[weights_.size() - 1]);
    }
}
QuadratureRule bmc::bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions, Known) {
    const GaussianProcess process(covariance, noise, std::move(directions));
    return {process.directions(), process.weights()};
}
double GaussianProcess::integral(const std::vector<double>& values) const {
    double estimate = 0;
    for (std::size_t i = values.size(); i-- > 0;) estimate += values[i] * weights_[i];
    return estimate;
}
double GaussianProcess::amplitude(const std::vector<double>& values) const { return values.at(0) / 3 + 2; }
double GaussianProcess::standard_error(const std::vector<double>& values) const {
    taken.predicted.push_back(values.at(0) + values.back() / 7 + static_cast<double>(values.size()));
    return taken.predicted.back();
}

CosineRule bmc::cosine_rule(const QuadratureRule& rule) {
    CosineRule same;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) same.add(rule.directions[i], rule.weights[i]);
    return same;
}

Color bmc::reflected_light(const Scene&, const EnvironmentMap&, const Hit&, const CosineRule&, const Frame&) {
    return {};
}

namespace {

// How the sets that a method took are not those of the estimates 0, 1, 2, ... of as many as wanted.
void explain_sets(const char* method, const std::vector<double>& sets, std::size_t wanted,
                  const ErrorSettings& settings, std::size_t n) {
    std::string numbers;
    for (const double y : sets) {
        std::size_t e = 0;
        while (e < 9 && estimate_directions(settings, n, e).directions[0].y != y) ++e;
        numbers += e < 9 ? ' ' + std::to_string(e) : " ?";
    }
    std::string right;
    for (std::size_t e = 0; e < wanted; ++e) right += ' ' + std::to_string(e);
    explain_if(sets.size() > wanted, "%s makes %zu estimates, the settings say %zu", method, sets.size(), wanted);
    explain_if(!sets.empty() && numbers.substr(0, right.size()) != right.substr(0, numbers.size()),
               "%s takes the directions of the estimates%.40s (?: none of these), not%s", method, numbers.c_str(),
               right.c_str());
    explain_if(!sets.empty() && sets.size() != wanted, "%s makes %zu estimates, the settings say %zu", method,
               sets.size(), wanted);
}

// A column of a table: what is in a row, and what it is the mean of.
struct Column {
    double given;
    std::vector<double> values;  // estimates, or standard errors, which have the truth 0
    double truth, n, other;      // numbers of samples, and of the other method's estimates
};

Mistakes mistakes_of_column(const Column& c) {
    std::vector<double> errors;
    double size = 0, bias = 0;
    for (const double value : c.values) {
        errors.push_back(std::fabs(value - c.truth));
        size += errors.back(), bias += value - c.truth;
    }
    const double count = static_cast<double>(errors.size());
    return mistakes(errors,
                    {{{size}, " is a sum; it should be a mean"},

                     {{size / c.other}, " is divided by the number of the other method's estimates"},
                     {{size / c.n, size / count / c.n}, " is divided by the number of samples"},
                     {{size / count / count}, " is divided by the number of estimates twice"},

                     {{bias / count + 2 * c.truth}, " has the truth added; it is to be subtracted"},
                     {{size / count / c.truth}, " is divided by the truth"},
                     {{bias / count + c.truth}, " has a mean of estimates: the truth is not subtracted"},
                     {{bias / count, -bias / count, std::fabs(bias / count)},
                      " is a mean without absolute values, or the absolute value of a mean"},

                     {{0.3, std::sqrt(0.3)},
                      " is the variance of the process or its root; standard_error(values) gives the error"}},
                    1 / count);
}

void explain_column(const char* name, std::vector<Column> rows) {
    std::vector<double> given;
    for (Column& row : rows) {
        given.push_back(row.given);
        if (row.values.empty()) row.values = {NAN};  // nothing that is known
    }
    explain(name, given, [&](std::size_t i) { return mistakes_of_column(rows[i]); });
}

void table() {
    numbered = false;
    ErrorSettings settings;
    settings.covariance = CovarianceFamily::squared_exponential;
    settings.noise = 0.25;
    settings.seed = 7;
    const Integrand integrand{"", "", integrand_of, 112};
    std::vector<Column> mc, bmc, predicted;
    for (const bool more : {false, true}) {
        settings.mc_estimates = more ? 2 : 5;
        settings.bmc_estimates = more ? 4 : 3;
        std::printf("# samples mc_error bmc_error bmc_predicted\n");
        for (const std::size_t n : {7u, 11u, 60u}) {
            settings.samples = {n};
            taken = {};
            const ErrorRow row = error_table(integrand, settings).at(0);
            std::printf("%zu %.9g %.9g %.9g\n", row.samples, row.mc_error, row.bmc_error, row.bmc_predicted);
            explain_sets("Monte Carlo", taken.mc, settings.mc_estimates, settings, n);
            explain_sets("Bayesian Monte Carlo", taken.bmc, settings.bmc_estimates, settings, n);
            explain_if(taken.noise != 0.25, "the process has the noise %g, the settings say 0.25", taken.noise);
            explain_if(taken.covariance != (*settings.make_covariance())(1), "the process has another covariance");
            const double samples = static_cast<double>(n), mcs = more ? 2 : 5, bmcs = more ? 4 : 3;
            mc.push_back({row.mc_error, taken.mc_estimates, integrand.truth, samples, bmcs});
            bmc.push_back({row.bmc_error, taken.bmc_estimates, integrand.truth, samples, mcs});
            predicted.push_back({row.bmc_predicted, taken.predicted, 0, samples, mcs});
        }
    }
    explain_column("mc_error", mc);
    explain_column("bmc_error", bmc);
    explain_column("bmc_predicted", predicted);
}

// A private function, for numbers that a stream of random numbers hardly gives.
PlacedRule pool_of(const PixelRules& rules, Vec3 normal, double u, double turns);
template <auto function>
struct Opened {
    friend PlacedRule pool_of(const PixelRules& rules, Vec3 normal, double u, double turns) {
        return (rules.*function)(normal, u, turns);
    }
};
template struct Opened<&PixelRules::pool>;

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
        const Direction d = placed.frame.to_world(placed.rule->direction(i));
        const Frame frame(normal);
        const Vec3 w{d.x, d.y, d.z};
        return {dot(w, frame.tangent), dot(w, frame.normal), dot(w, frame.bitangent)};
    }
};

// Whether every direction of every pixel was turned by so many times a number of the pixel.
bool all_turned(const std::vector<Pixel>& pixels, double factor, double Pixel::*number, double more = 0) {
    for (const Pixel& pixel : pixels)
        for (std::size_t i = 0; i < pixel.placed.rule->size(); ++i) {
            const double apart = pixel.turned(i) - factor * pixel.*number - more;
            if (!(std::fabs(apart - std::floor(apart + 0.5)) < 1e-3)) return false;
        }
    return true;
}

const char* angle(const std::vector<Pixel>& pixels) {
    const std::pair<double, const char*> factors[] = {{1, "by the pixel's turns"},
                                                      {0, "not turned"},
                                                      {-1, "by the turns, but the other way round"},
                                                      {1 / (2 * pi), "by so many radians instead of turns"},
                                                      {pi / 180, "by pi / 180 as much: turns are no degrees"},
                                                      {1.0 / 360, "by a 360th: turns are no degrees"},
                                                      {2 * pi, "by 2 pi as much: turns are no radians"},
                                                      {360, "by 360 times as much: turns are no degrees"},
                                                      {360 / (2 * pi), "by 57.3 times as much: turns are no degrees"},
                                                      {pi, "by pi as much: turns are no radians"},
                                                      {2, "twice as far"},
                                                      {0.5, "half as far"}};
    for (const auto& [factor, words] : factors)
        if (all_turned(pixels, factor, &Pixel::turns)) return words;
    const double first = pixels[0].turned(0);
    if (all_turned(pixels, 0, &Pixel::turns, first)) return "by a fixed angle";
    if (all_turned(pixels, 1, &Pixel::turns, first - pixels[0].turns)) return "by the turns and a fixed angle besides";
    if (all_turned(pixels, 1, &Pixel::u)) return "by u, which chooses the rule; turns is the angle";
    return "by another angle, or directions by different ones";
}

void print_choices(const std::vector<Pixel>& pixels, const PixelRules& rules) {
    std::map<double, std::size_t> numbers;
    for (const auto& shared : rules.shared()) numbers.emplace(shared.weights.at(0), numbers.size());
    std::map<std::size_t, std::pair<double, double>> chosen;  // the least and the largest u for which it is chosen
    std::vector<double> choices;
    for (const Pixel& pixel : pixels) {
        const auto number = numbers.find(pixel.placed.rule->weights.at(0));
        if (number == numbers.end()) throw std::runtime_error("the rule is none of shared_rules_");
        auto& [least, largest] = chosen.emplace(number->second, std::pair(pixel.u, pixel.u)).first->second;
        least = std::min(least, pixel.u), largest = std::max(largest, pixel.u);
        choices.push_back(static_cast<double>(number->second));
    }
    if (numbers.size() > 1)
        explain("", choices, [&](std::size_t i) {
            const double u = pixels[i].u;
            return Mistakes{{{std::floor(7 * u)}, ""},
                            {{std::floor(7 * pixels[i].turns)}, "turns chooses the rule; u is for that"},
                            {{0}, "the first rule is always chosen"},
                            {{6}, "the last rule is always chosen"},
                            {{std::floor(6 * u)}, "u is multiplied by size - 1, so the last is never chosen"},
                            {{std::floor(6 * u + 0.5), std::ceil(6 * u), std::min(6.0, std::floor(7 * u + 0.5))},
                             "u size is to be cut off, not rounded, nor is u (size - 1)"},
                            {{6 - std::floor(7 * u)}, "the rules are counted from the end"},
                            {{std::min(6.0, std::floor(20 * u))}, "u is multiplied by 20; the pool has size() rules"}};
        });
    std::printf("# rules never chosen:");
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (chosen.count(i) == 0) std::printf(" %zu of %zu", i, numbers.size());
    std::printf("\n# rule chosen_from_u to_u\n");
    for (const auto& [number, u] : chosen) std::printf("%zu %.3f %.3f\n", number, u.first, u.second);
    std::printf("# u rule\n");
    for (std::size_t i = 0; numbers.size() > 1 && i < 14; ++i) {
        const double u = i == 0 ? 0 : (static_cast<double>((i + 1) / 2) + (i % 2 == 0 ? 1e-9 : -1e-9)) / 7;
        std::printf("%.10f %zu\n", u, numbers.at(pool_of(rules, {0, 1, 0}, u, 0).rule->weights.at(0)));
    }
}

template <Method its>
void method() {
    RenderSettings settings;
    settings.method = its;
    settings.samples = 3;
    settings.pool = 7;
    const PixelRules rules(settings);
    const std::size_t shared = rules_made;
    std::vector<Pixel> pixels;
    bool upright = true, above = true, opposite = true, world = true, own = true;
    for (std::size_t i = 0; i < 2000; ++i) {
        Random random(3, i), same(3, i);
        const double u = same.uniform(), turns = same.uniform();
        const Vec3 normal = normalize({std::sin(static_cast<double>(i)), 2 * u - 1, turns - 0.5});
        pixels.push_back({u, turns, rules.rule_for(normal, random), normal});
        if (!pixels.back().placed.rule) throw std::runtime_error("a pixel has no rule");
        const CosineRule& rule = *pixels.back().placed.rule;
        for (std::size_t j = 0; j < rule.size(); ++j) {
            const double y = static_cast<double>(rule.y[j]);
            opposite = opposite && std::fabs(pixels.back().local(j).y + y) < 1e-3;
            world = world && squared_distance(pixels.back().placed.frame.normal, pixels[0].placed.frame.normal) < 1e-9;
            if (!(std::fabs(pixels.back().local(j).y - static_cast<double>(rule.y[j])) < 1e-3)) {
                upright = false;
                above = above && normal.y < 0;
            }
        }
        own = own && std::fabs(pixels.back().local(0).y - u) < 1e-3;
    }
    const std::size_t made = rules_made - shared;
    explain_if(opposite, "the frame's up axis is the opposite of the normal");
    explain_if(world, "the frame is not aligned with the normal: Frame(normal) does that");
    explain_if(!upright && above, "the frame's up axis is not the normal where that points down");
    explain_if((its == Method::rotated || its == Method::pool) && all_turned(pixels, 0, &Pixel::turns),
               "not turned: rotated(turns) changes no frame, it returns one that is turned by a number of turns");
    explain_if(its == Method::direct && made != 2000, "%zu processes for 2000 pixels; every pixel has its own", made);
    explain_if(its != Method::direct && made > 0, "%zu new processes for 2000 pixels; take one of shared_rules_", made);
    std::printf("# directions of a rule: %zu\n", pixels[0].placed.rule->size());
    std::printf("# rules made for 2000 pixels: %zu\n", made);
    std::printf("# their up axis is the normal: %s\n", upright ? "yes" : "no");
    std::printf("# turned: %s\n", angle(pixels));
    if (its == Method::direct) std::printf("# drawn first from the pixel's random numbers: %s\n", own ? "yes" : "no");
    if (its != Method::direct) print_choices(pixels, rules);
}

}  // namespace

int main(int argc, char** argv) {
    return call(argc, argv,
                {{"table", table},
                 {"direct", method<Method::direct>},
                 {"single", method<Method::single>},
                 {"rotated", method<Method::rotated>},
                 {"pool", method<Method::pool>}});
}
