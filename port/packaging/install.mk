# make install, make uninstall: program, libraries, headers, pages and what pkg-config and CMake look for. Included by the Makefile.
#: make install, uninstall          (PREFIX=, DESTDIR=, LIBDIR=, BINDIR=, MANDIR=, INCLUDEDIR=, DOCDIR=)
.PHONY: install uninstall
PREFIX     ?= /usr/local
LIBDIR     ?= $(PREFIX)/lib
BINDIR     ?= $(PREFIX)/bin
MANDIR     ?= $(PREFIX)/share/man
INCLUDEDIR ?= $(PREFIX)/include
DOCDIR     ?= $(PREFIX)/share/doc/contact2d

HEADERS := $(wildcard include/*.h port/*/c2d_*.h) port/fortran/contact2d.f90
CMAKEDIR := $(LIBDIR)/cmake/contact2d
# Pages keep their places, and with them the links from one to another.
PAGES := $(wildcard *.md src/*.md src/*/*.md src/program/*/*.md include/*.md port/*.md port/*/*.md tests/*.md)
PAGES := $(sort $(PAGES))
EXAMPLES := $(sort $(shell find examples -type f)) # what the pages run
# Where shells look for completions, and how `contact2d completion` calls each.
BASHDIR ?= $(PREFIX)/share/bash-completion/completions
ZSHDIR  ?= $(PREFIX)/share/zsh/site-functions
FISHDIR ?= $(PREFIX)/share/fish/vendor_completions.d
COMPLETIONS := bash:$(BASHDIR)/contact2d zsh:$(ZSHDIR)/_contact2d fish:$(FISHDIR)/contact2d.fish
INSTALLED := $(BINDIR)/contact2d $(MANDIR)/man1/contact2d.1 $(LIBDIR)/libcontact2d.a $(LIBDIR)/libcontact2d.so.$(VERSION) \
  $(LIBDIR)/libcontact2d.so.$(SOVERSION) $(LIBDIR)/libcontact2d.so \
  $(addprefix $(INCLUDEDIR)/,$(notdir $(HEADERS))) $(LIBDIR)/pkgconfig/contact2d.pc \
  $(CMAKEDIR)/contact2dConfig.cmake $(CMAKEDIR)/contact2dConfigVersion.cmake $(addprefix $(DOCDIR)/,$(PAGES) $(EXAMPLES)) \
  $(foreach c,$(COMPLETIONS),$(lastword $(subst :, ,$(c))))
# From the folder of CMake's configuration to the headers, so that both can be moved with their prefix.
below = $(if $(and $(filter $(PREFIX)/%,$(1)),$(PREFIX)),$(patsubst $(PREFIX)/%,%,$(1)))
INCLUDE_FROM_CONFIG := $(if $(and $(call below,$(CMAKEDIR)),$(call below,$(INCLUDEDIR))),\
  $${contact2d_here}/$(subst $(empty) $(empty),/,$(patsubst %,..,$(subst /, ,$(call below,$(CMAKEDIR)))))/$(call below,$(INCLUDEDIR)),\
  $(INCLUDEDIR))
fill = sed -e 's|@PREFIX@|$(PREFIX)|g' -e 's|@LIBDIR@|$(LIBDIR)|g' -e 's|@INCLUDEDIR@|$(INCLUDEDIR)|g' \
  -e 's|@VERSION@|$(VERSION)|g' -e 's|@SOVERSION@|$(SOVERSION)|g' \
  -e 's|@INCLUDE_FROM_CONFIG@|$(strip $(INCLUDE_FROM_CONFIG))|g'

install: all $(SHARED)
	mkdir -p '$(DESTDIR)$(BINDIR)' '$(DESTDIR)$(MANDIR)/man1' '$(DESTDIR)$(LIBDIR)/pkgconfig' '$(DESTDIR)$(CMAKEDIR)' '$(DESTDIR)$(INCLUDEDIR)'
	install -m 755 $(PROGRAM) '$(DESTDIR)$(BINDIR)/contact2d'
	install -m 644 $(HEADERS) '$(DESTDIR)$(INCLUDEDIR)/'
	install -m 644 $(LIBRARY) '$(DESTDIR)$(LIBDIR)/'
	install -m 755 $(SHARED) '$(DESTDIR)$(LIBDIR)/'
	ln -sf libcontact2d.so.$(VERSION) '$(DESTDIR)$(LIBDIR)/libcontact2d.so.$(SOVERSION)'
	ln -sf libcontact2d.so.$(SOVERSION) '$(DESTDIR)$(LIBDIR)/libcontact2d.so'
	$(fill) port/packaging/contact2d.1.in > '$(DESTDIR)$(MANDIR)/man1/contact2d.1'
	$(fill) port/packaging/contact2d.pc.in > '$(DESTDIR)$(LIBDIR)/pkgconfig/contact2d.pc'
	$(fill) port/packaging/contact2dConfig.cmake.in > '$(DESTDIR)$(CMAKEDIR)/contact2dConfig.cmake'
	$(fill) port/packaging/contact2dConfigVersion.cmake.in > '$(DESTDIR)$(CMAKEDIR)/contact2dConfigVersion.cmake'
# (a program for another machine cannot say its completions here: they are left out, with a message)
	for pair in $(COMPLETIONS); do file='$(DESTDIR)'$${pair#*:}; mkdir -p "$$(dirname "$$file")" && \
	  $(PROGRAM) completion $${pair%%:*} > "$$file" || { rm -f "$$file"; echo "no completion for $${pair%%:*}: $(PROGRAM) does not run here"; }; done
	for page in $(PAGES) $(EXAMPLES); do mkdir -p '$(DESTDIR)$(DOCDIR)'/$$(dirname $$page) && \
	  install -m 644 $$page '$(DESTDIR)$(DOCDIR)'/$$page || exit 1; done

uninstall:
	for file in $(INSTALLED); do rm -f '$(DESTDIR)'$$file; done
	-rmdir '$(DESTDIR)$(CMAKEDIR)' 2>/dev/null || true
	-find '$(DESTDIR)$(DOCDIR)' -depth -type d -exec rmdir {} + 2>/dev/null || true

