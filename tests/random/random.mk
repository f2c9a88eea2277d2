# make random N=1000 SEED=1: random decks, judged (tests/random/judge.hpp). Those that fail are left in build/random, each
# named after its seed. KIND=few: few pairs, all their statuses tried. KIND=lift: lifted off and put back. KIND=mirror:
# symmetric bodies. KIND=three: three bodies. KIND=punch: the 84 punches of Spence.
.PHONY: random
N ?= 1000
SEED ?= 1
KIND ?= any
RANDOM_SOURCES := $(wildcard tests/random/*.cpp)
RANDOM_OBJECTS := $(patsubst tests/random/%.cpp,$(BUILD)/tests/random_%.o,$(RANDOM_SOURCES))
RANDOM_JUDGE := $(filter-out %/random_main.o,$(RANDOM_OBJECTS))
$(BUILD)/tests/random_%.o: tests/random/%.cpp $(BUILD)/flags Makefile
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(EXACT) $(DEPS) -c $< -o $@
$(BUILD)/tests/run_random: $(RANDOM_OBJECTS) $(BUILD)/tests/problem.o $(BUILD)/tests/many_bodies.o \
    $(BUILD)/tests/paths.o $(REPORT_OBJECTS) $(FAMILY_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
random: $(BUILD)/tests/run_random
	@mkdir -p $(BUILD)/random
	@$(BUILD)/tests/run_random $(N) $(SEED) $(BUILD)/random $(KIND)
