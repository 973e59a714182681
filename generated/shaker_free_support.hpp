// SPDX-License-Identifier: MIT-0
// shaker_free_support: Mass on a spring from a support that moves freely
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
//   kinematics                2                0          0             0                  0       0      2       2
//   mass_matrix               0                0          0             0                  0       0      0       0
//   bias                      4                3          1             1                  0       0      9       9
//   inverse_dynamics          6                4          1             1                  0       0     12      12
//   forward_dynamics          4                4          1             1                  0       0     10      10
//   energy                    6                9          0             1                  0       0     16      16
//   first_integrals           7                9          0             1                  0       0     17      17
//   linearisation             8               10          3             1                  0       0     22      22
//
// Not computed because this mechanism does not need it:
//   kinematics: of 60 results 43 vanish identically, 4 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 30 results 19 vanish identically
//
// To write this file again:
//   shaker_free_support_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output shaker_free_support.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace shaker_free_support {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"lambda", "m"}, {"l", "m"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"lambda", "m/s"}, {"l", "m/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 28> results{{{"result", "support_position", 3, 1, 1, "m"},
      {"result", "support_rotation", 3, 3, 2, "1"}, {"result", "support_velocity", 3, 1, 1, "m/s"}, {"result",
      "support_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "mass_position", 3, 1, 1, "m"}, {"result",
      "mass_rotation", 3, 3, 2, "1"}, {"result", "mass_velocity", 3, 1, 1, "m/s"}, {"result", "mass_angular_velocity",
      3, 1, 1, "rad/s"}, {"result", "H_position", 3, 1, 1, "m"}, {"result", "H_velocity", 3, 1, 1, "m/s"}, {"result",
      "H_jacobian", 3, 2, 2, "1"}, {"result", "P_position", 3, 1, 1, "m"}, {"result", "P_velocity", 3, 1, 1, "m/s"},
      {"result", "P_jacobian", 3, 2, 2, "1"}, {"mass", "", 2, 2, 2, "kg"}, {"forces", "", 2, 1, 1, "N"}, {"forces", "",
      2, 1, 1, "N"}, {"accelerations", "", 2, 1, 1, "m/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1,
      1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "energy", 1,
      1, 0, "J"}, {"result", "M", 2, 2, 2, "kg"}, {"result", "C", 2, 2, 2, ""}, {"result", "K", 2, 2, 2, "N/m"},
      {"result", "F", 2, 1, 1, "N"}, {"result", "A", 4, 4, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 8> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 14}, {"mass_matrix", false, false, false, false, results.data() + 14, 1}, {"bias", false,
      false, false, false, results.data() + 15, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 16,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 17, 2}, {"energy", false, false, true, false,
      results.data() + 19, 3}, {"first_integrals", false, false, false, false, results.data() + 22, 1},
      {"linearisation", true, true, true, true, results.data() + 23, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::shaker_free_support::Description;

  static constexpr const char* name = "shaker_free_support";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x9fab402278ea8831ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar lambda;  ///< coordinate [m]
    Scalar l;  ///< coordinate [m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::lambda, &Coordinates::l};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar lambda;  ///< its rate [m/s]
    Scalar l;  ///< its rate [m/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::lambda, &Velocities::l};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar lambda;  ///< its second rate [m/s^2]
    Scalar l;  ///< its second rate [m/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::lambda, &Accelerations::l};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar lambda;  ///< works with the rate of lambda [N]
    Scalar l;  ///< works with the rate of l [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::lambda, &GeneralizedForces::l};
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
    const Scalar n0_22 = traits::constant(0.22, 0.22f, "11/50");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    state.time = n0;
    state.q.lambda = n0;
    state.q.l = n0_22;
    state.v.lambda = n5;
    state.v.l = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> support_position;  ///< centre of mass of support [m]
    std::array<Scalar, 9> support_rotation;  ///< from the axes of support to the ground's (3 x 3)
    std::array<Scalar, 3> support_velocity;  ///< velocity of the centre of mass of support [m/s]
    std::array<Scalar, 3> support_angular_velocity;  ///< angular velocity of support [rad/s]
    std::array<Scalar, 3> mass_position;  ///< centre of mass of mass [m]
    std::array<Scalar, 9> mass_rotation;  ///< from the axes of mass to the ground's (3 x 3)
    std::array<Scalar, 3> mass_velocity;  ///< velocity of the centre of mass of mass [m/s]
    std::array<Scalar, 3> mass_angular_velocity;  ///< angular velocity of mass [rad/s]
    std::array<Scalar, 3> H_position;  ///< position of H [m]
    std::array<Scalar, 3> H_velocity;  ///< velocity of the material point at H [m/s]
    std::array<Scalar, 6> H_jacobian;  ///< partial velocities of H (3 x 2)
    std::array<Scalar, 3> P_position;  ///< position of P [m]
    std::array<Scalar, 3> P_velocity;  ///< velocity of the material point at P [m/s]
    std::array<Scalar, 6> P_jacobian;  ///< partial velocities of P (3 x 2)
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
    const Scalar q_lambda = state.q.lambda;
    const Scalar v_lambda = state.v.lambda;
    const Scalar q_l = state.q.l;
    const Scalar v_l = state.v.l;
    const Scalar z0 = q_lambda + q_l;  // place of mass, y
    const Scalar z1 = v_lambda + v_l;  // velocity of mass, y
    result.support_position[0] = n0;
    result.support_position[1] = q_lambda;
    result.support_position[2] = n0;
    result.support_rotation[0] = n1;
    result.support_rotation[1] = n0;
    result.support_rotation[2] = n0;
    result.support_rotation[3] = n0;
    result.support_rotation[4] = n1;
    result.support_rotation[5] = n0;
    result.support_rotation[6] = n0;
    result.support_rotation[7] = n0;
    result.support_rotation[8] = n1;
    result.support_velocity[0] = n0;
    result.support_velocity[1] = v_lambda;
    result.support_velocity[2] = n0;
    result.support_angular_velocity[0] = n0;
    result.support_angular_velocity[1] = n0;
    result.support_angular_velocity[2] = n0;
    result.mass_position[0] = n0;
    result.mass_position[1] = z0;
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
    result.mass_velocity[1] = z1;
    result.mass_velocity[2] = n0;
    result.mass_angular_velocity[0] = n0;
    result.mass_angular_velocity[1] = n0;
    result.mass_angular_velocity[2] = n0;
    result.H_position[0] = n0;
    result.H_position[1] = q_lambda;
    result.H_position[2] = n0;
    result.H_velocity[0] = n0;
    result.H_velocity[1] = v_lambda;
    result.H_velocity[2] = n0;
    result.H_jacobian[0] = n0;
    result.H_jacobian[3] = n0;
    result.H_jacobian[1] = n1;
    result.H_jacobian[4] = n0;
    result.H_jacobian[2] = n0;
    result.H_jacobian[5] = n0;
    result.P_position[0] = n0;
    result.P_position[1] = z0;
    result.P_position[2] = n0;
    result.P_velocity[0] = n0;
    result.P_velocity[1] = z1;
    result.P_velocity[2] = n0;
    result.P_jacobian[0] = n0;
    result.P_jacobian[3] = n0;
    result.P_jacobian[1] = n1;
    result.P_jacobian[4] = n1;
    result.P_jacobian[2] = n0;
    result.P_jacobian[5] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    mass[0] = n4;
    mass[1] = n1;
    mass[2] = n1;
    mass[3] = n1;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n80 = traits::constant(80.0, 80.0f, "80/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar q_l = state.q.l;
    const Scalar z0 = q_l * q_l;
    const Scalar z1 = traits::sqrt(z0);
    const Scalar z2 = n1 / z1;
    const Scalar z3 = n400 - n80 * z2;
    const Scalar z4 = q_l * z3;
    const Scalar z5 = n9_81 + z4;  // force on mass, y
    const Scalar z6 = n29_43 - z4 + z5;  // force on support, y
    forces.lambda = z6;
    forces.l = z5;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n80 = traits::constant(80.0, 80.0f, "80/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar a_lambda = accelerations.lambda;
    const Scalar q_l = state.q.l;
    const Scalar a_l = accelerations.l;
    const Scalar z0 = q_l * q_l;
    const Scalar z1 = n9_81 + a_lambda;
    const Scalar z2 = traits::sqrt(z0);
    const Scalar z3 = a_l + z1;
    const Scalar z4 = n1 / z2;
    const Scalar z5 = n400 - n80 * z4;
    const Scalar z6 = q_l * z5;
    const Scalar z7 = z6 + z3;  // force on mass, y
    const Scalar z8 = z6 - n3 * z1 - z7;  // force on support, y
    forces.lambda = -z8;
    forces.l = z7;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n80 = traits::constant(80.0, 80.0f, "80/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_l = state.q.l;
    const Scalar z0 = q_l * q_l;
    const Scalar z1 = traits::sqrt(z0);
    const Scalar z2 = n1 / z1;
    const Scalar z3 = n400 - n80 * z2;
    const Scalar z4 = q_l * z3;
    const Scalar z5 = n9_81 + z4;
    const Scalar z6 = n29_43 - z4;
    const Scalar z7 = n1_over_3 * z6;
    const Scalar z8 = z5 - z7;
    accelerations.lambda = -z7;
    accelerations.l = -z8;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.lambda * accelerations.l;
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
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_lambda = state.q.lambda;
    const Scalar v_lambda = state.v.lambda;
    const Scalar q_l = state.q.l;
    const Scalar v_l = state.v.l;
    const Scalar z0 = q_l * q_l;
    const Scalar z1 = v_lambda + v_l;  // velocity of mass, y
    const Scalar z2 = q_lambda + q_l;
    const Scalar z3 = traits::sqrt(z0);
    const Scalar z4 = n0_2 - z3;
    result.kinetic = n1_5 * v_lambda * v_lambda + n0_5 * z1 * z1;
    result.force_function = -n29_43 * q_lambda - n9_81 * z2 - n200 * z4 * z4;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n200 = traits::constant(200.0, 200.0f, "200/1");
    const Scalar q_lambda = state.q.lambda;
    const Scalar v_lambda = state.v.lambda;
    const Scalar q_l = state.q.l;
    const Scalar v_l = state.v.l;
    const Scalar z0 = q_l * q_l;
    const Scalar z1 = v_lambda + v_l;  // velocity of mass, y
    const Scalar z2 = q_lambda + q_l;
    const Scalar z3 = traits::sqrt(z0);
    const Scalar z4 = n0_2 - z3;
    result.energy = n29_43 * q_lambda + n1_5 * v_lambda * v_lambda + n0_5 * z1 * z1 + n9_81 * z2 + n200 * z4 * z4;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n80 = traits::constant(80.0, 80.0f, "80/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_lambda = accelerations.lambda;
    const Scalar q_l = state.q.l;
    const Scalar a_l = accelerations.l;
    const Scalar z0 = q_l * q_l;
    const Scalar z1 = n2 * q_l;
    const Scalar z2 = n9_81 + a_lambda;
    const Scalar z3 = traits::sqrt(z0);
    const Scalar z4 = a_l + z2;
    const Scalar z5 = n1 / z3;
    const Scalar z6 = n0_5 * z1 / z3;
    const Scalar z7 = n400 - n80 * z5;
    const Scalar z8 = z6 / (z3 * z3);
    const Scalar z9 = q_l * z7;
    const Scalar z10 = z9 + z4;  // force on mass, y
    const Scalar z11 = z9 - n3 * z2 - z10;  // force on support, y
    const Scalar z12 = n80 * z8;
    const Scalar z13 = q_l * z12 + z7;
    const Scalar z14 = n1_over_3 * z13;
    const Scalar z15 = z13 + z14;
    result.M[0] = n4;
    result.M[1] = n1;
    result.M[2] = n1;
    result.M[3] = n1;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = z13;
    result.F[0] = z11;
    result.F[1] = -z10;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = n0;
    result.A[3] = n0;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = z14;
    result.A[7] = -z15;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = n0;
    result.A[11] = n0;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = n0;
    result.A[15] = n0;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.K[3] * result.F[0] * result.F[1] * result.A[6] * result.A[7];
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
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace shaker_free_support
