// SPDX-License-Identifier: MIT-0
// struck_mechanism_two_rods: Two jointed rods struck by a ball
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, constraints, contacts, contact_coefficients
// Parameters set at run time: e
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   0                0          0             0                  0       0      0       0
//   bias                          0                0          0             0                  0       0      0       0
//   energy                       10               18          0             0                  2       0     32      36
//   constraints                  14               20          0             0                  2       0     38      38
//   contacts                     11               17          0             0                  1       0     30      31
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 49 results 42 vanish identically
//   bias: of 7 results 7 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: of 20 results 6 vanish identically
//   contacts: of 10 results 3 vanish identically, 1 repeat another up to sign
//   contact_coefficients: of 5 results 4 vanish identically
//
// To write this file again:
//   struck_mechanism_two_rods_scene generate --kernels mass_matrix,bias,energy,constraints,contacts,contact_coefficients --support torsor_support.hpp --output struck_mechanism_two_rods.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace struck_mechanism_two_rods {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 7> coordinates{{{"x1", "m"}, {"z1", "m"}, {"w1", "rad"},
      {"x2", "m"}, {"z2", "m"}, {"w2", "rad"}, {"z", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 7> velocities{{{"x1", "m/s"}, {"z1", "m/s"}, {"w1", "rad/s"},
      {"x2", "m/s"}, {"z2", "m/s"}, {"w2", "rad/s"}, {"z", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 2> multipliers{{{"lambda_B_x", "N"}, {"lambda_B_z", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"e", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 18> results{{{"mass", "", 7, 7, 2, ""}, {"forces", "", 7, 1, 1,
      ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "value", 2, 1, 1, "m"}, {"result", "rate", 2, 1, 1, "m/s"}, {"result", "jacobian", 2, 7, 2, ""},
      {"result", "gamma", 2, 1, 1, "m/s^2"}, {"result", "gap", 1, 1, 1, "m"}, {"result", "rate", 1, 1, 1, "m/s"},
      {"result", "jacobian", 1, 7, 2, ""}, {"result", "drift", 1, 1, 1, "m/s^2"}, {"result", "friction", 1, 1, 1, "1"},
      {"result", "static_friction", 1, 1, 1, "1"}, {"result", "restitution", 1, 1, 1, "1"}, {"result", "bound", 1, 1, 1,
      ""}, {"result", "static_bound", 1, 1, 1, ""}}};
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
  using Description = ::struck_mechanism_two_rods::Description;

  static constexpr const char* name = "struck_mechanism_two_rods";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x6c78330c1631d122ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 2;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar e;  ///< parameter [1]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::e};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x1;  ///< coordinate [m]
    Scalar z1;  ///< coordinate [m]
    Scalar w1;  ///< coordinate [rad]
    Scalar x2;  ///< coordinate [m]
    Scalar z2;  ///< coordinate [m]
    Scalar w2;  ///< coordinate [rad]
    Scalar z;  ///< coordinate [m]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x1, &Coordinates::z1, &Coordinates::w1,
          &Coordinates::x2, &Coordinates::z2, &Coordinates::w2, &Coordinates::z};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x1;  ///< its rate [m/s]
    Scalar z1;  ///< its rate [m/s]
    Scalar w1;  ///< its rate [rad/s]
    Scalar x2;  ///< its rate [m/s]
    Scalar z2;  ///< its rate [m/s]
    Scalar w2;  ///< its rate [rad/s]
    Scalar z;  ///< its rate [m/s]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x1, &Velocities::z1, &Velocities::w1, &Velocities::x2,
          &Velocities::z2, &Velocities::w2, &Velocities::z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x1;  ///< its second rate [m/s^2]
    Scalar z1;  ///< its second rate [m/s^2]
    Scalar w1;  ///< its second rate [rad/s^2]
    Scalar x2;  ///< its second rate [m/s^2]
    Scalar z2;  ///< its second rate [m/s^2]
    Scalar w2;  ///< its second rate [rad/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x1, &Accelerations::z1, &Accelerations::w1,
          &Accelerations::x2, &Accelerations::z2, &Accelerations::w2, &Accelerations::z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x1;  ///< works with the rate of x1 [N]
    Scalar z1;  ///< works with the rate of z1 [N]
    Scalar w1;  ///< works with the rate of w1 [N m]
    Scalar x2;  ///< works with the rate of x2 [N]
    Scalar z2;  ///< works with the rate of z2 [N]
    Scalar w2;  ///< works with the rate of w2 [N m]
    Scalar z;  ///< works with the rate of z [N]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x1, &GeneralizedForces::z1,
          &GeneralizedForces::w1, &GeneralizedForces::x2, &GeneralizedForces::z2, &GeneralizedForces::w2,
          &GeneralizedForces::z};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_B_x;  ///< of the constraint B_x [N]
    Scalar lambda_B_z;  ///< of the constraint B_z [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_B_x, &Multipliers::lambda_B_z};
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
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
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    state.time = n0;
    state.q.x1 = n0_5;
    state.q.z1 = n0;
    state.q.w1 = n0;
    state.q.x2 = n1_5;
    state.q.z2 = n0;
    state.q.w2 = n0;
    state.q.z = -n0_05;
    state.v.x1 = n0;
    state.v.z1 = n0;
    state.v.w1 = n0;
    state.v.x2 = n0;
    state.v.z2 = n0;
    state.v.w2 = n0;
    state.v.z = n1;
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
    std::array<Scalar, 2> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 2> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 14> jacobian;  ///< A, stored column by column (2 x 7)
    std::array<Scalar, 2> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Gaps of contacts, and what they may do along their normals and tangents.
  struct Contacts {
    std::array<Scalar, 1> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 1> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 7> jacobian;  ///< J, stored column by column (1 x 7)
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
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 49>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1_over_12 = traits::constant(0.08333333333333333, 0.083333336f, "1/12");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n1;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n1_over_12;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n1;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n1;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = n1_over_12;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0_5;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State&, GeneralizedForces& forces) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    forces.x1 = n0;
    forces.z1 = n0;
    forces.w1 = n0;
    forces.x2 = n0;
    forces.z2 = n0;
    forces.w2 = n0;
    forces.z = n0;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n1_over_24 = traits::constant(0.041666666666666664, 0.041666668f, "1/24");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x1 = state.v.x1;
    const Scalar v_z1 = state.v.z1;
    const Scalar q_w1 = state.q.w1;
    const Scalar v_w1 = state.v.w1;
    const Scalar v_x2 = state.v.x2;
    const Scalar v_z2 = state.v.z2;
    const Scalar q_w2 = state.q.w2;
    const Scalar v_w2 = state.v.w2;
    const Scalar v_z = state.v.z;
    const Scalar angles_[] = {q_w1, q_w2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_w1 = sines_[0], c_w1 = cosines_[0];
    const Scalar s_w2 = sines_[1], c_w2 = cosines_[1];
    const Scalar z0 = v_x1 * c_w1 + v_z1 * s_w1;
    const Scalar z1 = v_x1 * s_w1 - v_z1 * c_w1;
    const Scalar z2 = v_x2 * c_w2 + v_z2 * s_w2;
    const Scalar z3 = v_x2 * s_w2 - v_z2 * c_w2;
    result.kinetic = n0_25 * v_z * v_z + n1_over_24 * (v_w1 * v_w1 + v_w2 * v_w2) + n0_5 * (z0 * z0 + z1 * z1 + z2 * z2
        + z3 * z3);
    result.force_function = n0;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x1 = state.q.x1;
    const Scalar v_x1 = state.v.x1;
    const Scalar q_z1 = state.q.z1;
    const Scalar v_z1 = state.v.z1;
    const Scalar q_w1 = state.q.w1;
    const Scalar v_w1 = state.v.w1;
    const Scalar q_x2 = state.q.x2;
    const Scalar v_x2 = state.v.x2;
    const Scalar q_z2 = state.q.z2;
    const Scalar v_z2 = state.v.z2;
    const Scalar q_w2 = state.q.w2;
    const Scalar v_w2 = state.v.w2;
    const Scalar angles_[] = {q_w1, q_w2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_w1 = sines_[0], c_w1 = cosines_[0];
    const Scalar s_w2 = sines_[1], c_w2 = cosines_[1];
    const Scalar z0 = v_w1 * s_w1;
    const Scalar z1 = v_w2 * s_w2;
    const Scalar z2 = v_w1 * c_w1;
    const Scalar z3 = v_w2 * c_w2;
    const Scalar z4 = n0_5 * c_w1;
    const Scalar z5 = n0_5 * s_w1;
    const Scalar z6 = n0_5 * c_w2;
    const Scalar z7 = n0_5 * s_w2;
    const Scalar z8 = q_z1 + z5;
    const Scalar z9 = q_x1 + z4;
    const Scalar z10 = q_z2 - z7;
    const Scalar z11 = q_x2 - z6;
    const Scalar z12 = n0_5 * z0;
    const Scalar z13 = n0_5 * z1;
    const Scalar z14 = v_w1 * z2;
    const Scalar z15 = v_w2 * z3;
    const Scalar z16 = n0_5 * z2;
    const Scalar z17 = n0_5 * z3;
    const Scalar z18 = v_w1 * z0;
    const Scalar z19 = v_w2 * z1;
    const Scalar z20 = z9 - z11;
    const Scalar z21 = z8 - z10;
    const Scalar z22 = v_x1 - z12;
    const Scalar z23 = v_x2 + z13;
    const Scalar z24 = n0_5 * z14;
    const Scalar z25 = n0_5 * z15;
    const Scalar z26 = v_z1 + z16;
    const Scalar z27 = v_z2 - z17;
    const Scalar z28 = n0_5 * z18;
    const Scalar z29 = n0_5 * z19;
    const Scalar z30 = z22 - z23;
    const Scalar z31 = z24 + z25;
    const Scalar z32 = z26 - z27;
    const Scalar z33 = z28 + z29;
    result.value[0] = -z20;
    result.rate[0] = -z30;
    result.gamma[0] = z31;
    result.value[1] = -z21;
    result.rate[1] = -z32;
    result.gamma[1] = z33;
    result.jacobian[0] = -n1;
    result.jacobian[1] = n0;
    result.jacobian[2] = n0;
    result.jacobian[3] = -n1;
    result.jacobian[4] = z5;
    result.jacobian[5] = -z4;
    result.jacobian[6] = n1;
    result.jacobian[7] = n0;
    result.jacobian[8] = n0;
    result.jacobian[9] = n1;
    result.jacobian[10] = z7;
    result.jacobian[11] = -z6;
    result.jacobian[12] = n0;
    result.jacobian[13] = n0;
  }

  /// Contacts that open and close, in the order blow.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x1 = state.q.x1;
    const Scalar v_x1 = state.v.x1;
    const Scalar q_z1 = state.q.z1;
    const Scalar v_z1 = state.v.z1;
    const Scalar q_w1 = state.q.w1;
    const Scalar v_w1 = state.v.w1;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    Scalar s_w1, c_w1;
    traits::sincos(q_w1, s_w1, c_w1);
    const Scalar z0 = v_w1 * s_w1;
    const Scalar z1 = v_z1 - v_z;
    const Scalar z2 = v_w1 * c_w1;
    const Scalar z3 = q_z1 - q_z;
    const Scalar z4 = q_x1 * c_w1 + s_w1 * z3;
    const Scalar z5 = q_x1 * s_w1 - c_w1 * z3;
    const Scalar z6 = v_x1 * s_w1 - c_w1 * z1 + q_x1 * z2 + z3 * z0;
    const Scalar z7 = v_w1 * z0;
    const Scalar z8 = v_w1 * z2;
    const Scalar z9 = q_x1 * z7 - z3 * z8 - n2 * (v_x1 * z2 + z0 * z1);
    const Scalar z10 = n0_05 + z5;
    result.gap[0] = -z10;
    result.rate[0] = -z6;
    result.drift[0] = z9;
    result.jacobian[0] = -s_w1;
    result.jacobian[1] = c_w1;
    result.jacobian[2] = -z4;
    result.jacobian[3] = n0;
    result.jacobian[4] = n0;
    result.jacobian[5] = n0;
    result.jacobian[6] = -c_w1;
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
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 49>&>(mass_matrix));
    visitor(Description::kernels[1], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[2], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[3], KernelFunction<void, Constraints&>(constraints));
    visitor(Description::kernels[4], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[5], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace struck_mechanism_two_rods
