// alone_rules TASK: what the function of the task table, direct, single, rotated or pool does where rules are made and
// applied by the stand-ins below, whose numbers tell which directions were taken, and in which order.
#include "alone.h"

#include "experiments/error_table.h"
#include "numerics/formatted.h"
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
    std::vector<double> mc, bmc, mc_estimates, bmc_estimates, predicted, amplitudes;
    double noise = 0, covariance = 0;
} taken;

}  // namespace

DirectionSet bmc::place_directions(Placement placement, std::size_t n, Random& random) {
    DirectionSet set{placement, {}};
    if (n == 0) throw std::invalid_argument("a set of 0 directions is asked for");
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
    taken.amplitudes.push_back(integrand_of(directions_[0]) / 3 + 2);
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
    explain_if(sets.size() > wanted, "%s takes %zu sets of directions, the settings say %zu estimates", method,
               sets.size(), wanted);
    explain_if(!sets.empty() && numbers.substr(0, right.size()) != right.substr(0, numbers.size()),
               "%s takes the directions of the estimates%.40s (?: none of these), not%s", method, numbers.c_str(),
               right.c_str());
    explain_if(!sets.empty() && sets.size() != wanted,
               "%s takes %zu sets of directions, the settings say %zu estimates", method, sets.size(), wanted);
}

// A number in a row of a table, and the estimates of which it is the mean error; or standard errors, which have the
// truth 0; beside the number of the other method's estimates.
Case mean_error(std::vector<double> values, double truth, double n, double other) {
    if (values.empty()) values = {NAN};  // nothing that is known
    std::vector<double> errors;
    double size = 0, bias = 0, squares = 0, amplitude = 0;
    const double count = static_cast<double>(values.size());
    for (const double value : values) {
        errors.push_back(std::fabs(value - truth));
        squares += errors.back() * errors.back() / count, size += errors.back(), bias += (value - truth) / count;
    }
    for (const double each : taken.amplitudes) amplitude += each / static_cast<double>(taken.amplitudes.size());
    return mistakes(
        errors,
        {{{size}, " is a sum; it should be a mean"},
         {{size / other}, " is divided by the number of the other method's estimates"},
         {{size / count / truth}, " is divided by the truth"},
         {{std::sqrt(squares)}, " is the root of a mean of squares"},
         {{bias + 2 * truth}, " has the truth added; it is to be subtracted"},
         {{bias + truth}, " has a mean of estimates: the truth is not subtracted"},
         {{bias, -bias, std::fabs(bias)}, " is a mean without absolute values, or the absolute value of a mean"},
         {{0.3, std::sqrt(0.3), amplitude, 0.3 * amplitude, std::sqrt(0.3) * amplitude},
          " is made of the variance or the amplitude of the process; standard_error(values) gives the error"}},
        {{"n", n}, {"the number of estimates", count}, {"the other method's number of estimates", other}}, 1 / count);
}

void table() {
    function = "error_row";
    numbered = false;
    ErrorSettings settings;
    settings.covariance = CovarianceFamily::squared_exponential;
    settings.noise = 0.25;
    settings.seed = 7;
    const Integrand integrand{"", "", integrand_of, 112};
    Trial mc, bmc, predicted;
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
            mc.add(row.mc_error, mean_error(taken.mc_estimates, integrand.truth, samples, bmcs));
            bmc.add(row.bmc_error, mean_error(taken.bmc_estimates, integrand.truth, samples, mcs));
            predicted.add(row.bmc_predicted, mean_error(taken.predicted, 0, samples, mcs));
        }
    }
    mc.passes("mc_error");
    bmc.passes("bmc_error");
    predicted.passes("bmc_predicted");
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
    std::vector<double> numbers;
    const PlacedRule placed;
    Vec3 normal;

    double u() const { return numbers[0]; }
    double turns() const { return numbers[1]; }

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

// Whether every direction of every pixel was turned by so much.
template <class Turns>
bool all_turned(const std::vector<Pixel>& pixels, Turns turns) {
    for (const Pixel& pixel : pixels)
        for (std::size_t i = 0; i < pixel.placed.rule->size(); ++i) {
            const double apart = pixel.turned(i) - turns(pixel);
            if (!(std::fabs(apart - std::floor(apart + 0.5)) < 1e-3)) return false;
        }
    return true;
}
bool none_turned(const std::vector<Pixel>& pixels) {
    return all_turned(pixels, [](const Pixel&) { return 0; });
}

std::string angle_of(const std::vector<Pixel>& pixels) {
    if (none_turned(pixels)) return "not turned";
    if (!all_turned(pixels, [](const Pixel& pixel) { return pixel.turned(0); }))
        return "directions by different angles";
    const std::pair<double, const char*> factors[] = {{1, "by the pixel's turns"},
                                                      {-1, "by the turns, but the other way round"},
                                                      {2, "twice as far"},
                                                      {2 * pi, "by 2 pi as much: turns are no radians"},
                                                      {360, "by 360 times as much: turns are no degrees"}};
    for (const auto& [factor, words] : factors)
        if (all_turned(pixels, [its = factor](const Pixel& pixel) { return its * pixel.turns(); })) return words;
    for (std::size_t k = 0; k < pixels[0].numbers.size(); ++k)
        if (all_turned(pixels, [=](const Pixel& pixel) { return pixel.numbers[k]; }))
            return k == 0 ? "by u, which chooses the rule; turns is the angle"
                          : formatted("by the pixel's random number %zu", k + 1);
    const double first = pixels[0].turned(0), more = first - pixels[0].turns();
    if (all_turned(pixels, [=](const Pixel&) { return first; }))
        return formatted("by a fixed angle, %.3g turns", first);
    if (all_turned(pixels, [=](const Pixel& pixel) { return pixel.turns() + more; }))
        return formatted("by the turns and %.3g turns besides", more);
    return "by another angle";
}

