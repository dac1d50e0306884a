#include "judge/correct_pictures.h"

#include <algorithm>
#include <cmath>

#include "experiments/command.h"
#include "experiments/picture_error.h"

namespace {

double itself(double x) { return x; }
double log_of_positive(double x) { return portable::log(std::max(x, 1e-12)); }

// In a small picture no neighbours may be alike; hence the 0.003.
double log_of_fraction(double x) { return portable::log(0.003 + x); }
double from_log_of_fraction(double t) { return std::clamp(portable::exp(t) - 0.003, 0.0, 1.0); }

// Independent pixels have correlations of about 0, of either sign; hence the 0.1.
double log_odds(double correlation) {
    return portable::log((0.1 + std::max(correlation, -0.09)) / (1.01 - correlation));
}
double from_log_odds(double t) {
    const double odds = portable::exp(t);
    return std::min(1.0, (1.01 * odds - 0.1) / (1 + odds));
}

// Away from the seeds that pictures to be judged are made with.
constexpr std::uint64_t first_seed = 1000000;

// A large pool in place of a process for each pixel: its pictures have the same numbers.
RenderSettings cheaper(RenderSettings settings) {
    if (settings.method != Method::direct) return settings;
    const double n = static_cast<double>(settings.samples);
    settings.method = Method::pool;
    settings.pool = static_cast<std::size_t>(std::clamp(1e8 / (n * n * n), 50.0, 500.0));
    return settings;
}

Image clamped(Image image) {
    const auto at_most_1 = [](Color c) { return Color{std::min(c.x, 1.0), std::min(c.y, 1.0), std::min(c.z, 1.0)}; };
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) image.set(x, y, at_most_1(image(x, y)));
    return image;
}

}  // namespace

const Scale scales[quantity_count] = {{"rmse", log_of_positive, portable::exp, 0.01},
                                      {"brightness", itself, itself, 0.001},
                                      {"correlation", log_odds, from_log_odds, 0.1},
                                      {"alike", log_of_fraction, from_log_of_fraction, 0.05},
                                      {"block", log_of_positive, portable::exp, 0.2}};

Spread::Spread(const std::vector<Numbers>& all, std::size_t which) {
    const Scale& scale = scales[which];
    const double n = static_cast<double>(all.size());
    double variance = 0;
    for (const Numbers& numbers : all) mean += scale.to(numbers[which]) / n;
    for (const Numbers& numbers : all) {
        const double difference = scale.to(numbers[which]) - mean;
        variance += difference * difference / (n - 1);
    }
    deviation = std::max(scale.floor, std::sqrt(variance * (1 + 1 / n)));
}

Numbers Truth::numbers(const Image& picture) const {
    const ImageError error = image_error(mask, picture, image);
    return {error.rmse, error.brightness, error.correlation, alike_neighbours(mask, picture, image, error.rmse),
            largest_block_error(mask, picture, image, block_side()).error};
}

int Truth::block_side() const { return std::max(4, std::min(image.width(), image.height()) / 25); }

bool shares_one_rule(const RenderSettings& settings) {
    return settings.method == Method::single || settings.method == Method::rotated ||
           (settings.method == Method::mc && is_lattice(settings.placement));
}

std::string options_of(const RenderSettings& settings) {
    return line("--method %s --samples %zu", name_of(settings.method, method_names), settings.samples) +
           (settings.method == Method::pool ? line(" --pool %zu", settings.pool) : "");
}

std::vector<Candidate> candidates_for(const RenderSettings& settings) {
    std::vector<Candidate> candidates = {{options_of(settings), settings}};
    std::vector<std::size_t> counts{10, 20, 40, 80, 160, settings.samples};
    std::sort(counts.begin(), counts.end());
    counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    for (const auto& [name, method] : method_names)
        for (const std::size_t samples : counts) {
            RenderSettings chosen = settings;
            chosen.method = method;
            chosen.samples = samples;
            if (method != settings.method || samples != settings.samples)
                candidates.push_back({options_of(chosen), chosen});
        }
    RenderSettings unturned = settings;
    unturned.pool = std::min<std::size_t>(settings.pool, 50);  // for each of its pictures so many are rendered
    candidates.push_back({options_of(settings) + ", the pool not turned", unturned, false});
    return candidates;
}

Image Studio::dense(RenderSettings settings) {
    settings.method = Method::mc;
    settings.placement = Placement::cosine_fibonacci;
    settings.samples = dense_samples;
    settings.prior.known = KnownPart::light;
    Image image = render(scene_, light_, settings);
    count(static_cast<double>(dense_samples) * settings.width * settings.height);
    return image;
}

Truth Studio::truth(const Image& dense) const {
    return {maxval_ > 0 ? clamped(dense) : dense, object_mask(scene_, dense.width(), dense.height())};
}

std::vector<Numbers> Studio::numbers(const Candidate& candidate, const Truth& truth, std::size_t seeds) {
    RenderSettings settings = candidate.turns ? cheaper(candidate.settings) : candidate.settings;
    settings.width = truth.image.width();
    settings.height = truth.image.height();
    std::vector<Numbers> all;
    for (settings.seed = first_seed; settings.seed < first_seed + seeds; ++settings.seed) {
        all.push_back(truth.numbers(candidate.turns ? picture(settings) : unturned_pool(settings)));
        count(rays(candidate, settings.width, settings.height));
    }
    return all;
}

double Studio::rays(const Candidate& candidate, int width, int height) {
    const RenderSettings& settings = candidate.settings;
    const double n = static_cast<double>(settings.samples) * (settings.method == Method::mc ? 4 : 1);
    return (n + 30) * width * height * (candidate.turns ? 1 : static_cast<double>(settings.pool));
}

Image Studio::picture(const RenderSettings& settings) const {
    return stored(render(scene_, light_, settings), maxval_);
}

// Each pixel from one of several pictures of one rule each.
Image Studio::unturned_pool(RenderSettings settings) const {
    Random random(settings.seed, 0);
    settings.method = Method::single;
    settings.seed *= settings.pool;
    std::vector<Image> singles;
    for (std::size_t i = 0; i < settings.pool; ++i, ++settings.seed) singles.push_back(picture(settings));
    Image image = singles[0];
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const double choice = random.uniform() * static_cast<double>(singles.size());
            image.set(x, y, singles[static_cast<std::size_t>(choice)](x, y));
        }
    return image;
}

void Studio::count(double rays) {
    done_rays_ += rays;
    if (progress_ && done_rays_ < all_rays_) progress_(done_rays_ / all_rays_);
}
