#include "experiments/reports.h"
#include "quadrature/gaussian_process.h"
#include "test.h"

TEST_CASE("the options of a report take what it has memory and time for") {
    const auto takes = [](std::string (*report)(Arguments&), const std::string& word) {
        try {
            output_of(report, {word, "--help"});
        } catch (const Help&) {
            return true;
        } catch (const std::invalid_argument&) {
        }
        return false;
    };
    for (const bool more : {false, true}) {
        CHECK(takes(belief_discs, more ? "--samples=401" : "--samples=400") != more);
        CHECK(takes(models_report, more ? "--samples=401" : "--samples=400") != more);
        CHECK(takes(rule_report, more ? "--samples=4097" : "--samples=4096") != more);
        CHECK(takes(tradeoff_report, more ? "--size=1025" : "--size=1024") != more);
        CHECK(takes(tradeoff_report, more ? "--size=1" : "--size=2") != more);
        CHECK(takes(error_tables, more ? "--mc-estimates=100001" : "--mc-estimates=100000") != more);
        CHECK(takes(error_tables, more ? "--bmc-estimates=100001" : "--bmc-estimates=100000") != more);
    }
}

// Two samples: Q = [a b; b a], whose inverse and determinant are elementary.
TEST_CASE("the log evidence is the density's logarithm with the best amplitude") {
    const GaussianProcess process(Sobolev(), 0.1, {{0, 1, 0}, {0.6, 0.8, 0}});
    const double a = 8.0 / 3 + 0.01, b = 8.0 / 3 - std::sqrt(0.4), determinant = a * a - b * b;
    const double form = (a * (1 + 9) - 2 * b * 3) / determinant;  // Y = (1, 3)
    CHECK(std::fabs(process.log_evidence({1, 3}) - (-std::log(form / 2) - 0.5 * std::log(determinant))) < 1e-14);
}
