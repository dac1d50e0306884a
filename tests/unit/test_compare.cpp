// Of tests/output/difference.h: what judges all references.
#include "../output/difference.h"

#include "test.h"

static const std::string table = "# n error\n10 0.5\n20 -0.25\n40 0\n# sum 0.25; half\n";
static const char* const formal = "no word differs, but white space, a byte order mark, or the form of the numbers";

TEST_CASE("texts differ where their first word does, and in white space") {
    CHECK(difference(table, table, 0) == "");
    CHECK(difference(table, "# n error\n10 0.5\n20 -0.26\n40 0\n# sum 0.25; half\n", 0) ==
          "line 3: reference -0.25, here -0.26; 1 of 13 words differ");
    CHECK(difference(table, "# n error\n10 0.5\n", 0) == "line 3: reference 20, here nothing; 8 of 13 words differ");
    for (const std::string& other : {table.substr(0, table.size() - 1), "  " + table, "\xEF\xBB\xBF" + table})
        CHECK(difference(table, other, 0) == formal);
}

TEST_CASE("tolerant, numbers agree within a relative 0.001 plus 1e-9, and words exactly") {
    const auto with = [](const std::string& row) { return difference(table, "# n error\n" + row, 1e-3); };
    CHECK(with("10  0.50049\n20 -0.25\n40 9e-10\n# sum 0.2501; half\n") == "");
    CHECK(with("10 0.50051\n20 -0.25\n40 0\n# sum 0.25; half\n") == Containing{"line 2: reference 0.5, here 0.50051;"});
    CHECK(with("10 0.5\n20 -0.25\n40 2e-9\n# sum 0.25; half\n") == Containing{"line 4: reference 0, here 2e-9;"});
    CHECK(with("10 nan\n20 -0.25\n40 0\n# sum 0.25; half\n") == Containing{"line 2: reference 0.5, here nan;"});
    CHECK(with("10 0.5\n20 -0.25\n40 0\n# sum 0.25: half\n") == Containing{"line 5: reference 0.25;, here 0.25:"});
    for (const std::string word : {"halves", "0half"})
        CHECK(with("10 0.5\n20 -0.25\n40 0\n# sum 0.25; " + word + "\n") == Containing{"reference half, here " + word});
    std::string thousands;
    for (int i = 0; i < 3000; ++i) thousands += "7 ";
    CHECK(difference(thousands + "1", thousands + "2", 1e-3) == Containing{"1 of 3001 words differ"});
}

// Of one row; and of one column, in a file of the other byte order if the scale is positive.
static std::string ppm(const std::string& codes) { return formatted("P6\n%zu 1\n255\n", codes.size() / 3) + codes; }
static std::string pfm(const std::vector<Colour>& colours, const char* scale = "-1.0") {
    Image image(1, static_cast<int>(colours.size()));
    image.pixels = colours;
    const std::string bytes = encode(image, Format::pfm), header = "PF\n1 " + std::to_string(colours.size()) + "\n";
    std::string floats = bytes.substr(bytes.size() - 12 * colours.size());
    for (std::size_t i = 0; i < floats.size() && *scale != '-'; i += 4) std::reverse(&floats[i], &floats[i] + 4);
    return header + scale + "\n" + floats;
}

TEST_CASE("pictures differ at their first pixel, and by their errors there") {
    CHECK(difference(ppm("abcdef"), ppm("abcdeg"), 0) ==
          "pixel (x 1, y 0): reference 102, here 103; 1 of 2 pixels differ; there the RMSE is 0.0016, the brightness "
          "is off by +0.7 %");
    CHECK(difference(pfm({{2, 1, 1}}), pfm({{NAN, 2, 1}}), 0) ==
          "pixel (x 0, y 0): reference 2, here nan; 1 of 1 pixels differ");
    for (const char* scale : {"-1.0", "1.0"})
        CHECK(difference(pfm({{2, 2, 2}, {1, 1, 1}}, scale), pfm({{2, 2, 2}, {1, 2, 1}}, scale), 0) ==
              "pixel (x 0, y 1): reference 1, here 2; 1 of 2 pixels differ; there the RMSE is 0.577, the brightness is "
              "off by +33.3 %");
    CHECK(difference(pfm({{2, 1, 0.5}}), pfm({{1, 0.5, 0.25}}, "-2"), 1e-3) == "");
    CHECK(difference("P6\n2 1\n255\nabcdef", "P6 2 1\n255\nabcdef", 0) == formal);
    CHECK(difference("P6\n2 1\n255\nabcdef", "P6\n# by\n#GIMP\n2 1\n# 8\n255\nabcdef", 0) == "");
    const std::string one("P6 1 1 65535\n\0\1\0\1\0\1", 19), two("P6 1 1 65535\n\0\1\0\2\0\1", 19);
    CHECK(difference(one, two, 0) ==
          Containing{"reference 1, here 2; 1 of 1 pixels differ; there the RMSE is 6.82e-07"});
}

