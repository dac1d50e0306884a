#include "scene/render_fast.h"

#include <algorithm>
#include <cstring>
#include <optional>

// What one turn of the loop that follows writes no other reads; clang sees so by itself or not at all.
#ifdef __clang__
#define INDEPENDENT
#else
#define INDEPENDENT _Pragma("GCC ivdep")
#endif

namespace {

// A texel and what follows it: one instruction loads and widens them where Double4{t[0], t[1], t[2], t[3]} stands.
typedef double Double4 __attribute__((vector_size(32)));
typedef int Mask __attribute__((vector_size(32)));

// The numbers that one instruction takes at most; loops begin at a multiple of them and run on to the next one, and
// what they write beyond the end is overwritten or not read.
constexpr std::size_t lanes = 8;
constexpr std::size_t padded(std::size_t n) { return (n + lanes - 1) / lanes * lanes; }

constexpr std::size_t most_rays = 1024, most_pixels = 64, least_pixels = 4;

// A pixel's rule, an array for each component.
struct Rule {
    std::vector<float> x, y, z;
    std::vector<double> weight;
    std::vector<int> columns, rows;
    std::vector<const float*> rgb;

    void assign(const PixelRule& pixel) {
        const std::size_t n = pixel.rule.size();
        for (std::vector<float>* component : {&x, &y, &z}) component->resize(padded(n));
        weight.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            x[i] = pixel.rule[i].direction.x;
            y[i] = pixel.rule[i].direction.y;
            z[i] = pixel.rule[i].direction.z;
            weight[i] = pixel.rule[i].weight;
        }
        if (pixel.caps.empty()) return;
        columns.resize(padded(n), 1);
        rows.resize(padded(n), 1);
        rgb.resize(n);
        for (std::size_t i = 0; i < n; ++i) {
            columns[i] = pixel.caps[i]->columns;
            rows[i] = pixel.caps[i]->rows;
            rgb[i] = pixel.caps[i]->rgb;
        }
    }
};

struct Pixel {
    int column;
    Color sun;  // its irradiance by a known sun
    Hit hit;
    Direction tangent{Vec3{}}, normal{Vec3{}}, bitangent{Vec3{}};
    const Rule* rule;
    bool shadowed;
    double sum[4], all[4];

    void set_frame(const Frame& frame) {
        tangent = Direction(frame.tangent);
        normal = Direction(frame.normal);
        bitangent = Direction(frame.bitangent);
    }
};

struct Rays {
    float x[most_rays + lanes], y[most_rays + lanes], z[most_rays + lanes];
    int visible[most_rays + lanes];  // all bits or none
    int texel[most_rays + lanes];
};

struct Block {
    std::size_t size = 0;
    Pixel pixel[most_pixels];
    Rule fresh[most_pixels];
    Rays rays;
};

template <class Shadow>
void find_rays(const Pixel& pixel, std::size_t begin, std::size_t n, Shadow shadow, Rays& rays, std::size_t at) {
    const float *a = pixel.rule->x.data() + begin, *b = pixel.rule->y.data() + begin, *c = pixel.rule->z.data() + begin;
    const Direction t = pixel.tangent, u = pixel.normal, v = pixel.bitangent;
    float *x = rays.x + at, *y = rays.y + at, *z = rays.z + at;
    int* visible = rays.visible + at;
    const std::size_t end = padded(n);
    INDEPENDENT
    for (std::size_t i = 0; i < end; ++i) {
        const float dx = a[i] * t.x + b[i] * u.x + c[i] * v.x;
        const float dy = a[i] * t.y + b[i] * u.y + c[i] * v.y;
        const float dz = a[i] * t.z + b[i] * u.z + c[i] * v.z;
        x[i] = dx;
        y[i] = dy;
        z[i] = dz;
        visible[i] = shadow(dx, dy, dz) ? 0 : -1;
    }
}

void find_rays(const Scene& scene, const Pixel& pixel, std::size_t begin, std::size_t n, Rays& rays, std::size_t at) {
    const Vec3 p = pixel.hit.point;
    if (pixel.hit.object == Object::rectangle) {
        const Vec3 offset = scene.sphere.centre - p;
        const Direction o(offset);
        const float excess = static_cast<float>(dot(offset, offset) - scene.sphere.radius * scene.sphere.radius);
        find_rays(
            pixel, begin, n,
            [=](float x, float y, float z) {
                const float ahead = o.x * x + o.y * y + o.z * z;
                return (ahead > 0) & (ahead * ahead > excess);
            },
            rays, at);
        return;
    }
    const Rectangle& r = scene.rectangle;
    const float towards = p.y < r.y ? 1 : -1, height = static_cast<float>(std::fabs(p.y - r.y));
    const float left = static_cast<float>(r.x_min - p.x), right = static_cast<float>(r.x_max - p.x);
    const float far = static_cast<float>(r.z_min - p.z), near = static_cast<float>(r.z_max - p.z);
    find_rays(
        pixel, begin, n,
        [=](float x, float y, float z) {
            const float approach = towards * y, across = height * x, along = height * z;
            return (approach > 0) & (across >= left * approach) & (across <= right * approach) &
                   (along >= far * approach) & (along <= near * approach);
        },
        rays, at);
}

