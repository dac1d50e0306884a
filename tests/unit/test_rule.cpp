#include "experiments/reports.h"
#include "experiments/samples.h"
#include "test.h"

static Samples samples_in(const std::string& content) {
    std::istringstream in(content);
    return read_samples(in);
}

// The report on directions in a file of this content.
static std::string report_on(const std::string& content, std::vector<std::string> words = {}) {
    const TemporaryFile file(content);
    words.push_back("--directions=" + file.name);
    return output_of(rule_report, words);
}

TEST_CASE("directions are read with or without values") {
    const Samples samples = samples_in("# x y z value\r\n0 1 0 2.5\r\n\n0.6 0.8 0 -1e3 # low\n\t0.0 0 -1\t7");
    CHECK(samples.directions == std::vector<Vec3>{{0, 1, 0}, {0.6, 0.8, 0}, {0, 0, -1}});
    CHECK(samples.values == std::vector<double>{2.5, -1000, 7});
    CHECK(samples_in("\xef\xbb\xbf 0 1 0\n1 0 0\n").values.empty());
    CHECK(samples_in("0.8000008 0.6 0\n").directions.size() == 1);  // a length of 1 + 6.4e-7
}

static void refused(const std::string& content, const std::string& reason) {
    CAPTURE(content.substr(0, 80));
    CHECK(message_of([&] { samples_in(content); }) == Containing{reason});
}

TEST_CASE("a line that is no direction is named, with what is wrong and what to do") {
    const auto not_a_number = [](const std::string& line, const std::string& word) {
        refused("0 1 0\n\n" + line, "line 3: '" + word +
                                        "' is not a number such as -0.5, with a hyphen and a point; plain "
                                        "blanks stand between columns, and # begins a comment");
    };
    not_a_number("0 1 0x\n", "0x");
    not_a_number("0;1;0", "0;1;0");
    not_a_number(std::string("0 1 0 5\0\n", 9), "5");
    not_a_number("0\xc2\xa0-1\xc2\xa0-0\n", "0\xc2\xa0-1\xc2\xa0-0");  // no-break spaces
    not_a_number("0 0 \xe2\x88\x92.5\n", "\xe2\x88\x92.5");            // a minus
    for (const char* word : {"nan", "inf", "1e400"})
        refused(formatted("0 1 %s\n", word), formatted("line 1: '%s' is not finite", word));
    for (const auto& [line, count] : {std::pair("0 1\n", 2), {"0 1 0 1 1\n", 5}})
        refused(line, formatted("line 1: expected x y z or x y z value, not %d columns", count));
    for (const auto& [y, shown] : {std::pair("1.000002", "1.000002"), {"0.9991", "0.9991"}, {"0", "0"}})
        refused(formatted("0 %s 0\n", y), formatted("line 1: the direction has the length %s; divide x, y and", shown));
    for (const auto& [lines, count, before] : {std::tuple("0 1 0\n0 1 0 5\n", 4, 3), {"0 1 0 5\n0 1 0\n", 3, 4}})
        refused(lines, formatted("line 2: %d columns, where earlier lines have %d", count, before));
    refused("0 1 0\n1 -1e-17 0\n", "line 2: y = -1e-17 is below the horizon; directions have y >= 0");
}

TEST_CASE("the number of directions is 1 to 4096, and that of lines and characters limited") {
    std::string rows, comments;
    for (int i = 0; i < 4096; ++i) rows += "0 1 0\n";
    for (int i = 0; i < 65535; ++i) comments += "#\n";
    CHECK(samples_in(rows).directions.size() == 4096);
    refused(rows + "0 1 0\n", "line 4097: at most 4096 directions are allowed");
    refused("# nothing\n", "there is no direction in the file");
    CHECK(samples_in("0 1 0\n" + comments.substr(2)).directions.size() == 1);
    refused("0 1 0\n" + comments, "line 65536: fewer than 65536 lines of fewer than 4096 characters are allowed");
    refused("#" + std::string(4095, ' ') + "\n0 1 0\n", "line 1: fewer than 65536 lines");
}

