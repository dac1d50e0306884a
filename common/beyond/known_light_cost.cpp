#include "beyond/known_light_cost.h"

#include "light/load_environment.h"
#include "numerics/progress.h"
#include "numerics/statistics.h"

namespace bmc::beyond {
static ComparedPicture picture_of_known(const EnvironmentLight& light, Method method, std::size_t pool,
                                        Placement placement) {
    ComparedPicture compared = compared_picture(light.environment, method, pool, placement, Known::cosine);
    compared.known = "light";
    compared.image = [&light](const RenderSettings& settings) { return picture(light, {settings, true}); };
    return compared;
}

// The cells "predicted" and "within" of a row.
static std::string prediction_cells(const ComparedPicture& compared, PictureSettings settings,
                                    const EnvironmentLight& light, const Image& truth) {
    const Scene scene = sphere_scene();
    RootMeanSquare predicted;
    Statistics covered;
    Progress progress(static_cast<double>(seeds_of(settings)));
    for (const std::uint64_t end = settings.seed + seeds_of(settings); settings.seed != end; ++settings.seed) {
        const Image image = compared.image(settings);
        const Image better = render(scene, light.environment, settings, better_shader(scene, light, settings));
        const Image errors = predicted_errors(image, better);
        predicted.add(root_mean_square(errors));
        covered.add(coverage(image, truth, errors));
        progress.done();
    }
    return formatted("  %10.5f %6.3f", predicted.value(), covered.mean);
}

static std::vector<std::string> all_prediction_cells(const std::vector<ComparedPicture>& compared,
                                                     const CostSettings& costs, const EnvironmentLight& light,
                                                     const Image& truth) {
    std::vector<std::string> cells;
    Progress progress(2 * static_cast<double>(compared.size()), table_parts);
    for (const ComparedPicture& each : compared)
        for (const std::size_t n : {10u, 40u}) {
            const bool light_known = each.known == std::string("light");
            cells.push_back(prediction_cells(each, {row_settings(costs, each.settings, n), light_known}, light, truth));
            progress.done();
        }
    return cells;
}

Image truth_with_sun(const EnvironmentMap& environment, RenderSettings settings, std::size_t samples) {
    settings.samples = samples;
    const Scene scene = sphere_scene();
    return render(scene, environment, settings, shader_with_sun(scene, environment, settings, samples));
}

double coverage(const Image& image, const Image& truth, const Image& predicted) {
    double within = 0, all = 0;
    for_each_hit(sphere_scene(), {image.width, image.height}, [&](int x, int y, const Hit&) {
        const Color error = image(x, y) - truth(x, y), most = 2 * predicted(x, y);
        within += (std::fabs(error.x) <= most.x) + (std::fabs(error.y) <= most.y) + (std::fabs(error.z) <= most.z);
        all += 3;
    });
    return within / all;
}

Options KnownLightReport::options() {
    Options all = cost_options(costs);
    all.insert(all.begin(), text_option("environment", "FILE",
                                        "one light, as for the renderer (default: each built-in light)", environment));
    return all;
}

std::string KnownLightReport::report() const {
    std::vector<std::string> names{environment};
    if (environment.empty()) names = {std::begin(built_in_lights), std::end(built_in_lights)};
    std::string text;
    Progress progress(static_cast<double>(names.size()) * (2 + 2 * table_parts));
    for (const std::string& name : names) {
        const EnvironmentMap map = load_environment(name);
        const RenderSettings settings = row_settings(costs, {}, 0);
        const EnvironmentLight light(map, true, settings.threads);
        progress.done();
        const Image truth = truth_with_sun(map, settings, 10000);
        progress.done();
        const std::vector<ComparedPicture> compared{
            compared_picture(map, Method::mc, 1, Placement::uniform),
            compared_picture(map, Method::pool, 20, Placement::uniform),
            compared_picture(map, Method::pool, 20, Placement::cosine_fibonacci, Known::cosine),
            picture_of_known(light, Method::mc, 1, Placement::uniform),
            picture_of_known(light, Method::pool, 20, Placement::uniform),
            picture_of_known(light, Method::mc, 1, Placement::cosine_fibonacci),
            picture_of_known(light, Method::pool, 20, Placement::cosine_fibonacci)};
        const std::vector<PictureCost> rows = picture_costs(compared, {10, 40}, costs, truth);
        progress.done(table_parts);
        const std::vector<std::string> cells = all_prediction_cells(compared, costs, light, truth);
        progress.done(table_parts);
        text += (text.empty() ? "" : "\n\n") + ("# The sphere scene under " + name) +
                ". Columns as of tradeoff; predicted: the rmse by a better picture; within: the fraction of\n"
                "# errors within two predicted ones.\n" +
                picture_table(rows, costs.timed, "   predicted within", cells);
    }
    return text;
}
}  // namespace bmc::beyond
