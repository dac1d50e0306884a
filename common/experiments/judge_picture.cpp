#include "experiments/judge_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <thread>
#include <utility>

#include "command_line.h"
#include "experiments/command.h"
#include "experiments/picture_error.h"
#include "experiments/suspects.h"

namespace {

// RMSE, brightness, correlation, alike neighbours, largest block error.
constexpr std::size_t quantity_count = 5;
using Numbers = std::array<double, quantity_count>;

// A scale on which the spread of a number over seeds is about normal, and what must be allowed for on it beyond the
// spread: correct programs differ in their frames and roundings.
struct Scale {
    const char* name;
    double (*to)(double);
    double (*from)(double);
    double floor;
};

double itself(double x) { return x; }
double log_of_positive(double x) { return portable::log(std::max(x, 1e-12)); }

// Independent pixels have correlations of about 0, of either sign; hence the 0.05.
double log_odds(double correlation) {
    return portable::log((0.05 + std::max(correlation, -0.045)) / (1.01 - correlation));
}
double from_log_odds(double t) {
    const double odds = portable::exp(t);
    return std::min(1.0, (1.01 * odds - 0.05) / (1 + odds));
}

constexpr Scale scales[quantity_count] = {{"rmse", log_of_positive, portable::exp, 0.01},
                                          {"brightness", itself, itself, 0.001},
                                          {"correlation", log_odds, from_log_odds, 0.1},
                                          {"alike", log_of_positive, portable::exp, 0.05},
                                          {"block", log_of_positive, portable::exp, 0.1}};

// Whether all pixels share one rule: a picture is then one sample.
bool shares_one_rule(const RenderSettings& settings) {
    return settings.method == Method::single || settings.method == Method::rotated ||
           (settings.method == Method::mc && is_lattice(settings.placement));
}

// Standard deviations that a number may be away from the mean, for a correct picture to be called wrong once in
// thousands: more for one rule, whose numbers have longer tails than normal ones.
double accepted_deviations(const RenderSettings& settings) { return shares_one_rule(settings) ? 6 : 5; }

// Of numbers on their scale.
struct Spread {
    double mean = 0, deviation = 0;

    // The standard deviation of a new number from the mean of so many.
    Spread(const std::vector<Numbers>& all, std::size_t which, const Scale& scale) {
        const double n = static_cast<double>(all.size());
        double variance = 0;
        for (const Numbers& numbers : all) mean += scale.to(numbers[which]) / n;
        for (const Numbers& numbers : all) {
            const double difference = scale.to(numbers[which]) - mean;
            variance += difference * difference / (n - 1);
        }
        deviation = std::max(scale.floor, std::sqrt(variance * (1 + 1 / n)));
    }
};

// The truth at one size, and what pictures differ from it by.
struct Truth {
    Image image;
    std::vector<bool> mask;

    Numbers numbers(const Image& picture) const {
        const ImageError error = image_error(mask, picture, image);
        return {error.rmse, error.brightness, error.correlation, alike_neighbours(mask, picture, image, error.rmse),
                largest_block_error(mask, picture, image, block_side()).error};
    }

    int block_side() const { return std::max(4, std::min(image.width(), image.height()) / 25); }
};

Image clamped(Image image) {
    const auto at_most_1 = [](Color c) { return Color{std::min(c.x, 1.0), std::min(c.y, 1.0), std::min(c.z, 1.0)}; };
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) image.set(x, y, at_most_1(image(x, y)));
    return image;
}

// Pictures of a method whose numbers the judged one's are compared with.
struct Candidate {
    std::string name;  // its options
    RenderSettings settings;
    bool turns = true;  // false: a pool that is not turned
};

// Correct pictures of the scene, as a file with such codes keeps them.
class Studio {
public:
    Studio(const Scene& scene, const EnvironmentMap& environment, const Covariance& covariance, int maxval,
           const Progress& progress, double all_rays)
        : scene_(scene),
          environment_(environment),
          covariance_(covariance),
          maxval_(maxval),
          progress_(progress),
          all_rays_(all_rays) {}

