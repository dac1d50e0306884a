// k and z of one number.
#pragma once

#include "quadrature/covariance.h"

inline double k_of(const Covariance& covariance, double squared_chord) {
    covariance.covariances(&squared_chord, 1);
    return squared_chord;
}

inline double z_of(const Covariance& covariance, double cos_theta, KnownPart known = KnownPart::nothing) {
    std::vector<double> one{cos_theta};
    covariance.hemisphere_integrals(one, known);
    return one[0];
}
