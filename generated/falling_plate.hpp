// SPDX-License-Identifier: MIT-0
// falling_plate: A plate falls with its edge on a smooth plane
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, reactions, linearisation
// Parameters set at run time: b, A, B, F
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                9                4          0             0                  0       0     13       -
//   kinematics               12               28          0             0                  2       0     44      46
//   mass_matrix               3                7          0             0                  1       0     12      21
//   bias                     14               39          0             0                  1       0     55      66
//   inverse_dynamics         21               48          0             0                  1       0     71      86
//   forward_dynamics         20               50          2             0                  1       0     74      89
//   energy                   15               30          0             0                  2       0     49      59
//   first_integrals          19               36          0             0                  2       0     59      70
//   reactions                16               30          0             0                  2       0     50      61
//   linearisation            73              149          2             0                  1       0    226     255
//
// Not computed because this mechanism does not need it:
//   kinematics: of 18 results 1 vanish identically
//   mass_matrix: of 16 results 10 vanish identically, 1 repeat another up to sign
//   bias: of 4 results 2 vanish identically
//   forward_dynamics: of 4 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   linearisation: of 116 results 90 vanish identically, 1 repeat another up to sign
//
// To write this file again:
//   falling_plate_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output falling_plate.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace falling_plate {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 4> coordinates{{{"x", "m"}, {"y", "m"}, {"alpha", "rad"},
      {"beta", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 4> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"alpha",
      "rad/s"}, {"beta", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 4> parameters{{{"b", "m"}, {"A", "kg m^2"}, {"B", "kg m^2"},
      {"F", "kg m^2"}}};
  static constexpr std::array<torsor::ResultDescription, 23> results{{{"result", "plate_position", 3, 1, 1, "m"},
      {"result", "plate_rotation", 3, 3, 2, "1"}, {"result", "plate_velocity", 3, 1, 1, "m/s"}, {"result",
      "plate_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 4, 4, 2, ""}, {"forces", "", 4, 1, 1, "N m"}, {"forces",
      "", 4, 1, 1, "N, N, N m, N m"}, {"accelerations", "", 4, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1, ""},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result", "momentum_x", 1, 1, 0, "N s"}, {"result", "momentum_y", 1, 1,
      0, "N s"}, {"result", "momentum_alpha", 1, 1, 0, "N m s"}, {"result", "N", 1, 1, 0, "N"}, {"result", "moment", 1,
      1, 0, "N m"}, {"result", "M", 4, 4, 2, ""}, {"result", "C", 4, 4, 2, "N m s"}, {"result", "K", 4, 4, 2, "N m"},
      {"result", "F", 4, 1, 1, "N, N, N m, N m"}, {"result", "A", 8, 8, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 4}, {"mass_matrix", false, false, false, false, results.data() + 4, 1}, {"bias", false, false,
      false, false, results.data() + 5, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 6, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 7, 2}, {"energy", false, false, true, false,
      results.data() + 9, 3}, {"first_integrals", false, false, false, false, results.data() + 12, 4}, {"reactions",
      true, true, true, false, results.data() + 16, 2}, {"linearisation", true, true, true, true, results.data() + 18,
      5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::falling_plate::Description;

  static constexpr const char* name = "falling_plate";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x4eb3090d503cac72ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 4;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 4;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar b;  ///< parameter [m]
    Scalar A;  ///< parameter [kg m^2]
    Scalar B;  ///< parameter [kg m^2]
    Scalar F;  ///< parameter [kg m^2]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::b, &Parameters::A, &Parameters::B, &Parameters::F};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar alpha;  ///< coordinate [rad]
    Scalar beta;  ///< coordinate [rad]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::alpha,
          &Coordinates::beta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar alpha;  ///< its rate [rad/s]
    Scalar beta;  ///< its rate [rad/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::alpha,
          &Velocities::beta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar alpha;  ///< its second rate [rad/s^2]
    Scalar beta;  ///< its second rate [rad/s^2]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::alpha,
          &Accelerations::beta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar alpha;  ///< works with the rate of alpha [N m]
    Scalar beta;  ///< works with the rate of beta [N m]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::alpha, &GeneralizedForces::beta};
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
    Scalar m_de226596;
    Scalar m_b5f0de83;
    Scalar m_c70c1f0e;
    Scalar m_8204775b;
    Scalar m_6f102224;
    Scalar m_a8188141;
    Scalar m_96015fcf;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_045 = traits::constant(0.045, 0.045f, "9/200");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_015 = traits::constant(0.015, 0.015f, "3/200");
    parameters.b = n0_3;
    parameters.A = n0_045;
    parameters.B = n0_02;
    parameters.F = n0_015;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_b = parameters.b;
    const Scalar p_A = parameters.A;
    const Scalar p_B = parameters.B;
    const Scalar z0 = p_b * p_b + p_A;
    const Scalar z1 = p_b * p_b + p_A + p_B;
    const Scalar z2 = p_B - z1;
    const Scalar z3 = p_B - z0 + z1;
    const Scalar z4 = n0_5 * z3;
    const Scalar z5 = p_B - z4;
    const Scalar z6 = z1 - z4;
    const Scalar z7 = z5 - z6;
    const Scalar z8 = n2 * p_b;
    precomputed.m_de226596 = z0;
    precomputed.m_b5f0de83 = z2;
    precomputed.m_c70c1f0e = z5;
    precomputed.m_8204775b = z6;
    precomputed.m_6f102224 = z7;
    precomputed.m_a8188141 = z1;
    precomputed.m_96015fcf = z8;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1_4 = traits::constant(1.4, 1.4f, "7/5");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.alpha = n0;
    state.q.beta = n1_4;
    state.v.x = n0;
    state.v.y = n0;
    state.v.alpha = n0;
    state.v.beta = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> plate_position;  ///< centre of mass of plate [m]
    std::array<Scalar, 9> plate_rotation;  ///< from the axes of plate to the ground's (3 x 3)
    std::array<Scalar, 3> plate_velocity;  ///< velocity of the centre of mass of plate [m/s]
    std::array<Scalar, 3> plate_angular_velocity;  ///< angular velocity of plate [rad/s]
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
    Scalar momentum_x;  ///< dT/dx' of the cyclic coordinate 'x' [N s]
    Scalar momentum_y;  ///< dT/dy' of the cyclic coordinate 'y' [N s]
    Scalar momentum_alpha;  ///< dT/dalpha' of the cyclic coordinate 'alpha' [N m s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy, &FirstIntegrals::momentum_x,
          &FirstIntegrals::momentum_y, &FirstIntegrals::momentum_alpha};
      return members_[i_];
    }
  };

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar N;  ///< reaction along 'N' [N]
    Scalar moment;  ///< reaction along 'moment' [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::N, &Reactions::moment};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 16> M;  ///< mass matrix (4 x 4)
    std::array<Scalar, 16> C;  ///< damping and gyroscopic terms (4 x 4)
    std::array<Scalar, 16> K;  ///< stiffness (4 x 4)
    std::array<Scalar, 4> F;  ///< right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, e'): x' = A x + B du (8 x 8)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = p_b * c_beta;
    const Scalar z2 = v_alpha * c_beta;
    const Scalar z3 = s_alpha * c_beta;
    const Scalar z4 = c_alpha * c_beta;
    const Scalar z5 = s_alpha * s_beta;
    const Scalar z6 = c_alpha * s_beta;
    const Scalar z7 = p_b * v_beta;
    const Scalar z8 = p_b * s_beta;
    const Scalar z9 = c_alpha * v_beta;  // angular velocity of plate, x
    const Scalar z10 = s_alpha * v_beta;  // angular velocity of plate, y
    const Scalar z11 = c_beta * z7;
    const Scalar z12 = s_alpha * z1;
    const Scalar z13 = c_alpha * z1;
    const Scalar z14 = v_alpha * z1;
    const Scalar z15 = p_b * z3;
    const Scalar z16 = p_b * z4;
    const Scalar z17 = p_b * z2;
    const Scalar z18 = q_x + z12;  // place of foot, x
    const Scalar z19 = q_y - z13;  // place of foot, y
    const Scalar z20 = v_x - s_alpha * p_b * z0 + c_alpha * z14;  // velocity of foot, x
    const Scalar z21 = v_y + c_alpha * p_b * z0 + s_alpha * z14;  // velocity of foot, y
    const Scalar z22 = z18 - z15;
    const Scalar z23 = z19 + z16;
    const Scalar z24 = c_alpha * z17 - z20 - z5 * z7;
    const Scalar z25 = s_alpha * z17 - z21 + z6 * z7;
    result.plate_position[0] = z22;
    result.plate_position[1] = z23;
    result.plate_position[2] = z8;
    result.plate_rotation[0] = c_alpha;
    result.plate_rotation[1] = s_alpha;
    result.plate_rotation[2] = n0;
    result.plate_rotation[3] = -z3;
    result.plate_rotation[4] = z4;
    result.plate_rotation[5] = s_beta;
    result.plate_rotation[6] = z5;
    result.plate_rotation[7] = -z6;
    result.plate_rotation[8] = c_beta;
    result.plate_velocity[0] = -z24;
    result.plate_velocity[1] = -z25;
    result.plate_velocity[2] = z11;
    result.plate_angular_velocity[0] = z9;
    result.plate_angular_velocity[1] = z10;
    result.plate_angular_velocity[2] = v_alpha;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 16>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar p_B = precomputed.parameters.B;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_b5f0de83;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = c_beta * m1;
    const Scalar z1 = p_b * s_beta;
    const Scalar z2 = p_b * c_beta;
    const Scalar z3 = s_beta * p_F;
    const Scalar z4 = c_beta * z0;
    const Scalar z5 = z1 * z1;
    const Scalar z6 = p_B - z4;
    const Scalar z7 = m0 - z5;
    const Scalar z8 = z2 * z2 - z6;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n1;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = -z8;
    mass[11] = z3;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = z3;
    mass[15] = z7;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar m0 = precomputed.m_c70c1f0e;
    const Scalar m1 = precomputed.m_8204775b;
    const Scalar m2 = precomputed.m_6f102224;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = c_beta * v_beta;
    const Scalar z2 = p_b * c_beta;
    const Scalar z3 = v_alpha * v_alpha;
    const Scalar z4 = v_alpha * s_beta;
    const Scalar z5 = v_alpha * c_beta;
    const Scalar z6 = v_beta * v_beta;
    const Scalar z7 = p_b * s_beta;
    const Scalar z8 = v_beta * z1;
    const Scalar z9 = n2 * v_alpha * p_b * z0;
    const Scalar z10 = v_beta * z5;  // angular acceleration of plate, y
    const Scalar z11 = v_beta * z4;  // angular acceleration of plate, z
    const Scalar z12 = z5 * z5;
    const Scalar z13 = z4 * z5;
    const Scalar z14 = z4 * z4;
    const Scalar z15 = z2 * z3 + p_b * z8;
    const Scalar z16 = n2 * z11;
    const Scalar z17 = z12 + z6;
    const Scalar z18 = n2 * z10;
    const Scalar z19 = z6 - z14;
    const Scalar z20 = p_b * z13;  // force on plate, z
    const Scalar z21 = p_b * z16;  // force on plate, x
    const Scalar z22 = p_b * z17;  // force on plate, y
    const Scalar z23 = p_F * z13 + m0 * z18;  // moment on plate, y
    const Scalar z24 = p_b * z9 + p_F * z19 - m1 * z16;  // moment on plate, z
    const Scalar z25 = n9_81 * c_beta - s_beta * z15;
    const Scalar z26 = s_beta * z20 + c_beta * z22;
    const Scalar z27 = z9 - z21;  // force on foot, x
    const Scalar z28 = p_b * z25 - z13 * m2;  // moment on plate, x
    const Scalar z29 = z15 - z26;  // force on foot, y
    const Scalar z30 = s_beta * z23 + c_beta * z24;
    const Scalar z31 = z2 * z27 - z30;  // moment on turned, z
    const Scalar z32 = z7 * z29 + z28;
    forces.x = n0;
    forces.y = n0;
    forces.alpha = -z31;
    forces.beta = z32;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar p_B = precomputed.parameters.B;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_b5f0de83;
    const Scalar m2 = precomputed.m_c70c1f0e;
    const Scalar m3 = precomputed.m_8204775b;
    const Scalar m4 = precomputed.m_6f102224;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = c_beta * v_beta;
    const Scalar z2 = p_b * c_beta;
    const Scalar z3 = v_alpha * v_alpha;
    const Scalar z4 = v_alpha * s_beta;
    const Scalar z5 = v_alpha * c_beta;
    const Scalar z6 = v_beta * v_beta;
    const Scalar z7 = c_beta * m1;
    const Scalar z8 = p_b * s_beta;
    const Scalar z9 = s_beta * p_F;
    const Scalar z10 = v_beta * z4;
    const Scalar z11 = z5 * z5;
    const Scalar z12 = z4 * z5;
    const Scalar z13 = v_beta * z5;
    const Scalar z14 = z4 * z4;
    const Scalar z15 = c_beta * z7;
    const Scalar z16 = z8 * z8;
    const Scalar z17 = v_beta * z1;
    const Scalar z18 = n2 * v_alpha * p_b * z0;
    const Scalar z19 = z11 + z6;
    const Scalar z20 = z6 - z14;
    const Scalar z21 = p_B - z15;
    const Scalar z22 = m0 - z16;
    const Scalar z23 = z2 * z3 + p_b * z17;
    const Scalar z24 = n2 * z10;
    const Scalar z25 = n2 * z13;
    const Scalar z26 = p_b * z12;  // force on plate, z
    const Scalar z27 = p_b * z19;  // force on plate, y
    const Scalar z28 = z2 * z2 - z21;
    const Scalar z29 = p_b * z24;  // force on plate, x
    const Scalar z30 = p_F * z12 + m2 * z25;  // moment on plate, y
    const Scalar z31 = p_b * z18 + p_F * z20 - m3 * z24;  // moment on plate, z
    const Scalar z32 = n9_81 * c_beta - s_beta * z23;
    const Scalar z33 = s_beta * z26 + c_beta * z27;
    const Scalar z34 = z18 - z29;  // force on foot, x
    const Scalar z35 = p_b * z32 - m4 * z12;  // moment on plate, x
    const Scalar z36 = z23 - z33;  // force on foot, y
    const Scalar z37 = s_beta * z30 + c_beta * z31;
    const Scalar z38 = z2 * z34 - z37;  // moment on turned, z
    const Scalar z39 = z8 * z36 + z35;
    const Scalar z40 = z38 + a_alpha * z28 - a_beta * z9;
    const Scalar z41 = z39 + a_alpha * z9 + a_beta * z22;
    forces.x = a_x;
    forces.y = a_y;
    forces.alpha = -z40;
    forces.beta = z41;
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
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar p_B = precomputed.parameters.B;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_b5f0de83;
    const Scalar m2 = precomputed.m_c70c1f0e;
    const Scalar m3 = precomputed.m_8204775b;
    const Scalar m4 = precomputed.m_6f102224;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = p_b * s_beta;
    const Scalar z1 = c_beta * m1;
    const Scalar z2 = s_beta * v_beta;
    const Scalar z3 = c_beta * v_beta;
    const Scalar z4 = p_b * c_beta;
    const Scalar z5 = v_alpha * v_alpha;
    const Scalar z6 = v_alpha * s_beta;
    const Scalar z7 = v_alpha * c_beta;
    const Scalar z8 = v_beta * v_beta;
    const Scalar z9 = s_beta * p_F;
    const Scalar z10 = v_beta * z3;
    const Scalar z11 = n2 * v_alpha * p_b * z2;
    const Scalar z12 = v_beta * z7;  // angular acceleration of plate, y
    const Scalar z13 = v_beta * z6;  // angular acceleration of plate, z
    const Scalar z14 = z7 * z7;
    const Scalar z15 = z6 * z7;
    const Scalar z16 = z6 * z6;
    const Scalar z17 = c_beta * z1;
    const Scalar z18 = z0 * z0;
    const Scalar z19 = z4 * z5 + p_b * z10;
    const Scalar z20 = n2 * z13;
    const Scalar z21 = z14 + z8;
    const Scalar z22 = n2 * z12;
    const Scalar z23 = z8 - z16;
    const Scalar z24 = p_b * z15;  // force on plate, z
    const Scalar z25 = p_B - z17;
    const Scalar z26 = m0 - z18;
    const Scalar z27 = p_b * z20;  // force on plate, x
    const Scalar z28 = p_b * z21;  // force on plate, y
    const Scalar z29 = p_F * z15 + m2 * z22;  // moment on plate, y
    const Scalar z30 = p_b * z11 + p_F * z23 - m3 * z20;  // moment on plate, z
    const Scalar z31 = z4 * z4 - z25;
    const Scalar z32 = n1 / z26;
    const Scalar z33 = n9_81 * c_beta - s_beta * z19;
    const Scalar z34 = s_beta * z24 + c_beta * z28;
    const Scalar z35 = z11 - z27;  // force on foot, x
    const Scalar z36 = p_b * z33 - m4 * z15;  // moment on plate, x
    const Scalar z37 = z19 - z34;  // force on foot, y
    const Scalar z38 = s_beta * z29 + c_beta * z30;
    const Scalar z39 = z4 * z35 - z38;  // moment on turned, z
    const Scalar z40 = z0 * z37 + z36;
    const Scalar z41 = z9 * z32;
    const Scalar z42 = z9 * z41 + z31;
    const Scalar z43 = z39 + z40 * z41;
    const Scalar z44 = n1 / z42;
    const Scalar z45 = z44 * z43;
    const Scalar z46 = z40 * z32 - z41 * z45;
    accelerations.x = n0;
    accelerations.y = n0;
    accelerations.alpha = -z45;
    accelerations.beta = -z46;
    if (!(traits::regular(-z42, -z31) && traits::regular(z26, z26))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.alpha * accelerations.beta;
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
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar p_B = precomputed.parameters.B;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_a8188141;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = v_x * s_alpha - v_y * c_alpha;
    const Scalar z2 = v_x * c_alpha + v_y * s_alpha;
    const Scalar z3 = p_b * c_beta;
    const Scalar z4 = v_alpha * s_beta;
    const Scalar z5 = v_alpha * c_beta;
    const Scalar z6 = p_b * s_beta;
    const Scalar z7 = v_beta * p_F + p_B * z4;
    const Scalar z8 = v_alpha * z3 + z2;
    const Scalar z9 = p_b * z0 - z1;  // velocity of foot, y
    const Scalar z10 = c_beta * z9;
    const Scalar z11 = s_beta * z9;
    const Scalar z12 = p_b * z5 - z8;
    const Scalar z13 = p_b * z8 - m1 * z5;
    const Scalar z14 = p_b * v_beta - z11;
    const Scalar z15 = p_b * z11 - v_beta * m0 - p_F * z4;
    result.kinetic = -n0_5 * (z8 * z12 - z4 * z7 - z10 * z10 + z5 * z13 + z11 * z14 + v_beta * z15);
    result.force_function = -n9_81 * z6;
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
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar p_B = precomputed.parameters.B;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_a8188141;
    const Scalar m2 = precomputed.m_b5f0de83;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = s_beta * v_beta;
    const Scalar z1 = v_x * s_alpha - v_y * c_alpha;
    const Scalar z2 = v_x * c_alpha + v_y * s_alpha;
    const Scalar z3 = p_b * c_beta;
    const Scalar z4 = c_beta * m2;
    const Scalar z5 = v_alpha * s_beta;
    const Scalar z6 = v_alpha * c_beta;
    const Scalar z7 = p_b * s_beta;
    const Scalar z8 = s_beta * p_F;
    const Scalar z9 = v_beta * p_F + p_B * z5;
    const Scalar z10 = c_beta * z4;
    const Scalar z11 = p_B - z10;
    const Scalar z12 = v_alpha * z3 + z2;
    const Scalar z13 = p_b * z0 - z1;  // velocity of foot, y
    const Scalar z14 = z3 * z3 - z11;
    const Scalar z15 = c_beta * z13;
    const Scalar z16 = s_beta * z13;
    const Scalar z17 = p_b * z6 - z12;
    const Scalar z18 = p_b * z12 - m1 * z6;
    const Scalar z19 = p_b * v_beta - z16;
    const Scalar z20 = p_b * z16 - v_beta * m0 - p_F * z5;
    result.energy = -n0_5 * (z12 * z17 - z5 * z9 - z15 * z15 + z6 * z18 + z16 * z19 + v_beta * z20) + n9_81 * z7;
    result.momentum_x = v_x;
    result.momentum_y = v_y;
    result.momentum_alpha = -v_alpha * z14 + v_beta * z8;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_alpha = state.q.alpha;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar m0 = precomputed.m_c70c1f0e;
    const Scalar m1 = precomputed.m_8204775b;
    const Scalar m2 = precomputed.m_96015fcf;
    const Scalar angles_[] = {q_alpha, q_beta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_alpha = sines_[0], c_alpha = cosines_[0];
    const Scalar s_beta = sines_[1], c_beta = cosines_[1];
    const Scalar z0 = v_alpha * s_beta;
    const Scalar z1 = v_alpha * c_beta;
    const Scalar z2 = a_alpha * c_beta;
    const Scalar z3 = a_alpha * s_beta;
    const Scalar z4 = v_beta * v_beta;
    const Scalar z5 = s_beta * v_beta;
    const Scalar z6 = a_x * c_alpha + a_y * s_alpha;
    const Scalar z7 = p_b * c_beta;
    const Scalar z8 = v_beta * z1 + z3;  // angular acceleration of plate, y
    const Scalar z9 = v_beta * z0 - z2;  // angular acceleration of plate, z
    const Scalar z10 = v_beta * z0;
    const Scalar z11 = z1 * z1;
    const Scalar z12 = z0 * z1;
    const Scalar z13 = v_beta * z1;
    const Scalar z14 = z0 * z0;
    const Scalar z15 = z11 + z4;
    const Scalar z16 = a_beta + z12;
    const Scalar z17 = z4 - z14;
    const Scalar z18 = v_alpha * m2 * z5 - z6 - a_alpha * z7;
    const Scalar z19 = z9 + z10;
    const Scalar z20 = z8 + z13;
    const Scalar z21 = p_b * z15;  // force on plate, y
    const Scalar z22 = p_b * z16;  // force on plate, z
    const Scalar z23 = p_F * z16 + m0 * z20;  // moment on plate, y
    const Scalar z24 = c_beta * z22 - s_beta * z21;
    const Scalar z25 = p_F * z17 - m1 * z19 + p_b * z18;  // moment on plate, z
    const Scalar z26 = n9_81 + z24;  // force on foot, z
    const Scalar z27 = c_beta * z23 - s_beta * z25;
    result.N = z26;
    result.moment = z27;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, Reactions& result) noexcept {
    Mechanism::reactions(precomputed, state, accelerations, Multipliers(), Inputs(), result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar v_alpha = state.v.alpha;
    const Scalar a_alpha = accelerations.alpha;
    const Scalar p_b = precomputed.parameters.b;
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar p_F = precomputed.parameters.F;
    const Scalar p_B = precomputed.parameters.B;
    const Scalar m0 = precomputed.m_de226596;
    const Scalar m1 = precomputed.m_b5f0de83;
    const Scalar m2 = precomputed.m_c70c1f0e;
    const Scalar m3 = precomputed.m_8204775b;
    const Scalar m4 = precomputed.m_6f102224;
    const Scalar m5 = precomputed.m_96015fcf;
    Scalar s_beta, c_beta;
    traits::sincos(q_beta, s_beta, c_beta);
    const Scalar z0 = c_beta * v_beta;
    const Scalar z1 = v_alpha * s_beta;
    const Scalar z2 = s_beta * v_beta;
    const Scalar z3 = v_alpha * c_beta;
    const Scalar z4 = p_b * s_beta;
    const Scalar z5 = p_b * c_beta;
    const Scalar z6 = v_alpha * v_alpha;
    const Scalar z7 = v_beta * v_beta;
    const Scalar z8 = c_beta * m1;
    const Scalar z9 = n2 * v_alpha;
    const Scalar z10 = s_beta * p_F;
    const Scalar z11 = n2 * v_alpha * p_b * s_beta;
    const Scalar z12 = s_beta * m1;
    const Scalar z13 = c_beta * p_F;
    const Scalar z14 = v_beta * z1;
    const Scalar z15 = z3 * z3;
    const Scalar z16 = n2 * v_beta;
    const Scalar z17 = z1 * z3;
    const Scalar z18 = v_beta * z3;
    const Scalar z19 = z1 * z1;
    const Scalar z20 = c_beta * z8;
    const Scalar z21 = z4 * z4;
    const Scalar z22 = v_beta * z0;
    const Scalar z23 = n2 * v_alpha * p_b * z2;
    const Scalar z24 = m5 * z2;
    const Scalar z25 = n2 * z2;
    const Scalar z26 = n2 * s_beta * z1;
    const Scalar z27 = c_beta * z1 + s_beta * z3;
    const Scalar z28 = n2 * z0;
    const Scalar z29 = z5 * z9;
    const Scalar z30 = n2 * c_beta * z3;
    const Scalar z31 = n2 * z1;
    const Scalar z32 = z15 + z7;
    const Scalar z33 = n2 * z3;
    const Scalar z34 = z7 - z19;
    const Scalar z35 = p_B - z20;
    const Scalar z36 = m0 - z21;
    const Scalar z37 = z5 * z6 + p_b * z22;
    const Scalar z38 = n2 * z14;
    const Scalar z39 = n2 * z18;
    const Scalar z40 = p_b * z17;  // force on plate, z
    const Scalar z41 = p_b * z25;
    const Scalar z42 = p_b * z24 - p_F * z26 - m3 * z25;
    const Scalar z43 = p_b * z30;
    const Scalar z44 = s_beta * z29;
    const Scalar z45 = p_b * z31;
    const Scalar z46 = p_F * z16 + p_b * z11 - m3 * z31;
    const Scalar z47 = m2 * z33;
    const Scalar z48 = p_b * z32;  // force on plate, y
    const Scalar z49 = c_beta * z12 + s_beta * z8;
    const Scalar z50 = n2 * v_alpha * p_b * z0;
    const Scalar z51 = z4 * z5;
    const Scalar z52 = n2 * z51;
    const Scalar z53 = z5 * z5 - z35;
    const Scalar z54 = z3 * z31;
    const Scalar z55 = z15 - z19;
    const Scalar z56 = p_b * z38;  // force on plate, x
    const Scalar z57 = p_F * z17 + m2 * z39;  // moment on plate, y
    const Scalar z58 = p_b * z23 + p_F * z34 - m3 * z38;  // moment on plate, z
    const Scalar z59 = z24 - z41;
    const Scalar z60 = z11 - z45;
    const Scalar z61 = p_F * z55 - m2 * z38;
    const Scalar z62 = s_beta * z47 + c_beta * z46;
    const Scalar z63 = z23 - z56;  // force on foot, x
    const Scalar z64 = p_b * z44 + m4 * z27;
    const Scalar z65 = z49 + z52;
    const Scalar z66 = p_b * z50 - p_F * z54 - m3 * z39;
    const Scalar z67 = c_beta * (z57 + z66) - s_beta * (z58 - z61);
    const Scalar z68 = s_beta * z57 + c_beta * z58;
    const Scalar z69 = z5 * z60 - z62;
    const Scalar z70 = p_b * z39;
    const Scalar z71 = z50 - z70;
    const Scalar z72 = z5 * z63 - z68;  // moment on turned, z
    const Scalar z73 = s_beta * z40 + c_beta * z48;
    const Scalar z74 = z72 + a_alpha * z53 - a_beta * z10;
    const Scalar z75 = z67 + z4 * z63 - z5 * z71;
    const Scalar z76 = z37 - z73;  // force on foot, y
    const Scalar z77 = m2 * z28 + p_F * z27;
    const Scalar z78 = s_beta * z77 + c_beta * z42;
    const Scalar z79 = p_b * z27;
    const Scalar z80 = c_beta * z43 + s_beta * z79;
    const Scalar z81 = n9_81 * c_beta - s_beta * z37;
    const Scalar z82 = p_b * z81 - m4 * z17;  // moment on plate, x
    const Scalar z83 = z29 - z80;
    const Scalar z84 = z5 * z59 - z78;
    const Scalar z85 = z75 + a_beta * z13 + a_alpha * z65;
    const Scalar z86 = z4 * z83 - z64;
    const Scalar z87 = v_beta * z2;
    const Scalar z88 = z4 * z6 + p_b * z87;
    const Scalar z89 = p_b * z54;
    const Scalar z90 = p_b * z28;
    const Scalar z91 = p_b * z16;
    const Scalar z92 = c_beta * z91;
    const Scalar z93 = n2 * (z4 * z5 - z52);
    const Scalar z94 = z4 * z76 + z82;
    const Scalar z95 = z94 + a_alpha * z10 + a_beta * z36;
    const Scalar z96 = c_beta * z37 + s_beta * (n9_81 - z88);
    const Scalar z97 = n1 / z36;
    const Scalar z98 = z90 - z92;
    const Scalar z99 = m4 * z55 + p_b * z96;
    const Scalar z100 = p_b * z55;
    const Scalar z101 = c_beta * (z40 - z89) - s_beta * (z48 - z100);
    const Scalar z102 = z10 * z97;
    const Scalar z103 = z10 * z102 + z53;
    const Scalar z104 = s_beta * z90;
    const Scalar z105 = p_b * z104;
    const Scalar z106 = z84 + z86 * z102;
    const Scalar z107 = z88 + z101;
    const Scalar z108 = n1 / z103;
    const Scalar z109 = z4 * z98 - z105;
    const Scalar z110 = z99 - z5 * z76 + z4 * z107;
    const Scalar z111 = z69 + z109 * z102;
    const Scalar z112 = a_alpha * z13 - z110 + a_beta * z93;
    const Scalar z113 = z108 * z106;
    const Scalar z114 = z108 * z111;
    const Scalar z115 = z85 - z112 * z102;
    const Scalar z116 = z86 * z97 - z102 * z113;
    const Scalar z117 = z109 * z97 - z102 * z114;
    const Scalar z118 = z108 * z115;
    const Scalar z119 = z112 * z97 + z102 * z118;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n1;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = -z53;
    result.M[11] = z10;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = z10;
    result.M[15] = z36;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = n0;
    result.C[8] = n0;
    result.C[9] = n0;
    result.C[10] = -z84;
    result.C[11] = z86;
    result.C[12] = n0;
    result.C[13] = n0;
    result.C[14] = -z69;
    result.C[15] = z109;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = z85;
    result.K[15] = z112;
    result.F[0] = -a_x;
    result.F[1] = -a_y;
    result.F[2] = z74;
    result.F[3] = -z95;
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
    result.A[21] = n0;
    result.A[22] = n0;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = z118;
    result.A[31] = -z119;
    result.A[32] = n1;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = n0;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = n0;
    result.A[47] = n0;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = -z113;
    result.A[55] = -z116;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n1;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = -z114;
    result.A[63] = -z117;
    if (!(traits::regular(-z103, -z53) && traits::regular(z36, z36))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[10] * result.M[11] * result.M[14] * result.M[15] * result.C[10] * result.C[11]
        * result.C[14] * result.C[15] * result.K[14] * result.K[15]) * (n0 * result.F[0] * result.F[1] * result.F[2]
        * result.F[3] * result.A[30] * result.A[31] * result.A[54] * result.A[55] * result.A[62] * result.A[63]);
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 16>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, Reactions&>(reactions));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace falling_plate
