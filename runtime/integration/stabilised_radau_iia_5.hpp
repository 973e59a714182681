// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "torsor/runtime/constraints/constraint_kinds.hpp"
#include "torsor/runtime/constraints/constraint_reading.hpp"
#include "torsor/runtime/constraints/independent_constraints.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace torsor::runtime {

/// A motion (see `equations_of_motion`) with multipliers, of a mechanism with the kernels `constraints` and
/// `mass_matrix`.
template <class S>
concept HasStabilisedForm = requires {
  typename S::Mechanism;
  requires HasMassMatrixAndBias<typename S::Mechanism> && HasConstraints<typename S::Mechanism>;
};

/// The index-2 form of a constrained motion that is stabilised on position and velocity, as RadauFormula wants it:
///   q' = N (v + M⁻¹Aᵀ μ),   v' = a(q, v) + M⁻¹Aᵀ η,   0 = g(q, t),   0 = A v - b,
/// a being the accelerations of the motion (kernel `forward_dynamics`) and N = 1, but for quaternions and other
/// coordinates with rates of their own (kernel `coordinate_rates`). On the exact motion μ = η = 0: they carry what the
/// discretisation and rounding would move off the constraints, along the directions least by the metric of the masses.
/// N M⁻¹Aᵀ and M⁻¹Aᵀ are frozen with the Jacobian, which costs nothing in order since μ and η are as small as the error
/// of a step. Constraints on velocities alone have no μ, those that repeat others neither. These equations keep the
/// norm of quaternions, but for the error of a step, which is taken away before the constraints are met at its end.
/// Source: Gear, Leimkuhler & Gupta, J. Comp. Appl. Math. 12 (1985); Hairer-Wanner II, VII.1 (1.30) and VII.2.
template <class S, class Scalar, std::size_t size>
class StabilisedEquations {
  using M = typename std::remove_cv_t<S>::Mechanism;
  static constexpr std::size_t nq = coordinates_of<M>, n = velocities_of<M>;
  static constexpr std::size_t m = static_cast<std::size_t>(M::multiplier_count);

 public:
  static constexpr std::size_t extra = 2 * m, all = size + extra;
  using Vector = std::array<Scalar, size>;
  using Extended = std::array<Scalar, all>;
  using Pairs = std::array<Complex<Scalar>, all>;

  template <class F>
  [[nodiscard]] bool linearise(F& f, Scalar t, const Vector& y, const Vector& slope) {
    if (!evaluate_jacobian(f, t, y, slope, J_)) return false;
    derive_constraints(f, t, y);
    f.evaluation = find_directions(f, t, y);
    if (f.evaluation != Evaluation::ok) return false;
    auto& matrix = projection_.matrix();
    for (std::size_t j = 0; j < extra; ++j) {
      Vector column;
      for (std::size_t i = 0; i < size; ++i) column[i] = B_[j * size + i];
      for (std::size_t i = 0; i < extra; ++i) matrix[j * extra + i] = counts_[i] ? along(i, column) : unit(i, j);
    }
    f.evaluation = projection_.factorise();
    return f.evaluation == Evaluation::ok;
  }

  template <class F>
  [[nodiscard]] Evaluation factorise(F& f, Scalar real, const Complex<Scalar>& pair) noexcept {
    f.decompositions += 2;
    const Evaluation evaluation = real_.factorise(*this, real);
    return evaluation == Evaluation::ok ? pair_.factorise(*this, pair) : evaluation;
  }

  template <class F>
  [[nodiscard]] bool evaluate(F& f, Scalar t, const Extended& x, Extended& result) {
    Vector y, slope;
    std::copy_n(x.begin(), size, y.begin());
    if (!f(t, y, slope)) return false;
    for (std::size_t i = 0; i < size; ++i) result[i] = slope[i];
    for (std::size_t j = 0; j < extra; ++j) {
      for (std::size_t i = 0; i < size; ++i) result[i] += B_[j * size + i] * x[size + j];
    }
    const Residual c = residual(f, t, y);
    for (std::size_t j = 0; j < extra; ++j) result[size + j] = c[j];
    if (!all_finite(result)) f.evaluation = Evaluation::not_finite;
    return f.evaluation == Evaluation::ok;
  }

  void solve(Extended& r) const noexcept { real_.solve(*this, r); }
  void solve(Pairs& r) const noexcept { pair_.solve(*this, r); }