void print_choices(const std::vector<Pixel>& pixels, const PixelRules& rules) {
    std::map<double, std::size_t> numbers;
    for (const auto& shared : rules.shared()) numbers.emplace(shared.weights.at(0), numbers.size());
    Trial choices;
    for (const Pixel& pixel : pixels) {
        const double u = pixel.u(), i = static_cast<double>(choices.given.size());
        const auto number = numbers.find(pixel.placed.rule->weights.at(0));
        if (number == numbers.end() || pixel.placed.rule->y[0] != rules.shared()[number->second].y[0])
            throw std::runtime_error("the rule is none of shared_rules_");
        choices.add(static_cast<double>(number->second),
                    mistakes(std::floor(7 * u),
                             {{{std::floor(7 * pixel.turns())}, "turns chooses the rule; u is for that"},
                              {{0, 6}, " is 0, or size - 1, whatever u"},
                              {{std::floor(6 * u)}, "u is multiplied by size - 1, so the last is never chosen"},
                              {{std::floor(6 * u + 0.5), std::ceil(6 * u), std::min(6.0, std::floor(7 * u + 0.5))},
                               "u size is to be cut off, not rounded, nor is u (size - 1)"},
                              {{6 - std::floor(7 * u)}, "the rules are counted from the end"},
                              {{std::min(6.0, std::floor(20 * u)), std::fmod(std::floor(20 * u), 7),
                                std::fmod(std::floor(100 * u), 7)},
                               "u is multiplied by another number than size()"},
                              {{std::fmod(i, 7)}, "the rules take turns: a counter chooses; u is for that"}}));
    }
    const bool right = numbers.size() == 1 || choices.passes("the number of the rule");
    std::printf("# as u chooses them: %s\n", right ? "all rules" : "not all rules");
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
    for (const auto& [name, method] : method_names)
        if (method == its) function = name;
    settings.samples = 3;
    settings.pool = 7;
    const PixelRules rules(settings);
    const std::size_t shared = rules_made;
    std::vector<Pixel> pixels;
    bool upright = true, above = true, world = true, same = true;
    std::vector<bool> drawn(6, true);
    for (std::size_t i = 0; i < 2000; ++i) {
        Random random(3, i), again(3, i);
        std::vector<double> numbers;
        while (numbers.size() < drawn.size()) numbers.push_back(again.uniform());
        const Vec3 normal = normalize({std::sin(static_cast<double>(i)), 2 * numbers[0] - 1, numbers[1] - 0.5});
        pixels.push_back({numbers, rules.rule_for(normal, random), normal});
        const Pixel& pixel = pixels.back();
        if (!pixel.placed.rule) throw std::runtime_error("a pixel has no rule");
        const CosineRule& rule = *pixel.placed.rule;
        for (std::size_t j = 0; j < rule.size(); ++j) {
            const bool so = std::fabs(pixel.local(j).y - static_cast<double>(rule.y[j])) < 1e-3;
            upright = upright && so, above = above && (so || normal.y < 0);
        }
        world = world && squared_distance(pixel.placed.frame.normal, pixels[0].placed.frame.normal) < 1e-9;
        for (std::size_t k = 0; k < drawn.size(); ++k)
            drawn[k] = drawn[k] && std::fabs(static_cast<double>(rule.y[0]) - numbers[k]) < 1e-3;
        same = same && rule.y[0] == pixels[0].placed.rule->y[0];
    }
    const std::size_t made = rules_made - shared;
    explain_if(world, "the frame has the same up axis for all pixels; Frame(normal) is aligned with the normal");
    explain_if(!upright && above,
               "the frame's up axis is not the normal where that points down; Frame(normal) aligns it");
    explain_if(!upright, "the frame's up axis is not the normal; Frame(normal) aligns it");
    explain_if((its == Method::rotated || its == Method::pool) && none_turned(pixels),
               "not turned: rotated(turns) changes no frame, it returns one that is turned by a number of turns");
    explain_if(its == Method::direct && made != 2000, "%zu processes for 2000 pixels; every pixel has its own", made);
    explain_if(its != Method::direct && made > 0, "%zu new processes for 2000 pixels; take one of shared_rules_", made);
    std::printf("# directions of a rule: %zu\n", pixels[0].placed.rule->size());
    std::printf("# rules made for 2000 pixels: %zu\n", made);
    std::printf("# their up axis is the normal: %s\n", upright ? "yes" : "no");
    std::printf("# turned: %s\n", angle_of(pixels).c_str());
    if (its == Method::direct) {
        std::printf("# drawn first from the pixel's random numbers: %s\n", drawn[0] ? "yes" : "no");
        explain_if(
            same, "all pixels have the same directions; fresh_rule(random) takes them from the pixel's random numbers");
        for (std::size_t k = 1; k < drawn.size(); ++k)
            explain_if(drawn[k], "%zu of the pixel's random numbers are drawn before its directions are", k);
        explain_if(
            !drawn[0],
            "its directions are not those of fresh_rule(random): made in another way, or of other random numbers");
    }
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
