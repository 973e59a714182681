// SPDX-License-Identifier: MIT
// arm7: Arm with seven revolute joints
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total):
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total
//   kinematics              398              700          0             0                  7       0   1112
//   mass_matrix             162              197          0             0                  6       0    371
//   bias                    271              307          0             0                  6       0    590
//   inverse_dynamics        291              316          0             0                  6       0    619
//   forward_dynamics        538              630          6             0                  6       0   1186
//   energy                  221              307          0             0                  6       0    540
//   linearisation          3355             4068          6             0                  6       0   7441
//
// Not computed because this mechanism does not need it:
//   kinematics: of 153 results 9 vanish identically, 21 repeat another up to sign
//   mass_matrix: of 49 results 21 repeat another up to sign
//   first_integrals: left out, 'tau1', 'tau2', 'tau3', 'tau4', 'tau5', 'tau6', 'tau7' have no force function
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 497 results 197 vanish identically, 22 repeat another up to sign
//
// To write this file again:
//   arm7_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --output arm7.hpp
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

namespace arm7 {

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;

  static constexpr const char* name = "arm7";
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 7;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    static constexpr int size = 0;
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar q1;  ///< coordinate [rad or 1]
    Scalar q2;  ///< coordinate [rad or 1]
    Scalar q3;  ///< coordinate [rad or 1]
    Scalar q4;  ///< coordinate [rad or 1]
    Scalar q5;  ///< coordinate [rad or 1]
    Scalar q6;  ///< coordinate [rad or 1]
    Scalar q7;  ///< coordinate [rad or 1]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::q1, &Coordinates::q2, &Coordinates::q3,
          &Coordinates::q4, &Coordinates::q5, &Coordinates::q6, &Coordinates::q7};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar q1;  ///< its rate [rad/s]
    Scalar q2;  ///< its rate [rad/s]
    Scalar q3;  ///< its rate [rad/s]
    Scalar q4;  ///< its rate [rad/s]
    Scalar q5;  ///< its rate [rad/s]
    Scalar q6;  ///< its rate [rad/s]
    Scalar q7;  ///< its rate [rad/s]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::q1, &Velocities::q2, &Velocities::q3, &Velocities::q4,
          &Velocities::q5, &Velocities::q6, &Velocities::q7};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar q1;  ///< its second rate [rad/s^2]
    Scalar q2;  ///< its second rate [rad/s^2]
    Scalar q3;  ///< its second rate [rad/s^2]
    Scalar q4;  ///< its second rate [rad/s^2]
    Scalar q5;  ///< its second rate [rad/s^2]
    Scalar q6;  ///< its second rate [rad/s^2]
    Scalar q7;  ///< its second rate [rad/s^2]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::q1, &Accelerations::q2, &Accelerations::q3,
          &Accelerations::q4, &Accelerations::q5, &Accelerations::q6, &Accelerations::q7};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar q1;  ///< works with the rate of q1 [N m]
    Scalar q2;  ///< works with the rate of q2 [N m]
    Scalar q3;  ///< works with the rate of q3 [N m]
    Scalar q4;  ///< works with the rate of q4 [N m]
    Scalar q5;  ///< works with the rate of q5 [N m]
    Scalar q6;  ///< works with the rate of q6 [N m]
    Scalar q7;  ///< works with the rate of q7 [N m]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::q1, &GeneralizedForces::q2,
          &GeneralizedForces::q3, &GeneralizedForces::q4, &GeneralizedForces::q5, &GeneralizedForces::q6,
          &GeneralizedForces::q7};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar tau1;  ///< motor [N m]
    Scalar tau2;  ///< motor [N m]
    Scalar tau3;  ///< motor [N m]
    Scalar tau4;  ///< motor [N m]
    Scalar tau5;  ///< motor [N m]
    Scalar tau6;  ///< motor [N m]
    Scalar tau7;  ///< motor [N m]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::tau1, &Inputs::tau2, &Inputs::tau3, &Inputs::tau4, &Inputs::tau5,
          &Inputs::tau6, &Inputs::tau7};
      return members_[i_];
    }
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
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n1_9 = traits::constant(1.9, 1.9f, "19/10");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    state.time = n0;
    state.q.q1 = n0_3;
    state.q.q2 = -n0_7;
    state.q.q3 = n0_4;
    state.q.q4 = -n1_9;
    state.q.q5 = n0_2;
    state.q.q6 = n1_6;
    state.q.q7 = -n0_5;
    state.v.q1 = n0;
    state.v.q2 = n0;
    state.v.q3 = n0;
    state.v.q4 = n0;
    state.v.q5 = n0;
    state.v.q6 = n0;
    state.v.q7 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> link1_position;  ///< centre of mass of link1 [m]
    std::array<Scalar, 9> link1_rotation;  ///< from the axes of link1 to the ground's (3 x 3)
    std::array<Scalar, 3> link1_velocity;  ///< velocity of the centre of mass of link1 [m/s]
    std::array<Scalar, 3> link1_angular_velocity;  ///< angular velocity of link1 [rad/s]
    std::array<Scalar, 3> link2_position;  ///< centre of mass of link2 [m]
    std::array<Scalar, 9> link2_rotation;  ///< from the axes of link2 to the ground's (3 x 3)
    std::array<Scalar, 3> link2_velocity;  ///< velocity of the centre of mass of link2 [m/s]
    std::array<Scalar, 3> link2_angular_velocity;  ///< angular velocity of link2 [rad/s]
    std::array<Scalar, 3> link3_position;  ///< centre of mass of link3 [m]
    std::array<Scalar, 9> link3_rotation;  ///< from the axes of link3 to the ground's (3 x 3)
    std::array<Scalar, 3> link3_velocity;  ///< velocity of the centre of mass of link3 [m/s]
    std::array<Scalar, 3> link3_angular_velocity;  ///< angular velocity of link3 [rad/s]
    std::array<Scalar, 3> link4_position;  ///< centre of mass of link4 [m]
    std::array<Scalar, 9> link4_rotation;  ///< from the axes of link4 to the ground's (3 x 3)
    std::array<Scalar, 3> link4_velocity;  ///< velocity of the centre of mass of link4 [m/s]
    std::array<Scalar, 3> link4_angular_velocity;  ///< angular velocity of link4 [rad/s]
    std::array<Scalar, 3> link5_position;  ///< centre of mass of link5 [m]
    std::array<Scalar, 9> link5_rotation;  ///< from the axes of link5 to the ground's (3 x 3)
    std::array<Scalar, 3> link5_velocity;  ///< velocity of the centre of mass of link5 [m/s]
    std::array<Scalar, 3> link5_angular_velocity;  ///< angular velocity of link5 [rad/s]
    std::array<Scalar, 3> link6_position;  ///< centre of mass of link6 [m]
    std::array<Scalar, 9> link6_rotation;  ///< from the axes of link6 to the ground's (3 x 3)
    std::array<Scalar, 3> link6_velocity;  ///< velocity of the centre of mass of link6 [m/s]
    std::array<Scalar, 3> link6_angular_velocity;  ///< angular velocity of link6 [rad/s]
    std::array<Scalar, 3> link7_position;  ///< centre of mass of link7 [m]
    std::array<Scalar, 9> link7_rotation;  ///< from the axes of link7 to the ground's (3 x 3)
    std::array<Scalar, 3> link7_velocity;  ///< velocity of the centre of mass of link7 [m/s]
    std::array<Scalar, 3> link7_angular_velocity;  ///< angular velocity of link7 [rad/s]
    std::array<Scalar, 3> tip_position;  ///< position of tip [m]
    std::array<Scalar, 3> tip_velocity;  ///< velocity of the material point at tip [m/s]
    std::array<Scalar, 21> tip_jacobian;  ///< partial velocities of tip (3 x 7)
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
    std::array<Scalar, 49> M;  ///< mass matrix (7 x 7)
    std::array<Scalar, 49> C;  ///< damping and gyroscopic terms (7 x 7)
    std::array<Scalar, 49> K;  ///< stiffness (7 x 7)
    std::array<Scalar, 7> F;  ///< right-hand side
    std::array<Scalar, 49> E;  ///< effect of the inputs (7 x 7)
    std::array<Scalar, 196> A;  ///< state matrix of x = (e, e'): x' = A x + B du (14 x 14)
    std::array<Scalar, 98> B;  ///< input matrix (14 x 7)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k4 = traits::constant(0.002081, 0.002081f, "2081/1000000");
    const Scalar k5 = traits::constant(0.003875, 0.003875f, "31/8000");
    const Scalar k6 = traits::constant(0.02872, 0.02872f, "359/12500");
    const Scalar k7 = traits::constant(0.003141, 0.003141f, "3141/1000000");
    const Scalar k8 = traits::constant(0.003495, 0.003495f, "699/200000");
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar k10 = traits::constant(0.039252, 0.039252f, "9813/250000");
    const Scalar k11 = traits::constant(0.027518, 0.027518f, "13759/500000");
    const Scalar k12 = traits::constant(0.249498, 0.249498f, "124749/500000");
    const Scalar k13 = traits::constant(0.066502, 0.066502f, "33251/500000");
    const Scalar k14 = traits::constant(0.104419, 0.104419f, "104419/1000000");
    const Scalar k15 = traits::constant(0.05317, 0.05317f, "5317/100000");
    const Scalar k16 = traits::constant(0.027454, 0.027454f, "13727/500000");
    const Scalar k17 = traits::constant(0.041065, 0.041065f, "8213/200000");
    const Scalar k18 = traits::constant(0.011953, 0.011953f, "11953/1000000");
    const Scalar k19 = traits::constant(0.345563, 0.345563f, "345563/1000000");
    const Scalar k20 = traits::constant(0.038437, 0.038437f, "38437/1000000");
    const Scalar k21 = traits::constant(0.014117, 0.014117f, "14117/1000000");
    const Scalar k22 = traits::constant(0.060149, 0.060149f, "60149/1000000");
    const Scalar k23 = traits::constant(0.010517, 0.010517f, "10517/1000000");
    const Scalar k24 = traits::constant(0.004252, 0.004252f, "1063/250000");
    const Scalar k25 = traits::constant(0.061597, 0.061597f, "61597/1000000");
    const Scalar n0_107 = traits::constant(0.107, 0.107f, "107/1000");
    const Scalar n0_158 = traits::constant(0.158, 0.158f, "79/500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_q1 = state.q.q1;
    const Scalar v_q1 = state.v.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    Scalar s_q1, c_q1;
    traits::sincos(q_q1, s_q1, c_q1);
    Scalar s_q2, c_q2;
    traits::sincos(q_q2, s_q2, c_q2);
    Scalar s_q3, c_q3;
    traits::sincos(q_q3, s_q3, c_q3);
    Scalar s_q4, c_q4;
    traits::sincos(q_q4, s_q4, c_q4);
    Scalar s_q5, c_q5;
    traits::sincos(q_q5, s_q5, c_q5);
    Scalar s_q6, c_q6;
    traits::sincos(q_q6, s_q6, c_q6);
    Scalar s_q7, c_q7;
    traits::sincos(q_q7, s_q7, c_q7);
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z37 = n0_316 * v_q2;
    const Scalar z38 = n0_316 * z35;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z41 = s_q3 * z38 + c_q3 * z37;
    const Scalar z42 = s_q3 * z37 - c_q3 * z38;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z44 = z42 - n0_0825 * z43;
    const Scalar z45 = n0_0825 * z40;
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z48 = s_q4 * z45 - c_q4 * z41;
    const Scalar z49 = s_q4 * z41 + c_q4 * z45;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z51 = z48 + n0_384 * z50;
    const Scalar z52 = z49 + n0_0825 * z50;
    const Scalar z53 = z44 + n0_384 * z46 - n0_0825 * z47;
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z56 = s_q5 * z53 + c_q5 * z51;
    const Scalar z57 = s_q5 * z51 - c_q5 * z53;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z61 = s_q6 * z52 + c_q6 * z56;
    const Scalar z62 = s_q6 * z56 - c_q6 * z52;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z64 = z62 + n0_088 * z63;
    const Scalar z65 = z57 + n0_088 * z60;
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z68 = s_q7 * z65 + c_q7 * z61;
    const Scalar z69 = s_q7 * z61 - c_q7 * z65;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z71 = k4 * s_q1 - k5 * c_q1;
    const Scalar z72 = k5 * s_q1 + k4 * c_q1;
    const Scalar z73 = k4 * v_q1;
    const Scalar z74 = k5 * v_q1;
    const Scalar z75 = s_q1 * z74 + c_q1 * z73;
    const Scalar z76 = s_q1 * z73 - c_q1 * z74;
    const Scalar z77 = k6 * s_q2 - k7 * c_q2;
    const Scalar z78 = k7 * s_q2 + k6 * c_q2;
    const Scalar z79 = k8 * s_q1 - c_q1 * z77;
    const Scalar z80 = s_q1 * z77 + k8 * c_q1;
    const Scalar z81 = n0_333 + z78;
    const Scalar z82 = c_q1 * c_q2;
    const Scalar z83 = s_q1 * c_q2;
    const Scalar z84 = c_q1 * s_q2;
    const Scalar z85 = s_q1 * s_q2;
    const Scalar z86 = k6 * v_q2 - k8 * z36;
    const Scalar z87 = k7 * v_q2 - k8 * z35;
    const Scalar z88 = k6 * z35 - k7 * z36;
    const Scalar z89 = s_q2 * z87 + c_q2 * z86;
    const Scalar z90 = s_q2 * z86 - c_q2 * z87;
    const Scalar z91 = s_q1 * z88 - c_q1 * z89;
    const Scalar z92 = s_q1 * z89 + c_q1 * z88;
    const Scalar z93 = s_q2 * z36 - c_q2 * z35;
    const Scalar z94 = s_q2 * z35 + c_q2 * z36;
    const Scalar z95 = s_q1 * v_q2 - c_q1 * z93;
    const Scalar z96 = s_q1 * z93 + c_q1 * v_q2;
    const Scalar z97 = k10 * s_q3 - k11 * c_q3;
    const Scalar z98 = k11 * s_q3 + k10 * c_q3;
    const Scalar z99 = k12 * s_q2 - c_q2 * z97;
    const Scalar z100 = s_q2 * z97 + k12 * c_q2;
    const Scalar z101 = s_q1 * z98 - c_q1 * z99;
    const Scalar z102 = s_q1 * z99 + c_q1 * z98;
    const Scalar z103 = n0_333 + z100;
    const Scalar z104 = c_q2 * c_q3;
    const Scalar z105 = s_q2 * c_q3;
    const Scalar z106 = s_q1 * s_q3 - c_q1 * z104;
    const Scalar z107 = s_q1 * z104 + c_q1 * s_q3;
    const Scalar z108 = c_q2 * s_q3;
    const Scalar z109 = s_q2 * s_q3;
    const Scalar z110 = s_q1 * c_q3 + c_q1 * z108;
    const Scalar z111 = s_q1 * z108 - c_q1 * c_q3;
    const Scalar z112 = k13 * z40 - z41 + k10 * z43;
    const Scalar z113 = k13 * z39 - z42 + k11 * z43;
    const Scalar z114 = k10 * z39 - k11 * z40;
    const Scalar z115 = s_q3 * z113 + c_q3 * z112;
    const Scalar z116 = s_q3 * z112 - c_q3 * z113;
    const Scalar z117 = s_q2 * z114 - c_q2 * z115;
    const Scalar z118 = s_q2 * z115 + c_q2 * z114;
    const Scalar z119 = s_q1 * z116 + c_q1 * z117;
    const Scalar z120 = s_q1 * z117 - c_q1 * z116;
    const Scalar z121 = s_q3 * z40 - c_q3 * z39;
    const Scalar z122 = s_q3 * z39 + c_q3 * z40;
    const Scalar z123 = s_q2 * z43 - c_q2 * z121;
    const Scalar z124 = s_q2 * z121 + c_q2 * z43;
    const Scalar z125 = s_q1 * z122 - c_q1 * z123;
    const Scalar z126 = s_q1 * z123 + c_q1 * z122;
    const Scalar z127 = k14 * s_q4 + k15 * c_q4;
    const Scalar z128 = k15 * s_q4 - k14 * c_q4;
    const Scalar z129 = n0_0825 - z127;
    const Scalar z130 = k16 * s_q3 + c_q3 * z129;
    const Scalar z131 = s_q3 * z129 - k16 * c_q3;
    const Scalar z132 = n0_316 - z128;
    const Scalar z133 = s_q2 * z132 + c_q2 * z130;
    const Scalar z134 = s_q2 * z130 - c_q2 * z132;
    const Scalar z135 = s_q1 * z131 - c_q1 * z133;
    const Scalar z136 = s_q1 * z133 + c_q1 * z131;
    const Scalar z137 = n0_333 - z134;
    const Scalar z138 = c_q3 * c_q4;
    const Scalar z139 = s_q3 * c_q4;
    const Scalar z140 = s_q2 * s_q4 + c_q2 * z138;
    const Scalar z141 = s_q2 * z138 - c_q2 * s_q4;
    const Scalar z142 = s_q1 * z139 - c_q1 * z140;
    const Scalar z143 = s_q1 * z140 + c_q1 * z139;
    const Scalar z144 = c_q3 * s_q4;
    const Scalar z145 = s_q3 * s_q4;
    const Scalar z146 = s_q2 * c_q4 - c_q2 * z144;
    const Scalar z147 = s_q2 * z144 + c_q2 * c_q4;
    const Scalar z148 = s_q1 * z145 + c_q1 * z146;
    const Scalar z149 = s_q1 * z146 - c_q1 * z145;
    const Scalar z150 = k16 * z47 + z48 + k14 * z50;
    const Scalar z151 = k16 * z46 + z49 + k15 * z50;
    const Scalar z152 = z44 + k14 * z46 - k15 * z47;
    const Scalar z153 = s_q4 * z151 - c_q4 * z150;
    const Scalar z154 = s_q4 * z150 + c_q4 * z151;
    const Scalar z155 = s_q3 * z152 + c_q3 * z153;
    const Scalar z156 = s_q3 * z153 - c_q3 * z152;
    const Scalar z157 = s_q2 * z154 - c_q2 * z155;
    const Scalar z158 = s_q2 * z155 + c_q2 * z154;
    const Scalar z159 = s_q1 * z156 + c_q1 * z157;
    const Scalar z160 = s_q1 * z157 - c_q1 * z156;
    const Scalar z161 = s_q4 * z47 + c_q4 * z46;
    const Scalar z162 = s_q4 * z46 - c_q4 * z47;
    const Scalar z163 = s_q3 * z50 + c_q3 * z161;
    const Scalar z164 = s_q3 * z161 - c_q3 * z50;
    const Scalar z165 = s_q2 * z162 + c_q2 * z163;
    const Scalar z166 = s_q2 * z163 - c_q2 * z162;
    const Scalar z167 = s_q1 * z164 - c_q1 * z165;
    const Scalar z168 = s_q1 * z165 + c_q1 * z164;
    const Scalar z169 = k17 * s_q5 + k18 * c_q5;
    const Scalar z170 = k18 * s_q5 - k17 * c_q5;
    const Scalar z171 = n0_0825 + z169;
    const Scalar z172 = k19 * s_q4 + c_q4 * z171;
    const Scalar z173 = s_q4 * z171 - k19 * c_q4;
    const Scalar z174 = n0_0825 - z172;
    const Scalar z175 = s_q3 * z170 + c_q3 * z174;
    const Scalar z176 = s_q3 * z174 - c_q3 * z170;
    const Scalar z177 = n0_316 - z173;
    const Scalar z178 = s_q2 * z177 + c_q2 * z175;
    const Scalar z179 = s_q2 * z175 - c_q2 * z177;
    const Scalar z180 = s_q1 * z176 - c_q1 * z178;
    const Scalar z181 = s_q1 * z178 + c_q1 * z176;
    const Scalar z182 = n0_333 - z179;
    const Scalar z183 = c_q4 * c_q5;
    const Scalar z184 = s_q4 * c_q5;
    const Scalar z185 = s_q3 * s_q5 - c_q3 * z183;
    const Scalar z186 = s_q3 * z183 + c_q3 * s_q5;
    const Scalar z187 = s_q2 * z184 - c_q2 * z185;
    const Scalar z188 = s_q2 * z185 + c_q2 * z184;
    const Scalar z189 = s_q1 * z186 - c_q1 * z187;
    const Scalar z190 = s_q1 * z187 + c_q1 * z186;
    const Scalar z191 = c_q4 * s_q5;
    const Scalar z192 = s_q4 * s_q5;
    const Scalar z193 = s_q3 * c_q5 + c_q3 * z191;
    const Scalar z194 = s_q3 * z191 - c_q3 * c_q5;
    const Scalar z195 = s_q2 * z192 + c_q2 * z193;
    const Scalar z196 = s_q2 * z193 - c_q2 * z192;
    const Scalar z197 = s_q1 * z194 - c_q1 * z195;
    const Scalar z198 = s_q1 * z195 + c_q1 * z194;
    const Scalar z199 = k20 * z55 - z56 - k17 * z58;
    const Scalar z200 = k20 * z54 - z57 + k18 * z58;
    const Scalar z201 = z52 + k17 * z54 + k18 * z55;
    const Scalar z202 = s_q5 * z200 + c_q5 * z199;
    const Scalar z203 = s_q5 * z199 - c_q5 * z200;
    const Scalar z204 = s_q4 * z201 + c_q4 * z202;
    const Scalar z205 = s_q4 * z202 - c_q4 * z201;
    const Scalar z206 = s_q3 * z203 - c_q3 * z204;
    const Scalar z207 = s_q3 * z204 + c_q3 * z203;
    const Scalar z208 = s_q2 * z205 - c_q2 * z206;
    const Scalar z209 = s_q2 * z206 + c_q2 * z205;
    const Scalar z210 = s_q1 * z207 - c_q1 * z208;
    const Scalar z211 = s_q1 * z208 + c_q1 * z207;
    const Scalar z212 = s_q5 * z55 - c_q5 * z54;
    const Scalar z213 = s_q5 * z54 + c_q5 * z55;
    const Scalar z214 = s_q4 * z58 - c_q4 * z212;
    const Scalar z215 = s_q4 * z212 + c_q4 * z58;
    const Scalar z216 = s_q3 * z213 - c_q3 * z214;
    const Scalar z217 = s_q3 * z214 + c_q3 * z213;
    const Scalar z218 = s_q2 * z215 + c_q2 * z216;
    const Scalar z219 = s_q2 * z216 - c_q2 * z215;
    const Scalar z220 = s_q1 * z217 + c_q1 * z218;
    const Scalar z221 = s_q1 * z218 - c_q1 * z217;
    const Scalar z222 = k21 * s_q6 + k22 * c_q6;
    const Scalar z223 = k22 * s_q6 - k21 * c_q6;
    const Scalar z224 = k23 * s_q5 - c_q5 * z222;
    const Scalar z225 = s_q5 * z222 + k23 * c_q5;
    const Scalar z226 = n0_0825 + z224;
    const Scalar z227 = n0_384 + z223;
    const Scalar z228 = s_q4 * z227 + c_q4 * z226;
    const Scalar z229 = s_q4 * z226 - c_q4 * z227;
    const Scalar z230 = n0_0825 - z228;
    const Scalar z231 = s_q3 * z225 - c_q3 * z230;
    const Scalar z232 = s_q3 * z230 + c_q3 * z225;
    const Scalar z233 = n0_316 - z229;
    const Scalar z234 = s_q2 * z233 - c_q2 * z231;
    const Scalar z235 = s_q2 * z231 + c_q2 * z233;
    const Scalar z236 = s_q1 * z232 - c_q1 * z234;
    const Scalar z237 = s_q1 * z234 + c_q1 * z232;
    const Scalar z238 = n0_333 + z235;
    const Scalar z239 = c_q5 * c_q6;
    const Scalar z240 = s_q5 * c_q6;
    const Scalar z241 = s_q4 * s_q6 - c_q4 * z239;
    const Scalar z242 = s_q4 * z239 + c_q4 * s_q6;
    const Scalar z243 = s_q3 * z240 + c_q3 * z241;
    const Scalar z244 = s_q3 * z241 - c_q3 * z240;
    const Scalar z245 = s_q2 * z242 - c_q2 * z243;
    const Scalar z246 = s_q2 * z243 + c_q2 * z242;
    const Scalar z247 = s_q1 * z244 + c_q1 * z245;
    const Scalar z248 = s_q1 * z245 - c_q1 * z244;
    const Scalar z249 = c_q5 * s_q6;
    const Scalar z250 = s_q5 * s_q6;
    const Scalar z251 = s_q4 * c_q6 + c_q4 * z249;
    const Scalar z252 = s_q4 * z249 - c_q4 * c_q6;
    const Scalar z253 = s_q3 * z250 - c_q3 * z251;
    const Scalar z254 = s_q3 * z251 + c_q3 * z250;
    const Scalar z255 = s_q2 * z252 - c_q2 * z253;
    const Scalar z256 = s_q2 * z253 + c_q2 * z252;
    const Scalar z257 = s_q1 * z254 - c_q1 * z255;
    const Scalar z258 = s_q1 * z255 + c_q1 * z254;
    const Scalar z259 = k23 * z60 + z61 - k21 * z63;
    const Scalar z260 = k23 * z59 + z62 + k22 * z63;
    const Scalar z261 = z57 + k21 * z59 + k22 * z60;
    const Scalar z262 = s_q6 * z260 + c_q6 * z259;
    const Scalar z263 = s_q6 * z259 - c_q6 * z260;
    const Scalar z264 = s_q5 * z261 + c_q5 * z262;
    const Scalar z265 = s_q5 * z262 - c_q5 * z261;
    const Scalar z266 = s_q4 * z263 - c_q4 * z264;
    const Scalar z267 = s_q4 * z264 + c_q4 * z263;
    const Scalar z268 = s_q3 * z265 + c_q3 * z266;
    const Scalar z269 = s_q3 * z266 - c_q3 * z265;
    const Scalar z270 = s_q2 * z267 - c_q2 * z268;
    const Scalar z271 = s_q2 * z268 + c_q2 * z267;
    const Scalar z272 = s_q1 * z269 + c_q1 * z270;
    const Scalar z273 = s_q1 * z270 - c_q1 * z269;
    const Scalar z274 = s_q6 * z60 - c_q6 * z59;
    const Scalar z275 = s_q6 * z59 + c_q6 * z60;
    const Scalar z276 = s_q5 * z63 - c_q5 * z274;
    const Scalar z277 = s_q5 * z274 + c_q5 * z63;
    const Scalar z278 = s_q4 * z275 - c_q4 * z276;
    const Scalar z279 = s_q4 * z276 + c_q4 * z275;
    const Scalar z280 = s_q3 * z277 - c_q3 * z278;
    const Scalar z281 = s_q3 * z278 + c_q3 * z277;
    const Scalar z282 = s_q2 * z279 + c_q2 * z280;
    const Scalar z283 = s_q2 * z280 - c_q2 * z279;
    const Scalar z284 = s_q1 * z281 + c_q1 * z282;
    const Scalar z285 = s_q1 * z282 - c_q1 * z281;
    const Scalar z286 = k24 * s_q7 + k23 * c_q7;
    const Scalar z287 = k23 * s_q7 - k24 * c_q7;
    const Scalar z288 = n0_088 + z286;
    const Scalar z289 = k25 * s_q6 + c_q6 * z288;
    const Scalar z290 = s_q6 * z288 - k25 * c_q6;
    const Scalar z291 = s_q5 * z287 + c_q5 * z289;
    const Scalar z292 = s_q5 * z289 - c_q5 * z287;
    const Scalar z293 = n0_0825 - z291;
    const Scalar z294 = n0_384 + z290;
    const Scalar z295 = s_q4 * z294 + c_q4 * z293;
    const Scalar z296 = s_q4 * z293 - c_q4 * z294;
    const Scalar z297 = n0_0825 - z295;
    const Scalar z298 = s_q3 * z292 - c_q3 * z297;
    const Scalar z299 = s_q3 * z297 + c_q3 * z292;
    const Scalar z300 = n0_316 - z296;
    const Scalar z301 = s_q2 * z300 - c_q2 * z298;
    const Scalar z302 = s_q2 * z298 + c_q2 * z300;
    const Scalar z303 = s_q1 * z299 - c_q1 * z301;
    const Scalar z304 = s_q1 * z301 + c_q1 * z299;
    const Scalar z305 = n0_333 + z302;
    const Scalar z306 = c_q6 * c_q7;
    const Scalar z307 = s_q6 * c_q7;
    const Scalar z308 = s_q5 * s_q7 + c_q5 * z306;
    const Scalar z309 = s_q5 * z306 - c_q5 * s_q7;
    const Scalar z310 = s_q4 * z307 - c_q4 * z308;
    const Scalar z311 = s_q4 * z308 + c_q4 * z307;
    const Scalar z312 = s_q3 * z309 + c_q3 * z310;
    const Scalar z313 = s_q3 * z310 - c_q3 * z309;
    const Scalar z314 = s_q2 * z311 - c_q2 * z312;
    const Scalar z315 = s_q2 * z312 + c_q2 * z311;
    const Scalar z316 = s_q1 * z313 + c_q1 * z314;
    const Scalar z317 = s_q1 * z314 - c_q1 * z313;
    const Scalar z318 = c_q6 * s_q7;
    const Scalar z319 = s_q6 * s_q7;
    const Scalar z320 = s_q5 * c_q7 - c_q5 * z318;
    const Scalar z321 = s_q5 * z318 + c_q5 * c_q7;
    const Scalar z322 = s_q4 * z319 + c_q4 * z320;
    const Scalar z323 = s_q4 * z320 - c_q4 * z319;
    const Scalar z324 = s_q3 * z321 + c_q3 * z322;
    const Scalar z325 = s_q3 * z322 - c_q3 * z321;
    const Scalar z326 = s_q2 * z323 + c_q2 * z324;
    const Scalar z327 = s_q2 * z324 - c_q2 * z323;
    const Scalar z328 = s_q1 * z325 - c_q1 * z326;
    const Scalar z329 = s_q1 * z326 + c_q1 * z325;
    const Scalar z330 = k25 * z67 + z68 - k24 * z70;
    const Scalar z331 = k25 * z66 - z69 - k23 * z70;
    const Scalar z332 = z64 + k24 * z66 - k23 * z67;
    const Scalar z333 = s_q7 * z331 - c_q7 * z330;
    const Scalar z334 = s_q7 * z330 + c_q7 * z331;
    const Scalar z335 = s_q6 * z332 - c_q6 * z333;
    const Scalar z336 = s_q6 * z333 + c_q6 * z332;
    const Scalar z337 = s_q5 * z334 + c_q5 * z335;
    const Scalar z338 = s_q5 * z335 - c_q5 * z334;
    const Scalar z339 = s_q4 * z336 + c_q4 * z337;
    const Scalar z340 = s_q4 * z337 - c_q4 * z336;
    const Scalar z341 = s_q3 * z338 - c_q3 * z339;
    const Scalar z342 = s_q3 * z339 + c_q3 * z338;
    const Scalar z343 = s_q2 * z340 - c_q2 * z341;
    const Scalar z344 = s_q2 * z341 + c_q2 * z340;
    const Scalar z345 = s_q1 * z342 - c_q1 * z343;
    const Scalar z346 = s_q1 * z343 + c_q1 * z342;
    const Scalar z347 = s_q7 * z67 + c_q7 * z66;
    const Scalar z348 = s_q7 * z66 - c_q7 * z67;
    const Scalar z349 = s_q6 * z70 + c_q6 * z347;
    const Scalar z350 = s_q6 * z347 - c_q6 * z70;
    const Scalar z351 = s_q5 * z348 + c_q5 * z349;
    const Scalar z352 = s_q5 * z349 - c_q5 * z348;
    const Scalar z353 = s_q4 * z350 - c_q4 * z351;
    const Scalar z354 = s_q4 * z351 + c_q4 * z350;
    const Scalar z355 = s_q3 * z352 + c_q3 * z353;
    const Scalar z356 = s_q3 * z353 - c_q3 * z352;
    const Scalar z357 = s_q2 * z354 - c_q2 * z355;
    const Scalar z358 = s_q2 * z355 + c_q2 * z354;
    const Scalar z359 = s_q1 * z356 + c_q1 * z357;
    const Scalar z360 = s_q1 * z357 - c_q1 * z356;
    const Scalar z361 = n0_107 * s_q6 + n0_088 * c_q6;
    const Scalar z362 = n0_088 * s_q6 - n0_107 * c_q6;
    const Scalar z363 = c_q5 * z361;
    const Scalar z364 = s_q5 * z361;
    const Scalar z365 = n0_0825 - z363;
    const Scalar z366 = n0_384 + z362;
    const Scalar z367 = s_q4 * z366 + c_q4 * z365;
    const Scalar z368 = s_q4 * z365 - c_q4 * z366;
    const Scalar z369 = n0_0825 - z367;
    const Scalar z370 = s_q3 * z364 - c_q3 * z369;
    const Scalar z371 = s_q3 * z369 + c_q3 * z364;
    const Scalar z372 = n0_316 - z368;
    const Scalar z373 = s_q2 * z372 - c_q2 * z370;
    const Scalar z374 = s_q2 * z370 + c_q2 * z372;
    const Scalar z375 = s_q1 * z371 - c_q1 * z373;
    const Scalar z376 = s_q1 * z373 + c_q1 * z371;
    const Scalar z377 = n0_333 + z374;
    const Scalar z378 = n0_107 * z67 + z68;
    const Scalar z379 = n0_107 * z66 - z69;
    const Scalar z380 = s_q7 * z379 - c_q7 * z378;
    const Scalar z381 = s_q7 * z378 + c_q7 * z379;
    const Scalar z382 = s_q6 * z64 - c_q6 * z380;
    const Scalar z383 = s_q6 * z380 + c_q6 * z64;
    const Scalar z384 = s_q5 * z381 + c_q5 * z382;
    const Scalar z385 = s_q5 * z382 - c_q5 * z381;
    const Scalar z386 = s_q4 * z383 + c_q4 * z384;
    const Scalar z387 = s_q4 * z384 - c_q4 * z383;
    const Scalar z388 = s_q3 * z385 - c_q3 * z386;
    const Scalar z389 = s_q3 * z386 + c_q3 * z385;
    const Scalar z390 = s_q2 * z387 - c_q2 * z388;
    const Scalar z391 = s_q2 * z388 + c_q2 * z387;
    const Scalar z392 = s_q1 * z389 - c_q1 * z390;
    const Scalar z393 = s_q1 * z390 + c_q1 * z389;
    const Scalar z394 = n0_333 - z377;
    const Scalar z395 = c_q1 * z394;
    const Scalar z396 = s_q1 * z394;
    const Scalar z397 = s_q1 * z376 - c_q1 * z375;
    const Scalar z398 = n0_316 * s_q2;
    const Scalar z399 = n0_316 * c_q2;
    const Scalar z400 = c_q1 * z398;
    const Scalar z401 = s_q1 * z398;
    const Scalar z402 = n0_333 + z399;
    const Scalar z403 = z375 + z400;
    const Scalar z404 = z376 - z401;
    const Scalar z405 = z377 - z402;
    const Scalar z406 = c_q2 * z404 - z85 * z405;
    const Scalar z407 = c_q2 * z403 + z84 * z405;
    const Scalar z408 = z84 * z404 + z85 * z403;
    const Scalar z409 = n0_0825 * c_q3;
    const Scalar z410 = n0_0825 * s_q3;
    const Scalar z411 = n0_316 * s_q2 + c_q2 * z409;
    const Scalar z412 = s_q2 * z409 - n0_316 * c_q2;
    const Scalar z413 = s_q1 * z410 - c_q1 * z411;
    const Scalar z414 = s_q1 * z411 + c_q1 * z410;
    const Scalar z415 = n0_333 - z412;
    const Scalar z416 = z375 - z413;
    const Scalar z417 = z376 - z414;
    const Scalar z418 = z377 - z415;
    const Scalar z419 = z109 * z417 + z111 * z418;
    const Scalar z420 = z109 * z416 - z110 * z418;
    const Scalar z421 = z110 * z417 + z111 * z416;
    const Scalar z422 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z423 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z424 = n0_0825 - z422;
    const Scalar z425 = c_q3 * z424;
    const Scalar z426 = s_q3 * z424;
    const Scalar z427 = n0_316 - z423;
    const Scalar z428 = s_q2 * z427 + c_q2 * z425;
    const Scalar z429 = s_q2 * z425 - c_q2 * z427;
    const Scalar z430 = s_q1 * z426 - c_q1 * z428;
    const Scalar z431 = s_q1 * z428 + c_q1 * z426;
    const Scalar z432 = n0_333 - z429;
    const Scalar z433 = z375 - z430;
    const Scalar z434 = z376 - z431;
    const Scalar z435 = z377 - z432;
    const Scalar z436 = z147 * z434 - z149 * z435;
    const Scalar z437 = z147 * z433 + z148 * z435;
    const Scalar z438 = z148 * z434 + z149 * z433;
    const Scalar z439 = z196 * z434 + z198 * z435;
    const Scalar z440 = z196 * z433 + z197 * z435;
    const Scalar z441 = z197 * z434 - z198 * z433;
    const Scalar z442 = n0_088 * c_q6;
    const Scalar z443 = n0_088 * s_q6;
    const Scalar z444 = c_q5 * z442;
    const Scalar z445 = s_q5 * z442;
    const Scalar z446 = n0_0825 - z444;
    const Scalar z447 = n0_384 + z443;
    const Scalar z448 = s_q4 * z447 + c_q4 * z446;
    const Scalar z449 = s_q4 * z446 - c_q4 * z447;
    const Scalar z450 = n0_0825 - z448;
    const Scalar z451 = s_q3 * z445 - c_q3 * z450;
    const Scalar z452 = s_q3 * z450 + c_q3 * z445;
    const Scalar z453 = n0_316 - z449;
    const Scalar z454 = s_q2 * z453 - c_q2 * z451;
    const Scalar z455 = s_q2 * z451 + c_q2 * z453;
    const Scalar z456 = s_q1 * z452 - c_q1 * z454;
    const Scalar z457 = s_q1 * z454 + c_q1 * z452;
    const Scalar z458 = n0_333 + z455;
    const Scalar z459 = z375 - z456;
    const Scalar z460 = z376 - z457;
    const Scalar z461 = z377 - z458;
    const Scalar z462 = z256 * z460 - z258 * z461;
    const Scalar z463 = z256 * z459 - z257 * z461;
    const Scalar z464 = z257 * z460 - z258 * z459;
    result.link1_position[0] = -z71;
    result.link1_position[1] = z72;
    result.link1_position[2] = n0_158;
    result.link1_rotation[0] = c_q1;
    result.link1_rotation[1] = s_q1;
    result.link1_rotation[2] = n0;
    result.link1_rotation[3] = -s_q1;
    result.link1_rotation[4] = c_q1;
    result.link1_rotation[5] = n0;
    result.link1_rotation[6] = n0;
    result.link1_rotation[7] = n0;
    result.link1_rotation[8] = n1;
    result.link1_velocity[0] = -z75;
    result.link1_velocity[1] = -z76;
    result.link1_velocity[2] = n0;
    result.link1_angular_velocity[0] = n0;
    result.link1_angular_velocity[1] = n0;
    result.link1_angular_velocity[2] = v_q1;
    result.link2_position[0] = -z79;
    result.link2_position[1] = z80;
    result.link2_position[2] = z81;
    result.link2_rotation[0] = z82;
    result.link2_rotation[1] = z83;
    result.link2_rotation[2] = -s_q2;
    result.link2_rotation[3] = -z84;
    result.link2_rotation[4] = -z85;
    result.link2_rotation[5] = -c_q2;
    result.link2_rotation[6] = -s_q1;
    result.link2_rotation[7] = c_q1;
    result.link2_rotation[8] = n0;
    result.link2_velocity[0] = -z91;
    result.link2_velocity[1] = z92;
    result.link2_velocity[2] = -z90;
    result.link2_angular_velocity[0] = -z95;
    result.link2_angular_velocity[1] = z96;
    result.link2_angular_velocity[2] = z94;
    result.link3_position[0] = -z101;
    result.link3_position[1] = z102;
    result.link3_position[2] = z103;
    result.link3_rotation[0] = -z106;
    result.link3_rotation[1] = z107;
    result.link3_rotation[2] = -z105;
    result.link3_rotation[3] = -z110;
    result.link3_rotation[4] = -z111;
    result.link3_rotation[5] = z109;
    result.link3_rotation[6] = z84;
    result.link3_rotation[7] = z85;
    result.link3_rotation[8] = c_q2;
    result.link3_velocity[0] = z119;
    result.link3_velocity[1] = z120;
    result.link3_velocity[2] = z118;
    result.link3_angular_velocity[0] = -z125;
    result.link3_angular_velocity[1] = z126;
    result.link3_angular_velocity[2] = z124;
    result.link4_position[0] = -z135;
    result.link4_position[1] = z136;
    result.link4_position[2] = z137;
    result.link4_rotation[0] = -z142;
    result.link4_rotation[1] = z143;
    result.link4_rotation[2] = -z141;
    result.link4_rotation[3] = z148;
    result.link4_rotation[4] = z149;
    result.link4_rotation[5] = z147;
    result.link4_rotation[6] = z110;
    result.link4_rotation[7] = z111;
    result.link4_rotation[8] = -z109;
    result.link4_velocity[0] = -z159;
    result.link4_velocity[1] = -z160;
    result.link4_velocity[2] = -z158;
    result.link4_angular_velocity[0] = -z167;
    result.link4_angular_velocity[1] = z168;
    result.link4_angular_velocity[2] = -z166;
    result.link5_position[0] = -z180;
    result.link5_position[1] = z181;
    result.link5_position[2] = z182;
    result.link5_rotation[0] = -z189;
    result.link5_rotation[1] = z190;
    result.link5_rotation[2] = z188;
    result.link5_rotation[3] = z197;
    result.link5_rotation[4] = -z198;
    result.link5_rotation[5] = z196;
    result.link5_rotation[6] = z148;
    result.link5_rotation[7] = z149;
    result.link5_rotation[8] = z147;
    result.link5_velocity[0] = -z210;
    result.link5_velocity[1] = z211;
    result.link5_velocity[2] = z209;
    result.link5_angular_velocity[0] = z220;
    result.link5_angular_velocity[1] = z221;
    result.link5_angular_velocity[2] = -z219;
    result.link6_position[0] = -z236;
    result.link6_position[1] = z237;
    result.link6_position[2] = z238;
    result.link6_rotation[0] = z247;
    result.link6_rotation[1] = z248;
    result.link6_rotation[2] = z246;
    result.link6_rotation[3] = z257;
    result.link6_rotation[4] = -z258;
    result.link6_rotation[5] = -z256;
    result.link6_rotation[6] = -z197;
    result.link6_rotation[7] = z198;
    result.link6_rotation[8] = -z196;
    result.link6_velocity[0] = -z272;
    result.link6_velocity[1] = -z273;
    result.link6_velocity[2] = -z271;
    result.link6_angular_velocity[0] = z284;
    result.link6_angular_velocity[1] = z285;
    result.link6_angular_velocity[2] = -z283;
    result.link7_position[0] = -z303;
    result.link7_position[1] = z304;
    result.link7_position[2] = z305;
    result.link7_rotation[0] = z316;
    result.link7_rotation[1] = z317;
    result.link7_rotation[2] = z315;
    result.link7_rotation[3] = -z328;
    result.link7_rotation[4] = z329;
    result.link7_rotation[5] = -z327;
    result.link7_rotation[6] = -z257;
    result.link7_rotation[7] = z258;
    result.link7_rotation[8] = z256;
    result.link7_velocity[0] = z345;
    result.link7_velocity[1] = -z346;
    result.link7_velocity[2] = -z344;
    result.link7_angular_velocity[0] = z359;
    result.link7_angular_velocity[1] = z360;
    result.link7_angular_velocity[2] = z358;
    result.tip_position[0] = -z375;
    result.tip_position[1] = z376;
    result.tip_position[2] = z377;
    result.tip_velocity[0] = z392;
    result.tip_velocity[1] = -z393;
    result.tip_velocity[2] = -z391;
    result.tip_jacobian[0] = -z376;
    result.tip_jacobian[3] = -z395;
    result.tip_jacobian[6] = -z406;
    result.tip_jacobian[9] = z419;
    result.tip_jacobian[12] = -z436;
    result.tip_jacobian[15] = z439;
    result.tip_jacobian[18] = -z462;
    result.tip_jacobian[1] = -z375;
    result.tip_jacobian[4] = -z396;
    result.tip_jacobian[7] = -z407;
    result.tip_jacobian[10] = z420;
    result.tip_jacobian[13] = -z437;
    result.tip_jacobian[16] = z440;
    result.tip_jacobian[19] = -z463;
    result.tip_jacobian[2] = n0;
    result.tip_jacobian[5] = -z397;
    result.tip_jacobian[8] = z408;
    result.tip_jacobian[11] = z421;
    result.tip_jacobian[14] = z438;
    result.tip_jacobian[17] = -z441;
    result.tip_jacobian[20] = -z464;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 49>& mass) noexcept {
    const Scalar k0 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k1 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar k9 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k10 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n0_176 = traits::constant(0.176, 0.176f, "22/125");
    const Scalar k13 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k14 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k15 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k18 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k19 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k21 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k22 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k23 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k24 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k27 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n0_768 = traits::constant(0.768, 0.768f, "96/125");
    const Scalar n0_165 = traits::constant(0.165, 0.165f, "33/200");
    const Scalar k30 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k31 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k36 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k37 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k38 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k41 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar n0_632 = traits::constant(0.632, 0.632f, "79/125");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k49 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k50 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar q_q2 = state.q.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar q_q7 = state.q.q7;
    Scalar s_q2, c_q2;
    traits::sincos(q_q2, s_q2, c_q2);
    Scalar s_q3, c_q3;
    traits::sincos(q_q3, s_q3, c_q3);
    Scalar s_q4, c_q4;
    traits::sincos(q_q4, s_q4, c_q4);
    Scalar s_q5, c_q5;
    traits::sincos(q_q5, s_q5, c_q5);
    Scalar s_q6, c_q6;
    traits::sincos(q_q6, s_q6, c_q6);
    Scalar s_q7, c_q7;
    traits::sincos(q_q7, s_q7, c_q7);
    const Scalar z465 = k0 * s_q7 - k1 * c_q7;
    const Scalar z466 = k1 * s_q7 + k0 * c_q7;
    const Scalar z467 = k2 * s_q7 - k3 * c_q7;
    const Scalar z468 = k3 * s_q7 + k2 * c_q7;
    const Scalar z469 = c_q6 * z465;
    const Scalar z470 = s_q6 * z465;
    const Scalar z471 = k4 + n0_088 * z466;
    const Scalar z472 = s_q6 * z471 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z471;
    const Scalar z474 = s_q5 * z466 - c_q5 * z469;
    const Scalar z475 = s_q5 * z469 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n0_0825 * z470 - n0_384 * z474 - z477;
    const Scalar z479 = s_q4 * z470 + c_q4 * z474;
    const Scalar z480 = s_q4 * z474 - c_q4 * z470;
    const Scalar z481 = n0_384 * z475 - z476;
    const Scalar z482 = z473 + n0_0825 * z475;
    const Scalar z483 = s_q4 * z482 - c_q4 * z481;
    const Scalar z484 = s_q4 * z481 + c_q4 * z482;
    const Scalar z485 = n0_0825 * z475 - z484;
    const Scalar z486 = s_q3 * z475 + c_q3 * z479;
    const Scalar z487 = s_q3 * z479 - c_q3 * z475;
    const Scalar z488 = z478 + n0_0825 * z480;
    const Scalar z489 = s_q3 * z488 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z488;
    const Scalar z491 = n0_316 * z486 - z490;
    const Scalar z494 = n0_316 * z487 - z489;
    const Scalar z496 = s_q2 * z494 - c_q2 * z485;
    const Scalar z497 = k9 * s_q7 - k10 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k9 - z498;
    const Scalar z500 = k11 + c_q7 * z497;
    const Scalar z501 = n0_088 * z465 - z500;
    const Scalar z502 = k4 + n0_176 * z466;
    const Scalar z503 = n0_176 * z466 + z498;
    const Scalar z504 = k13 + z466;
    const Scalar z505 = k14 - z499;
    const Scalar z506 = k15 - z467;
    const Scalar z507 = k16 + z501;
    const Scalar z508 = k17 + z468;
    const Scalar z509 = k18 + z503;
    const Scalar z510 = s_q6 * z504 - k19 * c_q6;
    const Scalar z511 = k19 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n0_0825 * z511 - n0_384 * z514 - z517;
    const Scalar z519 = s_q4 * z511 + c_q4 * z514;
    const Scalar z520 = s_q4 * z514 - c_q4 * z511;
    const Scalar z521 = n0_384 * z515 + z516;
    const Scalar z522 = z513 - n0_0825 * z515;
    const Scalar z523 = s_q4 * z522 + c_q4 * z521;
    const Scalar z524 = s_q4 * z521 - c_q4 * z522;
    const Scalar z525 = n0_0825 * z515 - z524;
    const Scalar z526 = s_q3 * z515 - c_q3 * z519;
    const Scalar z527 = s_q3 * z519 + c_q3 * z515;
    const Scalar z528 = z518 + n0_0825 * z520;
    const Scalar z529 = s_q3 * z528 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z528;
    const Scalar z531 = n0_316 * z526 + z530;
    const Scalar z534 = n0_316 * z527 - z529;
    const Scalar z536 = s_q2 * z534 + c_q2 * z525;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k21 - z511;
    const Scalar z545 = k22 - z465;
    const Scalar z546 = k23 - z541;
    const Scalar z547 = k24 - z512;
    const Scalar z548 = k25 + z543;
    const Scalar z549 = k26 + z513;
    const Scalar z550 = k27 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n0_384 * z551 - z554;
    const Scalar z556 = c_q4 * z551;
    const Scalar z557 = s_q4 * z551;
    const Scalar z558 = n0_384 * z552 - z553;
    const Scalar z559 = z550 + n0_0825 * z552;
    const Scalar z560 = s_q4 * z559 - c_q4 * z558;
    const Scalar z561 = s_q4 * z558 + c_q4 * z559;
    const Scalar z562 = n0_0825 * z552 - z561;
    const Scalar z563 = s_q3 * z552 + c_q3 * z556;
    const Scalar z564 = s_q3 * z556 - c_q3 * z552;
    const Scalar z565 = z555 - n0_0825 * z557;
    const Scalar z566 = s_q3 * z565 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z565;
    const Scalar z568 = n0_316 * z563 - z567;
    const Scalar z571 = n0_316 * z564 + z566;
    const Scalar z573 = s_q2 * z571 - c_q2 * z562;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n0_768 * z510 + z578;
    const Scalar z582 = n0_0825 * z510 + n0_384 * z552 - z553;
    const Scalar z583 = n0_0825 * z551 + z580;
    const Scalar z584 = z550 + n0_165 * z552;
    const Scalar z585 = n0_768 * z510 + n0_165 * z552 + z579;
    const Scalar z586 = k30 + z552;
    const Scalar z587 = k31 + z510;
    const Scalar z588 = k32 + z581;
    const Scalar z589 = k33 + z582;
    const Scalar z590 = k34 + z583;
    const Scalar z591 = k35 + z555;
    const Scalar z592 = k36 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = c_q3 * z593;
    const Scalar z598 = s_q3 * z593;
    const Scalar z599 = z592 - n0_0825 * z594;
    const Scalar z600 = s_q3 * z599 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z599;
    const Scalar z602 = n0_316 * z597 + z601;
    const Scalar z605 = n0_316 * z598 - z600;
    const Scalar z607 = s_q2 * z605 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = n0_0825 * z551 - z595;
    const Scalar z616 = n0_0825 * z593 - z614;
    const Scalar z617 = z592 - n0_165 * z594;
    const Scalar z618 = n0_165 * z594 - z613;
    const Scalar z619 = k37 - z594;
    const Scalar z620 = k38 - z551;
    const Scalar z621 = k39 + z612;
    const Scalar z622 = k40 - z615;
    const Scalar z623 = k41 - z616;
    const Scalar z624 = k42 + z596;
    const Scalar z625 = k43 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n0_316 * z626 + z629;
    const Scalar z633 = n0_316 * z627 + z628;
    const Scalar z635 = s_q2 * z633 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = n0_632 * z593 - z640;
    const Scalar z644 = n0_632 * z593 - z641;
    const Scalar z647 = k45 - z643;
    const Scalar z648 = k46 + z633;
    const Scalar z649 = k47 - z642;
    const Scalar z650 = k48 + z630;
    const Scalar z651 = k49 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k50 + z661;
    mass[0] = z669;
    mass[1] = -z655;
    mass[2] = -z635;
    mass[3] = z607;
    mass[4] = z573;
    mass[5] = -z536;
    mass[6] = z496;
    mass[7] = -z655;
    mass[8] = z651;
    mass[9] = -z630;
    mass[10] = z602;
    mass[11] = z568;
    mass[12] = z531;
    mass[13] = z491;
    mass[14] = -z635;
    mass[15] = -z630;
    mass[16] = z625;
    mass[17] = z596;
    mass[18] = -z562;
    mass[19] = -z525;
    mass[20] = -z485;
    mass[21] = z607;
    mass[22] = z602;
    mass[23] = z596;
    mass[24] = z592;
    mass[25] = -z555;
    mass[26] = -z518;
    mass[27] = z478;
    mass[28] = z573;
    mass[29] = z568;
    mass[30] = -z562;
    mass[31] = -z555;
    mass[32] = z550;
    mass[33] = -z513;
    mass[34] = z473;
    mass[35] = -z536;
    mass[36] = z531;
    mass[37] = -z525;
    mass[38] = -z518;
    mass[39] = -z513;
    mass[40] = z509;
    mass[41] = -z468;
    mass[42] = z496;
    mass[43] = z491;
    mass[44] = -z485;
    mass[45] = z478;
    mass[46] = z473;
    mass[47] = -z468;
    mass[48] = k4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k6 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k7 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k8 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k9 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k10 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k11 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k12 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k13 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k14 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k15 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar k16 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k17 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k18 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k19 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k20 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k21 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k22 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k23 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k24 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k27 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar k28 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k29 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k30 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k31 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k34 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k35 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k36 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k37 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k38 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k39 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k40 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k41 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k42 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k43 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k44 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k45 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k46 = traits::constant(2.025402344516817, 2.0254023f, "15823455816537633/7812500000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k49 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k50 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k51 = traits::constant(3.104340043512, 3.10434f, "388042505439/125000000000");
    const Scalar k52 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k53 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar v_q1 = state.v.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    Scalar s_q2, c_q2;
    traits::sincos(q_q2, s_q2, c_q2);
    Scalar s_q3, c_q3;
    traits::sincos(q_q3, s_q3, c_q3);
    Scalar s_q4, c_q4;
    traits::sincos(q_q4, s_q4, c_q4);
    Scalar s_q5, c_q5;
    traits::sincos(q_q5, s_q5, c_q5);
    Scalar s_q6, c_q6;
    traits::sincos(q_q6, s_q6, c_q6);
    Scalar s_q7, c_q7;
    traits::sincos(q_q7, s_q7, c_q7);
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z677 = n9_81 * s_q2;
    const Scalar z678 = n9_81 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z685 = n2 * z679;
    const Scalar z686 = c_q3 * z679;
    const Scalar z687 = s_q3 * z679;
    const Scalar z688 = z677 + n0_316 * z681;
    const Scalar z689 = z678 - n0_316 * z684;
    const Scalar z690 = n0_316 * z685;
    const Scalar z691 = s_q3 * z690 - c_q3 * z688;
    const Scalar z692 = s_q3 * z688 + c_q3 * z690;
    const Scalar z693 = v_q3 * z40 - z686;  // angular acceleration of link3, x
    const Scalar z694 = v_q3 * z39 - z687;  // angular acceleration of link3, y
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z699 = z680 - z698;
    const Scalar z700 = z39 * z43;
    const Scalar z701 = z694 + z700;
    const Scalar z702 = s_q4 * z680 - c_q4 * z693;
    const Scalar z703 = s_q4 * z693 + c_q4 * z680;
    const Scalar z704 = z691 - n0_0825 * z697;
    const Scalar z705 = z692 - n0_0825 * z699;
    const Scalar z706 = z689 + n0_0825 * z701;
    const Scalar z707 = s_q4 * z706 + c_q4 * z704;
    const Scalar z708 = s_q4 * z704 - c_q4 * z706;
    const Scalar z709 = v_q4 * z47 + z702;  // angular acceleration of link4, x
    const Scalar z710 = v_q4 * z46 + z703;  // angular acceleration of link4, y
    const Scalar z711 = z47 * z47;
    const Scalar z712 = z50 * z50;
    const Scalar z713 = z711 + z712;
    const Scalar z714 = z46 * z47;
    const Scalar z715 = z694 + z714;
    const Scalar z716 = z694 - z714;
    const Scalar z717 = z46 * z46;
    const Scalar z718 = z712 + z717;
    const Scalar z719 = z46 * z50;
    const Scalar z720 = z710 + z719;
    const Scalar z721 = z47 * z50;
    const Scalar z722 = z709 + z721;
    const Scalar z723 = s_q5 * z694 + c_q5 * z709;
    const Scalar z724 = s_q5 * z709 - c_q5 * z694;
    const Scalar z725 = z707 + n0_0825 * z713 - n0_384 * z715;
    const Scalar z726 = z708 + n0_0825 * z716 + n0_384 * z718;
    const Scalar z727 = z705 + n0_0825 * z720 + n0_384 * z722;
    const Scalar z728 = s_q5 * z727 + c_q5 * z725;
    const Scalar z729 = s_q5 * z725 - c_q5 * z727;
    const Scalar z730 = v_q5 * z55 + z723;  // angular acceleration of link5, x
    const Scalar z731 = v_q5 * z54 + z724;  // angular acceleration of link5, y
    const Scalar z732 = s_q6 * z710 + c_q6 * z730;
    const Scalar z733 = s_q6 * z730 - c_q6 * z710;
    const Scalar z734 = s_q6 * z726 - c_q6 * z728;
    const Scalar z735 = s_q6 * z728 + c_q6 * z726;
    const Scalar z736 = v_q6 * z60 - z732;  // angular acceleration of link6, x
    const Scalar z737 = v_q6 * z59 - z733;  // angular acceleration of link6, y
    const Scalar z738 = z60 * z60;
    const Scalar z739 = z63 * z63;
    const Scalar z740 = z738 + z739;
    const Scalar z741 = z59 * z60;
    const Scalar z742 = z731 - z741;
    const Scalar z743 = z59 * z63;
    const Scalar z744 = z737 + z743;
    const Scalar z745 = s_q7 * z731 - c_q7 * z736;
    const Scalar z746 = s_q7 * z736 + c_q7 * z731;
    const Scalar z747 = z734 + n0_088 * z740;
    const Scalar z748 = z735 + n0_088 * z742;
    const Scalar z749 = z729 + n0_088 * z744;
    const Scalar z750 = s_q7 * z749 - c_q7 * z747;
    const Scalar z751 = s_q7 * z747 + c_q7 * z749;
    const Scalar z752 = v_q7 * z67 + z745;  // angular acceleration of link7, x
    const Scalar z753 = v_q7 * z66 + z746;  // angular acceleration of link7, y
    const Scalar z754 = z67 * z67;
    const Scalar z755 = z70 * z70;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z66 * z67;
    const Scalar z758 = z737 + z757;
    const Scalar z759 = z737 - z757;
    const Scalar z760 = z66 * z66;
    const Scalar z761 = z755 + z760;
    const Scalar z762 = z66 * z70;
    const Scalar z763 = z753 + z762;
    const Scalar z764 = z67 * z70;
    const Scalar z765 = z752 + z764;
    const Scalar z766 = z754 - z755;
    const Scalar z767 = z755 - z760;
    const Scalar z768 = z752 - z764;
    const Scalar z769 = z753 - z762;
    const Scalar z770 = z754 - z760;
    const Scalar z771 = k6 * z756 - k7 * z758;  // force on link7, x
    const Scalar z772 = k6 * z759 + k7 * z761;  // force on link7, y
    const Scalar z773 = k6 * z763 + k7 * z765;  // force on link7, z
    const Scalar z774 = k7 * z748 + k8 * z752 + k9 * z759 - k10 * z763 + k11 * z764 + k12 * z766;  // moment on link7, x
    const Scalar z775 = k6 * z748 + k12 * z758 + k13 * z762 - k10 * z765 + k9 * z767;  // moment on link7, y
    // moment on link7, z
    const Scalar z776 = k11 * z737 + k7 * z750 + k6 * z751 + k8 * z757 + k9 * z768 + k12 * z769 + k10 * z770;
    const Scalar z777 = s_q7 * z772 + c_q7 * z771;
    const Scalar z778 = s_q7 * z771 - c_q7 * z772;
    const Scalar z779 = s_q7 * z775 - c_q7 * z774;
    const Scalar z780 = s_q7 * z774 + c_q7 * z775;
    const Scalar z781 = z731 + z741;
    const Scalar z782 = z59 * z59;
    const Scalar z783 = z739 + z782;
    const Scalar z784 = z60 * z63;
    const Scalar z785 = z736 + z784;
    const Scalar z786 = z738 - z739;
    const Scalar z787 = z739 - z782;
    const Scalar z788 = z736 - z784;
    const Scalar z789 = z737 - z743;
    const Scalar z790 = z738 - z782;
    const Scalar z791 = k14 * z740 + z777 + k15 * z781;  // force on link6, x
    const Scalar z792 = k14 * z742 + z773 - k15 * z783;  // force on link6, y
    const Scalar z793 = k14 * z744 - z778 - k15 * z785;  // force on link6, z
    // moment on link6, x
    const Scalar z794 = k15 * z729 + k16 * z736 - k17 * z742 + k18 * z744 - z779 - k19 * z784 - k20 * z786;
    // moment on link6, y
    const Scalar z795 = k14 * z729 + k21 * z743 + z776 - n0_088 * z778 + k20 * z781 - k18 * z785 + k17 * z787;
    // moment on link6, z
    const Scalar z796 = k19 * z731 + k15 * z734 + k14 * z735 - k16 * z741 + n0_088 * z773 + z780 + k17 * z788 + k20
        * z789 + k18 * z790;
    const Scalar z797 = s_q6 * z792 - c_q6 * z791;
    const Scalar z798 = s_q6 * z791 + c_q6 * z792;
    const Scalar z799 = s_q6 * z795 - c_q6 * z794;
    const Scalar z800 = s_q6 * z794 + c_q6 * z795;
    const Scalar z801 = z55 * z55;
    const Scalar z802 = z58 * z58;
    const Scalar z803 = z801 + z802;
    const Scalar z804 = z54 * z55;
    const Scalar z805 = z710 + z804;
    const Scalar z806 = z710 - z804;
    const Scalar z807 = z54 * z54;
    const Scalar z808 = z802 + z807;
    const Scalar z809 = z54 * z58;
    const Scalar z810 = z731 + z809;
    const Scalar z811 = z55 * z58;
    const Scalar z812 = z730 + z811;
    const Scalar z813 = z801 - z802;
    const Scalar z814 = z802 - z807;
    const Scalar z815 = z730 - z811;
    const Scalar z816 = z731 - z809;
    const Scalar z817 = z801 - z807;
    const Scalar z818 = z797 + k22 * z803 + k23 * z805;  // force on link5, x
    const Scalar z819 = z793 - k22 * z806 + k23 * z808;  // force on link5, y
    const Scalar z820 = z798 - k22 * z810 + k23 * z812;  // force on link5, z
    // moment on link5, x
    const Scalar z821 = k23 * z726 + k24 * z730 - z799 - k25 * z806 + k26 * z810 + k27 * z811 - k28 * z813;
    const Scalar z822 = k22 * z726 - z796 + k28 * z805 - k29 * z809 - k26 * z812 + k25 * z814;  // moment on link5, y
    // moment on link5, z
    const Scalar z823 = k27 * z710 + k23 * z728 - k22 * z729 + z800 + k24 * z804 - k25 * z815 - k28 * z816 - k26 * z817;
    const Scalar z824 = s_q5 * z819 + c_q5 * z818;
    const Scalar z825 = s_q5 * z818 - c_q5 * z819;
    const Scalar z826 = s_q5 * z822 - c_q5 * z821;
    const Scalar z827 = s_q5 * z821 + c_q5 * z822;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z830 = z709 - z721;
    const Scalar z831 = z710 - z719;
    const Scalar z832 = z711 - z717;
    const Scalar z833 = k30 * z713 - k31 * z715 + z824;  // force on link4, x
    const Scalar z834 = k30 * z716 + k31 * z718 + z820;  // force on link4, y
    const Scalar z835 = k30 * z720 + k31 * z722 + z825;  // force on link4, z
    // moment on link4, x
    const Scalar z836 = k31 * z705 + k32 * z709 - k33 * z716 + k34 * z720 + k35 * z721 + n0_384 * z825 - z826 + k36
        * z828;
    // moment on link4, y
    const Scalar z837 = k30 * z705 + k36 * z715 + k37 * z719 + k34 * z722 + z823 + n0_0825 * z825 - k33 * z829;
    // moment on link4, z
    const Scalar z838 = k35 * z694 - k31 * z707 + k30 * z708 + k32 * z714 + n0_0825 * z820 - n0_384 * z824 + z827 - k33
        * z830 + k36 * z831 - k34 * z832;
    const Scalar z839 = s_q4 * z834 + c_q4 * z833;
    const Scalar z840 = s_q4 * z833 - c_q4 * z834;
    const Scalar z841 = s_q4 * z837 - c_q4 * z836;
    const Scalar z842 = s_q4 * z836 + c_q4 * z837;
    const Scalar z843 = z680 + z698;
    const Scalar z844 = z39 * z39;
    const Scalar z845 = z696 + z844;
    const Scalar z846 = z40 * z43;
    const Scalar z847 = z693 + z846;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z850 = z693 - z846;
    const Scalar z851 = z694 - z700;
    const Scalar z852 = z695 - z844;
    const Scalar z853 = k38 * z697 - z839 - k39 * z843;  // force on link3, x
    const Scalar z854 = k38 * z699 - z835 + k39 * z845;  // force on link3, y
    // moment on link3, x
    const Scalar z856 = k39 * z689 + k40 * z693 + k41 * z699 + k42 * z701 + z841 + k43 * z846 - k44 * z848;
    // moment on link3, y
    const Scalar z857 = k38 * z689 + k45 * z700 + z838 + n0_0825 * z840 - k44 * z843 + k42 * z847 + k41 * z849;
    // moment on link3, z
    const Scalar z858 = k43 * z680 + k39 * z691 - k38 * z692 + k40 * z698 - n0_0825 * z835 + z842 + k41 * z850 - k44
        * z851 - k42 * z852;
    const Scalar z859 = s_q3 * z854 - c_q3 * z853;
    const Scalar z860 = s_q3 * z853 + c_q3 * z854;
    const Scalar z861 = s_q3 * z857 + c_q3 * z856;
    const Scalar z862 = s_q3 * z856 - c_q3 * z857;
    const Scalar z863 = z36 * z36;
    const Scalar z865 = n2 * z680;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z872 = k46 * z679 - k47 * z681 - n0_316 * z860 - z861 + k48 * z865 + k49 * z866;  // moment on link2, x
    const Scalar z873 = k50 * z680 - k49 * z681 + k48 * z685 + z858 + k47 * z867;  // moment on link2, y
    const Scalar z874 = k51 * z677 - k52 * z678 + k53 * z681 - n0_316 * z859 - z862 + k48 * z868;  // moment on link2, z
    const Scalar z878 = s_q2 * z872 - c_q2 * z873;
    forces.q1 = z878;
    forces.q2 = -z874;
    forces.q3 = -z858;
    forces.q4 = z838;
    forces.q5 = -z823;
    forces.q6 = -z796;
    forces.q7 = z776;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k5 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k6 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k7 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k8 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k9 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k10 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k12 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k13 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k14 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar k15 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k16 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k17 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k18 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k19 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k20 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k21 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k22 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k23 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar k24 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k25 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k26 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k27 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k28 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k29 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k30 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k31 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k32 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k33 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k36 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k37 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k38 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k39 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k40 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k41 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k42 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k43 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k44 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k45 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k46 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k47 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k48 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k49 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k50 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k51 = traits::constant(3.104340043512, 3.10434f, "388042505439/125000000000");
    const Scalar k52 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k53 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar v_q1 = state.v.q1;
    const Scalar a_q1 = accelerations.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar a_q2 = accelerations.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar a_q3 = accelerations.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar a_q4 = accelerations.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar a_q5 = accelerations.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar a_q6 = accelerations.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar a_q7 = accelerations.q7;
    Scalar s_q2, c_q2;
    traits::sincos(q_q2, s_q2, c_q2);
    Scalar s_q3, c_q3;
    traits::sincos(q_q3, s_q3, c_q3);
    Scalar s_q4, c_q4;
    traits::sincos(q_q4, s_q4, c_q4);
    Scalar s_q5, c_q5;
    traits::sincos(q_q5, s_q5, c_q5);
    Scalar s_q6, c_q6;
    traits::sincos(q_q6, s_q6, c_q6);
    Scalar s_q7, c_q7;
    traits::sincos(q_q7, s_q7, c_q7);
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z677 = n9_81 * s_q2;
    const Scalar z678 = n9_81 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z689 = z678 - n0_316 * z684;
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z700 = z39 * z43;
    const Scalar z711 = z47 * z47;
    const Scalar z712 = z50 * z50;
    const Scalar z713 = z711 + z712;
    const Scalar z714 = z46 * z47;
    const Scalar z717 = z46 * z46;
    const Scalar z718 = z712 + z717;
    const Scalar z719 = z46 * z50;
    const Scalar z721 = z47 * z50;
    const Scalar z738 = z60 * z60;
    const Scalar z739 = z63 * z63;
    const Scalar z740 = z738 + z739;
    const Scalar z741 = z59 * z60;
    const Scalar z743 = z59 * z63;
    const Scalar z754 = z67 * z67;
    const Scalar z755 = z70 * z70;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z66 * z67;
    const Scalar z760 = z66 * z66;
    const Scalar z761 = z755 + z760;
    const Scalar z762 = z66 * z70;
    const Scalar z764 = z67 * z70;
    const Scalar z766 = z754 - z755;
    const Scalar z767 = z755 - z760;
    const Scalar z770 = z754 - z760;
    const Scalar z782 = z59 * z59;
    const Scalar z783 = z739 + z782;
    const Scalar z784 = z60 * z63;
    const Scalar z786 = z738 - z739;
    const Scalar z787 = z739 - z782;
    const Scalar z790 = z738 - z782;
    const Scalar z801 = z55 * z55;
    const Scalar z802 = z58 * z58;
    const Scalar z803 = z801 + z802;
    const Scalar z804 = z54 * z55;
    const Scalar z807 = z54 * z54;
    const Scalar z808 = z802 + z807;
    const Scalar z809 = z54 * z58;
    const Scalar z811 = z55 * z58;
    const Scalar z813 = z801 - z802;
    const Scalar z814 = z802 - z807;
    const Scalar z817 = z801 - z807;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z832 = z711 - z717;
    const Scalar z844 = z39 * z39;
    const Scalar z845 = z696 + z844;
    const Scalar z846 = z40 * z43;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z852 = z695 - z844;
    const Scalar z863 = z36 * z36;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z884 = a_q1 * s_q2;
    const Scalar z885 = a_q1 * c_q2;
    const Scalar z886 = v_q2 * z36 + z884;  // angular acceleration of link2, x
    const Scalar z887 = v_q2 * z35 - z885;  // angular acceleration of link2, y
    const Scalar z888 = a_q2 - z681;
    const Scalar z889 = z679 + z886;
    const Scalar z890 = a_q2 * s_q3 - c_q3 * z886;
    const Scalar z891 = a_q2 * c_q3 + s_q3 * z886;
    const Scalar z892 = z677 - n0_316 * z888;
    const Scalar z893 = n0_316 * z889;
    const Scalar z894 = s_q3 * z893 - c_q3 * z892;
    const Scalar z895 = s_q3 * z892 + c_q3 * z893;
    const Scalar z896 = v_q3 * z40 + z890;  // angular acceleration of link3, x
    const Scalar z897 = v_q3 * z39 - z891;  // angular acceleration of link3, y
    const Scalar z898 = a_q3 - z887;  // angular acceleration of link3, z
    const Scalar z899 = z698 + z898;
    const Scalar z900 = z700 + z897;
    const Scalar z901 = s_q4 * z898 + c_q4 * z896;
    const Scalar z902 = s_q4 * z896 - c_q4 * z898;
    const Scalar z903 = n0_0825 * z697 - z894;
    const Scalar z904 = z895 + n0_0825 * z899;
    const Scalar z905 = z689 + n0_0825 * z900;
    const Scalar z906 = s_q4 * z905 - c_q4 * z903;
    const Scalar z907 = s_q4 * z903 + c_q4 * z905;
    const Scalar z908 = v_q4 * z47 - z901;  // angular acceleration of link4, x
    const Scalar z909 = v_q4 * z46 + z902;  // angular acceleration of link4, y
    const Scalar z910 = a_q4 + z897;  // angular acceleration of link4, z
    const Scalar z911 = z714 + z910;
    const Scalar z912 = z714 - z910;
    const Scalar z913 = z719 + z909;
    const Scalar z914 = z721 + z908;
    const Scalar z915 = s_q5 * z910 + c_q5 * z908;
    const Scalar z916 = s_q5 * z908 - c_q5 * z910;
    const Scalar z917 = n0_0825 * z713 + z906 - n0_384 * z911;
    const Scalar z918 = n0_384 * z718 - z907 - n0_0825 * z912;
    const Scalar z919 = z904 + n0_0825 * z913 + n0_384 * z914;
    const Scalar z920 = s_q5 * z919 + c_q5 * z917;
    const Scalar z921 = s_q5 * z917 - c_q5 * z919;
    const Scalar z922 = v_q5 * z55 + z915;  // angular acceleration of link5, x
    const Scalar z923 = v_q5 * z54 + z916;  // angular acceleration of link5, y
    const Scalar z924 = a_q5 - z909;  // angular acceleration of link5, z
    const Scalar z925 = s_q6 * z924 - c_q6 * z922;
    const Scalar z926 = s_q6 * z922 + c_q6 * z924;
    const Scalar z927 = s_q6 * z918 - c_q6 * z920;
    const Scalar z928 = s_q6 * z920 + c_q6 * z918;
    const Scalar z929 = v_q6 * z60 + z925;  // angular acceleration of link6, x
    const Scalar z930 = v_q6 * z59 - z926;  // angular acceleration of link6, y
    const Scalar z931 = a_q6 - z923;  // angular acceleration of link6, z
    const Scalar z932 = z741 + z931;
    const Scalar z933 = z743 + z930;
    const Scalar z934 = s_q7 * z931 + c_q7 * z929;
    const Scalar z935 = s_q7 * z929 - c_q7 * z931;
    const Scalar z936 = n0_088 * z740 + z927;
    const Scalar z937 = z928 - n0_088 * z932;
    const Scalar z938 = z921 + n0_088 * z933;
    const Scalar z939 = s_q7 * z938 - c_q7 * z936;
    const Scalar z940 = s_q7 * z936 + c_q7 * z938;
    const Scalar z941 = v_q7 * z67 - z934;  // angular acceleration of link7, x
    const Scalar z942 = v_q7 * z66 + z935;  // angular acceleration of link7, y
    const Scalar z943 = a_q7 + z930;  // angular acceleration of link7, z
    const Scalar z944 = z757 + z943;
    const Scalar z945 = z757 - z943;
    const Scalar z946 = z762 + z942;
    const Scalar z947 = z764 + z941;
    const Scalar z948 = z764 - z941;
    const Scalar z949 = z762 - z942;
    const Scalar z950 = k5 * z756 - k6 * z944;  // force on link7, x
    const Scalar z951 = k6 * z761 - k5 * z945;  // force on link7, y
    const Scalar z952 = k5 * z946 + k6 * z947;  // force on link7, z
    const Scalar z953 = k7 * z764 + k8 * z766 + k6 * z937 + k9 * z941 - k10 * z945 - k11 * z946;  // moment on link7, x
    const Scalar z954 = k12 * z762 + k10 * z767 + k5 * z937 + k8 * z944 - k11 * z947;  // moment on link7, y
    // moment on link7, z
    const Scalar z955 = k9 * z757 + k11 * z770 + k6 * z939 + k5 * z940 + k7 * z943 - k10 * z948 - k8 * z949;
    const Scalar z956 = s_q7 * z951 + c_q7 * z950;
    const Scalar z957 = s_q7 * z950 - c_q7 * z951;
    const Scalar z958 = s_q7 * z954 - c_q7 * z953;
    const Scalar z959 = s_q7 * z953 + c_q7 * z954;
    const Scalar z960 = z741 - z931;
    const Scalar z961 = z784 + z929;
    const Scalar z962 = z784 - z929;
    const Scalar z963 = z743 - z930;
    const Scalar z964 = k13 * z740 + z956 + k14 * z960;  // force on link6, x
    const Scalar z965 = k14 * z783 + k13 * z932 - z952;  // force on link6, y
    const Scalar z966 = k13 * z933 - z957 - k14 * z961;  // force on link6, z
    // moment on link6, x
    const Scalar z967 = k15 * z784 + k16 * z786 - k14 * z921 - k17 * z929 - k18 * z932 - k19 * z933 + z958;
    // moment on link6, y
    const Scalar z968 = k20 * z743 + k18 * z787 + k13 * z921 + z955 - n0_088 * z957 + k16 * z960 - k19 * z961;
    // moment on link6, z
    const Scalar z969 = k17 * z741 - k19 * z790 - k14 * z927 - k13 * z928 + k15 * z931 - n0_088 * z952 - z959 + k18
        * z962 + k16 * z963;
    const Scalar z970 = s_q6 * z965 + c_q6 * z964;
    const Scalar z971 = s_q6 * z964 - c_q6 * z965;
    const Scalar z972 = s_q6 * z968 + c_q6 * z967;
    const Scalar z973 = s_q6 * z967 - c_q6 * z968;
    const Scalar z974 = z804 - z924;
    const Scalar z975 = z804 + z924;
    const Scalar z976 = z809 + z923;
    const Scalar z977 = z811 + z922;
    const Scalar z978 = z811 - z922;
    const Scalar z979 = z809 - z923;
    const Scalar z980 = k21 * z803 - z970 + k22 * z974;  // force on link5, x
    const Scalar z981 = k22 * z808 + z966 + k21 * z975;  // force on link5, y
    const Scalar z982 = z971 - k21 * z976 + k22 * z977;  // force on link5, z
    // moment on link5, x
    const Scalar z983 = k23 * z811 - k24 * z813 + k22 * z918 + k25 * z922 - z972 + k26 * z975 + k27 * z976;
    const Scalar z984 = k28 * z809 - k26 * z814 - k21 * z918 - z969 - k24 * z974 + k27 * z977;  // moment on link5, y
    // moment on link5, z
    const Scalar z985 = k25 * z804 - k27 * z817 + k22 * z920 - k21 * z921 - k23 * z924 - z973 + k26 * z978 + k24 * z979;
    const Scalar z986 = s_q5 * z981 + c_q5 * z980;
    const Scalar z987 = s_q5 * z980 - c_q5 * z981;
    const Scalar z988 = s_q5 * z984 + c_q5 * z983;
    const Scalar z989 = s_q5 * z983 - c_q5 * z984;
    const Scalar z990 = z721 - z908;
    const Scalar z991 = z719 - z909;
    const Scalar z992 = k29 * z713 - k30 * z911 + z986;  // force on link4, x
    const Scalar z993 = k30 * z718 - k29 * z912 + z982;  // force on link4, y
    const Scalar z994 = k29 * z913 + k30 * z914 + z987;  // force on link4, z
    // moment on link4, x
    const Scalar z995 = k31 * z721 + k32 * z828 + k30 * z904 + k33 * z908 + k34 * z912 + k35 * z913 + n0_384 * z987
        + z988;
    // moment on link4, y
    const Scalar z996 = k36 * z719 - k34 * z829 + k29 * z904 + k32 * z911 + k35 * z914 + z985 + n0_0825 * z987;
    // moment on link4, z
    const Scalar z997 = k33 * z714 - k35 * z832 - k30 * z906 - k29 * z907 + k31 * z910 + n0_0825 * z982 - n0_384 * z986
        + z989 + k34 * z990 - k32 * z991;
    const Scalar z998 = s_q4 * z993 + c_q4 * z992;
    const Scalar z999 = s_q4 * z992 - c_q4 * z993;
    const Scalar z1000 = s_q4 * z996 - c_q4 * z995;
    const Scalar z1001 = s_q4 * z995 + c_q4 * z996;
    const Scalar z1002 = z698 - z898;
    const Scalar z1003 = z846 + z896;
    const Scalar z1004 = z846 - z896;
    const Scalar z1005 = z700 - z897;
    const Scalar z1006 = k37 * z697 - z998 - k38 * z1002;  // force on link3, x
    const Scalar z1007 = k38 * z845 - k37 * z899 - z994;  // force on link3, y
    // moment on link3, x
    const Scalar z1009 = k38 * z689 + k39 * z846 - k40 * z848 + k41 * z896 - k42 * z899 + k43 * z900 + z1000;
    // moment on link3, y
    const Scalar z1010 = k37 * z689 + k44 * z700 + k42 * z849 + z997 + n0_0825 * z999 - k40 * z1002 + k43 * z1003;
    // moment on link3, z
    const Scalar z1011 = k41 * z698 - k43 * z852 + k38 * z894 - k37 * z895 - k39 * z898 - n0_0825 * z994 + z1001 - k42
        * z1004 + k40 * z1005;
    const Scalar z1012 = s_q3 * z1007 - c_q3 * z1006;
    const Scalar z1013 = s_q3 * z1006 + c_q3 * z1007;
    const Scalar z1014 = s_q3 * z1010 + c_q3 * z1009;
    const Scalar z1015 = s_q3 * z1009 - c_q3 * z1010;
    const Scalar z1016 = a_q2 + z681;
    const Scalar z1017 = z680 + z887;
    const Scalar z1018 = z679 - z886;
    const Scalar z1019 = z680 - z887;
    // moment on link2, x
    const Scalar z1023 = k45 * z679 + k46 * z866 + k47 * z886 - n0_316 * z1013 - z1014 - k48 * z1016 + k49 * z1017;
    const Scalar z1024 = k50 * z680 + k48 * z867 + k46 * z888 + k49 * z889 + z1011;  // moment on link2, y
    // moment on link2, z
    const Scalar z1025 = k45 * a_q2 - k51 * z677 + k52 * z678 - k47 * z681 - k49 * z868 + n0_316 * z1012 + z1015 + k48
        * z1018 - k46 * z1019;
    const Scalar z1029 = s_q2 * z1023 - c_q2 * z1024;
    const Scalar z1034 = k53 * a_q1 + z1029;  // moment on link1, z
    forces.q1 = z1034;
    forces.q2 = z1025;
    forces.q3 = -z1011;
    forces.q4 = z997;
    forces.q5 = -z985;
    forces.q6 = z969;
    forces.q7 = z955;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by an
  /// unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not positive
  /// relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar k0 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k1 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar k9 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k10 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n0_176 = traits::constant(0.176, 0.176f, "22/125");
    const Scalar k13 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k14 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k15 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k18 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k19 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k21 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k22 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k23 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k24 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k27 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n0_768 = traits::constant(0.768, 0.768f, "96/125");
    const Scalar n0_165 = traits::constant(0.165, 0.165f, "33/200");
    const Scalar k30 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k31 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k36 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k37 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k38 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k41 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar n0_632 = traits::constant(0.632, 0.632f, "79/125");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k49 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k50 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k52 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k53 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k54 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k55 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k56 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k57 = traits::constant(2.025402344516817, 2.0254023f, "15823455816537633/7812500000000000");
    const Scalar k58 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k59 = traits::constant(3.104340043512, 3.10434f, "388042505439/125000000000");
    const Scalar k60 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k61 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_q1 = state.v.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar u_tau1 = inputs.tau1;
    const Scalar u_tau2 = inputs.tau2;
    const Scalar u_tau3 = inputs.tau3;
    const Scalar u_tau4 = inputs.tau4;
    const Scalar u_tau5 = inputs.tau5;
    const Scalar u_tau6 = inputs.tau6;
    const Scalar u_tau7 = inputs.tau7;
    Scalar s_q2, c_q2;
    traits::sincos(q_q2, s_q2, c_q2);
    Scalar s_q3, c_q3;
    traits::sincos(q_q3, s_q3, c_q3);
    Scalar s_q4, c_q4;
    traits::sincos(q_q4, s_q4, c_q4);
    Scalar s_q5, c_q5;
    traits::sincos(q_q5, s_q5, c_q5);
    Scalar s_q6, c_q6;
    traits::sincos(q_q6, s_q6, c_q6);
    Scalar s_q7, c_q7;
    traits::sincos(q_q7, s_q7, c_q7);
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z465 = k0 * s_q7 - k1 * c_q7;
    const Scalar z466 = k1 * s_q7 + k0 * c_q7;
    const Scalar z467 = k2 * s_q7 - k3 * c_q7;
    const Scalar z468 = k3 * s_q7 + k2 * c_q7;
    const Scalar z469 = c_q6 * z465;
    const Scalar z470 = s_q6 * z465;
    const Scalar z471 = k4 + n0_088 * z466;
    const Scalar z472 = s_q6 * z471 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z471;
    const Scalar z474 = s_q5 * z466 - c_q5 * z469;
    const Scalar z475 = s_q5 * z469 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n0_0825 * z470 - n0_384 * z474 - z477;
    const Scalar z479 = s_q4 * z470 + c_q4 * z474;
    const Scalar z480 = s_q4 * z474 - c_q4 * z470;
    const Scalar z481 = n0_384 * z475 - z476;
    const Scalar z482 = z473 + n0_0825 * z475;
    const Scalar z483 = s_q4 * z482 - c_q4 * z481;
    const Scalar z484 = s_q4 * z481 + c_q4 * z482;
    const Scalar z485 = n0_0825 * z475 - z484;
    const Scalar z486 = s_q3 * z475 + c_q3 * z479;
    const Scalar z487 = s_q3 * z479 - c_q3 * z475;
    const Scalar z488 = z478 + n0_0825 * z480;
    const Scalar z489 = s_q3 * z488 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z488;
    const Scalar z491 = n0_316 * z486 - z490;
    const Scalar z494 = n0_316 * z487 - z489;
    const Scalar z496 = s_q2 * z494 - c_q2 * z485;
    const Scalar z497 = k9 * s_q7 - k10 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k9 - z498;
    const Scalar z500 = k11 + c_q7 * z497;
    const Scalar z501 = n0_088 * z465 - z500;
    const Scalar z502 = k4 + n0_176 * z466;
    const Scalar z503 = n0_176 * z466 + z498;
    const Scalar z504 = k13 + z466;
    const Scalar z505 = k14 - z499;
    const Scalar z506 = k15 - z467;
    const Scalar z507 = k16 + z501;
    const Scalar z508 = k17 + z468;
    const Scalar z509 = k18 + z503;
    const Scalar z510 = s_q6 * z504 - k19 * c_q6;
    const Scalar z511 = k19 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n0_0825 * z511 - n0_384 * z514 - z517;
    const Scalar z519 = s_q4 * z511 + c_q4 * z514;
    const Scalar z520 = s_q4 * z514 - c_q4 * z511;
    const Scalar z521 = n0_384 * z515 + z516;
    const Scalar z522 = z513 - n0_0825 * z515;
    const Scalar z523 = s_q4 * z522 + c_q4 * z521;
    const Scalar z524 = s_q4 * z521 - c_q4 * z522;
    const Scalar z525 = n0_0825 * z515 - z524;
    const Scalar z526 = s_q3 * z515 - c_q3 * z519;
    const Scalar z527 = s_q3 * z519 + c_q3 * z515;
    const Scalar z528 = z518 + n0_0825 * z520;
    const Scalar z529 = s_q3 * z528 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z528;
    const Scalar z531 = n0_316 * z526 + z530;
    const Scalar z534 = n0_316 * z527 - z529;
    const Scalar z536 = s_q2 * z534 + c_q2 * z525;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k21 - z511;
    const Scalar z545 = k22 - z465;
    const Scalar z546 = k23 - z541;
    const Scalar z547 = k24 - z512;
    const Scalar z548 = k25 + z543;
    const Scalar z549 = k26 + z513;
    const Scalar z550 = k27 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n0_384 * z551 - z554;
    const Scalar z556 = c_q4 * z551;
    const Scalar z557 = s_q4 * z551;
    const Scalar z558 = n0_384 * z552 - z553;
    const Scalar z559 = z550 + n0_0825 * z552;
    const Scalar z560 = s_q4 * z559 - c_q4 * z558;
    const Scalar z561 = s_q4 * z558 + c_q4 * z559;
    const Scalar z562 = n0_0825 * z552 - z561;
    const Scalar z563 = s_q3 * z552 + c_q3 * z556;
    const Scalar z564 = s_q3 * z556 - c_q3 * z552;
    const Scalar z565 = z555 - n0_0825 * z557;
    const Scalar z566 = s_q3 * z565 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z565;
    const Scalar z568 = n0_316 * z563 - z567;
    const Scalar z571 = n0_316 * z564 + z566;
    const Scalar z573 = s_q2 * z571 - c_q2 * z562;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n0_768 * z510 + z578;
    const Scalar z582 = n0_0825 * z510 + n0_384 * z552 - z553;
    const Scalar z583 = n0_0825 * z551 + z580;
    const Scalar z584 = z550 + n0_165 * z552;
    const Scalar z585 = n0_768 * z510 + n0_165 * z552 + z579;
    const Scalar z586 = k30 + z552;
    const Scalar z587 = k31 + z510;
    const Scalar z588 = k32 + z581;
    const Scalar z589 = k33 + z582;
    const Scalar z590 = k34 + z583;
    const Scalar z591 = k35 + z555;
    const Scalar z592 = k36 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = c_q3 * z593;
    const Scalar z598 = s_q3 * z593;
    const Scalar z599 = z592 - n0_0825 * z594;
    const Scalar z600 = s_q3 * z599 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z599;
    const Scalar z602 = n0_316 * z597 + z601;
    const Scalar z605 = n0_316 * z598 - z600;
    const Scalar z607 = s_q2 * z605 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = n0_0825 * z551 - z595;
    const Scalar z616 = n0_0825 * z593 - z614;
    const Scalar z617 = z592 - n0_165 * z594;
    const Scalar z618 = n0_165 * z594 - z613;
    const Scalar z619 = k37 - z594;
    const Scalar z620 = k38 - z551;
    const Scalar z621 = k39 + z612;
    const Scalar z622 = k40 - z615;
    const Scalar z623 = k41 - z616;
    const Scalar z624 = k42 + z596;
    const Scalar z625 = k43 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n0_316 * z626 + z629;
    const Scalar z633 = n0_316 * z627 + z628;
    const Scalar z635 = s_q2 * z633 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = n0_632 * z593 - z640;
    const Scalar z644 = n0_632 * z593 - z641;
    const Scalar z647 = k45 - z643;
    const Scalar z648 = k46 + z633;
    const Scalar z649 = k47 - z642;
    const Scalar z650 = k48 + z630;
    const Scalar z651 = k49 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k50 + z661;
    const Scalar z677 = n9_81 * s_q2;
    const Scalar z678 = n9_81 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z685 = n2 * z679;
    const Scalar z686 = c_q3 * z679;
    const Scalar z687 = s_q3 * z679;
    const Scalar z688 = z677 + n0_316 * z681;
    const Scalar z689 = z678 - n0_316 * z684;
    const Scalar z690 = n0_316 * z685;
    const Scalar z691 = s_q3 * z690 - c_q3 * z688;
    const Scalar z692 = s_q3 * z688 + c_q3 * z690;
    const Scalar z693 = v_q3 * z40 - z686;  // angular acceleration of link3, x
    const Scalar z694 = v_q3 * z39 - z687;  // angular acceleration of link3, y
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z699 = z680 - z698;
    const Scalar z700 = z39 * z43;
    const Scalar z701 = z694 + z700;
    const Scalar z702 = s_q4 * z680 - c_q4 * z693;
    const Scalar z703 = s_q4 * z693 + c_q4 * z680;
    const Scalar z704 = z691 - n0_0825 * z697;
    const Scalar z705 = z692 - n0_0825 * z699;
    const Scalar z706 = z689 + n0_0825 * z701;
    const Scalar z707 = s_q4 * z706 + c_q4 * z704;
    const Scalar z708 = s_q4 * z704 - c_q4 * z706;
    const Scalar z709 = v_q4 * z47 + z702;  // angular acceleration of link4, x
    const Scalar z710 = v_q4 * z46 + z703;  // angular acceleration of link4, y
    const Scalar z711 = z47 * z47;
    const Scalar z712 = z50 * z50;
    const Scalar z713 = z711 + z712;
    const Scalar z714 = z46 * z47;
    const Scalar z715 = z694 + z714;
    const Scalar z716 = z694 - z714;
    const Scalar z717 = z46 * z46;
    const Scalar z718 = z712 + z717;
    const Scalar z719 = z46 * z50;
    const Scalar z720 = z710 + z719;
    const Scalar z721 = z47 * z50;
    const Scalar z722 = z709 + z721;
    const Scalar z723 = s_q5 * z694 + c_q5 * z709;
    const Scalar z724 = s_q5 * z709 - c_q5 * z694;
    const Scalar z725 = z707 + n0_0825 * z713 - n0_384 * z715;
    const Scalar z726 = z708 + n0_0825 * z716 + n0_384 * z718;
    const Scalar z727 = z705 + n0_0825 * z720 + n0_384 * z722;
    const Scalar z728 = s_q5 * z727 + c_q5 * z725;
    const Scalar z729 = s_q5 * z725 - c_q5 * z727;
    const Scalar z730 = v_q5 * z55 + z723;  // angular acceleration of link5, x
    const Scalar z731 = v_q5 * z54 + z724;  // angular acceleration of link5, y
    const Scalar z732 = s_q6 * z710 + c_q6 * z730;
    const Scalar z733 = s_q6 * z730 - c_q6 * z710;
    const Scalar z734 = s_q6 * z726 - c_q6 * z728;
    const Scalar z735 = s_q6 * z728 + c_q6 * z726;
    const Scalar z736 = v_q6 * z60 - z732;  // angular acceleration of link6, x
    const Scalar z737 = v_q6 * z59 - z733;  // angular acceleration of link6, y
    const Scalar z738 = z60 * z60;
    const Scalar z739 = z63 * z63;
    const Scalar z740 = z738 + z739;
    const Scalar z741 = z59 * z60;
    const Scalar z742 = z731 - z741;
    const Scalar z743 = z59 * z63;
    const Scalar z744 = z737 + z743;
    const Scalar z745 = s_q7 * z731 - c_q7 * z736;
    const Scalar z746 = s_q7 * z736 + c_q7 * z731;
    const Scalar z747 = z734 + n0_088 * z740;
    const Scalar z748 = z735 + n0_088 * z742;
    const Scalar z749 = z729 + n0_088 * z744;
    const Scalar z750 = s_q7 * z749 - c_q7 * z747;
    const Scalar z751 = s_q7 * z747 + c_q7 * z749;
    const Scalar z752 = v_q7 * z67 + z745;  // angular acceleration of link7, x
    const Scalar z753 = v_q7 * z66 + z746;  // angular acceleration of link7, y
    const Scalar z754 = z67 * z67;
    const Scalar z755 = z70 * z70;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z66 * z67;
    const Scalar z758 = z737 + z757;
    const Scalar z759 = z737 - z757;
    const Scalar z760 = z66 * z66;
    const Scalar z761 = z755 + z760;
    const Scalar z762 = z66 * z70;
    const Scalar z763 = z753 + z762;
    const Scalar z764 = z67 * z70;
    const Scalar z765 = z752 + z764;
    const Scalar z766 = z754 - z755;
    const Scalar z767 = z755 - z760;
    const Scalar z768 = z752 - z764;
    const Scalar z769 = z753 - z762;
    const Scalar z770 = z754 - z760;
    const Scalar z771 = k0 * z756 - k1 * z758;  // force on link7, x
    const Scalar z772 = k0 * z759 + k1 * z761;  // force on link7, y
    const Scalar z773 = k0 * z763 + k1 * z765;  // force on link7, z
    const Scalar z774 = k1 * z748 + k9 * z752 + k3 * z759 - k11 * z763 + k4 * z764 + k2 * z766;  // moment on link7, x
    const Scalar z775 = k0 * z748 + k2 * z758 + k52 * z762 - k11 * z765 + k3 * z767;  // moment on link7, y
    // moment on link7, z
    const Scalar z776 = k4 * z737 + k1 * z750 + k0 * z751 + k9 * z757 + k3 * z768 + k2 * z769 + k11 * z770;
    const Scalar z777 = s_q7 * z772 + c_q7 * z771;
    const Scalar z778 = s_q7 * z771 - c_q7 * z772;
    const Scalar z779 = s_q7 * z775 - c_q7 * z774;
    const Scalar z780 = s_q7 * z774 + c_q7 * z775;
    const Scalar z781 = z731 + z741;
    const Scalar z782 = z59 * z59;
    const Scalar z783 = z739 + z782;
    const Scalar z784 = z60 * z63;
    const Scalar z785 = z736 + z784;
    const Scalar z786 = z738 - z739;
    const Scalar z787 = z739 - z782;
    const Scalar z788 = z736 - z784;
    const Scalar z789 = z737 - z743;
    const Scalar z790 = z738 - z782;
    const Scalar z791 = k13 * z740 + z777 + k19 * z781;  // force on link6, x
    const Scalar z792 = k13 * z742 + z773 - k19 * z783;  // force on link6, y
    const Scalar z793 = k13 * z744 - z778 - k19 * z785;  // force on link6, z
    // moment on link6, x
    const Scalar z794 = k19 * z729 + k14 * z736 - k16 * z742 + k15 * z744 - z779 - k18 * z784 - k17 * z786;
    // moment on link6, y
    const Scalar z795 = k13 * z729 + k53 * z743 + z776 - n0_088 * z778 + k17 * z781 - k15 * z785 + k16 * z787;
    // moment on link6, z
    const Scalar z796 = k18 * z731 + k19 * z734 + k13 * z735 - k14 * z741 + n0_088 * z773 + z780 + k16 * z788 + k17
        * z789 + k15 * z790;
    const Scalar z797 = s_q6 * z792 - c_q6 * z791;
    const Scalar z798 = s_q6 * z791 + c_q6 * z792;
    const Scalar z799 = s_q6 * z795 - c_q6 * z794;
    const Scalar z800 = s_q6 * z794 + c_q6 * z795;
    const Scalar z801 = z55 * z55;
    const Scalar z802 = z58 * z58;
    const Scalar z803 = z801 + z802;
    const Scalar z804 = z54 * z55;
    const Scalar z805 = z710 + z804;
    const Scalar z806 = z710 - z804;
    const Scalar z807 = z54 * z54;
    const Scalar z808 = z802 + z807;
    const Scalar z809 = z54 * z58;
    const Scalar z810 = z731 + z809;
    const Scalar z811 = z55 * z58;
    const Scalar z812 = z730 + z811;
    const Scalar z813 = z801 - z802;
    const Scalar z814 = z802 - z807;
    const Scalar z815 = z730 - z811;
    const Scalar z816 = z731 - z809;
    const Scalar z817 = z801 - z807;
    const Scalar z818 = z797 + k21 * z803 + k22 * z805;  // force on link5, x
    const Scalar z819 = z793 - k21 * z806 + k22 * z808;  // force on link5, y
    const Scalar z820 = z798 - k21 * z810 + k22 * z812;  // force on link5, z
    // moment on link5, x
    const Scalar z821 = k22 * z726 + k23 * z730 - z799 - k25 * z806 + k24 * z810 + k27 * z811 - k26 * z813;
    const Scalar z822 = k21 * z726 - z796 + k26 * z805 - k54 * z809 - k24 * z812 + k25 * z814;  // moment on link5, y
    // moment on link5, z
    const Scalar z823 = k27 * z710 + k22 * z728 - k21 * z729 + z800 + k23 * z804 - k25 * z815 - k26 * z816 - k24 * z817;
    const Scalar z824 = s_q5 * z819 + c_q5 * z818;
    const Scalar z825 = s_q5 * z818 - c_q5 * z819;
    const Scalar z826 = s_q5 * z822 - c_q5 * z821;
    const Scalar z827 = s_q5 * z821 + c_q5 * z822;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z830 = z709 - z721;
    const Scalar z831 = z710 - z719;
    const Scalar z832 = z711 - z717;
    const Scalar z833 = k30 * z713 - k31 * z715 + z824;  // force on link4, x
    const Scalar z834 = k30 * z716 + k31 * z718 + z820;  // force on link4, y
    const Scalar z835 = k30 * z720 + k31 * z722 + z825;  // force on link4, z
    // moment on link4, x
    const Scalar z836 = k31 * z705 + k32 * z709 - k34 * z716 + k33 * z720 + k36 * z721 + n0_384 * z825 - z826 + k35
        * z828;
    // moment on link4, y
    const Scalar z837 = k30 * z705 + k35 * z715 + k55 * z719 + k33 * z722 + z823 + n0_0825 * z825 - k34 * z829;
    // moment on link4, z
    const Scalar z838 = k36 * z694 - k31 * z707 + k30 * z708 + k32 * z714 + n0_0825 * z820 - n0_384 * z824 + z827 - k34
        * z830 + k35 * z831 - k33 * z832;
    const Scalar z839 = s_q4 * z834 + c_q4 * z833;
    const Scalar z840 = s_q4 * z833 - c_q4 * z834;
    const Scalar z841 = s_q4 * z837 - c_q4 * z836;
    const Scalar z842 = s_q4 * z836 + c_q4 * z837;
    const Scalar z843 = z680 + z698;
    const Scalar z844 = z39 * z39;
    const Scalar z845 = z696 + z844;
    const Scalar z846 = z40 * z43;
    const Scalar z847 = z693 + z846;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z850 = z693 - z846;
    const Scalar z851 = z694 - z700;
    const Scalar z852 = z695 - z844;
    const Scalar z853 = k37 * z697 - z839 - k38 * z843;  // force on link3, x
    const Scalar z854 = k37 * z699 - z835 + k38 * z845;  // force on link3, y
    // moment on link3, x
    const Scalar z856 = k38 * z689 + k39 * z693 + k41 * z699 + k40 * z701 + z841 + k43 * z846 - k42 * z848;
    // moment on link3, y
    const Scalar z857 = k37 * z689 + k56 * z700 + z838 + n0_0825 * z840 - k42 * z843 + k40 * z847 + k41 * z849;
    // moment on link3, z
    const Scalar z858 = k43 * z680 + k38 * z691 - k37 * z692 + k39 * z698 - n0_0825 * z835 + z842 + k41 * z850 - k42
        * z851 - k40 * z852;
    const Scalar z859 = s_q3 * z854 - c_q3 * z853;
    const Scalar z860 = s_q3 * z853 + c_q3 * z854;
    const Scalar z861 = s_q3 * z857 + c_q3 * z856;
    const Scalar z862 = s_q3 * z856 - c_q3 * z857;
    const Scalar z863 = z36 * z36;
    const Scalar z865 = n2 * z680;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z872 = k57 * z679 - k47 * z681 - n0_316 * z860 - z861 + k46 * z865 + k48 * z866;  // moment on link2, x
    const Scalar z873 = k58 * z680 - k48 * z681 + k46 * z685 + z858 + k47 * z867;  // moment on link2, y
    const Scalar z874 = k59 * z677 - k60 * z678 + k45 * z681 - n0_316 * z859 - z862 + k46 * z868;  // moment on link2, z
    const Scalar z878 = s_q2 * z872 - c_q2 * z873;
    const Scalar z1035 = u_tau1 - z878;
    const Scalar z1036 = u_tau2 + z874;
    const Scalar z1037 = u_tau3 + z858;
    const Scalar z1038 = u_tau4 - z838;
    const Scalar z1039 = u_tau5 + z823;
    const Scalar z1040 = u_tau6 + z796;
    const Scalar z1041 = u_tau7 - z776;
    const Scalar z1042 = k61 * z496;
    const Scalar z1043 = k61 * z491;
    const Scalar z1044 = k61 * z485;
    const Scalar z1045 = k61 * z478;
    const Scalar z1046 = k61 * z473;
    const Scalar z1047 = k61 * z468;
    const Scalar z1048 = z496 * z1042 - z669;
    const Scalar z1049 = z496 * z1043 + z655;
    const Scalar z1050 = z491 * z1043 - z651;
    const Scalar z1051 = z496 * z1044 - z635;
    const Scalar z1052 = z491 * z1044 - z630;
    const Scalar z1053 = z485 * z1044 - z625;
    const Scalar z1054 = z496 * z1045 - z607;
    const Scalar z1055 = z491 * z1045 - z602;
    const Scalar z1056 = z485 * z1045 + z596;
    const Scalar z1057 = z478 * z1045 - z592;
    const Scalar z1058 = z496 * z1046 - z573;
    const Scalar z1059 = z491 * z1046 - z568;
    const Scalar z1060 = z485 * z1046 - z562;
    const Scalar z1061 = z478 * z1046 + z555;
    const Scalar z1062 = z473 * z1046 - z550;
    const Scalar z1063 = z496 * z1047 - z536;
    const Scalar z1064 = z491 * z1047 + z531;
    const Scalar z1065 = z485 * z1047 + z525;
    const Scalar z1066 = z478 * z1047 - z518;
    const Scalar z1067 = z473 * z1047 - z513;
    const Scalar z1068 = z468 * z1047 - z509;
    const Scalar z1069 = n1 / z1068;
    const Scalar z1070 = z1063 * z1069;
    const Scalar z1071 = z1064 * z1069;
    const Scalar z1072 = z1065 * z1069;
    const Scalar z1073 = z1066 * z1069;
    const Scalar z1074 = z1067 * z1069;
    const Scalar z1075 = z1048 - z1063 * z1070;
    const Scalar z1076 = z1049 - z1063 * z1071;
    const Scalar z1077 = z1050 - z1064 * z1071;
    const Scalar z1078 = z1051 - z1063 * z1072;
    const Scalar z1079 = z1052 - z1064 * z1072;
    const Scalar z1080 = z1053 - z1065 * z1072;
    const Scalar z1081 = z1054 - z1063 * z1073;
    const Scalar z1082 = z1055 - z1064 * z1073;
    const Scalar z1083 = z1056 - z1065 * z1073;
    const Scalar z1084 = z1057 - z1066 * z1073;
    const Scalar z1085 = z1058 - z1063 * z1074;
    const Scalar z1086 = z1059 - z1064 * z1074;
    const Scalar z1087 = z1060 - z1065 * z1074;
    const Scalar z1088 = z1061 - z1066 * z1074;
    const Scalar z1089 = z1062 - z1067 * z1074;
    const Scalar z1090 = n1 / z1089;
    const Scalar z1091 = z1085 * z1090;
    const Scalar z1092 = z1086 * z1090;
    const Scalar z1093 = z1087 * z1090;
    const Scalar z1094 = z1088 * z1090;
    const Scalar z1095 = z1075 - z1085 * z1091;
    const Scalar z1096 = z1076 - z1085 * z1092;
    const Scalar z1097 = z1077 - z1086 * z1092;
    const Scalar z1098 = z1078 - z1085 * z1093;
    const Scalar z1099 = z1079 - z1086 * z1093;
    const Scalar z1100 = z1080 - z1087 * z1093;
    const Scalar z1101 = z1081 - z1085 * z1094;
    const Scalar z1102 = z1082 - z1086 * z1094;
    const Scalar z1103 = z1083 - z1087 * z1094;
    const Scalar z1104 = z1084 - z1088 * z1094;
    const Scalar z1105 = n1 / z1104;
    const Scalar z1106 = z1101 * z1105;
    const Scalar z1107 = z1102 * z1105;
    const Scalar z1108 = z1103 * z1105;
    const Scalar z1109 = z1095 - z1101 * z1106;
    const Scalar z1110 = z1096 - z1101 * z1107;
    const Scalar z1111 = z1097 - z1102 * z1107;
    const Scalar z1112 = z1098 - z1101 * z1108;
    const Scalar z1113 = z1099 - z1102 * z1108;
    const Scalar z1114 = z1100 - z1103 * z1108;
    const Scalar z1115 = n1 / z1114;
    const Scalar z1116 = z1112 * z1115;
    const Scalar z1117 = z1113 * z1115;
    const Scalar z1118 = z1109 - z1112 * z1116;
    const Scalar z1119 = z1110 - z1112 * z1117;
    const Scalar z1120 = z1111 - z1113 * z1117;
    const Scalar z1121 = n1 / z1120;
    const Scalar z1122 = z1119 * z1121;
    const Scalar z1123 = z1118 - z1119 * z1122;
    const Scalar z1124 = n1 / z1123;
    const Scalar z1125 = z1040 + z1041 * z1047;
    const Scalar z1126 = z1039 - z1041 * z1046 + z1074 * z1125;
    const Scalar z1127 = z1038 - z1041 * z1045 + z1073 * z1125 - z1094 * z1126;
    const Scalar z1128 = z1037 + z1041 * z1044 - z1072 * z1125 + z1093 * z1126 + z1108 * z1127;
    const Scalar z1129 = z1036 - z1041 * z1043 + z1071 * z1125 - z1092 * z1126 - z1107 * z1127 + z1117 * z1128;
    const Scalar z1130 = z1035 - z1041 * z1042 + z1070 * z1125 - z1091 * z1126 - z1106 * z1127 + z1116 * z1128 - z1122
        * z1129;
    const Scalar z1131 = z1124 * z1130;
    const Scalar z1132 = z1121 * z1129 - z1122 * z1131;
    const Scalar z1133 = z1115 * z1128 + z1116 * z1131 + z1117 * z1132;
    const Scalar z1134 = z1105 * z1127 - z1106 * z1131 - z1107 * z1132 + z1108 * z1133;
    const Scalar z1135 = z1090 * z1126 - z1091 * z1131 - z1092 * z1132 + z1093 * z1133 - z1094 * z1134;
    const Scalar z1136 = z1069 * z1125 + z1070 * z1131 + z1071 * z1132 - z1072 * z1133 + z1073 * z1134 + z1074 * z1135;
    const Scalar z1137 = k61 * z1041 + z1042 * z1131 + z1043 * z1132 - z1044 * z1133 + z1045 * z1134 + z1046 * z1135
        - z1047 * z1136;
    accelerations.q1 = -z1131;
    accelerations.q2 = -z1132;
    accelerations.q3 = -z1133;
    accelerations.q4 = -z1134;
    accelerations.q5 = -z1135;
    accelerations.q6 = -z1136;
    accelerations.q7 = z1137;
    if (!(traits::regular(-z1123, z669) && traits::regular(-z1120, z651) && traits::regular(-z1114, z625)
        && traits::regular(-z1104, z592) && traits::regular(-z1089, z550) && traits::regular(-z1068, z509)
        && traits::regular(k4, k4))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (accelerations.q1 - accelerations.q1) + (accelerations.q2 - accelerations.q2)
        + (accelerations.q3 - accelerations.q3) + (accelerations.q4 - accelerations.q4) + (accelerations.q5
        - accelerations.q5) + (accelerations.q6 - accelerations.q6) + (accelerations.q7 - accelerations.q7);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar k5 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k6 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k7 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k8 = traits::constant(0.00850351162402155, 0.008503512f, "170070232480431/20000000000000000");
    const Scalar k9 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k10 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k11 = traits::constant(0.028124284712194955, 0.028124284f, "7031071178048739/250000000000000000");
    const Scalar k12 = traits::constant(0.026534991901690206, 0.026534991f, "13267495950845103/500000000000000000");
    const Scalar k13 = traits::constant(0.214708623208, 0.21470863f, "26838577901/125000000000");
    const Scalar k14 = traits::constant(3.228604, 3.228604f, "807151/250000");
    const Scalar k15 = traits::constant(0.126729164208, 0.12672916f, "7920572763/62500000000");
    const Scalar k16 = traits::constant(0.088844724872, 0.088844724f, "11105590609/125000000000");
    const Scalar k17 = traits::constant(0.05649492601407083, 0.056494925f, "3530932875879427/62500000000000000");
    const Scalar k18 = traits::constant(0.008248333140675744, 0.008248333f, "257760410646117/31250000000000000");
    const Scalar k19 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k20 = traits::constant(0.052878381999606115, 0.052878384f, "1652449437487691/31250000000000000");
    const Scalar k21 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k22 = traits::constant(0.01824920229252011, 0.018249203f, "1140575143282507/62500000000000000");
    const Scalar k23 = traits::constant(0.09850206933, 0.09850207f, "9850206933/100000000000");
    const Scalar k24 = traits::constant(3.587895, 3.587895f, "717579/200000");
    const Scalar k25 = traits::constant(0.374644408005, 0.3746444f, "74928881601/200000000000");
    const Scalar k26 = traits::constant(0.19076837715, 0.19076838f, "3815367543/20000000000");
    const Scalar k27 = traits::constant(0.06767727025085991, 0.06767727f, "13535454050171983/200000000000000000");
    const Scalar k28 = traits::constant(0.02771584317362585, 0.027715843f, "554316863472517/20000000000000000");
    const Scalar k29 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k30 = traits::constant(0.03239943042445132, 0.03239943f, "809985760611283/25000000000000000");
    const Scalar k31 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k32 = traits::constant(0.07758614905253959, 0.07758615f, "15517229810507919/200000000000000000");
    const Scalar k33 = traits::constant(0.047121686402, 0.047121685f, "23560843201/500000000000");
    const Scalar k34 = traits::constant(1.225946, 1.225946f, "612973/500000");
    const Scalar k35 = traits::constant(0.05034347249, 0.050343473f, "5034347249/100000000000");
    const Scalar k36 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k37 = traits::constant(0.03942757095803552, 0.03942757f, "9856892739508881/250000000000000000");
    const Scalar k38 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k39 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k40 = traits::constant(0.03146037232526039, 0.03146037f, "7865093081315097/250000000000000000");
    const Scalar k41 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k42 = traits::constant(0.010869510762828565, 0.0108695105f, "2717377690707141/250000000000000000");
    const Scalar k43 = traits::constant(0.017527158935, 0.01752716f, "3505431787/200000000000");
    const Scalar k44 = traits::constant(1.666555, 1.666555f, "333311/200000");
    const Scalar k45 = traits::constant(0.023526756935, 0.023526756f, "4705351387/200000000000");
    const Scalar k46 = traits::constant(0.100241616695, 0.10024162f, "20048323339/200000000000");
    const Scalar k47 = traits::constant(0.00248046035817079, 0.0024804603f, "248046035817079/100000000000000000");
    const Scalar k48 = traits::constant(0.001524110902883315, 0.0015241109f, "304822180576663/200000000000000000");
    const Scalar k49 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k50 = traits::constant(0.01056776613310695, 0.010567766f, "211355322662139/20000000000000000");
    const Scalar k51 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k52 = traits::constant(0.01179456023023895, 0.011794561f, "235891204604779/20000000000000000");
    const Scalar k53 = traits::constant(0.045305948634, 0.04530595f, "22652974317/500000000000");
    const Scalar k54 = traits::constant(0.735522, 0.735522f, "367761/500000");
    const Scalar k55 = traits::constant(0.015320008390949586, 0.015320009f, "7660004195474793/500000000000000000");
    const Scalar k56 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k57 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k58 = traits::constant(0.012899064612428356, 0.012899064f, "3224766153107089/250000000000000000");
    const Scalar k59 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k60 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k61 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k62 = traits::constant(0.01857971472, 0.018579714f, "116123217/6250000000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k64 = traits::constant(0.004606581888605612, 0.0046065818f, "1151645472151403/250000000000000000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k66 = traits::constant(9.8177933583, 9.817793f, "98177933583/10000000000");
    const Scalar k67 = traits::constant(31.67260524, 31.672606f, "791815131/25000000");
    const Scalar k68 = traits::constant(35.19724995, 35.19725f, "703944999/20000000");
    const Scalar k69 = traits::constant(28.37543481, 28.375435f, "2837543481/100000000");
    const Scalar k70 = traits::constant(7.21547082, 7.215471f, "360773541/50000000");
    const Scalar v_q1 = state.v.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar u_tau1 = inputs.tau1;
    const Scalar u_tau2 = inputs.tau2;
    const Scalar u_tau3 = inputs.tau3;
    const Scalar u_tau4 = inputs.tau4;
    const Scalar u_tau5 = inputs.tau5;
    const Scalar u_tau6 = inputs.tau6;
    const Scalar u_tau7 = inputs.tau7;
    Scalar s_q2, c_q2;
    traits::sincos(q_q2, s_q2, c_q2);
    Scalar s_q3, c_q3;
    traits::sincos(q_q3, s_q3, c_q3);
    Scalar s_q4, c_q4;
    traits::sincos(q_q4, s_q4, c_q4);
    Scalar s_q5, c_q5;
    traits::sincos(q_q5, s_q5, c_q5);
    Scalar s_q6, c_q6;
    traits::sincos(q_q6, s_q6, c_q6);
    Scalar s_q7, c_q7;
    traits::sincos(q_q7, s_q7, c_q7);
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z37 = n0_316 * v_q2;
    const Scalar z38 = n0_316 * z35;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z41 = s_q3 * z38 + c_q3 * z37;
    const Scalar z42 = s_q3 * z37 - c_q3 * z38;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z44 = z42 - n0_0825 * z43;
    const Scalar z45 = n0_0825 * z40;
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z48 = s_q4 * z45 - c_q4 * z41;
    const Scalar z49 = s_q4 * z41 + c_q4 * z45;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z51 = z48 + n0_384 * z50;
    const Scalar z52 = z49 + n0_0825 * z50;
    const Scalar z53 = z44 + n0_384 * z46 - n0_0825 * z47;
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z56 = s_q5 * z53 + c_q5 * z51;
    const Scalar z57 = s_q5 * z51 - c_q5 * z53;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z61 = s_q6 * z52 + c_q6 * z56;
    const Scalar z62 = s_q6 * z56 - c_q6 * z52;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z64 = z62 + n0_088 * z63;
    const Scalar z65 = z57 + n0_088 * z60;
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z68 = s_q7 * z65 + c_q7 * z61;
    const Scalar z69 = s_q7 * z61 - c_q7 * z65;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z399 = n0_316 * c_q2;
    const Scalar z402 = n0_333 + z399;
    const Scalar z409 = n0_0825 * c_q3;
    const Scalar z412 = s_q2 * z409 - n0_316 * c_q2;
    const Scalar z415 = n0_333 - z412;
    const Scalar z422 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z423 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z424 = n0_0825 - z422;
    const Scalar z425 = c_q3 * z424;
    const Scalar z427 = n0_316 - z423;
    const Scalar z429 = s_q2 * z425 - c_q2 * z427;
    const Scalar z432 = n0_333 - z429;
    const Scalar z442 = n0_088 * c_q6;
    const Scalar z443 = n0_088 * s_q6;
    const Scalar z444 = c_q5 * z442;
    const Scalar z445 = s_q5 * z442;
    const Scalar z446 = n0_0825 - z444;
    const Scalar z447 = n0_384 + z443;
    const Scalar z448 = s_q4 * z447 + c_q4 * z446;
    const Scalar z449 = s_q4 * z446 - c_q4 * z447;
    const Scalar z450 = n0_0825 - z448;
    const Scalar z451 = s_q3 * z445 - c_q3 * z450;
    const Scalar z453 = n0_316 - z449;
    const Scalar z455 = s_q2 * z451 + c_q2 * z453;
    const Scalar z458 = n0_333 + z455;
    const Scalar z465 = k5 * s_q7 - k6 * c_q7;
    const Scalar z466 = k6 * s_q7 + k5 * c_q7;
    const Scalar z1138 = k7 * v_q2 - k8 * z35 + k9 * z36;
    const Scalar z1139 = k10 * v_q2 + k9 * z35 - k11 * z36;
    const Scalar z1140 = k12 * v_q2 - k7 * z35 - k10 * z36;
    const Scalar z1141 = k13 * z40 - k14 * z41 + k15 * z43;
    const Scalar z1142 = k13 * z39 - k14 * z42 + k16 * z43;
    const Scalar z1143 = k17 * z39 - k18 * z40 - k13 * z42 - k19 * z43;
    const Scalar z1144 = k18 * z39 - k20 * z40 + k13 * z41 + k21 * z43;
    const Scalar z1145 = k19 * z39 + k21 * z40 + k15 * z41 + k16 * z42 - k22 * z43;
    const Scalar z1146 = k23 * z47 + k24 * z48 + k25 * z50;
    const Scalar z1147 = k23 * z46 + k24 * z49 + k26 * z50;
    const Scalar z1148 = k24 * z44 + k25 * z46 - k26 * z47;
    const Scalar z1149 = k25 * z44 + k27 * z46 - k28 * z47 + k23 * z49 + k29 * z50;
    const Scalar z1150 = k26 * z44 + k28 * z46 - k30 * z47 - k23 * z48 - k31 * z50;
    const Scalar z1151 = k29 * z46 + k31 * z47 + k25 * z48 + k26 * z49 + k32 * z50;
    const Scalar z1152 = k33 * z55 - k34 * z56 - k35 * z58;
    const Scalar z1153 = k33 * z54 - k34 * z57 + k36 * z58;
    const Scalar z1154 = k34 * z52 + k35 * z54 + k36 * z55;
    const Scalar z1155 = k35 * z52 + k37 * z54 - k38 * z55 - k33 * z57 + k39 * z58;
    const Scalar z1156 = k36 * z52 - k38 * z54 + k40 * z55 - k33 * z56 - k41 * z58;
    const Scalar z1157 = k39 * z54 - k41 * z55 + k35 * z56 - k36 * z57 + k42 * z58;
    const Scalar z1158 = k43 * z60 + k44 * z61 - k45 * z63;
    const Scalar z1159 = k43 * z59 + k44 * z62 + k46 * z63;
    const Scalar z1160 = k44 * z57 + k45 * z59 + k46 * z60;
    const Scalar z1161 = k45 * z57 + k47 * z59 + k48 * z60 + k43 * z62 - k49 * z63;
    const Scalar z1162 = k46 * z57 + k48 * z59 + k50 * z60 + k43 * z61 + k51 * z63;
    const Scalar z1163 = k49 * z59 - k51 * z60 + k45 * z61 - k46 * z62 - k52 * z63;
    const Scalar z1164 = k53 * z67 + k54 * z68 - k6 * z70;
    const Scalar z1165 = k53 * z66 - k54 * z69 - k5 * z70;
    const Scalar z1166 = k54 * z64 + k6 * z66 - k5 * z67;
    const Scalar z1167 = k6 * z64 + k55 * z66 + k56 * z67 - k53 * z69 - k57 * z70;
    const Scalar z1168 = k5 * z64 - k56 * z66 - k58 * z67 - k53 * z68 - k59 * z70;
    const Scalar z1169 = k57 * z66 - k59 * z67 + k6 * z68 - k5 * z69 - k60 * z70;
    const Scalar z1173 = k61 * s_q2 + k62 * c_q2;
    const Scalar z1176 = k15 * s_q3 - k16 * c_q3;
    const Scalar z1179 = s_q2 * z1176 - k13 * c_q2;
    const Scalar z1182 = k25 * s_q4 + k26 * c_q4;
    const Scalar z1183 = k26 * s_q4 - k25 * c_q4;
    const Scalar z1184 = k23 * s_q3 - c_q3 * z1182;
    const Scalar z1187 = s_q2 * z1184 + c_q2 * z1183;
    const Scalar z1190 = k35 * s_q5 + k36 * c_q5;
    const Scalar z1191 = k36 * s_q5 - k35 * c_q5;
    const Scalar z1192 = k33 * s_q4 - c_q4 * z1190;
    const Scalar z1193 = s_q4 * z1190 + k33 * c_q4;
    const Scalar z1194 = s_q3 * z1191 + c_q3 * z1192;
    const Scalar z1197 = s_q2 * z1194 + c_q2 * z1193;
    const Scalar z1200 = k45 * s_q6 + k46 * c_q6;
    const Scalar z1201 = k46 * s_q6 - k45 * c_q6;
    const Scalar z1202 = k43 * s_q5 - c_q5 * z1200;
    const Scalar z1203 = s_q5 * z1200 + k43 * c_q5;
    const Scalar z1204 = s_q4 * z1201 + c_q4 * z1202;
    const Scalar z1205 = s_q4 * z1202 - c_q4 * z1201;
    const Scalar z1206 = s_q3 * z1203 + c_q3 * z1204;
    const Scalar z1209 = s_q2 * z1206 - c_q2 * z1205;
    const Scalar z1212 = k53 * s_q6 + c_q6 * z466;
    const Scalar z1213 = s_q6 * z466 - k53 * c_q6;
    const Scalar z1214 = s_q5 * z465 + c_q5 * z1212;
    const Scalar z1215 = s_q5 * z1212 - c_q5 * z465;
    const Scalar z1216 = s_q4 * z1213 - c_q4 * z1214;
    const Scalar z1217 = s_q4 * z1214 + c_q4 * z1213;
    const Scalar z1218 = s_q3 * z1215 + c_q3 * z1216;
    const Scalar z1221 = s_q2 * z1218 + c_q2 * z1217;
    result.kinetic = n0_5 * (-z57 * (z1153 - z1160) + v_q2 * z1140 - z35 * z1138 - z36 * z1139 + z39 * z1143 - z40
        * z1144 - z41 * z1141 - z42 * z1142 - z43 * z1145 + z44 * z1148 + z46 * z1149 - z47 * z1150 + z48 * z1146 + z49
        * z1147 + z50 * z1151 + z52 * z1154 + z54 * z1155 + z55 * z1156 - z56 * z1152 + z58 * z1157 + z59 * z1161 + z60
        * z1162 + z61 * z1158 + z62 * z1159 - z63 * z1163 + z64 * z1166 + z66 * z1167 - z67 * z1168 + z68 * z1164 - z69
        * z1165 - z70 * z1169) + k64 * v_q1 * v_q1;
    result.force_function = -n9_81 * (z1173 + z1179 - z1187 - z1197 + z1209 + z1221) - k66 - k67 * z402 - k68 * z415
        - k69 * z432 - k70 * z458;
    result.power = v_q1 * u_tau1 + v_q2 * u_tau2 + v_q3 * u_tau3 + v_q4 * u_tau4 + v_q5 * u_tau5 + v_q6 * u_tau6 + v_q7
        * u_tau7;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar k0 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k1 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k2 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k3 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k4 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar k9 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k10 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n0_176 = traits::constant(0.176, 0.176f, "22/125");
    const Scalar k13 = traits::constant(0.164967552695, 0.16496755f, "32993510539/200000000000");
    const Scalar k14 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k15 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k18 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k19 = traits::constant(0.068832705569, 0.0688327f, "68832705569/1000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k21 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k22 = traits::constant(0.067870631425, 0.06787063f, "2714825257/40000000000");
    const Scalar k23 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k24 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k27 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n0_768 = traits::constant(0.768, 0.768f, "96/125");
    const Scalar n0_165 = traits::constant(0.165, 0.165f, "33/200");
    const Scalar k30 = traits::constant(0.49008027465, 0.49008027f, "9801605493/20000000000");
    const Scalar k31 = traits::constant(1.720683553603, 1.7206836f, "1720683553603/1000000000000");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k36 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k37 = traits::constant(0.684157959872, 0.68415797f, "10689968123/15625000000");
    const Scalar k38 = traits::constant(0.028227094878, 0.028227095f, "14113547439/500000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k41 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar n0_632 = traits::constant(0.632, 0.632f, "79/125");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k47 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k48 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k49 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k50 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k52 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k53 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k54 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k55 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k56 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k57 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k58 = traits::constant(3.104340043512, 3.10434f, "388042505439/125000000000");
    const Scalar k59 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k60 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k62 = traits::constant(2.025402344516817, 2.0254023f, "15823455816537633/7812500000000000");
    const Scalar k63 = traits::constant(0.13605107024338747, 0.13605107f, "8503191890211717/62500000000000000");
    const Scalar k64 = traits::constant(1.173353342191997, 1.1733533f, "586676671095998483/500000000000000000");
    const Scalar k65 = traits::constant(0.0513640063978176, 0.051364005f, "8025625999659/156250000000000");
    const Scalar k66 = traits::constant(0.0295053836801595, 0.029505383f, "14752691840079751/500000000000000000");
    const Scalar k67 = traits::constant(0.007330595745882176, 0.0073305955f, "114540558529409/15625000000000000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_q1 = state.v.q1;
    const Scalar a_q1 = accelerations.q1;
    const Scalar q_q2 = state.q.q2;
    const Scalar v_q2 = state.v.q2;
    const Scalar a_q2 = accelerations.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar v_q3 = state.v.q3;
    const Scalar a_q3 = accelerations.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar v_q4 = state.v.q4;
    const Scalar a_q4 = accelerations.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar v_q5 = state.v.q5;
    const Scalar a_q5 = accelerations.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar v_q6 = state.v.q6;
    const Scalar a_q6 = accelerations.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar v_q7 = state.v.q7;
    const Scalar a_q7 = accelerations.q7;
    const Scalar u_tau1 = inputs.tau1;
    const Scalar u_tau2 = inputs.tau2;
    const Scalar u_tau3 = inputs.tau3;
    const Scalar u_tau4 = inputs.tau4;
    const Scalar u_tau5 = inputs.tau5;
    const Scalar u_tau6 = inputs.tau6;
    const Scalar u_tau7 = inputs.tau7;
    Scalar s_q2, c_q2;
    traits::sincos(q_q2, s_q2, c_q2);
    Scalar s_q3, c_q3;
    traits::sincos(q_q3, s_q3, c_q3);
    Scalar s_q4, c_q4;
    traits::sincos(q_q4, s_q4, c_q4);
    Scalar s_q5, c_q5;
    traits::sincos(q_q5, s_q5, c_q5);
    Scalar s_q6, c_q6;
    traits::sincos(q_q6, s_q6, c_q6);
    Scalar s_q7, c_q7;
    traits::sincos(q_q7, s_q7, c_q7);
    const Scalar z35 = v_q1 * s_q2;
    const Scalar z36 = v_q1 * c_q2;
    const Scalar z39 = v_q2 * s_q3 - c_q3 * z35;
    const Scalar z40 = v_q2 * c_q3 + s_q3 * z35;
    const Scalar z43 = v_q3 + z36;  // angular velocity of link3, z
    const Scalar z46 = s_q4 * z43 + c_q4 * z39;
    const Scalar z47 = s_q4 * z39 - c_q4 * z43;
    const Scalar z50 = v_q4 - z40;  // angular velocity of link4, z
    const Scalar z54 = s_q5 * z50 - c_q5 * z46;
    const Scalar z55 = s_q5 * z46 + c_q5 * z50;
    const Scalar z58 = v_q5 - z47;  // angular velocity of link5, z
    const Scalar z59 = s_q6 * z58 - c_q6 * z54;
    const Scalar z60 = s_q6 * z54 + c_q6 * z58;
    const Scalar z63 = v_q6 + z55;  // angular velocity of link6, z
    const Scalar z66 = s_q7 * z63 + c_q7 * z59;
    const Scalar z67 = s_q7 * z59 - c_q7 * z63;
    const Scalar z70 = v_q7 - z60;  // angular velocity of link7, z
    const Scalar z105 = s_q2 * c_q3;
    const Scalar z109 = s_q2 * s_q3;
    const Scalar z139 = s_q3 * c_q4;
    const Scalar z145 = s_q3 * s_q4;
    const Scalar z184 = s_q4 * c_q5;
    const Scalar z192 = s_q4 * s_q5;
    const Scalar z240 = s_q5 * c_q6;
    const Scalar z250 = s_q5 * s_q6;
    const Scalar z307 = s_q6 * c_q7;
    const Scalar z319 = s_q6 * s_q7;
    const Scalar z465 = k0 * s_q7 - k1 * c_q7;
    const Scalar z466 = k1 * s_q7 + k0 * c_q7;
    const Scalar z467 = k2 * s_q7 - k3 * c_q7;
    const Scalar z468 = k3 * s_q7 + k2 * c_q7;
    const Scalar z469 = c_q6 * z465;
    const Scalar z470 = s_q6 * z465;
    const Scalar z471 = k4 + n0_088 * z466;
    const Scalar z472 = s_q6 * z471 + c_q6 * z467;
    const Scalar z473 = s_q6 * z467 - c_q6 * z471;
    const Scalar z474 = s_q5 * z466 - c_q5 * z469;
    const Scalar z475 = s_q5 * z469 + c_q5 * z466;
    const Scalar z476 = s_q5 * z468 - c_q5 * z472;
    const Scalar z477 = s_q5 * z472 + c_q5 * z468;
    const Scalar z478 = n0_0825 * z470 - n0_384 * z474 - z477;
    const Scalar z479 = s_q4 * z470 + c_q4 * z474;
    const Scalar z480 = s_q4 * z474 - c_q4 * z470;
    const Scalar z481 = n0_384 * z475 - z476;
    const Scalar z482 = z473 + n0_0825 * z475;
    const Scalar z483 = s_q4 * z482 - c_q4 * z481;
    const Scalar z484 = s_q4 * z481 + c_q4 * z482;
    const Scalar z485 = n0_0825 * z475 - z484;
    const Scalar z486 = s_q3 * z475 + c_q3 * z479;
    const Scalar z487 = s_q3 * z479 - c_q3 * z475;
    const Scalar z488 = z478 + n0_0825 * z480;
    const Scalar z489 = s_q3 * z488 - c_q3 * z483;
    const Scalar z490 = s_q3 * z483 + c_q3 * z488;
    const Scalar z491 = n0_316 * z486 - z490;
    const Scalar z494 = n0_316 * z487 - z489;
    const Scalar z496 = s_q2 * z494 - c_q2 * z485;
    const Scalar z497 = k9 * s_q7 - k10 * c_q7;
    const Scalar z498 = s_q7 * z497;
    const Scalar z499 = k9 - z498;
    const Scalar z500 = k11 + c_q7 * z497;
    const Scalar z501 = n0_088 * z465 - z500;
    const Scalar z502 = k4 + n0_176 * z466;
    const Scalar z503 = n0_176 * z466 + z498;
    const Scalar z504 = k13 + z466;
    const Scalar z505 = k14 - z499;
    const Scalar z506 = k15 - z467;
    const Scalar z507 = k16 + z501;
    const Scalar z508 = k17 + z468;
    const Scalar z509 = k18 + z503;
    const Scalar z510 = s_q6 * z504 - k19 * c_q6;
    const Scalar z511 = k19 * s_q6 + c_q6 * z504;
    const Scalar z512 = s_q6 * z508 + c_q6 * z507;
    const Scalar z513 = s_q6 * z507 - c_q6 * z508;
    const Scalar z514 = c_q5 * z510;
    const Scalar z515 = s_q5 * z510;
    const Scalar z516 = s_q5 * z509 - c_q5 * z512;
    const Scalar z517 = s_q5 * z512 + c_q5 * z509;
    const Scalar z518 = n0_0825 * z511 - n0_384 * z514 - z517;
    const Scalar z519 = s_q4 * z511 + c_q4 * z514;
    const Scalar z520 = s_q4 * z514 - c_q4 * z511;
    const Scalar z521 = n0_384 * z515 + z516;
    const Scalar z522 = z513 - n0_0825 * z515;
    const Scalar z523 = s_q4 * z522 + c_q4 * z521;
    const Scalar z524 = s_q4 * z521 - c_q4 * z522;
    const Scalar z525 = n0_0825 * z515 - z524;
    const Scalar z526 = s_q3 * z515 - c_q3 * z519;
    const Scalar z527 = s_q3 * z519 + c_q3 * z515;
    const Scalar z528 = z518 + n0_0825 * z520;
    const Scalar z529 = s_q3 * z528 - c_q3 * z523;
    const Scalar z530 = s_q3 * z523 + c_q3 * z528;
    const Scalar z531 = n0_316 * z526 + z530;
    const Scalar z534 = n0_316 * z527 - z529;
    const Scalar z536 = s_q2 * z534 + c_q2 * z525;
    const Scalar z537 = z502 + z505;
    const Scalar z538 = n2 * z506;
    const Scalar z539 = s_q6 * z537 - c_q6 * z538;
    const Scalar z540 = s_q6 * z539;
    const Scalar z541 = z505 - z540;
    const Scalar z542 = z502 - z540;
    const Scalar z543 = c_q6 * z539 + z506;
    const Scalar z544 = k21 - z511;
    const Scalar z545 = k22 - z465;
    const Scalar z546 = k23 - z541;
    const Scalar z547 = k24 - z512;
    const Scalar z548 = k25 + z543;
    const Scalar z549 = k26 + z513;
    const Scalar z550 = k27 + z542;
    const Scalar z551 = s_q5 * z544 - c_q5 * z545;
    const Scalar z552 = s_q5 * z545 + c_q5 * z544;
    const Scalar z553 = s_q5 * z549 + c_q5 * z548;
    const Scalar z554 = s_q5 * z548 - c_q5 * z549;
    const Scalar z555 = n0_384 * z551 - z554;
    const Scalar z556 = c_q4 * z551;
    const Scalar z557 = s_q4 * z551;
    const Scalar z558 = n0_384 * z552 - z553;
    const Scalar z559 = z550 + n0_0825 * z552;
    const Scalar z560 = s_q4 * z559 - c_q4 * z558;
    const Scalar z561 = s_q4 * z558 + c_q4 * z559;
    const Scalar z562 = n0_0825 * z552 - z561;
    const Scalar z563 = s_q3 * z552 + c_q3 * z556;
    const Scalar z564 = s_q3 * z556 - c_q3 * z552;
    const Scalar z565 = z555 - n0_0825 * z557;
    const Scalar z566 = s_q3 * z565 + c_q3 * z560;
    const Scalar z567 = s_q3 * z560 - c_q3 * z565;
    const Scalar z568 = n0_316 * z563 - z567;
    const Scalar z571 = n0_316 * z564 + z566;
    const Scalar z573 = s_q2 * z571 - c_q2 * z562;
    const Scalar z574 = z509 - z546;
    const Scalar z575 = n2 * z547;
    const Scalar z576 = s_q5 * z574 + c_q5 * z575;
    const Scalar z577 = s_q5 * z576;
    const Scalar z578 = z546 + z577;
    const Scalar z579 = z509 - z577;
    const Scalar z580 = c_q5 * z576 - z547;
    const Scalar z581 = n0_768 * z510 + z578;
    const Scalar z582 = n0_0825 * z510 + n0_384 * z552 - z553;
    const Scalar z583 = n0_0825 * z551 + z580;
    const Scalar z584 = z550 + n0_165 * z552;
    const Scalar z585 = n0_768 * z510 + n0_165 * z552 + z579;
    const Scalar z586 = k30 + z552;
    const Scalar z587 = k31 + z510;
    const Scalar z588 = k32 + z581;
    const Scalar z589 = k33 + z582;
    const Scalar z590 = k34 + z583;
    const Scalar z591 = k35 + z555;
    const Scalar z592 = k36 + z585;
    const Scalar z593 = s_q4 * z586 - c_q4 * z587;
    const Scalar z594 = s_q4 * z587 + c_q4 * z586;
    const Scalar z595 = s_q4 * z591 + c_q4 * z590;
    const Scalar z596 = s_q4 * z590 - c_q4 * z591;
    const Scalar z597 = c_q3 * z593;
    const Scalar z598 = s_q3 * z593;
    const Scalar z599 = z592 - n0_0825 * z594;
    const Scalar z600 = s_q3 * z599 + c_q3 * z595;
    const Scalar z601 = s_q3 * z595 - c_q3 * z599;
    const Scalar z602 = n0_316 * z597 + z601;
    const Scalar z605 = n0_316 * z598 - z600;
    const Scalar z607 = s_q2 * z605 + c_q2 * z596;
    const Scalar z608 = z584 - z588;
    const Scalar z609 = n2 * z589;
    const Scalar z610 = s_q4 * z608 - c_q4 * z609;
    const Scalar z611 = s_q4 * z610;
    const Scalar z612 = z588 + z611;
    const Scalar z613 = z584 - z611;
    const Scalar z614 = c_q4 * z610 + z589;
    const Scalar z615 = n0_0825 * z551 - z595;
    const Scalar z616 = n0_0825 * z593 - z614;
    const Scalar z617 = z592 - n0_165 * z594;
    const Scalar z618 = n0_165 * z594 - z613;
    const Scalar z619 = k37 - z594;
    const Scalar z620 = k38 - z551;
    const Scalar z621 = k39 + z612;
    const Scalar z622 = k40 - z615;
    const Scalar z623 = k41 - z616;
    const Scalar z624 = k42 + z596;
    const Scalar z625 = k43 - z618;
    const Scalar z626 = s_q3 * z619 + c_q3 * z620;
    const Scalar z627 = s_q3 * z620 - c_q3 * z619;
    const Scalar z628 = s_q3 * z624 - c_q3 * z623;
    const Scalar z629 = s_q3 * z623 + c_q3 * z624;
    const Scalar z630 = n0_316 * z626 + z629;
    const Scalar z633 = n0_316 * z627 + z628;
    const Scalar z635 = s_q2 * z633 - c_q2 * z625;
    const Scalar z636 = z617 - z621;
    const Scalar z637 = n2 * z622;
    const Scalar z638 = s_q3 * z636 + c_q3 * z637;
    const Scalar z639 = s_q3 * z638;
    const Scalar z640 = z621 + z639;
    const Scalar z641 = z617 - z639;
    const Scalar z642 = c_q3 * z638 - z622;
    const Scalar z643 = n0_632 * z593 - z640;
    const Scalar z644 = n0_632 * z593 - z641;
    const Scalar z647 = k45 - z643;
    const Scalar z648 = k46 + z633;
    const Scalar z649 = k47 - z642;
    const Scalar z650 = k48 + z630;
    const Scalar z651 = k49 - z644;
    const Scalar z655 = s_q2 * z649 + c_q2 * z650;
    const Scalar z656 = z625 - z647;
    const Scalar z657 = n2 * z648;
    const Scalar z658 = s_q2 * z656 + c_q2 * z657;
    const Scalar z659 = s_q2 * z658;
    const Scalar z661 = z625 - z659;
    const Scalar z669 = k50 + z661;
    const Scalar z677 = n9_81 * s_q2;
    const Scalar z678 = n9_81 * c_q2;
    const Scalar z679 = v_q2 * z36;  // angular acceleration of link2, x
    const Scalar z680 = v_q2 * z35;  // angular acceleration of link2, y
    const Scalar z681 = z35 * z36;
    const Scalar z682 = v_q2 * v_q2;
    const Scalar z683 = z35 * z35;
    const Scalar z684 = z682 + z683;
    const Scalar z689 = z678 - n0_316 * z684;
    const Scalar z695 = z40 * z40;
    const Scalar z696 = z43 * z43;
    const Scalar z697 = z695 + z696;
    const Scalar z698 = z39 * z40;
    const Scalar z700 = z39 * z43;
    const Scalar z711 = z47 * z47;
    const Scalar z712 = z50 * z50;
    const Scalar z713 = z711 + z712;
    const Scalar z714 = z46 * z47;
    const Scalar z717 = z46 * z46;
    const Scalar z718 = z712 + z717;
    const Scalar z719 = z46 * z50;
    const Scalar z721 = z47 * z50;
    const Scalar z738 = z60 * z60;
    const Scalar z739 = z63 * z63;
    const Scalar z740 = z738 + z739;
    const Scalar z741 = z59 * z60;
    const Scalar z743 = z59 * z63;
    const Scalar z754 = z67 * z67;
    const Scalar z755 = z70 * z70;
    const Scalar z756 = z754 + z755;
    const Scalar z757 = z66 * z67;
    const Scalar z760 = z66 * z66;
    const Scalar z761 = z755 + z760;
    const Scalar z762 = z66 * z70;
    const Scalar z764 = z67 * z70;
    const Scalar z766 = z754 - z755;
    const Scalar z767 = z755 - z760;
    const Scalar z770 = z754 - z760;
    const Scalar z782 = z59 * z59;
    const Scalar z783 = z739 + z782;
    const Scalar z784 = z60 * z63;
    const Scalar z786 = z738 - z739;
    const Scalar z787 = z739 - z782;
    const Scalar z790 = z738 - z782;
    const Scalar z801 = z55 * z55;
    const Scalar z802 = z58 * z58;
    const Scalar z803 = z801 + z802;
    const Scalar z804 = z54 * z55;
    const Scalar z807 = z54 * z54;
    const Scalar z808 = z802 + z807;
    const Scalar z809 = z54 * z58;
    const Scalar z811 = z55 * z58;
    const Scalar z813 = z801 - z802;
    const Scalar z814 = z802 - z807;
    const Scalar z817 = z801 - z807;
    const Scalar z828 = z711 - z712;
    const Scalar z829 = z712 - z717;
    const Scalar z832 = z711 - z717;
    const Scalar z844 = z39 * z39;
    const Scalar z845 = z696 + z844;
    const Scalar z846 = z40 * z43;
    const Scalar z848 = z695 - z696;
    const Scalar z849 = z696 - z844;
    const Scalar z852 = z695 - z844;
    const Scalar z863 = z36 * z36;
    const Scalar z866 = z682 - z863;
    const Scalar z867 = z682 - z683;
    const Scalar z868 = z683 - z863;
    const Scalar z884 = a_q1 * s_q2;
    const Scalar z885 = a_q1 * c_q2;
    const Scalar z886 = v_q2 * z36 + z884;  // angular acceleration of link2, x
    const Scalar z887 = v_q2 * z35 - z885;  // angular acceleration of link2, y
    const Scalar z888 = a_q2 - z681;
    const Scalar z889 = z679 + z886;
    const Scalar z890 = a_q2 * s_q3 - c_q3 * z886;
    const Scalar z891 = a_q2 * c_q3 + s_q3 * z886;
    const Scalar z892 = z677 - n0_316 * z888;
    const Scalar z893 = n0_316 * z889;
    const Scalar z894 = s_q3 * z893 - c_q3 * z892;
    const Scalar z895 = s_q3 * z892 + c_q3 * z893;
    const Scalar z896 = v_q3 * z40 + z890;  // angular acceleration of link3, x
    const Scalar z897 = v_q3 * z39 - z891;  // angular acceleration of link3, y
    const Scalar z898 = a_q3 - z887;  // angular acceleration of link3, z
    const Scalar z899 = z698 + z898;
    const Scalar z900 = z700 + z897;
    const Scalar z901 = s_q4 * z898 + c_q4 * z896;
    const Scalar z902 = s_q4 * z896 - c_q4 * z898;
    const Scalar z903 = n0_0825 * z697 - z894;
    const Scalar z904 = z895 + n0_0825 * z899;
    const Scalar z905 = z689 + n0_0825 * z900;
    const Scalar z906 = s_q4 * z905 - c_q4 * z903;
    const Scalar z907 = s_q4 * z903 + c_q4 * z905;
    const Scalar z908 = v_q4 * z47 - z901;  // angular acceleration of link4, x
    const Scalar z909 = v_q4 * z46 + z902;  // angular acceleration of link4, y
    const Scalar z910 = a_q4 + z897;  // angular acceleration of link4, z
    const Scalar z911 = z714 + z910;
    const Scalar z912 = z714 - z910;
    const Scalar z913 = z719 + z909;
    const Scalar z914 = z721 + z908;
    const Scalar z915 = s_q5 * z910 + c_q5 * z908;
    const Scalar z916 = s_q5 * z908 - c_q5 * z910;
    const Scalar z917 = n0_0825 * z713 + z906 - n0_384 * z911;
    const Scalar z918 = n0_384 * z718 - z907 - n0_0825 * z912;
    const Scalar z919 = z904 + n0_0825 * z913 + n0_384 * z914;
    const Scalar z920 = s_q5 * z919 + c_q5 * z917;
    const Scalar z921 = s_q5 * z917 - c_q5 * z919;
    const Scalar z922 = v_q5 * z55 + z915;  // angular acceleration of link5, x
    const Scalar z923 = v_q5 * z54 + z916;  // angular acceleration of link5, y
    const Scalar z924 = a_q5 - z909;  // angular acceleration of link5, z
    const Scalar z925 = s_q6 * z924 - c_q6 * z922;
    const Scalar z926 = s_q6 * z922 + c_q6 * z924;
    const Scalar z927 = s_q6 * z918 - c_q6 * z920;
    const Scalar z928 = s_q6 * z920 + c_q6 * z918;
    const Scalar z929 = v_q6 * z60 + z925;  // angular acceleration of link6, x
    const Scalar z930 = v_q6 * z59 - z926;  // angular acceleration of link6, y
    const Scalar z931 = a_q6 - z923;  // angular acceleration of link6, z
    const Scalar z932 = z741 + z931;
    const Scalar z933 = z743 + z930;
    const Scalar z934 = s_q7 * z931 + c_q7 * z929;
    const Scalar z935 = s_q7 * z929 - c_q7 * z931;
    const Scalar z936 = n0_088 * z740 + z927;
    const Scalar z937 = z928 - n0_088 * z932;
    const Scalar z938 = z921 + n0_088 * z933;
    const Scalar z939 = s_q7 * z938 - c_q7 * z936;
    const Scalar z940 = s_q7 * z936 + c_q7 * z938;
    const Scalar z941 = v_q7 * z67 - z934;  // angular acceleration of link7, x
    const Scalar z942 = v_q7 * z66 + z935;  // angular acceleration of link7, y
    const Scalar z943 = a_q7 + z930;  // angular acceleration of link7, z
    const Scalar z944 = z757 + z943;
    const Scalar z945 = z757 - z943;
    const Scalar z946 = z762 + z942;
    const Scalar z947 = z764 + z941;
    const Scalar z948 = z764 - z941;
    const Scalar z949 = z762 - z942;
    const Scalar z950 = k0 * z756 - k1 * z944;  // force on link7, x
    const Scalar z951 = k1 * z761 - k0 * z945;  // force on link7, y
    const Scalar z952 = k0 * z946 + k1 * z947;  // force on link7, z
    const Scalar z953 = k4 * z764 + k2 * z766 + k1 * z937 + k9 * z941 - k3 * z945 - k11 * z946;  // moment on link7, x
    const Scalar z954 = k52 * z762 + k3 * z767 + k0 * z937 + k2 * z944 - k11 * z947;  // moment on link7, y
    // moment on link7, z
    const Scalar z955 = k9 * z757 + k11 * z770 + k1 * z939 + k0 * z940 + k4 * z943 - k3 * z948 - k2 * z949;
    const Scalar z956 = s_q7 * z951 + c_q7 * z950;
    const Scalar z957 = s_q7 * z950 - c_q7 * z951;
    const Scalar z958 = s_q7 * z954 - c_q7 * z953;
    const Scalar z959 = s_q7 * z953 + c_q7 * z954;
    const Scalar z960 = z741 - z931;
    const Scalar z961 = z784 + z929;
    const Scalar z962 = z784 - z929;
    const Scalar z963 = z743 - z930;
    const Scalar z964 = k13 * z740 + z956 + k19 * z960;  // force on link6, x
    const Scalar z965 = k19 * z783 + k13 * z932 - z952;  // force on link6, y
    const Scalar z966 = k13 * z933 - z957 - k19 * z961;  // force on link6, z
    // moment on link6, x
    const Scalar z967 = k18 * z784 + k17 * z786 - k19 * z921 - k14 * z929 - k16 * z932 - k15 * z933 + z958;
    // moment on link6, y
    const Scalar z968 = k53 * z743 + k16 * z787 + k13 * z921 + z955 - n0_088 * z957 + k17 * z960 - k15 * z961;
    // moment on link6, z
    const Scalar z969 = k14 * z741 - k15 * z790 - k19 * z927 - k13 * z928 + k18 * z931 - n0_088 * z952 - z959 + k16
        * z962 + k17 * z963;
    const Scalar z970 = s_q6 * z965 + c_q6 * z964;
    const Scalar z971 = s_q6 * z964 - c_q6 * z965;
    const Scalar z972 = s_q6 * z968 + c_q6 * z967;
    const Scalar z973 = s_q6 * z967 - c_q6 * z968;
    const Scalar z974 = z804 - z924;
    const Scalar z975 = z804 + z924;
    const Scalar z976 = z809 + z923;
    const Scalar z977 = z811 + z922;
    const Scalar z978 = z811 - z922;
    const Scalar z979 = z809 - z923;
    const Scalar z980 = k21 * z803 - z970 + k22 * z974;  // force on link5, x
    const Scalar z981 = k22 * z808 + z966 + k21 * z975;  // force on link5, y
    const Scalar z982 = z971 - k21 * z976 + k22 * z977;  // force on link5, z
    // moment on link5, x
    const Scalar z983 = k27 * z811 - k26 * z813 + k22 * z918 + k23 * z922 - z972 + k25 * z975 + k24 * z976;
    const Scalar z984 = k54 * z809 - k25 * z814 - k21 * z918 - z969 - k26 * z974 + k24 * z977;  // moment on link5, y
    // moment on link5, z
    const Scalar z985 = k23 * z804 - k24 * z817 + k22 * z920 - k21 * z921 - k27 * z924 - z973 + k25 * z978 + k26 * z979;
    const Scalar z986 = s_q5 * z981 + c_q5 * z980;
    const Scalar z987 = s_q5 * z980 - c_q5 * z981;
    const Scalar z988 = s_q5 * z984 + c_q5 * z983;
    const Scalar z989 = s_q5 * z983 - c_q5 * z984;
    const Scalar z990 = z721 - z908;
    const Scalar z991 = z719 - z909;
    const Scalar z992 = k30 * z713 - k31 * z911 + z986;  // force on link4, x
    const Scalar z993 = k31 * z718 - k30 * z912 + z982;  // force on link4, y
    const Scalar z994 = k30 * z913 + k31 * z914 + z987;  // force on link4, z
    // moment on link4, x
    const Scalar z995 = k36 * z721 + k35 * z828 + k31 * z904 + k32 * z908 + k34 * z912 + k33 * z913 + n0_384 * z987
        + z988;
    // moment on link4, y
    const Scalar z996 = k55 * z719 - k34 * z829 + k30 * z904 + k35 * z911 + k33 * z914 + z985 + n0_0825 * z987;
    // moment on link4, z
    const Scalar z997 = k32 * z714 - k33 * z832 - k31 * z906 - k30 * z907 + k36 * z910 + n0_0825 * z982 - n0_384 * z986
        + z989 + k34 * z990 - k35 * z991;
    const Scalar z998 = s_q4 * z993 + c_q4 * z992;
    const Scalar z999 = s_q4 * z992 - c_q4 * z993;
    const Scalar z1000 = s_q4 * z996 - c_q4 * z995;
    const Scalar z1001 = s_q4 * z995 + c_q4 * z996;
    const Scalar z1002 = z698 - z898;
    const Scalar z1003 = z846 + z896;
    const Scalar z1004 = z846 - z896;
    const Scalar z1005 = z700 - z897;
    const Scalar z1006 = k37 * z697 - z998 - k38 * z1002;  // force on link3, x
    const Scalar z1007 = k38 * z845 - k37 * z899 - z994;  // force on link3, y
    // moment on link3, x
    const Scalar z1009 = k38 * z689 + k43 * z846 - k42 * z848 + k39 * z896 - k41 * z899 + k40 * z900 + z1000;
    // moment on link3, y
    const Scalar z1010 = k37 * z689 + k56 * z700 + k41 * z849 + z997 + n0_0825 * z999 - k42 * z1002 + k40 * z1003;
    // moment on link3, z
    const Scalar z1011 = k39 * z698 - k40 * z852 + k38 * z894 - k37 * z895 - k43 * z898 - n0_0825 * z994 + z1001 - k41
        * z1004 + k42 * z1005;
    const Scalar z1012 = s_q3 * z1007 - c_q3 * z1006;
    const Scalar z1013 = s_q3 * z1006 + c_q3 * z1007;
    const Scalar z1014 = s_q3 * z1010 + c_q3 * z1009;
    const Scalar z1015 = s_q3 * z1009 - c_q3 * z1010;
    const Scalar z1016 = a_q2 + z681;
    const Scalar z1017 = z680 + z887;
    const Scalar z1018 = z679 - z886;
    const Scalar z1019 = z680 - z887;
    // moment on link2, x
    const Scalar z1023 = k49 * z679 + k48 * z866 + k45 * z886 - n0_316 * z1013 - z1014 - k47 * z1016 + k46 * z1017;
    const Scalar z1024 = k57 * z680 + k47 * z867 + k48 * z888 + k46 * z889 + z1011;  // moment on link2, y
    // moment on link2, z
    const Scalar z1025 = k49 * a_q2 - k58 * z677 + k59 * z678 - k45 * z681 - k46 * z868 + n0_316 * z1012 + z1015 + k47
        * z1018 - k48 * z1019;
    const Scalar z1029 = s_q2 * z1023 - c_q2 * z1024;
    const Scalar z1034 = k50 * a_q1 + z1029;  // moment on link1, z
    const Scalar z1042 = k60 * z496;
    const Scalar z1043 = k60 * z491;
    const Scalar z1044 = k60 * z485;
    const Scalar z1045 = k60 * z478;
    const Scalar z1046 = k60 * z473;
    const Scalar z1047 = k60 * z468;
    const Scalar z1048 = z496 * z1042 - z669;
    const Scalar z1049 = z496 * z1043 + z655;
    const Scalar z1050 = z491 * z1043 - z651;
    const Scalar z1051 = z496 * z1044 - z635;
    const Scalar z1052 = z491 * z1044 - z630;
    const Scalar z1053 = z485 * z1044 - z625;
    const Scalar z1054 = z496 * z1045 - z607;
    const Scalar z1055 = z491 * z1045 - z602;
    const Scalar z1056 = z485 * z1045 + z596;
    const Scalar z1057 = z478 * z1045 - z592;
    const Scalar z1058 = z496 * z1046 - z573;
    const Scalar z1059 = z491 * z1046 - z568;
    const Scalar z1060 = z485 * z1046 - z562;
    const Scalar z1061 = z478 * z1046 + z555;
    const Scalar z1062 = z473 * z1046 - z550;
    const Scalar z1063 = z496 * z1047 - z536;
    const Scalar z1064 = z491 * z1047 + z531;
    const Scalar z1065 = z485 * z1047 + z525;
    const Scalar z1066 = z478 * z1047 - z518;
    const Scalar z1067 = z473 * z1047 - z513;
    const Scalar z1068 = z468 * z1047 - z509;
    const Scalar z1069 = n1 / z1068;
    const Scalar z1070 = z1063 * z1069;
    const Scalar z1071 = z1064 * z1069;
    const Scalar z1072 = z1065 * z1069;
    const Scalar z1073 = z1066 * z1069;
    const Scalar z1074 = z1067 * z1069;
    const Scalar z1075 = z1048 - z1063 * z1070;
    const Scalar z1076 = z1049 - z1063 * z1071;
    const Scalar z1077 = z1050 - z1064 * z1071;
    const Scalar z1078 = z1051 - z1063 * z1072;
    const Scalar z1079 = z1052 - z1064 * z1072;
    const Scalar z1080 = z1053 - z1065 * z1072;
    const Scalar z1081 = z1054 - z1063 * z1073;
    const Scalar z1082 = z1055 - z1064 * z1073;
    const Scalar z1083 = z1056 - z1065 * z1073;
    const Scalar z1084 = z1057 - z1066 * z1073;
    const Scalar z1085 = z1058 - z1063 * z1074;
    const Scalar z1086 = z1059 - z1064 * z1074;
    const Scalar z1087 = z1060 - z1065 * z1074;
    const Scalar z1088 = z1061 - z1066 * z1074;
    const Scalar z1089 = z1062 - z1067 * z1074;
    const Scalar z1090 = n1 / z1089;
    const Scalar z1091 = z1085 * z1090;
    const Scalar z1092 = z1086 * z1090;
    const Scalar z1093 = z1087 * z1090;
    const Scalar z1094 = z1088 * z1090;
    const Scalar z1095 = z1075 - z1085 * z1091;
    const Scalar z1096 = z1076 - z1085 * z1092;
    const Scalar z1097 = z1077 - z1086 * z1092;
    const Scalar z1098 = z1078 - z1085 * z1093;
    const Scalar z1099 = z1079 - z1086 * z1093;
    const Scalar z1100 = z1080 - z1087 * z1093;
    const Scalar z1101 = z1081 - z1085 * z1094;
    const Scalar z1102 = z1082 - z1086 * z1094;
    const Scalar z1103 = z1083 - z1087 * z1094;
    const Scalar z1104 = z1084 - z1088 * z1094;
    const Scalar z1105 = n1 / z1104;
    const Scalar z1106 = z1101 * z1105;
    const Scalar z1107 = z1102 * z1105;
    const Scalar z1108 = z1103 * z1105;
    const Scalar z1109 = z1095 - z1101 * z1106;
    const Scalar z1110 = z1096 - z1101 * z1107;
    const Scalar z1111 = z1097 - z1102 * z1107;
    const Scalar z1112 = z1098 - z1101 * z1108;
    const Scalar z1113 = z1099 - z1102 * z1108;
    const Scalar z1114 = z1100 - z1103 * z1108;
    const Scalar z1115 = n1 / z1114;
    const Scalar z1116 = z1112 * z1115;
    const Scalar z1117 = z1113 * z1115;
    const Scalar z1118 = z1109 - z1112 * z1116;
    const Scalar z1119 = z1110 - z1112 * z1117;
    const Scalar z1120 = z1111 - z1113 * z1117;
    const Scalar z1121 = n1 / z1120;
    const Scalar z1122 = z1119 * z1121;
    const Scalar z1123 = z1118 - z1119 * z1122;
    const Scalar z1124 = n1 / z1123;
    const Scalar z1311 = v_q2 * c_q2;
    const Scalar z1312 = s_q2 * z36 + c_q2 * z35;
    const Scalar z1313 = n2 * z40 * z109;
    const Scalar z1314 = n2 * c_q2 * z43;
    const Scalar z1315 = z1313 + z1314;
    const Scalar z1316 = s_q3 * z1311;
    const Scalar z1317 = v_q3 * z105 + z1316;
    const Scalar z1318 = c_q2 * s_q4 - c_q4 * z105;
    const Scalar z1319 = c_q2 * c_q4 + s_q4 * z105;
    const Scalar z1320 = z46 * z1319 - z47 * z1318;
    const Scalar z1321 = z1317 - z1320;
    const Scalar z1322 = n2 * z50 * z109;
    const Scalar z1323 = n2 * z46 * z1318;
    const Scalar z1324 = z1322 - z1323;
    const Scalar z1325 = s_q5 * z109 + c_q5 * z1318;
    const Scalar z1326 = s_q6 * z1325 - c_q6 * z1319;
    const Scalar z1327 = n2 * z60 * z1326;
    const Scalar z1328 = s_q5 * z1318 - c_q5 * z109;
    const Scalar z1329 = n2 * z63 * z1328;
    const Scalar z1330 = z1327 - z1329;
    const Scalar z1331 = s_q6 * z1319 + c_q6 * z1325;
    const Scalar z1332 = v_q2 * s_q2;
    const Scalar z1333 = c_q3 * z1311;
    const Scalar z1334 = v_q3 * z109 - z1333;
    const Scalar z1335 = s_q4 * z1332 - c_q4 * z1334;
    const Scalar z1336 = v_q4 * z1319 - z1335;
    const Scalar z1337 = s_q5 * z1317 + c_q5 * z1336;
    const Scalar z1338 = v_q5 * z1328 - z1337;
    const Scalar z1339 = s_q4 * z1334 + c_q4 * z1332;
    const Scalar z1340 = v_q4 * z1318 + z1339;
    const Scalar z1341 = s_q6 * z1338 - c_q6 * z1340;
    const Scalar z1342 = v_q6 * z1331 - z1341;
    const Scalar z1343 = s_q7 * z1328 + c_q7 * z1331;
    const Scalar z1344 = s_q7 * z1331 - c_q7 * z1328;
    const Scalar z1345 = z66 * z1344 + z67 * z1343;
    const Scalar z1346 = z1342 - z1345;
    const Scalar z1347 = n2 * z70 * z1326;
    const Scalar z1348 = n2 * z66 * z1343;
    const Scalar z1349 = z1347 + z1348;
    const Scalar z1350 = k0 * z1346 + k1 * z1349;
    const Scalar z1351 = n2 * z67 * z1344;
    const Scalar z1352 = z1347 + z1351;
    const Scalar z1353 = z1342 + z1345;
    const Scalar z1354 = k0 * z1352 - k1 * z1353;
    const Scalar z1355 = s_q7 * z1350 + c_q7 * z1354;
    const Scalar z1356 = s_q5 * z1336 - c_q5 * z1317;
    const Scalar z1357 = v_q5 * z1325 + z1356;
    const Scalar z1358 = z59 * z1326 - z60 * z1331;
    const Scalar z1359 = z1357 + z1358;
    const Scalar z1360 = k13 * z1330 - z1355 + k19 * z1359;
    const Scalar z1361 = z1357 - z1358;
    const Scalar z1362 = s_q6 * z1340 + c_q6 * z1338;
    const Scalar z1363 = v_q6 * z1326 + z1362;
    const Scalar z1364 = s_q7 * z1363 + c_q7 * z1357;
    const Scalar z1365 = v_q7 * z1343 - z1364;
    const Scalar z1366 = z66 * z1326 + z70 * z1343;
    const Scalar z1367 = z1365 + z1366;
    const Scalar z1368 = s_q7 * z1357 - c_q7 * z1363;
    const Scalar z1369 = v_q7 * z1344 - z1368;
    const Scalar z1370 = z67 * z1326 + z70 * z1344;
    const Scalar z1371 = z1369 + z1370;
    const Scalar z1372 = k0 * z1367 + k1 * z1371;
    const Scalar z1373 = n2 * z59 * z1331;
    const Scalar z1374 = z1329 + z1373;
    const Scalar z1375 = k13 * z1361 - z1372 + k19 * z1374;
    const Scalar z1376 = s_q6 * z1360 + c_q6 * z1375;
    const Scalar z1377 = z54 * z1319 - z58 * z1325;
    const Scalar z1378 = z1357 - z1377;
    const Scalar z1379 = z55 * z1319 + z58 * z1328;
    const Scalar z1380 = z1338 + z1379;
    const Scalar z1381 = z1376 - k21 * z1378 - k22 * z1380;
    const Scalar z1382 = k30 * z1321 + k31 * z1324 + z1381;
    const Scalar z1383 = n2 * z47 * z1319;
    const Scalar z1384 = z1322 + z1383;
    const Scalar z1385 = z1317 + z1320;
    const Scalar z1386 = z59 * z1328 + z63 * z1331;
    const Scalar z1387 = z1342 + z1386;
    const Scalar z1388 = s_q7 * z1354 - c_q7 * z1350;
    const Scalar z1389 = z60 * z1328 - z63 * z1326;
    const Scalar z1390 = z1363 - z1389;
    const Scalar z1391 = k13 * z1387 - z1388 + k19 * z1390;
    const Scalar z1392 = z54 * z1328 - z55 * z1325;
    const Scalar z1393 = z1340 - z1392;
    const Scalar z1394 = n2 * z58 * z1319;
    const Scalar z1395 = n2 * z54 * z1325;
    const Scalar z1396 = z1394 - z1395;
    const Scalar z1397 = z1391 - k21 * z1393 + k22 * z1396;
    const Scalar z1398 = s_q6 * z1375 - c_q6 * z1360;
    const Scalar z1399 = n2 * z55 * z1328;
    const Scalar z1400 = z1394 + z1399;
    const Scalar z1401 = z1340 + z1392;
    const Scalar z1402 = z1398 - k21 * z1400 - k22 * z1401;
    const Scalar z1403 = s_q5 * z1397 - c_q5 * z1402;
    const Scalar z1404 = k30 * z1384 - k31 * z1385 - z1403;
    const Scalar z1405 = s_q4 * z1382 + c_q4 * z1404;
    const Scalar z1406 = z39 * z109 - z40 * z105;
    const Scalar z1407 = z1332 + z1406;
    const Scalar z1408 = k37 * z1315 + z1405 - k38 * z1407;
    const Scalar z1409 = z1332 - z1406;
    const Scalar z1410 = z46 * z109 - z50 * z1318;
    const Scalar z1411 = z1340 - z1410;
    const Scalar z1412 = z47 * z109 + z50 * z1319;
    const Scalar z1413 = z1336 + z1412;
    const Scalar z1414 = s_q5 * z1402 + c_q5 * z1397;
    const Scalar z1415 = k30 * z1411 - k31 * z1413 - z1414;
    const Scalar z1416 = n2 * z39 * z105;
    const Scalar z1417 = z1314 - z1416;
    const Scalar z1418 = k37 * z1409 - z1415 + k38 * z1417;
    const Scalar z1419 = s_q3 * z1408 + c_q3 * z1418;
    const Scalar z1420 = n2 * s_q2 * z35;
    const Scalar z1421 = n0_316 * z1420;
    const Scalar z1422 = c_q2 * z39 - z43 * z105;
    const Scalar z1423 = z1317 - z1422;
    const Scalar z1424 = z1421 + n0_0825 * z1423;
    const Scalar z1425 = n2 * z1311;
    const Scalar z1426 = n0_316 * z1425;
    const Scalar z1427 = n0_316 * z1312;
    const Scalar z1428 = s_q3 * z1426 - c_q3 * z1427;
    const Scalar z1429 = n0_0825 * z1315 - z1428;
    const Scalar z1430 = s_q4 * z1424 + c_q4 * z1429;
    const Scalar z1431 = s_q4 * z1429 - c_q4 * z1424;
    const Scalar z1432 = n0_0825 * z1321 + n0_384 * z1324 + z1431;
    const Scalar z1433 = n0_0825 * z1384 - n0_384 * z1385 + z1430;
    const Scalar z1434 = s_q3 * z1427 + c_q3 * z1426;
    const Scalar z1435 = n0_0825 * z1409 - z1434;
    const Scalar z1436 = n0_0825 * z1411 - n0_384 * z1413 - z1435;
    const Scalar z1437 = s_q5 * z1433 + c_q5 * z1436;
    const Scalar z1438 = n0_088 * z1387 - z1437;
    const Scalar z1439 = s_q5 * z1436 - c_q5 * z1433;
    const Scalar z1440 = s_q6 * z1432 + c_q6 * z1439;
    const Scalar z1441 = n0_088 * z1330 + z1440;
    const Scalar z1442 = s_q7 * z1438 + c_q7 * z1441;
    const Scalar z1443 = s_q7 * z1441 - c_q7 * z1438;
    const Scalar z1444 = z1369 - z1370;
    const Scalar z1445 = z1365 - z1366;
    const Scalar z1446 = z1348 - z1351;
    const Scalar z1447 = k4 * z1342 + k9 * z1345 + k1 * z1442 - k0 * z1443 + k3 * z1444 + k2 * z1445 - k11 * z1446;
    const Scalar z1448 = z1329 - z1373;
    const Scalar z1449 = k17 * z1359 - k53 * z1386 + n0_088 * z1388 - k15 * z1390 + k13 * z1437 - z1447 - k16 * z1448;
    const Scalar z1450 = s_q6 * z1439 - c_q6 * z1432;
    const Scalar z1451 = n0_088 * z1361 - z1450;
    const Scalar z1452 = z1347 - z1348;
    const Scalar z1453 = k2 * z1353 + k52 * z1366 - k11 * z1371 - k0 * z1451 + k3 * z1452;
    const Scalar z1454 = z1347 - z1351;
    const Scalar z1455 = k3 * z1346 - k11 * z1367 + k9 * z1369 + k4 * z1370 - k1 * z1451 - k2 * z1454;
    const Scalar z1456 = s_q7 * z1453 - c_q7 * z1455;
    const Scalar z1457 = z1327 + z1329;
    const Scalar z1458 = k16 * z1361 - k14 * z1363 + k15 * z1387 - k18 * z1389 - k19 * z1437 - z1456 + k17 * z1457;
    const Scalar z1459 = s_q6 * z1449 + c_q6 * z1458;
    const Scalar z1460 = z1394 - z1399;
    const Scalar z1461 = k23 * z1338 - k24 * z1378 + k27 * z1379 - k25 * z1393 - k22 * z1432 + z1459 + k26 * z1460;
    const Scalar z1462 = s_q7 * z1455 + c_q7 * z1453;
    const Scalar z1463 = z1363 + z1389;
    const Scalar z1464 = z1342 - z1386;
    const Scalar z1465 = z1327 + z1373;
    const Scalar z1466 = k18 * z1357 - k14 * z1358 - n0_088 * z1372 + k19 * z1440 - k13 * z1450 - z1462 + k16 * z1463
        - k17 * z1464 + k15 * z1465;
    const Scalar z1467 = z1394 + z1395;
    const Scalar z1468 = k54 * z1377 + k24 * z1380 - k26 * z1401 + k21 * z1432 - z1466 - k25 * z1467;
    const Scalar z1469 = s_q5 * z1461 - c_q5 * z1468;
    const Scalar z1470 = z1336 - z1412;
    const Scalar z1471 = z1340 + z1410;
    const Scalar z1472 = z1323 + z1383;
    const Scalar z1473 = k36 * z1317 + k32 * z1320 + n0_0825 * z1381 + n0_384 * z1403 - k31 * z1430 + k30 * z1431
        - z1469 - k34 * z1470 - k35 * z1471 - k33 * z1472;
    const Scalar z1474 = s_q4 * z1404 - c_q4 * z1382;
    const Scalar z1475 = c_q2 * z40 + z43 * z109;
    const Scalar z1476 = z1334 + z1475;
    const Scalar z1477 = z1314 + z1416;
    const Scalar z1478 = k42 * z1407 + k37 * z1421 - k56 * z1422 + z1473 + n0_0825 * z1474 - k40 * z1476 - k41 * z1477;
    const Scalar z1479 = s_q6 * z1458 - c_q6 * z1449;
    const Scalar z1480 = z1338 - z1379;
    const Scalar z1481 = z1357 + z1377;
    const Scalar z1482 = z1395 + z1399;
    const Scalar z1483 = k27 * z1340 + k23 * z1392 + k21 * z1437 + k22 * z1439 + z1479 - k25 * z1480 + k26 * z1481 - k24
        * z1482;
    const Scalar z1484 = z1322 + z1323;
    const Scalar z1485 = k35 * z1385 + k55 * z1410 + k33 * z1413 + n0_0825 * z1414 + k30 * z1435 - z1483 - k34 * z1484;
    const Scalar z1486 = s_q5 * z1468 + c_q5 * z1461;
    const Scalar z1487 = z1322 - z1383;
    const Scalar z1488 = k34 * z1321 - k32 * z1336 + k33 * z1411 - k36 * z1412 - n0_384 * z1414 - k31 * z1435 + z1486
        + k35 * z1487;
    const Scalar z1489 = s_q4 * z1485 + c_q4 * z1488;
    const Scalar z1490 = z1313 - z1314;
    const Scalar z1491 = k39 * z1334 + k41 * z1409 - k38 * z1421 - k40 * z1423 + k43 * z1475 - z1489 - k42 * z1490;
    const Scalar z1492 = s_q3 * z1478 - c_q3 * z1491;
    const Scalar z1493 = n2 * z1332;
    const Scalar z1494 = n2 * c_q2 * z36;
    const Scalar z1495 = k62 * z1311 - k47 * z1312 - n0_316 * z1419 + z1492 + k46 * z1493 - k48 * z1494;
    const Scalar z1496 = s_q4 * z1488 - c_q4 * z1485;
    const Scalar z1497 = z1334 - z1475;
    const Scalar z1498 = z1317 + z1422;
    const Scalar z1499 = z1313 + z1416;
    const Scalar z1500 = k43 * z1332 + k39 * z1406 - n0_0825 * z1415 + k38 * z1428 - k37 * z1434 + z1496 + k41 * z1497
        + k42 * z1498 - k40 * z1499;
    const Scalar z1501 = k48 * z1312 - k57 * z1332 + k47 * z1420 - k46 * z1425 - z1500;
    const Scalar z1502 = s_q2 * z1495 + c_q2 * z1501;
    const Scalar z1503 = s_q3 * z1418 - c_q3 * z1408;
    const Scalar z1504 = s_q3 * z1491 + c_q3 * z1478;
    const Scalar z1505 = z1420 - z1494;
    const Scalar z1506 = k45 * z1312 - n0_316 * z1503 - z1504 + k46 * z1505;
    const Scalar z1507 = n2 * c_q3 * z40;
    const Scalar z1508 = s_q3 * z36;
    const Scalar z1509 = v_q3 * s_q3 - z1508;
    const Scalar z1510 = z46 * z145 + z47 * z139;
    const Scalar z1511 = z1509 - z1510;
    const Scalar z1512 = n2 * c_q3 * z50;
    const Scalar z1513 = n2 * z46 * z139;
    const Scalar z1514 = z1512 - z1513;
    const Scalar z1515 = c_q3 * s_q5 + c_q5 * z139;
    const Scalar z1516 = s_q6 * z1515 + c_q6 * z145;
    const Scalar z1517 = n2 * z60 * z1516;
    const Scalar z1518 = c_q3 * c_q5 - s_q5 * z139;
    const Scalar z1519 = n2 * z63 * z1518;
    const Scalar z1520 = z1517 + z1519;
    const Scalar z1521 = s_q6 * z145 - c_q6 * z1515;
    const Scalar z1522 = c_q3 * z36;
    const Scalar z1523 = v_q3 * c_q3 - z1522;
    const Scalar z1524 = s_q4 * z35 - c_q4 * z1523;
    const Scalar z1525 = v_q4 * z145 + z1524;
    const Scalar z1526 = s_q5 * z1509 + c_q5 * z1525;
    const Scalar z1527 = v_q5 * z1518 - z1526;
    const Scalar z1528 = s_q4 * z1523 + c_q4 * z35;
    const Scalar z1529 = v_q4 * z139 + z1528;
    const Scalar z1530 = s_q6 * z1527 + c_q6 * z1529;
    const Scalar z1531 = v_q6 * z1521 - z1530;
    const Scalar z1532 = s_q7 * z1518 + c_q7 * z1521;
    const Scalar z1533 = s_q7 * z1521 - c_q7 * z1518;
    const Scalar z1534 = z66 * z1533 + z67 * z1532;
    const Scalar z1535 = z1531 - z1534;
    const Scalar z1536 = n2 * z70 * z1516;
    const Scalar z1537 = n2 * z66 * z1532;
    const Scalar z1538 = z1536 - z1537;
    const Scalar z1539 = k0 * z1535 - k1 * z1538;
    const Scalar z1540 = n2 * z67 * z1533;
    const Scalar z1541 = z1536 - z1540;
    const Scalar z1542 = z1531 + z1534;
    const Scalar z1543 = k0 * z1541 + k1 * z1542;
    const Scalar z1544 = s_q7 * z1539 - c_q7 * z1543;
    const Scalar z1545 = s_q5 * z1525 - c_q5 * z1509;
    const Scalar z1546 = v_q5 * z1515 - z1545;
    const Scalar z1547 = z59 * z1516 + z60 * z1521;
    const Scalar z1548 = z1546 + z1547;
    const Scalar z1549 = k13 * z1520 + z1544 + k19 * z1548;
    const Scalar z1550 = z1546 - z1547;
    const Scalar z1551 = s_q6 * z1529 - c_q6 * z1527;
    const Scalar z1552 = v_q6 * z1516 + z1551;
    const Scalar z1553 = s_q7 * z1552 + c_q7 * z1546;
    const Scalar z1554 = v_q7 * z1532 + z1553;
    const Scalar z1555 = z66 * z1516 - z70 * z1532;
    const Scalar z1556 = z1554 - z1555;
    const Scalar z1557 = s_q7 * z1546 - c_q7 * z1552;
    const Scalar z1558 = v_q7 * z1533 + z1557;
    const Scalar z1559 = z67 * z1516 - z70 * z1533;
    const Scalar z1560 = z1558 - z1559;
    const Scalar z1561 = k0 * z1556 + k1 * z1560;
    const Scalar z1562 = n2 * z59 * z1521;
    const Scalar z1563 = z1519 + z1562;
    const Scalar z1564 = k13 * z1550 + z1561 - k19 * z1563;
    const Scalar z1565 = s_q6 * z1549 + c_q6 * z1564;
    const Scalar z1566 = z54 * z145 + z58 * z1515;
    const Scalar z1567 = z1546 + z1566;
    const Scalar z1568 = z55 * z145 + z58 * z1518;
    const Scalar z1569 = z1527 + z1568;
    const Scalar z1570 = z1565 - k21 * z1567 + k22 * z1569;
    const Scalar z1571 = k30 * z1511 - k31 * z1514 - z1570;
    const Scalar z1572 = n2 * z47 * z145;
    const Scalar z1573 = z1512 - z1572;
    const Scalar z1574 = z1509 + z1510;
    const Scalar z1575 = z59 * z1518 + z63 * z1521;
    const Scalar z1576 = z1531 + z1575;
    const Scalar z1577 = s_q7 * z1543 + c_q7 * z1539;
    const Scalar z1578 = z60 * z1518 + z63 * z1516;
    const Scalar z1579 = z1552 + z1578;
    const Scalar z1580 = k13 * z1576 + z1577 - k19 * z1579;
    const Scalar z1581 = z54 * z1518 + z55 * z1515;
    const Scalar z1582 = z1529 + z1581;
    const Scalar z1583 = n2 * z58 * z145;
    const Scalar z1584 = n2 * z54 * z1515;
    const Scalar z1585 = z1583 + z1584;
    const Scalar z1586 = z1580 + k21 * z1582 + k22 * z1585;
    const Scalar z1587 = s_q6 * z1564 - c_q6 * z1549;
    const Scalar z1588 = n2 * z55 * z1518;
    const Scalar z1589 = z1583 + z1588;
    const Scalar z1590 = z1529 - z1581;
    const Scalar z1591 = z1587 + k21 * z1589 - k22 * z1590;
    const Scalar z1592 = s_q5 * z1586 + c_q5 * z1591;
    const Scalar z1593 = k30 * z1573 + k31 * z1574 + z1592;
    const Scalar z1594 = s_q4 * z1571 - c_q4 * z1593;
    const Scalar z1595 = s_q3 * z40 + c_q3 * z39;
    const Scalar z1596 = z35 + z1595;
    const Scalar z1597 = k37 * z1507 - z1594 - k38 * z1596;
    const Scalar z1598 = z35 - z1595;
    const Scalar z1599 = c_q3 * z46 - z50 * z139;
    const Scalar z1600 = z1529 - z1599;
    const Scalar z1601 = c_q3 * z47 - z50 * z145;
    const Scalar z1602 = z1525 - z1601;
    const Scalar z1603 = s_q5 * z1591 - c_q5 * z1586;
    const Scalar z1604 = k30 * z1600 + k31 * z1602 - z1603;
    const Scalar z1605 = n2 * s_q3 * z39;
    const Scalar z1606 = k37 * z1598 - z1604 + k38 * z1605;
    const Scalar z1607 = s_q3 * z1597 + c_q3 * z1606;
    const Scalar z1608 = n2 * v_q2;
    const Scalar z1609 = n0_316 * z1608;
    const Scalar z1610 = s_q3 * z43;
    const Scalar z1611 = z1509 + z1610;
    const Scalar z1612 = z1609 - n0_0825 * z1611;
    const Scalar z1613 = n2 * z36;
    const Scalar z1614 = n0_316 * z1613;
    const Scalar z1615 = s_q3 * z1614;
    const Scalar z1616 = n0_0825 * z1507 - z1615;
    const Scalar z1617 = s_q4 * z1612 + c_q4 * z1616;
    const Scalar z1618 = s_q4 * z1616 - c_q4 * z1612;
    const Scalar z1619 = n0_0825 * z1511 - n0_384 * z1514 - z1618;
    const Scalar z1620 = n0_0825 * z1573 + n0_384 * z1574 + z1617;
    const Scalar z1621 = c_q3 * z1614;
    const Scalar z1622 = n0_0825 * z1598 - z1621;
    const Scalar z1623 = n0_0825 * z1600 + n0_384 * z1602 - z1622;
    const Scalar z1624 = s_q5 * z1620 + c_q5 * z1623;
    const Scalar z1625 = n0_088 * z1576 + z1624;
    const Scalar z1626 = s_q5 * z1623 - c_q5 * z1620;
    const Scalar z1627 = s_q6 * z1619 - c_q6 * z1626;
    const Scalar z1628 = n0_088 * z1520 - z1627;
    const Scalar z1629 = s_q7 * z1625 - c_q7 * z1628;
    const Scalar z1630 = s_q7 * z1628 + c_q7 * z1625;
    const Scalar z1631 = z1558 + z1559;
    const Scalar z1632 = z1554 + z1555;
    const Scalar z1633 = z1537 - z1540;
    const Scalar z1634 = k4 * z1531 + k9 * z1534 + k1 * z1629 + k0 * z1630 + k3 * z1631 + k2 * z1632 - k11 * z1633;
    const Scalar z1635 = z1519 - z1562;
    const Scalar z1636 = k17 * z1548 + k53 * z1575 + n0_088 * z1577 - k15 * z1579 + k13 * z1624 + z1634 + k16 * z1635;
    const Scalar z1637 = s_q6 * z1626 + c_q6 * z1619;
    const Scalar z1638 = n0_088 * z1550 - z1637;
    const Scalar z1639 = z1536 + z1537;
    const Scalar z1640 = k2 * z1542 - k52 * z1555 - k11 * z1560 + k0 * z1638 - k3 * z1639;
    const Scalar z1641 = z1536 + z1540;
    const Scalar z1642 = k3 * z1535 - k11 * z1556 + k9 * z1558 - k4 * z1559 + k1 * z1638 + k2 * z1641;
    const Scalar z1643 = s_q7 * z1640 - c_q7 * z1642;
    const Scalar z1644 = z1517 - z1519;
    const Scalar z1645 = k16 * z1550 - k14 * z1552 - k15 * z1576 + k18 * z1578 - k19 * z1624 + z1643 + k17 * z1644;
    const Scalar z1646 = s_q6 * z1636 + c_q6 * z1645;
    const Scalar z1647 = z1583 - z1588;
    const Scalar z1648 = k23 * z1527 + k24 * z1567 + k27 * z1568 + k25 * z1582 - k22 * z1619 - z1646 + k26 * z1647;
    const Scalar z1649 = s_q7 * z1642 + c_q7 * z1640;
    const Scalar z1650 = z1552 - z1578;
    const Scalar z1651 = z1531 - z1575;
    const Scalar z1652 = z1517 - z1562;
    const Scalar z1653 = k18 * z1546 - k14 * z1547 + n0_088 * z1561 - k19 * z1627 - k13 * z1637 + z1649 + k16 * z1650
        + k17 * z1651 + k15 * z1652;
    const Scalar z1654 = z1583 - z1584;
    const Scalar z1655 = k54 * z1566 + k24 * z1569 + k26 * z1590 + k21 * z1619 + z1653 - k25 * z1654;
    const Scalar z1656 = s_q5 * z1648 - c_q5 * z1655;
    const Scalar z1657 = z1525 + z1601;
    const Scalar z1658 = z1529 + z1599;
    const Scalar z1659 = z1513 - z1572;
    const Scalar z1660 = k36 * z1509 + k32 * z1510 - n0_0825 * z1570 + n0_384 * z1592 + k31 * z1617 - k30 * z1618
        - z1656 - k34 * z1657 + k35 * z1658 + k33 * z1659;
    const Scalar z1661 = s_q4 * z1593 + c_q4 * z1571;
    const Scalar z1662 = c_q3 * z43;
    const Scalar z1663 = z1523 + z1662;
    const Scalar z1664 = k42 * z1596 + k41 * z1605 + k37 * z1609 - k56 * z1610 - z1660 + n0_0825 * z1661 - k40 * z1663;
    const Scalar z1665 = s_q6 * z1645 - c_q6 * z1636;
    const Scalar z1666 = z1527 - z1568;
    const Scalar z1667 = z1546 - z1566;
    const Scalar z1668 = z1584 - z1588;
    const Scalar z1669 = k27 * z1529 - k23 * z1581 + k21 * z1624 + k22 * z1626 + z1665 + k25 * z1666 + k26 * z1667 - k24
        * z1668;
    const Scalar z1670 = z1512 + z1513;
    const Scalar z1671 = k35 * z1574 - k55 * z1599 + k33 * z1602 - n0_0825 * z1603 - k30 * z1622 + z1669 + k34 * z1670;
    const Scalar z1672 = s_q5 * z1655 + c_q5 * z1648;
    const Scalar z1673 = z1512 + z1572;
    const Scalar z1674 = k34 * z1511 - k32 * z1525 - k33 * z1600 + k36 * z1601 + n0_384 * z1603 + k31 * z1622 + z1672
        - k35 * z1673;
    const Scalar z1675 = s_q4 * z1671 + c_q4 * z1674;
    const Scalar z1676 = k42 * z1507 - k39 * z1523 - k41 * z1598 + k38 * z1609 - k40 * z1611 - k43 * z1662 - z1675;
    const Scalar z1677 = s_q3 * z1664 + c_q3 * z1676;
    const Scalar z1678 = n2 * z35;
    const Scalar z1679 = k62 * z36 - n0_316 * z1607 + k48 * z1608 + z1677 + k46 * z1678;
    const Scalar z1680 = s_q4 * z1674 - c_q4 * z1671;
    const Scalar z1681 = z1523 - z1662;
    const Scalar z1682 = z1509 - z1610;
    const Scalar z1683 = z1507 - z1605;
    const Scalar z1684 = k43 * z35 + k39 * z1595 - n0_0825 * z1604 + k38 * z1615 - k37 * z1621 - z1680 + k41 * z1681
        - k42 * z1682 - k40 * z1683;
    const Scalar z1685 = k57 * z35 + k47 * z1608 + k46 * z1613 + z1684;
    const Scalar z1686 = s_q2 * z1679 - c_q2 * z1685;
    const Scalar z1687 = n2 * z35 * z36;
    const Scalar z1688 = n2 * z40 * z1508;
    const Scalar z1689 = n2 * z35 * z43;
    const Scalar z1690 = z1688 - z1689;
    const Scalar z1691 = n2 * z50 * z1508;
    const Scalar z1692 = s_q4 * z35 + c_q4 * z1522;
    const Scalar z1693 = n2 * z46 * z1692;
    const Scalar z1694 = z1691 + z1693;
    const Scalar z1695 = s_q4 * z1522 - c_q4 * z35;
    const Scalar z1696 = z46 * z1695 + z47 * z1692;
    const Scalar z1697 = s_q3 * z887;
    const Scalar z1698 = v_q3 * z1522 - z1697;
    const Scalar z1699 = z1696 - z1698;
    const Scalar z1700 = s_q5 * z1508 - c_q5 * z1692;
    const Scalar z1701 = s_q6 * z1700 - c_q6 * z1695;
    const Scalar z1702 = n2 * z60 * z1701;
    const Scalar z1703 = s_q5 * z1692 + c_q5 * z1508;
    const Scalar z1704 = n2 * z63 * z1703;
    const Scalar z1705 = z1702 + z1704;
    const Scalar z1706 = n2 * z70 * z1701;
    const Scalar z1707 = s_q6 * z1695 + c_q6 * z1700;
    const Scalar z1708 = s_q7 * z1703 - c_q7 * z1707;
    const Scalar z1709 = n2 * z66 * z1708;
    const Scalar z1710 = z1706 - z1709;
    const Scalar z1711 = s_q7 * z1707 + c_q7 * z1703;
    const Scalar z1712 = z66 * z1711 - z67 * z1708;
    const Scalar z1713 = c_q3 * z887;
    const Scalar z1714 = v_q3 * z1508 + z1713;
    const Scalar z1715 = s_q4 * z886 - c_q4 * z1714;
    const Scalar z1716 = v_q4 * z1695 - z1715;
    const Scalar z1717 = s_q5 * z1698 + c_q5 * z1716;
    const Scalar z1718 = v_q5 * z1703 + z1717;
    const Scalar z1719 = s_q4 * z1714 + c_q4 * z886;
    const Scalar z1720 = v_q4 * z1692 - z1719;
    const Scalar z1721 = s_q6 * z1718 - c_q6 * z1720;
    const Scalar z1722 = v_q6 * z1707 + z1721;
    const Scalar z1723 = z1712 - z1722;
    const Scalar z1724 = k1 * z1710 - k0 * z1723;
    const Scalar z1725 = n2 * z67 * z1711;
    const Scalar z1726 = z1706 + z1725;
    const Scalar z1727 = z1712 + z1722;
    const Scalar z1728 = k0 * z1726 - k1 * z1727;
    const Scalar z1729 = s_q7 * z1724 + c_q7 * z1728;
    const Scalar z1730 = z59 * z1701 - z60 * z1707;
    const Scalar z1731 = s_q5 * z1716 - c_q5 * z1698;
    const Scalar z1732 = v_q5 * z1700 + z1731;
    const Scalar z1733 = z1730 + z1732;
    const Scalar z1734 = k13 * z1705 - z1729 + k19 * z1733;
    const Scalar z1735 = n2 * z59 * z1707;
    const Scalar z1736 = z1704 - z1735;
    const Scalar z1737 = z1730 - z1732;
    const Scalar z1738 = z66 * z1701 - z70 * z1708;
    const Scalar z1739 = s_q6 * z1720 + c_q6 * z1718;
    const Scalar z1740 = v_q6 * z1701 - z1739;
    const Scalar z1741 = s_q7 * z1740 + c_q7 * z1732;
    const Scalar z1742 = v_q7 * z1708 + z1741;
    const Scalar z1743 = z1738 - z1742;
    const Scalar z1744 = z67 * z1701 + z70 * z1711;
    const Scalar z1745 = s_q7 * z1732 - c_q7 * z1740;
    const Scalar z1746 = v_q7 * z1711 - z1745;
    const Scalar z1747 = z1744 + z1746;
    const Scalar z1748 = k0 * z1743 + k1 * z1747;
    const Scalar z1749 = k19 * z1736 + k13 * z1737 + z1748;
    const Scalar z1750 = s_q6 * z1734 - c_q6 * z1749;
    const Scalar z1751 = z54 * z1695 - z58 * z1700;
    const Scalar z1752 = z1732 - z1751;
    const Scalar z1753 = z55 * z1695 - z58 * z1703;
    const Scalar z1754 = z1718 - z1753;
    const Scalar z1755 = z1750 - k21 * z1752 + k22 * z1754;
    const Scalar z1756 = k31 * z1694 - k30 * z1699 + z1755;
    const Scalar z1757 = n2 * z47 * z1695;
    const Scalar z1758 = z1691 + z1757;
    const Scalar z1759 = z1696 + z1698;
    const Scalar z1760 = n2 * z58 * z1695;
    const Scalar z1761 = n2 * z54 * z1700;
    const Scalar z1762 = z1760 - z1761;
    const Scalar z1763 = z59 * z1703 - z63 * z1707;
    const Scalar z1764 = z1722 - z1763;
    const Scalar z1765 = s_q7 * z1728 - c_q7 * z1724;
    const Scalar z1766 = z60 * z1703 + z63 * z1701;
    const Scalar z1767 = z1740 + z1766;
    const Scalar z1768 = k13 * z1764 - z1765 + k19 * z1767;
    const Scalar z1769 = z54 * z1703 + z55 * z1700;
    const Scalar z1770 = z1720 - z1769;
    const Scalar z1771 = k22 * z1762 + z1768 + k21 * z1770;
    const Scalar z1772 = n2 * z55 * z1703;
    const Scalar z1773 = z1760 - z1772;
    const Scalar z1774 = s_q6 * z1749 + c_q6 * z1734;
    const Scalar z1775 = z1720 + z1769;
    const Scalar z1776 = k21 * z1773 + z1774 - k22 * z1775;
    const Scalar z1777 = s_q5 * z1771 + c_q5 * z1776;
    const Scalar z1778 = k30 * z1758 - k31 * z1759 - z1777;
    const Scalar z1779 = s_q4 * z1756 + c_q4 * z1778;
    const Scalar z1780 = z39 * z1508 - z40 * z1522;
    const Scalar z1781 = z886 + z1780;
    const Scalar z1782 = k37 * z1690 + z1779 - k38 * z1781;
    const Scalar z1783 = n2 * z39 * z1522;
    const Scalar z1784 = z1689 + z1783;
    const Scalar z1785 = z886 - z1780;
    const Scalar z1786 = z46 * z1508 + z50 * z1692;
    const Scalar z1787 = z1720 + z1786;
    const Scalar z1788 = z47 * z1508 + z50 * z1695;
    const Scalar z1789 = z1716 + z1788;
    const Scalar z1790 = s_q5 * z1776 - c_q5 * z1771;
    const Scalar z1791 = k30 * z1787 + k31 * z1789 - z1790;
    const Scalar z1792 = k38 * z1784 - k37 * z1785 - z1791;
    const Scalar z1793 = s_q3 * z1782 - c_q3 * z1792;
    const Scalar z1794 = z677 + n0_316 * z1687;
    const Scalar z1795 = z35 * z39 + z43 * z1522;
    const Scalar z1796 = z1689 - z1783;
    const Scalar z1797 = z1693 - z1757;
    const Scalar z1798 = z1698 + z1795;
    const Scalar z1799 = z1794 + n0_0825 * z1798;
    const Scalar z1800 = n0_316 * z1017;
    const Scalar z1801 = z35 * z35 - z36 * z36;
    const Scalar z1802 = z678 - n0_316 * z1801;
    const Scalar z1803 = s_q3 * z1800 + c_q3 * z1802;
    const Scalar z1804 = n0_0825 * z1690 + z1803;
    const Scalar z1805 = s_q4 * z1799 + c_q4 * z1804;
    const Scalar z1806 = s_q4 * z1804 - c_q4 * z1799;
    const Scalar z1807 = z1760 + z1772;
    const Scalar z1808 = n0_384 * z1694 - n0_0825 * z1699 + z1806;
    const Scalar z1809 = z1704 + z1735;
    const Scalar z1810 = n0_0825 * z1758 - n0_384 * z1759 + z1805;
    const Scalar z1811 = s_q3 * z1802 - c_q3 * z1800;
    const Scalar z1812 = n0_0825 * z1785 - z1811;
    const Scalar z1813 = n0_0825 * z1787 + n0_384 * z1789 + z1812;
    const Scalar z1814 = s_q5 * z1810 - c_q5 * z1813;
    const Scalar z1815 = z1709 + z1725;
    const Scalar z1816 = n0_088 * z1764 - z1814;
    const Scalar z1817 = s_q5 * z1813 + c_q5 * z1810;
    const Scalar z1818 = s_q6 * z1808 - c_q6 * z1817;
    const Scalar z1819 = n0_088 * z1705 + z1818;
    const Scalar z1820 = s_q7 * z1816 + c_q7 * z1819;
    const Scalar z1821 = s_q7 * z1819 - c_q7 * z1816;
    const Scalar z1822 = z1744 - z1746;
    const Scalar z1823 = z1738 + z1742;
    const Scalar z1824 = k9 * z1712 + k4 * z1722 + k11 * z1815 + k1 * z1820 - k0 * z1821 - k3 * z1822 - k2 * z1823;
    const Scalar z1825 = k17 * z1733 + k53 * z1763 + n0_088 * z1765 - k15 * z1767 + k16 * z1809 + k13 * z1814 - z1824;
    const Scalar z1826 = z1702 - z1704;
    const Scalar z1827 = z1706 + z1709;
    const Scalar z1828 = s_q6 * z1817 + c_q6 * z1808;
    const Scalar z1829 = n0_088 * z1737 - z1828;
    const Scalar z1830 = k2 * z1727 + k52 * z1738 - k11 * z1747 + k3 * z1827 + k0 * z1829;
    const Scalar z1831 = z1706 - z1725;
    const Scalar z1832 = k3 * z1723 + k11 * z1743 - k4 * z1744 - k9 * z1746 - k1 * z1829 + k2 * z1831;
    const Scalar z1833 = s_q7 * z1830 + c_q7 * z1832;
    const Scalar z1834 = k16 * z1737 + k14 * z1740 - k15 * z1764 - k18 * z1766 + k19 * z1814 - k17 * z1826 + z1833;
    const Scalar z1835 = s_q6 * z1825 - c_q6 * z1834;
    const Scalar z1836 = k23 * z1718 + k24 * z1752 - k27 * z1753 - k25 * z1770 - k26 * z1807 + k22 * z1808 - z1835;
    const Scalar z1837 = z1760 + z1761;
    const Scalar z1838 = z1702 + z1735;
    const Scalar z1839 = s_q7 * z1832 - c_q7 * z1830;
    const Scalar z1840 = z1740 - z1766;
    const Scalar z1841 = z1722 + z1763;
    const Scalar z1842 = k14 * z1730 - k18 * z1732 + n0_088 * z1748 - k19 * z1818 - k13 * z1828 - k15 * z1838 - z1839
        - k16 * z1840 + k17 * z1841;
    const Scalar z1843 = k54 * z1751 - k24 * z1754 + k26 * z1775 + k21 * z1808 - k25 * z1837 + z1842;
    const Scalar z1844 = s_q5 * z1836 + c_q5 * z1843;
    const Scalar z1845 = z1716 - z1788;
    const Scalar z1846 = z1720 - z1786;
    const Scalar z1847 = k32 * z1696 + k36 * z1698 + n0_0825 * z1755 + n0_384 * z1777 + k33 * z1797 - k31 * z1805 + k30
        * z1806 + z1844 - k34 * z1845 + k35 * z1846;
    const Scalar z1848 = s_q4 * z1778 - c_q4 * z1756;
    const Scalar z1849 = z35 * z40 - z43 * z1508;
    const Scalar z1850 = z1714 - z1849;
    const Scalar z1851 = k42 * z1781 + k37 * z1794 + k56 * z1795 + k41 * z1796 + z1847 + n0_0825 * z1848 - k40 * z1850;
    const Scalar z1852 = z1688 + z1689;
    const Scalar z1853 = z1691 - z1693;
    const Scalar z1854 = z1761 - z1772;
    const Scalar z1855 = s_q6 * z1834 + c_q6 * z1825;
    const Scalar z1856 = z1718 + z1753;
    const Scalar z1857 = z1732 + z1751;
    const Scalar z1858 = k27 * z1720 + k23 * z1769 - k21 * z1814 + k22 * z1817 + k24 * z1854 + z1855 - k25 * z1856 - k26
        * z1857;
    const Scalar z1859 = k35 * z1759 + k55 * z1786 + k33 * z1789 - n0_0825 * z1790 + k30 * z1812 - k34 * z1853 + z1858;
    const Scalar z1860 = z1691 - z1757;
    const Scalar z1861 = s_q5 * z1843 - c_q5 * z1836;
    const Scalar z1862 = k34 * z1699 + k32 * z1716 + k33 * z1787 + k36 * z1788 - n0_384 * z1790 + k31 * z1812 - k35
        * z1860 - z1861;
    const Scalar z1863 = s_q4 * z1859 - c_q4 * z1862;
    const Scalar z1864 = k39 * z1714 + k41 * z1785 - k38 * z1794 - k40 * z1798 - k43 * z1849 - k42 * z1852 - z1863;
    const Scalar z1865 = s_q3 * z1851 - c_q3 * z1864;
    const Scalar z1866 = k49 * z680 + k45 * z887 - k46 * z889 - k48 * z1687 + n0_316 * z1793 - k47 * z1801 - z1865;
    const Scalar z1867 = z1688 + z1783;
    const Scalar z1868 = s_q4 * z1862 + c_q4 * z1859;
    const Scalar z1869 = z1714 + z1849;
    const Scalar z1870 = z1698 - z1795;
    const Scalar z1871 = k43 * z886 + k39 * z1780 + n0_0825 * z1791 - k38 * z1803 - k37 * z1811 - k40 * z1867 - z1868
        + k41 * z1869 + k42 * z1870;
    const Scalar z1872 = k57 * z679 - k46 * z1017 - k47 * z1687 + k48 * z1801 + z1871;
    const Scalar z1873 = s_q2 * (z1024 - z1866) + c_q2 * (z1023 - z1872);
    const Scalar z1874 = s_q3 * z1606 - c_q3 * z1597;
    const Scalar z1875 = s_q3 * z1676 - c_q3 * z1664;
    const Scalar z1876 = n0_316 * z1874 - z1875;
    const Scalar z1877 = n2 * z1687;
    const Scalar z1878 = s_q3 * z1792 + c_q3 * z1782;
    const Scalar z1879 = s_q3 * z1864 + c_q3 * z1851;
    const Scalar z1880 = k59 * z677 + k58 * z678 + k48 * z1018 + k47 * z1019 - k45 * z1801 + k46 * z1877 + n0_316
        * z1878 - z1879;
    const Scalar z1881 = n2 * z43;
    const Scalar z1882 = s_q4 * z47 - c_q4 * z46;
    const Scalar z1883 = z39 - z1882;
    const Scalar z1884 = n2 * s_q4 * z46;
    const Scalar z1885 = c_q4 * c_q6 - s_q6 * z184;
    const Scalar z1886 = n2 * z60 * z1885;
    const Scalar z1887 = n2 * z63 * z192;
    const Scalar z1888 = z1886 + z1887;
    const Scalar z1889 = c_q4 * s_q6 + c_q6 * z184;
    const Scalar z1890 = c_q4 * z40;
    const Scalar z1891 = v_q4 * c_q4 + z1890;
    const Scalar z1892 = s_q5 * z39 - c_q5 * z1891;
    const Scalar z1893 = v_q5 * z192 + z1892;
    const Scalar z1894 = s_q4 * z40;
    const Scalar z1895 = v_q4 * s_q4 + z1894;
    const Scalar z1896 = s_q6 * z1893 - c_q6 * z1895;
    const Scalar z1897 = v_q6 * z1889 - z1896;
    const Scalar z1898 = s_q7 * z192 + c_q7 * z1889;
    const Scalar z1899 = s_q7 * z1889 - c_q7 * z192;
    const Scalar z1900 = z66 * z1899 + z67 * z1898;
    const Scalar z1901 = z1897 - z1900;
    const Scalar z1902 = n2 * z70 * z1885;
    const Scalar z1903 = n2 * z66 * z1898;
    const Scalar z1904 = z1902 - z1903;
    const Scalar z1905 = k0 * z1901 - k1 * z1904;
    const Scalar z1906 = n2 * z67 * z1899;
    const Scalar z1907 = z1902 - z1906;
    const Scalar z1908 = z1897 + z1900;
    const Scalar z1909 = k0 * z1907 + k1 * z1908;
    const Scalar z1910 = s_q7 * z1905 - c_q7 * z1909;
    const Scalar z1911 = s_q5 * z1891 + c_q5 * z39;
    const Scalar z1912 = v_q5 * z184 + z1911;
    const Scalar z1913 = z59 * z1885 + z60 * z1889;
    const Scalar z1914 = z1912 - z1913;
    const Scalar z1915 = k13 * z1888 + z1910 - k19 * z1914;
    const Scalar z1916 = z1912 + z1913;
    const Scalar z1917 = s_q6 * z1895 + c_q6 * z1893;
    const Scalar z1918 = v_q6 * z1885 - z1917;
    const Scalar z1919 = s_q7 * z1918 - c_q7 * z1912;
    const Scalar z1920 = v_q7 * z1898 + z1919;
    const Scalar z1921 = z66 * z1885 - z70 * z1898;
    const Scalar z1922 = z1920 - z1921;
    const Scalar z1923 = s_q7 * z1912 + c_q7 * z1918;
    const Scalar z1924 = v_q7 * z1899 - z1923;
    const Scalar z1925 = z67 * z1885 - z70 * z1899;
    const Scalar z1926 = z1924 - z1925;
    const Scalar z1927 = k0 * z1922 + k1 * z1926;
    const Scalar z1928 = n2 * z59 * z1889;
    const Scalar z1929 = z1887 + z1928;
    const Scalar z1930 = k13 * z1916 - z1927 + k19 * z1929;
    const Scalar z1931 = s_q6 * z1915 - c_q6 * z1930;
    const Scalar z1932 = c_q4 * z54 - z58 * z184;
    const Scalar z1933 = z1912 - z1932;
    const Scalar z1934 = c_q4 * z55 + z58 * z192;
    const Scalar z1935 = z1893 + z1934;
    const Scalar z1936 = z1931 + k21 * z1933 + k22 * z1935;
    const Scalar z1937 = k30 * z1883 + k31 * z1884 + z1936;
    const Scalar z1938 = n2 * c_q4 * z47;
    const Scalar z1939 = z39 + z1882;
    const Scalar z1940 = z59 * z192 + z63 * z1889;
    const Scalar z1941 = z1897 + z1940;
    const Scalar z1942 = s_q7 * z1909 + c_q7 * z1905;
    const Scalar z1943 = z60 * z192 + z63 * z1885;
    const Scalar z1944 = z1918 + z1943;
    const Scalar z1945 = k13 * z1941 + z1942 - k19 * z1944;
    const Scalar z1946 = z54 * z192 - z55 * z184;
    const Scalar z1947 = z1895 - z1946;
    const Scalar z1948 = n2 * c_q4 * z58;
    const Scalar z1949 = n2 * z54 * z184;
    const Scalar z1950 = z1948 - z1949;
    const Scalar z1951 = z1945 - k21 * z1947 + k22 * z1950;
    const Scalar z1952 = s_q6 * z1930 + c_q6 * z1915;
    const Scalar z1953 = n2 * z55 * z192;
    const Scalar z1954 = z1948 + z1953;
    const Scalar z1955 = z1895 + z1946;
    const Scalar z1956 = z1952 - k21 * z1954 - k22 * z1955;
    const Scalar z1957 = s_q5 * z1951 - c_q5 * z1956;
    const Scalar z1958 = k30 * z1938 + k31 * z1939 - z1957;
    const Scalar z1959 = s_q4 * z1937 - c_q4 * z1958;
    const Scalar z1960 = k37 * z1881 - z1959;
    const Scalar z1961 = s_q4 * z50;
    const Scalar z1962 = z1895 + z1961;
    const Scalar z1963 = c_q4 * z50;
    const Scalar z1964 = z1891 + z1963;
    const Scalar z1965 = s_q5 * z1956 + c_q5 * z1951;
    const Scalar z1966 = k30 * z1962 - k31 * z1964 - z1965;
    const Scalar z1967 = k38 * z1881 - z1966;
    const Scalar z1968 = s_q3 * z1960 + c_q3 * z1967;
    const Scalar z1969 = n2 * z39;
    const Scalar z1970 = n0_0825 * z1969;
    const Scalar z1971 = n0_0825 * z1881;
    const Scalar z1972 = s_q4 * z1970 - c_q4 * z1971;
    const Scalar z1973 = s_q4 * z1971 + c_q4 * z1970;
    const Scalar z1974 = n0_0825 * z1883 + n0_384 * z1884 - z1973;
    const Scalar z1975 = n0_0825 * z1938 + n0_384 * z1939 - z1972;
    const Scalar z1976 = n0_0825 * z1962 - n0_384 * z1964;
    const Scalar z1977 = s_q5 * z1975 + c_q5 * z1976;
    const Scalar z1978 = n0_088 * z1941 - z1977;
    const Scalar z1979 = s_q5 * z1976 - c_q5 * z1975;
    const Scalar z1980 = s_q6 * z1974 - c_q6 * z1979;
    const Scalar z1981 = n0_088 * z1888 + z1980;
    const Scalar z1982 = s_q7 * z1978 - c_q7 * z1981;
    const Scalar z1983 = s_q7 * z1981 + c_q7 * z1978;
    const Scalar z1984 = z1924 + z1925;
    const Scalar z1985 = z1920 + z1921;
    const Scalar z1986 = z1903 - z1906;
    const Scalar z1987 = k4 * z1897 + k9 * z1900 + k1 * z1982 + k0 * z1983 + k3 * z1984 + k2 * z1985 - k11 * z1986;
    const Scalar z1988 = z1887 - z1928;
    const Scalar z1989 = k17 * z1914 - k53 * z1940 - n0_088 * z1942 + k15 * z1944 + k13 * z1977 - z1987 - k16 * z1988;
    const Scalar z1990 = s_q6 * z1979 + c_q6 * z1974;
    const Scalar z1991 = n0_088 * z1916 - z1990;
    const Scalar z1992 = z1902 + z1903;
    const Scalar z1993 = k2 * z1908 - k52 * z1921 - k11 * z1926 - k0 * z1991 - k3 * z1992;
    const Scalar z1994 = z1902 + z1906;
    const Scalar z1995 = k3 * z1901 - k11 * z1922 + k9 * z1924 - k4 * z1925 - k1 * z1991 + k2 * z1994;
    const Scalar z1996 = s_q7 * z1993 - c_q7 * z1995;
    const Scalar z1997 = z1886 - z1887;
    const Scalar z1998 = k16 * z1916 + k14 * z1918 + k15 * z1941 - k18 * z1943 - k19 * z1977 - z1996 - k17 * z1997;
    const Scalar z1999 = s_q6 * z1989 + c_q6 * z1998;
    const Scalar z2000 = z1948 - z1953;
    const Scalar z2001 = k23 * z1893 - k24 * z1933 + k27 * z1934 - k25 * z1947 + k22 * z1974 + z1999 + k26 * z2000;
    const Scalar z2002 = s_q7 * z1995 + c_q7 * z1993;
    const Scalar z2003 = z1918 - z1943;
    const Scalar z2004 = z1897 - z1940;
    const Scalar z2005 = z1886 - z1928;
    const Scalar z2006 = k18 * z1912 + k14 * z1913 - n0_088 * z1927 - k19 * z1980 - k13 * z1990 - z2002 - k16 * z2003
        - k17 * z2004 - k15 * z2005;
    const Scalar z2007 = z1948 + z1949;
    const Scalar z2008 = k54 * z1932 + k24 * z1935 - k26 * z1955 - k21 * z1974 - z2006 - k25 * z2007;
    const Scalar z2009 = s_q5 * z2001 - c_q5 * z2008;
    const Scalar z2010 = z1891 - z1963;
    const Scalar z2011 = z1895 - z1961;
    const Scalar z2012 = z1884 + z1938;
    const Scalar z2013 = k36 * z39 + k32 * z1882 + n0_0825 * z1936 - n0_384 * z1957 - k31 * z1972 - k30 * z1973 + z2009
        + k34 * z2010 + k35 * z2011 + k33 * z2012;
    const Scalar z2014 = s_q4 * z1958 + c_q4 * z1937;
    const Scalar z2015 = n2 * z40;
    const Scalar z2016 = k56 * z39 + k41 * z1881 + z2013 - n0_0825 * z2014 + k40 * z2015;
    const Scalar z2017 = s_q6 * z1998 - c_q6 * z1989;
    const Scalar z2018 = z1893 - z1934;
    const Scalar z2019 = z1912 + z1932;
    const Scalar z2020 = z1949 + z1953;
    const Scalar z2021 = k27 * z1895 + k23 * z1946 + k21 * z1977 + k22 * z1979 + z2017 - k25 * z2018 + k26 * z2019 - k24
        * z2020;
    const Scalar z2022 = k34 * z1884 + k35 * z1939 + k55 * z1961 - k33 * z1964 - n0_0825 * z1965 + z2021;
    const Scalar z2023 = s_q5 * z2008 + c_q5 * z2001;
    const Scalar z2024 = k34 * z1883 + k32 * z1891 + k35 * z1938 - k33 * z1962 + k36 * z1963 + n0_384 * z1965 - z2023;
    const Scalar z2025 = s_q4 * z2022 + c_q4 * z2024;
    const Scalar z2026 = k63 * z40 + k42 * z1881 + k40 * z1969 + z2025;
    const Scalar z2027 = s_q3 * z2016 + c_q3 * z2026;
    const Scalar z2028 = n0_316 * z1968 + z2027;
    const Scalar z2029 = s_q4 * z2024 - c_q4 * z2022;
    const Scalar z2030 = n0_0825 * z1966 + z2029;
    const Scalar z2031 = s_q2 * z2028 - c_q2 * z2030;
    const Scalar z2032 = n2 * z39 * z40;
    const Scalar z2033 = n2 * z39 * z50;
    const Scalar z2034 = n2 * z46 * z1890;
    const Scalar z2035 = z2033 + z2034;
    const Scalar z2036 = z46 * z1894 + z47 * z1890;
    const Scalar z2037 = z896 - z2036;
    const Scalar z2038 = s_q5 * z39 - c_q5 * z1890;
    const Scalar z2039 = s_q6 * z2038 - c_q6 * z1894;
    const Scalar z2040 = n2 * z60 * z2039;
    const Scalar z2041 = s_q5 * z1890 + c_q5 * z39;
    const Scalar z2042 = n2 * z63 * z2041;
    const Scalar z2043 = z2040 + z2042;
    const Scalar z2044 = n2 * z70 * z2039;
    const Scalar z2045 = s_q6 * z1894 + c_q6 * z2038;
    const Scalar z2046 = s_q7 * z2041 - c_q7 * z2045;
    const Scalar z2047 = n2 * z66 * z2046;
    const Scalar z2048 = z2044 - z2047;
    const Scalar z2049 = s_q7 * z2045 + c_q7 * z2041;
    const Scalar z2050 = z66 * z2049 - z67 * z2046;
    const Scalar z2051 = c_q4 * z897;
    const Scalar z2052 = v_q4 * z1894 + z2051;
    const Scalar z2053 = s_q5 * z896 + c_q5 * z2052;
    const Scalar z2054 = v_q5 * z2041 + z2053;
    const Scalar z2055 = s_q4 * z897;
    const Scalar z2056 = v_q4 * z1890 - z2055;
    const Scalar z2057 = s_q6 * z2054 - c_q6 * z2056;
    const Scalar z2058 = v_q6 * z2045 + z2057;
    const Scalar z2059 = z2050 - z2058;
    const Scalar z2060 = k1 * z2048 - k0 * z2059;
    const Scalar z2061 = n2 * z67 * z2049;
    const Scalar z2062 = z2044 + z2061;
    const Scalar z2063 = z2050 + z2058;
    const Scalar z2064 = k0 * z2062 - k1 * z2063;
    const Scalar z2065 = s_q7 * z2060 + c_q7 * z2064;
    const Scalar z2066 = z59 * z2039 - z60 * z2045;
    const Scalar z2067 = s_q5 * z2052 - c_q5 * z896;
    const Scalar z2068 = v_q5 * z2038 + z2067;
    const Scalar z2069 = z2066 + z2068;
    const Scalar z2070 = k13 * z2043 - z2065 + k19 * z2069;
    const Scalar z2071 = n2 * z59 * z2045;
    const Scalar z2072 = z2042 - z2071;
    const Scalar z2073 = z2066 - z2068;
    const Scalar z2074 = z66 * z2039 - z70 * z2046;
    const Scalar z2075 = s_q6 * z2056 + c_q6 * z2054;
    const Scalar z2076 = v_q6 * z2039 - z2075;
    const Scalar z2077 = s_q7 * z2076 + c_q7 * z2068;
    const Scalar z2078 = v_q7 * z2046 + z2077;
    const Scalar z2079 = z2074 - z2078;
    const Scalar z2080 = z67 * z2039 + z70 * z2049;
    const Scalar z2081 = s_q7 * z2068 - c_q7 * z2076;
    const Scalar z2082 = v_q7 * z2049 - z2081;
    const Scalar z2083 = z2080 + z2082;
    const Scalar z2084 = k0 * z2079 + k1 * z2083;
    const Scalar z2085 = k19 * z2072 + k13 * z2073 + z2084;
    const Scalar z2086 = s_q6 * z2070 - c_q6 * z2085;
    const Scalar z2087 = z54 * z1894 - z58 * z2038;
    const Scalar z2088 = z2068 - z2087;
    const Scalar z2089 = z55 * z1894 - z58 * z2041;
    const Scalar z2090 = z2054 - z2089;
    const Scalar z2091 = z2086 - k21 * z2088 + k22 * z2090;
    const Scalar z2092 = k31 * z2035 + k30 * z2037 + z2091;
    const Scalar z2093 = n2 * z47 * z1894;
    const Scalar z2094 = z2033 + z2093;
    const Scalar z2095 = z896 + z2036;
    const Scalar z2096 = n2 * z58 * z1894;
    const Scalar z2097 = n2 * z54 * z2038;
    const Scalar z2098 = z2096 - z2097;
    const Scalar z2099 = z59 * z2041 - z63 * z2045;
    const Scalar z2100 = z2058 - z2099;
    const Scalar z2101 = s_q7 * z2064 - c_q7 * z2060;
    const Scalar z2102 = z60 * z2041 + z63 * z2039;
    const Scalar z2103 = z2076 + z2102;
    const Scalar z2104 = k13 * z2100 - z2101 + k19 * z2103;
    const Scalar z2105 = z54 * z2041 + z55 * z2038;
    const Scalar z2106 = z2056 - z2105;
    const Scalar z2107 = k22 * z2098 + z2104 + k21 * z2106;
    const Scalar z2108 = n2 * z55 * z2041;
    const Scalar z2109 = z2096 - z2108;
    const Scalar z2110 = s_q6 * z2085 + c_q6 * z2070;
    const Scalar z2111 = z2056 + z2105;
    const Scalar z2112 = k21 * z2109 + z2110 - k22 * z2111;
    const Scalar z2113 = s_q5 * z2107 + c_q5 * z2112;
    const Scalar z2114 = k30 * z2094 - k31 * z2095 - z2113;
    const Scalar z2115 = s_q4 * z2092 + c_q4 * z2114;
    const Scalar z2116 = z39 * z39 - z40 * z40;
    const Scalar z2117 = k37 * z2032 + z2115 - k38 * z2116;
    const Scalar z2118 = z39 * z46 + z50 * z1890;
    const Scalar z2119 = z2056 + z2118;
    const Scalar z2120 = z39 * z47 + z50 * z1894;
    const Scalar z2121 = z2052 + z2120;
    const Scalar z2122 = s_q5 * z2112 - c_q5 * z2107;
    const Scalar z2123 = k30 * z2119 + k31 * z2121 - z2122;
    const Scalar z2124 = k38 * z2032 + k37 * z2116 - z2123;
    const Scalar z2125 = s_q3 * (z1007 + z2117) - c_q3 * (z1006 + z2124);
    const Scalar z2126 = z2034 - z2093;
    const Scalar z2127 = n0_0825 * z1003;
    const Scalar z2128 = z895 + n0_0825 * z2032;
    const Scalar z2129 = s_q4 * z2127 + c_q4 * z2128;
    const Scalar z2130 = s_q4 * z2128 - c_q4 * z2127;
    const Scalar z2131 = z2096 + z2108;
    const Scalar z2132 = n0_384 * z2035 + n0_0825 * z2037 + z2130;
    const Scalar z2133 = z2042 + z2071;
    const Scalar z2134 = n0_0825 * z2094 - n0_384 * z2095 + z2129;
    const Scalar z2135 = z894 + n0_0825 * z2116;
    const Scalar z2136 = n0_0825 * z2119 + n0_384 * z2121 - z2135;
    const Scalar z2137 = s_q5 * z2134 - c_q5 * z2136;
    const Scalar z2138 = z2047 + z2061;
    const Scalar z2139 = n0_088 * z2100 - z2137;
    const Scalar z2140 = s_q5 * z2136 + c_q5 * z2134;
    const Scalar z2141 = s_q6 * z2132 - c_q6 * z2140;
    const Scalar z2142 = n0_088 * z2043 + z2141;
    const Scalar z2143 = s_q7 * z2139 + c_q7 * z2142;
    const Scalar z2144 = s_q7 * z2142 - c_q7 * z2139;
    const Scalar z2145 = z2080 - z2082;
    const Scalar z2146 = z2074 + z2078;
    const Scalar z2147 = k9 * z2050 + k4 * z2058 + k11 * z2138 + k1 * z2143 - k0 * z2144 - k3 * z2145 - k2 * z2146;
    const Scalar z2148 = k17 * z2069 + k53 * z2099 + n0_088 * z2101 - k15 * z2103 + k16 * z2133 + k13 * z2137 - z2147;
    const Scalar z2149 = z2040 - z2042;
    const Scalar z2150 = z2044 + z2047;
    const Scalar z2151 = s_q6 * z2140 + c_q6 * z2132;
    const Scalar z2152 = n0_088 * z2073 - z2151;
    const Scalar z2153 = k2 * z2063 + k52 * z2074 - k11 * z2083 + k3 * z2150 + k0 * z2152;
    const Scalar z2154 = z2044 - z2061;
    const Scalar z2155 = k3 * z2059 + k11 * z2079 - k4 * z2080 - k9 * z2082 - k1 * z2152 + k2 * z2154;
    const Scalar z2156 = s_q7 * z2153 + c_q7 * z2155;
    const Scalar z2157 = k16 * z2073 + k14 * z2076 - k15 * z2100 - k18 * z2102 + k19 * z2137 - k17 * z2149 + z2156;
    const Scalar z2158 = s_q6 * z2148 - c_q6 * z2157;
    const Scalar z2159 = k23 * z2054 + k24 * z2088 - k27 * z2089 - k25 * z2106 - k26 * z2131 + k22 * z2132 - z2158;
    const Scalar z2160 = z2096 + z2097;
    const Scalar z2161 = z2040 + z2071;
    const Scalar z2162 = s_q7 * z2155 - c_q7 * z2153;
    const Scalar z2163 = z2076 - z2102;
    const Scalar z2164 = z2058 + z2099;
    const Scalar z2165 = k14 * z2066 - k18 * z2068 + n0_088 * z2084 - k19 * z2141 - k13 * z2151 - k15 * z2161 - z2162
        - k16 * z2163 + k17 * z2164;
    const Scalar z2166 = k54 * z2087 - k24 * z2090 + k26 * z2111 + k21 * z2132 - k25 * z2160 + z2165;
    const Scalar z2167 = s_q5 * z2159 + c_q5 * z2166;
    const Scalar z2168 = z2052 - z2120;
    const Scalar z2169 = z2056 - z2118;
    const Scalar z2170 = k36 * z896 + k32 * z2036 + n0_0825 * z2091 + n0_384 * z2113 + k33 * z2126 - k31 * z2129 + k30
        * z2130 + z2167 - k34 * z2168 + k35 * z2169;
    const Scalar z2171 = s_q4 * z2114 - c_q4 * z2092;
    const Scalar z2172 = k56 * z846 - k40 * z900 - k41 * z2032 + k42 * z2116 + z2170 + n0_0825 * z2171;
    const Scalar z2173 = z2033 - z2034;
    const Scalar z2174 = z2097 - z2108;
    const Scalar z2175 = s_q6 * z2157 + c_q6 * z2148;
    const Scalar z2176 = z2054 + z2089;
    const Scalar z2177 = z2068 + z2087;
    const Scalar z2178 = k27 * z2056 + k23 * z2105 - k21 * z2137 + k22 * z2140 + k24 * z2174 + z2175 - k25 * z2176 - k26
        * z2177;
    const Scalar z2179 = k35 * z2095 + k55 * z2118 + k33 * z2121 - n0_0825 * z2122 - k30 * z2135 - k34 * z2173 + z2178;
    const Scalar z2180 = z2033 - z2093;
    const Scalar z2181 = s_q5 * z2166 - c_q5 * z2159;
    const Scalar z2182 = k34 * z2037 - k32 * z2052 - k33 * z2119 - k36 * z2120 + n0_384 * z2122 + k31 * z2135 + k35
        * z2180 + z2181;
    const Scalar z2183 = s_q4 * z2179 + c_q4 * z2182;
    const Scalar z2184 = k43 * z700 + k39 * z897 - k40 * z1003 - k42 * z2032 - k41 * z2116 - z2183;
    const Scalar z2185 = s_q3 * (z1009 - z2172) - c_q3 * (z1010 - z2184);
    const Scalar z2186 = n0_316 * z2125 + z2185;
    const Scalar z2187 = n2 * z2032;
    const Scalar z2188 = s_q4 * z2182 - c_q4 * z2179;
    const Scalar z2189 = k37 * z894 + k38 * z895 + k42 * z1004 + k41 * z1005 - k39 * z2116 - n0_0825 * z2123 + k40
        * z2187 - z2188;
    const Scalar z2190 = s_q2 * z2186 - c_q2 * z2189;
    const Scalar z2191 = s_q3 * z1967 - c_q3 * z1960;
    const Scalar z2192 = s_q3 * z2026 - c_q3 * z2016;
    const Scalar z2193 = n0_316 * z2191 + z2192;
    const Scalar z2194 = s_q3 * (z1006 + z2124) + c_q3 * (z1007 + z2117);
    const Scalar z2195 = s_q3 * (z1010 - z2184) + c_q3 * (z1009 - z2172);
    const Scalar z2196 = n0_316 * z2194 + z2195;
    const Scalar z2197 = n2 * z50;
    const Scalar z2198 = n2 * z60 * z250;
    const Scalar z2199 = n2 * c_q5 * z63;
    const Scalar z2200 = z2198 + z2199;
    const Scalar z2201 = c_q5 * z47;
    const Scalar z2202 = v_q5 * c_q5 + z2201;
    const Scalar z2203 = s_q6 * z2202 - c_q6 * z46;
    const Scalar z2204 = v_q6 * z240 + z2203;
    const Scalar z2205 = c_q5 * s_q7 - c_q7 * z240;
    const Scalar z2206 = c_q5 * c_q7 + s_q7 * z240;
    const Scalar z2207 = z66 * z2206 - z67 * z2205;
    const Scalar z2208 = z2204 - z2207;
    const Scalar z2209 = n2 * z70 * z250;
    const Scalar z2210 = n2 * z66 * z2205;
    const Scalar z2211 = z2209 - z2210;
    const Scalar z2212 = k0 * z2208 + k1 * z2211;
    const Scalar z2213 = n2 * z67 * z2206;
    const Scalar z2214 = z2209 + z2213;
    const Scalar z2215 = z2204 + z2207;
    const Scalar z2216 = k0 * z2214 - k1 * z2215;
    const Scalar z2217 = s_q7 * z2212 + c_q7 * z2216;
    const Scalar z2218 = s_q5 * z47;
    const Scalar z2219 = v_q5 * s_q5 + z2218;
    const Scalar z2220 = z59 * z250 - z60 * z240;
    const Scalar z2221 = z2219 + z2220;
    const Scalar z2222 = k13 * z2200 - z2217 + k19 * z2221;
    const Scalar z2223 = z2219 - z2220;
    const Scalar z2224 = s_q6 * z46 + c_q6 * z2202;
    const Scalar z2225 = v_q6 * z250 - z2224;
    const Scalar z2226 = s_q7 * z2225 + c_q7 * z2219;
    const Scalar z2227 = v_q7 * z2205 + z2226;
    const Scalar z2228 = z66 * z250 - z70 * z2205;
    const Scalar z2229 = z2227 - z2228;
    const Scalar z2230 = s_q7 * z2219 - c_q7 * z2225;
    const Scalar z2231 = v_q7 * z2206 - z2230;
    const Scalar z2232 = z67 * z250 + z70 * z2206;
    const Scalar z2233 = z2231 + z2232;
    const Scalar z2234 = k0 * z2229 - k1 * z2233;
    const Scalar z2235 = n2 * z59 * z240;
    const Scalar z2236 = z2199 - z2235;
    const Scalar z2237 = k13 * z2223 + z2234 - k19 * z2236;
    const Scalar z2238 = s_q6 * z2222 + c_q6 * z2237;
    const Scalar z2239 = s_q5 * z58;
    const Scalar z2240 = z2219 + z2239;
    const Scalar z2241 = c_q5 * z58;
    const Scalar z2242 = z2202 + z2241;
    const Scalar z2243 = z2238 - k21 * z2240 + k22 * z2242;
    const Scalar z2244 = k31 * z2197 + z2243;
    const Scalar z2245 = c_q5 * z59 - z63 * z240;
    const Scalar z2246 = z2204 - z2245;
    const Scalar z2247 = s_q7 * z2216 - c_q7 * z2212;
    const Scalar z2248 = c_q5 * z60 + z63 * z250;
    const Scalar z2249 = z2225 + z2248;
    const Scalar z2250 = k13 * z2246 - z2247 + k19 * z2249;
    const Scalar z2251 = s_q5 * z55 + c_q5 * z54;
    const Scalar z2252 = z46 - z2251;
    const Scalar z2253 = n2 * s_q5 * z54;
    const Scalar z2254 = z2250 + k21 * z2252 - k22 * z2253;
    const Scalar z2255 = s_q6 * z2237 - c_q6 * z2222;
    const Scalar z2256 = n2 * c_q5 * z55;
    const Scalar z2257 = z46 + z2251;
    const Scalar z2258 = z2255 + k21 * z2256 + k22 * z2257;
    const Scalar z2259 = s_q5 * z2254 - c_q5 * z2258;
    const Scalar z2260 = k30 * z2197 - z2259;
    const Scalar z2261 = s_q4 * z2244 + c_q4 * z2260;
    const Scalar z2262 = n2 * z46;
    const Scalar z2263 = n2 * z47;
    const Scalar z2264 = s_q5 * z2258 + c_q5 * z2254;
    const Scalar z2265 = k30 * z2262 + k31 * z2263 + z2264;
    const Scalar z2266 = s_q3 * z2261 + c_q3 * z2265;
    const Scalar z2267 = n0_384 * z2197;
    const Scalar z2268 = n0_0825 * z2197;
    const Scalar z2269 = n0_0825 * z2262 + n0_384 * z2263;
    const Scalar z2270 = s_q5 * z2268 - c_q5 * z2269;
    const Scalar z2271 = n0_088 * z2246 - z2270;
    const Scalar z2272 = s_q5 * z2269 + c_q5 * z2268;
    const Scalar z2273 = s_q6 * z2267 - c_q6 * z2272;
    const Scalar z2274 = n0_088 * z2200 + z2273;
    const Scalar z2275 = s_q7 * z2271 + c_q7 * z2274;
    const Scalar z2276 = s_q7 * z2274 - c_q7 * z2271;
    const Scalar z2277 = z2231 - z2232;
    const Scalar z2278 = z2227 + z2228;
    const Scalar z2279 = z2210 + z2213;
    const Scalar z2280 = k4 * z2204 + k9 * z2207 + k1 * z2275 - k0 * z2276 + k3 * z2277 - k2 * z2278 + k11 * z2279;
    const Scalar z2281 = z2199 + z2235;
    const Scalar z2282 = k17 * z2221 + k53 * z2245 + n0_088 * z2247 - k15 * z2249 + k13 * z2270 - z2280 + k16 * z2281;
    const Scalar z2283 = s_q6 * z2272 + c_q6 * z2267;
    const Scalar z2284 = n0_088 * z2223 + z2283;
    const Scalar z2285 = z2209 + z2210;
    const Scalar z2286 = k2 * z2215 + k52 * z2228 - k11 * z2233 - k0 * z2284 + k3 * z2285;
    const Scalar z2287 = z2209 - z2213;
    const Scalar z2288 = k3 * z2208 + k11 * z2229 + k9 * z2231 + k4 * z2232 - k1 * z2284 - k2 * z2287;
    const Scalar z2289 = s_q7 * z2286 - c_q7 * z2288;
    const Scalar z2290 = z2198 - z2199;
    const Scalar z2291 = k16 * z2223 - k14 * z2225 + k15 * z2246 + k18 * z2248 - k19 * z2270 - z2289 + k17 * z2290;
    const Scalar z2292 = s_q6 * z2282 + c_q6 * z2291;
    const Scalar z2293 = k23 * z2202 + k24 * z2240 + k27 * z2241 - k25 * z2252 - k26 * z2256 + k22 * z2267 - z2292;
    const Scalar z2294 = s_q7 * z2288 + c_q7 * z2286;
    const Scalar z2295 = z2225 - z2248;
    const Scalar z2296 = z2204 + z2245;
    const Scalar z2297 = z2198 + z2235;
    const Scalar z2298 = k18 * z2219 - k14 * z2220 + n0_088 * z2234 + k19 * z2273 + k13 * z2283 - z2294 + k16 * z2295
        - k17 * z2296 + k15 * z2297;
    const Scalar z2299 = k54 * z2239 + k24 * z2242 + k25 * z2253 - k26 * z2257 - k21 * z2267 + z2298;
    const Scalar z2300 = s_q5 * z2293 - c_q5 * z2299;
    const Scalar z2301 = n0_0825 * z2243 + n0_384 * z2259 + z2300;
    const Scalar z2302 = s_q4 * z2260 - c_q4 * z2244;
    const Scalar z2303 = z2301 + n0_0825 * z2302;
    const Scalar z2304 = s_q6 * z2291 - c_q6 * z2282;
    const Scalar z2305 = z2202 - z2241;
    const Scalar z2306 = z2219 - z2239;
    const Scalar z2307 = z2253 - z2256;
    const Scalar z2308 = k27 * z46 + k23 * z2251 - k21 * z2270 + k22 * z2272 - z2304 - k25 * z2305 - k26 * z2306 + k24
        * z2307;
    const Scalar z2309 = k55 * z46 - k34 * z2197 + k33 * z2263 + n0_0825 * z2264 + z2308;
    const Scalar z2310 = s_q5 * z2299 + c_q5 * z2293;
    const Scalar z2311 = k64 * z47 - k35 * z2197 + k33 * z2262 + n0_384 * z2264 + z2310;
    const Scalar z2312 = s_q4 * z2309 - c_q4 * z2311;
    const Scalar z2313 = s_q3 * z2303 + c_q3 * z2312;
    const Scalar z2314 = n0_316 * z2266 - z2313;
    const Scalar z2315 = s_q4 * z2311 + c_q4 * z2309;
    const Scalar z2316 = n0_0825 * z2265 - z2315;
    const Scalar z2317 = s_q2 * z2314 + c_q2 * z2316;
    const Scalar z2318 = n2 * z46 * z47;
    const Scalar z2319 = z46 * z46 - z47 * z47;
    const Scalar z2320 = s_q6 * z2201 - c_q6 * z46;
    const Scalar z2321 = n2 * z60 * z2320;
    const Scalar z2322 = n2 * z63 * z2218;
    const Scalar z2323 = z2321 - z2322;
    const Scalar z2324 = n2 * z70 * z2320;
    const Scalar z2325 = s_q6 * z46 + c_q6 * z2201;
    const Scalar z2326 = s_q7 * z2218 + c_q7 * z2325;
    const Scalar z2327 = n2 * z66 * z2326;
    const Scalar z2328 = z2324 + z2327;
    const Scalar z2329 = s_q7 * z2325 - c_q7 * z2218;
    const Scalar z2330 = z66 * z2329 + z67 * z2326;
    const Scalar z2331 = c_q5 * z909;
    const Scalar z2332 = v_q5 * z2218 - z2331;
    const Scalar z2333 = s_q6 * z2332 - c_q6 * z908;
    const Scalar z2334 = v_q6 * z2325 - z2333;
    const Scalar z2335 = z2330 - z2334;
    const Scalar z2336 = k1 * z2328 - k0 * z2335;
    const Scalar z2337 = n2 * z67 * z2329;
    const Scalar z2338 = z2324 + z2337;
    const Scalar z2339 = z2330 + z2334;
    const Scalar z2340 = k0 * z2338 - k1 * z2339;
    const Scalar z2341 = s_q7 * z2336 + c_q7 * z2340;
    const Scalar z2342 = z59 * z2320 - z60 * z2325;
    const Scalar z2343 = s_q5 * z909;
    const Scalar z2344 = v_q5 * z2201 + z2343;
    const Scalar z2345 = z2342 + z2344;
    const Scalar z2346 = k13 * z2323 - z2341 + k19 * z2345;
    const Scalar z2347 = n2 * z59 * z2325;
    const Scalar z2348 = z2322 + z2347;
    const Scalar z2349 = z2342 - z2344;
    const Scalar z2350 = z66 * z2320 + z70 * z2326;
    const Scalar z2351 = s_q6 * z908 + c_q6 * z2332;
    const Scalar z2352 = v_q6 * z2320 + z2351;
    const Scalar z2353 = s_q7 * z2352 + c_q7 * z2344;
    const Scalar z2354 = v_q7 * z2326 - z2353;
    const Scalar z2355 = z2350 + z2354;
    const Scalar z2356 = z67 * z2320 + z70 * z2329;
    const Scalar z2357 = s_q7 * z2344 - c_q7 * z2352;
    const Scalar z2358 = v_q7 * z2329 - z2357;
    const Scalar z2359 = z2356 + z2358;
    const Scalar z2360 = k0 * z2355 + k1 * z2359;
    const Scalar z2361 = k19 * z2348 - k13 * z2349 - z2360;
    const Scalar z2362 = s_q6 * z2346 + c_q6 * z2361;
    const Scalar z2363 = z46 * z54 - z58 * z2201;
    const Scalar z2364 = z2344 - z2363;
    const Scalar z2365 = z46 * z55 + z58 * z2218;
    const Scalar z2366 = z2332 + z2365;
    const Scalar z2367 = z2362 - k21 * z2364 - k22 * z2366;
    const Scalar z2368 = k31 * z2318 + k30 * z2319 - z2367;
    const Scalar z2369 = n2 * z46 * z58;
    const Scalar z2370 = n2 * z54 * z2201;
    const Scalar z2371 = z2369 - z2370;
    const Scalar z2372 = z59 * z2218 + z63 * z2325;
    const Scalar z2373 = z2334 + z2372;
    const Scalar z2374 = s_q7 * z2340 - c_q7 * z2336;
    const Scalar z2375 = z60 * z2218 - z63 * z2320;
    const Scalar z2376 = z2352 - z2375;
    const Scalar z2377 = k13 * z2373 - z2374 + k19 * z2376;
    const Scalar z2378 = z54 * z2218 - z55 * z2201;
    const Scalar z2379 = z908 - z2378;
    const Scalar z2380 = k22 * z2371 + z2377 - k21 * z2379;
    const Scalar z2381 = n2 * z55 * z2218;
    const Scalar z2382 = z2369 + z2381;
    const Scalar z2383 = s_q6 * z2361 - c_q6 * z2346;
    const Scalar z2384 = z908 + z2378;
    const Scalar z2385 = k21 * z2382 - z2383 + k22 * z2384;
    const Scalar z2386 = s_q5 * z2380 + c_q5 * z2385;
    const Scalar z2387 = k30 * z2318 - k31 * z2319 - z2386;
    const Scalar z2388 = s_q4 * (z992 + z2368) - c_q4 * (z993 + z2387);
    const Scalar z2389 = s_q5 * z2385 - c_q5 * z2380;
    const Scalar z2390 = k31 * z913 - k30 * z914 - z2389;
    const Scalar z2391 = s_q3 * z2388 - c_q3 * z2390;
    const Scalar z2392 = n2 * z2318;
    const Scalar z2393 = z2369 - z2381;
    const Scalar z2394 = z906 - n0_384 * z2318 - n0_0825 * z2319;
    const Scalar z2395 = z2322 - z2347;
    const Scalar z2396 = z907 + n0_0825 * z2318 - n0_384 * z2319;
    const Scalar z2397 = n0_384 * z913 - n0_0825 * z914;
    const Scalar z2398 = s_q5 * z2396 - c_q5 * z2397;
    const Scalar z2399 = z2327 - z2337;
    const Scalar z2400 = n0_088 * z2373 - z2398;
    const Scalar z2401 = s_q5 * z2397 + c_q5 * z2396;
    const Scalar z2402 = s_q6 * z2394 - c_q6 * z2401;
    const Scalar z2403 = n0_088 * z2323 + z2402;
    const Scalar z2404 = s_q7 * z2400 + c_q7 * z2403;
    const Scalar z2405 = s_q7 * z2403 - c_q7 * z2400;
    const Scalar z2406 = z2356 - z2358;
    const Scalar z2407 = z2350 - z2354;
    const Scalar z2408 = k9 * z2330 + k4 * z2334 - k11 * z2399 + k1 * z2404 - k0 * z2405 - k3 * z2406 - k2 * z2407;
    const Scalar z2409 = k17 * z2345 - k53 * z2372 + n0_088 * z2374 - k15 * z2376 - k16 * z2395 + k13 * z2398 - z2408;
    const Scalar z2410 = z2321 + z2322;
    const Scalar z2411 = z2324 - z2327;
    const Scalar z2412 = s_q6 * z2401 + c_q6 * z2394;
    const Scalar z2413 = n0_088 * z2349 - z2412;
    const Scalar z2414 = k2 * z2339 + k52 * z2350 - k11 * z2359 + k3 * z2411 + k0 * z2413;
    const Scalar z2415 = z2324 - z2337;
    const Scalar z2416 = k3 * z2335 + k11 * z2355 - k4 * z2356 - k9 * z2358 - k1 * z2413 + k2 * z2415;
    const Scalar z2417 = s_q7 * z2414 + c_q7 * z2416;
    const Scalar z2418 = k16 * z2349 + k14 * z2352 - k15 * z2373 + k18 * z2375 + k19 * z2398 - k17 * z2410 + z2417;
    const Scalar z2419 = s_q6 * z2409 - c_q6 * z2418;
    const Scalar z2420 = k23 * z2332 - k24 * z2364 + k27 * z2365 - k25 * z2379 + k26 * z2393 - k22 * z2394 + z2419;
    const Scalar z2421 = z2369 + z2370;
    const Scalar z2422 = z2321 + z2347;
    const Scalar z2423 = s_q7 * z2416 - c_q7 * z2414;
    const Scalar z2424 = z2352 + z2375;
    const Scalar z2425 = z2334 - z2372;
    const Scalar z2426 = k14 * z2342 - k18 * z2344 + n0_088 * z2360 - k19 * z2402 - k13 * z2412 - k15 * z2422 - z2423
        - k16 * z2424 + k17 * z2425;
    const Scalar z2427 = k54 * z2363 + k24 * z2366 - k26 * z2384 + k21 * z2394 - k25 * z2421 + z2426;
    const Scalar z2428 = s_q5 * z2420 - c_q5 * z2427;
    const Scalar z2429 = k30 * z906 - k31 * z907 + k35 * z990 + k34 * z991 + k32 * z2319 + n0_0825 * z2367 + n0_384
        * z2386 - k33 * z2392 - z2428;
    const Scalar z2430 = s_q4 * (z993 + z2387) + c_q4 * (z992 + z2368);
    const Scalar z2431 = z2429 + n0_0825 * z2430;
    const Scalar z2432 = z2370 + z2381;
    const Scalar z2433 = s_q6 * z2418 + c_q6 * z2409;
    const Scalar z2434 = z2332 - z2365;
    const Scalar z2435 = z2344 + z2363;
    const Scalar z2436 = k27 * z908 + k23 * z2378 + k21 * z2398 - k22 * z2401 - k24 * z2432 - z2433 - k25 * z2434 + k26
        * z2435;
    const Scalar z2437 = k55 * z721 - k33 * z913 + k34 * z2318 - k35 * z2319 + n0_0825 * z2389 + z2436;
    const Scalar z2438 = s_q5 * z2427 + c_q5 * z2420;
    const Scalar z2439 = k36 * z719 + k32 * z909 - k33 * z914 + k35 * z2318 + k34 * z2319 - n0_384 * z2389 - z2438;
    const Scalar z2440 = s_q4 * (z995 - z2437) + c_q4 * (z996 - z2439);
    const Scalar z2441 = s_q3 * z2431 + c_q3 * z2440;
    const Scalar z2442 = n0_316 * z2391 + z2441;
    const Scalar z2443 = s_q4 * (z996 - z2439) - c_q4 * (z995 - z2437);
    const Scalar z2444 = n0_0825 * z2390 + z2443;
    const Scalar z2445 = s_q2 * z2442 - c_q2 * z2444;
    const Scalar z2446 = s_q3 * z2265 - c_q3 * z2261;
    const Scalar z2447 = s_q3 * z2312 - c_q3 * z2303;
    const Scalar z2448 = n0_316 * z2446 - z2447;
    const Scalar z2449 = s_q3 * z2390 + c_q3 * z2388;
    const Scalar z2450 = s_q3 * z2440 - c_q3 * z2431;
    const Scalar z2451 = n0_316 * z2449 - z2450;
    const Scalar z2452 = n2 * c_q6 * z60;
    const Scalar z2453 = s_q6 * z55;
    const Scalar z2454 = v_q6 * s_q6 - z2453;
    const Scalar z2455 = z66 * z319 + z67 * z307;
    const Scalar z2456 = z2454 - z2455;
    const Scalar z2457 = n2 * c_q6 * z70;
    const Scalar z2458 = n2 * z66 * z307;
    const Scalar z2459 = z2457 - z2458;
    const Scalar z2460 = k0 * z2456 - k1 * z2459;
    const Scalar z2461 = n2 * z67 * z319;
    const Scalar z2462 = z2457 - z2461;
    const Scalar z2463 = z2454 + z2455;
    const Scalar z2464 = k0 * z2462 + k1 * z2463;
    const Scalar z2465 = s_q7 * z2460 - c_q7 * z2464;
    const Scalar z2466 = s_q6 * z60 + c_q6 * z59;
    const Scalar z2467 = z54 + z2466;
    const Scalar z2468 = k13 * z2452 + z2465 + k19 * z2467;
    const Scalar z2469 = z54 - z2466;
    const Scalar z2470 = c_q6 * z55;
    const Scalar z2471 = v_q6 * c_q6 - z2470;
    const Scalar z2472 = s_q7 * z2471 + c_q7 * z54;
    const Scalar z2473 = v_q7 * z307 + z2472;
    const Scalar z2474 = c_q6 * z66 - z70 * z307;
    const Scalar z2475 = z2473 - z2474;
    const Scalar z2476 = s_q7 * z54 - c_q7 * z2471;
    const Scalar z2477 = v_q7 * z319 + z2476;
    const Scalar z2478 = c_q6 * z67 - z70 * z319;
    const Scalar z2479 = z2477 - z2478;
    const Scalar z2480 = k0 * z2475 + k1 * z2479;
    const Scalar z2481 = n2 * s_q6 * z59;
    const Scalar z2482 = k13 * z2469 + z2480 - k19 * z2481;
    const Scalar z2483 = s_q6 * z2468 + c_q6 * z2482;
    const Scalar z2484 = n2 * z54;
    const Scalar z2485 = n2 * z55;
    const Scalar z2486 = z2483 - k21 * z2484 + k22 * z2485;
    const Scalar z2487 = s_q6 * z63;
    const Scalar z2488 = z2454 + z2487;
    const Scalar z2489 = s_q7 * z2464 + c_q7 * z2460;
    const Scalar z2490 = c_q6 * z63;
    const Scalar z2491 = z2471 + z2490;
    const Scalar z2492 = k13 * z2488 + z2489 - k19 * z2491;
    const Scalar z2493 = n2 * z58;
    const Scalar z2494 = z2492 + k22 * z2493;
    const Scalar z2495 = s_q6 * z2482 - c_q6 * z2468;
    const Scalar z2496 = k21 * z2493 + z2495;
    const Scalar z2497 = s_q5 * z2494 + c_q5 * z2496;
    const Scalar z2498 = s_q4 * z2486 + c_q4 * z2497;
    const Scalar z2499 = s_q5 * z2496 - c_q5 * z2494;
    const Scalar z2500 = s_q3 * z2498 + c_q3 * z2499;
    const Scalar z2501 = n0_088 * z2488;
    const Scalar z2502 = n0_088 * z2452;
    const Scalar z2503 = s_q7 * z2501 - c_q7 * z2502;
    const Scalar z2504 = s_q7 * z2502 + c_q7 * z2501;
    const Scalar z2505 = z2477 + z2478;
    const Scalar z2506 = z2473 + z2474;
    const Scalar z2507 = z2458 - z2461;
    const Scalar z2508 = k4 * z2454 + k9 * z2455 + k1 * z2503 + k0 * z2504 + k3 * z2505 + k2 * z2506 - k11 * z2507;
    const Scalar z2509 = k17 * z2467 - k16 * z2481 + k53 * z2487 + n0_088 * z2489 - k15 * z2491 + z2508;
    const Scalar z2510 = n0_088 * z2469;
    const Scalar z2511 = z2457 + z2458;
    const Scalar z2512 = k2 * z2463 - k52 * z2474 - k11 * z2479 + k0 * z2510 - k3 * z2511;
    const Scalar z2513 = z2457 + z2461;
    const Scalar z2514 = k3 * z2456 - k11 * z2475 + k9 * z2477 - k4 * z2478 + k1 * z2510 + k2 * z2513;
    const Scalar z2515 = s_q7 * z2512 - c_q7 * z2514;
    const Scalar z2516 = k17 * z2452 + k16 * z2469 - k14 * z2471 - k15 * z2488 + k18 * z2490 + z2515;
    const Scalar z2517 = s_q6 * z2509 + c_q6 * z2516;
    const Scalar z2518 = k65 * z55 + k24 * z2484 + k26 * z2493 - z2517;
    const Scalar z2519 = s_q7 * z2514 + c_q7 * z2512;
    const Scalar z2520 = z2471 - z2490;
    const Scalar z2521 = z2454 - z2487;
    const Scalar z2522 = z2452 - z2481;
    const Scalar z2523 = k18 * z54 - k14 * z2466 + n0_088 * z2480 + z2519 + k16 * z2520 + k17 * z2521 + k15 * z2522;
    const Scalar z2524 = k54 * z54 + k24 * z2485 - k25 * z2493 + z2523;
    const Scalar z2525 = s_q5 * z2518 - c_q5 * z2524;
    const Scalar z2526 = n0_0825 * z2486 - n0_384 * z2497 + z2525;
    const Scalar z2527 = s_q4 * z2497 - c_q4 * z2486;
    const Scalar z2528 = z2526 + n0_0825 * z2527;
    const Scalar z2529 = s_q6 * z2516 - c_q6 * z2509;
    const Scalar z2530 = n0_0825 * z2499 - z2529;
    const Scalar z2531 = s_q5 * z2524 + c_q5 * z2518;
    const Scalar z2532 = n0_384 * z2499 + z2531;
    const Scalar z2533 = s_q4 * z2530 - c_q4 * z2532;
    const Scalar z2534 = s_q3 * z2528 + c_q3 * z2533;
    const Scalar z2535 = n0_316 * z2500 - z2534;
    const Scalar z2536 = s_q4 * z2532 + c_q4 * z2530;
    const Scalar z2537 = n0_0825 * z2499 - z2536;
    const Scalar z2538 = s_q2 * z2535 + c_q2 * z2537;
    const Scalar z2539 = n2 * z60 * z2453;
    const Scalar z2540 = n2 * z54 * z63;
    const Scalar z2541 = z2539 - z2540;
    const Scalar z2542 = n2 * z70 * z2453;
    const Scalar z2543 = s_q7 * z54 + c_q7 * z2470;
    const Scalar z2544 = n2 * z66 * z2543;
    const Scalar z2545 = z2542 + z2544;
    const Scalar z2546 = s_q7 * z2470 - c_q7 * z54;
    const Scalar z2547 = z66 * z2546 + z67 * z2543;
    const Scalar z2548 = s_q6 * z923;
    const Scalar z2549 = v_q6 * z2470 - z2548;
    const Scalar z2550 = z2547 - z2549;
    const Scalar z2551 = k1 * z2545 - k0 * z2550;
    const Scalar z2552 = n2 * z67 * z2546;
    const Scalar z2553 = z2542 + z2552;
    const Scalar z2554 = z2547 + z2549;
    const Scalar z2555 = k0 * z2553 - k1 * z2554;
    const Scalar z2556 = s_q7 * z2551 + c_q7 * z2555;
    const Scalar z2557 = z59 * z2453 - z60 * z2470;
    const Scalar z2558 = z922 + z2557;
    const Scalar z2559 = k13 * z2541 - z2556 + k19 * z2558;
    const Scalar z2560 = n2 * z59 * z2470;
    const Scalar z2561 = z2540 + z2560;
    const Scalar z2562 = z922 - z2557;
    const Scalar z2563 = z66 * z2453 + z70 * z2543;
    const Scalar z2564 = c_q6 * z923;
    const Scalar z2565 = v_q6 * z2453 + z2564;
    const Scalar z2566 = s_q7 * z2565 + c_q7 * z922;
    const Scalar z2567 = v_q7 * z2543 - z2566;
    const Scalar z2568 = z2563 + z2567;
    const Scalar z2569 = z67 * z2453 + z70 * z2546;
    const Scalar z2570 = s_q7 * z922 - c_q7 * z2565;
    const Scalar z2571 = v_q7 * z2546 - z2570;
    const Scalar z2572 = z2569 + z2571;
    const Scalar z2573 = k0 * z2568 + k1 * z2572;
    const Scalar z2574 = k19 * z2561 + k13 * z2562 - z2573;
    const Scalar z2575 = s_q6 * z2559 + c_q6 * z2574;
    const Scalar z2576 = k22 * z976 + k21 * z977 - z2575;
    const Scalar z2577 = n2 * z54 * z55;
    const Scalar z2578 = z54 * z59 + z63 * z2470;
    const Scalar z2579 = z2549 + z2578;
    const Scalar z2580 = s_q7 * z2555 - c_q7 * z2551;
    const Scalar z2581 = z54 * z60 - z63 * z2453;
    const Scalar z2582 = z2565 - z2581;
    const Scalar z2583 = k13 * z2579 - z2580 + k19 * z2582;
    const Scalar z2584 = z54 * z54 - z55 * z55;
    const Scalar z2585 = k22 * z2577 - z2583 - k21 * z2584;
    const Scalar z2586 = s_q6 * z2574 - c_q6 * z2559;
    const Scalar z2587 = k21 * z2577 + k22 * z2584 - z2586;
    const Scalar z2588 = s_q5 * (z980 - z2585) - c_q5 * (z981 - z2587);
    const Scalar z2589 = s_q4 * z2576 + c_q4 * z2588;
    const Scalar z2590 = s_q5 * (z981 - z2587) + c_q5 * (z980 - z2585);
    const Scalar z2591 = s_q3 * z2589 - c_q3 * z2590;
    const Scalar z2592 = z2540 - z2560;
    const Scalar z2593 = z2544 - z2552;
    const Scalar z2594 = z920 - n0_088 * z2579;
    const Scalar z2595 = c_q6 * z921;
    const Scalar z2596 = n0_088 * z2541 + z2595;
    const Scalar z2597 = s_q7 * z2594 - c_q7 * z2596;
    const Scalar z2598 = s_q7 * z2596 + c_q7 * z2594;
    const Scalar z2599 = z2569 - z2571;
    const Scalar z2600 = z2563 - z2567;
    const Scalar z2601 = k9 * z2547 + k4 * z2549 - k11 * z2593 - k1 * z2597 - k0 * z2598 - k3 * z2599 - k2 * z2600;
    const Scalar z2602 = k13 * z920 + k17 * z2558 - k53 * z2578 + n0_088 * z2580 - k15 * z2582 - k16 * z2592 - z2601;
    const Scalar z2603 = z2539 + z2540;
    const Scalar z2604 = z2542 - z2544;
    const Scalar z2605 = s_q6 * z921;
    const Scalar z2606 = n0_088 * z2562 - z2605;
    const Scalar z2607 = k2 * z2554 + k52 * z2563 - k11 * z2572 + k3 * z2604 - k0 * z2606;
    const Scalar z2608 = z2542 - z2552;
    const Scalar z2609 = k3 * z2550 + k11 * z2568 - k4 * z2569 - k9 * z2571 + k1 * z2606 + k2 * z2608;
    const Scalar z2610 = s_q7 * z2607 + c_q7 * z2609;
    const Scalar z2611 = k19 * z920 - k16 * z2562 + k14 * z2565 - k15 * z2579 + k18 * z2581 - k17 * z2603 + z2610;
    const Scalar z2612 = s_q6 * z2602 - c_q6 * z2611;
    const Scalar z2613 = k27 * z809 + k23 * z923 - k24 * z977 - k26 * z2577 + k25 * z2584 + z2612;
    const Scalar z2614 = z2539 + z2560;
    const Scalar z2615 = s_q7 * z2609 - c_q7 * z2607;
    const Scalar z2616 = z2565 + z2581;
    const Scalar z2617 = z2549 - z2578;
    const Scalar z2618 = k18 * z922 - k14 * z2557 - n0_088 * z2573 + k19 * z2595 - k13 * z2605 + k15 * z2614 + z2615
        + k16 * z2616 - k17 * z2617;
    const Scalar z2619 = k54 * z811 - k24 * z976 + k25 * z2577 + k26 * z2584 + z2618;
    const Scalar z2620 = s_q5 * (z984 - z2613) + c_q5 * (z983 - z2619);
    const Scalar z2621 = n0_0825 * z2576 - n0_384 * z2588 - z2620;
    const Scalar z2622 = s_q4 * z2588 - c_q4 * z2576;
    const Scalar z2623 = z2621 + n0_0825 * z2622;
    const Scalar z2624 = n2 * z2577;
    const Scalar z2625 = s_q6 * z2611 + c_q6 * z2602;
    const Scalar z2626 = k21 * z920 + k22 * z921 - k26 * z978 + k25 * z979 + k23 * z2584 - k24 * z2624 - z2625;
    const Scalar z2627 = n0_0825 * z2590 - z2626;
    const Scalar z2628 = s_q5 * (z983 - z2619) - c_q5 * (z984 - z2613);
    const Scalar z2629 = n0_384 * z2590 - z2628;
    const Scalar z2630 = s_q4 * z2627 - c_q4 * z2629;
    const Scalar z2631 = s_q3 * z2623 - c_q3 * z2630;
    const Scalar z2632 = n0_316 * z2591 - z2631;
    const Scalar z2633 = s_q4 * z2629 + c_q4 * z2627;
    const Scalar z2634 = n0_0825 * z2590 - z2633;
    const Scalar z2635 = s_q2 * z2632 - c_q2 * z2634;
    const Scalar z2636 = s_q3 * z2499 - c_q3 * z2498;
    const Scalar z2637 = s_q3 * z2533 - c_q3 * z2528;
    const Scalar z2638 = n0_316 * z2636 - z2637;
    const Scalar z2639 = s_q3 * z2590 + c_q3 * z2589;
    const Scalar z2640 = s_q3 * z2630 + c_q3 * z2623;
    const Scalar z2641 = n0_316 * z2639 - z2640;
    const Scalar z2642 = n2 * z63;
    const Scalar z2643 = s_q7 * z67 - c_q7 * z66;
    const Scalar z2644 = z59 - z2643;
    const Scalar z2645 = n2 * s_q7 * z66;
    const Scalar z2646 = k0 * z2644 + k1 * z2645;
    const Scalar z2647 = n2 * c_q7 * z67;
    const Scalar z2648 = z59 + z2643;
    const Scalar z2649 = k0 * z2647 + k1 * z2648;
    const Scalar z2650 = s_q7 * z2646 - c_q7 * z2649;
    const Scalar z2651 = k13 * z2642 + z2650;
    const Scalar z2652 = s_q7 * z60;
    const Scalar z2653 = v_q7 * s_q7 + z2652;
    const Scalar z2654 = s_q7 * z70;
    const Scalar z2655 = z2653 + z2654;
    const Scalar z2656 = c_q7 * z60;
    const Scalar z2657 = v_q7 * c_q7 + z2656;
    const Scalar z2658 = c_q7 * z70;
    const Scalar z2659 = z2657 + z2658;
    const Scalar z2660 = k0 * z2655 - k1 * z2659;
    const Scalar z2661 = k19 * z2642 - z2660;
    const Scalar z2662 = s_q6 * z2651 - c_q6 * z2661;
    const Scalar z2663 = n2 * z59;
    const Scalar z2664 = s_q7 * z2649 + c_q7 * z2646;
    const Scalar z2665 = n2 * z60;
    const Scalar z2666 = k13 * z2663 + z2664 - k19 * z2665;
    const Scalar z2667 = s_q6 * z2661 + c_q6 * z2651;
    const Scalar z2668 = s_q5 * z2666 - c_q5 * z2667;
    const Scalar z2669 = s_q4 * z2662 + c_q4 * z2668;
    const Scalar z2670 = s_q5 * z2667 + c_q5 * z2666;
    const Scalar z2671 = s_q3 * z2669 - c_q3 * z2670;
    const Scalar z2672 = n0_088 * z2663;
    const Scalar z2673 = n0_088 * z2642;
    const Scalar z2674 = s_q7 * z2672 - c_q7 * z2673;
    const Scalar z2675 = s_q7 * z2673 + c_q7 * z2672;
    const Scalar z2676 = z2657 - z2658;
    const Scalar z2677 = z2653 - z2654;
    const Scalar z2678 = z2645 + z2647;
    const Scalar z2679 = k4 * z59 + k9 * z2643 + k1 * z2674 + k0 * z2675 - k3 * z2676 + k2 * z2677 - k11 * z2678;
    const Scalar z2680 = k53 * z59 + k16 * z2642 + n0_088 * z2664 - k15 * z2665 + z2679;
    const Scalar z2681 = k3 * z2645 - k2 * z2648 - k52 * z2654 - k11 * z2659;
    const Scalar z2682 = k3 * z2644 - k2 * z2647 - k11 * z2655 - k9 * z2657 - k4 * z2658;
    const Scalar z2683 = s_q7 * z2681 + c_q7 * z2682;
    const Scalar z2684 = k66 * z60 - k17 * z2642 - k15 * z2663 - z2683;
    const Scalar z2685 = s_q6 * z2680 + c_q6 * z2684;
    const Scalar z2686 = s_q7 * z2682 - c_q7 * z2681;
    const Scalar z2687 = n0_088 * z2660 + z2686;
    const Scalar z2688 = s_q5 * z2685 + c_q5 * z2687;
    const Scalar z2689 = n0_0825 * z2662 - n0_384 * z2668 - z2688;
    const Scalar z2690 = s_q4 * z2668 - c_q4 * z2662;
    const Scalar z2691 = z2689 + n0_0825 * z2690;
    const Scalar z2692 = s_q6 * z2684 - c_q6 * z2680;
    const Scalar z2693 = n0_0825 * z2670 + z2692;
    const Scalar z2694 = s_q5 * z2687 - c_q5 * z2685;
    const Scalar z2695 = n0_384 * z2670 - z2694;
    const Scalar z2696 = s_q4 * z2693 - c_q4 * z2695;
    const Scalar z2697 = s_q3 * z2691 - c_q3 * z2696;
    const Scalar z2698 = n0_316 * z2671 - z2697;
    const Scalar z2699 = s_q4 * z2695 + c_q4 * z2693;
    const Scalar z2700 = n0_0825 * z2670 - z2699;
    const Scalar z2701 = s_q2 * z2698 - c_q2 * z2700;
    const Scalar z2702 = n2 * z59 * z60;
    const Scalar z2703 = n2 * z59 * z70;
    const Scalar z2704 = n2 * z66 * z2656;
    const Scalar z2705 = z2703 + z2704;
    const Scalar z2706 = z66 * z2652 + z67 * z2656;
    const Scalar z2707 = z929 - z2706;
    const Scalar z2708 = k1 * z2705 + k0 * z2707;
    const Scalar z2709 = n2 * z67 * z2652;
    const Scalar z2710 = z2703 + z2709;
    const Scalar z2711 = z929 + z2706;
    const Scalar z2712 = k0 * z2710 - k1 * z2711;
    const Scalar z2713 = s_q7 * z2708 + c_q7 * z2712;
    const Scalar z2714 = z59 * z59 - z60 * z60;
    const Scalar z2715 = k13 * z2702 - z2713 + k19 * z2714;
    const Scalar z2716 = z59 * z66 + z70 * z2656;
    const Scalar z2717 = s_q7 * z930;
    const Scalar z2718 = v_q7 * z2656 - z2717;
    const Scalar z2719 = z2716 + z2718;
    const Scalar z2720 = z59 * z67 + z70 * z2652;
    const Scalar z2721 = c_q7 * z930;
    const Scalar z2722 = v_q7 * z2652 + z2721;
    const Scalar z2723 = z2720 + z2722;
    const Scalar z2724 = k0 * z2719 + k1 * z2723;
    const Scalar z2725 = k19 * z2702 - k13 * z2714 - z2724;
    const Scalar z2726 = s_q6 * (z965 - z2715) + c_q6 * (z964 - z2725);
    const Scalar z2727 = s_q7 * z2712 - c_q7 * z2708;
    const Scalar z2728 = k19 * z933 + k13 * z961 - z2727;
    const Scalar z2729 = s_q6 * (z964 - z2725) - c_q6 * (z965 - z2715);
    const Scalar z2730 = s_q5 * z2728 + c_q5 * z2729;
    const Scalar z2731 = s_q4 * z2726 + c_q4 * z2730;
    const Scalar z2732 = s_q5 * z2729 - c_q5 * z2728;
    const Scalar z2733 = s_q3 * z2731 + c_q3 * z2732;
    const Scalar z2734 = z2704 - z2709;
    const Scalar z2735 = n0_088 * z961;
    const Scalar z2736 = z928 - n0_088 * z2702;
    const Scalar z2737 = s_q7 * z2735 - c_q7 * z2736;
    const Scalar z2738 = s_q7 * z2736 + c_q7 * z2735;
    const Scalar z2739 = z2720 - z2722;
    const Scalar z2740 = z2716 - z2718;
    const Scalar z2741 = k4 * z929 + k9 * z2706 - k11 * z2734 + k1 * z2737 + k0 * z2738 - k3 * z2739 - k2 * z2740;
    const Scalar z2742 = k53 * z784 + k15 * z933 - k16 * z2702 - k17 * z2714 - n0_088 * z2727 + z2741;
    const Scalar z2743 = z2703 - z2704;
    const Scalar z2744 = z927 - n0_088 * z2714;
    const Scalar z2745 = k2 * z2711 + k52 * z2716 - k11 * z2723 + k3 * z2743 - k0 * z2744;
    const Scalar z2746 = z2703 - z2709;
    const Scalar z2747 = k3 * z2707 - k11 * z2719 + k4 * z2720 + k9 * z2722 - k1 * z2744 - k2 * z2746;
    const Scalar z2748 = s_q7 * z2745 - c_q7 * z2747;
    const Scalar z2749 = k18 * z743 - k14 * z930 + k15 * z961 + k17 * z2702 - k16 * z2714 - z2748;
    const Scalar z2750 = s_q6 * (z967 - z2742) - c_q6 * (z968 - z2749);
    const Scalar z2751 = n2 * z2702;
    const Scalar z2752 = s_q7 * z2747 + c_q7 * z2745;
    const Scalar z2753 = k13 * z927 - k19 * z928 + k17 * z962 - k16 * z963 - k14 * z2714 - n0_088 * z2724 + k15 * z2751
        - z2752;
    const Scalar z2754 = s_q5 * z2750 + c_q5 * z2753;
    const Scalar z2755 = n0_0825 * z2726 - n0_384 * z2730 + z2754;
    const Scalar z2756 = s_q4 * z2730 - c_q4 * z2726;
    const Scalar z2757 = z2755 + n0_0825 * z2756;
    const Scalar z2758 = s_q6 * (z968 - z2749) + c_q6 * (z967 - z2742);
    const Scalar z2759 = n0_0825 * z2732 - z2758;
    const Scalar z2760 = s_q5 * z2753 - c_q5 * z2750;
    const Scalar z2761 = n0_384 * z2732 - z2760;
    const Scalar z2762 = s_q4 * z2759 - c_q4 * z2761;
    const Scalar z2763 = s_q3 * z2757 + c_q3 * z2762;
    const Scalar z2764 = n0_316 * z2733 - z2763;
    const Scalar z2765 = s_q4 * z2761 + c_q4 * z2759;
    const Scalar z2766 = n0_0825 * z2732 - z2765;
    const Scalar z2767 = s_q2 * z2764 + c_q2 * z2766;
    const Scalar z2768 = s_q3 * z2670 + c_q3 * z2669;
    const Scalar z2769 = s_q3 * z2696 + c_q3 * z2691;
    const Scalar z2770 = n0_316 * z2768 - z2769;
    const Scalar z2771 = s_q3 * z2732 - c_q3 * z2731;
    const Scalar z2772 = s_q3 * z2762 - c_q3 * z2757;
    const Scalar z2773 = n0_316 * z2771 - z2772;
    const Scalar z2774 = n2 * z70;
    const Scalar z2775 = k1 * z2774;
    const Scalar z2776 = k0 * z2774;
    const Scalar z2777 = s_q7 * z2775 + c_q7 * z2776;
    const Scalar z2778 = n2 * z66;
    const Scalar z2779 = n2 * z67;
    const Scalar z2780 = k0 * z2778 + k1 * z2779;
    const Scalar z2781 = s_q6 * z2777 + c_q6 * z2780;
    const Scalar z2782 = s_q7 * z2776 - c_q7 * z2775;
    const Scalar z2783 = s_q6 * z2780 - c_q6 * z2777;
    const Scalar z2784 = s_q5 * z2782 - c_q5 * z2783;
    const Scalar z2785 = s_q4 * z2781 - c_q4 * z2784;
    const Scalar z2786 = s_q5 * z2783 + c_q5 * z2782;
    const Scalar z2787 = s_q3 * z2785 + c_q3 * z2786;
    const Scalar z2788 = n0_088 * z2782;
    const Scalar z2789 = k52 * z66 + k3 * z2774 - k11 * z2779;
    const Scalar z2790 = k67 * z67 - k2 * z2774 - k11 * z2778;
    const Scalar z2791 = s_q7 * z2789 - c_q7 * z2790;
    const Scalar z2792 = s_q6 * z2788 - c_q6 * z2791;
    const Scalar z2793 = s_q7 * z2790 + c_q7 * z2789;
    const Scalar z2794 = n0_088 * z2780 + z2793;
    const Scalar z2795 = s_q5 * z2792 - c_q5 * z2794;
    const Scalar z2796 = n0_0825 * z2781 + n0_384 * z2784 + z2795;
    const Scalar z2797 = s_q4 * z2784 + c_q4 * z2781;
    const Scalar z2798 = z2796 - n0_0825 * z2797;
    const Scalar z2799 = s_q6 * z2791 + c_q6 * z2788;
    const Scalar z2800 = n0_0825 * z2786 - z2799;
    const Scalar z2801 = s_q5 * z2794 + c_q5 * z2792;
    const Scalar z2802 = n0_384 * z2786 + z2801;
    const Scalar z2803 = s_q4 * z2800 - c_q4 * z2802;
    const Scalar z2804 = s_q3 * z2798 + c_q3 * z2803;
    const Scalar z2805 = n0_316 * z2787 - z2804;
    const Scalar z2806 = s_q4 * z2802 + c_q4 * z2800;
    const Scalar z2807 = n0_0825 * z2786 - z2806;
    const Scalar z2808 = s_q2 * z2805 + c_q2 * z2807;
    const Scalar z2809 = n2 * z66 * z67;
    const Scalar z2810 = z66 * z66 - z67 * z67;
    const Scalar z2811 = k1 * z2809 + k0 * z2810;
    const Scalar z2812 = k0 * z2809 - k1 * z2810;
    const Scalar z2813 = s_q7 * (z950 + z2811) - c_q7 * (z951 + z2812);
    const Scalar z2814 = k1 * z946 - k0 * z947;
    const Scalar z2815 = s_q6 * z2813 - c_q6 * z2814;
    const Scalar z2816 = s_q7 * (z951 + z2812) + c_q7 * (z950 + z2811);
    const Scalar z2817 = s_q6 * z2814 + c_q6 * z2813;
    const Scalar z2818 = s_q5 * z2816 - c_q5 * z2817;
    const Scalar z2819 = s_q4 * z2815 + c_q4 * z2818;
    const Scalar z2820 = s_q5 * z2817 + c_q5 * z2816;
    const Scalar z2821 = s_q3 * z2819 - c_q3 * z2820;
    const Scalar z2822 = n2 * z2809;
    const Scalar z2823 = k0 * z939 - k1 * z940 - k2 * z948 + k3 * z949 - k9 * z2810 - k11 * z2822;
    const Scalar z2824 = n0_088 * z2816 + z2823;
    const Scalar z2825 = k52 * z764 + k11 * z946 - k3 * z2809 - k2 * z2810;
    const Scalar z2826 = k4 * z762 + k9 * z942 + k11 * z947 + k2 * z2809 - k3 * z2810;
    const Scalar z2827 = s_q7 * (z953 - z2825) + c_q7 * (z954 - z2826);
    const Scalar z2828 = s_q6 * z2824 - c_q6 * z2827;
    const Scalar z2829 = s_q7 * (z954 - z2826) - c_q7 * (z953 - z2825);
    const Scalar z2830 = n0_088 * z2814 - z2829;
    const Scalar z2831 = s_q5 * z2828 - c_q5 * z2830;
    const Scalar z2832 = n0_0825 * z2815 - n0_384 * z2818 - z2831;
    const Scalar z2833 = s_q4 * z2818 - c_q4 * z2815;
    const Scalar z2834 = z2832 + n0_0825 * z2833;
    const Scalar z2835 = s_q6 * z2827 + c_q6 * z2824;
    const Scalar z2836 = n0_0825 * z2820 - z2835;
    const Scalar z2837 = s_q5 * z2830 + c_q5 * z2828;
    const Scalar z2838 = n0_384 * z2820 + z2837;
    const Scalar z2839 = s_q4 * z2836 - c_q4 * z2838;
    const Scalar z2840 = s_q3 * z2834 - c_q3 * z2839;
    const Scalar z2841 = n0_316 * z2821 - z2840;
    const Scalar z2842 = s_q4 * z2838 + c_q4 * z2836;
    const Scalar z2843 = n0_0825 * z2820 - z2842;
    const Scalar z2844 = s_q2 * z2841 - c_q2 * z2843;
    const Scalar z2845 = s_q3 * z2786 - c_q3 * z2785;
    const Scalar z2846 = s_q3 * z2803 - c_q3 * z2798;
    const Scalar z2847 = n0_316 * z2845 - z2846;
    const Scalar z2848 = s_q3 * z2820 + c_q3 * z2819;
    const Scalar z2849 = s_q3 * z2839 + c_q3 * z2834;
    const Scalar z2850 = n0_316 * z2848 - z2849;
    const Scalar z2851 = z1047 * z1447 + z1466;
    const Scalar z2852 = z1046 * z1447 - z1074 * z2851 + z1483;
    const Scalar z2853 = z1045 * z1447 - z1073 * z2851 - z1094 * z2852 + z1473;
    const Scalar z2854 = z1044 * z1447 - z1072 * z2851 - z1093 * z2852 - z1108 * z2853 - z1500;
    const Scalar z2855 = z1043 * z1447 - z1071 * z2851 - z1092 * z2852 - z1107 * z2853 - z1117 * z2854 + z1506;
    const Scalar z2856 = z1042 * z1447 - z1070 * z2851 - z1091 * z2852 - z1106 * z2853 - z1116 * z2854 - z1122 * z2855
        - z1502;
    const Scalar z2857 = z1124 * z2856;
    const Scalar z2858 = z1121 * z2855 - z1122 * z2857;
    const Scalar z2859 = z1115 * z2854 - z1116 * z2857 - z1117 * z2858;
    const Scalar z2860 = z1105 * z2853 - z1106 * z2857 - z1107 * z2858 - z1108 * z2859;
    const Scalar z2861 = z1090 * z2852 - z1091 * z2857 - z1092 * z2858 - z1093 * z2859 - z1094 * z2860;
    const Scalar z2862 = z1069 * z2851 - z1070 * z2857 - z1071 * z2858 - z1072 * z2859 - z1073 * z2860 - z1074 * z2861;
    const Scalar z2863 = z1042 * z2857 + z1043 * z2858 + z1044 * z2859 + z1045 * z2860 + z1046 * z2861 + z1047 * z2862
        - k60 * z1447;
    const Scalar z2864 = z1047 * z1824 - z1842;
    const Scalar z2865 = z1046 * z1824 - z1074 * z2864 - z1858;
    const Scalar z2866 = z1045 * z1824 - z1073 * z2864 - z1094 * z2865 + z1847;
    const Scalar z2867 = z1044 * z1824 - z1072 * z2864 - z1093 * z2865 - z1108 * z2866 - z1871;
    const Scalar z2868 = z1043 * z1824 - z1071 * z2864 - z1092 * z2865 - z1107 * z2866 - z1117 * z2867 + z1880;
    const Scalar z2869 = z1042 * z1824 - z1070 * z2864 - z1091 * z2865 - z1106 * z2866 - z1116 * z2867 - z1122 * z2868
        - z1873;
    const Scalar z2870 = z1124 * z2869;
    const Scalar z2871 = z1121 * z2868 - z1122 * z2870;
    const Scalar z2872 = z1115 * z2867 - z1116 * z2870 - z1117 * z2871;
    const Scalar z2873 = z1105 * z2866 - z1106 * z2870 - z1107 * z2871 - z1108 * z2872;
    const Scalar z2874 = z1090 * z2865 - z1091 * z2870 - z1092 * z2871 - z1093 * z2872 - z1094 * z2873;
    const Scalar z2875 = z1069 * z2864 - z1070 * z2870 - z1071 * z2871 - z1072 * z2872 - z1073 * z2873 - z1074 * z2874;
    const Scalar z2876 = z1042 * z2870 + z1043 * z2871 + z1044 * z2872 + z1045 * z2873 + z1046 * z2874 + z1047 * z2875
        - k60 * z1824;
    const Scalar z2877 = z1047 * z1634 - z1653;
    const Scalar z2878 = z1046 * z1634 - z1074 * z2877 - z1669;
    const Scalar z2879 = z1045 * z1634 - z1073 * z2877 - z1094 * z2878 + z1660;
    const Scalar z2880 = z1044 * z1634 - z1072 * z2877 - z1093 * z2878 - z1108 * z2879 + z1684;
    const Scalar z2881 = z1043 * z1634 - z1071 * z2877 - z1092 * z2878 - z1107 * z2879 - z1117 * z2880 + z1876;
    const Scalar z2882 = z1042 * z1634 - z1070 * z2877 - z1091 * z2878 - z1106 * z2879 - z1116 * z2880 - z1122 * z2881
        + z1686;
    const Scalar z2883 = z1124 * z2882;
    const Scalar z2884 = z1121 * z2881 - z1122 * z2883;
    const Scalar z2885 = z1115 * z2880 - z1116 * z2883 - z1117 * z2884;
    const Scalar z2886 = z1105 * z2879 - z1106 * z2883 - z1107 * z2884 - z1108 * z2885;
    const Scalar z2887 = z1090 * z2878 - z1091 * z2883 - z1092 * z2884 - z1093 * z2885 - z1094 * z2886;
    const Scalar z2888 = z1069 * z2877 - z1070 * z2883 - z1071 * z2884 - z1072 * z2885 - z1073 * z2886 - z1074 * z2887;
    const Scalar z2889 = z1042 * z2883 + z1043 * z2884 + z1044 * z2885 + z1045 * z2886 + z1046 * z2887 + z1047 * z2888
        - k60 * z1634;
    const Scalar z2890 = z1047 * z2147 - z2165;
    const Scalar z2891 = z1046 * z2147 - z1074 * z2890 - z2178;
    const Scalar z2892 = z1045 * z2147 - z1073 * z2890 - z1094 * z2891 + z2170;
    const Scalar z2893 = z1044 * z2147 - z1072 * z2890 - z1093 * z2891 - z1108 * z2892 + z2189;
    const Scalar z2894 = z1043 * z2147 - z1071 * z2890 - z1092 * z2891 - z1107 * z2892 - z1117 * z2893 + z2196;
    const Scalar z2895 = z1042 * z2147 - z1070 * z2890 - z1091 * z2891 - z1106 * z2892 - z1116 * z2893 - z1122 * z2894
        + z2190;
    const Scalar z2896 = z1124 * z2895;
    const Scalar z2897 = z1121 * z2894 - z1122 * z2896;
    const Scalar z2898 = z1115 * z2893 - z1116 * z2896 - z1117 * z2897;
    const Scalar z2899 = z1105 * z2892 - z1106 * z2896 - z1107 * z2897 - z1108 * z2898;
    const Scalar z2900 = z1090 * z2891 - z1091 * z2896 - z1092 * z2897 - z1093 * z2898 - z1094 * z2899;
    const Scalar z2901 = z1069 * z2890 - z1070 * z2896 - z1071 * z2897 - z1072 * z2898 - z1073 * z2899 - z1074 * z2900;
    const Scalar z2902 = z1042 * z2896 + z1043 * z2897 + z1044 * z2898 + z1045 * z2899 + z1046 * z2900 + z1047 * z2901
        - k60 * z2147;
    const Scalar z2903 = z1047 * z1987 + z2006;
    const Scalar z2904 = z1046 * z1987 - z1074 * z2903 + z2021;
    const Scalar z2905 = z1045 * z1987 - z1073 * z2903 - z1094 * z2904 - z2013;
    const Scalar z2906 = z1044 * z1987 - z1072 * z2903 - z1093 * z2904 - z1108 * z2905 + z2030;
    const Scalar z2907 = z1043 * z1987 - z1071 * z2903 - z1092 * z2904 - z1107 * z2905 - z1117 * z2906 - z2193;
    const Scalar z2908 = z1042 * z1987 - z1070 * z2903 - z1091 * z2904 - z1106 * z2905 - z1116 * z2906 - z1122 * z2907
        + z2031;
    const Scalar z2909 = z1124 * z2908;
    const Scalar z2910 = z1121 * z2907 - z1122 * z2909;
    const Scalar z2911 = z1115 * z2906 - z1116 * z2909 - z1117 * z2910;
    const Scalar z2912 = z1105 * z2905 - z1106 * z2909 - z1107 * z2910 - z1108 * z2911;
    const Scalar z2913 = z1090 * z2904 - z1091 * z2909 - z1092 * z2910 - z1093 * z2911 - z1094 * z2912;
    const Scalar z2914 = z1069 * z2903 - z1070 * z2909 - z1071 * z2910 - z1072 * z2911 - z1073 * z2912 - z1074 * z2913;
    const Scalar z2915 = z1042 * z2909 + z1043 * z2910 + z1044 * z2911 + z1045 * z2912 + z1046 * z2913 + z1047 * z2914
        - k60 * z1987;
    const Scalar z2916 = z1047 * z2408 - z2426;
    const Scalar z2917 = z1046 * z2408 - z1074 * z2916 + z2436;
    const Scalar z2918 = z1045 * z2408 - z1073 * z2916 - z1094 * z2917 + z2429;
    const Scalar z2919 = z1044 * z2408 - z1072 * z2916 - z1093 * z2917 - z1108 * z2918 - z2444;
    const Scalar z2920 = z1043 * z2408 - z1071 * z2916 - z1092 * z2917 - z1107 * z2918 - z1117 * z2919 - z2451;
    const Scalar z2921 = z1042 * z2408 - z1070 * z2916 - z1091 * z2917 - z1106 * z2918 - z1116 * z2919 - z1122 * z2920
        - z2445;
    const Scalar z2922 = z1124 * z2921;
    const Scalar z2923 = z1121 * z2920 - z1122 * z2922;
    const Scalar z2924 = z1115 * z2919 - z1116 * z2922 - z1117 * z2923;
    const Scalar z2925 = z1105 * z2918 - z1106 * z2922 - z1107 * z2923 - z1108 * z2924;
    const Scalar z2926 = z1090 * z2917 - z1091 * z2922 - z1092 * z2923 - z1093 * z2924 - z1094 * z2925;
    const Scalar z2927 = z1069 * z2916 - z1070 * z2922 - z1071 * z2923 - z1072 * z2924 - z1073 * z2925 - z1074 * z2926;
    const Scalar z2928 = z1042 * z2922 + z1043 * z2923 + z1044 * z2924 + z1045 * z2925 + z1046 * z2926 + z1047 * z2927
        - k60 * z2408;
    const Scalar z2929 = z1047 * z2280 + z2298;
    const Scalar z2930 = z1046 * z2280 - z1074 * z2929 - z2308;
    const Scalar z2931 = z1045 * z2280 - z1073 * z2929 - z1094 * z2930 + z2301;
    const Scalar z2932 = z1044 * z2280 - z1072 * z2929 - z1093 * z2930 - z1108 * z2931 - z2316;
    const Scalar z2933 = z1043 * z2280 - z1071 * z2929 - z1092 * z2930 - z1107 * z2931 - z1117 * z2932 - z2448;
    const Scalar z2934 = z1042 * z2280 - z1070 * z2929 - z1091 * z2930 - z1106 * z2931 - z1116 * z2932 - z1122 * z2933
        + z2317;
    const Scalar z2935 = z1124 * z2934;
    const Scalar z2936 = z1121 * z2933 - z1122 * z2935;
    const Scalar z2937 = z1115 * z2932 - z1116 * z2935 - z1117 * z2936;
    const Scalar z2938 = z1105 * z2931 - z1106 * z2935 - z1107 * z2936 - z1108 * z2937;
    const Scalar z2939 = z1090 * z2930 - z1091 * z2935 - z1092 * z2936 - z1093 * z2937 - z1094 * z2938;
    const Scalar z2940 = z1069 * z2929 - z1070 * z2935 - z1071 * z2936 - z1072 * z2937 - z1073 * z2938 - z1074 * z2939;
    const Scalar z2941 = z1042 * z2935 + z1043 * z2936 + z1044 * z2937 + z1045 * z2938 + z1046 * z2939 + z1047 * z2940
        - k60 * z2280;
    const Scalar z2942 = z1047 * z2601 + z2618;
    const Scalar z2943 = z1046 * z2601 - z1074 * z2942 + z2626;
    const Scalar z2944 = z1045 * z2601 - z1073 * z2942 - z1094 * z2943 - z2621;
    const Scalar z2945 = z1044 * z2601 - z1072 * z2942 - z1093 * z2943 - z1108 * z2944 - z2634;
    const Scalar z2946 = z1043 * z2601 - z1071 * z2942 - z1092 * z2943 - z1107 * z2944 - z1117 * z2945 - z2641;
    const Scalar z2947 = z1042 * z2601 - z1070 * z2942 - z1091 * z2943 - z1106 * z2944 - z1116 * z2945 - z1122 * z2946
        - z2635;
    const Scalar z2948 = z1124 * z2947;
    const Scalar z2949 = z1121 * z2946 - z1122 * z2948;
    const Scalar z2950 = z1115 * z2945 - z1116 * z2948 - z1117 * z2949;
    const Scalar z2951 = z1105 * z2944 - z1106 * z2948 - z1107 * z2949 - z1108 * z2950;
    const Scalar z2952 = z1090 * z2943 - z1091 * z2948 - z1092 * z2949 - z1093 * z2950 - z1094 * z2951;
    const Scalar z2953 = z1069 * z2942 - z1070 * z2948 - z1071 * z2949 - z1072 * z2950 - z1073 * z2951 - z1074 * z2952;
    const Scalar z2954 = z1042 * z2948 + z1043 * z2949 + z1044 * z2950 + z1045 * z2951 + z1046 * z2952 + z1047 * z2953
        - k60 * z2601;
    const Scalar z2955 = z1047 * z2508 - z2523;
    const Scalar z2956 = z1046 * z2508 - z1074 * z2955 - z2529;
    const Scalar z2957 = z1045 * z2508 - z1073 * z2955 - z1094 * z2956 - z2526;
    const Scalar z2958 = z1044 * z2508 - z1072 * z2955 - z1093 * z2956 - z1108 * z2957 + z2537;
    const Scalar z2959 = z1043 * z2508 - z1071 * z2955 - z1092 * z2956 - z1107 * z2957 - z1117 * z2958 + z2638;
    const Scalar z2960 = z1042 * z2508 - z1070 * z2955 - z1091 * z2956 - z1106 * z2957 - z1116 * z2958 - z1122 * z2959
        - z2538;
    const Scalar z2961 = z1124 * z2960;
    const Scalar z2962 = z1121 * z2959 - z1122 * z2961;
    const Scalar z2963 = z1115 * z2958 - z1116 * z2961 - z1117 * z2962;
    const Scalar z2964 = z1105 * z2957 - z1106 * z2961 - z1107 * z2962 - z1108 * z2963;
    const Scalar z2965 = z1090 * z2956 - z1091 * z2961 - z1092 * z2962 - z1093 * z2963 - z1094 * z2964;
    const Scalar z2966 = z1069 * z2955 - z1070 * z2961 - z1071 * z2962 - z1072 * z2963 - z1073 * z2964 - z1074 * z2965;
    const Scalar z2967 = z1042 * z2961 + z1043 * z2962 + z1044 * z2963 + z1045 * z2964 + z1046 * z2965 + z1047 * z2966
        - k60 * z2508;
    const Scalar z2968 = z1047 * z2741 + z2753;
    const Scalar z2969 = z1046 * z2741 - z1074 * z2968 - z2758;
    const Scalar z2970 = z1045 * z2741 - z1073 * z2968 - z1094 * z2969 - z2755;
    const Scalar z2971 = z1044 * z2741 - z1072 * z2968 - z1093 * z2969 - z1108 * z2970 + z2766;
    const Scalar z2972 = z1043 * z2741 - z1071 * z2968 - z1092 * z2969 - z1107 * z2970 - z1117 * z2971 + z2773;
    const Scalar z2973 = z1042 * z2741 - z1070 * z2968 - z1091 * z2969 - z1106 * z2970 - z1116 * z2971 - z1122 * z2972
        - z2767;
    const Scalar z2974 = z1124 * z2973;
    const Scalar z2975 = z1121 * z2972 - z1122 * z2974;
    const Scalar z2976 = z1115 * z2971 - z1116 * z2974 - z1117 * z2975;
    const Scalar z2977 = z1105 * z2970 - z1106 * z2974 - z1107 * z2975 - z1108 * z2976;
    const Scalar z2978 = z1090 * z2969 - z1091 * z2974 - z1092 * z2975 - z1093 * z2976 - z1094 * z2977;
    const Scalar z2979 = z1069 * z2968 - z1070 * z2974 - z1071 * z2975 - z1072 * z2976 - z1073 * z2977 - z1074 * z2978;
    const Scalar z2980 = z1042 * z2974 + z1043 * z2975 + z1044 * z2976 + z1045 * z2977 + z1046 * z2978 + z1047 * z2979
        - k60 * z2741;
    const Scalar z2981 = z1047 * z2679 - z2687;
    const Scalar z2982 = z1046 * z2679 - z1074 * z2981 - z2692;
    const Scalar z2983 = z1045 * z2679 - z1073 * z2981 - z1094 * z2982 - z2689;
    const Scalar z2984 = z1044 * z2679 - z1072 * z2981 - z1093 * z2982 - z1108 * z2983 - z2700;
    const Scalar z2985 = z1043 * z2679 - z1071 * z2981 - z1092 * z2982 - z1107 * z2983 - z1117 * z2984 - z2770;
    const Scalar z2986 = z1042 * z2679 - z1070 * z2981 - z1091 * z2982 - z1106 * z2983 - z1116 * z2984 - z1122 * z2985
        - z2701;
    const Scalar z2987 = z1124 * z2986;
    const Scalar z2988 = z1121 * z2985 - z1122 * z2987;
    const Scalar z2989 = z1115 * z2984 - z1116 * z2987 - z1117 * z2988;
    const Scalar z2990 = z1105 * z2983 - z1106 * z2987 - z1107 * z2988 - z1108 * z2989;
    const Scalar z2991 = z1090 * z2982 - z1091 * z2987 - z1092 * z2988 - z1093 * z2989 - z1094 * z2990;
    const Scalar z2992 = z1069 * z2981 - z1070 * z2987 - z1071 * z2988 - z1072 * z2989 - z1073 * z2990 - z1074 * z2991;
    const Scalar z2993 = z1042 * z2987 + z1043 * z2988 + z1044 * z2989 + z1045 * z2990 + z1046 * z2991 + z1047 * z2992
        - k60 * z2679;
    const Scalar z2994 = z1047 * z2823 + z2830;
    const Scalar z2995 = z1046 * z2823 - z1074 * z2994 + z2835;
    const Scalar z2996 = z1045 * z2823 - z1073 * z2994 - z1094 * z2995 - z2832;
    const Scalar z2997 = z1044 * z2823 - z1072 * z2994 - z1093 * z2995 - z1108 * z2996 - z2843;
    const Scalar z2998 = z1043 * z2823 - z1071 * z2994 - z1092 * z2995 - z1107 * z2996 - z1117 * z2997 - z2850;
    const Scalar z2999 = z1042 * z2823 - z1070 * z2994 - z1091 * z2995 - z1106 * z2996 - z1116 * z2997 - z1122 * z2998
        - z2844;
    const Scalar z3000 = z1124 * z2999;
    const Scalar z3001 = z1121 * z2998 - z1122 * z3000;
    const Scalar z3002 = z1115 * z2997 - z1116 * z3000 - z1117 * z3001;
    const Scalar z3003 = z1105 * z2996 - z1106 * z3000 - z1107 * z3001 - z1108 * z3002;
    const Scalar z3004 = z1090 * z2995 - z1091 * z3000 - z1092 * z3001 - z1093 * z3002 - z1094 * z3003;
    const Scalar z3005 = z1069 * z2994 - z1070 * z3000 - z1071 * z3001 - z1072 * z3002 - z1073 * z3003 - z1074 * z3004;
    const Scalar z3006 = z1042 * z3000 + z1043 * z3001 + z1044 * z3002 + z1045 * z3003 + z1046 * z3004 + z1047 * z3005
        - k60 * z2823;
    const Scalar z3007 = z1074 * z2794 - z2799;
    const Scalar z3008 = z1073 * z2794 - z1094 * z3007 - z2796;
    const Scalar z3009 = z1072 * z2794 - z1093 * z3007 - z1108 * z3008 + z2807;
    const Scalar z3010 = z1071 * z2794 - z1092 * z3007 - z1107 * z3008 - z1117 * z3009 + z2847;
    const Scalar z3011 = z1070 * z2794 - z1091 * z3007 - z1106 * z3008 - z1116 * z3009 - z1122 * z3010 - z2808;
    const Scalar z3012 = z1124 * z3011;
    const Scalar z3013 = z1121 * z3010 - z1122 * z3012;
    const Scalar z3014 = z1115 * z3009 - z1116 * z3012 - z1117 * z3013;
    const Scalar z3015 = z1105 * z3008 - z1106 * z3012 - z1107 * z3013 - z1108 * z3014;
    const Scalar z3016 = z1090 * z3007 - z1091 * z3012 - z1092 * z3013 - z1093 * z3014 - z1094 * z3015;
    const Scalar z3017 = z1069 * z2794 + z1070 * z3012 + z1071 * z3013 + z1072 * z3014 + z1073 * z3015 + z1074 * z3016;
    const Scalar z3018 = z1042 * z3012 + z1043 * z3013 + z1044 * z3014 + z1045 * z3015 + z1046 * z3016 - z1047 * z3017;
    const Scalar z3019 = z1122 * z1124;
    const Scalar z3020 = z1116 * z1124 - z1117 * z3019;
    const Scalar z3021 = z1106 * z1124 - z1107 * z3019 - z1108 * z3020;
    const Scalar z3022 = z1091 * z1124 - z1092 * z3019 - z1093 * z3020 - z1094 * z3021;
    const Scalar z3023 = z1070 * z1124 - z1071 * z3019 - z1072 * z3020 - z1073 * z3021 - z1074 * z3022;
    const Scalar z3024 = z1042 * z1124 - z1043 * z3019 - z1044 * z3020 - z1045 * z3021 - z1046 * z3022 - z1047 * z3023;
    const Scalar z3025 = z1121 + z1122 * z3019;
    const Scalar z3026 = z1116 * z3019 - z1117 * z3025;
    const Scalar z3027 = z1106 * z3019 - z1107 * z3025 - z1108 * z3026;
    const Scalar z3028 = z1091 * z3019 - z1092 * z3025 - z1093 * z3026 - z1094 * z3027;
    const Scalar z3029 = z1070 * z3019 - z1071 * z3025 - z1072 * z3026 - z1073 * z3027 - z1074 * z3028;
    const Scalar z3030 = z1042 * z3019 - z1043 * z3025 - z1044 * z3026 - z1045 * z3027 - z1046 * z3028 - z1047 * z3029;
    const Scalar z3031 = z1116 - z1117 * z1122;
    const Scalar z3032 = z1124 * z3031;
    const Scalar z3033 = z1117 * z1121 - z1122 * z3032;
    const Scalar z3034 = z1115 + z1116 * z3032 + z1117 * z3033;
    const Scalar z3035 = z1106 * z3032 + z1107 * z3033 - z1108 * z3034;
    const Scalar z3036 = z1091 * z3032 + z1092 * z3033 - z1093 * z3034 - z1094 * z3035;
    const Scalar z3037 = z1070 * z3032 + z1071 * z3033 - z1072 * z3034 - z1073 * z3035 - z1074 * z3036;
    const Scalar z3038 = z1042 * z3032 + z1043 * z3033 - z1044 * z3034 - z1045 * z3035 - z1046 * z3036 - z1047 * z3037;
    const Scalar z3039 = z1107 - z1108 * z1117;
    const Scalar z3040 = z1106 - z1108 * z1116 - z1122 * z3039;
    const Scalar z3041 = z1124 * z3040;
    const Scalar z3042 = z1121 * z3039 - z1122 * z3041;
    const Scalar z3043 = z1108 * z1115 - z1116 * z3041 - z1117 * z3042;
    const Scalar z3044 = z1105 + z1106 * z3041 + z1107 * z3042 + z1108 * z3043;
    const Scalar z3045 = z1091 * z3041 + z1092 * z3042 + z1093 * z3043 - z1094 * z3044;
    const Scalar z3046 = z1070 * z3041 + z1071 * z3042 + z1072 * z3043 - z1073 * z3044 - z1074 * z3045;
    const Scalar z3047 = z1042 * z3041 + z1043 * z3042 + z1044 * z3043 - z1045 * z3044 - z1046 * z3045 - z1047 * z3046;
    const Scalar z3048 = z1093 - z1094 * z1108;
    const Scalar z3049 = z1092 - z1094 * z1107 - z1117 * z3048;
    const Scalar z3050 = z1091 - z1094 * z1106 - z1116 * z3048 - z1122 * z3049;
    const Scalar z3051 = z1124 * z3050;
    const Scalar z3052 = z1121 * z3049 - z1122 * z3051;
    const Scalar z3053 = z1115 * z3048 - z1116 * z3051 - z1117 * z3052;
    const Scalar z3054 = z1094 * z1105 - z1106 * z3051 - z1107 * z3052 - z1108 * z3053;
    const Scalar z3055 = z1090 + z1091 * z3051 + z1092 * z3052 + z1093 * z3053 + z1094 * z3054;
    const Scalar z3056 = z1070 * z3051 + z1071 * z3052 + z1072 * z3053 + z1073 * z3054 - z1074 * z3055;
    const Scalar z3057 = z1042 * z3051 + z1043 * z3052 + z1044 * z3053 + z1045 * z3054 - z1046 * z3055 - z1047 * z3056;
    const Scalar z3058 = z1073 - z1074 * z1094;
    const Scalar z3059 = z1072 - z1074 * z1093 - z1108 * z3058;
    const Scalar z3060 = z1071 - z1074 * z1092 - z1107 * z3058 - z1117 * z3059;
    const Scalar z3061 = z1070 - z1074 * z1091 - z1106 * z3058 - z1116 * z3059 - z1122 * z3060;
    const Scalar z3062 = z1124 * z3061;
    const Scalar z3063 = z1121 * z3060 - z1122 * z3062;
    const Scalar z3064 = z1115 * z3059 - z1116 * z3062 - z1117 * z3063;
    const Scalar z3065 = z1105 * z3058 - z1106 * z3062 - z1107 * z3063 - z1108 * z3064;
    const Scalar z3066 = z1074 * z1090 - z1091 * z3062 - z1092 * z3063 - z1093 * z3064 - z1094 * z3065;
    const Scalar z3067 = z1069 + z1070 * z3062 + z1071 * z3063 + z1072 * z3064 + z1073 * z3065 + z1074 * z3066;
    const Scalar z3068 = z1042 * z3062 + z1043 * z3063 + z1044 * z3064 + z1045 * z3065 + z1046 * z3066 - z1047 * z3067;
    const Scalar z3069 = z1046 - z1047 * z1074;
    const Scalar z3070 = z1045 - z1047 * z1073 - z1094 * z3069;
    const Scalar z3071 = z1044 - z1047 * z1072 - z1093 * z3069 - z1108 * z3070;
    const Scalar z3072 = z1043 - z1047 * z1071 - z1092 * z3069 - z1107 * z3070 - z1117 * z3071;
    const Scalar z3073 = z1042 - z1047 * z1070 - z1091 * z3069 - z1106 * z3070 - z1116 * z3071 - z1122 * z3072;
    const Scalar z3074 = z1124 * z3073;
    const Scalar z3075 = z1121 * z3072 - z1122 * z3074;
    const Scalar z3076 = z1115 * z3071 - z1116 * z3074 - z1117 * z3075;
    const Scalar z3077 = z1105 * z3070 - z1106 * z3074 - z1107 * z3075 - z1108 * z3076;
    const Scalar z3078 = z1090 * z3069 - z1091 * z3074 - z1092 * z3075 - z1093 * z3076 - z1094 * z3077;
    const Scalar z3079 = z1047 * z1069 - z1070 * z3074 - z1071 * z3075 - z1072 * z3076 - z1073 * z3077 - z1074 * z3078;
    const Scalar z3080 = k60 - z1042 * z3074 - z1043 * z3075 - z1044 * z3076 - z1045 * z3077 - z1046 * z3078 - z1047
        * z3079;
    result.M[0] = z669;
    result.M[1] = -z655;
    result.M[2] = -z635;
    result.M[3] = z607;
    result.M[4] = z573;
    result.M[5] = -z536;
    result.M[6] = z496;
    result.M[7] = -z655;
    result.M[8] = z651;
    result.M[9] = -z630;
    result.M[10] = z602;
    result.M[11] = z568;
    result.M[12] = z531;
    result.M[13] = z491;
    result.M[14] = -z635;
    result.M[15] = -z630;
    result.M[16] = z625;
    result.M[17] = z596;
    result.M[18] = -z562;
    result.M[19] = -z525;
    result.M[20] = -z485;
    result.M[21] = z607;
    result.M[22] = z602;
    result.M[23] = z596;
    result.M[24] = z592;
    result.M[25] = -z555;
    result.M[26] = -z518;
    result.M[27] = z478;
    result.M[28] = z573;
    result.M[29] = z568;
    result.M[30] = -z562;
    result.M[31] = -z555;
    result.M[32] = z550;
    result.M[33] = -z513;
    result.M[34] = z473;
    result.M[35] = -z536;
    result.M[36] = z531;
    result.M[37] = -z525;
    result.M[38] = -z518;
    result.M[39] = -z513;
    result.M[40] = z509;
    result.M[41] = -z468;
    result.M[42] = z496;
    result.M[43] = z491;
    result.M[44] = -z485;
    result.M[45] = z478;
    result.M[46] = z473;
    result.M[47] = -z468;
    result.M[48] = k4;
    result.C[0] = z1502;
    result.C[1] = -z1506;
    result.C[2] = -z1500;
    result.C[3] = -z1473;
    result.C[4] = -z1483;
    result.C[5] = z1466;
    result.C[6] = z1447;
    result.C[7] = z1686;
    result.C[8] = z1876;
    result.C[9] = -z1684;
    result.C[10] = z1660;
    result.C[11] = -z1669;
    result.C[12] = z1653;
    result.C[13] = -z1634;
    result.C[14] = -z2031;
    result.C[15] = z2193;
    result.C[16] = z2030;
    result.C[17] = z2013;
    result.C[18] = -z2021;
    result.C[19] = z2006;
    result.C[20] = z1987;
    result.C[21] = z2317;
    result.C[22] = -z2448;
    result.C[23] = z2316;
    result.C[24] = z2301;
    result.C[25] = -z2308;
    result.C[26] = -z2298;
    result.C[27] = -z2280;
    result.C[28] = z2538;
    result.C[29] = -z2638;
    result.C[30] = z2537;
    result.C[31] = z2526;
    result.C[32] = z2529;
    result.C[33] = -z2523;
    result.C[34] = z2508;
    result.C[35] = z2701;
    result.C[36] = z2770;
    result.C[37] = -z2700;
    result.C[38] = z2689;
    result.C[39] = z2692;
    result.C[40] = -z2687;
    result.C[41] = z2679;
    result.C[42] = z2808;
    result.C[43] = -z2847;
    result.C[44] = z2807;
    result.C[45] = z2796;
    result.C[46] = z2799;
    result.C[47] = -z2794;
    result.C[48] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = z1873;
    result.K[8] = -z1880;
    result.K[9] = -z1871;
    result.K[10] = -z1847;
    result.K[11] = z1858;
    result.K[12] = -z1842;
    result.K[13] = z1824;
    result.K[14] = z2190;
    result.K[15] = z2196;
    result.K[16] = -z2189;
    result.K[17] = z2170;
    result.K[18] = -z2178;
    result.K[19] = z2165;
    result.K[20] = -z2147;
    result.K[21] = -z2445;
    result.K[22] = -z2451;
    result.K[23] = z2444;
    result.K[24] = z2429;
    result.K[25] = z2436;
    result.K[26] = z2426;
    result.K[27] = -z2408;
    result.K[28] = -z2635;
    result.K[29] = -z2641;
    result.K[30] = z2634;
    result.K[31] = -z2621;
    result.K[32] = z2626;
    result.K[33] = -z2618;
    result.K[34] = -z2601;
    result.K[35] = z2767;
    result.K[36] = -z2773;
    result.K[37] = z2766;
    result.K[38] = z2755;
    result.K[39] = z2758;
    result.K[40] = z2753;
    result.K[41] = z2741;
    result.K[42] = -z2844;
    result.K[43] = -z2850;
    result.K[44] = z2843;
    result.K[45] = -z2832;
    result.K[46] = z2835;
    result.K[47] = -z2830;
    result.K[48] = -z2823;
    result.F[0] = u_tau1 - z1034;
    result.F[1] = u_tau2 - z1025;
    result.F[2] = u_tau3 + z1011;
    result.F[3] = u_tau4 - z997;
    result.F[4] = u_tau5 + z985;
    result.F[5] = u_tau6 - z969;
    result.F[6] = u_tau7 - z955;
    result.E[0] = n1;
    result.E[1] = n0;
    result.E[2] = n0;
    result.E[3] = n0;
    result.E[4] = n0;
    result.E[5] = n0;
    result.E[6] = n0;
    result.E[7] = n0;
    result.E[8] = n1;
    result.E[9] = n0;
    result.E[10] = n0;
    result.E[11] = n0;
    result.E[12] = n0;
    result.E[13] = n0;
    result.E[14] = n0;
    result.E[15] = n0;
    result.E[16] = n1;
    result.E[17] = n0;
    result.E[18] = n0;
    result.E[19] = n0;
    result.E[20] = n0;
    result.E[21] = n0;
    result.E[22] = n0;
    result.E[23] = n0;
    result.E[24] = n1;
    result.E[25] = n0;
    result.E[26] = n0;
    result.E[27] = n0;
    result.E[28] = n0;
    result.E[29] = n0;
    result.E[30] = n0;
    result.E[31] = n0;
    result.E[32] = n1;
    result.E[33] = n0;
    result.E[34] = n0;
    result.E[35] = n0;
    result.E[36] = n0;
    result.E[37] = n0;
    result.E[38] = n0;
    result.E[39] = n0;
    result.E[40] = n1;
    result.E[41] = n0;
    result.E[42] = n0;
    result.E[43] = n0;
    result.E[44] = n0;
    result.E[45] = n0;
    result.E[46] = n0;
    result.E[47] = n0;
    result.E[48] = n1;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = n0;
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = n0;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = -z2870;
    result.A[22] = -z2871;
    result.A[23] = z2872;
    result.A[24] = -z2873;
    result.A[25] = -z2874;
    result.A[26] = z2875;
    result.A[27] = z2876;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = z2896;
    result.A[36] = z2897;
    result.A[37] = -z2898;
    result.A[38] = z2899;
    result.A[39] = z2900;
    result.A[40] = -z2901;
    result.A[41] = -z2902;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = z2922;
    result.A[50] = z2923;
    result.A[51] = -z2924;
    result.A[52] = z2925;
    result.A[53] = z2926;
    result.A[54] = -z2927;
    result.A[55] = -z2928;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = z2948;
    result.A[64] = z2949;
    result.A[65] = -z2950;
    result.A[66] = z2951;
    result.A[67] = z2952;
    result.A[68] = -z2953;
    result.A[69] = -z2954;
    result.A[70] = n0;
    result.A[71] = n0;
    result.A[72] = n0;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z2974;
    result.A[78] = -z2975;
    result.A[79] = z2976;
    result.A[80] = -z2977;
    result.A[81] = -z2978;
    result.A[82] = z2979;
    result.A[83] = z2980;
    result.A[84] = n0;
    result.A[85] = n0;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = n0;
    result.A[91] = z3000;
    result.A[92] = z3001;
    result.A[93] = -z3002;
    result.A[94] = z3003;
    result.A[95] = z3004;
    result.A[96] = -z3005;
    result.A[97] = -z3006;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = n0;
    result.A[103] = n0;
    result.A[104] = n0;
    result.A[105] = -z2857;
    result.A[106] = -z2858;
    result.A[107] = z2859;
    result.A[108] = -z2860;
    result.A[109] = -z2861;
    result.A[110] = z2862;
    result.A[111] = z2863;
    result.A[112] = n0;
    result.A[113] = n1;
    result.A[114] = n0;
    result.A[115] = n0;
    result.A[116] = n0;
    result.A[117] = n0;
    result.A[118] = n0;
    result.A[119] = z2883;
    result.A[120] = z2884;
    result.A[121] = -z2885;
    result.A[122] = z2886;
    result.A[123] = z2887;
    result.A[124] = -z2888;
    result.A[125] = -z2889;
    result.A[126] = n0;
    result.A[127] = n0;
    result.A[128] = n1;
    result.A[129] = n0;
    result.A[130] = n0;
    result.A[131] = n0;
    result.A[132] = n0;
    result.A[133] = -z2909;
    result.A[134] = -z2910;
    result.A[135] = z2911;
    result.A[136] = -z2912;
    result.A[137] = -z2913;
    result.A[138] = z2914;
    result.A[139] = z2915;
    result.A[140] = n0;
    result.A[141] = n0;
    result.A[142] = n0;
    result.A[143] = n1;
    result.A[144] = n0;
    result.A[145] = n0;
    result.A[146] = n0;
    result.A[147] = z2935;
    result.A[148] = z2936;
    result.A[149] = -z2937;
    result.A[150] = z2938;
    result.A[151] = z2939;
    result.A[152] = -z2940;
    result.A[153] = -z2941;
    result.A[154] = n0;
    result.A[155] = n0;
    result.A[156] = n0;
    result.A[157] = n0;
    result.A[158] = n1;
    result.A[159] = n0;
    result.A[160] = n0;
    result.A[161] = -z2961;
    result.A[162] = -z2962;
    result.A[163] = z2963;
    result.A[164] = -z2964;
    result.A[165] = -z2965;
    result.A[166] = z2966;
    result.A[167] = z2967;
    result.A[168] = n0;
    result.A[169] = n0;
    result.A[170] = n0;
    result.A[171] = n0;
    result.A[172] = n0;
    result.A[173] = n1;
    result.A[174] = n0;
    result.A[175] = -z2987;
    result.A[176] = -z2988;
    result.A[177] = z2989;
    result.A[178] = -z2990;
    result.A[179] = -z2991;
    result.A[180] = z2992;
    result.A[181] = z2993;
    result.A[182] = n0;
    result.A[183] = n0;
    result.A[184] = n0;
    result.A[185] = n0;
    result.A[186] = n0;
    result.A[187] = n0;
    result.A[188] = n1;
    result.A[189] = -z3012;
    result.A[190] = -z3013;
    result.A[191] = z3014;
    result.A[192] = -z3015;
    result.A[193] = -z3016;
    result.A[194] = -z3017;
    result.A[195] = z3018;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = -z1124;
    result.B[8] = z3019;
    result.B[9] = -z3020;
    result.B[10] = z3021;
    result.B[11] = z3022;
    result.B[12] = -z3023;
    result.B[13] = z3024;
    result.B[14] = n0;
    result.B[15] = n0;
    result.B[16] = n0;
    result.B[17] = n0;
    result.B[18] = n0;
    result.B[19] = n0;
    result.B[20] = n0;
    result.B[21] = z3019;
    result.B[22] = -z3025;
    result.B[23] = z3026;
    result.B[24] = -z3027;
    result.B[25] = -z3028;
    result.B[26] = z3029;
    result.B[27] = -z3030;
    result.B[28] = n0;
    result.B[29] = n0;
    result.B[30] = n0;
    result.B[31] = n0;
    result.B[32] = n0;
    result.B[33] = n0;
    result.B[34] = n0;
    result.B[35] = -z3032;
    result.B[36] = -z3033;
    result.B[37] = -z3034;
    result.B[38] = z3035;
    result.B[39] = z3036;
    result.B[40] = -z3037;
    result.B[41] = z3038;
    result.B[42] = n0;
    result.B[43] = n0;
    result.B[44] = n0;
    result.B[45] = n0;
    result.B[46] = n0;
    result.B[47] = n0;
    result.B[48] = n0;
    result.B[49] = z3041;
    result.B[50] = z3042;
    result.B[51] = -z3043;
    result.B[52] = -z3044;
    result.B[53] = -z3045;
    result.B[54] = z3046;
    result.B[55] = -z3047;
    result.B[56] = n0;
    result.B[57] = n0;
    result.B[58] = n0;
    result.B[59] = n0;
    result.B[60] = n0;
    result.B[61] = n0;
    result.B[62] = n0;
    result.B[63] = z3051;
    result.B[64] = z3052;
    result.B[65] = -z3053;
    result.B[66] = z3054;
    result.B[67] = -z3055;
    result.B[68] = z3056;
    result.B[69] = -z3057;
    result.B[70] = n0;
    result.B[71] = n0;
    result.B[72] = n0;
    result.B[73] = n0;
    result.B[74] = n0;
    result.B[75] = n0;
    result.B[76] = n0;
    result.B[77] = -z3062;
    result.B[78] = -z3063;
    result.B[79] = z3064;
    result.B[80] = -z3065;
    result.B[81] = -z3066;
    result.B[82] = -z3067;
    result.B[83] = z3068;
    result.B[84] = n0;
    result.B[85] = n0;
    result.B[86] = n0;
    result.B[87] = n0;
    result.B[88] = n0;
    result.B[89] = n0;
    result.B[90] = n0;
    result.B[91] = z3074;
    result.B[92] = z3075;
    result.B[93] = -z3076;
    result.B[94] = z3077;
    result.B[95] = z3078;
    result.B[96] = -z3079;
    result.B[97] = z3080;
    if (!(traits::regular(-z1123, z669) && traits::regular(-z1120, z651) && traits::regular(-z1114, z625)
        && traits::regular(-z1104, z592) && traits::regular(-z1089, z550) && traits::regular(-z1068, z509)
        && traits::regular(k4, k4))) return torsor::Status::singular;
    // x - x is 0 for every finite x and not a number for any other.
    const Scalar zero = (result.M[0] - result.M[0]) + (result.M[1] - result.M[1]) + (result.M[2] - result.M[2])
        + (result.M[3] - result.M[3]) + (result.M[4] - result.M[4]) + (result.M[5] - result.M[5]) + (result.M[6]
        - result.M[6]) + (result.M[7] - result.M[7]) + (result.M[8] - result.M[8]) + (result.M[9] - result.M[9])
        + (result.M[10] - result.M[10]) + (result.M[11] - result.M[11]) + (result.M[12] - result.M[12]) + (result.M[13]
        - result.M[13]) + (result.M[14] - result.M[14]) + (result.M[15] - result.M[15]) + (result.M[16] - result.M[16])
        + (result.M[17] - result.M[17]) + (result.M[18] - result.M[18]) + (result.M[19] - result.M[19]) + (result.M[20]
        - result.M[20]) + (result.M[21] - result.M[21]) + (result.M[22] - result.M[22]) + (result.M[23] - result.M[23])
        + (result.M[24] - result.M[24]) + (result.M[25] - result.M[25]) + (result.M[26] - result.M[26]) + (result.M[27]
        - result.M[27]) + (result.M[28] - result.M[28]) + (result.M[29] - result.M[29]) + (result.M[30] - result.M[30])
        + (result.M[31] - result.M[31]) + (result.M[32] - result.M[32]) + (result.M[33] - result.M[33]) + (result.M[34]
        - result.M[34]) + (result.M[35] - result.M[35]) + (result.M[36] - result.M[36]) + (result.M[37] - result.M[37])
        + (result.M[38] - result.M[38]) + (result.M[39] - result.M[39]) + (result.M[40] - result.M[40]) + (result.M[41]
        - result.M[41]) + (result.M[42] - result.M[42]) + (result.M[43] - result.M[43]) + (result.M[44] - result.M[44])
        + (result.M[45] - result.M[45]) + (result.M[46] - result.M[46]) + (result.M[47] - result.M[47]) + (result.C[0]
        - result.C[0]) + (result.C[1] - result.C[1]) + (result.C[2] - result.C[2]) + (result.C[3] - result.C[3])
        + (result.C[4] - result.C[4]) + (result.C[5] - result.C[5]) + (result.C[6] - result.C[6]) + (result.C[7]
        - result.C[7]) + (result.C[8] - result.C[8]) + (result.C[9] - result.C[9]) + (result.C[10] - result.C[10])
        + (result.C[11] - result.C[11]) + (result.C[12] - result.C[12]) + (result.C[13] - result.C[13]) + (result.C[14]
        - result.C[14]) + (result.C[15] - result.C[15]) + (result.C[16] - result.C[16]) + (result.C[17] - result.C[17])
        + (result.C[18] - result.C[18]) + (result.C[19] - result.C[19]) + (result.C[20] - result.C[20]) + (result.C[21]
        - result.C[21]) + (result.C[22] - result.C[22]) + (result.C[23] - result.C[23]) + (result.C[24] - result.C[24])
        + (result.C[25] - result.C[25]) + (result.C[26] - result.C[26]) + (result.C[27] - result.C[27]) + (result.C[28]
        - result.C[28]) + (result.C[29] - result.C[29]) + (result.C[30] - result.C[30]) + (result.C[31] - result.C[31])
        + (result.C[32] - result.C[32]) + (result.C[33] - result.C[33]) + (result.C[34] - result.C[34]) + (result.C[35]
        - result.C[35]) + (result.C[36] - result.C[36]) + (result.C[37] - result.C[37]) + (result.C[38] - result.C[38])
        + (result.C[39] - result.C[39]) + (result.C[40] - result.C[40]) + (result.C[41] - result.C[41]) + (result.C[42]
        - result.C[42]) + (result.C[43] - result.C[43]) + (result.C[44] - result.C[44]) + (result.C[45] - result.C[45])
        + (result.C[46] - result.C[46]) + (result.C[47] - result.C[47]) + (result.K[7] - result.K[7]) + (result.K[8]
        - result.K[8]) + (result.K[9] - result.K[9]) + (result.K[10] - result.K[10]) + (result.K[11] - result.K[11])
        + (result.K[12] - result.K[12]) + (result.K[13] - result.K[13]) + (result.K[14] - result.K[14]) + (result.K[15]
        - result.K[15]) + (result.K[16] - result.K[16]) + (result.K[17] - result.K[17]) + (result.K[18] - result.K[18])
        + (result.K[19] - result.K[19]) + (result.K[20] - result.K[20]) + (result.K[21] - result.K[21]) + (result.K[22]
        - result.K[22]) + (result.K[23] - result.K[23]) + (result.K[24] - result.K[24]) + (result.K[25] - result.K[25])
        + (result.K[26] - result.K[26]) + (result.K[27] - result.K[27]) + (result.K[28] - result.K[28]) + (result.K[29]
        - result.K[29]) + (result.K[30] - result.K[30]) + (result.K[31] - result.K[31]) + (result.K[32] - result.K[32])
        + (result.K[33] - result.K[33]) + (result.K[34] - result.K[34]) + (result.K[35] - result.K[35]) + (result.K[36]
        - result.K[36]) + (result.K[37] - result.K[37]) + (result.K[38] - result.K[38]) + (result.K[39] - result.K[39])
        + (result.K[40] - result.K[40]) + (result.K[41] - result.K[41]) + (result.K[42] - result.K[42]) + (result.K[43]
        - result.K[43]) + (result.K[44] - result.K[44]) + (result.K[45] - result.K[45]) + (result.K[46] - result.K[46])
        + (result.K[47] - result.K[47]) + (result.K[48] - result.K[48]) + (result.F[0] - result.F[0]) + (result.F[1]
        - result.F[1]) + (result.F[2] - result.F[2]) + (result.F[3] - result.F[3]) + (result.F[4] - result.F[4])
        + (result.F[5] - result.F[5]) + (result.F[6] - result.F[6]) + (result.A[21] - result.A[21]) + (result.A[22]
        - result.A[22]) + (result.A[23] - result.A[23]) + (result.A[24] - result.A[24]) + (result.A[25] - result.A[25])
        + (result.A[26] - result.A[26]) + (result.A[27] - result.A[27]) + (result.A[35] - result.A[35]) + (result.A[36]
        - result.A[36]) + (result.A[37] - result.A[37]) + (result.A[38] - result.A[38]) + (result.A[39] - result.A[39])
        + (result.A[40] - result.A[40]) + (result.A[41] - result.A[41]) + (result.A[49] - result.A[49]) + (result.A[50]
        - result.A[50]) + (result.A[51] - result.A[51]) + (result.A[52] - result.A[52]) + (result.A[53] - result.A[53])
        + (result.A[54] - result.A[54]) + (result.A[55] - result.A[55]) + (result.A[63] - result.A[63]) + (result.A[64]
        - result.A[64]) + (result.A[65] - result.A[65]) + (result.A[66] - result.A[66]) + (result.A[67] - result.A[67])
        + (result.A[68] - result.A[68]) + (result.A[69] - result.A[69]) + (result.A[77] - result.A[77]) + (result.A[78]
        - result.A[78]) + (result.A[79] - result.A[79]) + (result.A[80] - result.A[80]) + (result.A[81] - result.A[81])
        + (result.A[82] - result.A[82]) + (result.A[83] - result.A[83]) + (result.A[91] - result.A[91]) + (result.A[92]
        - result.A[92]) + (result.A[93] - result.A[93]) + (result.A[94] - result.A[94]) + (result.A[95] - result.A[95])
        + (result.A[96] - result.A[96]) + (result.A[97] - result.A[97]) + (result.A[105] - result.A[105])
        + (result.A[106] - result.A[106]) + (result.A[107] - result.A[107]) + (result.A[108] - result.A[108])
        + (result.A[109] - result.A[109]) + (result.A[110] - result.A[110]) + (result.A[111] - result.A[111])
        + (result.A[119] - result.A[119]) + (result.A[120] - result.A[120]) + (result.A[121] - result.A[121])
        + (result.A[122] - result.A[122]) + (result.A[123] - result.A[123]) + (result.A[124] - result.A[124])
        + (result.A[125] - result.A[125]) + (result.A[133] - result.A[133]) + (result.A[134] - result.A[134])
        + (result.A[135] - result.A[135]) + (result.A[136] - result.A[136]) + (result.A[137] - result.A[137])
        + (result.A[138] - result.A[138]) + (result.A[139] - result.A[139]) + (result.A[147] - result.A[147])
        + (result.A[148] - result.A[148]) + (result.A[149] - result.A[149]) + (result.A[150] - result.A[150])
        + (result.A[151] - result.A[151]) + (result.A[152] - result.A[152]) + (result.A[153] - result.A[153])
        + (result.A[161] - result.A[161]) + (result.A[162] - result.A[162]) + (result.A[163] - result.A[163])
        + (result.A[164] - result.A[164]) + (result.A[165] - result.A[165]) + (result.A[166] - result.A[166])
        + (result.A[167] - result.A[167]) + (result.A[175] - result.A[175]) + (result.A[176] - result.A[176])
        + (result.A[177] - result.A[177]) + (result.A[178] - result.A[178]) + (result.A[179] - result.A[179])
        + (result.A[180] - result.A[180]) + (result.A[181] - result.A[181]) + (result.A[189] - result.A[189])
        + (result.A[190] - result.A[190]) + (result.A[191] - result.A[191]) + (result.A[192] - result.A[192])
        + (result.A[193] - result.A[193]) + (result.A[194] - result.A[194]) + (result.A[195] - result.A[195])
        + (result.B[7] - result.B[7]) + (result.B[8] - result.B[8]) + (result.B[9] - result.B[9]) + (result.B[10]
        - result.B[10]) + (result.B[11] - result.B[11]) + (result.B[12] - result.B[12]) + (result.B[13] - result.B[13])
        + (result.B[21] - result.B[21]) + (result.B[22] - result.B[22]) + (result.B[23] - result.B[23]) + (result.B[24]
        - result.B[24]) + (result.B[25] - result.B[25]) + (result.B[26] - result.B[26]) + (result.B[27] - result.B[27])
        + (result.B[35] - result.B[35]) + (result.B[36] - result.B[36]) + (result.B[37] - result.B[37]) + (result.B[38]
        - result.B[38]) + (result.B[39] - result.B[39]) + (result.B[40] - result.B[40]) + (result.B[41] - result.B[41])
        + (result.B[49] - result.B[49]) + (result.B[50] - result.B[50]) + (result.B[51] - result.B[51]) + (result.B[52]
        - result.B[52]) + (result.B[53] - result.B[53]) + (result.B[54] - result.B[54]) + (result.B[55] - result.B[55])
        + (result.B[63] - result.B[63]) + (result.B[64] - result.B[64]) + (result.B[65] - result.B[65]) + (result.B[66]
        - result.B[66]) + (result.B[67] - result.B[67]) + (result.B[68] - result.B[68]) + (result.B[69] - result.B[69])
        + (result.B[77] - result.B[77]) + (result.B[78] - result.B[78]) + (result.B[79] - result.B[79]) + (result.B[80]
        - result.B[80]) + (result.B[81] - result.B[81]) + (result.B[82] - result.B[82]) + (result.B[83] - result.B[83])
        + (result.B[91] - result.B[91]) + (result.B[92] - result.B[92]) + (result.B[93] - result.B[93]) + (result.B[94]
        - result.B[94]) + (result.B[95] - result.B[95]) + (result.B[96] - result.B[96]) + (result.B[97] - result.B[97]);
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }
};

}  // namespace arm7
