#include "base/terminal.h"

#include <unistd.h>

#include <cctype>
#include <chrono>
#include <cstdio>
#include <mutex>

namespace bmc {
static int columns = 0;  // of the line that is shown

static void clear_line() {
    if (columns > 0) std::fprintf(stderr, "\r%*s\r", columns, "");
    columns = 0;
}

static double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Progress::Progress(const std::string& phase, std::size_t parts) : phase_(phase), parts_(parts), start_(seconds()) {}

Progress::~Progress() { clear_line(); }

void Progress::done() {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    const std::size_t percent = 100 * ++done_ / parts_;
    const double spent = seconds() - start_;
    if (percent == percent_ || spent < 1 || !isatty(STDERR_FILENO)) return;
    percent_ = percent;
    const double left = spent / static_cast<double>(done_) * static_cast<double>(parts_ - done_);
    clear_line();
    columns = std::fprintf(stderr, "%s: %zu %%, %.0f s left", phase_.c_str(), percent, left);
}

// Nothing here allocates: the problem may be a lack of memory.
void print_note(std::string_view text) {
    clear_line();
    std::fprintf(stderr, "%s: ", program_name);
    for (const char c : text) std::fputc(std::iscntrl(static_cast<unsigned char>(c)) ? '?' : c, stderr);
    std::fputc('\n', stderr);
}
}  // namespace bmc
