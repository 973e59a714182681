// SPDX-License-Identifier: MIT-0
// graham_variator: Graham variator: a cone rolling in a ring drives a third body
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints, linearisation
// Parameters set at run time: d
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute               16               30          5             0                  0       0     51       -
//   kinematics               25               50          0             0                  3       0     81      85
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      1                4          0             0                  1       0      7       7
//   inverse_dynamics          9               14          0             0                  1       0     25      36
//   forward_dynamics         12               21          0             0                  1       0     35      62
//   energy                   13               29          0             0                  2       0     46      50
//   constraints               3                4          0             0                  0       0      7      19
//   linearisation            27               35          0             0                  1       0     64     100
//
// Not computed because this mechanism does not need it:
//   kinematics: of 84 results 41 vanish identically, 8 repeat another up to sign
//   mass_matrix: of 9 results 4 vanish identically
//   bias: of 3 results 2 vanish identically
//   forward_dynamics: of 7 results 2 vanish identically
//   first_integrals: left out, 'C1', 'C3' have no force function
//   constraints: of 24 results 17 vanish identically
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 68 results 46 vanish identically, 2 repeat another up to sign
//
// Constraints:
//   Constraints that repeat others are left out, their multipliers are 0: rolling_A_x, rolling_E_x.
//
// To write this file again:
//   graham_variator_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output graham_variator.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace graham_variator {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"alpha", "rad"}, {"beta", "rad"}, {"gamma",
      "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"alpha", "rad/s"}, {"beta", "rad/s"},
      {"gamma", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> inputs{{{"C1", "N m"}, {"C3", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 4> multipliers{{{"lambda_rolling_A_x", "N"}, {"T_A", "N"},
      {"lambda_rolling_E_x", "N"}, {"T_E", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"d", "m"}}};
  static constexpr std::array<torsor::ResultDescription, 42> results{{{"result", "S1_position", 3, 1, 1, "m"},
      {"result", "S1_rotation", 3, 3, 2, "1"}, {"result", "S1_velocity", 3, 1, 1, "m/s"}, {"result",
      "S1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S2_position", 3, 1, 1, "m"}, {"result", "S2_rotation", 3, 3,
      2, "1"}, {"result", "S2_velocity", 3, 1, 1, "m/s"}, {"result", "S2_angular_velocity", 3, 1, 1, "rad/s"},
      {"result", "S3_position", 3, 1, 1, "m"}, {"result", "S3_rotation", 3, 3, 2, "1"}, {"result", "S3_velocity", 3, 1,
      1, "m/s"}, {"result", "S3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "A_position", 3, 1, 1, "m"}, {"result",
      "A_velocity", 3, 1, 1, "m/s"}, {"result", "A_jacobian", 3, 3, 2, "m"}, {"result", "E_position", 3, 1, 1, "m"},
      {"result", "E_velocity", 3, 1, 1, "m/s"}, {"result", "E_jacobian", 3, 3, 2, "m"}, {"mass", "", 3, 3, 2, "kg m^2"},
      {"forces", "", 3, 1, 1, "N m"}, {"forces", "", 3, 1, 1, "N m"}, {"accelerations", "", 3, 1, 1, "rad/s^2"},
      {"multipliers", "", 4, 1, 1, "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0,
      "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "value", 4, 1, 1, ""}, {"result", "rate", 4, 1, 1, "m/s"},
      {"result", "jacobian", 4, 3, 2, "m"}, {"result", "gamma", 4, 1, 1, ""}, {"result", "M", 3, 3, 2, "kg m^2"},
      {"result", "C", 3, 3, 2, ""}, {"result", "K", 3, 3, 2, "N m"}, {"result", "F", 3, 1, 1, "N m"}, {"result", "E", 3,
      2, 2, "1"}, {"result", "M_r", 1, 1, 2, "kg m^2"}, {"result", "C_r", 1, 1, 2, ""}, {"result", "K_r", 1, 3, 2,
      "N m"}, {"result", "F_r", 1, 1, 1, "N m"}, {"result", "E_r", 1, 2, 2, "1"}, {"result", "A", 4, 4, 2, ""},
      {"result", "B", 4, 2, 2, "1/kg/m^2"}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 18}, {"mass_matrix", false, false, false, false, results.data() + 18, 1}, {"bias", false,
      false, false, false, results.data() + 19, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 20,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 21, 2}, {"energy", false, false, true, false,
      results.data() + 23, 3}, {"constraints", false, false, false, false, results.data() + 26, 4}, {"linearisation",
      true, true, true, true, results.data() + 30, 12}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::graham_variator::Description;

  static constexpr const char* name = "graham_variator";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x1c7fe08bbdf0790eULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 3;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 2;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 4;
  static constexpr int first_integral_count = 0;
  /// Multipliers that are taken as zero: their constraints repeat others.
  static constexpr int redundant_count = 2;
  static constexpr int redundant_multipliers[redundant_count] = {0, 2};

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar d;  ///< parameter [m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::d};
      return members_[i_];
    }
  };

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
  struct Inputs {
    Scalar C1;  ///< motor [N m]
    Scalar C3;  ///< motor [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C1, &Inputs::C3};
      return members_[i_];
    }
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_rolling_A_x;  ///< indeterminate, of the constraint rolling_A_x [N]
    Scalar T_A;  ///< of the constraint rolling_A_y [N]
    Scalar lambda_rolling_E_x;  ///< indeterminate, of the constraint rolling_E_x [N]
    Scalar T_E;  ///< of the constraint rolling_E_y [N]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_rolling_A_x, &Multipliers::T_A,
          &Multipliers::lambda_rolling_E_x, &Multipliers::T_E};
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
    Scalar m_46683f43;
    Scalar m_852b2189;
    Scalar m_d9a89de0;
    Scalar m_6536f1f6;
    Scalar m_86e17fa2;
    Scalar m_ea2508da;
    Scalar m_a117cb70;
    Scalar m_30009293;
    Scalar m_1f0a45e1;
    Scalar m_778397ee;
    Scalar m_ede56c5d;
    Scalar m_414ab9fb;
    Scalar m_0f787c15;
    Scalar m_6b92ce98;
    Scalar m_152fd5e6;
    Scalar m_efa9d5f5;
    Scalar m_9fc44db5;
    Scalar m_97a82f3a;
    Scalar m_01924d0c;
    Scalar m_64965342;
    Scalar m_c2186257;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    parameters.d = n0_1;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar k0 = traits::constant(0.2679491924311227, 0.2679492f, "2;0;-1;0");
    const Scalar k1 = traits::constant(0.9659258262890683, 0.9659258f, "0;1/4;0;1/4");
    const Scalar k2 = traits::constant(0.25881904510252074, 0.25881904f, "0;-1/4;0;1/4");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k4 = traits::constant(58.17702669501042, 58.177025f,
        "10423180000/199644649;-1286500000/199644649;-606230000/598933947;1372100000/199644649");
    const Scalar k5 = traits::constant(3333.3333333333335, 3333.3333f, "10000/3");
    const Scalar k6 = traits::constant(0.5365982994617848, 0.5365983f,
        "96127600/199644649;-9185885/399289298;5901400/598933947;11504115/399289298");
    const Scalar k7 = traits::constant(16.474460900704823, 16.47446f,
        "79530122875/598933947;225565500/199644649;-39773754800/598933947;-706203500/598933947");
    const Scalar k8 = traits::constant(0.4080831129300902, 0.4080831f,
        "81606996074311354948800/187435544049510497429929;-4833141400108286640000/187435544049510497429929;-670503431205999804000/187435544049510497429929;1175234291156953584000/187435544049510497429929");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k10 = traits::constant(2.4504812091337693, 2.4504812f,
        "554831044729/239573578800;217036829/1597157192;1090130053/95829431520;-252043749/7985785960");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k12 = traits::constant(57.244853140274905, 57.244854f,
        "2729353520000/52676627161;-342376000000/52676627161;-189457160000/158029881483;359131200000/52676627161");
    const Scalar n0_0003 = traits::constant(3e-04, 3e-04f, "3/10000");
    const Scalar k14 = traits::constant(0.11155394517270574, 0.111553945f, "1/10;1/80;0;-1/400");
    const Scalar k15 = traits::constant(8.96427283187357, 8.9642725f,
        "1544000/148921;-194500/148921;-20000/148921;41100/148921");
    const Scalar k16 = traits::constant(0.017468819381011653, 0.01746882f, "447/20000;3/1000;-41/40000;-3/1000");
    const Scalar k17 = traits::constant(0.00010814652780161257, 0.00010814653f, "0;3/80000;0;9/400000");
    const Scalar k18 = traits::constant(0.0002897777478867205, 0.00028977776f, "0;3/40000;0;3/40000");
    const Scalar k19 = traits::constant(0.00011196152422706632, 0.000111961526f, "3/50000;0;3/100000;0");
    const Scalar p_d = parameters.d;
    const Scalar z0 = k0 * p_d;
    const Scalar z1 = k1 * p_d + k2 * z0;
    const Scalar z2 = k2 * p_d - k1 * z0;
    const Scalar z3 = n0_1 - z2;
    const Scalar z4 = k2 * z1 - k1 * z2;
    const Scalar z5 = z3 - k1 * z4;
    const Scalar z6 = k4 * z5;
    const Scalar z7 = k5 * z4 - k1 * z6;
    const Scalar z8 = z3 * z6 + z4 * z7;
    const Scalar z9 = k6 + k7 * p_d;
    const Scalar z10 = k8 * z9;
    const Scalar z11 = z8 - z9 * z10;
    const Scalar z12 = n1 / z11;
    const Scalar z13 = k10 + z8;
    const Scalar z14 = n1 / z4;
    const Scalar z15 = n0_02 * z14;
    const Scalar z16 = z4 * z4;
    const Scalar z17 = k12 * z3 * z3 + k5 * z4 * z4;
    const Scalar z18 = n0_0003 * z17;
    const Scalar z19 = k14 - z3 * z15;
    const Scalar z20 = k15 * z19;
    const Scalar z21 = z3 * z14;
    const Scalar z22 = k16 - k17 / p_d;
    const Scalar z23 = k18 - k19 / p_d;
    const Scalar z24 = n0_02 * z20;
    const Scalar z25 = z22 + z20 * z24 - z21 * z23;
    const Scalar z26 = n1 / z25;
    const Scalar z27 = z20 * z26;
    precomputed.m_46683f43 = z0;
    precomputed.m_852b2189 = z1;
    precomputed.m_d9a89de0 = z3;
    precomputed.m_6536f1f6 = z4;
    precomputed.m_86e17fa2 = z6;
    precomputed.m_ea2508da = z7;
    precomputed.m_a117cb70 = z10;
    precomputed.m_30009293 = z11;
    precomputed.m_1f0a45e1 = z12;
    precomputed.m_778397ee = z13;
    precomputed.m_ede56c5d = z14;
    precomputed.m_414ab9fb = z15;
    precomputed.m_0f787c15 = z16;
    precomputed.m_6b92ce98 = z18;
    precomputed.m_152fd5e6 = z20;
    precomputed.m_efa9d5f5 = z21;
    precomputed.m_9fc44db5 = z23;
    precomputed.m_97a82f3a = z24;
    precomputed.m_01924d0c = z25;
    precomputed.m_64965342 = z26;
    precomputed.m_c2186257 = z27;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar k2 = traits::constant(7.464101615137754, 7.464102f, "4;0;2;0");
    const Scalar k3 = traits::constant(1.3382048664584603, 1.3382049f,
        "121120/148921;-10628/148921;60160/148921;-4492/148921");
    const Scalar p_d = parameters.d;
    state.time = n0;
    state.q.alpha = n0;
    state.q.beta = n0;
    state.q.gamma = n0;
    state.v.alpha = n20;
    state.v.beta = -k2 / p_d;
    state.v.gamma = n20 - k3 / p_d;
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
    std::array<Scalar, 3> A_position;  ///< position of A [m]
    std::array<Scalar, 3> A_velocity;  ///< velocity of the material point at A [m/s]
    std::array<Scalar, 9> A_jacobian;  ///< partial velocities of A (3 x 3)
    std::array<Scalar, 3> E_position;  ///< position of E [m]
    std::array<Scalar, 3> E_velocity;  ///< velocity of the material point at E [m/s]
    std::array<Scalar, 9> E_jacobian;  ///< partial velocities of E (3 x 3)
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
    std::array<Scalar, 4> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 4> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 12> jacobian;  ///< A, stored column by column (4 x 3)
    std::array<Scalar, 4> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 6> E;  ///< effect of the inputs (3 x 2)
    std::array<Scalar, 1> M_r;  ///< reduced mass matrix
    std::array<Scalar, 1> C_r;  ///< reduced damping and gyroscopic terms
    std::array<Scalar, 3> K_r;  ///< reduced stiffness (1 x 3)
    std::array<Scalar, 1> F_r;  ///< reduced right-hand side
    std::array<Scalar, 2> E_r;  ///< reduced effect of the inputs (1 x 2)
    std::array<Scalar, 16> A;  ///< state matrix of x = (e, w): x' = A x + B du (4 x 4)
    std::array<Scalar, 8> B;  ///< input matrix (4 x 2)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 3;
  static constexpr int independent_coordinates[3] = {0, 1, 2};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 1;
  static constexpr int independent_velocities[1] = {0};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar k0 = traits::constant(0.25881904510252074, 0.25881904f, "0;-1/4;0;1/4");
    const Scalar k1 = traits::constant(0.9659258262890683, 0.9659258f, "0;1/4;0;1/4");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_03 = traits::constant(0.03, 0.03f, "3/100");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k8 = traits::constant(0.0579555495773441, 0.05795555f, "0;3/200;0;3/200");
    const Scalar k9 = traits::constant(0.034154155690722464, 0.034154154f, "0;1/400;0;1/80");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_d = precomputed.parameters.d;
    const Scalar m0 = precomputed.m_46683f43;
    const Scalar m1 = precomputed.m_852b2189;
    const Scalar angles_[] = {q_alpha, q_beta, q_gamma};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar z0 = k0 * v_alpha;
    const Scalar z1 = k1 * c_alpha;
    const Scalar z2 = k1 * s_alpha;
    const Scalar z3 = n0_1 * v_alpha;
    const Scalar z4 = k1 * v_alpha;
    const Scalar z5 = k0 * c_alpha;
    const Scalar z6 = s_beta * z0;
    const Scalar z7 = k0 * s_alpha;
    const Scalar z8 = s_alpha * z3;  // velocity of inclined, y
    const Scalar z9 = c_alpha * z3;  // velocity of inclined, z
    const Scalar z10 = c_beta * z0;
    const Scalar z11 = z4 * m0 - z0 * p_d;
    const Scalar z12 = n0_02 * z4 - n0_03 * z0;
    const Scalar z13 = n0_1 * c_alpha;
    const Scalar z14 = n0_1 * s_alpha;
    const Scalar z15 = k0 * c_beta;
    const Scalar z16 = k0 * s_beta;
    const Scalar z17 = v_alpha + k1 * v_beta;  // angular velocity of S2, x
    const Scalar z18 = s_alpha * s_beta - c_beta * z1;
    const Scalar z19 = s_alpha * c_beta + s_beta * z1;
    const Scalar z20 = c_alpha * s_beta + c_beta * z2;
    const Scalar z21 = c_alpha * c_beta - s_beta * z2;
    const Scalar z22 = v_beta * z5;  // angular velocity of S2, y
    const Scalar z23 = v_beta * z7;  // angular velocity of S2, z
    const Scalar z24 = n0_06 * z5;
    const Scalar z25 = n0_06 * z7;
    const Scalar z26 = n0_06 * z6;
    const Scalar z27 = n0_06 * z10;
    const Scalar z28 = z5 * p_d - z1 * m0;
    const Scalar z29 = z7 * p_d - z2 * m0;
    const Scalar z30 = s_alpha * z11 + z8;
    const Scalar z31 = c_alpha * z11 + z9;
    const Scalar z32 = n0_03 * z5 - n0_02 * z1;
    const Scalar z33 = n0_03 * z7 - n0_02 * z2;
    const Scalar z34 = s_alpha * z12 + z8;
    const Scalar z35 = c_alpha * z12 + z9;
    const Scalar z36 = z13 - z24;
    const Scalar z37 = z14 - z25;
    const Scalar z38 = z8 - z18 * z26 - z19 * z27;
    const Scalar z39 = z9 - z20 * z26 - z21 * z27;
    const Scalar z40 = z13 - z28;
    const Scalar z41 = z14 - z29;
    const Scalar z42 = z13 - z32;
    const Scalar z43 = z14 - z33;
    result.S1_position[0] = n0;
    result.S1_position[1] = n0;
    result.S1_position[2] = n0;
    result.S1_rotation[0] = n1;
    result.S1_rotation[1] = n0;
    result.S1_rotation[2] = n0;
    result.S1_rotation[3] = n0;
    result.S1_rotation[4] = c_alpha;
    result.S1_rotation[5] = s_alpha;
    result.S1_rotation[6] = n0;
    result.S1_rotation[7] = -s_alpha;
    result.S1_rotation[8] = c_alpha;
    result.S1_velocity[0] = n0;
    result.S1_velocity[1] = n0;
    result.S1_velocity[2] = n0;
    result.S1_angular_velocity[0] = v_alpha;
    result.S1_angular_velocity[1] = n0;
    result.S1_angular_velocity[2] = n0;
    result.S2_position[0] = -k8;
    result.S2_position[1] = z36;
    result.S2_position[2] = z37;
    result.S2_rotation[0] = k1;
    result.S2_rotation[1] = z5;
    result.S2_rotation[2] = z7;
    result.S2_rotation[3] = -z15;
    result.S2_rotation[4] = -z18;
    result.S2_rotation[5] = z20;
    result.S2_rotation[6] = z16;
    result.S2_rotation[7] = -z19;
    result.S2_rotation[8] = z21;
    result.S2_velocity[0] = n0;
    result.S2_velocity[1] = -z38;
    result.S2_velocity[2] = z39;
    result.S2_angular_velocity[0] = z17;
    result.S2_angular_velocity[1] = z22;
    result.S2_angular_velocity[2] = z23;
    result.S3_position[0] = n0;
    result.S3_position[1] = n0;
    result.S3_position[2] = n0;
    result.S3_rotation[0] = n1;
    result.S3_rotation[1] = n0;
    result.S3_rotation[2] = n0;
    result.S3_rotation[3] = n0;
    result.S3_rotation[4] = c_gamma;
    result.S3_rotation[5] = s_gamma;
    result.S3_rotation[6] = n0;
    result.S3_rotation[7] = -s_gamma;
    result.S3_rotation[8] = c_gamma;
    result.S3_velocity[0] = n0;
    result.S3_velocity[1] = n0;
    result.S3_velocity[2] = n0;
    result.S3_angular_velocity[0] = v_gamma;
    result.S3_angular_velocity[1] = n0;
    result.S3_angular_velocity[2] = n0;
    result.A_position[0] = -m1;
    result.A_position[1] = z40;
    result.A_position[2] = z41;
    result.A_velocity[0] = n0;
    result.A_velocity[1] = -z30;
    result.A_velocity[2] = z31;
    result.A_jacobian[0] = n0;
    result.A_jacobian[3] = n0;
    result.A_jacobian[6] = n0;
    result.A_jacobian[1] = -z41;
    result.A_jacobian[4] = n0;
    result.A_jacobian[7] = n0;
    result.A_jacobian[2] = z40;
    result.A_jacobian[5] = n0;
    result.A_jacobian[8] = n0;
    result.E_position[0] = -k9;
    result.E_position[1] = z42;
    result.E_position[2] = z43;
    result.E_velocity[0] = n0;
    result.E_velocity[1] = -z34;
    result.E_velocity[2] = z35;
    result.E_jacobian[0] = n0;
    result.E_jacobian[3] = n0;
    result.E_jacobian[6] = n0;
    result.E_jacobian[1] = -z43;
    result.E_jacobian[4] = n0;
    result.E_jacobian[7] = n0;
    result.E_jacobian[2] = z42;
    result.E_jacobian[5] = n0;
    result.E_jacobian[8] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 9>& mass) noexcept {
    const Scalar k0 = traits::constant(0.017468819381011653, 0.01746882f, "447/20000;3/1000;-41/40000;-3/1000");
    const Scalar k1 = traits::constant(0.0002897777478867205, 0.00028977776f, "0;3/40000;0;3/40000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_0003 = traits::constant(3e-04, 3e-04f, "3/10000");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    mass[0] = k0;
    mass[1] = k1;
    mass[2] = n0;
    mass[3] = k1;
    mass[4] = n0_0003;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0_02;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n98_1 = traits::constant(98.1, 98.1f, "981/10");
    const Scalar n0_006 = traits::constant(0.006, 0.006f, "3/500");
    const Scalar k2 = traits::constant(0.25881904510252074, 0.25881904f, "0;-1/4;0;1/4");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    Scalar s_alpha, c_alpha;
    traits::sincos(q_alpha, s_alpha, c_alpha);
    const Scalar z0 = n98_1 * s_alpha;
    const Scalar z1 = n0_006 * z0;  // moment on inclined, y
    const Scalar z2 = k2 * z1;
    const Scalar z3 = n0_01 * z0 - z2;  // moment on S1, x
    forces.alpha = -z3;
    forces.beta = n0;
    forces.gamma = n0;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n98_1 = traits::constant(98.1, 98.1f, "981/10");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.0002897777478867205, 0.00028977776f, "0;3/40000;0;3/40000");
    const Scalar n0_0003 = traits::constant(3e-04, 3e-04f, "3/10000");
    const Scalar n0_006 = traits::constant(0.006, 0.006f, "3/500");
    const Scalar k5 = traits::constant(0.25881904510252074, 0.25881904f, "0;-1/4;0;1/4");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar k7 = traits::constant(0.017468819381011653, 0.01746882f, "447/20000;3/1000;-41/40000;-3/1000");
    const Scalar k8 = traits::constant(0.11155394517270574, 0.111553945f, "1/10;1/80;0;-1/400");
    const Scalar q_alpha = state.q.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar a_beta = accelerations.beta;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar l_T_A = multipliers.T_A;
    const Scalar l_T_E = multipliers.T_E;
    const Scalar m0 = precomputed.m_d9a89de0;
    const Scalar m1 = precomputed.m_6536f1f6;
    Scalar s_alpha, c_alpha;
    traits::sincos(q_alpha, s_alpha, c_alpha);
    const Scalar z0 = n98_1 * s_alpha;
    const Scalar z1 = n0_02 * a_gamma;  // moment on S3, x
    const Scalar z2 = k2 * a_alpha + n0_0003 * a_beta;
    const Scalar z3 = n0_006 * z0;  // moment on inclined, y
    const Scalar z4 = k5 * z3;
    const Scalar z5 = n0_01 * z0 - z4;  // moment on S1, x
    const Scalar z6 = k7 * a_alpha - z5 + k2 * a_beta;
    forces.alpha = z6 - m0 * l_T_A - k8 * l_T_E;
    forces.beta = z2 - m1 * l_T_A - n0_02 * l_T_E;
    forces.gamma = z1 + k8 * l_T_E;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs& inputs, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n98_1 = traits::constant(98.1, 98.1f, "981/10");
    const Scalar n50 = traits::constant(50.0, 50.0f, "50/1");
    const Scalar n0_006 = traits::constant(0.006, 0.006f, "3/500");
    const Scalar k3 = traits::constant(0.25881904510252074, 0.25881904f, "0;-1/4;0;1/4");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar k5 = traits::constant(5.365982994617848, 5.365983f,
        "961276000/199644649;-45929425/199644649;59014000/598933947;57520575/199644649");
    const Scalar k6 = traits::constant(5.577697258635287, 5.5776973f, "5;5/8;0;-1/8");
    const Scalar k7 = traits::constant(58.17702669501042, 58.177025f,
        "10423180000/199644649;-1286500000/199644649;-606230000/598933947;1372100000/199644649");
    const Scalar k8 = traits::constant(0.9659258262890683, 0.9659258f, "0;1/4;0;1/4");
    const Scalar k9 = traits::constant(0.4080831129300902, 0.4080831f,
        "81606996074311354948800/187435544049510497429929;-4833141400108286640000/187435544049510497429929;-670503431205999804000/187435544049510497429929;1175234291156953584000/187435544049510497429929");
    const Scalar k10 = traits::constant(61.48352510873733, 61.483524f,
        "39738981350/598933947;-255072500/199644649;-5795575/199644649;-735710500/598933947");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar u_C1 = inputs.C1;
    const Scalar u_C3 = inputs.C3;
    const Scalar m0 = precomputed.m_d9a89de0;
    const Scalar m1 = precomputed.m_6536f1f6;
    const Scalar m2 = precomputed.m_86e17fa2;
    const Scalar m3 = precomputed.m_ea2508da;
    const Scalar m4 = precomputed.m_a117cb70;
    const Scalar m5 = precomputed.m_30009293;
    const Scalar m6 = precomputed.m_1f0a45e1;
    const Scalar m7 = precomputed.m_778397ee;
    Scalar s_alpha, c_alpha;
    traits::sincos(q_alpha, s_alpha, c_alpha);
    const Scalar z0 = n98_1 * s_alpha;
    const Scalar z1 = n50 * u_C3;
    const Scalar z2 = n0_006 * z0;  // moment on inclined, y
    const Scalar z3 = k3 * z2;
    const Scalar z4 = n0_01 * z0 - z3;  // moment on S1, x
    const Scalar z5 = u_C1 + z4;
    const Scalar z6 = k5 * (u_C1 + z4) - k6 * u_C3;
    const Scalar z7 = k7 * z5;
    const Scalar z8 = k8 * z7;
    const Scalar z9 = m0 * z7 - m1 * z8;
    const Scalar z10 = m4 * z6 - z9;
    const Scalar z11 = m6 * z10;
    const Scalar z12 = k9 * z6 + m4 * z11;
    const Scalar z13 = m2 * z11 + z7 - k5 * z12;
    const Scalar z14 = m3 * z11 - z8 - k10 * z12;
    const Scalar z15 = z1 + k6 * z12;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.alpha = z13;
    accelerations.beta = z14;
    accelerations.gamma = z15;
    multipliers.lambda_rolling_A_x = n0;
    multipliers.T_A = z11;
    multipliers.lambda_rolling_E_x = n0;
    multipliers.T_E = -z12;
    const Scalar bound0_ = roundings_ * m7;
    if (!(traits::regular(m5, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.alpha * accelerations.beta * accelerations.gamma * multipliers.T_A
        * multipliers.T_E;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar k0 = traits::constant(0.25881904510252074, 0.25881904f, "0;-1/4;0;1/4");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k2 = traits::constant(0.9659258262890683, 0.9659258f, "0;1/4;0;1/4");
    const Scalar k3 = traits::constant(0.015529142706151246, 0.015529143f, "0;-3/200;0;3/200");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n0_0044 = traits::constant(0.0044, 0.0044f, "11/2500");
    const Scalar n0_005 = traits::constant(0.005, 0.005f, "1/200");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar k8 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar v_gamma = state.v.gamma;
    const Scalar u_C1 = inputs.C1;
    const Scalar u_C3 = inputs.C3;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = k0 * v_alpha;
    const Scalar z1 = n0_1 * v_alpha;
    const Scalar z2 = k2 * v_alpha;
    const Scalar z3 = n0_1 * c_alpha;
    const Scalar z4 = k3 * c_alpha;
    const Scalar z5 = c_beta * z0;
    const Scalar z6 = s_beta * z0;
    const Scalar z7 = s_beta * z1;
    const Scalar z8 = c_beta * z1;
    const Scalar z9 = v_beta + z2;  // angular velocity of S2, x
    const Scalar z10 = n0_06 * z6 - z7;
    const Scalar z11 = n0_06 * z5 - z8;
    const Scalar z12 = n0_0044 * z5 - n0_06 * z8;
    const Scalar z13 = n0_0044 * z6 - n0_06 * z7;
    result.kinetic = n0_005 * v_alpha * v_alpha + n0_01 * v_gamma * v_gamma + k8 * z9 * z9 + n0_5 * (z5 * z12 + z6 * z13
        - z7 * z10 - z8 * z11);
    result.force_function = -n9_81 * (z3 - z4);
    result.power = v_alpha * u_C1 + v_gamma * u_C3;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k1 = traits::constant(0.11155394517270574, 0.111553945f, "1/10;1/80;0;-1/400");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_alpha = state.v.alpha;
    const Scalar v_beta = state.v.beta;
    const Scalar v_gamma = state.v.gamma;
    const Scalar m0 = precomputed.m_d9a89de0;
    const Scalar m1 = precomputed.m_6536f1f6;
    const Scalar z0 = v_alpha * m0 + v_beta * m1;
    const Scalar z1 = n0_02 * v_beta + k1 * (v_alpha - v_gamma);
    result.value[0] = n0;
    result.rate[0] = n0;
    result.gamma[0] = n0;
    result.value[1] = n0;
    result.rate[1] = z0;
    result.gamma[1] = n0;
    result.value[2] = n0;
    result.rate[2] = n0;
    result.gamma[2] = n0;
    result.value[3] = n0;
    result.rate[3] = z1;
    result.gamma[3] = n0;
    result.jacobian[0] = n0;
    result.jacobian[1] = m0;
    result.jacobian[2] = n0;
    result.jacobian[3] = k1;
    result.jacobian[4] = n0;
    result.jacobian[5] = m1;
    result.jacobian[6] = n0;
    result.jacobian[7] = n0_02;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = n0;
    result.jacobian[11] = -k1;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of alpha, beta, gamma,
  /// w those of the rates of alpha;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs& inputs,
      Linearisation& result) noexcept {
    const Scalar n98_1 = traits::constant(98.1, 98.1f, "981/10");
    const Scalar k1 = traits::constant(0.0002897777478867205, 0.00028977776f, "0;3/40000;0;3/40000");
    const Scalar n0_0003 = traits::constant(3e-04, 3e-04f, "3/10000");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k4 = traits::constant(0.11155394517270574, 0.111553945f, "1/10;1/80;0;-1/400");
    const Scalar k5 = traits::constant(8.96427283187357, 8.9642725f,
        "1544000/148921;-194500/148921;-20000/148921;41100/148921");
    const Scalar n0_006 = traits::constant(0.006, 0.006f, "3/500");
    const Scalar k7 = traits::constant(0.25881904510252074, 0.25881904f, "0;-1/4;0;1/4");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar k9 = traits::constant(0.017468819381011653, 0.01746882f, "447/20000;3/1000;-41/40000;-3/1000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_alpha = state.q.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar a_beta = accelerations.beta;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar u_C1 = inputs.C1;
    const Scalar u_C3 = inputs.C3;
    const Scalar l_T_A = multipliers.T_A;
    const Scalar l_T_E = multipliers.T_E;
    const Scalar m0 = precomputed.m_d9a89de0;
    const Scalar m1 = precomputed.m_6536f1f6;
    const Scalar m2 = precomputed.m_ede56c5d;
    const Scalar m3 = precomputed.m_414ab9fb;
    const Scalar m4 = precomputed.m_0f787c15;
    const Scalar m5 = precomputed.m_6b92ce98;
    const Scalar m6 = precomputed.m_152fd5e6;
    const Scalar m7 = precomputed.m_efa9d5f5;
    const Scalar m8 = precomputed.m_9fc44db5;
    const Scalar m9 = precomputed.m_97a82f3a;
    const Scalar m10 = precomputed.m_01924d0c;
    const Scalar m11 = precomputed.m_64965342;
    const Scalar m12 = precomputed.m_c2186257;
    Scalar s_alpha, c_alpha;
    traits::sincos(q_alpha, s_alpha, c_alpha);
    const Scalar z0 = n98_1 * s_alpha;
    const Scalar z1 = k1 * a_alpha + n0_0003 * a_beta;
    const Scalar z2 = n0_02 * a_gamma;  // moment on S3, x
    const Scalar z3 = a_alpha * m0 + a_beta * m1;
    const Scalar z4 = n0_02 * a_beta + k4 * (a_alpha - a_gamma);
    const Scalar z5 = u_C3 - k4 * l_T_E - z2;
    const Scalar z6 = n98_1 * c_alpha;
    const Scalar z7 = z3 * m3 - z4;
    const Scalar z8 = z3 * m2;
    const Scalar z9 = m1 * l_T_A - z1 + n0_02 * l_T_E;
    const Scalar z10 = k5 * z7;
    const Scalar z11 = z8 * m8 + z10 * m9;
    const Scalar z12 = n0_006 * z0;  // moment on inclined, y
    const Scalar z13 = n0_006 * z6;
    const Scalar z14 = k7 * z12;
    const Scalar z15 = k7 * z13;
    const Scalar z16 = n0_01 * z0 - z14;  // moment on S1, x
    const Scalar z17 = n0_01 * z6 - z15;
    const Scalar z18 = k9 * a_alpha - z16 + k1 * a_beta;
    const Scalar z19 = z17 * m11;
    const Scalar z20 = m0 * l_T_A + u_C1 + k4 * l_T_E + m6 * z5 - m7 * z9 - z18;
    const Scalar z21 = z20 + z11;
    result.M[0] = k9;
    result.M[1] = k1;
    result.M[2] = n0;
    result.M[3] = k1;
    result.M[4] = n0_0003;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = n0_02;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = n0;
    result.C[8] = n0;
    result.K[0] = -z17;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.F[0] = m0 * l_T_A + u_C1 + k4 * l_T_E - z18;
    result.F[1] = m1 * l_T_A - z1 + n0_02 * l_T_E;
    result.F[2] = u_C3 - k4 * l_T_E - z2;
    result.E[0] = n1;
    result.E[1] = n0;
    result.E[2] = n0;
    result.E[3] = n0;
    result.E[4] = n0;
    result.E[5] = n1;
    result.M_r[0] = m10;
    result.C_r[0] = n0;
    result.K_r[0] = -z17;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.F_r[0] = z21;
    result.E_r[0] = n1;
    result.E_r[1] = m6;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = z19;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = n1;
    result.A[13] = -m7;
    result.A[14] = m6;
    result.A[15] = n0;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = m11;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = m12;
    if (!(traits::regular(m4, m5) && traits::regular(m10, m10))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.K[0] * result.F[0] * result.F[1] * result.F[2] * result.M_r[0] * result.K_r[0]
        * result.F_r[0] * result.E_r[1] * result.A[3] * result.A[13] * result.A[14] * result.B[3] * result.B[7];
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 9>&>(mass_matrix));
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

}  // namespace graham_variator
