#include "scene/render.h"
#include "scene/pilot.h"
#include "scene/render_fast.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <optional>
#include <system_error>

namespace {

class Renderer {
public:
    Renderer(const Scene& scene, const Light& light, const RenderSettings& settings, const PixelRules& rules)
        : scene_(scene), light_(light), settings_(settings), rules_(rules) {
        if (settings.show == Show::error) picture_amplitude_ = run_pilot(scene, light, settings, rules).amplitude;
    }

    void operator()(int y, Image& image) const {
        const Camera camera{settings_.width, settings_.height};
        for (int x = 0; x < settings_.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const std::optional<Hit> hit = intersect(scene_, ray);
            Random random = pixel_stream(settings_, x, y);
            image.set(x, y, hit ? shown(*hit, random) : background(ray));
        }
    }

private:
    // What is exact has no error.
    Color background(const Ray& ray) const {
        return settings_.show == Show::error ? Color{} : light_.environment().interpolated_radiance(ray.direction);
    }

    Color shown(const Hit& hit, Random& random) const {
        const PlacedRule placed = rules_.of(hit.normal, random);
        if (settings_.show == Show::picture) return reflected(hit, placed);
        const PixelError error = pixel_error(scene_, light_, settings_.known, hit, placed);
        return standard_error(error, picture_amplitude_, rules_.samples());
    }

    Color reflected(const Hit& hit, const PlacedRule& placed) const {
        const auto& [rule, caps, process] = *placed.rule;
        return settings_.known == KnownPart::light
                   ? reflected_known_light(scene_, light_.averages(), hit, rule, caps, placed.frame, placed.sun)
                   : reflected_light(scene_, light_.environment(), hit, rule, placed.frame);
    }

    const Scene& scene_;
    const Light& light_;
    const RenderSettings& settings_;
    const PixelRules& rules_;
    Color picture_amplitude_;  // where errors are shown
};

}  // namespace

Image render(const Scene& scene, const Light& light, const RenderSettings& settings, const Progress& progress) {
    PixelRules rules(settings, settings.known == KnownPart::light ? &light.averages() : nullptr);
    const std::size_t steps = rules.shared_count() + static_cast<std::size_t>(settings.height);
    std::atomic<std::size_t> done{0};
    const auto report = [&] {
        if (progress && done < steps) progress(static_cast<double>(done) / static_cast<double>(steps));
    };
    for (; done < rules.shared_count(); ++done, report()) rules.make_shared_rule();
    std::function<void(int, Image&)> render_row = Renderer(scene, light, settings, rules);
    const bool is_fast = !settings.plain && settings.show == Show::picture;
    if (is_fast) render_row = rows_fast(scene, light, settings, rules);
    Image image(settings.width, settings.height);
    std::atomic<int> next_row{0};
    const auto work = [&](bool reports) {
        for (int y; (y = next_row++) < settings.height;) {
            render_row(y, image);
            ++done;
            if (reports) report();
        }
    };
    std::vector<std::future<void>> helpers;
    try {
        for (unsigned i = 1; i < settings.threads; ++i) helpers.push_back(std::async(std::launch::async, work, false));
    } catch (const std::system_error&) {  // the system starts no more: those that it has started do all
    }
    work(true);
    for (std::future<void>& helper : helpers) helper.get();
    if (progress) progress(1);
    return image;
}
