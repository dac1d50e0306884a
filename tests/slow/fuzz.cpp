// libFuzzer: any bytes are a map of radiances, rows of numbers or the options of a command, or an error of one line.
#include "command_line/command_line.h"
#include "experiments/samples.h"
#include "light/environment.h"

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

using namespace bmc;

namespace {

template <class Error, class Read>
void check(const std::string& bytes, Read read) {
    std::istringstream in(bytes);
    try {
        if (!read(in)) std::abort();
    } catch (const Error& error) {
        const std::string text = error.what();
        if (text.empty() || text.find('\n') != std::string::npos) std::abort();
    }
}

// Whether the settings that the words say are allowed.
bool reads_options(std::istream& in) {
    std::vector<std::string> words{"program"};
    for (std::string word; in >> word;) words.emplace_back(word.c_str());  // as far as argv has it
    Arguments arguments{std::move(words), ""};
    std::vector<std::size_t> samples{1};
    ModelSettings settings;
    add_sample_list(arguments, samples);
    add_model_options(arguments, settings);
    arguments.read();
    for (const std::size_t n : samples)
        if (n < 1 || n > 4096) return false;
    return !samples.empty() && settings.smoothness > 1 && settings.smoothness < 2 && settings.noise >= 0 &&
           settings.noise <= 1000;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string text(bytes, bytes + size);
    check<std::runtime_error>(text, [](std::istream& in) {
        const Colour corner = read_radiance_hdr(in).radiance({0, -1, 0});
        return corner.x >= 0 && corner.y >= 0 && corner.z >= 0;
    });
    check<std::runtime_error>(text, [](std::istream& in) {
        const Samples samples = read_samples(in);
        return !samples.directions.empty() &&
               (samples.values.empty() || samples.values.size() == samples.directions.size());
    });
    check<std::invalid_argument>(text, reads_options);
    return 0;
}
