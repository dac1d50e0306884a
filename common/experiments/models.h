// Which model an integrand requires: by the error, which needs the truth, and by the evidence, which does not. And
// whether the standard error that a process predicts is honest.
#pragma once

#include "command_line.h"
#include "experiments/integrands.h"
#include "quadrature/covariance.h"

#include <memory>
#include <string>
#include <vector>

namespace bmc {
struct Model {
    CovarianceFamily family;
    double parameter;
    std::shared_ptr<const Covariance> covariance;

    Model(CovarianceFamily its_family, double its_parameter)
        : family(its_family), parameter(its_parameter), covariance(make_covariance(family, parameter)) {}
};

// Incident luminance times cos(theta), shadows included, at so many points that pixels of the sphere scene show, drawn
// at random.
std::vector<Integrand> scene_integrands(const std::shared_ptr<const EnvironmentMap>& light, std::size_t points);

// A process on one set of samples of one integrand: the error of its estimate, and what it says of it.
struct Verdict {
    double error, predicted;  // of the estimate; the standard error
    double surprise;          // minus the log evidence; 0 for a set of zeros, which says nothing about a model
};

// A model's verdicts on so many fresh uniform sets of n directions, for every integrand on each set. Verdicts i of two
// models come from the same samples.
struct Examined {
    Model model;
    double noise;
    std::vector<Verdict> verdicts;

    double rmse() const;
    double predicted() const;  // root mean square of the predicted standard errors
    double coverage() const;   // fraction of errors within two predicted ones
};
Examined examine(const Model& model, double noise, const std::vector<Integrand>& integrands, std::size_t n,
                 std::size_t sets);

// The RMSE if each set of samples chooses the model with the largest evidence; how often that is a squared-exponential
// one; and the RMSE of the one model whose evidence over all sets is largest.
struct Choice {
    double rmse, smooth, pooled_rmse;
};
Choice choice_by_evidence(const std::vector<Examined>& models);

// Root mean square error of Monte Carlo on the same sets.
double monte_carlo_rmse(const std::vector<Integrand>& integrands, std::size_t n, std::size_t sets);

// What `workbench models` prints.
std::string models_report();
}  // namespace bmc
