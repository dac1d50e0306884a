# make              the two programs
# make test         every test, and the programs' output against tests/references
# make portability  the output of every compiler and processor that this machine has tools for
# make references   rewrites tests/references: only when the output is meant to change
# make clean        removes what make made

CXX ?= g++
ARCH ?= $(shell $(CXX) -march=native -x c++ -fsyntax-only /dev/null 2>/dev/null && echo -march=native)
CXXFLAGS ?= -O3 $(ARCH)
BUILD ?= build
BIN ?= .

# Part of the language that the sources are written in: without contraction every result is what IEEE 754 says. The last
# two change no bit; they let the compiler vectorise loops with square roots and comparisons.
LANGUAGE = -std=c++17 -ffp-contract=off -fno-math-errno -fno-trapping-math -pthread
WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion

COMMON = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard common/*.cpp))
TESTS = $(patsubst %.cpp,$(BUILD)/%.o,tests/main.cpp $(wildcard tests/test_*.cpp))

.PHONY: all test portability references clean
all: $(BIN)/workbench $(BIN)/renderer

$(BIN)/workbench $(BIN)/renderer: $(BIN)/%: $(BUILD)/%.o $(COMMON)
	$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ -o $@

$(BUILD)/unit_tests: $(TESTS) $(COMMON)
	$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ -o $@

$(BUILD)/compare: $(BUILD)/tests/compare.o
	$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ -o $@

$(BUILD)/%.o: %.cpp
	@mkdir -p $(@D)
	$(CXX) $(CXXFLAGS) $(LANGUAGE) $(WARNINGS) $(CPPFLAGS) -MMD -MP -c $< -o $@

test: all $(BUILD)/unit_tests $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) tests/run

portability: all $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) tests/portability

references: all
	BUILD=$(BUILD) BIN=$(BIN) tests/run --rewrite

clean:
	rm -rf build workbench renderer

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
