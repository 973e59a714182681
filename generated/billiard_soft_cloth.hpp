// SPDX-License-Identifier: MIT-0
// billiard_soft_cloth: Billiard ball that slides, rolls, and comes to rest
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: f, e, h, k
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   0                0          0             0                  0       0      0       0
//   bias                          6               17          0             0                  0       0     23      27
//   energy                       23               30          0             0                  0       0     53      63
//   contacts                     25               33          0             0                  0       0     58      64
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 36 results 30 vanish identically
//   bias: of 6 results 5 vanish identically
//   energy: of 3 results 1 vanish identically
//   contacts: of 51 results 26 vanish identically
//   contact_coefficients: of 15 results 8 vanish identically, 3 repeat another up to sign
//
// To write this file again:
//   billiard_soft_cloth_scene generate --kernels mass_matrix,bias,energy,contacts,contact_coefficients --support torsor_support.hpp --output billiard_soft_cloth.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace billiard_soft_cloth {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 7> coordinates{{{"x", "m"}, {"y", "m"}, {"z", "m"},
      {"turn_w", "1"}, {"turn_x", "1"}, {"turn_y", "1"}, {"turn_z", "1"}}};
  static constexpr std::array<torsor::QuantityDescription, 6> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"},
      {"turn_omega_x", "rad/s"}, {"turn_omega_y", "rad/s"}, {"turn_omega_z", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 4> parameters{{{"f", "1"}, {"e", "1"}, {"h", "m"}, {"k",
      "m"}}};
  static constexpr std::array<torsor::ResultDescription, 15> results{{{"rates", "", 7, 1, 1,
      "m/s, m/s, m/s, rad/s, rad/s, rad/s, rad/s"}, {"mass", "", 6, 6, 2, ""}, {"forces", "", 6, 1, 1, "N"}, {"result",
      "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"},
      {"result", "gap", 3, 1, 1, "m"}, {"result", "rate", 6, 1, 1, "m/s, m/s, m/s, rad/s, rad/s, rad/s"}, {"result",
      "jacobian", 6, 6, 2, ""}, {"result", "drift", 6, 1, 1, ""}, {"result", "friction", 3, 1, 1, "1, m, m"}, {"result",
      "static_friction", 3, 1, 1, "1, m, m"}, {"result", "restitution", 3, 1, 1, "1"}, {"result", "bound", 3, 1, 1, ""},
      {"result", "static_bound", 3, 1, 1, ""}}};
  static constexpr std::array<torsor::KernelDescription, 6> kernels{{{"coordinate_rates", false, false, false, false,
      results.data() + 0, 1}, {"mass_matrix", false, false, false, false, results.data() + 1, 1}, {"bias", false, false,
      false, false, results.data() + 2, 1}, {"energy", false, false, true, false, results.data() + 3, 3}, {"contacts",
      false, false, false, false, results.data() + 6, 4}, {"contact_coefficients", false, false, false, false,
      results.data() + 10, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::billiard_soft_cloth::Description;

  static constexpr const char* name = "billiard_soft_cloth";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x78804ea1266eaaa3ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 1;
  static constexpr int quaternions[quaternion_count] = {3};

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar f;  ///< parameter [1]
    Scalar e;  ///< parameter [1]
    Scalar h;  ///< parameter [m]
    Scalar k;  ///< parameter [m]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::f, &Parameters::e, &Parameters::h, &Parameters::k};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar turn_w;  ///< component of a unit quaternion [1]
    Scalar turn_x;  ///< component of a unit quaternion [1]
    Scalar turn_y;  ///< component of a unit quaternion [1]
    Scalar turn_z;  ///< component of a unit quaternion [1]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::z,
          &Coordinates::turn_w, &Coordinates::turn_x, &Coordinates::turn_y, &Coordinates::turn_z};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar turn_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar turn_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar turn_omega_z;  ///< angular velocity, in moving axes [rad/s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::z,
          &Velocities::turn_omega_x, &Velocities::turn_omega_y, &Velocities::turn_omega_z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar turn_omega_x;  ///< its rate [rad/s^2]
    Scalar turn_omega_y;  ///< its rate [rad/s^2]
    Scalar turn_omega_z;  ///< its rate [rad/s^2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::z,
          &Accelerations::turn_omega_x, &Accelerations::turn_omega_y, &Accelerations::turn_omega_z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar turn_omega_x;  ///< works with turn_omega_x [N m]
    Scalar turn_omega_y;  ///< works with turn_omega_y [N m]
    Scalar turn_omega_z;  ///< works with turn_omega_z [N m]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::z, &GeneralizedForces::turn_omega_x, &GeneralizedForces::turn_omega_y,
          &GeneralizedForces::turn_omega_z};
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
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    parameters.f = n0_2;
    parameters.e = n0;
    parameters.h = n0_0005;
    parameters.k = n0_0002;
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
    const Scalar k1 = traits::constant(0.028575, 0.028575f, "1143/40000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.z = k1;
    state.q.turn_w = n1;
    state.q.turn_x = n0;
    state.q.turn_y = n0;
    state.q.turn_z = n0;
    state.v.x = n2;
    state.v.y = n0;
    state.v.z = n0;
    state.v.turn_omega_x = n0;
    state.v.turn_omega_y = n0;
    state.v.turn_omega_z = n0;
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
    std::array<Scalar, 3> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 6> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 36> jacobian;  ///< J, stored column by column (6 x 6)
    std::array<Scalar, 6> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 3;
  static constexpr int contact_row_count = 6;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[3] = {1, 0, 0};
  static constexpr int contact_tangents[3] = {2, 2, 1};
  /// Of a turn that is resisted the contact whose N bounds the moment, from 1; else 0.
  static constexpr int contact_pressed_by[3] = {0, 1, 1};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 3> friction;  ///< f [1]; of turns h [m]
    std::array<Scalar, 3> static_friction;  ///< f_s [1]; of turns h [m]
    std::array<Scalar, 3> restitution;  ///< e [1]
    std::array<Scalar, 3> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 3> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 7>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar v_z = state.v.z;
    const Scalar q_turn_y = state.q.turn_y;
    const Scalar q_turn_z = state.q.turn_z;
    const Scalar q_turn_x = state.q.turn_x;
    const Scalar q_turn_w = state.q.turn_w;
    const Scalar v_turn_omega_x = state.v.turn_omega_x;
    const Scalar v_turn_omega_y = state.v.turn_omega_y;
    const Scalar v_turn_omega_z = state.v.turn_omega_z;
    const Scalar z0 = n0_5 * (q_turn_y * v_turn_omega_y + q_turn_z * v_turn_omega_z + q_turn_x * v_turn_omega_x);
    const Scalar z1 = n0_5 * (q_turn_y * v_turn_omega_z - q_turn_z * v_turn_omega_y + q_turn_w * v_turn_omega_x);
    const Scalar z2 = n0_5 * (q_turn_z * v_turn_omega_x - q_turn_x * v_turn_omega_z + q_turn_w * v_turn_omega_y);
    const Scalar z3 = n0_5 * (q_turn_y * v_turn_omega_x - q_turn_x * v_turn_omega_y - q_turn_w * v_turn_omega_z);
    rates[0] = v_x;
    rates[1] = v_y;
    rates[2] = v_z;
    rates[3] = -z0;
    rates[4] = z1;
    rates[5] = z2;
    rates[6] = -z3;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 36>& mass) noexcept {
    const Scalar n0_17 = traits::constant(0.17, 0.17f, "17/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k2 = traits::constant(5.55240825e-05, 5.5524084e-05f, "22209633/400000000000");
    mass[0] = n0_17;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0_17;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0_17;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = k2;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = k2;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = k2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_17 = traits::constant(0.17, 0.17f, "17/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_turn_y = state.q.turn_y;
    const Scalar q_turn_z = state.q.turn_z;
    const Scalar q_turn_x = state.q.turn_x;
    const Scalar q_turn_w = state.q.turn_w;
    const Scalar z0 = n2 * q_turn_y;
    const Scalar z1 = n2 * q_turn_x;
    const Scalar z2 = q_turn_y * z0;
    const Scalar z3 = q_turn_x * z1;
    const Scalar z4 = q_turn_z * z0;
    const Scalar z5 = q_turn_w * z1;
    const Scalar z6 = q_turn_z * z1;
    const Scalar z7 = q_turn_w * z0;
    const Scalar z8 = z4 + z5;
    const Scalar z9 = n1 - z2 - z3;
    const Scalar z10 = z6 - z7;
    const Scalar z11 = n9_81 * z10;
    const Scalar z12 = n9_81 * z8;
    const Scalar z13 = n9_81 * z9;
    const Scalar z14 = n0_17 * z11;  // force on ball, x
    const Scalar z15 = n0_17 * z12;  // force on ball, y
    const Scalar z16 = n0_17 * z13;  // force on ball, z
    const Scalar z17 = z8 * z15 + z9 * z16 + z10 * z14;
    forces.x = n0;
    forces.y = n0;
    forces.z = z17;
    forces.turn_omega_x = n0;
    forces.turn_omega_y = n0;
    forces.turn_omega_z = n0;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k2 = traits::constant(2.776204125e-05, 2.7762042e-05f, "22209633/800000000000");
    const Scalar n0_085 = traits::constant(0.085, 0.085f, "17/200");
    const Scalar n1_6677 = traits::constant(1.6677, 1.6677f, "16677/10000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_turn_y = state.q.turn_y;
    const Scalar q_turn_z = state.q.turn_z;
    const Scalar q_turn_x = state.q.turn_x;
    const Scalar q_turn_w = state.q.turn_w;
    const Scalar v_turn_omega_x = state.v.turn_omega_x;
    const Scalar v_turn_omega_y = state.v.turn_omega_y;
    const Scalar v_turn_omega_z = state.v.turn_omega_z;
    const Scalar z0 = n2 * q_turn_y;
    const Scalar z1 = n2 * q_turn_z;
    const Scalar z2 = n2 * q_turn_x;
    const Scalar z3 = q_turn_y * z0;
    const Scalar z4 = q_turn_z * z1;
    const Scalar z5 = q_turn_x * z0;
    const Scalar z6 = q_turn_w * z1;
    const Scalar z7 = q_turn_x * z1;
    const Scalar z8 = q_turn_w * z0;
    const Scalar z9 = q_turn_x * z2;
    const Scalar z10 = q_turn_z * z0;
    const Scalar z11 = q_turn_w * z2;
    const Scalar z12 = z5 - z6;
    const Scalar z13 = z5 + z6;
    const Scalar z14 = z7 + z8;
    const Scalar z15 = n1 - z4 - z9;
    const Scalar z16 = z10 - z11;
    const Scalar z17 = z7 - z8;
    const Scalar z18 = n1 - z3 - z4;
    const Scalar z19 = z10 + z11;
    const Scalar z20 = n1 - z3 - z9;
    const Scalar z21 = v_y * z13 + v_z * z17 + v_x * z18;
    const Scalar z22 = v_x * z12 + v_y * z15 + v_z * z19;
    const Scalar z23 = v_x * z14 + v_y * z16 + v_z * z20;
    result.kinetic = k2 * (v_turn_omega_x * v_turn_omega_x + v_turn_omega_y * v_turn_omega_y + v_turn_omega_z
        * v_turn_omega_z) + n0_085 * (z21 * z21 + z22 * z22 + z23 * z23);
    result.force_function = -n1_6677 * q_z;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Contacts that open and close, in the order cloth, cloth_rolling, cloth_spinning.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k1 = traits::constant(0.028575, 0.028575f, "1143/40000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_turn_y = state.q.turn_y;
    const Scalar q_turn_z = state.q.turn_z;
    const Scalar q_turn_x = state.q.turn_x;
    const Scalar q_turn_w = state.q.turn_w;
    const Scalar v_turn_omega_x = state.v.turn_omega_x;
    const Scalar v_turn_omega_y = state.v.turn_omega_y;
    const Scalar v_turn_omega_z = state.v.turn_omega_z;
    const Scalar z0 = n2 * q_turn_y;
    const Scalar z1 = n2 * q_turn_z;
    const Scalar z2 = n2 * q_turn_x;
    const Scalar z3 = k1 - q_z;
    const Scalar z4 = q_turn_y * z0;
    const Scalar z5 = q_turn_z * z1;
    const Scalar z6 = q_turn_x * z0;
    const Scalar z7 = q_turn_w * z1;
    const Scalar z8 = q_turn_x * z2;
    const Scalar z9 = q_turn_x * z1;
    const Scalar z10 = q_turn_w * z0;
    const Scalar z11 = q_turn_z * z0;
    const Scalar z12 = z6 - z7;
    const Scalar z13 = z6 + z7;
    const Scalar z14 = q_turn_w * z2;
    const Scalar z15 = n1 - z5 - z8;
    const Scalar z16 = z9 - z10;
    const Scalar z17 = k1 * z13;
    const Scalar z18 = k1 * z12;
    const Scalar z19 = z9 + z10;
    const Scalar z20 = z11 + z14;
    const Scalar z21 = k1 * z19;
    const Scalar z22 = n1 - z4 - z5;
    const Scalar z23 = k1 * z15;
    const Scalar z24 = z11 - z14;
    const Scalar z25 = n1 - z4 - z8;
    const Scalar z26 = k1 * z22;
    const Scalar z27 = k1 * z24;
    const Scalar z28 = v_turn_omega_y * z12 + v_turn_omega_z * z19 + v_turn_omega_x * z22;
    const Scalar z29 = v_turn_omega_x * z13 + v_turn_omega_y * z15 + v_turn_omega_z * z24;
    const Scalar z30 = v_turn_omega_x * z16 + v_turn_omega_y * z20 + v_turn_omega_z * z25;
    const Scalar z31 = v_x - v_turn_omega_x * z17 - v_turn_omega_y * z23 - v_turn_omega_z * z27;
    const Scalar z32 = v_y + v_turn_omega_y * z18 + v_turn_omega_z * z21 + v_turn_omega_x * z26;
    result.gap[0] = -z3;
    result.rate[0] = v_z;
    result.drift[0] = n0;
    result.rate[1] = z31;
    result.drift[1] = n0;
    result.rate[2] = z32;
    result.drift[2] = n0;
    result.gap[1] = n0;
    result.rate[3] = z28;
    result.drift[3] = n0;
    result.rate[4] = z29;
    result.drift[4] = n0;
    result.gap[2] = n0;
    result.rate[5] = z30;
    result.drift[5] = n0;
    result.jacobian[0] = n0;
    result.jacobian[1] = n1;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = n0;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = n0;
    result.jacobian[8] = n1;
    result.jacobian[9] = n0;
    result.jacobian[10] = n0;
    result.jacobian[11] = n0;
    result.jacobian[12] = n1;
    result.jacobian[13] = n0;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = -z17;
    result.jacobian[20] = z26;
    result.jacobian[21] = z22;
    result.jacobian[22] = z13;
    result.jacobian[23] = z16;
    result.jacobian[24] = n0;
    result.jacobian[25] = -z23;
    result.jacobian[26] = z18;
    result.jacobian[27] = z12;
    result.jacobian[28] = z15;
    result.jacobian[29] = z20;
    result.jacobian[30] = n0;
    result.jacobian[31] = -z27;
    result.jacobian[32] = z21;
    result.jacobian[33] = z19;
    result.jacobian[34] = z24;
    result.jacobian[35] = z25;
  }

  /// What the surfaces of each contact are made of, in the order cloth, cloth_rolling, cloth_spinning:
  /// |T| <= f N + b while it slides, f_s and b_s while it sticks.
  TORSOR_DEVICE static void contact_coefficients(const Precomputed& precomputed, const State&,
      ContactCoefficients& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_e = precomputed.parameters.e;
    const Scalar p_h = precomputed.parameters.h;
    const Scalar p_k = precomputed.parameters.k;
    result.friction[0] = p_f;
    result.static_friction[0] = p_f;
    result.restitution[0] = p_e;
    result.bound[0] = n0;
    result.static_bound[0] = n0;
    result.friction[1] = p_h;
    result.static_friction[1] = p_h;
    result.restitution[1] = n0;
    result.bound[1] = n0;
    result.static_bound[1] = n0;
    result.friction[2] = p_k;
    result.static_friction[2] = p_k;
    result.restitution[2] = n0;
    result.bound[2] = n0;
    result.static_bound[2] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 7>&>(coordinate_rates));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 36>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[4], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[5], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace billiard_soft_cloth
