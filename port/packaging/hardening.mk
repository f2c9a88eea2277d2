# What ships is hardened where it is built for Linux: protected stack, checked memory functions, marks for control-flow
# enforcement, a program at addresses of chance, tables of addresses that are read-only before main. HARDENING= leaves all of it
# out, as it is left out for other machines, for hosts without files (PORTS=), and under sanitizers, which look further.
# Included by the Makefile.
MACHINE := $(shell $(CXX) -dumpmachine 2>/dev/null)
has_flag = $(shell echo | $(CXX) $(1) -E -x c++ - >/dev/null 2>&1 && echo "$(1)")
NOT_HARDENED := $(findstring -fsanitize,$(CXXFLAGS))$(if $(filter posix,$(PORTS)),,no files)
ifneq ($(and $(findstring linux,$(MACHINE)),$(if $(NOT_HARDENED),,yes)),)
BRANCHES := $(if $(filter x86_64-% i386-% i486-% i586-% i686-%,$(MACHINE)),-fcf-protection,\
  $(if $(filter aarch64-%,$(MACHINE)),-mbranch-protection=standard))
# (glibc warns of it without optimisation)
CHECKED := $(if $(filter -O1 -O2 -O3 -Os,$(CXXFLAGS)),$(if $(findstring _FORTIFY_SOURCE,$(CPPFLAGS) $(CXXFLAGS)),,\
  -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2))
# (:= by hand for ?=, which would ask the compiler each time that it is read)
ifeq ($(origin HARDENING),undefined)
HARDENING := -fstack-protector-strong $(strip $(if $(BRANCHES),$(call has_flag,$(BRANCHES)))) $(strip $(CHECKED))
endif
endif
# Arithmetic on numbers that were checked has no text in its frames, and many of them: arrays of characters alone are protected
# there, which costs nothing (all of them: 3 % of a path).
ifneq ($(findstring -fstack-protector-strong,$(HARDENING)),)
hardening_of = $(if $(filter src/bie/% src/contact/%,$(1)),-fstack-protector)
endif
ifneq ($(strip $(HARDENING)),)
HARDENED_LINK := -Wl,-z,relro,-z,now,-z,noexecstack
HARDENED_PROGRAM := -fPIE
HARDENED_PIE := $(if $(findstring -static,$(LDFLAGS)),,-pie)
endif

# The same bits from any folder: debugging information and __FILE__ name files of the project as it sees them itself, and
# archives contain no times and no owners.
SAME_FOLDER := $(call has_flag,-ffile-prefix-map='$(CURDIR)'=.)
ifneq ($(SAME_FOLDER),)
SAME_FOLDER += -ffile-prefix-map='$(BUILD)'=build
endif
ARCHIVE := $(AR) $(if $(findstring darwin,$(MACHINE)),rcs,rcsD)
