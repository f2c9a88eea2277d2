# contact2d. Targets: all (default) demo chapter9 test random faults bench guard convergence estimate-truth embedded hostile
#   hostile-blocks small sanitize sanitize-library sanitize-threads msan coverage cross fuzz mutants amalgamation api deb
#   reproducible web python windows install uninstall list relist symbols format format-check clean.
# Variables: CXX CC AR CXXFLAGS CFLAGS CPPFLAGS LDFLAGS HARDENING PORTS BATCH BUILD PREFIX DESTDIR LIBDIR DOCTEST_INCLUDE
#   DOCTEST_SHA256 NO_INSTALL.
# What is compiled stands in src/sources.mk, which CMakeLists.txt reads too.
include src/sources.mk
# What the list of sources is compared with the folders by, before PORTS= chooses among them.
LISTED_SOURCES := $(sort $(CORE_SOURCES) $(PORT_SOURCES) $(REPORT_SOURCES) $(PROGRAM_SOURCES))
ALL_PORT_SOURCES := $(PORT_SOURCES)
PORT_SOURCES := $(filter $(addsuffix /%,$(addprefix port/,$(PORTS))),$(PORT_SOURCES))
# (tests/hostile.mk)
HOSTILE_SOURCES := $(if $(HOSTILE_WIDTH),tests/hostile/hostile_port.cpp)

BUILD    ?= build
CXX      ?= g++
CC       ?= cc
AR       ?= ar
CXXFLAGS ?= -O2
CFLAGS   ?= -O2
JOBS     ?= $(shell nproc 2>/dev/null || echo 2)
ifeq ($(MAKELEVEL),0) # make within make takes part in the jobs of the first
MAKEFLAGS += -j$(JOBS)
endif

PREFIX     ?= /usr/local
LIBDIR     ?= $(PREFIX)/lib
BINDIR     ?= $(PREFIX)/bin
MANDIR     ?= $(PREFIX)/share/man
INCLUDEDIR ?= $(PREFIX)/include
DOCDIR     ?= $(PREFIX)/share/doc/contact2d

version_part = $(shell sed -n 's/^\#define C2D_VERSION_$(1) *//p' include/contact2d.h)
MAJOR     := $(call version_part,MAJOR)
MINOR     := $(call version_part,MINOR)
VERSION   := $(MAJOR).$(MINOR).$(call version_part,PATCH)
# Before 1.0 a minor version may change calls: programs of another must not find it.
SOVERSION := $(if $(filter 0,$(MAJOR)),0.$(MINOR),$(MAJOR))

include port/packaging/hardening.mk

WARNINGS  := -Wall -Wextra -Wpedantic -Wconversion -Wshadow
INCLUDES  := -Isrc -Iinclude $(addprefix -Iport/,$(PORTS))
COMMON    := $(INCLUDES) -std=c++17 $(WARNINGS)
EXACT     := -ffp-contract=off
CORE_ONLY := -fPIC -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-math-errno
DEPS      := -MMD -MP

# src/memory/real.cpp -> memory_real.o, port/stdio/tapes.cpp -> port_stdio_tapes.o
object = $(BUILD)/obj/$(subst /,_,$(basename $(patsubst src/%,%,$(1)))).o
objects = $(foreach s,$(1),$(call object,$(s)))

# Report, program and tests are compiled BATCH files at a time, as the headers of the C++ library take longer than what follows
# them; so names that are private to a file of the first two are unique in their folder. BATCH=1: each file by itself.
BATCH ?= 10
comma := ,
# words -> words of up to BATCH of them with commas; such a word -> its files; what its object depends on; the line of a recipe that
# writes them as one source; what is compiled; and its object, named after the first.
batches = $(if $(1),$(shell echo $(1) | xargs -n $(BATCH) | tr ' ' ,))
files = $(subst $(comma), ,$(1))
batch_needs = $(call files,$(1)) $(if $(findstring $(comma),$(1)),src/sources.mk)
write_batch = $(if $(findstring $(comma),$(1)),@printf '\043include "%s"\n' $(call files,$(1)) > $$(@:.o=.cpp))
batch_source = $(if $(findstring $(comma),$(1)),-I. $$(@:.o=.cpp),$(1))
batch_object = $(patsubst %.o,%$(if $(findstring $(comma),$(1)),_etc).o,$(call object,$(firstword $(call files,$(1)))))

