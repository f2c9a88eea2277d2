# contact2d: library, program, tests. `make help` lists targets and variables.
# What is compiled stands in src/sources.mk, which CMakeLists.txt reads too. Fragments are included where they are needed; each begins
# with what it is for.

#: make                             build/libcontact2d.a and build/contact2d
#: make demo                        a first problem: listing, tables and a page of pictures in build/demo
#: make chapter9                    figures 36 to 41 of the dissertation
#: make python                      shared library and program for port/python
#: make symbols                     rewrite the list of exported names
#: make format, format-check        format the sources with clang-format 14, or check them
#: make clean                       remove all build results

# ---------------------------------------------------------------- variables
.DEFAULT_GOAL := all
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
# Report and program are no faster by -O2, and compiled in two thirds of the time by -O1.
PROGRAM_FLAGS ?= $(if $(filter -O2 -O3,$(CXXFLAGS)),-O1)

LIBRARY = $(BUILD)/libcontact2d.a
SHARED  = $(BUILD)/libcontact2d.so.$(VERSION)
POST    = $(BUILD)/libcontact2d_post.a
PROGRAM = $(BUILD)/contact2d
TESTS   = $(BUILD)/tests/run_tests

version_part = $(shell sed -n 's/^\#define C2D_VERSION_$(1) *//p' include/contact2d.h)
MAJOR     := $(call version_part,MAJOR)
MINOR     := $(call version_part,MINOR)
VERSION   := $(MAJOR).$(MINOR).$(call version_part,PATCH)
# Before 1.0 a minor version may change calls: programs of another must not find it.
SOVERSION := $(if $(filter 0,$(MAJOR)),0.$(MINOR),$(MAJOR))

# ---------------------------------------------------------------- sources and their objects
include src/sources.mk
# What the folders are compared with (src/relist.mk), before PORTS= chooses among the ports.
LISTED_SOURCES   := $(sort $(CORE_SOURCES) $(PORT_SOURCES) $(POST_SOURCES) $(REPORT_SOURCES) $(PROGRAM_SOURCES))
ALL_PORT_SOURCES := $(PORT_SOURCES)
PORT_SOURCES     := $(filter $(addsuffix /%,$(addprefix port/,$(PORTS))),$(PORT_SOURCES))
HOSTILE_SOURCES  := $(if $(HOSTILE_WIDTH),tests/hostile/hostile_port.cpp)
PROGRAM_MAIN     := src/program/main.cpp

include port/packaging/hardening.mk
include src/compile.mk

