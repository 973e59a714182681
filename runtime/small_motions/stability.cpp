// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/stability.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "torsor/runtime/numerics/decompositions.hpp"
#include "torsor/runtime/records/table.hpp"
#include "torsor/runtime/small_motions/characteristic_polynomial.hpp"

namespace torsor::runtime {

StabilityReport stability_by_lejeune_dirichlet(const Eigen::MatrixXd& hessian, double tolerance) {
  if (hessian.rows() == 0 || hessian.rows() != hessian.cols() || !hessian.allFinite()) {
    throw std::invalid_argument("the Hessian of -(U + T0) must be square and finite");
  }
  const std::string law = "Lejeune-Dirichlet: ";
  const double largest = hessian.cwiseAbs().maxCoeff();
  if (largest == 0.0) return {Stability::cannot_conclude, law + "the Hessian of -(U + T0) vanishes"};
  const Eigen::MatrixXd scaled = hessian / largest;
  const double asymmetry = (scaled - scaled.transpose()).cwiseAbs().maxCoeff();
  if (asymmetry > tolerance) {
    return {Stability::cannot_conclude,
            law + "the matrix is not symmetric (by " + scientific(asymmetry) +
                " of its largest entry): the static forces have no force function, the criterion does not apply"};
  }
  const double least = symmetric_eigenpairs(0.5 * (scaled + scaled.transpose())).values(0);
  const std::string number =
      "the smallest eigenvalue of the Hessian of -(U + T0) is " + scientific(least) + " of its largest entry";
  if (least > tolerance) return {Stability::stable, law + number + ": a strict minimum"};
  if (least < -tolerance) {
    return {Stability::cannot_conclude, law + number + ": no minimum to this order, which proves nothing by itself"};
  }
  return {Stability::cannot_conclude,
          law + number + ", zero within " + scientific(tolerance) + ": the second order does not decide"};
}

StabilityReport stability_by_lejeune_dirichlet(const LinearSystem& system, double tolerance) {
  return stability_by_lejeune_dirichlet(normalised(system).S, tolerance);
}

namespace {

/// `uncertain`: what each root may be off by.
StabilityReport by_roots(const Eigen::VectorXcd& roots, const Eigen::VectorXd& uncertain, const std::string& equation) {
  Eigen::Index rightmost = 0;
  roots.real().maxCoeff(&rightmost);
  const std::string text = "Liapunov: the largest real part of the roots of " + equation + " is " +
                           scientific(roots(rightmost).real()) + " 1/s, zero being below " +
                           scientific(uncertain(rightmost)) + " 1/s";
  if ((roots.real() - uncertain).maxCoeff() > 0.0) return {Stability::unstable, text};
  if ((roots.real() + uncertain).maxCoeff() < 0.0) return {Stability::asymptotically_stable, text};
  return {Stability::cannot_conclude,
          text + ": roots on the imaginary axis leave the decision to the terms of higher order"};
}

/// D⁻¹ A D with D of powers of 2, rows and columns of like size: the same roots, whatever the units of the states.
/// Source: Parlett-Reinsch, Balancing a matrix for calculation of eigenvalues and eigenvectors, Num. Math. 13 (1969).
Eigen::MatrixXd balanced(Eigen::MatrixXd A) {
  constexpr int most_sweeps = 100;  // each makes the norm smaller by a part; three or four do in practice
  bool changed = true;
  for (int sweep = 0; changed && sweep < most_sweeps; ++sweep) {
    changed = false;
    for (Eigen::Index k = 0; k < A.rows(); ++k) {
      const double diagonal = std::abs(A(k, k));
      const double row = A.row(k).lpNorm<1>() - diagonal, column = A.col(k).lpNorm<1>() - diagonal;
      if (!(row > 0.0) || !(column > 0.0)) continue;
      const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
      if (!(column * factor + row / factor < 0.95 * (column + row))) continue;
      A.col(k) *= factor;
      A.row(k) /= factor;
      changed = true;
    }
  }
  return A;
}

/// A, balanced, without the rows and columns of states that nothing depends on, or that do not change: a root 0 each. A
/// column is rounding where each entry is beside others of its row, and a row where each is beside others of its column.
/// A diagonal entry is a rate, in 1/s whatever the states are measured in: it is rounding beside the rates √|A_ij A_ji|.
Eigen::MatrixXd without_idle_states(Eigen::MatrixXd A) {
  static constexpr double rounding = 1e-13;
  const double fastest = A.cwiseProduct(A.transpose()).cwiseAbs().maxCoeff();  // the square of that rate
  const auto idle = [&](Eigen::Index k) {
    if (std::abs(A(k, k)) > 64.0 * std::numeric_limits<double>::epsilon() * std::sqrt(fastest)) return false;
    const Eigen::MatrixXd sizes = A.cwiseAbs();
    const Eigen::VectorXd of_rows = sizes.rowwise().maxCoeff(), of_columns = sizes.colwise().maxCoeff();
    return (sizes.col(k).array() <= rounding * of_rows.array()).all() ||
           (sizes.row(k).transpose().array() <= rounding * of_columns.array()).all();
  };
  for (Eigen::Index k = 0; k < A.rows();) {
    if (!idle(k)) {
      ++k;
      continue;
    }
    const Eigen::Index rest = A.rows() - k - 1;
    A.middleRows(k, rest) = A.bottomRows(rest).eval();
    A.middleCols(k, rest) = A.rightCols(rest).eval();
    A.conservativeResize(A.rows() - 1, A.cols() - 1);
    k = 0;
  }
  return A;
}

}  // namespace

StabilityReport stability_by_eigenvalues(const LinearSystem& system, double tolerance) {
  const std::vector<DampedMode> modes = damped_modes(system);
  Eigen::VectorXcd roots(static_cast<Eigen::Index>(modes.size()));
  for (std::size_t k = 0; k < modes.size(); ++k) roots(static_cast<Eigen::Index>(k)) = modes[k].eigenvalue;
  const double zero = tolerance * roots.cwiseAbs().maxCoeff();
  return by_roots(roots, Eigen::VectorXd::Constant(roots.size(), zero), "det(M s^2 + C s + K)");
}

StabilityReport stability_by_eigenvalues(const Eigen::MatrixXd& A, double tolerance) {
  if (A.rows() == 0 || A.rows() != A.cols() || !A.allFinite()) {
    throw std::invalid_argument("a state matrix must be square and finite");
  }
  const Eigen::MatrixXd rest = balanced(without_idle_states(balanced(A)));
  const Eigen::Index idle = A.rows() - rest.rows();
  if (rest.rows() == 0) return {Stability::cannot_conclude, "Liapunov: all roots of det(A - s 1) are zero"};
  const auto [roots, right] = eigenpairs(rest);
  // Golub & Van Loan, Matrix Computations, 7.2.2: a simple root moves by the condition 1/|yᴴ x| times what A moves by.
  const Eigen::MatrixXcd left = right.inverse();
  const double rounding = 1e-14 * rest.norm(), zero = tolerance * roots.cwiseAbs().maxCoeff();
  Eigen::VectorXd uncertain(roots.size());
  for (Eigen::Index k = 0; k < roots.size(); ++k) {
    const double condition = left.row(k).norm() * right.col(k).norm();
    uncertain(k) = std::isfinite(condition) ? std::max(zero, condition * rounding) : std::numeric_limits<double>::max();
  }
  StabilityReport report = by_roots(roots, uncertain, "det(A - s 1)");
  if (idle > 0) {
    report.reason += "; besides, " + std::to_string(idle) +
                     " roots 0 of states that nothing depends on or that do not "
                     "change";
    if (report.verdict == Stability::asymptotically_stable) report.verdict = Stability::cannot_conclude;
  }
  return report;
}

StabilityReport stability_by_routh(const RouthTable& table) {
  const std::string text = "Routh: " + std::to_string(table.right) + " roots with Re > 0, " +
                           std::to_string(table.imaginary + table.zero) + " with Re = 0, " +
                           std::to_string(table.left) + " with Re < 0";
  if (table.right > 0) return {Stability::unstable, text};
  if (table.stable()) return {Stability::asymptotically_stable, text};
  return {Stability::cannot_conclude, text + ": the linearised equations do not decide"};
}

StabilityReport stability_by_routh(const LinearSystem& system) {
  const CharacteristicPolynomial polynomial = characteristic_polynomial(system);
  return stability_by_routh(routh_table(polynomial.coefficients, polynomial.uncertainties));
}

}  // namespace torsor::runtime
