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

inline const char *cause_mark = "cause", *function = "";  // the student's that is tried
inline std::string unexplained;                           // a line about what is wrong first without a known cause

__attribute__((format(printf, 2, 3))) inline void explain_if(bool so, const char* format, ...) {
    if (!so) return;
    va_list values;
    va_start(values, format);
    std::fprintf(stderr, "%s: %s: ", cause_mark, function);
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

// What a number may depend on, of which a mistake may have any power as a factor.
struct Quantity {
    std::string name;
    double value;
};
using Quantities = std::vector<Quantity>;

inline Quantities count(double n) { return {{"n", n}, {"(n-1)", n - 1}, {"(n+1)", n + 1}}; }

inline Quantities angle(double cosine, Quantities others = {}) {
    const Quantities own{{"cos(theta)", cosine},
                         {"the sine", std::sqrt(std::max(0.0, 1 - cosine * cosine))},
                         {"(1-cos(theta))", 1 - cosine},
                         {"theta", std::acos(std::min(1.0, cosine))}};
    others.insert(others.end(), own.begin(), own.end());
    return others;
}

// What is known of a case: mistakes, of which the first is none, and where it stands in a list of so many.
struct Case {
    Mistakes mistakes;
    Quantities quantities;
    std::size_t place = 1, of = 0;

    double right() const { return mistakes[0].values[0]; }
};

// What is right, for which there are no words; mistakes; and those of any number.
inline Case mistakes(double right, Mistakes own, Quantities quantities = {}, std::size_t place = 1,
                     std::size_t of = 0) {
    own.insert(own.begin(), {{right}, ""});
    own.insert(own.end(), {{{0}, " is 0: is it set?"},
                           {{1}, " is 1"},
                           {{HUGE_VAL, -HUGE_VAL}, " is infinite: a division by 0?"},
                           {{-right}, " has the other sign"},
                           {{std::fabs(right)}, " has lost its sign where it is below 0"},
                           {{std::max(0.0, right)}, " is 0 where it should be below 0"},
                           {{right * right}, " is squared"},
                           {{std::sqrt(right)}, " is a root of what it should be"},
                           {{1 / right}, " is 1 over what it should be"},
                           {{std::trunc(right)}, " is a whole number: an int?"}});
    return {own, std::move(quantities), place, of};
}

// The same of a sum of so many terms.
inline Case mistakes(const std::vector<double>& terms, Mistakes own, Quantities quantities = {}, double scale = 1) {
    double sum = 0, whole = 0, size = 0, above = 0, squares = 0;
    for (const double term : terms) {
        sum += term, size += std::fabs(term), above += std::max(0.0, term), squares += term * term;
        whole = std::trunc(whole + term);
    }
    const double first = terms[0], last = terms.back();
    const Mistake sums[] = {
        {{first, last}, " has its first or last term alone: return in the loop, or = in place of +=?"},
        {{sum - first, sum - last}, " lacks its first or its last term"},
        {{sum + first, sum + last}, " has its first or its last term twice"},
        {{whole}, " is a sum of whole numbers: an int?"},
        {{above}, " lacks its terms below 0"},
        {{size}, " has terms that lost their sign"},
        {{squares, std::sqrt(squares)}, " has squares in place of terms"}};
    for (Mistake each : sums) {
        for (double& value : each.values) value *= scale;
        own.push_back(each);
    }
    return mistakes(scale * sum, own, std::move(quantities));
}

// As words, if numbers are others times so many quantities of their cases, or 1 over these, times one constant, which
// may have to be one of few digits or pi.
inline std::string law(const std::vector<double>& numbers, const std::vector<double>& others,
                       const std::vector<const Case*>& cases, int degree, bool plain, std::string above = "",
                       std::string below = "") {
    for (std::size_t q = 0; degree > 0 && q < cases[0]->quantities.size(); ++q)
        for (const bool over : {false, true}) {
            std::vector<double> products = others;
            for (std::size_t i = 0; i < products.size(); ++i)
                products[i] *= std::pow(cases[i]->quantities[q].value, over ? -1 : 1);
            const std::string name = " * " + cases[0]->quantities[q].name, &all = over ? below : above;
            const bool again = all.size() >= name.size() && all.rfind(name) == all.size() - name.size();
            const std::string more = all + (again ? "^2" : name);
            const std::string words =
                law(numbers, products, cases, degree - 1, plain, over ? above : more, over ? more : below);
            if (!words.empty()) return words;
        }
    if (degree > 0) return "";
    double constant = 0;
    for (std::size_t i = 0; i < numbers.size() && constant == 0; ++i)
        if (std::isfinite(numbers[i] / others[i])) constant = numbers[i] / others[i];
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (constant == 0 || !near(numbers[i], constant * others[i])) return "";
    const double size = std::fabs(constant);
    bool named = false;
    for (const double power : {2, -2, 1, -1, 0}) {  // of pi, times a whole number, or 1 over one
        const double rest = size / std::pow(std::acos(-1), power), whole = std::round(std::max(rest, 1 / rest));
        named = whole < 100 && std::fabs(whole / std::max(rest, 1 / rest) - 1) < 1e-5;
        if (!named) continue;
        const std::string of_pi = power == 0 ? "" : std::fabs(power) == 1 ? " pi" : " pi^2";
        const std::string digits = whole > 1 ? ' ' + std::to_string(static_cast<int>(whole)) : "";
        for (const bool over : {false, true}) {
            const std::string factor = (over == (rest < 1) ? digits : "") + (over == (power < 0) ? of_pi : "");
            std::string& all = over ? below : above;
            if (!factor.empty()) all = " *" + factor + all;
        }
        break;
    }
    if (!named && plain) return "";
    if (!named) {
        char digits[40];
        std::snprintf(digits, sizeof digits, " * %.4g", size);
        above = digits + above;
    }
    const bool product = below.find(' ', 3) != std::string::npos;
    return (constant < 0 ? " -" : " ") + (above.empty() ? "1" : above.substr(3)) +
           (below.empty() ? ""
            : product     ? " / (" + below.substr(3) + ')'
                          : " / " + below.substr(3));
}

// By what all these numbers are explained, or nothing. Of a part only words that begin with a space or a colon tell.
inline std::string explanation(const std::vector<double>& given, const std::vector<const Case*>& cases, bool part) {
    for (std::size_t m = 1; m < cases[0]->mistakes.size(); ++m)
        for (std::size_t way = 0, i; way < cases[0]->mistakes[m].values.size(); ++way) {
            for (i = 0; i < given.size() && near(given[i], cases[i]->mistakes[m].values[way]);) ++i;
            const std::string& words = cases[0]->mistakes[m].words;
            if (i == given.size() && !(part && words.find_first_of(" :") != 0)) return words;
        }
    std::vector<double> right, more;
    const std::vector<double> ones(given.size(), 1);
    bool varies = false;
    for (std::size_t i = 0; i < given.size(); ++i) {
        right.push_back(cases[i]->right()), more.push_back(given[i] - right[i]);
        varies = varies || !near(right[i], right[0]);
    }
    for (int degree = 0; degree < 4 && given.size() > 2; ++degree) {
        const std::string only = varies ? law(given, ones, cases, degree, degree > 0) : "";
        if (!only.empty()) return (degree == 0 ? " is always" : " is") + only;
        const std::string times = law(given, right, cases, degree, false);
        if (!times.empty()) return " is" + times + " times what it should be";
        const std::string plus = law(more, ones, cases, degree, degree > 0);
        if (!plus.empty()) return " is what it should be, plus" + plus;
    }
    return "";
}

// Numbers that were given, and what is known of each.
struct Trial {
    std::vector<double> given;
    std::vector<Case> cases;

    void add(double number, Case its) { given.push_back(number), cases.push_back(std::move(its)); }

    // Whether all are right. If not, tells the mistake by which each is explained, or each that is wrong, with what
    // this is about where the words begin with a space or a colon.
    bool passes(const std::string& about) const {
        std::vector<const Case*> all, wrong;
        std::vector<double> wrongly;
        bool first = true, last = true;
        for (std::size_t i = 0; i < given.size(); ++i) {
            all.push_back(&cases[i]);
            if (near(given[i], cases[i].right())) continue;
            wrong.push_back(&cases[i]), wrongly.push_back(given[i]);
            first = first && cases[i].place == 0, last = last && cases[i].place + 1 == cases[i].of;
        }
        if (wrong.empty()) return true;
        std::string words = explanation(given, all, false), where;
        if (words.empty() && wrong.size() < all.size()) {
            words = explanation(wrongly, wrong, true);
            where = first  ? " (in the first place alone)"
                    : last ? " (in the last place alone)"
                           : " (" + std::to_string(wrong.size()) + " of " + std::to_string(all.size()) + " cases)";
            if (words.empty() && (first || last)) words = " is wrong";
        }
        if (words.empty() && unexplained.empty())
            unexplained = std::string(cause_mark) + ": " + function + ": " + about + " is wrong\n";
        explain_if(!words.empty(), "%s%s%s", words.find_first_of(" :") == 0 ? about.c_str() : "", words.c_str(),
                   where.c_str());
        return false;
    }
};

// The argument, between these, of which a function, increasing, gives a value.
template <class Of>
double argument(Of of, double value, double least, double largest) {
    for (const double end : {least, largest})
        if (std::fabs(of(end) - value) < 1e-12) return end;
    if (!(of(least) < value && value < of(largest))) return NAN;
    for (int i = 0; i < 60; ++i) {
        const double middle = (least + largest) / 2;
        (of(middle) < value ? least : largest) = middle;
    }
    return least;
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
            if (argc >= 2 && std::strcmp(argv[1], task.name) == 0)
                return task.print(), std::fputs(unexplained.c_str(), stderr), 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", cause_mark, error.what());
        return 1;
    }
    std::fprintf(stderr, "usage: %s TASK [MARK]\n", argv[0]);
    return 2;
}
