// The course's table of directions that were drawn by two strategies, half of them uniformly and half with density
// cos(theta) / pi: RMSEs of pictures by the balance heuristic, by BMC, and by BMC with the cosine known. Twenty seeds
// have pools of twenty rules each.
#include "experiments/picture_cost.h"

#include <cstdio>

using namespace bmc;

static std::vector<QuadratureRule> rules_of_set(std::size_t n, Random random) {
    std::vector<Vec3> set = random_directions(n / 2, random);
    const std::vector<Vec3> others = random_directions(n / 2, random, KnownPart::cosine);
    set.insert(set.end(), others.begin(), others.end());
    QuadratureRule balance{set, {}, KnownPart::cosine};  // cos(theta) over n times the mean of both densities
    for (const Vec3& w : set) balance.weights.push_back(4 * portable::pi * w.y / (double(n) * (1 + 2 * w.y)));
    return {balance, cosine_rule(bayesian_rule(Sobolev(), 0.01, set)), bayesian_rule(SobolevKnownCosine(), 0.01, set)};
}

int main() {
    CostSettings costs;
    costs.size = 40;
    for (const std::string& name : light_names()) {
        const EnvironmentMap light = load_environment(name);
        const PictureCost dense = compared_picture(light, Method::mc, 1, Placement::cosine_fibonacci);
        const Image truth = dense.image(row_settings(costs, dense.settings, 10000));
        for (const std::size_t n : {10, 40, 160}) {
            RootMeanSquare rmse[3];
            RenderSettings settings = row_settings(costs, {}, n);
            for (; settings.seed <= 20; ++settings.seed) {
                std::vector<std::vector<QuadratureRule>> pool(20);
                for (std::size_t i = 0; i < pool.size(); ++i) pool[i] = rules_of_set(n, {settings.seed, i});
                for (std::size_t method = 0; method < 3; ++method) {
                    const Image image = render(light, settings, [&](const Hit& hit, int x, int y) {
                        Random random = pixel_stream(settings, x, y);
                        const QuadratureRule& rule = pool[static_cast<std::size_t>(20 * random.uniform())][method];
                        const Frame frame = Frame(hit.normal).rotated(random.uniform());
                        return reflected_radiance(sphere_scene, light, hit, rule, frame);
                    });
                    rmse[method].add(image_error(image, truth).rmse);
                }
            }
            std::printf("%zu %s %.4g %.4g %.4g\n", n, name.c_str(), rmse[0].value(), rmse[1].value(), rmse[2].value());
        }
    }
}
