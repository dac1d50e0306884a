// libFuzzer: any bytes are a picture, a map of radiances or rows of numbers, or an error of one line.
#include "../course/judge/picture_file.h"
#include "experiments/rule.h"
#include "light/radiance_hdr.h"

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

using namespace bmc;

namespace {

template <class Read>
void check(const std::string& bytes, Read read) {
    std::istringstream in(bytes);
    try {
        if (!read(in)) std::abort();
    } catch (const std::runtime_error& error) {
        const std::string text = error.what();
        if (text.empty() || text.find('\n') != std::string::npos) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::string text(bytes, bytes + size);
    check(text, [](std::istream& in) {
        const PictureFile picture = read_picture(in);
        const Color corner = picture.image(picture.image.width() - 1, picture.image.height() - 1);
        return picture.maxval == 0 ? corner.x - corner.x == 0 : corner.x >= 0 && corner.x <= 1;
    });
    check(text, [](std::istream& in) {
        const Color corner = read_radiance_hdr(in).radiance({0, -1, 0});
        return corner.x >= 0 && corner.y >= 0 && corner.z >= 0;
    });
    check(text, [](std::istream& in) {
        const Samples samples = read_samples(in);
        return !samples.directions.empty() &&
               (samples.values.empty() || samples.values.size() == samples.directions.size());
    });
    return 0;
}
