#include "judge_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "command_line.h"
#include "prediction/predicted_error.h"

namespace bmc {
namespace {

// Leaves an RMSE of 0.0003, where 40 samples of the best method leave 0.005; of 0.02 under the sun of bright-desert,
// where they leave 0.17.
constexpr std::size_t dense_samples = 2000;

// Away from the seeds that pictures to be judged are made with; so many are enough to know how pictures spread.
constexpr std::uint64_t first_seed = 1000000;
constexpr std::size_t seeds = 40;

// What a picture shows where it shows no object: the environment, without noise.
struct Background {
    double differing;  // fraction of the pixels with a code off by more than 1.5
    double accepted;   // of that fraction
    double outline;    // share of these that are at most two columns or rows from an object
    double down;       // how many more values show codes that are rounded down than to the nearest; 0 tells nothing

    bool fits() const { return differing <= accepted; }
};

// Of floats, 128 values to the largest channel of a pixel count as codes: radiance in a Radiance picture has no more.
Background background_of(const Image& picture, const Truth& truth, int maxval) {
    double count = 0, differing = 0, outline = 0, down = 0;
    const int width = picture.width(), height = picture.height();
    const auto near_object = [&](int x, int y) {
        for (int i = std::max(0, y - 2); i <= std::min(height - 1, y + 2); ++i)
            for (int j = std::max(0, x - 2); j <= std::min(width - 1, x + 2); ++j)
                if (truth.shows_object(j, i)) return true;
        return false;
    };
    for (std::size_t i = 0; i < picture.size(); ++i) {
        if (truth.mask[i]) continue;
        const Color measured = picture[i], right = truth.image[i];
        const double largest = std::max({right.x, right.y, right.z, 1e-6});
        bool differs = false;
        for (const auto channel : channels) {
            const double a = measured.*channel, b = right.*channel;
            const double missing = maxval > 0 ? maxval * (srgb_encoded(b) - srgb_encoded(a)) : 128 * (b - a) / largest;
            differs = differs || !(std::fabs(missing) <= 1.5);
            if (b < 1 && std::fabs(missing) < 1) down += missing > 0.5 ? 1 : missing < 0 ? -1 : 0;
        }
        differing += differs;
        outline += differs && near_object(static_cast<int>(i) % width, static_cast<int>(i) / width);
        count += 1;
    }
    count = std::max(1.0, count);
    return {differing / count, std::max(0.001, 2 / count), outline / std::max(1.0, differing), down};
}

// A picture of codes, half a code brighter: as it was before its program rounded codes down.
Image undo_rounding(const Image& picture, int maxval) {
    return each_channel(picture, [&](double linear) {
        const double code = maxval * srgb_encoded(linear);
        return code < 0.5 || code > maxval - 0.5 ? linear : srgb_decoded((code + 0.5) / maxval);
    });
}

// A picture beside what its file can hold of a truth.
struct View {
    const Truth* truth;
    Background background;
    bool rounds_down;
    Fingerprint fingerprint;
    BlockError block;
    double light, lost;  // root mean square of the truth, and the share of its light that is beyond white
};
View view_of(const Image& picture, const Truth& whole, int maxval, bool rounds_down = false) {
    const auto hold = [&](double v) { return maxval > 0 ? std::min(v, 1.0) : v; };
    const Truth truth{each_channel(whole.image, hold), whole.mask};
    const Background background = background_of(picture, truth, maxval);
    const Image image = rounds_down ? undo_rounding(picture, maxval) : picture;
    const double light = image_error(Image(image.width(), image.height()), truth).rmse,
                 lost = -image_error(truth.image, whole).brightness;
    return {&whole, background, rounds_down, fingerprint(image, truth), largest_block_error(image, truth), light, lost};
}

// The view of a picture that is nearest to correct ones: with an interpolated background or with texels, with codes
// that are rounded to the nearest or down. If the background does not tell how codes are rounded, the brightness does.
View nearest_view(const PictureFile& picture, const Expected& expected) {
    const auto view = [&](std::size_t truth, bool down) {
        return view_of(picture.image, expected.truths[truth], picture.maxval, down);
    };
    const View interpolated = view(0, false), texels = view(1, false);
    const bool shows_texels = texels.background.differing < interpolated.background.differing;
    const View& nearest = shows_texels ? texels : interpolated;
    if (picture.maxval == 0 || nearest.background.down < 0) return nearest;
    const View down = view(shows_texels, true);
    const double mean = spread_of(expected.correct, brightness_number).mean;
    const auto error = [&](const View& each) { return std::fabs(each.fingerprint[brightness_number] - mean); };
    return nearest.background.down > 0 || error(down) < error(nearest) ? down : nearest;
}

// The fingerprints of correct pictures in files of this kind.
std::vector<Fingerprint> correct_fingerprints(const EnvironmentLight& light, const Expected& expected,
                                              const Progress& progress) {
    PictureSettings settings = expected.settings;
    if (settings.method == Method::direct) {  // a large pool has the same numbers, and is cheaper
        const double n = static_cast<double>(settings.samples);
        settings.method = Method::pool;
        settings.pool = static_cast<std::size_t>(std::clamp(1e8 / (n * n * n), 50.0, 500.0));
    }
    std::vector<Fingerprint> correct;
    for (; correct.size() < seeds; ++settings.seed) {
        const Image stored = as_stored(picture(sphere_scene(), light, settings), expected.maxval);
        correct.push_back(view_of(stored, expected.truths[0], expected.maxval).fingerprint);
        if (progress) progress(static_cast<double>(correct.size()) / static_cast<double>(seeds));
    }
    return correct;
}

// A picture by one rule is one sample, whose numbers have longer tails than normal ones.
Accepted accepted_of(const PictureSettings& settings) {
    const bool has_one_rule = settings.method == Method::single || settings.method == Method::rotated ||
                              (settings.method == Method::mc && is_lattice(settings.placement));
    return has_one_rule ? Accepted{6, 10} : Accepted{5, 6};
}

// Whether sphere and rectangle are as bright, colour by colour, as in correct pictures.
bool is_as_bright(const Fingerprint& measured, const Expected& expected, double slack = 1, double most = HUGE_VAL) {
    for (std::size_t i = first_part; i < roughness_number; ++i) {
        const auto [mean, deviation] = spread_of(expected.correct, i);
        const double reach = slack * expected.accepted.deviations * deviation;
        if (!(std::fabs(measured[i] - mean) <= std::min(reach, most))) return false;
    }
    return true;
}

// The explanation that the picture is nearest to, or an empty text. Where the background proves it, the objects need
// only be nearer to it than to the truth; otherwise nearly as near as correct pictures are, and not mostly white.
std::string cause_of(const PictureFile& picture, const View& view, const Expected& expected, const Comparison& beside) {
    const bool is_proof = !view.background.fits();
    if (!is_proof && is_as_bright(view.fingerprint, expected)) return "";
    std::string cause;
    double least = HUGE_VAL;
    const auto consider = [&](const Explanation& explanation) {
        const View explained = view_of(explanation.picture, explanation.truth, picture.maxval, view.rounds_down);
        const Fingerprint& measured = explained.fingerprint;
        const double share = 1.3 * explained.light / view.light;
        const bool is_near = !(explained.lost > 0.5) && is_as_bright(measured, expected, 1.5, 0.04) &&
                             measured[rmse_number] <= share * beside["rmse"].high &&
                             measured[block_number] <= share * beside["block"].high;
        const bool is_nearer = is_proof && measured[rmse_number] < 0.98 * view.fingerprint[rmse_number];
        if (!explained.background.fits() || measured[rmse_number] >= least || !(is_nearer || is_near)) return;
        least = 0.98 * measured[rmse_number];
        cause = explanation.cause;
    };
    for (const Truth& truth : expected.truths)
        if (is_proof) explain_whole(picture.image, truth, picture.maxval, consider);
    if (!is_proof)
        explain_objects(picture.image, *view.truth, *expected.environment, expected.settings.samples, consider);
    return cause;
}

// What the pattern of small errors tells, or an empty text. Neighbours err alike if their noise is shared, and under
// other mistakes too; but these leave their differences as rough as they are.
std::string pattern_of(const View& view, const Expected& expected, const Comparison& beside) {
    const auto is_small = [](double part) { return std::fabs(part) < 0.15; };
    const auto parts = view.fingerprint.begin() + first_part;
    if (!view.background.fits() || !std::all_of(parts, parts + 6, is_small)) return "";
    const Lag lag = lag_of(beside.most_deviating_lag);
    if (beside["repeats"].measured > std::max(0.5, beside["repeats"].high))
        return formatted("random numbers or rules repeat %d columns and %d rows away", lag.x, lag.y);
    const double roughness = spread_of(expected.correct, roughness_number).mean;
    if (beside["correlation"].measured > std::max(0.5, beside["correlation"].high) && beside["rmse"].measured >= beside["rmse"].low &&
        view.fingerprint[roughness_number] < 0.6 * roughness)
        return "neighbouring pixels share random numbers, or rules that are not turned";
    return "";
}

// Where the picture errs: its background; all objects alike; or the part that deviates most, and its colours that do so
// half as much. An empty text if it does so nowhere more than correct pictures.
std::string place_of(const View& view, const Expected& expected, const Comparison& beside) {
    if (!view.background.fits() && view.background.outline > 0.5)
        return "the outline of the objects differs: camera, sphere or rectangle";
    if (!view.background.fits())
        return formatted("it errs most in the background, of which %.3g %% differ", 100 * view.background.differing);
    if (is_as_bright(view.fingerprint, expected)) return "";
    const auto in_words = [](double error) {
        return formatted("%.0f %% too %s", 100 * std::fabs(error), error < 0 ? "dark" : "bright");
    };
    Fingerprint relative = view.fingerprint;  // to the brightness of all objects
    for (std::size_t i = first_part; i < roughness_number; ++i)
        relative[i] = (1 + relative[i]) / (1 + relative[brightness_number]) - 1;
    if (!beside["brightness"].fits() && is_as_bright(relative, expected))
        return "it errs on all objects alike: " + in_words(relative[brightness_number]);
    const auto deviates = [&](std::size_t i) { return spread_of(expected.correct, i).deviations(view.fingerprint[i]); };
    std::size_t most = first_part;
    for (std::size_t i = first_part; i < roughness_number; ++i)
        if (std::fabs(deviates(i)) > std::fabs(deviates(most))) most = i;
    const std::size_t part = (most - first_part) / 3;
    std::size_t i = first_part + 3 * part;
    std::string names;
    for (const char* name : {"red", "green", "blue"})
        if (deviates(i++) / deviates(most) > 0.5) names += (names.empty() ? "" : ", ") + std::string(name);
    return std::string("it errs most on the ") + (part == 0 ? "sphere: " : "rectangle: ") + names + ' ' +
           in_words(view.fingerprint[most]);
}

}  // namespace

Expected expect(const EnvironmentLight& light, PictureSettings settings, const PictureFile& picture,
                const Progress& progress) {
    const Camera camera{picture.image.width(), picture.image.height()};
    settings.width = camera.width;
    settings.height = camera.height;
    settings.seed = first_seed;
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const double objects = object_pixels(sphere_scene(), camera);
    if (objects < 500)
        throw std::invalid_argument(formatted("%d x %d pixels are too few to judge: %.0f show an object, 500 should",
                                              camera.width, camera.height, objects));
    const Truth truth = dense_truth(light, settings, dense_samples);
    const auto texel = [&](int x, int y) {
        return truth.shows_object(x, y) ? truth.image(x, y) : light.environment.radiance(camera.ray(x, y).direction);
    };
    const Truth texels{image_of(camera.width, camera.height, texel), truth.mask};
    Expected expected{settings, picture.maxval, accepted_of(settings), {truth, texels}, &light.environment, {}};
    if (view_of(picture.image, truth, 0).light == 0)
        throw std::invalid_argument("the environment lights no object, so there is nothing to judge; take another");
    expected.correct = correct_fingerprints(light, expected, progress);
    return expected;
}

Judgement judge(const PictureFile& picture, const Expected& expected) {
    const View view = nearest_view(picture, expected);
    Judgement judgement{compare(view.fingerprint, expected.correct, expected.accepted), view.block, ""};
    Comparison& comparison = judgement.comparison;
    comparison.quantities.insert(comparison.quantities.begin(),
                                 {"background", view.background.differing, 0, 0, view.background.accepted});
    if (comparison.fits()) return judgement;
    std::string cause = pattern_of(view, expected, comparison);
    if (cause.empty()) cause = cause_of(picture, view, expected, comparison);
    judgement.reason = cause.empty() ? place_of(view, expected, comparison) : "likely: " + cause;
    return judgement;
}
}  // namespace bmc
