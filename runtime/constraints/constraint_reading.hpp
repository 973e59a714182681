// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "torsor/runtime/constraints/constraint_kinds.hpp"
#include "torsor/runtime/mechanism_model.hpp"
#include "torsor/runtime/numerics/small_matrix.hpp"

namespace torsor::runtime {

/// The constraints of a mechanism at a state, and how large their residuals may be by rounding alone. Residuals count
/// over the size Σ_j |A_ij| of their row: a displacement of the coordinates, and a rate of them; where they are compared
/// with one another, over Σ_j |A_ij| r_j, with the reaches r_j of ConstraintKinds, which has no unit.
///
/// f_i is known to some roundings of the terms that it is a sum of. Of coordinates these are |A_ij q_j|, of angles no
/// more than a quarter of a turn of them, where their sines are largest; of constant lengths they are the radii on
/// which angles carry points, |∂²f_i/∂q_j²|, see `lengths`. A constant that is no radius is balanced by these terms
/// where f_i = 0. Of A v - b they are |A_ij v_j| and |b_i|.
template <HasConstraints M>
class ConstraintReading {
 public:
  using Scalar = ScalarOf<M>;
  using Kinds = ConstraintKinds<M>;
  static constexpr std::size_t nv = velocities_of<M>, m = static_cast<std::size_t>(M::multiplier_count);
  using Residual = SmallMatrix<Scalar, m>;
  using Rows = std::array<Scalar, m>;

  /// False where something is not finite.
  [[nodiscard]] bool read(const typename M::Precomputed& precomputed, const Kinds& kinds, Scalar t,
                          const StateVector<M>& y) noexcept {
    state = unpack<M>(t, y);
    M::constraints(precomputed, state, constraints);
    position = velocity = open = displacement = parting = speed = Scalar(0);
    for (std::size_t j = 0; j < nv; ++j) {
      speed = std::max(speed, std::abs(state.v[static_cast<int>(j)]) / kinds.reach[j]);
    }
    Scalar all = Scalar(0);  // not finite where one is not, which a maximum would drop
    Scalar largest = Scalar(1);
    for (const Scalar& component : y) all += component - component;
    for (std::size_t k = 0; k < Kinds::nq; ++k) largest = std::max(largest, std::abs(y[k]) / kinds.coordinate_reach[k]);
    for (std::size_t i = 0; i < m; ++i) {
      Scalar size = Scalar(0), moving = Scalar(0), sum = Scalar(0), reach = Scalar(0);
      Scalar usual_size = Scalar(0), usual_reach = Scalar(0);
      near_[i] = far_[i] = beside_[i] = Scalar(0);
      for (std::size_t j = 0; j < nv; ++j) {
        const Scalar entry = std::abs(constraints.jacobian[j * m + i]);
        const bool attitude = kinds.coordinate[j] == Kinds::nq;
        const Scalar far = attitude ? Scalar(1) : std::abs(y[attitude ? 0 : kinds.coordinate[j]]);
        const Scalar near = kinds.turns[j] ? std::min(far, Kinds::whole_turn / Scalar(4)) : far;
        size += entry;
        reach += entry * kinds.reach[j];
        usual_size += kinds.usual[j * m + i];
        usual_reach += kinds.usual[j * m + i] * kinds.reach[j];
        near_[i] += entry * near;
        far_[i] += entry * std::max(far, kinds.turns[j] ? Scalar(1) : largest * kinds.reach[j]);
        beside_[i] += entry * std::max(near, kinds.reach[j]);
        const Scalar product = constraints.jacobian[j * m + i] * state.v[static_cast<int>(j)];
        moving += std::abs(product);
        sum += product;
      }
      moving_[i] = moving + std::abs(sum - constraints.rate[i]);
      if (reach < vanished * usual_reach) {
        reach = usual_reach;
        size = usual_size;
        moving_[i] += usual_reach * speed;
      }
      size_[i] = size > Scalar(0) ? size : Scalar(1);
      reach_[i] = reach > Scalar(0) ? reach : Scalar(1);
      all += size + constraints.value[i] + constraints.rate[i];
      if (kinds.holonomic[i]) {
        position = std::max(position, std::abs(constraints.value[i]) / size_[i]);
        open += std::abs(constraints.value[i]) / reach_[i];
        const Scalar least = usual_reach > Scalar(0) ? usual_reach : Scalar(1);
        displacement = std::max(displacement, std::abs(constraints.value[i]) / least);
      }
      velocity = std::max(velocity, std::abs(constraints.rate[i]) / size_[i]);
      parting = std::max(parting, std::abs(constraints.rate[i]) / reach_[i]);
    }
    return std::isfinite(all) && std::isfinite(open) && std::isfinite(velocity);
  }

