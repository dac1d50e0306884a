// Of tests/output/difference.h: what judges all references.
#include "../output/difference.h"

#include "test.h"

static const std::string table = "# n error\n10 0.5\n20 -0.25\n40 nan\n# sum 0.25; half\n";

TEST_CASE("texts differ where their first word does, and in white space") {
    CHECK(difference(table, "# n error\n10 0.5\n20 -0.26\n40 nan\n# sum 0.25; half\n", 0) ==
          "line 3: reference -0.25, here -0.26; 1 of 13 words differ");
    CHECK(difference(table, "# n error\n10 0.5\n", 0) == "line 3: reference 20, here nothing; 8 of 13 words differ");
    CHECK(difference("1", "1\n2", 0) == "line 2: reference nothing, here 2; 1 of 2 words differ");
    for (const std::string& other : {table.substr(0, table.size() - 1), "  " + table, "\xEF\xBB\xBF" + table})
        CHECK(difference(table, other, 0) == "no word differs, but white space or a byte order mark");
}

TEST_CASE("tolerant, numbers agree within a relative 0.001 plus 1e-9, and words exactly") {
    const auto with = [](const std::string& row) { return difference(table, "# n error\n" + row, 1e-3); };
    for (const char* word : {"nan", "-nan", "NaN", "-nan(ind)"})
        CHECK(with("10  0.50049\n20 -0.25\n40 " + std::string(word) + "\n# sum 0.2501; half\n") == "");
    CHECK(with("10 0.50051\n20 -0.25\n40 nan\n# sum 0.25; half\n") == Containing{"reference 0.5, here 0.50051;"});
    CHECK(with("10 nan\n20 -0.25\n40 nan\n# sum 0.25; half\n") == Containing{"line 2: reference 0.5, here nan;"});
    CHECK(with("10 0.5\n20 -0.25\n40 7\n# sum 0.25; half\n") == Containing{"line 4: reference nan, here 7;"});
    CHECK(with("10 0.5\n20 -0.25\n40 nan\n# sum 0.25: half\n") == Containing{"line 5: reference 0.25;, here 0.25:"});
    CHECK(difference("half 0", "halves 0half", 1e-3) == "line 1: reference half, here halves; 2 of 2 words differ");
    CHECK(difference("0 -inf", "9e-10 -Infinity", 1e-3) == "");
    CHECK(difference("0 inf", "2e-9 1", 1e-3) == "line 1: reference 0, here 2e-9; 2 of 2 words differ");
}

static std::string ppm(const std::string& codes) { return formatted("P6\n%zu 1\n255\n", codes.size() / 3) + codes; }
static std::string pfm(const std::vector<Colour>& colours) {  // of one column
    Image image(1, static_cast<int>(colours.size()));
    image.pixels = colours;
    return encode(image, Format::pfm);
}

TEST_CASE("pictures differ at their first pixel, and by their errors there; one in a thousand may, tolerant") {
    CHECK(difference(ppm("abcdef"), ppm("abcdeg"), 0) ==
          "pixel (x 1, y 0): reference 102, here 103; 1 of 2 pixels differ; there the RMSE is 0.0016, the brightness "
          "is off by +0.7 %");
    CHECK(difference(pfm({{2, 1, 1}, {}}), pfm({{2, NAN, 1}, {}}), 0) ==
          "pixel (x 0, y 0): reference 1, here nan; 1 of 2 pixels differ");
    CHECK(difference(pfm({{}, {1, 1, 1}}), pfm({{}, {1, 2, 1}}), 0) ==
          Containing{"(x 0, y 1): reference 1, here 2; 1"});
    CHECK(difference(pfm({{2, 1, 1}}), pfm({{2, 1.0009, 1}}), 1e-3) == "");
    CHECK(difference(pfm({{2, 1, 1}}), pfm({{2, 1.0009, 1}}), 0) == Containing{"reference 1, here 1.0009"});
    std::string grey(3 * 1600, 'a'), spot = grey;
    spot[5] = 'b';
    CHECK(difference(ppm(grey), ppm(spot), 1e-3) == "");
    spot[6] = 'b';
    CHECK(difference(ppm(grey), ppm(spot), 0.1) == Containing{"pixel (x 1, y 0): reference 97, here 98; 2 of 1600"});
}

