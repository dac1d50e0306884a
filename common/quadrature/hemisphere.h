// Directions in the unit hemisphere H around the up axis y, and frames that carry them to a surface. Integrals are with
// respect to solid angle. A direction's elevation cosine, cos(theta), is its y.
#pragma once

#include "numerics/random.h"
#include "numerics/vec3.h"

#include <cstddef>
#include <vector>

namespace bmc {
// n independent directions, uniform w.r.t. solid angle (density 1 / 2 pi), by Archimedes' theorem: the elevation cosine
// is uniform in (0, 1]. Draws the cosine first, then the azimuth.
std::vector<Vec3> uniform_directions(std::size_t n, Random& random);

// n directions on the spherical Fibonacci lattice: elevation cosines 1 - (i + 1/2) / n, azimuths i golden angles
// (Marques, Bouville, Ribardiere, Santos & Bouatouch, "Spherical Fibonacci point sets for illumination integrals",
// Computer Graphics Forum 2013, eq. 2).
std::vector<Vec3> fibonacci_directions(std::size_t n);

// n independent directions with density cos(theta) / pi w.r.t. solid angle: elevation cosine sqrt(u) (Malley's method).
std::vector<Vec3> cosine_directions(std::size_t n, Random& random);

// The Fibonacci lattice with the elevation cosines sqrt(1 - (i + 1/2) / n): its density is cos(theta) / pi.
std::vector<Vec3> cosine_fibonacci_directions(std::size_t n);

// The direction turned about the up axis by an angle in turns (1 turn = 2 pi radians), from z towards x.
Vec3 rotate_around_y(Vec3 direction, double turns);

// A right-handed orthonormal basis whose up axis is a surface normal: to_world carries (0, 1, 0) to the normal.
struct Frame {
    Vec3 tangent, normal, bitangent;

    // The frame of a unit normal. It is continuous except where normal.z changes its sign. The formulas are the
    // paper's, and dot products show that they are right (Duff, Burgess, Christensen, Hery, Kensler, Liani & Villemin,
    // "Building an orthonormal basis, revisited", JCGT 2017).
    explicit Frame(Vec3 unit_normal);

    // The frame whose to_world(v) is this frame's to_world(rotate_around_y(v, turns)).
    [[nodiscard]] Frame rotated(double turns) const;

    Vec3 to_world(Vec3 local) const { return local.x * tangent + local.y * normal + local.z * bitangent; }
};
}  // namespace bmc
