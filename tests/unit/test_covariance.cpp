#include "quadrature/covariance.h"

#include "quadrature/hemisphere.h"

#include "test.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>

using portable::pi;

namespace {

struct TableRow {
    std::string kernel, cos_theta;
    double parameter, value;
};

// 40-digit quadrature that shares nothing with the formulas under test.
std::vector<TableRow> integral_table() {
    std::ifstream in("tests/unit/hemisphere_integrals.txt");
    std::vector<TableRow> rows;
    for (std::string line; std::getline(in, line);) {
        if (line[0] == '#') continue;
        std::istringstream words(line);
        TableRow row;
        words >> row.kernel >> row.parameter >> row.cos_theta >> row.value;
        rows.push_back(row);
    }
    return rows;
}

std::unique_ptr<Covariance> covariance_of(const TableRow& row) {
    if (row.kernel != "squared_exponential") return std::make_unique<Sobolev>(row.parameter);
    return std::make_unique<SquaredExponential>(row.parameter);
}

}  // namespace

TEST_CASE("z and zz agree with independent 40-digit quadrature to 2e-15, to 2e-14 for length-scales below 0.1") {
    int rows = 0;
    for (const TableRow& row : integral_table()) {
        const KnownPart known = row.kernel == "sobolev_cosine" ? KnownPart::cosine : KnownPart::nothing;
        const auto covariance = covariance_of(row);
        const double ours =
            row.cos_theta == "-" ? covariance->integral_of_z(known) : covariance->z(std::stod(row.cos_theta), known);
        const double bound = row.kernel == "squared_exponential" && row.parameter < 0.1 ? 2e-14 : 2e-15;
        CAPTURE(row.kernel);
        CAPTURE(row.parameter);
        CAPTURE(row.cos_theta);
        CHECK(std::fabs(ours / row.value - 1) <= bound);
        ++rows;
    }
    CHECK(rows == 156);
}

TEST_CASE("the closed form and the sum for any smoothness meet at s = 3/2") {
    // The neighbouring double of 3/2 takes the sum. Over that step z changes by up to 4e-16 relative; the sum is wrong
    // by up to 1.3e-15, the closed form by 4e-16.
    const Sobolev closed(1.5), sum(std::nextafter(1.5, 2));
    for (double c = 1; c > 1e-30; c *= 0.7) CHECK(std::fabs(sum.z(c) / closed.z(c) - 1) < 2.1e-15 + 4e-16);
    CHECK(std::fabs(sum.integral_of_z() / closed.integral_of_z() - 1) < 2e-15);
}

TEST_CASE("z at pole and equator has its elementary values") {
    for (double s : {1.001, 1.2, 1.5, 1.8, 1.999}) {
        const double two_p = std::pow(2, s - 1), constant = std::pow(2, 2 * s - 1) / s;
        CHECK(std::fabs(Sobolev(s).z(1) / (2 * pi * (constant - two_p / s)) - 1) < 2e-15);
        CHECK(std::fabs(Sobolev(s).z(0) / (pi * std::pow(4, s) / (2 * s)) - 1) < 2e-15);
    }
}

TEST_CASE("z tends smoothly to its value on the equator") {
    for (const Sobolev& covariance : {Sobolev(1.5), Sobolev(1.2)}) {
        const double equator = covariance.z(0);
        for (double c : {1e-300, 1e-100, 1e-18, 1e-16}) CHECK(std::fabs(covariance.z(c) / equator - 1) < 1e-15);
        CHECK(covariance.z(1e-12) > equator);
    }
}

