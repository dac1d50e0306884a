#include "base/terminal.h"

#include "base/formatted.h"

#include <unistd.h>
#ifndef _WIN32
#include <sys/ioctl.h>
#endif

#include <chrono>
#include <cstdlib>
#include <mutex>

namespace bmc {
using Clock = std::chrono::steady_clock;

static Clock::time_point start;  // of the outermost calculation
static bool running = false;
static std::string shown;  // the end of what the terminal has

static std::size_t columns_of_terminal() {
#ifdef TIOCGWINSZ
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
#endif
    return 80;
}

// A line can be written again, unless stderr is a file, or a terminal that cannot go back (TERM=dumb: an editor's).
static bool can_go_back() {
    const char* const kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) && !(kind && std::string_view(kind) == "dumb");
}

static void show(const std::string& text) {
    if (text == shown) return;
    std::fprintf(stderr, "\r%*s\r%s", static_cast<int>(shown.size()), "", text.c_str());
    shown = text;
}

Progress::Progress(double parts) : parts_(parts), outermost_(!running) {
    if (outermost_) start = Clock::now();
    running = true;
}

Progress::~Progress() {
    if (!outermost_) return;
    show("");
    running = false;
}

void Progress::done(double parts) {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    const double fraction = (done_ += parts) / parts_;
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    if (!outermost_ || seconds < 1 || !can_go_back()) return;
    const double left = fraction < 1 ? seconds / fraction - seconds : 0;
    show(formatted("%.0f %%, %.0f s left", 100 * fraction, left).substr(0, columns_of_terminal() - 1));
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
        const bool of_utf8 = i > 0 && text[i - 1] == '\xc2' && byte >= 0x80 && byte < 0xa0;  // U+0080 to U+009F
        line[count++] = byte < ' ' || byte == 0x7f || of_utf8 ? '?' : text[i];
    }
    show("");
    std::fprintf(stderr, "%s: %.*s\n", program_name, static_cast<int>(count), line);
}
}  // namespace bmc
