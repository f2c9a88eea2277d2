# Speed, as a table: make bench SAVE=file keeps it, BASE=file compares with one that was kept, LARGE=1 adds the sizes
# that take minutes, ONLY=elimination,out_of_core,assembly,interior,events,bodies,compressed,program takes parts of it.
# Rivals are processes of their own, compiled if what they need is here; the library itself needs none of them.
#: make bench                       table of run times (SAVE=, BASE=, LARGE=1, ONLY=)
#: make guard, guard-save           instruction counts of fixed tasks against stored counts
BENCH := $(BUILD)/bench
BENCH_OBJECTS := $(patsubst tests/bench/%.cpp,$(BENCH)/%.o,$(wildcard tests/bench/*.cpp)) $(BENCH)/many_bodies.o
BENCH_PEAK_peak_avx2 := $(KERNEL_kernel_avx2)
BENCH_PEAK_peak_avx512 := $(KERNEL_kernel_avx512)
$(BENCH)/%.o: tests/bench/%.cpp $(BUILD)/flags tests/bench/bench.mk
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(EXACT) $(if $(filter peak_%,$*),-ffp-contract=fast $(BENCH_PEAK_$*)) \
	  $(DEPS) -c $< -o $@
$(BENCH)/many_bodies.o: tests/many_bodies.cpp $(BUILD)/flags tests/bench/bench.mk
	@mkdir -p $(@D)
	$(CXX) $(CPPFLAGS) $(COMMON) $(CXXFLAGS) $(EXACT) $(DEPS) -c $< -o $@
$(BENCH)/run_bench: $(BENCH_OBJECTS) $(LIBRARY)
	$(CXX) $(CXXFLAGS) $(LDFLAGS) -o $@ $^ -lm -pthread
$(BENCH)/empty $(BENCH)/spawn: $(BENCH)/%: tests/bench/%.c $(BUILD)/flags
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) $(LDFLAGS) -o $@ $<

# What there is of libraries. OpenBLAS on its own; the reference BLAS and LAPACK where Debian keeps them beside it.
# Eigen and a compiler of Fortran by trying.
HASH := \#
ifneq ($(filter bench,$(MAKECMDGOALS)),)
BENCH_FOLDERS := $(dir $(shell $(CXX) -print-file-name=libm.so)) /usr/lib/$(shell $(CC) -print-multiarch 2>/dev/null)/ /usr/lib64/ /usr/lib/
first_of = $(firstword $(wildcard $(foreach d,$(BENCH_FOLDERS),$(addprefix $(d),$(1)))))
OPENBLAS ?= $(call first_of,libopenblas.so.0 libopenblas.so)
REFERENCE_BLAS ?= $(call first_of,blas/libblas.so.3)
REFERENCE_LAPACK ?= $(call first_of,lapack/liblapack.so.3)
EIGEN_FLAGS ?= $(shell pkg-config --cflags eigen3 2>/dev/null || echo -I/usr/include/eigen3)
HAS_EIGEN := $(shell echo '$(HASH)include <Eigen/LU>' | $(CXX) $(EIGEN_FLAGS) -fsyntax-only -x c++ - 2>/dev/null && echo yes)
HAS_HMAT := $(shell echo '$(HASH)include <hmat/hmat.h>' | $(CXX) -fsyntax-only -x c++ - 2>/dev/null && echo yes)
BENCH_FC ?= $(firstword $(shell command -v gfortran flang 2>/dev/null))
endif
RIVALS := $(addprefix $(BENCH)/,rival_rows $(if $(OPENBLAS)$(REFERENCE_LAPACK),rival_lapack) \
  $(if $(HAS_EIGEN),rival_eigen rival_eigen_native) $(if $(HAS_HMAT),rival_hmat) $(if $(BENCH_FC),rival_rows_fortran))
RIVAL := $(CXX) -std=c++17 -O2
$(RIVALS): tests/bench/rivals/serve.hpp | $(BUILD)/flags
$(BENCH)/rival_rows: tests/bench/rivals/rows.cpp
	@mkdir -p $(@D)
	$(RIVAL) -o $@ $<
$(BENCH)/rival_rows_fortran: tests/bench/rivals/rows.cpp tests/bench/rivals/rows.f
	@mkdir -p $(@D)
	$(BENCH_FC) -O2 -c tests/bench/rivals/rows.f -o $(BENCH)/rows_f.o
	$(RIVAL) -DRIVAL_FORTRAN -o $@ $< $(BENCH)/rows_f.o
$(BENCH)/rival_lapack: tests/bench/rivals/lapack.cpp
	@mkdir -p $(@D)
	$(RIVAL) -o $@ $< -ldl
$(BENCH)/rival_eigen: tests/bench/rivals/eigen.cpp
	@mkdir -p $(@D)
	$(RIVAL) -DNDEBUG $(EIGEN_FLAGS) -o $@ $<
$(BENCH)/rival_eigen_native: tests/bench/rivals/eigen.cpp
	@mkdir -p $(@D)
	$(RIVAL) -O3 -march=native -DNDEBUG $(EIGEN_FLAGS) -o $@ $<

$(BENCH)/rival_hmat: tests/bench/rivals/hmat.cpp
	@mkdir -p $(@D)
	$(RIVAL) -o $@ $< -lhmat

bench: $(BENCH)/run_bench $(BENCH)/empty $(BENCH)/spawn $(RIVALS) $(PROGRAM)
	@$(BENCH)/run_bench --program $(PROGRAM) --empty $(BENCH)/empty --spawn $(BENCH)/spawn --examples examples --decks tests/data/decks \
	  --folder $(BENCH) --openblas '$(OPENBLAS)' --blas '$(REFERENCE_BLAS)' --lapack '$(REFERENCE_LAPACK)' \
	  --large '$(LARGE)' --only '$(ONLY)' --save '$(SAVE)' --base '$(BASE)'

# Guards against regressions that need no quiet machine: instruction counts. guard-save keeps those of this compiler.
GUARD = sh tests/bench/guard.sh $(1) $(BENCH)/run_bench $(PROGRAM) $(call object,src/linalg/kernel_avx512.cpp) tests/bench/guard.txt \
  '$(CXX)' '$(strip $(CPPFLAGS) $(CXXFLAGS))'
guard guard-save: $(BENCH)/run_bench $(PROGRAM)
	@$(call GUARD,$(if $(filter guard,$@),check,save))
.PHONY: guard guard-save