TEST_CASE("the same numbers in another form are the same picture") {
    for (const char* other : {"P6 2 1\n255\nabcdef", "P6\n# by\n#GIMP\n2#1\n1\n# 8\n255# bits\nabcdef",
                              "P3\n2 1\n255\n97 98 99 # red\n100 101\n102 # end"})
        CHECK(difference(ppm("abcdef"), other, 0) == "");
    const std::string one("P6 1 1 65535\n\0\1\0\1\0\1", 19), two("P6 1 1 65535\n\0\1\1\2\0\1", 19);
    CHECK(difference(one, two, 0) == Containing{"reference 1, here 258; 1 of 1 pixels differ; there the RMSE is 0.00"});
    const std::string big_endian("PF\n1 2\n2\n\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0\x3f\0\0\0\x3e\x80\0\0", 33);
    CHECK(difference(pfm({{2, 1, 0.5}, {}}), big_endian, 0) == "");  // twice 1, 1/2 and 1/4
    const std::string radiance = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x40\x20\x81";
    CHECK(difference(pfm({{1, 0.5, 0.25}}), radiance, 0) == "");
}

TEST_CASE("over objects, pictures of any kind have errors, and the background has none") {
    Image truth(40, 40), image(40, 40);
    for (Colour& pixel : image.pixels) pixel = {7, 7, 7};  // of the background
    for_each_hit({40, 40}, [&](int x, int y, const Hit&) {
        truth(x, y) = {0.5, 0.5, 0.5};  // each column of the right half mirrors one of the other parity
        image(x, y) = (x % 2 == 0 ? 1.3 : 1.1) * truth(x, y);
    });
    const std::string expected = encode(truth, Format::pfm), found = encode(image, Format::pfm);
    CHECK(difference(expected, found, 0, true) ==
          "over objects the RMSE is 0.112, the brightness is off by +20.0 %, and neighbours' errors correlate by "
          "-1.00");
    CHECK(difference(encode(truth, Format::ppm), found, 0, true) == Containing{"off by +19.3 %"});
    CHECK(difference(encode(Image(40, 40), Format::pfm), found, 0, true) == "no light is reflected by objects");
    CHECK(difference(expected, encode(Image(40, 20), Format::pfm), 0, true) ==
          "reference: 40 x 40, floats, here: 40 x 20, floats");
    std::fill_n(image.pixels.begin(), 800, Colour{1, nan_value, 1});  // the upper half
    CHECK(difference(expected, encode(image, Format::pfm), 0, true) ==
          "over objects the RMSE is 0.112, the brightness is off by +20.0 %, without 362 of 1064 pixels that are no "
          "numbers, the first (x 16, y 5)");
    CHECK(difference(table, found, 0, true) == "reference: no picture, here: 40 x 40, floats");
}

TEST_CASE("a picture of another kind or size, in text, or cut is told from one that is right") {
    const auto said = [](const std::string& bytes) { return difference(ppm("abcdef"), bytes, 0); };
    CHECK(said(ppm("abc")) == "reference: 2 x 1, codes up to 255, here: 1 x 1, codes up to 255");
    CHECK(said(encode(Image(1, 1), Format::bmp)) == Containing{"here: neither a text nor a picture that can be read"});
    CHECK(said(std::string("\xFF\xFE#\0", 4)) == Containing{"here: a text in UTF-16"});
    CHECK(said("P6\n-2 1\n255\nabcdef") == "here: the width '-2' is not a number from 1 to 65535");
    CHECK(said("P3\n1 1\n255\n1 256 1") == "here: the code '256' is not a number from 0 to 255");
    CHECK(said(ppm("abcdef") + ppm("abcdef")) ==
          "here: a picture of 2 x 1, codes up to 255, and another one behind it");
    for (const std::string& bytes : {ppm("abcdef") + "\r\n", ppm("abcdef").substr(0, 12), std::string("P6\n2 1\n255"),
                                     std::string("P3\n9999 9999\n255\n1"), pfm({{}}).substr(0, 20)})
        CHECK(said(bytes) == Containing{", which ends early or late (was it written in text mode?)"});
    CHECK_THROWS_AS(difference(ppm("abcdef").substr(0, 12), ppm("abcdef"), 0), std::runtime_error);
}
