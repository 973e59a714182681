// SPDX-License-Identifier: MIT-0
// turning_slot: Bead in a slot that turns in a vertical plane
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints, linearisation
// Parameters set at run time: omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                0                1          0             0                  0       0      1       -
//   kinematics                0                0          0             0                  0       0      0       0
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                0          0             0                  0       0      0       0
//   inverse_dynamics          3                5          0             0                  1       0     10      10
//   forward_dynamics          5               16          0             0                  1       0     23      24
//   energy                    1                3          0             0                  0       0      4       4
//   constraints               7               16          0             0                  1       0     25      26
//   linearisation            10               33          6             0                  1       0     51      54
//
// Not computed because this mechanism does not need it:
//   kinematics: of 30 results 17 vanish identically, 4 repeat another up to sign
//   mass_matrix: of 4 results 2 vanish identically
//   bias: of 2 results 1 vanish identically
//   energy: of 3 results 1 vanish identically
//   first_integrals: left out, constraint 'slot' imposes a velocity (b is not zero)
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 22 results 11 vanish identically
//
// To write this file again:
//   turning_slot_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output turning_slot.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace turning_slot {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"x", "m"}, {"y", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"x", "m/s"}, {"y", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 1> multipliers{{{"N", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"omega", "rad/s"}}};
  static constexpr std::array<torsor::ResultDescription, 28> results{{{"result", "bead_position", 3, 1, 1, "m"},
      {"result", "bead_rotation", 3, 3, 2, "1"}, {"result", "bead_velocity", 3, 1, 1, "m/s"}, {"result",
      "bead_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "center_position", 3, 1, 1, "m"}, {"result",
      "center_velocity", 3, 1, 1, "m/s"}, {"result", "center_jacobian", 3, 2, 2, "1"}, {"mass", "", 2, 2, 2, "kg"},
      {"forces", "", 2, 1, 1, "N"}, {"forces", "", 2, 1, 1, "N"}, {"accelerations", "", 2, 1, 1, "m/s^2"},
      {"multipliers", "", 1, 1, 1, "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0,
      "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "value", 1, 1, 1, "m"}, {"result", "rate", 1, 1, 1, "m/s"},
      {"result", "jacobian", 1, 2, 2, "1"}, {"result", "gamma", 1, 1, 1, "m/s^2"}, {"result", "M", 2, 2, 2, "kg"},
      {"result", "C", 2, 2, 2, ""}, {"result", "K", 2, 2, 2, ""}, {"result", "F", 2, 1, 1, "N"}, {"result", "M_r", 1, 1,
      2, "kg"}, {"result", "C_r", 1, 1, 2, "N s/m"}, {"result", "K_r", 1, 1, 2, "N/m"}, {"result", "F_r", 1, 1, 1, "N"},
      {"result", "A", 2, 2, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 7}, {"mass_matrix", false, false, false, false, results.data() + 7, 1}, {"bias", false, false,
      false, false, results.data() + 8, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 9, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 10, 2}, {"energy", false, false, true, false,
      results.data() + 12, 3}, {"constraints", false, false, false, false, results.data() + 15, 4}, {"linearisation",
      true, true, true, true, results.data() + 19, 9}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::turning_slot::Description;

  static constexpr const char* name = "turning_slot";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x4ccf497fddac66ffULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 1;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar omega;  ///< parameter [rad/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::omega};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar N;  ///< of the constraint slot [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::N};
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
    Scalar m_e71b311a;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    parameters.omega = n2;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_omega = parameters.omega;
    const Scalar z0 = n2 * p_omega;
    precomputed.m_e71b311a = z0;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar p_omega = parameters.omega;
    state.time = n0;
    state.q.x = n0_5;
    state.q.y = n0;
    state.v.x = n0;
    state.v.y = n0_5 * p_omega;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> bead_position;  ///< centre of mass of bead [m]
    std::array<Scalar, 9> bead_rotation;  ///< from the axes of bead to the ground's (3 x 3)
    std::array<Scalar, 3> bead_velocity;  ///< velocity of the centre of mass of bead [m/s]
    std::array<Scalar, 3> bead_angular_velocity;  ///< angular velocity of bead [rad/s]
    std::array<Scalar, 3> center_position;  ///< position of center [m]
    std::array<Scalar, 3> center_velocity;  ///< velocity of the material point at center [m/s]
    std::array<Scalar, 6> center_jacobian;  ///< partial velocities of center (3 x 2)
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
    std::array<Scalar, 1> M_r;  ///< reduced mass matrix
    std::array<Scalar, 1> C_r;  ///< reduced damping and gyroscopic terms
    std::array<Scalar, 1> K_r;  ///< reduced stiffness
    std::array<Scalar, 1> F_r;  ///< reduced right-hand side
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, w): x' = A x + B du (2 x 2)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 1;
  static constexpr int independent_coordinates[1] = {0};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 1;
  static constexpr int independent_velocities[1] = {0};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    result.bead_position[0] = q_x;
    result.bead_position[1] = q_y;
    result.bead_position[2] = n0;
    result.bead_rotation[0] = n1;
    result.bead_rotation[1] = n0;
    result.bead_rotation[2] = n0;
    result.bead_rotation[3] = n0;
    result.bead_rotation[4] = n1;
    result.bead_rotation[5] = n0;
    result.bead_rotation[6] = n0;
    result.bead_rotation[7] = n0;
    result.bead_rotation[8] = n1;
    result.bead_velocity[0] = v_x;
    result.bead_velocity[1] = v_y;
    result.bead_velocity[2] = n0;
    result.bead_angular_velocity[0] = n0;
    result.bead_angular_velocity[1] = n0;
    result.bead_angular_velocity[2] = n0;
    result.center_position[0] = q_x;
    result.center_position[1] = q_y;
    result.center_position[2] = n0;
    result.center_velocity[0] = v_x;
    result.center_velocity[1] = v_y;
    result.center_velocity[2] = n0;
    result.center_jacobian[0] = n1;
    result.center_jacobian[3] = n0;
    result.center_jacobian[1] = n0;
    result.center_jacobian[4] = n1;
    result.center_jacobian[2] = n0;
    result.center_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    mass[0] = n2;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State&, GeneralizedForces& forces) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    forces.x = n0;
    forces.y = n19_62;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar l_N = multipliers.N;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = n9_81 + a_y;
    const Scalar z4 = n2 * a_x;  // force on bead, x
    const Scalar z5 = n2 * z3;  // force on bead, y
    forces.x = z4 + z1 * l_N;
    forces.y = z5 - z2 * l_N;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = p_omega * z2;
    const Scalar z5 = n0_5 * z2;
    const Scalar z6 = n0_5 * z1;
    const Scalar z7 = p_omega * z3;
    const Scalar z8 = p_omega * z4;
    const Scalar z9 = q_x * z7 - q_y * z8 - n2 * (v_x * z4 + v_y * z3);
    const Scalar z10 = n9_81 * z2 - z9;
    const Scalar z11 = n2 * z10;
    const Scalar z12 = z6 * z11;
    const Scalar z13 = n9_81 - z5 * z11;
    accelerations.x = -z12;
    accelerations.y = -z13;
    multipliers.N = z11;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * multipliers.N;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    return Mechanism::forward_dynamics(precomputed, state, Inputs(), accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    result.kinetic = v_x * v_x + v_y * v_y;
    result.force_function = -n19_62 * q_y;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = p_omega * z2;
    const Scalar z5 = q_x * z1 - q_y * z2;
    const Scalar z6 = v_x * z1 - v_y * z2 + q_x * z4 + q_y * z3;
    const Scalar z7 = p_omega * z3;
    const Scalar z8 = p_omega * z4;
    const Scalar z9 = q_x * z7 - q_y * z8 - n2 * (v_x * z4 + v_y * z3);
    result.value[0] = -z5;
    result.rate[0] = -z6;
    result.gamma[0] = z9;
    result.jacobian[0] = -z1;
    result.jacobian[1] = z2;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x,
  /// w those of the rates of x;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar l_N = multipliers.N;
    const Scalar m0 = precomputed.m_e71b311a;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = p_omega * z2;
    const Scalar z5 = n9_81 + a_y;
    const Scalar z6 = n2 / (z2 * z2);
    const Scalar z7 = n1 / z2;
    const Scalar z8 = p_omega / z2;
    const Scalar z9 = m0 / z2;
    const Scalar z10 = n2 * (a_x + z1 * z5 / z2);
    const Scalar z11 = n2 * a_x;  // force on bead, x
    const Scalar z12 = n2 * z5;  // force on bead, y
    const Scalar z13 = z2 * z2;
    const Scalar z14 = p_omega * z3;
    const Scalar z15 = p_omega * z4;
    const Scalar z16 = n2 * z3;
    const Scalar z17 = q_x * z14 - q_y * z15 - n2 * (v_x * z4 + v_y * z3);
    const Scalar z18 = z1 * z7;
    const Scalar z19 = z7 * z8;
    const Scalar z20 = z7 * z9;
    const Scalar z21 = z16 * z19;
    const Scalar z22 = n2 * z18;
    const Scalar z23 = n1 / z6;
    const Scalar z24 = a_x * z1 - z17 - a_y * z2;
    const Scalar z25 = z7 * z21;
    const Scalar z26 = z20 * z22;
    const Scalar z27 = z25 * z22;
    const Scalar z28 = z24 * z7;
    const Scalar z29 = z28 * z22;
    const Scalar z30 = z27 * z23;
    const Scalar z31 = z26 * z23;
    const Scalar z32 = z10 + z29;
    result.M[0] = n2;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n2;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.F[0] = -l_N * z1 - z11;
    result.F[1] = l_N * z2 - z12;
    result.M_r[0] = z6;
    result.C_r[0] = z26;
    result.K_r[0] = z27;
    result.F_r[0] = -z32;
    result.A[0] = n0;
    result.A[1] = -z30;
    result.A[2] = n1;
    result.A[3] = -z31;
    if (!(traits::regular(z13, n1) && traits::regular(z6, z6))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.F[0] * result.F[1] * result.M_r[0] * result.C_r[0] * result.K_r[0] * result.F_r[0]
        * result.A[1] * result.A[3];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, multipliers, Inputs(), result);
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

}  // namespace turning_slot
