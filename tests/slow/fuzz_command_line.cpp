// libFuzzer: any words, one a line, are a request that the programs can carry out, or a UsageError.
#include "numerics/portable_math.h"

#include "command_line.h"
#include "experiments/error_table.h"
#include "experiments/models.h"
#include "experiments/rule.h"
#include "experiments/stability.h"
#include "experiments/tradeoff.h"
#include "light/desert.h"
#include "light/radiance_hdr.h"
#include "numerics/plain_loops.h"
#include "prediction.h"

#include <getopt.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>

using namespace bmc;

// Whatever the programs include is included above: inside a namespace nothing may be included for the first time.
namespace renderer_program {
#include "../../renderer.cpp"
}
namespace workbench_program {
#include "../../workbench.cpp"
}

namespace {

void require(bool condition) {
    if (!condition) std::abort();
}

void check(const ModelSettings& model) {
    require(model.smoothness > 1 && model.smoothness < 2);
    require(model.length_scale > 0 && model.length_scale <= 1e6);
    require(model.noise >= 0 && model.noise <= 1000);
}

void check(const renderer_program::Request& request) {
    const PictureSettings& settings = request.settings;
    require(settings.samples >= 1 && settings.pool >= 1 && settings.threads >= 1);
    require(settings.width >= 1 && settings.width <= 8192);
    require(settings.height >= 1 && settings.height <= 8192);
    check(static_cast<const ModelSettings&>(settings));
}

// The workbench's own options are in its commands.
void check(const workbench_program::Request& request) { require(request.command.report != nullptr); }

void check(const ErrorTables& tables) {
    const ErrorSettings& settings = tables.settings;
    require(!settings.samples.empty() && settings.samples.size() <= 1000);
    for (const std::size_t n : settings.samples) require(n >= 1 && n <= 4096);
    require(settings.mc_estimates >= 1 && settings.bmc_estimates >= 1);
    check(static_cast<const ModelSettings&>(settings));
}

void check(const Rule& rule) {
    require(rule.samples >= 1 && rule.samples <= 4096);
    check(rule.settings);
}

void check(const Tradeoff& tradeoff) { require(tradeoff.costs.size >= 2 && tradeoff.costs.size <= 1024); }

template <class Parse>
void parse(Parse parse_words, std::vector<std::string> words) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    optind = 0;  // a fresh scan
    try {
        const auto request = parse_words(static_cast<int>(words.size()), argv.data());
        check(request);
    } catch (const UsageError& error) {
        require(error.what()[0] != '\0');
    }
}

template <class Experiment>
Experiment parse_experiment(int argc, char** argv) {
    Experiment experiment;
    parse_options(argc, argv, experiment.options());
    return experiment;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    std::vector<std::string> words{"program", ""};
    for (std::size_t i = 0; i < size; ++i) {
        if (bytes[i] == '\n' || bytes[i] == '\0')
            words.emplace_back();
        else
            words.back() += static_cast<char>(bytes[i]);
    }
    if (words.back().empty()) words.pop_back();  // a last line ends with its line break
    parse(renderer_program::parse, words);
    parse(workbench_program::parse, words);
    parse(parse_experiment<ErrorTables>, words);
    parse(parse_experiment<Rule>, words);
    parse(parse_experiment<Tradeoff>, words);
    return 0;
}
