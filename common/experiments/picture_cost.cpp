#include "experiments/picture_cost.h"

#include <chrono>

namespace bmc {
double time_call(const std::function<void()>& action) {
    using Clock = std::chrono::steady_clock;
    double fewest = 1e300, all = 0;
    for (int calls = 0; calls < 4 || all < 8e-3; ++calls) {
        const auto start = Clock::now();
        action();
        const std::chrono::duration<double> seconds = Clock::now() - start;
        fewest = std::min(fewest, seconds.count());
        all += seconds.count();
    }
    return fewest;
}

// The rules are made once, whatever the size: a picture of one pixel measures their time.
static double seconds_per_megapixel(PictureCost picture) {
    picture.settings.threads = 1;
    const auto seconds_at = [&](int side) {
        picture.settings.width = picture.settings.height = side;
        return time_call([&] { picture.image(picture.settings); });
    };
    double pixels = 0;
    for_each_hit(sphere_scene, {64, 64}, [&](int, int, const Hit&) { ++pixels; });
    const double whole = seconds_at(64), rules = seconds_at(1);
    return rules + 1e6 * std::max(0.0, whole - rules) / pixels;
}

// More where each seed has but one rule, fewer where they take long.
static std::size_t seeds_of(const RenderSettings& settings) {
    if (settings.width > 128 || (settings.method == Method::direct && settings.samples > 40)) return 4;
    return settings.method == Method::single || settings.method == Method::rotated ? 64 : 16;
}

CostSettings taken_costs(Arguments& arguments) {
    CostSettings s;
    arguments.add("environment", "FILE", "one light, as for the renderer (default: each built-in light)",
                  s.environment);
    arguments.add("size", "W", "size of the pictures: W x W pixels", s.size, 2, 1024);
    arguments.add("seed", "K", "seed of the random numbers", s.seed, 0, UINT64_MAX);
    arguments.add("no-times", "leave out measured times, which differ from run to run", s.untimed);
    add_sample_list(arguments, s.sample_counts);
    arguments.take();
    return s;
}

std::string picture_report(const CostSettings& costs, PictureTable table) {
    const auto names = costs.environment.empty() ? light_names() : std::vector{costs.environment};
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : "\n\n") + table(costs, name, load_environment(name));
    return text;
}

std::string measured_table(const CostSettings& costs, const std::vector<PictureCost>& compared, const Image& truth) {
    Progress progress("rows", compared.size() * costs.sample_counts.size());
    std::vector<PictureCost> rows;
    for (const PictureCost& picture : compared)
        for (const std::size_t n : costs.sample_counts) {
            rows.push_back(measured_picture(picture, n, costs, truth));
            progress.done();
        }
    return picture_table(rows, !costs.untimed);
}

RenderSettings row_settings(const CostSettings& costs, RenderSettings settings, std::size_t samples) {
    settings.samples = samples;
    settings.seed = 1000 * (costs.seed - 1);
    settings.width = settings.height = costs.size;
    return settings;
}

ImageError image_error(const Image& image, const Image& truth) {
    const Camera camera{image.width, image.height};
    double count = 0, true_sum = 0, squares = 0, products = 0, pair_squares = 0;
    Colour sum;
    for_each_hit(sphere_scene, camera, [&](int x, int y, const Hit&) {
        const Colour error = image(x, y) - truth(x, y);
        count += 1;
        sum += error;
        true_sum += dot(truth(x, y), {1, 1, 1});
        squares += dot(error, error);
    });
    const Colour mean = 1 / count * sum;
    for_each_hit(sphere_scene, camera, [&](int x, int y, const Hit&) {
        if (x + 1 == image.width || !intersect(sphere_scene, camera.ray(x + 1, y))) return;
        const Colour here = image(x, y) - truth(x, y) - mean, next = image(x + 1, y) - truth(x + 1, y) - mean;
        products += dot(here, next);
        pair_squares += (dot(here, here) + dot(next, next)) / 2;
    });
    return {std::sqrt(squares / (3 * count)), pair_squares > 0 ? products / pair_squares : 0,
            (sum.x + sum.y + sum.z) / true_sum};
}

PictureCost compared_picture(const EnvironmentMap& light, Method method, std::size_t pool, Placement placement) {
    RenderSettings settings;
    settings.method = method;
    settings.pool = pool;
    settings.placement = placement;
    return {settings, name_of(method, method_names),
            [&light](const RenderSettings& s) { return render(light, s, environment_shader(light, PixelRules(s))); }};
}

std::vector<PictureCost> compared_pictures(const EnvironmentMap& light) {
    constexpr Placement uniform, cosine{PointSet::random, Density::cosine};
    std::vector<PictureCost> pictures{
        compared_picture(light, Method::mc, 1, uniform),      compared_picture(light, Method::mc, 1, cosine),
        compared_picture(light, Method::direct, 1, uniform),  compared_picture(light, Method::single, 1, uniform),
        compared_picture(light, Method::rotated, 1, uniform), compared_picture(light, Method::pool, 5, uniform),
        compared_picture(light, Method::pool, 20, uniform),   compared_picture(light, Method::pool, 20, cosine)};
    for (const PointSet set : {PointSet::stratified, PointSet::fibonacci, PointSet::optimised}) {
        const Placement placement{set, Density::cosine};
        pictures.push_back(compared_picture(light, Method::mc, 1, placement));
        pictures.push_back(compared_picture(light, Method::pool, placement.is_fixed() ? 1 : 20, placement));
    }
    return pictures;
}

PictureCost measured_picture(PictureCost picture, std::size_t samples, const CostSettings& costs, const Image& truth) {
    if (!(image_error(truth, truth).brightness == 0))  // 0 / 0
        throw std::runtime_error("the environment lights no object, so there is no error to compare; take another");
    RenderSettings settings = picture.settings = row_settings(costs, picture.settings, samples);
    for (std::size_t i = 0; i < seeds_of(settings); ++i) {
        ++settings.seed;
        const ImageError error = image_error(picture.image(settings), truth);
        picture.rmse.add(error.rmse);
        picture.brightness.add(error.brightness);
        picture.correlation.add(error.correlation);
    }
    if (!costs.untimed) picture.seconds_per_megapixel = seconds_per_megapixel(picture);
    return picture;
}

std::string picture_table(const std::vector<PictureCost>& rows, bool timed) {
    std::string text = formatted(
        "# method  pool placement         known   samples       rmse     +-rmse correlation brightness "
        "mc_samples%s\n",
        timed ? "  s/megapixel efficiency" : "");
    for (const PictureCost& row : rows) {
        const RenderSettings& s = row.settings;
        const PictureCost& mc = *std::find_if(
            rows.begin(), rows.end(), [&](const PictureCost& first) { return first.settings.samples == s.samples; });
        const char* const known = row.light_known                          ? "light"
                                  : s.placement.density == Density::cosine ? "cosine"
                                                                           : "nothing";
        const double rmse = row.rmse.value(), gain = mc.rmse.value() * mc.rmse.value() / (rmse * rmse);
        text += formatted("%-9s %4zu %-17s %-7s %7zu %10.5f %10.5f %11.4f %10.5f %10s", row.method_column, s.pool,
                          s.placement.name().c_str(), known, s.samples, rmse, row.rmse.standard_error(),
                          row.correlation.mean, row.brightness.value(),
                          two_digits(static_cast<double>(s.samples) * gain).c_str());
        if (timed)
            text += formatted(" %12.3g %10.3g", row.seconds_per_megapixel,
                              gain * mc.seconds_per_megapixel / row.seconds_per_megapixel);
        text += '\n';
    }
    return text;
}
}  // namespace bmc
