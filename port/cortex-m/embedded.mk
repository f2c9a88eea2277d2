# The library for Cortex-M3, M4F and M7, and the sample deck on their boards in an emulator: included by the Makefile.
# Needs arm-none-eabi-g++ with newlib, and qemu-system-arm (Debian: gcc-arm-none-eabi libnewlib-arm-none-eabi
# libstdc++-arm-none-eabi-newlib qemu-system-arm).
ARM_PREFIX ?= arm-none-eabi-
QEMU_ARM   ?= qemu-system-arm
EMBEDDED   := $(BUILD)/embedded
BOARDS     := m3 m4f m7

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
# Bytes that the linker must find between static data and the top of RAM.
STACK_LEAST ?= 4096

ARM_FLAGS := -std=c++17 -Os -ffreestanding -fbuiltin -fno-math-errno -fno-exceptions -fno-rtti -ffunction-sections \
  -fdata-sections -fno-threadsafe-statics $(EXACT) $(WARNINGS) -fstack-usage -fcallgraph-info=su
ARM_PORT := $(wildcard port/cortex-m/*.cpp)

define arm_object
$(EMBEDDED)/$(1)/obj/$(subst /,_,$(basename $(patsubst src/%,%,$(2)))).o: $(2) port/cortex-m/embedded.mk | $(EMBEDDED)/$(1)/obj
	$(ARM_PREFIX)g++ $(cpu_$(1)) $(real_$(1)) $(ARM_FLAGS) -Isrc -Iinclude -Iport/cortex-m $(DEPS) -c $(2) -o $$@
endef
arm_objects = $(foreach s,$(2),$(EMBEDDED)/$(1)/obj/$(subst /,_,$(basename $(patsubst src/%,%,$(s)))).o)

define arm_board
$(EMBEDDED)/$(1)/obj:
	@mkdir -p $$@
$(foreach s,$(CORE_SOURCES) $(ARM_PORT),$(eval $(call arm_object,$(1),$(s))))
$(EMBEDDED)/$(1)/libcontact2d.a: $(call arm_objects,$(1),$(CORE_SOURCES)) src/sources.mk
	@rm -f $$@
	$(ARM_PREFIX)ar rcs $$@ $(call arm_objects,$(1),$(CORE_SOURCES))
$(EMBEDDED)/$(1)/run_deck.elf: $(EMBEDDED)/$(1)/libcontact2d.a $(call arm_objects,$(1),$(ARM_PORT)) $(wildcard port/cortex-m/*.ld)
	$(ARM_PREFIX)g++ $(cpu_$(1)) -nostdlib -Wl,--gc-sections -Wl,-Map,$$(@:.elf=.map) -Lport/cortex-m \
	  -Wl,--defsym=stack_least=$(STACK_LEAST) -T port/cortex-m/$(board_$(1)).ld $(call arm_objects,$(1),$(ARM_PORT)) \
	  $(EMBEDDED)/$(1)/libcontact2d.a -lm -lc -lgcc -o $$@
$(EMBEDDED)/$(1)/hertz.csv: $(EMBEDDED)/$(1)/run_deck.elf examples/hertz.dat
	@mkdir -p $$(@D)/tapes
	$(QEMU_ARM) -M $(board_$(1)) -nographic -monitor none -serial none -kernel $$< \
	  -semihosting-config enable=on,target=native,arg=examples/hertz.dat,arg=$$(@D)/tapes,arg=$$@.new </dev/null
	@mv $$@.new $$@
-include $(wildcard $(EMBEDDED)/$(1)/obj/*.d)
endef
$(foreach b,$(BOARDS),$(eval $(call arm_board,$(b))))

$(EMBEDDED)/compare: tests/embedded/compare.cpp $(BUILD)/flags
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(LDFLAGS) -o $@ $<
$(EMBEDDED)/desktop.csv: $(PROGRAM) examples/hertz.dat
	@mkdir -p $(@D)
	$(PROGRAM) run examples/hertz.dat --no-progress --listing $(@:.csv=.lst) --csv $@ 2>/dev/null

EMBEDDED_TESTED := $(BOARDS:%=$(EMBEDDED)/%/run_deck.elf) $(EMBEDDED)/compare

# The sample deck on every board, compared with this machine's run.
.PHONY: embedded $(BOARDS:%=embedded-%)
embedded: $(BOARDS:%=embedded-%)
$(BOARDS:%=embedded-%): embedded-%: $(EMBEDDED)/%/hertz.csv $(EMBEDDED)/desktop.csv $(EMBEDDED)/compare
	@echo 'embedded: $* ($(board_$*))'
	@$(EMBEDDED)/compare $(EMBEDDED)/desktop.csv $< $(agree_$*)
