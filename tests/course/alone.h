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

inline bool near(double a, double b) { return std::isfinite(b) && std::fabs(a - b) <= 1e-3 * std::fabs(b) + 1e-9; }

// A mistake: what it makes of a case of a test, and the words for it; what is right has none.
template <class Case>
struct Mistake {
    double (*value)(const Case&);
    const char* words;
};

// Whether all that was given is right, which stands first. If not, tells the mistake by which all is explained.
template <class Case>
bool explain(const std::vector<Case>& cases, std::initializer_list<Mistake<Case>> mistakes) {
    for (const Mistake<Case>& mistake : mistakes) {
        const auto explains = [&](const Case& each) { return near(each.given, mistake.value(each)); };
        if (!std::all_of(cases.begin(), cases.end(), explains)) continue;
        if (mistake.words) explain_if(true, "%s", mistake.words);
        return !mistake.words;
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
