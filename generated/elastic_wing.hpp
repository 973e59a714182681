// SPDX-License-Identifier: MIT-0
// elastic_wing: Half an aircraft with an elastic wing and an engine
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, linearisation
// Parameters set at run time: gust
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics               60               45          0             0                  5       0    115     115
//   mass_matrix              35               41          0             0                  5       0     86      90
//   bias                     55               67          0             0                  8       0    138     139
//   inverse_dynamics         79               89          0             0                  8       0    184     185
//   forward_dynamics        120              159          4             0                  8       0    299     300
//   energy                   66              105          0             0                  8       0    187     199
//   linearisation           471              594          4             0                  8       0   1085    1115
//
// Not computed because this mechanism does not need it:
//   kinematics: of 228 results 120 vanish identically, 28 repeat another up to sign
//   mass_matrix: of 36 results 6 vanish identically, 12 repeat another up to sign
//   first_integrals: left out, 'friction_1', 'friction_2', 'friction_3', 'friction_4', 'pylon_friction' have no force function; 'gust_1', 'gust_2', 'gust_3', 'gust_4' have force functions that are not stated
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 258 results 108 vanish identically, 12 repeat another up to sign
//
// To write this file again:
//   elastic_wing_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output elastic_wing.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace elastic_wing {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 6> coordinates{{{"z", "m"}, {"beta_1", "rad"}, {"beta_2",
      "rad"}, {"beta_3", "rad"}, {"beta_4", "rad"}, {"gamma", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 6> velocities{{{"z", "m/s"}, {"beta_1", "rad/s"}, {"beta_2",
      "rad/s"}, {"beta_3", "rad/s"}, {"beta_4", "rad/s"}, {"gamma", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"gust", "N"}}};
  static constexpr std::array<torsor::ResultDescription, 52> results{{{"result", "fuselage_position", 3, 1, 1, "m"},
      {"result", "fuselage_rotation", 3, 3, 2, "1"}, {"result", "fuselage_velocity", 3, 1, 1, "m/s"}, {"result",
      "fuselage_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "panel_1_position", 3, 1, 1, "m"}, {"result",
      "panel_1_rotation", 3, 3, 2, "1"}, {"result", "panel_1_velocity", 3, 1, 1, "m/s"}, {"result",
      "panel_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "panel_2_position", 3, 1, 1, "m"}, {"result",
      "panel_2_rotation", 3, 3, 2, "1"}, {"result", "panel_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "panel_2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "panel_3_position", 3, 1, 1, "m"}, {"result",
      "panel_3_rotation", 3, 3, 2, "1"}, {"result", "panel_3_velocity", 3, 1, 1, "m/s"}, {"result",
      "panel_3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "panel_4_position", 3, 1, 1, "m"}, {"result",
      "panel_4_rotation", 3, 3, 2, "1"}, {"result", "panel_4_velocity", 3, 1, 1, "m/s"}, {"result",
      "panel_4_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "engine_position", 3, 1, 1, "m"}, {"result",
      "engine_rotation", 3, 3, 2, "1"}, {"result", "engine_velocity", 3, 1, 1, "m/s"}, {"result",
      "engine_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "middle_1_position", 3, 1, 1, "m"}, {"result",
      "middle_1_velocity", 3, 1, 1, "m/s"}, {"result", "middle_1_jacobian", 3, 6, 2, ""}, {"result",
      "middle_2_position", 3, 1, 1, "m"}, {"result", "middle_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "middle_2_jacobian", 3, 6, 2, ""}, {"result", "middle_3_position", 3, 1, 1, "m"}, {"result", "middle_3_velocity",
      3, 1, 1, "m/s"}, {"result", "middle_3_jacobian", 3, 6, 2, ""}, {"result", "middle_4_position", 3, 1, 1, "m"},
      {"result", "middle_4_velocity", 3, 1, 1, "m/s"}, {"result", "middle_4_jacobian", 3, 6, 2, ""}, {"result",
      "tip_position", 3, 1, 1, "m"}, {"result", "tip_velocity", 3, 1, 1, "m/s"}, {"result", "tip_jacobian", 3, 6, 2,
      ""}, {"mass", "", 6, 6, 2, ""}, {"forces", "", 6, 1, 1, "N, N m, N m, N m, N m, N m"}, {"forces", "", 6, 1, 1,
      "N, N m, N m, N m, N m, N m"}, {"accelerations", "", 6, 1, 1,
      "m/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1,
      1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "M", 6, 6,
      2, ""}, {"result", "C", 6, 6, 2, ""}, {"result", "K", 6, 6, 2, ""}, {"result", "F", 6, 1, 1,
      "N, N m, N m, N m, N m, N m"}, {"result", "A", 12, 12, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 39}, {"mass_matrix", false, false, false, false, results.data() + 39, 1}, {"bias", false,
      false, false, false, results.data() + 40, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 41,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 42, 2}, {"energy", false, false, true, false,
      results.data() + 44, 3}, {"linearisation", true, true, true, true, results.data() + 47, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::elastic_wing::Description;

  static constexpr const char* name = "elastic_wing";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x8b7e9776a5b3282bULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar gust;  ///< parameter [N]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::gust};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar z;  ///< coordinate [m]
    Scalar beta_1;  ///< coordinate [rad]
    Scalar beta_2;  ///< coordinate [rad]
    Scalar beta_3;  ///< coordinate [rad]
    Scalar beta_4;  ///< coordinate [rad]
    Scalar gamma;  ///< coordinate [rad]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::z, &Coordinates::beta_1, &Coordinates::beta_2,
          &Coordinates::beta_3, &Coordinates::beta_4, &Coordinates::gamma};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar z;  ///< its rate [m/s]
    Scalar beta_1;  ///< its rate [rad/s]
    Scalar beta_2;  ///< its rate [rad/s]
    Scalar beta_3;  ///< its rate [rad/s]
    Scalar beta_4;  ///< its rate [rad/s]
    Scalar gamma;  ///< its rate [rad/s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::z, &Velocities::beta_1, &Velocities::beta_2,
          &Velocities::beta_3, &Velocities::beta_4, &Velocities::gamma};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar z;  ///< its second rate [m/s^2]
    Scalar beta_1;  ///< its second rate [rad/s^2]
    Scalar beta_2;  ///< its second rate [rad/s^2]
    Scalar beta_3;  ///< its second rate [rad/s^2]
    Scalar beta_4;  ///< its second rate [rad/s^2]
    Scalar gamma;  ///< its second rate [rad/s^2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::z, &Accelerations::beta_1, &Accelerations::beta_2,
          &Accelerations::beta_3, &Accelerations::beta_4, &Accelerations::gamma};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar z;  ///< works with the rate of z [N]
    Scalar beta_1;  ///< works with the rate of beta_1 [N m]
    Scalar beta_2;  ///< works with the rate of beta_2 [N m]
    Scalar beta_3;  ///< works with the rate of beta_3 [N m]
    Scalar beta_4;  ///< works with the rate of beta_4 [N m]
    Scalar gamma;  ///< works with the rate of gamma [N m]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::z, &GeneralizedForces::beta_1,
          &GeneralizedForces::beta_2, &GeneralizedForces::beta_3, &GeneralizedForces::beta_4,
          &GeneralizedForces::gamma};
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
    const Scalar n10000 = traits::constant(10000.0, 10000.0f, "10000/1");
    parameters.gust = n10000;
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
    state.time = n0;
    state.q.z = n0;
    state.q.beta_1 = n0;
    state.q.beta_2 = n0;
    state.q.beta_3 = n0;
    state.q.beta_4 = n0;
    state.q.gamma = n0;
    state.v.z = n0;
    state.v.beta_1 = n0;
    state.v.beta_2 = n0;
    state.v.beta_3 = n0;
    state.v.beta_4 = n0;
    state.v.gamma = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> fuselage_position;  ///< centre of mass of fuselage [m]
    std::array<Scalar, 9> fuselage_rotation;  ///< from the axes of fuselage to the ground's (3 x 3)
    std::array<Scalar, 3> fuselage_velocity;  ///< velocity of the centre of mass of fuselage [m/s]
    std::array<Scalar, 3> fuselage_angular_velocity;  ///< angular velocity of fuselage [rad/s]
    std::array<Scalar, 3> panel_1_position;  ///< centre of mass of panel_1 [m]
    std::array<Scalar, 9> panel_1_rotation;  ///< from the axes of panel_1 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_1_velocity;  ///< velocity of the centre of mass of panel_1 [m/s]
    std::array<Scalar, 3> panel_1_angular_velocity;  ///< angular velocity of panel_1 [rad/s]
    std::array<Scalar, 3> panel_2_position;  ///< centre of mass of panel_2 [m]
    std::array<Scalar, 9> panel_2_rotation;  ///< from the axes of panel_2 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_2_velocity;  ///< velocity of the centre of mass of panel_2 [m/s]
    std::array<Scalar, 3> panel_2_angular_velocity;  ///< angular velocity of panel_2 [rad/s]
    std::array<Scalar, 3> panel_3_position;  ///< centre of mass of panel_3 [m]
    std::array<Scalar, 9> panel_3_rotation;  ///< from the axes of panel_3 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_3_velocity;  ///< velocity of the centre of mass of panel_3 [m/s]
    std::array<Scalar, 3> panel_3_angular_velocity;  ///< angular velocity of panel_3 [rad/s]
    std::array<Scalar, 3> panel_4_position;  ///< centre of mass of panel_4 [m]
    std::array<Scalar, 9> panel_4_rotation;  ///< from the axes of panel_4 to the ground's (3 x 3)
    std::array<Scalar, 3> panel_4_velocity;  ///< velocity of the centre of mass of panel_4 [m/s]
    std::array<Scalar, 3> panel_4_angular_velocity;  ///< angular velocity of panel_4 [rad/s]
    std::array<Scalar, 3> engine_position;  ///< centre of mass of engine [m]
    std::array<Scalar, 9> engine_rotation;  ///< from the axes of engine to the ground's (3 x 3)
    std::array<Scalar, 3> engine_velocity;  ///< velocity of the centre of mass of engine [m/s]
    std::array<Scalar, 3> engine_angular_velocity;  ///< angular velocity of engine [rad/s]
    std::array<Scalar, 3> middle_1_position;  ///< position of middle_1 [m]
    std::array<Scalar, 3> middle_1_velocity;  ///< velocity of the material point at middle_1 [m/s]
    std::array<Scalar, 18> middle_1_jacobian;  ///< partial velocities of middle_1 (3 x 6)
    std::array<Scalar, 3> middle_2_position;  ///< position of middle_2 [m]
    std::array<Scalar, 3> middle_2_velocity;  ///< velocity of the material point at middle_2 [m/s]
    std::array<Scalar, 18> middle_2_jacobian;  ///< partial velocities of middle_2 (3 x 6)
    std::array<Scalar, 3> middle_3_position;  ///< position of middle_3 [m]
    std::array<Scalar, 3> middle_3_velocity;  ///< velocity of the material point at middle_3 [m/s]
    std::array<Scalar, 18> middle_3_jacobian;  ///< partial velocities of middle_3 (3 x 6)
    std::array<Scalar, 3> middle_4_position;  ///< position of middle_4 [m]
    std::array<Scalar, 3> middle_4_velocity;  ///< velocity of the material point at middle_4 [m/s]
    std::array<Scalar, 18> middle_4_jacobian;  ///< partial velocities of middle_4 (3 x 6)
    std::array<Scalar, 3> tip_position;  ///< position of tip [m]
    std::array<Scalar, 3> tip_velocity;  ///< velocity of the material point at tip [m/s]
    std::array<Scalar, 18> tip_jacobian;  ///< partial velocities of tip (3 x 6)
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
    std::array<Scalar, 36> M;  ///< mass matrix (6 x 6)
    std::array<Scalar, 36> C;  ///< damping and gyroscopic terms (6 x 6)
    std::array<Scalar, 36> K;  ///< stiffness (6 x 6)
    std::array<Scalar, 6> F;  ///< right-hand side
    std::array<Scalar, 144> A;  ///< state matrix of x = (e, e'): x' = A x + B du (12 x 12)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar z0 = q_beta_1 + q_beta_2;
    const Scalar z1 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z2 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar z3 = q_beta_1 + q_gamma;
    const Scalar angles_[] = {q_beta_1, z0, z1, z2, z3};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar z4 = sines_[1], z5 = cosines_[1];
    const Scalar z6 = sines_[2], z7 = cosines_[2];
    const Scalar z8 = sines_[3], z9 = cosines_[3];
    const Scalar z10 = sines_[4], z11 = cosines_[4];
    const Scalar z12 = n4 * v_beta_1;
    const Scalar z13 = v_beta_1 + v_beta_2;
    const Scalar z14 = n4 * s_beta_1;
    const Scalar z15 = n4 * c_beta_1;
    const Scalar z16 = n4 * z5;
    const Scalar z17 = n4 * z4;
    const Scalar z18 = s_beta_1 * z12;  // velocity of panel_2, y
    const Scalar z19 = v_z + c_beta_1 * z12;  // velocity of panel_2, z
    const Scalar z20 = n4 * z13;
    const Scalar z21 = v_beta_3 + z13;
    const Scalar z22 = n4 * z7;
    const Scalar z23 = n4 * z6;
    const Scalar z24 = n2 * z9;
    const Scalar z25 = n2 * z8;
    const Scalar z26 = n4 * z21;
    const Scalar z27 = v_beta_4 + z21;
    const Scalar z28 = v_beta_1 + v_gamma;
    const Scalar z29 = n2 * z7;
    const Scalar z30 = n2 * z6;
    const Scalar z31 = n2 * v_beta_1;
    const Scalar z32 = n2 * z13;
    const Scalar z33 = n2 * z21;
    const Scalar z34 = n2 * z27;
    const Scalar z35 = n1_2 * z28;
    const Scalar z36 = n2 * c_beta_1;
    const Scalar z37 = s_beta_1 * z31;
    const Scalar z38 = v_z + c_beta_1 * z31;
    const Scalar z39 = n2 * s_beta_1;
    const Scalar z40 = n2 * z5;
    const Scalar z41 = n2 * z4;
    const Scalar z42 = n1_2 * z10;
    const Scalar z43 = n1_2 * z11;
    const Scalar z44 = q_z + z14;  // place of panel_2, z
    const Scalar z45 = z4 * z20 + z18;  // velocity of panel_3, y
    const Scalar z46 = q_z + z39;
    const Scalar z47 = z4 * z32 + z18;
    const Scalar z48 = z18 - z11 * z35;
    const Scalar z49 = z5 * z20 + z19;  // velocity of panel_3, z
    const Scalar z50 = z5 * z32 + z19;
    const Scalar z51 = z19 + z10 * z35;
    const Scalar z52 = z15 + z16;  // place of panel_3, y
    const Scalar z53 = n4 * z9;
    const Scalar z54 = z44 + z17;  // place of panel_3, z
    const Scalar z55 = n4 * z27;
    const Scalar z56 = n4 * z8;
    const Scalar z57 = z15 + z40;
    const Scalar z58 = z44 + z41;
    const Scalar z59 = z15 + z42;
    const Scalar z60 = z44 - z43;
    const Scalar z61 = z14 + z41;
    const Scalar z62 = z6 * z26 + z45;  // velocity of panel_4, y
    const Scalar z63 = z6 * z33 + z45;
    const Scalar z64 = z7 * z26 + z49;  // velocity of panel_4, z
    const Scalar z65 = z7 * z33 + z49;
    const Scalar z66 = z52 + z22;  // place of panel_4, y
    const Scalar z67 = z54 + z23;  // place of panel_4, z
    const Scalar z68 = z52 + z29;
    const Scalar z69 = z54 + z30;
    const Scalar z70 = z16 + z29;
    const Scalar z71 = z17 + z30;
    const Scalar z72 = z8 * z34 + z62;
    const Scalar z73 = z8 * z55 + z62;
    const Scalar z74 = z66 + z24;
    const Scalar z75 = z67 + z25;
    const Scalar z76 = z9 * z34 + z64;
    const Scalar z77 = z15 + z70;
    const Scalar z78 = z14 + z71;
    const Scalar z79 = z22 + z24;
    const Scalar z80 = z23 + z25;
    const Scalar z81 = z9 * z55 + z64;
    const Scalar z82 = z66 + z53;
    const Scalar z83 = z67 + z56;
    const Scalar z84 = z22 + z53;
    const Scalar z85 = z23 + z56;
    const Scalar z86 = z16 + z79;
    const Scalar z87 = z17 + z80;
    const Scalar z88 = z16 + z84;
    const Scalar z89 = z17 + z85;
    const Scalar z90 = z15 + z86;
    const Scalar z91 = z14 + z87;
    const Scalar z92 = z15 + z88;
    const Scalar z93 = z14 + z89;
    result.fuselage_position[0] = n0;
    result.fuselage_position[1] = n0;
    result.fuselage_position[2] = q_z;
    result.fuselage_rotation[0] = n1;
    result.fuselage_rotation[1] = n0;
    result.fuselage_rotation[2] = n0;
    result.fuselage_rotation[3] = n0;
    result.fuselage_rotation[4] = n1;
    result.fuselage_rotation[5] = n0;
    result.fuselage_rotation[6] = n0;
    result.fuselage_rotation[7] = n0;
    result.fuselage_rotation[8] = n1;
    result.fuselage_velocity[0] = n0;
    result.fuselage_velocity[1] = n0;
    result.fuselage_velocity[2] = v_z;
    result.fuselage_angular_velocity[0] = n0;
    result.fuselage_angular_velocity[1] = n0;
    result.fuselage_angular_velocity[2] = n0;
    result.panel_1_position[0] = n0;
    result.panel_1_position[1] = z36;
    result.panel_1_position[2] = z46;
    result.panel_1_rotation[0] = n1;
    result.panel_1_rotation[1] = n0;
    result.panel_1_rotation[2] = n0;
    result.panel_1_rotation[3] = n0;
    result.panel_1_rotation[4] = c_beta_1;
    result.panel_1_rotation[5] = s_beta_1;
    result.panel_1_rotation[6] = n0;
    result.panel_1_rotation[7] = -s_beta_1;
    result.panel_1_rotation[8] = c_beta_1;
    result.panel_1_velocity[0] = n0;
    result.panel_1_velocity[1] = -z37;
    result.panel_1_velocity[2] = z38;
    result.panel_1_angular_velocity[0] = v_beta_1;
    result.panel_1_angular_velocity[1] = n0;
    result.panel_1_angular_velocity[2] = n0;
    result.panel_2_position[0] = n0;
    result.panel_2_position[1] = z57;
    result.panel_2_position[2] = z58;
    result.panel_2_rotation[0] = n1;
    result.panel_2_rotation[1] = n0;
    result.panel_2_rotation[2] = n0;
    result.panel_2_rotation[3] = n0;
    result.panel_2_rotation[4] = z5;
    result.panel_2_rotation[5] = z4;
    result.panel_2_rotation[6] = n0;
    result.panel_2_rotation[7] = -z4;
    result.panel_2_rotation[8] = z5;
    result.panel_2_velocity[0] = n0;
    result.panel_2_velocity[1] = -z47;
    result.panel_2_velocity[2] = z50;
    result.panel_2_angular_velocity[0] = z13;
    result.panel_2_angular_velocity[1] = n0;
    result.panel_2_angular_velocity[2] = n0;
    result.panel_3_position[0] = n0;
    result.panel_3_position[1] = z68;
    result.panel_3_position[2] = z69;
    result.panel_3_rotation[0] = n1;
    result.panel_3_rotation[1] = n0;
    result.panel_3_rotation[2] = n0;
    result.panel_3_rotation[3] = n0;
    result.panel_3_rotation[4] = z7;
    result.panel_3_rotation[5] = z6;
    result.panel_3_rotation[6] = n0;
    result.panel_3_rotation[7] = -z6;
    result.panel_3_rotation[8] = z7;
    result.panel_3_velocity[0] = n0;
    result.panel_3_velocity[1] = -z63;
    result.panel_3_velocity[2] = z65;
    result.panel_3_angular_velocity[0] = z21;
    result.panel_3_angular_velocity[1] = n0;
    result.panel_3_angular_velocity[2] = n0;
    result.panel_4_position[0] = n0;
    result.panel_4_position[1] = z74;
    result.panel_4_position[2] = z75;
    result.panel_4_rotation[0] = n1;
    result.panel_4_rotation[1] = n0;
    result.panel_4_rotation[2] = n0;
    result.panel_4_rotation[3] = n0;
    result.panel_4_rotation[4] = z9;
    result.panel_4_rotation[5] = z8;
    result.panel_4_rotation[6] = n0;
    result.panel_4_rotation[7] = -z8;
    result.panel_4_rotation[8] = z9;
    result.panel_4_velocity[0] = n0;
    result.panel_4_velocity[1] = -z72;
    result.panel_4_velocity[2] = z76;
    result.panel_4_angular_velocity[0] = z27;
    result.panel_4_angular_velocity[1] = n0;
    result.panel_4_angular_velocity[2] = n0;
    result.engine_position[0] = n0;
    result.engine_position[1] = z59;
    result.engine_position[2] = z60;
    result.engine_rotation[0] = n1;
    result.engine_rotation[1] = n0;
    result.engine_rotation[2] = n0;
    result.engine_rotation[3] = n0;
    result.engine_rotation[4] = z11;
    result.engine_rotation[5] = z10;
    result.engine_rotation[6] = n0;
    result.engine_rotation[7] = -z10;
    result.engine_rotation[8] = z11;
    result.engine_velocity[0] = n0;
    result.engine_velocity[1] = -z48;
    result.engine_velocity[2] = z51;
    result.engine_angular_velocity[0] = z28;
    result.engine_angular_velocity[1] = n0;
    result.engine_angular_velocity[2] = n0;
    result.middle_1_position[0] = n0;
    result.middle_1_position[1] = z36;
    result.middle_1_position[2] = z46;
    result.middle_1_velocity[0] = n0;
    result.middle_1_velocity[1] = -z37;
    result.middle_1_velocity[2] = z38;
    result.middle_1_jacobian[0] = n0;
    result.middle_1_jacobian[3] = n0;
    result.middle_1_jacobian[6] = n0;
    result.middle_1_jacobian[9] = n0;
    result.middle_1_jacobian[12] = n0;
    result.middle_1_jacobian[15] = n0;
    result.middle_1_jacobian[1] = n0;
    result.middle_1_jacobian[4] = -z39;
    result.middle_1_jacobian[7] = n0;
    result.middle_1_jacobian[10] = n0;
    result.middle_1_jacobian[13] = n0;
    result.middle_1_jacobian[16] = n0;
    result.middle_1_jacobian[2] = n1;
    result.middle_1_jacobian[5] = z36;
    result.middle_1_jacobian[8] = n0;
    result.middle_1_jacobian[11] = n0;
    result.middle_1_jacobian[14] = n0;
    result.middle_1_jacobian[17] = n0;
    result.middle_2_position[0] = n0;
    result.middle_2_position[1] = z57;
    result.middle_2_position[2] = z58;
    result.middle_2_velocity[0] = n0;
    result.middle_2_velocity[1] = -z47;
    result.middle_2_velocity[2] = z50;
    result.middle_2_jacobian[0] = n0;
    result.middle_2_jacobian[3] = n0;
    result.middle_2_jacobian[6] = n0;
    result.middle_2_jacobian[9] = n0;
    result.middle_2_jacobian[12] = n0;
    result.middle_2_jacobian[15] = n0;
    result.middle_2_jacobian[1] = n0;
    result.middle_2_jacobian[4] = -z61;
    result.middle_2_jacobian[7] = -z41;
    result.middle_2_jacobian[10] = n0;
    result.middle_2_jacobian[13] = n0;
    result.middle_2_jacobian[16] = n0;
    result.middle_2_jacobian[2] = n1;
    result.middle_2_jacobian[5] = z57;
    result.middle_2_jacobian[8] = z40;
    result.middle_2_jacobian[11] = n0;
    result.middle_2_jacobian[14] = n0;
    result.middle_2_jacobian[17] = n0;
    result.middle_3_position[0] = n0;
    result.middle_3_position[1] = z68;
    result.middle_3_position[2] = z69;
    result.middle_3_velocity[0] = n0;
    result.middle_3_velocity[1] = -z63;
    result.middle_3_velocity[2] = z65;
    result.middle_3_jacobian[0] = n0;
    result.middle_3_jacobian[3] = n0;
    result.middle_3_jacobian[6] = n0;
    result.middle_3_jacobian[9] = n0;
    result.middle_3_jacobian[12] = n0;
    result.middle_3_jacobian[15] = n0;
    result.middle_3_jacobian[1] = n0;
    result.middle_3_jacobian[4] = -z78;
    result.middle_3_jacobian[7] = -z71;
    result.middle_3_jacobian[10] = -z30;
    result.middle_3_jacobian[13] = n0;
    result.middle_3_jacobian[16] = n0;
    result.middle_3_jacobian[2] = n1;
    result.middle_3_jacobian[5] = z77;
    result.middle_3_jacobian[8] = z70;
    result.middle_3_jacobian[11] = z29;
    result.middle_3_jacobian[14] = n0;
    result.middle_3_jacobian[17] = n0;
    result.middle_4_position[0] = n0;
    result.middle_4_position[1] = z74;
    result.middle_4_position[2] = z75;
    result.middle_4_velocity[0] = n0;
    result.middle_4_velocity[1] = -z72;
    result.middle_4_velocity[2] = z76;
    result.middle_4_jacobian[0] = n0;
    result.middle_4_jacobian[3] = n0;
    result.middle_4_jacobian[6] = n0;
    result.middle_4_jacobian[9] = n0;
    result.middle_4_jacobian[12] = n0;
    result.middle_4_jacobian[15] = n0;
    result.middle_4_jacobian[1] = n0;
    result.middle_4_jacobian[4] = -z91;
    result.middle_4_jacobian[7] = -z87;
    result.middle_4_jacobian[10] = -z80;
    result.middle_4_jacobian[13] = -z25;
    result.middle_4_jacobian[16] = n0;
    result.middle_4_jacobian[2] = n1;
    result.middle_4_jacobian[5] = z90;
    result.middle_4_jacobian[8] = z86;
    result.middle_4_jacobian[11] = z79;
    result.middle_4_jacobian[14] = z24;
    result.middle_4_jacobian[17] = n0;
    result.tip_position[0] = n0;
    result.tip_position[1] = z82;
    result.tip_position[2] = z83;
    result.tip_velocity[0] = n0;
    result.tip_velocity[1] = -z73;
    result.tip_velocity[2] = z81;
    result.tip_jacobian[0] = n0;
    result.tip_jacobian[3] = n0;
    result.tip_jacobian[6] = n0;
    result.tip_jacobian[9] = n0;
    result.tip_jacobian[12] = n0;
    result.tip_jacobian[15] = n0;
    result.tip_jacobian[1] = n0;
    result.tip_jacobian[4] = -z93;
    result.tip_jacobian[7] = -z89;
    result.tip_jacobian[10] = -z85;
    result.tip_jacobian[13] = -z56;
    result.tip_jacobian[16] = n0;
    result.tip_jacobian[2] = n1;
    result.tip_jacobian[5] = z92;
    result.tip_jacobian[8] = z88;
    result.tip_jacobian[11] = z84;
    result.tip_jacobian[14] = z53;
    result.tip_jacobian[17] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 36>& mass) noexcept {
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k6 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar k8 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k11 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z0 = n500 * s_beta_4;
    const Scalar z1 = n500 * c_beta_4;
    const Scalar z2 = n2400 * c_gamma;
    const Scalar z3 = n2400 * s_gamma;
    const Scalar z4 = n3580 + n4 * z3;
    const Scalar z5 = s_beta_1 * z2 + c_beta_1 * z3;
    const Scalar z6 = n3580 + n8 * z3;
    const Scalar z7 = n16600 + z3;
    const Scalar z8 = k6 + n4 * z1;
    const Scalar z9 = c_beta_3 * z0;
    const Scalar z10 = s_beta_3 * z0;
    const Scalar z11 = k6 + n8 * z1;
    const Scalar z12 = n1900 + z1;
    const Scalar z13 = s_beta_3 * z1 + z9;
    const Scalar z14 = c_beta_3 * z1 - z10;
    const Scalar z15 = s_beta_3 * z12 + z9;
    const Scalar z16 = c_beta_3 * z12 - z10;
    const Scalar z17 = k8 + z6;
    const Scalar z18 = n6400 + z11;
    const Scalar z19 = z8 + n4 * z14;
    const Scalar z20 = s_beta_2 * z14 + c_beta_2 * z13;
    const Scalar z21 = s_beta_2 * z13 - c_beta_2 * z14;
    const Scalar z22 = z18 + n4 * z16;
    const Scalar z23 = c_beta_2 * z15;
    const Scalar z24 = s_beta_2 * z15;
    const Scalar z25 = z18 + n8 * z16;
    const Scalar z26 = n4400 + z16;
    const Scalar z27 = s_beta_2 * z16 + z23;
    const Scalar z28 = c_beta_2 * z16 - z24;
    const Scalar z29 = s_beta_2 * z26 + z23;
    const Scalar z30 = c_beta_2 * z26 - z24;
    const Scalar z31 = k11 + z25;
    const Scalar z32 = z19 - n4 * z21;
    const Scalar z33 = s_beta_1 * z20 + c_beta_1 * z21;
    const Scalar z34 = z22 + n4 * z28;
    const Scalar z35 = s_beta_1 * z27 - c_beta_1 * z28;
    const Scalar z36 = z31 + n4 * z30;
    const Scalar z37 = s_beta_1 * z29 - c_beta_1 * z30;
    const Scalar z38 = z31 + n8 * z30;
    const Scalar z39 = z7 + z30;
    const Scalar z40 = z2 - z29;
    const Scalar z41 = s_beta_1 * z40 + c_beta_1 * z39;
    const Scalar z42 = z17 + z38;
    mass[0] = n20500;
    mass[1] = z41;
    mass[2] = -z37;
    mass[3] = -z35;
    mass[4] = -z33;
    mass[5] = z5;
    mass[6] = z41;
    mass[7] = z42;
    mass[8] = z36;
    mass[9] = z34;
    mass[10] = z32;
    mass[11] = z4;
    mass[12] = -z37;
    mass[13] = z36;
    mass[14] = z31;
    mass[15] = z22;
    mass[16] = z19;
    mass[17] = n0;
    mass[18] = -z35;
    mass[19] = z34;
    mass[20] = z22;
    mass[21] = z18;
    mass[22] = z8;
    mass[23] = n0;
    mass[24] = -z33;
    mass[25] = z32;
    mass[26] = z19;
    mass[27] = z8;
    mass[28] = k6;
    mass[29] = n0;
    mass[30] = z5;
    mass[31] = z4;
    mass[32] = n0;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n3580;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar k2 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k4 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k6 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k8 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z0 = q_beta_1 + q_beta_2;
    const Scalar z1 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z2 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z0, z1, z2};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z3 = sines_[5], z4 = cosines_[5];
    const Scalar z5 = sines_[6], z6 = cosines_[6];
    const Scalar z7 = sines_[7], z8 = cosines_[7];
    const Scalar z9 = v_beta_1 * v_beta_1;
    const Scalar z10 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z11 = p_gust * z7;
    const Scalar z12 = p_gust * z8;
    const Scalar z13 = p_gust * z5;
    const Scalar z14 = p_gust * z6;
    const Scalar z15 = n4 * z9;
    const Scalar z16 = v_beta_3 + z10;  // angular velocity of panel_3, x
    const Scalar z17 = z10 * z10;
    const Scalar z18 = p_gust * z3;
    const Scalar z19 = p_gust * z4;
    const Scalar z20 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z21 = c_beta_2 * z15;
    const Scalar z22 = s_beta_2 * z15;
    const Scalar z23 = v_beta_4 + z16;  // angular velocity of panel_4, x
    const Scalar z24 = z16 * z16;
    const Scalar z25 = z20 * z20;
    const Scalar z26 = s_beta_1 * p_gust;
    const Scalar z27 = z23 * z23;
    const Scalar z28 = c_beta_1 * p_gust;
    const Scalar z29 = c_gamma * z15;
    const Scalar z30 = n2400 * z25;  // force on engine, z
    const Scalar z31 = k2 * q_beta_1;
    const Scalar z32 = n60000 * v_beta_1;
    const Scalar z33 = s_gamma * z30;
    const Scalar z34 = c_gamma * z30;
    const Scalar z35 = k4 * q_beta_2;
    const Scalar z36 = n28000 * v_beta_2;
    const Scalar z37 = k6 * q_beta_3;
    const Scalar z38 = n12000 * v_beta_3;
    const Scalar z39 = k8 * q_beta_4;
    const Scalar z40 = n5000 * v_beta_4;
    const Scalar z41 = n600000 * q_gamma;
    const Scalar z42 = n1200 * v_gamma;
    const Scalar z43 = n2 * z28;
    const Scalar z44 = z21 + n4 * z17;
    const Scalar z45 = n2400 * z29;  // moment on engine, x
    const Scalar z46 = n2 * z19;
    const Scalar z47 = z41 + z42 - z45;
    const Scalar z48 = s_beta_3 * z22 - c_beta_3 * z44;
    const Scalar z49 = c_beta_3 * z22 + s_beta_3 * z44;
    const Scalar z50 = n2 * z14;
    const Scalar z51 = z48 - n4 * z24;
    const Scalar z52 = n2 * z12;
    const Scalar z53 = z11 + n500 * z27;  // force on panel_4, y
    const Scalar z54 = s_beta_4 * z51 - c_beta_4 * z49;
    const Scalar z55 = s_beta_4 * z12 - c_beta_4 * z53;
    const Scalar z56 = c_beta_4 * z12 + s_beta_4 * z53;
    const Scalar z57 = z13 + n1900 * z24 - z55;  // force on panel_3, y
    const Scalar z58 = z14 + z56;  // force on panel_3, z
    const Scalar z59 = z52 + n500 * z54;  // moment on panel_4, x
    const Scalar z60 = s_beta_3 * z58 - c_beta_3 * z57;
    const Scalar z61 = s_beta_3 * z57 + c_beta_3 * z58;
    const Scalar z62 = z50 - n1900 * z49 + n4 * z56 + z59;  // moment on panel_3, x
    const Scalar z63 = z39 + z40 - z59;
    const Scalar z64 = z37 + z38 - z62;
    const Scalar z65 = z18 + n4400 * z17 - z60;  // force on panel_2, y
    const Scalar z66 = z19 + z61;  // force on panel_2, z
    const Scalar z67 = z46 - n4400 * z22 + z62 + n4 * z61;  // moment on panel_2, x
    const Scalar z68 = s_beta_2 * z66 - c_beta_2 * z65;
    const Scalar z69 = s_beta_2 * z65 + c_beta_2 * z66;
    const Scalar z70 = z35 + z36 - z67;
    const Scalar z71 = z26 + n16600 * z9 + z33 - z68;  // force on panel_1, y
    const Scalar z72 = z28 - z34 + z69;  // force on panel_1, z
    const Scalar z73 = z43 + z45 + z67 - n4 * (z34 - z69);  // moment on panel_1, x
    const Scalar z74 = s_beta_1 * z71 + c_beta_1 * z72;
    const Scalar z75 = z31 + z32 - z73;
    forces.z = -z74;
    forces.beta_1 = z75;
    forces.beta_2 = z70;
    forces.beta_3 = z64;
    forces.beta_4 = z63;
    forces.gamma = z47;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar k1 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k3 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k5 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k7 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k17 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar k19 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k21 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar a_z = accelerations.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar a_beta_3 = accelerations.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar a_beta_4 = accelerations.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z0 = q_beta_1 + q_beta_2;
    const Scalar z1 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z2 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z0, z1, z2};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z3 = sines_[5], z4 = cosines_[5];
    const Scalar z5 = sines_[6], z6 = cosines_[6];
    const Scalar z7 = sines_[7], z8 = cosines_[7];
    const Scalar z9 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z10 = a_beta_1 + a_beta_2;  // angular acceleration of panel_2, x
    const Scalar z11 = a_z * s_beta_1;
    const Scalar z12 = v_beta_1 * v_beta_1;
    const Scalar z13 = a_z * c_beta_1;
    const Scalar z14 = p_gust * z8;
    const Scalar z15 = v_beta_3 + z9;  // angular velocity of panel_3, x
    const Scalar z16 = a_beta_3 + z10;  // angular acceleration of panel_3, x
    const Scalar z17 = p_gust * z7;
    const Scalar z18 = p_gust * z5;
    const Scalar z19 = p_gust * z6;
    const Scalar z20 = z9 * z9;
    const Scalar z21 = v_beta_4 + z15;  // angular velocity of panel_4, x
    const Scalar z22 = a_beta_4 + z16;  // angular acceleration of panel_4, x
    const Scalar z23 = z15 * z15;
    const Scalar z24 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z25 = p_gust * z4;
    const Scalar z26 = p_gust * z3;
    const Scalar z27 = z21 * z21;
    const Scalar z28 = z24 * z24;
    const Scalar z29 = c_beta_1 * p_gust;
    const Scalar z30 = a_beta_1 + a_gamma;  // angular acceleration of engine, x
    const Scalar z31 = n2400 * z28;  // force on engine, z
    const Scalar z32 = s_beta_1 * p_gust;
    const Scalar z33 = n2400 * z30;  // force on engine, y
    const Scalar z34 = k1 * q_beta_1;
    const Scalar z35 = n60000 * v_beta_1;
    const Scalar z36 = k3 * q_beta_2;
    const Scalar z37 = s_gamma * z31 - c_gamma * z33;
    const Scalar z38 = s_gamma * z33 + c_gamma * z31;
    const Scalar z39 = n28000 * v_beta_2;
    const Scalar z40 = k5 * q_beta_3;
    const Scalar z41 = n12000 * v_beta_3;
    const Scalar z42 = k7 * q_beta_4;
    const Scalar z43 = n5000 * v_beta_4;
    const Scalar z44 = n600000 * q_gamma;
    const Scalar z45 = n1200 * v_gamma;
    const Scalar z46 = n2 * z29;
    const Scalar z47 = z11 - n4 * z12;
    const Scalar z48 = n4 * a_beta_1 + z13;
    const Scalar z49 = n2 * z25;
    const Scalar z50 = s_beta_2 * z48 + c_beta_2 * z47;
    const Scalar z51 = s_beta_2 * z47 - c_beta_2 * z48;
    const Scalar z52 = s_gamma * z48 + c_gamma * z47;
    const Scalar z53 = n2 * z19;
    const Scalar z54 = n2 * z14;
    const Scalar z55 = z17 + n500 * z27;  // force on panel_4, y
    const Scalar z56 = z14 - n500 * z22;  // force on panel_4, z
    const Scalar z57 = z50 - n4 * z20;
    const Scalar z58 = z51 - n4 * z10;
    const Scalar z59 = n3580 * z30 + n2400 * z52;  // moment on engine, x
    const Scalar z60 = s_beta_4 * z56 - c_beta_4 * z55;
    const Scalar z61 = s_beta_4 * z55 + c_beta_4 * z56;
    const Scalar z62 = s_beta_3 * z58 - c_beta_3 * z57;
    const Scalar z63 = s_beta_3 * z57 + c_beta_3 * z58;
    const Scalar z64 = z44 + z45 + z59;
    const Scalar z65 = z18 + n1900 * z23 - z60;  // force on panel_3, y
    const Scalar z66 = z19 - n1900 * z16 + z61;  // force on panel_3, z
    const Scalar z67 = z62 + n4 * z23;
    const Scalar z68 = z63 - n4 * z16;
    const Scalar z69 = s_beta_3 * z66 - c_beta_3 * z65;
    const Scalar z70 = s_beta_3 * z65 + c_beta_3 * z66;
    const Scalar z71 = s_beta_4 * z67 - c_beta_4 * z68;
    const Scalar z72 = z26 + n4400 * z20 - z69;  // force on panel_2, y
    const Scalar z73 = z25 - n4400 * z10 + z70;  // force on panel_2, z
    const Scalar z74 = z54 - k17 * z22 - n500 * z71;  // moment on panel_4, x
    const Scalar z75 = s_beta_2 * z73 - c_beta_2 * z72;
    const Scalar z76 = s_beta_2 * z72 + c_beta_2 * z73;
    const Scalar z77 = z53 - n6400 * z16 + n4 * z61 + n1900 * z63 + z74;  // moment on panel_3, x
    const Scalar z78 = z42 + z43 - z74;
    const Scalar z79 = z49 - k19 * z10 + n4400 * z51 + n4 * z70 + z77;  // moment on panel_2, x
    const Scalar z80 = z32 + n16600 * z12 + z37 - z75;  // force on panel_1, y
    const Scalar z81 = n16600 * a_beta_1 - z29 + z38 - z76;  // force on panel_1, z
    const Scalar z82 = z40 + z41 - z77;
    const Scalar z83 = k21 * a_beta_1 - z46 + n16600 * z13 + z59 + n4 * (z38 - z76) - z79;  // moment on panel_1, x
    const Scalar z84 = s_beta_1 * z80 - c_beta_1 * z81;
    const Scalar z85 = z36 + z39 - z79;
    const Scalar z86 = n20500 * a_z - z84;  // force on fuselage, z
    const Scalar z87 = z34 + z35 + z83;
    forces.z = z86;
    forces.beta_1 = z87;
    forces.beta_2 = z85;
    forces.beta_3 = z82;
    forces.beta_4 = z78;
    forces.gamma = z64;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, GeneralizedForces& forces) noexcept {
    Mechanism::inverse_dynamics(precomputed, state, accelerations, Multipliers(), forces);
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar n187_5 = traits::constant(187.5, 187.5f, "375/2");
    const Scalar k1 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar k3 = traits::constant(1608.9385474860335, 1608.9386f, "288000/179");
    const Scalar k4 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k6 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar k10 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar k16 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar k20 = traits::constant(0.00027932960893854746, 0.0002793296f, "1/3580");
    const Scalar n120_over_179 = traits::constant(0.6703910614525139, 0.6703911f, "120/179");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k24 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar k25 = traits::constant(0.00075, 0.00075f, "3/4000");
    const Scalar n0_375 = traits::constant(0.375, 0.375f, "3/8");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z0 = q_beta_1 + q_beta_2;
    const Scalar z1 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z2 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z0, z1, z2};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z3 = sines_[5], z4 = cosines_[5];
    const Scalar z5 = sines_[6], z6 = cosines_[6];
    const Scalar z7 = sines_[7], z8 = cosines_[7];
    const Scalar z9 = n187_5 * c_beta_4;
    const Scalar z10 = n187_5 * s_beta_4;
    const Scalar z11 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z12 = p_gust * z8;
    const Scalar z13 = k1 * q_beta_4;
    const Scalar z14 = n5000 * v_beta_4;
    const Scalar z15 = v_beta_3 + z11;  // angular velocity of panel_3, x
    const Scalar z16 = p_gust * z7;
    const Scalar z17 = z13 + z14;
    const Scalar z18 = p_gust * z6;
    const Scalar z19 = k3 * s_gamma;
    const Scalar z20 = p_gust * z5;
    const Scalar z21 = v_beta_4 + z15;  // angular velocity of panel_4, x
    const Scalar z22 = k4 * q_beta_3;
    const Scalar z23 = n12000 * v_beta_3;
    const Scalar z24 = z22 + z23;
    const Scalar z25 = p_gust * z4;
    const Scalar z26 = k3 * c_gamma;
    const Scalar z27 = p_gust * z3;
    const Scalar z28 = k6 * q_beta_2;
    const Scalar z29 = n28000 * v_beta_2;
    const Scalar z30 = n600000 * q_gamma;
    const Scalar z31 = n1200 * v_gamma;
    const Scalar z32 = z28 + z29;
    const Scalar z33 = z30 + z31;
    const Scalar z34 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z35 = c_beta_1 * p_gust;
    const Scalar z36 = s_beta_1 * p_gust;
    const Scalar z37 = k10 * q_beta_1;
    const Scalar z38 = n60000 * v_beta_1;
    const Scalar z39 = z37 + z38;
    const Scalar z40 = n2 * z35;
    const Scalar z41 = c_gamma * z26;
    const Scalar z42 = s_gamma * z19;
    const Scalar z43 = s_gamma * z26;
    const Scalar z44 = c_beta_4 * z9;
    const Scalar z45 = s_beta_4 * z10;
    const Scalar z46 = s_beta_4 * z9;
    const Scalar z47 = n2 * z25;
    const Scalar z48 = n4 * z43;
    const Scalar z49 = n4 * z42;
    const Scalar z50 = n4 * z46;
    const Scalar z51 = n4 * z44;
    const Scalar z52 = n2 * z18;
    const Scalar z53 = n4 * z49;
    const Scalar z54 = n16600 - z49;
    const Scalar z55 = n4 * z51;
    const Scalar z56 = n1900 - z51;
    const Scalar z57 = n2 * z12;
    const Scalar z58 = k16 - z53;
    const Scalar z59 = z11 * z11;
    const Scalar z60 = v_beta_1 * v_beta_1;
    const Scalar z61 = n4 * z60;
    const Scalar z62 = c_beta_2 * z61;
    const Scalar z63 = s_beta_2 * z61;
    const Scalar z64 = n6400 - z55;
    const Scalar z65 = z62 + n4 * z59;
    const Scalar z66 = s_beta_3 * z63 - c_beta_3 * z65;
    const Scalar z67 = n1 / z64;
    const Scalar z68 = c_beta_3 * z63 + s_beta_3 * z65;
    const Scalar z69 = z50 * z67;
    const Scalar z70 = z15 * z15;
    const Scalar z71 = z56 * z67;
    const Scalar z72 = z66 - n4 * z70;
    const Scalar z73 = z45 + z50 * z69;
    const Scalar z74 = s_beta_4 * z72 - c_beta_4 * z68;
    const Scalar z75 = z46 - z50 * z71;
    const Scalar z76 = c_gamma * z61;
    const Scalar z77 = z44 + z56 * z71;
    const Scalar z78 = z34 * z34;
    const Scalar z79 = z73 - z77;
    const Scalar z80 = n2400 * z78;
    const Scalar z81 = n2 * z75;
    const Scalar z82 = n2400 * z76;
    const Scalar z83 = s_beta_3 * z79 - c_beta_3 * z81;
    const Scalar z84 = z33 - z82;
    const Scalar z85 = s_beta_3 * z83;
    const Scalar z86 = k20 * z84;
    const Scalar z87 = c_beta_3 * z83 + z75;
    const Scalar z88 = z73 - z85;
    const Scalar z89 = n120_over_179 * z84;
    const Scalar z90 = z77 + z85;
    const Scalar z91 = s_gamma * z89 - c_gamma * z80;
    const Scalar z92 = s_gamma * z80 + c_gamma * z89;
    const Scalar z93 = n4 * z87;
    const Scalar z94 = z21 * z21;
    const Scalar z95 = n4 * z90;
    const Scalar z96 = z16 + n500 * z94;
    const Scalar z97 = n4 * z95;
    const Scalar z98 = z57 + n500 * z74;
    const Scalar z99 = n4400 - z95;
    const Scalar z100 = k24 - z97;
    const Scalar z101 = z17 - z98;
    const Scalar z102 = k25 * z101;
    const Scalar z103 = n1 / z100;
    const Scalar z104 = z12 + n0_375 * z101;
    const Scalar z105 = z93 * z103;
    const Scalar z106 = s_beta_4 * z104 - c_beta_4 * z96;
    const Scalar z107 = z99 * z103;
    const Scalar z108 = s_beta_4 * z96 + c_beta_4 * z104;
    const Scalar z109 = z88 + z93 * z105;
    const Scalar z110 = z20 + n1900 * z70 - z106;
    const Scalar z111 = z87 - z93 * z107;
    const Scalar z112 = z18 + z108;
    const Scalar z113 = z90 + z99 * z107;
    const Scalar z114 = z52 + z17 - n1900 * z68 + n4 * z108;
    const Scalar z115 = z109 - z113;
    const Scalar z116 = z24 - z114;
    const Scalar z117 = n2 * z111;
    const Scalar z118 = z67 * z116;
    const Scalar z119 = s_beta_2 * z115 + c_beta_2 * z117;
    const Scalar z120 = z69 * z116 + z110;
    const Scalar z121 = s_beta_2 * z119;
    const Scalar z122 = z71 * z116 + z112;
    const Scalar z123 = c_beta_2 * z119 - z111;
    const Scalar z124 = z109 - z121;
    const Scalar z125 = s_beta_3 * z122 - c_beta_3 * z120;
    const Scalar z126 = z113 + z121;
    const Scalar z127 = z27 + n4400 * z59 - z125;
    const Scalar z128 = s_beta_3 * z120 + c_beta_3 * z122;
    const Scalar z129 = n4 * z123;
    const Scalar z130 = z25 + z128;
    const Scalar z131 = z43 + z123;
    const Scalar z132 = n4 * z126;
    const Scalar z133 = z47 + z24 - n4400 * z63 + n4 * z128;
    const Scalar z134 = z41 + z124;
    const Scalar z135 = z42 + z126;
    const Scalar z136 = z48 + z129;
    const Scalar z137 = n4 * z132;
    const Scalar z138 = z32 - z133;
    const Scalar z139 = z54 - z132;
    const Scalar z140 = z58 - z137;
    const Scalar z141 = z105 * z138 - z127;
    const Scalar z142 = z107 * z138 + z130;
    const Scalar z143 = z103 * z138;
    const Scalar z144 = s_beta_2 * z142 + c_beta_2 * z141;
    const Scalar z145 = s_beta_2 * z141 - c_beta_2 * z142;
    const Scalar z146 = z36 + n16600 * z60 + z92 - z144;
    const Scalar z147 = n1 / z140;
    const Scalar z148 = z35 + z91 - z145;
    const Scalar z149 = z136 * z147;
    const Scalar z150 = z32 + z33 + z40 + n4 * (z91 - z145);
    const Scalar z151 = z139 * z147;
    const Scalar z152 = z39 - z150;
    const Scalar z153 = z136 * z149 + z134;
    const Scalar z154 = z147 * z152;
    const Scalar z155 = z136 * z151 - z131;
    const Scalar z156 = z139 * z151 + z135;
    const Scalar z157 = z149 * z152 - z146;
    const Scalar z158 = z151 * z152 + z148;
    const Scalar z159 = z153 - z156;
    const Scalar z160 = n2 * z155;
    const Scalar z161 = s_beta_1 * z157 - c_beta_1 * z158;
    const Scalar z162 = s_beta_1 * z159 - c_beta_1 * z160;
    const Scalar z163 = s_beta_1 * z162;
    const Scalar z164 = z156 + z163;
    const Scalar z165 = n20500 - z164;
    const Scalar z166 = n1 / z165;
    const Scalar z167 = z166 * z161;
    const Scalar z168 = s_beta_1 * z167;
    const Scalar z169 = c_beta_1 * z167;
    const Scalar z170 = z154 + z149 * z168 - z151 * z169;
    const Scalar z171 = z169 + n4 * z170;
    const Scalar z172 = c_beta_2 * z168 + s_beta_2 * z171;
    const Scalar z173 = s_beta_2 * z168 - c_beta_2 * z171;
    const Scalar z174 = c_gamma * z168 + s_gamma * z171;
    const Scalar z175 = z143 + z105 * z172 + z107 * z173;
    const Scalar z176 = z86 - n120_over_179 * z174;
    const Scalar z177 = z170 - z176;
    const Scalar z178 = z170 - z175;
    const Scalar z179 = z173 - n4 * z175;
    const Scalar z180 = s_beta_3 * z179 - c_beta_3 * z172;
    const Scalar z181 = s_beta_3 * z172 + c_beta_3 * z179;
    const Scalar z182 = z118 + z71 * z181 + z69 * z180;
    const Scalar z183 = z175 - z182;
    const Scalar z184 = z181 - n4 * z182;
    const Scalar z185 = s_beta_4 * z180 - c_beta_4 * z184;
    const Scalar z186 = z102 - n0_375 * z185;
    const Scalar z187 = z182 - z186;
    accelerations.z = -z167;
    accelerations.beta_1 = -z170;
    accelerations.beta_2 = z178;
    accelerations.beta_3 = z183;
    accelerations.beta_4 = z187;
    accelerations.gamma = z177;
    if (!(traits::regular(z64, z64) && traits::regular(z100, z100) && traits::regular(z140, z140)
        && traits::regular(z165, z165))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.z * accelerations.beta_1 * accelerations.beta_2 * accelerations.beta_3
        * accelerations.beta_4 * accelerations.gamma;
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
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n2600 = traits::constant(2600.0, 2600.0f, "2600/1");
    const Scalar n1300 = traits::constant(1300.0, 1300.0f, "1300/1");
    const Scalar k8 = traits::constant(6933.333333333333, 6933.3335f, "20800/3");
    const Scalar n800 = traits::constant(800.0, 800.0f, "800/1");
    const Scalar n1600 = traits::constant(1600.0, 1600.0f, "1600/1");
    const Scalar k11 = traits::constant(4266.666666666667, 4266.6665f, "12800/3");
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar n2000 = traits::constant(2000.0, 2000.0f, "2000/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n450 = traits::constant(450.0, 450.0f, "450/1");
    const Scalar n900 = traits::constant(900.0, 900.0f, "900/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n250 = traits::constant(250.0, 250.0f, "250/1");
    const Scalar k19 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar n7850 = traits::constant(7850.0, 7850.0f, "7850/1");
    const Scalar n650 = traits::constant(650.0, 650.0f, "650/1");
    const Scalar n400 = traits::constant(400.0, 400.0f, "400/1");
    const Scalar n1000 = traits::constant(1000.0, 1000.0f, "1000/1");
    const Scalar n225 = traits::constant(225.0, 225.0f, "225/1");
    const Scalar n125 = traits::constant(125.0, 125.0f, "125/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k27 = traits::constant(1.5e+07, 1.5e+07f, "15000000/1");
    const Scalar k28 = traits::constant(7e+06, 7e+06f, "7000000/1");
    const Scalar k29 = traits::constant(3e+06, 3e+06f, "3000000/1");
    const Scalar k30 = traits::constant(1250000.0, 1250000.0f, "1250000/1");
    const Scalar n300000 = traits::constant(3e+05, 3e+05f, "300000/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar v_z = state.v.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z0 = q_beta_1 + q_beta_2;
    const Scalar z1 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z2 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z0, z1, z2};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z3 = sines_[5], z4 = cosines_[5];
    const Scalar z5 = sines_[6], z6 = cosines_[6];
    const Scalar z7 = sines_[7], z8 = cosines_[7];
    const Scalar z9 = v_z * c_beta_1;
    const Scalar z10 = v_z * s_beta_1;
    const Scalar z11 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z12 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z13 = s_beta_1 * p_gust;
    const Scalar z14 = c_beta_1 * p_gust;
    const Scalar z15 = v_beta_3 + z11;  // angular velocity of panel_3, x
    const Scalar z16 = n60000 * v_beta_1;
    const Scalar z17 = z3 * p_gust;
    const Scalar z18 = z4 * p_gust;
    const Scalar z19 = n28000 * v_beta_2;
    const Scalar z20 = z5 * p_gust;
    const Scalar z21 = v_beta_4 + z15;  // angular velocity of panel_4, x
    const Scalar z22 = z6 * p_gust;
    const Scalar z23 = n12000 * v_beta_3;
    const Scalar z24 = z7 * p_gust;
    const Scalar z25 = z8 * p_gust;
    const Scalar z26 = n5000 * v_beta_4;
    const Scalar z27 = n1200 * v_gamma;
    const Scalar z28 = n4 * v_beta_1 + z9;
    const Scalar z29 = n2600 * v_beta_1 + n1300 * z9;
    const Scalar z30 = k8 * v_beta_1 + n2600 * z9;
    const Scalar z31 = c_beta_2 * z10 + s_beta_2 * z28;
    const Scalar z32 = s_beta_2 * z10 - c_beta_2 * z28;
    const Scalar z33 = c_gamma * z10 + s_gamma * z28;
    const Scalar z34 = s_gamma * z10 - c_gamma * z28;
    const Scalar z35 = z32 - n4 * z11;
    const Scalar z36 = n800 * z32 - n1600 * z11;
    const Scalar z37 = n1600 * z32 - k11 * z11;
    const Scalar z38 = n2400 * z12 + n2000 * z33;
    const Scalar z39 = n3580 * z12 + n2400 * z33;
    const Scalar z40 = s_beta_3 * z35 - c_beta_3 * z31;
    const Scalar z41 = s_beta_3 * z31 + c_beta_3 * z35;
    const Scalar z42 = z41 - n4 * z15;
    const Scalar z43 = n450 * z41 - n900 * z15;
    const Scalar z44 = n900 * z41 - n2400 * z15;
    const Scalar z45 = c_beta_4 * z40 + s_beta_4 * z42;
    const Scalar z46 = s_beta_4 * z40 - c_beta_4 * z42;
    const Scalar z47 = n500 * z21 + n250 * z46;
    const Scalar z48 = k19 * z21 + n500 * z46;
    result.kinetic = n7850 * v_z * v_z + n650 * z10 * z10 + n400 * z31 * z31 + n1000 * z34 * z34 + n225 * z40 * z40
        + n125 * z45 * z45 + n0_5 * (v_beta_1 * z30 + z9 * z29 + z33 * z38 + z12 * z39 + z32 * z36 - z11 * z37 + z41
        * z43 - z15 * z44 + z46 * z47 + z21 * z48);
    result.force_function = -k27 * q_beta_1 * q_beta_1 - k28 * q_beta_2 * q_beta_2 - k29 * q_beta_3 * q_beta_3 - k30
        * q_beta_4 * q_beta_4 - n300000 * q_gamma * q_gamma;
    result.power = z10 * z13 - v_beta_1 * z16 - v_beta_2 * z19 - v_beta_3 * z23 - v_beta_4 * z26 - v_gamma * z27 + z9
        * z14 + z31 * z17 - z32 * z18 + n2 * (v_beta_1 * z14 + z11 * z18 + z15 * z22 + z21 * z25) - z41 * z22 - z40
        * z20 - z45 * z24 + z46 * z25;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n2400 = traits::constant(2400.0, 2400.0f, "2400/1");
    const Scalar k1 = traits::constant(3e+07, 3e+07f, "30000000/1");
    const Scalar n60000 = traits::constant(60000.0, 60000.0f, "60000/1");
    const Scalar k3 = traits::constant(1.4e+07, 1.4e+07f, "14000000/1");
    const Scalar n28000 = traits::constant(28000.0, 28000.0f, "28000/1");
    const Scalar k5 = traits::constant(6e+06, 6e+06f, "6000000/1");
    const Scalar n12000 = traits::constant(12000.0, 12000.0f, "12000/1");
    const Scalar k7 = traits::constant(2500000.0, 2500000.0f, "2500000/1");
    const Scalar n5000 = traits::constant(5000.0, 5000.0f, "5000/1");
    const Scalar n600000 = traits::constant(6e+05, 6e+05f, "600000/1");
    const Scalar n1200 = traits::constant(1200.0, 1200.0f, "1200/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n3580 = traits::constant(3580.0, 3580.0f, "3580/1");
    const Scalar n500 = traits::constant(500.0, 500.0f, "500/1");
    const Scalar n8 = traits::constant(8.0, 8.0f, "8/1");
    const Scalar n16600 = traits::constant(16600.0, 16600.0f, "16600/1");
    const Scalar k17 = traits::constant(1333.3333333333333, 1333.3334f, "4000/3");
    const Scalar k18 = traits::constant(62933.333333333336, 62933.332f, "188800/3");
    const Scalar n1900 = traits::constant(1900.0, 1900.0f, "1900/1");
    const Scalar n6400 = traits::constant(6400.0, 6400.0f, "6400/1");
    const Scalar n4400 = traits::constant(4400.0, 4400.0f, "4400/1");
    const Scalar k22 = traits::constant(15466.666666666666, 15466.667f, "46400/3");
    const Scalar n20500 = traits::constant(20500.0, 20500.0f, "20500/1");
    const Scalar k24 = traits::constant(0.00027932960893854746, 0.0002793296f, "1/3580");
    const Scalar k25 = traits::constant(0.00075, 0.00075f, "3/4000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n3_75 = traits::constant(3.75, 3.75f, "15/4");
    const Scalar n60_over_179 = traits::constant(0.33519553072625696, 0.33519554f, "60/179");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_z = accelerations.z;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar q_beta_3 = state.q.beta_3;
    const Scalar v_beta_3 = state.v.beta_3;
    const Scalar a_beta_3 = accelerations.beta_3;
    const Scalar q_beta_4 = state.q.beta_4;
    const Scalar v_beta_4 = state.v.beta_4;
    const Scalar a_beta_4 = accelerations.beta_4;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar p_gust = precomputed.parameters.gust;
    const Scalar z0 = q_beta_1 + q_beta_2;
    const Scalar z1 = q_beta_1 + q_beta_2 + q_beta_3;
    const Scalar z2 = q_beta_1 + q_beta_2 + q_beta_3 + q_beta_4;
    const Scalar angles_[] = {q_beta_1, q_beta_2, q_beta_3, q_beta_4, q_gamma, z0, z1, z2};
    Scalar sines_[8], cosines_[8];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar s_beta_3 = sines_[2], c_beta_3 = cosines_[2];
    const Scalar s_beta_4 = sines_[3], c_beta_4 = cosines_[3];
    const Scalar s_gamma = sines_[4], c_gamma = cosines_[4];
    const Scalar z3 = sines_[5], z4 = cosines_[5];
    const Scalar z5 = sines_[6], z6 = cosines_[6];
    const Scalar z7 = sines_[7], z8 = cosines_[7];
    const Scalar z9 = v_beta_1 + v_beta_2;  // angular velocity of panel_2, x
    const Scalar z10 = a_beta_1 + a_beta_2;  // angular acceleration of panel_2, x
    const Scalar z11 = a_z * c_beta_1;
    const Scalar z12 = p_gust * z7;
    const Scalar z13 = a_z * s_beta_1;
    const Scalar z14 = v_beta_1 * v_beta_1;
    const Scalar z15 = v_beta_3 + z9;  // angular velocity of panel_3, x
    const Scalar z16 = a_beta_3 + z10;  // angular acceleration of panel_3, x
    const Scalar z17 = p_gust * z8;
    const Scalar z18 = p_gust * z6;
    const Scalar z19 = p_gust * z5;
    const Scalar z20 = z9 * z9;
    const Scalar z21 = v_beta_4 + z15;  // angular velocity of panel_4, x
    const Scalar z22 = a_beta_4 + z16;  // angular acceleration of panel_4, x
    const Scalar z23 = z15 * z15;
    const Scalar z24 = p_gust * z3;
    const Scalar z25 = v_beta_1 + v_gamma;  // angular velocity of engine, x
    const Scalar z26 = a_beta_1 + a_gamma;  // angular acceleration of engine, x
    const Scalar z27 = z21 * z21;
    const Scalar z28 = p_gust * z4;
    const Scalar z29 = z25 * z25;
    const Scalar z30 = n2400 * z26;  // force on engine, y
    const Scalar z31 = c_beta_1 * p_gust;
    const Scalar z32 = n2400 * z29;  // force on engine, z
    const Scalar z33 = s_beta_1 * p_gust;
    const Scalar z34 = k1 * q_beta_1;
    const Scalar z35 = n60000 * v_beta_1;
    const Scalar z36 = k3 * q_beta_2;
    const Scalar z37 = n28000 * v_beta_2;
    const Scalar z38 = s_gamma * z30 + c_gamma * z32;
    const Scalar z39 = s_gamma * z32 - c_gamma * z30;
    const Scalar z40 = k5 * q_beta_3;
    const Scalar z41 = n12000 * v_beta_3;
    const Scalar z42 = k7 * q_beta_4;
    const Scalar z43 = n5000 * v_beta_4;
    const Scalar z44 = n600000 * q_gamma;
    const Scalar z45 = n1200 * v_gamma;
    const Scalar z46 = n2400 * c_gamma;
    const Scalar z47 = n2 * z31;
    const Scalar z48 = n2400 * s_gamma;
    const Scalar z49 = z13 - n4 * z14;
    const Scalar z50 = n4 * a_beta_1 + z11;
    const Scalar z51 = n2 * z28;
    const Scalar z52 = n3580 + n4 * z48;
    const Scalar z53 = s_beta_2 * z50 + c_beta_2 * z49;
    const Scalar z54 = s_beta_2 * z49 - c_beta_2 * z50;
    const Scalar z55 = s_gamma * z50 + c_gamma * z49;
    const Scalar z56 = s_gamma * z49 - c_gamma * z50;
    const Scalar z57 = n2 * z18;
    const Scalar z58 = s_beta_1 * z46 + c_beta_1 * z48;
    const Scalar z59 = n2 * z17;
    const Scalar z60 = n500 * c_beta_4;
    const Scalar z61 = n500 * s_beta_4;
    const Scalar z62 = n3580 + n8 * z48;
    const Scalar z63 = n16600 + z48;
    const Scalar z64 = k17 + n4 * z60;
    const Scalar z65 = c_beta_3 * z61;
    const Scalar z66 = s_beta_3 * z61;
    const Scalar z67 = s_beta_3 * z60 + z65;
    const Scalar z68 = c_beta_3 * z60 - z66;
    const Scalar z69 = k18 + z62;
    const Scalar z70 = z12 + n500 * z27;  // force on panel_4, y
    const Scalar z71 = z17 - n500 * z22;  // force on panel_4, z
    const Scalar z72 = z53 - n4 * z20;
    const Scalar z73 = z64 + n4 * z68;
    const Scalar z74 = z54 - n4 * z10;
    const Scalar z75 = s_beta_2 * z68 + c_beta_2 * z67;
    const Scalar z76 = n3580 * z26 + n2400 * z55;  // moment on engine, x
    const Scalar z77 = s_beta_4 * z71 - c_beta_4 * z70;
    const Scalar z78 = s_beta_4 * z70 + c_beta_4 * z71;
    const Scalar z79 = s_beta_3 * z74 - c_beta_3 * z72;
    const Scalar z80 = s_beta_2 * z67 - c_beta_2 * z68;
    const Scalar z81 = s_beta_3 * z72 + c_beta_3 * z74;
    const Scalar z82 = s_beta_1 * z75 + c_beta_1 * z80;
    const Scalar z83 = z73 - n4 * z80;
    const Scalar z84 = k17 + n8 * z60;
    const Scalar z85 = z44 + z45 + z76;
    const Scalar z86 = z19 + n1900 * z23 - z77;  // force on panel_3, y
    const Scalar z87 = z18 - n1900 * z16 + z78;  // force on panel_3, z
    const Scalar z88 = z79 + n4 * z23;
    const Scalar z89 = n1900 + z60;
    const Scalar z90 = z81 - n4 * z16;
    const Scalar z91 = n6400 + z84;
    const Scalar z92 = s_beta_3 * z87 - c_beta_3 * z86;
    const Scalar z93 = s_beta_3 * z86 + c_beta_3 * z87;
    const Scalar z94 = s_beta_4 * z90 + c_beta_4 * z88;
    const Scalar z95 = s_beta_3 * z89 + z65;
    const Scalar z96 = s_beta_4 * z88 - c_beta_4 * z90;
    const Scalar z97 = c_beta_3 * z89 - z66;
    const Scalar z98 = z91 + n4 * z97;
    const Scalar z99 = z91 + n8 * z97;
    const Scalar z100 = s_beta_2 * z95;
    const Scalar z101 = c_beta_2 * z95;
    const Scalar z102 = z24 + n4400 * z20 - z92;  // force on panel_2, y
    const Scalar z103 = k22 + z99;
    const Scalar z104 = n4400 + z97;
    const Scalar z105 = c_beta_2 * z104 - z100;
    const Scalar z106 = z59 - k17 * z22 - n500 * z96;  // moment on panel_4, x
    const Scalar z107 = c_beta_2 * z97 - z100;
    const Scalar z108 = s_beta_2 * z104 + z101;
    const Scalar z109 = z57 - n6400 * z16 + n4 * z78 + n1900 * z81 + z106;  // moment on panel_3, x
    const Scalar z110 = z42 + z43 - z106;
    const Scalar z111 = z40 + z41 - z109;
    const Scalar z112 = s_beta_2 * z97 + z101;
    const Scalar z113 = z51 - k22 * z10 + n4400 * z54 + n4 * z93 + z109;  // moment on panel_2, x
    const Scalar z114 = z36 + z37 - z113;
    const Scalar z115 = z28 - n4400 * z10 + z93;  // force on panel_2, z
    const Scalar z116 = n2 * z15;
    const Scalar z117 = z46 - z108;
    const Scalar z118 = z63 + z105;
    const Scalar z119 = s_beta_1 * z117 + c_beta_1 * z118;
    const Scalar z120 = n2 * z25;
    const Scalar z121 = n2400 * z120;
    const Scalar z122 = s_beta_1 * z112 - c_beta_1 * z107;
    const Scalar z123 = z98 + n4 * z107;
    const Scalar z124 = s_beta_1 * z108 - c_beta_1 * z105;
    const Scalar z125 = n2 * v_beta_1;
    const Scalar z126 = z103 + n8 * z105;
    const Scalar z127 = z69 + z126;
    const Scalar z128 = z103 + n4 * z105;
    const Scalar z129 = s_gamma * z121;
    const Scalar z130 = s_beta_2 * z102 + c_beta_2 * z115;
    const Scalar z131 = k18 * a_beta_1 - z47 + n16600 * z11 + z76 + n4 * (z38 - z130) - z113;  // moment on panel_1, x
    const Scalar z132 = n16600 * a_beta_1 - z31 + z38 - z130;  // force on panel_1, z
    const Scalar z133 = s_beta_2 * z115 - c_beta_2 * z102;
    const Scalar z134 = z33 + n16600 * z14 + z39 - z133;  // force on panel_1, y
    const Scalar z135 = z34 + z35 + z131;
    const Scalar z136 = n2 * z21;
    const Scalar z137 = n500 * z136;
    const Scalar z138 = s_beta_1 * z134 - c_beta_1 * z132;
    const Scalar z139 = c_beta_4 * z137;
    const Scalar z140 = s_beta_4 * z137;
    const Scalar z141 = n1900 * z116 + z139;
    const Scalar z142 = c_beta_3 * z140;
    const Scalar z143 = n20500 * a_z - z138;  // force on fuselage, z
    const Scalar z144 = n2 * z9;
    const Scalar z145 = n4 * z116;
    const Scalar z146 = c_gamma * z121;
    const Scalar z147 = n4 * z125;
    const Scalar z148 = s_beta_2 * z147;
    const Scalar z149 = c_beta_2 * z147;
    const Scalar z150 = c_gamma * z147;
    const Scalar z151 = n4 * z144;
    const Scalar z152 = s_beta_4 * z12 + c_beta_4 * z17;
    const Scalar z153 = z18 + z152;
    const Scalar z154 = z149 + z151;
    const Scalar z155 = n2400 * z150;
    const Scalar z156 = s_beta_4 * z17 - c_beta_4 * z12;
    const Scalar z157 = s_beta_3 * z148 - c_beta_3 * z154;
    const Scalar z158 = c_beta_3 * z148 + s_beta_3 * z154;
    const Scalar z159 = z19 - z156;
    const Scalar z160 = z157 - z145;
    const Scalar z161 = n2 * z19;
    const Scalar z162 = s_beta_3 * z140;
    const Scalar z163 = n4 * z140;
    const Scalar z164 = s_beta_2 * z11 + c_beta_2 * z13;
    const Scalar z165 = s_beta_4 * z160 - c_beta_4 * z158;
    const Scalar z166 = s_beta_3 * z153 - c_beta_3 * z159;
    const Scalar z167 = s_beta_2 * z13 - c_beta_2 * z11;
    const Scalar z168 = s_gamma * z13 - c_gamma * z11;
    const Scalar z169 = n2400 * z168;
    const Scalar z170 = n500 * z165;
    const Scalar z171 = c_beta_3 * z141 - z162;
    const Scalar z172 = s_beta_3 * z141 + z142;
    const Scalar z173 = n4400 * z144 + z171;
    const Scalar z174 = n1900 * z158 - z163 - z170;
    const Scalar z175 = z24 - z166;
    const Scalar z176 = n2 * z24;
    const Scalar z177 = n4 * z172 - z174 - n4400 * z148;
    const Scalar z178 = s_beta_3 * z159 + c_beta_3 * z153;
    const Scalar z179 = z28 + z178;
    const Scalar z180 = s_beta_3 * z164 + c_beta_3 * z167;
    const Scalar z181 = s_beta_3 * z167 - c_beta_3 * z164;
    const Scalar z182 = s_beta_4 * z180 + c_beta_4 * z181;
    const Scalar z183 = c_beta_2 * z172;
    const Scalar z184 = s_beta_3 * z151;
    const Scalar z185 = s_beta_2 * z172;
    const Scalar z186 = c_beta_3 * z151;
    const Scalar z187 = s_beta_2 * z173 + z183;
    const Scalar z188 = c_beta_2 * z173 - z185;
    const Scalar z189 = z145 + z186;
    const Scalar z190 = s_beta_2 * z175 + c_beta_2 * z179;
    const Scalar z191 = z31 + z190;
    const Scalar z192 = n16600 * z125 + z129 + z188;
    const Scalar z193 = c_beta_4 * z184 + s_beta_4 * z189;
    const Scalar z194 = n500 * z193;
    const Scalar z195 = s_beta_1 * z188 + c_beta_1 * z187;
    const Scalar z196 = n2 * z12;
    const Scalar z197 = z196 + n500 * z182;
    const Scalar z198 = z163 - n1900 * z184 - z194;
    const Scalar z199 = s_beta_2 * z179 - c_beta_2 * z175;
    const Scalar z200 = n4 * z156 - z161 - n1900 * z181 - z197;
    const Scalar z201 = n2 * z33;
    const Scalar z202 = z33 - z199;
    const Scalar z203 = s_beta_1 * (z132 + z191) + c_beta_1 * (z134 - z202);
    const Scalar z204 = n4400 * z164 - z176 + n4 * z166 + z200;
    const Scalar z205 = n16600 * z13 - z201 + z169 + z204 + n4 * z199;
    const Scalar z206 = z146 - z187;
    const Scalar z207 = s_beta_1 * z192 - c_beta_1 * z206;
    const Scalar z208 = s_beta_4 * z81 + c_beta_4 * z79;
    const Scalar z209 = s_beta_4 * z145;
    const Scalar z210 = s_beta_3 * z139 + z142;
    const Scalar z211 = n500 * z209;
    const Scalar z212 = z196 + n500 * z208;
    const Scalar z213 = c_beta_2 * z171 - z185;
    const Scalar z214 = s_beta_2 * z171 + z183;
    const Scalar z215 = z161 - n4 * z156 + n1900 * z79 + z212;
    const Scalar z216 = s_beta_1 * z213 + c_beta_1 * z214;
    const Scalar z217 = k1 - z205;
    const Scalar z218 = s_beta_3 * z53 + c_beta_3 * z54;
    const Scalar z219 = s_beta_3 * z54 - c_beta_3 * z53;
    const Scalar z220 = s_beta_4 * z218 + c_beta_4 * z219;
    const Scalar z221 = s_beta_3 * (z87 - z153) - c_beta_3 * (z86 - z159);
    const Scalar z222 = s_beta_3 * (z86 - z159) + c_beta_3 * (z87 - z153);
    const Scalar z223 = z196 + n500 * z220;
    const Scalar z224 = z163 - z211;
    const Scalar z225 = n4 * (z146 - z187) - z155 - z177;
    const Scalar z226 = n4 * z156 - z161 - n1900 * z219 - z223;
    const Scalar z227 = n4400 * z53 - z176 + n4 * z166 + z226;
    const Scalar z228 = c_beta_3 * z139 - z162;
    const Scalar z229 = n60000 + z225;
    const Scalar z230 = n500 * z94 + z196;
    const Scalar z231 = s_beta_1 * z129 - c_beta_1 * z146;
    const Scalar z232 = s_beta_4 * (z12 - z70) + c_beta_4 * (z17 - z71);
    const Scalar z233 = s_beta_4 * (z17 - z71) - c_beta_4 * (z12 - z70);
    const Scalar z234 = s_beta_3 * z232 + c_beta_3 * z233;
    const Scalar z235 = s_beta_3 * z233 - c_beta_3 * z232;
    const Scalar z236 = n4 * z233 - z230;
    const Scalar z237 = k7 + z230;
    const Scalar z238 = s_beta_2 * (z115 - z179) - c_beta_2 * (z102 - z175);
    const Scalar z239 = s_beta_2 * (z102 - z175) + c_beta_2 * (z115 - z179);
    const Scalar z240 = c_beta_1 * z238 + s_beta_1 * z239;
    const Scalar z241 = n4 * z238 - z227;
    const Scalar z242 = k3 - z227;
    const Scalar z243 = n2400 * z56;
    const Scalar z244 = s_beta_1 * z38 + c_beta_1 * z39;
    const Scalar z245 = n4 * z146;
    const Scalar z246 = n4 * z39 + z243;
    const Scalar z247 = n600000 - z243;
    const Scalar z248 = k24 * z52;
    const Scalar z249 = z58 * z248 - z119;
    const Scalar z250 = k24 * z58;
    const Scalar z251 = n20500 - z58 * z250;
    const Scalar z252 = s_beta_2 * z221 - c_beta_2 * z222;
    const Scalar z253 = c_beta_2 * z221 + s_beta_2 * z222;
    const Scalar z254 = n4 * z221 + z215;
    const Scalar z255 = s_beta_1 * z252 - c_beta_1 * z253;
    const Scalar z256 = n4 * z253 + z254;
    const Scalar z257 = k5 + z215;
    const Scalar z258 = s_beta_2 * z210 - c_beta_2 * z228;
    const Scalar z259 = s_beta_2 * z228 + c_beta_2 * z210;
    const Scalar z260 = z163 + n4 * z210;
    const Scalar z261 = s_beta_1 * z258 - c_beta_1 * z259;
    const Scalar z262 = n4 * z259 + z260;
    const Scalar z263 = s_beta_2 * z234 + c_beta_2 * z235;
    const Scalar z264 = s_beta_2 * z235 - c_beta_2 * z234;
    const Scalar z265 = n4 * z234 + z236;
    const Scalar z266 = s_beta_1 * z263 + c_beta_1 * z264;
    const Scalar z267 = n4 * z264 - z265;
    const Scalar z268 = n4 * z172 + z198;
    const Scalar z269 = z52 * z248 - z127;
    const Scalar z270 = n4 * z172 + z224;
    const Scalar z271 = n4 * z187 + z268;
    const Scalar z272 = n28000 - z268;
    const Scalar z273 = n4 * z214 + z270;
    const Scalar z274 = n12000 - z224;
    const Scalar z275 = k25 * z64;
    const Scalar z276 = z64 * z275 - z91;
    const Scalar z277 = z73 * z275 - z98;
    const Scalar z278 = z83 * z275 - z123;
    const Scalar z279 = z82 * z275 - z122;
    const Scalar z280 = n1 / z276;
    const Scalar z281 = z197 * z275 + z200;
    const Scalar z282 = z170 * z275 + z174;
    const Scalar z283 = z223 * z275 + z226;
    const Scalar z284 = k25 * z73;
    const Scalar z285 = z73 * z284 - z103;
    const Scalar z286 = z83 * z284 - z128;
    const Scalar z287 = z82 * z284 - z124;
    const Scalar z288 = k25 * z83;
    const Scalar z289 = z83 * z288 + z269;
    const Scalar z290 = z82 * z288 - z249;
    const Scalar z291 = k25 * z82;
    const Scalar z292 = z82 * z291 - z251;
    const Scalar z293 = z194 * z275 + z198;
    const Scalar z294 = z212 * z275 - z257;
    const Scalar z295 = z277 * z280;
    const Scalar z296 = z278 * z280;
    const Scalar z297 = z279 * z280;
    const Scalar z298 = z292 - z279 * z297;
    const Scalar z299 = z290 - z279 * z296;
    const Scalar z300 = z285 - z277 * z295;
    const Scalar z301 = z287 - z279 * z295;
    const Scalar z302 = z286 - z278 * z295;
    const Scalar z303 = z289 - z278 * z296;
    const Scalar z304 = n1 / z300;
    const Scalar z305 = z211 * z275 - z274;
    const Scalar z306 = z197 * z284 + z204 - z295 * z281;
    const Scalar z307 = z170 * z284 - z177 - z295 * z282;
    const Scalar z308 = z223 * z284 - z242 - z295 * z283;
    const Scalar z309 = z194 * z284 - z272 - z295 * z293;
    const Scalar z310 = z212 * z284 - z254 - z295 * z294;
    const Scalar z311 = z301 * z304;
    const Scalar z312 = z211 * z284 + z270 - z295 * z305;
    const Scalar z313 = z302 * z304;
    const Scalar z314 = z298 - z301 * z311;
    const Scalar z315 = z303 - z302 * z313;
    const Scalar z316 = z299 - z301 * z313;
    const Scalar z317 = z169 * z248 - z197 * z288 + z296 * z281 + z217 + z313 * z306;
    const Scalar z318 = n1 / z315;
    const Scalar z319 = z229 + z155 * z248 + z170 * z288 - z296 * z282 - z313 * z307;
    const Scalar z320 = z223 * z288 - z241 - z296 * z283 - z313 * z308;
    const Scalar z321 = z194 * z288 + z271 - z296 * z293 - z313 * z309;
    const Scalar z322 = z212 * z288 - z256 - z296 * z294 - z313 * z310;
    const Scalar z323 = z211 * z288 + z273 - z296 * z305 - z313 * z312;
    const Scalar z324 = z316 * z318;
    const Scalar z325 = z314 - z316 * z324;
    const Scalar z326 = z203 - z169 * z250 - z197 * z291 + z297 * z281 + z311 * z306 - z324 * z317;
    const Scalar z327 = n1 / z325;
    const Scalar z328 = z236 + z237 * z275;
    const Scalar z329 = z265 + z237 * z284 - z295 * z328;
    const Scalar z330 = z207 - z155 * z250 + z170 * z291 - z297 * z282 - z311 * z307 - z324 * z319;
    const Scalar z331 = z267 - z237 * z288 + z296 * z328 + z313 * z329;
    const Scalar z332 = z240 + z223 * z291 - z297 * z283 - z311 * z308 - z324 * z320;
    const Scalar z333 = z195 - z194 * z291 + z297 * z293 + z311 * z309 + z324 * z321;
    const Scalar z334 = z255 - z212 * z291 + z297 * z294 + z311 * z310 + z324 * z322;
    const Scalar z335 = z216 - z211 * z291 + z297 * z305 + z311 * z312 + z324 * z323;
    const Scalar z336 = z266 + z237 * z291 - z297 * z328 - z311 * z329 + z324 * z331;
    const Scalar z337 = z327 * z326;
    const Scalar z338 = z327 * z330;
    const Scalar z339 = z327 * z332;
    const Scalar z340 = z327 * z333;
    const Scalar z341 = z327 * z334;
    const Scalar z342 = z327 * z335;
    const Scalar z343 = z327 * z336;
    const Scalar z344 = z318 * z317 - z324 * z337;
    const Scalar z345 = k24 * z169 + z250 * z337 - z248 * z344;
    const Scalar z346 = z318 * z319 - z324 * z338;
    const Scalar z347 = k24 * z155 + z250 * z338 - z248 * z346;
    const Scalar z348 = z318 * z320 - z324 * z339;
    const Scalar z349 = z318 * z321 + z324 * z340;
    const Scalar z350 = z318 * z322 + z324 * z341;
    const Scalar z351 = z318 * z323 + z324 * z342;
    const Scalar z352 = z318 * z331 + z324 * z343;
    const Scalar z353 = z304 * z306 + z311 * z337 + z313 * z344;
    const Scalar z354 = z304 * z307 - z311 * z338 - z313 * z346;
    const Scalar z355 = z304 * z308 - z311 * z339 - z313 * z348;
    const Scalar z356 = z304 * z309 + z311 * z340 - z313 * z349;
    const Scalar z357 = z304 * z310 + z311 * z341 - z313 * z350;
    const Scalar z358 = z304 * z312 + z311 * z342 - z313 * z351;
    const Scalar z359 = z304 * z329 - z311 * z343 + z313 * z352;
    const Scalar z360 = z280 * z281 + z297 * z337 + z296 * z344 - z295 * z353;
    const Scalar z361 = k25 * z197 + z291 * z337 + z288 * z344 - z284 * z353 - z275 * z360;
    const Scalar z362 = z163 + n5000 * z275;
    const Scalar z363 = z260 + n5000 * z284 - z295 * z362;
    const Scalar z364 = z280 * z282 - z297 * z338 - z296 * z346 - z295 * z354;
    const Scalar z365 = k25 * z170 - z291 * z338 - z288 * z346 - z284 * z354 - z275 * z364;
    const Scalar z366 = z262 + n5000 * z288 - z296 * z362 - z313 * z363;
    const Scalar z367 = z246 + z247 * z248;
    const Scalar z368 = z261 + n5000 * z291 - z297 * z362 - z311 * z363 - z324 * z366;
    const Scalar z369 = z244 + z247 * z250 + z324 * z367;
    const Scalar z370 = z327 * z368;
    const Scalar z371 = z327 * z369;
    const Scalar z372 = z318 * z366 - z324 * z370;
    const Scalar z373 = z280 * z283 - z297 * z339 - z296 * z348 - z295 * z355;
    const Scalar z374 = k25 * z223 - z291 * z339 - z288 * z348 - z284 * z355 - z275 * z373;
    const Scalar z375 = z250 * z339 - z248 * z348;
    const Scalar z376 = z304 * z363 - z311 * z370 - z313 * z372;
    const Scalar z377 = z245 - n1200 * z248;
    const Scalar z378 = z231 + n1200 * z250 - z324 * z377;
    const Scalar z379 = z318 * z367 + z324 * z371;
    const Scalar z380 = k24 * z247 - z250 * z371 - z248 * z379;
    const Scalar z381 = z327 * z378;
    const Scalar z382 = z280 * z293 + z297 * z340 - z296 * z349 - z295 * z356;
    const Scalar z383 = k25 * z194 + z291 * z340 - z288 * z349 - z284 * z356 - z275 * z382;
    const Scalar z384 = z318 * z377 - z324 * z381;
    const Scalar z385 = z250 * z340 + z248 * z349;
    const Scalar z386 = z280 * z294 + z297 * z341 - z296 * z350 - z295 * z357;
    const Scalar z387 = k25 * z212 + z291 * z341 - z288 * z350 - z284 * z357 - z275 * z386;
    const Scalar z388 = z250 * z341 + z248 * z350;
    const Scalar z389 = z280 * z305 + z297 * z342 - z296 * z351 - z295 * z358;
    const Scalar z390 = k25 * z211 + z291 * z342 - z288 * z351 - z284 * z358 - z275 * z389;
    const Scalar z391 = z250 * z342 + z248 * z351;
    const Scalar z392 = z280 * z328 - z297 * z343 + z296 * z352 - z295 * z359;
    const Scalar z393 = k25 * z237 - z291 * z343 + z288 * z352 - z284 * z359 - z275 * z392;
    const Scalar z394 = z250 * z343 + z248 * z352;
    const Scalar z395 = z280 * z362 - z297 * z370 - z296 * z372 - z295 * z376;
    const Scalar z396 = z311 * z371 - z313 * z379;
    const Scalar z397 = n3_75 - z291 * z370 - z288 * z372 - z284 * z376 - z275 * z395;
    const Scalar z398 = z311 * z381 + z313 * z384;
    const Scalar z399 = z297 * z371 - z296 * z379 - z295 * z396;
    const Scalar z400 = z297 * z381 + z296 * z384 - z295 * z398;
    const Scalar z401 = z250 * z370 - z248 * z372;
    const Scalar z402 = z291 * z371 - z288 * z379 - z284 * z396 - z275 * z399;
    const Scalar z403 = z291 * z381 + z288 * z384 - z284 * z398 - z275 * z400;
    const Scalar z404 = n60_over_179 - z250 * z381 + z248 * z384;
    result.M[0] = n20500;
    result.M[1] = z119;
    result.M[2] = -z124;
    result.M[3] = -z122;
    result.M[4] = -z82;
    result.M[5] = z58;
    result.M[6] = z119;
    result.M[7] = z127;
    result.M[8] = z128;
    result.M[9] = z123;
    result.M[10] = z83;
    result.M[11] = z52;
    result.M[12] = -z124;
    result.M[13] = z128;
    result.M[14] = z103;
    result.M[15] = z98;
    result.M[16] = z73;
    result.M[17] = n0;
    result.M[18] = -z122;
    result.M[19] = z123;
    result.M[20] = z98;
    result.M[21] = z91;
    result.M[22] = z64;
    result.M[23] = n0;
    result.M[24] = -z82;
    result.M[25] = z83;
    result.M[26] = z73;
    result.M[27] = z64;
    result.M[28] = k17;
    result.M[29] = n0;
    result.M[30] = z58;
    result.M[31] = z52;
    result.M[32] = n0;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n3580;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = -z207;
    result.C[7] = z229;
    result.C[8] = -z177;
    result.C[9] = z174;
    result.C[10] = -z170;
    result.C[11] = -z155;
    result.C[12] = -z195;
    result.C[13] = -z271;
    result.C[14] = z272;
    result.C[15] = -z198;
    result.C[16] = z194;
    result.C[17] = n0;
    result.C[18] = -z216;
    result.C[19] = -z273;
    result.C[20] = -z270;
    result.C[21] = z274;
    result.C[22] = z211;
    result.C[23] = n0;
    result.C[24] = z261;
    result.C[25] = -z262;
    result.C[26] = -z260;
    result.C[27] = -z163;
    result.C[28] = n5000;
    result.C[29] = n0;
    result.C[30] = -z231;
    result.C[31] = z245;
    result.C[32] = n0;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n1200;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = -z203;
    result.K[7] = z217;
    result.K[8] = -z204;
    result.K[9] = -z200;
    result.K[10] = z197;
    result.K[11] = -z169;
    result.K[12] = z240;
    result.K[13] = z241;
    result.K[14] = z242;
    result.K[15] = -z226;
    result.K[16] = z223;
    result.K[17] = n0;
    result.K[18] = -z255;
    result.K[19] = z256;
    result.K[20] = z254;
    result.K[21] = z257;
    result.K[22] = z212;
    result.K[23] = n0;
    result.K[24] = z266;
    result.K[25] = z267;
    result.K[26] = -z265;
    result.K[27] = -z236;
    result.K[28] = z237;
    result.K[29] = n0;
    result.K[30] = -z244;
    result.K[31] = -z246;
    result.K[32] = n0;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = z247;
    result.F[0] = -z143;
    result.F[1] = -z135;
    result.F[2] = -z114;
    result.F[3] = -z111;
    result.F[4] = -z110;
    result.F[5] = -z85;
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
    result.A[18] = -z337;
    result.A[19] = z344;
    result.A[20] = -z353;
    result.A[21] = -z360;
    result.A[22] = -z361;
    result.A[23] = z345;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = n0;
    result.A[29] = n0;
    result.A[30] = z339;
    result.A[31] = -z348;
    result.A[32] = -z355;
    result.A[33] = -z373;
    result.A[34] = -z374;
    result.A[35] = -z375;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = n0;
    result.A[41] = n0;
    result.A[42] = -z341;
    result.A[43] = -z350;
    result.A[44] = -z357;
    result.A[45] = -z386;
    result.A[46] = -z387;
    result.A[47] = z388;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n0;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = z343;
    result.A[55] = z352;
    result.A[56] = -z359;
    result.A[57] = -z392;
    result.A[58] = -z393;
    result.A[59] = -z394;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = n0;
    result.A[64] = n0;
    result.A[65] = n0;
    result.A[66] = -z371;
    result.A[67] = -z379;
    result.A[68] = -z396;
    result.A[69] = -z399;
    result.A[70] = -z402;
    result.A[71] = -z380;
    result.A[72] = n1;
    result.A[73] = n0;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = n0;
    result.A[78] = n0;
    result.A[79] = n0;
    result.A[80] = n0;
    result.A[81] = n0;
    result.A[82] = n0;
    result.A[83] = n0;
    result.A[84] = n0;
    result.A[85] = n1;
    result.A[86] = n0;
    result.A[87] = n0;
    result.A[88] = n0;
    result.A[89] = n0;
    result.A[90] = -z338;
    result.A[91] = z346;
    result.A[92] = z354;
    result.A[93] = z364;
    result.A[94] = z365;
    result.A[95] = z347;
    result.A[96] = n0;
    result.A[97] = n0;
    result.A[98] = n1;
    result.A[99] = n0;
    result.A[100] = n0;
    result.A[101] = n0;
    result.A[102] = -z340;
    result.A[103] = -z349;
    result.A[104] = -z356;
    result.A[105] = -z382;
    result.A[106] = -z383;
    result.A[107] = z385;
    result.A[108] = n0;
    result.A[109] = n0;
    result.A[110] = n0;
    result.A[111] = n1;
    result.A[112] = n0;
    result.A[113] = n0;
    result.A[114] = -z342;
    result.A[115] = -z351;
    result.A[116] = -z358;
    result.A[117] = -z389;
    result.A[118] = -z390;
    result.A[119] = z391;
    result.A[120] = n0;
    result.A[121] = n0;
    result.A[122] = n0;
    result.A[123] = n0;
    result.A[124] = n1;
    result.A[125] = n0;
    result.A[126] = z370;
    result.A[127] = -z372;
    result.A[128] = -z376;
    result.A[129] = -z395;
    result.A[130] = -z397;
    result.A[131] = -z401;
    result.A[132] = n0;
    result.A[133] = n0;
    result.A[134] = n0;
    result.A[135] = n0;
    result.A[136] = n0;
    result.A[137] = n1;
    result.A[138] = -z381;
    result.A[139] = z384;
    result.A[140] = -z398;
    result.A[141] = -z400;
    result.A[142] = -z403;
    result.A[143] = -z404;
    if (!(traits::regular(-z325, n20500) && traits::regular(-z315, z127) && traits::regular(-z300, z103)
        && traits::regular(-z276, z91))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((((n0 * result.M[1] * result.M[2] * result.M[3] * result.M[4] * result.M[5] * result.M[6]
        * result.M[7] * result.M[8]) * (n0 * result.M[9] * result.M[10] * result.M[11] * result.M[12] * result.M[13]
        * result.M[14] * result.M[15] * result.M[16] * result.M[18])) * ((n0 * result.M[19] * result.M[20]
        * result.M[21] * result.M[22] * result.M[24] * result.M[25] * result.M[26] * result.M[27]) * (n0 * result.M[30]
        * result.M[31] * result.C[6] * result.C[7] * result.C[8] * result.C[9] * result.C[10] * result.C[11]
        * result.C[12]))) * (((n0 * result.C[13] * result.C[14] * result.C[15] * result.C[16] * result.C[18]
        * result.C[19] * result.C[20] * result.C[21]) * (n0 * result.C[22] * result.C[24] * result.C[25] * result.C[26]
        * result.C[27] * result.C[30] * result.C[31] * result.K[6] * result.K[7])) * ((n0 * result.K[8] * result.K[9]
        * result.K[10] * result.K[11] * result.K[12] * result.K[13] * result.K[14] * result.K[15] * result.K[16]) * (n0
        * result.K[18] * result.K[19] * result.K[20] * result.K[21] * result.K[22] * result.K[24] * result.K[25]
        * result.K[26] * result.K[27])))) * ((((n0 * result.K[28] * result.K[30] * result.K[31] * result.K[35]
        * result.F[0] * result.F[1] * result.F[2] * result.F[3]) * (n0 * result.F[4] * result.F[5] * result.A[18]
        * result.A[19] * result.A[20] * result.A[21] * result.A[22] * result.A[23] * result.A[30])) * ((n0
        * result.A[31] * result.A[32] * result.A[33] * result.A[34] * result.A[35] * result.A[42] * result.A[43]
        * result.A[44] * result.A[45]) * (n0 * result.A[46] * result.A[47] * result.A[54] * result.A[55] * result.A[56]
        * result.A[57] * result.A[58] * result.A[59] * result.A[66]))) * (((n0 * result.A[67] * result.A[68]
        * result.A[69] * result.A[70] * result.A[71] * result.A[90] * result.A[91] * result.A[92]) * (n0 * result.A[93]
        * result.A[94] * result.A[95] * result.A[102] * result.A[103] * result.A[104] * result.A[105] * result.A[106]
        * result.A[107])) * ((n0 * result.A[114] * result.A[115] * result.A[116] * result.A[117] * result.A[118]
        * result.A[119] * result.A[126] * result.A[127] * result.A[128]) * (n0 * result.A[129] * result.A[130]
        * result.A[131] * result.A[138] * result.A[139] * result.A[140] * result.A[141] * result.A[142]
        * result.A[143]))));
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
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 36>&>(mass_matrix));
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

}  // namespace elastic_wing
