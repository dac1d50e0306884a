// Text with numbers in it.
#pragma once

#include <cstdio>
#include <string>

namespace bmc {
// The text that printf would print, cut after 319 characters.
template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments) {
    char text[320];
    std::snprintf(text, sizeof text, format, arguments...);
    return text;
}
}  // namespace bmc