TEST_CASE("a Radiance picture has floats") {
    const std::string radiance = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x80\x40\x20\x81";
    CHECK(difference(pfm({{1, 0.5, 0.25}}), radiance, 0) == formal);
    CHECK(difference(radiance, pfm({{1, 0.5, 0.2}}), 0) == Containing{"reference 0.25, here 0.2"});
    CHECK(difference(pfm({{}}), radiance.substr(0, radiance.size() - 1), 0) == "here: the file ends inside a scanline");
}

TEST_CASE("over objects, pictures of any kind have errors, and the background has none") {
    Image truth(40, 40), image(40, 40);
    for (Colour& pixel : image.pixels) pixel = {7, 7, 7};  // of the background
    for_each_hit(sphere_scene, {40, 40}, [&](int x, int y, const Hit&) {
        truth(x, y) = {0.5, 0.5, 0.5};  // each column of the right half mirrors one of the other parity
        image(x, y) = (x % 2 == 0 ? 1.3 : 1.1) * truth(x, y);
    });
    const std::string expected = encode(truth, Format::pfm), found = encode(image, Format::pfm);
    const char* const words =
        "over objects the RMSE is 0.112, the brightness is off by +20.0 %, and neighbours' errors "
        "correlate by -1.00";
    CHECK(difference(expected, found, 0, true) == Containing{words});
    CHECK(difference(encode(truth, Format::ppm), found, 0, true) == Containing{"off by +19.3 %"});
    CHECK(difference(found, encode(Image(40, 40), Format::pfm), 0, true) == Containing{"is off by -100.0 %"});
    CHECK(difference(encode(Image(40, 40), Format::pfm), found, 0, true) == "no light is reflected by objects");
    CHECK(difference(expected, encode(Image(40, 20), Format::pfm), 0, true) ==
          "reference: 40 x 40, floats, here: 40 x 20, floats");
    CHECK(difference(expected, table, 0, true) == "reference: 40 x 40, floats, here: no picture");
    CHECK(difference(table, "1", 0, true) == "reference: no picture, here: no picture");
}

TEST_CASE("tolerant, floats have a tolerance, and one pixel in a thousand may differ") {
    CHECK(difference(pfm({{2, 1, 1}}), pfm({{2, 1.0009, 1}}), 1e-3) == "");
    CHECK(difference(pfm({{2, 1, 1}}), pfm({{2, 1.0009, 1}}), 0) == Containing{"reference 1, here 1.0009"});
    CHECK(difference(pfm({{2, 1, 1}}), pfm({{2, NAN, 1}}), 1e-3) == Containing{"reference 1, here nan"});
    const std::string grey(3 * 1600, 'a');
    std::string spot = grey;
    spot[5] = 'b';
    CHECK(difference(ppm(grey), ppm(spot), 1e-3) == "");
    spot[6] = 'b';
    CHECK(difference(ppm(grey), ppm(spot), 0.1) == Containing{"pixel (x 1, y 0): reference 97, here 98; 2 of 1600"});
}

TEST_CASE("a picture of another kind or size, in text, or cut is told from one that is right") {
    CHECK(difference(ppm("abcdef"), "P3\n2 1\n255\n97 98 99\n100 101 102\n", 1e-3) == "");
    CHECK(difference(ppm("abcdef"), ppm("abc"), 0) ==
          "reference: 2 x 1, codes up to 255, here: 1 x 1, codes up to 255");
    CHECK(difference(ppm("abcdef"), pfm({{}, {}}), 0) == Containing{", here: 1 x 2, floats"});
    CHECK(difference(ppm("abcdef"), table, 0) == Containing{", here: no picture"});
    const std::string bmp = encode(Image(1, 1), Format::bmp), said = "here: neither a text nor a picture that can be ";
    CHECK(difference(ppm("abcdef"), bmp, 0) == Containing{said});
    CHECK(difference(table, std::string("\xFF\xFE#\0", 4), 0) == Containing{"here: a text in UTF-16"});
    for (const std::string& bytes :
         {ppm("abcdef") + "\r\n", ppm("abcdef").substr(0, 12), std::string("P6\n2 1\n255"),
          std::string("P3\n9999 9999\n255\n1"), std::string("PF\n6148914691236517206 1\n1\n"),
          std::string("P6\n2 0\n255\n"), std::string("P6\n2"), pfm({{}}).substr(0, 20)})
        CHECK(difference(ppm("abcdef"), bytes, 0) ==
              Containing{", which ends early or late (was it written in text mode?)"});
    CHECK_THROWS_AS(difference(ppm("abcdef").substr(0, 12), ppm("abcdef"), 0), std::runtime_error);
}
