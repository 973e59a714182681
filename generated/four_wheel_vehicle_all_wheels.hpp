// SPDX-License-Identifier: MIT-0
// four_wheel_vehicle_all_wheels: Four-wheel vehicle: the eight conditions of its four wheels
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: alpha_1, alpha_2, alpha_3, alpha_4
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute               12               28          0             0                  4       0     48       -
//   kinematics               64               73          0             0                  9       0    155     155
//   mass_matrix              44               44          0             0                  1       0     90     118
//   bias                     43               60          0             0                  1       0    105     119
//   inverse_dynamics        116              111          0             0                  5       0    237     270
//   forward_dynamics        599              729         11             0                  5       0   1349    1406
//   energy                   48               74          0             0                  5       0    132     162
//   constraints              44               56          0             0                  4       0    108     132
//
// Not computed because this mechanism does not need it:
//   kinematics: of 246 results 131 vanish identically, 30 repeat another up to sign
//   mass_matrix: of 121 results 82 vanish identically, 14 repeat another up to sign
//   bias: of 11 results 4 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: of 112 results 64 vanish identically, 8 repeat another up to sign
//
// To write this file again:
//   four_wheel_vehicle_all_wheels_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --support torsor_support.hpp --output four_wheel_vehicle_all_wheels.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace four_wheel_vehicle_all_wheels {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 11> coordinates{{{"x", "m"}, {"y", "m"}, {"psi", "rad"},
      {"phi_1", "rad"}, {"phi_2", "rad"}, {"phi_3", "rad"}, {"phi_4", "rad"}, {"s_1", "m"}, {"s_2", "m"}, {"s_3", "m"},
      {"s_4", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 11> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"psi", "rad/s"},
      {"phi_1", "rad/s"}, {"phi_2", "rad/s"}, {"phi_3", "rad/s"}, {"phi_4", "rad/s"}, {"s_1", "m/s"}, {"s_2", "m/s"},
      {"s_3", "m/s"}, {"s_4", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 8> multipliers{{{"lambda_wheel_1_x", "N"},
      {"lambda_wheel_1_y", "N"}, {"lambda_wheel_2_x", "N"}, {"lambda_wheel_2_y", "N"}, {"lambda_wheel_3_x", "N"},
      {"lambda_wheel_3_y", "N"}, {"lambda_wheel_4_x", "N"}, {"lambda_wheel_4_y", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 4> parameters{{{"alpha_1", "rad"}, {"alpha_2", "rad"},
      {"alpha_3", "rad"}, {"alpha_4", "rad"}}};
  static constexpr std::array<torsor::ResultDescription, 44> results{{{"result", "chassis_position", 3, 1, 1, "m"},
      {"result", "chassis_rotation", 3, 3, 2, "1"}, {"result", "chassis_velocity", 3, 1, 1, "m/s"}, {"result",
      "chassis_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "wheel_1_position", 3, 1, 1, "m"}, {"result",
      "wheel_1_rotation", 3, 3, 2, "1"}, {"result", "wheel_1_velocity", 3, 1, 1, "m/s"}, {"result",
      "wheel_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "wheel_2_position", 3, 1, 1, "m"}, {"result",
      "wheel_2_rotation", 3, 3, 2, "1"}, {"result", "wheel_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "wheel_2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "wheel_3_position", 3, 1, 1, "m"}, {"result",
      "wheel_3_rotation", 3, 3, 2, "1"}, {"result", "wheel_3_velocity", 3, 1, 1, "m/s"}, {"result",
      "wheel_3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "wheel_4_position", 3, 1, 1, "m"}, {"result",
      "wheel_4_rotation", 3, 3, 2, "1"}, {"result", "wheel_4_velocity", 3, 1, 1, "m/s"}, {"result",
      "wheel_4_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "P1_position", 3, 1, 1, "m"}, {"result", "P1_velocity",
      3, 1, 1, "m/s"}, {"result", "P1_jacobian", 3, 11, 2, ""}, {"result", "P2_position", 3, 1, 1, "m"}, {"result",
      "P2_velocity", 3, 1, 1, "m/s"}, {"result", "P2_jacobian", 3, 11, 2, ""}, {"result", "P3_position", 3, 1, 1, "m"},
      {"result", "P3_velocity", 3, 1, 1, "m/s"}, {"result", "P3_jacobian", 3, 11, 2, ""}, {"result", "P4_position", 3,
      1, 1, "m"}, {"result", "P4_velocity", 3, 1, 1, "m/s"}, {"result", "P4_jacobian", 3, 11, 2, ""}, {"mass", "", 11,
      11, 2, ""}, {"forces", "", 11, 1, 1, "N, N, N m, 0, 0, 0, 0, N, N, N, N"}, {"forces", "", 11, 1, 1,
      "N, N, N m, N m, N m, N m, N m, N, N, N, N"}, {"accelerations", "", 11, 1, 1,
      "m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, m/s^2, m/s^2, m/s^2, m/s^2"}, {"multipliers", "", 8,
      1, 1, "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power",
      1, 1, 0, "W"}, {"result", "value", 8, 1, 1, ""}, {"result", "rate", 8, 1, 1, "m/s"}, {"result", "jacobian", 8, 11,
      2, ""}, {"result", "gamma", 8, 1, 1, "m/s^2"}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 32}, {"mass_matrix", false, false, false, false, results.data() + 32, 1}, {"bias", false,
      false, false, false, results.data() + 33, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 34,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 35, 2}, {"energy", false, false, true, false,
      results.data() + 37, 3}, {"constraints", false, false, false, false, results.data() + 40, 4}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::four_wheel_vehicle_all_wheels::Description;

  static constexpr const char* name = "four_wheel_vehicle_all_wheels";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x6504a0031122c95cULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 11;
  static constexpr int velocity_count = 11;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 8;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar alpha_1;  ///< parameter [rad]
    Scalar alpha_2;  ///< parameter [rad]
    Scalar alpha_3;  ///< parameter [rad]
    Scalar alpha_4;  ///< parameter [rad]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::alpha_1, &Parameters::alpha_2, &Parameters::alpha_3,
          &Parameters::alpha_4};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad]
    Scalar phi_1;  ///< coordinate [rad]
    Scalar phi_2;  ///< coordinate [rad]
    Scalar phi_3;  ///< coordinate [rad]
    Scalar phi_4;  ///< coordinate [rad]
    Scalar s_1;  ///< coordinate [m]
    Scalar s_2;  ///< coordinate [m]
    Scalar s_3;  ///< coordinate [m]
    Scalar s_4;  ///< coordinate [m]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::phi_1, &Coordinates::phi_2, &Coordinates::phi_3, &Coordinates::phi_4, &Coordinates::s_1,
          &Coordinates::s_2, &Coordinates::s_3, &Coordinates::s_4};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar phi_1;  ///< its rate [rad/s]
    Scalar phi_2;  ///< its rate [rad/s]
    Scalar phi_3;  ///< its rate [rad/s]
    Scalar phi_4;  ///< its rate [rad/s]
    Scalar s_1;  ///< its rate [m/s]
    Scalar s_2;  ///< its rate [m/s]
    Scalar s_3;  ///< its rate [m/s]
    Scalar s_4;  ///< its rate [m/s]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::phi_1,
          &Velocities::phi_2, &Velocities::phi_3, &Velocities::phi_4, &Velocities::s_1, &Velocities::s_2,
          &Velocities::s_3, &Velocities::s_4};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar phi_1;  ///< its second rate [rad/s^2]
    Scalar phi_2;  ///< its second rate [rad/s^2]
    Scalar phi_3;  ///< its second rate [rad/s^2]
    Scalar phi_4;  ///< its second rate [rad/s^2]
    Scalar s_1;  ///< its second rate [m/s^2]
    Scalar s_2;  ///< its second rate [m/s^2]
    Scalar s_3;  ///< its second rate [m/s^2]
    Scalar s_4;  ///< its second rate [m/s^2]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::phi_1, &Accelerations::phi_2, &Accelerations::phi_3, &Accelerations::phi_4,
          &Accelerations::s_1, &Accelerations::s_2, &Accelerations::s_3, &Accelerations::s_4};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar phi_1;  ///< works with the rate of phi_1 [N m]
    Scalar phi_2;  ///< works with the rate of phi_2 [N m]
    Scalar phi_3;  ///< works with the rate of phi_3 [N m]
    Scalar phi_4;  ///< works with the rate of phi_4 [N m]
    Scalar s_1;  ///< works with the rate of s_1 [N]
    Scalar s_2;  ///< works with the rate of s_2 [N]
    Scalar s_3;  ///< works with the rate of s_3 [N]
    Scalar s_4;  ///< works with the rate of s_4 [N]
    static constexpr int size = 11;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::phi_1, &GeneralizedForces::phi_2, &GeneralizedForces::phi_3,
          &GeneralizedForces::phi_4, &GeneralizedForces::s_1, &GeneralizedForces::s_2, &GeneralizedForces::s_3,
          &GeneralizedForces::s_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_wheel_1_x;  ///< of the constraint wheel_1_x [N]
    Scalar lambda_wheel_1_y;  ///< of the constraint wheel_1_y [N]
    Scalar lambda_wheel_2_x;  ///< of the constraint wheel_2_x [N]
    Scalar lambda_wheel_2_y;  ///< of the constraint wheel_2_y [N]
    Scalar lambda_wheel_3_x;  ///< of the constraint wheel_3_x [N]
    Scalar lambda_wheel_3_y;  ///< of the constraint wheel_3_y [N]
    Scalar lambda_wheel_4_x;  ///< of the constraint wheel_4_x [N]
    Scalar lambda_wheel_4_y;  ///< of the constraint wheel_4_y [N]
    static constexpr int size = 8;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_wheel_1_x, &Multipliers::lambda_wheel_1_y,
          &Multipliers::lambda_wheel_2_x, &Multipliers::lambda_wheel_2_y, &Multipliers::lambda_wheel_3_x,
          &Multipliers::lambda_wheel_3_y, &Multipliers::lambda_wheel_4_x, &Multipliers::lambda_wheel_4_y};
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
    Scalar m_92c0037f;
    Scalar m_c7906510;
    Scalar m_43ebfeb2;
    Scalar m_584e2578;
    Scalar m_4922d978;
    Scalar m_0a1afa2c;
    Scalar m_2e8ec554;
    Scalar m_43b32f47;
    Scalar m_3cba4880;
    Scalar m_6795f82c;
    Scalar m_1ecdcef4;
    Scalar m_e2566af3;
    Scalar m_cc38b7ab;
    Scalar m_7d206ec7;
    Scalar m_d89552ed;
    Scalar m_f93fecf2;
    Scalar m_e90afaf4;
    Scalar m_d90c674e;
    Scalar m_e5df403d;
    Scalar m_47b4c84d;
    Scalar m_0e0985b8;
    Scalar m_d2eddde9;
    Scalar m_2a23efbc;
    Scalar m_85796129;
    Scalar m_e00c27a7;
    Scalar m_3b9dd6fa;
    Scalar m_8ec84cf7;
    Scalar m_25022fbd;
    Scalar m_9d44cfff;
    Scalar m_6373fbbb;
    Scalar m_d5fafc4e;
    Scalar m_df0487e0;
    Scalar m_0054f442;
    Scalar m_b458bac9;
    Scalar m_a1fc46ba;
    Scalar m_232b8723;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n1_over_6 = traits::constant(0.16666666666666666, 0.16666667f, "1/6");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar pi = traits::pi();
    parameters.alpha_1 = -n0_25 * pi;
    parameters.alpha_2 = -n1_over_6 * pi;
    parameters.alpha_3 = n0;
    parameters.alpha_4 = n0;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar p_alpha_1 = parameters.alpha_1;
    const Scalar p_alpha_2 = parameters.alpha_2;
    const Scalar p_alpha_3 = parameters.alpha_3;
    const Scalar p_alpha_4 = parameters.alpha_4;
    const Scalar angles_[] = {p_alpha_1, p_alpha_2, p_alpha_3, p_alpha_4};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha_1 = sines_[0], c_alpha_1 = cosines_[0];
    const Scalar s_alpha_2 = sines_[1], c_alpha_2 = cosines_[1];
    const Scalar s_alpha_3 = sines_[2], c_alpha_3 = cosines_[2];
    const Scalar s_alpha_4 = sines_[3], c_alpha_4 = cosines_[3];
    const Scalar z0 = n20 * c_alpha_4;
    const Scalar z1 = n20 * s_alpha_4;
    const Scalar z2 = z0 + k1 * z1;
    const Scalar z3 = n20 * c_alpha_3;
    const Scalar z4 = n20 * s_alpha_3;
    const Scalar z5 = z3 - k1 * z4;
    const Scalar z6 = n20 * c_alpha_2;
    const Scalar z7 = n20 * s_alpha_2;
    const Scalar z8 = z6 + k1 * z7;
    const Scalar z9 = n20 * c_alpha_1;
    const Scalar z10 = n20 * s_alpha_1;
    const Scalar z11 = z9 - k1 * z10;
    const Scalar z12 = s_alpha_1 + k1 * c_alpha_1;
    const Scalar z13 = k1 * s_alpha_1 - c_alpha_1;
    const Scalar z14 = s_alpha_2 - k1 * c_alpha_2;
    const Scalar z15 = k1 * s_alpha_2 + c_alpha_2;
    const Scalar z16 = s_alpha_3 + k1 * c_alpha_3;
    const Scalar z17 = k1 * s_alpha_3 - c_alpha_3;
    const Scalar z18 = s_alpha_4 - k1 * c_alpha_4;
    const Scalar z19 = k1 * s_alpha_4 + c_alpha_4;
    const Scalar z20 = n0_05 * z2;
    const Scalar z21 = n0_05 * z5;
    const Scalar z22 = n0_05 * z8;
    const Scalar z23 = n0_05 * z11;
    const Scalar z24 = z2 * z20;
    const Scalar z25 = z5 * z21;
    const Scalar z26 = z8 * z22;
    const Scalar z27 = z11 * z23;
    precomputed.m_92c0037f = s_alpha_1;
    precomputed.m_c7906510 = c_alpha_1;
    precomputed.m_43ebfeb2 = s_alpha_2;
    precomputed.m_584e2578 = c_alpha_2;
    precomputed.m_4922d978 = s_alpha_3;
    precomputed.m_0a1afa2c = c_alpha_3;
    precomputed.m_2e8ec554 = s_alpha_4;
    precomputed.m_43b32f47 = c_alpha_4;
    precomputed.m_3cba4880 = z0;
    precomputed.m_6795f82c = z1;
    precomputed.m_1ecdcef4 = z2;
    precomputed.m_e2566af3 = z3;
    precomputed.m_cc38b7ab = z4;
    precomputed.m_7d206ec7 = z5;
    precomputed.m_d89552ed = z6;
    precomputed.m_f93fecf2 = z7;
    precomputed.m_e90afaf4 = z8;
    precomputed.m_d90c674e = z9;
    precomputed.m_e5df403d = z10;
    precomputed.m_47b4c84d = z11;
    precomputed.m_0e0985b8 = z12;
    precomputed.m_d2eddde9 = z13;
    precomputed.m_2a23efbc = z14;
    precomputed.m_85796129 = z15;
    precomputed.m_e00c27a7 = z16;
    precomputed.m_3b9dd6fa = z17;
    precomputed.m_8ec84cf7 = z18;
    precomputed.m_25022fbd = z19;
    precomputed.m_9d44cfff = z20;
    precomputed.m_6373fbbb = z21;
    precomputed.m_d5fafc4e = z22;
    precomputed.m_df0487e0 = z23;
    precomputed.m_0054f442 = z24;
    precomputed.m_b458bac9 = z25;
    precomputed.m_a1fc46ba = z26;
    precomputed.m_232b8723 = z27;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k2 = traits::constant(2.732050807568877, 2.732051f, "1;0;1;0");
    const Scalar k3 = traits::constant(9.428090415820634, 9.42809f, "0;20/3;0;0");
    const Scalar n40_over_3 = traits::constant(13.333333333333334, 13.333333f, "40/3");
    const Scalar k5 = traits::constant(11.547005383792515, 11.547006f, "0;0;20/3;0");
    const Scalar n20_over_3 = traits::constant(6.666666666666667, 6.6666665f, "20/3");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.psi = n0;
    state.q.phi_1 = n0;
    state.q.phi_2 = n0;
    state.q.phi_3 = n0;
    state.q.phi_4 = n0;
    state.q.s_1 = n0;
    state.q.s_2 = n0;
    state.q.s_3 = n0;
    state.q.s_4 = n0;
    state.v.x = n1;
    state.v.y = k2;
    state.v.psi = -n1;
    state.v.phi_1 = -k3;
    state.v.phi_2 = -n40_over_3;
    state.v.phi_3 = -k5;
    state.v.phi_4 = -n20_over_3;
    state.v.s_1 = n0;
    state.v.s_2 = n0;
    state.v.s_3 = n0;
    state.v.s_4 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> chassis_position;  ///< centre of mass of chassis [m]
    std::array<Scalar, 9> chassis_rotation;  ///< from the axes of chassis to the ground's (3 x 3)
    std::array<Scalar, 3> chassis_velocity;  ///< velocity of the centre of mass of chassis [m/s]
    std::array<Scalar, 3> chassis_angular_velocity;  ///< angular velocity of chassis [rad/s]
    std::array<Scalar, 3> wheel_1_position;  ///< centre of mass of wheel_1 [m]
    std::array<Scalar, 9> wheel_1_rotation;  ///< from the axes of wheel_1 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_1_velocity;  ///< velocity of the centre of mass of wheel_1 [m/s]
    std::array<Scalar, 3> wheel_1_angular_velocity;  ///< angular velocity of wheel_1 [rad/s]
    std::array<Scalar, 3> wheel_2_position;  ///< centre of mass of wheel_2 [m]
    std::array<Scalar, 9> wheel_2_rotation;  ///< from the axes of wheel_2 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_2_velocity;  ///< velocity of the centre of mass of wheel_2 [m/s]
    std::array<Scalar, 3> wheel_2_angular_velocity;  ///< angular velocity of wheel_2 [rad/s]
    std::array<Scalar, 3> wheel_3_position;  ///< centre of mass of wheel_3 [m]
    std::array<Scalar, 9> wheel_3_rotation;  ///< from the axes of wheel_3 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_3_velocity;  ///< velocity of the centre of mass of wheel_3 [m/s]
    std::array<Scalar, 3> wheel_3_angular_velocity;  ///< angular velocity of wheel_3 [rad/s]
    std::array<Scalar, 3> wheel_4_position;  ///< centre of mass of wheel_4 [m]
    std::array<Scalar, 9> wheel_4_rotation;  ///< from the axes of wheel_4 to the ground's (3 x 3)
    std::array<Scalar, 3> wheel_4_velocity;  ///< velocity of the centre of mass of wheel_4 [m/s]
    std::array<Scalar, 3> wheel_4_angular_velocity;  ///< angular velocity of wheel_4 [rad/s]
    std::array<Scalar, 3> P1_position;  ///< position of P1 [m]
    std::array<Scalar, 3> P1_velocity;  ///< velocity of the material point at P1 [m/s]
    std::array<Scalar, 33> P1_jacobian;  ///< partial velocities of P1 (3 x 11)
    std::array<Scalar, 3> P2_position;  ///< position of P2 [m]
    std::array<Scalar, 3> P2_velocity;  ///< velocity of the material point at P2 [m/s]
    std::array<Scalar, 33> P2_jacobian;  ///< partial velocities of P2 (3 x 11)
    std::array<Scalar, 3> P3_position;  ///< position of P3 [m]
    std::array<Scalar, 3> P3_velocity;  ///< velocity of the material point at P3 [m/s]
    std::array<Scalar, 33> P3_jacobian;  ///< partial velocities of P3 (3 x 11)
    std::array<Scalar, 3> P4_position;  ///< position of P4 [m]
    std::array<Scalar, 3> P4_velocity;  ///< velocity of the material point at P4 [m/s]
    std::array<Scalar, 33> P4_jacobian;  ///< partial velocities of P4 (3 x 11)
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
    std::array<Scalar, 8> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 8> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 88> jacobian;  ///< A, stored column by column (8 x 11)
    std::array<Scalar, 8> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z0 = q_psi + p_alpha_1;
    const Scalar z1 = q_psi + p_alpha_2;
    const Scalar z2 = q_psi + p_alpha_3;
    const Scalar z3 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4, z0, z1, z2, z3};
    Scalar sines_[9], cosines_[9];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z4 = sines_[5], z5 = cosines_[5];
    const Scalar z6 = sines_[6], z7 = cosines_[6];
    const Scalar z8 = sines_[7], z9 = cosines_[7];
    const Scalar z10 = sines_[8], z11 = cosines_[8];
    const Scalar z12 = k0 * v_psi;
    const Scalar z13 = s_psi - k0 * c_psi;
    const Scalar z14 = k0 * s_psi + c_psi;
    const Scalar z15 = s_psi + k0 * c_psi;
    const Scalar z16 = v_x - v_psi * c_psi - s_psi * z12;  // velocity of steered_1, x
    const Scalar z17 = v_y - v_psi * s_psi + c_psi * z12;  // velocity of steered_1, y
    const Scalar z18 = v_x - v_psi * c_psi + s_psi * z12;  // velocity of steered_2, x
    const Scalar z19 = v_y - v_psi * s_psi - c_psi * z12;  // velocity of steered_2, y
    const Scalar z20 = v_x + v_psi * c_psi + s_psi * z12;  // velocity of steered_3, x
    const Scalar z21 = v_y + v_psi * s_psi - c_psi * z12;  // velocity of steered_3, y
    const Scalar z22 = v_x + v_psi * c_psi - s_psi * z12;  // velocity of steered_4, x
    const Scalar z23 = v_y + v_psi * s_psi + c_psi * z12;  // velocity of steered_4, y
    const Scalar z24 = k0 * s_psi - c_psi;
    const Scalar z25 = v_psi * q_s_1;
    const Scalar z26 = v_psi * q_s_2;
    const Scalar z27 = v_psi * q_s_3;
    const Scalar z28 = q_s_1 * z5;
    const Scalar z29 = q_s_1 * z4;
    const Scalar z30 = q_s_2 * z7;
    const Scalar z31 = q_s_2 * z6;
    const Scalar z32 = q_s_3 * z9;
    const Scalar z33 = c_phi_1 * z4;
    const Scalar z34 = s_phi_1 * z4;
    const Scalar z35 = c_phi_1 * z5;
    const Scalar z36 = s_phi_1 * z5;
    const Scalar z37 = v_phi_1 * z5;  // angular velocity of wheel_1, x
    const Scalar z38 = v_phi_1 * z4;  // angular velocity of wheel_1, y
    const Scalar z39 = c_phi_2 * z6;
    const Scalar z40 = s_phi_2 * z6;
    const Scalar z41 = c_phi_2 * z7;
    const Scalar z42 = s_phi_2 * z7;
    const Scalar z43 = v_phi_2 * z7;  // angular velocity of wheel_2, x
    const Scalar z44 = v_phi_2 * z6;  // angular velocity of wheel_2, y
    const Scalar z45 = c_phi_3 * z8;
    const Scalar z46 = s_phi_3 * z8;
    const Scalar z47 = c_phi_3 * z9;
    const Scalar z48 = s_phi_3 * z9;
    const Scalar z49 = v_phi_3 * z9;  // angular velocity of wheel_3, x
    const Scalar z50 = v_phi_3 * z8;  // angular velocity of wheel_3, y
    const Scalar z51 = q_s_3 * z8;
    const Scalar z52 = q_s_4 * z11;
    const Scalar z53 = q_s_4 * z10;
    const Scalar z54 = q_x - z13;  // place of steered_1, x
    const Scalar z55 = q_y + z14;  // place of steered_1, y
    const Scalar z56 = c_phi_4 * z10;
    const Scalar z57 = s_phi_4 * z10;
    const Scalar z58 = v_psi * q_s_4;
    const Scalar z59 = q_x - z15;  // place of steered_2, x
    const Scalar z60 = q_y - z24;  // place of steered_2, y
    const Scalar z61 = q_x + z13;  // place of steered_3, x
    const Scalar z62 = q_y - z14;  // place of steered_3, y
    const Scalar z63 = q_x + z15;  // place of steered_4, x
    const Scalar z64 = q_y + z24;  // place of steered_4, y
    const Scalar z65 = z54 + z28;  // place of axle_1, x
    const Scalar z66 = c_phi_4 * z11;
    const Scalar z67 = z55 + z29;  // place of axle_1, y
    const Scalar z68 = s_phi_4 * z11;
    const Scalar z69 = v_phi_4 * z11;  // angular velocity of wheel_4, x
    const Scalar z70 = z59 + z30;  // place of axle_2, x
    const Scalar z71 = z60 + z31;  // place of axle_2, y
    const Scalar z72 = z61 + z32;  // place of axle_3, x
    const Scalar z73 = z62 + z51;  // place of axle_3, y
    const Scalar z74 = z63 + z52;  // place of axle_4, x
    const Scalar z75 = z64 + z53;  // place of axle_4, y
    const Scalar z76 = z16 + v_s_1 * z5 - z4 * z25;  // velocity of axle_1, x
    const Scalar z77 = v_phi_4 * z10;  // angular velocity of wheel_4, y
    const Scalar z78 = z17 + v_s_1 * z4 + z5 * z25;  // velocity of axle_1, y
    const Scalar z79 = z13 - z28;
    const Scalar z80 = z13 + z32;
    const Scalar z81 = z14 + z29;
    const Scalar z82 = z15 - z30;
    const Scalar z83 = z24 - z31;
    const Scalar z84 = z18 + v_s_2 * z7 - z6 * z26;  // velocity of axle_2, x
    const Scalar z85 = z19 + v_s_2 * z6 + z7 * z26;  // velocity of axle_2, y
    const Scalar z86 = z20 + v_s_3 * z9 - z8 * z27;  // velocity of axle_3, x
    const Scalar z87 = z21 + v_s_3 * z8 + z9 * z27;  // velocity of axle_3, y
    const Scalar z88 = z22 + v_s_4 * z11 - z10 * z58;  // velocity of axle_4, x
    const Scalar z89 = z23 + v_s_4 * z10 + z11 * z58;  // velocity of axle_4, y
    const Scalar z90 = z14 - z51;
    const Scalar z91 = z15 + z52;
    const Scalar z92 = z24 + z53;
    result.chassis_position[0] = q_x;
    result.chassis_position[1] = q_y;
    result.chassis_position[2] = n0_3;
    result.chassis_rotation[0] = c_psi;
    result.chassis_rotation[1] = s_psi;
    result.chassis_rotation[2] = n0;
    result.chassis_rotation[3] = -s_psi;
    result.chassis_rotation[4] = c_psi;
    result.chassis_rotation[5] = n0;
    result.chassis_rotation[6] = n0;
    result.chassis_rotation[7] = n0;
    result.chassis_rotation[8] = n1;
    result.chassis_velocity[0] = v_x;
    result.chassis_velocity[1] = v_y;
    result.chassis_velocity[2] = n0;
    result.chassis_angular_velocity[0] = n0;
    result.chassis_angular_velocity[1] = n0;
    result.chassis_angular_velocity[2] = v_psi;
    result.wheel_1_position[0] = z65;
    result.wheel_1_position[1] = z67;
    result.wheel_1_position[2] = n0_3;
    result.wheel_1_rotation[0] = z5;
    result.wheel_1_rotation[1] = z4;
    result.wheel_1_rotation[2] = n0;
    result.wheel_1_rotation[3] = -z33;
    result.wheel_1_rotation[4] = z35;
    result.wheel_1_rotation[5] = s_phi_1;
    result.wheel_1_rotation[6] = z34;
    result.wheel_1_rotation[7] = -z36;
    result.wheel_1_rotation[8] = c_phi_1;
    result.wheel_1_velocity[0] = z76;
    result.wheel_1_velocity[1] = z78;
    result.wheel_1_velocity[2] = n0;
    result.wheel_1_angular_velocity[0] = z37;
    result.wheel_1_angular_velocity[1] = z38;
    result.wheel_1_angular_velocity[2] = v_psi;
    result.wheel_2_position[0] = z70;
    result.wheel_2_position[1] = z71;
    result.wheel_2_position[2] = n0_3;
    result.wheel_2_rotation[0] = z7;
    result.wheel_2_rotation[1] = z6;
    result.wheel_2_rotation[2] = n0;
    result.wheel_2_rotation[3] = -z39;
    result.wheel_2_rotation[4] = z41;
    result.wheel_2_rotation[5] = s_phi_2;
    result.wheel_2_rotation[6] = z40;
    result.wheel_2_rotation[7] = -z42;
    result.wheel_2_rotation[8] = c_phi_2;
    result.wheel_2_velocity[0] = z84;
    result.wheel_2_velocity[1] = z85;
    result.wheel_2_velocity[2] = n0;
    result.wheel_2_angular_velocity[0] = z43;
    result.wheel_2_angular_velocity[1] = z44;
    result.wheel_2_angular_velocity[2] = v_psi;
    result.wheel_3_position[0] = z72;
    result.wheel_3_position[1] = z73;
    result.wheel_3_position[2] = n0_3;
    result.wheel_3_rotation[0] = z9;
    result.wheel_3_rotation[1] = z8;
    result.wheel_3_rotation[2] = n0;
    result.wheel_3_rotation[3] = -z45;
    result.wheel_3_rotation[4] = z47;
    result.wheel_3_rotation[5] = s_phi_3;
    result.wheel_3_rotation[6] = z46;
    result.wheel_3_rotation[7] = -z48;
    result.wheel_3_rotation[8] = c_phi_3;
    result.wheel_3_velocity[0] = z86;
    result.wheel_3_velocity[1] = z87;
    result.wheel_3_velocity[2] = n0;
    result.wheel_3_angular_velocity[0] = z49;
    result.wheel_3_angular_velocity[1] = z50;
    result.wheel_3_angular_velocity[2] = v_psi;
    result.wheel_4_position[0] = z74;
    result.wheel_4_position[1] = z75;
    result.wheel_4_position[2] = n0_3;
    result.wheel_4_rotation[0] = z11;
    result.wheel_4_rotation[1] = z10;
    result.wheel_4_rotation[2] = n0;
    result.wheel_4_rotation[3] = -z56;
    result.wheel_4_rotation[4] = z66;
    result.wheel_4_rotation[5] = s_phi_4;
    result.wheel_4_rotation[6] = z57;
    result.wheel_4_rotation[7] = -z68;
    result.wheel_4_rotation[8] = c_phi_4;
    result.wheel_4_velocity[0] = z88;
    result.wheel_4_velocity[1] = z89;
    result.wheel_4_velocity[2] = n0;
    result.wheel_4_angular_velocity[0] = z69;
    result.wheel_4_angular_velocity[1] = z77;
    result.wheel_4_angular_velocity[2] = v_psi;
    result.P1_position[0] = z65;
    result.P1_position[1] = z67;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = z76;
    result.P1_velocity[1] = z78;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = -z81;
    result.P1_jacobian[9] = n0;
    result.P1_jacobian[12] = n0;
    result.P1_jacobian[15] = n0;
    result.P1_jacobian[18] = n0;
    result.P1_jacobian[21] = z5;
    result.P1_jacobian[24] = n0;
    result.P1_jacobian[27] = n0;
    result.P1_jacobian[30] = n0;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z79;
    result.P1_jacobian[10] = n0;
    result.P1_jacobian[13] = n0;
    result.P1_jacobian[16] = n0;
    result.P1_jacobian[19] = n0;
    result.P1_jacobian[22] = z4;
    result.P1_jacobian[25] = n0;
    result.P1_jacobian[28] = n0;
    result.P1_jacobian[31] = n0;
    result.P1_jacobian[2] = n0;
    result.P1_jacobian[5] = n0;
    result.P1_jacobian[8] = n0;
    result.P1_jacobian[11] = n0;
    result.P1_jacobian[14] = n0;
    result.P1_jacobian[17] = n0;
    result.P1_jacobian[20] = n0;
    result.P1_jacobian[23] = n0;
    result.P1_jacobian[26] = n0;
    result.P1_jacobian[29] = n0;
    result.P1_jacobian[32] = n0;
    result.P2_position[0] = z70;
    result.P2_position[1] = z71;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = z84;
    result.P2_velocity[1] = z85;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z83;
    result.P2_jacobian[9] = n0;
    result.P2_jacobian[12] = n0;
    result.P2_jacobian[15] = n0;
    result.P2_jacobian[18] = n0;
    result.P2_jacobian[21] = n0;
    result.P2_jacobian[24] = z7;
    result.P2_jacobian[27] = n0;
    result.P2_jacobian[30] = n0;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = -z82;
    result.P2_jacobian[10] = n0;
    result.P2_jacobian[13] = n0;
    result.P2_jacobian[16] = n0;
    result.P2_jacobian[19] = n0;
    result.P2_jacobian[22] = n0;
    result.P2_jacobian[25] = z6;
    result.P2_jacobian[28] = n0;
    result.P2_jacobian[31] = n0;
    result.P2_jacobian[2] = n0;
    result.P2_jacobian[5] = n0;
    result.P2_jacobian[8] = n0;
    result.P2_jacobian[11] = n0;
    result.P2_jacobian[14] = n0;
    result.P2_jacobian[17] = n0;
    result.P2_jacobian[20] = n0;
    result.P2_jacobian[23] = n0;
    result.P2_jacobian[26] = n0;
    result.P2_jacobian[29] = n0;
    result.P2_jacobian[32] = n0;
    result.P3_position[0] = z72;
    result.P3_position[1] = z73;
    result.P3_position[2] = n0;
    result.P3_velocity[0] = z86;
    result.P3_velocity[1] = z87;
    result.P3_velocity[2] = n0;
    result.P3_jacobian[0] = n1;
    result.P3_jacobian[3] = n0;
    result.P3_jacobian[6] = z90;
    result.P3_jacobian[9] = n0;
    result.P3_jacobian[12] = n0;
    result.P3_jacobian[15] = n0;
    result.P3_jacobian[18] = n0;
    result.P3_jacobian[21] = n0;
    result.P3_jacobian[24] = n0;
    result.P3_jacobian[27] = z9;
    result.P3_jacobian[30] = n0;
    result.P3_jacobian[1] = n0;
    result.P3_jacobian[4] = n1;
    result.P3_jacobian[7] = z80;
    result.P3_jacobian[10] = n0;
    result.P3_jacobian[13] = n0;
    result.P3_jacobian[16] = n0;
    result.P3_jacobian[19] = n0;
    result.P3_jacobian[22] = n0;
    result.P3_jacobian[25] = n0;
    result.P3_jacobian[28] = z8;
    result.P3_jacobian[31] = n0;
    result.P3_jacobian[2] = n0;
    result.P3_jacobian[5] = n0;
    result.P3_jacobian[8] = n0;
    result.P3_jacobian[11] = n0;
    result.P3_jacobian[14] = n0;
    result.P3_jacobian[17] = n0;
    result.P3_jacobian[20] = n0;
    result.P3_jacobian[23] = n0;
    result.P3_jacobian[26] = n0;
    result.P3_jacobian[29] = n0;
    result.P3_jacobian[32] = n0;
    result.P4_position[0] = z74;
    result.P4_position[1] = z75;
    result.P4_position[2] = n0;
    result.P4_velocity[0] = z88;
    result.P4_velocity[1] = z89;
    result.P4_velocity[2] = n0;
    result.P4_jacobian[0] = n1;
    result.P4_jacobian[3] = n0;
    result.P4_jacobian[6] = -z92;
    result.P4_jacobian[9] = n0;
    result.P4_jacobian[12] = n0;
    result.P4_jacobian[15] = n0;
    result.P4_jacobian[18] = n0;
    result.P4_jacobian[21] = n0;
    result.P4_jacobian[24] = n0;
    result.P4_jacobian[27] = n0;
    result.P4_jacobian[30] = z11;
    result.P4_jacobian[1] = n0;
    result.P4_jacobian[4] = n1;
    result.P4_jacobian[7] = z91;
    result.P4_jacobian[10] = n0;
    result.P4_jacobian[13] = n0;
    result.P4_jacobian[16] = n0;
    result.P4_jacobian[19] = n0;
    result.P4_jacobian[22] = n0;
    result.P4_jacobian[25] = n0;
    result.P4_jacobian[28] = n0;
    result.P4_jacobian[31] = z10;
    result.P4_jacobian[2] = n0;
    result.P4_jacobian[5] = n0;
    result.P4_jacobian[8] = n0;
    result.P4_jacobian[11] = n0;
    result.P4_jacobian[14] = n0;
    result.P4_jacobian[17] = n0;
    result.P4_jacobian[20] = n0;
    result.P4_jacobian[23] = n0;
    result.P4_jacobian[26] = n0;
    result.P4_jacobian[29] = n0;
    result.P4_jacobian[32] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 121>& mass) noexcept {
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar k1 = traits::constant(14.641016151377546, 14.641016f, "-20;0;20;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(30.71796769724491, 30.717968f, "100;0;-40;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k5 = traits::constant(1.4641016151377546, 1.4641017f, "-2;0;2;0");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar q_psi = state.q.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar s_alpha_1 = precomputed.m_92c0037f;
    const Scalar c_alpha_1 = precomputed.m_c7906510;
    const Scalar s_alpha_2 = precomputed.m_43ebfeb2;
    const Scalar c_alpha_2 = precomputed.m_584e2578;
    const Scalar s_alpha_3 = precomputed.m_4922d978;
    const Scalar c_alpha_3 = precomputed.m_0a1afa2c;
    const Scalar s_alpha_4 = precomputed.m_2e8ec554;
    const Scalar c_alpha_4 = precomputed.m_43b32f47;
    const Scalar m8 = precomputed.m_3cba4880;
    const Scalar m9 = precomputed.m_6795f82c;
    const Scalar m10 = precomputed.m_1ecdcef4;
    const Scalar m11 = precomputed.m_e2566af3;
    const Scalar m12 = precomputed.m_cc38b7ab;
    const Scalar m13 = precomputed.m_7d206ec7;
    const Scalar m14 = precomputed.m_d89552ed;
    const Scalar m15 = precomputed.m_f93fecf2;
    const Scalar m16 = precomputed.m_e90afaf4;
    const Scalar m17 = precomputed.m_d90c674e;
    const Scalar m18 = precomputed.m_e5df403d;
    const Scalar m19 = precomputed.m_47b4c84d;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z0 = n20 * q_s_4;
    const Scalar z1 = n20 * q_s_3;
    const Scalar z2 = n20 * q_s_2;
    const Scalar z3 = n20 * q_s_1;
    const Scalar z4 = s_psi * m9 - c_psi * m8;
    const Scalar z5 = s_alpha_4 * z0;
    const Scalar z6 = s_alpha_3 * z1;
    const Scalar z7 = c_alpha_4 * z0;
    const Scalar z8 = c_alpha_3 * z1;
    const Scalar z9 = q_s_4 * z0;
    const Scalar z10 = s_alpha_2 * z2;
    const Scalar z11 = k1 + z7;
    const Scalar z12 = n20 - z5;
    const Scalar z13 = k1 - z8;
    const Scalar z14 = n20 - z6;
    const Scalar z15 = c_alpha_2 * z2;
    const Scalar z16 = n0_5 + z9;
    const Scalar z17 = q_s_3 * z1;
    const Scalar z18 = s_alpha_1 * z3;
    const Scalar z19 = z11 - z13;
    const Scalar z20 = z12 + z14;
    const Scalar z21 = k1 - z15;
    const Scalar z22 = n20 + z10;
    const Scalar z23 = c_alpha_1 * z3;
    const Scalar z24 = k3 - n2 * z5 + k5 * z7 + z16;
    const Scalar z25 = n0_5 + z17;
    const Scalar z26 = q_s_2 * z2;
    const Scalar z27 = z19 - z21;
    const Scalar z28 = z20 - z22;
    const Scalar z29 = k1 + z23;
    const Scalar z30 = n20 + z18;
    const Scalar z31 = n900 + z24;
    const Scalar z32 = k3 - n2 * z6 - k5 * z8 + z25;
    const Scalar z33 = n0_5 + z26;
    const Scalar z34 = q_s_1 * z3;
    const Scalar z35 = z27 + z29;
    const Scalar z36 = z28 - z30;
    const Scalar z37 = z31 + z32;
    const Scalar z38 = k3 + n2 * z10 - k5 * z15 + z33;
    const Scalar z39 = n0_5 + z34;
    const Scalar z40 = z37 + z38;
    const Scalar z41 = k3 + n2 * z18 + k5 * z23 + z39;
    const Scalar z42 = s_psi * m8 + c_psi * m9;
    const Scalar z43 = s_psi * m12 - c_psi * m11;
    const Scalar z44 = s_psi * m11 + c_psi * m12;
    const Scalar z45 = s_psi * m15 - c_psi * m14;
    const Scalar z46 = s_psi * m14 + c_psi * m15;
    const Scalar z47 = s_psi * m18 - c_psi * m17;
    const Scalar z48 = s_psi * m17 + c_psi * m18;
    const Scalar z49 = z40 + z41;
    const Scalar z50 = s_psi * z35 - c_psi * z36;
    const Scalar z51 = s_psi * z36 + c_psi * z35;
    mass[0] = n880;
    mass[1] = n0;
    mass[2] = -z50;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = -z47;
    mass[8] = -z45;
    mass[9] = -z43;
    mass[10] = -z4;
    mass[11] = n0;
    mass[12] = n880;
    mass[13] = z51;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = z48;
    mass[19] = z46;
    mass[20] = z44;
    mass[21] = z42;
    mass[22] = -z50;
    mass[23] = z51;
    mass[24] = z49;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = -m19;
    mass[30] = -m16;
    mass[31] = m13;
    mass[32] = m10;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0_9;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = n0;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0_9;
    mass[49] = n0;
    mass[50] = n0;
    mass[51] = n0;
    mass[52] = n0;
    mass[53] = n0;
    mass[54] = n0;
    mass[55] = n0;
    mass[56] = n0;
    mass[57] = n0;
    mass[58] = n0;
    mass[59] = n0;
    mass[60] = n0_9;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = n0;
    mass[66] = n0;
    mass[67] = n0;
    mass[68] = n0;
    mass[69] = n0;
    mass[70] = n0;
    mass[71] = n0;
    mass[72] = n0_9;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = n0;
    mass[76] = n0;
    mass[77] = -z47;
    mass[78] = z48;
    mass[79] = -m19;
    mass[80] = n0;
    mass[81] = n0;
    mass[82] = n0;
    mass[83] = n0;
    mass[84] = n20;
    mass[85] = n0;
    mass[86] = n0;
    mass[87] = n0;
    mass[88] = -z45;
    mass[89] = z46;
    mass[90] = -m16;
    mass[91] = n0;
    mass[92] = n0;
    mass[93] = n0;
    mass[94] = n0;
    mass[95] = n0;
    mass[96] = n20;
    mass[97] = n0;
    mass[98] = n0;
    mass[99] = -z43;
    mass[100] = z44;
    mass[101] = m13;
    mass[102] = n0;
    mass[103] = n0;
    mass[104] = n0;
    mass[105] = n0;
    mass[106] = n0;
    mass[107] = n0;
    mass[108] = n20;
    mass[109] = n0;
    mass[110] = -z4;
    mass[111] = z42;
    mass[112] = m10;
    mass[113] = n0;
    mass[114] = n0;
    mass[115] = n0;
    mass[116] = n0;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n20;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar s_alpha_1 = precomputed.m_92c0037f;
    const Scalar c_alpha_1 = precomputed.m_c7906510;
    const Scalar s_alpha_2 = precomputed.m_43ebfeb2;
    const Scalar c_alpha_2 = precomputed.m_584e2578;
    const Scalar s_alpha_3 = precomputed.m_4922d978;
    const Scalar c_alpha_3 = precomputed.m_0a1afa2c;
    const Scalar s_alpha_4 = precomputed.m_2e8ec554;
    const Scalar c_alpha_4 = precomputed.m_43b32f47;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z0 = v_psi * v_psi;
    const Scalar z1 = n2 * v_psi;
    const Scalar z2 = k1 * z0;
    const Scalar z3 = s_alpha_1 * z0 + c_alpha_1 * z2;
    const Scalar z4 = s_alpha_1 * z2 - c_alpha_1 * z0;
    const Scalar z5 = s_alpha_2 * z0 - c_alpha_2 * z2;
    const Scalar z6 = c_alpha_2 * z0 + s_alpha_2 * z2;
    const Scalar z7 = c_alpha_4 * z0 + s_alpha_4 * z2;
    const Scalar z8 = s_alpha_3 * z2 - c_alpha_3 * z0;
    const Scalar z9 = v_s_2 * z1 - z6;
    const Scalar z10 = v_s_4 * z1 + z7;
    const Scalar z11 = s_alpha_3 * z0 + c_alpha_3 * z2;
    const Scalar z12 = s_alpha_4 * z0 - c_alpha_4 * z2;
    const Scalar z13 = v_s_3 * z1 - z8;
    const Scalar z14 = n20 * z10;  // force on axle_4, y
    const Scalar z15 = n20 * z9;  // force on axle_2, y
    const Scalar z16 = q_s_3 * z0 - z11;
    const Scalar z17 = q_s_4 * z0 - z12;
    const Scalar z18 = v_s_1 * z1 + z4;
    const Scalar z19 = q_s_4 * z14;  // moment on steered_4, z
    const Scalar z20 = n20 * z13;  // force on axle_3, y
    const Scalar z21 = q_s_2 * z15;  // moment on steered_2, z
    const Scalar z22 = q_s_2 * z0 + z5;
    const Scalar z23 = n20 * z17;  // force on axle_4, x
    const Scalar z24 = n20 * z16;  // force on axle_3, x
    const Scalar z25 = q_s_3 * z20;  // moment on steered_3, z
    const Scalar z26 = n20 * z18;  // force on axle_1, y
    const Scalar z27 = q_s_1 * z0 + z3;
    const Scalar z28 = n20 * z22;  // force on axle_2, x
    const Scalar z29 = q_s_1 * z26;  // moment on steered_1, z
    const Scalar z30 = n20 * z27;  // force on axle_1, x
    const Scalar z31 = s_alpha_4 * z14 + c_alpha_4 * z23;
    const Scalar z32 = s_alpha_4 * z23 - c_alpha_4 * z14;
    const Scalar z33 = c_alpha_3 * z24 + s_alpha_3 * z20;
    const Scalar z34 = s_alpha_3 * z24 - c_alpha_3 * z20;
    const Scalar z35 = s_alpha_2 * z15 + c_alpha_2 * z28;
    const Scalar z36 = s_alpha_2 * z28 - c_alpha_2 * z15;
    const Scalar z37 = c_alpha_1 * z30 + s_alpha_1 * z26;
    const Scalar z38 = s_alpha_1 * z30 - c_alpha_1 * z26;
    const Scalar z39 = z31 + z33 + z35 + z37;  // force on S, x
    const Scalar z40 = z32 + z34 + z36 + z38;  // force on S, y
    const Scalar z41 = z19 + z21 + z25 + z29 - z31 - z33 + z35 + z37 - k1 * (z32 - z34 - z36 + z38);  // moment on S, z
    const Scalar z42 = s_psi * z40 - c_psi * z39;
    const Scalar z43 = s_psi * z39 + c_psi * z40;
    forces.x = z42;
    forces.y = -z43;
    forces.psi = z41;
    forces.phi_1 = n0;
    forces.phi_2 = n0;
    forces.phi_3 = n0;
    forces.phi_4 = n0;
    forces.s_1 = -z30;
    forces.s_2 = -z28;
    forces.s_3 = -z24;
    forces.s_4 = -z23;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar k3 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n800 = traits::constant(800.0, 800.0f, "800/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar a_s_1 = accelerations.s_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar a_s_2 = accelerations.s_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar a_s_3 = accelerations.s_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar a_s_4 = accelerations.s_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_2_x = multipliers.lambda_wheel_2_x;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_4_x = multipliers.lambda_wheel_4_x;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    const Scalar s_alpha_1 = precomputed.m_92c0037f;
    const Scalar c_alpha_1 = precomputed.m_c7906510;
    const Scalar s_alpha_2 = precomputed.m_43ebfeb2;
    const Scalar c_alpha_2 = precomputed.m_584e2578;
    const Scalar s_alpha_3 = precomputed.m_4922d978;
    const Scalar c_alpha_3 = precomputed.m_0a1afa2c;
    const Scalar s_alpha_4 = precomputed.m_2e8ec554;
    const Scalar c_alpha_4 = precomputed.m_43b32f47;
    const Scalar m8 = precomputed.m_0e0985b8;
    const Scalar m9 = precomputed.m_d2eddde9;
    const Scalar m10 = precomputed.m_2a23efbc;
    const Scalar m11 = precomputed.m_85796129;
    const Scalar m12 = precomputed.m_e00c27a7;
    const Scalar m13 = precomputed.m_3b9dd6fa;
    const Scalar m14 = precomputed.m_8ec84cf7;
    const Scalar m15 = precomputed.m_25022fbd;
    const Scalar z0 = q_psi + p_alpha_1;
    const Scalar z1 = q_psi + p_alpha_2;
    const Scalar z2 = q_psi + p_alpha_3;
    const Scalar z3 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, z0, z1, z2, z3};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar z4 = sines_[1], z5 = cosines_[1];
    const Scalar z6 = sines_[2], z7 = cosines_[2];
    const Scalar z8 = sines_[3], z9 = cosines_[3];
    const Scalar z10 = sines_[4], z11 = cosines_[4];
    const Scalar z12 = v_psi * v_psi;
    const Scalar z13 = a_x * c_psi + a_y * s_psi;
    const Scalar z14 = a_x * s_psi - a_y * c_psi;
    const Scalar z15 = n2 * v_psi;
    const Scalar z16 = n0_5 * a_psi;
    const Scalar z17 = n0_9 * a_phi_4;  // moment on wheel_4, x
    const Scalar z18 = n0_9 * a_phi_3;  // moment on wheel_3, x
    const Scalar z19 = n0_9 * a_phi_2;  // moment on wheel_2, x
    const Scalar z20 = n0_9 * a_phi_1;  // moment on wheel_1, x
    const Scalar z21 = q_s_1 + m8;
    const Scalar z22 = q_s_2 + m10;
    const Scalar z23 = q_s_3 - m12;
    const Scalar z24 = a_psi + k3 * z12 - z13;
    const Scalar z25 = q_s_4 - m14;
    const Scalar z26 = k3 * a_psi - z12 - z14;
    const Scalar z27 = a_psi - k3 * z12 - z13;
    const Scalar z28 = k3 * a_psi + z12 + z14;
    const Scalar z29 = a_psi + k3 * z12 + z13;
    const Scalar z30 = k3 * a_psi - z12 + z14;
    const Scalar z31 = a_psi - k3 * z12 + z13;
    const Scalar z32 = k3 * a_psi + z12 - z14;
    const Scalar z33 = s_alpha_1 * z26 - c_alpha_1 * z24;
    const Scalar z34 = s_alpha_1 * z24 + c_alpha_1 * z26;
    const Scalar z35 = s_alpha_2 * z28 + c_alpha_2 * z27;
    const Scalar z36 = s_alpha_2 * z27 - c_alpha_2 * z28;
    const Scalar z37 = s_alpha_3 * z30 - c_alpha_3 * z29;
    const Scalar z38 = s_alpha_3 * z29 + c_alpha_3 * z30;
    const Scalar z39 = s_alpha_4 * z32 + c_alpha_4 * z31;
    const Scalar z40 = s_alpha_4 * z31 - c_alpha_4 * z32;
    const Scalar z41 = q_s_1 * z12 - a_s_1 - z33;
    const Scalar z42 = z34 + a_psi * q_s_1 + v_s_1 * z15;
    const Scalar z43 = q_s_2 * z12 - a_s_2 + z35;
    const Scalar z44 = z36 + a_psi * q_s_2 + v_s_2 * z15;
    const Scalar z45 = q_s_3 * z12 - a_s_3 + z37;
    const Scalar z46 = a_psi * q_s_3 - z38 + v_s_3 * z15;
    const Scalar z47 = q_s_4 * z12 - a_s_4 - z39;
    const Scalar z48 = a_psi * q_s_4 - z40 + v_s_4 * z15;
    const Scalar z49 = n20 * z47;  // force on axle_4, x
    const Scalar z50 = n20 * z45;  // force on axle_3, x
    const Scalar z51 = n20 * z43;  // force on axle_2, x
    const Scalar z52 = n20 * z41;  // force on axle_1, x
    const Scalar z53 = n20 * z48;  // force on axle_4, y
    const Scalar z54 = n20 * z46;  // force on axle_3, y
    const Scalar z55 = n20 * z44;  // force on axle_2, y
    const Scalar z56 = n20 * z42;  // force on axle_1, y
    const Scalar z57 = q_s_4 * z53 + z16;  // moment on steered_4, z
    const Scalar z58 = c_alpha_4 * z49 + s_alpha_4 * z53;
    const Scalar z59 = s_alpha_4 * z49 - c_alpha_4 * z53;
    const Scalar z60 = q_s_3 * z54 + z16;  // moment on steered_3, z
    const Scalar z61 = c_alpha_3 * z50 + s_alpha_3 * z54;
    const Scalar z62 = s_alpha_3 * z50 - c_alpha_3 * z54;
    const Scalar z63 = q_s_2 * z55 + z16;  // moment on steered_2, z
    const Scalar z64 = c_alpha_2 * z51 + s_alpha_2 * z55;
    const Scalar z65 = s_alpha_2 * z51 - c_alpha_2 * z55;
    const Scalar z66 = c_alpha_1 * z52 + s_alpha_1 * z56;
    const Scalar z67 = s_alpha_1 * z52 - c_alpha_1 * z56;
    const Scalar z68 = z58 + z61 + z64 + z66;  // force on S, x
    const Scalar z69 = z59 + z62 + z65 + z67;  // force on S, y
    const Scalar z70 = q_s_1 * z56 + z16;  // moment on steered_1, z
    // moment on S, z
    const Scalar z71 = n900 * a_psi + z57 - z58 + z60 - z61 + z63 + z64 + z70 + z66 - k3 * (z59 - z62 - z65 + z67);
    const Scalar z72 = s_psi * z69 - c_psi * z68;
    const Scalar z73 = s_psi * z68 + c_psi * z69;
    const Scalar z74 = n800 * a_x + z72;  // force on S.y, x
    const Scalar z75 = n800 * a_y - z73;  // force on S.y, y
    forces.x = -l_lambda_wheel_1_x * z5 + l_lambda_wheel_1_y * z4 - l_lambda_wheel_2_x * z7 + l_lambda_wheel_2_y * z6
        - l_lambda_wheel_3_x * z9 + l_lambda_wheel_3_y * z8 - l_lambda_wheel_4_x * z11 + l_lambda_wheel_4_y * z10 + z74;
    forces.y = -l_lambda_wheel_1_x * z4 - l_lambda_wheel_1_y * z5 - l_lambda_wheel_2_x * z6 - l_lambda_wheel_2_y * z7
        - l_lambda_wheel_3_x * z8 - l_lambda_wheel_3_y * z9 - l_lambda_wheel_4_x * z10 - l_lambda_wheel_4_y * z11 + z75;
    forces.psi = -m9 * l_lambda_wheel_1_x + m11 * l_lambda_wheel_2_x + m13 * l_lambda_wheel_3_x - m15
        * l_lambda_wheel_4_x - l_lambda_wheel_1_y * z21 - l_lambda_wheel_2_y * z22 - l_lambda_wheel_3_y * z23
        - l_lambda_wheel_4_y * z25 + z71;
    forces.phi_1 = -n0_3 * l_lambda_wheel_1_y + z20;
    forces.phi_2 = -n0_3 * l_lambda_wheel_2_y + z19;
    forces.phi_3 = -n0_3 * l_lambda_wheel_3_y + z18;
    forces.phi_4 = -n0_3 * l_lambda_wheel_4_y + z17;
    forces.s_1 = -l_lambda_wheel_1_x - z52;
    forces.s_2 = -l_lambda_wheel_2_x - z51;
    forces.s_3 = -l_lambda_wheel_3_x - z50;
    forces.s_4 = -l_lambda_wheel_4_x - z49;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k4 = traits::constant(30.71796769724491, 30.717968f, "100;0;-40;0");
    const Scalar k5 = traits::constant(1.4641016151377546, 1.4641017f, "-2;0;2;0");
    const Scalar k6 = traits::constant(14.641016151377546, 14.641016f, "-20;0;20;0");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar s_alpha_1 = precomputed.m_92c0037f;
    const Scalar c_alpha_1 = precomputed.m_c7906510;
    const Scalar s_alpha_2 = precomputed.m_43ebfeb2;
    const Scalar c_alpha_2 = precomputed.m_584e2578;
    const Scalar s_alpha_3 = precomputed.m_4922d978;
    const Scalar c_alpha_3 = precomputed.m_0a1afa2c;
    const Scalar s_alpha_4 = precomputed.m_2e8ec554;
    const Scalar c_alpha_4 = precomputed.m_43b32f47;
    const Scalar m8 = precomputed.m_0e0985b8;
    const Scalar m9 = precomputed.m_d2eddde9;
    const Scalar m10 = precomputed.m_2a23efbc;
    const Scalar m11 = precomputed.m_85796129;
    const Scalar m12 = precomputed.m_e00c27a7;
    const Scalar m13 = precomputed.m_3b9dd6fa;
    const Scalar m14 = precomputed.m_8ec84cf7;
    const Scalar m15 = precomputed.m_25022fbd;
    const Scalar m16 = precomputed.m_3cba4880;
    const Scalar m17 = precomputed.m_6795f82c;
    const Scalar m18 = precomputed.m_e2566af3;
    const Scalar m19 = precomputed.m_cc38b7ab;
    const Scalar m20 = precomputed.m_d89552ed;
    const Scalar m21 = precomputed.m_f93fecf2;
    const Scalar m22 = precomputed.m_d90c674e;
    const Scalar m23 = precomputed.m_e5df403d;
    const Scalar m24 = precomputed.m_9d44cfff;
    const Scalar m25 = precomputed.m_6373fbbb;
    const Scalar m26 = precomputed.m_d5fafc4e;
    const Scalar m27 = precomputed.m_df0487e0;
    const Scalar m28 = precomputed.m_0054f442;
    const Scalar m29 = precomputed.m_b458bac9;
    const Scalar m30 = precomputed.m_a1fc46ba;
    const Scalar m31 = precomputed.m_232b8723;
    const Scalar z0 = q_psi + p_alpha_1;
    const Scalar z1 = q_psi + p_alpha_2;
    const Scalar z2 = q_psi + p_alpha_3;
    const Scalar z3 = q_psi + p_alpha_4;
    const Scalar angles_[] = {q_psi, z0, z1, z2, z3};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar z4 = sines_[1], z5 = cosines_[1];
    const Scalar z6 = sines_[2], z7 = cosines_[2];
    const Scalar z8 = sines_[3], z9 = cosines_[3];
    const Scalar z10 = sines_[4], z11 = cosines_[4];
    const Scalar z12 = q_s_4 - m14;
    const Scalar z13 = q_s_3 - m12;
    const Scalar z14 = q_s_2 + m10;
    const Scalar z15 = v_psi * v_psi;
    const Scalar z16 = n2 * v_psi;
    const Scalar z17 = q_s_1 + m8;
    const Scalar z18 = k1 * z15;
    const Scalar z19 = v_psi * z5;
    const Scalar z20 = v_psi * z7;
    const Scalar z21 = v_psi * z9;
    const Scalar z22 = v_psi * z11;
    const Scalar z23 = v_psi * z4;
    const Scalar z24 = s_alpha_3 * z15 + c_alpha_3 * z18;
    const Scalar z25 = s_alpha_4 * z15 - c_alpha_4 * z18;
    const Scalar z26 = c_alpha_4 * z15 + s_alpha_4 * z18;
    const Scalar z27 = s_alpha_2 * z15 - c_alpha_2 * z18;
    const Scalar z28 = c_alpha_2 * z15 + s_alpha_2 * z18;
    const Scalar z29 = s_alpha_3 * z18 - c_alpha_3 * z15;
    const Scalar z30 = q_s_3 * z15 - z24;
    const Scalar z31 = q_s_4 * z15 - z25;
    const Scalar z32 = v_s_4 * z16 + z26;
    const Scalar z33 = s_alpha_1 * z15 + c_alpha_1 * z18;
    const Scalar z34 = q_s_2 * z15 + z27;
    const Scalar z35 = v_s_2 * z16 - z28;
    const Scalar z36 = v_s_3 * z16 - z29;
    const Scalar z37 = n20 * z31;  // force on axle_4, x
    const Scalar z38 = n20 * z32;  // force on axle_4, y
    const Scalar z39 = n20 * z30;  // force on axle_3, x
    const Scalar z40 = s_alpha_1 * z18 - c_alpha_1 * z15;
    const Scalar z41 = q_s_1 * z15 + z33;
    const Scalar z42 = n20 * z36;  // force on axle_3, y
    const Scalar z43 = n20 * z34;  // force on axle_2, x
    const Scalar z44 = n20 * z35;  // force on axle_2, y
    const Scalar z45 = v_s_1 * z16 + z40;
    const Scalar z46 = n20 * z41;  // force on axle_1, x
    const Scalar z47 = s_alpha_4 * z38 + c_alpha_4 * z37;
    const Scalar z48 = s_alpha_4 * z37 - c_alpha_4 * z38;
    const Scalar z49 = c_alpha_3 * z39 + s_alpha_3 * z42;
    const Scalar z50 = n20 * z45;  // force on axle_1, y
    const Scalar z51 = q_s_4 * z38;  // moment on steered_4, z
    const Scalar z52 = s_alpha_3 * z39 - c_alpha_3 * z42;
    const Scalar z53 = q_s_3 * z42;  // moment on steered_3, z
    const Scalar z54 = s_alpha_2 * z44 + c_alpha_2 * z43;
    const Scalar z55 = s_alpha_2 * z43 - c_alpha_2 * z44;
    const Scalar z56 = q_s_2 * z44;  // moment on steered_2, z
    const Scalar z57 = c_alpha_1 * z46 + s_alpha_1 * z50;
    const Scalar z58 = s_alpha_1 * z46 - c_alpha_1 * z50;
    const Scalar z59 = q_s_1 * z50;  // moment on steered_1, z
    const Scalar z60 = z51 + z56 + z53 + z59 - z47 - z49 + z54 + z57 - k1 * (z48 - z52 - z55 + z58);  // moment on S, z
    const Scalar z61 = z47 + z49 + z54 + z57;  // force on S, x
    const Scalar z62 = z48 + z52 + z55 + z58;  // force on S, y
    const Scalar z63 = s_psi * z62 - c_psi * z61;
    const Scalar z64 = v_psi * z6;
    const Scalar z65 = v_psi * z8;
    const Scalar z66 = v_psi * z10;
    const Scalar z67 = v_x * z23 - v_y * z19;
    const Scalar z68 = s_psi * z61 + c_psi * z62;
    const Scalar z69 = v_x * z19 + v_y * z23 - v_psi * v_s_1;
    const Scalar z70 = n20 * q_s_4;
    const Scalar z71 = q_s_4 * z70;
    const Scalar z72 = s_psi * m16 + c_psi * m17;
    const Scalar z73 = s_psi * m17 - c_psi * m16;
    const Scalar z74 = v_x * z64 - v_y * z20;
    const Scalar z75 = v_x * z20 + v_y * z64 - v_psi * v_s_2;
    const Scalar z76 = n0_5 + z71;
    const Scalar z77 = s_alpha_4 * z70;
    const Scalar z78 = c_alpha_4 * z70;
    const Scalar z79 = k4 - n2 * z77 + k5 * z78 + z76;
    const Scalar z80 = k6 + z78;
    const Scalar z81 = v_x * z65 - v_y * z21;
    const Scalar z82 = v_x * z21 + v_y * z65 - v_psi * v_s_3;
    const Scalar z83 = n20 - z77;
    const Scalar z84 = n20 * q_s_3;
    const Scalar z85 = s_psi * m18 + c_psi * m19;
    const Scalar z86 = s_psi * m19 - c_psi * m18;
    const Scalar z87 = n900 + z79;
    const Scalar z88 = v_x * z66 - v_y * z22;
    const Scalar z89 = v_x * z22 + v_y * z66 - v_psi * v_s_4;
    const Scalar z90 = s_alpha_3 * z84;
    const Scalar z91 = n20 * q_s_2;
    const Scalar z92 = s_alpha_2 * z91;
    const Scalar z93 = n20 * q_s_1;
    const Scalar z94 = c_alpha_3 * z84;
    const Scalar z95 = q_s_3 * z84;
    const Scalar z96 = n0_5 + z95;
    const Scalar z97 = s_alpha_1 * z93;
    const Scalar z98 = c_alpha_2 * z91;
    const Scalar z99 = q_s_2 * z91;
    const Scalar z100 = n0_5 + z99;
    const Scalar z101 = c_alpha_1 * z93;
    const Scalar z102 = k4 - n2 * z90 - k5 * z94 + z96;
    const Scalar z103 = q_s_1 * z93;
    const Scalar z104 = n20 - z90;
    const Scalar z105 = z83 + z104;
    const Scalar z106 = k4 + n2 * z92 - k5 * z98 + z100;
    const Scalar z107 = z87 + z102;
    const Scalar z108 = n0_5 + z103;
    const Scalar z109 = k6 - z94;
    const Scalar z110 = z80 - z109;
    const Scalar z111 = n20 + z92;
    const Scalar z112 = z107 + z106;
    const Scalar z113 = z105 - z111;
    const Scalar z114 = k4 + n2 * z97 + k5 * z101 + z108;
    const Scalar z115 = z112 + z114;
    const Scalar z116 = k6 - z98;
    const Scalar z117 = z110 - z116;
    const Scalar z118 = n20 + z97;
    const Scalar z119 = z113 - z118;
    const Scalar z120 = k6 + z101;
    const Scalar z121 = m28 - z115;
    const Scalar z122 = n0_05 * z72;
    const Scalar z123 = z117 + z120;
    const Scalar z124 = n880 - z72 * z122;
    const Scalar z125 = n0_05 * z85;
    const Scalar z126 = m29 + z121;
    const Scalar z127 = s_psi * m20 + c_psi * m21;
    const Scalar z128 = z85 * z125 - z124;
    const Scalar z129 = m30 + z126;
    const Scalar z130 = s_psi * z119 + c_psi * z123;
    const Scalar z131 = s_psi * z123 - c_psi * z119;
    const Scalar z132 = m24 * z72 - z130;
    const Scalar z133 = m31 + z129;
    const Scalar z134 = m24 * z73 - z131;
    const Scalar z135 = n0_05 * z127;
    const Scalar z136 = z127 * z135 + z128;
    const Scalar z137 = m25 * z85 + z132;
    const Scalar z138 = s_psi * m22 + c_psi * m23;
    const Scalar z139 = m25 * z86 + z134;
    const Scalar z140 = m26 * z127 - z137;
    const Scalar z141 = n0_05 * z138;
    const Scalar z142 = n0_05 * z73;
    const Scalar z143 = z138 * z141 + z136;
    const Scalar z144 = z73 * z122;
    const Scalar z145 = n880 - z73 * z142;
    const Scalar z146 = m27 * z138 + z140;
    const Scalar z147 = z86 * z125 + z144;
    const Scalar z148 = n0_05 * z86;
    const Scalar z149 = z86 * z148 - z145;
    const Scalar z150 = s_psi * m21 - c_psi * m20;
    const Scalar z151 = n1 / z133;
    const Scalar z152 = z150 * z135 + z147;
    const Scalar z153 = m26 * z150 - z139;
    const Scalar z154 = z146 * z151;
    const Scalar z155 = n0_05 * z150;
    const Scalar z156 = z143 - z146 * z154;
    const Scalar z157 = z150 * z155 + z149;
    const Scalar z158 = s_psi * m23 - c_psi * m22;
    const Scalar z159 = z158 * z141 + z152;
    const Scalar z160 = m27 * z158 + z153;
    const Scalar z161 = n1 / z156;
    const Scalar z162 = n0_05 * z158;
    const Scalar z163 = z158 * z162 + z157;
    const Scalar z164 = z159 - z160 * z154;
    const Scalar z165 = z160 * z151;
    const Scalar z166 = z9 + z13 * z154;
    const Scalar z167 = z8 - z125;
    const Scalar z168 = z163 - z160 * z165;
    const Scalar z169 = z10 - z122;
    const Scalar z170 = z7 + z14 * z154;
    const Scalar z171 = z6 - z135;
    const Scalar z172 = z5 + z17 * z154;
    const Scalar z173 = z4 - z141;
    const Scalar z174 = z164 * z161;
    const Scalar z175 = z168 - z164 * z174;
    const Scalar z176 = z5 + z162 + z174 * z173;
    const Scalar z177 = z4 + z17 * z165 - z174 * z172;
    const Scalar z178 = z11 + z142 + z174 * z169;
    const Scalar z179 = z8 + z13 * z165 - z174 * z166;
    const Scalar z180 = z9 + z148 + z174 * z167;
    const Scalar z181 = n1 / z175;
    const Scalar z182 = z6 + z14 * z165 - z174 * z170;
    const Scalar z183 = z7 + z155 + z174 * z171;
    const Scalar z184 = z181 * z176;
    const Scalar z185 = z181 * z177;
    const Scalar z186 = z181 * z183;
    const Scalar z187 = z181 * z182;
    const Scalar z188 = z181 * z180;
    const Scalar z189 = z181 * z179;
    const Scalar z190 = z181 * z178;
    const Scalar z191 = z161 * z173 + z174 * z184;
    const Scalar z192 = z11 + z12 * z154;
    const Scalar z193 = z161 * z172 - z174 * z185;
    const Scalar z194 = z161 * z171 + z174 * z186;
    const Scalar z195 = z161 * z170 - z174 * z187;
    const Scalar z196 = z161 * z167 + z174 * z188;
    const Scalar z197 = z161 * z169 + z174 * z190;
    const Scalar z198 = z161 * z166 - z174 * z189;
    const Scalar z199 = z165 * z190 - z154 * z197;
    const Scalar z200 = z13 * z151 + z165 * z189 + z154 * z198;
    const Scalar z201 = n0_05 - z142 * z190 + z122 * z197 - m24 * z199;
    const Scalar z202 = z142 * z189 + z122 * z198 + m24 * z200;
    const Scalar z203 = z165 * z188 - z154 * z196;
    const Scalar z204 = z142 * z188 - z122 * z196 + m24 * z203;
    const Scalar z205 = z14 * z151 + z165 * z187 + z154 * z195;
    const Scalar z206 = n0_05 - z148 * z188 + z125 * z196 - m25 * z203;
    const Scalar z207 = z142 * z187 + z122 * z195 + m24 * z205;
    const Scalar z208 = z148 * z187 + z125 * z195 + m25 * z205;
    const Scalar z209 = z165 * z186 - z154 * z194;
    const Scalar z210 = z142 * z186 - z122 * z194 + m24 * z209;
    const Scalar z211 = z148 * z186 - z125 * z194 + m25 * z209;
    const Scalar z212 = z17 * z151 + z165 * z185 + z154 * z193;
    const Scalar z213 = n0_05 - z155 * z186 + z135 * z194 + m26 * z209;
    const Scalar z214 = z142 * z185 + z122 * z193 + m24 * z212;
    const Scalar z215 = m26 * z212 - z155 * z185 - z135 * z193;
    const Scalar z216 = z148 * z185 + z125 * z193 + m25 * z212;
    const Scalar z217 = z165 * z184 - z154 * z191;
    const Scalar z218 = z10 + z12 * z165 - z174 * z192;
    const Scalar z219 = z142 * z184 - z122 * z191 + m24 * z217;
    const Scalar z220 = n0_05 - z162 * z184 + z141 * z191 + m27 * z217;
    const Scalar z221 = z181 * z218;
    const Scalar z222 = z135 * z191 - z155 * z184 + m26 * z217;
    const Scalar z223 = z161 * z192 - z174 * z221;
    const Scalar z224 = z148 * z184 - z125 * z191 + m25 * z217;
    const Scalar z225 = z12 * z151 + z165 * z221 + z154 * z223;
    const Scalar z226 = z4 * z184 - z5 * z191 + z17 * z217;
    const Scalar z227 = z220 + m9 * z217 - z5 * z184 - z4 * z191;
    const Scalar z228 = m27 * z212 - z162 * z185 - z141 * z193;
    const Scalar z229 = n0_1 - z6 * z187 - z7 * z195 - z14 * z205;
    const Scalar z230 = z6 * z186 - z7 * z194 + z14 * z209;
    const Scalar z231 = z7 * z186 + z6 * z194 + m11 * z209 - z213;
    const Scalar z232 = m11 * z212 - z6 * z193 + z7 * z185 - z215;
    const Scalar z233 = z6 * z185 + z7 * z193 + z14 * z212;
    const Scalar z234 = n0_1 - z4 * z185 - z5 * z193 - z17 * z212;
    const Scalar z235 = z7 * z184 + z6 * z191 + m11 * z217 - z222;
    const Scalar z236 = z6 * z184 - z7 * z191 + z14 * z217;
    const Scalar z237 = z9 * z184 + z8 * z191 + m13 * z217 + z224;
    const Scalar z238 = z141 * z194 - z162 * z186 + m27 * z209;
    const Scalar z239 = z8 * z188 - z9 * z196 + z13 * z203;
    const Scalar z240 = z9 * z188 + z8 * z196 + m13 * z203 - z206;
    const Scalar z241 = z9 * z187 - z8 * z195 + m13 * z205 + z208;
    const Scalar z242 = z8 * z187 + z9 * z195 + z13 * z205;
    const Scalar z243 = z9 * z186 + z8 * z194 + m13 * z209 + z211;
    const Scalar z244 = z8 * z186 - z9 * z194 + z13 * z209;
    const Scalar z245 = z9 * z185 - z8 * z193 + m13 * z212 + z216;
    const Scalar z246 = z8 * z185 + z9 * z193 + z13 * z212;
    const Scalar z247 = z8 * z184 - z9 * z191 + z13 * z217;
    const Scalar z248 = m27 * z205 - z162 * z187 - z141 * z195;
    const Scalar z249 = n0_1 - z8 * z189 - z9 * z198 - z13 * z200;
    const Scalar z250 = m26 * z205 - z155 * z187 - z135 * z195;
    const Scalar z251 = z201 + m15 * z199 - z11 * z190 - z10 * z197;
    const Scalar z252 = z10 * z198 - z202 - z11 * z189 + m15 * z200;
    const Scalar z253 = m15 * z203 - z204 - z11 * z188 - z10 * z196;
    const Scalar z254 = z10 * z195 - z207 - z11 * z187 + m15 * z205;
    const Scalar z255 = m15 * z209 - z210 - z11 * z186 - z10 * z194;
    const Scalar z256 = z10 * z193 - z214 - z11 * z185 + m15 * z212;
    const Scalar z257 = m15 * z217 - z219 - z11 * z184 - z10 * z191;
    const Scalar z258 = z10 * z184 - z11 * z191 + z12 * z217;
    const Scalar z259 = z141 * z196 - z162 * z188 + m27 * z203;
    const Scalar z260 = z10 * z185 + z11 * z193 + z12 * z212;
    const Scalar z261 = z135 * z196 - z155 * z188 + m26 * z203;
    const Scalar z262 = n0_1 - z10 * z221 - z11 * z223 - z12 * z225;
    const Scalar z263 = z10 * z190 - z11 * z197 + z12 * z199;
    const Scalar z264 = n1 / z262;
    const Scalar z265 = z10 * z189 + z11 * z198 + z12 * z200;
    const Scalar z266 = z10 * z188 - z11 * z196 + z12 * z203;
    const Scalar z267 = z10 * z187 + z11 * z195 + z12 * z205;
    const Scalar z268 = z10 * z186 - z11 * z194 + z12 * z209;
    const Scalar z269 = z258 * z264;
    const Scalar z270 = m27 * z200 - z162 * z189 - z141 * z198;
    const Scalar z271 = z260 * z264;
    const Scalar z272 = m26 * z200 - z155 * z189 - z135 * z198;
    const Scalar z273 = z268 * z264;
    const Scalar z274 = z148 * z189 + z125 * z198 + m25 * z200;
    const Scalar z275 = z226 + z258 * z271;
    const Scalar z276 = z263 * z264;
    const Scalar z277 = z265 * z264;
    const Scalar z278 = z266 * z264;
    const Scalar z279 = z267 * z264;
    const Scalar z280 = z234 - z260 * z271;
    const Scalar z281 = z227 - z258 * z269;
    const Scalar z282 = z141 * z197 - z162 * z190 + m27 * z199;
    const Scalar z283 = z235 + z258 * z273;
    const Scalar z284 = z135 * z197 - z155 * z190 + m26 * z199;
    const Scalar z285 = z232 + z260 * z273;
    const Scalar z286 = z148 * z190 - z125 * z197 + m25 * z199;
    const Scalar z287 = z230 + z268 * z279;
    const Scalar z288 = z233 + z260 * z279;
    const Scalar z289 = z245 + z260 * z278;
    const Scalar z290 = z236 + z258 * z279;
    const Scalar z291 = z237 + z258 * z278;
    const Scalar z292 = z229 - z267 * z279;
    const Scalar z293 = z231 + z268 * z273;
    const Scalar z294 = m27 * z225 - z162 * z221 - z141 * z223;
    const Scalar z295 = z243 + z268 * z278;
    const Scalar z296 = m26 * z225 - z155 * z221 - z135 * z223;
    const Scalar z297 = z241 + z267 * z278;
    const Scalar z298 = z148 * z221 + z125 * z223 + m25 * z225;
    const Scalar z299 = z240 + z266 * z278;
    const Scalar z300 = z142 * z221 + z122 * z223 + m24 * z225;
    const Scalar z301 = z251 - z263 * z276;
    const Scalar z302 = z252 - z265 * z276;
    const Scalar z303 = n1 / z301;
    const Scalar z304 = z249 - z265 * z277;
    const Scalar z305 = z239 + z266 * z277;
    const Scalar z306 = z253 - z266 * z276;
    const Scalar z307 = z242 + z267 * z277;
    const Scalar z308 = z254 - z267 * z276;
    const Scalar z309 = z244 + z268 * z277;
    const Scalar z310 = z255 - z268 * z276;
    const Scalar z311 = z246 + z260 * z277;
    const Scalar z312 = z256 - z260 * z276;
    const Scalar z313 = z247 + z258 * z277;
    const Scalar z314 = z257 - z258 * z276;
    const Scalar z315 = z314 * z303;
    const Scalar z316 = z302 * z303;
    const Scalar z317 = z306 * z303;
    const Scalar z318 = z308 * z303;
    const Scalar z319 = z310 * z303;
    const Scalar z320 = z312 * z303;
    const Scalar z321 = z281 - z314 * z315;
    const Scalar z322 = z304 - z302 * z316;
    const Scalar z323 = z305 + z306 * z316;
    const Scalar z324 = z299 + z306 * z317;
    const Scalar z325 = z297 + z308 * z317;
    const Scalar z326 = n1 / z322;
    const Scalar z327 = z307 + z308 * z316;
    const Scalar z328 = z292 - z308 * z318;
    const Scalar z329 = z287 + z310 * z318;
    const Scalar z330 = z295 + z310 * z317;
    const Scalar z331 = z309 + z310 * z316;
    const Scalar z332 = z293 + z310 * z319;
    const Scalar z333 = z285 + z312 * z319;
    const Scalar z334 = z288 + z312 * z318;
    const Scalar z335 = z289 + z312 * z317;
    const Scalar z336 = z311 + z312 * z316;
    const Scalar z337 = z280 - z312 * z320;
    const Scalar z338 = z275 + z314 * z320;
    const Scalar z339 = z283 + z314 * z319;
    const Scalar z340 = z290 + z314 * z318;
    const Scalar z341 = z291 + z314 * z317;
    const Scalar z342 = z313 + z314 * z316;
    const Scalar z343 = m24 * z37 + m25 * z39 - m26 * z43 - m27 * z46 + z60;
    const Scalar z344 = z37 * z122 - z68 + z39 * z125 + z43 * z135 + z46 * z141 + z154 * z343;
    const Scalar z345 = z37 * z142 - z63 + z39 * z148 + z43 * z155 + z46 * z162 + z165 * z343 - z174 * z344;
    const Scalar z346 = z181 * z345;
    const Scalar z347 = z323 * z326;
    const Scalar z348 = z324 + z323 * z347;
    const Scalar z349 = z325 + z327 * z347;
    const Scalar z350 = z161 * z344 - z174 * z346;
    const Scalar z351 = z330 + z331 * z347;
    const Scalar z352 = n1 / z348;
    const Scalar z353 = z335 + z336 * z347;
    const Scalar z354 = z341 + z342 * z347;
    const Scalar z355 = z327 * z326;
    const Scalar z356 = z328 - z327 * z355;
    const Scalar z357 = z329 + z331 * z355;
    const Scalar z358 = z334 + z336 * z355;
    const Scalar z359 = z340 + z342 * z355;
    const Scalar z360 = z331 * z326;
    const Scalar z361 = z332 + z331 * z360;
    const Scalar z362 = z333 + z336 * z360;
    const Scalar z363 = z339 + z342 * z360;
    const Scalar z364 = z336 * z326;
    const Scalar z365 = z337 - z336 * z364;
    const Scalar z366 = z338 + z342 * z364;
    const Scalar z367 = z349 * z352;
    const Scalar z368 = z351 * z352;
    const Scalar z369 = z353 * z352;
    const Scalar z370 = z342 * z326;
    const Scalar z371 = z151 * z343 + z165 * z346 + z154 * z350;
    const Scalar z372 = n0_05 * z46 - z162 * z346 - z141 * z350 + m27 * z371;
    const Scalar z373 = n0_05 * z43 - z155 * z346 - z135 * z350 + m26 * z371;
    const Scalar z374 = z148 * z346 - n0_05 * z39 + z125 * z350 + m25 * z371;
    const Scalar z375 = z142 * z346 - n0_05 * z37 + z122 * z350 + m24 * z371;
    const Scalar z376 = z356 + z349 * z367;
    const Scalar z377 = z321 - z342 * z370;
    const Scalar z378 = z4 * z346 - z69 + z5 * z350 + z17 * z371;
    const Scalar z379 = z6 * z346 - z75 + z7 * z350 + z14 * z371;
    const Scalar z380 = z8 * z346 - z82 + z9 * z350 + z13 * z371;
    const Scalar z381 = z10 * z346 - z89 + z11 * z350 + z12 * z371;
    const Scalar z382 = z357 - z351 * z367;
    const Scalar z383 = z361 - z351 * z368;
    const Scalar z384 = n1 / z376;
    const Scalar z385 = z362 - z353 * z368;
    const Scalar z386 = z358 - z353 * z367;
    const Scalar z387 = z365 + z353 * z369;
    const Scalar z388 = z366 - z354 * z369;
    const Scalar z389 = z363 - z354 * z368;
    const Scalar z390 = z359 - z354 * z367;
    const Scalar z391 = z4 * z350 - z67 - z5 * z346 + m9 * z371 + z372;
    const Scalar z392 = z74 + z7 * z346 - z6 * z350 + m11 * z371 - z373;
    const Scalar z393 = z81 + z9 * z346 - z8 * z350 + m13 * z371 + z374;
    const Scalar z394 = z10 * z350 - z88 - z11 * z346 + m15 * z371 - z375;
    const Scalar z395 = z276 * z381 - z394;
    const Scalar z396 = z382 * z384;
    const Scalar z397 = z383 + z382 * z396;
    const Scalar z398 = z385 + z386 * z396;
    const Scalar z399 = z389 + z390 * z396;
    const Scalar z400 = z380 + z277 * z381 - z316 * z395;
    const Scalar z401 = n1 / z397;
    const Scalar z402 = z386 * z384;
    const Scalar z403 = z387 - z386 * z402;
    const Scalar z404 = z388 + z390 * z402;
    const Scalar z405 = z393 + z278 * z381 - z317 * z395 + z347 * z400;
    const Scalar z406 = z379 + z279 * z381 - z318 * z395 + z355 * z400 - z367 * z405;
    const Scalar z407 = z392 + z273 * z381 - z319 * z395 + z360 * z400 - z368 * z405 + z396 * z406;
    const Scalar z408 = z398 * z401;
    const Scalar z409 = z403 + z398 * z408;
    const Scalar z410 = z404 - z399 * z408;
    const Scalar z411 = z378 + z271 * z381 - z320 * z395 + z364 * z400 - z369 * z405 + z402 * z406 - z408 * z407;
    const Scalar z412 = n1 / z409;
    const Scalar z413 = z354 * z352;
    const Scalar z414 = z377 + z354 * z413;
    const Scalar z415 = z234 + z229 + z249 + z262 - z231 - z240 + z227 + z251;
    const Scalar z416 = z390 * z384;
    const Scalar z417 = z414 - z390 * z416;
    const Scalar z418 = z399 * z401;
    const Scalar z419 = z410 * z412;
    const Scalar z420 = z417 + z399 * z418;
    const Scalar z421 = z269 * z381 - z391 - z315 * z395 + z370 * z400 - z413 * z405 + z416 * z406 - z418 * z407 + z419
        * z411;
    const Scalar z422 = z420 - z410 * z419;
    const Scalar z423 = n1 / z422;
    const Scalar z424 = z423 * z421;
    const Scalar z425 = z412 * z411 + z419 * z424;
    const Scalar z426 = z401 * z407 + z418 * z424 + z408 * z425;
    const Scalar z427 = n1_over_3 * z425;
    const Scalar z428 = z384 * z406 + z416 * z424 + z402 * z425 - z396 * z426;
    const Scalar z429 = z352 * z405 + z413 * z424 + z369 * z425 - z368 * z426 + z367 * z428;
    const Scalar z430 = n1_over_3 * z428;
    const Scalar z431 = z326 * z400 + z370 * z424 + z364 * z425 - z360 * z426 + z355 * z428 - z347 * z429;
    const Scalar z432 = z303 * z395 - z315 * z424 - z320 * z425 + z319 * z426 - z318 * z428 + z317 * z429 - z316 * z431;
    const Scalar z433 = n1_over_3 * z431;
    const Scalar z434 = z264 * z381 + z269 * z424 + z271 * z425 - z273 * z426 + z279 * z428 - z278 * z429 + z277 * z431
        + z276 * z432;
    const Scalar z435 = z346 + z184 * z424 + z185 * z425 - z186 * z426 + z187 * z428 - z188 * z429 + z189 * z431 + z190
        * z432 + z221 * z434;
    const Scalar z436 = z191 * z424 - z350 - z193 * z425 - z194 * z426 - z195 * z428 - z196 * z429 - z198 * z431 + z197
        * z432 - z223 * z434;
    const Scalar z437 = z371 + z217 * z424 + z212 * z425 - z209 * z426 + z205 * z428 - z203 * z429 + z200 * z431 + z199
        * z432 + z225 * z434;
    const Scalar z438 = z372 + z220 * z424 + z228 * z425 - z238 * z426 + z248 * z428 - z259 * z429 + z270 * z431 + z282
        * z432 + z294 * z434;
    const Scalar z439 = z373 + z222 * z424 + z215 * z425 - z213 * z426 + z250 * z428 - z261 * z429 + z272 * z431 + z284
        * z432 + z296 * z434;
    const Scalar z440 = z374 + z224 * z424 + z216 * z425 - z211 * z426 + z208 * z428 + z206 * z429 + z274 * z431 + z286
        * z432 + z298 * z434;
    const Scalar z441 = n1_over_3 * z434;
    const Scalar z442 = z375 + z219 * z424 + z214 * z425 - z210 * z426 + z207 * z428 - z204 * z429 + z202 * z431 - z201
        * z432 + z300 * z434;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.x = -z435;
    accelerations.y = -z436;
    accelerations.psi = z437;
    accelerations.phi_1 = -z427;
    accelerations.phi_2 = -z430;
    accelerations.phi_3 = -z433;
    accelerations.phi_4 = -z441;
    accelerations.s_1 = z438;
    accelerations.s_2 = z439;
    accelerations.s_3 = -z440;
    accelerations.s_4 = -z442;
    multipliers.lambda_wheel_1_x = z424;
    multipliers.lambda_wheel_1_y = -z425;
    multipliers.lambda_wheel_2_x = -z426;
    multipliers.lambda_wheel_2_y = -z428;
    multipliers.lambda_wheel_3_x = -z429;
    multipliers.lambda_wheel_3_y = -z431;
    multipliers.lambda_wheel_4_x = z432;
    multipliers.lambda_wheel_4_y = -z434;
    const Scalar bound0_ = roundings_ * z415;
    if (!(traits::regular(-z175, n880) && traits::regular(-z156, n880) && traits::regular(-z133, z115)
        && traits::regular(z422, bound0_) && traits::regular(z409, bound0_) && traits::regular(-z397, bound0_)
        && traits::regular(z376, bound0_) && traits::regular(-z348, bound0_) && traits::regular(z322, bound0_)
        && traits::regular(z301, bound0_) && traits::regular(z262, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * accelerations.x * accelerations.y * accelerations.psi * accelerations.phi_1
        * accelerations.phi_2 * accelerations.phi_3 * accelerations.phi_4 * accelerations.s_1 * accelerations.s_2) * (n0
        * accelerations.s_3 * accelerations.s_4 * multipliers.lambda_wheel_1_x * multipliers.lambda_wheel_1_y
        * multipliers.lambda_wheel_2_x * multipliers.lambda_wheel_2_y * multipliers.lambda_wheel_3_x
        * multipliers.lambda_wheel_3_y * multipliers.lambda_wheel_4_x * multipliers.lambda_wheel_4_y);
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    return Mechanism::forward_dynamics(precomputed, state, Inputs(), accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar s_alpha_1 = precomputed.m_92c0037f;
    const Scalar c_alpha_1 = precomputed.m_c7906510;
    const Scalar s_alpha_2 = precomputed.m_43ebfeb2;
    const Scalar c_alpha_2 = precomputed.m_584e2578;
    const Scalar s_alpha_3 = precomputed.m_4922d978;
    const Scalar c_alpha_3 = precomputed.m_0a1afa2c;
    const Scalar s_alpha_4 = precomputed.m_2e8ec554;
    const Scalar c_alpha_4 = precomputed.m_43b32f47;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z0 = v_x * c_psi + v_y * s_psi;
    const Scalar z1 = v_x * s_psi - v_y * c_psi;
    const Scalar z2 = v_psi * s_phi_1;
    const Scalar z3 = v_psi * c_phi_1;
    const Scalar z4 = v_psi * s_phi_2;
    const Scalar z5 = v_psi * c_phi_2;
    const Scalar z6 = v_psi * s_phi_3;
    const Scalar z7 = v_psi * c_phi_3;
    const Scalar z8 = v_psi * s_phi_4;
    const Scalar z9 = v_psi * c_phi_4;
    const Scalar z10 = v_psi - z0;
    const Scalar z11 = k0 * v_psi - z1;
    const Scalar z12 = k0 * v_psi + z1;
    const Scalar z13 = v_psi + z0;
    const Scalar z14 = s_alpha_1 * z11 - c_alpha_1 * z10;
    const Scalar z15 = s_alpha_1 * z10 + c_alpha_1 * z11;
    const Scalar z16 = c_alpha_2 * z10 + s_alpha_2 * z12;
    const Scalar z17 = s_alpha_2 * z10 - c_alpha_2 * z12;
    const Scalar z18 = s_alpha_3 * z12 - c_alpha_3 * z13;
    const Scalar z19 = s_alpha_3 * z13 + c_alpha_3 * z12;
    const Scalar z20 = c_alpha_4 * z13 + s_alpha_4 * z11;
    const Scalar z21 = s_alpha_4 * z13 - c_alpha_4 * z11;
    const Scalar z22 = v_psi * q_s_1 + z15;
    const Scalar z23 = v_psi * q_s_2 + z17;
    const Scalar z24 = v_s_2 - z16;  // velocity of axle_2, x
    const Scalar z25 = v_psi * q_s_3 - z19;
    const Scalar z26 = v_psi * q_s_4 - z21;
    const Scalar z27 = v_s_4 + z20;  // velocity of axle_4, x
    const Scalar z28 = v_s_1 + z14;  // velocity of axle_1, x
    const Scalar z29 = v_s_3 - z18;  // velocity of axle_3, x
    const Scalar z30 = c_phi_1 * z22;
    const Scalar z31 = s_phi_1 * z22;
    const Scalar z32 = c_phi_2 * z23;
    const Scalar z33 = s_phi_2 * z23;
    const Scalar z34 = c_phi_3 * z25;
    const Scalar z35 = s_phi_3 * z25;
    const Scalar z36 = c_phi_4 * z26;
    const Scalar z37 = s_phi_4 * z26;
    result.kinetic = n450 * v_psi * v_psi + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3 * v_phi_3 + v_phi_4
        * v_phi_4) + n400 * (z0 * z0 + z1 * z1) + n0_25 * (z2 * z2 + z3 * z3 + z4 * z4 + z5 * z5 + z6 * z6 + z7 * z7
        + z8 * z8 + z9 * z9) + n10 * (z24 * z24 + z27 * z27 + z28 * z28 + z29 * z29 + z30 * z30 + z31 * z31 + z32 * z32
        + z33 * z33 + z34 * z34 + z35 * z35 + z36 * z36 + z37 * z37);
    result.force_function = n0;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar q_s_1 = state.q.s_1;
    const Scalar v_s_1 = state.v.s_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_s_2 = state.q.s_2;
    const Scalar v_s_2 = state.v.s_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_s_3 = state.q.s_3;
    const Scalar v_s_3 = state.v.s_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_s_4 = state.q.s_4;
    const Scalar v_s_4 = state.v.s_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar m0 = precomputed.m_0e0985b8;
    const Scalar m1 = precomputed.m_d2eddde9;
    const Scalar m2 = precomputed.m_2a23efbc;
    const Scalar m3 = precomputed.m_85796129;
    const Scalar m4 = precomputed.m_e00c27a7;
    const Scalar m5 = precomputed.m_3b9dd6fa;
    const Scalar m6 = precomputed.m_8ec84cf7;
    const Scalar m7 = precomputed.m_25022fbd;
    const Scalar z0 = q_psi + p_alpha_1;
    const Scalar z1 = q_psi + p_alpha_2;
    const Scalar z2 = q_psi + p_alpha_3;
    const Scalar z3 = q_psi + p_alpha_4;
    const Scalar angles_[] = {z0, z1, z2, z3};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z4 = sines_[0], z5 = cosines_[0];
    const Scalar z6 = sines_[1], z7 = cosines_[1];
    const Scalar z8 = sines_[2], z9 = cosines_[2];
    const Scalar z10 = sines_[3], z11 = cosines_[3];
    const Scalar z12 = v_psi * z5;
    const Scalar z13 = v_psi * z7;
    const Scalar z14 = v_psi * z9;
    const Scalar z15 = v_psi * z11;
    const Scalar z16 = q_s_1 + m0;
    const Scalar z17 = v_psi * z4;
    const Scalar z18 = q_s_2 + m2;
    const Scalar z19 = v_psi * z6;
    const Scalar z20 = q_s_3 - m4;
    const Scalar z21 = v_psi * z8;
    const Scalar z22 = q_s_4 - m6;
    const Scalar z23 = v_psi * z10;
    const Scalar z24 = v_psi * m1 + v_s_1 + v_x * z5 + v_y * z4;
    const Scalar z25 = v_x * z4 - v_y * z5 - v_psi * z16 - n0_3 * v_phi_1;
    const Scalar z26 = v_s_2 - v_psi * m3 + v_x * z7 + v_y * z6;
    const Scalar z27 = v_x * z6 - v_y * z7 - v_psi * z18 - n0_3 * v_phi_2;
    const Scalar z28 = v_s_3 - v_psi * m5 + v_x * z9 + v_y * z8;
    const Scalar z29 = v_x * z8 - v_y * z9 - v_psi * z20 - n0_3 * v_phi_3;
    const Scalar z30 = v_psi * m7 + v_s_4 + v_x * z11 + v_y * z10;
    const Scalar z31 = v_x * z10 - v_y * z11 - v_psi * z22 - n0_3 * v_phi_4;
    const Scalar z32 = v_x * z17 - v_y * z12;
    const Scalar z33 = v_x * z12 + v_y * z17 - v_psi * v_s_1;
    const Scalar z34 = v_x * z19 - v_y * z13;
    const Scalar z35 = v_x * z13 + v_y * z19 - v_psi * v_s_2;
    const Scalar z36 = v_x * z21 - v_y * z14;
    const Scalar z37 = v_x * z14 + v_y * z21 - v_psi * v_s_3;
    const Scalar z38 = v_x * z23 - v_y * z15;
    const Scalar z39 = v_x * z15 + v_y * z23 - v_psi * v_s_4;
    result.value[0] = n0;
    result.rate[0] = z24;
    result.gamma[0] = -z32;
    result.value[1] = n0;
    result.rate[1] = -z25;
    result.gamma[1] = -z33;
    result.value[2] = n0;
    result.rate[2] = z26;
    result.gamma[2] = -z34;
    result.value[3] = n0;
    result.rate[3] = -z27;
    result.gamma[3] = -z35;
    result.value[4] = n0;
    result.rate[4] = z28;
    result.gamma[4] = -z36;
    result.value[5] = n0;
    result.rate[5] = -z29;
    result.gamma[5] = -z37;
    result.value[6] = n0;
    result.rate[6] = z30;
    result.gamma[6] = -z38;
    result.value[7] = n0;
    result.rate[7] = -z31;
    result.gamma[7] = -z39;
    result.jacobian[0] = z5;
    result.jacobian[1] = -z4;
    result.jacobian[2] = z7;
    result.jacobian[3] = -z6;
    result.jacobian[4] = z9;
    result.jacobian[5] = -z8;
    result.jacobian[6] = z11;
    result.jacobian[7] = -z10;
    result.jacobian[8] = z4;
    result.jacobian[9] = z5;
    result.jacobian[10] = z6;
    result.jacobian[11] = z7;
    result.jacobian[12] = z8;
    result.jacobian[13] = z9;
    result.jacobian[14] = z10;
    result.jacobian[15] = z11;
    result.jacobian[16] = m1;
    result.jacobian[17] = z16;
    result.jacobian[18] = -m3;
    result.jacobian[19] = z18;
    result.jacobian[20] = -m5;
    result.jacobian[21] = z20;
    result.jacobian[22] = m7;
    result.jacobian[23] = z22;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0_3;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = n0;
    result.jacobian[35] = n0_3;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = n0;
    result.jacobian[45] = n0_3;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = n0;
    result.jacobian[53] = n0;
    result.jacobian[54] = n0;
    result.jacobian[55] = n0_3;
    result.jacobian[56] = n1;
    result.jacobian[57] = n0;
    result.jacobian[58] = n0;
    result.jacobian[59] = n0;
    result.jacobian[60] = n0;
    result.jacobian[61] = n0;
    result.jacobian[62] = n0;
    result.jacobian[63] = n0;
    result.jacobian[64] = n0;
    result.jacobian[65] = n0;
    result.jacobian[66] = n1;
    result.jacobian[67] = n0;
    result.jacobian[68] = n0;
    result.jacobian[69] = n0;
    result.jacobian[70] = n0;
    result.jacobian[71] = n0;
    result.jacobian[72] = n0;
    result.jacobian[73] = n0;
    result.jacobian[74] = n0;
    result.jacobian[75] = n0;
    result.jacobian[76] = n1;
    result.jacobian[77] = n0;
    result.jacobian[78] = n0;
    result.jacobian[79] = n0;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = n0;
    result.jacobian[85] = n0;
    result.jacobian[86] = n1;
    result.jacobian[87] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 121>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, Constraints&>(constraints));
  }
};

}  // namespace four_wheel_vehicle_all_wheels
