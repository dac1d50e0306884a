#include "experiments/picture_cost.h"

#include "experiments/picture_error.h"
#include "numerics/progress.h"
#include "numerics/statistics.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace bmc {
// The rules are made once, whatever the size: a picture of one pixel measures their time.
static double seconds_per_megapixel(const ComparedPicture& picture, RenderSettings settings) {
    settings.threads = 1;
    Progress uncounted(1, 0);
    const auto seconds_at = [&](int side) {
        settings.width = settings.height = side;
        return time_call([&] { picture.image(settings); });
    };
    double pixels = 0;
    for_each_hit(sphere_scene(), {64, 64}, [&](int, int, const Hit&) { ++pixels; });
    const double whole = seconds_at(64), rules = seconds_at(1);
    return rules + 1e6 * std::max(0.0, whole - rules) / pixels;
}

static PictureCost picture_cost(const ComparedPicture& picture, RenderSettings settings, const Image& truth) {
    RootMeanSquare rmse, brightness;
    Statistics correlation;
    Progress progress(static_cast<double>(seeds_of(settings)));
    for (const std::uint64_t end = settings.seed + seeds_of(settings); settings.seed != end; ++settings.seed) {
        const ImageError error = image_error(picture.image(settings), truth);
        rmse.add(error.rmse);
        brightness.add(error.brightness);
        correlation.add(error.correlation);
        progress.done();
    }
    return {settings, picture.known, rmse.value(), rmse.standard_error(), correlation.mean, brightness.value(), 0};
}

Options cost_options(CostSettings& costs) {
    return {{"size", "W", "of the pictures, W x W pixels (default 64)",
             [&](const std::string& text) { costs.size = static_cast<int>(parse_integer(text, 2, 1024)); }},
            {"seed", "K", "seed of the random numbers (default 1)",
             [&](const std::string& text) { costs.seed = parse_integer(text, 0, UINT64_MAX); }},
            {"no-times", "", "leaves out what is measured and differs from run to run",
             [&](const std::string&) { costs.timed = false; }}};
}

RenderSettings row_settings(const CostSettings& costs, RenderSettings settings, std::size_t samples) {
    settings.samples = samples;
    settings.seed = 1000 * (costs.seed - 1) + 1;
    settings.width = settings.height = costs.size;
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    return settings;
}

// If pixels share rules, 64 rules make the standard error of the RMSE a few per cent of it. Otherwise every pixel is a
// sample, and the seeds are for the brightness. Fewer seeds where they would take long.
std::uint64_t seeds_of(const RenderSettings& settings) {
    if (settings.width > 128 || (settings.method == Method::direct && settings.samples > 40)) return 4;
    if (settings.method == Method::direct || (settings.method == Method::mc && !is_lattice(settings.placement)))
        return 16;
    return std::max<std::uint64_t>(16, 64 / settings.pool);
}

ComparedPicture compared_picture(const EnvironmentMap& light, Method method, std::size_t pool, Placement placement,
                                 Known known) {
    RenderSettings settings;
    settings.method = method;
    settings.pool = pool;
    settings.placement = placement;
    settings.known = known;
    return {settings, name_of(known, known_names), [&light](const RenderSettings& s) { return picture(light, s); }};
}

std::vector<ComparedPicture> compared_pictures(const EnvironmentMap& light) {
    std::vector<ComparedPicture> list;
    const auto add = [&](Method method, std::size_t pool, Placement placement, Known known = Known::nothing) {
        list.push_back(compared_picture(light, method, pool, placement, known));
    };
    add(Method::mc, 1, Placement::uniform);
    add(Method::mc, 1, Placement::cosine);
    add(Method::direct, 1, Placement::uniform);
    add(Method::single, 1, Placement::uniform);
    add(Method::rotated, 1, Placement::uniform);
    add(Method::pool, 5, Placement::uniform);
    add(Method::pool, 20, Placement::uniform);
    add(Method::pool, 20, Placement::cosine, Known::cosine);
    add(Method::mc, 1, Placement::fibonacci);
    add(Method::pool, 20, Placement::fibonacci);
    add(Method::mc, 1, Placement::cosine_fibonacci);
    add(Method::pool, 20, Placement::cosine_fibonacci, Known::cosine);
    return list;
}

double time_call(const std::function<void()>& action) {
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

std::vector<PictureCost> picture_costs(const std::vector<ComparedPicture>& compared,
                                       const std::vector<std::size_t>& samples, const CostSettings& costs,
                                       const Image& truth) {
    if (!(image_error(truth, truth).brightness == 0))  // 0 / 0
        throw std::runtime_error("the environment lights no object, so there is no error to compare; take another");
    std::vector<PictureCost> rows;
    Progress progress(static_cast<double>(compared.size() * samples.size()), table_parts);
    for (const ComparedPicture& each : compared)
        for (const std::size_t n : samples) {
            const RenderSettings settings = row_settings(costs, each.settings, n);
            rows.push_back(picture_cost(each, settings, truth));
            progress.done();
            if (costs.timed) rows.back().seconds_per_megapixel = seconds_per_megapixel(each, settings);
        }
    return rows;
}

std::string picture_table(const std::vector<PictureCost>& rows, bool timed, const char* more_heading,
                          const std::vector<std::string>& more) {
    std::string text = formatted(
        "# method  pool placement        known   samples       rmse     +-rmse correlation brightness mc_samples%s%s\n",
        more_heading, timed ? "  s/megapixel efficiency" : "");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const PictureCost& row = rows[i];
        const RenderSettings& s = row.settings;
        const PictureCost& mc = *std::find_if(
            rows.begin(), rows.end(), [&](const PictureCost& first) { return first.settings.samples == s.samples; });
        const double gain = mc.rmse * mc.rmse / (row.rmse * row.rmse);
        text +=
            formatted("%-8s %5zu %-16s %-7s %7zu %10.5f %10.5f %11.4f %10.5f %10.4g", name_of(s.method, method_names),
                      s.pool, name_of(s.placement, placement_names), row.known, s.samples, row.rmse, row.rmse_error,
                      row.correlation, row.brightness, static_cast<double>(s.samples) * gain);
        if (!more.empty()) text += more[i];
        if (timed)
            text += formatted(" %12.3g %10.3g", row.seconds_per_megapixel,
                              gain * mc.seconds_per_megapixel / row.seconds_per_megapixel);
        text += '\n';
    }
    return text;
}
}  // namespace bmc
