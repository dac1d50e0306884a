// What alone.cpp, alone_integral.cpp and alone_rules.cpp share. Each calls the functions of single tasks and prints
// what they give. Where that cannot be right a line on stderr says why: after "cause: ", or after the second argument
// in place of "cause", which no other program can know.
#pragma once

#if __has_include(<execinfo.h>)
#include <execinfo.h>
#endif
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

inline const char* cause_mark = "cause";

__attribute__((format(printf, 2, 3))) inline void explain_if(bool so, const char* format, ...) {
    if (!so) return;
    va_list values;
    va_start(values, format);
    std::fprintf(stderr, "%s: ", cause_mark);
    std::vfprintf(stderr, format, values);
    va_end(values);
    std::fputc('\n', stderr);
}

inline bool near(double a, double b) {
    return a == b || (std::isfinite(b) && std::fabs(a - b) <= 1e-3 * std::fabs(b) + 1e-9);
}

// What a case of a test is given by a mistake, perhaps in several ways, and the words for it.
struct Mistake {
    std::vector<double> values;
    std::string words;
};
using Mistakes = std::vector<Mistake>;

// What is right, for which there are no words; mistakes; and those of any number, with n things or a cosine in it.
inline Mistakes mistakes(double right, Mistakes own, double n = NAN, double cosine = NAN) {
    const double pi = std::acos(-1), sine = std::sqrt(1 - cosine * cosine);
    own.insert(own.begin(), {{right}, ""});
    const auto factor = [&](double value, const std::string& name) {
        own.push_back({{right * value}, " is multiplied by " + name + ", or not divided by it"});
        own.push_back({{right / value}, " is divided by " + name + ", or not multiplied by it"});
    };
    factor(cosine, "cos(theta)"), factor(sine, "the sine"), factor(1 - cosine, "1 - cos(theta)"), factor(n, "n"),
        factor(n * n, "n twice");
    factor(2 * pi / n, "2 pi / n"), factor(std::sqrt(n), "the root of n"), factor(2, "2"), factor(4, "4");
    factor(pi, "pi"), factor(2 * pi, "2 pi"), factor(4 * pi, "4 pi"), factor(pi * pi, "pi twice"),
        factor(4 * pi * pi, "2 pi twice");
    own.insert(own.end(), {{{right * n / (n - 1)}, " is divided by n - 1, not n"},
                           {{right * n / (n + 1)}, " is divided by n + 1, not n"},
                           {{0}, " is 0: is it set?"},
                           {{1}, " is 1"},
                           {{-right}, " has the other sign"},
                           {{std::fabs(right)}, " has lost its sign where it is below 0"},
                           {{std::max(0.0, right)}, " is 0 where it should be below 0"},
                           {{right * right}, " is squared"},
                           {{std::sqrt(right)}, " is a root of what it should be"},
                           {{1 / right}, " is 1 over what it should be"},
                           {{std::trunc(right)}, " is a whole number: an int?"}});
    return own;
}

// The same of a sum of so many terms.
inline Mistakes mistakes(const std::vector<double>& terms, Mistakes own, double scale = 1) {
    double sum = 0, even = 0, product = 1, whole = 0, size = 0, above = 0, squares = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const double term = terms[i];
        sum += term, product *= term, size += std::fabs(term), above += std::max(0.0, term), squares += term * term;
        even += i % 2 == 0 ? term : 0, whole = std::trunc(whole + term);
    }
    const double first = terms[0], last = terms.back(), largest = *std::max_element(terms.begin(), terms.end());
    const Mistake sums[] = {
        {{first, last}, " has its first or last term alone: return in the loop, or = in place of +=?"},
        {{sum - first, sum - last}, " lacks its first or its last term"},
        {{even, sum - even}, " has only every other term"},
        {{whole}, " is a sum of whole numbers: an int?"},
        {{above}, " lacks its terms below 0"},
        {{size}, " has terms that lost their sign"},
        {{largest, product}, " is the largest term, or the product of all"},
        {{squares, std::sqrt(squares)}, " has squares in place of terms"}};
    for (Mistake each : sums) {
        for (double& value : each.values) value *= scale;
        own.push_back(each);
    }
    return mistakes(scale * sum, own, static_cast<double>(terms.size()));
}

// Whether each case i was given what is right, the first of mistakes_of(i). If not, tells the mistake by which each is
// explained, with what this is about where the words begin with a space or a colon.
template <class MistakesOf>
bool explain(const std::string& about, const std::vector<double>& given, MistakesOf mistakes_of) {
    std::vector<Mistakes> all;
    while (all.size() < given.size()) all.push_back(mistakes_of(all.size()));
    for (std::size_t m = 0; m < all.at(0).size(); ++m)
        for (std::size_t way = 0, i; way < all[0][m].values.size(); ++way) {
            for (i = 0; i < given.size() && near(given[i], all[i][m].values[way]);) ++i;
            if (i < given.size()) continue;
            const std::string& words = all[0][m].words;
            explain_if(m > 0, "%s%s", words.find_first_of(" :") == 0 ? about.c_str() : "", words.c_str());
            return m == 0;
        }
    return false;
}

struct Task {
    const char* name;
    void (*print)();
};

// On stderr the addresses of the calls that have not ended: whoever has the program can tell their lines.
inline void end_by(int signal) {
#if __has_include(<execinfo.h>)
    void* calls[64];
    backtrace_symbols_fd(calls, backtrace(calls, 64), 2);
#endif
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

inline int call(int argc, char** argv, std::initializer_list<Task> tasks) {
    for (const int signal : {SIGABRT, SIGSEGV, SIGALRM, SIGXCPU}) std::signal(signal, end_by);
    if (argc == 3)
        cause_mark = argv[2];  // and who gives it limits the time
    else
        alarm(30);  // the limit of a processor's time ends no program that sleeps
    try {
        for (const Task& task : tasks)
            if (argc >= 2 && std::strcmp(argv[1], task.name) == 0) return task.print(), 0;
    } catch (const std::exception& error) {
        explain_if(true, "%s", error.what());
        return 1;
    }
    std::fprintf(stderr, "usage: %s TASK [MARK]\n", argv[0]);
    return 2;
}
