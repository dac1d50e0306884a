#include "picture_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <istream>
#include <stdexcept>
#include <streambuf>
#include <vector>

namespace {

// The linear value of every code.
std::vector<float> decoded_codes(int maxval) {
    std::vector<float> values;
    for (int code = 0; code <= maxval; ++code)
        values.push_back(static_cast<float>(srgb_decoded(static_cast<double>(code) / maxval)));
    return values;
}

class PictureReader {
public:
    explicit PictureReader(std::streambuf& bytes) : bytes_(bytes) {}

    PictureFile read() {
        std::string magic;
        for (int i = 0; i < 2 && bytes_.sgetc() != end_of_file; ++i) magic += static_cast<char>(bytes_.sbumpc());
        if (magic == "\x89P") fail("a PNG; pngtopnm file.png > file.ppm makes of it what is read here");
        if (magic != "P3" && magic != "P6" && magic != "PF")
            fail("it begins neither with P6 or P3 (PPM) nor with PF (PFM in colour)");
        is_text_ = magic == "P3";
        is_ppm_ = magic != "PF";
        const int width = whole_number("width", max_side);
        height_ = whole_number("height", max_side);
        const int maxval = is_ppm_ ? whole_number("largest code", 255) : 0;
        // Of the scale, in units that nobody agreed on, only the sign counts.
        if (!is_ppm_) little_endian_ = word("scale")[0] == '-';
        if (!is_text_) require_one_space();
        const std::vector<float> linear_values = decoded_codes(std::max(maxval, 1));
        for (rows_ = 0; rows_ < height_; ++rows_)
            for (int i = 0; i < 3 * width; ++i) values_.push_back(is_ppm_ ? linear_values[code(maxval)] : real());
        const auto pixel = [&](int x, int y) {
            const float* rgb = &values_[static_cast<std::size_t>(3 * (from_top(y) * width + x))];
            return Color{rgb[0], rgb[1], rgb[2]};
        };
        return {image_of(width, height_, pixel), maxval};
    }

private:
    static constexpr int max_side = 8192;
    static constexpr int end_of_file = std::char_traits<char>::eof();

    [[noreturn]] void fail(const std::string& problem) const {
        throw std::runtime_error(rows_ < 0 ? problem : "row " + std::to_string(from_top(rows_)) + ": " + problem);
    }

    // The row as the file counts them: a PFM begins at the bottom.
    int from_top(int row) const { return is_ppm_ ? row : height_ - 1 - row; }

    static bool is_space(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    // The next characters up to a space or a comment; what should stand here is named if they do not look like it.
    std::string word(const std::string& what) {
        int c = bytes_.sgetc();
        for (; is_space(c) || c == '#'; c = bytes_.snextc())
            if (c == '#')
                while (c != '\n' && c != '\r' && c != end_of_file) c = bytes_.snextc();
        std::string text;
        for (; c != end_of_file && !is_space(c) && c != '#'; c = bytes_.snextc()) {
            if (text.size() == 20 || c <= ' ' || c > '~') fail("the " + what + " is not a number: '" + text + "...'");
            text += static_cast<char>(c);
        }
        if (text.empty()) fail("the file ends where the " + what + " should be");
        return text;
    }

    int whole_number(const std::string& what, int most, int least = 1) {
        const std::string text = word(what);
        const bool digits = text.find_first_not_of("0123456789") == std::string::npos && text.size() <= 9;
        const int value = digits ? std::stoi(text) : -1;
        if (value >= least && value <= most) return value;
        fail("the " + what + " '" + text + "' is not a whole number from " + std::to_string(least) + " to " +
             std::to_string(most));
    }

    void require_one_space() {
        const int c = bytes_.sbumpc();
        if (!is_space(c)) fail("after the header there should be one space or line break");
        if (c == '\r' && bytes_.sgetc() == '\n')
            fail("CR and LF end the header: were its line ends converted? write the file in binary mode");
    }

    unsigned byte() {
        const int c = bytes_.sbumpc();
        if (c == end_of_file) fail("the file ends inside the picture");
        return static_cast<unsigned>(c);
    }

    std::size_t code(int maxval) {
        if (is_text_) return static_cast<std::size_t>(whole_number("code", maxval, 0));
        const unsigned code = byte();
        if (code > static_cast<unsigned>(maxval))
            fail("code " + std::to_string(code) + " exceeds the largest, " + std::to_string(maxval));
        return code;
    }

    float real() {
        std::uint32_t bits = 0;
        for (int k = 0; k < 4; ++k) bits |= byte() << 8 * (little_endian_ ? k : 3 - k);
        const auto value = portable::bit_cast<float>(bits);
        if (!std::isfinite(value)) fail("a value is infinite or no number");
        return value;
    }

    std::streambuf& bytes_;
    bool is_text_ = false, is_ppm_ = true, little_endian_ = false;
    int height_ = 0;
    int rows_ = -1;              // that are read; -1: the header is
    std::vector<float> values_;  // of all channels, linear
};

}  // namespace

PictureFile read_picture(std::istream& in) { return PictureReader(*in.rdbuf()).read(); }

double srgb_encoded(double linear) {
    if (!(linear > 0)) return 0;
    const double v = std::min(linear, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * portable::pow(v, 1 / 2.4) - 0.055;
}

Image stored(const Image& image, int maxval) {
    if (maxval == 0) return image;
    const std::vector<float> decoded = decoded_codes(maxval);
    return each_channel(
        image, [&](double linear) { return decoded[static_cast<std::size_t>(maxval * srgb_encoded(linear) + 0.5)]; });
}
