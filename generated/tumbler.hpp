// SPDX-License-Identifier: MIT-0
// tumbler: Tumbler: a weighted half sphere rolling on a table
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints
// Parameters set at run time: a
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                2                3          1             0                  0       0      6       -
//   kinematics               53               89          0             0                  3       0    148     148
//   mass_matrix               1                9          0             0                  2       0     14      19
//   bias                     11               30          0             0                  2       0     45      49
//   inverse_dynamics         31               51          0             0                  2       0     86      91
//   forward_dynamics        122              212          7             0                  2       0    345     350
//   energy                   19               38          0             0                  3       0     63      70
//   constraints               9               25          0             0                  2       0     38      38
//
// Not computed because this mechanism does not need it:
//   kinematics: of 45 results 11 vanish identically
//   mass_matrix: of 36 results 18 vanish identically, 6 repeat another up to sign
//   forward_dynamics: of 9 results 1 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 27 results 14 vanish identically
//
// To write this file again:
//   tumbler_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints --support torsor_support.hpp --output tumbler.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace tumbler {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 6> coordinates{{{"x", "m"}, {"y", "m"}, {"z", "m"}, {"psi",
      "rad"}, {"theta", "rad"}, {"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 6> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"},
      {"psi", "rad/s"}, {"theta", "rad/s"}, {"phi", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 3> multipliers{{{"N", "N"}, {"X", "N"}, {"Y", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"a", "m"}}};
  static constexpr std::array<torsor::ResultDescription, 20> results{{{"result", "tumbler_position", 3, 1, 1, "m"},
      {"result", "tumbler_rotation", 3, 3, 2, "1"}, {"result", "tumbler_velocity", 3, 1, 1, "m/s"}, {"result",
      "tumbler_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "I_position", 3, 1, 1, "m"}, {"result", "I_velocity", 3,
      1, 1, "m/s"}, {"result", "I_geometric_velocity", 3, 1, 1, "m/s"}, {"result", "I_jacobian", 3, 6, 2, ""}, {"mass",
      "", 6, 6, 2, ""}, {"forces", "", 6, 1, 1, "N, N, N, N m, N m, N m"}, {"forces", "", 6, 1, 1,
      "N, N, N, N m, N m, N m"}, {"accelerations", "", 6, 1, 1, "m/s^2, m/s^2, 0, rad/s^2, rad/s^2, rad/s^2"},
      {"multipliers", "", 3, 1, 1, "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0,
      "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "value", 3, 1, 1, "m"}, {"result", "rate", 3, 1, 1, "m/s"},
      {"result", "jacobian", 3, 6, 2, ""}, {"result", "gamma", 3, 1, 1, "m/s^2"}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 8}, {"mass_matrix", false, false, false, false, results.data() + 8, 1}, {"bias", false, false,
      false, false, results.data() + 9, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 10, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 11, 2}, {"energy", false, false, true, false,
      results.data() + 13, 3}, {"constraints", false, false, false, false, results.data() + 16, 4}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::tumbler::Description;

  static constexpr const char* name = "tumbler";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x96421ec8d1073051ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 3;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar a;  ///< parameter [m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::a};
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
    Scalar m_fcfe008c;
    Scalar m_94eff1a0;
    Scalar m_a41afbc0;
    Scalar m_36f1651a;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    parameters.a = n0_02;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar k2 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_a = parameters.a;
    const Scalar z0 = n0_0002 + n0_2 * p_a * p_a;
    const Scalar z1 = n0_2 * p_a;
    const Scalar z2 = k2 - z0;
    const Scalar z3 = n1 / z0;
    precomputed.m_fcfe008c = z0;
    precomputed.m_94eff1a0 = z1;
    precomputed.m_a41afbc0 = z2;
    precomputed.m_36f1651a = z3;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar z0 = n1;
    const Scalar z1 = traits::formula(0.8414709848078965, 0.84147096f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.z = n0_05;
    state.q.psi = n0;
    state.q.theta = n1;
    state.q.phi = n0;
    state.v.x = -n0_15 * z1;
    state.v.y = n0;
    state.v.z = n0;
    state.v.psi = n5;
    state.v.theta = n0;
    state.v.phi = n3;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> tumbler_position;  ///< centre of mass of tumbler [m]
    std::array<Scalar, 9> tumbler_rotation;  ///< from the axes of tumbler to the ground's (3 x 3)
    std::array<Scalar, 3> tumbler_velocity;  ///< velocity of the centre of mass of tumbler [m/s]
    std::array<Scalar, 3> tumbler_angular_velocity;  ///< angular velocity of tumbler [rad/s]
    std::array<Scalar, 3> I_position;  ///< position of I [m]
    std::array<Scalar, 3> I_velocity;  ///< velocity of the material point at I [m/s]
    std::array<Scalar, 3> I_geometric_velocity;  ///< velocity of the point I itself, which moves in its frame [m/s]
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
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
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
    const Scalar p_a = precomputed.parameters.a;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = v_psi * c_theta;
    const Scalar z1 = s_theta * c_phi;
    const Scalar z2 = v_psi * s_theta;
    const Scalar z3 = v_phi * c_phi;
    const Scalar z4 = s_psi * c_theta;
    const Scalar z5 = c_psi * c_theta;
    const Scalar z6 = n0_05 * c_theta;
    const Scalar z7 = s_psi * s_theta;
    const Scalar z8 = c_psi * s_theta;
    const Scalar z9 = s_theta * s_phi;
    const Scalar z10 = v_theta * c_theta;
    const Scalar z11 = v_phi * s_phi;
    const Scalar z12 = v_theta * s_theta;
    const Scalar z13 = c_psi * v_theta;  // angular velocity of tumbler.2, x
    const Scalar z14 = s_psi * v_theta;  // angular velocity of tumbler.2, y
    const Scalar z15 = c_theta * p_a;
    const Scalar z16 = v_psi + c_theta * v_phi;  // angular velocity of tumbler, z
    const Scalar z17 = c_psi * c_phi - s_phi * z4;
    const Scalar z18 = c_psi * s_phi + c_phi * z4;
    const Scalar z19 = s_psi * c_phi + s_phi * z5;
    const Scalar z20 = s_psi * s_phi - c_phi * z5;
    const Scalar z21 = v_theta * c_phi + s_phi * z2;
    const Scalar z22 = v_theta * s_phi - c_phi * z2;
    const Scalar z23 = v_phi + z0;
    const Scalar z24 = v_phi * z7 + z13;  // angular velocity of tumbler, x
    const Scalar z25 = v_phi * z8 - z14;  // angular velocity of tumbler, y
    const Scalar z26 = p_a * z7;
    const Scalar z27 = p_a * z8;
    const Scalar z28 = q_z - z15;
    const Scalar z29 = n0_05 * z9;
    const Scalar z30 = n0_05 * z1;
    const Scalar z31 = s_theta * z3 + s_phi * z10;
    const Scalar z32 = s_theta * z11 - c_phi * z10;
    const Scalar z33 = n0_05 * z12;
    const Scalar z34 = q_x - z26;
    const Scalar z35 = q_y + z27;
    const Scalar z36 = c_theta * z6 + z9 * z29 + z1 * z30;
    const Scalar z37 = p_a * z22;
    const Scalar z38 = p_a * z21;
    const Scalar z39 = z7 * z6 + z17 * z29 - z18 * z30;
    const Scalar z40 = z8 * z6 - z19 * z29 + z20 * z30;
    const Scalar z41 = z23 * z30 + z22 * z6;
    const Scalar z42 = z21 * z6 - z23 * z29;
    const Scalar z43 = z21 * z30 + z22 * z29;
    const Scalar z44 = v_x + z17 * z37 - z18 * z38;
    const Scalar z45 = v_y + z19 * z37 - z20 * z38;
    const Scalar z46 = v_z + z9 * z37 + z1 * z38;
    const Scalar z47 = n0_05 * z31;
    const Scalar z48 = n0_05 * z32;
    const Scalar z49 = z7 * z33 - z17 * z47 - z18 * z48;
    const Scalar z50 = v_x + z17 * z41 - z7 * z43 - z18 * z42;
    const Scalar z51 = v_y + z19 * z41 + z8 * z43 - z20 * z42;
    const Scalar z52 = v_z + z9 * z41 - c_theta * z43 + z1 * z42;
    const Scalar z53 = z8 * z33 + z19 * z47 + z20 * z48;
    const Scalar z54 = c_theta * z33 - z9 * z47 + z1 * z48;
    const Scalar z55 = q_x - z39;
    const Scalar z56 = q_y + z40;
    const Scalar z57 = q_z - z36;
    const Scalar z58 = z50 + z49;
    const Scalar z59 = z51 - z53;
    const Scalar z60 = z52 + z54;
    const Scalar z61 = c_theta * z40 - z8 * z36;
    const Scalar z62 = c_theta * z39 - z7 * z36;
    const Scalar z63 = s_psi * z36;
    const Scalar z64 = c_psi * z36;
    result.tumbler_position[0] = z34;
    result.tumbler_position[1] = z35;
    result.tumbler_position[2] = z28;
    result.tumbler_rotation[0] = z17;
    result.tumbler_rotation[1] = z19;
    result.tumbler_rotation[2] = z9;
    result.tumbler_rotation[3] = -z18;
    result.tumbler_rotation[4] = -z20;
    result.tumbler_rotation[5] = z1;
    result.tumbler_rotation[6] = z7;
    result.tumbler_rotation[7] = -z8;
    result.tumbler_rotation[8] = c_theta;
    result.tumbler_velocity[0] = z44;
    result.tumbler_velocity[1] = z45;
    result.tumbler_velocity[2] = z46;
    result.tumbler_angular_velocity[0] = z24;
    result.tumbler_angular_velocity[1] = -z25;
    result.tumbler_angular_velocity[2] = z16;
    result.I_position[0] = z55;
    result.I_position[1] = z56;
    result.I_position[2] = z57;
    result.I_velocity[0] = z50;
    result.I_velocity[1] = z51;
    result.I_velocity[2] = z52;
    result.I_geometric_velocity[0] = z58;
    result.I_geometric_velocity[1] = z59;
    result.I_geometric_velocity[2] = z60;
    result.I_jacobian[0] = n1;
    result.I_jacobian[3] = n0;
    result.I_jacobian[6] = n0;
    result.I_jacobian[9] = n0;
    result.I_jacobian[12] = -z63;
    result.I_jacobian[15] = -z61;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n1;
    result.I_jacobian[7] = n0;
    result.I_jacobian[10] = n0;
    result.I_jacobian[13] = z64;
    result.I_jacobian[16] = -z62;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.I_jacobian[8] = n1;
    result.I_jacobian[11] = n0;
    result.I_jacobian[14] = n0;
    result.I_jacobian[17] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 36>& mass) noexcept {
    const Scalar k0 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar m0 = precomputed.m_fcfe008c;
    const Scalar m1 = precomputed.m_94eff1a0;
    const Scalar m2 = precomputed.m_a41afbc0;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = s_theta * m2;
    const Scalar z1 = c_theta * m1;
    const Scalar z2 = s_theta * m1;
    const Scalar z3 = k0 * c_theta;
    const Scalar z4 = s_psi * z1;
    const Scalar z5 = c_psi * z1;
    const Scalar z6 = k0 - s_theta * z0;
    const Scalar z7 = c_psi * z2;
    const Scalar z8 = s_psi * z2;
    mass[0] = n0_2;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = -z7;
    mass[4] = -z4;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0_2;
    mass[8] = n0;
    mass[9] = -z8;
    mass[10] = z5;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0_2;
    mass[15] = n0;
    mass[16] = z2;
    mass[17] = n0;
    mass[18] = -z7;
    mass[19] = -z8;
    mass[20] = n0;
    mass[21] = z6;
    mass[22] = n0;
    mass[23] = z3;
    mass[24] = -z4;
    mass[25] = z5;
    mass[26] = z2;
    mass[27] = n0;
    mass[28] = m0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = z3;
    mass[34] = n0;
    mass[35] = k0;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k1 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1_962 = traits::constant(1.962, 1.962f, "981/500");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar m0 = precomputed.m_fcfe008c;
    const Scalar m1 = precomputed.m_94eff1a0;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = v_psi * s_theta;
    const Scalar z1 = v_psi * c_theta;
    const Scalar z2 = v_theta * v_theta;
    const Scalar z3 = n9_81 * s_theta;
    const Scalar z4 = v_theta * z1;  // angular acceleration of tumbler.2, y
    const Scalar z5 = v_theta * z0;  // angular acceleration of tumbler.2, z
    const Scalar z6 = v_phi + z1;  // angular velocity of tumbler, z
    const Scalar z7 = z0 * z1;
    const Scalar z8 = z0 * z0;
    const Scalar z9 = z0 * z6;
    const Scalar z10 = v_theta * z6;
    const Scalar z11 = k1 * z5;  // moment on tumbler, z
    const Scalar z12 = n2 * z4;
    const Scalar z13 = z2 + z8;
    const Scalar z14 = m1 * z7;  // force on tumbler.2, y
    const Scalar z15 = k1 * z9;  // moment on tumbler, x
    const Scalar z16 = k1 * z10;  // moment on tumbler, y
    const Scalar z17 = m1 * z12;  // force on tumbler.2, x
    const Scalar z18 = m1 * z13;  // force on tumbler.2, z
    const Scalar z19 = m0 * z7 - z15 - m1 * z3;  // moment on tumbler.2, x
    const Scalar z20 = m0 * z12 - z16;  // moment on tumbler.2, y
    const Scalar z21 = c_theta * z14 + s_theta * z18;
    const Scalar z22 = s_theta * z14 - c_theta * z18;
    const Scalar z23 = s_theta * z20 - c_theta * z11;
    const Scalar z24 = s_psi * z21 - c_psi * z17;
    const Scalar z25 = s_psi * z17 + c_psi * z21;
    const Scalar z26 = n1_962 - z22;  // force on tumbler.z, z
    forces.x = z24;
    forces.y = -z25;
    forces.z = z26;
    forces.psi = z23;
    forces.theta = -z19;
    forces.phi = -z11;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k2 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
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
    const Scalar l_N = multipliers.N;
    const Scalar l_X = multipliers.X;
    const Scalar l_Y = multipliers.Y;
    const Scalar m0 = precomputed.m_fcfe008c;
    const Scalar m1 = precomputed.m_94eff1a0;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = v_psi * s_theta;
    const Scalar z1 = v_psi * c_theta;
    const Scalar z2 = v_theta * v_theta;
    const Scalar z3 = a_psi * s_theta;
    const Scalar z4 = a_psi * c_theta;
    const Scalar z5 = n9_81 + a_z;
    const Scalar z6 = a_x * c_psi + a_y * s_psi;
    const Scalar z7 = a_x * s_psi - a_y * c_psi;
    const Scalar z8 = s_psi * s_theta;
    const Scalar z9 = c_psi * s_theta;
    const Scalar z10 = n0_05 * s_psi;
    const Scalar z11 = n0_05 * c_psi;
    const Scalar z12 = v_theta * z1 + z3;  // angular acceleration of tumbler.2, y
    const Scalar z13 = v_theta * z0 - z4;  // angular acceleration of tumbler.2, z
    const Scalar z14 = v_phi + z1;  // angular velocity of tumbler, z
    const Scalar z15 = v_theta * z1;
    const Scalar z16 = z0 * z1;
    const Scalar z17 = z0 * z0;
    const Scalar z18 = n0_05 * z9;
    const Scalar z19 = n0_05 * z8;
    const Scalar z20 = z0 * z14;
    const Scalar z21 = v_theta * z14;
    const Scalar z22 = a_theta - z16;
    const Scalar z23 = z2 + z17;
    const Scalar z24 = s_theta * z5 - c_theta * z7;
    const Scalar z25 = a_phi - z13;  // angular acceleration of tumbler, z
    const Scalar z26 = z12 + z15;
    const Scalar z27 = k2 * z20;  // moment on tumbler, x
    const Scalar z28 = k2 * z21;  // moment on tumbler, y
    const Scalar z29 = m1 * z22;  // force on tumbler.2, y
    const Scalar z30 = m1 * z23;  // force on tumbler.2, z
    const Scalar z31 = k2 * z25;  // moment on tumbler, z
    const Scalar z32 = m1 * z26;  // force on tumbler.2, x
    const Scalar z33 = z27 + m0 * (a_theta - z16) + m1 * z24;  // moment on tumbler.2, x
    const Scalar z34 = m0 * z26 - z28 - m1 * z6;  // moment on tumbler.2, y
    const Scalar z35 = s_theta * z30 - c_theta * z29;
    const Scalar z36 = s_theta * z29 + c_theta * z30;
    const Scalar z37 = s_psi * z35 - c_psi * z32;
    const Scalar z38 = s_psi * z32 + c_psi * z35;
    const Scalar z39 = n0_2 * z5 + z36;  // force on tumbler.z, z
    const Scalar z40 = c_theta * z31 + s_theta * z34;
    const Scalar z41 = n0_2 * a_y - z38;  // force on tumbler.z, y
    const Scalar z42 = n0_2 * a_x + z37;  // force on tumbler.z, x
    forces.x = z42 - l_X;
    forces.y = z41 - l_Y;
    forces.z = z39 - l_N;
    forces.psi = z40;
    forces.theta = z33 + z10 * l_X - z11 * l_Y;
    forces.phi = z31 - z18 * l_X - z19 * l_Y;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar k0 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k3 = traits::constant(6666.666666666667, 6666.6665f, "20000/3");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_962 = traits::constant(1.962, 1.962f, "981/500");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar m0 = precomputed.m_fcfe008c;
    const Scalar m1 = precomputed.m_94eff1a0;
    const Scalar m2 = precomputed.m_a41afbc0;
    const Scalar m3 = precomputed.m_36f1651a;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = s_theta * m1;
    const Scalar z1 = s_theta * s_theta * m0;
    const Scalar z2 = c_theta * m1;
    const Scalar z3 = s_psi * s_theta;
    const Scalar z4 = k0 * c_theta;
    const Scalar z5 = n0_05 * c_psi;
    const Scalar z6 = c_psi * s_theta;
    const Scalar z7 = n0_05 * s_psi;
    const Scalar z8 = v_psi * s_theta;
    const Scalar z9 = v_psi * c_theta;
    const Scalar z10 = v_theta * v_theta;
    const Scalar z11 = n9_81 * s_theta;
    const Scalar z12 = v_theta * c_theta;
    const Scalar z13 = v_psi * c_psi;
    const Scalar z14 = v_psi * s_psi;
    const Scalar z15 = s_theta * m2;
    const Scalar z16 = n0_05 * z6;
    const Scalar z17 = n0_05 * z3;
    const Scalar z18 = n0_05 * z13;
    const Scalar z19 = c_psi * z12 - s_theta * z14;
    const Scalar z20 = n0_05 * z14;
    const Scalar z21 = s_psi * z12 + s_theta * z13;
    const Scalar z22 = v_theta * z9;  // angular acceleration of tumbler.2, y
    const Scalar z23 = v_theta * z8;  // angular acceleration of tumbler.2, z
    const Scalar z24 = v_phi + z9;  // angular velocity of tumbler, z
    const Scalar z25 = z8 * z9;
    const Scalar z26 = z8 * z8;
    const Scalar z27 = s_psi * z2;
    const Scalar z28 = c_psi * z2;
    const Scalar z29 = k0 - s_theta * z15;
    const Scalar z30 = c_psi * z0;
    const Scalar z31 = s_psi * z0;
    const Scalar z32 = k3 * z4;
    const Scalar z33 = z0 * m3;
    const Scalar z34 = z8 * z24;
    const Scalar z35 = v_theta * z24;
    const Scalar z36 = k0 * z23;  // moment on tumbler, z
    const Scalar z37 = n2 * z22;
    const Scalar z38 = z10 + z26;
    const Scalar z39 = m1 * z25;  // force on tumbler.2, y
    const Scalar z40 = z27 * m3;
    const Scalar z41 = z28 * m3;
    const Scalar z42 = z27 * z33;
    const Scalar z43 = z28 * z33;
    const Scalar z44 = n0_2 - z0 * z33;
    const Scalar z45 = n1 / z1;
    const Scalar z46 = k0 * z34;  // moment on tumbler, x
    const Scalar z47 = k0 * z35;  // moment on tumbler, y
    const Scalar z48 = m1 * z37;  // force on tumbler.2, x
    const Scalar z49 = m1 * z38;  // force on tumbler.2, z
    const Scalar z50 = n0_2 - z27 * z40;
    const Scalar z51 = z27 * z41;
    const Scalar z52 = n0_2 - z28 * z41;
    const Scalar z53 = n0_05 * z19;
    const Scalar z54 = n0_05 * z21;
    const Scalar z55 = n1 / z44;
    const Scalar z56 = m0 * z25 - z46 - m1 * z11;  // moment on tumbler.2, x
    const Scalar z57 = m0 * z37 - z47;  // moment on tumbler.2, y
    const Scalar z58 = c_theta * z39 + s_theta * z49;
    const Scalar z59 = s_theta * z39 - c_theta * z49;
    const Scalar z60 = v_theta * z18 - v_phi * z53;
    const Scalar z61 = v_theta * z20 - v_phi * z54;
    const Scalar z62 = z17 * z32;
    const Scalar z63 = z5 * z33;
    const Scalar z64 = z16 * z32;
    const Scalar z65 = z7 * z33;
    const Scalar z66 = s_psi * z58 - c_psi * z48;
    const Scalar z67 = s_psi * z48 + c_psi * z58;
    const Scalar z68 = n1_962 - z59;  // force on tumbler.z, z
    const Scalar z69 = s_theta * z57;
    const Scalar z70 = z30 * z45;
    const Scalar z71 = z31 * z45;
    const Scalar z72 = z56 * z33 + z68;
    const Scalar z73 = z30 * z70 - z50;
    const Scalar z74 = z30 * z71 - z51;
    const Scalar z75 = z31 * z71 - z52;
    const Scalar z76 = z42 * z55;
    const Scalar z77 = z43 * z55;
    const Scalar z78 = z42 * z76 + z73;
    const Scalar z79 = z42 * z77 - z74;
    const Scalar z80 = z43 * z77 + z75;
    const Scalar z81 = z7 * z41 - z71 * z64 + z77 * z65;
    const Scalar z82 = n1 - z5 * z41 - z71 * z62 - z77 * z63;
    const Scalar z83 = z56 * z41 - z67 + z71 * z69 + z77 * z72;
    const Scalar z84 = n1 / z80;
    const Scalar z85 = z79 * z84;
    const Scalar z86 = z78 - z79 * z85;
    const Scalar z87 = z76 - z77 * z85;
    const Scalar z88 = n1 - z7 * z40 - z70 * z64 - z76 * z65 + z85 * z81;
    const Scalar z89 = z5 * z40 - z70 * z62 + z76 * z63 + z85 * z82;
    const Scalar z90 = z56 * z40 - z66 - z70 * z69 + z76 * z72 - z85 * z83;
    const Scalar z91 = n1 / z86;
    const Scalar z92 = z91 * z87;
    const Scalar z93 = z91 * z88;
    const Scalar z94 = z91 * z89;
    const Scalar z95 = z91 * z90;
    const Scalar z96 = z77 * z84 - z85 * z92;
    const Scalar z97 = z84 * z81 + z85 * z93;
    const Scalar z98 = z84 * z82 + z85 * z94;
    const Scalar z99 = z84 * z83 - z85 * z95;
    const Scalar z100 = z55 - z76 * z92 - z77 * z96;
    const Scalar z101 = z70 * z92 - z71 * z96;
    const Scalar z102 = z55 * z65 + z76 * z93 - z77 * z97;
    const Scalar z103 = z45 * z64 + z70 * z93 + z71 * z97;
    const Scalar z104 = z55 * z63 - z76 * z94 + z77 * z98;
    const Scalar z105 = z45 * z62 + z70 * z94 + z71 * z98;
    const Scalar z106 = z55 * z72 - z76 * z95 - z77 * z99;
    const Scalar z107 = z45 * z69 + z70 * z95 - z71 * z99;
    const Scalar z108 = z40 * z92 + z41 * z96 - z33 * z100;
    const Scalar z109 = z32 * z101;
    const Scalar z110 = z5 * m3 - z40 * z94 + z41 * z98 + z33 * z104;
    const Scalar z111 = z7 * m3 + z40 * z93 - z41 * z97 + z33 * z102;
    const Scalar z112 = z56 * m3 - z40 * z95 - z41 * z99 + z33 * z106;
    const Scalar z113 = k3 * z36 + z32 * z107;
    const Scalar z114 = z60 + z95 + z7 * z112 - z16 * z113;
    const Scalar z115 = z99 - z61 + z5 * z112 + z17 * z113;
    const Scalar z116 = k3 * z17 + z32 * z105;
    const Scalar z117 = k3 * z16 + z32 * z103;
    const Scalar z118 = z5 * z110 - z98 + z17 * z116;
    const Scalar z119 = z97 + z5 * z111 - z17 * z117;
    const Scalar z120 = z5 * z108 - z96 - z17 * z109;
    const Scalar z121 = n1 / z118;
    const Scalar z122 = z7 * z111 - z93 + z16 * z117;
    const Scalar z123 = z16 * z109 - z92 + z7 * z108;
    const Scalar z124 = z100 + z122 + z118;
    const Scalar z125 = z120 * z121;
    const Scalar z126 = z119 * z121;
    const Scalar z127 = z100 - z120 * z125;
    const Scalar z128 = z123 - z120 * z126;
    const Scalar z129 = z122 - z119 * z126;
    const Scalar z130 = z126 * z115 - z114;
    const Scalar z131 = n1 / z129;
    const Scalar z132 = z128 * z131;
    const Scalar z133 = z127 - z128 * z132;
    const Scalar z134 = z106 + z125 * z115 - z132 * z130;
    const Scalar z135 = n1 / z133;
    const Scalar z136 = z135 * z134;
    const Scalar z137 = z131 * z130 - z132 * z136;
    const Scalar z138 = z121 * z115 + z125 * z136 + z126 * z137;
    const Scalar z139 = z92 * z136 - z95 + z93 * z137 + z94 * z138;
    const Scalar z140 = z96 * z136 - z99 - z97 * z137 - z98 * z138;
    const Scalar z141 = z101 * z136 - z107 + z103 * z137 + z105 * z138;
    const Scalar z142 = z112 + z108 * z136 + z111 * z137 - z110 * z138;
    const Scalar z143 = z109 * z136 - z113 + z117 * z137 + z116 * z138;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.x = z139;
    accelerations.y = -z140;
    accelerations.z = n0;
    accelerations.psi = z141;
    accelerations.theta = z142;
    accelerations.phi = -z143;
    multipliers.N = z136;
    multipliers.X = -z137;
    multipliers.Y = -z138;
    const Scalar bound0_ = roundings_ * z124;
    if (!(traits::regular(-z86, n0_2) && traits::regular(-z80, n0_2) && traits::regular(z44, n0_2)
        && traits::regular(z1, z29) && traits::regular(m0, m0) && traits::regular(z133, bound0_)
        && traits::regular(z129, bound0_) && traits::regular(z118, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.psi * accelerations.theta
        * accelerations.phi * multipliers.N * multipliers.X * multipliers.Y;
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
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar k1 = traits::constant(7.5e-05, 7.5e-05f, "3/40000");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_962 = traits::constant(1.962, 1.962f, "981/500");
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
    const Scalar m0 = precomputed.m_fcfe008c;
    const Scalar m1 = precomputed.m_94eff1a0;
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
    const Scalar z4 = c_theta * m1;
    const Scalar z5 = v_theta * c_phi + s_phi * z2;
    const Scalar z6 = v_theta * s_phi - c_phi * z2;
    const Scalar z7 = v_phi + z3;  // angular velocity of tumbler, z
    const Scalar z8 = v_z * s_theta - c_theta * z0;
    const Scalar z9 = v_z * c_theta + s_theta * z0;
    const Scalar z10 = c_phi * z1 + s_phi * z8;
    const Scalar z11 = s_phi * z1 - c_phi * z8;
    const Scalar z12 = m1 * z6 + n0_2 * z10;
    const Scalar z13 = m1 * z5 - n0_2 * z11;
    const Scalar z14 = m0 * z5 - m1 * z11;
    const Scalar z15 = m0 * z6 + m1 * z10;
    result.kinetic = k1 * z7 * z7 + n0_1 * z9 * z9 + n0_5 * (z5 * z14 + z6 * z15 + z10 * z12 - z11 * z13);
    result.force_function = -n1_962 * q_z + n9_81 * z4;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
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
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = v_theta * c_theta;
    const Scalar z1 = v_psi * c_psi;
    const Scalar z2 = v_psi * s_psi;
    const Scalar z3 = n0_05 * s_psi;
    const Scalar z4 = n0_05 * c_psi;
    const Scalar z5 = s_psi * s_theta;
    const Scalar z6 = c_psi * s_theta;
    const Scalar z7 = n0_05 - q_z;
    const Scalar z8 = n0_05 * z6;
    const Scalar z9 = n0_05 * z5;
    const Scalar z10 = n0_05 * z1;
    const Scalar z11 = c_psi * z0 - s_theta * z2;
    const Scalar z12 = n0_05 * z2;
    const Scalar z13 = s_psi * z0 + s_theta * z1;
    const Scalar z14 = v_x - v_theta * z3 + v_phi * z8;
    const Scalar z15 = v_y + v_theta * z4 + v_phi * z9;
    const Scalar z16 = n0_05 * z11;
    const Scalar z17 = n0_05 * z13;
    const Scalar z18 = v_theta * z10 - v_phi * z16;
    const Scalar z19 = v_theta * z12 - v_phi * z17;
    result.value[0] = -z7;
    result.rate[0] = v_z;
    result.gamma[0] = n0;
    result.value[1] = n0;
    result.rate[1] = z14;
    result.gamma[1] = -z18;
    result.value[2] = n0;
    result.rate[2] = z15;
    result.gamma[2] = -z19;
    result.jacobian[0] = n0;
    result.jacobian[1] = n1;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = n0;
    result.jacobian[5] = n1;
    result.jacobian[6] = n1;
    result.jacobian[7] = n0;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = n0;
    result.jacobian[11] = n0;
    result.jacobian[12] = n0;
    result.jacobian[13] = -z3;
    result.jacobian[14] = z4;
    result.jacobian[15] = n0;
    result.jacobian[16] = z8;
    result.jacobian[17] = z9;
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

}  // namespace tumbler
