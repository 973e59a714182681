// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/numerics/lu.hpp"
#include "torsor/runtime/steps/accumulated_state.hpp"
#include "torsor/runtime/steps/dense_step.hpp"
#include "torsor/runtime/steps/radau_tableau.hpp"
#include "torsor/runtime/steps/step_control.hpp"

namespace torsor::runtime {

/// Stages, error, lengths and interpolant of one step of Radau IIA of order 5; see AdaptiveRun.
///
/// `Equations` holds what is solved, x' = F(t, x) with `extra` unknowns after y whose equations are algebraic, 0 = F:
///   linearise(f, t, y, slope)       the derivatives at a place; false where the model failed;
///   factorise(f, real, pair)        the matrices of the shifts by an eigenvalue and a pair over h;
///   evaluate(f, t, x, F)            false where the model failed;
///   solve(r)                        by the real or the complex matrix, according to r;
///   finish(f, t, y, change)         a last word on the change of y that a step brings.
template <class Equations, class Scalar, std::size_t size>
class RadauFormula {
 public:
  using Vector = std::array<Scalar, size>;
  using Step = DenseStep<Scalar, size>;
  using State = AccumulatedState<Scalar, size>;

  template <class Options>
  explicit RadauFormula(const Options&) noexcept {}
  template <class Options>
  static bool usable(const Options&) noexcept {
    return true;
  }

  template <class F>
  Evaluation prepare(F& f, const StepsAhead<Scalar, size>& ahead, Scalar& length) {
    const auto& tolerances = ahead.tolerances;
    // The estimate is two orders below the method: it is held to a tolerance as much larger.
    const Scalar given = tolerances.relative > Scalar(0) ? tolerances.relative : tolerances.absolute;
    const Scalar factor = Scalar(0.1) / std::cbrt(given);
    tolerances_ = {tolerances.relative * factor, tolerances.absolute * factor};
    const Scalar held = given * factor;
    enough_ = std::max(Scalar(10) * epsilon / held, std::min(Scalar(0.03), std::sqrt(held)));
    if (!f(ahead.range.start, ahead.y, slope_)) return f.evaluation;
    slope_known_ = true;
    if (!(length > Scalar(0))) length = starting_step(f, {ahead.range, ahead.y, tolerances_}, slope_, 4);
    return Evaluation::ok;
  }

  /// One step of length h to state.next(). Where Newton's method fails the error is infinite and `shorter` knows how
  /// far to go back.
  template <class F>
  Evaluation attempt(F& f, Scalar t, Scalar h, State& state, Scalar& error) {
    const Vector& y = state.now();
    proposal_ = Scalar(0.5) * std::abs(h);
    if (!slope_known_ && !f(t, y, slope_)) return f.evaluation;
    slope_known_ = true;
    for (std::size_t i = 0; i < size; ++i) {
      magnitude_[i] = std::abs(y[i]);
      const bool scaled = tolerances_.absolute > Scalar(0) || magnitude_[i] > Scalar(0);
      if (!scaled) magnitude_[i] = std::numeric_limits<Scalar>::infinity();
    }
    if (!jacobian_known_) {
      if (!equations_.linearise(f, t, y, slope_)) return f.evaluation;
      jacobian_known_ = jacobian_fresh_ = true;
      factorised_ = Scalar(0);
    }
    // A matrix of nearly this length serves as well: the clock rounds lengths.
    if (!(std::abs(h - factorised_) <= Scalar(1e-3) * std::abs(h))) {
      const Evaluation evaluation = factorise(f, h);
      if (evaluation != Evaluation::ok) return refuse(evaluation);
    }
    guess(h);
    bool converged = false;
    const Evaluation evaluation = iterate(f, t, h, y, converged);
    if (evaluation != Evaluation::ok) return refuse(evaluation);
    if (!converged) {
      error = std::numeric_limits<Scalar>::infinity();
      return refuse(Evaluation::ok);
    }
    // Without an absolute tolerance what starts from zero has the scale of its way in the step.
    for (std::size_t i = 0; i < size; ++i) {
      const Scalar way = std::max({std::abs(z1_[i]), std::abs(z2_[i]), std::abs(z3_[i])});
      if (std::isinf(magnitude_[i]) && way > Scalar(0)) magnitude_[i] = way;
    }
    Vector change;
    std::copy_n(z3_.begin(), size, change.begin());
    if (!equations_.finish(f, t + h, y, change)) return refuse(f.evaluation);
    state.propose(change);
    if (!all_finite(state.next())) return refuse(Evaluation::not_finite);
    length_ = h;
    return estimate(f, t, h, y, error);
  }

