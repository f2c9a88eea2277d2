# make faults: the program with every operation failing, every write cut off, power lost after every change, and memory refused at
# every place that asks for it (tests/faults/judge.hpp). FAULTS_STEP=50 takes every fiftieth case, PART= one of operations, lies,
# kills, power, memory, JOB= one of the jobs (tests/faults/jobs.cpp).
#: make faults                      the program with every operation and request of memory failing in turn (PART=, JOB=, FAULTS_STEP=)
.PHONY: faults
FAULTS_STEP ?= 1
FAULTS_SOURCES := $(filter-out %/main.cpp,$(wildcard tests/faults/*.cpp))
FAULTS_JUDGE   := $(BUILD)/tests/faults_judge.o# all of them but main, compiled together
FAULTS_PRELOAD := $(BUILD)/tests/faults.so
compile_faults = $(CXX) $(CPPFLAGS) -I. $(COMMON) $(CXXFLAGS) -O0 $(EXACT) $(DEPS) -o $@ -c
$(FAULTS_JUDGE): $(FAULTS_SOURCES) $(BUILD)/flags
	@printf '\043include "%s"\n' $(FAULTS_SOURCES) > $(@:.o=.cpp)
	$(compile_faults) $(@:.o=.cpp)
$(BUILD)/tests/faults_main.o: tests/faults/main.cpp $(BUILD)/flags
	$(compile_faults) $<
$(FAULTS_PRELOAD): $(wildcard tests/faults/preload/*.[ch]) $(BUILD)/flags
	$(CC) -std=gnu11 -Wall -Wextra -Wconversion -Wshadow -O2 -fPIC -shared -o $@ $(filter %.c,$^) -ldl -pthread
$(BUILD)/tests/run_faults: $(FAULTS_JUDGE) $(BUILD)/tests/faults_main.o
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^
PART ?= operations lies kills power memory
faults: $(PART:%=faults-%)
faults-%: $(BUILD)/tests/run_faults $(FAULTS_PRELOAD) $(PROGRAM)
	@$(BUILD)/tests/run_faults $(PROGRAM) $(FAULTS_PRELOAD) $(FAULTS_STEP) $* '$(JOB)'
