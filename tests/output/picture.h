// Pictures that a program wrote: PPM (P6, and P3, its text form) with codes up to 255, PFM (PF), and Radiance (.hdr).
#pragma once

#include "scene/image.h"

struct Picture {
    bmc::Format format;  // ppm: codes; pfm: linear floats
    std::string header;  // in one line
    bmc::Image values;   // codes or floats, as they stand in the file
};

// The picture that these bytes are. One newline may follow it. Throws std::runtime_error that says what is wrong.
// Memory follows what the file holds, not what its header claims.
Picture parse_picture(const std::string& bytes);

// Its linear light; PPM is coded as IEC 61966-2-1 says.
bmc::Image linear_light(const Picture& picture);