  /// The length to try after a refusal.
  [[nodiscard]] Scalar shorter(Scalar h, Scalar error) noexcept {
    rejected_ = true;
    if (!std::isfinite(error)) return proposal_;
    if (!jacobian_fresh_) jacobian_known_ = false;
    return first_ ? h * Scalar(0.1) : h / quotient(error);
  }

  /// The length to try after a step kept: the lesser of what the last error and what the trend of two errors ask for.
  [[nodiscard]] Scalar longer(Scalar h, Scalar error, Scalar planned, bool after_rejection) noexcept {
    Scalar divisor = quotient(error);
    if (!first_) {
      const Scalar trend = last_length_ / h * std::pow(error * error / last_error_, Scalar(0.25)) / safety;
      divisor = std::max(divisor, std::clamp(trend, Scalar(0.125), Scalar(5)));
    }
    last_length_ = h;
    last_error_ = std::max(Scalar(0.01), error);
    Scalar proposal = h / divisor;
    if (after_rejection) proposal = std::min(proposal, h);
    // A step cut short by the end says little about how long the next one may be.
    if (h < planned * Scalar(0.99)) return std::max(proposal, planned);
    // A little more is not worth a decomposition.
    const bool same = serves() && proposal >= h && proposal <= Scalar(1.2) * h;
    return same ? h : proposal;
  }

  template <class F>
  Evaluation refine(F&, Scalar, Scalar, const State&) noexcept {
    return Evaluation::ok;
  }

  /// The collocation polynomial: y at the start, and y + Z_i at the nodes.
  [[nodiscard]] Step interpolant(Scalar t, Scalar t_next, Scalar, const State& state) const noexcept {
    Step step{t, t_next, {}};
    auto& c = step.coefficients;
    for (std::size_t i = 0; i < size; ++i) {
      c[0][i] = state.now()[i];
      c[1][i] = state.next()[i] - state.now()[i];
      polynomial(i, c[2][i], c[3][i]);
    }
    return step;
  }

  void accept() noexcept {
    for (std::size_t i = 0; i < size; ++i) polynomial(i, bend_[i], twist_[i]);
    std::copy_n(z3_.begin(), size, last_z_.begin());
    guessed_from_ = length_;
    first_ = rejected_ = slope_known_ = jacobian_fresh_ = false;
    jacobian_known_ = serves();
  }

 private:
  using T = RadauTableau<Scalar>;
  static constexpr std::size_t all = size + Equations::extra;
  using Extended = std::array<Scalar, all>;
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr Scalar safety = Scalar(0.9);
  static constexpr int most_iterations = 7;
  using Pair = Complex<Scalar>;

  // Whether Newton's method converged so fast that the next step may use the same Jacobian.
  [[nodiscard]] bool serves() const noexcept { return rate_ <= Scalar(0.001); }

  Evaluation refuse(Evaluation evaluation) noexcept {
    if (!jacobian_fresh_) jacobian_known_ = false;
    return evaluation;
  }

  template <class F>
  Evaluation factorise(F& f, Scalar h) noexcept {
    factorised_ = Scalar(0);
    const Evaluation evaluation = equations_.factorise(f, T::real / h, Pair{T::pair_re / h, T::pair_im / h});
    if (evaluation == Evaluation::ok) factorised_ = h;
    return evaluation;
  }

  // Z_i = θ (Z_3 + (1 - θ) (bend + θ twist)) at θ = c_i.
  void polynomial(std::size_t i, Scalar& bend, Scalar& twist) const noexcept {
    const Scalar at_1 = (z1_[i] / T::c1 - z3_[i]) / (Scalar(1) - T::c1);
    const Scalar at_2 = (z2_[i] / T::c2 - z3_[i]) / (Scalar(1) - T::c2);
    twist = (at_2 - at_1) / (T::c2 - T::c1);
    bend = at_1 - T::c1 * twist;
  }

