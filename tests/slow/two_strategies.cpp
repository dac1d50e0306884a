// The course's table of directions that were drawn by two strategies, half of them uniformly, and half with density
// cos(theta) / pi ("cosine"), the same with both halves stratified ("strata"), or in proportion to the light ("light").
// Lines of: strategy, number, light, and RMSEs of pictures by multiple importance sampling with the balance heuristic
// (Veach & Guibas, "Optimally combining sampling techniques for Monte Carlo rendering", SIGGRAPH 1995), by BMC, by BMC
// with the cosine known, and by BMC of the visibility alone, where the light is known as well. With two arguments, a
// strategy and a number, only lines of these.
#include "experiments/reports.h"
#include "light/texels_on_sphere.h"

#include <cstdio>

using namespace bmc;

// A direction in the world, and the part of all light for which it stands.
struct LitDirection {
    Vec3 direction;
    Colour light;
};

// Such directions for n equal parts of the light, row after row of the map, each at a random place of its texel.
static std::vector<LitDirection> lit_directions(const EnvironmentMap& map, double n) {
    const double pi = portable::pi, columns = map.width - 1, rows = map.height - 1;
    const double part = 4 * pi * mean_over_directions(map, brightness) / n;
    std::vector<LitDirection> lit;
    Random random(1, 0);
    double parts = 0;
    for (int y = 0; y < map.height - 1; ++y)
        for (int x = 0; x < map.width - 1; ++x) {
            const Colour colour = map.colour(map.index(x, y));
            const double top = std::cos(pi * y / rows), height = top - std::cos(pi * (y + 1) / rows);
            parts += 2 * pi / columns * height * brightness(colour) / part;
            while (double(lit.size()) + 0.5 < parts) {
                const double cosine = top - height * random.uniform(), sine = std::sqrt(1 - cosine * cosine);
                const double azimuth = 2 * pi * ((x + random.uniform()) / columns - 0.5);  // from -z towards x
                lit.push_back({{sine * std::sin(azimuth), cosine, -sine * std::cos(azimuth)},
                               part / brightness(colour) * colour});
            }
        }
    return lit;
}

// The four estimates of the light that arrives at a hit.
static std::vector<Colour> estimates(const EnvironmentMap& map, const std::vector<LitDirection>& lit,
                                     const std::string& strategy, std::size_t n, const Hit& hit, Random random) {
    const Frame frame(hit.normal);
    std::vector<LitDirection> above;  // in the frame's hemisphere, and what arrives from there if nothing is in the way
    Colour all;
    for (const auto& [w, light] : lit)
        if (const double cosine = dot(w, hit.normal); cosine > 0) {
            above.push_back({{dot(w, frame.tangent), cosine, dot(w, frame.bitangent)}, cosine * light});
            all += above.back().light;
        }
    const double hemisphere = brightness(lit[0].light) * double(above.size());  // the integral of L

    const auto draw = strategy == "strata" ? stratified_directions : random_directions;
    std::vector<Vec3> set = draw(n / 2, random, KnownPart::nothing), others = draw(n / 2, random, KnownPart::cosine);
    if (strategy == "light")
        for (Vec3& w : others) w = above[static_cast<std::size_t>(random.uniform() * double(above.size()))].direction;
    set.insert(set.end(), others.begin(), others.end());

    std::vector<double> visible, balance;
    std::vector<Colour> radiance;
    for (const Vec3& w : set) {
        visible.push_back(!is_shadowed(sphere_scene, hit, frame.to_world(w)));
        radiance.push_back(map.radiance(frame.to_world(w)));
        const double density = strategy == "light" ? brightness(radiance.back()) / hemisphere : w.y / portable::pi;
        balance.push_back(2 * w.y / (double(n) * (0.5 / portable::pi + density)));
    }
    std::vector<Colour> results;
    for (const std::vector<double>& weights : {balance, cosine_rule(bayesian_rule(Sobolev(), 0.01, set)).weights,
                                               bayesian_rule(SobolevKnownCosine(), 0.01, set).weights}) {
        results.push_back({});
        for (std::size_t j = 0; j < n; ++j) results.back() += weights[j] * visible[j] * radiance[j];
    }

    // The visibility, with p = L cos(theta): z is a sum over a tenth of the lit directions.
    const Cholesky q(covariance_matrix(Sobolev(), 0.01, set));
    results.push_back({});
    for (double Colour::*channel : {&Colour::x, &Colour::y, &Colour::z}) {
        std::vector<double> z(n);
        for (std::size_t i = random.bits() % 10; i < above.size(); i += 10)
            for (std::size_t j = 0; j < n; ++j)
                z[j] += above[i].light.*channel * Sobolev().k(squared_distance(set[j], above[i].direction));
        const std::vector<double> weights = bayesian_weights(q, z);
        double part = 0, sum = 0;
        for (std::size_t j = 0; j < n; ++j) part += weights[j] * visible[j], sum += weights[j];
        results.back().*channel = part / sum * all.*channel;
    }
    return results;
}

int main(int argc, char** argv) {
    CostSettings costs;
    costs.size = 40;
    for (const std::string& name : light_names()) {
        const EnvironmentMap light = load_environment(name);
        const std::vector<LitDirection> lit = lit_directions(light, 10000);
        const PictureCost dense = compared_picture(light, Method::mc, 1, {PointSet::fibonacci, KnownPart::cosine});
        const Image truth = dense.image(row_settings(costs, dense.settings, 10000));
        for (const char* strategy : {"cosine", "strata", "light"})
            for (const std::size_t n : {10, 40, 160}) {
                if (argc == 3 && (argv[1] != std::string(strategy) || argv[2] != std::to_string(n))) continue;
                RootMeanSquare rmse[4];
                RenderSettings settings = row_settings(costs, {}, n);
                for (settings.seed = 1; settings.seed <= 160 / n; ++settings.seed) {
                    std::vector<Image> images(4, truth);
                    render(light, settings, [&](const Hit& hit, int x, int y) {
                        const auto all = estimates(light, lit, strategy, n, hit, pixel_stream(settings, x, y));
                        for (std::size_t i = 0; i < 4; ++i) images[i](x, y) = 1 / portable::pi * (hit.albedo * all[i]);
                        return Colour();
                    });
                    for (std::size_t i = 0; i < 4; ++i) rmse[i].add(image_error(images[i], truth).rmse);
                }
                std::printf("%s %zu %s", strategy, n, name.c_str());
                for (const RootMeanSquare& each : rmse) std::printf(" %.4g", each.value());
                std::printf("\n");
            }
    }
}
