#include "numerics/cholesky.h"

#include "experiments/stability.h"

#include "test.h"

namespace {

Matrix product_with_transpose(const Matrix& a, const Matrix& b) {  // a^T b
    Matrix product(a.columns(), b.columns());
    for (std::size_t k = 0; k < a.rows(); ++k)
        for (std::size_t i = 0; i < a.columns(); ++i)
            for (std::size_t j = 0; j < b.columns(); ++j) product(i, j) += a(k, i) * b(k, j);
    return product;
}

// |A|, the largest sum of absolute values in a row: the norm that the maximum norm of vectors induces.
double row_sum_norm(const Matrix& a) {
    double largest = 0;
    for (std::size_t i = 0; i < a.rows(); ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < a.columns(); ++j) sum += std::fabs(a(i, j));
        largest = std::max(largest, sum);
    }
    return largest;
}

// B^T B + I for a random B: condition number of a few n.
Matrix random_spd(std::size_t n, std::uint64_t seed) {
    Random random(seed, n);
    Matrix b(n, n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) b(i, j) = random.uniform() - 0.5;
    Matrix a = product_with_transpose(b, b);
    for (std::size_t i = 0; i < n; ++i) a(i, i) += 1;
    return a;
}

std::vector<Matrix> test_matrices() {
    std::vector<Matrix> matrices;
    const auto add = [&](const Covariance& covariance, double noise, const std::vector<Vec3>& directions) {
        matrices.push_back(symmetric(covariance_matrix(covariance, noise, directions)));
    };
    for (std::size_t n : {1u, 2u, 3u, 7u, 24u, 25u, 40u, 65u}) {
        matrices.push_back(random_spd(n, 1));
        add(Sobolev(), 0.01, random_directions(n));
        add(SquaredExponential(0.3), 0.01, random_directions(n));
    }
    for (const SampleSet set : {SampleSet::random, SampleSet::equator, SampleSet::pole, SampleSet::cluster})
        for (const double noise : {1.0, 1e-4, 1e-6}) {
            add(Sobolev(), noise, sample_set(set, 100));
            add(SquaredExponential(1), noise, sample_set(set, 100));
        }
    return matrices;
}

double residual_of_inverse(const Matrix& a) {
    const Matrix inverse = Cholesky(a).inverse();
    Matrix residual = product_with_transpose(a, inverse);
    for (std::size_t i = 0; i < a.rows(); ++i) residual(i, i) -= 1;
    return row_sum_norm(residual) / (DBL_EPSILON * row_sum_norm(a) * row_sum_norm(inverse));
}

// What becomes of a matrix: the bits of the factor, or the pivot and the text of the refusal.
std::string outcome(const Matrix& a, bool plain) {
    std::string result;
    plain_loops = plain;
    try {
        const Matrix factor = Cholesky(a).upper();
        result.assign(reinterpret_cast<const char*>(factor.row(0)), a.rows() * a.columns() * sizeof(double));
    } catch (const NotPositiveDefinite& error) {
        result = formatted("refused: %zu, %a, %s", error.index, error.value, error.what());
    }
    plain_loops = false;
    return result;
}

// Whether the fast twin does with a matrix what the plain text does, bit for bit.
bool same_outcome(const Matrix& a) { return outcome(a, true) == outcome(a, false); }

}  // namespace

TEST_CASE("the fast twin has the bits of the plain text, for sizes with every remainder") {
    std::vector<std::size_t> sizes{127, 128, 129, 200, 512, 513, 577};
    for (std::size_t n = 1; n <= 100; ++n) sizes.push_back(n);
    for (const std::size_t n : sizes)
        CHECK_MESSAGE(same_outcome(covariance_matrix(Sobolev(), 0.01, random_directions(n))), n);
}

TEST_CASE("the fast twin has the bits of the plain text where a matrix is nearly singular, and refuses the same") {
    std::size_t refused = 0;
    for (const std::size_t n : {5u, 12u, 37u, 65u, 129u, 170u, 260u})
        for (const double noise : {1e-6, 1e-8, 0.0}) {
            const Matrix q = covariance_matrix(SquaredExponential(1), noise, random_directions(n));
            CHECK_MESSAGE(same_outcome(q), n);
            refused += contains(outcome(q, true), "refused");
        }
    CHECK(refused >= 5);
}

TEST_CASE("fast and plain factor refuse the same pivot, whichever it is, and do not read the lower triangle") {
    for (const std::size_t n : {9u, 40u, 175u})
        for (std::size_t k = 0; k < n; k += n < 100 ? 1 : 13) {
            Matrix a = random_spd(n, 1);
            a(k, k) = -1;
            const std::string refusal = outcome(a, true);
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < i; ++j) a(i, j) = std::nan("");
            INFO(n, " ", k);
            CHECK(contains(refusal, formatted("refused: %zu,", k)));
            CHECK(outcome(a, true) == refusal);
            CHECK(outcome(a, false) == refusal);
        }
}

