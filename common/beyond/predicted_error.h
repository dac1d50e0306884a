// The error of a picture, without the truth: its distance from a better picture, which has four times the samples with
// equal weights on the cosine lattice, and rays of its own to the sun. If both errors are independent, and e and e' are
// their root mean squares, the mean of (A - B)^2 is
//     e^2 + e'^2,  with e' <= e / 2 if the error falls at least as fast as that of Monte Carlo.
// So a predicted error is usually up to 12 % too large, and more where four times the samples help little: at worst
// 24 % in 950 settings under 17 lights, of which others were up to 21 % too small. Nothing of the picture goes into the
// better one: no covariance, no noise, no shared rule, no random number. So a bias shows, and so does a sun that no
// sample meets. If the light is known, the better picture knows it, too.
#pragma once

#include "beyond/known_light.h"

namespace bmc::beyond {
// The shader by the samples of these settings, with equal weights on the cosine lattice, and by this number of rays to
// the texels of more than four times the mean (sun.h). Nothing is from a table of the light.
Shader sun_shader(const EnvironmentMap& map, RenderSettings settings, std::size_t rays);

// The shader of the better picture. The environment must outlive it where light_shader needs it.
Shader better_shader(const EnvironmentLight& light, RenderSettings settings);

// The root mean square of picture - better around each pixel, colour by colour, over a window as far as that shows the
// same object; 0 where no object is. Windows grow with the picture, from 7 x 7 pixels to 15 x 15 from 490 rows on, so
// that large pictures of errors are smooth.
Image predicted_errors(const Image& picture, const Image& better);

// The root mean square over all colours of the pixels that show an object; 0 where none does.
double root_mean_square(const Image& errors);
}  // namespace bmc::beyond
