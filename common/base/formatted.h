// Text with numbers in it.
#pragma once

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace bmc {
// The text that printf would print. The attribute lets a compiler compare the arguments with the format.
#if defined(__GNUC__) && !defined(__MINGW32__)
__attribute__((format(printf, 1, 2)))
#endif
inline std::string
formatted(const char* format, ...) {
    va_list arguments, same;
    va_start(arguments, format);
    va_copy(same, arguments);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, arguments)), ' ');
    std::vsnprintf(text.data(), text.size() + 1, format, same);
    va_end(same);
    va_end(arguments);
    return text;
}

// A number of at least 1, rounded to two digits for a reader: 110000, 2e+79.
inline std::string two_digits(double number) {
    return formatted("%.9g", std::floor(std::strtod(formatted("%.1e", number).c_str(), nullptr) + 0.5));
}

// "mc, direct or pool".
inline std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
    return text;
}

// An enumeration stands beside an array of its names, in the order of the enumerators, which options and reports read.
template <class T, std::size_t count>
const char* name_of(T value, const char* const (&names)[count]) {
    return names[static_cast<std::size_t>(value)];
}
}  // namespace bmc
