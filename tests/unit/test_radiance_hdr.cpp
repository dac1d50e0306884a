#include "light/load_environment.h"
#include "test.h"

static std::vector<std::string> notes;  // of the last map
static EnvironmentMap read_hdr(const std::string& content) {
    std::istringstream in(content);
    notes.clear();
    return read_radiance_hdr(in, notes);
}

static std::vector<double> channels(const EnvironmentMap& map) {
    std::vector<double> all;
    for (int i = 1; i <= map.width * map.height; ++i)
        for (const double channel : {map.colour(i).x, map.colour(i).y, map.colour(i).z}) all.push_back(channel);
    return all;
}

static std::string bytes_of(const std::vector<int>& values) {
    std::string text;
    for (const int value : values) text += static_cast<char>(static_cast<unsigned char>(value));
    return text;
}

static std::string hdr(const std::string& size, const std::string& texels,
                       const std::string& lines = "FORMAT=32-bit_rle_rgbe") {
    return "#?RADIANCE\n" + lines + "\n\n" + size + "\n" + texels;
}

// The channels of a texel 1 2 3 under these lines.
static std::vector<double> with_lines(const std::string& lines) {
    return channels(read_hdr(hdr("-Y 1 +X 1", bytes_of({1, 2, 3, 136}), lines)));
}

// Of 8 texels. A component is three times 128, then five bytes; the exponents are one run.
static const std::string coded = bytes_of({2, 2, 0, 8, 131, 128, 5,   1, 2,   3,   4,   5,   131, 128, 5,
                                           6, 7, 8, 9, 10,  131, 128, 5, 255, 254, 253, 252, 251, 136, 136});

TEST_CASE("a flat picture decodes to mantissa * 2^(exponent - 136), or 0 for exponent 0, even if it looks coded") {
    const std::string texels = bytes_of({128, 64, 1, 129, 200, 100, 50, 0, 255, 1, 0, 255, 255, 1, 128, 1});
    CHECK(channels(read_hdr(hdr("-Y 1 +X 4", texels))) ==
          std::vector<double>{1, 0.5, 0x1p-7, 0, 0, 0, 0x1.fep126, 0x1p119, 0, 255 * 0x1p-135, 0x1p-135, 0x1p-128});
    CHECK(channels(read_hdr(hdr("-Y 1 +X 2", bytes_of({2, 2, 0, 136, 2, 2, 2, 136}))))[4] == 2);
    CHECK(channels(read_hdr(hdr("-Y 1 +X 8", bytes_of({2, 2, 128, 136}) + std::string(28, '\3'))))[2] == 128);
}

TEST_CASE("a file's radiances are the true ones times all of its exposures") {
    CHECK(with_lines("EXPOSURE=2\nEXPOSURE= 0.25") == std::vector<double>{2, 4, 6});
    CHECK(with_lines("COLORCORR=1 0.5 2\nCOLORCORR= 2 2 2 ") == std::vector<double>{0.5, 2, 0.75});
    CHECK(with_lines("EXPOSURE=.5e0, once\nCOLORCORR=1 1 1 2") == std::vector<double>{2, 4, 6});
    CHECK(notes.empty());
    for (const std::string line : {"EXPOSURE=0", "EXPOSURE=-1", "EXPOSURE=nan", "EXPOSURE=1e7", "EXPOSURE=x 1",
                                   "EXPOSURE=", "COLORCORR=1 1", "COLORCORR=1 1 0", "COLORCORR=1e7 1 1"}) {
        CHECK_MESSAGE((with_lines(line) == std::vector<double>{1, 2, 3}), line);
        CHECK(notes == std::vector<std::string>{"'" + line + "' is not from 1e-6 to 1e6, and counts as 1"});
    }
}

TEST_CASE("colours that are not the standard ones, nor none, get a note") {
    for (const std::string line : {"PRIMARIES=0.64 0.33 0.29 0.6 0.15 0.06 0.3333 0.3333", "PRIMARIES=0 0 0 0 0 0 0 0",
                                   "PRIMARIES= 0.64 0.33 0.30 0.60 0.15 0.06 0.3127 0.3290", "PRIMARIES"}) {
        with_lines(line);
        CHECK_MESSAGE(notes.empty(), line);
    }
    with_lines("PRIMARIES=0.68 0.32 0.265 0.69 0.15 0.06 0.3127 0.329");
    CHECK(notes.at(0) == Containing{"0.329' is not converted: its colours count as the standard ones"});
}

