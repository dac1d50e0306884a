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

int main(int argc, char** argv) {
    return bmc::run_program("renderer", [&] {
        return bmc::run_command({"", "", std::make_shared<Request>(), "out.ppm"},
                                "usage: ./renderer [options] > out.ppm\n"
                                "       ./renderer --method direct --samples 20 --size 100 > direct.ppm\n",
                                argc, argv);
    });
}
