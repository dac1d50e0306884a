#include "scene/image.h"
#include "test.h"

#include <set>

static std::string text_of(const std::vector<int>& bytes) { return {bytes.begin(), bytes.end()}; }

// 0.5 encodes to 187.5160, 0.0031308 to 12.92 * 0.0031308 * 255 = 10.31, 0.0001 to 0.33; what is no number is black.
TEST_CASE("PPM: header, rows from the top, sRGB bytes, clamped") {
    Image image(2, 2);
    image.pixels = {{0, 1, 0.5}, {-3, 7, 0.0031308}, {0, 0, 0}, {nan_value, 0.0001, infinity}};
    CHECK(encode(image, Format::ppm) == "P6\n2 2\n255\n" + text_of({0, 255, 188, 0, 255, 10, 0, 0, 0, 0, 0, 255}));
}

// A row of 3 pixels has 9 bytes, and 3 of padding.
TEST_CASE("BMP: header, rows from the bottom, padded, blue first") {
    Image image(3, 2);
    image(0, 0) = {1, 0, 0};
    image(2, 1) = {0, 0.5, 1};
    const std::string bmp = encode(image, Format::bmp);
    std::string header = "BM";  // one plane of 24 bits, 3780 pixels per metre, no other colours
    for (const int word : {78, 0, 54, 40, 3, 2, 1 + 24 * 65536, 0, 24, 3780, 3780, 0, 0})
        header += text_of({word % 256, word / 256 % 256, word / 65536, 0});
    CHECK(bmp.substr(0, 54) == header);
    CHECK(bmp.substr(54) == text_of({0, 0, 0, 0, 0, 0, 255, 188, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    CHECK(encode(Image(4, 1), Format::bmp).size() == 54 + 12);
}

// So a reader can have them back, whatever their order in a format that is only added to the names.
TEST_CASE("every format with a name has another file for each code of each channel") {
    for (std::size_t format = 0; format < std::size(format_names); ++format) {
        std::set<std::string> files;
        for (double Colour::*const channel : {&Colour::x, &Colour::y, &Colour::z})
            for (int i = 0; i < 2 * 18; ++i) {  // codes 0, 15 ... 255 in either of two pixels
                Image image(2, 1);
                image(i % 2, 0).*channel = srgb_to_linear(i / 2 / 17.0);
                files.insert(encode(image, static_cast<Format>(format)));
            }
        CHECK_MESSAGE(files.size() == 6 * 17 + 1, std::string(format_names[format]));
    }
}

TEST_CASE("a byte stands for the light of the codes within half a unit, by sRGB's formula") {
    for (int byte = 1; byte < 256; ++byte) {
        CAPTURE(byte);
        const double code = (byte - 0.5) / 255, begin = srgb_to_linear(code);
        CHECK(relative(begin, code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4)) < 1e-15);
        Image image(2, 1);
        image.pixels = {{begin * (1 - 1e-15), 0, 0}, {begin, 0, 0}};
        const std::string ppm = encode(image, Format::ppm);
        CHECK(static_cast<unsigned char>(ppm[ppm.size() - 6]) == byte - 1);
        CHECK(static_cast<unsigned char>(ppm[ppm.size() - 3]) == byte);
    }
}
