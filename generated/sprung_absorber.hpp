// SPDX-License-Identifier: MIT-0
// sprung_absorber: Mass on a spring, shaken, with a smaller one as its absorber
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: k2, c2, f, omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                1                3          0             0                  0       0      4       -
//   kinematics                0                0          0             0                  0       0      0       0
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      6                5          0             0                  1       0     13      13
//   inverse_dynamics          8                6          0             0                  1       0     16      16
//   forward_dynamics          6                6          0             0                  1       0     14      14
//   energy                    5               13          0             0                  1       0     20      21
//   linearisation             8                6          0             0                  1       0     16      19
//
// Not computed because this mechanism does not need it:
//   kinematics: of 48 results 35 vanish identically, 2 repeat another up to sign
//   mass_matrix: of 4 results 2 vanish identically
//   first_integrals: left out, 'friction' has no force function; 'shaking' has a force function that is not stated
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 30 results 8 vanish identically, 11 repeat another up to sign
//
// To write this file again:
//   sprung_absorber_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output sprung_absorber.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace sprung_absorber {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"x1", "m"}, {"x2", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"x1", "m/s"}, {"x2", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 4> parameters{{{"k2", "N/m"}, {"c2", "N s/m"}, {"f", "N"},
      {"omega", "rad/s"}}};
  static constexpr std::array<torsor::ResultDescription, 24> results{{{"result", "machine_position", 3, 1, 1, "m"},
      {"result", "machine_rotation", 3, 3, 2, "1"}, {"result", "machine_velocity", 3, 1, 1, "m/s"}, {"result",
      "machine_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "absorber_position", 3, 1, 1, "m"}, {"result",
      "absorber_rotation", 3, 3, 2, "1"}, {"result", "absorber_velocity", 3, 1, 1, "m/s"}, {"result",
      "absorber_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "A_position", 3, 1, 1, "m"}, {"result", "A_velocity",
      3, 1, 1, "m/s"}, {"result", "A_jacobian", 3, 2, 2, "1"}, {"mass", "", 2, 2, 2, "kg"}, {"forces", "", 2, 1, 1,
      "N"}, {"forces", "", 2, 1, 1, "N"}, {"accelerations", "", 2, 1, 1, "m/s^2"}, {"multipliers", "", 0, 1, 1, ""},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "M", 2, 2, 2, "kg"}, {"result", "C", 2, 2, 2, "N s/m"}, {"result", "K", 2, 2, 2, "N/m"},
      {"result", "F", 2, 1, 1, "N"}, {"result", "A", 4, 4, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 11}, {"mass_matrix", false, false, false, false, results.data() + 11, 1}, {"bias", false,
      false, false, false, results.data() + 12, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 13,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 14, 2}, {"energy", false, false, true, false,
      results.data() + 16, 3}, {"linearisation", true, true, true, true, results.data() + 19, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::sprung_absorber::Description;

  static constexpr const char* name = "sprung_absorber";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x90db53d34365e8ffULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 4;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar k2;  ///< parameter [N/m]
    Scalar c2;  ///< parameter [N s/m]
    Scalar f;  ///< parameter [N]
    Scalar omega;  ///< parameter [rad/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::k2, &Parameters::c2, &Parameters::f, &Parameters::omega};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x1;  ///< coordinate [m]
    Scalar x2;  ///< coordinate [m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x1, &Coordinates::x2};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x1;  ///< its rate [m/s]
    Scalar x2;  ///< its rate [m/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x1, &Velocities::x2};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x1;  ///< its second rate [m/s^2]
    Scalar x2;  ///< its second rate [m/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x1, &Accelerations::x2};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x1;  ///< works with the rate of x1 [N]
    Scalar x2;  ///< works with the rate of x2 [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x1, &GeneralizedForces::x2};
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
    Scalar m_b1cd9f7f;
    Scalar m_d520c9b4;
    Scalar m_8f58a2ce;
    Scalar m_e2f62ebb;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    parameters.k2 = n10;
    parameters.c2 = n0;
    parameters.f = n1;
    parameters.omega = n10;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar p_k2 = parameters.k2;
    const Scalar p_c2 = parameters.c2;
    const Scalar z0 = n0_5 * p_k2;
    const Scalar z1 = n100 + p_k2;
    const Scalar z2 = n10 * p_k2;
    const Scalar z3 = n10 * p_c2;
    precomputed.m_b1cd9f7f = z0;
    precomputed.m_d520c9b4 = z1;
    precomputed.m_8f58a2ce = z2;
    precomputed.m_e2f62ebb = z3;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_f = parameters.f;
    const Scalar p_k2 = parameters.k2;
    state.time = n0;
    state.q.x1 = n0;
    state.q.x2 = -p_f / p_k2;
    state.v.x1 = n0;
    state.v.x2 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> machine_position;  ///< centre of mass of machine [m]
    std::array<Scalar, 9> machine_rotation;  ///< from the axes of machine to the ground's (3 x 3)
    std::array<Scalar, 3> machine_velocity;  ///< velocity of the centre of mass of machine [m/s]
    std::array<Scalar, 3> machine_angular_velocity;  ///< angular velocity of machine [rad/s]
    std::array<Scalar, 3> absorber_position;  ///< centre of mass of absorber [m]
    std::array<Scalar, 9> absorber_rotation;  ///< from the axes of absorber to the ground's (3 x 3)
    std::array<Scalar, 3> absorber_velocity;  ///< velocity of the centre of mass of absorber [m/s]
    std::array<Scalar, 3> absorber_angular_velocity;  ///< angular velocity of absorber [rad/s]
    std::array<Scalar, 3> A_position;  ///< position of A [m]
    std::array<Scalar, 3> A_velocity;  ///< velocity of the material point at A [m/s]
    std::array<Scalar, 6> A_jacobian;  ///< partial velocities of A (3 x 2)
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
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x1 = state.q.x1;
    const Scalar v_x1 = state.v.x1;
    const Scalar q_x2 = state.q.x2;
    const Scalar v_x2 = state.v.x2;
    result.machine_position[0] = q_x1;
    result.machine_position[1] = n0;
    result.machine_position[2] = n0;
    result.machine_rotation[0] = n1;
    result.machine_rotation[1] = n0;
    result.machine_rotation[2] = n0;
    result.machine_rotation[3] = n0;
    result.machine_rotation[4] = n1;
    result.machine_rotation[5] = n0;
    result.machine_rotation[6] = n0;
    result.machine_rotation[7] = n0;
    result.machine_rotation[8] = n1;
    result.machine_velocity[0] = v_x1;
    result.machine_velocity[1] = n0;
    result.machine_velocity[2] = n0;
    result.machine_angular_velocity[0] = n0;
    result.machine_angular_velocity[1] = n0;
    result.machine_angular_velocity[2] = n0;
    result.absorber_position[0] = q_x2;
    result.absorber_position[1] = n0;
    result.absorber_position[2] = n0;
    result.absorber_rotation[0] = n1;
    result.absorber_rotation[1] = n0;
    result.absorber_rotation[2] = n0;
    result.absorber_rotation[3] = n0;
    result.absorber_rotation[4] = n1;
    result.absorber_rotation[5] = n0;
    result.absorber_rotation[6] = n0;
    result.absorber_rotation[7] = n0;
    result.absorber_rotation[8] = n1;
    result.absorber_velocity[0] = v_x2;
    result.absorber_velocity[1] = n0;
    result.absorber_velocity[2] = n0;
    result.absorber_angular_velocity[0] = n0;
    result.absorber_angular_velocity[1] = n0;
    result.absorber_angular_velocity[2] = n0;
    result.A_position[0] = q_x1;
    result.A_position[1] = n0;
    result.A_position[2] = n0;
    result.A_velocity[0] = v_x1;
    result.A_velocity[1] = n0;
    result.A_velocity[2] = n0;
    result.A_jacobian[0] = n1;
    result.A_jacobian[3] = n0;
    result.A_jacobian[1] = n0;
    result.A_jacobian[4] = n0;
    result.A_jacobian[2] = n0;
    result.A_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0_1;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar q_x1 = state.q.x1;
    const Scalar v_x1 = state.v.x1;
    const Scalar q_x2 = state.q.x2;
    const Scalar v_x2 = state.v.x2;
    const Scalar p_k2 = precomputed.parameters.k2;
    const Scalar p_c2 = precomputed.parameters.c2;
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = q_x1 - q_x2;
    const Scalar z4 = n100 * q_x1;
    const Scalar z5 = v_x1 - v_x2;
    const Scalar z6 = p_f * z2;
    const Scalar z7 = p_k2 * z3;
    const Scalar z8 = z5 * p_c2;
    const Scalar z9 = z7 + z8;
    const Scalar z10 = z4 + z7 + z8 - z6;
    forces.x1 = z10;
    forces.x2 = -z9;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar q_x1 = state.q.x1;
    const Scalar v_x1 = state.v.x1;
    const Scalar a_x1 = accelerations.x1;
    const Scalar q_x2 = state.q.x2;
    const Scalar v_x2 = state.v.x2;
    const Scalar a_x2 = accelerations.x2;
    const Scalar p_k2 = precomputed.parameters.k2;
    const Scalar p_c2 = precomputed.parameters.c2;
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = q_x1 - q_x2;
    const Scalar z4 = n100 * q_x1;
    const Scalar z5 = v_x1 - v_x2;
    const Scalar z6 = p_f * z2;
    const Scalar z7 = n0_1 * a_x2;  // force on absorber, x
    const Scalar z8 = p_k2 * z3;
    const Scalar z9 = z5 * p_c2;
    const Scalar z10 = z8 + z9 - z7;
    const Scalar z11 = a_x1 - z6;  // force on machine, x
    const Scalar z12 = z4 + z8 + z9 + z11;
    forces.x1 = z12;
    forces.x2 = -z10;
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
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n10 = traits::constant(10.0, 10.0f, "10/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x1 = state.q.x1;
    const Scalar v_x1 = state.v.x1;
    const Scalar q_x2 = state.q.x2;
    const Scalar v_x2 = state.v.x2;
    const Scalar p_k2 = precomputed.parameters.k2;
    const Scalar p_c2 = precomputed.parameters.c2;
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = q_x1 - q_x2;
    const Scalar z4 = n100 * q_x1;
    const Scalar z5 = v_x1 - v_x2;
    const Scalar z6 = p_f * z2;
    const Scalar z7 = p_k2 * z3;
    const Scalar z8 = z5 * p_c2;
    const Scalar z9 = z7 + z8;
    const Scalar z10 = n10 * z9;
    const Scalar z11 = z4 + z7 + z8 - z6;
    accelerations.x1 = -z11;
    accelerations.x2 = z10;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x1 * accelerations.x2;
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
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n50 = traits::constant(50.0, 50.0f, "50/1");
    const Scalar q_x1 = state.q.x1;
    const Scalar v_x1 = state.v.x1;
    const Scalar q_x2 = state.q.x2;
    const Scalar v_x2 = state.v.x2;
    const Scalar p_c2 = precomputed.parameters.c2;
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar m0 = precomputed.m_b1cd9f7f;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = v_x1 - v_x2;
    const Scalar z4 = q_x1 - q_x2;
    const Scalar z5 = p_f * z2;
    const Scalar z6 = p_c2 * z3;
    result.kinetic = n0_5 * v_x1 * v_x1 + n0_05 * v_x2 * v_x2;
    result.force_function = -n50 * q_x1 * q_x1 - m0 * z4 * z4;
    result.power = v_x1 * z5 - z3 * z6;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n100 = traits::constant(100.0, 100.0f, "100/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x1 = state.q.x1;
    const Scalar v_x1 = state.v.x1;
    const Scalar a_x1 = accelerations.x1;
    const Scalar q_x2 = state.q.x2;
    const Scalar v_x2 = state.v.x2;
    const Scalar a_x2 = accelerations.x2;
    const Scalar p_k2 = precomputed.parameters.k2;
    const Scalar p_c2 = precomputed.parameters.c2;
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar m0 = precomputed.m_d520c9b4;
    const Scalar m1 = precomputed.m_8f58a2ce;
    const Scalar m2 = precomputed.m_e2f62ebb;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = q_x1 - q_x2;
    const Scalar z4 = n100 * q_x1;
    const Scalar z5 = v_x1 - v_x2;
    const Scalar z6 = p_f * z2;
    const Scalar z7 = n0_1 * a_x2;  // force on absorber, x
    const Scalar z8 = p_k2 * z3;
    const Scalar z9 = z5 * p_c2;
    const Scalar z10 = z8 + z9 - z7;
    const Scalar z11 = a_x1 - z6;  // force on machine, x
    const Scalar z12 = z4 + z8 + z9 + z11;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0_1;
    result.C[0] = p_c2;
    result.C[1] = -p_c2;
    result.C[2] = -p_c2;
    result.C[3] = p_c2;
    result.K[0] = m0;
    result.K[1] = -p_k2;
    result.K[2] = -p_k2;
    result.K[3] = p_k2;
    result.F[0] = -z12;
    result.F[1] = z10;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = -m0;
    result.A[3] = m1;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = p_k2;
    result.A[7] = -m1;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = -p_c2;
    result.A[11] = m2;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = p_c2;
    result.A[15] = -m2;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.C[0] * result.C[1] * result.C[2] * result.C[3] * result.K[0] * result.K[1]
        * result.K[2] * result.K[3] * result.F[0]) * (n0 * result.F[1] * result.A[2] * result.A[3] * result.A[6]
        * result.A[7] * result.A[10] * result.A[11] * result.A[14] * result.A[15]);
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

}  // namespace sprung_absorber
