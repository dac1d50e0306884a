#include "light/environment.h"
#include "test.h"

static EnvironmentMap read_hdr(const std::string& content) {
    std::istringstream in(content);
    return read_radiance_hdr(in);
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
    const std::string texels = bytes_of({128, 64, 1, 129, 200, 100, 50, 0, 255, 1, 0, 247, 255, 1, 128, 1});
    CHECK(channels(read_hdr(hdr("-Y 1 +X 4", texels))) ==
          std::vector<double>{1, 0.5, 0x1p-7, 0, 0, 0, 0x1.fep118, 0x1p111, 0, 255 * 0x1p-135, 0x1p-135, 0x1p-128});
    CHECK(channels(read_hdr(hdr("-Y 1 +X 2", bytes_of({2, 2, 0, 136, 2, 2, 2, 136}))))[4] == 2);
    CHECK(channels(read_hdr(hdr("-Y 1 +X 8", bytes_of({2, 2, 128, 136}) + std::string(28, '\3'))))[2] == 128);
}

TEST_CASE("a file's radiances are the true ones times all of its exposures") {
    CHECK(with_lines("EXPOSURE=2\nEXPOSURE= 0.25") == std::vector<double>{2, 4, 6});
    CHECK(with_lines("EXPOSURE=.5e0, once\nCOLORCORR=1 0.5 2\nPRIMARIES=1 1") == std::vector<double>{2, 4, 6});
    CHECK(stderr_of([] {
              CHECK(with_lines("EXPOSURE=2\nEXPOSURE= 0.0") == std::vector<double>{0.5, 1, 1.5});
          }) == Containing{": note: the light's EXPOSURE=0 counts as 1\n"});
    for (const std::string line :
         {"EXPOSURE=-1", "EXPOSURE=nan", "EXPOSURE=1e7", "EXPOSURE=x 1", "EXPOSURE=", "EXPOSURE=1e-4\nEXPOSURE=1e-4"})
        CHECK(message_of([&] { with_lines(line); }) == "the product of the EXPOSURE lines is not from 1e-6 to 1e6");
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

TEST_CASE("a header may have CRLF, other variables, and no format; what follows the last scanline does not count") {
    const std::string texel = bytes_of({1, 2, 3, 136});
    for (const std::string& file :
         {"#?RGBE\r\n# comment\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n" + texel,
          "#?AUTOPANO\nSOFTWARE= 2.5\nGAMMA=1\n\n-Y 1 +X 1\n" + texel, "#?\nx\n\n-Y 1 +X 1\n" + texel + "more",
          "#?RADIANCE \nFORMAT= 32-bit_rle_rgbe\t \n\n-Y 1 +X 1\n" + texel}) {
        CHECK_MESSAGE((channels(read_hdr(file)) == std::vector<double>{1, 2, 3}), file);
    }
}

TEST_CASE("what is no Radiance picture, of another kind, or cut is refused with the reason") {
    const auto refused = [](const std::string& file, const std::string& reason) {
        CHECK(message_of([&] { read_hdr(file); }) == Containing{reason});
    };
    const std::string what_is_read = ": a light is a Radiance picture as `oiiotool in -o out.hdr` writes it";
    for (const char* file :
         {"", "#", "<html>", "# RADIANCE\n\n-Y 1 +X 1\n", "v/1\1\2", "PF\n", "\x89PNG", "\xff\xd8\xff"})
        refused(file, "its first line does not begin with #?" + what_is_read);
    refused("#?RADIANCE", "the header ends early, or has a line of more than 4095 bytes");
    refused("#?RADIANCE\n" + std::string(5000, 'x'), "the header ends early, or has a line of more than 4095 bytes");
    std::string lines;
    for (int i = 0; i < 1001; ++i) lines += "x\n";
    refused(hdr("", "", lines), "the header has more than 1000 lines");
    for (const std::string format : {"FORMAT=32-bit_rle_rgb", "FORMAT=32-bit_rle_xyze", "FORMAT="})
        refused(hdr("-Y 1 +X 1", "", format), "'" + format + "'" + what_is_read);
    for (const std::string size :
         {"-Y 1 +X", "-Y 1 +X 1 2", "-Y 0 +X 1", "-Y 1 +X 0", "-Y 1 +X 12px", "-Y 4294967299 +X 1", "-Y 1 +Y 1",
          "-Y 1 -X 1", "+Y 1 +X 1", "+X 1 -Y 1", "-Z 1 +X 1", "*Y 1 +X 1"})
        refused(hdr(size, ""),
                "resolution line '" + size +
                    "' is not '-Y height +X width': a light is a Radiance picture as `oiiotool in --reorient -o");
    for (const std::string size : {"-Y 8193 +X 8192", "-Y 65536 +X 65536"})
        refused(hdr(size, "", "EXPOSURE=4"), "67108864; `oiiotool in --divc 4 --resize 4096x0 -o out.hdr` makes fewer");
    const auto row_refused = [&](const std::vector<int>& bytes, const std::string& reason) {
        refused(hdr("-Y 2 +X 8", coded + bytes_of(bytes)), reason);
    };
    row_refused({5, 5, 5, 136, 1, 1, 1, 7}, "a scanline has a run of before 1991" + what_is_read);
    for (const int code : {133, 5, 0, 128})  // behind a run of four
        row_refused({2, 2, 0, 8, 132, 1, code, 1, 1, 1, 1, 1, 1, 1, 1, 1}, "a run is empty, or ends after");
    row_refused({2, 2, 0, 9}, "a scanline has a wrong width");
    row_refused({2, 2, 1, 8}, "a scanline has a wrong width");
    row_refused({2, 2, 0, 8, 136}, "the file ends inside a scanline");
    refused(hdr("-Y 1 +X 1", bytes_of({1, 2, 1, 255})), "a radiance exceeds 1e36");
}

TEST_CASE("an error of reading is not the end of a map, wherever it is") {
    check_failing_reads(hdr("-Y 1 +X 8", coded.substr(0, coded.size() - 1)),
                        [](std::istream& in) { read_radiance_hdr(in); });
}
