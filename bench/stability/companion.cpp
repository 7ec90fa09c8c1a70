#include <Eigen/Eigenvalues>

#include "stability/solvers.h"

namespace rt::bench {

int companion_roots(double c2, double c1, double c0, double* roots) {
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.diagonal(-1).setOnes();
  companion.col(3) << -c0, -c1, -c2, 0;
  const Eigen::EigenSolver<Eigen::Matrix4d> solver(companion, false);
  int count = 0;
  for (int i = 0; i < 4; ++i) {
    // Real eigenvalues come out of the real Schur form exactly real.
    if (solver.eigenvalues()[i].imag() == 0) {
      roots[count++] = solver.eigenvalues()[i].real();
    }
  }
  return count;
}

}  // namespace rt::bench
