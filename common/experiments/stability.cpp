#include "experiments/stability.h"

#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <cmath>

namespace bmc {
namespace {

constexpr double noises[] = {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 0};

struct Setting {
    SampleSet set;
    std::size_t samples;
    Model model;
};

// The sweeps: samples; covariances; sample sets.
std::vector<Setting> settings() {
    const Model rough(CovarianceFamily::sobolev, 1.5), smooth(CovarianceFamily::squared_exponential, 1);
    std::vector<Setting> all;
    for (const std::size_t n : {1u, 2u, 10u, 100u, 1000u}) all.push_back({SampleSet::random, n, rough});
    for (const double s : {1.001, 1.1, 1.25, 1.75, 1.9, 1.999})
        all.push_back({SampleSet::random, 100, {CovarianceFamily::sobolev, s}});
    for (const double l : {0.05, 0.2, 1.0, 5.0, 100.0, 1e6})
        all.push_back({SampleSet::random, 100, {CovarianceFamily::squared_exponential, l}});
    for (const SampleSet set : {SampleSet::duplicates, SampleSet::equator, SampleSet::pole, SampleSet::cluster})
        for (const Model& model : {rough, smooth}) all.push_back({set, 100, model});
    return all;
}

// The decimal digits that are right, of the 16 of a double.
int digits_of(double error) {
    if (!(error > 1e-16)) return 16;
    return static_cast<int>(std::max(0.0, std::floor(-portable::log(error) / portable::log(10))));
}

// The weights, or none if the covariance matrix is refused.
std::optional<std::vector<double>> weights_of(const std::vector<Vec3>& directions, const Model& model, double noise) {
    try {
        return GaussianProcess(*model.covariance, noise, directions).weights();
    } catch (const NotPositiveDefinite&) {
        return std::nullopt;
    }
}

}  // namespace

std::vector<Vec3> sample_set(SampleSet set, std::size_t n) {
    Random random(1, n);
    std::vector<Vec3> directions = uniform_directions(n, random);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 d = directions[i];
        switch (set) {
            case SampleSet::random: break;
            case SampleSet::duplicates: directions[i] = directions[i / 2 * 2]; break;
            case SampleSet::equator: directions[i] = normalize({d.x, 0, d.z}); break;
            case SampleSet::pole: directions[i] = {0, 1, 0}; break;
            case SampleSet::cluster: directions[i] = normalize(Vec3{0.48, 0.6, 0.64} + 1e-8 * d); break;
        }
    }
    return directions;
}

std::optional<double> weight_error(const std::vector<Vec3>& directions, const Model& model, double noise) {
    const auto weights = weights_of(directions, model, noise);
    if (!weights) return std::nullopt;
    const std::size_t n = weights->size();
    double error = 0, largest = 0;
    for (const double turns : {0.1, 0.3, 0.6, 0.8}) {
        std::vector<Vec3> turned;  // in the reverse order, too
        for (std::size_t i = n; i-- > 0;) turned.push_back(rotate_around_y(directions[i], turns));
        const auto others = weights_of(turned, model, noise);
        if (!others) return INFINITY;
        for (std::size_t i = 0; i < n; ++i) {
            error = std::max(error, std::fabs((*weights)[i] - (*others)[n - 1 - i]));
            largest = std::max(largest, std::fabs((*weights)[i]));
        }
    }
    return error / largest;
}

std::string stability_report() {
    std::string text =
        "# Where the arithmetic breaks: of the 16 digits of the weights, how many stay the same when all directions "
        "are\n"
        "# turned about the up axis, which must not change a weight (-: the factor refuses the matrix), at a noise of\n"
        "# set         samples covariance          parameter     1 0.01 1e-4 1e-6 1e-8 1e-12    0\n";
    std::vector<int> fewest(std::size(noises), 16), refused(std::size(noises));
    for (const auto& [set, samples, model] : settings()) {
        text += formatted("  %-11s %7zu %-19s %9g ", name_of(set, sample_set_names), samples,
                          name_of(model.family, covariance_names), model.parameter);
        for (std::size_t i = 0; i < std::size(noises); ++i) {
            const std::optional<double> error = weight_error(sample_set(set, samples), model, noises[i]);
            text += error ? formatted("%5d", digits_of(*error)) : "    -";
            refused[i] += !error;
            if (error) fewest[i] = std::min(fewest[i], digits_of(*error));
        }
        text += '\n';
    }
    for (const auto& [name, numbers] : {std::pair("refused (-)", refused), {"fewest digits of the others", fewest}}) {
        text += formatted("# %-50s", name);
        for (const int number : numbers) text += formatted("%5d", number);
        text += '\n';
    }
    return text +
           "# In the cluster the squared exponential of two directions rounds to 1. No turning shows that: of the "
           "digits at\n# 1e-6 only 3 are right.\n";
}
}  // namespace bmc