TEST_CASE("many codes of an 8-bit picture, over 255 or as they are, get a note; other values get none") {
    const auto note_of = [](int codes, int exponent, int odd) {
        std::string texels;
        for (int i = 0; i < codes; ++i) texels += bytes_of({255 - i, 255 - i, 255 - i, exponent});
        read_hdr(hdr("-Y " + std::to_string(codes + 1) + " +X 1", texels + bytes_of({odd, 128, 128, exponent - 1})));
        return notes.empty() ? "" : notes[0];
    };
    for (const int exponent : {128, 136}) {
        CHECK(note_of(250, exponent, 128) == Containing{"its values are the codes of an 8-bit picture, not radiances"});
        CHECK(note_of(250, exponent, 129) == "");
        CHECK(note_of(20, exponent, 128) == "");
    }
    CHECK(note_of(250, 129, 128) == "");
}

// Red at the top left, green behind it, and blue below.
TEST_CASE("every orientation gives the same map") {
    const std::string r = bytes_of({1, 0, 0, 136}), g = bytes_of({0, 1, 0, 136}), b = bytes_of({0, 0, 1, 136});
    const std::string k(4, '\0');
    const std::vector<double> upright = channels(read_hdr(hdr("-Y 2 +X 3", r + g + g + b + k + k)));
    CHECK(upright == std::vector<double>{1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0});
    for (const auto& each : {std::pair("-Y 2 -X 3", g + g + r + k + k + b),
                             {"+Y 2 +X 3", b + k + k + r + g + g},
                             {"+Y 2 -X 3", k + k + b + g + g + r},
                             {"+X 3 -Y 2", r + b + g + k + g + k},
                             {"+X 3 +Y 2", b + r + k + g + k + g},
                             {"-X 3 -Y 2", g + k + g + k + r + b},
                             {"-X 3 +Y 2", k + g + k + g + b + r}})
        CHECK_MESSAGE(channels(read_hdr(hdr(each.first, each.second))) == upright, each.first);
}

// Radiance's primaries: white has X = Y = Z, and red X = 0.64 / 0.33 Y and Z = 0.03 / 0.33 Y.
TEST_CASE("XYZ in lumens becomes RGB in watts, of which each has 179, and at least 0") {
    const std::string texels = bytes_of({179, 179, 179, 136, 192, 99, 9, 136, 0, 179, 0, 136});
    const std::vector<double> rgb = channels(read_hdr(hdr("-Y 1 +X 3", texels, "FORMAT=32-bit_rle_xyze")));
    const double red = 99. / 179 / 0.26507;  // its part of white's luminance is 0.26507
    const Numbers expected{1, 1, 1, red, 0, 0, 0, 1.9783, 0};
    for (std::size_t i = 0; i < 9; ++i) CHECK_MESSAGE(std::fabs(rgb[i] - expected[i]) < 3e-4, i);
}

TEST_CASE("a texel 1 1 1 n of a flat scanline repeats the one before, and others behind it 256 times as often") {
    const auto repeated = [](const std::string& width, const std::vector<int>& bytes) {
        return channels(read_hdr(hdr("-Y 1 +X " + width, bytes_of(bytes))));
    };
    std::vector<double> few(12, 7), many(3 * 516, 7);
    for (std::vector<double>* all : {&few, &many}) all->insert(all->end(), 6, 9);
    CHECK(repeated("6", {7, 7, 7, 136, 1, 1, 1, 3, 9, 9, 9, 136, 1, 1, 1, 1}) == few);
    CHECK(repeated("518", {7, 7, 7, 136, 1, 1, 1, 3, 1, 1, 1, 2, 9, 9, 9, 136, 1, 1, 1, 1}) == many);
}

TEST_CASE("coded scanlines of 8 to 32767 texels decode the runs and literals of each component, up to the longest") {
    std::vector<double> both(9, 128);
    for (int i = 0; i < 5; ++i)
        for (const double value : {1 + i, 6 + i, 255 - i}) both.push_back(value);
    for (std::size_t i = 0; i < 24; ++i) both.push_back(both[i]);
    std::string runs = bytes_of({2, 2, 127, 255}), literals = bytes_of({2, 2, 0, 128});
    for (int run = 0; run < 4 * 259; ++run) runs += bytes_of({run % 259 == 258 ? 1 : 128 + 127, 136});  // 258 * 127 + 1
    for (int component = 0; component < 4; ++component) literals += bytes_of({128}) + std::string(128, '\x88');
    for (const auto& [size, texels, decoded] : {std::tuple("-Y 2 +X 8", coded + coded, both),
                                                {"-Y 1 +X 32767", runs, std::vector<double>(3 * 32767, 136)},
                                                {"-Y 1 +X 128", literals, std::vector<double>(3 * 128, 136)}})
        CHECK(channels(read_hdr(hdr(size, texels))) == decoded);
}

