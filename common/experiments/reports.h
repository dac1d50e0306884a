// The workbench's reports as text: whitespace-separated columns under lines that begin with '#', so that gnuplot, awk
// and numpy.loadtxt read them as they are. Each ends in the sentences that it was made for.
#pragma once

#include "numerics/portable_math.h"

#include <string>
#include <vector>

#include "experiments/error_table.h"
#include "experiments/models.h"
#include "experiments/stability.h"
#include "experiments/tradeoff.h"
#include "quadrature/quadrature.h"

// The error table of one integrand.
std::string error_report(const Integrand& integrand, const std::vector<ErrorRow>& rows);

// A rule: its directions and weights, for whoever wants to plot or to reuse them, and how well it integrates the one
// integrand that every rule should.
std::string rule_report(const QuadratureRule& rule);

// What it is worth to know that the integrand has a factor cos(theta): Monte Carlo and Bayesian Monte Carlo, without
// and with it.
std::string known_report();

// What accuracy costs, for the environment integrand and for the sphere scene in size x size pixels. Seconds, and what
// follows from them, only if timed; they are measured and differ from run to run, everything else does not.
std::string tradeoff_report(const EnvironmentMap& environment, int size, bool timed);

// Which model an integrand requires.
std::string models_report();

// Where the arithmetic breaks.
std::string stability_report();
