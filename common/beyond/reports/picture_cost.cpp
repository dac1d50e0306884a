#include "beyond/reports/picture_cost.h"

#include "beyond/reports/picture_error.h"
#include "beyond/reports/root_mean_square.h"
#include "command_line/command_line.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace bmc {
static PictureSettings settings_of(Method method, std::size_t pool, Placement placement,
                                   const char* known = "nothing") {
    PictureSettings settings;
    settings.method = method;
    settings.pool = pool;
    settings.placement = placement;
    set_known(settings, known);
    return settings;
}

// The settings with these samples, the size and the seed.
static PictureSettings with_size(const CostSettings& costs, PictureSettings settings, std::size_t samples) {
    settings.samples = samples;
    settings.seed = 1000 * (costs.seed - 1) + 1;
    settings.width = settings.height = costs.size;
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    return settings;
}

// The rules are made once, whatever the size: a picture of one pixel measures their time.
static double seconds_per_megapixel(const EnvironmentLight& light, PictureSettings settings) {
    settings.threads = 1;
    const auto seconds_at = [&](int side) {
        settings.width = settings.height = side;
        return seconds_of([&] { picture(light, settings); });
    };
    double pixels = 0;
    for_each_hit(sphere_scene(), {64, 64}, [&](int, int, const Hit&) { ++pixels; });
    const double whole = seconds_at(64), rules = seconds_at(1);
    return rules + 1e6 * std::max(0.0, whole - rules) / pixels;
}

// If pixels share rules, 64 rules make the standard error of the RMSE a few per cent of it. Otherwise every pixel is a
// sample, and the seeds are for the brightness. Fewer seeds where they would take long.
static std::uint64_t seeds_of(const PictureSettings& settings) {
    if (settings.width > 128 || (settings.method == Method::direct && settings.samples > 40)) return 4;
    if (settings.method == Method::direct || (settings.method == Method::mc && !is_lattice(settings.placement)))
        return 16;
    return std::max<std::uint64_t>(16, 64 / settings.pool);
}

static PictureCost picture_cost(const EnvironmentLight& light, PictureSettings settings, const Image& truth) {
    RootMeanSquare rmse, brightness, predicted;
    Statistics correlation, covered;
    const std::uint64_t end = settings.seed + seeds_of(settings);
    std::optional<Image> before;
    for (; settings.seed != end; ++settings.seed) {
        Image image = picture(light, settings);
        const ImageError error = image_error(image, truth);
        rmse.add(error.rmse);
        brightness.add(error.brightness);
        correlation.add(error.correlation);
        if (before) {
            const Image errors = standard_errors(*before, image);
            predicted.add(root_mean_square(errors));
            covered.add(coverage(image, truth, errors));
        }
        before = std::move(image);
    }
    return {settings,     rmse.value(),     rmse.standard_error(), predicted.value(),
            covered.mean, correlation.mean, brightness.value(),    0};
}

double seconds_of(const std::function<void()>& action) {
    double fewest = HUGE_VAL;
    for (int runs = 0, calls = 1; runs < 4;) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < calls; ++i) action();
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        if (seconds.count() < 2e-3) {
            calls *= 2;
        } else {
            fewest = std::min(fewest, seconds.count() / calls);
            ++runs;
        }
    }
    return fewest;
}

std::vector<PictureSettings> compared_settings(bool all) {
    constexpr auto uniform = Placement::uniform, fibonacci = Placement::fibonacci, cosine = Placement::cosine,
                   cosine_fibonacci = Placement::cosine_fibonacci;
    std::vector<PictureSettings> list{settings_of(Method::mc, 1, uniform),
                                      settings_of(Method::direct, 1, uniform),
                                      settings_of(Method::single, 1, uniform),
                                      settings_of(Method::rotated, 1, uniform),
                                      settings_of(Method::pool, 5, uniform),
                                      settings_of(Method::pool, 20, uniform),
                                      settings_of(Method::mc, 1, fibonacci),
                                      settings_of(Method::pool, 20, fibonacci),
                                      settings_of(Method::pool, 20, cosine_fibonacci, "cosine"),
                                      settings_of(Method::mc, 1, uniform, "light"),
                                      settings_of(Method::pool, 20, uniform, "light"),
                                      settings_of(Method::mc, 1, cosine_fibonacci, "light"),
                                      settings_of(Method::pool, 20, cosine_fibonacci, "light")};
    if (!all) return list;
    list.push_back(settings_of(Method::mc, 1, cosine));
    list.push_back(settings_of(Method::pool, 20, cosine, "cosine"));
    list.push_back(settings_of(Method::mc, 1, cosine_fibonacci));
    return list;
}

std::vector<PictureCost> picture_costs(const EnvironmentMap& environment, const std::vector<PictureSettings>& compared,
                                       const std::vector<std::size_t>& samples, const CostSettings& costs) {
    const EnvironmentLight light(environment, true, std::max(1u, std::thread::hardware_concurrency()));
    const Image truth = dense_truth(environment, with_size(costs, {}, 0), 10000);
    if (!(image_error(truth, truth).brightness == 0))  // 0 / 0
        throw std::runtime_error("the environment lights no object, so there is no error to compare; take another");
    std::vector<PictureCost> rows;
    for (const PictureSettings& each : compared)
        for (const std::size_t n : samples) {
            const PictureSettings settings = with_size(costs, each, n);
            rows.push_back(picture_cost(light, settings, truth));
            if (costs.timed) rows.back().seconds_per_megapixel = seconds_per_megapixel(light, settings);
        }
    return rows;
}

std::string picture_table(const std::vector<PictureCost>& rows, bool timed) {
    std::string text = formatted(
        "# method  pool placement        known   samples       rmse     +-rmse correlation brightness "
        "mc_samples  predicted within%s\n",
        timed ? "  s/megapixel efficiency" : "");
    for (const PictureCost& row : rows) {
        const PictureSettings& s = row.settings;
        const PictureCost& mc = *std::find_if(
            rows.begin(), rows.end(), [&](const PictureCost& first) { return first.settings.samples == s.samples; });
        const double gain = mc.rmse * mc.rmse / (row.rmse * row.rmse);
        text += formatted("%-8s %5zu %-16s %-7s %7zu %10.5f %10.5f %11.4f %10.5f %10.4g %10.5f %6.3f",
                          name_of(s.method, method_names), s.pool, name_of(s.placement, placement_names), known_name(s),
                          s.samples, row.rmse, row.rmse_error, row.correlation, row.brightness,
                          static_cast<double>(s.samples) * gain, row.predicted, row.coverage);
        if (timed)
            text += formatted(" %12.3g %10.3g", row.seconds_per_megapixel,
                              gain * mc.seconds_per_megapixel / row.seconds_per_megapixel);
        text += '\n';
    }
    return text;
}
}  // namespace bmc
