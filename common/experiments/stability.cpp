#include "experiments/stability.h"

#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace bmc {
namespace {

constexpr double noises[] = {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 0};

std::string setting(const StabilityRow& row) {
    return formatted("%-11s %7zu %-19s %9g ", name_of(row.set, sample_set_names), row.samples,
                     name_of(row.model.family, covariance_names), row.model.parameter);
}

// The decimal digits that are right, of the 16 of a double.
int digits_of(double error) {
    if (!(error > 1e-16)) return 16;
    return static_cast<int>(std::max(0.0, std::floor(-portable::log(error) / portable::log(10))));
}

// A line for each setting, a column for each noise. Rows of one setting follow each other.
std::string digits_table(const std::vector<StabilityRow>& rows) {
    std::string text =
        "# How many of 16 digits of the weights hold, at a noise of\n"
        "# set         samples covariance          parameter     1 0.01 1e-4 1e-6 1e-8 1e-12    0\n";
    for (std::size_t i = 0; i < rows.size();) {
        const std::string name = setting(rows[i]);
        text += "  " + name;
        for (const double noise : noises) {
            if (i == rows.size() || setting(rows[i]) != name || rows[i].noise != noise)
                text += formatted("%5s", "?");
            else if (const StabilityRow& row = rows[i++]; row.refused)
                text += formatted("%5s", "-");
            else
                text += formatted("%5d", digits_of(row.weight_error));
        }
        text += '\n';
    }
    return text +
           "# -: the factor refuses the matrix; ?: not tried. In the cluster the squared exponential of two directions "
           "rounds\n"
           "# to 1. No turning shows that: of the digits at 1e-6 only 3 are right.\n";
}

// Which noise to choose: how many matrices are refused, and how many digits are right.
std::string stability_verdict(const std::vector<StabilityRow>& rows) {
    std::string text = "# The factor accepts these, and less than one digit of their weights is right:\n";
    for (const StabilityRow& row : rows)
        if (!row.refused && !(row.weight_error < 0.1))
            text += "#   " + setting(row) + formatted("noise %g\n", row.noise);
    double chosen = 1;
    for (const double noise : {1e-2, 1e-4, 1e-6, 1e-8}) {
        double condition = 0, error = 0;
        int refused = 0;
        for (const StabilityRow& row : rows) {
            if (row.noise != noise) continue;
            refused += row.refused;
            condition = std::max(condition, row.condition);
            error = std::max(error, row.weight_error);
        }
        text += formatted(
            "# Noise %g: %d settings are refused; the others have condition numbers up to %.1g and weights\n"
            "#   that are wrong by up to %.1g of the largest.\n",
            noise, refused, condition, error);
        if (refused == 0 && error < 1e-6) chosen = noise;
    }
    return text +
           formatted("# %g is the least noise here with which nothing is refused and every weight has six digits.\n",
                     chosen);
}

// A line for each noise.
std::string errors_table(const std::vector<StabilityRow>& rows) {
    std::string text =
        "# Largest errors of the weights over the largest weight, by the factor and by the inverse of Q, inf where "
        "none\n"
        "# has a digit; a matrix that the factor refuses is in a comment.\n"
        "# set         samples covariance          parameter   noise  condition  by_factor by_inverse\n";
    for (const StabilityRow& row : rows) {
        text += (row.refused ? "# " : "  ") + setting(row) + formatted("%7g ", row.noise);
        if (row.refused)
            text += "refused\n";
        else if (row.condition == 0)
            text += formatted("%10s %10.2g %10s\n", "-", row.weight_error, "-");
        else
            text += formatted("%10.3g %10.2g %10.2g\n", row.condition, row.weight_error, row.inverse_error);
    }
    return text;
}

std::vector<double> product(const Matrix& a, const std::vector<double>& x) {
    std::vector<double> b(a.rows());
    for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::inner_product(x.begin(), x.end(), a.row(i), 0.0);
    return b;
}

// The weights of the directions turned and taken in the reverse order, in the order of the directions. They are
// infinite if the covariance matrix is refused.
std::vector<double> turned_weights(const Model& model, double noise, const std::vector<Vec3>& directions,
                                   double turns) {
    std::vector<Vec3> turned;
    for (std::size_t i = directions.size(); i-- > 0;) turned.push_back(rotate_around_y(directions[i], turns));
    try {
        std::vector<double> weights = GaussianProcess(*model.covariance, noise, turned).weights();
        std::reverse(weights.begin(), weights.end());
        return weights;
    } catch (const NotPositiveDefinite&) {
        return std::vector<double>(turned.size(), INFINITY);
    }
}

// The largest difference, over the largest weight.
double difference(const std::vector<double>& weights, const std::vector<double>& others) {
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        error = std::max(error, std::fabs(weights[i] - others[i]));
        largest = std::max(largest, std::fabs(weights[i]));
    }
    return error / largest;
}

