#include "prediction.h"

#include "test.h"

namespace {

std::vector<std::string> parse_model(std::vector<std::string> arguments, ModelSettings& settings) {
    const ModelOptions model(settings);
    return parse(std::move(arguments), join({model.process, {model.known, model.placement}}));
}

}  // namespace

TEST_CASE("model options make the covariance that they name") {
    ModelSettings settings;
    CHECK(parse_model({"--covariance", "squared-exponential", "--length-scale", "0.5"}, settings).empty());
    CHECK((*settings.make_covariance())(0.75) == SquaredExponential(0.5)(0.75));
    CHECK(
        parse_model({"--covariance", "sobolev", "--smoothness", "1.3", "--placement", "fibonacci"}, settings).empty());
    CHECK((*settings.make_covariance())(0.75) == Sobolev(1.3)(0.75));
    CHECK(settings.placement == Placement::fibonacci);
    settings = {};
    CHECK(parse_model({"--known", "cosine", "--placement", "cosine-fibonacci"}, settings).empty());
    CHECK(settings.known == Known::cosine);
    CHECK(settings.placement == Placement::cosine_fibonacci);
    CHECK_NOTHROW(require_closed_form(settings));
    settings.smoothness = 1.4;
    CHECK_THROWS_AS(require_closed_form(settings), UsageError);
    CHECK_THROWS_WITH_AS(
        parse_model({"--length-scale", "2"}, settings),
        "--length-scale would change nothing: it belongs to --covariance squared-exponential; leave it out",
        UsageError);
}

TEST_CASE("only a picture has a light that can be known") {
    PictureSettings settings;
    CHECK_THROWS_AS(parse_model({"--known", "light"}, settings), UsageError);
    const PictureOptions options(settings);
    CHECK(parse({"--method", "mc", "--known", "light"}, {options.method, options.known}).empty());
    CHECK(settings.known == Known::light);
}
