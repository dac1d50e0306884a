#include "judge/correct_pictures.h"

#include <algorithm>

#include "experiments/command.h"
#include "judge/picture_file.h"

namespace {

// Leaves an RMSE of 0.0003, where 40 samples of the best method leave 0.005; of 0.02 under the sun of bright-desert,
// where they leave 0.17.
constexpr std::size_t dense_samples = 2000;

// Away from the seeds that pictures to be judged are made with.
constexpr std::uint64_t first_seed = 1000000;

}  // namespace

std::string options_of(const RenderSettings& settings) {
    return line("--method %s --samples %zu", name_of(settings.method, method_names), settings.samples) +
           (settings.method == Method::pool ? line(" --pool %zu", settings.pool) : "");
}

bool shares_one_rule(const RenderSettings& settings) {
    return settings.method == Method::single || settings.method == Method::rotated ||
           (settings.method == Method::mc && is_lattice(settings.placement));
}

Image Studio::dense(RenderSettings settings) const {
    settings.method = Method::mc;
    settings.placement = Placement::cosine_fibonacci;
    settings.samples = dense_samples;
    settings.prior.known = KnownPart::light;
    return render(scene_, light_, settings);
}

std::vector<Numbers> Studio::numbers(RenderSettings settings, const Truth& truth, std::size_t count,
                                     const Progress& progress) const {
    if (settings.method == Method::direct) {  // a large pool has the same numbers, and is cheaper
        const double n = static_cast<double>(settings.samples);
        settings.method = Method::pool;
        settings.pool = static_cast<std::size_t>(std::clamp(1e8 / (n * n * n), 50.0, 500.0));
    }
    settings.width = truth.image.width();
    settings.height = truth.image.height();
    std::vector<Numbers> numbers;
    for (settings.seed = first_seed; numbers.size() < count; ++settings.seed) {
        numbers.push_back(numbers_of(stored(render(scene_, light_, settings), maxval_), truth));
        if (progress) progress(static_cast<double>(numbers.size()) / static_cast<double>(count));
    }
    return numbers;
}
