// SPDX-License-Identifier: MIT-0
// model_making_press: Model-making press: two columns, a screw and two cups
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               51               73          2             0                  2       0    130     142
//   mass_matrix              16               28          0             0                  0       0     44      52
//   bias                     36               76          0             0                  0       0    112     125
//   inverse_dynamics        122              184          1             0                  1       0    309     330
//   forward_dynamics        315              542          9             0                  1       0    868     938
//   energy                   46               72          2             0                  0       0    120     144
//   constraints             159              266          2             0                  1       0    429     503
//
// Not computed because this mechanism does not need it:
//   kinematics: of 72 results 16 vanish identically, 16 repeat another up to sign
//   mass_matrix: of 81 results 60 vanish identically, 6 repeat another up to sign
//   bias: of 9 results 1 vanish identically
//   forward_dynamics: of 19 results 4 vanish identically
//   constraints: of 120 results 76 vanish identically, 1 repeat another up to sign
//
// Constraints:
//   Constraints that repeat others are left out, their multipliers are 0: L2_z, L2_ry, L2_rz, L5_z.
//   Indeterminate, as they are shared with those in a way that no motion tells: lambda_L3_z.
//
// To write this file again:
//   model_making_press_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --support torsor_support.hpp --output model_making_press.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace model_making_press {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 11> coordinates{{{"a_z", "m"}, {"a", "rad"}, {"lower_w",
      "1"}, {"lower_x", "1"}, {"lower_y", "1"}, {"lower_z", "1"}, {"upper_w", "1"}, {"upper_x", "1"}, {"upper_y", "1"},
      {"upper_z", "1"}, {"omega_z", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 9> velocities{{{"a_z", "m/s"}, {"a", "rad/s"},
      {"lower_omega_x", "rad/s"}, {"lower_omega_y", "rad/s"}, {"lower_omega_z", "rad/s"}, {"upper_omega_x", "rad/s"},
      {"upper_omega_y", "rad/s"}, {"upper_omega_z", "rad/s"}, {"omega_z", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> inputs{{{"C", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 10> multipliers{{{"lambda_L2_y", "N"}, {"lambda_L2_z", "N"},
      {"lambda_L2_ry", "N m"}, {"lambda_L2_rz", "N m"}, {"lambda_L3_z", "N"}, {"lambda_L3_rx", "N m"}, {"lambda_L3_ry",
      "N m"}, {"lambda_L5_z", "N"}, {"lambda_L5_rx", "N m"}, {"lambda_L5_ry", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 29> results{{{"rates", "", 11, 1, 1,
      "m/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s"}, {"result", "traverse_position", 3,
      1, 1, "m"}, {"result", "traverse_rotation", 3, 3, 2, "1"}, {"result", "traverse_velocity", 3, 1, 1, "m/s"},
      {"result", "traverse_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "screw_position", 3, 1, 1, "m"}, {"result",
      "screw_rotation", 3, 3, 2, "1"}, {"result", "screw_velocity", 3, 1, 1, "m/s"}, {"result",
      "screw_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "lower_cup_position", 3, 1, 1, "m"}, {"result",
      "lower_cup_rotation", 3, 3, 2, "1"}, {"result", "lower_cup_velocity", 3, 1, 1, "m/s"}, {"result",
      "lower_cup_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "upper_cup_position", 3, 1, 1, "m"}, {"result",
      "upper_cup_rotation", 3, 3, 2, "1"}, {"result", "upper_cup_velocity", 3, 1, 1, "m/s"}, {"result",
      "upper_cup_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 9, 9, 2, ""}, {"forces", "", 9, 1, 1,
      "N, 0, N m, N m, N m, N m, N m, N m, N m"}, {"forces", "", 9, 1, 1, "N, N m, N m, N m, N m, N m, N m, N m, N m"},
      {"accelerations", "", 9, 1, 1, "m/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2"},
      {"multipliers", "", 10, 1, 1, "N, 0, 0, 0, N, N m, N m, 0, N m, N m"}, {"result", "kinetic", 1, 1, 0, "J"},
      {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "value", 10, 1, 1,
      "m, m, 0, 0, m, 1, 1, m, 1, 1"}, {"result", "rate", 10, 1, 1,
      "m/s, m/s, 0, 0, m/s, rad/s, rad/s, m/s, rad/s, rad/s"}, {"result", "jacobian", 10, 9, 2, ""}, {"result", "gamma",
      10, 1, 1, "m/s^2, m/s^2, 0, 0, m/s^2, rad/s^2, rad/s^2, m/s^2, rad/s^2, rad/s^2"}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"coordinate_rates", false, false, false, false,
      results.data() + 0, 1}, {"kinematics", false, false, false, false, results.data() + 1, 16}, {"mass_matrix", false,
      false, false, false, results.data() + 17, 1}, {"bias", false, false, false, false, results.data() + 18, 1},
      {"inverse_dynamics", true, true, false, false, results.data() + 19, 1}, {"forward_dynamics", false, false, true,
      true, results.data() + 20, 2}, {"energy", false, false, true, false, results.data() + 22, 3}, {"constraints",
      false, false, false, false, results.data() + 25, 4}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::model_making_press::Description;

  static constexpr const char* name = "model_making_press";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xd30814f6b432343aULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 11;
  static constexpr int velocity_count = 9;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 10;
  static constexpr int first_integral_count = 0;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 2;
  static constexpr int quaternions[quaternion_count] = {2, 6};
  /// Multipliers that are taken as zero: their constraints repeat others.
  static constexpr int redundant_count = 4;
  static constexpr int redundant_multipliers[redundant_count] = {1, 2, 3, 7};

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar a_z;  ///< coordinate [m]
    Scalar a;  ///< coordinate [rad]
    Scalar lower_w;  ///< component of a unit quaternion [1]
    Scalar lower_x;  ///< component of a unit quaternion [1]
    Scalar lower_y;  ///< component of a unit quaternion [1]
    Scalar lower_z;  ///< component of a unit quaternion [1]
    Scalar upper_w;  ///< component of a unit quaternion [1]
    Scalar upper_x;  ///< component of a unit quaternion [1]
    Scalar upper_y;  ///< component of a unit quaternion [1]
    Scalar upper_z;  ///< component of a unit quaternion [1]
    Scalar omega_z;  ///< coordinate [rad]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::a_z, &Coordinates::a, &Coordinates::lower_w,
          &Coordinates::lower_x, &Coordinates::lower_y, &Coordinates::lower_z, &Coordinates::upper_w,
          &Coordinates::upper_x, &Coordinates::upper_y, &Coordinates::upper_z, &Coordinates::omega_z};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar a_z;  ///< its rate [m/s]
    Scalar a;  ///< its rate [rad/s]
    Scalar lower_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar lower_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar lower_omega_z;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar upper_omega_z;  ///< angular velocity, in moving axes [rad/s]
    Scalar omega_z;  ///< its rate [rad/s]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::a_z, &Velocities::a, &Velocities::lower_omega_x,
          &Velocities::lower_omega_y, &Velocities::lower_omega_z, &Velocities::upper_omega_x,
          &Velocities::upper_omega_y, &Velocities::upper_omega_z, &Velocities::omega_z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar a_z;  ///< its second rate [m/s^2]
    Scalar a;  ///< its second rate [rad/s^2]
    Scalar lower_omega_x;  ///< its rate [rad/s^2]
    Scalar lower_omega_y;  ///< its rate [rad/s^2]
    Scalar lower_omega_z;  ///< its rate [rad/s^2]
    Scalar upper_omega_x;  ///< its rate [rad/s^2]
    Scalar upper_omega_y;  ///< its rate [rad/s^2]
    Scalar upper_omega_z;  ///< its rate [rad/s^2]
    Scalar omega_z;  ///< its second rate [rad/s^2]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::a_z, &Accelerations::a,
          &Accelerations::lower_omega_x, &Accelerations::lower_omega_y, &Accelerations::lower_omega_z,
          &Accelerations::upper_omega_x, &Accelerations::upper_omega_y, &Accelerations::upper_omega_z,
          &Accelerations::omega_z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar a_z;  ///< works with the rate of a_z [N]
    Scalar a;  ///< works with the rate of a [N m]
    Scalar lower_omega_x;  ///< works with lower_omega_x [N m]
    Scalar lower_omega_y;  ///< works with lower_omega_y [N m]
    Scalar lower_omega_z;  ///< works with lower_omega_z [N m]
    Scalar upper_omega_x;  ///< works with upper_omega_x [N m]
    Scalar upper_omega_y;  ///< works with upper_omega_y [N m]
    Scalar upper_omega_z;  ///< works with upper_omega_z [N m]
    Scalar omega_z;  ///< works with the rate of omega_z [N m]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::a_z, &GeneralizedForces::a,
          &GeneralizedForces::lower_omega_x, &GeneralizedForces::lower_omega_y, &GeneralizedForces::lower_omega_z,
          &GeneralizedForces::upper_omega_x, &GeneralizedForces::upper_omega_y, &GeneralizedForces::upper_omega_z,
          &GeneralizedForces::omega_z};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar C;  ///< motor [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C};
      return members_[i_];
    }
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_L2_y;  ///< of the constraint L2_y [N]
    Scalar lambda_L2_z;  ///< indeterminate, of the constraint L2_z [N]
    Scalar lambda_L2_ry;  ///< indeterminate, of the constraint L2_ry [N m]
    Scalar lambda_L2_rz;  ///< indeterminate, of the constraint L2_rz [N m]
    Scalar lambda_L3_z;  ///< indeterminate, of the constraint L3_z [N]
    Scalar lambda_L3_rx;  ///< of the constraint L3_rx [N m]
    Scalar lambda_L3_ry;  ///< of the constraint L3_ry [N m]
    Scalar lambda_L5_z;  ///< indeterminate, of the constraint L5_z [N]
    Scalar lambda_L5_rx;  ///< of the constraint L5_rx [N m]
    Scalar lambda_L5_ry;  ///< of the constraint L5_ry [N m]
    static constexpr int size = 10;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_L2_y, &Multipliers::lambda_L2_z,
          &Multipliers::lambda_L2_ry, &Multipliers::lambda_L2_rz, &Multipliers::lambda_L3_z, &Multipliers::lambda_L3_rx,
          &Multipliers::lambda_L3_ry, &Multipliers::lambda_L5_z, &Multipliers::lambda_L5_rx,
          &Multipliers::lambda_L5_ry};
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
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    state.time = n0;
    state.q.a_z = n0;
    state.q.a = n0;
    state.q.lower_w = n1;
    state.q.lower_x = n0;
    state.q.lower_y = n0;
    state.q.lower_z = n0;
    state.q.upper_w = n1;
    state.q.upper_x = n0;
    state.q.upper_y = n0;
    state.q.upper_z = n0;
    state.q.omega_z = n0;
    state.v.a_z = n0;
    state.v.a = n0;
    state.v.lower_omega_x = n0;
    state.v.lower_omega_y = n0;
    state.v.lower_omega_z = n0;
    state.v.upper_omega_x = n0;
    state.v.upper_omega_y = n0;
    state.v.upper_omega_z = n0;
    state.v.omega_z = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> traverse_position;  ///< centre of mass of traverse [m]
    std::array<Scalar, 9> traverse_rotation;  ///< from the axes of traverse to the ground's (3 x 3)
    std::array<Scalar, 3> traverse_velocity;  ///< velocity of the centre of mass of traverse [m/s]
    std::array<Scalar, 3> traverse_angular_velocity;  ///< angular velocity of traverse [rad/s]
    std::array<Scalar, 3> screw_position;  ///< centre of mass of screw [m]
    std::array<Scalar, 9> screw_rotation;  ///< from the axes of screw to the ground's (3 x 3)
    std::array<Scalar, 3> screw_velocity;  ///< velocity of the centre of mass of screw [m/s]
    std::array<Scalar, 3> screw_angular_velocity;  ///< angular velocity of screw [rad/s]
    std::array<Scalar, 3> lower_cup_position;  ///< centre of mass of lower_cup [m]
    std::array<Scalar, 9> lower_cup_rotation;  ///< from the axes of lower_cup to the ground's (3 x 3)
    std::array<Scalar, 3> lower_cup_velocity;  ///< velocity of the centre of mass of lower_cup [m/s]
    std::array<Scalar, 3> lower_cup_angular_velocity;  ///< angular velocity of lower_cup [rad/s]
    std::array<Scalar, 3> upper_cup_position;  ///< centre of mass of upper_cup [m]
    std::array<Scalar, 9> upper_cup_rotation;  ///< from the axes of upper_cup to the ground's (3 x 3)
    std::array<Scalar, 3> upper_cup_velocity;  ///< velocity of the centre of mass of upper_cup [m/s]
    std::array<Scalar, 3> upper_cup_angular_velocity;  ///< angular velocity of upper_cup [rad/s]
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

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 10> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 10> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 90> jacobian;  ///< A, stored column by column (10 x 9)
    std::array<Scalar, 10> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 11>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_a_z = state.v.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar z0 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x * v_lower_omega_x);
    const Scalar z1 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w * v_lower_omega_x);
    const Scalar z2 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w * v_lower_omega_y);
    const Scalar z3 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w * v_lower_omega_z);
    const Scalar z4 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x * v_upper_omega_x);
    const Scalar z5 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w * v_upper_omega_x);
    const Scalar z6 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w * v_upper_omega_y);
    const Scalar z7 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w * v_upper_omega_z);
    rates[0] = v_a_z;
    rates[1] = v_a;
    rates[2] = -z0;
    rates[3] = z1;
    rates[4] = z2;
    rates[5] = -z3;
    rates[6] = -z4;
    rates[7] = z5;
    rates[8] = z6;
    rates[9] = -z7;
    rates[10] = v_omega_z;
  }

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar angles_[] = {q_a, q_omega_z};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_a = sines_[0], c_a = cosines_[0];
    const Scalar s_omega_z = sines_[1], c_omega_z = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z0 = n2 * q_lower_y;
    const Scalar z1 = n2 * q_upper_y;
    const Scalar z2 = n2 * q_lower_z;
    const Scalar z3 = n2 * q_upper_z;
    const Scalar z4 = n2 * q_lower_x;
    const Scalar z5 = n2 * q_upper_x;
    const Scalar z6 = q_lower_y * z0;
    const Scalar z7 = q_upper_y * z1;
    const Scalar z8 = q_lower_z * z2;
    const Scalar z9 = q_lower_x * z0;
    const Scalar z10 = q_lower_w * z2;
    const Scalar z11 = q_upper_z * z3;
    const Scalar z12 = q_upper_x * z1;
    const Scalar z13 = q_upper_w * z3;
    const Scalar z14 = n1 - z6 - z8;
    const Scalar z15 = z9 + z10;
    const Scalar z16 = q_lower_x * z4;
    const Scalar z17 = n1 - z7 - z11;
    const Scalar z18 = z12 + z13;
    const Scalar z19 = q_upper_x * z5;
    const Scalar z20 = z9 - z10;
    const Scalar z21 = n1 - z8 - z16;
    const Scalar z22 = q_lower_x * z2;
    const Scalar z23 = q_lower_w * z0;
    const Scalar z24 = z12 - z13;
    const Scalar z25 = n1 - z11 - z19;
    const Scalar z26 = q_upper_x * z3;
    const Scalar z27 = q_upper_w * z1;
    const Scalar z28 = n1 - z6 - z16;
    const Scalar z29 = q_lower_z * z0;
    const Scalar z30 = q_lower_w * z4;
    const Scalar z31 = q_upper_z * z1;
    const Scalar z32 = q_upper_w * z5;
    const Scalar z33 = z22 - z23;
    const Scalar z34 = z22 + z23;
    const Scalar z35 = z26 - z27;
    const Scalar z36 = z26 + z27;
    const Scalar z37 = z29 - z30;
    const Scalar z38 = z29 + z30;
    const Scalar z39 = z31 - z32;
    const Scalar z40 = z31 + z32;
    const Scalar z41 = s_a * z15 - c_a * z14;
    const Scalar z42 = s_a * z14 + c_a * z15;
    const Scalar z43 = s_a * z18 - c_a * z17;
    const Scalar z44 = s_a * z17 + c_a * z18;
    const Scalar z45 = s_a * z21 - c_a * z20;
    const Scalar z46 = s_a * z20 + c_a * z21;
    const Scalar z47 = v_a + v_lower_omega_x * z33;  // angular velocity of lower_omega_x, z
    const Scalar z48 = s_a * z25 - c_a * z24;
    const Scalar z49 = s_a * z24 + c_a * z25;
    const Scalar z50 = v_a + v_upper_omega_x * z35;  // angular velocity of upper_omega_x, z
    const Scalar z51 = n1 - z7 - z19;
    const Scalar z52 = s_a * z37 - c_a * z34;
    const Scalar z53 = s_a * z34 + c_a * z37;
    const Scalar z54 = v_lower_omega_y * z38 + z47;  // angular velocity of lower_omega_y, z
    const Scalar z55 = s_a * z39 - c_a * z36;
    const Scalar z56 = s_a * z36 + c_a * z39;
    const Scalar z57 = v_upper_omega_y * z40 + z50;  // angular velocity of upper_omega_y, z
    const Scalar z58 = n0_1 * c_a;
    const Scalar z59 = n0_1 * v_a;
    const Scalar z60 = n0_1 * s_a;
    const Scalar z61 = s_a * z59;  // velocity of lower_omega_x, x
    const Scalar z62 = n0_1 - z58;  // place of lower_omega_x, x
    const Scalar z63 = c_a * z59;  // velocity of lower_omega_x, y
    const Scalar z64 = v_lower_omega_z * z28 + z54;  // angular velocity of lower_cup, z
    const Scalar z65 = v_upper_omega_z * z51 + z57;  // angular velocity of upper_cup, z
    const Scalar z66 = n0_002 * q_omega_z / pi;
    const Scalar z67 = v_lower_omega_x * z41;  // angular velocity of lower_omega_x, x
    const Scalar z68 = v_lower_omega_x * z42;  // angular velocity of lower_omega_x, y
    const Scalar z69 = v_upper_omega_x * z43;  // angular velocity of upper_omega_x, x
    const Scalar z70 = v_upper_omega_x * z44;  // angular velocity of upper_omega_x, y
    const Scalar z71 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z72 = v_lower_omega_y * z45 + z67;  // angular velocity of lower_omega_y, x
    const Scalar z73 = v_lower_omega_y * z46 + z68;  // angular velocity of lower_omega_y, y
    const Scalar z74 = v_upper_omega_y * z48 + z69;  // angular velocity of upper_omega_y, x
    const Scalar z75 = v_upper_omega_y * z49 + z70;  // angular velocity of upper_omega_y, y
    const Scalar z76 = v_lower_omega_z * z52 + z72;  // angular velocity of lower_cup, x
    const Scalar z77 = v_lower_omega_z * z53 + z73;  // angular velocity of lower_cup, y
    const Scalar z78 = v_upper_omega_z * z55 + z74;  // angular velocity of upper_cup, x
    const Scalar z79 = v_upper_omega_z * z56 + z75;  // angular velocity of upper_cup, y
    result.traverse_position[0] = -z62;
    result.traverse_position[1] = z60;
    result.traverse_position[2] = q_a_z;
    result.traverse_rotation[0] = c_a;
    result.traverse_rotation[1] = s_a;
    result.traverse_rotation[2] = n0;
    result.traverse_rotation[3] = -s_a;
    result.traverse_rotation[4] = c_a;
    result.traverse_rotation[5] = n0;
    result.traverse_rotation[6] = n0;
    result.traverse_rotation[7] = n0;
    result.traverse_rotation[8] = n1;
    result.traverse_velocity[0] = -z61;
    result.traverse_velocity[1] = z63;
    result.traverse_velocity[2] = v_a_z;
    result.traverse_angular_velocity[0] = n0;
    result.traverse_angular_velocity[1] = n0;
    result.traverse_angular_velocity[2] = v_a;
    result.screw_position[0] = n0;
    result.screw_position[1] = n0;
    result.screw_position[2] = z66;
    result.screw_rotation[0] = c_omega_z;
    result.screw_rotation[1] = s_omega_z;
    result.screw_rotation[2] = n0;
    result.screw_rotation[3] = -s_omega_z;
    result.screw_rotation[4] = c_omega_z;
    result.screw_rotation[5] = n0;
    result.screw_rotation[6] = n0;
    result.screw_rotation[7] = n0;
    result.screw_rotation[8] = n1;
    result.screw_velocity[0] = n0;
    result.screw_velocity[1] = n0;
    result.screw_velocity[2] = z71;
    result.screw_angular_velocity[0] = n0;
    result.screw_angular_velocity[1] = n0;
    result.screw_angular_velocity[2] = v_omega_z;
    result.lower_cup_position[0] = -z62;
    result.lower_cup_position[1] = z60;
    result.lower_cup_position[2] = q_a_z;
    result.lower_cup_rotation[0] = -z41;
    result.lower_cup_rotation[1] = z42;
    result.lower_cup_rotation[2] = z33;
    result.lower_cup_rotation[3] = -z45;
    result.lower_cup_rotation[4] = z46;
    result.lower_cup_rotation[5] = z38;
    result.lower_cup_rotation[6] = -z52;
    result.lower_cup_rotation[7] = z53;
    result.lower_cup_rotation[8] = z28;
    result.lower_cup_velocity[0] = -z61;
    result.lower_cup_velocity[1] = z63;
    result.lower_cup_velocity[2] = v_a_z;
    result.lower_cup_angular_velocity[0] = -z76;
    result.lower_cup_angular_velocity[1] = z77;
    result.lower_cup_angular_velocity[2] = z64;
    result.upper_cup_position[0] = -z62;
    result.upper_cup_position[1] = z60;
    result.upper_cup_position[2] = q_a_z;
    result.upper_cup_rotation[0] = -z43;
    result.upper_cup_rotation[1] = z44;
    result.upper_cup_rotation[2] = z35;
    result.upper_cup_rotation[3] = -z48;
    result.upper_cup_rotation[4] = z49;
    result.upper_cup_rotation[5] = z40;
    result.upper_cup_rotation[6] = -z55;
    result.upper_cup_rotation[7] = z56;
    result.upper_cup_rotation[8] = z51;
    result.upper_cup_velocity[0] = -z61;
    result.upper_cup_velocity[1] = z63;
    result.upper_cup_velocity[2] = v_a_z;
    result.upper_cup_angular_velocity[0] = -z78;
    result.upper_cup_angular_velocity[1] = z79;
    result.upper_cup_angular_velocity[2] = z65;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 81>& mass) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k5 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z0;
    });
    const Scalar z2 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z0 * z1;
    });
    const Scalar z3 = n2 * q_upper_y;
    const Scalar z4 = n2 * q_upper_x;
    const Scalar z5 = n2 * q_lower_y;
    const Scalar z6 = n2 * q_lower_x;
    const Scalar z7 = q_lower_y * z5;
    const Scalar z8 = q_lower_x * z6;
    const Scalar z9 = q_upper_y * z3;
    const Scalar z10 = q_upper_z * z3;
    const Scalar z11 = q_upper_w * z4;
    const Scalar z12 = q_lower_z * z5;
    const Scalar z13 = q_lower_w * z6;
    const Scalar z14 = q_upper_x * z4;
    const Scalar z15 = z10 + z11;
    const Scalar z16 = z12 + z13;
    const Scalar z17 = n1 - z9 - z14;
    const Scalar z18 = q_upper_z * z4;
    const Scalar z19 = q_upper_w * z3;
    const Scalar z20 = k5 * z15;
    const Scalar z21 = n1 - z7 - z8;
    const Scalar z22 = k5 * z16;
    const Scalar z23 = q_lower_z * z6;
    const Scalar z24 = q_lower_w * z5;
    const Scalar z25 = k5 * z17;
    const Scalar z26 = z18 - z19;
    const Scalar z27 = k5 * z21;
    const Scalar z28 = z23 - z24;
    const Scalar z29 = k5 * z26;
    const Scalar z30 = k5 * z28;
    const Scalar z31 = z15 * z20 + z17 * z25 + z26 * z29;
    const Scalar z32 = z16 * z22 + z21 * z27 + z28 * z30;
    const Scalar z33 = n0_0002 + z31;
    const Scalar z34 = n0_0002 + z32;
    const Scalar z35 = n0_01 + z33;
    const Scalar z36 = z35 + z34;
    mass[0] = n0_84;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = z36;
    mass[11] = z30;
    mass[12] = z22;
    mass[13] = z27;
    mass[14] = z29;
    mass[15] = z20;
    mass[16] = z25;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = z30;
    mass[20] = k5;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = z22;
    mass[29] = n0;
    mass[30] = k5;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = z27;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = k5;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = z29;
    mass[47] = n0;
    mass[48] = n0;
    mass[49] = n0;
    mass[50] = k5;
    mass[51] = n0;
    mass[52] = n0;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = z20;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = k5;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = z25;
    mass[65] = n0;
    mass[66] = n0;
    mass[67] = n0;
    mass[68] = n0;
    mass[69] = n0;
    mass[70] = k5;
    mass[71] = n0;
    mass[72] = n0;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = n0;
    mass[76] = n0;
    mass[77] = n0;
    mass[78] = n0;
    mass[79] = n0;
    mass[80] = z2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar k10 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z2 = n2 * q_lower_y;
    const Scalar z3 = n2 * q_lower_z;
    const Scalar z4 = n2 * q_upper_y;
    const Scalar z5 = n2 * q_upper_z;
    const Scalar z6 = n2 * q_lower_x;
    const Scalar z7 = n2 * q_upper_x;
    const Scalar z8 = q_lower_y * z2;
    const Scalar z9 = q_lower_x * z2;
    const Scalar z10 = q_lower_w * z3;
    const Scalar z11 = q_upper_y * z4;
    const Scalar z12 = q_upper_x * z4;
    const Scalar z13 = q_upper_w * z5;
    const Scalar z14 = v_a * v_a;
    const Scalar z15 = z9 - z10;
    const Scalar z16 = q_lower_x * z6;
    const Scalar z17 = q_lower_z * z2;
    const Scalar z18 = q_lower_w * z6;
    const Scalar z19 = z12 - z13;
    const Scalar z20 = q_upper_x * z7;
    const Scalar z21 = q_upper_z * z4;
    const Scalar z22 = q_upper_w * z7;
    const Scalar z23 = n0_1 * z14;
    const Scalar z24 = z17 + z18;
    const Scalar z25 = q_lower_x * z3;
    const Scalar z26 = q_lower_w * z2;
    const Scalar z27 = n1 - z8 - z16;
    const Scalar z28 = z21 + z22;
    const Scalar z29 = q_upper_x * z5;
    const Scalar z30 = q_upper_w * z4;
    const Scalar z31 = n1 - z11 - z20;
    const Scalar z32 = q_lower_z * z3;
    const Scalar z33 = q_upper_z * z5;
    const Scalar z34 = z25 + z26;
    const Scalar z35 = z29 + z30;
    const Scalar z36 = n1 - z8 - z32;
    const Scalar z37 = n1 - z11 - z33;
    const Scalar z38 = z15 * z23 - n9_81 * z24;
    const Scalar z39 = z19 * z23 - n9_81 * z28;
    const Scalar z40 = z25 - z26;
    const Scalar z41 = z29 - z30;
    const Scalar z42 = n9_81 * z27 - z34 * z23;
    const Scalar z43 = n9_81 * z31 - z35 * z23;
    const Scalar z44 = n0_02 * z39;  // force on upper_cup, y
    const Scalar z45 = n0_02 * z38;  // force on lower_cup, y
    const Scalar z46 = n0_02 * z43;  // force on upper_cup, z
    const Scalar z47 = n0_02 * z42;  // force on lower_cup, z
    const Scalar z48 = z36 * z23 - n9_81 * z40;
    const Scalar z49 = z37 * z23 - n9_81 * z41;
    const Scalar z50 = n0_02 * z49;  // force on upper_cup, x
    const Scalar z51 = n0_02 * z48;  // force on lower_cup, x
    const Scalar z52 = v_a * z24;
    const Scalar z53 = v_a * z27;
    const Scalar z54 = v_a * z28;
    const Scalar z55 = v_a * z31;
    const Scalar z56 = z28 * z44 - z31 * z46 + z41 * z50;
    const Scalar z57 = z24 * z45 - z27 * z47 + z40 * z51;
    const Scalar z58 = v_a * z40;
    const Scalar z59 = v_lower_omega_x * z53;  // angular acceleration of lower_omega_x, y
    const Scalar z60 = v_lower_omega_x * z52;  // angular acceleration of lower_omega_x, z
    const Scalar z61 = v_lower_omega_y * z53;  // angular acceleration of lower_omega_y, x
    const Scalar z62 = v_a * z41;
    const Scalar z63 = v_upper_omega_x * z55;  // angular acceleration of upper_omega_x, y
    const Scalar z64 = v_upper_omega_x * z54;  // angular acceleration of upper_omega_x, z
    const Scalar z65 = v_upper_omega_y * z55;  // angular acceleration of upper_omega_y, x
    const Scalar z66 = z56 + z57;  // force on ring_A, z
    const Scalar z67 = n20000 * q_a_z;
    const Scalar z68 = n0_0005 * v_omega_z;
    const Scalar z69 = v_lower_omega_y * z58 - z60;  // angular acceleration of lower_omega_y, z
    const Scalar z70 = v_lower_omega_z * z52 - z61;  // angular acceleration of lower_cup, x
    const Scalar z71 = v_lower_omega_z * z58 - z59;  // angular acceleration of lower_cup, y
    const Scalar z72 = v_upper_omega_y * z62 - z64;  // angular acceleration of upper_omega_y, z
    const Scalar z73 = v_upper_omega_z * z54 - z65;  // angular acceleration of upper_cup, x
    const Scalar z74 = v_upper_omega_z * z62 - z63;  // angular acceleration of upper_cup, y
    const Scalar z75 = n7_848 - z66;  // force on ring_A.1, z
    const Scalar z76 = k10 * z73;  // moment on upper_cup, x
    const Scalar z77 = k10 * z74;  // moment on upper_cup, y
    const Scalar z78 = k10 * z72;  // moment on upper_cup, z
    const Scalar z79 = k10 * z70;  // moment on lower_cup, x
    const Scalar z80 = k10 * z71;  // moment on lower_cup, y
    const Scalar z81 = k10 * z69;  // moment on lower_cup, z
    const Scalar z82 = z67 + z75;
    const Scalar z83 = z1 + z68;
    forces.a_z = z82;
    forces.a = n0;
    forces.lower_omega_x = z79;
    forces.lower_omega_y = -z80;
    forces.lower_omega_z = z81;
    forces.upper_omega_x = z76;
    forces.upper_omega_y = -z77;
    forces.upper_omega_z = z78;
    forces.omega_z = z83;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k7 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar q_a_z = state.q.a_z;
    const Scalar a_a_z = accelerations.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar a_a = accelerations.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar a_lower_omega_x = accelerations.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar a_lower_omega_y = accelerations.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar a_lower_omega_z = accelerations.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar a_upper_omega_x = accelerations.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar a_upper_omega_y = accelerations.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar a_upper_omega_z = accelerations.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar a_omega_z = accelerations.omega_z;
    const Scalar l_lambda_L2_y = multipliers.lambda_L2_y;
    const Scalar l_lambda_L2_z = multipliers.lambda_L2_z;
    const Scalar l_lambda_L3_z = multipliers.lambda_L3_z;
    const Scalar l_lambda_L3_rx = multipliers.lambda_L3_rx;
    const Scalar l_lambda_L3_ry = multipliers.lambda_L3_ry;
    const Scalar l_lambda_L5_z = multipliers.lambda_L5_z;
    const Scalar l_lambda_L5_rx = multipliers.lambda_L5_rx;
    const Scalar l_lambda_L5_ry = multipliers.lambda_L5_ry;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z0;
    });
    const Scalar z2 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z0 * z1;
    });
    const Scalar z3 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z4 = n2 * q_lower_y;
    const Scalar z5 = n2 * q_lower_z;
    const Scalar z6 = n2 * q_upper_y;
    const Scalar z7 = n2 * q_upper_z;
    const Scalar z8 = n2 * q_lower_x;
    const Scalar z9 = n2 * q_upper_x;
    const Scalar z10 = q_lower_y * z4;
    const Scalar z11 = q_lower_x * z4;
    const Scalar z12 = q_lower_w * z5;
    const Scalar z13 = q_upper_y * z6;
    const Scalar z14 = q_upper_x * z6;
    const Scalar z15 = q_upper_w * z7;
    const Scalar z16 = v_a * v_a;
    const Scalar z17 = z11 - z12;
    const Scalar z18 = q_lower_x * z8;
    const Scalar z19 = q_lower_z * z4;
    const Scalar z20 = q_lower_w * z8;
    const Scalar z21 = z14 - z15;
    const Scalar z22 = q_upper_x * z9;
    const Scalar z23 = q_upper_z * z6;
    const Scalar z24 = q_upper_w * z9;
    const Scalar z25 = n0_1 * z16;
    const Scalar z26 = q_lower_x * z5;
    const Scalar z27 = q_lower_w * z4;
    const Scalar z28 = z19 + z20;
    const Scalar z29 = n1 - z10 - z18;
    const Scalar z30 = z23 + z24;
    const Scalar z31 = q_upper_x * z7;
    const Scalar z32 = q_upper_w * z6;
    const Scalar z33 = n1 - z13 - z22;
    const Scalar z34 = q_lower_z * z5;
    const Scalar z35 = z26 - z27;
    const Scalar z36 = z26 + z27;
    const Scalar z37 = q_upper_z * z7;
    const Scalar z38 = z31 + z32;
    const Scalar z39 = n1 - z10 - z34;
    const Scalar z40 = n1 - z13 - z37;
    const Scalar z41 = k7 * z35;
    const Scalar z42 = z17 * z25 - n9_81 * z28;
    const Scalar z43 = z21 * z25 - n9_81 * z30;
    const Scalar z44 = z31 - z32;
    const Scalar z45 = k7 * z30;
    const Scalar z46 = k7 * z28;
    const Scalar z47 = z19 - z20;
    const Scalar z48 = n9_81 * z29 - z36 * z25;
    const Scalar z49 = z23 - z24;
    const Scalar z50 = n9_81 * z33 - z38 * z25;
    const Scalar z51 = n0_02 * z43;  // force on upper_cup, y
    const Scalar z52 = n0_02 * z42;  // force on lower_cup, y
    const Scalar z53 = n0_02 * z50;  // force on upper_cup, z
    const Scalar z54 = n0_02 * z48;  // force on lower_cup, z
    const Scalar z55 = z39 * z25 - n9_81 * z35;
    const Scalar z56 = z40 * z25 - n9_81 * z44;
    const Scalar z57 = k7 * z33;
    const Scalar z58 = n0_02 * z56;  // force on upper_cup, x
    const Scalar z59 = n0_02 * z55;  // force on lower_cup, x
    const Scalar z60 = z28 * z52 - z29 * z54 + z35 * z59;
    const Scalar z61 = k7 * z44;
    const Scalar z62 = v_a * z28;
    const Scalar z63 = z30 * z51 - z33 * z53 + z44 * z58;
    const Scalar z64 = v_a * z29;
    const Scalar z65 = v_a * z30;
    const Scalar z66 = z63 + z60;  // force on ring_A, z
    const Scalar z67 = v_a * z33;
    const Scalar z68 = k7 * z29;
    const Scalar z69 = v_a * z35;
    const Scalar z70 = n7_848 - z66;  // force on ring_A.1, z
    const Scalar z71 = v_a * z44;
    const Scalar z72 = v_lower_omega_x * z64;  // angular acceleration of lower_omega_x, y
    const Scalar z73 = v_lower_omega_y * z64;  // angular acceleration of lower_omega_y, x
    const Scalar z74 = v_lower_omega_z * z62 - z73;  // angular acceleration of lower_cup, x
    const Scalar z75 = v_lower_omega_x * z62;  // angular acceleration of lower_omega_x, z
    const Scalar z76 = v_lower_omega_y * z69 - z75;  // angular acceleration of lower_omega_y, z
    const Scalar z77 = v_lower_omega_z * z69 - z72;  // angular acceleration of lower_cup, y
    const Scalar z78 = k7 * z77;  // moment on lower_cup, y
    const Scalar z79 = k7 * z74;  // moment on lower_cup, x
    const Scalar z80 = v_upper_omega_x * z67;  // angular acceleration of upper_omega_x, y
    const Scalar z81 = v_upper_omega_y * z67;  // angular acceleration of upper_omega_y, x
    const Scalar z82 = v_upper_omega_z * z65 - z81;  // angular acceleration of upper_cup, x
    const Scalar z83 = v_upper_omega_x * z65;  // angular acceleration of upper_omega_x, z
    const Scalar z84 = v_upper_omega_y * z71 - z83;  // angular acceleration of upper_omega_y, z
    const Scalar z85 = v_upper_omega_z * z71 - z80;  // angular acceleration of upper_cup, y
    const Scalar z86 = k7 * z85;  // moment on upper_cup, y
    const Scalar z87 = k7 * z82;  // moment on upper_cup, x
    const Scalar z88 = k7 * z76;  // moment on lower_cup, z
    const Scalar z89 = n0_002 * q_omega_z / pi;
    const Scalar z90 = k7 * z84;  // moment on upper_cup, z
    const Scalar z91 = z30 * z45 + z33 * z57 + z44 * z61;
    const Scalar z92 = n0_0002 + z91;
    const Scalar z93 = z28 * z46 + z29 * z68 + z35 * z41;
    const Scalar z94 = n0_01 + z92;
    const Scalar z95 = n0_0002 + z93;
    const Scalar z96 = n20000 * q_a_z;
    const Scalar z97 = z96 + z70;
    const Scalar z98 = n0_0005 * v_omega_z;
    const Scalar z99 = z79 + k7 * a_lower_omega_x + a_a * z41;
    const Scalar z100 = z94 + z95;
    const Scalar z101 = n0_84 * a_a_z + z97;
    const Scalar z102 = a_lower_omega_x * z41 + a_lower_omega_y * z46 + a_upper_omega_x * z61 + a_upper_omega_y * z45
        + a_lower_omega_z * z68 + a_upper_omega_z * z57 + a_a * z100;
    const Scalar z103 = k7 * a_lower_omega_y - z78 + a_a * z46;
    const Scalar z104 = z88 + k7 * a_lower_omega_z + a_a * z68;
    const Scalar z105 = q_lower_x * q_lower_x;
    const Scalar z106 = q_lower_y * q_lower_x;
    const Scalar z107 = z87 + k7 * a_upper_omega_x + a_a * z61;
    const Scalar z108 = q_upper_x * q_upper_x;
    const Scalar z109 = q_upper_y * q_upper_x;
    const Scalar z110 = k7 * a_upper_omega_y - z86 + a_a * z45;
    const Scalar z111 = q_lower_y * q_lower_y;
    const Scalar z112 = q_lower_z * q_lower_z;
    const Scalar z113 = z90 + k7 * a_upper_omega_z + a_a * z57;
    const Scalar z114 = q_upper_y * q_upper_y;
    const Scalar z115 = q_upper_z * q_upper_z;
    const Scalar z116 = z0 * z29;
    const Scalar z117 = q_a_z - z89;
    const Scalar z118 = z111 - z112;
    const Scalar z119 = z0 * z33;
    const Scalar z120 = q_lower_w * q_lower_w - z105;
    const Scalar z121 = z112 - z105;
    const Scalar z122 = q_lower_z * q_lower_w + z106;
    const Scalar z123 = n2 * z122;
    const Scalar z124 = q_lower_z * q_lower_w - z106;
    const Scalar z125 = q_lower_w * q_lower_w - z111;
    const Scalar z126 = z3 + z98;
    const Scalar z127 = a_omega_z * z2 + z126;
    const Scalar z128 = z114 - z115;
    const Scalar z129 = z115 - z108;
    const Scalar z130 = q_upper_w * q_upper_w - z108;
    const Scalar z131 = q_upper_w * q_upper_w - z114;
    const Scalar z132 = n2 * z124;
    const Scalar z133 = n0_2 * c_a;
    const Scalar z134 = n0_2 * s_a;
    const Scalar z135 = z118 - z120;
    const Scalar z136 = z118 + z120;
    const Scalar z137 = q_upper_z * q_upper_w + z109;
    const Scalar z138 = n2 * z137;
    const Scalar z139 = q_upper_z * q_upper_w - z109;
    const Scalar z140 = n2 * z139;
    const Scalar z141 = z121 + z125;
    const Scalar z142 = z121 - z125;
    const Scalar z143 = n0_1 * s_a;
    const Scalar z144 = z128 - z130;
    const Scalar z145 = z128 + z130;
    const Scalar z146 = n0_1 * c_a;
    const Scalar z147 = z47 * z146 + z36 * z143;
    const Scalar z148 = n0_1 - z146;
    const Scalar z149 = z129 - z131;
    const Scalar z150 = z49 * z146 + z38 * z143;
    const Scalar z151 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z152 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z153 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z154 = z28 * z117 + z143 * z136 - z148 * z132;
    const Scalar z155 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z156 = z35 * z117 + z143 * z123 - z148 * z142;
    const Scalar z157 = n2 * z151;
    const Scalar z158 = n2 * z152;
    const Scalar z159 = z30 * z117 + z143 * z145 - z148 * z140;
    const Scalar z160 = z44 * z117 + z143 * z138 - z148 * z149;
    const Scalar z161 = n2 * z153;
    const Scalar z162 = z129 + z131;
    const Scalar z163 = n2 * z155;
    forces.a_z = z101 + l_lambda_L3_z * z29 + l_lambda_L5_z * z33;
    forces.a = -l_lambda_L2_y * z133 + z102 - l_lambda_L2_z * z134 + l_lambda_L3_z * z147 + l_lambda_L5_z * z150;
    forces.lower_omega_x = -l_lambda_L3_rx * z135 + z99 - l_lambda_L3_z * z154;
    forces.lower_omega_y = l_lambda_L3_ry * z141 + z103 + l_lambda_L3_z * z156;
    forces.lower_omega_z = z104 + l_lambda_L3_rx * z157 - l_lambda_L3_ry * z158;
    forces.upper_omega_x = -l_lambda_L5_rx * z144 + z107 - l_lambda_L5_z * z159;
    forces.upper_omega_y = l_lambda_L5_ry * z162 + z110 + l_lambda_L5_z * z160;
    forces.upper_omega_z = z113 + l_lambda_L5_rx * z161 - l_lambda_L5_ry * z163;
    forces.omega_z = -l_lambda_L3_z * z116 + z127 - l_lambda_L5_z * z119;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k13 = traits::constant(1e-05, 1e-05f, "1/100000");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n100000 = traits::constant(1e+05, 1e+05f, "100000/1");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n25_over_21 = traits::constant(1.1904761904761905, 1.1904762f, "25/21");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar u_C = inputs.C;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.0001909859317102744, 0.00019098593f, [&]() -> Scalar {
      return n0_3 * z0;
    });
    const Scalar z2 = traits::formula(0.0001001215854203708, 0.000100121586f, [&]() -> Scalar {
      return n0_0001 + z0 * z1;
    });
    const Scalar z3 = traits::formula(9987.856223025203, 9987.856f, [&]() -> Scalar {
      return n1 / z2;
    });
    const Scalar z4 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z5 = n2 * q_upper_y;
    const Scalar z6 = n2 * q_upper_x;
    const Scalar z7 = n2 * q_lower_y;
    const Scalar z8 = n2 * q_lower_x;
    const Scalar z9 = n2 * q_upper_z;
    const Scalar z10 = n2 * q_lower_z;
    const Scalar z11 = q_upper_y * z5;
    const Scalar z12 = q_upper_z * z5;
    const Scalar z13 = q_upper_w * z6;
    const Scalar z14 = q_lower_y * z7;
    const Scalar z15 = q_lower_z * z7;
    const Scalar z16 = q_lower_w * z8;
    const Scalar z17 = q_upper_x * z6;
    const Scalar z18 = z12 + z13;
    const Scalar z19 = q_lower_x * z8;
    const Scalar z20 = z15 + z16;
    const Scalar z21 = n1 - z11 - z17;
    const Scalar z22 = q_upper_x * z9;
    const Scalar z23 = q_upper_w * z5;
    const Scalar z24 = n1 - z14 - z19;
    const Scalar z25 = q_lower_x * z10;
    const Scalar z26 = q_lower_w * z7;
    const Scalar z27 = z22 - z23;
    const Scalar z28 = z25 - z26;
    const Scalar z29 = n0_002 * q_omega_z / pi;
    const Scalar z30 = n0_1 * s_a;
    const Scalar z31 = z15 - z16;
    const Scalar z32 = n0_1 * c_a;
    const Scalar z33 = z25 + z26;
    const Scalar z34 = q_a_z - z29;
    const Scalar z35 = q_lower_x * z7;
    const Scalar z36 = q_lower_w * z10;
    const Scalar z37 = z35 - z36;
    const Scalar z38 = q_upper_x * z5;
    const Scalar z39 = q_upper_w * z9;
    const Scalar z40 = z38 - z39;
    const Scalar z41 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w * v_lower_omega_y);
    const Scalar z42 = z22 + z23;
    const Scalar z43 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w * v_lower_omega_x);
    const Scalar z44 = q_lower_z * z10;
    const Scalar z45 = n1 - z14 - z44;
    const Scalar z46 = q_lower_y * q_lower_y;
    const Scalar z47 = q_upper_z * z9;
    const Scalar z48 = n1 - z11 - z47;
    const Scalar z49 = q_lower_z * q_lower_z;
    const Scalar z50 = q_lower_x * q_lower_x;
    const Scalar z51 = z49 - z50;
    const Scalar z52 = z46 - z49;
    const Scalar z53 = q_lower_w * q_lower_w - z46;
    const Scalar z54 = q_lower_w * q_lower_w - z50;
    const Scalar z55 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z56 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z57 = q_lower_y * q_lower_x;
    const Scalar z58 = z52 + z54;
    const Scalar z59 = q_lower_z * q_lower_w - z57;
    const Scalar z60 = q_lower_z * q_lower_w + z57;
    const Scalar z61 = z51 - z53;
    const Scalar z62 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w * v_lower_omega_z);
    const Scalar z63 = n2 * z59;
    const Scalar z64 = n2 * z60;
    const Scalar z65 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x * v_lower_omega_x);
    const Scalar z66 = z0 * z24;
    const Scalar z67 = n0_5 * (v_lower_omega_x * z41 - v_lower_omega_y * z43 + v_lower_omega_z * z65);
    const Scalar z68 = n0_1 - z32;
    const Scalar z69 = z20 * z34 + z30 * z58 - z68 * z63;
    const Scalar z70 = z28 * z34 + z30 * z64 - z68 * z61;
    const Scalar z71 = z31 * z32 + z33 * z30;
    const Scalar z72 = n0_5 * (v_lower_omega_x * z43 + v_lower_omega_y * z41 - v_lower_omega_z * z62);
    const Scalar z73 = n0_5 * (v_lower_omega_x * z62 + v_lower_omega_y * z65 + v_lower_omega_z * z43);
    const Scalar z74 = n0_5 * (v_lower_omega_x * z65 - v_lower_omega_y * z62 - v_lower_omega_z * z41);
    const Scalar z75 = n4 * z41;
    const Scalar z76 = n4 * z43;
    const Scalar z77 = n0_2 * c_a;
    const Scalar z78 = z62 * z75 + n2 * (q_lower_y * z67 + q_lower_z * z73);
    const Scalar z79 = z65 * z76 + n2 * (q_lower_x * z72 + q_lower_w * z74);
    const Scalar z80 = n4 * (q_lower_y * z73 - z41 * z41);
    const Scalar z81 = n4 * (q_lower_x * z74 - z43 * z43);
    const Scalar z82 = z80 + z81;
    const Scalar z83 = v_a * s_a;
    const Scalar z84 = n4 * q_lower_y * z41;
    const Scalar z85 = n4 * q_lower_x * z43;
    const Scalar z86 = z84 + z85;
    const Scalar z87 = n0_002 * v_omega_z / pi;
    const Scalar z88 = v_a_z - z87;
    const Scalar z89 = v_a * c_a;
    const Scalar z90 = z62 * z76 + n2 * (q_lower_z * z74 + q_lower_x * z67);
    const Scalar z91 = z78 - z79;
    const Scalar z92 = v_a * z83;
    const Scalar z93 = z65 * z75 + n2 * (q_lower_y * z72 + q_lower_w * z73);
    const Scalar z94 = n0_1 * z83;
    const Scalar z95 = n2 * (q_lower_y * z62 - q_lower_z * z41);
    const Scalar z96 = n2 * (q_lower_z * z43 - q_lower_x * z62);
    const Scalar z97 = n2 * (q_lower_x * z65 - q_lower_w * z43);
    const Scalar z98 = z95 - z97;
    const Scalar z99 = n2 * (q_lower_y * z65 - q_lower_w * z41);
    const Scalar z100 = z96 - z99;
    const Scalar z101 = n0_1 * z89;
    const Scalar z102 = v_a * z89;
    const Scalar z103 = n0_1 * z102;
    const Scalar z104 = n0_1 * z92;
    const Scalar z105 = n0_2 * z92;
    const Scalar z106 = z51 + z53;
    const Scalar z107 = z52 - z54;
    const Scalar z108 = z78 + z79;
    const Scalar z109 = n2 * z55;
    const Scalar z110 = n2 * z56;
    const Scalar z111 = q_upper_y * q_upper_y;
    const Scalar z112 = q_upper_z * q_upper_z;
    const Scalar z113 = q_upper_x * q_upper_x;
    const Scalar z114 = z112 - z113;
    const Scalar z115 = z111 - z112;
    const Scalar z116 = q_upper_w * q_upper_w - z111;
    const Scalar z117 = q_upper_w * q_upper_w - z113;
    const Scalar z118 = z114 + z116;
    const Scalar z119 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z120 = z115 - z117;
    const Scalar z121 = n2 * z119;
    const Scalar z122 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z123 = n2 * z122;
    const Scalar z124 = v_a * v_a;
    const Scalar z125 = n0_1 * z124;
    const Scalar z126 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w
        * v_upper_omega_y);
    const Scalar z127 = z37 * z125 - n9_81 * z20;
    const Scalar z128 = z40 * z125 - n9_81 * z18;
    const Scalar z129 = n9_81 * z21 - z42 * z125;
    const Scalar z130 = z45 * z125 - n9_81 * z28;
    const Scalar z131 = z48 * z125 - n9_81 * z27;
    const Scalar z132 = n9_81 * z24 - z33 * z125;
    const Scalar z133 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w
        * v_upper_omega_x);
    const Scalar z134 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x
        * v_upper_omega_x);
    const Scalar z135 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w
        * v_upper_omega_z);
    const Scalar z136 = v_a * z24;
    const Scalar z137 = v_a * z20;
    const Scalar z138 = v_lower_omega_y * z136;  // angular acceleration of lower_omega_y, x
    const Scalar z139 = v_lower_omega_x * z136;  // angular acceleration of lower_omega_x, y
    const Scalar z140 = n20000 * q_a_z;
    const Scalar z141 = n0_5 * (v_upper_omega_x * z134 - v_upper_omega_y * z135 - v_upper_omega_z * z126);
    const Scalar z142 = v_lower_omega_z * z137 - z138;  // angular acceleration of lower_cup, x
    const Scalar z143 = v_lower_omega_x * z137;  // angular acceleration of lower_omega_x, z
    const Scalar z144 = n0_5 * (v_upper_omega_x * z126 - v_upper_omega_y * z133 + v_upper_omega_z * z134);
    const Scalar z145 = n0_5 * (v_upper_omega_x * z133 + v_upper_omega_y * z126 - v_upper_omega_z * z135);
    const Scalar z146 = n4 * z126;
    const Scalar z147 = v_a * z28;
    const Scalar z148 = v_lower_omega_z * z147 - z139;  // angular acceleration of lower_cup, y
    const Scalar z149 = v_lower_omega_y * z147 - z143;  // angular acceleration of lower_omega_y, z
    const Scalar z150 = v_a * z18;
    const Scalar z151 = v_a * z21;
    const Scalar z152 = z90 + z93;
    const Scalar z153 = z30 * z91 - z34 * z82 + z68 * z152 + z31 * z104 - z33 * z103 + n2 * (z86 * z88 + z98 * z101
        - z100 * z94);
    const Scalar z154 = z90 - z93;
    const Scalar z155 = n0_02 * z128;  // force on upper_cup, y
    const Scalar z156 = n0_02 * z127;  // force on lower_cup, y
    const Scalar z157 = n0_02 * z129;  // force on upper_cup, z
    const Scalar z158 = n0_02 * z132;  // force on lower_cup, z
    const Scalar z159 = n0_02 * z131;  // force on upper_cup, x
    const Scalar z160 = z18 * z155 - z21 * z157 + z27 * z159;
    const Scalar z161 = n0_02 * z130;  // force on lower_cup, x
    const Scalar z162 = z20 * z156 - z24 * z158 + z28 * z161;
    const Scalar z163 = k13 * z142;  // moment on lower_cup, x
    const Scalar z164 = k13 * z148;  // moment on lower_cup, y
    const Scalar z165 = k13 * z149;  // moment on lower_cup, z
    const Scalar z166 = n0_5 * (v_upper_omega_x * z135 + v_upper_omega_y * z134 + v_upper_omega_z * z133);
    const Scalar z167 = z160 + z162;  // force on ring_A, z
    const Scalar z168 = n4 * z133;
    const Scalar z169 = k13 * z21;
    const Scalar z170 = v_a * z27;
    const Scalar z171 = v_upper_omega_x * z150;  // angular acceleration of upper_omega_x, z
    const Scalar z172 = n7_848 - z167;  // force on ring_A.1, z
    const Scalar z173 = v_upper_omega_y * z170 - z171;  // angular acceleration of upper_omega_y, z
    const Scalar z174 = v_upper_omega_y * z151;  // angular acceleration of upper_omega_y, x
    const Scalar z175 = v_upper_omega_z * z150 - z174;  // angular acceleration of upper_cup, x
    const Scalar z176 = z140 + z172;
    const Scalar z177 = v_upper_omega_x * z151;  // angular acceleration of upper_omega_x, y
    const Scalar z178 = v_upper_omega_z * z170 - z177;  // angular acceleration of upper_cup, y
    const Scalar z179 = k13 * z173;  // moment on upper_cup, z
    const Scalar z180 = n0_0005 * v_omega_z;
    const Scalar z181 = z4 + z180;
    const Scalar z182 = k13 * z175;  // moment on upper_cup, x
    const Scalar z183 = z135 * z146 + n2 * (q_upper_y * z144 + q_upper_z * z166);
    const Scalar z184 = z135 * z168 + n2 * (q_upper_z * z141 + q_upper_x * z144);
    const Scalar z185 = z134 * z168 + n2 * (q_upper_x * z145 + q_upper_w * z141);
    const Scalar z186 = z134 * z146 + n2 * (q_upper_y * z145 + q_upper_w * z166);
    const Scalar z187 = z183 + z185;
    const Scalar z188 = z184 - z186;
    const Scalar z189 = u_C - z181;
    const Scalar z190 = k13 * z178;  // moment on upper_cup, y
    const Scalar z191 = k13 * z18;
    const Scalar z192 = k13 * z20;
    const Scalar z193 = k13 * z24;
    const Scalar z194 = k13 * z27;
    const Scalar z195 = z18 * z191 + z21 * z169 + z27 * z194;
    const Scalar z196 = k13 * z28;
    const Scalar z197 = z20 * z192 + z24 * z193 + z28 * z196;
    const Scalar z198 = n100000 * z169;
    const Scalar z199 = n100000 * z191;
    const Scalar z200 = n100000 * z194;
    const Scalar z201 = n100000 * z193;
    const Scalar z202 = n100000 * z192;
    const Scalar z203 = n100000 * z196;
    const Scalar z204 = z120 * z200 - z123 * z198;
    const Scalar z205 = n0_0002 + z195;
    const Scalar z206 = n0_0002 + z197;
    const Scalar z207 = z106 * z202 - z109 * z201;
    const Scalar z208 = n0_01 + z205;
    const Scalar z209 = z118 * z199 - z121 * z198;
    const Scalar z210 = z107 * z203 - z110 * z201;
    const Scalar z211 = z208 + z206;
    const Scalar z212 = n25_over_21 * z24;
    const Scalar z213 = z71 + z69 * z203 - z70 * z202;
    const Scalar z214 = z169 * z198 - z211;
    const Scalar z215 = z3 * z66;
    const Scalar z216 = z191 * z199 + z214;
    const Scalar z217 = z194 * z200 + z216;
    const Scalar z218 = z193 * z201 + z217;
    const Scalar z219 = z192 * z202 + z218;
    const Scalar z220 = z196 * z203 + z219;
    const Scalar z221 = n1 / z220;
    const Scalar z222 = z77 * z221;
    const Scalar z223 = z221 * z213;
    const Scalar z224 = z221 * z210;
    const Scalar z225 = z221 * z207;
    const Scalar z226 = z221 * z204;
    const Scalar z227 = z221 * z209;
    const Scalar z228 = z203 * z222;
    const Scalar z229 = z202 * z222;
    const Scalar z230 = z201 * z222;
    const Scalar z231 = z200 * z222;
    const Scalar z232 = z199 * z222;
    const Scalar z233 = z198 * z222;
    const Scalar z234 = n100000 * z69 - z203 * z223;
    const Scalar z235 = n100000 * z70 + z202 * z223;
    const Scalar z236 = z201 * z223;
    const Scalar z237 = z200 * z223;
    const Scalar z238 = z199 * z223;
    const Scalar z239 = z198 * z223;
    const Scalar z240 = n100000 * z107 - z203 * z224;
    const Scalar z241 = z202 * z224;
    const Scalar z242 = n100000 * z110 + z201 * z224;
    const Scalar z243 = z200 * z224;
    const Scalar z244 = z199 * z224;
    const Scalar z245 = z198 * z224;
    const Scalar z246 = z203 * z225;
    const Scalar z247 = n100000 * z106 - z202 * z225;
    const Scalar z248 = n100000 * z109 + z201 * z225;
    const Scalar z249 = z200 * z225;
    const Scalar z250 = z199 * z225;
    const Scalar z251 = z198 * z225;
    const Scalar z252 = z203 * z226;
    const Scalar z253 = z202 * z226;
    const Scalar z254 = z201 * z226;
    const Scalar z255 = n100000 * z120 - z200 * z226;
    const Scalar z256 = z199 * z226;
    const Scalar z257 = n100000 * z123 + z198 * z226;
    const Scalar z258 = z203 * z227;
    const Scalar z259 = z202 * z227;
    const Scalar z260 = z201 * z227;
    const Scalar z261 = z200 * z227;
    const Scalar z262 = n100000 * z118 - z199 * z227;
    const Scalar z263 = n100000 * z121 + z198 * z227;
    const Scalar z264 = z77 * z222;
    const Scalar z265 = z71 * z222 + z69 * z228 - z70 * z229;
    const Scalar z266 = z107 * z228 - z110 * z230;
    const Scalar z267 = z120 * z249 - z123 * z251;
    const Scalar z268 = z24 * z212 + z66 * z215 - z71 * z223 + z69 * z234 + z70 * z235;
    const Scalar z269 = z118 * z262 + z121 * z263;
    const Scalar z270 = z118 * z256 - z121 * z257;
    const Scalar z271 = n1 / z269;
    const Scalar z272 = z120 * z255 + z123 * z257;
    const Scalar z273 = z118 * z250 - z121 * z251;
    const Scalar z274 = z106 * z247 + z109 * z248;
    const Scalar z275 = z106 * z241 - z109 * z242;
    const Scalar z276 = z120 * z243 - z123 * z245;
    const Scalar z277 = z118 * z244 - z121 * z245;
    const Scalar z278 = z107 * z240 + z110 * z242;
    const Scalar z279 = z110 * z236 + z107 * z234;
    const Scalar z280 = z270 * z271;
    const Scalar z281 = z273 * z271;
    const Scalar z282 = z277 * z271;
    const Scalar z283 = z106 * z235 - z109 * z236;
    const Scalar z284 = z272 - z270 * z280;
    const Scalar z285 = z267 + z273 * z280;
    const Scalar z286 = z274 - z273 * z281;
    const Scalar z287 = z275 + z277 * z281;
    const Scalar z288 = n1 / z284;
    const Scalar z289 = z276 + z277 * z280;
    const Scalar z290 = z278 - z277 * z282;
    const Scalar z291 = z120 * z237 - z123 * z239;
    const Scalar z292 = z118 * z238 - z121 * z239;
    const Scalar z293 = z279 - z292 * z282;
    const Scalar z294 = z283 + z292 * z281;
    const Scalar z295 = z291 + z292 * z280;
    const Scalar z296 = z292 * z271;
    const Scalar z297 = z268 - z292 * z296;
    const Scalar z298 = z106 * z229 - z109 * z230;
    const Scalar z299 = z120 * z231 - z123 * z233;
    const Scalar z300 = z285 * z288;
    const Scalar z301 = z289 * z288;
    const Scalar z302 = z295 * z288;
    const Scalar z303 = z118 * z232 - z121 * z233;
    const Scalar z304 = z286 - z285 * z300;
    const Scalar z305 = z287 + z289 * z300;
    const Scalar z306 = z290 - z289 * z301;
    const Scalar z307 = z293 - z295 * z301;
    const Scalar z308 = n1 / z304;
    const Scalar z309 = z294 + z295 * z300;
    const Scalar z310 = z297 - z295 * z302;
    const Scalar z311 = n25_over_21 * z176;
    const Scalar z312 = n100000 * z163;
    const Scalar z313 = z265 + z303 * z296;
    const Scalar z314 = z266 + z303 * z282;
    const Scalar z315 = z298 + z303 * z281;
    const Scalar z316 = z299 + z303 * z280;
    const Scalar z317 = n100000 * z164;
    const Scalar z318 = z313 + z316 * z302;
    const Scalar z319 = z314 + z316 * z301;
    const Scalar z320 = z315 + z316 * z300;
    const Scalar z321 = n100000 * z165;
    const Scalar z322 = n100000 * z182;
    const Scalar z323 = z303 * z271;
    const Scalar z324 = z107 * z312 - z108 - z110 * z321;
    const Scalar z325 = z264 + z303 * z323;
    const Scalar z326 = z278 + z274 + z272 + z269;
    const Scalar z327 = z154 + z109 * z321 + z106 * z317;
    const Scalar z328 = z264 - z268;
    const Scalar z329 = n100000 * z179;
    const Scalar z330 = z120 * z322 - z187 - z123 * z329;
    const Scalar z331 = z3 * z189;
    const Scalar z332 = z24 * z311 - z69 * z312 - z70 * z317 + z66 * z331 + z153;
    const Scalar z333 = n100000 * z190;
    const Scalar z334 = z188 + z121 * z329 + z118 * z333;
    const Scalar z335 = z305 * z308;
    const Scalar z336 = z306 - z305 * z335;
    const Scalar z337 = z307 - z309 * z335;
    const Scalar z338 = z319 + z320 * z335;
    const Scalar z339 = z280 * z334 - z330;
    const Scalar z340 = n1 / z336;
    const Scalar z341 = z309 * z308;
    const Scalar z342 = z310 - z309 * z341;
    const Scalar z343 = z318 + z320 * z341;
    const Scalar z344 = z327 + z281 * z334 + z300 * z339;
    const Scalar z345 = z316 * z288;
    const Scalar z346 = z325 + z316 * z345;
    const Scalar z347 = z282 * z334 - z324 + z301 * z339 + z335 * z344;
    const Scalar z348 = z320 * z308;
    const Scalar z349 = z346 + z320 * z348;
    const Scalar z350 = z338 * z340;
    const Scalar z351 = z337 * z340;
    const Scalar z352 = z349 + z338 * z350;
    const Scalar z353 = z343 - z338 * z351;
    const Scalar z354 = z342 - z337 * z351;
    const Scalar z355 = z332 + z296 * z334 + z302 * z339 + z341 * z344 - z351 * z347;
    const Scalar z356 = n1 / z354;
    const Scalar z357 = z353 * z356;
    const Scalar z358 = z352 + z353 * z357;
    const Scalar z359 = z105 + z323 * z334 + z345 * z339 + z348 * z344 + z350 * z347 + z357 * z355;
    const Scalar z360 = n1 / z358;
    const Scalar z361 = z360 * z359;
    const Scalar z362 = z356 * z355 - z357 * z361;
    const Scalar z363 = z340 * z347 - z350 * z361 - z351 * z362;
    const Scalar z364 = z212 * z362 - z311;
    const Scalar z365 = z215 * z362 - z331;
    const Scalar z366 = z308 * z344 - z348 * z361 + z341 * z362 + z335 * z363;
    const Scalar z367 = z288 * z339 - z345 * z361 + z302 * z362 + z301 * z363 + z300 * z366;
    const Scalar z368 = z271 * z334 - z323 * z361 + z296 * z362 + z282 * z363 + z281 * z366 + z280 * z367;
    const Scalar z369 = z222 * z361 - z223 * z362 - z224 * z363 - z225 * z366 - z226 * z367 - z227 * z368;
    const Scalar z370 = z312 + z228 * z361 + z234 * z362 + z240 * z363 - z246 * z366 - z252 * z367 - z258 * z368;
    const Scalar z371 = z229 * z361 - z317 - z235 * z362 - z241 * z363 + z247 * z366 - z253 * z367 - z259 * z368;
    const Scalar z372 = z321 + z230 * z361 - z236 * z362 - z242 * z363 - z248 * z366 - z254 * z367 - z260 * z368;
    const Scalar z373 = z322 + z231 * z361 - z237 * z362 - z243 * z363 - z249 * z366 + z255 * z367 - z261 * z368;
    const Scalar z374 = z232 * z361 - z333 - z238 * z362 - z244 * z363 - z250 * z366 - z256 * z367 + z262 * z368;
    const Scalar z375 = z329 + z233 * z361 - z239 * z362 - z245 * z363 - z251 * z366 - z257 * z367 - z263 * z368;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.a_z = z364;
    accelerations.a = z369;
    accelerations.lower_omega_x = -z370;
    accelerations.lower_omega_y = -z371;
    accelerations.lower_omega_z = -z372;
    accelerations.upper_omega_x = -z373;
    accelerations.upper_omega_y = -z374;
    accelerations.upper_omega_z = -z375;
    accelerations.omega_z = -z365;
    multipliers.lambda_L2_y = -z361;
    multipliers.lambda_L2_z = n0;
    multipliers.lambda_L2_ry = n0;
    multipliers.lambda_L2_rz = n0;
    multipliers.lambda_L3_z = -z362;
    multipliers.lambda_L3_rx = -z363;
    multipliers.lambda_L3_ry = z366;
    multipliers.lambda_L5_z = n0;
    multipliers.lambda_L5_rx = -z367;
    multipliers.lambda_L5_ry = z368;
    const Scalar bound0_ = roundings_ * z328;
    const Scalar bound1_ = roundings_ * z326;
    if (!(traits::regular(-z220, z211) && traits::regular(z2, z2) && traits::regular(-z358, -bound0_)
        && traits::regular(z354, -bound0_) && traits::regular(z336, bound1_) && traits::regular(z304, bound1_)
        && traits::regular(z284, bound1_) && traits::regular(z269, bound1_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.a_z * accelerations.a * accelerations.lower_omega_x
        * accelerations.lower_omega_y * accelerations.lower_omega_z * accelerations.upper_omega_x
        * accelerations.upper_omega_y * accelerations.upper_omega_z * accelerations.omega_z * multipliers.lambda_L2_y
        * multipliers.lambda_L3_z * multipliers.lambda_L3_rx * multipliers.lambda_L3_ry * multipliers.lambda_L5_rx
        * multipliers.lambda_L5_ry;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_005 = traits::constant(0.005, 0.005f, "1/200");
    const Scalar k7 = traits::constant(5e-05, 5e-05f, "1/20000");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar k9 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n8_2404 = traits::constant(8.2404, 8.2404f, "20601/2500");
    const Scalar n10000 = traits::constant(10000.0, 10000.0f, "10000/1");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar u_C = inputs.C;
    const Scalar pi = traits::pi();
    const Scalar z0 = n2 * q_lower_y;
    const Scalar z1 = n2 * q_upper_y;
    const Scalar z2 = n2 * q_lower_z;
    const Scalar z3 = n2 * q_lower_x;
    const Scalar z4 = n2 * q_upper_z;
    const Scalar z5 = n2 * q_upper_x;
    const Scalar z6 = q_lower_y * z0;
    const Scalar z7 = q_upper_y * z1;
    const Scalar z8 = q_lower_z * z2;
    const Scalar z9 = q_lower_z * z0;
    const Scalar z10 = q_lower_w * z3;
    const Scalar z11 = q_lower_x * z2;
    const Scalar z12 = q_lower_w * z0;
    const Scalar z13 = q_upper_z * z4;
    const Scalar z14 = q_upper_z * z1;
    const Scalar z15 = q_upper_w * z5;
    const Scalar z16 = q_upper_x * z4;
    const Scalar z17 = q_upper_w * z1;
    const Scalar z18 = q_lower_x * z3;
    const Scalar z19 = q_upper_x * z5;
    const Scalar z20 = q_lower_x * z0;
    const Scalar z21 = q_lower_w * z2;
    const Scalar z22 = z9 - z10;
    const Scalar z23 = z9 + z10;
    const Scalar z24 = z11 - z12;
    const Scalar z25 = q_upper_x * z1;
    const Scalar z26 = q_upper_w * z4;
    const Scalar z27 = z14 - z15;
    const Scalar z28 = z14 + z15;
    const Scalar z29 = z16 - z17;
    const Scalar z30 = n0_1 * v_a;
    const Scalar z31 = n1 - z6 - z18;
    const Scalar z32 = n1 - z7 - z19;
    const Scalar z33 = z20 + z21;
    const Scalar z34 = n1 - z8 - z18;
    const Scalar z35 = z25 + z26;
    const Scalar z36 = n1 - z13 - z19;
    const Scalar z37 = v_a * z24;
    const Scalar z38 = v_a * z23;
    const Scalar z39 = v_a * z31;
    const Scalar z40 = v_a * z29;
    const Scalar z41 = v_a * z28;
    const Scalar z42 = v_a * z32;
    const Scalar z43 = v_a_z * z24 + z33 * z30;
    const Scalar z44 = v_a_z * z23 + z34 * z30;
    const Scalar z45 = z22 * z30 + v_a_z * z31;
    const Scalar z46 = v_lower_omega_x + z37;  // angular velocity of lower_omega_x, x
    const Scalar z47 = v_lower_omega_y + z38;  // angular velocity of lower_omega_y, y
    const Scalar z48 = v_lower_omega_z + z39;  // angular velocity of lower_cup, z
    const Scalar z49 = v_a_z * z29 + z35 * z30;
    const Scalar z50 = v_a_z * z28 + z36 * z30;
    const Scalar z51 = z27 * z30 + v_a_z * z32;
    const Scalar z52 = v_upper_omega_x + z40;  // angular velocity of upper_omega_x, x
    const Scalar z53 = v_upper_omega_y + z41;  // angular velocity of upper_omega_y, y
    const Scalar z54 = v_upper_omega_z + z42;  // angular velocity of upper_cup, z
    const Scalar z55 = n0_002 * q_omega_z / pi;
    const Scalar z56 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z57 = n0_0005 * v_omega_z;
    result.kinetic = n0_4 * v_a_z * v_a_z + n0_005 * v_a * v_a + k7 * v_omega_z * v_omega_z + n0_15 * z56 * z56 + k9
        * (z46 * z46 + z47 * z47 + z48 * z48 + z52 * z52 + z53 * z53 + z54 * z54) + n0_01 * (z43 * z43 + z44 * z44 + z45
        * z45 + z49 * z49 + z50 * z50 + z51 * z51);
    result.force_function = -q_a_z * (n8_2404 + n10000 * q_a_z) - n2_943 * z55;
    result.power = v_omega_z * (u_C - z57);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_a = state.q.a;
    const Scalar v_a = state.v.a;
    const Scalar q_lower_y = state.q.lower_y;
    const Scalar q_lower_z = state.q.lower_z;
    const Scalar q_lower_x = state.q.lower_x;
    const Scalar q_lower_w = state.q.lower_w;
    const Scalar v_lower_omega_x = state.v.lower_omega_x;
    const Scalar v_lower_omega_y = state.v.lower_omega_y;
    const Scalar v_lower_omega_z = state.v.lower_omega_z;
    const Scalar q_upper_y = state.q.upper_y;
    const Scalar q_upper_z = state.q.upper_z;
    const Scalar q_upper_x = state.q.upper_x;
    const Scalar q_upper_w = state.q.upper_w;
    const Scalar v_upper_omega_x = state.v.upper_omega_x;
    const Scalar v_upper_omega_y = state.v.upper_omega_y;
    const Scalar v_upper_omega_z = state.v.upper_omega_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    Scalar s_a, c_a;
    traits::sincos(q_a, s_a, c_a);
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = n0_5 * (q_lower_z * v_lower_omega_x - q_lower_x * v_lower_omega_z + q_lower_w * v_lower_omega_y);
    const Scalar z2 = n0_5 * (q_lower_y * v_lower_omega_z - q_lower_z * v_lower_omega_y + q_lower_w * v_lower_omega_x);
    const Scalar z3 = n0_5 * (q_lower_y * v_lower_omega_x - q_lower_x * v_lower_omega_y - q_lower_w * v_lower_omega_z);
    const Scalar z4 = n0_5 * (q_lower_y * v_lower_omega_y + q_lower_z * v_lower_omega_z + q_lower_x * v_lower_omega_x);
    const Scalar z5 = n2 * q_lower_y;
    const Scalar z6 = n2 * q_upper_y;
    const Scalar z7 = q_lower_y * z5;
    const Scalar z8 = n2 * q_lower_x;
    const Scalar z9 = q_upper_y * z6;
    const Scalar z10 = n2 * q_upper_x;
    const Scalar z11 = q_lower_x * z8;
    const Scalar z12 = q_upper_x * z10;
    const Scalar z13 = n0_002 * v_omega_z / pi;
    const Scalar z14 = n1 - z7 - z11;
    const Scalar z15 = n1 - z9 - z12;
    const Scalar z16 = n0_002 * q_omega_z / pi;
    const Scalar z17 = n0_1 * s_a;
    const Scalar z18 = n4 * q_lower_y * z1;
    const Scalar z19 = n4 * q_lower_x * z2;
    const Scalar z20 = v_a_z - z13;
    const Scalar z21 = q_a_z - z16;
    const Scalar z22 = z18 + z19;
    const Scalar z23 = n0_1 * c_a;
    const Scalar z24 = n2 * (q_lower_y * z3 - q_lower_z * z1);
    const Scalar z25 = n2 * (q_lower_x * z4 - q_lower_w * z2);
    const Scalar z26 = v_a * s_a;
    const Scalar z27 = z24 - z25;
    const Scalar z28 = q_lower_z * z5;
    const Scalar z29 = q_lower_w * z5;
    const Scalar z30 = n0_2 * s_a;
    const Scalar z31 = q_lower_w * z8;
    const Scalar z32 = q_lower_z * z8;
    const Scalar z33 = q_upper_z * z6;
    const Scalar z34 = q_upper_w * z6;
    const Scalar z35 = q_upper_w * z10;
    const Scalar z36 = q_upper_z * z10;
    const Scalar z37 = v_a * c_a;
    const Scalar z38 = q_lower_y * q_lower_y;
    const Scalar z39 = q_lower_x * q_lower_x;
    const Scalar z40 = z28 - z31;
    const Scalar z41 = z28 + z31;
    const Scalar z42 = q_lower_y * q_lower_x;
    const Scalar z43 = z33 - z35;
    const Scalar z44 = z33 + z35;
    const Scalar z45 = z32 - z29;
    const Scalar z46 = z32 + z29;
    const Scalar z47 = z0 * z14;
    const Scalar z48 = n0_5 * (v_lower_omega_x * z3 + v_lower_omega_y * z4 + v_lower_omega_z * z2);
    const Scalar z49 = z36 - z34;
    const Scalar z50 = z36 + z34;
    const Scalar z51 = n0_5 * (v_lower_omega_x * z4 - v_lower_omega_y * z3 - v_lower_omega_z * z1);
    const Scalar z52 = n4 * (q_lower_y * z48 - z1 * z1);
    const Scalar z53 = n0_2 * z37;
    const Scalar z54 = n0_2 * z26;
    const Scalar z55 = z40 * z23 + z46 * z17;
    const Scalar z56 = n0_1 - z23;
    const Scalar z57 = z14 * z21 + z40 * z17 + z46 * z56;
    const Scalar z58 = v_a * z26;
    const Scalar z59 = n0_1 * z26;
    const Scalar z60 = n0_2 * z58;
    const Scalar z61 = n0_1 * z58;
    const Scalar z62 = n0_1 * z37;
    const Scalar z63 = v_a * z37;
    const Scalar z64 = n0_2 * z63;
    const Scalar z65 = n0_1 * z63;
    const Scalar z66 = n2 * (q_lower_z * z2 - q_lower_x * z3);
    const Scalar z67 = n2 * (q_lower_y * z4 - q_lower_w * z1);
    const Scalar z68 = q_lower_z * q_lower_z - z38;
    const Scalar z69 = q_lower_w * q_lower_w - z38;
    const Scalar z70 = q_lower_w * q_lower_w - z39;
    const Scalar z71 = q_lower_z * q_lower_z - z39;
    const Scalar z72 = q_lower_z * q_lower_w + z42;
    const Scalar z73 = n2 * z72;
    const Scalar z74 = q_lower_z * q_lower_w - z42;
    const Scalar z75 = n2 * z74;
    const Scalar z76 = z66 - z67;
    const Scalar z77 = z14 * z20 - z21 * z22 - z17 * z27 + z40 * z62 + z46 * z59 + z56 * z76;
    const Scalar z78 = z68 - z70;
    const Scalar z79 = z41 * z21 - z17 * z78 - z56 * z75;
    const Scalar z80 = n0_2 * c_a;
    const Scalar z81 = n0_1 - z80;
    const Scalar z82 = n0_5 * (v_lower_omega_x * z1 - v_lower_omega_y * z2 + v_lower_omega_z * z4);
    const Scalar z83 = n0_1 + z81;
    const Scalar z84 = z24 + z25;
    const Scalar z85 = z68 + z70;
    const Scalar z86 = z66 + z67;
    const Scalar z87 = z43 * z23 + z50 * z17;
    const Scalar z88 = z71 + z69;
    const Scalar z89 = z71 - z69;
    const Scalar z90 = z45 * z21 + z17 * z73 - z56 * z89;
    const Scalar z91 = z15 * z21 + z43 * z17 + z50 * z56;
    const Scalar z92 = n0_5 * (q_upper_z * v_upper_omega_x - q_upper_x * v_upper_omega_z + q_upper_w * v_upper_omega_y);
    const Scalar z93 = n0_5 * (q_upper_y * v_upper_omega_z - q_upper_z * v_upper_omega_y + q_upper_w * v_upper_omega_x);
    const Scalar z94 = n0_5 * (q_upper_y * v_upper_omega_x - q_upper_x * v_upper_omega_y - q_upper_w * v_upper_omega_z);
    const Scalar z95 = n0_5 * (q_upper_y * v_upper_omega_y + q_upper_z * v_upper_omega_z + q_upper_x * v_upper_omega_x);
    const Scalar z96 = n0_5 * (v_lower_omega_x * z2 + v_lower_omega_y * z1 - v_lower_omega_z * z3);
    const Scalar z97 = n4 * z1;
    const Scalar z98 = n4 * z2;
    const Scalar z99 = n4 * (q_lower_x * z51 - z2 * z2);
    const Scalar z100 = z52 + z99;
    const Scalar z101 = z3 * z97 + n2 * (q_lower_y * z82 + q_lower_z * z48);
    const Scalar z102 = z3 * z98 + n2 * (q_lower_z * z51 + q_lower_x * z82);
    const Scalar z103 = z4 * z98 + n2 * (q_lower_x * z96 + q_lower_w * z51);
    const Scalar z104 = z4 * z97 + n2 * (q_lower_y * z96 + q_lower_w * z48);
    const Scalar z105 = z101 + z103;
    const Scalar z106 = z101 - z103;
    const Scalar z107 = z102 - z104;
    const Scalar z108 = z102 + z104;
    const Scalar z109 = n4 * q_upper_y * z92;
    const Scalar z110 = z17 * z106 - z21 * z100 + z56 * z108 + z40 * z61 - z46 * z65 + n2 * (z22 * z20 + z27 * z62 - z76
        * z59);
    const Scalar z111 = n4 * q_upper_x * z93;
    const Scalar z112 = z109 + z111;
    const Scalar z113 = n2 * (q_upper_y * z94 - q_upper_z * z92);
    const Scalar z114 = n2 * (q_upper_x * z95 - q_upper_w * z93);
    const Scalar z115 = z113 - z114;
    const Scalar z116 = q_upper_y * q_upper_y;
    const Scalar z117 = q_upper_x * q_upper_x;
    const Scalar z118 = q_upper_y * q_upper_x;
    const Scalar z119 = n2 * (q_upper_z * z93 - q_upper_x * z94);
    const Scalar z120 = n2 * (q_upper_y * z95 - q_upper_w * z92);
    const Scalar z121 = q_upper_z * q_upper_z - z116;
    const Scalar z122 = q_upper_w * q_upper_w - z116;
    const Scalar z123 = q_upper_w * q_upper_w - z117;
    const Scalar z124 = q_upper_z * q_upper_z - z117;
    const Scalar z125 = q_upper_z * q_upper_w + z118;
    const Scalar z126 = n2 * z125;
    const Scalar z127 = q_upper_z * q_upper_w - z118;
    const Scalar z128 = n2 * z127;
    const Scalar z129 = z119 - z120;
    const Scalar z130 = z15 * z20 - z21 * z112 - z17 * z115 + z43 * z62 + z50 * z59 + z56 * z129;
    const Scalar z131 = z121 - z123;
    const Scalar z132 = z44 * z21 - z17 * z131 - z56 * z128;
    const Scalar z133 = z124 - z122;
    const Scalar z134 = z49 * z21 + z17 * z126 - z56 * z133;
    const Scalar z135 = q_lower_y * q_lower_w - q_lower_z * q_lower_x;
    const Scalar z136 = n2 * z135;
    const Scalar z137 = q_lower_y * q_lower_z + q_lower_x * q_lower_w;
    const Scalar z138 = z113 + z114;
    const Scalar z139 = z121 + z123;
    const Scalar z140 = z119 + z120;
    const Scalar z141 = z124 + z122;
    const Scalar z142 = n0_5 * (v_upper_omega_x * z92 - v_upper_omega_y * z93 + v_upper_omega_z * z95);
    const Scalar z143 = n2 * z137;
    const Scalar z144 = n0_5 * (v_upper_omega_x * z93 + v_upper_omega_y * z92 - v_upper_omega_z * z94);
    const Scalar z145 = z0 * z15;
    const Scalar z146 = n0_5 * (v_upper_omega_x * z94 + v_upper_omega_y * z95 + v_upper_omega_z * z93);
    const Scalar z147 = n0_5 * (v_upper_omega_x * z95 - v_upper_omega_y * z94 - v_upper_omega_z * z92);
    const Scalar z148 = n4 * z92;
    const Scalar z149 = n4 * (q_upper_y * z146 - z92 * z92);
    const Scalar z150 = n4 * z93;
    const Scalar z151 = n4 * (q_upper_x * z147 - z93 * z93);
    const Scalar z152 = z94 * z148 + n2 * (q_upper_y * z142 + q_upper_z * z146);
    const Scalar z153 = z94 * z150 + n2 * (q_upper_z * z147 + q_upper_x * z142);
    const Scalar z154 = z95 * z150 + n2 * (q_upper_x * z144 + q_upper_w * z147);
    const Scalar z155 = z95 * z148 + n2 * (q_upper_y * z144 + q_upper_w * z146);
    const Scalar z156 = z152 - z154;
    const Scalar z157 = z152 + z154;
    const Scalar z158 = z149 + z151;
    const Scalar z159 = z153 + z155;
    const Scalar z160 = q_upper_y * q_upper_w - q_upper_z * q_upper_x;
    const Scalar z161 = q_upper_y * q_upper_z + q_upper_x * q_upper_w;
    const Scalar z162 = z17 * z156 - z21 * z158 + z56 * z159 + z43 * z61 - z50 * z65 + n2 * (z20 * z112 + z62 * z115
        - z59 * z129);
    const Scalar z163 = n2 * z160;
    const Scalar z164 = n2 * z161;
    const Scalar z165 = z153 - z155;
    result.value[0] = z30;
    result.rate[0] = z53;
    result.gamma[0] = -z60;
    result.value[1] = z83;
    result.rate[1] = z54;
    result.gamma[1] = z64;
    result.value[2] = n0;
    result.rate[2] = n0;
    result.gamma[2] = n0;
    result.value[3] = n0;
    result.rate[3] = n0;
    result.gamma[3] = n0;
    result.value[4] = -z57;
    result.rate[4] = -z77;
    result.gamma[4] = z110;
    result.value[5] = -z41;
    result.rate[5] = z84;
    result.gamma[5] = z105;
    result.value[6] = z45;
    result.rate[6] = z86;
    result.gamma[6] = -z107;
    result.value[7] = -z91;
    result.rate[7] = -z130;
    result.gamma[7] = z162;
    result.value[8] = -z44;
    result.rate[8] = z138;
    result.gamma[8] = z157;
    result.value[9] = z49;
    result.rate[9] = z140;
    result.gamma[9] = -z165;
    result.jacobian[0] = n0;
    result.jacobian[1] = n0;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = -z14;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = -z15;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = z80;
    result.jacobian[11] = z30;
    result.jacobian[12] = n0;
    result.jacobian[13] = n0;
    result.jacobian[14] = -z55;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = -z87;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = n0;
    result.jacobian[21] = n0;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = z79;
    result.jacobian[25] = -z85;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = -z90;
    result.jacobian[35] = n0;
    result.jacobian[36] = -z88;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = n0;
    result.jacobian[45] = -z136;
    result.jacobian[46] = z143;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = n0;
    result.jacobian[53] = n0;
    result.jacobian[54] = n0;
    result.jacobian[55] = n0;
    result.jacobian[56] = n0;
    result.jacobian[57] = z132;
    result.jacobian[58] = -z139;
    result.jacobian[59] = n0;
    result.jacobian[60] = n0;
    result.jacobian[61] = n0;
    result.jacobian[62] = n0;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n0;
    result.jacobian[67] = -z134;
    result.jacobian[68] = n0;
    result.jacobian[69] = -z141;
    result.jacobian[70] = n0;
    result.jacobian[71] = n0;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n0;
    result.jacobian[76] = n0;
    result.jacobian[77] = n0;
    result.jacobian[78] = -z163;
    result.jacobian[79] = z164;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = z47;
    result.jacobian[85] = n0;
    result.jacobian[86] = n0;
    result.jacobian[87] = z145;
    result.jacobian[88] = n0;
    result.jacobian[89] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 11>&>(coordinate_rates));
    visitor(Description::kernels[1], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[2], KernelFunction<void, std::array<Scalar, 81>&>(mass_matrix));
    visitor(Description::kernels[3], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[4],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[5],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[6], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[7], KernelFunction<void, Constraints&>(constraints));
  }
};

}  // namespace model_making_press
