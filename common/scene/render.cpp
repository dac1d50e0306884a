#include "scene/render.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <optional>

namespace {

// BEGIN SOLUTION shade
// The weight of direction i in the integral of L cos(theta), where L is to be sampled: the cosine belongs to the
// weights unless it is the rule's known part, which its weights have in them.
double cosine_weight(const QuadratureRule& rule, std::size_t i) {
    return knows_cosine(rule.known) ? rule.weights[i] : rule.weights[i] * rule.directions[i].y;
}
// END SOLUTION

// The numbers that one SIMD instruction takes at most. Arrays of a whole number of them leave no rest to be computed
// one by one.
constexpr std::size_t vector_size = 16;

std::size_t padded(std::size_t n) { return (n + vector_size - 1) / vector_size * vector_size; }

// A quadrature rule for the cosine-weighted integral, as the loops over its directions read it: an array per component,
// so that the compiler can compute neighbouring directions side by side, and cos(theta), which no rotation about the up
// axis changes, folded into the weights once. The directions are in single precision, twice as many side by side, and
// padded with some that have no weight.
struct CosineRule {
    std::vector<float> x, y, z;
    std::vector<double> weight;

    // Where the light is known, the table of its averages that each direction looks its light up in.
    const PrefilteredEnvironment* light;
    std::vector<int> columns, rows;
    std::vector<const float*> rgb;

    CosineRule(const QuadratureRule& rule, const PrefilteredEnvironment* known_light) : light(known_light) {
        const std::size_t n = rule.weights.size();
        for (std::vector<float>* component : {&x, &y, &z}) component->resize(padded(n));
        for (std::size_t i = 0; i < n; ++i) {
            x[i] = static_cast<float>(rule.directions[i].x);
            y[i] = static_cast<float>(rule.directions[i].y);
            z[i] = static_cast<float>(rule.directions[i].z);
            weight.push_back(cosine_weight(rule, i));
            if (!light) continue;
            const LightTable& table = light->table(solid_angle(rule, i));
            columns.push_back(table.columns);
            rows.push_back(table.rows);
            rgb.push_back(table.rgb);
        }
        if (!light) return;
        columns.resize(padded(n), 1);
        rows.resize(padded(n), 1);
    }

private:
    // What direction i stands for: its weight without the cosine, but of an evenly shared hemisphere at least a quarter
    // and at most four times its share, also where the weight is negative.
    static double solid_angle(const QuadratureRule& rule, std::size_t i) {
        const double share = 2 * portable::pi / static_cast<double>(rule.weights.size());
        return std::clamp(cosine_weight(rule, i) / rule.directions[i].y, share / 4, share * 4);
    }
};

// BEGIN SOLUTION shade
// Directions that go through the loops together: what is noted of them stays in the nearest cache, and memory does not
// grow with their number.
constexpr std::size_t batch = 512;
struct Samples {
    float x[batch], y[batch], z[batch];  // directions in the world
    float visible[batch];                // 1, or 0 where the other object is in the way
    int texel[batch];
};

struct SingleVec3 {
    float x, y, z;

    explicit SingleVec3(Vec3 v) : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z)) {}
};

// Carries n directions of the rule, from begin on, to the surface.
void find_directions(const CosineRule& rule, std::size_t begin, std::size_t n, const Frame& frame, Samples& samples) {
    const float *x = rule.x.data() + begin, *y = rule.y.data() + begin, *z = rule.z.data() + begin;
    const SingleVec3 t(frame.tangent), u(frame.normal), b(frame.bitangent);
    for (std::size_t i = 0; i < n; ++i) {
        samples.x[i] = x[i] * t.x + y[i] * u.x + z[i] * b.x;
        samples.y[i] = x[i] * t.y + y[i] * u.y + z[i] * b.y;
        samples.z[i] = x[i] * t.z + y[i] * u.z + z[i] * b.z;
    }
}

