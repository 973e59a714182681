// SPDX-License-Identifier: MIT-0
// helicopter_on_a_circle: Rotor of a helicopter that goes round a circle
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, reactions, linearisation
// Parameters set at run time: theta, omega, alpha
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                4               12          1             0                  2       0     21       -
//   kinematics               56               81          0             0                  2       0    141     168
//   mass_matrix               0                0          0             0                  0       0      0       8
//   bias                      0                0          0             0                  0       0      0       0
//   inverse_dynamics          0                1          0             0                  0       0      1       9
//   forward_dynamics          0                1          0             0                  0       0      1      10
//   energy                   13               23          0             0                  1       0     38      53
//   reactions                35               50          0             0                  1       0     87     115
//   linearisation             1                1          0             0                  0       0      2      11
//
// Not computed because this mechanism does not need it:
//   kinematics: of 153 results 13 vanish identically, 80 repeat another up to sign
//   bias: of 1 results 1 vanish identically
//   energy: of 3 results 1 vanish identically
//   first_integrals: left out, 'C' has no force function
//   constraints: left out, the scene has no constraints
//   reactions: of 6 results 3 vanish identically
//   linearisation: of 11 results 6 vanish identically
//
// To write this file again:
//   helicopter_on_a_circle_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output helicopter_on_a_circle.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace helicopter_on_a_circle {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 1> coordinates{{{"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> velocities{{{"phi", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> inputs{{{"C", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 3> parameters{{{"theta", "rad"}, {"omega", "rad/s"},
      {"alpha", "rad"}}};
  static constexpr std::array<torsor::ResultDescription, 56> results{{{"result", "span_1_position", 3, 1, 1, "m"},
      {"result", "span_1_rotation", 3, 3, 2, "1"}, {"result", "span_1_velocity", 3, 1, 1, "m/s"}, {"result",
      "span_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "blade_1_position", 3, 1, 1, "m"}, {"result",
      "blade_1_rotation", 3, 3, 2, "1"}, {"result", "blade_1_velocity", 3, 1, 1, "m/s"}, {"result",
      "blade_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "span_2_position", 3, 1, 1, "m"}, {"result",
      "span_2_rotation", 3, 3, 2, "1"}, {"result", "span_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "span_2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "blade_2_position", 3, 1, 1, "m"}, {"result",
      "blade_2_rotation", 3, 3, 2, "1"}, {"result", "blade_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "blade_2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "span_3_position", 3, 1, 1, "m"}, {"result",
      "span_3_rotation", 3, 3, 2, "1"}, {"result", "span_3_velocity", 3, 1, 1, "m/s"}, {"result",
      "span_3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "blade_3_position", 3, 1, 1, "m"}, {"result",
      "blade_3_rotation", 3, 3, 2, "1"}, {"result", "blade_3_velocity", 3, 1, 1, "m/s"}, {"result",
      "blade_3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "span_4_position", 3, 1, 1, "m"}, {"result",
      "span_4_rotation", 3, 3, 2, "1"}, {"result", "span_4_velocity", 3, 1, 1, "m/s"}, {"result",
      "span_4_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "blade_4_position", 3, 1, 1, "m"}, {"result",
      "blade_4_rotation", 3, 3, 2, "1"}, {"result", "blade_4_velocity", 3, 1, 1, "m/s"}, {"result",
      "blade_4_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "A_position", 3, 1, 1, "m"}, {"result", "A_velocity", 3,
      1, 1, "m/s"}, {"result", "A_jacobian", 3, 1, 2, ""}, {"mass", "", 1, 1, 2, "kg m^2"}, {"forces", "", 1, 1, 1, ""},
      {"forces", "", 1, 1, 1, "N m"}, {"accelerations", "", 1, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1, ""},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "X", 1, 1, 0, "N"}, {"result", "Y", 1, 1, 0, "N"}, {"result", "Z", 1, 1, 0, "N"}, {"result",
      "M_x", 1, 1, 0, "N m"}, {"result", "M_y", 1, 1, 0, "N m"}, {"result", "M_z", 1, 1, 0, "N m"}, {"result", "M", 1,
      1, 2, "kg m^2"}, {"result", "C", 1, 1, 2, ""}, {"result", "K", 1, 1, 2, ""}, {"result", "F", 1, 1, 1, "N m"},
      {"result", "E", 1, 1, 2, "1"}, {"result", "A", 2, 2, 2, "1"}, {"result", "B", 2, 1, 2, "1/kg/m^2"}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 35}, {"mass_matrix", false, false, false, false, results.data() + 35, 1}, {"bias", false,
      false, false, false, results.data() + 36, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 37,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 38, 2}, {"energy", false, false, true, false,
      results.data() + 40, 3}, {"reactions", true, true, true, false, results.data() + 43, 6}, {"linearisation", true,
      true, true, true, results.data() + 49, 7}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::helicopter_on_a_circle::Description;

  static constexpr const char* name = "helicopter_on_a_circle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe0adb1c13b335e34ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 1;
  static constexpr int velocity_count = 1;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 3;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar theta;  ///< parameter [rad]
    Scalar omega;  ///< parameter [rad/s]
    Scalar alpha;  ///< parameter [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::theta, &Parameters::omega, &Parameters::alpha};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::phi};
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
    Scalar m_282b6380;
    Scalar m_b1b5ea6b;
    Scalar m_7b59dd2d;
    Scalar m_e1bdef79;
    Scalar m_b30b430b;
    Scalar m_9d2b0082;
    Scalar m_83f08dc3;
    Scalar m_d520cb19;
    Scalar m_2ab9571c;
    Scalar m_b7112841;
    Scalar m_d19d4ca7;
    Scalar m_2c52f31d;  ///< force on upwards, x
    Scalar m_1454edca;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    parameters.theta = n0_3;
    parameters.omega = n0_2;
    parameters.alpha = n0_2;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n120 = traits::constant(120.0, 120.0f, "120/1");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar p_omega = parameters.omega;
    const Scalar p_theta = parameters.theta;
    const Scalar p_alpha = parameters.alpha;
    const Scalar angles_[] = {p_theta, p_alpha};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_alpha = sines_[1], c_alpha = cosines_[1];
    const Scalar z0 = n100 * p_omega;
    const Scalar z1 = p_omega * s_theta;
    const Scalar z2 = p_omega * c_theta;
    const Scalar z3 = c_theta * s_alpha;
    const Scalar z4 = c_theta * c_alpha;
    const Scalar z5 = n0_4 * c_alpha;
    const Scalar z6 = c_alpha * z5;
    const Scalar z7 = n1330 + z6;
    const Scalar z8 = z6 + z7;
    const Scalar z9 = z6 + z8;
    const Scalar z10 = z6 + z9;
    const Scalar z11 = n1 / z10;
    const Scalar z12 = p_omega * p_omega;
    const Scalar z13 = n100 * z12;
    const Scalar z14 = z1 * z2;
    const Scalar z15 = n120 * z13;  // force on upwards, x
    const Scalar z16 = n665 * z14;
    precomputed.m_282b6380 = s_theta;
    precomputed.m_b1b5ea6b = c_theta;
    precomputed.m_7b59dd2d = s_alpha;
    precomputed.m_e1bdef79 = c_alpha;
    precomputed.m_b30b430b = z0;
    precomputed.m_9d2b0082 = z1;
    precomputed.m_83f08dc3 = z2;
    precomputed.m_d520cb19 = z3;
    precomputed.m_2ab9571c = z4;
    precomputed.m_b7112841 = z10;
    precomputed.m_d19d4ca7 = z11;
    precomputed.m_2c52f31d = z15;
    precomputed.m_1454edca = z16;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    state.time = n0;
    state.q.phi = n0;
    state.v.phi = n30;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> span_1_position;  ///< centre of mass of span_1 [m]
    std::array<Scalar, 9> span_1_rotation;  ///< from the axes of span_1 to the ground's (3 x 3)
    std::array<Scalar, 3> span_1_velocity;  ///< velocity of the centre of mass of span_1 [m/s]
    std::array<Scalar, 3> span_1_angular_velocity;  ///< angular velocity of span_1 [rad/s]
    std::array<Scalar, 3> blade_1_position;  ///< centre of mass of blade_1 [m]
    std::array<Scalar, 9> blade_1_rotation;  ///< from the axes of blade_1 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_1_velocity;  ///< velocity of the centre of mass of blade_1 [m/s]
    std::array<Scalar, 3> blade_1_angular_velocity;  ///< angular velocity of blade_1 [rad/s]
    std::array<Scalar, 3> span_2_position;  ///< centre of mass of span_2 [m]
    std::array<Scalar, 9> span_2_rotation;  ///< from the axes of span_2 to the ground's (3 x 3)
    std::array<Scalar, 3> span_2_velocity;  ///< velocity of the centre of mass of span_2 [m/s]
    std::array<Scalar, 3> span_2_angular_velocity;  ///< angular velocity of span_2 [rad/s]
    std::array<Scalar, 3> blade_2_position;  ///< centre of mass of blade_2 [m]
    std::array<Scalar, 9> blade_2_rotation;  ///< from the axes of blade_2 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_2_velocity;  ///< velocity of the centre of mass of blade_2 [m/s]
    std::array<Scalar, 3> blade_2_angular_velocity;  ///< angular velocity of blade_2 [rad/s]
    std::array<Scalar, 3> span_3_position;  ///< centre of mass of span_3 [m]
    std::array<Scalar, 9> span_3_rotation;  ///< from the axes of span_3 to the ground's (3 x 3)
    std::array<Scalar, 3> span_3_velocity;  ///< velocity of the centre of mass of span_3 [m/s]
    std::array<Scalar, 3> span_3_angular_velocity;  ///< angular velocity of span_3 [rad/s]
    std::array<Scalar, 3> blade_3_position;  ///< centre of mass of blade_3 [m]
    std::array<Scalar, 9> blade_3_rotation;  ///< from the axes of blade_3 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_3_velocity;  ///< velocity of the centre of mass of blade_3 [m/s]
    std::array<Scalar, 3> blade_3_angular_velocity;  ///< angular velocity of blade_3 [rad/s]
    std::array<Scalar, 3> span_4_position;  ///< centre of mass of span_4 [m]
    std::array<Scalar, 9> span_4_rotation;  ///< from the axes of span_4 to the ground's (3 x 3)
    std::array<Scalar, 3> span_4_velocity;  ///< velocity of the centre of mass of span_4 [m/s]
    std::array<Scalar, 3> span_4_angular_velocity;  ///< angular velocity of span_4 [rad/s]
    std::array<Scalar, 3> blade_4_position;  ///< centre of mass of blade_4 [m]
    std::array<Scalar, 9> blade_4_rotation;  ///< from the axes of blade_4 to the ground's (3 x 3)
    std::array<Scalar, 3> blade_4_velocity;  ///< velocity of the centre of mass of blade_4 [m/s]
    std::array<Scalar, 3> blade_4_angular_velocity;  ///< angular velocity of blade_4 [rad/s]
    std::array<Scalar, 3> A_position;  ///< position of A [m]
    std::array<Scalar, 3> A_velocity;  ///< velocity of the material point at A [m/s]
    std::array<Scalar, 3> A_jacobian;  ///< partial velocities of A
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
    Scalar X;  ///< reaction along 'X' [N]
    Scalar Y;  ///< reaction along 'Y' [N]
    Scalar Z;  ///< reaction along 'Z' [N]
    Scalar M_x;  ///< reaction along 'M_x' [N m]
    Scalar M_y;  ///< reaction along 'M_y' [N m]
    Scalar M_z;  ///< reaction along 'M_z' [N m]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::X, &Reactions::Y, &Reactions::Z, &Reactions::M_x,
          &Reactions::M_y, &Reactions::M_z};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 1> M;  ///< mass matrix
    std::array<Scalar, 1> C;  ///< damping and gyroscopic terms
    std::array<Scalar, 1> K;  ///< stiffness
    std::array<Scalar, 1> F;  ///< right-hand side
    std::array<Scalar, 1> E;  ///< effect of the inputs
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, e'): x' = A x + B du (2 x 2)
    std::array<Scalar, 2> B;  ///< input matrix
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar s_theta = precomputed.m_282b6380;
    const Scalar c_theta = precomputed.m_b1b5ea6b;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m4 = precomputed.m_b30b430b;
    const Scalar m5 = precomputed.m_9d2b0082;
    const Scalar m6 = precomputed.m_83f08dc3;
    const Scalar m7 = precomputed.m_d520cb19;
    const Scalar m8 = precomputed.m_2ab9571c;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {q_phi, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = c_theta * z1;
    const Scalar z4 = c_phi * m5;
    const Scalar z5 = s_phi * m5;
    const Scalar z6 = c_theta * z2;
    const Scalar z7 = m4 * z1;  // velocity of outwards, x
    const Scalar z8 = m4 * z2;  // velocity of outwards, y
    const Scalar z9 = s_theta * z2;
    const Scalar z10 = s_theta * z1;
    const Scalar z11 = v_phi + m6;
    const Scalar z12 = s_theta * c_phi;
    const Scalar z13 = s_theta * s_phi;
    const Scalar z14 = n3 * z11;
    const Scalar z15 = n100 * z2;
    const Scalar z16 = n100 * z1;
    const Scalar z17 = p_omega + c_theta * v_phi;  // angular velocity of rotor, z
    const Scalar z18 = c_alpha * z13 - m7;
    const Scalar z19 = s_alpha * z13 + m8;
    const Scalar z20 = c_alpha * z12 - m7;
    const Scalar z21 = s_alpha * z12 + m8;
    const Scalar z22 = c_alpha * z13 + m7;
    const Scalar z23 = s_alpha * z13 - m8;
    const Scalar z24 = c_alpha * z12 + m7;
    const Scalar z25 = s_alpha * z12 - m8;
    const Scalar z26 = n3 * z12;
    const Scalar z27 = n3 * z5;
    const Scalar z28 = n3 * z13;
    const Scalar z29 = n3 * z4;
    const Scalar z30 = s_phi * z1 - c_phi * z6;
    const Scalar z31 = c_phi * z1 + s_phi * z6;
    const Scalar z32 = s_phi * z2 + c_phi * z3;
    const Scalar z33 = s_phi * z3 - c_phi * z2;
    const Scalar z34 = v_phi * z9;  // angular velocity of rotor, x
    const Scalar z35 = v_phi * z10;  // angular velocity of rotor, y
    const Scalar z36 = s_alpha * z9;
    const Scalar z37 = c_alpha * z9;
    const Scalar z38 = s_alpha * z10;
    const Scalar z39 = c_alpha * z10;
    const Scalar z40 = c_theta * z27 - z13 * z14;
    const Scalar z41 = c_theta * z29 - z12 * z14;
    const Scalar z42 = c_alpha * z31 + z36;
    const Scalar z43 = s_alpha * z31 - z37;
    const Scalar z44 = c_alpha * z30 - z36;
    const Scalar z45 = s_alpha * z30 + z37;
    const Scalar z46 = c_alpha * z32 + z38;
    const Scalar z47 = s_alpha * z32 - z39;
    const Scalar z48 = c_alpha * z31 - z36;
    const Scalar z49 = s_alpha * z31 + z37;
    const Scalar z50 = c_alpha * z30 + z36;
    const Scalar z51 = s_alpha * z30 - z37;
    const Scalar z52 = c_alpha * z32 - z38;
    const Scalar z53 = s_alpha * z32 + z39;
    const Scalar z54 = n3 * z30;
    const Scalar z55 = n3 * z32;
    const Scalar z56 = z7 + z9 * z27 + z31 * z14;
    const Scalar z57 = n3 * z31;
    const Scalar z58 = z7 + z9 * z29 - z30 * z14;
    const Scalar z59 = z8 - z10 * z29 - z32 * z14;
    const Scalar z60 = n3 * z33;
    const Scalar z61 = c_alpha * z33 + z38;
    const Scalar z62 = s_alpha * z33 - z39;
    const Scalar z63 = c_alpha * z33 - z38;
    const Scalar z64 = s_alpha * z33 + z39;
    const Scalar z65 = z15 - z54;
    const Scalar z66 = z16 + z55;
    const Scalar z67 = z8 - z10 * z27 - z33 * z14;
    const Scalar z68 = z15 - z57;
    const Scalar z69 = z16 - z60;
    const Scalar z70 = z15 + z54;
    const Scalar z71 = z16 - z55;
    const Scalar z72 = z7 - z9 * z27 - z31 * z14;
    const Scalar z73 = z8 + z10 * z27 + z33 * z14;
    const Scalar z74 = z15 + z57;
    const Scalar z75 = z16 + z60;
    const Scalar z76 = z7 - z9 * z29 + z30 * z14;
    const Scalar z77 = z8 + z10 * z29 + z32 * z14;
    result.span_1_position[0] = z65;
    result.span_1_position[1] = z66;
    result.span_1_position[2] = z26;
    result.span_1_rotation[0] = -z30;
    result.span_1_rotation[1] = z32;
    result.span_1_rotation[2] = z12;
    result.span_1_rotation[3] = -z31;
    result.span_1_rotation[4] = -z33;
    result.span_1_rotation[5] = -z13;
    result.span_1_rotation[6] = -z9;
    result.span_1_rotation[7] = -z10;
    result.span_1_rotation[8] = c_theta;
    result.span_1_velocity[0] = -z56;
    result.span_1_velocity[1] = z67;
    result.span_1_velocity[2] = z40;
    result.span_1_angular_velocity[0] = -z34;
    result.span_1_angular_velocity[1] = -z35;
    result.span_1_angular_velocity[2] = z17;
    result.blade_1_position[0] = z15;
    result.blade_1_position[1] = z16;
    result.blade_1_position[2] = n0;
    result.blade_1_rotation[0] = -z30;
    result.blade_1_rotation[1] = z32;
    result.blade_1_rotation[2] = z12;
    result.blade_1_rotation[3] = -z42;
    result.blade_1_rotation[4] = -z61;
    result.blade_1_rotation[5] = -z18;
    result.blade_1_rotation[6] = z43;
    result.blade_1_rotation[7] = z62;
    result.blade_1_rotation[8] = z19;
    result.blade_1_velocity[0] = -z7;
    result.blade_1_velocity[1] = z8;
    result.blade_1_velocity[2] = n0;
    result.blade_1_angular_velocity[0] = -z34;
    result.blade_1_angular_velocity[1] = -z35;
    result.blade_1_angular_velocity[2] = z17;
    result.span_2_position[0] = z68;
    result.span_2_position[1] = z69;
    result.span_2_position[2] = -z28;
    result.span_2_rotation[0] = -z31;
    result.span_2_rotation[1] = -z33;
    result.span_2_rotation[2] = -z13;
    result.span_2_rotation[3] = z30;
    result.span_2_rotation[4] = -z32;
    result.span_2_rotation[5] = -z12;
    result.span_2_rotation[6] = -z9;
    result.span_2_rotation[7] = -z10;
    result.span_2_rotation[8] = c_theta;
    result.span_2_velocity[0] = -z58;
    result.span_2_velocity[1] = z59;
    result.span_2_velocity[2] = z41;
    result.span_2_angular_velocity[0] = -z34;
    result.span_2_angular_velocity[1] = -z35;
    result.span_2_angular_velocity[2] = z17;
    result.blade_2_position[0] = z15;
    result.blade_2_position[1] = z16;
    result.blade_2_position[2] = n0;
    result.blade_2_rotation[0] = -z31;
    result.blade_2_rotation[1] = -z33;
    result.blade_2_rotation[2] = -z13;
    result.blade_2_rotation[3] = z44;
    result.blade_2_rotation[4] = -z46;
    result.blade_2_rotation[5] = -z20;
    result.blade_2_rotation[6] = -z45;
    result.blade_2_rotation[7] = z47;
    result.blade_2_rotation[8] = z21;
    result.blade_2_velocity[0] = -z7;
    result.blade_2_velocity[1] = z8;
    result.blade_2_velocity[2] = n0;
    result.blade_2_angular_velocity[0] = -z34;
    result.blade_2_angular_velocity[1] = -z35;
    result.blade_2_angular_velocity[2] = z17;
    result.span_3_position[0] = z70;
    result.span_3_position[1] = z71;
    result.span_3_position[2] = -z26;
    result.span_3_rotation[0] = z30;
    result.span_3_rotation[1] = -z32;
    result.span_3_rotation[2] = -z12;
    result.span_3_rotation[3] = z31;
    result.span_3_rotation[4] = z33;
    result.span_3_rotation[5] = z13;
    result.span_3_rotation[6] = -z9;
    result.span_3_rotation[7] = -z10;
    result.span_3_rotation[8] = c_theta;
    result.span_3_velocity[0] = -z72;
    result.span_3_velocity[1] = z73;
    result.span_3_velocity[2] = -z40;
    result.span_3_angular_velocity[0] = -z34;
    result.span_3_angular_velocity[1] = -z35;
    result.span_3_angular_velocity[2] = z17;
    result.blade_3_position[0] = z15;
    result.blade_3_position[1] = z16;
    result.blade_3_position[2] = n0;
    result.blade_3_rotation[0] = z30;
    result.blade_3_rotation[1] = -z32;
    result.blade_3_rotation[2] = -z12;
    result.blade_3_rotation[3] = z48;
    result.blade_3_rotation[4] = z63;
    result.blade_3_rotation[5] = z22;
    result.blade_3_rotation[6] = -z49;
    result.blade_3_rotation[7] = -z64;
    result.blade_3_rotation[8] = -z23;
    result.blade_3_velocity[0] = -z7;
    result.blade_3_velocity[1] = z8;
    result.blade_3_velocity[2] = n0;
    result.blade_3_angular_velocity[0] = -z34;
    result.blade_3_angular_velocity[1] = -z35;
    result.blade_3_angular_velocity[2] = z17;
    result.span_4_position[0] = z74;
    result.span_4_position[1] = z75;
    result.span_4_position[2] = z28;
    result.span_4_rotation[0] = z31;
    result.span_4_rotation[1] = z33;
    result.span_4_rotation[2] = z13;
    result.span_4_rotation[3] = -z30;
    result.span_4_rotation[4] = z32;
    result.span_4_rotation[5] = z12;
    result.span_4_rotation[6] = -z9;
    result.span_4_rotation[7] = -z10;
    result.span_4_rotation[8] = c_theta;
    result.span_4_velocity[0] = -z76;
    result.span_4_velocity[1] = z77;
    result.span_4_velocity[2] = -z41;
    result.span_4_angular_velocity[0] = -z34;
    result.span_4_angular_velocity[1] = -z35;
    result.span_4_angular_velocity[2] = z17;
    result.blade_4_position[0] = z15;
    result.blade_4_position[1] = z16;
    result.blade_4_position[2] = n0;
    result.blade_4_rotation[0] = z31;
    result.blade_4_rotation[1] = z33;
    result.blade_4_rotation[2] = z13;
    result.blade_4_rotation[3] = -z50;
    result.blade_4_rotation[4] = z52;
    result.blade_4_rotation[5] = z24;
    result.blade_4_rotation[6] = z51;
    result.blade_4_rotation[7] = -z53;
    result.blade_4_rotation[8] = -z25;
    result.blade_4_velocity[0] = -z7;
    result.blade_4_velocity[1] = z8;
    result.blade_4_velocity[2] = n0;
    result.blade_4_angular_velocity[0] = -z34;
    result.blade_4_angular_velocity[1] = -z35;
    result.blade_4_angular_velocity[2] = z17;
    result.A_position[0] = z15;
    result.A_position[1] = z16;
    result.A_position[2] = n0;
    result.A_velocity[0] = -z7;
    result.A_velocity[1] = z8;
    result.A_velocity[2] = n0;
    result.A_jacobian[0] = n0;
    result.A_jacobian[1] = n0;
    result.A_jacobian[2] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State&,
      std::array<Scalar, 1>& mass) noexcept {
    const Scalar m0 = precomputed.m_b7112841;
    mass[0] = m0;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State&, GeneralizedForces& forces) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    forces.phi = n0;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State&,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar a_phi = accelerations.phi;
    const Scalar m0 = precomputed.m_b7112841;
    const Scalar z0 = a_phi * m0;
    forces.phi = z0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State&,
      const Inputs& inputs, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar u_C = inputs.C;
    const Scalar m0 = precomputed.m_b7112841;
    const Scalar m1 = precomputed.m_d19d4ca7;
    const Scalar z0 = u_C * m1;
    accelerations.phi = z0;
    if (!(traits::regular(m0, m0))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.phi;
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
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar n332_9 = traits::constant(332.9, 332.9f, "3329/10");
    const Scalar n60 = traits::constant(60.0, 60.0f, "60/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar u_C = inputs.C;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_b30b430b;
    const Scalar m3 = precomputed.m_9d2b0082;
    const Scalar m4 = precomputed.m_83f08dc3;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_phi + m4;  // angular velocity of rotor, z
    const Scalar z1 = c_phi * m3;
    const Scalar z2 = s_phi * m3;
    const Scalar z3 = s_phi * m2;
    const Scalar z4 = c_phi * m2;
    const Scalar z5 = c_alpha * z0;
    const Scalar z6 = s_alpha * z2 + z5;
    const Scalar z7 = s_alpha * z1 + z5;
    const Scalar z8 = s_alpha * z2 - z5;
    const Scalar z9 = s_alpha * z1 - z5;
    result.kinetic = n665 * z0 * z0 + n332_9 * (z1 * z1 + z2 * z2) + n60 * (z3 * z3 + z4 * z4) + n0_2 * (z6 * z6 + z7
        * z7 + z8 * z8 + z9 * z9);
    result.force_function = n0;
    result.power = v_phi * u_C;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar s_alpha = precomputed.m_7b59dd2d;
    const Scalar c_alpha = precomputed.m_e1bdef79;
    const Scalar m2 = precomputed.m_9d2b0082;
    const Scalar m3 = precomputed.m_83f08dc3;
    const Scalar m4 = precomputed.m_2c52f31d;
    const Scalar m5 = precomputed.m_1454edca;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_phi + m3;  // angular velocity of rotor, z
    const Scalar z1 = s_phi * m2;
    const Scalar z2 = c_phi * m2;
    const Scalar z3 = a_phi * c_alpha;
    const Scalar z4 = s_alpha * z0;
    const Scalar z5 = c_alpha * z0;
    const Scalar z6 = v_phi * z1;  // angular acceleration of rotor, x
    const Scalar z7 = v_phi * z2;  // angular acceleration of rotor, y
    const Scalar z8 = c_alpha * z1 - z4;
    const Scalar z9 = s_alpha * z1 + z5;
    const Scalar z10 = c_alpha * z2 - z4;
    const Scalar z11 = s_alpha * z2 + z5;
    const Scalar z12 = c_alpha * z1 + z4;
    const Scalar z13 = s_alpha * z1 - z5;
    const Scalar z14 = c_alpha * z2 + z4;
    const Scalar z15 = s_alpha * z2 - z5;
    const Scalar z16 = z1 * z0;
    const Scalar z17 = z2 * z0;
    const Scalar z18 = s_alpha * z7 + z3;
    const Scalar z19 = s_alpha * z6 - z3;
    const Scalar z20 = s_alpha * z7 - z3;
    const Scalar z21 = s_alpha * z6 + z3;
    const Scalar z22 = z14 * z15;
    const Scalar z23 = z1 * z14;
    const Scalar z24 = z12 * z13;
    const Scalar z25 = z2 * z12;
    const Scalar z26 = z10 * z11;
    const Scalar z27 = z1 * z10;
    const Scalar z28 = z8 * z9;
    const Scalar z29 = z2 * z8;
    const Scalar z30 = n0_4 * (z7 - z22);  // moment on blade_4, x
    const Scalar z31 = n0_4 * (z21 - z23);  // moment on blade_4, z
    const Scalar z32 = n0_4 * (z6 - z24);  // moment on blade_3, x
    const Scalar z33 = n0_4 * (z20 - z25);  // moment on blade_3, z
    const Scalar z34 = n0_4 * (z7 + z26);  // moment on blade_2, x
    const Scalar z35 = n0_4 * (z19 + z27);  // moment on blade_2, z
    const Scalar z36 = n0_4 * (z6 + z28);  // moment on blade_1, x
    const Scalar z37 = n0_4 * (z18 + z29);  // moment on blade_1, z
    const Scalar z38 = s_alpha * z31;
    const Scalar z39 = c_alpha * z31;
    const Scalar z40 = s_alpha * z33;
    const Scalar z41 = c_alpha * z33;
    const Scalar z42 = s_alpha * z35;
    const Scalar z43 = c_alpha * z35;
    const Scalar z44 = s_alpha * z37;
    const Scalar z45 = c_alpha * z37;
    const Scalar z46 = n1330 * z16 + z32 + z36 + z38 + z42;  // moment on rotor, x
    const Scalar z47 = n1330 * z17 + z30 + z34 + z40 + z44;  // moment on rotor, y
    const Scalar z48 = n1330 * a_phi + z39 - z41 - z43 + z45;  // moment on rotor, z
    const Scalar z49 = s_phi * z46 + c_phi * z47;
    const Scalar z50 = m5 - z49;  // moment on pitch, y
    result.X = -m4;
    result.Y = n0;
    result.Z = n0;
    result.M_x = n0;
    result.M_y = z50;
    result.M_z = z48;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Inputs& inputs, Reactions& result) noexcept {
    Mechanism::reactions(precomputed, state, accelerations, Multipliers(), inputs, result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State&,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar a_phi = accelerations.phi;
    const Scalar u_C = inputs.C;
    const Scalar m0 = precomputed.m_b7112841;
    const Scalar m1 = precomputed.m_d19d4ca7;
    const Scalar z0 = a_phi * m0;
    result.M[0] = m0;
    result.C[0] = n0;
    result.K[0] = n0;
    result.F[0] = u_C - z0;
    result.E[0] = n1;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n1;
    result.A[3] = n0;
    result.B[0] = n0;
    result.B[1] = m1;
    if (!(traits::regular(m0, m0))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.M[0] * result.F[0] * result.B[1];
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 1>&>(mass_matrix));
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

}  // namespace helicopter_on_a_circle
