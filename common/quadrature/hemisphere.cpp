#include "quadrature/hemisphere.h"

namespace bmc {
// The azimuth is 0 at +z, and a quarter turn at +x.
static inline Vec3 direction_at(double u, double turns, Density density) {
    const double cos_theta = density == Density::cosine ? std::sqrt(u) : u;
    const double sin_theta = std::sqrt((1 - cos_theta) * (1 + cos_theta));  // sqrt(1 - cos^2), exact near 1
    const portable::SineCosine azimuth = portable::sincos_turns(turns);
    return {sin_theta * azimuth.sine, cos_theta, sin_theta * azimuth.cosine};
}

std::vector<Vec3> random_directions(std::size_t n, Random& random, Density density) {
    std::vector<double> u(n), turns(n);
    for (std::size_t i = 0; i < n; ++i) {
        u[i] = 1 - random.uniform();
        turns[i] = random.uniform();
    }
    std::vector<Vec3> directions(n);  // a loop without draws, which a processor computes for several at once
    for (std::size_t i = 0; i < n; ++i) directions[i] = direction_at(u[i], turns[i], density);
    return directions;
}

std::vector<Vec3> stratified_directions(std::size_t n, Random& random, Density density) {
    const auto rows = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)) / 2 + 0.5);
    const double rotation = random.uniform();
    std::vector<Vec3> directions;
    for (std::size_t row = 1; row <= rows; ++row) {
        const std::size_t end = row * n / rows;  // of the row's cells
        const double cells = static_cast<double>(end - directions.size());
        for (double cell = 0; directions.size() < end; ++cell) {
            const double height = static_cast<double>(end) - cells * random.uniform();  // in n-ths, above 0
            const double across = cell + random.uniform();
            directions.push_back(direction_at(height / static_cast<double>(n), rotation + across / cells, density));
        }
    }
    return directions;
}

std::vector<Vec3> fibonacci_directions(std::size_t n, Density density) {
    constexpr double golden = 0.61803398874989484820;  // 1 / golden ratio: the golden angle in turns
    std::vector<Vec3> directions(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double index = static_cast<double>(i);
        directions[i] = direction_at(1 - (index + 0.5) / static_cast<double>(n), index * golden, density);
    }
    return directions;
}

// As k is 8/3 - r, V falls as the distances between the directions grow. Each direction in turn tries another azimuth,
// nearer from sweep to sweep, and keeps it if the sum of the distances grows.
std::vector<Vec3> optimised_directions(std::size_t n, Density density) {
    constexpr int sweeps = 50;
    std::vector<Vec3> directions = fibonacci_directions(n, density);
    Random random(0, n);
    for (int sweep = sweeps; sweep > 0; --sweep)
        for (Vec3& from : directions) {
            const Vec3 to = rotate_around_y(from, (random.uniform() - 0.5) * sweep / sweeps);
            double farther = -length(to - from);  // from the others; the sum counts the place that it leaves, too
            for (const Vec3& other : directions) farther += length(to - other) - length(from - other);
            if (farther > 0) from = to;
        }
    return directions;
}

// BEGIN SOLUTION rotate
Vec3 rotate_around_y(Vec3 direction, double turns) {
    const auto [sine, cosine] = portable::sincos_turns(turns);
    return {cosine * direction.x + sine * direction.z, direction.y, cosine * direction.z - sine * direction.x};
}
// END SOLUTION

Frame::Frame(Vec3 unit_normal) : normal(unit_normal) {
    const double sign = normal.z < 0 ? -1 : 1;
    const double a = -1 / (sign + normal.z), b = normal.x * normal.y * a;
    tangent = {b, sign + normal.y * normal.y * a, -normal.y};
    bitangent = {1 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
}

// BEGIN SOLUTION rotate
// to_world is linear: rotating a local direction about y rotates the axes that its x and z are multiplied by.
Frame Frame::rotated(double turns) const {
    const auto [sine, cosine] = portable::sincos_turns(turns);
    Frame frame = *this;
    frame.tangent = cosine * tangent - sine * bitangent;
    frame.bitangent = sine * tangent + cosine * bitangent;
    return frame;
}
// END SOLUTION
}  // namespace bmc