TEST_CASE("cholesky reproduces the matrix: |A - L L^T| / (n eps |A|) < 10, LAPACK's ratio") {
    for (const Matrix& a : test_matrices()) {
        const Cholesky cholesky(a);
        Matrix difference = product_with_transpose(cholesky.upper(), cholesky.upper());
        for (std::size_t i = 0; i < a.rows(); ++i)
            for (std::size_t j = 0; j < a.rows(); ++j) difference(i, j) -= a(i, j);
        CHECK(row_sum_norm(difference) / (static_cast<double>(a.rows()) * DBL_EPSILON * row_sum_norm(a)) < 10);
    }
}

// A backward stable solution leaves a fraction of a rounding however nearly singular A is, here 0.06: its condition is
// 1e13. An inverse whose columns mix several solutions, as when half of it is taken from symmetry, leaves 2.3.
TEST_CASE("cholesky inverts: |I - A A^-1| / (eps |A| |A^-1|) < 3, and < 0.5 for nearly singular matrices") {
    for (const Matrix& a : test_matrices()) CHECK(residual_of_inverse(a) < 3);
    for (std::uint64_t set = 0; set < 20; ++set) {
        const Matrix q = covariance_matrix(SquaredExponential(1), 1e-6, random_directions(65, set));
        CHECK(residual_of_inverse(symmetric(q)) < 0.5);
    }
}

TEST_CASE("cholesky solves: |b - A x| / (n eps |A| |x|) < 10, and half a solution gives b^T A^-1 b") {
    for (const Matrix& a : test_matrices()) {
        const std::size_t n = a.rows();
        Random random(3, n);
        std::vector<double> b(n);
        for (double& element : b) element = random.uniform();
        const Cholesky cholesky(a);
        const std::vector<double> x = cholesky.solve(b), half = cholesky.solve_lower(b);
        double residual = 0, x_norm = 0, form = 0, half_squared = 0;
        for (std::size_t i = 0; i < n; ++i) {
            double r = b[i];
            for (std::size_t j = 0; j < n; ++j) r -= a(i, j) * x[j];
            residual = std::max(residual, std::fabs(r));
            x_norm = std::max(x_norm, std::fabs(x[i]));
            form += b[i] * x[i];
            half_squared += half[i] * half[i];
        }
        CHECK(residual / (static_cast<double>(n) * DBL_EPSILON * row_sum_norm(a) * x_norm) < 10);
        // Both are b^T A^-1 b; their difference is bounded by the same residual.
        CHECK(std::fabs(form - half_squared) <=
              10 * static_cast<double>(n) * DBL_EPSILON * row_sum_norm(a) * x_norm * x_norm * static_cast<double>(n));
    }
}

// A = L L^T with L = [2; 1 3; 4 5 6]: det A = (2 * 3 * 6)^2. Only the upper triangle of A is read.
TEST_CASE("cholesky knows the determinant of a matrix of small integers") {
    Matrix a(3, 3);
    const double elements[3][3] = {{4, 2, 8}, {0, 10, 19}, {0, 0, 77}},
                 factor[3][3] = {{2, 1, 4}, {0, 3, 5}, {0, 0, 6}};
    for (std::size_t i = 0; i < 9; ++i) a(i / 3, i % 3) = elements[i / 3][i % 3];
    const Cholesky cholesky(a);
    for (std::size_t i = 0; i < 9; ++i) CHECK(cholesky.upper()(i / 3, i % 3) == factor[i / 3][i % 3]);
    CHECK(std::fabs(cholesky.log_determinant() - 2 * std::log(36.0)) < 2e-15);
}

TEST_CASE("cholesky rejects an indefinite matrix and names the pivot") {
    Matrix a(2, 2);
    a(0, 0) = 4;
    a(0, 1) = 2;
    a(1, 1) = 1;  // singular: the second pivot is exactly 0
    CHECK_THROWS_WITH_AS(Cholesky{a},
                         "the matrix is not positive definite: pivot 1 is 0 and must exceed 4.4e-16; raise the noise",
                         NotPositiveDefinite);
    a(1, 1) = std::nan("");
    CHECK_THROWS_AS(Cholesky{a}, NotPositiveDefinite);
}

TEST_CASE("cholesky rejects shapes that do not fit") {
    CHECK_THROWS_AS(Cholesky(Matrix(2, 3)), std::invalid_argument);
    CHECK_THROWS_AS(Cholesky(random_spd(3, 1)).solve({1, 2}), std::invalid_argument);
    CHECK_THROWS_AS(Cholesky(random_spd(3, 1)).solve({1, 2, 3, 4}), std::invalid_argument);
}
