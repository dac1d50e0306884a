// two_strategies STRATEGY N LIGHT : RMSEs of pictures from N directions in each pixel, half of them uniform, and half
// with density cos(theta) / pi ("cosine") or in proportion to the light ("light"): by multiple importance sampling with
// the balance heuristic (Veach & Guibas, "Optimally combining sampling techniques for Monte Carlo rendering", SIGGRAPH
// 1995), and by BMC. The course's page says what follows.
#include "beyond/sun.h"
#include "experiments/reports.h"

#include <array>
#include <cstdio>

using namespace bmc;

// Directions in the world, each of which stands for an equal part of the light.
struct LitDirections {
    std::vector<Vec3> all;
    double part;
};

// Both estimates of the light that arrives at a hit.
static std::array<Colour, 2> estimates(const EnvironmentMap& map, const LitDirections& lit, const std::string& strategy,
                                       std::size_t n, const Hit& hit, Random random) {
    const Frame frame(hit.normal);
    std::vector<Vec3> above;  // in the frame's hemisphere
    for (const Vec3& w : lit.all)
        if (const double cosine = dot(w, hit.normal); cosine > 0)
            above.push_back({dot(w, frame.tangent), cosine, dot(w, frame.bitangent)});
    const double hemisphere = lit.part * double(above.size());  // the integral of L

    std::vector<Vec3> set = random_directions(n / 2, random, KnownPart::nothing);
    std::vector<Vec3> others = random_directions(n / 2, random, KnownPart::cosine);
    if (strategy == "light")
        for (Vec3& w : others) w = above[static_cast<std::size_t>(random.uniform() * double(above.size()))];
    set.insert(set.end(), others.begin(), others.end());

    std::array<Colour, 2> results;
    const std::vector<double> weights = cosine_rule(bayesian_rule(Sobolev(), 0.01, set)).weights;
    for (std::size_t j = 0; j < n; ++j) {
        const Vec3 direction = frame.to_world(set[j]);
        if (is_shadowed(sphere_scene, hit, direction)) continue;
        const Colour radiance = map.radiance(direction);
        const double density = strategy == "light" ? brightness(radiance) / hemisphere : set[j].y / portable::pi;
        results[0] += 2 * set[j].y / (double(n) * (0.5 / portable::pi + density)) * radiance;
        results[1] += weights[j] * radiance;
    }
    return results;
}

int main(int, char** argv) {
    const std::string strategy = argv[1];
    const std::size_t n = std::stoul(argv[2]);
    const EnvironmentMap light = load_environment(argv[3]);
    const beyond::Sun sun(light, 0);  // all of the light
    LitDirections lit{{}, sun.light() / 10000};
    Random random(1, 0);
    for (int i = 0; i < 10000; ++i) {
        const double across = (i + random.uniform()) / 10000;
        lit.all.push_back(sun.ray(across, random.uniform()).direction);
    }
    CostSettings costs;
    costs.size = 40;
    const PictureCost dense = compared_picture(light, Method::mc, 1, {PointSet::fibonacci, KnownPart::cosine});
    const Image truth = dense.image(row_settings(costs, dense.settings, 10000));
    RenderSettings settings = row_settings(costs, {}, n);
    RootMeanSquare rmse[2];
    for (settings.seed = 1; settings.seed <= 160 / n; ++settings.seed) {
        Image images[] = {truth, truth};
        render(light, settings, [&](const Hit& hit, int x, int y) {
            const auto both = estimates(light, lit, strategy, n, hit, pixel_stream(settings, x, y));
            for (std::size_t i = 0; i < 2; ++i) images[i](x, y) = 1 / portable::pi * (hit.albedo * both[i]);
            return Colour();
        });
        for (std::size_t i = 0; i < 2; ++i) rmse[i].add(image_error(images[i], truth).rmse);
    }
    std::printf("%.4g %.4g\n", rmse[0].value(), rmse[1].value());
}
