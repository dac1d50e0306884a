// Neighbouring pixels share what they see of a known light. On one object the visible fraction f of the sky's light
// (known_light.h) is nearly a plane over a window of 5 x 5 to 9 x 9 pixels:
//     f(u, v) ~ c + a u + b v,   u, v = -r .. r.
// So the pixel in the middle takes c of the plane of least squares in place of its own fraction (Draper & Smith,
// "Applied Regression Analysis", 1998, chapter 1). The n pixels of the window that show the same object err
// independently, and c has about the error of their mean. The plane is also the mean of a Gaussian process with the
// covariance 1 + u u' + v v' and an amplitude without bound (Rasmussen & Williams, 2006, section 2.1).
//
// All pixels have one lattice, turned by the sequence R2 (M. Roberts, "The unreasonable effectiveness of quasirandom
// sequences", 2018): so the directions of neighbours fill each other's gaps, and each stands for a smaller cap. The
// next seed swaps x and y: so two pictures err at other places, and their difference tells how much (prediction.h).
//
// This is a denoiser of first order, as those of Moon et al. (2014) and Bitterli et al. (2016), but of one number: that
// the light is known makes a plane enough. The sun's light is not shared: the edge of its shadow can be as narrow as a
// pixel. So a sun that sends the share s of the light gets 0.8 s of the rays, where it has s / 2 without sharing.
// Weights of a process suit the directions of one pixel. They leave a bias that no neighbour averages away, so equal
// weights are better here.
#pragma once

#include "known_light/known_light.h"

#include <algorithm>

namespace bmc {
// What the pixels of a picture see, row by row: an object, and the visible fraction of the sky's light there.
struct View {
    std::optional<Object> object;
    Color fraction;
};
struct Views {
    int width, height;
    std::vector<View> views = std::vector<View>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));

    View& at(int x, int y) { return views[static_cast<std::size_t>(y * width + x)]; }
    const View& at(int x, int y) const { return views[static_cast<std::size_t>(y * width + x)]; }

    // c, in [0, 1], of the window around a pixel; the pixel's own fraction where the window fixes no plane. Windows
    // grow with the picture: r = 2, from 450 rows on 3, from 600 on 4.
    int reach() const { return std::clamp(height / 150, 2, 4); }
    Color shared_fraction(int x, int y) const;
};

// The views of a picture, each by its own rays: by the first rule that the pixels of the settings share, a lattice with
// equal weights or with those of a process.
Views sky_views(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings);

// The L_o, linear RGB, of a picture's points. Scene and light must outlive it. Throws what the Gaussian processes
// throw.
Shade reflected_shared_light(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings);
}  // namespace bmc
