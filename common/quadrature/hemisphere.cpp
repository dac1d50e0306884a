#include "quadrature/hemisphere.h"

namespace bmc {
namespace {

Vec3 direction_at(double cos_theta, double turns) {
    const double sin_theta = std::sqrt((1 - cos_theta) * (1 + cos_theta));
    const portable::SineCosine azimuth = portable::sincos_turns(turns);
    return {sin_theta * azimuth.sine, cos_theta, sin_theta * azimuth.cosine};
}

// Both families take the elevation cosine to be a function of a number that is uniform in (0, 1].
template <class Elevation>
std::vector<Vec3> random_directions(std::size_t n, Random& random, Elevation cosine_of) {
    std::vector<Vec3> directions(n);
    for (Vec3& direction : directions) {
        const double u = 1 - random.uniform();
        const double turns = random.uniform();
        direction = direction_at(cosine_of(u), turns);
    }
    return directions;
}

template <class Elevation>
std::vector<Vec3> lattice_directions(std::size_t n, Elevation cosine_of) {
    constexpr double golden = 0.61803398874989484820;  // the golden ratio less 1
    std::vector<Vec3> directions(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double index = static_cast<double>(i);
        directions[i] = direction_at(cosine_of(1 - (index + 0.5) / static_cast<double>(n)), index * golden);
    }
    return directions;
}

double itself(double u) { return u; }
double root(double u) { return std::sqrt(u); }

}  // namespace

std::vector<Vec3> uniform_directions(std::size_t n, Random& random) { return random_directions(n, random, itself); }
std::vector<Vec3> fibonacci_directions(std::size_t n) { return lattice_directions(n, itself); }
std::vector<Vec3> cosine_directions(std::size_t n, Random& random) { return random_directions(n, random, root); }
std::vector<Vec3> cosine_fibonacci_directions(std::size_t n) { return lattice_directions(n, root); }

Vec3 rotate_around_y(Vec3 direction, double turns) {
    const auto [sine, cosine] = portable::sincos_turns(turns);
    return {cosine * direction.x + sine * direction.z, direction.y, cosine * direction.z - sine * direction.x};
}

Frame::Frame(Vec3 unit_normal) : normal(unit_normal) {
    const double sign = normal.z < 0 ? -1 : 1;
    const double a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
    tangent = {b, sign + normal.y * normal.y * a, -normal.y};
    bitangent = {1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
}

Frame Frame::rotated(double turns) const {
    const auto [sine, cosine] = portable::sincos_turns(turns);
    Frame frame = *this;
    frame.tangent = cosine * tangent - sine * bitangent;
    frame.bitangent = sine * tangent + cosine * bitangent;
    return frame;
}
}  // namespace bmc
