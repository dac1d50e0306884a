#include "numerics/parallel.h"

#include <atomic>
#include <future>
#include <system_error>
#include <vector>

namespace bmc {
void for_each_row(int rows, unsigned threads, const std::function<void(int)>& row) {
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
        for (unsigned i = 1; i < threads; ++i) helpers.push_back(std::async(std::launch::async, work));
    } catch (const std::system_error&) {  // the system starts no more threads: those that run do all
    }
    work();
    for (std::future<void>& helper : helpers) helper.get();
}
}  // namespace bmc
