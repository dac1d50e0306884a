#include "base/terminal.h"

#include <cstdlib>
#include <string_view>

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

#else

bool bmc::output_is_terminal() { return false; }
bool bmc::is_in_foreground() { return false; }
void bmc::keep_all_bytes() {}

#endif
