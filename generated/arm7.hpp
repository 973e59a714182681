// SPDX-License-Identifier: MIT-0
// arm7: Arm with seven revolute joints
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics              252              343          0             0                  7       0    609     609
//   mass_matrix             162              181          0             0                  6       0    355     355
//   bias                    266              292          0             0                  6       0    570     570
//   inverse_dynamics        285              300          0             0                  6       0    597     597
//   forward_dynamics        515              586          6             0                  6       0   1119    1119
//   energy                  221              306          0             0                  6       0    539     577
//   linearisation          2054             2386          6             0                  6       0   4458    4466
//
// Not computed because this mechanism does not need it:
//   kinematics: of 153 results 12 vanish identically, 20 repeat another up to sign
//   mass_matrix: of 49 results 21 repeat another up to sign
//   first_integrals: left out, 'tau1', 'tau2', 'tau3', 'tau4', 'tau5', 'tau6', 'tau7' have no force function
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 497 results 197 vanish identically, 22 repeat another up to sign
//
// To write this file again:
//   arm7_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output arm7.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace arm7 {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 7> coordinates{{{"q1", "rad"}, {"q2", "rad"}, {"q3", "rad"},
      {"q4", "rad"}, {"q5", "rad"}, {"q6", "rad"}, {"q7", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 7> velocities{{{"q1", "rad/s"}, {"q2", "rad/s"}, {"q3",
      "rad/s"}, {"q4", "rad/s"}, {"q5", "rad/s"}, {"q6", "rad/s"}, {"q7", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 7> inputs{{{"tau1", "N m"}, {"tau2", "N m"}, {"tau3", "N m"},
      {"tau4", "N m"}, {"tau5", "N m"}, {"tau6", "N m"}, {"tau7", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 46> results{{{"result", "link1_position", 3, 1, 1, "m"},
      {"result", "link1_rotation", 3, 3, 2, "1"}, {"result", "link1_velocity", 3, 1, 1, "m/s"}, {"result",
      "link1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "link2_position", 3, 1, 1, "m"}, {"result",
      "link2_rotation", 3, 3, 2, "1"}, {"result", "link2_velocity", 3, 1, 1, "m/s"}, {"result",
      "link2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "link3_position", 3, 1, 1, "m"}, {"result",
      "link3_rotation", 3, 3, 2, "1"}, {"result", "link3_velocity", 3, 1, 1, "m/s"}, {"result",
      "link3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "link4_position", 3, 1, 1, "m"}, {"result",
      "link4_rotation", 3, 3, 2, "1"}, {"result", "link4_velocity", 3, 1, 1, "m/s"}, {"result",
      "link4_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "link5_position", 3, 1, 1, "m"}, {"result",
      "link5_rotation", 3, 3, 2, "1"}, {"result", "link5_velocity", 3, 1, 1, "m/s"}, {"result",
      "link5_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "link6_position", 3, 1, 1, "m"}, {"result",
      "link6_rotation", 3, 3, 2, "1"}, {"result", "link6_velocity", 3, 1, 1, "m/s"}, {"result",
      "link6_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "link7_position", 3, 1, 1, "m"}, {"result",
      "link7_rotation", 3, 3, 2, "1"}, {"result", "link7_velocity", 3, 1, 1, "m/s"}, {"result",
      "link7_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "tip_position", 3, 1, 1, "m"}, {"result", "tip_velocity",
      3, 1, 1, "m/s"}, {"result", "tip_jacobian", 3, 7, 2, "m"}, {"mass", "", 7, 7, 2, "kg m^2"}, {"forces", "", 7, 1,
      1, "N m"}, {"forces", "", 7, 1, 1, "N m"}, {"accelerations", "", 7, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1,
      ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "M", 7, 7, 2, "kg m^2"}, {"result", "C", 7, 7, 2, "N m s"}, {"result", "K", 7, 7, 2, "N m"},
      {"result", "F", 7, 1, 1, "N m"}, {"result", "E", 7, 7, 2, "1"}, {"result", "A", 14, 14, 2, ""}, {"result", "B",
      14, 7, 2, "1/kg/m^2"}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 31}, {"mass_matrix", false, false, false, false, results.data() + 31, 1}, {"bias", false,
      false, false, false, results.data() + 32, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 33,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 34, 2}, {"energy", false, false, true, false,
      results.data() + 36, 3}, {"linearisation", true, true, true, true, results.data() + 39, 7}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::arm7::Description;

  static constexpr const char* name = "arm7";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x902da328eb9e2b5fULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 7;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar q1;  ///< coordinate [rad]
    Scalar q2;  ///< coordinate [rad]
    Scalar q3;  ///< coordinate [rad]
    Scalar q4;  ///< coordinate [rad]
    Scalar q5;  ///< coordinate [rad]
    Scalar q6;  ///< coordinate [rad]
    Scalar q7;  ///< coordinate [rad]
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
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k5 = traits::constant(0.002081, 0.002081f, "2081/1000000");
    const Scalar k6 = traits::constant(0.003875, 0.003875f, "31/8000");
    const Scalar k7 = traits::constant(0.003495, 0.003495f, "699/200000");
    const Scalar k8 = traits::constant(0.003141, 0.003141f, "3141/1000000");
    const Scalar k9 = traits::constant(0.02872, 0.02872f, "359/12500");
    const Scalar k10 = traits::constant(0.039252, 0.039252f, "9813/250000");
    const Scalar k11 = traits::constant(0.066502, 0.066502f, "33251/500000");
    const Scalar k12 = traits::constant(0.027518, 0.027518f, "13759/500000");
    const Scalar k13 = traits::constant(0.104419, 0.104419f, "104419/1000000");
    const Scalar k14 = traits::constant(0.027454, 0.027454f, "13727/500000");
    const Scalar k15 = traits::constant(0.05317, 0.05317f, "5317/100000");
    const Scalar k16 = traits::constant(0.038437, 0.038437f, "38437/1000000");
    const Scalar k17 = traits::constant(0.041065, 0.041065f, "8213/200000");
    const Scalar k18 = traits::constant(0.011953, 0.011953f, "11953/1000000");
    const Scalar k19 = traits::constant(0.060149, 0.060149f, "60149/1000000");
    const Scalar k20 = traits::constant(0.010517, 0.010517f, "10517/1000000");
    const Scalar k21 = traits::constant(0.014117, 0.014117f, "14117/1000000");
    const Scalar n0_107 = traits::constant(0.107, 0.107f, "107/1000");
    const Scalar k23 = traits::constant(0.004252, 0.004252f, "1063/250000");
    const Scalar k24 = traits::constant(0.061597, 0.061597f, "61597/1000000");
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
    const Scalar angles_[] = {q_q1, q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q1 = sines_[0], c_q1 = cosines_[0];
    const Scalar s_q2 = sines_[1], c_q2 = cosines_[1];
    const Scalar s_q3 = sines_[2], c_q3 = cosines_[2];
    const Scalar s_q4 = sines_[3], c_q4 = cosines_[3];
    const Scalar s_q5 = sines_[4], c_q5 = cosines_[4];
    const Scalar s_q6 = sines_[5], c_q6 = cosines_[5];
    const Scalar s_q7 = sines_[6], c_q7 = cosines_[6];
    const Scalar z0 = v_q1 * s_q2;
    const Scalar z1 = v_q1 * c_q2;
    const Scalar z2 = s_q1 * c_q2;
    const Scalar z3 = n0_316 * v_q2;
    const Scalar z4 = c_q1 * c_q2;
    const Scalar z5 = s_q1 * s_q2;
    const Scalar z6 = s_q2 * s_q3;
    const Scalar z7 = s_q2 * z3;  // velocity of link3, z
    const Scalar z8 = c_q1 * s_q2;
    const Scalar z9 = s_q2 * c_q3;
    const Scalar z10 = s_q1 * v_q2;  // angular velocity of link2, x
    const Scalar z11 = c_q1 * v_q2;  // angular velocity of link2, y
    const Scalar z12 = v_q1 + c_q2 * v_q3;  // angular velocity of link3, z
    const Scalar z13 = n0_316 * c_q2;
    const Scalar z14 = s_q1 * s_q3 - c_q3 * z4;
    const Scalar z15 = s_q1 * c_q3 + s_q3 * z4;
    const Scalar z16 = c_q1 * s_q3 + c_q3 * z2;
    const Scalar z17 = c_q1 * c_q3 - s_q3 * z2;
    const Scalar z18 = n0_316 * z8;
    const Scalar z19 = n0_316 * z5;
    const Scalar z20 = n0_333 + z13;  // place of link3, z
    const Scalar z21 = n0_316 * z0;
    const Scalar z22 = v_q2 * s_q3 - c_q3 * z0;
    const Scalar z23 = v_q2 * c_q3 + s_q3 * z0;
    const Scalar z24 = v_q3 + z1;
    const Scalar z25 = v_q3 * z8 - z10;  // angular velocity of link3, x
    const Scalar z26 = v_q3 * z5 + z11;  // angular velocity of link3, y
    const Scalar z27 = c_q2 * s_q4 - c_q4 * z9;
    const Scalar z28 = c_q2 * c_q4 + s_q4 * z9;
    const Scalar z29 = n0_0825 * z9;
    const Scalar z30 = v_q4 * z6 - z12;  // angular velocity of link4, z
    const Scalar z31 = s_q1 * z21 - z4 * z3;  // velocity of link3, x
    const Scalar z32 = z2 * z3 + c_q1 * z21;  // velocity of link3, y
    const Scalar z33 = z20 - z29;  // place of link4, z
    const Scalar z34 = n0_0825 * z24;
    const Scalar z35 = s_q4 * z8 - c_q4 * z14;
    const Scalar z36 = c_q4 * z8 + s_q4 * z14;
    const Scalar z37 = s_q4 * z5 + c_q4 * z16;
    const Scalar z38 = s_q4 * z16 - c_q4 * z5;
    const Scalar z39 = n0_0825 * z14;
    const Scalar z40 = n0_0825 * z16;
    const Scalar z41 = n0_0825 * z23;
    const Scalar z42 = s_q4 * z24 + c_q4 * z22;
    const Scalar z43 = s_q4 * z22 - c_q4 * z24;
    const Scalar z44 = v_q4 - z23;
    const Scalar z45 = v_q4 * z15 + z25;  // angular velocity of link4, x
    const Scalar z46 = v_q4 * z17 - z26;  // angular velocity of link4, y
    const Scalar z47 = v_q5 * z28 - z30;  // angular velocity of link5, z
    const Scalar z48 = s_q5 * z6 + c_q5 * z27;
    const Scalar z49 = z5 * z41 - z32 - z17 * z34;  // velocity of link4, y
    const Scalar z50 = v_q5 * z36 + z45;  // angular velocity of link5, x
    const Scalar z51 = z31 + z15 * z34 + z8 * z41;  // velocity of link4, x
    const Scalar z52 = z7 - z6 * z34 + c_q2 * z41;  // velocity of link4, z
    const Scalar z53 = v_q5 * z38 + z46;  // angular velocity of link5, y
    const Scalar z54 = n0_384 * z44;
    const Scalar z55 = n0_384 * z42 - n0_0825 * z43;
    const Scalar z56 = s_q5 * z44 - c_q5 * z42;
    const Scalar z57 = v_q5 - z43;
    const Scalar z58 = c_q5 * z44 + s_q5 * z42;
    const Scalar z59 = n0_0825 * z44;
    const Scalar z60 = s_q5 * z15 - c_q5 * z35;
    const Scalar z61 = v_q6 + z58;
    const Scalar z62 = s_q5 * z17 + c_q5 * z37;
    const Scalar z63 = s_q6 * z57 - c_q6 * z56;
    const Scalar z64 = s_q6 * z56 + c_q6 * z57;
    const Scalar z65 = s_q6 * z36 - c_q6 * z60;
    const Scalar z66 = c_q6 * z36 + s_q6 * z60;
    const Scalar z67 = c_q5 * z15 + s_q5 * z35;
    const Scalar z68 = v_q6 * z67 + z50;  // angular velocity of link6, x
    const Scalar z69 = s_q5 * z37 - c_q5 * z17;
    const Scalar z70 = v_q6 * z69 - z53;  // angular velocity of link6, y
    const Scalar z71 = s_q5 * z27 - c_q5 * z6;
    const Scalar z72 = v_q6 * z71 + z47;  // angular velocity of link6, z
    const Scalar z73 = z15 * z55 - z51 - z35 * z54 - z36 * z59;  // velocity of link5, x
    const Scalar z74 = z49 + z37 * z54 - z38 * z59 + z17 * z55;  // velocity of link5, y
    const Scalar z75 = z52 + z27 * z54 + z28 * z59 + z6 * z55;  // velocity of link5, z
    const Scalar z76 = s_q6 * z38 - c_q6 * z62;
    const Scalar z77 = c_q6 * z38 + s_q6 * z62;
    const Scalar z78 = s_q6 * z28 + c_q6 * z48;
    const Scalar z79 = s_q6 * z48 - c_q6 * z28;
    const Scalar z80 = n0_088 * z65;
    const Scalar z81 = n0_0825 * z35 - n0_384 * z36;
    const Scalar z82 = n0_088 * z76;
    const Scalar z83 = n0_088 * z78;
    const Scalar z84 = n0_0825 * z37 + n0_384 * z38;
    const Scalar z85 = n0_0825 * z27 - n0_384 * z28;
    const Scalar z86 = s_q7 * z67 + c_q7 * z65;
    const Scalar z87 = s_q7 * z69 - c_q7 * z76;
    const Scalar z88 = s_q7 * z71 + c_q7 * z78;
    const Scalar z89 = z18 - z39;  // place of link4, x
    const Scalar z90 = z19 + z40;  // place of link4, y
    const Scalar z91 = v_q7 * z66 - z68;  // angular velocity of link7, x
    const Scalar z92 = v_q7 * z77 + z70;  // angular velocity of link7, y
    const Scalar z93 = v_q7 * z79 + z72;  // angular velocity of link7, z
    const Scalar z94 = k5 * s_q1 - k6 * c_q1;
    const Scalar z95 = k6 * s_q1 + k5 * c_q1;
    const Scalar z96 = k7 * s_q1 + k8 * z4 - k9 * z8;
    const Scalar z97 = k7 * c_q1 - k8 * z2 + k9 * z5;
    const Scalar z98 = n0_088 * z64;
    const Scalar z99 = s_q7 * z61 + c_q7 * z63;
    const Scalar z100 = n0_088 * z61;
    const Scalar z101 = s_q7 * z63 - c_q7 * z61;
    const Scalar z102 = v_q7 - z64;
    const Scalar z103 = z67 * z98 - z73 - z66 * z100;  // velocity of link7, x
    const Scalar z104 = z69 * z98 + z74 + z77 * z100;  // velocity of link7, y
    const Scalar z105 = z71 * z98 + z75 + z79 * z100;  // velocity of link7, z
    const Scalar z106 = s_q7 * z65 - c_q7 * z67;
    const Scalar z107 = c_q7 * z69 + s_q7 * z76;
    const Scalar z108 = s_q7 * z78 - c_q7 * z71;
    const Scalar z109 = k5 * v_q1;
    const Scalar z110 = k6 * v_q1;
    const Scalar z111 = s_q1 * z110 + c_q1 * z109;
    const Scalar z112 = s_q1 * z109 - c_q1 * z110;
    const Scalar z113 = z89 - z81;  // place of link5, x
    const Scalar z114 = k9 * v_q2 - k7 * z1;
    const Scalar z115 = z90 - z84;  // place of link5, y
    const Scalar z116 = k8 * v_q2 - k7 * z0;
    const Scalar z117 = z33 - z85;  // place of link5, z
    const Scalar z118 = k9 * z0 - k8 * z1;
    const Scalar z119 = s_q1 * z118 - z4 * z114 - z8 * z116;
    const Scalar z120 = z2 * z114 + z5 * z116 + c_q1 * z118;
    const Scalar z121 = s_q2 * z114 - c_q2 * z116;
    const Scalar z122 = k10 * z24 + k11 * z23;
    const Scalar z123 = k12 * z24 + k11 * z22;
    const Scalar z124 = k10 * z22 - k12 * z23;
    const Scalar z125 = z14 * z122 - z31 - z15 * z123 + z8 * z124;
    const Scalar z126 = z32 - z16 * z122 + z17 * z123 + z5 * z124;
    const Scalar z127 = z9 * z122 - z7 + z6 * z123 + c_q2 * z124;
    const Scalar z128 = k11 * z8 + k12 * z14 + k10 * z15;
    const Scalar z129 = z18 - z128;
    const Scalar z130 = k11 * z5 - k12 * z16 - k10 * z17;
    const Scalar z131 = z19 - z130;
    const Scalar z132 = k11 * c_q2 + k12 * z9 - k10 * z6;
    const Scalar z133 = z20 - z132;
    const Scalar z134 = k13 * z44 + k14 * z43;
    const Scalar z135 = k15 * z44 + k14 * z42;
    const Scalar z136 = k13 * z42 - k15 * z43;
    const Scalar z137 = z15 * z136 - z51 - z36 * z135 - z35 * z134;
    const Scalar z138 = z49 + z37 * z134 - z38 * z135 + z17 * z136;
    const Scalar z139 = z28 * z135 + z52 + z27 * z134 + z6 * z136;
    const Scalar z140 = k14 * z15 - k15 * z35 + k13 * z36;
    const Scalar z141 = z89 + z140;
    const Scalar z142 = k14 * z17 + k15 * z37 + k13 * z38;
    const Scalar z143 = z90 - z142;
    const Scalar z144 = k14 * z6 + k15 * z27 - k13 * z28;
    const Scalar z145 = z33 - z144;
    const Scalar z146 = z113 + z80;  // place of link7, x
    const Scalar z147 = k16 * z58 - k17 * z57;
    const Scalar z148 = z115 - z82;  // place of link7, y
    const Scalar z149 = k16 * z56 + k18 * z57;
    const Scalar z150 = z117 + z83;  // place of link7, z
    const Scalar z151 = k17 * z56 + k18 * z58;
    const Scalar z152 = z36 * z151 - z73 + z60 * z147 - z67 * z149;
    const Scalar z153 = k16 * z36 - k18 * z60 + k17 * z67;
    const Scalar z154 = z113 - z153;
    const Scalar z155 = z38 * z151 - z74 + z62 * z147 + z69 * z149;
    const Scalar z156 = z75 + z28 * z151 - z48 * z147 - z71 * z149;
    const Scalar z157 = k16 * z38 - k18 * z62 - k17 * z69;
    const Scalar z158 = z115 + z157;
    const Scalar z159 = k16 * z28 + k18 * z48 + k17 * z71;
    const Scalar z160 = z117 - z159;
    const Scalar z161 = k19 * z61 + k20 * z63;
    const Scalar z162 = k21 * z63 + k19 * z64;
    const Scalar z163 = k20 * z64 - k21 * z61;
    const Scalar z164 = z67 * z162 - z73 + z65 * z163 - z66 * z161;
    const Scalar z165 = z77 * z161 + z74 + z69 * z162 - z76 * z163;
    const Scalar z166 = z79 * z161 + z75 + z71 * z162 + z78 * z163;
    const Scalar z167 = k20 * z67 - k19 * z65 + k21 * z66;
    const Scalar z168 = z113 - z167;
    const Scalar z169 = k20 * z69 + k19 * z76 - k21 * z77;
    const Scalar z170 = z115 - z169;
    const Scalar z171 = k20 * z71 - k19 * z78 - k21 * z79;
    const Scalar z172 = z117 - z171;
    const Scalar z173 = k8 * s_q2 + k9 * c_q2;
    const Scalar z174 = n0_333 + z173;
    const Scalar z175 = n0_107 * z66;
    const Scalar z176 = z80 - z175;
    const Scalar z177 = z146 - z175;
    const Scalar z178 = n0_107 * z77;
    const Scalar z179 = z82 - z178;
    const Scalar z180 = z148 + z178;
    const Scalar z181 = n0_107 * z79;
    const Scalar z182 = z83 + z181;
    const Scalar z183 = z150 + z181;
    const Scalar z184 = z81 - z176;
    const Scalar z185 = z84 + z179;
    const Scalar z186 = z69 * z176 + z67 * z179;
    const Scalar z187 = z69 * z182 + z71 * z179;
    const Scalar z188 = z67 * z182 - z71 * z176;
    const Scalar z189 = z85 - z182;
    const Scalar z190 = z39 + z184;
    const Scalar z191 = z40 - z185;
    const Scalar z192 = z29 + z189;
    const Scalar z193 = z18 - z190;
    const Scalar z194 = z19 + z191;
    const Scalar z195 = z38 * z182 - z28 * z179;
    const Scalar z196 = z36 * z182 - z28 * z176;
    const Scalar z197 = z36 * z179 - z38 * z176;
    const Scalar z198 = c_q1 * z193 + s_q1 * z194;
    const Scalar z199 = z13 - z192;
    const Scalar z200 = z17 * z189 - z6 * z185;
    const Scalar z201 = z15 * z189 + z6 * z184;
    const Scalar z202 = z17 * z184 + z15 * z185;
    const Scalar z203 = z5 * z192 + c_q2 * z191;
    const Scalar z204 = z5 * z190 + z8 * z191;
    const Scalar z205 = c_q2 * z190 - z8 * z192;
    const Scalar z206 = k23 * z99 - k20 * z101;
    const Scalar z207 = c_q1 * z199;
    const Scalar z208 = s_q1 * z199;
    const Scalar z209 = k24 * z99 - k20 * z102;
    const Scalar z210 = n0_107 * z99;
    const Scalar z211 = k24 * z101 - k23 * z102;
    const Scalar z212 = n0_107 * z101;
    const Scalar z213 = z66 * z206 - z103 + z106 * z209 - z86 * z211;
    const Scalar z214 = z103 + z86 * z212 - z106 * z210;
    const Scalar z215 = k24 * z66 - k20 * z86 - k23 * z106;
    const Scalar z216 = k24 * z77 + k20 * z87 - k23 * z107;
    const Scalar z217 = k24 * z79 + k20 * z88 + k23 * z108;
    const Scalar z218 = z146 - z215;
    const Scalar z219 = z148 + z216;
    const Scalar z220 = z150 + z217;
    const Scalar z221 = z104 + z77 * z206 + z107 * z209 + z87 * z211;
    const Scalar z222 = z105 + z79 * z206 - z108 * z209 + z88 * z211;
    const Scalar z223 = z104 + z107 * z210 + z87 * z212;
    const Scalar z224 = z105 + z88 * z212 - z108 * z210;
    result.link1_position[0] = -z94;
    result.link1_position[1] = z95;
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
    result.link1_velocity[0] = -z111;
    result.link1_velocity[1] = -z112;
    result.link1_velocity[2] = n0;
    result.link1_angular_velocity[0] = n0;
    result.link1_angular_velocity[1] = n0;
    result.link1_angular_velocity[2] = v_q1;
    result.link2_position[0] = -z96;
    result.link2_position[1] = z97;
    result.link2_position[2] = z174;
    result.link2_rotation[0] = z4;
    result.link2_rotation[1] = z2;
    result.link2_rotation[2] = -s_q2;
    result.link2_rotation[3] = -z8;
    result.link2_rotation[4] = -z5;
    result.link2_rotation[5] = -c_q2;
    result.link2_rotation[6] = -s_q1;
    result.link2_rotation[7] = c_q1;
    result.link2_rotation[8] = n0;
    result.link2_velocity[0] = -z119;
    result.link2_velocity[1] = z120;
    result.link2_velocity[2] = -z121;
    result.link2_angular_velocity[0] = -z10;
    result.link2_angular_velocity[1] = z11;
    result.link2_angular_velocity[2] = v_q1;
    result.link3_position[0] = z129;
    result.link3_position[1] = z131;
    result.link3_position[2] = z133;
    result.link3_rotation[0] = -z14;
    result.link3_rotation[1] = z16;
    result.link3_rotation[2] = -z9;
    result.link3_rotation[3] = -z15;
    result.link3_rotation[4] = z17;
    result.link3_rotation[5] = z6;
    result.link3_rotation[6] = z8;
    result.link3_rotation[7] = z5;
    result.link3_rotation[8] = c_q2;
    result.link3_velocity[0] = z125;
    result.link3_velocity[1] = z126;
    result.link3_velocity[2] = z127;
    result.link3_angular_velocity[0] = z25;
    result.link3_angular_velocity[1] = z26;
    result.link3_angular_velocity[2] = z12;
    result.link4_position[0] = z141;
    result.link4_position[1] = z143;
    result.link4_position[2] = z145;
    result.link4_rotation[0] = z35;
    result.link4_rotation[1] = z37;
    result.link4_rotation[2] = z27;
    result.link4_rotation[3] = z36;
    result.link4_rotation[4] = -z38;
    result.link4_rotation[5] = z28;
    result.link4_rotation[6] = z15;
    result.link4_rotation[7] = -z17;
    result.link4_rotation[8] = -z6;
    result.link4_velocity[0] = z137;
    result.link4_velocity[1] = -z138;
    result.link4_velocity[2] = -z139;
    result.link4_angular_velocity[0] = z45;
    result.link4_angular_velocity[1] = -z46;
    result.link4_angular_velocity[2] = -z30;
    result.link5_position[0] = z154;
    result.link5_position[1] = z158;
    result.link5_position[2] = z160;
    result.link5_rotation[0] = -z60;
    result.link5_rotation[1] = z62;
    result.link5_rotation[2] = z48;
    result.link5_rotation[3] = -z67;
    result.link5_rotation[4] = -z69;
    result.link5_rotation[5] = -z71;
    result.link5_rotation[6] = z36;
    result.link5_rotation[7] = -z38;
    result.link5_rotation[8] = z28;
    result.link5_velocity[0] = -z152;
    result.link5_velocity[1] = z155;
    result.link5_velocity[2] = -z156;
    result.link5_angular_velocity[0] = z50;
    result.link5_angular_velocity[1] = -z53;
    result.link5_angular_velocity[2] = z47;
    result.link6_position[0] = z168;
    result.link6_position[1] = z170;
    result.link6_position[2] = z172;
    result.link6_rotation[0] = z65;
    result.link6_rotation[1] = -z76;
    result.link6_rotation[2] = z78;
    result.link6_rotation[3] = z66;
    result.link6_rotation[4] = -z77;
    result.link6_rotation[5] = -z79;
    result.link6_rotation[6] = z67;
    result.link6_rotation[7] = z69;
    result.link6_rotation[8] = z71;
    result.link6_velocity[0] = -z164;
    result.link6_velocity[1] = -z165;
    result.link6_velocity[2] = -z166;
    result.link6_angular_velocity[0] = z68;
    result.link6_angular_velocity[1] = z70;
    result.link6_angular_velocity[2] = z72;
    result.link7_position[0] = z218;
    result.link7_position[1] = z219;
    result.link7_position[2] = z220;
    result.link7_rotation[0] = z86;
    result.link7_rotation[1] = z87;
    result.link7_rotation[2] = z88;
    result.link7_rotation[3] = -z106;
    result.link7_rotation[4] = z107;
    result.link7_rotation[5] = -z108;
    result.link7_rotation[6] = -z66;
    result.link7_rotation[7] = z77;
    result.link7_rotation[8] = z79;
    result.link7_velocity[0] = z213;
    result.link7_velocity[1] = -z221;
    result.link7_velocity[2] = -z222;
    result.link7_angular_velocity[0] = -z91;
    result.link7_angular_velocity[1] = z92;
    result.link7_angular_velocity[2] = z93;
    result.tip_position[0] = z177;
    result.tip_position[1] = z180;
    result.tip_position[2] = z183;
    result.tip_velocity[0] = -z214;
    result.tip_velocity[1] = -z223;
    result.tip_velocity[2] = -z224;
    result.tip_jacobian[0] = -z194;
    result.tip_jacobian[3] = z207;
    result.tip_jacobian[6] = -z203;
    result.tip_jacobian[9] = z200;
    result.tip_jacobian[12] = -z195;
    result.tip_jacobian[15] = z187;
    result.tip_jacobian[18] = n0;
    result.tip_jacobian[1] = z193;
    result.tip_jacobian[4] = z208;
    result.tip_jacobian[7] = -z205;
    result.tip_jacobian[10] = z201;
    result.tip_jacobian[13] = -z196;
    result.tip_jacobian[16] = -z188;
    result.tip_jacobian[19] = n0;
    result.tip_jacobian[2] = n0;
    result.tip_jacobian[5] = -z198;
    result.tip_jacobian[8] = z204;
    result.tip_jacobian[11] = -z202;
    result.tip_jacobian[14] = -z197;
    result.tip_jacobian[17] = -z186;
    result.tip_jacobian[20] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 49>& mass) noexcept {
    const Scalar k0 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k1 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar k2 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k3 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k4 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k5 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k6 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k8 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k10 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k11 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k12 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k15 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k16 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k17 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar k19 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k20 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k21 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k22 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k23 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k24 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k25 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar k27 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k28 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k29 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k30 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k32 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k33 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k34 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k35 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k36 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k37 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k38 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k39 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k40 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k41 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k42 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k43 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k44 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k45 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k46 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k47 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k48 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar q_q2 = state.q.q2;
    const Scalar q_q3 = state.q.q3;
    const Scalar q_q4 = state.q.q4;
    const Scalar q_q5 = state.q.q5;
    const Scalar q_q6 = state.q.q6;
    const Scalar q_q7 = state.q.q7;
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z0 = k0 * s_q7 - k1 * c_q7;
    const Scalar z1 = k2 * s_q7 + k3 * c_q7;
    const Scalar z2 = k4 * s_q7 - k5 * c_q7;
    const Scalar z3 = k3 * s_q7 - k2 * c_q7;
    const Scalar z4 = k5 * s_q7 + k4 * c_q7;
    const Scalar z5 = k6 + n16_over_15 * z1;
    const Scalar z6 = c_q6 * z3;
    const Scalar z7 = s_q6 * z3;
    const Scalar z8 = s_q7 * z0;
    const Scalar z9 = k8 + c_q7 * z0;
    const Scalar z10 = k6 + n32_over_15 * z1;
    const Scalar z11 = k10 + z1;
    const Scalar z12 = k11 - z2;
    const Scalar z13 = k12 + z4;
    const Scalar z14 = s_q5 * z1 - c_q5 * z6;
    const Scalar z15 = c_q5 * z1 + s_q5 * z6;
    const Scalar z16 = k0 - z8;
    const Scalar z17 = n32_over_15 * z1 + z8;
    const Scalar z18 = s_q6 * z11 - k13 * c_q6;
    const Scalar z19 = k13 * s_q6 + c_q6 * z11;
    const Scalar z20 = c_q6 * z2 + s_q6 * z5;
    const Scalar z21 = n2 * z12;
    const Scalar z22 = s_q6 * z2 - c_q6 * z5;
    const Scalar z23 = n16_over_15 * z3 - z9;
    const Scalar z24 = k15 - z16;
    const Scalar z25 = s_q4 * z7 + c_q4 * z14;
    const Scalar z26 = s_q4 * z14 - c_q4 * z7;
    const Scalar z27 = k16 + z17;
    const Scalar z28 = s_q5 * z4 - c_q5 * z20;
    const Scalar z29 = c_q5 * z4 + s_q5 * z20;
    const Scalar z30 = z22 + z15;
    const Scalar z31 = k17 + z23;
    const Scalar z32 = z10 + z24;
    const Scalar z33 = c_q5 * z18;
    const Scalar z34 = s_q5 * z18;
    const Scalar z35 = s_q3 * z15 + c_q3 * z25;
    const Scalar z36 = s_q3 * z25 - c_q3 * z15;
    const Scalar z37 = s_q6 * z13 + c_q6 * z31;
    const Scalar z38 = s_q6 * z31 - c_q6 * z13;
    const Scalar z39 = n256_over_55 * z15 - z28;
    const Scalar z40 = k19 - z3;
    const Scalar z41 = k20 - z19;
    const Scalar z42 = z7 - n256_over_55 * z14 - z29;
    const Scalar z43 = s_q6 * z32 - c_q6 * z21;
    const Scalar z44 = s_q4 * z19 + c_q4 * z33;
    const Scalar z45 = s_q4 * z33 - c_q4 * z19;
    const Scalar z46 = z42 + z26;
    const Scalar z47 = s_q5 * z27 - c_q5 * z37;
    const Scalar z48 = c_q5 * z27 + s_q5 * z37;
    const Scalar z49 = k21 - z37;
    const Scalar z50 = s_q4 * z30 - c_q4 * z39;
    const Scalar z51 = c_q4 * z30 + s_q4 * z39;
    const Scalar z52 = k22 + z38;
    const Scalar z53 = z19 - n256_over_55 * z33 - z48;
    const Scalar z54 = z15 - z51;
    const Scalar z55 = c_q6 * z43 + z12;
    const Scalar z56 = z53 + z45;
    const Scalar z57 = s_q6 * z43;
    const Scalar z58 = z24 - z57;
    const Scalar z59 = z10 - z57;
    const Scalar z60 = k23 + z55;
    const Scalar z61 = s_q5 * z40 + c_q5 * z41;
    const Scalar z62 = s_q5 * z41 - c_q5 * z40;
    const Scalar z63 = k24 - z58;
    const Scalar z64 = k25 + z59;
    const Scalar z65 = s_q5 * z60 - c_q5 * z52;
    const Scalar z66 = s_q5 * z52 + c_q5 * z60;
    const Scalar z67 = z38 - z34;
    const Scalar z68 = n256_over_55 * z34 + z47;
    const Scalar z69 = s_q4 * z67 + c_q4 * z68;
    const Scalar z70 = s_q4 * z68 - c_q4 * z67;
    const Scalar z71 = s_q3 * z46 - c_q3 * z50;
    const Scalar z72 = n632_over_165 * z36 - z71;
    const Scalar z73 = n256_over_55 * z61 - z66;
    const Scalar z74 = c_q3 * z46 + s_q3 * z50;
    const Scalar z75 = n256_over_55 * z62 - z65;
    const Scalar z76 = z64 + z61;
    const Scalar z77 = n632_over_165 * z35 - z74;
    const Scalar z78 = c_q4 * z62;
    const Scalar z79 = c_q3 * z34 + s_q3 * z44;
    const Scalar z80 = s_q2 * z72 - c_q2 * z54;
    const Scalar z81 = n2 * z49;
    const Scalar z82 = z27 - z63;
    const Scalar z83 = c_q5 * z81 + s_q5 * z82;
    const Scalar z84 = z18 + n256_over_55 * z61 - z66;
    const Scalar z85 = z64 + n2 * z61;
    const Scalar z86 = k27 + z84;
    const Scalar z87 = k28 + z75;
    const Scalar z88 = z34 - z70;
    const Scalar z89 = s_q3 * z34 - c_q3 * z44;
    const Scalar z90 = s_q5 * z83;
    const Scalar z91 = c_q5 * z83 - z49;
    const Scalar z92 = k29 + z18;
    const Scalar z93 = k30 + z61;
    const Scalar z94 = z63 + z90;
    const Scalar z95 = z27 - z90;
    const Scalar z96 = z62 + z91;
    const Scalar z97 = s_q4 * z92 + c_q4 * z93;
    const Scalar z98 = s_q4 * z93 - c_q4 * z92;
    const Scalar z99 = n512_over_55 * z18 + z94;
    const Scalar z100 = z95 + n512_over_55 * z18 + n2 * z61;
    const Scalar z101 = k32 + z99;
    const Scalar z102 = k33 + z96;
    const Scalar z103 = s_q4 * z62;
    const Scalar z104 = z75 - z103;
    const Scalar z105 = s_q4 * z76 - c_q4 * z73;
    const Scalar z106 = c_q4 * z76 + s_q4 * z73;
    const Scalar z107 = k34 + z100;
    const Scalar z108 = s_q3 * z78 - c_q3 * z61;
    const Scalar z109 = z61 - z106;
    const Scalar z110 = s_q3 * z61 + c_q3 * z78;
    const Scalar z111 = c_q3 * z105 + s_q3 * z104;
    const Scalar z112 = n632_over_165 * z108 + z111;
    const Scalar z113 = s_q3 * z56 - c_q3 * z69;
    const Scalar z114 = c_q3 * z56 + s_q3 * z69;
    const Scalar z115 = s_q4 * z87 + c_q4 * z102;
    const Scalar z116 = n632_over_165 * z89 + z114;
    const Scalar z117 = s_q4 * z102 - c_q4 * z87;
    const Scalar z118 = n632_over_165 * z79 - z113;
    const Scalar z119 = z107 - z97;
    const Scalar z120 = s_q3 * z105 - c_q3 * z104;
    const Scalar z121 = c_q3 * z98;
    const Scalar z122 = c_q2 * z88 + s_q2 * z118;
    const Scalar z123 = z85 - z101;
    const Scalar z124 = n2 * z86;
    const Scalar z125 = s_q4 * z123 - c_q4 * z124;
    const Scalar z126 = z62 - z115;
    const Scalar z127 = k35 - z126;
    const Scalar z128 = z107 - n2 * z97;
    const Scalar z129 = k36 - z62;
    const Scalar z130 = k37 + z117;
    const Scalar z131 = k38 - z97;
    const Scalar z132 = n2 * z127;
    const Scalar z133 = n632_over_165 * z110 - z120;
    const Scalar z134 = s_q4 * z125;
    const Scalar z135 = c_q4 * z125 + z86;
    const Scalar z136 = s_q3 * z129 - c_q3 * z131;
    const Scalar z137 = z101 + z134;
    const Scalar z138 = z85 - z134;
    const Scalar z139 = z98 - z135;
    const Scalar z140 = c_q3 * z129 + s_q3 * z131;
    const Scalar z141 = k39 + z137;
    const Scalar z142 = n2 * z97 - z138;
    const Scalar z143 = k40 - z139;
    const Scalar z144 = s_q3 * z98;
    const Scalar z145 = c_q3 * z115 + s_q3 * z119;
    const Scalar z146 = z128 - z141;
    const Scalar z147 = s_q3 * z130 - c_q3 * z143;
    const Scalar z148 = s_q2 * z112 - c_q2 * z109;
    const Scalar z149 = c_q3 * z132 + s_q3 * z146;
    const Scalar z150 = n632_over_165 * z136 + z147;
    const Scalar z151 = s_q3 * z149;
    const Scalar z152 = k41 - z142;
    const Scalar z153 = c_q3 * z130 + s_q3 * z143;
    const Scalar z154 = k42 + z150;
    const Scalar z155 = z141 + z151;
    const Scalar z156 = n632_over_165 * z140 + z153;
    const Scalar z157 = z128 - z151;
    const Scalar z158 = n2 * z154;
    const Scalar z159 = c_q3 * z149 - z127;
    const Scalar z160 = k43 * z98 - z155;
    const Scalar z161 = k44 + z156;
    const Scalar z162 = s_q3 * z115 - c_q3 * z119;
    const Scalar z163 = n632_over_165 * z144 - z145;
    const Scalar z164 = k45 - z160;
    const Scalar z165 = k46 - z159;
    const Scalar z166 = k43 * z98 - z157;
    const Scalar z167 = n632_over_165 * z121 + z162;
    const Scalar z168 = z152 - z164;
    const Scalar z169 = c_q2 * z117 + s_q2 * z163;
    const Scalar z170 = s_q2 * z150 - c_q2 * z152;
    const Scalar z171 = c_q2 * z158 + s_q2 * z168;
    const Scalar z172 = k47 - z166;
    const Scalar z173 = c_q2 * z161 + s_q2 * z165;
    const Scalar z174 = s_q2 * z171;
    const Scalar z175 = z152 - z174;
    const Scalar z176 = k48 + z175;
    mass[0] = z176;
    mass[1] = -z173;
    mass[2] = -z170;
    mass[3] = z169;
    mass[4] = z148;
    mass[5] = -z122;
    mass[6] = z80;
    mass[7] = -z173;
    mass[8] = z172;
    mass[9] = -z156;
    mass[10] = z167;
    mass[11] = z133;
    mass[12] = z116;
    mass[13] = z77;
    mass[14] = -z170;
    mass[15] = -z156;
    mass[16] = z152;
    mass[17] = z117;
    mass[18] = -z109;
    mass[19] = -z88;
    mass[20] = -z54;
    mass[21] = z169;
    mass[22] = z167;
    mass[23] = z117;
    mass[24] = z107;
    mass[25] = -z75;
    mass[26] = -z53;
    mass[27] = z42;
    mass[28] = z148;
    mass[29] = z133;
    mass[30] = -z109;
    mass[31] = -z75;
    mass[32] = z64;
    mass[33] = -z38;
    mass[34] = z22;
    mass[35] = -z122;
    mass[36] = z116;
    mass[37] = -z88;
    mass[38] = -z53;
    mass[39] = -z38;
    mass[40] = z27;
    mass[41] = -z4;
    mass[42] = z80;
    mass[43] = z77;
    mass[44] = -z54;
    mass[45] = z42;
    mass[46] = z22;
    mass[47] = -z4;
    mass[48] = k6;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar k4 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k5 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k7 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k8 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k9 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k10 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k11 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k12 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k14 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k15 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k16 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k17 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k18 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k19 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k20 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k21 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k22 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k23 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k24 = traits::constant(0.02914515311624745, 0.029145153f, "3643144139530931/125000000000000000");
    const Scalar k25 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k26 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k27 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k28 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k29 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k30 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k31 = traits::constant(0.011496343893347959, 0.011496344f, "11496343893347959/1000000000000000000");
    const Scalar k32 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k33 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k36 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k37 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k38 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k39 = traits::constant(0.6310729011877872, 0.6310729f, "631072901187787269/1000000000000000000");
    const Scalar k40 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k41 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k42 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k43 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k44 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k45 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k46 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k47 = traits::constant(0.07860781999140594, 0.07860782f, "19651954997851483/250000000000000000");
    const Scalar k48 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k49 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k50 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k51 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k52 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k53 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k54 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k55 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k56 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k57 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
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
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z0 = v_q1 * c_q2;
    const Scalar z1 = v_q1 * s_q2;
    const Scalar z2 = v_q2 * v_q2;
    const Scalar z3 = k0 * s_q2;
    const Scalar z4 = k0 * c_q2;
    const Scalar z5 = v_q2 * z0;  // angular acceleration of link2, x
    const Scalar z6 = v_q2 * z1;  // angular acceleration of link2, y
    const Scalar z7 = z1 * z0;
    const Scalar z8 = z1 * z1;
    const Scalar z9 = v_q2 * s_q3 - c_q3 * z1;
    const Scalar z10 = v_q2 * c_q3 + s_q3 * z1;
    const Scalar z11 = v_q3 + z0;  // angular velocity of link3, z
    const Scalar z12 = z2 + z8;
    const Scalar z13 = n2 * z5;
    const Scalar z14 = c_q3 * z5;
    const Scalar z15 = s_q3 * z5;
    const Scalar z16 = z3 + n632_over_165 * z7;
    const Scalar z17 = z11 * z11;
    const Scalar z18 = z10 * z10;
    const Scalar z19 = z9 * z10;
    const Scalar z20 = z9 * z11;
    const Scalar z21 = s_q4 * z11 + c_q4 * z9;
    const Scalar z22 = s_q4 * z9 - c_q4 * z11;
    const Scalar z23 = v_q4 - z10;  // angular velocity of link4, z
    const Scalar z24 = z4 - n632_over_165 * z12;
    const Scalar z25 = n632_over_165 * z13;
    const Scalar z26 = v_q3 * z10 - z14;  // angular acceleration of link3, x
    const Scalar z27 = v_q3 * z9 - z15;  // angular acceleration of link3, y
    const Scalar z28 = z18 + z17;
    const Scalar z29 = z6 - z19;
    const Scalar z30 = z23 * z23;
    const Scalar z31 = s_q3 * z25 - c_q3 * z16;
    const Scalar z32 = s_q3 * z16 + c_q3 * z25;
    const Scalar z33 = z27 + z20;
    const Scalar z34 = s_q4 * z6 - c_q4 * z26;
    const Scalar z35 = c_q4 * z6 + s_q4 * z26;
    const Scalar z36 = z21 * z21;
    const Scalar z37 = z21 * z23;
    const Scalar z38 = s_q5 * z23 - c_q5 * z21;
    const Scalar z39 = c_q5 * z23 + s_q5 * z21;
    const Scalar z40 = z22 * z22;
    const Scalar z41 = z21 * z22;
    const Scalar z42 = z22 * z23;
    const Scalar z43 = v_q5 - z22;  // angular velocity of link5, z
    const Scalar z44 = z24 + z33;
    const Scalar z45 = z30 + z36;
    const Scalar z46 = z32 - z29;
    const Scalar z47 = v_q4 * z22 + z34;  // angular acceleration of link4, x
    const Scalar z48 = v_q4 * z21 + z35;  // angular acceleration of link4, y
    const Scalar z49 = z40 + z30;
    const Scalar z50 = z27 + z41;
    const Scalar z51 = z27 - z41;
    const Scalar z52 = s_q6 * z43 - c_q6 * z38;
    const Scalar z53 = s_q6 * z38 + c_q6 * z43;
    const Scalar z54 = v_q6 + z39;  // angular velocity of link6, z
    const Scalar z55 = z31 - z28;
    const Scalar z56 = z54 * z54;
    const Scalar z57 = z48 + z37;
    const Scalar z58 = z47 + z42;
    const Scalar z59 = s_q5 * z27 + c_q5 * z47;
    const Scalar z60 = s_q5 * z47 - c_q5 * z27;
    const Scalar z61 = s_q4 * z44 + c_q4 * z55;
    const Scalar z62 = s_q4 * z55 - c_q4 * z44;
    const Scalar z63 = z46 + z57 + n256_over_55 * z58;
    const Scalar z64 = z53 * z53;
    const Scalar z65 = z52 * z53;
    const Scalar z66 = z52 * z54;
    const Scalar z67 = s_q7 * z54 + c_q7 * z52;
    const Scalar z68 = v_q5 * z39 + z59;  // angular acceleration of link5, x
    const Scalar z69 = z49 - n256_over_55 * z50 + z61;
    const Scalar z70 = v_q5 * z38 + z60;  // angular acceleration of link5, y
    const Scalar z71 = s_q6 * z48 + c_q6 * z68;
    const Scalar z72 = s_q7 * z52 - c_q7 * z54;
    const Scalar z73 = v_q7 - z53;  // angular velocity of link7, z
    const Scalar z74 = n256_over_55 * z45 + z51 + z62;
    const Scalar z75 = v_q6 * z53 - z71;  // angular acceleration of link6, x
    const Scalar z76 = s_q6 * z68 - c_q6 * z48;
    const Scalar z77 = v_q6 * z52 - z76;  // angular acceleration of link6, y
    const Scalar z78 = z72 * z72;
    const Scalar z79 = z67 * z72;
    const Scalar z80 = z67 * z67;
    const Scalar z81 = c_q7 * z70 + s_q7 * z75;
    const Scalar z82 = z73 * z73;
    const Scalar z83 = v_q7 * z67 + z81;  // angular acceleration of link7, y
    const Scalar z84 = z67 * z73;
    const Scalar z85 = z72 * z73;
    const Scalar z86 = c_q5 * z69 + s_q5 * z63;
    const Scalar z87 = s_q5 * z69 - c_q5 * z63;
    const Scalar z88 = z53 * z54;
    const Scalar z89 = z52 * z52;
    const Scalar z90 = z78 - z80;
    const Scalar z91 = s_q7 * z70 - c_q7 * z75;
    const Scalar z92 = v_q7 * z72 + z91;  // angular acceleration of link7, x
    const Scalar z93 = z82 + z80;
    const Scalar z94 = z82 - z80;
    const Scalar z95 = z56 - z89;
    const Scalar z96 = z78 - z82;
    const Scalar z97 = z78 + z82;
    const Scalar z98 = c_q6 * z74 + s_q6 * z86;
    const Scalar z99 = z70 - z65;
    const Scalar z100 = z77 + z79;
    const Scalar z101 = k4 * z97 - k5 * z100;  // force on link7, times 0.0825 m, x
    const Scalar z102 = z77 - z79;
    const Scalar z103 = k5 * z93 + k4 * z102;  // force on link7, times 0.0825 m, y
    const Scalar z104 = z70 + z65;
    const Scalar z105 = s_q6 * z74 - c_q6 * z86;
    const Scalar z106 = z64 - z89;
    const Scalar z107 = z56 + z89;
    const Scalar z108 = z64 + z56;
    const Scalar z109 = z64 - z56;
    const Scalar z110 = z83 + z84;
    const Scalar z111 = z83 - z84;
    const Scalar z112 = z77 + z66;
    const Scalar z113 = z77 - z66;
    const Scalar z114 = z98 + n16_over_15 * z99;
    const Scalar z115 = z92 + z85;
    const Scalar z116 = z92 - z85;
    const Scalar z117 = k7 * z94 + k8 * z100 + k4 * z114 + k9 * z110 - k10 * z115;  // moment on link7, y
    const Scalar z118 = k8 * z96 + k7 * z102 + k5 * z114 - k10 * z110 + k11 * z115;  // moment on link7, x
    const Scalar z119 = k4 * z110 + k5 * z115;  // force on link7, times 0.0825 m, z
    const Scalar z120 = k12 * z99 + z119 - k13 * z107;  // force on link6, times 0.0825 m, y
    const Scalar z121 = z105 + n16_over_15 * z108;
    const Scalar z122 = z43 * z43;
    const Scalar z123 = z38 * z39;
    const Scalar z124 = z38 * z38;
    const Scalar z125 = z87 + n16_over_15 * z112;
    const Scalar z126 = z75 + z88;
    const Scalar z127 = z75 - z88;
    const Scalar z128 = z39 * z39;
    const Scalar z129 = s_q7 * z103 + c_q7 * z101;
    const Scalar z130 = s_q7 * z101 - c_q7 * z103;
    const Scalar z131 = k12 * z108 + z129 + k13 * z104;  // force on link6, times 0.0825 m, x
    const Scalar z132 = z48 + z123;
    const Scalar z133 = s_q7 * z121 + c_q7 * z125;
    const Scalar z134 = s_q7 * z125 - c_q7 * z121;
    // moment on link7, z
    const Scalar z135 = k14 * z79 + k10 * z90 + k15 * z77 + k7 * z116 + k8 * z111 + k4 * z133 + k5 * z134;
    // moment on link6, y
    const Scalar z136 = k16 * z95 + k17 * z104 + k12 * z87 - k18 * z126 + k19 * z112 - n16_over_15 * z130 + z135;
    const Scalar z137 = z47 - z42;
    const Scalar z138 = z39 * z43;
    const Scalar z139 = z38 * z43;
    const Scalar z140 = k12 * z112 - z130 - k13 * z126;  // force on link6, times 0.0825 m, z
    const Scalar z141 = z48 - z37;
    const Scalar z142 = z122 - z124;
    const Scalar z143 = z128 - z124;
    const Scalar z144 = z122 + z124;
    const Scalar z145 = z128 - z122;
    const Scalar z146 = z128 + z122;
    const Scalar z147 = z68 - z138;
    const Scalar z148 = z68 + z138;
    const Scalar z149 = z48 - z123;
    const Scalar z150 = z140 - k20 * z149 + k21 * z144;  // force on link5, times 0.0825 m, y
    const Scalar z151 = z40 - z36;
    const Scalar z152 = z30 - z36;
    const Scalar z153 = z40 - z30;
    const Scalar z154 = z70 - z139;
    const Scalar z155 = z70 + z139;
    const Scalar z156 = s_q7 * z117 - c_q7 * z118;
    const Scalar z157 = k13 * z87 - k17 * z109 - k16 * z99 - k22 * z126 + k18 * z112 - z156;  // moment on link6, x
    const Scalar z158 = s_q7 * z118 + c_q7 * z117;
    // moment on link6, z
    const Scalar z159 = k18 * z106 - k23 * z65 + k24 * z70 + k13 * z105 + k12 * z98 + k16 * z127 + k17 * z113
        + n16_over_15 * z119 + z158;
    const Scalar z160 = k25 * z142 + k26 * z132 + k20 * z74 - k27 * z148 - k28 * z155 - z159;  // moment on link5, y
    const Scalar z161 = z10 * z11;
    const Scalar z162 = z9 * z9;
    const Scalar z163 = z27 - z20;
    const Scalar z164 = s_q6 * z120 - c_q6 * z131;
    const Scalar z165 = z164 + k20 * z146 + k21 * z132;  // force on link5, times 0.0825 m, x
    const Scalar z166 = s_q6 * z131 + c_q6 * z120;
    const Scalar z167 = z166 - k20 * z155 + k21 * z148;  // force on link5, times 0.0825 m, z
    const Scalar z168 = s_q6 * z136 - c_q6 * z157;
    const Scalar z169 = k21 * z74 - k26 * z145 - k25 * z149 + k29 * z148 + k27 * z155 - z168;  // moment on link5, x
    const Scalar z170 = c_q6 * z136 + s_q6 * z157;
    // moment on link5, z
    const Scalar z171 = k30 * z123 + k31 * z48 - k27 * z143 - k25 * z147 - k26 * z154 + k21 * z86 - k20 * z87 + z170;
    const Scalar z172 = z167 + k32 * z45 + k33 * z51;  // force on link4, times 0.0825 m, y
    const Scalar z173 = z0 * z0;
    const Scalar z174 = z6 + z19;
    const Scalar z175 = s_q5 * z150 + c_q5 * z165;
    const Scalar z176 = s_q5 * z165 - c_q5 * z150;
    const Scalar z177 = k33 * z46 - k34 * z152 + k35 * z50 + k36 * z57 + k37 * z58 + z171 + z176;  // moment on link4, y
    const Scalar z178 = z175 + k33 * z49 - k32 * z50;  // force on link4, times 0.0825 m, x
    const Scalar z179 = z18 - z17;
    const Scalar z180 = z18 - z162;
    const Scalar z181 = z17 - z162;
    const Scalar z182 = z17 + z162;
    const Scalar z183 = s_q5 * z160 - c_q5 * z169;
    // moment on link4, x
    const Scalar z184 = k32 * z46 - k34 * z51 + k35 * z153 + k37 * z57 + k38 * z58 - z183 + n256_over_55 * z176;
    const Scalar z185 = z176 + k33 * z57 + k32 * z58;  // force on link4, times 0.0825 m, z
    const Scalar z186 = c_q5 * z160 + s_q5 * z169;
    // moment on link4, z
    const Scalar z187 = k39 * z27 + k40 * z41 - k37 * z151 - k34 * z137 + k35 * z141 - k32 * z61 + k33 * z62 + z167
        + z186 - n256_over_55 * z175;
    const Scalar z188 = k41 * z29 - z185 + k42 * z182;  // force on link3, times 0.0825 m, y
    const Scalar z189 = z26 - z161;
    const Scalar z190 = z26 + z161;
    const Scalar z191 = s_q4 * z177 - c_q4 * z184;
    const Scalar z192 = k42 * z24 + k43 * z29 - k44 * z179 + k45 * z33 + k46 * z190 + z191;  // moment on link3, x
    const Scalar z193 = c_q4 * z177 + s_q4 * z184;
    // moment on link3, z
    const Scalar z194 = k47 * z6 - k48 * z19 - k45 * z180 + k43 * z189 - k44 * z163 - k41 * z32 + k42 * z31 - z185
        + z193;
    const Scalar z195 = n2 * z6;
    const Scalar z196 = s_q4 * z172 + c_q4 * z178;
    const Scalar z197 = s_q4 * z178 - c_q4 * z172;
    // moment on link3, y
    const Scalar z198 = k41 * z24 - k44 * z174 + k43 * z181 + k49 * z33 + k45 * z190 + z187 + z197;
    const Scalar z199 = z2 - z173;
    const Scalar z200 = k41 * z28 - z196 - k42 * z174;  // force on link3, times 0.0825 m, x
    const Scalar z201 = c_q3 * z192 + s_q3 * z198;
    const Scalar z202 = c_q3 * z188 + s_q3 * z200;
    const Scalar z203 = z2 - z8;
    const Scalar z204 = z8 - z173;
    const Scalar z205 = s_q3 * z192 - c_q3 * z198;
    // moment on link2, x
    const Scalar z206 = k50 * z7 - k51 * z13 - k52 * z195 - k53 * z199 + z201 + n632_over_165 * z202;
    const Scalar z207 = s_q3 * z188 - c_q3 * z200;
    const Scalar z208 = k53 * z7 - k52 * z13 - k54 * z195 - k50 * z203 - z194;  // moment on link2, y
    // moment on link2, z
    const Scalar z209 = k55 * z3 - k56 * z4 + k57 * z7 + k52 * z204 - z205 - n632_over_165 * z207;
    const Scalar z210 = s_q2 * z206 - c_q2 * z208;
    forces.q1 = -z210;
    forces.q2 = -z209;
    forces.q3 = -z194;
    forces.q4 = z187;
    forces.q5 = -z171;
    forces.q6 = -z159;
    forces.q7 = z135;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar k3 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k4 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k6 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k7 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k8 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k9 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k10 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k11 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k12 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k13 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k14 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k15 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k16 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k17 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k18 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k19 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k20 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k21 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k22 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k23 = traits::constant(0.02914515311624745, 0.029145153f, "3643144139530931/125000000000000000");
    const Scalar k24 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k25 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k26 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k27 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k28 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k29 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k30 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k31 = traits::constant(0.011496343893347959, 0.011496344f, "11496343893347959/1000000000000000000");
    const Scalar k32 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k33 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k34 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k35 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k36 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k37 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k38 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k39 = traits::constant(0.6310729011877872, 0.6310729f, "631072901187787269/1000000000000000000");
    const Scalar k40 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k41 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k42 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k43 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k44 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k45 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k46 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k47 = traits::constant(0.07860781999140594, 0.07860782f, "19651954997851483/250000000000000000");
    const Scalar k48 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k49 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k50 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k51 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k52 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k53 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k54 = traits::constant(0.9793493837268126, 0.9793494f, "489674691863406311/500000000000000000");
    const Scalar k55 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k56 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k57 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
    const Scalar k58 = traits::constant(0.014259565994474374, 0.014259566f, "7129782997237187/500000000000000000");
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
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z0 = v_q1 * c_q2;
    const Scalar z1 = a_q1 * s_q2;
    const Scalar z2 = v_q1 * s_q2;
    const Scalar z3 = a_q1 * c_q2;
    const Scalar z4 = v_q2 * v_q2;
    const Scalar z5 = k0 * s_q2;
    const Scalar z6 = k0 * c_q2;
    const Scalar z7 = v_q2 * z0 + z1;  // angular acceleration of link2, x
    const Scalar z8 = v_q2 * z2 - z3;  // angular acceleration of link2, y
    const Scalar z9 = z2 * z0;
    const Scalar z10 = z2 * z2;
    const Scalar z11 = v_q2 * z0;
    const Scalar z12 = v_q2 * s_q3 - c_q3 * z2;
    const Scalar z13 = v_q2 * c_q3 + s_q3 * z2;
    const Scalar z14 = v_q3 + z0;  // angular velocity of link3, z
    const Scalar z15 = a_q2 - z9;
    const Scalar z16 = z4 + z10;
    const Scalar z17 = z14 * z14;
    const Scalar z18 = z7 + z11;
    const Scalar z19 = a_q2 * s_q3 - c_q3 * z7;
    const Scalar z20 = a_q2 * c_q3 + s_q3 * z7;
    const Scalar z21 = a_q3 - z8;  // angular acceleration of link3, z
    const Scalar z22 = z13 * z13;
    const Scalar z23 = z12 * z13;
    const Scalar z24 = z12 * z14;
    const Scalar z25 = s_q4 * z14 + c_q4 * z12;
    const Scalar z26 = s_q4 * z12 - c_q4 * z14;
    const Scalar z27 = v_q4 - z13;  // angular velocity of link4, z
    const Scalar z28 = z5 - n632_over_165 * z15;
    const Scalar z29 = z6 - n632_over_165 * z16;
    const Scalar z30 = n632_over_165 * z18;
    const Scalar z31 = z22 + z17;
    const Scalar z32 = z21 + z23;
    const Scalar z33 = z27 * z27;
    const Scalar z34 = v_q3 * z13 + z19;  // angular acceleration of link3, x
    const Scalar z35 = v_q3 * z12 - z20;  // angular acceleration of link3, y
    const Scalar z36 = s_q3 * z30 - c_q3 * z28;
    const Scalar z37 = s_q3 * z28 + c_q3 * z30;
    const Scalar z38 = z25 * z25;
    const Scalar z39 = z25 * z27;
    const Scalar z40 = s_q5 * z27 - c_q5 * z25;
    const Scalar z41 = c_q5 * z27 + s_q5 * z25;
    const Scalar z42 = z26 * z26;
    const Scalar z43 = z25 * z26;
    const Scalar z44 = z26 * z27;
    const Scalar z45 = v_q5 - z26;  // angular velocity of link5, z
    const Scalar z46 = z35 + z24;
    const Scalar z47 = s_q4 * z21 + c_q4 * z34;
    const Scalar z48 = s_q4 * z34 - c_q4 * z21;
    const Scalar z49 = a_q4 + z35;  // angular acceleration of link4, z
    const Scalar z50 = z33 + z38;
    const Scalar z51 = z42 + z33;
    const Scalar z52 = s_q6 * z45 - c_q6 * z40;
    const Scalar z53 = s_q6 * z40 + c_q6 * z45;
    const Scalar z54 = v_q6 + z41;  // angular velocity of link6, z
    const Scalar z55 = z29 + z46;
    const Scalar z56 = z49 + z43;
    const Scalar z57 = z49 - z43;
    const Scalar z58 = v_q4 * z26 - z47;  // angular acceleration of link4, x
    const Scalar z59 = z36 - z31;
    const Scalar z60 = z37 + z32;
    const Scalar z61 = z54 * z54;
    const Scalar z62 = v_q4 * z25 + z48;  // angular acceleration of link4, y
    const Scalar z63 = s_q4 * z55 + c_q4 * z59;
    const Scalar z64 = s_q4 * z59 - c_q4 * z55;
    const Scalar z65 = z58 + z44;
    const Scalar z66 = s_q5 * z49 + c_q5 * z58;
    const Scalar z67 = s_q5 * z58 - c_q5 * z49;
    const Scalar z68 = s_q7 * z54 + c_q7 * z52;
    const Scalar z69 = v_q5 * z41 + z66;  // angular acceleration of link5, x
    const Scalar z70 = a_q5 - z62;  // angular acceleration of link5, z
    const Scalar z71 = z62 + z39;
    const Scalar z72 = z51 - n256_over_55 * z56 + z63;
    const Scalar z73 = v_q5 * z40 + z67;  // angular acceleration of link5, y
    const Scalar z74 = c_q6 * z70 + s_q6 * z69;
    const Scalar z75 = v_q7 - z53;  // angular velocity of link7, z
    const Scalar z76 = s_q6 * z70 - c_q6 * z69;
    const Scalar z77 = a_q6 - z73;  // angular acceleration of link6, z
    const Scalar z78 = z60 + n256_over_55 * z65 + z71;
    const Scalar z79 = v_q6 * z52 - z74;  // angular acceleration of link6, y
    const Scalar z80 = v_q6 * z53 + z76;  // angular acceleration of link6, x
    const Scalar z81 = s_q7 * z52 - c_q7 * z54;
    const Scalar z82 = z75 * z75;
    const Scalar z83 = z68 * z68;
    const Scalar z84 = n256_over_55 * z50 + z57 + z64;
    const Scalar z85 = a_q7 + z79;  // angular acceleration of link7, z
    const Scalar z86 = z81 * z81;
    const Scalar z87 = z68 * z81;
    const Scalar z88 = z82 + z83;
    const Scalar z89 = c_q5 * z72 + s_q5 * z78;
    const Scalar z90 = s_q5 * z72 - c_q5 * z78;
    const Scalar z91 = z53 * z53;
    const Scalar z92 = z52 * z52;
    const Scalar z93 = z52 * z53;
    const Scalar z94 = z52 * z54;
    const Scalar z95 = z53 * z54;
    const Scalar z96 = s_q7 * z77 + c_q7 * z80;
    const Scalar z97 = v_q7 * z81 - z96;  // angular acceleration of link7, x
    const Scalar z98 = z81 * z75;
    const Scalar z99 = z68 * z75;
    const Scalar z100 = z86 + z82;
    const Scalar z101 = z85 - z87;
    const Scalar z102 = k3 * z88 + k4 * z101;  // force on link7, times 0.0825 m, y
    const Scalar z103 = c_q6 * z84 + s_q6 * z89;
    const Scalar z104 = z77 + z93;
    const Scalar z105 = z86 - z83;
    const Scalar z106 = z82 - z83;
    const Scalar z107 = z86 - z82;
    const Scalar z108 = s_q6 * z84 - c_q6 * z89;
    const Scalar z109 = z91 - z92;
    const Scalar z110 = z91 + z61;
    const Scalar z111 = z91 - z61;
    const Scalar z112 = s_q7 * z80 - c_q7 * z77;
    const Scalar z113 = v_q7 * z68 + z112;  // angular acceleration of link7, y
    const Scalar z114 = z85 + z87;
    const Scalar z115 = k4 * z100 - k3 * z114;  // force on link7, times 0.0825 m, x
    const Scalar z116 = z61 - z92;
    const Scalar z117 = z61 + z92;
    const Scalar z118 = z79 + z94;
    const Scalar z119 = z79 - z94;
    const Scalar z120 = z103 - n16_over_15 * z104;
    const Scalar z121 = z108 + n16_over_15 * z110;
    const Scalar z122 = z97 + z98;
    const Scalar z123 = z97 - z98;
    const Scalar z124 = z41 * z41;
    const Scalar z125 = z40 * z41;
    const Scalar z126 = z90 + n16_over_15 * z118;
    const Scalar z127 = z40 * z40;
    const Scalar z128 = z113 + z99;
    const Scalar z129 = z113 - z99;
    const Scalar z130 = k6 * z106 + k4 * z120 + k7 * z114 - k8 * z122 + k9 * z128;  // moment on link7, y
    const Scalar z131 = k7 * z107 + k3 * z120 + k6 * z101 + k10 * z122 - k8 * z128;  // moment on link7, x
    const Scalar z132 = k3 * z122 + k4 * z128;  // force on link7, times 0.0825 m, z
    const Scalar z133 = k11 * z104 - z132 + k12 * z117;  // force on link6, times 0.0825 m, y
    const Scalar z134 = z77 - z93;
    const Scalar z135 = s_q7 * z102 + c_q7 * z115;
    const Scalar z136 = s_q7 * z115 - c_q7 * z102;
    const Scalar z137 = k11 * z110 + z135 - k12 * z134;  // force on link6, times 0.0825 m, x
    const Scalar z138 = z45 * z45;
    const Scalar z139 = s_q7 * z121 + c_q7 * z126;
    const Scalar z140 = s_q7 * z126 - c_q7 * z121;
    // moment on link7, z
    const Scalar z141 = k13 * z87 + k8 * z105 + k14 * z85 + k6 * z123 + k4 * z139 + k3 * z140 + k7 * z129;
    const Scalar z142 = z58 - z44;
    const Scalar z143 = z62 - z39;
    const Scalar z144 = z41 * z45;
    const Scalar z145 = z40 * z45;
    const Scalar z146 = z124 - z127;
    const Scalar z147 = z42 - z38;
    const Scalar z148 = z42 - z33;
    const Scalar z149 = z33 - z38;
    const Scalar z150 = z138 - z127;
    const Scalar z151 = z138 + z127;
    const Scalar z152 = z80 + z95;
    // moment on link6, y
    const Scalar z153 = k15 * z116 + k11 * z90 - k16 * z134 + k17 * z118 - k18 * z152 - n16_over_15 * z136 + z141;
    const Scalar z154 = z80 - z95;
    const Scalar z155 = k11 * z118 - z136 - k12 * z152;  // force on link6, times 0.0825 m, z
    const Scalar z156 = z70 - z125;
    const Scalar z157 = z70 + z125;
    const Scalar z158 = z155 + k19 * z157 + k20 * z151;  // force on link5, times 0.0825 m, y
    const Scalar z159 = z69 - z144;
    const Scalar z160 = z69 + z144;
    const Scalar z161 = z124 - z138;
    const Scalar z162 = z124 + z138;
    const Scalar z163 = z73 - z145;
    const Scalar z164 = z73 + z145;
    const Scalar z165 = c_q6 * z137 + s_q6 * z133;
    const Scalar z166 = s_q6 * z137 - c_q6 * z133;
    const Scalar z167 = z165 - k19 * z162 + k20 * z156;  // force on link5, times 0.0825 m, x
    const Scalar z168 = z166 - k19 * z164 + k20 * z160;  // force on link5, times 0.0825 m, z
    const Scalar z169 = s_q7 * z130 - c_q7 * z131;
    const Scalar z170 = k12 * z90 - k16 * z111 + k15 * z104 + k18 * z118 - k21 * z152 - z169;  // moment on link6, x
    const Scalar z171 = s_q7 * z131 + c_q7 * z130;
    // moment on link6, z
    const Scalar z172 = k18 * z109 - k22 * z93 - k23 * z77 + k12 * z108 + k11 * z103 + k15 * z154 + k16 * z119
        + n16_over_15 * z132 + z171;
    const Scalar z173 = k24 * z150 - k25 * z156 + k19 * z84 - k26 * z160 - k27 * z164 - z172;  // moment on link5, y
    const Scalar z174 = z13 * z14;
    const Scalar z175 = z35 - z24;
    const Scalar z176 = z12 * z12;
    const Scalar z177 = z168 + k28 * z50 + k29 * z57;  // force on link4, times 0.0825 m, y
    const Scalar z178 = c_q6 * z153 + s_q6 * z170;
    // moment on link5, z
    const Scalar z179 = k30 * z125 - k26 * z146 - k31 * z70 - k24 * z159 - k25 * z163 + k20 * z89 - k19 * z90 + z178;
    const Scalar z180 = s_q6 * z153 - c_q6 * z170;
    const Scalar z181 = k24 * z157 - k25 * z161 + k20 * z84 + k32 * z160 + k26 * z164 - z180;  // moment on link5, x
    const Scalar z182 = z7 - z11;
    const Scalar z183 = z0 * z0;
    const Scalar z184 = v_q2 * z2;
    const Scalar z185 = z21 - z23;
    const Scalar z186 = z34 - z174;
    const Scalar z187 = z34 + z174;
    const Scalar z188 = s_q5 * z158 - c_q5 * z167;
    const Scalar z189 = c_q5 * z158 + s_q5 * z167;
    const Scalar z190 = k33 * z56 - k34 * z149 + k29 * z60 + k35 * z65 + k36 * z71 + z179 - z189;  // moment on link4, y
    const Scalar z191 = z188 + k29 * z51 - k28 * z56;  // force on link4, times 0.0825 m, x
    const Scalar z192 = z22 - z17;
    const Scalar z193 = z22 - z176;
    const Scalar z194 = z17 - z176;
    const Scalar z195 = z17 + z176;
    const Scalar z196 = s_q5 * z173 - c_q5 * z181;
    // moment on link4, x
    const Scalar z197 = k33 * z148 - k34 * z57 + k28 * z60 + k37 * z65 + k35 * z71 - n256_over_55 * z189 - z196;
    const Scalar z198 = k28 * z65 - z189 + k29 * z71;  // force on link4, times 0.0825 m, z
    const Scalar z199 = c_q5 * z173 + s_q5 * z181;
    // moment on link4, z
    const Scalar z200 = k35 * z147 - k38 * z43 - k39 * z49 + k34 * z142 + k28 * z63 - k33 * z143 - k29 * z64 - z168
        + n256_over_55 * z188 - z199;
    const Scalar z201 = k40 * z32 + z198 - k41 * z195;  // force on link3, times 0.0825 m, y
    const Scalar z202 = z4 - z183;
    const Scalar z203 = z4 - z10;
    const Scalar z204 = z10 - z183;
    const Scalar z205 = s_q4 * z177 + c_q4 * z191;
    const Scalar z206 = s_q4 * z191 - c_q4 * z177;
    // moment on link3, y
    const Scalar z207 = k40 * z29 + k42 * z185 + k43 * z194 + k44 * z46 + k45 * z187 - z200 + z206;
    const Scalar z208 = k40 * z31 - z205 + k41 * z185;  // force on link3, times 0.0825 m, x
    const Scalar z209 = a_q2 + z9;
    const Scalar z210 = s_q4 * z190 - c_q4 * z197;
    const Scalar z211 = k41 * z29 - k43 * z32 - k42 * z192 + k45 * z46 + k46 * z187 + z210;  // moment on link3, x
    const Scalar z212 = c_q4 * z190 + s_q4 * z197;
    // moment on link3, z
    const Scalar z213 = k43 * z186 - k47 * z21 - k48 * z23 - k45 * z193 - k42 * z175 + k41 * z36 - k40 * z37 - z198
        + z212;
    const Scalar z214 = z8 + z184;
    const Scalar z215 = c_q3 * z211 + s_q3 * z207;
    const Scalar z216 = s_q3 * z208 - c_q3 * z201;
    // moment on link2, x
    const Scalar z217 = k49 * z202 - k50 * z209 + k51 * z18 + k52 * z214 - z215 - n632_over_165 * z216;
    const Scalar z218 = z8 - z184;
    const Scalar z219 = k49 * z15 + k50 * z203 + k52 * z18 + k53 * z214 + z213;  // moment on link2, y
    const Scalar z220 = s_q3 * z211 - c_q3 * z207;
    const Scalar z221 = s_q3 * z201 + c_q3 * z208;
    const Scalar z222 = s_q2 * z217 - c_q2 * z219;
    // moment on link2, z
    const Scalar z223 = k54 * a_q2 - k55 * z5 + k56 * z6 - k57 * z9 - k52 * z204 - k50 * z182 + k49 * z218 + z220
        - n632_over_165 * z221;
    const Scalar z224 = k58 * a_q1 + z222;  // moment on link1, z
    forces.q1 = z224;
    forces.q2 = z223;
    forces.q3 = -z213;
    forces.q4 = -z200;
    forces.q5 = -z179;
    forces.q6 = -z172;
    forces.q7 = z141;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar k0 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k1 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar k2 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar k5 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k8 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k9 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k10 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k11 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k12 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k14 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k15 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k16 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k17 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k19 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k20 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k21 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k22 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k23 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k24 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k25 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k26 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k27 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k28 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k29 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar k30 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k31 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k32 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k33 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k35 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k36 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k37 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k38 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k39 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k40 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k41 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k42 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k43 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k44 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k45 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar k46 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k47 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k48 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k49 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k50 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k52 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar k53 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k54 = traits::constant(0.002128477624927662, 0.0021284777f, "1064238812463831/500000000000000000");
    const Scalar k55 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k56 = traits::constant(0.013508337745659894, 0.013508338f, "13508337745659893/1000000000000000000");
    const Scalar k57 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k58 = traits::constant(0.010045187828321245, 0.010045188f, "2009037565664249/200000000000000000");
    const Scalar k59 = traits::constant(0.00859403176329453, 0.008594031f, "8594031763294531/1000000000000000000");
    const Scalar k60 = traits::constant(0.5393781288741563, 0.5393781f, "539378128874156269/1000000000000000000");
    const Scalar k61 = traits::constant(0.5852255150309718, 0.5852255f, "585225515030971769/1000000000000000000");
    const Scalar k62 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k63 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k64 = traits::constant(0.022178148964878235, 0.022178149f, "5544537241219559/250000000000000000");
    const Scalar k65 = traits::constant(0.03425152206164946, 0.034251522f, "1712576103082473/50000000000000000");
    const Scalar k66 = traits::constant(0.9562715012318808, 0.9562715f, "59766968826992551/62500000000000000");
    const Scalar k67 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k68 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k69 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k70 = traits::constant(0.9331936187369491, 0.9331936f, "93319361873694901/100000000000000000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
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
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z0 = v_q1 * s_q2;
    const Scalar z1 = v_q1 * c_q2;
    const Scalar z2 = k0 * s_q7 + k1 * c_q7;
    const Scalar z3 = k1 * s_q7 - k0 * c_q7;
    const Scalar z4 = v_q2 * v_q2;
    const Scalar z5 = k2 * s_q2;
    const Scalar z6 = k2 * c_q2;
    const Scalar z7 = v_q2 * z1;  // angular acceleration of link2, x
    const Scalar z8 = v_q2 * z0;  // angular acceleration of link2, y
    const Scalar z9 = z0 * z1;
    const Scalar z10 = z0 * z0;
    const Scalar z11 = v_q2 * s_q3 - c_q3 * z0;
    const Scalar z12 = v_q2 * c_q3 + s_q3 * z0;
    const Scalar z13 = v_q3 + z1;  // angular velocity of link3, z
    const Scalar z14 = z4 + z10;
    const Scalar z15 = n2 * z7;
    const Scalar z16 = c_q3 * z7;
    const Scalar z17 = s_q3 * z7;
    const Scalar z18 = z5 + n632_over_165 * z9;
    const Scalar z19 = z13 * z13;
    const Scalar z20 = k5 + z2;
    const Scalar z21 = z12 * z12;
    const Scalar z22 = z11 * z12;
    const Scalar z23 = z11 * z13;
    const Scalar z24 = s_q4 * z13 + c_q4 * z11;
    const Scalar z25 = s_q4 * z11 - c_q4 * z13;
    const Scalar z26 = v_q4 - z12;  // angular velocity of link4, z
    const Scalar z27 = z6 - n632_over_165 * z14;
    const Scalar z28 = n632_over_165 * z15;
    const Scalar z29 = v_q3 * z12 - z16;  // angular acceleration of link3, x
    const Scalar z30 = v_q3 * z11 - z17;  // angular acceleration of link3, y
    const Scalar z31 = z21 + z19;
    const Scalar z32 = z26 * z26;
    const Scalar z33 = s_q3 * z28 - c_q3 * z18;
    const Scalar z34 = s_q3 * z18 + c_q3 * z28;
    const Scalar z35 = z30 + z23;
    const Scalar z36 = c_q4 * z29;
    const Scalar z37 = s_q4 * z29;
    const Scalar z38 = z24 * z24;
    const Scalar z39 = z24 * z26;
    const Scalar z40 = s_q5 * z26 - c_q5 * z24;
    const Scalar z41 = c_q5 * z26 + s_q5 * z24;
    const Scalar z42 = z25 * z25;
    const Scalar z43 = z24 * z25;
    const Scalar z44 = z25 * z26;
    const Scalar z45 = v_q5 - z25;  // angular velocity of link5, z
    const Scalar z46 = z27 + z35;
    const Scalar z47 = v_q4 * z25 - z36;  // angular acceleration of link4, x
    const Scalar z48 = v_q4 * z24 + z37;  // angular acceleration of link4, y
    const Scalar z49 = z32 + z38;
    const Scalar z50 = z34 + z22;
    const Scalar z51 = z42 + z32;
    const Scalar z52 = s_q6 * z45 - c_q6 * z40;
    const Scalar z53 = s_q6 * z40 + c_q6 * z45;
    const Scalar z54 = v_q6 + z41;  // angular velocity of link6, z
    const Scalar z55 = z33 - z31;
    const Scalar z56 = z48 + z39;
    const Scalar z57 = z47 + z44;
    const Scalar z58 = c_q5 * z47;
    const Scalar z59 = s_q5 * z47;
    const Scalar z60 = z54 * z54;
    const Scalar z61 = s_q4 * z46 + c_q4 * z55;
    const Scalar z62 = s_q4 * z55 - c_q4 * z46;
    const Scalar z63 = z50 + z56 + n256_over_55 * z57;
    const Scalar z64 = v_q5 * z41 + z58;  // angular acceleration of link5, x
    const Scalar z65 = v_q5 * z40 + z59;  // angular acceleration of link5, y
    const Scalar z66 = z53 * z53;
    const Scalar z67 = z52 * z53;
    const Scalar z68 = z52 * z54;
    const Scalar z69 = s_q7 * z54 + c_q7 * z52;
    const Scalar z70 = s_q7 * z52 - c_q7 * z54;
    const Scalar z71 = z53 * z54;
    const Scalar z72 = v_q7 - z53;  // angular velocity of link7, z
    const Scalar z73 = z52 * z52;
    const Scalar z74 = z51 - n256_over_55 * z43 + z61;
    const Scalar z75 = c_q6 * z64;
    const Scalar z76 = z72 * z72;
    const Scalar z77 = z69 * z69;
    const Scalar z78 = s_q6 * z64;
    const Scalar z79 = n256_over_55 * z49 - z43 + z62;
    const Scalar z80 = v_q6 * z53 - z75;  // angular acceleration of link6, x
    const Scalar z81 = v_q6 * z52 - z78;  // angular acceleration of link6, y
    const Scalar z82 = z70 * z70;
    const Scalar z83 = z69 * z70;
    const Scalar z84 = z76 + z77;
    const Scalar z85 = k1 * z83 - k0 * z84;
    const Scalar z86 = s_q7 * z80;
    const Scalar z87 = z82 + z76;
    const Scalar z88 = c_q5 * z74 + s_q5 * z63;
    const Scalar z89 = s_q5 * z74 - c_q5 * z63;
    const Scalar z90 = v_q7 * z69 + z86;  // angular acceleration of link7, y
    const Scalar z91 = z69 * z72;
    const Scalar z92 = z70 * z72;
    const Scalar z93 = k1 * z87 - k0 * z83;
    const Scalar z94 = c_q7 * z80;
    const Scalar z95 = v_q7 * z70 - z94;  // angular acceleration of link7, x
    const Scalar z96 = z66 - z73;
    const Scalar z97 = z82 - z76;
    const Scalar z98 = z76 - z77;
    const Scalar z99 = z82 - z77;
    const Scalar z100 = c_q6 * z79 + s_q6 * z88;
    const Scalar z101 = z90 + z91;
    const Scalar z102 = z90 - z91;
    const Scalar z103 = z60 - z73;
    const Scalar z104 = z60 + z73;
    const Scalar z105 = z81 + z68;
    const Scalar z106 = z81 - z68;
    const Scalar z107 = z95 + z92;
    const Scalar z108 = z95 - z92;
    const Scalar z109 = s_q6 * z79 - c_q6 * z88;
    const Scalar z110 = z66 + z60;
    const Scalar z111 = z66 - z60;
    const Scalar z112 = z47 - z44;
    const Scalar z113 = z48 - z39;
    const Scalar z114 = z100 - n16_over_15 * z67;
    const Scalar z115 = k8 * z83 + k9 * z98 + k1 * z114 + k10 * z101 - k11 * z107;
    const Scalar z116 = k8 * z97 - k9 * z83 + k0 * z114 - k11 * z101 + k12 * z107;
    const Scalar z117 = k1 * z101 + k0 * z107;
    const Scalar z118 = k5 * z67 - z117 + k13 * z104;
    const Scalar z119 = z80 - z71;
    const Scalar z120 = z80 + z71;
    const Scalar z121 = z89 + n16_over_15 * z105;
    const Scalar z122 = z109 + n16_over_15 * z110;
    const Scalar z123 = z12 * z13;
    const Scalar z124 = z11 * z11;
    const Scalar z125 = z40 * z41;
    const Scalar z126 = s_q7 * z121 - c_q7 * z122;
    const Scalar z127 = c_q7 * z121 + s_q7 * z122;
    const Scalar z128 = z30 - z23;
    const Scalar z129 = z1 * z1;
    const Scalar z130 = k8 * s_q7 - k9 * c_q7;
    const Scalar z131 = k14 * z83 + k11 * z99 + k9 * z108 + k8 * z102 + k0 * z126 + k1 * z127;
    const Scalar z132 = k9 * s_q7 + k8 * c_q7;
    const Scalar z133 = k15 + n16_over_15 * z2;
    const Scalar z134 = s_q6 * z130 - c_q6 * z133;
    const Scalar z135 = c_q6 * z130 + s_q6 * z133;
    const Scalar z136 = c_q6 * z3;
    const Scalar z137 = s_q6 * z3;
    const Scalar z138 = s_q5 * z2 - c_q5 * z136;
    const Scalar z139 = c_q5 * z2 + s_q5 * z136;
    const Scalar z140 = c_q5 * z132 + s_q5 * z135;
    const Scalar z141 = z137 - n256_over_55 * z138 - z140;
    const Scalar z142 = s_q5 * z132 - c_q5 * z135;
    const Scalar z143 = n256_over_55 * z139 - z142;
    const Scalar z144 = z40 * z45;
    const Scalar z145 = z40 * z40;
    const Scalar z146 = z134 + z139;
    const Scalar z147 = z65 + z144;
    const Scalar z148 = z65 - z144;
    const Scalar z149 = z41 * z45;
    const Scalar z150 = z45 * z45;
    const Scalar z151 = z41 * z41;
    const Scalar z152 = z64 + z149;
    const Scalar z153 = z64 - z149;
    const Scalar z154 = z150 + z145;
    const Scalar z155 = z151 + z150;
    const Scalar z156 = z150 - z145;
    const Scalar z157 = z151 - z150;
    const Scalar z158 = z151 - z145;
    const Scalar z159 = z42 - z32;
    const Scalar z160 = z42 - z38;
    const Scalar z161 = z32 - z38;
    const Scalar z162 = s_q4 * z137 + c_q4 * z138;
    const Scalar z163 = z29 + z123;
    const Scalar z164 = z29 - z123;
    const Scalar z165 = z19 - z124;
    const Scalar z166 = z21 - z19;
    const Scalar z167 = z19 + z124;
    const Scalar z168 = z21 - z124;
    const Scalar z169 = n2 * z8;
    const Scalar z170 = z4 - z129;
    const Scalar z171 = z4 - z10;
    const Scalar z172 = z10 - z129;
    const Scalar z173 = u_tau7 - z131;
    const Scalar z174 = s_q4 * z138 - c_q4 * z137;
    const Scalar z175 = k16 - z130;
    const Scalar z176 = z141 + z174;
    const Scalar z177 = k14 * s_q7 - k17 * c_q7;
    const Scalar z178 = s_q7 * z177;
    const Scalar z179 = k11 + c_q7 * z177;
    const Scalar z180 = k15 + n32_over_15 * z2;
    const Scalar z181 = k19 + z132;
    const Scalar z182 = n32_over_15 * z2 + z178;
    const Scalar z183 = k14 - z178;
    const Scalar z184 = n16_over_15 * z3 - z179;
    const Scalar z185 = k20 - z3;
    const Scalar z186 = k21 - z183;
    const Scalar z187 = n2 * z175;
    const Scalar z188 = k22 + z182;
    const Scalar z189 = k13 * s_q6 + c_q6 * z20;
    const Scalar z190 = k23 + z184;
    const Scalar z191 = s_q6 * z20 - k13 * c_q6;
    const Scalar z192 = z180 + z186;
    const Scalar z193 = s_q6 * z181 + c_q6 * z190;
    const Scalar z194 = s_q6 * z192 - c_q6 * z187;
    const Scalar z195 = s_q6 * z190 - c_q6 * z181;
    const Scalar z196 = k24 - z193;
    const Scalar z197 = k25 - z189;
    const Scalar z198 = c_q5 * z191;
    const Scalar z199 = c_q5 * z188 + s_q5 * z193;
    const Scalar z200 = c_q6 * z194 + z175;
    const Scalar z201 = s_q6 * z194;
    const Scalar z202 = z189 - n256_over_55 * z198 - z199;
    const Scalar z203 = z186 - z201;
    const Scalar z204 = z180 - z201;
    const Scalar z205 = k26 + z200;
    const Scalar z206 = s_q5 * z188 - c_q5 * z193;
    const Scalar z207 = k27 - z203;
    const Scalar z208 = k28 + z195;
    const Scalar z209 = s_q5 * z191;
    const Scalar z210 = n256_over_55 * z209 + z206;
    const Scalar z211 = z195 - z209;
    const Scalar z212 = c_q4 * z146 + s_q4 * z143;
    const Scalar z213 = s_q4 * z146 - c_q4 * z143;
    const Scalar z214 = k29 + z204;
    const Scalar z215 = z139 - z212;
    const Scalar z216 = s_q5 * z185 + c_q5 * z197;
    const Scalar z217 = s_q5 * z197 - c_q5 * z185;
    const Scalar z218 = s_q5 * z208 + c_q5 * z205;
    const Scalar z219 = s_q4 * z210 - c_q4 * z211;
    const Scalar z220 = s_q4 * z211 + c_q4 * z210;
    const Scalar z221 = z209 - z219;
    const Scalar z222 = s_q4 * z198 - c_q4 * z189;
    const Scalar z223 = s_q4 * z189 + c_q4 * z198;
    const Scalar z224 = z202 + z222;
    const Scalar z225 = s_q3 * z139 + c_q3 * z162;
    const Scalar z226 = s_q5 * z205 - c_q5 * z208;
    const Scalar z227 = s_q3 * z162 - c_q3 * z139;
    const Scalar z228 = n256_over_55 * z216 - z218;
    const Scalar z229 = c_q3 * z176 + s_q3 * z213;
    const Scalar z230 = n632_over_165 * z225 - z229;
    const Scalar z231 = s_q3 * z176 - c_q3 * z213;
    const Scalar z232 = n632_over_165 * z227 - z231;
    const Scalar z233 = n256_over_55 * z217 - z226;
    const Scalar z234 = z214 + z216;
    const Scalar z235 = s_q4 * z217;
    const Scalar z236 = c_q4 * z217;
    const Scalar z237 = s_q3 * z209 - c_q3 * z223;
    const Scalar z238 = c_q3 * z209 + s_q3 * z223;
    const Scalar z239 = s_q2 * z232 - c_q2 * z215;
    const Scalar z240 = z191 + n256_over_55 * z216 - z218;
    const Scalar z241 = k30 + z240;
    const Scalar z242 = z233 - z235;
    const Scalar z243 = n2 * z196;
    const Scalar z244 = z188 - z207;
    const Scalar z245 = c_q5 * z243 + s_q5 * z244;
    const Scalar z246 = z214 + n2 * z216;
    const Scalar z247 = k31 + z233;
    const Scalar z248 = k32 + z191;
    const Scalar z249 = k33 + z216;
    const Scalar z250 = s_q4 * z248 + c_q4 * z249;
    const Scalar z251 = s_q4 * z249 - c_q4 * z248;
    const Scalar z252 = c_q5 * z245 - z196;
    const Scalar z253 = s_q5 * z245;
    const Scalar z254 = c_q4 * z234 + s_q4 * z228;
    const Scalar z255 = s_q4 * z234 - c_q4 * z228;
    const Scalar z256 = z207 + z253;
    const Scalar z257 = z188 - z253;
    const Scalar z258 = n512_over_55 * z191 + z256;
    const Scalar z259 = z257 + n512_over_55 * z191 + n2 * z216;
    const Scalar z260 = z217 + z252;
    const Scalar z261 = k35 + z260;
    const Scalar z262 = k36 + z258;
    const Scalar z263 = z216 - z254;
    const Scalar z264 = c_q3 * z224 + s_q3 * z220;
    const Scalar z265 = n632_over_165 * z237 + z264;
    const Scalar z266 = s_q3 * z224 - c_q3 * z220;
    const Scalar z267 = n632_over_165 * z238 - z266;
    const Scalar z268 = k37 + z259;
    const Scalar z269 = s_q4 * z247 + c_q4 * z261;
    const Scalar z270 = s_q4 * z261 - c_q4 * z247;
    const Scalar z271 = c_q2 * z221 + s_q2 * z267;
    const Scalar z272 = z246 - z262;
    const Scalar z273 = n2 * z241;
    const Scalar z274 = s_q4 * z272 - c_q4 * z273;
    const Scalar z275 = z217 - z269;
    const Scalar z276 = k38 - z275;
    const Scalar z277 = k39 - z217;
    const Scalar z278 = z268 - n2 * z250;
    const Scalar z279 = k40 + z270;
    const Scalar z280 = k41 - z250;
    const Scalar z281 = z268 - z250;
    const Scalar z282 = s_q3 * z277 - c_q3 * z280;
    const Scalar z283 = c_q3 * z277 + s_q3 * z280;
    const Scalar z284 = c_q4 * z274 + z241;
    const Scalar z285 = s_q4 * z274;
    const Scalar z286 = z262 + z285;
    const Scalar z287 = z246 - z285;
    const Scalar z288 = z251 - z284;
    const Scalar z289 = s_q3 * z216 + c_q3 * z236;
    const Scalar z290 = n2 * z250 - z287;
    const Scalar z291 = s_q3 * z236 - c_q3 * z216;
    const Scalar z292 = k42 + z286;
    const Scalar z293 = k43 - z288;
    const Scalar z294 = s_q3 * z279 - c_q3 * z293;
    const Scalar z295 = c_q3 * z279 + s_q3 * z293;
    const Scalar z296 = k44 - z290;
    const Scalar z297 = s_q3 * z255 - c_q3 * z242;
    const Scalar z298 = n632_over_165 * z282 + z294;
    const Scalar z299 = n632_over_165 * z289 - z297;
    const Scalar z300 = n632_over_165 * z283 + z295;
    const Scalar z301 = c_q3 * z255 + s_q3 * z242;
    const Scalar z302 = n632_over_165 * z291 + z301;
    const Scalar z303 = n2 * z276;
    const Scalar z304 = z278 - z292;
    const Scalar z305 = c_q3 * z303 + s_q3 * z304;
    const Scalar z306 = c_q3 * z251;
    const Scalar z307 = s_q2 * z302 - c_q2 * z263;
    const Scalar z308 = k45 * z132;
    const Scalar z309 = k45 * z134;
    const Scalar z310 = k45 * z141;
    const Scalar z311 = k45 * z215;
    const Scalar z312 = s_q3 * z269 - c_q3 * z281;
    const Scalar z313 = n632_over_165 * z306 + z312;
    const Scalar z314 = c_q3 * z269 + s_q3 * z281;
    const Scalar z315 = c_q3 * z305 - z276;
    const Scalar z316 = s_q3 * z305;
    const Scalar z317 = z292 + z316;
    const Scalar z318 = z278 - z316;
    const Scalar z319 = k46 - z315;
    const Scalar z320 = k47 + z298;
    const Scalar z321 = n2 * z320;
    const Scalar z322 = s_q2 * z298 - c_q2 * z296;
    const Scalar z323 = k48 * z251 - z317;
    const Scalar z324 = k48 * z251 - z318;
    const Scalar z325 = s_q3 * z251;
    const Scalar z326 = n632_over_165 * z325 - z314;
    const Scalar z327 = k49 - z323;
    const Scalar z328 = k50 - z324;
    const Scalar z329 = z239 * z311 - z322;
    const Scalar z330 = z215 * z311 - z296;
    const Scalar z331 = z296 - z327;
    const Scalar z332 = c_q2 * z270 + s_q2 * z326;
    const Scalar z333 = z132 * z308 - z188;
    const Scalar z334 = c_q2 * z321 + s_q2 * z331;
    const Scalar z335 = z134 * z308 - z195;
    const Scalar z336 = z134 * z309 - z214;
    const Scalar z337 = n1 / z333;
    const Scalar z338 = z141 * z309 + z233;
    const Scalar z339 = z141 * z308 - z202;
    const Scalar z340 = z141 * z310 - z268;
    const Scalar z341 = z215 * z310 + z270;
    const Scalar z342 = z215 * z309 - z263;
    const Scalar z343 = z215 * z308 + z221;
    const Scalar z344 = z230 * z310 - z313;
    const Scalar z345 = z230 * z309 - z299;
    const Scalar z346 = z230 * z308 + z265;
    const Scalar z347 = s_q2 * z334;
    const Scalar z348 = z296 - z347;
    const Scalar z349 = z239 * z310 - z332;
    const Scalar z350 = z239 * z309 - z307;
    const Scalar z351 = z239 * z308 - z271;
    const Scalar z352 = k52 + z348;
    const Scalar z353 = z335 * z337;
    const Scalar z354 = z336 - z335 * z353;
    const Scalar z355 = z338 - z339 * z353;
    const Scalar z356 = z342 - z343 * z353;
    const Scalar z357 = z345 - z346 * z353;
    const Scalar z358 = n1 / z354;
    const Scalar z359 = z350 - z351 * z353;
    const Scalar z360 = z339 * z337;
    const Scalar z361 = z340 - z339 * z360;
    const Scalar z362 = z341 - z343 * z360;
    const Scalar z363 = z344 - z346 * z360;
    const Scalar z364 = z349 - z351 * z360;
    const Scalar z365 = z343 * z337;
    const Scalar z366 = z330 - z343 * z365;
    const Scalar z367 = z329 - z351 * z365;
    const Scalar z368 = k45 * z230;
    const Scalar z369 = z230 * z368 - z328;
    const Scalar z370 = z230 * z311 - z300;
    const Scalar z371 = z370 - z346 * z365;
    const Scalar z372 = k53 + z300;
    const Scalar z373 = c_q2 * z372 + s_q2 * z319;
    const Scalar z374 = z355 * z358;
    const Scalar z375 = z356 * z358;
    const Scalar z376 = z346 * z337;
    const Scalar z377 = z369 - z346 * z376;
    const Scalar z378 = z366 - z356 * z375;
    const Scalar z379 = z371 - z357 * z375;
    const Scalar z380 = z367 - z359 * z375;
    const Scalar z381 = z239 * z368 + z373;
    const Scalar z382 = z364 - z359 * z374;
    const Scalar z383 = z357 * z358;
    const Scalar z384 = z377 - z357 * z383;
    const Scalar z385 = k45 * z239;
    const Scalar z386 = z361 - z355 * z374;
    const Scalar z387 = z362 - z356 * z374;
    const Scalar z388 = z363 - z357 * z374;
    const Scalar z389 = z239 * z385 - z352;
    const Scalar z390 = n1 / z386;
    const Scalar z391 = z381 - z351 * z376;
    const Scalar z392 = z391 - z359 * z383;
    const Scalar z393 = s_q7 * z85 - c_q7 * z93;
    const Scalar z394 = c_q7 * z85 + s_q7 * z93;
    const Scalar z395 = k13 * z67 - z393 + k5 * z110;  // force on link6, times 0.0825 m, x
    const Scalar z396 = s_q7 * z115 - c_q7 * z116;
    const Scalar z397 = s_q7 * z116 + c_q7 * z115;
    const Scalar z398 = z387 * z390;
    const Scalar z399 = z388 * z390;
    const Scalar z400 = z351 * z337;
    // moment on link6, z
    const Scalar z401 = k16 * z96 - k54 * z67 + k23 * z119 + k19 * z106 + k13 * z109 + k5 * z100 + n16_over_15 * z117
        + z397;
    // moment on link6, y
    const Scalar z402 = k19 * z67 + k23 * z103 + k5 * z89 + k55 * z105 - k16 * z120 - n16_over_15 * z394 + z131;
    const Scalar z403 = k13 * z89 + k23 * z67 + k16 * z105 - k56 * z120 - k19 * z111 - z396;  // moment on link6, x
    const Scalar z404 = k5 * z105 - z394 - k13 * z120;  // force on link6, times 0.0825 m, z
    const Scalar z405 = z378 - z387 * z398;
    const Scalar z406 = z389 - z351 * z400;
    const Scalar z407 = z404 + k25 * z125 + k20 * z154;  // force on link5, times 0.0825 m, y
    const Scalar z408 = k25 * z79 + k28 * z125 - k57 * z147 - k24 * z152 + k26 * z156 - z401;  // moment on link5, y
    const Scalar z409 = z379 - z388 * z398;
    const Scalar z410 = z384 - z388 * z399;
    const Scalar z411 = n1 / z405;
    const Scalar z412 = z392 - z382 * z399;
    const Scalar z413 = z380 - z382 * z398;
    const Scalar z414 = c_q6 * z395 + s_q6 * z118;
    const Scalar z415 = s_q6 * z395 - c_q6 * z118;
    const Scalar z416 = k20 * z125 - z414 + k25 * z155;  // force on link5, times 0.0825 m, x
    const Scalar z417 = k25 * z147 - z415 - k20 * z152;  // force on link5, times 0.0825 m, z
    const Scalar z418 = s_q6 * z402 - c_q6 * z403;
    const Scalar z419 = k20 * z79 + k26 * z125 + k24 * z147 + k58 * z152 - k28 * z157 - z418;  // moment on link5, x
    const Scalar z420 = c_q6 * z402 + s_q6 * z403;
    // moment on link5, z
    const Scalar z421 = k20 * z88 - k25 * z89 + k59 * z125 - k26 * z153 - k28 * z148 - k24 * z158 + z420;
    const Scalar z422 = z417 + k33 * z43 - k32 * z49;  // force on link4, times 0.0825 m, y
    const Scalar z423 = s_q5 * z407 + c_q5 * z416;
    const Scalar z424 = s_q5 * z416 - c_q5 * z407;
    const Scalar z425 = z423 + k33 * z51 - k32 * z43;  // force on link4, times 0.0825 m, x
    const Scalar z426 = s_q5 * z408 - c_q5 * z419;
    const Scalar z427 = c_q5 * z408 + s_q5 * z419;
    const Scalar z428 = z424 + k33 * z56 + k32 * z57;  // force on link4, times 0.0825 m, z
    const Scalar z429 = z409 * z411;
    const Scalar z430 = z410 - z409 * z429;
    const Scalar z431 = z412 - z413 * z429;
    const Scalar z432 = z359 * z358;
    // moment on link4, z
    const Scalar z433 = k32 * z61 - k33 * z62 - k60 * z43 + k35 * z112 - k31 * z113 + k30 * z160 + z417 + n256_over_55
        * z423 - z427;
    // moment on link4, x
    const Scalar z434 = k35 * z43 + k32 * z50 + k31 * z159 + k30 * z56 + k61 * z57 - z426 + n256_over_55 * z424;
    const Scalar z435 = k33 * z50 + k31 * z43 + k62 * z56 + k30 * z57 - k35 * z161 + z421 + z424;  // moment on link4, y
    const Scalar z436 = z406 - z359 * z432;
    const Scalar z437 = z428 + k41 * z22 - k39 * z167;  // force on link3, times 0.0825 m, y
    const Scalar z438 = n1 / z430;
    const Scalar z439 = s_q4 * z422 - c_q4 * z425;
    const Scalar z440 = c_q4 * z422 + s_q4 * z425;
    // moment on link3, y
    const Scalar z441 = k41 * z27 - k40 * z22 + k63 * z35 + k38 * z163 + k43 * z165 - z433 + z440;
    const Scalar z442 = z439 + k41 * z31 - k39 * z22;  // force on link3, times 0.0825 m, x
    const Scalar z443 = s_q4 * z435 - c_q4 * z434;
    const Scalar z444 = k39 * z27 - k43 * z22 + k38 * z35 + k64 * z163 - k40 * z166 + z443;  // moment on link3, x
    const Scalar z445 = c_q4 * z435 + s_q4 * z434;
    // moment on link3, z
    const Scalar z446 = k39 * z33 - k41 * z34 - k65 * z22 + k43 * z164 - k40 * z128 - k38 * z168 - z428 + z445;
    const Scalar z447 = s_q3 * z441 + c_q3 * z444;
    const Scalar z448 = s_q3 * z442 - c_q3 * z437;
    const Scalar z449 = s_q3 * z437 + c_q3 * z442;
    const Scalar z450 = z382 * z390;
    // moment on link2, x
    const Scalar z451 = k46 * z9 - k66 * z15 - k47 * z169 - k53 * z170 + z447 + n632_over_165 * z448;
    const Scalar z452 = k53 * z9 - k47 * z15 - k67 * z169 - k46 * z171 - z446;  // moment on link2, y
    const Scalar z453 = z436 - z382 * z450;
    const Scalar z454 = s_q2 * z451 - c_q2 * z452;
    const Scalar z455 = s_q3 * z444 - c_q3 * z441;
    // moment on link2, z
    const Scalar z456 = k68 * z5 - k69 * z6 + k70 * z9 + k47 * z172 - z455 + n632_over_165 * z449;
    const Scalar z457 = u_tau4 + z433;
    const Scalar z458 = u_tau5 + z421;
    const Scalar z459 = u_tau1 + z454;
    const Scalar z460 = u_tau3 + z446;
    const Scalar z461 = u_tau2 + z456;
    const Scalar z462 = z413 * z411;
    const Scalar z463 = z453 - z413 * z462;
    const Scalar z464 = u_tau6 + z401;
    const Scalar z465 = z173 * z308 + z464;
    const Scalar z466 = z431 * z438;
    const Scalar z467 = z463 - z431 * z466;
    const Scalar z468 = z173 * z309 - z458 - z353 * z465;
    const Scalar z469 = n1 / z467;
    const Scalar z470 = z173 * z310 - z457 - z360 * z465 - z374 * z468;
    const Scalar z471 = z173 * z311 - z365 * z465 - z375 * z468 + z460 - z398 * z470;
    const Scalar z472 = z173 * z368 - z376 * z465 - z383 * z468 - z399 * z470 - z461 - z429 * z471;
    const Scalar z473 = z173 * z385 - z459 - z400 * z465 - z432 * z468 - z450 * z470 - z462 * z471 - z466 * z472;
    const Scalar z474 = z469 * z473;
    const Scalar z475 = z438 * z472 - z466 * z474;
    const Scalar z476 = z411 * z471 - z462 * z474 - z429 * z475;
    const Scalar z477 = z390 * z470 - z450 * z474 - z399 * z475 - z398 * z476;
    const Scalar z478 = z8 - z476;
    const Scalar z479 = z358 * z468 - z432 * z474 - z383 * z475 - z375 * z476 - z374 * z477;
    const Scalar z480 = z30 - z477;
    const Scalar z481 = z337 * z465 - z400 * z474 - z376 * z475 - z365 * z476 - z360 * z477 - z353 * z479;
    const Scalar z482 = z48 + z479;
    const Scalar z483 = k45 * z173 - z385 * z474 - z368 * z475 - z311 * z476 - z310 * z477 - z309 * z479 - z308 * z481;
    const Scalar z484 = z65 - z481;
    const Scalar z485 = z81 - z483;
    accelerations.q1 = z474;
    accelerations.q2 = z475;
    accelerations.q3 = z478;
    accelerations.q4 = -z480;
    accelerations.q5 = z482;
    accelerations.q6 = z484;
    accelerations.q7 = -z485;
    if (!(traits::regular(-z467, z352) && traits::regular(-z430, z328) && traits::regular(-z405, z296)
        && traits::regular(-z386, z268) && traits::regular(-z354, z214) && traits::regular(-z333,
        z188))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.q1 * accelerations.q2 * accelerations.q3 * accelerations.q4
        * accelerations.q5 * accelerations.q6 * accelerations.q7;
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
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n0_316 = traits::constant(0.316, 0.316f, "79/250");
    const Scalar k1 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k2 = traits::constant(0.00850351162402155, 0.008503512f, "170070232480431/20000000000000000");
    const Scalar k3 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k4 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k5 = traits::constant(0.028124284712194955, 0.028124284f, "7031071178048739/250000000000000000");
    const Scalar k6 = traits::constant(0.026534991901690206, 0.026534991f, "13267495950845103/500000000000000000");
    const Scalar k7 = traits::constant(0.002031994566, 0.0020319945f, "1015997283/500000000000");
    const Scalar k8 = traits::constant(0.01857971472, 0.018579714f, "116123217/6250000000");
    const Scalar n0_0825 = traits::constant(0.0825, 0.0825f, "33/400");
    const Scalar k10 = traits::constant(0.126729164208, 0.12672916f, "7920572763/62500000000");
    const Scalar k11 = traits::constant(0.088844724872, 0.088844724f, "11105590609/125000000000");
    const Scalar n0_333 = traits::constant(0.333, 0.333f, "333/1000");
    const Scalar k13 = traits::constant(0.214708623208, 0.21470863f, "26838577901/125000000000");
    const Scalar k14 = traits::constant(3.228604, 3.228604f, "807151/250000");
    const Scalar k15 = traits::constant(0.05649492601407083, 0.056494925f, "3530932875879427/62500000000000000");
    const Scalar k16 = traits::constant(0.008248333140675744, 0.008248333f, "257760410646117/31250000000000000");
    const Scalar k17 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k18 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k19 = traits::constant(0.052878381999606115, 0.052878384f, "1652449437487691/31250000000000000");
    const Scalar n0_384 = traits::constant(0.384, 0.384f, "48/125");
    const Scalar k21 = traits::constant(0.01824920229252011, 0.018249203f, "1140575143282507/62500000000000000");
    const Scalar n0_088 = traits::constant(0.088, 0.088f, "11/125");
    const Scalar k23 = traits::constant(0.374644408005, 0.3746444f, "74928881601/200000000000");
    const Scalar k24 = traits::constant(0.09850206933, 0.09850207f, "9850206933/100000000000");
    const Scalar k25 = traits::constant(3.587895, 3.587895f, "717579/200000");
    const Scalar k26 = traits::constant(0.19076837715, 0.19076838f, "3815367543/20000000000");
    const Scalar k27 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k28 = traits::constant(0.06767727025085991, 0.06767727f, "13535454050171983/200000000000000000");
    const Scalar k29 = traits::constant(0.02771584317362585, 0.027715843f, "554316863472517/20000000000000000");
    const Scalar k30 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k31 = traits::constant(0.03239943042445132, 0.03239943f, "809985760611283/25000000000000000");
    const Scalar k32 = traits::constant(0.07758614905253959, 0.07758615f, "15517229810507919/200000000000000000");
    const Scalar k33 = traits::constant(0.05034347249, 0.050343473f, "5034347249/100000000000");
    const Scalar k34 = traits::constant(0.014653732538, 0.014653733f, "7326866269/500000000000");
    const Scalar k35 = traits::constant(0.047121686402, 0.047121685f, "23560843201/500000000000");
    const Scalar k36 = traits::constant(1.225946, 1.225946f, "612973/500000");
    const Scalar k37 = traits::constant(0.03942757095803552, 0.03942757f, "9856892739508881/250000000000000000");
    const Scalar k38 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k39 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k40 = traits::constant(0.03146037232526039, 0.03146037f, "7865093081315097/250000000000000000");
    const Scalar k41 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k42 = traits::constant(0.010869510762828565, 0.0108695105f, "2717377690707141/250000000000000000");
    const Scalar k43 = traits::constant(0.003127439544, 0.0031274396f, "390929943/125000000000");
    const Scalar k44 = traits::constant(0.007735484874, 0.0077354847f, "3867742437/500000000000");
    const Scalar k45 = traits::constant(0.023526756935, 0.023526756f, "4705351387/200000000000");
    const Scalar k46 = traits::constant(0.100241616695, 0.10024162f, "20048323339/200000000000");
    const Scalar k47 = traits::constant(0.017527158935, 0.01752716f, "3505431787/200000000000");
    const Scalar k48 = traits::constant(1.666555, 1.666555f, "333311/200000");
    const Scalar k49 = traits::constant(0.00248046035817079, 0.0024804603f, "248046035817079/100000000000000000");
    const Scalar k50 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k51 = traits::constant(0.001524110902883315, 0.0015241109f, "304822180576663/200000000000000000");
    const Scalar k52 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k53 = traits::constant(0.01056776613310695, 0.010567766f, "211355322662139/20000000000000000");
    const Scalar k54 = traits::constant(0.01179456023023895, 0.011794561f, "235891204604779/20000000000000000");
    const Scalar k55 = traits::constant(0.045305948634, 0.04530595f, "22652974317/500000000000");
    const Scalar k56 = traits::constant(0.735522, 0.735522f, "367761/500000");
    const Scalar k57 = traits::constant(0.015320008390949586, 0.015320009f, "7660004195474793/500000000000000000");
    const Scalar k58 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k59 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k60 = traits::constant(0.012899064612428356, 0.012899064f, "3224766153107089/250000000000000000");
    const Scalar k61 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k62 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k63 = traits::constant(0.004606581888605612, 0.0046065818f, "1151645472151403/250000000000000000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k65 = traits::constant(9.8177933583, 9.817793f, "98177933583/10000000000");
    const Scalar k66 = traits::constant(31.67260524, 31.672606f, "791815131/25000000");
    const Scalar k67 = traits::constant(35.19724995, 35.19725f, "703944999/20000000");
    const Scalar k68 = traits::constant(28.37543481, 28.375435f, "2837543481/100000000");
    const Scalar k69 = traits::constant(7.21547082, 7.215471f, "360773541/50000000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
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
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z0 = v_q1 * s_q2;
    const Scalar z1 = n0_316 * v_q2;
    const Scalar z2 = v_q1 * c_q2;
    const Scalar z3 = n0_316 * z0;
    const Scalar z4 = v_q2 * s_q3 - c_q3 * z0;
    const Scalar z5 = v_q2 * c_q3 + s_q3 * z0;
    const Scalar z6 = v_q3 + z2;  // angular velocity of link3, z
    const Scalar z7 = k1 * v_q2 - k2 * z0 + k3 * z2;
    const Scalar z8 = k4 * v_q2 + k3 * z0 - k5 * z2;
    const Scalar z9 = k6 * v_q2 - k1 * z0 - k4 * z2;
    const Scalar z10 = c_q3 * z1 + s_q3 * z3;
    const Scalar z11 = s_q3 * z1 - c_q3 * z3;
    const Scalar z12 = k7 * s_q2 + k8 * c_q2;
    const Scalar z13 = n0_0825 * z5;
    const Scalar z14 = s_q4 * z6 + c_q4 * z4;
    const Scalar z15 = s_q4 * z4 - c_q4 * z6;
    const Scalar z16 = v_q4 - z5;  // angular velocity of link4, z
    const Scalar z17 = z11 - n0_0825 * z6;
    const Scalar z18 = n0_316 * c_q2;
    const Scalar z19 = k10 * s_q3 - k11 * c_q3;
    const Scalar z20 = n0_333 + z18;
    const Scalar z21 = s_q2 * z19 - k13 * c_q2;
    const Scalar z22 = s_q4 * z13 - c_q4 * z10;
    const Scalar z23 = n0_0825 * c_q3;
    const Scalar z24 = s_q4 * z10 + c_q4 * z13;
    const Scalar z25 = s_q2 * z23 - z18;
    const Scalar z26 = n0_333 - z25;
    const Scalar z27 = k10 * z6 + k13 * z5 - k14 * z10;
    const Scalar z28 = k11 * z6 + k13 * z4 - k14 * z11;
    const Scalar z29 = k15 * z4 - k16 * z5 - k13 * z11 - k17 * z6;
    const Scalar z30 = k18 * z6 + k16 * z4 - k19 * z5 + k13 * z10;
    const Scalar z31 = z17 + n0_384 * z14 - n0_0825 * z15;
    const Scalar z32 = z22 + n0_384 * z16;
    const Scalar z33 = v_q5 - z15;  // angular velocity of link5, z
    const Scalar z34 = c_q5 * z16 + s_q5 * z14;
    const Scalar z35 = z24 + n0_0825 * z16;
    const Scalar z36 = s_q5 * z16 - c_q5 * z14;
    const Scalar z37 = c_q5 * z32 + s_q5 * z31;
    const Scalar z38 = v_q6 + z34;  // angular velocity of link6, z
    const Scalar z39 = s_q6 * z33 - c_q6 * z36;
    const Scalar z40 = k17 * z4 + k18 * z5 + k10 * z10 + k11 * z11 - k21 * z6;
    const Scalar z41 = s_q6 * z37 - c_q6 * z35;
    const Scalar z42 = s_q5 * z32 - c_q5 * z31;
    const Scalar z43 = s_q6 * z36 + c_q6 * z33;
    const Scalar z44 = z41 + n0_088 * z38;
    const Scalar z45 = s_q7 * z38 + c_q7 * z39;
    const Scalar z46 = v_q7 - z43;  // angular velocity of link7, z
    const Scalar z47 = n0_384 * s_q4 + n0_0825 * c_q4;
    const Scalar z48 = n0_0825 - z47;
    const Scalar z49 = k23 * z16 + k24 * z15 + k25 * z22;
    const Scalar z50 = c_q3 * z48;
    const Scalar z51 = k26 * z16 + k24 * z14 + k25 * z24;
    const Scalar z52 = k23 * z14 + k25 * z17 - k26 * z15;
    const Scalar z53 = k27 * z16 + k28 * z14 + k23 * z17 - k29 * z15 + k24 * z24;
    const Scalar z54 = k29 * z14 - k30 * z16 + k26 * z17 - k31 * z15 - k24 * z22;
    const Scalar z55 = z42 + n0_088 * z43;
    const Scalar z56 = k32 * z16 + k27 * z14 + k30 * z15 + k23 * z22 + k26 * z24;
    const Scalar z57 = s_q6 * z35 + c_q6 * z37;
    const Scalar z58 = s_q7 * z39 - c_q7 * z38;
    const Scalar z59 = k33 * s_q5 + k34 * c_q5;
    const Scalar z60 = k34 * s_q5 - k33 * c_q5;
    const Scalar z61 = n0_0825 * s_q4 - n0_384 * c_q4;
    const Scalar z62 = n0_316 - z61;
    const Scalar z63 = k35 * z34 - k33 * z33 - k36 * z37;
    const Scalar z64 = s_q2 * z50 - c_q2 * z62;
    const Scalar z65 = s_q7 * z55 + c_q7 * z57;
    const Scalar z66 = s_q7 * z57 - c_q7 * z55;
    const Scalar z67 = n0_333 - z64;
    const Scalar z68 = n0_088 * c_q6;
    const Scalar z69 = k35 * z36 + k34 * z33 - k36 * z42;
    const Scalar z70 = k33 * z36 + k34 * z34 + k36 * z35;
    const Scalar z71 = k37 * z36 - k38 * z34 + k39 * z33 + k33 * z35 - k35 * z42;
    const Scalar z72 = k40 * z34 - k38 * z36 - k41 * z33 + k34 * z35 - k35 * z37;
    const Scalar z73 = n0_088 * s_q6;
    const Scalar z74 = k39 * z36 - k41 * z34 + k42 * z33 + k33 * z37 - k34 * z42;
    const Scalar z75 = c_q5 * z68;
    const Scalar z76 = k43 * s_q7 + k44 * c_q7;
    const Scalar z77 = n0_384 + z73;
    const Scalar z78 = n0_0825 - z75;
    const Scalar z79 = k45 * s_q6 + k46 * c_q6;
    const Scalar z80 = k44 * s_q7 - k43 * c_q7;
    const Scalar z81 = s_q5 * z68;
    const Scalar z82 = k47 * z43 - k45 * z38 + k48 * z57;
    const Scalar z83 = k46 * z38 + k47 * z39 + k48 * z41;
    const Scalar z84 = k45 * z39 + k46 * z43 + k48 * z42;
    const Scalar z85 = k49 * z39 - k50 * z38 + k51 * z43 + k45 * z42 + k47 * z41;
    const Scalar z86 = k52 * z38 + k51 * z39 + k53 * z43 + k46 * z42 + k47 * z57;
    const Scalar z87 = k46 * s_q6 - k45 * c_q6;
    const Scalar z88 = k50 * z39 - k54 * z38 - k52 * z43 + k45 * z57 - k46 * z41;
    const Scalar z89 = k55 * s_q6 + c_q6 * z76;
    const Scalar z90 = k47 * s_q5 - c_q5 * z79;
    const Scalar z91 = s_q6 * z76 - k55 * c_q6;
    const Scalar z92 = k47 * c_q5 + s_q5 * z79;
    const Scalar z93 = s_q4 * z77 + c_q4 * z78;
    const Scalar z94 = s_q4 * z78 - c_q4 * z77;
    const Scalar z95 = s_q5 * z80 + c_q5 * z89;
    const Scalar z96 = s_q4 * z87 + c_q4 * z90;
    const Scalar z97 = n0_0825 - z93;
    const Scalar z98 = s_q5 * z89 - c_q5 * z80;
    const Scalar z99 = n0_316 - z94;
    const Scalar z100 = k23 * s_q4 + k26 * c_q4;
    const Scalar z101 = k35 * s_q4 - c_q4 * z59;
    const Scalar z102 = s_q3 * z92 + c_q3 * z96;
    const Scalar z103 = s_q4 * z91 - c_q4 * z95;
    const Scalar z104 = s_q3 * z81 - c_q3 * z97;
    const Scalar z105 = k26 * s_q4 - k23 * c_q4;
    const Scalar z106 = c_q4 * z91 + s_q4 * z95;
    const Scalar z107 = k35 * c_q4 + s_q4 * z59;
    const Scalar z108 = k24 * s_q3 - c_q3 * z100;
    const Scalar z109 = s_q3 * z60 + c_q3 * z101;
    const Scalar z110 = s_q4 * z90 - c_q4 * z87;
    const Scalar z111 = c_q2 * z99 + s_q2 * z104;
    const Scalar z112 = k55 * z58 - k43 * z46 + k56 * z65;
    const Scalar z113 = s_q3 * z98 + c_q3 * z103;
    const Scalar z114 = k55 * z45 - k44 * z46 - k56 * z66;
    const Scalar z115 = k43 * z45 - k44 * z58 + k56 * z44;
    const Scalar z116 = k57 * z45 - k58 * z46 + k59 * z58 + k43 * z44 - k55 * z66;
    const Scalar z117 = k44 * z44 - k59 * z45 - k60 * z58 - k55 * z65 - k61 * z46;
    const Scalar z118 = k58 * z45 - k62 * z46 - k61 * z58 + k43 * z65 - k44 * z66;
    const Scalar z119 = c_q2 * z105 + s_q2 * z108;
    const Scalar z120 = c_q2 * z107 + s_q2 * z109;
    const Scalar z121 = s_q2 * z102 - c_q2 * z110;
    const Scalar z122 = n0_333 + z111;
    const Scalar z123 = c_q2 * z106 + s_q2 * z113;
    result.kinetic = k63 * v_q1 * v_q1 + n0_5 * (v_q2 * z9 - z0 * z7 - z2 * z8 - z10 * z27 - z11 * z28 - z5 * z30 + z24
        * z51 + z4 * z29 + z22 * z49 + z17 * z52 - z6 * z40 + z35 * z70 + z14 * z53 + z16 * z56 - z15 * z54 - z37 * z63
        + z36 * z71 + z34 * z72 + z33 * z74 + z57 * z82 - z42 * (z69 - z84) + z41 * z83 + z43 * z86 + z39 * z85 - z38
        * z88 + z44 * z115 + z65 * z112 - z66 * z114 + z45 * z116 - z46 * z118 - z58 * z117);
    result.force_function = -k65 - k66 * z20 - k67 * z26 - k68 * z67 - k69 * z122 - n9_81 * (z12 + z21 - z119 - z120
        + z121 + z123);
    result.power = v_q1 * u_tau1 + v_q2 * u_tau2 + v_q3 * u_tau3 + v_q4 * u_tau4 + v_q5 * u_tau5 + v_q6 * u_tau6 + v_q7
        * u_tau7;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar k0 = traits::constant(118.9090909090909, 118.90909f, "1308/11");
    const Scalar n632_over_165 = traits::constant(3.83030303030303, 3.830303f, "632/165");
    const Scalar n256_over_55 = traits::constant(4.654545454545454, 4.6545453f, "256/55");
    const Scalar k3 = traits::constant(0.00025801376238, 0.00025801375f, "12900688119/50000000000000");
    const Scalar k4 = traits::constant(0.000638177502105, 0.0006381775f, "127635500421/200000000000000");
    const Scalar n16_over_15 = traits::constant(1.0666666666666667, 1.0666667f, "16/15");
    const Scalar k6 = traits::constant(0.002488708188839716, 0.0024887081f, "622177047209929/250000000000000000");
    const Scalar k7 = traits::constant(0.001672482661783778, 0.0016724827f, "836241330891889/500000000000000000");
    const Scalar k8 = traits::constant(0.000548359106408232, 0.0005483591f, "68544888301029/125000000000000000");
    const Scalar k9 = traits::constant(0.000395108718315752, 0.0003951087f, "49388589789469/125000000000000000");
    const Scalar k10 = traits::constant(0.004909651967360946, 0.004909652f, "2454825983680473/500000000000000000");
    const Scalar k11 = traits::constant(0.00242094377852123, 0.0024209437f, "242094377852123/100000000000000000");
    const Scalar k12 = traits::constant(0.0136098230973375, 0.013609823f, "1088785847787/80000000000000");
    const Scalar k13 = traits::constant(0.0056786982094425, 0.0056786984f, "2271479283777/400000000000000");
    const Scalar k14 = traits::constant(0.03127363074117511, 0.03127363f, "3127363074117511/100000000000000000");
    const Scalar k15 = traits::constant(0.000103758917218685, 0.00010375892f, "20751783443737/200000000000000000");
    const Scalar k16 = traits::constant(9.3569097314605e-05, 9.35691e-05f, "18713819462921/200000000000000000");
    const Scalar k17 = traits::constant(0.005511034382675315, 0.0055110343f, "1102206876535063/200000000000000000");
    const Scalar k18 = traits::constant(0.001208932934385, 0.001208933f, "241786586877/200000000000000");
    const Scalar k19 = traits::constant(0.0055993270925625, 0.005599327f, "89589233481/16000000000000");
    const Scalar k20 = traits::constant(0.030389507210667306, 0.030389506f, "15194753605333653/500000000000000000");
    const Scalar k21 = traits::constant(0.000884123530507804, 0.00088412355f, "221030882626951/250000000000000000");
    const Scalar k22 = traits::constant(0.004600245517563106, 0.0046002455f, "2300122758781553/500000000000000000");
    const Scalar k23 = traits::constant(0.002902312130053428, 0.0029023122f, "725578032513357/250000000000000000");
    const Scalar k24 = traits::constant(0.00216405205209813, 0.002164052f, "216405205209813/100000000000000000");
    const Scalar k25 = traits::constant(0.00151524447332703, 0.0015152445f, "151524447332703/100000000000000000");
    const Scalar k26 = traits::constant(0.1419563931722475, 0.14195639f, "56782557268899/400000000000000");
    const Scalar k27 = traits::constant(0.040431622658625, 0.040431622f, "323452981269/8000000000000");
    const Scalar k28 = traits::constant(0.027133159263935513, 0.02713316f, "13566579631967757/500000000000000000");
    const Scalar k29 = traits::constant(0.024230847133882086, 0.024230847f, "12115423566941043/500000000000000000");
    const Scalar k30 = traits::constant(0.13876407268546084, 0.13876407f, "2775281453709217/20000000000000000");
    const Scalar k31 = traits::constant(0.540829284939183, 0.5408293f, "540829284939182983/1000000000000000000");
    const Scalar k32 = traits::constant(0.632524057252814, 0.6325241f, "632524057252813983/1000000000000000000");
    const Scalar k33 = traits::constant(0.0039053550262761, 0.003905355f, "39053550262761/10000000000000000");
    const Scalar k34 = traits::constant(0.00164448757736927, 0.0016444876f, "164448757736927/100000000000000000");
    const Scalar k35 = traits::constant(0.091694772313631, 0.09169477f, "91694772313631/1000000000000000");
    const Scalar k36 = traits::constant(0.05644303168944, 0.056443032f, "352768948059/6250000000000");
    const Scalar k37 = traits::constant(0.002328735327435, 0.0023287353f, "465747065487/200000000000000");
    const Scalar k38 = traits::constant(0.1128593420530554, 0.11285934f, "3526854439157981/31250000000000000");
    const Scalar k39 = traits::constant(0.004377257121839584, 0.004377257f, "136789285057487/31250000000000000");
    const Scalar k40 = traits::constant(0.005487648106562256, 0.0054876483f, "342978006660141/62500000000000000");
    const Scalar k41 = traits::constant(0.000121912420950744, 0.000121912424f, "15239052618843/125000000000000000");
    const Scalar k42 = traits::constant(0.12445520614822143, 0.124455206f, "15556900768527679/125000000000000000");
    const Scalar k43 = traits::constant(0.01159586409516604, 0.011595864f, "289896602379151/25000000000000000");
    const Scalar k44 = traits::constant(0.04615576498986361, 0.046155766f, "11538941247465903/250000000000000000");
    const Scalar k45 = traits::constant(0.0007689361029464, 0.0007689361f, "961170128683/1250000000000000");
    const Scalar k46 = traits::constant(0.01026110182100817, 0.010261102f, "1026110182100817/100000000000000000");
    const Scalar k47 = traits::constant(0.00398335888393552, 0.003983359f, "24895993024597/6250000000000000");
    const Scalar k48 = traits::constant(0.000790217436631504, 0.0007902174f, "49388589789469/62500000000000000");
    const Scalar n32_over_15 = traits::constant(2.1333333333333333, 2.1333334f, "32/15");
    const Scalar k50 = traits::constant(1.0357790547533403, 1.035779f, "517889527376670159/500000000000000000");
    const Scalar k51 = traits::constant(0.9896232897634767, 0.9896233f, "494811644881738353/500000000000000000");
    const Scalar k52 = traits::constant(0.25610805358974, 0.25610805f, "12805402679487/50000000000000");
    const Scalar k53 = traits::constant(0.000167639551695, 0.00016763955f, "33527910339/200000000000000");
    const Scalar k54 = traits::constant(0.03733744848940618, 0.03733745f, "1866872424470309/50000000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n512_over_55 = traits::constant(9.309090909090909, 9.309091f, "512/55");
    const Scalar k57 = traits::constant(7.66060606060606, 7.660606f, "1264/165");
    const Scalar k58 = traits::constant(0.003665297872941088, 0.0036652978f, "114540558529409/31250000000000000");
    const Scalar k59 = traits::constant(0.001244354094419858, 0.0012443541f, "622177047209929/500000000000000000");
    const Scalar k60 = traits::constant(0.01475269184007975, 0.014752692f, "14752691840079751/1000000000000000000");
    const Scalar k61 = traits::constant(0.015636815370587556, 0.015636815f, "3127363074117511/200000000000000000");
    const Scalar k62 = traits::constant(0.0256820031989088, 0.025682002f, "8025625999659/312500000000000");
    const Scalar k63 = traits::constant(0.001451156065026714, 0.0014511561f, "725578032513357/500000000000000000");
    const Scalar k64 = traits::constant(0.5866766710959985, 0.58667666f, "586676671095998483/1000000000000000000");
    const Scalar k65 = traits::constant(0.0458473861568155, 0.045847386f, "91694772313631/2000000000000000");
    const Scalar k66 = traits::constant(0.0564296710265277, 0.05642967f, "3526854439157981/62500000000000000");
    const Scalar k67 = traits::constant(0.06802553512169374, 0.06802554f, "8503191890211717/125000000000000000");
    const Scalar k68 = traits::constant(0.0001790829744405, 0.00017908297f, "358165948881/2000000000000000");
    const Scalar k69 = traits::constant(1.0127011722584085, 1.0127012f, "15823455816537633/15625000000000000");
    const Scalar k70 = traits::constant(0.023077882494931805, 0.023077883f, "11538941247465903/500000000000000000");
    const Scalar k71 = traits::constant(203.68042513969144, 203.68042f, "500000000000000000/2454825983680473");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
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
    const Scalar angles_[] = {q_q2, q_q3, q_q4, q_q5, q_q6, q_q7};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_q2 = sines_[0], c_q2 = cosines_[0];
    const Scalar s_q3 = sines_[1], c_q3 = cosines_[1];
    const Scalar s_q4 = sines_[2], c_q4 = cosines_[2];
    const Scalar s_q5 = sines_[3], c_q5 = cosines_[3];
    const Scalar s_q6 = sines_[4], c_q6 = cosines_[4];
    const Scalar s_q7 = sines_[5], c_q7 = cosines_[5];
    const Scalar z0 = v_q1 * s_q2;
    const Scalar z1 = v_q1 * c_q2;
    const Scalar z2 = a_q1 * s_q2;
    const Scalar z3 = a_q1 * c_q2;
    const Scalar z4 = v_q2 * v_q2;
    const Scalar z5 = k0 * s_q2;
    const Scalar z6 = k0 * c_q2;
    const Scalar z7 = v_q2 * z1 + z2;  // angular acceleration of link2, x
    const Scalar z8 = v_q2 * z0 - z3;  // angular acceleration of link2, y
    const Scalar z9 = z0 * z1;
    const Scalar z10 = z0 * z0;
    const Scalar z11 = v_q2 * z1;
    const Scalar z12 = v_q2 * s_q3 - c_q3 * z0;
    const Scalar z13 = v_q2 * c_q3 + s_q3 * z0;
    const Scalar z14 = v_q3 + z1;  // angular velocity of link3, z
    const Scalar z15 = a_q2 - z9;
    const Scalar z16 = z4 + z10;
    const Scalar z17 = z14 * z14;
    const Scalar z18 = z7 + z11;
    const Scalar z19 = a_q2 * s_q3 - c_q3 * z7;
    const Scalar z20 = a_q2 * c_q3 + s_q3 * z7;
    const Scalar z21 = a_q3 - z8;  // angular acceleration of link3, z
    const Scalar z22 = z13 * z13;
    const Scalar z23 = z12 * z13;
    const Scalar z24 = z12 * z14;
    const Scalar z25 = s_q4 * z14 + c_q4 * z12;
    const Scalar z26 = s_q4 * z12 - c_q4 * z14;
    const Scalar z27 = v_q4 - z13;  // angular velocity of link4, z
    const Scalar z28 = z5 - n632_over_165 * z15;
    const Scalar z29 = z6 - n632_over_165 * z16;
    const Scalar z30 = n632_over_165 * z18;
    const Scalar z31 = z22 + z17;
    const Scalar z32 = z21 + z23;
    const Scalar z33 = z27 * z27;
    const Scalar z34 = v_q3 * z13 + z19;  // angular acceleration of link3, x
    const Scalar z35 = v_q3 * z12 - z20;  // angular acceleration of link3, y
    const Scalar z36 = s_q3 * z30 - c_q3 * z28;
    const Scalar z37 = s_q3 * z28 + c_q3 * z30;
    const Scalar z38 = z25 * z25;
    const Scalar z39 = z25 * z27;
    const Scalar z40 = s_q5 * z27 - c_q5 * z25;
    const Scalar z41 = c_q5 * z27 + s_q5 * z25;
    const Scalar z42 = z26 * z26;
    const Scalar z43 = z25 * z26;
    const Scalar z44 = z26 * z27;
    const Scalar z45 = v_q5 - z26;  // angular velocity of link5, z
    const Scalar z46 = z35 + z24;
    const Scalar z47 = s_q4 * z21 + c_q4 * z34;
    const Scalar z48 = s_q4 * z34 - c_q4 * z21;
    const Scalar z49 = a_q4 + z35;  // angular acceleration of link4, z
    const Scalar z50 = z33 + z38;
    const Scalar z51 = z42 + z33;
    const Scalar z52 = s_q6 * z45 - c_q6 * z40;
    const Scalar z53 = s_q6 * z40 + c_q6 * z45;
    const Scalar z54 = v_q6 + z41;  // angular velocity of link6, z
    const Scalar z55 = z29 + z46;
    const Scalar z56 = z49 + z43;
    const Scalar z57 = z49 - z43;
    const Scalar z58 = v_q4 * z26 - z47;  // angular acceleration of link4, x
    const Scalar z59 = z36 - z31;
    const Scalar z60 = z37 + z32;
    const Scalar z61 = z54 * z54;
    const Scalar z62 = v_q4 * z25 + z48;  // angular acceleration of link4, y
    const Scalar z63 = s_q4 * z55 + c_q4 * z59;
    const Scalar z64 = s_q4 * z59 - c_q4 * z55;
    const Scalar z65 = z58 + z44;
    const Scalar z66 = s_q5 * z49 + c_q5 * z58;
    const Scalar z67 = s_q7 * z54 + c_q7 * z52;
    const Scalar z68 = v_q7 - z53;  // angular velocity of link7, z
    const Scalar z69 = s_q7 * z52 - c_q7 * z54;
    const Scalar z70 = v_q5 * z41 + z66;  // angular acceleration of link5, x
    const Scalar z71 = a_q5 - z62;  // angular acceleration of link5, z
    const Scalar z72 = s_q5 * z58 - c_q5 * z49;
    const Scalar z73 = v_q5 * z40 + z72;  // angular acceleration of link5, y
    const Scalar z74 = c_q6 * z71 + s_q6 * z70;
    const Scalar z75 = s_q6 * z71 - c_q6 * z70;
    const Scalar z76 = a_q6 - z73;  // angular acceleration of link6, z
    const Scalar z77 = z68 * z68;
    const Scalar z78 = z67 * z67;
    const Scalar z79 = v_q6 * z52 - z74;  // angular acceleration of link6, y
    const Scalar z80 = v_q6 * z53 + z75;  // angular acceleration of link6, x
    const Scalar z81 = z62 + z39;
    const Scalar z82 = z51 - n256_over_55 * z56 + z63;
    const Scalar z83 = a_q7 + z79;  // angular acceleration of link7, z
    const Scalar z84 = z69 * z69;
    const Scalar z85 = z67 * z69;
    const Scalar z86 = z77 + z78;
    const Scalar z87 = z60 + n256_over_55 * z65 + z81;
    const Scalar z88 = n256_over_55 * z50 + z57 + z64;
    const Scalar z89 = z53 * z53;
    const Scalar z90 = s_q7 * z76 + c_q7 * z80;
    const Scalar z91 = v_q7 * z69 - z90;  // angular acceleration of link7, x
    const Scalar z92 = z84 + z77;
    const Scalar z93 = z83 - z85;
    const Scalar z94 = k3 * z86 + k4 * z93;  // force on link7, times 0.0825 m, y
    const Scalar z95 = c_q5 * z82 + s_q5 * z87;
    const Scalar z96 = s_q5 * z82 - c_q5 * z87;
    const Scalar z97 = z52 * z52;
    const Scalar z98 = s_q7 * z80 - c_q7 * z76;
    const Scalar z99 = v_q7 * z67 + z98;  // angular acceleration of link7, y
    const Scalar z100 = z83 + z85;
    const Scalar z101 = k4 * z92 - k3 * z100;  // force on link7, times 0.0825 m, x
    const Scalar z102 = z69 * z68;
    const Scalar z103 = z52 * z53;
    const Scalar z104 = z84 - z78;
    const Scalar z105 = s_q6 * z88 - c_q6 * z95;
    const Scalar z106 = z89 + z61;
    const Scalar z107 = z52 * z54;
    const Scalar z108 = z67 * z68;
    const Scalar z109 = z91 + z102;
    const Scalar z110 = c_q6 * z88 + s_q6 * z95;
    const Scalar z111 = z89 - z97;
    const Scalar z112 = z76 + z103;
    const Scalar z113 = z84 - z77;
    const Scalar z114 = z77 - z78;
    const Scalar z115 = z79 + z107;
    const Scalar z116 = z79 - z107;
    const Scalar z117 = z99 + z108;
    const Scalar z118 = z99 - z108;
    const Scalar z119 = z61 - z97;
    const Scalar z120 = z105 + n16_over_15 * z106;
    const Scalar z121 = s_q7 * z94 + c_q7 * z101;
    const Scalar z122 = z110 - n16_over_15 * z112;
    const Scalar z123 = k6 * z108 + k7 * z114 + k4 * z122 + k8 * z100 - k9 * z109;  // moment on link7, y
    const Scalar z124 = k10 * z102 + k8 * z113 + k3 * z122 + k7 * z93 + k11 * z91 - k9 * z117;  // moment on link7, x
    const Scalar z125 = z91 - z102;
    const Scalar z126 = k3 * z109 + k4 * z117;  // force on link7, times 0.0825 m, z
    const Scalar z127 = z53 * z54;
    const Scalar z128 = z96 + n16_over_15 * z115;
    const Scalar z129 = s_q7 * z101 - c_q7 * z94;
    const Scalar z130 = z76 - z103;
    const Scalar z131 = k12 * z106 + z121 - k13 * z130;  // force on link6, times 0.0825 m, x
    const Scalar z132 = z45 * z45;
    const Scalar z133 = z40 * z40;
    const Scalar z134 = z41 * z41;
    const Scalar z135 = z40 * z41;
    const Scalar z136 = z89 - z61;
    const Scalar z137 = z61 + z97;
    const Scalar z138 = k12 * z112 - z126 + k13 * z137;  // force on link6, times 0.0825 m, y
    const Scalar z139 = s_q7 * z120 + c_q7 * z128;
    const Scalar z140 = s_q7 * z128 - c_q7 * z120;
    // moment on link7, z
    const Scalar z141 = k11 * z85 + k9 * z104 + k10 * z83 + k7 * z125 + k4 * z139 + k3 * z140 + k8 * z118;
    const Scalar z142 = z62 - z39;
    const Scalar z143 = z42 - z38;
    const Scalar z144 = z41 * z45;
    const Scalar z145 = z132 - z133;
    const Scalar z146 = z80 + z127;
    const Scalar z147 = z134 - z133;
    const Scalar z148 = z134 - z132;
    const Scalar z149 = z40 * z45;
    // moment on link6, y
    const Scalar z150 = k14 * z107 + k15 * z119 + k12 * z96 - k16 * z130 - k17 * z146 - n16_over_15 * z129 + z141;
    const Scalar z151 = k12 * z115 - z129 - k13 * z146;  // force on link6, times 0.0825 m, z
    const Scalar z152 = z80 - z127;
    const Scalar z153 = z71 + z135;
    const Scalar z154 = z58 - z44;
    const Scalar z155 = z71 - z135;
    const Scalar z156 = c_q6 * z131 + s_q6 * z138;
    const Scalar z157 = z134 + z132;
    const Scalar z158 = z156 - k18 * z157 + k19 * z155;  // force on link5, times 0.0825 m, x
    const Scalar z159 = z132 + z133;
    const Scalar z160 = z151 + k18 * z153 + k19 * z159;  // force on link5, times 0.0825 m, y
    const Scalar z161 = z70 - z144;
    const Scalar z162 = z33 - z38;
    const Scalar z163 = z42 - z33;
    const Scalar z164 = z73 - z149;
    const Scalar z165 = z73 + z149;
    const Scalar z166 = s_q6 * z131 - c_q6 * z138;
    const Scalar z167 = s_q7 * z123 - c_q7 * z124;
    // moment on link6, x
    const Scalar z168 = k13 * z96 - k20 * z127 - k16 * z136 + k21 * z80 + k15 * z112 + k17 * z115 - z167;
    const Scalar z169 = z70 + z144;
    const Scalar z170 = z166 - k18 * z165 + k19 * z169;  // force on link5, times 0.0825 m, z
    const Scalar z171 = c_q7 * z123 + s_q7 * z124;
    // moment on link6, z
    const Scalar z172 = k17 * z111 - k21 * z103 - k20 * z76 + k13 * z105 + k12 * z110 + k15 * z152 + k16 * z116
        + n16_over_15 * z126 + z171;
    const Scalar z173 = k22 * z145 - k23 * z149 - k24 * z155 + k18 * z88 - k25 * z169 - z172;  // moment on link5, y
    const Scalar z174 = z170 + k26 * z50 + k27 * z57;  // force on link4, times 0.0825 m, y
    const Scalar z175 = z35 - z24;
    const Scalar z176 = s_q5 * z160 - c_q5 * z158;
    const Scalar z177 = z176 + k27 * z51 - k26 * z56;  // force on link4, times 0.0825 m, x
    const Scalar z178 = z21 - z23;
    const Scalar z179 = z12 * z12;
    const Scalar z180 = s_q6 * z150 - c_q6 * z168;
    // moment on link5, x
    const Scalar z181 = k28 * z144 - k24 * z148 + k29 * z70 + k22 * z153 + k19 * z88 + k25 * z165 - z180;
    const Scalar z182 = z13 * z14;
    const Scalar z183 = z17 - z179;
    const Scalar z184 = s_q6 * z168 + c_q6 * z150;
    // moment on link5, z
    const Scalar z185 = k29 * z135 - k25 * z147 - k28 * z71 - k22 * z161 - k24 * z164 + k19 * z95 - k18 * z96 + z184;
    const Scalar z186 = k3 * s_q7 + k4 * c_q7;
    const Scalar z187 = k8 * s_q7 - k7 * c_q7;
    const Scalar z188 = k4 * s_q7 - k3 * c_q7;
    const Scalar z189 = k7 * s_q7 + k8 * c_q7;
    const Scalar z190 = k10 + n16_over_15 * z186;
    const Scalar z191 = s_q6 * z187 - c_q6 * z190;
    const Scalar z192 = c_q6 * z188;
    const Scalar z193 = s_q6 * z188;
    const Scalar z194 = c_q6 * z187 + s_q6 * z190;
    const Scalar z195 = z34 + z182;
    const Scalar z196 = c_q5 * z173 + s_q5 * z181;
    // moment on link4, z
    const Scalar z197 = k30 * z143 - k31 * z43 - k32 * z49 + k33 * z154 + k26 * z63 - k34 * z142 - k27 * z64 - z170
        + n256_over_55 * z176 - z196;
    const Scalar z198 = c_q5 * z160 + s_q5 * z158;
    const Scalar z199 = k35 * z39 - k33 * z162 + k34 * z56 + k27 * z60 + k30 * z65 + z185 - z198;  // moment on link4, y
    const Scalar z200 = k26 * z65 - z198 + k27 * z81;  // force on link4, times 0.0825 m, z
    const Scalar z201 = s_q5 * z186 - c_q5 * z192;
    const Scalar z202 = z22 - z17;
    const Scalar z203 = z17 + z179;
    const Scalar z204 = k36 * z32 + z200 - k37 * z203;  // force on link3, times 0.0825 m, y
    const Scalar z205 = s_q4 * z177 - c_q4 * z174;
    // moment on link3, y
    const Scalar z206 = k38 * z24 + k36 * z29 + k39 * z178 + k40 * z183 + k41 * z195 - z197 + z205;
    const Scalar z207 = z7 - z11;
    const Scalar z208 = s_q5 * z173 - c_q5 * z181;
    // moment on link4, x
    const Scalar z209 = k32 * z44 + k34 * z163 - k33 * z57 + k26 * z60 + k31 * z58 + k30 * z81 - n256_over_55 * z198
        - z208;
    const Scalar z210 = c_q5 * z189 + s_q5 * z194;
    const Scalar z211 = z193 - n256_over_55 * z201 - z210;
    const Scalar z212 = c_q5 * z186 + s_q5 * z192;
    const Scalar z213 = s_q5 * z189 - c_q5 * z194;
    const Scalar z214 = n256_over_55 * z212 - z213;
    const Scalar z215 = z191 + z212;
    const Scalar z216 = s_q4 * z201 - c_q4 * z193;
    const Scalar z217 = z211 + z216;
    const Scalar z218 = s_q4 * z193 + c_q4 * z201;
    const Scalar z219 = c_q4 * z215 + s_q4 * z214;
    const Scalar z220 = s_q4 * z215 - c_q4 * z214;
    const Scalar z221 = z34 - z182;
    const Scalar z222 = z212 - z219;
    const Scalar z223 = z22 - z179;
    const Scalar z224 = s_q3 * z212 + c_q3 * z218;
    const Scalar z225 = v_q2 * z0;
    const Scalar z226 = s_q4 * z199 - c_q4 * z209;
    // moment on link3, x
    const Scalar z227 = k42 * z182 + k37 * z29 - k40 * z32 - k39 * z202 + k43 * z34 + k41 * z46 + z226;
    const Scalar z228 = z8 - z225;
    const Scalar z229 = z8 + z225;
    const Scalar z230 = z1 * z1;
    const Scalar z231 = s_q4 * z174 + c_q4 * z177;
    const Scalar z232 = k36 * z31 - z231 + k37 * z178;  // force on link3, times 0.0825 m, x
    const Scalar z233 = c_q3 * z217 + s_q3 * z220;
    const Scalar z234 = s_q3 * z218 - c_q3 * z212;
    const Scalar z235 = s_q3 * z217 - c_q3 * z220;
    const Scalar z236 = z4 - z10;
    const Scalar z237 = z4 - z230;
    const Scalar z238 = a_q2 + z9;
    const Scalar z239 = c_q4 * z199 + s_q4 * z209;
    // moment on link3, z
    const Scalar z240 = k43 * z23 - k42 * z21 - k41 * z223 + k40 * z221 - k39 * z175 + k37 * z36 - k36 * z37 - z200
        + z239;
    const Scalar z241 = k44 * z225 + k45 * z15 + k46 * z236 + k47 * z18 + z240;  // moment on link2, y
    const Scalar z242 = n632_over_165 * z224 - z233;
    const Scalar z243 = n632_over_165 * z234 - z235;
    const Scalar z244 = k11 * s_q7 - k48 * c_q7;
    const Scalar z245 = s_q7 * z244;
    const Scalar z246 = k9 + c_q7 * z244;
    const Scalar z247 = k10 + n32_over_15 * z186;
    const Scalar z248 = k17 - z187;
    const Scalar z249 = k11 - z245;
    const Scalar z250 = n32_over_15 * z186 + z245;
    const Scalar z251 = n16_over_15 * z188 - z246;
    const Scalar z252 = k16 + z189;
    const Scalar z253 = k21 - z249;
    const Scalar z254 = k12 + z186;
    const Scalar z255 = k20 + z250;
    const Scalar z256 = s_q2 * z243 - c_q2 * z222;
    const Scalar z257 = k15 + z251;
    const Scalar z258 = c_q3 * z227 + s_q3 * z206;
    const Scalar z259 = s_q3 * z232 - c_q3 * z204;
    // moment on link2, x
    const Scalar z260 = k50 * z11 + k51 * z7 - k46 * z238 + k45 * z237 + k47 * z229 - z258 - n632_over_165 * z259;
    const Scalar z261 = z10 - z230;
    const Scalar z262 = s_q3 * z227 - c_q3 * z206;
    const Scalar z263 = s_q3 * z204 + c_q3 * z232;
    // moment on link2, z
    const Scalar z264 = k50 * a_q2 - k52 * z5 + k53 * z6 - k51 * z9 - k47 * z261 - k46 * z207 + k45 * z228 + z262
        - n632_over_165 * z263;
    const Scalar z265 = s_q6 * z252 + c_q6 * z257;
    const Scalar z266 = k13 * s_q6 + c_q6 * z254;
    const Scalar z267 = s_q6 * z257 - c_q6 * z252;
    const Scalar z268 = s_q6 * z254 - k13 * c_q6;
    const Scalar z269 = c_q5 * z268;
    const Scalar z270 = c_q5 * z255 + s_q5 * z265;
    const Scalar z271 = s_q5 * z268;
    const Scalar z272 = s_q5 * z255 - c_q5 * z265;
    const Scalar z273 = z266 - n256_over_55 * z269 - z270;
    const Scalar z274 = n256_over_55 * z271 + z272;
    const Scalar z275 = z267 - z271;
    const Scalar z276 = s_q4 * z269 - c_q4 * z266;
    const Scalar z277 = s_q4 * z274 - c_q4 * z275;
    const Scalar z278 = s_q4 * z266 + c_q4 * z269;
    const Scalar z279 = z273 + z276;
    const Scalar z280 = s_q4 * z275 + c_q4 * z274;
    const Scalar z281 = s_q2 * z260 - c_q2 * z241;
    const Scalar z282 = z271 - z277;
    const Scalar z283 = k54 * a_q1 + z281;  // moment on link1, z
    const Scalar z284 = z247 + z253;
    const Scalar z285 = n2 * z248;
    const Scalar z286 = s_q6 * z284 - c_q6 * z285;
    const Scalar z287 = k25 - z265;
    const Scalar z288 = n2 * z287;
    const Scalar z289 = k19 - z188;
    const Scalar z290 = k18 - z266;
    const Scalar z291 = k24 + z267;
    const Scalar z292 = s_q5 * z289 + c_q5 * z290;
    const Scalar z293 = s_q5 * z290 - c_q5 * z289;
    const Scalar z294 = s_q6 * z286;
    const Scalar z295 = c_q6 * z286 + z248;
    const Scalar z296 = k26 + z268;
    const Scalar z297 = s_q3 * z271 - c_q3 * z278;
    const Scalar z298 = k22 + z295;
    const Scalar z299 = z253 - z294;
    const Scalar z300 = z247 - z294;
    const Scalar z301 = k27 + z292;
    const Scalar z302 = k29 - z299;
    const Scalar z303 = k28 + z300;
    const Scalar z304 = s_q5 * z298 - c_q5 * z291;
    const Scalar z305 = s_q5 * z291 + c_q5 * z298;
    const Scalar z306 = z255 - z302;
    const Scalar z307 = z303 + n2 * z292;
    const Scalar z308 = z268 + n256_over_55 * z292 - z305;
    const Scalar z309 = c_q5 * z288 + s_q5 * z306;
    const Scalar z310 = n256_over_55 * z293 - z304;
    const Scalar z311 = k30 + z308;
    const Scalar z312 = n256_over_55 * z292 - z305;
    const Scalar z313 = s_q5 * z309;
    const Scalar z314 = c_q5 * z309 - z287;
    const Scalar z315 = k34 + z310;
    const Scalar z316 = z302 + z313;
    const Scalar z317 = z255 - z313;
    const Scalar z318 = z293 + z314;
    const Scalar z319 = z303 + z292;
    const Scalar z320 = c_q4 * z319 + s_q4 * z312;
    const Scalar z321 = n512_over_55 * z268 + z316;
    const Scalar z322 = z317 + n512_over_55 * z268 + n2 * z292;
    const Scalar z323 = k33 + z318;
    const Scalar z324 = k31 + z321;
    const Scalar z325 = s_q4 * z301 - c_q4 * z296;
    const Scalar z326 = z292 - z320;
    const Scalar z327 = s_q4 * z293;
    const Scalar z328 = s_q4 * z319 - c_q4 * z312;
    const Scalar z329 = k32 + z322;
    const Scalar z330 = c_q4 * z293;
    const Scalar z331 = z310 - z327;
    const Scalar z332 = c_q3 * z279 + s_q3 * z280;
    const Scalar z333 = n632_over_165 * z297 + z332;
    const Scalar z334 = s_q3 * z292 + c_q3 * z330;
    const Scalar z335 = s_q3 * z328 - c_q3 * z331;
    const Scalar z336 = n632_over_165 * z334 - z335;
    const Scalar z337 = c_q3 * z271 + s_q3 * z278;
    const Scalar z338 = s_q4 * z296 + c_q4 * z301;
    const Scalar z339 = s_q3 * z279 - c_q3 * z280;
    const Scalar z340 = n632_over_165 * z337 - z339;
    const Scalar z341 = s_q4 * z315 + c_q4 * z323;
    const Scalar z342 = s_q4 * z323 - c_q4 * z315;
    const Scalar z343 = z329 - z338;
    const Scalar z344 = c_q3 * z325;
    const Scalar z345 = s_q3 * z330 - c_q3 * z292;
    const Scalar z346 = c_q3 * z328 + s_q3 * z331;
    const Scalar z347 = n632_over_165 * z345 + z346;
    const Scalar z348 = c_q2 * z282 + s_q2 * z340;
    const Scalar z349 = z307 - z324;
    const Scalar z350 = n2 * z311;
    const Scalar z351 = s_q4 * z349 - c_q4 * z350;
    const Scalar z352 = z293 - z341;
    const Scalar z353 = k41 - z352;
    const Scalar z354 = z329 - n2 * z338;
    const Scalar z355 = k37 - z293;
    const Scalar z356 = k39 + z342;
    const Scalar z357 = k36 - z338;
    const Scalar z358 = n2 * z353;
    const Scalar z359 = s_q3 * z355 - c_q3 * z357;
    const Scalar z360 = s_q4 * z351;
    const Scalar z361 = c_q4 * z351 + z311;
    const Scalar z362 = s_q3 * z341 - c_q3 * z343;
    const Scalar z363 = n632_over_165 * z344 + z362;
    const Scalar z364 = z325 - z361;
    const Scalar z365 = z324 + z360;
    const Scalar z366 = z307 - z360;
    const Scalar z367 = k43 + z365;
    const Scalar z368 = n2 * z338 - z366;
    const Scalar z369 = k40 - z364;
    const Scalar z370 = c_q3 * z355 + s_q3 * z357;
    const Scalar z371 = z354 - z367;
    const Scalar z372 = k42 - z368;
    const Scalar z373 = s_q3 * z356 - c_q3 * z369;
    const Scalar z374 = c_q3 * z358 + s_q3 * z371;
    const Scalar z375 = c_q3 * z356 + s_q3 * z369;
    const Scalar z376 = n632_over_165 * z359 + z373;
    const Scalar z377 = n632_over_165 * z370 + z375;
    const Scalar z378 = s_q3 * z325;
    const Scalar z379 = c_q3 * z341 + s_q3 * z343;
    const Scalar z380 = n632_over_165 * z378 - z379;
    const Scalar z381 = s_q2 * z347 - c_q2 * z326;
    const Scalar z382 = z42 + z38;
    const Scalar z383 = z22 + z179;
    const Scalar z384 = z10 + z230;
    const Scalar z385 = n2 * z14;
    const Scalar z386 = n2 * z25;
    const Scalar z387 = n2 * z13;
    const Scalar z388 = n2 * z12;
    const Scalar z389 = s_q3 * z374;
    const Scalar z390 = c_q3 * z374 - z353;
    const Scalar z391 = k46 - z390;
    const Scalar z392 = n2 * z0;
    const Scalar z393 = z367 + z389;
    const Scalar z394 = z354 - z389;
    const Scalar z395 = k57 * z325 - z393;
    const Scalar z396 = k57 * z325 - z394;
    const Scalar z397 = n2 * v_q2;
    const Scalar z398 = k47 + z376;
    const Scalar z399 = n2 * z398;
    const Scalar z400 = k45 + z377;
    const Scalar z401 = k51 - z395;
    const Scalar z402 = k50 - z396;
    const Scalar z403 = c_q2 * z342 + s_q2 * z380;
    const Scalar z404 = z84 + z78;
    const Scalar z405 = z89 + z97;
    const Scalar z406 = z134 + z133;
    const Scalar z407 = n2 * z68;
    const Scalar z408 = n2 * z54;
    const Scalar z409 = n2 * z45;
    const Scalar z410 = n2 * z27;
    const Scalar z411 = n2 * z67;
    const Scalar z412 = n2 * z69;
    const Scalar z413 = k8 * z411;
    const Scalar z414 = k7 * z412;
    const Scalar z415 = k9 * z407;
    const Scalar z416 = k58 * z407 + k8 * z412;
    const Scalar z417 = k7 * z411 - k59 * z407;
    const Scalar z418 = z414 + z415;
    const Scalar z419 = z413 - z415;
    const Scalar z420 = k4 * z407;
    const Scalar z421 = n2 * z53;
    const Scalar z422 = k3 * z407;
    const Scalar z423 = k3 * z411 - k4 * z412;
    const Scalar z424 = k59 * z412 - k8 * z407;
    const Scalar z425 = n2 * z52;
    const Scalar z426 = n2 * z40;
    const Scalar z427 = n2 * z41;
    const Scalar z428 = n2 * z26;
    const Scalar z429 = z372 - z401;
    const Scalar z430 = c_q2 * z399 + s_q2 * z429;
    const Scalar z431 = s_q2 * z376 - c_q2 * z372;
    const Scalar z432 = k7 * z407 + k59 * z411;
    const Scalar z433 = s_q2 * z430;
    const Scalar z434 = k9 * z411;
    const Scalar z435 = k58 * z411 + k9 * z412;
    const Scalar z436 = z372 - z433;
    const Scalar z437 = k59 * z412 + z434;
    const Scalar z438 = z418 - z419;
    const Scalar z439 = n16_over_15 * z408;
    const Scalar z440 = n16_over_15 * z421;
    const Scalar z441 = k54 + z436;
    const Scalar z442 = s_q7 * z420 - c_q7 * z422;
    const Scalar z443 = s_q7 * z422 + c_q7 * z420;
    const Scalar z444 = z413 + z414;
    const Scalar z445 = c_q2 * z400 + s_q2 * z391;
    const Scalar z446 = k52 - z325;
    const Scalar z447 = n2 * z1;
    const Scalar z448 = k53 + z359;
    const Scalar z449 = z416 + z417;
    const Scalar z450 = c_q7 * z449 + s_q7 * z438;
    const Scalar z451 = s_q7 * z435 - c_q7 * z437;
    const Scalar z452 = s_q7 * z432 - c_q7 * z424;
    const Scalar z453 = z451 + z186 * z439 + n16_over_15 * z423;
    const Scalar z454 = s_q7 * z437 + c_q7 * z435;
    const Scalar z455 = z188 * z439 - z454;
    const Scalar z456 = s_q7 * z450;
    const Scalar z457 = c_q7 * z450 - z416;
    const Scalar z458 = c_q7 * z450 - z417;
    const Scalar z459 = z418 - z456;
    const Scalar z460 = z419 + z456;
    const Scalar z461 = c_q7 * z432 + s_q7 * z424;
    const Scalar z462 = n16_over_15 * z442 + z459;
    const Scalar z463 = n2 * v_q1;
    const Scalar z464 = z457 + z186 * z440 - n16_over_15 * z443;
    const Scalar z465 = k60 * z408 - z452 + k16 * z421;
    const Scalar z466 = k15 * z425 - z453 - k61 * z408;
    const Scalar z467 = z464 + k17 * z425 + k61 * z421;
    const Scalar z468 = k60 * z425 - z461 + k17 * z421;
    const Scalar z469 = z458 + k61 * z421 - k16 * z408;
    const Scalar z470 = z188 * z440 + z460;
    const Scalar z471 = k16 * z425;
    const Scalar z472 = k15 * z421;
    const Scalar z473 = z471 + z472 + z470;
    const Scalar z474 = k17 * z408;
    const Scalar z475 = z462 - z472 - z474;
    const Scalar z476 = z471 - z474 + z444;
    const Scalar z477 = z465 + z466;
    const Scalar z478 = z455 + k15 * z408 + k61 * z425;
    const Scalar z479 = s_q6 * z467 - c_q6 * z468;
    const Scalar z480 = z475 + z476;
    const Scalar z481 = k24 * z426;
    const Scalar z482 = k22 * z427;
    const Scalar z483 = k25 * z409;
    const Scalar z484 = k12 * z408 + z423;
    const Scalar z485 = c_q6 * z477 + s_q6 * z480;
    const Scalar z486 = k13 * z408 - z442;
    const Scalar z487 = s_q6 * z478 + c_q6 * z469;
    const Scalar z488 = z487 + k24 * z427 - k62 * z409;
    const Scalar z489 = s_q6 * z485;
    const Scalar z490 = s_q6 * z468 + c_q6 * z467;
    const Scalar z491 = z475 - z489;
    const Scalar z492 = z476 - z489;
    const Scalar z493 = c_q6 * z485 - z466;
    const Scalar z494 = z482 + z483 + z491;
    const Scalar z495 = z481 + z482 + z492;
    const Scalar z496 = z481 - z483 + z473;
    const Scalar z497 = c_q6 * z485 - z465;
    const Scalar z498 = k63 * z427 - z493 + k24 * z409;
    const Scalar z499 = z497 + k25 * z426 - k63 * z427;
    const Scalar z500 = s_q6 * z469 - c_q6 * z478;
    const Scalar z501 = k62 * z426 - z500 - k25 * z427;
    const Scalar z502 = k13 * z425 - z443 + k12 * z421;
    const Scalar z503 = c_q6 * z484 + s_q6 * z486;
    const Scalar z504 = k19 * z426 - z503 + k18 * z427;
    const Scalar z505 = k63 * z426 - z479 - k22 * z409;
    const Scalar z506 = s_q6 * z484 - c_q6 * z486;
    const Scalar z507 = k19 * z409 + z506;
    const Scalar z508 = z490 + k22 * z426 + k63 * z409;
    const Scalar z509 = k18 * z409 - z502;
    const Scalar z510 = z494 - z496;
    const Scalar z511 = z488 + z508;
    const Scalar z512 = n256_over_55 * z410;
    const Scalar z513 = s_q5 * z505 + c_q5 * z498;
    const Scalar z514 = s_q5 * z510 - c_q5 * z511;
    const Scalar z515 = n256_over_55 * z386 - z428;
    const Scalar z516 = c_q5 * z509 + s_q5 * z507;
    const Scalar z517 = s_q5 * z509 - c_q5 * z507;
    const Scalar z518 = z268 * z512 - z513 - n256_over_55 * z517;
    const Scalar z519 = s_q5 * z498 - c_q5 * z505;
    const Scalar z520 = z268 * z515 - z519 + n256_over_55 * z516;
    const Scalar z521 = z518 + k64 * z410 + k34 * z428;
    const Scalar z522 = s_q5 * z514;
    const Scalar z523 = s_q5 * z501 - c_q5 * z499;
    const Scalar z524 = c_q5 * z514 + z488;
    const Scalar z525 = z292 * z515 + z516 - z524;
    const Scalar z526 = c_q5 * z514 + z508;
    const Scalar z527 = z293 * z512 - z526;
    const Scalar z528 = z525 + k30 * z386 - k65 * z428;
    const Scalar z529 = z516 + k26 * z386 - k27 * z428;
    const Scalar z530 = z520 + k64 * z386 - k30 * z428;
    const Scalar z531 = k65 * z428 - z527 - k34 * z410;
    const Scalar z532 = z494 - z522;
    const Scalar z533 = z292 * z512 - z517 - z532;
    const Scalar z534 = k26 * z410 - z517;
    const Scalar z535 = z496 + z522;
    const Scalar z536 = z293 * z515 - z535;
    const Scalar z537 = k34 * z386;
    const Scalar z538 = k33 * z428;
    const Scalar z539 = k30 * z410;
    const Scalar z540 = z539 + z538 + z533;
    const Scalar z541 = z292 * z410 + z504 + z523;
    const Scalar z542 = z537 - z538 + z536;
    const Scalar z543 = z541 + k65 * z410 + k33 * z386;
    const Scalar z544 = c_q5 * z501 + s_q5 * z499;
    const Scalar z545 = z293 * z410 - z544;
    const Scalar z546 = z268 * z410 - z495 + n256_over_55 * z504;
    const Scalar z547 = z539 + z537 + z546;
    const Scalar z548 = k27 * z410 + z504;
    const Scalar z549 = z521 - z543;
    const Scalar z550 = k65 * z386 - z545 - k33 * z410;
    const Scalar z551 = z540 + z547;
    const Scalar z552 = c_q4 * z548 + s_q4 * z534;
    const Scalar z553 = s_q4 * z551 - c_q4 * z549;
    const Scalar z554 = c_q4 * z528 + s_q4 * z530;
    const Scalar z555 = n632_over_165 * z392;
    const Scalar z556 = z338 * z385 + z529 - z554;
    const Scalar z557 = c_q4 * z550 + s_q4 * z531;
    const Scalar z558 = z556 + k40 * z388 - k66 * z385;
    const Scalar z559 = s_q4 * z553;
    const Scalar z560 = s_q4 * z528 - c_q4 * z530;
    const Scalar z561 = z325 * z385 - z560;
    const Scalar z562 = z293 * z387 - z557;
    const Scalar z563 = s_q4 * z550 - c_q4 * z531;
    const Scalar z564 = z563 + k39 * z387 - k67 * z385;
    const Scalar z565 = z562 + k67 * z388 - k41 * z387;
    const Scalar z566 = z547 - z559;
    const Scalar z567 = z540 - z559;
    const Scalar z568 = z325 * z387 - z566;
    const Scalar z569 = k37 * z388 - z552 - k36 * z387;
    const Scalar z570 = s_q4 * z548 - c_q4 * z534;
    const Scalar z571 = z570 + z567;
    const Scalar z572 = k37 * z385 - z570;
    const Scalar z573 = k39 * z388;
    const Scalar z574 = k40 * z387;
    const Scalar z575 = z573 - z574 + z568;
    const Scalar z576 = k41 * z385;
    const Scalar z577 = z574 - z576 + z571;
    const Scalar z578 = n632_over_165 * z397;
    const Scalar z579 = c_q4 * z553 + z521;
    const Scalar z580 = z338 * z387 - z552 + z579;
    const Scalar z581 = c_q4 * z553 - z543;
    const Scalar z582 = k39 * z385 - z581 + k66 * z387;
    const Scalar z583 = z580 + k41 * z388 - k66 * z387;
    const Scalar z584 = z293 * z385 - z542;
    const Scalar z585 = z573 - z576 + z584;
    const Scalar z586 = k68 * z463;
    const Scalar z587 = k40 * z385 - z561 + k66 * z388;
    const Scalar z588 = z564 - z558;
    const Scalar z589 = z577 + z585;
    const Scalar z590 = k36 * z385 - z529;
    const Scalar z591 = z577 + z575;
    const Scalar z592 = c_q3 * z588 + s_q3 * z589;
    const Scalar z593 = z585 - z575;
    const Scalar z594 = n632_over_165 * z569 + z575;
    const Scalar z595 = s_q3 * z587 + c_q3 * z582;
    const Scalar z596 = c_q3 * z565 + s_q3 * z583;
    const Scalar z597 = z6 * z370;
    const Scalar z598 = s_q3 * z592;
    const Scalar z599 = s_q3 * z590 + c_q3 * z572;
    const Scalar z600 = z595 + z325 * z578 + n632_over_165 * z599;
    const Scalar z601 = s_q3 * z582 - c_q3 * z587;
    const Scalar z602 = z577 - z598;
    const Scalar z603 = z577 - z585;
    const Scalar z604 = z585 - z598;
    const Scalar z605 = z359 * z578 - z602;
    const Scalar z606 = z600 + k45 * z447 - k69 * z397;
    const Scalar z607 = z370 * z555 - z604;
    const Scalar z608 = k45 * z392;
    const Scalar z609 = k46 * z447;
    const Scalar z610 = z608 - z609 + z607;
    const Scalar z611 = k47 * z397;
    const Scalar z612 = z611 - z609 + z605;
    const Scalar z613 = z611 - z608 + z594;
    const Scalar z614 = s_q3 * z572 - c_q3 * z590;
    const Scalar z615 = z601 + z325 * z555 + n632_over_165 * z614;
    const Scalar z616 = z12 * z569 - z355 * z383 - z221 * z325 + z204;
    const Scalar z617 = z175 * z325 + z357 * z383 + z13 * z569 + z232;
    const Scalar z618 = z221 * z356 - z37 * z355 - z36 * z357 + z175 * z369 - z372 * z383 + z12 * z565 - z13 * z583;
    const Scalar z619 = s_q3 * z565 - c_q3 * z583;
    const Scalar z620 = z206 + z221 * z353 - z36 * z325 - z175 * z367 + z369 * z383 + z12 * z564 - z13 * z593;
    const Scalar z621 = c_q3 * z592 - z564;
    const Scalar z622 = c_q3 * z592 + z558;
    const Scalar z623 = z370 * z578 + z622;
    const Scalar z624 = z359 * z555 - z621;
    const Scalar z625 = z582 + z353 * z388 + z367 * z387;
    const Scalar z626 = z603 + z370 * z555 - z359 * z578;
    const Scalar z627 = z369 * z387 - z603 - z356 * z388;
    const Scalar z628 = z325 * z388 - z590;
    const Scalar z629 = z325 * z387 - z572;
    const Scalar z630 = z587 + z353 * z387 + z354 * z388;
    const Scalar z631 = z623 + k45 * z397 + k70 * z447;
    const Scalar z632 = k69 * z392 - z615 - k47 * z447;
    const Scalar z633 = z624 + k47 * z392 - k70 * z447;
    const Scalar z634 = z207 * z400 - z6 * z446 - z5 * z448 + z228 * z391 - z402 * z384 + z0 * z632 - z1 * z633;
    const Scalar z635 = c_q2 * z632 + s_q2 * z633;
    const Scalar z636 = z631 + z398 * z392 + z401 * z447;
    const Scalar z637 = z37 * z325;
    const Scalar z638 = z637 - z175 * z353 - z356 * z383 + z221 * z354 - z227 - z13 * z558 + z12 * z591;
    const Scalar z639 = s_q3 * z616 + c_q3 * z617;
    const Scalar z640 = s_q3 * z617 - c_q3 * z616;
    const Scalar z641 = z596 + z372 * z392 + z376 * z447;
    const Scalar z642 = z207 * z372 - z597 - z228 * z376 - z377 * z384 + z1 * z619 + z0 * z626;
    const Scalar z643 = s_q2 * z619 - c_q2 * z626;
    const Scalar z644 = k46 * z392 - z619 - k70 * z397;
    const Scalar z645 = z596 + k46 * z397 + k70 * z392;
    const Scalar z646 = z63 * z301 + z64 * z296 - z154 * z315 - z142 * z323 - z329 * z382 - z26 * z528 + z25 * z530;
    const Scalar z647 = z338 * z385 - z554;
    const Scalar z648 = z645 + z372 * z392 + z398 * z447;
    const Scalar z649 = s_q2 * z636 - c_q2 * z648;
    const Scalar z650 = z540 - z547;
    const Scalar z651 = z540 + z542;
    const Scalar z652 = z547 - z542;
    const Scalar z653 = s_q3 * z638 + c_q3 * z620;
    const Scalar z654 = n632_over_165 * z639 + z653;
    const Scalar z655 = s_q3 * z620 - c_q3 * z638;
    const Scalar z656 = n632_over_165 * z640 + z655;
    const Scalar z657 = z323 * z428 - z650 - z315 * z386;
    const Scalar z658 = s_q2 * z654 - c_q2 * z618;
    const Scalar z659 = z612 + z613;
    const Scalar z660 = z325 * z387 + z650;
    const Scalar z661 = z606 - z644;
    const Scalar z662 = s_q2 * z659 - c_q2 * z661;
    const Scalar z663 = z637 - z175 * z341 - z342 * z383 + z221 * z343 + z12 * z660 - z13 * z647;
    const Scalar z664 = z341 * z387 - z561 + z343 * z388;
    const Scalar z665 = s_q2 * z662;
    const Scalar z666 = z612 - z665;
    const Scalar z667 = z561 + z344 * z555 - z378 * z578;
    const Scalar z668 = s_q3 * z660 - c_q3 * z647;
    const Scalar z669 = c_q3 * z660 + s_q3 * z647;
    const Scalar z670 = z338 * z555 - z668;
    const Scalar z671 = z666 + z586;
    const Scalar z672 = z338 * z578 - z669;
    const Scalar z673 = z610 + z586;
    const Scalar z674 = z5 * z338 - z6 * z344 - z207 * z342 - z228 * z380 - z363 * z384 + z0 * z667 + z1 * z670;
    const Scalar z675 = z671 - z673;
    const Scalar z676 = z342 * z392 - z672 - z380 * z447;
    const Scalar z677 = z612 - z613;
    const Scalar z678 = z612 - z610;
    const Scalar z679 = z597 - z207 * z372 + z228 * z398 + z400 * z384 + z260 + z1 * z644 + z0 * z678;
    const Scalar z680 = z613 + z610;
    const Scalar z681 = z241 + z5 * z370 + z207 * z398 + z391 * z384 - z228 * z401 + z0 * z606 + z1 * z680;
    const Scalar z682 = z677 + z391 * z447 - z400 * z392;
    const Scalar z683 = z323 * z382 - z199 - z63 * z293 - z154 * z311 + z142 * z324 + z25 * z521 - z26 * z652;
    const Scalar z684 = s_q2 * z670 - c_q2 * z667;
    const Scalar z685 = c_q2 * z679 + s_q2 * z681;
    const Scalar z686 = z531 + z311 * z386 + z324 * z428;
    const Scalar z687 = z25 * z529 - z296 * z382 - z154 * z293 - z174;
    const Scalar z688 = z301 * z382 + z142 * z293 + z26 * z529 + z177;
    const Scalar z689 = z550 + z307 * z386 + z311 * z428;
    const Scalar z690 = z64 * z293;
    const Scalar z691 = z690 - z154 * z307 + z142 * z311 - z315 * z382 + z209 - z26 * z543 + z25 * z651;
    const Scalar z692 = s_q4 * z687 - c_q4 * z688;
    const Scalar z693 = c_q4 * z687 + s_q4 * z688;
    const Scalar z694 = z646 - z692;
    const Scalar z695 = z142 * z296 - z154 * z301 - z26 * z548 + z25 * z534;
    const Scalar z696 = z296 * z428 + z301 * z386;
    const Scalar z697 = z293 * z386 - z548;
    const Scalar z698 = z293 * z428 - z534;
    const Scalar z699 = s_q3 * z693 - c_q3 * z695;
    const Scalar z700 = s_q3 * z695 + c_q3 * z693;
    const Scalar z701 = s_q4 * z697 - c_q4 * z698;
    const Scalar z702 = c_q4 * z697 + s_q4 * z698;
    const Scalar z703 = z657 + z701;
    const Scalar z704 = c_q4 * z689 + s_q4 * z686;
    const Scalar z705 = s_q4 * z689 - c_q4 * z686;
    const Scalar z706 = z696 - z704;
    const Scalar z707 = s_q4 * z691 - c_q4 * z683;
    const Scalar z708 = c_q4 * z691 + s_q4 * z683;
    const Scalar z709 = s_q3 * z629 - c_q3 * z628;
    const Scalar z710 = z695 - z708;
    const Scalar z711 = s_q3 * z628 + c_q3 * z629;
    const Scalar z712 = z496 - z495;
    const Scalar z713 = s_q3 * z694 + c_q3 * z707;
    const Scalar z714 = n632_over_165 * z699 + z713;
    const Scalar z715 = s_q3 * z707 - c_q3 * z694;
    const Scalar z716 = n632_over_165 * z700 - z715;
    const Scalar z717 = s_q3 * z630 + c_q3 * z625;
    const Scalar z718 = s_q3 * z625 - c_q3 * z630;
    const Scalar z719 = n632_over_165 * z711 - z717;
    const Scalar z720 = z161 * z291 - z303 * z406 - z164 * z298 + z95 * z290 + z96 * z289 + z40 * z501 - z41 * z499;
    const Scalar z721 = n632_over_165 * z709 - z718;
    const Scalar z722 = z494 + z496;
    const Scalar z723 = z494 - z495;
    const Scalar z724 = s_q2 * z714 - c_q2 * z710;
    const Scalar z725 = s_q2 * z719 - c_q2 * z627;
    const Scalar z726 = z161 * z287 - z298 * z406 - z164 * z302 - z95 * z268 + z40 * z488 - z173 - z41 * z712;
    const Scalar z727 = z292 * z512 - z722 + z293 * z515;
    const Scalar z728 = z291 * z426 - z722 + z298 * z427;
    const Scalar z729 = z292 * z410 + z523;
    const Scalar z730 = z164 * z268 - z290 * z406 + z41 * z504 + z158;
    const Scalar z731 = z40 * z504 - z289 * z406 - z161 * z268 - z160;
    const Scalar z732 = z690 - z154 * z319 + z142 * z312 - z310 * z382 + z25 * z727 - z26 * z729;
    const Scalar z733 = z319 * z386 - z545 + z312 * z428;
    const Scalar z734 = z330 * z387 + z545;
    const Scalar z735 = z96 * z268;
    const Scalar z736 = z735 + z291 * z406 - z161 * z255 + z164 * z287 - z41 * z508 + z181 + z40 * z723;
    const Scalar z737 = s_q4 * z727 + c_q4 * z729;
    const Scalar z738 = s_q4 * z729 - c_q4 * z727;
    const Scalar z739 = z330 * z385 + z738;
    const Scalar z740 = z737 + z292 * z387 - z327 * z385;
    const Scalar z741 = z161 * z290 + z164 * z289 + z41 * z509 + z40 * z507;
    const Scalar z742 = z290 * z426 - z289 * z427;
    const Scalar z743 = z36 * z292 + z37 * z330 + z175 * z328 - z221 * z331 + z326 * z383 + z12 * z734 - z13 * z740;
    const Scalar z744 = z739 + z328 * z387 + z331 * z388;
    const Scalar z745 = z739 + z334 * z555 - z345 * z578;
    const Scalar z746 = z268 * z427 - z507;
    const Scalar z747 = z268 * z426 + z509;
    const Scalar z748 = s_q3 * z734 - c_q3 * z740;
    const Scalar z749 = c_q3 * z734 + s_q3 * z740;
    const Scalar z750 = z327 * z555 + z748;
    const Scalar z751 = z327 * z578 + z749;
    const Scalar z752 = s_q5 * z730 - c_q5 * z731;
    const Scalar z753 = s_q5 * z731 + c_q5 * z730;
    const Scalar z754 = z207 * z326 - z5 * z327 - z6 * z334 - z228 * z347 - z336 * z384 + z0 * z745 - z1 * z750;
    const Scalar z755 = c_q2 * z745 + s_q2 * z750;
    const Scalar z756 = z326 * z392 - z751 + z347 * z447;
    const Scalar z757 = s_q5 * z726 + c_q5 * z736;
    const Scalar z758 = s_q5 * z736 - c_q5 * z726;
    const Scalar z759 = z741 + n256_over_55 * z752 - z757;
    const Scalar z760 = n256_over_55 * z753 + z758;
    const Scalar z761 = z720 + z753;
    const Scalar z762 = c_q4 * z741 + s_q4 * z752;
    const Scalar z763 = s_q4 * z741 - c_q4 * z752;
    const Scalar z764 = z759 - z762;
    const Scalar z765 = s_q4 * z761 - c_q4 * z760;
    const Scalar z766 = c_q4 * z761 + s_q4 * z760;
    const Scalar z767 = c_q3 * z753 + s_q3 * z763;
    const Scalar z768 = z753 - z766;
    const Scalar z769 = s_q3 * z753 - c_q3 * z763;
    const Scalar z770 = s_q3 * z764 + c_q3 * z765;
    const Scalar z771 = n632_over_165 * z767 - z770;
    const Scalar z772 = s_q3 * z765 - c_q3 * z764;
    const Scalar z773 = n632_over_165 * z769 - z772;
    const Scalar z774 = s_q3 * z696 + c_q3 * z702;
    const Scalar z775 = z498 + z287 * z426 + z302 * z427;
    const Scalar z776 = s_q3 * z702 - c_q3 * z696;
    const Scalar z777 = z505 + z255 * z426 + z287 * z427;
    const Scalar z778 = c_q2 * z768 + s_q2 * z771;
    const Scalar z779 = s_q3 * z703 - c_q3 * z705;
    const Scalar z780 = c_q3 * z703 + s_q3 * z705;
    const Scalar z781 = n632_over_165 * z776 - z779;
    const Scalar z782 = n632_over_165 * z774 - z780;
    const Scalar z783 = s_q5 * z746 - c_q5 * z747;
    const Scalar z784 = s_q5 * z747 + c_q5 * z746;
    const Scalar z785 = s_q2 * z781 - c_q2 * z706;
    const Scalar z786 = z105 * z254 - z255 * z405 - k13 * z110 - z152 * z252 + z116 * z257 + z52 * z468 + z53 * z467;
    const Scalar z787 = z110 * z188;
    const Scalar z788 = z116 * z188 - z254 * z405 + z53 * z502 - z131;
    const Scalar z789 = z52 * z502 - k13 * z405 - z152 * z188 - z138;
    const Scalar z790 = z475 - z476;
    const Scalar z791 = z476 - z473;
    const Scalar z792 = z105 * z188 - z257 * z405 + z152 * z248 - z116 * z253 + z52 * z465 - z53 * z791 - z150;
    const Scalar z793 = z475 + z473;
    const Scalar z794 = z53 * z466 - z787 - z252 * z405 - z152 * z247 - z116 * z248 + z52 * z793 - z168;
    const Scalar z795 = z790 + z257 * z421 + z252 * z425;
    const Scalar z796 = z735 + z267 * z406 - z161 * z255 - z164 * z265 + z40 * z790 - z41 * z490;
    const Scalar z797 = z255 * z426 - z479 - z265 * z427;
    const Scalar z798 = z269 * z515 - z479 - z271 * z512;
    const Scalar z799 = s_q5 * z790 - c_q5 * z490;
    const Scalar z800 = c_q5 * z790 + s_q5 * z490;
    const Scalar z801 = z799 + z271 * z410 + z266 * z515;
    const Scalar z802 = z800 + z266 * z512 + z269 * z410;
    const Scalar z803 = z53 * z484 + z152 * z254 + k13 * z116 + z52 * z486;
    const Scalar z804 = z273 * z382 - z63 * z266 - z154 * z275 + z64 * z269 - z142 * z274 + z25 * z798 + z26 * z801;
    const Scalar z805 = z802 + z274 * z428 - z275 * z386;
    const Scalar z806 = z278 * z387 + z802;
    const Scalar z807 = s_q4 * z798 - c_q4 * z801;
    const Scalar z808 = c_q4 * z798 + s_q4 * z801;
    const Scalar z809 = z271 * z387 - z807 + z276 * z385;
    const Scalar z810 = z278 * z385 - z808;
    const Scalar z811 = s_q6 * z788 - c_q6 * z789;
    const Scalar z812 = c_q6 * z788 + s_q6 * z789;
    const Scalar z813 = z297 * z555 - z810 + z337 * z578;
    const Scalar z814 = z37 * z278 - z36 * z271 + z221 * z279 + z175 * z280 - z282 * z383 + z12 * z806 + z13 * z809;
    const Scalar z815 = z810 + z280 * z387 - z279 * z388;
    const Scalar z816 = s_q3 * z806 + c_q3 * z809;
    const Scalar z817 = s_q3 * z809 - c_q3 * z806;
    const Scalar z818 = z276 * z555 + z816;
    const Scalar z819 = z276 * z578 - z817;
    const Scalar z820 = c_q6 * z792 + s_q6 * z794;
    const Scalar z821 = s_q6 * z792 - c_q6 * z794;
    const Scalar z822 = z5 * z276 - z6 * z297 + z207 * z282 + z228 * z340 - z333 * z384 + z0 * z813 + z1 * z818;
    const Scalar z823 = s_q2 * z818 - c_q2 * z813;
    const Scalar z824 = z819 + z282 * z392 - z340 * z447;
    const Scalar z825 = s_q5 * z803 - c_q5 * z811;
    const Scalar z826 = c_q5 * z803 + s_q5 * z811;
    const Scalar z827 = s_q5 * z786 - c_q5 * z820;
    const Scalar z828 = s_q5 * z777 + c_q5 * z775;
    const Scalar z829 = s_q5 * z775 - c_q5 * z777;
    const Scalar z830 = c_q5 * z786 + s_q5 * z820;
    const Scalar z831 = n256_over_55 * z826 + z827;
    const Scalar z832 = n256_over_55 * z784 + z828;
    const Scalar z833 = z742 - n256_over_55 * z783 - z829;
    const Scalar z834 = z821 - z826;
    const Scalar z835 = z728 - z784;
    const Scalar z836 = z812 + n256_over_55 * z825 - z830;
    const Scalar z837 = s_q4 * z812 - c_q4 * z825;
    const Scalar z838 = s_q4 * z783 - c_q4 * z742;
    const Scalar z839 = s_q4 * z742 + c_q4 * z783;
    const Scalar z840 = c_q4 * z812 + s_q4 * z825;
    const Scalar z841 = z833 + z838;
    const Scalar z842 = s_q4 * z834 + c_q4 * z831;
    const Scalar z843 = s_q4 * z835 + c_q4 * z832;
    const Scalar z844 = s_q4 * z831 - c_q4 * z834;
    const Scalar z845 = s_q4 * z832 - c_q4 * z835;
    const Scalar z846 = z836 - z840;
    const Scalar z847 = z826 - z844;
    const Scalar z848 = z784 - z845;
    const Scalar z849 = s_q3 * z839 - c_q3 * z784;
    const Scalar z850 = s_q3 * z784 + c_q3 * z839;
    const Scalar z851 = c_q3 * z826 + s_q3 * z837;
    const Scalar z852 = s_q3 * z826 - c_q3 * z837;
    const Scalar z853 = s_q3 * z846 - c_q3 * z842;
    const Scalar z854 = s_q3 * z841 + c_q3 * z843;
    const Scalar z855 = s_q3 * z843 - c_q3 * z841;
    const Scalar z856 = n632_over_165 * z851 - z853;
    const Scalar z857 = c_q3 * z846 + s_q3 * z842;
    const Scalar z858 = n632_over_165 * z849 - z854;
    const Scalar z859 = n632_over_165 * z850 + z855;
    const Scalar z860 = n632_over_165 * z852 + z857;
    const Scalar z861 = c_q2 * z847 + s_q2 * z856;
    const Scalar z862 = s_q2 * z858 - c_q2 * z848;
    const Scalar z863 = z67 * z435 - k10 * z404 + z69 * z437 - k8 * z125 + k3 * z139 - k4 * z140 + k7 * z118;
    const Scalar z864 = z186 * z439 + z451;
    const Scalar z865 = z478 + z247 * z425 - z248 * z421;
    const Scalar z866 = z253 * z421 - z469 + z248 * z425;
    const Scalar z867 = z188 * z421 - z486;
    const Scalar z868 = z188 * z425 + z484;
    const Scalar z869 = z254 * z425 - k13 * z421;
    const Scalar z870 = z455 + z187 * z421 + z190 * z425;
    const Scalar z871 = z67 * z423 - z94 - k3 * z404;
    const Scalar z872 = z418 + z419;
    const Scalar z873 = z188 * z440 + z872;
    const Scalar z874 = z413 + z414 - z872;
    const Scalar z875 = z419 - z444;
    const Scalar z876 = z418 - z444;
    const Scalar z877 = s_q6 * z867 - c_q6 * z868;
    const Scalar z878 = z116 * z187 - z787 - z189 * z405 - z152 * z190 + z52 * z873 - z53 * z864;
    const Scalar z879 = z69 * z423 + z101 + k4 * z404;
    const Scalar z880 = s_q6 * z868 + c_q6 * z867;
    const Scalar z881 = z67 * z422 - z69 * z420 - k4 * z125 + k3 * z118;
    const Scalar z882 = s_q6 * z873 - c_q6 * z864;
    const Scalar z883 = z191 * z406 - z161 * z189 - z164 * z194 - z95 * z186 - z96 * z192 + z40 * z455 - z41 * z882;
    const Scalar z884 = c_q6 * z873 + s_q6 * z864;
    const Scalar z885 = z884 + z189 * z426 - z194 * z427;
    const Scalar z886 = z884 + z212 * z512 + z201 * z515;
    const Scalar z887 = s_q5 * z455 - c_q5 * z882;
    const Scalar z888 = c_q5 * z455 + s_q5 * z882;
    const Scalar z889 = z887 + z193 * z515 - z212 * z410;
    const Scalar z890 = z888 + z201 * z410 + z193 * z512;
    const Scalar z891 = s_q6 * z865 - c_q6 * z866;
    const Scalar z892 = z67 * z416 - k7 * z404 - z69 * z875 + k9 * z125 + k11 * z118 - z123;
    const Scalar z893 = z211 * z382 - z154 * z215 - z63 * z193 + z142 * z214 + z64 * z201 + z25 * z886 + z26 * z889;
    const Scalar z894 = z215 * z386 - z890 + z214 * z428;
    const Scalar z895 = c_q6 * z865 + s_q6 * z866;
    const Scalar z896 = k8 * z404 - z69 * z417 + z67 * z876 + k9 * z118 - z124;
    const Scalar z897 = z218 * z387 + z890;
    const Scalar z898 = s_q4 * z886 - c_q4 * z889;
    const Scalar z899 = c_q4 * z886 + s_q4 * z889;
    const Scalar z900 = z218 * z385 - z899;
    const Scalar z901 = z898 + z212 * z387 - z216 * z385;
    const Scalar z902 = s_q5 * z869 + c_q5 * z877;
    const Scalar z903 = s_q5 * z877 - c_q5 * z869;
    const Scalar z904 = z900 + z220 * z387 - z217 * z388;
    const Scalar z905 = z36 * z212 + z37 * z218 + z221 * z217 + z175 * z220 + z222 * z383 + z12 * z897 - z13 * z901;
    const Scalar z906 = z900 + z224 * z555 - z234 * z578;
    const Scalar z907 = s_q7 * z871 - c_q7 * z879;
    const Scalar z908 = s_q7 * z879 + c_q7 * z871;
    const Scalar z909 = s_q3 * z897 - c_q3 * z901;
    const Scalar z910 = z216 * z555 + z909;
    const Scalar z911 = c_q3 * z897 + s_q3 * z901;
    const Scalar z912 = z216 * z578 + z911;
    const Scalar z913 = s_q5 * z891 + c_q5 * z795;
    const Scalar z914 = z207 * z222 - z5 * z216 - z6 * z224 - z228 * z243 - z242 * z384 + z0 * z906 - z1 * z910;
    const Scalar z915 = z222 * z392 - z912 + z243 * z447;
    const Scalar z916 = c_q2 * z906 + s_q2 * z910;
    const Scalar z917 = s_q5 * z795 - c_q5 * z891;
    const Scalar z918 = z880 - n256_over_55 * z902 - z913;
    const Scalar z919 = n256_over_55 * z903 + z917;
    const Scalar z920 = s_q7 * z892 - c_q7 * z896;
    const Scalar z921 = c_q7 * z892 + s_q7 * z896;
    const Scalar z922 = z863 + n16_over_15 * z907;
    const Scalar z923 = z895 + z903;
    const Scalar z924 = n16_over_15 * z881 + z920;
    const Scalar z925 = s_q6 * z881 + c_q6 * z908;
    const Scalar z926 = s_q4 * z902 - c_q4 * z880;
    const Scalar z927 = s_q4 * z880 + c_q4 * z902;
    const Scalar z928 = s_q6 * z908 - c_q6 * z881;
    const Scalar z929 = z918 + z926;
    const Scalar z930 = s_q6 * z922 - c_q6 * z921;
    const Scalar z931 = s_q4 * z923 - c_q4 * z919;
    const Scalar z932 = s_q6 * z921 + c_q6 * z922;
    const Scalar z933 = c_q4 * z923 + s_q4 * z919;
    const Scalar z934 = z903 - z933;
    const Scalar z935 = s_q5 * z907 + c_q5 * z925;
    const Scalar z936 = s_q5 * z925 - c_q5 * z907;
    const Scalar z937 = s_q5 * z924 - c_q5 * z930;
    const Scalar z938 = c_q3 * z903 + s_q3 * z927;
    const Scalar z939 = s_q3 * z903 - c_q3 * z927;
    const Scalar z940 = c_q5 * z924 + s_q5 * z930;
    const Scalar z941 = n256_over_55 * z936 + z937;
    const Scalar z942 = s_q3 * z929 + c_q3 * z931;
    const Scalar z943 = s_q3 * z931 - c_q3 * z929;
    const Scalar z944 = n632_over_165 * z938 - z942;
    const Scalar z945 = n632_over_165 * z939 - z943;
    const Scalar z946 = z928 + n256_over_55 * z935 + z940;
    const Scalar z947 = c_q2 * z934 + s_q2 * z944;
    const Scalar z948 = k11 * z412 - z434 + z424;
    const Scalar z949 = u_tau1 - z283;
    const Scalar z950 = u_tau2 - z264;
    const Scalar z951 = u_tau3 + z240;
    const Scalar z952 = u_tau4 + z197;
    const Scalar z953 = u_tau5 + z185;
    const Scalar z954 = u_tau6 + z172;
    const Scalar z955 = u_tau7 - z141;
    const Scalar z956 = k9 * z412 - z432;
    const Scalar z957 = k4 * z411 + k3 * z412;
    const Scalar z958 = k71 * z189;
    const Scalar z959 = k71 * z191;
    const Scalar z960 = k71 * z211;
    const Scalar z961 = k71 * z222;
    const Scalar z962 = s_q7 * z956 + c_q7 * z948;
    const Scalar z963 = s_q7 * z948 - c_q7 * z956;
    const Scalar z964 = n16_over_15 * z957 + z963;
    const Scalar z965 = n16_over_15 * z442 - z874;
    const Scalar z966 = s_q6 * z957 - c_q6 * z443;
    const Scalar z967 = c_q6 * z957 + s_q6 * z443;
    const Scalar z968 = k71 * z242;
    const Scalar z969 = c_q6 * z962 + s_q6 * z965;
    const Scalar z970 = s_q6 * z962 - c_q6 * z965;
    const Scalar z971 = s_q5 * z442 - c_q5 * z966;
    const Scalar z972 = c_q5 * z442 + s_q5 * z966;
    const Scalar z973 = z932 + z936;
    const Scalar z974 = z242 * z968 - z402;
    const Scalar z975 = z256 * z968 + z445;
    const Scalar z976 = c_q4 * z928 + s_q4 * z935;
    const Scalar z977 = s_q4 * z928 - c_q4 * z935;
    const Scalar z978 = z242 * z961 - z377;
    const Scalar z979 = z946 - z976;
    const Scalar z980 = z256 * z961 - z431;
    const Scalar z981 = s_q5 * z969 - c_q5 * z964;
    const Scalar z982 = s_q5 * z964 + c_q5 * z969;
    const Scalar z983 = z967 + n256_over_55 * z971 + z981;
    const Scalar z984 = n256_over_55 * z972 + z982;
    const Scalar z985 = z970 + z972;
    const Scalar z986 = c_q4 * z967 + s_q4 * z971;
    const Scalar z987 = s_q4 * z967 - c_q4 * z971;
    const Scalar z988 = z983 - z986;
    const Scalar z989 = s_q4 * z973 - c_q4 * z941;
    const Scalar z990 = c_q4 * z973 + s_q4 * z941;
    const Scalar z991 = z222 * z961 - z372;
    const Scalar z992 = z242 * z960 - z363;
    const Scalar z993 = z256 * z960 - z403;
    const Scalar z994 = z936 - z990;
    const Scalar z995 = z222 * z960 + z342;
    const Scalar z996 = k71 * z256;
    const Scalar z997 = z256 * z996 - z441;
    const Scalar z998 = s_q4 * z985 - c_q4 * z984;
    const Scalar z999 = c_q4 * z985 + s_q4 * z984;
    const Scalar z1000 = z972 - z999;
    const Scalar z1001 = s_q3 * z977 - c_q3 * z936;
    const Scalar z1002 = s_q3 * z936 + c_q3 * z977;
    const Scalar z1003 = z211 * z960 - z329;
    const Scalar z1004 = z256 * z959 - z381;
    const Scalar z1005 = s_q3 * z979 - c_q3 * z989;
    const Scalar z1006 = n632_over_165 * z1001 - z1005;
    const Scalar z1007 = c_q3 * z979 + s_q3 * z989;
    const Scalar z1008 = n632_over_165 * z1002 - z1007;
    const Scalar z1009 = z191 * z959 - z303;
    const Scalar z1010 = z211 * z959 + z310;
    const Scalar z1011 = z222 * z959 - z326;
    const Scalar z1012 = z242 * z959 - z336;
    const Scalar z1013 = s_q2 * z1006 - c_q2 * z994;
    const Scalar z1014 = z189 * z958 - z255;
    const Scalar z1015 = z191 * z958 - z267;
    const Scalar z1016 = z211 * z958 - z273;
    const Scalar z1017 = z222 * z958 + z282;
    const Scalar z1018 = z242 * z958 + z333;
    const Scalar z1019 = z256 * z958 - z348;
    const Scalar z1020 = n1 / z1014;
    const Scalar z1021 = c_q3 * z972 + s_q3 * z987;
    const Scalar z1022 = s_q3 * z972 - c_q3 * z987;
    const Scalar z1023 = s_q3 * z988 + c_q3 * z998;
    const Scalar z1024 = s_q3 * z998 - c_q3 * z988;
    const Scalar z1025 = n632_over_165 * z1021 - z1023;
    const Scalar z1026 = n632_over_165 * z1022 - z1024;
    const Scalar z1027 = z1015 * z1020;
    const Scalar z1028 = c_q2 * z1000 + s_q2 * z1025;
    const Scalar z1029 = z823 - z916 * z958;
    const Scalar z1030 = z1009 - z1015 * z1027;
    const Scalar z1031 = z1010 - z1016 * z1027;
    const Scalar z1032 = z1011 - z1017 * z1027;
    const Scalar z1033 = z1012 - z1018 * z1027;
    const Scalar z1034 = n1 / z1030;
    const Scalar z1035 = z755 - z916 * z959 - z1027 * z1029;
    const Scalar z1036 = z1004 - z1019 * z1027;
    const Scalar z1037 = z1016 * z1020;
    const Scalar z1038 = z1003 - z1016 * z1037;
    const Scalar z1039 = z995 - z1017 * z1037;
    const Scalar z1040 = z992 - z1018 * z1037;
    const Scalar z1041 = z993 - z1019 * z1037;
    const Scalar z1042 = z1017 * z1020;
    const Scalar z1043 = z991 - z1017 * z1042;
    const Scalar z1044 = z978 - z1018 * z1042;
    const Scalar z1045 = z980 - z1019 * z1042;
    const Scalar z1046 = z1018 * z1020;
    const Scalar z1047 = z974 - z1018 * z1046;
    const Scalar z1048 = z975 - z1019 * z1046;
    const Scalar z1049 = z1031 * z1034;
    const Scalar z1050 = z1032 * z1034;
    const Scalar z1051 = z1033 * z1034;
    const Scalar z1052 = z1038 - z1031 * z1049;
    const Scalar z1053 = z1039 - z1032 * z1049;
    const Scalar z1054 = z1043 - z1032 * z1050;
    const Scalar z1055 = z1044 - z1033 * z1050;
    const Scalar z1056 = n1 / z1052;
    const Scalar z1057 = z1040 - z1033 * z1049;
    const Scalar z1058 = z1047 - z1033 * z1051;
    const Scalar z1059 = z1041 - z1036 * z1049;
    const Scalar z1060 = z916 * z960 + z1037 * z1029 + z1049 * z1035 + z684;
    const Scalar z1061 = z1048 - z1036 * z1051;
    const Scalar z1062 = z1045 - z1036 * z1050;
    const Scalar z1063 = z1019 * z1020;
    const Scalar z1064 = z997 - z1019 * z1063;
    const Scalar z1065 = z822 + z914 * z958;
    const Scalar z1066 = z754 - z914 * z959 + z1027 * z1065;
    const Scalar z1067 = z1053 * z1056;
    const Scalar z1068 = z1057 * z1056;
    const Scalar z1069 = z1036 * z1034;
    const Scalar z1070 = z1064 - z1036 * z1069;
    const Scalar z1071 = z824 + z915 * z958;
    const Scalar z1072 = z1054 - z1053 * z1067;
    const Scalar z1073 = z1055 - z1057 * z1067;
    const Scalar z1074 = z1058 - z1057 * z1068;
    const Scalar z1075 = z1061 - z1059 * z1068;
    const Scalar z1076 = n1 / z1072;
    const Scalar z1077 = z1062 - z1059 * z1067;
    const Scalar z1078 = z814 - z905 * z958;
    const Scalar z1079 = z756 - z915 * z959 + z1027 * z1071;
    const Scalar z1080 = z1037 * z1065 - z914 * z960 - z1049 * z1066 + z674;
    const Scalar z1081 = z743 - z905 * z959 - z1027 * z1078;
    const Scalar z1082 = z676 + z915 * z960 - z1037 * z1071 + z1049 * z1079;
    const Scalar z1083 = z916 * z961 + z1042 * z1029 + z1050 * z1035 - z1067 * z1060 + z643;
    const Scalar z1084 = z1042 * z1065 - z914 * z961 - z1050 * z1066 - z1067 * z1080 + z642;
    const Scalar z1085 = z641 - z915 * z961 + z1042 * z1071 - z1050 * z1079 + z1067 * z1082;
    const Scalar z1086 = z1073 * z1076;
    const Scalar z1087 = z1074 - z1073 * z1086;
    const Scalar z1088 = z1075 - z1077 * z1086;
    const Scalar z1089 = z1068 * z1060 - z916 * z968 - z1046 * z1029 - z1051 * z1035 + z1086 * z1083 + z635;
    const Scalar z1090 = n1 / z1087;
    const Scalar z1091 = z1046 * z1065 - z914 * z968 - z1051 * z1066 - z1068 * z1080 - z1086 * z1084 + z634;
    const Scalar z1092 = z915 * z968 - z1046 * z1071 + z1051 * z1079 - z1068 * z1082 + z1086 * z1085 + z682;
    const Scalar z1093 = z1059 * z1056;
    const Scalar z1094 = z1070 - z1059 * z1093;
    const Scalar z1095 = z663 - z905 * z960 - z1037 * z1078 - z1049 * z1081;
    const Scalar z1096 = z905 * z961 + z1042 * z1078 + z1050 * z1081 + z618 + z1067 * z1095;
    const Scalar z1097 = z656 - z905 * z968 - z1046 * z1078 - z1051 * z1081 - z1068 * z1095 + z1086 * z1096;
    const Scalar z1098 = z1077 * z1076;
    const Scalar z1099 = z1094 - z1077 * z1098;
    const Scalar z1100 = z815 - z904 * z958;
    const Scalar z1101 = z744 - z904 * z959 - z1027 * z1100;
    const Scalar z1102 = z1088 * z1090;
    const Scalar z1103 = z1099 - z1088 * z1102;
    const Scalar z1104 = z1093 * z1060 - z916 * z996 - z1063 * z1029 - z1069 * z1035 + z1098 * z1083 - z1102 * z1089
        + z675;
    const Scalar z1105 = z904 * z960 + z1037 * z1100 + z1049 * z1101 + z664;
    const Scalar z1106 = z904 * z961 + z1042 * z1100 + z1050 * z1101 - z1067 * z1105 + z627;
    const Scalar z1107 = n1 / z1103;
    const Scalar z1108 = z804 - z893 * z958;
    const Scalar z1109 = z1063 * z1065 - z914 * z996 - z1069 * z1066 - z1093 * z1080 - z1098 * z1084 - z1102 * z1091
        + z685;
    const Scalar z1110 = z1068 * z1105 - z904 * z968 - z1046 * z1100 - z1051 * z1101 + z1086 * z1106 + z721;
    const Scalar z1111 = z1063 * z1071 - z915 * z996 - z1069 * z1079 + z1093 * z1082 - z1098 * z1085 + z1102 * z1092
        + z649;
    const Scalar z1112 = z658 + z905 * z996 + z1063 * z1078 + z1069 * z1081 + z1093 * z1095 - z1098 * z1096 + z1102
        * z1097;
    const Scalar z1113 = z904 * z996 + z1063 * z1100 + z1069 * z1101 - z1093 * z1105 - z1098 * z1106 + z1102 * z1110
        + z725;
    const Scalar z1114 = z1107 * z1104;
    const Scalar z1115 = z732 - z893 * z959 - z1027 * z1108;
    const Scalar z1116 = z1107 * z1109;
    const Scalar z1117 = z1107 * z1111;
    const Scalar z1118 = z1107 * z1112;
    const Scalar z1119 = z1107 * z1113;
    const Scalar z1120 = z1090 * z1089 - z1102 * z1114;
    const Scalar z1121 = z893 * z960 + z1037 * z1108 + z1049 * z1115 + z646;
    const Scalar z1122 = z1090 * z1091 - z1102 * z1116;
    const Scalar z1123 = z1090 * z1092 + z1102 * z1117;
    const Scalar z1124 = z1090 * z1097 + z1102 * z1118;
    const Scalar z1125 = z1090 * z1110 + z1102 * z1119;
    const Scalar z1126 = z1076 * z1083 + z1098 * z1114 + z1086 * z1120;
    const Scalar z1127 = z710 - z893 * z961 - z1042 * z1108 - z1050 * z1115 + z1067 * z1121;
    const Scalar z1128 = z1076 * z1084 - z1098 * z1116 - z1086 * z1122;
    const Scalar z1129 = z1076 * z1085 - z1098 * z1117 + z1086 * z1123;
    const Scalar z1130 = z1076 * z1096 - z1098 * z1118 + z1086 * z1124;
    const Scalar z1131 = z1076 * z1106 - z1098 * z1119 + z1086 * z1125;
    const Scalar z1132 = z1056 * z1060 + z1093 * z1114 + z1068 * z1120 - z1067 * z1126;
    const Scalar z1133 = z716 - z893 * z968 - z1046 * z1108 - z1051 * z1115 + z1068 * z1121 - z1086 * z1127;
    const Scalar z1134 = z1056 * z1080 - z1093 * z1116 - z1068 * z1122 - z1067 * z1128;
    const Scalar z1135 = z1056 * z1082 + z1093 * z1117 - z1068 * z1123 + z1067 * z1129;
    const Scalar z1136 = z1056 * z1095 + z1093 * z1118 - z1068 * z1124 + z1067 * z1130;
    const Scalar z1137 = z1056 * z1105 - z1093 * z1119 + z1068 * z1125 - z1067 * z1131;
    const Scalar z1138 = z1034 * z1035 - z1069 * z1114 - z1051 * z1120 + z1050 * z1126 + z1049 * z1132;
    const Scalar z1139 = z724 - z893 * z996 - z1063 * z1108 - z1069 * z1115 + z1093 * z1121 - z1098 * z1127 - z1102
        * z1133;
    const Scalar z1140 = z1034 * z1066 - z1069 * z1116 - z1051 * z1122 - z1050 * z1128 - z1049 * z1134;
    const Scalar z1141 = z1034 * z1079 - z1069 * z1117 + z1051 * z1123 - z1050 * z1129 + z1049 * z1135;
    const Scalar z1142 = z1034 * z1081 + z1069 * z1118 - z1051 * z1124 + z1050 * z1130 - z1049 * z1136;
    const Scalar z1143 = z1034 * z1101 + z1069 * z1119 - z1051 * z1125 + z1050 * z1131 + z1049 * z1137;
    const Scalar z1144 = z1020 * z1029 - z1063 * z1114 - z1046 * z1120 + z1042 * z1126 + z1037 * z1132 - z1027 * z1138;
    const Scalar z1145 = k71 * z916 + z996 * z1114 + z968 * z1120 - z961 * z1126 - z960 * z1132 + z959 * z1138 + z958
        * z1144;
    const Scalar z1146 = z805 + z894 * z958;
    const Scalar z1147 = z733 - z894 * z959 + z1027 * z1146;
    const Scalar z1148 = z1107 * z1139;
    const Scalar z1149 = z1090 * z1133 - z1102 * z1148;
    const Scalar z1150 = z1037 * z1146 - z894 * z960 - z1049 * z1147 + z657;
    const Scalar z1151 = z1076 * z1127 - z1098 * z1148 - z1086 * z1149;
    const Scalar z1152 = z1020 * z1065 + z1063 * z1116 + z1046 * z1122 + z1042 * z1128 + z1037 * z1134 + z1027 * z1140;
    const Scalar z1153 = k71 * z914 + z996 * z1116 + z968 * z1122 + z961 * z1128 + z960 * z1134 + z959 * z1140 - z958
        * z1152;
    const Scalar z1154 = z796 - z883 * z958;
    const Scalar z1155 = z720 + z883 * z959 + z1027 * z1154;
    const Scalar z1156 = z1042 * z1146 - z894 * z961 - z1050 * z1147 - z1067 * z1150 + z706;
    const Scalar z1157 = z759 - z883 * z960 - z1037 * z1154 + z1049 * z1155;
    const Scalar z1158 = z883 * z961 + z1042 * z1154 - z1050 * z1155 + z768 + z1067 * z1157;
    const Scalar z1159 = z1046 * z1146 - z894 * z968 - z1051 * z1147 - z1068 * z1150 - z1086 * z1156 + z782;
    const Scalar z1160 = z883 * z968 + z1046 * z1154 - z1051 * z1155 + z1068 * z1157 - z1086 * z1158 + z773;
    const Scalar z1161 = z1063 * z1146 - z894 * z996 - z1069 * z1147 - z1093 * z1150 - z1098 * z1156 - z1102 * z1159
        + z785;
    const Scalar z1162 = z778 - z883 * z996 - z1063 * z1154 + z1069 * z1155 - z1093 * z1157 + z1098 * z1158 + z1102
        * z1160;
    const Scalar z1163 = z1107 * z1161;
    const Scalar z1164 = z1090 * z1159 - z1102 * z1163;
    const Scalar z1165 = z1056 * z1121 + z1093 * z1148 + z1068 * z1149 + z1067 * z1151;
    const Scalar z1166 = z1076 * z1156 - z1098 * z1163 - z1086 * z1164;
    const Scalar z1167 = z1034 * z1115 - z1069 * z1148 - z1051 * z1149 - z1050 * z1151 + z1049 * z1165;
    const Scalar z1168 = z1056 * z1150 - z1093 * z1163 - z1068 * z1164 - z1067 * z1166;
    const Scalar z1169 = z1034 * z1147 - z1069 * z1163 - z1051 * z1164 - z1050 * z1166 - z1049 * z1168;
    const Scalar z1170 = z1020 * z1071 + z1063 * z1117 - z1046 * z1123 + z1042 * z1129 - z1037 * z1135 + z1027 * z1141;
    const Scalar z1171 = k71 * z915 + z996 * z1117 - z968 * z1123 + z961 * z1129 - z960 * z1135 + z959 * z1141 - z958
        * z1170;
    const Scalar z1172 = z797 - z885 * z958;
    const Scalar z1173 = z728 - z885 * z959 - z1027 * z1172;
    const Scalar z1174 = z1107 * z1162;
    const Scalar z1175 = z1090 * z1160 + z1102 * z1174;
    const Scalar z1176 = z833 + z885 * z960 + z1037 * z1172 + z1049 * z1173;
    const Scalar z1177 = z1076 * z1158 + z1098 * z1174 - z1086 * z1175;
    const Scalar z1178 = z885 * z961 + z1042 * z1172 + z1050 * z1173 + z848 - z1067 * z1176;
    const Scalar z1179 = z1056 * z1157 - z1093 * z1174 + z1068 * z1175 + z1067 * z1177;
    const Scalar z1180 = z885 * z968 + z1046 * z1172 + z1051 * z1173 - z1068 * z1176 + z859 - z1086 * z1178;
    const Scalar z1181 = z885 * z996 + z1063 * z1172 + z1069 * z1173 - z1093 * z1176 - z1098 * z1178 + z862 - z1102
        * z1180;
    const Scalar z1182 = z1034 * z1155 + z1069 * z1174 - z1051 * z1175 - z1050 * z1177 + z1049 * z1179;
    const Scalar z1183 = z1020 * z1078 + z1063 * z1118 - z1046 * z1124 + z1042 * z1130 - z1037 * z1136 - z1027 * z1142;
    const Scalar z1184 = k71 * z905 - z996 * z1118 + z968 * z1124 - z961 * z1130 + z960 * z1136 + z959 * z1142 + z958
        * z1183;
    const Scalar z1185 = z786 - z878 * z958;
    const Scalar z1186 = z821 - z878 * z959 - z1027 * z1185;
    const Scalar z1187 = z1107 * z1181;
    const Scalar z1188 = z1090 * z1180 - z1102 * z1187;
    const Scalar z1189 = z836 - z878 * z960 - z1037 * z1185 - z1049 * z1186;
    const Scalar z1190 = z1076 * z1178 - z1098 * z1187 - z1086 * z1188;
    const Scalar z1191 = z878 * z961 + z1042 * z1185 + z1050 * z1186 + z847 + z1067 * z1189;
    const Scalar z1192 = z1056 * z1176 - z1093 * z1187 - z1068 * z1188 - z1067 * z1190;
    const Scalar z1193 = z878 * z968 + z1046 * z1185 + z1051 * z1186 + z1068 * z1189 + z860 - z1086 * z1191;
    const Scalar z1194 = z861 - z878 * z996 - z1063 * z1185 - z1069 * z1186 - z1093 * z1189 + z1098 * z1191 + z1102
        * z1193;
    const Scalar z1195 = z1034 * z1173 + z1069 * z1187 + z1051 * z1188 + z1050 * z1190 + z1049 * z1192;
    const Scalar z1196 = z1020 * z1100 + z1063 * z1119 - z1046 * z1125 + z1042 * z1131 + z1037 * z1137 - z1027 * z1143;
    const Scalar z1197 = k71 * z904 - z996 * z1119 + z968 * z1125 - z961 * z1131 - z960 * z1137 + z959 * z1143 + z958
        * z1196;
    const Scalar z1198 = z795 - z870 * z958;
    const Scalar z1199 = z895 + z870 * z959 + z1027 * z1198;
    const Scalar z1200 = z1107 * z1194;
    const Scalar z1201 = z1090 * z1193 + z1102 * z1200;
    const Scalar z1202 = z918 - z870 * z960 - z1037 * z1198 + z1049 * z1199;
    const Scalar z1203 = z1076 * z1191 + z1098 * z1200 - z1086 * z1201;
    const Scalar z1204 = z870 * z961 + z1042 * z1198 - z1050 * z1199 + z934 + z1067 * z1202;
    const Scalar z1205 = z1056 * z1189 - z1093 * z1200 + z1068 * z1201 + z1067 * z1203;
    const Scalar z1206 = z945 + z870 * z968 + z1046 * z1198 - z1051 * z1199 + z1068 * z1202 - z1086 * z1204;
    const Scalar z1207 = z947 - z870 * z996 - z1063 * z1198 + z1069 * z1199 - z1093 * z1202 + z1098 * z1204 + z1102
        * z1206;
    const Scalar z1208 = z1034 * z1186 - z1069 * z1200 + z1051 * z1201 + z1050 * z1203 - z1049 * z1205;
    const Scalar z1209 = z1020 * z1108 - z1063 * z1148 - z1046 * z1149 - z1042 * z1151 + z1037 * z1165 - z1027 * z1167;
    const Scalar z1210 = k71 * z893 + z996 * z1148 + z968 * z1149 + z961 * z1151 - z960 * z1165 + z959 * z1167 + z958
        * z1209;
    const Scalar z1211 = z863 * z958 - z924;
    const Scalar z1212 = z863 * z959 + z932 - z1027 * z1211;
    const Scalar z1213 = z1107 * z1207;
    const Scalar z1214 = z1090 * z1206 + z1102 * z1213;
    const Scalar z1215 = z863 * z960 + z946 - z1037 * z1211 - z1049 * z1212;
    const Scalar z1216 = z1076 * z1204 + z1098 * z1213 - z1086 * z1214;
    const Scalar z1217 = z863 * z961 + z994 - z1042 * z1211 - z1050 * z1212 - z1067 * z1215;
    const Scalar z1218 = z863 * z968 + z1008 - z1046 * z1211 - z1051 * z1212 - z1068 * z1215 - z1086 * z1217;
    const Scalar z1219 = z863 * z996 + z1013 - z1063 * z1211 - z1069 * z1212 - z1093 * z1215 - z1098 * z1217 - z1102
        * z1218;
    const Scalar z1220 = z1056 * z1202 - z1093 * z1213 + z1068 * z1214 + z1067 * z1216;
    const Scalar z1221 = z1034 * z1199 + z1069 * z1213 - z1051 * z1214 - z1050 * z1216 + z1049 * z1220;
    const Scalar z1222 = z1020 * z1146 + z1063 * z1163 + z1046 * z1164 + z1042 * z1166 + z1037 * z1168 + z1027 * z1169;
    const Scalar z1223 = k71 * z894 + z996 * z1163 + z968 * z1164 + z961 * z1166 + z960 * z1168 + z959 * z1169 - z958
        * z1222;
    const Scalar z1224 = z874 * z958 - z964;
    const Scalar z1225 = z874 * z959 + z970 - z1027 * z1224;
    const Scalar z1226 = z1107 * z1219;
    const Scalar z1227 = z1090 * z1218 - z1102 * z1226;
    const Scalar z1228 = z874 * z960 - z983 - z1037 * z1224 - z1049 * z1225;
    const Scalar z1229 = z1076 * z1217 - z1098 * z1226 - z1086 * z1227;
    const Scalar z1230 = z874 * z961 + z1000 - z1042 * z1224 - z1050 * z1225 - z1067 * z1228;
    const Scalar z1231 = z874 * z968 + z1026 - z1046 * z1224 - z1051 * z1225 - z1068 * z1228 - z1086 * z1230;
    const Scalar z1232 = z874 * z996 - z1028 - z1063 * z1224 - z1069 * z1225 - z1093 * z1228 - z1098 * z1230 - z1102
        * z1231;
    const Scalar z1233 = z1056 * z1215 - z1093 * z1226 - z1068 * z1227 - z1067 * z1229;
    const Scalar z1234 = z1034 * z1212 - z1069 * z1226 - z1051 * z1227 - z1050 * z1229 - z1049 * z1233;
    const Scalar z1235 = z1020 * z1154 - z1063 * z1174 + z1046 * z1175 + z1042 * z1177 - z1037 * z1179 + z1027 * z1182;
    const Scalar z1236 = k71 * z883 + z996 * z1174 - z968 * z1175 - z961 * z1177 + z960 * z1179 - z959 * z1182 + z958
        * z1235;
    const Scalar z1237 = z1107 * z1232;
    const Scalar z1238 = z1090 * z1231 - z1102 * z1237;
    const Scalar z1239 = z1020 * z1172 + z1063 * z1187 + z1046 * z1188 + z1042 * z1190 + z1037 * z1192 - z1027 * z1195;
    const Scalar z1240 = k71 * z885 - z996 * z1187 - z968 * z1188 - z961 * z1190 - z960 * z1192 + z959 * z1195 + z958
        * z1239;
    const Scalar z1241 = z1076 * z1230 - z1098 * z1237 - z1086 * z1238;
    const Scalar z1242 = z1056 * z1228 - z1093 * z1237 - z1068 * z1238 - z1067 * z1241;
    const Scalar z1243 = z1020 * z1185 - z1063 * z1200 + z1046 * z1201 + z1042 * z1203 - z1037 * z1205 - z1027 * z1208;
    const Scalar z1244 = k71 * z878 + z996 * z1200 - z968 * z1201 - z961 * z1203 + z960 * z1205 + z959 * z1208 + z958
        * z1243;
    const Scalar z1245 = z1034 * z1225 - z1069 * z1237 - z1051 * z1238 - z1050 * z1241 - z1049 * z1242;
    const Scalar z1246 = z1020 * z1198 - z1063 * z1213 + z1046 * z1214 + z1042 * z1216 - z1037 * z1220 + z1027 * z1221;
    const Scalar z1247 = k71 * z870 + z996 * z1213 - z968 * z1214 - z961 * z1216 + z960 * z1220 - z959 * z1221 + z958
        * z1246;
    const Scalar z1248 = z1020 * z1211 - z1063 * z1226 - z1046 * z1227 - z1042 * z1229 - z1037 * z1233 - z1027 * z1234;
    const Scalar z1249 = k71 * z863 - z996 * z1226 - z968 * z1227 - z961 * z1229 - z960 * z1233 - z959 * z1234 - z958
        * z1248;
    const Scalar z1250 = z1020 * z1224 - z1063 * z1237 - z1046 * z1238 - z1042 * z1241 - z1037 * z1242 - z1027 * z1245;
    const Scalar z1251 = k71 * z874 - z996 * z1237 - z968 * z1238 - z961 * z1241 - z960 * z1242 - z959 * z1245 - z958
        * z1250;
    const Scalar z1252 = z959 - z958 * z1027;
    const Scalar z1253 = z1037 - z1027 * z1049;
    const Scalar z1254 = z960 - z958 * z1037 - z1049 * z1252;
    const Scalar z1255 = z1050 - z1049 * z1067;
    const Scalar z1256 = z1042 - z1027 * z1050 - z1067 * z1253;
    const Scalar z1257 = z961 - z958 * z1042 - z1050 * z1252 - z1067 * z1254;
    const Scalar z1258 = z1068 - z1067 * z1086;
    const Scalar z1259 = z1051 - z1049 * z1068 - z1086 * z1255;
    const Scalar z1260 = z1046 - z1027 * z1051 - z1068 * z1253 - z1086 * z1256;
    const Scalar z1261 = z968 - z958 * z1046 - z1051 * z1252 - z1068 * z1254 - z1086 * z1257;
    const Scalar z1262 = z1098 - z1086 * z1102;
    const Scalar z1263 = z1107 * z1262;
    const Scalar z1264 = z1093 - z1067 * z1098 - z1102 * z1258;
    const Scalar z1265 = z1107 * z1264;
    const Scalar z1266 = z1069 - z1049 * z1093 - z1098 * z1255 - z1102 * z1259;
    const Scalar z1267 = z1107 * z1266;
    const Scalar z1268 = z1090 * z1258 - z1102 * z1265;
    const Scalar z1269 = z1063 - z1027 * z1069 - z1093 * z1253 - z1098 * z1256 - z1102 * z1260;
    const Scalar z1270 = z1107 * z1269;
    const Scalar z1271 = z1090 * z1259 - z1102 * z1267;
    const Scalar z1272 = z1076 * z1255 - z1098 * z1267 - z1086 * z1271;
    const Scalar z1273 = z1090 * z1260 - z1102 * z1270;
    const Scalar z1274 = z996 - z958 * z1063 - z1069 * z1252 - z1093 * z1254 - z1098 * z1257 - z1102 * z1261;
    const Scalar z1275 = z1107 * z1274;
    const Scalar z1276 = z1076 * z1256 - z1098 * z1270 - z1086 * z1273;
    const Scalar z1277 = z1090 * z1261 - z1102 * z1275;
    const Scalar z1278 = z1056 * z1253 - z1093 * z1270 - z1068 * z1273 - z1067 * z1276;
    const Scalar z1279 = z1076 * z1257 - z1098 * z1275 - z1086 * z1277;
    const Scalar z1280 = z1102 * z1107;
    const Scalar z1281 = z1056 * z1254 - z1093 * z1275 - z1068 * z1277 - z1067 * z1279;
    const Scalar z1282 = z1090 + z1102 * z1280;
    const Scalar z1283 = z1086 * z1090 - z1102 * z1263;
    const Scalar z1284 = z1034 * z1252 - z1069 * z1275 - z1051 * z1277 - z1050 * z1279 - z1049 * z1281;
    const Scalar z1285 = z1098 * z1107 - z1086 * z1280;
    const Scalar z1286 = z1098 * z1280 - z1086 * z1282;
    const Scalar z1287 = z1076 + z1098 * z1263 + z1086 * z1283;
    const Scalar z1288 = z1067 * z1076 - z1098 * z1265 - z1086 * z1268;
    const Scalar z1289 = z1093 * z1107 - z1068 * z1280 - z1067 * z1285;
    const Scalar z1290 = z1093 * z1280 - z1068 * z1282 - z1067 * z1286;
    const Scalar z1291 = z1093 * z1263 + z1068 * z1283 - z1067 * z1287;
    const Scalar z1292 = z1056 + z1093 * z1265 + z1068 * z1268 + z1067 * z1288;
    const Scalar z1293 = z1049 * z1056 - z1093 * z1267 - z1068 * z1271 - z1067 * z1272;
    const Scalar z1294 = z1069 * z1107 - z1051 * z1280 - z1050 * z1285 - z1049 * z1289;
    const Scalar z1295 = z1069 * z1280 - z1051 * z1282 - z1050 * z1286 - z1049 * z1290;
    const Scalar z1296 = z1069 * z1263 + z1051 * z1283 - z1050 * z1287 - z1049 * z1291;
    const Scalar z1297 = z1069 * z1265 + z1051 * z1268 + z1050 * z1288 - z1049 * z1292;
    const Scalar z1298 = z1034 + z1069 * z1267 + z1051 * z1271 + z1050 * z1272 + z1049 * z1293;
    const Scalar z1299 = z1027 * z1034 - z1069 * z1270 - z1051 * z1273 - z1050 * z1276 - z1049 * z1278;
    const Scalar z1300 = z1063 * z1107 - z1046 * z1280 - z1042 * z1285 - z1037 * z1289 - z1027 * z1294;
    const Scalar z1301 = z996 * z1107 - z968 * z1280 - z961 * z1285 - z960 * z1289 - z959 * z1294 - z958 * z1300;
    const Scalar z1302 = z1063 * z1280 - z1046 * z1282 - z1042 * z1286 - z1037 * z1290 - z1027 * z1295;
    const Scalar z1303 = z996 * z1280 - z968 * z1282 - z961 * z1286 - z960 * z1290 - z959 * z1295 - z958 * z1302;
    const Scalar z1304 = z1063 * z1263 + z1046 * z1283 - z1042 * z1287 - z1037 * z1291 - z1027 * z1296;
    const Scalar z1305 = z996 * z1263 + z968 * z1283 - z961 * z1287 - z960 * z1291 - z959 * z1296 - z958 * z1304;
    const Scalar z1306 = z1063 * z1265 + z1046 * z1268 + z1042 * z1288 - z1037 * z1292 - z1027 * z1297;
    const Scalar z1307 = z996 * z1265 + z968 * z1268 + z961 * z1288 - z960 * z1292 - z959 * z1297 - z958 * z1306;
    const Scalar z1308 = z1063 * z1267 + z1046 * z1271 + z1042 * z1272 + z1037 * z1293 - z1027 * z1298;
    const Scalar z1309 = z996 * z1267 + z968 * z1271 + z961 * z1272 + z960 * z1293 - z959 * z1298 - z958 * z1308;
    const Scalar z1310 = z1020 + z1063 * z1270 + z1046 * z1273 + z1042 * z1276 + z1037 * z1278 + z1027 * z1299;
    const Scalar z1311 = z996 * z1270 + z968 * z1273 + z961 * z1276 + z960 * z1278 + z959 * z1299 - z958 * z1310;
    const Scalar z1312 = z958 * z1020 - z1063 * z1275 - z1046 * z1277 - z1042 * z1279 - z1037 * z1281 - z1027 * z1284;
    const Scalar z1313 = k71 - z996 * z1275 - z968 * z1277 - z961 * z1279 - z960 * z1281 - z959 * z1284 - z958 * z1312;
    result.M[0] = z441;
    result.M[1] = -z445;
    result.M[2] = -z431;
    result.M[3] = z403;
    result.M[4] = z381;
    result.M[5] = -z348;
    result.M[6] = z256;
    result.M[7] = -z445;
    result.M[8] = z402;
    result.M[9] = -z377;
    result.M[10] = z363;
    result.M[11] = z336;
    result.M[12] = z333;
    result.M[13] = z242;
    result.M[14] = -z431;
    result.M[15] = -z377;
    result.M[16] = z372;
    result.M[17] = z342;
    result.M[18] = -z326;
    result.M[19] = -z282;
    result.M[20] = -z222;
    result.M[21] = z403;
    result.M[22] = z363;
    result.M[23] = z342;
    result.M[24] = z329;
    result.M[25] = -z310;
    result.M[26] = -z273;
    result.M[27] = z211;
    result.M[28] = z381;
    result.M[29] = z336;
    result.M[30] = -z326;
    result.M[31] = -z310;
    result.M[32] = z303;
    result.M[33] = -z267;
    result.M[34] = z191;
    result.M[35] = -z348;
    result.M[36] = z333;
    result.M[37] = -z282;
    result.M[38] = -z273;
    result.M[39] = -z267;
    result.M[40] = z255;
    result.M[41] = -z189;
    result.M[42] = z256;
    result.M[43] = z242;
    result.M[44] = -z222;
    result.M[45] = z211;
    result.M[46] = z191;
    result.M[47] = -z189;
    result.M[48] = k10;
    result.C[0] = -z675;
    result.C[1] = -z635;
    result.C[2] = -z643;
    result.C[3] = z684;
    result.C[4] = -z755;
    result.C[5] = z823;
    result.C[6] = -z916;
    result.C[7] = z649;
    result.C[8] = -z682;
    result.C[9] = -z641;
    result.C[10] = -z676;
    result.C[11] = z756;
    result.C[12] = z824;
    result.C[13] = z915;
    result.C[14] = z725;
    result.C[15] = -z721;
    result.C[16] = -z627;
    result.C[17] = z664;
    result.C[18] = -z744;
    result.C[19] = z815;
    result.C[20] = -z904;
    result.C[21] = -z785;
    result.C[22] = -z782;
    result.C[23] = z706;
    result.C[24] = -z657;
    result.C[25] = -z733;
    result.C[26] = -z805;
    result.C[27] = -z894;
    result.C[28] = -z862;
    result.C[29] = -z859;
    result.C[30] = z848;
    result.C[31] = -z833;
    result.C[32] = z728;
    result.C[33] = -z797;
    result.C[34] = z885;
    result.C[35] = z947;
    result.C[36] = -z945;
    result.C[37] = z934;
    result.C[38] = z918;
    result.C[39] = -z895;
    result.C[40] = -z795;
    result.C[41] = z870;
    result.C[42] = z1028;
    result.C[43] = -z1026;
    result.C[44] = z1000;
    result.C[45] = z983;
    result.C[46] = -z970;
    result.C[47] = -z964;
    result.C[48] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = z685;
    result.K[8] = z634;
    result.K[9] = -z642;
    result.K[10] = z674;
    result.K[11] = z754;
    result.K[12] = z822;
    result.K[13] = z914;
    result.K[14] = -z658;
    result.K[15] = z656;
    result.K[16] = z618;
    result.K[17] = z663;
    result.K[18] = z743;
    result.K[19] = -z814;
    result.K[20] = z905;
    result.K[21] = -z724;
    result.K[22] = -z716;
    result.K[23] = z710;
    result.K[24] = z646;
    result.K[25] = -z732;
    result.K[26] = z804;
    result.K[27] = -z893;
    result.K[28] = -z778;
    result.K[29] = z773;
    result.K[30] = -z768;
    result.K[31] = -z759;
    result.K[32] = z720;
    result.K[33] = z796;
    result.K[34] = -z883;
    result.K[35] = -z861;
    result.K[36] = z860;
    result.K[37] = -z847;
    result.K[38] = -z836;
    result.K[39] = -z821;
    result.K[40] = z786;
    result.K[41] = -z878;
    result.K[42] = -z1013;
    result.K[43] = -z1008;
    result.K[44] = z994;
    result.K[45] = -z946;
    result.K[46] = -z932;
    result.K[47] = -z924;
    result.K[48] = z863;
    result.F[0] = z949;
    result.F[1] = z950;
    result.F[2] = z951;
    result.F[3] = z952;
    result.F[4] = z953;
    result.F[5] = z954;
    result.F[6] = z955;
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
    result.A[21] = z1116;
    result.A[22] = z1122;
    result.A[23] = -z1128;
    result.A[24] = z1134;
    result.A[25] = z1140;
    result.A[26] = z1152;
    result.A[27] = -z1153;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = -z1118;
    result.A[36] = z1124;
    result.A[37] = z1130;
    result.A[38] = z1136;
    result.A[39] = z1142;
    result.A[40] = -z1183;
    result.A[41] = -z1184;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = -z1148;
    result.A[50] = -z1149;
    result.A[51] = z1151;
    result.A[52] = z1165;
    result.A[53] = -z1167;
    result.A[54] = z1209;
    result.A[55] = z1210;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = -z1174;
    result.A[64] = z1175;
    result.A[65] = -z1177;
    result.A[66] = -z1179;
    result.A[67] = z1182;
    result.A[68] = z1235;
    result.A[69] = z1236;
    result.A[70] = n0;
    result.A[71] = n0;
    result.A[72] = n0;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z1200;
    result.A[78] = z1201;
    result.A[79] = -z1203;
    result.A[80] = -z1205;
    result.A[81] = -z1208;
    result.A[82] = z1243;
    result.A[83] = z1244;
    result.A[84] = n0;
    result.A[85] = n0;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = n0;
    result.A[91] = -z1226;
    result.A[92] = -z1227;
    result.A[93] = z1229;
    result.A[94] = -z1233;
    result.A[95] = -z1234;
    result.A[96] = z1248;
    result.A[97] = -z1249;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = n0;
    result.A[103] = n0;
    result.A[104] = n0;
    result.A[105] = -z1114;
    result.A[106] = -z1120;
    result.A[107] = -z1126;
    result.A[108] = z1132;
    result.A[109] = -z1138;
    result.A[110] = z1144;
    result.A[111] = z1145;
    result.A[112] = n0;
    result.A[113] = n1;
    result.A[114] = n0;
    result.A[115] = n0;
    result.A[116] = n0;
    result.A[117] = n0;
    result.A[118] = n0;
    result.A[119] = z1117;
    result.A[120] = -z1123;
    result.A[121] = -z1129;
    result.A[122] = -z1135;
    result.A[123] = z1141;
    result.A[124] = z1170;
    result.A[125] = -z1171;
    result.A[126] = n0;
    result.A[127] = n0;
    result.A[128] = n1;
    result.A[129] = n0;
    result.A[130] = n0;
    result.A[131] = n0;
    result.A[132] = n0;
    result.A[133] = z1119;
    result.A[134] = -z1125;
    result.A[135] = -z1131;
    result.A[136] = z1137;
    result.A[137] = -z1143;
    result.A[138] = z1196;
    result.A[139] = z1197;
    result.A[140] = n0;
    result.A[141] = n0;
    result.A[142] = n0;
    result.A[143] = n1;
    result.A[144] = n0;
    result.A[145] = n0;
    result.A[146] = n0;
    result.A[147] = -z1163;
    result.A[148] = -z1164;
    result.A[149] = z1166;
    result.A[150] = -z1168;
    result.A[151] = -z1169;
    result.A[152] = -z1222;
    result.A[153] = z1223;
    result.A[154] = n0;
    result.A[155] = n0;
    result.A[156] = n0;
    result.A[157] = n0;
    result.A[158] = n1;
    result.A[159] = n0;
    result.A[160] = n0;
    result.A[161] = -z1187;
    result.A[162] = -z1188;
    result.A[163] = z1190;
    result.A[164] = -z1192;
    result.A[165] = z1195;
    result.A[166] = -z1239;
    result.A[167] = -z1240;
    result.A[168] = n0;
    result.A[169] = n0;
    result.A[170] = n0;
    result.A[171] = n0;
    result.A[172] = n0;
    result.A[173] = n1;
    result.A[174] = n0;
    result.A[175] = z1213;
    result.A[176] = -z1214;
    result.A[177] = z1216;
    result.A[178] = z1220;
    result.A[179] = -z1221;
    result.A[180] = -z1246;
    result.A[181] = -z1247;
    result.A[182] = n0;
    result.A[183] = n0;
    result.A[184] = n0;
    result.A[185] = n0;
    result.A[186] = n0;
    result.A[187] = n0;
    result.A[188] = n1;
    result.A[189] = -z1237;
    result.A[190] = -z1238;
    result.A[191] = z1241;
    result.A[192] = -z1242;
    result.A[193] = -z1245;
    result.A[194] = z1250;
    result.A[195] = -z1251;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n0;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = -z1107;
    result.B[8] = z1280;
    result.B[9] = -z1285;
    result.B[10] = z1289;
    result.B[11] = z1294;
    result.B[12] = -z1300;
    result.B[13] = z1301;
    result.B[14] = n0;
    result.B[15] = n0;
    result.B[16] = n0;
    result.B[17] = n0;
    result.B[18] = n0;
    result.B[19] = n0;
    result.B[20] = n0;
    result.B[21] = z1280;
    result.B[22] = -z1282;
    result.B[23] = z1286;
    result.B[24] = -z1290;
    result.B[25] = -z1295;
    result.B[26] = z1302;
    result.B[27] = -z1303;
    result.B[28] = n0;
    result.B[29] = n0;
    result.B[30] = n0;
    result.B[31] = n0;
    result.B[32] = n0;
    result.B[33] = n0;
    result.B[34] = n0;
    result.B[35] = -z1263;
    result.B[36] = -z1283;
    result.B[37] = -z1287;
    result.B[38] = z1291;
    result.B[39] = z1296;
    result.B[40] = -z1304;
    result.B[41] = z1305;
    result.B[42] = n0;
    result.B[43] = n0;
    result.B[44] = n0;
    result.B[45] = n0;
    result.B[46] = n0;
    result.B[47] = n0;
    result.B[48] = n0;
    result.B[49] = z1265;
    result.B[50] = z1268;
    result.B[51] = -z1288;
    result.B[52] = -z1292;
    result.B[53] = -z1297;
    result.B[54] = z1306;
    result.B[55] = -z1307;
    result.B[56] = n0;
    result.B[57] = n0;
    result.B[58] = n0;
    result.B[59] = n0;
    result.B[60] = n0;
    result.B[61] = n0;
    result.B[62] = n0;
    result.B[63] = z1267;
    result.B[64] = z1271;
    result.B[65] = -z1272;
    result.B[66] = z1293;
    result.B[67] = -z1298;
    result.B[68] = z1308;
    result.B[69] = -z1309;
    result.B[70] = n0;
    result.B[71] = n0;
    result.B[72] = n0;
    result.B[73] = n0;
    result.B[74] = n0;
    result.B[75] = n0;
    result.B[76] = n0;
    result.B[77] = -z1270;
    result.B[78] = -z1273;
    result.B[79] = z1276;
    result.B[80] = -z1278;
    result.B[81] = -z1299;
    result.B[82] = -z1310;
    result.B[83] = z1311;
    result.B[84] = n0;
    result.B[85] = n0;
    result.B[86] = n0;
    result.B[87] = n0;
    result.B[88] = n0;
    result.B[89] = n0;
    result.B[90] = n0;
    result.B[91] = z1275;
    result.B[92] = z1277;
    result.B[93] = -z1279;
    result.B[94] = z1281;
    result.B[95] = z1284;
    result.B[96] = -z1312;
    result.B[97] = z1313;
    if (!(traits::regular(-z1103, z441) && traits::regular(-z1087, z402) && traits::regular(-z1072, z372)
        && traits::regular(-z1052, z329) && traits::regular(-z1030, z303) && traits::regular(-z1014,
        z255))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (((((n0 * result.M[0] * result.M[1] * result.M[2] * result.M[3] * result.M[4] * result.M[5]
        * result.M[6] * result.M[7]) * (n0 * result.M[8] * result.M[9] * result.M[10] * result.M[11] * result.M[12]
        * result.M[13] * result.M[14] * result.M[15] * result.M[16])) * ((n0 * result.M[17] * result.M[18]
        * result.M[19] * result.M[20] * result.M[21] * result.M[22] * result.M[23] * result.M[24] * result.M[25]) * (n0
        * result.M[26] * result.M[27] * result.M[28] * result.M[29] * result.M[30] * result.M[31] * result.M[32]
        * result.M[33] * result.M[34]))) * (((n0 * result.M[35] * result.M[36] * result.M[37] * result.M[38]
        * result.M[39] * result.M[40] * result.M[41] * result.M[42] * result.M[43]) * (n0 * result.M[44] * result.M[45]
        * result.M[46] * result.M[47] * result.C[0] * result.C[1] * result.C[2] * result.C[3] * result.C[4])) * ((n0
        * result.C[5] * result.C[6] * result.C[7] * result.C[8] * result.C[9] * result.C[10] * result.C[11]
        * result.C[12] * result.C[13]) * (n0 * result.C[14] * result.C[15] * result.C[16] * result.C[17] * result.C[18]
        * result.C[19] * result.C[20] * result.C[21] * result.C[22])))) * ((((n0 * result.C[23] * result.C[24]
        * result.C[25] * result.C[26] * result.C[27] * result.C[28] * result.C[29] * result.C[30]) * (n0 * result.C[31]
        * result.C[32] * result.C[33] * result.C[34] * result.C[35] * result.C[36] * result.C[37] * result.C[38]
        * result.C[39])) * ((n0 * result.C[40] * result.C[41] * result.C[42] * result.C[43] * result.C[44]
        * result.C[45] * result.C[46] * result.C[47] * result.K[7]) * (n0 * result.K[8] * result.K[9] * result.K[10]
        * result.K[11] * result.K[12] * result.K[13] * result.K[14] * result.K[15] * result.K[16]))) * (((n0
        * result.K[17] * result.K[18] * result.K[19] * result.K[20] * result.K[21] * result.K[22] * result.K[23]
        * result.K[24] * result.K[25]) * (n0 * result.K[26] * result.K[27] * result.K[28] * result.K[29] * result.K[30]
        * result.K[31] * result.K[32] * result.K[33] * result.K[34])) * ((n0 * result.K[35] * result.K[36]
        * result.K[37] * result.K[38] * result.K[39] * result.K[40] * result.K[41] * result.K[42] * result.K[43]) * (n0
        * result.K[44] * result.K[45] * result.K[46] * result.K[47] * result.K[48] * result.F[0] * result.F[1]
        * result.F[2] * result.F[3]))))) * (((((n0 * result.F[4] * result.F[5] * result.F[6] * result.A[21]
        * result.A[22] * result.A[23] * result.A[24] * result.A[25]) * (n0 * result.A[26] * result.A[27] * result.A[35]
        * result.A[36] * result.A[37] * result.A[38] * result.A[39] * result.A[40] * result.A[41])) * ((n0
        * result.A[49] * result.A[50] * result.A[51] * result.A[52] * result.A[53] * result.A[54] * result.A[55]
        * result.A[63] * result.A[64]) * (n0 * result.A[65] * result.A[66] * result.A[67] * result.A[68] * result.A[69]
        * result.A[77] * result.A[78] * result.A[79] * result.A[80]))) * (((n0 * result.A[81] * result.A[82]
        * result.A[83] * result.A[91] * result.A[92] * result.A[93] * result.A[94] * result.A[95] * result.A[96]) * (n0
        * result.A[97] * result.A[105] * result.A[106] * result.A[107] * result.A[108] * result.A[109] * result.A[110]
        * result.A[111] * result.A[119])) * ((n0 * result.A[120] * result.A[121] * result.A[122] * result.A[123]
        * result.A[124] * result.A[125] * result.A[133] * result.A[134] * result.A[135]) * (n0 * result.A[136]
        * result.A[137] * result.A[138] * result.A[139] * result.A[147] * result.A[148] * result.A[149] * result.A[150]
        * result.A[151])))) * ((((n0 * result.A[152] * result.A[153] * result.A[161] * result.A[162] * result.A[163]
        * result.A[164] * result.A[165] * result.A[166] * result.A[167]) * (n0 * result.A[175] * result.A[176]
        * result.A[177] * result.A[178] * result.A[179] * result.A[180] * result.A[181] * result.A[189]
        * result.A[190])) * ((n0 * result.A[191] * result.A[192] * result.A[193] * result.A[194] * result.A[195]
        * result.B[7] * result.B[8] * result.B[9] * result.B[10]) * (n0 * result.B[11] * result.B[12] * result.B[13]
        * result.B[21] * result.B[22] * result.B[23] * result.B[24] * result.B[25] * result.B[26]))) * (((n0
        * result.B[27] * result.B[35] * result.B[36] * result.B[37] * result.B[38] * result.B[39] * result.B[40]
        * result.B[41] * result.B[49]) * (n0 * result.B[50] * result.B[51] * result.B[52] * result.B[53] * result.B[54]
        * result.B[55] * result.B[63] * result.B[64] * result.B[65])) * ((n0 * result.B[66] * result.B[67]
        * result.B[68] * result.B[69] * result.B[77] * result.B[78] * result.B[79] * result.B[80] * result.B[81]) * (n0
        * result.B[82] * result.B[83] * result.B[91] * result.B[92] * result.B[93] * result.B[94] * result.B[95]
        * result.B[96] * result.B[97])))));
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 49>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace arm7
