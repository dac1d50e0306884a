# Programs that call the functions of single tasks: what alone*.cpp say.
ALONE = $(addprefix $(BUILD)/,alone alone_integral alone_rules)
STUDENT = $(BUILD)/student.a
$(BUILD)/tests/course/alone%.o: EXTRA = -O0

$(STUDENT): $(COMMON)
	@rm -f $@ && ar rcs $@ $^

$(BUILD)/alone $(BUILD)/alone_rules: $(BUILD)/%: $(BUILD)/tests/course/%.o $(STUDENT)
	$(call as,LINK $@) $(LINK) -o $@

# The source without the other tasks in it.
$(BUILD)/integral.cpp: common/quadrature/gaussian_process.cpp
	@mkdir -p $(@D)
	@bash -c '. tests/course/tasks && only integral $<' > $@
$(BUILD)/integral.o: $(BUILD)/integral.cpp
	@$(COMPILE) -O0 -w -c $< -o $@
$(BUILD)/alone_integral: $(BUILD)/tests/course/alone_integral.o $(BUILD)/integral.o $(STUDENT)
	$(call as,LINK $@) $(LINK) -o $@
