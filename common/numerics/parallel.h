// Rows of a picture, computed by several threads.
#pragma once

#include <atomic>
#include <future>
#include <system_error>
#include <vector>

namespace bmc {
// Calls row(y) once for every y from 0 to rows - 1, in any order, on at most this number of threads. An exception of a
// call ends the work of all and reaches the caller.
template <class Row>
void for_each_row(int rows, unsigned threads, Row row) {
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
