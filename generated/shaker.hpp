// SPDX-License-Identifier: MIT-0
// shaker: Mass on a spring from a shaken support
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, reactions, linearisation
// Parameters set at run time: omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                2                4          0             0                  1       0      8       8
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      3                5          0             0                  1       0     10      10
//   inverse_dynamics          4                5          0             0                  1       0     11      11
//   forward_dynamics          3                5          0             0                  1       0     10      10
//   energy                    4                9          0             0                  1       0     15      15
//   reactions                 2                4          0             0                  1       0      8       8
//   linearisation             4                5          0             0                  1       0     11      11
//
// Not computed because this mechanism does not need it:
//   kinematics: of 18 results 13 vanish identically
//   energy: of 3 results 1 vanish identically
//   first_integrals: left out, T depends on time explicitly; the force function U depends on time explicitly
//   constraints: left out, the scene has no constraints
//   linearisation: of 8 results 3 vanish identically
//
// To write this file again:
//   shaker_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output shaker.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace shaker {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 1> coordinates{{{"x", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> velocities{{{"x", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"omega", "rad/s"}}};
  static constexpr std::array<torsor::ResultDescription, 18> results{{{"result", "mass_position", 3, 1, 1, "m"},
      {"result", "mass_rotation", 3, 3, 2, "1"}, {"result", "mass_velocity", 3, 1, 1, "m/s"}, {"result",
      "mass_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 1, 1, 2, "kg"}, {"forces", "", 1, 1, 1, "N"}, {"forces",
      "", 1, 1, 1, "N"}, {"accelerations", "", 1, 1, 1, "m/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result",
      "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"},
      {"result", "drive", 1, 1, 0, "N"}, {"result", "M", 1, 1, 2, "kg"}, {"result", "C", 1, 1, 2, ""}, {"result", "K",
      1, 1, 2, "N/m"}, {"result", "F", 1, 1, 1, "N"}, {"result", "A", 2, 2, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 4}, {"mass_matrix", false, false, false, false, results.data() + 4, 1}, {"bias", false, false,
      false, false, results.data() + 5, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 6, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 7, 2}, {"energy", false, false, true, false,
      results.data() + 9, 3}, {"reactions", true, true, true, false, results.data() + 12, 1}, {"linearisation", true,
      true, true, true, results.data() + 13, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::shaker::Description;

  static constexpr const char* name = "shaker";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x5500e5fdca28930eULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 1;
  static constexpr int velocity_count = 1;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar omega;  ///< parameter [rad/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::omega};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x};
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
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    parameters.omega = n15;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters& parameters) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k1 = traits::constant(0.175475, 0.175475f, "7019/40000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar p_omega = parameters.omega;
    state.time = n0;
    state.q.x = k1;
    state.v.x = -n0_01 * p_omega;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> mass_position;  ///< centre of mass of mass [m]
    std::array<Scalar, 9> mass_rotation;  ///< from the axes of mass to the ground's (3 x 3)
    std::array<Scalar, 3> mass_velocity;  ///< velocity of the centre of mass of mass [m/s]
    std::array<Scalar, 3> mass_angular_velocity;  ///< angular velocity of mass [rad/s]
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

  /// Reactions of joints along released directions.
  struct Reactions {
    Scalar drive;  ///< reaction along 'drive' [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::drive};
      return members_[i_];
    }
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 1> M;  ///< mass matrix
    std::array<Scalar, 1> C;  ///< damping and gyroscopic terms
    std::array<Scalar, 1> K;  ///< stiffness
    std::array<Scalar, 1> F;  ///< right-hand side
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, e'): x' = A x + B du (2 x 2)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed& precomputed, const State& state,
      Kinematics& result) noexcept {
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z2;
    const Scalar z4 = n0_01 * z1;
    const Scalar z5 = n0_01 * z3;  // velocity of support, y
    const Scalar z6 = q_x + z4;  // place of mass, y
    const Scalar z7 = v_x + z5;  // velocity of mass, y
    result.mass_position[0] = n0;
    result.mass_position[1] = z6;
    result.mass_position[2] = n0;
    result.mass_rotation[0] = n1;
    result.mass_rotation[1] = n0;
    result.mass_rotation[2] = n0;
    result.mass_rotation[3] = n0;
    result.mass_rotation[4] = n1;
    result.mass_rotation[5] = n0;
    result.mass_rotation[6] = n0;
    result.mass_rotation[7] = n0;
    result.mass_rotation[8] = n1;
    result.mass_velocity[0] = n0;
    result.mass_velocity[1] = z7;
    result.mass_velocity[2] = n0;
    result.mass_angular_velocity[0] = n0;
    result.mass_angular_velocity[1] = n0;
    result.mass_angular_velocity[2] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 1>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    mass[0] = n1;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_x = state.q.x;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = n0_2 - q_x;
    const Scalar z5 = n400 * z4;
    const Scalar z6 = p_omega * z3;
    const Scalar z7 = n9_81 - n0_01 * z6;
    const Scalar z8 = z5 - z7;
    forces.x = -z8;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_x = state.q.x;
    const Scalar a_x = accelerations.x;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = n0_2 - q_x;
    const Scalar z5 = n400 * z4;
    const Scalar z6 = p_omega * z3;
    const Scalar z7 = n9_81 - n0_01 * z6;
    const Scalar z8 = a_x + z7;
    const Scalar z9 = z5 - z8;
    forces.x = -z9;
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
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_x = state.q.x;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = n0_2 - q_x;
    const Scalar z5 = n400 * z4;
    const Scalar z6 = p_omega * z3;
    const Scalar z7 = n9_81 - n0_01 * z6;
    const Scalar z8 = z5 - z7;
    accelerations.x = z8;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x;
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
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z2;
    const Scalar z4 = n0_01 * z1 + q_x;
    const Scalar z5 = n0_2 - q_x;
    const Scalar z6 = n0_01 * z3;  // velocity of support, y
    const Scalar z7 = v_x + z6;  // velocity of mass, y
    result.kinetic = n0_5 * z7 * z7;
    result.force_function = -n200 * z5 * z5 - n9_81 * z4;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar a_x = accelerations.x;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = p_omega * z3;
    const Scalar z5 = n9_81 - n0_01 * z4;
    const Scalar z6 = a_x + z5;
    result.drive = z6;
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
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_x = state.q.x;
    const Scalar a_x = accelerations.x;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z1;
    const Scalar z4 = n0_2 - q_x;
    const Scalar z5 = n400 * z4;
    const Scalar z6 = p_omega * z3;
    const Scalar z7 = n9_81 - n0_01 * z6;
    const Scalar z8 = a_x + z7;
    const Scalar z9 = z5 - z8;
    result.M[0] = n1;
    result.C[0] = n0;
    result.K[0] = n400;
    result.F[0] = z9;
    result.A[0] = n0;
    result.A[1] = -n400;
    result.A[2] = n1;
    result.A[3] = n0;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.F[0];
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 1>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, Reactions&>(reactions));
    visitor(Description::kernels[7],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace shaker
