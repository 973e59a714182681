// SPDX-License-Identifier: MIT-0
// torque_free_body: Rigid body without any torque
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation, jets
// Parameters set at run time: I1, I2, I3
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                3                3          3             0                  0       0      9       -
//   kinematics               18               21          0             0                  0       0     39      45
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      0                6          0             0                  0       0      6       9
//   inverse_dynamics          3                9          0             0                  0       0     12      15
//   forward_dynamics          0                9          0             0                  0       0      9      15
//   energy                    2                7          0             0                  0       0      9      11
//   first_integrals           2                7          0             0                  0       0      9      11
//   linearisation             3               21          0             0                  0       0     24      30
//   jets                     46               75          0             0                  0       0    121       -
//
// Not computed because this mechanism does not need it:
//   kinematics: of 18 results 6 vanish identically
//   mass_matrix: of 9 results 6 vanish identically
//   energy: of 3 results 2 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 66 results 39 vanish identically, 3 repeat another up to sign
//
// To write this file again:
//   torque_free_body_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,jets --support torsor_support.hpp --output torque_free_body.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace torque_free_body {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 4> coordinates{{{"e_w", "1"}, {"e_x", "1"}, {"e_y", "1"},
      {"e_z", "1"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"e_omega_x", "rad/s"}, {"e_omega_y",
      "rad/s"}, {"e_omega_z", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 3> parameters{{{"I1", "kg m^2"}, {"I2", "kg m^2"}, {"I3",
      "kg m^2"}}};
  static constexpr std::array<torsor::ResultDescription, 20> results{{{"rates", "", 4, 1, 1, "rad/s"}, {"result",
      "body_position", 3, 1, 1, "m"}, {"result", "body_rotation", 3, 3, 2, "1"}, {"result", "body_velocity", 3, 1, 1,
      "m/s"}, {"result", "body_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 3, 3, 2, "kg m^2"}, {"forces", "", 3,
      1, 1, "N m"}, {"forces", "", 3, 1, 1, "N m"}, {"accelerations", "", 3, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1,
      1, ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1,
      0, "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result", "M", 3, 3, 2, "kg m^2"}, {"result", "C", 3, 3, 2,
      "N m s"}, {"result", "K", 3, 3, 2, ""}, {"result", "F", 3, 1, 1, "N m"}, {"result", "A", 6, 6, 2, ""},
      {"coefficients", "", 7, 0, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 10> kernels{{{"coordinate_rates", false, false, false, false,
      results.data() + 0, 1}, {"kinematics", false, false, false, false, results.data() + 1, 4}, {"mass_matrix", false,
      false, false, false, results.data() + 5, 1}, {"bias", false, false, false, false, results.data() + 6, 1},
      {"inverse_dynamics", true, true, false, false, results.data() + 7, 1}, {"forward_dynamics", false, false, true,
      true, results.data() + 8, 2}, {"energy", false, false, true, false, results.data() + 10, 3}, {"first_integrals",
      false, false, false, false, results.data() + 13, 1}, {"linearisation", true, true, true, true, results.data()
      + 14, 5}, {"jets", false, false, true, true, results.data() + 19, 1}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::torque_free_body::Description;

  static constexpr const char* name = "torque_free_body";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x17c165587e15770cULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 3;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 1;
  static constexpr int quaternions[quaternion_count] = {0};

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar I1;  ///< parameter [kg m^2]
    Scalar I2;  ///< parameter [kg m^2]
    Scalar I3;  ///< parameter [kg m^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::I1, &Parameters::I2, &Parameters::I3};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar e_w;  ///< component of a unit quaternion [1]
    Scalar e_x;  ///< component of a unit quaternion [1]
    Scalar e_y;  ///< component of a unit quaternion [1]
    Scalar e_z;  ///< component of a unit quaternion [1]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::e_w, &Coordinates::e_x, &Coordinates::e_y,
          &Coordinates::e_z};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar e_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar e_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar e_omega_z;  ///< angular velocity, in moving axes [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::e_omega_x, &Velocities::e_omega_y,
          &Velocities::e_omega_z};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar e_omega_x;  ///< its rate [rad/s^2]
    Scalar e_omega_y;  ///< its rate [rad/s^2]
    Scalar e_omega_z;  ///< its rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::e_omega_x, &Accelerations::e_omega_y,
          &Accelerations::e_omega_z};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar e_omega_x;  ///< works with e_omega_x [N m]
    Scalar e_omega_y;  ///< works with e_omega_y [N m]
    Scalar e_omega_z;  ///< works with e_omega_z [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::e_omega_x, &GeneralizedForces::e_omega_y,
          &GeneralizedForces::e_omega_z};
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
    Scalar m_a1b9b1ab;
    Scalar m_ff477b03;
    Scalar m_ed21dc8f;
    Scalar m_ccc6a9f6;
    Scalar m_805f55cf;
    Scalar m_890bddd1;
    Scalar m_8124a2d7;
    Scalar m_202d1c7d;
    Scalar m_41a86042;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    parameters.I1 = n1;
    parameters.I2 = n2;
    parameters.I3 = n3;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_I1 = parameters.I1;
    const Scalar p_I2 = parameters.I2;
    const Scalar p_I3 = parameters.I3;
    const Scalar z0 = p_I2 - p_I3;
    const Scalar z1 = p_I1 - p_I3;
    const Scalar z2 = p_I1 - p_I2;
    const Scalar z3 = n1 / p_I3;
    const Scalar z4 = n1 / p_I2;
    const Scalar z5 = n1 / p_I1;
    precomputed.m_a1b9b1ab = z0;
    precomputed.m_ff477b03 = z1;
    precomputed.m_ed21dc8f = z2;
    precomputed.m_ccc6a9f6 = z3;
    precomputed.m_805f55cf = z4;
    precomputed.m_890bddd1 = z5;
    precomputed.m_8124a2d7 = z5 * z0;
    precomputed.m_202d1c7d = z4 * z1;
    precomputed.m_41a86042 = z3 * z2;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    state.time = n0;
    state.q.e_w = n1;
    state.q.e_x = n0;
    state.q.e_y = n0;
    state.q.e_z = n0;
    state.v.e_omega_x = n1;
    state.v.e_omega_y = n0;
    state.v.e_omega_z = n1;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> body_position;  ///< centre of mass of body [m]
    std::array<Scalar, 9> body_rotation;  ///< from the axes of body to the ground's (3 x 3)
    std::array<Scalar, 3> body_velocity;  ///< velocity of the centre of mass of body [m/s]
    std::array<Scalar, 3> body_angular_velocity;  ///< angular velocity of body [rad/s]
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
    Scalar energy;  ///< T - U [J]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 36> A;  ///< state matrix of x = (e, w): x' = A x + B du (6 x 6)
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 4>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar q_e_y = state.q.e_y;
    const Scalar q_e_z = state.q.e_z;
    const Scalar q_e_x = state.q.e_x;
    const Scalar q_e_w = state.q.e_w;
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar z0 = n0_5 * (q_e_y * v_e_omega_y + q_e_z * v_e_omega_z + q_e_x * v_e_omega_x);
    const Scalar z1 = n0_5 * (q_e_y * v_e_omega_z - q_e_z * v_e_omega_y + q_e_w * v_e_omega_x);
    const Scalar z2 = n0_5 * (q_e_z * v_e_omega_x - q_e_x * v_e_omega_z + q_e_w * v_e_omega_y);
    const Scalar z3 = n0_5 * (q_e_y * v_e_omega_x - q_e_x * v_e_omega_y - q_e_w * v_e_omega_z);
    rates[0] = -z0;
    rates[1] = z1;
    rates[2] = z2;
    rates[3] = -z3;
  }

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_e_y = state.q.e_y;
    const Scalar q_e_z = state.q.e_z;
    const Scalar q_e_x = state.q.e_x;
    const Scalar q_e_w = state.q.e_w;
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar z0 = n2 * q_e_y;
    const Scalar z1 = n2 * q_e_z;
    const Scalar z2 = n2 * q_e_x;
    const Scalar z3 = q_e_y * z0;
    const Scalar z4 = q_e_z * z1;
    const Scalar z5 = q_e_x * z0;
    const Scalar z6 = q_e_w * z1;
    const Scalar z7 = q_e_x * z1;
    const Scalar z8 = q_e_w * z0;
    const Scalar z9 = q_e_x * z2;
    const Scalar z10 = q_e_z * z0;
    const Scalar z11 = q_e_w * z2;
    const Scalar z12 = n1 - z3 - z4;
    const Scalar z13 = z5 + z6;
    const Scalar z14 = z7 - z8;
    const Scalar z15 = z5 - z6;
    const Scalar z16 = n1 - z4 - z9;
    const Scalar z17 = z10 + z11;
    const Scalar z18 = v_e_omega_x * z13;  // angular velocity of e_omega_x, y
    const Scalar z19 = v_e_omega_x * z14;  // angular velocity of e_omega_x, z
    const Scalar z20 = z10 - z11;
    const Scalar z21 = n1 - z3 - z9;
    const Scalar z22 = v_e_omega_x * z12;  // angular velocity of e_omega_x, x
    const Scalar z23 = z7 + z8;
    const Scalar z24 = v_e_omega_y * z16 + z18;  // angular velocity of e_omega_y, y
    const Scalar z25 = v_e_omega_y * z17 + z19;  // angular velocity of e_omega_y, z
    const Scalar z26 = v_e_omega_y * z15 + z22;  // angular velocity of e_omega_y, x
    const Scalar z27 = v_e_omega_z * z20 + z24;  // angular velocity of body, y
    const Scalar z28 = v_e_omega_z * z21 + z25;  // angular velocity of body, z
    const Scalar z29 = v_e_omega_z * z23 + z26;  // angular velocity of body, x
    result.body_position[0] = n0;
    result.body_position[1] = n0;
    result.body_position[2] = n0;
    result.body_rotation[0] = z12;
    result.body_rotation[1] = z13;
    result.body_rotation[2] = z14;
    result.body_rotation[3] = z15;
    result.body_rotation[4] = z16;
    result.body_rotation[5] = z17;
    result.body_rotation[6] = z23;
    result.body_rotation[7] = z20;
    result.body_rotation[8] = z21;
    result.body_velocity[0] = n0;
    result.body_velocity[1] = n0;
    result.body_velocity[2] = n0;
    result.body_angular_velocity[0] = z29;
    result.body_angular_velocity[1] = z27;
    result.body_angular_velocity[2] = z28;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State&,
      std::array<Scalar, 9>& mass) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_I1 = precomputed.parameters.I1;
    const Scalar p_I2 = precomputed.parameters.I2;
    const Scalar p_I3 = precomputed.parameters.I3;
    mass[0] = p_I1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = p_I2;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = p_I3;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar m0 = precomputed.m_a1b9b1ab;
    const Scalar m1 = precomputed.m_ff477b03;
    const Scalar m2 = precomputed.m_ed21dc8f;
    const Scalar z0 = v_e_omega_y * v_e_omega_z;
    const Scalar z1 = v_e_omega_x * v_e_omega_z;
    const Scalar z2 = v_e_omega_x * v_e_omega_y;
    const Scalar z3 = m0 * z0;  // moment on body, x
    const Scalar z4 = m1 * z1;  // moment on body, y
    const Scalar z5 = m2 * z2;  // moment on body, z
    forces.e_omega_x = -z3;
    forces.e_omega_y = z4;
    forces.e_omega_z = -z5;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar a_e_omega_x = accelerations.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar a_e_omega_y = accelerations.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar a_e_omega_z = accelerations.e_omega_z;
    const Scalar p_I1 = precomputed.parameters.I1;
    const Scalar p_I2 = precomputed.parameters.I2;
    const Scalar p_I3 = precomputed.parameters.I3;
    const Scalar m0 = precomputed.m_a1b9b1ab;
    const Scalar m1 = precomputed.m_ff477b03;
    const Scalar m2 = precomputed.m_ed21dc8f;
    const Scalar z0 = v_e_omega_y * v_e_omega_z;
    const Scalar z1 = v_e_omega_x * v_e_omega_z;
    const Scalar z2 = v_e_omega_x * v_e_omega_y;
    const Scalar z3 = a_e_omega_x * p_I1 - m0 * z0;  // moment on body, x
    const Scalar z4 = a_e_omega_y * p_I2 + m1 * z1;  // moment on body, y
    const Scalar z5 = a_e_omega_z * p_I3 - m2 * z2;  // moment on body, z
    forces.e_omega_x = z3;
    forces.e_omega_y = z4;
    forces.e_omega_z = z5;
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
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar p_I1 = precomputed.parameters.I1;
    const Scalar p_I2 = precomputed.parameters.I2;
    const Scalar p_I3 = precomputed.parameters.I3;
    const Scalar m0 = precomputed.m_ccc6a9f6;
    const Scalar m1 = precomputed.m_805f55cf;
    const Scalar m2 = precomputed.m_890bddd1;
    const Scalar m3 = precomputed.m_a1b9b1ab;
    const Scalar m4 = precomputed.m_ff477b03;
    const Scalar m5 = precomputed.m_ed21dc8f;
    const Scalar z0 = v_e_omega_y * v_e_omega_z;
    const Scalar z1 = v_e_omega_x * v_e_omega_z;
    const Scalar z2 = v_e_omega_x * v_e_omega_y;
    const Scalar z3 = m3 * z0;
    const Scalar z4 = m4 * z1;
    const Scalar z5 = m5 * z2;
    const Scalar z6 = m0 * z5;
    const Scalar z7 = m1 * z4;
    const Scalar z8 = m2 * z3;
    accelerations.e_omega_x = z8;
    accelerations.e_omega_y = -z7;
    accelerations.e_omega_z = z6;
    if (!(traits::regular(p_I1, p_I1) && traits::regular(p_I2, p_I2) && traits::regular(p_I3,
        p_I3))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.e_omega_x * accelerations.e_omega_y * accelerations.e_omega_z;
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar p_I1 = precomputed.parameters.I1;
    const Scalar p_I2 = precomputed.parameters.I2;
    const Scalar p_I3 = precomputed.parameters.I3;
    result.kinetic = n0_5 * (v_e_omega_x * v_e_omega_x * p_I1 + v_e_omega_y * v_e_omega_y * p_I2 + v_e_omega_z
        * v_e_omega_z * p_I3);
    result.force_function = n0;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar p_I1 = precomputed.parameters.I1;
    const Scalar p_I2 = precomputed.parameters.I2;
    const Scalar p_I3 = precomputed.parameters.I3;
    result.energy = n0_5 * (v_e_omega_x * v_e_omega_x * p_I1 + v_e_omega_y * v_e_omega_y * p_I2 + v_e_omega_z
        * v_e_omega_z * p_I3);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  /// Along an attitude e is a turn in its moving axes, e' stands for w, the deviation of the angular velocity
  /// omega, and w = de/dt + omega x e: A says so.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_e_omega_x = state.v.e_omega_x;
    const Scalar a_e_omega_x = accelerations.e_omega_x;
    const Scalar v_e_omega_y = state.v.e_omega_y;
    const Scalar a_e_omega_y = accelerations.e_omega_y;
    const Scalar v_e_omega_z = state.v.e_omega_z;
    const Scalar a_e_omega_z = accelerations.e_omega_z;
    const Scalar p_I1 = precomputed.parameters.I1;
    const Scalar p_I2 = precomputed.parameters.I2;
    const Scalar p_I3 = precomputed.parameters.I3;
    const Scalar m0 = precomputed.m_a1b9b1ab;
    const Scalar m1 = precomputed.m_ff477b03;
    const Scalar m2 = precomputed.m_ed21dc8f;
    const Scalar m3 = precomputed.m_ccc6a9f6;
    const Scalar m4 = precomputed.m_805f55cf;
    const Scalar m5 = precomputed.m_890bddd1;
    const Scalar z0 = v_e_omega_y * v_e_omega_z;
    const Scalar z1 = v_e_omega_x * v_e_omega_z;
    const Scalar z2 = v_e_omega_x * v_e_omega_y;
    const Scalar z3 = v_e_omega_z * m1;
    const Scalar z4 = v_e_omega_y * m2;
    const Scalar z5 = v_e_omega_z * m0;
    const Scalar z6 = v_e_omega_x * m2;
    const Scalar z7 = v_e_omega_y * m0;
    const Scalar z8 = v_e_omega_x * m1;
    const Scalar z9 = a_e_omega_x * p_I1 - m0 * z0;  // moment on body, x
    const Scalar z10 = a_e_omega_y * p_I2 + m1 * z1;  // moment on body, y
    const Scalar z11 = a_e_omega_z * p_I3 - m2 * z2;  // moment on body, z
    const Scalar z12 = z3 * m4;
    const Scalar z13 = z4 * m3;
    const Scalar z14 = z5 * m5;
    const Scalar z15 = z6 * m3;
    const Scalar z16 = z7 * m5;
    const Scalar z17 = z8 * m4;
    result.M[0] = p_I1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = p_I2;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = p_I3;
    result.C[0] = n0;
    result.C[1] = z3;
    result.C[2] = -z4;
    result.C[3] = -z5;
    result.C[4] = n0;
    result.C[5] = -z6;
    result.C[6] = -z7;
    result.C[7] = z8;
    result.C[8] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.F[0] = -z9;
    result.F[1] = -z10;
    result.F[2] = -z11;
    result.A[0] = n0;
    result.A[1] = -v_e_omega_z;
    result.A[2] = v_e_omega_y;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = v_e_omega_z;
    result.A[7] = n0;
    result.A[8] = -v_e_omega_x;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = -v_e_omega_y;
    result.A[13] = v_e_omega_x;
    result.A[14] = n0;
    result.A[15] = n0;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = n0;
    result.A[22] = -z12;
    result.A[23] = z13;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = z14;
    result.A[28] = n0;
    result.A[29] = z15;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = z16;
    result.A[34] = -z17;
    result.A[35] = n0;
    if (!(traits::regular(p_I1, p_I1) && traits::regular(p_I2, p_I2) && traits::regular(p_I3,
        p_I3))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[0] * result.M[4] * result.M[8] * result.C[1] * result.C[2] * result.C[3]
        * result.C[5] * result.C[6] * result.C[7] * result.F[0] * result.F[1] * result.F[2]) * (n0 * result.A[1]
        * result.A[2] * result.A[6] * result.A[8] * result.A[12] * result.A[13] * result.A[22] * result.A[23]
        * result.A[27] * result.A[29] * result.A[33] * result.A[34]);
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, Multipliers(), Inputs(), result);
  }

  /// Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions
  /// then velocities, the inputs being constant. 15 operations take a convolution at each order.
  /// Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed& precomputed, const State& state, const Inputs&, int order,
      std::array<Scalar, 7>* coefficients) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_I1 = precomputed.parameters.I1;
    const Scalar p_I2 = precomputed.parameters.I2;
    const Scalar p_I3 = precomputed.parameters.I3;
    const Scalar b0 = state.q.e_y;
    const Scalar b5 = state.v.e_omega_y;
    const Scalar b1 = state.q.e_z;
    const Scalar b6 = state.v.e_omega_z;
    const Scalar b2 = state.q.e_x;
    const Scalar b4 = state.v.e_omega_x;
    const Scalar b3 = state.q.e_w;
    const Scalar f0 = precomputed.m_8124a2d7;
    const Scalar f1 = precomputed.m_202d1c7d;
    const Scalar f2 = precomputed.m_41a86042;
    const Scalar b7 = b0 * b5;
    const Scalar b8 = b1 * b6;
    const Scalar b9 = b2 * b4;
    const Scalar b10 = b0 * b6;
    const Scalar b11 = b1 * b5;
    const Scalar b12 = b3 * b4;
    const Scalar b13 = b1 * b4;
    const Scalar b14 = b2 * b6;
    const Scalar b15 = b3 * b5;
    const Scalar b16 = b0 * b4;
    const Scalar b17 = b2 * b5;
    const Scalar b18 = b3 * b6;
    const Scalar b19 = b5 * b6;
    const Scalar b20 = b4 * b6;
    const Scalar b21 = b4 * b5;
    coefficients[0][0] = state.q.e_w;
    coefficients[0][1] = state.q.e_x;
    coefficients[0][2] = state.q.e_y;
    coefficients[0][3] = state.q.e_z;
    coefficients[0][4] = state.v.e_omega_x;
    coefficients[0][5] = state.v.e_omega_y;
    coefficients[0][6] = state.v.e_omega_z;
    coefficients[1][0] = -n0_5 * b7 - n0_5 * b8 - n0_5 * b9;
    coefficients[1][1] = n0_5 * b10 - n0_5 * b11 + n0_5 * b12;
    coefficients[1][2] = n0_5 * b13 - n0_5 * b14 + n0_5 * b15;
    coefficients[1][3] = -n0_5 * b16 + n0_5 * b17 + n0_5 * b18;
    coefficients[1][4] = f0 * b19;
    coefficients[1][5] = -f1 * b20;
    coefficients[1][6] = f2 * b21;
    torsor::Convolutions<Scalar, 15> operations_;
    typename torsor::Convolutions<Scalar, 15>::Sums sums_;
    Scalar number_ = n1, inverse_ = n1;
    for (int k_ = 1; k_ < order; ++k_) {
      const Scalar following_ = number_ + n1, next_ = n1 / following_;
      operations_.sum(k_, sums_);
      const Scalar x0 = coefficients[k_][2];
      const Scalar x1 = coefficients[k_][3];
      const Scalar x2 = coefficients[k_][1];
      const Scalar x3 = coefficients[k_][0];
      const Scalar x4 = coefficients[k_][4];
      const Scalar x5 = coefficients[k_][5];
      const Scalar x6 = coefficients[k_][6];
      const Scalar x7 = sums_[0] + b0 * x5 + b5 * x0;
      const Scalar x8 = sums_[1] + b1 * x6 + b6 * x1;
      const Scalar x9 = sums_[2] + b2 * x4 + b4 * x2;
      const Scalar x10 = sums_[3] + b0 * x6 + b6 * x0;
      const Scalar x11 = sums_[4] + b1 * x5 + b5 * x1;
      const Scalar x12 = sums_[5] + b3 * x4 + b4 * x3;
      const Scalar x13 = sums_[6] + b1 * x4 + b4 * x1;
      const Scalar x14 = sums_[7] + b2 * x6 + b6 * x2;
      const Scalar x15 = sums_[8] + b3 * x5 + b5 * x3;
      const Scalar x16 = sums_[9] + b0 * x4 + b4 * x0;
      const Scalar x17 = sums_[10] + b2 * x5 + b5 * x2;
      const Scalar x18 = sums_[11] + b3 * x6 + b6 * x3;
      const Scalar x19 = sums_[12] + b5 * x6 + b6 * x5;
      const Scalar x20 = sums_[13] + b4 * x6 + b6 * x4;
      const Scalar x21 = sums_[14] + b4 * x5 + b5 * x4;
      coefficients[k_ + 1][0] = next_ * (-n0_5 * x7 - n0_5 * x8 - n0_5 * x9);
      coefficients[k_ + 1][1] = next_ * (n0_5 * x10 - n0_5 * x11 + n0_5 * x12);
      coefficients[k_ + 1][2] = next_ * (n0_5 * x13 - n0_5 * x14 + n0_5 * x15);
      coefficients[k_ + 1][3] = next_ * (-n0_5 * x16 + n0_5 * x17 + n0_5 * x18);
      coefficients[k_ + 1][4] = next_ * f0 * x19;
      coefficients[k_ + 1][5] = next_ * (-f1 * x20);
      coefficients[k_ + 1][6] = next_ * f2 * x21;
      const Scalar left_[] = {x0, x1, x2, x0, x1, x3, x1, x2, x3, x0, x2, x3, x5, x4, x4};
      const Scalar right_[] = {x5, x6, x4, x6, x5, x4, x4, x6, x5, x4, x5, x6, x6, x6, x5};
      operations_.keep(k_, left_, right_);
      number_ = following_;
      inverse_ = next_;
    }
    static_cast<void>(inverse_);
    if (!(traits::regular(p_I1, p_I1) && traits::regular(p_I2, p_I2) && traits::regular(p_I3,
        p_I3))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * coefficients[order][0] * coefficients[order][1] * coefficients[order][2]
        * coefficients[order][3] * coefficients[order][4] * coefficients[order][5] * coefficients[order][6];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed& precomputed, const State& state, int order,
      std::array<Scalar, 7>* coefficients) noexcept {
    return Mechanism::jets(precomputed, state, Inputs(), order, coefficients);
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 4>&>(coordinate_rates));
    visitor(Description::kernels[1], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[2], KernelFunction<void, std::array<Scalar, 9>&>(mass_matrix));
    visitor(Description::kernels[3], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[4],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[5],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[6], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[7], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
    visitor(Description::kernels[9], KernelFunction<torsor::Status, const Inputs&, int, std::array<Scalar, 7>*>(jets));
  }
};

}  // namespace torque_free_body