// Shadow and grid come by value: what only these loops can see, their stores cannot change, so they vectorise.

template <class Shadow>
void find_visible(std::size_t n, Shadow shadow, Samples& samples) {
    for (std::size_t i = 0; i < n; ++i)
        samples.visible[i] = shadow.covers(samples.x[i], samples.y[i], samples.z[i]) ? 0.0f : 1.0f;
}

// By the object that can be in the way.
void find_visible(std::size_t n, const Scene& scene, const Hit& hit, Samples& samples) {
    if (hit.object == Object::sphere)
        find_visible(n, RectangleShadow(scene.rectangle, hit.point), samples);
    else
        find_visible(n, SphereShadow(scene.sphere, hit.point), samples);
}

// The texels that the directions end in.
void find_texels(std::size_t n, TexelGrid grid, Samples& samples) {
    for (std::size_t i = 0; i < n; ++i) samples.texel[i] = grid.texel_index(samples.x[i], samples.y[i], samples.z[i]);
}

// The same where every direction has a table of its own.
void find_texels(std::size_t n, const int* columns, const int* rows, Samples& samples) {
    for (std::size_t i = 0; i < n; ++i)
        samples.texel[i] = TexelGrid(columns[i], rows[i]).texel_index(samples.x[i], samples.y[i], samples.z[i]);
}

Color reflect(const Hit& hit, Color irradiance) {
    return 1 / portable::pi *
           Color{hit.albedo.x * irradiance.x, hit.albedo.y * irradiance.y, hit.albedo.z * irradiance.z};
}

// A visible part of the light, in [0, 1] whatever the weights; 0 where no direction has light of this colour.
double fraction(double visible, double all) { return all > 0 ? std::clamp(visible / all, 0.0, 1.0) : 0; }

// The same where the light is known (prefiltered_environment.h): the irradiance without shadows times the part of the
// light that passes the other object.
Color shade_known_light(const Scene& scene, const Hit& hit, const CosineRule& rule, const Frame& frame) {
    const Color irradiance = rule.light->irradiance(hit.normal);
    const std::size_t n = rule.weight.size();
    Samples samples;
    Color visible, all;
    bool shadowed = false;
    for (std::size_t begin = 0; begin < n; begin += batch) {
        const std::size_t count = std::min(batch, n - begin);
        find_directions(rule, begin, padded(count), frame, samples);
        find_visible(padded(count), scene, hit, samples);
        shadowed = shadowed || std::count(samples.visible, samples.visible + count, 0.0f) > 0;
        if (!shadowed && begin + count == n) return reflect(hit, irradiance);
        find_texels(padded(count), rule.columns.data() + begin, rule.rows.data() + begin, samples);
        for (std::size_t i = 0; i < count; ++i) {
            const float* rgb = rule.rgb[begin + i] + 3 * static_cast<std::ptrdiff_t>(samples.texel[i]);
            const Color light = rule.weight[begin + i] * Color{rgb[0], rgb[1], rgb[2]};
            all = all + light;
            visible = visible + static_cast<double>(samples.visible[i]) * light;
        }
    }
    return reflect(hit, {irradiance.x * fraction(visible.x, all.x), irradiance.y * fraction(visible.y, all.y),
                         irradiance.z * fraction(visible.z, all.z)});
}

// The light that a point reflects, by a rule that the frame carries to its surface: the sum of weights times the
// environment's radiance in the directions that pass the other object, times albedo / pi.
Color shade(const Scene& scene, const EnvironmentMap& environment, const Hit& hit, const CosineRule& rule,
            const Frame& frame) {
    if (rule.light) return shade_known_light(scene, hit, rule, frame);
    Samples samples;
    Color irradiance;
    for (std::size_t begin = 0, n = rule.weight.size(); begin < n; begin += batch) {
        const std::size_t count = std::min(batch, n - begin);
        find_directions(rule, begin, padded(count), frame, samples);
        find_texels(padded(count), environment.grid(), samples);
        find_visible(padded(count), scene, hit, samples);
        for (std::size_t i = 0; i < count; ++i) {
            const float* rgb = environment.texels() + 3 * static_cast<std::ptrdiff_t>(samples.texel[i]);
            const double weight = static_cast<double>(samples.visible[i]) * rule.weight[begin + i];
            irradiance = irradiance + weight * Color{rgb[0], rgb[1], rgb[2]};
        }
    }
    return reflect(hit, irradiance);
}
// END SOLUTION

