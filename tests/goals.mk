# Goals beside the programs; tests/README.md says which to make when.
# make test         every unit test, and the programs' output against tests/output/references
# make judge        build/judge, which tells whether the pictures of another program are right
# make references   rewrites these: only when the output is meant to change
# make handout      the project for students, without the solutions: build/handout and build/handout.tar.gz
# make grade        grades SUBMISSION, a folder made from the hand-out (default: this project)
# make mutations    whether the tests notice the breaks of the product that tests/slow/mutations.txt lists
# make portability  the output of every compiler and processor that this machine has tools for
# make sanitizers   what runs the product, compiled by clang++ with its sanitizers
# make fuzz         FUZZ_SECONDS of made-up files and options, by clang++'s libFuzzer
# make figures      draws the figures of the pages from the programs' output
# make seconds      measures the times that one of the figures shows: on a quiet machine
# make format-check whether clang-format would change a source
# make PRECOMPILED=FILE GOAL   the programs, too, compile with the standard headers read once, into FILE

JUDGE = $(patsubst %.cpp,$(BUILD)/%.o,$(filter-out %/judge.cpp,$(wildcard tests/course/judge/*.cpp)))
TESTS = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/unit/*.cpp))
.PHONY: doctest test judge references handout grade grade_programs mutations portability sanitizers fuzz \
    figures seconds format-check

# The standard headers, read once.
HEADERS = $(or $(PRECOMPILED),$(BUILD)/standard.h)
$(HEADERS).gch: $(BUILD)/settings
	@cat common/*/*.h common/*/*.cpp | grep -oE '^#include <[a-z_]+>' | sort -u > $(HEADERS)
	$(call as,CXX $(HEADERS)) $(COMPILE) -x c++-header $(HEADERS) -o $@
$(TESTS) $(if $(PRECOMPILED),$(COMMON)): EXTRA += -include $(HEADERS)
$(TESTS) $(if $(PRECOMPILED),$(COMMON)): | $(HEADERS).gch

$(TESTS): | doctest
$(TESTS): EXTRA += -O1 -DDOCTEST_CONFIG_SUPER_FAST_ASSERTS
doctest:
	@CXX="$(CXX)" CPPFLAGS="$(CPPFLAGS)" tests/require_tool doctest test

$(BUILD)/unit_tests: $(TESTS) $(JUDGE) $(COMMON)
	$(call as,LINK $@) $(LINK) -o $@

$(BUILD)/compare: $(BUILD)/tests/output/compare.o $(BUILD)/tests/output/compare_text.o $(BUILD)/tests/output/compare_picture.o $(COMMON)
	$(call as,LINK $@) $(LINK) -o $@

judge: $(BUILD)/judge
$(BUILD)/tests/course/judge/%.o: EXTRA =
$(BUILD)/judge: $(BUILD)/tests/course/judge/judge.o $(JUDGE) $(COMMON)
	$(call as,LINK $@) $(LINK) -o $@

# By name, so that what links it tells which objects it took.
$(BUILD)/common.a: $(COMMON) $(JUDGE)
	@rm -f $@ && ar rcsT $@ $^

include tests/course/alone.mk
test: all $(BUILD)/unit_tests $(BUILD)/compare $(ALONE)
	BUILD=$(BUILD) BIN=$(BIN) tests/output/run

references: all
	BUILD=$(BUILD) BIN=$(BIN) tests/output/run --rewrite

handout: all $(ALONE)
	BUILD=$(BUILD) BIN=$(BIN) tests/course/handout

SUBMISSION ?= .
grade_programs: all $(BUILD)/compare $(ALONE)
grade:
	BUILD=$(BUILD) CXX=$(CXX) tests/course/grade "$(SUBMISSION)"

mutations: all $(BUILD)/unit_tests $(BUILD)/compare $(BUILD)/common.a
	BUILD=$(BUILD) tests/slow/mutations

portability: all $(BUILD)/compare
	BUILD=$(BUILD) tests/slow/portability

SANITIZED = $(BUILD)/sanitizers
sanitizers:
	$(MAKE) CXX=clang++ CPPFLAGS=-Werror CXXFLAGS="-O1 -g1 -fno-sanitize-recover=all -fsanitize=address,undefined" \
	    BUILD=$(SANITIZED) BIN=$(SANITIZED) PRECOMPILED=$(SANITIZED)/standard.h all $(SANITIZED)/unit_tests $(SANITIZED)/compare
	BUILD=$(SANITIZED) BIN=$(SANITIZED) tests/output/run product

# What it finds stays in FUZZ, and is where the next run begins; tests/slow/corpus is only read.
FUZZ = $(BUILD)/fuzz
FUZZ_SECONDS ?= 60
fuzz:
	@tests/require_tool libFuzzer fuzz
	$(MAKE) CXX=clang++ CXXFLAGS="-O1 -g1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all" \
	    BUILD=$(FUZZ) PRECOMPILED=$(FUZZ)/standard.h $(FUZZ)/fuzz
	mkdir -p $(FUZZ)/found && cp tests/output/bright.hdr tests/output/directions.txt $(FUZZ)/found
	$(FUZZ)/fuzz $(FUZZ)/found tests/slow/corpus -seed=1 -max_len=4096 -timeout=30 -rss_limit_mb=4096 \
	    -max_total_time=$(FUZZ_SECONDS) -artifact_prefix=$(FUZZ)/ -verbosity=0 -print_final_stats=1
$(BUILD)/fuzz: $(BUILD)/tests/slow/fuzz.o $(filter %/picture_file.o,$(JUDGE)) \
    $(filter-out $(addprefix $(BUILD)/common/,%_cost.o %_error.o picture.o prediction.o known_light/% sharing/% \
    experiments/models.o experiments/stability.o experiments/tradeoff.o),$(COMMON))
	$(call as,LINK $@) $(LINK) -fsanitize=fuzzer -o $@

$(BUILD)/belief: $(BUILD)/tests/figures/belief.o $(COMMON)
	$(call as,LINK $@) $(LINK) -o $@
figures seconds: all $(BUILD)/belief
	BUILD=$(BUILD) BIN=$(BIN) tests/figures/draw $(if $(filter seconds,$@),--seconds)

format-check:
	@tests/require_tool clang-format format-check
	clang-format --dry-run -Werror *.cpp common/*.cpp common/*.h common/*/*.cpp common/*/*.h tests/*/*.cpp tests/*/*.h tests/course/judge/*.cpp tests/course/judge/*.h
