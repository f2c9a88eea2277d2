# contact2d. Targets: all (default) demo chapter9 test random bench guard convergence estimate-truth embedded hostile small
#   cross amalgamation deb install uninstall list relist symbols format format-check clean.
# Variables: CXX CC AR CXXFLAGS CFLAGS CPPFLAGS LDFLAGS BUILD PREFIX DESTDIR LIBDIR DOCTEST_INCLUDE NO_INSTALL.
# What is compiled stands in src/sources.mk, which CMakeLists.txt reads too.
include src/sources.mk
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

WARNINGS  := -Wall -Wextra -Wpedantic -Wconversion -Wshadow
INCLUDES  := -Isrc -Iinclude $(addprefix -Iport/,$(PORTS))
COMMON    := $(INCLUDES) -std=c++17 $(WARNINGS)
EXACT     := -ffp-contract=off
CORE_ONLY := -fPIC -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-math-errno
DEPS      := -MMD -MP

# src/memory/real.cpp -> memory_real.o, port/stdio/tapes.cpp -> port_stdio_tapes.o
object = $(BUILD)/obj/$(subst /,_,$(basename $(patsubst src/%,%,$(1)))).o
objects = $(foreach s,$(1),$(call object,$(s)))

CORE_OBJECTS    := $(call objects,$(CORE_SOURCES))
PORT_OBJECTS    := $(call objects,$(PORT_SOURCES) $(HOSTILE_SOURCES))
REPORT_OBJECTS  := $(call objects,$(REPORT_SOURCES))
PROGRAM_OBJECTS := $(call objects,$(PROGRAM_SOURCES))
FAMILY_OBJECTS  := $(filter $(addprefix $(BUILD)/obj/program_,families_% sketch_% drawing_% estimate_% \
  deck_file.o interrupt.o progress.o workspace.o),$(PROGRAM_OBJECTS))
