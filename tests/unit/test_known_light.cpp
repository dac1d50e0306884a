#include "known_light/known_light.h"

#include "experiments/picture_cost.h"
#include "experiments/reports.h"
#include "test.h"

#include <map>

// The light 1 + w.slope, and beside it the light 1.
static const Vec3 slope{0.48, -0.64, 0.6};
static EnvironmentMap linear_map(int columns, int rows) {
    return map_of(columns + 1, rows + 1, [=](int x, int y) {
        return Colour{1 + dot(towards((x + 0.5) / columns, (y + 0.5) / rows), slope), 1, 0};
    });
}

// The integral of (1 + w.slope) cos(theta) is pi + (2 pi / 3) n.slope.
TEST_CASE("the irradiance is the integral of L cos(theta) within 1e-3, for any size of map") {
    const std::vector<Vec3> normals = all_around(100);
    const auto irradiance_of = [](const EnvironmentMap& map) {
        return light_around(cells_of_light(map, infinity, 48), 0, 48, 0, 2);
    };
    const EnvironmentMap linear = irradiance_of(linear_map(300, 150)), texel = irradiance_of(even_map(1, 1, 1));
    for (const Vec3& n : normals) {
        CAPTURE(n);
        CHECK(std::fabs(linear.interpolated(n).x - (pi + 2 * pi / 3 * dot(n, slope))) < 1e-3 * 5 * pi / 3);
        CHECK(relative(linear.interpolated(n).y, pi) < 2e-3);
        CHECK(relative(texel.interpolated(n).z, pi) < 2e-3);
    }
}

// The integral of max(w.n - h, 0) is pi (1 - h)^2, and that of w.n times it pi (1 - h)^2 (2 + h) / 3.
TEST_CASE("a cone has the light around its direction, weighted by a tent, within 2 % of the largest light") {
    const double h = 1 - 2.0 / 40;
    const EnvironmentMap around = light_around(cells_of_light(linear_map(512, 256), infinity, 48), h, 48, 0.5, 2);
    for (int i = 0; i < 96 * 48; ++i) {
        const Vec3 n = towards((i % 96 + 0.5) / 96, (i / 96 + 0.5) / 48);
        CAPTURE(n);
        const double mean = 1 + (2 + h) / 3 * dot(n, slope);
        CHECK(std::fabs(around.radiance(n).x / (pi * (1 - h) * (1 - h)) - mean) < 0.04);
    }
}

TEST_CASE("cells and points part the light of the map, without loss") {
    const EnvironmentMap map = sunny_map();
    const double limit = 10 * mean_over_directions(map, channel_sum);
    Colour sum;
    for (const Lamp& cell : cells_of_light(map, limit, 5)) sum += cell.light;
    const std::vector<Lamp> points = points_of_light(map, limit, 77);
    CHECK(points.size() == 77);
    for (const Lamp& point : points) {
        sum += point.light;
        CHECK(relative(channel_sum(point.light), channel_sum(points[0].light)) < 1e-12);
        CHECK(channel_sum(map.radiance(point.direction)) > limit);
    }
    CHECK(relative(channel_sum(sum), 4 * pi * mean_over_directions(map, channel_sum)) < 1e-12);
    const auto [lowest, highest] = std::minmax_element(
        points.begin(), points.end(), [](const Lamp& a, const Lamp& b) { return a.direction.y < b.direction.y; });
    CHECK(highest->direction.y - lowest->direction.y > 0.9 * (std::cos(pi * 10 / 31) - std::cos(pi * 11 / 31)));
    CHECK(points_of_light(even_map(4, 4, 1), 31, 77).empty());
}

// Of two pieces of a map the second one is passed after the first, however wide the map is.
TEST_CASE("the points pass the texels in Morton's order, each evenly") {
    const EnvironmentMap map = map_of(8193, 513, [](int x, int y) {
        return (x % 4096 < 4 && x < 8192 && y / 2 == 127) * Colour{1, 1, 1};
    });
    std::vector<int> passed;  // 100 piece + 10 row + column
    for (const Lamp& point : points_of_light(map, 0, 3200)) {
        const int i = map.index(point.direction) - 1, x = i % 8193;
        const int place = x / 4096 * 100 + (i / 8193 - 252) * 10 + x % 4096;
        if (passed.empty() || passed.back() != place) passed.push_back(place);
    }
    CHECK(passed == std::vector<int>{20, 21, 30, 31, 22, 23, 32, 33, 120, 121, 130, 131, 122, 123, 132, 133});
}

TEST_CASE("a fraction is visible over all light, from 0 to 1, and 1 where there is no light") {
    CHECK(fraction({1, -2, 16}, {2, -1, 8}) == Vec3{0.5, 1, 1});
    CHECK(fraction({0, -1, 0}, {0, 1, 1}) == Vec3{1, 0, 0});
}

static Image picture_of(const EnvironmentMap& map, const RenderSettings& settings) {
    const KnownLight light = known_light(map, settings.samples, 2);
    return render(map, settings, known_light_shader(light, settings));
}

// Of three rays the sphere often stops all: under an even light in 2 % of the pixels.
TEST_CASE("no point is black under a light that comes from everywhere") {
    const RenderSettings settings = small_picture(Method::mc, 3, 100, {PointSet::optimised, Density::cosine});
    const Image image = picture_of(even_map(2, 2, 1), settings);
    double least = infinity;
    for_each_hit({100, 100}, [&](int x, int y, const Hit&) { least = std::min(least, image(x, y).y); });
    CHECK(least > 0.01);
}

TEST_CASE(
    "a known light has six tenths of the error of an unknown one, with any number of samples, and less with a sun") {
    for (const std::size_t samples : {1u, 2u, 5u, 40u}) {
        CAPTURE(samples);
        const RenderSettings settings = small_picture(Method::mc, samples, 24, {PointSet::optimised, Density::cosine});
        for (const EnvironmentMap& map : {coloured_map(16, 9), sunny_map()}) {
            const std::vector<Lamp> lamps = points_of_light(map, 0, 1 << 15);
            const Image truth = render(map, settings, [&](const Hit& hit, int, int) {
                Arriving sum;
                for (const Lamp& lamp : lamps) sum.add(hit, lamp);
                return 1 / pi * (hit.albedo * sum.visible);
            });
            const double known = image_error(picture_of(map, settings), truth).rmse;
            const double unknown =
                image_error(render(map, settings, environment_shader(map, PixelRules(settings))), truth).rmse;
            CHECK(known < (map.width == 16 ? 0.6 : 0.15) * unknown);
        }
    }
}

TEST_CASE("of two known parts the last one counts") {
    ModelSettings settings;
    Arguments arguments;
    add_model_options(arguments, settings, {"nothing", "cosine", "light"});
    parse({"--known=nothing", "--known=light"}, arguments);
    CHECK(arguments.given["known"] == "light");
    CHECK(*settings.known == Known::cosine);
    CHECK_THROWS_AS(parse({"--known=dark"}, arguments), std::invalid_argument);
}

// Under a sun and a sky, of which about half of the samples see one each.
TEST_CASE("tradeoff: the quotient of mis has at most half of its error, and the known light still less") {
    std::map<std::string, double> error;  // of each method, the last row of it
    for (const std::vector<std::string>& row :
         rows_of(output_of(tradeoff_report, {"--size=8", "--no-times", "--samples=10", "--environment=bright-desert"})))
        error[row[0]] = std::stod(row[5]);
    CHECK(error["mis-ratio"] < 0.5 * error["mis"]);
    CHECK(error["pool"] < error["mis-ratio"]);
    CHECK(error["mis"] < 0.1 * error["mc"]);
}
