// SPDX-License-Identifier: MIT-0
// nose_radar: Radar on the nose of an aircraft
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, reactions, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                8               22          0             0                  2       0     34      34
//   mass_matrix               4                7          0             0                  2       0     15      15
//   bias                      8               29          0             0                  2       0     41      41
//   inverse_dynamics         20               39          0             0                  2       0     63      63
//   forward_dynamics         21               47          2             0                  2       0     74      74
//   energy                   14               31          0             0                  2       0     49      52
//   reactions                11               25          0             0                  2       0     40      40
//   linearisation            73              152          2             0                  2       0    231     241
//
// Not computed because this mechanism does not need it:
//   kinematics: of 54 results 24 vanish identically, 7 repeat another up to sign
//   mass_matrix: of 9 results 2 vanish identically, 2 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   first_integrals: left out, 'thrust', 'azimuth', 'elevation' have no force function
//   constraints: left out, the scene has no constraints
//   linearisation: of 93 results 45 vanish identically, 4 repeat another up to sign
//
// To write this file again:
//   nose_radar_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output nose_radar.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace nose_radar {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"x", "m"}, {"alpha", "rad"}, {"beta",
      "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"x", "m/s"}, {"alpha", "rad/s"}, {"beta",
      "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> inputs{{{"thrust", "N"}, {"azimuth", "N m"}, {"elevation",
      "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 29> results{{{"result", "aircraft_position", 3, 1, 1, "m"},
      {"result", "aircraft_rotation", 3, 3, 2, "1"}, {"result", "aircraft_velocity", 3, 1, 1, "m/s"}, {"result",
      "aircraft_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "unit_1_position", 3, 1, 1, "m"}, {"result",
      "unit_1_rotation", 3, 3, 2, "1"}, {"result", "unit_1_velocity", 3, 1, 1, "m/s"}, {"result",
      "unit_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "antenna_position", 3, 1, 1, "m"}, {"result",
      "antenna_rotation", 3, 3, 2, "1"}, {"result", "antenna_velocity", 3, 1, 1, "m/s"}, {"result",
      "antenna_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 3, 3, 2, ""}, {"forces", "", 3, 1, 1, "N, N m, N m"},
      {"forces", "", 3, 1, 1, "N, N m, N m"}, {"accelerations", "", 3, 1, 1, "m/s^2, rad/s^2, rad/s^2"}, {"multipliers",
      "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result",
      "power", 1, 1, 0, "W"}, {"result", "F_x", 1, 1, 0, "N"}, {"result", "F_x2", 1, 1, 0, "N"}, {"result", "M", 3, 3,
      2, ""}, {"result", "C", 3, 3, 2, ""}, {"result", "K", 3, 3, 2, ""}, {"result", "F", 3, 1, 1, "N, N m, N m"},
      {"result", "E", 3, 3, 2, "1"}, {"result", "A", 6, 6, 2, ""}, {"result", "B", 6, 3, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 12}, {"mass_matrix", false, false, false, false, results.data() + 12, 1}, {"bias", false,
      false, false, false, results.data() + 13, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 14,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 15, 2}, {"energy", false, false, true, false,
      results.data() + 17, 3}, {"reactions", true, true, true, false, results.data() + 20, 2}, {"linearisation", true,
      true, true, true, results.data() + 22, 7}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::nose_radar::Description;

  static constexpr const char* name = "nose_radar";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xcbe747f3cffd4db8ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 3;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 3;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar alpha;  ///< coordinate [rad]
    Scalar beta;  ///< coordinate [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::alpha, &Coordinates::beta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar alpha;  ///< its rate [rad/s]
    Scalar beta;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::alpha, &Velocities::beta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar alpha;  ///< its second rate [rad/s^2]
    Scalar beta;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::alpha, &Accelerations::beta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar alpha;  ///< works with the rate of alpha [N m]
    Scalar beta;  ///< works with the rate of beta [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::alpha,
          &GeneralizedForces::beta};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar thrust;  ///< motor [N]
    Scalar azimuth;  ///< motor [N m]
    Scalar elevation;  ///< motor [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::thrust, &Inputs::azimuth, &Inputs::elevation};
      return members_[i_];
    }
  };

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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    state.time = n0;
    state.q.x = n0;
    state.q.alpha = n0_3;
    state.q.beta = -n0_4;
    state.v.x = n200;
    state.v.alpha = n1_5;
    state.v.beta = n2;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> aircraft_position;  ///< centre of mass of aircraft [m]
    std::array<Scalar, 9> aircraft_rotation;  ///< from the axes of aircraft to the ground's (3 x 3)
    std::array<Scalar, 3> aircraft_velocity;  ///< velocity of the centre of mass of aircraft [m/s]
    std::array<Scalar, 3> aircraft_angular_velocity;  ///< angular velocity of aircraft [rad/s]
    std::array<Scalar, 3> unit_1_position;  ///< centre of mass of unit_1 [m]
    std::array<Scalar, 9> unit_1_rotation;  ///< from the axes of unit_1 to the ground's (3 x 3)
    std::array<Scalar, 3> unit_1_velocity;  ///< velocity of the centre of mass of unit_1 [m/s]
    std::array<Scalar, 3> unit_1_angular_velocity;  ///< angular velocity of unit_1 [rad/s]
    std::array<Scalar, 3> antenna_position;  ///< centre of mass of antenna [m]
    std::array<Scalar, 9> antenna_rotation;  ///< from the axes of antenna to the ground's (3 x 3)
    std::array<Scalar, 3> antenna_velocity;  ///< velocity of the centre of mass of antenna [m/s]
    std::array<Scalar, 3> antenna_angular_velocity;  ///< angular velocity of antenna [rad/s]
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

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar F_x;  ///< reaction along 'F_x' [N]
    Scalar F_x2;  ///< reaction along 'F_x2' [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::F_x, &Reactions::F_x2};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 9> E;  ///< effect of the inputs (3 x 3)
    std::array<Scalar, 36> A;  ///< state matrix of x = (e, e'): x' = A x + B du (6 x 6)
    std::array<Scalar, 18> B;  ///< input matrix (6 x 3)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n0_4 * v_alpha;
    const Scalar z1 = c_alpha * s_beta;
    const Scalar z2 = s_alpha * s_beta;
    const Scalar z3 = n0_25 * v_beta;
    const Scalar z4 = v_alpha * c_beta;
    const Scalar z5 = c_alpha * c_beta;
    const Scalar z6 = v_x - s_alpha * z0;  // velocity of hinge, x
    const Scalar z7 = c_alpha * z0;  // velocity of hinge, y
    const Scalar z8 = s_alpha * c_beta;
    const Scalar z9 = n0_4 * c_alpha;
    const Scalar z10 = n0_4 * s_alpha;
    const Scalar z11 = s_alpha * v_beta;  // angular velocity of hinge, x
    const Scalar z12 = c_alpha * v_beta;  // angular velocity of hinge, y
    const Scalar z13 = n0_25 * s_beta;
    const Scalar z14 = c_beta * z3;
    const Scalar z15 = q_x + z9;  // place of hinge, x
    const Scalar z16 = n0_25 * z5;
    const Scalar z17 = n0_25 * z8;
    const Scalar z18 = n0_25 * z4;
    const Scalar z19 = z15 + z16;
    const Scalar z20 = z10 + z17;
    const Scalar z21 = z1 * z3 - z6 + s_alpha * z18;
    const Scalar z22 = z7 - z2 * z3 + c_alpha * z18;
    result.aircraft_position[0] = q_x;
    result.aircraft_position[1] = n0;
    result.aircraft_position[2] = n0;
    result.aircraft_rotation[0] = n1;
    result.aircraft_rotation[1] = n0;
    result.aircraft_rotation[2] = n0;
    result.aircraft_rotation[3] = n0;
    result.aircraft_rotation[4] = n1;
    result.aircraft_rotation[5] = n0;
    result.aircraft_rotation[6] = n0;
    result.aircraft_rotation[7] = n0;
    result.aircraft_rotation[8] = n1;
    result.aircraft_velocity[0] = v_x;
    result.aircraft_velocity[1] = n0;
    result.aircraft_velocity[2] = n0;
    result.aircraft_angular_velocity[0] = n0;
    result.aircraft_angular_velocity[1] = n0;
    result.aircraft_angular_velocity[2] = n0;
    result.unit_1_position[0] = q_x;
    result.unit_1_position[1] = n0;
    result.unit_1_position[2] = n0;
    result.unit_1_rotation[0] = c_alpha;
    result.unit_1_rotation[1] = s_alpha;
    result.unit_1_rotation[2] = n0;
    result.unit_1_rotation[3] = -s_alpha;
    result.unit_1_rotation[4] = c_alpha;
    result.unit_1_rotation[5] = n0;
    result.unit_1_rotation[6] = n0;
    result.unit_1_rotation[7] = n0;
    result.unit_1_rotation[8] = n1;
    result.unit_1_velocity[0] = v_x;
    result.unit_1_velocity[1] = n0;
    result.unit_1_velocity[2] = n0;
    result.unit_1_angular_velocity[0] = n0;
    result.unit_1_angular_velocity[1] = n0;
    result.unit_1_angular_velocity[2] = v_alpha;
    result.antenna_position[0] = z19;
    result.antenna_position[1] = z20;
    result.antenna_position[2] = -z13;
    result.antenna_rotation[0] = z5;
    result.antenna_rotation[1] = z8;
    result.antenna_rotation[2] = -s_beta;
    result.antenna_rotation[3] = -s_alpha;
    result.antenna_rotation[4] = c_alpha;
    result.antenna_rotation[5] = n0;
    result.antenna_rotation[6] = z1;
    result.antenna_rotation[7] = z2;
    result.antenna_rotation[8] = c_beta;
    result.antenna_velocity[0] = -z21;
    result.antenna_velocity[1] = z22;
    result.antenna_velocity[2] = -z14;
    result.antenna_angular_velocity[0] = -z11;
    result.antenna_angular_velocity[1] = z12;
    result.antenna_angular_velocity[2] = v_alpha;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 9>& mass) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n4_8 = traits::constant(4.8, 4.8f, "24/5");
    const Scalar n1_92 = traits::constant(1.92, 1.92f, "48/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n9012 = traits::constant(9012.0, 9012.0f, "9012/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1_25 = traits::constant(1.25, 1.25f, "5/4");
    const Scalar q_alpha = state.q.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n3 * c_beta;
    const Scalar z1 = n0_35 * c_beta;
    const Scalar z2 = n3 * s_beta;
    const Scalar z3 = c_alpha * z2;
    const Scalar z4 = c_beta * z1;
    const Scalar z5 = n4_8 + z0;
    const Scalar z6 = n1_92 + n0_8 * z0 + z4;
    const Scalar z7 = s_alpha * z5;
    const Scalar z8 = n1_2 + z6;
    mass[0] = n9012;
    mass[1] = -z7;
    mass[2] = -z3;
    mass[3] = -z7;
    mass[4] = z8;
    mass[5] = n0;
    mass[6] = -z3;
    mass[7] = n0;
    mass[8] = n1_25;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_alpha * v_alpha;
    const Scalar z1 = v_alpha * c_beta;
    const Scalar z2 = v_alpha * s_beta;
    const Scalar z3 = v_beta * v_beta;
    const Scalar z4 = n0_4 * z0;
    const Scalar z5 = c_beta * z4;
    const Scalar z6 = s_beta * z4;
    const Scalar z7 = v_beta * z1;  // angular acceleration of hinge, x
    const Scalar z8 = v_beta * z2;  // angular acceleration of hinge, z
    const Scalar z9 = z1 * z1;
    const Scalar z10 = z2 * z1;
    const Scalar z11 = n3 * z6;  // moment on antenna, y
    const Scalar z12 = z3 + z9;
    const Scalar z13 = n2 * z8;
    const Scalar z14 = n12 * z6 + n3 * z10;  // force on antenna, z
    const Scalar z15 = n2 * z7;
    const Scalar z16 = n0_35 * z10 + z11;  // moment on hinge, y
    const Scalar z17 = n12 * z5 + n3 * z12;  // force on antenna, x
    const Scalar z18 = n3 * z13;  // force on antenna, y
    const Scalar z19 = n0_45 * z15;  // moment on hinge, x
    const Scalar z20 = n0_8 * z13;  // moment on hinge, z
    const Scalar z21 = s_beta * z19 - c_beta * z20;
    const Scalar z22 = s_beta * z14 + c_beta * z17;
    const Scalar z23 = s_alpha * z18 - c_alpha * z22;
    const Scalar z24 = n0_4 * z18 - z21;  // moment on unit_1, z
    forces.x = z23;
    forces.alpha = -z24;
    forces.beta = z16;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n1_25 = traits::constant(1.25, 1.25f, "5/4");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n9000 = traits::constant(9000.0, 9000.0f, "9000/1");
    const Scalar a_x = accelerations.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = a_x * c_alpha;
    const Scalar z1 = v_alpha * v_alpha;
    const Scalar z2 = v_alpha * s_beta;
    const Scalar z3 = v_alpha * c_beta;
    const Scalar z4 = a_alpha * s_beta;
    const Scalar z5 = a_x * s_alpha;
    const Scalar z6 = a_alpha * c_beta;
    const Scalar z7 = v_beta * v_beta;
    const Scalar z8 = z0 - n0_4 * z1;
    const Scalar z9 = n0_4 * a_alpha - z5;
    const Scalar z10 = v_beta * z3 + z4;  // angular acceleration of hinge, x
    const Scalar z11 = v_beta * z2 - z6;  // angular acceleration of hinge, z
    const Scalar z12 = z3 * z3;
    const Scalar z13 = v_beta * z2;
    const Scalar z14 = z2 * z3;
    const Scalar z15 = v_beta * z3;
    const Scalar z16 = z7 + z12;
    const Scalar z17 = a_beta + z14;
    const Scalar z18 = c_beta * z8;
    const Scalar z19 = s_beta * z8;
    const Scalar z20 = z11 + z13;
    const Scalar z21 = n3 * z9;  // moment on antenna, z
    const Scalar z22 = z10 + z15;
    const Scalar z23 = n12 * z18 - n3 * z16;  // force on antenna, x
    const Scalar z24 = n12 * z9 - n3 * z20;  // force on antenna, y
    const Scalar z25 = n12 * z19 - n3 * z17;  // force on antenna, z
    const Scalar z26 = n3 * z19;  // moment on antenna, y
    const Scalar z27 = n0_45 * z22;  // moment on hinge, x
    const Scalar z28 = n0_8 * z20 - z21;  // moment on hinge, z
    const Scalar z29 = n1_25 * a_beta - z26 + n0_35 * z14;  // moment on hinge, y
    const Scalar z30 = s_beta * z27 - c_beta * z28;
    const Scalar z31 = s_beta * z25 + c_beta * z23;
    const Scalar z32 = z30 + n0_75 * a_alpha + n0_4 * z24;  // moment on unit_1, z
    const Scalar z33 = s_alpha * z24 - c_alpha * z31;
    const Scalar z34 = n9000 * a_x - z33;  // force on aircraft, x
    forces.x = z34;
    forces.alpha = z32;
    forces.beta = z29;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n4_8 = traits::constant(4.8, 4.8f, "24/5");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n1_92 = traits::constant(1.92, 1.92f, "48/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n9012 = traits::constant(9012.0, 9012.0f, "9012/1");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar u_thrust = inputs.thrust;
    const Scalar u_azimuth = inputs.azimuth;
    const Scalar u_elevation = inputs.elevation;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n3 * c_beta;
    const Scalar z1 = n0_35 * c_beta;
    const Scalar z2 = v_alpha * v_alpha;
    const Scalar z3 = v_alpha * s_beta;
    const Scalar z4 = v_alpha * c_beta;
    const Scalar z5 = n3 * s_beta;
    const Scalar z6 = n0_4 * z2;
    const Scalar z7 = v_beta * v_beta;
    const Scalar z8 = c_beta * z6;
    const Scalar z9 = s_beta * z6;
    const Scalar z10 = v_beta * z4;  // angular acceleration of hinge, x
    const Scalar z11 = v_beta * z3;  // angular acceleration of hinge, z
    const Scalar z12 = z4 * z4;
    const Scalar z13 = z3 * z4;
    const Scalar z14 = n3 * z9;  // moment on antenna, y
    const Scalar z15 = c_alpha * z5;
    const Scalar z16 = c_beta * z1;
    const Scalar z17 = n4_8 + z0;
    const Scalar z18 = z7 + z12;
    const Scalar z19 = n2 * z11;
    const Scalar z20 = n12 * z9 + n3 * z13;  // force on antenna, z
    const Scalar z21 = n2 * z10;
    const Scalar z22 = n0_35 * z13 + z14;  // moment on hinge, y
    const Scalar z23 = n1_92 + n0_8 * z0 + z16;
    const Scalar z24 = s_alpha * z17;
    const Scalar z25 = n0_8 * z15;
    const Scalar z26 = n12 * z8 + n3 * z18;  // force on antenna, x
    const Scalar z27 = n3 * z19;  // force on antenna, y
    const Scalar z28 = n0_45 * z21;  // moment on hinge, x
    const Scalar z29 = n0_8 * z19;  // moment on hinge, z
    const Scalar z30 = n9012 - z15 * z25;
    const Scalar z31 = u_elevation - z22;
    const Scalar z32 = n1_2 + z23;
    const Scalar z33 = s_beta * z28 - c_beta * z29;
    const Scalar z34 = s_beta * z20 + c_beta * z26;
    const Scalar z35 = n1 / z32;
    const Scalar z36 = s_alpha * z27 - c_alpha * z34;
    const Scalar z37 = n0_4 * z27 - z33;  // moment on unit_1, z
    const Scalar z38 = u_thrust - z36;
    const Scalar z39 = u_azimuth + z37;
    const Scalar z40 = z24 * z35;
    const Scalar z41 = z24 * z40 - z30;
    const Scalar z42 = z31 * z25 + z38 + z39 * z40;
    const Scalar z43 = n1 / z41;
    const Scalar z44 = z43 * z42;
    const Scalar z45 = z39 * z35 - z40 * z44;
    const Scalar z46 = n0_8 * z31 - z25 * z44;
    accelerations.x = -z44;
    accelerations.alpha = z45;
    accelerations.beta = z46;
    if (!(traits::regular(-z41, n9012) && traits::regular(z32, z32))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.alpha * accelerations.beta;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs& inputs, Accelerations& accelerations) noexcept {
    Multipliers multipliers{};
    return Mechanism::forward_dynamics(precomputed, state, inputs, accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n1_25 = traits::constant(1.25, 1.25f, "5/4");
    const Scalar n4500 = traits::constant(4500.0, 4500.0f, "4500/1");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar u_thrust = inputs.thrust;
    const Scalar u_azimuth = inputs.azimuth;
    const Scalar u_elevation = inputs.elevation;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_x * s_alpha;
    const Scalar z1 = v_x * c_alpha;
    const Scalar z2 = v_alpha * c_beta;
    const Scalar z3 = v_alpha * s_beta;
    const Scalar z4 = n0_4 * v_alpha - z0;
    const Scalar z5 = c_beta * z1;
    const Scalar z6 = s_beta * z1;
    const Scalar z7 = n3 * v_beta - n12 * z6;
    const Scalar z8 = n1_25 * v_beta - n3 * z6;
    const Scalar z9 = n3 * z2 + n12 * z4;
    const Scalar z10 = n1_25 * z2 + n3 * z4;
    result.kinetic = n4500 * v_x * v_x + n0_15 * v_alpha * v_alpha + n0_45 * z3 * z3 + n6 * z5 * z5 + n0_5 * (v_beta
        * z8 + z4 * z9 + z2 * z10 - z6 * z7);
    result.force_function = n0;
    result.power = v_x * u_thrust + v_alpha * u_azimuth + v_beta * u_elevation;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar a_x = accelerations.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = a_x * c_alpha;
    const Scalar z1 = v_alpha * v_alpha;
    const Scalar z2 = v_alpha * s_beta;
    const Scalar z3 = v_alpha * c_beta;
    const Scalar z4 = a_x * s_alpha;
    const Scalar z5 = a_alpha * c_beta;
    const Scalar z6 = v_beta * v_beta;
    const Scalar z7 = z0 - n0_4 * z1;
    const Scalar z8 = n0_4 * a_alpha - z4;
    const Scalar z9 = v_beta * z2 - z5;  // angular acceleration of hinge, z
    const Scalar z10 = z3 * z3;
    const Scalar z11 = v_beta * z2;
    const Scalar z12 = z2 * z3;
    const Scalar z13 = z6 + z10;
    const Scalar z14 = a_beta + z12;
    const Scalar z15 = c_beta * z7;
    const Scalar z16 = s_beta * z7;
    const Scalar z17 = z9 + z11;
    const Scalar z18 = n12 * z15 - n3 * z13;  // force on antenna, x
    const Scalar z19 = n12 * z8 - n3 * z17;  // force on antenna, y
    const Scalar z20 = n12 * z16 - n3 * z14;  // force on antenna, z
    const Scalar z21 = s_beta * z20 + c_beta * z18;
    const Scalar z22 = s_alpha * z19 - c_alpha * z21;
    result.F_x = -z22;
    result.F_x2 = z18;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Inputs& inputs, Reactions& result) noexcept {
    Mechanism::reactions(precomputed, state, accelerations, Multipliers(), inputs, result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n4_8 = traits::constant(4.8, 4.8f, "24/5");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    const Scalar n1_92 = traits::constant(1.92, 1.92f, "48/25");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n1_25 = traits::constant(1.25, 1.25f, "5/4");
    const Scalar n9000 = traits::constant(9000.0, 9000.0f, "9000/1");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9012 = traits::constant(9012.0, 9012.0f, "9012/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_x = accelerations.x;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar u_thrust = inputs.thrust;
    const Scalar u_azimuth = inputs.azimuth;
    const Scalar u_elevation = inputs.elevation;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n3 * c_beta;
    const Scalar z1 = n0_35 * c_beta;
    const Scalar z2 = a_x * c_alpha;
    const Scalar z3 = v_alpha * v_alpha;
    const Scalar z4 = v_alpha * s_beta;
    const Scalar z5 = v_alpha * c_beta;
    const Scalar z6 = a_alpha * s_beta;
    const Scalar z7 = n2 * v_alpha;
    const Scalar z8 = a_x * s_alpha;
    const Scalar z9 = a_alpha * c_beta;
    const Scalar z10 = v_beta * v_beta;
    const Scalar z11 = n0_4 * z7;
    const Scalar z12 = n3 * s_beta;
    const Scalar z13 = v_beta * s_beta;
    const Scalar z14 = c_beta * z11;
    const Scalar z15 = s_beta * z11;
    const Scalar z16 = v_beta * c_beta;
    const Scalar z17 = z2 - n0_4 * z3;
    const Scalar z18 = n0_4 * a_alpha - z8;
    const Scalar z19 = v_beta * z5 + z6;  // angular acceleration of hinge, x
    const Scalar z20 = v_beta * z4 - z9;  // angular acceleration of hinge, z
    const Scalar z21 = z5 * z5;
    const Scalar z22 = v_beta * z4;
    const Scalar z23 = z4 * z5;
    const Scalar z24 = v_beta * z5;
    const Scalar z25 = c_alpha * z12;
    const Scalar z26 = c_beta * z1;
    const Scalar z27 = n4_8 + z0;
    const Scalar z28 = n2 * z13;
    const Scalar z29 = s_beta * z5 + c_beta * z4;
    const Scalar z30 = n2 * c_beta * z5;
    const Scalar z31 = n12 * z2;
    const Scalar z32 = s_beta * z8;
    const Scalar z33 = c_beta * z8;
    const Scalar z34 = n2 * z16;
    const Scalar z35 = z10 + z21;
    const Scalar z36 = a_beta + z23;
    const Scalar z37 = n1_92 + n0_8 * z0 + z26;
    const Scalar z38 = s_alpha * z27;
    const Scalar z39 = n3 * z28;
    const Scalar z40 = n12 * z14 + n3 * z30;
    const Scalar z41 = n12 * z32;
    const Scalar z42 = n12 * z33;
    const Scalar z43 = n0_45 * z34;
    const Scalar z44 = c_beta * z17;
    const Scalar z45 = n0_8 * z28;
    const Scalar z46 = s_beta * z17;
    const Scalar z47 = n3 * z2;
    const Scalar z48 = n3 * z15;
    const Scalar z49 = c_beta * z47;
    const Scalar z50 = z20 + z22;
    const Scalar z51 = n3 * z32;
    const Scalar z52 = n2 * z4;
    const Scalar z53 = n3 * z52;
    const Scalar z54 = n3 * z18;  // moment on antenna, z
    const Scalar z55 = z19 + z24;
    const Scalar z56 = s_beta * z41 + c_beta * z42;
    const Scalar z57 = s_beta * z43 - c_beta * z45;
    const Scalar z58 = n0_4 * z31 + z49;
    const Scalar z59 = n12 * z44;
    const Scalar z60 = n2 * v_beta;
    const Scalar z61 = n12 * z18 - n3 * z50;  // force on antenna, y
    const Scalar z62 = n12 * z46;
    const Scalar z63 = n3 * z46;  // moment on antenna, y
    const Scalar z64 = n0_45 * z55;  // moment on hinge, x
    const Scalar z65 = n0_8 * z50 - z54;  // moment on hinge, z
    const Scalar z66 = n1_2 + z37;
    const Scalar z67 = n12 * z15 + n3 * z29;
    const Scalar z68 = n0_35 * z29 + z48;
    const Scalar z69 = n3 * z35 - z59;  // force on antenna, x
    const Scalar z70 = n3 * z60;
    const Scalar z71 = c_beta * z70;
    const Scalar z72 = n3 * z36 - z62;  // force on antenna, z
    const Scalar z73 = n1_25 * a_beta - z63 + n0_35 * z23;  // moment on hinge, y
    const Scalar z74 = c_beta * z40 + s_beta * z67;
    const Scalar z75 = z4 * z4 - z21;
    const Scalar z76 = n2 * z5;
    const Scalar z77 = z4 * z76;
    const Scalar z78 = z59 + n3 * z75;
    const Scalar z79 = s_alpha * z39 - c_alpha * z74;
    const Scalar z80 = z62 - n3 * z77;
    const Scalar z81 = n0_4 * z39 - z57;
    const Scalar z82 = s_alpha * z53 - c_alpha * z71;
    const Scalar z83 = s_beta * z72 + c_beta * z69;
    const Scalar z84 = s_beta * (z69 + z78) - c_beta * (z72 + z80);
    const Scalar z85 = s_alpha * (z83 + z31) - c_alpha * (z61 + z56);
    const Scalar z86 = n0_45 * z76;
    const Scalar z87 = s_alpha * z61 + c_alpha * z83;
    const Scalar z88 = n9000 * a_x - z87;  // force on aircraft, x
    const Scalar z89 = n3 * z55;
    const Scalar z90 = s_alpha * z89 + c_alpha * z84;
    const Scalar z91 = s_beta * z64 - c_beta * z65;
    const Scalar z92 = z91 + n0_75 * a_alpha + n0_4 * z61;  // moment on unit_1, z
    const Scalar z93 = n0_8 * z55;
    const Scalar z94 = n1 / z66;
    const Scalar z95 = n0_45 * z50;
    const Scalar z96 = c_beta * (z64 - z93) + s_beta * (z65 - z95);
    const Scalar z97 = n0_8 * z25;
    const Scalar z98 = n9012 - z25 * z97;
    const Scalar z99 = z38 * z94;
    const Scalar z100 = n0_8 * z52;
    const Scalar z101 = s_beta * z86 - c_beta * z100;
    const Scalar z102 = n3 * z44;
    const Scalar z103 = z38 * z99 - z98;
    const Scalar z104 = n0_35 * z75 + z102;
    const Scalar z105 = n0_4 * z89 - z96;
    const Scalar z106 = n0_4 * z53 - z101;
    const Scalar z107 = n1 / z103;
    const Scalar z108 = z51 * z97 + z85 - z58 * z99;
    const Scalar z109 = z68 * z97 + z79 - z81 * z99;
    const Scalar z110 = z90 - z105 * z99 - z104 * z97;
    const Scalar z111 = z82 - z106 * z99;
    const Scalar z112 = z107 * z108;
    const Scalar z113 = z107 * z109;
    const Scalar z114 = z107 * z110;
    const Scalar z115 = z107 * z111;
    const Scalar z116 = z99 * z107;
    const Scalar z117 = z97 * z107;
    const Scalar z118 = z58 * z94 + z99 * z112;
    const Scalar z119 = n0_8 * z51 - z97 * z112;
    const Scalar z120 = z81 * z94 + z99 * z113;
    const Scalar z121 = n0_8 * z68 - z97 * z113;
    const Scalar z122 = z105 * z94 + z99 * z114;
    const Scalar z123 = n0_8 * z104 + z97 * z114;
    const Scalar z124 = z106 * z94 + z99 * z115;
    const Scalar z125 = z97 * z115;
    const Scalar z126 = z94 - z99 * z116;
    const Scalar z127 = z97 * z116;
    const Scalar z128 = z99 * z117;
    const Scalar z129 = n0_8 - z97 * z117;
    result.M[0] = n9012;
    result.M[1] = -z38;
    result.M[2] = -z25;
    result.M[3] = -z38;
    result.M[4] = z66;
    result.M[5] = n0;
    result.M[6] = -z25;
    result.M[7] = n0;
    result.M[8] = n1_25;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = z79;
    result.C[4] = -z81;
    result.C[5] = z68;
    result.C[6] = z82;
    result.C[7] = -z106;
    result.C[8] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = z85;
    result.K[4] = -z58;
    result.K[5] = z51;
    result.K[6] = z90;
    result.K[7] = -z105;
    result.K[8] = -z104;
    result.F[0] = u_thrust - z88;
    result.F[1] = u_azimuth - z92;
    result.F[2] = u_elevation - z73;
    result.E[0] = n1;
    result.E[1] = n0;
    result.E[2] = n0;
    result.E[3] = n0;
    result.E[4] = n1;
    result.E[5] = n0;
    result.E[6] = n0;
    result.E[7] = n0;
    result.E[8] = n1;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = z112;
    result.A[10] = z118;
    result.A[11] = -z119;
    result.A[12] = n0;
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = z114;
    result.A[16] = z122;
    result.A[17] = z123;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = n0;
    result.A[22] = n0;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = z113;
    result.A[28] = z120;
    result.A[29] = -z121;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = z115;
    result.A[34] = z124;
    result.A[35] = z125;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = -z107;
    result.B[4] = -z116;
    result.B[5] = -z117;
    result.B[6] = n0;
    result.B[7] = n0;
    result.B[8] = n0;
    result.B[9] = -z116;
    result.B[10] = z126;
    result.B[11] = -z127;
    result.B[12] = n0;
    result.B[13] = n0;
    result.B[14] = n0;
    result.B[15] = -z117;
    result.B[16] = -z128;
    result.B[17] = z129;
    if (!(traits::regular(-z103, n9012) && traits::regular(z66, z66))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.M[1] * result.M[2] * result.M[3] * result.M[4] * result.M[6] * result.C[3]
        * result.C[4] * result.C[5] * result.C[6] * result.C[7]) * (n0 * result.K[3] * result.K[4] * result.K[5]
        * result.K[6] * result.K[7] * result.K[8] * result.F[0] * result.F[1] * result.F[2] * result.A[9])) * ((n0
        * result.A[10] * result.A[11] * result.A[15] * result.A[16] * result.A[17] * result.A[27] * result.A[28]
        * result.A[29] * result.A[33] * result.A[34]) * (n0 * result.A[35] * result.B[3] * result.B[4] * result.B[5]
        * result.B[9] * result.B[10] * result.B[11] * result.B[15] * result.B[16] * result.B[17]));
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Inputs& inputs, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, Multipliers(), inputs, result);
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
    visitor(Description::kernels[6],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, Reactions&>(reactions));
    visitor(Description::kernels[7],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace nose_radar
