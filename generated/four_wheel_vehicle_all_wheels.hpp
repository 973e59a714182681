// SPDX-License-Identifier: MIT
// four_wheel_vehicle_all_wheels: Four-wheel vehicle: the eight conditions of its four wheels
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, energy, constraints
// Parameters set at run time: alpha_1, alpha_2, alpha_3, alpha_4
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                8                8          0             0                  4       0     24       -
//   kinematics               76              134          0             0                  9       0    228     236
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                0          0             0                  0       0      0       0
//   inverse_dynamics         33               37          0             0                  4       0     78     326
//   energy                   40               70          0             0                  5       0    120     150
//   constraints              32               52          0             0                  4       0     92     116
//
// Not computed because this mechanism does not need it:
//   kinematics: of 198 results 91 vanish identically, 10 repeat another up to sign
//   mass_matrix: of 49 results 42 vanish identically
//   bias: of 7 results 7 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: of 80 results 36 vanish identically, 8 repeat another up to sign
//
// To write this file again:
//   four_wheel_vehicle_all_wheels_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,energy,constraints --output four_wheel_vehicle_all_wheels.hpp
#pragma once

#include <array>
#include <cmath>

#ifndef TORSOR_KERNEL_SUPPORT
#define TORSOR_KERNEL_SUPPORT 1
// Define it before the first generated header to annotate every function, e.g. as __host__ __device__.
#ifndef TORSOR_DEVICE
#define TORSOR_DEVICE
#endif

namespace torsor {

/// What a kernel says about its results; the larger, the worse.
enum class Status : int { ok = 0, singular = 1, not_finite = 2 };

/// What a kernel needs of its scalar. This one serves float and double; specialise it, once a header is included, for
/// any other (a pack of several states, a high-precision number).
template <class Scalar>
struct scalar_traits {
  static_assert(sizeof(Scalar) == sizeof(float) || sizeof(Scalar) == sizeof(double),
                "specialise torsor::scalar_traits for a scalar that is neither float nor double");
  static constexpr bool is_float = sizeof(Scalar) == sizeof(float);

  /// A number, rounded for either format. `exact` is "num/den", or "a;b;c;d" for a + b sqrt(2) + c sqrt(3) + d sqrt(6).
  TORSOR_DEVICE static constexpr Scalar constant(double in_double, float in_float, const char* /*exact*/) noexcept {
    return is_float ? static_cast<Scalar>(in_float) : static_cast<Scalar>(in_double);
  }
  /// The same for a number that is no such sum: a callable computes it where literals are not precise enough.
  template <class Callable>
  TORSOR_DEVICE static constexpr Scalar formula(double in_double, float in_float, const Callable&) noexcept {
    return constant(in_double, in_float, nullptr);
  }
  TORSOR_DEVICE static constexpr Scalar pi() noexcept { return constant(3.141592653589793, 3.1415927f, nullptr); }
  TORSOR_DEVICE static constexpr Scalar select(bool condition, Scalar if_true, Scalar if_false) noexcept {
    return condition ? if_true : if_false;
  }
  TORSOR_DEVICE static void sincos(const Scalar& angle, Scalar& sine, Scalar& cosine) noexcept {
    sine = std::sin(angle);
    cosine = std::cos(angle);
  }
  TORSOR_DEVICE static Scalar sqrt(const Scalar& x) noexcept { return std::sqrt(x); }
  TORSOR_DEVICE static Scalar exp(const Scalar& x) noexcept { return std::exp(x); }
  TORSOR_DEVICE static Scalar log(const Scalar& x) noexcept { return std::log(x); }
  /// Whether a pivot is positive beyond the rounding of the diagonal entry it came from; not when it is not a number.
  TORSOR_DEVICE static bool regular(const Scalar& pivot, const Scalar& diagonal) noexcept {
    return pivot > constant(0x1p-52, 0x1p-23f, nullptr) * std::abs(diagonal);
  }
};

}  // namespace torsor
#elif TORSOR_KERNEL_SUPPORT != 1
#error "headers of incompatible versions of torsor meet here: write them again with one version"
#endif

