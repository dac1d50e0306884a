#include "quadrature/closed_forms.h"
#include "quadrature/hemisphere.h"

namespace bmc {
// As k is 8/3 - r, a direction that moves lowers V by 2 w (what z gains + w times what its distances to the others
// gain). Each direction in turn tries random moves, shorter from sweep to sweep, and makes those that lower V.
std::vector<Vec3> optimised_directions(std::size_t n, KnownPart p) {
    constexpr double sweeps = 50;
    const double w = known_integral(p) / static_cast<double>(n), reach = 2.4 / std::sqrt(static_cast<double>(n));
    const auto z = [p](double y) { return (p == KnownPart::cosine ? sobolev_cosine_z : sobolev_z)(std::min(y, 1.0)); };
    std::vector<Vec3> directions = fibonacci_directions(n, p);
    Random random(0, n);
    for (double sweep = 0; sweep < sweeps; ++sweep)
        for (Vec3& from : directions) {
            Vec3 to = from;
            for (double* each : {&to.x, &to.y, &to.z}) *each += reach * (1 - sweep / sweeps) * (random.uniform() - 0.5);
            to = normalize(to);
            to.y = std::fabs(to.y);
            double farther = -length(to - from);  // which the sum counts, too
            for (const Vec3& other : directions) farther += length(to - other) - length(from - other);
            if (z(to.y) + w * farther > z(from.y)) from = to;
        }
    return directions;
}
}  // namespace bmc
