# make check        which tasks are right, which are wrong and why, and which are not written yet
# make belief       belief.ppm: what your process believes of the light at a point, by the tasks of 3.1 and montecarlo
# make hand-in      hand-in.tar.gz: the files with tasks

.PHONY: check belief hand-in
WARNINGS += -Wno-unused-parameter -Wno-unused-function -Wno-unused-variable  # of what no task uses yet

# Headers that a task may want need no #include.
TASK_SOURCES := $(shell grep -l 'BEGIN SOLUTION' common/*/*.cpp)
$(TASK_SOURCES:%.cpp=$(BUILD)/%.o): EXTRA = $(patsubst %,-include %,$(shell sed -n "s/^usual='\(.*\)'.*/\1/p" tests/tasks))

$(BUILD)/verdict: $(BUILD)/tests/verdict.o
$(BUILD)/compare: $(addprefix $(BUILD)/,$(patsubst %.cpp,%.o,$(wildcard tests/output/*.cpp)) common/scene/image.o common/numerics/portable_math.o)
$(BUILD)/verdict $(BUILD)/compare:
	$(call say,LINK $@) $(LINK) -o $@
check: $(addprefix $(BUILD)/,verdict compare workbench.o renderer.o) $(filter-out $(TASK_SOURCES:%.cpp=$(BUILD)/%.o),$(COMMON))
	@BUILD=$(BUILD) CXX='$(CXX)' bash tests/check

belief: $(BIN)/workbench
	./workbench belief > belief.ppm || (rm belief.ppm; false)

hand-in:
	tar -czf hand-in.tar.gz $(TASK_SOURCES)
