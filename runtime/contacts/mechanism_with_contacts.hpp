// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <utility>

#include "torsor/runtime/contacts/contact_system.hpp"
#include "torsor/runtime/mechanism_model.hpp"

namespace torsor::runtime {

/// A mechanism generated with the kernels `contacts` and `contact_coefficients`.
template <class M>
concept HasContacts = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state, typename M::Contacts& contacts,
             typename M::ContactCoefficients& coefficients) {
  M::contacts(precomputed, state, contacts);
  M::contact_coefficients(precomputed, state, coefficients);
  requires M::contact_count >
  0;
};

/// How many constraints repeat no other.
template <MechanismModel M>
[[nodiscard]] constexpr int kept_constraints() noexcept {
  if constexpr (HasRedundantConstraints<M>) {
    return M::multiplier_count - M::redundant_count;
  } else {
    return M::multiplier_count;
  }
}

/// A generated mechanism whose contacts open, stick and slide, for `integrate_contacts`: M and h come from `mass_matrix`
/// and `bias`, gaps, rows, velocities and drifts from `contacts`, and loops are held by `constraints`. With a law of
/// inputs u(state), the forces h and E u together come from `forward_dynamics`, at accelerations in which no contact acts:
/// F = E u − h = M a − Aᵀ λ. A law that damps may have `damping(state)`: for each velocity what the generalised force along it
/// loses for each unit of it, as an array of numbers >= 0. Steps of equal length then take it implicitly.
template <HasContacts M, class InputLaw = NoInputs<M>>
requires(HasMassMatrixAndBias<M> && (M::multiplier_count == 0 || HasConstraints<M>)) class MechanismWithContacts {
 public:
  static constexpr std::size_t nq = coordinates_of<M>, nv = velocities_of<M>;
  static constexpr std::size_t contacts = static_cast<std::size_t>(M::contact_count);
  static constexpr int constraints = kept_constraints<M>();
  using Mechanism = M;
  using State = StateVector<M>;

  /// Coefficients are those of these parameters.
  explicit MechanismWithContacts(const typename M::Parameters& parameters = M::default_parameters(),
                                 InputLaw law = InputLaw{}) noexcept
      : precomputed_(M::precompute(parameters)), law_(std::move(law)) {
    typename M::ContactCoefficients of;
    M::contact_coefficients(precomputed_, initial_state_of<M>(precomputed_), of);
    for (std::size_t i = 0; i < contacts; ++i) {
      rules_[i] = {.tangents = static_cast<int>(M::contact_tangents[i]),
                   .normal = M::contact_normals[i] != 0,
                   .friction = of.friction[i],
                   .static_friction = of.static_friction[i],
                   .bound = of.bound[i],
                   .static_bound = of.static_bound[i],
                   .restitution = of.restitution[i]};
      if constexpr (requires { M::contact_pressed_by; }) {
        if (M::contact_pressed_by[i] > 0) rules_[i].pressed_by = static_cast<int>(M::contact_pressed_by[i]) - 1;
      }
      if constexpr (requires { M::contact_bearings; }) rules_[i].bearing = static_cast<int>(M::contact_bearings[i]);
    }
  }

  [[nodiscard]] ContactRule rule(int i) const noexcept { return rules_[static_cast<std::size_t>(i)]; }

  [[nodiscard]] Evaluation read(double t, const State& y, ContactReading& reading) const noexcept {
    constexpr std::size_t rows = static_cast<std::size_t>(M::contact_row_count);
    const typename M::State state = unpack<M>(t, y);
    std::array<double, nv * nv> mass;
    M::mass_matrix(precomputed_, state, mass);
    typename M::Contacts now;
    M::contacts(precomputed_, state, now);
    for (std::size_t i = 0; i < contacts; ++i) reading.gap[i] = now.gap[i];
    for (std::size_t k = 0; k < rows; ++k) {
      reading.w(at(k)) = now.rate[k];
      reading.drift(at(k)) = now.drift[k];
    }
    for (std::size_t j = 0; j < nv; ++j) {
      for (std::size_t i = 0; i < nv; ++i) reading.M(at(i), at(j)) = mass[j * nv + i];
      for (std::size_t k = 0; k < rows; ++k) reading.J(at(k), at(j)) = now.jacobian[j * rows + k];
    }
    if constexpr (constraints > 0) read_constraints(state, reading);
    if constexpr (requires { M::contact_bearings; }) read_bearings(now, reading);
    return read_forces(state, reading);
  }

  void coordinate_rates(double t, const State& y, std::array<double, nq>& rates) const noexcept {
    State dydt{};
    write_coordinate_rates<M>(precomputed_, unpack<M>(t, y), dydt);
    for (std::size_t i = 0; i < nq; ++i) rates[i] = dydt[i];
  }

  void normalise(State& y) const noexcept {
    if constexpr (HasQuaternions<M>) normalise_quaternions<M>(y);
  }

  [[nodiscard]] Evaluation settle_start(State& y) const noexcept {
    return start_with_unit_quaternions<M>(y) ? Evaluation::ok : Evaluation::not_finite;
  }

  void damping(double t, const State& y, std::array<double, nv>& rates) const noexcept
    requires requires(const InputLaw& law, const typename M::State& state) {
      { law.damping(state) } -> std::convertible_to<std::array<double, nv>>;
    }
  {
    rates = law_.damping(unpack<M>(t, y));
  }

  /// The state that the scene starts from.
  [[nodiscard]] State initial() const noexcept { return pack<M>(initial_state_of<M>(precomputed_)); }
  [[nodiscard]] const typename M::Precomputed& precomputed() const noexcept { return precomputed_; }

 private:
  static constexpr Eigen::Index at(std::size_t i) noexcept { return static_cast<Eigen::Index>(i); }

  static bool repeats_others(std::size_t constraint) noexcept {
    if constexpr (HasRedundantConstraints<M>) {
      for (const int each : M::redundant_multipliers) {
        if (static_cast<std::size_t>(each) == constraint) return true;
      }
    }
    return false;
  }

  void read_constraints(const typename M::State& state, ContactReading& reading) const noexcept {
    constexpr auto m = static_cast<std::size_t>(M::multiplier_count);
    typename M::Constraints now;
    M::constraints(precomputed_, state, now);
    Eigen::Index row = 0;
    for (std::size_t k = 0; k < m; ++k) {
      if (repeats_others(k)) continue;
      reading.gamma(row) = now.gamma[k];
      reading.value(row) = now.value[k];
      reading.rate(row) = now.rate[k];
      for (std::size_t j = 0; j < nv; ++j) reading.A(row, at(j)) = now.jacobian[j * m + k];
      ++row;
    }
  }

  static void read_bearings(const typename M::Contacts& now, ContactReading& reading) noexcept {
    constexpr auto rows = static_cast<std::size_t>(M::contact_row_count);
    const auto count = static_cast<std::size_t>(reading.R0.size());
    for (std::size_t k = 0; k < count; ++k) {
      reading.R0(at(k)) = now.bearing[k];
      for (std::size_t j = 0; j < nv; ++j) reading.B(at(k), at(j)) = now.bearing_by_accelerations[j * count + k];
      for (std::size_t j = 0; j < rows; ++j) reading.C(at(k), at(j)) = now.bearing_by_reactions[j * count + k];
      if constexpr (M::multiplier_count > 0) {
        constexpr auto m = static_cast<std::size_t>(M::multiplier_count);
        Eigen::Index column = 0;
        for (std::size_t j = 0; j < m; ++j) {
          if (!repeats_others(j)) reading.D(at(k), column++) = now.bearing_by_multipliers[j * count + k];
        }
      }
    }
  }

  [[nodiscard]] Evaluation read_forces(const typename M::State& state, ContactReading& reading) const noexcept {
    if constexpr (M::input_count > 0 && !std::is_same_v<InputLaw, NoInputs<M>>) {
      static_assert(HasForwardDynamics<M>, "a law of inputs needs the kernel forward_dynamics");
      typename M::Accelerations a{};
      typename M::Multipliers lambda{};
      const Evaluation evaluation = to_evaluation(M::forward_dynamics(precomputed_, state, law_(state), a, lambda));
      if (evaluation != Evaluation::ok) return evaluation;
      Eigen::Matrix<double, static_cast<int>(nv), 1> acceleration;
      for (std::size_t i = 0; i < nv; ++i) acceleration(at(i)) = a[static_cast<int>(i)];
      reading.F.noalias() = reading.M * acceleration;
      if constexpr (constraints > 0) {
        Eigen::Index row = 0;
        for (int k = 0; k < M::multiplier_count; ++k) {
          if (repeats_others(static_cast<std::size_t>(k))) continue;
          reading.F -= reading.A.row(row++).transpose() * lambda[k];
        }
      }
    } else {
      typename M::GeneralizedForces bias{};
      M::bias(precomputed_, state, bias);
      for (std::size_t i = 0; i < nv; ++i) reading.F(at(i)) = -bias[static_cast<int>(i)];
    }
    return Evaluation::ok;
  }

  typename M::Precomputed precomputed_;
  InputLaw law_;
  std::array<ContactRule, contacts> rules_;
};

}  // namespace torsor::runtime
