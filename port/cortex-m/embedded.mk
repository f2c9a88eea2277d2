# The library for Cortex-M3, M4F and M7, and the sample deck on their boards in an emulator: included by the Makefile.
# Needs arm-none-eabi-g++ with newlib, and qemu-system-arm (Debian: gcc-arm-none-eabi libnewlib-arm-none-eabi
# libstdc++-arm-none-eabi-newlib qemu-system-arm).
#: make embedded, footprint         boards in an emulator; their code, data and stack sizes (BOARD=)
ARM_PREFIX ?= arm-none-eabi-
QEMU_ARM   ?= qemu-system-arm
EMBEDDED   := $(BUILD)/embedded
BOARDS     := m3 m4f m7
script = port/cortex-m/$(board_$(1)).ld
sources_of_board = $(ARM_PORT)

board_m3  := lm3s6965evb
board_m4f := mps2-an386
board_m7  := mps2-an500
cpu_m3    := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft
cpu_m4f   := -mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard
cpu_m7    := -mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard
real_m4f  := -DC2D_REAL=float -DC2D_REAL_BYTES=4
# What the results may differ from the desktop's, over the largest of their kind.
agree_m3  := 1e-9
agree_m4f := 2e-4
agree_m7  := 1e-9
# make embedded BOARD=DIR: a board of one's own in their place (README.md of this folder). DIR/board.mk sets CPU and SCRIPT, and as
# needed EMULATED, DEFINES, AGREE, PARTS, SOURCES, ARM_PREFIX, QEMU_ARM.
ifdef BOARD
override BOARD := $(BOARD:%/=%)
AGREE := 1e-9
include $(BOARD)/board.mk
BOARDS := $(notdir $(BOARD))
cpu_$(BOARDS) := $(CPU)
board_$(BOARDS) := $(EMULATED)
real_$(BOARDS) := $(DEFINES)
agree_$(BOARDS) := $(AGREE)
parts_$(BOARDS) := $(PARTS)
script = $(BOARD)/$(SCRIPT)
sources_of_board = $(or $(SOURCES),$(ARM_PORT))
endif
# Bytes that the linker must find between static data and the top of RAM; one more, an odd number that is no address of a function.
STACK_LEAST ?= 4096

ARM_FLAGS := -std=c++17 -Os -fno-move-loop-invariants -fno-tree-loop-im -fno-schedule-insns2 -fno-inline-small-functions -ffreestanding \
  -fbuiltin -fno-math-errno -fno-exceptions -fno-rtti -ffunction-sections -fdata-sections -fno-threadsafe-statics \
  -DC2D_PARTS_BY_CALL $(EXACT) $(WARNINGS)
