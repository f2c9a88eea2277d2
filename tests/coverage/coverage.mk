# make coverage: the test suite on a library, ports, report and program that count (clang's counters stand at conditions of the
# source: what a compiler adds, as edges of exceptions, is no branch), tests being those of make test; then those tests that cross
# what is otherwise in small code, on a library of that. Prints the branches not covered by tests, and a table; fails below the
# percentages of COVERAGE_LEAST. Debian: apt install clang-14 llvm-14.
#: make coverage                    branches not covered by tests (COVERAGE_LEAST=)
.PHONY: coverage coverage-table
COVERAGE_FLAGS := -O2 -fprofile-instr-generate -fcoverage-mapping -DC2D_COUNTED
COVERAGE_LEAST ?= core:100,ports:98,report:98,program:98
COVERAGE = $(BUILD)/coverage
COVERAGE_SMALL = $(BUILD)/coverage/small
SMALL_TESTS := $(patsubst %,*test_%.cpp,reference linalg integrals interior indicator elimination assembly store bodies coarse \
  corners invariance search inner_edges)
# $(1) folder, $(2) lists of tests left out, $(3) files of tests or nothing: all, $(4) more variables
coverage_run = C2D_TESTS_NOT='$(2)' C2D_TESTS_FILES='$(3)' LLVM_PROFILE_FILE='$(abspath $(1))/profile/%m.profraw' \
  $(MAKE) -s test-all BUILD=$(1) TESTS_FROM=$(BUILD) CXX=clang++-14 CC=clang-14 CXXFLAGS='$(COVERAGE_FLAGS)' CFLAGS='$(COVERAGE_FLAGS)' \
  LDFLAGS=-fprofile-instr-generate HARDENING= PROGRAM_FLAGS=-O0 \
  TEST_CXX='clang++-14 $(COVERAGE_FLAGS)' TEST_CC='clang-14 $(COVERAGE_FLAGS)' $(4)
coverage_show = llvm-profdata-14 merge -o $(1)/all.profdata $(1)/profile/*.profraw && \
  llvm-cov-14 show -show-branches=count -instr-profile $(1)/all.profdata $(1)/tests/run_tests -object $(1)/tests/run_proof -object $(1)/contact2d \
  $$(for program in $(1)/counted/*; do [ ! -f $$program ] || echo -object $$program; done) \
  -ignore-filename-regex=/tests/ > $(1)/branches.txt
coverage: all-test-objects
	@command -v llvm-cov-14 clang++-14 >/dev/null || { echo 'needs clang-14 and llvm-14'; exit 1; }
	@mkdir -p $(COVERAGE)/profile $(COVERAGE_SMALL)/profile
	@rm -f $(COVERAGE)/profile/* $(COVERAGE_SMALL)/profile/*
	+@$(call coverage_run,$(COVERAGE),tests/coverage/not.txt)
	+@$(call coverage_run,$(COVERAGE_SMALL),tests/coverage/not.txt tests/small.txt,$(subst $(empty) $(empty),$(comma),$(SMALL_TESTS)),\
	  CPPFLAGS='$(CPPFLAGS) -DC2D_SMALL' PROGRAM_FROM=$(COVERAGE))
	@$(MAKE) -s coverage-table
coverage-table: # of what has run
	@$(call coverage_show,$(COVERAGE))
	@$(call coverage_show,$(COVERAGE_SMALL))
	@cat $(COVERAGE)/branches.txt $(COVERAGE_SMALL)/branches.txt | \
	  awk -v ROOT='$(CURDIR)' -v LEAST='$(COVERAGE_LEAST)' -f tests/coverage/report.awk
