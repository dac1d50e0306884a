// Pictures of three channels a pixel that a program wrote: PPM (P6) with codes up to 255, and PFM (PF).
#pragma once

#include "scene/image.h"

#include <optional>

struct Picture {
    bmc::Format format;
    std::string header;  // in one line
    bmc::Image values;   // codes or floats, as they stand in the file
};

// The picture that these bytes are; none if they are no complete one. Memory follows what the file holds, not what its
// header claims.
std::optional<Picture> parse_picture(const std::string& bytes);

// Its linear light; PPM is coded as IEC 61966-2-1 says.
bmc::Image linear_light(const Picture& picture);