TEST_CASE("z is the integral of k: a dense quadrature agrees") {
    // The mean over 1e5 Fibonacci directions of k - k(r = 0), whose error falls faster than 1 / n: 1e-4 is ample.
    const std::vector<Vec3> directions = fibonacci_directions(100000);
    const Vec3 from = normalize({0.6, 0.5, -0.2});
    const Sobolev rough(1.2), elliptic(1.5);
    const SquaredExponential smooth(0.4);
    for (const Covariance* covariance :
         {static_cast<const Covariance*>(&rough), static_cast<const Covariance*>(&elliptic),
          static_cast<const Covariance*>(&smooth)}) {
        double sum = 0;
        for (const Vec3& to : directions) sum += (*covariance)(dot(to - from, to - from));
        CHECK(std::fabs(2 * pi / 1e5 * sum - covariance->z(from.y)) < 1e-4);
    }
}

TEST_CASE("z with the known part cos(theta) has its elementary values at pole and equator") {
    const Sobolev covariance;
    const double root = std::sqrt(2.0);
    CHECK(std::fabs(covariance.z(1, KnownPart::cosine) / (8 * pi / 3 - 8 * root * pi / 15) - 1) < 1e-15);
    CHECK(std::fabs(covariance.z(0, KnownPart::cosine) / (8 * pi / 3 - 64.0 / 15) - 1) < 1e-15);
}

TEST_CASE("zz with the known part cos(theta) is the integral of z cos(theta)") {
    // Gauss-Legendre with 3 points on 200 panels of the elevation cosine: z is smooth but for c log c terms at the
    // equator.
    const double nodes[] = {-std::sqrt(0.6), 0, std::sqrt(0.6)}, weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    double sum = 0;
    for (int panel = 0; panel < 200; ++panel)
        for (int i = 0; i < 3; ++i) {
            const double c = (panel + 0.5 + 0.5 * nodes[i]) / 200;
            sum += weights[i] / 200 * c * Sobolev().z(c, KnownPart::cosine);
        }
    CHECK(std::fabs(2 * pi * sum / Sobolev().integral_of_z(KnownPart::cosine) - 1) < 1e-8);
}

TEST_CASE("a covariance without a closed form for the known part refuses it") {
    const KnownPart known = KnownPart::cosine;
    CHECK_THROWS_AS(Sobolev(1.4).z(0.5, known), std::invalid_argument);
    CHECK_THROWS_AS(Sobolev(1.4).integral_of_z(known), std::invalid_argument);
    CHECK_THROWS_AS(SquaredExponential().z(0.5, known), std::invalid_argument);
    CHECK_THROWS_AS(SquaredExponential().integral_of_z(known), std::invalid_argument);
}

TEST_CASE("k has its defining values") {
    CHECK(std::fabs(Sobolev()(0) - 8.0 / 3) < 1e-15);
    CHECK(std::fabs(Sobolev()(2.25) - (8.0 / 3 - 1.5)) < 1e-15);
    CHECK(std::fabs(Sobolev(1.25)(3) - (std::pow(2, 1.5) / 1.25 - std::pow(3, 0.25))) < 1e-15);
    CHECK(SquaredExponential(0.5)(0) == 1);
    CHECK(std::fabs(SquaredExponential(0.5)(0.75) - std::exp(-1.5)) < 1e-16);
}

TEST_CASE("a long length-scale makes every z the solid angle 2 pi") {
    for (double c : {0.0, 0.5, 1.0}) CHECK(std::fabs(SquaredExponential(1e6).z(c) - 2 * pi) < 1e-11);
    CHECK(std::fabs(SquaredExponential(1e6).integral_of_z() - 4 * pi * pi) < 1e-10);
}

TEST_CASE("parameters outside their domain are refused with their value") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (double s : {1.0, 2.0, 0.0, -1.5, nan, infinity}) CHECK_THROWS_AS(Sobolev{s}, std::invalid_argument);
    for (double l : {0.0499, 0.0, -1.0, nan, infinity}) CHECK_THROWS_AS(SquaredExponential{l}, std::invalid_argument);
    CHECK_THROWS_WITH(SquaredExponential(0.01), "the length-scale must be at least 0.05; it is 0.010000");
}
