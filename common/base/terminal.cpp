#include "base/terminal.h"

#include <cctype>
#include <cstdio>
#include <cstdlib>

#ifdef _WIN32

#include <fcntl.h>
#include <io.h>
bool bmc::output_is_terminal() { return _isatty(1); }
bool bmc::is_in_foreground() { return _isatty(2); }
void bmc::keep_all_bytes() { _setmode(0, _O_BINARY), _setmode(1, _O_BINARY); }

#elif __has_include(<unistd.h>)

#include <fcntl.h>
#include <unistd.h>
bool bmc::output_is_terminal() { return isatty(STDOUT_FILENO); }
bool bmc::is_in_foreground() {
    const char* const kind = std::getenv("TERM");
    return tcgetpgrp(STDERR_FILENO) == getpgrp() && !(kind && std::string_view(kind) == "dumb");  // has no way back
}
void bmc::keep_all_bytes() { fcntl(STDOUT_FILENO, F_SETFL, fcntl(STDOUT_FILENO, F_GETFL) & ~O_NONBLOCK); }

#else  // ask nothing
bool bmc::output_is_terminal() { return false; }
bool bmc::is_in_foreground() { return false; }
void bmc::keep_all_bytes() {}

#endif

namespace bmc {
void show_line(std::string_view text) {
    static int columns = 0;  // of the line that is shown
    if (columns > 0) std::fprintf(stderr, "\r%*s\r", columns, "");
    columns = std::fprintf(stderr, "%.*s", static_cast<int>(text.size()), text.data());
}

// Nothing here allocates: the problem may be a lack of memory.
void print_note(std::string_view text) {
    show_line("");
    std::fprintf(stderr, "%s: ", program_name);
    for (const char c : text) std::fputc(std::iscntrl(static_cast<unsigned char>(c)) ? '?' : c, stderr);
    std::fputc('\n', stderr);
}
}  // namespace bmc
