#include "quadrature/gaussian_process.h"
#include "test.h"

namespace bmc {
std::vector<Vec3> sample_set(std::string_view name, std::size_t n);  // of experiments/stability.cpp
}  // namespace bmc

// A claim of d digits: no error of a weight exceeds 10^-d of the largest weight.
TEST_CASE("the digits that stability calls right are right, held against weights of 128 bits") {
    const char* const tables[] = {
#include "hemisphere_integrals.txt"
    };
    const auto exact = rows_of(tables[1]);
    std::ifstream reference("tests/output/references/stability.txt");
    REQUIRE_MESSAGE(reference, "start it in the project's root, where tests/output/references is");
    const auto claims = rows_of({std::istreambuf_iterator<char>(reference), {}});
    REQUIRE(claims.size() == exact.size());
    for (std::size_t row = 0; row < claims.size(); ++row) {
        const std::vector<std::string>& claim = claims[row];
        REQUIRE(std::equal(claim.begin(), claim.begin() + 4, exact[row].begin()));
        const std::size_t n = std::stoul(claim[1]);
        const auto directions = sample_set(claim[0], n);
        const auto covariance =
            make_covariance(claim[2] == "sobolev" ? CovarianceFamily::sobolev : CovarianceFamily::squared_exponential,
                            std::stod(claim[3]));
        std::size_t column = 4;
        for (const double noise : {1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 0.0}) {
            CAPTURE(claim);
            CAPTURE(noise);
            const std::string digits = claim[column], *weight = &exact[row][3 * column - 8];
            ++column;
            if (digits == "nan") continue;
            const std::vector<double> ours = GaussianProcess(*covariance, noise, directions).weights;
            double largest = 0;
            for (const double each : ours) largest = std::max(largest, std::fabs(each));
            for (const std::size_t i : {std::size_t{0}, n / 2, n - 1})
                CHECK(std::fabs(ours[i] - std::stod(*weight++)) <= largest * std::pow(10, -std::stod(digits)));
        }
    }
}
