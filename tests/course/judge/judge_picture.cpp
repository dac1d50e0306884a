#include "judge_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "command_line.h"
#include "likely_mistakes.h"
#include "mistaken_pictures.h"

namespace {

// Leaves an RMSE of 0.0003, where 40 samples of the best method leave 0.005; of 0.02 under the sun of bright-desert,
// where they leave 0.17.
constexpr std::size_t dense_samples = 2000;

// Away from the seeds that pictures to be judged are made with; so many are enough to know how pictures spread.
constexpr std::uint64_t first_seed = 1000000;
constexpr std::size_t seeds = 40;

// What a picture shows where it shows no object: the environment, without noise. Of floats, 128 values to the largest
// channel of a pixel count as codes: radiance in a Radiance picture has no more.
struct Background {
    double differing;  // fraction of the pixels with a code off by more than 1.5
    double accepted;   // of that fraction
    double offset;     // mean of what the others lack: 1/2 where a program rounds down; 0 for floats
};

Background background_beside(const Truth& expected, const PictureFile& picture) {
    const int maxval = picture.maxval;
    double count = 0, differing = 0, channels = 0, lacking = 0;
    for (std::size_t i = 0; i < picture.image.size(); ++i) {
        if (expected.mask[i]) continue;
        const Color here = picture.image[i], right = expected.image[i];
        const double largest = std::max({right.x, right.y, right.z, 1e-6});
        bool differs = false;
        for (const auto& [a, b] : {std::pair(here.x, right.x), {here.y, right.y}, {here.z, right.z}}) {
            const double missing = maxval > 0 ? maxval * (srgb_encoded(b) - srgb_encoded(a)) : 128 * (b - a) / largest;
            differs = differs || !(std::fabs(missing) <= 1.5);
            if (std::fabs(missing) > 1.5 || b >= 1) continue;
            lacking += missing;
            channels += 1;
        }
        differing += differs;
        count += 1;
    }
    count = std::max(1.0, count);
    return {differing / count, std::max(0.001, 2 / count), channels > 100 && maxval > 0 ? lacking / channels : 0};
}

// Against the environment interpolated, as the truth has it, or its single texels, as the practice's lookup gives:
// whichever the picture is closer to.
Background background_of(const PictureFile& picture, const Truth& truth, const EnvironmentMap& environment) {
    const Camera camera{truth.image.width(), truth.image.height()};
    const auto texel = [&](int x, int y) { return environment.radiance(camera.ray(x, y).direction); };
    const Background interpolated = background_beside(truth, picture),
                     texels = background_beside({image_of(camera.width, camera.height, texel), truth.mask}, picture);
    return texels.differing < interpolated.differing ? texels : interpolated;
}

// A picture of codes as it was before its program rounded it in its own way.
Image unrounded(const PictureFile& picture, double offset) {
    const int maxval = picture.maxval;
    if (maxval == 0) return picture.image;
    return each_channel(picture.image, [&](double linear) {
        const double code = maxval * srgb_encoded(linear);
        if (code < 0.5 || code > maxval - 0.5) return linear;
        return srgb_decoded(std::max(0.0, code + offset) / maxval);
    });
}

// The numbers of so many correct pictures of the settings, as a file with the largest code maxval keeps them.
std::vector<Numbers> correct_numbers(PictureSettings settings, const EnvironmentLight& light, int maxval, const Truth& truth,
                                     std::size_t count, const Progress& progress = nullptr) {
    if (settings.method == Method::direct) {  // a large pool has the same numbers, and is cheaper
        const double n = static_cast<double>(settings.samples);
        settings.method = Method::pool;
        settings.pool = static_cast<std::size_t>(std::clamp(1e8 / (n * n * n), 50.0, 500.0));
    }
    std::vector<Numbers> numbers;
    for (settings.seed = first_seed; numbers.size() < count; ++settings.seed) {
        numbers.push_back(numbers_of(stored(picture(sphere_scene(), light, settings), maxval), truth));
        if (progress) progress(static_cast<double>(numbers.size()) / static_cast<double>(count));
    }
    return numbers;
}

// A picture is then one sample.
bool shares_one_rule(const PictureSettings& settings) {
    return settings.method == Method::single || settings.method == Method::rotated ||
           (settings.method == Method::mc && is_lattice(settings.placement));
}

// More is accepted for one rule, whose numbers have longer tails than normal ones.
Comparison compared(const Numbers& here, const std::vector<Numbers>& correct, const PictureSettings& settings) {
    return compared(here, correct, shares_one_rule(settings) ? Accepted{6, 10} : Accepted{5, 6});
}

// The settings at the picture's size.
PictureSettings sized(PictureSettings settings, const Image& picture) {
    settings.width = picture.width();
    settings.height = picture.height();
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const double objects = object_pixels(sphere_scene(), {settings.width, settings.height});
    if (objects < 500)
        throw std::invalid_argument(formatted("%d x %d pixels are too few to judge: %.0f show an object, 500 should",
                                         settings.width, settings.height, objects));
    return settings;
}

// The other methods, and the same with other numbers of samples: not where one rule serves all pixels, whose pictures
// differ so much from seed to seed that another number explains nearly any.
std::vector<PictureSettings> others(const PictureSettings& settings) {
    std::vector<PictureSettings> all;
    for (const auto& each : method_names) {
        all.push_back(settings);
        all.back().method = each.second;
    }
    if (shares_one_rule(settings)) return all;
    for (const std::size_t samples : {settings.samples / 4, settings.samples / 2, 2 * settings.samples}) {
        all.push_back(settings);
        all.back().samples = std::max<std::size_t>(1, samples);
    }
    return all;
}

// What makes such pictures: a factor, another method or number of samples, whichever correct pictures of are nearest,
// if these would be accepted; or an empty text. numbers(settings, count): of so many correct pictures.
template <class NumbersOf>
std::string resembled(const Image& picture, const Truth& truth, const PictureSettings& settings,
                      const std::vector<Numbers>& correct, NumbersOf numbers) {
    const Numbers here = numbers_of(picture, truth);
    std::string name;
    double least = HUGE_VAL;
    const auto consider = [&](const std::string& text, const Comparison& comparison) {
        const double deviation = comparison["together"].here;
        if (!comparison.fits() || deviation >= least) return;
        least = deviation;
        name = text;
    };
    const double factor = 1 + here[1];
    const std::string reason = factor_name(factor, 0.02);
    const Image as_bright = image_of(settings.width, settings.height, [&](int x, int y) {
        return (truth.shows_object(x, y) ? 1 / factor : 1) * picture(x, y);
    });
    consider(formatted("what shows an object is %.3g times as bright", factor) + (reason.empty() ? "" : ": " + reason),
             compared(numbers_of(as_bright, truth), correct, settings));
    for (const PictureSettings& other : others(settings)) {
        try {
            const Comparison few = compared(here, numbers(other, 6), other);
            if (few["rmse"].fits() && few["brightness"].fits() && few["correlation"].fits())
                consider("the picture is as of " + options_of(other), compared(here, numbers(other, seeds), other));
        } catch (const NotPositiveDefinite&) {
            continue;  // no program makes pictures with so many samples
        }
    }
    return name;
}

// What the pattern of the errors tells, or an empty text.
std::string pattern(const Comparison& comparison) {
    const Lag lag = lag_of(comparison.strangest);
    if (comparison["repeats"].here > comparison["repeats"].high)
        return formatted("random numbers or rules repeat %d columns and %d rows away", lag.x, lag.y);
    if (comparison["rmse"].fits() && (comparison["alike"].here > comparison["alike"].high ||
                                      comparison["correlation"].here > comparison["correlation"].high))
        return "neighbouring pixels share random numbers, or rules that are not turned";
    return "";
}

}  // namespace

