// SPDX-License-Identifier: MIT
#include "runtime/stability.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "runtime/characteristic_polynomial.hpp"
#include "runtime/table.hpp"

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
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (scaled + scaled.transpose()),
                                                              Eigen::EigenvaluesOnly);
  const double least = solver.eigenvalues()(0);
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

StabilityReport stability_by_eigenvalues(const LinearSystem& system, double tolerance) {
  double rightmost = -std::numeric_limits<double>::infinity(), largest = 0.0;
  for (const DampedMode& mode : damped_modes(system)) {
    rightmost = std::max(rightmost, mode.eigenvalue.real());
    largest = std::max(largest, std::abs(mode.eigenvalue));
  }
  const double zero = tolerance * largest;
  const std::string text = "Liapunov: the largest real part of the roots of det(M s^2 + C s + K) is " +
                           scientific(rightmost) + " 1/s, zero being below " + scientific(zero) + " 1/s";
  if (rightmost > zero) return {Stability::unstable, text};
  if (rightmost < -zero) return {Stability::asymptotically_stable, text};
  return {Stability::cannot_conclude,
          text + ": roots on the imaginary axis leave the decision to the terms of higher order"};
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
