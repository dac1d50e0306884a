#include "experiments/samples.h"

#include "base/formatted.h"
#include "quadrature/model.h"

#include <istream>
#include <sstream>
#include <stdexcept>

namespace bmc {
static std::runtime_error error_in(std::size_t line, const std::string& problem) {
    return std::runtime_error(formatted("line %zu: ", line) + problem);
}

// The numbers of a line, without its comment.
static std::vector<double> columns_of(const std::string& line, std::size_t number) {
    std::istringstream words(line.substr(0, line.find('#')));
    words.exceptions(std::ios::badbit);  // a lack of memory does not end the line
    std::vector<double> columns;
    for (std::string word; words >> word;) {
        char* end = nullptr;
        columns.push_back(std::strtod(word.c_str(), &end));
        if (end != word.c_str() + word.size())
            throw error_in(number,
                           formatted("'%s' is not a number such as -0.5, with a hyphen and a point; plain blanks "
                                     "stand between columns, and # begins a comment",
                                     word.c_str()));
        if (!std::isfinite(columns.back())) throw error_in(number, "'" + word + "' is not finite");
    }
    return columns;
}

// Adds what stands in a line.
static void add_line(Samples& samples, const std::string& line, std::size_t number) {
    const std::vector<double> columns = columns_of(line, number);
    const std::size_t n = columns.size();
    if (n == 0) return;
    if (n != 3 && n != 4) throw error_in(number, formatted("expected x y z or x y z value, not %zu columns", n));
    const Vec3 omega{columns[0], columns[1], columns[2]};
    if (!(std::fabs(length(omega) - 1) <= 1e-6))
        throw error_in(number, formatted("the direction has the length %.9g; divide x, y and z by it", length(omega)));
    if (omega.y < 0) throw error_in(number, formatted("y = %g is below the horizon; directions have y >= 0", omega.y));
    if (samples.directions.size() == max_process_samples) throw error_in(number, "at most 4096 directions are allowed");
    if (!samples.directions.empty() && (n == 3) != samples.values.empty())
        throw error_in(number, formatted("%zu columns, where earlier lines have %zu", n, 7 - n));
    samples.directions.push_back(omega);
    if (n == 4) samples.values.push_back(columns[3]);
}

Samples read_samples(std::istream& in) {
    in.exceptions(std::ios::badbit);  // an error of reading does not end the file
    Samples samples;
    char line[4096];
    std::size_t number = 1;
    for (; in.getline(line, sizeof line) && number < 65536; ++number) {
        std::string text(line, static_cast<std::size_t>(in.gcount()) - !in.eof());
        if (number == 1 && text.compare(0, 3, "\xef\xbb\xbf") == 0) text.erase(0, 3);  // a byte order mark
        add_line(samples, text, number);
    }
    if (!in.fail() || !in.eof())  // a line too many, or a longer one
        throw error_in(number, "fewer than 65536 lines of fewer than 4096 characters are allowed");
    if (samples.directions.empty()) throw std::runtime_error("there is no direction in the file");
    return samples;
}
}  // namespace bmc
