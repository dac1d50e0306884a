#include "experiments/reports.h"

#include <algorithm>
#include <cstdio>

namespace {

template <class... Arguments>
std::string line(const char* format, Arguments... arguments) {
    char text[320];
    std::snprintf(text, sizeof text, format, arguments...);
    return text;
}

const char* name_of(Method method) {
    switch (method) {
        case Method::mc: return "mc";
        case Method::direct: return "direct";
        case Method::single: return "single";
        case Method::rotated: return "rotated";
        case Method::pool: return "pool";
    }
    return "";
}

const char* name_of(Placement placement) {
    switch (placement) {
        case Placement::uniform: return "uniform";
        case Placement::fibonacci: return "fibonacci";
        case Placement::cosine: return "cosine";
        case Placement::cosine_fibonacci: return "cosine-fibonacci";
    }
    return "";
}

const char* name_of(KnownPart known) { return known == KnownPart::cosine ? "cosine" : "nothing"; }
const char* name_of(PriorMean mean) { return mean == PriorMean::uniform ? "uniform" : "zero"; }

std::string integral_table(const std::vector<IntegralCost>& rows, bool timed) {
    std::string text =
        line("# samples      mc_rmse     bmc_rmse   mc_samples%s\n",
             timed ? "    draw_us       Q_us  factor_us       z_us weights_us  estim._us    pay_off" : "");
    for (const IntegralCost& row : rows) {
        text +=
            line("%9zu %12.5g %12.5g %12.5g", row.samples, row.mc_error, row.bmc_error, row.equivalent_mc_samples());
        const StageTimes& s = row.seconds;
        if (timed) {
            for (const double seconds : {s.draw, s.covariance, s.factor, s.z, s.weights, s.estimate})
                text += line(" %10.3g", 1e6 * seconds);
            text += line(" %10.3g", row.integrals_to_pay_off());
        }
        text += '\n';
    }
    return text;
}

std::string costly_operation(const std::vector<IntegralCost>& rows) {
    std::string text;
    for (const IntegralCost& row : {rows.front(), rows.back()}) {
        const StageTimes& s = row.seconds;
        const auto [seconds, name] =
            std::max({std::pair(s.draw, "drawing directions"), std::pair(s.covariance, "building Q"),
                      std::pair(s.factor, "factoring Q"), std::pair(s.z, "computing z"),
                      std::pair(s.weights, "solving for the weights")});
        text += line("# The costly operation at N = %zu is %s: %.0f %% of the time to make a rule.\n", row.samples,
                     name, 100 * seconds / s.rule());
    }
    return text;
}

// What to type for the settings of a row.
std::string settings_of(const PictureCost& row) {
    const RenderSettings& s = row.settings;
    return line("--method %s", name_of(s.method)) + (s.method == Method::pool ? line(" --pool %zu", s.pool) : "") +
           line(" --placement %s", name_of(s.placement)) +
           (s.prior.known == KnownPart::cosine ? " --known cosine" : "") +
           (s.prior.mean == PriorMean::uniform ? " --mean uniform" : "") + line(" --samples %zu", s.samples);
}

// The row of classic Monte Carlo on random directions with as many samples.
const PictureCost& classic(const std::vector<PictureCost>& rows, const PictureCost& row) {
    return *std::find_if(rows.begin(), rows.end(), [&](const PictureCost& other) {
        return other.settings.method == Method::mc && other.settings.placement == Placement::uniform &&
               other.settings.samples == row.settings.samples;
    });
}

double squared_ratio(double a, double b) { return a * a / (b * b); }

std::string picture_table(const std::vector<PictureCost>& rows, bool timed) {
    std::string text =
        line("# method  pool placement        known   mean    samples       rmse correlation brightness mc_samples%s\n",
             timed ? "  s/megapixel efficiency" : "");
    for (const PictureCost& row : rows) {
        const RenderSettings& s = row.settings;
        const PictureCost& mc = classic(rows, row);
        const double gain = squared_ratio(mc.rmse, row.rmse);
        text += line("%-8s %5zu %-16s %-7s %-7s %7zu %10.5f %11.4f %10.5f %10.4g", name_of(s.method), s.pool,
                     name_of(s.placement), name_of(s.prior.known), name_of(s.prior.mean), s.samples, row.rmse,
                     row.correlation, row.brightness, static_cast<double>(s.samples) * gain);
        if (timed)
            text += line(" %12.3g %10.3g", row.seconds_per_megapixel,
                         gain * mc.seconds_per_megapixel / row.seconds_per_megapixel);
        text += '\n';
    }
    return text;
}

std::string cheapest_settings(const std::vector<PictureCost>& rows, bool timed) {
    std::string text;
    for (const double target : {0.04, 0.02, 0.01}) {
        const PictureCost* best = nullptr;
        const auto cost = [&](const PictureCost& row) {
            return timed ? row.seconds_per_megapixel : static_cast<double>(row.settings.samples);
        };
        for (const PictureCost& row : rows)
            if (row.rmse <= target && (!best || cost(row) < cost(*best))) best = &row;
        text += line("# RMSE %.2f for the %s: ", target, timed ? "least time" : "fewest samples") +
                (best ? settings_of(*best) : "none of these") + '\n';
    }
    return text;
}

std::string model_name(const ModelRow& row) {
    return line("%s %g with noise %g", row.model.name.c_str(), row.model.parameter, row.noise);
}

std::string model_table(const std::vector<ModelRow>& rows) {
    std::string text =
        "# covariance        parameter  noise       rmse  predicted coverage log_evidence leave_one_out "
        "amplification\n";
    for (const ModelRow& row : rows)
        text += line("%-20s %8g %6g %10.5g %10.5g %8.4f %12.5g %13.5g %13.5g\n", row.model.name.c_str(),
                     row.model.parameter, row.noise, row.rmse, row.predicted, row.coverage, row.log_evidence,
                     row.leave_one_out, row.amplification);
    return text;
}

// The models that the table's columns choose, with the error that each choice brings.
std::string choices(const std::vector<ModelRow>& rows, double mc_rmse) {
    const auto least = [&](auto key) {
        return *std::min_element(rows.begin(), rows.end(),
                                 [&](const ModelRow& a, const ModelRow& b) { return key(a) < key(b); });
    };
    const ModelRow best = least([](const ModelRow& row) { return row.rmse; });
    const ModelRow evident = least([](const ModelRow& row) { return -row.log_evidence; });
    const ModelRow left_out = least([](const ModelRow& row) { return row.leave_one_out; });
    return line("# Monte Carlo on the same sets has RMSE %.5g. In hindsight the best is %s: %.5g.\n", mc_rmse,
                model_name(best).c_str(), best.rmse) +
           line("# Without the truth, the evidence chooses %s: %.5g;\n#   the leave-one-out error chooses %s: %.5g.\n",
                model_name(evident).c_str(), evident.rmse, model_name(left_out).c_str(), left_out.rmse);
}

std::string range_of_errors(const std::vector<ModelRow>& rows, const char* name, double noise) {
    double low = 1e300, high = 0;
    for (const ModelRow& row : rows) {
        if (row.model.name != name || row.noise != noise) continue;
        low = std::min(low, row.rmse);
        high = std::max(high, row.rmse);
    }
    return line("%s with noise %g %.3g to %.3g", name, noise, low, high);
}

std::string stability_line(const StabilityRow& row) {
    const std::string setting = line("%-11s %7zu %-19s %9g %6g ", name_of(row.set), row.samples, row.model.name.c_str(),
                                     row.model.parameter, row.noise);
    if (!row.refusal.empty()) return "# " + setting + row.refusal + '\n';
    return "  " + setting +
           line("%10.3g %8.3f %8.3f %10.2g %12.5g %10.3g\n", row.residuals.condition, row.residuals.factor,
                row.residuals.inverse, row.weight_difference, row.absolute_weights, row.cosine_error);
}

// What noise to choose, from the rows: where nothing is refused, and what is left of 16 digits there.
std::string stability_verdict(const std::vector<StabilityRow>& rows) {
    double factor = 0, inverse = 0;
    for (const StabilityRow& row : rows) {
        factor = std::max(factor, row.residuals.factor);
        inverse = std::max(inverse, row.residuals.inverse);
    }
    std::string text =
        line("# The largest residual ratios are %.2g and %.2g: what is computed is as good as the matrix allows.\n",
             factor, inverse);
    double chosen = 1;
    for (const double noise : {1e-2, 1e-4, 1e-6, 1e-8}) {
        double condition = 0, difference = 0;
        int refused = 0;
        for (const StabilityRow& row : rows) {
            if (row.noise != noise) continue;
            condition = std::max(condition, row.residuals.condition);
            difference = std::max(difference, row.weight_difference);
            refused += !row.refusal.empty();
        }
        text += line(
            "# Noise %g: %d settings are refused, the others have condition numbers up to %.1g and weights that solve "
            "and\n"
            "#   inverse agree on to %.1g.\n",
            noise, refused, condition, difference);
        if (refused == 0 && difference < 1e-6) chosen = noise;
    }
    return text +
           line("# Choose %g: the least noise here with which nothing is refused and every weight has six digits.\n",
                chosen);
}

}  // namespace