# Sources are compiled to code whose stack the compiler reports and whose bill is made (obj). Where the deck reader and the parts do
# not fit the 256 KiB of a board like that, run_deck is made of sources compiled once more for link-time optimisation (lto), some
# 4 % smaller: functions are not put into each other where that makes the stack longer.
flags_obj := -fstack-usage -fcallgraph-info=su
flags_lto := -flto --param=large-stack-frame=48 --param=large-stack-frame-growth=60
link_lto  := $(ARM_FLAGS) $(flags_lto) -flto=1 -flto-partition=one
form_m3   := lto
form_m4f  := lto
form = $(or $(form_$(1)),obj)
graphed = $(if $(form_$(1)),plain,run_deck)
ARM_PORT := $(wildcard port/cortex-m/*.cpp)
# Calls that declare a part of the library (src/memory/parts.hpp). run_deck links them as far as 256 KiB of ROM have room for
# them beside the rest: decks that need another are refused, with the name of its call.
PART_CALLS := c2d_link_holes c2d_set_symmetry
parts_m3   :=
parts_m7   := c2d_link_free_zones c2d_set_body_force c2d_set_rigid

# $(1) board, $(2) source, $(3) obj or lto
define arm_object
$(EMBEDDED)/$(1)/$(3)/$(subst /,_,$(basename $(patsubst src/%,%,$(2)))).o: $(2) port/cortex-m/embedded.mk | $(EMBEDDED)/$(1)/$(3)
	$(ARM_PREFIX)g++ $(cpu_$(1)) $(real_$(1)) $(ARM_FLAGS) $(flags_$(3)) -Isrc -Iinclude -Iport/cortex-m $(DEPS) -c $(2) -o $$@
endef
arm_objects = $(foreach s,$(2),$(EMBEDDED)/$(1)/$(3)/$(subst /,_,$(basename $(patsubst src/%,%,$(s)))).o)
# $(1) board, $(2) obj or lto
define arm_library
$(EMBEDDED)/$(1)/$(2):
	@mkdir -p $$@
$(foreach s,$(CORE_SOURCES) $(sort $(ARM_PORT) $(sources_of_board)),$(eval $(call arm_object,$(1),$(s),$(2))))
$(EMBEDDED)/$(1)/$(2)/libcontact2d.a: $(call arm_objects,$(1),$(CORE_SOURCES),$(2)) src/sources.mk
	@rm -f $$@
	$(ARM_PREFIX)gcc-ar rcsD $$@ $(call arm_objects,$(1),$(CORE_SOURCES),$(2))
-include $(wildcard $(EMBEDDED)/$(1)/$(2)/*.d)
endef

define arm_board
$(foreach f,$(sort obj $(call form,$(1))),$(eval $(call arm_library,$(1),$(f))))
$(EMBEDDED)/$(1)/run_deck.elf: $(EMBEDDED)/$(1)/$(call form,$(1))/libcontact2d.a $(call arm_objects,$(1),$(sources_of_board),$(call form,$(1))) \
  $(call script,$(1)) $(wildcard port/cortex-m/*.ld)
	$(ARM_PREFIX)g++ $(cpu_$(1)) $(link_$(call form,$(1))) -nostdlib -Wl,--gc-sections -Wl,-Map,$$(@:.elf=.map) -Lport/cortex-m \
	  -Wl,--defsym=stack_least=$(STACK_LEAST)+1 -T $(call script,$(1)) $(foreach p,$(PART_CALLS) $(parts_$(1)),-Wl,-u,$(p)) \
	  $(call arm_objects,$(1),$(sources_of_board),$(call form,$(1))) $(EMBEDDED)/$(1)/$(call form,$(1))/libcontact2d.a -lm -lc_nano -lgcc -o $$@
$(EMBEDDED)/$(1)/hertz.csv: $(EMBEDDED)/$(1)/run_deck.elf examples/hertz.dat
	@mkdir -p $$(@D)/tapes
	$(QEMU_ARM) -M $(board_$(1)) -nographic -monitor none -serial none -kernel $$< \
	  -semihosting-config enable=on,target=native,arg=examples/hertz.dat,arg=$$(@D)/tapes,arg=$$@.new </dev/null \
	  > $$(@D)/run.log 2>&1 || { cat $$(@D)/run.log; exit 1; }
	@mv $$@.new $$@
endef
$(foreach b,$(BOARDS),$(eval $(call arm_board,$(b))))

$(EMBEDDED)/compare: tests/embedded/compare.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(LDFLAGS) -o $@ $<
$(EMBEDDED)/desktop.csv: $(PROGRAM) examples/hertz.dat
	@mkdir -p $(@D)
	$(PROGRAM) run examples/hertz.dat --no-progress --listing $(@:.csv=.lst) --csv $@ 2>/dev/null

# $(1) which run, $(2) its results, $(3) the allowed differences. Printed in one piece, because other runs end at the same time.
agree = @text=$$($(EMBEDDED)/compare $(EMBEDDED)/desktop.csv $(2) $(3)); status=$$?; \
  printf 'embedded: %s\n%s\n' '$(1)' "$$text"; exit $$status
# The sample deck on every board, compared with this machine's run.
.PHONY: embedded embedded-float $(BOARDS:%=embedded-%)
ifdef BOARD
embedded: $(if $(EMULATED),embedded-$(BOARDS),$(EMBEDDED)/$(BOARDS)/run_deck.elf)
	@$(ARM_PREFIX)size $(EMBEDDED)/$(BOARDS)/run_deck.elf
else
embedded: $(BOARDS:%=embedded-%) embedded-float
endif
# Matrices in single precision on this machine.
embedded-float: $(EMBEDDED)/desktop.csv $(EMBEDDED)/compare
	@$(MAKE) -s BUILD=$(EMBEDDED)/float TESTS_FROM=$(BUILD) CPPFLAGS='$(CPPFLAGS) -DC2D_REAL=float -DC2D_REAL_BYTES=4' $(EMBEDDED)/float/contact2d
	@$(EMBEDDED)/float/contact2d run examples/hertz.dat --no-progress --listing $(EMBEDDED)/float/hertz.lst \
	  --csv $(EMBEDDED)/float/hertz.csv 2>$(EMBEDDED)/float/run.log || { cat $(EMBEDDED)/float/run.log; exit 1; }
	$(call agree,this machine$(comma) C2D_REAL=float,$(EMBEDDED)/float/hertz.csv,$(agree_m4f))
$(BOARDS:%=embedded-%): embedded-%: $(EMBEDDED)/%/hertz.csv $(EMBEDDED)/desktop.csv $(EMBEDDED)/compare
	$(call agree,$* ($(board_$*)),$<,$(agree_$*))

# ---- the bill: what every target takes ----------------------------------------------------------------------------
# Images of calls of the header and of what they need, linked with --gc-sections:
#   whole        every call                      no-deck, no-points   without the deck reader, without c2d_interior and c2d_indicators
#   solver       a model by calls, one load case, zones of pairs, begin and advance: all orders, both quadratures,
#                both steppings, interior points
#   solver-told  the same with warnings, search and proofs
#   solver-run   the same and c2d_run, c2d_get_summary, with energies       solver-deck   that and the deck reader
open := (
ALL_CALLS    := $(sort $(shell sed -n 's/^[a-z][a-z0-9_ *]*\(c2d_[a-z0-9_]*\)$(open)[a-z].*/\1/p' include/*.h))
DECK_CALLS   := c2d_scan_deck c2d_check_deck c2d_walk_deck c2d_read_deck
SOLVER_CALLS := c2d_memory_need c2d_create c2d_close c2d_set_problem c2d_set_body c2d_add_region c2d_set_nodes \
  c2d_set_condition c2d_add_point_load c2d_add_zone c2d_add_friction c2d_add_path c2d_complete c2d_set_options \
  c2d_prepare c2d_begin c2d_advance c2d_next_event c2d_cancel c2d_get c2d_interior c2d_get_state c2d_last_error c2d_message \
  c2d_outcome_message c2d_version
RUN_CALLS := c2d_run c2d_get_summary
CONFIGURATIONS := whole no-deck no-points solver solver-told solver-run solver-deck
calls_whole       := $(ALL_CALLS)
calls_no-deck     := $(filter-out $(DECK_CALLS),$(ALL_CALLS))
calls_no-points   := $(filter-out c2d_interior c2d_indicators,$(ALL_CALLS))
calls_solver      := $(SOLVER_CALLS)
calls_solver-told := $(SOLVER_CALLS) c2d_link_warnings c2d_link_search
calls_solver-run  := $(SOLVER_CALLS) $(RUN_CALLS)
calls_solver-deck := $(SOLVER_CALLS) $(RUN_CALLS) $(DECK_CALLS)
wanted = $(foreach c,$(calls_$(1)),-Wl,-u,$(c))

# $(1) board, $(2) configuration
define arm_size
$(EMBEDDED)/$(1)/$(2).elf: $(EMBEDDED)/$(1)/obj/libcontact2d.a $(EMBEDDED)/$(1)/obj/port_cortex-m_math.o port/cortex-m/sizes.ld
	@$(ARM_PREFIX)g++ $(cpu_$(1)) -nostdlib -Wl,--gc-sections -Wl,-e,c2d_create $(call wanted,$(2)) -T port/cortex-m/sizes.ld \
	  $(EMBEDDED)/$(1)/obj/port_cortex-m_math.o $(EMBEDDED)/$(1)/obj/libcontact2d.a -lm -lc_nano -lgcc -o $$@
$(EMBEDDED)/$(1)/$(2).size: $(EMBEDDED)/$(1)/$(2).elf
	@$(ARM_PREFIX)size -A $$< > $$@
endef
define arm_bill
$(foreach c,$(CONFIGURATIONS),$(eval $(call arm_size,$(1),$(c))))
# run_deck of the code of the call graph. For a board that runs other code (lto) it need not fit.
$(EMBEDDED)/$(1)/plain.elf: $(EMBEDDED)/$(1)/obj/libcontact2d.a $(call arm_objects,$(1),$(ARM_PORT),obj) $(wildcard port/cortex-m/*.ld)
	@sed 's/LENGTH = [0-9]*K/LENGTH = 1M/' port/cortex-m/$(board_$(1)).ld > $$(@:.elf=.ld)
	@$(ARM_PREFIX)g++ $(cpu_$(1)) -nostdlib -Wl,--gc-sections -Lport/cortex-m -Wl,--defsym=stack_least=$(STACK_LEAST)+1 \
	  -T $$(@:.elf=.ld) $(call arm_objects,$(1),$(ARM_PORT),obj) $(EMBEDDED)/$(1)/obj/libcontact2d.a -lm -lc_nano -lgcc -o $$@
$(EMBEDDED)/$(1)/whole.dis: $(EMBEDDED)/$(1)/whole.elf $(EMBEDDED)/$(1)/$(call graphed,$(1)).elf
	$(ARM_PREFIX)objdump -d $(EMBEDDED)/$(1)/$(call graphed,$(1)).elf $$< > $$@
	$(ARM_PREFIX)nm $(EMBEDDED)/$(1)/whole.elf > $$(@:.dis=.nm)
	@echo $(ALL_CALLS) > $$(@D)/calls
$(EMBEDDED)/$(1)/bill: $(EMBEDDED)/footprint $(CONFIGURATIONS:%=$(EMBEDDED)/$(1)/%.size) $(EMBEDDED)/$(1)/whole.dis \
  $(EMBEDDED)/$(1)/hertz.csv tests/footprint/indirect.txt
	@$(EMBEDDED)/footprint $(1) $$(@D) tests/footprint/indirect.txt > $$@.new; status=$$$$?; mv $$@.new $$@; \
	  [ $$$$status = 0 ] || { cat $$@; rm $$@; exit 1; }
endef
$(foreach b,$(BOARDS),$(eval $(call arm_bill,$(b))))

# This machine, with the same flags; its C library is shared and not counted.
DESKTOP := $(EMBEDDED)/desktop
desktop_object = $(DESKTOP)/obj/$(subst /,_,$(basename $(patsubst src/%,%,$(1)))).o
DESKTOP_OBJECTS := $(foreach s,$(CORE_SOURCES),$(call desktop_object,$(s)))
define desktop_compile
$(call desktop_object,$(1)): $(1) port/cortex-m/embedded.mk
	@mkdir -p $$(@D)
	$(CXX) $(CPPFLAGS) $(ARM_FLAGS) $(flags_obj) -Isrc -Iinclude $(DEPS) -c $(1) -o $$@
endef
$(foreach s,$(CORE_SOURCES),$(eval $(call desktop_compile,$(s))))
$(DESKTOP)/libcontact2d.a: $(DESKTOP_OBJECTS)
	@rm -f $@
	@$(ARCHIVE) $@ $(DESKTOP_OBJECTS)
define desktop_size
$(DESKTOP)/$(1).size: $(DESKTOP)/libcontact2d.a
	@$(CXX) -nostdlib -r -Wl,--gc-sections -Wl,-e,c2d_create $(call wanted,$(1)) $$^ -o $$(@:.size=.o)
	@size -A $$(@:.size=.o) > $$@
endef
$(foreach c,$(CONFIGURATIONS),$(eval $(call desktop_size,$(c))))
$(DESKTOP)/bill: $(EMBEDDED)/footprint $(CONFIGURATIONS:%=$(DESKTOP)/%.size) tests/footprint/indirect.txt
	@echo $(ALL_CALLS) > $(@D)/calls
	@$(EMBEDDED)/footprint desktop $(@D) tests/footprint/indirect.txt > $@.new; status=$$?; mv $@.new $@; \
	  [ $$status = 0 ] || { cat $@; rm $@; exit 1; }
-include $(wildcard $(DESKTOP)/obj/*.d)

$(EMBEDDED)/footprint: tests/footprint/footprint.cpp tests/footprint/stack.cpp tests/footprint/stack.hpp $(BUILD)/flags
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(LDFLAGS) -o $@ $(filter %.cpp,$^)
$(EMBEDDED)/workspace: tests/footprint/workspace.cpp $(LIBRARY)
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm
BILL_HEAD := | target | calls | code | constants | static data | stack | workspace | painted |
BILLS := $(EMBEDDED)/desktop/bill $(BOARDS:%=$(EMBEDDED)/%/bill)
# tests/test_embedded.cpp on all that it looks at.
.PHONY: test-embedded
test-embedded: $(BOARDS:%=$(EMBEDDED)/%/run_deck.elf) $(EMBEDDED)/compare $(BILLS) $(EMBEDDED)/workspace $(BUILD)/tests/only/embedded
	@C2D_ALL_HOSTS=1 $(BUILD)/tests/only/embedded
.PHONY: footprint footprint-readme
# The rows of the table in README.md of this folder, anew.
footprint-readme: $(BILLS)
	@{ echo; echo '$(BILL_HEAD)'; echo '| --- | --- | --- | --- | --- | --- | --- | --- |'; grep -h '^|' $(BILLS); } > $(EMBEDDED)/rows
	@awk '/^<!-- make footprint-readme/ { print; while ((getline row < "$(EMBEDDED)/rows") > 0) print row; skip = 1 } \
	  /^<!-- end -->/ { skip = 0 } !skip && !/^<!-- make footprint-readme/ { print }' port/cortex-m/README.md > $(EMBEDDED)/README.new
	@cat $(EMBEDDED)/README.new > port/cortex-m/README.md
footprint: $(BILLS) $(EMBEDDED)/workspace
	@grep -hv '^|' $(BILLS)
	@echo
	@echo '$(BILL_HEAD)'
	@echo '| --- | --- | --- | --- | --- | --- | --- | --- |'
	@grep -h '^|' $(BILLS)
	@echo
	@$(EMBEDDED)/workspace