  /// Takes away what Newton's method left of the constraints at the end of a step, along the same directions;
  /// quaternions get their norm back. What is rounding already stays as it is (see ConstraintReading), and so does what
  /// is nearly rounding where the directions magnify it (a mechanism near a position where its constraints lose their
  /// rank). False, with Evaluation::singular, where the corrections do not end; Evaluation::not_finite where something
  /// overflows.
  template <class F>
  [[nodiscard]] bool finish(F& f, Scalar t, const Vector& y, Vector& change) const {
    Reading here;
    Scalar last = std::numeric_limits<Scalar>::infinity();
    for (int round = 0; round < 20; ++round) {
      Vector x;
      for (std::size_t i = 0; i < size; ++i) x[i] = y[i] + change[i];
      if constexpr (HasQuaternions<M>) {
        Vector of_norm = x;
        normalise_quaternions<M>(of_norm);
        for (std::size_t i = 0; i < size; ++i) change[i] += of_norm[i] - x[i];
        x = of_norm;
      }
      bool finite = here.read(f.system().precomputed(), kinds_, t, x);
      Residual c = off(here);
      Scalar open = Scalar(0);
      for (std::size_t j = 0; j < extra; ++j) open += std::abs(c[j]);
      if (finite && open == Scalar(0)) return true;
      projection_.solve(c);
      Vector correction{};
      for (std::size_t j = 0; j < extra; ++j) {
        for (std::size_t i = 0; i < size; ++i) correction[i] += B_[j * size + i] * c[j];
      }
      finite = finite && all_finite(correction);
      if (!finite) {
        f.evaluation = Evaluation::not_finite;
        return false;
      }
      const Scalar moved = std::max(moved_by(correction, x, 0, nq), moved_by(correction, x, nq, size));
      // What is left is rounding of the residual, which would be magnified, or goes to and fro.
      const Scalar roundings = nearly_rounding(here);
      if (roundings <= few && moved > magnified * roundings * std::numeric_limits<Scalar>::epsilon()) return true;
      if (!(open < last / Scalar(2))) break;
      last = open;
      for (std::size_t i = 0; i < size; ++i) change[i] -= correction[i];
    }
    if (nearly_rounding(here) <= few) return true;  // else B no longer serves
    f.evaluation = Evaluation::singular;
    return false;
  }

 private:
  using Residual = std::array<Scalar, extra>;
  using Reading = ConstraintReading<M>;
  static constexpr Scalar few = Scalar(1e3);
  static constexpr Scalar magnified = Scalar(1e5);

  static constexpr Scalar unit(std::size_t i, std::size_t j) noexcept { return i == j ? Scalar(1) : Scalar(0); }

  /// (γ I - J, -B; -C, 0) by the Schur complement C (γ I - J)⁻¹ B.
  template <class Field>
  class Bordered {
   public:
    [[nodiscard]] Evaluation factorise(const StabilisedEquations& e, const Field& gamma) noexcept {
      const Evaluation evaluation = inner_.factorise(e.J_, gamma);
      if (evaluation != Evaluation::ok) return evaluation;
      auto& matrix = complement_.matrix();
      for (std::size_t j = 0; j < extra; ++j) {
        auto& response = responses_[j];
        for (std::size_t i = 0; i < size; ++i) response[i] = Field{e.B_[j * size + i]};
        inner_.solve(e.J_, response);
        for (std::size_t i = 0; i < extra; ++i) {
          matrix[j * extra + i] = e.counts_[i] ? e.along(i, response) : Field{unit(i, j)};
        }
      }
      return complement_.factorise();
    }

    void solve(const StabilisedEquations& e, std::array<Field, all>& r) const noexcept {
      typename Inner::Vector x;
      std::copy_n(r.begin(), size, x.begin());
      inner_.solve(e.J_, x);
      std::array<Field, extra> z;
      for (std::size_t j = 0; j < extra; ++j) {
        z[j] = e.counts_[j] ? Field{} - r[size + j] - e.along(j, x) : Field{};
      }
      complement_.solve(z);
      for (std::size_t j = 0; j < extra; ++j) {
        for (std::size_t i = 0; i < size; ++i) x[i] = x[i] + responses_[j][i] * z[j];
        r[size + j] = z[j];
      }
      std::copy_n(x.begin(), size, r.begin());
    }

   private:
    using Inner = ShiftedSystem<Field, Scalar, size, !HasCoordinateRates<M>>;
    Inner inner_;
    std::array<typename Inner::Vector, extra> responses_{};
    Lu<Field, extra> complement_;
  };