std::string error_report(const Integrand& integrand, const std::vector<ErrorRow>& rows) {
    std::string text = "# integral of " + integrand.formula + line(" = %.10f\n", integrand.truth) +
                       "# samples     mc_error    bmc_error bmc_predicted        mc/bmc   mc_samples     se_error\n";
    for (const ErrorRow& row : rows)
        text += line("%9zu %12.5g %12.5g %13.5g %13.5g %12.5g %12.5g\n", row.samples, row.mc_error, row.bmc_error,
                     row.bmc_predicted, row.gain(), row.equivalent_mc_samples(), row.rival_error);
    return text;
}

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

std::string known_report() {
    ErrorSettings settings;
    settings.mc_estimates = settings.bmc_estimates = 100;
    std::string text;
    const Integrand fourth{"cosine-fourth", "f cos(theta), f = cos(theta)^3,",
                           [](Vec3 w) { return w.y * w.y * w.y * w.y; }, 2 * portable::pi / 5};
    for (const Integrand& integrand : {fourth, practice_integrands().back()}) {
        const auto table = [&](Placement placement, Prior prior) {
            settings.placement = placement;
            settings.prior = prior;
            return error_table(integrand, Sobolev(), SquaredExponential(), settings);
        };
        const Prior cosine{KnownPart::cosine, PriorMean::zero};
        const std::vector<ErrorRow> uniform = table(Placement::uniform, {}),
                                    weighted = table(Placement::cosine, cosine);
        const std::vector<ErrorRow> lattice = table(Placement::cosine_fibonacci, cosine);
        text +=
            (text.empty() ? "" : "\n\n") + ("# integral of " + integrand.formula) +
            line(" = %.10f\n", integrand.truth) +
            "# mean absolute errors over 100 estimates: uniform directions with nothing known, cosine-distributed ones "
            "with\n"
            "# cos(theta) known, and the cosine-distributed Fibonacci set\n"
            "# samples   mc_uniform    mc_cosine   bmc_nothing   bmc_cosine bmc_predicted  qmc_lattice  bmc_lattice\n";
        for (std::size_t i = 0; i < uniform.size(); ++i)
            text += line("%9zu %12.5g %12.5g %13.5g %12.5g %13.5g %12.5g %12.5g\n", uniform[i].samples,
                         uniform[i].mc_error, weighted[i].mc_error, uniform[i].bmc_error, weighted[i].bmc_error,
                         weighted[i].bmc_predicted, lattice[i].mc_error, lattice[i].bmc_error);
    }
    return text;
}

