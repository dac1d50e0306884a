# make check        which tasks are right, which are wrong and why, and which are not written yet

CPPFLAGS += -D_GLIBCXX_ASSERTIONS
ALONE = $(BUILD)/alone
STRICT := $(shell bash -c '. tests/tasks && strict_options $(CXX)')
UNSOLVED = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/unsolved/common/*/*.cpp))
OTHERS = $(filter-out $(UNSOLVED:$(BUILD)/tests/unsolved/%=$(BUILD)/%),$(COMMON))

.PHONY: check check_programs
check:
	@BUILD=$(BUILD) BIN=$(BIN) MAKE='$(MAKE)' tests/check
check_programs: all $(BUILD)/compare $(BUILD)/unsolved.a

$(BUILD)/compare: $(BUILD)/tests/compare.o $(BUILD)/tests/compare_text.o $(BUILD)/tests/compare_picture.o $(BUILD)/unsolved.a
	$(call as,LINK $@) $(LINK) -o $@

# For each task a program that calls its functions alone. tests/check writes the sources and what each program is made
# of. An error in one keeps no other from being made.
$(BUILD)/tests/alone%.o $(UNSOLVED): EXTRA = -O0
$(BUILD)/unsolved.a: $(UNSOLVED) $(OTHERS)
	@rm -f $@ && ar rcs $@ $^
$(ALONE)/%.o: $(ALONE)/%.cpp $(BUILD)/settings
	@$(COMPILE) $(STRICT) -MMD -MP -c $< -o $@ 2> $@.err || rm -f $@
$(ALONE)/%/program:
	@$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ -o $@ 2> $@.err || rm -f $@
-include $(wildcard $(ALONE)/*.mk $(ALONE)/*/common/*/*.d)
