#include "base/terminal.h"

#include <unistd.h>

#include <cctype>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace bmc {
static const auto program_start = std::chrono::steady_clock::now();
static std::size_t open_phases = 0, shown_phases = 0;
static int columns = 0;  // of the line that is shown

static double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A line can be written again, unless stderr is a file, or a terminal that cannot go back (TERM=dumb: an editor's).
static bool can_go_back() {
    const char* const kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) && !(kind && std::string_view(kind) == "dumb");
}

static void clear_line() {
    if (columns > 0) std::fprintf(stderr, "\r%*s\r", columns, "");
    columns = 0;
}

// After Ctrl-C the shell's prompt begins a line of its own.
static void end_line(int signal) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, "\n", 1);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

Progress::Progress(const std::string& phase, std::size_t parts)
    : inside_another_(open_phases++ > 0), phase_(phase), parts_(parts) {}

Progress::~Progress() {
    --open_phases;
    if (!inside_another_) clear_line();
}

void Progress::done() {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    const std::size_t percent = 100 * ++done_ / parts_;
    if (inside_another_ || percent == percent_ || seconds_since(program_start) < 1 || !can_go_back()) return;
    if (percent_ == 0) ++shown_phases;
    percent_ = percent;
    const double left = seconds_since(start_) / static_cast<double>(done_) * static_cast<double>(parts_ - done_);
    clear_line();
    columns = std::fprintf(stderr, "%zu. %s: %zu %%, %.0f s left", shown_phases, phase_.c_str(), percent, left);
    std::signal(SIGINT, end_line);
}

// Nothing here allocates: the problem may be a lack of memory.
void print_note(std::string_view text) {
    clear_line();
    std::fprintf(stderr, "%s: ", program_name);
    for (const char c : text) std::fputc(std::iscntrl(static_cast<unsigned char>(c)) ? '?' : c, stderr);
    std::fputc('\n', stderr);
}
}  // namespace bmc
