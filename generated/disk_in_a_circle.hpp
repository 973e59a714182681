// SPDX-License-Identifier: MIT-0
// disk_in_a_circle: Disk rolling without slipping while its centre goes round a circle
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: rho
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                1                4          2             0                  0       0      7       -
//   kinematics               16               34          0             0                  3       0     56      56
//   mass_matrix               1                3          0             0                  1       0      6      11
//   bias                      4               15          0             0                  1       0     21      25
//   inverse_dynamics         20               29          0             0                  2       0     53      58
//   forward_dynamics         25               64          3             0                  2       0     96     103
//   energy                   14               28          0             0                  3       0     48      58
//   constraints              16               30          0             0                  2       0     50      50
//
// Not computed because this mechanism does not need it:
//   kinematics: of 42 results 10 vanish identically
//   mass_matrix: of 36 results 28 vanish identically, 1 repeat another up to sign
//   bias: of 6 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 27 results 11 vanish identically, 3 repeat another up to sign
//
// To write this file again:
//   disk_in_a_circle_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --support torsor_support.hpp --output disk_in_a_circle.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace disk_in_a_circle {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 6> coordinates{{{"x", "m"}, {"y", "m"}, {"z", "m"}, {"psi",
      "rad"}, {"theta", "rad"}, {"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 6> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"},
      {"psi", "rad/s"}, {"theta", "rad/s"}, {"phi", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 3> multipliers{{{"N", "N"}, {"X", "N"}, {"Y", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"rho", "m"}}};
  static constexpr std::array<torsor::ResultDescription, 19> results{{{"result", "disk_position", 3, 1, 1, "m"},
      {"result", "disk_rotation", 3, 3, 2, "1"}, {"result", "disk_velocity", 3, 1, 1, "m/s"}, {"result",
      "disk_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "I_position", 3, 1, 1, "m"}, {"result", "I_velocity", 3, 1,
      1, "m/s"}, {"result", "I_jacobian", 3, 6, 2, ""}, {"mass", "", 6, 6, 2, ""}, {"forces", "", 6, 1, 1,
      "0, 0, N, N m, N m, N m"}, {"forces", "", 6, 1, 1, "N, N, N, N m, N m, N m"}, {"accelerations", "", 6, 1, 1,
      "m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2"}, {"multipliers", "", 3, 1, 1, "N"}, {"result", "kinetic", 1, 1,
      0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "value", 3, 1,
      1, "m"}, {"result", "rate", 3, 1, 1, "m/s"}, {"result", "jacobian", 3, 6, 2, ""}, {"result", "gamma", 3, 1, 1,
      "m/s^2"}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 7}, {"mass_matrix", false, false, false, false, results.data() + 7, 1}, {"bias", false, false,
      false, false, results.data() + 8, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 9, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 10, 2}, {"energy", false, false, true, false,
      results.data() + 12, 3}, {"constraints", false, false, false, false, results.data() + 15, 4}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::disk_in_a_circle::Description;

  static constexpr const char* name = "disk_in_a_circle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x0d0272be54edbf3bULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 3;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar rho;  ///< parameter [m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::rho};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad]
    Scalar theta;  ///< coordinate [rad]
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::z, &Coordinates::psi,
          &Coordinates::theta, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::z, &Velocities::psi,
          &Velocities::theta, &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::z,
          &Accelerations::psi, &Accelerations::theta, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::z, &GeneralizedForces::psi, &GeneralizedForces::theta, &GeneralizedForces::phi};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar N;  ///< of the constraint contact [N]
    Scalar X;  ///< of the constraint rolling_x [N]
    Scalar Y;  ///< of the constraint rolling_y [N]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::N, &Multipliers::X, &Multipliers::Y};
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
    Scalar m_f6014e73;
    Scalar m_d93ea422;
    Scalar m_c5c6887b;
    Scalar m_0d712a8b;
    Scalar m_2db39225;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    parameters.rho = n2;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_rho = parameters.rho;
    const Scalar z0 = n0_25 * p_rho * p_rho;
    const Scalar z1 = n0_5 * p_rho * p_rho;
    const Scalar z2 = z0 - z1;
    const Scalar z3 = n1 / z1;
    const Scalar z4 = n1 / z0;
    precomputed.m_f6014e73 = z0;
    precomputed.m_d93ea422 = z1;
    precomputed.m_c5c6887b = z2;
    precomputed.m_0d712a8b = z3;
    precomputed.m_2db39225 = z4;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n60 = traits::constant(60.0, 60.0f, "60/1");
    const Scalar k1 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar k2 = traits::constant(67.96567368900274, 67.965675f, "0;0;981/25;0");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_over_6 = traits::constant(0.16666666666666666, 0.16666667f, "1/6");
    const Scalar p_rho = parameters.rho;
    const Scalar pi = traits::pi();
    const Scalar z0 = n60 + k1 * p_rho;
    const Scalar z1 = k2 / z0;
    const Scalar z2 = traits::sqrt(z1);
    const Scalar z3 = n10 + k1 * p_rho;
    state.time = n0;
    state.q.x = n0;
    state.q.y = -n10;
    state.q.z = n0_5 * p_rho;
    state.q.psi = n0;
    state.q.theta = n1_over_6 * pi;
    state.q.phi = n0;
    state.v.x = n10 * z2;
    state.v.y = n0;
    state.v.z = n0;
    state.v.psi = z2;
    state.v.theta = n0;
    state.v.phi = -z2 * z3 / p_rho;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> disk_position;  ///< centre of mass of disk [m]
    std::array<Scalar, 9> disk_rotation;  ///< from the axes of disk to the ground's (3 x 3)
    std::array<Scalar, 3> disk_velocity;  ///< velocity of the centre of mass of disk [m/s]
    std::array<Scalar, 3> disk_angular_velocity;  ///< angular velocity of disk [rad/s]
    std::array<Scalar, 3> I_position;  ///< position of I [m]
    std::array<Scalar, 3> I_velocity;  ///< velocity of the material point at I [m/s]
    std::array<Scalar, 18> I_jacobian;  ///< partial velocities of I (3 x 6)
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
    std::array<Scalar, 3> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 3> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 18> jacobian;  ///< A, stored column by column (3 x 6)
    std::array<Scalar, 3> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_rho = precomputed.parameters.rho;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = s_psi * c_theta;
    const Scalar z1 = s_psi * s_theta;
    const Scalar z2 = c_psi * s_theta;
    const Scalar z3 = v_theta * p_rho;
    const Scalar z4 = c_psi * c_theta;
    const Scalar z5 = v_psi * c_theta;
    const Scalar z6 = c_psi * v_theta;  // angular velocity of disk.2, x
    const Scalar z7 = s_psi * v_theta;  // angular velocity of disk.2, y
    const Scalar z8 = s_theta * p_rho;
    const Scalar z9 = s_theta * s_phi;
    const Scalar z10 = s_theta * c_phi;
    const Scalar z11 = v_psi + c_theta * v_phi;  // angular velocity of disk, z
    const Scalar z12 = v_z - c_theta * z3;
    const Scalar z13 = c_psi * c_phi - s_phi * z0;
    const Scalar z14 = c_psi * s_phi + c_phi * z0;
    const Scalar z15 = s_psi * c_phi + s_phi * z4;
    const Scalar z16 = s_psi * s_phi - c_phi * z4;
    const Scalar z17 = v_phi * z1 + z6;  // angular velocity of disk, x
    const Scalar z18 = v_phi * z2 - z7;  // angular velocity of disk, y
    const Scalar z19 = p_rho * z0;
    const Scalar z20 = p_rho * z4;
    const Scalar z21 = p_rho * z5;
    const Scalar z22 = q_z - z8;
    const Scalar z23 = s_psi * z8;
    const Scalar z24 = c_psi * z8;
    const Scalar z25 = v_x - z1 * z3 + c_psi * z21;
    const Scalar z26 = v_y + z2 * z3 + s_psi * z21;
    const Scalar z27 = q_x + z19;
    const Scalar z28 = q_y - z20;
    const Scalar z29 = s_psi * z19 + c_psi * z20;
    result.disk_position[0] = q_x;
    result.disk_position[1] = q_y;
    result.disk_position[2] = q_z;
    result.disk_rotation[0] = z13;
    result.disk_rotation[1] = z15;
    result.disk_rotation[2] = z9;
    result.disk_rotation[3] = -z14;
    result.disk_rotation[4] = -z16;
    result.disk_rotation[5] = z10;
    result.disk_rotation[6] = z1;
    result.disk_rotation[7] = -z2;
    result.disk_rotation[8] = c_theta;
    result.disk_velocity[0] = v_x;
    result.disk_velocity[1] = v_y;
    result.disk_velocity[2] = v_z;
    result.disk_angular_velocity[0] = z17;
    result.disk_angular_velocity[1] = -z18;
    result.disk_angular_velocity[2] = z11;
    result.I_position[0] = z27;
    result.I_position[1] = z28;
    result.I_position[2] = z22;
    result.I_velocity[0] = z25;
    result.I_velocity[1] = z26;
    result.I_velocity[2] = z12;
    result.I_jacobian[0] = n1;
    result.I_jacobian[3] = n0;
    result.I_jacobian[6] = n0;
    result.I_jacobian[9] = z20;
    result.I_jacobian[12] = -z23;
    result.I_jacobian[15] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n1;
    result.I_jacobian[7] = n0;
    result.I_jacobian[10] = z19;
    result.I_jacobian[13] = z24;
    result.I_jacobian[16] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.I_jacobian[8] = n1;
    result.I_jacobian[11] = n0;
    result.I_jacobian[14] = -z29;
    result.I_jacobian[17] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 36>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar m0 = precomputed.m_f6014e73;
    const Scalar m1 = precomputed.m_d93ea422;
    const Scalar m2 = precomputed.m_c5c6887b;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = c_theta * m2;
    const Scalar z1 = c_theta * m1;
    const Scalar z2 = c_theta * z0 - m0;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n1;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n1;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = -z2;
    mass[22] = n0;
    mass[23] = z1;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = m0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = z1;
    mass[34] = n0;
    mass[35] = m1;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar m0 = precomputed.m_f6014e73;
    const Scalar m1 = precomputed.m_d93ea422;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_psi * c_theta;
    const Scalar z1 = v_psi * s_theta;
    const Scalar z2 = v_theta * z0;  // angular acceleration of disk.2, y
    const Scalar z3 = v_theta * z1;  // angular acceleration of disk.2, z
    const Scalar z4 = v_phi + z0;  // angular velocity of disk, z
    const Scalar z5 = z1 * z0;
    const Scalar z6 = z1 * z4;
    const Scalar z7 = v_theta * z4;
    const Scalar z8 = m1 * z3;  // moment on disk, z
    const Scalar z9 = n2 * z2;
    const Scalar z10 = m1 * z6;  // moment on disk, x
    const Scalar z11 = m1 * z7;  // moment on disk, y
    const Scalar z12 = m0 * z5 - z10;  // moment on disk.2, x
    const Scalar z13 = m0 * z9 - z11;  // moment on disk.2, y
    const Scalar z14 = s_theta * z13 - c_theta * z8;
    forces.x = n0;
    forces.y = n0;
    forces.z = n9_81;
    forces.psi = z14;
    forces.theta = -z12;
    forces.phi = -z8;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar a_z = accelerations.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_rho = precomputed.parameters.rho;
    const Scalar l_N = multipliers.N;
    const Scalar l_X = multipliers.X;
    const Scalar l_Y = multipliers.Y;
    const Scalar m0 = precomputed.m_f6014e73;
    const Scalar m1 = precomputed.m_d93ea422;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = v_psi * s_theta;
    const Scalar z1 = v_psi * c_theta;
    const Scalar z2 = a_psi * c_theta;
    const Scalar z3 = a_psi * s_theta;
    const Scalar z4 = s_theta * p_rho;
    const Scalar z5 = c_theta * p_rho;
    const Scalar z6 = n9_81 + a_z;
    const Scalar z7 = v_theta * z1 + z3;  // angular acceleration of disk.2, y
    const Scalar z8 = v_theta * z0 - z2;  // angular acceleration of disk.2, z
    const Scalar z9 = v_phi + z1;  // angular velocity of disk, z
    const Scalar z10 = z0 * z1;
    const Scalar z11 = v_theta * z1;
    const Scalar z12 = s_theta * z4 + c_theta * z5;
    const Scalar z13 = z0 * z9;
    const Scalar z14 = v_theta * z9;
    const Scalar z15 = a_phi - z8;  // angular acceleration of disk, z
    const Scalar z16 = z7 + z11;
    const Scalar z17 = m1 * z13;  // moment on disk, x
    const Scalar z18 = m1 * z14;  // moment on disk, y
    const Scalar z19 = m1 * z15;  // moment on disk, z
    const Scalar z20 = m0 * (a_theta - z10) + z17;  // moment on disk.2, x
    const Scalar z21 = m0 * z16 - z18;  // moment on disk.2, y
    const Scalar z22 = c_theta * z19 + s_theta * z21;
    forces.x = a_x + s_psi * l_Y - c_psi * l_X;
    forces.y = a_y - s_psi * l_X - c_psi * l_Y;
    forces.z = z6 - l_N;
    forces.psi = z22 - z5 * l_X;
    forces.theta = z20 + z5 * l_N - z4 * l_Y;
    forces.phi = z19 - z12 * l_X;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar p_rho = precomputed.parameters.rho;
    const Scalar m0 = precomputed.m_f6014e73;
    const Scalar m1 = precomputed.m_d93ea422;
    const Scalar m2 = precomputed.m_c5c6887b;
    const Scalar m3 = precomputed.m_0d712a8b;
    const Scalar m4 = precomputed.m_2db39225;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = s_theta * p_rho;
    const Scalar z1 = c_theta * p_rho;
    const Scalar z2 = v_psi * c_theta;
    const Scalar z3 = v_psi * s_theta;
    const Scalar z4 = v_psi * c_psi;
    const Scalar z5 = v_theta * s_theta;
    const Scalar z6 = v_psi * s_psi;
    const Scalar z7 = v_theta * c_theta;
    const Scalar z8 = s_theta * s_theta * m0;
    const Scalar z9 = c_theta * m1;
    const Scalar z10 = v_psi * (v_x * s_psi - v_y * c_psi);
    const Scalar z11 = c_theta * m2;
    const Scalar z12 = p_rho * z7;
    const Scalar z13 = v_theta * z5;
    const Scalar z14 = s_theta * z0 + c_theta * z1;
    const Scalar z15 = v_theta * z2;  // angular acceleration of disk.2, y
    const Scalar z16 = v_theta * z3;  // angular acceleration of disk.2, z
    const Scalar z17 = v_phi + z2;  // angular velocity of disk, z
    const Scalar z18 = z3 * z2;
    const Scalar z19 = c_theta * z11 - m0;
    const Scalar z20 = z9 * m3;
    const Scalar z21 = z1 * m4;
    const Scalar z22 = z0 * m4;
    const Scalar z23 = p_rho * z13;
    const Scalar z24 = v_x * z4 + v_y * z6 - v_theta * z12;
    const Scalar z25 = z3 * z17;
    const Scalar z26 = v_theta * z17;
    const Scalar z27 = m1 * z16;  // moment on disk, z
    const Scalar z28 = n2 * z15;
    const Scalar z29 = n1 / z8;
    const Scalar z30 = n1 + z1 * z21;
    const Scalar z31 = z0 * z21;
    const Scalar z32 = n1 + z0 * z22;
    const Scalar z33 = m1 * z25;  // moment on disk, x
    const Scalar z34 = m1 * z26;  // moment on disk, y
    const Scalar z35 = z14 * m3;
    const Scalar z36 = n1 / z32;
    const Scalar z37 = n1_over_3 * z10;
    const Scalar z38 = n3 + z30 + z32;
    const Scalar z39 = m0 * z18 - z33;  // moment on disk.2, x
    const Scalar z40 = m0 * z28 - z34;  // moment on disk.2, y
    const Scalar z41 = s_theta * z40;
    const Scalar z42 = z39 * m4;
    const Scalar z43 = z29 * z41;
    const Scalar z44 = n9_81 - z23 + z1 * z42;
    const Scalar z45 = z0 * z42 - z24;
    const Scalar z46 = z27 * m3 + z20 * z43;
    const Scalar z47 = z31 * z36;
    const Scalar z48 = z30 - z31 * z47;
    const Scalar z49 = z47 * z45 - z44;
    const Scalar z50 = z35 * z37 + z46;
    const Scalar z51 = n1 / z48;
    const Scalar z52 = z51 * z49;
    const Scalar z53 = z36 * z45 + z47 * z52;
    const Scalar z54 = n9_81 + z52;
    const Scalar z55 = c_psi * z37 + s_psi * z53;
    const Scalar z56 = s_psi * z37 - c_psi * z53;
    const Scalar z57 = z42 + z21 * z52 - z22 * z53;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.x = z55;
    accelerations.y = z56;
    accelerations.z = -z54;
    accelerations.psi = -z43;
    accelerations.theta = z57;
    accelerations.phi = z50;
    multipliers.N = -z52;
    multipliers.X = z37;
    multipliers.Y = -z53;
    const Scalar bound0_ = roundings_ * z38;
    if (!(traits::regular(z8, -z19) && traits::regular(m0, m0) && traits::regular(m1, m1) && traits::regular(z48,
        bound0_) && traits::regular(z32, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.z * accelerations.psi
        * accelerations.theta * accelerations.phi * multipliers.N * multipliers.X * multipliers.Y;
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar m0 = precomputed.m_f6014e73;
    const Scalar m1 = precomputed.m_d93ea422;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = v_x * s_psi - v_y * c_psi;
    const Scalar z1 = v_x * c_psi + v_y * s_psi;
    const Scalar z2 = v_psi * s_theta;
    const Scalar z3 = v_psi * c_theta;
    const Scalar z4 = v_theta * c_phi + s_phi * z2;
    const Scalar z5 = v_theta * s_phi - c_phi * z2;
    const Scalar z6 = v_phi + z3;  // angular velocity of disk, z
    const Scalar z7 = v_z * s_theta - c_theta * z0;
    const Scalar z8 = v_z * c_theta + s_theta * z0;
    const Scalar z9 = c_phi * z1 + s_phi * z7;
    const Scalar z10 = s_phi * z1 - c_phi * z7;
    result.kinetic = n0_5 * (m1 * z6 * z6 + z8 * z8 + m0 * (z4 * z4 + z5 * z5) + z9 * z9 + z10 * z10);
    result.force_function = -n9_81 * q_z;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed& precomputed, const State& state,
      Constraints& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar p_rho = precomputed.parameters.rho;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = s_theta * p_rho;
    const Scalar z1 = v_theta * c_theta;
    const Scalar z2 = c_theta * p_rho;
    const Scalar z3 = v_theta * s_theta;
    const Scalar z4 = v_psi * s_psi;
    const Scalar z5 = v_psi * c_psi;
    const Scalar z6 = q_z - z0;
    const Scalar z7 = p_rho * z1;
    const Scalar z8 = v_theta * z3;
    const Scalar z9 = s_theta * z0 + c_theta * z2;
    const Scalar z10 = p_rho * z3;
    const Scalar z11 = v_x * s_psi - v_y * c_psi - v_theta * z0;
    const Scalar z12 = v_z - z7;
    const Scalar z13 = p_rho * z8;
    const Scalar z14 = z0 * z1 - z2 * z3 + s_theta * z7 - c_theta * z10;
    const Scalar z15 = v_x * z5 + v_y * z4 - v_theta * z7;
    const Scalar z16 = v_x * c_psi + v_y * s_psi + v_psi * z2 + v_phi * z9;
    const Scalar z17 = v_x * z4 - v_y * z5 + v_psi * z10 - v_phi * z14;
    result.value[0] = z6;
    result.rate[0] = z12;
    result.gamma[0] = z13;
    result.value[1] = n0;
    result.rate[1] = z16;
    result.gamma[1] = -z17;
    result.value[2] = n0;
    result.rate[2] = -z11;
    result.gamma[2] = -z15;
    result.jacobian[0] = n0;
    result.jacobian[1] = c_psi;
    result.jacobian[2] = -s_psi;
    result.jacobian[3] = n0;
    result.jacobian[4] = s_psi;
    result.jacobian[5] = c_psi;
    result.jacobian[6] = n1;
    result.jacobian[7] = n0;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = z2;
    result.jacobian[11] = n0;
    result.jacobian[12] = -z2;
    result.jacobian[13] = n0;
    result.jacobian[14] = z0;
    result.jacobian[15] = n0;
    result.jacobian[16] = z9;
    result.jacobian[17] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 36>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, Constraints&>(constraints));
  }
};

}  // namespace disk_in_a_circle