std::string tradeoff_report(const EnvironmentMap& environment, int size, bool timed) {
    const std::vector<IntegralCost> integrals = integral_costs(practice_integrands().back(), timed);
    const std::vector<PictureCost> pictures = picture_costs(environment, size, timed);
    return "# What an integral costs: the environment integrand, Sobolev 3/2, noise 0.01; errors are root mean "
           "squares.\n"
           "# mc_samples: samples with which Monte Carlo has the error of Bayesian Monte Carlo.\n" +
           std::string(timed ? "# Measured here: microseconds of each stage, and the integrals after which a rule made "
                               "once has cost\n"
                               "# less time than Monte Carlo at equal error.\n"
                             : "") +
           integral_table(integrals, timed) + (timed ? costly_operation(integrals) : "") +
           "\n\n# What a picture costs: the sphere scene against a dense quadrature, four seeds a row. rmse: linear, "
           "over the\n"
           "# pixels that show an object; correlation: of the errors of neighbouring pixels; brightness: relative "
           "error of\n"
           "# the mean; mc_samples: samples with which mc has this rmse.\n" +
           (timed ? "# Measured here: seconds for a megapixel of objects on one core, and 1 / (rmse^2 seconds) "
                    "relative to mc.\n"
                  : "") +
           picture_table(pictures, timed) + cheapest_settings(pictures, timed);
}

