# make check        which functions are right, which are wrong and why, and which are not written yet
# make check TASK=z             of one task, or function
# make check TASK=z_of ALL=yes  with all its numbers, as they are and right
# make test         your own tests, which begin in tests/test_process.cpp
# make belief       belief.ppm: what your process believes of the light at a point, from the tasks of 3.1 and montecarlo
# make hand-in      hand-in.tar.gz: the files with tasks

.PHONY: check test belief hand-in
WARNINGS += -Wno-unused-parameter -Wno-unused-function -Wno-unused-variable  # of what no task uses yet

# Headers that a task may want need no #include.
TASK_SOURCES := $(shell grep -l 'BEGIN SOLUTION' common/*/*.cpp)
TASK_OBJECTS := $(TASK_SOURCES:%.cpp=$(BUILD)/%.o)
USUAL := $(shell sed -n "s/^usual='\(.*\)'/\1/p" tests/tasks)
$(TASK_OBJECTS): EXTRA = $(USUAL:%=-include %)

$(BUILD)/verdict: $(BUILD)/tests/verdict.o
	$(call say,LINK $@) $(LINK) -o $@
check: $(BUILD)/verdict $(filter-out $(TASK_OBJECTS),$(COMMON))
	@BUILD=$(BUILD) CXX='$(CXX)' bash tests/check $(if $(ALL),--all) $(TASK)

TESTS := $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/test_*.cpp))
$(TESTS): EXTRA = -O1
$(BUILD)/tests/all_tests: $(TESTS) $(COMMON)
	$(call say,LINK $@) $(LINK) -o $@
test:
	@echo '#include <doctest/doctest.h>' | $(CXX) -E -x c++ - > /dev/null 2>&1 || \
	    { echo 'make test needs doctest: apt-get install doctest-dev, or brew install doctest' >&2; false; }
	@$(MAKE) $(BUILD)/tests/all_tests && $(BUILD)/tests/all_tests

belief: $(BIN)/workbench
	./workbench belief > belief.ppm || (rm belief.ppm; false)

hand-in:
	tar -czf hand-in.tar.gz $(TASK_SOURCES)
