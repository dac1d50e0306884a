// Which quadrature rule a pixel has. A method is a way to give each pixel its rule. Brouillat, Bouville, Loos, Hansen &
// Bouatouch, "A Bayesian Monte Carlo approach to global illumination" (Computer Graphics Forum 2009), share rules
// between pixels, as the last three here do.
#pragma once

#include "numerics/parallel.h"
#include "scene/reflection.h"

namespace bmc {
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
    unsigned threads = 1;         // changes no bit of the image
    Progress progress = nullptr;  // called with the fraction of its rows that is done
};

// Every pixel draws from a stream of its own.
Random pixel_stream(const RenderSettings& settings, int x, int y);

// A rule and the frame that carries it to the surface.
struct PlacedRule {
    std::shared_ptr<const CosineRule> rule;
    Frame frame;
};

class PixelRules {
public:
    // Makes the rules that pixels share: rule i on directions from the random stream 2^63 + i, since pixels have the
    // streams from 0. Throws what the Gaussian processes throw.
    explicit PixelRules(const RenderSettings& settings);

    const std::vector<CosineRule>& shared() const { return rules_; }

    // The rule of a pixel, from its stream of random numbers. It must not outlive this.
    PlacedRule rule_for(Vec3 normal, Random& random) const;

private:
    CosineRule fresh_rule(Random& random) const;
    PlacedRule direct(Vec3 normal, Random& random) const;
    PlacedRule single(Vec3 normal) const;
    PlacedRule rotated(Vec3 normal, double turns) const;
    PlacedRule pool(Vec3 normal, double u, double turns) const;

    RenderSettings settings_;
    std::unique_ptr<const Covariance> covariance_;
    std::vector<CosineRule> rules_;
    std::vector<std::shared_ptr<const CosineRule>>
        shared_rules_;  // rules_, without a count that threads would fight for
};
}  // namespace bmc
