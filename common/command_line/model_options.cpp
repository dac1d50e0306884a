#include "command_line/model_options.h"

namespace bmc {
void add_model_options(Options& options, ModelSettings& s) {
    options.add("covariance", covariance_names, s.covariance);
    options.add("smoothness", "X", "of sobolev, between 1 and 2", s.smoothness, min_smoothness, max_smoothness);
    options.add("length-scale", "X", "of the other covariances, from 0.05", s.length_scale, min_length_scale,
                max_length_scale);
    options.add("noise", "X", "standard deviation of sample errors, relative to f's amplitude", s.noise, 0, 1000);
    options.add(choice("known", {std::begin(known_part_names), std::end(known_part_names)}, 0, known_remark,
                       [&s](std::size_t chosen) { s.known_part = static_cast<KnownPart>(chosen); }));
    std::vector<std::string> placements;
    for (const Placement placement : all_placements()) placements.push_back(placement.name());
    options.add(
        choice("placement", placements, 0, "", [&s](std::size_t chosen) { s.placement = all_placements()[chosen]; }));
    options.add("seed", "K", "seed of the random numbers", s.seed, 0, UINT64_MAX);
    const auto is_sobolev = [&s] { return s.covariance == CovarianceFamily::sobolev; };
    options.make_idle({"length-scale"}, "with --covariance sobolev", is_sobolev);
    options.make_idle({"smoothness"}, "without --covariance sobolev", [=] { return !is_sobolev(); });
}

void add_sample_list(Options& options, std::vector<std::size_t>& samples) {
    std::string usual;
    for (const std::size_t n : samples) usual += (usual.empty() ? "" : ",") + std::to_string(n);
    options.add({"samples", "LIST", "numbers of samples (default " + usual + ")", [&samples](const std::string& text) {
                     samples.clear();
                     for (std::size_t begin = 0, end = 0; end < text.size(); begin = end + 1) {
                         end = std::min(text.find(',', begin), text.size());
                         samples.push_back(parse(text.substr(begin, end - begin), std::size_t{1}, max_process_samples));
                     }
                 }});
}
}  // namespace bmc
