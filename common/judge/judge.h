// Whether a picture of the sphere scene that another program made is right.
#pragma once

#include "options.h"

struct Judge {
    std::string file;         // the picture; "-": standard input
    std::string environment;  // empty: the built-in one
    RenderSettings correct;   // what correct programs would do

    std::vector<Option> options();
    Outcome report() const;  // exit status 0: within what correct programs do; 1: not
};
