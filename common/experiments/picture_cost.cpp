#include "experiments/picture_cost.h"

#include "base/formatted.h"

#include <algorithm>
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

ImageError image_error(const Image& image, const Image& truth) {
    const Camera camera{image.width, image.height};
    double count = 0, true_sum = 0, squares = 0, products = 0, pair_squares = 0;
    Colour sum;
    for_each_hit(camera, [&](int x, int y, const Hit&) {
        const Colour error = image(x, y) - truth(x, y);
        count += 1;
        sum += error;
        true_sum += channel_sum(truth(x, y));
        squares += dot(error, error);
    });
    const Colour mean = 1 / count * sum;
    for_each_hit(camera, [&](int x, int y, const Hit&) {
        if (x + 1 == image.width || !intersect(sphere_scene, camera.ray(x + 1, y))) return;
        const Colour here = image(x, y) - truth(x, y) - mean, next = image(x + 1, y) - truth(x + 1, y) - mean;
        products += dot(here, next);
        pair_squares += (dot(here, here) + dot(next, next)) / 2;
    });
    return {std::sqrt(squares / (3 * count)), pair_squares > 0 ? products / pair_squares : 0,
            channel_sum(sum) / true_sum};
}

static Image picture(const PictureMethod& method, const RenderSettings& settings) {
    return render(EnvironmentMap(1, 1), settings, method.shader(settings));
}

// What is shared between pixels is made once, whatever the size: a picture of one pixel measures its time.
static double seconds_per_megapixel(const PictureMethod& method) {
    const auto seconds_at = [&](int side) {
        RenderSettings settings = method.settings;
        settings.threads = 1;
        settings.width = settings.height = side;
        return time_call([&] { picture(method, settings); });
    };
    const double whole = seconds_at(64), shared = seconds_at(1);
    return shared + 1e6 * std::max(0.0, whole - shared) / pixels_of_objects({64, 64});
}

// More where each seed has but one rule, fewer where they take long.
static std::size_t seeds_of(const RenderSettings& settings) {
    if (settings.width > 128 || (settings.method == Method::direct && settings.samples > 40)) return 4;
    return settings.method == Method::single || settings.method == Method::rotated ? 64 : 16;
}

PictureRow picture_row(const PictureMethod& method, const Image& truth, bool timed) {
    PictureRow row{method.method, method.known, method.settings};
    RenderSettings settings = method.settings;
    for (std::size_t i = 0; i < seeds_of(settings); ++i) {
        ++settings.seed;
        const ImageError error = image_error(picture(method, settings), truth);
        row.rmse.add(error.rmse);
        row.bias.add(error.bias);
        row.correlation.add(error.correlation);
    }
    if (timed) row.seconds_per_megapixel = seconds_per_megapixel(method);
    return row;
}

std::string picture_table(const std::vector<PictureRow>& rows, bool timed) {
    std::string text = formatted(
        "# method  pool placement         known   samples       rmse     +-rmse correlation brightness "
        "mc_samples%s\n",
        timed ? "  s/megapixel efficiency" : "");
    for (const PictureRow& row : rows) {
        const RenderSettings& s = row.settings;
        const PictureRow& mc = *std::find_if(
            rows.begin(), rows.end(), [&](const PictureRow& first) { return first.settings.samples == s.samples; });
        const double rmse = row.rmse.value(), gain = mc.rmse.value() * mc.rmse.value() / (rmse * rmse);
        text += formatted("%-9s %4zu %-17s %-7s %7zu %10.5f %10.5f %11.4f %10.5f %10s", row.method.c_str(), s.pool,
                          s.placement.name().c_str(), row.known.c_str(), s.samples, rmse, row.rmse.standard_error(),
                          row.correlation.mean, row.bias.value(),
                          two_digits(static_cast<double>(s.samples) * gain).c_str());
        if (timed)
            text += formatted(" %12.3g %10.3g", row.seconds_per_megapixel,
                              gain * mc.seconds_per_megapixel / row.seconds_per_megapixel);
        text += '\n';
    }
    return text;
}
}  // namespace bmc
