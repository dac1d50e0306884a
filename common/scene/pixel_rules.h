// A method gives each pixel its quadrature rule. The last three share rules between pixels, as do Brouillat, Bouville,
// Loos, Hansen & Bouatouch, "A Bayesian Monte Carlo approach to global illumination" (Computer Graphics Forum 2009).
#pragma once

#include "base/progress.h"
#include "quadrature/model.h"
#include "quadrature/quadrature.h"

namespace bmc {
enum class Method {
    mc,       // classic Monte Carlo: fresh directions for every pixel (a fixed set: rotated at random)
    direct,   // a fresh Gaussian process on fresh directions for every pixel
    single,   // one Gaussian process for the whole image
    rotated,  // the same, its directions rotated at random about the normal in every pixel
    pool      // one of several, which a random number chooses, rotated by a second one (a fixed set needs but one)
};
inline constexpr const char* method_names[] = {"mc", "direct", "single", "rotated", "pool"};

struct RenderSettings : ModelSettings {
    Method method = Method::pool;
    std::size_t samples = 40;  // directions per pixel
    std::size_t pool = 20;     // Gaussian processes in the pool
    int width = 500, height = 500;
    std::size_t threads = processors();  // changes no bit of the image
};

// The random streams of a pixel and of shared rule i: no two are the same.
inline Random pixel_stream(const RenderSettings& settings, int x, int y) {
    return {settings.seed, static_cast<std::uint64_t>(std::int64_t{y} * settings.width + x)};
}
inline Random rule_stream(const RenderSettings& settings, std::size_t i) {
    return {settings.seed, (std::uint64_t{1} << 63) + i};
}

// The rule of a pixel, made for it alone or shared, and the frame that carries it to the surface.
struct OrientedRule {
    Frame frame;
    std::shared_ptr<const QuadratureRule> rule;
};

using SharedRules = std::vector<std::shared_ptr<const QuadratureRule>>;

struct PixelRules {
    const RenderSettings settings;
    const std::shared_ptr<const Covariance> covariance;  // null for Method::mc
    const Sampler sampler;

    // The rules that pixels share. These and those below are cosine rules: they integrate L v cos(theta) from samples
    // of L v.
    const SharedRules shared;

    // Throws what the Gaussian processes throw.
    explicit PixelRules(const RenderSettings& picture_settings);

    // A rule on fresh directions, of Monte Carlo or of a Gaussian process.
    std::shared_ptr<const QuadratureRule> fresh_rule(Random& random) const;

    // The rule of a pixel, from the pixel's random stream.
    OrientedRule rule_for(Vec3 normal, Random& random) const;

private:
    std::size_t shared_count() const;  // how many rules pixels share
    SharedRules shared_rules() const;
};
}  // namespace bmc
