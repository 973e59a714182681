// SPDX-License-Identifier: MIT-0
// bead_on_hoop: Bead on a hoop that turns about its vertical diameter
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, reactions, linearisation
// Parameters set at run time: omega
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                2               13          0             0                  2       0     19      19
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      1                4          0             0                  1       0      7       7
//   inverse_dynamics          2                4          0             0                  1       0      8       8
//   forward_dynamics          1                4          0             0                  1       0      7       7
//   energy                    1                5          0             0                  1       0      8       9
//   first_integrals           2                5          0             0                  1       0      9      10
//   reactions                 0                4          0             0                  1       0      6       6
//   linearisation             4                7          0             0                  1       0     13      13
//
// Not computed because this mechanism does not need it:
//   kinematics: of 18 results 1 vanish identically, 3 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   linearisation: of 8 results 3 vanish identically, 1 repeat another up to sign
//
// To write this file again:
//   bead_on_hoop_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output bead_on_hoop.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace bead_on_hoop {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 1> coordinates{{{"theta", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 1> velocities{{{"theta", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"omega", "rad/s"}}};
  static constexpr std::array<torsor::ResultDescription, 19> results{{{"result", "bead_position", 3, 1, 1, "m"},
      {"result", "bead_rotation", 3, 3, 2, "1"}, {"result", "bead_velocity", 3, 1, 1, "m/s"}, {"result",
      "bead_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 1, 1, 2, "kg m^2"}, {"forces", "", 1, 1, 1, "N m"},
      {"forces", "", 1, 1, 1, "N m"}, {"accelerations", "", 1, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1, ""},
      {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "painleve", 1, 1, 0, "J"}, {"result", "motor", 1, 1, 0, "N m"}, {"result", "M", 1, 1, 2,
      "kg m^2"}, {"result", "C", 1, 1, 2, ""}, {"result", "K", 1, 1, 2, "N m"}, {"result", "F", 1, 1, 1, "N m"},
      {"result", "A", 2, 2, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 4}, {"mass_matrix", false, false, false, false, results.data() + 4, 1}, {"bias", false, false,
      false, false, results.data() + 5, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 6, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 7, 2}, {"energy", false, false, true, false,
      results.data() + 9, 3}, {"first_integrals", false, false, false, false, results.data() + 12, 1}, {"reactions",
      true, true, true, false, results.data() + 13, 1}, {"linearisation", true, true, true, true, results.data() + 14,
      5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::bead_on_hoop::Description;

  static constexpr const char* name = "bead_on_hoop";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x3fe6bdbd6db85c37ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 1;
  static constexpr int velocity_count = 1;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;

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
    Scalar theta;  ///< coordinate [rad]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::theta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar theta;  ///< its rate [rad/s]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::theta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar theta;  ///< its second rate [rad/s^2]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::theta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar theta;  ///< works with the rate of theta [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::theta};
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
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    parameters.omega = n5;
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
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    state.time = n0;
    state.q.theta = n0_1;
    state.v.theta = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> bead_position;  ///< centre of mass of bead [m]
    std::array<Scalar, 9> bead_rotation;  ///< from the axes of bead to the ground's (3 x 3)
    std::array<Scalar, 3> bead_velocity;  ///< velocity of the centre of mass of bead [m/s]
    std::array<Scalar, 3> bead_angular_velocity;  ///< angular velocity of bead [rad/s]
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
    Scalar motor;  ///< reaction along 'motor' [N m]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Reactions::*member_(int i_) noexcept {
      constexpr Scalar Reactions::*members_[] = {&Reactions::motor};
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
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar t = state.time;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar z0 = p_omega * t;
    const Scalar angles_[] = {z0, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar z1 = sines_[0], z2 = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z3 = p_omega * s_theta;
    const Scalar z4 = z2 * c_theta;
    const Scalar z5 = z1 * c_theta;
    const Scalar z6 = z2 * s_theta;
    const Scalar z7 = z1 * s_theta;
    const Scalar z8 = z1 * v_theta;  // angular velocity of bead, x
    const Scalar z9 = z2 * v_theta;  // angular velocity of bead, y
    const Scalar z10 = v_theta * s_theta;
    const Scalar z11 = z1 * z3 - v_theta * z4;
    const Scalar z12 = z2 * z3 + v_theta * z5;
    result.bead_position[0] = -z6;
    result.bead_position[1] = -z7;
    result.bead_position[2] = -c_theta;
    result.bead_rotation[0] = z4;
    result.bead_rotation[1] = z5;
    result.bead_rotation[2] = -s_theta;
    result.bead_rotation[3] = -z1;
    result.bead_rotation[4] = z2;
    result.bead_rotation[5] = n0;
    result.bead_rotation[6] = z6;
    result.bead_rotation[7] = z7;
    result.bead_rotation[8] = c_theta;
    result.bead_velocity[0] = z11;
    result.bead_velocity[1] = -z12;
    result.bead_velocity[2] = z10;
    result.bead_angular_velocity[0] = -z8;
    result.bead_angular_velocity[1] = z9;
    result.bead_angular_velocity[2] = p_omega;
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
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * s_theta;
    const Scalar z1 = p_omega * c_theta;
    const Scalar z2 = n9_81 * s_theta;
    const Scalar z3 = z0 * z1;
    const Scalar z4 = z2 - z3;  // moment on bead, y
    forces.theta = z4;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar a_theta = accelerations.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * s_theta;
    const Scalar z1 = p_omega * c_theta;
    const Scalar z2 = n9_81 * s_theta;
    const Scalar z3 = z0 * z1;
    const Scalar z4 = a_theta + z2 - z3;  // moment on bead, y
    forces.theta = z4;
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
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * s_theta;
    const Scalar z1 = p_omega * c_theta;
    const Scalar z2 = n9_81 * s_theta;
    const Scalar z3 = z0 * z1;
    const Scalar z4 = z2 - z3;  // moment on bead, y
    accelerations.theta = -z4;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.theta;
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
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * s_theta;
    result.kinetic = n0_5 * (v_theta * v_theta + z0 * z0);
    result.force_function = n9_81 * c_theta;
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
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * s_theta;
    result.painleve = n0_5 * (v_theta * v_theta - z0 * z0) - n9_81 * c_theta;
  }

  /// Reactions against the released coordinates, each P_q - Q_q at q = 0: what the joint exerts along the released
  /// direction, at accelerations, multipliers and inputs that belong to the motion.
  TORSOR_DEVICE static void reactions(const Precomputed& precomputed, const State& state, const Accelerations&,
      const Multipliers&, const Inputs&, Reactions& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * c_theta;
    const Scalar z1 = v_theta * z0;  // angular acceleration of bead, x
    const Scalar z2 = n2 * z1;
    const Scalar z3 = s_theta * z2;
    result.motor = z3;
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
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_omega = precomputed.parameters.omega;
    const Scalar q_theta = state.q.theta;
    const Scalar a_theta = accelerations.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = p_omega * s_theta;
    const Scalar z1 = p_omega * c_theta;
    const Scalar z2 = n9_81 * s_theta;
    const Scalar z3 = n9_81 * c_theta;
    const Scalar z4 = z0 * z1;
    const Scalar z5 = z0 * z0 - z1 * z1;
    const Scalar z6 = a_theta + z2 - z4;  // moment on bead, y
    const Scalar z7 = z3 + z5;
    result.M[0] = n1;
    result.C[0] = n0;
    result.K[0] = z7;
    result.F[0] = -z6;
    result.A[0] = n0;
    result.A[1] = -z7;
    result.A[2] = n1;
    result.A[3] = n0;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.K[0] * result.F[0] * result.A[1];
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
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, Reactions&>(reactions));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace bead_on_hoop
