# make shape: sizes and habits of the sources (tests/shape). make list: src/sources.mk against the folders, what is missing from either. make relist: writes it anew. Included by the Makefile.
#: make list, relist                compare src/sources.mk with the folders; rewrite it
#: make shape                       code metrics: lines, modes, project jargon, comments, folders, call tree of a rate problem
.PHONY: list relist shape
shape: $(PROGRAM)
	@sh tests/shape/shape.sh $(BUILD)
# (port/cortex-m, port/web and port/windows are compiled for their own machines only, port/packaging has tools)
OTHER_PORTS := cortex-m packaging web windows
FOUND_PORTS := $(filter-out $(OTHER_PORTS:%=port/%/%),$(wildcard port/*/*.cpp port/*/*.c))
FOUND_CORE := $(filter-out src/post/% src/report/% src/program/%,$(wildcard src/*/*.cpp src/*/*/*.cpp))
FOUND_POST := $(wildcard src/post/*.cpp src/post/*/*.cpp)
FOUND_REPORT := $(wildcard src/report/*.cpp src/report/*/*.cpp)
FOUND_PROGRAM := $(wildcard src/program/*.cpp src/program/*/*.cpp src/program/*/*/*.cpp)
FOUND_SOURCES := $(sort $(FOUND_PORTS) $(FOUND_CORE) $(FOUND_POST) $(FOUND_REPORT) $(FOUND_PROGRAM))
NOT_LISTED := $(filter-out $(LISTED_SOURCES),$(FOUND_SOURCES))
NOT_FOUND := $(filter-out $(FOUND_SOURCES),$(LISTED_SOURCES))
ifneq ($(strip $(NOT_LISTED)$(NOT_FOUND)),)
$(warning src/sources.mk is out of date (make relist): $(addprefix +,$(NOT_LISTED)) $(addprefix -,$(NOT_FOUND)))
endif
list:
	@{ $(FAMILY_TEXT); } | cmp -s - src/program/family_sketches.inc || \
	  { echo 'src/program/family_sketches.inc differs from examples/families: make relist writes it anew'; exit 1; }
	@$(foreach s,$(NOT_LISTED),echo 'in the folders, not in src/sources.mk: $(s)';) \
	 $(foreach s,$(NOT_FOUND),echo 'in src/sources.mk, not in the folders: $(s)';) \
	 $(if $(strip $(NOT_LISTED)$(NOT_FOUND)),echo 'make relist writes src/sources.mk anew'; exit 1,\
	   echo 'src/sources.mk lists every source file')
lines = printf '$(1) += %s\n' $(sort $(2));
relist:
	@{ sed -n '/^#/p' src/sources.mk; \
	   $(call lines,PORTS,$(foreach s,$(filter %.cpp,$(FOUND_PORTS)),$(word 2,$(subst /, ,$(s))))) \
	   $(call lines,CORE_SOURCES,$(FOUND_CORE)) $(call lines,PORT_SOURCES,$(FOUND_PORTS)) \
	   $(call lines,POST_SOURCES,$(FOUND_POST)) \
	   $(call lines,REPORT_SOURCES,$(FOUND_REPORT)) $(call lines,PROGRAM_SOURCES,$(FOUND_PROGRAM)) } > src/sources.mk.new
	@mv src/sources.mk.new src/sources.mk
	@{ $(FAMILY_TEXT); } > src/program/family_sketches.inc

# The sketches that contact2d make knows, as text that the program includes; make relist writes it anew.
FAMILY_TEXT = for f in examples/families/*.c2s; do \
  printf '{"%s", R"c2s(' $$(basename $$f .c2s); cat $$f; printf ')c2s"},\n'; done
