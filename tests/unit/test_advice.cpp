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
    const double n =
        pixels_of_objects({200, 200});  // the rank of a pixel from the darkest, 1 to n, is n times its place
    const double tenth = std::floor(n / 10), hundredth = std::floor(n / 100);
    CHECK(warning(200, 0, [=](double place) { return place * n > n - tenth + 0.5 ? 8 : 0; }) == "");
    CHECK(warning(200, 0, [=](double place) { return place * n > n - tenth - 0.5 ? 8 : 0; }) ==
          Containing{"brighter than white; --exposure -3.0 makes the brightest hundredth white"});
    CHECK(warning(50, -0.5, [](double) { return 4; }) == Containing{"--exposure -2.5 "});
    CHECK(warning(200, 0, [=](double place) { return std::exp2((place * n - n) / 10 + 300); }) ==
          Containing{formatted("--exposure %.1f ", hundredth / 10 - 300)});
    CHECK(warning(8, 0, [](double place) { return std::exp2(10 * place); }) == Containing{"--exposure -10.0 "});
}

// The noise passes both thresholds in small steps: weights cancel where it is small, and vanish where it is large.
TEST_CASE("weights that cancel, or that make a white world dark, give a warning") {
    RenderSettings settings = small_picture(Method::single, 85);
    settings.covariance = CovarianceFamily::squared_exponential;
    int close_to_gain = 0, close_to_dark = 0;
    for (settings.noise = 30; settings.noise > 1e-5; settings.noise *= 0.85) {
        const PixelRules rules(settings);
        const QuadratureRule& rule = *rules.shared[0];
        const double gain = noise_gain(rule), dark = 1 - white_brightness(rule), most = 2 / std::sqrt(3 * 85.0);
        const std::string warning = stderr_of([&] { warn_of_weights(rules); });
        CAPTURE(settings.noise);
        CHECK(contains(warning, "errors of samples " + two_digits(gain) + " times") == (gain > 2));
        CHECK(contains(warning, formatted("%.0f %% too dark", 100 * dark)) == (gain <= 2 && dark > most));
        CHECK(warning.empty() == (gain <= 2 && dark <= most));
        close_to_gain += std::fabs(gain - 2) < 0.3;
        close_to_dark += std::fabs(dark - most) < 0.05;
    }
    CHECK(close_to_gain >= 2);
    CHECK(close_to_dark >= 2);
}

TEST_CASE("numbers for people have two digits, and an exponent only if they are long") {
    for (const auto& [number, text] : {std::pair(1.0, "1"),
                                       {2.6, "3"},
                                       {99.6, "100"},
                                       {145, "140"},
                                       {155, "160"},
                                       {1.26e5, "130000"},
                                       {2.04e79, "2e+79"}})
        CHECK(two_digits(number) == text);
}
