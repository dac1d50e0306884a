#include "experiments/known.h"

#include "experiments/error_table.h"

std::string Known::report() const {
    ErrorSettings settings;
    settings.mc_estimates = settings.bmc_estimates = 100;
    std::string text;
    const Integrand fourth{"cosine-fourth", "f cos(theta), f = cos(theta)^3,",
                           [](Vec3 w) { return w.y * w.y * w.y * w.y; }, 2 * portable::pi / 5};
    for (const Integrand& integrand : {fourth, practice_integrands().back()}) {
        const auto table = [&](Placement placement, Prior prior) {
            settings.placement = placement;
            settings.prior = prior;
            return error_table(integrand, settings);
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
