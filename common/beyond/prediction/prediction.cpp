#include "beyond/prediction/prediction.h"

#include <numeric>

namespace bmc::beyond {
Shader sun_shader(const EnvironmentMap& map, RenderSettings settings, std::size_t rays) {
    settings.method = Method::mc;
    settings.placement = {PointSet::fibonacci, KnownPart::cosine};
    const auto sun = std::make_shared<const Sun>(map, 4);  // with the edge of a disc, which a lattice would rarely meet
    return [=, sky = std::make_shared<const EnvironmentMap>(sun->sky(map)), rules = PixelRules(settings)](
               const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        const Colour sky_colour = reflected_radiance(sphere_scene, *sky, hit, *oriented.rule, oriented.frame);
        if (sun->empty()) return sky_colour;
        const Colour sun_colour = sample_sun(sphere_scene, *sun, hit, rays, random).visible;
        return sky_colour + sun->light() / (portable::pi * static_cast<double>(rays)) * (hit.albedo * sun_colour);
    };
}

Shader better_shader(const EnvironmentLight& light, RenderSettings settings) {
    const std::size_t samples = settings.samples;
    settings.method = Method::mc;
    settings.placement = {PointSet::fibonacci, KnownPart::cosine};
    settings.samples = 4 * samples;
    ++settings.seed;
    if (light.averages) return light_shader(light, settings);
    return sun_shader(light.environment, settings, samples);
}

using Objects = std::vector<std::optional<Object>>;  // that the pixels show

// The mean over the pixels of a window around column x of row y that show the same object.
static Colour mean_in_window(const Image& image, const Objects& objects, int x, int y) {
    const int reach = std::clamp(image.height / 70, 3, 7);
    const auto object = [&](int i, int j) { return objects[static_cast<std::size_t>(j * image.width + i)]; };
    double count = 0;
    Colour sum;
    for (int j = std::max(0, y - reach); j <= std::min(image.height - 1, y + reach); ++j)
        for (int i = std::max(0, x - reach); i <= std::min(image.width - 1, x + reach); ++i) {
            if (object(i, j) != object(x, y)) continue;
            sum += image(i, j);
            count += 1;
        }
    return 1 / count * sum;
}

Image predicted_errors(const Image& picture, const Image& better) {
    Image squares(picture.width, picture.height), errors = squares;
    Objects objects(picture.pixels.size());
    const Camera camera{picture.width, picture.height};
    for_each_hit(sphere_scene, camera, [&](int x, int y, const Hit& hit) {
        const Colour difference = picture(x, y) - better(x, y);
        squares(x, y) = difference * difference;
        objects[static_cast<std::size_t>(y * picture.width + x)] = hit.object;
    });
    for_each_hit(sphere_scene, camera, [&](int x, int y, const Hit&) {
        const Colour mean = mean_in_window(squares, objects, x, y);
        errors(x, y) = {std::sqrt(mean.x), std::sqrt(mean.y), std::sqrt(mean.z)};
    });
    return errors;
}

double root_mean_square(const Image& errors) {
    double squares = 0, count = 0;
    for_each_hit(sphere_scene, {errors.width, errors.height}, [&](int x, int y, const Hit&) {
        squares += dot(errors(x, y), errors(x, y));
        count += 3;
    });
    return count > 0 ? std::sqrt(squares / count) : 0;
}

struct PilotPixel {
    int x, y;
    Hit hit;
};

static std::vector<PilotPixel> pilot_pixels(const RenderSettings& settings, double rays) {
    const Camera camera{settings.width, settings.height};
    for (int parts = 128;; parts *= 2) {
        const int across = std::max(1, settings.width / parts), down = std::max(1, settings.height / parts);
        std::vector<PilotPixel> pixels;
        for (int y = down / 2; y < settings.height; y += down)
            for (int x = across / 2; x < settings.width; x += across)
                if (const auto hit = intersect(sphere_scene, camera.ray(x, y))) pixels.push_back({x, y, *hit});
        if (across * down == 1 || static_cast<double>(pixels.size() * settings.samples) >= rays) return pixels;
    }
}

double pilot_rmse(const EnvironmentLight& light, const RenderSettings& settings, double rays) {
    const Shader picture = light_shader(light, settings);
    const Shader better = better_shader(light, settings);
    const std::vector<PilotPixel> pixels = pilot_pixels(settings, rays);
    std::vector<double> squares(pixels.size());
    Progress progress(formatted("pilot of %zu samples", settings.samples), pixels.size());
    for_each_row(static_cast<int>(pixels.size()), settings.threads, [&](int i) {
        const auto& [x, y, hit] = pixels[static_cast<std::size_t>(i)];
        squares[static_cast<std::size_t>(i)] = squared_distance(picture(hit, x, y), better(hit, x, y));
        progress.done();
    });
    const double sum = std::accumulate(squares.begin(), squares.end(), 0.0);
    return pixels.empty() ? 0 : std::sqrt(sum / (3 * static_cast<double>(pixels.size())));
}

double kurtosis(const EnvironmentMap& map) {
    const double mean = mean_over_directions(map, brightness);
    const auto square = [=](Colour c) { return (brightness(c) - mean) * (brightness(c) - mean); };
    const double variance = mean_over_directions(map, square);
    const auto fourth_power = [=](Colour c) { return square(c) * square(c); };
    return variance > 0 ? mean_over_directions(map, fourth_power) / (variance * variance) : 1;
}

Prediction samples_for(double target, std::size_t most, const EnvironmentLight& light, RenderSettings settings) {
    if (settings.method == Method::direct) settings.method = Method::pool, settings.pool = RenderSettings().pool;
    const double rays = light.averages ? 0 : 256 * kurtosis(light.environment), limit = static_cast<double>(most);
    const auto predict = [&](double samples) {
        settings.samples = static_cast<std::size_t>(samples);
        return Prediction{samples, pilot_rmse(light, settings, rays)};
    };
    Prediction last = predict(1), next = last;
    // Errors at the edges of shadows fall like the power -3/4 of the samples; twice that excludes what no rule reaches.
    const auto in_reach = [&] { return next.rmse * portable::pow(next.samples / limit, 1.5) <= target; };
    while (next.rmse > target && next.samples < limit && in_reach()) {
        last = next;
        next = predict(std::min(2 * next.samples, limit));
    }
    const auto wanted = [&] {  // by a power of at most Monte Carlo's
        const double power = portable::log(next.rmse / last.rmse) / portable::log(next.samples / last.samples);
        return next.samples * portable::pow(target / next.rmse, 1 / std::min(-0.5, power));
    };
    if (next.rmse > target) return {wanted(), target};
    while (last.rmse > target) last = predict(std::clamp(std::ceil(wanted()), last.samples + 1, next.samples));
    return last;
}
}  // namespace bmc::beyond
