// The tolerant half of compare: whether the output of another program agrees, and if not, what a person would see.
#include "compare.h"

#include "../course/judge/likely_mistakes.h"
#include "scene/image.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

using namespace bmc;

namespace {

bool agree(double reference, double actual, double tolerance) {
    return reference == actual || std::fabs(actual - reference) <= tolerance * std::fabs(reference) + 1e-9;
}

void add(std::string& text, const std::string& clause) {
    if (!clause.empty()) text += (text.empty() ? "" : "; ") + clause;
}

// ---- Text

// A word is a number and what follows it ("0.5;"), or has no number.
struct Word {
    double number;
    std::string rest;
};

Word parse_word(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    return {number, end};
}

bool words_agree(const std::string& reference, const std::string& actual, double tolerance) {
    if (reference == actual) return true;
    const Word a = parse_word(reference), b = parse_word(actual);
    return a.rest == b.rest && a.rest.size() < reference.size() && agree(a.number, b.number, tolerance);
}

using Lines = std::vector<std::string>;

bool lines_agree(const std::string& reference, const std::string& actual, double tolerance) {
    const std::vector<std::string> a = split_columns(reference), b = split_columns(actual);
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!words_agree(a[i], b[i], tolerance)) return false;
    return true;
}

// A number of both outputs, in its table.
struct Cell {
    std::size_t row, column;  // from 1; the row in the whole output
    double reference, actual;
    bool agrees;
};

// Rows under one another, with as many columns each.
struct Table {
    std::vector<std::string> header;  // the words of the line above
    std::size_t columns = 0, rows = 0;
    std::vector<Cell> cells;

    bool names_columns() const { return header.size() == columns; }
    std::string column_name(std::size_t column) const {
        return "column " + std::to_string(column) + (names_columns() ? " (" + header[column - 1] + ")" : "");
    }
    bool is_matrix() const { return rows == columns && rows > 1 && !names_columns(); }
    std::string matrix_name() const { return header.empty() ? "the matrix" : header[0].substr(0, header[0].find(',')); }
    bool differs() const {
        return std::any_of(cells.begin(), cells.end(), [](const Cell& cell) { return !cell.agrees; });
    }
};

// Of two outputs with as many lines.
std::vector<Table> parse_tables(const Lines& reference, const Lines& actual, double tolerance) {
    std::vector<Table> tables;
    std::vector<std::string> header;
    std::size_t row = 0;
    bool within = false;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (!is_row(reference[i])) {
            within = false;
            if (!reference[i].empty()) header = split_columns(reference[i].substr(1));
            continue;
        }
        ++row;
        const std::vector<std::string> a = split_columns(reference[i]), b = split_columns(actual[i]);
        if (!within || tables.back().columns != a.size()) tables.push_back({header, a.size(), 0, {}});
        within = true;
        ++tables.back().rows;
        for (std::size_t j = 0; j < std::min(a.size(), b.size()); ++j)
            tables.back().cells.push_back(
                {row, j + 1, parse_word(a[j]).number, parse_word(b[j]).number, words_agree(a[j], b[j], tolerance)});
    }
    return tables;
}

// What makes results so many times as large, in brackets, if it is known.
std::string reason(double ratio) {
    for (const Factor& each : factors)
        if (std::fabs(ratio / each.factor - 1) <= 0.005) return std::string(" (") + each.name + ")";
    return "";
}

// The one number that these are of their references; 0 if there is none.
double common_ratio(const std::vector<Cell>& cells) {
    double ratio = 0;
    for (const Cell& cell : cells) {
        if (cell.reference == 0 && cell.actual == 0) continue;
        if (cell.reference == 0 || !std::isfinite(cell.actual)) return 0;
        const double here = cell.actual / cell.reference;
        if (ratio == 0) ratio = here;
        if (!(std::fabs(here - ratio) <= std::min(2e-3 * std::fabs(ratio), 0.1 * std::fabs(ratio - 1)))) return 0;
    }
    return ratio;
}

