# make              the two programs
# make clean        removes what make made
# BEGIN LECTURER
# make handout      the project for students, without the solutions: build/handout and build/handout.tar.gz
# make grade        grades SUBMISSION, a folder made from the hand-out (default: this project)
# make test         every test, and the programs' output against tests/references
# make mutations    whether the tests notice the breaks of the product that tests/mutations.txt lists
# make portability  the output of every compiler and processor that this machine has tools for
# make fuzz         FUZZ_SECONDS of made-up pictures and command lines, by clang++'s libFuzzer
# make bench        how fast the hot paths are, beside LAPACK if it is installed
# make figures      draws the figures of README.md from the programs' output
# make seconds      measures the times that one of the figures shows: on a quiet machine
# make format-check whether clang-format would change a source
# make references   rewrites tests/references: only when the output is meant to change
# END LECTURER

# On all processors, unless a number of jobs is given.
ifeq ($(filter -j% --jobserver%,$(MAKEFLAGS)),)
MAKEFLAGS += -j$(shell nproc)
endif

CXX ?= g++
ARCH ?= $(shell $(CXX) -march=native -x c++ -fsyntax-only /dev/null 2>/dev/null && echo -march=native)
CXXFLAGS ?= -O3 $(ARCH)
BUILD ?= build
BIN ?= .

# Part of the language that the sources are written in: without contraction every result is what IEEE 754 says. The last
# two change no bit; they let the compiler vectorise loops with square roots and comparisons.
LANGUAGE = -std=c++17 -ffp-contract=off -fno-math-errno -fno-trapping-math -pthread
WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion

COMMON = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard common/*.cpp common/*/*.cpp))
# BEGIN LECTURER
TESTS = $(patsubst %.cpp,$(BUILD)/%.o,tests/main.cpp $(wildcard tests/test_*.cpp))
.PHONY: doctest handout grade test portability mutations fuzz bench figures seconds format-check references
# END LECTURER

.PHONY: always all clean
all: $(BIN)/workbench $(BIN)/renderer

$(BIN)/workbench $(BIN)/renderer: $(BIN)/%: $(BUILD)/%.o $(COMMON)
	$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ -o $@

$(BUILD)/compare: $(BUILD)/tests/compare.o $(BUILD)/tests/compare_tolerant.o $(BUILD)/common/scene/scene.o
	$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ -o $@

$(TESTS): | doctest
doctest:
	@CXX="$(CXX)" CPPFLAGS="$(CPPFLAGS)" tests/needs doctest test

$(BUILD)/%.o: %.cpp $(BUILD)/settings
	@mkdir -p $(@D)
	$(COMPILE) -MMD -MP -c $< -o $@

# Written anew when the command to compile has changed: all that was made by another is then out of date.
COMPILE = $(CXX) $(CXXFLAGS) $(LANGUAGE) $(WARNINGS) -Icommon $(CPPFLAGS)
$(BUILD)/settings: always
	@mkdir -p $(@D)
	@echo '$(COMPILE) $(LDFLAGS)' | cmp -s - $@ || echo '$(COMPILE) $(LDFLAGS)' > $@

# BEGIN LECTURER
handout: all
	BUILD=$(BUILD) BIN=$(BIN) tests/handout

SUBMISSION ?= .
grade:
	BUILD=$(BUILD) CXX=$(CXX) tests/grade "$(SUBMISSION)"

$(BUILD)/unit_tests: $(TESTS) $(COMMON)
	$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ -o $@

test: all $(BUILD)/unit_tests $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) tests/run

portability: all $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) tests/portability

mutations:
	BUILD=$(BUILD) tests/mutations

FUZZ_SECONDS ?= 60
FUZZ = $(BUILD)/fuzz
FUZZERS = fuzz_environment fuzz_picture fuzz_command_line
fuzz:
	@tests/needs libFuzzer fuzz
	$(MAKE) CXX=clang++ CXXFLAGS="-O1 -g -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all" \
	    BUILD=$(FUZZ) $(FUZZERS:%=$(FUZZ)/%)
	FUZZ=$(FUZZ) FUZZ_SECONDS=$(FUZZ_SECONDS) tests/fuzz
$(FUZZERS:%=$(BUILD)/%): $(BUILD)/%: $(BUILD)/tests/%.o $(COMMON)
	$(CXX) $(CXXFLAGS) -fsanitize=fuzzer $(LANGUAGE) $(LDFLAGS) $^ -o $@

LAPACK = $(if $(wildcard /usr/lib/*/libopenblas.so),-lopenblas)
bench: $(BUILD)/bench
	OPENBLAS_NUM_THREADS=1 $(BUILD)/bench
$(BUILD)/tests/bench.o: private CPPFLAGS += $(if $(LAPACK),-DCOMPARE_LAPACK)
$(BUILD)/bench: $(BUILD)/tests/bench.o $(COMMON)
	$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ $(LAPACK) -o $@

format-check:
	@tests/needs clang-format format-check
	clang-format --dry-run -Werror *.cpp common/*.cpp common/*.h common/*/*.cpp common/*/*.h tests/*.cpp tests/*.h

figures seconds: all
	BIN=$(BIN) tests/figures $(if $(filter seconds,$@),--seconds)

references: all
	BUILD=$(BUILD) BIN=$(BIN) tests/run --rewrite
# END LECTURER

clean:
	rm -rf $(BUILD) $(BIN)/workbench $(BIN)/renderer

-include $(shell find $(BUILD) -name '*.d' 2>/dev/null)
