# One file for those who vendor the library, and a Debian package: included by the Makefile.
#: make amalgamation, api, deb      one source file, one page of the interface, Debian packages
#: make reproducible                check that a build in another folder gives the same bytes
#: make release                     the files of a release: the program as a web page, one source file, the interface
.PHONY: amalgamation api deb reproducible release

# ---------------------------------------------------------------- make amalgamation
# The core and the block store in memory as one contact2d.cpp, and the headers beside it.
AMALGAMATION := $(BUILD)/amalgamation
AMALGAMATED  := $(CORE_SOURCES) port/memory/c2d_memory.cpp
# (Not after $(BUILD)/flags: `make web ONE_FILE=` would write its own there, and all of this build would be compiled again.)
$(BUILD)/obj/amalgamate: port/packaging/amalgamate.cpp
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) -std=c++17 $(WARNINGS) $(CXXFLAGS) $(LDFLAGS) -o $@ $<
$(AMALGAMATION)/contact2d.cpp: $(BUILD)/obj/amalgamate $(AMALGAMATED) $(wildcard include/*.h src/*/*.hpp src/*/*/*.hpp port/memory/*.h) LICENSE
	@mkdir -p $(@D)
	@$(BUILD)/obj/amalgamate $(VERSION) $(AMALGAMATED) > $@.new
	@mv $@.new $@
	@cp include/*.h port/memory/c2d_memory.h $(@D)/
amalgamation: $(AMALGAMATION)/contact2d.cpp
	@echo 'One file: $(AMALGAMATION)/contact2d.cpp, with the headers beside it (and c2d_memory.h for the store that is in it)'

# ---------------------------------------------------------------- make api
# The headers as one page of HTML, the interface first.
API_HEADERS := include/contact2d.h $(filter-out include/contact2d.h,$(sort $(wildcard include/*.h port/*/c2d_*.h)))
$(BUILD)/obj/header_page: port/packaging/header_page.cpp $(BUILD)/flags
	$(CXX) $(CPPFLAGS) -std=c++17 $(WARNINGS) $(CXXFLAGS) $(LDFLAGS) -o $@ $<
api: $(BUILD)/obj/header_page
	@mkdir -p $(BUILD)/api
	@$(BUILD)/obj/header_page $(VERSION) $(API_HEADERS) > $(BUILD)/api/contact2d.html.new
	@mv $(BUILD)/api/contact2d.html.new $(BUILD)/api/contact2d.html
	@echo 'The C interface: $(BUILD)/api/contact2d.html (open it with a browser)'

# ---------------------------------------------------------------- make release
# Files with the version in their names, and their checksums. The page runs from a disk: those who have no compiler need nothing else.
# The archive has no times, owners or order of its own: the same bytes anywhere.
RELEASE := $(BUILD)/release
release: web amalgamation api
	@rm -rf $(RELEASE)
	@mkdir -p $(RELEASE)
	@cp $(BUILD)/web/contact2d.html $(RELEASE)/contact2d-$(VERSION).html
	@cp $(BUILD)/web/contact2d.js $(RELEASE)/contact2d-$(VERSION).js
	@cp $(BUILD)/api/contact2d.html $(RELEASE)/contact2d-$(VERSION)-interface.html
	@tar -C $(AMALGAMATION) --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=a+r,u+w,go-w -cf - . | gzip -9n \
	  > $(RELEASE)/contact2d-$(VERSION)-one-file.tar.gz
	@cd $(RELEASE) && sha256sum contact2d-* > SHA256SUMS && cat SHA256SUMS

# ---------------------------------------------------------------- make man
# The page for man, from the tables of the program.
#: make man                         rewrite port/packaging/contact2d.1.in
.PHONY: man
man: $(PROGRAM)
	$(PROGRAM) help --man | sed 's/"contact2d $(VERSION)"/"contact2d @VERSION@"/' > port/packaging/contact2d.1.in.new
	mv port/packaging/contact2d.1.in.new port/packaging/contact2d.1.in

# ---------------------------------------------------------------- make deb
# Needs dpkg-dev and debhelper, and lintian to look at the outcome (none of them reaches for a network). All in a
# folder of its own, made anew: the sources as they stand there, then the packages beside them.
DEB := $(BUILD)/deb
DEB_TREE := $(DEB)/contact2d-$(VERSION)
DEB_SOURCES := CITATION.cff CMakeLists.txt LICENSE Makefile README.md examples include port src tests
deb:
	@command -v dpkg-buildpackage >/dev/null && command -v dh >/dev/null || \
	  { echo 'make deb needs dpkg-buildpackage and dh (Debian: dpkg-dev debhelper)'; exit 1; }
	@rm -rf $(DEB)
	@mkdir -p $(DEB_TREE)
	@cp -R $(DEB_SOURCES) $(DEB_TREE)/
	@mv $(DEB_TREE)/port/debian $(DEB_TREE)/debian
	@grep -q '^contact2d ($(VERSION)) ' $(DEB_TREE)/debian/changelog || \
	  { echo 'port/debian/changelog does not begin with version $(VERSION)'; exit 1; }
	@cd $(DEB_TREE) && env -u MAKEFLAGS -u MAKELEVEL dpkg-buildpackage --build=binary --unsigned-changes \
	  --unsigned-buildinfo > ../build.log 2>&1 || { tail -40 ../build.log; exit 1; }
	@if command -v lintian >/dev/null; then lintian --fail-on error --allow-root $(DEB)/*.changes; \
	  else echo 'lintian is not installed: the packages were not looked at'; fi
	@ls $(DEB)/*.deb

# ---------------------------------------------------------------- make reproducible
# One file and packages (with library and program) once more, from a copy of the sources in a folder of another name, with
# other rights, locale and time zone, by one job: the same bytes.
AGAIN := $(BUILD)/reproducible/in_a_folder_with_a_longer_name
reproducible: amalgamation deb
	@rm -rf $(BUILD)/reproducible
	@mkdir -p $(AGAIN)
	@cp -R $(DEB_SOURCES) $(AGAIN)/
	@umask 027; unset MAKEFLAGS MAKELEVEL; LC_ALL=C.UTF-8 TZ=Asia/Kolkata $(MAKE) -s -C $(AGAIN) BUILD=out amalgamation deb > $(AGAIN)/log 2>&1 || \
	  { tail -20 $(AGAIN)/log; exit 1; }
	@cd $(BUILD); \
	  for file in amalgamation/contact2d.cpp deb/*.deb; do cmp $$file reproducible/$(notdir $(AGAIN))/out/$$file || exit 1; \
	    echo "reproducible: $$file"; done
