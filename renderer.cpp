// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "numerics/portable_math.h"

#include "scene/picture_request.h"

// The folder common/beyond brings options and pictures that go beyond the practice.
#if __has_include("beyond/request.h")
#include "beyond/request.h"
using Request = bmc::beyond::Request;
#else
using Request = bmc::PictureRequest;
#endif

using namespace bmc;

int main(int argc, char** argv) {
    return run_program("renderer", [&] {
        Request request;
        const auto picture = [&request] {
            request.require_possible();
            return request.file(request.image(load_environment(request.environment, request.settings.threads)));
        };
        return run_command({"", "", request.options(), picture, "out.ppm"},
                           "usage: ./renderer [options] > out.ppm\n"
                           "       ./renderer --method direct --samples 20 --size 100 > direct.ppm\n",
                           argc, argv);
    });
}
