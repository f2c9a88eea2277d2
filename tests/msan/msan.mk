# make msan: the core under clang's memory sanitizer (tests/msan/main.cpp). The library as one file and a driver that takes nothing
# of the C++ library but templates, as that would have to be instrumented, too. MSAN_DECKS selects.
#: make msan                        decks and forged states under the memory sanitizer (MSAN_DECKS=, MSAN_STRANGERS=)
.PHONY: msan
MSAN_CXX ?= clang++
MSAN_FLAGS := -std=c++17 -O1 -g1 -fsanitize=memory -fsanitize-memory-track-origins -fno-omit-frame-pointer -fno-sanitize-recover=all
MSAN_DECKS ?= $(wildcard tests/data/decks/*.dat tests/data/coarse/*.dat tests/data/hard/[DFN]*.dat examples/hertz.dat)
MSAN_STRANGERS ?= 300
$(BUILD)/msan/contact2d.o: $(CORE_SOURCES) $(wildcard src/*/*.hpp src/*/*/*.hpp include/*.h) tests/msan/msan.mk | $(BUILD)/flags
	@mkdir -p $(@D)
	$(MAKE) -s amalgamation
	$(MSAN_CXX) $(MSAN_FLAGS) $(EXACT) -fno-exceptions -fno-rtti -w -c $(AMALGAMATION)/contact2d.cpp -o $@
$(BUILD)/msan/run: tests/msan/main.cpp tests/fuzz/small_model.hpp tests/fuzz/forged_state.hpp $(BUILD)/msan/contact2d.o
	$(MSAN_CXX) $(MSAN_FLAGS) $(WARNINGS) -Iinclude -Isrc $(filter-out %.hpp,$^) -o $@ -lm
msan: $(BUILD)/msan/run
	@$(BUILD)/msan/run $(MSAN_STRANGERS) $(MSAN_DECKS)
