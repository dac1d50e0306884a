// The sun of an environment map, or its lamps: the texels of more than ten times the mean radiance. A rule's directions
// rarely meet them, so they have rays of their own: each kind of light is sampled in the way that suits it (Veach &
// Guibas, "Optimally combining sampling techniques for Monte Carlo rendering", SIGGRAPH 1995).
#pragma once

#include "base/random.h"
#include "light/texels_on_sphere.h"
#include "scene/scene.h"

#include <memory>

namespace bmc::beyond {
// Sums over rays: of all light, and of what arrives.
struct RatioEstimator {
    Colour all, visible;

    Colour fraction() const;  // in [0, 1]; 1 for a colour that no ray carries
};

class Sun {
public:
    // The texels of more than `threshold` times the mean.
    explicit Sun(const EnvironmentMap& map, double threshold = 10);

    bool empty() const { return texels_.empty(); }

    // The R + G + B that its texels exceed.
    double least() const { return least_; }

    // The integral of its R + G + B over all directions, and the ratio to that of the whole map.
    double light() const { return light_.back(); }
    double share() const { return empty() ? 0 : light() / all_; }

    // About the standard deviation of the directions that its light comes from, as unit vectors: above 0, at most 1.
    double spread() const { return spread_; }

    // The map that it was made of, without the sun: a copy, or where there is no sun that map, which must outlive it.
    std::shared_ptr<const EnvironmentMap> sky(const EnvironmentMap& map) const;

    // colour: the radiance there, scaled to R + G + B = 1.
    struct Ray {
        Vec3 direction;
        Colour colour;
    };

    // The ray that two numbers in [0, 1) choose, in proportion to the light if they are uniform, by the inverse of its
    // cumulative distribution: `across` chooses the texel, in Morton's order, and the place from left to right in it;
    // `down` chooses the height in the texel, w.r.t. solid angle.
    Ray ray(double across, double down) const;

private:
    struct Texel {
        std::uint64_t order;  // Morton's
        int row, column;
        Colour colour;
        double top, bottom;  // cosines of polar angles
    };

    static constexpr int steps = 4096;

    int columns_;  // of the map
    double all_, least_, spread_ = 1;
    std::vector<Texel> texels_;
    std::vector<double> light_{0};    // of no texel, of the first one, of the first two ...
    std::vector<std::size_t> first_;  // the texel where each of the equal steps of the light begins, and the last one
};

// The sums over m rays to the sun, or over none if it is empty. Ray j is ray((j + u) / m, down), where u and then down
// are random numbers. Its weight is cos(theta_j), 0 below the horizon.
RatioEstimator sample_sun(const Scene& scene, const Sun& sun, const Hit& hit, std::size_t m, Random& random);
}  // namespace bmc::beyond
