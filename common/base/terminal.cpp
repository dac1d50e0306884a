#include "base/terminal.h"

#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#elif __has_include(<unistd.h>)
#include <fcntl.h>
#include <unistd.h>
#endif

#include <cstdlib>
#include <string_view>

namespace bmc {
#ifdef _WIN32
bool output_is_terminal() { return _isatty(1); }
bool is_in_foreground() { return _isatty(2); }
void keep_all_bytes() {
    for (const int stream : {0, 1}) _setmode(stream, _O_BINARY);
}
#elif __has_include(<unistd.h>)
bool output_is_terminal() { return isatty(STDOUT_FILENO); }
bool is_in_foreground() {
    const char* const kind = std::getenv("TERM");
    return tcgetpgrp(STDERR_FILENO) == getpgrp() && !(kind && std::string_view(kind) == "dumb");  // has no way back
}
void keep_all_bytes() { fcntl(STDOUT_FILENO, F_SETFL, fcntl(STDOUT_FILENO, F_GETFL) & ~O_NONBLOCK); }
#else
bool output_is_terminal() { return false; }
bool is_in_foreground() { return false; }
void keep_all_bytes() {}
#endif
}  // namespace bmc
