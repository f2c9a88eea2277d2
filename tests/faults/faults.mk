# make faults: the program with every operation failing, every write cut off, power lost after every change, and every allocation
# refused (tests/faults/judge.hpp). FAULTS_STEP=50 takes every fiftieth case, PART= one of operations, lies, kills, power, memory,
# JOB= one of the jobs (tests/faults/jobs.cpp).
#: make faults                      the program with every operation and allocation failing in turn (PART=, JOB=, FAULTS_STEP=)
.PHONY: faults
FAULTS_STEP ?= 1
FAULTS_SOURCES := $(wildcard tests/faults/*.cpp)
FAULTS_OBJECTS := $(patsubst tests/faults/%.cpp,$(BUILD)/tests/faults_%.o,$(FAULTS_SOURCES))
FAULTS_JUDGE := $(filter-out %/faults_main.o,$(FAULTS_OBJECTS))
FAULTS_PRELOAD := $(BUILD)/tests/faults.so
$(BUILD)/tests/faults_%.o: tests/faults/%.cpp $(BUILD)/flags
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(PROGRAM_FLAGS) $(EXACT) $(DEPS) -c $< -o $@
$(FAULTS_PRELOAD): $(wildcard tests/faults/preload/*.[ch]) $(BUILD)/flags
	$(CC) -std=gnu11 -Wall -Wextra -Wconversion -Wshadow -O2 -fPIC -shared -o $@ $(filter %.c,$^) -ldl -pthread
$(BUILD)/tests/run_faults: $(FAULTS_OBJECTS)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^
PART ?= operations lies kills power memory
faults: $(PART:%=faults-%)
faults-%: $(BUILD)/tests/run_faults $(FAULTS_PRELOAD) $(PROGRAM)
	@$(BUILD)/tests/run_faults $(PROGRAM) $(FAULTS_PRELOAD) $(FAULTS_STEP) $* '$(JOB)'
