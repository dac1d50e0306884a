// judge PICTURE [the renderer's options]: whether a picture of the sphere scene is right, by a program with other
// random numbers. Four kinds of numbers are compared with those of eight pictures by this project: how much of the
// background differs and, of each object, the size of the errors, their mean in each channel, and how alike neighbours
// err. It prints what differs, by how many standard deviations and where, and no cause. Exit status: 0 right, 1
// different, 2 it cannot be judged.
#include "base/portable_math.h"

#include "../output/picture.h"
#include "base/input.h"
#include "base/statistics.h"
#include "scene/picture_request.h"

#include <algorithm>
#include <iterator>
#include <map>

using namespace bmc;

namespace {

constexpr std::size_t correct_pictures = 8;
constexpr std::uint64_t first_seed = 1000000;  // away from those that pictures to be judged are made with
constexpr double background_share = 0.002;     // of its pixels may differ

struct Number {
    std::string name;
    double value;
    double least;  // what counts as a standard deviation at least: correct programs differ in frames and roundings, too
    double free = 0;  // a difference that does not count
};

// The step of the codes of a .hdr picture, which shares one exponent between three bytes: 2^-8 of the power of 2 above
// the largest channel. Programs truncate or round to it; another picture has no step.
double step_of(bool hdr, Colour colour) {
    int exponent = 0;
    std::frexp(std::max({colour.x, colour.y, colour.z}), &exponent);
    return hdr ? std::ldexp(1, exponent - 8) : 0;
}

// The linear light of an image that has been written to a file and read.
Image stored(Image image, const PictureRequest& request) {
    const double factor = request.format == Format::ppm ? portable::pow(2, request.exposure) : 1;
    for (Colour& pixel : image.pixels) pixel = factor * pixel;
    return linear_light(parse_picture(encode(image, request.format)));
}

Image rendered(const EnvironmentMap& light, const PictureRequest& request) {
    const PixelRules rules(request.settings);
    return stored(render(light, request.settings, environment_shader(light, rules)), request);
}

// Whether two colours differ by at most two codes of a PPM, or a step.
bool looks_like(Colour here, Colour right, double step) {
    const auto near = [step](double a, double b) { return std::fabs(a - b) <= 0.002 + 0.02 * b + step; };
    return near(here.x, right.x) && near(here.y, right.y) && near(here.z, right.z);
}

// A line if too many pixels without an object differ. They may show the light as this project does, or the
// texel that the ray meets: smaller than a pixel, one is as good as the other.
std::string background_difference(const Image& picture, bool hdr, const Image& truth, const EnvironmentMap& light,
                                  const PictureRequest& request) {
    const Camera camera{picture.width, picture.height};
    Image texels(picture.width, picture.height);
    std::vector<std::pair<int, int>> differing;
    double all = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) texels(x, y) = light.radiance(camera.ray(x, y).direction);
    texels = stored(texels, request);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (intersect(sphere_scene, camera.ray(x, y))) continue;
            all += 1;
            const double step = step_of(hdr, truth(x, y));
            if (!looks_like(picture(x, y), truth(x, y), step) && !looks_like(picture(x, y), texels(x, y), step))
                differing.push_back({x, y});
        }
    const double count = static_cast<double>(differing.size());
    if (count <= background_share * all) return "";
    return formatted("background: %.3g %% of its pixels differ, %.3g %% may; the first is in column %d of row %d\n",
                     100 * count / all, 100 * background_share, differing[0].first, differing[0].second);
}

using Errors = std::map<std::pair<int, int>, double>;  // of the pixels (x, y) of an object

// The correlation of errors that are this many columns and rows apart.
double correlation(const Errors& errors, int columns, int rows) {
    double products = 0, squares = 0;
    for (const auto& [pixel, error] : errors) {
        const auto other = errors.find({pixel.first + columns, pixel.second + rows});
        if (other == errors.end()) continue;
        products += error * other->second;
        squares += (error * error + other->second * other->second) / 2;
    }
    return squares > 0 ? products / squares : 0;
}

