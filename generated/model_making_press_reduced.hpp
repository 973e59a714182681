// SPDX-License-Identifier: MIT-0
// model_making_press_reduced: Model-making press, reduced: one prismatic, one helical, one point contact
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
//   kinematics                0                2          2             0                  1       0      6       6
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      2                2          0             0                  0       0      4       5
//   inverse_dynamics          6                5          0             0                  0       0     11      12
//   forward_dynamics          6                8          0             0                  0       0     14      15
//   energy                    5               13          2             0                  0       0     20      22
//   constraints               2                2          2             0                  0       0      6       6
//   linearisation            13                8          0             0                  0       0     21      23
//
// Not computed because this mechanism does not need it:
//   kinematics: of 36 results 23 vanish identically, 2 repeat another up to sign
//   mass_matrix: of 4 results 2 vanish identically
//   first_integrals: left out, 'thread', 'C' have no force function
//   constraints: of 5 results 1 vanish identically
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 27 results 11 vanish identically
//
// To write this file again:
//   model_making_press_reduced_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output model_making_press_reduced.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace model_making_press_reduced {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"a_z", "m"}, {"omega_z", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"a_z", "m/s"}, {"omega_z", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> inputs{{{"C", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> multipliers{{{"lambda_LB_z", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 32> results{{{"result", "traverse_position", 3, 1, 1, "m"},
      {"result", "traverse_rotation", 3, 3, 2, "1"}, {"result", "traverse_velocity", 3, 1, 1, "m/s"}, {"result",
      "traverse_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "screw_position", 3, 1, 1, "m"}, {"result",
      "screw_rotation", 3, 3, 2, "1"}, {"result", "screw_velocity", 3, 1, 1, "m/s"}, {"result",
      "screw_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 2, 2, 2, ""}, {"forces", "", 2, 1, 1, "N, N m"},
      {"forces", "", 2, 1, 1, "N, N m"}, {"accelerations", "", 2, 1, 1, "m/s^2, rad/s^2"}, {"multipliers", "", 1, 1, 1,
      "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1,
      0, "W"}, {"result", "value", 1, 1, 1, "m"}, {"result", "rate", 1, 1, 1, "m/s"}, {"result", "jacobian", 1, 2, 2,
      ""}, {"result", "gamma", 1, 1, 1, ""}, {"result", "M", 2, 2, 2, ""}, {"result", "C", 2, 2, 2, "N m s"}, {"result",
      "K", 2, 2, 2, "N/m"}, {"result", "F", 2, 1, 1, "N, N m"}, {"result", "E", 2, 1, 2, "1"}, {"result", "M_r", 1, 1,
      2, "kg m^2"}, {"result", "C_r", 1, 1, 2, "N m s"}, {"result", "K_r", 1, 1, 2, "N m"}, {"result", "F_r", 1, 1, 1,
      "N m"}, {"result", "E_r", 1, 1, 2, "1"}, {"result", "A", 2, 2, 2, ""}, {"result", "B", 2, 1, 2, "1/kg/m^2"}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 8}, {"mass_matrix", false, false, false, false, results.data() + 8, 1}, {"bias", false, false,
      false, false, results.data() + 9, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 10, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 11, 2}, {"energy", false, false, true, false,
      results.data() + 13, 3}, {"constraints", false, false, false, false, results.data() + 16, 4}, {"linearisation",
      true, true, true, true, results.data() + 20, 12}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::model_making_press_reduced::Description;

  static constexpr const char* name = "model_making_press_reduced";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe97d6f31a4d6393eULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 1;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar a_z;  ///< coordinate [m]
    Scalar omega_z;  ///< coordinate [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::a_z, &Coordinates::omega_z};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar a_z;  ///< its rate [m/s]
    Scalar omega_z;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::a_z, &Velocities::omega_z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar a_z;  ///< its second rate [m/s^2]
    Scalar omega_z;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::a_z, &Accelerations::omega_z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar a_z;  ///< works with the rate of a_z [N]
    Scalar omega_z;  ///< works with the rate of omega_z [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::a_z, &GeneralizedForces::omega_z};
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
    Scalar lambda_LB_z;  ///< of the constraint LB_z [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_LB_z};
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
    state.time = n0;
    state.q.a_z = n0;
    state.q.omega_z = n0;
    state.v.a_z = n0;
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
    std::array<Scalar, 1> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 1> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 2> jacobian;  ///< A, stored column by column (1 x 2)
    std::array<Scalar, 1> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
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
    std::array<Scalar, 1> K_r;  ///< reduced stiffness
    std::array<Scalar, 1> F_r;  ///< reduced right-hand side
    std::array<Scalar, 1> E_r;  ///< reduced effect of the inputs
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, w): x' = A x + B du (2 x 2)
    std::array<Scalar, 2> B;  ///< input matrix
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 1;
  static constexpr int independent_coordinates[1] = {1};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 1;
  static constexpr int independent_velocities[1] = {1};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    Scalar s_omega_z, c_omega_z;
    traits::sincos(q_omega_z, s_omega_z, c_omega_z);
    const Scalar pi = traits::pi();
    const Scalar z0 = n0_002 * q_omega_z / pi;
    const Scalar z1 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    result.traverse_position[0] = n0;
    result.traverse_position[1] = n0;
    result.traverse_position[2] = q_a_z;
    result.traverse_rotation[0] = n1;
    result.traverse_rotation[1] = n0;
    result.traverse_rotation[2] = n0;
    result.traverse_rotation[3] = n0;
    result.traverse_rotation[4] = n1;
    result.traverse_rotation[5] = n0;
    result.traverse_rotation[6] = n0;
    result.traverse_rotation[7] = n0;
    result.traverse_rotation[8] = n1;
    result.traverse_velocity[0] = n0;
    result.traverse_velocity[1] = n0;
    result.traverse_velocity[2] = v_a_z;
    result.traverse_angular_velocity[0] = n0;
    result.traverse_angular_velocity[1] = n0;
    result.traverse_angular_velocity[2] = n0;
    result.screw_position[0] = n0;
    result.screw_position[1] = n0;
    result.screw_position[2] = z0;
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
    result.screw_velocity[2] = z1;
    result.screw_angular_velocity[0] = n0;
    result.screw_angular_velocity[1] = n0;
    result.screw_angular_velocity[2] = v_omega_z;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
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
    mass[0] = n0_84;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n8_2404 = traits::constant(8.2404, 8.2404f, "20601/2500");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z2 = n20000 * q_a_z;
    const Scalar z3 = n0_0005 * v_omega_z;
    const Scalar z4 = n8_2404 + z2;
    const Scalar z5 = z1 + z3;
    forces.a_z = z4;
    forces.omega_z = z5;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n8_2404 = traits::constant(8.2404, 8.2404f, "20601/2500");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar q_a_z = state.q.a_z;
    const Scalar a_a_z = accelerations.a_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar a_omega_z = accelerations.omega_z;
    const Scalar l_lambda_LB_z = multipliers.lambda_LB_z;
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
    const Scalar z4 = n20000 * q_a_z;
    const Scalar z5 = n0_0005 * v_omega_z;
    const Scalar z6 = n8_2404 + z4;
    const Scalar z7 = z3 + z5;
    const Scalar z8 = n0_84 * a_a_z + z6;
    const Scalar z9 = a_omega_z * z2 + z7;
    forces.a_z = l_lambda_LB_z + z8;
    forces.omega_z = -z0 * l_lambda_LB_z + z9;
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
    const Scalar n25_over_21 = traits::constant(1.1904761904761905, 1.1904762f, "25/21");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n8_2404 = traits::constant(8.2404, 8.2404f, "20601/2500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar u_C = inputs.C;
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
    const Scalar z4 = traits::formula(6.358466755142436, 6.3584666f, [&]() -> Scalar {
      return z0 * z3;
    });
    const Scalar z5 = traits::formula(1.1945241161344562, 1.1945242f, [&]() -> Scalar {
      return n25_over_21 + z0 * z4;
    });
    const Scalar z6 = traits::formula(0.8371534626157683, 0.83715343f, [&]() -> Scalar {
      return n1 / z5;
    });
    const Scalar z7 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z8 = n0_0005 * v_omega_z;
    const Scalar z9 = n20000 * q_a_z;
    const Scalar z10 = n8_2404 + z9;
    const Scalar z11 = z7 + z8;
    const Scalar z12 = u_C - z11;
    const Scalar z13 = n25_over_21 * z10;
    const Scalar z14 = z3 * z12;
    const Scalar z15 = z0 * z14 + z13;
    const Scalar z16 = z6 * z15;
    const Scalar z17 = z13 - n25_over_21 * z16;
    const Scalar z18 = z4 * z16 - z14;
    accelerations.a_z = -z17;
    accelerations.omega_z = -z18;
    multipliers.lambda_LB_z = -z16;
    if (!(traits::regular(z2, z2) && traits::regular(z5, z5))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.a_z * accelerations.omega_z * multipliers.lambda_LB_z;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_42 = traits::constant(0.42, 0.42f, "21/50");
    const Scalar k3 = traits::constant(5e-05, 5e-05f, "1/20000");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n8_2404 = traits::constant(8.2404, 8.2404f, "20601/2500");
    const Scalar n10000 = traits::constant(10000.0, 10000.0f, "10000/1");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar u_C = inputs.C;
    const Scalar pi = traits::pi();
    const Scalar z0 = n0_002 * q_omega_z / pi;
    const Scalar z1 = n0_002 * v_omega_z / pi;  // velocity of screw.1, z
    const Scalar z2 = n0_0005 * v_omega_z;
    result.kinetic = n0_42 * v_a_z * v_a_z + k3 * v_omega_z * v_omega_z + n0_15 * z1 * z1;
    result.force_function = -q_a_z * (n8_2404 + n10000 * q_a_z) - n2_943 * z0;
    result.power = -v_omega_z * (z2 - u_C);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar v_a_z = state.v.a_z;
    const Scalar q_omega_z = state.q.omega_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.0006366197723675813, 0.00063661975f, [&]() -> Scalar {
      return n0_002 / pi;
    });
    const Scalar z1 = n0_002 * q_omega_z / pi;
    const Scalar z2 = n0_002 * v_omega_z / pi;
    const Scalar z3 = q_a_z - z1;
    const Scalar z4 = v_a_z - z2;
    result.value[0] = -z3;
    result.rate[0] = -z4;
    result.gamma[0] = n0;
    result.jacobian[0] = -n1;
    result.jacobian[1] = z0;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of omega_z,
  /// w those of the rates of omega_z;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs& inputs,
      Linearisation& result) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar k3 = traits::constant(0.00168, 0.00168f, "21/12500");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n2_943 = traits::constant(2.943, 2.943f, "2943/1000");
    const Scalar n20000 = traits::constant(20000.0, 20000.0f, "20000/1");
    const Scalar n8_2404 = traits::constant(8.2404, 8.2404f, "20601/2500");
    const Scalar n0_84 = traits::constant(0.84, 0.84f, "21/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a_z = state.q.a_z;
    const Scalar a_a_z = accelerations.a_z;
    const Scalar v_omega_z = state.v.omega_z;
    const Scalar a_omega_z = accelerations.omega_z;
    const Scalar u_C = inputs.C;
    const Scalar l_lambda_LB_z = multipliers.lambda_LB_z;
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
    const Scalar z3 = traits::formula(0.0005347606087887683, 0.0005347606f, [&]() -> Scalar {
      return k3 / pi;
    });
    const Scalar z4 = traits::formula(0.00010046202459740906, 0.00010046203f, [&]() -> Scalar {
      return z0 * z3 + z2;
    });
    const Scalar z5 = traits::formula(12.732395447351626, 12.732395f, [&]() -> Scalar {
      return n40 / pi;
    });
    const Scalar z6 = traits::formula(0.008105694691387022, 0.008105694f, [&]() -> Scalar {
      return z0 * z5;
    });
    const Scalar z7 = traits::formula(9954.01002525476, 9954.01f, [&]() -> Scalar {
      return n1 / z4;
    });
    const Scalar z8 = traits::formula(80.6841662197207, 80.684166f, [&]() -> Scalar {
      return z6 * z7;
    });
    const Scalar z9 = traits::formula(4.977005012627379, 4.977005f, [&]() -> Scalar {
      return n0_0005 * z7;
    });
    const Scalar z10 = traits::formula(0.001873571990077792, 0.001873572f, [&]() -> Scalar {
      return n2_943 * z0;
    });
    const Scalar z11 = n20000 * q_a_z;
    const Scalar z12 = n0_0005 * v_omega_z;
    const Scalar z13 = a_a_z - a_omega_z * z0;
    const Scalar z14 = n8_2404 + z11;
    const Scalar z15 = z10 + z12;
    const Scalar z16 = z3 * z13;
    const Scalar z17 = n0_84 * a_a_z + z14;
    const Scalar z18 = a_omega_z * z2 + z15;
    const Scalar z19 = l_lambda_LB_z + z17;
    const Scalar z20 = u_C - z18 + z0 * (l_lambda_LB_z - z19);
    const Scalar z21 = z20 + z16;
    result.M[0] = n0_84;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z2;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0_0005;
    result.K[0] = n20000;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.F[0] = -l_lambda_LB_z - z17;
    result.F[1] = z0 * l_lambda_LB_z + u_C - z18;
    result.E[0] = n0;
    result.E[1] = n1;
    result.M_r[0] = z4;
    result.C_r[0] = n0_0005;
    result.K_r[0] = z6;
    result.F_r[0] = z21;
    result.E_r[0] = n1;
    result.A[0] = n0;
    result.A[1] = -z8;
    result.A[2] = n1;
    result.A[3] = -z9;
    result.B[0] = n0;
    result.B[1] = z7;
    if (!(traits::regular(z4, z4))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.M[3] * result.F[0] * result.F[1] * result.M_r[0] * result.K_r[0] * result.F_r[0]
        * result.A[1] * result.A[3] * result.B[1];
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

}  // namespace model_making_press_reduced
