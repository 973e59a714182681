// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <string>
#include <string_view>

#include "torsor/runtime/small_motions/linear_system.hpp"
#include "torsor/runtime/small_motions/modes.hpp"
#include "torsor/runtime/small_motions/routh.hpp"

namespace torsor::runtime {

/// What a criterion says about a rest or a steady motion. "Cannot conclude" is an answer.
///
/// Stable is meant in Liapunov's sense: for every ε > 0 there is a λ > 0 such that a motion whose coordinates and
/// velocities differ by less than λ at the start differs by less than ε for all time after. (Pommier, §7.4.3, has the
/// quantifiers exchanged, "for every λ there is an ε": so read, every rest whose neighbours keep within bounds would be
/// stable.) Asymptotically stable: the difference goes to zero as well. Unstable: there is an ε for which no λ will do.
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
[[nodiscard]] StabilityReport stability_by_lejeune_dirichlet(const Eigen::MatrixXd& hessian, double tolerance = 1e-9);

/// The same with K of the equations linearised about the rest as Hessian (all static forces derive from U + T0), in
/// coordinates normalised by the masses, so that units do not matter: what is compared is the squares of frequencies.
[[nodiscard]] StabilityReport stability_by_lejeune_dirichlet(const LinearSystem& system, double tolerance = 1e-9);

/// Liapunov's first method (Pommier, §7.4.3) on M x'' + C x' + K x = 0, the linearised equations: a root of
/// det(M s² + C s + K) with Re > 0 is unstable even if others have Re = 0; all Re < 0 is asymptotically stable;
/// otherwise the linearised equations cannot conclude. |Re| below `tolerance` times the largest |s| counts as zero: a
/// double root is known to the square root of rounding only.
[[nodiscard]] StabilityReport stability_by_eigenvalues(const LinearSystem& system, double tolerance = 1e-7);

/// The same on x' = A x, A of the kernel `linearisation` (`state_matrix`): about steady motions too, with constraints of
/// any kind. States that nothing depends on, or that do not change (cyclic coordinates, their momenta), are taken out
/// first, each a root 0 that leaves the method without a conclusion unless another root is unstable. A root counts as
/// zero also below what rounding may move it by, for a multiple root is known badly. Throws std::invalid_argument for a
/// matrix that is not square and finite.
[[nodiscard]] StabilityReport stability_by_eigenvalues(const Eigen::MatrixXd& A, double tolerance = 1e-7);

/// The same verdict from a Routh table: without any root.
[[nodiscard]] StabilityReport stability_by_routh(const RouthTable& table);

[[nodiscard]] StabilityReport stability_by_routh(const LinearSystem& system);

}  // namespace torsor::runtime
