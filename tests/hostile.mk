# make hostile: the library against the grain (src/memory/hostile.hpp), and the whole test suite in it, with panels of one
# column and of three: one object file tells the width. Tests that cannot hold there are listed, with the reason, in
# tests/hostile.txt.
.PHONY: hostile
HOSTILE_WIDTHS ?= 1 3
hostile:
	@for width in $(HOSTILE_WIDTHS); do \
	   echo "hostile: panels of $$width columns, least workspace, poisoned memory, assertions, failing store, late transfers"; \
	   rm -f $(BUILD)/hostile/obj/tests_hostile_hostile_port.o; \
	   C2D_TESTS_NOT=tests/hostile.txt $(MAKE) -s test BUILD=$(BUILD)/hostile HOSTILE_WIDTH=$$width \
	     CPPFLAGS='$(CPPFLAGS) -DC2D_HOSTILE=1' || exit 1; \
	 done
# make small: the whole test suite in small code (src/memory/config.hpp), as firmware has it. tests/small.txt: what
# cannot hold there.
.PHONY: small
small:
	@echo "small: plain loops, no closed forms of integrals, one block at a time"
	@C2D_TESTS_NOT=tests/small.txt $(MAKE) -s test BUILD=$(BUILD)/small CPPFLAGS='$(CPPFLAGS) -DC2D_SMALL'
