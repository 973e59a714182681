// SPDX-License-Identifier: MIT-0
// segment_in_sphere: A rod slides inside a sphere
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
//   kinematics               41               76          0             0                  3       0    123     138
//   mass_matrix               4                9          0             0                  2       0     17      17
//   bias                     10               24          0             0                  2       0     38      40
//   inverse_dynamics         16               27          0             0                  2       0     47      50
//   forward_dynamics         15               39          2             0                  2       0     60      61
//   energy                    5               14          0             0                  2       0     23      23
//   first_integrals          11               24          0             0                  2       0     39      39
//   linearisation            74              144          2             0                  2       0    224     238
//
// Not computed because this mechanism does not need it:
//   kinematics: of 48 results 2 vanish identically, 4 repeat another up to sign
//   mass_matrix: of 9 results 2 vanish identically, 2 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 66 results 24 vanish identically, 2 repeat another up to sign
//
// To write this file again:
//   segment_in_sphere_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output segment_in_sphere.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace segment_in_sphere {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"psi", "rad"}, {"theta", "rad"}, {"phi",
      "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"psi", "rad/s"}, {"theta", "rad/s"}, {"phi",
      "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 25> results{{{"result", "rod_position", 3, 1, 1, "m"},
      {"result", "rod_rotation", 3, 3, 2, "1"}, {"result", "rod_velocity", 3, 1, 1, "m/s"}, {"result",
      "rod_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "A_position", 3, 1, 1, "m"}, {"result", "A_velocity", 3, 1,
      1, "m/s"}, {"result", "A_jacobian", 3, 3, 2, "m"}, {"result", "B_position", 3, 1, 1, "m"}, {"result",
      "B_velocity", 3, 1, 1, "m/s"}, {"result", "B_jacobian", 3, 3, 2, "m"}, {"mass", "", 3, 3, 2, "kg m^2"}, {"forces",
      "", 3, 1, 1, "N m"}, {"forces", "", 3, 1, 1, "N m"}, {"accelerations", "", 3, 1, 1, "rad/s^2"}, {"multipliers",
      "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result",
      "power", 1, 1, 0, "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result", "momentum_psi", 1, 1, 0, "N m s"},
      {"result", "M", 3, 3, 2, "kg m^2"}, {"result", "C", 3, 3, 2, "N m s"}, {"result", "K", 3, 3, 2, "N m"}, {"result",
      "F", 3, 1, 1, "N m"}, {"result", "A", 6, 6, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 10}, {"mass_matrix", false, false, false, false, results.data() + 10, 1}, {"bias", false,
      false, false, false, results.data() + 11, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 12,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 13, 2}, {"energy", false, false, true, false,
      results.data() + 15, 3}, {"first_integrals", false, false, false, false, results.data() + 18, 2},
      {"linearisation", true, true, true, true, results.data() + 20, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::segment_in_sphere::Description;

  static constexpr const char* name = "segment_in_sphere";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x51ad1a5913492ecbULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 3;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 2;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar psi;  ///< coordinate [rad]
    Scalar theta;  ///< coordinate [rad]
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::psi, &Coordinates::theta, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::psi, &Velocities::theta, &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::psi, &Accelerations::theta, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::psi, &GeneralizedForces::theta,
          &GeneralizedForces::phi};
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
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    state.time = n0;
    state.q.psi = n0;
    state.q.theta = n2;
    state.q.phi = n0_5;
    state.v.psi = n1;
    state.v.theta = n0;
    state.v.phi = n3;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> rod_position;  ///< centre of mass of rod [m]
    std::array<Scalar, 9> rod_rotation;  ///< from the axes of rod to the ground's (3 x 3)
    std::array<Scalar, 3> rod_velocity;  ///< velocity of the centre of mass of rod [m/s]
    std::array<Scalar, 3> rod_angular_velocity;  ///< angular velocity of rod [rad/s]
    std::array<Scalar, 3> A_position;  ///< position of A [m]
    std::array<Scalar, 3> A_velocity;  ///< velocity of the material point at A [m/s]
    std::array<Scalar, 9> A_jacobian;  ///< partial velocities of A (3 x 3)
    std::array<Scalar, 3> B_position;  ///< position of B [m]
    std::array<Scalar, 3> B_velocity;  ///< velocity of the material point at B [m/s]
    std::array<Scalar, 9> B_jacobian;  ///< partial velocities of B (3 x 3)
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
    Scalar momentum_psi;  ///< dT/dpsi' of the cyclic coordinate 'psi' [N m s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy, &FirstIntegrals::momentum_psi};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 36> A;  ///< state matrix of x = (e, e'): x' = A x + B du (6 x 6)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = v_psi * s_theta;
    const Scalar z1 = s_psi * c_theta;
    const Scalar z2 = c_psi * c_theta;
    const Scalar z3 = s_psi * s_theta;
    const Scalar z4 = c_psi * s_theta;
    const Scalar z5 = v_psi * c_theta;
    const Scalar z6 = s_theta * s_phi;
    const Scalar z7 = n0_8 * c_theta;
    const Scalar z8 = c_psi * v_theta;  // angular velocity of second, x
    const Scalar z9 = s_psi * v_theta;  // angular velocity of second, y
    const Scalar z10 = s_theta * c_phi;
    const Scalar z11 = v_psi + c_theta * v_phi;  // angular velocity of rod, z
    const Scalar z12 = c_psi * c_phi - s_phi * z1;
    const Scalar z13 = c_psi * s_phi + c_phi * z1;
    const Scalar z14 = s_psi * c_phi + s_phi * z2;
    const Scalar z15 = s_psi * s_phi - c_phi * z2;
    const Scalar z16 = v_theta * c_phi + s_phi * z0;
    const Scalar z17 = v_theta * s_phi - c_phi * z0;
    const Scalar z18 = v_phi + z5;
    const Scalar z19 = v_phi * z3 + z8;  // angular velocity of rod, x
    const Scalar z20 = v_phi * z4 - z9;  // angular velocity of rod, y
    const Scalar z21 = n0_8 * z3;
    const Scalar z22 = n0_8 * z4;
    const Scalar z23 = n0_6 * z6 - z7;
    const Scalar z24 = n0_6 * z6 + z7;
    const Scalar z25 = n0_6 * z18;
    const Scalar z26 = n0_8 * z17;
    const Scalar z27 = n0_8 * z16;
    const Scalar z28 = n0_6 * z12 - z21;
    const Scalar z29 = n0_6 * z14 + z22;
    const Scalar z30 = n0_6 * z17;
    const Scalar z31 = s_psi * z23;
    const Scalar z32 = c_psi * z23;
    const Scalar z33 = n0_6 * z12 + z21;
    const Scalar z34 = n0_6 * z14 - z22;
    const Scalar z35 = s_psi * z24;
    const Scalar z36 = c_psi * z24;
    const Scalar z37 = z12 * z26;
    const Scalar z38 = z14 * z26;
    const Scalar z39 = z6 * z26;
    const Scalar z40 = z27 + z25;
    const Scalar z41 = z27 - z25;
    const Scalar z42 = z4 * z23 + c_theta * z29;
    const Scalar z43 = c_theta * z28 - z3 * z23;
    const Scalar z44 = z3 * z29 + z4 * z28;
    const Scalar z45 = s_psi * z28 - c_psi * z29;
    const Scalar z46 = z4 * z24 + c_theta * z34;
    const Scalar z47 = c_theta * z33 - z3 * z24;
    const Scalar z48 = z3 * z34 + z4 * z33;
    const Scalar z49 = s_psi * z33 - c_psi * z34;
    const Scalar z50 = z13 * z27 - z37;
    const Scalar z51 = z15 * z27 - z38;
    const Scalar z52 = z10 * z27 + z39;
    const Scalar z53 = z37 + z3 * z30 - z13 * z40;
    const Scalar z54 = z4 * z30 - z38 + z15 * z40;
    const Scalar z55 = z39 + c_theta * z30 + z10 * z40;
    const Scalar z56 = z3 * z30 - z37 + z13 * z41;
    const Scalar z57 = z38 + z4 * z30 - z15 * z41;
    const Scalar z58 = c_theta * z30 - z39 - z10 * z41;
    result.rod_position[0] = z21;
    result.rod_position[1] = -z22;
    result.rod_position[2] = z7;
    result.rod_rotation[0] = z12;
    result.rod_rotation[1] = z14;
    result.rod_rotation[2] = z6;
    result.rod_rotation[3] = -z13;
    result.rod_rotation[4] = -z15;
    result.rod_rotation[5] = z10;
    result.rod_rotation[6] = z3;
    result.rod_rotation[7] = -z4;
    result.rod_rotation[8] = c_theta;
    result.rod_velocity[0] = z50;
    result.rod_velocity[1] = z51;
    result.rod_velocity[2] = -z52;
    result.rod_angular_velocity[0] = z19;
    result.rod_angular_velocity[1] = -z20;
    result.rod_angular_velocity[2] = z11;
    result.A_position[0] = -z28;
    result.A_position[1] = -z29;
    result.A_position[2] = -z23;
    result.A_velocity[0] = -z53;
    result.A_velocity[1] = z54;
    result.A_velocity[2] = -z55;
    result.A_jacobian[0] = z29;
    result.A_jacobian[3] = -z31;
    result.A_jacobian[6] = z42;
    result.A_jacobian[1] = -z28;
    result.A_jacobian[4] = z32;
    result.A_jacobian[7] = -z43;
    result.A_jacobian[2] = n0;
    result.A_jacobian[5] = z45;
    result.A_jacobian[8] = -z44;
    result.B_position[0] = z33;
    result.B_position[1] = z34;
    result.B_position[2] = z24;
    result.B_velocity[0] = z56;
    result.B_velocity[1] = -z57;
    result.B_velocity[2] = z58;
    result.B_jacobian[0] = -z34;
    result.B_jacobian[3] = z35;
    result.B_jacobian[6] = -z46;
    result.B_jacobian[1] = z33;
    result.B_jacobian[4] = -z36;
    result.B_jacobian[7] = z47;
    result.B_jacobian[2] = n0;
    result.B_jacobian[5] = -z49;
    result.B_jacobian[8] = z48;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 9>& mass) noexcept {
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_64 = traits::constant(0.64, 0.64f, "16/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar angles_[] = {q_theta, q_phi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar z0 = n0_12 * c_phi;
    const Scalar z1 = n0_12 * s_phi;
    const Scalar z2 = n0_12 * c_theta;
    const Scalar z3 = c_phi * z0;
    const Scalar z4 = s_phi * z1;
    const Scalar z5 = s_phi * z0;
    const Scalar z6 = n0_64 + z4;
    const Scalar z7 = n0_64 + z3;
    const Scalar z8 = s_theta * z5;
    const Scalar z9 = n0_12 - z7;
    const Scalar z10 = s_theta * z9;
    const Scalar z11 = s_theta * z10;
    const Scalar z12 = n0_12 - z11;
    mass[0] = z12;
    mass[1] = -z8;
    mass[2] = z2;
    mass[3] = -z8;
    mass[4] = z6;
    mass[5] = n0;
    mass[6] = z2;
    mass[7] = n0;
    mass[8] = n0_12;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_64 = traits::constant(0.64, 0.64f, "16/25");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_phi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar z0 = v_psi * c_theta;
    const Scalar z1 = v_psi * s_theta;
    const Scalar z2 = n9_81 * s_theta;
    const Scalar z3 = v_theta * z0;  // angular acceleration of second, y
    const Scalar z4 = v_theta * z1;  // angular acceleration of second, z
    const Scalar z5 = v_theta * c_phi + s_phi * z1;
    const Scalar z6 = v_theta * s_phi - c_phi * z1;
    const Scalar z7 = v_phi + z0;  // angular velocity of rod, z
    const Scalar z8 = z1 * z0;
    const Scalar z9 = c_phi * z3;
    const Scalar z10 = n2 * z3;
    const Scalar z11 = z5 * z7;
    const Scalar z12 = z5 * z6;
    const Scalar z13 = v_phi * z5 - z9;  // angular acceleration of rod, y
    const Scalar z14 = n0_12 * (z4 + z12);  // moment on rod, z
    const Scalar z15 = n0_12 * (z13 + z11);  // moment on rod, y
    const Scalar z16 = s_phi * z15;
    const Scalar z17 = c_phi * z15;
    const Scalar z18 = n0_8 * z2 - z16 + n0_64 * z8;  // moment on second, x
    const Scalar z19 = z17 - n0_64 * z10;  // moment on second, y
    const Scalar z20 = c_theta * z14 + s_theta * z19;
    forces.psi = -z20;
    forces.theta = -z18;
    forces.phi = -z14;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_64 = traits::constant(0.64, 0.64f, "16/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar angles_[] = {q_theta, q_phi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar z0 = v_psi * c_theta;
    const Scalar z1 = a_psi * s_theta;
    const Scalar z2 = v_psi * s_theta;
    const Scalar z3 = a_psi * c_theta;
    const Scalar z4 = n9_81 * s_theta;
    const Scalar z5 = v_theta * z0 + z1;  // angular acceleration of second, y
    const Scalar z6 = v_theta * z2 - z3;  // angular acceleration of second, z
    const Scalar z7 = v_theta * c_phi + s_phi * z2;
    const Scalar z8 = v_theta * s_phi - c_phi * z2;
    const Scalar z9 = v_phi + z0;  // angular velocity of rod, z
    const Scalar z10 = v_theta * z0;
    const Scalar z11 = z2 * z0;
    const Scalar z12 = a_theta * s_phi - c_phi * z5;
    const Scalar z13 = a_phi - z6;  // angular acceleration of rod, z
    const Scalar z14 = z7 * z9;
    const Scalar z15 = z7 * z8;
    const Scalar z16 = z5 + z10;
    const Scalar z17 = n0_12 * (z13 - z15);  // moment on rod, z
    const Scalar z18 = v_phi * z7 + z12;  // angular acceleration of rod, y
    const Scalar z19 = n0_12 * (z18 + z14);  // moment on rod, y
    const Scalar z20 = s_phi * z19;
    const Scalar z21 = c_phi * z19;
    const Scalar z22 = z20 + n0_64 * (a_theta - z11) - n0_8 * z4;  // moment on second, x
    const Scalar z23 = z21 - n0_64 * z16;  // moment on second, y
    const Scalar z24 = s_theta * z23 - c_theta * z17;
    forces.psi = -z24;
    forces.theta = z22;
    forces.phi = z17;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_64 = traits::constant(0.64, 0.64f, "16/25");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_phi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar z0 = n0_12 * s_phi;
    const Scalar z1 = v_psi * c_theta;
    const Scalar z2 = v_psi * s_theta;
    const Scalar z3 = n0_12 * c_phi;
    const Scalar z4 = n9_81 * s_theta;
    const Scalar z5 = c_phi * z3;
    const Scalar z6 = s_phi * z0;
    const Scalar z7 = s_phi * z3;
    const Scalar z8 = v_theta * z1;  // angular acceleration of second, y
    const Scalar z9 = v_theta * z2;  // angular acceleration of second, z
    const Scalar z10 = v_theta * c_phi + s_phi * z2;
    const Scalar z11 = v_theta * s_phi - c_phi * z2;
    const Scalar z12 = v_phi + z1;  // angular velocity of rod, z
    const Scalar z13 = z2 * z1;
    const Scalar z14 = n0_64 + z6;
    const Scalar z15 = n0_64 + z5;
    const Scalar z16 = c_phi * z8;
    const Scalar z17 = n2 * z8;
    const Scalar z18 = z10 * z12;
    const Scalar z19 = z10 * z11;
    const Scalar z20 = n1 / z14;
    const Scalar z21 = v_phi * z10 - z16;  // angular acceleration of rod, y
    const Scalar z22 = n0_12 * z19;
    const Scalar z23 = n0_12 * (z21 + z18);
    const Scalar z24 = n25_over_3 * z22;
    const Scalar z25 = s_phi * z23;
    const Scalar z26 = c_phi * z23;
    const Scalar z27 = z7 * z20;
    const Scalar z28 = n0_8 * z4 - z25 + n0_64 * z13;
    const Scalar z29 = z26 - n0_64 * z17;
    const Scalar z30 = z7 * z27 - z15;
    const Scalar z31 = s_theta * z30;
    const Scalar z32 = z20 * z28;
    const Scalar z33 = z27 * z28 + z29;
    const Scalar z34 = s_theta * z31;
    const Scalar z35 = s_theta * z33;
    const Scalar z36 = n1 / z34;
    const Scalar z37 = z36 * z35;
    const Scalar z38 = s_theta * z37;
    const Scalar z39 = c_theta * z37;
    const Scalar z40 = z27 * z38 - z32;
    const Scalar z41 = z24 + z39;
    const Scalar z42 = z9 + z41;  // acceleration of joint rod
    accelerations.psi = -z37;
    accelerations.theta = -z40;
    accelerations.phi = z42;
    if (!(traits::regular(z14, z14) && traits::regular(-z34, -z34))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.psi * accelerations.theta * accelerations.phi;
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
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n0_32 = traits::constant(0.32, 0.32f, "8/25");
    const Scalar n0_38 = traits::constant(0.38, 0.38f, "19/50");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_phi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar z0 = v_psi * s_theta;
    const Scalar z1 = v_psi * c_theta;
    const Scalar z2 = n0_8 * c_theta;
    const Scalar z3 = v_theta * c_phi + s_phi * z0;
    const Scalar z4 = v_theta * s_phi - c_phi * z0;
    const Scalar z5 = v_phi + z1;  // angular velocity of rod, z
    result.kinetic = n0_06 * z5 * z5 + n0_32 * z3 * z3 + n0_38 * z4 * z4;
    result.force_function = -n9_81 * z2;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_64 = traits::constant(0.64, 0.64f, "16/25");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n0_32 = traits::constant(0.32, 0.32f, "8/25");
    const Scalar n0_38 = traits::constant(0.38, 0.38f, "19/50");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_phi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar z0 = n0_12 * c_phi;
    const Scalar z1 = v_psi * s_theta;
    const Scalar z2 = v_psi * c_theta;
    const Scalar z3 = n0_8 * c_theta;
    const Scalar z4 = n0_12 * c_theta;
    const Scalar z5 = v_theta * c_phi + s_phi * z1;
    const Scalar z6 = v_theta * s_phi - c_phi * z1;
    const Scalar z7 = v_phi + z2;  // angular velocity of rod, z
    const Scalar z8 = c_phi * z0;
    const Scalar z9 = s_phi * z0;
    const Scalar z10 = n0_64 + z8;
    const Scalar z11 = s_theta * z9;
    const Scalar z12 = n0_12 - z10;
    const Scalar z13 = s_theta * z12;
    const Scalar z14 = s_theta * z13;
    const Scalar z15 = n0_12 - z14;
    result.energy = n9_81 * z3 + n0_06 * z7 * z7 + n0_32 * z5 * z5 + n0_38 * z6 * z6;
    result.momentum_psi = v_phi * z4 - v_theta * z11 + v_psi * z15;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_64 = traits::constant(0.64, 0.64f, "16/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_24 = traits::constant(0.24, 0.24f, "6/25");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar angles_[] = {q_theta, q_phi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar z0 = v_psi * c_theta;
    const Scalar z1 = a_psi * s_theta;
    const Scalar z2 = v_psi * s_theta;
    const Scalar z3 = a_psi * c_theta;
    const Scalar z4 = n0_12 * s_phi;
    const Scalar z5 = s_theta * s_phi;
    const Scalar z6 = v_theta * c_theta;
    const Scalar z7 = s_theta * c_phi;
    const Scalar z8 = n0_12 * c_phi;
    const Scalar z9 = v_theta * s_theta;
    const Scalar z10 = n9_81 * c_theta;
    const Scalar z11 = n0_12 * c_theta;
    const Scalar z12 = n9_81 * s_theta;
    const Scalar z13 = v_theta * z0 + z1;  // angular acceleration of second, y
    const Scalar z14 = v_theta * z2 - z3;  // angular acceleration of second, z
    const Scalar z15 = v_theta * c_phi + s_phi * z2;
    const Scalar z16 = v_theta * s_phi - c_phi * z2;
    const Scalar z17 = v_phi + z0;  // angular velocity of rod, z
    const Scalar z18 = v_theta * z0;
    const Scalar z19 = z2 * z0;
    const Scalar z20 = c_phi * z8;
    const Scalar z21 = s_phi * z4;
    const Scalar z22 = s_phi * z8;
    const Scalar z23 = v_theta * z2;  // angular acceleration of second, z
    const Scalar z24 = c_phi * z6;
    const Scalar z25 = n2 * z6;
    const Scalar z26 = s_theta * z0 + c_theta * z2;
    const Scalar z27 = c_phi * z0;
    const Scalar z28 = n2 * z0;
    const Scalar z29 = s_phi * z0;
    const Scalar z30 = n0_64 + z21;
    const Scalar z31 = n0_64 + z20;
    const Scalar z32 = s_theta * z22;
    const Scalar z33 = v_phi * z5 - z24;
    const Scalar z34 = v_phi * c_phi - z27;
    const Scalar z35 = c_phi * z17;
    const Scalar z36 = a_theta * c_phi + s_phi * z13;
    const Scalar z37 = a_theta * s_phi - c_phi * z13;
    const Scalar z38 = a_phi - z14;  // angular acceleration of rod, z
    const Scalar z39 = z15 * z17;
    const Scalar z40 = z15 * z16;
    const Scalar z41 = z13 + z18;
    const Scalar z42 = z17 * z5 + c_theta * z15;
    const Scalar z43 = z15 * z7 - z16 * z5;
    const Scalar z44 = s_phi * z15 + c_phi * z16;
    const Scalar z45 = c_phi * z14;
    const Scalar z46 = z2 * z15 - z17 * z29;
    const Scalar z47 = n0_12 - z31;
    const Scalar z48 = n0_12 * (z38 - z40);  // moment on rod, z
    const Scalar z49 = n0_12 * (z34 + z35);
    const Scalar z50 = v_phi * z29 + z45;
    const Scalar z51 = v_phi * z16 - z36;  // angular acceleration of rod, x
    const Scalar z52 = v_phi * z15 + z37;  // angular acceleration of rod, y
    const Scalar z53 = z15 * z27 - z16 * z29;
    const Scalar z54 = z14 + z23;
    const Scalar z55 = s_theta * z47;
    const Scalar z56 = n0_12 * (z33 + z42);
    const Scalar z57 = n0_12 * (z9 - z43);
    const Scalar z58 = n0_12 * (z2 + z44);
    const Scalar z59 = n0_12 * (z50 - z46);
    const Scalar z60 = n0_12 * (z52 + z39);  // moment on rod, y
    const Scalar z61 = n0_12 * (z13 - z53);
    const Scalar z62 = s_theta * z55;
    const Scalar z63 = c_phi * z49;
    const Scalar z64 = n0_12 - z62;
    const Scalar z65 = c_phi * z56;
    const Scalar z66 = s_phi * z56;
    const Scalar z67 = z63 - n0_64 * z28;
    const Scalar z68 = c_phi * z59;
    const Scalar z69 = s_phi * z60;
    const Scalar z70 = s_phi * z49;
    const Scalar z71 = c_phi * z60;
    const Scalar z72 = z2 * z2 - z0 * z0;
    const Scalar z73 = z65 - n0_64 * z25;
    const Scalar z74 = z68 + n0_64 * z54;
    const Scalar z75 = z69 + n0_64 * (a_theta - z19) - n0_8 * z12;  // moment on second, x
    const Scalar z76 = z66 - n0_64 * z26;
    const Scalar z77 = z71 - n0_64 * z41;  // moment on second, y
    const Scalar z78 = s_phi * z59;
    const Scalar z79 = n0_8 * z10 - z78 - n0_64 * z72;
    const Scalar z80 = c_theta * z57 + s_theta * z73;
    const Scalar z81 = c_theta * z58 + s_theta * z67;
    const Scalar z82 = c_theta * (z77 + z61) + s_theta * (z48 + z74);
    const Scalar z83 = s_theta * z77 - c_theta * z48;
    const Scalar z84 = z16 * z17;
    const Scalar z85 = n1 / z30;
    const Scalar z86 = n0_12 * (z51 + z84);
    const Scalar z87 = s_theta * s_theta * z31;
    const Scalar z88 = z32 * z85;
    const Scalar z89 = z15 * z15 - z16 * z16;
    const Scalar z90 = z32 * z88 - z87;
    const Scalar z91 = n0_12 * z89;
    const Scalar z92 = c_phi * z86 + z69;
    const Scalar z93 = n0_24 * z15;
    const Scalar z94 = n25_over_3 * z11;
    const Scalar z95 = c_phi * z93;
    const Scalar z96 = s_phi * z93;
    const Scalar z97 = s_phi * z86 - z71;
    const Scalar z98 = s_theta * z92 - c_theta * z91;
    const Scalar z99 = s_theta * z95;
    const Scalar z100 = n1 / z90;
    const Scalar z101 = z57 * z94 - z80 + z76 * z88;
    const Scalar z102 = z61 * z94 - z82 - z79 * z88;
    const Scalar z103 = z58 * z94 - z81 + z70 * z88;
    const Scalar z104 = z91 * z94 + z98 - z97 * z88;
    const Scalar z105 = z99 - z96 * z88;
    const Scalar z106 = z100 * z101;
    const Scalar z107 = z100 * z102;
    const Scalar z108 = z100 * z103;
    const Scalar z109 = z100 * z105;
    const Scalar z110 = z76 * z85 - z88 * z106;
    const Scalar z111 = z100 * z104;
    const Scalar z112 = n25_over_3 * z57 - z94 * z106;
    const Scalar z113 = z79 * z85 + z88 * z107;
    const Scalar z114 = n25_over_3 * z61 - z94 * z107;
    const Scalar z115 = z70 * z85 - z88 * z108;
    const Scalar z116 = n25_over_3 * z58 - z94 * z108;
    const Scalar z117 = z97 * z85 + z88 * z111;
    const Scalar z118 = n25_over_3 * z91 - z94 * z111;
    const Scalar z119 = z96 * z85 + z88 * z109;
    const Scalar z120 = z94 * z109;
    result.M[0] = z64;
    result.M[1] = -z32;
    result.M[2] = z11;
    result.M[3] = -z32;
    result.M[4] = z30;
    result.M[5] = n0;
    result.M[6] = z11;
    result.M[7] = n0;
    result.M[8] = n0_12;
    result.C[0] = -z80;
    result.C[1] = z76;
    result.C[2] = -z57;
    result.C[3] = -z81;
    result.C[4] = z70;
    result.C[5] = -z58;
    result.C[6] = -z99;
    result.C[7] = z96;
    result.C[8] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = -z82;
    result.K[4] = -z79;
    result.K[5] = -z61;
    result.K[6] = z98;
    result.K[7] = -z97;
    result.K[8] = -z91;
    result.F[0] = z83;
    result.F[1] = -z75;
    result.F[2] = -z48;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = z107;
    result.A[10] = z113;
    result.A[11] = z114;
    result.A[12] = n0;
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = z111;
    result.A[16] = z117;
    result.A[17] = z118;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = z106;
    result.A[22] = -z110;
    result.A[23] = z112;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = z108;
    result.A[28] = -z115;
    result.A[29] = z116;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = -z109;
    result.A[34] = -z119;
    result.A[35] = z120;
    if (!(traits::regular(-z90, z64) && traits::regular(z30, z30))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.M[0] * result.M[1] * result.M[2] * result.M[3] * result.M[4] * result.M[6]
        * result.C[0] * result.C[1] * result.C[2]) * (n0 * result.C[3] * result.C[4] * result.C[5] * result.C[6]
        * result.C[7] * result.K[3] * result.K[4] * result.K[5] * result.K[6] * result.K[7])) * ((n0 * result.K[8]
        * result.F[0] * result.F[1] * result.F[2] * result.A[9] * result.A[10] * result.A[11] * result.A[15]
        * result.A[16]) * (n0 * result.A[17] * result.A[21] * result.A[22] * result.A[23] * result.A[27] * result.A[28]
        * result.A[29] * result.A[33] * result.A[34] * result.A[35]));
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 9>&>(mass_matrix));
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

}  // namespace segment_in_sphere
