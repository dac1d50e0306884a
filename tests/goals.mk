# Goals beside the programs; tests/README.md says which to make when.
# make test         every unit test, and the programs' output against tests/output/references
# make unit         the unit tests alone, below two seconds once they are compiled
# make references   rewrites these, or with ONLY='pool*' some: only when the output is meant to change
# make handout      the project for students, without the solutions: build/handout and build/handout.tar.gz
# make grade        grades SUBMISSION, a folder made from the hand-out (default: this project)
# make mutations    whether the tests notice the breaks of the product that tests/slow/mutations.txt lists
# make portability  the output of every compiler and processor that this machine has tools for
# make sanitizers   what runs the product, compiled by clang++ with its sanitizers
# make threads      pictures by seven threads, compiled by clang++ with its sanitizer of threads
# make fuzz         FUZZ_SECONDS of made-up files and options, by clang++'s libFuzzer
# make figures      draws the figures of the pages from the programs' output
# make seconds      measures the times that one of the figures shows: on a quiet machine
# make syntax       whether each source and header compiles alone: by CXX, clang++ with libc++, at its strictest
# make format-check whether clang-format would change a source (the lines of smallbmc.cpp are set by hand)

# With UNIT_AS_ONE=yes the unit tests are one source: a third of the time where they only run.
TESTS = $(if $(UNIT_AS_ONE),$(BUILD)/unit_sources.o,$(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/unit/*.cpp)))
.PHONY: doctest test unit references handout grade mutations portability sanitizers threads fuzz figures seconds
.PHONY: format-check syntax

# Unit tests take longer to compile than to run, and their header longest: it is read once, but for main.cpp, which sets
# doctest up.
UNIT = -O1 -DDOCTEST_CONFIG_SUPER_FAST_ASSERTS
UNIT_HEADER = $(BUILD)/tests/unit.h
$(UNIT_HEADER).gch: $(wildcard tests/unit/test.h common/*/*.h common/*/*/*.h) $(BUILD)/settings | doctest
	@mkdir -p $(@D) && echo '#include "$(abspath $<)"' > $(UNIT_HEADER)
	$(call say,CXX $<) $(COMPILE) $(UNIT) -x c++-header -MD -MP $(UNIT_HEADER) -o $@
$(TESTS): $(if $(UNIT_AS_ONE),,$(HEADERS:%=$(UNIT_HEADER).gch)) | doctest
$(TESTS): EXTRA = $(UNIT)
$(TESTS): HEADERS := $(HEADERS:%=$(UNIT_HEADER))
$(BUILD)/tests/unit/main.o: HEADERS =
doctest:
	@CXX="$(CXX)" CPPFLAGS="$(CPPFLAGS)" tests/require_tool doctest test

# Linked again when a test goes, too.
$(BUILD)/unit_tests: $(TESTS) $(COMMON) tests/unit
	$(call say,LINK $@) $(LINK) -o $@

$(BUILD)/compare: $(BUILD)/tests/output/compare.o $(COMMON)
$(BUILD)/check_tasks: $(BUILD)/tests/course/check_tasks.o $(COMMON)
$(BUILD)/compare $(BUILD)/check_tasks:
	$(call say,LINK $@) $(LINK) -o $@

test: all $(BUILD)/unit_tests $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) tests/output/run

unit: $(BUILD)/unit_tests
	BUILD=$(BUILD) tests/output/run unit_tests

ONLY = *
references: all
	BUILD=$(BUILD) BIN=$(BIN) tests/output/run --rewrite '$(ONLY)'

handout: all $(BUILD)/check_tasks
	BUILD=$(BUILD) BIN=$(BIN) tests/course/handout

SUBMISSION = .
grade:
	BUILD=$(BUILD) CXX="$(CXX)" tests/course/grade "$(SUBMISSION)"

mutations: doctest
	tests/slow/mutations

portability: all $(BUILD)/compare
	BUILD=$(BUILD) tests/slow/portability

