// SPDX-License-Identifier: MIT-0
// four_blade_rotor: Rotor of four blades set at a pitch, turning about its centre
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation
// Parameters set at run time: alpha
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute               11                4          2             0                  1       0     19       -
//   kinematics               62              101          0             0                  0       0    163     193
//   mass_matrix               0                0          0             0                  0       0      0      17
//   bias                     16               34          0             0                  0       0     50      58
//   inverse_dynamics         18               37          0             0                  0       0     55      78
//   forward_dynamics         16               36          0             0                  0       0     52      77
//   energy                   17               23          0             0                  0       0     40      55
//   first_integrals          17               24          0             0                  0       0     41      62
//   linearisation            34               72          0             0                  0       0    106     131
//
// Not computed because this mechanism does not need it:
//   kinematics: of 72 results 21 repeat another up to sign
//   mass_matrix: of 9 results 6 vanish identically
//   bias: of 3 results 1 vanish identically
//   forward_dynamics: of 3 results 1 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 66 results 43 vanish identically, 3 repeat another up to sign
//
// To write this file again:
//   four_blade_rotor_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output four_blade_rotor.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace four_blade_rotor {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 4> coordinates{{{"e_w", "1"}, {"e_x", "1"}, {"e_y", "1"},
      {"e_z", "1"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"e_omega_x", "rad/s"}, {"e_omega_y",
      "rad/s"}, {"e_omega_z", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"alpha", "rad"}}};
  static constexpr std::array<torsor::ResultDescription, 32> results{{{"rates", "", 4, 1, 1, "rad/s"}, {"result",
      "blade_1_position", 3, 1, 1, "m"}, {"result", "blade_1_rotation", 3, 3, 2, "1"}, {"result", "blade_1_velocity", 3,
      1, 1, "m/s"}, {"result", "blade_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "blade_2_position", 3, 1, 1,
      "m"}, {"result", "blade_2_rotation", 3, 3, 2, "1"}, {"result", "blade_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "blade_2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "blade_3_position", 3, 1, 1, "m"}, {"result",
      "blade_3_rotation", 3, 3, 2, "1"}, {"result", "blade_3_velocity", 3, 1, 1, "m/s"}, {"result",
      "blade_3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "blade_4_position", 3, 1, 1, "m"}, {"result",
      "blade_4_rotation", 3, 3, 2, "1"}, {"result", "blade_4_velocity", 3, 1, 1, "m/s"}, {"result",
      "blade_4_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 3, 3, 2, "kg m^2"}, {"forces", "", 3, 1, 1, "N m"},
      {"forces", "", 3, 1, 1, "N m"}, {"accelerations", "", 3, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1, ""},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result", "momentum_e_omega_z", 1, 1, 0, "N m s"}, {"result", "M", 3,
      3, 2, "kg m^2"}, {"result", "C", 3, 3, 2, "N m s"}, {"result", "K", 3, 3, 2, ""}, {"result", "F", 3, 1, 1, "N m"},
      {"result", "A", 6, 6, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"coordinate_rates", false, false, false, false,
      results.data() + 0, 1}, {"kinematics", false, false, false, false, results.data() + 1, 16}, {"mass_matrix", false,
      false, false, false, results.data() + 17, 1}, {"bias", false, false, false, false, results.data() + 18, 1},
      {"inverse_dynamics", true, true, false, false, results.data() + 19, 1}, {"forward_dynamics", false, false, true,
      true, results.data() + 20, 2}, {"energy", false, false, true, false, results.data() + 22, 3}, {"first_integrals",
      false, false, false, false, results.data() + 25, 2}, {"linearisation", true, true, true, true, results.data()
      + 27, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::four_blade_rotor::Description;

  static constexpr const char* name = "four_blade_rotor";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x9d5ad81d7409a20dULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 2;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 1;
  static constexpr int quaternions[quaternion_count] = {0};

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar alpha;  ///< parameter [rad]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::alpha};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar e_w;  ///< component of a unit quaternion [1]
    Scalar e_x;  ///< component of a unit quaternion [1]
    Scalar e_y;  ///< component of a unit quaternion [1]
    Scalar e_z;  ///< component of a unit quaternion [1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::e_w, &Coordinates::e_x, &Coordinates::e_y,
          &Coordinates::e_z};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar e_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar e_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar e_omega_z;  ///< angular velocity, in moving axes [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::e_omega_x, &Velocities::e_omega_y,
          &Velocities::e_omega_z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar e_omega_x;  ///< its rate [rad/s^2]
    Scalar e_omega_y;  ///< its rate [rad/s^2]
    Scalar e_omega_z;  ///< its rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::e_omega_x, &Accelerations::e_omega_y,
          &Accelerations::e_omega_z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar e_omega_x;  ///< works with e_omega_x [N m]
    Scalar e_omega_y;  ///< works with e_omega_y [N m]
    Scalar e_omega_z;  ///< works with e_omega_z [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::e_omega_x, &GeneralizedForces::e_omega_y,
          &GeneralizedForces::e_omega_z};
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
    Scalar m_7b59dd2d;
    Scalar m_e1bdef79;
    Scalar m_e4a9a61c;
    Scalar m_d588f5b1;
    Scalar m_b7112841;
    Scalar m_f22ad7bb;
    Scalar m_454349f9;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    parameters.alpha = n0_2;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar n665_4 = traits::constant(665.4, 665.4f, "3327/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_alpha = parameters.alpha;
    Scalar s_alpha, c_alpha;
    traits::sincos(p_alpha, s_alpha, c_alpha);
    const Scalar z0 = n0_4 * s_alpha;
    const Scalar z1 = n0_4 * c_alpha;
    const Scalar z2 = c_alpha * z1;
    const Scalar z3 = s_alpha * z0;
    const Scalar z4 = n665 + z3;
    const Scalar z5 = n1330 + z2;
    const Scalar z6 = n0_4 + z4;
    const Scalar z7 = n665_4 + z3;
    const Scalar z8 = z2 + z5;
    const Scalar z9 = z3 + z6;
    const Scalar z10 = n0_4 + z7;
    const Scalar z11 = z2 + z8;
    const Scalar z12 = n0_4 + z9;
    const Scalar z13 = z3 + z10;
    const Scalar z14 = z2 + z11;
    const Scalar z15 = n1 / z13;
    const Scalar z16 = n1 / z12;
    precomputed.m_7b59dd2d = s_alpha;
    precomputed.m_e1bdef79 = c_alpha;
    precomputed.m_e4a9a61c = z12;
    precomputed.m_d588f5b1 = z13;
    precomputed.m_b7112841 = z14;
    precomputed.m_f22ad7bb = z15;
    precomputed.m_454349f9 = z16;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    state.time = n0;
    state.q.e_w = n1;
    state.q.e_x = n0;
    state.q.e_y = n0;
    state.q.e_z = n0;
    state.v.e_omega_x = n0_4;
    state.v.e_omega_y = n0_3;
    state.v.e_omega_z = n5;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> blade_1_position;  ///< centre of mass of blade_1 [m]
    std::array<Scalar, 9> blade_1_rotation;  ///< from the axes of blade_1 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_1_velocity;  ///< velocity of the centre of mass of blade_1 [m/s]
    std::array<Scalar, 3> blade_1_angular_velocity;  ///< angular velocity of blade_1 [rad/s]
    std::array<Scalar, 3> blade_2_position;  ///< centre of mass of blade_2 [m]
    std::array<Scalar, 9> blade_2_rotation;  ///< from the axes of blade_2 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_2_velocity;  ///< velocity of the centre of mass of blade_2 [m/s]
    std::array<Scalar, 3> blade_2_angular_velocity;  ///< angular velocity of blade_2 [rad/s]
    std::array<Scalar, 3> blade_3_position;  ///< centre of mass of blade_3 [m]
    std::array<Scalar, 9> blade_3_rotation;  ///< from the axes of blade_3 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_3_velocity;  ///< velocity of the centre of mass of blade_3 [m/s]
    std::array<Scalar, 3> blade_3_angular_velocity;  ///< angular velocity of blade_3 [rad/s]
    std::array<Scalar, 3> blade_4_position;  ///< centre of mass of blade_4 [m]
    std::array<Scalar, 9> blade_4_rotation;  ///< from the axes of blade_4 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_4_velocity;  ///< velocity of the centre of mass of blade_4 [m/s]
    std::array<Scalar, 3> blade_4_angular_velocity;  ///< angular velocity of blade_4 [rad/s]
  };

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

  /// Quantities that every motion conserves.
  struct FirstIntegrals {
    Scalar energy;  ///< T - U [J]
    Scalar momentum_e_omega_z;  ///< dT/de_omega_z, constant in the moving axes [N m s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy, &FirstIntegrals::momentum_e_omega_z};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 36> A;  ///< state matrix of x = (e, w): x' = A x + B du (6 x 6)
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 4>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar q_e_y = state.q.e_y;
    const Scalar q_e_z = state.q.e_z;
    const Scalar q_e_x = state.q.e_x;
    const Scalar q_e_w = state.q.e_w;
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar z0 = n0_5 * (q_e_y * v_e_omega_y + q_e_z * v_e_omega_z + q_e_x * v_e_omega_x);
    const Scalar z1 = n0_5 * (q_e_y * v_e_omega_z - q_e_z * v_e_omega_y + q_e_w * v_e_omega_x);
    const Scalar z2 = n0_5 * (q_e_z * v_e_omega_x - q_e_x * v_e_omega_z + q_e_w * v_e_omega_y);
    const Scalar z3 = n0_5 * (q_e_y * v_e_omega_x - q_e_x * v_e_omega_y - q_e_w * v_e_omega_z);
    rates[0] = -z0;
    rates[1] = z1;
    rates[2] = z2;
    rates[3] = -z3;
  }

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar q_e_y = state.q.e_y;
    const Scalar q_e_z = state.q.e_z;
    const Scalar q_e_x = state.q.e_x;
    const Scalar q_e_w = state.q.e_w;
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar z0 = n2 * q_e_y;
    const Scalar z1 = n2 * q_e_z;
    const Scalar z2 = n2 * q_e_x;
    const Scalar z3 = v_e_omega_z * c_alpha;
    const Scalar z4 = v_e_omega_z * s_alpha;
    const Scalar z5 = q_e_y * z0;
    const Scalar z6 = q_e_z * z1;
    const Scalar z7 = q_e_z * z0;
    const Scalar z8 = q_e_w * z2;
    const Scalar z9 = q_e_x * z1;
    const Scalar z10 = q_e_w * z0;
    const Scalar z11 = q_e_x * z0;
    const Scalar z12 = q_e_w * z1;
    const Scalar z13 = q_e_x * z2;
    const Scalar z14 = z7 - z8;
    const Scalar z15 = z7 + z8;
    const Scalar z16 = z9 - z10;
    const Scalar z17 = z9 + z10;
    const Scalar z18 = n1 - z5 - z6;
    const Scalar z19 = z11 - z12;
    const Scalar z20 = z11 + z12;
    const Scalar z21 = n1 - z6 - z13;
    const Scalar z22 = n1 - z5 - z13;
    const Scalar z23 = s_alpha * z17;
    const Scalar z24 = s_alpha * z14;
    const Scalar z25 = c_alpha * z15;
    const Scalar z26 = c_alpha * z16;
    const Scalar z27 = v_e_omega_y * s_alpha - z3;
    const Scalar z28 = v_e_omega_x * s_alpha + z3;
    const Scalar z29 = v_e_omega_y * s_alpha + z3;
    const Scalar z30 = v_e_omega_x * s_alpha - z3;
    const Scalar z31 = v_e_omega_x * z18;  // angular velocity of e_omega_x, x
    const Scalar z32 = v_e_omega_x * z20;  // angular velocity of e_omega_x, y
    const Scalar z33 = n3 * z27;
    const Scalar z34 = v_e_omega_y * z19 + z31;  // angular velocity of e_omega_y, x
    const Scalar z35 = v_e_omega_y * z21 + z32;  // angular velocity of e_omega_y, y
    const Scalar z36 = n3 * z18;
    const Scalar z37 = n3 * z20;
    const Scalar z38 = v_e_omega_z * z17 + z34;  // angular velocity of rotor, x
    const Scalar z39 = v_e_omega_x * z16;  // angular velocity of e_omega_x, z
    const Scalar z40 = v_e_omega_z * z14 + z35;  // angular velocity of rotor, y
    const Scalar z41 = c_alpha * z17;
    const Scalar z42 = c_alpha * z14;
    const Scalar z43 = s_alpha * z15;
    const Scalar z44 = n3 * z28;
    const Scalar z45 = v_e_omega_y * z15 + z39;  // angular velocity of e_omega_y, z
    const Scalar z46 = v_e_omega_z * z22 + z45;  // angular velocity of rotor, z
    const Scalar z47 = s_alpha * z16;
    const Scalar z48 = n3 * z16;
    const Scalar z49 = c_alpha * z19 + z23;
    const Scalar z50 = n3 * z15;
    const Scalar z51 = c_alpha * z21 + z24;
    const Scalar z52 = n3 * z29;
    const Scalar z53 = n3 * z19;
    const Scalar z54 = n3 * z21;
    const Scalar z55 = s_alpha * z22 + z25;
    const Scalar z56 = s_alpha * z22 - z25;
    const Scalar z57 = v_e_omega_y * c_alpha + z4;
    const Scalar z58 = n3 * z57;
    const Scalar z59 = c_alpha * z18 - z23;
    const Scalar z60 = c_alpha * z20 - z24;
    const Scalar z61 = s_alpha * z22 - z26;
    const Scalar z62 = s_alpha * z22 + z26;
    const Scalar z63 = v_e_omega_x * c_alpha - z4;
    const Scalar z64 = n3 * z63;
    const Scalar z65 = c_alpha * z19 - z23;
    const Scalar z66 = c_alpha * z18 + z23;
    const Scalar z67 = c_alpha * z21 - z24;
    const Scalar z68 = c_alpha * z20 + z24;
    const Scalar z69 = v_e_omega_y * c_alpha - z4;
    const Scalar z70 = v_e_omega_x * c_alpha + z4;
    const Scalar z71 = n3 * z69;
    const Scalar z72 = s_alpha * z19 - z41;
    const Scalar z73 = z49 * z33 - z72 * z58;
    const Scalar z74 = n3 * z30;
    const Scalar z75 = s_alpha * z19 + z41;
    const Scalar z76 = z65 * z52 - z75 * z71;
    const Scalar z77 = n3 * z70;
    const Scalar z78 = s_alpha * z21 - z42;
    const Scalar z79 = z51 * z33 - z78 * z58;
    const Scalar z80 = s_alpha * z21 + z42;
    const Scalar z81 = z67 * z52 - z80 * z71;
    const Scalar z82 = c_alpha * z22 - z43;
    const Scalar z83 = z55 * z33 + z82 * z58;
    const Scalar z84 = c_alpha * z22 + z43;
    const Scalar z85 = z56 * z52 + z84 * z71;
    const Scalar z86 = s_alpha * z18 + z41;
    const Scalar z87 = s_alpha * z20 + z42;
    const Scalar z88 = c_alpha * z22 + z47;
    const Scalar z89 = s_alpha * z18 - z41;
    const Scalar z90 = s_alpha * z20 - z42;
    const Scalar z91 = c_alpha * z22 - z47;
    const Scalar z92 = z59 * z44 - z86 * z64;
    const Scalar z93 = z60 * z44 - z87 * z64;
    const Scalar z94 = z61 * z44 + z88 * z64;
    const Scalar z95 = z66 * z74 - z89 * z77;
    const Scalar z96 = z68 * z74 - z90 * z77;
    const Scalar z97 = z62 * z74 + z91 * z77;
    result.blade_1_position[0] = z36;
    result.blade_1_position[1] = z37;
    result.blade_1_position[2] = z48;
    result.blade_1_rotation[0] = z18;
    result.blade_1_rotation[1] = z20;
    result.blade_1_rotation[2] = z16;
    result.blade_1_rotation[3] = z49;
    result.blade_1_rotation[4] = z51;
    result.blade_1_rotation[5] = z55;
    result.blade_1_rotation[6] = -z72;
    result.blade_1_rotation[7] = -z78;
    result.blade_1_rotation[8] = z82;
    result.blade_1_velocity[0] = -z73;
    result.blade_1_velocity[1] = -z79;
    result.blade_1_velocity[2] = -z83;
    result.blade_1_angular_velocity[0] = z38;
    result.blade_1_angular_velocity[1] = z40;
    result.blade_1_angular_velocity[2] = z46;
    result.blade_2_position[0] = z53;
    result.blade_2_position[1] = z54;
    result.blade_2_position[2] = z50;
    result.blade_2_rotation[0] = z19;
    result.blade_2_rotation[1] = z21;
    result.blade_2_rotation[2] = z15;
    result.blade_2_rotation[3] = -z59;
    result.blade_2_rotation[4] = -z60;
    result.blade_2_rotation[5] = z61;
    result.blade_2_rotation[6] = z86;
    result.blade_2_rotation[7] = z87;
    result.blade_2_rotation[8] = z88;
    result.blade_2_velocity[0] = -z92;
    result.blade_2_velocity[1] = -z93;
    result.blade_2_velocity[2] = z94;
    result.blade_2_angular_velocity[0] = z38;
    result.blade_2_angular_velocity[1] = z40;
    result.blade_2_angular_velocity[2] = z46;
    result.blade_3_position[0] = -z36;
    result.blade_3_position[1] = -z37;
    result.blade_3_position[2] = -z48;
    result.blade_3_rotation[0] = -z18;
    result.blade_3_rotation[1] = -z20;
    result.blade_3_rotation[2] = -z16;
    result.blade_3_rotation[3] = -z65;
    result.blade_3_rotation[4] = -z67;
    result.blade_3_rotation[5] = z56;
    result.blade_3_rotation[6] = z75;
    result.blade_3_rotation[7] = z80;
    result.blade_3_rotation[8] = z84;
    result.blade_3_velocity[0] = -z76;
    result.blade_3_velocity[1] = -z81;
    result.blade_3_velocity[2] = z85;
    result.blade_3_angular_velocity[0] = z38;
    result.blade_3_angular_velocity[1] = z40;
    result.blade_3_angular_velocity[2] = z46;
    result.blade_4_position[0] = -z53;
    result.blade_4_position[1] = -z54;
    result.blade_4_position[2] = -z50;
    result.blade_4_rotation[0] = -z19;
    result.blade_4_rotation[1] = -z21;
    result.blade_4_rotation[2] = -z15;
    result.blade_4_rotation[3] = z66;
    result.blade_4_rotation[4] = z68;
    result.blade_4_rotation[5] = z62;
    result.blade_4_rotation[6] = -z89;
    result.blade_4_rotation[7] = -z90;
    result.blade_4_rotation[8] = z91;
    result.blade_4_velocity[0] = -z95;
    result.blade_4_velocity[1] = -z96;
    result.blade_4_velocity[2] = -z97;
    result.blade_4_angular_velocity[0] = z38;
    result.blade_4_angular_velocity[1] = z40;
    result.blade_4_angular_velocity[2] = z46;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State&,
      std::array<Scalar, 9>& mass) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar m0 = precomputed.m_e4a9a61c;
    const Scalar m1 = precomputed.m_d588f5b1;
    const Scalar m2 = precomputed.m_b7112841;
    mass[0] = m0;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = m1;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = m2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * v_e_omega_z;
    const Scalar z3 = v_e_omega_x * v_e_omega_z;
    const Scalar z4 = v_e_omega_y * c_alpha + z0;
    const Scalar z5 = v_e_omega_y * s_alpha - z1;
    const Scalar z6 = v_e_omega_x * c_alpha + z0;
    const Scalar z7 = v_e_omega_x * s_alpha - z1;
    const Scalar z8 = v_e_omega_x * c_alpha - z0;
    const Scalar z9 = z6 * z7;
    const Scalar z10 = z4 * z5;
    const Scalar z11 = v_e_omega_x * s_alpha + z1;
    const Scalar z12 = v_e_omega_y * c_alpha - z0;
    const Scalar z13 = v_e_omega_y * s_alpha + z1;
    const Scalar z14 = n0_4 * z9;  // moment on blade_4, x
    const Scalar z15 = n0_4 * z10;  // moment on blade_1, x
    const Scalar z16 = v_e_omega_y * z6;
    const Scalar z17 = z12 * z13;
    const Scalar z18 = v_e_omega_x * z12;
    const Scalar z19 = z8 * z11;
    const Scalar z20 = n0_4 * z16;  // moment on blade_4, z
    const Scalar z21 = n0_4 * z17;  // moment on blade_3, x
    const Scalar z22 = n0_4 * z18;  // moment on blade_3, z
    const Scalar z23 = v_e_omega_y * z8;
    const Scalar z24 = n0_4 * z19;  // moment on blade_2, x
    const Scalar z25 = v_e_omega_x * z4;
    const Scalar z26 = s_alpha * z20;
    const Scalar z27 = s_alpha * z22;
    const Scalar z28 = n0_4 * z23;  // moment on blade_2, z
    const Scalar z29 = n0_4 * z25;  // moment on blade_1, z
    const Scalar z30 = s_alpha * z28;
    const Scalar z31 = s_alpha * z29;
    const Scalar z32 = z15 - n665 * z2 - z21 + z26 - z30;  // moment on rotor, x
    const Scalar z33 = z14 - n665 * z3 - z24 - z27 + z31;  // moment on rotor, y
    forces.e_omega_x = -z32;
    forces.e_omega_y = z33;
    forces.e_omega_z = n0;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar a_e_omega_x = accelerations.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar a_e_omega_y = accelerations.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar a_e_omega_z = accelerations.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_e4a9a61c;
    const Scalar m3 = precomputed.m_d588f5b1;
    const Scalar m4 = precomputed.m_b7112841;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * v_e_omega_z;
    const Scalar z3 = v_e_omega_x * v_e_omega_z;
    const Scalar z4 = a_e_omega_z * m4;
    const Scalar z5 = v_e_omega_y * c_alpha + z0;
    const Scalar z6 = v_e_omega_y * c_alpha - z0;
    const Scalar z7 = v_e_omega_y * s_alpha + z1;
    const Scalar z8 = v_e_omega_x * c_alpha + z0;
    const Scalar z9 = v_e_omega_x * s_alpha - z1;
    const Scalar z10 = z8 * z9;
    const Scalar z11 = z6 * z7;
    const Scalar z12 = v_e_omega_y * s_alpha - z1;
    const Scalar z13 = v_e_omega_x * z6;
    const Scalar z14 = n0_4 * z11;  // moment on blade_3, x
    const Scalar z15 = n0_4 * z10;  // moment on blade_4, x
    const Scalar z16 = v_e_omega_x * c_alpha - z0;
    const Scalar z17 = v_e_omega_x * s_alpha + z1;
    const Scalar z18 = v_e_omega_y * z8;
    const Scalar z19 = z5 * z12;
    const Scalar z20 = n0_4 * z13;  // moment on blade_3, z
    const Scalar z21 = z16 * z17;
    const Scalar z22 = v_e_omega_y * z16;
    const Scalar z23 = v_e_omega_x * z5;
    const Scalar z24 = n0_4 * z18;  // moment on blade_4, z
    const Scalar z25 = s_alpha * z20;
    const Scalar z26 = n0_4 * z19;  // moment on blade_1, x
    const Scalar z27 = s_alpha * z24;
    const Scalar z28 = n0_4 * z21;  // moment on blade_2, x
    const Scalar z29 = n0_4 * z22;  // moment on blade_2, z
    const Scalar z30 = n0_4 * z23;  // moment on blade_1, z
    const Scalar z31 = s_alpha * z29;
    const Scalar z32 = s_alpha * z30;
    const Scalar z33 = n665 * z2 + z14 - z26 - z27 + z31;  // moment on rotor, x
    const Scalar z34 = n665 * z3 - z15 + z25 + z28 - z32;  // moment on rotor, y
    const Scalar z35 = a_e_omega_x * m2 + z33;
    const Scalar z36 = a_e_omega_y * m3 - z34;
    forces.e_omega_x = z35;
    forces.e_omega_y = z36;
    forces.e_omega_z = z4;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_e4a9a61c;
    const Scalar m3 = precomputed.m_d588f5b1;
    const Scalar m4 = precomputed.m_b7112841;
    const Scalar m5 = precomputed.m_f22ad7bb;
    const Scalar m6 = precomputed.m_454349f9;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * v_e_omega_z;
    const Scalar z3 = v_e_omega_x * v_e_omega_z;
    const Scalar z4 = v_e_omega_y * c_alpha + z0;
    const Scalar z5 = v_e_omega_y * s_alpha - z1;
    const Scalar z6 = v_e_omega_x * c_alpha + z0;
    const Scalar z7 = v_e_omega_x * s_alpha - z1;
    const Scalar z8 = v_e_omega_x * c_alpha - z0;
    const Scalar z9 = z6 * z7;
    const Scalar z10 = z4 * z5;
    const Scalar z11 = v_e_omega_x * s_alpha + z1;
    const Scalar z12 = v_e_omega_y * c_alpha - z0;
    const Scalar z13 = v_e_omega_y * s_alpha + z1;
    const Scalar z14 = n0_4 * z9;
    const Scalar z15 = n0_4 * z10;
    const Scalar z16 = v_e_omega_y * z6;
    const Scalar z17 = z12 * z13;
    const Scalar z18 = v_e_omega_x * z12;
    const Scalar z19 = z8 * z11;
    const Scalar z20 = n0_4 * z16;
    const Scalar z21 = n0_4 * z17;
    const Scalar z22 = n0_4 * z18;
    const Scalar z23 = v_e_omega_y * z8;
    const Scalar z24 = n0_4 * z19;
    const Scalar z25 = v_e_omega_x * z4;
    const Scalar z26 = s_alpha * z20;
    const Scalar z27 = s_alpha * z22;
    const Scalar z28 = n0_4 * z23;
    const Scalar z29 = n0_4 * z25;
    const Scalar z30 = s_alpha * z28;
    const Scalar z31 = s_alpha * z29;
    const Scalar z32 = z15 - n665 * z2 - z21 + z26 - z30;
    const Scalar z33 = z14 - n665 * z3 - z24 - z27 + z31;
    const Scalar z34 = m5 * z33;
    const Scalar z35 = m6 * z32;
    accelerations.e_omega_x = z35;
    accelerations.e_omega_y = -z34;
    accelerations.e_omega_z = n0;
    if (!(traits::regular(m4, m4) && traits::regular(m3, m3) && traits::regular(m2,
        m2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.e_omega_x * accelerations.e_omega_y;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      Accelerations& accelerations) noexcept {
    Multipliers multipliers{};
    return Mechanism::forward_dynamics(precomputed, state, Inputs(), accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n166_25 = traits::constant(166.25, 166.25f, "665/4");
    const Scalar n166_45 = traits::constant(166.45, 166.45f, "3329/20");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * c_alpha + z0;
    const Scalar z3 = v_e_omega_y * s_alpha - z1;
    const Scalar z4 = v_e_omega_x * c_alpha - z0;
    const Scalar z5 = v_e_omega_x * s_alpha + z1;
    const Scalar z6 = v_e_omega_y * c_alpha - z0;
    const Scalar z7 = v_e_omega_y * s_alpha + z1;
    const Scalar z8 = v_e_omega_x * c_alpha + z0;
    const Scalar z9 = v_e_omega_x * s_alpha - z1;
    result.kinetic = n0_4 * (v_e_omega_x * v_e_omega_x + v_e_omega_y * v_e_omega_y) + n166_25 * (z2 * z2 + z4 * z4 + z6
        * z6 + z8 * z8) + n166_45 * (z3 * z3 + z5 * z5 + z7 * z7 + z9 * z9);
    result.force_function = n0;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n166_25 = traits::constant(166.25, 166.25f, "665/4");
    const Scalar n166_45 = traits::constant(166.45, 166.45f, "3329/20");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_b7112841;
    const Scalar z0 = v_e_omega_z * s_alpha;
    const Scalar z1 = v_e_omega_z * c_alpha;
    const Scalar z2 = v_e_omega_y * c_alpha + z0;
    const Scalar z3 = v_e_omega_y * s_alpha - z1;
    const Scalar z4 = v_e_omega_x * c_alpha - z0;
    const Scalar z5 = v_e_omega_x * s_alpha + z1;
    const Scalar z6 = v_e_omega_y * c_alpha - z0;
    const Scalar z7 = v_e_omega_y * s_alpha + z1;
    const Scalar z8 = v_e_omega_x * c_alpha + z0;
    const Scalar z9 = v_e_omega_x * s_alpha - z1;
    result.energy = n0_4 * (v_e_omega_x * v_e_omega_x + v_e_omega_y * v_e_omega_y) + n166_25 * (z2 * z2 + z4 * z4 + z6
        * z6 + z8 * z8) + n166_45 * (z3 * z3 + z5 * z5 + z7 * z7 + z9 * z9);
    result.momentum_e_omega_z = v_e_omega_z * m2;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  /// Along an attitude e is a turn in its moving axes, e' stands for w, the deviation of the angular velocity
  /// omega, and w = de/dt + omega x e: A says so.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar a_e_omega_x = accelerations.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar a_e_omega_y = accelerations.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar a_e_omega_z = accelerations.e_omega_z;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_e4a9a61c;
    const Scalar m3 = precomputed.m_d588f5b1;
    const Scalar m4 = precomputed.m_b7112841;
    const Scalar m5 = precomputed.m_f22ad7bb;
    const Scalar m6 = precomputed.m_454349f9;
    const Scalar z0 = v_e_omega_z * c_alpha;
    const Scalar z1 = v_e_omega_z * s_alpha;
    const Scalar z2 = n2 * v_e_omega_y;
    const Scalar z3 = n2 * v_e_omega_x;
    const Scalar z4 = v_e_omega_y * v_e_omega_z;
    const Scalar z5 = v_e_omega_x * v_e_omega_z;
    const Scalar z6 = v_e_omega_y * s_alpha + z0;
    const Scalar z7 = v_e_omega_x * s_alpha - z0;
    const Scalar z8 = v_e_omega_y * s_alpha - z0;
    const Scalar z9 = v_e_omega_x * s_alpha + z0;
    const Scalar z10 = v_e_omega_y * c_alpha - z1;
    const Scalar z11 = v_e_omega_x * c_alpha + z1;
    const Scalar z12 = n0_4 * z2;
    const Scalar z13 = n0_4 * z3;
    const Scalar z14 = n2 * z7;
    const Scalar z15 = n2 * z6;
    const Scalar z16 = z11 * z7;
    const Scalar z17 = z10 * z6;
    const Scalar z18 = c_alpha * z12;
    const Scalar z19 = c_alpha * z13;
    const Scalar z20 = n2 * z9;
    const Scalar z21 = v_e_omega_y * c_alpha + z1;
    const Scalar z22 = n2 * z8;
    const Scalar z23 = v_e_omega_x * z10;
    const Scalar z24 = n0_4 * z14;
    const Scalar z25 = n0_4 * z15;
    const Scalar z26 = n0_4 * z16;  // moment on blade_4, x
    const Scalar z27 = n0_4 * z17;  // moment on blade_3, x
    const Scalar z28 = n0_4 * z20;
    const Scalar z29 = v_e_omega_x * c_alpha - z1;
    const Scalar z30 = n0_4 * z22;
    const Scalar z31 = v_e_omega_y * z11;
    const Scalar z32 = z21 * z8;
    const Scalar z33 = n0_4 * z23;  // moment on blade_3, z
    const Scalar z34 = s_alpha * z24;
    const Scalar z35 = c_alpha * z18 - z12;
    const Scalar z36 = s_alpha * z25;
    const Scalar z37 = c_alpha * z19 - z13;
    const Scalar z38 = c_alpha * z24;
    const Scalar z39 = c_alpha * z25;
    const Scalar z40 = c_alpha * z28;
    const Scalar z41 = c_alpha * z30;
    const Scalar z42 = z38 - z40;
    const Scalar z43 = z29 * z9;
    const Scalar z44 = v_e_omega_y * z29;
    const Scalar z45 = v_e_omega_x * z21;
    const Scalar z46 = n0_4 * z31;  // moment on blade_4, z
    const Scalar z47 = s_alpha * z33;
    const Scalar z48 = n0_4 * z32;  // moment on blade_1, x
    const Scalar z49 = z35 - z36;
    const Scalar z50 = z34 - z37;
    const Scalar z51 = s_alpha * z28;
    const Scalar z52 = n2 * v_e_omega_z;
    const Scalar z53 = z39 - z41;
    const Scalar z54 = s_alpha * z46;
    const Scalar z55 = n0_4 * z43;  // moment on blade_2, x
    const Scalar z56 = n0_4 * z44;  // moment on blade_2, z
    const Scalar z57 = n0_4 * z45;  // moment on blade_1, z
    const Scalar z58 = z35 + z49;
    const Scalar z59 = z50 + z51;
    const Scalar z60 = s_alpha * z30;
    const Scalar z61 = s_alpha * z56;
    const Scalar z62 = s_alpha * z57;
    const Scalar z63 = z58 - z60;
    const Scalar z64 = z37 - z59;
    const Scalar z65 = n665 * z52 + z53;
    const Scalar z66 = n665 * z52 - z42;
    const Scalar z67 = n665 * z4 + z27 - z48 - z54 + z61;  // moment on rotor, x
    const Scalar z68 = n665 * z5 - z26 + z47 + z55 - z62;  // moment on rotor, y
    const Scalar z69 = v_e_omega_z * m2 - z65;
    const Scalar z70 = v_e_omega_y * m2 + z63;
    const Scalar z71 = v_e_omega_z * m3 - z66;
    const Scalar z72 = v_e_omega_x * m3 + z64;
    const Scalar z73 = a_e_omega_x * m2 + z67;
    const Scalar z74 = a_e_omega_y * m3 - z68;
    const Scalar z75 = a_e_omega_z * m4;
    const Scalar z76 = m5 * z71;
    const Scalar z77 = m6 * z69;
    const Scalar z78 = m6 * z70;
    const Scalar z79 = m5 * z72;
    result.M[0] = m2;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = m3;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = m4;
    result.C[0] = n0;
    result.C[1] = z71;
    result.C[2] = n0;
    result.C[3] = -z69;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = z70;
    result.C[7] = -z72;
    result.C[8] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.F[0] = -z73;
    result.F[1] = -z74;
    result.F[2] = -z75;
    result.A[0] = n0;
    result.A[1] = -v_e_omega_z;
    result.A[2] = v_e_omega_y;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = v_e_omega_z;
    result.A[7] = n0;
    result.A[8] = -v_e_omega_x;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = -v_e_omega_y;
    result.A[13] = v_e_omega_x;
    result.A[14] = n0;
    result.A[15] = n0;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = n0;
    result.A[22] = -z76;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = z77;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = -z78;
    result.A[34] = z79;
    result.A[35] = n0;
    if (!(traits::regular(m2, m2) && traits::regular(m3, m3) && traits::regular(m4,
        m4))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[0] * result.M[4] * result.M[8] * result.C[1] * result.C[3] * result.C[6]
        * result.C[7] * result.F[0] * result.F[1] * result.F[2]) * (n0 * result.A[1] * result.A[2] * result.A[6]
        * result.A[8] * result.A[12] * result.A[13] * result.A[22] * result.A[27] * result.A[33] * result.A[34]);
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, Multipliers(), Inputs(), result);
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 4>&>(coordinate_rates));
    visitor(Description::kernels[1], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[2], KernelFunction<void, std::array<Scalar, 9>&>(mass_matrix));
    visitor(Description::kernels[3], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[4],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[5],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[6], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[7], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace four_blade_rotor
