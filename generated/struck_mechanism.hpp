// SPDX-License-Identifier: MIT-0
// struck_mechanism: Hanging rod struck by a ball
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, constraints, contacts, contact_coefficients
// Parameters set at run time: d, e
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   0                1          0             0                  1       0      3       3
//   bias                          0                5          0             0                  1       0      7       7
//   energy                        7               16          0             0                  1       0     25      27
//   constraints                   0                0          0             0                  0       0      0       0
//   contacts                     11               17          0             0                  1       0     30      31
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 16 results 10 vanish identically, 1 repeat another up to sign
//   bias: of 4 results 1 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 7 results 4 vanish identically
//   contacts: of 7 results 1 repeat another up to sign
//   contact_coefficients: of 5 results 4 vanish identically
//
// To write this file again:
//   struck_mechanism_scene generate --kernels mass_matrix,bias,energy,constraints,contacts,contact_coefficients --support torsor_support.hpp --output struck_mechanism.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace struck_mechanism {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 4> coordinates{{{"theta", "rad"}, {"x", "m"}, {"z", "m"},
      {"hinge_x", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 4> velocities{{{"theta", "rad/s"}, {"x", "m/s"}, {"z",
      "m/s"}, {"hinge_x", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 1> multipliers{{{"lambda_hinge_holds", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"d", "m"}, {"e", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 18> results{{{"mass", "", 4, 4, 2, ""}, {"forces", "", 4, 1, 1,
      "N m, 0, N, N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result",
      "power", 1, 1, 0, "W"}, {"result", "value", 1, 1, 1, "m"}, {"result", "rate", 1, 1, 1, "m/s"}, {"result",
      "jacobian", 1, 4, 2, "1"}, {"result", "gamma", 1, 1, 1, ""}, {"result", "gap", 1, 1, 1, "m"}, {"result", "rate",
      1, 1, 1, "m/s"}, {"result", "jacobian", 1, 4, 2, ""}, {"result", "drift", 1, 1, 1, "m/s^2"}, {"result",
      "friction", 1, 1, 1, "1"}, {"result", "static_friction", 1, 1, 1, "1"}, {"result", "restitution", 1, 1, 1, "1"},
      {"result", "bound", 1, 1, 1, ""}, {"result", "static_bound", 1, 1, 1, ""}}};
  static constexpr std::array<torsor::KernelDescription, 6> kernels{{{"mass_matrix", false, false, false, false,
      results.data() + 0, 1}, {"bias", false, false, false, false, results.data() + 1, 1}, {"energy", false, false,
      true, false, results.data() + 2, 3}, {"constraints", false, false, false, false, results.data() + 5, 4},
      {"contacts", false, false, false, false, results.data() + 9, 4}, {"contact_coefficients", false, false, false,
      false, results.data() + 13, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::struck_mechanism::Description;

  static constexpr const char* name = "struck_mechanism";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x6368a9b0750639f3ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 4;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 1;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar d;  ///< parameter [m]
    Scalar e;  ///< parameter [1]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::d, &Parameters::e};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar theta;  ///< coordinate [rad]
    Scalar x;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar hinge_x;  ///< coordinate [m]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::theta, &Coordinates::x, &Coordinates::z,
          &Coordinates::hinge_x};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar theta;  ///< its rate [rad/s]
    Scalar x;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar hinge_x;  ///< its rate [m/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::theta, &Velocities::x, &Velocities::z,
          &Velocities::hinge_x};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar theta;  ///< its second rate [rad/s^2]
    Scalar x;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar hinge_x;  ///< its second rate [m/s^2]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::theta, &Accelerations::x, &Accelerations::z,
          &Accelerations::hinge_x};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar theta;  ///< works with the rate of theta [N m]
    Scalar x;  ///< works with the rate of x [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar hinge_x;  ///< works with the rate of hinge_x [N]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::theta, &GeneralizedForces::x,
          &GeneralizedForces::z, &GeneralizedForces::hinge_x};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_hinge_holds;  ///< of the constraint hinge_holds [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_hinge_holds};
      return members_[i_];
    }
  };

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
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    parameters.d = n0_9;
    parameters.e = n0_5;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar p_d = parameters.d;
    state.time = n0;
    state.q.theta = n0;
    state.q.x = -n0_05;
    state.q.z = -p_d;
    state.q.hinge_x = n0;
    state.v.theta = n0;
    state.v.x = n4;
    state.v.z = n0;
    state.v.hinge_x = n0;
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

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 1> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 1> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 4> jacobian;  ///< A, stored column by column (1 x 4)
    std::array<Scalar, 1> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Gaps of contacts, and what they may do along their normals and tangents.
  struct Contacts {
    std::array<Scalar, 1> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 1> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 4> jacobian;  ///< J, stored column by column (1 x 4)
    std::array<Scalar, 1> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 1;
  static constexpr int contact_row_count = 1;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[1] = {1};
  static constexpr int contact_tangents[1] = {0};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 1> friction;  ///< f [1]
    std::array<Scalar, 1> static_friction;  ///< f_s [1]
    std::array<Scalar, 1> restitution;  ///< e [1]
    std::array<Scalar, 1> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 1> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 16>& mass) noexcept {
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0_96 = traits::constant(0.96, 0.96f, "24/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar q_theta = state.q.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = n1_2 * c_theta;
    mass[0] = n0_96;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z0;
    mass[4] = n0;
    mass[5] = n0_3;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0_3;
    mass[11] = n0;
    mass[12] = z0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_theta * v_theta;
    const Scalar z1 = n9_81 * s_theta;
    const Scalar z2 = n1_2 * z0;  // force on rod, z
    const Scalar z3 = s_theta * z2;
    const Scalar z4 = n1_2 * z1;  // moment on rod, y
    forces.theta = z4;
    forces.x = n0;
    forces.z = n2_943;
    forces.hinge_x = -z3;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_96 = traits::constant(0.96, 0.96f, "24/25");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_hinge_x = state.v.hinge_x;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_x = state.v.x;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_hinge_x * c_theta;
    const Scalar z1 = v_hinge_x * s_theta;
    const Scalar z2 = n1_2 * c_theta;
    const Scalar z3 = n1_2 * v_theta + n2 * z0;
    const Scalar z4 = n0_96 * v_theta + n1_2 * z0;
    result.kinetic = n0_15 * (v_x * v_x + v_z * v_z) + z1 * z1 + n0_5 * (v_theta * z4 + z0 * z3);
    result.force_function = -n2_943 * q_z + n9_81 * z2;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_hinge_x = state.q.hinge_x;
    const Scalar v_hinge_x = state.v.hinge_x;
    result.value[0] = q_hinge_x;
    result.rate[0] = v_hinge_x;
    result.gamma[0] = n0;
    result.jacobian[0] = n0;
    result.jacobian[1] = n0;
    result.jacobian[2] = n0;
    result.jacobian[3] = n1;
  }

  /// Contacts that open and close, in the order blow.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar q_hinge_x = state.q.hinge_x;
    const Scalar v_hinge_x = state.v.hinge_x;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_theta * s_theta;
    const Scalar z1 = v_hinge_x - v_x;
    const Scalar z2 = v_theta * c_theta;
    const Scalar z3 = q_hinge_x - q_x;
    const Scalar z4 = s_theta * q_z - c_theta * z3;
    const Scalar z5 = s_theta * z3 + c_theta * q_z;
    const Scalar z6 = s_theta * v_z - c_theta * z1 + q_z * z2 + z3 * z0;
    const Scalar z7 = v_theta * z0;
    const Scalar z8 = v_theta * z2;
    const Scalar z9 = q_z * z7 - z3 * z8 - n2 * (v_z * z2 + z0 * z1);
    const Scalar z10 = n0_05 + z4;
    result.gap[0] = -z10;
    result.rate[0] = -z6;
    result.drift[0] = z9;
    result.jacobian[0] = -z5;
    result.jacobian[1] = -c_theta;
    result.jacobian[2] = -s_theta;
    result.jacobian[3] = c_theta;
  }

  /// What the surfaces of each contact are made of, in the order blow:
  /// |T| <= f N + b while it slides, f_s and b_s while it sticks.
  TORSOR_DEVICE static void contact_coefficients(const Precomputed& precomputed, const State&,
      ContactCoefficients& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_e = precomputed.parameters.e;
    result.friction[0] = n0;
    result.static_friction[0] = n0;
    result.restitution[0] = p_e;
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
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 16>&>(mass_matrix));
    visitor(Description::kernels[1], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[2], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[3], KernelFunction<void, Constraints&>(constraints));
    visitor(Description::kernels[4], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[5], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace struck_mechanism
