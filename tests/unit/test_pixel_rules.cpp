#include "scene/pixel_rules.h"
#include "test.h"

static void check_equal(const QuadratureRule& a, const QuadratureRule& b) {
    CHECK(a.known == b.known);
    CHECK(first_difference(a.weights, b.weights) == "");
    CHECK(first_difference(a.directions, b.directions) == "");
}

// The rule that the settings make of a random stream.
static QuadratureRule rule_from(const RenderSettings& s, Random& random) {
    const DirectionSet set = place_directions(s.placement, s.samples, random);
    return s.method == Method::mc ? monte_carlo_rule(set)
                                  : bayesian_rule(*s.make_covariance(), s.noise, set.directions);
}

TEST_CASE("methods have names") { CHECK(names_all<Method>(method_names)); }

TEST_CASE("a pixel's random stream has the number of the pixel, row after row") {
    RenderSettings settings = small_picture(Method::mc, 1, 1 << 17);
    settings.height = 70000;
    settings.seed = 5;
    CHECK(pixel_stream(settings, 3, 1 << 16).bits() == Random(5, (std::uint64_t{1} << 33) + 3).bits());
}

TEST_CASE("pixels share as many rules as the method says, rule i from stream 2^63 + i") {
    for (const auto& [method_name, method] : named<Method>(method_names))
        for (const auto& [placement_name, placement] : named<Placement>(placement_names)) {
            RenderSettings settings = small_picture(method, 15, 12, placement);
            settings.seed = 3;
            const PixelRules rules(settings);
            std::size_t count = method == Method::pool ? 3 : 1;
            if (method == Method::direct || (method == Method::mc && !is_lattice(placement))) count = 0;
            const std::string names = method_name + std::string(" ") + placement_name;  // an INFO cannot name the pairs
            INFO(names);
            REQUIRE(rules.shared().size() == count);
            for (std::size_t i = 0; i < count; ++i) {
                Random random(3, (std::uint64_t{1} << 63) + i);
                check_equal(*rules.shared()[i], cosine_rule(rule_from(settings, random)));
            }
        }
}

TEST_CASE("a pixel has a fresh rule, a shared one, a turned one, or a chosen and turned one") {
    const Vec3 normal = normalize({0.3, -0.5, 0.8});
    for (const auto& [method_name, method] : named<Method>(method_names))
        for (const Placement placement : {Placement::uniform, Placement::cosine_fibonacci})
            for (std::uint64_t pixel = 0; pixel < 9; ++pixel) {
                const PixelRules rules(small_picture(method, 5, 12, placement, Known::cosine));
                Random drawn(1, pixel), here(1, pixel);
                const OrientedRule oriented = rules.rule_for(normal, drawn);
                Frame frame(normal);
                const std::string name = method_name;
                INFO(name);
                if (rules.shared().empty()) {
                    check_equal(*oriented.rule, cosine_rule(rule_from(rules.settings(), here)));
                } else {
                    const double u = method == Method::pool ? here.uniform() : 0;
                    if (method != Method::single) frame = frame.rotated(here.uniform());
                    CHECK(oriented.rule == rules.shared()[static_cast<std::size_t>(3 * u)]);
                }
                CHECK(oriented.frame.to_world({1, 2, 4}) == frame.to_world({1, 2, 4}));
                CHECK(drawn.bits() == here.bits());
            }
}

TEST_CASE("S is 1 for Monte Carlo, near 1 for rough covariances, far above for smooth ones") {
    const auto stability = [](const RenderSettings& settings) {
        return stability_constant(*PixelRules(settings).shared()[0]);
    };
    CHECK(std::fabs(stability(small_picture(Method::mc, 40, 12, Placement::cosine_fibonacci)) - 1) < 1e-14);
    for (const std::size_t samples : {5u, 10u, 40u, 160u})
        CHECK_MESSAGE(std::fabs(stability(small_picture(Method::pool, samples)) - 1) < 0.31, samples);
    RenderSettings smooth = small_picture(Method::pool, 85);
    smooth.covariance = CovarianceFamily::squared_exponential;
    CHECK(stability(smooth) < 1.31);  // noise 0.01
    smooth.noise = 0;
    CHECK(stability(smooth) > 20);
}