TEST_SOURCES    := $(wildcard tests/*.cpp)
CHAPTER9_SOURCES := $(wildcard examples/chapter9/*.cpp)
CHAPTER9_OBJECTS := $(call objects,$(CHAPTER9_SOURCES))
STUDY_OBJECT     := $(call object,examples/chapter9/study.cpp)
TEST_OBJECTS    := $(patsubst tests/%.cpp,$(BUILD)/tests/%.o,$(TEST_SOURCES))

LIBRARY := $(BUILD)/libcontact2d.a
SHARED  := $(BUILD)/libcontact2d.so.$(VERSION)
PROGRAM := $(BUILD)/contact2d
TESTS   := $(BUILD)/tests/run_tests

.DELETE_ON_ERROR:
.PHONY: all demo chapter9 test bench convergence estimate-truth install uninstall list relist symbols format format-check clean FORCE
all: $(LIBRARY) $(PROGRAM)

# ---------------------------------------------------------------- objects
# A stamp that changes with compiler and flags, so that other flags mean other objects.
FLAGS_NOW := $(CXX) $(CC) $(CPPFLAGS) $(CXXFLAGS) $(CFLAGS) $(LDFLAGS)
$(BUILD)/flags: FORCE
	@mkdir -p $(BUILD)/obj $(BUILD)/tests
	@echo '$(subst ','\'',$(FLAGS_NOW))' | cmp -s - $@ || echo '$(subst ','\'',$(FLAGS_NOW))' > $@

# The loops of the dense kernels and of the batched integrals ask for fused additions, and for the instruction set
# they are named after: which of them runs is decided by the processor. src/linalg/kernel.hpp.
ifneq ($(findstring x86_64,$(shell $(CXX) -dumpmachine 2>/dev/null)),)
KERNEL_kernel_avx2 := -mavx2 -mfma
KERNEL_kernel_avx512 := -mavx512f -mfma
endif
kernel_flags = $(if $(findstring /kernel_,$(1)),-ffp-contract=fast $(KERNEL_$(basename $(notdir $(1)))))
define compile
$(call object,$(1)): $(1) $(BUILD)/flags Makefile
	$(if $(filter %.c,$(1)),$(CC) $(CPPFLAGS) $(INCLUDES) -std=c99 -Wall -Wextra -Wpedantic $(CFLAGS) -fPIC,\
	  $(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(EXACT) $(2)) $(DEPS) -c $(1) -o $$@
endef
$(foreach s,$(CORE_SOURCES) $(PORT_SOURCES),$(eval $(call compile,$(s),$(CORE_ONLY) $(call kernel_flags,$(s)))))
$(foreach s,$(HOSTILE_SOURCES),$(eval $(call compile,$(s),$(CORE_ONLY) -UC2D_HOSTILE -DC2D_HOSTILE=$(HOSTILE_WIDTH))))
$(foreach s,$(REPORT_SOURCES) $(PROGRAM_SOURCES) $(CHAPTER9_SOURCES),$(eval $(call compile,$(s),)))

$(LIBRARY): $(CORE_OBJECTS) $(PORT_OBJECTS) src/sources.mk
	rm -f $@
	$(AR) rcs $@ $(CORE_OBJECTS) $(PORT_OBJECTS)

# Linked as C: nothing of the C++ run-time is needed. Only the names of the interface leave it; a list of them is kept.
EXPORTS := port/packaging/contact2d.map
$(SHARED): $(CORE_OBJECTS) $(PORT_OBJECTS) $(EXPORTS)
	$(CC) -shared $(LDFLAGS) -Wl,-soname,libcontact2d.so.$(SOVERSION) -Wl,--version-script,$(EXPORTS) \
	  -o $@ $(CORE_OBJECTS) $(PORT_OBJECTS) -lm -pthread
symbols: $(SHARED)
	sh port/packaging/symbols.sh $(SHARED) port/packaging/contact2d.symbols $(VERSION)

# With the C++ run-time inside, where there is a static one: a run of 5 ms would spend a tenth on loading it.
$(PROGRAM): $(PROGRAM_OBJECTS) $(REPORT_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -static-libstdc++ -static-libgcc -o $@ $^ -lm -pthread 2>/dev/null || \
	  $(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread

# ---------------------------------------------------------------- microcontrollers
include port/cortex-m/embedded.mk

# ---------------------------------------------------------------- hostile build, other machines, packages
include tests/hostile.mk
include tests/cross/cross.mk
include tests/random/random.mk
include port/packaging/packaging.mk

# ---------------------------------------------------------------- tests
# What differs from one copy of the tree to the next, for one file alone (tests/paths.hpp).
TEST_PATHS = -DC2D_TEST_ROOT='"$(CURDIR)"' -DC2D_TEST_BUILD='"$(abspath $(BUILD))"' -DC2D_TEST_CC='"$(CC)"' \
  -DC2D_TEST_CXX='"$(CXX)"' -DC2D_TEST_LIBRARY='"$(abspath $(LIBRARY))"' \
  -DC2D_TEST_CORE='"$(abspath $(LIBRARY))"' -DC2D_TEST_PROGRAM='"$(abspath $(PROGRAM))"' \
  -DC2D_TEST_SHARED='"$(abspath $(SHARED))"' \
  -DC2D_TEST_CHAPTER9='"$(abspath $(BUILD))/obj/chapter9"'

$(BUILD)/tests/doctest: tests/doctest.sh | $(BUILD)/flags
	CXX='$(CXX)' DOCTEST_INCLUDE='$(DOCTEST_INCLUDE)' NO_INSTALL='$(NO_INSTALL)' sh tests/doctest.sh $@
# (compiling them takes longer than running them)
$(BUILD)/tests/%.o: tests/%.cpp $(BUILD)/flags $(BUILD)/tests/doctest Makefile
	$(CXX) $(CPPFLAGS) $(COMMON) $$(cat $(BUILD)/tests/doctest) $(CXXFLAGS) -O0 $(EXACT) $(if $(filter paths,$*),$(TEST_PATHS)) \
	  $(DEPS) -c $< -o $@
$(TESTS): $(TEST_OBJECTS) $(RANDOM_JUDGE) $(STUDY_OBJECT) $(REPORT_OBJECTS) $(FAMILY_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $(TEST_OBJECTS) $(RANDOM_JUDGE) $(STUDY_OBJECT) $(REPORT_OBJECTS) \
	  $(FAMILY_OBJECTS) $(LIBRARY) -lm -pthread
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
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm
chapter9: $(BUILD)/obj/chapter9
	@mkdir -p $(BUILD)/chapter9
	@$(BUILD)/obj/chapter9 $(BUILD)/chapter9
	@echo 'Figures 36 to 41: $(BUILD)/chapter9/chapter9.svg; numbers: curves.csv; a deck per curve: *.dat'

include tests/bench/bench.mk

# Error against number of elements for every reference problem, with the observed order.
CONVERGENCE_OBJECTS := $(patsubst tests/convergence/%.cpp,$(BUILD)/convergence/%.o,$(wildcard tests/convergence/*.cpp))
$(BUILD)/convergence/%.o: tests/convergence/%.cpp $(BUILD)/flags Makefile
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) -Itests $(CXXFLAGS) $(EXACT) $(DEPS) -c $< -o $@
$(BUILD)/convergence/run_convergence: $(CONVERGENCE_OBJECTS) $(BUILD)/tests/paths.o $(FAMILY_OBJECTS) $(REPORT_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm
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
# (port/cortex-m is compiled for its own machines only, port/packaging has tools)
FOUND_SOURCES := $(sort $(filter-out port/cortex-m/% port/packaging/%,$(wildcard src/*/*.cpp src/program/*/*.cpp port/*/*.cpp port/*/*.c)))
LISTED_SOURCES := $(sort $(CORE_SOURCES) $(PORT_SOURCES) $(REPORT_SOURCES) $(PROGRAM_SOURCES))
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
	@{ sed -n '/^#/p' src/sources.mk; \
	   ls port/*/*.cpp | grep -v -e '^port/cortex-m/' -e '^port/packaging/' | cut -d/ -f2 | sort -u | sed 's/^/PORTS += /'; \
	   ls src/*/*.cpp | grep -v -e '^src/report/' -e '^src/program/' | sed 's/^/CORE_SOURCES += /'; \
	   ls port/*/*.cpp port/*/*.c 2>/dev/null | grep -v -e '^port/cortex-m/' -e '^port/packaging/' | sed 's/^/PORT_SOURCES += /'; \
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
PAGES := $(wildcard *.md src/*.md src/*/*.md src/program/*/*.md include/*.md port/*.md port/*/*.md tests/*.md examples/*.md examples/*.svg)
PAGES := $(sort $(PAGES))
INSTALLED := $(BINDIR)/contact2d $(MANDIR)/man1/contact2d.1 $(LIBDIR)/libcontact2d.a $(LIBDIR)/libcontact2d.so.$(VERSION) \
  $(LIBDIR)/libcontact2d.so.$(SOVERSION) $(LIBDIR)/libcontact2d.so \
  $(addprefix $(INCLUDEDIR)/,$(notdir $(HEADERS))) $(LIBDIR)/pkgconfig/contact2d.pc \
  $(CMAKEDIR)/contact2dConfig.cmake $(CMAKEDIR)/contact2dConfigVersion.cmake $(addprefix $(DOCDIR)/,$(PAGES))
fill = sed -e 's|@PREFIX@|$(PREFIX)|g' -e 's|@LIBDIR@|$(LIBDIR)|g' -e 's|@INCLUDEDIR@|$(INCLUDEDIR)|g' \
  -e 's|@VERSION@|$(VERSION)|g' -e 's|@SOVERSION@|$(SOVERSION)|g'

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
	  $(BUILD)/embedded $(BUILD)/hostile $(BUILD)/small $(BUILD)/cross $(BUILD)/amalgamation $(BUILD)/deb
	rm -f $(LIBRARY) $(BUILD)/libcontact2d.so.* $(PROGRAM) $(BUILD)/flags
	-rmdir $(BUILD) 2>/dev/null || true

-include $(wildcard $(BUILD)/obj/*.d $(BUILD)/tests/*.d $(BUILD)/bench/*.d $(BUILD)/convergence/*.d)
