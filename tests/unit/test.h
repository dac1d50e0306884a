// What several tests use.
#pragma once

#include "command_line.h"
#include "experiments/picture_error.h"
#include "scene/desert.h"
#include "scene/render.h"

#include <doctest/doctest.h>
#include <getopt.h>

#include <sstream>

using namespace bmc;

// What the options leave of a program's arguments.
inline std::vector<std::string> parse(std::vector<std::string> words, const std::vector<Option>& options) {
    words.insert(words.begin(), "program");
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    optind = 0;  // a fresh scan
    return parse_options(static_cast<int>(words.size()), argv.data(), options);
}

// The rows of a report that are not comments, as words.
inline std::vector<std::vector<std::string>> rows_of(const std::string& report) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        rows.emplace_back();
        for (std::string word; words >> word;) rows.back().push_back(word);
    }
    return rows;
}

inline const Method all_methods[] = {Method::mc, Method::direct, Method::single, Method::rotated, Method::pool};

inline RenderSettings small(Method method, std::size_t samples = 40, int size = 40) {
    RenderSettings settings;
    settings.method = method;
    settings.samples = samples;
    settings.width = settings.height = size;
    return settings;
}

inline const EnvironmentMap desert = load_environment("desert");

// What pictures tend to: plain weights on a dense lattice.
inline Image dense_picture(const EnvironmentMap& environment, int size = 40) {
    RenderSettings settings = small(Method::mc, 20000, size);
    settings.placement = Placement::fibonacci;
    settings.threads = 2;
    return render(sphere_scene(), environment, settings);
}

inline ImageError error_of(const Image& image, const Image& truth) { return image_error(image, truth_of(truth)); }
