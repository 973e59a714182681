// SPDX-License-Identifier: MIT-0
// passenger_in_vehicle: Passenger in a vehicle: trunk and head
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: V
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               13               16          0             0                  2       0     33      33
//   mass_matrix               3                3          0             0                  1       0      8       8
//   bias                      9               16          0             0                  2       0     29      29
//   inverse_dynamics         14               21          0             0                  2       0     39      39
//   forward_dynamics         15               25          1             0                  2       0     45      45
//   energy                   21               37          0             0                  3       0     64      68
//   linearisation            35               59          1             0                  2       0     99     100
//
// Not computed because this mechanism does not need it:
//   kinematics: of 60 results 31 vanish identically, 4 repeat another up to sign
//   mass_matrix: of 4 results 1 repeat another up to sign
//   first_integrals: left out, 'back_damping', 'neck_damping' have no force function
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 30 results 6 vanish identically, 1 repeat another up to sign
//
// To write this file again:
//   passenger_in_vehicle_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output passenger_in_vehicle.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace passenger_in_vehicle {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"theta_1", "rad"}, {"theta_2", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"theta_1", "rad/s"}, {"theta_2", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"V", "m/s"}}};
  static constexpr std::array<torsor::ResultDescription, 27> results{{{"result", "trunk_position", 3, 1, 1, "m"},
      {"result", "trunk_rotation", 3, 3, 2, "1"}, {"result", "trunk_velocity", 3, 1, 1, "m/s"}, {"result",
      "trunk_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "head_position", 3, 1, 1, "m"}, {"result",
      "head_rotation", 3, 3, 2, "1"}, {"result", "head_velocity", 3, 1, 1, "m/s"}, {"result", "head_angular_velocity",
      3, 1, 1, "rad/s"}, {"result", "I_position", 3, 1, 1, "m"}, {"result", "I_velocity", 3, 1, 1, "m/s"}, {"result",
      "I_jacobian", 3, 2, 2, ""}, {"result", "K_position", 3, 1, 1, "m"}, {"result", "K_velocity", 3, 1, 1, "m/s"},
      {"result", "K_jacobian", 3, 2, 2, "m"}, {"mass", "", 2, 2, 2, "kg m^2"}, {"forces", "", 2, 1, 1, "N m"},
      {"forces", "", 2, 1, 1, "N m"}, {"accelerations", "", 2, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1, ""},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "M", 2, 2, 2, "kg m^2"}, {"result", "C", 2, 2, 2, "N m s"}, {"result", "K", 2, 2, 2, "N m"},
      {"result", "F", 2, 1, 1, "N m"}, {"result", "A", 4, 4, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 14}, {"mass_matrix", false, false, false, false, results.data() + 14, 1}, {"bias", false,
      false, false, false, results.data() + 15, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 16,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 17, 2}, {"energy", false, false, true, false,
      results.data() + 19, 3}, {"linearisation", true, true, true, true, results.data() + 22, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::passenger_in_vehicle::Description;

  static constexpr const char* name = "passenger_in_vehicle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x534c9b313b36e1c1ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar V;  ///< parameter [m/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::V};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar theta_1;  ///< coordinate [rad]
    Scalar theta_2;  ///< coordinate [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::theta_1, &Coordinates::theta_2};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar theta_1;  ///< its rate [rad/s]
    Scalar theta_2;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::theta_1, &Velocities::theta_2};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar theta_1;  ///< its second rate [rad/s^2]
    Scalar theta_2;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::theta_1, &Accelerations::theta_2};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar theta_1;  ///< works with the rate of theta_1 [N m]
    Scalar theta_2;  ///< works with the rate of theta_2 [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::theta_1, &GeneralizedForces::theta_2};
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
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    parameters.V = n15;
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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    state.time = n0;
    state.q.theta_1 = -n0_3;
    state.q.theta_2 = -n0_4;
    state.v.theta_1 = n0;
    state.v.theta_2 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> trunk_position;  ///< centre of mass of trunk [m]
    std::array<Scalar, 9> trunk_rotation;  ///< from the axes of trunk to the ground's (3 x 3)
    std::array<Scalar, 3> trunk_velocity;  ///< velocity of the centre of mass of trunk [m/s]
    std::array<Scalar, 3> trunk_angular_velocity;  ///< angular velocity of trunk [rad/s]
    std::array<Scalar, 3> head_position;  ///< centre of mass of head [m]
    std::array<Scalar, 9> head_rotation;  ///< from the axes of head to the ground's (3 x 3)
    std::array<Scalar, 3> head_velocity;  ///< velocity of the centre of mass of head [m/s]
    std::array<Scalar, 3> head_angular_velocity;  ///< angular velocity of head [rad/s]
    std::array<Scalar, 3> I_position;  ///< position of I [m]
    std::array<Scalar, 3> I_velocity;  ///< velocity of the material point at I [m/s]
    std::array<Scalar, 6> I_jacobian;  ///< partial velocities of I (3 x 2)
    std::array<Scalar, 3> K_position;  ///< position of K [m]
    std::array<Scalar, 3> K_velocity;  ///< velocity of the material point at K [m/s]
    std::array<Scalar, 6> K_jacobian;  ///< partial velocities of K (3 x 2)
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

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 4> M;  ///< mass matrix (2 x 2)
    std::array<Scalar, 4> C;  ///< damping and gyroscopic terms (2 x 2)
    std::array<Scalar, 4> K;  ///< stiffness (2 x 2)
    std::array<Scalar, 2> F;  ///< right-hand side
    std::array<Scalar, 16> A;  ///< state matrix of x = (e, e'): x' = A x + B du (4 x 4)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_V = precomputed.parameters.V;
    const Scalar t = state.time;
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 + q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = p_V * t;
    const Scalar z4 = n0_6 * v_theta_1;
    const Scalar z5 = v_theta_1 + v_theta_2;
    const Scalar z6 = n0_6 * s_theta_1;
    const Scalar z7 = n0_6 * c_theta_1;
    const Scalar z8 = n0_35 * v_theta_1;
    const Scalar z9 = n0_8 + z3;  // place of S1, x
    const Scalar z10 = p_V - c_theta_1 * z4;  // velocity of S2, x
    const Scalar z11 = s_theta_1 * z4;  // velocity of S2, y
    const Scalar z12 = n0_15 * z5;
    const Scalar z13 = n0_35 * s_theta_1;
    const Scalar z14 = n0_35 * c_theta_1;
    const Scalar z15 = n0_15 * z1;
    const Scalar z16 = n0_15 * z2;
    const Scalar z17 = p_V - c_theta_1 * z8;
    const Scalar z18 = s_theta_1 * z8;
    const Scalar z19 = z9 - z6;  // place of S2, x
    const Scalar z20 = n0_5 + z7;  // place of S2, y
    const Scalar z21 = z9 - z13;
    const Scalar z22 = n0_5 + z14;
    const Scalar z23 = z1 * z12 + z11;
    const Scalar z24 = z2 * z12 - z10;
    const Scalar z25 = z19 - z15;
    const Scalar z26 = z20 + z16;
    result.trunk_position[0] = z21;
    result.trunk_position[1] = z22;
    result.trunk_position[2] = n0;
    result.trunk_rotation[0] = c_theta_1;
    result.trunk_rotation[1] = s_theta_1;
    result.trunk_rotation[2] = n0;
    result.trunk_rotation[3] = -s_theta_1;
    result.trunk_rotation[4] = c_theta_1;
    result.trunk_rotation[5] = n0;
    result.trunk_rotation[6] = n0;
    result.trunk_rotation[7] = n0;
    result.trunk_rotation[8] = n1;
    result.trunk_velocity[0] = z17;
    result.trunk_velocity[1] = -z18;
    result.trunk_velocity[2] = n0;
    result.trunk_angular_velocity[0] = n0;
    result.trunk_angular_velocity[1] = n0;
    result.trunk_angular_velocity[2] = v_theta_1;
    result.head_position[0] = z25;
    result.head_position[1] = z26;
    result.head_position[2] = n0;
    result.head_rotation[0] = z2;
    result.head_rotation[1] = z1;
    result.head_rotation[2] = n0;
    result.head_rotation[3] = -z1;
    result.head_rotation[4] = z2;
    result.head_rotation[5] = n0;
    result.head_rotation[6] = n0;
    result.head_rotation[7] = n0;
    result.head_rotation[8] = n1;
    result.head_velocity[0] = -z24;
    result.head_velocity[1] = -z23;
    result.head_velocity[2] = n0;
    result.head_angular_velocity[0] = n0;
    result.head_angular_velocity[1] = n0;
    result.head_angular_velocity[2] = z5;
    result.I_position[0] = z9;
    result.I_position[1] = n0_5;
    result.I_position[2] = n0;
    result.I_velocity[0] = p_V;
    result.I_velocity[1] = n0;
    result.I_velocity[2] = n0;
    result.I_jacobian[0] = n0;
    result.I_jacobian[3] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.K_position[0] = z19;
    result.K_position[1] = z20;
    result.K_position[2] = n0;
    result.K_velocity[0] = z10;
    result.K_velocity[1] = -z11;
    result.K_velocity[2] = n0;
    result.K_jacobian[0] = -z7;
    result.K_jacobian[3] = n0;
    result.K_jacobian[1] = -z6;
    result.K_jacobian[4] = n0;
    result.K_jacobian[2] = n0;
    result.K_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n8_2 = traits::constant(8.2, 8.2f, "41/5");
    const Scalar q_theta_2 = state.q.theta_2;
    Scalar s_theta_2, c_theta_2;
    traits::sincos(q_theta_2, s_theta_2, c_theta_2);
    const Scalar z0 = n0_75 * c_theta_2;
    const Scalar z1 = n0_1425 + n0_6 * z0;
    const Scalar z2 = n0_1425 + n1_2 * z0;
    const Scalar z3 = n8_2 + z2;
    mass[0] = z3;
    mass[1] = z1;
    mass[2] = z1;
    mass[3] = n0_1425;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n600 = traits::constant(600.0, 600.0f, "600/1");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n17 = traits::constant(17.0, 17.0f, "17/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar angles_[] = {q_theta_1, q_theta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar z0 = n9_81 * c_theta_1;
    const Scalar z1 = v_theta_1 * v_theta_1;
    const Scalar z2 = n9_81 * s_theta_1;
    const Scalar z3 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z4 = n600 * q_theta_1;
    const Scalar z5 = n25 * v_theta_1;
    const Scalar z6 = z3 * z3;
    const Scalar z7 = n40 * q_theta_2;
    const Scalar z8 = n0_6 * v_theta_2;
    const Scalar z9 = n0_75 * z6;  // force on S2, y
    const Scalar z10 = s_theta_2 * z9;
    const Scalar z11 = z0 - n0_6 * z1;
    const Scalar z12 = c_theta_2 * z2 + s_theta_2 * z11;
    const Scalar z13 = n0_75 * z12;  // moment on S2, z
    const Scalar z14 = n17 * z2 + z13 + n0_6 * z10;  // moment on S1, z
    const Scalar z15 = z7 + z8 - z13;
    const Scalar z16 = z4 + z5 - z14;
    forces.theta_1 = z16;
    forces.theta_2 = z15;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n600 = traits::constant(600.0, 600.0f, "600/1");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n8_2 = traits::constant(8.2, 8.2f, "41/5");
    const Scalar n17 = traits::constant(17.0, 17.0f, "17/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar angles_[] = {q_theta_1, q_theta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar z0 = n9_81 * c_theta_1;
    const Scalar z1 = v_theta_1 * v_theta_1;
    const Scalar z2 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z3 = n9_81 * s_theta_1;
    const Scalar z4 = a_theta_1 + a_theta_2;  // angular acceleration of S2, z
    const Scalar z5 = n600 * q_theta_1;
    const Scalar z6 = z2 * z2;
    const Scalar z7 = n0_75 * z4;  // force on S2, x
    const Scalar z8 = n25 * v_theta_1;
    const Scalar z9 = n40 * q_theta_2;
    const Scalar z10 = n0_6 * v_theta_2;
    const Scalar z11 = n0_75 * z6;  // force on S2, y
    const Scalar z12 = s_theta_2 * z11 - c_theta_2 * z7;
    const Scalar z13 = n0_6 * a_theta_1 - z3;
    const Scalar z14 = z0 - n0_6 * z1;
    const Scalar z15 = s_theta_2 * z14 - c_theta_2 * z13;
    const Scalar z16 = n0_75 * z15 - n0_1425 * z4;  // moment on S2, z
    const Scalar z17 = n8_2 * a_theta_1 - n17 * z3 - n0_6 * z12 - z16;  // moment on S1, z
    const Scalar z18 = z9 + z10 - z16;
    const Scalar z19 = z5 + z8 + z17;
    forces.theta_1 = z19;
    forces.theta_2 = z18;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n600 = traits::constant(600.0, 600.0f, "600/1");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n8_2 = traits::constant(8.2, 8.2f, "41/5");
    const Scalar n400_over_57 = traits::constant(7.017543859649122, 7.017544f, "400/57");
    const Scalar n17 = traits::constant(17.0, 17.0f, "17/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar angles_[] = {q_theta_1, q_theta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar z0 = n9_81 * c_theta_1;
    const Scalar z1 = v_theta_1 * v_theta_1;
    const Scalar z2 = n9_81 * s_theta_1;
    const Scalar z3 = n0_75 * c_theta_2;
    const Scalar z4 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z5 = n600 * q_theta_1;
    const Scalar z6 = z4 * z4;
    const Scalar z7 = n25 * v_theta_1;
    const Scalar z8 = n40 * q_theta_2;
    const Scalar z9 = n0_6 * v_theta_2;
    const Scalar z10 = n0_75 * z6;
    const Scalar z11 = s_theta_2 * z10;
    const Scalar z12 = z0 - n0_6 * z1;
    const Scalar z13 = n0_1425 + n0_6 * z3;
    const Scalar z14 = n0_1425 + n1_2 * z3;
    const Scalar z15 = c_theta_2 * z2 + s_theta_2 * z12;
    const Scalar z16 = n8_2 + z14;
    const Scalar z17 = n400_over_57 * z13;
    const Scalar z18 = z13 * z17 - z16;
    const Scalar z19 = n0_75 * z15;
    const Scalar z20 = n17 * z2 + z19 + n0_6 * z11;  // moment on S1, z
    const Scalar z21 = z8 + z9 - z19;
    const Scalar z22 = n1 / z18;
    const Scalar z23 = z5 + z7 - z20;
    const Scalar z24 = z23 - z21 * z17;
    const Scalar z25 = z22 * z24;
    const Scalar z26 = n400_over_57 * z21 + z17 * z25;
    accelerations.theta_1 = z25;
    accelerations.theta_2 = -z26;
    if (!(traits::regular(-z18, z16))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.theta_1 * accelerations.theta_2;
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
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n14 = traits::constant(14.0, 14.0f, "14/1");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n6_4 = traits::constant(6.4, 6.4f, "32/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n2_5 = traits::constant(2.5, 2.5f, "5/2");
    const Scalar n196_2 = traits::constant(196.2, 196.2f, "981/5");
    const Scalar n300 = traits::constant(300.0, 300.0f, "300/1");
    const Scalar n49_05 = traits::constant(49.05, 49.05f, "981/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar p_V = precomputed.parameters.V;
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 + q_theta_2;
    const Scalar angles_[] = {q_theta_1, q_theta_2, z0};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar z1 = cosines_[2];
    const Scalar z2 = p_V * c_theta_1;
    const Scalar z3 = p_V * s_theta_1;
    const Scalar z4 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z5 = n0_6 * c_theta_1;
    const Scalar z6 = n14 * c_theta_1;
    const Scalar z7 = n0_75 * z1;
    const Scalar z8 = n25 * v_theta_1;
    const Scalar z9 = n0_6 * v_theta_2;
    const Scalar z10 = n0_6 * v_theta_1 - z2;
    const Scalar z11 = n14 * v_theta_1 - n40 * z2;
    const Scalar z12 = n6_4 * v_theta_1 - n14 * z2;
    const Scalar z13 = n0_5 + z5;
    const Scalar z14 = s_theta_2 * z3 + c_theta_2 * z10;
    const Scalar z15 = s_theta_2 * z10 - c_theta_2 * z3;
    const Scalar z16 = n0_75 * z4 + n5 * z14;
    const Scalar z17 = n0_1425 * z4 + n0_75 * z14;
    result.kinetic = n20 * z3 * z3 + n2_5 * z15 * z15 + n0_5 * (v_theta_1 * z12 - z2 * z11 + z14 * z16 + z4 * z17);
    result.force_function = -n196_2 - n300 * q_theta_1 * q_theta_1 - n20 * q_theta_2 * q_theta_2 - n49_05 * z13 - n9_81
        * (z6 + z7);
    result.power = -v_theta_1 * z8 - v_theta_2 * z9;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n600 = traits::constant(600.0, 600.0f, "600/1");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n8_2 = traits::constant(8.2, 8.2f, "41/5");
    const Scalar n400_over_57 = traits::constant(7.017543859649122, 7.017544f, "400/57");
    const Scalar n17 = traits::constant(17.0, 17.0f, "17/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n80_over_19 = traits::constant(4.2105263157894735, 4.2105265f, "80/19");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar angles_[] = {q_theta_1, q_theta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar z0 = n0_75 * c_theta_2;
    const Scalar z1 = n9_81 * s_theta_1;
    const Scalar z2 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 * v_theta_1;
    const Scalar z6 = n2 * z2;
    const Scalar z7 = a_theta_1 + a_theta_2;  // angular acceleration of S2, z
    const Scalar z8 = n0_6 * z5;
    const Scalar z9 = z2 * z2;
    const Scalar z10 = n0_75 * z7;  // force on S2, x
    const Scalar z11 = n600 * q_theta_1;
    const Scalar z12 = n0_75 * z6;
    const Scalar z13 = s_theta_2 * z8;
    const Scalar z14 = n0_75 * z9;  // force on S2, y
    const Scalar z15 = n25 * v_theta_1;
    const Scalar z16 = n40 * q_theta_2;
    const Scalar z17 = n0_6 * v_theta_2;
    const Scalar z18 = s_theta_2 * z12;
    const Scalar z19 = s_theta_2 * z10 + c_theta_2 * z14;
    const Scalar z20 = s_theta_2 * z14 - c_theta_2 * z10;
    const Scalar z21 = n0_6 * a_theta_1 - z1;
    const Scalar z22 = z3 - n0_6 * z4;
    const Scalar z23 = n0_1425 + n0_6 * z0;
    const Scalar z24 = n0_1425 + n1_2 * z0;
    const Scalar z25 = n0_75 * z13;
    const Scalar z26 = n0_6 * z18;
    const Scalar z27 = s_theta_2 * z1 - c_theta_2 * z3;
    const Scalar z28 = z25 - z26;
    const Scalar z29 = s_theta_2 * z22 - c_theta_2 * z21;
    const Scalar z30 = s_theta_2 * z21 + c_theta_2 * z22;
    const Scalar z31 = n8_2 + z24;
    const Scalar z32 = n400_over_57 * z23;
    const Scalar z33 = n25 + z28;
    const Scalar z34 = n0_75 * z27;
    const Scalar z35 = z23 * z32 - z31;
    const Scalar z36 = z26 + n0_6 * z32;
    const Scalar z37 = z25 * z32 - z33;
    const Scalar z38 = n17 * z3 - z34;
    const Scalar z39 = n0_75 * z29 - n0_1425 * z7;  // moment on S2, z
    const Scalar z40 = n0_75 * z30;
    const Scalar z41 = n1 / z35;
    const Scalar z42 = n600 - z38;
    const Scalar z43 = n0_6 * z19 + z40;
    const Scalar z44 = n40 - z40;
    const Scalar z45 = z34 * z32 - z42;
    const Scalar z46 = n8_2 * a_theta_1 - n17 * z1 - n0_6 * z20 - z39;  // moment on S1, z
    const Scalar z47 = z16 + z17 - z39;
    const Scalar z48 = z43 + z44 * z32;
    const Scalar z49 = z11 + z15 + z46;
    const Scalar z50 = z41 * z45;
    const Scalar z51 = z41 * z37;
    const Scalar z52 = z41 * z48;
    const Scalar z53 = z41 * z36;
    const Scalar z54 = n400_over_57 * z34 - z32 * z50;
    const Scalar z55 = n400_over_57 * z25 - z32 * z51;
    const Scalar z56 = n400_over_57 * z44 - z32 * z52;
    const Scalar z57 = n80_over_19 - z32 * z53;
    result.M[0] = z31;
    result.M[1] = z23;
    result.M[2] = z23;
    result.M[3] = n0_1425;
    result.C[0] = z33;
    result.C[1] = z25;
    result.C[2] = -z26;
    result.C[3] = n0_6;
    result.K[0] = z42;
    result.K[1] = z34;
    result.K[2] = -z43;
    result.K[3] = z44;
    result.F[0] = -z49;
    result.F[1] = -z47;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = -z50;
    result.A[3] = -z54;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = -z52;
    result.A[7] = -z56;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = -z51;
    result.A[11] = -z55;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = -z53;
    result.A[15] = -z57;
    if (!(traits::regular(-z35, z31))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[0] * result.M[1] * result.M[2] * result.C[0] * result.C[1] * result.C[2]
        * result.K[0] * result.K[1] * result.K[2] * result.K[3]) * (n0 * result.F[0] * result.F[1] * result.A[2]
        * result.A[3] * result.A[6] * result.A[7] * result.A[10] * result.A[11] * result.A[14] * result.A[15]);
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 4>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace passenger_in_vehicle
