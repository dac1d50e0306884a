#include "judge/judge_table.h"

#include <algorithm>
#include <cmath>

#include "command_line.h"
#include "experiments/statistics.h"
#include "judge/likely_mistakes.h"

namespace {

constexpr std::size_t most_samples = 1000;

constexpr double least_spread = 0.02;  // of correct programs' conventions and of the digits that a table prints
constexpr double rounding = 1e-6;      // what a correct estimate may differ from an error of 0 by

std::size_t samples_of(const InputRow& row) {
    if (row.numbers.size() < 3)
        fail(row.line, "a row should be samples, error of Monte Carlo, error of Bayesian Monte Carlo");
    const double n = row.numbers[0];
    if (!(n >= 1 && n <= static_cast<double>(most_samples) && n == std::floor(n)))
        fail(row.line, line("%g samples; a whole number from 1 to %zu can be judged", n, most_samples));
    return static_cast<std::size_t>(n);
}

// A cell is a mean of so many absolute errors, and so is what is expected of it, of others.
Cell cell(double here, const Statistics& errors, std::size_t estimates) {
    if (errors.mean < rounding) return {here, 0, least_spread};
    const double share = 1 / static_cast<double>(estimates) + 1 / errors.count;
    return {here, errors.mean, std::max(least_spread, errors.deviation() / errors.mean * std::sqrt(share))};
}

// What makes of correct cells what these are, or an empty text.
std::string likely_mistake(const Column& column, double truth) {
    const double ratio = column.mean_ratio(), tolerance = column.accepted_factor() - 1;
    if (std::any_of(column.cells.begin(), column.cells.end(), [](const Cell& c) { return c.here < 0; }))
        return "an error is negative: absolute values are asked for";
    if (std::fabs(ratio - 1) <= tolerance)
        return line("errors scatter more than means of %zu do: fewer estimates, or one set of directions for all",
                    column.estimates);
    Column scaled = column;
    for (Cell& c : scaled.cells) c.here /= ratio;
    if (!(ratio > 0) || !scaled.fits()) return "";
    std::string name = line("all are about %.2g times the expected", ratio);
    if (std::fabs(ratio * truth - 1) <= tolerance) name += ": relative to the integral";
    for (const std::string& known :
         {factor_name(ratio, factors, tolerance), factor_name(ratio, factors_of_means, tolerance)})
        if (!known.empty()) name += ": " + known;
    return name;
}

bool fits_if_exchanged(const TableJudgement& judgement) {
    Column mc = judgement.mc, bmc = judgement.bmc;
    for (std::size_t i = 0; i < mc.cells.size(); ++i) std::swap(mc.cells[i].here, bmc.cells[i].here);
    return mc.fits() && bmc.fits();
}

std::string column_report(const Column& column, double truth) {
    const double factor = column.accepted_factor();
    const std::string text =
        line("# %s: mean ratio %.4g, accepted from %.4g to %.4g; scatter %.4g spreads, accepted to %.4g.\n",
             column.name.c_str(), column.mean_ratio(), 1 / factor, factor, column.scatter(), column.accepted_scatter());
    const std::string mistake = column.fits() ? "" : likely_mistake(column, truth);
    return text + (mistake.empty() ? "" : "#   Likely: " + mistake + ".\n");
}

}  // namespace

double Cell::ratio() const {
    if (expected > 0) return here / expected;
    return std::fabs(here) <= rounding ? 1 : HUGE_VAL;
}

double Column::mean_ratio() const {
    double sum = 0;
    for (const Cell& c : cells) sum += c.ratio();
    return sum / static_cast<double>(cells.size());
}

// Four standard deviations of the mean, on the logarithmic scale.
double Column::accepted_factor() const {
    double variance = 0;
    for (const Cell& c : cells) variance += c.spread * c.spread;
    return portable::exp(4 * std::sqrt(variance) / static_cast<double>(cells.size()));
}

// The cube root of a mean of positive numbers is about normal, its relative spread a third of the mean's (Wilson &
// Hilferty, "The distribution of chi-square", PNAS 1931).
double Column::scatter() const {
    double sum = 0;
    for (const Cell& c : cells) {
        const double deviation = 3 * (portable::pow(std::max(c.ratio(), 0.0), 1.0 / 3) - 1) / c.spread;
        sum += deviation * deviation;
    }
    return std::sqrt(sum / static_cast<double>(cells.size()));
}

// A sum of n squares of normal variables exceeds n + 2 sqrt(n t) + 2 t with a probability of at most e^-t (Laurent &
// Massart, "Adaptive estimation of a quadratic functional", Annals of Statistics 2000, lemma 1); t = 7.
double Column::accepted_scatter() const {
    const double n = static_cast<double>(cells.size());
    return std::sqrt(1 + 2 * std::sqrt(7 / n) + 14 / n);
}

bool Column::fits() const {
    const double factor = accepted_factor(), ratio = mean_ratio();
    return ratio <= factor && ratio >= 1 / factor && scatter() <= accepted_scatter();
}

TableJudgement judge_table(const std::vector<InputRow>& rows, const Integrand& integrand,
                           const ModelSettings& settings) {
    TableJudgement judgement{{}, {"MC", 100, {}}, {"BMC", 10, {}}, integrand.truth};
    ModelSettings others = settings;
    others.seed = 1000000;
    const std::unique_ptr<Covariance> covariance = settings.make_covariance();
    for (const InputRow& row : rows) {
        const std::size_t n = samples_of(row);
        if (std::count(judgement.samples.begin(), judgement.samples.end(), n) > 0)
            fail(row.line, line("%zu samples a second time; leave one table in the file", n));
        judgement.samples.push_back(n);
        // Few where Q is large: the time grows as n^3.
        const std::size_t estimates = std::clamp<std::size_t>(100000 / n, 100, 1000);
        Statistics mc, bmc;
        for (std::size_t e = 0; e < estimates; ++e) {
            const DirectionSet set = estimate_directions(others, n, e);
            const QuadratureRule rule = bayesian_rule(*covariance, settings.noise, set.directions, settings.known);
            mc.add(std::fabs(apply(monte_carlo_rule(set), integrand) - integrand.truth));
            bmc.add(std::fabs(apply(rule, integrand) - integrand.truth));
        }
        judgement.mc.cells.push_back(cell(row.numbers[1], mc, judgement.mc.estimates));
        judgement.bmc.cells.push_back(cell(row.numbers[2], bmc, judgement.bmc.estimates));
    }
    return judgement;
}

std::string table_report(const TableJudgement& judgement) {
    std::string text =
        "# samples     mc_error     expected    ratio   spread    bmc_error     expected    ratio   spread\n";
    for (std::size_t i = 0; i < judgement.samples.size(); ++i) {
        text += line("%9zu", judgement.samples[i]);
        for (const Cell& c : {judgement.mc.cells[i], judgement.bmc.cells[i]})
            text += line(" %12.5g %12.5g %8.3f %8.3f", c.here, c.expected, c.ratio(), c.spread);
        text += '\n';
    }
    text += column_report(judgement.mc, judgement.truth) + column_report(judgement.bmc, judgement.truth);
    if (!judgement.fits() && fits_if_exchanged(judgement)) text += "#   Likely: the columns are exchanged.\n";
    if (judgement.fits()) return text + "# Verdict: within what correct programs do.\n";
    const char* const outside = judgement.mc.fits() ? "BMC" : judgement.bmc.fits() ? "MC" : "MC and BMC";
    return text + "# Verdict: not what correct programs do, by " + outside + ".\n";
}
