// The renderer: at every point that the camera sees, the direct light
//     L_o = integral over H of (albedo / pi) L_i(w) cos(theta) dw
// that the environment sends past the other object, by one quadrature rule (Kajiya, "The rendering equation", SIGGRAPH
// 1986, for surfaces that do not emit and without interreflection).
//
// A method is a way to give each pixel its rule. Brouillat, Bouville, Loos, Hansen & Bouatouch, "A Bayesian Monte Carlo
// approach to global illumination" (Computer Graphics Forum 2009), share rules between pixels, as the last three here
// do.
#pragma once

#include "quadrature/quadrature.h"
#include "scene/environment.h"
#include "scene/image.h"
#include "scene/prefiltered_environment.h"
#include "scene/scene.h"

#include <functional>

enum class Method {
    mc,       // classic Monte Carlo: fresh directions for every pixel (a lattice: turned at random)
    direct,   // a fresh Gaussian process on fresh directions for every pixel
    single,   // one Gaussian process for the whole image
    rotated,  // the same, its directions turned at random about the normal in every pixel
    pool      // a random one of several Gaussian processes, turned at random
};
constexpr std::pair<const char*, Method> method_names[] = {{"mc", Method::mc},
                                                           {"direct", Method::direct},
                                                           {"single", Method::single},
                                                           {"rotated", Method::rotated},
                                                           {"pool", Method::pool}};

struct RenderSettings : ModelSettings {
    Method method = Method::pool;
    std::size_t samples = 40;  // directions per pixel
    std::size_t pool = 20;     // Gaussian processes in the pool
    int width = 500, height = 500;
    unsigned threads = 1;  // changes no bit of the image
};

// Called with the fraction of the image that is done, from one thread.
using Progress = std::function<void(double)>;

// The image of linear radiance. Every pixel draws from a random stream of its own.
// Throws what the Gaussian processes throw.
Image render(const Scene& scene, const Light& light, const RenderSettings& settings,
             const Progress& progress = nullptr);
