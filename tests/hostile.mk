# make hostile: the library against the grain (src/memory/hostile.hpp), and the whole test suite in it, with panels of one
# column and of three. Tests that cannot hold there are listed, with the reason, in tests/hostile.txt.
.PHONY: hostile
HOSTILE_WIDTHS := 1 3
hostile:
	@for width in $(HOSTILE_WIDTHS); do \
	   echo "hostile: panels of $$width columns, least workspace, poisoned memory, assertions, failing store"; \
	   C2D_TESTS_NOT=tests/hostile.txt $(MAKE) -s test BUILD=$(BUILD)/hostile-$$width \
	     CPPFLAGS='$(CPPFLAGS) -DC2D_HOSTILE='$$width || exit 1; \
	 done
