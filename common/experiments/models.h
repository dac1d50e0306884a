// Which model an integrand requires: covariance, its parameter and the noise, judged by the error, which needs the
// truth, and by the evidence and the leave-one-out error, which do not.
#pragma once

#include "experiments/command.h"
#include "experiments/integrands.h"
#include "quadrature/covariance.h"

#include <memory>
#include <string>
#include <vector>

// A covariance with the names that a report prints.
struct Model {
    CovarianceFamily family;
    double parameter;
    std::shared_ptr<const Covariance> covariance;

    Model(CovarianceFamily its_family, double its_parameter)
        : family(its_family), parameter(its_parameter), covariance(make_covariance(family, parameter)) {}

    const char* name() const { return name_of(family, covariance_names); }
};

// Sobolev s = 1.1, 1.25, 1.4, 1.5, 1.8; squared-exponential l = 0.25, 0.5, 1, 2.
std::vector<Model> compared_models();

struct ModelRow {
    Model model;
    double noise;
    double rmse;           // of the estimates, over all integrands and sample sets
    double predicted;      // root mean square of the predicted standard errors
    double coverage;       // fraction of errors within two predicted standard errors
    double log_evidence;   // per sample
    double leave_one_out;  // root mean square of the leave-one-out residuals
    double amplification;  // mean of the sum of |w| over 2 pi: what errors in the samples grow by
};

// The model on so many fresh uniform sets of n directions: a row for each group of integrands, over all of them.
std::vector<ModelRow> judge(const Model& model, double noise, const std::vector<std::vector<Integrand>>& groups,
                            std::size_t n, std::size_t sets);

// Root mean square error of Monte Carlo on the same sets.
double monte_carlo_rmse(const std::vector<Integrand>& integrands, std::size_t n, std::size_t sets);

// Mean relative error of Bayesian Monte Carlo, Sobolev 3/2 with noise 0.01, on the sum of the integrands, and its
// standard error.
struct Bias {
    double mean, standard_error;
};
Bias bias_of(const std::vector<Integrand>& integrands, std::size_t n, std::size_t sets);

struct Models {
    std::vector<Option> options() { return {}; }
    std::string report() const;
};