# All sources of common/, or all unit tests, as one: a fifth of the time where they only run. One source hides a
# missing #include, so the programs and one configuration of portability do without.
$(BUILD)/common_sources.cpp: $(wildcard common/*/*.cpp common/*/*/*.cpp)
$(BUILD)/unit_sources.cpp: $(wildcard tests/unit/*.cpp) tests/unit
$(BUILD)/%_sources.cpp: | $(BUILD)/settings
	@mkdir -p $(@D)
	@printf '#include "%s"\n' $(filter %.cpp,$^) > $@
$(BUILD)/%_sources.o: $(BUILD)/%_sources.cpp $(BUILD)/settings
	$(call say,CXX $<) $(COMPILE) -w -I. -Itests/unit $(EXTRA) -MMD -MP -c $< -o $@
ONE_SOURCE = HEADERS= COMMON='$$(BUILD)/common_sources.o' UNIT_AS_ONE=yes

SANITIZED = $(BUILD)/sanitizers
sanitizers:
	$(MAKE) CXX=clang++ CXXFLAGS="-O1 -g1 -fno-sanitize-recover=all -fsanitize=address,undefined" $(ONE_SOURCE) \
	    BUILD=$(SANITIZED) BIN=$(SANITIZED) all $(SANITIZED)/unit_tests $(SANITIZED)/compare
	BUILD=$(SANITIZED) BIN=$(SANITIZED) tests/output/run has_symbols __asan_init __ubsan_handle_add_overflow_abort
	BUILD=$(SANITIZED) BIN=$(SANITIZED) QUICK=yes tests/output/run product

THREADS = $(BUILD)/threads
threads:
	$(MAKE) CXX=clang++ CXXFLAGS="-O1 -g1 -fsanitize=thread" $(ONE_SOURCE) \
	    BUILD=$(THREADS) BIN=$(THREADS) $(THREADS)/renderer $(THREADS)/compare
	BUILD=$(THREADS) BIN=$(THREADS) tests/output/run has_symbols __tsan_init
	BUILD=$(THREADS) BIN=$(THREADS) tests/output/run references '*.p?m' --threads 7

# What it finds stays in FUZZ, and is where the next run begins; tests/slow/corpus is only read.
FUZZ = $(BUILD)/fuzz
FUZZ_SECONDS = 60
fuzz:
	@tests/require_tool libFuzzer fuzz
	$(MAKE) CXX=clang++ CXXFLAGS="-O1 -g1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all" \
	    BUILD=$(FUZZ) $(ONE_SOURCE) LDFLAGS=-fsanitize=fuzzer $(FUZZ)/fuzz
	mkdir -p $(FUZZ)/found && cp tests/output/bright.hdr tests/output/directions.txt $(FUZZ)/found
	$(FUZZ)/fuzz $(FUZZ)/found tests/slow/corpus -dict=tests/slow/corpus/dictionary -seed=1 \
	    -max_total_time=$(FUZZ_SECONDS) -max_len=4096 -timeout=30 -rss_limit_mb=4096 \
	    -artifact_prefix=$(FUZZ)/ -verbosity=0 -print_final_stats=1
$(BUILD)/fuzz: $(BUILD)/tests/slow/fuzz.o $(COMMON)
	$(call say,LINK $@) $(LINK) -o $@

figures seconds: all $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) tests/figures/draw $(if $(filter seconds,$@),--seconds)

# A header that is included first, and alone. libc++ includes fewer of its headers than others do, without these.
ALONE = $(wildcard *.cpp common/*/*.cpp common/*/*/*.cpp common/*/*.h common/*/*/*.h)
syntax: $(ALONE:%=$(BUILD)/syntax/%)
	@echo "$(words $^) passed, 0 failed"
$(BUILD)/syntax/%: % always
	$(call say,SYNTAX $<) $(CXX) $(LANGUAGE) $(WARNINGS) -Werror -Icommon -stdlib=libc++ \
	    -D_LIBCPP_REMOVE_TRANSITIVE_INCLUDES -fsyntax-only -include $< -x c++ /dev/null

format-check:
	@tests/require_tool clang-format format-check
	find *.cpp common tests \( -name '*.cpp' -o -name '*.h' \) ! -name smallbmc.cpp \
	    -exec clang-format --dry-run -Werror {} +
