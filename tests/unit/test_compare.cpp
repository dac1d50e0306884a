// Of tests/output/compare.h: what judges all references.
#include "../output/compare.h"
#include "../output/picture.h"

#include "test.h"

static const std::string table = "# n error\n10 0.5\n20 -0.25\n40 0\n# sum 0.25; half\n";

TEST_CASE("texts differ where their first line does") {
    const auto difference = [](const std::string& actual) { return text_difference(table, actual, 0); };
    CHECK(difference("# n error\n10 0.5\n20 -0.26\n40 0\n# sum 0.25; half\n") ==
          "row 2 (line 3), column 2: reference -0.25, here -0.26; 1 of 5 lines differs");
    CHECK(difference("# n error\n10\n20 -0.25\n40 0\n# sum 0.25\n") ==
          "line 2, reference: 10 0.5, here: 10; 2 of 5 lines differ");
    CHECK(difference("") == "line 1, reference: # n error, here: nothing; the reference has 5 lines, here are 0");
    CHECK(difference(table.substr(0, table.size() - 1)) == "only the line end after the last line differs");
}

TEST_CASE("a reference may have Windows line ends, an output may not") {
    CHECK(text_difference("10\r\n20\r\n", "10\n20\n", 0) == "");
    CHECK(text_difference("10\n", "10\r\n", 0) ==
          "line 1, reference: 10: only white space differs; 1 of 1 lines differs");
}

TEST_CASE("tolerant, numbers agree within a relative 0.001 plus 1e-9, and words exactly") {
    const auto difference = [](const std::string& actual) { return text_difference(table, actual, 1e-3); };
    CHECK(difference("# n  error\n10 0.50049\n20 -0.25\n40 9e-10\n# sum 0.2501; half\n") == "");
    CHECK(difference("# n error\n10 0.50051\n20 -0.25\n40 0\n# sum 0.25; half\n") ==
          "row 1 (line 2), column 2: reference 0.5, here 0.50051; 1 of 5 lines differs");
    CHECK(difference("# n error\n10 0.5\n20 -0.25\n40 0\n# sum 0.25: half\n") ==
          Containing{"line 5, reference: # sum"});
    CHECK(text_difference("# n\n10\n\n# Q\n1 2\n3 4\n", "# n\n10\n\n# Q\n1 2\n3 5\n", 1e-3) ==
          "row 3 (line 6), column 2: reference 4, here 5; 1 of 6 lines differs");
}

// A picture of one row; of a PFM as a file of the other byte order if the scale is positive.
static std::string ppm(const std::string& codes) { return formatted("P6\n%zu 1\n255\n", codes.size() / 3) + codes; }
static std::string pfm(int width, int height, const std::vector<float>& values, const char* scale = "-1.0") {
    std::string bytes = formatted("PF\n%d %d\n%s\n", width, height, scale);
    for (const float value : values) {
        const std::uint32_t word = portable::bit_cast<std::uint32_t>(value);
        for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> 8 * (*scale == '-' ? k : 3 - k) & 255);
    }
    return bytes;
}

TEST_CASE("pictures differ at their first pixel, and by their errors there") {
    CHECK(picture_difference(ppm("abcdef"), ppm("abcdeg"), 0) ==
          "pixel (x 1, y 0), blue: reference 102, here 103; 1 of 2 pixels differs, at most by 1; there the RMSE is "
          "0.0016, the brightness is off by +0.7 %");
    CHECK(picture_difference(pfm(1, 1, {2, 1, 1}), pfm(1, 1, {NAN, 2, 1}), 0) ==
          "pixel (x 0, y 0), red: reference 2, here nan; 1 of 1 pixels differs, at most by 1");
    CHECK(picture_difference("P6\n2 1\n255\nabcdef", "P6 2 1\n255\nabcdef", 0) ==
          "no pixel differs, but the form of the file: white space, text for bytes, or the sign of a 0");
    CHECK_THROWS_WITH(picture_difference("P6\n2 1\n255\nabcde", ppm("abcdef"), 0),
                      "the reference is damaged: bytes that are missing at the end: 1");
}