// The random streams of the rules that pixels share; pixels use the streams from 0.
constexpr std::uint64_t first_rule_stream = std::uint64_t{1} << 63;

std::size_t shared_rule_count(const RenderSettings& settings) {
    if (settings.method == Method::pool) return settings.pool;
    const bool turned = settings.method == Method::mc && is_lattice(settings.placement);
    return turned || settings.method == Method::single || settings.method == Method::rotated ? 1 : 0;
}

// Independent directions of Monte Carlo that a pixel draws at a time, so that their number may be any.
constexpr std::size_t most_fresh_directions = 4096;

class Renderer {
public:
    Renderer(const Scene& scene, const Light& light, const RenderSettings& settings)
        : scene_(scene),
          environment_(light.environment()),
          averages_(settings.prior.known == KnownPart::light ? &light.averages() : nullptr),
          covariance_(settings.make_covariance()),
          settings_(settings),
          camera_{settings.width, settings.height} {}

    void make_shared_rule() {
        Random random(settings_.seed, first_rule_stream + shared_rules_.size());
        shared_rules_.push_back(fresh_rule(settings_.samples, random));
    }

    // Returns how many pixels of the row show an object.
    std::size_t render_row(int y, Image& image) const {
        std::size_t objects = 0;
        for (int x = 0; x < settings_.width; ++x) {
            const Ray ray = camera_.ray(x, y);
            const std::optional<Hit> hit = intersect(scene_, ray);
            image.set(
                x, y,
                hit ? reflected_light(*hit, pixel_stream(x, y)) : environment_.interpolated_radiance(ray.direction));
            objects += hit.has_value();
        }
        return objects;
    }

private:
    Random pixel_stream(int x, int y) const {
        return {settings_.seed, static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(settings_.width) +
                                    static_cast<std::uint64_t>(x)};
    }

    CosineRule fresh_rule(std::size_t samples, Random& random) const {
        DirectionSet set = place_directions(settings_.placement, samples, random);
        if (settings_.method == Method::mc) return {monte_carlo_rule(std::move(set)), averages_};
        return {bayesian_rule(*covariance_, settings_.noise, std::move(set.directions), settings_.prior), averages_};
    }

    // BEGIN SOLUTION direct
    // A Gaussian process for every integral, on fresh directions from the pixel's random numbers.
    Color direct(const Hit& hit, Random& random) const {
        const CosineRule rule = fresh_rule(settings_.samples, random);
        return shade(scene_, environment_, hit, rule, Frame(hit.normal));
    }
    // END SOLUTION

    // BEGIN SOLUTION single
    // One process for the whole image, shared_rules_[0], its up axis aligned with the normal.
    Color single(const Hit& hit) const {
        const Frame aligned(hit.normal);
        return shade(scene_, environment_, hit, shared_rules_[0], aligned);
    }
    // END SOLUTION

    // BEGIN SOLUTION rotated
    // The same, but turned about its up axis by the pixel's own random angle before it is aligned with the normal.
    Color rotated(const Hit& hit, double turns) const {
        const Frame turned = Frame(hit.normal).rotated(turns);
        return shade(scene_, environment_, hit, shared_rules_[0], turned);
    }
    // END SOLUTION

