# make sanitize: every test under the address and undefined-behaviour sanitizers, tests and all, but those of tests/sanitized.txt.
# make sanitize-library: the tests of `make test` on library and program as `make fuzz` has them, by clang++; the tests are those of
# the build. Included by the Makefile.
#: make sanitize, sanitize-library  the tests under the address and undefined-behaviour sanitizers
#: make sanitize-threads            the parallel parts under the thread sanitizer (THREADS_NOT=)
.PHONY: sanitize sanitize-library sanitize-threads
SANITIZE_FLAGS := -O1 -g1 -fsanitize=address,undefined
sanitize:
	+@C2D_TESTS_NOT="tests/sanitized.txt $$C2D_TESTS_NOT" $(MAKE) -s test-all BUILD=$(BUILD)/sanitize \
	  CXXFLAGS='$(SANITIZE_FLAGS) -fno-sanitize-recover=all' CFLAGS='$(SANITIZE_FLAGS)' LDFLAGS='-fsanitize=address,undefined'
sanitize-library: test-objects amalgamation
	+@$(FUZZ_MAKE) BUILD=$(BUILD)/sanitize-library ONE_FILE=$(AMALGAMATION)/contact2d.cpp test TESTS_FROM=$(BUILD)

# make sanitize-threads: what runs side by side, and nothing else, under the thread sanitizer: the pool of threads, tasks, transfers
# on their way, a solver in each thread, cancel. THREADS_NOT='PATTERN,PATTERN': but those.
THREADS_TESTED := main paths problem many_bodies test_threads test_tasks test_ahead test_persist test_cancel
$(BUILD)/tests/run_threads: $(THREADS_TESTED:%=$(BUILD)/tests/%.o) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
sanitize-threads:
	+@$(MAKE) -s BUILD=$(BUILD)/threads CXXFLAGS='-O1 -g1 -fsanitize=thread' LDFLAGS=-fsanitize=thread $(BUILD)/threads/tests/run_threads
	@$(BUILD)/threads/tests/run_threads -tc='threads:*,tasks:*,ahead:*,port/posix:*,two solvers:*,cancel:*' \
	  -tce='cancel: at every chance*,$(THREADS_NOT)' | tail -1 # (which is one thread's)
