// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include "runtime/characteristic_polynomial.hpp"
#include "runtime/linear_system.hpp"
#include "runtime/modes.hpp"
#include "runtime/routh.hpp"

namespace torsor::runtime {

/// What a criterion says about a rest or a steady motion. "Cannot conclude" is an answer.
enum class Stability { stable, asymptotically_stable, unstable, cannot_conclude };

[[nodiscard]] constexpr std::string_view describe(Stability stability) noexcept {
  switch (stability) {
    case Stability::stable:
      return "stable";
    case Stability::asymptotically_stable:
      return "asymptotically stable";
    case Stability::unstable:
      return "unstable";
    case Stability::cannot_conclude:
      return "cannot conclude";
  }
  return "unknown verdict";
}

struct StabilityReport {
  Stability verdict = Stability::cannot_conclude;
  std::string reason;  ///< the criterion and the numbers it was decided by
};

/// Lejeune-Dirichlet (Pommier, §7.4.2): a rest, absolute or relative, where −(U + T0) has a strict minimum is stable,
/// also with dissipative and gyroscopic forces. `hessian` is that of −(U + T0) with respect to independent coordinates
/// of like units. Eigenvalues below `tolerance` times the largest entry count as zero.
/// A Hessian that is not positive definite proves nothing: gyroscopic forces may stabilise, higher orders may hold.
[[nodiscard]] inline StabilityReport stability_by_lejeune_dirichlet(const Eigen::MatrixXd& hessian,
                                                                    double tolerance = 1e-9) {
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

/// The same with K of the equations linearised about the rest as Hessian (all static forces derive from U + T0), in
/// coordinates normalised by the masses, so that units do not matter: what is compared is the squares of frequencies.
[[nodiscard]] inline StabilityReport stability_by_lejeune_dirichlet(const LinearSystem& system,
                                                                    double tolerance = 1e-9) {
  return stability_by_lejeune_dirichlet(normalised(system).S, tolerance);
}

/// Liapunov's first method (Pommier, §7.4.3) on M x'' + C x' + K x = 0, the linearised equations: a root of
/// det(M s² + C s + K) with Re > 0 is unstable even if others have Re = 0; all Re < 0 is asymptotically stable;
/// otherwise the linearised equations cannot conclude. |Re| below `tolerance` times the largest |s| counts as zero: a
/// double root is known to the square root of rounding only.
[[nodiscard]] inline StabilityReport stability_by_eigenvalues(const LinearSystem& system, double tolerance = 1e-7) {
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

/// The same verdict from a Routh table: without any root.
[[nodiscard]] inline StabilityReport stability_by_routh(const RouthTable& table) {
  const std::string text = "Routh: " + std::to_string(table.right) + " roots with Re > 0, " +
                           std::to_string(table.imaginary + table.zero) + " with Re = 0, " +
                           std::to_string(table.left) + " with Re < 0";
  if (table.right > 0) return {Stability::unstable, text};
  if (table.stable()) return {Stability::asymptotically_stable, text};
  return {Stability::cannot_conclude, text + ": the linearised equations do not decide"};
}

[[nodiscard]] inline StabilityReport stability_by_routh(const LinearSystem& system) {
  const CharacteristicPolynomial polynomial = characteristic_polynomial(system);
  return stability_by_routh(routh_table(polynomial.coefficients, polynomial.uncertainties));
}

}  // namespace torsor::runtime
