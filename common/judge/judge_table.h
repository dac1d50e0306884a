// Whether an error table by another program is what a correct one prints: every cell beside what the mean of so many
// absolute errors is expected to be, and how much such a mean spreads.
#pragma once

#include "experiments/integrands.h"
#include "scene/input.h"

#include <string>
#include <vector>

struct Cell {
    double here, expected;
    double spread;  // relative standard deviation of correct cells

    double ratio() const;
};

// The cells of one column, from the top.
struct Column {
    std::string name;
    std::size_t estimates;  // that each cell is the mean of
    std::vector<Cell> cells;

    // And how far that of a correct column may be from 1, as a factor.
    double mean_ratio() const;
    double accepted_factor() const;

    // Root mean square of the cells' deviations, in spreads: about 1 for correct cells; and the most that is accepted.
    double scatter() const;
    double accepted_scatter() const;

    bool fits() const;
};

struct TableJudgement {
    std::vector<std::size_t> samples;
    Column mc, bmc;
    double truth;  // the integral

    bool fits() const { return mc.fits() && bmc.fits(); }
};

// The rows "samples, error of Monte Carlo, error of Bayesian Monte Carlo", whatever follows in them, as means of 100
// and of 10 estimates. Throws std::runtime_error that names the line for other rows.
TableJudgement judge_table(const std::vector<InputRow>& rows, const Integrand& integrand,
                           const ModelSettings& settings);

std::string table_report(const TableJudgement& judgement);
