# make windows: the program for Windows, build/windows/contact2d.exe: one file that needs no libraries but the system's. The
# rules of the Makefile once more, by MinGW (Debian: g++-mingw-w64-x86-64-posix). Included by the Makefile.
#: make windows                     the program for Windows, build/windows/contact2d.exe
.PHONY: windows
WINDOWS_TOOLS ?= x86_64-w64-mingw32-
WINDOWS_CXX   ?= $(WINDOWS_TOOLS)g++-posix
WINDOWS_CPPFLAGS := -Iport/windows/include -D_FILE_OFFSET_BITS=64 -D_WIN32_WINNT=0x0A00 -Dmain=contact2d_main -Wa,-mbig-obj
windows:
	+$(MAKE) BUILD='$(BUILD)/windows' CXX='$(WINDOWS_CXX)' CC='$(WINDOWS_TOOLS)gcc-posix' AR='$(WINDOWS_TOOLS)ar' \
	  CPPFLAGS='$(WINDOWS_CPPFLAGS)' LDFLAGS='-static -municode -Wl,--stack,8388608' '$(BUILD)/windows/contact2d.exe'
	@echo 'The program for Windows: $(BUILD)/windows/contact2d.exe (port/windows/README.md)'

WINDOWS_SOURCES := $(sort $(wildcard port/windows/*.cpp))
$(foreach s,$(WINDOWS_SOURCES),$(eval $(call compile,$(s))))
$(BUILD)/contact2d.exe: $(PROGRAM_OBJECTS) $(REPORT_OBJECTS) $(call objects,$(WINDOWS_SOURCES)) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -Wl,--strip-all,--no-insert-timestamp -o $@ $^ -lntdll -pthread
