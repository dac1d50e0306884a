#include "judge/judge_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "experiments/command.h"
#include "experiments/picture_error.h"
#include "judge/background.h"
#include "judge/correct_pictures.h"
#include "judge/likely_mistakes.h"
#include "numerics/cholesky.h"

namespace {

// Standard deviations that a number may be away from the mean, for a correct picture to be called wrong once in
// thousands: more for one rule, whose numbers have longer tails than normal ones.
double accepted_deviations(const RenderSettings& settings) { return shares_one_rule(settings) ? 6 : 5; }

// Minus the logarithm of the density, up to a constant, that the numbers have after n others: Student's with n - 1
// degrees of freedom for each.
double unlikelihood(const Numbers& numbers, const std::vector<Numbers>& others) {
    const double n = static_cast<double>(others.size());
    double sum = 0;
    for (std::size_t i = 0; i < quantity_count; ++i) {
        const Spread spread(others, i);
        const double deviation = (scales[i].to(numbers[i]) - spread.mean) / spread.deviation;
        sum += n / 2 * portable::log(1 + deviation * deviation / (n - 1)) + portable::log(spread.deviation);
    }
    return sum;
}

// How far the numbers are from the mean of others, in standard deviations along the ellipsoid that these scatter in
// (Mahalanobis, 1936): an unlucky rule errs more and more alike, so more with less alike tells a mistake.
double joint_deviation(const Numbers& numbers, const std::vector<Numbers>& others) {
    const double n = static_cast<double>(others.size());
    std::vector<double> mean, difference;
    for (std::size_t i = 0; i < quantity_count; ++i) {
        mean.push_back(Spread(others, i).mean);
        difference.push_back(scales[i].to(numbers[i]) - mean[i]);
    }
    Matrix covariance(quantity_count, quantity_count);
    for (std::size_t i = 0; i < quantity_count; ++i)
        for (std::size_t j = i; j < quantity_count; ++j) {
            for (const Numbers& other : others)
                covariance(i, j) += (scales[i].to(other[i]) - mean[i]) * (scales[j].to(other[j]) - mean[j]);
            covariance(i, j) *= (1 + 1 / n) / (n - 1);
            if (i == j) covariance(i, i) += scales[i].floor * scales[i].floor;
        }
    double sum = 0;
    for (const double whitened : Cholesky(covariance).solve_lower(difference)) sum += whitened * whitened;
    return std::sqrt(sum);
}

// Of a method that shares rules a picture is one sample; pixels of Monte Carlo are many, and take longer.
std::size_t seeds_for(const RenderSettings& settings) {
    return settings.method == Method::mc && !shares_one_rule(settings) ? 20 : 40;
}

constexpr std::size_t candidate_seeds = 8;

// The joint deviation from n others that one picture in 50,000 exceeds, were the numbers normal: (n - k) / (k (n - 1))
// of its square is then distributed as F with k and n - k degrees of freedom (Hotelling, 1931), k = quantity_count.
double accepted_joint_deviation(std::size_t n) { return n == 20 ? 9.9 : 7; }

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
        const Spread spread(correct, i);
        const double reach = deviations * spread.deviation;
        quantities.push_back({scale.name, here[i], mean, std::sqrt(variance), scale.from(spread.mean - reach),
                              scale.from(spread.mean + reach)});
    }
    quantities.push_back(
        {"together", joint_deviation(here, correct), 0, 0, 0, accepted_joint_deviation(correct.size())});
    return quantities;
}

// The likeliest of the candidates, the logarithm of how many times likelier it is than the first, and the most that is
// accepted of it: correct pictures whose numbers are of two kinds, as with and without the sun, have much of it too.
struct Resemblance {
    Candidate likeliest;
    double excess, accepted;
};

// All candidates would take long at full size. The rays of small pictures are not those of a thinned one, so these have
// a truth of their own.
Resemblance resemblance(const Image& image, const Truth& truth, const std::vector<Numbers>& correct_at_full_size,
                        const std::vector<Candidate>& candidates, int step, Studio& studio) {
    const Truth thin{thinned(truth.image, step), thinned(truth.mask, image.width(), image.height(), step)};
    const Numbers here = thin.numbers(thinned(image, step));
    RenderSettings small = candidates[0].settings;
    small.width = thin.image.width();
    small.height = thin.image.height();
    const Truth small_truth = step == 1 ? truth : studio.truth(studio.dense(small));
    const std::vector<Numbers> correct =
        step == 1 ? correct_at_full_size : studio.numbers(candidates[0], small_truth, seeds_for(small));
    const auto excess_of = [](const Numbers& numbers, const std::vector<Numbers>& first,
                              const std::vector<Numbers>& others) {
        return unlikelihood(numbers, first) - unlikelihood(numbers, others);
    };
    Resemblance best{candidates[0], 0, 10};
    std::vector<Numbers> best_numbers = correct;
    for (std::size_t i = 1; i < candidates.size(); ++i) {
        std::vector<Numbers> others;
        try {
            others = studio.numbers(candidates[i], small_truth, candidate_seeds);
        } catch (const NotPositiveDefinite&) {
            continue;  // no program makes pictures with so many samples
        }
        const double excess = excess_of(here, correct, others);
        if (excess <= best.excess) continue;
        best = {candidates[i], excess, 10};
        best_numbers = std::move(others);
    }
    for (std::size_t i = 0; i < correct.size(); ++i) {
        std::vector<Numbers> rest = correct;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
        best.accepted = std::max(best.accepted, 10 + excess_of(correct[i], rest, best_numbers));
    }
    return best;
}

