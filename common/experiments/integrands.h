// Functions over the hemisphere whose integrals are known: what the experiments estimate.
#pragma once

#include "quadrature/quadrature.h"
#include "scene/environment.h"

#include <functional>
#include <string>
#include <vector>

// A function over the hemisphere and its integral w.r.t. solid angle.
struct Integrand {
    std::string name;
    std::string formula;
    std::function<double(Vec3)> value;
    double truth;
};

// The practice's integrands: 1, cos(theta), cos(theta)^3, and the built-in environment's luminance times cos(theta)
// above a tilted surface, whose truth is a dense quadrature.
std::vector<Integrand> practice_integrands();

// Incident luminance times cos(theta), shadows included, at five points of the sphere scene in the built-in
// environment: three on the sphere, two on the rectangle.
std::vector<Integrand> scene_integrands();

// The unknown factor of the integrand at each direction: its value over the known part.
std::vector<double> sample(const Integrand& integrand, const std::vector<Vec3>& directions,
                           KnownPart known = KnownPart::nothing);

// The rule's estimate of the integral.
double apply(const QuadratureRule& rule, const Integrand& integrand);

// The directions of estimate number e with n samples: the same in every experiment with this placement and seed, so
// that what they compare differs by method and not by luck.
DirectionSet estimate_directions(const ModelSettings& settings, std::size_t n, std::size_t e);
