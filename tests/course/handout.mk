# The goals check, test and hand-in, as README.md describes them.
.PHONY: check test hand-in
TASK =
unexport BASH_ENV  # which may print
WARNINGS += -Wno-unused-parameter -Wno-unused-function -Wno-unused-variable  # of what no task uses yet

# For the check your files are compiled as grading compiles them. Of one that gives no program with the others as they
# were handed out an .err stays, and the object is that of the file as it was handed out.
CHECK = $(BUILD)/tests/check
TASK_SOURCES := $(shell BASH_ENV= bash -c '. tests/tasks && echo $${files[*]}')
MINE = $(TASK_SOURCES:%.cpp=$(CHECK)/%.o)
HANDED_OUT = $(TASK_SOURCES:%.cpp=$(CHECK)/tests/handed_out/%.o)
GIVEN = $(filter-out $(TASK_SOURCES:%.cpp=$(BUILD)/%.o),$(COMMON))
OTHERS = $(CHECK)/tests/check_tasks.o $(GIVEN)
CHECK_COMPILE = $$(cat $(CHECK)/compiler) -Icommon -MMD -MP -c $< -o $@

$(CHECK)/compiler: tests/tasks $(BUILD)/settings
	@mkdir -p $(@D) && CXX='$(CXX)' bash -c '. tests/tasks && set_compiler && echo "$${compiler[*]}"' > $@
$(HANDED_OUT) $(CHECK)/tests/check_tasks.o: $(CHECK)/%.o: %.cpp $(CHECK)/compiler
	$(call say,CXX $<) mkdir -p $(@D) && $(CHECK_COMPILE)
$(MINE): $(CHECK)/%.o: %.cpp $(HANDED_OUT) $(OTHERS)
	$(call say,CXX $< for the check) mkdir -p $(@D) && \
	    if $(CHECK_COMPILE) 2> $(@:.o=.err) && $$(cat $(CHECK)/compiler) $@ $(OTHERS) \
	        $(filter-out %/tests/handed_out/$*.o,$(HANDED_OUT)) -o $(@:.o=) 2>> $(@:.o=.err); \
	    then rm $(@:.o=.err) $(@:.o=); else cp $(CHECK)/tests/handed_out/$*.o $@; fi
$(CHECK)/check_tasks: $(MINE) $(OTHERS)
	$(call say,LINK $@) $$(cat $(CHECK)/compiler) $^ -o $@
$(BUILD)/compare: $(BUILD)/tests/output/compare.o $(GIVEN) $(HANDED_OUT)
	$(call say,LINK $@) $(LINK) -o $@
check: $(BUILD)/compare $(CHECK)/check_tasks
	@BUILD=$(BUILD) bash tests/check $(TASK)

TESTS := $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/test_*.cpp))
$(TESTS): EXTRA = -O1
$(BUILD)/tests/all_tests: $(TESTS) $(COMMON)
	$(call say,LINK $@) $(LINK) -o $@
test: $(BUILD)/tests/all_tests
	@$<

# Without the variable, tar on a Mac adds a file ._NAME for each.
hand-in:
	COPYFILE_DISABLE=1 tar -czf hand-in.tar.gz $(TASK_SOURCES)
