#include "experiments/reports.h"
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