    Image picture(const RenderSettings& settings) const {
        return stored(render(scene_, environment_, covariance_, settings), maxval_);
    }

    Image truth(RenderSettings settings) {
        settings.method = Method::mc;
        settings.placement = Placement::cosine_fibonacci;
        settings.samples = dense_samples;
        settings.light = nullptr;
        Image image = render(scene_, environment_, covariance_, settings);
        count(static_cast<double>(dense_samples) * settings.width * settings.height);
        return image;
    }

    std::vector<Numbers> numbers(const Candidate& candidate, const Truth& truth, std::size_t seeds) {
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

    // About how many rays of a shared rule take the time of one such picture.
    static double rays(const Candidate& candidate, int width, int height) {
        const RenderSettings& settings = candidate.settings;
        const double n = static_cast<double>(settings.samples) * (settings.method == Method::mc ? 4 : 1);
        return (n + 30) * width * height * (candidate.turns ? 1 : static_cast<double>(settings.pool));
    }

    // They leave an RMSE of 0.0003, where 40 samples of the best method leave 0.005.
    static constexpr std::size_t dense_samples = 2000;

private:
    void count(double rays) {
        done_rays_ += rays;
        if (progress_) progress_(std::min(done_rays_ / all_rays_, 1.0));
    }

    // Away from the seeds that pictures to be judged are made with.
    static constexpr std::uint64_t first_seed = 1000000;

    // A large pool in place of a process for each pixel: its pictures have the same numbers.
    static RenderSettings cheaper(RenderSettings settings) {
        if (settings.method != Method::direct) return settings;
        const double n = static_cast<double>(settings.samples);
        settings.method = Method::pool;
        settings.pool = static_cast<std::size_t>(std::clamp(5e8 / (n * n * n), 100.0, 2000.0));
        return settings;
    }

    // Each pixel from one of several pictures of one rule each.
    Image unturned_pool(RenderSettings settings) const {
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

    const Scene& scene_;
    const EnvironmentMap& environment_;
    const Covariance& covariance_;
    int maxval_;
    const Progress& progress_;
    double done_rays_ = 0, all_rays_;
};

// How the codes of a picture's background differ from those that they should be.
struct Background {
    double differing;  // fraction of the pixels with a code off by more than 1.5
    double offset;     // mean of what the others lack: 1/2 where a program rounds down
};

// Codes, or for floats 128 values to the largest channel of a pixel: radiance in a Radiance picture has no more.
Background background_of(const Image& picture, int maxval, const Image& expected, const std::vector<bool>& mask) {
    double count = 0, differing = 0, channels = 0, lacking = 0;
    std::size_t pixel = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x, ++pixel) {
            if (mask[pixel]) continue;
            const Color here = picture(x, y), right = expected(x, y);
            const double largest = std::max({right.x, right.y, right.z, 1e-6});
            bool differs = false;
            for (const auto& [a, b] : {std::pair(here.x, right.x), {here.y, right.y}, {here.z, right.z}}) {
                const double missing =
                    maxval > 0 ? maxval * (srgb_encoded(b) - srgb_encoded(a)) : 128 * (b - a) / largest;
                differs = differs || !(std::fabs(missing) <= 1.5);
                if (std::fabs(missing) > 1.5 || b >= 1) continue;
                lacking += missing;
                channels += 1;
            }
            differing += differs;
            count += 1;
        }
    return {count > 0 ? differing / count : 0, channels > 100 && maxval > 0 ? lacking / channels : 0};
}

// The picture as it was before its program rounded it in its own way.
Image unrounded(Image image, int maxval, double offset) {
    const auto value = [&](double linear) {
        const double code = maxval * srgb_encoded(linear);
        if (code < 0.5 || code > maxval - 0.5) return linear;
        return srgb_decoded(std::max(0.0, code + offset) / maxval);
    };
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Color c = image(x, y);
            image.set(x, y, {value(c.x), value(c.y), value(c.z)});
        }
    return image;
}

