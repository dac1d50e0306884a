#include "judge/judge_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "experiments/command.h"
#include "experiments/picture_error.h"
#include "judge/background.h"
#include "judge/correct_pictures.h"
#include "judge/likely_mistakes.h"
#include "judge/mistaken_pictures.h"

namespace {

// More for one rule, whose numbers have longer tails than normal ones.
Accepted accepted_of(const RenderSettings& settings) {
    return shares_one_rule(settings) ? Accepted{6, 10} : Accepted{5, 6};
}

Comparison compared(const Numbers& here, const std::vector<Numbers>& correct, const RenderSettings& settings) {
    return compared(here, correct, accepted_of(settings));
}

// The settings at the picture's size.
RenderSettings sized(RenderSettings settings, const Image& picture) {
    settings.width = picture.width();
    settings.height = picture.height();
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const double objects = object_pixels(sphere_scene(), settings.width, settings.height);
    if (objects < 500)
        throw std::invalid_argument(line("%d x %d pixels are too few to judge: %.0f show an object, 500 should",
                                         settings.width, settings.height, objects));
    return settings;
}

Image clamped(Image image) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Color c = image(x, y);
            image.set(x, y, {std::min(c.x, 1.0), std::min(c.y, 1.0), std::min(c.z, 1.0)});
        }
    return image;
}

// The other methods, and the same with other numbers of samples: not where one rule serves all pixels, whose pictures
// differ so much from seed to seed that another number explains nearly any.
std::vector<RenderSettings> others(const RenderSettings& settings) {
    std::vector<RenderSettings> all;
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

// The picture with its objects so many times as bright.
Image brightened(const Image& picture, const Truth& truth, double factor) {
    Image image = picture;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (truth.shows_object(x, y)) image.set(x, y, factor * picture(x, y));
    return image;
}

// What makes such pictures: a factor, another method or number of samples, whichever correct pictures of are nearest,
// if these would be accepted; or an empty text.
std::string resembled(const Image& picture, const Truth& truth, const RenderSettings& settings,
                      const std::vector<Numbers>& correct, const Studio& studio) {
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
    const std::string reason = factor_name(factor, factors, 0.02);
    consider(line("what shows an object is %.3g times as bright", factor) + (reason.empty() ? "" : ": " + reason),
             compared(numbers_of(brightened(picture, truth, 1 / factor), truth), correct, settings));
    for (const RenderSettings& other : others(settings)) {
        try {
            const Comparison few = compared(here, studio.numbers(other, truth, 6), other);
            if (few["rmse"].fits() && few["brightness"].fits() && few["correlation"].fits())
                consider("the picture is as of " + options_of(other),
                         compared(here, studio.numbers(other, truth, seeds), other));
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
        return line("random numbers or rules repeat %d columns and %d rows away", lag.x, lag.y);
    if (comparison["rmse"].fits() && (comparison["alike"].here > comparison["alike"].high ||
                                      comparison["correlation"].here > comparison["correlation"].high))
        return "neighbouring pixels share random numbers, or rules that are not turned";
    return "";
}

}  // namespace

PictureJudgement judge_picture(const PictureFile& picture, const EnvironmentMap& environment,
                               const RenderSettings& wanted, const Progress& progress) {
    const RenderSettings settings = sized(wanted, picture.image);
    const Studio studio(environment, picture.maxval);
    const Truth dense{studio.dense(settings), object_mask(sphere_scene(), settings.width, settings.height)};
    const Truth truth{picture.maxval > 0 ? clamped(dense.image) : dense.image, dense.mask};
    const Background background = background_of(picture, truth, environment);
    const Image image =
        picture.maxval > 0 ? unrounded(picture.image, picture.maxval, background.offset) : picture.image;
    const Numbers here = numbers_of(image, truth);
    if (!std::isfinite(here[1]))
        throw std::invalid_argument("the environment lights no object, so there is nothing to judge; take another");
    const std::vector<Numbers> correct = studio.numbers(settings, truth, seeds, progress);
    PictureJudgement judgement{compared(here, correct, settings), largest_block_error(image, truth), ""};
    std::vector<Quantity>& quantities = judgement.comparison.quantities;
    quantities.insert(quantities.begin(), {"background", background.differing, 0, 0, 0, background.accepted});
    if (judgement.fits()) return judgement;

    const double rmse = judgement.comparison["rmse"].high;
    if (!quantities[0].fits()) {
        judgement.mistake = mistake_of_whole(picture, dense, rmse);
        return judgement;
    }
    judgement.mistake = mistake_of_objects(picture, dense, environment, settings.samples, 1.5 * rmse);
    if (judgement.mistake.empty()) judgement.mistake = resembled(image, truth, settings, correct, studio);
    if (judgement.mistake.empty()) judgement.mistake = pattern(judgement.comparison);
    return judgement;
}