std::vector<Number> numbers_of(const Image& picture, bool hdr, const Image& truth, bool one_rule) {
    struct Pixel {
        int x, y;
        Colour error, right;
    };
    std::map<Object, std::vector<Pixel>> objects;
    for_each_hit(sphere_scene, {truth.width, truth.height}, [&](int x, int y, const Hit& hit) {
        objects[hit.object].push_back({x, y, picture(x, y) - truth(x, y), truth(x, y)});
    });
    const auto mean = [](double error, double right) { return error / std::max(right, 1e-9); };
    const double least = one_rule ? 0.05 : 0.03;  // one rule for all pixels: few errors are independent
    std::vector<Number> all;
    for (const auto& [object, pixels] : objects) {
        const int number = static_cast<int>(object);
        const std::string name = number == 0   ? "sphere, "
                                 : number == 1 ? "rectangle, "
                                               : formatted("object %d, ", number);
        Statistics size;  // of errors; their squares would depend on a few pixels under a bright sun
        Colour sum, light;
        double steps = 0;
        for (const Pixel& each : pixels) {
            sum += each.error;
            light += each.right;
            steps += step_of(hdr, each.right);
            for (const double error : {each.error.x, each.error.y, each.error.z}) size.add(std::fabs(error));
        }
        const double brightness = mean(sum.x + sum.y + sum.z, light.x + light.y + light.z);
        Errors errors;  // but for their mean, which neighbours share
        for (const Pixel& each : pixels)
            errors[{each.x, each.y}] = dot(each.error - brightness * each.right, {1, 1, 1});
        all.insert(all.end(), {{name + "log of error size", portable::log(std::max(size.mean, 1e-9)), 0.02},
                               {name + "mean error, red", mean(sum.x, light.x), 0.004, mean(steps / 2, light.x)},
                               {name + "mean error, green", mean(sum.y, light.y), 0.004, mean(steps / 2, light.y)},
                               {name + "mean error, blue", mean(sum.z, light.z), 0.004, mean(steps / 2, light.z)},
                               {name + "correlation in rows", correlation(errors, 1, 0), least},
                               {name + "correlation in columns", correlation(errors, 0, 1), least},
                               {name + "correlation down right", correlation(errors, 1, 1), least},
                               {name + "correlation down left", correlation(errors, -1, 1), least}});
    }
    return all;
}

// A line for each number that is more than `most` deviations away from those of correct pictures.
std::string number_differences(const std::vector<Number>& numbers, const std::vector<std::vector<Number>>& correct,
                               double most) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        Statistics statistics;
        for (const std::vector<Number>& each : correct) statistics.add(each[i].value);
        // Of the difference of one number more from the mean of these.
        const double spread = statistics.standard_error() * std::sqrt(statistics.count + 1);
        const double difference = numbers[i].value - statistics.mean;
        const double deviations = std::copysign(std::max(0.0, std::fabs(difference) - numbers[i].free), difference) /
                                  std::max(spread, numbers[i].least);
        if (std::fabs(deviations) <= most) continue;
        text += formatted("%-34s %+9.3f %+10.3f %+12.1f", numbers[i].name.c_str(), numbers[i].value, statistics.mean,
                          deviations);
        if (numbers[i].name.find("log") != std::string::npos)
            text += formatted("   (errors are %.2f of what they should be)",
                              portable::exp(numbers[i].value - statistics.mean));
        text += '\n';
    }
    return text;
}

std::string differences(const std::string& file, const EnvironmentMap& light, PictureRequest& request) {
    const Picture found = read_file(file, [](std::istream& in) {
        return parse_picture({std::istreambuf_iterator<char>(in), {}});
    });
    const Image picture = linear_light(found);
    if (std::min(picture.width, picture.height) < 40)
        throw std::runtime_error(file + ": too small to be judged; it takes at least 40x40 pixels");
    for (int i = 0; i < picture.width * picture.height; ++i)
        if (!std::isfinite(dot(picture(i, 0), {1, 1, 1})))
            return formatted("no finite number in column %d of row %d\n", i % picture.width, i / picture.width);
    request.format = found.format;
    RenderSettings& settings = request.settings;
    settings.width = picture.width, settings.height = picture.height;
    PictureRequest exact = request;  // nearly without noise
    exact.settings.method = Method::mc, exact.settings.placement = cosine_lattice, exact.settings.samples = 2000;
    const Image truth = rendered(light, exact);
    const bool hdr = found.header.find(".hdr") == 0, one_rule = PixelRules(settings).shared.size() == 1;
    std::vector<std::vector<Number>> correct;
    for (settings.seed = first_seed; correct.size() < correct_pictures; ++settings.seed)
        correct.push_back(numbers_of(rendered(light, request), hdr, truth, one_rule));
    // Numbers of pictures by one rule have longer tails, which eight draws hardly show.
    const std::string text = number_differences(numbers_of(picture, hdr, truth, one_rule), correct, one_rule ? 8 : 6);
    return background_difference(picture, hdr, truth, light, request) +
           (text.empty() ? "" : "number                                  here   expected   deviations\n" + text);
}

// Sets the exit status to 1 if the picture differs.
std::string run(int argc, char** argv, int& status) {
    PictureRequest request;
    bool help = false;
    Options options = request.options();
    options.add("help", "prints this text", help);
    parse_options(argc, argv, options);
    if (help)
        return "usage: build/judge PICTURE [options]     a PPM, PFM or .hdr of the sphere scene\n\n"
               "The options say how the picture was made; --size, --format and --seed do not count.\n\n" +
               describe(options);
    if (argc - optind != 1) throw std::invalid_argument("name one picture, as in build/judge out.ppm --method direct");
    request.require_possible();
    const std::string file = argv[optind];
    const EnvironmentMap light = load_environment(request.environment, request.settings.threads);
    const std::string text = differences(file, light, request);
    if (text.empty()) return file + ": right, as far as a picture shows\n";
    status = 1;
    return file + ": differs from correct pictures\n" + text;
}

}  // namespace

int main(int argc, char** argv) {
    int status = 0;
    return run_program("judge", [&] { return run(argc, argv, status); }) == 0 ? status : 2;
}
