#include "predicted_picture.h"

#include "test.h"

namespace {

std::vector<std::string> parse_model(std::vector<std::string> arguments, ModelSettings& settings) {
    const ModelOptions model(settings);
    return parse(std::move(arguments), join({model.process, {model.placement, model.seed}}));
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
    CHECK(settings.known == KnownPart::cosine);
    CHECK(settings.placement == Placement::cosine_fibonacci);
    CHECK_NOTHROW(require_closed_form(settings));
    settings.smoothness = 1.4;
    CHECK_THROWS_AS(require_closed_form(settings), UsageError);
    settings = {};
    CHECK_THROWS_AS(parse_model({"--length-scale", "1"}, settings), UsageError);
    CHECK_THROWS_AS(parse_model({"--covariance", "squared-exponential", "--smoothness", "1.5"}, settings), UsageError);
    settings = {};
    for (const char* bad : {"1", "2", "0", "nan", "1.5x"})
        CHECK_THROWS_AS(parse_model({"--smoothness", bad}, settings), UsageError);
    CHECK_THROWS_AS(parse_model({"--noise", "-1"}, settings), UsageError);
}

TEST_CASE("only a picture has a light that can be known") {
    PictureSettings settings;
    CHECK_THROWS_AS(parse_model({"--known", "light"}, settings), UsageError);
    CHECK(parse({"--known", "light"}, PictureOptions(settings).process).empty());
    CHECK(settings.known_part() == Known::light);
    CHECK(parse({"--method", "mc", "--known", "light"},
                join({{PictureOptions(settings).method}, PictureOptions(settings).process}))
              .empty());
}

TEST_CASE("only a lattice of Monte Carlo has more than 4096 samples") {
    PictureSettings settings;
    settings.samples = 4097;
    CHECK_THROWS_AS(require_possible(settings), UsageError);
    settings.method = Method::mc;
    CHECK_THROWS_AS(require_possible(settings), UsageError);
    settings.placement = Placement::fibonacci;
    CHECK_NOTHROW(require_possible(settings));
}

TEST_CASE("Monte Carlo on a lattice predicts no error, nor does one sample, which only those are told who ask") {
    PictureSettings settings;
    settings.method = Method::mc;
    settings.placement = Placement::fibonacci;
    Prediction prediction;
    CHECK_NOTHROW(require_predictable(prediction, settings));
    prediction.show = Show::error;
    CHECK_THROWS_AS(require_predictable(prediction, settings), UsageError);
    settings.placement = Placement::cosine;
    CHECK_NOTHROW(require_predictable(prediction, settings));
    settings.width = settings.height = 20;
    settings.samples = 1;
    CHECK_THROWS_AS(asked_picture(desert, settings, prediction, Format::pfm, nullptr), UsageError);
    settings.method = Method::pool;
    CHECK_NOTHROW(asked_picture(desert, settings, prediction, Format::pfm, nullptr));
}
