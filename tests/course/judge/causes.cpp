#include "causes.h"

#include <array>

#include "command_line.h"
#include "fingerprint.h"
#include "likely_mistakes.h"
#include "picture_file.h"
#include "quadrature/hemisphere.h"

namespace bmc {
namespace {

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

}  // namespace

void explain_whole(const Image& picture, const Truth& truth, int maxval, const Consider& consider) {
    const int width = picture.width(), height = picture.height();
    const auto undo = [&](const char* cause, auto pixel) { consider({cause, image_of(width, height, pixel), truth}); };
    const auto encode = [&](const char* cause, auto f) {
        consider(
            {cause, picture, {each_channel(truth.image, [&](double v) { return f(std::min(v, 1.0)); }), truth.mask}});
    };
    for (const Mirroring& mirroring : mirrorings)
        undo(mirroring.name, [&](int x, int y) {
            return picture(mirroring.left_right ? width - 1 - x : x, mirroring.up_down ? height - 1 - y : y);
        });
    undo("red and blue exchanged", [&](int x, int y) {
        const Color color = picture(x, y);
        return Color{color.z, color.y, color.x};
    });
    encode(maxval > 0 ? "encoded by the sRGB curve twice" : "sRGB codes in a PFM, which holds linear values",
           srgb_encoded);
    consider({"the background is black", picture, times(1, 0, truth)});
    if (maxval == 0) return;
    encode("linear values in a PPM, which holds sRGB codes", srgb_decoded);
    encode("encoded by a gamma of 2.2 in place of the sRGB curve",
           [](double v) { return srgb_decoded(portable::pow(v, 1 / 2.2)); });
}

void explain_objects(const Image& picture, const Truth& truth, const EnvironmentMap& environment, std::size_t samples,
                     const Consider& consider) {
    const std::vector<Vec3> directions = fibonacci_directions(300);
    std::vector<Truth> wrong(std::size(wrong_integrands), truth);
    for_each_hit(sphere_scene(), {picture.width(), picture.height()}, [&](int x, int y, const Hit& hit) {
        const auto ratios = wrong_ratios(hit, environment, directions, 0.618 * (y * picture.width() + x));
        for (std::size_t i = 0; i < wrong.size(); ++i) wrong[i].image.set(x, y, ratios[i] * truth.image(x, y));
    });
    for (std::size_t i = 0; i < wrong.size(); ++i) consider({wrong_integrands[i], picture, wrong[i]});
    const double n = static_cast<double>(samples), weight = 2 * portable::pi / n;
    std::vector<Factor> all(std::begin(factors), std::end(factors));
    all.insert(all.end(), {{"nothing is added up", 0}, {"not divided by N", n}, {"divided by N twice", 1 / n}});
    all.insert(all.end(), {{"2 pi / N too often", weight}, {"2 pi / N is missing", 1 / weight}});
    for (const Factor& each : all) {  // with those that a picture may not tell from it: 40 is about 4 pi^2
        std::string cause = formatted("one factor for all objects, %.3g", each.factor), before = ": perhaps ";
        for (const auto& [reason, factor] : all)
            if (std::fabs(factor - each.factor) <= 0.04 * each.factor) cause += std::exchange(before, "; or ") + reason;
        consider({cause, picture, times(each.factor, 1, truth)});
    }
}
}  // namespace bmc
