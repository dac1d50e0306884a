#include "base/progress.h"

#include "base/formatted.h"
#include "base/terminal.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace bmc {
std::size_t processors() {
    return std::max(1u, std::thread::hardware_concurrency());  // 0 if it is not known
}

void for_each_row(int rows, std::size_t threads, const std::function<void(int y)>& row) {
    std::atomic<int> next{0};
    const auto take_rows = [&] {
        try {
            for (int y; (y = next++) < rows;) row(y);
        } catch (...) {
            next = rows;  // no thread begins another row
            throw;
        }
    };
    std::vector<std::future<void>> helpers;
    try {
        for (std::size_t i = 1; i < threads; ++i) helpers.push_back(std::async(std::launch::async, take_rows));
    } catch (const std::system_error&) {  // the system starts no more threads: those that run do all
    }
    take_rows();
    for (std::future<void>& helper : helpers) helper.get();
}

static double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Progress::Progress(const std::string& phase, std::size_t parts) : phase_(phase), parts_(parts), start_(seconds()) {}

Progress::~Progress() { show_line(""); }

void Progress::done() {
    static std::mutex mutex;
    const std::lock_guard<std::mutex> lock(mutex);
    ++done_;
    const double spent = seconds() - start_;
    if (spent < shown_ + 1 || !is_in_foreground()) return;
    shown_ = spent;
    const double left = spent / static_cast<double>(done_) * static_cast<double>(parts_ - done_);
    show_line(formatted("%s: %zu %%, %.0f s left", phase_.c_str(), 100 * done_ / parts_, left));
}
}  // namespace bmc