  // The stages by the polynomial of the step before, and their transforms.
  void guess(Scalar h) noexcept {
    z1_.fill(Scalar(0));
    z2_.fill(Scalar(0));
    z3_.fill(Scalar(0));
    if (!first_) {
      const Scalar ratio = h / guessed_from_;
      for (std::size_t i = 0; i < size; ++i) {
        const auto beyond = [&](Scalar c) {
          const Scalar w = c * ratio, theta = Scalar(1) + w;
          return w * (last_z_[i] - theta * (bend_[i] + theta * twist_[i]));
        };
        z1_[i] = beyond(T::c1);
        z2_[i] = beyond(T::c2);
        z3_[i] = beyond(Scalar(1));
      }
    }
    for (std::size_t i = 0; i < all; ++i) {
      w1_[i] = T::i11 * z1_[i] + T::i12 * z2_[i] + T::i13 * z3_[i];
      w2_[i] = T::i21 * z1_[i] + T::i22 * z2_[i] + T::i23 * z3_[i];
      w3_[i] = T::i31 * z1_[i] + T::i32 * z2_[i] + T::i33 * z3_[i];
    }
  }

  static Extended place(const Vector& y, const Extended& z) noexcept {
    Extended x = z;
    for (std::size_t i = 0; i < size; ++i) x[i] += y[i];
    return x;
  }

  template <class F>
  Evaluation iterate(F& f, Scalar t, Scalar h, const Vector& y, bool& converged) {
    const Scalar real = T::real / h, re = T::pair_re / h, im = T::pair_im / h;
    margin_ = std::pow(std::max(margin_, epsilon), Scalar(0.8));
    rate_ = Scalar(0.001);
    Scalar last_size = Scalar(0), last_quotient = Scalar(0);
    Extended x, f1, f2, f3;
    for (iterations_ = 1;; ++iterations_) {
      if (iterations_ > most_iterations) return Evaluation::ok;
      if (!equations_.evaluate(f, t + T::c1 * h, place(y, z1_), f1)) return f.evaluation;
      if (!equations_.evaluate(f, t + T::c2 * h, place(y, z2_), f2)) return f.evaluation;
      if (!equations_.evaluate(f, t + h, place(y, z3_), f3)) return f.evaluation;
      for (std::size_t i = 0; i < all; ++i) {
        x[i] = T::i11 * f1[i] + T::i12 * f2[i] + T::i13 * f3[i];
        pair_side_[i] = {T::i21 * f1[i] + T::i22 * f2[i] + T::i23 * f3[i],
                         T::i31 * f1[i] + T::i32 * f2[i] + T::i33 * f3[i]};
      }
      for (std::size_t i = 0; i < size; ++i) {
        x[i] -= real * w1_[i];
        pair_side_[i].re -= re * w2_[i] - im * w3_[i];
        pair_side_[i].im -= re * w3_[i] + im * w2_[i];
      }
      equations_.solve(x);
      equations_.solve(pair_side_);
      Scalar sum = Scalar(0);
      for (std::size_t i = 0; i < size; ++i) {
        sum += tolerances_.square(x[i], magnitude_[i]) + tolerances_.square(pair_side_[i].re, magnitude_[i]) +
               tolerances_.square(pair_side_[i].im, magnitude_[i]);
      }
      const Scalar change = std::sqrt(sum / static_cast<Scalar>(3 * size));
      if (!std::isfinite(change)) return Evaluation::ok;
      if (iterations_ > 1 && iterations_ < most_iterations) {
        const Scalar quotient = change / last_size;
        rate_ = iterations_ == 2 ? quotient : std::sqrt(quotient * last_quotient);
        last_quotient = quotient;
        if (!(rate_ < Scalar(0.99))) return Evaluation::ok;
        margin_ = rate_ / (Scalar(1) - rate_);
        const int left = most_iterations - 1 - iterations_;
        const Scalar expected = margin_ * change * std::pow(rate_, static_cast<Scalar>(left)) / enough_;
        if (expected >= Scalar(1)) {  // what is left of the iterations will not do: how much shorter would?
          const Scalar bounded = std::clamp(expected, Scalar(1e-4), Scalar(20));
          proposal_ = Scalar(0.8) * std::abs(h) * std::pow(bounded, Scalar(-1) / static_cast<Scalar>(4 + left));
          return Evaluation::ok;
        }
      }
      last_size = std::max(change, epsilon);
      for (std::size_t i = 0; i < all; ++i) {
        w1_[i] += x[i];
        w2_[i] += pair_side_[i].re;
        w3_[i] += pair_side_[i].im;
        z1_[i] = T::t11 * w1_[i] + T::t12 * w2_[i] + T::t13 * w3_[i];
        z2_[i] = T::t21 * w1_[i] + T::t22 * w2_[i] + T::t23 * w3_[i];
        z3_[i] = T::t31 * w1_[i] + w2_[i];
      }
      if (margin_ * change <= enough_) {
        converged = true;
        return Evaluation::ok;
      }
    }
  }

