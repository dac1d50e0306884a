// What the renderer is asked for beyond the practice: a light that is known, and errors that are predicted.
#pragma once

#include "beyond/prediction/prediction.h"
#include "scene/picture_request.h"

namespace bmc::beyond {
// What a file shows of each point: the light that it reflects, or the error predicted for that light.
enum class Show { picture, error };
constexpr const char* show_names[] = {"picture", "error"};

struct Request : PictureRequest {
    bool by_visibility = false;  // of the integrand L(omega) v(omega) cos(theta), beside the cosine
    Show show = Show::picture;
    double rmse = 0;  // the predicted RMSE to reach; 0: the number of samples is given

    void add_options(Options& options) override;

    // What the file shows. Prints the prediction on stderr. Throws std::runtime_error if an RMSE takes too many
    // samples.
    Image image(const EnvironmentMap& map) const override;
};
}  // namespace bmc::beyond
