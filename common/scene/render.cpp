#include "scene/render.h"
#include "scene/pilot.h"
#include "scene/render_fast.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <optional>

namespace {

class Renderer {
public:
    Renderer(const Scene& scene, const Light& light, const RenderSettings& settings, const PixelRules& rules)
        : scene_(scene), light_(light), settings_(settings), rules_(rules) {
        if (settings.show == Show::error) picture_amplitude_ = run_pilot(scene, light, settings, rules).amplitude;
    }

    // Returns how many pixels of the row show an object.
    std::size_t operator()(int y, Image& image) const {
        const Camera camera{settings_.width, settings_.height};
        std::size_t objects = 0;
        for (int x = 0; x < settings_.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const std::optional<Hit> hit = intersect(scene_, ray);
            Random random = pixel_stream(settings_, x, y);
            image.set(x, y, hit ? shown(*hit, random) : background(ray));
            objects += hit.has_value();
        }
        return objects;
    }

private:
    // What is exact has no error.
    Color background(const Ray& ray) const {
        return settings_.show == Show::error ? Color{} : light_.environment().interpolated_radiance(ray.direction);
    }

    Color shown(const Hit& hit, Random& random) const {
        if (settings_.show == Show::picture) return reflected(hit, random);
        const PlacedRule placed = rules_.of(hit.normal, settings_.samples, random);
        const PixelError error = pixel_error(scene_, light_, settings_.prior.known, hit, placed);
        return standard_error(error, picture_amplitude_, settings_.samples);
    }

    // The mean over parts of the directions where these are many, each part a rule of its own.
    Color reflected(const Hit& hit, Random& random) const {
        const bool in_parts = settings_.method == Method::mc && rules_.shared().empty();
        const std::size_t most = in_parts ? most_fresh_directions : settings_.samples;
        Color mean;
        for (std::size_t done = 0, part; done < settings_.samples; done += part) {
            part = std::min(settings_.samples - done, most);
            const double share = static_cast<double>(part) / static_cast<double>(settings_.samples);
            mean += share * shade(hit, rules_.of(hit.normal, part, random));
        }
        return mean;
    }

    Color shade(const Hit& hit, const PlacedRule& placed) const {
        const auto& [rule, caps, process] = *placed.rule;
        return settings_.prior.known == KnownPart::light
                   ? reflected_known_light(scene_, light_.averages(), hit, rule, caps, placed.frame)
                   : reflected_light(scene_, light_.environment(), hit, rule, placed.frame);
    }

    const Scene& scene_;
    const Light& light_;
    const RenderSettings& settings_;
    const PixelRules& rules_;
    Color picture_amplitude_;  // where errors are shown
};

// The fraction of a rendering that is done, counted in rays: they take the time, not the rows of sky. To make a rule of
// n directions by factoring Q takes as long as n^3 / 250 rays, and only one thread does it.
class Meter {
public:
    Meter(const Scene& scene, const RenderSettings& settings, std::size_t rules)
        : rays_per_pixel_(static_cast<double>(settings.samples)) {
        rays_per_rule_ = rays_per_pixel_;
        if (settings.method != Method::mc) rays_per_rule_ *= rays_per_pixel_ * rays_per_pixel_ / 250 * settings.threads;
        all_ = rays(rules, object_pixels(scene, settings.width, settings.height));
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
    PixelRules rules(settings, settings.prior.known == KnownPart::light ? &light.averages() : nullptr);
    const std::size_t shared = rules.shared_count();
    const std::optional<Meter> meter = progress ? std::optional(Meter(scene, settings, shared)) : std::nullopt;
    const auto report = [&](std::size_t made, std::size_t pixels) {
        if (meter && meter->done(made, pixels) < 1) progress(meter->done(made, pixels));
    };
    for (std::size_t made = 1; made <= shared; ++made) {
        rules.make_shared_rule();
        report(made, 0);
    }
    std::function<std::size_t(int, Image&)> render_row = Renderer(scene, light, settings, rules);
    const bool is_fast = !settings.plain && settings.show == Show::picture;
    if (is_fast) render_row = rows_fast(render_row, scene, light, settings, rules);
    Image image(settings.width, settings.height);
    std::atomic<int> next_row{0};
    std::atomic<std::size_t> object_pixels_done{0};
    const auto work = [&](bool reports) {
        for (int y; (y = next_row++) < settings.height;) {
            const std::size_t objects = render_row(y, image);
            object_pixels_done += objects;
            if (reports && objects > 0) report(shared, object_pixels_done);
        }
    };
    std::vector<std::future<void>> helpers;
    for (unsigned i = 1; i < settings.threads; ++i) helpers.push_back(std::async(std::launch::async, work, false));
    work(true);
    for (std::future<void>& helper : helpers) helper.get();
    if (progress) progress(1);
    return image;
}
