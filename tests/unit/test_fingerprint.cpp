#include "../course/judge/fingerprint.h"

#include "test.h"

namespace {

constexpr int side = 40;
const Truth grey = truth_of(image_of(side, side, [](int, int) { return Color{0.5, 0.5, 0.5}; }));

// The truth and an error of f(x, y) in every channel.
template <class Error>
Fingerprint with_error(Error f) {
    return fingerprint(image_of(side, side, [&](int x, int y) { return (0.5 + f(x, y)) * Color{1, 1, 1}; }), grey);
}

// Of forty pictures: number i is 0.01 a, or 0.01 / a, in half of them each; the others are all 0.01.
std::vector<Fingerprint> correct_pictures(std::size_t i, double a) {
    std::vector<Fingerprint> all(40, Fingerprint(first_lag + 1, 0.01));
    for (std::size_t k = 0; k < all.size(); ++k) all[k][i] *= k % 2 == 0 ? a : 1 / a;
    return all;
}

}  // namespace

// Errors alternate, so that neighbours differ by d and the RMSE of a channel is about 0.25: a tenth of it, over three
// channels, is 0.025 sqrt(3), and the vectors differ by d sqrt(3).
TEST_CASE("neighbours, beside and below, are alike where their errors differ by less than a tenth of the RMSE") {
    const auto alike = [&](auto error) { return with_error(error)[3]; };
    CHECK(std::fabs(alike([](int x, int) { return x % 2 ? 0.25 : -0.25; }) - 0.5) < 0.1);
    CHECK(alike([](int x, int y) { return 0.25 + ((x + y) % 2 ? 0.0124 : -0.0124); }) == 1);
    CHECK(alike([](int x, int y) { return 0.25 + ((x + y) % 2 ? 0.0126 : -0.0126); }) == 0);
}

TEST_CASE("the mean error of each colour is told for the sphere and for the rectangle") {
    Image picture = grey.image;
    for_each_hit(sphere_scene(), {side, side}, [&](int x, int y, const Hit& hit) {
        picture.set(x, y, hit.object == Object::sphere ? Color{0.5, 0.75, 0.5} : Color{0.5, 0.5, 0.25});
    });
    const Fingerprint numbers = fingerprint(picture, grey), expected{0, 0.5, 0, 0, 0, -0.5};
    for (std::size_t i = 0; i < 6; ++i) CHECK(std::fabs(numbers[first_part + i] - expected[i]) < 1e-12);
}

TEST_CASE("the block that errs most is found among those that show enough of an object") {
    Image picture = grey.image;
    picture.set(21, 13, {0.98, 0.98, 0.98});  // on the sphere, in the block of 4 x 4 around (22, 14)
    picture.set(0, 0, {9, 9, 9});             // the background
    const BlockError block = largest_block_error(picture, grey);
    CHECK(std::fabs(block.error - 0.03) < 1e-8);  // 0.48 in floats, 1/16 of it
    CHECK(block.x == 22);
    CHECK(block.y == 14);
}

TEST_CASE("a number just inside the accepted deviations fits, and one just outside does not") {
    const double spread = std::sqrt(40.0 / 39 * (1 + 1.0 / 40));  // of a new number, where half are +1 and half -1
    const auto fits = [&](std::size_t i, double number, const std::vector<Fingerprint>& correct) {
        Fingerprint measured(first_lag + 1, 0.01);
        measured[i] = number;
        return compare(measured, correct, {5, 6}).quantities[std::min(i, first_part)].fits();
    };
    // number(t) is t times as far away as is accepted.
    const auto check_border = [&](std::size_t i, const std::vector<Fingerprint>& correct, auto number) {
        CHECK(fits(i, number(0.999), correct));
        CHECK(!fits(i, number(1.001), correct));
    };
    for (const double sign : {1.0, -1.0})
        for (const auto& [i, a] : {std::pair(0u, 1.1), {4u, 1.5}}) {  // rmse, block: on a logarithmic scale
            const double reach = sign * 5 * spread * portable::log(a);
            check_border(i, correct_pictures(i, a), [&](double t) { return 0.01 * portable::exp(t * reach); });
        }
    // The same of errors as small as many samples leave.
    std::vector<Fingerprint> small = correct_pictures(0, 1.1);
    for (Fingerprint& numbers : small) numbers[0] *= 1e-4;
    check_border(0, small, [&](double t) { return 1e-6 * portable::exp(t * 5 * spread * portable::log(1.1)); });
    // Brightness as it is; its least deviation is 0.001. Repeats: 6 deviations, of 0.01 at least.
    check_border(1, correct_pictures(1, 1), [](double t) { return 0.01 + t * 0.005; });
    check_border(first_lag, correct_pictures(first_lag, 1), [](double t) { return 0.01 - t * 0.06; });
    // Correlations by log((0.1 + c) / (1.01 - c)), whose least deviation is 0.1, and near ones 0.03; alike by
    // log(0.003 + f), 0.02.
    for (const auto& [i, reach] : {std::pair(2u, 0.5), {5u, 0.15}})
        check_border(i, correct_pictures(i, 1), [reach = reach](double t) {
            const double high = 0.11 * portable::exp(t * reach);  // (0.1 + c) / (1.01 - c) is 0.11 at 0.01
            return (1.01 * high - 0.1) / (1 + high);
        });
    check_border(3, correct_pictures(3, 1), [](double t) { return 0.013 * portable::exp(t * 0.1) - 0.003; });
}

TEST_CASE("the joint deviation is accepted up to 7") {
    for (const auto& [deviations, fits] : {std::pair(6.99, true), {7.01, false}}) {
        Fingerprint measured(first_lag + 1, 0.01);
        measured[1] += deviations * 0.001;
        CHECK(compare(measured, correct_pictures(1, 1), {5, 6})["together"].fits() == fits);
    }
}

TEST_CASE("numbers that are common each, but not together, are found") {
    std::vector<Fingerprint> correct =
        correct_pictures(0, 1.1);  // where the RMSE is large, the worst block is bad, too
    for (Fingerprint& each : correct) each[block_number] *= std::pow(each[0] / 0.01, 4);
    for (const int power : {8, -8}) {
        Fingerprint measured(first_lag + 1, 0.01);
        measured[0] *= std::pow(1.1, 2);
        measured[block_number] *= std::pow(1.1, power);
        const Comparison comparison = compare(measured, correct, {5, 6});
        CHECK(comparison["rmse"].fits());
        CHECK(comparison["block"].fits());
        CHECK(comparison["together"].fits() == (power > 0));
    }
}
