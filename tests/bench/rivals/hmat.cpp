// The algebra of a library of hierarchical matrices, HMAT-OSS: the matrix of a disc is compressed by adaptive cross
// approximation, factored and solved once, all to the tolerance named when it starts. Its entries are read from the whole
// matrix, so that none of them costs more than a read.
#include "serve.hpp"

#include <hmat/hmat.h>

#include <cstdlib>
#include <memory>

namespace {

struct Whole {
  const double* a;
  int n;
};

void entry(void* context, int row, int column, void* result) {
  const Whole& whole = *static_cast<const Whole*>(context);
  *static_cast<double*>(result) = whole.a[row + static_cast<size_t>(column) * static_cast<size_t>(whole.n)];
}

// Where the unknowns are: two at each node of a disc.
hmat_cluster_tree_t* tree_of(int n) {
  std::vector<double> xy;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979324 * (i / 2) / (n / 2);
    xy.push_back(std::cos(angle)), xy.push_back(std::sin(angle));
  }
  const std::unique_ptr<hmat_clustering_algorithm_t, void (*)(hmat_clustering_algorithm_t*)> median(
      hmat_create_clustering_median(), hmat_delete_clustering);
  return hmat_create_cluster_tree(xy.data(), 2, n, median.get());
}

void solve(const hmat_interface_t& hmat, double tolerance, int n, const double* a, double* x) {
  Whole whole = {a, n};
  hmat_cluster_tree_t* const tree = tree_of(n);
  hmat_admissibility_t* const apart = hmat_create_admissibility_standard(2);
  hmat_matrix_t* const matrix = hmat.create_empty_hmatrix_admissibility(tree, tree, 0, apart);
  hmat.set_low_rank_epsilon(matrix, tolerance);
  hmat_assemble_context_t assembly;
  hmat_assemble_context_init(&assembly);
  assembly.user_context = &whole;
  assembly.compression = hmat_create_compression_aca_plus(tolerance);
  assembly.simple_compute = entry;
  assembly.progress = nullptr;
  hmat_factorization_context_t factorization;
  hmat_factorization_context_init(&factorization);
  factorization.progress = nullptr;
  const bool done = hmat.assemble_generic(matrix, &assembly) == 0 && hmat.factorize_generic(matrix, &factorization) == 0 &&
                    hmat.solve_systems(matrix, x, 1) == 0;
  hmat_delete_compression(assembly.compression);
  hmat_delete_admissibility(apart);
  hmat.destroy(matrix);
  hmat_delete_cluster_tree(tree);
  if (!done) std::exit(4);
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const double tolerance = std::atof(argv[1]);
  hmat_interface_t hmat;
  hmat_init_default_interface(&hmat, HMAT_DOUBLE_PRECISION);
  if (hmat.init() != 0) return 2;
  return rival::serve([&](int n, double* a, double* x) { solve(hmat, tolerance, n, a, x); }, [] { return 0.0; });
}
