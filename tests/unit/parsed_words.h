// What the options leave of a program's arguments.
#pragma once

#include "command_line.h"

#include <getopt.h>

inline std::vector<std::string> parse(std::vector<std::string> words, const std::vector<Option>& options) {
    words.insert(words.begin(), "program");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    optind = 0;  // a fresh scan
    return parse_options(static_cast<int>(words.size()), argv.data(), options);
}
