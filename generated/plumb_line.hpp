// SPDX-License-Identifier: MIT-0
// plumb_line: Plumb line on the turning earth
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, reactions, linearisation
// Parameters set at run time: r, latitude
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                1                8          0             0                  1       0     11       -
//   kinematics               24               48          0             0                  4       0     80      88
//   mass_matrix               0                1          0             0                  1       0      3       3
//   bias                     22               42          1             1                  3       0     72      82
//   inverse_dynamics         24               43          1             1                  3       0     75      85
//   forward_dynamics         22               44          2             1                  3       0     75      85
//   energy                   16               27          1             1                  3       0     51      62
//   first_integrals          21               32          1             1                  3       0     61      73
//   reactions                17               31          1             1                  3       0     56      66
//   linearisation            58              115          6             1                  3       0    186     202
//
// Not computed because this mechanism does not need it:
//   kinematics: of 42 results 12 vanish identically, 6 repeat another up to sign
//   mass_matrix: of 4 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   linearisation: of 30 results 10 vanish identically, 3 repeat another up to sign
//
// To write this file again:
//   plumb_line_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output plumb_line.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace plumb_line {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"delta", "rad"}, {"epsilon", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"delta", "rad/s"}, {"epsilon", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"r", "m"}, {"latitude", "rad"}}};
  static constexpr std::array<torsor::ResultDescription, 25> results{{{"result", "bob_position", 3, 1, 1, "m"},
      {"result", "bob_rotation", 3, 3, 2, "1"}, {"result", "bob_velocity", 3, 1, 1, "m/s"}, {"result",
      "bob_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "O_position", 3, 1, 1, "m"}, {"result", "O_velocity", 3, 1,
      1, "m/s"}, {"result", "O_jacobian", 3, 2, 2, ""}, {"result", "G_position", 3, 1, 1, "m"}, {"result", "G_velocity",
      3, 1, 1, "m/s"}, {"result", "G_jacobian", 3, 2, 2, "m"}, {"mass", "", 2, 2, 2, "kg m^2"}, {"forces", "", 2, 1, 1,
      "N m"}, {"forces", "", 2, 1, 1, "N m"}, {"accelerations", "", 2, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1,
      ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "painleve", 1, 1, 0, "J"}, {"result", "tension", 1, 1, 0, "N"}, {"result", "M", 2, 2, 2,
      "kg m^2"}, {"result", "C", 2, 2, 2, "N m s"}, {"result", "K", 2, 2, 2, "N m"}, {"result", "F", 2, 1, 1, "N m"},
      {"result", "A", 4, 4, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 10}, {"mass_matrix", false, false, false, false, results.data() + 10, 1}, {"bias", false,
      false, false, false, results.data() + 11, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 12,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 13, 2}, {"energy", false, false, true, false,
      results.data() + 15, 3}, {"first_integrals", false, false, false, false, results.data() + 18, 1}, {"reactions",
      true, true, true, false, results.data() + 19, 1}, {"linearisation", true, true, true, true, results.data() + 20,
      5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::plumb_line::Description;

  static constexpr const char* name = "plumb_line";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xa557bf7d1eb20a85ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar r;  ///< parameter [m]
    Scalar latitude;  ///< parameter [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::r, &Parameters::latitude};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar delta;  ///< coordinate [rad]
    Scalar epsilon;  ///< coordinate [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::delta, &Coordinates::epsilon};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar delta;  ///< its rate [rad/s]
    Scalar epsilon;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::delta, &Velocities::epsilon};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar delta;  ///< its second rate [rad/s^2]
    Scalar epsilon;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::delta, &Accelerations::epsilon};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar delta;  ///< works with the rate of delta [N m]
    Scalar epsilon;  ///< works with the rate of epsilon [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::delta, &GeneralizedForces::epsilon};
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
    Scalar m_d70720cb;
    Scalar m_2850c073;
    Scalar m_4afded67;
    Scalar m_dca3f8db;
    Scalar m_e5473e60;
    Scalar m_2dcdaecb;
    Scalar m_de60d3e0;
    Scalar m_0e4df02e;
    Scalar m_9aa83e17;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar k0 = traits::constant(6371000.0, 6371000.0f, "6371000/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar pi = traits::pi();
    parameters.r = k0;
    parameters.latitude = n0_25 * pi;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k1 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar p_latitude = parameters.latitude;
    const Scalar p_r = parameters.r;
    Scalar s_latitude, c_latitude;
    traits::sincos(p_latitude, s_latitude, c_latitude);
    const Scalar pi = traits::pi();
    const Scalar z0 = n1 + p_r;
    const Scalar z1 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k1 * pi;
    });
    const Scalar z2 = s_latitude * z1;
    const Scalar z3 = c_latitude * z1;
    const Scalar z4 = s_latitude * z0;
    const Scalar z5 = z0 * z3;
    const Scalar z6 = z3 * z3;
    const Scalar z7 = z2 * z3;
    const Scalar z8 = z0 * z6;
    const Scalar z9 = z0 * z7;
    precomputed.m_d70720cb = c_latitude;
    precomputed.m_2850c073 = z0;
    precomputed.m_4afded67 = z2;
    precomputed.m_dca3f8db = z3;
    precomputed.m_e5473e60 = z4;
    precomputed.m_2dcdaecb = z5;
    precomputed.m_de60d3e0 = s_latitude;
    precomputed.m_0e4df02e = z8;
    precomputed.m_9aa83e17 = z9;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    state.time = n0;
    state.q.delta = n0_1;
    state.q.epsilon = n0;
    state.v.delta = n0;
    state.v.epsilon = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> bob_position;  ///< centre of mass of bob [m]
    std::array<Scalar, 9> bob_rotation;  ///< from the axes of bob to the ground's (3 x 3)
    std::array<Scalar, 3> bob_velocity;  ///< velocity of the centre of mass of bob [m/s]
    std::array<Scalar, 3> bob_angular_velocity;  ///< angular velocity of bob [rad/s]
    std::array<Scalar, 3> O_position;  ///< position of O [m]
    std::array<Scalar, 3> O_velocity;  ///< velocity of the material point at O [m/s]
    std::array<Scalar, 6> O_jacobian;  ///< partial velocities of O (3 x 2)
    std::array<Scalar, 3> G_position;  ///< position of G [m]
    std::array<Scalar, 3> G_velocity;  ///< velocity of the material point at G [m/s]
    std::array<Scalar, 6> G_jacobian;  ///< partial velocities of G (3 x 2)
  };

  /// Energies of the mechanism.
  struct Energy {
    Scalar kinetic;  ///< kinetic energy T [J]
    Scalar force_function;  ///< force function U of gravity, springs, attractions and given functions [J]
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

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar tension;  ///< reaction along 'tension' [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::tension};
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
    const Scalar k0 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar t = state.time;
    const Scalar p_latitude = precomputed.parameters.latitude;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar c_latitude = precomputed.m_d70720cb;
    const Scalar m1 = precomputed.m_2850c073;
    const Scalar m2 = precomputed.m_4afded67;
    const Scalar m3 = precomputed.m_dca3f8db;
    const Scalar m4 = precomputed.m_e5473e60;
    const Scalar m5 = precomputed.m_2dcdaecb;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k0 * pi;
    });
    const Scalar z1 = t * z0;
    const Scalar z2 = p_latitude - q_delta;
    const Scalar angles_[] = {q_delta, q_epsilon, z1, z2};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_delta = sines_[0], c_delta = cosines_[0];
    const Scalar s_epsilon = sines_[1], c_epsilon = cosines_[1];
    const Scalar z3 = sines_[2], z4 = cosines_[2];
    const Scalar z5 = sines_[3], z6 = cosines_[3];
    const Scalar z7 = z4 * z6;
    const Scalar z8 = s_delta * m3 - c_delta * m2;
    const Scalar z9 = z3 * z6;
    const Scalar z10 = s_delta * m2 + c_delta * m3;
    const Scalar z11 = z3 * z5;
    const Scalar z12 = m5 * z3;  // velocity of meridian, x
    const Scalar z13 = m5 * z4;  // velocity of meridian, y
    const Scalar z14 = z4 * z5;
    const Scalar z15 = c_epsilon * z5;
    const Scalar z16 = s_epsilon * z5;
    const Scalar z17 = c_latitude * z4;
    const Scalar z18 = c_latitude * z3;
    const Scalar z19 = v_delta * z3;  // angular velocity of meridian, x
    const Scalar z20 = v_delta * z4;  // angular velocity of meridian, y
    const Scalar z21 = v_epsilon * z6 + z0;  // angular velocity of thread, z
    const Scalar z22 = m1 * z17;
    const Scalar z23 = m1 * z18;
    const Scalar z24 = s_epsilon * z3 - c_epsilon * z7;
    const Scalar z25 = c_epsilon * z3 + s_epsilon * z7;
    const Scalar z26 = s_epsilon * z4 + c_epsilon * z9;
    const Scalar z27 = s_epsilon * z9 - c_epsilon * z4;
    const Scalar z28 = v_epsilon * z14 + z19;  // angular velocity of thread, x
    const Scalar z29 = v_epsilon * z11 - z20;  // angular velocity of thread, y
    const Scalar z30 = m4 - z15;
    const Scalar z31 = z4 * z15;
    const Scalar z32 = z3 * z15;
    const Scalar z33 = v_delta * c_epsilon + s_epsilon * z8;
    const Scalar z34 = v_epsilon + z10;
    const Scalar z35 = z22 + z24;
    const Scalar z36 = z23 - z26;
    const Scalar z37 = z11 * z15 + z6 * z26;
    const Scalar z38 = z6 * z24 - z14 * z15;
    const Scalar z39 = z14 * z26 + z11 * z24;
    const Scalar z40 = z3 * z26 - z4 * z24;
    const Scalar z41 = z12 - z25 * z34 + z14 * z33;
    const Scalar z42 = z16 * z34 + z6 * z33;
    const Scalar z43 = z11 * z33 - z13 - z27 * z34;
    result.bob_position[0] = z35;
    result.bob_position[1] = z36;
    result.bob_position[2] = z30;
    result.bob_rotation[0] = -z24;
    result.bob_rotation[1] = z26;
    result.bob_rotation[2] = z15;
    result.bob_rotation[3] = -z25;
    result.bob_rotation[4] = -z27;
    result.bob_rotation[5] = -z16;
    result.bob_rotation[6] = -z14;
    result.bob_rotation[7] = -z11;
    result.bob_rotation[8] = z6;
    result.bob_velocity[0] = -z41;
    result.bob_velocity[1] = -z43;
    result.bob_velocity[2] = z42;
    result.bob_angular_velocity[0] = -z28;
    result.bob_angular_velocity[1] = -z29;
    result.bob_angular_velocity[2] = z21;
    result.O_position[0] = n0;
    result.O_position[1] = n0;
    result.O_position[2] = n0;
    result.O_velocity[0] = n0;
    result.O_velocity[1] = n0;
    result.O_velocity[2] = n0;
    result.O_jacobian[0] = n0;
    result.O_jacobian[3] = n0;
    result.O_jacobian[1] = n0;
    result.O_jacobian[4] = n0;
    result.O_jacobian[2] = n0;
    result.O_jacobian[5] = n0;
    result.G_position[0] = z35;
    result.G_position[1] = z36;
    result.G_position[2] = z30;
    result.G_velocity[0] = -z41;
    result.G_velocity[1] = -z43;
    result.G_velocity[2] = z42;
    result.G_jacobian[0] = -z31;
    result.G_jacobian[3] = z37;
    result.G_jacobian[1] = -z32;
    result.G_jacobian[4] = z38;
    result.G_jacobian[2] = z40;
    result.G_jacobian[5] = z39;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_epsilon = state.q.epsilon;
    Scalar s_epsilon, c_epsilon;
    traits::sincos(q_epsilon, s_epsilon, c_epsilon);
    const Scalar z0 = c_epsilon * c_epsilon;
    mass[0] = z0;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n1;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k2 = traits::constant(3.9847914e+14, 3.9847915e+14f, "398479140000000/1");
    const Scalar t = state.time;
    const Scalar p_r = precomputed.parameters.r;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar s_latitude = precomputed.m_de60d3e0;
    const Scalar c_latitude = precomputed.m_d70720cb;
    const Scalar m2 = precomputed.m_2850c073;
    const Scalar m3 = precomputed.m_4afded67;
    const Scalar m4 = precomputed.m_dca3f8db;
    const Scalar m5 = precomputed.m_0e4df02e;
    const Scalar m6 = precomputed.m_9aa83e17;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k0 * pi;
    });  // angular velocity of globe, z
    const Scalar z1 = t * z0;
    const Scalar angles_[] = {q_delta, q_epsilon, z1};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_delta = sines_[0], c_delta = cosines_[0];
    const Scalar s_epsilon = sines_[1], c_epsilon = cosines_[1];
    const Scalar z2 = sines_[2], z3 = cosines_[2];
    const Scalar z4 = c_delta * c_epsilon;
    const Scalar z5 = s_delta * c_epsilon;
    const Scalar z6 = s_delta * m3 + c_delta * m4;
    const Scalar z7 = s_delta * m4 - c_delta * m3;
    const Scalar z8 = c_delta * m2;
    const Scalar z9 = s_delta * m2;
    const Scalar z10 = s_delta * m6 + c_delta * m5;
    const Scalar z11 = s_delta * m5 - c_delta * m6;
    const Scalar z12 = n1 + p_r - z4;
    const Scalar z13 = s_epsilon * z8;
    const Scalar z14 = s_latitude * z5 - c_latitude * z12;
    const Scalar z15 = c_latitude * z5 + s_latitude * z12;
    const Scalar z16 = v_delta * z6;  // angular acceleration of meridian, x
    const Scalar z17 = v_delta * z7;  // angular acceleration of meridian, z
    const Scalar z18 = v_delta * s_epsilon - c_epsilon * z7;
    const Scalar z19 = v_delta * c_epsilon + s_epsilon * z7;
    const Scalar z20 = s_epsilon * z10;
    const Scalar z21 = v_epsilon + z6;  // angular velocity of thread, z
    const Scalar z22 = s_epsilon * z2 - z3 * z14;
    const Scalar z23 = s_epsilon * z3 + z2 * z14;
    const Scalar z24 = s_epsilon * z16;
    const Scalar z25 = z18 * z19;
    const Scalar z26 = z18 * z21;
    const Scalar z27 = v_epsilon * z18 - z24;  // angular acceleration of thread, y
    const Scalar z28 = z15 * z15 + z22 * z22 + z23 * z23;
    const Scalar z29 = z27 + z26;
    const Scalar z30 = traits::sqrt(z28);
    const Scalar z31 = n1 / z30;
    const Scalar z32 = k2 * z31 * z31 * z31;
    const Scalar z33 = z13 * z32;
    const Scalar z34 = z9 * z32;
    const Scalar z35 = z34 - z11;  // moment on bob, y
    const Scalar z36 = z33 - z20;  // moment on bob, z
    const Scalar z37 = z29 - z35;  // moment on thread, y
    const Scalar z38 = z17 - z25 - z36;  // moment on thread, z
    const Scalar z39 = c_epsilon * z37;
    forces.delta = -z39;
    forces.epsilon = -z38;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k2 = traits::constant(3.9847914e+14, 3.9847915e+14f, "398479140000000/1");
    const Scalar t = state.time;
    const Scalar p_r = precomputed.parameters.r;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar s_latitude = precomputed.m_de60d3e0;
    const Scalar c_latitude = precomputed.m_d70720cb;
    const Scalar m2 = precomputed.m_2850c073;
    const Scalar m3 = precomputed.m_4afded67;
    const Scalar m4 = precomputed.m_dca3f8db;
    const Scalar m5 = precomputed.m_0e4df02e;
    const Scalar m6 = precomputed.m_9aa83e17;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k0 * pi;
    });  // angular velocity of globe, z
    const Scalar z1 = t * z0;
    const Scalar angles_[] = {q_delta, q_epsilon, z1};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_delta = sines_[0], c_delta = cosines_[0];
    const Scalar s_epsilon = sines_[1], c_epsilon = cosines_[1];
    const Scalar z2 = sines_[2], z3 = cosines_[2];
    const Scalar z4 = c_delta * c_epsilon;
    const Scalar z5 = s_delta * c_epsilon;
    const Scalar z6 = s_delta * m3 + c_delta * m4;
    const Scalar z7 = s_delta * m4 - c_delta * m3;
    const Scalar z8 = c_delta * m2;
    const Scalar z9 = s_delta * m2;
    const Scalar z10 = s_delta * m6 + c_delta * m5;
    const Scalar z11 = s_delta * m5 - c_delta * m6;
    const Scalar z12 = n1 + p_r - z4;
    const Scalar z13 = s_epsilon * z8;
    const Scalar z14 = s_latitude * z5 - c_latitude * z12;
    const Scalar z15 = c_latitude * z5 + s_latitude * z12;
    const Scalar z16 = v_delta * z6;  // angular acceleration of meridian, x
    const Scalar z17 = v_delta * z7;  // angular acceleration of meridian, z
    const Scalar z18 = v_delta * s_epsilon - c_epsilon * z7;
    const Scalar z19 = v_delta * c_epsilon + s_epsilon * z7;
    const Scalar z20 = s_epsilon * z10;
    const Scalar z21 = v_epsilon + z6;  // angular velocity of thread, z
    const Scalar z22 = s_epsilon * z2 - z3 * z14;
    const Scalar z23 = s_epsilon * z3 + z2 * z14;
    const Scalar z24 = a_delta * c_epsilon + s_epsilon * z16;
    const Scalar z25 = a_epsilon - z17;  // angular acceleration of thread, z
    const Scalar z26 = z18 * z19;
    const Scalar z27 = z18 * z21;
    const Scalar z28 = z15 * z15 + z22 * z22 + z23 * z23;
    const Scalar z29 = v_epsilon * z18 - z24;  // angular acceleration of thread, y
    const Scalar z30 = z29 + z27;
    const Scalar z31 = traits::sqrt(z28);
    const Scalar z32 = n1 / z31;
    const Scalar z33 = k2 * z32 * z32 * z32;
    const Scalar z34 = z13 * z33;
    const Scalar z35 = z9 * z33;
    const Scalar z36 = z35 - z11;  // moment on bob, y
    const Scalar z37 = z34 - z20;  // moment on bob, z
    const Scalar z38 = z30 - z36;  // moment on thread, y
    const Scalar z39 = z25 + z26 + z37;  // moment on thread, z
    const Scalar z40 = c_epsilon * z38;
    forces.delta = -z40;
    forces.epsilon = z39;
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
    const Scalar k0 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k2 = traits::constant(3.9847914e+14, 3.9847915e+14f, "398479140000000/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar t = state.time;
    const Scalar p_r = precomputed.parameters.r;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar s_latitude = precomputed.m_de60d3e0;
    const Scalar c_latitude = precomputed.m_d70720cb;
    const Scalar m2 = precomputed.m_2850c073;
    const Scalar m3 = precomputed.m_4afded67;
    const Scalar m4 = precomputed.m_dca3f8db;
    const Scalar m5 = precomputed.m_0e4df02e;
    const Scalar m6 = precomputed.m_9aa83e17;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k0 * pi;
    });  // angular velocity of globe, z
    const Scalar z1 = t * z0;
    const Scalar angles_[] = {q_delta, q_epsilon, z1};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_delta = sines_[0], c_delta = cosines_[0];
    const Scalar s_epsilon = sines_[1], c_epsilon = cosines_[1];
    const Scalar z2 = sines_[2], z3 = cosines_[2];
    const Scalar z4 = c_delta * c_epsilon;
    const Scalar z5 = s_delta * c_epsilon;
    const Scalar z6 = s_delta * m3 + c_delta * m4;
    const Scalar z7 = s_delta * m4 - c_delta * m3;
    const Scalar z8 = c_epsilon * c_epsilon;
    const Scalar z9 = s_delta * m2;
    const Scalar z10 = c_delta * m2;
    const Scalar z11 = s_delta * m5 - c_delta * m6;
    const Scalar z12 = s_delta * m6 + c_delta * m5;
    const Scalar z13 = n1 + p_r - z4;
    const Scalar z14 = s_epsilon * z10;
    const Scalar z15 = n1 / z8;
    const Scalar z16 = s_latitude * z5 - c_latitude * z13;
    const Scalar z17 = c_latitude * z5 + s_latitude * z13;
    const Scalar z18 = v_delta * z6;  // angular acceleration of meridian, x
    const Scalar z19 = v_delta * z7;  // angular acceleration of meridian, z
    const Scalar z20 = v_delta * s_epsilon - c_epsilon * z7;
    const Scalar z21 = v_delta * c_epsilon + s_epsilon * z7;
    const Scalar z22 = s_epsilon * z12;
    const Scalar z23 = v_epsilon + z6;  // angular velocity of thread, z
    const Scalar z24 = s_epsilon * z2 - z3 * z16;
    const Scalar z25 = s_epsilon * z3 + z2 * z16;
    const Scalar z26 = s_epsilon * z18;
    const Scalar z27 = z20 * z21;
    const Scalar z28 = z20 * z23;
    const Scalar z29 = v_epsilon * z20 - z26;  // angular acceleration of thread, y
    const Scalar z30 = z17 * z17 + z24 * z24 + z25 * z25;
    const Scalar z31 = z29 + z28;
    const Scalar z32 = traits::sqrt(z30);
    const Scalar z33 = n1 / z32;
    const Scalar z34 = k2 * z33 * z33 * z33;
    const Scalar z35 = z14 * z34;
    const Scalar z36 = z9 * z34;
    const Scalar z37 = z36 - z11;  // moment on bob, y
    const Scalar z38 = z35 - z22;  // moment on bob, z
    const Scalar z39 = z31 - z37;  // moment on thread, y
    const Scalar z40 = z19 - z27 - z38;  // moment on thread, z
    const Scalar z41 = c_epsilon * z39;
    const Scalar z42 = z41 * z15;
    accelerations.delta = z42;
    accelerations.epsilon = z40;
    if (!(traits::regular(z8, z8))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.delta * accelerations.epsilon;
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
    const Scalar k0 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(3.9847914e+14, 3.9847915e+14f, "398479140000000/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar t = state.time;
    const Scalar p_r = precomputed.parameters.r;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar s_latitude = precomputed.m_de60d3e0;
    const Scalar c_latitude = precomputed.m_d70720cb;
    const Scalar m2 = precomputed.m_4afded67;
    const Scalar m3 = precomputed.m_dca3f8db;
    const Scalar m4 = precomputed.m_2dcdaecb;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k0 * pi;
    });  // angular velocity of globe, z
    const Scalar z1 = t * z0;
    const Scalar angles_[] = {q_delta, q_epsilon, z1};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_delta = sines_[0], c_delta = cosines_[0];
    const Scalar s_epsilon = sines_[1], c_epsilon = cosines_[1];
    const Scalar z2 = sines_[2], z3 = cosines_[2];
    const Scalar z4 = c_delta * c_epsilon;
    const Scalar z5 = s_delta * c_epsilon;
    const Scalar z6 = s_delta * m2 + c_delta * m3;
    const Scalar z7 = s_delta * m3 - c_delta * m2;
    const Scalar z8 = c_epsilon * m4;
    const Scalar z9 = s_epsilon * m4;
    const Scalar z10 = n1 + p_r - z4;
    const Scalar z11 = s_latitude * z5 - c_latitude * z10;
    const Scalar z12 = c_latitude * z5 + s_latitude * z10;
    const Scalar z13 = v_delta * c_epsilon + s_epsilon * z7;
    const Scalar z14 = v_epsilon + z6;  // angular velocity of thread, z
    const Scalar z15 = z8 - z14;
    const Scalar z16 = s_epsilon * z2 - z3 * z11;
    const Scalar z17 = s_epsilon * z3 + z2 * z11;
    const Scalar z18 = z12 * z12 + z16 * z16 + z17 * z17;
    const Scalar z19 = traits::sqrt(z18);
    const Scalar z20 = n1 / z19;
    result.kinetic = n0_5 * (z9 * z9 + z13 * z13 + z15 * (z8 - z14));
    result.force_function = k3 * z20;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar k0 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k3 = traits::constant(3.9847914e+14, 3.9847915e+14f, "398479140000000/1");
    const Scalar t = state.time;
    const Scalar p_r = precomputed.parameters.r;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar s_latitude = precomputed.m_de60d3e0;
    const Scalar c_latitude = precomputed.m_d70720cb;
    const Scalar m2 = precomputed.m_4afded67;
    const Scalar m3 = precomputed.m_dca3f8db;
    const Scalar m4 = precomputed.m_2dcdaecb;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k0 * pi;
    });  // angular velocity of globe, z
    const Scalar z1 = t * z0;
    const Scalar angles_[] = {q_delta, q_epsilon, z1};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_delta = sines_[0], c_delta = cosines_[0];
    const Scalar s_epsilon = sines_[1], c_epsilon = cosines_[1];
    const Scalar z2 = sines_[2], z3 = cosines_[2];
    const Scalar z4 = c_delta * c_epsilon;
    const Scalar z5 = s_delta * c_epsilon;
    const Scalar z6 = s_delta * m2 + c_delta * m3;
    const Scalar z7 = c_epsilon * m4;
    const Scalar z8 = s_delta * m3 - c_delta * m2;
    const Scalar z9 = s_epsilon * m4;
    const Scalar z10 = n1 + p_r - z4;
    const Scalar z11 = s_latitude * z5 - c_latitude * z10;
    const Scalar z12 = c_latitude * z5 + s_latitude * z10;
    const Scalar z13 = v_delta * c_epsilon + s_epsilon * z8;
    const Scalar z14 = v_epsilon + z6;  // angular velocity of thread, z
    const Scalar z15 = z7 - z14;
    const Scalar z16 = n0_5 * (z7 - z14);
    const Scalar z17 = s_epsilon * z2 - z3 * z11;
    const Scalar z18 = s_epsilon * z3 + z2 * z11;
    const Scalar z19 = c_epsilon * z13;
    const Scalar z20 = z12 * z12 + z17 * z17 + z18 * z18;
    const Scalar z21 = n0_5 * z15 + z16;
    const Scalar z22 = traits::sqrt(z20);
    const Scalar z23 = n1 / z22;
    result.painleve = v_delta * z19 - n0_5 * (z9 * z9 + z13 * z13 + z15 * (z7 - z14)) - v_epsilon * z21 - k3 * z23;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state, const Accelerations&,
      const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar k0 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k2 = traits::constant(3.9847914e+14, 3.9847915e+14f, "398479140000000/1");
    const Scalar t = state.time;
    const Scalar p_r = precomputed.parameters.r;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar s_latitude = precomputed.m_de60d3e0;
    const Scalar c_latitude = precomputed.m_d70720cb;
    const Scalar m2 = precomputed.m_2850c073;
    const Scalar m3 = precomputed.m_4afded67;
    const Scalar m4 = precomputed.m_dca3f8db;
    const Scalar m5 = precomputed.m_0e4df02e;
    const Scalar m6 = precomputed.m_9aa83e17;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k0 * pi;
    });  // angular velocity of globe, z
    const Scalar z1 = t * z0;
    const Scalar angles_[] = {q_delta, q_epsilon, z1};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_delta = sines_[0], c_delta = cosines_[0];
    const Scalar s_epsilon = sines_[1], c_epsilon = cosines_[1];
    const Scalar z2 = sines_[2], z3 = cosines_[2];
    const Scalar z4 = c_delta * c_epsilon;
    const Scalar z5 = s_delta * c_epsilon;
    const Scalar z6 = s_delta * m4 - c_delta * m3;
    const Scalar z7 = s_delta * m3 + c_delta * m4;
    const Scalar z8 = c_delta * m2;
    const Scalar z9 = s_delta * m6 + c_delta * m5;
    const Scalar z10 = n1 + p_r - z4;
    const Scalar z11 = c_epsilon * z8;
    const Scalar z12 = s_latitude * z5 - c_latitude * z10;
    const Scalar z13 = c_latitude * z5 + s_latitude * z10;
    const Scalar z14 = n1 - z11;
    const Scalar z15 = v_delta * c_epsilon + s_epsilon * z6;
    const Scalar z16 = c_epsilon * z9;
    const Scalar z17 = v_epsilon + z7;  // angular velocity of thread, z
    const Scalar z18 = s_epsilon * z2 - z3 * z12;
    const Scalar z19 = s_epsilon * z3 + z2 * z12;
    const Scalar z20 = z17 * z17;
    const Scalar z21 = z15 * z15;
    const Scalar z22 = z13 * z13 + z18 * z18 + z19 * z19;
    const Scalar z23 = z21 + z20;
    const Scalar z24 = traits::sqrt(z22);
    const Scalar z25 = n1 / z24;
    const Scalar z26 = k2 * z25 * z25 * z25;
    const Scalar z27 = z14 * z26;
    const Scalar z28 = z16 - z23 + z27;  // force on bob, x
    result.tension = -z28;
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
    const Scalar k0 = traits::constant(2.3148148148148147e-05, 2.3148148e-05f, "1/43200");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k4 = traits::constant(3.9847914e+14, 3.9847915e+14f, "398479140000000/1");
    const Scalar k5 = traits::constant(1.19543742e+15, 1.1954374e+15f, "1195437420000000/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar t = state.time;
    const Scalar p_r = precomputed.parameters.r;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar s_latitude = precomputed.m_de60d3e0;
    const Scalar c_latitude = precomputed.m_d70720cb;
    const Scalar m2 = precomputed.m_2850c073;
    const Scalar m3 = precomputed.m_4afded67;
    const Scalar m4 = precomputed.m_dca3f8db;
    const Scalar m5 = precomputed.m_0e4df02e;
    const Scalar m6 = precomputed.m_9aa83e17;
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(7.27220521664304e-05, 7.2722054e-05f, [&]() -> Scalar {
      return k0 * pi;
    });  // angular velocity of globe, z
    const Scalar z1 = t * z0;
    const Scalar angles_[] = {q_delta, q_epsilon, z1};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_delta = sines_[0], c_delta = cosines_[0];
    const Scalar s_epsilon = sines_[1], c_epsilon = cosines_[1];
    const Scalar z2 = sines_[2], z3 = cosines_[2];
    const Scalar z4 = c_delta * c_epsilon;
    const Scalar z5 = s_delta * c_epsilon;
    const Scalar z6 = s_delta * s_epsilon;
    const Scalar z7 = c_delta * s_epsilon;
    const Scalar z8 = s_delta * m3 + c_delta * m4;
    const Scalar z9 = s_delta * m4 - c_delta * m3;
    const Scalar z10 = c_delta * m2;
    const Scalar z11 = s_delta * m2;
    const Scalar z12 = s_delta * m5 - c_delta * m6;
    const Scalar z13 = c_epsilon * c_epsilon;
    const Scalar z14 = s_delta * m6 + c_delta * m5;
    const Scalar z15 = n1 + p_r - z4;
    const Scalar z16 = s_latitude * z5;
    const Scalar z17 = c_latitude * z5;
    const Scalar z18 = c_epsilon * z10;
    const Scalar z19 = s_epsilon * z10;
    const Scalar z20 = s_latitude * z6 + c_latitude * z7;
    const Scalar z21 = s_latitude * z7 - c_latitude * z6;
    const Scalar z22 = c_latitude * z15 - z16;
    const Scalar z23 = s_latitude * z15 + z17;
    const Scalar z24 = c_latitude * z4 + z16;
    const Scalar z25 = s_latitude * z4 - z17;
    const Scalar z26 = v_delta * z8;  // angular acceleration of meridian, x
    const Scalar z27 = v_delta * z9;  // angular acceleration of meridian, z
    const Scalar z28 = v_delta * s_epsilon - c_epsilon * z9;
    const Scalar z29 = v_delta * c_epsilon + s_epsilon * z9;
    const Scalar z30 = c_epsilon * z14;
    const Scalar z31 = s_epsilon * z14;
    const Scalar z32 = v_epsilon + z8;  // angular velocity of thread, z
    const Scalar z33 = s_epsilon * z8;
    const Scalar z34 = c_epsilon * z8;
    const Scalar z35 = s_epsilon * z2 + z3 * z22;
    const Scalar z36 = s_epsilon * z3 - z2 * z22;
    const Scalar z37 = a_delta * s_epsilon - c_epsilon * z26;
    const Scalar z38 = a_delta * c_epsilon + s_epsilon * z26;
    const Scalar z39 = a_epsilon - z27;  // angular acceleration of thread, z
    const Scalar z40 = v_epsilon * s_epsilon - z33;
    const Scalar z41 = s_epsilon * z32;
    const Scalar z42 = s_epsilon * z27;
    const Scalar z43 = z3 * z25;
    const Scalar z44 = z2 * z25;
    const Scalar z45 = z28 * z29;
    const Scalar z46 = z28 * z32;
    const Scalar z47 = z32 * z34 + z9 * z28;
    const Scalar z48 = s_epsilon * z29 + c_epsilon * z28;
    const Scalar z49 = z28 * z33 - z29 * z34;
    const Scalar z50 = v_epsilon * z34 - z42;
    const Scalar z51 = z23 * z23 + z35 * z35 + z36 * z36;
    const Scalar z52 = s_epsilon * z11;
    const Scalar z53 = v_epsilon * z29 + z37;  // angular acceleration of thread, x
    const Scalar z54 = v_epsilon * z28 - z38;  // angular acceleration of thread, y
    const Scalar z55 = z40 + z41;
    const Scalar z56 = n2 * (z23 * z24 - z35 * z43 + z36 * z44);
    const Scalar z57 = c_epsilon * z55;
    const Scalar z58 = z50 + z47;
    const Scalar z59 = z54 + z46;
    const Scalar z60 = z9 - z48;
    const Scalar z61 = traits::sqrt(z51);
    const Scalar z62 = n1 / z61;
    const Scalar z63 = s_epsilon * z12;
    const Scalar z64 = n0_5 * z56 / z61;
    const Scalar z65 = k4 * z62 * z62 * z62;
    const Scalar z66 = z64 / (z61 * z61);
    const Scalar z67 = z19 * z65;
    const Scalar z68 = z11 * z65;
    const Scalar z69 = z29 * z32;
    const Scalar z70 = z53 + z69;
    const Scalar z71 = z28 * z28 - z29 * z29;
    const Scalar z72 = n2 * z28;
    const Scalar z73 = c_epsilon * z72;
    const Scalar z74 = n1 / z13;
    const Scalar z75 = z57 * z74;
    const Scalar z76 = c_epsilon * z2 + z3 * z20;
    const Scalar z77 = c_epsilon * z3 - z2 * z20;
    const Scalar z78 = n2 * (z23 * z21 + z35 * z76 + z36 * z77);
    const Scalar z79 = n0_5 * z78 / z61;
    const Scalar z80 = z68 - z12;  // moment on bob, y
    const Scalar z81 = z67 - z31;  // moment on bob, z
    const Scalar z82 = z73 * z74;
    const Scalar z83 = k5 * z62 * z62 * z66;
    const Scalar z84 = z79 / (z61 * z61);
    const Scalar z85 = z59 - z80;  // moment on thread, y
    const Scalar z86 = z39 + z45 + z81;  // moment on thread, z
    const Scalar z87 = z10 * z65 - z11 * z83;
    const Scalar z88 = z65 * z52 + z19 * z83;
    const Scalar z89 = c_epsilon * z85;
    const Scalar z90 = z14 - z87;
    const Scalar z91 = z88 - z63;
    const Scalar z92 = z58 - z90;
    const Scalar z93 = z26 - z49 + z91;
    const Scalar z94 = c_epsilon * z92;
    const Scalar z95 = k5 * z62 * z62 * z84;
    const Scalar z96 = z11 * z95;
    const Scalar z97 = z18 * z65 - z19 * z95;
    const Scalar z98 = z94 * z74;
    const Scalar z99 = z70 + z96;
    const Scalar z100 = z30 - z97;
    const Scalar z101 = s_epsilon * z85 - c_epsilon * z99;
    const Scalar z102 = z71 + z100;
    const Scalar z103 = z101 * z74;
    result.M[0] = z13;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n1;
    result.C[0] = -z57;
    result.C[1] = -z60;
    result.C[2] = -z73;
    result.C[3] = n0;
    result.K[0] = z94;
    result.K[1] = -z93;
    result.K[2] = z101;
    result.K[3] = -z102;
    result.F[0] = z89;
    result.F[1] = -z86;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = -z98;
    result.A[3] = z93;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = -z103;
    result.A[7] = z102;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = z75;
    result.A[11] = z60;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = z82;
    result.A[15] = n0;
    if (!(traits::regular(z13, z13))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[0] * result.C[0] * result.C[1] * result.C[2] * result.K[0] * result.K[1]
        * result.K[2] * result.K[3]) * (n0 * result.F[0] * result.F[1] * result.A[2] * result.A[3] * result.A[6]
        * result.A[7] * result.A[10] * result.A[11] * result.A[14]);
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
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, Reactions&>(reactions));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace plumb_line