// The truth with the background of single texels: what the practice's lookup gives.
Image with_texels(const Scene& scene, const EnvironmentMap& environment, Image truth) {
    const Camera camera{truth.width(), truth.height()};
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x)
            if (const Ray ray = camera.ray(x, y); !intersect(scene, ray))
                truth.set(x, y, environment.radiance(ray.direction));
    return truth;
}

std::string options_of(const RenderSettings& settings) {
    return line("--method %s --samples %zu", name_of(settings.method, method_names), settings.samples);
}

// The settings themselves first.
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
    candidates.push_back({options_of(settings) + ", the pool not turned", settings, false});
    return candidates;
}

// Minus the logarithm of the density, up to a constant, that the numbers have after n others: Student's with n - 1
// degrees of freedom for each.
double unlikelihood(const Numbers& numbers, const std::vector<Numbers>& others) {
    const double n = static_cast<double>(others.size());
    double sum = 0;
    for (std::size_t i = 0; i < quantity_count; ++i) {
        const Spread spread(others, i, scales[i]);
        const double deviation = (scales[i].to(numbers[i]) - spread.mean) / spread.deviation;
        sum += n / 2 * portable::log(1 + deviation * deviation / (n - 1)) + portable::log(spread.deviation);
    }
    return sum;
}

// Of a method that shares rules a picture is one sample; pixels of Monte Carlo are many, and take longer.
std::size_t seeds_for(const RenderSettings& settings) {
    return settings.method == Method::mc && !shares_one_rule(settings) ? 20 : 40;
}

constexpr std::size_t candidate_seeds = 8;

// The quantities of a picture with such numbers among correct ones, and of its background.
std::vector<Quantity> quantities_of(const Numbers& here, const std::vector<Numbers>& correct, double deviations,
                                    double differing, double background_pixels) {
    std::vector<Quantity> quantities = {
        {"background", differing, 0, 0, 0, std::max(0.001, 2 / std::max(1.0, background_pixels))}};
    for (std::size_t i = 0; i < quantity_count; ++i) {
        const Scale& scale = scales[i];
        const double n = static_cast<double>(correct.size());
        double mean = 0, variance = 0;
        for (const Numbers& numbers : correct) mean += numbers[i] / n;
        for (const Numbers& numbers : correct) variance += (numbers[i] - mean) * (numbers[i] - mean) / (n - 1);
        const Spread spread(correct, i, scale);
        const double reach = deviations * spread.deviation;
        quantities.push_back({scale.name, here[i], mean, std::sqrt(variance), scale.from(spread.mean - reach),
                              scale.from(spread.mean + reach)});
    }
    return quantities;
}

// The likeliest of the candidates, and the logarithm of how many times likelier it is than the first.
struct Resemblance {
    Candidate likeliest;
    double excess;
};

Resemblance resemblance(const Numbers& here, const std::vector<Candidate>& candidates, Studio& studio,
                        const Truth& truth) {
    const double first = unlikelihood(here, studio.numbers(candidates[0], truth, candidate_seeds));
    Resemblance best{candidates[0], 0};
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        const double excess = first - unlikelihood(here, studio.numbers(candidates[i], truth, candidate_seeds));
        if (excess > best.excess) best = {candidates[i], excess};
    }
    return best;
}

// What the pattern of the errors tells of a picture that should be of the settings but is not; or an empty text.
std::string mistake_by_pattern(const PictureJudgement& judgement, const Candidate& likeliest,
                               const RenderSettings& settings) {
    const Method seems = likeliest.settings.method, wanted = settings.method;
    const bool patterned = !judgement.fits("alike") || !judgement.fits("correlation") || !judgement.fits("unlike");
    if (!patterned) return judgement.fits("rmse") ? "" : "another number of samples, or wrong weights";
    if (!likeliest.turns && wanted != Method::single) return "the rules are not turned";
    if (seems == Method::single && wanted != Method::single) return "one rule for all pixels, not turned";
    if (seems == Method::rotated && wanted != Method::mc) return "one rule for all pixels, if turned";
    if (seems == Method::mc && wanted != Method::mc) return "weights of Monte Carlo, or samples turned one by one";
    return "";
}

}  // namespace