// The sweeps: samples and noise; covariance and noise; sample set and noise.
std::vector<StabilityRow> stability_rows() {
    std::vector<StabilityRow> rows;
    const auto add = [&rows](SampleSet set, std::size_t n, const Model& model) {
        for (const double noise : noises)
            if (n <= 1000 || noise == 1e-2 || noise == 1e-4) rows.push_back(examine_stability(set, n, model, noise));
    };
    const Model rough(CovarianceFamily::sobolev, 1.5), smooth(CovarianceFamily::squared_exponential, 1);
    for (const std::size_t n : {1u, 2u, 10u, 100u, 1000u}) add(SampleSet::random, n, rough);
    for (const double s : {1.001, 1.1, 1.25, 1.75, 1.9, 1.999})
        add(SampleSet::random, 100, {CovarianceFamily::sobolev, s});
    for (const double l : {0.05, 0.2, 1.0, 5.0, 100.0, 1e6})
        add(SampleSet::random, 100, {CovarianceFamily::squared_exponential, l});
    for (const SampleSet set : {SampleSet::duplicates, SampleSet::equator, SampleSet::pole, SampleSet::cluster})
        for (const Model& model : {rough, smooth}) add(set, 100, model);
    add(SampleSet::cluster, 4096, rough);
    return rows;
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

StabilityRow examine_stability(SampleSet set, std::size_t n, const Model& model, double noise) {
    const std::vector<Vec3> directions = sample_set(set, n);
    StabilityRow row{set, n, model, noise};
    std::optional<GaussianProcess> process;
    try {
        process.emplace(*model.covariance, noise, directions);
    } catch (const NotPositiveDefinite&) {
        row.refused = true;
        return row;
    }
    std::vector<double> by_inverse = process->weights();
    if (n <= 1000) {
        const Matrix inverse = process->inverse_covariance();
        row.condition =
            row_sum_norm(symmetric(covariance_matrix(*model.covariance, noise, directions))) * row_sum_norm(inverse);
        by_inverse = product(inverse, process->z());
    }
    for (const double turns : {0.1, 0.3, 0.6, 0.8}) {
        const std::vector<double> turned = turned_weights(model, noise, directions, turns);
        row.weight_error = std::max(row.weight_error, difference(process->weights(), turned));
        row.inverse_error = std::max(row.inverse_error, difference(by_inverse, turned));
    }
    return row;
}

std::vector<Option> Stability::options() {
    return {{"all", "", "also every setting by itself", [this](const std::string&) { all = true; }}};
}

std::string Stability::report() const {
    const std::vector<StabilityRow> rows = stability_rows();
    const std::string text =
        "# Where the arithmetic breaks: the digits of the weights that stay the same when all directions are turned "
        "about\n"
        "# the up axis, which must not change a weight.\n" +
        digits_table(rows) + stability_verdict(rows);
    return all ? text + "\n\n" + errors_table(rows) : text;
}
}  // namespace bmc
