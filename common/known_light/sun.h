// The sun of an environment map: its texels of more than a hundred times the mean radiance. Hardly a direction of a
// rule meets them, so they have rays of their own: each kind of light is sampled in the way that suits it (Veach &
// Guibas, "Optimally combining sampling techniques for Monte Carlo rendering", SIGGRAPH 1995).
#pragma once

#include "light/environment.h"

#include <cstdint>
#include <vector>

namespace bmc {
class Sun {
public:
    explicit Sun(const EnvironmentMap& map);

    bool empty() const { return texels_.empty(); }

    // Its light over that of the whole map.
    double share() const { return empty() ? 0 : texels_.back().light / all_; }

    // The map with nothing but the sun, or with all but the sun.
    enum class Part { sun, sky };
    EnvironmentMap keep(Part part) const;

    // To the middle of a texel, whose radiance has this colour.
    struct Ray {
        Vec3 direction;
        Color colour;
    };

    // The ray to the texel at the fraction u in [0, 1) of all light, if texels are taken in Morton's order.
    const Ray& ray(double u) const;

private:
    struct Texel {
        std::uint64_t order;  // Morton's
        std::size_t index;
        Ray ray;
        double light;  // of this texel and those before it
    };

    const EnvironmentMap& map_;
    double all_;
    std::vector<Texel> texels_;
};
}  // namespace bmc