  // Row i of C times a column.
  template <class Field>
  [[nodiscard]] Field along(std::size_t i, const std::array<Field, size>& column) const noexcept {
    Field sum{};
    for (std::size_t k = 0; k < size; ++k) sum = sum + C_[k * extra + i] * column[k];
    return sum;
  }

  template <class F>
  static typename M::Constraints constraints_at(const F& f, Scalar t, const Vector& y) {
    typename M::Constraints constraints{};
    M::constraints(f.system().precomputed(), unpack<M>(t, y), constraints);
    return constraints;
  }

  // g, then A v - b; 0 where a row does not count.
  template <class F>
  Residual residual(const F& f, Scalar t, const Vector& y) const {
    const auto constraints = constraints_at(f, t, y);
    Residual c;
    for (std::size_t j = 0; j < m; ++j) {
      c[j] = counts_[j] ? constraints.value[j] : Scalar(0);
      c[m + j] = counts_[m + j] ? constraints.rate[j] : Scalar(0);
    }
    return c;
  }

  // What is off by more than rounding, of the rows that count.
  Residual off(const Reading& here) const noexcept {
    Residual c{};
    for (std::size_t j = 0; j < m; ++j) {
      if (counts_[j] && !here.position_is_rounding(j, lengths_)) c[j] = here.constraints.value[j];
      if (counts_[m + j] && !here.velocity_is_rounding(j)) c[m + j] = here.constraints.rate[j];
    }
    return c;
  }

  // How far a correction moves a coordinate, or a velocity, of its own size or a thousandth of the largest.
  static Scalar moved_by(const Vector& correction, const Vector& x, std::size_t from, std::size_t to) noexcept {
    Scalar largest = std::numeric_limits<Scalar>::min(), moved = Scalar(0);
    for (std::size_t i = from; i < to; ++i) largest = std::max(largest, std::abs(x[i]));
    for (std::size_t i = from; i < to; ++i) {
      moved = std::max(moved, std::abs(correction[i]) / std::max(std::abs(x[i]), Scalar(1e-3) * largest));
    }
    return moved;
  }

  // How many roundings of its terms each residual is at most.
  Scalar nearly_rounding(const Reading& here) const noexcept {
    Scalar roundings = Scalar(0);
    for (std::size_t j = 0; j < m; ++j) {
      if (counts_[j]) roundings = std::max(roundings, here.position_in_roundings(j, lengths_));
      if (counts_[m + j]) roundings = std::max(roundings, here.velocity_in_roundings(j));
    }
    return roundings;
  }

