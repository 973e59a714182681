// SPDX-License-Identifier: MIT-0
// heavy_top: Fast symmetric top about a fixed point
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation, jets
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               20               45          0             0                  3       0     71      71
//   mass_matrix               1                3          0             0                  1       0      6       6
//   bias                      7               21          0             0                  2       0     32      32
//   inverse_dynamics         12               23          0             0                  2       0     39      40
//   forward_dynamics          8               28          1             0                  2       0     41      41
//   energy                    6               16          0             0                  3       0     28      29
//   first_integrals           8               19          0             0                  3       0     33      34
//   linearisation            34               88          1             0                  2       0    127     132
//   jets                     33               51          2             0                  2       0     90       -
//
// Not computed because this mechanism does not need it:
//   kinematics: of 18 results 3 repeat another up to sign
//   mass_matrix: of 9 results 4 vanish identically, 1 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 66 results 29 vanish identically, 2 repeat another up to sign
//
// To write this file again:
//   heavy_top_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,jets --support torsor_support.hpp --output heavy_top.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace heavy_top {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"alpha", "rad"}, {"beta", "rad"}, {"gamma",
      "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"alpha", "rad/s"}, {"beta", "rad/s"},
      {"gamma", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 20> results{{{"result", "top_position", 3, 1, 1, "m"},
      {"result", "top_rotation", 3, 3, 2, "1"}, {"result", "top_velocity", 3, 1, 1, "m/s"}, {"result",
      "top_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 3, 3, 2, "kg m^2"}, {"forces", "", 3, 1, 1, "N m"},
      {"forces", "", 3, 1, 1, "N m"}, {"accelerations", "", 3, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1, ""},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result", "momentum_gamma", 1, 1, 0, "N m s"}, {"result", "M", 3, 3, 2,
      "kg m^2"}, {"result", "C", 3, 3, 2, "N m s"}, {"result", "K", 3, 3, 2, "N m"}, {"result", "F", 3, 1, 1, "N m"},
      {"result", "A", 6, 6, 2, ""}, {"coefficients", "", 6, 0, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 4}, {"mass_matrix", false, false, false, false, results.data() + 4, 1}, {"bias", false, false,
      false, false, results.data() + 5, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 6, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 7, 2}, {"energy", false, false, true, false,
      results.data() + 9, 3}, {"first_integrals", false, false, false, false, results.data() + 12, 2}, {"linearisation",
      true, true, true, true, results.data() + 14, 5}, {"jets", false, false, true, true, results.data() + 19, 1}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::heavy_top::Description;

  static constexpr const char* name = "heavy_top";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x19fa894d7c04f2e2ULL ^ torsor::support_fingerprint;
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
    Scalar alpha;  ///< coordinate [rad]
    Scalar beta;  ///< coordinate [rad]
    Scalar gamma;  ///< coordinate [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::alpha, &Coordinates::beta, &Coordinates::gamma};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar alpha;  ///< its rate [rad/s]
    Scalar beta;  ///< its rate [rad/s]
    Scalar gamma;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::alpha, &Velocities::beta, &Velocities::gamma};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar alpha;  ///< its second rate [rad/s^2]
    Scalar beta;  ///< its second rate [rad/s^2]
    Scalar gamma;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::alpha, &Accelerations::beta,
          &Accelerations::gamma};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar alpha;  ///< works with the rate of alpha [N m]
    Scalar beta;  ///< works with the rate of beta [N m]
    Scalar gamma;  ///< works with the rate of gamma [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::alpha, &GeneralizedForces::beta,
          &GeneralizedForces::gamma};
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
    const Scalar n1_over_6 = traits::constant(0.16666666666666666, 0.16666667f, "1/6");
    const Scalar k2 = traits::constant(2.30769, 2.30769f, "230769/100000");
    const Scalar k3 = traits::constant(3.9970363281186225, 3.9970362f, "0;0;230769/100000;0");
    const Scalar n150 = traits::constant(150.0, 150.0f, "150/1");
    const Scalar pi = traits::pi();
    state.time = n0;
    state.q.alpha = n0;
    state.q.beta = n0;
    state.q.gamma = -n1_over_6 * pi;
    state.v.alpha = k2;
    state.v.beta = -k3;
    state.v.gamma = n150;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> top_position;  ///< centre of mass of top [m]
    std::array<Scalar, 9> top_rotation;  ///< from the axes of top to the ground's (3 x 3)
    std::array<Scalar, 3> top_velocity;  ///< velocity of the centre of mass of top [m/s]
    std::array<Scalar, 3> top_angular_velocity;  ///< angular velocity of top [rad/s]
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
    Scalar momentum_gamma;  ///< dT/dgamma' of the cyclic coordinate 'gamma' [N m s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy, &FirstIntegrals::momentum_gamma};
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
    const Scalar k0 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar angles_[] = {q_alpha, q_beta, q_gamma};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar z0 = k0 * s_alpha;
    const Scalar z1 = n0_5 * s_alpha;
    const Scalar z2 = n0_5 * c_alpha;
    const Scalar z3 = k0 * c_alpha;
    const Scalar z4 = c_alpha * s_beta;
    const Scalar z5 = v_alpha * c_beta;
    const Scalar z6 = k0 * v_alpha;  // angular velocity of first, x
    const Scalar z7 = n0_5 * v_alpha;  // angular velocity of first, z
    const Scalar z8 = c_alpha * c_beta;
    const Scalar z9 = s_alpha * v_beta;  // angular velocity of second, y
    const Scalar z10 = k0 * c_beta + s_beta * z1;
    const Scalar z11 = k0 * s_beta - c_beta * z1;
    const Scalar z12 = s_beta * z0 - n0_5 * c_beta;
    const Scalar z13 = n0_5 * s_beta + c_beta * z0;
    const Scalar z14 = v_beta * z2 + z6;  // angular velocity of second, x
    const Scalar z15 = v_beta * z3 - z7;  // angular velocity of second, z
    const Scalar z16 = s_alpha * s_gamma + c_gamma * z4;
    const Scalar z17 = s_alpha * c_gamma - s_gamma * z4;
    const Scalar z18 = v_beta * s_gamma - c_gamma * z5;
    const Scalar z19 = v_beta * c_gamma + s_gamma * z5;
    const Scalar z20 = v_gamma * z8 - z9;  // angular velocity of top, y
    const Scalar z21 = s_gamma * z2 - c_gamma * z10;
    const Scalar z22 = c_gamma * z2 + s_gamma * z10;
    const Scalar z23 = v_gamma * z11 - z14;  // angular velocity of top, x
    const Scalar z24 = v_gamma * z13 + z15;  // angular velocity of top, z
    const Scalar z25 = z16 * z19 - z17 * z18;
    const Scalar z26 = s_gamma * z3 - c_gamma * z12;
    const Scalar z27 = c_gamma * z3 + s_gamma * z12;
    const Scalar z28 = z21 * z19 - z22 * z18;
    const Scalar z29 = z26 * z19 - z27 * z18;
    result.top_position[0] = -z11;
    result.top_position[1] = z8;
    result.top_position[2] = z13;
    result.top_rotation[0] = -z21;
    result.top_rotation[1] = z16;
    result.top_rotation[2] = -z26;
    result.top_rotation[3] = -z11;
    result.top_rotation[4] = z8;
    result.top_rotation[5] = z13;
    result.top_rotation[6] = z22;
    result.top_rotation[7] = -z17;
    result.top_rotation[8] = z27;
    result.top_velocity[0] = z28;
    result.top_velocity[1] = -z25;
    result.top_velocity[2] = z29;
    result.top_angular_velocity[0] = -z23;
    result.top_angular_velocity[1] = z20;
    result.top_angular_velocity[2] = z24;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 9>& mass) noexcept {
    const Scalar n945_over_64 = traits::constant(14.765625, 14.765625f, "945/64");
    const Scalar n15_over_32 = traits::constant(0.46875, 0.46875f, "15/32");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n975_over_64 = traits::constant(15.234375, 15.234375f, "975/64");
    const Scalar q_beta = state.q.beta;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = n945_over_64 * c_beta;
    const Scalar z1 = n15_over_32 * s_beta;
    const Scalar z2 = n15_over_32 + c_beta * z0;
    mass[0] = z2;
    mass[1] = n0;
    mass[2] = -z1;
    mass[3] = n0;
    mass[4] = n975_over_64;
    mass[5] = n0;
    mass[6] = -z1;
    mass[7] = n0;
    mass[8] = n15_over_32;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(8.495709211125343, 8.495709f, "0;0;981/200;0");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar n15_over_32 = traits::constant(0.46875, 0.46875f, "15/32");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    const Scalar n975_over_64 = traits::constant(15.234375, 15.234375f, "975/64");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar v_gamma = state.v.gamma;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_alpha * s_beta;
    const Scalar z1 = k0 * s_alpha;
    const Scalar z2 = v_alpha * c_beta;
    const Scalar z3 = k0 * c_alpha;
    const Scalar z4 = s_beta * z1 - n4_905 * c_beta;
    const Scalar z5 = v_beta * z0;  // angular acceleration of second, x
    const Scalar z6 = v_beta * z2;  // angular acceleration of second, y
    const Scalar z7 = v_gamma - z0;  // angular velocity of top, y
    const Scalar z8 = z2 * z0;
    const Scalar z9 = v_beta * z7;
    const Scalar z10 = z2 * z7;
    const Scalar z11 = n15_over_32 * z6;  // moment on top, y
    const Scalar z12 = n2 * z5;
    const Scalar z13 = n15_over_32 * z9;  // moment on top, x
    const Scalar z14 = n15_over_32 * z10;  // moment on top, z
    const Scalar z15 = n15 * z3 - z13 - n975_over_64 * z12;  // moment on second, x
    const Scalar z16 = n15 * z4 - z14 - n975_over_64 * z8;  // moment on second, z
    const Scalar z17 = s_beta * z11 + c_beta * z15;
    forces.alpha = z17;
    forces.beta = -z16;
    forces.gamma = -z11;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(8.495709211125343, 8.495709f, "0;0;981/200;0");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar n15_over_32 = traits::constant(0.46875, 0.46875f, "15/32");
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    const Scalar n975_over_64 = traits::constant(15.234375, 15.234375f, "975/64");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_alpha * s_beta;
    const Scalar z1 = v_alpha * c_beta;
    const Scalar z2 = a_alpha * s_beta;
    const Scalar z3 = a_alpha * c_beta;
    const Scalar z4 = k0 * c_alpha;
    const Scalar z5 = k0 * s_alpha;
    const Scalar z6 = s_beta * z5 - n4_905 * c_beta;
    const Scalar z7 = v_beta * z0 - z3;  // angular acceleration of second, x
    const Scalar z8 = v_beta * z1 + z2;  // angular acceleration of second, y
    const Scalar z9 = v_gamma - z0;  // angular velocity of top, y
    const Scalar z10 = z1 * z0;
    const Scalar z11 = v_beta * z0;
    const Scalar z12 = v_beta * z9;
    const Scalar z13 = z1 * z9;
    const Scalar z14 = a_gamma - z8;  // angular acceleration of top, y
    const Scalar z15 = z7 + z11;
    const Scalar z16 = n15_over_32 * z12;  // moment on top, x
    const Scalar z17 = n15_over_32 * z13;  // moment on top, z
    const Scalar z18 = n15_over_32 * z14;  // moment on top, y
    const Scalar z19 = n15 * z4 - z16 - n975_over_64 * z15;  // moment on second, x
    const Scalar z20 = z17 + n975_over_64 * (a_beta + z10) - n15 * z6;  // moment on second, z
    const Scalar z21 = s_beta * z18 - c_beta * z19;
    forces.alpha = -z21;
    forces.beta = z20;
    forces.gamma = z18;
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
    const Scalar n975_over_64 = traits::constant(15.234375, 15.234375f, "975/64");
    const Scalar k1 = traits::constant(8.495709211125343, 8.495709f, "0;0;981/200;0");
    const Scalar n15_over_32 = traits::constant(0.46875, 0.46875f, "15/32");
    const Scalar n945_over_64 = traits::constant(14.765625, 14.765625f, "945/64");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    const Scalar n64_over_975 = traits::constant(0.06564102564102564, 0.06564102f, "64/975");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar v_gamma = state.v.gamma;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_alpha * s_beta;
    const Scalar z1 = n975_over_64 * c_beta * c_beta;
    const Scalar z2 = k1 * c_alpha;
    const Scalar z3 = k1 * s_alpha;
    const Scalar z4 = v_alpha * c_beta;
    const Scalar z5 = n15_over_32 * s_beta;
    const Scalar z6 = n945_over_64 * c_beta;
    const Scalar z7 = s_beta * z3 - n4_905 * c_beta;
    const Scalar z8 = v_beta * z0;  // angular acceleration of second, x
    const Scalar z9 = v_beta * z4;  // angular acceleration of second, y
    const Scalar z10 = v_gamma - z0;  // angular velocity of top, y
    const Scalar z11 = z4 * z0;
    const Scalar z12 = n15_over_32 + c_beta * z6;
    const Scalar z13 = n32_over_15 * z5;
    const Scalar z14 = n2 * z8;
    const Scalar z15 = v_beta * z10;
    const Scalar z16 = z4 * z10;
    const Scalar z17 = n1 / z1;
    const Scalar z18 = n15_over_32 * z15;  // moment on top, x
    const Scalar z19 = n15_over_32 * z16;  // moment on top, z
    const Scalar z20 = n15 * z2 - z18 - n975_over_64 * z14;  // moment on second, x
    const Scalar z21 = n15 * z7 - z19 - n975_over_64 * z11;  // moment on second, z
    const Scalar z22 = c_beta * z20;
    const Scalar z23 = n64_over_975 * z21;
    const Scalar z24 = z17 * z22;
    const Scalar z25 = z13 * z24;
    const Scalar z26 = z9 - z25;
    accelerations.alpha = -z24;
    accelerations.beta = z23;
    accelerations.gamma = z26;
    if (!(traits::regular(z1, z12))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.alpha * accelerations.beta * accelerations.gamma;
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
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    const Scalar n15_over_64 = traits::constant(0.234375, 0.234375f, "15/64");
    const Scalar n975_over_128 = traits::constant(7.6171875, 7.6171875f, "975/128");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar k4 = traits::constant(8.495709211125343, 8.495709f, "0;0;981/200;0");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar angles_[] = {q_alpha, q_beta, q_gamma};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar z0 = v_alpha * c_beta;
    const Scalar z1 = v_alpha * s_beta;
    const Scalar z2 = n15 * c_beta;
    const Scalar z3 = n15 * s_beta;
    const Scalar z4 = v_beta * s_gamma - c_gamma * z0;
    const Scalar z5 = v_beta * c_gamma + s_gamma * z0;
    const Scalar z6 = v_gamma - z1;  // angular velocity of top, y
    const Scalar z7 = s_alpha * z2;
    result.kinetic = n15_over_64 * z6 * z6 + n975_over_128 * (z4 * z4 + z5 * z5);
    result.force_function = -n4_905 * z3 - k4 * z7;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    const Scalar n15_over_32 = traits::constant(0.46875, 0.46875f, "15/32");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar k3 = traits::constant(8.495709211125343, 8.495709f, "0;0;981/200;0");
    const Scalar n15_over_64 = traits::constant(0.234375, 0.234375f, "15/64");
    const Scalar n975_over_128 = traits::constant(7.6171875, 7.6171875f, "975/128");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar angles_[] = {q_alpha, q_beta, q_gamma};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar z0 = v_alpha * c_beta;
    const Scalar z1 = v_alpha * s_beta;
    const Scalar z2 = n15 * c_beta;
    const Scalar z3 = n15 * s_beta;
    const Scalar z4 = n15_over_32 * s_beta;
    const Scalar z5 = v_beta * s_gamma - c_gamma * z0;
    const Scalar z6 = v_beta * c_gamma + s_gamma * z0;
    const Scalar z7 = v_gamma - z1;  // angular velocity of top, y
    const Scalar z8 = s_alpha * z2;
    result.energy = n4_905 * z3 + k3 * z8 + n15_over_64 * z7 * z7 + n975_over_128 * (z5 * z5 + z6 * z6);
    result.momentum_gamma = -v_alpha * z4 + n15_over_32 * v_gamma;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar k0 = traits::constant(8.495709211125343, 8.495709f, "0;0;981/200;0");
    const Scalar n975_over_64 = traits::constant(15.234375, 15.234375f, "975/64");
    const Scalar n15_over_32 = traits::constant(0.46875, 0.46875f, "15/32");
    const Scalar n945_over_64 = traits::constant(14.765625, 14.765625f, "945/64");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n64_over_975 = traits::constant(0.06564102564102564, 0.06564102f, "64/975");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_alpha * s_beta;
    const Scalar z1 = v_alpha * c_beta;
    const Scalar z2 = a_alpha * s_beta;
    const Scalar z3 = a_alpha * c_beta;
    const Scalar z4 = k0 * c_alpha;
    const Scalar z5 = v_beta * s_beta;
    const Scalar z6 = k0 * s_alpha;
    const Scalar z7 = n975_over_64 * c_beta * c_beta;
    const Scalar z8 = n15_over_32 * s_beta;
    const Scalar z9 = v_beta * c_beta;
    const Scalar z10 = n15_over_32 * v_beta;
    const Scalar z11 = c_beta * z10;
    const Scalar z12 = n945_over_64 * c_beta;
    const Scalar z13 = s_beta * z6 - n4_905 * c_beta;
    const Scalar z14 = n4_905 * s_beta + c_beta * z6;
    const Scalar z15 = v_beta * z0 - z3;  // angular acceleration of second, x
    const Scalar z16 = v_beta * z1 + z2;  // angular acceleration of second, y
    const Scalar z17 = v_gamma - z0;  // angular velocity of top, y
    const Scalar z18 = z1 * z0;
    const Scalar z19 = v_beta * z0;
    const Scalar z20 = n15_over_32 + c_beta * z12;
    const Scalar z21 = v_beta * z1;  // angular acceleration of second, y
    const Scalar z22 = n15_over_32 * z9;
    const Scalar z23 = n15_over_32 * z5;
    const Scalar z24 = n2 * z5;
    const Scalar z25 = n15 * z6;
    const Scalar z26 = s_beta * z1;
    const Scalar z27 = s_beta * z4;
    const Scalar z28 = n15_over_32 * z1;
    const Scalar z29 = n2 * z0;
    const Scalar z30 = z1 * z1;
    const Scalar z31 = n32_over_15 * z8;
    const Scalar z32 = v_beta * z17;
    const Scalar z33 = z1 * z17;
    const Scalar z34 = n15_over_32 * z21;  // moment on top, y
    const Scalar z35 = z23 - n975_over_64 * z24;
    const Scalar z36 = c_beta * z25;
    const Scalar z37 = c_beta * z17 - z26;
    const Scalar z38 = c_beta * z0 + z26;
    const Scalar z39 = n15 * z27;
    const Scalar z40 = n15_over_32 * z17;
    const Scalar z41 = z0 * z17 + z30;
    const Scalar z42 = z0 * z0 - z30;
    const Scalar z43 = n1 / z7;
    const Scalar z44 = a_gamma - z16;  // angular acceleration of top, y
    const Scalar z45 = z15 + z19;
    const Scalar z46 = n15_over_32 * z15;
    const Scalar z47 = z16 + z21;
    const Scalar z48 = n15_over_32 * z32;  // moment on top, x
    const Scalar z49 = n15_over_32 * z33;  // moment on top, z
    const Scalar z50 = z40 + n975_over_64 * z29;
    const Scalar z51 = n64_over_975 * z39;
    const Scalar z52 = n15_over_32 * z44;  // moment on top, y
    const Scalar z53 = n64_over_975 * z28;
    const Scalar z54 = s_beta * z22 + c_beta * z35;
    const Scalar z55 = n15_over_32 * z37;
    const Scalar z56 = z34 - n975_over_64 * z47;
    const Scalar z57 = n15_over_32 * z41;
    const Scalar z58 = c_beta * z35;
    const Scalar z59 = n15 * z4 - z48 - n975_over_64 * z45;  // moment on second, x
    const Scalar z60 = z49 + n975_over_64 * (a_beta + z18) - n15 * z13;  // moment on second, z
    const Scalar z61 = z55 + n975_over_64 * z38;
    const Scalar z62 = s_beta * z28 - c_beta * z50;
    const Scalar z63 = n15 * z14 + z57 + n975_over_64 * z42;
    const Scalar z64 = c_beta * z50;
    const Scalar z65 = n64_over_975 * z61;
    const Scalar z66 = z36 * z43;
    const Scalar z67 = z43 * z58;
    const Scalar z68 = z43 * z64;
    const Scalar z69 = z11 * z43;
    const Scalar z70 = s_beta * z52 - c_beta * z59;
    const Scalar z71 = c_beta * (z52 - z56) + s_beta * (z59 + z46);
    const Scalar z72 = n64_over_975 * z63;
    const Scalar z73 = z31 * z66;
    const Scalar z74 = n32_over_15 * z22 - z31 * z67;
    const Scalar z75 = n32_over_15 * z28 + z31 * z68;
    const Scalar z76 = z31 * z69;
    const Scalar z77 = z46 * z31 - z71;
    const Scalar z78 = z43 * z77;
    const Scalar z79 = n32_over_15 * z46 + z31 * z78;
    result.M[0] = z20;
    result.M[1] = n0;
    result.M[2] = -z8;
    result.M[3] = n0;
    result.M[4] = n975_over_64;
    result.M[5] = n0;
    result.M[6] = -z8;
    result.M[7] = n0;
    result.M[8] = n15_over_32;
    result.C[0] = z54;
    result.C[1] = z61;
    result.C[2] = -z22;
    result.C[3] = z62;
    result.C[4] = n0;
    result.C[5] = -z28;
    result.C[6] = -z11;
    result.C[7] = z28;
    result.C[8] = n0;
    result.K[0] = -z36;
    result.K[1] = -z39;
    result.K[2] = n0;
    result.K[3] = -z71;
    result.K[4] = -z63;
    result.K[5] = z46;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.F[0] = z70;
    result.F[1] = -z60;
    result.F[2] = -z52;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = z66;
    result.A[4] = z51;
    result.A[5] = z73;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = -z78;
    result.A[10] = z72;
    result.A[11] = -z79;
    result.A[12] = n0;
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = n0;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = -z67;
    result.A[22] = -z65;
    result.A[23] = z74;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = z68;
    result.A[28] = n0;
    result.A[29] = z75;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = z69;
    result.A[34] = -z53;
    result.A[35] = z76;
    if (!(traits::regular(z7, z20))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[0] * result.M[2] * result.M[6] * result.C[0] * result.C[1] * result.C[2]
        * result.C[3] * result.C[5] * result.C[6] * result.C[7] * result.K[0] * result.K[1] * result.K[3] * result.K[4]
        * result.K[5] * result.F[0]) * (n0 * result.F[1] * result.F[2] * result.A[3] * result.A[4] * result.A[5]
        * result.A[9] * result.A[10] * result.A[11] * result.A[21] * result.A[22] * result.A[23] * result.A[27]
        * result.A[29] * result.A[33] * result.A[34] * result.A[35]);
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, Multipliers(), Inputs(), result);
  }

  /// Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions
  /// then velocities, the inputs being constant. 12 operations take a convolution at each order.
  /// Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed&, const State& state, const Inputs&, int order,
      std::array<Scalar, 6>* coefficients) noexcept {
    const Scalar n945_over_64 = traits::constant(14.765625, 14.765625f, "945/64");
    const Scalar n975_over_64 = traits::constant(15.234375, 15.234375f, "975/64");
    const Scalar n15_over_32 = traits::constant(0.46875, 0.46875f, "15/32");
    const Scalar n2_over_65 = traits::constant(0.03076923076923077, 0.03076923f, "2/65");
    const Scalar n128_over_65 = traits::constant(1.9692307692307693, 1.9692308f, "128/65");
    const Scalar k5 = traits::constant(8.365005992492646, 8.365006f, "0;0;7848/1625;0");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n63_over_65 = traits::constant(0.9692307692307692, 0.9692308f, "63/65");
    const Scalar k8 = traits::constant(4.829538461538461, 4.8295383f, "7848/1625");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n945_over_64 * c_beta;
    const Scalar z1 = n975_over_64 * c_beta * c_beta;
    const Scalar z2 = n15_over_32 + c_beta * z0;
    const Scalar b1 = state.v.alpha;
    const Scalar b8 = state.v.gamma;
    const Scalar b10 = b1 * s_beta;
    const Scalar b11 = n2_over_65 * b8 + n128_over_65 * b10;
    const Scalar b5 = state.v.beta;
    const Scalar b12 = b5 * b11;
    const Scalar b13 = k5 * c_alpha - b12;
    const Scalar b14 = b13 / c_beta;
    const Scalar i14 = n1 / c_beta;
    const Scalar b15 = n2_over_65 * b8 + n63_over_65 * b10;
    const Scalar b9 = b1 * c_beta;
    const Scalar b17 = s_alpha * s_beta;
    const Scalar b16 = b9 * b15;
    const Scalar b18 = b5 * b9;
    const Scalar b19 = s_beta * b14;
    coefficients[0][0] = state.q.alpha;
    coefficients[0][1] = state.q.beta;
    coefficients[0][2] = state.q.gamma;
    coefficients[0][3] = state.v.alpha;
    coefficients[0][4] = state.v.beta;
    coefficients[0][5] = state.v.gamma;
    coefficients[1][0] = b1;
    coefficients[1][1] = b5;
    coefficients[1][2] = b8;
    coefficients[1][3] = -b14;
    coefficients[1][4] = -k8 * c_beta + k5 * b17 - b16;
    coefficients[1][5] = b18 - b19;
    torsor::Convolutions<Scalar, 12> operations_;
    typename torsor::Convolutions<Scalar, 12>::Sums sums_;
    Scalar number_ = n1, inverse_ = n1;
    for (int k_ = 1; k_ < order; ++k_) {
      const Scalar following_ = number_ + n1, next_ = n1 / following_;
      operations_.sum(k_, sums_);
      const Scalar x0 = coefficients[k_][0];
      const Scalar x1 = coefficients[k_][3];
      const Scalar x2 = inverse_ * sums_[0] + c_alpha * x0;
      const Scalar w0 = number_ * x0;
      const Scalar x3 = -inverse_ * sums_[1] - s_alpha * x0;
      const Scalar x4 = coefficients[k_][1];
      const Scalar x5 = coefficients[k_][4];
      const Scalar x6 = inverse_ * sums_[2] + c_beta * x4;
      const Scalar w4 = number_ * x4;
      const Scalar x7 = -inverse_ * sums_[3] - s_beta * x4;
      const Scalar x8 = coefficients[k_][5];
      const Scalar x9 = sums_[4] + c_beta * x1 + b1 * x7;
      const Scalar x10 = sums_[5] + s_beta * x1 + b1 * x6;
      const Scalar x11 = n2_over_65 * x8 + n128_over_65 * x10;
      const Scalar x12 = sums_[6] + b11 * x5 + b5 * x11;
      const Scalar x13 = k5 * x3 - x12;
      const Scalar x14 = (x13 - (sums_[7] + b14 * x7)) * i14;
      const Scalar x15 = n2_over_65 * x8 + n63_over_65 * x10;
      const Scalar x16 = sums_[8] + b15 * x9 + b9 * x15;
      const Scalar x17 = sums_[9] + s_alpha * x6 + s_beta * x2;
      const Scalar x18 = sums_[10] + b9 * x5 + b5 * x9;
      const Scalar x19 = sums_[11] + b14 * x6 + s_beta * x14;
      coefficients[k_ + 1][0] = next_ * x1;
      coefficients[k_ + 1][1] = next_ * x5;
      coefficients[k_ + 1][2] = next_ * x8;
      coefficients[k_ + 1][3] = next_ * (-x14);
      coefficients[k_ + 1][4] = next_ * (-k8 * x7 + k5 * x17 - x16);
      coefficients[k_ + 1][5] = next_ * (x18 - x19);
      const Scalar left_[] = {w0, w0, w4, w4, x1, x1, x5, x14, x9, x2, x5, x6};
      const Scalar right_[] = {x3, x2, x7, x6, x7, x6, x11, x7, x15, x6, x9, x14};
      operations_.keep(k_, left_, right_);
      number_ = following_;
      inverse_ = next_;
    }
    static_cast<void>(inverse_);
    if (!(traits::regular(z1, z2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * coefficients[order][0] * coefficients[order][1] * coefficients[order][2]
        * coefficients[order][3] * coefficients[order][4] * coefficients[order][5];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed& precomputed, const State& state, int order,
      std::array<Scalar, 6>* coefficients) noexcept {
    return Mechanism::jets(precomputed, state, Inputs(), order, coefficients);
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
    visitor(Description::kernels[8], KernelFunction<torsor::Status, const Inputs&, int, std::array<Scalar, 6>*>(jets));
  }
};

}  // namespace heavy_top
