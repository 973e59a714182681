// SPDX-License-Identifier: MIT-0
// flyball_governor: Stiff flyball governor (IFToMM benchmark A05)
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, linearisation, residual, residual_jacobian
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function           additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                30               57          0             0                  3       0     93      93
//   mass_matrix                4                8          0             0                  2       0     16      16
//   bias                      34               77          4             2                  2       0    121     126
//   inverse_dynamics          42               89          4             2                  2       0    141     146
//   forward_dynamics          38               89          5             2                  2       0    138     143
//   energy                    32               64          2             2                  2       0    104     116
//   first_integrals            4                9          0             0                  2       0     17      17
//   linearisation            119              289         25             2                  2       0    439     477
//   residual                  42               89          4             2                  2       0    141     146
//   residual_jacobian         98              235         24             2                  2       0    363     398
//
// Not computed because this mechanism does not need it:
//   kinematics: of 180 results 57 vanish identically, 63 repeat another up to sign
//   mass_matrix: of 16 results 12 vanish identically
//   constraints: left out, the scene has no constraints
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 116 results 62 vanish identically
//
// To write this file again:
//   flyball_governor_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,residual,residual_jacobian --support torsor_support.hpp --output flyball_governor.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace flyball_governor {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 4> coordinates{{{"psi", "rad"}, {"s", "m"}, {"beta_1",
      "rad"}, {"beta_2", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 4> velocities{{{"psi", "rad/s"}, {"s", "m/s"}, {"beta_1",
      "rad/s"}, {"beta_2", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 52> results{{{"result", "shaft_position", 3, 1, 1, "m"},
      {"result", "shaft_rotation", 3, 3, 2, "1"}, {"result", "shaft_velocity", 3, 1, 1, "m/s"}, {"result",
      "shaft_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "slider_position", 3, 1, 1, "m"}, {"result",
      "slider_rotation", 3, 3, 2, "1"}, {"result", "slider_velocity", 3, 1, 1, "m/s"}, {"result",
      "slider_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "rod_1_position", 3, 1, 1, "m"}, {"result",
      "rod_1_rotation", 3, 3, 2, "1"}, {"result", "rod_1_velocity", 3, 1, 1, "m/s"}, {"result",
      "rod_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "ball_1_position", 3, 1, 1, "m"}, {"result",
      "ball_1_rotation", 3, 3, 2, "1"}, {"result", "ball_1_velocity", 3, 1, 1, "m/s"}, {"result",
      "ball_1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "rod_2_position", 3, 1, 1, "m"}, {"result",
      "rod_2_rotation", 3, 3, 2, "1"}, {"result", "rod_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "rod_2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "ball_2_position", 3, 1, 1, "m"}, {"result",
      "ball_2_rotation", 3, 3, 2, "1"}, {"result", "ball_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "ball_2_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "middle_1_position", 3, 1, 1, "m"}, {"result",
      "middle_1_velocity", 3, 1, 1, "m/s"}, {"result", "middle_1_jacobian", 3, 4, 2, "m"}, {"result", "ear_1_position",
      3, 1, 1, "m"}, {"result", "ear_1_velocity", 3, 1, 1, "m/s"}, {"result", "ear_1_jacobian", 3, 4, 2, ""}, {"result",
      "middle_2_position", 3, 1, 1, "m"}, {"result", "middle_2_velocity", 3, 1, 1, "m/s"}, {"result",
      "middle_2_jacobian", 3, 4, 2, "m"}, {"result", "ear_2_position", 3, 1, 1, "m"}, {"result", "ear_2_velocity", 3, 1,
      1, "m/s"}, {"result", "ear_2_jacobian", 3, 4, 2, ""}, {"mass", "", 4, 4, 2, ""}, {"forces", "", 4, 1, 1,
      "N m, N, N m, N m"}, {"forces", "", 4, 1, 1, "N m, N, N m, N m"}, {"accelerations", "", 4, 1, 1,
      "rad/s^2, m/s^2, rad/s^2, rad/s^2"}, {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1, 0, "J"},
      {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "momentum_psi", 1, 1, 0,
      "N m s"}, {"result", "M", 4, 4, 2, ""}, {"result", "C", 4, 4, 2, ""}, {"result", "K", 4, 4, 2, ""}, {"result",
      "F", 4, 1, 1, "N m, N, N m, N m"}, {"result", "A", 8, 8, 2, ""}, {"residual", "", 4, 1, 1, "N m, N, N m, N m"},
      {"result", "values", 25, 1, 1,
      "N m, N m, N m s, N m s, N m s, kg m^2, N/m, N, N, N s/m, N s, N s, kg, N, N m, N m s, N s, N m s, kg m^2, N, N m, N m s, N s, N m s, kg m^2"}}};
  static constexpr std::array<torsor::KernelDescription, 10> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 36}, {"mass_matrix", false, false, false, false, results.data() + 36, 1}, {"bias", false,
      false, false, false, results.data() + 37, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 38,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 39, 2}, {"energy", false, false, true, false,
      results.data() + 41, 3}, {"first_integrals", false, false, false, false, results.data() + 44, 1},
      {"linearisation", true, true, true, true, results.data() + 45, 5}, {"residual", true, true, true, false,
      results.data() + 50, 1}, {"residual_jacobian", true, true, true, false, results.data() + 51, 1}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::flyball_governor::Description;

  static constexpr const char* name = "flyball_governor";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x8d29f45144595021ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 4;
  static constexpr int velocity_count = 4;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar psi;  ///< coordinate [rad]
    Scalar s;  ///< coordinate [m]
    Scalar beta_1;  ///< coordinate [rad]
    Scalar beta_2;  ///< coordinate [rad]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::psi, &Coordinates::s, &Coordinates::beta_1,
          &Coordinates::beta_2};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar psi;  ///< its rate [rad/s]
    Scalar s;  ///< its rate [m/s]
    Scalar beta_1;  ///< its rate [rad/s]
    Scalar beta_2;  ///< its rate [rad/s]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::psi, &Velocities::s, &Velocities::beta_1,
          &Velocities::beta_2};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar s;  ///< its second rate [m/s^2]
    Scalar beta_1;  ///< its second rate [rad/s^2]
    Scalar beta_2;  ///< its second rate [rad/s^2]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::psi, &Accelerations::s, &Accelerations::beta_1,
          &Accelerations::beta_2};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar s;  ///< works with the rate of s [N]
    Scalar beta_1;  ///< works with the rate of beta_1 [N m]
    Scalar beta_2;  ///< works with the rate of beta_2 [N m]
    static constexpr int size = 4;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::psi, &GeneralizedForces::s,
          &GeneralizedForces::beta_1, &GeneralizedForces::beta_2};
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_over_6 = traits::constant(0.16666666666666666, 0.16666667f, "1/6");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar pi = traits::pi();
    state.time = n0;
    state.q.psi = n0;
    state.q.s = n0_5;
    state.q.beta_1 = n1_over_6 * pi;
    state.q.beta_2 = state.q.beta_1;
    state.v.psi = n2 * pi;
    state.v.s = n0;
    state.v.beta_1 = n0;
    state.v.beta_2 = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> shaft_position;  ///< centre of mass of shaft [m]
    std::array<Scalar, 9> shaft_rotation;  ///< from the axes of shaft to the ground's (3 x 3)
    std::array<Scalar, 3> shaft_velocity;  ///< velocity of the centre of mass of shaft [m/s]
    std::array<Scalar, 3> shaft_angular_velocity;  ///< angular velocity of shaft [rad/s]
    std::array<Scalar, 3> slider_position;  ///< centre of mass of slider [m]
    std::array<Scalar, 9> slider_rotation;  ///< from the axes of slider to the ground's (3 x 3)
    std::array<Scalar, 3> slider_velocity;  ///< velocity of the centre of mass of slider [m/s]
    std::array<Scalar, 3> slider_angular_velocity;  ///< angular velocity of slider [rad/s]
    std::array<Scalar, 3> rod_1_position;  ///< centre of mass of rod_1 [m]
    std::array<Scalar, 9> rod_1_rotation;  ///< from the axes of rod_1 to the ground's (3 x 3)
    std::array<Scalar, 3> rod_1_velocity;  ///< velocity of the centre of mass of rod_1 [m/s]
    std::array<Scalar, 3> rod_1_angular_velocity;  ///< angular velocity of rod_1 [rad/s]
    std::array<Scalar, 3> ball_1_position;  ///< centre of mass of ball_1 [m]
    std::array<Scalar, 9> ball_1_rotation;  ///< from the axes of ball_1 to the ground's (3 x 3)
    std::array<Scalar, 3> ball_1_velocity;  ///< velocity of the centre of mass of ball_1 [m/s]
    std::array<Scalar, 3> ball_1_angular_velocity;  ///< angular velocity of ball_1 [rad/s]
    std::array<Scalar, 3> rod_2_position;  ///< centre of mass of rod_2 [m]
    std::array<Scalar, 9> rod_2_rotation;  ///< from the axes of rod_2 to the ground's (3 x 3)
    std::array<Scalar, 3> rod_2_velocity;  ///< velocity of the centre of mass of rod_2 [m/s]
    std::array<Scalar, 3> rod_2_angular_velocity;  ///< angular velocity of rod_2 [rad/s]
    std::array<Scalar, 3> ball_2_position;  ///< centre of mass of ball_2 [m]
    std::array<Scalar, 9> ball_2_rotation;  ///< from the axes of ball_2 to the ground's (3 x 3)
    std::array<Scalar, 3> ball_2_velocity;  ///< velocity of the centre of mass of ball_2 [m/s]
    std::array<Scalar, 3> ball_2_angular_velocity;  ///< angular velocity of ball_2 [rad/s]
    std::array<Scalar, 3> middle_1_position;  ///< position of middle_1 [m]
    std::array<Scalar, 3> middle_1_velocity;  ///< velocity of the material point at middle_1 [m/s]
    std::array<Scalar, 12> middle_1_jacobian;  ///< partial velocities of middle_1 (3 x 4)
    std::array<Scalar, 3> ear_1_position;  ///< position of ear_1 [m]
    std::array<Scalar, 3> ear_1_velocity;  ///< velocity of the material point at ear_1 [m/s]
    std::array<Scalar, 12> ear_1_jacobian;  ///< partial velocities of ear_1 (3 x 4)
    std::array<Scalar, 3> middle_2_position;  ///< position of middle_2 [m]
    std::array<Scalar, 3> middle_2_velocity;  ///< velocity of the material point at middle_2 [m/s]
    std::array<Scalar, 12> middle_2_jacobian;  ///< partial velocities of middle_2 (3 x 4)
    std::array<Scalar, 3> ear_2_position;  ///< position of ear_2 [m]
    std::array<Scalar, 3> ear_2_velocity;  ///< velocity of the material point at ear_2 [m/s]
    std::array<Scalar, 12> ear_2_jacobian;  ///< partial velocities of ear_2 (3 x 4)
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
    std::array<Scalar, 16> M;  ///< mass matrix (4 x 4)
    std::array<Scalar, 16> C;  ///< damping and gyroscopic terms (4 x 4)
    std::array<Scalar, 16> K;  ///< stiffness (4 x 4)
    std::array<Scalar, 4> F;  ///< right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, e'): x' = A x + B du (8 x 8)
  };

  /// Derivatives of the residual in compressed rows.
  struct ResidualJacobian {
    std::array<Scalar, 25> values;  ///< entries, row by row
  };
  /// Where the values of ResidualJacobian stand: those of row i from row_start[i] to row_start[i + 1], each in its
  /// column: of unknown j by position j, by velocity n + j, by acceleration 2 n + j, by multiplier k 3 n + k.
  static constexpr int residual_jacobian_nonzeros = 25;
  static constexpr int residual_jacobian_row_start[5] = {0, 6, 13, 19, 25};
  static constexpr int residual_jacobian_column[25] = {2, 3, 4, 6, 7, 8, 1, 2, 3, 5, 6, 7, 9, 1, 2, 4, 5, 6, 10, 1, 3,
      4, 5, 7, 11};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_psi, q_beta_1, q_beta_2};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_beta_1 = sines_[1], c_beta_1 = cosines_[1];
    const Scalar s_beta_2 = sines_[2], c_beta_2 = cosines_[2];
    const Scalar z0 = n0_05 * v_psi;
    const Scalar z1 = s_psi * c_beta_1;
    const Scalar z2 = s_psi * c_beta_2;
    const Scalar z3 = c_psi * s_beta_1;
    const Scalar z4 = s_psi * s_beta_1;
    const Scalar z5 = v_psi * c_beta_1;
    const Scalar z6 = s_psi * z0;  // velocity of rod_1, x
    const Scalar z7 = c_psi * z0;  // velocity of rod_1, y
    const Scalar z8 = c_psi * s_beta_2;
    const Scalar z9 = s_psi * s_beta_2;
    const Scalar z10 = v_psi * c_beta_2;
    const Scalar z11 = n0_5 * v_beta_1;
    const Scalar z12 = n0_5 * v_beta_2;
    const Scalar z13 = c_psi * c_beta_1;
    const Scalar z14 = c_psi * c_beta_2;
    const Scalar z15 = n0_05 * c_psi;
    const Scalar z16 = n0_05 * s_psi;
    const Scalar z17 = n0_5 * s_beta_1;
    const Scalar z18 = n0_5 * s_beta_2;
    const Scalar z19 = s_psi * v_beta_1;  // angular velocity of rod_1, x
    const Scalar z20 = c_psi * v_beta_1;  // angular velocity of rod_1, y
    const Scalar z21 = s_psi * v_beta_2;  // angular velocity of rod_2, x
    const Scalar z22 = c_psi * v_beta_2;  // angular velocity of rod_2, y
    const Scalar z23 = c_beta_1 * z11;
    const Scalar z24 = n1 - s_beta_1;
    const Scalar z25 = v_beta_1 * c_beta_1;
    const Scalar z26 = c_beta_2 * z12;
    const Scalar z27 = n1 - s_beta_2;
    const Scalar z28 = v_beta_2 * c_beta_2;
    const Scalar z29 = n0_5 * z13;
    const Scalar z30 = n0_5 * z1;
    const Scalar z31 = n1 - z17;
    const Scalar z32 = n0_5 * z5;
    const Scalar z33 = z13 + z15;
    const Scalar z34 = z1 + z16;
    const Scalar z35 = z6 + s_psi * z5 + v_beta_1 * z3;
    const Scalar z36 = z7 + c_psi * z5 - v_beta_1 * z4;
    const Scalar z37 = n0_5 * z14;
    const Scalar z38 = n0_5 * z2;
    const Scalar z39 = n1 - z18;
    const Scalar z40 = n0_5 * z10;
    const Scalar z41 = z15 + z14;
    const Scalar z42 = z16 + z2;
    const Scalar z43 = z6 + s_psi * z10 + v_beta_2 * z8;
    const Scalar z44 = z7 + c_psi * z10 - v_beta_2 * z9;
    const Scalar z45 = c_psi * z17;
    const Scalar z46 = s_psi * z17;
    const Scalar z47 = c_psi * z18;
    const Scalar z48 = s_psi * z18;
    const Scalar z49 = z15 + z29;
    const Scalar z50 = z16 + z30;
    const Scalar z51 = z3 * z11 + z6 + s_psi * z32;
    const Scalar z52 = z7 - z4 * z11 + c_psi * z32;
    const Scalar z53 = z15 + z37;
    const Scalar z54 = z16 + z38;
    const Scalar z55 = z6 + z8 * z12 + s_psi * z40;
    const Scalar z56 = z7 - z9 * z12 + c_psi * z40;
    const Scalar z57 = s_psi * z30 + c_psi * z29;
    const Scalar z58 = s_psi * z38 + c_psi * z37;
    result.shaft_position[0] = n0;
    result.shaft_position[1] = n0;
    result.shaft_position[2] = n0_5;
    result.shaft_rotation[0] = c_psi;
    result.shaft_rotation[1] = s_psi;
    result.shaft_rotation[2] = n0;
    result.shaft_rotation[3] = -s_psi;
    result.shaft_rotation[4] = c_psi;
    result.shaft_rotation[5] = n0;
    result.shaft_rotation[6] = n0;
    result.shaft_rotation[7] = n0;
    result.shaft_rotation[8] = n1;
    result.shaft_velocity[0] = n0;
    result.shaft_velocity[1] = n0;
    result.shaft_velocity[2] = n0;
    result.shaft_angular_velocity[0] = n0;
    result.shaft_angular_velocity[1] = n0;
    result.shaft_angular_velocity[2] = v_psi;
    result.slider_position[0] = n0;
    result.slider_position[1] = n0;
    result.slider_position[2] = q_s;
    result.slider_rotation[0] = c_psi;
    result.slider_rotation[1] = s_psi;
    result.slider_rotation[2] = n0;
    result.slider_rotation[3] = -s_psi;
    result.slider_rotation[4] = c_psi;
    result.slider_rotation[5] = n0;
    result.slider_rotation[6] = n0;
    result.slider_rotation[7] = n0;
    result.slider_rotation[8] = n1;
    result.slider_velocity[0] = n0;
    result.slider_velocity[1] = n0;
    result.slider_velocity[2] = v_s;
    result.slider_angular_velocity[0] = n0;
    result.slider_angular_velocity[1] = n0;
    result.slider_angular_velocity[2] = v_psi;
    result.rod_1_position[0] = z49;
    result.rod_1_position[1] = z50;
    result.rod_1_position[2] = z31;
    result.rod_1_rotation[0] = z13;
    result.rod_1_rotation[1] = z1;
    result.rod_1_rotation[2] = -s_beta_1;
    result.rod_1_rotation[3] = -s_psi;
    result.rod_1_rotation[4] = c_psi;
    result.rod_1_rotation[5] = n0;
    result.rod_1_rotation[6] = z3;
    result.rod_1_rotation[7] = z4;
    result.rod_1_rotation[8] = c_beta_1;
    result.rod_1_velocity[0] = -z51;
    result.rod_1_velocity[1] = z52;
    result.rod_1_velocity[2] = -z23;
    result.rod_1_angular_velocity[0] = -z19;
    result.rod_1_angular_velocity[1] = z20;
    result.rod_1_angular_velocity[2] = v_psi;
    result.ball_1_position[0] = z33;
    result.ball_1_position[1] = z34;
    result.ball_1_position[2] = z24;
    result.ball_1_rotation[0] = z13;
    result.ball_1_rotation[1] = z1;
    result.ball_1_rotation[2] = -s_beta_1;
    result.ball_1_rotation[3] = -s_psi;
    result.ball_1_rotation[4] = c_psi;
    result.ball_1_rotation[5] = n0;
    result.ball_1_rotation[6] = z3;
    result.ball_1_rotation[7] = z4;
    result.ball_1_rotation[8] = c_beta_1;
    result.ball_1_velocity[0] = -z35;
    result.ball_1_velocity[1] = z36;
    result.ball_1_velocity[2] = -z25;
    result.ball_1_angular_velocity[0] = -z19;
    result.ball_1_angular_velocity[1] = z20;
    result.ball_1_angular_velocity[2] = v_psi;
    result.rod_2_position[0] = -z53;
    result.rod_2_position[1] = -z54;
    result.rod_2_position[2] = z39;
    result.rod_2_rotation[0] = z14;
    result.rod_2_rotation[1] = z2;
    result.rod_2_rotation[2] = s_beta_2;
    result.rod_2_rotation[3] = -s_psi;
    result.rod_2_rotation[4] = c_psi;
    result.rod_2_rotation[5] = n0;
    result.rod_2_rotation[6] = -z8;
    result.rod_2_rotation[7] = -z9;
    result.rod_2_rotation[8] = c_beta_2;
    result.rod_2_velocity[0] = z55;
    result.rod_2_velocity[1] = -z56;
    result.rod_2_velocity[2] = -z26;
    result.rod_2_angular_velocity[0] = z21;
    result.rod_2_angular_velocity[1] = -z22;
    result.rod_2_angular_velocity[2] = v_psi;
    result.ball_2_position[0] = -z41;
    result.ball_2_position[1] = -z42;
    result.ball_2_position[2] = z27;
    result.ball_2_rotation[0] = z14;
    result.ball_2_rotation[1] = z2;
    result.ball_2_rotation[2] = s_beta_2;
    result.ball_2_rotation[3] = -s_psi;
    result.ball_2_rotation[4] = c_psi;
    result.ball_2_rotation[5] = n0;
    result.ball_2_rotation[6] = -z8;
    result.ball_2_rotation[7] = -z9;
    result.ball_2_rotation[8] = c_beta_2;
    result.ball_2_velocity[0] = z43;
    result.ball_2_velocity[1] = -z44;
    result.ball_2_velocity[2] = -z28;
    result.ball_2_angular_velocity[0] = z21;
    result.ball_2_angular_velocity[1] = -z22;
    result.ball_2_angular_velocity[2] = v_psi;
    result.middle_1_position[0] = z49;
    result.middle_1_position[1] = z50;
    result.middle_1_position[2] = z31;
    result.middle_1_velocity[0] = -z51;
    result.middle_1_velocity[1] = z52;
    result.middle_1_velocity[2] = -z23;
    result.middle_1_jacobian[0] = -z50;
    result.middle_1_jacobian[3] = n0;
    result.middle_1_jacobian[6] = -z45;
    result.middle_1_jacobian[9] = n0;
    result.middle_1_jacobian[1] = z49;
    result.middle_1_jacobian[4] = n0;
    result.middle_1_jacobian[7] = -z46;
    result.middle_1_jacobian[10] = n0;
    result.middle_1_jacobian[2] = n0;
    result.middle_1_jacobian[5] = n0;
    result.middle_1_jacobian[8] = -z57;
    result.middle_1_jacobian[11] = n0;
    result.ear_1_position[0] = z15;
    result.ear_1_position[1] = z16;
    result.ear_1_position[2] = q_s;
    result.ear_1_velocity[0] = -z6;
    result.ear_1_velocity[1] = z7;
    result.ear_1_velocity[2] = v_s;
    result.ear_1_jacobian[0] = -z16;
    result.ear_1_jacobian[3] = n0;
    result.ear_1_jacobian[6] = n0;
    result.ear_1_jacobian[9] = n0;
    result.ear_1_jacobian[1] = z15;
    result.ear_1_jacobian[4] = n0;
    result.ear_1_jacobian[7] = n0;
    result.ear_1_jacobian[10] = n0;
    result.ear_1_jacobian[2] = n0;
    result.ear_1_jacobian[5] = n1;
    result.ear_1_jacobian[8] = n0;
    result.ear_1_jacobian[11] = n0;
    result.middle_2_position[0] = -z53;
    result.middle_2_position[1] = -z54;
    result.middle_2_position[2] = z39;
    result.middle_2_velocity[0] = z55;
    result.middle_2_velocity[1] = -z56;
    result.middle_2_velocity[2] = -z26;
    result.middle_2_jacobian[0] = z54;
    result.middle_2_jacobian[3] = n0;
    result.middle_2_jacobian[6] = n0;
    result.middle_2_jacobian[9] = z47;
    result.middle_2_jacobian[1] = -z53;
    result.middle_2_jacobian[4] = n0;
    result.middle_2_jacobian[7] = n0;
    result.middle_2_jacobian[10] = z48;
    result.middle_2_jacobian[2] = n0;
    result.middle_2_jacobian[5] = n0;
    result.middle_2_jacobian[8] = n0;
    result.middle_2_jacobian[11] = -z58;
    result.ear_2_position[0] = -z15;
    result.ear_2_position[1] = -z16;
    result.ear_2_position[2] = q_s;
    result.ear_2_velocity[0] = z6;
    result.ear_2_velocity[1] = -z7;
    result.ear_2_velocity[2] = v_s;
    result.ear_2_jacobian[0] = z16;
    result.ear_2_jacobian[3] = n0;
    result.ear_2_jacobian[6] = n0;
    result.ear_2_jacobian[9] = n0;
    result.ear_2_jacobian[1] = -z15;
    result.ear_2_jacobian[4] = n0;
    result.ear_2_jacobian[7] = n0;
    result.ear_2_jacobian[10] = n0;
    result.ear_2_jacobian[2] = n0;
    result.ear_2_jacobian[5] = n1;
    result.ear_2_jacobian[8] = n0;
    result.ear_2_jacobian[11] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 16>& mass) noexcept {
    const Scalar k0 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k3 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k6 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_beta_1 = cosines_[0];
    const Scalar c_beta_2 = cosines_[1];
    const Scalar z0 = k0 * c_beta_2;
    const Scalar z1 = n5_15 * c_beta_2;
    const Scalar z2 = k0 * c_beta_1;
    const Scalar z3 = n5_15 * c_beta_1;
    const Scalar z4 = c_beta_2 * z0;
    const Scalar z5 = c_beta_1 * z2;
    const Scalar z6 = n0_1 * z1 + z4;
    const Scalar z7 = n0_1 * z3 + z5;
    const Scalar z8 = k3 + z6;
    const Scalar z9 = z8 + z7;
    mass[0] = z9;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n3;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = k6;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = k6;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k5 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n10_2 = traits::constant(10.2, 10.2f, "51/5");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar k11 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar v_psi = state.v.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z0 = n1 - q_s;
    const Scalar z1 = v_beta_1 * s_beta_1;
    const Scalar z2 = v_beta_2 * s_beta_2;
    const Scalar z3 = v_beta_1 * c_beta_1;
    const Scalar z4 = v_beta_2 * c_beta_2;
    const Scalar z5 = n0_5 * s_beta_1;
    const Scalar z6 = s_beta_1 * z0;
    const Scalar z7 = c_beta_1 * z0;
    const Scalar z8 = s_beta_2 * z0;
    const Scalar z9 = c_beta_2 * z0;
    const Scalar z10 = v_psi * c_beta_2;
    const Scalar z11 = v_psi * s_beta_1;
    const Scalar z12 = v_psi * s_beta_2;
    const Scalar z13 = n0_5 * s_beta_2;
    const Scalar z14 = v_psi * v_psi;
    const Scalar z15 = v_psi * c_beta_1;
    const Scalar z16 = n0_05 * z14;
    const Scalar z17 = s_beta_1 * z16 - n9_81 * c_beta_1;
    const Scalar z18 = s_beta_2 * z16 - n9_81 * c_beta_2;
    const Scalar z19 = n0_5 - z6;
    const Scalar z20 = n1 - z5;
    const Scalar z21 = v_s * c_beta_1 + z0 * z1;
    const Scalar z22 = v_s * s_beta_1 - z0 * z3;
    const Scalar z23 = n0_5 - z8;
    const Scalar z24 = n1 - z13;
    const Scalar z25 = v_s * c_beta_2 + z0 * z2;
    const Scalar z26 = v_s * s_beta_2 - z0 * z4;
    const Scalar z27 = v_beta_1 * z15;  // angular acceleration of rod_1, x
    const Scalar z28 = v_beta_1 * z11;  // angular acceleration of rod_1, z
    const Scalar z29 = v_beta_2 * z10;  // angular acceleration of rod_2, x
    const Scalar z30 = v_beta_2 * z12;  // angular acceleration of rod_2, z
    const Scalar z31 = z12 * z10;
    const Scalar z32 = q_s - z20;
    const Scalar z33 = z11 * z15;
    const Scalar z34 = z7 * z7 + z19 * z19;
    const Scalar z35 = q_s - z24;
    const Scalar z36 = z9 * z9 + z23 * z23;
    const Scalar z37 = n2 * z30;
    const Scalar z38 = k5 * z29;  // moment on rod_2, x
    const Scalar z39 = n10_2 * z30;  // moment on rod_2, z
    const Scalar z40 = n2 * z28;
    const Scalar z41 = n2 * (z7 * z21 - z19 * z22);
    const Scalar z42 = n2 * (z9 * z25 - z23 * z26);
    const Scalar z43 = n5_15 * z37;  // force on rod_2, y
    const Scalar z44 = s_beta_2 * z38 - c_beta_2 * z39;
    const Scalar z45 = n5_15 * z40;  // force on rod_1, y
    const Scalar z46 = traits::sqrt(z34);
    const Scalar z47 = k5 * z27;  // moment on rod_1, x
    const Scalar z48 = traits::sqrt(z36);
    const Scalar z49 = n0_5 * z41;
    const Scalar z50 = n0_5 * z42;
    const Scalar z51 = n40000 * z49 / z34;
    const Scalar z52 = n40000 * z50 / z36;
    const Scalar z53 = n1 / z46;
    const Scalar z54 = n1 / z48;
    const Scalar z55 = z7 * z51;
    const Scalar z56 = z32 * z51;
    const Scalar z57 = z9 * z52;
    const Scalar z58 = z35 * z52;
    const Scalar z59 = n800000 - n400000 * z53;
    const Scalar z60 = n10_2 * z28;  // moment on rod_1, z
    const Scalar z61 = n800000 - n400000 * z54;
    const Scalar z62 = z7 * z59;
    const Scalar z63 = s_beta_1 * z47 - c_beta_1 * z60;
    const Scalar z64 = z32 * z59;
    const Scalar z65 = n0_05 * (z43 + z45) - z44 - z63;  // moment on shaft, z
    const Scalar z66 = z9 * z61;
    const Scalar z67 = z35 * z61;
    const Scalar z68 = z64 - z56 + z67 - z58;
    const Scalar z69 = n0_5 * (z62 - z55);
    const Scalar z70 = n0_5 * (z66 - z57);
    const Scalar z71 = z70 - n5_15 * z18 - k11 * z31;  // moment on rod_2, y
    const Scalar z72 = z69 - n5_15 * z17 - k11 * z33;  // moment on rod_1, y
    const Scalar z73 = n29_43 + z68;  // force on slider, z
    forces.psi = -z65;
    forces.s = z73;
    forces.beta_1 = -z72;
    forces.beta_2 = -z71;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, GeneralizedForces& forces) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k5 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar k6 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k9 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar n10_2 = traits::constant(10.2, 10.2f, "51/5");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k16 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar a_s = accelerations.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z0 = n1 - q_s;
    const Scalar z1 = v_beta_1 * s_beta_1;
    const Scalar z2 = v_beta_2 * s_beta_2;
    const Scalar z3 = v_beta_1 * c_beta_1;
    const Scalar z4 = v_beta_2 * c_beta_2;
    const Scalar z5 = n0_5 * s_beta_1;
    const Scalar z6 = s_beta_1 * z0;
    const Scalar z7 = c_beta_1 * z0;
    const Scalar z8 = s_beta_2 * z0;
    const Scalar z9 = c_beta_2 * z0;
    const Scalar z10 = v_psi * c_beta_2;
    const Scalar z11 = v_psi * s_beta_1;
    const Scalar z12 = v_psi * s_beta_2;
    const Scalar z13 = n0_5 * s_beta_2;
    const Scalar z14 = v_psi * v_psi;
    const Scalar z15 = v_psi * c_beta_1;
    const Scalar z16 = n0_05 * z14;
    const Scalar z17 = n5_15 * c_beta_2;
    const Scalar z18 = s_beta_1 * z16 - n9_81 * c_beta_1;
    const Scalar z19 = s_beta_2 * z16 - n9_81 * c_beta_2;
    const Scalar z20 = n0_5 - z6;
    const Scalar z21 = k5 * c_beta_2;
    const Scalar z22 = n1 - z5;
    const Scalar z23 = v_s * c_beta_1 + z0 * z1;
    const Scalar z24 = v_s * s_beta_1 - z0 * z3;
    const Scalar z25 = n0_5 - z8;
    const Scalar z26 = n1 - z13;
    const Scalar z27 = v_s * c_beta_2 + z0 * z2;
    const Scalar z28 = v_s * s_beta_2 - z0 * z4;
    const Scalar z29 = v_beta_2 * z12;
    const Scalar z30 = z12 * z10;
    const Scalar z31 = v_beta_2 * z10;
    const Scalar z32 = v_beta_1 * z11;
    const Scalar z33 = z11 * z15;
    const Scalar z34 = v_beta_1 * z15;
    const Scalar z35 = c_beta_2 * z21;
    const Scalar z36 = q_s - z22;
    const Scalar z37 = z7 * z7 + z20 * z20;
    const Scalar z38 = n5_15 * c_beta_1;
    const Scalar z39 = q_s - z26;
    const Scalar z40 = z9 * z9 + z25 * z25;
    const Scalar z41 = k6 * z31;  // moment on rod_2, x
    const Scalar z42 = k6 * z34;  // moment on rod_1, x
    const Scalar z43 = n0_1 * z17 + z35;
    const Scalar z44 = n2 * (z7 * z23 - z20 * z24);
    const Scalar z45 = n2 * (z9 * z27 - z25 * z28);
    const Scalar z46 = traits::sqrt(z37);
    const Scalar z47 = k5 * c_beta_1;
    const Scalar z48 = traits::sqrt(z40);
    const Scalar z49 = k9 + z43;
    const Scalar z50 = n0_5 * z44;
    const Scalar z51 = n0_5 * z45;
    const Scalar z52 = n40000 * z50 / z37;
    const Scalar z53 = n40000 * z51 / z40;
    const Scalar z54 = n1 / z46;
    const Scalar z55 = c_beta_1 * z47;
    const Scalar z56 = n1 / z48;
    const Scalar z57 = z7 * z52;
    const Scalar z58 = z36 * z52;
    const Scalar z59 = z9 * z53;
    const Scalar z60 = z39 * z53;
    const Scalar z61 = n800000 - n400000 * z54;
    const Scalar z62 = n0_1 * z38 + z55;
    const Scalar z63 = n800000 - n400000 * z56;
    const Scalar z64 = z7 * z61;
    const Scalar z65 = z49 + z62;
    const Scalar z66 = z36 * z61;
    const Scalar z67 = n2 * z29;
    const Scalar z68 = n2 * z32;
    const Scalar z69 = n10_2 * z29;  // moment on rod_2, z
    const Scalar z70 = s_beta_2 * z41 - c_beta_2 * z69;
    const Scalar z71 = n5_15 * z67;  // force on rod_2, y
    const Scalar z72 = n5_15 * z68;  // force on rod_1, y
    const Scalar z73 = n10_2 * z32;  // moment on rod_1, z
    const Scalar z74 = s_beta_1 * z42 - c_beta_1 * z73;
    const Scalar z75 = n0_05 * (z71 + z72) - z70 - z74;  // moment on shaft, z
    const Scalar z76 = a_psi * z65 - z75;
    const Scalar z77 = z9 * z63;
    const Scalar z78 = z39 * z63;
    const Scalar z79 = z66 - z58 + z78 - z60;
    const Scalar z80 = n0_5 * (z64 - z57);
    const Scalar z81 = n0_5 * (z77 - z59);
    const Scalar z82 = z81 - n5_15 * z19 - k5 * z30;  // moment on rod_2, y
    const Scalar z83 = z80 - n5_15 * z18 - k5 * z33;  // moment on rod_1, y
    const Scalar z84 = n29_43 + z79;  // force on slider, z
    const Scalar z85 = n3 * a_s + z84;
    const Scalar z86 = k16 * a_beta_1 - z83;
    const Scalar z87 = k16 * a_beta_2 - z82;
    forces.psi = z76;
    forces.s = z85;
    forces.beta_1 = z86;
    forces.beta_2 = z87;
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
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k1 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar k12 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n10_2 = traits::constant(10.2, 10.2f, "51/5");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar k16 = traits::constant(0.19607833525571802, 0.19607833f, "400000/2040001");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_psi = state.v.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z0 = n1 - q_s;
    const Scalar z1 = v_beta_1 * s_beta_1;
    const Scalar z2 = v_beta_2 * s_beta_2;
    const Scalar z3 = v_beta_1 * c_beta_1;
    const Scalar z4 = v_beta_2 * c_beta_2;
    const Scalar z5 = k1 * c_beta_2;
    const Scalar z6 = s_beta_1 * z0;
    const Scalar z7 = c_beta_1 * z0;
    const Scalar z8 = s_beta_2 * z0;
    const Scalar z9 = c_beta_2 * z0;
    const Scalar z10 = n5_15 * c_beta_2;
    const Scalar z11 = k1 * c_beta_1;
    const Scalar z12 = n0_5 * s_beta_1;
    const Scalar z13 = n5_15 * c_beta_1;
    const Scalar z14 = v_psi * s_beta_1;
    const Scalar z15 = n0_5 * s_beta_2;
    const Scalar z16 = v_psi * v_psi;
    const Scalar z17 = v_psi * c_beta_1;
    const Scalar z18 = n0_05 * z16;
    const Scalar z19 = s_beta_1 * z18 - n9_81 * c_beta_1;
    const Scalar z20 = n0_5 - z6;
    const Scalar z21 = v_psi * s_beta_2;
    const Scalar z22 = n1 - z12;
    const Scalar z23 = v_psi * c_beta_2;
    const Scalar z24 = v_s * c_beta_1 + z0 * z1;
    const Scalar z25 = v_s * s_beta_1 - z0 * z3;
    const Scalar z26 = n0_5 - z8;
    const Scalar z27 = n1 - z15;
    const Scalar z28 = v_s * c_beta_2 + z0 * z2;
    const Scalar z29 = v_s * s_beta_2 - z0 * z4;
    const Scalar z30 = c_beta_2 * z5;
    const Scalar z31 = c_beta_1 * z11;
    const Scalar z32 = v_beta_1 * z17;  // angular acceleration of rod_1, x
    const Scalar z33 = v_beta_1 * z14;  // angular acceleration of rod_1, z
    const Scalar z34 = q_s - z22;
    const Scalar z35 = s_beta_2 * z18 - n9_81 * c_beta_2;
    const Scalar z36 = z7 * z7 + z20 * z20;
    const Scalar z37 = v_beta_2 * z23;  // angular acceleration of rod_2, x
    const Scalar z38 = q_s - z27;
    const Scalar z39 = z9 * z9 + z26 * z26;
    const Scalar z40 = z30 + n0_1 * z10;
    const Scalar z41 = z31 + n0_1 * z13;
    const Scalar z42 = n2 * (z7 * z24 - z20 * z25);
    const Scalar z43 = n2 * (z9 * z28 - z26 * z29);
    const Scalar z44 = traits::sqrt(z36);
    const Scalar z45 = v_beta_2 * z21;  // angular acceleration of rod_2, z
    const Scalar z46 = traits::sqrt(z39);
    const Scalar z47 = k8 + z40;
    const Scalar z48 = z47 + z41;
    const Scalar z49 = n1 / z48;
    const Scalar z50 = n0_5 * z42;
    const Scalar z51 = n0_5 * z43;
    const Scalar z52 = n40000 * z50 / z36;
    const Scalar z53 = n40000 * z51 / z39;
    const Scalar z54 = n1 / z44;
    const Scalar z55 = n2 * z45;
    const Scalar z56 = n1 / z46;
    const Scalar z57 = z7 * z52;
    const Scalar z58 = z34 * z52;
    const Scalar z59 = z9 * z53;
    const Scalar z60 = z38 * z53;
    const Scalar z61 = n800000 - n400000 * z54;
    const Scalar z62 = z21 * z23;
    const Scalar z63 = n800000 - n400000 * z56;
    const Scalar z64 = z7 * z61;
    const Scalar z65 = n5_15 * z55;
    const Scalar z66 = z34 * z61;
    const Scalar z67 = z14 * z17;
    const Scalar z68 = k12 * z37;
    const Scalar z69 = n2 * z33;
    const Scalar z70 = n10_2 * z45;
    const Scalar z71 = s_beta_2 * z68 - c_beta_2 * z70;
    const Scalar z72 = n5_15 * z69;
    const Scalar z73 = k12 * z32;
    const Scalar z74 = n10_2 * z33;
    const Scalar z75 = s_beta_1 * z73 - c_beta_1 * z74;
    const Scalar z76 = n0_05 * (z65 + z72) - z71 - z75;
    const Scalar z77 = z49 * z76;
    const Scalar z78 = z9 * z63;
    const Scalar z79 = z38 * z63;
    const Scalar z80 = z66 - z58 + z79 - z60;
    const Scalar z81 = n0_5 * (z64 - z57);
    const Scalar z82 = n0_5 * (z78 - z59);
    const Scalar z83 = z82 - n5_15 * z35 - k1 * z62;
    const Scalar z84 = z81 - n5_15 * z19 - k1 * z67;
    const Scalar z85 = n29_43 + z80;
    const Scalar z86 = n1_over_3 * z85;
    const Scalar z87 = k16 * z83;
    const Scalar z88 = k16 * z84;
    accelerations.psi = z77;
    accelerations.s = -z86;
    accelerations.beta_1 = z88;
    accelerations.beta_2 = z87;
    if (!(traits::regular(z48, z48))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.psi * accelerations.s * accelerations.beta_1 * accelerations.beta_2;
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
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n5_3 = traits::constant(5.3, 5.3f, "53/10");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar k4 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar k8 = traits::constant(0.0025025, 0.0025025f, "1001/400000");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar k10 = traits::constant(2.55000125, 2.5500011f, "2040001/800000");
    const Scalar k11 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar n105_4575 = traits::constant(105.4575, 105.4575f, "42183/400");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar v_psi = state.v.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z0 = n1 - q_s;
    const Scalar z1 = v_beta_1 * s_beta_1;
    const Scalar z2 = v_beta_2 * s_beta_2;
    const Scalar z3 = v_beta_1 * c_beta_1;
    const Scalar z4 = v_beta_2 * c_beta_2;
    const Scalar z5 = n0_05 * v_psi;
    const Scalar z6 = s_beta_1 * z0;
    const Scalar z7 = c_beta_1 * z0;
    const Scalar z8 = s_beta_2 * z0;
    const Scalar z9 = c_beta_2 * z0;
    const Scalar z10 = v_psi * c_beta_1;
    const Scalar z11 = v_psi * c_beta_2;
    const Scalar z12 = n5_3 * z5;
    const Scalar z13 = n5_15 * z5;
    const Scalar z14 = v_psi * s_beta_1;
    const Scalar z15 = v_psi * s_beta_2;
    const Scalar z16 = n5_15 * s_beta_1;
    const Scalar z17 = n5_15 * s_beta_2;
    const Scalar z18 = n5_15 * z10 + z12;
    const Scalar z19 = k4 * z10 + z13;
    const Scalar z20 = n5_15 * z11 + z12;
    const Scalar z21 = k4 * z11 + z13;
    const Scalar z22 = n0_5 - z6;
    const Scalar z23 = v_s * c_beta_1 + z0 * z1;
    const Scalar z24 = v_s * s_beta_1 - z0 * z3;
    const Scalar z25 = n0_5 - z8;
    const Scalar z26 = v_s * c_beta_2 + z0 * z2;
    const Scalar z27 = v_s * s_beta_2 - z0 * z4;
    const Scalar z28 = z7 * z7 + z22 * z22;
    const Scalar z29 = z9 * z9 + z25 * z25;
    const Scalar z30 = n2 * (z7 * z23 - z22 * z24);
    const Scalar z31 = n2 * (z9 * z26 - z25 * z27);
    const Scalar z32 = traits::sqrt(z28);
    const Scalar z33 = traits::sqrt(z29);
    const Scalar z34 = n0_5 * z30;
    const Scalar z35 = n0_5 * z31;
    const Scalar z36 = n40000 * z34 / z28;
    const Scalar z37 = n40000 * z35 / z29;
    const Scalar z38 = n0_5 - z32;
    const Scalar z39 = n0_5 - z33;
    result.kinetic = k8 * v_psi * v_psi + n1_5 * v_s * v_s + k10 * (v_beta_1 * v_beta_1 + v_beta_2 * v_beta_2) + k11
        * (z14 * z14 + z15 * z15) + n0_5 * (z10 * z19 + z11 * z21 + z5 * (z18 + z20));
    result.force_function = -n105_4575 - n29_43 * q_s + n9_81 * (z16 + z17) - n400000 * (z38 * z38 + z39 * z39);
    result.power = -z34 * z36 - z35 * z37;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar k0 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k3 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar v_psi = state.v.psi;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_beta_1 = cosines_[0];
    const Scalar c_beta_2 = cosines_[1];
    const Scalar z0 = k0 * c_beta_2;
    const Scalar z1 = n5_15 * c_beta_2;
    const Scalar z2 = k0 * c_beta_1;
    const Scalar z3 = n5_15 * c_beta_1;
    const Scalar z4 = c_beta_2 * z0;
    const Scalar z5 = c_beta_1 * z2;
    const Scalar z6 = n0_1 * z1 + z4;
    const Scalar z7 = n0_1 * z3 + z5;
    const Scalar z8 = k3 + z6;
    const Scalar z9 = z8 + z7;
    result.momentum_psi = v_psi * z9;
  }

  /// Linearisation about the state: M e'' + C e' + K e = F + E du, with e and du deviations from the state and the
  /// inputs. Zero accelerations give the expansion about a rest, with F what is left of the equations there.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, Linearisation& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar k5 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar k6 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar k12 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n10_2 = traits::constant(10.2, 10.2f, "51/5");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k16 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar k17 = traits::constant(0.19607833525571802, 0.19607833f, "400000/2040001");
    const Scalar n1_over_3 = traits::constant(0.3333333333333333, 0.33333334f, "1/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar a_s = accelerations.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z0 = n1 - q_s;
    const Scalar z1 = v_beta_1 * s_beta_1;
    const Scalar z2 = v_beta_2 * s_beta_2;
    const Scalar z3 = v_beta_1 * c_beta_1;
    const Scalar z4 = v_beta_2 * c_beta_2;
    const Scalar z5 = v_psi * s_beta_1;
    const Scalar z6 = s_beta_1 * z0;
    const Scalar z7 = c_beta_1 * z0;
    const Scalar z8 = s_beta_2 * z0;
    const Scalar z9 = c_beta_2 * z0;
    const Scalar z10 = v_psi * s_beta_2;
    const Scalar z11 = n0_5 * s_beta_1;
    const Scalar z12 = v_psi * c_beta_1;
    const Scalar z13 = v_psi * c_beta_2;
    const Scalar z14 = n0_5 * s_beta_2;
    const Scalar z15 = v_psi * v_psi;
    const Scalar z16 = n0_05 * z15;
    const Scalar z17 = n0_5 * c_beta_1;
    const Scalar z18 = n0_5 * c_beta_2;
    const Scalar z19 = n9_81 * s_beta_1 + c_beta_1 * z16;
    const Scalar z20 = s_beta_1 * z16 - n9_81 * c_beta_1;
    const Scalar z21 = s_beta_2 * z16 - n9_81 * c_beta_2;
    const Scalar z22 = n9_81 * s_beta_2 + c_beta_2 * z16;
    const Scalar z23 = n0_5 - z6;
    const Scalar z24 = n1 - z11;
    const Scalar z25 = n5_15 * s_beta_2;
    const Scalar z26 = v_s * c_beta_1 + z0 * z1;
    const Scalar z27 = v_s * s_beta_1 - z0 * z3;
    const Scalar z28 = n0_5 - z8;
    const Scalar z29 = n1 - z14;
    const Scalar z30 = v_s * c_beta_2 + z0 * z2;
    const Scalar z31 = v_s * s_beta_2 - z0 * z4;
    const Scalar z32 = v_beta_2 * z10;
    const Scalar z33 = z10 * z13;
    const Scalar z34 = v_beta_2 * z13;
    const Scalar z35 = v_beta_1 * z5;
    const Scalar z36 = z5 * z12;
    const Scalar z37 = v_beta_1 * z12;
    const Scalar z38 = q_s - z24;
    const Scalar z39 = n5_15 * c_beta_2;
    const Scalar z40 = z7 * z7 + z23 * z23;
    const Scalar z41 = k5 * s_beta_2;
    const Scalar z42 = q_s - z29;
    const Scalar z43 = z9 * z9 + z28 * z28;
    const Scalar z44 = k6 * z34;  // moment on rod_2, x
    const Scalar z45 = k6 * z37;  // moment on rod_1, x
    const Scalar z46 = n2 * (z7 * z26 - z23 * z27);
    const Scalar z47 = n2 * (z9 * z30 - z28 * z31);
    const Scalar z48 = traits::sqrt(z40);
    const Scalar z49 = k5 * c_beta_2;
    const Scalar z50 = traits::sqrt(z43);
    const Scalar z51 = n0_5 * z46;
    const Scalar z52 = n0_5 * z47;
    const Scalar z53 = n40000 * z51 / z40;
    const Scalar z54 = n40000 * z52 / z43;
    const Scalar z55 = n1 / z48;
    const Scalar z56 = c_beta_2 * z49;
    const Scalar z57 = n1 / z50;
    const Scalar z58 = z7 * z53;
    const Scalar z59 = z38 * z53;
    const Scalar z60 = z9 * z54;
    const Scalar z61 = z42 * z54;
    const Scalar z62 = n800000 - n400000 * z55;
    const Scalar z63 = n0_1 * z39 + z56;
    const Scalar z64 = n800000 - n400000 * z57;
    const Scalar z65 = z7 * z62;
    const Scalar z66 = k12 + z63;
    const Scalar z67 = z38 * z62;
    const Scalar z68 = k5 * c_beta_1;
    const Scalar z69 = n5_15 * c_beta_1;
    const Scalar z70 = c_beta_1 * z68;
    const Scalar z71 = n10_2 * z32;  // moment on rod_2, z
    const Scalar z72 = n10_2 * z35;  // moment on rod_1, z
    const Scalar z73 = n2 * z32;
    const Scalar z74 = n5_15 * z73;  // force on rod_2, y
    const Scalar z75 = n0_1 * z69 + z70;
    const Scalar z76 = n2 * z35;
    const Scalar z77 = n5_15 * z76;  // force on rod_1, y
    const Scalar z78 = k5 * s_beta_1;
    const Scalar z79 = n5_15 * s_beta_1;
    const Scalar z80 = s_beta_2 * z44 - c_beta_2 * z71;
    const Scalar z81 = z66 + z75;
    const Scalar z82 = s_beta_1 * z45 - c_beta_1 * z72;
    const Scalar z83 = n0_05 * (z74 + z77) - z80 - z82;  // moment on shaft, z
    const Scalar z84 = a_psi * z81 - z83;
    const Scalar z85 = z9 * z64;
    const Scalar z86 = z42 * z64;
    const Scalar z87 = k6 * z4;
    const Scalar z88 = n2 * z2;
    const Scalar z89 = n5_15 * z88;
    const Scalar z90 = n2 * z1;
    const Scalar z91 = n5_15 * z90;
    const Scalar z92 = n10_2 * z2;
    const Scalar z93 = s_beta_2 * z87 - c_beta_2 * z92;
    const Scalar z94 = k6 * z3;
    const Scalar z95 = n10_2 * z1;
    const Scalar z96 = z67 - z59 + z86 - z61;
    const Scalar z97 = s_beta_1 * z94 - c_beta_1 * z95;
    const Scalar z98 = n0_5 * (z65 - z58);
    const Scalar z99 = n0_05 * (z89 + z91) - z93 - z97;
    const Scalar z100 = n0_5 * (z85 - z60);
    const Scalar z101 = n2 * (z7 * z1 + z23 * z3 + s_beta_1 * z27 + c_beta_1 * z26);
    const Scalar z102 = n2 * (z9 * z2 + z28 * z4 + s_beta_2 * z31 + c_beta_2 * z30);
    const Scalar z103 = n0_5 * z101;
    const Scalar z104 = n0_5 * z102;
    const Scalar z105 = n2 * (s_beta_1 * z23 - c_beta_1 * z7);
    const Scalar z106 = z100 - n5_15 * z21 - k5 * z33;  // moment on rod_2, y
    const Scalar z107 = z98 - n5_15 * z20 - k5 * z36;  // moment on rod_1, y
    const Scalar z108 = n40000 * (z51 * z105 / (z40 * z40) + z103 / z40);
    const Scalar z109 = n0_5 * z105;
    const Scalar z110 = n29_43 + z96;  // force on slider, z
    const Scalar z111 = n3 * a_s + z110;
    const Scalar z112 = k16 * a_beta_1 - z107;
    const Scalar z113 = k16 * a_beta_2 - z106;
    const Scalar z114 = s_beta_1 * z68 + c_beta_1 * z78;
    const Scalar z115 = n0_1 * z79 + z114;
    const Scalar z116 = k6 * z35;
    const Scalar z117 = z7 * n2 * (z6 + z23);
    const Scalar z118 = n2 * (s_beta_2 * z28 - c_beta_2 * z9);
    const Scalar z119 = n40000 * (z52 * z118 / (z43 * z43) + z104 / z43);
    const Scalar z120 = n0_5 * z118;
    const Scalar z121 = z109 / z48;
    const Scalar z122 = z121 / (z48 * z48);
    const Scalar z123 = n40000 * z109 / z40;
    const Scalar z124 = z120 / z50;
    const Scalar z125 = n40000 * z120 / z43;
    const Scalar z126 = n10_2 * z37;
    const Scalar z127 = s_beta_1 * (z72 - z116) + c_beta_1 * (z45 - z126);
    const Scalar z128 = n2 * z37;
    const Scalar z129 = n5_15 * z128;
    const Scalar z130 = n2 * v_psi;
    const Scalar z131 = n0_05 * z130;
    const Scalar z132 = n0_5 * z117;
    const Scalar z133 = k6 * z12;
    const Scalar z134 = z38 * z108 - z53;
    const Scalar z135 = c_beta_1 * z53 + z7 * z108;
    const Scalar z136 = n0_05 * z129 - z127;
    const Scalar z137 = z124 / (z50 * z50);
    const Scalar z138 = n400000 * z122;
    const Scalar z139 = n10_2 * z5;
    const Scalar z140 = s_beta_1 * z133 - c_beta_1 * z139;
    const Scalar z141 = a_psi * z115 + z136;
    const Scalar z142 = s_beta_1 * z131;
    const Scalar z143 = s_beta_2 * z131;
    const Scalar z144 = z42 * z119 - z54;
    const Scalar z145 = c_beta_2 * z54 + z9 * z119;
    const Scalar z146 = n2 * z5;
    const Scalar z147 = n5_15 * z146;
    const Scalar z148 = z38 * z138 + z62;
    const Scalar z149 = c_beta_1 * z62 - z7 * z138;
    const Scalar z150 = n0_5 * (z149 - z135);
    const Scalar z151 = n0_05 * z147 - z140;
    const Scalar z152 = n400000 * z137;
    const Scalar z153 = n40000 * z132 / z40;
    const Scalar z154 = s_beta_1 * z12 + c_beta_1 * z5;
    const Scalar z155 = n5_15 * z142 + k5 * z154;
    const Scalar z156 = z132 / z48;
    const Scalar z157 = z156 / (z48 * z48);
    const Scalar z158 = c_beta_2 * z64 - z9 * z152;
    const Scalar z159 = n0_5 * (z158 - z145);
    const Scalar z160 = z42 * z152 + z64;
    const Scalar z161 = z134 + z144 + z148 + z160;
    const Scalar z162 = s_beta_2 * z13 + c_beta_2 * z10;
    const Scalar z163 = n5_15 * z143 + k5 * z162;
    const Scalar z164 = z26 * n2 * (z6 + z23);
    const Scalar z165 = n0_5 * z164;
    const Scalar z166 = z38 * z123;
    const Scalar z167 = z7 * z123;
    const Scalar z168 = n0_5 * z167;
    const Scalar z169 = z42 * z125;
    const Scalar z170 = z166 + z169;
    const Scalar z171 = n40000 * (z51 * z117 / (z40 * z40) - z165 / z40);
    const Scalar z172 = s_beta_2 * z49 + c_beta_2 * z41;
    const Scalar z173 = z5 * z5 - z12 * z12;
    const Scalar z174 = n0_1 * z25 + z172;
    const Scalar z175 = n400000 * z157;
    const Scalar z176 = k6 * z32;
    const Scalar z177 = z9 * z125;
    const Scalar z178 = n0_5 * z177;
    const Scalar z179 = k17 * z155;
    const Scalar z180 = k17 * z163;
    const Scalar z181 = n1_over_3 * z161;
    const Scalar z182 = k17 * z150;
    const Scalar z183 = k17 * z159;
    const Scalar z184 = n1_over_3 * z170;
    const Scalar z185 = z30 * n2 * (z8 + z28);
    const Scalar z186 = z9 * n2 * (z8 + z28);
    const Scalar z187 = n0_5 * z185;
    const Scalar z188 = n1 / z81;
    const Scalar z189 = z99 * z188;
    const Scalar z190 = n40000 * (z52 * z186 / (z43 * z43) - z187 / z43);
    const Scalar z191 = n0_5 * z186;
    const Scalar z192 = n40000 * z191 / z43;
    const Scalar z193 = z191 / z50;
    const Scalar z194 = n10_2 * z34;
    const Scalar z195 = s_beta_2 * (z71 - z176) + c_beta_2 * (z44 - z194);
    const Scalar z196 = n2 * z34;
    const Scalar z197 = n5_15 * z196;
    const Scalar z198 = z6 * z62 + z7 * z175;
    const Scalar z199 = z17 * z62 - z38 * z175;
    const Scalar z200 = z6 * z53 - z7 * z171;
    const Scalar z201 = z17 * z53 + z38 * z171;
    const Scalar z202 = n0_5 * (z198 - z200);
    const Scalar z203 = n0_05 * z197 - z195;
    const Scalar z204 = z193 / (z50 * z50);
    const Scalar z205 = z199 - z201;
    const Scalar z206 = a_psi * z174 + z203;
    const Scalar z207 = n5_15 * z19 + z202 - k5 * z173;
    const Scalar z208 = z7 * z153;
    const Scalar z209 = z38 * z153;
    const Scalar z210 = k17 * z168;
    const Scalar z211 = k17 * z178;
    const Scalar z212 = z141 * z188;
    const Scalar z213 = z8 * z54 - z9 * z190;
    const Scalar z214 = z18 * z54 + z42 * z190;
    const Scalar z215 = k6 * z13;
    const Scalar z216 = n1_over_3 * z205;
    const Scalar z217 = n10_2 * z10;
    const Scalar z218 = s_beta_2 * z215 - c_beta_2 * z217;
    const Scalar z219 = n400000 * z204;
    const Scalar z220 = n2 * z10;
    const Scalar z221 = z10 * z10 - z13 * z13;
    const Scalar z222 = z8 * z64 + z9 * z219;
    const Scalar z223 = n5_15 * z220;
    const Scalar z224 = z18 * z64 - z42 * z219;
    const Scalar z225 = z9 * z192;
    const Scalar z226 = n0_5 * (z222 - z213);
    const Scalar z227 = n0_5 * z208;
    const Scalar z228 = n0_05 * z223 - z218;
    const Scalar z229 = z42 * z192;
    const Scalar z230 = z224 - z214;
    const Scalar z231 = n0_5 * z225;
    const Scalar z232 = k17 * z207;
    const Scalar z233 = z151 * z188;
    const Scalar z234 = n1_over_3 * z209;
    const Scalar z235 = k17 * z227;
    const Scalar z236 = n5_15 * z22 + z226 - k5 * z221;
    const Scalar z237 = z206 * z188;
    const Scalar z238 = n1_over_3 * z230;
    const Scalar z239 = z228 * z188;
    const Scalar z240 = n1_over_3 * z229;
    const Scalar z241 = k17 * z231;
    const Scalar z242 = k17 * z236;
    result.M[0] = z81;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n3;
    result.M[6] = n0;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = k16;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n0;
    result.M[15] = k16;
    result.C[0] = -z99;
    result.C[1] = n0;
    result.C[2] = z155;
    result.C[3] = z163;
    result.C[4] = n0;
    result.C[5] = z170;
    result.C[6] = -z168;
    result.C[7] = -z178;
    result.C[8] = -z151;
    result.C[9] = -z209;
    result.C[10] = z227;
    result.C[11] = n0;
    result.C[12] = -z228;
    result.C[13] = -z229;
    result.C[14] = n0;
    result.C[15] = z231;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = z161;
    result.K[6] = z150;
    result.K[7] = z159;
    result.K[8] = -z141;
    result.K[9] = z205;
    result.K[10] = z207;
    result.K[11] = n0;
    result.K[12] = -z206;
    result.K[13] = z230;
    result.K[14] = n0;
    result.K[15] = z236;
    result.F[0] = -z84;
    result.F[1] = -z111;
    result.F[2] = -z112;
    result.F[3] = -z113;
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
    result.A[13] = -z181;
    result.A[14] = -z182;
    result.A[15] = -z183;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = n0;
    result.A[20] = z212;
    result.A[21] = -z216;
    result.A[22] = -z232;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = n0;
    result.A[28] = z237;
    result.A[29] = -z238;
    result.A[30] = n0;
    result.A[31] = -z242;
    result.A[32] = n1;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = z189;
    result.A[37] = n0;
    result.A[38] = -z179;
    result.A[39] = -z180;
    result.A[40] = n0;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = -z184;
    result.A[46] = z210;
    result.A[47] = z211;
    result.A[48] = n0;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = n0;
    result.A[52] = z233;
    result.A[53] = z234;
    result.A[54] = -z235;
    result.A[55] = n0;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n1;
    result.A[60] = z239;
    result.A[61] = z240;
    result.A[62] = n0;
    result.A[63] = -z241;
    if (!(traits::regular(z81, z81))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.M[0] * result.C[0] * result.C[2] * result.C[3] * result.C[5] * result.C[6]
        * result.C[7] * result.C[8] * result.C[9] * result.C[10] * result.C[12]) * (n0 * result.C[13] * result.C[15]
        * result.K[5] * result.K[6] * result.K[7] * result.K[8] * result.K[9] * result.K[10] * result.K[12]
        * result.K[13] * result.K[15] * result.F[0])) * ((n0 * result.F[1] * result.F[2] * result.F[3] * result.A[13]
        * result.A[14] * result.A[15] * result.A[20] * result.A[21] * result.A[22] * result.A[28] * result.A[29]
        * result.A[31]) * (n0 * result.A[36] * result.A[38] * result.A[39] * result.A[45] * result.A[46] * result.A[47]
        * result.A[52] * result.A[53] * result.A[54] * result.A[60] * result.A[61] * result.A[63]));
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, Multipliers(), Inputs(), result);
  }

  /// Residual of the equations of motion, zero along motions:
  /// r = M a + h - E u.
  TORSOR_DEVICE static void residual(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers&, const Inputs&, std::array<Scalar, 4>& residual) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k5 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar k6 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k9 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar n10_2 = traits::constant(10.2, 10.2f, "51/5");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k16 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar a_s = accelerations.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar a_beta_1 = accelerations.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar a_beta_2 = accelerations.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z0 = n1 - q_s;
    const Scalar z1 = v_beta_1 * s_beta_1;
    const Scalar z2 = v_beta_2 * s_beta_2;
    const Scalar z3 = v_beta_1 * c_beta_1;
    const Scalar z4 = v_beta_2 * c_beta_2;
    const Scalar z5 = n0_5 * s_beta_1;
    const Scalar z6 = s_beta_1 * z0;
    const Scalar z7 = c_beta_1 * z0;
    const Scalar z8 = s_beta_2 * z0;
    const Scalar z9 = c_beta_2 * z0;
    const Scalar z10 = v_psi * c_beta_2;
    const Scalar z11 = v_psi * s_beta_1;
    const Scalar z12 = v_psi * s_beta_2;
    const Scalar z13 = n0_5 * s_beta_2;
    const Scalar z14 = v_psi * v_psi;
    const Scalar z15 = v_psi * c_beta_1;
    const Scalar z16 = n0_05 * z14;
    const Scalar z17 = n5_15 * c_beta_2;
    const Scalar z18 = s_beta_1 * z16 - n9_81 * c_beta_1;
    const Scalar z19 = s_beta_2 * z16 - n9_81 * c_beta_2;
    const Scalar z20 = n0_5 - z6;
    const Scalar z21 = k5 * c_beta_2;
    const Scalar z22 = n1 - z5;
    const Scalar z23 = v_s * c_beta_1 + z0 * z1;
    const Scalar z24 = v_s * s_beta_1 - z0 * z3;
    const Scalar z25 = n0_5 - z8;
    const Scalar z26 = n1 - z13;
    const Scalar z27 = v_s * c_beta_2 + z0 * z2;
    const Scalar z28 = v_s * s_beta_2 - z0 * z4;
    const Scalar z29 = v_beta_2 * z12;
    const Scalar z30 = z12 * z10;
    const Scalar z31 = v_beta_2 * z10;
    const Scalar z32 = v_beta_1 * z11;
    const Scalar z33 = z11 * z15;
    const Scalar z34 = v_beta_1 * z15;
    const Scalar z35 = c_beta_2 * z21;
    const Scalar z36 = q_s - z22;
    const Scalar z37 = z7 * z7 + z20 * z20;
    const Scalar z38 = n5_15 * c_beta_1;
    const Scalar z39 = q_s - z26;
    const Scalar z40 = z9 * z9 + z25 * z25;
    const Scalar z41 = k6 * z31;  // moment on rod_2, x
    const Scalar z42 = k6 * z34;  // moment on rod_1, x
    const Scalar z43 = n0_1 * z17 + z35;
    const Scalar z44 = n2 * (z7 * z23 - z20 * z24);
    const Scalar z45 = n2 * (z9 * z27 - z25 * z28);
    const Scalar z46 = traits::sqrt(z37);
    const Scalar z47 = k5 * c_beta_1;
    const Scalar z48 = traits::sqrt(z40);
    const Scalar z49 = k9 + z43;
    const Scalar z50 = n0_5 * z44;
    const Scalar z51 = n0_5 * z45;
    const Scalar z52 = n40000 * z50 / z37;
    const Scalar z53 = n40000 * z51 / z40;
    const Scalar z54 = n1 / z46;
    const Scalar z55 = c_beta_1 * z47;
    const Scalar z56 = n1 / z48;
    const Scalar z57 = z7 * z52;
    const Scalar z58 = z36 * z52;
    const Scalar z59 = z9 * z53;
    const Scalar z60 = z39 * z53;
    const Scalar z61 = n800000 - n400000 * z54;
    const Scalar z62 = n0_1 * z38 + z55;
    const Scalar z63 = n800000 - n400000 * z56;
    const Scalar z64 = z7 * z61;
    const Scalar z65 = z49 + z62;
    const Scalar z66 = z36 * z61;
    const Scalar z67 = n2 * z29;
    const Scalar z68 = n2 * z32;
    const Scalar z69 = n10_2 * z29;  // moment on rod_2, z
    const Scalar z70 = s_beta_2 * z41 - c_beta_2 * z69;
    const Scalar z71 = n5_15 * z67;  // force on rod_2, y
    const Scalar z72 = n5_15 * z68;  // force on rod_1, y
    const Scalar z73 = n10_2 * z32;  // moment on rod_1, z
    const Scalar z74 = s_beta_1 * z42 - c_beta_1 * z73;
    const Scalar z75 = n0_05 * (z71 + z72) - z70 - z74;  // moment on shaft, z
    const Scalar z76 = a_psi * z65 - z75;
    const Scalar z77 = z9 * z63;
    const Scalar z78 = z39 * z63;
    const Scalar z79 = z66 - z58 + z78 - z60;
    const Scalar z80 = n0_5 * (z64 - z57);
    const Scalar z81 = n0_5 * (z77 - z59);
    const Scalar z82 = z81 - n5_15 * z19 - k5 * z30;  // moment on rod_2, y
    const Scalar z83 = z80 - n5_15 * z18 - k5 * z33;  // moment on rod_1, y
    const Scalar z84 = n29_43 + z79;  // force on slider, z
    const Scalar z85 = n3 * a_s + z84;
    const Scalar z86 = k16 * a_beta_1 - z83;
    const Scalar z87 = k16 * a_beta_2 - z82;
    residual[0] = z76;
    residual[1] = z85;
    residual[2] = z86;
    residual[3] = z87;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void residual(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, std::array<Scalar, 4>& residual) noexcept {
    Mechanism::residual(precomputed, state, accelerations, Multipliers(), Inputs(), residual);
  }

  /// Derivatives of residual by (q, v, a, lambda) without those that vanish identically: `values` of
  /// compressed rows. r = M a + h - E u.
  TORSOR_DEVICE static void residual_jacobian(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, const Inputs&, ResidualJacobian& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k2 = traits::constant(5.0999975, 5.0999975f, "2039999/400000");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n5_15 = traits::constant(5.15, 5.15f, "103/20");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k7 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n10_2 = traits::constant(10.2, 10.2f, "51/5");
    const Scalar k10 = traits::constant(0.031515, 0.031515f, "6303/200000");
    const Scalar n40000 = traits::constant(40000.0, 40000.0f, "40000/1");
    const Scalar n800000 = traits::constant(8e+05, 8e+05f, "800000/1");
    const Scalar n400000 = traits::constant(4e+05, 4e+05f, "400000/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar k15 = traits::constant(5.1000025, 5.1000023f, "2040001/400000");
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_s = state.q.s;
    const Scalar v_s = state.v.s;
    const Scalar q_beta_1 = state.q.beta_1;
    const Scalar v_beta_1 = state.v.beta_1;
    const Scalar q_beta_2 = state.q.beta_2;
    const Scalar v_beta_2 = state.v.beta_2;
    const Scalar angles_[] = {q_beta_1, q_beta_2};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta_1 = sines_[0], c_beta_1 = cosines_[0];
    const Scalar s_beta_2 = sines_[1], c_beta_2 = cosines_[1];
    const Scalar z0 = n1 - q_s;
    const Scalar z1 = v_beta_1 * s_beta_1;
    const Scalar z2 = v_beta_2 * s_beta_2;
    const Scalar z3 = v_beta_1 * c_beta_1;
    const Scalar z4 = v_beta_2 * c_beta_2;
    const Scalar z5 = v_psi * s_beta_1;
    const Scalar z6 = s_beta_1 * z0;
    const Scalar z7 = c_beta_1 * z0;
    const Scalar z8 = s_beta_2 * z0;
    const Scalar z9 = c_beta_2 * z0;
    const Scalar z10 = v_psi * s_beta_2;
    const Scalar z11 = v_psi * c_beta_1;
    const Scalar z12 = v_psi * c_beta_2;
    const Scalar z13 = n0_5 * s_beta_1;
    const Scalar z14 = n0_5 * s_beta_2;
    const Scalar z15 = v_psi * v_psi;
    const Scalar z16 = k2 * c_beta_2;
    const Scalar z17 = k2 * c_beta_1;
    const Scalar z18 = n0_05 * z15;
    const Scalar z19 = k2 * s_beta_2;
    const Scalar z20 = k2 * s_beta_1;
    const Scalar z21 = n0_5 * c_beta_1;
    const Scalar z22 = n0_5 * c_beta_2;
    const Scalar z23 = n5_15 * c_beta_2;
    const Scalar z24 = n9_81 * s_beta_1 + c_beta_1 * z18;
    const Scalar z25 = n9_81 * s_beta_2 + c_beta_2 * z18;
    const Scalar z26 = n5_15 * s_beta_2;
    const Scalar z27 = n5_15 * s_beta_1;
    const Scalar z28 = n5_15 * c_beta_1;
    const Scalar z29 = n0_5 - z6;
    const Scalar z30 = n1 - z13;
    const Scalar z31 = v_s * c_beta_1 + z0 * z1;
    const Scalar z32 = v_s * s_beta_1 - z0 * z3;
    const Scalar z33 = n0_5 - z8;
    const Scalar z34 = n1 - z14;
    const Scalar z35 = v_s * c_beta_2 + z0 * z2;
    const Scalar z36 = v_s * s_beta_2 - z0 * z4;
    const Scalar z37 = v_beta_2 * z10;
    const Scalar z38 = v_beta_2 * z12;
    const Scalar z39 = v_beta_1 * z5;
    const Scalar z40 = v_beta_1 * z11;
    const Scalar z41 = c_beta_2 * z16;
    const Scalar z42 = c_beta_1 * z17;
    const Scalar z43 = q_s - z30;
    const Scalar z44 = n2 * z2;
    const Scalar z45 = z7 * z7 + z29 * z29;
    const Scalar z46 = q_s - z34;
    const Scalar z47 = z9 * z9 + z33 * z33;
    const Scalar z48 = k7 * z38;  // moment on rod_2, x
    const Scalar z49 = k7 * z40;  // moment on rod_1, x
    const Scalar z50 = n0_1 * z23 + z41;
    const Scalar z51 = n0_1 * z28 + z42;
    const Scalar z52 = n10_2 * z37;  // moment on rod_2, z
    const Scalar z53 = n10_2 * z39;  // moment on rod_1, z
    const Scalar z54 = n5_15 * z44;
    const Scalar z55 = n2 * (z7 * z31 - z29 * z32);
    const Scalar z56 = n2 * (z9 * z35 - z33 * z36);
    const Scalar z57 = traits::sqrt(z45);
    const Scalar z58 = k7 * z4;
    const Scalar z59 = traits::sqrt(z47);
    const Scalar z60 = k10 + z50;
    const Scalar z61 = z60 + z51;
    const Scalar z62 = n0_5 * z55;
    const Scalar z63 = n0_5 * z56;
    const Scalar z64 = n40000 * z62 / z45;
    const Scalar z65 = n40000 * z63 / z47;
    const Scalar z66 = n1 / z57;
    const Scalar z67 = n10_2 * z2;
    const Scalar z68 = n1 / z59;
    const Scalar z69 = n800000 - n400000 * z66;
    const Scalar z70 = s_beta_2 * z58 - c_beta_2 * z67;
    const Scalar z71 = n2 * (s_beta_1 * z29 - c_beta_1 * z7);
    const Scalar z72 = n2 * z1;
    const Scalar z73 = n5_15 * z72;
    const Scalar z74 = n0_5 * z71;
    const Scalar z75 = n2 * v_psi;
    const Scalar z76 = n0_05 * z75;
    const Scalar z77 = k7 * z3;
    const Scalar z78 = n10_2 * z1;
    const Scalar z79 = s_beta_1 * z77 - c_beta_1 * z78;
    const Scalar z80 = s_beta_1 * z76;
    const Scalar z81 = s_beta_2 * z76;
    const Scalar z82 = n40000 * z74 / z45;
    const Scalar z83 = s_beta_1 * z11 + c_beta_1 * z5;
    const Scalar z84 = n5_15 * z80 + k2 * z83;
    const Scalar z85 = n0_05 * (z54 + z73) - z70 - z79;
    const Scalar z86 = s_beta_2 * z12 + c_beta_2 * z10;
    const Scalar z87 = n5_15 * z81 + k2 * z86;
    const Scalar z88 = n800000 - n400000 * z68;
    const Scalar z89 = n2 * (z7 * z1 + z29 * z3 + s_beta_1 * z32 + c_beta_1 * z31);
    const Scalar z90 = n2 * (z9 * z2 + z33 * z4 + s_beta_2 * z36 + c_beta_2 * z35);
    const Scalar z91 = s_beta_1 * z17 + c_beta_1 * z20;
    const Scalar z92 = n0_1 * z27 + z91;
    const Scalar z93 = z31 * n2 * (z6 + z29);
    const Scalar z94 = z7 * n2 * (z6 + z29);
    const Scalar z95 = n0_5 * z93;
    const Scalar z96 = n0_5 * z89;
    const Scalar z97 = n40000 * (z62 * z71 / (z45 * z45) + z96 / z45);
    const Scalar z98 = n40000 * (z62 * z94 / (z45 * z45) - z95 / z45);
    const Scalar z99 = n0_5 * z94;
    const Scalar z100 = n0_5 * z90;
    const Scalar z101 = z74 / z57;
    const Scalar z102 = k7 * z39;
    const Scalar z103 = z101 / (z57 * z57);
    const Scalar z104 = n40000 * z99 / z45;
    const Scalar z105 = z99 / z57;
    const Scalar z106 = n2 * (s_beta_2 * z33 - c_beta_2 * z9);
    const Scalar z107 = n40000 * (z63 * z106 / (z47 * z47) + z100 / z47);
    const Scalar z108 = n0_5 * z106;
    const Scalar z109 = z108 / z59;
    const Scalar z110 = n40000 * z108 / z47;
    const Scalar z111 = n10_2 * z40;
    const Scalar z112 = s_beta_1 * (z53 - z102) + c_beta_1 * (z49 - z111);
    const Scalar z113 = z105 / (z57 * z57);
    const Scalar z114 = n2 * z40;
    const Scalar z115 = n400000 * z103;
    const Scalar z116 = n5_15 * z114;
    const Scalar z117 = z43 * z104;
    const Scalar z118 = k7 * z11;
    const Scalar z119 = z43 * z97 - z64;
    const Scalar z120 = n0_05 * z116 - z112;
    const Scalar z121 = c_beta_1 * z64 + z7 * z97;
    const Scalar z122 = n10_2 * z5;
    const Scalar z123 = s_beta_1 * z118 - c_beta_1 * z122;
    const Scalar z124 = a_psi * z92 + z120;
    const Scalar z125 = z109 / (z59 * z59);
    const Scalar z126 = n2 * z5;
    const Scalar z127 = n5_15 * z126;
    const Scalar z128 = n400000 * z113;
    const Scalar z129 = z43 * z115 + z69;
    const Scalar z130 = c_beta_1 * z69 - z7 * z115;
    const Scalar z131 = n0_5 * (z130 - z121);
    const Scalar z132 = n0_05 * z127 - z123;
    const Scalar z133 = z46 * z107 - z65;
    const Scalar z134 = c_beta_2 * z65 + z9 * z107;
    const Scalar z135 = z43 * z82;
    const Scalar z136 = z7 * z82;
    const Scalar z137 = n0_5 * z136;
    const Scalar z138 = z7 * z104;
    const Scalar z139 = n0_5 * z138;
    const Scalar z140 = n400000 * z125;
    const Scalar z141 = z6 * z69 + z7 * z128;
    const Scalar z142 = z21 * z69 - z43 * z128;
    const Scalar z143 = z21 * z64 + z43 * z98;
    const Scalar z144 = z142 - z143;
    const Scalar z145 = c_beta_2 * z88 - z9 * z140;
    const Scalar z146 = n0_5 * (z145 - z134);
    const Scalar z147 = z46 * z140 + z88;
    const Scalar z148 = z119 + z133 + z129 + z147;
    const Scalar z149 = z46 * z110;
    const Scalar z150 = z6 * z64 - z7 * z98;
    const Scalar z151 = z135 + z149;
    const Scalar z152 = n0_5 * (z141 - z150);
    const Scalar z153 = s_beta_2 * z16 + c_beta_2 * z19;
    const Scalar z154 = z5 * z5 - z11 * z11;
    const Scalar z155 = n0_1 * z26 + z153;
    const Scalar z156 = k7 * z37;
    const Scalar z157 = n5_15 * z24 + z152 - k2 * z154;
    const Scalar z158 = z9 * z110;
    const Scalar z159 = n0_5 * z158;
    const Scalar z160 = z9 * n2 * (z8 + z33);
    const Scalar z161 = z35 * n2 * (z8 + z33);
    const Scalar z162 = n0_5 * z160;
    const Scalar z163 = n0_5 * z161;
    const Scalar z164 = n10_2 * z38;
    const Scalar z165 = s_beta_2 * (z52 - z156) + c_beta_2 * (z48 - z164);
    const Scalar z166 = z162 / z59;
    const Scalar z167 = n40000 * (z63 * z160 / (z47 * z47) - z163 / z47);
    const Scalar z168 = k7 * z12;
    const Scalar z169 = n2 * z38;
    const Scalar z170 = n10_2 * z10;
    const Scalar z171 = n5_15 * z169;
    const Scalar z172 = n2 * z10;
    const Scalar z173 = n40000 * z162 / z47;
    const Scalar z174 = n5_15 * z172;
    const Scalar z175 = s_beta_2 * z168 - c_beta_2 * z170;
    const Scalar z176 = n0_05 * z171 - z165;
    const Scalar z177 = z10 * z10 - z12 * z12;
    const Scalar z178 = z166 / (z59 * z59);
    const Scalar z179 = n0_05 * z174 - z175;
    const Scalar z180 = z9 * z173;
    const Scalar z181 = a_psi * z155 + z176;
    const Scalar z182 = z46 * z173;
    const Scalar z183 = n0_5 * z180;
    const Scalar z184 = z22 * z65 + z46 * z167;
    const Scalar z185 = z8 * z65 - z9 * z167;
    const Scalar z186 = n400000 * z178;
    const Scalar z187 = z22 * z88 - z46 * z186;
    const Scalar z188 = z8 * z88 + z9 * z186;
    const Scalar z189 = z187 - z184;
    const Scalar z190 = n0_5 * (z188 - z185);
    const Scalar z191 = n5_15 * z25 + z190 - k2 * z177;
    result.values[0] = -z124;
    result.values[1] = -z181;
    result.values[2] = -z85;
    result.values[3] = -z132;
    result.values[4] = -z179;
    result.values[5] = z61;
    result.values[6] = z148;
    result.values[7] = z144;
    result.values[8] = z189;
    result.values[9] = z151;
    result.values[10] = -z117;
    result.values[11] = -z182;
    result.values[12] = n3;
    result.values[13] = z131;
    result.values[14] = z157;
    result.values[15] = z84;
    result.values[16] = -z137;
    result.values[17] = z139;
    result.values[18] = k15;
    result.values[19] = z146;
    result.values[20] = z191;
    result.values[21] = z87;
    result.values[22] = -z159;
    result.values[23] = z183;
    result.values[24] = k15;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void residual_jacobian(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, ResidualJacobian& result) noexcept {
    Mechanism::residual_jacobian(precomputed, state, accelerations, Multipliers(), Inputs(), result);
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
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
    visitor(Description::kernels[8],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, std::array<Scalar, 4>&>(residual));
    visitor(Description::kernels[9],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, ResidualJacobian&>(residual_jacobian));
  }
};

}  // namespace flyball_governor
