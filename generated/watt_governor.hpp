// SPDX-License-Identifier: MIT
// watt_governor: Watt's governor at a given speed
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, reactions, linearisation
// Parameters set at run time: m, M, L, omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                0                4          0             0                  0       0      4       -
//   kinematics                6               32          0             0                  2       0     42      42
//   mass_matrix               1                5          0             0                  1       0      8      10
//   bias                      3               15          0             0                  1       0     20      23
//   inverse_dynamics          5               16          0             0                  1       0     23      27
//   forward_dynamics          4               19          1             0                  1       0     26      29
//   energy                    3               16          0             0                  1       0     21      25
//   first_integrals           6               22          0             0                  1       0     30      35
//   reactions                 0                5          0             0                  1       0      7      10
//   linearisation            12               42          1             0                  1       0     57      61
//
// Not computed because this mechanism does not need it:
//   kinematics: of 54 results 12 vanish identically, 21 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   linearisation: of 8 results 1 vanish identically
//
// To write this file again:
//   watt_governor_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output watt_governor.hpp
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

namespace watt_governor {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "watt_governor";
  static constexpr int coordinate_count = 1;
  static constexpr int velocity_count = 1;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar m;  ///< parameter [kg]
    Scalar M;  ///< parameter [kg]
    Scalar L;  ///< parameter [m]
    Scalar omega;  ///< parameter [rad/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::m, &Parameters::M, &Parameters::L, &Parameters::omega};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar theta;  ///< coordinate [rad or 1]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::theta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar theta;  ///< its rate [rad/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::theta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar theta;  ///< its second rate [rad/s^2]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::theta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar theta;  ///< works with the rate of theta [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::theta};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    static constexpr int size = 0;
  };

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    static constexpr int size = 0;
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
    Scalar z16;
    Scalar z17;
    Scalar z19;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n12 = traits::constant(12.0, 12.0f, "12/1");
    parameters.m = n1;
    parameters.M = n2;
    parameters.L = n0_5;
    parameters.omega = n12;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_L = parameters.L;
    const Scalar p_m = parameters.m;
    const Scalar z16 = p_L * p_L * p_m;
    const Scalar z17 = p_L * p_m;
    const Scalar z19 = n2 * z16;
    precomputed.z16 = z16;
    precomputed.z17 = z17;
    precomputed.z19 = z19;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    state.time = n0;
    state.q.theta = n1;
    state.v.theta = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> ball_1_position;  ///< centre of mass of ball_1 [m]
    std::array<Scalar, 9> ball_1_rotation;  ///< from the axes of ball_1 to the ground's (3 x 3)
    std::array<Scalar, 3> ball_1_velocity;  ///< velocity of the centre of mass of ball_1 [m/s]
    std::array<Scalar, 3> ball_1_angular_velocity;  ///< angular velocity of ball_1 [rad/s]
    std::array<Scalar, 3> ball_2_position;  ///< centre of mass of ball_2 [m]
    std::array<Scalar, 9> ball_2_rotation;  ///< from the axes of ball_2 to the ground's (3 x 3)
    std::array<Scalar, 3> ball_2_velocity;  ///< velocity of the centre of mass of ball_2 [m/s]
    std::array<Scalar, 3> ball_2_angular_velocity;  ///< angular velocity of ball_2 [rad/s]
    std::array<Scalar, 3> sleeve_position;  ///< centre of mass of sleeve [m]
    std::array<Scalar, 9> sleeve_rotation;  ///< from the axes of sleeve to the ground's (3 x 3)
    std::array<Scalar, 3> sleeve_velocity;  ///< velocity of the centre of mass of sleeve [m/s]
    std::array<Scalar, 3> sleeve_angular_velocity;  ///< angular velocity of sleeve [rad/s]
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
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::painleve};
      return members_[i_];
    }
  };
  static constexpr int first_integral_count = 1;

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar motor;  ///< reaction along 'motor' [kg m^2 s^-2]
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
    std::array<Scalar, 1> M;  ///< mass matrix
    std::array<Scalar, 1> C;  ///< damping and gyroscopic terms
    std::array<Scalar, 1> K;  ///< stiffness
    std::array<Scalar, 1> F;  ///< right-hand side
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, e'): x' = A x + B du (2 x 2)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar z2 = p_omega * t;
    Scalar z3, z4;
    traits::sincos(z2, z3, z4);
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z11 = v_theta * s_theta;
    const Scalar z21 = p_omega * s_theta;
    const Scalar z22 = p_omega * c_theta;
    const Scalar z23 = n2 * c_theta * p_L;
    const Scalar z24 = n2 * p_L * z11;  // velocity of sleeve, z
    const Scalar z25 = s_theta * p_L;
    const Scalar z26 = c_theta * p_L;
    const Scalar z27 = z4 * z25;
    const Scalar z28 = z3 * z25;
    const Scalar z29 = z4 * c_theta;
    const Scalar z30 = z3 * c_theta;
    const Scalar z31 = z4 * s_theta;
    const Scalar z32 = z3 * s_theta;
    const Scalar z33 = v_theta * p_L;
    const Scalar z34 = p_L * z21;
    const Scalar z35 = c_theta * z33;
    const Scalar z36 = s_theta * z33;
    const Scalar z37 = z3 * z34 - z4 * z35;
    const Scalar z38 = z3 * z35 + z4 * z34;
    const Scalar z39 = s_theta * z22 - c_theta * z21;
    const Scalar z40 = s_theta * z21 + c_theta * z22;
    const Scalar z41 = z3 * v_theta - z4 * z39;
    const Scalar z42 = z3 * z39 + z4 * v_theta;
    result.ball_1_position[0] = -z27;
    result.ball_1_position[1] = -z28;
    result.ball_1_position[2] = -z26;
    result.ball_1_rotation[0] = z29;
    result.ball_1_rotation[1] = z30;
    result.ball_1_rotation[2] = -s_theta;
    result.ball_1_rotation[3] = -z3;
    result.ball_1_rotation[4] = z4;
    result.ball_1_rotation[5] = n0;
    result.ball_1_rotation[6] = z31;
    result.ball_1_rotation[7] = z32;
    result.ball_1_rotation[8] = c_theta;
    result.ball_1_velocity[0] = z37;
    result.ball_1_velocity[1] = -z38;
    result.ball_1_velocity[2] = z36;
    result.ball_1_angular_velocity[0] = -z41;
    result.ball_1_angular_velocity[1] = z42;
    result.ball_1_angular_velocity[2] = z40;
    result.ball_2_position[0] = z27;
    result.ball_2_position[1] = z28;
    result.ball_2_position[2] = -z26;
    result.ball_2_rotation[0] = z29;
    result.ball_2_rotation[1] = z30;
    result.ball_2_rotation[2] = s_theta;
    result.ball_2_rotation[3] = -z3;
    result.ball_2_rotation[4] = z4;
    result.ball_2_rotation[5] = n0;
    result.ball_2_rotation[6] = -z31;
    result.ball_2_rotation[7] = -z32;
    result.ball_2_rotation[8] = c_theta;
    result.ball_2_velocity[0] = -z37;
    result.ball_2_velocity[1] = z38;
    result.ball_2_velocity[2] = z36;
    result.ball_2_angular_velocity[0] = z41;
    result.ball_2_angular_velocity[1] = -z42;
    result.ball_2_angular_velocity[2] = z40;
    result.sleeve_position[0] = n0;
    result.sleeve_position[1] = n0;
    result.sleeve_position[2] = -z23;
    result.sleeve_rotation[0] = z4;
    result.sleeve_rotation[1] = z3;
    result.sleeve_rotation[2] = n0;
    result.sleeve_rotation[3] = -z3;
    result.sleeve_rotation[4] = z4;
    result.sleeve_rotation[5] = n0;
    result.sleeve_rotation[6] = n0;
    result.sleeve_rotation[7] = n0;
    result.sleeve_rotation[8] = n1;
    result.sleeve_velocity[0] = n0;
    result.sleeve_velocity[1] = n0;
    result.sleeve_velocity[2] = z24;
    result.sleeve_angular_velocity[0] = n0;
    result.sleeve_angular_velocity[1] = n0;
    result.sleeve_angular_velocity[2] = p_omega;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 1>& mass) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar q_theta = state.q.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar z16 = precomputed.z16;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z14 = n2 * s_theta * p_L;
    const Scalar z43 = z14 * p_M;
    const Scalar z71 = z14 * z43 + n2 * z16;
    mass[0] = z71;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar z16 = precomputed.z16;
    const Scalar z17 = precomputed.z17;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z12 = v_theta * c_theta;
    const Scalar z14 = n2 * s_theta * p_L;
    const Scalar z21 = p_omega * s_theta;
    const Scalar z22 = p_omega * c_theta;
    const Scalar z72 = n9_81 * s_theta;
    const Scalar z76 = v_theta * z12;
    const Scalar z77 = n9_81 + n2 * p_L * z76;
    const Scalar z78 = p_M * z77;  // force on sleeve, z
    const Scalar z79 = z21 * z22;
    const Scalar z88 = z16 * z79 - z17 * z72;  // moment on arm_2, y
    const Scalar z95 = z14 * z78 - n2 * z88;
    forces.theta = z95;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar z16 = precomputed.z16;
    const Scalar z17 = precomputed.z17;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z12 = v_theta * c_theta;
    const Scalar z13 = v_theta * z12 + a_theta * s_theta;
    const Scalar z14 = n2 * s_theta * p_L;
    const Scalar z21 = p_omega * s_theta;
    const Scalar z22 = p_omega * c_theta;
    const Scalar z72 = n9_81 * s_theta;
    const Scalar z79 = z21 * z22;
    const Scalar z96 = n9_81 + n2 * p_L * z13;
    const Scalar z97 = p_M * z96;  // force on sleeve, z
    const Scalar z100 = z16 * (a_theta - z79) + z17 * z72;  // moment on arm_2, y
    const Scalar z104 = z14 * z97 + n2 * z100;
    forces.theta = z104;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar z16 = precomputed.z16;
    const Scalar z17 = precomputed.z17;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z12 = v_theta * c_theta;
    const Scalar z14 = n2 * s_theta * p_L;
    const Scalar z21 = p_omega * s_theta;
    const Scalar z22 = p_omega * c_theta;
    const Scalar z43 = z14 * p_M;
    const Scalar z71 = z14 * z43 + n2 * z16;
    const Scalar z72 = n9_81 * s_theta;
    const Scalar z76 = v_theta * z12;
    const Scalar z77 = n9_81 + n2 * p_L * z76;
    const Scalar z78 = p_M * z77;  // force on sleeve, z
    const Scalar z79 = z21 * z22;
    const Scalar z88 = z16 * z79 - z17 * z72;  // moment on arm_2, y
    const Scalar z95 = z14 * z78 - n2 * z88;
    const Scalar z105 = n1 / z71;
    const Scalar z106 = z95 * z105;
    accelerations.theta = -z106;
    if (!(traits::regular(z71, z71))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.theta - accelerations.theta);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar z16 = precomputed.z16;
    const Scalar z17 = precomputed.z17;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z11 = v_theta * s_theta;
    const Scalar z21 = p_omega * s_theta;
    const Scalar z23 = n2 * c_theta * p_L;
    const Scalar z24 = n2 * p_L * z11;  // velocity of sleeve, z
    const Scalar z47 = c_theta * z17;
    result.kinetic = z16 * (v_theta * v_theta + z21 * z21) + n0_5 * p_M * z24 * z24;
    result.force_function = n9_81 * p_M * z23 + n19_62 * z47;
    result.power = n0;
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar z16 = precomputed.z16;
    const Scalar z17 = precomputed.z17;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z11 = v_theta * s_theta;
    const Scalar z21 = p_omega * s_theta;
    const Scalar z23 = n2 * c_theta * p_L;
    const Scalar z24 = n2 * p_L * z11;  // velocity of sleeve, z
    const Scalar z47 = c_theta * z17;
    const Scalar z109 = p_M * z24;
    const Scalar z114 = n2 * p_L * z109;
    const Scalar z117 = n2 * v_theta * z16 + s_theta * z114;
    result.painleve = -v_theta * (v_theta * z16 - z117) - p_M * (n9_81 * z23 + n0_5 * z24 * z24) - z16 * z21 * z21
        - n19_62 * z47;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state, const Accelerations&,
      const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar z19 = precomputed.z19;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z22 = p_omega * c_theta;
    const Scalar z74 = v_theta * z22;  // angular acceleration of arm_1, x
    const Scalar z87 = z19 * z74;  // moment on arm_2, x
    const Scalar z92 = s_theta * z87;
    const Scalar z94 = n2 * z92;  // moment on shaft, z
    result.motor = z94;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar p_L = precomputed.parameters.L;
    const Scalar p_M = precomputed.parameters.M;
    const Scalar z16 = precomputed.z16;
    const Scalar z17 = precomputed.z17;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z11 = v_theta * s_theta;
    const Scalar z12 = v_theta * c_theta;
    const Scalar z13 = v_theta * z12 + a_theta * s_theta;
    const Scalar z14 = n2 * s_theta * p_L;
    const Scalar z21 = p_omega * s_theta;
    const Scalar z22 = p_omega * c_theta;
    const Scalar z23 = n2 * c_theta * p_L;
    const Scalar z43 = z14 * p_M;
    const Scalar z71 = z14 * z43 + n2 * z16;
    const Scalar z72 = n9_81 * s_theta;
    const Scalar z73 = n9_81 * c_theta;
    const Scalar z79 = z21 * z22;
    const Scalar z96 = n9_81 + n2 * p_L * z13;
    const Scalar z97 = p_M * z96;  // force on sleeve, z
    const Scalar z100 = z16 * (a_theta - z79) + z17 * z72;  // moment on arm_2, y
    const Scalar z104 = z14 * z97 + n2 * z100;
    const Scalar z105 = n1 / z71;
    const Scalar z120 = v_theta * c_theta + z12;
    const Scalar z121 = n2 * p_L * z120;
    const Scalar z122 = p_M * z121;
    const Scalar z123 = z14 * z122;
    const Scalar z124 = v_theta * z11 - a_theta * c_theta;
    const Scalar z125 = n2 * p_L * z124;
    const Scalar z126 = p_M * z125;
    const Scalar z127 = z21 * z21 - z22 * z22;
    const Scalar z128 = z16 * z127 + z17 * z73;
    const Scalar z129 = z14 * z126 - z23 * z97 - n2 * z128;
    const Scalar z130 = z105 * z129;
    const Scalar z131 = z105 * z123;
    result.M[0] = z71;
    result.C[0] = z123;
    result.K[0] = -z129;
    result.F[0] = -z104;
    result.A[0] = n0;
    result.A[1] = z130;
    result.A[2] = n1;
    result.A[3] = -z131;
    if (!(traits::regular(z71, z71))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (result.M[0] - result.M[0]) + (result.C[0] - result.C[0]) + (result.K[0] - result.K[0])
        + (result.F[0] - result.F[0]) + (result.A[1] - result.A[1]) + (result.A[3] - result.A[3]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace watt_governor
