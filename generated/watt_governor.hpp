// SPDX-License-Identifier: MIT-0
// watt_governor: Watt's governor at a given speed
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, reactions, linearisation
// Parameters set at run time: m, M, L, omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                0                7          0             0                  0       0      7       -
//   kinematics                2               21          0             0                  2       0     27      29
//   mass_matrix               1                3          0             0                  1       0      6      10
//   bias                      3               13          0             0                  1       0     18      23
//   inverse_dynamics          5               14          0             0                  1       0     21      27
//   forward_dynamics          4               16          1             0                  1       0     23      29
//   energy                    3               12          0             0                  1       0     17      25
//   first_integrals           6               18          0             0                  1       0     26      35
//   reactions                 0                5          0             0                  1       0      7      10
//   linearisation            11               36          1             0                  1       0     50      61
//
// Not computed because this mechanism does not need it:
//   kinematics: of 54 results 12 vanish identically, 22 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   linearisation: of 8 results 1 vanish identically
//
// To write this file again:
//   watt_governor_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output watt_governor.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace watt_governor {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 1> coordinates{{{"theta", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> velocities{{{"theta", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 4> parameters{{{"m", "kg"}, {"M", "kg"}, {"L", "m"},
      {"omega", "rad/s"}}};
  static constexpr std::array<torsor::ResultDescription, 27> results{{{"result", "ball_1_position", 3, 1, 1, "m"},
      {"result", "ball_1_rotation", 3, 3, 2, "1"}, {"result", "ball_1_velocity", 3, 1, 1, "m/s"}, {"result",
      "ball_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "ball_2_position", 3, 1, 1, "m"}, {"result",
      "ball_2_rotation", 3, 3, 2, "1"}, {"result", "ball_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "ball_2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "sleeve_position", 3, 1, 1, "m"}, {"result",
      "sleeve_rotation", 3, 3, 2, "1"}, {"result", "sleeve_velocity", 3, 1, 1, "m/s"}, {"result",
      "sleeve_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 1, 1, 2, "kg m^2"}, {"forces", "", 1, 1, 1, "N m"},
      {"forces", "", 1, 1, 1, "N m"}, {"accelerations", "", 1, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1, ""},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "painleve", 1, 1, 0, "J"}, {"result", "motor", 1, 1, 0, "N m"}, {"result", "M", 1, 1, 2,
      "kg m^2"}, {"result", "C", 1, 1, 2, "N m s"}, {"result", "K", 1, 1, 2, "N m"}, {"result", "F", 1, 1, 1, "N m"},
      {"result", "A", 2, 2, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 12}, {"mass_matrix", false, false, false, false, results.data() + 12, 1}, {"bias", false,
      false, false, false, results.data() + 13, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 14,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 15, 2}, {"energy", false, false, true, false,
      results.data() + 17, 3}, {"first_integrals", false, false, false, false, results.data() + 20, 1}, {"reactions",
      true, true, true, false, results.data() + 21, 1}, {"linearisation", true, true, true, true, results.data() + 22,
      5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::watt_governor::Description;

  static constexpr const char* name = "watt_governor";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x68a6d46bbe83be0bULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 1;
  static constexpr int velocity_count = 1;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar m;  ///< parameter [kg]
    Scalar M;  ///< parameter [kg]
    Scalar L;  ///< parameter [m]
    Scalar omega;  ///< parameter [rad/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::m, &Parameters::M, &Parameters::L, &Parameters::omega};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar theta;  ///< coordinate [rad]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::theta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar theta;  ///< its rate [rad/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::theta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar theta;  ///< its second rate [rad/s^2]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::theta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar theta;  ///< works with the rate of theta [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::theta};
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
    Scalar m_05c12e58;
    Scalar m_1f69d53f;
    Scalar m_a7bd4253;
    Scalar m_efa9f396;
    Scalar m_48355c18;
    Scalar m_2f5126c7;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    parameters.m = n1;
    parameters.M = n2;
    parameters.L = n0_5;
    parameters.omega = n12;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar p_L = parameters.L;
    const Scalar p_m = parameters.m;
    const Scalar p_M = parameters.M;
    const Scalar z0 = n2 * p_L;
    const Scalar z1 = p_L * p_L * p_m;
    const Scalar z2 = n2 * z1;
    const Scalar z3 = p_L * p_m;
    const Scalar z4 = n0_5 * p_M;
    const Scalar z5 = n9_81 * p_M;
    precomputed.m_05c12e58 = z0;
    precomputed.m_1f69d53f = z2;
    precomputed.m_a7bd4253 = z1;
    precomputed.m_efa9f396 = z3;
    precomputed.m_48355c18 = z4;
    precomputed.m_2f5126c7 = z5;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    state.time = n0;
    state.q.theta = n1;
    state.v.theta = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> ball_1_position;  ///< centre of mass of ball_1 [m]
    std::array<Scalar, 9> ball_1_rotation;  ///< from the axes of ball_1 to the ground's (3 x 3)
    std::array<Scalar, 3> ball_1_velocity;  ///< velocity of the centre of mass of ball_1 [m/s]
    std::array<Scalar, 3> ball_1_angular_velocity;  ///< angular velocity of ball_1 [rad/s]
    std::array<Scalar, 3> ball_2_position;  ///< centre of mass of ball_2 [m]
    std::array<Scalar, 9> ball_2_rotation;  ///< from the axes of ball_2 to the ground's (3 x 3)
    std::array<Scalar, 3> ball_2_velocity;  ///< velocity of the centre of mass of ball_2 [m/s]
    std::array<Scalar, 3> ball_2_angular_velocity;  ///< angular velocity of ball_2 [rad/s]
    std::array<Scalar, 3> sleeve_position;  ///< centre of mass of sleeve [m]
    std::array<Scalar, 9> sleeve_rotation;  ///< from the axes of sleeve to the ground's (3 x 3)
    std::array<Scalar, 3> sleeve_velocity;  ///< velocity of the centre of mass of sleeve [m/s]
    std::array<Scalar, 3> sleeve_angular_velocity;  ///< angular velocity of sleeve [rad/s]
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
    Scalar painleve;  ///< T2 - T0 - U [J]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::painleve};
      return members_[i_];
    }
  };

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar motor;  ///< reaction along 'motor' [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::motor};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 1> M;  ///< mass matrix
    std::array<Scalar, 1> C;  ///< damping and gyroscopic terms
    std::array<Scalar, 1> K;  ///< stiffness
    std::array<Scalar, 1> F;  ///< right-hand side
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, e'): x' = A x + B du (2 x 2)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar m0 = precomputed.m_05c12e58;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {q_theta, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = p_omega * s_theta;
    const Scalar z4 = c_theta * z2;
    const Scalar z5 = c_theta * z1;
    const Scalar z6 = v_theta * p_L;
    const Scalar z7 = v_theta * s_theta;
    const Scalar z8 = s_theta * z2;
    const Scalar z9 = s_theta * z1;
    const Scalar z10 = c_theta * p_L;
    const Scalar z11 = v_theta * z1;  // angular velocity of arm_1, x
    const Scalar z12 = v_theta * z2;  // angular velocity of arm_1, y
    const Scalar z13 = s_theta * z6;
    const Scalar z14 = n2 * z10;
    const Scalar z15 = m0 * z7;  // velocity of sleeve, z
    const Scalar z16 = p_L * z3;
    const Scalar z17 = p_L * z8;
    const Scalar z18 = p_L * z9;
    const Scalar z19 = z1 * z16 - z4 * z6;
    const Scalar z20 = z2 * z16 + z5 * z6;
    result.ball_1_position[0] = -z17;
    result.ball_1_position[1] = -z18;
    result.ball_1_position[2] = -z10;
    result.ball_1_rotation[0] = z4;
    result.ball_1_rotation[1] = z5;
    result.ball_1_rotation[2] = -s_theta;
    result.ball_1_rotation[3] = -z1;
    result.ball_1_rotation[4] = z2;
    result.ball_1_rotation[5] = n0;
    result.ball_1_rotation[6] = z8;
    result.ball_1_rotation[7] = z9;
    result.ball_1_rotation[8] = c_theta;
    result.ball_1_velocity[0] = z19;
    result.ball_1_velocity[1] = -z20;
    result.ball_1_velocity[2] = z13;
    result.ball_1_angular_velocity[0] = -z11;
    result.ball_1_angular_velocity[1] = z12;
    result.ball_1_angular_velocity[2] = p_omega;
    result.ball_2_position[0] = z17;
    result.ball_2_position[1] = z18;
    result.ball_2_position[2] = -z10;
    result.ball_2_rotation[0] = z4;
    result.ball_2_rotation[1] = z5;
    result.ball_2_rotation[2] = s_theta;
    result.ball_2_rotation[3] = -z1;
    result.ball_2_rotation[4] = z2;
    result.ball_2_rotation[5] = n0;
    result.ball_2_rotation[6] = -z8;
    result.ball_2_rotation[7] = -z9;
    result.ball_2_rotation[8] = c_theta;
    result.ball_2_velocity[0] = -z19;
    result.ball_2_velocity[1] = z20;
    result.ball_2_velocity[2] = z13;
    result.ball_2_angular_velocity[0] = z11;
    result.ball_2_angular_velocity[1] = -z12;
    result.ball_2_angular_velocity[2] = p_omega;
    result.sleeve_position[0] = n0;
    result.sleeve_position[1] = n0;
    result.sleeve_position[2] = -z14;
    result.sleeve_rotation[0] = z2;
    result.sleeve_rotation[1] = z1;
    result.sleeve_rotation[2] = n0;
    result.sleeve_rotation[3] = -z1;
    result.sleeve_rotation[4] = z2;
    result.sleeve_rotation[5] = n0;
    result.sleeve_rotation[6] = n0;
    result.sleeve_rotation[7] = n0;
    result.sleeve_rotation[8] = n1;
    result.sleeve_velocity[0] = n0;
    result.sleeve_velocity[1] = n0;
    result.sleeve_velocity[2] = z15;
    result.sleeve_angular_velocity[0] = n0;
    result.sleeve_angular_velocity[1] = n0;
    result.sleeve_angular_velocity[2] = p_omega;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 1>& mass) noexcept {
    const Scalar q_theta = state.q.theta;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar m0 = precomputed.m_05c12e58;
    const Scalar m1 = precomputed.m_1f69d53f;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = s_theta * m0;
    const Scalar z1 = p_M * z0;
    const Scalar z2 = m1 + z0 * z1;
    mass[0] = z2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar m0 = precomputed.m_a7bd4253;
    const Scalar m1 = precomputed.m_efa9f396;
    const Scalar m2 = precomputed.m_05c12e58;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_theta * c_theta;
    const Scalar z1 = p_omega * s_theta;
    const Scalar z2 = p_omega * c_theta;
    const Scalar z3 = n9_81 * s_theta;
    const Scalar z4 = s_theta * m2;
    const Scalar z5 = v_theta * z0;
    const Scalar z6 = z1 * z2;
    const Scalar z7 = n9_81 + m2 * z5;
    const Scalar z8 = m0 * z6 - m1 * z3;  // moment on arm_2, y
    const Scalar z9 = p_M * z7;  // force on sleeve, z
    const Scalar z10 = z4 * z9 - n2 * z8;
    forces.theta = z10;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar m0 = precomputed.m_a7bd4253;
    const Scalar m1 = precomputed.m_efa9f396;
    const Scalar m2 = precomputed.m_05c12e58;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * s_theta;
    const Scalar z1 = p_omega * c_theta;
    const Scalar z2 = v_theta * c_theta;
    const Scalar z3 = n9_81 * s_theta;
    const Scalar z4 = s_theta * m2;
    const Scalar z5 = a_theta * s_theta + v_theta * z2;
    const Scalar z6 = z0 * z1;
    const Scalar z7 = m1 * z3 + m0 * (a_theta - z6);  // moment on arm_2, y
    const Scalar z8 = n9_81 + m2 * z5;
    const Scalar z9 = p_M * z8;  // force on sleeve, z
    const Scalar z10 = n2 * z7 + z4 * z9;
    forces.theta = z10;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar m0 = precomputed.m_a7bd4253;
    const Scalar m1 = precomputed.m_efa9f396;
    const Scalar m2 = precomputed.m_05c12e58;
    const Scalar m3 = precomputed.m_1f69d53f;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = s_theta * m2;
    const Scalar z1 = v_theta * c_theta;
    const Scalar z2 = p_omega * s_theta;
    const Scalar z3 = p_omega * c_theta;
    const Scalar z4 = n9_81 * s_theta;
    const Scalar z5 = v_theta * z1;
    const Scalar z6 = z2 * z3;
    const Scalar z7 = p_M * z0;
    const Scalar z8 = n9_81 + m2 * z5;
    const Scalar z9 = m0 * z6 - m1 * z4;  // moment on arm_2, y
    const Scalar z10 = m3 + z0 * z7;
    const Scalar z11 = p_M * z8;  // force on sleeve, z
    const Scalar z12 = n1 / z10;
    const Scalar z13 = z0 * z11 - n2 * z9;
    const Scalar z14 = z13 * z12;
    accelerations.theta = -z14;
    if (!(traits::regular(z10, z10))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.theta;
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
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar m0 = precomputed.m_a7bd4253;
    const Scalar m1 = precomputed.m_efa9f396;
    const Scalar m2 = precomputed.m_05c12e58;
    const Scalar m3 = precomputed.m_48355c18;
    const Scalar m4 = precomputed.m_2f5126c7;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_theta * s_theta;
    const Scalar z1 = p_omega * s_theta;
    const Scalar z2 = c_theta * m2;
    const Scalar z3 = c_theta * m1;
    const Scalar z4 = m2 * z0;  // velocity of sleeve, z
    result.kinetic = m0 * (v_theta * v_theta + z1 * z1) + m3 * z4 * z4;
    result.force_function = m4 * z2 + n19_62 * z3;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar m0 = precomputed.m_a7bd4253;
    const Scalar m1 = precomputed.m_efa9f396;
    const Scalar m2 = precomputed.m_05c12e58;
    const Scalar m3 = precomputed.m_1f69d53f;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_theta * s_theta;
    const Scalar z1 = p_omega * s_theta;
    const Scalar z2 = c_theta * m2;
    const Scalar z3 = c_theta * m1;
    const Scalar z4 = m2 * z0;  // velocity of sleeve, z
    const Scalar z5 = p_M * z4;
    const Scalar z6 = m2 * z5;
    const Scalar z7 = v_theta * m3 + s_theta * z6;
    result.painleve = -v_theta * (v_theta * m0 - z7) - p_M * (n9_81 * z2 + n0_5 * z4 * z4) - m0 * z1 * z1 - n19_62 * z3;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state, const Accelerations&,
      const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar m0 = precomputed.m_1f69d53f;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * c_theta;
    const Scalar z1 = v_theta * z0;  // angular acceleration of arm_1, x
    const Scalar z2 = m0 * z1;  // moment on arm_2, x
    const Scalar z3 = s_theta * z2;
    const Scalar z4 = n2 * z3;  // moment on shaft, z
    result.motor = z4;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, Reactions& result) noexcept {
    Mechanism::reactions(precomputed, state, accelerations, Multipliers(), Inputs(), result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar m0 = precomputed.m_a7bd4253;
    const Scalar m1 = precomputed.m_efa9f396;
    const Scalar m2 = precomputed.m_05c12e58;
    const Scalar m3 = precomputed.m_1f69d53f;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_theta * s_theta;
    const Scalar z1 = s_theta * m2;
    const Scalar z2 = v_theta * c_theta;
    const Scalar z3 = p_omega * s_theta;
    const Scalar z4 = p_omega * c_theta;
    const Scalar z5 = n9_81 * s_theta;
    const Scalar z6 = n9_81 * c_theta;
    const Scalar z7 = c_theta * m2;
    const Scalar z8 = a_theta * s_theta + v_theta * z2;
    const Scalar z9 = z3 * z4;
    const Scalar z10 = p_M * z1;
    const Scalar z11 = n2 * z2;
    const Scalar z12 = v_theta * z0 - a_theta * c_theta;
    const Scalar z13 = z3 * z3 - z4 * z4;
    const Scalar z14 = m1 * z5 + m0 * (a_theta - z9);  // moment on arm_2, y
    const Scalar z15 = m3 + z1 * z10;
    const Scalar z16 = m2 * z11;
    const Scalar z17 = n9_81 + m2 * z8;
    const Scalar z18 = p_M * z16;
    const Scalar z19 = m2 * z12;
    const Scalar z20 = m1 * z6 + m0 * z13;
    const Scalar z21 = n1 / z15;
    const Scalar z22 = p_M * z17;  // force on sleeve, z
    const Scalar z23 = z1 * z18;
    const Scalar z24 = p_M * z19;
    const Scalar z25 = n2 * z14 + z1 * z22;
    const Scalar z26 = z1 * z24 - z7 * z22 - n2 * z20;
    const Scalar z27 = z23 * z21;
    const Scalar z28 = z26 * z21;
    result.M[0] = z15;
    result.C[0] = z23;
    result.K[0] = -z26;
    result.F[0] = -z25;
    result.A[0] = n0;
    result.A[1] = z28;
    result.A[2] = n1;
    result.A[3] = -z27;
    if (!(traits::regular(z15, z15))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.M[0] * result.C[0] * result.K[0] * result.F[0] * result.A[1] * result.A[3];
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
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 1>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, Reactions&>(reactions));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace watt_governor
