// SPDX-License-Identifier: MIT-0
// shaker_damped: Mass on a spring and a damper from a shaken support
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: c, omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                0                0          0             0                  0       0      0       0
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      5                6          0             0                  1       0     13      13
//   inverse_dynamics          6                6          0             0                  1       0     14      14
//   forward_dynamics          5                6          0             0                  1       0     13      13
//   energy                    4               11          0             0                  1       0     17      17
//   linearisation             6                6          0             0                  1       0     14      14
//
// Not computed because this mechanism does not need it:
//   kinematics: of 18 results 13 vanish identically
//   first_integrals: left out, 'damper' has no force function; the force function U depends on time explicitly
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 8 results 1 vanish identically, 1 repeat another up to sign
//
// To write this file again:
//   shaker_damped_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output shaker_damped.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace shaker_damped {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 1> coordinates{{{"y", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> velocities{{{"y", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"c", "N s/m"}, {"omega", "rad/s"}}};
  static constexpr std::array<torsor::ResultDescription, 17> results{{{"result", "mass_position", 3, 1, 1, "m"},
      {"result", "mass_rotation", 3, 3, 2, "1"}, {"result", "mass_velocity", 3, 1, 1, "m/s"}, {"result",
      "mass_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 1, 1, 2, "kg"}, {"forces", "", 1, 1, 1, "N"}, {"forces",
      "", 1, 1, 1, "N"}, {"accelerations", "", 1, 1, 1, "m/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result",
      "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"},
      {"result", "M", 1, 1, 2, "kg"}, {"result", "C", 1, 1, 2, "N s/m"}, {"result", "K", 1, 1, 2, "N/m"}, {"result",
      "F", 1, 1, 1, "N"}, {"result", "A", 2, 2, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 4}, {"mass_matrix", false, false, false, false, results.data() + 4, 1}, {"bias", false, false,
      false, false, results.data() + 5, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 6, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 7, 2}, {"energy", false, false, true, false,
      results.data() + 9, 3}, {"linearisation", true, true, true, true, results.data() + 12, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::shaker_damped::Description;

  static constexpr const char* name = "shaker_damped";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x4da2b8188c9bf186ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 1;
  static constexpr int velocity_count = 1;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar c;  ///< parameter [N s/m]
    Scalar omega;  ///< parameter [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::c, &Parameters::omega};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar y;  ///< coordinate [m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::y};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar y;  ///< its rate [m/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::y};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar y;  ///< its second rate [m/s^2]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::y};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar y;  ///< works with the rate of y [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::y};
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
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n15 = traits::constant(15.0, 15.0f, "15/1");
    parameters.c = n4;
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
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k1 = traits::constant(0.175475, 0.175475f, "7019/40000");
    state.time = n0;
    state.q.y = k1;
    state.v.y = n0;
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
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    result.mass_position[0] = n0;
    result.mass_position[1] = q_y;
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
    result.mass_velocity[1] = v_y;
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
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z2;
    const Scalar z4 = n0_2 - q_y + n0_01 * z1;
    const Scalar z5 = v_y - n0_01 * z3;
    const Scalar z6 = n400 * z4;
    const Scalar z7 = z5 * p_c;
    const Scalar z8 = n9_81 - z6 + z7;
    forces.y = z8;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z2;
    const Scalar z4 = n0_2 - q_y + n0_01 * z1;
    const Scalar z5 = n9_81 + a_y;
    const Scalar z6 = v_y - n0_01 * z3;
    const Scalar z7 = n400 * z4;
    const Scalar z8 = z6 * p_c;
    const Scalar z9 = z7 - z5 - z8;
    forces.y = -z9;
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
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z2;
    const Scalar z4 = n0_2 - q_y + n0_01 * z1;
    const Scalar z5 = v_y - n0_01 * z3;
    const Scalar z6 = n400 * z4;
    const Scalar z7 = z5 * p_c;
    const Scalar z8 = n9_81 - z6 + z7;
    accelerations.y = -z8;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.y;
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
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z2;
    const Scalar z4 = n0_2 - q_y + n0_01 * z1;
    const Scalar z5 = v_y - n0_01 * z3;
    const Scalar z6 = z5 * p_c;
    result.kinetic = n0_5 * v_y * v_y;
    result.force_function = -n9_81 * q_y - n200 * z4 * z4;
    result.power = -z5 * z6;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar p_c = precomputed.parameters.c;
    const Scalar z0 = p_omega * t;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    const Scalar z3 = p_omega * z2;
    const Scalar z4 = n0_2 - q_y + n0_01 * z1;
    const Scalar z5 = n9_81 + a_y;
    const Scalar z6 = v_y - n0_01 * z3;
    const Scalar z7 = n400 * z4;
    const Scalar z8 = z6 * p_c;
    const Scalar z9 = z7 - z5 - z8;
    result.M[0] = n1;
    result.C[0] = p_c;
    result.K[0] = n400;
    result.F[0] = z9;
    result.A[0] = n0;
    result.A[1] = -n400;
    result.A[2] = n1;
    result.A[3] = -p_c;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.C[0] * result.F[0] * result.A[3];
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
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace shaker_damped
