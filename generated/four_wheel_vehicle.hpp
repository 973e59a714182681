// SPDX-License-Identifier: MIT-0
// four_wheel_vehicle: Four-wheel vehicle whose wheels roll without slipping
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               32               51          0             0                  5       0     93      95
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                4          0             0                  0       0      4       4
//   inverse_dynamics         36               38          0             0                  1       0     76      83
//   forward_dynamics         68               97          0             0                  1       0    167     174
//   energy                   40               68          0             0                  5       0    118     142
//   constraints              32               49          0             0                  1       0     83      88
//
// Not computed because this mechanism does not need it:
//   kinematics: of 198 results 91 vanish identically, 30 repeat another up to sign
//   mass_matrix: of 49 results 42 vanish identically
//   bias: of 7 results 3 vanish identically
//   forward_dynamics: of 15 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 80 results 36 vanish identically, 13 repeat another up to sign
//
// Constraints:
//   Constraints that repeat others are left out, their multipliers are 0: wheel_3_x, wheel_4_x.
//   Indeterminate, as they are shared with those in a way that no motion tells: lambda_wheel_1_x, lambda_wheel_2_x.
//
// To write this file again:
//   four_wheel_vehicle_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --support torsor_support.hpp --output four_wheel_vehicle.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace four_wheel_vehicle {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 7> coordinates{{{"x", "m"}, {"y", "m"}, {"psi", "rad"},
      {"phi_1", "rad"}, {"phi_2", "rad"}, {"phi_3", "rad"}, {"phi_4", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 7> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"psi", "rad/s"},
      {"phi_1", "rad/s"}, {"phi_2", "rad/s"}, {"phi_3", "rad/s"}, {"phi_4", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> inputs{{{"C3", "N m"}, {"C4", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 8> multipliers{{{"lambda_wheel_1_x", "N"},
      {"lambda_wheel_1_y", "N"}, {"lambda_wheel_2_x", "N"}, {"lambda_wheel_2_y", "N"}, {"lambda_wheel_3_x", "N"},
      {"lambda_wheel_3_y", "N"}, {"lambda_wheel_4_x", "N"}, {"lambda_wheel_4_y", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
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
      3, 1, 1, "m/s"}, {"result", "P1_jacobian", 3, 7, 2, ""}, {"result", "P2_position", 3, 1, 1, "m"}, {"result",
      "P2_velocity", 3, 1, 1, "m/s"}, {"result", "P2_jacobian", 3, 7, 2, ""}, {"result", "P3_position", 3, 1, 1, "m"},
      {"result", "P3_velocity", 3, 1, 1, "m/s"}, {"result", "P3_jacobian", 3, 7, 2, ""}, {"result", "P4_position", 3, 1,
      1, "m"}, {"result", "P4_velocity", 3, 1, 1, "m/s"}, {"result", "P4_jacobian", 3, 7, 2, ""}, {"mass", "", 7, 7, 2,
      ""}, {"forces", "", 7, 1, 1, "N m"}, {"forces", "", 7, 1, 1, "N, N, N m, N m, N m, N m, N m"}, {"accelerations",
      "", 7, 1, 1, "m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2"}, {"multipliers", "", 8, 1, 1, "N"},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "value", 8, 1, 1, ""}, {"result", "rate", 8, 1, 1, "m/s"}, {"result", "jacobian", 8, 7, 2, ""},
      {"result", "gamma", 8, 1, 1, "m/s^2"}}};
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
  using Description = ::four_wheel_vehicle::Description;

  static constexpr const char* name = "four_wheel_vehicle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x0936925df88149e3ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 2;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 8;
  static constexpr int first_integral_count = 0;
  /// Multipliers that are taken as zero: their constraints repeat others.
  static constexpr int redundant_count = 2;
  static constexpr int redundant_multipliers[redundant_count] = {4, 6};

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad]
    Scalar phi_1;  ///< coordinate [rad]
    Scalar phi_2;  ///< coordinate [rad]
    Scalar phi_3;  ///< coordinate [rad]
    Scalar phi_4;  ///< coordinate [rad]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::phi_1, &Coordinates::phi_2, &Coordinates::phi_3, &Coordinates::phi_4};
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
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::phi_1,
          &Velocities::phi_2, &Velocities::phi_3, &Velocities::phi_4};
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
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::phi_1, &Accelerations::phi_2, &Accelerations::phi_3, &Accelerations::phi_4};
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
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::phi_1, &GeneralizedForces::phi_2, &GeneralizedForces::phi_3,
          &GeneralizedForces::phi_4};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar C3;  ///< motor [N m]
    Scalar C4;  ///< motor [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::C3, &Inputs::C4};
      return members_[i_];
    }
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_wheel_1_x;  ///< indeterminate, of the constraint wheel_1_x [N]
    Scalar lambda_wheel_1_y;  ///< of the constraint wheel_1_y [N]
    Scalar lambda_wheel_2_x;  ///< indeterminate, of the constraint wheel_2_x [N]
    Scalar lambda_wheel_2_y;  ///< of the constraint wheel_2_y [N]
    Scalar lambda_wheel_3_x;  ///< indeterminate, of the constraint wheel_3_x [N]
    Scalar lambda_wheel_3_y;  ///< of the constraint wheel_3_y [N]
    Scalar lambda_wheel_4_x;  ///< indeterminate, of the constraint wheel_4_x [N]
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
    state.v.x = n1;
    state.v.y = k2;
    state.v.psi = -n1;
    state.v.phi_1 = -k3;
    state.v.phi_2 = -n40_over_3;
    state.v.phi_3 = -k5;
    state.v.phi_4 = -n20_over_3;
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
    std::array<Scalar, 21> P1_jacobian;  ///< partial velocities of P1 (3 x 7)
    std::array<Scalar, 3> P2_position;  ///< position of P2 [m]
    std::array<Scalar, 3> P2_velocity;  ///< velocity of the material point at P2 [m/s]
    std::array<Scalar, 21> P2_jacobian;  ///< partial velocities of P2 (3 x 7)
    std::array<Scalar, 3> P3_position;  ///< position of P3 [m]
    std::array<Scalar, 3> P3_velocity;  ///< velocity of the material point at P3 [m/s]
    std::array<Scalar, 21> P3_jacobian;  ///< partial velocities of P3 (3 x 7)
    std::array<Scalar, 3> P4_position;  ///< position of P4 [m]
    std::array<Scalar, 3> P4_velocity;  ///< velocity of the material point at P4 [m/s]
    std::array<Scalar, 21> P4_jacobian;  ///< partial velocities of P4 (3 x 7)
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
    std::array<Scalar, 56> jacobian;  ///< A, stored column by column (8 x 7)
    std::array<Scalar, 8> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar k1 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar angles_[] = {q_psi, q_phi_1, q_phi_2, q_phi_3, q_phi_4};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_phi_1 = sines_[1], c_phi_1 = cosines_[1];
    const Scalar s_phi_2 = sines_[2], c_phi_2 = cosines_[2];
    const Scalar s_phi_3 = sines_[3], c_phi_3 = cosines_[3];
    const Scalar s_phi_4 = sines_[4], c_phi_4 = cosines_[4];
    const Scalar z0 = k0 * v_psi;
    const Scalar z1 = k1 * (s_psi + c_psi);
    const Scalar z2 = k1 * (s_psi - c_psi);
    const Scalar z3 = s_psi - k0 * c_psi;
    const Scalar z4 = k0 * s_psi + c_psi;
    const Scalar z5 = n0_5 * s_psi + k3 * c_psi;
    const Scalar z6 = k3 * s_psi - n0_5 * c_psi;
    const Scalar z7 = s_psi + k0 * c_psi;
    const Scalar z8 = k0 * s_psi - c_psi;
    const Scalar z9 = v_x - v_psi * c_psi - s_psi * z0;  // velocity of steered_1, x
    const Scalar z10 = v_y - v_psi * s_psi + c_psi * z0;  // velocity of steered_1, y
    const Scalar z11 = v_x - v_psi * c_psi + s_psi * z0;  // velocity of steered_2, x
    const Scalar z12 = v_y - v_psi * s_psi - c_psi * z0;  // velocity of steered_2, y
    const Scalar z13 = v_x + v_psi * c_psi + s_psi * z0;  // velocity of steered_3, x
    const Scalar z14 = v_y + v_psi * s_psi - c_psi * z0;  // velocity of steered_3, y
    const Scalar z15 = s_psi * c_phi_3;
    const Scalar z16 = s_psi * s_phi_3;
    const Scalar z17 = c_psi * c_phi_3;
    const Scalar z18 = c_psi * s_phi_3;
    const Scalar z19 = c_psi * v_phi_3;  // angular velocity of wheel_3, x
    const Scalar z20 = s_psi * v_phi_3;  // angular velocity of wheel_3, y
    const Scalar z21 = v_x + v_psi * c_psi - s_psi * z0;  // velocity of steered_4, x
    const Scalar z22 = v_y + v_psi * s_psi + c_psi * z0;  // velocity of steered_4, y
    const Scalar z23 = s_psi * c_phi_4;
    const Scalar z24 = s_psi * s_phi_4;
    const Scalar z25 = c_psi * c_phi_4;
    const Scalar z26 = c_psi * s_phi_4;
    const Scalar z27 = c_psi * v_phi_4;  // angular velocity of wheel_4, x
    const Scalar z28 = s_psi * v_phi_4;  // angular velocity of wheel_4, y
    const Scalar z29 = q_x - z3;  // place of steered_1, x
    const Scalar z30 = q_y + z4;  // place of steered_1, y
    const Scalar z31 = q_x - z7;  // place of steered_2, x
    const Scalar z32 = q_y - z8;  // place of steered_2, y
    const Scalar z33 = q_x + z3;  // place of steered_3, x
    const Scalar z34 = q_y - z4;  // place of steered_3, y
    const Scalar z35 = q_x + z7;  // place of steered_4, x
    const Scalar z36 = q_y + z8;  // place of steered_4, y
    const Scalar z37 = c_phi_1 * z2;
    const Scalar z38 = s_phi_1 * z2;
    const Scalar z39 = c_phi_1 * z1;
    const Scalar z40 = s_phi_1 * z1;
    const Scalar z41 = v_phi_1 * z1;  // angular velocity of wheel_1, x
    const Scalar z42 = v_phi_1 * z2;  // angular velocity of wheel_1, y
    const Scalar z43 = c_phi_2 * z6;
    const Scalar z44 = s_phi_2 * z6;
    const Scalar z45 = c_phi_2 * z5;
    const Scalar z46 = s_phi_2 * z5;
    const Scalar z47 = v_phi_2 * z5;  // angular velocity of wheel_2, x
    const Scalar z48 = v_phi_2 * z6;  // angular velocity of wheel_2, y
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
    result.wheel_1_position[0] = z29;
    result.wheel_1_position[1] = z30;
    result.wheel_1_position[2] = n0_3;
    result.wheel_1_rotation[0] = z1;
    result.wheel_1_rotation[1] = z2;
    result.wheel_1_rotation[2] = n0;
    result.wheel_1_rotation[3] = -z37;
    result.wheel_1_rotation[4] = z39;
    result.wheel_1_rotation[5] = s_phi_1;
    result.wheel_1_rotation[6] = z38;
    result.wheel_1_rotation[7] = -z40;
    result.wheel_1_rotation[8] = c_phi_1;
    result.wheel_1_velocity[0] = z9;
    result.wheel_1_velocity[1] = z10;
    result.wheel_1_velocity[2] = n0;
    result.wheel_1_angular_velocity[0] = z41;
    result.wheel_1_angular_velocity[1] = z42;
    result.wheel_1_angular_velocity[2] = v_psi;
    result.wheel_2_position[0] = z31;
    result.wheel_2_position[1] = z32;
    result.wheel_2_position[2] = n0_3;
    result.wheel_2_rotation[0] = z5;
    result.wheel_2_rotation[1] = z6;
    result.wheel_2_rotation[2] = n0;
    result.wheel_2_rotation[3] = -z43;
    result.wheel_2_rotation[4] = z45;
    result.wheel_2_rotation[5] = s_phi_2;
    result.wheel_2_rotation[6] = z44;
    result.wheel_2_rotation[7] = -z46;
    result.wheel_2_rotation[8] = c_phi_2;
    result.wheel_2_velocity[0] = z11;
    result.wheel_2_velocity[1] = z12;
    result.wheel_2_velocity[2] = n0;
    result.wheel_2_angular_velocity[0] = z47;
    result.wheel_2_angular_velocity[1] = z48;
    result.wheel_2_angular_velocity[2] = v_psi;
    result.wheel_3_position[0] = z33;
    result.wheel_3_position[1] = z34;
    result.wheel_3_position[2] = n0_3;
    result.wheel_3_rotation[0] = c_psi;
    result.wheel_3_rotation[1] = s_psi;
    result.wheel_3_rotation[2] = n0;
    result.wheel_3_rotation[3] = -z15;
    result.wheel_3_rotation[4] = z17;
    result.wheel_3_rotation[5] = s_phi_3;
    result.wheel_3_rotation[6] = z16;
    result.wheel_3_rotation[7] = -z18;
    result.wheel_3_rotation[8] = c_phi_3;
    result.wheel_3_velocity[0] = z13;
    result.wheel_3_velocity[1] = z14;
    result.wheel_3_velocity[2] = n0;
    result.wheel_3_angular_velocity[0] = z19;
    result.wheel_3_angular_velocity[1] = z20;
    result.wheel_3_angular_velocity[2] = v_psi;
    result.wheel_4_position[0] = z35;
    result.wheel_4_position[1] = z36;
    result.wheel_4_position[2] = n0_3;
    result.wheel_4_rotation[0] = c_psi;
    result.wheel_4_rotation[1] = s_psi;
    result.wheel_4_rotation[2] = n0;
    result.wheel_4_rotation[3] = -z23;
    result.wheel_4_rotation[4] = z25;
    result.wheel_4_rotation[5] = s_phi_4;
    result.wheel_4_rotation[6] = z24;
    result.wheel_4_rotation[7] = -z26;
    result.wheel_4_rotation[8] = c_phi_4;
    result.wheel_4_velocity[0] = z21;
    result.wheel_4_velocity[1] = z22;
    result.wheel_4_velocity[2] = n0;
    result.wheel_4_angular_velocity[0] = z27;
    result.wheel_4_angular_velocity[1] = z28;
    result.wheel_4_angular_velocity[2] = v_psi;
    result.P1_position[0] = z29;
    result.P1_position[1] = z30;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = z9;
    result.P1_velocity[1] = z10;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = -z4;
    result.P1_jacobian[9] = n0;
    result.P1_jacobian[12] = n0;
    result.P1_jacobian[15] = n0;
    result.P1_jacobian[18] = n0;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z3;
    result.P1_jacobian[10] = n0;
    result.P1_jacobian[13] = n0;
    result.P1_jacobian[16] = n0;
    result.P1_jacobian[19] = n0;
    result.P1_jacobian[2] = n0;
    result.P1_jacobian[5] = n0;
    result.P1_jacobian[8] = n0;
    result.P1_jacobian[11] = n0;
    result.P1_jacobian[14] = n0;
    result.P1_jacobian[17] = n0;
    result.P1_jacobian[20] = n0;
    result.P2_position[0] = z31;
    result.P2_position[1] = z32;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = z11;
    result.P2_velocity[1] = z12;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z8;
    result.P2_jacobian[9] = n0;
    result.P2_jacobian[12] = n0;
    result.P2_jacobian[15] = n0;
    result.P2_jacobian[18] = n0;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = -z7;
    result.P2_jacobian[10] = n0;
    result.P2_jacobian[13] = n0;
    result.P2_jacobian[16] = n0;
    result.P2_jacobian[19] = n0;
    result.P2_jacobian[2] = n0;
    result.P2_jacobian[5] = n0;
    result.P2_jacobian[8] = n0;
    result.P2_jacobian[11] = n0;
    result.P2_jacobian[14] = n0;
    result.P2_jacobian[17] = n0;
    result.P2_jacobian[20] = n0;
    result.P3_position[0] = z33;
    result.P3_position[1] = z34;
    result.P3_position[2] = n0;
    result.P3_velocity[0] = z13;
    result.P3_velocity[1] = z14;
    result.P3_velocity[2] = n0;
    result.P3_jacobian[0] = n1;
    result.P3_jacobian[3] = n0;
    result.P3_jacobian[6] = z4;
    result.P3_jacobian[9] = n0;
    result.P3_jacobian[12] = n0;
    result.P3_jacobian[15] = n0;
    result.P3_jacobian[18] = n0;
    result.P3_jacobian[1] = n0;
    result.P3_jacobian[4] = n1;
    result.P3_jacobian[7] = z3;
    result.P3_jacobian[10] = n0;
    result.P3_jacobian[13] = n0;
    result.P3_jacobian[16] = n0;
    result.P3_jacobian[19] = n0;
    result.P3_jacobian[2] = n0;
    result.P3_jacobian[5] = n0;
    result.P3_jacobian[8] = n0;
    result.P3_jacobian[11] = n0;
    result.P3_jacobian[14] = n0;
    result.P3_jacobian[17] = n0;
    result.P3_jacobian[20] = n0;
    result.P4_position[0] = z35;
    result.P4_position[1] = z36;
    result.P4_position[2] = n0;
    result.P4_velocity[0] = z21;
    result.P4_velocity[1] = z22;
    result.P4_velocity[2] = n0;
    result.P4_jacobian[0] = n1;
    result.P4_jacobian[3] = n0;
    result.P4_jacobian[6] = -z8;
    result.P4_jacobian[9] = n0;
    result.P4_jacobian[12] = n0;
    result.P4_jacobian[15] = n0;
    result.P4_jacobian[18] = n0;
    result.P4_jacobian[1] = n0;
    result.P4_jacobian[4] = n1;
    result.P4_jacobian[7] = z7;
    result.P4_jacobian[10] = n0;
    result.P4_jacobian[13] = n0;
    result.P4_jacobian[16] = n0;
    result.P4_jacobian[19] = n0;
    result.P4_jacobian[2] = n0;
    result.P4_jacobian[5] = n0;
    result.P4_jacobian[8] = n0;
    result.P4_jacobian[11] = n0;
    result.P4_jacobian[14] = n0;
    result.P4_jacobian[17] = n0;
    result.P4_jacobian[20] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 49>& mass) noexcept {
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k2 = traits::constant(1024.8718707889795, 1024.8718f, "1302;0;-160;0");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    mass[0] = n880;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n880;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = k2;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0_9;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0_9;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = n0_9;
    mass[41] = n0;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = n0;
    mass[48] = n0_9;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z0 = n3 * v_phi_1;
    const Scalar z1 = n3 * v_phi_2;
    const Scalar z2 = n3 * v_phi_3;
    const Scalar z3 = n3 * v_phi_4;
    forces.x = n0;
    forces.y = n0;
    forces.psi = n0;
    forces.phi_1 = z0;
    forces.phi_2 = z1;
    forces.phi_3 = z2;
    forces.phi_4 = z3;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar k2 = traits::constant(1024.8718707889795, 1024.8718f, "1302;0;-160;0");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar k4 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k6 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar k7 = traits::constant(1.224744871391589, 1.2247449f, "0;0;0;1/2");
    const Scalar k8 = traits::constant(0.189468690981506, 0.1894687f, "0;1;0;-1/2");
    const Scalar k9 = traits::constant(1.1339745962155614, 1.1339746f, "2;0;-1/2;0");
    const Scalar k10 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_2_x = multipliers.lambda_wheel_2_x;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_4_x = multipliers.lambda_wheel_4_x;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z0 = n3 * v_phi_1;
    const Scalar z1 = n3 * v_phi_2;
    const Scalar z2 = n3 * v_phi_3;
    const Scalar z3 = n3 * v_phi_4;
    const Scalar z4 = n880 * a_x;  // force on S.y, x
    const Scalar z5 = n880 * a_y;  // force on S.y, y
    const Scalar z6 = k2 * a_psi;
    const Scalar z7 = n0_9 * a_phi_1 + z0;
    const Scalar z8 = n0_9 * a_phi_2 + z1;
    const Scalar z9 = n0_9 * a_phi_3 + z2;
    const Scalar z10 = n0_9 * a_phi_4 + z3;
    const Scalar z11 = k4 * (s_psi + c_psi);
    const Scalar z12 = k4 * (s_psi - c_psi);
    const Scalar z13 = n0_5 * s_psi + k6 * c_psi;
    const Scalar z14 = k6 * s_psi - n0_5 * c_psi;
    forces.x = z4 + s_psi * (l_lambda_wheel_3_y + l_lambda_wheel_4_y) - c_psi * (l_lambda_wheel_3_x
        + l_lambda_wheel_4_x) - z11 * l_lambda_wheel_1_x + z12 * l_lambda_wheel_1_y - z13 * l_lambda_wheel_2_x + z14
        * l_lambda_wheel_2_y;
    forces.y = -s_psi * (l_lambda_wheel_3_x + l_lambda_wheel_4_x) + z5 - c_psi * (l_lambda_wheel_3_y
        + l_lambda_wheel_4_y) - z11 * l_lambda_wheel_1_y - z12 * l_lambda_wheel_1_x - z13 * l_lambda_wheel_2_y - z14
        * l_lambda_wheel_2_x;
    forces.psi = k7 * l_lambda_wheel_1_x - l_lambda_wheel_3_x + k8 * l_lambda_wheel_1_y + n0_5 * l_lambda_wheel_2_x + k9
        * l_lambda_wheel_2_y - l_lambda_wheel_4_x + k10 * (l_lambda_wheel_3_y - l_lambda_wheel_4_y) + z6;
    forces.phi_1 = z7 - n0_3 * l_lambda_wheel_1_y;
    forces.phi_2 = z8 - n0_3 * l_lambda_wheel_2_y;
    forces.phi_3 = z9 - n0_3 * l_lambda_wheel_3_y;
    forces.phi_4 = z10 - n0_3 * l_lambda_wheel_4_y;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n10_over_9 = traits::constant(1.1111111111111112, 1.1111112f, "10/9");
    const Scalar k2 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k4 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n1_over_880 = traits::constant(0.0011363636363636363, 0.0011363636f, "1/880");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar k7 = traits::constant(0.006034576682862498, 0.006034577f,
        "-47006191/3371970601;0;38887200/3371970601;0");
    const Scalar k8 = traits::constant(0.0017129626287467768, 0.0017129626f,
        "66184580/3371970601;0;-69753751/6743941202;0");
    const Scalar k9 = traits::constant(0.017638487147502033, 0.017638488f, "-16685/894962;0;1687231/80546580;0");
    const Scalar k10 = traits::constant(0.009102215061268836, 0.009102215f,
        "21236489/6743941202;0;11589820/3371970601;0");
    const Scalar k11 = traits::constant(0.0020210924874408953, 0.0020210925f, "623431/80546580;0;-2955/894962;0");
    const Scalar k12 = traits::constant(0.005455658513429925, 0.0054556583f,
        "89114018400/13518896323201;0;-26603497741/40556688969603;0");
    const Scalar k13 = traits::constant(0.006572896294694327, 0.006572896f,
        "0;136601849/6743941202;0;-30385300/3371970601");
    const Scalar k14 = traits::constant(0.009196082194860185, 0.009196082f, "0;-702269/80546580;0;7865/894962");
    const Scalar k15 = traits::constant(0.01259924664742195, 0.012599247f,
        "0;245195815485/13518896323201;0;-216083377004/40556688969603");
    const Scalar k16 = traits::constant(0.28316279903238994, 0.2831628f,
        "0;25702471/42235382402;0;4867601651/42235382402");
    const Scalar k17 = traits::constant(0.01650954001858063, 0.01650954f,
        "0;105186729/6743941202;0;-7637740/3371970601");
    const Scalar k18 = traits::constant(0.0008008890184089598, 0.00080088904f, "0;350369/80546580;0;-1955/894962");
    const Scalar k19 = traits::constant(0.010379644993220454, 0.010379645f,
        "0;6781705485/13518896323201;0;160111588604/40556688969603");
    const Scalar k20 = traits::constant(1.223495166781618, 1.2234951f,
        "0;10617284129/42235382402;0;14966251291/42235382402");
    const Scalar k21 = traits::constant(0.002482053887386035, 0.0024820538f,
        "966041444/89519463013;0;-429461601/89519463013;0");
    const Scalar k22 = traits::constant(1952.7227294153192, 1952.7228f, "3168704970/2462867;0;2841587660/7388601;0");
    const Scalar k23 = traits::constant(9.897811768073788, 9.897812f,
        "869737739680/89519463013;0;9416037180/89519463013;0");
    const Scalar k24 = traits::constant(730.7739671779823, 730.774f,
        "16040869583970/21117691201;0;-351381498000/21117691201;0");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar k26 = traits::constant(9.76952417527508, 9.769525f,
        "129883377835200/13518896323201;0;1264285440000/13518896323201;0");
    const Scalar k27 = traits::constant(9.837140758022175, 9.837141f, "38852009/4027329;0;49100/447481;0");
    const Scalar k28 = traits::constant(9.836782527565767, 9.836782f,
        "32510763120/3371970601;0;380230400/3371970601;0");
    const Scalar k29 = traits::constant(0.0011950224279731092, 0.0011950224f, "0;20/134867;0;217/539468");
    const Scalar k30 = traits::constant(0.0001848706129827203, 0.00018487062f, "0;177/269734;0;-491/1618404");
    const Scalar k31 = traits::constant(0.0004878658632859967, 0.00048786585f, "217/539468;0;20/404601;0");
    const Scalar k32 = traits::constant(0.0011064549906541887, 0.001106455f, "197/134867;0;-331/1618404;0");
    const Scalar k33 = traits::constant(0.0007142851984076027, 0.0007142852f, "-137/269734;0;571/809202;0");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar u_C3 = inputs.C3;
    const Scalar u_C4 = inputs.C4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z0 = v_psi * c_psi;
    const Scalar z1 = v_psi * s_psi;
    const Scalar z2 = n3 * v_phi_3;
    const Scalar z3 = n3 * v_phi_4;
    const Scalar z4 = n3 * v_phi_1;
    const Scalar z5 = n3 * v_phi_2;
    const Scalar z6 = u_C3 - z2;
    const Scalar z7 = u_C4 - z3;
    const Scalar z8 = n10_over_9 * z4;
    const Scalar z9 = n10_over_9 * z5;
    const Scalar z10 = k2 * (s_psi + c_psi);
    const Scalar z11 = n10_over_9 * z6;
    const Scalar z12 = n10_over_9 * z7;
    const Scalar z13 = k2 * (s_psi - c_psi);
    const Scalar z14 = n0_5 * s_psi + k4 * c_psi;
    const Scalar z15 = k4 * s_psi - n0_5 * c_psi;
    const Scalar z16 = n1_over_880 * s_psi;
    const Scalar z17 = n1_over_880 * c_psi;
    const Scalar z18 = k2 * (z0 - z1);
    const Scalar z19 = k2 * (z0 + z1);
    const Scalar z20 = n0_5 * z0 - k4 * z1;
    const Scalar z21 = k4 * z0 + n0_5 * z1;
    const Scalar z22 = v_x * z0 + v_y * z1;
    const Scalar z23 = n1_over_880 * z10;
    const Scalar z24 = n1_over_880 * z13;
    const Scalar z25 = n1_over_880 * z14;
    const Scalar z26 = n1_over_880 * z15;
    const Scalar z27 = v_x * z18 + v_y * z19;
    const Scalar z28 = v_x * z19 - v_y * z18;
    const Scalar z29 = v_x * z20 + v_y * z21;
    const Scalar z30 = v_x * z21 - v_y * z20;
    const Scalar z31 = z22 - n0_3 * z11;
    const Scalar z32 = z22 - n0_3 * z12;
    const Scalar z33 = z31 - k7 * z32;
    const Scalar z34 = z28 + n0_3 * z8;
    const Scalar z35 = z30 + n0_3 * z9;
    const Scalar z36 = z35 - k8 * z32 - k9 * z33;
    const Scalar z37 = z29 - k10 * z32 - k11 * z33 + k12 * z36;
    const Scalar z38 = z34 - k13 * z32 - k14 * z33 - k15 * z36 + k16 * z37;
    const Scalar z39 = z27 - k17 * z32 + k18 * z33 + k19 * z36 - k20 * z37 - k21 * z38;
    const Scalar z40 = k22 * z39;
    const Scalar z41 = k23 * z38 - k21 * z40;
    const Scalar z42 = k24 * z37 - k20 * z40 + k16 * z41;
    const Scalar z43 = z8 - n1_over_3 * z41;
    const Scalar z44 = k26 * z36 + k19 * z40 - k15 * z41 + k12 * z42;
    const Scalar z45 = k27 * z33 + k18 * z40 - k14 * z41 - k11 * z42 - k9 * z44;
    const Scalar z46 = z9 - n1_over_3 * z44;
    const Scalar z47 = k28 * z32 - k17 * z40 - k13 * z41 - k10 * z42 - k8 * z44 - k7 * z45;
    const Scalar z48 = z11 + n1_over_3 * z45;
    const Scalar z49 = z23 * z40 + z24 * z41 + z25 * z42 + z26 * z44 + z16 * (z45 + z47);
    const Scalar z50 = z23 * z41 - z24 * z40 - z26 * z42 + z25 * z44 + z17 * (z45 + z47);
    const Scalar z51 = k29 * z40 - k30 * z41 + k31 * z42 - k32 * z44 - k33 * (z45 - z47);
    const Scalar z52 = z12 + n1_over_3 * z47;
    accelerations.x = -z49;
    accelerations.y = z50;
    accelerations.psi = z51;
    accelerations.phi_1 = -z43;
    accelerations.phi_2 = -z46;
    accelerations.phi_3 = z48;
    accelerations.phi_4 = z52;
    multipliers.lambda_wheel_1_x = -z40;
    multipliers.lambda_wheel_1_y = z41;
    multipliers.lambda_wheel_2_x = -z42;
    multipliers.lambda_wheel_2_y = z44;
    multipliers.lambda_wheel_3_x = n0;
    multipliers.lambda_wheel_3_y = z45;
    multipliers.lambda_wheel_4_x = n0;
    multipliers.lambda_wheel_4_y = z47;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.psi * accelerations.phi_1
        * accelerations.phi_2 * accelerations.phi_3 * accelerations.phi_4 * multipliers.lambda_wheel_1_x
        * multipliers.lambda_wheel_1_y * multipliers.lambda_wheel_2_x * multipliers.lambda_wheel_2_y
        * multipliers.lambda_wheel_3_y * multipliers.lambda_wheel_4_y;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k1 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar k2 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar k3 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar u_C3 = inputs.C3;
    const Scalar u_C4 = inputs.C4;
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
    const Scalar z10 = n3 * v_phi_1;
    const Scalar z11 = n3 * v_phi_2;
    const Scalar z12 = n3 * v_phi_3;
    const Scalar z13 = n3 * v_phi_4;
    const Scalar z14 = v_psi - z0;
    const Scalar z15 = k1 * v_psi - z1;
    const Scalar z16 = k1 * v_psi + z1;
    const Scalar z17 = v_psi + z0;
    const Scalar z18 = k2 * (z14 + z15);
    const Scalar z19 = k2 * (z14 - z15);
    const Scalar z20 = k3 * z14 - n0_5 * z16;
    const Scalar z21 = n0_5 * z14 + k3 * z16;
    const Scalar z22 = c_phi_3 * z16;
    const Scalar z23 = s_phi_3 * z16;
    const Scalar z24 = c_phi_4 * z15;
    const Scalar z25 = s_phi_4 * z15;
    const Scalar z26 = c_phi_1 * z19;
    const Scalar z27 = s_phi_1 * z19;
    const Scalar z28 = c_phi_2 * z21;
    const Scalar z29 = s_phi_2 * z21;
    result.kinetic = n450 * v_psi * v_psi + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3 * v_phi_3 + v_phi_4
        * v_phi_4) + n20 * z17 * z17 + n400 * (z0 * z0 + z1 * z1) + n0_25 * (z2 * z2 + z3 * z3 + z4 * z4 + z5 * z5 + z6
        * z6 + z7 * z7 + z8 * z8 + z9 * z9) + n10 * (z22 * z22 + z23 * z23 + z24 * z24 + z25 * z25 + z18 * z18 + z20
        * z20 + z26 * z26 + z27 * z27 + z28 * z28 + z29 * z29);
    result.force_function = n0;
    result.power = -v_phi_1 * z10 + v_phi_3 * (u_C3 - z12) + v_phi_4 * (u_C4 - z13) - v_phi_2 * z11;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar k0 = traits::constant(0.7071067811865476, 0.70710677f, "0;1/2;0;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar k4 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar k5 = traits::constant(1.224744871391589, 1.2247449f, "0;0;0;1/2");
    const Scalar k6 = traits::constant(0.189468690981506, 0.1894687f, "0;1;0;-1/2");
    const Scalar k7 = traits::constant(1.1339745962155614, 1.1339746f, "2;0;-1/2;0");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    const Scalar z0 = v_psi * c_psi;
    const Scalar z1 = v_psi * s_psi;
    const Scalar z2 = k0 * (s_psi + c_psi);
    const Scalar z3 = n0_5 * s_psi + k2 * c_psi;
    const Scalar z4 = k0 * (s_psi - c_psi);
    const Scalar z5 = k2 * s_psi - n0_5 * c_psi;
    const Scalar z6 = v_x * s_psi;
    const Scalar z7 = v_psi + v_x * c_psi + v_y * s_psi;
    const Scalar z8 = k0 * (z0 - z1);
    const Scalar z9 = k0 * (z0 + z1);
    const Scalar z10 = n0_5 * z0 - k2 * z1;
    const Scalar z11 = k2 * z0 + n0_5 * z1;
    const Scalar z12 = v_x * z1 - v_y * z0;
    const Scalar z13 = n0_3 * v_phi_3 - k4 * v_psi + v_y * c_psi - z6;
    const Scalar z14 = v_x * z0 + v_y * z1;
    const Scalar z15 = k4 * v_psi + n0_3 * v_phi_4 + v_y * c_psi - z6;
    const Scalar z16 = v_x * z2 + v_y * z4 - k5 * v_psi;
    const Scalar z17 = k6 * v_psi - n0_3 * v_phi_1 + v_x * z4 - v_y * z2;
    const Scalar z18 = v_x * z3 + v_y * z5 - n0_5 * v_psi;
    const Scalar z19 = k7 * v_psi - n0_3 * v_phi_2 + v_x * z5 - v_y * z3;
    const Scalar z20 = v_x * z8 + v_y * z9;
    const Scalar z21 = v_x * z9 - v_y * z8;
    const Scalar z22 = v_x * z10 + v_y * z11;
    const Scalar z23 = v_x * z11 - v_y * z10;
    result.value[0] = n0;
    result.rate[0] = z16;
    result.gamma[0] = z20;
    result.value[1] = n0;
    result.rate[1] = -z17;
    result.gamma[1] = -z21;
    result.value[2] = n0;
    result.rate[2] = z18;
    result.gamma[2] = z22;
    result.value[3] = n0;
    result.rate[3] = -z19;
    result.gamma[3] = -z23;
    result.value[4] = n0;
    result.rate[4] = z7;
    result.gamma[4] = -z12;
    result.value[5] = n0;
    result.rate[5] = z13;
    result.gamma[5] = -z14;
    result.value[6] = n0;
    result.rate[6] = z7;
    result.gamma[6] = -z12;
    result.value[7] = n0;
    result.rate[7] = z15;
    result.gamma[7] = -z14;
    result.jacobian[0] = z2;
    result.jacobian[1] = -z4;
    result.jacobian[2] = z3;
    result.jacobian[3] = -z5;
    result.jacobian[4] = c_psi;
    result.jacobian[5] = -s_psi;
    result.jacobian[6] = c_psi;
    result.jacobian[7] = -s_psi;
    result.jacobian[8] = z4;
    result.jacobian[9] = z2;
    result.jacobian[10] = z5;
    result.jacobian[11] = z3;
    result.jacobian[12] = s_psi;
    result.jacobian[13] = c_psi;
    result.jacobian[14] = s_psi;
    result.jacobian[15] = c_psi;
    result.jacobian[16] = -k5;
    result.jacobian[17] = -k6;
    result.jacobian[18] = -n0_5;
    result.jacobian[19] = -k7;
    result.jacobian[20] = n1;
    result.jacobian[21] = -k4;
    result.jacobian[22] = n1;
    result.jacobian[23] = k4;
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
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 49>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, Constraints&>(constraints));
  }
};

}  // namespace four_wheel_vehicle
