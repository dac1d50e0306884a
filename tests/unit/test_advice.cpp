#include "scene/advice.h"

#include "test.h"

TEST_CASE("more than a tenth of the objects' pixels above white gives a warning, of the brightest hundredth or pixel") {
    const auto warning = [](int size, double exposure, const std::function<double(double)>& light) {
        Image image(size, size);  // place: from 0 to 1 among the pixels of objects
        const double objects = pixels_of_objects({size, size});
        double seen = 0;
        for_each_hit({size, size}, [&](int x, int y, const Hit&) { image(x, y) = {0, light(++seen / objects), 0}; });
        return stderr_of([&] { warn_of_exposure(image, exposure); });
    };
    CHECK(warning(50, 0, [](double) { return 1; }) == "");
    const double n = pixels_of_objects({200, 200});  // n times its place is a pixel's rank from the darkest, 1 to n
    const double tenth = std::floor(n / 10), hundredth = std::floor(n / 100);
    CHECK(warning(200, 0, [=](double place) { return place * n > n - tenth + 0.5 ? 8 : 0; }) == "");
    CHECK(warning(200, 0, [=](double place) { return place * n > n - tenth - 0.5 ? 8 : 0; }) ==
          Containing{"brighter than white; --exposure -3.0 makes the brightest hundredth white"});
    CHECK(warning(50, -0.5, [](double) { return 4; }) == Containing{"--exposure -2.5 "});
    CHECK(warning(200, 0, [=](double place) { return std::exp2((place * n - n) / 10 + 300); }) ==
          Containing{formatted("--exposure %.1f ", hundredth / 10 - 300)});
    CHECK(warning(8, 0, [](double place) { return std::exp2(10 * place); }) == Containing{"--exposure -10.0 "});
}

TEST_CASE("numbers for people have two digits, and an exponent only if they are long") {
    std::string text;
    for (const double number : {1.0, 2.6, 99.6, 145.0, 155.0, 1.26e5, 2.04e79}) text += two_digits(number) + ' ';
    CHECK(text == "1 3 100 140 160 130000 2e+79 ");
}