// What the differences in one column have in common; nothing if they have nothing.
std::string describe_column(const Table& table, std::size_t column, const std::vector<Cell>& cells) {
    const std::string name = table.column_name(column);
    const auto all = [&](auto property) { return std::all_of(cells.begin(), cells.end(), property); };
    if (all([](const Cell& cell) { return cell.actual == 0; })) return "all of " + name + " is 0";
    const double ratio = common_ratio(cells);
    if (cells.size() > 1 && ratio != 0)
        return "all of " + name + " is " + in_words(ratio, 4) + " times the reference" + reason(ratio);
    const auto negatives = std::count_if(cells.begin(), cells.end(), [](const Cell& cell) { return cell.actual < 0; });
    if (negatives > 0 && all([](const Cell& cell) { return cell.reference >= 0; }))
        return std::to_string(negatives) + " of the " + std::to_string(cells.size()) + " numbers in " + name +
               " are negative, none of the reference's";
    return "";
}

std::string describe_columns(const Table& table) {
    std::string text, others;
    for (std::size_t column = 1; column <= table.columns; ++column) {
        std::vector<Cell> cells;
        for (const Cell& cell : table.cells)
            if (cell.column == column) cells.push_back(cell);
        if (std::all_of(cells.begin(), cells.end(), [](const Cell& cell) { return cell.agrees; })) continue;
        const std::string clause = describe_column(table, column, cells);
        add(text, clause);
        if (clause.empty()) others += (others.empty() ? "" : ", ") + table.column_name(column);
    }
    if (!others.empty()) add(text, "differences in " + others);
    return text;
}

// In a square table, such as a matrix, the place that holds all differences.
std::string describe_matrix(const Table& table) {
    bool one_row = true;
    std::size_t row = 0, differing = 0, on_diagonal = 0;
    for (const Cell& cell : table.cells) {
        if (cell.agrees) continue;
        const std::size_t here = cell.row - table.cells[0].row + 1;
        row = row == 0 ? here : row;
        one_row = one_row && here == row;
        if (here == cell.column) ++on_diagonal;
        ++differing;
    }
    const std::string name = table.matrix_name();
    const double ratio = common_ratio(table.cells);
    if (ratio != 0) return "all of " + name + " is " + in_words(ratio, 4) + " times the reference" + reason(ratio);
    if (on_diagonal == differing) return "only the diagonal of " + name + " differs";
    if (on_diagonal == 0 && differing + table.rows == table.cells.size())
        return "all of " + name + " but the diagonal differs";
    if (one_row) return "only row " + std::to_string(row) + " of " + name + " differs";
    if (differing == table.cells.size()) return "all of " + name + " differs";
    return std::to_string(differing) + " of the " + std::to_string(table.cells.size()) + " numbers of " + name +
           " differ";
}

// Where the first difference is: line `at` of both outputs.
std::string describe_place(const Lines& reference, const Lines& actual, std::size_t at, double tolerance) {
    const std::vector<std::string> a = split_columns(reference[at]), b = split_columns(actual[at]);
    const bool named = !a.empty() && parse_word(a[0]).rest == a[0];
    const std::string line = "line " + std::to_string(at + 1) + (named && is_row(reference[at]) ? ", " + a[0] : "");
    if (!is_row(reference[at]) || a.size() != b.size())
        return line + ", reference: " + reference[at] + ", here: " + actual[at];
    std::size_t i = 0;
    while (words_agree(a[i], b[i], tolerance)) ++i;
    const auto row = std::count_if(reference.data(), reference.data() + at + 1, is_row);
    return "row " + std::to_string(row) + " (" + line + "), column " + std::to_string(i + 1) + ": reference " + a[i] +
           ", here " + b[i];
}

// ---- Pictures

constexpr double differing_pixels = 1e-3;  // of all

// The linear light of a channel; PPM is coded as IEC 61966-2-1 says.
double light(const Picture& picture, std::size_t i) {
    const double value = picture.value(i);
    if (picture.floats) return value;
    return srgb_decoded(value / 255);
}

struct Pixel {
    std::size_t x, y;
};

