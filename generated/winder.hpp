// SPDX-License-Identifier: MIT-0
// winder: Winder: a bobbin on a turning arm
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, reactions, linearisation
// Parameters set at run time: omega, slope
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                1               19          0             0                  1       0     22       -
//   kinematics               11               31          0             0                  2       0     46      50
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      3                3          0             0                  0       0      6      12
//   inverse_dynamics          4                4          0             0                  0       0      8      14
//   forward_dynamics          3                4          0             0                  0       0      7      13
//   energy                   16               26          0             0                  1       0     44      58
//   first_integrals          20               31          0             0                  1       0     53      68
//   reactions                18               32          0             0                  1       0     52      65
//   linearisation             4                4          0             0                  0       0      8      17
//
// Not computed because this mechanism does not need it:
//   kinematics: of 60 results 26 vanish identically, 11 repeat another up to sign
//   mass_matrix: of 4 results 2 vanish identically
//   bias: of 2 results 1 vanish identically
//   forward_dynamics: of 2 results 1 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   linearisation: of 30 results 22 vanish identically
//
// To write this file again:
//   winder_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output winder.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace winder {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"lambda", "m"}, {"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"lambda", "m/s"}, {"phi", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"omega", "rad/s"}, {"slope", "rad"}}};
  static constexpr std::array<torsor::ResultDescription, 30> results{{{"result", "Sigma_position", 3, 1, 1, "m"},
      {"result", "Sigma_rotation", 3, 3, 2, "1"}, {"result", "Sigma_velocity", 3, 1, 1, "m/s"}, {"result",
      "Sigma_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S_position", 3, 1, 1, "m"}, {"result", "S_rotation", 3,
      3, 2, "1"}, {"result", "S_velocity", 3, 1, 1, "m/s"}, {"result", "S_angular_velocity", 3, 1, 1, "rad/s"},
      {"result", "G_position", 3, 1, 1, "m"}, {"result", "G_velocity", 3, 1, 1, "m/s"}, {"result", "G_jacobian", 3, 2,
      2, "1"}, {"result", "fixed_position", 3, 1, 1, "m"}, {"result", "fixed_velocity", 3, 1, 1, "m/s"}, {"result",
      "fixed_jacobian", 3, 2, 2, ""}, {"mass", "", 2, 2, 2, ""}, {"forces", "", 2, 1, 1, "N"}, {"forces", "", 2, 1, 1,
      "N, N m"}, {"accelerations", "", 2, 1, 1, "m/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1,
      0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "painleve", 1,
      1, 0, "J"}, {"result", "momentum_phi", 1, 1, 0, "N m s"}, {"result", "motor", 1, 1, 0, "N m"}, {"result", "M", 2,
      2, 2, ""}, {"result", "C", 2, 2, 2, ""}, {"result", "K", 2, 2, 2, "N/m"}, {"result", "F", 2, 1, 1, "N, N m"},
      {"result", "A", 4, 4, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 14}, {"mass_matrix", false, false, false, false, results.data() + 14, 1}, {"bias", false,
      false, false, false, results.data() + 15, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 16,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 17, 2}, {"energy", false, false, true, false,
      results.data() + 19, 3}, {"first_integrals", false, false, false, false, results.data() + 22, 2}, {"reactions",
      true, true, true, false, results.data() + 24, 1}, {"linearisation", true, true, true, true, results.data() + 25,
      5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::winder::Description;

  static constexpr const char* name = "winder";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x25b2bb4d5bfcb6abULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 2;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar omega;  ///< parameter [rad/s]
    Scalar slope;  ///< parameter [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::omega, &Parameters::slope};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar lambda;  ///< coordinate [m]
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::lambda, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar lambda;  ///< its rate [m/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::lambda, &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar lambda;  ///< its second rate [m/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::lambda, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar lambda;  ///< works with the rate of lambda [N]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::lambda, &GeneralizedForces::phi};
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
    Scalar m_5497d850;
    Scalar m_0d85e50a;
    Scalar m_e2924f70;
    Scalar m_1d3b3676;
    Scalar m_462a1001;
    Scalar m_6a95ea13;
    Scalar m_1a460582;
    Scalar m_07225285;
    Scalar m_4e72cd7c;
    Scalar m_107ee610;
    Scalar m_67ccdc7c;
    Scalar m_38b72402;
    Scalar m_ecb3ecf5;
    Scalar m_7e409560;
    Scalar m_4487ff3a;
    Scalar m_c1fca877;
    Scalar m_45a85e48;
    Scalar m_ae98d915;
    Scalar m_c069d2c4;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar pi = traits::pi();
    parameters.omega = n10;
    parameters.slope = n1_over_3 * pi;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar p_omega = parameters.omega;
    const Scalar p_slope = parameters.slope;
    Scalar s_slope, c_slope;
    traits::sincos(p_slope, s_slope, c_slope);
    const Scalar z0 = n0_2 * p_omega;
    const Scalar z1 = p_omega * s_slope;
    const Scalar z2 = n0_3 * c_slope;
    const Scalar z3 = n9_81 * c_slope;
    const Scalar z4 = z1 * z1;
    const Scalar z5 = p_omega * c_slope;
    const Scalar z6 = c_slope * z0;
    const Scalar z7 = s_slope * z0;
    const Scalar z8 = n0_3 * s_slope;
    const Scalar z9 = n0_01 * p_omega;
    const Scalar z10 = p_omega * z9;
    const Scalar z11 = n0_0005 * z5;
    const Scalar z12 = p_omega * p_omega;
    const Scalar z13 = n0_2 * z12;
    const Scalar z14 = n9_81 * s_slope;
    const Scalar z15 = z1 * z5;
    const Scalar z16 = n2 * z1;
    const Scalar z17 = n200 - n0_5 * z4;
    const Scalar z18 = n2 * z17;
    precomputed.m_5497d850 = s_slope;
    precomputed.m_0d85e50a = c_slope;
    precomputed.m_e2924f70 = z0;
    precomputed.m_1d3b3676 = z1;
    precomputed.m_462a1001 = z2;
    precomputed.m_6a95ea13 = z3;
    precomputed.m_1a460582 = z4;
    precomputed.m_07225285 = z5;
    precomputed.m_4e72cd7c = z6;
    precomputed.m_107ee610 = z7;
    precomputed.m_67ccdc7c = z8;
    precomputed.m_38b72402 = z10;
    precomputed.m_ecb3ecf5 = z11;
    precomputed.m_7e409560 = z13;
    precomputed.m_4487ff3a = z14;
    precomputed.m_c1fca877 = z15;
    precomputed.m_45a85e48 = z16;
    precomputed.m_ae98d915 = z17;
    precomputed.m_c069d2c4 = z18;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    state.time = n0;
    state.q.lambda = n0_05;
    state.q.phi = n0;
    state.v.lambda = n0;
    state.v.phi = n5;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> Sigma_position;  ///< centre of mass of Sigma [m]
    std::array<Scalar, 9> Sigma_rotation;  ///< from the axes of Sigma to the ground's (3 x 3)
    std::array<Scalar, 3> Sigma_velocity;  ///< velocity of the centre of mass of Sigma [m/s]
    std::array<Scalar, 3> Sigma_angular_velocity;  ///< angular velocity of Sigma [rad/s]
    std::array<Scalar, 3> S_position;  ///< centre of mass of S [m]
    std::array<Scalar, 9> S_rotation;  ///< from the axes of S to the ground's (3 x 3)
    std::array<Scalar, 3> S_velocity;  ///< velocity of the centre of mass of S [m/s]
    std::array<Scalar, 3> S_angular_velocity;  ///< angular velocity of S [rad/s]
    std::array<Scalar, 3> G_position;  ///< position of G [m]
    std::array<Scalar, 3> G_velocity;  ///< velocity of the material point at G [m/s]
    std::array<Scalar, 6> G_jacobian;  ///< partial velocities of G (3 x 2)
    std::array<Scalar, 3> fixed_position;  ///< position of fixed [m]
    std::array<Scalar, 3> fixed_velocity;  ///< velocity of the material point at fixed [m/s]
    std::array<Scalar, 6> fixed_jacobian;  ///< partial velocities of fixed (3 x 2)
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
    Scalar painleve;  ///< T2 - T0 - U [J]
    Scalar momentum_phi;  ///< dT/dphi' of the cyclic coordinate 'phi' [N m s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::painleve, &FirstIntegrals::momentum_phi};
      return members_[i_];
    }
  };

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar motor;  ///< reaction along 'motor' [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::motor};
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
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_lambda = state.q.lambda;
    const Scalar v_lambda = state.v.lambda;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar s_slope = precomputed.m_5497d850;
    const Scalar c_slope = precomputed.m_0d85e50a;
    const Scalar m2 = precomputed.m_e2924f70;
    const Scalar m3 = precomputed.m_1d3b3676;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {z0, q_phi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z1 = sines_[0], z2 = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar z3 = z1 * m2;  // velocity of holder, x
    const Scalar z4 = z2 * m2;  // velocity of holder, y
    const Scalar z5 = q_lambda * m3;
    const Scalar z6 = z1 * s_slope;
    const Scalar z7 = z2 * s_slope;
    const Scalar z8 = z1 * c_slope;
    const Scalar z9 = z2 * c_slope;
    const Scalar z10 = n0_2 * z2;
    const Scalar z11 = n0_2 * z1;
    const Scalar z12 = c_slope * q_lambda;
    const Scalar z13 = c_slope * v_lambda;  // velocity of S.1, z
    const Scalar z14 = s_slope * s_phi;
    const Scalar z15 = s_slope * c_phi;
    const Scalar z16 = p_omega + c_slope * v_phi;  // angular velocity of S, z
    const Scalar z17 = q_lambda * z6;
    const Scalar z18 = q_lambda * z7;
    const Scalar z19 = z2 * z5 - z3 + v_lambda * z6;  // velocity of S.1, x
    const Scalar z20 = z4 + z1 * z5 - v_lambda * z7;  // velocity of S.1, y
    const Scalar z21 = z2 * c_phi - s_phi * z8;
    const Scalar z22 = z2 * s_phi + c_phi * z8;
    const Scalar z23 = z1 * c_phi + s_phi * z9;
    const Scalar z24 = z1 * s_phi - c_phi * z9;
    const Scalar z25 = v_phi * z6;  // angular velocity of S, x
    const Scalar z26 = v_phi * z7;  // angular velocity of S, y
    const Scalar z27 = z10 + z17;  // place of S.1, x
    const Scalar z28 = z11 - z18;  // place of S.1, y
    result.Sigma_position[0] = n0;
    result.Sigma_position[1] = n0;
    result.Sigma_position[2] = n0;
    result.Sigma_rotation[0] = z2;
    result.Sigma_rotation[1] = z1;
    result.Sigma_rotation[2] = n0;
    result.Sigma_rotation[3] = -z1;
    result.Sigma_rotation[4] = z2;
    result.Sigma_rotation[5] = n0;
    result.Sigma_rotation[6] = n0;
    result.Sigma_rotation[7] = n0;
    result.Sigma_rotation[8] = n1;
    result.Sigma_velocity[0] = n0;
    result.Sigma_velocity[1] = n0;
    result.Sigma_velocity[2] = n0;
    result.Sigma_angular_velocity[0] = n0;
    result.Sigma_angular_velocity[1] = n0;
    result.Sigma_angular_velocity[2] = p_omega;
    result.S_position[0] = z27;
    result.S_position[1] = z28;
    result.S_position[2] = z12;
    result.S_rotation[0] = z21;
    result.S_rotation[1] = z23;
    result.S_rotation[2] = z14;
    result.S_rotation[3] = -z22;
    result.S_rotation[4] = -z24;
    result.S_rotation[5] = z15;
    result.S_rotation[6] = z6;
    result.S_rotation[7] = -z7;
    result.S_rotation[8] = c_slope;
    result.S_velocity[0] = z19;
    result.S_velocity[1] = z20;
    result.S_velocity[2] = z13;
    result.S_angular_velocity[0] = z25;
    result.S_angular_velocity[1] = -z26;
    result.S_angular_velocity[2] = z16;
    result.G_position[0] = z27;
    result.G_position[1] = z28;
    result.G_position[2] = z12;
    result.G_velocity[0] = z19;
    result.G_velocity[1] = z20;
    result.G_velocity[2] = z13;
    result.G_jacobian[0] = z6;
    result.G_jacobian[3] = n0;
    result.G_jacobian[1] = -z7;
    result.G_jacobian[4] = n0;
    result.G_jacobian[2] = c_slope;
    result.G_jacobian[5] = n0;
    result.fixed_position[0] = n0;
    result.fixed_position[1] = n0;
    result.fixed_position[2] = n0_3;
    result.fixed_velocity[0] = n0;
    result.fixed_velocity[1] = n0;
    result.fixed_velocity[2] = n0;
    result.fixed_jacobian[0] = n0;
    result.fixed_jacobian[3] = n0;
    result.fixed_jacobian[1] = n0;
    result.fixed_jacobian[4] = n0;
    result.fixed_jacobian[2] = n0;
    result.fixed_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    mass[0] = n0_5;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0_0005;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_lambda = state.q.lambda;
    const Scalar m0 = precomputed.m_462a1001;
    const Scalar m1 = precomputed.m_6a95ea13;
    const Scalar m2 = precomputed.m_1a460582;
    const Scalar z0 = q_lambda - m0;
    const Scalar z1 = q_lambda * m2 - m1;
    const Scalar z2 = n200 * z0;
    const Scalar z3 = z2 - n0_5 * z1;  // force on S.1, z
    forces.lambda = z3;
    forces.phi = n0;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar q_lambda = state.q.lambda;
    const Scalar a_lambda = accelerations.lambda;
    const Scalar a_phi = accelerations.phi;
    const Scalar m0 = precomputed.m_462a1001;
    const Scalar m1 = precomputed.m_6a95ea13;
    const Scalar m2 = precomputed.m_1a460582;
    const Scalar z0 = q_lambda - m0;
    const Scalar z1 = q_lambda * m2 - a_lambda - m1;
    const Scalar z2 = n0_0005 * a_phi;  // moment on S, z
    const Scalar z3 = n200 * z0;
    const Scalar z4 = z3 - n0_5 * z1;  // force on S.1, z
    forces.lambda = z4;
    forces.phi = z2;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_lambda = state.q.lambda;
    const Scalar m0 = precomputed.m_462a1001;
    const Scalar m1 = precomputed.m_6a95ea13;
    const Scalar m2 = precomputed.m_1a460582;
    const Scalar z0 = q_lambda - m0;
    const Scalar z1 = q_lambda * m2 - m1;
    const Scalar z2 = n200 * z0;
    const Scalar z3 = z2 - n0_5 * z1;  // force on S.1, z
    const Scalar z4 = n2 * z3;
    accelerations.lambda = -z4;
    accelerations.phi = n0;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.lambda;
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
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar k1 = traits::constant(0.00025, 0.00025f, "1/4000");
    const Scalar n0_0004 = traits::constant(4e-04, 4e-04f, "1/2500");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_lambda = state.q.lambda;
    const Scalar v_lambda = state.v.lambda;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar c_slope = precomputed.m_0d85e50a;
    const Scalar m1 = precomputed.m_1d3b3676;
    const Scalar m2 = precomputed.m_07225285;
    const Scalar m3 = precomputed.m_4e72cd7c;
    const Scalar m4 = precomputed.m_107ee610;
    const Scalar m5 = precomputed.m_67ccdc7c;
    const Scalar m6 = precomputed.m_462a1001;
    const Scalar m7 = precomputed.m_38b72402;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = q_lambda - m6;
    const Scalar z1 = s_phi * m5 - n0_2 * c_phi;
    const Scalar z2 = q_lambda * m1;
    const Scalar z3 = n0_2 * s_phi + c_phi * m5;
    const Scalar z4 = v_lambda - m4;  // velocity of S.1, z
    const Scalar z5 = s_phi * m1;
    const Scalar z6 = c_phi * m1;
    const Scalar z7 = s_phi * m3 + c_phi * z2;
    const Scalar z8 = s_phi * z2 - c_phi * m3;
    const Scalar z9 = v_phi + m2;  // angular velocity of S, z
    const Scalar z10 = c_slope * q_lambda;
    const Scalar z11 = z0 * z0 + z1 * z1 + z3 * z3;
    result.kinetic = m7 + k1 * z9 * z9 + n0_0004 * (z5 * z5 + z6 * z6) + n0_25 * (z4 * z4 + z7 * z7 + z8 * z8);
    result.force_function = -n4_905 * z10 - n100 * z11;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar k4 = traits::constant(0.00025, 0.00025f, "1/4000");
    const Scalar n0_0004 = traits::constant(4e-04, 4e-04f, "1/2500");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar q_lambda = state.q.lambda;
    const Scalar v_lambda = state.v.lambda;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar c_slope = precomputed.m_0d85e50a;
    const Scalar m1 = precomputed.m_1d3b3676;
    const Scalar m2 = precomputed.m_07225285;
    const Scalar m3 = precomputed.m_4e72cd7c;
    const Scalar m4 = precomputed.m_107ee610;
    const Scalar m5 = precomputed.m_67ccdc7c;
    const Scalar m6 = precomputed.m_462a1001;
    const Scalar m7 = precomputed.m_ecb3ecf5;
    const Scalar m8 = precomputed.m_38b72402;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = q_lambda - m6;
    const Scalar z1 = s_phi * m5 - n0_2 * c_phi;
    const Scalar z2 = q_lambda * m1;
    const Scalar z3 = n0_2 * s_phi + c_phi * m5;
    const Scalar z4 = v_lambda - m4;  // velocity of S.1, z
    const Scalar z5 = v_phi + m2;  // angular velocity of S, z
    const Scalar z6 = s_phi * m1;
    const Scalar z7 = c_phi * m1;
    const Scalar z8 = s_phi * m3 + c_phi * z2;
    const Scalar z9 = s_phi * z2 - c_phi * m3;
    const Scalar z10 = n0_0005 * z5;
    const Scalar z11 = n0_5 * z4;
    const Scalar z12 = c_slope * q_lambda;
    const Scalar z13 = z0 * z0 + z1 * z1 + z3 * z3;
    result.painleve = n4_905 * z12 - m8 + v_lambda * z11 + v_phi * z10 - k4 * z5 * z5 - n0_0004 * (z6 * z6 + z7 * z7)
        - n0_25 * (z4 * z4 + z8 * z8 + z9 * z9) + n100 * z13;
    result.momentum_phi = n0_0005 * v_phi + m7;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar q_lambda = state.q.lambda;
    const Scalar v_lambda = state.v.lambda;
    const Scalar a_lambda = accelerations.lambda;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar s_slope = precomputed.m_5497d850;
    const Scalar c_slope = precomputed.m_0d85e50a;
    const Scalar m2 = precomputed.m_67ccdc7c;
    const Scalar m3 = precomputed.m_462a1001;
    const Scalar m4 = precomputed.m_1d3b3676;
    const Scalar m5 = precomputed.m_07225285;
    const Scalar m6 = precomputed.m_7e409560;
    const Scalar m7 = precomputed.m_4487ff3a;
    const Scalar m8 = precomputed.m_6a95ea13;
    const Scalar m9 = precomputed.m_c1fca877;
    const Scalar m10 = precomputed.m_1a460582;
    const Scalar m11 = precomputed.m_45a85e48;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = n0_2 * s_phi + c_phi * m2;
    const Scalar z1 = c_phi * m4;
    const Scalar z2 = v_phi + m5;  // angular velocity of S, z
    const Scalar z3 = s_phi * m2 - n0_2 * c_phi;
    const Scalar z4 = s_phi * m4;
    const Scalar z5 = q_lambda - m3;
    const Scalar z6 = v_lambda * m11 - m6;
    const Scalar z7 = n200 * z5;
    const Scalar z8 = q_lambda * m10 - a_lambda - m8;
    const Scalar z9 = q_lambda * m9 + m7;
    const Scalar z10 = n0_0005 * a_phi;  // moment on S, z
    const Scalar z11 = z7 - n0_5 * z8;  // force on S.1, z
    const Scalar z12 = z1 * z2;
    const Scalar z13 = z4 * z2;
    const Scalar z14 = n0_0005 * z12;  // moment on S, x
    const Scalar z15 = n0_0005 * z13;  // moment on S, y
    const Scalar z16 = n200 * z3;
    const Scalar z17 = n200 * z0;
    const Scalar z18 = s_phi * z14 - c_phi * z15;
    const Scalar z19 = s_phi * z17 - c_phi * z16;
    const Scalar z20 = s_phi * z16 + c_phi * z17;
    const Scalar z21 = n0_5 * z6 + z19;  // force on S.1, x
    const Scalar z22 = n0_5 * z9 - z20;  // force on S.1, y
    const Scalar z23 = q_lambda * z21 + z18;  // moment on holder, y
    const Scalar z24 = s_slope * z11 - c_slope * z22;
    const Scalar z25 = c_slope * z10 + s_slope * z23;
    const Scalar z26 = n0_2 * z24 - z25;  // moment on Sigma, z
    result.motor = -z26;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, Reactions& result) noexcept {
    Mechanism::reactions(precomputed, state, accelerations, Multipliers(), Inputs(), result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n0_0005 = traits::constant(5e-04, 5e-04f, "1/2000");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_lambda = state.q.lambda;
    const Scalar a_lambda = accelerations.lambda;
    const Scalar a_phi = accelerations.phi;
    const Scalar m0 = precomputed.m_462a1001;
    const Scalar m1 = precomputed.m_6a95ea13;
    const Scalar m2 = precomputed.m_1a460582;
    const Scalar m3 = precomputed.m_ae98d915;
    const Scalar m4 = precomputed.m_c069d2c4;
    const Scalar z0 = q_lambda - m0;
    const Scalar z1 = q_lambda * m2 - a_lambda - m1;
    const Scalar z2 = n0_0005 * a_phi;  // moment on S, z
    const Scalar z3 = n200 * z0;
    const Scalar z4 = z3 - n0_5 * z1;  // force on S.1, z
    result.M[0] = n0_5;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0_0005;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.K[0] = m3;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.F[0] = -z4;
    result.F[1] = -z2;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = -m4;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = n0;
    result.A[15] = n0;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.K[0] * result.F[0] * result.F[1] * result.A[2];
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
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, Reactions&>(reactions));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace winder
