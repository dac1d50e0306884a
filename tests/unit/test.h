// What several tests use. A test makes the scene and the light that it needs, unless it is about the built-in ones.
#pragma once

#if !__has_include(<doctest/doctest.h>)
#error "the unit tests need doctest; tests/setup test installs it, or shows the names of Debian's packages"
#endif

#include "command_line/command_line.h"
#include "scene/render.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

using namespace bmc;
using portable::pi;

using Numbers = std::vector<double>;  // values of one check, which all are shown if it fails
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

inline double relative(double a, double b) { return std::fabs(a / b - 1); }
namespace bmc {
inline bool operator==(Vec3 a, Vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
}  // namespace bmc

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// What a text equals that holds this part: a failed check shows both.
struct Containing {
    std::string part;
};
inline bool operator==(const std::string& text, const Containing& some) { return contains(text, some.part); }

// What a failed check shows of vectors: all three numbers, and up to a dozen elements.
namespace doctest {
template <>
struct StringMaker<Vec3> {
    static String convert(Vec3 v) { return formatted("{%.17g, %.17g, %.17g}", v.x, v.y, v.z).c_str(); }
};
template <>
struct StringMaker<Containing> {
    static String convert(const Containing& some) { return ("... " + some.part + " ...").c_str(); }
};
template <class T>
struct StringMaker<std::vector<T>> {
    static String convert(const std::vector<T>& all) {
        String text = "{";
        for (std::size_t i = 0; i < all.size() && i < 12; ++i) text += (i ? ", " : "") + toString(all[i]);
        return text + (all.size() > 12 ? ", ...}" : "}");
    }
};
}  // namespace doctest

// The message of the exception that f throws; empty if it throws none.
inline std::string message_of(const std::function<void()>& f) {
    try {
        f();
        return "";
    } catch (const std::exception& error) {
        return error.what();
    }
}

// What f prints on standard error. Standard output is no terminal meanwhile.
std::string stderr_of(const std::function<void()>& f);

// A file that exists as long as this object, of a name that no other process has.
struct TemporaryFile {
    std::string name = (std::filesystem::temp_directory_path() / "bmc-XXXXXX").string();

    explicit TemporaryFile(const std::string& content) {
        close(mkstemp(name.data()));
        std::ofstream(name, std::ios::binary) << content;
    }
    ~TemporaryFile() { std::filesystem::remove(name); }
};

// Whether an error of reading is what read(in) ends with, wherever in these bytes, or behind them, it is.
template <class Read>
void check_failing_reads(const std::string& bytes, Read read) {
    struct FailingBuffer : std::stringbuf {
        using std::stringbuf::stringbuf;
        int_type underflow() override { throw std::ios::failure("an error of reading"); }
    };
    for (std::size_t n = 0; n <= bytes.size(); ++n) {
        FailingBuffer buffer(bytes.substr(0, n));
        std::istream in(&buffer);
        CHECK_MESSAGE(message_of([&] { read(in); }) == Containing{"an error of reading"}, n);
    }
}

// Lets the options take what stands in these words behind a command, and returns what they leave.
inline std::vector<std::string> parse(std::vector<std::string> words, Arguments& arguments) {
    words.insert(words.begin(), "command");
    arguments.words = std::move(words);
    return arguments.read();
}

// What a command prints for these words.
inline std::string output_of(std::string (*report)(Arguments&), std::vector<std::string> words) {
    words.insert(words.begin(), "command");
    Arguments arguments{std::move(words), ""};
    return report(arguments);
}

inline std::vector<std::string> words_in(const std::string& text) {
    std::istringstream words(text);
    return {std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
}

// The rows of a table that are not comments, as words.
inline std::vector<std::vector<std::string>> rows_of(const std::string& table) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(table);
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && line[0] != '#') rows.push_back(words_in(line));
    return rows;
}

inline std::vector<Vec3> some_directions(std::size_t n, std::uint64_t stream = 0) {
    Random random(11, stream);
    return random_directions(n, random);
}
inline std::vector<Vec3> all_around(std::size_t n) {
    std::vector<Vec3> directions = some_directions(n, 1);
    for (std::size_t i = 0; i < n; i += 2) directions[i] = -1 * directions[i];
    return directions;
}

// Towards a place in a map, both from 0 to 1: u as the azimuth grows, v from the pole down.
inline Vec3 towards(double u, double v) {
    const double azimuth = 2 * pi * (u - 0.5), polar = pi * v;
    return {std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
}

// The map whose texel in a column of a row is texel(column, row).
template <class Texel>
EnvironmentMap map_of(int width, int height, Texel texel) {
    EnvironmentMap map(width, height);
    for (int i = 0; i < width * height; ++i) map.set(i % width, i / width, texel(i % width, i / width));
    return map;
}
inline EnvironmentMap even_map(int width, int height, double radiance) {
    return map_of(width, height, [&](int, int) { return radiance * Colour{1, 1, 1}; });
}
inline EnvironmentMap coloured_map(int width, int height) {  // each texel has another colour
    return map_of(width, height, [](int x, int y) { return Colour{x + 0.5, y + 0.25, (7 * x + 5 * y) % 11 + 0.125}; });
}
inline EnvironmentMap sunny_map() {  // dim, with a sun of 6 x 6 degrees
    EnvironmentMap map = even_map(64, 32, 0.5);
    map.set(50, 10, {1000, 900, 800});
    return map;
}

inline RenderSettings small_picture(Method method, std::size_t samples = 10, int size = 12, Placement placement = {},
                                    Known known = Known::nothing) {
    RenderSettings settings;
    settings.method = method;
    settings.samples = samples;
    settings.pool = 3;
    settings.width = settings.height = size;
    settings.placement = placement;
    settings.known = known;
    return settings;
}
