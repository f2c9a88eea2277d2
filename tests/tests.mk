# The test program, and how it is run. Included by the Makefile.
#   make test               the tests required before every commit: all but what tests/proof.txt lists, with short loops
#   make test-all           all of it; C2D_TESTS_FULL=1: with the loops at their full length (a stage of make proof)
#   make test-times         the same as make test, from nothing, with processor seconds: a line for each source, the 40 slowest tests
#   make build/tests/only/NAME   a program with only the tests of tests/test_NAME.cpp; NAME,NAME,NAME: of several, compiled together
# A file that tests/proof.txt lists is compiled for run_proof alone. tests/README.md tells the rest.
#: make test                        the tests required before every commit
#: make test-all                    all tests; C2D_TESTS_FULL=1: full loops; C2D_ALL_HOSTS=1: a missing tool is a failure
#: make test-times                  processor time of make demo and make test from a clean tree
#: make build/tests/only/NAME       a program with only the tests of tests/test_NAME.cpp
.PHONY: test test-all test-times support-objects test-objects all-test-objects
TEST_CC  ?= $(CC)
TEST_CXX ?= $(CXX)
# What differs from one copy of the tree to the next, for one file alone (tests/paths.hpp).
TEST_PATHS = -DC2D_TEST_ROOT='"$(CURDIR)"' -DC2D_TEST_BUILD='"$(abspath $(BUILD))"' -DC2D_TEST_CC='"$(TEST_CC)"' \
  -DC2D_TEST_CXX='"$(TEST_CXX)"' -DC2D_TEST_LIBRARY='"$(abspath $(LIBRARY))"' \
  -DC2D_TEST_CORE='"$(abspath $(LIBRARY))"' -DC2D_TEST_PROGRAM='"$(abspath $(PROGRAM))"' \
  -DC2D_TEST_SHARED='"$(abspath $(SHARED))"' -DC2D_TEST_HARDENED=$(if $(strip $(HARDENING)),1,0) \
  -DC2D_TEST_CHAPTER9='"$(abspath $(BUILD))/obj/chapter9"'