TEST_CASE("a PFM begins with the bottom row, and the sign of its scale orders its bytes") {
    for (const char* scale : {"-1.0", "1.0"})
        CHECK(picture_difference(pfm(1, 2, {1, 1, 1, 2, 2, 2}, scale), pfm(1, 2, {1, 2, 1, 2, 2, 2}, scale), 0) ==
              "pixel (x 0, y 1), green: reference 1, here 2; 1 of 2 pixels differs, at most by 1; there the RMSE is "
              "0.577, the brightness is off by +33.3 %");
}

TEST_CASE("tolerant, one pixel in a thousand may differ") {
    const std::string grey(3 * 1600, 'a');
    std::string spot = grey;
    spot[5] = 'b';
    CHECK(picture_difference(ppm(grey), ppm(spot), 1e-3) == "");
    spot[6] = 'b';
    CHECK(picture_difference(ppm(grey), ppm(spot), 1e-3) ==
          Containing{"pixel (x 1, y 0), blue: reference 97, here 98; 2 of"});
}

TEST_CASE("a picture that is not read is named: how many bytes, text mode, another kind") {
    const auto difference = [](const std::string& actual) { return picture_difference(ppm("abcdef"), actual, 0); };
    CHECK(difference(ppm("abcdef").substr(0, 14)) == Containing{"bytes that are missing at the end: 3"});
    CHECK(difference(ppm("abcdef") + "\n") == Containing{"no pixel differs, but the form"});
    CHECK(difference(ppm("abcdef") + "\r\n") == Containing{"bytes behind the last pixel: 2"});
    CHECK(!contains(difference(ppm("abcdef") + "\r\n"), "text mode"));
    CHECK(difference("P6\r\n2 1\r\n255\r\na\r\nbcde") ==
          Containing{"last pixel: 2; it was written in text mode, with CR before LF: open the file in binary mode"});
    CHECK(difference("\x89PNG\r\n") == Containing{"it begins with none of P6, P3, PF and #?"});
    CHECK(difference(std::string("\xff\xfeP\0006\0", 6)) == Containing{"it is UTF-16, as PowerShell's > writes it"});
    CHECK(difference("P6\n2 1\n65535\nabcdef") == Containing{"its largest code is 65535; only 255 is supported"});
    CHECK(difference("P6\n2 0\n255\n") == Containing{"its size 2 x 0 is not from 1 x 1"});
    CHECK(difference("P6\n2") == Containing{"it ends inside the header"});
}

TEST_CASE("P3 is a PPM in text; a PFM's scale multiplies; an .hdr is linear light") {
    const std::string text = "P3\n2 1\n255\n97 98 99\n100 101 102\n";
    CHECK(picture_difference(ppm("abcdef"), text, 1e-3) == "");
    CHECK(picture_difference(ppm("abcdef"), text.substr(0, text.size() - 5), 0) ==
          Containing{"row 0, column 1: no code from 0 to 255"});
    CHECK(picture_difference(ppm("abcdef"), "P3\n9999 9999\n255\n1", 0) == Containing{"it ends before the last pixel"});
    CHECK(parse_picture(pfm(1, 1, {2, 1, 0.5}, "-2")).values(0, 0) == Vec3{4, 2, 1});
    CHECK(parse_picture(pfm(1, 1, {2, 1, 0.5}, "0.5")).values(0, 0) == Vec3{1, 0.5, 0.25});
    const Picture light = parse_picture("#?RADIANCE\n\n-Y 1 +X 2\n" + std::string("\1\2\3\210\4\5\6\210"));
    CHECK(linear_light(light).pixels == std::vector<Colour>{{1, 2, 3}, {4, 5, 6}});
}
