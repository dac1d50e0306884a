#include "judge_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "command_line.h"
#include "quadrature/hemisphere.h"

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
    double outline;    // share of these with an object at most two columns or rows away
    double down;       // how many more values show codes that are rounded down than to the nearest; 0 tells nothing

    bool fits() const { return differing <= accepted; }
};

// Of floats, 128 values to the largest channel of a pixel count as codes: radiance in a Radiance picture has no more.
Background background_of(const Image& picture, const Truth& truth, int maxval) {
    double count = 0, differing = 0, outline = 0, down = 0;
    const int width = picture.width(), height = picture.height();
    const auto shows_object = [&](int x, int y) {
        return truth.shows_object(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
    };
    for (std::size_t i = 0; i < picture.size(); ++i) {
        if (truth.mask[i]) continue;
        const Color measured = picture[i], right = truth.image[i];
        const double largest = std::max({right.x, right.y, right.z, 1e-6});
        bool differs = false, beside = false;
        for (const auto channel : channels) {
            const double a = measured.*channel, b = right.*channel;
            const double missing = maxval > 0 ? maxval * (srgb_encoded(b) - srgb_encoded(a)) : 128 * (b - a) / largest;
            differs = differs || !(std::fabs(missing) <= 1.5);
            if (b < 1 && std::fabs(missing) < 1) down += missing > 0.5 ? 1 : missing < 0 ? -1 : 0;
        }
        differing += differs;
        const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
        for (int d = -2; d <= 2; ++d) beside = beside || shows_object(x + d, y) || shows_object(x, y + d);
        outline += differs && beside;
        count += 1;
    }
    count = std::max(1.0, count);
    return {differing / count, std::max(0.001, 2 / count), outline / std::max(1.0, differing), down};
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
    const Image image =
        each_channel(picture, [&](double linear) {  // half a code brighter, as before it was rounded down
            const double code = rounds_down ? maxval * srgb_encoded(linear) : 0;
            return code < 0.5 || code > maxval - 0.5 ? linear : srgb_decoded((code + 0.5) / maxval);
        });
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

// A picture by one rule is one sample, whose numbers have longer tails than normal ones.
Accepted accepted_of(const PictureSettings& settings) {
    return settings.method == Method::single || settings.method == Method::rotated ||
                   (settings.method == Method::mc && is_lattice(settings.placement))
               ? Accepted{6, 10}
               : Accepted{5, 6};
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

constexpr const char* wrong_integrands[] = {"cos(theta) twice", "cos(theta) is missing", "no shadows",
                                            "the albedo is missing"};

// What a point reflects by each of the wrong integrands, over what it should reflect, by the same directions.
std::array<Color, 4> wrong_ratios(const Hit& hit, const EnvironmentMap& environment,
                                  const std::vector<Vec3>& directions, double turns) {
    const Scene scene = sphere_scene();
    const Frame frame = Frame(hit.normal).rotated(turns);
    Color right;
    std::array<Color, 4> wrong;
    for (const Vec3& local : directions) {
        const Vec3 direction = frame.to_world(local);
        const Color light = environment.radiance(direction);
        const double visible = is_shadowed(scene, hit, direction) ? 0 : 1;
        right += visible * local.y * light;
        wrong[0] += visible * local.y * local.y * light;
        wrong[1] += visible * light;
        wrong[2] += local.y * light;
    }
    wrong[3] = {right.x / hit.albedo.x, right.y / hit.albedo.y, right.z / hit.albedo.z};
    for (Color& each : wrong)
        for (const auto channel : channels) each.*channel = right.*channel > 0 ? each.*channel / (right.*channel) : 1;
    return wrong;
}

// The truth with so many times the light of objects and of the background.
Truth times(double objects, double rest, const Truth& truth) {
    const auto pixel = [&](int x, int y) { return (truth.shows_object(x, y) ? objects : rest) * truth.image(x, y); };
    return {image_of(truth.image.width(), truth.image.height(), pixel), truth.mask};
}

// Calls consider with mistakes that change the background too, and with a picture and a truth that would fit: the
// mistake is undone in the one or made in the other.
template <class Consider>
void explain_whole(const Image& picture, const Truth& truth, int maxval, const Consider& consider) {
    const int width = picture.width(), height = picture.height();
    const auto undo = [&](const char* cause, auto pixel) { consider(cause, image_of(width, height, pixel), truth); };
    const auto encode = [&](const char* cause, auto f) {
        const Image made = each_channel(truth.image, [&](double v) { return f(std::min(v, 1.0)); });
        consider(cause, picture, Truth{made, truth.mask});
    };
    undo("upside down", [&](int x, int y) { return picture(x, height - 1 - y); });
    undo("mirrored, left for right", [&](int x, int y) { return picture(width - 1 - x, y); });
    undo("turned by 180 degrees", [&](int x, int y) { return picture(width - 1 - x, height - 1 - y); });
    undo("red and blue exchanged", [&](int x, int y) {
        return Color{picture(x, y).z, picture(x, y).y, picture(x, y).x};
    });
    encode(maxval > 0 ? "encoded by the sRGB curve twice" : "sRGB codes in a PFM, which holds linear values",
           srgb_encoded);
    consider("the background is black", picture, times(1, 0, truth));
    if (maxval == 0) return;
    encode("linear values in a PPM, which holds sRGB codes", srgb_decoded);
    encode("encoded by a gamma of 2.2 in place of the sRGB curve",
           [](double v) { return srgb_decoded(portable::pow(v, 1 / 2.2)); });
}

// Those that change objects only, in pictures with so many samples a pixel.
template <class Consider>
void explain_objects(const Image& picture, const Truth& truth, const EnvironmentMap& environment, std::size_t samples,
                     const Consider& consider) {
    const std::vector<Vec3> directions = fibonacci_directions(300);
    std::vector<Truth> wrong(std::size(wrong_integrands), truth);
    for_each_hit(sphere_scene(), {picture.width(), picture.height()}, [&](int x, int y, const Hit& hit) {
        const auto ratios = wrong_ratios(hit, environment, directions, 0.618 * (y * picture.width() + x));
        for (std::size_t i = 0; i < wrong.size(); ++i) wrong[i].image.set(x, y, ratios[i] * truth.image(x, y));
    });
    for (std::size_t i = 0; i < wrong.size(); ++i) consider(wrong_integrands[i], picture, wrong[i]);
    const double n = static_cast<double>(samples), weight = 2 * portable::pi / n;
    const std::pair<const char*, double> factors[] = {{"1 / pi is missing, or pi too often", portable::pi},
                                                      {"divided by pi once too often", 1 / portable::pi},
                                                      {"weights pi / N in place of 2 pi / N", 0.5},
                                                      {"weights 4 pi / N in place of 2 pi / N, or added twice", 2},
                                                      {"2 pi too often", 2 * portable::pi},
                                                      {"2 pi is missing", 1 / (2 * portable::pi)},
                                                      {"nothing is added up", 0},
                                                      {"not divided by N", n},
                                                      {"divided by N twice", 1 / n},
                                                      {"2 pi / N too often", weight},
                                                      {"2 pi / N is missing", 1 / weight}};
    for (const auto& each : factors) {  // with those that a picture may not tell from it: 40 is about 4 pi^2
        std::string cause = formatted("one factor for all objects, %.3g", each.second), before = ": perhaps ";
        for (const auto& [reason, factor] : factors)
            if (std::fabs(factor - each.second) <= 0.04 * each.second) cause += std::exchange(before, "; or ") + reason;
        consider(cause, picture, times(each.second, 1, truth));
    }
}

// The explanation that the picture is nearest to, or an empty text. Where the background proves it, the objects need
// only be nearer to it than to the truth; otherwise nearly as near as correct pictures are, and not mostly white.
std::string cause_of(const PictureFile& picture, const View& view, const Expected& expected, const Comparison& beside) {
    const bool is_proof = !view.background.fits();
    if (!is_proof && is_as_bright(view.fingerprint, expected)) return "";
    std::string cause;
    double least = HUGE_VAL;
    const auto consider = [&](const std::string& mistake, const Image& image, const Truth& truth) {
        const View explained = view_of(image, truth, picture.maxval, view.rounds_down);
        const Fingerprint& measured = explained.fingerprint;
        const double share = 1.3 * explained.light / view.light;
        const bool is_near = !(explained.lost > 0.5) && is_as_bright(measured, expected, 1.5, 0.04) &&
                             measured[rmse_number] <= share * beside["rmse"].high &&
                             measured[block_number] <= share * beside["block"].high;
        const bool is_nearer = is_proof && measured[rmse_number] < 0.98 * view.fingerprint[rmse_number];
        if (!explained.background.fits() || measured[rmse_number] >= least || !(is_nearer || is_near)) return;
        least = 0.98 * measured[rmse_number];
        cause = mistake;
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
    if (beside["correlation"].measured > std::max(0.5, beside["correlation"].high) &&
        beside["rmse"].measured >= beside["rmse"].low && view.fingerprint[roughness_number] < 0.6 * roughness)
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

Expected expect(const EnvironmentLight& light, PictureSettings settings, const PictureFile& file,
                const Progress& progress) {
    const Camera camera{file.image.width(), file.image.height()};
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
    Expected expected{settings, file.maxval, accepted_of(settings), {truth, texels}, &light.environment, {}};
    if (view_of(file.image, truth, 0).light == 0)
        throw std::invalid_argument("the environment lights no object, so there is nothing to judge; take another");
    if (settings.method == Method::direct) {  // a large pool has the same numbers, and is cheaper
        const double n = static_cast<double>(settings.samples);
        settings.method = Method::pool;
        settings.pool = static_cast<std::size_t>(std::clamp(1e8 / (n * n * n), 50.0, 500.0));
    }
    for (; expected.correct.size() < seeds; ++settings.seed) {
        const Image stored = as_stored(picture(sphere_scene(), light, settings), expected.maxval);
        expected.correct.push_back(view_of(stored, expected.truths[0], expected.maxval).fingerprint);
        if (progress) progress(static_cast<double>(expected.correct.size()) / static_cast<double>(seeds));
    }
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
