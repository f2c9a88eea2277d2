# How a source becomes an object: what the Makefile's rules for library, program and ports stand on. Included by the Makefile.
#   flags      every object depends on build/flags, a file that changes when the compiler or its flags do: no object of other
#              flags is ever linked
#   files      of any size, on disks with 64-bit inode numbers: 32-bit programs cannot open them otherwise
#   kernels    files named kernel_SET.cpp ask for an instruction set and for fused additions (src/linalg/kernel.hpp)
#   batches    report, program and tests are compiled BATCH files at a time, as the headers of the C++ library take longer to
#              compile than what follows them; so names that are private to a file are unique in its folder. BATCH=1: each by itself

WARNINGS  := -Wall -Wextra -Wpedantic -Wconversion -Wshadow
INCLUDES  := -Isrc -Iinclude $(addprefix -Iport/,$(PORTS))
COMMON    := $(INCLUDES) -std=c++17 $(if $(findstring 64,$(MACHINE)),,-D_FILE_OFFSET_BITS=64) $(WARNINGS)
EXACT     := -ffp-contract=off
CORE_ONLY := -fPIC -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-math-errno
DEPS      := -MMD -MP
# GCC looks less often for memory that it can use again: batches are compiled in a sixth less time, in a quarter more memory.
SPACIOUS  := --param ggc-min-expand=1000 --param ggc-min-heapsize=2000000
COMMON    += $(shell echo | $(CXX) -Werror $(SPACIOUS) -E -x c++ - >/dev/null 2>&1 && echo "$(SPACIOUS)")

BATCH ?= 30
FLAGS_NOW := $(BATCH) $(ONE_FILE) $(CXX) $(CC) $(CPPFLAGS) $(CXXFLAGS) $(PROGRAM_FLAGS) $(CFLAGS) $(LDFLAGS) $(HARDENING)
$(BUILD)/flags: FORCE
	@mkdir -p $(BUILD)/obj $(BUILD)/tests/only
	@echo '$(subst ','\'',$(FLAGS_NOW))' | cmp -s - $@ || echo '$(subst ','\'',$(FLAGS_NOW))' > $@

ifneq ($(findstring x86_64,$(MACHINE)),)
KERNEL_kernel_avx2 := -mavx2 -mfma
KERNEL_kernel_avx512 := -mavx512f -mfma
endif
# MinGW's stack is aligned to 16 bytes, whatever the vectors on it need.
ifneq ($(findstring mingw,$(MACHINE)),)
KERNEL_ANYWHERE := -Wa,-muse-unaligned-vector-move
endif
kernel_flags = $(if $(findstring /kernel_,$(1)),-ffp-contract=fast $(KERNEL_$(basename $(notdir $(1)))) $(KERNEL_ANYWHERE))

# src/memory/real.cpp -> memory_real.o, port/stdio/tapes.cpp -> port_stdio_tapes.o
object = $(BUILD)/obj/$(subst /,_,$(basename $(patsubst src/%,%,$(1)))).o
objects = $(foreach s,$(1),$(call object,$(s)))

# A batch is a word: the names of its files, with commas. batches: files -> batches; files: a batch -> its files; batch_needs: what its
# object depends on; write_batch: the line of a recipe that writes them as one source; batch_source: what is compiled;
# batch_object: its object, named after the first.
comma := ,
batches = $(if $(1),$(shell echo $(1) | xargs -n $(BATCH) | tr ' ' ,))
files = $(subst $(comma), ,$(1))
batch_needs = $(call files,$(1)) $(if $(findstring $(comma),$(1)),src/sources.mk)
write_batch = $(if $(findstring $(comma),$(1)),@printf '\043include "%s"\n' $(call files,$(1)) > $$(@:.o=.cpp))
batch_source = $(if $(findstring $(comma),$(1)),-I. $$(@:.o=.cpp),$(1))
batch_object = $(patsubst %.o,%$(if $(findstring $(comma),$(1)),_etc).o,$(call object,$(firstword $(call files,$(1)))))

# $(call compile,FILE or batch,FLAGS): the rule of its object.
define compile
$(call batch_object,$(1)): $(call batch_needs,$(1)) $(BUILD)/flags src/compile.mk
	$(call write_batch,$(1))
	$(if $(filter %.c,$(1)),$(CC) $(CPPFLAGS) $(INCLUDES) -std=c99 -Wall -Wextra -Wpedantic $(HARDENING) $(CFLAGS) -fPIC,\
	  $(CXX) $(CPPFLAGS) $(COMMON) $(HARDENING) $(CXXFLAGS) $(if $(filter $(COUNTED_EACH),$(call files,$(1))),-fprofile-update=atomic) \
	  $(EXACT) $(2)) $(SAME_FOLDER) $(DEPS) -c $(call batch_source,$(1)) -o $$@
endef
