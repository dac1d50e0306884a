// smallbmc: Bayesian Monte Carlo in 99 lines. It renders spheres under a sky: the left half of the picture with Monte
// Carlo, the right half with Bayesian Monte Carlo. Both draw 40 directions in the same way. Only the weights differ.
//     g++ -O3 -std=c++17 common/smallbmc.cpp -o smallbmc && ./smallbmc > smallbmc.ppm
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

const int width = 600, height = 400, samples = 40;
const double pi = std::acos(-1.0);
std::mt19937 engine;
double uniform() { return engine() / 4294967296.0; }  // a random number, at least 0 and below 1

struct Vec { double x, y, z; };  // a point, a direction of length 1, or a colour
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double length(Vec a) { return std::sqrt(dot(a, a)); }
Vec unit(Vec a) { return 1 / length(a) * a; }
Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

// A direction around the y axis. Equal areas of the unit square become equal solid angles of the hemisphere.
Vec direction(double u, double v) {
    const double sine = std::sqrt(1 - u * u);
    return {sine * std::sin(2 * pi * v), u, sine * std::cos(2 * pi * v)};
}

// The prior covariance of what we see in two directions: the closer they are, the more alike we expect it to be.
double k(Vec a, Vec b) { return 8.0 / 3 - length(a - b); }
// The best weights solve Q w = z: Q holds the covariances of the samples, z those of each sample with the integral.
std::vector<double> weights(const std::vector<Vec>& omega) {
    const int n = omega.size();
    std::vector<std::vector<double>> q(n, std::vector<double>(n));
    std::vector<double> w(n);  // at first z, in the end the weights
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) q[i][j] = k(omega[i], omega[j]) + (i == j ? 1e-4 : 0);  // 1e-4 is noise^2
        for (int a = 0; a < 32; ++a)  // z_i, the integral of k(omega_i, .) over the hemisphere, is a sum over cells
            for (int b = 0; b < 32; ++b) w[i] += 2 * pi / 1024 * k(omega[i], direction((a + 0.5) / 32, (b + 0.5) / 32));
    }
    for (int m = 0; m < n; ++m)  // subtract multiples of row m from all other rows, until Q is diagonal
        for (int i = 0; i < n; ++i) {
            const double multiple = i == m ? 0 : q[i][m] / q[m][m];
            for (int j = m; j < n; ++j) q[i][j] -= multiple * q[m][j];
            w[i] -= multiple * w[m];
        }
    for (int i = 0; i < n; ++i) w[i] /= q[i][i];
    return w;
}

// The scene, listed from front to back: the first sphere of the list that a ray from the eye meets is the nearest.
struct Sphere { Vec centre, albedo; double radius; };
const Sphere scene[] = {{{-2.25, -0.9, -7.5}, {0.9, 0.4, 0.2}, 0.7}, {{2.25, -0.9, -7.5}, {0.9, 0.4, 0.2}, 0.7},
                        {{0, 0, -8}, {0.8, 0.8, 0.8}, 1.6}, {{0, -1e5 - 1.6, -8}, {0.3, 0.55, 0.3}, 1e5}};
double distance(const Sphere& sphere, Vec p, Vec d) {  // from p, in the direction d; 0 for a miss
    const Vec c = sphere.centre - p;
    const double along = dot(c, d), square = along * along - dot(c, c) + sphere.radius * sphere.radius;
    return along > 0 && square > 0 ? along - std::sqrt(square) : 0;
}
const Sphere* hit(Vec p, Vec d) {
    for (const Sphere& sphere : scene)
        if (distance(sphere, p, d) > 0) return &sphere;
    return nullptr;
}
Vec sky(Vec d) {  // bluer higher up, and brightest around a sun behind us, blurred by clouds
    const double blue = std::sqrt(std::fabs(d.y)), sun = std::exp(6 * dot(d, unit({0, 1, 1})) - 6);
    return Vec{0.9, 0.8, 0.65} + blue * Vec{-0.9, -0.6, 0.1} + sun * Vec{2.4, 1.9, 1.2};
}

int main() {
    struct Rule { std::vector<Vec> omega; std::vector<double> w; };
    std::vector<Rule> rules(20, {std::vector<Vec>(samples), {}});  // rotated together, directions keep their weights
    for (Rule& rule : rules) {
        for (Vec& o : rule.omega) { const double u = uniform(), v = uniform(); o = direction(u, v); }
        rule.w = weights(rule.omega);
    }
    std::printf("P3\n%d %d\n255\n", width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Vec eye{0, 0, 0}, ray = unit({x + 0.5 - width / 2, height / 2 - y - 0.5, -1.6 * height});
            const Sphere* sphere = hit(eye, ray);
            Vec colour = sphere ? Vec{0, 0, 0} : sky(ray);
            if (sphere) {
                const Vec p = eye + distance(*sphere, eye, ray) * ray, normal = unit(p - sphere->centre);
                const Rule& rule = rules[static_cast<int>(20 * uniform())];
                const double u = uniform(), v = uniform();  // a random rotation around the normal
                const Vec a = unit(cross(normal, direction(2 * u - 1, v))), b = cross(a, normal);
                for (int j = 0; j < samples; ++j) {
                    const Vec o = rule.omega[j], d = o.x * a + o.y * normal + o.z * b;
                    if (hit(p, d)) continue;  // the sky is hidden there
                    const double weight = x < width / 2 ? 2 * pi / samples : rule.w[j];  // the only difference
                    colour = colour + weight * o.y / pi * (sphere->albedo * sky(d));
                }
            }
            for (const double c : {colour.x, colour.y, colour.z})
                std::printf("%d\n", static_cast<int>(255 * std::pow(std::fmin(std::fmax(c, 0), 1), 1 / 2.2) + 0.5));
        }
}
