# make random N=1000 SEED=1: random decks, judged (tests/random/judge.hpp). Those that fail are left in build/random, each
# named after its seed. KIND=few: few pairs, all their statuses tried. KIND=lift: lifted off and put back. KIND=mirror:
# symmetric bodies. KIND=three: three bodies. KIND=revolved: bodies of revolution. KIND=resume: runs that are ended and taken up.
# KIND=punch: the 84 punches of Spence.
# make estimate N=200 SEED=1: random sketches, taken through the loop over meshes and held against finer ones. They are left in
# build/estimate. ELEMENTS and SECONDS are the limits of each. KIND=revolved: bodies of revolution; KIND=cycles: cycles until they are steady.
#: make random                      random decks with independent checks (N=, SEED=, KIND=)
#: make estimate                    random sketches against finer meshes (N=, SEED=, ELEMENTS=, SECONDS=)
.PHONY: random estimate
N ?= 1000
SEED ?= 1
ELEMENTS ?= 300
SECONDS ?= 10
KIND ?= any
RANDOM_SOURCES := $(wildcard tests/random/*.cpp)
RANDOM_OBJECTS := $(patsubst tests/random/%.cpp,$(BUILD)/tests/random_%.o,$(RANDOM_SOURCES))
REVOLVED_JUDGE := $(BUILD)/tests/random_judged_bodies.o $(BUILD)/tests/random_revolved_bodies.o
RANDOM_JUDGE := $(filter-out %/random_main.o %/random_main_sketches.o,$(RANDOM_OBJECTS))
SKETCH_JUDGE := $(filter %/random_children.o %/random_sketches.o %/random_sketch_pen.o %/random_sketch_judge.o,$(RANDOM_OBJECTS))
$(BUILD)/tests/random_%.o: tests/random/%.cpp $(BUILD)/flags
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(PROGRAM_FLAGS) $(EXACT) $(DEPS) -c $< -o $@
$(BUILD)/tests/run_random: $(RANDOM_JUDGE) $(BUILD)/tests/random_main.o $(BUILD)/tests/problem.o $(BUILD)/tests/many_bodies.o \
    $(BUILD)/tests/paths.o $(REPORT_OBJECTS) $(FAMILY_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
random: $(BUILD)/tests/run_random
	@mkdir -p $(BUILD)/random
	@$(BUILD)/tests/run_random $(N) $(SEED) $(BUILD)/random $(KIND)
$(BUILD)/tests/run_sketches: $(BUILD)/tests/random_main_sketches.o $(SKETCH_JUDGE) $(REPORT_OBJECTS) $(FAMILY_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
estimate: $(BUILD)/tests/run_sketches
	@mkdir -p $(BUILD)/estimate
	@$(BUILD)/tests/run_sketches $(if $(filter file,$(origin N)),200,$(N)) $(SEED) $(BUILD)/estimate $(ELEMENTS) $(SECONDS) $(if $(filter revolved cycles,$(KIND)),700 $(KIND))
