// What the renderer is asked for beyond the practice: a light that is known, and errors that are predicted.
#pragma once

#include "beyond/predicted_error.h"
#include "scene/picture_request.h"

namespace bmc::beyond {
// What a file shows of each point: the light that it reflects, or the error predicted for that light.
enum class Show { picture, error };
inline constexpr const char* show_names[] = {"picture", "error"};

struct Request : PictureRequest {
    bool light_known = false;  // of the integrand L(omega) v(omega) cos(theta), beside the cosine
    Show show = Show::picture;

    bool is_plain() const { return !light_known && show == Show::picture; }  // one of the practice's

    void add_options(Options& options) override;
    void advise(const EnvironmentMap& map) const override;

    // What the file shows. Prints the RMSE of predicted errors on stderr.
    Image image(const EnvironmentMap& map) const override;
};
}  // namespace bmc::beyond
