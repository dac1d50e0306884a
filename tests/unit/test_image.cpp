#include "scene/image.h"

#include "test.h"

TEST_CASE("PPM: header, rows from the top, sRGB bytes, clamped") {
    Image image(2, 2);
    image.set(0, 0, {0, 1, 0.5});
    image.set(1, 0, {-3, 7, 0.0031308});
    image.set(1, 1, {std::nan(""), 0.0001, 1e-30});
    const std::string ppm = to_ppm(image);
    // 0.5 encodes to 187.5160, 0.0031308 to 12.92 * 0.0031308 * 255 = 10.31, 0.0001 to 0.33; what is no number is
    // black.
    const unsigned char pixels[] = {0, 255, 188, 0, 255, 10, 0, 0, 0, 0, 0, 0};
    CHECK(ppm == "P6\n2 2\n255\n" + std::string(reinterpret_cast<const char*>(pixels), sizeof pixels));
}

TEST_CASE("PPM: a byte begins where the sRGB code is half a unit below it") {
    Image image(2, 1);
    for (int byte = 1; byte < 256; ++byte) {
        const double code = (byte - 0.5) / 255;
        const double begin = code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
        // The image rounds to floats, by 6e-8 at most.
        image.set(0, 0, {begin * (1 - 1e-7), 0, 0});
        image.set(1, 0, {begin * (1 + 1e-7), 0, 0});
        const std::string ppm = to_ppm(image);
        CHECK(static_cast<unsigned char>(ppm[ppm.size() - 6]) == byte - 1);
        CHECK(static_cast<unsigned char>(ppm[ppm.size() - 3]) == byte);
    }
}

TEST_CASE("PFM: header, rows from the bottom, little-endian floats as they are") {
    Image image(1, 2);
    image.set(0, 0, {1, 0, -2});
    image.set(0, 1, {0.5, 1e30, 0});
    const unsigned char pixels[] = {0, 0, 0,    0x3f, 0xca, 0xf2, 0x49, 0x71, 0, 0, 0, 0,
                                    0, 0, 0x80, 0x3f, 0,    0,    0,    0,    0, 0, 0, 0xc0};
    CHECK(to_pfm(image) == "PF\n1 2\n-1.0\n" + std::string(reinterpret_cast<const char*>(pixels), sizeof pixels));
}
