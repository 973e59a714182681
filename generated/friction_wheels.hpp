// SPDX-License-Identifier: MIT-0
// friction_wheels: Two friction wheels rolling on each other without slipping
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                5               16          0             0                  2       0     25      25
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                1          0             0                  0       0      1       1
//   inverse_dynamics          3                5          0             0                  0       0      8       8
//   forward_dynamics          3                8          0             0                  0       0     11      11
//   energy                    2                7          0             0                  0       0      9       9
//   constraints               1                2          0             0                  0       0      3       3
//   linearisation             8               10          0             0                  0       0     18      19
//
// Not computed because this mechanism does not need it:
//   kinematics: of 78 results 58 vanish identically, 5 repeat another up to sign
//   mass_matrix: of 4 results 2 vanish identically
//   bias: of 2 results 1 vanish identically
//   forward_dynamics: of 4 results 1 vanish identically
//   energy: of 3 results 1 vanish identically
//   first_integrals: left out, 'C1', 'load' have no force function
//   constraints: of 10 results 7 vanish identically
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 34 results 20 vanish identically
//
// Constraints:
//   Constraints that repeat others are left out, their multipliers are 0: rolling_y.
//
// To write this file again:
//   friction_wheels_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output friction_wheels.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace friction_wheels {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"theta_1", "rad"}, {"theta_2", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"theta_1", "rad/s"}, {"theta_2", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> inputs{{{"C1", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> multipliers{{{"T", "N"}, {"lambda_rolling_y", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 43> results{{{"result", "S1_position", 3, 1, 1, "m"},
      {"result", "S1_rotation", 3, 3, 2, "1"}, {"result", "S1_velocity", 3, 1, 1, "m/s"}, {"result",
      "S1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S2_position", 3, 1, 1, "m"}, {"result", "S2_rotation", 3, 3,
      2, "1"}, {"result", "S2_velocity", 3, 1, 1, "m/s"}, {"result", "S2_angular_velocity", 3, 1, 1, "rad/s"},
      {"result", "I_position", 3, 1, 1, "m"}, {"result", "I_velocity", 3, 1, 1, "m/s"}, {"result", "I_jacobian", 3, 2,
      2, ""}, {"result", "I1_position", 3, 1, 1, "m"}, {"result", "I1_velocity", 3, 1, 1, "m/s"}, {"result",
      "I1_geometric_velocity", 3, 1, 1, "m/s"}, {"result", "I1_jacobian", 3, 2, 2, "m"}, {"result", "I2_position", 3, 1,
      1, "m"}, {"result", "I2_velocity", 3, 1, 1, "m/s"}, {"result", "I2_geometric_velocity", 3, 1, 1, "m/s"},
      {"result", "I2_jacobian", 3, 2, 2, "m"}, {"mass", "", 2, 2, 2, "kg m^2"}, {"forces", "", 2, 1, 1, "N m"},
      {"forces", "", 2, 1, 1, "N m"}, {"accelerations", "", 2, 1, 1, "rad/s^2"}, {"multipliers", "", 2, 1, 1, "N"},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "value", 2, 1, 1, ""}, {"result", "rate", 2, 1, 1, "m/s"}, {"result", "jacobian", 2, 2, 2, "m"},
      {"result", "gamma", 2, 1, 1, ""}, {"result", "M", 2, 2, 2, "kg m^2"}, {"result", "C", 2, 2, 2, "N m s"},
      {"result", "K", 2, 2, 2, ""}, {"result", "F", 2, 1, 1, "N m"}, {"result", "E", 2, 1, 2, "1"}, {"result", "M_r", 1,
      1, 2, "kg m^2"}, {"result", "C_r", 1, 1, 2, "N m s"}, {"result", "K_r", 1, 2, 2, ""}, {"result", "F_r", 1, 1, 1,
      "N m"}, {"result", "E_r", 1, 1, 2, "1"}, {"result", "A", 3, 3, 2, ""}, {"result", "B", 3, 1, 2, "1/kg/m^2"}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 19}, {"mass_matrix", false, false, false, false, results.data() + 19, 1}, {"bias", false,
      false, false, false, results.data() + 20, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 21,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 22, 2}, {"energy", false, false, true, false,
      results.data() + 24, 3}, {"constraints", false, false, false, false, results.data() + 27, 4}, {"linearisation",
      true, true, true, true, results.data() + 31, 12}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::friction_wheels::Description;

  static constexpr const char* name = "friction_wheels";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x6e9c99a1602f6815ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 2;
  static constexpr int first_integral_count = 0;
  /// Multipliers that are taken as zero: their constraints repeat others.
  static constexpr int redundant_count = 1;
  static constexpr int redundant_multipliers[redundant_count] = {1};

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

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
  struct Inputs {
    Scalar C1;  ///< motor [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C1};
      return members_[i_];
    }
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar T;  ///< of the constraint rolling_x [N]
    Scalar lambda_rolling_y;  ///< indeterminate, of the constraint rolling_y [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::T, &Multipliers::lambda_rolling_y};
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
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    state.time = n0;
    state.q.theta_1 = n0;
    state.q.theta_2 = n0;
    state.v.theta_1 = n6;
    state.v.theta_2 = -n2;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> S1_position;  ///< centre of mass of S1 [m]
    std::array<Scalar, 9> S1_rotation;  ///< from the axes of S1 to the ground's (3 x 3)
    std::array<Scalar, 3> S1_velocity;  ///< velocity of the centre of mass of S1 [m/s]
    std::array<Scalar, 3> S1_angular_velocity;  ///< angular velocity of S1 [rad/s]
    std::array<Scalar, 3> S2_position;  ///< centre of mass of S2 [m]
    std::array<Scalar, 9> S2_rotation;  ///< from the axes of S2 to the ground's (3 x 3)
    std::array<Scalar, 3> S2_velocity;  ///< velocity of the centre of mass of S2 [m/s]
    std::array<Scalar, 3> S2_angular_velocity;  ///< angular velocity of S2 [rad/s]
    std::array<Scalar, 3> I_position;  ///< position of I [m]
    std::array<Scalar, 3> I_velocity;  ///< velocity of the material point at I [m/s]
    std::array<Scalar, 6> I_jacobian;  ///< partial velocities of I (3 x 2)
    std::array<Scalar, 3> I1_position;  ///< position of I1 [m]
    std::array<Scalar, 3> I1_velocity;  ///< velocity of the material point at I1 [m/s]
    std::array<Scalar, 3> I1_geometric_velocity;  ///< velocity of the point I1 itself, which moves in its frame [m/s]
    std::array<Scalar, 6> I1_jacobian;  ///< partial velocities of I1 (3 x 2)
    std::array<Scalar, 3> I2_position;  ///< position of I2 [m]
    std::array<Scalar, 3> I2_velocity;  ///< velocity of the material point at I2 [m/s]
    std::array<Scalar, 3> I2_geometric_velocity;  ///< velocity of the point I2 itself, which moves in its frame [m/s]
    std::array<Scalar, 6> I2_jacobian;  ///< partial velocities of I2 (3 x 2)
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
    std::array<Scalar, 2> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 2> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 4> jacobian;  ///< A, stored column by column (2 x 2)
    std::array<Scalar, 2> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 4> M;  ///< mass matrix (2 x 2)
    std::array<Scalar, 4> C;  ///< damping and gyroscopic terms (2 x 2)
    std::array<Scalar, 4> K;  ///< stiffness (2 x 2)
    std::array<Scalar, 2> F;  ///< right-hand side
    std::array<Scalar, 2> E;  ///< effect of the inputs
    std::array<Scalar, 1> M_r;  ///< reduced mass matrix
    std::array<Scalar, 1> C_r;  ///< reduced damping and gyroscopic terms
    std::array<Scalar, 2> K_r;  ///< reduced stiffness (1 x 2)
    std::array<Scalar, 1> F_r;  ///< reduced right-hand side
    std::array<Scalar, 1> E_r;  ///< reduced effect of the inputs
    std::array<Scalar, 9> A;  ///< state matrix of x = (e, w): x' = A x + B du (3 x 3)
    std::array<Scalar, 3> B;  ///< input matrix
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 2;
  static constexpr int independent_coordinates[2] = {0, 1};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 1;
  static constexpr int independent_velocities[1] = {1};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar angles_[] = {q_theta_1, q_theta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar z0 = n0_1 * s_theta_1;
    const Scalar z1 = n0_3 * s_theta_2;
    const Scalar z2 = n0_1 * c_theta_1;
    const Scalar z3 = n0_3 * c_theta_2;
    const Scalar z4 = s_theta_1 * z0 + c_theta_1 * z2;
    const Scalar z5 = v_theta_1 * z2;
    const Scalar z6 = v_theta_1 * z0;
    const Scalar z7 = s_theta_2 * z1 + c_theta_2 * z3;
    const Scalar z8 = v_theta_2 * z3;
    const Scalar z9 = v_theta_2 * z1;
    const Scalar z10 = s_theta_1 * z6 + c_theta_1 * z5;
    const Scalar z11 = s_theta_2 * z9 + c_theta_2 * z8;
    const Scalar z12 = n0_4 - z7;
    result.S1_position[0] = n0;
    result.S1_position[1] = n0;
    result.S1_position[2] = n0;
    result.S1_rotation[0] = c_theta_1;
    result.S1_rotation[1] = s_theta_1;
    result.S1_rotation[2] = n0;
    result.S1_rotation[3] = -s_theta_1;
    result.S1_rotation[4] = c_theta_1;
    result.S1_rotation[5] = n0;
    result.S1_rotation[6] = n0;
    result.S1_rotation[7] = n0;
    result.S1_rotation[8] = n1;
    result.S1_velocity[0] = n0;
    result.S1_velocity[1] = n0;
    result.S1_velocity[2] = n0;
    result.S1_angular_velocity[0] = n0;
    result.S1_angular_velocity[1] = n0;
    result.S1_angular_velocity[2] = v_theta_1;
    result.S2_position[0] = n0;
    result.S2_position[1] = n0_4;
    result.S2_position[2] = n0;
    result.S2_rotation[0] = c_theta_2;
    result.S2_rotation[1] = s_theta_2;
    result.S2_rotation[2] = n0;
    result.S2_rotation[3] = -s_theta_2;
    result.S2_rotation[4] = c_theta_2;
    result.S2_rotation[5] = n0;
    result.S2_rotation[6] = n0;
    result.S2_rotation[7] = n0;
    result.S2_rotation[8] = n1;
    result.S2_velocity[0] = n0;
    result.S2_velocity[1] = n0;
    result.S2_velocity[2] = n0;
    result.S2_angular_velocity[0] = n0;
    result.S2_angular_velocity[1] = n0;
    result.S2_angular_velocity[2] = v_theta_2;
    result.I_position[0] = n0;
    result.I_position[1] = n0_1;
    result.I_position[2] = n0;
    result.I_velocity[0] = n0;
    result.I_velocity[1] = n0;
    result.I_velocity[2] = n0;
    result.I_jacobian[0] = n0;
    result.I_jacobian[3] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.I1_position[0] = n0;
    result.I1_position[1] = z4;
    result.I1_position[2] = n0;
    result.I1_velocity[0] = -z10;
    result.I1_velocity[1] = n0;
    result.I1_velocity[2] = n0;
    result.I1_geometric_velocity[0] = n0;
    result.I1_geometric_velocity[1] = n0;
    result.I1_geometric_velocity[2] = n0;
    result.I1_jacobian[0] = -z4;
    result.I1_jacobian[3] = n0;
    result.I1_jacobian[1] = n0;
    result.I1_jacobian[4] = n0;
    result.I1_jacobian[2] = n0;
    result.I1_jacobian[5] = n0;
    result.I2_position[0] = n0;
    result.I2_position[1] = z12;
    result.I2_position[2] = n0;
    result.I2_velocity[0] = z11;
    result.I2_velocity[1] = n0;
    result.I2_velocity[2] = n0;
    result.I2_geometric_velocity[0] = n0;
    result.I2_geometric_velocity[1] = n0;
    result.I2_geometric_velocity[2] = n0;
    result.I2_jacobian[0] = n0;
    result.I2_jacobian[3] = z7;
    result.I2_jacobian[1] = n0;
    result.I2_jacobian[4] = n0;
    result.I2_jacobian[2] = n0;
    result.I2_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_81 = traits::constant(0.81, 0.81f, "81/100");
    mass[0] = n0_01;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0_81;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = n0_9 * v_theta_2;
    forces.theta_1 = n0;
    forces.theta_2 = z0;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_81 = traits::constant(0.81, 0.81f, "81/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar l_T = multipliers.T;
    const Scalar z0 = n0_9 * v_theta_2;
    const Scalar z1 = n0_01 * a_theta_1;  // moment on S1, z
    const Scalar z2 = n0_81 * a_theta_2 + z0;  // moment on S2, z
    forces.theta_1 = z1 + n0_1 * l_T;
    forces.theta_2 = z2 + n0_3 * l_T;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n100_over_81 = traits::constant(1.2345679012345678, 1.2345679f, "100/81");
    const Scalar n10_over_27 = traits::constant(0.37037037037037035, 0.37037036f, "10/27");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar u_C1 = inputs.C1;
    const Scalar z0 = n0_9 * v_theta_2;
    const Scalar z1 = n1_over_3 * v_theta_2 - n10 * u_C1;
    const Scalar z2 = n100 * u_C1;
    const Scalar z3 = n100_over_81 * z0;
    const Scalar z4 = n0_9 * z1;
    const Scalar z5 = z2 + n10 * z4;
    const Scalar z6 = z3 - n10_over_27 * z4;
    accelerations.theta_1 = z5;
    accelerations.theta_2 = -z6;
    multipliers.T = -z4;
    multipliers.lambda_rolling_y = n0;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.theta_1 * accelerations.theta_2 * multipliers.T;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n0_005 = traits::constant(0.005, 0.005f, "1/200");
    const Scalar n0_405 = traits::constant(0.405, 0.405f, "81/200");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar u_C1 = inputs.C1;
    const Scalar z0 = n0_9 * v_theta_2;
    result.kinetic = n0_005 * v_theta_1 * v_theta_1 + n0_405 * v_theta_2 * v_theta_2;
    result.force_function = n0;
    result.power = v_theta_1 * u_C1 - v_theta_2 * z0;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = n0_1 * v_theta_1 + n0_3 * v_theta_2;
    result.value[0] = n0;
    result.rate[0] = -z0;
    result.gamma[0] = n0;
    result.value[1] = n0;
    result.rate[1] = n0;
    result.gamma[1] = n0;
    result.jacobian[0] = -n0_1;
    result.jacobian[1] = n0;
    result.jacobian[2] = -n0_3;
    result.jacobian[3] = n0;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of theta_1, theta_2,
  /// w those of the rates of theta_2;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs& inputs,
      Linearisation& result) noexcept {
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_81 = traits::constant(0.81, 0.81f, "81/100");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_03 = traits::constant(0.03, 0.03f, "3/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n10_over_3 = traits::constant(3.3333333333333335, 3.3333333f, "10/3");
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar u_C1 = inputs.C1;
    const Scalar l_T = multipliers.T;
    const Scalar z0 = n0_9 * v_theta_2;
    const Scalar z1 = n0_01 * a_theta_1;  // moment on S1, z
    const Scalar z2 = n0_1 * a_theta_1 + n0_3 * a_theta_2;
    const Scalar z3 = n0_81 * a_theta_2 + z0;  // moment on S2, z
    const Scalar z4 = n10 * z2;
    const Scalar z5 = n3 * (u_C1 - z1) + z3;
    const Scalar z6 = n0_03 * z4;
    const Scalar z7 = z5 + z6;
    result.M[0] = n0_01;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0_81;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0_9;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.F[0] = u_C1 - n0_1 * l_T - z1;
    result.F[1] = -z3 - n0_3 * l_T;
    result.E[0] = n1;
    result.E[1] = n0;
    result.M_r[0] = n0_9;
    result.C_r[0] = n0_9;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.F_r[0] = -z7;
    result.E_r[0] = -n3;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = -n3;
    result.A[7] = n1;
    result.A[8] = -n1;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = -n10_over_3;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.F[0] * result.F[1] * result.F_r[0];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
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
    visitor(Description::kernels[6], KernelFunction<void, Constraints&>(constraints));
    visitor(Description::kernels[7],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace friction_wheels