std::string options_of(const PictureSettings& settings) {
    return formatted("--method %s --samples %zu", name_of(settings.method, method_names), settings.samples) +
           (settings.method == Method::pool ? formatted(" --pool %zu", settings.pool) : "");
}

PictureJudgement judge_picture(const PictureFile& picture, const EnvironmentMap& environment,
                               const PictureSettings& wanted, const Progress& progress) {
    const PictureSettings settings = sized(wanted, picture.image);
    const PrefilteredEnvironment prefiltered(environment, settings.threads);
    const EnvironmentLight light{environment, &prefiltered};
    const Truth dense = dense_truth(light, settings, dense_samples);
    const double white = picture.maxval > 0 ? 1 : HUGE_VAL;
    const Truth truth{each_channel(dense.image, [&](double v) { return std::min(v, white); }), dense.mask};
    const Background background = background_of(picture, truth, environment);
    const Image image = unrounded(picture, background.offset);
    const Numbers here = numbers_of(image, truth);
    if (!std::isfinite(here[1]))
        throw std::invalid_argument("the environment lights no object, so there is nothing to judge; take another");
    const std::vector<Numbers> correct = correct_numbers(settings, light, picture.maxval, truth, seeds, progress);
    PictureJudgement judgement{compared(here, correct, settings), largest_block_error(image, truth), ""};
    std::vector<Quantity>& quantities = judgement.comparison.quantities;
    quantities.insert(quantities.begin(), {"background", background.differing, 0, 0, 0, background.accepted});
    if (judgement.fits()) return judgement;

    const double rmse = judgement.comparison["rmse"].high;
    const auto numbers = [&](const PictureSettings& other, std::size_t count) {
        return correct_numbers(other, light, picture.maxval, truth, count);
    };
    if (!quantities[0].fits()) {
        judgement.mistake = mistake_of_whole(picture, dense, rmse);
        return judgement;
    }
    judgement.mistake = mistake_of_objects(picture, dense, environment, settings.samples, 1.5 * rmse);
    if (judgement.mistake.empty()) judgement.mistake = resembled(image, truth, settings, correct, numbers);
    if (judgement.mistake.empty()) judgement.mistake = pattern(judgement.comparison);
    return judgement;
}