class Rows {
public:
    Rows(const Scene& scene, const Light& light, const RenderSettings& settings, const PixelRules& rules)
        : samples_(rules.samples()),
          scene_(scene),
          environment_(light.environment()),
          averages_(settings.known == KnownPart::light ? &light.averages() : nullptr),
          settings_(settings),
          rules_(rules),
          shared_(rules.shared().size()) {
        for (std::size_t i = 0; i < shared_.size(); ++i) shared_[i].assign(*rules.shared()[i]);
    }

    void render(int y, Image& image) const {
        thread_local Block block;
        block.size = 0;  // an earlier row may have ended by an exception
        const Camera camera{settings_.width, settings_.height};
        const std::size_t pixels = std::clamp(most_rays / samples_, least_pixels, most_pixels);
        for (int x = 0; x < settings_.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const std::optional<Hit> hit = intersect(scene_, ray);
            if (!hit) {
                image.set(x, y, environment_.interpolated_radiance(ray.direction));
                continue;
            }
            block.pixel[block.size].column = x;
            block.pixel[block.size++].hit = *hit;
            if (block.size == pixels) finish(block, y, image);
        }
        finish(block, y, image);
    }

private:
    void place_rule(Pixel& pixel, Rule& fresh, int y) const {
        Random random = pixel_stream(settings_, pixel.column, y);
        const Hit& hit = pixel.hit;
        SunRays rays;
        if (shared_.empty()) {
            const PlacedRule placed = rules_.of(hit.normal, random);
            fresh.assign(*placed.rule);
            pixel.rule = &fresh;
            pixel.set_frame(placed.frame);
            rays = placed.sun;
        } else if (settings_.method == Method::single) {
            pixel.rule = &shared_[0];
            pixel.set_frame(Frame(hit.normal));
        } else {
            const double u = random.uniform();
            const double turns = random.uniform();
            const double count = settings_.method == Method::pool ? static_cast<double>(shared_.size()) : 0;
            pixel.rule = &shared_[static_cast<std::size_t>(u * count)];
            pixel.set_frame(Frame(hit.normal).rotated(turns));
        }
        if (!shared_.empty() && rules_.sun_samples() > 0) rays = {rules_.sun_samples(), random};
        if (averages_)
            pixel.sun = averages_->sun_irradiance(hit.normal) * visible_sun(scene_, *averages_, hit, rays).fraction;
    }

    void finish(Block& block, int y, Image& image) const {
        for (std::size_t p = 0; p < block.size; ++p) {
            Pixel& pixel = block.pixel[p];
            place_rule(pixel, block.fresh[p], y);
            for (int k = 0; k < 4; ++k) pixel.sum[k] = pixel.all[k] = 0;
            pixel.shadowed = false;
        }
        const std::size_t batch = block.size > 0 ? most_rays / block.size / lanes * lanes : 0;
        for (std::size_t begin = 0; begin < samples_ && block.size > 0; begin += batch) {
            const std::size_t n = std::min(batch, samples_ - begin);
            if (averages_)
                add_known_light(block, begin, n, begin + n == samples_);
            else
                add_light(block, begin, n);
        }
        Color sky;
        for (std::size_t p = 0; p < block.size; ++p) {
            const Pixel& pixel = block.pixel[p];
            const Vec3 normal = pixel.hit.normal, last = block.pixel[p > 0 ? p - 1 : 0].hit.normal;
            if (averages_ && (p == 0 || normal.x != last.x || normal.y != last.y || normal.z != last.z))
                sky = averages_->sky_irradiance(normal);
            const Color irradiance =
                averages_ ? sky * visible_sky(pixel) + pixel.sun : Color{pixel.sum[0], pixel.sum[1], pixel.sum[2]};
            image.set(pixel.column, y, 1 / portable::pi * (pixel.hit.albedo * irradiance));
        }
        block.size = 0;
    }

    void add_light(Block& block, std::size_t begin, std::size_t n) const {
        Rays& rays = block.rays;
        for (std::size_t p = 0; p < block.size; ++p) find_rays(scene_, block.pixel[p], begin, n, rays, p * n);
        find_texels(rays, block.size * n, environment_.grid(), 3 * environment_.width() * environment_.height());
        const float* texels = environment_.texels();
        for (std::size_t i = 0; i < block.size * n; ++i) __builtin_prefetch(texels + rays.texel[i]);
        std::size_t p = 0;
        for (; p + 4 <= block.size; p += 4) sum_light<4>(block, p, begin, n);
        for (; p < block.size; ++p) sum_light<1>(block, p, begin, n);
    }