  // C = ∂(g, A v - b)/∂(q, v): A where q' = v, else differences by q.
  template <class F>
  void derive_constraints(const F& f, Scalar t, const Vector& y) {
    const auto here = constraints_at(f, t, y);
    if (!kinds_known_) kinds_ = ConstraintKinds<M>::at(f.system().precomputed(), t, y);
    kinds_known_ = true;
    lengths_ = Reading::lengths(f.system().precomputed(), kinds_, t, y);
    for (std::size_t k = 0; k < nq; ++k) {
      Vector moved = y;
      moved[k] += std::sqrt(std::numeric_limits<Scalar>::epsilon()) * largeness(y, k);
      const Scalar delta = moved[k] - y[k];
      const auto there = constraints_at(f, t, moved);
      for (std::size_t j = 0; j < m; ++j) {
        if constexpr (HasCoordinateRates<M>) {
          C_[k * extra + j] = (there.value[j] - here.value[j]) / delta;
        } else {
          C_[k * extra + j] = kinds_.holonomic[j] ? here.jacobian[k * m + j] : Scalar(0);
        }
        C_[k * extra + m + j] = (there.rate[j] - here.rate[j]) / delta;
      }
    }
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < m; ++j) {
        C_[(nq + k) * extra + j] = Scalar(0);
        C_[(nq + k) * extra + m + j] = here.jacobian[k * m + j];
      }
    }
  }

  // What a difference by a coordinate is to be small against: near 0 its reach, a radian of an angle or of an attitude.
  Scalar largeness(const Vector& y, std::size_t k) const noexcept {
    return std::max(kinds_.coordinate_reach[k], std::abs(y[k]));
  }

  // The rows that count: of positions the holonomic constraints, of velocities all; of those that repeat others as many
  // as are independent, without those whose multipliers the mechanism takes as zero.
  Evaluation find_independent(const std::array<Scalar, n * n>& mass) noexcept {
    for (const bool positions : {true, false}) {
      std::array<Scalar, m * n> jacobian{};
      for (std::size_t j = 0; j < m; ++j) {
        bool counts = kinds_.holonomic[j] || !positions;
        if constexpr (HasRedundantConstraints<M>) {
          for (const int zero : M::redundant_multipliers) counts = counts && static_cast<std::size_t>(zero) != j;
        }
        for (std::size_t k = 0; k < n && counts; ++k) jacobian[k * m + j] = C_[(nq + k) * extra + m + j];
        counts_[(positions ? 0 : m) + j] = false;
      }
      IndependentConstraints<Scalar, n, m> factor;
      if (const Evaluation e = factor.factorise(mass, jacobian, usual_rank_tolerance<Scalar>(), kinds_.usual);
          e != Evaluation::ok) {
        return e;
      }
      for (int k = 0; k < factor.rank(); ++k) {
        counts_[(positions ? 0 : m) + static_cast<std::size_t>(factor.constraint(k))] = true;
      }
    }
    return Evaluation::ok;
  }

  // N u: the rates of the coordinates that velocities u bring, less those without any.
  template <class F>
  static std::array<Scalar, nq> rates_by(const F& f, const typename M::State& state, const std::array<Scalar, n>& u) {
    std::array<Scalar, nq> rates;
    if constexpr (HasCoordinateRates<M>) {
      typename M::State moving = state, resting = state;
      for (std::size_t k = 0; k < n; ++k) {
        moving.v[static_cast<int>(k)] = u[k];
        resting.v[static_cast<int>(k)] = Scalar(0);
      }
      std::array<Scalar, nq> rest;
      M::coordinate_rates(f.system().precomputed(), moving, rates);
      M::coordinate_rates(f.system().precomputed(), resting, rest);
      for (std::size_t k = 0; k < nq; ++k) rates[k] -= rest[k];
    } else {
      rates = u;
    }
    return rates;
  }

  // B = diag(N M⁻¹Aᵀ, M⁻¹Aᵀ).
  template <class F>
  Evaluation find_directions(const F& f, Scalar t, const Vector& y) {
    const typename M::State state = unpack<M>(t, y);
    Lu<Scalar, n> mass;
    M::mass_matrix(f.system().precomputed(), state, mass.matrix());
    if (const Evaluation e = find_independent(mass.matrix()); e != Evaluation::ok) return e;
    const Evaluation evaluation = mass.factorise();
    if (evaluation != Evaluation::ok) return evaluation;
    B_.fill(Scalar(0));
    for (std::size_t j = 0; j < m; ++j) {
      std::array<Scalar, n> column;
      for (std::size_t k = 0; k < n; ++k) column[k] = C_[(nq + k) * extra + m + j];
      mass.solve(column);
      const std::array<Scalar, nq> rates = rates_by(f, state, column);
      for (std::size_t k = 0; k < nq; ++k) {
        if (counts_[j]) B_[j * size + k] = rates[k];
      }
      for (std::size_t k = 0; k < n; ++k) {
        if (counts_[m + j]) B_[(m + j) * size + nq + k] = column[k];
      }
    }
    return Evaluation::ok;
  }

  JacobianMatrix<Scalar, size> J_{};
  std::array<Scalar, size * extra> B_{}, C_{};  // column by column
  std::array<bool, extra> counts_{};
  ConstraintKinds<M> kinds_{};
  bool kinds_known_ = false;
  typename Reading::Rows lengths_{};
  Lu<Scalar, extra> projection_;
  Bordered<Scalar> real_;
  Bordered<Complex<Scalar>> pair_;
};

/// Radau IIA of order 5 on the stabilised index-2 form (see StabilisedEquations): every step ends on the constraints,
/// in position and in velocity, to rounding, and with quaternions of norm 1; otherwise as RadauIia5. For motions of
/// mechanisms with multipliers and the kernels `constraints`, `mass_matrix` and `bias`; the start must satisfy its constraints.
struct StabilisedRadauIia5 {
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
    static_assert(HasStabilisedForm<std::remove_cv_t<S>>,
                  "StabilisedRadauIia5 wants equations_of_motion or constrained_motion of a mechanism with multipliers "
                  "whose header has the kernels constraints, mass_matrix and bias: generate it with "
                  "--kernels constraints,mass_matrix,bias,forward_dynamics, or with all");
    using Formula = RadauFormula<StabilisedEquations<S, Scalar, size>, Scalar, size>;
    return AdaptiveRun<Formula, StabilisedRadauIia5, S, Scalar, size>(system, y, t, *this);
  }
};

}  // namespace torsor::runtime
