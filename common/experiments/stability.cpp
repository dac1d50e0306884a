#include "experiments/reports.h"

#include "base/progress.h"
#include "quadrature/gaussian_process.h"
#include "quadrature/quadrature.h"

namespace bmc {
constexpr double noises[] = {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 0};

struct Setting {
    const char* set;
    std::size_t samples;
    CovarianceFamily family;
    double parameter;
};

// The sweeps: numbers of samples, covariances, sample sets.
static std::vector<Setting> settings(const std::vector<std::size_t>& sample_counts) {
    constexpr auto sobolev = CovarianceFamily::sobolev, squared_exponential = CovarianceFamily::squared_exponential;
    std::vector<Setting> all;
    for (const std::size_t n : sample_counts) all.push_back({"random", n, sobolev, 1.5});
    for (const double s : {1.001, 1.1, 1.25, 1.75, 1.9, 1.999}) all.push_back({"random", 100, sobolev, s});
    for (const double l : {0.05, 0.2, 1.0, 5.0, 100.0, 1e6}) all.push_back({"random", 100, squared_exponential, l});
    for (const char* const set : {"duplicates", "equator", "pole", "cluster"}) {
        all.push_back({set, 100, sobolev, 1.5});
        all.push_back({set, 100, squared_exponential, 1});
    }
    return all;
}

// A covariance three times as large: its numbers round otherwise, and z is a sum where the third may have a closed
// form.
struct Threefold final : Covariance {
    const Covariance& third;

    explicit Threefold(const Covariance& covariance) : third(covariance) {}
    double k(double squared_chord) const override { return 3 * third.k(squared_chord); }
    double cap_mean(double b) const override { return 3 * third.cap_mean(b); }
    double z(double cosine) const override { return z_by_caps(cosine, 0.125); }
};

// The decimal digits that are right, of the 16 of a double.
static int digits_of(double error) {
    if (!(error > 1e-16)) return 16;
    return static_cast<int>(std::max(0.0, std::floor(-portable::log(error) / portable::log(10))));
}

// n directions. random: uniform; duplicates: half as many, each of them twice; equator: all on the horizon; pole: all
// at the pole; cluster: all within 1e-8 of one direction.
std::vector<Vec3> sample_set(std::string_view name, std::size_t n) {
    Random random(1, n);
    std::vector<Vec3> directions = random_directions(n, random);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 d = directions[i];
        if (name == "duplicates") directions[i] = directions[i / 2 * 2];
        if (name == "equator") directions[i] = normalize({d.x, 0, d.z});
        if (name == "pole") directions[i] = {0, 1, 0};
        if (name == "cluster") directions[i] = normalize(Vec3{0.48, 0.6, 0.64} + 1e-8 * d);
    }
    return directions;
}

// The weights at each of the noises, times this scale: none where the matrix cannot be factored.
static std::vector<std::vector<double>> weights_of(const Covariance& covariance, const std::vector<Vec3>& directions,
                                                   double scale) {
    const std::vector<double> z = z_of(covariance, directions);
    const Matrix q = covariance_matrix(covariance, 0, directions);
    std::vector<std::vector<double>> all;
    for (const double noise : noises) {
        Matrix noisy = q;
        for (std::size_t i = 0; i < z.size(); ++i) noisy(i, i) += scale * noise * (scale * noise);
        try {
            all.push_back(bayesian_weights(Cholesky(std::move(noisy)), z));
        } catch (const NotPositiveDefinite&) {
            all.emplace_back();
        }
    }
    return all;
}

// The largest difference between weights and those of the directions in reverse order, over the largest weight.
static double difference(const std::vector<double>& weights, const std::vector<double>& reversed) {
    if (reversed.empty()) return INFINITY;
    double most = 0, largest = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        most = std::max(most, std::fabs(weights[i] - reversed[weights.size() - 1 - i]));
        largest = std::max(largest, std::fabs(weights[i]));
    }
    return most / largest;
}

// Neither another order of the directions nor their rotation about the up axis must change a weight (covariance.h), nor
// must three times the covariance and the squared noise, but they change every rounding error. The digits that stay the
// same are right: a test compares them with weights of 128 bits.
std::string stability_report(Arguments& arguments) {
    std::vector<std::size_t> sample_counts{1, 2, 10, 100, 1000};  // of the random directions with Sobolev 3/2
    add_sample_list(arguments, sample_counts);
    arguments.take();
    std::string text =
        R"(# Where the arithmetic breaks: of the 16 digits of the weights, the number that stays the same when all
# directions are reversed and rotated about the up axis, covariance and squared noise three times as large, which
# must not change a weight (nan: no factor of the matrix). Then the noise gain, about 1 for Monte Carlo; above 2,
# pictures are usually worse than Monte Carlo's.
#                                                   digits at a noise of               gain at a noise of
# set         samples covariance          parameter     1 0.01 1e-4 1e-6 1e-8 1e-12    0     0.01     1e-6        0
)";
    const std::vector<Setting> all = settings(sample_counts);
    Progress progress("rules", 4 * all.size());
    for (const auto& [set, samples, family, parameter] : all) {
        const auto covariance = make_covariance(family, parameter);
        const std::vector<Vec3> directions = sample_set(set, samples);
        const auto weights = weights_of(*covariance, directions, 1);
        double errors[std::size(noises)] = {};
        for (const double turns : {0.1, 0.3, 0.6, 0.8}) {
            std::vector<Vec3> turned(directions.rbegin(), directions.rend());
            for (Vec3& direction : turned) direction = rotate_around_y(direction, turns);
            const auto reversed = weights_of(Threefold(*covariance), turned, std::sqrt(3));
            for (std::size_t i = 0; i < weights.size(); ++i)
                errors[i] = std::max(errors[i], difference(weights[i], reversed[i]));
            progress.done();
        }
        text += formatted("  %-11s %7zu %-19s %9g ", set, samples, name_of(family, covariance_names), parameter);
        std::string gains;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const bool none = weights[i].empty();
            text += none ? "  nan" : formatted("%5d", digits_of(errors[i]));
            if (i == 1 || i == 3 || i == 6)
                gains += none ? "      nan" : formatted(" %8.3g", noise_gain({directions, weights[i]}));
        }
        text += gains + '\n';
    }
    return text;
}
}  // namespace bmc
