// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "torsor/runtime/integration/adaptive_run.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/numerics/jacobian.hpp"
#include "torsor/runtime/numerics/shifted_system.hpp"
#include "torsor/runtime/steps/radau_formula.hpp"
#include "torsor/runtime/steps/second_order.hpp"

namespace torsor::runtime {

/// The equations y' = f(t, y) as RadauFormula wants them: the Jacobian of the system, or differences, and its two
/// shifts.
template <class S, class Scalar, std::size_t size>
class RadauEquations {
 public:
  static constexpr std::size_t extra = 0;
  using Vector = std::array<Scalar, size>;
  using Pairs = std::array<Complex<Scalar>, size>;

  template <class F>
  [[nodiscard]] bool linearise(F& f, Scalar t, const Vector& y, const Vector& slope) {
    return evaluate_jacobian(f, t, y, slope, J_);
  }

  template <class F>
  [[nodiscard]] Evaluation factorise(F& f, Scalar real, const Complex<Scalar>& pair) noexcept {
    f.decompositions += 2;
    const Evaluation evaluation = real_.factorise(J_, real);
    return evaluation == Evaluation::ok ? pair_.factorise(J_, pair) : evaluation;
  }

  template <class F>
  [[nodiscard]] bool evaluate(F& f, Scalar t, const Vector& x, Vector& slope) {
    return f(t, x, slope);
  }

  void solve(Vector& r) const noexcept { real_.solve(J_, r); }
  void solve(Pairs& r) const noexcept { pair_.solve(J_, r); }

  template <class F>
  [[nodiscard]] bool finish(F&, Scalar, const Vector&, Vector&) const noexcept {
    return true;
  }

 private:
  static constexpr bool second_order = is_second_order<S> && size % 2 == 0;

  JacobianMatrix<Scalar, size> J_{};
  ShiftedSystem<Scalar, Scalar, size, second_order> real_;
  ShiftedSystem<Complex<Scalar>, Scalar, size, second_order> pair_;
};

/// Radau IIA of order 5 for stiff mechanisms: collocation at three nodes, the last at the end of the step,
///   Z_i = h Σ_j a_ij f(t + c_j h, y + Z_j),   y(t + h) = y + Z_3,
/// L-stable, so that what decays fast is gone and steps follow the slow motion.
///
/// The stages are solved by simplified Newton iterations in coordinates where one real and one complex system of the
/// state's size remain, half of it where q' = v (`second_order`). The Jacobian is the system's own
/// (`jacobian(t, y, J)`, which `equations_of_motion` offers where the derivatives were generated), else differences; it
/// is kept while it serves. The error is that of an embedded formula of order 3, filtered by the real system; as in
/// radau5, it is held to 0.1 tolerance^(2/3) so that the solution of order 5 meets the tolerance. The step control is
/// predictive (Gustafsson). Observers may take the collocation polynomial, of order 3 inside a step.
/// Source: Hairer-Wanner II, IV.8; Gustafsson, ACM TOMS 20 (1994); the authors' code radau5.
struct RadauIia5 {
  double relative_tolerance = 1e-9;      ///< 0, or at least four roundings of the scalar
  double absolute_tolerance = 1e-12;     ///< in the units of the state, the same for every component
  double first_step = 0.0;               ///< 0: chosen from the equations
  double largest_step = 0.0;             ///< 0: no limit
  std::int64_t step_limit = 10'000'000;  ///< accepted and rejected together
  bool compensated = false;              ///< carry what rounding loses of each sum of state and step

  static constexpr int order = 5;
  static constexpr bool coarse_inside = true;  ///< events are located on steps of the method

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const noexcept {
    return AdaptiveRun<RadauFormula<RadauEquations<S, Scalar, size>, Scalar, size>, RadauIia5, S, Scalar, size>(
        system, y, t, *this);
  }
};

}  // namespace torsor::runtime
