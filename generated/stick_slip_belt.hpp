// SPDX-License-Identifier: MIT-0
// stick_slip_belt: Block on a spring, carried along by a belt until it slips
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: v0, f, f_static
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   0                0          0             0                  0       0      0       0
//   bias                          0                1          0             0                  0       0      1       1
//   energy                        2                5          0             0                  0       0      7       7
//   contacts                      1                0          0             0                  0       0      1       1
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 4 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   contacts: of 9 results 4 vanish identically
//   contact_coefficients: of 5 results 3 vanish identically
//
// To write this file again:
//   stick_slip_belt_scene generate --kernels mass_matrix,bias,energy,contacts,contact_coefficients --support torsor_support.hpp --output stick_slip_belt.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace stick_slip_belt {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"x", "m"}, {"z", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"x", "m/s"}, {"z", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 3> parameters{{{"v0", "m/s"}, {"f", "1"}, {"f_static",
      "1"}}};
  static constexpr std::array<torsor::ResultDescription, 14> results{{{"mass", "", 2, 2, 2, "kg"}, {"forces", "", 2, 1,
      1, "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1,
      1, 0, "W"}, {"result", "gap", 1, 1, 1, "m"}, {"result", "rate", 2, 1, 1, "m/s"}, {"result", "jacobian", 2, 2, 2,
      "1"}, {"result", "drift", 2, 1, 1, ""}, {"result", "friction", 1, 1, 1, "1"}, {"result", "static_friction", 1, 1,
      1, "1"}, {"result", "restitution", 1, 1, 1, "1"}, {"result", "bound", 1, 1, 1, ""}, {"result", "static_bound", 1,
      1, 1, ""}}};
  static constexpr std::array<torsor::KernelDescription, 5> kernels{{{"mass_matrix", false, false, false, false,
      results.data() + 0, 1}, {"bias", false, false, false, false, results.data() + 1, 1}, {"energy", false, false,
      true, false, results.data() + 2, 3}, {"contacts", false, false, false, false, results.data() + 5, 4},
      {"contact_coefficients", false, false, false, false, results.data() + 9, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::stick_slip_belt::Description;

  static constexpr const char* name = "stick_slip_belt";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe611c3423f286a76ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 3;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar v0;  ///< parameter [m/s]
    Scalar f;  ///< parameter [1]
    Scalar f_static;  ///< parameter [1]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::v0, &Parameters::f, &Parameters::f_static};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::z};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar z;  ///< works with the rate of z [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::z};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers : torsor::NoMembers<Scalar> {};

  /// Time [s], coordinates and velocities.
  struct State {
    Scalar time;
    Coordinates q;
    Velocities v;
  };

  /// Parameters and what depends on them only: built once for each set of parameters.
  struct Precomputed {
    Parameters parameters;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    parameters.v0 = n0_2;
    parameters.f = n0_35;
    parameters.f_static = n0_5;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    state.time = n0;
    state.q.x = n0;
    state.q.z = n0;
    state.v.x = n0;
    state.v.z = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Energies of the mechanism.
  struct Energy {
    Scalar kinetic;  ///< kinetic energy T [J]
    Scalar force_function;  ///< force function U of gravity and springs [J]
    Scalar power;  ///< power of dampers, given forces and motors [W]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Energy::*member_(int i_) noexcept {
      constexpr Scalar Energy::*members_[] = {&Energy::kinetic, &Energy::force_function, &Energy::power};
      return members_[i_];
    }
  };

  /// Gaps of contacts, and what they may do along their normals and tangents.
  struct Contacts {
    std::array<Scalar, 1> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 2> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 4> jacobian;  ///< J, stored column by column (2 x 2)
    std::array<Scalar, 2> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 1;
  static constexpr int contact_row_count = 2;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[1] = {1};
  static constexpr int contact_tangents[1] = {1};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 1> friction;  ///< f [1]
    std::array<Scalar, 1> static_friction;  ///< f_s [1]
    std::array<Scalar, 1> restitution;  ///< e [1]
    std::array<Scalar, 1> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 1> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    mass[0] = n2;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n50 = traits::constant(50.0, 50.0f, "50/1");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar q_x = state.q.x;
    const Scalar z0 = n50 * q_x;
    forces.x = z0;
    forces.z = n19_62;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    result.kinetic = v_x * v_x + v_z * v_z;
    result.force_function = -n19_62 * q_z - n25 * q_x * q_x;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Contacts that open and close, in the order belt.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed& precomputed, const State& state, Contacts& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar p_v0 = precomputed.parameters.v0;
    const Scalar z0 = v_x - p_v0;
    result.gap[0] = q_z;
    result.rate[0] = v_z;
    result.drift[0] = n0;
    result.rate[1] = z0;
    result.drift[1] = n0;
    result.jacobian[0] = n0;
    result.jacobian[1] = n1;
    result.jacobian[2] = n1;
    result.jacobian[3] = n0;
  }

  /// What the surfaces of each contact are made of, in the order belt:
  /// |T| <= f N + b while it slides, f_s and b_s while it sticks.
  TORSOR_DEVICE static void contact_coefficients(const Precomputed& precomputed, const State&,
      ContactCoefficients& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_f_static = precomputed.parameters.f_static;
    result.friction[0] = p_f;
    result.static_friction[0] = p_f_static;
    result.restitution[0] = n0;
    result.bound[0] = n0;
    result.static_bound[0] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 4>&>(mass_matrix));
    visitor(Description::kernels[1], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[2], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[3], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[4], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace stick_slip_belt
