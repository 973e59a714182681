// SPDX-License-Identifier: MIT-0
// andrews_squeezer: Andrews' squeezing mechanism: seven bodies, three loops
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, constraints, linearisation, residual, residual_jacobian
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function           additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   kinematics                64               95          0             0                  7       0    173     173
//   mass_matrix                9                7          0             0                  3       0     22      22
//   bias                      20               35          1             1                  4       0     65      65
//   inverse_dynamics          73               92          1             1                  7       0    181     195
//   forward_dynamics         241              345         12             1                  7       0    613     642
//   energy                    29               50          0             1                  4       0     88      94
//   constraints               87              136          0             0                  7       0    237     249
//   linearisation            540              710         20             1                  7       0   1285    1425
//   residual                 131              198          1             1                  7       0    345     365
//   residual_jacobian        216              344          3             1                  7       0    578     662
//
// Not computed because this mechanism does not need it:
//   kinematics: of 315 results 201 vanish identically, 18 repeat another up to sign
//   mass_matrix: of 49 results 36 vanish identically, 3 repeat another up to sign
//   first_integrals: left out, 'motor' has a force function that is not stated
//   constraints: of 60 results 20 vanish identically, 8 repeat another up to sign
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 162 results 113 vanish identically, 3 repeat another up to sign
//   residual_jacobian: of 123 results 49 repeat another up to sign
//
// To write this file again:
//   andrews_squeezer_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,residual,residual_jacobian --support torsor_support.hpp --output andrews_squeezer.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace andrews_squeezer {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 7> coordinates{{{"beta", "rad"}, {"Theta", "rad"}, {"gamma",
      "rad"}, {"Phi", "rad"}, {"delta", "rad"}, {"Omega", "rad"}, {"epsilon", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 7> velocities{{{"beta", "rad/s"}, {"Theta", "rad/s"},
      {"gamma", "rad/s"}, {"Phi", "rad/s"}, {"delta", "rad/s"}, {"Omega", "rad/s"}, {"epsilon", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 6> multipliers{{{"lambda_E3_x", "N"}, {"lambda_E3_y", "N"},
      {"lambda_E4_x", "N"}, {"lambda_E4_y", "N"}, {"lambda_E6_x", "N"}, {"lambda_E6_y", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 72> results{{{"result", "S1_position", 3, 1, 1, "m"},
      {"result", "S1_rotation", 3, 3, 2, "1"}, {"result", "S1_velocity", 3, 1, 1, "m/s"}, {"result",
      "S1_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S2_position", 3, 1, 1, "m"}, {"result", "S2_rotation", 3, 3,
      2, "1"}, {"result", "S2_velocity", 3, 1, 1, "m/s"}, {"result", "S2_angular_velocity", 3, 1, 1, "rad/s"},
      {"result", "S3_position", 3, 1, 1, "m"}, {"result", "S3_rotation", 3, 3, 2, "1"}, {"result", "S3_velocity", 3, 1,
      1, "m/s"}, {"result", "S3_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S4_position", 3, 1, 1, "m"},
      {"result", "S4_rotation", 3, 3, 2, "1"}, {"result", "S4_velocity", 3, 1, 1, "m/s"}, {"result",
      "S4_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S5_position", 3, 1, 1, "m"}, {"result", "S5_rotation", 3, 3,
      2, "1"}, {"result", "S5_velocity", 3, 1, 1, "m/s"}, {"result", "S5_angular_velocity", 3, 1, 1, "rad/s"},
      {"result", "S6_position", 3, 1, 1, "m"}, {"result", "S6_rotation", 3, 3, 2, "1"}, {"result", "S6_velocity", 3, 1,
      1, "m/s"}, {"result", "S6_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "S7_position", 3, 1, 1, "m"},
      {"result", "S7_rotation", 3, 3, 2, "1"}, {"result", "S7_velocity", 3, 1, 1, "m/s"}, {"result",
      "S7_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "C_position", 3, 1, 1, "m"}, {"result", "C_velocity", 3, 1,
      1, "m/s"}, {"result", "C_jacobian", 3, 7, 2, ""}, {"result", "D_position", 3, 1, 1, "m"}, {"result", "D_velocity",
      3, 1, 1, "m/s"}, {"result", "D_jacobian", 3, 7, 2, "m"}, {"result", "E2_position", 3, 1, 1, "m"}, {"result",
      "E2_velocity", 3, 1, 1, "m/s"}, {"result", "E2_jacobian", 3, 7, 2, "m"}, {"result", "E3_position", 3, 1, 1, "m"},
      {"result", "E3_velocity", 3, 1, 1, "m/s"}, {"result", "E3_jacobian", 3, 7, 2, "m"}, {"result", "E4_position", 3,
      1, 1, "m"}, {"result", "E4_velocity", 3, 1, 1, "m/s"}, {"result", "E4_jacobian", 3, 7, 2, "m"}, {"result",
      "E6_position", 3, 1, 1, "m"}, {"result", "E6_velocity", 3, 1, 1, "m/s"}, {"result", "E6_jacobian", 3, 7, 2, "m"},
      {"result", "F_position", 3, 1, 1, "m"}, {"result", "F_velocity", 3, 1, 1, "m/s"}, {"result", "F_jacobian", 3, 7,
      2, "m"}, {"mass", "", 7, 7, 2, "kg m^2"}, {"forces", "", 7, 1, 1, "N m"}, {"forces", "", 7, 1, 1, "N m"},
      {"accelerations", "", 7, 1, 1, "rad/s^2"}, {"multipliers", "", 6, 1, 1, "N"}, {"result", "kinetic", 1, 1, 0, "J"},
      {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "value", 6, 1, 1, "m"},
      {"result", "rate", 6, 1, 1, "m/s"}, {"result", "jacobian", 6, 7, 2, "m"}, {"result", "gamma", 6, 1, 1, "m/s^2"},
      {"result", "M", 7, 7, 2, "kg m^2"}, {"result", "C", 7, 7, 2, "N m s"}, {"result", "K", 7, 7, 2, "N m"}, {"result",
      "F", 7, 1, 1, "N m"}, {"result", "M_r", 1, 1, 2, "kg m^2"}, {"result", "C_r", 1, 1, 2, "N m s"}, {"result", "K_r",
      1, 1, 2, "N m"}, {"result", "F_r", 1, 1, 1, "N m"}, {"result", "A", 2, 2, 2, ""}, {"residual", "", 13, 1, 1,
      "N m, N m, N m, N m, N m, N m, N m, m/s^2, m/s^2, m/s^2, m/s^2, m/s^2, m/s^2"}, {"result", "values", 123, 1, 1,
      "N m, N m, N m s, N m s, kg m^2, kg m^2, m, m, m, m, m, m, N m, N m, N m s, kg m^2, kg m^2, m, m, m, m, m, m, N m, kg m^2, m, m, N m, N m, N m s, kg m^2, kg m^2, m, m, N m, N m, N m s, N m s, kg m^2, kg m^2, m, m, N m, N m, N m s, kg m^2, kg m^2, m, m, N m, N m, N m s, N m s, kg m^2, kg m^2, m, m, m/s^2, m/s^2, m/s^2, m/s, m/s, m/s, m, m, m, m/s^2, m/s^2, m/s^2, m/s, m/s, m/s, m, m, m, m/s^2, m/s^2, m/s^2, m/s^2, m/s, m/s, m/s, m/s, m, m, m, m, m/s^2, m/s^2, m/s^2, m/s^2, m/s, m/s, m/s, m/s, m, m, m, m, m/s^2, m/s^2, m/s^2, m/s^2, m/s, m/s, m/s, m/s, m, m, m, m, m/s^2, m/s^2, m/s^2, m/s^2, m/s, m/s, m/s, m/s, m, m, m, m"}}};
  static constexpr std::array<torsor::KernelDescription, 10> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 49}, {"mass_matrix", false, false, false, false, results.data() + 49, 1}, {"bias", false,
      false, false, false, results.data() + 50, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 51,
      1}, {"forward_dynamics", false, false, true, true, results.data() + 52, 2}, {"energy", false, false, true, false,
      results.data() + 54, 3}, {"constraints", false, false, false, false, results.data() + 57, 4}, {"linearisation",
      true, true, true, true, results.data() + 61, 9}, {"residual", true, true, true, false, results.data() + 70, 1},
      {"residual_jacobian", true, true, true, false, results.data() + 71, 1}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::andrews_squeezer::Description;

  static constexpr const char* name = "andrews_squeezer";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xd8a0b03af433d79bULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 7;
  static constexpr int velocity_count = 7;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 6;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar beta;  ///< coordinate [rad]
    Scalar Theta;  ///< coordinate [rad]
    Scalar gamma;  ///< coordinate [rad]
    Scalar Phi;  ///< coordinate [rad]
    Scalar delta;  ///< coordinate [rad]
    Scalar Omega;  ///< coordinate [rad]
    Scalar epsilon;  ///< coordinate [rad]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::beta, &Coordinates::Theta, &Coordinates::gamma,
          &Coordinates::Phi, &Coordinates::delta, &Coordinates::Omega, &Coordinates::epsilon};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar beta;  ///< its rate [rad/s]
    Scalar Theta;  ///< its rate [rad/s]
    Scalar gamma;  ///< its rate [rad/s]
    Scalar Phi;  ///< its rate [rad/s]
    Scalar delta;  ///< its rate [rad/s]
    Scalar Omega;  ///< its rate [rad/s]
    Scalar epsilon;  ///< its rate [rad/s]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::beta, &Velocities::Theta, &Velocities::gamma,
          &Velocities::Phi, &Velocities::delta, &Velocities::Omega, &Velocities::epsilon};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar beta;  ///< its second rate [rad/s^2]
    Scalar Theta;  ///< its second rate [rad/s^2]
    Scalar gamma;  ///< its second rate [rad/s^2]
    Scalar Phi;  ///< its second rate [rad/s^2]
    Scalar delta;  ///< its second rate [rad/s^2]
    Scalar Omega;  ///< its second rate [rad/s^2]
    Scalar epsilon;  ///< its second rate [rad/s^2]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::beta, &Accelerations::Theta, &Accelerations::gamma,
          &Accelerations::Phi, &Accelerations::delta, &Accelerations::Omega, &Accelerations::epsilon};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar beta;  ///< works with the rate of beta [N m]
    Scalar Theta;  ///< works with the rate of Theta [N m]
    Scalar gamma;  ///< works with the rate of gamma [N m]
    Scalar Phi;  ///< works with the rate of Phi [N m]
    Scalar delta;  ///< works with the rate of delta [N m]
    Scalar Omega;  ///< works with the rate of Omega [N m]
    Scalar epsilon;  ///< works with the rate of epsilon [N m]
    static constexpr int size = 7;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::beta, &GeneralizedForces::Theta,
          &GeneralizedForces::gamma, &GeneralizedForces::Phi, &GeneralizedForces::delta, &GeneralizedForces::Omega,
          &GeneralizedForces::epsilon};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_E3_x;  ///< of the constraint E3_x [N]
    Scalar lambda_E3_y;  ///< of the constraint E3_y [N]
    Scalar lambda_E4_x;  ///< of the constraint E4_x [N]
    Scalar lambda_E4_y;  ///< of the constraint E4_y [N]
    Scalar lambda_E6_x;  ///< of the constraint E6_x [N]
    Scalar lambda_E6_y;  ///< of the constraint E6_y [N]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_E3_x, &Multipliers::lambda_E3_y,
          &Multipliers::lambda_E4_x, &Multipliers::lambda_E4_y, &Multipliers::lambda_E6_x, &Multipliers::lambda_E6_y};
      return members_[i_];
    }
  };

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
    const Scalar k1 = traits::constant(0.06171389001427645, 0.06171389f,
        "6171389001427644963589484580009627/100000000000000000000000000000000000");
    const Scalar k2 = traits::constant(0.45527981916307037, 0.45527983f,
        "4552798191630703802559123824490657/10000000000000000000000000000000000");
    const Scalar k3 = traits::constant(0.22266839016588588, 0.2226684f,
        "445336780331771769348946371218709/2000000000000000000000000000000000");
    const Scalar k4 = traits::constant(0.48736497954384256, 0.48736498f,
        "2436824897719212751127994767649241/5000000000000000000000000000000000");
    const Scalar k5 = traits::constant(0.22266839016588588, 0.2226684f,
        "2226683901658858846744731856093549/10000000000000000000000000000000000");
    const Scalar k6 = traits::constant(1.2305474445498212, 1.2305474f,
        "1230547444549821192497350155677741/1000000000000000000000000000000000");
    state.time = n0;
    state.q.beta = -k1;
    state.q.Theta = n0;
    state.q.gamma = k2;
    state.q.Phi = k3;
    state.q.delta = k4;
    state.q.Omega = -k5;
    state.q.epsilon = k6;
    state.v.beta = n0;
    state.v.Theta = n0;
    state.v.gamma = n0;
    state.v.Phi = n0;
    state.v.delta = n0;
    state.v.Omega = n0;
    state.v.epsilon = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> S1_position;  ///< centre of mass of S1 [m]
    std::array<Scalar, 9> S1_rotation;  ///< from the axes of S1 to the ground's (3 x 3)
    std::array<Scalar, 3> S1_velocity;  ///< velocity of the centre of mass of S1 [m/s]
    std::array<Scalar, 3> S1_angular_velocity;  ///< angular velocity of S1 [rad/s]
    std::array<Scalar, 3> S2_position;  ///< centre of mass of S2 [m]
    std::array<Scalar, 9> S2_rotation;  ///< from the axes of S2 to the ground's (3 x 3)
    std::array<Scalar, 3> S2_velocity;  ///< velocity of the centre of mass of S2 [m/s]
    std::array<Scalar, 3> S2_angular_velocity;  ///< angular velocity of S2 [rad/s]
    std::array<Scalar, 3> S3_position;  ///< centre of mass of S3 [m]
    std::array<Scalar, 9> S3_rotation;  ///< from the axes of S3 to the ground's (3 x 3)
    std::array<Scalar, 3> S3_velocity;  ///< velocity of the centre of mass of S3 [m/s]
    std::array<Scalar, 3> S3_angular_velocity;  ///< angular velocity of S3 [rad/s]
    std::array<Scalar, 3> S4_position;  ///< centre of mass of S4 [m]
    std::array<Scalar, 9> S4_rotation;  ///< from the axes of S4 to the ground's (3 x 3)
    std::array<Scalar, 3> S4_velocity;  ///< velocity of the centre of mass of S4 [m/s]
    std::array<Scalar, 3> S4_angular_velocity;  ///< angular velocity of S4 [rad/s]
    std::array<Scalar, 3> S5_position;  ///< centre of mass of S5 [m]
    std::array<Scalar, 9> S5_rotation;  ///< from the axes of S5 to the ground's (3 x 3)
    std::array<Scalar, 3> S5_velocity;  ///< velocity of the centre of mass of S5 [m/s]
    std::array<Scalar, 3> S5_angular_velocity;  ///< angular velocity of S5 [rad/s]
    std::array<Scalar, 3> S6_position;  ///< centre of mass of S6 [m]
    std::array<Scalar, 9> S6_rotation;  ///< from the axes of S6 to the ground's (3 x 3)
    std::array<Scalar, 3> S6_velocity;  ///< velocity of the centre of mass of S6 [m/s]
    std::array<Scalar, 3> S6_angular_velocity;  ///< angular velocity of S6 [rad/s]
    std::array<Scalar, 3> S7_position;  ///< centre of mass of S7 [m]
    std::array<Scalar, 9> S7_rotation;  ///< from the axes of S7 to the ground's (3 x 3)
    std::array<Scalar, 3> S7_velocity;  ///< velocity of the centre of mass of S7 [m/s]
    std::array<Scalar, 3> S7_angular_velocity;  ///< angular velocity of S7 [rad/s]
    std::array<Scalar, 3> C_position;  ///< position of C [m]
    std::array<Scalar, 3> C_velocity;  ///< velocity of the material point at C [m/s]
    std::array<Scalar, 21> C_jacobian;  ///< partial velocities of C (3 x 7)
    std::array<Scalar, 3> D_position;  ///< position of D [m]
    std::array<Scalar, 3> D_velocity;  ///< velocity of the material point at D [m/s]
    std::array<Scalar, 21> D_jacobian;  ///< partial velocities of D (3 x 7)
    std::array<Scalar, 3> E2_position;  ///< position of E2 [m]
    std::array<Scalar, 3> E2_velocity;  ///< velocity of the material point at E2 [m/s]
    std::array<Scalar, 21> E2_jacobian;  ///< partial velocities of E2 (3 x 7)
    std::array<Scalar, 3> E3_position;  ///< position of E3 [m]
    std::array<Scalar, 3> E3_velocity;  ///< velocity of the material point at E3 [m/s]
    std::array<Scalar, 21> E3_jacobian;  ///< partial velocities of E3 (3 x 7)
    std::array<Scalar, 3> E4_position;  ///< position of E4 [m]
    std::array<Scalar, 3> E4_velocity;  ///< velocity of the material point at E4 [m/s]
    std::array<Scalar, 21> E4_jacobian;  ///< partial velocities of E4 (3 x 7)
    std::array<Scalar, 3> E6_position;  ///< position of E6 [m]
    std::array<Scalar, 3> E6_velocity;  ///< velocity of the material point at E6 [m/s]
    std::array<Scalar, 21> E6_jacobian;  ///< partial velocities of E6 (3 x 7)
    std::array<Scalar, 3> F_position;  ///< position of F [m]
    std::array<Scalar, 3> F_velocity;  ///< velocity of the material point at F [m/s]
    std::array<Scalar, 21> F_jacobian;  ///< partial velocities of F (3 x 7)
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

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 6> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 6> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 42> jacobian;  ///< A, stored column by column (6 x 7)
    std::array<Scalar, 6> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 49> M;  ///< mass matrix (7 x 7)
    std::array<Scalar, 49> C;  ///< damping and gyroscopic terms (7 x 7)
    std::array<Scalar, 49> K;  ///< stiffness (7 x 7)
    std::array<Scalar, 7> F;  ///< right-hand side
    std::array<Scalar, 1> M_r;  ///< reduced mass matrix
    std::array<Scalar, 1> C_r;  ///< reduced damping and gyroscopic terms
    std::array<Scalar, 1> K_r;  ///< reduced stiffness
    std::array<Scalar, 1> F_r;  ///< reduced right-hand side
    std::array<Scalar, 4> A;  ///< state matrix of x = (e, w): x' = A x + B du (2 x 2)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 1;
  static constexpr int independent_coordinates[1] = {0};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 1;
  static constexpr int independent_velocities[1] = {0};

  /// Derivatives of the residual in compressed rows.
  struct ResidualJacobian {
    std::array<Scalar, 123> values;  ///< entries, row by row
  };
  /// Where the values of ResidualJacobian stand: those of row i from row_start[i] to row_start[i + 1], each in its
  /// column: of unknown j by position j, by velocity n + j, by acceleration 2 n + j, by multiplier k 3 n + k.
  static constexpr int residual_jacobian_nonzeros = 123;
  static constexpr int residual_jacobian_row_start[14] = {0, 12, 23, 27, 34, 42, 49, 57, 66, 75, 87, 99, 111, 123};
  static constexpr int residual_jacobian_column[123] = {0, 1, 7, 8, 14, 15, 21, 22, 23, 24, 25, 26, 0, 1, 7, 14, 15, 21,
      22, 23, 24, 25, 26, 2, 16, 21, 22, 3, 4, 11, 17, 18, 23, 24, 3, 4, 10, 11, 17, 18, 23, 24, 5, 6, 13, 19, 20, 25,
      26, 5, 6, 12, 13, 19, 20, 25, 26, 0, 1, 2, 7, 8, 9, 14, 15, 16, 0, 1, 2, 7, 8, 9, 14, 15, 16, 0, 1, 3, 4, 7, 8,
      10, 11, 14, 15, 17, 18, 0, 1, 3, 4, 7, 8, 10, 11, 14, 15, 17, 18, 0, 1, 5, 6, 7, 8, 12, 13, 14, 15, 19, 20, 0, 1,
      5, 6, 7, 8, 12, 13, 14, 15, 19, 20};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k2 = traits::constant(0.01874, 0.01874f, "937/50000");
    const Scalar k3 = traits::constant(0.01043, 0.01043f, "1043/100000");
    const Scalar k4 = traits::constant(0.00916, 0.00916f, "229/25000");
    const Scalar k5 = traits::constant(0.02308, 0.02308f, "577/25000");
    const Scalar n0_0115 = traits::constant(0.0115, 0.0115f, "23/2000");
    const Scalar k7 = traits::constant(0.00579, 0.00579f, "579/100000");
    const Scalar k8 = traits::constant(0.00092, 0.00092f, "23/25000");
    const Scalar k9 = traits::constant(0.01228, 0.01228f, "307/25000");
    const Scalar k10 = traits::constant(0.00449, 0.00449f, "449/100000");
    const Scalar k11 = traits::constant(0.06934, 0.06934f, "3467/50000");
    const Scalar k12 = traits::constant(0.00227, 0.00227f, "227/100000");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k17 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k18 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar z0 = q_beta + q_Theta;
    const Scalar z1 = q_delta + q_Phi;
    const Scalar z2 = q_epsilon + q_Omega;
    const Scalar angles_[] = {q_beta, q_gamma, q_delta, q_epsilon, z0, z1, z2};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_gamma = sines_[1], c_gamma = cosines_[1];
    const Scalar s_delta = sines_[2], c_delta = cosines_[2];
    const Scalar s_epsilon = sines_[3], c_epsilon = cosines_[3];
    const Scalar z3 = sines_[4], z4 = cosines_[4];
    const Scalar z5 = sines_[5], z6 = cosines_[5];
    const Scalar z7 = sines_[6], z8 = cosines_[6];
    const Scalar z9 = n0_007 * v_beta;
    const Scalar z10 = v_beta + v_Theta;
    const Scalar z11 = n0_04 * v_delta;
    const Scalar z12 = v_delta + v_Phi;
    const Scalar z13 = n0_04 * v_epsilon;
    const Scalar z14 = v_epsilon + v_Omega;
    const Scalar z15 = k2 * v_gamma;
    const Scalar z16 = k3 * v_gamma;
    const Scalar z17 = k4 * v_delta;
    const Scalar z18 = k5 * v_delta;
    const Scalar z19 = n0_04 * c_delta;
    const Scalar z20 = n0_04 * s_delta;
    const Scalar z21 = n0_04 * s_epsilon;
    const Scalar z22 = n0_04 * c_epsilon;
    const Scalar z23 = s_beta * z9;  // velocity of K2, x
    const Scalar z24 = c_beta * z9;  // velocity of K2, y
    const Scalar z25 = s_delta * z11;  // velocity of K4, x
    const Scalar z26 = c_delta * z11;  // velocity of K4, y
    const Scalar z27 = c_epsilon * z13;  // velocity of K6, x
    const Scalar z28 = s_epsilon * z13;  // velocity of K6, y
    const Scalar z29 = n0_0115 * z10;
    const Scalar z30 = k7 * z12;
    const Scalar z31 = n0_007 * c_beta;
    const Scalar z32 = k8 * c_beta;
    const Scalar z33 = k8 * s_beta;
    const Scalar z34 = s_gamma * z16 - c_gamma * z15;
    const Scalar z35 = s_gamma * z15 + c_gamma * z16;
    const Scalar z36 = n0_007 * s_beta;
    const Scalar z37 = k7 * z14;
    const Scalar z38 = s_delta * z18 + c_delta * z17;
    const Scalar z39 = s_delta * z17 - c_delta * z18;
    const Scalar z40 = k8 * v_beta;
    const Scalar z41 = n0_0115 * z4;
    const Scalar z42 = s_beta * z40;
    const Scalar z43 = c_beta * z40;
    const Scalar z44 = n0_0115 * z3;
    const Scalar z45 = k2 * s_gamma + k3 * c_gamma;
    const Scalar z46 = k3 * s_gamma - k2 * c_gamma;
    const Scalar z47 = k7 * z5;
    const Scalar z48 = k7 * z6;
    const Scalar z49 = k4 * s_delta - k5 * c_delta;
    const Scalar z50 = k5 * s_delta + k4 * c_delta;
    const Scalar z51 = k7 * z8;
    const Scalar z52 = k7 * z7;
    const Scalar z53 = k9 * s_epsilon - k10 * c_epsilon;
    const Scalar z54 = k10 * s_epsilon + k9 * c_epsilon;
    const Scalar z55 = k11 - z19;  // place of K4, x
    const Scalar z56 = k9 * v_epsilon;
    const Scalar z57 = k12 - z20;  // place of K4, y
    const Scalar z58 = k10 * v_epsilon;
    const Scalar z59 = s_epsilon * z58 + c_epsilon * z56;
    const Scalar z60 = s_epsilon * z56 - c_epsilon * z58;
    const Scalar z61 = n0_018 * v_gamma;
    const Scalar z62 = n0_02 * v_gamma;
    const Scalar z63 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z64 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z65 = k11 - z21;  // place of K6, x
    const Scalar z66 = s_gamma * z62 - c_gamma * z61;
    const Scalar z67 = k12 + z22;  // place of K6, y
    const Scalar z68 = s_gamma * z61 + c_gamma * z62;
    const Scalar z69 = n0_028 * z10;
    const Scalar z70 = n0_028 * z4;
    const Scalar z71 = n0_028 * z3;
    const Scalar z72 = n0_035 * s_gamma;
    const Scalar z73 = z3 * z29 - z23;
    const Scalar z74 = z4 * z29 - z24;
    const Scalar z75 = z3 * z69 - z23;
    const Scalar z76 = z4 * z69 - z24;
    const Scalar z77 = z31 - z41;
    const Scalar z78 = z31 - z70;
    const Scalar z79 = z36 - z44;
    const Scalar z80 = z36 - z71;
    const Scalar z81 = k17 - z45;
    const Scalar z82 = k18 + z46;
    const Scalar z83 = z55 - z47;
    const Scalar z84 = z57 + z48;
    const Scalar z85 = k11 + z49;
    const Scalar z86 = k12 - z50;
    const Scalar z87 = z65 - z51;
    const Scalar z88 = z67 - z52;
    const Scalar z89 = k11 - z53;
    const Scalar z90 = k12 + z54;
    const Scalar z91 = n0_02 * z12;
    const Scalar z92 = n0_02 * z14;
    const Scalar z93 = n0_035 * c_gamma;
    const Scalar z94 = k17 - z63;
    const Scalar z95 = n0_035 * v_gamma;
    const Scalar z96 = k18 + z64;
    const Scalar z97 = n0_02 * z5;
    const Scalar z98 = k17 - z72;
    const Scalar z99 = n0_02 * z6;
    const Scalar z100 = k18 - z93;
    const Scalar z101 = n0_02 * z8;
    const Scalar z102 = z55 - z97;
    const Scalar z103 = n0_02 * z7;
    const Scalar z104 = z19 + z97;
    const Scalar z105 = z6 * z30 - z25;
    const Scalar z106 = z5 * z30 + z26;
    const Scalar z107 = z7 * z37 - z27;
    const Scalar z108 = z8 * z37 + z28;
    const Scalar z109 = c_gamma * z95;
    const Scalar z110 = s_gamma * z95;
    const Scalar z111 = z6 * z91 - z25;
    const Scalar z112 = z5 * z91 + z26;
    const Scalar z113 = z57 + z99;
    const Scalar z114 = z20 - z99;
    const Scalar z115 = z7 * z92 - z27;
    const Scalar z116 = z8 * z92 + z28;
    const Scalar z117 = z65 - z101;
    const Scalar z118 = z67 - z103;
    const Scalar z119 = z21 + z101;
    const Scalar z120 = z22 - z103;
    result.S1_position[0] = z32;
    result.S1_position[1] = z33;
    result.S1_position[2] = n0;
    result.S1_rotation[0] = c_beta;
    result.S1_rotation[1] = s_beta;
    result.S1_rotation[2] = n0;
    result.S1_rotation[3] = -s_beta;
    result.S1_rotation[4] = c_beta;
    result.S1_rotation[5] = n0;
    result.S1_rotation[6] = n0;
    result.S1_rotation[7] = n0;
    result.S1_rotation[8] = n1;
    result.S1_velocity[0] = -z42;
    result.S1_velocity[1] = z43;
    result.S1_velocity[2] = n0;
    result.S1_angular_velocity[0] = n0;
    result.S1_angular_velocity[1] = n0;
    result.S1_angular_velocity[2] = v_beta;
    result.S2_position[0] = z77;
    result.S2_position[1] = z79;
    result.S2_position[2] = n0;
    result.S2_rotation[0] = z4;
    result.S2_rotation[1] = z3;
    result.S2_rotation[2] = n0;
    result.S2_rotation[3] = -z3;
    result.S2_rotation[4] = z4;
    result.S2_rotation[5] = n0;
    result.S2_rotation[6] = n0;
    result.S2_rotation[7] = n0;
    result.S2_rotation[8] = n1;
    result.S2_velocity[0] = z73;
    result.S2_velocity[1] = -z74;
    result.S2_velocity[2] = n0;
    result.S2_angular_velocity[0] = n0;
    result.S2_angular_velocity[1] = n0;
    result.S2_angular_velocity[2] = z10;
    result.S3_position[0] = -z81;
    result.S3_position[1] = z82;
    result.S3_position[2] = n0;
    result.S3_rotation[0] = c_gamma;
    result.S3_rotation[1] = s_gamma;
    result.S3_rotation[2] = n0;
    result.S3_rotation[3] = -s_gamma;
    result.S3_rotation[4] = c_gamma;
    result.S3_rotation[5] = n0;
    result.S3_rotation[6] = n0;
    result.S3_rotation[7] = n0;
    result.S3_rotation[8] = n1;
    result.S3_velocity[0] = -z34;
    result.S3_velocity[1] = z35;
    result.S3_velocity[2] = n0;
    result.S3_angular_velocity[0] = n0;
    result.S3_angular_velocity[1] = n0;
    result.S3_angular_velocity[2] = v_gamma;
    result.S4_position[0] = -z83;
    result.S4_position[1] = -z84;
    result.S4_position[2] = n0;
    result.S4_rotation[0] = z6;
    result.S4_rotation[1] = z5;
    result.S4_rotation[2] = n0;
    result.S4_rotation[3] = -z5;
    result.S4_rotation[4] = z6;
    result.S4_rotation[5] = n0;
    result.S4_rotation[6] = n0;
    result.S4_rotation[7] = n0;
    result.S4_rotation[8] = n1;
    result.S4_velocity[0] = z105;
    result.S4_velocity[1] = z106;
    result.S4_velocity[2] = n0;
    result.S4_angular_velocity[0] = n0;
    result.S4_angular_velocity[1] = n0;
    result.S4_angular_velocity[2] = z12;
    result.S5_position[0] = -z85;
    result.S5_position[1] = -z86;
    result.S5_position[2] = n0;
    result.S5_rotation[0] = c_delta;
    result.S5_rotation[1] = s_delta;
    result.S5_rotation[2] = n0;
    result.S5_rotation[3] = -s_delta;
    result.S5_rotation[4] = c_delta;
    result.S5_rotation[5] = n0;
    result.S5_rotation[6] = n0;
    result.S5_rotation[7] = n0;
    result.S5_rotation[8] = n1;
    result.S5_velocity[0] = -z38;
    result.S5_velocity[1] = -z39;
    result.S5_velocity[2] = n0;
    result.S5_angular_velocity[0] = n0;
    result.S5_angular_velocity[1] = n0;
    result.S5_angular_velocity[2] = v_delta;
    result.S6_position[0] = -z87;
    result.S6_position[1] = -z88;
    result.S6_position[2] = n0;
    result.S6_rotation[0] = z8;
    result.S6_rotation[1] = z7;
    result.S6_rotation[2] = n0;
    result.S6_rotation[3] = -z7;
    result.S6_rotation[4] = z8;
    result.S6_rotation[5] = n0;
    result.S6_rotation[6] = n0;
    result.S6_rotation[7] = n0;
    result.S6_rotation[8] = n1;
    result.S6_velocity[0] = -z107;
    result.S6_velocity[1] = z108;
    result.S6_velocity[2] = n0;
    result.S6_angular_velocity[0] = n0;
    result.S6_angular_velocity[1] = n0;
    result.S6_angular_velocity[2] = z14;
    result.S7_position[0] = -z89;
    result.S7_position[1] = -z90;
    result.S7_position[2] = n0;
    result.S7_rotation[0] = c_epsilon;
    result.S7_rotation[1] = s_epsilon;
    result.S7_rotation[2] = n0;
    result.S7_rotation[3] = -s_epsilon;
    result.S7_rotation[4] = c_epsilon;
    result.S7_rotation[5] = n0;
    result.S7_rotation[6] = n0;
    result.S7_rotation[7] = n0;
    result.S7_rotation[8] = n1;
    result.S7_velocity[0] = z59;
    result.S7_velocity[1] = z60;
    result.S7_velocity[2] = n0;
    result.S7_angular_velocity[0] = n0;
    result.S7_angular_velocity[1] = n0;
    result.S7_angular_velocity[2] = v_epsilon;
    result.C_position[0] = n0_014;
    result.C_position[1] = n0_072;
    result.C_position[2] = n0;
    result.C_velocity[0] = n0;
    result.C_velocity[1] = n0;
    result.C_velocity[2] = n0;
    result.C_jacobian[0] = n0;
    result.C_jacobian[3] = n0;
    result.C_jacobian[6] = n0;
    result.C_jacobian[9] = n0;
    result.C_jacobian[12] = n0;
    result.C_jacobian[15] = n0;
    result.C_jacobian[18] = n0;
    result.C_jacobian[1] = n0;
    result.C_jacobian[4] = n0;
    result.C_jacobian[7] = n0;
    result.C_jacobian[10] = n0;
    result.C_jacobian[13] = n0;
    result.C_jacobian[16] = n0;
    result.C_jacobian[19] = n0;
    result.C_jacobian[2] = n0;
    result.C_jacobian[5] = n0;
    result.C_jacobian[8] = n0;
    result.C_jacobian[11] = n0;
    result.C_jacobian[14] = n0;
    result.C_jacobian[17] = n0;
    result.C_jacobian[20] = n0;
    result.D_position[0] = -z94;
    result.D_position[1] = z96;
    result.D_position[2] = n0;
    result.D_velocity[0] = -z66;
    result.D_velocity[1] = z68;
    result.D_velocity[2] = n0;
    result.D_jacobian[0] = n0;
    result.D_jacobian[3] = n0;
    result.D_jacobian[6] = -z64;
    result.D_jacobian[9] = n0;
    result.D_jacobian[12] = n0;
    result.D_jacobian[15] = n0;
    result.D_jacobian[18] = n0;
    result.D_jacobian[1] = n0;
    result.D_jacobian[4] = n0;
    result.D_jacobian[7] = z63;
    result.D_jacobian[10] = n0;
    result.D_jacobian[13] = n0;
    result.D_jacobian[16] = n0;
    result.D_jacobian[19] = n0;
    result.D_jacobian[2] = n0;
    result.D_jacobian[5] = n0;
    result.D_jacobian[8] = n0;
    result.D_jacobian[11] = n0;
    result.D_jacobian[14] = n0;
    result.D_jacobian[17] = n0;
    result.D_jacobian[20] = n0;
    result.E2_position[0] = z78;
    result.E2_position[1] = z80;
    result.E2_position[2] = n0;
    result.E2_velocity[0] = z75;
    result.E2_velocity[1] = -z76;
    result.E2_velocity[2] = n0;
    result.E2_jacobian[0] = -z80;
    result.E2_jacobian[3] = z71;
    result.E2_jacobian[6] = n0;
    result.E2_jacobian[9] = n0;
    result.E2_jacobian[12] = n0;
    result.E2_jacobian[15] = n0;
    result.E2_jacobian[18] = n0;
    result.E2_jacobian[1] = z78;
    result.E2_jacobian[4] = -z70;
    result.E2_jacobian[7] = n0;
    result.E2_jacobian[10] = n0;
    result.E2_jacobian[13] = n0;
    result.E2_jacobian[16] = n0;
    result.E2_jacobian[19] = n0;
    result.E2_jacobian[2] = n0;
    result.E2_jacobian[5] = n0;
    result.E2_jacobian[8] = n0;
    result.E2_jacobian[11] = n0;
    result.E2_jacobian[14] = n0;
    result.E2_jacobian[17] = n0;
    result.E2_jacobian[20] = n0;
    result.E3_position[0] = -z98;
    result.E3_position[1] = z100;
    result.E3_position[2] = n0;
    result.E3_velocity[0] = z109;
    result.E3_velocity[1] = z110;
    result.E3_velocity[2] = n0;
    result.E3_jacobian[0] = n0;
    result.E3_jacobian[3] = n0;
    result.E3_jacobian[6] = z93;
    result.E3_jacobian[9] = n0;
    result.E3_jacobian[12] = n0;
    result.E3_jacobian[15] = n0;
    result.E3_jacobian[18] = n0;
    result.E3_jacobian[1] = n0;
    result.E3_jacobian[4] = n0;
    result.E3_jacobian[7] = z72;
    result.E3_jacobian[10] = n0;
    result.E3_jacobian[13] = n0;
    result.E3_jacobian[16] = n0;
    result.E3_jacobian[19] = n0;
    result.E3_jacobian[2] = n0;
    result.E3_jacobian[5] = n0;
    result.E3_jacobian[8] = n0;
    result.E3_jacobian[11] = n0;
    result.E3_jacobian[14] = n0;
    result.E3_jacobian[17] = n0;
    result.E3_jacobian[20] = n0;
    result.E4_position[0] = -z102;
    result.E4_position[1] = -z113;
    result.E4_position[2] = n0;
    result.E4_velocity[0] = z111;
    result.E4_velocity[1] = z112;
    result.E4_velocity[2] = n0;
    result.E4_jacobian[0] = n0;
    result.E4_jacobian[3] = n0;
    result.E4_jacobian[6] = n0;
    result.E4_jacobian[9] = z99;
    result.E4_jacobian[12] = -z114;
    result.E4_jacobian[15] = n0;
    result.E4_jacobian[18] = n0;
    result.E4_jacobian[1] = n0;
    result.E4_jacobian[4] = n0;
    result.E4_jacobian[7] = n0;
    result.E4_jacobian[10] = z97;
    result.E4_jacobian[13] = z104;
    result.E4_jacobian[16] = n0;
    result.E4_jacobian[19] = n0;
    result.E4_jacobian[2] = n0;
    result.E4_jacobian[5] = n0;
    result.E4_jacobian[8] = n0;
    result.E4_jacobian[11] = n0;
    result.E4_jacobian[14] = n0;
    result.E4_jacobian[17] = n0;
    result.E4_jacobian[20] = n0;
    result.E6_position[0] = -z117;
    result.E6_position[1] = -z118;
    result.E6_position[2] = n0;
    result.E6_velocity[0] = -z115;
    result.E6_velocity[1] = z116;
    result.E6_velocity[2] = n0;
    result.E6_jacobian[0] = n0;
    result.E6_jacobian[3] = n0;
    result.E6_jacobian[6] = n0;
    result.E6_jacobian[9] = n0;
    result.E6_jacobian[12] = n0;
    result.E6_jacobian[15] = -z103;
    result.E6_jacobian[18] = z120;
    result.E6_jacobian[1] = n0;
    result.E6_jacobian[4] = n0;
    result.E6_jacobian[7] = n0;
    result.E6_jacobian[10] = n0;
    result.E6_jacobian[13] = n0;
    result.E6_jacobian[16] = z101;
    result.E6_jacobian[19] = z119;
    result.E6_jacobian[2] = n0;
    result.E6_jacobian[5] = n0;
    result.E6_jacobian[8] = n0;
    result.E6_jacobian[11] = n0;
    result.E6_jacobian[14] = n0;
    result.E6_jacobian[17] = n0;
    result.E6_jacobian[20] = n0;
    result.F_position[0] = z31;
    result.F_position[1] = z36;
    result.F_position[2] = n0;
    result.F_velocity[0] = -z23;
    result.F_velocity[1] = z24;
    result.F_velocity[2] = n0;
    result.F_jacobian[0] = -z36;
    result.F_jacobian[3] = n0;
    result.F_jacobian[6] = n0;
    result.F_jacobian[9] = n0;
    result.F_jacobian[12] = n0;
    result.F_jacobian[15] = n0;
    result.F_jacobian[18] = n0;
    result.F_jacobian[1] = z31;
    result.F_jacobian[4] = n0;
    result.F_jacobian[7] = n0;
    result.F_jacobian[10] = n0;
    result.F_jacobian[13] = n0;
    result.F_jacobian[16] = n0;
    result.F_jacobian[19] = n0;
    result.F_jacobian[2] = n0;
    result.F_jacobian[5] = n0;
    result.F_jacobian[8] = n0;
    result.F_jacobian[11] = n0;
    result.F_jacobian[14] = n0;
    result.F_jacobian[17] = n0;
    result.F_jacobian[20] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 49>& mass) noexcept {
    const Scalar k0 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k1 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k2 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k4 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k7 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k8 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k9 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k11 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_Theta = state.q.Theta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar q_Omega = state.q.Omega;
    const Scalar angles_[] = {q_Theta, q_Phi, q_Omega};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_Theta = cosines_[0];
    const Scalar s_Phi = sines_[1];
    const Scalar s_Omega = sines_[2];
    const Scalar z0 = k0 * s_Omega;
    const Scalar z1 = k0 * s_Phi;
    const Scalar z2 = k1 * c_Theta;
    const Scalar z3 = k2 - z0;
    const Scalar z4 = k2 - n2 * z0;
    const Scalar z5 = k2 + z1;
    const Scalar z6 = k2 + n2 * z1;
    const Scalar z7 = k4 - n0_175 * z2;
    const Scalar z8 = k4 - n0_35 * z2;
    const Scalar z9 = k7 + z4;
    const Scalar z10 = k8 + z6;
    const Scalar z11 = k9 + z8;
    mass[0] = z11;
    mass[1] = z7;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = z7;
    mass[8] = k4;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = k11;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = k2;
    mass[25] = z5;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = z5;
    mass[32] = z10;
    mass[33] = n0;
    mass[34] = n0;
    mass[35] = n0;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n0;
    mass[39] = n0;
    mass[40] = k2;
    mass[41] = z3;
    mass[42] = n0;
    mass[43] = n0;
    mass[44] = n0;
    mass[45] = n0;
    mass[46] = n0;
    mass[47] = z3;
    mass[48] = z9;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k3 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar k4 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k6 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k8 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k9 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar angles_[] = {q_Theta, q_gamma, q_Phi, q_Omega};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_Theta = sines_[0];
    const Scalar s_gamma = sines_[1], c_gamma = cosines_[1];
    const Scalar c_Phi = cosines_[2];
    const Scalar c_Omega = cosines_[3];
    const Scalar z0 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z1 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z2 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z3 = k2 * s_gamma + k3 * c_gamma;
    const Scalar z4 = z2 * z2;
    const Scalar z5 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z6 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z7 = v_beta * v_beta;
    const Scalar z8 = k3 * s_gamma - k2 * c_gamma;
    const Scalar z9 = k4 * z4;  // force on K2, times 0.04 m, x
    const Scalar z10 = n0_175 * z7;
    const Scalar z11 = v_delta * v_delta;
    const Scalar z12 = v_epsilon * v_epsilon;
    const Scalar z13 = z6 * z6;
    const Scalar z14 = z5 * z5;
    const Scalar z15 = s_Theta * z9;
    const Scalar z16 = s_Theta * z10;
    const Scalar z17 = c_Phi * z11;
    const Scalar z18 = c_Omega * z12;
    const Scalar z19 = k6 * z13;  // force on K6, times 0.04 m, x
    const Scalar z20 = k6 * z14;  // force on K4, times 0.04 m, y
    const Scalar z21 = c_Omega * z19;
    const Scalar z22 = c_Phi * z20;
    const Scalar z23 = k6 * z18;  // moment on K6, z
    const Scalar z24 = k6 * z17;  // moment on K4, z
    const Scalar z25 = k4 * z16;  // moment on K2, z
    const Scalar z26 = z23 - z21;  // moment on K7, z
    const Scalar z27 = z24 - z22;  // moment on K5, z
    const Scalar z28 = n0_033 - n0_175 * z15 + z25;  // moment on K1, z
    const Scalar z29 = k8 - z0;
    const Scalar z30 = k9 + z1;
    const Scalar z31 = n0_02 - z3;
    const Scalar z32 = n0_018 - z8;
    const Scalar z33 = n0_014 + z29;
    const Scalar z34 = n0_072 - z30;
    const Scalar z35 = z33 * z33 + z34 * z34;
    const Scalar z36 = traits::sqrt(z35);
    const Scalar z37 = n1 / z36;
    const Scalar z38 = n4530 - n352_6605 * z37;
    const Scalar z39 = z31 * z38;
    const Scalar z40 = z32 * z38;
    const Scalar z41 = n0_018 * z39 - n0_02 * z40;
    forces.beta = -z28;
    forces.Theta = -z25;
    forces.gamma = z41;
    forces.Phi = -z24;
    forces.delta = -z27;
    forces.Omega = z23;
    forces.epsilon = z26;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar k2 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k3 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k5 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k6 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k11 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k12 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar k13 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k14 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k17 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k18 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k20 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k24 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar a_Theta = accelerations.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar a_Phi = accelerations.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar a_Omega = accelerations.Omega;
    const Scalar l_lambda_E3_x = multipliers.lambda_E3_x;
    const Scalar l_lambda_E3_y = multipliers.lambda_E3_y;
    const Scalar l_lambda_E4_x = multipliers.lambda_E4_x;
    const Scalar l_lambda_E4_y = multipliers.lambda_E4_y;
    const Scalar l_lambda_E6_x = multipliers.lambda_E6_x;
    const Scalar l_lambda_E6_y = multipliers.lambda_E6_y;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z0 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z1 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z2 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z3 = v_beta * v_beta;
    const Scalar z4 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z5 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z6 = k2 * s_gamma + k3 * c_gamma;
    const Scalar z7 = n0_175 * z3;
    const Scalar z8 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z9 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z10 = z2 * z2;
    const Scalar z11 = k3 * s_gamma - k2 * c_gamma;
    const Scalar z12 = n0_175 * a_beta;
    const Scalar z13 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z14 = v_epsilon * v_epsilon;
    const Scalar z15 = z5 * z5;
    const Scalar z16 = k5 * z9;  // force on K6, times 0.04 m, y
    const Scalar z17 = z4 * z4;
    const Scalar z18 = k5 * z8;  // force on K4, times 0.04 m, x
    const Scalar z19 = k6 * z10;  // force on K2, times 0.04 m, x
    const Scalar z20 = v_delta * v_delta;
    const Scalar z21 = k5 * z15;  // force on K6, times 0.04 m, x
    const Scalar z22 = k5 * z17;  // force on K4, times 0.04 m, y
    const Scalar z23 = k6 * z13;  // force on K2, times 0.04 m, y
    const Scalar z24 = s_Theta * z7 + c_Theta * z12;
    const Scalar z25 = a_epsilon * s_Omega - c_Omega * z14;
    const Scalar z26 = a_delta * s_Phi - c_Phi * z20;
    const Scalar z27 = s_Omega * z16 + c_Omega * z21;
    const Scalar z28 = s_Phi * z18 + c_Phi * z22;
    const Scalar z29 = s_Theta * z19 - c_Theta * z23;
    const Scalar z30 = n0_028 * c_Theta;
    const Scalar z31 = n0_028 * s_Theta;
    const Scalar z32 = n0_02 * s_Phi;
    const Scalar z33 = n0_02 * c_Phi;
    const Scalar z34 = n0_035 * s_gamma;
    const Scalar z35 = n0_035 * c_gamma;
    const Scalar z36 = n0_007 - z30;
    const Scalar z37 = s_beta * z31;
    const Scalar z38 = c_beta * z31;
    const Scalar z39 = n0_04 + z32;
    const Scalar z40 = s_delta * z33;
    const Scalar z41 = c_beta * z36 + z37;
    const Scalar z42 = s_beta * z36 - z38;
    const Scalar z43 = s_beta * z30 + z38;
    const Scalar z44 = c_beta * z30 - z37;
    const Scalar z45 = k11 - z0;
    const Scalar z46 = c_delta * z39 + z40;
    const Scalar z47 = k12 + z1;
    const Scalar z48 = c_delta * z33;
    const Scalar z49 = n0_02 - z6;
    const Scalar z50 = n0_018 - z11;
    const Scalar z51 = k5 * z25 - k13 * z9;  // moment on K6, z
    const Scalar z52 = k13 * z8 + k5 * z26;  // moment on K4, z
    const Scalar z53 = k6 * z24 - k14 * z13;  // moment on K2, z
    const Scalar z54 = n0_014 + z45;
    const Scalar z55 = s_delta * z39 - z48;
    const Scalar z56 = n0_072 - z47;
    const Scalar z57 = n0_02 * c_Omega;
    const Scalar z58 = n0_02 * s_Omega;
    const Scalar z59 = s_delta * z32 - z48;
    const Scalar z60 = c_delta * z32 + z40;
    const Scalar z61 = n0_04 - z58;
    const Scalar z62 = k17 * a_delta + z28 + z52;  // moment on K5, z
    const Scalar z63 = z54 * z54 + z56 * z56;
    const Scalar z64 = c_epsilon * z57;
    const Scalar z65 = k18 * a_epsilon - z27 - z51;  // moment on K7, z
    const Scalar z66 = n0_033 - k20 * a_beta - n0_175 * z29 + z53;  // moment on K1, z
    const Scalar z67 = traits::sqrt(z63);
    const Scalar z68 = s_epsilon * z61 + z64;
    const Scalar z69 = n1 / z67;
    const Scalar z70 = s_epsilon * z57;
    const Scalar z71 = n4530 - n352_6605 * z69;
    const Scalar z72 = c_epsilon * z61 - z70;
    const Scalar z73 = z49 * z71;
    const Scalar z74 = c_epsilon * z58 + z70;
    const Scalar z75 = z50 * z71;
    const Scalar z76 = s_epsilon * z58 - z64;
    const Scalar z77 = n0_018 * z73 - n0_02 * z75;
    const Scalar z78 = k24 * a_gamma + z77;  // moment on K3, z
    forces.beta = z42 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z66 - z41 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    forces.Theta = -z53 - z43 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z44 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    forces.gamma = z78 + l_lambda_E3_x * z35 + l_lambda_E3_y * z34;
    forces.Phi = -l_lambda_E4_x * z59 + z52 + l_lambda_E4_y * z60;
    forces.delta = -l_lambda_E4_x * z55 + z62 + l_lambda_E4_y * z46;
    forces.Omega = -z51 - l_lambda_E6_x * z74 - l_lambda_E6_y * z76;
    forces.epsilon = z65 + l_lambda_E6_x * z72 + l_lambda_E6_y * z68;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar k7 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar k9 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k10 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k11 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k12 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k14 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k16 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k18 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k19 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k21 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k22 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k24 = traits::constant(1082587.9264381505, 1082587.9f, "80000000000/73897");
    const Scalar k25 = traits::constant(61842.35515712993, 61842.355f, "40000000000000/646805897");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z0 = n0_028 * c_Theta;
    const Scalar z1 = n0_028 * s_Theta;
    const Scalar z2 = n0_02 * c_Omega;
    const Scalar z3 = n0_02 * s_Omega;
    const Scalar z4 = n0_02 * s_Phi;
    const Scalar z5 = n0_02 * c_Phi;
    const Scalar z6 = n0_035 * s_gamma;
    const Scalar z7 = v_beta * c_beta;
    const Scalar z8 = v_beta * s_beta;
    const Scalar z9 = v_delta * s_delta;
    const Scalar z10 = v_delta * c_delta;
    const Scalar z11 = v_Theta * c_Theta;
    const Scalar z12 = v_Theta * s_Theta;
    const Scalar z13 = v_Phi * s_Phi;
    const Scalar z14 = v_Phi * c_Phi;
    const Scalar z15 = n0_035 * c_gamma;
    const Scalar z16 = v_gamma * c_gamma;
    const Scalar z17 = v_gamma * s_gamma;
    const Scalar z18 = n0_007 - z0;
    const Scalar z19 = s_beta * z1;
    const Scalar z20 = v_epsilon * c_epsilon;
    const Scalar z21 = c_beta * z1;
    const Scalar z22 = n0_028 * z11;
    const Scalar z23 = n0_028 * z12;
    const Scalar z24 = v_gamma * z17;
    const Scalar z25 = v_Theta * z12;
    const Scalar z26 = v_Theta * z11;
    const Scalar z27 = v_beta * z8;
    const Scalar z28 = v_beta * z7;
    const Scalar z29 = v_gamma * z16;
    const Scalar z30 = n0_04 + z4;
    const Scalar z31 = s_delta * z5;
    const Scalar z32 = c_delta * z5;
    const Scalar z33 = n0_02 * z13;
    const Scalar z34 = n0_02 * z14;
    const Scalar z35 = v_Phi * z14;
    const Scalar z36 = v_Phi * z13;
    const Scalar z37 = v_delta * z9;
    const Scalar z38 = v_delta * z10;
    const Scalar z39 = n0_04 - z3;
    const Scalar z40 = c_epsilon * z2;
    const Scalar z41 = s_epsilon * z2;
    const Scalar z42 = c_beta * z18 + z19;
    const Scalar z43 = v_Omega * c_Omega;
    const Scalar z44 = n0_02 * z43;
    const Scalar z45 = s_beta * z18 - z21;
    const Scalar z46 = v_Omega * z43;
    const Scalar z47 = v_Omega * s_Omega;
    const Scalar z48 = v_epsilon * s_epsilon;
    const Scalar z49 = n0_02 * z47;
    const Scalar z50 = v_Omega * z47;
    const Scalar z51 = s_beta * z0 + z21;
    const Scalar z52 = v_epsilon * z48;
    const Scalar z53 = v_epsilon * z20;
    const Scalar z54 = n0_035 * z24;
    const Scalar z55 = n0_028 * z25;
    const Scalar z56 = n0_028 * z26;
    const Scalar z57 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z58 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z59 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z60 = c_beta * z0 - z19;
    const Scalar z61 = n0_035 * z29;
    const Scalar z62 = c_delta * z30 + z31;
    const Scalar z63 = s_delta * z30 - z32;
    const Scalar z64 = s_delta * z4 - z32;
    const Scalar z65 = n0_02 * z35;
    const Scalar z66 = n0_02 * z36;
    const Scalar z67 = c_delta * z4 + z31;
    const Scalar z68 = s_epsilon * z39 + z40;
    const Scalar z69 = c_epsilon * z39 - z41;
    const Scalar z70 = c_epsilon * z3 + z41;
    const Scalar z71 = n0_02 * z50;
    const Scalar z72 = n0_02 * z46;
    const Scalar z73 = s_epsilon * z3 - z40;
    const Scalar z74 = z1 * z27 + z18 * z28 + s_beta * z55 - c_beta * z56 - n2 * (z7 * z22 - z8 * z23);
    const Scalar z75 = z1 * z28 - z18 * z27 + s_beta * z56 + c_beta * z55 + n2 * (z7 * z23 + z22 * z8);
    const Scalar z76 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z77 = z5 * z37 + z30 * z38 + s_delta * z65 + c_delta * z66 + n2 * (z10 * z33 + z9 * z34);
    const Scalar z78 = z30 * z37 - z5 * z38 + s_delta * z66 - c_delta * z65 - n2 * (z10 * z34 - z33 * z9);
    const Scalar z79 = z74 - z77;
    const Scalar z80 = z75 + z78;
    const Scalar z81 = z54 - z74;
    const Scalar z82 = k7 - z76;
    const Scalar z83 = n0_014 + z82;
    const Scalar z84 = z61 - z75;
    const Scalar z85 = z57 * z57;
    const Scalar z86 = k9 * z85;  // force on K2, times 0.04 m, x
    const Scalar z87 = z59 * z59;
    const Scalar z88 = z58 * z58;
    const Scalar z89 = k10 * z87;  // force on K6, times 0.04 m, x
    const Scalar z90 = k10 * z88;  // force on K4, times 0.04 m, y
    const Scalar z91 = k10 * s_Omega;
    const Scalar z92 = s_Theta * z86;
    const Scalar z93 = k11 - n2 * z91;
    const Scalar z94 = k11 - z91;
    const Scalar z95 = c_Omega * z89;
    const Scalar z96 = c_Phi * z90;
    const Scalar z97 = k9 * c_Theta;
    const Scalar z98 = k12 - n0_175 * z97;
    const Scalar z99 = k14 + z93;
    const Scalar z100 = k12 - n0_35 * z97;
    const Scalar z101 = k10 * s_Phi;
    const Scalar z102 = k11 + n2 * z101;
    const Scalar z103 = k16 + z100;
    const Scalar z104 = n1 / z99;
    const Scalar z105 = k11 + z101;
    const Scalar z106 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z107 = k18 + z102;
    const Scalar z108 = k19 + z106;
    const Scalar z109 = v_beta * v_beta;
    const Scalar z110 = n0_175 * z109;
    const Scalar z111 = v_delta * v_delta;
    const Scalar z112 = c_Phi * z111;
    const Scalar z113 = n0_072 - z108;
    const Scalar z114 = v_epsilon * v_epsilon;
    const Scalar z115 = c_Omega * z114;
    const Scalar z116 = s_Theta * z110;
    const Scalar z117 = k21 * s_gamma + k22 * c_gamma;
    const Scalar z118 = z83 * z83 + z113 * z113;
    const Scalar z119 = k9 * z116;  // moment on K2, z
    const Scalar z120 = k10 * z115;  // moment on K6, z
    const Scalar z121 = k10 * z112;  // moment on K4, z
    const Scalar z122 = n0_02 - z117;
    const Scalar z123 = traits::sqrt(z118);
    const Scalar z124 = n0_033 - n0_175 * z92 + z119;  // moment on K1, z
    const Scalar z125 = z120 - z95;  // moment on K7, z
    const Scalar z126 = z121 - z96;  // moment on K5, z
    const Scalar z127 = s_epsilon * z71 - z2 * z53 - z39 * z52 - c_epsilon * z72 - n2 * (z20 * z44 - z48 * z49);
    const Scalar z128 = z2 * z52 - z39 * z53 + s_epsilon * z72 + c_epsilon * z71 + n2 * (z20 * z49 + z44 * z48);
    const Scalar z129 = z74 + z127;
    const Scalar z130 = z75 + z128;
    const Scalar z131 = n1 / z107;
    const Scalar z132 = k24 * z98;
    const Scalar z133 = z98 * z132 - z103;
    const Scalar z134 = n1 / z123;
    const Scalar z135 = z94 * z104;
    const Scalar z136 = k11 - z94 * z135;
    const Scalar z137 = z42 + z60 * z132;
    const Scalar z138 = n1 / z133;
    const Scalar z139 = z45 + z51 * z132;
    const Scalar z140 = z105 * z131;
    const Scalar z141 = n1 / z136;
    const Scalar z142 = k11 - z105 * z140;
    const Scalar z143 = k25 * z15;
    const Scalar z144 = k22 * s_gamma - k21 * c_gamma;
    const Scalar z145 = n0_018 - z144;
    const Scalar z146 = n1 / z142;
    const Scalar z147 = z63 * z140 - z64;
    const Scalar z148 = k25 * z6;
    const Scalar z149 = n4530 - n352_6605 * z134;
    const Scalar z150 = z62 * z140 - z67;
    const Scalar z151 = z138 * z139;
    const Scalar z152 = z138 * z137;
    const Scalar z153 = z122 * z149;
    const Scalar z154 = z145 * z149;
    const Scalar z155 = k24 * z51 - z132 * z151;
    const Scalar z156 = k24 * z60 - z132 * z152;
    const Scalar z157 = n0_018 * z153 - n0_02 * z154;
    const Scalar z158 = z42 * z152;
    const Scalar z159 = z68 * z135 + z73;
    const Scalar z160 = z141 * z159;
    const Scalar z161 = z42 * z151;
    const Scalar z162 = z146 * z150;
    const Scalar z163 = z146 * z147;
    const Scalar z164 = z69 * z135 + z70;
    const Scalar z165 = z141 * z164;
    const Scalar z166 = z68 * z104 + z135 * z160;
    const Scalar z167 = z45 * z151;
    const Scalar z168 = z62 * z131 + z140 * z162;
    const Scalar z169 = z60 * z156 - z158 + z73 * z160 + z68 * z166;
    const Scalar z170 = z69 * z104 + z135 * z165;
    const Scalar z171 = z60 * z155 - z161 - z73 * z165 - z68 * z170;
    const Scalar z172 = n1 / z169;
    const Scalar z173 = z51 * z155 - z167 + z70 * z165 + z69 * z170;
    const Scalar z174 = z45 * z152 - z51 * z156;
    const Scalar z175 = z60 * z156 - z158;
    const Scalar z176 = z60 * z156 - z158 - z67 * z162 + z62 * z168;
    const Scalar z177 = z63 * z131 + z140 * z163;
    const Scalar z178 = z51 * z155 - z167;
    const Scalar z179 = z51 * z155 - z167 - z64 * z163 + z63 * z177;
    const Scalar z180 = z171 * z172;
    const Scalar z181 = z175 * z172;
    const Scalar z182 = z173 - z171 * z180;
    const Scalar z183 = z174 + z175 * z180;
    const Scalar z184 = z175 * z181 - z176;
    const Scalar z185 = z60 * z155 - z161;
    const Scalar z186 = n1 / z182;
    const Scalar z187 = z60 * z155 - z161 - z67 * z163 + z62 * z177;
    const Scalar z188 = z185 * z181 - z187;
    const Scalar z189 = z185 * z172;
    const Scalar z190 = z174 + z175 * z189;
    const Scalar z191 = z178 - z185 * z180;
    const Scalar z192 = z178 - z185 * z189;
    const Scalar z193 = z179 - z185 * z189;
    const Scalar z194 = z6 * z148 - z42 * z152 + z60 * z156;
    const Scalar z195 = z175 * (n1 - z181);
    const Scalar z196 = z194 - z175 * z181;
    const Scalar z197 = z183 * z186;
    const Scalar z198 = z191 * z186;
    const Scalar z199 = z6 * z143 + z42 * z151 - z60 * z155;
    const Scalar z200 = z184 + z183 * z197;
    const Scalar z201 = z188 - z191 * z197;
    const Scalar z202 = z193 - z191 * z198;
    const Scalar z203 = n1 / z200;
    const Scalar z204 = z190 - z183 * z198;
    const Scalar z205 = z195 - z183 * z197;
    const Scalar z206 = z196 - z183 * z197;
    const Scalar z207 = z199 + z185 * z181;
    const Scalar z208 = z207 - z191 * z197;
    const Scalar z209 = z192 - z191 * z198;
    const Scalar z210 = z15 * z143 - z45 * z151 + z51 * z155;
    const Scalar z211 = z119 * z132 - z124;
    const Scalar z212 = z138 * z211;
    const Scalar z213 = z120 - z125 * z135;
    const Scalar z214 = z141 * z213;
    const Scalar z215 = z121 - z126 * z140;
    const Scalar z216 = k24 * z119 - z132 * z212;
    const Scalar z217 = z125 * z104 - z135 * z214;
    const Scalar z218 = z146 * z215;
    const Scalar z219 = z126 * z131 - z140 * z218;
    const Scalar z220 = k25 * z157;
    const Scalar z221 = z81 - z45 * z212 + z51 * z216 + z15 * z220;
    const Scalar z222 = z45 * z212 + z79 - z51 * z216 - z64 * z218 - z63 * z219;
    const Scalar z223 = z42 * z212 + z80 - z60 * z216 - z67 * z218 - z62 * z219;
    const Scalar z224 = z42 * z212 - z84 - z60 * z216 + z6 * z220;
    const Scalar z225 = z201 * z203;
    const Scalar z226 = z202 + z201 * z225;
    const Scalar z227 = z204 + z205 * z225;
    const Scalar z228 = z205 * z203;
    const Scalar z229 = z206 + z205 * z228;
    const Scalar z230 = z185 * (n1 - z181);
    const Scalar z231 = n1 / z226;
    const Scalar z232 = z210 - z185 * z189;
    const Scalar z233 = z210 + z194 + z179 + z176 + z173 + z169;
    const Scalar z234 = z45 * z212 + z129 - z51 * z216 + z70 * z214 - z69 * z217;
    const Scalar z235 = z42 * z212 + z130 - z60 * z216 - z73 * z214 + z68 * z217;
    const Scalar z236 = z230 + z191 * z197;
    const Scalar z237 = z232 - z191 * z198;
    const Scalar z238 = z208 - z236 * z228;
    const Scalar z239 = z209 - z236 * z225;
    const Scalar z240 = z180 * z235 - z234;
    const Scalar z241 = z181 * z235 - z223 + z197 * z240;
    const Scalar z242 = z227 * z231;
    const Scalar z243 = z229 - z227 * z242;
    const Scalar z244 = z238 - z239 * z242;
    const Scalar z245 = z189 * z235 - z222 - z198 * z240 - z225 * z241;
    const Scalar z246 = n1 / z243;
    const Scalar z247 = z181 * z235 - z224 + z197 * z240 + z228 * z241 + z242 * z245;
    const Scalar z248 = z236 * z203;
    const Scalar z249 = z237 + z236 * z248;
    const Scalar z250 = z239 * z231;
    const Scalar z251 = z249 - z239 * z250;
    const Scalar z252 = z244 * z246;
    const Scalar z253 = z251 - z244 * z252;
    const Scalar z254 = z189 * z235 + z221 - z198 * z240 + z248 * z241 - z250 * z245 + z252 * z247;
    const Scalar z255 = n1 / z253;
    const Scalar z256 = z255 * z254;
    const Scalar z257 = z246 * z247 + z252 * z256;
    const Scalar z258 = z231 * z245 - z250 * z256 + z242 * z257;
    const Scalar z259 = z143 * z256 - z220 - z148 * z257;
    const Scalar z260 = z203 * z241 - z248 * z256 - z228 * z257 + z225 * z258;
    const Scalar z261 = z186 * z240 - z198 * (z256 + z258) + z197 * (z257 - z260);
    const Scalar z262 = z218 + z163 * z258 - z162 * z260;
    const Scalar z263 = z177 * z258 - z219 - z168 * z260;
    const Scalar z264 = z172 * z235 + z189 * (z256 + z258) + z181 * (z257 - z260) + z180 * z261;
    const Scalar z265 = z151 * (z256 + z258 + z261) - z212 + z152 * (z257 - z260 - z264);
    const Scalar z266 = z155 * (z256 + z258 + z261) - z216 + z156 * (z257 - z260 - z264);
    const Scalar z267 = z214 + z165 * z261 + z160 * z264;
    const Scalar z268 = z170 * z261 - z217 + z166 * z264;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.beta = -z265;
    accelerations.Theta = -z266;
    accelerations.gamma = z259;
    accelerations.Phi = z262;
    accelerations.delta = -z263;
    accelerations.Omega = -z267;
    accelerations.epsilon = z268;
    multipliers.lambda_E3_x = -z256;
    multipliers.lambda_E3_y = z257;
    multipliers.lambda_E4_x = -z258;
    multipliers.lambda_E4_y = -z260;
    multipliers.lambda_E6_x = -z261;
    multipliers.lambda_E6_y = -z264;
    const Scalar bound0_ = roundings_ * z233;
    if (!(traits::regular(-z133, z103) && traits::regular(z142, k11) && traits::regular(z107, z107)
        && traits::regular(z136, k11) && traits::regular(z99, z99) && traits::regular(z253, bound0_)
        && traits::regular(z243, bound0_) && traits::regular(z226, bound0_) && traits::regular(-z200, bound0_)
        && traits::regular(z182, bound0_) && traits::regular(z169, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.beta * accelerations.Theta * accelerations.gamma * accelerations.Phi
        * accelerations.delta * accelerations.Omega * accelerations.epsilon * multipliers.lambda_E3_x
        * multipliers.lambda_E3_y * multipliers.lambda_E4_x * multipliers.lambda_E4_y * multipliers.lambda_E6_x
        * multipliers.lambda_E6_y;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    return Mechanism::forward_dynamics(precomputed, state, Inputs(), accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar k4 = traits::constant(0.00365, 0.00365f, "73/20000");
    const Scalar k5 = traits::constant(4.1975e-05, 4.1975e-05f, "1679/40000000");
    const Scalar k6 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar k7 = traits::constant(4.08774e-05, 4.08774e-05f, "204387/5000000000");
    const Scalar k8 = traits::constant(0.00706, 0.00706f, "353/50000");
    const Scalar k9 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k10 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k11 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k14 = traits::constant(0.07785, 0.07785f, "1557/20000");
    const Scalar k15 = traits::constant(1.1153034e-06, 1.1153033e-06f, "5576517/5000000000000");
    const Scalar k16 = traits::constant(8.0850737125e-06, 8.085074e-06f, "646805897/80000000000000");
    const Scalar k17 = traits::constant(2.7579868e-05, 2.7579868e-05f, "6894967/250000000000");
    const Scalar k18 = traits::constant(1.4259649165e-05, 1.4259649e-05f, "2851929833/200000000000000");
    const Scalar k19 = traits::constant(0.001825, 0.001825f, "73/40000");
    const Scalar k20 = traits::constant(0.00353, 0.00353f, "353/100000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n2265 = traits::constant(2265.0, 2265.0f, "2265/1");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar angles_[] = {q_Theta, q_gamma, q_Phi, q_Omega};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_Theta = sines_[0], c_Theta = cosines_[0];
    const Scalar s_gamma = sines_[1], c_gamma = cosines_[1];
    const Scalar s_Phi = sines_[2], c_Phi = cosines_[2];
    const Scalar s_Omega = sines_[3], c_Omega = cosines_[3];
    const Scalar z0 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z1 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z2 = n0_007 * v_beta;
    const Scalar z3 = n0_04 * v_epsilon;
    const Scalar z4 = c_Theta * z2;
    const Scalar z5 = n0_04 * v_delta;
    const Scalar z6 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z7 = s_Omega * z3;
    const Scalar z8 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z9 = s_Phi * z5;
    const Scalar z10 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z11 = s_Theta * z2;
    const Scalar z12 = c_Phi * z5;
    const Scalar z13 = c_Omega * z3;
    const Scalar z14 = k4 * z4 - k5 * z8;
    const Scalar z15 = k5 * z4 - k6 * z8;
    const Scalar z16 = k7 * z6 + k8 * z9;
    const Scalar z17 = k9 * z6 + k7 * z9;
    const Scalar z18 = k8 * z7 - k7 * z10;
    const Scalar z19 = k7 * z7 - k9 * z10;
    const Scalar z20 = k10 - z0;
    const Scalar z21 = k11 + z1;
    const Scalar z22 = n0_014 + z20;
    const Scalar z23 = n0_072 - z21;
    const Scalar z24 = z22 * z22 + z23 * z23;
    const Scalar z25 = traits::sqrt(z24);
    const Scalar z26 = k14 - z25;
    result.kinetic = k15 * v_beta * v_beta + k16 * v_gamma * v_gamma + k17 * v_delta * v_delta + k18 * v_epsilon
        * v_epsilon + k19 * z11 * z11 + k20 * (z12 * z12 + z13 * z13) + n0_5 * (z9 * z16 + z6 * z17 + z4 * z14 - z8
        * z15 + z7 * z18 - z10 * z19);
    result.force_function = -n2265 * z26 * z26;
    result.power = n0_033 * v_beta;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar k3 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k4 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k8 = traits::constant(0.06934, 0.06934f, "3467/50000");
    const Scalar k9 = traits::constant(0.00227, 0.00227f, "227/100000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z0 = v_beta * c_beta;
    const Scalar z1 = v_beta * s_beta;
    const Scalar z2 = n0_02 * s_Phi;
    const Scalar z3 = v_delta * s_delta;
    const Scalar z4 = n0_028 * c_Theta;
    const Scalar z5 = n0_028 * s_Theta;
    const Scalar z6 = n0_02 * c_Phi;
    const Scalar z7 = v_delta * c_delta;
    const Scalar z8 = v_Theta * c_Theta;
    const Scalar z9 = v_Theta * s_Theta;
    const Scalar z10 = v_Phi * s_Phi;
    const Scalar z11 = v_Phi * c_Phi;
    const Scalar z12 = v_gamma * c_gamma;
    const Scalar z13 = v_gamma * s_gamma;
    const Scalar z14 = n0_035 * s_gamma;
    const Scalar z15 = n0_035 * c_gamma;
    const Scalar z16 = k3 - z14;
    const Scalar z17 = k4 - z15;
    const Scalar z18 = n0_007 - z4;
    const Scalar z19 = s_beta * z5;
    const Scalar z20 = c_beta * z5;
    const Scalar z21 = n0_035 * z12;
    const Scalar z22 = n0_028 * z8;
    const Scalar z23 = n0_028 * z9;
    const Scalar z24 = v_gamma * z13;
    const Scalar z25 = v_Theta * z9;
    const Scalar z26 = v_Theta * z8;
    const Scalar z27 = v_beta * z1;
    const Scalar z28 = v_beta * z0;
    const Scalar z29 = n0_035 * z13;
    const Scalar z30 = v_gamma * z12;
    const Scalar z31 = n0_04 + z2;
    const Scalar z32 = s_delta * z6;
    const Scalar z33 = c_delta * z6;
    const Scalar z34 = n0_02 * z10;
    const Scalar z35 = n0_02 * z11;
    const Scalar z36 = v_Phi * z11;
    const Scalar z37 = v_Phi * z10;
    const Scalar z38 = v_delta * z3;
    const Scalar z39 = c_beta * z18 + z19;
    const Scalar z40 = v_delta * z7;
    const Scalar z41 = s_beta * z18 - z20;
    const Scalar z42 = z5 * z0 + s_beta * z22 + c_beta * z23 - z18 * z1;
    const Scalar z43 = s_beta * z4 + z20;
    const Scalar z44 = n0_035 * z24;
    const Scalar z45 = n0_028 * z25;
    const Scalar z46 = n0_028 * z26;
    const Scalar z47 = z5 * z1 + s_beta * z23 - c_beta * z22 + z18 * z0;
    const Scalar z48 = c_beta * z4 - z19;
    const Scalar z49 = n0_035 * z30;
    const Scalar z50 = c_delta * z31 + z32;
    const Scalar z51 = s_delta * z31 - z33;
    const Scalar z52 = s_delta * z34 - c_delta * z35 - z6 * z7 + z31 * z3;
    const Scalar z53 = s_delta * z2 - z33;
    const Scalar z54 = n0_02 * z36;
    const Scalar z55 = n0_02 * z37;
    const Scalar z56 = z5 * z27 + z18 * z28 + s_beta * z45 - c_beta * z46 - n2 * (z0 * z22 - z1 * z23);
    const Scalar z57 = z5 * z28 - z18 * z27 + s_beta * z46 + c_beta * z45 + n2 * (z0 * z23 + z22 * z1);
    const Scalar z58 = z16 + z39;
    const Scalar z59 = z17 - z41;
    const Scalar z60 = c_delta * z2 + z32;
    const Scalar z61 = z21 - z42;
    const Scalar z62 = z29 - z47;
    const Scalar z63 = k8 - z50;
    const Scalar z64 = z39 + z63;
    const Scalar z65 = z42 + z52;
    const Scalar z66 = v_Omega * s_Omega;
    const Scalar z67 = k9 - z51;
    const Scalar z68 = z41 + z67;
    const Scalar z69 = v_epsilon * s_epsilon;
    const Scalar z70 = n0_02 * c_Omega;
    const Scalar z71 = n0_02 * s_Omega;
    const Scalar z72 = z44 - z56;
    const Scalar z73 = z49 - z57;
    const Scalar z74 = v_Omega * z66;
    const Scalar z75 = n0_02 * z74;
    const Scalar z76 = n0_02 * z66;
    const Scalar z77 = v_epsilon * c_epsilon;
    const Scalar z78 = v_epsilon * z69;
    const Scalar z79 = v_Omega * c_Omega;
    const Scalar z80 = n0_04 - z71;
    const Scalar z81 = v_epsilon * z77;
    const Scalar z82 = v_Omega * z79;
    const Scalar z83 = n0_02 * z79;
    const Scalar z84 = c_epsilon * z70;
    const Scalar z85 = s_epsilon * z71 - z84;
    const Scalar z86 = n0_02 * z82;
    const Scalar z87 = s_epsilon * z80 + z84;
    const Scalar z88 = s_epsilon * z70;
    const Scalar z89 = c_epsilon * z71 + z88;
    const Scalar z90 = c_epsilon * z80 - z88;
    const Scalar z91 = k8 - z87;
    const Scalar z92 = z6 * z38 + z31 * z40 + s_delta * z54 + c_delta * z55 + n2 * (z7 * z34 + z3 * z35);
    const Scalar z93 = z31 * z38 - z6 * z40 + s_delta * z55 - c_delta * z54 - n2 * (z7 * z35 - z34 * z3);
    const Scalar z94 = z6 * z3 + s_delta * z35 + c_delta * z34 + z31 * z7;
    const Scalar z95 = z39 + z91;
    const Scalar z96 = k9 + z90;
    const Scalar z97 = z70 * z69 + s_epsilon * z83 + c_epsilon * z76 - z80 * z77;
    const Scalar z98 = z41 + z96;
    const Scalar z99 = s_epsilon * z75 - z70 * z81 - z80 * z78 - c_epsilon * z86 - n2 * (z77 * z83 - z69 * z76);
    const Scalar z100 = s_epsilon * z76 - c_epsilon * z83 - z70 * z77 - z80 * z69;
    const Scalar z101 = z70 * z78 - z80 * z81 + s_epsilon * z86 + c_epsilon * z75 + n2 * (z77 * z76 + z83 * z69);
    const Scalar z102 = z56 - z92;
    const Scalar z103 = z47 - z94;
    const Scalar z104 = z57 + z93;
    const Scalar z105 = z42 + z97;
    const Scalar z106 = z56 + z99;
    const Scalar z107 = z47 + z100;
    const Scalar z108 = z57 + z101;
    result.value[0] = z58;
    result.rate[0] = -z61;
    result.gamma[0] = z72;
    result.value[1] = -z59;
    result.rate[1] = -z62;
    result.gamma[1] = -z73;
    result.value[2] = z64;
    result.rate[2] = z65;
    result.gamma[2] = -z102;
    result.value[3] = z68;
    result.rate[3] = z103;
    result.gamma[3] = z104;
    result.value[4] = z95;
    result.rate[4] = z105;
    result.gamma[4] = -z106;
    result.value[5] = z98;
    result.rate[5] = z107;
    result.gamma[5] = z108;
    result.jacobian[0] = -z41;
    result.jacobian[1] = z39;
    result.jacobian[2] = -z41;
    result.jacobian[3] = z39;
    result.jacobian[4] = -z41;
    result.jacobian[5] = z39;
    result.jacobian[6] = z43;
    result.jacobian[7] = -z48;
    result.jacobian[8] = z43;
    result.jacobian[9] = -z48;
    result.jacobian[10] = z43;
    result.jacobian[11] = -z48;
    result.jacobian[12] = -z15;
    result.jacobian[13] = -z14;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z53;
    result.jacobian[21] = -z60;
    result.jacobian[22] = n0;
    result.jacobian[23] = n0;
    result.jacobian[24] = n0;
    result.jacobian[25] = n0;
    result.jacobian[26] = z51;
    result.jacobian[27] = -z50;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n0;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n0;
    result.jacobian[34] = z89;
    result.jacobian[35] = z85;
    result.jacobian[36] = n0;
    result.jacobian[37] = n0;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = -z90;
    result.jacobian[41] = -z87;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of beta,
  /// w those of the rates of beta;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar k7 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar k8 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k11 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k12 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k14 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k15 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k16 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k20 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k21 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k22 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k24 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k27 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar k28 = traits::constant(1082587.9264381505, 1082587.9f, "80000000000/73897");
    const Scalar k29 = traits::constant(1244740.7431948162, 1244740.8f, "500000000000000/401690073");
    const Scalar k30 = traits::constant(61842.35515712993, 61842.355f, "40000000000000/646805897");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar a_Theta = accelerations.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar a_Phi = accelerations.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar a_Omega = accelerations.Omega;
    const Scalar l_lambda_E3_x = multipliers.lambda_E3_x;
    const Scalar l_lambda_E3_y = multipliers.lambda_E3_y;
    const Scalar l_lambda_E4_x = multipliers.lambda_E4_x;
    const Scalar l_lambda_E4_y = multipliers.lambda_E4_y;
    const Scalar l_lambda_E6_x = multipliers.lambda_E6_x;
    const Scalar l_lambda_E6_y = multipliers.lambda_E6_y;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z0 = n0_035 * c_gamma;
    const Scalar z1 = n0_02 * c_Phi;
    const Scalar z2 = n0_02 * s_Phi;
    const Scalar z3 = n0_028 * s_Theta;
    const Scalar z4 = n0_028 * c_Theta;
    const Scalar z5 = n0_035 * s_gamma;
    const Scalar z6 = v_beta * c_beta;
    const Scalar z7 = v_beta * s_beta;
    const Scalar z8 = v_Theta * s_Theta;
    const Scalar z9 = v_Theta * c_Theta;
    const Scalar z10 = v_delta * c_delta;
    const Scalar z11 = v_Phi * s_Phi;
    const Scalar z12 = v_delta * s_delta;
    const Scalar z13 = v_Phi * c_Phi;
    const Scalar z14 = v_gamma * c_gamma;
    const Scalar z15 = v_gamma * s_gamma;
    const Scalar z16 = n0_007 - z4;
    const Scalar z17 = s_beta * z3;
    const Scalar z18 = c_beta * z3;
    const Scalar z19 = n0_035 * z14;
    const Scalar z20 = n0_028 * z9;
    const Scalar z21 = n0_028 * z8;
    const Scalar z22 = z3 * z6;
    const Scalar z23 = v_gamma * z15;
    const Scalar z24 = v_Theta * z8;
    const Scalar z25 = v_Theta * z9;
    const Scalar z26 = v_beta * z7;
    const Scalar z27 = v_beta * z6;
    const Scalar z28 = n0_035 * z15;
    const Scalar z29 = z3 * z7;
    const Scalar z30 = v_gamma * z14;
    const Scalar z31 = n0_04 + z2;
    const Scalar z32 = s_delta * z1;
    const Scalar z33 = c_delta * z1;
    const Scalar z34 = n0_02 * z11;
    const Scalar z35 = n0_02 * z13;
    const Scalar z36 = z1 * z10;
    const Scalar z37 = v_Phi * z13;
    const Scalar z38 = v_Phi * z11;
    const Scalar z39 = c_beta * z16 + z17;
    const Scalar z40 = v_delta * z12;
    const Scalar z41 = v_delta * z10;
    const Scalar z42 = s_beta * z16 - z18;
    const Scalar z43 = z1 * z12;
    const Scalar z44 = s_beta * z20;
    const Scalar z45 = s_beta * z4 + z18;
    const Scalar z46 = n0_035 * z23;
    const Scalar z47 = n0_028 * z24;
    const Scalar z48 = n0_028 * z25;
    const Scalar z49 = z3 * z26;
    const Scalar z50 = z7 * z21;
    const Scalar z51 = c_beta * z20;
    const Scalar z52 = c_beta * z4 - z17;
    const Scalar z53 = n0_035 * z30;
    const Scalar z54 = z3 * z27;
    const Scalar z55 = z6 * z21;
    const Scalar z56 = c_delta * z31 + z32;
    const Scalar z57 = s_delta * z31 - z33;
    const Scalar z58 = c_delta * z35;
    const Scalar z59 = s_delta * z2 - z33;
    const Scalar z60 = n0_02 * z37;
    const Scalar z61 = n0_02 * z38;
    const Scalar z62 = z1 * z40;
    const Scalar z63 = z10 * z34;
    const Scalar z64 = s_delta * z35;
    const Scalar z65 = c_delta * z2 + z32;
    const Scalar z66 = z1 * z41;
    const Scalar z67 = z34 * z12;
    const Scalar z68 = z22 + c_beta * z21 - z16 * z7 + z44;
    const Scalar z69 = n0_02 * c_Omega;
    const Scalar z70 = n0_02 * s_Omega;
    const Scalar z71 = s_epsilon * z69;
    const Scalar z72 = c_epsilon * z69;
    const Scalar z73 = n0_04 - z70;
    const Scalar z74 = v_epsilon * c_epsilon;
    const Scalar z75 = v_epsilon * s_epsilon;
    const Scalar z76 = v_Omega * s_Omega;
    const Scalar z77 = s_epsilon * z73 + z72;
    const Scalar z78 = c_epsilon * z73 - z71;
    const Scalar z79 = v_Omega * c_Omega;
    const Scalar z80 = n0_02 * z79;
    const Scalar z81 = z29 + s_beta * z21 + z16 * z6 - z51;
    const Scalar z82 = s_delta * z34 - z36 + z31 * z12 - z58;
    const Scalar z83 = z43 + c_delta * z34 + z31 * z10 + z64;
    const Scalar z84 = z49 + z16 * z27 + s_beta * z47 - c_beta * z48 - n2 * (z6 * z20 - z50);
    const Scalar z85 = n0_02 * z76;
    const Scalar z86 = z54 + s_beta * z48 - z16 * z26 + c_beta * z47 + n2 * (z20 * z7 + z55);
    const Scalar z87 = z62 + z31 * z41 + s_delta * z60 + c_delta * z61 + n2 * (z12 * z35 + z63);
    const Scalar z88 = z31 * z40 - z66 + s_delta * z61 - c_delta * z60 - n2 * (z10 * z35 - z67);
    const Scalar z89 = z46 - z84;
    const Scalar z90 = c_epsilon * z70 + z71;
    const Scalar z91 = z69 * z75;
    const Scalar z92 = s_epsilon * z80;
    const Scalar z93 = v_Omega * z76;
    const Scalar z94 = n0_02 * z93;
    const Scalar z95 = v_Omega * z79;
    const Scalar z96 = n0_02 * z95;
    const Scalar z97 = v_epsilon * z74;
    const Scalar z98 = v_epsilon * z75;
    const Scalar z99 = z91 + c_epsilon * z85 - z73 * z74 + z92;
    const Scalar z100 = z69 * z97;
    const Scalar z101 = z53 - z86;
    const Scalar z102 = s_epsilon * z70 - z72;
    const Scalar z103 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z104 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z105 = k7 - z103;
    const Scalar z106 = k8 + z104;
    const Scalar z107 = z69 * z74;
    const Scalar z108 = n0_014 + z105;
    const Scalar z109 = c_epsilon * z80;
    const Scalar z110 = s_epsilon * z85 - z107 - z73 * z75 - z109;
    const Scalar z111 = n0_072 - z106;
    const Scalar z112 = z69 * z98;
    const Scalar z113 = z108 * z108 + z111 * z111;
    const Scalar z114 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z115 = z75 * z85;
    const Scalar z116 = z74 * z85;
    const Scalar z117 = s_epsilon * z94 - z100 - z73 * z98 - c_epsilon * z96 - n2 * (z74 * z80 - z115);
    const Scalar z118 = traits::sqrt(z113);
    const Scalar z119 = z112 + s_epsilon * z96 - z73 * z97 + c_epsilon * z94 + n2 * (z80 * z75 + z116);
    const Scalar z120 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z121 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z122 = k11 * s_gamma + k12 * c_gamma;
    const Scalar z123 = k12 * s_gamma - k11 * c_gamma;
    const Scalar z124 = z84 - z87;
    const Scalar z125 = v_beta * v_beta;
    const Scalar z126 = n0_175 * z125;
    const Scalar z127 = n0_175 * a_beta;
    const Scalar z128 = z86 + z88;
    const Scalar z129 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z130 = z114 * z114;
    const Scalar z131 = k14 * z130;  // force on K2, times 0.04 m, x
    const Scalar z132 = s_Theta * z127 - c_Theta * z126;
    const Scalar z133 = s_Theta * z126 + c_Theta * z127;
    const Scalar z134 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z135 = v_delta * v_delta;
    const Scalar z136 = z120 * z120;
    const Scalar z137 = k15 * z136;  // force on K4, times 0.04 m, y
    const Scalar z138 = k15 * z134;  // force on K4, times 0.04 m, x
    const Scalar z139 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z140 = a_delta * c_Phi + s_Phi * z135;
    const Scalar z141 = a_delta * s_Phi - c_Phi * z135;
    const Scalar z142 = k16 * z134 + k15 * z141;  // moment on K4, z
    const Scalar z143 = v_epsilon * v_epsilon;
    const Scalar z144 = z121 * z121;
    const Scalar z145 = k15 * z144;  // force on K6, times 0.04 m, x
    const Scalar z146 = k15 * z139;  // force on K6, times 0.04 m, y
    const Scalar z147 = n1 / z118;
    const Scalar z148 = a_epsilon * c_Omega + s_Omega * z143;
    const Scalar z149 = a_epsilon * s_Omega - c_Omega * z143;
    const Scalar z150 = k15 * z149 - k16 * z139;  // moment on K6, z
    const Scalar z151 = n4530 - n352_6605 * z147;
    const Scalar z152 = s_Phi * z138 + c_Phi * z137;
    const Scalar z153 = s_Phi * z137 - c_Phi * z138;
    const Scalar z154 = k20 * a_delta + z152 + z142;  // moment on K5, z
    const Scalar z155 = s_Omega * z146 + c_Omega * z145;
    const Scalar z156 = s_Omega * z145 - c_Omega * z146;
    const Scalar z157 = k21 * a_epsilon - z155 - z150;  // moment on K7, z
    const Scalar z158 = n0_02 - z122;
    const Scalar z159 = z84 + z117;
    const Scalar z160 = k14 * z133 - k22 * z129;  // moment on K2, z
    const Scalar z161 = k14 * z129;  // force on K2, times 0.04 m, y
    const Scalar z162 = s_Theta * z161 + c_Theta * z131;
    const Scalar z163 = s_Theta * z131 - c_Theta * z161;
    const Scalar z164 = k15 * s_Omega;
    const Scalar z165 = k16 - n2 * z164;
    const Scalar z166 = n0_033 - k24 * a_beta - n0_175 * z163 + z160;  // moment on K1, z
    const Scalar z167 = k16 - z164;
    const Scalar z168 = z86 + z119;
    const Scalar z169 = k21 + z165;
    const Scalar z170 = k14 * c_Theta;
    const Scalar z171 = k22 - n0_35 * z170;
    const Scalar z172 = k22 - n0_175 * z170;
    const Scalar z173 = k15 * s_Phi;
    const Scalar z174 = k16 + n2 * z173;
    const Scalar z175 = k16 + z173;
    const Scalar z176 = k24 + z171;
    const Scalar z177 = n2 * v_beta;
    const Scalar z178 = n0_175 * z177;
    const Scalar z179 = n0_018 - z123;
    const Scalar z180 = n2 * z114;
    const Scalar z181 = k14 * z180;
    const Scalar z182 = k20 + z174;
    const Scalar z183 = z158 * z151;
    const Scalar z184 = s_Theta * z178;
    const Scalar z185 = z39 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z42 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    const Scalar z186 = s_Theta * z181;
    const Scalar z187 = n0_175 * z186;
    const Scalar z188 = k14 * z184;
    const Scalar z189 = z179 * z151;
    const Scalar z190 = n0_018 * z183 - n0_02 * z189;
    const Scalar z191 = n2 * (z103 * z111 - z104 * z108);
    const Scalar z192 = k14 * z132;
    const Scalar z193 = n0_5 * z191 / z118;
    const Scalar z194 = n0_175 * z162 + z192;
    const Scalar z195 = k15 * z140;
    const Scalar z196 = n2 * z120;
    const Scalar z197 = k15 * z148;
    const Scalar z198 = z45 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z192 + z52 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z199 = z45 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z194 + z52 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z200 = k15 * z196;
    const Scalar z201 = c_Phi * z200;
    const Scalar z202 = z153 - z195;
    const Scalar z203 = k27 * a_gamma + z190;  // moment on K3, z
    const Scalar z204 = n2 * z8;
    const Scalar z205 = n2 * z9;
    const Scalar z206 = n0_028 * z204;
    const Scalar z207 = z193 / (z118 * z118);
    const Scalar z208 = n0_028 * z205;
    const Scalar z209 = z86 + a_beta * z39 - a_Theta * z52;
    const Scalar z210 = z84 + a_beta * z42 - a_Theta * z45;
    const Scalar z211 = a_beta * z42 - a_Theta * z45 + a_gamma * z0 - z89;
    const Scalar z212 = a_beta * z39 - a_Theta * z52 - a_gamma * z5 - z101;
    const Scalar z213 = n2 * z121;
    const Scalar z214 = a_beta * z42 - a_Theta * z45 - a_delta * z57 - a_Phi * z59 + z124;
    const Scalar z215 = n352_6605 * z207;
    const Scalar z216 = z123 * z151 - z158 * z215;
    const Scalar z217 = z122 * z151 + z179 * z215;
    const Scalar z218 = a_beta * z39 - a_Theta * z52 - a_delta * z56 - a_Phi * z65 + z128;
    const Scalar z219 = n0_018 * z216 + n0_02 * z217;
    const Scalar z220 = k15 * z213;
    const Scalar z221 = z156 - z197;
    const Scalar z222 = a_beta * z42 - a_Theta * z45 + a_epsilon * z78 - a_Omega * z90 + z159;
    const Scalar z223 = a_beta * z39 - a_Theta * z52 - a_epsilon * z77 + a_Omega * z102 + z168;
    const Scalar z224 = c_Omega * z220;
    const Scalar z225 = l_lambda_E3_x * z5 - z219 - l_lambda_E3_y * z0;
    const Scalar z226 = z29 + s_beta * z21 - z4 * z6 - z51;
    const Scalar z227 = n2 * z7;
    const Scalar z228 = n2 * z6;
    const Scalar z229 = z3 * z227 + z16 * z228 + n2 * (s_beta * z21 - z51);
    const Scalar z230 = z3 * z228 - z16 * z227 + n2 * (c_beta * z21 + z44);
    const Scalar z231 = l_lambda_E4_y * z59;
    const Scalar z232 = l_lambda_E4_x * z65 - z195 + z231;
    const Scalar z233 = l_lambda_E4_x * z65 + z231 + z202;
    const Scalar z234 = l_lambda_E4_x * z65 + z231;
    const Scalar z235 = n2 * v_delta;
    const Scalar z236 = c_Phi * z235;
    const Scalar z237 = l_lambda_E6_y * z90;
    const Scalar z238 = l_lambda_E6_x * z102 - z197 - z237;
    const Scalar z239 = l_lambda_E6_x * z102 - z237 + z221;
    const Scalar z240 = k15 * z236;
    const Scalar z241 = l_lambda_E6_x * z102 - z237;
    const Scalar z242 = z45 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z52 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    const Scalar z243 = n2 * v_epsilon;
    const Scalar z244 = c_Omega * z243;
    const Scalar z245 = z188 - z187;
    const Scalar z246 = z54 + z4 * z26 + s_beta * z48 + c_beta * z47 + n2 * (z20 * z7 + z55);
    const Scalar z247 = z49 + s_beta * z47 - z4 * z27 - c_beta * z48 - n2 * (z6 * z20 - z50);
    const Scalar z248 = z62 + z2 * z41 + s_delta * z60 + c_delta * z61 + n2 * (z12 * z35 + z63);
    const Scalar z249 = z2 * z40 - z66 + s_delta * z61 - c_delta * z60 - n2 * (z10 * z35 - z67);
    const Scalar z250 = z22 + z4 * z7 + c_beta * z21 + z44;
    const Scalar z251 = s_beta * z206 - n2 * (z4 * z6 - z29) - c_beta * z208;
    const Scalar z252 = s_beta * z208 + c_beta * z206 + n2 * (z4 * z7 + z22);
    const Scalar z253 = n2 * z11;
    const Scalar z254 = z52 * (a_beta + a_Theta) - z246;
    const Scalar z255 = z45 * (a_beta + a_Theta) - z247;
    const Scalar z256 = n2 * z13;
    const Scalar z257 = n0_02 * z253;
    const Scalar z258 = n2 * z15;
    const Scalar z259 = n2 * z14;
    const Scalar z260 = n0_02 * z256;
    const Scalar z261 = n0_035 * z258;
    const Scalar z262 = a_gamma * z5 + z53;
    const Scalar z263 = n0_035 * z259;
    const Scalar z264 = a_gamma * z0 - z46;
    const Scalar z265 = z59 * (a_delta + a_Phi) + z248;
    const Scalar z266 = z65 * (a_delta + a_Phi) - z249;
    const Scalar z267 = k15 * z244;
    const Scalar z268 = z43 + z2 * z10 + c_delta * z34 + z64;
    const Scalar z269 = s_delta * z260 + c_delta * z257 + n2 * (z2 * z10 + z43);
    const Scalar z270 = s_delta * z257 - c_delta * z260 + n2 * (z2 * z12 - z36);
    const Scalar z271 = z2 * z12 - z36 + s_delta * z34 - z58;
    const Scalar z272 = n2 * z12;
    const Scalar z273 = n2 * z10;
    const Scalar z274 = z201 - z240;
    const Scalar z275 = z1 * z272 + z31 * z273 + n2 * (c_delta * z34 + z64);
    const Scalar z276 = l_lambda_E4_x * z56 + l_lambda_E4_y * z57;
    const Scalar z277 = z31 * z272 - z1 * z273 + n2 * (s_delta * z34 - z58);
    const Scalar z278 = z112 + z70 * z97 + s_epsilon * z96 + c_epsilon * z94 + n2 * (z80 * z75 + z116);
    const Scalar z279 = n2 * z76;
    const Scalar z280 = n2 * z79;
    const Scalar z281 = n0_02 * z279;
    const Scalar z282 = n0_02 * z280;
    const Scalar z283 = z87 + a_delta * z57 + a_Phi * z59;
    const Scalar z284 = a_delta * z56 - z88 + a_Phi * z65;
    const Scalar z285 = z102 * (a_epsilon + a_Omega) + z278;
    const Scalar z286 = z70 * z75;
    const Scalar z287 = s_epsilon * z85 - z107 + z286 - z109;
    const Scalar z288 = s_epsilon * z281 - n2 * (z107 - z286) - c_epsilon * z282;
    const Scalar z289 = z91 + z70 * z74 + c_epsilon * z85 + z92;
    const Scalar z290 = z224 - z267;
    const Scalar z291 = s_epsilon * z282 + c_epsilon * z281 + n2 * (z70 * z74 + z91);
    const Scalar z292 = l_lambda_E6_x * z77 - l_lambda_E6_y * z78;
    const Scalar z293 = z70 * z98 - z100 + s_epsilon * z94 - c_epsilon * z96 - n2 * (z74 * z80 - z115);
    const Scalar z294 = n2 * z75;
    const Scalar z295 = n2 * z74;
    const Scalar z296 = a_epsilon * z77 - z119 - a_Omega * z102;
    const Scalar z297 = z117 + a_epsilon * z78 - a_Omega * z90;
    const Scalar z298 = n2 * (s_epsilon * z85 - z109) - z69 * z295 - z73 * z294;
    const Scalar z299 = z69 * z294 - z73 * z295 + n2 * (c_epsilon * z85 + z92);
    const Scalar z300 = z90 * (a_epsilon + a_Omega) - z293;
    const Scalar z301 = n1 / z0;
    const Scalar z302 = z5 * z301;
    const Scalar z303 = n1 / z90;
    const Scalar z304 = n1 / z59;
    const Scalar z305 = z102 * z303;
    const Scalar z306 = z65 * z304;
    const Scalar z307 = z42 * z42;
    const Scalar z308 = z45 * z302 + z52;
    const Scalar z309 = z77 - z78 * z305;
    const Scalar z310 = z56 - z57 * z306;
    const Scalar z311 = z45 * z305 + z52;
    const Scalar z312 = z308 * z308;
    const Scalar z313 = n1 / z308;
    const Scalar z314 = z309 * z309;
    const Scalar z315 = n1 / z309;
    const Scalar z316 = z310 * z310;
    const Scalar z317 = n1 / z310;
    const Scalar z318 = z45 * z306 - z52;
    const Scalar z319 = z39 + z42 * z302;
    const Scalar z320 = z39 * z39;
    const Scalar z321 = k28 * z45;
    const Scalar z322 = k28 * z52;
    const Scalar z323 = z90 * z90;
    const Scalar z324 = z45 * z321 + z78 * z78 / z169 + z307 / z176 + k29 * z323;
    const Scalar z325 = z59 * z59;
    const Scalar z326 = z45 * z321 + z57 * z57 / z182 + z307 / z176 + k29 * z325;
    const Scalar z327 = z311 * z313;
    const Scalar z328 = z318 * z313;
    const Scalar z329 = z313 * z319;
    const Scalar z330 = k16 * z324;
    const Scalar z331 = k16 * z326;
    const Scalar z332 = z39 + z42 * z305 - z327 * z319;
    const Scalar z333 = z39 - z42 * z306 + z328 * z319;
    const Scalar z334 = z317 * z333;
    const Scalar z335 = z315 * z332;
    const Scalar z336 = z42 - z45 * z329;
    const Scalar z337 = z301 * z336;
    const Scalar z338 = z42 - z45 * z329 + z78 * z335;
    const Scalar z339 = z42 - z45 * z329 - z57 * z334;
    const Scalar z340 = z303 * z338;
    const Scalar z341 = z304 * z339;
    const Scalar z342 = z81 + z226 * z329 + z28 * z337;
    const Scalar z343 = z81 + z226 * z329 + z110 * z335 + z287 * z340;
    const Scalar z344 = z81 + z226 * z329 - z83 * z334 - z268 * z341;
    const Scalar z345 = z68 + z250 * z329 + z82 * z334 + z271 * z341;
    const Scalar z346 = z68 + z250 * z329 + z99 * z335 + z289 * z340;
    const Scalar z347 = z68 + z250 * z329 + z19 * z337;
    const Scalar z348 = z302 * z342 + z347;
    const Scalar z349 = z229 + z251 * z329 + z261 * z337;
    const Scalar z350 = z230 + z252 * z329 + z263 * z337;
    const Scalar z351 = z346 + z305 * z343 - z327 * z348;
    const Scalar z352 = z306 * z344 - z345 - z328 * z348;
    const Scalar z353 = z313 * z348;
    const Scalar z354 = z45 * z353 - z342;
    const Scalar z355 = z317 * z352;
    const Scalar z356 = z315 * z351;
    const Scalar z357 = z45 * z353 - z343 - z78 * z356;
    const Scalar z358 = z301 * z354;
    const Scalar z359 = z45 * z353 - z344 - z57 * z355;
    const Scalar z360 = z302 * z349 + z350;
    const Scalar z361 = z313 * z360;
    const Scalar z362 = z304 * z359;
    const Scalar z363 = z303 * z357;
    const Scalar z364 = z229 + z251 * z329 - z275 * z334 - z269 * z341;
    const Scalar z365 = z45 * z361 - z349;
    const Scalar z366 = z229 + z251 * z329 + z298 * z335 + z288 * z340;
    const Scalar z367 = z301 * z365;
    const Scalar z368 = z230 + z252 * z329 + z277 * z334 + z270 * z341;
    const Scalar z369 = z230 + z252 * z329 + z299 * z335 + z291 * z340;
    const Scalar z370 = z306 * z364 - z368 - z328 * z360;
    const Scalar z371 = z369 + z305 * z366 - z327 * z360;
    const Scalar z372 = z0 * z0;
    const Scalar z373 = z45 * z321 + z307 / z176 + k30 * z372;
    const Scalar z374 = z317 * z370;
    const Scalar z375 = z320 / z176 + k30 * z5 * z5 + z52 * z322;
    const Scalar z376 = k27 * z373;
    const Scalar z377 = k22 * z375;
    const Scalar z378 = z251 * z353;
    const Scalar z379 = z378 + z275 * z355 + z269 * z362;
    const Scalar z380 = z288 * z363 - z378 - z298 * z356;
    const Scalar z381 = z261 * z358 - z378;
    const Scalar z382 = z252 * z353;
    const Scalar z383 = z263 * z358 - z382;
    const Scalar z384 = z277 * z355 - z382 + z270 * z362;
    const Scalar z385 = z315 * z371;
    const Scalar z386 = z45 * z361 - z364 - z57 * z374;
    const Scalar z387 = z304 * z386;
    const Scalar z388 = z45 * z361 - z366 - z78 * z385;
    const Scalar z389 = z303 * z388;
    const Scalar z390 = z52 * z322 + z77 * z77 / z169 + k29 * z102 * z102 + z320 / z176;
    const Scalar z391 = z291 * z363 - z382 - z299 * z356;
    const Scalar z392 = z52 * z322 + z56 * z56 / z182 + k29 * z65 * z65 + z320 / z176;
    const Scalar z393 = z169 * z390;
    const Scalar z394 = z209 - z254 * z329 - z284 * z334 - z266 * z341;
    const Scalar z395 = z182 * z392;
    const Scalar z396 = z210 - z255 * z329 - z283 * z334 - z265 * z341;
    const Scalar z397 = z384 + z396;
    const Scalar z398 = z185 - z199 * z329;
    const Scalar z399 = z209 - z254 * z329 - z296 * z335 + z285 * z340;
    const Scalar z400 = z209 - z254 * z329 + z262 * z337;
    const Scalar z401 = z381 - z400;
    const Scalar z402 = z210 - z255 * z329 + z297 * z335 - z300 * z340;
    const Scalar z403 = z210 - z255 * z329 - z264 * z337;
    const Scalar z404 = z383 + z403;
    const Scalar z405 = z242 + z198 * z329;
    const Scalar z406 = z379 + z394;
    const Scalar z407 = z380 - z399;
    const Scalar z408 = z391 + z402;
    const Scalar z409 = z234 * z334 + z232 * z341;
    const Scalar z410 = z241 * z335 + z238 * z340;
    const Scalar z411 = z276 * z334 + z233 * z341;
    const Scalar z412 = z239 * z340 - z292 * z335;
    const Scalar z413 = z172 * z329 + z176;
    const Scalar z414 = z172 + k22 * z329;
    const Scalar z415 = z302 * z401 + z404;
    const Scalar z416 = z211 * z302 + z212;
    const Scalar z417 = z160 + z45 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z52 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y);
    const Scalar z418 = z187 * z353;
    const Scalar z419 = z418 + z398;
    const Scalar z420 = z187 * z329 - z245;
    const Scalar z421 = z182 * z334 + z175 * z341;
    const Scalar z422 = z169 * z335 + z167 * z340;
    const Scalar z423 = z397 + z328 * z415 + z306 * z406;
    const Scalar z424 = z214 * z306 - z218 - z328 * z416;
    const Scalar z425 = z175 * z334 + k16 * z341;
    const Scalar z426 = z317 * z423;
    const Scalar z427 = z317 * z424;
    const Scalar z428 = z408 + z305 * z407 - z327 * z415;
    const Scalar z429 = z222 * z305 + z223 - z327 * z416;
    const Scalar z430 = l_lambda_E4_x * z59 - z142 - l_lambda_E4_y * z65;
    const Scalar z431 = z203 + l_lambda_E3_x * z0 + l_lambda_E3_y * z5;
    const Scalar z432 = l_lambda_E4_x * z57 - z154 - l_lambda_E4_y * z56;
    const Scalar z433 = z313 * z415;
    const Scalar z434 = z313 * z416;
    const Scalar z435 = z45 * z433 - z401;
    const Scalar z436 = z45 * z434 - z211;
    const Scalar z437 = z274 * z355 + z201 * z362;
    const Scalar z438 = z437 + z411;
    const Scalar z439 = z274 * z334 + z201 * z341;
    const Scalar z440 = z240 * z355;
    const Scalar z441 = z440 - z409;
    const Scalar z442 = z301 * z435;
    const Scalar z443 = z301 * z436;
    const Scalar z444 = z240 * z334;
    const Scalar z445 = z167 * z335 + k16 * z340;
    const Scalar z446 = z315 * z428;
    const Scalar z447 = z150 + l_lambda_E6_x * z90 + l_lambda_E6_y * z102;
    const Scalar z448 = z157 + l_lambda_E6_x * z78 + l_lambda_E6_y * z77;
    const Scalar z449 = z42 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z166 - z39 * (l_lambda_E3_y
        + l_lambda_E4_y + l_lambda_E6_y) - z329 * z417 - z334 * z432 + z335 * z448 - z341 * z430 - z340 * z447 - z337
        * z431;
    const Scalar z450 = z315 * z429;
    const Scalar z451 = z45 * z433 + z406 + z57 * z426;
    const Scalar z452 = z45 * z434 - z214 - z57 * z427;
    const Scalar z453 = z224 * z363 - z290 * z356;
    const Scalar z454 = z453 + z412;
    const Scalar z455 = z290 * z335 + z224 * z340;
    const Scalar z456 = z267 * z356;
    const Scalar z457 = z456 + z410;
    const Scalar z458 = z267 * z335;
    const Scalar z459 = z188 * z329 - z420 + z341 * z444 - z340 * z458 - z334 * z439 + z335 * z455;
    const Scalar z460 = z304 * z451;
    const Scalar z461 = z304 * z452;
    const Scalar z462 = z45 * z433 - z407 - z78 * z446;
    const Scalar z463 = z45 * z434 - z222 - z78 * z450;
    const Scalar z464 = z303 * z462;
    const Scalar z465 = z303 * z463;
    const Scalar z466 = z225 * z337;
    const Scalar z467 = z329 * z405 - z419 - z341 * z441 - z340 * z457 + z334 * z438 - z335 * z454 + z337 * z466;
    const Scalar z468 = k27 * z337;
    const Scalar z469 = z329 * z414 + z413 + z337 * z468 + z334 * z421 + z335 * z422 + z341 * z425 + z340 * z445;
    const Scalar z470 = z367 * z468 - z361 * z414 + z374 * z421 - z385 * z422 + z387 * z425 + z389 * z445;
    const Scalar z471 = z433 * z414 - z442 * z468 + z426 * z421 + z446 * z422 - z460 * z425 - z464 * z445;
    const Scalar z472 = z443 * z468 - z434 * z414 + z427 * z421 - z450 * z422 + z461 * z425 + z465 * z445;
    const Scalar z473 = z471 + z467;
    const Scalar z474 = z470 + z459;
    const Scalar z475 = n1 / z469;
    const Scalar z476 = z449 - z472;
    const Scalar z477 = z473 * z475;
    const Scalar z478 = z474 * z475;
    result.M[0] = z176;
    result.M[1] = z172;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = z172;
    result.M[8] = k22;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n0;
    result.M[15] = n0;
    result.M[16] = k27;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = n0;
    result.M[22] = n0;
    result.M[23] = n0;
    result.M[24] = k16;
    result.M[25] = z175;
    result.M[26] = n0;
    result.M[27] = n0;
    result.M[28] = n0;
    result.M[29] = n0;
    result.M[30] = n0;
    result.M[31] = z175;
    result.M[32] = z182;
    result.M[33] = n0;
    result.M[34] = n0;
    result.M[35] = n0;
    result.M[36] = n0;
    result.M[37] = n0;
    result.M[38] = n0;
    result.M[39] = n0;
    result.M[40] = k16;
    result.M[41] = z167;
    result.M[42] = n0;
    result.M[43] = n0;
    result.M[44] = n0;
    result.M[45] = n0;
    result.M[46] = n0;
    result.M[47] = z167;
    result.M[48] = z169;
    result.C[0] = -z245;
    result.C[1] = -z188;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = z187;
    result.C[8] = n0;
    result.C[9] = n0;
    result.C[10] = n0;
    result.C[11] = n0;
    result.C[12] = n0;
    result.C[13] = n0;
    result.C[14] = n0;
    result.C[15] = n0;
    result.C[16] = n0;
    result.C[17] = n0;
    result.C[18] = n0;
    result.C[19] = n0;
    result.C[20] = n0;
    result.C[21] = n0;
    result.C[22] = n0;
    result.C[23] = n0;
    result.C[24] = n0;
    result.C[25] = z201;
    result.C[26] = n0;
    result.C[27] = n0;
    result.C[28] = n0;
    result.C[29] = n0;
    result.C[30] = n0;
    result.C[31] = -z240;
    result.C[32] = z274;
    result.C[33] = n0;
    result.C[34] = n0;
    result.C[35] = n0;
    result.C[36] = n0;
    result.C[37] = n0;
    result.C[38] = n0;
    result.C[39] = n0;
    result.C[40] = n0;
    result.C[41] = -z224;
    result.C[42] = n0;
    result.C[43] = n0;
    result.C[44] = n0;
    result.C[45] = n0;
    result.C[46] = n0;
    result.C[47] = z267;
    result.C[48] = -z290;
    result.K[0] = z185;
    result.K[1] = -z242;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = -z199;
    result.K[8] = -z198;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = -z225;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = -z232;
    result.K[25] = -z233;
    result.K[26] = n0;
    result.K[27] = n0;
    result.K[28] = n0;
    result.K[29] = n0;
    result.K[30] = n0;
    result.K[31] = -z234;
    result.K[32] = -z276;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.K[36] = n0;
    result.K[37] = n0;
    result.K[38] = n0;
    result.K[39] = n0;
    result.K[40] = z238;
    result.K[41] = z239;
    result.K[42] = n0;
    result.K[43] = n0;
    result.K[44] = n0;
    result.K[45] = n0;
    result.K[46] = n0;
    result.K[47] = z241;
    result.K[48] = -z292;
    result.F[0] = -z42 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z166 + z39 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    result.F[1] = z160 + z45 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z52 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    result.F[2] = -z203 - l_lambda_E3_x * z0 - l_lambda_E3_y * z5;
    result.F[3] = l_lambda_E4_x * z59 - z142 - l_lambda_E4_y * z65;
    result.F[4] = l_lambda_E4_x * z57 - z154 - l_lambda_E4_y * z56;
    result.F[5] = z150 + l_lambda_E6_x * z90 + l_lambda_E6_y * z102;
    result.F[6] = -z157 - l_lambda_E6_x * z78 - l_lambda_E6_y * z77;
    result.M_r[0] = z469;
    result.C_r[0] = -z474;
    result.K_r[0] = -z473;
    result.F_r[0] = -z476;
    result.A[0] = n0;
    result.A[1] = z477;
    result.A[2] = n1;
    result.A[3] = z478;
    if (!(traits::regular(z323, z330) && traits::regular(z325, z331) && traits::regular(z372, z376)
        && traits::regular(z312, z377) && traits::regular(z314, z393) && traits::regular(z316, z395)
        && traits::regular(z469, z469))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.M[0] * result.M[1] * result.M[7] * result.M[25] * result.M[31] * result.M[32]
        * result.M[41] * result.M[47] * result.M[48] * result.C[0] * result.C[1]) * (n0 * result.C[7] * result.C[25]
        * result.C[31] * result.C[32] * result.C[41] * result.C[47] * result.C[48] * result.K[0] * result.K[1]
        * result.K[7] * result.K[8])) * ((n0 * result.K[16] * result.K[24] * result.K[25] * result.K[31] * result.K[32]
        * result.K[40] * result.K[41] * result.K[47] * result.K[48] * result.F[0] * result.F[1]) * (n0 * result.F[2]
        * result.F[3] * result.F[4] * result.F[5] * result.F[6] * result.M_r[0] * result.C_r[0] * result.K_r[0]
        * result.F_r[0] * result.A[1] * result.A[3]));
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, multipliers, Inputs(), result);
  }

  /// Residual of the equations of motion, zero along motions:
  /// r = (M a + h - A' lambda - E u, A a + gamma).
  TORSOR_DEVICE static void residual(const Precomputed&, const State& state, const Accelerations& accelerations,
      const Multipliers& multipliers, const Inputs&, std::array<Scalar, 13>& residual) noexcept {
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar k7 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar k9 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k10 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar k11 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k13 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k14 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k16 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar k17 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar n0_033 = traits::constant(0.033, 0.033f, "33/1000");
    const Scalar k19 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar k20 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar k24 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k25 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar a_Theta = accelerations.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar a_Phi = accelerations.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar a_Omega = accelerations.Omega;
    const Scalar l_lambda_E3_x = multipliers.lambda_E3_x;
    const Scalar l_lambda_E3_y = multipliers.lambda_E3_y;
    const Scalar l_lambda_E4_x = multipliers.lambda_E4_x;
    const Scalar l_lambda_E4_y = multipliers.lambda_E4_y;
    const Scalar l_lambda_E6_x = multipliers.lambda_E6_x;
    const Scalar l_lambda_E6_y = multipliers.lambda_E6_y;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z0 = v_beta * c_beta;
    const Scalar z1 = v_beta * s_beta;
    const Scalar z2 = n0_02 * s_Phi;
    const Scalar z3 = v_delta * s_delta;
    const Scalar z4 = n0_028 * c_Theta;
    const Scalar z5 = n0_028 * s_Theta;
    const Scalar z6 = n0_02 * c_Phi;
    const Scalar z7 = v_delta * c_delta;
    const Scalar z8 = n0_02 * c_Omega;
    const Scalar z9 = n0_02 * s_Omega;
    const Scalar z10 = v_Theta * c_Theta;
    const Scalar z11 = v_Theta * s_Theta;
    const Scalar z12 = v_Phi * s_Phi;
    const Scalar z13 = v_Phi * c_Phi;
    const Scalar z14 = v_gamma * c_gamma;
    const Scalar z15 = v_gamma * s_gamma;
    const Scalar z16 = n0_035 * s_gamma;
    const Scalar z17 = n0_035 * c_gamma;
    const Scalar z18 = n0_007 - z4;
    const Scalar z19 = s_beta * z5;
    const Scalar z20 = v_epsilon * c_epsilon;
    const Scalar z21 = c_beta * z5;
    const Scalar z22 = n0_028 * z10;
    const Scalar z23 = n0_028 * z11;
    const Scalar z24 = v_gamma * z15;
    const Scalar z25 = v_Theta * z11;
    const Scalar z26 = v_Theta * z10;
    const Scalar z27 = v_beta * z1;
    const Scalar z28 = v_beta * z0;
    const Scalar z29 = v_gamma * z14;
    const Scalar z30 = n0_04 + z2;
    const Scalar z31 = s_delta * z6;
    const Scalar z32 = c_delta * z6;
    const Scalar z33 = n0_02 * z12;
    const Scalar z34 = n0_02 * z13;
    const Scalar z35 = v_Phi * z13;
    const Scalar z36 = v_Phi * z12;
    const Scalar z37 = v_delta * z3;
    const Scalar z38 = v_delta * z7;
    const Scalar z39 = n0_04 - z9;
    const Scalar z40 = c_epsilon * z8;
    const Scalar z41 = s_epsilon * z8;
    const Scalar z42 = c_beta * z18 + z19;
    const Scalar z43 = v_Omega * c_Omega;
    const Scalar z44 = n0_02 * z43;
    const Scalar z45 = s_beta * z18 - z21;
    const Scalar z46 = v_Omega * z43;
    const Scalar z47 = v_Omega * s_Omega;
    const Scalar z48 = v_epsilon * s_epsilon;
    const Scalar z49 = n0_02 * z47;
    const Scalar z50 = v_Omega * z47;
    const Scalar z51 = s_beta * z4 + z21;
    const Scalar z52 = v_epsilon * z48;
    const Scalar z53 = v_epsilon * z20;
    const Scalar z54 = n0_035 * z24;
    const Scalar z55 = n0_028 * z25;
    const Scalar z56 = n0_028 * z26;
    const Scalar z57 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z58 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z59 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z60 = c_beta * z4 - z19;
    const Scalar z61 = n0_035 * z29;
    const Scalar z62 = c_delta * z30 + z31;
    const Scalar z63 = s_delta * z30 - z32;
    const Scalar z64 = s_delta * z2 - z32;
    const Scalar z65 = n0_02 * z35;
    const Scalar z66 = n0_02 * z36;
    const Scalar z67 = c_delta * z2 + z31;
    const Scalar z68 = s_epsilon * z39 + z40;
    const Scalar z69 = c_epsilon * z39 - z41;
    const Scalar z70 = c_epsilon * z9 + z41;
    const Scalar z71 = n0_02 * z50;
    const Scalar z72 = n0_02 * z46;
    const Scalar z73 = s_epsilon * z9 - z40;
    const Scalar z74 = z5 * z27 + z18 * z28 + s_beta * z55 - c_beta * z56 - n2 * (z0 * z22 - z1 * z23);
    const Scalar z75 = z5 * z28 - z18 * z27 + s_beta * z56 + c_beta * z55 + n2 * (z0 * z23 + z22 * z1);
    const Scalar z76 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z77 = z6 * z37 + z30 * z38 + s_delta * z65 + c_delta * z66 + n2 * (z7 * z33 + z3 * z34);
    const Scalar z78 = z30 * z37 - z6 * z38 + s_delta * z66 - c_delta * z65 - n2 * (z7 * z34 - z33 * z3);
    const Scalar z79 = z54 - z74;
    const Scalar z80 = k7 - z76;
    const Scalar z81 = n0_014 + z80;
    const Scalar z82 = z61 - z75;
    const Scalar z83 = z74 - z77;
    const Scalar z84 = z59 * z59;
    const Scalar z85 = k9 * z84;  // force on K6, times 0.04 m, x
    const Scalar z86 = z75 + z78;
    const Scalar z87 = a_beta * z45 - a_Theta * z51 - a_delta * z63 - a_Phi * z64 + z83;
    const Scalar z88 = a_beta * z42 - a_Theta * z60 - a_delta * z62 - a_Phi * z67 + z86;
    const Scalar z89 = a_beta * z45 - a_Theta * z51 + a_gamma * z17 - z79;
    const Scalar z90 = a_beta * z42 - a_Theta * z60 - a_gamma * z16 - z82;
    const Scalar z91 = z57 * z57;
    const Scalar z92 = z58 * z58;
    const Scalar z93 = k10 * z91;  // force on K2, times 0.04 m, x
    const Scalar z94 = k9 * z92;  // force on K4, times 0.04 m, y
    const Scalar z95 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z96 = k11 + z95;
    const Scalar z97 = v_beta * v_beta;
    const Scalar z98 = n0_175 * z97;
    const Scalar z99 = k13 * s_gamma + k14 * c_gamma;
    const Scalar z100 = n0_072 - z96;
    const Scalar z101 = n0_02 - z99;
    const Scalar z102 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z103 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z104 = k14 * s_gamma - k13 * c_gamma;
    const Scalar z105 = z81 * z81 + z100 * z100;
    const Scalar z106 = n0_018 - z104;
    const Scalar z107 = n0_175 * a_beta;
    const Scalar z108 = s_Theta * z98 + c_Theta * z107;
    const Scalar z109 = traits::sqrt(z105);
    const Scalar z110 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z111 = v_epsilon * v_epsilon;
    const Scalar z112 = a_epsilon * s_Omega - c_Omega * z111;
    const Scalar z113 = k10 * z108 - k16 * z110;  // moment on K2, z
    const Scalar z114 = k10 * z110;  // force on K2, times 0.04 m, y
    const Scalar z115 = s_Theta * z93 - c_Theta * z114;
    const Scalar z116 = k9 * z112 - k17 * z103;  // moment on K6, z
    const Scalar z117 = k9 * z103;  // force on K6, times 0.04 m, y
    const Scalar z118 = s_Omega * z117 + c_Omega * z85;
    const Scalar z119 = n0_033 - k19 * a_beta - n0_175 * z115 + z113;  // moment on K1, z
    const Scalar z120 = k9 * z102;  // force on K4, times 0.04 m, x
    const Scalar z121 = s_Phi * z120 + c_Phi * z94;
    const Scalar z122 = v_delta * v_delta;
    const Scalar z123 = a_delta * s_Phi - c_Phi * z122;
    const Scalar z124 = k20 * a_epsilon - z118 - z116;  // moment on K7, z
    const Scalar z125 = n1 / z109;
    const Scalar z126 = s_epsilon * z71 - z8 * z53 - z39 * z52 - c_epsilon * z72 - n2 * (z20 * z44 - z48 * z49);
    const Scalar z127 = z8 * z52 - z39 * z53 + s_epsilon * z72 + c_epsilon * z71 + n2 * (z20 * z49 + z44 * z48);
    const Scalar z128 = n4530 - n352_6605 * z125;
    const Scalar z129 = z74 + z126;
    const Scalar z130 = z75 + z127;
    const Scalar z131 = k17 * z102 + k9 * z123;  // moment on K4, z
    const Scalar z132 = k24 * a_delta + z121 + z131;  // moment on K5, z
    const Scalar z133 = z101 * z128;
    const Scalar z134 = z106 * z128;
    const Scalar z135 = a_beta * z45 - a_Theta * z51 + a_epsilon * z69 - a_Omega * z70 + z129;
    const Scalar z136 = n0_018 * z133 - n0_02 * z134;
    const Scalar z137 = a_beta * z42 - a_Theta * z60 - a_epsilon * z68 + a_Omega * z73 + z130;
    const Scalar z138 = k25 * a_gamma + z136;  // moment on K3, z
    residual[0] = z45 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) - z119 - z42 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    residual[1] = -z113 - z51 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z60 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    residual[2] = z138 + l_lambda_E3_x * z17 + l_lambda_E3_y * z16;
    residual[3] = -l_lambda_E4_x * z64 + z131 + l_lambda_E4_y * z67;
    residual[4] = -l_lambda_E4_x * z63 + z132 + l_lambda_E4_y * z62;
    residual[5] = -z116 - l_lambda_E6_x * z70 - l_lambda_E6_y * z73;
    residual[6] = z124 + l_lambda_E6_x * z69 + l_lambda_E6_y * z68;
    residual[7] = -z89;
    residual[8] = z90;
    residual[9] = -z87;
    residual[10] = z88;
    residual[11] = -z135;
    residual[12] = z137;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void residual(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, std::array<Scalar, 13>& residual) noexcept {
    Mechanism::residual(precomputed, state, accelerations, multipliers, Inputs(), residual);
  }

  /// Derivatives of residual by (q, v, a, lambda) without those that vanish identically: `values` of
  /// compressed rows. r = (M a + h - A' lambda - E u, A a + gamma).
  TORSOR_DEVICE static void residual_jacobian(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      ResidualJacobian& result) noexcept {
    const Scalar n0_028 = traits::constant(0.028, 0.028f, "7/250");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_035 = traits::constant(0.035, 0.035f, "7/200");
    const Scalar n0_007 = traits::constant(0.007, 0.007f, "7/1000");
    const Scalar n0_04 = traits::constant(0.04, 0.04f, "1/25");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_018 = traits::constant(0.018, 0.018f, "9/500");
    const Scalar k7 = traits::constant(0.03635, 0.03635f, "727/20000");
    const Scalar n0_014 = traits::constant(0.014, 0.014f, "7/500");
    const Scalar k9 = traits::constant(0.03273, 0.03273f, "3273/100000");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k11 = traits::constant(0.03927, 0.03927f, "3927/100000");
    const Scalar k12 = traits::constant(0.05035, 0.05035f, "1007/20000");
    const Scalar n0_175 = traits::constant(0.175, 0.175f, "7/40");
    const Scalar k14 = traits::constant(1.635096e-06, 1.635096e-06f, "204387/125000000000");
    const Scalar k15 = traits::constant(1.679e-06, 1.679e-06f, "1679/1000000000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n4530 = traits::constant(4530.0, 4530.0f, "4530/1");
    const Scalar n352_6605 = traits::constant(352.6605, 352.6605f, "705321/2000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k20 = traits::constant(8.03380146e-07, 8.0338015e-07f, "401690073/500000000000000");
    const Scalar k21 = traits::constant(3.981529833e-05, 3.98153e-05f, "3981529833/100000000000000");
    const Scalar k22 = traits::constant(6.6455736e-05, 6.645574e-05f, "8306967/125000000000");
    const Scalar k23 = traits::constant(9.237125e-07, 9.237125e-07f, "73897/80000000000");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar k25 = traits::constant(2.4094568e-06, 2.4094568e-06f, "3011821/1250000000000");
    const Scalar k26 = traits::constant(1.6170147425e-05, 1.6170148e-05f, "646805897/40000000000000");
    const Scalar q_beta = state.q.beta;
    const Scalar v_beta = state.v.beta;
    const Scalar a_beta = accelerations.beta;
    const Scalar q_Theta = state.q.Theta;
    const Scalar v_Theta = state.v.Theta;
    const Scalar a_Theta = accelerations.Theta;
    const Scalar q_gamma = state.q.gamma;
    const Scalar v_gamma = state.v.gamma;
    const Scalar a_gamma = accelerations.gamma;
    const Scalar q_delta = state.q.delta;
    const Scalar v_delta = state.v.delta;
    const Scalar a_delta = accelerations.delta;
    const Scalar q_Phi = state.q.Phi;
    const Scalar v_Phi = state.v.Phi;
    const Scalar a_Phi = accelerations.Phi;
    const Scalar q_epsilon = state.q.epsilon;
    const Scalar v_epsilon = state.v.epsilon;
    const Scalar a_epsilon = accelerations.epsilon;
    const Scalar q_Omega = state.q.Omega;
    const Scalar v_Omega = state.v.Omega;
    const Scalar a_Omega = accelerations.Omega;
    const Scalar l_lambda_E3_x = multipliers.lambda_E3_x;
    const Scalar l_lambda_E3_y = multipliers.lambda_E3_y;
    const Scalar l_lambda_E4_x = multipliers.lambda_E4_x;
    const Scalar l_lambda_E4_y = multipliers.lambda_E4_y;
    const Scalar l_lambda_E6_x = multipliers.lambda_E6_x;
    const Scalar l_lambda_E6_y = multipliers.lambda_E6_y;
    const Scalar angles_[] = {q_beta, q_Theta, q_gamma, q_delta, q_Phi, q_epsilon, q_Omega};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_beta = sines_[0], c_beta = cosines_[0];
    const Scalar s_Theta = sines_[1], c_Theta = cosines_[1];
    const Scalar s_gamma = sines_[2], c_gamma = cosines_[2];
    const Scalar s_delta = sines_[3], c_delta = cosines_[3];
    const Scalar s_Phi = sines_[4], c_Phi = cosines_[4];
    const Scalar s_epsilon = sines_[5], c_epsilon = cosines_[5];
    const Scalar s_Omega = sines_[6], c_Omega = cosines_[6];
    const Scalar z0 = v_beta * c_beta;
    const Scalar z1 = v_Theta * c_Theta;
    const Scalar z2 = v_beta * s_beta;
    const Scalar z3 = v_delta * c_delta;
    const Scalar z4 = v_delta * s_delta;
    const Scalar z5 = n0_028 * c_Theta;
    const Scalar z6 = n0_028 * s_Theta;
    const Scalar z7 = n0_02 * s_Phi;
    const Scalar z8 = n0_02 * c_Phi;
    const Scalar z9 = v_Theta * s_Theta;
    const Scalar z10 = v_Phi * s_Phi;
    const Scalar z11 = v_Phi * c_Phi;
    const Scalar z12 = v_gamma * c_gamma;
    const Scalar z13 = v_gamma * s_gamma;
    const Scalar z14 = n0_035 * s_gamma;
    const Scalar z15 = n0_035 * c_gamma;
    const Scalar z16 = n0_02 * c_Omega;
    const Scalar z17 = n0_02 * s_Omega;
    const Scalar z18 = n0_007 - z5;
    const Scalar z19 = s_beta * z6;
    const Scalar z20 = c_beta * z6;
    const Scalar z21 = n0_028 * z1;
    const Scalar z22 = n0_028 * z9;
    const Scalar z23 = v_gamma * z13;
    const Scalar z24 = v_Theta * z9;
    const Scalar z25 = v_Theta * z1;
    const Scalar z26 = v_beta * z2;
    const Scalar z27 = v_beta * z0;
    const Scalar z28 = v_gamma * z12;
    const Scalar z29 = n0_04 + z7;
    const Scalar z30 = s_delta * z8;
    const Scalar z31 = c_delta * z8;
    const Scalar z32 = n0_02 * z10;
    const Scalar z33 = n0_02 * z11;
    const Scalar z34 = v_Phi * z11;
    const Scalar z35 = v_Phi * z10;
    const Scalar z36 = v_delta * z4;
    const Scalar z37 = v_delta * z3;
    const Scalar z38 = n0_04 - z17;
    const Scalar z39 = c_epsilon * z16;
    const Scalar z40 = c_beta * z18 + z19;
    const Scalar z41 = s_epsilon * z16;
    const Scalar z42 = s_beta * z18 - z20;
    const Scalar z43 = v_epsilon * c_epsilon;
    const Scalar z44 = v_Omega * c_Omega;
    const Scalar z45 = v_epsilon * s_epsilon;
    const Scalar z46 = v_Omega * s_Omega;
    const Scalar z47 = n0_02 * z44;
    const Scalar z48 = n0_02 * z46;
    const Scalar z49 = s_beta * z5 + z20;
    const Scalar z50 = v_Omega * z46;
    const Scalar z51 = v_Omega * z44;
    const Scalar z52 = n0_035 * z23;
    const Scalar z53 = v_epsilon * z43;
    const Scalar z54 = n0_028 * z24;
    const Scalar z55 = v_epsilon * z45;
    const Scalar z56 = n0_028 * z25;
    const Scalar z57 = z6 * z26;
    const Scalar z58 = z2 * z22;
    const Scalar z59 = c_beta * z5 - z19;
    const Scalar z60 = n0_035 * z28;
    const Scalar z61 = z6 * z27;
    const Scalar z62 = z0 * z22;
    const Scalar z63 = c_delta * z29 + z30;
    const Scalar z64 = s_delta * z29 - z31;
    const Scalar z65 = s_delta * z7 - z31;
    const Scalar z66 = n0_02 * z34;
    const Scalar z67 = n0_02 * z35;
    const Scalar z68 = z8 * z36;
    const Scalar z69 = z3 * z32;
    const Scalar z70 = c_delta * z7 + z30;
    const Scalar z71 = z8 * z37;
    const Scalar z72 = z32 * z4;
    const Scalar z73 = s_epsilon * z38 + z39;
    const Scalar z74 = c_epsilon * z38 - z41;
    const Scalar z75 = n0_02 * z50;
    const Scalar z76 = n0_02 * z51;
    const Scalar z77 = c_epsilon * z17 + z41;
    const Scalar z78 = s_epsilon * z17 - z39;
    const Scalar z79 = z16 * z53;
    const Scalar z80 = z16 * z55;
    const Scalar z81 = z45 * z48;
    const Scalar z82 = z43 * z48;
    const Scalar z83 = z57 + z18 * z27 + s_beta * z54 - c_beta * z56 - n2 * (z0 * z21 - z58);
    const Scalar z84 = n0_018 * s_gamma + n0_02 * c_gamma;
    const Scalar z85 = n0_02 * s_gamma - n0_018 * c_gamma;
    const Scalar z86 = v_beta + v_Theta;  // angular velocity of K2, z
    const Scalar z87 = v_delta + v_Phi;  // angular velocity of K4, z
    const Scalar z88 = v_epsilon + v_Omega;  // angular velocity of K6, z
    const Scalar z89 = z61 + s_beta * z56 - z18 * z26 + c_beta * z54 + n2 * (z21 * z2 + z62);
    const Scalar z90 = k7 - z84;
    const Scalar z91 = n0_014 + z90;
    const Scalar z92 = k9 + z85;
    const Scalar z93 = n0_072 - z92;
    const Scalar z94 = k11 * s_gamma + k12 * c_gamma;
    const Scalar z95 = k12 * s_gamma - k11 * c_gamma;
    const Scalar z96 = z91 * z91 + z93 * z93;
    const Scalar z97 = v_beta * v_beta;
    const Scalar z98 = n0_175 * z97;
    const Scalar z99 = n0_175 * a_beta;
    const Scalar z100 = a_beta + a_Theta;  // angular acceleration of K2, z
    const Scalar z101 = n0_02 - z94;
    const Scalar z102 = n0_018 - z95;
    const Scalar z103 = v_delta * v_delta;
    const Scalar z104 = s_Theta * z99 - c_Theta * z98;
    const Scalar z105 = traits::sqrt(z96);
    const Scalar z106 = a_delta * c_Phi + s_Phi * z103;
    const Scalar z107 = v_epsilon * v_epsilon;
    const Scalar z108 = a_epsilon * c_Omega + s_Omega * z107;
    const Scalar z109 = a_delta + a_Phi;  // angular acceleration of K4, z
    const Scalar z110 = a_epsilon + a_Omega;  // angular acceleration of K6, z
    const Scalar z111 = z68 + z29 * z37 + s_delta * z66 + c_delta * z67 + n2 * (z4 * z33 + z69);
    const Scalar z112 = k14 * z110;  // force on K6, times 0.04 m, y
    const Scalar z113 = z88 * z88;
    const Scalar z114 = k14 * z113;  // force on K6, times 0.04 m, x
    const Scalar z115 = z29 * z36 - z71 + s_delta * z67 - c_delta * z66 - n2 * (z3 * z33 - z72);
    const Scalar z116 = s_Omega * z114 - c_Omega * z112;
    const Scalar z117 = k15 * z100;  // force on K2, times 0.04 m, y
    const Scalar z118 = k14 * z109;  // force on K4, times 0.04 m, x
    const Scalar z119 = n1 / z105;
    const Scalar z120 = z86 * z86;
    const Scalar z121 = k15 * z120;  // force on K2, times 0.04 m, x
    const Scalar z122 = z87 * z87;
    const Scalar z123 = k14 * z122;  // force on K4, times 0.04 m, y
    const Scalar z124 = n2 * v_beta;
    const Scalar z125 = n0_175 * z124;
    const Scalar z126 = s_epsilon * z75 - z79 - z38 * z55 - c_epsilon * z76 - n2 * (z43 * z47 - z81);
    const Scalar z127 = s_Theta * z117 + c_Theta * z121;
    const Scalar z128 = s_Phi * z123 - c_Phi * z118;
    const Scalar z129 = n4530 - n352_6605 * z119;
    const Scalar z130 = n2 * z86;
    const Scalar z131 = k15 * z130;
    const Scalar z132 = s_Theta * z125;
    const Scalar z133 = k15 * z132;
    const Scalar z134 = z80 + s_epsilon * z76 - z38 * z53 + c_epsilon * z75 + n2 * (z47 * z45 + z82);
    const Scalar z135 = n2 * (z84 * z93 - z85 * z91);
    const Scalar z136 = n0_5 * z135 / z105;
    const Scalar z137 = k15 * z104;
    const Scalar z138 = n2 * z87;
    const Scalar z139 = n2 * z88;
    const Scalar z140 = n0_175 * z127 + z137;
    const Scalar z141 = z49 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z137 + z59 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z142 = z49 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) - z140 + z59 * (l_lambda_E3_x
        + l_lambda_E4_x + l_lambda_E6_x);
    const Scalar z143 = k14 * z106;
    const Scalar z144 = k14 * z108;
    const Scalar z145 = s_Theta * z131;
    const Scalar z146 = k14 * z138;
    const Scalar z147 = k14 * z139;
    const Scalar z148 = n0_175 * z145;
    const Scalar z149 = c_Phi * z146;
    const Scalar z150 = z128 - z143;
    const Scalar z151 = c_Omega * z147;
    const Scalar z152 = z133 - z148;
    const Scalar z153 = z136 / (z105 * z105);
    const Scalar z154 = z116 - z144;
    const Scalar z155 = z40 * (l_lambda_E3_x + l_lambda_E4_x + l_lambda_E6_x) + z42 * (l_lambda_E3_y + l_lambda_E4_y
        + l_lambda_E6_y);
    const Scalar z156 = z49 * (l_lambda_E3_y + l_lambda_E4_y + l_lambda_E6_y) + z59 * (l_lambda_E3_x + l_lambda_E4_x
        + l_lambda_E6_x);
    const Scalar z157 = l_lambda_E4_x * z63 + l_lambda_E4_y * z64;
    const Scalar z158 = n2 * v_delta;
    const Scalar z159 = c_Phi * z158;
    const Scalar z160 = n2 * v_epsilon;
    const Scalar z161 = c_Omega * z160;
    const Scalar z162 = k14 * s_Omega;
    const Scalar z163 = n352_6605 * z153;
    const Scalar z164 = k20 - z162;
    const Scalar z165 = k20 - n2 * z162;
    const Scalar z166 = k14 * z159;
    const Scalar z167 = k14 * z161;
    const Scalar z168 = z95 * z129 - z101 * z163;
    const Scalar z169 = z94 * z129 + z102 * z163;
    const Scalar z170 = z149 - z166;
    const Scalar z171 = z151 - z167;
    const Scalar z172 = n0_018 * z168 + n0_02 * z169;
    const Scalar z173 = k21 + z165;
    const Scalar z174 = z89 + a_beta * z40 - a_Theta * z59;
    const Scalar z175 = l_lambda_E6_x * z73 - l_lambda_E6_y * z74;
    const Scalar z176 = k14 * s_Phi;
    const Scalar z177 = k20 + z176;
    const Scalar z178 = k20 + n2 * z176;
    const Scalar z179 = l_lambda_E3_x * z14 - z172 - l_lambda_E3_y * z15;
    const Scalar z180 = n2 * z2;
    const Scalar z181 = k22 + z178;
    const Scalar z182 = z83 + a_beta * z42 - a_Theta * z49;
    const Scalar z183 = n2 * z0;
    const Scalar z184 = z6 * z180 + z18 * z183 + n2 * (s_beta * z22 - c_beta * z21);
    const Scalar z185 = k15 * c_Theta;
    const Scalar z186 = z6 * z183 - z18 * z180 + n2 * (s_beta * z21 + c_beta * z22);
    const Scalar z187 = k23 - n0_175 * z185;
    const Scalar z188 = z61 + z5 * z26 + s_beta * z56 + c_beta * z54 + n2 * (z21 * z2 + z62);
    const Scalar z189 = k23 - n0_35 * z185;
    const Scalar z190 = z59 * (a_beta + a_Theta) - z188;
    const Scalar z191 = k25 + z189;
    const Scalar z192 = z57 + s_beta * z54 - z5 * z27 - c_beta * z56 - n2 * (z0 * z21 - z58);
    const Scalar z193 = z7 * z36 - z71 + s_delta * z67 - c_delta * z66 - n2 * (z3 * z33 - z72);
    const Scalar z194 = z68 + z7 * z37 + s_delta * z66 + c_delta * z67 + n2 * (z4 * z33 + z69);
    const Scalar z195 = z49 * (a_beta + a_Theta) - z192;
    const Scalar z196 = a_gamma * z14 + z60;
    const Scalar z197 = a_gamma * z15 - z52;
    const Scalar z198 = a_delta * z63 - z115 + a_Phi * z70;
    const Scalar z199 = z70 * (a_delta + a_Phi) - z193;
    const Scalar z200 = z65 * (a_delta + a_Phi) + z194;
    const Scalar z201 = n2 * z9;
    const Scalar z202 = n2 * z1;
    const Scalar z203 = n2 * z11;
    const Scalar z204 = n2 * z10;
    const Scalar z205 = n0_028 * z201;
    const Scalar z206 = n0_028 * z202;
    const Scalar z207 = n0_02 * z203;
    const Scalar z208 = n0_02 * z204;
    const Scalar z209 = n2 * z13;
    const Scalar z210 = n0_035 * z209;
    const Scalar z211 = n2 * z12;
    const Scalar z212 = n0_035 * z211;
    const Scalar z213 = s_beta * z205 - n2 * (z5 * z0 - z6 * z2) - c_beta * z206;
    const Scalar z214 = s_beta * z206 + c_beta * z205 + n2 * (z5 * z2 + z6 * z0);
    const Scalar z215 = s_delta * z207 + c_delta * z208 + n2 * (z7 * z3 + z8 * z4);
    const Scalar z216 = s_delta * z208 - c_delta * z207 + n2 * (z7 * z4 - z8 * z3);
    const Scalar z217 = l_lambda_E4_y * z65;
    const Scalar z218 = l_lambda_E4_x * z70 - z143 + z217;
    const Scalar z219 = z111 + a_delta * z64 + a_Phi * z65;
    const Scalar z220 = z80 + z17 * z53 + s_epsilon * z76 + c_epsilon * z75 + n2 * (z47 * z45 + z82);
    const Scalar z221 = l_lambda_E4_x * z70 + z217 + z150;
    const Scalar z222 = l_lambda_E4_x * z70 + z217;
    const Scalar z223 = z17 * z55 - z79 + s_epsilon * z75 - c_epsilon * z76 - n2 * (z43 * z47 - z81);
    const Scalar z224 = z78 * (a_epsilon + a_Omega) + z220;
    const Scalar z225 = z77 * (a_epsilon + a_Omega) - z223;
    const Scalar z226 = n2 * z46;
    const Scalar z227 = n2 * z44;
    const Scalar z228 = n2 * z4;
    const Scalar z229 = n0_02 * z226;
    const Scalar z230 = n0_02 * z227;
    const Scalar z231 = n2 * z3;
    const Scalar z232 = z8 * z228 + z29 * z231 + n2 * (s_delta * z33 + c_delta * z32);
    const Scalar z233 = z29 * z228 - z8 * z231 + n2 * (s_delta * z32 - c_delta * z33);
    const Scalar z234 = l_lambda_E6_y * z77;
    const Scalar z235 = l_lambda_E6_x * z78 - z144 - z234;
    const Scalar z236 = n2 * z45;
    const Scalar z237 = n2 * z43;
    const Scalar z238 = l_lambda_E6_x * z78 - z234 + z154;
    const Scalar z239 = l_lambda_E6_x * z78 - z234;
    const Scalar z240 = s_epsilon * z229 - n2 * (z16 * z43 - z17 * z45) - c_epsilon * z230;
    const Scalar z241 = s_epsilon * z230 + c_epsilon * z229 + n2 * (z16 * z45 + z17 * z43);
    const Scalar z242 = a_epsilon * z73 - z134 - a_Omega * z78;
    const Scalar z243 = n2 * (s_epsilon * z48 - c_epsilon * z47) - z16 * z237 - z38 * z236;
    const Scalar z244 = z126 + a_epsilon * z74 - a_Omega * z77;
    const Scalar z245 = z16 * z236 - z38 * z237 + n2 * (s_epsilon * z47 + c_epsilon * z48);
    result.values[0] = z155;
    result.values[1] = -z142;
    result.values[2] = -z152;
    result.values[3] = z148;
    result.values[4] = z191;
    result.values[5] = z187;
    result.values[6] = z42;
    result.values[7] = -z40;
    result.values[8] = z42;
    result.values[9] = -z40;
    result.values[10] = z42;
    result.values[11] = -z40;
    result.values[12] = -z156;
    result.values[13] = -z141;
    result.values[14] = -z133;
    result.values[15] = z187;
    result.values[16] = k23;
    result.values[17] = -z49;
    result.values[18] = z59;
    result.values[19] = -z49;
    result.values[20] = z59;
    result.values[21] = -z49;
    result.values[22] = z59;
    result.values[23] = -z179;
    result.values[24] = k26;
    result.values[25] = z15;
    result.values[26] = z14;
    result.values[27] = -z218;
    result.values[28] = -z222;
    result.values[29] = -z166;
    result.values[30] = k20;
    result.values[31] = z177;
    result.values[32] = -z65;
    result.values[33] = z70;
    result.values[34] = -z221;
    result.values[35] = -z157;
    result.values[36] = z149;
    result.values[37] = z170;
    result.values[38] = z177;
    result.values[39] = z181;
    result.values[40] = -z64;
    result.values[41] = z63;
    result.values[42] = z235;
    result.values[43] = z239;
    result.values[44] = z167;
    result.values[45] = k20;
    result.values[46] = z164;
    result.values[47] = -z77;
    result.values[48] = -z78;
    result.values[49] = z238;
    result.values[50] = -z175;
    result.values[51] = -z151;
    result.values[52] = -z171;
    result.values[53] = z164;
    result.values[54] = z173;
    result.values[55] = z74;
    result.values[56] = z73;
    result.values[57] = -z174;
    result.values[58] = z190;
    result.values[59] = z196;
    result.values[60] = -z184;
    result.values[61] = -z213;
    result.values[62] = z210;
    result.values[63] = -z42;
    result.values[64] = z49;
    result.values[65] = -z15;
    result.values[66] = -z182;
    result.values[67] = z195;
    result.values[68] = -z197;
    result.values[69] = z186;
    result.values[70] = z214;
    result.values[71] = -z212;
    result.values[72] = z40;
    result.values[73] = -z59;
    result.values[74] = -z14;
    result.values[75] = -z174;
    result.values[76] = z190;
    result.values[77] = z199;
    result.values[78] = z198;
    result.values[79] = -z184;
    result.values[80] = -z213;
    result.values[81] = z215;
    result.values[82] = z232;
    result.values[83] = -z42;
    result.values[84] = z49;
    result.values[85] = z65;
    result.values[86] = z64;
    result.values[87] = -z182;
    result.values[88] = z195;
    result.values[89] = z200;
    result.values[90] = z219;
    result.values[91] = z186;
    result.values[92] = z214;
    result.values[93] = z216;
    result.values[94] = z233;
    result.values[95] = z40;
    result.values[96] = -z59;
    result.values[97] = -z70;
    result.values[98] = -z63;
    result.values[99] = -z174;
    result.values[100] = z190;
    result.values[101] = -z224;
    result.values[102] = z242;
    result.values[103] = -z184;
    result.values[104] = -z213;
    result.values[105] = -z240;
    result.values[106] = -z243;
    result.values[107] = -z42;
    result.values[108] = z49;
    result.values[109] = z77;
    result.values[110] = -z74;
    result.values[111] = -z182;
    result.values[112] = z195;
    result.values[113] = z225;
    result.values[114] = -z244;
    result.values[115] = z186;
    result.values[116] = z214;
    result.values[117] = z241;
    result.values[118] = z245;
    result.values[119] = z40;
    result.values[120] = -z59;
    result.values[121] = z78;
    result.values[122] = -z73;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void residual_jacobian(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, ResidualJacobian& result) noexcept {
    Mechanism::residual_jacobian(precomputed, state, accelerations, multipliers, Inputs(), result);
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 49>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, Constraints&>(constraints));
    visitor(Description::kernels[7],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
    visitor(Description::kernels[8],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, std::array<Scalar, 13>&>(residual));
    visitor(Description::kernels[9],
        KernelFunction<void, const Accelerations&, const Multipliers&, const Inputs&, ResidualJacobian&>(residual_jacobian));
  }
};

}  // namespace andrews_squeezer