  /// Whether f_i is within `roundings` of its terms, lengths included.
  [[nodiscard]] bool position_is_rounding(std::size_t i, const Rows& lengths, Scalar roundings = usual) const noexcept {
    return std::abs(constraints.value[i]) <= roundings * epsilon * (near_[i] + lengths[i]);
  }
  /// The same where angles wound up count in full, as they are known no better, and where terms that vanish count as
  /// large as an angle of 1 rad or the farthest coordinate would make them: what is left near a root at zero.
  [[nodiscard]] bool position_is_closed(std::size_t i, const Rows& lengths, Scalar roundings) const noexcept {
    return position_in_roundings(i, lengths) <= roundings;
  }
  [[nodiscard]] bool velocity_is_rounding(std::size_t i) const noexcept {
    return std::abs(constraints.rate[i]) <= usual * epsilon * moving_[i];
  }
  /// How many roundings a residual is: of terms in which those that vanish count as above, and of the largest velocity.
  [[nodiscard]] Scalar position_in_roundings(std::size_t i, const Rows& lengths) const noexcept {
    const Scalar off = std::abs(constraints.value[i]);
    return off == Scalar(0) ? off : off / (epsilon * (far_[i] + lengths[i]));
  }
  [[nodiscard]] Scalar velocity_in_roundings(std::size_t i) const noexcept {
    const Scalar off = std::abs(constraints.rate[i]);
    return off == Scalar(0) ? off : off / (epsilon * std::max(moving_[i], reach_[i] * speed));
  }
  /// Whether constraints hold their rate to a part of that of the fastest velocity.
  [[nodiscard]] bool velocity_is_within(Scalar part) const noexcept {
    bool within = true;
    for (std::size_t i = 0; i < m; ++i) {
      within = within && std::abs(constraints.rate[i]) <= part * reach_[i] * speed;
    }
    return within;
  }
  [[nodiscard]] bool position_is_rounding(const Rows& lengths) const noexcept {
    bool within = true;
    for (std::size_t i = 0; i < m; ++i) within = within && position_is_rounding(i, lengths);
    return within;
  }
  [[nodiscard]] bool velocity_is_rounding() const noexcept {
    bool within = true;
    for (std::size_t i = 0; i < m; ++i) within = within && velocity_is_rounding(i);
    return within;
  }
  /// Whether lengths could make rounding of all f_i, so that they are worth their evaluations.
  [[nodiscard]] bool position_may_be_rounding() const noexcept {
    bool within = true;
    for (std::size_t i = 0; i < m; ++i) {
      within = within && std::abs(constraints.value[i]) <= Scalar(1e4) * epsilon * beside_[i];
    }
    return within;
  }

  /// What is to be taken away: f, and A v - b, without what is rounding, which says nothing of the coordinates.
  [[nodiscard]] Residual value(const Rows& lengths) const noexcept {
    Residual f;
    for (std::size_t i = 0; i < m; ++i) {
      f(static_cast<int>(i)) = position_is_rounding(i, lengths) ? Scalar(0) : constraints.value[i];
    }
    return f;
  }
  [[nodiscard]] Residual rate() const noexcept {
    Residual r;
    for (std::size_t i = 0; i < m; ++i) {
      r(static_cast<int>(i)) = velocity_is_rounding(i) ? Scalar(0) : constraints.rate[i];
    }
    return r;
  }

  /// Σ_j |∂²f_i/∂q_j²| over all velocities that turn something, by γ: γ is quadratic in them, but for what time brings.
  [[nodiscard]] static Rows lengths(const typename M::Precomputed& precomputed, const Kinds& kinds, Scalar t,
                                    const StateVector<M>& y) noexcept {
    typename M::State state = unpack<M>(t, y);
    const auto moving_alone = [&](std::size_t moving, Scalar turning) {
      for (std::size_t j = 0; j < nv; ++j) state.v[static_cast<int>(j)] = j == moving ? turning : Scalar(0);
      typename M::Constraints at{};
      M::constraints(precomputed, state, at);
      return at;
    };
    const auto at_rest = moving_alone(0, Scalar(0));
    bool still = true;
    for (std::size_t i = 0; i < m; ++i) {
      still = still && at_rest.gamma[i] == Scalar(0) && at_rest.rate[i] == Scalar(0);
    }
    Rows sum{};
    for (std::size_t j = 0; j < nv; ++j) {
      if (!kinds.turns[j]) continue;
      const Rows forth = moving_alone(j, Scalar(1)).gamma;
      const Rows back = still ? forth : moving_alone(j, Scalar(-1)).gamma;
      for (std::size_t i = 0; i < m; ++i) {
        const Scalar radius = std::abs((forth[i] + back[i]) / Scalar(2) - at_rest.gamma[i]);
        if (kinds.holonomic[i] && std::isfinite(radius)) sum[i] += radius;
      }
    }
    return sum;
  }

  /// How far a change of the coordinates moves the parts that holonomic constraints tie, over their reaches.
  template <class Change>
  [[nodiscard]] Scalar motion_by(const Kinds& kinds, const Change& change) const noexcept {
    Scalar largest = Scalar(0);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < nv && kinds.holonomic[i]; ++j) {
        const Scalar moved = constraints.jacobian[j * m + i] * change(static_cast<int>(j)) / reach_[i];
        largest = std::max(largest, std::abs(moved));
      }
    }
    return largest;
  }

  typename M::State state{};
  typename M::Constraints constraints{};
  Scalar position = Scalar(0), velocity = Scalar(0);  // the largest residuals
  Scalar open = Scalar(0);          // the sum of the residuals in position, over their reaches
  Scalar displacement = Scalar(0);  // the largest of these, over what they usually are
  Scalar parting = Scalar(0);       // the largest residual in velocity, over its reach
  Scalar speed = Scalar(0);         // the largest velocity, over its reach

 private:
  static constexpr Scalar epsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr Scalar usual = Scalar(2);
  // A row below this part of what it usually is vanishes: it is rounding, and no measure of anything.
  static constexpr Scalar vanished = Scalar(1e-8);
  Rows near_{}, far_{}, beside_{}, reach_{}, size_{}, moving_{};
};

}  // namespace torsor::runtime
