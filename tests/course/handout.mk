# make check        which tasks are right, which are wrong and why, and which are not written yet

COURSE = tests
CPPFLAGS += -D_GLIBCXX_ASSERTIONS
include tests/alone.mk

.PHONY: check check_programs
check: check_programs
	@BUILD=$(BUILD) BIN=$(BIN) tests/check --built
check_programs: all $(BUILD)/compare $(ALONE)

$(BUILD)/compare: $(BUILD)/tests/compare.o $(BUILD)/tests/compare_text.o $(BUILD)/tests/compare_picture.o $(COMMON)
	$(call as,LINK $@) $(LINK) -o $@
