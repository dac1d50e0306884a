// Which quadrature rule a pixel has. A method is a way to give each pixel its rule. Brouillat, Bouville, Loos, Hansen &
// Bouatouch, "A Bayesian Monte Carlo approach to global illumination" (Computer Graphics Forum 2009), share rules
// between pixels, as the last three here do.
#pragma once

#include "scene/known_light.h"

#include <memory>
#include <optional>

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

// What a picture shows of each point: the light that it reflects, or the standard error that is predicted for that.
enum class Show { picture, error };
constexpr std::pair<const char*, Show> show_names[] = {{"picture", Show::picture}, {"error", Show::error}};

struct RenderSettings : ModelSettings {
    Method method = Method::pool;
    std::size_t samples = 40;  // directions per pixel
    std::size_t pool = 20;     // Gaussian processes in the pool
    Show show = Show::picture;
    int width = 500, height = 500;
    unsigned threads = 1;  // changes no bit of the image
    bool plain = false;    // nor does this: whether the loops are those of the textbook
};

// Monte Carlo's samples tell its error by what they differ by, if they are independent.
inline bool predicts_error(const RenderSettings& settings) {
    return settings.method != Method::mc || !is_lattice(settings.placement);
}

// Every pixel draws from a stream of its own.
Random pixel_stream(const RenderSettings& settings, int x, int y);

// The directions of a pixel before they are carried to its surface, and what they count.
struct PixelRule {
    CosineRule rule;
    std::vector<const LightTable*> caps;     // of each direction, where the light is known
    std::optional<GaussianProcess> process;  // that gave the weights, where errors are shown
};

// A rule and the frame that carries it to the surface, and the rays to a sun that is known.
struct PlacedRule {
    std::shared_ptr<const PixelRule> rule;
    Frame frame;
    SunRays sun{};
};

class PixelRules {
public:
    // The averages of a known light, null for one that is not. Both arguments must outlive this.
    PixelRules(const RenderSettings& settings, const PrefilteredEnvironment* averages);

    // Makes one of the rules that pixels share, of which there are shared_count(): rule i from the random stream
    // 2^63 + i, pixels having those from 0. Throws what the Gaussian processes throw.
    void make_shared_rule();
    std::size_t shared_count() const;
    const std::vector<std::shared_ptr<const PixelRule>>& shared() const { return shared_rules_; }

    // A pixel's samples: those of its rule, and those of a sun that is known.
    std::size_t samples() const { return settings_.samples; }
    std::size_t sun_samples() const { return sun_samples_; }

    // The rule of a pixel, from its stream of random numbers.
    PlacedRule of(Vec3 normal, Random& random) const;

private:
    std::shared_ptr<const PixelRule> fresh_rule(std::size_t samples, Random& random) const;
    PlacedRule without_sun(Vec3 normal, Random& random) const;
    PlacedRule direct(Vec3 normal, Random& random) const;
    PlacedRule single(Vec3 normal) const;
    PlacedRule rotated(Vec3 normal, double turns) const;
    PlacedRule pool(Vec3 normal, double u, double turns) const;

    RenderSettings settings_;  // of the rules
    const PrefilteredEnvironment* averages_;
    std::unique_ptr<Covariance> covariance_;
    std::size_t sun_samples_;
    std::vector<std::shared_ptr<const PixelRule>> shared_rules_;
};
