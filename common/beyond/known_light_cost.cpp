#include "beyond/known_light_cost.h"

namespace bmc::beyond {
static PictureCost picture_of_known(const EnvironmentLight& light, Method method, std::size_t pool,
                                    Placement placement) {
    PictureCost compared = compared_picture(light.environment, method, pool, placement);
    compared.settings.known_part = KnownPart::cosine;
    compared.known_column = "light";
    compared.image = [&light](const RenderSettings& settings) {
        return render(light.environment, settings, shader_of(light, settings));
    };
    return compared;
}

double coverage(const Image& image, const Image& truth, const Image& predicted) {
    double within = 0, all = 0;
    for_each_hit(sphere_scene, {image.width, image.height}, [&](int x, int y, const Hit&) {
        const Colour error = image(x, y) - truth(x, y), most = 2 * predicted(x, y);
        within += (std::fabs(error.x) <= most.x) + (std::fabs(error.y) <= most.y) + (std::fabs(error.z) <= most.z);
        all += 3;
    });
    return within / all;
}

std::string KnownLightReport::table(const std::string& name, const EnvironmentMap& map) const {
    const RenderSettings dense = row_settings(costs, {}, 10000);
    const EnvironmentLight light(map, true, dense.threads), unknown(map, false, dense.threads);
    std::vector<PictureCost> compared{compared_picture(map, Method::mc, 1, {}),
                                      compared_picture(map, Method::pool, 20, {}),
                                      compared_picture(map, Method::mc, 1, {PointSet::optimised, KnownPart::cosine})};
    for (const Placement placement : {Placement{}, Placement{PointSet::fibonacci, KnownPart::cosine},
                                      Placement{PointSet::optimised, KnownPart::cosine}}) {
        compared.push_back(picture_of_known(light, Method::mc, 1, placement));
        compared.push_back(picture_of_known(light, Method::pool, placement.is_fixed() ? 1 : 20, placement));
    }
    const Image truth = render(map, dense, shader_with_sun(map, dense, dense.samples));
    Progress progress("rows", compared.size() * samples.size());
    std::vector<PictureCost> rows;
    for (const PictureCost& picture : compared)
        for (const std::size_t n : samples) {
            const EnvironmentLight& light_of_picture = picture.known_column == std::string("light") ? light : unknown;
            RootMeanSquare predicted;
            Statistics covered;
            rows.push_back(measured_picture(picture, n, costs, truth, [&](const Image& image, const RenderSettings& s) {
                const Image errors = predicted_errors(image, render(map, s, better_shader(light_of_picture, s)));
                predicted.add(root_mean_square(errors));
                covered.add(coverage(image, truth, errors));
            }));
            rows.back().more = formatted("  %10.5f %6.3f", predicted.value(), covered.mean);
            progress.done();
        }
    return "# The sphere scene under " + name +
           ". Columns as of tradeoff; predicted: the rmse by a better picture; within: the fraction of\n"
           "# errors within two predicted ones.\n" +
           picture_table(rows, !costs.untimed, "   predicted within");
}
}  // namespace bmc::beyond
