#include "options.h"

namespace bmc {
namespace {

std::function<std::string()> unless_family(const ModelSettings& settings, CovarianceFamily family) {
    return [&settings, family] {
        if (settings.covariance == family) return std::string();
        return std::string("it belongs to --covariance ") + name_of(family, covariance_names);
    };
}

}  // namespace

ModelOptions::ModelOptions(ModelSettings& s)
    : process{choice_option("covariance", "", covariance_names, s.covariance),
              useless_while(
                  unless_family(s, CovarianceFamily::sobolev),
                  real_option("smoothness", "S", "smoothness of the Sobolev covariance, between 1 and 2 (default 1.5)",
                              s.smoothness, {1.001, 1.999})),
              useless_while(
                  unless_family(s, CovarianceFamily::squared_exponential),
                  real_option("length-scale", "L", "of the squared-exponential covariance, from 0.05 (default 1)",
                              s.length_scale, {0.05, 1e6})),
              real_option("noise", "X",
                          "standard deviation of a sample's error, divided by the amplitude (default 0.01)", s.noise,
                          {0, 1000})},
      known(choice_option("known", "known part of the integrand: ", process_known_names, s.known,
                          ", for sobolev with smoothness 1.5")),
      placement(choice_option("placement", "placement of the directions: ", placement_names, s.placement)),
      seed(seed_option("seed of the random numbers (default 1)", s.seed)) {}

void require_closed_form(const ModelSettings& settings) {
    try {
        settings.make_covariance()->integral_of_z(settings.known);
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

RenderOptions::RenderOptions(RenderSettings& s)
    : ModelOptions(s),
      method(choice_option("method", "", method_names, s.method)),
      samples(count_option("samples", "N", "directions per pixel (default 40)", s.samples, 1000000)),
      pool(useless_while([&s] { return s.method == Method::pool ? "" : "it belongs to --method pool"; },
                         count_option("pool", "K", "Gaussian processes in the pool (default 20)", s.pool, 1000))) {
    const auto no_process = [&s] { return s.method == Method::mc ? "--method mc makes no Gaussian process" : ""; };
    for (Option& option : process) option = useless_while(no_process, option);
    known = useless_while(no_process, known);
}

void require_possible(const RenderSettings& settings) {
    const bool one_lattice = settings.method == Method::mc && is_lattice(settings.placement);
    if (!one_lattice && settings.samples > max_process_samples)
        throw UsageError("--samples: " + std::to_string(settings.samples) + " are too many, at most " +
                         std::to_string(max_process_samples) + " are allowed but for --method mc on a lattice");
    require_closed_form(settings);
}
}  // namespace bmc
