// Eigen's LU with partial pivoting, in place as the others do it.
#include "serve.hpp"

#include <Eigen/LU>

int main() {
  return rival::serve(
      [](int n, double* a, double* x) {
        Eigen::Map<Eigen::MatrixXd> matrix(a, n, n);
        Eigen::Map<Eigen::VectorXd> vector(x, n);
        const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXd>> lu(matrix);
        vector = lu.solve(vector).eval();
      },
      [] { return 0.0; });
}
