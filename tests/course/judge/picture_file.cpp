#include "picture_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <istream>
#include <stdexcept>
#include <streambuf>

#include "command_line.h"

namespace bmc {
namespace {

// Of every code.
std::vector<float> linear_values(int maxval) {
    std::vector<float> values;
    for (double code = 0; code <= maxval; ++code)
        values.push_back(static_cast<float>(srgb_decoded(code / std::max(maxval, 1))));
    return values;
}

class PictureReader {
public:
    explicit PictureReader(std::streambuf& bytes) : bytes_(bytes) {}

    PictureFile read() {
        char magic[2];
        const std::string kind(magic, static_cast<std::size_t>(bytes_.sgetn(magic, 2)));
        if (kind == "\x89P") fail("a PNG; pngtopnm file.png > file.ppm makes of it what is read here");
        is_pfm_ = kind == "PF";
        is_text_ = kind == "P3";
        if (!is_pfm_ && !is_text_ && kind != "P6")
            fail("it begins neither with P6 or P3 (PPM) nor with PF (PFM in colour)");
        const int width = whole_number("width", 1, 8192);
        height_ = whole_number("height", 1, 8192);
        const int maxval = is_pfm_ ? 0 : whole_number("largest code", 1, 255);
        // Of the scale, in units that nobody agreed on, only the sign counts.
        little_endian_ = is_pfm_ && word("scale")[0] == '-';
        if (!is_text_) require_one_space();
        const std::vector<float> linear = linear_values(maxval);
        std::vector<float> values;
        for (rows_ = 0; rows_ < height_; ++rows_)
            for (int i = 0; i < 3 * width; ++i) values.push_back(is_pfm_ ? real() : linear[code(maxval)]);
        const auto pixel = [&](int x, int y) {
            const float* rgb = &values[static_cast<std::size_t>(3 * (from_top(y) * width + x))];
            return Color{rgb[0], rgb[1], rgb[2]};
        };
        return {image_of(width, height_, pixel), maxval};
    }

private:
    [[noreturn]] void fail(const std::string& problem) const {
        throw std::runtime_error(rows_ < 0 ? problem : formatted("row %d: ", from_top(rows_)) + problem);
    }

    // The row as the file counts them: a PFM begins at the bottom.
    int from_top(int row) const { return is_pfm_ ? height_ - 1 - row : row; }

    // The next characters up to a space or a comment; what should stand here is named if they do not look like it.
    std::string word(const std::string& what) {
        int c = bytes_.sgetc();
        for (; std::isspace(c) || c == '#'; c = bytes_.snextc())
            if (c == '#')
                while (c != '\n' && c != '\r' && c != EOF) c = bytes_.snextc();
        std::string text;
        for (; c != EOF && !std::isspace(c) && c != '#'; c = bytes_.snextc()) {
            if (text.size() == 20 || c <= ' ' || c > '~') fail("the " + what + " is not a number: '" + text + "...'");
            text += static_cast<char>(c);
        }
        if (text.empty()) fail("the file ends where the " + what + " should be");
        return text;
    }

    int whole_number(const std::string& what, int least, int most) {
        try {
            return static_cast<int>(parse_integer(word(what), least, most));
        } catch (const UsageError& error) {
            fail("the " + what + ' ' + error.what());
        }
    }

    void require_one_space() {
        const int c = bytes_.sbumpc();
        if (!std::isspace(c)) fail("after the header there should be one space or line break");
        if (c == '\r' && bytes_.sgetc() == '\n')
            fail("CR and LF end the header: were its line ends converted? write the file in binary mode");
    }

    unsigned byte() {
        const int c = bytes_.sbumpc();
        if (c == EOF) fail("the file ends inside the picture");
        return static_cast<unsigned>(c);
    }

    std::size_t code(int maxval) {
        const int code = is_text_ ? whole_number("code", 0, maxval) : static_cast<int>(byte());
        if (code > maxval) fail(formatted("code %d exceeds the largest, %d", code, maxval));
        return static_cast<std::size_t>(code);
    }

    float real() {
        std::uint32_t bits = 0;
        for (int k = 0; k < 4; ++k) bits |= byte() << 8 * (little_endian_ ? k : 3 - k);
        const auto value = portable::bit_cast<float>(bits);
        if (!std::isfinite(value)) fail("a value is infinite or no number");
        return value;
    }

    std::streambuf& bytes_;
    bool is_text_ = false, is_pfm_ = false, little_endian_ = false;
    int height_ = 0, rows_ = -1;  // rows that are read; -1: the header is
};

}  // namespace

PictureFile read_picture(std::istream& in) { return PictureReader(*in.rdbuf()).read(); }

double srgb_encoded(double linear) {
    if (!(linear > 0)) return 0;
    const double v = std::min(linear, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * portable::pow(v, 1 / 2.4) - 0.055;
}

Image as_stored(const Image& image, int maxval) {
    if (maxval == 0) return image;
    const std::vector<float> linear = linear_values(maxval);
    return each_channel(image,
                        [&](double v) { return linear[static_cast<std::size_t>(maxval * srgb_encoded(v) + 0.5)]; });
}
}  // namespace bmc
