# make cross: the library and the program for other machines and by other compilers; the sample deck against this
# machine's run; blocks of one machine before the library of another. CROSS_ONLY=s390x: one of i686, s390x, g++-11, clang-13, and
# for another machine the library alone. What is not installed is told and left out, with C2D_ALL_HOSTS=1 it is an error. Debian:
# g++-i686-linux-gnu g++-s390x-linux-gnu qemu-user g++-11 clang-13.
#: make cross                       other machines and older compilers (CROSS_ONLY=)
.PHONY: cross
CROSS := $(BUILD)/cross
cross: $(PROGRAM) $(LIBRARY) $(EMBEDDED)/compare
	@MAKEFLAGS= JOBS='$(JOBS)' CROSS_ONLY='$(CROSS_ONLY)' CC='$(CC)' MAKE='$(MAKE)' sh tests/cross/cross.sh $(CROSS) $(BUILD) $(EMBEDDED)/compare
