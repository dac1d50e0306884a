# make check        which tasks print what they should

.PHONY: check
check: all $(BUILD)/compare
	BUILD=$(BUILD) BIN=$(BIN) tests/check --built

$(BUILD)/compare: $(BUILD)/tests/compare.o $(BUILD)/tests/compare_tolerant.o $(BUILD)/common/scene/scene.o
	$(call as,LINK $@) $(LINK) -o $@
