# TESTS_FROM=FOLDER: the tests on a library with other flags (sanitizers, -DC2D_SMALL, panels of one column, counters). What such flags
# do not reach is linked from the build in FOLDER, by a compiler whose objects go with this one's: report and program
# (PROGRAM_FROM), which see the headers of the interface alone, unless this build watches them too; and tests, but for those that
# see the core's configuration where that is another. Included by the Makefile.
TESTS_FROM ?= $(BUILD)
SANITIZED := $(findstring -fsanitize,$(CXXFLAGS))
COUNTED := $(findstring -fprofile,$(CXXFLAGS))
# Threads lose counts, and a difference of two of them may come out below zero: here none is lost. (Everywhere that takes too long.)
COUNTED_EACH := $(if $(COUNTED),src/deck/% src/model/% src/results/% src/post/% src/report/% src/program/% src/bie/transfer.cpp)
PROGRAM_FROM ?= $(if $(SANITIZED)$(COUNTED),$(BUILD),$(TESTS_FROM))
ifneq ($(PROGRAM_FROM),$(BUILD))
from_there = $(1:$(BUILD)/%=$(PROGRAM_FROM)/%)
REPORT_OBJECTS   := $(call from_there,$(REPORT_OBJECTS))
PROGRAM_OBJECTS  := $(call from_there,$(PROGRAM_OBJECTS))
FAMILY_OBJECTS   := $(call from_there,$(FAMILY_OBJECTS))
CHAPTER9_OBJECTS := $(call from_there,$(CHAPTER9_OBJECTS))
STUDY_OBJECT     := $(call from_there,$(STUDY_OBJECT))
endif
# Files of tests that see the core's configuration: batches of their own (tests/tests.mk).
CORE_TESTS := $(shell grep -l -E '^\#include "((bie|contact|deck|elimination|interface|linalg|memory|model|quadrature|results|solver|store)/[a-z0-9_]*|fuzz/calls|deck_recorder|gauss_points|hand_tableau|model_fixture)\.hpp' tests/test_*.cpp)
# $(call borrowed,OBJECTS): those of another build in the place of this one's, where they are the same: sanitizers and counters change
# nothing that tests see. What is chosen by TEST_FILES is in no other build.
ifneq ($(TESTS_FROM),$(BUILD))
tests_own = paths $(notdir $(basename \
  $(if $(findstring -DC2D_,$(CPPFLAGS)),$(shell grep -l src/memory/config.hpp $(TESTS_FROM)/tests/*.d)) \
  $(if $(TEST_FILES),$(call test_objects,$(TEST_BATCHES)))))
TESTS_OWN = $(eval TESTS_OWN := $(tests_own))$(TESTS_OWN) # found once
borrowed = $(foreach o,$(1),$(if $(filter $(notdir $(basename $(o))),$(TESTS_OWN)),$(o),$(o:$(BUILD)/%=$(TESTS_FROM)/%)))
else
borrowed = $(1)
endif
