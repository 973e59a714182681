// SPDX-License-Identifier: MIT-0
// loading_robot: Press-loading robot: motor actions and the transverse reaction Y12
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
//   kinematics               20               27          0             0                  2       0     51      55
//   mass_matrix               9                7          0             0                  1       0     18      19
//   bias                     13               22          0             0                  2       0     39      39
//   inverse_dynamics         22               30          0             0                  2       0     56      56
//   forward_dynamics         35               45          2             0                  2       0     86      87
//   energy                   22               39          0             0                  2       0     65      70
//   reactions                 8               13          0             0                  2       0     25      25
//   linearisation           102              153          2             0                  2       0    261     263
//
// Not computed because this mechanism does not need it:
//   kinematics: of 84 results 46 vanish identically, 13 repeat another up to sign
//   mass_matrix: of 9 results 3 repeat another up to sign
//   first_integrals: left out, 'C01', 'F12', 'C23' have no force function
//   constraints: left out, the scene has no constraints
//   linearisation: of 93 results 32 vanish identically, 4 repeat another up to sign
//
// To write this file again:
//   loading_robot_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output loading_robot.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace loading_robot {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"alpha", "rad"}, {"x", "m"}, {"beta",
      "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"alpha", "rad/s"}, {"x", "m/s"}, {"beta",
      "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> inputs{{{"C01", "N m"}, {"F12", "N"}, {"C23", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 34> results{{{"result", "S1_position", 3, 1, 1, "m"},
      {"result", "S1_rotation", 3, 3, 2, "1"}, {"result", "S1_velocity", 3, 1, 1, "m/s"}, {"result",
      "S1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S2_position", 3, 1, 1, "m"}, {"result", "S2_rotation", 3, 3,
      2, "1"}, {"result", "S2_velocity", 3, 1, 1, "m/s"}, {"result", "S2_angular_velocity", 3, 1, 1, "rad/s"},
      {"result", "S3_position", 3, 1, 1, "m"}, {"result", "S3_rotation", 3, 3, 2, "1"}, {"result", "S3_velocity", 3, 1,
      1, "m/s"}, {"result", "S3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "Oo_position", 3, 1, 1, "m"},
      {"result", "Oo_velocity", 3, 1, 1, "m/s"}, {"result", "Oo_jacobian", 3, 3, 2, ""}, {"result", "O2_position", 3, 1,
      1, "m"}, {"result", "O2_velocity", 3, 1, 1, "m/s"}, {"result", "O2_jacobian", 3, 3, 2, ""}, {"mass", "", 3, 3, 2,
      ""}, {"forces", "", 3, 1, 1, "N m, N, N m"}, {"forces", "", 3, 1, 1, "N m, N, N m"}, {"accelerations", "", 3, 1,
      1, "rad/s^2, m/s^2, rad/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result",
      "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "Y12", 1, 1, 0, "N"}, {"result",
      "M", 3, 3, 2, ""}, {"result", "C", 3, 3, 2, ""}, {"result", "K", 3, 3, 2, ""}, {"result", "F", 3, 1, 1,
      "N m, N, N m"}, {"result", "E", 3, 3, 2, "1"}, {"result", "A", 6, 6, 2, ""}, {"result", "B", 6, 3, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 18}, {"mass_matrix", false, false, false, false, results.data() + 18, 1}, {"bias", false,
      false, false, false, results.data() + 19, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 20,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 21, 2}, {"energy", false, false, true, false,
      results.data() + 23, 3}, {"reactions", true, true, true, false, results.data() + 26, 1}, {"linearisation", true,
      true, true, true, results.data() + 27, 7}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::loading_robot::Description;

  static constexpr const char* name = "loading_robot";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe03ac945506f3739ULL ^ torsor::support_fingerprint;
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
    Scalar alpha;  ///< coordinate [rad]
    Scalar x;  ///< coordinate [m]
    Scalar beta;  ///< coordinate [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::alpha, &Coordinates::x, &Coordinates::beta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar alpha;  ///< its rate [rad/s]
    Scalar x;  ///< its rate [m/s]
    Scalar beta;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::alpha, &Velocities::x, &Velocities::beta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar alpha;  ///< its second rate [rad/s^2]
    Scalar x;  ///< its second rate [m/s^2]
    Scalar beta;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::alpha, &Accelerations::x, &Accelerations::beta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar alpha;  ///< works with the rate of alpha [N m]
    Scalar x;  ///< works with the rate of x [N]
    Scalar beta;  ///< works with the rate of beta [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::alpha, &GeneralizedForces::x,
          &GeneralizedForces::beta};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar C01;  ///< motor [N m]
    Scalar F12;  ///< motor [N]
    Scalar C23;  ///< motor [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C01, &Inputs::F12, &Inputs::C23};
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
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    state.time = n0;
    state.q.alpha = n0_4;
    state.q.x = n0_6;
    state.q.beta = n0_7;
    state.v.alpha = n0_2;
    state.v.x = -n0_1;
    state.v.beta = n0;
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
    std::array<Scalar, 3> S3_position;  ///< centre of mass of S3 [m]
    std::array<Scalar, 9> S3_rotation;  ///< from the axes of S3 to the ground's (3 x 3)
    std::array<Scalar, 3> S3_velocity;  ///< velocity of the centre of mass of S3 [m/s]
    std::array<Scalar, 3> S3_angular_velocity;  ///< angular velocity of S3 [rad/s]
    std::array<Scalar, 3> Oo_position;  ///< position of Oo [m]
    std::array<Scalar, 3> Oo_velocity;  ///< velocity of the material point at Oo [m/s]
    std::array<Scalar, 9> Oo_jacobian;  ///< partial velocities of Oo (3 x 3)
    std::array<Scalar, 3> O2_position;  ///< position of O2 [m]
    std::array<Scalar, 3> O2_velocity;  ///< velocity of the material point at O2 [m/s]
    std::array<Scalar, 9> O2_jacobian;  ///< partial velocities of O2 (3 x 3)
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
    Scalar Y12;  ///< reaction along 'Y12' [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::Y12};
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar z0 = q_alpha + q_beta;
    const Scalar angles_[] = {q_alpha, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n0_5 * v_alpha;
    const Scalar z4 = v_alpha * q_x;
    const Scalar z5 = v_alpha + v_beta;
    const Scalar z6 = n0_5 * s_alpha;
    const Scalar z7 = n0_5 * c_alpha;
    const Scalar z8 = c_alpha * q_x;
    const Scalar z9 = c_alpha * z3;  // velocity of guide, x
    const Scalar z10 = s_alpha * z3;  // velocity of guide, y
    const Scalar z11 = s_alpha * q_x;
    const Scalar z12 = n0_3 * v_alpha;
    const Scalar z13 = n0_4 * v_alpha;
    const Scalar z14 = n0_2 * z5;
    const Scalar z15 = n0_4 * c_alpha;
    const Scalar z16 = n0_4 * s_alpha;
    const Scalar z17 = n0_2 * z2;
    const Scalar z18 = n0_2 * z1;
    const Scalar z19 = z6 - z8;  // place of S2, x
    const Scalar z20 = z7 + z11;  // place of S2, y
    const Scalar z21 = z9 + s_alpha * z4 - c_alpha * v_x;  // velocity of S2, x
    const Scalar z22 = s_alpha * v_x - z10 + c_alpha * z4;  // velocity of S2, y
    const Scalar z23 = n0_3 * c_alpha - z6;
    const Scalar z24 = n0_3 * s_alpha + z7;
    const Scalar z25 = s_alpha * z12 + z9;
    const Scalar z26 = c_alpha * z12 - z10;
    const Scalar z27 = z19 - z15;
    const Scalar z28 = z20 + z16;
    const Scalar z29 = z19 + z17;
    const Scalar z30 = z20 - z18;
    const Scalar z31 = s_alpha * z13 + z21;
    const Scalar z32 = c_alpha * z13 + z22;
    const Scalar z33 = z21 - z1 * z14;
    const Scalar z34 = z22 - z2 * z14;
    result.S1_position[0] = z23;
    result.S1_position[1] = z24;
    result.S1_position[2] = n0;
    result.S1_rotation[0] = c_alpha;
    result.S1_rotation[1] = s_alpha;
    result.S1_rotation[2] = n0;
    result.S1_rotation[3] = -s_alpha;
    result.S1_rotation[4] = c_alpha;
    result.S1_rotation[5] = n0;
    result.S1_rotation[6] = n0;
    result.S1_rotation[7] = n0;
    result.S1_rotation[8] = n1;
    result.S1_velocity[0] = -z25;
    result.S1_velocity[1] = z26;
    result.S1_velocity[2] = n0;
    result.S1_angular_velocity[0] = n0;
    result.S1_angular_velocity[1] = n0;
    result.S1_angular_velocity[2] = v_alpha;
    result.S2_position[0] = -z27;
    result.S2_position[1] = z28;
    result.S2_position[2] = n0;
    result.S2_rotation[0] = c_alpha;
    result.S2_rotation[1] = s_alpha;
    result.S2_rotation[2] = n0;
    result.S2_rotation[3] = -s_alpha;
    result.S2_rotation[4] = c_alpha;
    result.S2_rotation[5] = n0;
    result.S2_rotation[6] = n0;
    result.S2_rotation[7] = n0;
    result.S2_rotation[8] = n1;
    result.S2_velocity[0] = -z31;
    result.S2_velocity[1] = z32;
    result.S2_velocity[2] = n0;
    result.S2_angular_velocity[0] = n0;
    result.S2_angular_velocity[1] = n0;
    result.S2_angular_velocity[2] = v_alpha;
    result.S3_position[0] = -z29;
    result.S3_position[1] = z30;
    result.S3_position[2] = n0;
    result.S3_rotation[0] = z2;
    result.S3_rotation[1] = z1;
    result.S3_rotation[2] = n0;
    result.S3_rotation[3] = -z1;
    result.S3_rotation[4] = z2;
    result.S3_rotation[5] = n0;
    result.S3_rotation[6] = n0;
    result.S3_rotation[7] = n0;
    result.S3_rotation[8] = n1;
    result.S3_velocity[0] = -z33;
    result.S3_velocity[1] = z34;
    result.S3_velocity[2] = n0;
    result.S3_angular_velocity[0] = n0;
    result.S3_angular_velocity[1] = n0;
    result.S3_angular_velocity[2] = z5;
    result.Oo_position[0] = n0;
    result.Oo_position[1] = n0;
    result.Oo_position[2] = n0;
    result.Oo_velocity[0] = n0;
    result.Oo_velocity[1] = n0;
    result.Oo_velocity[2] = n0;
    result.Oo_jacobian[0] = n0;
    result.Oo_jacobian[3] = n0;
    result.Oo_jacobian[6] = n0;
    result.Oo_jacobian[1] = n0;
    result.Oo_jacobian[4] = n0;
    result.Oo_jacobian[7] = n0;
    result.Oo_jacobian[2] = n0;
    result.Oo_jacobian[5] = n0;
    result.Oo_jacobian[8] = n0;
    result.O2_position[0] = -z19;
    result.O2_position[1] = z20;
    result.O2_position[2] = n0;
    result.O2_velocity[0] = -z21;
    result.O2_velocity[1] = z22;
    result.O2_velocity[2] = n0;
    result.O2_jacobian[0] = -z20;
    result.O2_jacobian[3] = c_alpha;
    result.O2_jacobian[6] = n0;
    result.O2_jacobian[1] = -z19;
    result.O2_jacobian[4] = s_alpha;
    result.O2_jacobian[7] = n0;
    result.O2_jacobian[2] = n0;
    result.O2_jacobian[5] = n0;
    result.O2_jacobian[8] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 9>& mass) noexcept {
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n16_5 = traits::constant(16.5, 16.5f, "33/2");
    const Scalar n33 = traits::constant(33.0, 33.0f, "33/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n8_25 = traits::constant(8.25, 8.25f, "33/4");
    const Scalar n36 = traits::constant(36.0, 36.0f, "36/1");
    const Scalar q_x = state.q.x;
    const Scalar q_beta = state.q.beta;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = n1_6 * c_beta;
    const Scalar z1 = n1_6 * s_beta;
    const Scalar z2 = n0_5 - q_x * z0;
    const Scalar z3 = n10 - z0;
    const Scalar z4 = n16_5 - z1;
    const Scalar z5 = q_x * (n33 * q_x + n2 * z3) + n0_5;
    const Scalar z6 = n0_5 * z1 - z2;
    const Scalar z7 = n8_25 - z1 + z5;
    const Scalar z8 = n36 + z7;
    mass[0] = z8;
    mass[1] = -z4;
    mass[2] = -z6;
    mass[3] = -z4;
    mass[4] = n33;
    mass[5] = z1;
    mass[6] = -z6;
    mass[7] = z1;
    mass[8] = n0_5;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n33 = traits::constant(33.0, 33.0f, "33/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n18 = traits::constant(18.0, 18.0f, "18/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n9_81 * c_alpha;
    const Scalar z1 = v_alpha * v_alpha;
    const Scalar z2 = n9_81 * s_alpha;
    const Scalar z3 = v_alpha + v_beta;  // angular velocity of S3, z
    const Scalar z4 = z3 * z3;
    const Scalar z5 = n1_6 * z4;  // force on S3, x
    const Scalar z6 = c_beta * z5;
    const Scalar z7 = s_beta * z5;
    const Scalar z8 = z0 - n0_5 * z1;
    const Scalar z9 = q_x * z1 - z2;
    const Scalar z10 = n2 * v_alpha * v_x + z8;
    const Scalar z11 = n10 * z1 - z6 + n33 * z9;  // force on S2, x
    const Scalar z12 = s_beta * z9 + c_beta * z10;
    const Scalar z13 = n33 * z10 + z7;  // force on S2, y
    const Scalar z14 = n1_6 * z12;  // moment on S3, z
    const Scalar z15 = n10 * z10 - z14;  // moment on S2, z
    const Scalar z16 = q_x * z13 + z15;  // moment on guide, z
    const Scalar z17 = n30 * z2 - n18 * z0 - n0_5 * z11 - z16;  // moment on S1, z
    forces.alpha = -z17;
    forces.x = -z11;
    forces.beta = -z14;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n33 = traits::constant(33.0, 33.0f, "33/1");
    const Scalar n36 = traits::constant(36.0, 36.0f, "36/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n18 = traits::constant(18.0, 18.0f, "18/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n9_81 * c_alpha;
    const Scalar z1 = v_alpha * v_alpha;
    const Scalar z2 = n9_81 * s_alpha;
    const Scalar z3 = v_alpha + v_beta;  // angular velocity of S3, z
    const Scalar z4 = a_alpha + a_beta;  // angular acceleration of S3, z
    const Scalar z5 = z3 * z3;
    const Scalar z6 = n1_6 * z4;  // force on S3, y
    const Scalar z7 = n1_6 * z5;  // force on S3, x
    const Scalar z8 = s_beta * z6 + c_beta * z7;
    const Scalar z9 = s_beta * z7 - c_beta * z6;
    const Scalar z10 = n0_5 * a_alpha - z2;
    const Scalar z11 = z0 - n0_5 * z1;
    const Scalar z12 = q_x * z1 - a_x + z10;
    const Scalar z13 = z11 + a_alpha * q_x + n2 * v_alpha * v_x;
    const Scalar z14 = n10 * z1 - z8 + n33 * z12;  // force on S2, x
    const Scalar z15 = s_beta * z12 + c_beta * z13;
    const Scalar z16 = n10 * a_alpha + z9 + n33 * z13;  // force on S2, y
    const Scalar z17 = n1_6 * z15 - n0_5 * z4;  // moment on S3, z
    const Scalar z18 = n10 * z13 - z17;  // moment on S2, z
    const Scalar z19 = q_x * z16 + z18;  // moment on guide, z
    const Scalar z20 = n36 * a_alpha - n30 * z2 + n18 * z0 + n0_5 * z14 + z19;  // moment on S1, z
    forces.alpha = z20;
    forces.x = -z14;
    forces.beta = -z17;
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
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n16_5 = traits::constant(16.5, 16.5f, "33/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n33 = traits::constant(33.0, 33.0f, "33/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n8_25 = traits::constant(8.25, 8.25f, "33/4");
    const Scalar n36 = traits::constant(36.0, 36.0f, "36/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n18 = traits::constant(18.0, 18.0f, "18/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar u_C01 = inputs.C01;
    const Scalar u_F12 = inputs.F12;
    const Scalar u_C23 = inputs.C23;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n1_6 * s_beta;
    const Scalar z1 = n1_6 * c_beta;
    const Scalar z2 = n9_81 * c_alpha;
    const Scalar z3 = v_alpha * v_alpha;
    const Scalar z4 = n9_81 * s_alpha;
    const Scalar z5 = v_alpha + v_beta;  // angular velocity of S3, z
    const Scalar z6 = z5 * z5;
    const Scalar z7 = n1_6 * z6;  // force on S3, x
    const Scalar z8 = c_beta * z7;
    const Scalar z9 = s_beta * z7;
    const Scalar z10 = z2 - n0_5 * z3;
    const Scalar z11 = q_x * z3 - z4;
    const Scalar z12 = n0_5 - q_x * z1;
    const Scalar z13 = n10 - z1;
    const Scalar z14 = n16_5 - z0;
    const Scalar z15 = n2 * z0;
    const Scalar z16 = q_x * (n33 * q_x + n2 * z13) + n0_5;
    const Scalar z17 = n33 - z0 * z15;
    const Scalar z18 = n2 * v_alpha * v_x + z10;
    const Scalar z19 = n10 * z3 - z8 + n33 * z11;  // force on S2, x
    const Scalar z20 = n0_5 * z0 - z12;
    const Scalar z21 = n1 / z17;
    const Scalar z22 = s_beta * z11 + c_beta * z18;
    const Scalar z23 = n33 * z18 + z9;  // force on S2, y
    const Scalar z24 = u_F12 + z19;
    const Scalar z25 = n2 * z20;
    const Scalar z26 = z20 * z15 - z14;
    const Scalar z27 = n8_25 - z0 + z16;
    const Scalar z28 = n1_6 * z22;  // moment on S3, z
    const Scalar z29 = n36 + z27;
    const Scalar z30 = n10 * z18 - z28;  // moment on S2, z
    const Scalar z31 = u_C23 + z28;
    const Scalar z32 = z20 * z25 - z29;
    const Scalar z33 = z24 - z31 * z15;
    const Scalar z34 = q_x * z23 + z30;  // moment on guide, z
    const Scalar z35 = z26 * z21;
    const Scalar z36 = n30 * z4 - n18 * z2 - n0_5 * z19 - z34;  // moment on S1, z
    const Scalar z37 = z32 + z26 * z35;
    const Scalar z38 = u_C01 + z36;
    const Scalar z39 = n1 / z37;
    const Scalar z40 = z38 + z31 * z25 - z35 * z33;
    const Scalar z41 = z39 * z40;
    const Scalar z42 = z21 * z33 + z35 * z41;
    const Scalar z43 = n2 * z31 - z25 * z41 - z15 * z42;
    accelerations.alpha = -z41;
    accelerations.x = z42;
    accelerations.beta = z43;
    if (!(traits::regular(-z37, z29) && traits::regular(z17, n33))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.alpha * accelerations.x * accelerations.beta;
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n18 = traits::constant(18.0, 18.0f, "18/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    const Scalar n12_5 = traits::constant(12.5, 12.5f, "25/2");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n323_73 = traits::constant(323.73, 323.73f, "32373/100");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar u_C01 = inputs.C01;
    const Scalar u_F12 = inputs.F12;
    const Scalar u_C23 = inputs.C23;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n0_5 * v_alpha;
    const Scalar z1 = v_alpha * q_x;
    const Scalar z2 = v_alpha + v_beta;  // angular velocity of S3, z
    const Scalar z3 = n1_6 * c_beta;
    const Scalar z4 = n1_6 * s_beta;
    const Scalar z5 = n18 * s_alpha + n30 * c_alpha;
    const Scalar z6 = v_x - z0;  // velocity of S2, x
    const Scalar z7 = n10 * v_alpha + n25 * z1;
    const Scalar z8 = s_beta * z6 - c_beta * z1;
    const Scalar z9 = s_beta * z1 + c_beta * z6;
    const Scalar z10 = n6 * v_alpha + n10 * z1;
    const Scalar z11 = s_alpha * q_x + n0_5 * c_alpha;
    const Scalar z12 = n10 * s_alpha;
    const Scalar z13 = s_alpha * z3 + c_alpha * z4;
    const Scalar z14 = n1_6 * z2 + n8 * z8;
    const Scalar z15 = n0_5 * z2 + n1_6 * z8;
    result.kinetic = n15 * v_alpha * v_alpha + n12_5 * z6 * z6 + n4 * z9 * z9 + n0_5 * (v_alpha * z10 + z1 * z7 + z8
        * z14 + z2 * z15);
    result.force_function = -n323_73 * z11 - n9_81 * (z5 + z12 - z13);
    result.power = v_alpha * u_C01 + v_x * u_F12 + v_beta * u_C23;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n33 = traits::constant(33.0, 33.0f, "33/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_alpha + v_beta;  // angular velocity of S3, z
    const Scalar z1 = n9_81 * c_alpha;
    const Scalar z2 = v_alpha * v_alpha;
    const Scalar z3 = a_alpha + a_beta;  // angular acceleration of S3, z
    const Scalar z4 = z0 * z0;
    const Scalar z5 = n1_6 * z3;  // force on S3, y
    const Scalar z6 = n1_6 * z4;  // force on S3, x
    const Scalar z7 = s_beta * z6 - c_beta * z5;
    const Scalar z8 = z1 - n0_5 * z2;
    const Scalar z9 = z8 + a_alpha * q_x + n2 * v_alpha * v_x;
    const Scalar z10 = n10 * a_alpha + z7 + n33 * z9;  // force on S2, y
    result.Y12 = z10;
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
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n33 = traits::constant(33.0, 33.0f, "33/1");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n16_5 = traits::constant(16.5, 16.5f, "33/2");
    const Scalar n8_25 = traits::constant(8.25, 8.25f, "33/4");
    const Scalar n36 = traits::constant(36.0, 36.0f, "36/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n18 = traits::constant(18.0, 18.0f, "18/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar u_C01 = inputs.C01;
    const Scalar u_F12 = inputs.F12;
    const Scalar u_C23 = inputs.C23;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = n1_6 * s_beta;
    const Scalar z1 = n9_81 * c_alpha;
    const Scalar z2 = v_alpha * v_alpha;
    const Scalar z3 = n1_6 * c_beta;
    const Scalar z4 = v_alpha + v_beta;  // angular velocity of S3, z
    const Scalar z5 = n2 * v_alpha;
    const Scalar z6 = z4 * z4;
    const Scalar z7 = n0_5 * z5;
    const Scalar z8 = n9_81 * s_alpha;
    const Scalar z9 = a_alpha + a_beta;  // angular acceleration of S3, z
    const Scalar z10 = q_x * z5;
    const Scalar z11 = n1_6 * z9;  // force on S3, y
    const Scalar z12 = n1_6 * z6;  // force on S3, x
    const Scalar z13 = n2 * v_x - z7;
    const Scalar z14 = n2 * z4;
    const Scalar z15 = a_alpha * c_beta + s_beta * z2;
    const Scalar z16 = s_beta * z12 - c_beta * z11;
    const Scalar z17 = n1_6 * z14;
    const Scalar z18 = s_beta * z10 + c_beta * z13;
    const Scalar z19 = c_beta * z17;
    const Scalar z20 = s_beta * z17;
    const Scalar z21 = c_beta * z5;
    const Scalar z22 = n33 * a_alpha;
    const Scalar z23 = s_beta * z11 + c_beta * z12;
    const Scalar z24 = n33 * z5;
    const Scalar z25 = n33 * z2;
    const Scalar z26 = n0_5 * a_alpha - z8;
    const Scalar z27 = z1 - n0_5 * z2;
    const Scalar z28 = n0_5 - q_x * z3;
    const Scalar z29 = n10 - z3;
    const Scalar z30 = n16_5 - z0;
    const Scalar z31 = n10 * z5 - z19 + n33 * z10;
    const Scalar z32 = n33 * z13 + z20;
    const Scalar z33 = n33 * z1;
    const Scalar z34 = n33 * z8;
    const Scalar z35 = s_beta * z1 + c_beta * z8;
    const Scalar z36 = n1_6 * z21;
    const Scalar z37 = q_x * (n33 * q_x + n2 * z29) + n0_5;
    const Scalar z38 = n10 * z5 - z36;
    const Scalar z39 = q_x * z2 - a_x + z26;
    const Scalar z40 = q_x * z20;
    const Scalar z41 = n0_5 * z19 - z40;
    const Scalar z42 = z27 + a_alpha * q_x + v_x * z5;
    const Scalar z43 = n0_5 * z0 - z28;
    const Scalar z44 = n1_6 * z18;
    const Scalar z45 = n1_6 * z15;
    const Scalar z46 = n10 * z2 - z23 + n33 * z39;  // force on S2, x
    const Scalar z47 = n10 * z13 - z44;
    const Scalar z48 = n1_6 * z35;
    const Scalar z49 = q_x * z24 + z38;
    const Scalar z50 = n10 * a_alpha - z45;
    const Scalar z51 = n10 * z8 - z48;
    const Scalar z52 = n8_25 - z0 + z37;
    const Scalar z53 = q_x * z32 + z47;
    const Scalar z54 = s_beta * z42 - c_beta * z39;
    const Scalar z55 = s_beta * z39 + c_beta * z42;
    const Scalar z56 = n2 * z0;
    const Scalar z57 = n2 * z43;
    const Scalar z58 = n33 - z0 * z56;
    const Scalar z59 = z43 * z56 - z30;
    const Scalar z60 = n10 * a_alpha + z16 + n33 * z42;  // force on S2, y
    const Scalar z61 = n36 + z52;
    const Scalar z62 = q_x * z34 + z51;
    const Scalar z63 = n0_5 * z31 + z53;
    const Scalar z64 = n1_6 * z55 - n0_5 * z9;  // moment on S3, z
    const Scalar z65 = n1 / z58;
    const Scalar z66 = z33 - z48 * z56;
    const Scalar z67 = q_x * z22 + z50 + z60;
    const Scalar z68 = z43 * z57 - z61;
    const Scalar z69 = n18 * z8 + n30 * z1 + n0_5 * z33 + z62;
    const Scalar z70 = n0_5 * z25 + z67;
    const Scalar z71 = n1_6 * z54;
    const Scalar z72 = z59 * z65;
    const Scalar z73 = q_x * z23 + z71;
    const Scalar z74 = n10 * z42 - z64;  // moment on S2, z
    const Scalar z75 = z68 + z59 * z72;
    const Scalar z76 = z48 * z57 - z69 - z72 * z66;
    const Scalar z77 = n0_5 * z16 + z73;
    const Scalar z78 = q_x * z60 + z74;  // moment on guide, z
    const Scalar z79 = n1 / z75;
    const Scalar z80 = n36 * a_alpha - n30 * z8 + n18 * z1 + n0_5 * z46 + z78;  // moment on S1, z
    const Scalar z81 = z31 - z44 * z56;
    const Scalar z82 = z25 - z45 * z56;
    const Scalar z83 = z16 + z71 * z56;
    const Scalar z84 = z44 * z57 - z63 - z72 * z81;
    const Scalar z85 = z45 * z57 - z70 - z72 * z82;
    const Scalar z86 = z71 * z57 + z77 + z72 * z83;
    const Scalar z87 = z19 * z72 + z41;
    const Scalar z88 = z79 * z76;
    const Scalar z89 = z79 * z84;
    const Scalar z90 = z79 * z85;
    const Scalar z91 = z79 * z86;
    const Scalar z92 = z79 * z87;
    const Scalar z93 = z65 * z66 + z72 * z88;
    const Scalar z94 = z65 * z81 + z72 * z89;
    const Scalar z95 = n2 * z48 - z57 * z88 - z56 * z93;
    const Scalar z96 = z36 * z56;
    const Scalar z97 = z36 * z57 - z49 + z72 * z96;
    const Scalar z98 = z57 + z56 * z72;
    const Scalar z99 = n2 * z44 - z57 * z89 - z56 * z94;
    const Scalar z100 = z79 * z97;
    const Scalar z101 = z72 * z79;
    const Scalar z102 = z79 * z98;
    const Scalar z103 = z65 * z82 + z72 * z90;
    const Scalar z104 = z65 * z96 - z72 * z100;
    const Scalar z105 = z65 * z83 - z72 * z91;
    const Scalar z106 = z19 * z65 - z72 * z92;
    const Scalar z107 = z65 - z72 * z101;
    const Scalar z108 = z56 * z65 - z72 * z102;
    const Scalar z109 = n2 * z45 - z57 * z90 - z56 * z103;
    const Scalar z110 = n2 * z36 - z57 * z100 + z56 * z104;
    const Scalar z111 = n2 * z71 - z57 * z91 + z56 * z105;
    const Scalar z112 = z57 * z92 - z56 * z106;
    const Scalar z113 = z57 * z79 + z56 * z101;
    const Scalar z114 = z57 * z101 - z56 * z107;
    const Scalar z115 = n2 - z57 * z102 + z56 * z108;
    result.M[0] = z61;
    result.M[1] = -z30;
    result.M[2] = -z43;
    result.M[3] = -z30;
    result.M[4] = n33;
    result.M[5] = z0;
    result.M[6] = -z43;
    result.M[7] = z0;
    result.M[8] = n0_5;
    result.C[0] = z63;
    result.C[1] = -z31;
    result.C[2] = -z44;
    result.C[3] = z49;
    result.C[4] = n0;
    result.C[5] = -z36;
    result.C[6] = -z41;
    result.C[7] = z19;
    result.C[8] = n0;
    result.K[0] = -z69;
    result.K[1] = z33;
    result.K[2] = z48;
    result.K[3] = z70;
    result.K[4] = -z25;
    result.K[5] = -z45;
    result.K[6] = z77;
    result.K[7] = -z16;
    result.K[8] = z71;
    result.F[0] = u_C01 - z80;
    result.F[1] = u_F12 + z46;
    result.F[2] = u_C23 + z64;
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
    result.A[3] = z88;
    result.A[4] = -z93;
    result.A[5] = -z95;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = -z90;
    result.A[10] = z103;
    result.A[11] = z109;
    result.A[12] = n0;
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = z91;
    result.A[16] = z105;
    result.A[17] = -z111;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = -z89;
    result.A[22] = z94;
    result.A[23] = z99;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = -z100;
    result.A[28] = -z104;
    result.A[29] = z110;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = -z92;
    result.A[34] = -z106;
    result.A[35] = -z112;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = -z79;
    result.B[4] = z101;
    result.B[5] = -z113;
    result.B[6] = n0;
    result.B[7] = n0;
    result.B[8] = n0;
    result.B[9] = z101;
    result.B[10] = z107;
    result.B[11] = z114;
    result.B[12] = n0;
    result.B[13] = n0;
    result.B[14] = n0;
    result.B[15] = -z102;
    result.B[16] = -z108;
    result.B[17] = z115;
    if (!(traits::regular(-z75, z61) && traits::regular(z58, n33))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.M[0] * result.M[1] * result.M[2] * result.M[3] * result.M[5] * result.M[6]
        * result.M[7] * result.C[0] * result.C[1] * result.C[2] * result.C[3] * result.C[5] * result.C[6]) * (n0
        * result.C[7] * result.K[0] * result.K[1] * result.K[2] * result.K[3] * result.K[4] * result.K[5] * result.K[6]
        * result.K[7] * result.K[8] * result.F[0] * result.F[1] * result.F[2])) * ((n0 * result.A[3] * result.A[4]
        * result.A[5] * result.A[9] * result.A[10] * result.A[11] * result.A[15] * result.A[16] * result.A[17]
        * result.A[21] * result.A[22] * result.A[23] * result.A[27]) * (n0 * result.A[28] * result.A[29] * result.A[33]
        * result.A[34] * result.A[35] * result.B[3] * result.B[4] * result.B[5] * result.B[9] * result.B[10]
        * result.B[11] * result.B[15] * result.B[16] * result.B[17]));
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

}  // namespace loading_robot