std::string models_report() {
    constexpr std::size_t n = 40, sets = 200;
    const auto table = [&](const std::vector<Integrand>& integrands) {
        std::vector<ModelRow> rows;
        for (const Model& model : compared_models())
            for (const double noise : {1e-3, 1e-2, 1e-1}) rows.push_back(judge(model, noise, integrands, n, sets));
        return rows;
    };
    const std::vector<Integrand> smooth{practice_integrands()[1]}, radiance = scene_integrands();
    const std::vector<ModelRow> smooth_rows = table(smooth), radiance_rows = table(radiance);
    const double mc_rmse = monte_carlo_rmse(radiance, n, sets);
    std::string text =
        "# What cos(theta) requires: 200 random sets of 40 directions.\n" + model_table(smooth_rows) +
        choices(smooth_rows, monte_carlo_rmse(smooth, n, sets)) +
        "\n\n# What a scene requires: incident radiance times cos(theta) at five points, the same sets.\n" +
        model_table(radiance_rows) + choices(radiance_rows, mc_rmse) +
        "\n\n# Is the error bar honest? Fraction of errors within two predicted standard errors on the same radiance.\n"
        "# smoothness samples       rmse  predicted coverage\n";
    constexpr std::size_t counts[] = {20, 40, 80, 160};
    for (const double s : {1.25, 1.5, 1.8})
        for (const std::size_t count : counts) {
            const ModelRow row = judge({"sobolev", s, std::make_shared<Sobolev>(s)}, 1e-2, radiance, count, sets);
            text += line("%12g %7zu %10.5g %10.5g %8.4f\n", s, count, row.rmse, row.predicted, row.coverage);
        }
    return text + "# RMSE on radiance: " + range_of_errors(radiance_rows, "sobolev", 1e-2) + ";\n#   " +
           range_of_errors(radiance_rows, "squared-exponential", 1e-2) + ", " +
           range_of_errors(radiance_rows, "squared-exponential", 1e-1) + line("; Monte Carlo %.3g.\n", mc_rmse);
}

std::string stability_report() {
    const std::vector<StabilityRow> rows = stability_rows();
    std::string text =
        "# Where the arithmetic breaks. factor and inverse: residuals over what backward stable arithmetic leaves "
        "(LAPACK\n"
        "# accepts 30); difference: of the weights by solve and by inverse; a set that double precision cannot tell "
        "from a\n"
        "# singular one is refused, in a comment.\n"
        "# set         samples covariance          parameter  noise  condition   factor  inverse difference      "
        "sum_|w|  cos_error\n";
    for (const StabilityRow& row : rows) text += stability_line(row);
    return text + stability_verdict(rows);
}
