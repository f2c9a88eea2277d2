# make web: the program as one page, build/web/contact2d.html, and as one script, build/web/contact2d.js. Included by the
# Makefile. Needs clang, lld, and for wasm32 the C library, the C++ library and the compiler's run-time (Debian: clang lld
# wasi-libc libclang-rt-14-dev-wasm32 libc++-14-dev-wasm32 libc++abi-14-dev-wasm32, or of another version of clang).
#: make web                         the program as a web page, build/web/contact2d.html
.PHONY: web
WEB       := $(BUILD)/web
WEB_CXX   ?= clang++
# What is compiled how: the core, and report and program.
WEB_FLAGS ?= -O2
WEB_PROGRAM_FLAGS ?= -O1
WEB_COMMON := --target=wasm32-wasi -std=c++17 -ffp-contract=off -isystem port/web/include -Isrc -Iinclude $(addprefix -Iport/,$(filter-out fortran,$(PORTS))) \
  -D_WASI_EMULATED_SIGNAL -D_WASI_EMULATED_MMAN -D_WASI_EMULATED_PROCESS_CLOCKS -Wall -Wextra
WEB_CORE_ONLY := -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-math-errno
# Not the FORTRAN names, and nothing that needs threads: port/web/platform.cpp stands in for it.
WEB_CORE  := $(or $(ONE_FILE),$(CORE_SOURCES)) $(filter-out port/fortran/% port/threads/% port/posix/transfers.cpp \
  $(if $(ONE_FILE),port/memory/%),$(PORT_SOURCES))
WEB_REST  := $(REPORT_BATCHES) $(FAMILY_BATCHES) $(PROGRAM_MAIN) port/web/exceptions.cpp port/web/platform.cpp
web_object = $(patsubst $(BUILD)/%,$(WEB)/%,$(call batch_object,$(1)))
web_kernel = $(if $(findstring /kernel_,$(1)),-ffp-contract=off -msimd128)

$(WEB)/flags: FORCE
	@mkdir -p $(WEB)/obj
	@echo '$(WEB_CXX) $(WEB_COMMON) $(WEB_FLAGS) $(WEB_PROGRAM_FLAGS) $(ONE_FILE)' | cmp -s - $@ || echo '$(WEB_CXX) $(WEB_COMMON) $(WEB_FLAGS) $(WEB_PROGRAM_FLAGS) $(ONE_FILE)' > $@
define web_compile
$(call web_object,$(1)): $(call batch_needs,$(1)) $(WEB)/flags port/web/web.mk
	$(call write_batch,$(1))
	$(WEB_CXX) $(WEB_COMMON) $(2) -MMD -MP -c $(call batch_source,$(1)) -o $$@
endef
$(foreach s,$(WEB_CORE),$(eval $(call web_compile,$(s),$(WEB_FLAGS) $(WEB_CORE_ONLY) $(call web_kernel,$(s)))))
$(foreach s,$(WEB_REST),$(eval $(call web_compile,$(s),$(WEB_PROGRAM_FLAGS) -fwasm-exceptions -include port/web/system.hpp)))
$(WEB)/contact2d.wasm: $(foreach s,$(WEB_CORE) $(WEB_REST),$(call web_object,$(s)))
	$(WEB_CXX) --target=wasm32-wasi -O2 -Wl,--strip-all -Wl,-z,stack-size=1048576 -o $@ $^ \
	  -lwasi-emulated-signal -lwasi-emulated-mman

# ---------------------------------------------------------------- packed into text
WEB_EXAMPLES := $(wildcard examples/tutorial/t*) $(wildcard examples/*.c2s examples/revolution/*.c2s examples/*.dat) \
  examples/gear_pinion.csv examples/gear_wheel.csv examples/rough_profile.csv
# (lines that any awk takes)
pack = gzip -9n | base64 -w 4096
$(WEB)/contact2d.b64: $(WEB)/contact2d.wasm
	cat $< | $(pack) > $@
$(WEB)/examples.b64: port/web/examples.sh port/web/web.mk $(WEB_EXAMPLES)
	@mkdir -p $(@D)
	sh port/web/examples.sh $(WEB_EXAMPLES) | $(pack) > $@
# `@include FILE` on a line of its own: that file, of port/web or of what was packed.
WEB_PARTS := $(addprefix port/web/,page.html page.css page.js draw.js engine.js)
web_fill = awk -v folders='port/web $(WEB)' '/^@include / { n = split(folders, f, " "); for (i = 1; i <= n; ++i) \
  while ((getline line < (f[i] "/" $$2)) > 0) print line; next } { print }'
$(WEB)/contact2d.html: $(WEB_PARTS) $(WEB)/contact2d.b64 $(WEB)/examples.b64
	$(web_fill) port/web/page.html > $@
$(WEB)/contact2d.js: port/web/engine.js port/web/script.js $(WEB)/contact2d.b64
	$(web_fill) port/web/script.js > $@
web: $(WEB)/contact2d.html $(WEB)/contact2d.js
	@echo 'The program as a page: $(WEB)/contact2d.html; for a page of your own: $(WEB)/contact2d.js (port/web/README.md)'