TEST_CASE("a header may have CRLF, other variables, and no format") {
    const std::string texel = bytes_of({1, 2, 3, 136});
    for (const std::string& file : {"#?RGBE\r\n# comment\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n" + texel,
                                    "#?AUTOPANO\nSOFTWARE= 2.5\nGAMMA=1\n\n-Y 1 +X 1\n" + texel,
                                    "#?RADIANCE \nFORMAT= 32-bit_rle_rgbe\t \n\n-Y 1 +X 1\n" + texel}) {
        CHECK_MESSAGE((channels(read_hdr(file)) == std::vector<double>{1, 2, 3}), file);
        CHECK(notes.empty());
    }
    read_hdr("#?RADIANCE\n\n-Y 1 +X 1\n" + texel + "x");
    CHECK(notes == std::vector<std::string>{"bytes follow the last scanline; is the picture as it should be?"});
}

TEST_CASE("what is no Radiance picture, of another kind, or cut is refused with the reason") {
    const auto refused = [](const std::string& file, const std::string& reason) {
        CHECK(message_of([&] { read_hdr(file); }) == Containing{reason});
    };
    refused("<html>", "not a Radiance picture, whose first line begins with #?");
    refused("# RADIANCE\n\n-Y 1 +X 1\n", "not a Radiance picture");
    for (const char* light : {"v/1\1\2", "II*", "MM", "PF\n"})
        refused(light, " picture; `oiiotool in -o out.hdr` converts it");
    for (const char* codes : {"\x89PNG", "\xff\xd8\xff"})
        refused(codes, " picture, which holds codes; `oiiotool in --colorconvert sRGB linear -o out.hdr` makes light");
    refused("version https://git-lfs.github.com/spec/v1\n", "a pointer of git-lfs; `git lfs pull` gets the file");
    refused("#?RADIANCE", "the file ends inside the header");
    refused("#?RADIANCE\n" + std::string(5000, 'x'), "a line of the header is longer than 4095 bytes; delete it");
    std::string lines;
    for (int i = 0; i < 1001; ++i) lines += "x\n";
    refused(hdr("", "", lines), "the header has more than 1000 lines; delete those that have no '='");
    for (const std::string format : {"FORMAT=32-bit_rle_rgb", "FORMAT="})
        refused(hdr("-Y 1 +X 1", "", format), "'" + format + "' is neither 32-bit_rle_rgbe nor");
    for (const std::string size :
         {"-Y 1 +X", "-Y 1 +X 1 2", "-Y 0 +X 1", "-Y 1 +X 0", "-Y 1 +X 12px", "-Y 8193 +X 8192", "-Y 65536 +X 65536",
          "-Y 4294967299 +X 1", "-Y 1 +Y 1", "-X 1 +X 1", "-Z 1 +X 1", "*Y 1 +X 1"})
        refused(hdr(size, ""), "resolution line '" + size + "': it should be '-Y height +X width'");
    const auto row_refused = [&](const std::vector<int>& bytes, const std::string& reason) {
        refused(hdr("-Y 2 +X 8", coded + bytes_of(bytes)), reason);
    };
    row_refused({1, 1, 1, 2}, "a run has no texel before it, or ends after the scanline");
    row_refused({5, 5, 5, 136, 1, 1, 1, 8}, "a run has no texel before it, or ends after the scanline");
    for (const int code : {137, 9, 0, 128})
        row_refused({2, 2, 0, 8, code, 1, 1, 1, 1, 1, 1, 1, 1, 1}, "a run is empty, or ends after");
    row_refused({2, 2, 0, 9}, "the scanline announces another width than the header");
    row_refused({2, 2, 1, 8}, "the scanline announces another width than the header");
    row_refused({2, 2, 0, 8, 136}, "the file ends inside a scanline");
}

TEST_CASE("an error of reading is not the end of a map, wherever it is") {
    check_failing_reads(hdr("-Y 1 +X 8", coded), [](std::istream& in) { read_radiance_hdr(in, notes); });
}
