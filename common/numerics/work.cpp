#include "numerics/work.h"

#include "numerics/formatted.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <future>
#include <system_error>
#include <vector>

namespace bmc {
using Clock = std::chrono::steady_clock;

std::size_t processors() {
    return std::max(1u, std::thread::hardware_concurrency());  // 0 if it is not known
}

void for_each_row(int rows, std::size_t threads, const std::function<void(int y)>& row) {
    std::atomic<int> next{0};
    const auto work = [&] {
        try {
            for (int y; (y = next++) < rows;) row(y);
        } catch (...) {
            next = rows;  // no thread begins another row
            throw;
        }
    };
    std::vector<std::future<void>> helpers;
    try {
        for (std::size_t i = 1; i < threads; ++i) helpers.push_back(std::async(std::launch::async, work));
    } catch (const std::system_error&) {  // the system starts no more threads: those that run do all
    }
    work();
    for (std::future<void>& helper : helpers) helper.get();
}

double time_call(const std::function<void()>& action) {
    double fewest = 1e300;
    for (int runs = 0, calls = 1; runs < 4;) {
        const auto start = Clock::now();
        for (int i = 0; i < calls; ++i) action();
        const std::chrono::duration<double> seconds = Clock::now() - start;
        if (seconds.count() < 2e-3) {
            calls *= 2;
        } else {
            fewest = std::min(fewest, seconds.count() / calls);
            ++runs;
        }
    }
    return fewest;
}

static Clock::time_point start;  // of the outermost work
static bool running = false;
static std::string shown;  // the end of what the terminal has

// For Ctrl-C, so that no line stays in front of the prompt. A signal handler may call these functions.
static void erase_and_stop(int signal) {
    constexpr char blanks[] = "\r                              \r";
    if (write(STDERR_FILENO, blanks, sizeof blanks - 1) >= 0) std::signal(signal, SIG_DFL);
    std::raise(signal);
}

static void show(const std::string& text) {
    if (text == shown) return;
    if (shown.empty()) std::signal(SIGINT, erase_and_stop);
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
    if (!outermost_ || seconds < 1 || !isatty(STDERR_FILENO)) return;
    show(formatted("%.0f %%, %.0f s left", 100 * fraction, fraction < 1 ? seconds / fraction - seconds : 0));
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
