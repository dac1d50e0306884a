// What alone.cpp, alone_integral.cpp and alone_rules.cpp share. Each calls the functions of single tasks and prints
// what they give. Where that cannot be right a line on stderr says why: after "cause: ", or after the second argument
// in place of "cause", which no other program can know.
#pragma once

#include <unistd.h>

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <exception>
#include <initializer_list>

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

inline bool near(double a, double b) { return std::fabs(a - b) <= 1e-3 * std::fabs(b) + 1e-9; }

// A value that a mistake gives, and what the mistake is.
struct Mistake {
    double value;
    const char* words;
};

// Which mistake gives the value, if one does.
inline void explain(double value, std::initializer_list<Mistake> mistakes) {
    for (const Mistake& mistake : mistakes) explain_if(near(value, mistake.value), "%s", mistake.words);
}

struct Task {
    const char* name;
    void (*print)();
};

inline int call(int argc, char** argv, std::initializer_list<Task> tasks) {
    if (argc == 3)
        cause_mark = argv[2];  // and who gives it limits the time
    else
        alarm(4);  // a processor's time is no limit for a program that sleeps
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
