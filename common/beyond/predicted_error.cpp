#include "beyond/predicted_error.h"

namespace bmc::beyond {
Shader sun_shader(const EnvironmentMap& map, RenderSettings settings, std::size_t rays) {
    settings.method = Method::mc;
    settings.placement = {PointSet::fibonacci, KnownPart::cosine};
    const auto sun = std::make_shared<const Sun>(map, 4);  // with the edge of a disc, which a lattice would rarely meet
    return [=, sky = sun->sky(map), rules = PixelRules(settings)](const Hit& hit, int x, int y) {
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
}  // namespace bmc::beyond
