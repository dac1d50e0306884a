#include "../course/judge/picture_file.h"

#include "test.h"

namespace {

const TextReader<PictureFile> read{read_picture};

// A text that may hold zeros.
template <std::size_t size>
std::string bytes(const char (&text)[size]) {
    return std::string(text, size - 1);
}

const Image example = image_of(3, 2, [](int x, int y) { return Color{0.1 * x, 0.3 * y + 0.01 * x, 1.0 - 0.2 * x}; });

bool equal(const Image& a, const Image& b) { return to_pfm(a) == to_pfm(b); }

}  // namespace

TEST_CASE("what to_ppm and to_pfm write is read: codes exactly, floats exactly") {
    const PictureFile ppm = read(to_ppm(example)), pfm = read(to_pfm(example));
    CHECK(ppm.maxval == 255);
    CHECK(to_ppm(ppm.image) == to_ppm(example));
    CHECK(equal(ppm.image, as_stored(example, 255)));
    CHECK(pfm.maxval == 0);
    CHECK(equal(pfm.image, example));
    CHECK(equal(as_stored(example, 0), example));
}

TEST_CASE("sRGB is decoded as it is encoded: every code comes back, for any largest code") {
    for (const int maxval : {1, 15, 255})
        for (int code = 0; code <= maxval; ++code) {
            const double back = maxval * srgb_encoded(srgb_decoded(static_cast<double>(code) / maxval));
            CHECK(std::fabs(back - code) < 1e-4);  // the two branches meet within 1e-7, 3e-5 of 255 codes
        }
}

TEST_CASE("P6 and P3 may have comments, any largest code, and bytes after the end") {
    const PictureFile six = read(bytes("P6#\n# 9 9\n 2 # width\n1\t255\n\377\200\0\0\1\2garbage"));
    CHECK(six.image(0, 0).x == 1);
    CHECK(std::fabs(six.image(0, 0).y - srgb_decoded(128 / 255.0)) < 1e-7);
    CHECK(six.image(1, 0).x == 0);
    const PictureFile words = read("P3\r\n1 2\r\n10\r\n10 5 0 # red\r\n0#\n10 5\r\ngarbage");
    CHECK(words.image(0, 0).x == 1);
    CHECK(std::fabs(words.image(0, 0).y - srgb_decoded(0.5)) < 1e-7);
    CHECK(words.image(0, 1).y == 1);
}

TEST_CASE("a PFM of either byte order is read, its bottom row first") {
    const PictureFile little = read(bytes("PF\n1 2\n-1.0\n\0\0\200?\0\0\0\0\0\0\0\300\0\0\0?\0\0\0\0\0\0\0\0garbage"));
    const PictureFile big = read(bytes("PF\n1 2\n2.5\n?\200\0\0\0\0\0\0\300\0\0\0?\0\0\0\0\0\0\0\0\0\0\0"));
    CHECK(equal(little.image, big.image));
    CHECK(big.image(0, 1).z == -2);
    CHECK(big.image(0, 0).x == 0.5);
}

TEST_CASE("what is no picture is refused in one line that says what is wrong") {
    CHECK(read.error("P6 1 1 255\rabc") == "");
    const std::string begins = "it begins neither with P6 or P3 (PPM) nor with PF (PFM in colour)";
    for (const auto& [text, error] : {
             std::pair(std::string(), begins),
             {"P5 1 1 255\n1", begins},
             {"Pf\n1 1\n1\n1234", begins},
             {"P6\r\n1 1\r\n255\r\nabc",
              "CR and LF end the header: were its line ends converted? write the file in binary mode"},
             {"\x89PNG\r\n", "a PNG; pngtopnm file.png > file.ppm makes of it what is read here"},
             {"P6", "the file ends where the width should be"},
             {"P6 5 0 255\n", "the height '0' is not a whole number from 1 to 8192"},
             {"P6 8193 1 255\n", "the width '8193' is not a whole number from 1 to 8192"},
             {"P6 1 1 256\n", "the largest code '256' is not a whole number from 1 to 255"},
             {"P6 1\x1b[2J 1 255\n", "the width is not a number: '1...'"},
             {"P6 99999999999999999999999 1 255\n", "the width is not a number: '99999999999999999999...'"},
             {"P6 1 1 255", "after the header there should be one space or line break"},
             {"P6 1 1 9\n\1\2\12", "row 0: code 10 exceeds the largest, 9"},
             {"P3 1 1 9\n1 2 10", "row 0: the code '10' is not a whole number from 0 to 9"},
             {"P3 1 2 9\n1 2 3\n4 x", "row 1: the code 'x' is not a whole number from 0 to 9"},
             {bytes("PF 1 2 1\n0\0\0\0000\0\0\0000\0\0\0\177\200\0\0"), "row 0: a value is infinite or no number"},
             {"P6 8192 8192 255\nabc", "row 0: the file ends inside the picture"},  // and takes no memory
             {"PF 8192 8192 1\nabc", "row 8191: the file ends inside the picture"},
             {"P3 8192 8192 1\n1", "row 0: the file ends where the code should be"},
         })
        CHECK(read.error(text) == error);
}

TEST_CASE("a picture that is cut anywhere is refused") {
    const std::string three = "P3 3 2 7\n1 2 3 4 5 6 7 6 5 4 3 2 1 0 1 2 3 4";
    for (const std::string& whole : {to_ppm(example), to_pfm(example), three}) {
        CHECK(read.error(whole) == "");
        for (std::size_t length = 0; length < whole.size(); ++length) CHECK(read.error(whole.substr(0, length)) != "");
    }
}
