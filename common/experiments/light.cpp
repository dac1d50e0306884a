#include "experiments/light.h"

#include "scene/desert.h"
#include "scene/radiance_hdr.h"

std::string LightFile::report() const {
    require_file_output("./workbench light > desert.hdr");
    return to_radiance_hdr(built_in_environment());
}
