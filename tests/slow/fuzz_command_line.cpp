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

// What is parsed from the words, and then used, is a request or a usage error.
template <class Use>
void parse(std::vector<std::string> words, Use use) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    optind = 0;  // a fresh scan
    try {
        use(static_cast<int>(words.size()), argv.data());
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
    parse(words, [](int argc, char** argv) {
        const PictureSettings settings = renderer_program::parse(argc, argv).settings;
        require(settings.samples >= 1 && settings.pool >= 1 && settings.threads >= 1);
        require(settings.width >= 1 && settings.width <= 8192 && settings.height >= 1 && settings.height <= 8192);
        check(settings);
    });
    parse(words, [](int argc, char** argv) { require(workbench_program::parse(argc, argv) != nullptr); });
    parse(words, [](int argc, char** argv) {
        const ErrorSettings settings = parse_experiment<ErrorTables>(argc, argv).settings;
        for (const std::size_t n : settings.samples) require(n >= 1 && n <= 4096);
        require(!settings.samples.empty() && settings.mc_estimates >= 1 && settings.bmc_estimates >= 1);
        check(settings);
    });
    parse(words, [](int argc, char** argv) { check(parse_experiment<Rule>(argc, argv).settings); });
    parse(words, [](int argc, char** argv) {
        const int size = parse_experiment<Tradeoff>(argc, argv).costs.size;
        require(size >= 2 && size <= 1024);
    });
    return 0;
}
