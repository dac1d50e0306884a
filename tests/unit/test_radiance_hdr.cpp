#include "light/radiance_hdr.h"

#include "test.h"

namespace {

const TextReader<EnvironmentMap> read{read_radiance_hdr};

std::string bytes(const std::vector<int>& values) {
    std::string text;
    for (const int value : values) text += static_cast<char>(static_cast<unsigned char>(value));
    return text;
}

std::string header(const std::string& size) { return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n"; }

// A new-style component of 8 texels: three times 128, then the five bytes given.
std::vector<int> component(int a, int b, int c, int d, int e) { return {131, 128, 5, a, b, c, d, e}; }

std::string new_style_scanline() {
    std::vector<int> scanline{2, 2, 0, 8};
    for (const std::vector<int>& part : {component(1, 2, 3, 4, 5), component(6, 7, 8, 9, 10),
                                         component(255, 254, 253, 252, 251), std::vector<int>{136, 136}})
        scanline.insert(scanline.end(), part.begin(), part.end());
    return bytes(scanline);
}

}  // namespace

TEST_CASE("a flat Radiance picture decodes to mantissa * 2^(exponent - 136)") {
    // The last texel has subnormal numbers.
    const EnvironmentMap map = read(header("-Y 1 +X 5") + bytes({128, 64, 1,   129, 255, 255, 255, 136, 200, 100,
                                                                 50,  0,  255, 1,   0,   255, 255, 1,   128, 1}));
    CHECK(map.width() == 5);
    CHECK(values(map) == std::vector<float>{1.0f, 0.5f, 0x1p-7f, 255, 255, 255, 0, 0, 0, 0x1.fep126f, 0x1p119f, 0,
                                            255 * 0x1p-135f, 0x1p-135f, 0x1p-128f});
}

TEST_CASE("a long file is read to its end, flat or in new-style scanlines") {
    // 7 texels a row are too few for new-style scanlines; 119,994 texels of 4 bytes are more than is read at a time.
    std::vector<int> flat;
    std::vector<float> expected;
    for (int i = 0; i < 7 * 17142; ++i)
        for (const int value : {i % 101 + 3, i % 103, i % 107, 136}) {
            flat.push_back(value);
            if (value != 136) expected.push_back(static_cast<float>(value));
        }
    CHECK(values(read(header("-Y 17142 +X 7") + bytes(flat))) == expected);
    std::string rows;
    for (int row = 0; row < 5000; ++row) rows += new_style_scanline();
    const std::vector<float> many = values(read(header("-Y 5000 +X 8") + rows));
    REQUIRE(many.size() == 5000 * 24);
    CHECK(std::equal(many.begin() + 24, many.end(), many.begin()));  // each row is the one before
}

TEST_CASE("new-style scanlines decode runs and literals of each component") {
    const EnvironmentMap map = read(header("-Y 2 +X 8") + new_style_scanline() + new_style_scanline());
    std::vector<float> expected;
    for (int row = 0; row < 2; ++row) {
        expected.insert(expected.end(), 9, 128.0f);
        for (int i = 0; i < 5; ++i)
            for (const int value : {1 + i, 6 + i, 255 - i}) expected.push_back(static_cast<float>(value));
    }
    CHECK(values(map) == expected);
}

TEST_CASE("new-style scanlines have up to 32767 texels") {
    std::vector<int> scanline{2, 2, 127, 255};
    for (int component = 0; component < 4; ++component) {
        for (int run = 0; run < 258; ++run) scanline.insert(scanline.end(), {128 + 127, 136});  // 258 * 127 = 32766
        scanline.insert(scanline.end(), {1, 136});
    }
    CHECK(values(read(header("-Y 1 +X 32767") + bytes(scanline))) == std::vector<float>(3 * 32767, 136));
}

TEST_CASE("a picture that begins like a new-style scanline but is too narrow for one is flat") {
    const EnvironmentMap map = read(header("-Y 1 +X 2") + bytes({2, 2, 0, 136, 2, 2, 2, 136}));
    CHECK(values(map) == std::vector<float>{2, 2, 0, 2, 2, 2});
}

TEST_CASE("headers may end their lines with CRLF, carry other variables, lack a format, and be followed by anything") {
    const std::string texel = bytes({1, 2, 3, 136});
    for (const std::string& file : {"#?RGBE\r\n# comment\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n" + texel,
                                    "#?RADIANCE\nFORMAT= 32-bit_rle_rgbe \n\n-Y 1 +X 1\n" + texel,
                                    "#?RADIANCE\nEXPOSURE= 2.5\nGAMMA=1\n\n-Y 1 +X 1\n" + texel + "garbage"})
        CHECK(values(read(file)) == std::vector<float>{1, 2, 3});
}

TEST_CASE("what is no Radiance picture, or one of a kind that is not supported, is refused with the reason") {
    const std::string first = "first line should be #?RADIANCE or #?RGBE", variables = "#?RADIANCE\nFORMAT=";
    for (const auto& row : {
             std::pair(std::string(), first),
             {"#", first},
             {"P6\n1 1\n255\n", first},
             {"#?RADIANT\n\n-Y 1 +X 1\n", first},
             {variables + "32-bit_rle_xyze\n\n-Y 1 +X 1\n", "'32-bit_rle_xyze' is not supported"},
             {header("+Y 1 +X 1"), "'+Y 1 +X 1' is not supported, only '-Y height +X width'"},
             {header("-Y 1 +X 1 2"), "resolution line '-Y 1 +X 1 2'"},
             {header("-Y 0 +X 1"), "resolution line '-Y 0 +X 1'"},
             {header("-Y 1 +X 12px"), "resolution line '-Y 1 +X 12px'"},
             {header("-Y 99999999999999999999 +X 1"), "resolution line '-Y 99999999999999999999 +X 1'"},
             {header("-Y 8193 +X 8192"), "exceeds the limit of 67108864"},
             {"#?RADIANCE\n\n-Y 1 +X 1", "ends inside the header"},
             {"#?" + std::string(5000, 'x'), "longer than 4096"},
             {header("-Y 1 +X 2") + bytes({9, 9, 9, 136, 1, 1, 1, 1}), "row 0: runs of the oldest kind"},
             {header("-Y 1 +X 2") + bytes({1, 1, 1, 2}), "row 0: runs of the oldest kind are not supported"},
             {header("-Y 1 +X 8") + bytes({2, 2, 0, 8, 137, 1}), "row 0: a run goes past the end of the scanline"},
             {header("-Y 1 +X 8") + bytes({2, 2, 0, 8, 9, 1}), "row 0: a run goes past the end of the scanline"},
             {header("-Y 1 +X 8") + bytes({2, 2, 0, 8, 0, 1}), "row 0: a run of length 0"},
             {header("-Y 1 +X 8") + bytes({2, 2, 0, 9}), "row 0: the scanline announces 9 texels instead of 8"},
             {header("-Y 8192 +X 8192") + bytes({9, 9, 9, 136}), "row 0: the file ends inside a scanline"},
         }) {
        INFO(row.second);
        CHECK(contains(read.error(row.first), row.second));
    }
}

TEST_CASE("a picture that is cut anywhere is refused, and within the picture the row is named") {
    const std::string file = header("-Y 2 +X 8") + new_style_scanline() + new_style_scanline();
    for (std::size_t length = 0; length < file.size(); ++length) CHECK(read.error(file.substr(0, length)) != "");
    CHECK(read.error(file.substr(0, file.size() - 1)) == "row 1: the file ends inside a scanline");
}

TEST_CASE("a map that is written and read back is off by half a step of its texel's largest channel at most") {
    std::vector<float> rgb{0, 0, 0, 1, 0.5f, 0.25f, 0.999f, 0.001f, 0, 3e38f, 1, 0, 1e-45f, 0, 0, 255.4f, 255.6f, 7};
    Random random(1, 0);
    for (int i = 0; i < 3 * 94; ++i) rgb.push_back(static_cast<float>(portable::exp(40 * random.uniform() - 20)));
    const EnvironmentMap map(10, 10, rgb);
    const std::vector<float> back = values(read(to_radiance_hdr(map)));
    REQUIRE(back.size() == rgb.size());
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        // A mantissa of 128 is a largest channel of at least 127.75: that, of 255.5, rounds to 128 of the next
        // exponent.
        const double largest = std::max({rgb[i], rgb[i + 1], rgb[i + 2], 2e-38f});
        if (largest > 1e38) continue;  // clamped
        for (std::size_t j = i; j < i + 3; ++j) CHECK(std::fabs(double{back[j]} - double{rgb[j]}) <= largest / 255.5);
    }
    CHECK(back[9] == 255 * 0x1p119f);
    // 255.6 is nearer to 128 * 2 than to 255, and all of its texel goes in steps of 2.
    CHECK(std::vector<float>(back.begin() + 15, back.begin() + 18) == std::vector<float>{256, 256, 8});
    CHECK(std::vector<float>(back.begin(), back.begin() + 6) == std::vector<float>{0, 0, 0, 1, 0.5f, 0.25f});
}
