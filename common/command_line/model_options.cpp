#include "command_line/model_options.h"

namespace bmc {
Options model_options(ModelSettings& s) {
    return model_options(s, enum_option("known", known_names, s.known, known_remark));
}

Options model_options(ModelSettings& s, const Option& known) {
    return {enum_option("covariance", covariance_names, s.covariance),
            real_option("smoothness", "of sobolev, between 1 and 2 (default 1.5)", s.smoothness, 1.001, 1.999),
            real_option("length-scale", "of squared-exponential, from 0.05 (default 1)", s.length_scale, 0.05, 1e6),
            real_option("noise", "standard deviation of a sample's error over the amplitude (default 0.01)", s.noise, 0,
                        1000),
            known,
            enum_option("placement", placement_names, s.placement),
            {"seed", "K", "seed of the random numbers (default 1)",
             [&s](const std::string& text) { s.seed = parse_integer(text, 0, UINT64_MAX); }}};
}
}  // namespace bmc