# ---------------------------------------------------------------- which files, in which batches
PROOF_TESTS  := $(shell sed -n 's/^\(test_[a-z0-9_]*\.cpp\) .*/tests\/\1/p' tests/proof.txt)
TEST_SOURCES := $(filter-out $(PROOF_TESTS),$(or $(TEST_FILES:%=tests/test_%.cpp),$(wildcard tests/test_*.cpp)))
TEST_SUPPORT := $(filter-out tests/test_%,$(wildcard tests/*.cpp))
# Files that another build compiles again go with their like (tests/borrow.mk), and so do those with <regex>, the heaviest of headers.
REGEX_TESTS := $(shell grep -l '^\#include <regex>' tests/test_*.cpp)
regex_first = $(filter $(REGEX_TESTS),$(1)) $(filter-out $(REGEX_TESTS),$(1))
test_batches = $(call batches,$(call regex_first,$(filter $(CORE_TESTS),$(1)))) \
  $(call batches,$(call regex_first,$(filter-out $(CORE_TESTS),$(1))))
test_objects = $(foreach b,$(1),$(patsubst $(BUILD)/obj/tests_%,$(BUILD)/tests/%,$(call batch_object,$(b))))
TEST_BATCHES  := $(call test_batches,$(TEST_SOURCES))
PROOF_BATCHES := $(call test_batches,$(PROOF_TESTS))
SUPPORT_OBJECTS := $(TEST_SUPPORT:tests/%.cpp=$(BUILD)/tests/%.o)
# Of other folders, what a file of tests includes: judges of random decks, the campaign of faults, the fuzzed functions, chapter 9.
RANDOM_USERS := $(shell grep -l '^\#include "random/[^r]' tests/test_*.cpp)
REVOLVED_USERS := $(shell grep -l '^\#include "random/revolved_bodies' tests/test_*.cpp)
FAULTS_USERS := $(shell grep -l '^\#include "faults/[cd]' tests/test_*.cpp)
judges_of = $(if $(filter $(RANDOM_USERS),$(1)),$(RANDOM_JUDGE)) $(if $(filter $(REVOLVED_USERS),$(1)),$(REVOLVED_JUDGE)) \
  $(if $(filter $(FAULTS_USERS),$(1)),$(FAULTS_JUDGE)) \
  $(if $(filter tests/test_fuzz.cpp,$(1)),$(FUZZ_OBJECTS)) $(if $(filter tests/test_chapter9.cpp,$(1)),$(STUDY_OBJECT))
TEST_OBJECTS  := $(SUPPORT_OBJECTS) $(call test_objects,$(TEST_BATCHES)) $(call judges_of,$(TEST_SOURCES))
PROOF_OBJECTS := $(SUPPORT_OBJECTS) $(call test_objects,$(PROOF_BATCHES)) $(call judges_of,$(PROOF_TESTS))
support-objects: $(call borrowed,$(SUPPORT_OBJECTS)) $(REPORT_OBJECTS) $(PROGRAM_OBJECTS)
test-objects: support-objects $(call borrowed,$(TEST_OBJECTS))
all-test-objects: test-objects $(call borrowed,$(PROOF_OBJECTS)) $(CHAPTER9_OBJECTS)

# ---------------------------------------------------------------- compiled
$(BUILD)/tests/doctest: tests/doctest.sh | $(BUILD)/flags
	CXX='$(CXX)' DOCTEST_INCLUDE='$(DOCTEST_INCLUDE)' NO_INSTALL='$(NO_INSTALL)' sh tests/doctest.sh $@
# (Compiling them takes longer than running them: no code is optimised, checks are calls that leave exceptions to the test case, and
# warnings, a sixth of it, are left to CMake, whose build by clang takes them as errors.)
COMPILE_TEST = $(CXX) $(CPPFLAGS) -DDOCTEST_CONFIG_SUPER_FAST_ASSERTS $(filter-out $(WARNINGS),$(COMMON)) -w -Itests $$(cat $(BUILD)/tests/doctest) $(CXXFLAGS) -O0 $(EXACT) $(DEPS)
$(BUILD)/tests/%.o: tests/%.cpp $(BUILD)/flags $(BUILD)/tests/doctest tests/tests.mk
	$(COMPILE_TEST) $(if $(filter paths,$*),$(TEST_PATHS)) -c $< -o $@
define compile_tests
$(2:.o=.list): FORCE | $(BUILD)/flags
	@echo $(1) | cmp -s - $$@ || echo $(1) > $$@
$(2): $(call files,$(1)) $(2:.o=.list) tests/batch.sh $(BUILD)/flags $(BUILD)/tests/doctest tests/tests.mk
	@sh tests/batch.sh $(call files,$(1)) > $$(@:.o=.cpp)
	$$(COMPILE_TEST) -c $$(@:.o=.cpp) -o $$@
endef
$(foreach b,$(TEST_BATCHES) $(PROOF_BATCHES),$(if $(findstring $(comma),$(b)),$(eval $(call compile_tests,$(b),$(call test_objects,$(b))))))

# ---------------------------------------------------------------- linked
TESTED := $(PROGRAM) $(LIBRARY) $(SHARED) # what tests run
# Calls that a test can refuse go through it (tests/refused_calls.hpp, system_calls.hpp); linkers elsewhere cannot do that.
WRAP_CALLS := $(if $(filter Linux,$(shell uname -s)),$(patsubst %,-Wl$(comma)--wrap=%,\
  $(shell sed -n 's/^WRAPPED.\([a-z0-9_]*\),.*/\1/p; s/.* __wrap_\([a-z0-9_]*\)(.*) {$$/\1/p' \
  tests/refused_calls.cpp tests/system_calls.cpp)))
# What counts or is checked stands first: of functions that stand in headers the linker takes the first copy.
WATCHED_FIRST := $(if $(COUNTED)$(SANITIZED),$(CORE_OBJECTS) $(PORT_OBJECTS) $(FAMILY_OBJECTS) $(REPORT_OBJECTS))
TEST_LIBRARIES := $(FAMILY_OBJECTS) $(REPORT_OBJECTS) $(LIBRARY)
LINK_TESTS = $(CXX) $(CXXFLAGS) $(LDFLAGS) $(WRAP_CALLS) -o $@ $^ -lm -pthread
PROOFS := $(BUILD)/tests/run_proof
$(TESTS): $(WATCHED_FIRST) $(call borrowed,$(TEST_OBJECTS)) $(TEST_LIBRARIES)
	$(LINK_TESTS)
$(PROOFS): $(WATCHED_FIRST) $(call borrowed,$(PROOF_OBJECTS)) $(TEST_LIBRARIES)
	$(LINK_TESTS)
define only
$(BUILD)/tests/only/$(1): $(BUILD)/tests/test_$(1).o $(SUPPORT_OBJECTS) $(call judges_of,tests/test_$(1).cpp) $(TEST_LIBRARIES) \
    | $(TESTED) $(if $(filter chapter9,$(1)),$(BUILD)/obj/chapter9)
	@mkdir -p $$(@D)
	$$(LINK_TESTS)
endef
$(foreach s,$(TEST_SOURCES) $(PROOF_TESTS),$(eval $(call only,$(s:tests/test_%.cpp=%))))
# Several, with commas: compiled together.
define several
$(call compile_tests,$(subst $() ,$(comma),$(patsubst %,tests/test_%.cpp,$(call files,$(1)))),$(BUILD)/tests/only/$(1).o)
$(BUILD)/tests/only/$(1): $(BUILD)/tests/only/$(1).o $(SUPPORT_OBJECTS) \
    $(call judges_of,$(patsubst %,tests/test_%.cpp,$(call files,$(1)))) $(TEST_LIBRARIES) | $(TESTED)
	$$(LINK_TESTS)
endef
$(foreach g,$(MAKECMDGOALS:$(BUILD)/tests/only/%=%),$(if $(findstring $(comma),$(g)),$(eval $(call several,$(g)))))

# ---------------------------------------------------------------- run
test: $(TESTS) $(TESTED)
	@C2D_TESTS_NOT="tests/proof.txt $$C2D_TESTS_NOT" sh tests/run_shards.sh $(JOBS) $(TESTS)
# C2D_ALL_HOSTS=1: what needs other compilers fails where they are missing. (The page, Windows and boards must have been built.)
test-all: $(TESTS) $(PROOFS) $(TESTED) $(BUILD)/obj/chapter9
	@sh tests/run_shards.sh $(JOBS) $(TESTS) $(PROOFS)
test-times:
	@rm -rf '$(BUILD)/times' && mkdir -p '$(BUILD)/times'
	+@C2D_TEST_TIMES='$(abspath $(BUILD))/times/tests' C2D_COMPILE_TIMES='$(abspath $(BUILD))/times/sources' \
	  $(MAKE) -s BUILD='$(BUILD)/times/build' CXX='sh tests/timed.sh $(CXX)' TEST_CXX='$(CXX)' demo test
	@sh tests/times.sh '$(BUILD)/times'
