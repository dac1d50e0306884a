# Programs that call the functions of single tasks, the others' apart: what alone*.cpp say. An error in one keeps no
# other from being made.
COURSE ?= tests/course
ALONE = $(addprefix $(BUILD)/,alone alone_integral alone_rules)
STUDENT = $(BUILD)/student.a
LINK_ALONE = $(CXX) $(CXXFLAGS) $(LANGUAGE) $(LDFLAGS)

$(BUILD)/$(COURSE)/%.o: EXTRA = -O0

$(STUDENT): $(COMMON)
	@rm -f $@
	@ar rcs $@ $(COMMON)

$(BUILD)/alone $(BUILD)/alone_rules: $(BUILD)/%: $(BUILD)/$(COURSE)/%.o $(STUDENT)
	@$(LINK_ALONE) $^ -o $@ 2> $@.err || rm -f $@

# The source without the other tasks in it.
$(BUILD)/integral.cpp: common/quadrature/gaussian_process.cpp
	@mkdir -p $(@D)
	@bash -c '. $(COURSE)/tasks && only integral $<' > $@
$(BUILD)/integral.o: $(BUILD)/integral.cpp
	@$(COMPILE) -O0 -w -c $< -o $@ 2> $@.err || rm -f $@
$(BUILD)/alone_integral: $(BUILD)/$(COURSE)/alone_integral.o $(BUILD)/integral.o $(STUDENT)
	@$(LINK_ALONE) $^ -o $@ 2> $@.err || rm -f $@