    // Where no direction of a pixel is shadowed, all its light arrives, and no sum is needed.
    void add_known_light(Block& block, std::size_t begin, std::size_t n, bool last) const {
        Rays& rays = block.rays;
        Pixel* pixels[most_pixels];
        std::size_t count = 0;
        for (std::size_t p = 0; p < block.size; ++p) {
            Pixel& pixel = block.pixel[p];
            find_rays(scene_, pixel, begin, n, rays, count * n);
            int all = -1;
            for (std::size_t i = 0; i < n; ++i) all &= rays.visible[count * n + i];
            pixel.shadowed = pixel.shadowed || all == 0;
            if (pixel.shadowed || !last) pixels[count++] = &pixel;
        }
        for (std::size_t p = 0; p < count; ++p) find_cap_texels(*pixels[p]->rule, begin, n, rays, p * n);
        std::size_t p = 0;
        for (; p + 2 <= count; p += 2) sum_known_light<2>(block, pixels + p, p * n, begin, n);
        for (; p < count; ++p) sum_known_light<1>(block, pixels + p, p * n, begin, n);
    }

    static Color visible_sky(const Pixel& pixel) {
        if (!pixel.shadowed) return {1, 1, 1};
        const auto fraction = [&](int k) { return pixel.all[k] > 0 ? pixel.sum[k] / pixel.all[k] : 1; };
        return {fraction(0), fraction(1), fraction(2)};
    }

    static void find_cap_texels(const Rule& rule, std::size_t begin, std::size_t n, Rays& rays, std::size_t at) {
        const float *x = rays.x + at, *y = rays.y + at, *z = rays.z + at;
        const int *columns = rule.columns.data() + begin, *rows = rule.rows.data() + begin;
        int* texel = rays.texel + at;
        const std::size_t end = padded(n);
        INDEPENDENT
        for (std::size_t i = 0; i < end; ++i)
            texel[i] = 3 * TexelGrid(columns[i], rows[i]).texel_index(x[i], y[i], z[i]);
    }

    template <std::size_t together>
    static void sum_known_light(Block& block, Pixel** pixels, std::size_t at, std::size_t begin, std::size_t n) {
        Double4 sum[together], all[together];
        const double* weight[together];
        const int* visible = block.rays.visible + at;
        const int* texels = block.rays.texel + at;
        const float* const* rgb[together];
        for (std::size_t k = 0; k < together; ++k) {
            std::memcpy(&sum[k], pixels[k]->sum, sizeof sum[k]);
            std::memcpy(&all[k], pixels[k]->all, sizeof all[k]);
            weight[k] = pixels[k]->rule->weight.data() + begin;
            rgb[k] = pixels[k]->rule->rgb.data() + begin;
        }
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < together; ++k) {
                const float* t = rgb[k][i] + texels[k * n + i];
                const Double4 part = weight[k][i] * Double4{t[0], t[1], t[2], t[3]};
                all[k] += part;
                sum[k] += Double4(Mask(part) & (visible[k * n + i] - Mask{}));
            }
        for (std::size_t k = 0; k < together; ++k) {
            std::memcpy(pixels[k]->sum, &sum[k], sizeof sum[k]);
            std::memcpy(pixels[k]->all, &all[k], sizeof all[k]);
        }
    }

    static void find_texels(Rays& rays, std::size_t n, TexelGrid grid, int black) {
        const std::size_t end = padded(n);
        INDEPENDENT
        for (std::size_t i = 0; i < end; ++i) {
            const int texel = 3 * grid.texel_index(rays.x[i], rays.y[i], rays.z[i]);
            rays.texel[i] = rays.visible[i] ? texel : black;
        }
    }

    template <std::size_t together>
    void sum_light(Block& block, std::size_t p, std::size_t begin, std::size_t n) const {
        Double4 sum[together];
        const double* weight[together];
        const int* texel = block.rays.texel + p * n;
        const float* texels = environment_.texels();
        for (std::size_t k = 0; k < together; ++k) {
            std::memcpy(&sum[k], block.pixel[p + k].sum, sizeof sum[k]);
            weight[k] = block.pixel[p + k].rule->weight.data() + begin;
        }
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < together; ++k) {
                const float* t = texels + texel[k * n + i];
                sum[k] += weight[k][i] * Double4{t[0], t[1], t[2], t[3]};
            }
        for (std::size_t k = 0; k < together; ++k) std::memcpy(block.pixel[p + k].sum, &sum[k], sizeof sum[k]);
    }

    const std::size_t samples_;
    const Scene& scene_;
    const EnvironmentMap& environment_;
    const PrefilteredEnvironment* averages_;  // null unless the light is known
    const RenderSettings& settings_;
    const PixelRules& rules_;
    std::vector<Rule> shared_;
};

}  // namespace

RenderRow rows_fast(const Scene& scene, const Light& light, const RenderSettings& settings, const PixelRules& rules) {
    return [rows = Rows(scene, light, settings, rules)](int y, Image& image) { rows.render(y, image); };
}
