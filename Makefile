# make              the two programs
# make V=1          the same, with the commands in full
# make clean        removes what make made
# make help         these lines
# Of the environment CXX, CXXFLAGS, CPPFLAGS and LDFLAGS count, as for any GNU make. Other variables are the Makefile's
# own, and count on the command line alone.
BUILD = build
BIN = .

# A program is made of an object of its own and of those of common/. It is linked again when a source goes, too: the
# source's folder has changed.
COMMON = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard common/*/*.cpp))
# For make a blank ends a name, and copies have one: render 2.cpp, render (copy).cpp.
BLANK := $(shell find common $(wildcard tests) -path '* *.cpp')
$(if $(BLANK),$(error a file that is compiled has no blank in its name; rename or remove $(BLANK)))
.PHONY: always all clean help
all: $(BIN)/workbench $(BIN)/renderer
$(BIN)/workbench $(BIN)/renderer: $(BIN)/%: $(BUILD)/%.o $(COMMON) $(wildcard common/*/)
	$(call say,LINK $@) $(LINK) -o $@

# An object is made of a source, and of the headers that are listed beside it when it is compiled; also of the settings,
# the command that compiles.
$(BUILD)/%.o: %.cpp $(BUILD)/settings
	@mkdir -p $(@D)
	$(call say,CXX $<) $(COMPILE) $(EXTRA) -MMD -MP -c $< -o $@

clean:
	$(if $(wildcard $(BUILD)/settings),rm -rf $(BUILD) $(BIN)/workbench $(BIN)/renderer)

help:
	@sed -n 's/^# make/make/p' $(filter Makefile %.mk,$(MAKEFILE_LIST))

# The rest says how. The language is part of the sources: its first row of flags makes every result what IEEE 754 says;
# the second one changes no bit, and lets the compiler vectorise loops with square roots and comparisons.
CXX ?= g++
# Where the compiler knows it; but GCC for Windows, which has _WIN32, makes programs with it that crash at random.
NATIVE := $(shell echo _WIN32 | $(CXX) -march=native -x c++ -E - 2>/dev/null | grep -qx _WIN32 && echo -march=native)
CXXFLAGS ?= -O3 $(NATIVE)
LANGUAGE = -std=c++17 -pthread -ffp-contract=off -fno-associative-math -fno-reciprocal-math \
    -fno-math-errno -fno-trapping-math
# A case that a switch lacks is an error: so the compiler names each place that a new enumerator needs.
WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror=switch
EXTRA =
COMPILE = $(CXX) $(CXXFLAGS) $(LANGUAGE) $(WARNINGS) -Icommon $(CPPFLAGS)
LINK = $(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $(filter %.o,$^)

# Prints these words in place of the command; under make -s nothing is printed.
V =
SILENT := $(findstring s,$(firstword -$(MAKEFLAGS)))
say = $(if $(V)$(SILENT),,@echo '$(1)' &&)

# On all processors that it may use, unless a number of jobs is given or another make gives them.
ifeq ($(MAKELEVEL)$(filter -j% --jobserver%,$(MAKEFLAGS)),0)
MAKEFLAGS += -j$(shell nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
endif

# Rewritten when the compile command changes, which makes every object out of date. make clean removes a folder that has
# it: so a folder with files that make did not make gets none.
$(BUILD)/settings: always
	@mkdir -p $(@D)
	@[ -e $@ ] || [ -z "$$(find $(@D) -maxdepth 1 -type f)" ] || \
	    { echo 'BUILD=$(BUILD) has files that make did not make; name another folder' >&2; false; }
	@echo '$(SETTINGS)' | cmp -s - $@ || echo '$(SETTINGS)' > $@

-include tests/goals.mk
-include $(shell find $(BUILD)/*.d $(BUILD)/common $(BUILD)/tests -name '*.d' 2>/dev/null)

# Last, and once: a goal's own COMPILE would reach this file of settings, too, and each goal undo what another made.
SETTINGS := $(COMPILE) $(LDFLAGS)
