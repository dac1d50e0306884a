#include "numerics/parallel.h"

#include <atomic>
#include <future>
#include <system_error>
#include <vector>

namespace bmc {
void for_each_row(int rows, unsigned threads, const std::function<void(int)>& row, const Progress& progress) {
    std::atomic<int> next{0}, done{0};
    const auto work = [&](const Progress& tell) {
        try {
            for (int y; (y = next++) < rows;) {
                row(y);
                if (const int now = ++done; tell && now < rows) tell(static_cast<double>(now) / rows);
            }
        } catch (...) {
            next = rows;  // no thread begins another row
            throw;
        }
    };
    std::vector<std::future<void>> helpers;
    try {
        for (unsigned i = 1; i < threads; ++i) helpers.push_back(std::async(std::launch::async, work, nullptr));
    } catch (const std::system_error&) {  // the system starts no more threads: those that run do all
    }
    work(progress);
    for (std::future<void>& helper : helpers) helper.get();
    if (progress) progress(1);
}
}  // namespace bmc