bool PictureJudgement::fits(const std::string& name) const {
    return std::all_of(quantities.begin(), quantities.end(),
                       [&](const Quantity& q) { return q.name != name || q.fits(); });
}

bool PictureJudgement::fits() const {
    return std::all_of(quantities.begin(), quantities.end(), [](const Quantity& quantity) { return quantity.fits(); });
}

PictureJudgement judge_picture(const Picture& picture, const EnvironmentMap& environment, const Covariance& covariance,
                               const RenderSettings& wanted, const Progress& progress) {
    const Scene scene = sphere_scene();
    const int width = picture.image.width(), height = picture.image.height(), maxval = picture.maxval;
    const std::vector<bool> mask = object_mask(scene, width, height);
    const auto objects = static_cast<double>(std::count(mask.begin(), mask.end(), true));
    if (objects < 500)
        throw std::invalid_argument(
            line("%d x %d pixels are too few to judge: %.0f show an object, 500 should", width, height, objects));
    RenderSettings settings = wanted;
    settings.width = width;
    settings.height = height;
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const std::vector<Candidate> candidates = candidates_for(settings);
    const Candidate& asked = candidates[0];
    const int step = std::max(1, std::min(width, height) / 150);
    double rays = static_cast<double>(Studio::dense_samples) * width * height +
                  static_cast<double>(seeds_for(settings)) * Studio::rays(asked, width, height);
    for (const Candidate& candidate : candidates)
        rays += candidate_seeds * Studio::rays(candidate, width / step, height / step);
    Studio studio(scene, environment, covariance, maxval, progress, rays);

    const Image dense = studio.truth(settings);
    const Truth truth{maxval > 0 ? clamped(dense) : dense, mask};
    const Background interpolated = background_of(picture.image, maxval, truth.image, mask),
                     texels = background_of(picture.image, maxval, with_texels(scene, environment, truth.image), mask),
                     background = texels.differing < interpolated.differing ? texels : interpolated;
    const Image image = maxval > 0 ? unrounded(picture.image, maxval, background.offset) : picture.image;
    const Numbers here = truth.numbers(image);
    if (!std::isfinite(here[1]))
        throw std::invalid_argument("the environment lights no object, so there is nothing to judge; take another");
    const BlockError block = largest_block_error(mask, image, truth.image, truth.block_side());
    const std::vector<Numbers> correct = studio.numbers(asked, truth, seeds_for(settings));
    const double background_pixels = static_cast<double>(mask.size()) - objects;
    PictureJudgement judgement{
        quantities_of(here, correct, accepted_deviations(settings), background.differing, background_pixels), block.x,
        block.y, "", ""};

    const Truth thin{thinned(truth.image, step), thinned(mask, width, height, step)};
    const Numbers thin_here = thin.numbers(thinned(image, step));
    RenderSettings small = settings;  // its rays are not those of the thinned picture, so it has a truth of its own
    small.width = thin.image.width();
    small.height = thin.image.height();
    const Image small_truth = studio.truth(small);
    const Truth coarse{maxval > 0 ? clamped(small_truth) : small_truth, object_mask(scene, small.width, small.height)};
    const Resemblance best = resemblance(thin_here, candidates, studio, coarse);
    const bool other_method = best.likeliest.settings.method != settings.method || !best.likeliest.turns;
    judgement.quantities.push_back({"unlike", other_method ? best.excess : 0, 0, 0, 0, 10});
    judgement.resembles = best.likeliest.name;
    if (judgement.fits()) return judgement;
    judgement.mistake = likely_mistake(scene, environment, picture.image, maxval, dense, settings.samples);
    if (judgement.mistake.empty())
        judgement.mistake = mistake_by_pattern(judgement, best.likeliest, settings);
    else
        judgement.resembles.clear();  // the numbers of a picture that is wrong as a whole resemble nothing
    return judgement;
}