CORE_OBJECTS    := $(call objects,$(CORE_SOURCES))
PORT_OBJECTS    := $(call objects,$(PORT_SOURCES) $(HOSTILE_SOURCES))
PROGRAM_MAIN    := src/program/main.cpp
REPORT_BATCHES  := $(call batches,$(REPORT_SOURCES))
FAMILY_BATCHES  := $(call batches,$(filter-out $(PROGRAM_MAIN),$(PROGRAM_SOURCES)))
REPORT_OBJECTS  := $(foreach b,$(REPORT_BATCHES),$(call batch_object,$(b)))
FAMILY_OBJECTS  := $(foreach b,$(FAMILY_BATCHES),$(call batch_object,$(b))) # all of the program but its main
PROGRAM_OBJECTS := $(call objects,$(PROGRAM_MAIN)) $(FAMILY_OBJECTS)
CHAPTER9_SOURCES := $(sort $(wildcard examples/chapter9/*.cpp))
CHAPTER9_OBJECTS := $(call objects,$(CHAPTER9_SOURCES))
STUDY_OBJECT     := $(call object,examples/chapter9/study.cpp)
# Tests that are compiled again where the core's configuration is another, or for sanitizers, go with their like.
TEST_SOURCES    := $(wildcard tests/*.cpp)
SANITIZER_TESTS := $(shell grep -l -e kSanitized -e __SANITIZE_ -e hosts.hpp tests/test_*.cpp)
CORE_TESTS      := $(filter-out $(SANITIZER_TESTS),$(shell grep -l -E '^\#include "((bie|contact|deck|elimination|interface|linalg|memory|model|quadrature|results|solver|store)/[a-z0-9_]*|fuzz/calls|deck_recorder|gauss_points|hand_tableau|model_fixture)\.hpp' tests/test_*.cpp))
OTHER_TESTS     := $(filter-out $(CORE_TESTS) $(SANITIZER_TESTS),$(filter tests/test_%,$(TEST_SOURCES)))
test_objects = $(foreach b,$(1),$(patsubst $(BUILD)/obj/tests_%,$(BUILD)/tests/%,$(call batch_object,$(b))))
SANITIZER_BATCHES := $(call batches,$(SANITIZER_TESTS))
TEST_BATCHES := $(call batches,$(CORE_TESTS)) $(SANITIZER_BATCHES) $(call batches,$(OTHER_TESTS))
TEST_OBJECTS := $(patsubst tests/%.cpp,$(BUILD)/tests/%.o,$(filter-out tests/test_%,$(TEST_SOURCES))) $(call test_objects,$(TEST_BATCHES))

# TESTS_FROM=FOLDER: another build, by a compiler whose objects go with this one's. What is the same there is linked as it is: report and
# program (PROGRAM_FROM), which see the headers of the interface alone, unless this build watches them too, and tests, but for those
# that see the core's configuration; with sanitizers, tests that do not ask for them. So the same tests run on a library with
# other flags.
TESTS_FROM ?= $(BUILD)
SANITIZED := $(findstring -fsanitize,$(CXXFLAGS))
COUNTED := $(findstring -fprofile,$(CXXFLAGS))
# Threads lose counts, and a difference of two of them may come out below zero: here none is lost. (Everywhere that takes too long.)
COUNTED_EACH := $(if $(COUNTED),src/deck/% src/model/% src/results/% src/report/% src/program/% src/bie/transfer.cpp)
PROGRAM_FROM ?= $(if $(SANITIZED)$(COUNTED),$(BUILD),$(TESTS_FROM))
ifneq ($(PROGRAM_FROM),$(BUILD))
from_there = $(1:$(BUILD)/%=$(PROGRAM_FROM)/%)
REPORT_OBJECTS   := $(call from_there,$(REPORT_OBJECTS))
PROGRAM_OBJECTS  := $(call from_there,$(PROGRAM_OBJECTS))
FAMILY_OBJECTS   := $(call from_there,$(FAMILY_OBJECTS))
CHAPTER9_OBJECTS := $(call from_there,$(CHAPTER9_OBJECTS))
STUDY_OBJECT     := $(call from_there,$(STUDY_OBJECT))
endif

LIBRARY := $(BUILD)/libcontact2d.a
SHARED  := $(BUILD)/libcontact2d.so.$(VERSION)
PROGRAM := $(BUILD)/contact2d
TESTS   := $(BUILD)/tests/run_tests

.DELETE_ON_ERROR:
.PHONY: all demo chapter9 test bench convergence estimate-truth install uninstall list relist symbols format format-check clean FORCE
# PORTS='memory fortran' is a library without files and threads, and without the program, which has both.
all: $(LIBRARY) $(if $(filter-out $(PORT_SOURCES),$(ALL_PORT_SOURCES)),,$(PROGRAM))

# ---------------------------------------------------------------- objects
# A stamp that changes with compiler and flags, so that other flags mean other objects.
FLAGS_NOW := $(BATCH) $(CXX) $(CC) $(CPPFLAGS) $(CXXFLAGS) $(PROGRAM_FLAGS) $(CFLAGS) $(LDFLAGS) $(HARDENING)
$(BUILD)/flags: FORCE
	@mkdir -p $(BUILD)/obj $(BUILD)/tests
	@echo '$(subst ','\'',$(FLAGS_NOW))' | cmp -s - $@ || echo '$(subst ','\'',$(FLAGS_NOW))' > $@

# The loops of the dense kernels and of the batched integrals ask for fused additions, and for the instruction set
# they are named after: which of them runs is decided by the processor. src/linalg/kernel.hpp.
ifneq ($(findstring x86_64,$(MACHINE)),)
KERNEL_kernel_avx2 := -mavx2 -mfma
KERNEL_kernel_avx512 := -mavx512f -mfma
endif
# MinGW's stack is aligned to 16 bytes, whatever the vectors on it need.
ifneq ($(findstring mingw,$(MACHINE)),)
KERNEL_ANYWHERE := -Wa,-muse-unaligned-vector-move
endif
kernel_flags = $(if $(findstring /kernel_,$(1)),-ffp-contract=fast $(KERNEL_$(basename $(notdir $(1)))) $(KERNEL_ANYWHERE))
# $(1) file, or files with commas, $(2) flags
define compile
$(call batch_object,$(1)): $(call batch_needs,$(1)) $(BUILD)/flags Makefile
	$(call write_batch,$(1))
	$(if $(filter %.c,$(1)),$(CC) $(CPPFLAGS) $(INCLUDES) -std=c99 -Wall -Wextra -Wpedantic $(HARDENING) $(CFLAGS) -fPIC,\
	  $(CXX) $(CPPFLAGS) $(COMMON) $(HARDENING) $(CXXFLAGS) $(if $(filter $(COUNTED_EACH),$(call files,$(1))),-fprofile-update=atomic) \
	  $(EXACT) $(2)) $(SAME_FOLDER) $(DEPS) -c $(call batch_source,$(1)) -o $$@
endef
$(foreach s,$(CORE_SOURCES) $(PORT_SOURCES),$(eval $(call compile,$(s),$(CORE_ONLY) $(call hardening_of,$(s)) $(call kernel_flags,$(s)))))
$(foreach s,$(HOSTILE_SOURCES),$(eval $(call compile,$(s),$(CORE_ONLY) -UC2D_HOSTILE -DC2D_HOSTILE=$(HOSTILE_WIDTH))))
# (It is no faster by -O2, and compiled in two thirds of the time by -O1. PROGRAM_FLAGS=-O0 where that is what takes time.)
PROGRAM_FLAGS ?= $(if $(filter -O2 -O3,$(CXXFLAGS)),-O1)
$(foreach s,$(REPORT_BATCHES) $(FAMILY_BATCHES) $(PROGRAM_MAIN) $(CHAPTER9_SOURCES),$(eval $(call compile,$(s),$(HARDENED_PROGRAM) $(PROGRAM_FLAGS))))

$(LIBRARY): $(CORE_OBJECTS) $(PORT_OBJECTS) src/sources.mk
	rm -f $@
	$(ARCHIVE) $@ $(CORE_OBJECTS) $(PORT_OBJECTS)

# Linked as C: nothing of the C++ run-time is needed. Only the names of the interface leave it; a list of them is kept.
EXPORTS := port/packaging/contact2d.map
$(SHARED): $(CORE_OBJECTS) $(PORT_OBJECTS) $(EXPORTS)
	$(CC) -shared $(HARDENED_LINK) $(LDFLAGS) -Wl,-soname,libcontact2d.so.$(SOVERSION) -Wl,--version-script,$(EXPORTS) \
	  -o $@ $(CORE_OBJECTS) $(PORT_OBJECTS) -lm -pthread
# What port/python takes from here.
.PHONY: python
python: $(SHARED) $(PROGRAM)
symbols: $(SHARED)
	sh port/packaging/symbols.sh $(SHARED) port/packaging/contact2d.symbols $(VERSION)

# With the C++ run-time inside, where there is a static one: a run of 5 ms would spend a tenth on loading it.
LINK_PROGRAM = $(HARDENED_LINK) $(HARDENED_PIE) $(LDFLAGS)
$(PROGRAM): $(PROGRAM_OBJECTS) $(REPORT_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LINK_PROGRAM) -static-libstdc++ -static-libgcc -o $@ $^ -lm -pthread 2>/dev/null || \
	  $(CXX) $(CXXFLAGS) $(LINK_PROGRAM) -o $@ $^ -lm -pthread

# ---------------------------------------------------------------- microcontrollers
include port/cortex-m/embedded.mk

# ---------------------------------------------------------------- hostile build, other machines, packages
include tests/hostile.mk
include tests/sanitize.mk
include tests/cross/cross.mk
include tests/random/random.mk
include tests/faults/faults.mk
include tests/coverage/coverage.mk
include tests/fuzz/fuzz.mk
include tests/msan/msan.mk
include port/packaging/packaging.mk
include port/web/web.mk
include port/windows/windows.mk

# ---------------------------------------------------------------- tests
TEST_CC  ?= $(CC)
TEST_CXX ?= $(CXX)
# What differs from one copy of the tree to the next, for one file alone (tests/paths.hpp).
TEST_PATHS = -DC2D_TEST_ROOT='"$(CURDIR)"' -DC2D_TEST_BUILD='"$(abspath $(BUILD))"' -DC2D_TEST_CC='"$(TEST_CC)"' \
  -DC2D_TEST_CXX='"$(TEST_CXX)"' -DC2D_TEST_LIBRARY='"$(abspath $(LIBRARY))"' \
  -DC2D_TEST_CORE='"$(abspath $(LIBRARY))"' -DC2D_TEST_PROGRAM='"$(abspath $(PROGRAM))"' \
  -DC2D_TEST_SHARED='"$(abspath $(SHARED))"' -DC2D_TEST_HARDENED=$(if $(strip $(HARDENING)),1,0) \
  -DC2D_TEST_CHAPTER9='"$(abspath $(BUILD))/obj/chapter9"'

$(BUILD)/tests/doctest: tests/doctest.sh | $(BUILD)/flags
	CXX='$(CXX)' DOCTEST_INCLUDE='$(DOCTEST_INCLUDE)' NO_INSTALL='$(NO_INSTALL)' sh tests/doctest.sh $@
# (Compiling them takes longer than running them: no code is optimised, and checks are calls that leave exceptions to the test case.)
COMPILE_TEST = $(CXX) $(CPPFLAGS) -DDOCTEST_CONFIG_SUPER_FAST_ASSERTS $(COMMON) -Itests $$(cat $(BUILD)/tests/doctest) $(CXXFLAGS) -O0 $(EXACT) $(DEPS)
$(BUILD)/tests/%.o: tests/%.cpp $(BUILD)/flags $(BUILD)/tests/doctest Makefile
	$(COMPILE_TEST) $(if $(filter paths,$*),$(TEST_PATHS)) -c $< -o $@
define compile_tests
$(2:.o=.list): FORCE | $(BUILD)/flags
	@echo $(1) | cmp -s - $$@ || echo $(1) > $$@
$(2): $(call files,$(1)) $(2:.o=.list) tests/batch.sh $(BUILD)/flags $(BUILD)/tests/doctest Makefile
	@sh tests/batch.sh $(call files,$(1)) > $$(@:.o=.cpp)
	$$(COMPILE_TEST) -c $$(@:.o=.cpp) -o $$@
endef
$(foreach b,$(TEST_BATCHES),$(if $(findstring $(comma),$(b)),$(eval $(call compile_tests,$(b),$(call test_objects,$(b))))))
ALL_TEST_OBJECTS := $(TEST_OBJECTS) $(RANDOM_JUDGE) $(FAULTS_JUDGE) $(FUZZ_OBJECTS)
ifneq ($(TESTS_FROM),$(BUILD))
# (counters change nothing that tests see)
TESTS_OWN := paths $(notdir $(basename \
  $(if $(if $(COUNTED),$(findstring -DC2D_,$(CPPFLAGS)),any),$(shell grep -l src/memory/config.hpp $(TESTS_FROM)/tests/*.d)) \
  $(if $(SANITIZED),$(call test_objects,$(SANITIZER_BATCHES)) $(shell grep -l -e kSanitized -e __SANITIZE_ -e hosts.hpp tests/*.cpp))))
TESTS_OWN := $(TESTS_OWN:%=$(BUILD)/tests/%.o)
ALL_TEST_OBJECTS := $(filter $(TESTS_OWN),$(ALL_TEST_OBJECTS)) \
  $(patsubst $(BUILD)/%,$(TESTS_FROM)/%,$(filter-out $(TESTS_OWN),$(ALL_TEST_OBJECTS)))
endif
.PHONY: test-objects
test-objects: $(ALL_TEST_OBJECTS) $(REPORT_OBJECTS) $(PROGRAM_OBJECTS) $(CHAPTER9_OBJECTS)
# Calls that a test can refuse go through it (tests/refused_calls.hpp, system_calls.hpp); linkers elsewhere cannot do that.
WRAP_CALLS := $(if $(filter Linux,$(shell uname -s)),$(patsubst %,-Wl$(comma)--wrap=%,\
  $(shell sed -n 's/^WRAPPED.\([a-z0-9_]*\),.*/\1/p; s/.* __wrap_\([a-z0-9_]*\)(.*) {$$/\1/p' \
  tests/refused_calls.cpp tests/system_calls.cpp)))
# What counts stands first: of functions that stand in headers the linker takes the first copy.
$(TESTS): $(if $(COUNTED),$(CORE_OBJECTS) $(PORT_OBJECTS) $(FAMILY_OBJECTS) $(REPORT_OBJECTS)) \
  $(ALL_TEST_OBJECTS) $(STUDY_OBJECT) $(FUZZ_PROGRAM)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) $(WRAP_CALLS) -o $@ $^ -lm -pthread
# C2D_ALL_HOSTS=1: also what needs other compilers and an emulator.
test: $(if $(C2D_ALL_HOSTS),$(EMBEDDED_TESTED)) $(TESTS) $(PROGRAM) $(LIBRARY) $(SHARED) $(BUILD)/obj/chapter9
	@sh tests/run_shards.sh $(TESTS) $(JOBS)

# ---------------------------------------------------------------- for the user
demo: $(PROGRAM)
	@mkdir -p $(BUILD)/demo
	$(PROGRAM) run examples/hertz.dat --listing $(BUILD)/demo/hertz.lst --csv $(BUILD)/demo/hertz.csv \
	  --boundary $(BUILD)/demo/hertz_boundary.csv --json $(BUILD)/demo/hertz.json --report $(BUILD)/demo/report.html
	@echo 'Results: $(BUILD)/demo/hertz.lst (listing), hertz.csv, hertz_boundary.csv, hertz.json;'
	@echo 'pictures: $(BUILD)/demo/report.html (open it with a browser)'
	@echo 'The warnings are right: this sample of 1987 loads its contact beyond the end of the zone and strains far beyond small;'
	@echo 'src/report/OUTPUT.md tells what each means.'

# Chapter 9 of the dissertation: figures 36 to 41, as increments give them and as events do.
$(BUILD)/obj/chapter9: $(CHAPTER9_OBJECTS) $(REPORT_OBJECTS) $(FAMILY_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
chapter9: $(BUILD)/obj/chapter9
	@mkdir -p $(BUILD)/chapter9
	@$(BUILD)/obj/chapter9 $(BUILD)/chapter9
	@echo 'Figures 36 to 41: $(BUILD)/chapter9/chapter9.svg; numbers: curves.csv; a deck per curve: *.dat'

include tests/bench/bench.mk
include tests/mutants/mutants.mk

# Error against number of elements for every reference problem, with the observed order.
CONVERGENCE_OBJECTS := $(patsubst tests/convergence/%.cpp,$(BUILD)/convergence/%.o,$(wildcard tests/convergence/*.cpp))
$(BUILD)/convergence/%.o: tests/convergence/%.cpp $(BUILD)/flags Makefile
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) -Itests $(CXXFLAGS) $(EXACT) $(DEPS) -c $< -o $@
$(BUILD)/convergence/run_convergence: $(CONVERGENCE_OBJECTS) $(BUILD)/tests/paths.o $(FAMILY_OBJECTS) $(REPORT_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
convergence: $(BUILD)/convergence/run_convergence
	@$(BUILD)/convergence/run_convergence

# True errors beside those that the loop over meshes states; TRUTH='Hertz 0.01' a problem and tolerances.
TRUTH := '' 0.01 0.001
$(BUILD)/tests/run_truth: tests/truth/main.cpp $(BUILD)/tests/estimate_truth.o $(BUILD)/tests/truth_problems.o $(FAMILY_OBJECTS) \
  $(REPORT_OBJECTS) $(LIBRARY)
	$(CXX) $(CPPFLAGS) $(COMMON) -Itests $(CXXFLAGS) $(EXACT) $(LDFLAGS) -o $@ $^ -lm
estimate-truth: $(BUILD)/tests/run_truth
	@$(BUILD)/tests/run_truth $(TRUTH)

# The list of sources against the folders: what is missing from either.
# (port/cortex-m, port/web and port/windows are compiled for their own machines only, port/packaging has tools)
FOUND_SOURCES := $(sort $(filter-out port/cortex-m/% port/packaging/% port/web/% port/windows/%,$(wildcard src/*/*.cpp src/program/*/*.cpp port/*/*.cpp port/*/*.c)))
NOT_LISTED := $(filter-out $(LISTED_SOURCES),$(FOUND_SOURCES))
NOT_FOUND := $(filter-out $(FOUND_SOURCES),$(LISTED_SOURCES))
ifneq ($(strip $(NOT_LISTED)$(NOT_FOUND)),)
$(warning src/sources.mk is out of date (make relist): $(addprefix +,$(NOT_LISTED)) $(addprefix -,$(NOT_FOUND)))
endif
list:
	@$(foreach s,$(NOT_LISTED),echo 'in the folders, not in src/sources.mk: $(s)';) \
	 $(foreach s,$(NOT_FOUND),echo 'in src/sources.mk, not in the folders: $(s)';) \
	 $(if $(strip $(NOT_LISTED)$(NOT_FOUND)),echo 'make relist writes src/sources.mk anew'; exit 1,\
	   echo 'src/sources.mk lists every source file')
relist:
	@export LC_ALL=C; { sed -n '/^#/p' src/sources.mk; \
	   ls port/*/*.cpp | grep -v -e '^port/cortex-m/' -e '^port/packaging/' -e '^port/web/' -e '^port/windows/' | cut -d/ -f2 | sort -u | sed 's/^/PORTS += /'; \
	   ls src/*/*.cpp | grep -v -e '^src/report/' -e '^src/program/' | sed 's/^/CORE_SOURCES += /'; \
	   ls port/*/*.cpp port/*/*.c 2>/dev/null | grep -v -e '^port/cortex-m/' -e '^port/packaging/' -e '^port/web/' -e '^port/windows/' | sed 's/^/PORT_SOURCES += /'; \
	   ls src/report/*.cpp | sed 's/^/REPORT_SOURCES += /'; \
	   ls src/program/*.cpp src/program/*/*.cpp | sed 's/^/PROGRAM_SOURCES += /'; } > src/sources.mk.new
	@mv src/sources.mk.new src/sources.mk

FORMATTED = $(shell find src port tests -name '*.[ch]pp' -o -name '*.[ch]')
format:
	clang-format -i $(FORMATTED)
# Versions differ in what they make of a line: that of Debian 12 decides.
format-check:
	@clang-format --version | grep -q 'version 14\.' || { echo 'not checked: needs clang-format 14'; exit 0; }; \
	  clang-format --dry-run -Werror $(FORMATTED)

# ---------------------------------------------------------------- install
HEADERS := $(wildcard include/*.h port/*/c2d_*.h) port/fortran/contact2d.f90
CMAKEDIR := $(LIBDIR)/cmake/contact2d
# Pages keep their places, and with them the links from one to another.
PAGES := $(wildcard *.md src/*.md src/*/*.md src/program/*/*.md include/*.md port/*.md port/*/*.md tests/*.md examples/*.md examples/*/*.md examples/*.svg)
PAGES := $(sort $(PAGES))
INSTALLED := $(BINDIR)/contact2d $(MANDIR)/man1/contact2d.1 $(LIBDIR)/libcontact2d.a $(LIBDIR)/libcontact2d.so.$(VERSION) \
  $(LIBDIR)/libcontact2d.so.$(SOVERSION) $(LIBDIR)/libcontact2d.so \
  $(addprefix $(INCLUDEDIR)/,$(notdir $(HEADERS))) $(LIBDIR)/pkgconfig/contact2d.pc \
  $(CMAKEDIR)/contact2dConfig.cmake $(CMAKEDIR)/contact2dConfigVersion.cmake $(addprefix $(DOCDIR)/,$(PAGES))
# From the folder of CMake's configuration to the headers, so that both can be moved with their prefix.
below = $(if $(and $(filter $(PREFIX)/%,$(1)),$(PREFIX)),$(patsubst $(PREFIX)/%,%,$(1)))
INCLUDE_FROM_CONFIG := $(if $(and $(call below,$(CMAKEDIR)),$(call below,$(INCLUDEDIR))),\
  $${contact2d_here}/$(subst $(empty) $(empty),/,$(patsubst %,..,$(subst /, ,$(call below,$(CMAKEDIR)))))/$(call below,$(INCLUDEDIR)),\
  $(INCLUDEDIR))
fill = sed -e 's|@PREFIX@|$(PREFIX)|g' -e 's|@LIBDIR@|$(LIBDIR)|g' -e 's|@INCLUDEDIR@|$(INCLUDEDIR)|g' \
  -e 's|@VERSION@|$(VERSION)|g' -e 's|@SOVERSION@|$(SOVERSION)|g' \
  -e 's|@INCLUDE_FROM_CONFIG@|$(strip $(INCLUDE_FROM_CONFIG))|g'

install: all $(SHARED)
	mkdir -p $(DESTDIR)$(BINDIR) $(DESTDIR)$(MANDIR)/man1 $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(CMAKEDIR) $(DESTDIR)$(INCLUDEDIR)
	install -m 755 $(PROGRAM) $(DESTDIR)$(BINDIR)/contact2d
	install -m 644 $(HEADERS) $(DESTDIR)$(INCLUDEDIR)/
	install -m 644 $(LIBRARY) $(DESTDIR)$(LIBDIR)/
	install -m 755 $(SHARED) $(DESTDIR)$(LIBDIR)/
	ln -sf libcontact2d.so.$(VERSION) $(DESTDIR)$(LIBDIR)/libcontact2d.so.$(SOVERSION)
	ln -sf libcontact2d.so.$(SOVERSION) $(DESTDIR)$(LIBDIR)/libcontact2d.so
	$(fill) port/packaging/contact2d.1.in > $(DESTDIR)$(MANDIR)/man1/contact2d.1
	$(fill) port/packaging/contact2d.pc.in > $(DESTDIR)$(LIBDIR)/pkgconfig/contact2d.pc
	$(fill) port/packaging/contact2dConfig.cmake.in > $(DESTDIR)$(CMAKEDIR)/contact2dConfig.cmake
	$(fill) port/packaging/contact2dConfigVersion.cmake.in > $(DESTDIR)$(CMAKEDIR)/contact2dConfigVersion.cmake
	for page in $(PAGES); do mkdir -p $(DESTDIR)$(DOCDIR)/$$(dirname $$page) && \
	  install -m 644 $$page $(DESTDIR)$(DOCDIR)/$$page || exit 1; done

uninstall:
	rm -f $(addprefix $(DESTDIR),$(INSTALLED))
	-rmdir $(DESTDIR)$(CMAKEDIR) 2>/dev/null || true
	-find $(DESTDIR)$(DOCDIR) -depth -type d -exec rmdir {} + 2>/dev/null || true

clean:
	rm -rf $(BUILD)/obj $(BUILD)/tests $(BUILD)/demo $(BUILD)/bench $(BUILD)/convergence $(BUILD)/chapter9 \
	  $(BUILD)/embedded $(BUILD)/fuzz $(BUILD)/sanitize $(BUILD)/sanitize-library $(BUILD)/threads $(BUILD)/hostile $(BUILD)/small \
	  $(BUILD)/cross $(BUILD)/amalgamation $(BUILD)/api $(BUILD)/deb $(BUILD)/reproducible $(BUILD)/web
	rm -f $(LIBRARY) $(BUILD)/libcontact2d.so.* $(PROGRAM) $(BUILD)/flags
	-rmdir $(BUILD) 2>/dev/null || true

-include $(wildcard $(BUILD)/web/obj/*.d $(BUILD)/obj/*.d $(BUILD)/tests/*.d $(BUILD)/bench/*.d $(BUILD)/convergence/*.d)
