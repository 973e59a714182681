// SPDX-License-Identifier: MIT-0
// billiard_two_balls: Billiard ball that strikes another one
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: f, e, f_between
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   0                0          0             0                  0       0      0       0
//   bias                         12               34          0             0                  0       0     46      54
//   energy                       48               57          0             0                  0       0    105     128
//   contacts                    282              410         17             1                  0       0    710     757
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 144 results 132 vanish identically
//   bias: of 12 results 10 vanish identically
//   energy: of 3 results 1 vanish identically
//   contacts: of 129 results 66 vanish identically, 9 repeat another up to sign
//   contact_coefficients: of 15 results 8 vanish identically, 4 repeat another up to sign
//
// To write this file again:
//   billiard_two_balls_scene generate --kernels mass_matrix,bias,energy,contacts,contact_coefficients --support torsor_support.hpp --output billiard_two_balls.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace billiard_two_balls {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 14> coordinates{{{"x", "m"}, {"y", "m"}, {"z", "m"},
      {"turn_w", "1"}, {"turn_x", "1"}, {"turn_y", "1"}, {"turn_z", "1"}, {"x2", "m"}, {"y2", "m"}, {"z2", "m"},
      {"turn2_w", "1"}, {"turn2_x", "1"}, {"turn2_y", "1"}, {"turn2_z", "1"}}};
  static constexpr std::array<torsor::QuantityDescription, 12> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"},
      {"turn_omega_x", "rad/s"}, {"turn_omega_y", "rad/s"}, {"turn_omega_z", "rad/s"}, {"x2", "m/s"}, {"y2", "m/s"},
      {"z2", "m/s"}, {"turn2_omega_x", "rad/s"}, {"turn2_omega_y", "rad/s"}, {"turn2_omega_z", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 3> parameters{{{"f", "1"}, {"e", "1"}, {"f_between", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 15> results{{{"rates", "", 14, 1, 1,
      "m/s, m/s, m/s, rad/s, rad/s, rad/s, rad/s, m/s, m/s, m/s, rad/s, rad/s, rad/s, rad/s"}, {"mass", "", 12, 12, 2,
      ""}, {"forces", "", 12, 1, 1, "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0,
      "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "gap", 3, 1, 1, "m"}, {"result", "rate", 9, 1, 1, "m/s"},
      {"result", "jacobian", 9, 12, 2, ""}, {"result", "drift", 9, 1, 1, "m/s^2"}, {"result", "friction", 3, 1, 1, "1"},
      {"result", "static_friction", 3, 1, 1, "1"}, {"result", "restitution", 3, 1, 1, "1"}, {"result", "bound", 3, 1, 1,
      ""}, {"result", "static_bound", 3, 1, 1, ""}}};
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
  using Description = ::billiard_two_balls::Description;

  static constexpr const char* name = "billiard_two_balls";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xba5310ed479fe3e9ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 14;
  static constexpr int velocity_count = 12;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 3;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 2;
  static constexpr int quaternions[quaternion_count] = {3, 10};

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar f;  ///< parameter [1]
    Scalar e;  ///< parameter [1]
    Scalar f_between;  ///< parameter [1]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::f, &Parameters::e, &Parameters::f_between};
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
    Scalar x2;  ///< coordinate [m]
    Scalar y2;  ///< coordinate [m]
    Scalar z2;  ///< coordinate [m]
    Scalar turn2_w;  ///< component of a unit quaternion [1]
    Scalar turn2_x;  ///< component of a unit quaternion [1]
    Scalar turn2_y;  ///< component of a unit quaternion [1]
    Scalar turn2_z;  ///< component of a unit quaternion [1]
    static constexpr int size = 14;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::z,
          &Coordinates::turn_w, &Coordinates::turn_x, &Coordinates::turn_y, &Coordinates::turn_z, &Coordinates::x2,
          &Coordinates::y2, &Coordinates::z2, &Coordinates::turn2_w, &Coordinates::turn2_x, &Coordinates::turn2_y,
          &Coordinates::turn2_z};
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
    Scalar x2;  ///< its rate [m/s]
    Scalar y2;  ///< its rate [m/s]
    Scalar z2;  ///< its rate [m/s]
    Scalar turn2_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar turn2_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar turn2_omega_z;  ///< angular velocity, in moving axes [rad/s]
    static constexpr int size = 12;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::z,
          &Velocities::turn_omega_x, &Velocities::turn_omega_y, &Velocities::turn_omega_z, &Velocities::x2,
          &Velocities::y2, &Velocities::z2, &Velocities::turn2_omega_x, &Velocities::turn2_omega_y,
          &Velocities::turn2_omega_z};
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
    Scalar x2;  ///< its second rate [m/s^2]
    Scalar y2;  ///< its second rate [m/s^2]
    Scalar z2;  ///< its second rate [m/s^2]
    Scalar turn2_omega_x;  ///< its rate [rad/s^2]
    Scalar turn2_omega_y;  ///< its rate [rad/s^2]
    Scalar turn2_omega_z;  ///< its rate [rad/s^2]
    static constexpr int size = 12;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::z,
          &Accelerations::turn_omega_x, &Accelerations::turn_omega_y, &Accelerations::turn_omega_z, &Accelerations::x2,
          &Accelerations::y2, &Accelerations::z2, &Accelerations::turn2_omega_x, &Accelerations::turn2_omega_y,
          &Accelerations::turn2_omega_z};
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
    Scalar x2;  ///< works with the rate of x2 [N]
    Scalar y2;  ///< works with the rate of y2 [N]
    Scalar z2;  ///< works with the rate of z2 [N]
    Scalar turn2_omega_x;  ///< works with turn2_omega_x [N m]
    Scalar turn2_omega_y;  ///< works with turn2_omega_y [N m]
    Scalar turn2_omega_z;  ///< works with turn2_omega_z [N m]
    static constexpr int size = 12;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::z, &GeneralizedForces::turn_omega_x, &GeneralizedForces::turn_omega_y,
          &GeneralizedForces::turn_omega_z, &GeneralizedForces::x2, &GeneralizedForces::y2, &GeneralizedForces::z2,
          &GeneralizedForces::turn2_omega_x, &GeneralizedForces::turn2_omega_y, &GeneralizedForces::turn2_omega_z};
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
    const Scalar n0_93 = traits::constant(0.93, 0.93f, "93/100");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    parameters.f = n0_2;
    parameters.e = n0_93;
    parameters.f_between = n0_06;
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
    const Scalar k1 = traits::constant(0.04949335182628067, 0.04949335f, "0;0;1143/40000;0");
    const Scalar k2 = traits::constant(0.028575, 0.028575f, "1143/40000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    state.time = n0;
    state.q.x = -k1;
    state.q.y = -k2;
    state.q.z = k2;
    state.q.turn_w = n1;
    state.q.turn_x = n0;
    state.q.turn_y = n0;
    state.q.turn_z = n0;
    state.q.x2 = n0;
    state.q.y2 = n0;
    state.q.z2 = k2;
    state.q.turn2_w = n1;
    state.q.turn2_x = n0;
    state.q.turn2_y = n0;
    state.q.turn2_z = n0;
    state.v.x = n2;
    state.v.y = n0;
    state.v.z = n0;
    state.v.turn_omega_x = n0;
    state.v.turn_omega_y = n0;
    state.v.turn_omega_z = n0;
    state.v.x2 = n0;
    state.v.y2 = n0;
    state.v.z2 = n0;
    state.v.turn2_omega_x = n0;
    state.v.turn2_omega_y = n0;
    state.v.turn2_omega_z = n0;
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
    std::array<Scalar, 9> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 108> jacobian;  ///< J, stored column by column (9 x 12)
    std::array<Scalar, 9> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 3;
  static constexpr int contact_row_count = 9;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[3] = {1, 1, 1};
  static constexpr int contact_tangents[3] = {2, 2, 2};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 3> friction;  ///< f [1]
    std::array<Scalar, 3> static_friction;  ///< f_s [1]
    std::array<Scalar, 3> restitution;  ///< e [1]
    std::array<Scalar, 3> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 3> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 14>& rates) noexcept {
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
    const Scalar v_x2 = state.v.x2;
    const Scalar v_y2 = state.v.y2;
    const Scalar v_z2 = state.v.z2;
    const Scalar q_turn2_y = state.q.turn2_y;
    const Scalar q_turn2_z = state.q.turn2_z;
    const Scalar q_turn2_x = state.q.turn2_x;
    const Scalar q_turn2_w = state.q.turn2_w;
    const Scalar v_turn2_omega_x = state.v.turn2_omega_x;
    const Scalar v_turn2_omega_y = state.v.turn2_omega_y;
    const Scalar v_turn2_omega_z = state.v.turn2_omega_z;
    const Scalar z0 = n0_5 * (q_turn_y * v_turn_omega_y + q_turn_z * v_turn_omega_z + q_turn_x * v_turn_omega_x);
    const Scalar z1 = n0_5 * (q_turn_y * v_turn_omega_z - q_turn_z * v_turn_omega_y + q_turn_w * v_turn_omega_x);
    const Scalar z2 = n0_5 * (q_turn_z * v_turn_omega_x - q_turn_x * v_turn_omega_z + q_turn_w * v_turn_omega_y);
    const Scalar z3 = n0_5 * (q_turn_y * v_turn_omega_x - q_turn_x * v_turn_omega_y - q_turn_w * v_turn_omega_z);
    const Scalar z4 = n0_5 * (q_turn2_y * v_turn2_omega_y + q_turn2_z * v_turn2_omega_z + q_turn2_x * v_turn2_omega_x);
    const Scalar z5 = n0_5 * (q_turn2_y * v_turn2_omega_z - q_turn2_z * v_turn2_omega_y + q_turn2_w * v_turn2_omega_x);
    const Scalar z6 = n0_5 * (q_turn2_z * v_turn2_omega_x - q_turn2_x * v_turn2_omega_z + q_turn2_w * v_turn2_omega_y);
    const Scalar z7 = n0_5 * (q_turn2_y * v_turn2_omega_x - q_turn2_x * v_turn2_omega_y - q_turn2_w * v_turn2_omega_z);
    rates[0] = v_x;
    rates[1] = v_y;
    rates[2] = v_z;
    rates[3] = -z0;
    rates[4] = z1;
    rates[5] = z2;
    rates[6] = -z3;
    rates[7] = v_x2;
    rates[8] = v_y2;
    rates[9] = v_z2;
    rates[10] = -z4;
    rates[11] = z5;
    rates[12] = z6;
    rates[13] = -z7;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 144>& mass) noexcept {
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
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0_17;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0_17;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = k2;
    mass[40] = n0;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0;
    mass[49] = n0;
    mass[50] = n0;
    mass[51] = n0;
    mass[52] = k2;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = n0;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = n0;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = k2;
    mass[66] = n0;
    mass[67] = n0;
    mass[68] = n0;
    mass[69] = n0;
    mass[70] = n0;
    mass[71] = n0;
    mass[72] = n0;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = n0;
    mass[76] = n0;
    mass[77] = n0;
    mass[78] = n0_17;
    mass[79] = n0;
    mass[80] = n0;
    mass[81] = n0;
    mass[82] = n0;
    mass[83] = n0;
    mass[84] = n0;
    mass[85] = n0;
    mass[86] = n0;
    mass[87] = n0;
    mass[88] = n0;
    mass[89] = n0;
    mass[90] = n0;
    mass[91] = n0_17;
    mass[92] = n0;
    mass[93] = n0;
    mass[94] = n0;
    mass[95] = n0;
    mass[96] = n0;
    mass[97] = n0;
    mass[98] = n0;
    mass[99] = n0;
    mass[100] = n0;
    mass[101] = n0;
    mass[102] = n0;
    mass[103] = n0;
    mass[104] = n0_17;
    mass[105] = n0;
    mass[106] = n0;
    mass[107] = n0;
    mass[108] = n0;
    mass[109] = n0;
    mass[110] = n0;
    mass[111] = n0;
    mass[112] = n0;
    mass[113] = n0;
    mass[114] = n0;
    mass[115] = n0;
    mass[116] = n0;
    mass[117] = k2;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n0;
    mass[121] = n0;
    mass[122] = n0;
    mass[123] = n0;
    mass[124] = n0;
    mass[125] = n0;
    mass[126] = n0;
    mass[127] = n0;
    mass[128] = n0;
    mass[129] = n0;
    mass[130] = k2;
    mass[131] = n0;
    mass[132] = n0;
    mass[133] = n0;
    mass[134] = n0;
    mass[135] = n0;
    mass[136] = n0;
    mass[137] = n0;
    mass[138] = n0;
    mass[139] = n0;
    mass[140] = n0;
    mass[141] = n0;
    mass[142] = n0;
    mass[143] = k2;
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
    const Scalar q_turn2_y = state.q.turn2_y;
    const Scalar q_turn2_z = state.q.turn2_z;
    const Scalar q_turn2_x = state.q.turn2_x;
    const Scalar q_turn2_w = state.q.turn2_w;
    const Scalar z0 = n2 * q_turn_y;
    const Scalar z1 = n2 * q_turn_x;
    const Scalar z2 = n2 * q_turn2_y;
    const Scalar z3 = n2 * q_turn2_x;
    const Scalar z4 = q_turn_y * z0;
    const Scalar z5 = q_turn_x * z1;
    const Scalar z6 = q_turn_z * z0;
    const Scalar z7 = q_turn_w * z1;
    const Scalar z8 = q_turn2_y * z2;
    const Scalar z9 = q_turn2_z * z2;
    const Scalar z10 = q_turn2_w * z3;
    const Scalar z11 = q_turn2_x * z3;
    const Scalar z12 = z6 + z7;
    const Scalar z13 = z9 + z10;
    const Scalar z14 = n1 - z4 - z5;
    const Scalar z15 = n1 - z8 - z11;
    const Scalar z16 = n9_81 * z12;
    const Scalar z17 = n9_81 * z13;
    const Scalar z18 = q_turn_z * z1;
    const Scalar z19 = q_turn_w * z0;
    const Scalar z20 = q_turn2_z * z3;
    const Scalar z21 = q_turn2_w * z2;
    const Scalar z22 = n9_81 * z14;
    const Scalar z23 = n9_81 * z15;
    const Scalar z24 = n0_17 * z17;  // force on ball2, y
    const Scalar z25 = n0_17 * z16;  // force on ball, y
    const Scalar z26 = z18 - z19;
    const Scalar z27 = z20 - z21;
    const Scalar z28 = n0_17 * z23;  // force on ball2, z
    const Scalar z29 = n0_17 * z22;  // force on ball, z
    const Scalar z30 = n9_81 * z26;
    const Scalar z31 = n9_81 * z27;
    const Scalar z32 = n0_17 * z30;  // force on ball, x
    const Scalar z33 = n0_17 * z31;  // force on ball2, x
    const Scalar z34 = z12 * z25 + z14 * z29 + z26 * z32;
    const Scalar z35 = z13 * z24 + z15 * z28 + z27 * z33;
    forces.x = n0;
    forces.y = n0;
    forces.z = z34;
    forces.turn_omega_x = n0;
    forces.turn_omega_y = n0;
    forces.turn_omega_z = n0;
    forces.x2 = n0;
    forces.y2 = n0;
    forces.z2 = z35;
    forces.turn2_omega_x = n0;
    forces.turn2_omega_y = n0;
    forces.turn2_omega_z = n0;
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
    const Scalar v_x2 = state.v.x2;
    const Scalar v_y2 = state.v.y2;
    const Scalar q_z2 = state.q.z2;
    const Scalar v_z2 = state.v.z2;
    const Scalar q_turn2_y = state.q.turn2_y;
    const Scalar q_turn2_z = state.q.turn2_z;
    const Scalar q_turn2_x = state.q.turn2_x;
    const Scalar q_turn2_w = state.q.turn2_w;
    const Scalar v_turn2_omega_x = state.v.turn2_omega_x;
    const Scalar v_turn2_omega_y = state.v.turn2_omega_y;
    const Scalar v_turn2_omega_z = state.v.turn2_omega_z;
    const Scalar z0 = n2 * q_turn_y;
    const Scalar z1 = n2 * q_turn_z;
    const Scalar z2 = n2 * q_turn2_y;
    const Scalar z3 = n2 * q_turn2_z;
    const Scalar z4 = n2 * q_turn_x;
    const Scalar z5 = n2 * q_turn2_x;
    const Scalar z6 = q_turn_z * z1;
    const Scalar z7 = q_turn_x * z0;
    const Scalar z8 = q_turn_w * z1;
    const Scalar z9 = q_turn_x * z1;
    const Scalar z10 = q_turn_w * z0;
    const Scalar z11 = q_turn2_z * z3;
    const Scalar z12 = q_turn2_x * z2;
    const Scalar z13 = q_turn2_w * z3;
    const Scalar z14 = q_turn2_x * z3;
    const Scalar z15 = q_turn2_w * z2;
    const Scalar z16 = z7 - z8;
    const Scalar z17 = z7 + z8;
    const Scalar z18 = q_turn_x * z4;
    const Scalar z19 = q_turn_z * z0;
    const Scalar z20 = q_turn_w * z4;
    const Scalar z21 = z9 + z10;
    const Scalar z22 = z12 - z13;
    const Scalar z23 = z12 + z13;
    const Scalar z24 = q_turn2_x * z5;
    const Scalar z25 = q_turn2_z * z2;
    const Scalar z26 = q_turn2_w * z5;
    const Scalar z27 = z14 + z15;
    const Scalar z28 = z9 - z10;
    const Scalar z29 = q_turn_y * z0;
    const Scalar z30 = q_turn2_y * z2;
    const Scalar z31 = n1 - z6 - z18;
    const Scalar z32 = z14 - z15;
    const Scalar z33 = z19 - z20;
    const Scalar z34 = z19 + z20;
    const Scalar z35 = n1 - z11 - z24;
    const Scalar z36 = v_x * z16 + v_y * z31 + v_z * z34;
    const Scalar z37 = z25 - z26;
    const Scalar z38 = n1 - z29 - z6;
    const Scalar z39 = n1 - z29 - z18;
    const Scalar z40 = n1 - z30 - z11;
    const Scalar z41 = z25 + z26;
    const Scalar z42 = n1 - z30 - z24;
    const Scalar z43 = v_y * z17 + v_z * z28 + v_x * z38;
    const Scalar z44 = v_x * z21 + v_y * z33 + v_z * z39;
    const Scalar z45 = v_y2 * z23 + v_z2 * z32 + v_x2 * z40;
    const Scalar z46 = v_x2 * z22 + v_y2 * z35 + v_z2 * z41;
    const Scalar z47 = v_x2 * z27 + v_y2 * z37 + v_z2 * z42;
    result.kinetic = k2 * (v_turn_omega_x * v_turn_omega_x + v_turn_omega_y * v_turn_omega_y + v_turn_omega_z
        * v_turn_omega_z + v_turn2_omega_x * v_turn2_omega_x + v_turn2_omega_y * v_turn2_omega_y + v_turn2_omega_z
        * v_turn2_omega_z) + n0_085 * (z43 * z43 + z36 * z36 + z44 * z44 + z45 * z45 + z46 * z46 + z47 * z47);
    result.force_function = -n1_6677 * (q_z + q_z2);
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Contacts that open and close, in the order cloth, cloth2, balls.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar k3 = traits::constant(0.028575, 0.028575f, "1143/40000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k5 = traits::constant(0.05715, 0.05715f, "1143/20000");
    const Scalar k6 = traits::constant(0.29177582482559333, 0.29177582f, "305943/1048555");
    const Scalar k7 = traits::constant(0.33443167025096443, 0.33443168f, "70134/209711");
    const Scalar k8 = traits::constant(0.8961151298692009, 0.8961151f, "939626/1048555");
    const Scalar k9 = traits::constant(0.6450534306736413, 0.64505345f, "676374/1048555");
    const Scalar k10 = traits::constant(0.6229620763813057, 0.62296206f, "130642/209711");
    const Scalar k11 = traits::constant(0.4425204209602739, 0.4425204f, "464007/1048555");
    const Scalar k12 = traits::constant(0.7062385854819251, 0.70623857f, "148106/209711");
    const Scalar k13 = traits::constant(0.7071588996285364, 0.7071589f, "148299/209711");
    const Scalar k14 = traits::constant(0.03396102255008083, 0.033961024f, "7122/209711");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
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
    const Scalar q_x2 = state.q.x2;
    const Scalar v_x2 = state.v.x2;
    const Scalar q_y2 = state.q.y2;
    const Scalar v_y2 = state.v.y2;
    const Scalar q_z2 = state.q.z2;
    const Scalar v_z2 = state.v.z2;
    const Scalar q_turn2_y = state.q.turn2_y;
    const Scalar q_turn2_z = state.q.turn2_z;
    const Scalar q_turn2_x = state.q.turn2_x;
    const Scalar q_turn2_w = state.q.turn2_w;
    const Scalar v_turn2_omega_x = state.v.turn2_omega_x;
    const Scalar v_turn2_omega_y = state.v.turn2_omega_y;
    const Scalar v_turn2_omega_z = state.v.turn2_omega_z;
    const Scalar z0 = n0_5 * (q_turn_y * v_turn_omega_z - q_turn_z * v_turn_omega_y + q_turn_w * v_turn_omega_x);
    const Scalar z1 = n0_5 * (q_turn_y * v_turn_omega_y + q_turn_z * v_turn_omega_z + q_turn_x * v_turn_omega_x);
    const Scalar z2 = n0_5 * (q_turn_z * v_turn_omega_x - q_turn_x * v_turn_omega_z + q_turn_w * v_turn_omega_y);
    const Scalar z3 = n0_5 * (q_turn_y * v_turn_omega_x - q_turn_x * v_turn_omega_y - q_turn_w * v_turn_omega_z);
    const Scalar z4 = n2 * q_turn_y;
    const Scalar z5 = q_turn_y * z4;
    const Scalar z6 = n2 * q_turn_z;
    const Scalar z7 = q_turn_z * z6;
    const Scalar z8 = n2 * (q_turn_y * z0 + q_turn_x * z2);
    const Scalar z9 = n2 * (q_turn_z * z1 + q_turn_w * z3);
    const Scalar z10 = n4 * q_turn_z * z3;
    const Scalar z11 = n4 * q_turn_x * z0;
    const Scalar z12 = n2 * (q_turn_y * z3 - q_turn_z * z2);
    const Scalar z13 = n2 * (q_turn_x * z1 - q_turn_w * z0);
    const Scalar z14 = z8 - z9;
    const Scalar z15 = z10 - z11;
    const Scalar z16 = z12 - z13;
    const Scalar z17 = q_turn_x * z4;
    const Scalar z18 = n4 * q_turn_y * z2;
    const Scalar z19 = q_turn_w * z6;
    const Scalar z20 = z10 - z18;
    const Scalar z21 = q_turn_x * z6;
    const Scalar z22 = k3 - q_z;
    const Scalar z23 = n2 * q_turn_x;
    const Scalar z24 = n1 - z5 - z7;
    const Scalar z25 = z8 + z9;
    const Scalar z26 = z17 + z19;
    const Scalar z27 = z17 - z19;
    const Scalar z28 = n2 * (q_turn_z * z0 - q_turn_x * z3);
    const Scalar z29 = n2 * (q_turn_y * z1 - q_turn_w * z2);
    const Scalar z30 = z28 - z29;
    const Scalar z31 = q_turn_z * z4;
    const Scalar z32 = q_turn_w * z4;
    const Scalar z33 = q_turn_w * z23;
    const Scalar z34 = q_turn_x * z23;
    const Scalar z35 = n1 - z5 - z34;
    const Scalar z36 = n1 - z7 - z34;
    const Scalar z37 = k3 - q_z2;
    const Scalar z38 = n2 * q_turn2_y;
    const Scalar z39 = n2 * q_turn2_z;
    const Scalar z40 = z31 - z33;
    const Scalar z41 = z31 + z33;
    const Scalar z42 = z21 - z32;
    const Scalar z43 = z21 + z32;
    const Scalar z44 = n0_5 * (q_turn2_y * v_turn2_omega_z - q_turn2_z * v_turn2_omega_y + q_turn2_w * v_turn2_omega_x);
    const Scalar z45 = n0_5 * (q_turn2_z * v_turn2_omega_x - q_turn2_x * v_turn2_omega_z + q_turn2_w * v_turn2_omega_y);
    const Scalar z46 = n2 * (q_turn2_y * z44 + q_turn2_x * z45);
    const Scalar z47 = q_turn2_y * z38;
    const Scalar z48 = n0_5 * (q_turn2_y * v_turn2_omega_y + q_turn2_z * v_turn2_omega_z + q_turn2_x * v_turn2_omega_x);
    const Scalar z49 = n0_5 * (q_turn2_y * v_turn2_omega_x - q_turn2_x * v_turn2_omega_y - q_turn2_w * v_turn2_omega_z);
    const Scalar z50 = q_turn2_x * z38;
    const Scalar z51 = q_turn2_w * z39;
    const Scalar z52 = q_turn2_z * z39;
    const Scalar z53 = q_turn2_x * z39;
    const Scalar z54 = n2 * (q_turn2_z * z48 + q_turn2_w * z49);
    const Scalar z55 = n4 * q_turn2_z * z49;
    const Scalar z56 = n2 * q_turn2_x;
    const Scalar z57 = z50 + z51;
    const Scalar z58 = z50 - z51;
    const Scalar z59 = q_turn2_x * z56;
    const Scalar z60 = q_turn2_w * z56;
    const Scalar z61 = z46 - z54;
    const Scalar z62 = q_turn2_w * z38;
    const Scalar z63 = q_turn2_z * z38;
    const Scalar z64 = n1 - z47 - z52;
    const Scalar z65 = n1 - z52 - z59;
    const Scalar z66 = z46 + z54;
    const Scalar z67 = n1 - z47 - z59;
    const Scalar z68 = n4 * q_turn2_y * z45;
    const Scalar z69 = n4 * q_turn2_x * z44;
    const Scalar z70 = z55 - z68;
    const Scalar z71 = z55 - z69;
    const Scalar z72 = n2 * (q_turn2_y * z49 - q_turn2_z * z45);
    const Scalar z73 = n2 * (q_turn2_x * z48 - q_turn2_w * z44);
    const Scalar z74 = z53 - z62;
    const Scalar z75 = z53 + z62;
    const Scalar z76 = z72 - z73;
    const Scalar z77 = z63 - z60;
    const Scalar z78 = n2 * (q_turn2_z * z44 - q_turn2_x * z49);
    const Scalar z79 = z63 + z60;
    const Scalar z80 = n2 * (q_turn2_y * z48 - q_turn2_w * z45);
    const Scalar z81 = q_x - q_x2;
    const Scalar z82 = q_y - q_y2;
    const Scalar z83 = q_z - q_z2;
    const Scalar z84 = z81 * z81 + z82 * z82 + z83 * z83;
    const Scalar z85 = z78 - z80;
    const Scalar z86 = k3 * z26;
    const Scalar z87 = k3 * z27;
    const Scalar z88 = k3 * z57;
    const Scalar z89 = k3 * z58;
    const Scalar z90 = k3 * z36;
    const Scalar z91 = k3 * z43;
    const Scalar z92 = k3 * z65;
    const Scalar z93 = k3 * z75;
    const Scalar z94 = k3 * z24;
    const Scalar z95 = v_y + v_turn_omega_y * z87 + v_turn_omega_z * z91 + v_turn_omega_x * z94;
    const Scalar z96 = traits::sqrt(z84);
    const Scalar z97 = n2 * z81;
    const Scalar z98 = n2 * z82;
    const Scalar z99 = k3 * z40;
    const Scalar z100 = v_x - v_turn_omega_x * z86 - v_turn_omega_y * z90 - v_turn_omega_z * z99;
    const Scalar z101 = v_x - v_x2;
    const Scalar z102 = v_y - v_y2;
    const Scalar z103 = v_z - v_z2;
    const Scalar z104 = n2 * (z81 * z101 + z82 * z102 + z83 * z103);
    const Scalar z105 = n2 * (z101 * z101 + z102 * z102 + z103 * z103);
    const Scalar z106 = n2 * z83;
    const Scalar z107 = k3 * z64;
    const Scalar z108 = v_y2 + v_turn2_omega_y * z89 + v_turn2_omega_z * z93 + v_turn2_omega_x * z107;
    const Scalar z109 = k3 * z77;
    const Scalar z110 = v_x2 - v_turn2_omega_x * z88 - v_turn2_omega_y * z92 - v_turn2_omega_z * z109;
    const Scalar z111 = n0_5 * z97 / z96;
    const Scalar z112 = n0_5 * z98 / z96;
    const Scalar z113 = n0_5 * z106 / z96;
    const Scalar z114 = k5 - z96;
    const Scalar z115 = z28 + z29;
    const Scalar z116 = n0_5 * z104 / z96;
    const Scalar z117 = z12 + z13;
    const Scalar z118 = z81 / z96;
    const Scalar z119 = z82 / z96;
    const Scalar z120 = z83 / z96;
    const Scalar z121 = k3 * z118;
    const Scalar z122 = k3 * z119;
    const Scalar z123 = k3 * z120;
    const Scalar z124 = z81 - k3 * z118;
    const Scalar z125 = z82 - k3 * z119;
    const Scalar z126 = z83 - k3 * z120;
    const Scalar z127 = k6 + z118;
    const Scalar z128 = k7 - z119;
    const Scalar z129 = k8 + z120;
    const Scalar z130 = k9 * z118 - k10 * z119 - k11 * z120;
    const Scalar z131 = k12 * z118 + k13 * z119 + k14 * z120;
    const Scalar z132 = n0_5 * (z104 * z116 / (z96 * z96) - z105 / z96);
    const Scalar z133 = z11 + z18;
    const Scalar z134 = z78 + z80;
    const Scalar z135 = z83 * z116 / (z96 * z96) - z103 / z96;
    const Scalar z136 = z82 * z116 / (z96 * z96) - z102 / z96;
    const Scalar z137 = z127 * z127 + z128 * z128 + z129 * z129;
    const Scalar z138 = z26 * z123 - z42 * z122;
    const Scalar z139 = z72 + z73;
    const Scalar z140 = z24 * z123 - z42 * z121;
    const Scalar z141 = z24 * z122 - z26 * z121;
    const Scalar z142 = z69 + z68;
    const Scalar z143 = z103 + k3 * z135;
    const Scalar z144 = z102 + k3 * z136;
    const Scalar z145 = k3 * z135;
    const Scalar z146 = k3 * z136;
    const Scalar z147 = z122 * z115 - z14 * z123 + z26 * z145 - z42 * z146;
    const Scalar z148 = z16 * z123 - z122 * z133 + z40 * z145 - z35 * z146;
    const Scalar z149 = z61 * z126 - z125 * z134 + z57 * z143 - z74 * z144;
    const Scalar z150 = z71 * z126 + z125 * z139 + z65 * z143 - z79 * z144;
    const Scalar z151 = z36 * z123 - z41 * z122;
    const Scalar z152 = z27 * z123 - z41 * z121;
    const Scalar z153 = z125 * z142 - z76 * z126 + z77 * z143 - z67 * z144;
    const Scalar z154 = n2 / z137;
    const Scalar z155 = z27 * z122 - z36 * z121;
    const Scalar z156 = z81 * z116 / (z96 * z96) - z101 / z96;
    const Scalar z157 = z40 * z123 - z35 * z122;
    const Scalar z158 = n2 * (z127 * z156 - z128 * z136 + z129 * z135);
    const Scalar z159 = z35 * z121 - z43 * z123;
    const Scalar z160 = z154 * z130;
    const Scalar z161 = z154 * z131;
    const Scalar z162 = z36 * z145 - z41 * z146 - z15 * z123 - z122 * z117;
    const Scalar z163 = v_turn_omega_x * z147 + v_turn_omega_z * z148 - v_turn2_omega_x * z149 - v_turn2_omega_y * z150
        - v_turn2_omega_z * z153 + v_turn_omega_y * z162;
    const Scalar z164 = n2 * z158 / (z137 * z137);
    const Scalar z165 = z40 * z121 - z43 * z122;
    const Scalar z166 = k3 * z156;
    const Scalar z167 = z57 * z126 - z74 * z125;
    const Scalar z168 = z121 * z115 - z20 * z123 + z24 * z145 - z42 * z166;
    const Scalar z169 = z64 * z126 - z74 * z124;
    const Scalar z170 = z27 * z145 - z41 * z166 - z25 * z123 - z121 * z117;
    const Scalar z171 = k11 + z129 * z160;
    const Scalar z172 = k12 - z127 * z161;
    const Scalar z173 = k11 * z135 + k10 * z136 - k9 * z156;
    const Scalar z174 = z154 * z173 + z130 * z164;
    const Scalar z175 = z64 * z125 - z57 * z124;
    const Scalar z176 = z30 * z123 + z121 * z133 + z35 * z166 - z43 * z145;
    const Scalar z177 = z65 * z126 - z79 * z125;
    const Scalar z178 = z101 + k3 * z156;
    const Scalar z179 = z58 * z126 - z79 * z124;
    const Scalar z180 = z70 * z126 - z124 * z134 + z64 * z143 - z74 * z178;
    const Scalar z181 = k9 - z127 * z160;
    const Scalar z182 = k13 + z128 * z161;
    const Scalar z183 = z58 * z125 - z65 * z124;
    const Scalar z184 = z66 * z126 + z124 * z139 + z58 * z143 - z79 * z178;
    const Scalar z185 = z77 * z126 - z67 * z125;
    const Scalar z186 = z67 * z178 - z75 * z143 - z85 * z126 - z124 * z142;
    const Scalar z187 = z67 * z124 - z75 * z126;
    const Scalar z188 = v_turn_omega_x * z168 - v_turn_omega_z * z176 - v_turn2_omega_x * z180 - v_turn2_omega_y * z184
        + v_turn_omega_y * z170 + v_turn2_omega_z * z186;
    const Scalar z189 = k10 - z128 * z160;
    const Scalar z190 = z138 * z181 + z140 * z189 - z141 * z171;
    const Scalar z191 = z151 * z181 + z152 * z189 - z155 * z171;
    const Scalar z192 = z157 * z181 - z159 * z189 + z165 * z171;
    const Scalar z193 = z167 * z181 + z169 * z189 - z175 * z171;
    const Scalar z194 = z177 * z181 + z179 * z189 - z183 * z171;
    const Scalar z195 = k14 - z129 * z161;
    const Scalar z196 = z77 * z124 - z75 * z125;
    const Scalar z197 = z185 * z181 - z187 * z189 + z196 * z171;
    const Scalar z198 = v_x - v_x2 - v_turn_omega_x * z138 - v_turn_omega_y * z151 - v_turn_omega_z * z157
        - v_turn2_omega_x * z167 - v_turn2_omega_y * z177 - v_turn2_omega_z * z185;
    const Scalar z199 = z14 * z121 - z20 * z122 + z24 * z146 - z26 * z166;
    const Scalar z200 = v_y - v_y2 + v_turn_omega_x * z140 + v_turn_omega_y * z152 - v_turn_omega_z * z159
        + v_turn2_omega_x * z169 + v_turn2_omega_y * z179 - v_turn2_omega_z * z187;
    const Scalar z201 = z15 * z121 - z25 * z122 + z27 * z146 - z36 * z166;
    const Scalar z202 = z160 * z136 + z128 * z174;
    const Scalar z203 = v_z - v_z2 - v_turn_omega_x * z141 - v_turn_omega_y * z155 + v_turn_omega_z * z165
        - v_turn2_omega_x * z175 - v_turn2_omega_y * z183 + v_turn2_omega_z * z196;
    const Scalar z204 = z16 * z121 + z30 * z122 + z40 * z166 - z43 * z146;
    const Scalar z205 = z70 * z125 - z61 * z124 + z64 * z144 - z57 * z178;
    const Scalar z206 = z66 * z125 - z71 * z124 + z58 * z144 - z65 * z178;
    const Scalar z207 = z77 * z178 - z75 * z144 - z76 * z124 - z85 * z125;
    const Scalar z208 = v_turn_omega_x * z199 + v_turn_omega_y * z201 - v_turn_omega_z * z204 - v_turn2_omega_x * z205
        - v_turn2_omega_y * z206 + v_turn2_omega_z * z207;
    const Scalar z209 = z138 * z172 - z140 * z182 + z141 * z195;
    const Scalar z210 = z151 * z172 - z152 * z182 + z155 * z195;
    const Scalar z211 = z157 * z172 + z159 * z182 - z165 * z195;
    const Scalar z212 = z167 * z172 - z169 * z182 + z175 * z195;
    const Scalar z213 = z177 * z172 - z179 * z182 + z183 * z195;
    const Scalar z214 = z185 * z172 + z187 * z182 - z196 * z195;
    const Scalar z215 = z198 * z181 - z200 * z189 - z203 * z171;
    const Scalar z216 = z198 * z172 + z200 * z182 + z203 * z195;
    const Scalar z217 = k14 * z135 + k13 * z136 + k12 * z156;
    const Scalar z218 = z154 * z217 - z131 * z164;
    const Scalar z219 = z127 * z174 - z160 * z156;
    const Scalar z220 = z129 * z174 - z160 * z135;
    const Scalar z221 = z171 * z208 - z181 * z163 - z189 * z188 - z200 * z202 + z198 * z219 + z203 * z220;
    const Scalar z222 = z161 * z156 + z127 * z218;
    const Scalar z223 = z161 * z135 + z129 * z218;
    const Scalar z224 = z128 * z218 - z161 * z136;
    const Scalar z225 = z172 * z163 - z182 * z188 + z195 * z208 + z198 * z222 + z203 * z223 - z200 * z224;
    result.gap[0] = -z22;
    result.rate[0] = v_z;
    result.drift[0] = n0;
    result.rate[1] = z100;
    result.drift[1] = n0;
    result.rate[2] = z95;
    result.drift[2] = n0;
    result.gap[1] = -z37;
    result.rate[3] = v_z2;
    result.drift[3] = n0;
    result.rate[4] = z110;
    result.drift[4] = n0;
    result.rate[5] = z108;
    result.drift[5] = n0;
    result.gap[2] = -z114;
    result.rate[6] = z116;
    result.drift[6] = -z132;
    result.rate[7] = z215;
    result.drift[7] = -z221;
    result.rate[8] = z216;
    result.drift[8] = z225;
    result.jacobian[0] = n0;
    result.jacobian[1] = n1;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = n0;
    result.jacobian[5] = n0;
    result.jacobian[6] = z111;
    result.jacobian[7] = z181;
    result.jacobian[8] = z172;
    result.jacobian[9] = n0;
    result.jacobian[10] = n0;
    result.jacobian[11] = n1;
    result.jacobian[12] = n0;
    result.jacobian[13] = n0;
    result.jacobian[14] = n0;
    result.jacobian[15] = z112;
    result.jacobian[16] = -z189;
    result.jacobian[17] = z182;
    result.jacobian[18] = n1;
    result.jacobian[19] = n0;
    result.jacobian[20] = n0;
    result.jacobian[21] = n0;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = z113;
    result.jacobian[25] = -z171;
    result.jacobian[26] = z195;
    result.jacobian[27] = n0;
    result.jacobian[28] = -z86;
    result.jacobian[29] = z94;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = -z190;
    result.jacobian[35] = -z209;
    result.jacobian[36] = n0;
    result.jacobian[37] = -z90;
    result.jacobian[38] = z87;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = -z191;
    result.jacobian[44] = -z210;
    result.jacobian[45] = n0;
    result.jacobian[46] = -z99;
    result.jacobian[47] = z91;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = -z192;
    result.jacobian[53] = -z211;
    result.jacobian[54] = n0;
    result.jacobian[55] = n0;
    result.jacobian[56] = n0;
    result.jacobian[57] = n0;
    result.jacobian[58] = n1;
    result.jacobian[59] = n0;
    result.jacobian[60] = -z111;
    result.jacobian[61] = -z181;
    result.jacobian[62] = -z172;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n0;
    result.jacobian[67] = n0;
    result.jacobian[68] = n1;
    result.jacobian[69] = -z112;
    result.jacobian[70] = z189;
    result.jacobian[71] = -z182;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n1;
    result.jacobian[76] = n0;
    result.jacobian[77] = n0;
    result.jacobian[78] = -z113;
    result.jacobian[79] = z171;
    result.jacobian[80] = -z195;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = n0;
    result.jacobian[85] = -z88;
    result.jacobian[86] = z107;
    result.jacobian[87] = n0;
    result.jacobian[88] = -z193;
    result.jacobian[89] = -z212;
    result.jacobian[90] = n0;
    result.jacobian[91] = n0;
    result.jacobian[92] = n0;
    result.jacobian[93] = n0;
    result.jacobian[94] = -z92;
    result.jacobian[95] = z89;
    result.jacobian[96] = n0;
    result.jacobian[97] = -z194;
    result.jacobian[98] = -z213;
    result.jacobian[99] = n0;
    result.jacobian[100] = n0;
    result.jacobian[101] = n0;
    result.jacobian[102] = n0;
    result.jacobian[103] = -z109;
    result.jacobian[104] = z93;
    result.jacobian[105] = n0;
    result.jacobian[106] = -z197;
    result.jacobian[107] = -z214;
  }

  /// What the surfaces of each contact are made of, in the order cloth, cloth2, balls:
  /// |T| <= f N + b while it slides, f_s and b_s while it sticks.
  TORSOR_DEVICE static void contact_coefficients(const Precomputed& precomputed, const State&,
      ContactCoefficients& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_f_between = precomputed.parameters.f_between;
    const Scalar p_e = precomputed.parameters.e;
    result.friction[0] = p_f;
    result.static_friction[0] = p_f;
    result.restitution[0] = n0;
    result.bound[0] = n0;
    result.static_bound[0] = n0;
    result.friction[1] = p_f;
    result.static_friction[1] = p_f;
    result.restitution[1] = n0;
    result.bound[1] = n0;
    result.static_bound[1] = n0;
    result.friction[2] = p_f_between;
    result.static_friction[2] = p_f_between;
    result.restitution[2] = p_e;
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
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 14>&>(coordinate_rates));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 144>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[4], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[5], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace billiard_two_balls