// The pixels that differ, the picture mirrored in x or y first.
std::vector<Pixel> differences(const Picture& reference, const Picture& actual, bool mirror_x = false,
                               bool mirror_y = false) {
    std::vector<Pixel> found;
    for (std::size_t y = 0; y < reference.height; ++y)
        for (std::size_t x = 0; x < reference.width; ++x) {
            const std::size_t i = reference.index(x, y);
            const std::size_t j =
                actual.index(mirror_x ? reference.width - 1 - x : x, mirror_y ? reference.height - 1 - y : y);
            bool same = true;
            for (std::size_t k = 0; k < 3; ++k)
                same = same && (reference.channels[i + k] == actual.channels[j + k] ||
                                (reference.floats && agree(reference.value(i + k), actual.value(j + k), 1e-3)));
            if (!same) found.push_back({x, y});
        }
    return found;
}

bool few(const std::vector<Pixel>& pixels, const Picture& picture) {
    return static_cast<double>(pixels.size()) <=
           differing_pixels * static_cast<double>(picture.width) * static_cast<double>(picture.height);
}

// What the picture is instead: another known one, or the reference in a mirror.
std::string describe_likeness(const Picture& reference, const Picture& actual,
                              const std::vector<Named<Picture>>& others) {
    for (const Named<Picture>& other : others)
        if (other.output.header == actual.header && few(differences(other.output, actual), actual))
            return "it equals the picture of " + other.name;
    for (const Mirroring& mirroring : mirrorings)
        if (few(differences(reference, actual, mirroring.left_right, mirroring.up_down), actual))
            return std::string("it is ") + mirroring.name;
    return "";
}

// If it is one part of the sphere scene that differs: which.
std::string describe_part(const std::vector<Pixel>& pixels, const Picture& picture) {
    if (pixels.size() == picture.width * picture.height) return "";
    const Scene scene = sphere_scene();
    const Camera camera{static_cast<int>(picture.width), static_cast<int>(picture.height)};
    std::map<std::string, std::size_t> parts;
    for (const Pixel& pixel : pixels) {
        const auto hit = intersect(scene, camera.ray(static_cast<int>(pixel.x), static_cast<int>(pixel.y)));
        ++parts[!hit ? "in the background" : hit->object == Object::sphere ? "on the sphere" : "on the rectangle"];
    }
    for (const auto& [name, count] : parts)
        if (static_cast<double>(count) >= 0.99 * static_cast<double>(pixels.size()))
            return "only pixels " + name + " differ";
    return "";
}

// The light of a pixel, the sum of its channels.
double light(const Picture& picture, Pixel pixel) {
    const std::size_t i = picture.index(pixel.x, pixel.y);
    return light(picture, i) + light(picture, i + 1) + light(picture, i + 2);
}

// How much the light changes from a pixel that differs to the pixel `step` to the right, squared, on average: in both
// pictures, and in their difference, in which the scene itself cancels and only noise is left.
struct Roughness {
    double reference = 0, actual = 0, difference = 0;
};

Roughness roughness(const Picture& reference, const Picture& actual, const std::vector<Pixel>& pixels,
                    std::size_t step) {
    Roughness sum;
    double count = 0;
    for (std::size_t i = 0; i + step < pixels.size(); ++i) {
        const Pixel here = pixels[i], there = pixels[i + step];
        if (there.y != here.y || there.x != here.x + step) continue;
        const double a = light(reference, there) - light(reference, here);
        const double b = light(actual, there) - light(actual, here);
        sum.reference += a * a;
        sum.actual += b * b;
        sum.difference += (b - a) * (b - a);
        ++count;
    }
    const double scale = 1 / std::max(count, 1.0);
    return {sum.reference * scale, sum.actual * scale, sum.difference * scale};
}

bool within(double ratio, double factor) { return ratio * factor > 1 && ratio < factor; }

