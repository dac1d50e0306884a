// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "numerics/portable_math.h"

#include "command_line/options.h"

// The folder common/beyond brings options and pictures that go beyond the practice.
#if __has_include("beyond/picture_request.h")
#include "beyond/picture_request.h"
using Request = bmc::beyond::PictureRequest;
#else
using Request = bmc::PictureRequest;
#endif

using namespace bmc;

namespace {

// What to print. Throws UsageError.
std::string run(int argc, char** argv) {
    Request request;
    bool help = false;
    Options options = request.options();
    options.push_back({"help", "", "prints this text", [&](const std::string&) { help = true; }});
    const std::vector<std::string> rest = parse_options(argc, argv, options);
    if (help)
        return "usage: ./renderer [options] > out.ppm\n\n"
               "Renders the sphere scene by Monte Carlo or Bayesian Monte Carlo integration.\n\n" +
               describe(options) +
               "\nexamples: ./renderer --method mc > mc.ppm\n"
               "          ./renderer --method direct --samples 20 --size 100 > direct.ppm\n";
    if (!rest.empty())
        throw UsageError("'" + rest[0] + "' is no option; type ./renderer --help, or ./renderer > out.ppm");
    request.require_possible();
    require_file_output("./renderer > out.ppm");
    return request.file(request.image(load_environment(request.environment, request.settings.threads)));
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("renderer", [&] { return run(argc, argv); });
}
