# make              the two programs
# make V=1          the same, with the commands in full
# make clean        removes what make made
# make help         these lines

# Under make -s nothing is printed; on all processors that it may use, unless a number of jobs is given or another make
# gives them.
SILENT := $(findstring s,$(firstword -$(MAKEFLAGS)))
ifeq ($(MAKELEVEL)$(filter -j% --jobserver%,$(MAKEFLAGS)),0)
MAKEFLAGS += -j$(shell nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
endif

CXX ?= g++
ifeq ($(origin ARCH),undefined)
ARCH := $(shell $(CXX) -march=native -x c++ -fsyntax-only /dev/null 2>/dev/null && echo -march=native)
endif
CXXFLAGS ?= -O3 $(ARCH)
BUILD ?= build
BIN ?= .

# Part of the language that the sources are written in: without contraction every result is what IEEE 754 says. The last
# two change no bit; they let the compiler vectorise loops with square roots and comparisons.
LANGUAGE = -std=c++17 -ffp-contract=off -fno-math-errno -fno-trapping-math -pthread
# A case that a switch lacks is an error: so the compiler names each place that a new enumerator needs.
WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror=switch
COMPILE = $(CXX) $(CXXFLAGS) $(LANGUAGE) $(WARNINGS) -Icommon $(CPPFLAGS)
LINK = $(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $(filter %.o,$^)

COMMON = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard common/*/*.cpp common/*/*/*.cpp))

# Prints these words in place of the command.
say = $(if $(V)$(SILENT),,@echo '$(1)' &&)

.PHONY: always all clean help
all: $(BIN)/workbench $(BIN)/renderer

# Linked again when a source goes, too: its folder has changed.
$(BIN)/workbench $(BIN)/renderer: $(BIN)/%: $(BUILD)/%.o $(COMMON) $(wildcard common/*/ common/*/*/)
	$(call say,LINK $@) $(LINK) -o $@

# Both programs include headers of common/beyond if it exists: the folder common changes when it comes or goes.
$(BUILD)/workbench.o $(BUILD)/renderer.o: common

# The standard headers, read once: that saves 38 % of the time of a first make. Without it: HEADERS=
HEADERS = $(BUILD)/standard.h
$(BUILD)/standard.h.gch: $(BUILD)/settings
	@printf '#include <%s>\n' algorithm cmath functional memory optional stdexcept string vector > $(BUILD)/standard.h
	$(call say,CXX the standard headers) $(COMPILE) -x c++-header -MD -MP $(BUILD)/standard.h -o $@

$(BUILD)/%.o: %.cpp $(BUILD)/settings | $(HEADERS:=.gch)
	@mkdir -p $(@D)
	$(call say,CXX $<) $(COMPILE) $(HEADERS:%=-include %) $(EXTRA) -MMD -MP -c $< -o $@

# Rewritten when the compile command changes, which makes every object out of date.
$(BUILD)/settings: always
	@mkdir -p $(@D)
	@echo '$(SETTINGS)' | cmp -s - $@ || echo '$(SETTINGS)' > $@

clean:
	rm -rf $(BUILD) $(BIN)/workbench $(BIN)/renderer

help:
	@sed -n 's/^# make/make/p' $(filter Makefile %.mk,$(MAKEFILE_LIST))

-include tests/goals.mk
-include $(shell find $(BUILD)/*.d $(BUILD)/common $(BUILD)/tests -name '*.d' 2>/dev/null)

# Last, and once: a goal's own COMPILE would reach this file of settings, too, and each goal undo what another made.
SETTINGS := $(COMPILE) $(LDFLAGS)
