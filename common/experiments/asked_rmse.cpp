#include "experiments/asked_rmse.h"

#include "experiments/picture_error.h"
#include "experiments/root_mean_square.h"
#include "scene/pilot.h"

#include <stdexcept>

std::string asked_table(const EnvironmentMap& environment, const CostSettings& costs) {
    constexpr std::size_t most = 512;
    constexpr int seeds = 4;
    const Scene scene = sphere_scene();
    const Light light(environment);
    const Image truth = dense_picture(scene, light, costs);
    const std::vector<bool> mask = object_mask(scene, costs.size, costs.size);
    std::string text = "# method  pool placement        known   mean        asked samples rmse/asked\n";
    for (const RenderSettings& asked :
         {settings_of(Method::pool, 20, Placement::uniform),
          settings_of(Method::pool, 20, Placement::cosine_fibonacci, {KnownPart::cosine, PriorMean::zero}),
          settings_of(Method::pool, 20, Placement::cosine_fibonacci, {KnownPart::light, PriorMean::zero})})
        for (const double target : {0.02, 0.01, 0.005, 0.0025}) {
            RenderSettings settings = sized_as(costs, asked, most);
            text += name_columns(settings) + line(" %10g", target);
            try {
                settings.samples = samples_for(target, most, scene, light, settings).samples;
            } catch (const std::runtime_error&) {
                text += "       -          -\n";
                break;
            }
            RootMeanSquare rmse;
            for (int i = 0; i < seeds; ++i, ++settings.seed)
                rmse.add(image_error(mask, render(scene, light, settings), truth).rmse);
            text += line(" %7zu %10.2f\n", settings.samples, rmse.value() / target);
        }
    return text;
}