// The one factor, neither 0 nor 1, between the lights of all channels that are neither too dark nor too bright for
// their bytes to tell it; 0 if there is none.
double common_factor(const Picture& reference, const Picture& actual, const std::vector<Pixel>& pixels) {
    const auto tells = [](double light) { return light > 0.02 && light < 0.99; };
    std::vector<double> factors;
    for (const Pixel& pixel : pixels)
        for (std::size_t i = reference.index(pixel.x, pixel.y), end = i + 3; i < end; ++i)
            if (tells(light(reference, i)) && tells(light(actual, i)))
                factors.push_back(light(actual, i) / light(reference, i));
    if (factors.empty() || factors.size() < pixels.size() / 4) return 0;
    std::sort(factors.begin(), factors.end());
    const double middle = factors[factors.size() / 2], low = factors[factors.size() / 50];
    const double high = factors[factors.size() - 1 - factors.size() / 50];
    return low > 0.95 * middle && high < 1.05 * middle && !within(middle, 1.02) ? middle : 0;
}

// Brightness and noise, where the pictures differ.
std::string describe_light(const Picture& reference, const Picture& actual, const std::vector<Pixel>& pixels) {
    double expected = 0, found = 0;
    for (const Pixel& pixel : pixels) {
        expected += light(reference, pixel);
        found += light(actual, pixel);
    }
    const double brightness = found / expected;
    if (!std::isfinite(brightness)) return "it holds numbers that are not finite";
    if (found == 0) return "where it differs, it is black";
    const double factor = common_factor(reference, actual, pixels);
    if (factor != 0)
        return "the light of every pixel is " + in_words(factor, 3) + " times the reference's" + reason(factor);
    const Roughness near = roughness(reference, actual, pixels, 1), far = roughness(reference, actual, pixels, 8);
    const bool same_noise = within(near.actual / near.reference, 1.5) && within(far.actual / far.reference, 1.5);
    // Independent noises add up in the difference; those of the same random numbers cancel.
    if (std::fabs(brightness - 1) < 0.03 && same_noise && near.difference > 0.5 * (near.reference + near.actual))
        return "the noise is another seed's: brightness, error and correlation agree, the pixels do not; the random "
               "numbers are other ones or drawn in another order";
    const double percent = 100 * std::fabs(brightness - 1);
    std::string text =
        "the picture is " + in_words(percent, percent < 10 ? 2 : 3) + (brightness < 1 ? " % darker" : " % brighter");
    if (percent > 3) return text;
    const double noise = std::sqrt(near.actual / near.reference);
    if (noise > 1.1) add(text, "neighbouring pixels differ " + in_words(noise, 2) + " times as much: noisier");
    if (noise < 0.9) add(text, "neighbouring pixels differ " + in_words(noise, 2) + " times as much: smoother");
    return text;
}

}  // namespace

std::string tolerant_text_difference(const std::string& reference, const std::string& actual, double tolerance,
                                     const std::vector<Named<std::string>>& others) {
    const Lines expected = split_lines(reference), found = split_lines(actual);
    std::size_t first = 0;
    while (first < std::min(expected.size(), found.size()) && lines_agree(expected[first], found[first], tolerance))
        ++first;
    if (first == expected.size() && first == found.size()) return "";
    std::string text;
    if (first < std::min(expected.size(), found.size())) text = describe_place(expected, found, first, tolerance);
    for (const Named<std::string>& other : others)
        if (tolerant_text_difference(other.output, actual, tolerance, {}).empty())
            add(text, "it equals the output of " + other.name);
    if (expected.size() != found.size()) {
        add(text, "the reference has " + std::to_string(expected.size()) + " lines, here are " +
                      std::to_string(found.size()));
        return text;
    }
    for (const Table& table : parse_tables(expected, found, tolerance))
        if (table.differs()) {
            add(text, table.is_matrix() ? describe_matrix(table) : describe_columns(table));
            break;
        }
    return text;
}

std::string tolerant_picture_difference(const Picture& reference, const Picture& actual,
                                        const std::vector<Named<Picture>>& others) {
    const std::vector<Pixel> pixels = differences(reference, actual);
    if (few(pixels, actual)) return "";
    std::string text = count_of(pixels.size(), actual.width * actual.height, "pixels");
    const std::string likeness = describe_likeness(reference, actual, others);
    if (!likeness.empty()) return text + "; " + likeness;
    add(text, describe_part(pixels, actual));
    add(text, describe_light(reference, actual, pixels));
    return text;
}
