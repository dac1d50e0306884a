#include "experiments/reports.h"
#include "test.h"

// One direction w, seen by the process alone: Y = 1/2 there, and 0 is believed far from it. The mean is k Y / q with
// q = k(0) + noise^2, the deviation a sqrt(k(0) - k^2 / q) with the amplitude a = Y / sqrt(q).
TEST_CASE("the discs of belief show light, posterior mean, deviation and error") {
    const TemporaryFile light("#?RADIANCE\n\n-Y 1 +X 1\n\200\200\200\200");  // 0.5
    std::vector<std::string> words{"--environment", light.name, "--samples=1", "--placement=fibonacci", "--noise=0.5"};
    std::string picture;
    const std::string printed = stderr_of([&] { picture = output_of(belief_discs, words); }),
                      header = "P6\n800 200\n255\n";
    Random random(1, 0);
    const Vec3 w = sampler_of({PointSet::fibonacci}, 1)(random)[0];
    const double q = 8.0 / 3 + 0.25, z = Sobolev().z(w.y), amplitude = 0.5 / std::sqrt(q);
    const double error = amplitude * std::sqrt(Sobolev().zz() - z * z / q);
    CHECK(!contains(printed, "note:"));
    CHECK(printed == Containing{formatted(": estimate %.5g, error bar %.3g, truth ", 0.5 * z / q, error)});
    words.emplace_back("--known=cosine");  // the values stay 1/2: cos(theta) is divided out
    const std::string cosine = stderr_of([&] { output_of(belief_discs, words); });
    CHECK(cosine == Containing{formatted(": estimate %.5g, ", 0.5 * SobolevKnownCosine().z(w.y) / q)});

    REQUIRE(picture.size() == header.size() + 3 * 800 * 200);
    const auto byte = [&](int x, int y) {
        return static_cast<unsigned char>(picture[header.size() + 3 * static_cast<std::size_t>(800 * y + x)]);
    };
    const auto shows = [&](int x, int y, double linear) {  // within about a unit: a pixel is a mean of 9 places
        return std::fabs(srgb_to_linear(byte(x, y) / 255.0) - std::min(linear, 1.0)) < 0.01;
    };
    double sum = 0, cosine_sum = 0;  // over the first disc, in which areas are solid angles
    for (int x = 0; x < 200; ++x)
        for (int y = 0; y < 200; ++y) {
            const double up = 1 - std::pow((x + 0.5) / 100 - 1, 2) - std::pow((y + 0.5) / 100 - 1, 2);
            if (up > 0 && byte(x, y) > 0) sum += 2e-4 * 0.5, cosine_sum += 2e-4 * 0.5 * up;
        }
    for (const auto& [text, truth] : {std::pair(printed, sum), {cosine, cosine_sum}})
        CHECK(relative(std::stod(text.substr(text.find("truth ") + 6)), truth) < 0.01);
    int visible = 0;
    for (const auto& [x, y] : {std::pair(100, 100), {60, 90}, {150, 120}, {90, 30}, {100, 175}, {30, 140}}) {
        const double u = 2 * (x + 0.5) / 200 - 1, v = 2 * (y + 0.5) / 200 - 1, up = 1 - u * u - v * v;
        const Vec3 here{-std::sqrt(1 + up) * v, up, -std::sqrt(1 + up) * u};
        const double k = Sobolev().k(squared_distance(here, w)), mean = k * 0.5 / q, seen = byte(x, y) > 0 ? 0.5 : 0;
        CHECK(shows(x, y, seen));
        CHECK(shows(200 + x, y, mean));
        CHECK(shows(400 + x, y, 2.5 * amplitude * std::sqrt(8.0 / 3 - k * k / q)));
        CHECK(shows(600 + x, y, 2.5 * std::fabs(mean - seen)));
        visible += seen > 0;
    }
    CHECK(visible > 1);
    for (int disc = 0; disc < 4; ++disc) CHECK(byte(200 * disc + 1, 1) == 118);  // the grey 0.18 around them
    // The sample is a white dot with a black rim, a part of its pixel; the light around is 188.
    const double scale = std::sqrt(1 + w.y);
    const int x = static_cast<int>(100 * (1 - w.z / scale)), y = static_cast<int>(100 * (1 - w.x / scale));
    CHECK(byte(x, y) == 255);
    CHECK(std::min(byte(x + 2, y), byte(x + 3, y)) < 160);
}

// One column of 63 has 24 where all others have 1/2: a lamp, which the only sample misses. Interpolated between columns
// it leaves the mean square 1/4 + (23.5 + (2/3) 23.5^2) / 63, and 1/2 is 20 % of its root; the sphere hides little.
TEST_CASE("belief says that its samples have missed a lamp") {
    std::string texels;
    for (int x = 0; x < 64; ++x) texels += x == 4 ? "\300\300\300\205" : "\200\200\200\200";
    const TemporaryFile light("#?RADIANCE\n\n-Y 1 +X 64\n" + texels);
    const std::vector<std::string> words{"--environment", light.name, "--samples=1", "--placement=fibonacci"};
    CHECK(stderr_of([&] { output_of(belief_discs, words); }) == Containing{"note: the samples have seen 20 %"});
}
