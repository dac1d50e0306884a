// Whether a picture of the sphere scene, made by whatever program with whatever random numbers, is what a correct one
// makes: its fingerprint beside those of correct pictures with other seeds.
#pragma once

#include "fingerprint.h"
#include "picture_file.h"

namespace bmc {
// What is expected of pictures in one kind of file.
struct Expected {
    PictureSettings settings;
    int maxval;
    Accepted accepted;
    Truth truths[2];  // not clamped; the background interpolated, as here, or of single texels, as in the practice
    const EnvironmentMap* environment;
    std::vector<Fingerprint> correct;

    bool serves(const PictureFile& file) const {
        return maxval == file.maxval && settings.width == file.image.width() && settings.height == file.image.height();
    }
};

// For files like this picture's, under a light that must outlive it, by programs with these settings, whose size and
// seed are not used. Throws std::invalid_argument if too few pixels show an object, or the environment lights none.
Expected expect(const EnvironmentLight& light, PictureSettings settings, const PictureFile& picture,
                const Progress& progress = nullptr);

struct Judgement {
    Comparison comparison;  // first "background", the fraction of its pixels that differ
    BlockError block;
    std::string reason;  // of a wrong picture: its cause, or where it errs most; empty if neither is sure
};
Judgement judge(const PictureFile& picture, const Expected& expected);
}  // namespace bmc
