#include "command_line/model_options.h"

#include <sstream>

namespace bmc {
Options model_options(ModelSettings& s) {
    Options all{enum_option("covariance", covariance_names, s.covariance),
                real_option("smoothness", "of sobolev, between 1 and 2 (default 1.5)", s.smoothness, 1.001, 1.999),
                real_option("length-scale", "of squared-exponential, from 0.05 (default 1)", s.length_scale, 0.05, 1e6),
                real_option("noise", "standard deviation of a sample's error over the amplitude (default 0.01)",
                            s.noise, 0, 1000),
                enum_option("known", known_names, s.known, known_remark),
                enum_option("placement", placement_names, s.placement),
                {"seed", "K", "seed of the random numbers (default 1)",
                 [&s](const std::string& text) { s.seed = parse_integer(text, 0, UINT64_MAX); }}};
    make_idle(all, {s.covariance == CovarianceFamily::sobolev ? "length-scale" : "smoothness"},
              std::string("--covariance ") + name_of(s.covariance, covariance_names));
    return all;
}

Option sample_list_option(std::vector<std::size_t>& samples) {
    std::string usual;
    for (const std::size_t n : samples) usual += (usual.empty() ? "" : ",") + std::to_string(n);
    return {"samples", "LIST", "numbers of samples (default " + usual + ")", [&samples](const std::string& text) {
                samples.clear();
                std::istringstream words(text + ',');
                for (std::string word; std::getline(words, word, ',');)
                    samples.push_back(static_cast<std::size_t>(parse_integer(word, 1, max_process_samples)));
            }};
}
}  // namespace bmc
