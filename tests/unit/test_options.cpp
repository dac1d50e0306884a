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
    settings = {};
    CHECK(parse_model({"--smoothness", "1.3", "--placement", "fibonacci"}, settings).empty());
    CHECK((*settings.make_covariance())(0.75) == Sobolev(1.3)(0.75));
    CHECK(settings.placement == Placement::fibonacci);
    settings.known = Known::cosine;
    CHECK_THROWS_AS(require_closed_form(settings), UsageError);
    settings.smoothness = 1.5;
    CHECK_NOTHROW(require_closed_form(settings));
}
