# What is compiled, one file a line: read by Makefile (include) and by CMakeLists.txt (file(STRINGS)).
# `make list` compares it with the folders, `make relist` writes it anew.
