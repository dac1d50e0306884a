#include "scene/render.h"

#include <atomic>
#include <future>

namespace {

// A quadrature rule for the cosine-weighted integral, as the loop over its directions reads it: an array per component,
// so that the compiler can compute neighbouring directions side by side, and cos(theta), which no rotation about the up
// axis changes, folded into the weights once.
struct CosineRule {
    std::vector<double> x, y, z, weight;

    explicit CosineRule(const QuadratureRule& rule) {
        for (std::size_t i = 0; i < rule.weights.size(); ++i) {
            const Vec3 direction = rule.directions[i];
            x.push_back(direction.x);
            y.push_back(direction.y);
            z.push_back(direction.z);
            weight.push_back(rule.known == KnownPart::cosine ? rule.weights[i] : rule.weights[i] * direction.y);
        }
    }
};

// What one thread reuses from pixel to pixel: where each direction ends, and with what weight.
struct Samples {
    std::vector<double> weight;
    std::vector<int> texel;
};

// Frame, shadow and grid come by value: what only this loop can see, its stores cannot change, so it vectorises.

// The weight of every direction that leaves the surface past the other object; 0 for those in shadow.
template <class Shadow>
void find_weights(const CosineRule& rule, Frame frame, Shadow shadow, double* weight) {
    const double *x = rule.x.data(), *y = rule.y.data(), *z = rule.z.data(), *rule_weight = rule.weight.data();
    for (std::size_t i = 0; i < rule.weight.size(); ++i)
        weight[i] = shadow.covers(frame.to_world({x[i], y[i], z[i]})) ? 0 : rule_weight[i];
}

// The texel that every direction ends in.
void find_texels(const CosineRule& rule, Frame frame, TexelGrid grid, int* texel) {
    const double *x = rule.x.data(), *y = rule.y.data(), *z = rule.z.data();
    for (std::size_t i = 0; i < rule.weight.size(); ++i) {
        const Vec3 direction = frame.to_world({x[i], y[i], z[i]});
        texel[i] = grid.texel_index(direction.x, direction.y, direction.z);
    }
}

Color weighted_sum(const Samples& samples, const float* texels) {
    Color sum;
    for (std::size_t i = 0; i < samples.weight.size(); ++i) {
        const float* texel = texels + 3 * static_cast<std::ptrdiff_t>(samples.texel[i]);
        sum = sum + samples.weight[i] * Color{texel[0], texel[1], texel[2]};
    }
    return sum;
}

Color reflected_light(const Scene& scene, const Hit& hit, const CosineRule& rule, const Frame& frame,
                      const EnvironmentMap& environment, Samples& samples) {
    samples.weight.resize(rule.weight.size());
    samples.texel.resize(rule.weight.size());
    if (hit.object == Object::sphere)
        find_weights(rule, frame, RectangleShadow(scene.rectangle, hit.point), samples.weight.data());
    else
        find_weights(rule, frame, SphereShadow(scene.sphere, hit.point), samples.weight.data());
    find_texels(rule, frame, environment.grid(), samples.texel.data());
    const Color irradiance = weighted_sum(samples, environment.texels());
    return 1 / portable::pi *
           Color{hit.albedo.x * irradiance.x, hit.albedo.y * irradiance.y, hit.albedo.z * irradiance.z};
}

// The random streams of the rules that pixels share; pixels use the streams from 0.
constexpr std::uint64_t first_rule_stream = std::uint64_t{1} << 63;

class Renderer {
public:
    Renderer(const Scene& scene, const EnvironmentMap& environment, const Covariance& covariance,
             const RenderSettings& settings)
        : scene_(scene),
          environment_(environment),
          covariance_(covariance),
          settings_(settings),
          camera_{settings.width, settings.height} {
        const Method method = settings.method;
        const bool shares_one = method == Method::single || method == Method::rotated ||
                                (method == Method::mc && is_lattice(settings.placement));
        const std::size_t shared = method == Method::pool ? settings.pool : shares_one ? 1 : 0;
        for (std::size_t i = 0; i < shared; ++i) {
            Random random(settings.seed, first_rule_stream + i);
            shared_rules_.push_back(fresh_rule(random));
        }
    }

    void render_row(int y, Samples& samples, Image& image) const {
        for (int x = 0; x < settings_.width; ++x) {
            const Ray ray = camera_.ray(x, y);
            const std::optional<Hit> hit = intersect(scene_, ray);
            image.set(x, y, hit ? shade(*hit, pixel_stream(x, y), samples) : environment_.radiance(ray.direction));
        }
    }

private:
    Random pixel_stream(int x, int y) const {
        return {settings_.seed, static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(settings_.width) +
                                    static_cast<std::uint64_t>(x)};
    }

    CosineRule fresh_rule(Random& random) const {
        std::vector<Vec3> directions = place_directions(settings_.placement, settings_.samples, random);
        if (settings_.method == Method::mc)
            return CosineRule(monte_carlo_rule(std::move(directions), settings_.placement));
        return CosineRule(bayesian_rule(covariance_, settings_.noise, std::move(directions), settings_.prior));
    }

    Color shade(const Hit& hit, Random random, Samples& samples) const {
        const Frame frame(hit.normal);
        if (shared_rules_.empty())
            return reflected_light(scene_, hit, fresh_rule(random), frame, environment_, samples);
        if (settings_.method == Method::single)
            return reflected_light(scene_, hit, shared_rules_[0], frame, environment_, samples);
        const auto choice = static_cast<std::size_t>(random.uniform() * static_cast<double>(shared_rules_.size()));
        const double turns = random.uniform();
        return reflected_light(scene_, hit, shared_rules_[choice], frame.rotated(turns), environment_, samples);
    }

    const Scene& scene_;
    const EnvironmentMap& environment_;
    const Covariance& covariance_;
    const RenderSettings& settings_;
    Camera camera_;
    std::vector<CosineRule> shared_rules_;
};

}  // namespace

Image render(const Scene& scene, const EnvironmentMap& environment, const Covariance& covariance,
             const RenderSettings& settings, const Progress& progress) {
    const Renderer renderer(scene, environment, covariance, settings);
    Image image(settings.width, settings.height);
    std::atomic<int> next_row{0};
    const auto work = [&](bool reports) {
        Samples samples;
        for (int y; (y = next_row++) < settings.height;) {
            renderer.render_row(y, samples, image);
            if (reports && progress) progress(static_cast<double>(y + 1) / settings.height);
        }
    };
    std::vector<std::future<void>> helpers;
    for (unsigned i = 1; i < settings.threads; ++i) helpers.push_back(std::async(std::launch::async, work, false));
    work(true);
    for (std::future<void>& helper : helpers) helper.get();
    return image;
}
