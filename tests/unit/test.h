// What several tests use.
#pragma once

#include "command_line.h"
#include "experiments/picture_error.h"
#include "light/desert.h"
#include "light/radiance_hdr.h"
#include "numerics/plain_loops.h"
#include "prediction.h"

#include <doctest/doctest.h>
#include <getopt.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

using namespace bmc;
using portable::pi;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

inline double relative(double a, double b) { return std::fabs(a / b - 1); }

// ---- Text

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The message of the exception that f throws; empty if it throws none.
template <class Function>
std::string message_of(Function f) {
    try {
        f();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

// What a reader makes of a file with this content, and the message with which it refuses it; empty if it does not.
template <class Result>
struct TextReader {
    Result (*reader)(std::istream&);

    Result operator()(const std::string& content) const {
        std::istringstream in(content);
        return reader(in);
    }
    std::string error(const std::string& content) const {
        return message_of([&] { (*this)(content); });
    }
};

// What the options leave of a program's arguments.
inline std::vector<std::string> parse(std::vector<std::string> words, const std::vector<Option>& options) {
    words.insert(words.begin(), "program");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    optind = 0;  // a fresh scan
    return parse_options(static_cast<int>(words.size()), argv.data(), options);
}

// The rows of a report that are not comments, as words.
inline std::vector<std::vector<std::string>> rows_of(const std::string& report) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        rows.emplace_back();
        for (std::string word; words >> word;) rows.back().push_back(word);
    }
    return rows;
}

// ---- Directions and maps

inline std::vector<Vec3> random_directions(std::size_t n, std::uint64_t stream = 0) {
    Random random(11, stream);
    return uniform_directions(n, random);
}

// Unit vectors all around.
inline std::vector<Vec3> random_normals(std::size_t n) {
    std::vector<Vec3> normals = random_directions(n, 1);
    for (std::size_t i = 0; i < n; i += 2) normals[i] = -1 * normals[i];
    return normals;
}

// Towards a place in a map, both from 0 to 1: u as the azimuth grows, v from the pole down.
inline Vec3 towards(double u, double v) {
    const double azimuth = 2 * pi * (u - 0.5), polar = pi * v;
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

// The map whose texel in a column of a row is texel(column, row).
template <class Texel>
EnvironmentMap map_of(int width, int height, Texel texel) {
    const Image image = image_of(width, height, texel);
    return EnvironmentMap(width, height, image.rgb());
}

inline EnvironmentMap even_map(int width, int height, double radiance) {
    return map_of(width, height, [&](int, int) { return Color{radiance, radiance, radiance}; });
}

// With a sun of 6 x 6 degrees.
inline const EnvironmentMap sunny = map_of(64, 32, [](int column, int row) {
    return column == 50 && row == 10 ? Color{1000, 900, 800} : Color{0.25, 0.5, 0.75};
});

// Coloured stripes.
inline EnvironmentMap striped_map(int width, int height) {
    return map_of(width, height, [&](int column, int row) {
        const int i = 3 * (row * width + column);
        return Color{i % 7 + 0.0, (i + 1) % 7 + 0.0, (i + 2) % 7 + 0.0};
    });
}

inline std::vector<float> values(const EnvironmentMap& map) {
    return {map.texels(), map.texels() + 3 * map.width() * map.height()};
}

inline const EnvironmentMap desert = load_environment(), white = even_map(1, 1, 1);

// ---- Pictures

inline const Method all_methods[] = {Method::mc, Method::direct, Method::single, Method::rotated, Method::pool};

inline PictureSettings small(Method method, std::size_t samples = 40, int size = 40,
                             Placement placement = Placement::uniform, Known known = Known::nothing) {
    PictureSettings settings;
    settings.method = method;
    settings.samples = samples;
    settings.width = settings.height = size;
    settings.placement = placement;
    settings.known = known;
    return settings;
}

// A sphere below the rectangle, in its shadow.
inline Scene sphere_below() {
    Scene scene = sphere_scene();
    scene.sphere.radius = 0.8;
    scene.rectangle.y = 1.2;
    return scene;
}

// Nothing but the sphere.
inline Scene sphere_alone() {
    Scene scene = sphere_scene();
    scene.rectangle.x_max = scene.rectangle.x_min;
    return scene;
}

// Whether a picture has the same bytes by the textbook's loops and by the fast ones.
template <class Draw>
bool twins_agree(Draw draw) {
    const std::string fast = to_pfm(draw());
    plain_loops = true;
    const std::string plain = to_pfm(draw());
    plain_loops = false;
    return fast == plain;
}

// What pictures tend to: plain weights on a dense lattice.
inline Image dense_picture(const EnvironmentMap& environment, int size = 40) {
    PictureSettings settings = small(Method::mc, 20000, size, Placement::fibonacci);
    settings.threads = 2;
    return render(sphere_scene(), environment, settings);
}

inline ImageError error_of(const Image& image, const Image& truth) { return image_error(image, truth_of(truth)); }

// The light that a point reflects as one would first write it: in double precision and from a rule as it is.
inline Color plain_light(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                         const QuadratureRule& rule, const Frame& frame, bool shadows = true) {
    Color sum;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        const Vec3 direction = frame.to_world(rule.directions[i]);
        if (shadows && is_shadowed(scene, hit, direction)) continue;
        sum += rule.weights[i] * rule.directions[i].y / pi * environment.radiance(direction);
    }
    return hit.albedo * sum;
}
