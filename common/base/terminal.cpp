#include "base/terminal.h"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace bmc {
using Clock = std::chrono::steady_clock;

static const Clock::time_point start = Clock::now();
static Progress* innermost = nullptr;
static int shown = 0;  // per cent, the most so far

// A line can be written again, unless stderr is a file, or a terminal that cannot go back (TERM=dumb: an editor's).
static bool can_go_back() {
    const char* const kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) && !(kind && std::string_view(kind) == "dumb");
}

static void clear_line() {
    if (shown > 0) std::fputs("\r     \r", stderr);
}

Progress::Progress(std::size_t parts) : outer_(innermost), parts_(parts) { innermost = this; }

Progress::~Progress() {
    innermost = outer_;
    if (!outer_) clear_line();
}

void Progress::done() {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    if (Clock::now() - start < std::chrono::seconds(1)) {
        --parts_;
        return;
    }
    ++done_;
    double fraction = 0;
    for (const Progress* each = innermost; each; each = each->outer_)
        fraction = (static_cast<double>(each->done_) + fraction) / static_cast<double>(each->parts_);
    const int percent = static_cast<int>(100 * fraction);
    if (percent <= shown || !can_go_back()) return;
    shown = percent;
    std::fprintf(stderr, "\r%d %%", shown);
}

// Nothing here allocates: the problem may be a lack of memory.
void print_note(std::string_view text) {
    constexpr std::size_t most = 300;  // at either end
    char line[2 * most + 8];
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text.size() > 2 * most && i == most) {
            for (const char* dots = " ... "; *dots; ++dots) line[count++] = *dots;
            i = text.size() - most;
        }
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool is_control = i > 0 && text[i - 1] == '\xc2' && byte >= 0x80 && byte < 0xa0;  // U+0080 to U+009F
        line[count++] = byte < ' ' || byte == 0x7f || is_control ? '?' : text[i];
    }
    clear_line();
    std::fprintf(stderr, "%s: %.*s\n", program_name, static_cast<int>(count), line);
}
}  // namespace bmc
