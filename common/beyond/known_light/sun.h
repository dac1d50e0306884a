// The sun of an environment map: its texels of more than a hundred times the mean radiance. A rule's directions almost
// never meet them, so they have rays of their own: each kind of light is sampled in the way that suits it (Veach &
// Guibas, "Optimally combining sampling techniques for Monte Carlo rendering", SIGGRAPH 1995).
#pragma once

#include "light/environment.h"
#include "numerics/random.h"
#include "scene/scene.h"

namespace bmc::beyond {
// Sums over rays: of all light, and of what arrives.
struct RatioEstimator {
    Color all, visible;

    void add(Color light, bool arrives) {
        all += light;
        if (arrives) visible += light;
    }

    Color fraction() const;  // in [0, 1]; 1 for a colour that no ray carries
};

class Sun {
public:
    // The texels of more than `threshold` times the mean.
    explicit Sun(const EnvironmentMap& map, double threshold = 100);

    bool empty() const { return texels_.empty(); }

    // The integral of its R + G + B over all directions, and the ratio to that of the whole map.
    double light() const { return empty() ? 0 : texels_.back().light; }
    double share() const { return empty() ? 0 : light() / all_; }

    // The irradiance of a unit normal if nothing is in the way, by 256 rays.
    Color irradiance(Vec3 normal) const;

    // The map without the sun.
    EnvironmentMap sky() const;

    // The colour is the radiance there over its R + G + B.
    struct Ray {
        Vec3 direction;
        Color colour;
    };

    // The ray at which the fraction u in [0, 1) of the sun's light has been passed, where texels follow each other in
    // Morton's order, and each is passed from left to right. v in [0, 1) is how far down in the texel the ray lies,
    // w.r.t. solid angle. So rays of uniform u and v follow the light.
    Ray ray(double u, double v) const;

private:
    struct Texel {
        std::uint64_t order;  // Morton's
        int row, column;
        Color colour;
        double light;  // of this texel and those before it
    };

    const EnvironmentMap& map_;
    double all_;
    std::vector<Texel> texels_;
    std::vector<Ray> rays_;  // with their share of the light
};

// The sums over m rays to the sun, none if it is empty. Ray j goes to the place after the fraction (j + u_j) / m of its
// light, v_j down in a texel, by random numbers u_j and then v_j; its weight is cos(theta_j), 0 below the horizon.
RatioEstimator sample_sun(const Scene& scene, const Sun& sun, const Hit& hit, std::size_t m, Random& random);
}  // namespace bmc::beyond
