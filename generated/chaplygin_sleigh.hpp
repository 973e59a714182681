// SPDX-License-Identifier: MIT-0
// chaplygin_sleigh: Chaplygin's sleigh: a knife edge on a smooth plane
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                4                5          0             0                  1       0     11      11
//   mass_matrix               0                2          0             0                  1       0      4       4
//   bias                      0                4          0             0                  1       0      6       6
//   inverse_dynamics          8               13          0             0                  1       0     23      23
//   forward_dynamics         16               37          3             0                  1       0     58      58
//   energy                    6               11          0             0                  1       0     19      21
//   first_integrals           6               11          0             0                  1       0     19      21
//   constraints               2                6          0             0                  1       0     10      10
//   linearisation            27               58          5             0                  1       0     92      94
//
// Not computed because this mechanism does not need it:
//   kinematics: of 33 results 17 vanish identically, 2 repeat another up to sign
//   mass_matrix: of 9 results 2 vanish identically, 2 repeat another up to sign
//   bias: of 3 results 1 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: of 6 results 2 vanish identically
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 71 results 36 vanish identically, 2 repeat another up to sign
//
// To write this file again:
//   chaplygin_sleigh_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output chaplygin_sleigh.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace chaplygin_sleigh {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"x", "m"}, {"y", "m"}, {"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"phi",
      "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 1> multipliers{{{"N", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 29> results{{{"result", "sleigh_position", 3, 1, 1, "m"},
      {"result", "sleigh_rotation", 3, 3, 2, "1"}, {"result", "sleigh_velocity", 3, 1, 1, "m/s"}, {"result",
      "sleigh_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "C_position", 3, 1, 1, "m"}, {"result", "C_velocity", 3,
      1, 1, "m/s"}, {"result", "C_jacobian", 3, 3, 2, "1"}, {"mass", "", 3, 3, 2, ""}, {"forces", "", 3, 1, 1, "N"},
      {"forces", "", 3, 1, 1, "N, N, N m"}, {"accelerations", "", 3, 1, 1, "m/s^2, m/s^2, rad/s^2"}, {"multipliers", "",
      1, 1, 1, "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result",
      "power", 1, 1, 0, "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result", "value", 1, 1, 1, ""}, {"result", "rate",
      1, 1, 1, "m/s"}, {"result", "jacobian", 1, 3, 2, "1"}, {"result", "gamma", 1, 1, 1, "m/s^2"}, {"result", "M", 3,
      3, 2, ""}, {"result", "C", 3, 3, 2, "N s"}, {"result", "K", 3, 3, 2, ""}, {"result", "F", 3, 1, 1, "N, N, N m"},
      {"result", "M_r", 2, 2, 2, ""}, {"result", "C_r", 2, 2, 2, ""}, {"result", "K_r", 2, 3, 2, ""}, {"result", "F_r",
      2, 1, 1, "N, N m"}, {"result", "A", 5, 5, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 7}, {"mass_matrix", false, false, false, false, results.data() + 7, 1}, {"bias", false, false,
      false, false, results.data() + 8, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 9, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 10, 2}, {"energy", false, false, true, false,
      results.data() + 12, 3}, {"first_integrals", false, false, false, false, results.data() + 15, 1}, {"constraints",
      false, false, false, false, results.data() + 16, 4}, {"linearisation", true, true, true, true, results.data()
      + 20, 9}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::chaplygin_sleigh::Description;

  static constexpr const char* name = "chaplygin_sleigh";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xaa7f7bdbe170ed7eULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 3;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 1;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::phi};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar N;  ///< of the constraint knife_edge [N]
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
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.phi = n0;
    state.v.x = n0;
    state.v.y = n0;
    state.v.phi = n2;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> sleigh_position;  ///< centre of mass of sleigh [m]
    std::array<Scalar, 9> sleigh_rotation;  ///< from the axes of sleigh to the ground's (3 x 3)
    std::array<Scalar, 3> sleigh_velocity;  ///< velocity of the centre of mass of sleigh [m/s]
    std::array<Scalar, 3> sleigh_angular_velocity;  ///< angular velocity of sleigh [rad/s]
    std::array<Scalar, 3> C_position;  ///< position of C [m]
    std::array<Scalar, 3> C_velocity;  ///< velocity of the material point at C [m/s]
    std::array<Scalar, 9> C_jacobian;  ///< partial velocities of C (3 x 3)
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
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy};
      return members_[i_];
    }
  };

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 1> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 1> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 3> jacobian;  ///< A, stored column by column (1 x 3)
    std::array<Scalar, 1> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 4> M_r;  ///< reduced mass matrix (2 x 2)
    std::array<Scalar, 4> C_r;  ///< reduced damping and gyroscopic terms (2 x 2)
    std::array<Scalar, 6> K_r;  ///< reduced stiffness (2 x 3)
    std::array<Scalar, 2> F_r;  ///< reduced right-hand side
    std::array<Scalar, 25> A;  ///< state matrix of x = (e, w): x' = A x + B du (5 x 5)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 3;
  static constexpr int independent_coordinates[3] = {0, 1, 2};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 2;
  static constexpr int independent_velocities[2] = {0, 2};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = n0_5 * v_phi;
    const Scalar z1 = n0_5 * c_phi;
    const Scalar z2 = n0_5 * s_phi;
    const Scalar z3 = v_x - s_phi * z0;
    const Scalar z4 = v_y + c_phi * z0;
    const Scalar z5 = q_x + z1;
    const Scalar z6 = q_y + z2;
    result.sleigh_position[0] = z5;
    result.sleigh_position[1] = z6;
    result.sleigh_position[2] = n0;
    result.sleigh_rotation[0] = c_phi;
    result.sleigh_rotation[1] = s_phi;
    result.sleigh_rotation[2] = n0;
    result.sleigh_rotation[3] = -s_phi;
    result.sleigh_rotation[4] = c_phi;
    result.sleigh_rotation[5] = n0;
    result.sleigh_rotation[6] = n0;
    result.sleigh_rotation[7] = n0;
    result.sleigh_rotation[8] = n1;
    result.sleigh_velocity[0] = z3;
    result.sleigh_velocity[1] = z4;
    result.sleigh_velocity[2] = n0;
    result.sleigh_angular_velocity[0] = n0;
    result.sleigh_angular_velocity[1] = n0;
    result.sleigh_angular_velocity[2] = v_phi;
    result.C_position[0] = q_x;
    result.C_position[1] = q_y;
    result.C_position[2] = n0;
    result.C_velocity[0] = v_x;
    result.C_velocity[1] = v_y;
    result.C_velocity[2] = n0;
    result.C_jacobian[0] = n1;
    result.C_jacobian[3] = n0;
    result.C_jacobian[6] = n0;
    result.C_jacobian[1] = n0;
    result.C_jacobian[4] = n1;
    result.C_jacobian[7] = n0;
    result.C_jacobian[2] = n0;
    result.C_jacobian[5] = n0;
    result.C_jacobian[8] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 9>& mass) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar q_phi = state.q.phi;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = n0_5 * s_phi;
    const Scalar z1 = n0_5 * c_phi;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = -z0;
    mass[3] = n0;
    mass[4] = n1;
    mass[5] = z1;
    mass[6] = -z0;
    mass[7] = z1;
    mass[8] = n0_75;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_phi * v_phi;
    const Scalar z1 = n0_5 * z0;  // force on sleigh, x
    const Scalar z2 = c_phi * z1;
    const Scalar z3 = s_phi * z1;
    forces.x = -z2;
    forces.y = -z3;
    forces.phi = n0;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar l_N = multipliers.N;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_phi * v_phi;
    const Scalar z1 = n0_5 * a_phi;  // force on sleigh, y
    const Scalar z2 = a_x * s_phi - a_y * c_phi;
    const Scalar z3 = n0_5 * z0;  // force on sleigh, x
    const Scalar z4 = s_phi * z1 + c_phi * z3;
    const Scalar z5 = s_phi * z3 - c_phi * z1;
    const Scalar z6 = n0_75 * a_phi - n0_5 * z2;  // moment on sleigh, z
    const Scalar z7 = a_x - z4;  // force on along_y, x
    const Scalar z8 = a_y - z5;  // force on along_y, y
    forces.x = s_phi * l_N + z7;
    forces.y = -c_phi * l_N + z8;
    forces.phi = z6;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n4_over_3 = traits::constant(1.3333333333333333, 1.3333334f, "4/3");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = n0_5 * c_phi;
    const Scalar z1 = n0_5 * s_phi;
    const Scalar z2 = v_phi * v_phi;
    const Scalar z3 = v_phi * c_phi;
    const Scalar z4 = v_phi * s_phi;
    const Scalar z5 = n0_5 * z2;  // force on sleigh, x
    const Scalar z6 = c_phi * z5;
    const Scalar z7 = s_phi * z5;
    const Scalar z8 = v_x * z3 + v_y * z4;
    const Scalar z9 = n4_over_3 * z1;
    const Scalar z10 = n4_over_3 * z0;
    const Scalar z11 = n1 - z1 * z9;
    const Scalar z12 = z1 * z10;
    const Scalar z13 = n1 - z0 * z10;
    const Scalar z14 = n1 / z13;
    const Scalar z15 = z12 * z14;
    const Scalar z16 = z11 - z12 * z15;
    const Scalar z17 = s_phi + c_phi * z15;
    const Scalar z18 = z6 - z7 * z15;
    const Scalar z19 = n1 / z16;
    const Scalar z20 = z19 * z17;
    const Scalar z21 = z19 * z18;
    const Scalar z22 = c_phi * z14 + z15 * z20;
    const Scalar z23 = z7 * z14 - z15 * z21;
    const Scalar z24 = z9 * z20 + z10 * z22;
    const Scalar z25 = s_phi * z20 + c_phi * z22;
    const Scalar z26 = z9 * z21 - z10 * z23;
    const Scalar z27 = z8 + s_phi * z21 - c_phi * z23;
    const Scalar z28 = n1 / z25;
    const Scalar z29 = z28 * z27;
    const Scalar z30 = z20 * z29 - z21;
    const Scalar z31 = z22 * z29 + z23;
    const Scalar z32 = z24 * z29 - z26;
    accelerations.x = -z30;
    accelerations.y = z31;
    accelerations.phi = -z32;
    multipliers.N = z29;
    if (!(traits::regular(z16, n1) && traits::regular(z13, n1) && traits::regular(z25,
        z25))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.phi * multipliers.N;
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_x * s_phi - v_y * c_phi;
    const Scalar z1 = v_x * c_phi + v_y * s_phi;
    const Scalar z2 = n0_5 * v_phi - z0;
    const Scalar z3 = n0_75 * v_phi - n0_5 * z0;
    result.kinetic = n0_5 * (z1 * z1 + v_phi * z3 - z0 * z2);
    result.force_function = n0;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_x * s_phi - v_y * c_phi;
    const Scalar z1 = v_x * c_phi + v_y * s_phi;
    const Scalar z2 = n0_5 * v_phi - z0;
    const Scalar z3 = n0_75 * v_phi - n0_5 * z0;
    result.energy = n0_5 * (z1 * z1 + v_phi * z3 - z0 * z2);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_phi * c_phi;
    const Scalar z1 = v_phi * s_phi;
    const Scalar z2 = v_x * s_phi - v_y * c_phi;
    const Scalar z3 = v_x * z0 + v_y * z1;
    result.value[0] = n0;
    result.rate[0] = -z2;
    result.gamma[0] = -z3;
    result.jacobian[0] = -s_phi;
    result.jacobian[1] = c_phi;
    result.jacobian[2] = n0;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x, y, phi,
  /// w those of the rates of x, phi;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n4_over_3 = traits::constant(1.3333333333333333, 1.3333334f, "4/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar l_N = multipliers.N;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_phi * v_phi;
    const Scalar z1 = n0_5 * a_phi;  // force on sleigh, y
    const Scalar z2 = v_phi * s_phi;
    const Scalar z3 = v_phi * c_phi;
    const Scalar z4 = a_x * c_phi;
    const Scalar z5 = v_x * c_phi + v_y * s_phi;
    const Scalar z6 = n0_5 * z0;  // force on sleigh, x
    const Scalar z7 = n1 / c_phi;
    const Scalar z8 = a_x * s_phi;
    const Scalar z9 = n1 / (c_phi * c_phi);
    const Scalar z10 = s_phi * z6 - c_phi * z1;
    const Scalar z11 = s_phi * z1 + c_phi * z6;
    const Scalar z12 = n0_5 * c_phi;
    const Scalar z13 = v_phi / c_phi;
    const Scalar z14 = n2 * v_phi;
    const Scalar z15 = n0_5 * z14;
    const Scalar z16 = n0_5 * s_phi;
    const Scalar z17 = c_phi * c_phi;
    const Scalar z18 = c_phi * z15;
    const Scalar z19 = s_phi * z15;
    const Scalar z20 = v_x * z3 + v_y * z2;
    const Scalar z21 = a_y * s_phi + z4;
    const Scalar z22 = a_y * c_phi - z8;
    const Scalar z23 = v_x * z2 - v_y * z3;
    const Scalar z24 = n0_75 * a_phi + n0_5 * z22;  // moment on sleigh, z
    const Scalar z25 = a_x - z11;  // force on along_y, x
    const Scalar z26 = a_y - z10;  // force on along_y, y
    const Scalar z27 = c_phi * l_N + z10;
    const Scalar z28 = s_phi * l_N - z11;
    const Scalar z29 = n0_5 * z21;
    const Scalar z30 = a_y * c_phi - z8 - z20;
    const Scalar z31 = a_y * s_phi + z4 - z23;
    const Scalar z32 = a_x - z11 + s_phi * z26 / c_phi;
    const Scalar z33 = s_phi * z7;
    const Scalar z34 = z5 * z7;
    const Scalar z35 = z7 * z13;
    const Scalar z36 = z30 * z7;
    const Scalar z37 = z2 * z34;
    const Scalar z38 = z33 * z35;
    const Scalar z39 = z33 * z34;
    const Scalar z40 = z12 * z35;
    const Scalar z41 = z12 * z34;
    const Scalar z42 = z27 + z28 * z33;
    const Scalar z43 = z33 * z36;
    const Scalar z44 = z12 * z36;
    const Scalar z45 = n1 / z9;
    const Scalar z46 = z31 + z37;
    const Scalar z47 = z13 - z39;
    const Scalar z48 = z24 - z44;
    const Scalar z49 = n4_over_3 * z40;
    const Scalar z50 = n4_over_3 * z41;
    const Scalar z51 = z7 * z46;
    const Scalar z52 = z33 * z51;
    const Scalar z53 = z12 * z51;
    const Scalar z54 = z52 + z42;
    const Scalar z55 = z29 - z53;
    const Scalar z56 = z32 - z43;
    const Scalar z57 = z38 * z45;
    const Scalar z58 = z47 * z45;
    const Scalar z59 = z54 * z45;
    const Scalar z60 = n4_over_3 * z55;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = -z16;
    result.M[3] = n0;
    result.M[4] = n1;
    result.M[5] = z12;
    result.M[6] = -z16;
    result.M[7] = z12;
    result.M[8] = n0_75;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = -z18;
    result.C[7] = -z19;
    result.C[8] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = z27;
    result.K[7] = z28;
    result.K[8] = -z29;
    result.F[0] = -s_phi * l_N - z25;
    result.F[1] = c_phi * l_N - z26;
    result.F[2] = -z24;
    result.M_r[0] = z9;
    result.M_r[1] = n0;
    result.M_r[2] = n0;
    result.M_r[3] = n0_75;
    result.C_r[0] = z38;
    result.C_r[1] = z40;
    result.C_r[2] = -z47;
    result.C_r[3] = z41;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = z54;
    result.K_r[5] = -z55;
    result.F_r[0] = -z56;
    result.F_r[1] = -z48;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = z34;
    result.A[12] = n0;
    result.A[13] = -z59;
    result.A[14] = z60;
    result.A[15] = n1;
    result.A[16] = z33;
    result.A[17] = n0;
    result.A[18] = -z57;
    result.A[19] = -z49;
    result.A[20] = n0;
    result.A[21] = n0;
    result.A[22] = n1;
    result.A[23] = z58;
    result.A[24] = -z50;
    if (!(traits::regular(z17, n1) && traits::regular(z9, z9))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[2] * result.M[5] * result.M[6] * result.M[7] * result.C[6] * result.C[7]
        * result.K[6] * result.K[7] * result.K[8] * result.F[0] * result.F[1] * result.F[2] * result.M_r[0]
        * result.C_r[0]) * (n0 * result.C_r[1] * result.C_r[2] * result.C_r[3] * result.K_r[4] * result.K_r[5]
        * result.F_r[0] * result.F_r[1] * result.A[11] * result.A[13] * result.A[14] * result.A[16] * result.A[18]
        * result.A[19] * result.A[23] * result.A[24]);
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 9>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7], KernelFunction<void, Constraints&>(constraints));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace chaplygin_sleigh
