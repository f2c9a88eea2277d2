# make mutants: changes in kernels, exchange, events, elimination, block format and deck reader, each of which a test must catch
# (tests/mutants/make.cpp, run.cpp). MUTANTS_ONLY= a part or a file, MUTANTS_SEED= another choice, MUTANTS_SHARE=50 half as many,
# MUTANTS_SECONDS= of tests for each, MUTANTS_TESTS=all or parts of the names of their files (tests/mutants/tests.txt).
#: make mutants                     mutations of the core that a test must detect (MUTANTS_ONLY=, _SHARE=, _SEED=, _SECONDS=, _TESTS=)
.PHONY: mutants mutants-objects
MUTANTS := $(BUILD)/mutants
MUTANTS_SEED ?= 1
MUTANTS_SHARE ?= 100
# Numbers of mutants lie below; with a 1 before six digits they are lines in the compiler's messages (sites.hpp).
MUTANTS_MOST := 1000000
MUTANTS_HERE := $(wildcard tests/mutants/*.hpp) tests/mutants/mutants.mk
mutant_object = $(MUTANTS)/obj/$(subst /,_,$(basename $(patsubst src/%,%,$(1)))).o
MUTANT_OBJECTS := $(foreach s,$(CORE_SOURCES),$(call mutant_object,$(s)))
MUTANT_TESTS := $(filter-out %/main.o %/paths.o,$(sort $(TEST_OBJECTS) $(PROOF_OBJECTS) \
  $(filter-out $(LIBRARY),$(FUZZ_PROGRAM))))
MUTANT_LIBRARY := $(MUTANTS)/libcontact2d.a
quoted = '"$(abspath $(1))"'
MUTANT_PATHS = $(subst $(call quoted,$(LIBRARY)),$(call quoted,$(MUTANT_LIBRARY)),$(TEST_PATHS))
MUTANT_PATHS := $(subst $(call quoted,$(PROGRAM)),$(call quoted,$(MUTANTS)/contact2d),$(MUTANT_PATHS))
MUTANT_PATHS := $(subst $(call quoted,$(BUILD)),'(std::getenv("C2D_MUTANTS_BUILD") ? std::getenv("C2D_MUTANTS_BUILD") : "$(abspath $(MUTANTS))")',$(MUTANT_PATHS))

$(MUTANTS)/make_mutants: tests/mutants/make.cpp tests/mutants/sites.cpp tests/mutants/tokens.cpp $(MUTANTS_HERE)
	@mkdir -p $(MUTANTS)/obj
	$(CXX) -std=c++17 $(WARNINGS) -O1 -DC2D_MUTANTS_MOST=$(MUTANTS_MOST) -o $@ $(filter %.cpp,$^)
# Compiled with -O1: the choices cost less so. Warnings would be of the changes.
define compile_mutant
$(call mutant_object,$(1)): $(MUTANTS)/$(1) $(MUTANTS_HERE)
	@$(CXX) $(CPPFLAGS) -I$(MUTANTS)/src $(INCLUDES) -include tests/mutants/switch.hpp -std=c++17 -w -O1 -pedantic-errors $(EXACT) \
	  $(CORE_ONLY) $(call kernel_flags,$(1)) $(DEPS) -c $$< -o $$@ 2>$$@.log || { cat $$@.log; exit 1; }
endef
$(foreach s,$(CORE_SOURCES),$(eval $(call compile_mutant,$(s))))
$(MUTANTS)/obj/switch.o: tests/mutants/switch.cpp $(MUTANTS_HERE)
	$(CXX) -std=c++17 $(WARNINGS) -O1 -fPIC -fno-exceptions -fno-rtti -DC2D_MUTANTS_MOST=$(MUTANTS_MOST) -c $< -o $@
$(MUTANTS)/obj/run.o: tests/mutants/run.cpp $(BUILD)/tests/doctest $(MUTANTS_HERE)
	$(CXX) $(COMMON) $$(cat $(BUILD)/tests/doctest) -O1 -DC2D_MUTANTS_MOST=$(MUTANTS_MOST) -c $< -o $@
$(MUTANTS)/obj/paths.o: tests/paths.cpp $(MUTANTS_HERE)
	$(CXX) $(COMMON) -include cstdlib $(MUTANT_PATHS) -c $< -o $@

# What does not compile is no mutant: the compiler names it by the line of its message.
$(MUTANTS)/sources: $(MUTANTS)/make_mutants FORCE
	@rm -f $(MUTANTS)/dropped.txt
	@$< $(MUTANTS) $(MUTANTS_SEED) $(MUTANTS_SHARE)
	@until $(MAKE) -s -k mutants-objects >$(MUTANTS)/errors.txt 2>&1; do \
	  sed -n -e 's/^[^ :]*:1\([0-9]\{6\}\):[0-9]*: error.*/\1/p' -e 's/.*error.*c2d_is(\([0-9]*\)).*/\1/p' $(MUTANTS)/errors.txt | \
	    sed 's/^0*\(.\)/\1/' | sort -u > $(MUTANTS)/more.txt; \
	  [ -s $(MUTANTS)/more.txt ] || { cat $(MUTANTS)/errors.txt; exit 1; }; \
	  cat $(MUTANTS)/more.txt >> $(MUTANTS)/dropped.txt; \
	  $< $(MUTANTS) $(MUTANTS_SEED) $(MUTANTS_SHARE) >/dev/null; done
	@touch $(MUTANTS)/dropped.txt
	@echo "$$(wc -l < $(MUTANTS)/dropped.txt) of them do not compile"
mutants-objects: $(MUTANT_OBJECTS)

$(MUTANTS)/run_mutants: $(MUTANTS)/sources $(addprefix $(MUTANTS)/obj/,switch.o run.o paths.o) $(MUTANT_TESTS) $(PROGRAM_OBJECTS) $(PORT_OBJECTS)
	@rm -f $(MUTANT_LIBRARY) $(MUTANTS)/trace.txt
	@$(AR) rcs $(MUTANT_LIBRARY) $(MUTANT_OBJECTS) $(PORT_OBJECTS) $(MUTANTS)/obj/switch.o
	@$(CXX) $(LDFLAGS) -o $(MUTANTS)/contact2d $(MUTANT_OBJECTS) $(PROGRAM_OBJECTS) $(REPORT_OBJECTS) $(MUTANT_LIBRARY) -lm -pthread
	@$(CXX) $(LDFLAGS) $(WRAP_CALLS) -o $@ $(MUTANT_OBJECTS) $(addprefix $(MUTANTS)/obj/,switch.o run.o paths.o) $(MUTANT_TESTS) $(PORT_OBJECTS) \
	  -lm -pthread
mutants: $(MUTANTS)/run_mutants
	@$(MUTANTS)/run_mutants $(MUTANTS) $(JOBS) '$(MUTANTS_ONLY)'

-include $(wildcard $(MUTANTS)/obj/*.d)
