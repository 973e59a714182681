// SPDX-License-Identifier: MIT-0
// helicopter_on_a_circle_pitching_blades: The helicopter's rotor with blades of variable pitch
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, reactions
// Parameters set at run time: theta, omega, alpha, alpha_c, k, c
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                0                9          0             0                  1       0     11       -
//   kinematics               68              113          0             0                  6       0    193     198
//   mass_matrix               4                8          0             0                  4       0     20      20
//   bias                     56               69          0             0                  5       0    135     160
//   inverse_dynamics         65               74          0             0                  5       0    149     174
//   forward_dynamics         61               82          1             0                  5       0    154     179
//   energy                   40               53          0             0                  5       0    103     124
//   reactions                48               65          0             0                  5       0    123     140
//
// Not computed because this mechanism does not need it:
//   kinematics: of 165 results 25 vanish identically, 68 repeat another up to sign
//   mass_matrix: of 25 results 20 vanish identically
//   reactions: of 6 results 2 vanish identically
//
// To write this file again:
//   helicopter_on_a_circle_pitching_blades_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,reactions --support torsor_support.hpp --output helicopter_on_a_circle_pitching_blades.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace helicopter_on_a_circle_pitching_blades {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 5> coordinates{{{"phi", "rad"}, {"alpha_1", "rad"},
      {"alpha_2", "rad"}, {"alpha_3", "rad"}, {"alpha_4", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 5> velocities{{{"phi", "rad/s"}, {"alpha_1", "rad/s"},
      {"alpha_2", "rad/s"}, {"alpha_3", "rad/s"}, {"alpha_4", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> inputs{{{"C", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 6> parameters{{{"theta", "rad"}, {"omega", "rad/s"},
      {"alpha", "rad"}, {"alpha_c", "rad"}, {"k", "N m"}, {"c", "N m s"}}};
  static constexpr std::array<torsor::ResultDescription, 49> results{{{"result", "span_1_position", 3, 1, 1, "m"},
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
      1, 1, "m/s"}, {"result", "A_jacobian", 3, 5, 2, ""}, {"mass", "", 5, 5, 2, "kg m^2"}, {"forces", "", 5, 1, 1,
      "N m"}, {"forces", "", 5, 1, 1, "N m"}, {"accelerations", "", 5, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1,
      ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "X", 1, 1, 0, "N"}, {"result", "Y", 1, 1, 0, "N"}, {"result", "Z", 1, 1, 0, "N"}, {"result",
      "M_x", 1, 1, 0, "N m"}, {"result", "M_y", 1, 1, 0, "N m"}, {"result", "M_z", 1, 1, 0, "N m"}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 35}, {"mass_matrix", false, false, false, false, results.data() + 35, 1}, {"bias", false,
      false, false, false, results.data() + 36, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 37,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 38, 2}, {"energy", false, false, true, false,
      results.data() + 40, 3}, {"reactions", true, true, true, false, results.data() + 43, 6}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::helicopter_on_a_circle_pitching_blades::Description;

  static constexpr const char* name = "helicopter_on_a_circle_pitching_blades";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x3adbbbf734d65cbaULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 5;
  static constexpr int velocity_count = 5;
  static constexpr int input_count = 1;
  static constexpr int parameter_count = 6;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar theta;  ///< parameter [rad]
    Scalar omega;  ///< parameter [rad/s]
    Scalar alpha;  ///< parameter [rad]
    Scalar alpha_c;  ///< parameter [rad]
    Scalar k;  ///< parameter [N m]
    Scalar c;  ///< parameter [N m s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::theta, &Parameters::omega, &Parameters::alpha,
          &Parameters::alpha_c, &Parameters::k, &Parameters::c};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar phi;  ///< coordinate [rad]
    Scalar alpha_1;  ///< coordinate [rad]
    Scalar alpha_2;  ///< coordinate [rad]
    Scalar alpha_3;  ///< coordinate [rad]
    Scalar alpha_4;  ///< coordinate [rad]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::phi, &Coordinates::alpha_1, &Coordinates::alpha_2,
          &Coordinates::alpha_3, &Coordinates::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar phi;  ///< its rate [rad/s]
    Scalar alpha_1;  ///< its rate [rad/s]
    Scalar alpha_2;  ///< its rate [rad/s]
    Scalar alpha_3;  ///< its rate [rad/s]
    Scalar alpha_4;  ///< its rate [rad/s]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::phi, &Velocities::alpha_1, &Velocities::alpha_2,
          &Velocities::alpha_3, &Velocities::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar phi;  ///< its second rate [rad/s^2]
    Scalar alpha_1;  ///< its second rate [rad/s^2]
    Scalar alpha_2;  ///< its second rate [rad/s^2]
    Scalar alpha_3;  ///< its second rate [rad/s^2]
    Scalar alpha_4;  ///< its second rate [rad/s^2]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::phi, &Accelerations::alpha_1,
          &Accelerations::alpha_2, &Accelerations::alpha_3, &Accelerations::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar phi;  ///< works with the rate of phi [N m]
    Scalar alpha_1;  ///< works with the rate of alpha_1 [N m]
    Scalar alpha_2;  ///< works with the rate of alpha_2 [N m]
    Scalar alpha_3;  ///< works with the rate of alpha_3 [N m]
    Scalar alpha_4;  ///< works with the rate of alpha_4 [N m]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::phi, &GeneralizedForces::alpha_1,
          &GeneralizedForces::alpha_2, &GeneralizedForces::alpha_3, &GeneralizedForces::alpha_4};
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
    Scalar m_b30b430b;
    Scalar m_9d2b0082;
    Scalar m_83f08dc3;
    Scalar m_94794fcc;
    Scalar m_2c52f31d;  ///< force on upwards, x
    Scalar m_1454edca;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n4000 = traits::constant(4000.0, 4000.0f, "4000/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    parameters.theta = n0_3;
    parameters.omega = n0_2;
    parameters.alpha = n0_2;
    parameters.alpha_c = n0_1;
    parameters.k = n4000;
    parameters.c = n8;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n120 = traits::constant(120.0, 120.0f, "120/1");
    const Scalar n665 = traits::constant(665.0, 665.0f, "665/1");
    const Scalar p_omega = parameters.omega;
    const Scalar p_theta = parameters.theta;
    const Scalar p_k = parameters.k;
    Scalar s_theta, c_theta;
    traits::sincos(p_theta, s_theta, c_theta);
    const Scalar z0 = n100 * p_omega;
    const Scalar z1 = p_omega * s_theta;
    const Scalar z2 = p_omega * c_theta;
    const Scalar z3 = n0_5 * p_k;
    const Scalar z4 = p_omega * p_omega;
    const Scalar z5 = n100 * z4;
    const Scalar z6 = z1 * z2;
    const Scalar z7 = n120 * z5;  // force on upwards, x
    const Scalar z8 = n665 * z6;
    precomputed.m_282b6380 = s_theta;
    precomputed.m_b1b5ea6b = c_theta;
    precomputed.m_b30b430b = z0;
    precomputed.m_9d2b0082 = z1;
    precomputed.m_83f08dc3 = z2;
    precomputed.m_94794fcc = z3;
    precomputed.m_2c52f31d = z7;
    precomputed.m_1454edca = z8;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar p_alpha = parameters.alpha;
    const Scalar p_alpha_c = parameters.alpha_c;
    state.time = n0;
    state.q.phi = n0;
    state.q.alpha_1 = p_alpha + p_alpha_c;
    state.q.alpha_2 = p_alpha;
    state.q.alpha_3 = p_alpha - p_alpha_c;
    state.q.alpha_4 = p_alpha;
    state.v.phi = n30;
    state.v.alpha_1 = n0;
    state.v.alpha_2 = -n30 * p_alpha_c;
    state.v.alpha_3 = n0;
    state.v.alpha_4 = -state.v.alpha_2;
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
    std::array<Scalar, 15> A_jacobian;  ///< partial velocities of A (3 x 5)
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

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar s_theta = precomputed.m_282b6380;
    const Scalar c_theta = precomputed.m_b1b5ea6b;
    const Scalar m2 = precomputed.m_b30b430b;
    const Scalar m3 = precomputed.m_9d2b0082;
    const Scalar m4 = precomputed.m_83f08dc3;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {z0, q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z1 = sines_[0], z2 = cosines_[0];
    const Scalar s_phi = sines_[1], c_phi = cosines_[1];
    const Scalar s_alpha_1 = sines_[2], c_alpha_1 = cosines_[2];
    const Scalar s_alpha_2 = sines_[3], c_alpha_2 = cosines_[3];
    const Scalar s_alpha_3 = sines_[4], c_alpha_3 = cosines_[4];
    const Scalar s_alpha_4 = sines_[5], c_alpha_4 = cosines_[5];
    const Scalar z3 = z2 * c_theta;
    const Scalar z4 = z1 * c_theta;
    const Scalar z5 = c_phi * m3;
    const Scalar z6 = s_phi * m3;
    const Scalar z7 = z1 * m2;  // velocity of outwards, x
    const Scalar z8 = z2 * m2;  // velocity of outwards, y
    const Scalar z9 = z2 * s_theta;
    const Scalar z10 = z1 * s_theta;
    const Scalar z11 = v_phi + m4;
    const Scalar z12 = s_theta * c_phi;
    const Scalar z13 = s_theta * s_phi;
    const Scalar z14 = p_omega + c_theta * v_phi;  // angular velocity of rotor, z
    const Scalar z15 = n100 * z2;
    const Scalar z16 = n100 * z1;
    const Scalar z17 = n3 * z11;
    const Scalar z18 = c_theta * s_alpha_1 - c_alpha_1 * z13;
    const Scalar z19 = c_theta * c_alpha_1 + s_alpha_1 * z13;
    const Scalar z20 = v_alpha_1 * z12 + z14;  // angular velocity of blade_1, z
    const Scalar z21 = c_theta * s_alpha_2 - c_alpha_2 * z12;
    const Scalar z22 = c_theta * c_alpha_2 + s_alpha_2 * z12;
    const Scalar z23 = v_alpha_2 * z13 - z14;  // angular velocity of blade_2, z
    const Scalar z24 = c_theta * s_alpha_3 + c_alpha_3 * z13;
    const Scalar z25 = c_theta * c_alpha_3 - s_alpha_3 * z13;
    const Scalar z26 = v_alpha_3 * z12 - z14;  // angular velocity of blade_3, z
    const Scalar z27 = c_theta * s_alpha_4 + c_alpha_4 * z12;
    const Scalar z28 = c_theta * c_alpha_4 - s_alpha_4 * z12;
    const Scalar z29 = v_alpha_4 * z13 + z14;  // angular velocity of blade_4, z
    const Scalar z30 = n3 * z12;
    const Scalar z31 = n3 * z6;
    const Scalar z32 = z1 * s_phi - c_phi * z3;
    const Scalar z33 = n3 * z13;
    const Scalar z34 = z1 * c_phi + s_phi * z3;
    const Scalar z35 = z2 * s_phi + c_phi * z4;
    const Scalar z36 = z2 * c_phi - s_phi * z4;
    const Scalar z37 = n3 * z5;
    const Scalar z38 = v_phi * z9;  // angular velocity of rotor, x
    const Scalar z39 = v_phi * z10;  // angular velocity of rotor, y
    const Scalar z40 = c_theta * z31 - z13 * z17;
    const Scalar z41 = c_theta * z37 - z12 * z17;
    const Scalar z42 = s_alpha_1 * z9 + c_alpha_1 * z34;
    const Scalar z43 = s_alpha_1 * z34 - c_alpha_1 * z9;
    const Scalar z44 = s_alpha_1 * z10 - c_alpha_1 * z36;
    const Scalar z45 = c_alpha_1 * z10 + s_alpha_1 * z36;
    const Scalar z46 = v_alpha_1 * z32 + z38;  // angular velocity of blade_1, x
    const Scalar z47 = v_alpha_1 * z35 - z39;  // angular velocity of blade_1, y
    const Scalar z48 = s_alpha_2 * z9 - c_alpha_2 * z32;
    const Scalar z49 = n3 * z32;
    const Scalar z50 = n3 * z35;
    const Scalar z51 = n3 * z34;
    const Scalar z52 = n3 * z36;
    const Scalar z53 = c_alpha_2 * z9 + s_alpha_2 * z32;
    const Scalar z54 = s_alpha_2 * z10 + c_alpha_2 * z35;
    const Scalar z55 = s_alpha_2 * z35 - c_alpha_2 * z10;
    const Scalar z56 = v_alpha_2 * z34 + z38;  // angular velocity of blade_2, x
    const Scalar z57 = v_alpha_2 * z36 - z39;  // angular velocity of blade_2, y
    const Scalar z58 = s_alpha_3 * z9 - c_alpha_3 * z34;
    const Scalar z59 = c_alpha_3 * z9 + s_alpha_3 * z34;
    const Scalar z60 = s_alpha_3 * z10 + c_alpha_3 * z36;
    const Scalar z61 = s_alpha_3 * z36 - c_alpha_3 * z10;
    const Scalar z62 = v_alpha_3 * z32 - z38;  // angular velocity of blade_3, x
    const Scalar z63 = v_alpha_3 * z35 + z39;  // angular velocity of blade_3, y
    const Scalar z64 = s_alpha_4 * z9 + c_alpha_4 * z32;
    const Scalar z65 = s_alpha_4 * z32 - c_alpha_4 * z9;
    const Scalar z66 = s_alpha_4 * z10 - c_alpha_4 * z35;
    const Scalar z67 = c_alpha_4 * z10 + s_alpha_4 * z35;
    const Scalar z68 = v_alpha_4 * z34 - z38;  // angular velocity of blade_4, x
    const Scalar z69 = v_alpha_4 * z36 + z39;  // angular velocity of blade_4, y
    const Scalar z70 = z15 - z49;
    const Scalar z71 = z16 + z50;
    const Scalar z72 = z7 + z9 * z31 + z34 * z17;
    const Scalar z73 = z8 - z10 * z31 + z36 * z17;
    const Scalar z74 = z15 - z51;
    const Scalar z75 = z16 + z52;
    const Scalar z76 = z7 + z9 * z37 - z32 * z17;
    const Scalar z77 = z8 - z10 * z37 - z35 * z17;
    const Scalar z78 = z15 + z49;
    const Scalar z79 = z16 - z50;
    const Scalar z80 = z7 - z9 * z31 - z34 * z17;
    const Scalar z81 = z8 + z10 * z31 - z36 * z17;
    const Scalar z82 = z15 + z51;
    const Scalar z83 = z16 - z52;
    const Scalar z84 = z7 - z9 * z37 + z32 * z17;
    const Scalar z85 = z8 + z10 * z37 + z35 * z17;
    result.span_1_position[0] = z70;
    result.span_1_position[1] = z71;
    result.span_1_position[2] = z30;
    result.span_1_rotation[0] = -z32;
    result.span_1_rotation[1] = z35;
    result.span_1_rotation[2] = z12;
    result.span_1_rotation[3] = -z34;
    result.span_1_rotation[4] = z36;
    result.span_1_rotation[5] = -z13;
    result.span_1_rotation[6] = -z9;
    result.span_1_rotation[7] = -z10;
    result.span_1_rotation[8] = c_theta;
    result.span_1_velocity[0] = -z72;
    result.span_1_velocity[1] = z73;
    result.span_1_velocity[2] = z40;
    result.span_1_angular_velocity[0] = -z38;
    result.span_1_angular_velocity[1] = -z39;
    result.span_1_angular_velocity[2] = z14;
    result.blade_1_position[0] = z15;
    result.blade_1_position[1] = z16;
    result.blade_1_position[2] = n0;
    result.blade_1_rotation[0] = -z32;
    result.blade_1_rotation[1] = z35;
    result.blade_1_rotation[2] = z12;
    result.blade_1_rotation[3] = -z42;
    result.blade_1_rotation[4] = -z44;
    result.blade_1_rotation[5] = z18;
    result.blade_1_rotation[6] = z43;
    result.blade_1_rotation[7] = -z45;
    result.blade_1_rotation[8] = z19;
    result.blade_1_velocity[0] = -z7;
    result.blade_1_velocity[1] = z8;
    result.blade_1_velocity[2] = n0;
    result.blade_1_angular_velocity[0] = -z46;
    result.blade_1_angular_velocity[1] = z47;
    result.blade_1_angular_velocity[2] = z20;
    result.span_2_position[0] = z74;
    result.span_2_position[1] = z75;
    result.span_2_position[2] = -z33;
    result.span_2_rotation[0] = -z34;
    result.span_2_rotation[1] = z36;
    result.span_2_rotation[2] = -z13;
    result.span_2_rotation[3] = z32;
    result.span_2_rotation[4] = -z35;
    result.span_2_rotation[5] = -z12;
    result.span_2_rotation[6] = -z9;
    result.span_2_rotation[7] = -z10;
    result.span_2_rotation[8] = c_theta;
    result.span_2_velocity[0] = -z76;
    result.span_2_velocity[1] = z77;
    result.span_2_velocity[2] = z41;
    result.span_2_angular_velocity[0] = -z38;
    result.span_2_angular_velocity[1] = -z39;
    result.span_2_angular_velocity[2] = z14;
    result.blade_2_position[0] = z15;
    result.blade_2_position[1] = z16;
    result.blade_2_position[2] = n0;
    result.blade_2_rotation[0] = -z34;
    result.blade_2_rotation[1] = z36;
    result.blade_2_rotation[2] = -z13;
    result.blade_2_rotation[3] = -z48;
    result.blade_2_rotation[4] = -z54;
    result.blade_2_rotation[5] = z21;
    result.blade_2_rotation[6] = -z53;
    result.blade_2_rotation[7] = z55;
    result.blade_2_rotation[8] = z22;
    result.blade_2_velocity[0] = -z7;
    result.blade_2_velocity[1] = z8;
    result.blade_2_velocity[2] = n0;
    result.blade_2_angular_velocity[0] = -z56;
    result.blade_2_angular_velocity[1] = z57;
    result.blade_2_angular_velocity[2] = -z23;
    result.span_3_position[0] = z78;
    result.span_3_position[1] = z79;
    result.span_3_position[2] = -z30;
    result.span_3_rotation[0] = z32;
    result.span_3_rotation[1] = -z35;
    result.span_3_rotation[2] = -z12;
    result.span_3_rotation[3] = z34;
    result.span_3_rotation[4] = -z36;
    result.span_3_rotation[5] = z13;
    result.span_3_rotation[6] = -z9;
    result.span_3_rotation[7] = -z10;
    result.span_3_rotation[8] = c_theta;
    result.span_3_velocity[0] = -z80;
    result.span_3_velocity[1] = z81;
    result.span_3_velocity[2] = -z40;
    result.span_3_angular_velocity[0] = -z38;
    result.span_3_angular_velocity[1] = -z39;
    result.span_3_angular_velocity[2] = z14;
    result.blade_3_position[0] = z15;
    result.blade_3_position[1] = z16;
    result.blade_3_position[2] = n0;
    result.blade_3_rotation[0] = z32;
    result.blade_3_rotation[1] = -z35;
    result.blade_3_rotation[2] = -z12;
    result.blade_3_rotation[3] = -z58;
    result.blade_3_rotation[4] = -z60;
    result.blade_3_rotation[5] = z24;
    result.blade_3_rotation[6] = -z59;
    result.blade_3_rotation[7] = z61;
    result.blade_3_rotation[8] = z25;
    result.blade_3_velocity[0] = -z7;
    result.blade_3_velocity[1] = z8;
    result.blade_3_velocity[2] = n0;
    result.blade_3_angular_velocity[0] = z62;
    result.blade_3_angular_velocity[1] = -z63;
    result.blade_3_angular_velocity[2] = -z26;
    result.span_4_position[0] = z82;
    result.span_4_position[1] = z83;
    result.span_4_position[2] = z33;
    result.span_4_rotation[0] = z34;
    result.span_4_rotation[1] = -z36;
    result.span_4_rotation[2] = z13;
    result.span_4_rotation[3] = -z32;
    result.span_4_rotation[4] = z35;
    result.span_4_rotation[5] = z12;
    result.span_4_rotation[6] = -z9;
    result.span_4_rotation[7] = -z10;
    result.span_4_rotation[8] = c_theta;
    result.span_4_velocity[0] = -z84;
    result.span_4_velocity[1] = z85;
    result.span_4_velocity[2] = -z41;
    result.span_4_angular_velocity[0] = -z38;
    result.span_4_angular_velocity[1] = -z39;
    result.span_4_angular_velocity[2] = z14;
    result.blade_4_position[0] = z15;
    result.blade_4_position[1] = z16;
    result.blade_4_position[2] = n0;
    result.blade_4_rotation[0] = z34;
    result.blade_4_rotation[1] = -z36;
    result.blade_4_rotation[2] = z13;
    result.blade_4_rotation[3] = -z64;
    result.blade_4_rotation[4] = -z66;
    result.blade_4_rotation[5] = z27;
    result.blade_4_rotation[6] = z65;
    result.blade_4_rotation[7] = -z67;
    result.blade_4_rotation[8] = z28;
    result.blade_4_velocity[0] = -z7;
    result.blade_4_velocity[1] = z8;
    result.blade_4_velocity[2] = n0;
    result.blade_4_angular_velocity[0] = z68;
    result.blade_4_angular_velocity[1] = -z69;
    result.blade_4_angular_velocity[2] = z29;
    result.A_position[0] = z15;
    result.A_position[1] = z16;
    result.A_position[2] = n0;
    result.A_velocity[0] = -z7;
    result.A_velocity[1] = z8;
    result.A_velocity[2] = n0;
    result.A_jacobian[0] = n0;
    result.A_jacobian[3] = n0;
    result.A_jacobian[6] = n0;
    result.A_jacobian[9] = n0;
    result.A_jacobian[12] = n0;
    result.A_jacobian[1] = n0;
    result.A_jacobian[4] = n0;
    result.A_jacobian[7] = n0;
    result.A_jacobian[10] = n0;
    result.A_jacobian[13] = n0;
    result.A_jacobian[2] = n0;
    result.A_jacobian[5] = n0;
    result.A_jacobian[8] = n0;
    result.A_jacobian[11] = n0;
    result.A_jacobian[14] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 25>& mass) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar angles_[] = {q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_alpha_1 = cosines_[0];
    const Scalar c_alpha_2 = cosines_[1];
    const Scalar c_alpha_3 = cosines_[2];
    const Scalar c_alpha_4 = cosines_[3];
    const Scalar z0 = n0_4 * c_alpha_4;
    const Scalar z1 = n0_4 * c_alpha_3;
    const Scalar z2 = n0_4 * c_alpha_2;
    const Scalar z3 = n0_4 * c_alpha_1;
    const Scalar z4 = c_alpha_4 * z0;
    const Scalar z5 = c_alpha_3 * z1;
    const Scalar z6 = c_alpha_2 * z2;
    const Scalar z7 = c_alpha_1 * z3;
    const Scalar z8 = n1330 + z4;
    const Scalar z9 = z8 + z5;
    const Scalar z10 = z9 + z6;
    const Scalar z11 = z10 + z7;
    mass[0] = z11;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0_4;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0_4;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0_4;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0_4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar m0 = precomputed.m_9d2b0082;
    const Scalar m1 = precomputed.m_83f08dc3;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z0 = v_phi + m1;  // angular velocity of rotor, z
    const Scalar z1 = c_phi * m0;
    const Scalar z2 = s_phi * m0;
    const Scalar z3 = v_phi * s_phi;
    const Scalar z4 = p_alpha - q_alpha_1 + c_phi * p_alpha_c;
    const Scalar z5 = q_alpha_3 - p_alpha + c_phi * p_alpha_c;
    const Scalar z6 = v_phi * c_phi;
    const Scalar z7 = q_alpha_2 - p_alpha + s_phi * p_alpha_c;
    const Scalar z8 = p_alpha - q_alpha_4 + s_phi * p_alpha_c;
    const Scalar z9 = v_alpha_1 + p_alpha_c * z3;
    const Scalar z10 = v_alpha_2 + p_alpha_c * z6;
    const Scalar z11 = v_alpha_3 - p_alpha_c * z3;
    const Scalar z12 = v_alpha_4 - p_alpha_c * z6;
    const Scalar z13 = v_phi * z2;  // angular acceleration of rotor, x
    const Scalar z14 = v_phi * z1;  // angular acceleration of rotor, y
    const Scalar z15 = s_alpha_1 * z0 - c_alpha_1 * z2;
    const Scalar z16 = c_alpha_1 * z0 + s_alpha_1 * z2;
    const Scalar z17 = v_alpha_1 + z1;  // angular velocity of blade_1, x
    const Scalar z18 = s_alpha_2 * z0 - c_alpha_2 * z1;
    const Scalar z19 = c_alpha_2 * z0 + s_alpha_2 * z1;
    const Scalar z20 = v_alpha_2 - z2;  // angular velocity of blade_2, x
    const Scalar z21 = s_alpha_3 * z0 + c_alpha_3 * z2;
    const Scalar z22 = s_alpha_3 * z2 - c_alpha_3 * z0;
    const Scalar z23 = v_alpha_3 - z1;  // angular velocity of blade_3, x
    const Scalar z24 = s_alpha_4 * z0 + c_alpha_4 * z1;
    const Scalar z25 = s_alpha_4 * z1 - c_alpha_4 * z0;
    const Scalar z26 = v_alpha_4 + z2;  // angular velocity of blade_4, x
    const Scalar z27 = p_k * z4;
    const Scalar z28 = p_k * z7;
    const Scalar z29 = p_k * z5;
    const Scalar z30 = p_k * z8;
    const Scalar z31 = s_alpha_1 * z14;
    const Scalar z32 = s_alpha_2 * z13;
    const Scalar z33 = s_alpha_3 * z14;
    const Scalar z34 = s_alpha_4 * z13;
    const Scalar z35 = z9 * p_c;
    const Scalar z36 = p_c * z10;
    const Scalar z37 = p_c * z11;
    const Scalar z38 = p_c * z12;
    const Scalar z39 = z24 * z26;
    const Scalar z40 = z21 * z23;
    const Scalar z41 = z18 * z19;
    const Scalar z42 = z18 * z20;
    const Scalar z43 = z15 * z16;
    const Scalar z44 = z15 * z17;
    const Scalar z45 = v_alpha_1 * z15 - z31;  // angular acceleration of blade_1, z
    const Scalar z46 = v_alpha_2 * z18 + z32;  // angular acceleration of blade_2, z
    const Scalar z47 = v_alpha_3 * z21 + z33;  // angular acceleration of blade_3, z
    const Scalar z48 = v_alpha_4 * z24 - z34;  // angular acceleration of blade_4, z
    const Scalar z49 = z24 * z25;
    const Scalar z50 = z21 * z22;
    const Scalar z51 = n0_4 * (z14 - z41);  // moment on blade_2, x
    const Scalar z52 = n0_4 * (z13 - z43);  // moment on blade_1, x
    const Scalar z53 = n0_4 * (z14 - z49);  // moment on blade_4, x
    const Scalar z54 = n0_4 * (z48 + z39);  // moment on blade_4, z
    const Scalar z55 = n0_4 * (z13 - z50);  // moment on blade_3, x
    const Scalar z56 = n0_4 * (z47 + z40);  // moment on blade_3, z
    const Scalar z57 = n0_4 * (z46 + z42);  // moment on blade_2, z
    const Scalar z58 = n0_4 * (z45 + z44);  // moment on blade_1, z
    const Scalar z59 = z27 - z35 + z52;
    const Scalar z60 = z28 + z36 - z51;
    const Scalar z61 = c_alpha_4 * z54;
    const Scalar z62 = c_alpha_3 * z56;
    const Scalar z63 = c_alpha_2 * z57;
    const Scalar z64 = c_alpha_1 * z58;
    const Scalar z65 = z29 + z37 + z55;
    const Scalar z66 = z30 - z38 - z53;
    const Scalar z67 = z61 + z62 + z63 + z64;  // moment on rotor, z
    const Scalar z68 = p_alpha_c * (s_phi * (z27 + z29 - z35 + z37) - c_phi * (z28 + z30 + z36 - z38)) + z67;
    forces.phi = -z68;
    forces.alpha_1 = -z59;
    forces.alpha_2 = z60;
    forces.alpha_3 = z65;
    forces.alpha_4 = -z66;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar a_alpha_1 = accelerations.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar a_alpha_2 = accelerations.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar a_alpha_3 = accelerations.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar a_alpha_4 = accelerations.alpha_4;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar m0 = precomputed.m_9d2b0082;
    const Scalar m1 = precomputed.m_83f08dc3;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z0 = s_phi * m0;
    const Scalar z1 = v_phi + m1;  // angular velocity of rotor, z
    const Scalar z2 = c_phi * m0;
    const Scalar z3 = v_phi * s_phi;
    const Scalar z4 = p_alpha - q_alpha_1 + c_phi * p_alpha_c;
    const Scalar z5 = q_alpha_3 - p_alpha + c_phi * p_alpha_c;
    const Scalar z6 = v_phi * c_phi;
    const Scalar z7 = q_alpha_2 - p_alpha + s_phi * p_alpha_c;
    const Scalar z8 = p_alpha - q_alpha_4 + s_phi * p_alpha_c;
    const Scalar z9 = v_alpha_1 + p_alpha_c * z3;
    const Scalar z10 = v_alpha_2 + p_alpha_c * z6;
    const Scalar z11 = v_alpha_3 - p_alpha_c * z3;
    const Scalar z12 = v_alpha_4 - p_alpha_c * z6;
    const Scalar z13 = v_phi * z0;  // angular acceleration of rotor, x
    const Scalar z14 = v_phi * z2;  // angular acceleration of rotor, y
    const Scalar z15 = s_alpha_1 * z1 - c_alpha_1 * z0;
    const Scalar z16 = c_alpha_1 * z1 + s_alpha_1 * z0;
    const Scalar z17 = v_alpha_1 + z2;  // angular velocity of blade_1, x
    const Scalar z18 = s_alpha_2 * z1 - c_alpha_2 * z2;
    const Scalar z19 = c_alpha_2 * z1 + s_alpha_2 * z2;
    const Scalar z20 = v_alpha_2 - z0;  // angular velocity of blade_2, x
    const Scalar z21 = s_alpha_3 * z1 + c_alpha_3 * z0;
    const Scalar z22 = s_alpha_3 * z0 - c_alpha_3 * z1;
    const Scalar z23 = v_alpha_3 - z2;  // angular velocity of blade_3, x
    const Scalar z24 = s_alpha_4 * z1 + c_alpha_4 * z2;
    const Scalar z25 = s_alpha_4 * z2 - c_alpha_4 * z1;
    const Scalar z26 = v_alpha_4 + z0;  // angular velocity of blade_4, x
    const Scalar z27 = p_k * z4;
    const Scalar z28 = p_k * z7;
    const Scalar z29 = p_k * z5;
    const Scalar z30 = p_k * z8;
    const Scalar z31 = a_phi * c_alpha_1 + s_alpha_1 * z14;
    const Scalar z32 = a_alpha_1 - z13;  // angular acceleration of blade_1, x
    const Scalar z33 = a_phi * c_alpha_2 - s_alpha_2 * z13;
    const Scalar z34 = a_alpha_2 - z14;  // angular acceleration of blade_2, x
    const Scalar z35 = a_phi * c_alpha_3 - s_alpha_3 * z14;
    const Scalar z36 = a_alpha_3 + z13;  // angular acceleration of blade_3, x
    const Scalar z37 = a_phi * c_alpha_4 + s_alpha_4 * z13;
    const Scalar z38 = a_alpha_4 + z14;  // angular acceleration of blade_4, x
    const Scalar z39 = z9 * p_c;
    const Scalar z40 = p_c * z10;
    const Scalar z41 = p_c * z11;
    const Scalar z42 = p_c * z12;
    const Scalar z43 = z24 * z26;
    const Scalar z44 = z21 * z23;
    const Scalar z45 = z18 * z19;
    const Scalar z46 = z18 * z20;
    const Scalar z47 = z15 * z16;
    const Scalar z48 = z15 * z17;
    const Scalar z49 = v_alpha_1 * z15 - z31;  // angular acceleration of blade_1, z
    const Scalar z50 = v_alpha_2 * z18 - z33;  // angular acceleration of blade_2, z
    const Scalar z51 = v_alpha_3 * z21 - z35;  // angular acceleration of blade_3, z
    const Scalar z52 = z21 * z22;
    const Scalar z53 = n0_4 * (z34 + z45);  // moment on blade_2, x
    const Scalar z54 = n0_4 * (z32 + z47);  // moment on blade_1, x
    const Scalar z55 = v_alpha_4 * z24 - z37;  // angular acceleration of blade_4, z
    const Scalar z56 = z24 * z25;
    const Scalar z57 = n0_4 * (z55 + z43);  // moment on blade_4, z
    const Scalar z58 = n0_4 * (z51 + z44);  // moment on blade_3, z
    const Scalar z59 = n0_4 * (z50 + z46);  // moment on blade_2, z
    const Scalar z60 = n0_4 * (z49 + z48);  // moment on blade_1, z
    const Scalar z61 = n0_4 * (z38 - z56);  // moment on blade_4, x
    const Scalar z62 = n0_4 * (z36 - z52);  // moment on blade_3, x
    const Scalar z63 = c_alpha_4 * z57;
    const Scalar z64 = c_alpha_3 * z58;
    const Scalar z65 = c_alpha_2 * z59;
    const Scalar z66 = c_alpha_1 * z60;
    const Scalar z67 = z27 - z39 - z54;
    const Scalar z68 = n1330 * a_phi - z63 - z64 - z65 - z66;  // moment on rotor, z
    const Scalar z69 = z28 + z40 + z53;
    const Scalar z70 = z29 + z41 + z62;
    const Scalar z71 = z30 - z42 - z61;
    const Scalar z72 = p_alpha_c * (s_phi * (z27 + z29 - z39 + z41) - c_phi * (z28 + z30 + z40 - z42)) - z68;
    forces.phi = -z72;
    forces.alpha_1 = -z67;
    forces.alpha_2 = z69;
    forces.alpha_3 = z70;
    forces.alpha_4 = -z71;
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
      const Inputs& inputs, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1330 = traits::constant(1330.0, 1330.0f, "1330/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2_5 = traits::constant(2.5, 2.5f, "5/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar u_C = inputs.C;
    const Scalar p_k = precomputed.parameters.k;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar m0 = precomputed.m_9d2b0082;
    const Scalar m1 = precomputed.m_83f08dc3;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z0 = v_phi + m1;  // angular velocity of rotor, z
    const Scalar z1 = c_phi * m0;
    const Scalar z2 = s_phi * m0;
    const Scalar z3 = v_phi * s_phi;
    const Scalar z4 = p_alpha - q_alpha_1 + c_phi * p_alpha_c;
    const Scalar z5 = q_alpha_3 - p_alpha + c_phi * p_alpha_c;
    const Scalar z6 = v_phi * c_phi;
    const Scalar z7 = q_alpha_2 - p_alpha + s_phi * p_alpha_c;
    const Scalar z8 = p_alpha - q_alpha_4 + s_phi * p_alpha_c;
    const Scalar z9 = v_alpha_1 + p_alpha_c * z3;
    const Scalar z10 = v_alpha_2 + p_alpha_c * z6;
    const Scalar z11 = v_alpha_3 - p_alpha_c * z3;
    const Scalar z12 = v_alpha_4 - p_alpha_c * z6;
    const Scalar z13 = v_phi * z2;  // angular acceleration of rotor, x
    const Scalar z14 = v_phi * z1;  // angular acceleration of rotor, y
    const Scalar z15 = s_alpha_1 * z0 - c_alpha_1 * z2;
    const Scalar z16 = c_alpha_1 * z0 + s_alpha_1 * z2;
    const Scalar z17 = v_alpha_1 + z1;  // angular velocity of blade_1, x
    const Scalar z18 = s_alpha_2 * z0 - c_alpha_2 * z1;
    const Scalar z19 = c_alpha_2 * z0 + s_alpha_2 * z1;
    const Scalar z20 = v_alpha_2 - z2;  // angular velocity of blade_2, x
    const Scalar z21 = s_alpha_3 * z0 + c_alpha_3 * z2;
    const Scalar z22 = s_alpha_3 * z2 - c_alpha_3 * z0;
    const Scalar z23 = v_alpha_3 - z1;  // angular velocity of blade_3, x
    const Scalar z24 = s_alpha_4 * z0 + c_alpha_4 * z1;
    const Scalar z25 = s_alpha_4 * z1 - c_alpha_4 * z0;
    const Scalar z26 = v_alpha_4 + z2;  // angular velocity of blade_4, x
    const Scalar z27 = p_k * z4;
    const Scalar z28 = p_k * z7;
    const Scalar z29 = p_k * z5;
    const Scalar z30 = p_k * z8;
    const Scalar z31 = s_alpha_1 * z14;
    const Scalar z32 = s_alpha_2 * z13;
    const Scalar z33 = s_alpha_3 * z14;
    const Scalar z34 = s_alpha_4 * z13;
    const Scalar z35 = z9 * p_c;
    const Scalar z36 = p_c * z10;
    const Scalar z37 = n0_4 * c_alpha_4;
    const Scalar z38 = c_alpha_4 * z37;
    const Scalar z39 = n1330 + z38;
    const Scalar z40 = p_c * z11;
    const Scalar z41 = n0_4 * c_alpha_3;
    const Scalar z42 = n0_4 * c_alpha_2;
    const Scalar z43 = c_alpha_3 * z41;
    const Scalar z44 = p_c * z12;
    const Scalar z45 = c_alpha_2 * z42;
    const Scalar z46 = n0_4 * c_alpha_1;
    const Scalar z47 = c_alpha_1 * z46;
    const Scalar z48 = z24 * z26;
    const Scalar z49 = z21 * z23;
    const Scalar z50 = z18 * z19;
    const Scalar z51 = z18 * z20;
    const Scalar z52 = z15 * z16;
    const Scalar z53 = z15 * z17;
    const Scalar z54 = v_alpha_1 * z15 - z31;  // angular acceleration of blade_1, z
    const Scalar z55 = v_alpha_2 * z18 + z32;  // angular acceleration of blade_2, z
    const Scalar z56 = v_alpha_3 * z21 + z33;  // angular acceleration of blade_3, z
    const Scalar z57 = v_alpha_4 * z24 - z34;  // angular acceleration of blade_4, z
    const Scalar z58 = z39 + z43;
    const Scalar z59 = z24 * z25;
    const Scalar z60 = z21 * z22;
    const Scalar z61 = n0_4 * (z14 - z50);  // moment on blade_2, x
    const Scalar z62 = z58 + z45;
    const Scalar z63 = n0_4 * (z13 - z52);  // moment on blade_1, x
    const Scalar z64 = n0_4 * (z57 + z48);  // moment on blade_4, z
    const Scalar z65 = n0_4 * (z56 + z49);  // moment on blade_3, z
    const Scalar z66 = n0_4 * (z55 + z51);  // moment on blade_2, z
    const Scalar z67 = n0_4 * (z54 + z53);  // moment on blade_1, z
    const Scalar z68 = z62 + z47;
    const Scalar z69 = n0_4 * (z14 - z59);  // moment on blade_4, x
    const Scalar z70 = c_alpha_4 * z64;
    const Scalar z71 = c_alpha_3 * z65;
    const Scalar z72 = c_alpha_2 * z66;
    const Scalar z73 = c_alpha_1 * z67;
    const Scalar z74 = n0_4 * (z13 - z60);  // moment on blade_3, x
    const Scalar z75 = z70 + z71 + z72 + z73;  // moment on rotor, z
    const Scalar z76 = z27 - z35 + z63;
    const Scalar z77 = z28 + z36 - z61;
    const Scalar z78 = z29 + z40 + z74;
    const Scalar z79 = z30 - z44 - z69;
    const Scalar z80 = n1 / z68;
    const Scalar z81 = n2_5 * z76;
    const Scalar z82 = n2_5 * z77;
    const Scalar z83 = n2_5 * z78;
    const Scalar z84 = n2_5 * z79;
    const Scalar z85 = p_alpha_c * (s_phi * (z27 + z29 - z35 + z40) - c_phi * (z28 + z30 + z36 - z44)) + z75;
    const Scalar z86 = u_C + z85;
    const Scalar z87 = z86 * z80;
    accelerations.phi = z87;
    accelerations.alpha_1 = z81;
    accelerations.alpha_2 = -z82;
    accelerations.alpha_3 = -z83;
    accelerations.alpha_4 = z84;
    if (!(traits::regular(z68, z68))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.phi * accelerations.alpha_1 * accelerations.alpha_2 * accelerations.alpha_3
        * accelerations.alpha_4;
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
    const Scalar n332_5 = traits::constant(332.5, 332.5f, "665/2");
    const Scalar n60 = traits::constant(60.0, 60.0f, "60/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar u_C = inputs.C;
    const Scalar p_alpha_c = precomputed.parameters.alpha_c;
    const Scalar p_alpha = precomputed.parameters.alpha;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar m0 = precomputed.m_b30b430b;
    const Scalar m1 = precomputed.m_9d2b0082;
    const Scalar m2 = precomputed.m_83f08dc3;
    const Scalar m3 = precomputed.m_94794fcc;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z0 = c_phi * m1;
    const Scalar z1 = s_phi * m1;
    const Scalar z2 = v_phi + m2;  // angular velocity of rotor, z
    const Scalar z3 = v_phi * s_phi;
    const Scalar z4 = v_phi * c_phi;
    const Scalar z5 = s_phi * m0;
    const Scalar z6 = c_phi * m0;
    const Scalar z7 = p_alpha - q_alpha_1 + c_phi * p_alpha_c;
    const Scalar z8 = q_alpha_2 - p_alpha + s_phi * p_alpha_c;
    const Scalar z9 = q_alpha_3 - p_alpha + c_phi * p_alpha_c;
    const Scalar z10 = p_alpha - q_alpha_4 + s_phi * p_alpha_c;
    const Scalar z11 = c_alpha_1 * z2 + s_alpha_1 * z1;
    const Scalar z12 = v_alpha_1 + z0;  // angular velocity of blade_1, x
    const Scalar z13 = c_alpha_2 * z2 + s_alpha_2 * z0;
    const Scalar z14 = v_alpha_2 - z1;  // angular velocity of blade_2, x
    const Scalar z15 = s_alpha_3 * z1 - c_alpha_3 * z2;
    const Scalar z16 = v_alpha_3 - z0;  // angular velocity of blade_3, x
    const Scalar z17 = s_alpha_4 * z0 - c_alpha_4 * z2;
    const Scalar z18 = v_alpha_4 + z1;  // angular velocity of blade_4, x
    const Scalar z19 = v_alpha_1 + p_alpha_c * z3;
    const Scalar z20 = v_alpha_2 + p_alpha_c * z4;
    const Scalar z21 = v_alpha_3 - p_alpha_c * z3;
    const Scalar z22 = v_alpha_4 - p_alpha_c * z4;
    const Scalar z23 = p_c * z19;
    const Scalar z24 = p_c * z20;
    const Scalar z25 = p_c * z21;
    const Scalar z26 = p_c * z22;
    result.kinetic = n665 * z2 * z2 + n332_5 * (z0 * z0 + z1 * z1) + n60 * (z5 * z5 + z6 * z6) + n0_2 * (z12 * z12 + z14
        * z14 + z16 * z16 + z18 * z18 + z11 * z11 + z13 * z13 + z15 * z15 + z17 * z17);
    result.force_function = -m3 * (z7 * z7 + z8 * z8 + z9 * z9 + z10 * z10);
    result.power = v_phi * u_C - z19 * z23 - z20 * z24 - z21 * z25 - z22 * z26;
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
    const Scalar q_alpha_1 = state.q.alpha_1;
    const Scalar v_alpha_1 = state.v.alpha_1;
    const Scalar a_alpha_1 = accelerations.alpha_1;
    const Scalar q_alpha_2 = state.q.alpha_2;
    const Scalar v_alpha_2 = state.v.alpha_2;
    const Scalar a_alpha_2 = accelerations.alpha_2;
    const Scalar q_alpha_3 = state.q.alpha_3;
    const Scalar v_alpha_3 = state.v.alpha_3;
    const Scalar a_alpha_3 = accelerations.alpha_3;
    const Scalar q_alpha_4 = state.q.alpha_4;
    const Scalar v_alpha_4 = state.v.alpha_4;
    const Scalar a_alpha_4 = accelerations.alpha_4;
    const Scalar m0 = precomputed.m_9d2b0082;
    const Scalar m1 = precomputed.m_83f08dc3;
    const Scalar m2 = precomputed.m_2c52f31d;
    const Scalar m3 = precomputed.m_1454edca;
    const Scalar angles_[] = {q_phi, q_alpha_1, q_alpha_2, q_alpha_3, q_alpha_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar s_alpha_1 = sines_[1], c_alpha_1 = cosines_[1];
    const Scalar s_alpha_2 = sines_[2], c_alpha_2 = cosines_[2];
    const Scalar s_alpha_3 = sines_[3], c_alpha_3 = cosines_[3];
    const Scalar s_alpha_4 = sines_[4], c_alpha_4 = cosines_[4];
    const Scalar z0 = v_phi + m1;  // angular velocity of rotor, z
    const Scalar z1 = s_phi * m0;
    const Scalar z2 = c_phi * m0;
    const Scalar z3 = v_phi * z1;  // angular acceleration of rotor, x
    const Scalar z4 = v_phi * z2;  // angular acceleration of rotor, y
    const Scalar z5 = s_alpha_1 * z0 - c_alpha_1 * z1;
    const Scalar z6 = c_alpha_1 * z0 + s_alpha_1 * z1;
    const Scalar z7 = v_alpha_1 + z2;  // angular velocity of blade_1, x
    const Scalar z8 = s_alpha_2 * z0 - c_alpha_2 * z2;
    const Scalar z9 = c_alpha_2 * z0 + s_alpha_2 * z2;
    const Scalar z10 = v_alpha_2 - z1;  // angular velocity of blade_2, x
    const Scalar z11 = s_alpha_3 * z0 + c_alpha_3 * z1;
    const Scalar z12 = s_alpha_3 * z1 - c_alpha_3 * z0;
    const Scalar z13 = v_alpha_3 - z2;  // angular velocity of blade_3, x
    const Scalar z14 = s_alpha_4 * z0 + c_alpha_4 * z2;
    const Scalar z15 = s_alpha_4 * z2 - c_alpha_4 * z0;
    const Scalar z16 = v_alpha_4 + z1;  // angular velocity of blade_4, x
    const Scalar z17 = z1 * z0;
    const Scalar z18 = z2 * z0;
    const Scalar z19 = a_phi * c_alpha_1 + s_alpha_1 * z4;
    const Scalar z20 = a_alpha_1 - z3;  // angular acceleration of blade_1, x
    const Scalar z21 = a_phi * c_alpha_2 - s_alpha_2 * z3;
    const Scalar z22 = a_alpha_2 - z4;  // angular acceleration of blade_2, x
    const Scalar z23 = a_phi * c_alpha_3 - s_alpha_3 * z4;
    const Scalar z24 = a_alpha_3 + z3;  // angular acceleration of blade_3, x
    const Scalar z25 = a_phi * c_alpha_4 + s_alpha_4 * z3;
    const Scalar z26 = a_alpha_4 + z4;  // angular acceleration of blade_4, x
    const Scalar z27 = z14 * z16;
    const Scalar z28 = z11 * z13;
    const Scalar z29 = z8 * z9;
    const Scalar z30 = z8 * z10;
    const Scalar z31 = z5 * z6;
    const Scalar z32 = z5 * z7;
    const Scalar z33 = v_alpha_1 * z5 - z19;  // angular acceleration of blade_1, z
    const Scalar z34 = v_alpha_2 * z8 - z21;  // angular acceleration of blade_2, z
    const Scalar z35 = v_alpha_3 * z11 - z23;  // angular acceleration of blade_3, z
    const Scalar z36 = v_alpha_4 * z14 - z25;  // angular acceleration of blade_4, z
    const Scalar z37 = z14 * z15;
    const Scalar z38 = z11 * z12;
    const Scalar z39 = n0_4 * (z22 + z29);  // moment on blade_2, x
    const Scalar z40 = n0_4 * (z20 + z31);  // moment on blade_1, x
    const Scalar z41 = n0_4 * (z26 - z37);  // moment on blade_4, x
    const Scalar z42 = n0_4 * (z24 - z38);  // moment on blade_3, x
    const Scalar z43 = n0_4 * (z36 + z27);  // moment on blade_4, z
    const Scalar z44 = n0_4 * (z35 + z28);  // moment on blade_3, z
    const Scalar z45 = n0_4 * (z34 + z30);  // moment on blade_2, z
    const Scalar z46 = n0_4 * (z33 + z32);  // moment on blade_1, z
    const Scalar z47 = s_alpha_4 * z43;
    const Scalar z48 = c_alpha_4 * z43;
    const Scalar z49 = s_alpha_3 * z44;
    const Scalar z50 = c_alpha_3 * z44;
    const Scalar z51 = s_alpha_2 * z45;
    const Scalar z52 = c_alpha_2 * z45;
    const Scalar z53 = s_alpha_1 * z46;
    const Scalar z54 = c_alpha_1 * z46;
    const Scalar z55 = z40 - n1330 * z17 - z42 + z47 - z51;  // moment on rotor, x
    const Scalar z56 = n1330 * z18 - z39 + z41 + z49 - z53;  // moment on rotor, y
    const Scalar z57 = n1330 * a_phi - z48 - z50 - z52 - z54;  // moment on rotor, z
    const Scalar z58 = s_phi * z56 + c_phi * z55;
    const Scalar z59 = s_phi * z55 - c_phi * z56;
    const Scalar z60 = m3 + z59;  // moment on pitch, y
    result.X = -m2;
    result.Y = n0;
    result.Z = n0;
    result.M_x = z58;
    result.M_y = z60;
    result.M_z = z57;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Inputs& inputs, Reactions& result) noexcept {
    Mechanism::reactions(precomputed, state, accelerations, Multipliers(), inputs, result);
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 25>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, Reactions&>(reactions));
  }
};

}  // namespace helicopter_on_a_circle_pitching_blades
