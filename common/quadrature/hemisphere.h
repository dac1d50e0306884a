// Directions in the unit hemisphere H around the up axis y, and frames that carry them to a surface. Integrals are with
// respect to solid angle. The cosine of a direction's angle theta to the up axis is its y.
#pragma once

#include "base/random.h"
#include "base/vec3.h"

#include <vector>

namespace bmc {
// Where directions are dense: uniform, 1 / (2 pi) everywhere, or in proportion to the cosine, cos(theta) / pi.
enum class Density { uniform, cosine };
inline constexpr const char* density_names[] = {"uniform", "cosine"};

// n independent directions. If the density is uniform, cos(theta) is u, uniform in (0, 1], and so is the azimuth
// (Archimedes). For the density cos(theta) / pi the cosine is sqrt(u), which is below c with the probability c^2
// (Malley's method). u is drawn first, then the azimuth.
std::vector<Vec3> random_directions(std::size_t n, Random& random, Density density = Density::uniform);

// n directions of this density: a random one in each of n cells of equal area, in about sqrt(n) / 2 rows of u, so that
// cells are about as high as they are wide on the hemisphere. Rows differ by at most one cell, and each is as high as
// its cells require (Cook, Porter & Carpenter, "Distributed ray tracing", SIGGRAPH 1984). All are rotated about the up
// axis by a random angle, which is drawn first.
std::vector<Vec3> stratified_directions(std::size_t n, Random& random, Density density = Density::uniform);

// n directions of this density on the spherical Fibonacci lattice: u = 1 - (i + 1/2) / n and azimuths of i golden
// angles (Marques, Bouville, Ribardiere, Santos & Bouatouch, "Spherical Fibonacci point sets for illumination
// integrals", Computer Graphics Forum 2013, eq. 2).
std::vector<Vec3> fibonacci_directions(std::size_t n, Density density = Density::uniform);

// n directions on which equal weights w, 2 pi or pi over n, have a small worst-case error for the covariance
// Sobolev 3/2 (covariance.h). Its square is V = zz - 2 w sum of z_i + w^2 sum of k(omega_i, omega_j). They come from
// the lattice by a fixed stream of random moves, in a time that grows as n^2: 4096 take seconds. Only azimuths move. If
// heights did, V would be a few per cent smaller, but a tenth of it, where n is 10, would be an error that all
// rotations of the set share, and pictures would be too bright or too dark. Of the lattice's heights it is below a
// hundredth.
std::vector<Vec3> optimised_directions(std::size_t n, Density density = Density::uniform);

// The direction rotated about the up axis by an angle in turns (1 turn = 2 pi radians), from z towards x.
Vec3 rotate_around_y(Vec3 direction, double turns);

// A right-handed orthonormal basis whose up axis is a surface normal: to_world carries (0, 1, 0) to the normal.
struct Frame {
    Vec3 tangent, normal, bitangent;

    // The frame of a unit normal, continuous except where normal.z changes sign. You can verify it with dot products
    // (Duff, Burgess, Christensen, Hery, Kensler, Liani & Villemin, "Building an orthonormal basis, revisited", 2017).
    explicit Frame(Vec3 unit_normal);

    // This frame rotated about its normal: the new to_world(v) is the old to_world(rotate_around_y(v, turns)).
    [[nodiscard]] Frame rotated(double turns) const;

    Vec3 to_world(Vec3 local) const { return local.x * tangent + local.y * normal + local.z * bitangent; }
};
}  // namespace bmc
