// What a report says in numbers.
#pragma once

#include <sstream>
#include <string>
#include <vector>

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
