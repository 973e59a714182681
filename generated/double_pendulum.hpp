// SPDX-License-Identifier: MIT-0
// double_pendulum: Planar double pendulum with absolute angles
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation, inverse_dynamics_derivatives, forward_dynamics_derivatives, regressor, jets, inverse_dynamics_second_derivatives, forward_dynamics_second_derivatives
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function                             additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                                   4                4          0             0                  2       0     12      12
//   mass_matrix                                  1                0          0             0                  1       0      3       3
//   bias                                         4                8          0             0                  2       0     16      16
//   inverse_dynamics                            10                9          0             0                  2       0     23      24
//   forward_dynamics                             7               12          1             0                  2       0     24      24
//   energy                                       6                8          0             0                  3       0     20      24
//   first_integrals                              7                8          0             0                  3       0     21      25
//   linearisation                               26               32          1             0                  2       0     63      66
//   inverse_dynamics_derivatives                13               15          0             0                  2       0     32      34
//   forward_dynamics_derivatives                24               36          1             0                  2       0     65      67
//   regressor                                    7               12          0             0                  2       0     23      23
//   jets                                        32               41          1             0                  2       0     78       -
//   inverse_dynamics_second_derivatives         15               16          0             0                  2       0     35      37
//   forward_dynamics_second_derivatives         56               72          1             0                  2       0    133     145
//
// Not computed because this mechanism does not need it:
//   kinematics: of 36 results 16 vanish identically, 6 repeat another up to sign
//   mass_matrix: of 4 results 1 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 30 results 8 vanish identically, 1 repeat another up to sign
//   inverse_dynamics_derivatives: of 8 results 2 vanish identically
//   forward_dynamics_derivatives: of 12 results 1 repeat another up to sign
//   regressor: of 12 results 4 vanish identically
//   inverse_dynamics_second_derivatives: of 32 results 14 vanish identically, 9 repeat another up to sign
//   forward_dynamics_second_derivatives: of 24 results 4 vanish identically, 6 repeat another up to sign
//
// To write this file again:
//   double_pendulum_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,inverse_dynamics_derivatives,forward_dynamics_derivatives,regressor,jets,inverse_dynamics_second_derivatives,forward_dynamics_second_derivatives --support torsor_support.hpp --output double_pendulum.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace double_pendulum {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"theta_1", "rad"}, {"theta_2", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"theta_1", "rad/s"}, {"theta_2", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 36> results{{{"result", "first_mass_position", 3, 1, 1, "m"},
      {"result", "first_mass_rotation", 3, 3, 2, "1"}, {"result", "first_mass_velocity", 3, 1, 1, "m/s"}, {"result",
      "first_mass_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "second_mass_position", 3, 1, 1, "m"}, {"result",
      "second_mass_rotation", 3, 3, 2, "1"}, {"result", "second_mass_velocity", 3, 1, 1, "m/s"}, {"result",
      "second_mass_angular_velocity", 3, 1, 1, "rad/s"}, {"mass", "", 2, 2, 2, "kg m^2"}, {"forces", "", 2, 1, 1,
      "N m"}, {"forces", "", 2, 1, 1, "N m"}, {"accelerations", "", 2, 1, 1, "rad/s^2"}, {"multipliers", "", 0, 1, 1,
      ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0,
      "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result", "M", 2, 2, 2, "kg m^2"}, {"result", "C", 2, 2, 2, "N m s"},
      {"result", "K", 2, 2, 2, "N m"}, {"result", "F", 2, 1, 1, "N m"}, {"result", "A", 4, 4, 2, ""}, {"result",
      "by_position", 2, 2, 2, "N m"}, {"result", "by_velocity", 2, 2, 2, "N m s"}, {"result", "by_position", 2, 2, 2,
      "1/s^2"}, {"result", "by_velocity", 2, 2, 2, "1/s"}, {"result", "by_force", 2, 2, 2, "1/kg/m^2"}, {"result", "Y",
      2, 6, 2, ""}, {"coefficients", "", 4, 0, 2, ""}, {"result", "by_position_position", 2, 4, 2, "N m"}, {"result",
      "by_position_velocity", 2, 4, 2, "N m s"}, {"result", "by_velocity_velocity", 2, 4, 2, "kg m^2"}, {"result",
      "by_acceleration_position", 2, 4, 2, "kg m^2"}, {"result", "by_position_position", 2, 4, 2, "1/s^2"}, {"result",
      "by_position_velocity", 2, 4, 2, "1/s"}, {"result", "by_velocity_velocity", 2, 4, 2, "1"}}};
  static constexpr std::array<torsor::KernelDescription, 14> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 8}, {"mass_matrix", false, false, false, false, results.data() + 8, 1}, {"bias", false, false,
      false, false, results.data() + 9, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 10, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 11, 2}, {"energy", false, false, true, false,
      results.data() + 13, 3}, {"first_integrals", false, false, false, false, results.data() + 16, 1},
      {"linearisation", true, true, true, true, results.data() + 17, 5}, {"inverse_dynamics_derivatives", true, true,
      false, false, results.data() + 22, 2}, {"forward_dynamics_derivatives", false, false, true, true, results.data()
      + 24, 3}, {"regressor", true, false, false, false, results.data() + 27, 1}, {"jets", false, false, true, true,
      results.data() + 28, 1}, {"inverse_dynamics_second_derivatives", true, true, false, false, results.data() + 29,
      4}, {"forward_dynamics_second_derivatives", false, false, true, true, results.data() + 33, 3}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::double_pendulum::Description;

  static constexpr const char* name = "double_pendulum";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x18d701826494c92dULL ^ torsor::support_fingerprint;
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
    Scalar theta_1;  ///< coordinate [rad]
    Scalar theta_2;  ///< coordinate [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::theta_1, &Coordinates::theta_2};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar theta_1;  ///< its rate [rad/s]
    Scalar theta_2;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::theta_1, &Velocities::theta_2};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar theta_1;  ///< its second rate [rad/s^2]
    Scalar theta_2;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::theta_1, &Accelerations::theta_2};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar theta_1;  ///< works with the rate of theta_1 [N m]
    Scalar theta_2;  ///< works with the rate of theta_2 [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::theta_1, &GeneralizedForces::theta_2};
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
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n2_5 = traits::constant(2.5, 2.5f, "5/2");
    state.time = n0;
    state.q.theta_1 = n2;
    state.q.theta_2 = n2_5;
    state.v.theta_1 = n0;
    state.v.theta_2 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> first_mass_position;  ///< centre of mass of first_mass [m]
    std::array<Scalar, 9> first_mass_rotation;  ///< from the axes of first_mass to the ground's (3 x 3)
    std::array<Scalar, 3> first_mass_velocity;  ///< velocity of the centre of mass of first_mass [m/s]
    std::array<Scalar, 3> first_mass_angular_velocity;  ///< angular velocity of first_mass [rad/s]
    std::array<Scalar, 3> second_mass_position;  ///< centre of mass of second_mass [m]
    std::array<Scalar, 9> second_mass_rotation;  ///< from the axes of second_mass to the ground's (3 x 3)
    std::array<Scalar, 3> second_mass_velocity;  ///< velocity of the centre of mass of second_mass [m/s]
    std::array<Scalar, 3> second_mass_angular_velocity;  ///< angular velocity of second_mass [rad/s]
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

  /// Derivatives of generalised forces, stored column by column.
  struct InverseDynamicsDerivatives {
    std::array<Scalar, 4> by_position;  ///< df_i/dq_j (2 x 2)
    std::array<Scalar, 4> by_velocity;  ///< df_i/dv_j (2 x 2)
  };

  /// Derivatives of accelerations and multipliers, stored column by column.
  struct ForwardDynamicsDerivatives {
    std::array<Scalar, 4> by_position;  ///< da_i/dq_j (2 x 2)
    std::array<Scalar, 4> by_velocity;  ///< da_i/dv_j (2 x 2)
    std::array<Scalar, 4> by_force;  ///< da_i/df_j, f generalised forces added to E u (2 x 2)
  };

  /// What the generalised forces are linear in, stored column by column.
  struct Regressor {
    std::array<Scalar, 12> Y;  ///< forces of unit base parameters (2 x 6)
  };
  /// Standard inertial parameters of the links, ten each about the link's origin in its axes:
  ///   m h_x h_y h_z J_xx J_xy J_xz J_yy J_yz J_zz (J_xy = minus the integral of x y dm).
  /// 0 to 9: frame upper with body first_mass
  /// 10 to 19: frame lower with body second_mass
  static constexpr int inertial_parameter_count = 20;
  /// Base parameters pi_b, by their place in the list above; of the others those that have an effect are
  /// combined with them. First link to last: what a joint cannot tell apart goes towards the ground
  /// (Gautier & Khalil, 1990).
  static constexpr int base_parameter_count = 6;
  static constexpr int base_parameters[6] = {1, 2, 9, 11, 12, 19};
  /// pi_base = pi_b + K pi_d: each pi_base[regrouped_to[k]], from pi[base_parameters[...]], gains
  /// regrouping_factors[k] * pi[regrouped_from[k]].
  static constexpr int regrouping_count = 2;
  static constexpr int regrouped_from[2] = {10, 10};
  static constexpr int regrouped_to[2] = {1, 2};
  static constexpr double regrouping_factors[2] = {-1, 1};

  /// Second derivatives of generalised forces, page by page.
  struct InverseDynamicsSecondDerivatives {
    std::array<Scalar, 8> by_position_position;  ///< d2f_i/dq_j dq_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_position_velocity;  ///< d2f_i/dq_j dv_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_velocity_velocity;  ///< d2f_i/dv_j dv_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_acceleration_position;  ///< d2f_i/da_j dq_k = dM_ij/dq_k, 2 pages (2 x 4)
  };

  /// Second derivatives of accelerations and multipliers, page by page.
  struct ForwardDynamicsSecondDerivatives {
    std::array<Scalar, 8> by_position_position;  ///< d2a_i/dq_j dq_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_position_velocity;  ///< d2a_i/dq_j dv_k, 2 pages (2 x 4)
    std::array<Scalar, 8> by_velocity_velocity;  ///< d2a_i/dv_j dv_k, 2 pages (2 x 4)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar angles_[] = {q_theta_1, q_theta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar s_theta_2 = sines_[1], c_theta_2 = cosines_[1];
    const Scalar z0 = v_theta_1 * c_theta_1;  // velocity of lower, x
    const Scalar z1 = v_theta_1 * s_theta_1;  // velocity of lower, y
    const Scalar z2 = s_theta_1 + s_theta_2;
    const Scalar z3 = c_theta_1 + c_theta_2;
    const Scalar z4 = v_theta_2 * c_theta_2 + z0;
    const Scalar z5 = v_theta_2 * s_theta_2 + z1;
    result.first_mass_position[0] = s_theta_1;
    result.first_mass_position[1] = -c_theta_1;
    result.first_mass_position[2] = n0;
    result.first_mass_rotation[0] = c_theta_1;
    result.first_mass_rotation[1] = s_theta_1;
    result.first_mass_rotation[2] = n0;
    result.first_mass_rotation[3] = -s_theta_1;
    result.first_mass_rotation[4] = c_theta_1;
    result.first_mass_rotation[5] = n0;
    result.first_mass_rotation[6] = n0;
    result.first_mass_rotation[7] = n0;
    result.first_mass_rotation[8] = n1;
    result.first_mass_velocity[0] = z0;
    result.first_mass_velocity[1] = z1;
    result.first_mass_velocity[2] = n0;
    result.first_mass_angular_velocity[0] = n0;
    result.first_mass_angular_velocity[1] = n0;
    result.first_mass_angular_velocity[2] = v_theta_1;
    result.second_mass_position[0] = z2;
    result.second_mass_position[1] = -z3;
    result.second_mass_position[2] = n0;
    result.second_mass_rotation[0] = c_theta_2;
    result.second_mass_rotation[1] = s_theta_2;
    result.second_mass_rotation[2] = n0;
    result.second_mass_rotation[3] = -s_theta_2;
    result.second_mass_rotation[4] = c_theta_2;
    result.second_mass_rotation[5] = n0;
    result.second_mass_rotation[6] = n0;
    result.second_mass_rotation[7] = n0;
    result.second_mass_rotation[8] = n1;
    result.second_mass_velocity[0] = z4;
    result.second_mass_velocity[1] = z5;
    result.second_mass_velocity[2] = n0;
    result.second_mass_angular_velocity[0] = n0;
    result.second_mass_angular_velocity[1] = n0;
    result.second_mass_angular_velocity[2] = v_theta_2;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 4>& mass) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    Scalar z1, z2;
    traits::sincos(z0, z1, z2);
    mass[0] = n2;
    mass[1] = z2;
    mass[2] = z2;
    mass[3] = n1;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = v_theta_2 * v_theta_2;
    const Scalar z6 = n9_81 * s_theta_1;
    const Scalar z7 = z1 * z5;
    const Scalar z8 = z3 + z4;
    const Scalar z9 = z1 * z8 - z2 * z6;
    const Scalar z10 = n2 * z6 + z7;
    forces.theta_1 = z10;
    forces.theta_2 = -z9;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n9_81 * s_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = a_theta_2 * z2 + z1 * z6;
    const Scalar z8 = a_theta_1 + z5;
    const Scalar z9 = z3 + z4;
    const Scalar z10 = z1 * z9 - z2 * z8;
    const Scalar z11 = a_theta_2 - z10;  // moment on lower, z
    const Scalar z12 = n2 * (a_theta_1 + z5) + z7 + z11;  // moment on upper, z
    const Scalar z13 = z11 - z12;
    forces.theta_1 = -z13;
    forces.theta_2 = z11;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 - z2 * z2;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n9_81 * s_theta_1;
    const Scalar z8 = z1 * z6;
    const Scalar z9 = z3 + z4;
    const Scalar z10 = z1 * z9 - z2 * z7;
    const Scalar z11 = n2 * z7 + z8;
    const Scalar z12 = n1 / z5;
    const Scalar z13 = z2 * z10 + z11;
    const Scalar z14 = z12 * z13;
    const Scalar z15 = z2 * z14 + z10;
    accelerations.theta_1 = -z14;
    accelerations.theta_2 = z15;
    if (!(traits::regular(z5, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.theta_1 * accelerations.theta_2;
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0, q_theta_2};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar c_theta_2 = cosines_[2];
    const Scalar z3 = v_theta_1 * z2;
    const Scalar z4 = v_theta_1 * z1;
    const Scalar z5 = v_theta_2 + z3;
    result.kinetic = n0_5 * (v_theta_1 * v_theta_1 + z4 * z4 + z5 * (v_theta_2 + z3));
    result.force_function = n19_62 * c_theta_1 + n9_81 * c_theta_2;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0, q_theta_2};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar c_theta_2 = cosines_[2];
    const Scalar z3 = v_theta_1 * z2;
    const Scalar z4 = v_theta_1 * z1;
    const Scalar z5 = v_theta_2 + z3;
    result.energy = n0_5 * (v_theta_1 * v_theta_1 + z4 * z4 + z5 * (v_theta_2 + z3)) - n19_62 * c_theta_1 - n9_81
        * c_theta_2;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * s_theta_1;
    const Scalar z4 = n9_81 * c_theta_1;
    const Scalar z5 = v_theta_1 * v_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n2 - z2 * z2;
    const Scalar z8 = a_theta_2 * z1 - z2 * z6;
    const Scalar z9 = n2 * v_theta_1;
    const Scalar z10 = a_theta_2 * z2 + z1 * z6;
    const Scalar z11 = z1 * z9;
    const Scalar z12 = n2 * v_theta_2;
    const Scalar z13 = z1 * z12;
    const Scalar z14 = a_theta_1 + z3;
    const Scalar z15 = z4 + z5;
    const Scalar z16 = z1 * z15 - z2 * z14;
    const Scalar z17 = z1 * z14 + z2 * z15;
    const Scalar z18 = z1 * (z3 - z14) + z2 * (z4 - z15);
    const Scalar z19 = z2 * z11;
    const Scalar z20 = n1 / z7;
    const Scalar z21 = a_theta_2 - z16;  // moment on lower, z
    const Scalar z22 = z17 + z8;
    const Scalar z23 = n2 * (a_theta_1 + z3) + z10 + z21;  // moment on upper, z
    const Scalar z24 = n2 * z4 - z8 + z18;
    const Scalar z25 = z17 - z22;
    const Scalar z26 = z21 - z23;
    const Scalar z27 = z18 - z24;
    const Scalar z28 = z2 * z17 + z25;
    const Scalar z29 = z20 * z19;
    const Scalar z30 = z13 * z20;
    const Scalar z31 = z2 * z18 + z27;
    const Scalar z32 = z2 * z29 + z11;
    const Scalar z33 = z20 * z28;
    const Scalar z34 = z2 * z30;
    const Scalar z35 = z20 * z31;
    const Scalar z36 = z2 * z33 + z17;
    const Scalar z37 = z2 * z35 + z18;
    result.M[0] = n2;
    result.M[1] = z2;
    result.M[2] = z2;
    result.M[3] = n1;
    result.C[0] = n0;
    result.C[1] = -z11;
    result.C[2] = z13;
    result.C[3] = n0;
    result.K[0] = -z27;
    result.K[1] = z18;
    result.K[2] = -z25;
    result.K[3] = z17;
    result.F[0] = z26;
    result.F[1] = -z21;
    result.A[0] = n0;
    result.A[1] = n0;
    result.A[2] = z35;
    result.A[3] = -z37;
    result.A[4] = n0;
    result.A[5] = n0;
    result.A[6] = z33;
    result.A[7] = -z36;
    result.A[8] = n1;
    result.A[9] = n0;
    result.A[10] = -z29;
    result.A[11] = z32;
    result.A[12] = n0;
    result.A[13] = n1;
    result.A[14] = -z30;
    result.A[15] = z34;
    if (!(traits::regular(z7, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.M[1] * result.M[2] * result.C[1] * result.C[2] * result.K[0] * result.K[1]
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

  /// Derivatives of inverse_dynamics at (q, v, a, lambda). That by accelerations is the mass matrix.
  TORSOR_DEVICE static void inverse_dynamics_derivatives(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, InverseDynamicsDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * s_theta_1;
    const Scalar z4 = n9_81 * c_theta_1;
    const Scalar z5 = v_theta_1 * v_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n2 * v_theta_1;
    const Scalar z8 = n2 * v_theta_2;
    const Scalar z9 = a_theta_2 * z1 - z2 * z6;
    const Scalar z10 = z1 * z7;
    const Scalar z11 = z1 * z8;
    const Scalar z12 = a_theta_1 + z3;
    const Scalar z13 = z4 + z5;
    const Scalar z14 = z1 * z12 + z2 * z13;
    const Scalar z15 = z1 * (z3 - z12) + z2 * (z4 - z13);
    const Scalar z16 = z14 + z9;
    const Scalar z17 = n2 * z4 - z9 + z15;
    const Scalar z18 = z14 - z16;
    const Scalar z19 = z15 - z17;
    result.by_position[0] = -z19;
    result.by_position[1] = z15;
    result.by_position[2] = -z18;
    result.by_position[3] = z14;
    result.by_velocity[0] = n0;
    result.by_velocity[1] = -z10;
    result.by_velocity[2] = z11;
    result.by_velocity[3] = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, InverseDynamicsDerivatives& result) noexcept {
    Mechanism::inverse_dynamics_derivatives(precomputed, state, accelerations, Multipliers(), result);
  }

  /// Derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion, by
  /// solving with the factorisation of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_derivatives(const Precomputed&, const State& state,
      const Inputs&, ForwardDynamicsDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 - z2 * z2;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n9_81 * s_theta_1;
    const Scalar z8 = z1 * z6;
    const Scalar z9 = n2 * v_theta_1;
    const Scalar z10 = z1 * z9;
    const Scalar z11 = n2 * v_theta_2;
    const Scalar z12 = z1 * z11;
    const Scalar z13 = z3 + z4;
    const Scalar z14 = z1 * z13 - z2 * z7;
    const Scalar z15 = n2 * z7 + z8;
    const Scalar z16 = z2 * z10;
    const Scalar z17 = n1 / z5;
    const Scalar z18 = z2 * z14 + z15;
    const Scalar z19 = z17 * z18;
    const Scalar z20 = z17 * z16;
    const Scalar z21 = z2 * z17;
    const Scalar z22 = z12 * z17;
    const Scalar z23 = z2 * z19 + z14;
    const Scalar z24 = z7 - z19;
    const Scalar z25 = z2 * z20 + z10;
    const Scalar z26 = z2 * z22;
    const Scalar z27 = n1 + z2 * z21;
    const Scalar z28 = z2 * (z3 - z13) + z1 * (z7 - z24);
    const Scalar z29 = z2 * z13 + z1 * z24;
    const Scalar z30 = z1 * z23 - z2 * z6;
    const Scalar z31 = n2 * z3 + z28 - z30;
    const Scalar z32 = z30 + z29;
    const Scalar z33 = z29 - z32;
    const Scalar z34 = z28 - z31;
    const Scalar z35 = z2 * z29 + z33;
    const Scalar z36 = z2 * z28 + z34;
    const Scalar z37 = z17 * z35;
    const Scalar z38 = z17 * z36;
    const Scalar z39 = z2 * z37 + z29;
    const Scalar z40 = z2 * z38 + z28;
    result.by_position[0] = z38;
    result.by_position[1] = -z40;
    result.by_position[2] = z37;
    result.by_position[3] = -z39;
    result.by_velocity[0] = -z20;
    result.by_velocity[1] = z25;
    result.by_velocity[2] = -z22;
    result.by_velocity[3] = z26;
    result.by_force[0] = z17;
    result.by_force[1] = -z21;
    result.by_force[2] = -z21;
    result.by_force[3] = z27;
    if (!(traits::regular(z5, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.by_position[0] * result.by_position[1] * result.by_position[2]
        * result.by_position[3] * result.by_velocity[0] * result.by_velocity[1] * result.by_velocity[2]
        * result.by_velocity[3] * result.by_force[0] * result.by_force[1] * result.by_force[2] * result.by_force[3];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      ForwardDynamicsDerivatives& result) noexcept {
    return Mechanism::forward_dynamics_derivatives(precomputed, state, Inputs(), result);
  }

  /// Regressor: Y pi_base are the generalised forces of inertia and gravity at (q, v, a), inverse_dynamics without
  /// other actions and multipliers. Y has the columns of base_parameters only: those of the other inertial
  /// parameters are combinations of them, no measurement tells them apart, and least squares with them are singular.
  TORSOR_DEVICE static void regressor(const Precomputed&, const State& state, const Accelerations& accelerations,
      Regressor& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * s_theta_1;
    const Scalar z4 = n9_81 * c_theta_1;
    const Scalar z5 = v_theta_1 * v_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = a_theta_2 * z1 - z2 * z6;
    const Scalar z8 = a_theta_2 * z2 + z1 * z6;
    const Scalar z9 = a_theta_1 + z3;
    const Scalar z10 = z4 + z5;
    const Scalar z11 = z1 * z10 - z2 * z9;
    const Scalar z12 = z1 * z9 + z2 * z10;
    result.Y[0] = z4;
    result.Y[1] = n0;
    result.Y[2] = -z3;
    result.Y[3] = n0;
    result.Y[4] = a_theta_1;
    result.Y[5] = n0;
    result.Y[6] = z7;
    result.Y[7] = z12;
    result.Y[8] = -z8;
    result.Y[9] = z11;
    result.Y[10] = n0;
    result.Y[11] = a_theta_2;
  }

  /// Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions
  /// then velocities, the inputs being constant. 10 operations take a convolution at each order; accelerations
  /// are solved for, in the inverse dynamics, by the factors of M at the start.
  /// Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed&, const State& state, const Inputs&, int order,
      std::array<Scalar, 4>* coefficients) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 - z2 * z2;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n9_81 * s_theta_1;
    const Scalar z8 = z1 * z6;
    const Scalar z9 = z3 + z4;
    const Scalar z10 = z1 * z9 - z2 * z7;
    const Scalar z11 = n2 * z7 + z8;
    const Scalar z12 = n1 / z5;
    const Scalar z13 = z2 * z10 + z11;
    const Scalar z14 = z12 * z13;
    const Scalar z15 = z2 * z14 + z10;
    const Scalar b11 = v_theta_2 * v_theta_2;
    const Scalar b14 = v_theta_1 * v_theta_1;
    const Scalar b15 = n9_81 * c_theta_1 + b14;
    const Scalar b7 = z15;
    const Scalar b2 = -z14;
    const Scalar b17 = b2 + n9_81 * s_theta_1;
    coefficients[0][0] = state.q.theta_1;
    coefficients[0][1] = state.q.theta_2;
    coefficients[0][2] = state.v.theta_1;
    coefficients[0][3] = state.v.theta_2;
    coefficients[1][0] = v_theta_1;
    coefficients[1][1] = v_theta_2;
    coefficients[1][2] = -z14;
    coefficients[1][3] = z15;
    torsor::Convolutions<Scalar, 10> operations_;
    typename torsor::Convolutions<Scalar, 10>::Sums sums_;
    Scalar number_ = n1, inverse_ = n1;
    for (int k_ = 1; k_ < order; ++k_) {
      const Scalar following_ = number_ + n1, next_ = n1 / following_;
      operations_.sum(k_, sums_);
      const Scalar x0 = coefficients[k_][0];
      const Scalar x1 = coefficients[k_][2];
      const Scalar x3 = inverse_ * sums_[0] + c_theta_1 * x0;
      const Scalar w0 = number_ * x0;
      const Scalar x4 = -inverse_ * sums_[1] - s_theta_1 * x0;
      const Scalar x5 = coefficients[k_][1];
      const Scalar x6 = coefficients[k_][3];
      const Scalar x8 = x0 - x5;
      const Scalar x9 = inverse_ * sums_[2] + z2 * x8;
      const Scalar w8 = number_ * x8;
      const Scalar x10 = -inverse_ * sums_[3] - z1 * x8;
      const Scalar x11 = sums_[4] + (v_theta_2 + v_theta_2) * x6;
      const Scalar x12 = sums_[5] + z1 * x11 + b11 * x9;
      const Scalar x14 = sums_[7] + (v_theta_1 + v_theta_1) * x1;
      const Scalar x15 = n9_81 * x4 + x14;
      const Scalar x16 = sums_[8] + z1 * x15 + b15 * x9;
      const Scalar o13 = sums_[6] + b7 * x10;
      const Scalar o17 = n9_81 * x3;
      const Scalar o18 = sums_[9] + b17 * x10;
      const Scalar p18 = o18 + z2 * o17;
      const Scalar r1 = -(-x16 + p18);
      const Scalar r0 = -(n19_62 * x3 + x12 + o13) - z2 * r1;
      const Scalar a0 = z12 * r0;
      const Scalar a1 = r1 - z2 * a0;
      const Scalar x17 = o17 + a0;
      coefficients[k_ + 1][0] = next_ * x1;
      coefficients[k_ + 1][1] = next_ * x6;
      coefficients[k_ + 1][2] = next_ * a0;
      coefficients[k_ + 1][3] = next_ * a1;
      const Scalar left_[] = {w0, w0, w8, w8, x6, x9, a1, x1, x9, x10};
      const Scalar right_[] = {x4, x3, x10, x9, x6, x11, x10, x1, x15, x17};
      operations_.keep(k_, left_, right_);
      number_ = following_;
      inverse_ = next_;
    }
    static_cast<void>(inverse_);
    if (!(traits::regular(z5, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * coefficients[order][0] * coefficients[order][1] * coefficients[order][2]
        * coefficients[order][3];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed& precomputed, const State& state, int order,
      std::array<Scalar, 4>* coefficients) noexcept {
    return Mechanism::jets(precomputed, state, Inputs(), order, coefficients);
  }

  /// Second derivatives of inverse_dynamics at (q, v, a, lambda). It is linear in a: d2f/da dq has the derivatives of
  /// the mass matrix, and what else has an a is zero.
  /// Each member x_by_y_z has one page for each z_k, the derivative of a matrix by z_k: the entry of row i and column
  /// j of page k is [i + rows * (j + columns * k)].
  TORSOR_DEVICE static void inverse_dynamics_second_derivatives(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, InverseDynamicsSecondDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar a_theta_1 = accelerations.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar a_theta_2 = accelerations.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n9_81 * s_theta_1;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n2 * v_theta_1;
    const Scalar z8 = n2 * v_theta_2;
    const Scalar z9 = a_theta_2 * z2 + z1 * z6;
    const Scalar z10 = z2 * z7;
    const Scalar z11 = z2 * z8;
    const Scalar z12 = n2 * z1;
    const Scalar z13 = a_theta_1 + z5;
    const Scalar z14 = z3 + z4;
    const Scalar z15 = z1 * z14 - z2 * z13;
    const Scalar z16 = z1 * (z3 - z14) - z2 * (z5 - z13);
    const Scalar z17 = z15 - z9;
    const Scalar z18 = n2 * z5 + z9 + z16;
    const Scalar z19 = z9 + z16;
    const Scalar z20 = z15 - z17;
    const Scalar z21 = z16 - z18;
    const Scalar z22 = z16 - z19;
    result.by_position_position[0] = z21;
    result.by_position_position[1] = -z16;
    result.by_position_position[2] = -z22;
    result.by_position_position[3] = z16;
    result.by_position_position[4] = -z22;
    result.by_position_position[5] = z16;
    result.by_position_position[6] = -z20;
    result.by_position_position[7] = z15;
    result.by_position_velocity[0] = n0;
    result.by_position_velocity[1] = -z10;
    result.by_position_velocity[2] = n0;
    result.by_position_velocity[3] = z10;
    result.by_position_velocity[4] = z11;
    result.by_position_velocity[5] = n0;
    result.by_position_velocity[6] = -z11;
    result.by_position_velocity[7] = n0;
    result.by_velocity_velocity[0] = n0;
    result.by_velocity_velocity[1] = -z12;
    result.by_velocity_velocity[2] = n0;
    result.by_velocity_velocity[3] = n0;
    result.by_velocity_velocity[4] = n0;
    result.by_velocity_velocity[5] = n0;
    result.by_velocity_velocity[6] = z12;
    result.by_velocity_velocity[7] = n0;
    result.by_acceleration_position[0] = n0;
    result.by_acceleration_position[1] = -z1;
    result.by_acceleration_position[2] = -z1;
    result.by_acceleration_position[3] = n0;
    result.by_acceleration_position[4] = n0;
    result.by_acceleration_position[5] = z1;
    result.by_acceleration_position[6] = z1;
    result.by_acceleration_position[7] = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics_second_derivatives(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, InverseDynamicsSecondDerivatives& result) noexcept {
    Mechanism::inverse_dynamics_second_derivatives(precomputed, state, accelerations, Multipliers(), result);
  }

  /// Second derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion;
  /// it is linear in u. Returns singular where forward_dynamics does.
  /// Each member x_by_y_z has one page for each z_k, the derivative of a matrix by z_k: the entry of row i and column
  /// j of page k is [i + rows * (j + columns * k)].
  TORSOR_DEVICE static torsor::Status forward_dynamics_second_derivatives(const Precomputed&, const State& state,
      const Inputs&, ForwardDynamicsSecondDerivatives& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta_1 = state.q.theta_1;
    const Scalar v_theta_1 = state.v.theta_1;
    const Scalar q_theta_2 = state.q.theta_2;
    const Scalar v_theta_2 = state.v.theta_2;
    const Scalar z0 = q_theta_1 - q_theta_2;
    const Scalar angles_[] = {q_theta_1, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta_1 = sines_[0], c_theta_1 = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = n9_81 * c_theta_1;
    const Scalar z4 = v_theta_1 * v_theta_1;
    const Scalar z5 = n2 - z2 * z2;
    const Scalar z6 = v_theta_2 * v_theta_2;
    const Scalar z7 = n9_81 * s_theta_1;
    const Scalar z8 = z1 * z6;
    const Scalar z9 = n2 * v_theta_1;
    const Scalar z10 = z1 * z9;
    const Scalar z11 = n2 * v_theta_2;
    const Scalar z12 = z1 * z11;
    const Scalar z13 = z2 * z9;
    const Scalar z14 = z2 * z11;
    const Scalar z15 = n2 * z1;
    const Scalar z16 = z3 + z4;
    const Scalar z17 = z1 * z16;
    const Scalar z18 = n2 * z7 + z8;
    const Scalar z19 = z2 * z10;
    const Scalar z20 = n1 / z5;
    const Scalar z21 = z2 * z7 - z17;
    const Scalar z22 = z2 * z21 - z18;
    const Scalar z23 = z20 * z22;
    const Scalar z24 = z20 * z19;
    const Scalar z25 = z20 * z12;
    const Scalar z26 = z2 * z23 + z21;
    const Scalar z27 = z2 * z15;
    const Scalar z28 = z20 * z15;
    const Scalar z29 = z20 * z27;
    const Scalar z30 = z7 + z23;
    const Scalar z31 = z2 * z24 + z10;
    const Scalar z32 = z2 * z25;
    const Scalar z33 = z1 * z24 - z13;
    const Scalar z34 = z1 * z25;
    const Scalar z35 = z2 * z28;
    const Scalar z36 = z2 * z29 + z15;
    const Scalar z37 = z2 * (z3 - z16) + z1 * (z7 - z30);
    const Scalar z38 = z2 * z16 + z1 * z30;
    const Scalar z39 = z1 * (z3 - z16) - z2 * (z7 - z30);
    const Scalar z40 = z2 * z30 - z17;
    const Scalar z41 = z1 * z32 - z14;
    const Scalar z42 = z2 * z6 + z1 * z26;
    const Scalar z43 = z2 * z26 - z8;
    const Scalar z44 = z1 * z31;
    const Scalar z45 = z2 * z33 + z44;
    const Scalar z46 = z2 * z34 + z41;
    const Scalar z47 = z42 - z38;
    const Scalar z48 = z43 - z40;
    const Scalar z49 = n2 * z3 + z37 + z42;
    const Scalar z50 = z39 - z43;
    const Scalar z51 = n2 * z7 + z39 - z43;
    const Scalar z52 = z38 + z47;
    const Scalar z53 = z40 + z48;
    const Scalar z54 = z20 * z45;
    const Scalar z55 = z20 * z46;
    const Scalar z56 = z39 - z50;
    const Scalar z57 = z2 * z38 + z52;
    const Scalar z58 = z2 * z54 + z33;
    const Scalar z59 = z2 * z55 + z34;
    const Scalar z60 = z37 - z49;
    const Scalar z61 = z39 - z51;
    const Scalar z62 = z20 * z57;
    const Scalar z63 = z2 * z37 + z60;
    const Scalar z64 = z2 * z62 + z38;
    const Scalar z65 = z62 * z15 - z40;
    const Scalar z66 = z20 * z63;
    const Scalar z67 = z64 * z15 - z53;
    const Scalar z68 = z2 * z66 + z37;
    const Scalar z69 = z1 * (z66 - z62) + z39;
    const Scalar z70 = z66 * z15 + z39;
    const Scalar z71 = z2 * z65 + z67;
    const Scalar z72 = z1 * (z68 - z64) + z56;
    const Scalar z73 = z68 * z15 + z61;
    const Scalar z74 = z20 * z71;
    const Scalar z75 = z2 * z70 + z73;
    const Scalar z76 = z2 * z74 + z65;
    const Scalar z77 = z2 * z69 + z72;
    const Scalar z78 = z20 * z75;
    const Scalar z79 = z20 * z77;
    const Scalar z80 = z2 * z78 + z70;
    const Scalar z81 = z2 * z79 + z69;
    result.by_position_position[0] = -z78;
    result.by_position_position[1] = z80;
    result.by_position_position[2] = z79;
    result.by_position_position[3] = -z81;
    result.by_position_position[4] = z79;
    result.by_position_position[5] = -z81;
    result.by_position_position[6] = z74;
    result.by_position_position[7] = -z76;
    result.by_position_velocity[0] = z54;
    result.by_position_velocity[1] = -z58;
    result.by_position_velocity[2] = -z54;
    result.by_position_velocity[3] = z58;
    result.by_position_velocity[4] = z55;
    result.by_position_velocity[5] = -z59;
    result.by_position_velocity[6] = -z55;
    result.by_position_velocity[7] = z59;
    result.by_velocity_velocity[0] = -z29;
    result.by_velocity_velocity[1] = z36;
    result.by_velocity_velocity[2] = n0;
    result.by_velocity_velocity[3] = n0;
    result.by_velocity_velocity[4] = n0;
    result.by_velocity_velocity[5] = n0;
    result.by_velocity_velocity[6] = -z28;
    result.by_velocity_velocity[7] = z35;
    if (!(traits::regular(z5, n2))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * result.by_position_position[0] * result.by_position_position[1]
        * result.by_position_position[2] * result.by_position_position[3] * result.by_position_position[4]
        * result.by_position_position[5] * result.by_position_position[6] * result.by_position_position[7]
        * result.by_position_velocity[0] * result.by_position_velocity[1]) * (n0 * result.by_position_velocity[2]
        * result.by_position_velocity[3] * result.by_position_velocity[4] * result.by_position_velocity[5]
        * result.by_position_velocity[6] * result.by_position_velocity[7] * result.by_velocity_velocity[0]
        * result.by_velocity_velocity[1] * result.by_velocity_velocity[6] * result.by_velocity_velocity[7]);
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics_second_derivatives(const Precomputed& precomputed,
      const State& state, ForwardDynamicsSecondDerivatives& result) noexcept {
    return Mechanism::forward_dynamics_second_derivatives(precomputed, state, Inputs(), result);
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
    visitor(Description::kernels[8],
        KernelFunction<void, const Accelerations&, const Multipliers&, InverseDynamicsDerivatives&>(inverse_dynamics_derivatives));
    visitor(Description::kernels[9],
        KernelFunction<torsor::Status, const Inputs&, ForwardDynamicsDerivatives&>(forward_dynamics_derivatives));
    visitor(Description::kernels[10], KernelFunction<void, const Accelerations&, Regressor&>(regressor));
    visitor(Description::kernels[11], KernelFunction<torsor::Status, const Inputs&, int, std::array<Scalar, 4>*>(jets));
    visitor(Description::kernels[12],
        KernelFunction<void, const Accelerations&, const Multipliers&, InverseDynamicsSecondDerivatives&>(inverse_dynamics_second_derivatives));
    visitor(Description::kernels[13],
        KernelFunction<torsor::Status, const Inputs&, ForwardDynamicsSecondDerivatives&>(forward_dynamics_second_derivatives));
  }
};

}  // namespace double_pendulum
