// SPDX-License-Identifier: MIT
// passenger_in_vehicle: Passenger in a vehicle: trunk and head
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: V
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total); before: without inertia
// moved across joints, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               29               37          0             0                  3       0     72      72
//   mass_matrix               3                3          0             0                  1       0      8       8
//   bias                      9               16          0             0                  2       0     29      37
//   inverse_dynamics         14               21          0             0                  2       0     39      46
//   forward_dynamics         15               25          1             0                  2       0     45      53
//   energy                   21               37          0             0                  3       0     64      68
//   linearisation            35               60          1             0                  2       0    100     128
//
// Not computed because this mechanism does not need it:
//   kinematics: of 60 results 31 vanish identically, 4 repeat another up to sign
//   mass_matrix: of 4 results 1 repeat another up to sign
//   first_integrals: left out, 'back_damping', 'neck_damping' have no force function
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 30 results 6 vanish identically, 1 repeat another up to sign
//
// To write this file again:
//   passenger_in_vehicle_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output passenger_in_vehicle.hpp
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

namespace passenger_in_vehicle {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "passenger_in_vehicle";
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar V;  ///< parameter [m/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::V};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar theta_1;  ///< coordinate [rad or 1]
    Scalar theta_2;  ///< coordinate [rad or 1]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::theta_1, &Coordinates::theta_2};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar theta_1;  ///< its rate [rad/s]
    Scalar theta_2;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::theta_1, &Velocities::theta_2};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar theta_1;  ///< its second rate [rad/s^2]
    Scalar theta_2;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::theta_1, &Accelerations::theta_2};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar theta_1;  ///< works with the rate of theta_1 [N m]
    Scalar theta_2;  ///< works with the rate of theta_2 [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::theta_1, &GeneralizedForces::theta_2};
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
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    parameters.V = n15;
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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    state.time = n0;
    state.q.theta_1 = -n0_3;
    state.q.theta_2 = -n0_4;
    state.v.theta_1 = n0;
    state.v.theta_2 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> trunk_position;  ///< centre of mass of trunk [m]
    std::array<Scalar, 9> trunk_rotation;  ///< from the axes of trunk to the ground's (3 x 3)
    std::array<Scalar, 3> trunk_velocity;  ///< velocity of the centre of mass of trunk [m/s]
    std::array<Scalar, 3> trunk_angular_velocity;  ///< angular velocity of trunk [rad/s]
    std::array<Scalar, 3> head_position;  ///< centre of mass of head [m]
    std::array<Scalar, 9> head_rotation;  ///< from the axes of head to the ground's (3 x 3)
    std::array<Scalar, 3> head_velocity;  ///< velocity of the centre of mass of head [m/s]
    std::array<Scalar, 3> head_angular_velocity;  ///< angular velocity of head [rad/s]
    std::array<Scalar, 3> I_position;  ///< position of I [m]
    std::array<Scalar, 3> I_velocity;  ///< velocity of the material point at I [m/s]
    std::array<Scalar, 6> I_jacobian;  ///< partial velocities of I (3 x 2)
    std::array<Scalar, 3> K_position;  ///< position of K [m]
    std::array<Scalar, 3> K_velocity;  ///< velocity of the material point at K [m/s]
    std::array<Scalar, 6> K_jacobian;  ///< partial velocities of K (3 x 2)
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
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_V = precomputed.parameters.V;
    const Scalar t = state.time;
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    Scalar s_theta_1, c_theta_1;
    traits::sincos(q_theta_1, s_theta_1, c_theta_1);
    Scalar s_theta_2, c_theta_2;
    traits::sincos(q_theta_2, s_theta_2, c_theta_2);
    const Scalar z13 = p_V * c_theta_1;
    const Scalar z14 = p_V * s_theta_1;
    const Scalar z15 = n0_6 * v_theta_1 - z13;
    const Scalar z16 = s_theta_2 * z14 + c_theta_2 * z15;
    const Scalar z17 = s_theta_2 * z15 - c_theta_2 * z14;
    const Scalar z18 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z19 = n0_35 * s_theta_1;
    const Scalar z20 = n0_35 * c_theta_1;
    const Scalar z21 = n0_8 - z19;
    const Scalar z22 = n0_5 + z20;
    const Scalar z23 = p_V * t + z21;
    const Scalar z24 = n0_35 * v_theta_1 - z13;
    const Scalar z25 = s_theta_1 * z14 - c_theta_1 * z24;
    const Scalar z26 = s_theta_1 * z24 + c_theta_1 * z14;
    const Scalar z27 = n0_15 * s_theta_2;
    const Scalar z28 = n0_15 * c_theta_2;
    const Scalar z29 = n0_6 + z28;
    const Scalar z30 = s_theta_1 * z29 + c_theta_1 * z27;
    const Scalar z31 = s_theta_1 * z27 - c_theta_1 * z29;
    const Scalar z32 = n0_8 - z30;
    const Scalar z33 = n0_5 - z31;
    const Scalar z34 = p_V * t + z32;
    const Scalar z35 = q_theta_1 + q_theta_2;
    Scalar z36, z37;
    traits::sincos(z35, z36, z37);
    const Scalar z38 = z16 + n0_15 * z18;
    const Scalar z39 = z17 * z36 + z37 * z38;
    const Scalar z40 = z17 * z37 - z36 * z38;
    const Scalar z41 = n0_8 + p_V * t;
    const Scalar z42 = s_theta_1 * z14 + c_theta_1 * z13;
    const Scalar z44 = n0_6 * s_theta_1;
    const Scalar z45 = n0_6 * c_theta_1;
    const Scalar z46 = n0_8 - z44;
    const Scalar z47 = n0_5 + z45;
    const Scalar z48 = p_V * t + z46;
    const Scalar z49 = z16 * z37 + z17 * z36;
    const Scalar z50 = z16 * z36 - z17 * z37;
    const Scalar z51 = z41 - z48;
    const Scalar z52 = n0_5 - z47;
    result.trunk_position[0] = z23;
    result.trunk_position[1] = z22;
    result.trunk_position[2] = n0;
    result.trunk_rotation[0] = c_theta_1;
    result.trunk_rotation[1] = s_theta_1;
    result.trunk_rotation[2] = n0;
    result.trunk_rotation[3] = -s_theta_1;
    result.trunk_rotation[4] = c_theta_1;
    result.trunk_rotation[5] = n0;
    result.trunk_rotation[6] = n0;
    result.trunk_rotation[7] = n0;
    result.trunk_rotation[8] = n1;
    result.trunk_velocity[0] = z25;
    result.trunk_velocity[1] = -z26;
    result.trunk_velocity[2] = n0;
    result.trunk_angular_velocity[0] = n0;
    result.trunk_angular_velocity[1] = n0;
    result.trunk_angular_velocity[2] = v_theta_1;
    result.head_position[0] = z34;
    result.head_position[1] = z33;
    result.head_position[2] = n0;
    result.head_rotation[0] = z37;
    result.head_rotation[1] = z36;
    result.head_rotation[2] = n0;
    result.head_rotation[3] = -z36;
    result.head_rotation[4] = z37;
    result.head_rotation[5] = n0;
    result.head_rotation[6] = n0;
    result.head_rotation[7] = n0;
    result.head_rotation[8] = n1;
    result.head_velocity[0] = -z39;
    result.head_velocity[1] = z40;
    result.head_velocity[2] = n0;
    result.head_angular_velocity[0] = n0;
    result.head_angular_velocity[1] = n0;
    result.head_angular_velocity[2] = z18;
    result.I_position[0] = z41;
    result.I_position[1] = n0_5;
    result.I_position[2] = n0;
    result.I_velocity[0] = z42;
    result.I_velocity[1] = n0;
    result.I_velocity[2] = n0;
    result.I_jacobian[0] = n0;
    result.I_jacobian[3] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.K_position[0] = z48;
    result.K_position[1] = z47;
    result.K_position[2] = n0;
    result.K_velocity[0] = -z49;
    result.K_velocity[1] = -z50;
    result.K_velocity[2] = n0;
    result.K_jacobian[0] = z52;
    result.K_jacobian[3] = n0;
    result.K_jacobian[1] = -z51;
    result.K_jacobian[4] = n0;
    result.K_jacobian[2] = n0;
    result.K_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n8_2 = traits::constant(8.2, 8.2f, "41/5");
    const Scalar q_theta_2 = state.q.theta_2;
    Scalar s_theta_2, c_theta_2;
    traits::sincos(q_theta_2, s_theta_2, c_theta_2);
    const Scalar z53 = n0_75 * c_theta_2;
    const Scalar z55 = n0_1425 + n0_6 * z53;
    const Scalar z64 = n0_1425 + n1_2 * z53;
    const Scalar z67 = n8_2 + z64;
    mass[0] = z67;
    mass[1] = z55;
    mass[2] = z55;
    mass[3] = n0_1425;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n600 = traits::constant(600.0, 600.0f, "600/1");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n17 = traits::constant(17.0, 17.0f, "17/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    Scalar s_theta_1, c_theta_1;
    traits::sincos(q_theta_1, s_theta_1, c_theta_1);
    Scalar s_theta_2, c_theta_2;
    traits::sincos(q_theta_2, s_theta_2, c_theta_2);
    const Scalar z18 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z83 = n600 * q_theta_1;
    const Scalar z84 = n25 * v_theta_1;
    const Scalar z85 = n40 * q_theta_2;
    const Scalar z86 = n0_6 * v_theta_2;
    const Scalar z87 = n9_81 * s_theta_1;
    const Scalar z88 = n9_81 * c_theta_1;
    const Scalar z89 = v_theta_1 * v_theta_1;
    const Scalar z90 = z88 - n0_6 * z89;
    const Scalar z91 = s_theta_2 * z90 + c_theta_2 * z87;
    const Scalar z93 = z18 * z18;
    const Scalar z94 = n0_75 * z93;  // force on S2, y
    const Scalar z95 = n0_75 * z91;  // moment on S2, z
    const Scalar z96 = s_theta_2 * z94;
    const Scalar z99 = n17 * z87 + z95 + n0_6 * z96;  // moment on S1, z
    const Scalar z104 = z83 + z84 - z99;
    const Scalar z105 = z85 + z86 - z95;
    forces.theta_1 = z104;
    forces.theta_2 = z105;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n600 = traits::constant(600.0, 600.0f, "600/1");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n8_2 = traits::constant(8.2, 8.2f, "41/5");
    const Scalar n17 = traits::constant(17.0, 17.0f, "17/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    Scalar s_theta_1, c_theta_1;
    traits::sincos(q_theta_1, s_theta_1, c_theta_1);
    Scalar s_theta_2, c_theta_2;
    traits::sincos(q_theta_2, s_theta_2, c_theta_2);
    const Scalar z18 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z83 = n600 * q_theta_1;
    const Scalar z84 = n25 * v_theta_1;
    const Scalar z85 = n40 * q_theta_2;
    const Scalar z86 = n0_6 * v_theta_2;
    const Scalar z87 = n9_81 * s_theta_1;
    const Scalar z88 = n9_81 * c_theta_1;
    const Scalar z89 = v_theta_1 * v_theta_1;
    const Scalar z90 = z88 - n0_6 * z89;
    const Scalar z93 = z18 * z18;
    const Scalar z94 = n0_75 * z93;  // force on S2, y
    const Scalar z106 = n0_6 * a_theta_1 - z87;
    const Scalar z107 = s_theta_2 * z90 - c_theta_2 * z106;
    const Scalar z109 = a_theta_1 + a_theta_2;  // angular acceleration of S2, z
    const Scalar z110 = n0_75 * z109;  // force on S2, x
    const Scalar z111 = n0_75 * z107 - n0_1425 * z109;  // moment on S2, z
    const Scalar z112 = s_theta_2 * z94 - c_theta_2 * z110;
    const Scalar z116 = n8_2 * a_theta_1 - n17 * z87 - z111 - n0_6 * z112;  // moment on S1, z
    const Scalar z121 = z83 + z84 + z116;
    const Scalar z122 = z85 + z86 - z111;
    forces.theta_1 = z121;
    forces.theta_2 = z122;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n8_2 = traits::constant(8.2, 8.2f, "41/5");
    const Scalar n600 = traits::constant(600.0, 600.0f, "600/1");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n17 = traits::constant(17.0, 17.0f, "17/1");
    const Scalar n400_over_57 = traits::constant(7.017543859649122, 7.017544f, "400/57");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    Scalar s_theta_1, c_theta_1;
    traits::sincos(q_theta_1, s_theta_1, c_theta_1);
    Scalar s_theta_2, c_theta_2;
    traits::sincos(q_theta_2, s_theta_2, c_theta_2);
    const Scalar z18 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z53 = n0_75 * c_theta_2;
    const Scalar z55 = n0_1425 + n0_6 * z53;
    const Scalar z64 = n0_1425 + n1_2 * z53;
    const Scalar z67 = n8_2 + z64;
    const Scalar z83 = n600 * q_theta_1;
    const Scalar z84 = n25 * v_theta_1;
    const Scalar z85 = n40 * q_theta_2;
    const Scalar z86 = n0_6 * v_theta_2;
    const Scalar z87 = n9_81 * s_theta_1;
    const Scalar z88 = n9_81 * c_theta_1;
    const Scalar z89 = v_theta_1 * v_theta_1;
    const Scalar z90 = z88 - n0_6 * z89;
    const Scalar z91 = s_theta_2 * z90 + c_theta_2 * z87;
    const Scalar z93 = z18 * z18;
    const Scalar z94 = n0_75 * z93;  // force on S2, y
    const Scalar z95 = n0_75 * z91;  // moment on S2, z
    const Scalar z96 = s_theta_2 * z94;
    const Scalar z99 = n17 * z87 + z95 + n0_6 * z96;  // moment on S1, z
    const Scalar z104 = z83 + z84 - z99;
    const Scalar z105 = z85 + z86 - z95;
    const Scalar z183 = n400_over_57 * z55;
    const Scalar z184 = z55 * z183 - z67;
    const Scalar z185 = n1 / z184;
    const Scalar z186 = z104 - z105 * z183;
    const Scalar z187 = z185 * z186;
    const Scalar z188 = n400_over_57 * z105 + z183 * z187;
    accelerations.theta_1 = z187;
    accelerations.theta_2 = -z188;
    if (!(traits::regular(-z184, z67))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.theta_1 - accelerations.theta_1) + (accelerations.theta_2
        - accelerations.theta_2);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n14 = traits::constant(14.0, 14.0f, "14/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n6_4 = traits::constant(6.4, 6.4f, "32/5");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n20 = traits::constant(20.0, 20.0f, "20/1");
    const Scalar n2_5 = traits::constant(2.5, 2.5f, "5/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n196_2 = traits::constant(196.2, 196.2f, "981/5");
    const Scalar n300 = traits::constant(300.0, 300.0f, "300/1");
    const Scalar n49_05 = traits::constant(49.05, 49.05f, "981/20");
    const Scalar p_V = precomputed.parameters.V;
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    Scalar s_theta_1, c_theta_1;
    traits::sincos(q_theta_1, s_theta_1, c_theta_1);
    Scalar s_theta_2, c_theta_2;
    traits::sincos(q_theta_2, s_theta_2, c_theta_2);
    const Scalar z13 = p_V * c_theta_1;
    const Scalar z14 = p_V * s_theta_1;
    const Scalar z15 = n0_6 * v_theta_1 - z13;
    const Scalar z16 = s_theta_2 * z14 + c_theta_2 * z15;
    const Scalar z17 = s_theta_2 * z15 - c_theta_2 * z14;
    const Scalar z18 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z35 = q_theta_1 + q_theta_2;
    Scalar z36, z37;
    traits::sincos(z35, z36, z37);
    const Scalar z45 = n0_6 * c_theta_1;
    const Scalar z47 = n0_5 + z45;
    const Scalar z84 = n25 * v_theta_1;
    const Scalar z86 = n0_6 * v_theta_2;
    const Scalar z189 = n14 * v_theta_1 - n40 * z13;
    const Scalar z190 = n6_4 * v_theta_1 - n14 * z13;
    const Scalar z191 = n5 * z16 + n0_75 * z18;
    const Scalar z192 = n0_75 * z16 + n0_1425 * z18;
    const Scalar z194 = n14 * c_theta_1;
    const Scalar z196 = n0_75 * z37;
    result.kinetic = n0_5 * (v_theta_1 * z190 - z13 * z189 + z16 * z191 + z18 * z192) + n20 * z14 * z14 + n2_5 * z17
        * z17;
    result.force_function = -n9_81 * (z194 + z196) - n196_2 - n300 * q_theta_1 * q_theta_1 - n20 * q_theta_2 * q_theta_2
        - n49_05 * z47;
    result.power = -v_theta_1 * z84 - v_theta_2 * z86;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n0_75 = traits::constant(0.75, 0.75f, "3/4");
    const Scalar n0_1425 = traits::constant(0.1425, 0.1425f, "57/400");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n8_2 = traits::constant(8.2, 8.2f, "41/5");
    const Scalar n600 = traits::constant(600.0, 600.0f, "600/1");
    const Scalar n25 = traits::constant(25.0, 25.0f, "25/1");
    const Scalar n40 = traits::constant(40.0, 40.0f, "40/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n17 = traits::constant(17.0, 17.0f, "17/1");
    const Scalar n400_over_57 = traits::constant(7.017543859649122, 7.017544f, "400/57");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n80_over_19 = traits::constant(4.2105263157894735, 4.2105265f, "80/19");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    Scalar s_theta_1, c_theta_1;
    traits::sincos(q_theta_1, s_theta_1, c_theta_1);
    Scalar s_theta_2, c_theta_2;
    traits::sincos(q_theta_2, s_theta_2, c_theta_2);
    const Scalar z18 = v_theta_1 + v_theta_2;  // angular velocity of S2, z
    const Scalar z53 = n0_75 * c_theta_2;
    const Scalar z55 = n0_1425 + n0_6 * z53;
    const Scalar z64 = n0_1425 + n1_2 * z53;
    const Scalar z67 = n8_2 + z64;
    const Scalar z83 = n600 * q_theta_1;
    const Scalar z84 = n25 * v_theta_1;
    const Scalar z85 = n40 * q_theta_2;
    const Scalar z86 = n0_6 * v_theta_2;
    const Scalar z87 = n9_81 * s_theta_1;
    const Scalar z88 = n9_81 * c_theta_1;
    const Scalar z89 = v_theta_1 * v_theta_1;
    const Scalar z90 = z88 - n0_6 * z89;
    const Scalar z93 = z18 * z18;
    const Scalar z94 = n0_75 * z93;  // force on S2, y
    const Scalar z106 = n0_6 * a_theta_1 - z87;
    const Scalar z107 = s_theta_2 * z90 - c_theta_2 * z106;
    const Scalar z108 = s_theta_2 * z106 + c_theta_2 * z90;
    const Scalar z109 = a_theta_1 + a_theta_2;  // angular acceleration of S2, z
    const Scalar z110 = n0_75 * z109;  // force on S2, x
    const Scalar z111 = n0_75 * z107 - n0_1425 * z109;  // moment on S2, z
    const Scalar z112 = s_theta_2 * z94 - c_theta_2 * z110;
    const Scalar z113 = s_theta_2 * z110 + c_theta_2 * z94;
    const Scalar z116 = n8_2 * a_theta_1 - n17 * z87 - z111 - n0_6 * z112;  // moment on S1, z
    const Scalar z121 = z83 + z84 + z116;
    const Scalar z122 = z85 + z86 - z111;
    const Scalar z183 = n400_over_57 * z55;
    const Scalar z184 = z55 * z183 - z67;
    const Scalar z185 = n1 / z184;
    const Scalar z215 = n2 * v_theta_1;
    const Scalar z216 = n0_6 * z215;
    const Scalar z217 = s_theta_2 * z216;
    const Scalar z218 = n0_75 * z217;
    const Scalar z219 = n2 * z18;
    const Scalar z220 = n0_75 * z219;
    const Scalar z221 = s_theta_2 * z220;
    const Scalar z222 = z218 - n0_6 * z221;
    const Scalar z223 = n25 + z222;
    const Scalar z224 = s_theta_2 * z87 - c_theta_2 * z88;
    const Scalar z225 = n0_75 * z224;
    const Scalar z226 = n17 * z88 - z225;
    const Scalar z227 = n600 - z226;
    const Scalar z228 = n0_6 * z221;
    const Scalar z229 = n0_75 * z108;
    const Scalar z230 = n0_6 * z113 + z229;
    const Scalar z231 = n40 - z229;
    const Scalar z232 = z183 * z225 - z227;
    const Scalar z233 = z185 * z232;
    const Scalar z234 = z183 * z233 - n400_over_57 * z225;
    const Scalar z235 = z183 * z218 - z223;
    const Scalar z236 = z185 * z235;
    const Scalar z237 = z183 * z236 - n400_over_57 * z218;
    const Scalar z238 = z183 * z231 + z230;
    const Scalar z239 = z185 * z238;
    const Scalar z240 = z183 * z239 - n400_over_57 * z231;
    const Scalar z241 = n0_6 * z183 + z228;
    const Scalar z242 = z185 * z241;
    const Scalar z243 = n80_over_19 - z183 * z242;
    result.M[0] = z67;
    result.M[1] = z55;
    result.M[2] = z55;
    result.M[3] = n0_1425;
    result.C[0] = z223;
    result.C[1] = z218;
    result.C[2] = -z228;
    result.C[3] = n0_6;
    result.K[0] = z227;
    result.K[1] = z225;
    result.K[2] = -z230;
    result.K[3] = z231;
    result.F[0] = -z121;
    result.F[1] = -z122;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = -z233;
    result.A[3] = z234;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = -z239;
    result.A[7] = z240;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = -z236;
    result.A[11] = z237;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = -z242;
    result.A[15] = -z243;
    if (!(traits::regular(-z184, z67))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (result.M[0] - result.M[0]) + (result.M[1] - result.M[1]) + (result.M[2] - result.M[2])
        + (result.C[0] - result.C[0]) + (result.C[1] - result.C[1]) + (result.C[2] - result.C[2]) + (result.K[0]
        - result.K[0]) + (result.K[1] - result.K[1]) + (result.K[2] - result.K[2]) + (result.K[3] - result.K[3])
        + (result.F[0] - result.F[0]) + (result.F[1] - result.F[1]) + (result.A[2] - result.A[2]) + (result.A[3]
        - result.A[3]) + (result.A[6] - result.A[6]) + (result.A[7] - result.A[7]) + (result.A[10] - result.A[10])
        + (result.A[11] - result.A[11]) + (result.A[14] - result.A[14]) + (result.A[15] - result.A[15]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace passenger_in_vehicle
