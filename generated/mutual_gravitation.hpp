// SPDX-License-Identifier: MIT-0
// mutual_gravitation: Two masses under their mutual gravitation
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               12               20          0             0                  1       0     34      42
//   mass_matrix               1                5          0             0                  0       0      6       6
//   bias                      5               19          1             1                  0       0     26      31
//   inverse_dynamics          8               26          1             1                  0       0     36      41
//   forward_dynamics          6               24          2             1                  0       0     33      38
//   energy                   10               18          1             1                  1       0     32      35
//   first_integrals          12               24          1             1                  1       0     40      43
//   linearisation            18               63          4             1                  0       0     86      94
//
// Not computed because this mechanism does not need it:
//   kinematics: of 72 results 32 vanish identically, 15 repeat another up to sign
//   mass_matrix: of 16 results 12 vanish identically
//   bias: of 4 results 2 vanish identically
//   forward_dynamics: of 4 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 116 results 94 vanish identically
//
// To write this file again:
//   mutual_gravitation_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output mutual_gravitation.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace mutual_gravitation {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 4> coordinates{{{"X", "m"}, {"Y", "m"}, {"r", "m"}, {"phi",
      "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 4> velocities{{{"X", "m/s"}, {"Y", "m/s"}, {"r", "m/s"},
      {"phi", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 31> results{{{"result", "first_position", 3, 1, 1, "m"},
      {"result", "first_rotation", 3, 3, 2, "1"}, {"result", "first_velocity", 3, 1, 1, "m/s"}, {"result",
      "first_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "second_position", 3, 1, 1, "m"}, {"result",
      "second_rotation", 3, 3, 2, "1"}, {"result", "second_velocity", 3, 1, 1, "m/s"}, {"result",
      "second_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "P1_position", 3, 1, 1, "m"}, {"result", "P1_velocity",
      3, 1, 1, "m/s"}, {"result", "P1_jacobian", 3, 4, 2, ""}, {"result", "P2_position", 3, 1, 1, "m"}, {"result",
      "P2_velocity", 3, 1, 1, "m/s"}, {"result", "P2_jacobian", 3, 4, 2, ""}, {"mass", "", 4, 4, 2, ""}, {"forces", "",
      4, 1, 1, "0, 0, N, N m"}, {"forces", "", 4, 1, 1, "N, N, N, N m"}, {"accelerations", "", 4, 1, 1,
      "0, 0, m/s^2, rad/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result",
      "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result",
      "momentum_X", 1, 1, 0, "N s"}, {"result", "momentum_Y", 1, 1, 0, "N s"}, {"result", "momentum_phi", 1, 1, 0,
      "N m s"}, {"result", "M", 4, 4, 2, ""}, {"result", "C", 4, 4, 2, ""}, {"result", "K", 4, 4, 2, ""}, {"result",
      "F", 4, 1, 1, "N, N, N, N m"}, {"result", "A", 8, 8, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 14}, {"mass_matrix", false, false, false, false, results.data() + 14, 1}, {"bias", false,
      false, false, false, results.data() + 15, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 16,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 17, 2}, {"energy", false, false, true, false,
      results.data() + 19, 3}, {"first_integrals", false, false, false, false, results.data() + 22, 4},
      {"linearisation", true, true, true, true, results.data() + 26, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::mutual_gravitation::Description;

  static constexpr const char* name = "mutual_gravitation";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x54f3193c85ae19efULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 4;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 4;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar X;  ///< coordinate [m]
    Scalar Y;  ///< coordinate [m]
    Scalar r;  ///< coordinate [m]
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::X, &Coordinates::Y, &Coordinates::r,
          &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar X;  ///< its rate [m/s]
    Scalar Y;  ///< its rate [m/s]
    Scalar r;  ///< its rate [m/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::X, &Velocities::Y, &Velocities::r, &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar X;  ///< its second rate [m/s^2]
    Scalar Y;  ///< its second rate [m/s^2]
    Scalar r;  ///< its second rate [m/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::X, &Accelerations::Y, &Accelerations::r,
          &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar X;  ///< works with the rate of X [N]
    Scalar Y;  ///< works with the rate of Y [N]
    Scalar r;  ///< works with the rate of r [N]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::X, &GeneralizedForces::Y,
          &GeneralizedForces::r, &GeneralizedForces::phi};
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
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_125 = traits::constant(0.125, 0.125f, "1/8");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    state.time = n0;
    state.q.X = n0;
    state.q.Y = n0;
    state.q.r = n0_4;
    state.q.phi = n0;
    state.v.X = n0_25;
    state.v.Y = -n0_125;
    state.v.r = n0;
    state.v.phi = n10;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> first_position;  ///< centre of mass of first [m]
    std::array<Scalar, 9> first_rotation;  ///< from the axes of first to the ground's (3 x 3)
    std::array<Scalar, 3> first_velocity;  ///< velocity of the centre of mass of first [m/s]
    std::array<Scalar, 3> first_angular_velocity;  ///< angular velocity of first [rad/s]
    std::array<Scalar, 3> second_position;  ///< centre of mass of second [m]
    std::array<Scalar, 9> second_rotation;  ///< from the axes of second to the ground's (3 x 3)
    std::array<Scalar, 3> second_velocity;  ///< velocity of the centre of mass of second [m/s]
    std::array<Scalar, 3> second_angular_velocity;  ///< angular velocity of second [rad/s]
    std::array<Scalar, 3> P1_position;  ///< position of P1 [m]
    std::array<Scalar, 3> P1_velocity;  ///< velocity of the material point at P1 [m/s]
    std::array<Scalar, 12> P1_jacobian;  ///< partial velocities of P1 (3 x 4)
    std::array<Scalar, 3> P2_position;  ///< position of P2 [m]
    std::array<Scalar, 3> P2_velocity;  ///< velocity of the material point at P2 [m/s]
    std::array<Scalar, 12> P2_jacobian;  ///< partial velocities of P2 (3 x 4)
  };

  /// Energies of the mechanism.
  struct Energy {
    Scalar kinetic;  ///< kinetic energy T [J]
    Scalar force_function;  ///< force function U of gravity, springs, attractions and given functions [J]
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
    Scalar momentum_X;  ///< dT/dX' of the cyclic coordinate 'X' [N s]
    Scalar momentum_Y;  ///< dT/dY' of the cyclic coordinate 'Y' [N s]
    Scalar momentum_phi;  ///< dT/dphi' of the cyclic coordinate 'phi' [N m s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy, &FirstIntegrals::momentum_X,
          &FirstIntegrals::momentum_Y, &FirstIntegrals::momentum_phi};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 16> M;  ///< mass matrix (4 x 4)
    std::array<Scalar, 16> C;  ///< damping and gyroscopic terms (4 x 4)
    std::array<Scalar, 16> K;  ///< stiffness (4 x 4)
    std::array<Scalar, 4> F;  ///< right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, e'): x' = A x + B du (8 x 8)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_X = state.q.X;
    const Scalar v_X = state.v.X;
    const Scalar q_Y = state.q.Y;
    const Scalar v_Y = state.v.Y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_r = state.q.r;
    const Scalar v_r = state.v.r;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = n0_25 * q_r;
    const Scalar z1 = n0_75 * q_r;
    const Scalar z2 = n0_25 * c_phi;
    const Scalar z3 = n0_25 * s_phi;
    const Scalar z4 = n0_75 * c_phi;
    const Scalar z5 = n0_75 * s_phi;
    const Scalar z6 = v_phi * z0;
    const Scalar z7 = v_phi * z1;
    const Scalar z8 = q_r * z2;
    const Scalar z9 = q_r * z3;
    const Scalar z10 = v_X + s_phi * z6 - v_r * z2;  // velocity of first, x
    const Scalar z11 = v_Y - c_phi * z6 - v_r * z3;  // velocity of first, y
    const Scalar z12 = q_r * z4;
    const Scalar z13 = q_r * z5;
    const Scalar z14 = v_X - s_phi * z7 + v_r * z4;  // velocity of second, x
    const Scalar z15 = v_Y + c_phi * z7 + v_r * z5;  // velocity of second, y
    const Scalar z16 = q_X - z8;  // place of first, x
    const Scalar z17 = q_Y - z9;  // place of first, y
    const Scalar z18 = q_X + z12;  // place of second, x
    const Scalar z19 = q_Y + z13;  // place of second, y
    result.first_position[0] = z16;
    result.first_position[1] = z17;
    result.first_position[2] = n0;
    result.first_rotation[0] = c_phi;
    result.first_rotation[1] = s_phi;
    result.first_rotation[2] = n0;
    result.first_rotation[3] = -s_phi;
    result.first_rotation[4] = c_phi;
    result.first_rotation[5] = n0;
    result.first_rotation[6] = n0;
    result.first_rotation[7] = n0;
    result.first_rotation[8] = n1;
    result.first_velocity[0] = z10;
    result.first_velocity[1] = z11;
    result.first_velocity[2] = n0;
    result.first_angular_velocity[0] = n0;
    result.first_angular_velocity[1] = n0;
    result.first_angular_velocity[2] = v_phi;
    result.second_position[0] = z18;
    result.second_position[1] = z19;
    result.second_position[2] = n0;
    result.second_rotation[0] = c_phi;
    result.second_rotation[1] = s_phi;
    result.second_rotation[2] = n0;
    result.second_rotation[3] = -s_phi;
    result.second_rotation[4] = c_phi;
    result.second_rotation[5] = n0;
    result.second_rotation[6] = n0;
    result.second_rotation[7] = n0;
    result.second_rotation[8] = n1;
    result.second_velocity[0] = z14;
    result.second_velocity[1] = z15;
    result.second_velocity[2] = n0;
    result.second_angular_velocity[0] = n0;
    result.second_angular_velocity[1] = n0;
    result.second_angular_velocity[2] = v_phi;
    result.P1_position[0] = z16;
    result.P1_position[1] = z17;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = z10;
    result.P1_velocity[1] = z11;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = -z2;
    result.P1_jacobian[9] = z9;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z3;
    result.P1_jacobian[10] = -z8;
    result.P1_jacobian[2] = n0;
    result.P1_jacobian[5] = n0;
    result.P1_jacobian[8] = n0;
    result.P1_jacobian[11] = n0;
    result.P2_position[0] = z18;
    result.P2_position[1] = z19;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = z14;
    result.P2_velocity[1] = z15;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z4;
    result.P2_jacobian[9] = -z13;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = z5;
    result.P2_jacobian[10] = z12;
    result.P2_jacobian[2] = n0;
    result.P2_jacobian[5] = n0;
    result.P2_jacobian[8] = n0;
    result.P2_jacobian[11] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 16>& mass) noexcept {
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_r = state.q.r;
    const Scalar z0 = n0_25 * q_r;
    const Scalar z1 = n0_75 * q_r;
    const Scalar z2 = z1 * z1;
    const Scalar z3 = n3 * z0 * z0;
    const Scalar z4 = z2 + z3;
    mass[0] = n4;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n4;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0_75;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = z4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_phi = state.v.phi;
    const Scalar q_r = state.q.r;
    const Scalar v_r = state.v.r;
    const Scalar z0 = n0_75 * q_r;
    const Scalar z1 = n0_25 * q_r;
    const Scalar z2 = v_phi * v_phi;
    const Scalar z3 = v_phi * v_r;
    const Scalar z4 = z0 + z1;
    const Scalar z5 = z1 * z2;
    const Scalar z6 = z0 * z2;
    const Scalar z7 = n0_5 * z3;
    const Scalar z8 = n1_5 * z3;
    const Scalar z9 = z4 * z4;
    const Scalar z10 = n3 * z7;  // force on first, y
    const Scalar z11 = traits::sqrt(z9);
    const Scalar z12 = z0 * z8 + z1 * z10;  // moment on line, z
    const Scalar z13 = n1 / z11;
    const Scalar z14 = n3 * z13 * z13 * z13;
    const Scalar z15 = z4 * z14;
    const Scalar z16 = z15 - z6;  // force on second, x
    const Scalar z17 = z15 - n3 * z5;  // force on first, x
    const Scalar z18 = n0_75 * z16 + n0_25 * z17;
    forces.X = n0;
    forces.Y = n0;
    forces.r = z18;
    forces.phi = z12;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar a_X = accelerations.X;
    const Scalar a_Y = accelerations.Y;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar q_r = state.q.r;
    const Scalar v_r = state.v.r;
    const Scalar a_r = accelerations.r;
    const Scalar z0 = n0_75 * q_r;
    const Scalar z1 = n0_25 * q_r;
    const Scalar z2 = v_phi * v_phi;
    const Scalar z3 = v_phi * v_r;
    const Scalar z4 = n4 * a_X;
    const Scalar z5 = n4 * a_Y;
    const Scalar z6 = z0 + z1;
    const Scalar z7 = z0 * z2;
    const Scalar z8 = z1 * z2;
    const Scalar z9 = n0_5 * z3;
    const Scalar z10 = n1_5 * z3;
    const Scalar z11 = z0 * z0;
    const Scalar z12 = z6 * z6;
    const Scalar z13 = n3 * z9;  // force on first, y
    const Scalar z14 = n3 * z1 * z1;
    const Scalar z15 = traits::sqrt(z12);
    const Scalar z16 = z11 + z14;
    const Scalar z17 = z0 * z10 + z1 * z13;  // moment on line, z
    const Scalar z18 = a_phi * z16 + z17;
    const Scalar z19 = n1 / z15;
    const Scalar z20 = n3 * z19 * z19 * z19;
    const Scalar z21 = z6 * z20;
    const Scalar z22 = z21 - z7;  // force on second, x
    const Scalar z23 = z21 - n3 * z8;  // force on first, x
    const Scalar z24 = n0_75 * z22 + n0_25 * z23;
    const Scalar z25 = n0_75 * a_r + z24;
    forces.X = z4;
    forces.Y = z5;
    forces.r = z25;
    forces.phi = z18;
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
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4_over_3 = traits::constant(1.3333333333333333, 1.3333334f, "4/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_phi = state.v.phi;
    const Scalar q_r = state.q.r;
    const Scalar v_r = state.v.r;
    const Scalar z0 = n0_75 * q_r;
    const Scalar z1 = n0_25 * q_r;
    const Scalar z2 = v_phi * v_phi;
    const Scalar z3 = v_phi * v_r;
    const Scalar z4 = z0 + z1;
    const Scalar z5 = z1 * z2;
    const Scalar z6 = z0 * z0;
    const Scalar z7 = n3 * z1 * z1;
    const Scalar z8 = z0 * z2;
    const Scalar z9 = n0_5 * z3;
    const Scalar z10 = n1_5 * z3;
    const Scalar z11 = z4 * z4;
    const Scalar z12 = n3 * z9;  // force on first, y
    const Scalar z13 = traits::sqrt(z11);
    const Scalar z14 = z0 * z10 + z1 * z12;  // moment on line, z
    const Scalar z15 = z6 + z7;
    const Scalar z16 = n1 / z15;
    const Scalar z17 = z14 * z16;
    const Scalar z18 = n1 / z13;
    const Scalar z19 = n3 * z18 * z18 * z18;
    const Scalar z20 = z4 * z19;
    const Scalar z21 = z20 - z8;  // force on second, x
    const Scalar z22 = z20 - n3 * z5;  // force on first, x
    const Scalar z23 = n0_75 * z21 + n0_25 * z22;
    const Scalar z24 = n4_over_3 * z23;
    accelerations.X = n0;
    accelerations.Y = n0;
    accelerations.r = -z24;
    accelerations.phi = -z17;
    if (!(traits::regular(z15, z15))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.r * accelerations.phi;
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
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_X = state.v.X;
    const Scalar v_Y = state.v.Y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_r = state.q.r;
    const Scalar v_r = state.v.r;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = n0_25 * q_r;
    const Scalar z1 = n0_75 * q_r;
    const Scalar z2 = v_X * c_phi + v_Y * s_phi;
    const Scalar z3 = v_X * s_phi - v_Y * c_phi;
    const Scalar z4 = z0 + z1;
    const Scalar z5 = z4 * z4;
    const Scalar z6 = traits::sqrt(z5);
    const Scalar z7 = n1 / z6;
    const Scalar z8 = v_phi * z0 + z3;
    const Scalar z9 = n0_25 * v_r - z2;  // velocity of first, x
    const Scalar z10 = v_phi * z1 - z3;
    const Scalar z11 = n0_75 * v_r + z2;  // velocity of second, x
    result.kinetic = n1_5 * (z8 * z8 + z9 * z9) + n0_5 * (z10 * z10 + z11 * z11);
    result.force_function = n3 * z7;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar v_X = state.v.X;
    const Scalar v_Y = state.v.Y;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_r = state.q.r;
    const Scalar v_r = state.v.r;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = n0_25 * q_r;
    const Scalar z1 = n0_75 * q_r;
    const Scalar z2 = v_X * c_phi + v_Y * s_phi;
    const Scalar z3 = v_X * s_phi - v_Y * c_phi;
    const Scalar z4 = z0 + z1;
    const Scalar z5 = z1 * z1;
    const Scalar z6 = n3 * z0 * z0;
    const Scalar z7 = z4 * z4;
    const Scalar z8 = traits::sqrt(z7);
    const Scalar z9 = z5 + z6;
    const Scalar z10 = n1 / z8;
    const Scalar z11 = v_phi * z0 + z3;
    const Scalar z12 = n0_25 * v_r - z2;  // velocity of first, x
    const Scalar z13 = v_phi * z1 - z3;
    const Scalar z14 = n0_75 * v_r + z2;  // velocity of second, x
    result.energy = n1_5 * (z11 * z11 + z12 * z12) + n0_5 * (z13 * z13 + z14 * z14) - n3 * z10;
    result.momentum_X = n4 * v_X;
    result.momentum_Y = n4 * v_Y;
    result.momentum_phi = v_phi * z9;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n4_over_3 = traits::constant(1.3333333333333333, 1.3333334f, "4/3");
    const Scalar n9 = traits::constant(9.0, 9.0f, "9/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_X = accelerations.X;
    const Scalar a_Y = accelerations.Y;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar q_r = state.q.r;
    const Scalar v_r = state.v.r;
    const Scalar a_r = accelerations.r;
    const Scalar z0 = n0_75 * q_r;
    const Scalar z1 = n0_25 * q_r;
    const Scalar z2 = v_phi * v_phi;
    const Scalar z3 = n0_5 * v_phi;
    const Scalar z4 = n1_5 * v_phi;
    const Scalar z5 = n2 * v_phi;
    const Scalar z6 = z0 + z1;
    const Scalar z7 = z0 * z0;
    const Scalar z8 = n3 * z1 * z1;
    const Scalar z9 = v_r * z3;
    const Scalar z10 = z0 * z2;
    const Scalar z11 = z6 * z6;
    const Scalar z12 = n2 * z6;
    const Scalar z13 = v_r * z4;
    const Scalar z14 = n0_75 * z2;
    const Scalar z15 = z1 * z2;
    const Scalar z16 = n3 * z9;  // force on first, y
    const Scalar z17 = traits::sqrt(z11);
    const Scalar z18 = z7 + z8;
    const Scalar z19 = n0_25 * z2;
    const Scalar z20 = n1_5 * z0;
    const Scalar z21 = n1_5 * z1;
    const Scalar z22 = z0 * z5;
    const Scalar z23 = z1 * z5;
    const Scalar z24 = n1_5 * v_r;
    const Scalar z25 = n0_5 * v_r;
    const Scalar z26 = z20 + z21;
    const Scalar z27 = n3 * z3;
    const Scalar z28 = n0_75 * z13 + n0_25 * z16;
    const Scalar z29 = z0 * z13 + z1 * z16;  // moment on line, z
    const Scalar z30 = n3 * z23;
    const Scalar z31 = n3 * z25;
    const Scalar z32 = z0 * z4 + z1 * z27;
    const Scalar z33 = a_phi * z26 + z28;
    const Scalar z34 = n0_75 * z22 + n0_25 * z30;
    const Scalar z35 = z0 * z24 + z1 * z31;
    const Scalar z36 = n1 / z18;
    const Scalar z37 = n4 * a_X;
    const Scalar z38 = n4 * a_Y;
    const Scalar z39 = a_phi * z18 + z29;
    const Scalar z40 = z33 * z36;
    const Scalar z41 = n0_5 * z12 / z17;
    const Scalar z42 = n1 / z17;
    const Scalar z43 = z32 * z36;
    const Scalar z44 = n4_over_3 * z34;
    const Scalar z45 = z35 * z36;
    const Scalar z46 = n3 * z42 * z42 * z42;
    const Scalar z47 = z41 / (z17 * z17);
    const Scalar z48 = z6 * z46;
    const Scalar z49 = z48 - z10;  // force on second, x
    const Scalar z50 = z48 - n3 * z15;  // force on first, x
    const Scalar z51 = n9 * z42 * z42 * z47;
    const Scalar z52 = n0_75 * z49 + n0_25 * z50;
    const Scalar z53 = z6 * z51 - z46;
    const Scalar z54 = z53 + z14;
    const Scalar z55 = z53 + n3 * z19;
    const Scalar z56 = n0_75 * a_r + z52;
    const Scalar z57 = n0_75 * z54 + n0_25 * z55;
    const Scalar z58 = n4_over_3 * z57;
    result.M[0] = n4;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n4;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n0_75;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n0;
    result.M[15] = z18;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = n0;
    result.C[8] = n0;
    result.C[9] = n0;
    result.C[10] = n0;
    result.C[11] = z32;
    result.C[12] = n0;
    result.C[13] = n0;
    result.C[14] = -z34;
    result.C[15] = z35;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.K[9] = n0;
    result.K[10] = -z57;
    result.K[11] = z33;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.F[0] = -z37;
    result.F[1] = -z38;
    result.F[2] = -z56;
    result.F[3] = -z39;
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
    result.A[11] = n0;
    result.A[12] = n0;
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = n0;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = n0;
    result.A[22] = z58;
    result.A[23] = -z40;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = n0;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = n0;
    result.A[55] = -z43;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n1;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = z44;
    result.A[63] = -z45;
    if (!(traits::regular(z18, z18))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.M[15] * result.C[11] * result.C[14] * result.C[15] * result.K[10] * result.K[11]
        * result.F[0] * result.F[1] * result.F[2] * result.F[3] * result.A[22] * result.A[23] * result.A[55]
        * result.A[62] * result.A[63];
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 16>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace mutual_gravitation
