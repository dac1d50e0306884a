// How far long work is: from one second on a terminal shows "43 %, 12 s left" (standard error). Work inside other work
// is a part of the other, and shows nothing.
#pragma once

#include "numerics/formatted.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <mutex>
#include <utility>

namespace bmc {
class Progress {
    double parts_, done_ = 0;
    const bool outermost_ = !std::exchange(running_, true);
    const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    inline static bool running_ = false;
    inline static std::mutex mutex_;
    inline static std::string shown_;  // the end of what the terminal has

public:
    explicit Progress(double parts) : parts_(parts) {}
    ~Progress() {
        if (outermost_) show("");
        if (outermost_) running_ = false;
    }
    static void show(const std::string& text) {  // in place of what is shown
        if (text != shown_) std::fprintf(stderr, "\r%*s\r%s", static_cast<int>(shown_.size()), "", text.c_str());
        if (shown_.empty() && !text.empty()) std::signal(SIGINT, erase_and_stop);
        shown_ = text;
    }
    void done(double parts = 1) {  // Any thread may call this.
        const std::lock_guard<std::mutex> lock(mutex_);
        const double fraction = (done_ += parts) / parts_;
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        if (!outermost_ || seconds < 1 || !isatty(STDERR_FILENO)) return;
        const double left = fraction < 1 ? seconds / fraction - seconds : 0;
        show(formatted("%.0f %%, %.0f s left", 100 * fraction, left));
    }

private:
    static void erase_and_stop(int signal) {  // with what a signal handler may call
        constexpr char blanks[] = "\r                                \r";
        if (write(STDERR_FILENO, blanks, sizeof blanks - 1) >= 0) std::signal(signal, SIG_DFL);
        std::raise(signal);
    }
};
}  // namespace bmc
