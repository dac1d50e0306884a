# make check        which tasks are right, which are wrong and why, and which are not written yet
# make belief       belief.ppm: what your process believes of the light at a point, by the tasks montecarlo, inverse, z and integral

.PHONY: check belief
WARNINGS += -Wno-unused-parameter -Wno-unused-function -Wno-unused-variable  # of what no task uses yet

# Headers that a task may want need no #include.
TASK_SOURCES := $(shell grep -l 'BEGIN SOLUTION' common/*/*.cpp)
USUAL = algorithm array cmath functional iostream map numeric set stdexcept string vector
$(TASK_SOURCES:%.cpp=$(BUILD)/%.o): EXTRA = $(addprefix -include ,$(USUAL))

# tests/check writes the handed out sources with the texts of tasks into JUDGED. A sum that begins with nothing is to be
# wrong, and a crash to have a line. What does not compile leaves its error in a file, and the rest goes on.
JUDGED = $(BUILD)/tests/judged
STRICT := -O1 -g1 -w -D_GLIBCXX_ASSERTIONS -Werror=return-type -Werror=uninitialized $(shell for each in \
    -ftrivial-auto-var-init=pattern -fno-finite-loops; do $(CXX) $$each -x c++ -fsyntax-only /dev/null 2> /dev/null && echo $$each; done)
$(JUDGED)/usual.h.gch: $(BUILD)/settings
	@mkdir -p $(@D) && printf '%s\n' $(USUAL:%='#include <%>') > $(JUDGED)/usual.h
	@$(COMPILE) $(STRICT) -x c++-header $(JUDGED)/usual.h -o $@
$(JUDGED)/%.o: $(JUDGED)/%.cpp $(BUILD)/settings | $(JUDGED)/usual.h.gch
	@$(COMPILE) $(STRICT) -include $(JUDGED)/usual.h -MMD -MP -c $< -o $@ 2> $@.err || rm -f $@

OTHERS = $(filter-out $(TASK_SOURCES:%.cpp=$(BUILD)/%.o),$(COMMON))
$(BUILD)/tests/check_tasks.o: EXTRA = -O1 -g1
JUDGED_PROGRAMS = $(addprefix $(JUDGED)/,check_tasks workbench renderer)
$(JUDGED)/check_tasks: $(BUILD)/tests/check_tasks.o
$(JUDGED)/workbench: $(BUILD)/workbench.o
$(JUDGED)/renderer: $(BUILD)/renderer.o
$(JUDGED_PROGRAMS): $(OTHERS) $(TASK_SOURCES:%.cpp=$(JUDGED)/%.o)
	@$(LINK) -o $@ 2> $@.err || rm -f $@

$(BUILD)/compare: $(addprefix $(BUILD)/,tests/compare.o tests/compare_text.o tests/compare_picture.o tests/picture.o common/scene/image.o common/numerics/portable_math.o)
	$(call say,LINK $@) $(LINK) -o $@
check: $(BUILD)/compare $(BUILD)/tests/check_tasks.o $(BUILD)/workbench.o $(BUILD)/renderer.o $(OTHERS)
	@BUILD=$(BUILD) MAKE='$(MAKE)' bash tests/check

belief: $(BIN)/workbench
	./workbench belief > belief.ppm || (rm belief.ppm; false)