namespace four_wheel_vehicle_all_wheels {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "four_wheel_vehicle_all_wheels";
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 8;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar alpha_1;  ///< parameter [rad or 1]
    Scalar alpha_2;  ///< parameter [rad or 1]
    Scalar alpha_3;  ///< parameter [rad or 1]
    Scalar alpha_4;  ///< parameter [rad or 1]
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
    Scalar psi;  ///< coordinate [rad or 1]
    Scalar phi_1;  ///< coordinate [rad or 1]
    Scalar phi_2;  ///< coordinate [rad or 1]
    Scalar phi_3;  ///< coordinate [rad or 1]
    Scalar phi_4;  ///< coordinate [rad or 1]
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
    static constexpr int size = 0;
  };

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
    Scalar s_alpha_1;
    Scalar c_alpha_1;
    Scalar s_alpha_2;
    Scalar c_alpha_2;
    Scalar s_alpha_3;
    Scalar c_alpha_3;
    Scalar s_alpha_4;
    Scalar c_alpha_4;
    Scalar z284;
    Scalar z285;
    Scalar z292;
    Scalar z293;
    Scalar z300;
    Scalar z301;
    Scalar z308;
    Scalar z309;
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
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar p_alpha_1 = parameters.alpha_1;
    const Scalar p_alpha_2 = parameters.alpha_2;
    const Scalar p_alpha_3 = parameters.alpha_3;
    const Scalar p_alpha_4 = parameters.alpha_4;
    Scalar s_alpha_1, c_alpha_1;
    traits::sincos(p_alpha_1, s_alpha_1, c_alpha_1);
    Scalar s_alpha_2, c_alpha_2;
    traits::sincos(p_alpha_2, s_alpha_2, c_alpha_2);
    Scalar s_alpha_3, c_alpha_3;
    traits::sincos(p_alpha_3, s_alpha_3, c_alpha_3);
    Scalar s_alpha_4, c_alpha_4;
    traits::sincos(p_alpha_4, s_alpha_4, c_alpha_4);
    const Scalar z284 = s_alpha_1 + k0 * c_alpha_1;
    const Scalar z285 = k0 * s_alpha_1 - c_alpha_1;
    const Scalar z292 = s_alpha_2 - k0 * c_alpha_2;
    const Scalar z293 = k0 * s_alpha_2 + c_alpha_2;
    const Scalar z300 = s_alpha_3 + k0 * c_alpha_3;
    const Scalar z301 = k0 * s_alpha_3 - c_alpha_3;
    const Scalar z308 = s_alpha_4 - k0 * c_alpha_4;
    const Scalar z309 = k0 * s_alpha_4 + c_alpha_4;
    precomputed.s_alpha_1 = s_alpha_1;
    precomputed.c_alpha_1 = c_alpha_1;
    precomputed.s_alpha_2 = s_alpha_2;
    precomputed.c_alpha_2 = c_alpha_2;
    precomputed.s_alpha_3 = s_alpha_3;
    precomputed.c_alpha_3 = c_alpha_3;
    precomputed.s_alpha_4 = s_alpha_4;
    precomputed.c_alpha_4 = c_alpha_4;
    precomputed.z284 = z284;
    precomputed.z285 = z285;
    precomputed.z292 = z292;
    precomputed.z293 = z293;
    precomputed.z300 = z300;
    precomputed.z301 = z301;
    precomputed.z308 = z308;
    precomputed.z309 = z309;
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
    const Scalar q_phi_1 = state.q.phi_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar q_phi_2 = state.q.phi_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar q_phi_3 = state.q.phi_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar q_phi_4 = state.q.phi_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    Scalar s_phi_1, c_phi_1;
    traits::sincos(q_phi_1, s_phi_1, c_phi_1);
    Scalar s_phi_2, c_phi_2;
    traits::sincos(q_phi_2, s_phi_2, c_phi_2);
    Scalar s_phi_3, c_phi_3;
    traits::sincos(q_phi_3, s_phi_3, c_phi_3);
    Scalar s_phi_4, c_phi_4;
    traits::sincos(q_phi_4, s_phi_4, c_phi_4);
    const Scalar z43 = v_x * c_psi + v_y * s_psi;
    const Scalar z44 = v_x * s_psi - v_y * c_psi;
    const Scalar z45 = v_psi - z43;
    const Scalar z46 = k0 * v_psi - z44;
    const Scalar z47 = s_alpha_1 * z46 - c_alpha_1 * z45;
    const Scalar z48 = s_alpha_1 * z45 + c_alpha_1 * z46;
    const Scalar z49 = v_psi * s_phi_1;
    const Scalar z50 = v_psi * c_phi_1;
    const Scalar z51 = c_phi_1 * z48;
    const Scalar z52 = s_phi_1 * z48;
    const Scalar z53 = k0 * v_psi + z44;
    const Scalar z54 = s_alpha_2 * z53 + c_alpha_2 * z45;
    const Scalar z55 = s_alpha_2 * z45 - c_alpha_2 * z53;
    const Scalar z56 = v_psi * s_phi_2;
    const Scalar z57 = v_psi * c_phi_2;
    const Scalar z58 = c_phi_2 * z55;
    const Scalar z59 = s_phi_2 * z55;
    const Scalar z60 = v_psi + z43;
    const Scalar z61 = s_alpha_3 * z53 - c_alpha_3 * z60;
    const Scalar z62 = s_alpha_3 * z60 + c_alpha_3 * z53;
    const Scalar z63 = v_psi * s_phi_3;
    const Scalar z64 = v_psi * c_phi_3;
    const Scalar z65 = c_phi_3 * z62;
    const Scalar z66 = s_phi_3 * z62;
    const Scalar z67 = s_alpha_4 * z46 + c_alpha_4 * z60;
    const Scalar z68 = s_alpha_4 * z60 - c_alpha_4 * z46;
    const Scalar z69 = v_psi * s_phi_4;
    const Scalar z70 = v_psi * c_phi_4;
    const Scalar z71 = c_phi_4 * z68;
    const Scalar z72 = s_phi_4 * z68;
    const Scalar z73 = s_psi * z44 + c_psi * z43;
    const Scalar z74 = s_psi * z43 - c_psi * z44;
    const Scalar z75 = s_psi - k0 * c_psi;
    const Scalar z76 = k0 * s_psi + c_psi;
    const Scalar z77 = q_y + z76;
    const Scalar z78 = q_x - z75;
    const Scalar z79 = q_psi + p_alpha_1;
    Scalar z80, z81;
    traits::sincos(z79, z80, z81);
    const Scalar z82 = c_phi_1 * z80;
    const Scalar z83 = c_phi_1 * z81;
    const Scalar z84 = s_phi_1 * z80;
    const Scalar z85 = s_phi_1 * z81;
    const Scalar z86 = s_phi_1 * z52 + c_phi_1 * z51;
    const Scalar z88 = z47 * z81 - z80 * z86;
    const Scalar z89 = z47 * z80 + z81 * z86;
    const Scalar z90 = s_phi_1 * z50 - c_phi_1 * z49;
    const Scalar z91 = s_phi_1 * z49 + c_phi_1 * z50;
    const Scalar z92 = v_phi_1 * z81 + z80 * z90;
    const Scalar z93 = v_phi_1 * z80 - z81 * z90;
    const Scalar z94 = s_psi + k0 * c_psi;
    const Scalar z95 = k0 * s_psi - c_psi;
    const Scalar z96 = q_y - z95;
    const Scalar z97 = q_x - z94;
    const Scalar z98 = q_psi + p_alpha_2;
    Scalar z99, z100;
    traits::sincos(z98, z99, z100);
    const Scalar z101 = c_phi_2 * z99;
    const Scalar z102 = c_phi_2 * z100;
    const Scalar z103 = s_phi_2 * z99;
    const Scalar z104 = s_phi_2 * z100;
    const Scalar z105 = s_phi_2 * z59 + c_phi_2 * z58;
    const Scalar z107 = z54 * z100 + z99 * z105;
    const Scalar z108 = z54 * z99 - z100 * z105;
    const Scalar z109 = s_phi_2 * z57 - c_phi_2 * z56;
    const Scalar z110 = s_phi_2 * z56 + c_phi_2 * z57;
    const Scalar z111 = v_phi_2 * z100 + z99 * z109;
    const Scalar z112 = v_phi_2 * z99 - z100 * z109;
    const Scalar z113 = q_y - z76;
    const Scalar z114 = q_x + z75;
    const Scalar z115 = q_psi + p_alpha_3;
    Scalar z116, z117;
    traits::sincos(z115, z116, z117);
    const Scalar z118 = c_phi_3 * z116;
    const Scalar z119 = c_phi_3 * z117;
    const Scalar z120 = s_phi_3 * z116;
    const Scalar z121 = s_phi_3 * z117;
    const Scalar z122 = s_phi_3 * z66 + c_phi_3 * z65;
    const Scalar z124 = z61 * z117 - z116 * z122;
    const Scalar z125 = z61 * z116 + z117 * z122;
    const Scalar z126 = s_phi_3 * z64 - c_phi_3 * z63;
    const Scalar z127 = s_phi_3 * z63 + c_phi_3 * z64;
    const Scalar z128 = v_phi_3 * z117 + z116 * z126;
    const Scalar z129 = v_phi_3 * z116 - z117 * z126;
    const Scalar z130 = q_y + z95;
    const Scalar z131 = q_x + z94;
    const Scalar z132 = q_psi + p_alpha_4;
    Scalar z133, z134;
    traits::sincos(z132, z133, z134);
    const Scalar z135 = c_phi_4 * z133;
    const Scalar z136 = c_phi_4 * z134;
    const Scalar z137 = s_phi_4 * z133;
    const Scalar z138 = s_phi_4 * z134;
    const Scalar z139 = s_phi_4 * z72 + c_phi_4 * z71;
    const Scalar z141 = z67 * z134 + z133 * z139;
    const Scalar z142 = z67 * z133 - z134 * z139;
    const Scalar z143 = s_phi_4 * z70 - c_phi_4 * z69;
    const Scalar z144 = s_phi_4 * z69 + c_phi_4 * z70;
    const Scalar z145 = v_phi_4 * z134 + z133 * z143;
    const Scalar z146 = v_phi_4 * z133 - z134 * z143;
    const Scalar z147 = z47 * z81 - z48 * z80;
    const Scalar z148 = z47 * z80 + z48 * z81;
    const Scalar z149 = q_x - z78;
    const Scalar z150 = q_y - z77;
    const Scalar z151 = z54 * z100 + z55 * z99;
    const Scalar z152 = z54 * z99 - z55 * z100;
    const Scalar z153 = q_x - z97;
    const Scalar z154 = q_y - z96;
    const Scalar z155 = z61 * z117 - z62 * z116;
    const Scalar z156 = z61 * z116 + z62 * z117;
    const Scalar z157 = q_x - z114;
    const Scalar z158 = q_y - z113;
    const Scalar z159 = z67 * z134 + z68 * z133;
    const Scalar z160 = z67 * z133 - z68 * z134;
    const Scalar z161 = q_x - z131;
    const Scalar z162 = q_y - z130;
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
    result.chassis_velocity[0] = z73;
    result.chassis_velocity[1] = z74;
    result.chassis_velocity[2] = n0;
    result.chassis_angular_velocity[0] = n0;
    result.chassis_angular_velocity[1] = n0;
    result.chassis_angular_velocity[2] = v_psi;
    result.wheel_1_position[0] = z78;
    result.wheel_1_position[1] = z77;
    result.wheel_1_position[2] = n0_3;
    result.wheel_1_rotation[0] = z81;
    result.wheel_1_rotation[1] = z80;
    result.wheel_1_rotation[2] = n0;
    result.wheel_1_rotation[3] = -z82;
    result.wheel_1_rotation[4] = z83;
    result.wheel_1_rotation[5] = s_phi_1;
    result.wheel_1_rotation[6] = z84;
    result.wheel_1_rotation[7] = -z85;
    result.wheel_1_rotation[8] = c_phi_1;
    result.wheel_1_velocity[0] = z88;
    result.wheel_1_velocity[1] = z89;
    result.wheel_1_velocity[2] = n0;
    result.wheel_1_angular_velocity[0] = z92;
    result.wheel_1_angular_velocity[1] = z93;
    result.wheel_1_angular_velocity[2] = z91;
    result.wheel_2_position[0] = z97;
    result.wheel_2_position[1] = z96;
    result.wheel_2_position[2] = n0_3;
    result.wheel_2_rotation[0] = z100;
    result.wheel_2_rotation[1] = z99;
    result.wheel_2_rotation[2] = n0;
    result.wheel_2_rotation[3] = -z101;
    result.wheel_2_rotation[4] = z102;
    result.wheel_2_rotation[5] = s_phi_2;
    result.wheel_2_rotation[6] = z103;
    result.wheel_2_rotation[7] = -z104;
    result.wheel_2_rotation[8] = c_phi_2;
    result.wheel_2_velocity[0] = -z107;
    result.wheel_2_velocity[1] = -z108;
    result.wheel_2_velocity[2] = n0;
    result.wheel_2_angular_velocity[0] = z111;
    result.wheel_2_angular_velocity[1] = z112;
    result.wheel_2_angular_velocity[2] = z110;
    result.wheel_3_position[0] = z114;
    result.wheel_3_position[1] = z113;
    result.wheel_3_position[2] = n0_3;
    result.wheel_3_rotation[0] = z117;
    result.wheel_3_rotation[1] = z116;
    result.wheel_3_rotation[2] = n0;
    result.wheel_3_rotation[3] = -z118;
    result.wheel_3_rotation[4] = z119;
    result.wheel_3_rotation[5] = s_phi_3;
    result.wheel_3_rotation[6] = z120;
    result.wheel_3_rotation[7] = -z121;
    result.wheel_3_rotation[8] = c_phi_3;
    result.wheel_3_velocity[0] = -z124;
    result.wheel_3_velocity[1] = -z125;
    result.wheel_3_velocity[2] = n0;
    result.wheel_3_angular_velocity[0] = z128;
    result.wheel_3_angular_velocity[1] = z129;
    result.wheel_3_angular_velocity[2] = z127;
    result.wheel_4_position[0] = z131;
    result.wheel_4_position[1] = z130;
    result.wheel_4_position[2] = n0_3;
    result.wheel_4_rotation[0] = z134;
    result.wheel_4_rotation[1] = z133;
    result.wheel_4_rotation[2] = n0;
    result.wheel_4_rotation[3] = -z135;
    result.wheel_4_rotation[4] = z136;
    result.wheel_4_rotation[5] = s_phi_4;
    result.wheel_4_rotation[6] = z137;
    result.wheel_4_rotation[7] = -z138;
    result.wheel_4_rotation[8] = c_phi_4;
    result.wheel_4_velocity[0] = z141;
    result.wheel_4_velocity[1] = z142;
    result.wheel_4_velocity[2] = n0;
    result.wheel_4_angular_velocity[0] = z145;
    result.wheel_4_angular_velocity[1] = z146;
    result.wheel_4_angular_velocity[2] = z144;
    result.P1_position[0] = z78;
    result.P1_position[1] = z77;
    result.P1_position[2] = n0;
    result.P1_velocity[0] = z147;
    result.P1_velocity[1] = z148;
    result.P1_velocity[2] = n0;
    result.P1_jacobian[0] = n1;
    result.P1_jacobian[3] = n0;
    result.P1_jacobian[6] = z150;
    result.P1_jacobian[9] = n0;
    result.P1_jacobian[12] = n0;
    result.P1_jacobian[15] = n0;
    result.P1_jacobian[18] = n0;
    result.P1_jacobian[1] = n0;
    result.P1_jacobian[4] = n1;
    result.P1_jacobian[7] = -z149;
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
    result.P2_position[0] = z97;
    result.P2_position[1] = z96;
    result.P2_position[2] = n0;
    result.P2_velocity[0] = -z151;
    result.P2_velocity[1] = -z152;
    result.P2_velocity[2] = n0;
    result.P2_jacobian[0] = n1;
    result.P2_jacobian[3] = n0;
    result.P2_jacobian[6] = z154;
    result.P2_jacobian[9] = n0;
    result.P2_jacobian[12] = n0;
    result.P2_jacobian[15] = n0;
    result.P2_jacobian[18] = n0;
    result.P2_jacobian[1] = n0;
    result.P2_jacobian[4] = n1;
    result.P2_jacobian[7] = -z153;
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
    result.P3_position[0] = z114;
    result.P3_position[1] = z113;
    result.P3_position[2] = n0;
    result.P3_velocity[0] = -z155;
    result.P3_velocity[1] = -z156;
    result.P3_velocity[2] = n0;
    result.P3_jacobian[0] = n1;
    result.P3_jacobian[3] = n0;
    result.P3_jacobian[6] = z158;
    result.P3_jacobian[9] = n0;
    result.P3_jacobian[12] = n0;
    result.P3_jacobian[15] = n0;
    result.P3_jacobian[18] = n0;
    result.P3_jacobian[1] = n0;
    result.P3_jacobian[4] = n1;
    result.P3_jacobian[7] = -z157;
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
    result.P4_position[0] = z131;
    result.P4_position[1] = z130;
    result.P4_position[2] = n0;
    result.P4_velocity[0] = z159;
    result.P4_velocity[1] = z160;
    result.P4_velocity[2] = n0;
    result.P4_jacobian[0] = n1;
    result.P4_jacobian[3] = n0;
    result.P4_jacobian[6] = z162;
    result.P4_jacobian[9] = n0;
    result.P4_jacobian[12] = n0;
    result.P4_jacobian[15] = n0;
    result.P4_jacobian[18] = n0;
    result.P4_jacobian[1] = n0;
    result.P4_jacobian[4] = n1;
    result.P4_jacobian[7] = -z161;
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
  TORSOR_DEVICE static void bias(const Precomputed&, const State&, GeneralizedForces& forces) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    forces.x = n0;
    forces.y = n0;
    forces.psi = n0;
    forces.phi_1 = n0;
    forces.phi_2 = n0;
    forces.phi_3 = n0;
    forces.phi_4 = n0;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(1022.8718707889797, 1022.8719f, "1300;0;-160;0");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_2_x = multipliers.lambda_wheel_2_x;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_4_x = multipliers.lambda_wheel_4_x;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    const Scalar z284 = precomputed.z284;
    const Scalar z285 = precomputed.z285;
    const Scalar z292 = precomputed.z292;
    const Scalar z293 = precomputed.z293;
    const Scalar z300 = precomputed.z300;
    const Scalar z301 = precomputed.z301;
    const Scalar z308 = precomputed.z308;
    const Scalar z309 = precomputed.z309;
    const Scalar z79 = q_psi + p_alpha_1;
    Scalar z80, z81;
    traits::sincos(z79, z80, z81);
    const Scalar z98 = q_psi + p_alpha_2;
    Scalar z99, z100;
    traits::sincos(z98, z99, z100);
    const Scalar z115 = q_psi + p_alpha_3;
    Scalar z116, z117;
    traits::sincos(z115, z116, z117);
    const Scalar z132 = q_psi + p_alpha_4;
    Scalar z133, z134;
    traits::sincos(z132, z133, z134);
    const Scalar z263 = n0_9 * a_phi_4;  // moment on wheel_4, x
    const Scalar z264 = n0_5 * a_psi;  // moment on steered_4, z
    const Scalar z267 = n0_9 * a_phi_3;  // moment on wheel_3, x
    const Scalar z270 = n0_9 * a_phi_2;  // moment on wheel_2, x
    const Scalar z273 = n0_9 * a_phi_1;  // moment on wheel_1, x
    const Scalar z278 = k2 * a_psi + n4 * z264;  // moment on S, z
    const Scalar z281 = n880 * a_x;  // force on S.y, x
    const Scalar z282 = n880 * a_y;  // force on S.y, y
    forces.x = z80 * l_lambda_wheel_1_y - z81 * l_lambda_wheel_1_x + z99 * l_lambda_wheel_2_y - z100
        * l_lambda_wheel_2_x + z116 * l_lambda_wheel_3_y - z117 * l_lambda_wheel_3_x + z133 * l_lambda_wheel_4_y - z134
        * l_lambda_wheel_4_x + z281;
    forces.y = -z80 * l_lambda_wheel_1_x - z81 * l_lambda_wheel_1_y - z99 * l_lambda_wheel_2_x - z100
        * l_lambda_wheel_2_y - z116 * l_lambda_wheel_3_x - z117 * l_lambda_wheel_3_y - z133 * l_lambda_wheel_4_x - z134
        * l_lambda_wheel_4_y + z282;
    forces.psi = z278 - z284 * l_lambda_wheel_1_y - z285 * l_lambda_wheel_1_x - z292 * l_lambda_wheel_2_y + z293
        * l_lambda_wheel_2_x + z300 * l_lambda_wheel_3_y + z301 * l_lambda_wheel_3_x + z308 * l_lambda_wheel_4_y - z309
        * l_lambda_wheel_4_x;
    forces.phi_1 = z273 - n0_3 * l_lambda_wheel_1_y;
    forces.phi_2 = z270 - n0_3 * l_lambda_wheel_2_y;
    forces.phi_3 = z267 - n0_3 * l_lambda_wheel_3_y;
    forces.phi_4 = z263 - n0_3 * l_lambda_wheel_4_y;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
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
    const Scalar s_alpha_1 = precomputed.s_alpha_1;
    const Scalar c_alpha_1 = precomputed.c_alpha_1;
    const Scalar s_alpha_2 = precomputed.s_alpha_2;
    const Scalar c_alpha_2 = precomputed.c_alpha_2;
    const Scalar s_alpha_3 = precomputed.s_alpha_3;
    const Scalar c_alpha_3 = precomputed.c_alpha_3;
    const Scalar s_alpha_4 = precomputed.s_alpha_4;
    const Scalar c_alpha_4 = precomputed.c_alpha_4;
    Scalar s_psi, c_psi;
    traits::sincos(q_psi, s_psi, c_psi);
    Scalar s_phi_1, c_phi_1;
    traits::sincos(q_phi_1, s_phi_1, c_phi_1);
    Scalar s_phi_2, c_phi_2;
    traits::sincos(q_phi_2, s_phi_2, c_phi_2);
    Scalar s_phi_3, c_phi_3;
    traits::sincos(q_phi_3, s_phi_3, c_phi_3);
    Scalar s_phi_4, c_phi_4;
    traits::sincos(q_phi_4, s_phi_4, c_phi_4);
    const Scalar z43 = v_x * c_psi + v_y * s_psi;
    const Scalar z44 = v_x * s_psi - v_y * c_psi;
    const Scalar z45 = v_psi - z43;
    const Scalar z46 = k0 * v_psi - z44;
    const Scalar z47 = s_alpha_1 * z46 - c_alpha_1 * z45;
    const Scalar z48 = s_alpha_1 * z45 + c_alpha_1 * z46;
    const Scalar z49 = v_psi * s_phi_1;
    const Scalar z50 = v_psi * c_phi_1;
    const Scalar z51 = c_phi_1 * z48;
    const Scalar z52 = s_phi_1 * z48;
    const Scalar z53 = k0 * v_psi + z44;
    const Scalar z54 = s_alpha_2 * z53 + c_alpha_2 * z45;
    const Scalar z55 = s_alpha_2 * z45 - c_alpha_2 * z53;
    const Scalar z56 = v_psi * s_phi_2;
    const Scalar z57 = v_psi * c_phi_2;
    const Scalar z58 = c_phi_2 * z55;
    const Scalar z59 = s_phi_2 * z55;
    const Scalar z60 = v_psi + z43;
    const Scalar z61 = s_alpha_3 * z53 - c_alpha_3 * z60;
    const Scalar z62 = s_alpha_3 * z60 + c_alpha_3 * z53;
    const Scalar z63 = v_psi * s_phi_3;
    const Scalar z64 = v_psi * c_phi_3;
    const Scalar z65 = c_phi_3 * z62;
    const Scalar z66 = s_phi_3 * z62;
    const Scalar z67 = s_alpha_4 * z46 + c_alpha_4 * z60;
    const Scalar z68 = s_alpha_4 * z60 - c_alpha_4 * z46;
    const Scalar z69 = v_psi * s_phi_4;
    const Scalar z70 = v_psi * c_phi_4;
    const Scalar z71 = c_phi_4 * z68;
    const Scalar z72 = s_phi_4 * z68;
    result.kinetic = n10 * (z47 * z47 + z51 * z51 + z52 * z52 + z54 * z54 + z58 * z58 + z59 * z59 + z61 * z61 + z65
        * z65 + z66 * z66 + z67 * z67 + z71 * z71 + z72 * z72) + n0_25 * (z49 * z49 + z50 * z50 + z56 * z56 + z57 * z57
        + z63 * z63 + z64 * z64 + z69 * z69 + z70 * z70) + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3
        * v_phi_3 + v_phi_4 * v_phi_4) + n400 * (z43 * z43 + z44 * z44) + n450 * v_psi * v_psi;
    result.force_function = n0;
    result.power = n0;
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z284 = precomputed.z284;
    const Scalar z285 = precomputed.z285;
    const Scalar z292 = precomputed.z292;
    const Scalar z293 = precomputed.z293;
    const Scalar z300 = precomputed.z300;
    const Scalar z301 = precomputed.z301;
    const Scalar z308 = precomputed.z308;
    const Scalar z309 = precomputed.z309;
    const Scalar z79 = q_psi + p_alpha_1;
    Scalar z80, z81;
    traits::sincos(z79, z80, z81);
    const Scalar z98 = q_psi + p_alpha_2;
    Scalar z99, z100;
    traits::sincos(z98, z99, z100);
    const Scalar z115 = q_psi + p_alpha_3;
    Scalar z116, z117;
    traits::sincos(z115, z116, z117);
    const Scalar z132 = q_psi + p_alpha_4;
    Scalar z133, z134;
    traits::sincos(z132, z133, z134);
    const Scalar z286 = v_x * z81 + v_y * z80 + v_psi * z285;
    const Scalar z287 = v_psi * z80;
    const Scalar z288 = v_psi * z81;
    const Scalar z289 = v_x * z287 - v_y * z288;
    const Scalar z290 = v_x * z80 - v_y * z81 - v_psi * z284 - n0_3 * v_phi_1;
    const Scalar z291 = v_x * z288 + v_y * z287;
    const Scalar z294 = v_x * z100 + v_y * z99 - v_psi * z293;
    const Scalar z295 = v_psi * z99;
    const Scalar z296 = v_psi * z100;
    const Scalar z297 = v_x * z295 - v_y * z296;
    const Scalar z298 = v_x * z99 - v_y * z100 - v_psi * z292 - n0_3 * v_phi_2;
    const Scalar z299 = v_x * z296 + v_y * z295;
    const Scalar z302 = v_x * z117 + v_y * z116 - v_psi * z301;
    const Scalar z303 = v_psi * z116;
    const Scalar z304 = v_psi * z117;
    const Scalar z305 = v_x * z303 - v_y * z304;
    const Scalar z306 = v_x * z116 - v_y * z117 + v_psi * z300 - n0_3 * v_phi_3;
    const Scalar z307 = v_x * z304 + v_y * z303;
    const Scalar z310 = v_x * z134 + v_y * z133 + v_psi * z309;
    const Scalar z311 = v_psi * z133;
    const Scalar z312 = v_psi * z134;
    const Scalar z313 = v_x * z311 - v_y * z312;
    const Scalar z314 = v_x * z133 - v_y * z134 + v_psi * z308 - n0_3 * v_phi_4;
    const Scalar z315 = v_x * z312 + v_y * z311;
    result.value[0] = n0;
    result.rate[0] = z286;
    result.gamma[0] = -z289;
    result.value[1] = n0;
    result.rate[1] = -z290;
    result.gamma[1] = -z291;
    result.value[2] = n0;
    result.rate[2] = z294;
    result.gamma[2] = -z297;
    result.value[3] = n0;
    result.rate[3] = -z298;
    result.gamma[3] = -z299;
    result.value[4] = n0;
    result.rate[4] = z302;
    result.gamma[4] = -z305;
    result.value[5] = n0;
    result.rate[5] = -z306;
    result.gamma[5] = -z307;
    result.value[6] = n0;
    result.rate[6] = z310;
    result.gamma[6] = -z313;
    result.value[7] = n0;
    result.rate[7] = -z314;
    result.gamma[7] = -z315;
    result.jacobian[0] = z81;
    result.jacobian[1] = -z80;
    result.jacobian[2] = z100;
    result.jacobian[3] = -z99;
    result.jacobian[4] = z117;
    result.jacobian[5] = -z116;
    result.jacobian[6] = z134;
    result.jacobian[7] = -z133;
    result.jacobian[8] = z80;
    result.jacobian[9] = z81;
    result.jacobian[10] = z99;
    result.jacobian[11] = z100;
    result.jacobian[12] = z116;
    result.jacobian[13] = z117;
    result.jacobian[14] = z133;
    result.jacobian[15] = z134;
    result.jacobian[16] = z285;
    result.jacobian[17] = z284;
    result.jacobian[18] = -z293;
    result.jacobian[19] = z292;
    result.jacobian[20] = -z301;
    result.jacobian[21] = -z300;
    result.jacobian[22] = z309;
    result.jacobian[23] = -z308;
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
};

}  // namespace four_wheel_vehicle_all_wheels
