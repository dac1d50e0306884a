#define DOCTEST_CONFIG_IMPLEMENT
#include "test.h"

std::string stderr_of(const std::function<void()>& f) {
    std::FILE *const printed = std::tmpfile(), *const nowhere = std::tmpfile();
    std::fflush(stdout);
    const int out = dup(STDOUT_FILENO), err = dup(STDERR_FILENO);
    dup2(fileno(nowhere), STDOUT_FILENO);
    dup2(fileno(printed), STDERR_FILENO);
    const std::string problem = message_of(f);
    std::fflush(stdout);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    std::string text;
    std::rewind(printed);
    for (int c; (c = std::fgetc(printed)) != EOF;) text += static_cast<char>(c);
    close(out), close(err), std::fclose(printed), std::fclose(nowhere);
    if (!problem.empty()) throw std::runtime_error(problem);
    return text;
}

int main(int argc, char** argv) {
    static bool ended = false;  // a case that ends the program is no success
    std::atexit([] { ended ? void() : std::_Exit(1); });
    const int status = doctest::Context(argc, argv).run();
    ended = true;
    return status;
}
