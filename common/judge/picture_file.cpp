#include "judge/picture_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <istream>
#include <stdexcept>
#include <streambuf>
#include <utility>
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
            fail("not a picture that is known here: it should begin with P6 or P3 (PPM) or with PF (PFM in colour)");
        is_text_ = magic == "P3";
        width_ = whole_number("width", max_side);
        height_ = whole_number("height", max_side);
        const bool is_ppm = magic != "PF";
        const int maxval = is_ppm ? whole_number("largest code", 65535) : 0;
        if (!is_ppm) read_byte_order();
        const auto values = static_cast<std::size_t>(width_) * 3;
        if (!is_text_) require_one_space();
        for (rows_ = 0; rows_ < height_; ++rows_) is_ppm ? read_codes(values, maxval) : read_floats(values);
        const int largest = narrow_to_bytes(maxval);
        const std::vector<float> decoded = decoded_codes(largest);
        for (const int code : codes_) rgb_.push_back(decoded[static_cast<std::size_t>(code)]);
        return {image(!is_ppm), largest};
    }

private:
    static constexpr int max_side = 8192;
    static constexpr int end_of_file = std::char_traits<char>::eof();

    [[noreturn]] void fail(const std::string& problem) const {
        throw std::runtime_error(rows_ < 0 ? problem : "row " + std::to_string(row()) + ": " + problem);
    }

    // From the top; a PFM begins at the bottom.
    int row() const { return first_byte_ < 0 ? rows_ : height_ - 1 - rows_; }

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

    // The sign of the scale; its size, in units that nobody agreed on, is ignored.
    void read_byte_order() {
        const std::string text = word("scale");
        char* end = nullptr;
        const double scale = std::strtod(text.c_str(), &end);
        if (*end != '\0' || !(scale < 0 || scale > 0)) fail("the scale '" + text + "' is not a number other than 0");
        first_byte_ = scale < 0 ? 0 : 3;
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

    void read_codes(std::size_t values, int maxval) {
        for (std::size_t i = 0; i < values; ++i) {
            int code;
            if (is_text_) {
                code = whole_number("code", maxval, 0);
            } else {
                code = static_cast<int>(byte());
                if (maxval > 255) code = 256 * code + static_cast<int>(byte());
                if (code > maxval)
                    fail("code " + std::to_string(code) + " exceeds the largest, " + std::to_string(maxval));
            }
            codes_.push_back(static_cast<std::uint16_t>(code));
        }
    }

    // Codes to 255 that were widened, by a factor and rounded in whatever way or by a shift, become codes to 255 again.
    // Returns the largest code.
    int narrow_to_bytes(int maxval) {
        const auto byte_of = [&](int code) { return (255 * code + maxval / 2) / maxval; };
        const auto is_scaled = [&](int code) { return std::fabs(code - byte_of(code) * maxval / 255.0) < 1; };
        const auto is_shifted = [](int code) { return code % 256 == 0; };
        if (maxval <= 255) return maxval;
        if (std::all_of(codes_.begin(), codes_.end(), is_scaled)) {
            for (std::uint16_t& code : codes_) code = static_cast<std::uint16_t>(byte_of(code));
        } else if (maxval == 65535 && std::all_of(codes_.begin(), codes_.end(), is_shifted)) {
            for (std::uint16_t& code : codes_) code >>= 8;
        } else {
            return maxval;
        }
        return 255;
    }

    void read_floats(std::size_t values) {
        for (std::size_t i = 0; i < values; ++i) {
            std::uint32_t bits = 0;
            for (int k = 0; k < 4; ++k) bits |= byte() << 8 * (first_byte_ == 0 ? k : 3 - k);
            float value;
            std::memcpy(&value, &bits, sizeof value);
            if (!std::isfinite(value)) fail("a value is infinite or no number");
            rgb_.push_back(value);
        }
    }

    Image image(bool bottom_first) const {
        Image result(width_, height_);
        const float* rgb = rgb_.data();
        for (int i = 0; i < height_; ++i)
            for (int x = 0; x < width_; ++x, rgb += 3)
                result.set(x, bottom_first ? height_ - 1 - i : i, {rgb[0], rgb[1], rgb[2]});
        return result;
    }

    std::streambuf& bytes_;
    bool is_text_ = false;
    int width_ = 0, height_ = 0;
    int rows_ = -1;        // that are read; -1: the header is
    int first_byte_ = -1;  // of a float, where 0 is the lowest; -1: no floats
    std::vector<std::uint16_t> codes_;
    std::vector<float> rgb_;
};

}  // namespace

PictureFile read_picture(std::istream& in) { return PictureReader(*in.rdbuf()).read(); }

double srgb_encoded(double linear) {
    if (!(linear > 0)) return 0;
    const double v = std::min(linear, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * portable::pow(v, 1 / 2.4) - 0.055;
}

// The code of a value is how many thresholds it reaches, as in to_ppm.
Image stored(Image image, int maxval) {
    if (maxval == 0) return image;
    const std::vector<float> decoded = decoded_codes(maxval);
    std::vector<double> thresholds;
    for (int code = 1; code <= maxval; ++code) thresholds.push_back(srgb_decoded((code - 0.5) / maxval));
    const auto keep = [&](double linear) {
        const auto code = std::upper_bound(thresholds.begin(), thresholds.end(), linear) - thresholds.begin();
        return static_cast<double>(decoded[static_cast<std::size_t>(code)]);
    };
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Color color = image(x, y);
            image.set(x, y, {keep(color.x), keep(color.y), keep(color.z)});
        }
    return image;
}
