# make hostile: every test on a library under the worst legal conditions (src/memory/hostile.hpp), with panels of one column and of
# three (HOSTILE_WIDTHS), which one object file sets. Tests that cannot hold there are listed, with the reason, in
# tests/hostile.txt. make hostile-blocks: of `make test` those files that cross blocks. Included by the Makefile.
#: make hostile, hostile-blocks     the tests under worst-case legal conditions of the library (HOSTILE_WIDTHS=)
#: make small                       the tests with the small code of the boards
.PHONY: hostile hostile-blocks
HOSTILE_WIDTHS ?= 1 3
BLOCK_TESTS := elimination assembly memory store tapes ahead tasks persist bodies holes body_force symmetry threads interior events
# $(1) width, $(2) test or test-all, $(3) variables
hostile_run = echo "hostile: panels of $(1) columns, least workspace, poisoned memory, assertions, failing store, late transfers"; \
  rm -f $(BUILD)/hostile/obj/tests_hostile_hostile_port.o; \
  C2D_TESTS_NOT="tests/hostile.txt $$C2D_TESTS_NOT" $(MAKE) -s $(2) BUILD=$(BUILD)/hostile TESTS_FROM=$(BUILD) \
    HOSTILE_WIDTH=$(1) CPPFLAGS='$(CPPFLAGS) -DC2D_HOSTILE=1' $(3)
hostile: all-test-objects
	+@for width in $(HOSTILE_WIDTHS); do $(call hostile_run,$$width,test-all) || exit 1; done
hostile-blocks: support-objects amalgamation
	+@for width in $(HOSTILE_WIDTHS); do $(call hostile_run,$$width,test,TEST_FILES='$(BLOCK_TESTS)' CXXFLAGS=-O1 \
	  ONE_FILE=$(AMALGAMATION)/contact2d.cpp) || exit 1; done
# make small: the whole test suite in small code (src/memory/config.hpp), as firmware has it. tests/small.txt: what
# cannot hold there.
.PHONY: small
small: all-test-objects
	@echo "small: plain loops, no closed forms of integrals, one block at a time"
	@C2D_TESTS_NOT="tests/small.txt $$C2D_TESTS_NOT" $(MAKE) -s test-all BUILD=$(BUILD)/small TESTS_FROM=$(BUILD) CPPFLAGS='$(CPPFLAGS) -DC2D_SMALL'