# ONE_FILE=FILE: the core and the port in memory as `make amalgamation` writes them. Compiled in a fifth of the time, for builds that are
# made once; a program has all of it or nothing.
CORE_OBJECTS    := $(if $(ONE_FILE),$(BUILD)/obj/one_file.o,$(call objects,$(CORE_SOURCES)))
PORT_OBJECTS    := $(call objects,$(filter-out $(if $(ONE_FILE),port/memory/%),$(PORT_SOURCES)) $(HOSTILE_SOURCES))
POST_BATCHES    := $(call batches,$(POST_SOURCES))
REPORT_BATCHES  := $(POST_BATCHES) $(call batches,$(REPORT_SOURCES))
FAMILY_BATCHES  := $(call batches,$(filter-out $(PROGRAM_MAIN),$(PROGRAM_SOURCES)))
REPORT_OBJECTS  := $(foreach b,$(REPORT_BATCHES),$(call batch_object,$(b)))
FAMILY_OBJECTS  := $(foreach b,$(FAMILY_BATCHES),$(call batch_object,$(b))) # all of the program but its main
PROGRAM_OBJECTS := $(call objects,$(PROGRAM_MAIN)) $(FAMILY_OBJECTS)
CHAPTER9_SOURCES := $(sort $(wildcard examples/chapter9/*.cpp))
CHAPTER9_OBJECTS := $(call objects,$(CHAPTER9_SOURCES))
STUDY_OBJECT     := $(call object,examples/chapter9/study.cpp)
include tests/borrow.mk

# ---------------------------------------------------------------- the library and the program
.DELETE_ON_ERROR:
.PHONY: all demo chapter9 test symbols python help format format-check clean FORCE
# PORTS='memory fortran' is a library without files and threads, and without the program, which has both.
all: $(LIBRARY) $(if $(filter-out $(PORT_SOURCES),$(ALL_PORT_SOURCES)),,$(POST) $(PROGRAM))

$(foreach s,$(CORE_SOURCES) $(PORT_SOURCES),$(eval $(call compile,$(s),$(CORE_ONLY) $(call hardening_of,$(s)) $(call kernel_flags,$(s)))))
$(BUILD)/obj/one_file.o: $(ONE_FILE) $(BUILD)/flags
	$(CXX) $(CPPFLAGS) -Iinclude -Iport/memory -std=c++17 $(CXXFLAGS) $(EXACT) $(CORE_ONLY) -c $< -o $@
$(foreach s,$(HOSTILE_SOURCES),$(eval $(call compile,$(s),$(CORE_ONLY) -UC2D_HOSTILE -DC2D_HOSTILE=$(HOSTILE_WIDTH))))
$(foreach s,$(REPORT_BATCHES) $(FAMILY_BATCHES) $(PROGRAM_MAIN) $(CHAPTER9_SOURCES),$(eval $(call compile,$(s),$(HARDENED_PROGRAM) $(PROGRAM_FLAGS))))

$(LIBRARY): $(CORE_OBJECTS) $(PORT_OBJECTS) src/sources.mk
	rm -f $@
	$(ARCHIVE) $@ $(CORE_OBJECTS) $(PORT_OBJECTS)

# Linked as C: nothing of the C++ run-time is needed. Only the names of the interface leave it; a list of them is kept.
EXPORTS := port/packaging/contact2d.map
$(SHARED): $(CORE_OBJECTS) $(PORT_OBJECTS) $(EXPORTS)
	$(CC) -shared $(HARDENED_LINK) $(LDFLAGS) -Wl,-soname,libcontact2d.so.$(SOVERSION) -Wl,--version-script,$(EXPORTS) \
	  -o $@ $(CORE_OBJECTS) $(PORT_OBJECTS) -lm -pthread
symbols: $(SHARED)
	sh port/packaging/symbols.sh $(SHARED) port/packaging/contact2d.symbols $(VERSION)

# With the C++ run-time inside, where there is a static one: a run of 5 ms would spend a tenth on loading it.
LINK_PROGRAM = $(HARDENED_LINK) $(HARDENED_PIE) $(LDFLAGS)
$(PROGRAM): $(PROGRAM_OBJECTS) $(REPORT_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LINK_PROGRAM) -static-libstdc++ -static-libgcc -o $@ $^ -lm -pthread 2>/dev/null || \
	  $(CXX) $(CXXFLAGS) $(LINK_PROGRAM) -o $@ $^ -lm -pthread
# What port/python takes from here.
python: $(SHARED) $(PROGRAM)

# Edges, corners, cracks and other quantities of a solved model (src/post), for programs that call the library.
$(POST): $(foreach b,$(POST_BATCHES),$(call batch_object,$(b)))
	rm -f $@
	$(ARCHIVE) $@ $^

# ---------------------------------------------------------------- for the user
demo: $(PROGRAM)
	@mkdir -p $(BUILD)/demo
	$(PROGRAM) run examples/tutorial/t1_roller.c2s --listing $(BUILD)/demo/roller.lst --csv $(BUILD)/demo/roller.csv \
	  --boundary $(BUILD)/demo/roller_boundary.csv --json $(BUILD)/demo/roller.json --report $(BUILD)/demo/report.html
	@echo 'A steel roller of radius 5 mm on a steel raceway, 200 N per mm of length, half of it (examples/tutorial/t1_roller.c2s):'
	@grep -E -m 3 'stated error|peak pressure|contact edge 1' $(BUILD)/demo/roller.lst
	@echo 'Hertz: peak pressure 1200.47 MPa, contact up to x = 0.106061 mm'
	@echo 'Results: $(BUILD)/demo/roller.lst (listing), roller.csv, roller_boundary.csv, roller.json;'
	@echo 'pictures: $(BUILD)/demo/report.html (open it with a browser)'

# Chapter 9 of the dissertation: figures 36 to 41, as increments give them and as events do.
$(BUILD)/obj/chapter9: $(CHAPTER9_OBJECTS) $(REPORT_OBJECTS) $(FAMILY_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
chapter9: $(BUILD)/obj/chapter9
	@mkdir -p $(BUILD)/chapter9
	@$(BUILD)/obj/chapter9 $(BUILD)/chapter9
	@echo 'Figures 36 to 41: $(BUILD)/chapter9/chapter9.svg; numbers: curves.csv; a deck per curve: *.dat'

# The lines that begin with #: in this file and in the fragments.
help:
	@sed -n 's/^#: //p' $(filter Makefile %.mk,$(MAKEFILE_LIST))
	@echo
	@echo 'Variables: CXX CC AR CXXFLAGS CFLAGS CPPFLAGS LDFLAGS PROGRAM_FLAGS HARDENING PORTS BUILD JOBS BATCH ONE_FILE;'
	@echo 'for the tests DOCTEST_INCLUDE DOCTEST_SHA256 NO_INSTALL'

# ---------------------------------------------------------------- tests, other machines, packages
include tests/random/random.mk
include tests/faults/faults.mk
include tests/fuzz/fuzz.mk
include tests/tests.mk
include tests/truth.mk
include tests/hostile.mk
include tests/sanitize.mk
include tests/msan/msan.mk
include tests/coverage/coverage.mk
include tests/mutants/mutants.mk
include tests/proof/proof.mk
include tests/bench/bench.mk
include port/cortex-m/embedded.mk
include tests/cross/cross.mk
include port/packaging/packaging.mk
include port/packaging/install.mk
include port/web/web.mk
include port/windows/windows.mk
include examples/gallery/gallery.mk
include src/relist.mk

# ---------------------------------------------------------------- the tree
FORMATTED = $(shell find src port tests -name '*.[ch]pp' -o -name '*.[ch]')
format:
	clang-format -i $(FORMATTED)
# Versions differ in what they make of a line: that of Debian 12 decides.
format-check:
	@clang-format --version | grep -q 'version 14\.' || { echo 'not checked: needs clang-format 14'; exit 0; }; \
	  clang-format --dry-run -Werror $(FORMATTED)

clean:
	rm -rf $(addprefix $(BUILD)/,obj tests demo bench convergence chapter9 embedded fuzz sanitize sanitize-library threads hostile \
	  small cross amalgamation api deb reproducible release web times proof)
	rm -f $(LIBRARY) $(POST) $(BUILD)/libcontact2d.so.* $(PROGRAM) $(BUILD)/flags
	-rmdir $(BUILD) 2>/dev/null || true

-include $(wildcard $(BUILD)/web/obj/*.d $(BUILD)/obj/*.d $(BUILD)/tests/*.d $(BUILD)/tests/only/*.d $(BUILD)/bench/*.d $(BUILD)/convergence/*.d)
