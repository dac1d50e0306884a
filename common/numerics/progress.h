// How far long work is: a stage has so many parts, and within another stage it makes up `share` of the other's parts.
// From one second until the outermost stage ends, a terminal shows "renderer: 43 %, 12 s left" (standard error).
#pragma once

#include "numerics/formatted.h"

#include <unistd.h>

#include <chrono>
#include <mutex>

namespace bmc {
class Progress {
    double parts_, share_, done_ = 0;
    Progress* outer_ = innermost_;
    std::chrono::steady_clock::time_point start_ = outer_ ? outer_->start_ : std::chrono::steady_clock::now();
    inline static thread_local Progress* innermost_ = nullptr;
    inline static std::mutex mutex_;

public:
    inline static std::string program = "bmc", shown;  // shown: the end of what the terminal has
    explicit Progress(double parts, double share = 1) : parts_(parts), share_(share) { innermost_ = this; }
    ~Progress() {
        innermost_ = outer_;
        if (!outer_) show("");
    }
    static void show(const std::string& text) {  // in place of what is shown
        if (text != shown) std::fprintf(stderr, "\r%*s\r%s", static_cast<int>(shown.size()), "", text.c_str());
        shown = text;
    }
    void done(double parts = 1) {  // Any thread may call this.
        const std::lock_guard<std::mutex> lock(mutex_);
        double f = (done_ += parts) / parts_;  // the fraction of all work
        for (auto s = this; s->outer_; s = s->outer_) f = (s->outer_->done_ + s->share_ * f) / s->outer_->parts_;
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        if (seconds < 1 || !isatty(STDERR_FILENO)) return;
        show(formatted("%s: %.0f %%, %.0f s left", program.c_str(), 100 * f, seconds / f - seconds));
    }
};
}  // namespace bmc