    // BEGIN SOLUTION pool
    // A random one of several processes, shared_rules_, turned like the one; u is uniform in [0, 1).
    Color pool(const Hit& hit, double u, double turns) const {
        const auto choice = static_cast<std::size_t>(u * static_cast<double>(shared_rules_.size()));
        const Frame turned = Frame(hit.normal).rotated(turns);
        return shade(scene_, environment_, hit, shared_rules_[choice], turned);
    }
    // END SOLUTION

    Color reflected_light(const Hit& hit, Random random) const {
        if (settings_.method == Method::direct) return direct(hit, random);
        if (settings_.method == Method::single) return single(hit);
        if (shared_rules_.empty()) return monte_carlo_light(hit, Frame(hit.normal), random);
        const double u = random.uniform();
        const double turns = random.uniform();
        return settings_.method == Method::pool ? pool(hit, u, turns) : rotated(hit, turns);
    }

    // The mean over parts of the directions, each a rule of its own.
    Color monte_carlo_light(const Hit& hit, const Frame& frame, Random& random) const {
        Color mean;
        for (std::size_t done = 0, part; done < settings_.samples; done += part) {
            part = std::min(settings_.samples - done, most_fresh_directions);
            const double share = static_cast<double>(part) / static_cast<double>(settings_.samples);
            mean = mean + share * shade(scene_, environment_, hit, fresh_rule(part, random), frame);
        }
        return mean;
    }

    const Scene& scene_;
    const EnvironmentMap& environment_;
    const PrefilteredEnvironment* averages_;  // null unless the light is known
    const std::unique_ptr<Covariance> covariance_;
    const RenderSettings& settings_;
    Camera camera_;
    std::vector<CosineRule> shared_rules_;
};

// The fraction of a rendering that is done, counted in rays: they take the time, not the rows of sky. To make a rule of
// n directions by factoring Q takes as long as n^3 / 250 rays, and only one thread does it.
class Meter {
public:
    Meter(const Scene& scene, const RenderSettings& settings) : rays_per_pixel_(static_cast<double>(settings.samples)) {
        rays_per_rule_ = rays_per_pixel_;
        if (settings.method != Method::mc) rays_per_rule_ *= rays_per_pixel_ * rays_per_pixel_ / 250 * settings.threads;
        all_ = rays(shared_rule_count(settings), object_pixels(scene, settings.width, settings.height));
    }

    double done(std::size_t rules, std::size_t pixels) const { return rays(rules, static_cast<double>(pixels)) / all_; }

private:
    double rays(std::size_t rules, double pixels) const {
        return static_cast<double>(rules) * rays_per_rule_ + pixels * rays_per_pixel_;
    }

    double rays_per_pixel_, rays_per_rule_, all_;
};

}  // namespace

Image render(const Scene& scene, const Light& light, const RenderSettings& settings, const Progress& progress) {
    const std::optional<Meter> meter = progress ? std::optional(Meter(scene, settings)) : std::nullopt;
    const auto report = [&](std::size_t rules, std::size_t pixels) {
        if (meter && meter->done(rules, pixels) < 1) progress(meter->done(rules, pixels));
    };
    Renderer renderer(scene, light, settings);
    const std::size_t rules = shared_rule_count(settings);
    for (std::size_t made = 1; made <= rules; ++made) {
        renderer.make_shared_rule();
        report(made, 0);
    }
    Image image(settings.width, settings.height);
    std::atomic<int> next_row{0};
    std::atomic<std::size_t> object_pixels_done{0};
    const auto work = [&](bool reports) {
        for (int y; (y = next_row++) < settings.height;) {
            const std::size_t objects = renderer.render_row(y, image);
            object_pixels_done += objects;
            if (reports && objects > 0) report(rules, object_pixels_done);
        }
    };
    std::vector<std::future<void>> helpers;
    for (unsigned i = 1; i < settings.threads; ++i) helpers.push_back(std::async(std::launch::async, work, false));
    work(true);
    for (std::future<void>& helper : helpers) helper.get();
    if (progress) progress(1);
    return image;
}
