// What the usual mistakes make of a picture, so that the one which a wrong picture shows can be named.
#pragma once

#include "experiments/picture_error.h"

#include <functional>
#include <string>

namespace bmc {
// A mistake explains a picture if `picture` is a correct picture of `truth`: the mistake is undone in the one or made
// in the other.
struct Explanation {
    std::string cause;
    Image picture;
    Truth truth;
};
using Consider = std::function<void(const Explanation&)>;

// Calls consider with the explanations that change the background too: pixels in the wrong place, colours, transfer
// functions. maxval is that of the picture's file.
void explain_whole(const Image& picture, const Truth& truth, int maxval, const Consider& consider);

// The same for those that change objects only, in pictures with so many samples a pixel.
void explain_objects(const Image& picture, const Truth& truth, const EnvironmentMap& environment, std::size_t samples,
                     const Consider& consider);
}  // namespace bmc
