// SPDX-License-Identifier: MIT
// four_wheel_vehicle: Four-wheel vehicle whose wheels roll without slipping
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: alpha_1, alpha_2, alpha_3, alpha_4
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                6               12          0             0                  4       0     26       -
//   kinematics               76              134          0             0                  9       0    228     236
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                4          0             0                  0       0      4       4
//   inverse_dynamics         31               35          0             0                  4       0     74     318
//   forward_dynamics        146              211          6             0                  4       0    371     594
//   energy                   45               78          0             0                  5       0    133     165
//   constraints              26               42          0             0                  4       0     76      96
//
// Not computed because this mechanism does not need it:
//   kinematics: of 198 results 91 vanish identically, 10 repeat another up to sign
//   mass_matrix: of 49 results 42 vanish identically
//   bias: of 7 results 3 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 60 results 26 vanish identically, 4 repeat another up to sign
//
// To write this file again:
//   four_wheel_vehicle_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --output four_wheel_vehicle.hpp
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

namespace four_wheel_vehicle {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "four_wheel_vehicle";
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 2;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 6;

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
    Scalar lambda_wheel_1_x;  ///< of the constraint wheel_1_x [N]
    Scalar lambda_wheel_1_y;  ///< of the constraint wheel_1_y [N]
    Scalar lambda_wheel_3_x;  ///< of the constraint wheel_3_x [N]
    Scalar lambda_wheel_3_y;  ///< of the constraint wheel_3_y [N]
    Scalar lambda_wheel_2_y;  ///< of the constraint wheel_2_y [N]
    Scalar lambda_wheel_4_y;  ///< of the constraint wheel_4_y [N]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_wheel_1_x, &Multipliers::lambda_wheel_1_y,
          &Multipliers::lambda_wheel_3_x, &Multipliers::lambda_wheel_3_y, &Multipliers::lambda_wheel_2_y,
          &Multipliers::lambda_wheel_4_y};
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
    Scalar z294;
    Scalar z295;
    Scalar z302;
    Scalar z303;
    Scalar z310;
    Scalar z316;
    Scalar z336;
    Scalar z337;
    Scalar z340;
    Scalar z341;
    Scalar z344;
    Scalar z347;
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
    const Scalar k1 = traits::constant(0.0009757317265719934, 0.0009757317f, "217/269734;0;40/404601;0");
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
    const Scalar z294 = s_alpha_1 + k0 * c_alpha_1;
    const Scalar z295 = k0 * s_alpha_1 - c_alpha_1;
    const Scalar z302 = s_alpha_3 + k0 * c_alpha_3;
    const Scalar z303 = k0 * s_alpha_3 - c_alpha_3;
    const Scalar z310 = s_alpha_2 - k0 * c_alpha_2;
    const Scalar z316 = s_alpha_4 - k0 * c_alpha_4;
    const Scalar z336 = k1 * z295;
    const Scalar z337 = k1 * z294;
    const Scalar z340 = k1 * z303;
    const Scalar z341 = k1 * z302;
    const Scalar z344 = k1 * z310;
    const Scalar z347 = k1 * z316;
    precomputed.s_alpha_1 = s_alpha_1;
    precomputed.c_alpha_1 = c_alpha_1;
    precomputed.s_alpha_2 = s_alpha_2;
    precomputed.c_alpha_2 = c_alpha_2;
    precomputed.s_alpha_3 = s_alpha_3;
    precomputed.c_alpha_3 = c_alpha_3;
    precomputed.s_alpha_4 = s_alpha_4;
    precomputed.c_alpha_4 = c_alpha_4;
    precomputed.z294 = z294;
    precomputed.z295 = z295;
    precomputed.z302 = z302;
    precomputed.z303 = z303;
    precomputed.z310 = z310;
    precomputed.z316 = z316;
    precomputed.z336 = z336;
    precomputed.z337 = z337;
    precomputed.z340 = z340;
    precomputed.z341 = z341;
    precomputed.z344 = z344;
    precomputed.z347 = z347;
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
    std::array<Scalar, 6> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 6> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 42> jacobian;  ///< A, stored column by column (6 x 7)
    std::array<Scalar, 6> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
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
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar z217 = n3 * v_phi_1;
    const Scalar z218 = n3 * v_phi_2;
    const Scalar z219 = n3 * v_phi_3;
    const Scalar z220 = n3 * v_phi_4;
    forces.x = n0;
    forces.y = n0;
    forces.psi = n0;
    forces.phi_1 = z217;
    forces.phi_2 = z218;
    forces.phi_3 = z219;
    forces.phi_4 = z220;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_9 = traits::constant(0.9, 0.9f, "9/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(1022.8718707889797, 1022.8719f, "1300;0;-160;0");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n880 = traits::constant(880.0, 880.0f, "880/1");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_psi = state.q.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar p_alpha_1 = precomputed.parameters.alpha_1;
    const Scalar v_phi_1 = state.v.phi_1;
    const Scalar a_phi_1 = accelerations.phi_1;
    const Scalar p_alpha_2 = precomputed.parameters.alpha_2;
    const Scalar v_phi_2 = state.v.phi_2;
    const Scalar a_phi_2 = accelerations.phi_2;
    const Scalar p_alpha_3 = precomputed.parameters.alpha_3;
    const Scalar v_phi_3 = state.v.phi_3;
    const Scalar a_phi_3 = accelerations.phi_3;
    const Scalar p_alpha_4 = precomputed.parameters.alpha_4;
    const Scalar v_phi_4 = state.v.phi_4;
    const Scalar a_phi_4 = accelerations.phi_4;
    const Scalar l_lambda_wheel_1_x = multipliers.lambda_wheel_1_x;
    const Scalar l_lambda_wheel_1_y = multipliers.lambda_wheel_1_y;
    const Scalar l_lambda_wheel_3_x = multipliers.lambda_wheel_3_x;
    const Scalar l_lambda_wheel_3_y = multipliers.lambda_wheel_3_y;
    const Scalar l_lambda_wheel_2_y = multipliers.lambda_wheel_2_y;
    const Scalar l_lambda_wheel_4_y = multipliers.lambda_wheel_4_y;
    const Scalar z294 = precomputed.z294;
    const Scalar z295 = precomputed.z295;
    const Scalar z302 = precomputed.z302;
    const Scalar z303 = precomputed.z303;
    const Scalar z310 = precomputed.z310;
    const Scalar z316 = precomputed.z316;
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
    const Scalar z217 = n3 * v_phi_1;
    const Scalar z218 = n3 * v_phi_2;
    const Scalar z219 = n3 * v_phi_3;
    const Scalar z220 = n3 * v_phi_4;
    const Scalar z269 = n0_9 * a_phi_4;  // moment on wheel_4, x
    const Scalar z270 = n0_5 * a_psi;  // moment on steered_4, z
    const Scalar z273 = n0_9 * a_phi_3;  // moment on wheel_3, x
    const Scalar z276 = n0_9 * a_phi_2;  // moment on wheel_2, x
    const Scalar z279 = n0_9 * a_phi_1;  // moment on wheel_1, x
    const Scalar z284 = k3 * a_psi + n4 * z270;  // moment on S, z
    const Scalar z287 = n880 * a_x;  // force on S.y, x
    const Scalar z288 = n880 * a_y;  // force on S.y, y
    const Scalar z290 = z217 + z279;
    const Scalar z291 = z218 + z276;
    const Scalar z292 = z219 + z273;
    const Scalar z293 = z220 + z269;
    forces.x = z80 * l_lambda_wheel_1_y - z81 * l_lambda_wheel_1_x + z99 * l_lambda_wheel_2_y + z116
        * l_lambda_wheel_3_y - z117 * l_lambda_wheel_3_x + z133 * l_lambda_wheel_4_y + z287;
    forces.y = -z80 * l_lambda_wheel_1_x - z81 * l_lambda_wheel_1_y - z100 * l_lambda_wheel_2_y - z116
        * l_lambda_wheel_3_x - z117 * l_lambda_wheel_3_y - z134 * l_lambda_wheel_4_y + z288;
    forces.psi = z284 - z294 * l_lambda_wheel_1_y - z295 * l_lambda_wheel_1_x + z302 * l_lambda_wheel_3_y + z303
        * l_lambda_wheel_3_x - z310 * l_lambda_wheel_2_y + z316 * l_lambda_wheel_4_y;
    forces.phi_1 = z290 - n0_3 * l_lambda_wheel_1_y;
    forces.phi_2 = z291 - n0_3 * l_lambda_wheel_2_y;
    forces.phi_3 = z292 - n0_3 * l_lambda_wheel_3_y;
    forces.phi_4 = z293 - n0_3 * l_lambda_wheel_4_y;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs& inputs, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n10_over_9 = traits::constant(1.1111111111111112, 1.1111112f, "10/9");
    const Scalar n1_over_880 = traits::constant(0.0011363636363636363, 0.0011363636f, "1/880");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
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
    const Scalar u_C3 = inputs.C3;
    const Scalar u_C4 = inputs.C4;
    const Scalar z294 = precomputed.z294;
    const Scalar z295 = precomputed.z295;
    const Scalar z302 = precomputed.z302;
    const Scalar z303 = precomputed.z303;
    const Scalar z310 = precomputed.z310;
    const Scalar z316 = precomputed.z316;
    const Scalar z336 = precomputed.z336;
    const Scalar z337 = precomputed.z337;
    const Scalar z340 = precomputed.z340;
    const Scalar z341 = precomputed.z341;
    const Scalar z344 = precomputed.z344;
    const Scalar z347 = precomputed.z347;
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
    const Scalar z217 = n3 * v_phi_1;
    const Scalar z218 = n3 * v_phi_2;
    const Scalar z219 = n3 * v_phi_3;
    const Scalar z220 = n3 * v_phi_4;
    const Scalar z297 = v_psi * z80;
    const Scalar z298 = v_psi * z81;
    const Scalar z299 = v_x * z297 - v_y * z298;
    const Scalar z301 = v_x * z298 + v_y * z297;
    const Scalar z305 = v_psi * z116;
    const Scalar z306 = v_psi * z117;
    const Scalar z307 = v_x * z305 - v_y * z306;
    const Scalar z309 = v_x * z306 + v_y * z305;
    const Scalar z313 = v_psi * z100;
    const Scalar z314 = v_psi * z99;
    const Scalar z315 = v_x * z313 + v_y * z314;
    const Scalar z319 = v_psi * z134;
    const Scalar z320 = v_psi * z133;
    const Scalar z321 = v_x * z319 + v_y * z320;
    const Scalar z328 = u_C3 - z219;
    const Scalar z329 = u_C4 - z220;
    const Scalar z330 = n10_over_9 * z217;
    const Scalar z331 = n10_over_9 * z218;
    const Scalar z332 = n10_over_9 * z328;
    const Scalar z333 = n10_over_9 * z329;
    const Scalar z334 = n1_over_880 * z81;
    const Scalar z335 = n1_over_880 * z80;
    const Scalar z338 = n1_over_880 * z117;
    const Scalar z339 = n1_over_880 * z116;
    const Scalar z342 = n1_over_880 * z99;
    const Scalar z343 = n1_over_880 * z100;
    const Scalar z345 = n1_over_880 * z133;
    const Scalar z346 = n1_over_880 * z134;
    const Scalar z348 = z80 * z335 + z81 * z334 + z295 * z336;
    const Scalar z349 = z80 * z334 - z81 * z335 - z294 * z336;
    const Scalar z350 = n0_1 + z80 * z335 + z81 * z334 + z294 * z337;
    const Scalar z351 = z301 + n0_3 * z330;
    const Scalar z352 = z116 * z335 + z117 * z334 - z303 * z336;
    const Scalar z353 = z116 * z334 - z117 * z335 - z303 * z337;
    const Scalar z354 = z116 * z339 + z117 * z338 + z303 * z340;
    const Scalar z355 = z116 * z334 - z117 * z335 + z302 * z336;
    const Scalar z356 = z116 * z335 + z117 * z334 - z302 * z337;
    const Scalar z357 = z116 * z338 - z117 * z339 - z302 * z340;
    const Scalar z358 = n0_1 + z116 * z339 + z117 * z338 + z302 * z341;
    const Scalar z359 = z309 - n0_3 * z332;
    const Scalar z360 = z99 * z334 - z100 * z335 - z310 * z336;
    const Scalar z361 = z99 * z335 + z100 * z334 + z310 * z337;
    const Scalar z362 = z99 * z338 - z100 * z339 + z310 * z340;
    const Scalar z363 = z99 * z339 + z100 * z338 - z310 * z341;
    const Scalar z364 = n0_1 + z99 * z342 + z100 * z343 + z310 * z344;
    const Scalar z365 = z315 + n0_3 * z331;
    const Scalar z366 = z133 * z334 - z134 * z335 + z316 * z336;
    const Scalar z367 = z133 * z335 + z134 * z334 - z316 * z337;
    const Scalar z368 = z133 * z338 - z134 * z339 - z316 * z340;
    const Scalar z369 = z133 * z339 + z134 * z338 + z316 * z341;
    const Scalar z370 = z133 * z342 + z134 * z343 - z316 * z344;
    const Scalar z371 = n0_1 + z133 * z345 + z134 * z346 + z316 * z347;
    const Scalar z372 = z321 - n0_3 * z333;
    const Scalar z373 = n1 / z371;
    const Scalar z374 = z366 * z373;
    const Scalar z375 = z367 * z373;
    const Scalar z376 = z368 * z373;
    const Scalar z377 = z369 * z373;
    const Scalar z378 = z370 * z373;
    const Scalar z379 = z348 - z366 * z374;
    const Scalar z380 = z349 - z366 * z375;
    const Scalar z381 = z350 - z367 * z375;
    const Scalar z382 = z352 - z366 * z376;
    const Scalar z383 = z353 + z367 * z376;
    const Scalar z384 = z354 - z368 * z376;
    const Scalar z385 = z355 - z366 * z377;
    const Scalar z386 = z356 - z367 * z377;
    const Scalar z387 = z357 - z368 * z377;
    const Scalar z388 = z358 - z369 * z377;
    const Scalar z389 = z360 - z366 * z378;
    const Scalar z390 = z361 - z367 * z378;
    const Scalar z391 = z362 - z368 * z378;
    const Scalar z392 = z363 - z369 * z378;
    const Scalar z393 = z364 - z370 * z378;
    const Scalar z394 = n1 / z393;
    const Scalar z395 = z389 * z394;
    const Scalar z396 = z390 * z394;
    const Scalar z397 = z391 * z394;
    const Scalar z398 = z392 * z394;
    const Scalar z399 = z379 - z389 * z395;
    const Scalar z400 = z380 - z389 * z396;
    const Scalar z401 = z381 - z390 * z396;
    const Scalar z402 = z382 - z389 * z397;
    const Scalar z403 = z383 + z390 * z397;
    const Scalar z404 = z384 - z391 * z397;
    const Scalar z405 = z385 - z389 * z398;
    const Scalar z406 = z386 - z390 * z398;
    const Scalar z407 = z387 - z391 * z398;
    const Scalar z408 = z388 - z392 * z398;
    const Scalar z409 = n1 / z408;
    const Scalar z410 = z405 * z409;
    const Scalar z411 = z406 * z409;
    const Scalar z412 = z407 * z409;
    const Scalar z413 = z399 - z405 * z410;
    const Scalar z414 = z400 - z405 * z411;
    const Scalar z415 = z401 - z406 * z411;
    const Scalar z416 = z402 - z405 * z412;
    const Scalar z417 = z403 + z406 * z412;
    const Scalar z418 = z404 - z407 * z412;
    const Scalar z419 = n1 / z418;
    const Scalar z420 = z416 * z419;
    const Scalar z421 = z417 * z419;
    const Scalar z422 = z413 - z416 * z420;
    const Scalar z423 = z414 + z416 * z421;
    const Scalar z424 = z415 - z417 * z421;
    const Scalar z425 = n1 / z424;
    const Scalar z426 = z423 * z425;
    const Scalar z427 = z422 - z423 * z426;
    const Scalar z428 = n1 / z427;
    const Scalar z429 = z365 - z372 * z378;
    const Scalar z430 = z359 - z372 * z377 - z398 * z429;
    const Scalar z431 = z307 + z372 * z376 + z397 * z429 + z412 * z430;
    const Scalar z432 = z351 - z372 * z375 - z396 * z429 - z411 * z430 - z421 * z431;
    const Scalar z433 = z299 + z372 * z374 + z395 * z429 + z410 * z430 - z420 * z431 + z426 * z432;
    const Scalar z434 = z428 * z433;
    const Scalar z435 = z425 * z432 + z426 * z434;
    const Scalar z436 = z419 * z431 - z420 * z434 - z421 * z435;
    const Scalar z437 = z409 * z430 + z410 * z434 - z411 * z435 + z412 * z436;
    const Scalar z438 = z394 * z429 + z395 * z434 - z396 * z435 + z397 * z436 - z398 * z437;
    const Scalar z439 = z372 * z373 + z374 * z434 - z375 * z435 + z376 * z436 - z377 * z437 - z378 * z438;
    const Scalar z440 = z334 * z434 - z335 * z435 + z338 * z436 - z339 * z437 - z342 * z438 - z345 * z439;
    const Scalar z441 = z334 * z435 + z335 * z434 + z338 * z437 + z339 * z436 + z343 * z438 + z346 * z439;
    const Scalar z442 = z336 * z434 + z337 * z435 - z340 * z436 - z341 * z437 + z344 * z438 - z347 * z439;
    const Scalar z443 = z330 - n1_over_3 * z435;
    const Scalar z444 = z331 - n1_over_3 * z438;
    const Scalar z445 = z332 + n1_over_3 * z437;
    const Scalar z446 = z333 + n1_over_3 * z439;
    accelerations.x = z440;
    accelerations.y = z441;
    accelerations.psi = z442;
    accelerations.phi_1 = -z443;
    accelerations.phi_2 = -z444;
    accelerations.phi_3 = z445;
    accelerations.phi_4 = z446;
    multipliers.lambda_wheel_1_x = z434;
    multipliers.lambda_wheel_1_y = z435;
    multipliers.lambda_wheel_3_x = z436;
    multipliers.lambda_wheel_3_y = z437;
    multipliers.lambda_wheel_2_y = z438;
    multipliers.lambda_wheel_4_y = z439;
    if (!(traits::regular(z427, z348) && traits::regular(z424, z350) && traits::regular(z418, z354)
        && traits::regular(z408, z358) && traits::regular(z393, z364) && traits::regular(z371,
        z371))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.x - accelerations.x) + (accelerations.y - accelerations.y) + (accelerations.psi
        - accelerations.psi) + (accelerations.phi_1 - accelerations.phi_1) + (accelerations.phi_2 - accelerations.phi_2)
        + (accelerations.phi_3 - accelerations.phi_3) + (accelerations.phi_4 - accelerations.phi_4)
        + (multipliers.lambda_wheel_1_x - multipliers.lambda_wheel_1_x) + (multipliers.lambda_wheel_1_y
        - multipliers.lambda_wheel_1_y) + (multipliers.lambda_wheel_3_x - multipliers.lambda_wheel_3_x)
        + (multipliers.lambda_wheel_3_y - multipliers.lambda_wheel_3_y) + (multipliers.lambda_wheel_2_y
        - multipliers.lambda_wheel_2_y) + (multipliers.lambda_wheel_4_y - multipliers.lambda_wheel_4_y);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar k0 = traits::constant(0.7320508075688773, 0.73205084f, "-1;0;1;0");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
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
    const Scalar u_C3 = inputs.C3;
    const Scalar u_C4 = inputs.C4;
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
    const Scalar z217 = n3 * v_phi_1;
    const Scalar z218 = n3 * v_phi_2;
    const Scalar z219 = n3 * v_phi_3;
    const Scalar z220 = n3 * v_phi_4;
    result.kinetic = n10 * (z47 * z47 + z51 * z51 + z52 * z52 + z54 * z54 + z58 * z58 + z59 * z59 + z61 * z61 + z65
        * z65 + z66 * z66 + z67 * z67 + z71 * z71 + z72 * z72) + n0_25 * (z49 * z49 + z50 * z50 + z56 * z56 + z57 * z57
        + z63 * z63 + z64 * z64 + z69 * z69 + z70 * z70) + n0_45 * (v_phi_1 * v_phi_1 + v_phi_2 * v_phi_2 + v_phi_3
        * v_phi_3 + v_phi_4 * v_phi_4) + n400 * (z43 * z43 + z44 * z44) + n450 * v_psi * v_psi;
    result.force_function = n0;
    result.power = v_phi_3 * (u_C3 - z219) + v_phi_4 * (u_C4 - z220) - v_phi_1 * z217 - v_phi_2 * z218;
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
    const Scalar z294 = precomputed.z294;
    const Scalar z295 = precomputed.z295;
    const Scalar z302 = precomputed.z302;
    const Scalar z303 = precomputed.z303;
    const Scalar z310 = precomputed.z310;
    const Scalar z316 = precomputed.z316;
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
    const Scalar z296 = v_x * z81 + v_y * z80 + v_psi * z295;
    const Scalar z297 = v_psi * z80;
    const Scalar z298 = v_psi * z81;
    const Scalar z299 = v_x * z297 - v_y * z298;
    const Scalar z300 = v_x * z80 - v_y * z81 - v_psi * z294 - n0_3 * v_phi_1;
    const Scalar z301 = v_x * z298 + v_y * z297;
    const Scalar z304 = v_x * z117 + v_y * z116 - v_psi * z303;
    const Scalar z305 = v_psi * z116;
    const Scalar z306 = v_psi * z117;
    const Scalar z307 = v_x * z305 - v_y * z306;
    const Scalar z308 = v_x * z116 - v_y * z117 + v_psi * z302 - n0_3 * v_phi_3;
    const Scalar z309 = v_x * z306 + v_y * z305;
    const Scalar z312 = v_x * z99 - v_y * z100 - v_psi * z310 - n0_3 * v_phi_2;
    const Scalar z313 = v_psi * z100;
    const Scalar z314 = v_psi * z99;
    const Scalar z315 = v_x * z313 + v_y * z314;
    const Scalar z318 = v_x * z133 - v_y * z134 + v_psi * z316 - n0_3 * v_phi_4;
    const Scalar z319 = v_psi * z134;
    const Scalar z320 = v_psi * z133;
    const Scalar z321 = v_x * z319 + v_y * z320;
    result.value[0] = n0;
    result.rate[0] = z296;
    result.gamma[0] = -z299;
    result.value[1] = n0;
    result.rate[1] = -z300;
    result.gamma[1] = -z301;
    result.value[2] = n0;
    result.rate[2] = z304;
    result.gamma[2] = -z307;
    result.value[3] = n0;
    result.rate[3] = -z308;
    result.gamma[3] = -z309;
    result.value[4] = n0;
    result.rate[4] = -z312;
    result.gamma[4] = -z315;
    result.value[5] = n0;
    result.rate[5] = -z318;
    result.gamma[5] = -z321;
    result.jacobian[0] = z81;
    result.jacobian[1] = -z80;
    result.jacobian[2] = z117;
    result.jacobian[3] = -z116;
    result.jacobian[4] = -z99;
    result.jacobian[5] = -z133;
    result.jacobian[6] = z80;
    result.jacobian[7] = z81;
    result.jacobian[8] = z116;
    result.jacobian[9] = z117;
    result.jacobian[10] = z100;
    result.jacobian[11] = z134;
    result.jacobian[12] = z295;
    result.jacobian[13] = z294;
    result.jacobian[14] = -z303;
    result.jacobian[15] = -z302;
    result.jacobian[16] = z310;
    result.jacobian[17] = -z316;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0_3;
    result.jacobian[20] = n0;
    result.jacobian[21] = n0;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0;
    result.jacobian[26] = n0;
    result.jacobian[27] = n0;
    result.jacobian[28] = n0_3;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0_3;
    result.jacobian[34] = n0;
    result.jacobian[35] = n0;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = n0;
    result.jacobian[41] = n0_3;
  }
};

}  // namespace four_wheel_vehicle
