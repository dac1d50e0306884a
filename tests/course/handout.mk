# make check        which tasks are right, which are wrong and why, and which are not written yet
# make belief       belief.ppm: what your process believes of the light at a point, by the tasks inverse, z and integral

CPPFLAGS += -D_GLIBCXX_ASSERTIONS
ALONE = $(BUILD)/alone
STRICT := $(shell bash -c '. tests/tasks && strict_options $(CXX)')
UNSOLVED = $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tests/unsolved/common/*.cpp tests/unsolved/common/*/*.cpp))

.PHONY: check check_programs belief
check:
	@BUILD=$(BUILD) MAKE='$(MAKE)' bash tests/check
check_programs: all $(BUILD)/compare $(BUILD)/unsolved.a

belief: $(BUILD)/belief
	$(BUILD)/belief > belief.ppm || (rm belief.ppm; false)
$(BUILD)/belief: tests/belief.cpp $(COMMON)
	$(call as,LINK $@) $(COMPILE) $^ -o $@

# Tasks are tried with the hand-out as it was, whatever common/ holds now.
$(BUILD)/tests/%.o $(ALONE)/%.o: COMPILE := $(subst -Icommon,-Itests/unsolved/common,$(COMPILE)) $(STRICT)

$(BUILD)/unsolved.a: $(UNSOLVED)
	@rm -f $@ && ar rcs $@ $^
$(BUILD)/compare: $(BUILD)/tests/compare.o $(BUILD)/tests/compare_text.o $(BUILD)/tests/compare_picture.o $(BUILD)/unsolved.a
	$(call as,LINK $@) $(LINK) -o $@

# For each task a program that calls its functions alone, and the two programs. tests/check writes the sources and what
# each is made of. An error in one keeps no other from being made. Each is named when it is made.
$(ALONE)/%.o: $(ALONE)/%.cpp $(BUILD)/settings
	@$(COMPILE) -MMD -MP -c $< -o $@ 2> $@.err || rm -f $@
$(ALONE)/%/program:
	@mkdir -p $(@D)
	@$(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS) $^ -o $@ 2> $@.err || rm -f $@; echo $*
-include $(wildcard $(ALONE)/*.mk $(ALONE)/*/common/*/*.d)
