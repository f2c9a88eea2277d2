# make fuzz: every target of tests/fuzz under libFuzzer with the address and undefined-behaviour sanitizers, JOBS of them at a time,
# each for FUZZ_SECONDS (an hour for all). FUZZ='deck sketch' selects. What is new in the corpus, and what fails, is left in build/fuzz/corpus and
# build/fuzz/failed. A file tests/fuzz/NAME.cpp defines LLVMFuzzerTestOneInput and nothing else that is visible; beside it
# NAME.dict holds words, seeds/NAME and found/NAME inputs. FUZZ_MORE_NAME are files of the tree that are seeds too.
#: make fuzz                        the fuzzers (FUZZ=, FUZZ_SECONDS=)
.PHONY: fuzz fuzz-build
FUZZ_TARGETS := $(basename $(notdir $(wildcard tests/fuzz/*.cpp)))
FUZZ ?= $(FUZZ_TARGETS)
FUZZ_AT_ONCE := $(shell n=$(words $(FUZZ)); [ $(JOBS) -lt $$n ] && echo $(JOBS) || echo $$n)
FUZZ_SECONDS ?= $(shell echo $$((3600 * $(FUZZ_AT_ONCE) / $(words $(FUZZ)))))
FUZZ_CXX ?= clang++
FUZZ_CC ?= clang
FUZZ_FLAGS := -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all
# (Comparisons that are traced guide the fuzzers better, and double the time in which the suite runs:
# FUZZ_COVERAGE='-fsanitize-coverage=inline-8bit-counters,pc-table' traces none.)
FUZZ_COVERAGE ?= -fsanitize=fuzzer-no-link
FUZZ_LIMITS := -rss_limit_mb=1500 -malloc_limit_mb=1000 -timeout=10 -print_final_stats=1 -close_fd_mask=3

FUZZ_MORE_deck = examples/*.dat tests/data/decks tests/data/hard tests/data/judge tests/data/coarse
FUZZ_MORE_program = $(FUZZ_MORE_deck)
FUZZ_MORE_sketch = examples/*.c2s
FUZZ_MORE_drawing = tests/data/drawings

# In the tests: the same functions under names of their own.
FUZZ_OBJECTS := $(FUZZ_TARGETS:%=$(BUILD)/tests/fuzz_%.o)
$(BUILD)/tests/fuzz_%.o: tests/fuzz/%.cpp $(BUILD)/flags
	$(CXX) $(CPPFLAGS) $(COMMON) -DLLVMFuzzerTestOneInput=fuzz_$* $(CXXFLAGS) -O0 $(EXACT) $(DEPS) -c $< -o $@

# The program without its main.
FUZZ_PROGRAM := $(FAMILY_OBJECTS) $(REPORT_OBJECTS) $(LIBRARY)
$(BUILD)/run_%: tests/fuzz/%.cpp $(FUZZ_PROGRAM) $(BUILD)/flags
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(EXACT) -MMD -MP -MF $@.d -fsanitize=fuzzer $< $(FUZZ_PROGRAM) $(LDFLAGS) -o $@ -lm -pthread
-include $(wildcard $(BUILD)/run_*.d)

# (gcc says of itself that it sanitizes)
FUZZ_MAKE = $(MAKE) -s BUILD=$(BUILD)/fuzz CXX=$(FUZZ_CXX) CC=$(FUZZ_CC) CPPFLAGS='$(CPPFLAGS) -D__SANITIZE_ADDRESS__' \
  CXXFLAGS='$(FUZZ_FLAGS) $(FUZZ_COVERAGE)' CFLAGS='$(FUZZ_FLAGS) $(FUZZ_COVERAGE)' LDFLAGS='-fsanitize=address,undefined' PROGRAM_FLAGS=-O0
fuzz-build:
	+@$(FUZZ_MAKE) $(FUZZ:%=$(BUILD)/fuzz/run_%)
fuzz: $(FUZZ:%=fuzz-run-%)
	@echo "fuzz: $(words $(FUZZ)) targets, $(FUZZ_SECONDS) s each"
fuzz-run-%: fuzz-build
	@mkdir -p $(BUILD)/fuzz/corpus/$* $(BUILD)/fuzz/failed/$*
	@cp -r $(wildcard tests/fuzz/seeds/$*/* tests/fuzz/found/$*/* $(FUZZ_MORE_$*)) $(BUILD)/fuzz/corpus/$*/
	@$(BUILD)/fuzz/run_$* $(FUZZ_LIMITS) $(FUZZ_MORE_FLAGS) $(if $(wildcard tests/fuzz/$*.dict),-dict=tests/fuzz/$*.dict) \
	  -max_total_time=$(FUZZ_SECONDS) -artifact_prefix=$(BUILD)/fuzz/failed/$*/ $(BUILD)/fuzz/corpus/$* > $(BUILD)/fuzz/$*.log 2>&1; \
	  code=$$?; echo "fuzz $*: $$(grep -e '^SUMMARY' -e 'number_of_executed_units' -e 'Test unit written' $(BUILD)/fuzz/$*.log)"; \
	  exit $$code
