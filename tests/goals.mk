# Goals beside the programs; tests/README.md says which to make when.
# make test         every unit test, and the programs' output against tests/output/references
# make unit         the unit tests alone, below two seconds once they are compiled
# make references   rewrites these, or with ONLY='pool*' some: only when the output is meant to change
# make handout      the project for students, without the solutions: build/handout.tar.gz
# make grade        grades SUBMISSION, a folder made from the hand-out (default: this project)
# make portability  the output of every compiler and processor that this machine has tools for
# make sanitizers   what runs the product, compiled by clang++ with its sanitizers
# make threads      pictures by seven threads, compiled by clang++ with its sanitizer of threads
# make fuzz         FUZZ_SECONDS of made-up files and options, by clang++'s libFuzzer
# make figures      draws the figures of the pages from the programs' output
# make seconds      measures the times that two of the figures show, on a quiet machine, and errors under the light MAP
# make syntax       whether each source and header compiles alone: by CXX, clang++ with libc++, at its strictest
# make format-check whether clang-format would change a source (the lines of smallbmc.cpp are set by hand)

.PHONY: test unit programs sources references handout grade portability sanitizers threads fuzz
.PHONY: figures seconds format-check syntax

# All unit tests are one source, which reads each header once; they take longer to compile than to run. So are, where
# programs only run, all sources of common/: one source hides a missing #include. Made again when a file goes, too.
$(BUILD)/unit_sources.cpp: $(wildcard tests/unit/*.cpp) tests/unit
$(BUILD)/common_sources.cpp: $(wildcard common/*/*.cpp common/*/)
$(BUILD)/%_sources.cpp: | $(BUILD)/settings
	@printf '#include "%s"\n' $(filter %.cpp,$^) > $@
$(BUILD)/%_sources.o: $(BUILD)/%_sources.cpp $(BUILD)/settings
	$(call say,CXX $<) $(COMPILE) -I. $(EXTRA) -MMD -MP -c $< -o $@
$(BUILD)/common_sources.o: EXTRA = -w
$(BUILD)/unit_sources.o: EXTRA = -O0 -DDOCTEST_CONFIG_SUPER_FAST_ASSERTS
ONE_SOURCE = COMMON='$$(BUILD)/common_sources.o'
$(BUILD)/unit_tests: $(BUILD)/unit_sources.o $(COMMON)
	$(call say,LINK $@) $(LINK) -o $@

$(BUILD)/compare: $(BUILD)/tests/output/compare.o
$(BUILD)/check_tasks: $(BUILD)/tests/course/check_tasks.o
$(BUILD)/fuzz: $(BUILD)/tests/slow/fuzz.o
$(addprefix $(BUILD)/,compare check_tasks fuzz): $(COMMON)
	$(call say,LINK $@) $(LINK) -o $@

# The sources of other goals are compiled as well, but to nothing: a change that breaks one is noticed at once.
SEEN = $(patsubst %.cpp,$(BUILD)/%.seen,common/smallbmc.cpp $(wildcard tests/course/*.cpp tests/slow/*.cpp))
$(SEEN): $(BUILD)/%.seen: %.cpp $(BUILD)/settings
	@mkdir -p $(@D)
	$(call say,SYNTAX $<) $(COMPILE) -Wno-conversion -fsyntax-only -MMD -MP -MT $@ -MF $@.d $< && touch $@

# Three parts, which make runs side by side.
test: unit programs sources
unit: $(BUILD)/unit_tests
	timeout 300 $(BUILD)/unit_tests
programs sources: all $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) bash tests/output/run $@
sources: $(SEEN)

ONLY = *
references: all
	BUILD=$(BUILD) BIN=$(BIN) bash tests/output/run --rewrite '$(ONLY)'

handout: all $(BUILD)/check_tasks
	BUILD=$(BUILD) BIN=$(BIN) bash tests/course/handout

SUBMISSION = .
grade:
	BUILD=$(BUILD) CXX="$(CXX)" bash tests/course/grade "$(SUBMISSION)"

portability: all $(BUILD)/compare
	BUILD=$(BUILD) bash tests/slow/portability

SANITIZED = $(BUILD)/sanitizers
sanitizers: export UBSAN_OPTIONS = halt_on_error=1
sanitizers:
	$(MAKE) CXX=clang++ $(ONE_SOURCE) BUILD=$(SANITIZED) BIN=$(SANITIZED) \
	    CXXFLAGS="-O1 -g1 -fno-sanitize-recover=all -fsanitize=address,undefined,float-cast-overflow" \
	    all $(SANITIZED)/unit_tests $(SANITIZED)/compare
	nm $(SANITIZED)/renderer | grep -qw __asan_init && nm $(SANITIZED)/renderer | grep -q __ubsan_handle_.*_abort
	$(SANITIZED)/unit_tests
	BUILD=$(SANITIZED) BIN=$(SANITIZED) QUICK=yes bash tests/output/run product

THREADS = $(BUILD)/threads
threads:
	$(MAKE) CXX=clang++ CXXFLAGS="-O1 -g1 -fsanitize=thread" $(ONE_SOURCE) \
	    BUILD=$(THREADS) BIN=$(THREADS) $(THREADS)/renderer $(THREADS)/compare
	nm $(THREADS)/renderer | grep -qw __tsan_init
	BUILD=$(THREADS) BIN=$(THREADS) bash tests/output/run references '!(small-light).p?m' --threads 7

# What it finds stays in FUZZ, and is where the next run begins; tests/slow/corpus is only read.
FUZZ = $(BUILD)/fuzz
FUZZ_SECONDS = 60
fuzz:
	$(MAKE) CXX=clang++ CXXFLAGS="-O1 -g1 -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all" \
	    BUILD=$(FUZZ) $(ONE_SOURCE) LDFLAGS=-fsanitize=fuzzer $(FUZZ)/fuzz
	mkdir -p $(FUZZ)/found && cp tests/output/bright.hdr tests/output/directions.txt $(FUZZ)/found
	$(FUZZ)/fuzz $(FUZZ)/found tests/slow/corpus -dict=tests/slow/corpus/dictionary -seed=1 \
	    -max_total_time=$(FUZZ_SECONDS) -max_len=4096 -timeout=30 -rss_limit_mb=4096 \
	    -artifact_prefix=$(FUZZ)/ -verbosity=0 -print_final_stats=1

figures seconds: all $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) bash tests/figures/draw $(if $(filter seconds,$@),--seconds "$(MAP)")

# Each source, and each header that is not the first include of a source, where clang-format puts the source's own.
# libc++ includes fewer of its headers than others do, without these.
SOURCES = $(wildcard *.cpp common/*/*.cpp)
ALONE = $(SOURCES) $(filter-out $(SOURCES:.cpp=.h),$(wildcard common/*/*.h))
syntax: $(ALONE:%=$(BUILD)/syntax/%)
	@echo "$(words $^) passed, 0 failed"
$(BUILD)/syntax/%: % always
	$(call say,SYNTAX $<) $(CXX) $(LANGUAGE) $(WARNINGS) -Werror -Icommon -stdlib=libc++ \
	    -D_LIBCPP_REMOVE_TRANSITIVE_INCLUDES -fsyntax-only -include $< -x c++ /dev/null

format-check:
	find *.cpp common tests \( -name '*.cpp' -o -name '*.h' \) ! -name smallbmc.cpp \
	    -exec clang-format --dry-run -Werror {} +