// What the pattern of the errors tells of a picture that should be of the settings but is not; or an empty text.
std::string mistake_by_pattern(const PictureJudgement& judgement, const Candidate& likeliest,
                               const RenderSettings& settings) {
    const auto misfits = std::count_if(judgement.quantities.begin(), judgement.quantities.end(),
                                       [](const Quantity& quantity) { return !quantity.fits(); });
    if (misfits == 1 && !judgement.fits("background"))
        return "the environment is looked up beside the place, or between other centres of texels";
    const auto rmse = std::find_if(judgement.quantities.begin(), judgement.quantities.end(),
                                   [](const Quantity& quantity) { return std::string(quantity.name) == "rmse"; });
    if (rmse->here > 2 * rmse->expected && !judgement.fits("correlation"))
        return "an error that neighbouring pixels share, largest in the block above";
    const Method seems = likeliest.settings.method, wanted = settings.method;
    const bool of_another = !judgement.fits("alike") || !judgement.fits("unlike");
    if (of_another && !likeliest.turns && wanted != Method::single) return "the rules are not turned";
    if (of_another && seems == Method::single) return "one rule for all pixels, not turned";
    if (of_another && seems == Method::rotated && wanted != Method::mc && wanted != Method::rotated)
        return "one rule for all pixels, if turned";
    if (of_another && seems == Method::mc) return "weights of Monte Carlo, or samples turned one by one";
    if (judgement.fits("rmse") && judgement.fits("brightness")) return "";
    return "wrong weights, another number of samples, or samples that are not around the normal";
}

// The settings at the picture's size.
RenderSettings sized(RenderSettings settings, const Image& picture) {
    settings.width = picture.width();
    settings.height = picture.height();
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const double objects = object_pixels(sphere_scene(), settings.width, settings.height);
    if (objects < 500)
        throw std::invalid_argument(line("%d x %d pixels are too few to judge: %.0f show an object, 500 should",
                                         settings.width, settings.height, objects));
    return settings;
}

// Of the dense rule, of the correct pictures, and of the small ones.
double rays_for(const std::vector<Candidate>& candidates, int step) {
    const RenderSettings& settings = candidates[0].settings;
    const int width = settings.width, height = settings.height;
    const auto of_truth_and_correct = [&](int w, int h) {
        return static_cast<double>(dense_samples) * w * h +
               static_cast<double>(seeds_for(settings)) * Studio::rays(candidates[0], w, h);
    };
    double rays = of_truth_and_correct(width, height);
    if (step > 1) rays += of_truth_and_correct(width / step, height / step);
    for (std::size_t i = 1; i < candidates.size(); ++i)
        rays += candidate_seeds * Studio::rays(candidates[i], width / step, height / step);
    return rays;
}

}  // namespace

bool PictureJudgement::fits(const std::string& name) const {
    return std::all_of(quantities.begin(), quantities.end(),
                       [&](const Quantity& q) { return q.name != name || q.fits(); });
}

bool PictureJudgement::fits() const {
    return std::all_of(quantities.begin(), quantities.end(), [](const Quantity& quantity) { return quantity.fits(); });
}

PictureJudgement judge_picture(const Picture& picture, const EnvironmentMap& environment, const RenderSettings& wanted,
                               const Progress& progress) {
    const int maxval = picture.maxval;
    const RenderSettings settings = sized(wanted, picture.image);
    const std::vector<Candidate> candidates = candidates_for(settings);
    const int step = std::max(1, std::min(settings.width, settings.height) / 150);
    Studio studio(environment, maxval, progress);
    studio.expect(rays_for(candidates, step));

    const Image dense = studio.dense(settings);
    const Truth truth = studio.truth(dense);
    const Background background = background_of(picture.image, maxval, truth.image, truth.mask, environment);
    const Image image = maxval > 0 ? unrounded(picture.image, maxval, background.offset) : picture.image;
    const Numbers here = truth.numbers(image);
    if (!std::isfinite(here[1]))
        throw std::invalid_argument("the environment lights no object, so there is nothing to judge; take another");
    const BlockError block = largest_block_error(truth.mask, image, truth.image, truth.block_side());
    const std::vector<Numbers> correct = studio.numbers(candidates[0], truth, seeds_for(settings));
    const auto background_pixels = static_cast<double>(std::count(truth.mask.begin(), truth.mask.end(), false));
    PictureJudgement judgement{
        quantities_of(here, correct, accepted_deviations(settings), background.differing, background_pixels), block.x,
        block.y, "", ""};

    const Resemblance best = resemblance(image, truth, correct, candidates, step, studio);
    const bool other_method = best.likeliest.settings.method != settings.method || !best.likeliest.turns;
    judgement.quantities.push_back({"unlike", other_method ? best.excess : 0, 0, 0, 0, best.accepted});
    judgement.resembles = best.likeliest.name;
    studio.finish();
    if (judgement.fits()) return judgement;
    judgement.mistake =
        likely_mistake(environment, picture.image, maxval, dense, settings.samples, judgement.fits("background"));
    if (judgement.mistake.empty())
        judgement.mistake = mistake_by_pattern(judgement, best.likeliest, settings);
    else
        judgement.resembles.clear();  // the numbers of a picture that is wrong as a whole resemble nothing
    return judgement;
}
