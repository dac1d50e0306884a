#include "experiments/reports.h"
#include "test.h"

TEST_CASE("the options of a report take what it has memory and time for") {
    for (const auto& [report, option, least, most] : {std::tuple(&belief_discs, "--samples=", 1, 400),
                                                      {models_report, "--samples=", 1, 400},
                                                      {rule_report, "--samples=", 1, 4096},
                                                      {tradeoff_report, "--size=", 2, 1024},
                                                      {error_tables, "--mc-estimates=", 1, 100000},
                                                      {error_tables, "--bmc-estimates=", 1, 100000}})
        for (const int number : {least - 1, least, most, most + 1}) {
            const std::vector<std::string> words{option + std::to_string(number), "--help"};
            CAPTURE(words);
            if (least <= number && number <= most)
                CHECK_THROWS_AS(output_of(report, words), Help);
            else
                CHECK_THROWS_AS(output_of(report, words), std::invalid_argument);
        }
}
