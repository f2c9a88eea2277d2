# make convergence: error against number of elements for every reference problem, with the observed order.
# make estimate-truth: true errors beside those that the loop over meshes states; TRUTH='Hertz 0.01' a problem and tolerances.
# Included by the Makefile.
#: make convergence                 errors against the number of elements
#: make estimate-truth              stated errors against true errors (TRUTH=)
.PHONY: convergence estimate-truth
CONVERGENCE_OBJECTS := $(patsubst tests/convergence/%.cpp,$(BUILD)/convergence/%.o,$(wildcard tests/convergence/*.cpp))
$(BUILD)/convergence/%.o: tests/convergence/%.cpp $(BUILD)/flags tests/truth.mk
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) -Itests $(CXXFLAGS) $(EXACT) $(DEPS) -c $< -o $@
$(BUILD)/convergence/run_convergence: $(CONVERGENCE_OBJECTS) $(BUILD)/tests/paths.o $(FAMILY_OBJECTS) $(REPORT_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
convergence: $(BUILD)/convergence/run_convergence
	@$(BUILD)/convergence/run_convergence

TRUTH := '' 0.01 0.001
$(BUILD)/tests/run_truth: tests/truth/main.cpp $(BUILD)/tests/estimate_truth.o $(BUILD)/tests/truth_problems.o $(FAMILY_OBJECTS) \
  $(REPORT_OBJECTS) $(LIBRARY)
	$(CXX) $(CPPFLAGS) $(COMMON) -Itests $(CXXFLAGS) $(EXACT) $(LDFLAGS) -o $@ $^ -lm
estimate-truth: $(BUILD)/tests/run_truth
	@$(BUILD)/tests/run_truth $(TRUTH)
