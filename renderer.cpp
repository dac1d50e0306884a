// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "base/portable_math.h"

#include "scene/picture_request.h"

int main(int argc, char** argv) {
    return bmc::run_program("renderer", [&] {
        bmc::Arguments arguments{{argv, argv + argc}, R"(usage: ./renderer [options] > out.ppm
       ./renderer --method direct --samples 20 --size 100 > direct.ppm

Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo. The methods:
  mc       Monte Carlo: random directions for each pixel, all of equal weight
  direct   Bayesian Monte Carlo, with a new Gaussian process for each pixel
  single   one Gaussian process for all pixels, turned to the normal
  rotated  the same, rotated about the normal by a random angle in each pixel
  pool     in each pixel one of several Gaussian processes, rotated by a random angle
)"};
        return bmc::PictureRequest().report(arguments);
    });
}
