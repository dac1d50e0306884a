// Of tests/output/compare.h: what judges all references.
#include "../output/compare.h"

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
          "no pixel differs, but white space in the header or the sign of a 0");
    CHECK(picture_difference(ppm("abcdef"), ppm("abcdef").substr(0, 14), 0) ==
          Containing{"14 bytes that are not a complete"});
    CHECK_THROWS_WITH(picture_difference("P6\r\n2 1\r\n255\r\nabcdef", ppm("abcdef"), 0),
                      "the reference is a damaged picture (were its line ends converted?)");
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