  // (γ₀/h I - J)⁻¹ (f(t, y) + (e₁ Z₁ + e₂ Z₂ + e₃ Z₃)/h), once more from there at the start and after a refusal, where
  // what decays fast would otherwise be taken for an error.
  template <class F>
  Evaluation estimate(F& f, Scalar t, Scalar h, const Vector& y, Scalar& error) {
    Vector stages;
    Extended e{};
    for (std::size_t i = 0; i < size; ++i) {
      stages[i] = (T::e1 * z1_[i] + T::e2 * z2_[i] + T::e3 * z3_[i]) / h;
      e[i] = stages[i] + slope_[i];
    }
    equations_.solve(e);
    error = weighted(e);
    if (error >= Scalar(1) && (first_ || rejected_)) {
      Vector moved, slope;
      for (std::size_t i = 0; i < size; ++i) moved[i] = y[i] + e[i];
      if (f(t, moved, slope)) {
        e.fill(Scalar(0));
        for (std::size_t i = 0; i < size; ++i) e[i] = stages[i] + slope[i];
        equations_.solve(e);
        error = weighted(e);
      }
    }
    return Evaluation::ok;
  }

  [[nodiscard]] Scalar weighted(const Extended& e) const noexcept {
    Scalar sum = Scalar(0);
    for (std::size_t i = 0; i < size; ++i) sum += tolerances_.square(e[i], magnitude_[i]);
    return std::max(std::sqrt(sum / static_cast<Scalar>(size)), Scalar(1e-10));
  }

  // How much shorter the next step is to be, with a margin that shrinks with the iterations this one took.
  [[nodiscard]] Scalar quotient(Scalar error) const noexcept {
    const Scalar margin = std::min(safety, safety * static_cast<Scalar>(1 + 2 * most_iterations) /
                                               static_cast<Scalar>(iterations_ + 2 * most_iterations));
    return std::clamp(std::pow(error, Scalar(0.25)) / margin, Scalar(0.125), Scalar(5));
  }

  Tolerances<Scalar> tolerances_{};
  Scalar enough_ = Scalar(0);  // of Newton's method, in units of the tolerances
  bool first_ = true, rejected_ = false;
  bool slope_known_ = false, jacobian_known_ = false, jacobian_fresh_ = false;
  Scalar factorised_ = Scalar(0);  // the length of the step whose matrices stand factorised
  Scalar length_ = Scalar(0), guessed_from_ = Scalar(0);
  Scalar proposal_ = Scalar(0);  // the length to try where Newton's method failed
  Scalar margin_ = Scalar(1), rate_ = Scalar(1);
  Scalar last_length_ = Scalar(0), last_error_ = Scalar(0);
  int iterations_ = 0;
  Vector slope_{}, magnitude_{};
  Extended z1_{}, z2_{}, z3_{}, w1_{}, w2_{}, w3_{};  // stages, and their transforms T⁻¹ Z
  Vector last_z_{}, bend_{}, twist_{};
  std::array<Pair, all> pair_side_{};
  Equations equations_;
};

}  // namespace torsor::runtime
