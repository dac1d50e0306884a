#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <future>
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
}  // namespace bmc