TEST_CASE("an error of reading is not the end of the directions, wherever it is") {
    check_failing_reads("# x y z\n0 1 0 5\n0.6 0.8 0 7\n", read_samples);
}

// Of one direction w = z / (k(0) + noise^2).
TEST_CASE("the report of directions with the known part cosine says so") {
    const double z = SobolevKnownCosine().z(0.8), w = z / (8.0 / 3 + 0.25);
    const std::string text = report_on("0.6 0.8 0 -3\n", {"--known=cosine", "--noise=0.5"});
    for (const std::string& part :
         {formatted(" %12.9g %24.17g\n", z, w),
          formatted("weights sum to %.6g, and the integral of cos(theta) is 3.14159. The ratio %.4g would", w, w / pi),
          std::string("exact for constants. Negative weights: 0."),
          formatted("# The integral of the values times cos(theta): estimate %.9g, amplitude", -3 * w)})
        CHECK(text == Containing{part});
}

TEST_CASE("an estimate that is too large fails, and an error bar that is only rounding is unknown") {
    const auto report = [](const std::string& lines, const std::string& noise) {
        return report_on(lines, {"--covariance=squared-exponential", "--length-scale=1000", "--noise=" + noise});
    };
    std::string lines;
    for (const Vec3& w : some_directions(40)) lines += formatted("%.17g %.17g %.17g 1\n", w.x, w.y, w.z);
    CHECK(message_of([&] { report(lines, "1e-7"); }) == Containing{"rounding leaves no digit of the weights right"});
    CHECK(report(lines, "1e-6") == Containing{"error bar unknown: what is left of the variance may be rounding"});
    CHECK(report_on("0.6 0.8 0 1\n-0.6 0.8 0 -1\n") == Containing{"estimate 0, amplitude 0."});
    CHECK(report_on("0 1 0 5e-324\n") == Containing{"amplitude 0, error bar unknown: the values are 0, or too small"});
    CHECK(report_on("0 1 0 1e154\n") == Containing{"estimate 4.06"});
    for (const char* values : {"0 1 0 1e308\n0.6 0.8 0 1e308\n", "0 1 0 1e155\n"})  // the estimate, or its bar
        CHECK_THROWS_WITH(report_on(values), "the values are too large for their squares; divide all by one number");
}

// In arithmetic of 128 bits the sum is 6.28318419, the gain 89.563791, and the numbers of the values are 3.14159542078,
// 0.156274806 and 1.56648567e-05, or 3.06376131, 7521.03019 and 0.753901818.
TEST_CASE("of a matrix that is nearly singular no digit is printed that rounding has made wrong") {
    std::string cosine, step;
    for (const Vec3& w : some_directions(100)) {
        cosine += formatted("%.17g %.17g %.17g %.17g\n", w.x, w.y, w.z, w.y);
        step += formatted("%.17g %.17g %.17g %g\n", w.x, w.y, w.z, w.x > 0 ? 1 : 0.5);
    }
    const std::vector<std::string> model{"--covariance=squared-exponential", "--noise=1e-6"};
    for (const char* part : {"# The weights sum to 6.3, and", "of samples 90 times as much",
                             "estimate 3.141595, amplitude 0.16, error bar 1.6e-05\n"})
        CHECK(report_on(cosine, model) == Containing{part});
    CHECK(report_on(step, model) == Containing{"estimate 3.1, amplitude 7.5e+03, error bar 0.75\n"});
}

TEST_CASE("directions are drawn from stream 0, and those of a file have no placement") {
    const std::string report = output_of(rule_report, {"--samples=3", "--placement=fibonacci", "--seed=5"});
    Random random(5, 0);
    const double x = sampler_of({PointSet::fibonacci}, 3)(random)[1].x;
    CHECK(rows_of(report).at(1).at(0) == formatted("%.17g", x));
    CHECK(report_on("0 1 0\n", {"--placement=cosine"}) == report_on("0 1 0\n"));
}
