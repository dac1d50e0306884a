// Which quadrature rule a pixel has. A method is a way to give each pixel its rule. Brouillat, Bouville, Loos, Hansen &
// Bouatouch, "A Bayesian Monte Carlo approach to global illumination" (Computer Graphics Forum 2009), share rules
// between pixels, as the last three here do.
#pragma once

#include "scene/parallel.h"
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
    unsigned threads = 1;  // changes no bit of the image
};

// Every pixel draws from a stream of its own.
Random pixel_stream(const RenderSettings& settings, int x, int y);

// The directions of a pixel before they are carried to its surface.
struct PixelRule {
    CosineRule directions;
};

// A rule and the frame that carries it to the surface.
struct PlacedRule {
    std::shared_ptr<const PixelRule> rule;
    Frame frame;
};

// Makes a rule on a set of directions. It may be a PixelRule that holds more.
using MakeRule = std::function<std::shared_ptr<const PixelRule>(DirectionSet)>;

class PixelRules {
public:
    // The rules of Monte Carlo or of Gaussian processes, or those of `make`. The constructor makes the rules that
    // pixels share: rule i on directions from the random stream 2^63 + i, since pixels have the streams from 0. Throws
    // what the Gaussian processes throw.
    explicit PixelRules(const RenderSettings& settings, const Progress& progress = nullptr);
    PixelRules(const RenderSettings& settings, MakeRule make, const Progress& progress = nullptr);

    // The part of the constructor in the work on a picture, if a rule takes as long as a row.
    static double share_of_work(const RenderSettings& settings);

    const std::vector<std::shared_ptr<const PixelRule>>& shared() const { return shared_rules_; }

    // The rule of a pixel, from its stream of random numbers. It must not outlive this.
    PlacedRule rule_for(Vec3 normal, Random& random) const;

private:
    std::shared_ptr<const PixelRule> fresh_rule(Random& random) const;
    PlacedRule direct(Vec3 normal, Random& random) const;
    PlacedRule single(Vec3 normal) const;
    PlacedRule rotated(Vec3 normal, double turns) const;
    PlacedRule pool(Vec3 normal, double u, double turns) const;

    RenderSettings settings_;
    MakeRule make_;
    std::vector<std::shared_ptr<const PixelRule>> owned_rules_;
    std::vector<std::shared_ptr<const PixelRule>> shared_rules_;  // without owners, whose count threads would fight for
};
}  // namespace bmc
