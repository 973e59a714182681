// SPDX-License-Identifier: MIT-0
// satellite_arms: Deployment of the arms of a satellite
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               12               44          0             0                  3       0     62      62
//   mass_matrix               4                8          0             0                  2       0     16      16
//   bias                     15               37          0             0                  2       0     56      58
//   inverse_dynamics         22               48          0             0                  2       0     74      76
//   forward_dynamics         21               48          1             0                  2       0     74      76
//   energy                   21               37          0             0                  2       0     62      70
//   first_integrals           4                9          0             0                  2       0     17      17
//   linearisation            59              136          1             0                  2       0    200     206
//
// Not computed because this mechanism does not need it:
//   kinematics: of 99 results 46 vanish identically, 12 repeat another up to sign
//   mass_matrix: of 9 results 6 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 84 results 49 vanish identically
//
// To write this file again:
//   satellite_arms_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output satellite_arms.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace satellite_arms {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"psi", "rad"}, {"theta_2", "rad"},
      {"theta_3", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"psi", "rad/s"}, {"theta_2", "rad/s"},
      {"theta_3", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> inputs{{{"Cm2", "N m"}, {"Cm3", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 37> results{{{"result", "S1_position", 3, 1, 1, "m"},
      {"result", "S1_rotation", 3, 3, 2, "1"}, {"result", "S1_velocity", 3, 1, 1, "m/s"}, {"result",
      "S1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S2_position", 3, 1, 1, "m"}, {"result", "S2_rotation", 3, 3,
      2, "1"}, {"result", "S2_velocity", 3, 1, 1, "m/s"}, {"result", "S2_angular_velocity", 3, 1, 1, "rad/s"},
      {"result", "S3_position", 3, 1, 1, "m"}, {"result", "S3_rotation", 3, 3, 2, "1"}, {"result", "S3_velocity", 3, 1,
      1, "m/s"}, {"result", "S3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "O_position", 3, 1, 1, "m"}, {"result",
      "O_velocity", 3, 1, 1, "m/s"}, {"result", "O_jacobian", 3, 3, 2, ""}, {"result", "O2_position", 3, 1, 1, "m"},
      {"result", "O2_velocity", 3, 1, 1, "m/s"}, {"result", "O2_jacobian", 3, 3, 2, "m"}, {"result", "O3_position", 3,
      1, 1, "m"}, {"result", "O3_velocity", 3, 1, 1, "m/s"}, {"result", "O3_jacobian", 3, 3, 2, "m"}, {"mass", "", 3, 3,
      2, "kg m^2"}, {"forces", "", 3, 1, 1, "N m"}, {"forces", "", 3, 1, 1, "N m"}, {"accelerations", "", 3, 1, 1,
      "rad/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1,
      1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "momentum_psi", 1, 1, 0, "N m s"}, {"result", "M", 3, 3,
      2, "kg m^2"}, {"result", "C", 3, 3, 2, "N m s"}, {"result", "K", 3, 3, 2, "N m"}, {"result", "F", 3, 1, 1, "N m"},
      {"result", "E", 3, 2, 2, "1"}, {"result", "A", 6, 6, 2, ""}, {"result", "B", 6, 2, 2, "1/kg/m^2"}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 21}, {"mass_matrix", false, false, false, false, results.data() + 21, 1}, {"bias", false,
      false, false, false, results.data() + 22, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 23,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 24, 2}, {"energy", false, false, true, false,
      results.data() + 26, 3}, {"first_integrals", false, false, false, false, results.data() + 29, 1},
      {"linearisation", true, true, true, true, results.data() + 30, 7}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::satellite_arms::Description;

  static constexpr const char* name = "satellite_arms";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x85c2b55a544feec3ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 3;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 2;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar psi;  ///< coordinate [rad]
    Scalar theta_2;  ///< coordinate [rad]
    Scalar theta_3;  ///< coordinate [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::psi, &Coordinates::theta_2, &Coordinates::theta_3};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta_2;  ///< its rate [rad/s]
    Scalar theta_3;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::psi, &Velocities::theta_2, &Velocities::theta_3};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta_2;  ///< its second rate [rad/s^2]
    Scalar theta_3;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::psi, &Accelerations::theta_2,
          &Accelerations::theta_3};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta_2;  ///< works with the rate of theta_2 [N m]
    Scalar theta_3;  ///< works with the rate of theta_3 [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::psi, &GeneralizedForces::theta_2,
          &GeneralizedForces::theta_3};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar Cm2;  ///< motor [N m]
    Scalar Cm3;  ///< motor [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::Cm2, &Inputs::Cm3};
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
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    state.time = n0;
    state.q.psi = n0;
    state.q.theta_2 = n0_05;
    state.q.theta_3 = -n0_05;
    state.v.psi = n3;
    state.v.theta_2 = n0;
    state.v.theta_3 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> S1_position;  ///< centre of mass of S1 [m]
    std::array<Scalar, 9> S1_rotation;  ///< from the axes of S1 to the ground's (3 x 3)
    std::array<Scalar, 3> S1_velocity;  ///< velocity of the centre of mass of S1 [m/s]
    std::array<Scalar, 3> S1_angular_velocity;  ///< angular velocity of S1 [rad/s]
    std::array<Scalar, 3> S2_position;  ///< centre of mass of S2 [m]
    std::array<Scalar, 9> S2_rotation;  ///< from the axes of S2 to the ground's (3 x 3)
    std::array<Scalar, 3> S2_velocity;  ///< velocity of the centre of mass of S2 [m/s]
    std::array<Scalar, 3> S2_angular_velocity;  ///< angular velocity of S2 [rad/s]
    std::array<Scalar, 3> S3_position;  ///< centre of mass of S3 [m]
    std::array<Scalar, 9> S3_rotation;  ///< from the axes of S3 to the ground's (3 x 3)
    std::array<Scalar, 3> S3_velocity;  ///< velocity of the centre of mass of S3 [m/s]
    std::array<Scalar, 3> S3_angular_velocity;  ///< angular velocity of S3 [rad/s]
    std::array<Scalar, 3> O_position;  ///< position of O [m]
    std::array<Scalar, 3> O_velocity;  ///< velocity of the material point at O [m/s]
    std::array<Scalar, 9> O_jacobian;  ///< partial velocities of O (3 x 3)
    std::array<Scalar, 3> O2_position;  ///< position of O2 [m]
    std::array<Scalar, 3> O2_velocity;  ///< velocity of the material point at O2 [m/s]
    std::array<Scalar, 9> O2_jacobian;  ///< partial velocities of O2 (3 x 3)
    std::array<Scalar, 3> O3_position;  ///< position of O3 [m]
    std::array<Scalar, 3> O3_velocity;  ///< velocity of the material point at O3 [m/s]
    std::array<Scalar, 9> O3_jacobian;  ///< partial velocities of O3 (3 x 3)
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
    Scalar momentum_psi;  ///< dT/dpsi' of the cyclic coordinate 'psi' [N m s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::momentum_psi};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 9> M;  ///< mass matrix (3 x 3)
    std::array<Scalar, 9> C;  ///< damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 9> K;  ///< stiffness (3 x 3)
    std::array<Scalar, 3> F;  ///< right-hand side
    std::array<Scalar, 6> E;  ///< effect of the inputs (3 x 2)
    std::array<Scalar, 36> A;  ///< state matrix of x = (e, e'): x' = A x + B du (6 x 6)
    std::array<Scalar, 12> B;  ///< input matrix (6 x 2)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar q_theta_3 = state.q.theta_3;
    const Scalar v_theta_3 = state.v.theta_3;
    const Scalar angles_[] = {q_psi, q_theta_2, q_theta_3};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar s_theta_3 = sines_[2], c_theta_3 = cosines_[2];
    const Scalar z0 = n0_3 * v_psi;
    const Scalar z1 = n0_35 * v_psi;
    const Scalar z2 = v_psi * s_theta_3;
    const Scalar z3 = c_psi * c_theta_2;
    const Scalar z4 = s_psi * c_theta_2;
    const Scalar z5 = s_psi * c_theta_3;
    const Scalar z6 = s_psi * z0;  // velocity of S2, x
    const Scalar z7 = c_psi * z0;  // velocity of S2, y
    const Scalar z8 = s_psi * z1;  // velocity of S3, x
    const Scalar z9 = c_psi * z1;  // velocity of S3, y
    const Scalar z10 = n0_5 * v_theta_2;
    const Scalar z11 = n0_45 * v_theta_3;
    const Scalar z12 = v_psi * s_theta_2;
    const Scalar z13 = c_psi * s_theta_2;
    const Scalar z14 = s_psi * s_theta_2;
    const Scalar z15 = c_psi * s_theta_3;
    const Scalar z16 = s_psi * s_theta_3;
    const Scalar z17 = c_psi * c_theta_3;
    const Scalar z18 = n0_3 * c_psi;
    const Scalar z19 = n0_3 * s_psi;
    const Scalar z20 = n0_35 * c_psi;
    const Scalar z21 = n0_35 * s_psi;
    const Scalar z22 = s_psi * v_theta_2;  // angular velocity of S2, x
    const Scalar z23 = c_psi * v_theta_2;  // angular velocity of S2, y
    const Scalar z24 = s_psi * v_theta_3;  // angular velocity of S3, x
    const Scalar z25 = c_psi * v_theta_3;  // angular velocity of S3, y
    const Scalar z26 = n0_5 * c_theta_2;
    const Scalar z27 = s_theta_2 * z10;
    const Scalar z28 = n0_45 * c_theta_3;
    const Scalar z29 = s_theta_3 * z11;
    const Scalar z30 = n0_5 * z13;
    const Scalar z31 = n0_5 * z14;
    const Scalar z32 = n0_5 * z12;
    const Scalar z33 = n0_45 * z15;
    const Scalar z34 = n0_45 * z16;
    const Scalar z35 = n0_45 * z2;
    const Scalar z36 = z18 + z30;
    const Scalar z37 = z19 + z31;
    const Scalar z38 = z6 - z3 * z10 + s_psi * z32;
    const Scalar z39 = z4 * z10 + z7 + c_psi * z32;
    const Scalar z40 = z20 - z33;
    const Scalar z41 = z21 - z34;
    const Scalar z42 = s_psi * z35 - z8 - z17 * z11;
    const Scalar z43 = z5 * z11 - z9 + c_psi * z35;
    result.S1_position[0] = n0;
    result.S1_position[1] = n0;
    result.S1_position[2] = n0_1;
    result.S1_rotation[0] = c_psi;
    result.S1_rotation[1] = s_psi;
    result.S1_rotation[2] = n0;
    result.S1_rotation[3] = -s_psi;
    result.S1_rotation[4] = c_psi;
    result.S1_rotation[5] = n0;
    result.S1_rotation[6] = n0;
    result.S1_rotation[7] = n0;
    result.S1_rotation[8] = n1;
    result.S1_velocity[0] = n0;
    result.S1_velocity[1] = n0;
    result.S1_velocity[2] = n0;
    result.S1_angular_velocity[0] = n0;
    result.S1_angular_velocity[1] = n0;
    result.S1_angular_velocity[2] = v_psi;
    result.S2_position[0] = z36;
    result.S2_position[1] = z37;
    result.S2_position[2] = z26;
    result.S2_rotation[0] = z3;
    result.S2_rotation[1] = z4;
    result.S2_rotation[2] = -s_theta_2;
    result.S2_rotation[3] = -s_psi;
    result.S2_rotation[4] = c_psi;
    result.S2_rotation[5] = n0;
    result.S2_rotation[6] = z13;
    result.S2_rotation[7] = z14;
    result.S2_rotation[8] = c_theta_2;
    result.S2_velocity[0] = -z38;
    result.S2_velocity[1] = z39;
    result.S2_velocity[2] = -z27;
    result.S2_angular_velocity[0] = -z22;
    result.S2_angular_velocity[1] = z23;
    result.S2_angular_velocity[2] = v_psi;
    result.S3_position[0] = -z40;
    result.S3_position[1] = -z41;
    result.S3_position[2] = z28;
    result.S3_rotation[0] = z17;
    result.S3_rotation[1] = z5;
    result.S3_rotation[2] = -s_theta_3;
    result.S3_rotation[3] = -s_psi;
    result.S3_rotation[4] = c_psi;
    result.S3_rotation[5] = n0;
    result.S3_rotation[6] = z15;
    result.S3_rotation[7] = z16;
    result.S3_rotation[8] = c_theta_3;
    result.S3_velocity[0] = -z42;
    result.S3_velocity[1] = z43;
    result.S3_velocity[2] = -z29;
    result.S3_angular_velocity[0] = -z24;
    result.S3_angular_velocity[1] = z25;
    result.S3_angular_velocity[2] = v_psi;
    result.O_position[0] = n0;
    result.O_position[1] = n0;
    result.O_position[2] = n0;
    result.O_velocity[0] = n0;
    result.O_velocity[1] = n0;
    result.O_velocity[2] = n0;
    result.O_jacobian[0] = n0;
    result.O_jacobian[3] = n0;
    result.O_jacobian[6] = n0;
    result.O_jacobian[1] = n0;
    result.O_jacobian[4] = n0;
    result.O_jacobian[7] = n0;
    result.O_jacobian[2] = n0;
    result.O_jacobian[5] = n0;
    result.O_jacobian[8] = n0;
    result.O2_position[0] = z18;
    result.O2_position[1] = z19;
    result.O2_position[2] = n0;
    result.O2_velocity[0] = -z6;
    result.O2_velocity[1] = z7;
    result.O2_velocity[2] = n0;
    result.O2_jacobian[0] = -z19;
    result.O2_jacobian[3] = n0;
    result.O2_jacobian[6] = n0;
    result.O2_jacobian[1] = z18;
    result.O2_jacobian[4] = n0;
    result.O2_jacobian[7] = n0;
    result.O2_jacobian[2] = n0;
    result.O2_jacobian[5] = n0;
    result.O2_jacobian[8] = n0;
    result.O3_position[0] = -z20;
    result.O3_position[1] = -z21;
    result.O3_position[2] = n0;
    result.O3_velocity[0] = z8;
    result.O3_velocity[1] = -z9;
    result.O3_velocity[2] = n0;
    result.O3_jacobian[0] = z21;
    result.O3_jacobian[3] = n0;
    result.O3_jacobian[6] = n0;
    result.O3_jacobian[1] = -z20;
    result.O3_jacobian[4] = n0;
    result.O3_jacobian[7] = n0;
    result.O3_jacobian[2] = n0;
    result.O3_jacobian[5] = n0;
    result.O3_jacobian[8] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 9>& mass) noexcept {
    const Scalar n109_over_160 = traits::constant(0.68125, 0.68125f, "109/160");
    const Scalar n0_3375 = traits::constant(0.3375, 0.3375f, "27/80");
    const Scalar n0_666 = traits::constant(0.666, 0.666f, "333/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n7_over_3 = traits::constant(2.3333333333333335, 2.3333333f, "7/3");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k6 = traits::constant(1.39525, 1.39525f, "5581/4000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_668 = traits::constant(0.668, 0.668f, "167/250");
    const Scalar k9 = traits::constant(0.68225, 0.68225f, "2729/4000");
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar q_theta_3 = state.q.theta_3;
    const Scalar angles_[] = {q_theta_2, q_theta_3};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_2 = sines_[0];
    const Scalar s_theta_3 = sines_[1];
    const Scalar z0 = n109_over_160 * s_theta_3;
    const Scalar z1 = n0_3375 * s_theta_3;
    const Scalar z2 = n0_666 * s_theta_2;
    const Scalar z3 = n0_3 * s_theta_2;
    const Scalar z4 = s_theta_3 * z0;
    const Scalar z5 = s_theta_2 * z2;
    const Scalar z6 = n7_over_3 * z1 - z4;
    const Scalar z7 = n2 * z3 + z5;
    const Scalar z8 = k6 - z6;
    const Scalar z9 = z8 + z7;
    mass[0] = z9;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0_668;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = k9;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n7_over_6 = traits::constant(1.1666666666666667, 1.1666666f, "7/6");
    const Scalar n32_7 = traits::constant(32.7, 32.7f, "327/10");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n35 = traits::constant(35.0, 35.0f, "35/1");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1_3635 = traits::constant(1.3635, 1.3635f, "2727/2000");
    const Scalar n0_001 = traits::constant(0.001, 0.001f, "1/1000");
    const Scalar n1_334 = traits::constant(1.334, 1.334f, "667/500");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n109_over_160 = traits::constant(0.68125, 0.68125f, "109/160");
    const Scalar n0_3375 = traits::constant(0.3375, 0.3375f, "27/80");
    const Scalar n0_666 = traits::constant(0.666, 0.666f, "333/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar q_theta_3 = state.q.theta_3;
    const Scalar v_theta_3 = state.v.theta_3;
    const Scalar angles_[] = {q_theta_2, q_theta_3};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_2 = sines_[0], c_theta_2 = cosines_[0];
    const Scalar s_theta_3 = sines_[1], c_theta_3 = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(1.5707963267948966, 1.5707964f, [&]() -> Scalar {
      return n0_5 * pi;
    });
    const Scalar z1 = v_psi * c_theta_2;
    const Scalar z2 = v_psi * c_theta_3;
    const Scalar z3 = v_psi * s_theta_3;
    const Scalar z4 = v_psi * v_psi;
    const Scalar z5 = v_psi * s_theta_2;
    const Scalar z6 = q_theta_2 - z0;
    const Scalar z7 = n7_over_6 * z4;
    const Scalar z8 = q_theta_3 + z0;
    const Scalar z9 = n32_7 * s_theta_2 + c_theta_2 * z4;
    const Scalar z10 = n30 * z6;
    const Scalar z11 = n32_7 * s_theta_3 - c_theta_3 * z7;
    const Scalar z12 = n35 * z8;
    const Scalar z13 = n5 * v_theta_2;
    const Scalar z14 = n6 * v_theta_3;
    const Scalar z15 = v_theta_2 * z1;  // angular acceleration of S2, x
    const Scalar z16 = v_theta_2 * z5;  // angular acceleration of S2, z
    const Scalar z17 = v_theta_3 * z2;  // angular acceleration of S3, x
    const Scalar z18 = v_theta_3 * z3;  // angular acceleration of S3, z
    const Scalar z19 = z3 * z2;
    const Scalar z20 = z5 * z1;
    const Scalar z21 = n2 * z17;
    const Scalar z22 = n1_3635 * z17;  // moment on S3, x
    const Scalar z23 = n0_001 * z18;  // moment on S3, z
    const Scalar z24 = n2 * z15;
    const Scalar z25 = n1_334 * z15;  // moment on S2, x
    const Scalar z26 = n0_002 * z16;  // moment on S2, z
    const Scalar z27 = n109_over_160 * z19 + n0_3375 * z11;  // moment on S3, y
    const Scalar z28 = n0_666 * z20 + n0_3 * z9;  // moment on S2, y
    const Scalar z29 = n0_3375 * z21;  // force on S3, times 0.3 m, y
    const Scalar z30 = s_theta_3 * z22 - c_theta_3 * z23;
    const Scalar z31 = n0_3 * z24;  // force on S2, times 0.3 m, y
    const Scalar z32 = s_theta_2 * z25 - c_theta_2 * z26;
    const Scalar z33 = z10 + z13 - z28;
    const Scalar z34 = z12 + z14 - z27;
    const Scalar z35 = n7_over_6 * z29 - z31 - z30 - z32;  // moment on S1, z
    forces.psi = -z35;
    forces.theta_2 = z33;
    forces.theta_3 = z34;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n109_over_160 = traits::constant(0.68125, 0.68125f, "109/160");
    const Scalar n7_over_6 = traits::constant(1.1666666666666667, 1.1666666f, "7/6");
    const Scalar n0_3375 = traits::constant(0.3375, 0.3375f, "27/80");
    const Scalar n0_666 = traits::constant(0.666, 0.666f, "333/500");
    const Scalar n32_7 = traits::constant(32.7, 32.7f, "327/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n35 = traits::constant(35.0, 35.0f, "35/1");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n0_001 = traits::constant(0.001, 0.001f, "1/1000");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n7_over_3 = traits::constant(2.3333333333333335, 2.3333333f, "7/3");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1_3635 = traits::constant(1.3635, 1.3635f, "2727/2000");
    const Scalar n1_334 = traits::constant(1.334, 1.334f, "667/500");
    const Scalar k17 = traits::constant(1.39525, 1.39525f, "5581/4000");
    const Scalar n0_668 = traits::constant(0.668, 0.668f, "167/250");
    const Scalar k19 = traits::constant(0.68225, 0.68225f, "2729/4000");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar q_theta_3 = state.q.theta_3;
    const Scalar v_theta_3 = state.v.theta_3;
    const Scalar a_theta_3 = accelerations.theta_3;
    const Scalar angles_[] = {q_theta_2, q_theta_3};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_2 = sines_[0], c_theta_2 = cosines_[0];
    const Scalar s_theta_3 = sines_[1], c_theta_3 = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(1.5707963267948966, 1.5707964f, [&]() -> Scalar {
      return n0_5 * pi;
    });
    const Scalar z1 = v_psi * c_theta_2;
    const Scalar z2 = v_psi * c_theta_3;
    const Scalar z3 = v_psi * s_theta_3;
    const Scalar z4 = v_psi * v_psi;
    const Scalar z5 = v_psi * s_theta_2;
    const Scalar z6 = n109_over_160 * s_theta_3;
    const Scalar z7 = n7_over_6 * z4;
    const Scalar z8 = n0_3375 * s_theta_3;
    const Scalar z9 = n0_666 * s_theta_2;
    const Scalar z10 = q_theta_2 - z0;
    const Scalar z11 = q_theta_3 + z0;
    const Scalar z12 = n32_7 * s_theta_2 + c_theta_2 * z4;
    const Scalar z13 = n32_7 * s_theta_3 - c_theta_3 * z7;
    const Scalar z14 = n0_3 * s_theta_2;
    const Scalar z15 = n30 * z10;
    const Scalar z16 = n35 * z11;
    const Scalar z17 = n5 * v_theta_2;
    const Scalar z18 = n6 * v_theta_3;
    const Scalar z19 = z3 * z2;
    const Scalar z20 = v_theta_3 * z2;
    const Scalar z21 = v_theta_3 * z3;
    const Scalar z22 = z5 * z1;
    const Scalar z23 = v_theta_2 * z1;
    const Scalar z24 = v_theta_2 * z5;
    const Scalar z25 = s_theta_3 * z6;
    const Scalar z26 = s_theta_2 * z9;
    const Scalar z27 = n0_001 * z21;  // moment on S3, z
    const Scalar z28 = n0_002 * z24;  // moment on S2, z
    const Scalar z29 = n7_over_3 * z8 - z25;
    const Scalar z30 = n2 * z14 + z26;
    const Scalar z31 = n2 * z20;
    const Scalar z32 = n1_3635 * z20;  // moment on S3, x
    const Scalar z33 = n2 * z23;
    const Scalar z34 = n1_334 * z23;  // moment on S2, x
    const Scalar z35 = n109_over_160 * z19 + n0_3375 * z13;  // moment on S3, y
    const Scalar z36 = n0_666 * z22 + n0_3 * z12;  // moment on S2, y
    const Scalar z37 = n0_3375 * z31;  // force on S3, times 0.3 m, y
    const Scalar z38 = s_theta_3 * z32 - c_theta_3 * z27;
    const Scalar z39 = n0_3 * z33;  // force on S2, times 0.3 m, y
    const Scalar z40 = s_theta_2 * z34 - c_theta_2 * z28;
    const Scalar z41 = k17 - z29;
    const Scalar z42 = z41 + z30;
    const Scalar z43 = z15 + z17 - z36;
    const Scalar z44 = z16 + z18 - z35;
    const Scalar z45 = n7_over_6 * z37 - z39 - z38 - z40;  // moment on S1, z
    const Scalar z46 = n0_668 * a_theta_2 + z43;
    const Scalar z47 = k19 * a_theta_3 + z44;
    const Scalar z48 = a_psi * z42 - z45;
    forces.psi = z48;
    forces.theta_2 = z46;
    forces.theta_3 = z47;
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n109_over_160 = traits::constant(0.68125, 0.68125f, "109/160");
    const Scalar n0_3375 = traits::constant(0.3375, 0.3375f, "27/80");
    const Scalar n0_666 = traits::constant(0.666, 0.666f, "333/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n7_over_6 = traits::constant(1.1666666666666667, 1.1666666f, "7/6");
    const Scalar n32_7 = traits::constant(32.7, 32.7f, "327/10");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n35 = traits::constant(35.0, 35.0f, "35/1");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n7_over_3 = traits::constant(2.3333333333333335, 2.3333333f, "7/3");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1_3635 = traits::constant(1.3635, 1.3635f, "2727/2000");
    const Scalar n0_001 = traits::constant(0.001, 0.001f, "1/1000");
    const Scalar n1_334 = traits::constant(1.334, 1.334f, "667/500");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar k17 = traits::constant(1.39525, 1.39525f, "5581/4000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n250_over_167 = traits::constant(1.4970059880239521, 1.4970059f, "250/167");
    const Scalar k20 = traits::constant(1.4657383657017222, 1.4657384f, "4000/2729");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar q_theta_3 = state.q.theta_3;
    const Scalar v_theta_3 = state.v.theta_3;
    const Scalar u_Cm2 = inputs.Cm2;
    const Scalar u_Cm3 = inputs.Cm3;
    const Scalar angles_[] = {q_theta_2, q_theta_3};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_2 = sines_[0], c_theta_2 = cosines_[0];
    const Scalar s_theta_3 = sines_[1], c_theta_3 = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(1.5707963267948966, 1.5707964f, [&]() -> Scalar {
      return n0_5 * pi;
    });
    const Scalar z1 = n109_over_160 * s_theta_3;
    const Scalar z2 = n0_3375 * s_theta_3;
    const Scalar z3 = n0_666 * s_theta_2;
    const Scalar z4 = n0_3 * s_theta_2;
    const Scalar z5 = v_psi * c_theta_2;
    const Scalar z6 = v_psi * c_theta_3;
    const Scalar z7 = v_psi * v_psi;
    const Scalar z8 = v_psi * s_theta_2;
    const Scalar z9 = v_psi * s_theta_3;
    const Scalar z10 = n7_over_6 * z7;
    const Scalar z11 = q_theta_2 - z0;
    const Scalar z12 = q_theta_3 + z0;
    const Scalar z13 = n32_7 * s_theta_2 + c_theta_2 * z7;
    const Scalar z14 = n32_7 * s_theta_3 - c_theta_3 * z10;
    const Scalar z15 = n30 * z11;
    const Scalar z16 = n35 * z12;
    const Scalar z17 = n5 * v_theta_2;
    const Scalar z18 = n6 * v_theta_3;
    const Scalar z19 = s_theta_3 * z1;
    const Scalar z20 = s_theta_2 * z3;
    const Scalar z21 = v_theta_2 * z5;  // angular acceleration of S2, x
    const Scalar z22 = v_theta_2 * z8;  // angular acceleration of S2, z
    const Scalar z23 = v_theta_3 * z6;  // angular acceleration of S3, x
    const Scalar z24 = v_theta_3 * z9;  // angular acceleration of S3, z
    const Scalar z25 = z9 * z6;
    const Scalar z26 = z8 * z5;
    const Scalar z27 = z19 - n7_over_3 * z2;
    const Scalar z28 = z20 + n2 * z4;
    const Scalar z29 = n2 * z23;
    const Scalar z30 = n1_3635 * z23;
    const Scalar z31 = n0_001 * z24;
    const Scalar z32 = n2 * z21;
    const Scalar z33 = n1_334 * z21;
    const Scalar z34 = n0_002 * z22;
    const Scalar z35 = n109_over_160 * z25 + n0_3375 * z14;
    const Scalar z36 = n0_666 * z26 + n0_3 * z13;
    const Scalar z37 = n0_3375 * z29;
    const Scalar z38 = s_theta_3 * z30 - c_theta_3 * z31;
    const Scalar z39 = n0_3 * z32;
    const Scalar z40 = s_theta_2 * z33 - c_theta_2 * z34;
    const Scalar z41 = k17 + z27;
    const Scalar z42 = z41 + z28;
    const Scalar z43 = z15 + z17 - z36;
    const Scalar z44 = z16 + z18 - z35;
    const Scalar z45 = n1 / z42;
    const Scalar z46 = n7_over_6 * z37 - z39 - z38 - z40;
    const Scalar z47 = u_Cm2 - z43;
    const Scalar z48 = u_Cm3 - z44;
    const Scalar z49 = n250_over_167 * z47;
    const Scalar z50 = k20 * z48;
    const Scalar z51 = z45 * z46;
    accelerations.psi = z51;
    accelerations.theta_2 = z49;
    accelerations.theta_3 = z50;
    if (!(traits::regular(z42, z42))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.psi * accelerations.theta_2 * accelerations.theta_3;
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_125 = traits::constant(1.125, 1.125f, "9/8");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_67 = traits::constant(0.67, 0.67f, "67/100");
    const Scalar n2_5 = traits::constant(2.5, 2.5f, "5/2");
    const Scalar n549_over_800 = traits::constant(0.68625, 0.68625f, "549/800");
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n0_334 = traits::constant(0.334, 0.334f, "167/500");
    const Scalar k12 = traits::constant(0.341125, 0.341125f, "2729/8000");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n0_0025 = traits::constant(0.0025, 0.0025f, "1/400");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    const Scalar n17_5 = traits::constant(17.5, 17.5f, "35/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar q_theta_3 = state.q.theta_3;
    const Scalar v_theta_3 = state.v.theta_3;
    const Scalar u_Cm2 = inputs.Cm2;
    const Scalar u_Cm3 = inputs.Cm3;
    const Scalar angles_[] = {q_theta_2, q_theta_3};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_2 = sines_[0], c_theta_2 = cosines_[0];
    const Scalar s_theta_3 = sines_[1], c_theta_3 = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(1.5707963267948966, 1.5707964f, [&]() -> Scalar {
      return n0_5 * pi;
    });
    const Scalar z1 = n0_35 * v_psi;
    const Scalar z2 = n0_3 * v_psi;
    const Scalar z3 = v_psi * s_theta_2;
    const Scalar z4 = v_psi * s_theta_3;
    const Scalar z5 = v_psi * c_theta_2;
    const Scalar z6 = v_psi * c_theta_3;
    const Scalar z7 = n1_125 * c_theta_3;
    const Scalar z8 = q_theta_2 - z0;
    const Scalar z9 = q_theta_3 + z0;
    const Scalar z10 = n5 * v_theta_2;
    const Scalar z11 = n6 * v_theta_3;
    const Scalar z12 = n2 * z2 + z3;
    const Scalar z13 = z2 + n0_67 * z3;
    const Scalar z14 = n2_5 * z1 - n1_125 * z4;
    const Scalar z15 = n1_125 * z1 - n549_over_800 * z4;
    result.kinetic = n0_45 * v_psi * v_psi + n0_334 * v_theta_2 * v_theta_2 + k12 * v_theta_3 * v_theta_3 + n0_002 * z5
        * z5 + n0_0025 * z6 * z6 + n0_5 * (z2 * z12 + z3 * z13 + z1 * z14 - z4 * z15);
    result.force_function = -n19_62 - n15 * z8 * z8 - n17_5 * z9 * z9 - n9_81 * (c_theta_2 + z7);
    result.power = v_theta_2 * (u_Cm2 - z10) + v_theta_3 * (u_Cm3 - z11);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n109_over_160 = traits::constant(0.68125, 0.68125f, "109/160");
    const Scalar n0_3375 = traits::constant(0.3375, 0.3375f, "27/80");
    const Scalar n0_666 = traits::constant(0.666, 0.666f, "333/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n7_over_3 = traits::constant(2.3333333333333335, 2.3333333f, "7/3");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k6 = traits::constant(1.39525, 1.39525f, "5581/4000");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar q_theta_3 = state.q.theta_3;
    const Scalar angles_[] = {q_theta_2, q_theta_3};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_2 = sines_[0];
    const Scalar s_theta_3 = sines_[1];
    const Scalar z0 = n109_over_160 * s_theta_3;
    const Scalar z1 = n0_3375 * s_theta_3;
    const Scalar z2 = n0_666 * s_theta_2;
    const Scalar z3 = n0_3 * s_theta_2;
    const Scalar z4 = s_theta_3 * z0;
    const Scalar z5 = s_theta_2 * z2;
    const Scalar z6 = n7_over_3 * z1 - z4;
    const Scalar z7 = n2 * z3 + z5;
    const Scalar z8 = k6 - z6;
    const Scalar z9 = z8 + z7;
    result.momentum_psi = v_psi * z9;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs& inputs, Linearisation& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n109_over_160 = traits::constant(0.68125, 0.68125f, "109/160");
    const Scalar n0_3375 = traits::constant(0.3375, 0.3375f, "27/80");
    const Scalar n0_666 = traits::constant(0.666, 0.666f, "333/500");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n7_over_6 = traits::constant(1.1666666666666667, 1.1666666f, "7/6");
    const Scalar n32_7 = traits::constant(32.7, 32.7f, "327/10");
    const Scalar n30 = traits::constant(30.0, 30.0f, "30/1");
    const Scalar n35 = traits::constant(35.0, 35.0f, "35/1");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n6 = traits::constant(6.0, 6.0f, "6/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1_3635 = traits::constant(1.3635, 1.3635f, "2727/2000");
    const Scalar n0_001 = traits::constant(0.001, 0.001f, "1/1000");
    const Scalar n1_334 = traits::constant(1.334, 1.334f, "667/500");
    const Scalar n0_002 = traits::constant(0.002, 0.002f, "1/500");
    const Scalar n7_over_3 = traits::constant(2.3333333333333335, 2.3333333f, "7/3");
    const Scalar n0_668 = traits::constant(0.668, 0.668f, "167/250");
    const Scalar k18 = traits::constant(0.68225, 0.68225f, "2729/4000");
    const Scalar k19 = traits::constant(1.39525, 1.39525f, "5581/4000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n250_over_167 = traits::constant(1.4970059880239521, 1.4970059f, "250/167");
    const Scalar k22 = traits::constant(1.4657383657017222, 1.4657384f, "4000/2729");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k24 = traits::constant(7.485029940119761, 7.48503f, "1250/167");
    const Scalar k25 = traits::constant(8.794430194210333, 8.79443f, "24000/2729");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar q_theta_3 = state.q.theta_3;
    const Scalar v_theta_3 = state.v.theta_3;
    const Scalar a_theta_3 = accelerations.theta_3;
    const Scalar u_Cm2 = inputs.Cm2;
    const Scalar u_Cm3 = inputs.Cm3;
    const Scalar angles_[] = {q_theta_2, q_theta_3};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_2 = sines_[0], c_theta_2 = cosines_[0];
    const Scalar s_theta_3 = sines_[1], c_theta_3 = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(1.5707963267948966, 1.5707964f, [&]() -> Scalar {
      return n0_5 * pi;
    });
    const Scalar z1 = n109_over_160 * s_theta_3;
    const Scalar z2 = v_psi * s_theta_3;
    const Scalar z3 = v_psi * s_theta_2;
    const Scalar z4 = n0_3375 * s_theta_3;
    const Scalar z5 = n0_666 * s_theta_2;
    const Scalar z6 = v_psi * c_theta_3;
    const Scalar z7 = v_psi * v_psi;
    const Scalar z8 = v_psi * c_theta_2;
    const Scalar z9 = n0_3 * s_theta_2;
    const Scalar z10 = n7_over_6 * z7;
    const Scalar z11 = v_theta_3 * c_theta_3;
    const Scalar z12 = n109_over_160 * c_theta_3;
    const Scalar z13 = n0_666 * c_theta_2;
    const Scalar z14 = v_theta_3 * s_theta_3;
    const Scalar z15 = q_theta_2 - z0;
    const Scalar z16 = q_theta_3 + z0;
    const Scalar z17 = s_theta_2 * z7 - n32_7 * c_theta_2;
    const Scalar z18 = s_theta_3 * z10 + n32_7 * c_theta_3;
    const Scalar z19 = n32_7 * s_theta_2 + c_theta_2 * z7;
    const Scalar z20 = n32_7 * s_theta_3 - c_theta_3 * z10;
    const Scalar z21 = n0_3375 * c_theta_3;
    const Scalar z22 = n0_3 * c_theta_2;
    const Scalar z23 = n30 * z15;
    const Scalar z24 = n35 * z16;
    const Scalar z25 = v_theta_2 * c_theta_2;
    const Scalar z26 = n5 * v_theta_2;
    const Scalar z27 = n6 * v_theta_3;
    const Scalar z28 = n2 * v_psi;
    const Scalar z29 = v_theta_2 * s_theta_2;
    const Scalar z30 = n7_over_6 * z28;
    const Scalar z31 = c_theta_2 * z28;
    const Scalar z32 = c_theta_3 * z30;
    const Scalar z33 = z2 * z6;
    const Scalar z34 = v_theta_3 * z6;
    const Scalar z35 = v_theta_3 * z2;
    const Scalar z36 = z3 * z8;
    const Scalar z37 = v_theta_2 * z8;
    const Scalar z38 = v_theta_2 * z3;
    const Scalar z39 = s_theta_3 * z1;
    const Scalar z40 = s_theta_2 * z5;
    const Scalar z41 = n2 * z11;
    const Scalar z42 = n1_3635 * z11;
    const Scalar z43 = n0_001 * z14;
    const Scalar z44 = n2 * z25;
    const Scalar z45 = n1_334 * z25;
    const Scalar z46 = n0_002 * z29;
    const Scalar z47 = s_theta_2 * z8 + c_theta_2 * z3;
    const Scalar z48 = s_theta_3 * z6 + c_theta_3 * z2;
    const Scalar z49 = n2 * z8;
    const Scalar z50 = n0_001 * z35;  // moment on S3, z
    const Scalar z51 = n1_334 * z8;
    const Scalar z52 = n0_002 * z3;
    const Scalar z53 = n0_002 * z38;  // moment on S2, z
    const Scalar z54 = s_theta_2 * z13 + c_theta_2 * z5;
    const Scalar z55 = n7_over_3 * z4 - z39;
    const Scalar z56 = n2 * z9 + z40;
    const Scalar z57 = n2 * z34;
    const Scalar z58 = n1_3635 * z34;  // moment on S3, x
    const Scalar z59 = n2 * z37;
    const Scalar z60 = n1_334 * z37;  // moment on S2, x
    const Scalar z61 = n0_3375 * z41;
    const Scalar z62 = s_theta_3 * z42 - c_theta_3 * z43;
    const Scalar z63 = n0_3 * z44;
    const Scalar z64 = s_theta_2 * z45 - c_theta_2 * z46;
    const Scalar z65 = n0_3 * z49;
    const Scalar z66 = s_theta_2 * z51 - c_theta_2 * z52;
    const Scalar z67 = n2 * z38;
    const Scalar z68 = n1_334 * z38;
    const Scalar z69 = n0_002 * z37;
    const Scalar z70 = n109_over_160 * z33 + n0_3375 * z20;  // moment on S3, y
    const Scalar z71 = n0_666 * z36 + n0_3 * z19;  // moment on S2, y
    const Scalar z72 = n0_3375 * z57;  // force on S3, times 0.3 m, y
    const Scalar z73 = s_theta_3 * z58 - c_theta_3 * z50;
    const Scalar z74 = n0_3 * z59;  // force on S2, times 0.3 m, y
    const Scalar z75 = s_theta_2 * z60 - c_theta_2 * z53;
    const Scalar z76 = n0_3 * z67;
    const Scalar z77 = s_theta_2 * (z53 - z68) + c_theta_2 * (z60 - z69);
    const Scalar z78 = n2 * z22 + z54;
    const Scalar z79 = n0_3 * z31 + n0_666 * z47;
    const Scalar z80 = n7_over_6 * z61 - z63 - z62 - z64;
    const Scalar z81 = z23 + z26 - z71;
    const Scalar z82 = n7_over_6 * z72 - z74 - z73 - z75;  // moment on S1, z
    const Scalar z83 = z24 + z27 - z70;
    const Scalar z84 = n0_3375 * z32 - n109_over_160 * z48;
    const Scalar z85 = z65 + z66;
    const Scalar z86 = n0_668 * a_theta_2 + z81;
    const Scalar z87 = k18 * a_theta_3 + z83;
    const Scalar z88 = k19 - z55;
    const Scalar z89 = z88 + z56;
    const Scalar z90 = s_theta_3 * z12 + c_theta_3 * z1;
    const Scalar z91 = z3 * z3 - z8 * z8;
    const Scalar z92 = z76 - z77;
    const Scalar z93 = n1_3635 * z35;
    const Scalar z94 = n7_over_3 * z21 - z90;
    const Scalar z95 = n0_001 * z34;
    const Scalar z96 = n1_3635 * z6;
    const Scalar z97 = s_theta_3 * (z50 - z93) + c_theta_3 * (z58 - z95);
    const Scalar z98 = n2 * z35;
    const Scalar z99 = n0_001 * z2;
    const Scalar z100 = n0_3375 * z98;
    const Scalar z101 = n2 * z6;
    const Scalar z102 = z2 * z2 - z6 * z6;
    const Scalar z103 = n0_3375 * z101;
    const Scalar z104 = s_theta_3 * z96 - c_theta_3 * z99;
    const Scalar z105 = n7_over_6 * z100 + z97;
    const Scalar z106 = n0_3 * z17 + n0_666 * z91;
    const Scalar z107 = a_psi * z78 - z92;
    const Scalar z108 = n30 + z106;
    const Scalar z109 = n7_over_6 * z103 - z104;
    const Scalar z110 = a_psi * z94 - z105;
    const Scalar z111 = a_psi * z89 - z82;
    const Scalar z112 = n0_3375 * z18 - n109_over_160 * z102;
    const Scalar z113 = n35 - z112;
    const Scalar z114 = n1 / z89;
    const Scalar z115 = z80 * z114;
    const Scalar z116 = n250_over_167 * z79;
    const Scalar z117 = k22 * z84;
    const Scalar z118 = z107 * z114;
    const Scalar z119 = n250_over_167 * z108;
    const Scalar z120 = z85 * z114;
    const Scalar z121 = z110 * z114;
    const Scalar z122 = k22 * z113;
    const Scalar z123 = z109 * z114;
    result.M[0] = z89;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0_668;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = k18;
    result.C[0] = -z80;
    result.C[1] = -z79;
    result.C[2] = z84;
    result.C[3] = z85;
    result.C[4] = n5;
    result.C[5] = n0;
    result.C[6] = -z109;
    result.C[7] = n0;
    result.C[8] = n6;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = z107;
    result.K[4] = z108;
    result.K[5] = n0;
    result.K[6] = -z110;
    result.K[7] = n0;
    result.K[8] = z113;
    result.F[0] = -z111;
    result.F[1] = u_Cm2 - z86;
    result.F[2] = u_Cm3 - z87;
    result.E[0] = n0;
    result.E[1] = n1;
    result.E[2] = n0;
    result.E[3] = n0;
    result.E[4] = n0;
    result.E[5] = n1;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = n0;
    result.A[7] = n0;
    result.A[8] = n0;
    result.A[9] = -z118;
    result.A[10] = -z119;
    result.A[11] = n0;
    result.A[12] = n0;
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = z121;
    result.A[16] = n0;
    result.A[17] = -z122;
    result.A[18] = n1;
    result.A[19] = n0;
    result.A[20] = n0;
    result.A[21] = z115;
    result.A[22] = z116;
    result.A[23] = -z117;
    result.A[24] = n0;
    result.A[25] = n1;
    result.A[26] = n0;
    result.A[27] = -z120;
    result.A[28] = -k24;
    result.A[29] = n0;
    result.A[30] = n0;
    result.A[31] = n0;
    result.A[32] = n1;
    result.A[33] = z123;
    result.A[34] = n0;
    result.A[35] = -k25;
    result.B[0] = n0;
    result.B[1] = n0;
    result.B[2] = n0;
    result.B[3] = n0;
    result.B[4] = n250_over_167;
    result.B[5] = n0;
    result.B[6] = n0;
    result.B[7] = n0;
    result.B[8] = n0;
    result.B[9] = n0;
    result.B[10] = n0;
    result.B[11] = k22;
    if (!(traits::regular(z89, z89))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[0] * result.C[0] * result.C[1] * result.C[2] * result.C[3] * result.C[6]
        * result.K[3] * result.K[4] * result.K[6] * result.K[8] * result.F[0]) * (n0 * result.F[1] * result.F[2]
        * result.A[9] * result.A[10] * result.A[15] * result.A[17] * result.A[21] * result.A[22] * result.A[23]
        * result.A[27] * result.A[33]);
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 9>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace satellite_arms
