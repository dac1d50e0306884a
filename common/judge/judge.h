// Whether what another program made is right: a picture of the sphere scene, or an error table.
#pragma once

#include "options.h"

struct Judge {
    std::string file;         // the picture or table; "-": standard input
    std::string integrand;    // of the table; empty: the file is a picture
    std::string environment;  // empty: the built-in one
    RenderSettings correct;   // what correct programs would do

    std::vector<Option> options();
    Outcome report() const;  // exit status 0: within what correct programs do; 1: not

private:
    Outcome judge_picture_file() const;
    Outcome judge_table_file() const;
};
