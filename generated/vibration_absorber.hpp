// SPDX-License-Identifier: MIT-0
// vibration_absorber: Vibration absorber: unbalanced machine on a spring, with a pendulum
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: d, omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                0                6          1             0                  0       0      7       -
//   kinematics                4               10          0             0                  2       0     18      19
//   mass_matrix               0                1          0             0                  1       0      3       4
//   bias                      3                8          0             0                  2       0     15      17
//   inverse_dynamics          7               13          0             0                  2       0     24      27
//   forward_dynamics          6               15          1             0                  2       0     26      30
//   energy                   13               25          0             0                  2       0     42      50
//   linearisation            12               32          1             0                  2       0     49      53
//
// Not computed because this mechanism does not need it:
//   kinematics: of 66 results 38 vanish identically, 6 repeat another up to sign
//   mass_matrix: of 4 results 1 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   first_integrals: left out, T depends on time explicitly; the force function U depends on time explicitly
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 30 results 12 vanish identically, 1 repeat another up to sign
//
// To write this file again:
//   vibration_absorber_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output vibration_absorber.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace vibration_absorber {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"X", "m"}, {"theta", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"X", "m/s"}, {"theta", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"d", "m"}, {"omega", "rad/s"}}};
  static constexpr std::array<torsor::ResultDescription, 28> results{{{"result", "support_position", 3, 1, 1, "m"},
      {"result", "support_rotation", 3, 3, 2, "1"}, {"result", "support_velocity", 3, 1, 1, "m/s"}, {"result",
      "support_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "pendulum_position", 3, 1, 1, "m"}, {"result",
      "pendulum_rotation", 3, 3, 2, "1"}, {"result", "pendulum_velocity", 3, 1, 1, "m/s"}, {"result",
      "pendulum_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "unbalance_position", 3, 1, 1, "m"}, {"result",
      "unbalance_rotation", 3, 3, 2, "1"}, {"result", "unbalance_velocity", 3, 1, 1, "m/s"}, {"result",
      "unbalance_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "G1_position", 3, 1, 1, "m"}, {"result",
      "G1_velocity", 3, 1, 1, "m/s"}, {"result", "G1_jacobian", 3, 2, 2, "1"}, {"mass", "", 2, 2, 2, ""}, {"forces", "",
      2, 1, 1, "N, N m"}, {"forces", "", 2, 1, 1, "N, N m"}, {"accelerations", "", 2, 1, 1, "m/s^2, rad/s^2"},
      {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"},
      {"result", "power", 1, 1, 0, "W"}, {"result", "M", 2, 2, 2, ""}, {"result", "C", 2, 2, 2, "N s"}, {"result", "K",
      2, 2, 2, ""}, {"result", "F", 2, 1, 1, "N, N m"}, {"result", "A", 4, 4, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 15}, {"mass_matrix", false, false, false, false, results.data() + 15, 1}, {"bias", false,
      false, false, false, results.data() + 16, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 17,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 18, 2}, {"energy", false, false, true, false,
      results.data() + 20, 3}, {"linearisation", true, true, true, true, results.data() + 23, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::vibration_absorber::Description;

  static constexpr const char* name = "vibration_absorber";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x001755afff0fad15ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar d;  ///< parameter [m]
    Scalar omega;  ///< parameter [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::d, &Parameters::omega};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar X;  ///< coordinate [m]
    Scalar theta;  ///< coordinate [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::X, &Coordinates::theta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar X;  ///< its rate [m/s]
    Scalar theta;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::X, &Velocities::theta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar X;  ///< its second rate [m/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::X, &Accelerations::theta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar X;  ///< works with the rate of X [N]
    Scalar theta;  ///< works with the rate of theta [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::X, &GeneralizedForces::theta};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

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
    Scalar m_d35bb54c;
    Scalar m_c10e5f00;
    Scalar m_53d108b6;  ///< force on rotor, z
    Scalar m_248a3b97;
    Scalar m_ba725c70;
    Scalar m_a124f2ef;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_0981 = traits::constant(0.0981, 0.0981f, "981/10000");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    parameters.d = n0_0981;
    parameters.omega = n10;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k3 = traits::constant(4e-05, 4e-05f, "1/25000");
    const Scalar p_omega = parameters.omega;
    const Scalar p_d = parameters.d;
    const Scalar z0 = n0_02 * p_omega;
    const Scalar z1 = p_d * p_d;
    const Scalar z2 = p_omega * p_omega;
    const Scalar z3 = n0_002 * z2;  // force on rotor, z
    const Scalar z4 = n1 / z1;
    const Scalar z5 = k3 * p_omega;
    const Scalar z6 = n0_002 * p_omega;
    precomputed.m_d35bb54c = z0;
    precomputed.m_c10e5f00 = z1;
    precomputed.m_53d108b6 = z3;
    precomputed.m_248a3b97 = z4;
    precomputed.m_ba725c70 = z5;
    precomputed.m_a124f2ef = z6;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_11 = traits::constant(0.11, 0.11f, "11/100");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    state.time = n0;
    state.q.X = n0_11;
    state.q.theta = n0_3;
    state.v.X = n0;
    state.v.theta = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> support_position;  ///< centre of mass of support [m]
    std::array<Scalar, 9> support_rotation;  ///< from the axes of support to the ground's (3 x 3)
    std::array<Scalar, 3> support_velocity;  ///< velocity of the centre of mass of support [m/s]
    std::array<Scalar, 3> support_angular_velocity;  ///< angular velocity of support [rad/s]
    std::array<Scalar, 3> pendulum_position;  ///< centre of mass of pendulum [m]
    std::array<Scalar, 9> pendulum_rotation;  ///< from the axes of pendulum to the ground's (3 x 3)
    std::array<Scalar, 3> pendulum_velocity;  ///< velocity of the centre of mass of pendulum [m/s]
    std::array<Scalar, 3> pendulum_angular_velocity;  ///< angular velocity of pendulum [rad/s]
    std::array<Scalar, 3> unbalance_position;  ///< centre of mass of unbalance [m]
    std::array<Scalar, 9> unbalance_rotation;  ///< from the axes of unbalance to the ground's (3 x 3)
    std::array<Scalar, 3> unbalance_velocity;  ///< velocity of the centre of mass of unbalance [m/s]
    std::array<Scalar, 3> unbalance_angular_velocity;  ///< angular velocity of unbalance [rad/s]
    std::array<Scalar, 3> G1_position;  ///< position of G1 [m]
    std::array<Scalar, 3> G1_velocity;  ///< velocity of the material point at G1 [m/s]
    std::array<Scalar, 6> G1_jacobian;  ///< partial velocities of G1 (3 x 2)
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
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_X = state.q.X;
    const Scalar v_X = state.v.X;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_d = precomputed.parameters.d;
    const Scalar m0 = precomputed.m_d35bb54c;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {q_theta, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = v_theta * p_d;
    const Scalar z4 = s_theta * p_d;
    const Scalar z5 = n0_02 * z1;
    const Scalar z6 = c_theta * p_d;
    const Scalar z7 = n0_02 * z2;
    const Scalar z8 = v_X + z2 * m0;
    const Scalar z9 = v_X + c_theta * z3;
    const Scalar z10 = s_theta * z3;
    const Scalar z11 = z1 * m0;
    const Scalar z12 = q_X + z4;
    const Scalar z13 = q_X + z5;
    result.support_position[0] = q_X;
    result.support_position[1] = n0;
    result.support_position[2] = n0;
    result.support_rotation[0] = n1;
    result.support_rotation[1] = n0;
    result.support_rotation[2] = n0;
    result.support_rotation[3] = n0;
    result.support_rotation[4] = n1;
    result.support_rotation[5] = n0;
    result.support_rotation[6] = n0;
    result.support_rotation[7] = n0;
    result.support_rotation[8] = n1;
    result.support_velocity[0] = v_X;
    result.support_velocity[1] = n0;
    result.support_velocity[2] = n0;
    result.support_angular_velocity[0] = n0;
    result.support_angular_velocity[1] = n0;
    result.support_angular_velocity[2] = n0;
    result.pendulum_position[0] = z12;
    result.pendulum_position[1] = n0;
    result.pendulum_position[2] = z6;
    result.pendulum_rotation[0] = c_theta;
    result.pendulum_rotation[1] = n0;
    result.pendulum_rotation[2] = -s_theta;
    result.pendulum_rotation[3] = n0;
    result.pendulum_rotation[4] = n1;
    result.pendulum_rotation[5] = n0;
    result.pendulum_rotation[6] = s_theta;
    result.pendulum_rotation[7] = n0;
    result.pendulum_rotation[8] = c_theta;
    result.pendulum_velocity[0] = z9;
    result.pendulum_velocity[1] = n0;
    result.pendulum_velocity[2] = -z10;
    result.pendulum_angular_velocity[0] = n0;
    result.pendulum_angular_velocity[1] = v_theta;
    result.pendulum_angular_velocity[2] = n0;
    result.unbalance_position[0] = z13;
    result.unbalance_position[1] = n0;
    result.unbalance_position[2] = z7;
    result.unbalance_rotation[0] = z2;
    result.unbalance_rotation[1] = n0;
    result.unbalance_rotation[2] = -z1;
    result.unbalance_rotation[3] = n0;
    result.unbalance_rotation[4] = n1;
    result.unbalance_rotation[5] = n0;
    result.unbalance_rotation[6] = z1;
    result.unbalance_rotation[7] = n0;
    result.unbalance_rotation[8] = z2;
    result.unbalance_velocity[0] = z8;
    result.unbalance_velocity[1] = n0;
    result.unbalance_velocity[2] = -z11;
    result.unbalance_angular_velocity[0] = n0;
    result.unbalance_angular_velocity[1] = p_omega;
    result.unbalance_angular_velocity[2] = n0;
    result.G1_position[0] = q_X;
    result.G1_position[1] = n0;
    result.G1_position[2] = n0;
    result.G1_velocity[0] = v_X;
    result.G1_velocity[1] = n0;
    result.G1_velocity[2] = n0;
    result.G1_jacobian[0] = n1;
    result.G1_jacobian[3] = n0;
    result.G1_jacobian[1] = n0;
    result.G1_jacobian[4] = n0;
    result.G1_jacobian[2] = n0;
    result.G1_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 4>& mass) noexcept {
    const Scalar n11_1 = traits::constant(11.1, 11.1f, "111/10");
    const Scalar q_theta = state.q.theta;
    const Scalar p_d = precomputed.parameters.d;
    const Scalar m0 = precomputed.m_c10e5f00;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = c_theta * p_d;
    mass[0] = n11_1;
    mass[1] = z0;
    mass[2] = z0;
    mass[3] = m0;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1000 = traits::constant(1000.0, 1000.0f, "1000/1");
    const Scalar q_X = state.q.X;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_d = precomputed.parameters.d;
    const Scalar m0 = precomputed.m_53d108b6;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {q_theta, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0];
    const Scalar z1 = sines_[1];
    const Scalar z2 = v_theta * v_theta;
    const Scalar z3 = n0_1 - q_X;
    const Scalar z4 = z1 * m0;
    const Scalar z5 = n9_81 * s_theta;
    const Scalar z6 = n1000 * z3;
    const Scalar z7 = p_d * z2;  // force on pendulum, z
    const Scalar z8 = s_theta * z7;
    const Scalar z9 = p_d * z5;  // moment on pendulum, y
    const Scalar z10 = z4 + z8;  // force on support, x
    const Scalar z11 = z6 + z10;
    forces.X = -z11;
    forces.theta = z9;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1000 = traits::constant(1000.0, 1000.0f, "1000/1");
    const Scalar n11_1 = traits::constant(11.1, 11.1f, "111/10");
    const Scalar q_X = state.q.X;
    const Scalar a_X = accelerations.X;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_d = precomputed.parameters.d;
    const Scalar m0 = precomputed.m_c10e5f00;
    const Scalar m1 = precomputed.m_53d108b6;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {q_theta, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar z1 = sines_[1];
    const Scalar z2 = v_theta * v_theta;
    const Scalar z3 = z1 * m1;
    const Scalar z4 = a_theta * p_d;  // force on pendulum, x
    const Scalar z5 = n0_1 - q_X;
    const Scalar z6 = a_X * c_theta + n9_81 * s_theta;
    const Scalar z7 = p_d * z2;  // force on pendulum, z
    const Scalar z8 = n1000 * z5;
    const Scalar z9 = s_theta * z7 - c_theta * z4;
    const Scalar z10 = a_theta * m0 + p_d * z6;  // moment on pendulum, y
    const Scalar z11 = n11_1 * a_X - z3 - z9;  // force on support, x
    const Scalar z12 = z8 - z11;
    forces.X = -z12;
    forces.theta = z10;
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
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1000 = traits::constant(1000.0, 1000.0f, "1000/1");
    const Scalar n11_1 = traits::constant(11.1, 11.1f, "111/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_X = state.q.X;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_d = precomputed.parameters.d;
    const Scalar m0 = precomputed.m_c10e5f00;
    const Scalar m1 = precomputed.m_248a3b97;
    const Scalar m2 = precomputed.m_53d108b6;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {q_theta, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar z1 = sines_[1];
    const Scalar z2 = c_theta * p_d;
    const Scalar z3 = v_theta * v_theta;
    const Scalar z4 = n0_1 - q_X;
    const Scalar z5 = z1 * m2;
    const Scalar z6 = n9_81 * s_theta;
    const Scalar z7 = n1000 * z4;
    const Scalar z8 = p_d * z3;
    const Scalar z9 = s_theta * z8;
    const Scalar z10 = p_d * z6;
    const Scalar z11 = m1 * z2;
    const Scalar z12 = z5 + z9;  // force on support, x
    const Scalar z13 = n11_1 - z2 * z11;
    const Scalar z14 = z7 + z12;
    const Scalar z15 = n1 / z13;
    const Scalar z16 = z10 * z11 + z14;
    const Scalar z17 = z15 * z16;
    const Scalar z18 = m1 * z10 + z11 * z17;
    accelerations.X = z17;
    accelerations.theta = -z18;
    if (!(traits::regular(z13, n11_1) && traits::regular(m0, m0))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.X * accelerations.theta;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      Accelerations& accelerations) noexcept {
    Multipliers multipliers{};
    return Mechanism::forward_dynamics(precomputed, state, Inputs(), accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_X = state.q.X;
    const Scalar v_X = state.v.X;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_d = precomputed.parameters.d;
    const Scalar m0 = precomputed.m_c10e5f00;
    const Scalar m1 = precomputed.m_ba725c70;
    const Scalar m2 = precomputed.m_a124f2ef;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {q_theta, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = v_X * c_theta;
    const Scalar z4 = v_X * z2;
    const Scalar z5 = v_X * s_theta;
    const Scalar z6 = v_X * z1;
    const Scalar z7 = c_theta * p_d;
    const Scalar z8 = n0_002 * z2;
    const Scalar z9 = n0_1 - q_X;
    const Scalar z10 = v_theta * p_d + z3;
    const Scalar z11 = v_theta * m0 + p_d * z3;
    const Scalar z12 = m2 + n0_1 * z4;
    const Scalar z13 = m1 + n0_002 * z4;
    result.kinetic = n5 * v_X * v_X + n0_05 * z6 * z6 + n0_5 * (z5 * z5 + v_theta * z11 + z3 * z10 + p_omega * z13 + z4
        * z12);
    result.force_function = n9_81 * (z7 + z8) - n500 * z9 * z9;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1000 = traits::constant(1000.0, 1000.0f, "1000/1");
    const Scalar n11_1 = traits::constant(11.1, 11.1f, "111/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_X = state.q.X;
    const Scalar a_X = accelerations.X;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_d = precomputed.parameters.d;
    const Scalar m0 = precomputed.m_c10e5f00;
    const Scalar m1 = precomputed.m_53d108b6;
    const Scalar m2 = precomputed.m_248a3b97;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {q_theta, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar z1 = sines_[1];
    const Scalar z2 = c_theta * p_d;
    const Scalar z3 = v_theta * v_theta;
    const Scalar z4 = a_theta * p_d;  // force on pendulum, x
    const Scalar z5 = a_X * s_theta - n9_81 * c_theta;
    const Scalar z6 = p_d * z3;  // force on pendulum, z
    const Scalar z7 = n2 * v_theta;
    const Scalar z8 = z1 * m1;
    const Scalar z9 = p_d * z7;
    const Scalar z10 = n0_1 - q_X;
    const Scalar z11 = a_X * c_theta + n9_81 * s_theta;
    const Scalar z12 = s_theta * z4 + c_theta * z6;
    const Scalar z13 = s_theta * z6 - c_theta * z4;
    const Scalar z14 = s_theta * z9;
    const Scalar z15 = n1000 * z10;
    const Scalar z16 = z2 * m2;
    const Scalar z17 = n11_1 - z2 * z16;
    const Scalar z18 = a_theta * m0 + p_d * z11;  // moment on pendulum, y
    const Scalar z19 = n11_1 * a_X - z8 - z13;  // force on support, x
    const Scalar z20 = p_d * z5;
    const Scalar z21 = n1 / z17;
    const Scalar z22 = z12 - z20 * z16;
    const Scalar z23 = z15 - z19;
    const Scalar z24 = n1000 * z21;
    const Scalar z25 = z21 * z22;
    const Scalar z26 = z14 * z21;
    const Scalar z27 = z16 * z24;
    const Scalar z28 = z20 * m2 - z16 * z25;
    const Scalar z29 = z16 * z26;
    result.M[0] = n11_1;
    result.M[1] = z2;
    result.M[2] = z2;
    result.M[3] = m0;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = -z14;
    result.C[3] = n0;
    result.K[0] = n1000;
    result.K[1] = n0;
    result.K[2] = -z12;
    result.K[3] = -z20;
    result.F[0] = z23;
    result.F[1] = -z18;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = -z24;
    result.A[3] = z27;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = z25;
    result.A[7] = z28;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = z26;
    result.A[15] = -z29;
    if (!(traits::regular(z17, n11_1) && traits::regular(m0, m0))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.M[1] * result.M[2] * result.M[3] * result.C[2] * result.K[2] * result.K[3]
        * result.F[0] * result.F[1] * result.A[2] * result.A[3] * result.A[6] * result.A[7] * result.A[14]
        * result.A[15];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, Multipliers(), Inputs(), result);
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 4>&>(mass_matrix));
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

}  // namespace vibration_absorber
