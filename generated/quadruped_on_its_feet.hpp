// SPDX-License-Identifier: MIT-0
// quadruped_on_its_feet
// Made by torsor 0.1.0 from quadruped.urdf; change that and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, forward_dynamics, energy, contacts, contact_coefficients
// Parameters set at run time: ground_friction, ground_restitution
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                 307              402          0             0                 12       0    733     747
//   bias                        380              504          0             0                 12       0    908     926
//   forward_dynamics            938             1168         14             0                 12       0   2144    2186
//   energy                      352              469          0             0                 16       0    853     980
//   contacts                    984             1273          0             0                 12       0   2281    2414
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 324 results 114 vanish identically, 96 repeat another up to sign
//   contacts: of 244 results 132 vanish identically
//   contact_coefficients: of 20 results 8 vanish identically, 10 repeat another up to sign
//
// Angles and axes that were made exact:
//   1.5707963267948966 is pi/2: link front_left_thigh_link (rpy), link front_right_thigh_link (rpy), link rear_left_thigh_link (rpy), link rear_right_thigh_link (rpy)
//
// To write this file again:
//   torsor generate quadruped.urdf --base floating --ground front_left_foot,front_right_foot,rear_left_foot,rear_right_foot --ground-friction 0.6 --name quadruped_on_its_feet --initial 'trunk_z=0.45,trunk_x'\''=0.5,front_left_thigh=0.7,front_left_knee=-1.4,front_right_thigh=0.7,front_right_knee=-1.4,rear_left_thigh=0.7,rear_left_knee=-1.4,rear_right_thigh=0.7,rear_right_knee=-1.4' --kernels mass_matrix,bias,forward_dynamics,energy,contacts,contact_coefficients --support torsor_support.hpp --output quadruped_on_its_feet.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace quadruped_on_its_feet {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 19> coordinates{{{"trunk_x", "m"}, {"trunk_y", "m"},
      {"trunk_z", "m"}, {"trunk_attitude_w", "1"}, {"trunk_attitude_x", "1"}, {"trunk_attitude_y", "1"},
      {"trunk_attitude_z", "1"}, {"front_left_hip", "rad"}, {"front_left_thigh", "rad"}, {"front_left_knee", "rad"},
      {"front_right_hip", "rad"}, {"front_right_thigh", "rad"}, {"front_right_knee", "rad"}, {"rear_left_hip", "rad"},
      {"rear_left_thigh", "rad"}, {"rear_left_knee", "rad"}, {"rear_right_hip", "rad"}, {"rear_right_thigh", "rad"},
      {"rear_right_knee", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 18> velocities{{{"trunk_x", "m/s"}, {"trunk_y", "m/s"},
      {"trunk_z", "m/s"}, {"trunk_attitude_omega_x", "rad/s"}, {"trunk_attitude_omega_y", "rad/s"},
      {"trunk_attitude_omega_z", "rad/s"}, {"front_left_hip", "rad/s"}, {"front_left_thigh", "rad/s"},
      {"front_left_knee", "rad/s"}, {"front_right_hip", "rad/s"}, {"front_right_thigh", "rad/s"}, {"front_right_knee",
      "rad/s"}, {"rear_left_hip", "rad/s"}, {"rear_left_thigh", "rad/s"}, {"rear_left_knee", "rad/s"},
      {"rear_right_hip", "rad/s"}, {"rear_right_thigh", "rad/s"}, {"rear_right_knee", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 12> inputs{{{"front_left_hip_torque", "N m"},
      {"front_left_thigh_torque", "N m"}, {"front_left_knee_torque", "N m"}, {"front_right_hip_torque", "N m"},
      {"front_right_thigh_torque", "N m"}, {"front_right_knee_torque", "N m"}, {"rear_left_hip_torque", "N m"},
      {"rear_left_thigh_torque", "N m"}, {"rear_left_knee_torque", "N m"}, {"rear_right_hip_torque", "N m"},
      {"rear_right_thigh_torque", "N m"}, {"rear_right_knee_torque", "N m"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"ground_friction", "1"},
      {"ground_restitution", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 17> results{{{"rates", "", 19, 1, 1,
      "m/s, m/s, m/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s, rad/s"},
      {"mass", "", 18, 18, 2, ""}, {"forces", "", 18, 1, 1,
      "N, N, N, N m, N m, N m, N m, N m, N m, N m, N m, N m, N m, N m, N m, N m, N m, N m"}, {"accelerations", "", 18,
      1, 1,
      "m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2"},
      {"multipliers", "", 0, 1, 1, ""}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"},
      {"result", "power", 1, 1, 0, "W"}, {"result", "gap", 4, 1, 1, "m"}, {"result", "rate", 12, 1, 1, "m/s"},
      {"result", "jacobian", 12, 18, 2, ""}, {"result", "drift", 12, 1, 1, "m/s^2"}, {"result", "friction", 4, 1, 1,
      "1"}, {"result", "static_friction", 4, 1, 1, "1"}, {"result", "restitution", 4, 1, 1, "1"}, {"result", "bound", 4,
      1, 1, ""}, {"result", "static_bound", 4, 1, 1, ""}}};
  static constexpr std::array<torsor::KernelDescription, 7> kernels{{{"coordinate_rates", false, false, false, false,
      results.data() + 0, 1}, {"mass_matrix", false, false, false, false, results.data() + 1, 1}, {"bias", false, false,
      false, false, results.data() + 2, 1}, {"forward_dynamics", false, false, true, true, results.data() + 3, 2},
      {"energy", false, false, true, false, results.data() + 5, 3}, {"contacts", false, false, false, false,
      results.data() + 8, 4}, {"contact_coefficients", false, false, false, false, results.data() + 12, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::quadruped_on_its_feet::Description;

  static constexpr const char* name = "quadruped_on_its_feet";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xe1df57263c2ec268ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 19;
  static constexpr int velocity_count = 18;
  static constexpr int input_count = 12;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;
  /// Indices in q of the first components (w) of the unit quaternions (w, x, y, z).
  static constexpr int quaternion_count = 1;
  static constexpr int quaternions[quaternion_count] = {3};
  /// Range of each freedom, largest rate and largest effort, by its index in v; infinite where the scene states none.
  /// Data: no kernel looks at them.
  struct Limits { double lower, upper, velocity, effort; };
  static constexpr Limits limits[velocity_count] = {
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_x
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_y
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_z
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_attitude_omega_x
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_attitude_omega_y
      {-HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL},  // trunk_attitude_omega_z
      {-0.8, 0.8, 20.0, 25.0},  // front_left_hip
      {-1.5, 3.0, 20.0, 25.0},  // front_left_thigh
      {-2.7, -0.3, 20.0, 40.0},  // front_left_knee
      {-0.8, 0.8, 20.0, 25.0},  // front_right_hip
      {-1.5, 3.0, 20.0, 25.0},  // front_right_thigh
      {-2.7, -0.3, 20.0, 40.0},  // front_right_knee
      {-0.8, 0.8, 20.0, 25.0},  // rear_left_hip
      {-1.5, 3.0, 20.0, 25.0},  // rear_left_thigh
      {-2.7, -0.3, 20.0, 40.0},  // rear_left_knee
      {-0.8, 0.8, 20.0, 25.0},  // rear_right_hip
      {-1.5, 3.0, 20.0, 25.0},  // rear_right_thigh
      {-2.7, -0.3, 20.0, 40.0},  // rear_right_knee
  };

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar ground_friction;  ///< parameter [1]
    Scalar ground_restitution;  ///< parameter [1]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::ground_friction, &Parameters::ground_restitution};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar trunk_x;  ///< coordinate [m]
    Scalar trunk_y;  ///< coordinate [m]
    Scalar trunk_z;  ///< coordinate [m]
    Scalar trunk_attitude_w;  ///< component of a unit quaternion [1]
    Scalar trunk_attitude_x;  ///< component of a unit quaternion [1]
    Scalar trunk_attitude_y;  ///< component of a unit quaternion [1]
    Scalar trunk_attitude_z;  ///< component of a unit quaternion [1]
    Scalar front_left_hip;  ///< coordinate [rad]
    Scalar front_left_thigh;  ///< coordinate [rad]
    Scalar front_left_knee;  ///< coordinate [rad]
    Scalar front_right_hip;  ///< coordinate [rad]
    Scalar front_right_thigh;  ///< coordinate [rad]
    Scalar front_right_knee;  ///< coordinate [rad]
    Scalar rear_left_hip;  ///< coordinate [rad]
    Scalar rear_left_thigh;  ///< coordinate [rad]
    Scalar rear_left_knee;  ///< coordinate [rad]
    Scalar rear_right_hip;  ///< coordinate [rad]
    Scalar rear_right_thigh;  ///< coordinate [rad]
    Scalar rear_right_knee;  ///< coordinate [rad]
    static constexpr int size = 19;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::trunk_x, &Coordinates::trunk_y, &Coordinates::trunk_z,
          &Coordinates::trunk_attitude_w, &Coordinates::trunk_attitude_x, &Coordinates::trunk_attitude_y,
          &Coordinates::trunk_attitude_z, &Coordinates::front_left_hip, &Coordinates::front_left_thigh,
          &Coordinates::front_left_knee, &Coordinates::front_right_hip, &Coordinates::front_right_thigh,
          &Coordinates::front_right_knee, &Coordinates::rear_left_hip, &Coordinates::rear_left_thigh,
          &Coordinates::rear_left_knee, &Coordinates::rear_right_hip, &Coordinates::rear_right_thigh,
          &Coordinates::rear_right_knee};
      return members_[i_];
    }
  };

  /// Generalised velocities v; coordinate_rates gives dq/dt.
  struct Velocities {
    Scalar trunk_x;  ///< its rate [m/s]
    Scalar trunk_y;  ///< its rate [m/s]
    Scalar trunk_z;  ///< its rate [m/s]
    Scalar trunk_attitude_omega_x;  ///< angular velocity, in moving axes [rad/s]
    Scalar trunk_attitude_omega_y;  ///< angular velocity, in moving axes [rad/s]
    Scalar trunk_attitude_omega_z;  ///< angular velocity, in moving axes [rad/s]
    Scalar front_left_hip;  ///< its rate [rad/s]
    Scalar front_left_thigh;  ///< its rate [rad/s]
    Scalar front_left_knee;  ///< its rate [rad/s]
    Scalar front_right_hip;  ///< its rate [rad/s]
    Scalar front_right_thigh;  ///< its rate [rad/s]
    Scalar front_right_knee;  ///< its rate [rad/s]
    Scalar rear_left_hip;  ///< its rate [rad/s]
    Scalar rear_left_thigh;  ///< its rate [rad/s]
    Scalar rear_left_knee;  ///< its rate [rad/s]
    Scalar rear_right_hip;  ///< its rate [rad/s]
    Scalar rear_right_thigh;  ///< its rate [rad/s]
    Scalar rear_right_knee;  ///< its rate [rad/s]
    static constexpr int size = 18;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::trunk_x, &Velocities::trunk_y, &Velocities::trunk_z,
          &Velocities::trunk_attitude_omega_x, &Velocities::trunk_attitude_omega_y, &Velocities::trunk_attitude_omega_z,
          &Velocities::front_left_hip, &Velocities::front_left_thigh, &Velocities::front_left_knee,
          &Velocities::front_right_hip, &Velocities::front_right_thigh, &Velocities::front_right_knee,
          &Velocities::rear_left_hip, &Velocities::rear_left_thigh, &Velocities::rear_left_knee,
          &Velocities::rear_right_hip, &Velocities::rear_right_thigh, &Velocities::rear_right_knee};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar trunk_x;  ///< its second rate [m/s^2]
    Scalar trunk_y;  ///< its second rate [m/s^2]
    Scalar trunk_z;  ///< its second rate [m/s^2]
    Scalar trunk_attitude_omega_x;  ///< its rate [rad/s^2]
    Scalar trunk_attitude_omega_y;  ///< its rate [rad/s^2]
    Scalar trunk_attitude_omega_z;  ///< its rate [rad/s^2]
    Scalar front_left_hip;  ///< its second rate [rad/s^2]
    Scalar front_left_thigh;  ///< its second rate [rad/s^2]
    Scalar front_left_knee;  ///< its second rate [rad/s^2]
    Scalar front_right_hip;  ///< its second rate [rad/s^2]
    Scalar front_right_thigh;  ///< its second rate [rad/s^2]
    Scalar front_right_knee;  ///< its second rate [rad/s^2]
    Scalar rear_left_hip;  ///< its second rate [rad/s^2]
    Scalar rear_left_thigh;  ///< its second rate [rad/s^2]
    Scalar rear_left_knee;  ///< its second rate [rad/s^2]
    Scalar rear_right_hip;  ///< its second rate [rad/s^2]
    Scalar rear_right_thigh;  ///< its second rate [rad/s^2]
    Scalar rear_right_knee;  ///< its second rate [rad/s^2]
    static constexpr int size = 18;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::trunk_x, &Accelerations::trunk_y,
          &Accelerations::trunk_z, &Accelerations::trunk_attitude_omega_x, &Accelerations::trunk_attitude_omega_y,
          &Accelerations::trunk_attitude_omega_z, &Accelerations::front_left_hip, &Accelerations::front_left_thigh,
          &Accelerations::front_left_knee, &Accelerations::front_right_hip, &Accelerations::front_right_thigh,
          &Accelerations::front_right_knee, &Accelerations::rear_left_hip, &Accelerations::rear_left_thigh,
          &Accelerations::rear_left_knee, &Accelerations::rear_right_hip, &Accelerations::rear_right_thigh,
          &Accelerations::rear_right_knee};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar trunk_x;  ///< works with the rate of trunk_x [N]
    Scalar trunk_y;  ///< works with the rate of trunk_y [N]
    Scalar trunk_z;  ///< works with the rate of trunk_z [N]
    Scalar trunk_attitude_omega_x;  ///< works with trunk_attitude_omega_x [N m]
    Scalar trunk_attitude_omega_y;  ///< works with trunk_attitude_omega_y [N m]
    Scalar trunk_attitude_omega_z;  ///< works with trunk_attitude_omega_z [N m]
    Scalar front_left_hip;  ///< works with the rate of front_left_hip [N m]
    Scalar front_left_thigh;  ///< works with the rate of front_left_thigh [N m]
    Scalar front_left_knee;  ///< works with the rate of front_left_knee [N m]
    Scalar front_right_hip;  ///< works with the rate of front_right_hip [N m]
    Scalar front_right_thigh;  ///< works with the rate of front_right_thigh [N m]
    Scalar front_right_knee;  ///< works with the rate of front_right_knee [N m]
    Scalar rear_left_hip;  ///< works with the rate of rear_left_hip [N m]
    Scalar rear_left_thigh;  ///< works with the rate of rear_left_thigh [N m]
    Scalar rear_left_knee;  ///< works with the rate of rear_left_knee [N m]
    Scalar rear_right_hip;  ///< works with the rate of rear_right_hip [N m]
    Scalar rear_right_thigh;  ///< works with the rate of rear_right_thigh [N m]
    Scalar rear_right_knee;  ///< works with the rate of rear_right_knee [N m]
    static constexpr int size = 18;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::trunk_x, &GeneralizedForces::trunk_y,
          &GeneralizedForces::trunk_z, &GeneralizedForces::trunk_attitude_omega_x,
          &GeneralizedForces::trunk_attitude_omega_y, &GeneralizedForces::trunk_attitude_omega_z,
          &GeneralizedForces::front_left_hip, &GeneralizedForces::front_left_thigh, &GeneralizedForces::front_left_knee,
          &GeneralizedForces::front_right_hip, &GeneralizedForces::front_right_thigh,
          &GeneralizedForces::front_right_knee, &GeneralizedForces::rear_left_hip, &GeneralizedForces::rear_left_thigh,
          &GeneralizedForces::rear_left_knee, &GeneralizedForces::rear_right_hip, &GeneralizedForces::rear_right_thigh,
          &GeneralizedForces::rear_right_knee};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs {
    Scalar front_left_hip_torque;  ///< motor [N m]
    Scalar front_left_thigh_torque;  ///< motor [N m]
    Scalar front_left_knee_torque;  ///< motor [N m]
    Scalar front_right_hip_torque;  ///< motor [N m]
    Scalar front_right_thigh_torque;  ///< motor [N m]
    Scalar front_right_knee_torque;  ///< motor [N m]
    Scalar rear_left_hip_torque;  ///< motor [N m]
    Scalar rear_left_thigh_torque;  ///< motor [N m]
    Scalar rear_left_knee_torque;  ///< motor [N m]
    Scalar rear_right_hip_torque;  ///< motor [N m]
    Scalar rear_right_thigh_torque;  ///< motor [N m]
    Scalar rear_right_knee_torque;  ///< motor [N m]
    static constexpr int size = 12;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Inputs::*member_(int i_) noexcept {
      constexpr Scalar Inputs::*members_[] = {&Inputs::front_left_hip_torque, &Inputs::front_left_thigh_torque,
          &Inputs::front_left_knee_torque, &Inputs::front_right_hip_torque, &Inputs::front_right_thigh_torque,
          &Inputs::front_right_knee_torque, &Inputs::rear_left_hip_torque, &Inputs::rear_left_thigh_torque,
          &Inputs::rear_left_knee_torque, &Inputs::rear_right_hip_torque, &Inputs::rear_right_thigh_torque,
          &Inputs::rear_right_knee_torque};
      return members_[i_];
    }
  };

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
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    parameters.ground_friction = n0_6;
    parameters.ground_restitution = n0;
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
    const Scalar n0_45 = traits::constant(0.45, 0.45f, "9/20");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n1_4 = traits::constant(1.4, 1.4f, "7/5");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    state.time = n0;
    state.q.trunk_x = n0;
    state.q.trunk_y = n0;
    state.q.trunk_z = n0_45;
    state.q.trunk_attitude_w = n1;
    state.q.trunk_attitude_x = n0;
    state.q.trunk_attitude_y = n0;
    state.q.trunk_attitude_z = n0;
    state.q.front_left_hip = n0;
    state.q.front_left_thigh = n0_7;
    state.q.front_left_knee = -n1_4;
    state.q.front_right_hip = n0;
    state.q.front_right_thigh = n0_7;
    state.q.front_right_knee = -n1_4;
    state.q.rear_left_hip = n0;
    state.q.rear_left_thigh = n0_7;
    state.q.rear_left_knee = -n1_4;
    state.q.rear_right_hip = n0;
    state.q.rear_right_thigh = n0_7;
    state.q.rear_right_knee = -n1_4;
    state.v.trunk_x = n0_5;
    state.v.trunk_y = n0;
    state.v.trunk_z = n0;
    state.v.trunk_attitude_omega_x = n0;
    state.v.trunk_attitude_omega_y = n0;
    state.v.trunk_attitude_omega_z = n0;
    state.v.front_left_hip = n0;
    state.v.front_left_thigh = n0;
    state.v.front_left_knee = n0;
    state.v.front_right_hip = n0;
    state.v.front_right_thigh = n0;
    state.v.front_right_knee = n0;
    state.v.rear_left_hip = n0;
    state.v.rear_left_thigh = n0;
    state.v.rear_left_knee = n0;
    state.v.rear_right_hip = n0;
    state.v.rear_right_thigh = n0;
    state.v.rear_right_knee = n0;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

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

  /// Gaps of contacts, and what they may do along their normals and tangents.
  struct Contacts {
    std::array<Scalar, 4> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 12> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 216> jacobian;  ///< J, stored column by column (12 x 18)
    std::array<Scalar, 12> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 4;
  static constexpr int contact_row_count = 12;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[4] = {1, 1, 1, 1};
  static constexpr int contact_tangents[4] = {2, 2, 2, 2};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 4> friction;  ///< f [1]
    std::array<Scalar, 4> static_friction;  ///< f_s [1]
    std::array<Scalar, 4> restitution;  ///< e [1]
    std::array<Scalar, 4> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 4> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// dq/dt from v: the velocity itself for a coordinate, 1/2 e (0, omega) for a unit quaternion e with the angular
  /// velocity omega in moving axes.
  TORSOR_DEVICE static void coordinate_rates(const Precomputed&, const State& state,
      std::array<Scalar, 19>& rates) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_trunk_x = state.v.trunk_x;
    const Scalar v_trunk_y = state.v.trunk_y;
    const Scalar v_trunk_z = state.v.trunk_z;
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar z0 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_y + q_trunk_attitude_z
        * v_trunk_attitude_omega_z + q_trunk_attitude_x * v_trunk_attitude_omega_x);
    const Scalar z1 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_z - q_trunk_attitude_z
        * v_trunk_attitude_omega_y + q_trunk_attitude_w * v_trunk_attitude_omega_x);
    const Scalar z2 = n0_5 * (q_trunk_attitude_z * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_z + q_trunk_attitude_w * v_trunk_attitude_omega_y);
    const Scalar z3 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_y - q_trunk_attitude_w * v_trunk_attitude_omega_z);
    rates[0] = v_trunk_x;
    rates[1] = v_trunk_y;
    rates[2] = v_trunk_z;
    rates[3] = -z0;
    rates[4] = z1;
    rates[5] = z2;
    rates[6] = -z3;
    rates[7] = v_front_left_hip;
    rates[8] = v_front_left_thigh;
    rates[9] = v_front_left_knee;
    rates[10] = v_front_right_hip;
    rates[11] = v_front_right_thigh;
    rates[12] = v_front_right_knee;
    rates[13] = v_rear_left_hip;
    rates[14] = v_rear_left_thigh;
    rates[15] = v_rear_left_knee;
    rates[16] = v_rear_right_hip;
    rates[17] = v_rear_right_thigh;
    rates[18] = v_rear_right_knee;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state,
      std::array<Scalar, 324>& mass) noexcept {
    const Scalar k0 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar k4 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar k8 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar k10 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k13 = traits::constant(0.0082236, 0.0082236f, "20559/2500000");
    const Scalar k14 = traits::constant(0.0086236, 0.0086236f, "21559/2500000");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_0406 = traits::constant(0.0406, 0.0406f, "203/5000");
    const Scalar n0_3362 = traits::constant(0.3362, 0.3362f, "1681/5000");
    const Scalar n0_3668 = traits::constant(0.3668, 0.3668f, "917/2500");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee};
    Scalar sines_[12], cosines_[12];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z0 = k0 * c_rear_right_knee;
    const Scalar z1 = n0_032 * c_rear_right_knee;
    const Scalar z2 = k0 * s_rear_right_knee;
    const Scalar z3 = n0_032 * s_rear_right_knee;
    const Scalar z4 = n2 * q_trunk_attitude_y;
    const Scalar z5 = n2 * q_trunk_attitude_z;
    const Scalar z6 = q_trunk_attitude_y * z4;
    const Scalar z7 = q_trunk_attitude_z * z5;
    const Scalar z8 = q_trunk_attitude_x * z4;
    const Scalar z9 = q_trunk_attitude_w * z5;
    const Scalar z10 = n2 * q_trunk_attitude_x;
    const Scalar z11 = q_trunk_attitude_x * z5;
    const Scalar z12 = q_trunk_attitude_w * z4;
    const Scalar z13 = n1 - z6 - z7;
    const Scalar z14 = z8 + z9;
    const Scalar z15 = q_trunk_attitude_x * z10;
    const Scalar z16 = q_trunk_attitude_z * z4;
    const Scalar z17 = q_trunk_attitude_w * z10;
    const Scalar z18 = z11 - z12;
    const Scalar z19 = z8 - z9;
    const Scalar z20 = n1 - z7 - z15;
    const Scalar z21 = z16 + z17;
    const Scalar z22 = n1 - z6 - z15;
    const Scalar z23 = z16 - z17;
    const Scalar z24 = z11 + z12;
    const Scalar z25 = k4 + n0_2 * z1;
    const Scalar z26 = s_rear_right_thigh * z3;
    const Scalar z27 = c_rear_right_thigh * z3;
    const Scalar z28 = c_rear_right_knee * z0;
    const Scalar z29 = s_rear_right_knee * z2;
    const Scalar z30 = s_rear_right_knee * z0;
    const Scalar z31 = k4 + n0_4 * z1;
    const Scalar z32 = n0_124 + z1;
    const Scalar z33 = c_rear_right_thigh * z1 - z26;
    const Scalar z34 = s_rear_right_thigh * z1 + z27;
    const Scalar z35 = n0_4 * z1 + z28;
    const Scalar z36 = n0_2 * z3 + z30;
    const Scalar z37 = c_rear_right_thigh * z32 - z26;
    const Scalar z38 = s_rear_right_thigh * z32 + z27;
    const Scalar z39 = k8 + z31;
    const Scalar z40 = n0_08 * z34;
    const Scalar z41 = n0_08 * z33;
    const Scalar z42 = s_rear_right_hip * z34;
    const Scalar z43 = c_rear_right_hip * z34;
    const Scalar z44 = k10 + z35;
    const Scalar z45 = n0_08 * z38;
    const Scalar z46 = n0_08 * z37;
    const Scalar z47 = s_rear_right_hip * z38;
    const Scalar z48 = c_rear_right_hip * z38;
    const Scalar z49 = n2 * z36;
    const Scalar z50 = n0_1048 * s_rear_right_hip + c_rear_right_hip * z37;
    const Scalar z51 = s_rear_right_hip * z37 - n0_1048 * c_rear_right_hip;
    const Scalar z52 = c_rear_right_hip * z25 + s_rear_right_hip * z41;
    const Scalar z53 = s_rear_right_hip * z25 - c_rear_right_hip * z41;
    const Scalar z54 = z40 + n0_05 * z43;
    const Scalar z55 = z13 * z33 + z19 * z42 - z24 * z43;
    const Scalar z56 = z14 * z33 + z20 * z42 - z23 * z43;
    const Scalar z57 = z18 * z33 + z21 * z42 - z22 * z43;
    const Scalar z58 = c_rear_right_hip * z39 + s_rear_right_hip * z46;
    const Scalar z59 = s_rear_right_hip * z39 - c_rear_right_hip * z46;
    const Scalar z60 = z45 + n0_05 * z48;
    const Scalar z61 = z13 * z37 + z19 * z47 - z24 * z48;
    const Scalar z62 = z14 * z37 + z20 * z47 - z23 * z48;
    const Scalar z63 = z18 * z37 + z21 * z47 - z22 * z48;
    const Scalar z64 = z29 - z44;
    const Scalar z65 = s_rear_right_thigh * z64 - c_rear_right_thigh * z49;
    const Scalar z66 = n0_05 * z33 - z53 - n0_2 * z42;
    const Scalar z67 = n0_05 * z37 - z59 - n0_2 * z47;
    const Scalar z68 = n0_2 * z43 + z52;
    const Scalar z69 = n0_2 * z48 + z58;
    const Scalar z70 = k0 * c_rear_left_knee;
    const Scalar z71 = c_rear_right_thigh * z65 + z36;
    const Scalar z72 = s_rear_right_thigh * z65;
    const Scalar z73 = z19 * z50 + z24 * z51;
    const Scalar z74 = z29 - z72;
    const Scalar z75 = z44 + z72;
    const Scalar z76 = n0_032 * c_rear_left_knee;
    const Scalar z77 = z20 * z50 + z23 * z51;
    const Scalar z78 = k13 + z74;
    const Scalar z79 = k14 + z75;
    const Scalar z80 = z21 * z50 + z22 * z51;
    const Scalar z81 = z79 - n0_05 * z51;
    const Scalar z82 = z79 - n0_1 * z51;
    const Scalar z83 = c_rear_left_knee * z70;
    const Scalar z84 = n0_4 * z76 + z83;
    const Scalar z85 = s_rear_left_knee * z70;
    const Scalar z86 = n0_0406 + z82;
    const Scalar z87 = k0 * s_rear_left_knee;
    const Scalar z88 = s_rear_left_knee * z87;
    const Scalar z89 = n0_032 * s_rear_left_knee;
    const Scalar z90 = n0_2 * z89 + z85;
    const Scalar z91 = k10 + z84;
    const Scalar z92 = s_rear_left_thigh * z89;
    const Scalar z93 = c_rear_left_thigh * z89;
    const Scalar z94 = n0_124 + z76;
    const Scalar z95 = c_rear_left_thigh * z94 - z92;
    const Scalar z96 = s_rear_left_thigh * z94 + z93;
    const Scalar z97 = c_rear_left_thigh * z76 - z92;
    const Scalar z98 = s_rear_left_thigh * z76 + z93;
    const Scalar z99 = z39 - z78;
    const Scalar z100 = k4 + n0_4 * z76;
    const Scalar z101 = k8 + z100;
    const Scalar z102 = k4 + n0_2 * z76;
    const Scalar z103 = n0_08 * z95;
    const Scalar z104 = n2 * z46;
    const Scalar z105 = s_rear_right_hip * z99 - c_rear_right_hip * z104;
    const Scalar z106 = n0_08 * z96;
    const Scalar z107 = c_rear_right_hip * z45 + s_rear_right_hip * z71;
    const Scalar z108 = s_rear_right_hip * z45 - c_rear_right_hip * z71;
    const Scalar z109 = c_rear_right_hip * z105 + z46;
    const Scalar z110 = s_rear_right_hip * z105;
    const Scalar z111 = n0_2 * z50 + z108;
    const Scalar z112 = z78 + z110;
    const Scalar z113 = z39 - z110;
    const Scalar z114 = n0_05 * z50 - z109;
    const Scalar z115 = n0_2 * z51 - z107;
    const Scalar z116 = n0_4 * z38 + z113;
    const Scalar z117 = z112 + n0_4 * z38 - n0_1 * z51;
    const Scalar z118 = z107 + n0_05 * z38 - n0_2 * z51;
    const Scalar z119 = n0_3362 + z116;
    const Scalar z120 = z88 - z91;
    const Scalar z121 = n2 * z90;
    const Scalar z122 = s_rear_left_thigh * z120 - c_rear_left_thigh * z121;
    const Scalar z123 = n0_3668 + z117;
    const Scalar z124 = n2 * z103;
    const Scalar z125 = n0_1048 * s_rear_left_hip - c_rear_left_hip * z95;
    const Scalar z126 = n0_1048 * c_rear_left_hip + s_rear_left_hip * z95;
    const Scalar z127 = z19 * z125 - z24 * z126;
    const Scalar z128 = c_rear_left_thigh * z122 + z90;
    const Scalar z129 = s_rear_left_thigh * z122;
    const Scalar z130 = z20 * z125 - z23 * z126;
    const Scalar z131 = z88 - z129;
    const Scalar z132 = z91 + z129;
    const Scalar z133 = z21 * z125 - z22 * z126;
    const Scalar z134 = k13 + z131;
    const Scalar z135 = k14 + z132;
    const Scalar z136 = s_rear_left_hip * z128 - c_rear_left_hip * z106;
    const Scalar z137 = s_rear_left_hip * z106 + c_rear_left_hip * z128;
    const Scalar z138 = n0_2 * z125 + z137;
    const Scalar z139 = z135 + n0_05 * z126;
    const Scalar z140 = n0_2 * z126 - z136;
    const Scalar z141 = z101 - z134;
    const Scalar z142 = c_rear_left_hip * z124 + s_rear_left_hip * z141;
    const Scalar z143 = n0_08 * z97;
    const Scalar z144 = s_rear_left_hip * z98;
    const Scalar z145 = s_rear_left_hip * z102 + c_rear_left_hip * z143;
    const Scalar z146 = s_rear_left_hip * z143 - c_rear_left_hip * z102;
    const Scalar z147 = s_rear_left_hip * z142;
    const Scalar z148 = z145 + n0_05 * z97 + n0_2 * z144;
    const Scalar z149 = s_rear_left_hip * z96;
    const Scalar z150 = s_rear_left_hip * z101 + c_rear_left_hip * z103;
    const Scalar z151 = z150 + n0_05 * z95 + n0_2 * z149;
    const Scalar z152 = n0_08 * z98;
    const Scalar z153 = z134 + z147;
    const Scalar z154 = z101 - z147;
    const Scalar z155 = c_rear_left_hip * z142 - z103;
    const Scalar z156 = s_rear_left_hip * z103 - c_rear_left_hip * z101;
    const Scalar z157 = c_rear_left_hip * z98;
    const Scalar z158 = z152 + n0_05 * z157;
    const Scalar z159 = n0_2 * z157 - z146;
    const Scalar z160 = z38 + z96;
    const Scalar z161 = z135 + n0_1 * z126;
    const Scalar z162 = n0_05 * z96 - z136 + n0_2 * z126;
    const Scalar z163 = n0_4 * z96 + z154;
    const Scalar z164 = n0_05 * z125 - z155;
    const Scalar z165 = z153 + n0_4 * z96 + n0_1 * z126;
    const Scalar z166 = c_rear_left_hip * z96;
    const Scalar z167 = z106 + n0_05 * z166;
    const Scalar z168 = n0_2 * z166 - z156;
    const Scalar z169 = z13 * z97 + z19 * z144 - z24 * z157;
    const Scalar z170 = z51 + z126;
    const Scalar z171 = z14 * z97 + z20 * z144 - z23 * z157;
    const Scalar z172 = z18 * z97 + z21 * z144 - z22 * z157;
    const Scalar z173 = z50 - z125;
    const Scalar z174 = z86 + z161;
    const Scalar z175 = z118 - z162;
    const Scalar z176 = z119 + z163;
    const Scalar z177 = z111 - z138;
    const Scalar z178 = z114 + z164;
    const Scalar z179 = z123 + z165;
    const Scalar z180 = z13 * z95 + z19 * z149 - z24 * z166;
    const Scalar z181 = z14 * z95 + z20 * z149 - z23 * z166;
    const Scalar z182 = z18 * z95 + z21 * z149 - z22 * z166;
    const Scalar z183 = k0 * c_front_right_knee;
    const Scalar z184 = n0_032 * c_front_right_knee;
    const Scalar z185 = c_front_right_knee * z183;
    const Scalar z186 = s_front_right_knee * z183;
    const Scalar z187 = k0 * s_front_right_knee;
    const Scalar z188 = s_front_right_knee * z187;
    const Scalar z189 = n0_032 * s_front_right_knee;
    const Scalar z190 = n0_4 * z184 + z185;
    const Scalar z191 = n0_2 * z189 + z186;
    const Scalar z192 = s_front_right_thigh * z189;
    const Scalar z193 = c_front_right_thigh * z189;
    const Scalar z194 = n0_124 + z184;
    const Scalar z195 = k4 + n0_4 * z184;
    const Scalar z196 = k10 + z190;
    const Scalar z197 = k8 + z195;
    const Scalar z198 = n2 * z191;
    const Scalar z199 = c_front_right_thigh * z194 - z192;
    const Scalar z200 = s_front_right_thigh * z194 + z193;
    const Scalar z201 = c_front_right_thigh * z184 - z192;
    const Scalar z202 = s_front_right_thigh * z184 + z193;
    const Scalar z203 = k4 + n0_2 * z184;
    const Scalar z204 = z188 - z196;
    const Scalar z205 = s_front_right_thigh * z204 - c_front_right_thigh * z198;
    const Scalar z206 = n0_08 * z199;
    const Scalar z207 = n2 * z206;
    const Scalar z208 = n0_08 * z200;
    const Scalar z209 = n0_1048 * s_front_right_hip + c_front_right_hip * z199;
    const Scalar z210 = n0_08 * z201;
    const Scalar z211 = s_front_right_hip * z199 - n0_1048 * c_front_right_hip;
    const Scalar z212 = z19 * z209 + z24 * z211;
    const Scalar z213 = c_front_right_thigh * z205 + z191;
    const Scalar z214 = s_front_right_thigh * z205;
    const Scalar z215 = z20 * z209 + z23 * z211;
    const Scalar z216 = z188 - z214;
    const Scalar z217 = z196 + z214;
    const Scalar z218 = z21 * z209 + z22 * z211;
    const Scalar z219 = k13 + z216;
    const Scalar z220 = k14 + z217;
    const Scalar z221 = c_front_right_hip * z208 + s_front_right_hip * z213;
    const Scalar z222 = s_front_right_hip * z208 - c_front_right_hip * z213;
    const Scalar z223 = n0_2 * z209 - z222;
    const Scalar z224 = z220 - n0_05 * z211;
    const Scalar z225 = n0_2 * z211 + z221;
    const Scalar z226 = z197 - z219;
    const Scalar z227 = s_front_right_hip * z226 - c_front_right_hip * z207;
    const Scalar z228 = s_front_right_hip * z202;
    const Scalar z229 = s_front_right_hip * z203 - c_front_right_hip * z210;
    const Scalar z230 = c_front_right_hip * z203 + s_front_right_hip * z210;
    const Scalar z231 = n0_05 * z201 - z229 + n0_2 * z228;
    const Scalar z232 = s_front_right_hip * z227;
    const Scalar z233 = s_front_right_hip * z200;
    const Scalar z234 = s_front_right_hip * z197 - c_front_right_hip * z206;
    const Scalar z235 = n0_05 * z199 - z234 + n0_2 * z233;
    const Scalar z236 = n0_08 * z202;
    const Scalar z237 = z219 + z232;
    const Scalar z238 = z197 - z232;
    const Scalar z239 = c_front_right_hip * z227 + z206;
    const Scalar z240 = c_front_right_hip * z197 + s_front_right_hip * z206;
    const Scalar z241 = c_front_right_hip * z202;
    const Scalar z242 = z236 + n0_05 * z241;
    const Scalar z243 = n0_2 * z241 - z230;
    const Scalar z244 = z160 + z200;
    const Scalar z245 = z220 - n0_1 * z211;
    const Scalar z246 = z221 + n0_05 * z200 + n0_2 * z211;
    const Scalar z247 = n0_4 * z200 - z238;
    const Scalar z248 = n0_05 * z209 - z239;
    const Scalar z249 = n0_4 * z200 - z237 + n0_1 * z211;
    const Scalar z250 = c_front_right_hip * z200;
    const Scalar z251 = z208 + n0_05 * z250;
    const Scalar z252 = n0_2 * z250 - z240;
    const Scalar z253 = z13 * z201 + z19 * z228 - z24 * z241;
    const Scalar z254 = z170 + z211;
    const Scalar z255 = z14 * z201 + z20 * z228 - z23 * z241;
    const Scalar z256 = z18 * z201 + z21 * z228 - z22 * z241;
    const Scalar z257 = z173 + z209;
    const Scalar z258 = z174 + z245;
    const Scalar z259 = z175 + z246;
    const Scalar z260 = z176 - z247;
    const Scalar z261 = z177 - z223;
    const Scalar z262 = z178 + z248;
    const Scalar z263 = z179 - z249;
    const Scalar z264 = z13 * z199 + z19 * z233 - z24 * z250;
    const Scalar z265 = z14 * z199 + z20 * z233 - z23 * z250;
    const Scalar z266 = z18 * z199 + z21 * z233 - z22 * z250;
    const Scalar z267 = k0 * c_front_left_knee;
    const Scalar z268 = n0_032 * c_front_left_knee;
    const Scalar z269 = c_front_left_knee * z267;
    const Scalar z270 = s_front_left_knee * z267;
    const Scalar z271 = k0 * s_front_left_knee;
    const Scalar z272 = s_front_left_knee * z271;
    const Scalar z273 = n0_032 * s_front_left_knee;
    const Scalar z274 = n0_4 * z268 + z269;
    const Scalar z275 = n0_2 * z273 + z270;
    const Scalar z276 = s_front_left_thigh * z273;
    const Scalar z277 = c_front_left_thigh * z273;
    const Scalar z278 = n0_124 + z268;
    const Scalar z279 = c_front_left_thigh * z278 - z276;
    const Scalar z280 = k10 + z274;
    const Scalar z281 = s_front_left_thigh * z278 + z277;
    const Scalar z282 = c_front_left_thigh * z268 - z276;
    const Scalar z283 = s_front_left_thigh * z268 + z277;
    const Scalar z284 = z272 - z280;
    const Scalar z285 = n2 * z275;
    const Scalar z286 = k4 + n0_4 * z268;
    const Scalar z287 = s_front_left_thigh * z284 - c_front_left_thigh * z285;
    const Scalar z288 = k8 + z286;
    const Scalar z289 = k4 + n0_2 * z268;
    const Scalar z290 = n0_08 * z279;
    const Scalar z291 = n2 * z290;
    const Scalar z292 = n0_08 * z281;
    const Scalar z293 = n0_08 * z282;
    const Scalar z294 = n0_1048 * s_front_left_hip - c_front_left_hip * z279;
    const Scalar z295 = s_front_left_hip * z283;
    const Scalar z296 = c_front_left_thigh * z287 + z275;
    const Scalar z297 = s_front_left_thigh * z287;
    const Scalar z298 = s_front_left_hip * z289 + c_front_left_hip * z293;
    const Scalar z299 = s_front_left_hip * z293 - c_front_left_hip * z289;
    const Scalar z300 = z298 + n0_05 * z282 - n0_2 * z295;
    const Scalar z301 = z272 - z297;
    const Scalar z302 = z280 + z297;
    const Scalar z303 = k13 + z301;
    const Scalar z304 = k14 + z302;
    const Scalar z305 = s_front_left_hip * z296 - c_front_left_hip * z292;
    const Scalar z306 = s_front_left_hip * z292 + c_front_left_hip * z296;
    const Scalar z307 = n0_2 * z294 - z306;
    const Scalar z308 = z288 - z303;
    const Scalar z309 = c_front_left_hip * z291 + s_front_left_hip * z308;
    const Scalar z310 = s_front_left_hip * z281;
    const Scalar z311 = s_front_left_hip * z288 + c_front_left_hip * z290;
    const Scalar z312 = z311 + n0_05 * z279 - n0_2 * z310;
    const Scalar z313 = s_front_left_hip * z309;
    const Scalar z314 = n0_1048 * c_front_left_hip + s_front_left_hip * z279;
    const Scalar z315 = z304 + n0_05 * z314;
    const Scalar z316 = n0_2 * z314 + z305;
    const Scalar z317 = z19 * z294 - z24 * z314;
    const Scalar z318 = z20 * z294 - z23 * z314;
    const Scalar z319 = z21 * z294 - z22 * z314;
    const Scalar z320 = n0_08 * z283;
    const Scalar z321 = z303 + z313;
    const Scalar z322 = z288 - z313;
    const Scalar z323 = c_front_left_hip * z309 - z290;
    const Scalar z324 = s_front_left_hip * z290 - c_front_left_hip * z288;
    const Scalar z325 = c_front_left_hip * z283;
    const Scalar z326 = z320 + n0_05 * z325;
    const Scalar z327 = n0_2 * z325 + z299;
    const Scalar z328 = z244 + z281;
    const Scalar z329 = z304 + n0_1 * z314;
    const Scalar z330 = n0_05 * z281 - z305 - n0_2 * z314;
    const Scalar z331 = n0_4 * z281 - z322;
    const Scalar z332 = n0_05 * z294 - z323;
    const Scalar z333 = n0_4 * z281 - z321 - n0_1 * z314;
    const Scalar z334 = c_front_left_hip * z281;
    const Scalar z335 = z292 + n0_05 * z334;
    const Scalar z336 = n0_2 * z334 + z324;
    const Scalar z337 = z13 * z282 + z19 * z295 - z24 * z325;
    const Scalar z338 = z254 + z314;
    const Scalar z339 = z14 * z282 + z20 * z295 - z23 * z325;
    const Scalar z340 = z18 * z282 + z21 * z295 - z22 * z325;
    const Scalar z341 = z258 + z329;
    const Scalar z342 = z259 - z330;
    const Scalar z343 = z260 - z331;
    const Scalar z344 = z261 + z307;
    const Scalar z345 = z262 + z332;
    const Scalar z346 = z257 - z294;
    const Scalar z347 = z13 * z279 + z19 * z310 - z24 * z334;
    const Scalar z348 = z14 * z279 + z20 * z310 - z23 * z334;
    const Scalar z349 = z18 * z279 + z21 * z310 - z22 * z334;
    const Scalar z350 = z263 - z333;
    const Scalar z351 = z19 * z328 + z13 * z338;
    const Scalar z352 = z20 * z328 + z14 * z338;
    const Scalar z353 = z21 * z328 + z18 * z338;
    const Scalar z354 = z13 * z346 - z24 * z328;
    const Scalar z355 = z14 * z346 - z23 * z328;
    const Scalar z356 = z22 * z328 - z18 * z346;
    const Scalar z357 = z19 * z346 + z24 * z338;
    const Scalar z358 = z20 * z346 + z23 * z338;
    const Scalar z359 = z21 * z346 + z22 * z338;
    mass[0] = n12_24;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z357;
    mass[4] = -z354;
    mass[5] = -z351;
    mass[6] = -z317;
    mass[7] = -z347;
    mass[8] = -z337;
    mass[9] = z212;
    mass[10] = -z264;
    mass[11] = -z253;
    mass[12] = -z127;
    mass[13] = -z180;
    mass[14] = -z169;
    mass[15] = z73;
    mass[16] = -z61;
    mass[17] = -z55;
    mass[18] = n0;
    mass[19] = n12_24;
    mass[20] = n0;
    mass[21] = z358;
    mass[22] = -z355;
    mass[23] = -z352;
    mass[24] = -z318;
    mass[25] = -z348;
    mass[26] = -z339;
    mass[27] = z215;
    mass[28] = -z265;
    mass[29] = -z255;
    mass[30] = -z130;
    mass[31] = -z181;
    mass[32] = -z171;
    mass[33] = z77;
    mass[34] = -z62;
    mass[35] = -z56;
    mass[36] = n0;
    mass[37] = n0;
    mass[38] = n12_24;
    mass[39] = z359;
    mass[40] = z356;
    mass[41] = -z353;
    mass[42] = -z319;
    mass[43] = -z349;
    mass[44] = -z340;
    mass[45] = z218;
    mass[46] = -z266;
    mass[47] = -z256;
    mass[48] = -z133;
    mass[49] = -z182;
    mass[50] = -z172;
    mass[51] = z80;
    mass[52] = -z63;
    mass[53] = -z57;
    mass[54] = z357;
    mass[55] = z358;
    mass[56] = z359;
    mass[57] = z341;
    mass[58] = -z342;
    mass[59] = -z344;
    mass[60] = z315;
    mass[61] = z335;
    mass[62] = z326;
    mass[63] = z224;
    mass[64] = -z251;
    mass[65] = -z242;
    mass[66] = z139;
    mass[67] = z167;
    mass[68] = z158;
    mass[69] = z81;
    mass[70] = -z60;
    mass[71] = -z54;
    mass[72] = -z354;
    mass[73] = -z355;
    mass[74] = z356;
    mass[75] = -z342;
    mass[76] = z343;
    mass[77] = -z345;
    mass[78] = -z316;
    mass[79] = -z336;
    mass[80] = -z327;
    mass[81] = -z225;
    mass[82] = -z252;
    mass[83] = -z243;
    mass[84] = z140;
    mass[85] = z168;
    mass[86] = z159;
    mass[87] = z115;
    mass[88] = z69;
    mass[89] = z68;
    mass[90] = -z351;
    mass[91] = -z352;
    mass[92] = -z353;
    mass[93] = -z344;
    mass[94] = -z345;
    mass[95] = z350;
    mass[96] = -z307;
    mass[97] = z312;
    mass[98] = z300;
    mass[99] = z223;
    mass[100] = -z235;
    mass[101] = -z231;
    mass[102] = z138;
    mass[103] = z151;
    mass[104] = z148;
    mass[105] = -z111;
    mass[106] = -z67;
    mass[107] = -z66;
    mass[108] = -z317;
    mass[109] = -z318;
    mass[110] = -z319;
    mass[111] = z315;
    mass[112] = -z316;
    mass[113] = -z307;
    mass[114] = z304;
    mass[115] = z292;
    mass[116] = z320;
    mass[117] = n0;
    mass[118] = n0;
    mass[119] = n0;
    mass[120] = n0;
    mass[121] = n0;
    mass[122] = n0;
    mass[123] = n0;
    mass[124] = n0;
    mass[125] = n0;
    mass[126] = -z347;
    mass[127] = -z348;
    mass[128] = -z349;
    mass[129] = z335;
    mass[130] = -z336;
    mass[131] = z312;
    mass[132] = z292;
    mass[133] = z288;
    mass[134] = z289;
    mass[135] = n0;
    mass[136] = n0;
    mass[137] = n0;
    mass[138] = n0;
    mass[139] = n0;
    mass[140] = n0;
    mass[141] = n0;
    mass[142] = n0;
    mass[143] = n0;
    mass[144] = -z337;
    mass[145] = -z339;
    mass[146] = -z340;
    mass[147] = z326;
    mass[148] = -z327;
    mass[149] = z300;
    mass[150] = z320;
    mass[151] = z289;
    mass[152] = k4;
    mass[153] = n0;
    mass[154] = n0;
    mass[155] = n0;
    mass[156] = n0;
    mass[157] = n0;
    mass[158] = n0;
    mass[159] = n0;
    mass[160] = n0;
    mass[161] = n0;
    mass[162] = z212;
    mass[163] = z215;
    mass[164] = z218;
    mass[165] = z224;
    mass[166] = -z225;
    mass[167] = z223;
    mass[168] = n0;
    mass[169] = n0;
    mass[170] = n0;
    mass[171] = z220;
    mass[172] = -z208;
    mass[173] = -z236;
    mass[174] = n0;
    mass[175] = n0;
    mass[176] = n0;
    mass[177] = n0;
    mass[178] = n0;
    mass[179] = n0;
    mass[180] = -z264;
    mass[181] = -z265;
    mass[182] = -z266;
    mass[183] = -z251;
    mass[184] = -z252;
    mass[185] = -z235;
    mass[186] = n0;
    mass[187] = n0;
    mass[188] = n0;
    mass[189] = -z208;
    mass[190] = z197;
    mass[191] = z203;
    mass[192] = n0;
    mass[193] = n0;
    mass[194] = n0;
    mass[195] = n0;
    mass[196] = n0;
    mass[197] = n0;
    mass[198] = -z253;
    mass[199] = -z255;
    mass[200] = -z256;
    mass[201] = -z242;
    mass[202] = -z243;
    mass[203] = -z231;
    mass[204] = n0;
    mass[205] = n0;
    mass[206] = n0;
    mass[207] = -z236;
    mass[208] = z203;
    mass[209] = k4;
    mass[210] = n0;
    mass[211] = n0;
    mass[212] = n0;
    mass[213] = n0;
    mass[214] = n0;
    mass[215] = n0;
    mass[216] = -z127;
    mass[217] = -z130;
    mass[218] = -z133;
    mass[219] = z139;
    mass[220] = z140;
    mass[221] = z138;
    mass[222] = n0;
    mass[223] = n0;
    mass[224] = n0;
    mass[225] = n0;
    mass[226] = n0;
    mass[227] = n0;
    mass[228] = z135;
    mass[229] = z106;
    mass[230] = z152;
    mass[231] = n0;
    mass[232] = n0;
    mass[233] = n0;
    mass[234] = -z180;
    mass[235] = -z181;
    mass[236] = -z182;
    mass[237] = z167;
    mass[238] = z168;
    mass[239] = z151;
    mass[240] = n0;
    mass[241] = n0;
    mass[242] = n0;
    mass[243] = n0;
    mass[244] = n0;
    mass[245] = n0;
    mass[246] = z106;
    mass[247] = z101;
    mass[248] = z102;
    mass[249] = n0;
    mass[250] = n0;
    mass[251] = n0;
    mass[252] = -z169;
    mass[253] = -z171;
    mass[254] = -z172;
    mass[255] = z158;
    mass[256] = z159;
    mass[257] = z148;
    mass[258] = n0;
    mass[259] = n0;
    mass[260] = n0;
    mass[261] = n0;
    mass[262] = n0;
    mass[263] = n0;
    mass[264] = z152;
    mass[265] = z102;
    mass[266] = k4;
    mass[267] = n0;
    mass[268] = n0;
    mass[269] = n0;
    mass[270] = z73;
    mass[271] = z77;
    mass[272] = z80;
    mass[273] = z81;
    mass[274] = z115;
    mass[275] = -z111;
    mass[276] = n0;
    mass[277] = n0;
    mass[278] = n0;
    mass[279] = n0;
    mass[280] = n0;
    mass[281] = n0;
    mass[282] = n0;
    mass[283] = n0;
    mass[284] = n0;
    mass[285] = z79;
    mass[286] = -z45;
    mass[287] = -z40;
    mass[288] = -z61;
    mass[289] = -z62;
    mass[290] = -z63;
    mass[291] = -z60;
    mass[292] = z69;
    mass[293] = -z67;
    mass[294] = n0;
    mass[295] = n0;
    mass[296] = n0;
    mass[297] = n0;
    mass[298] = n0;
    mass[299] = n0;
    mass[300] = n0;
    mass[301] = n0;
    mass[302] = n0;
    mass[303] = -z45;
    mass[304] = z39;
    mass[305] = z25;
    mass[306] = -z55;
    mass[307] = -z56;
    mass[308] = -z57;
    mass[309] = -z54;
    mass[310] = z68;
    mass[311] = -z66;
    mass[312] = n0;
    mass[313] = n0;
    mass[314] = n0;
    mass[315] = n0;
    mass[316] = n0;
    mass[317] = n0;
    mass[318] = n0;
    mass[319] = n0;
    mass[320] = n0;
    mass[321] = -z40;
    mass[322] = z25;
    mass[323] = k4;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar k7 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar k8 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar k9 = traits::constant(3.96e-05, 3.96e-05f, "99/2500000");
    const Scalar k10 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar k11 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar k14 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k16 = traits::constant(0.0082236, 0.0082236f, "20559/2500000");
    const Scalar k17 = traits::constant(0.0080236, 0.0080236f, "20059/2500000");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar n0_0306 = traits::constant(0.0306, 0.0306f, "153/5000");
    const Scalar n0_2948 = traits::constant(0.2948, 0.2948f, "737/2500");
    const Scalar n0_3254 = traits::constant(0.3254, 0.3254f, "1627/5000");
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee};
    Scalar sines_[12], cosines_[12];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z0 = n2 * q_trunk_attitude_y;
    const Scalar z1 = n2 * q_trunk_attitude_x;
    const Scalar z2 = n2 * q_trunk_attitude_z;
    const Scalar z3 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z4 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z5 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z6 = q_trunk_attitude_y * z0;
    const Scalar z7 = q_trunk_attitude_x * z1;
    const Scalar z8 = q_trunk_attitude_z * z0;
    const Scalar z9 = q_trunk_attitude_w * z1;
    const Scalar z10 = q_trunk_attitude_x * z2;
    const Scalar z11 = q_trunk_attitude_w * z0;
    const Scalar z12 = n1 - z6 - z7;
    const Scalar z13 = z8 + z9;
    const Scalar z14 = z10 - z11;
    const Scalar z15 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z16 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z17 = n9_81 * z13;
    const Scalar z18 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z19 = n9_81 * z14;
    const Scalar z20 = z5 + z15;
    const Scalar z21 = z15 + z16;
    const Scalar z22 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z23 = n9_81 * z12;
    const Scalar z24 = z8 - z9;
    const Scalar z25 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z26 = z10 + z11;
    const Scalar z27 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z28 = q_trunk_attitude_x * z0;
    const Scalar z29 = z23 + n0_2 * z3 + n0_05 * z18;
    const Scalar z30 = z17 + n0_2 * z4 - n0_05 * z21;
    const Scalar z31 = z22 * z22;
    const Scalar z32 = z19 - n0_2 * z20 + n0_05 * z4;
    const Scalar z33 = s_front_left_hip * z29 + c_front_left_hip * z30;
    const Scalar z34 = s_front_left_hip * z30 - c_front_left_hip * z29;
    const Scalar z35 = q_trunk_attitude_z * z2;
    const Scalar z36 = q_trunk_attitude_w * z2;
    const Scalar z37 = n1 - z6 - z35;
    const Scalar z38 = n1 - z35 - z7;
    const Scalar z39 = z28 + z36;
    const Scalar z40 = z28 - z36;
    const Scalar z41 = n0_05 * v_front_left_hip;
    const Scalar z42 = n0_05 * v_front_left_thigh;
    const Scalar z43 = n0_05 * v_front_left_knee;
    const Scalar z44 = n0_05 * v_front_right_hip;
    const Scalar z45 = n0_05 * v_front_right_thigh;
    const Scalar z46 = n0_05 * v_front_right_knee;
    const Scalar z47 = n0_05 * v_rear_left_hip;
    const Scalar z48 = n0_05 * v_rear_left_thigh;
    const Scalar z49 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z50 = n0_05 * v_rear_left_knee;
    const Scalar z51 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z52 = n0_05 * v_rear_right_hip;
    const Scalar z53 = z19 - n0_2 * z20 - n0_05 * z4;
    const Scalar z54 = n0_05 * v_rear_right_thigh;
    const Scalar z55 = z17 + n0_2 * z4 + n0_05 * z21;
    const Scalar z56 = n0_05 * v_rear_right_knee;
    const Scalar z57 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z58 = z23 + n0_2 * z3 - n0_05 * z18;
    const Scalar z59 = z57 * z57;
    const Scalar z60 = s_front_right_hip * z58 + c_front_right_hip * z55;
    const Scalar z61 = s_front_right_hip * z55 - c_front_right_hip * z58;
    const Scalar z62 = v_front_left_hip * z27;  // angular acceleration of front_left_hip_link, y
    const Scalar z63 = v_front_left_hip * z25;  // angular acceleration of front_left_hip_link, z
    const Scalar z64 = z25 * z22;
    const Scalar z65 = z27 * z27;
    const Scalar z66 = z25 * z27;
    const Scalar z67 = v_front_left_thigh + z25;  // angular velocity of front_left_thigh_link, y
    const Scalar z68 = v_front_right_hip * z49;  // angular acceleration of front_right_hip_link, z
    const Scalar z69 = c_front_right_thigh * z57 + s_front_right_thigh * z51;
    const Scalar z70 = s_front_right_thigh * z57 - c_front_right_thigh * z51;
    const Scalar z71 = z65 + z31;
    const Scalar z72 = z63 + z64;
    const Scalar z73 = z49 * z57;
    const Scalar z74 = z68 + z73;
    const Scalar z75 = z33 - n0_08 * z71;
    const Scalar z76 = z51 * z51;
    const Scalar z77 = z76 + z59;
    const Scalar z78 = s_front_right_thigh * z68;
    const Scalar z79 = c_front_right_thigh * z68;
    const Scalar z80 = v_front_right_thigh * z70 - z78;  // angular acceleration of front_right_thigh_link, x
    const Scalar z81 = v_front_right_thigh * z69 - z79;  // angular acceleration of front_right_thigh_link, z
    const Scalar z82 = z60 + n0_08 * z77;
    const Scalar z83 = c_front_left_thigh * z22 + s_front_left_thigh * z27;
    const Scalar z84 = s_front_left_thigh * z22 - c_front_left_thigh * z27;
    const Scalar z85 = v_front_right_thigh + z49;  // angular velocity of front_right_thigh_link, y
    const Scalar z86 = z49 * z51;
    const Scalar z87 = s_front_left_thigh * z63;
    const Scalar z88 = c_front_left_thigh * z63;
    const Scalar z89 = v_front_left_thigh * z84 - z87;  // angular acceleration of front_left_thigh_link, x
    const Scalar z90 = v_front_left_thigh * z83 - z88;  // angular acceleration of front_left_thigh_link, z
    const Scalar z91 = z70 * z85;
    const Scalar z92 = z80 + z91;
    const Scalar z93 = s_front_right_knee * z70 - c_front_right_knee * z69;
    const Scalar z94 = z84 * z67;
    const Scalar z95 = z89 + z94;
    const Scalar z96 = s_front_left_knee * z90 + c_front_left_knee * z89;
    const Scalar z97 = z53 - n0_08 * z74;
    const Scalar z98 = s_front_left_knee * z84 - c_front_left_knee * z83;
    const Scalar z99 = s_front_left_knee * z83 + c_front_left_knee * z84;
    const Scalar z100 = z83 * z84;
    const Scalar z101 = v_front_left_knee * z99 + z96;  // angular acceleration of front_left_shank_link, x
    const Scalar z102 = v_front_right_hip * z51;  // angular acceleration of front_right_hip_link, y
    const Scalar z103 = z32 + n0_08 * z72;
    const Scalar z104 = s_front_right_knee * z81 + c_front_right_knee * z80;
    const Scalar z105 = s_front_right_knee * z69 + c_front_right_knee * z70;
    const Scalar z106 = z69 * z70;
    const Scalar z107 = z61 - n0_08 * z86;
    const Scalar z108 = v_front_left_knee + z67;  // angular velocity of front_left_shank_link, y
    const Scalar z109 = z69 * z69;
    const Scalar z110 = z85 * z85;
    const Scalar z111 = z109 + z110;
    const Scalar z112 = z34 + n0_08 * z66;
    const Scalar z113 = z83 * z83;
    const Scalar z114 = z67 * z67;
    const Scalar z115 = z113 + z114;
    const Scalar z116 = z75 - n0_2 * z95;
    const Scalar z117 = s_front_right_thigh * z97 - c_front_right_thigh * z107;
    const Scalar z118 = s_front_right_thigh * z107 + c_front_right_thigh * z97;
    const Scalar z119 = s_front_left_thigh * z103 - c_front_left_thigh * z112;
    const Scalar z120 = s_front_left_thigh * z112 + c_front_left_thigh * z103;
    const Scalar z121 = v_front_right_knee * z105 + z104;  // angular acceleration of front_right_shank_link, x
    const Scalar z122 = z117 + n0_2 * z111;
    const Scalar z123 = z119 + n0_2 * z115;
    const Scalar z124 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z125 = v_front_right_knee + z85;  // angular velocity of front_right_shank_link, y
    const Scalar z126 = z82 - n0_2 * z92;
    const Scalar z127 = z102 - z106;
    const Scalar z128 = z62 - z100;
    const Scalar z129 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z130 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z131 = z23 - n0_2 * z3 + n0_05 * z18;
    const Scalar z132 = v_rear_left_hip * z124;  // angular acceleration of rear_left_hip_link, z
    const Scalar z133 = z17 - n0_2 * z4 - n0_05 * z21;
    const Scalar z134 = z19 + n0_2 * z20 + n0_05 * z4;
    const Scalar z135 = s_rear_left_hip * z131 + c_rear_left_hip * z133;
    const Scalar z136 = s_rear_left_hip * z133 - c_rear_left_hip * z131;
    const Scalar z137 = v_rear_left_hip * z130;  // angular acceleration of rear_left_hip_link, y
    const Scalar z138 = z118 + n0_2 * z127;
    const Scalar z139 = s_front_right_knee * z122 - c_front_right_knee * z138;
    const Scalar z140 = z120 + n0_2 * z128;
    const Scalar z141 = s_front_left_knee * z123 - c_front_left_knee * z140;
    const Scalar z142 = z17 - n0_2 * z4 + n0_05 * z21;
    const Scalar z143 = z19 + n0_2 * z20 - n0_05 * z4;
    const Scalar z144 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z145 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z146 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z147 = z23 - n0_2 * z3 - n0_05 * z18;
    const Scalar z148 = v_rear_right_hip * z145;  // angular acceleration of rear_right_hip_link, z
    const Scalar z149 = c_rear_right_thigh * z144 + s_rear_right_thigh * z146;
    const Scalar z150 = s_rear_right_thigh * z144 - c_rear_right_thigh * z146;
    const Scalar z151 = z145 * z144;
    const Scalar z152 = z148 + z151;
    const Scalar z153 = z146 * z146;
    const Scalar z154 = z144 * z144;
    const Scalar z155 = z153 + z154;
    const Scalar z156 = s_rear_right_thigh * z148;
    const Scalar z157 = c_rear_right_thigh * z148;
    const Scalar z158 = v_rear_right_thigh + z145;  // angular velocity of rear_right_thigh_link, y
    const Scalar z159 = z145 * z146;
    const Scalar z160 = c_rear_left_thigh * z129 + s_rear_left_thigh * z130;
    const Scalar z161 = s_rear_left_thigh * z129 - c_rear_left_thigh * z130;
    const Scalar z162 = s_rear_right_hip * z147 + c_rear_right_hip * z142;
    const Scalar z163 = s_rear_right_hip * z142 - c_rear_right_hip * z147;
    const Scalar z164 = z162 + n0_08 * z155;
    const Scalar z165 = z124 * z129;
    const Scalar z166 = v_rear_right_thigh * z150 - z156;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z167 = z132 + z165;
    const Scalar z168 = v_rear_right_thigh * z149 - z157;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z169 = z130 * z130;
    const Scalar z170 = z129 * z129;
    const Scalar z171 = z169 + z170;
    const Scalar z172 = s_rear_left_thigh * z132;
    const Scalar z173 = c_rear_left_thigh * z132;
    const Scalar z174 = v_rear_left_thigh * z161 - z172;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z175 = v_rear_left_thigh * z160 - z173;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z176 = z135 - n0_08 * z171;
    const Scalar z177 = z150 * z158;
    const Scalar z178 = v_rear_left_thigh + z124;  // angular velocity of rear_left_thigh_link, y
    const Scalar z179 = z124 * z130;
    const Scalar z180 = z166 + z177;
    const Scalar z181 = s_rear_right_knee * z150 - c_rear_right_knee * z149;
    const Scalar z182 = z143 - n0_08 * z152;
    const Scalar z183 = z161 * z178;
    const Scalar z184 = z174 + z183;
    const Scalar z185 = s_rear_left_knee * z175 + c_rear_left_knee * z174;
    const Scalar z186 = v_rear_right_hip * z146;  // angular acceleration of rear_right_hip_link, y
    const Scalar z187 = s_rear_left_knee * z161 - c_rear_left_knee * z160;
    const Scalar z188 = s_rear_left_knee * z160 + c_rear_left_knee * z161;
    const Scalar z189 = z160 * z161;
    const Scalar z190 = v_rear_left_knee * z188 + z185;  // angular acceleration of rear_left_shank_link, x
    const Scalar z191 = z163 - n0_08 * z159;
    const Scalar z192 = z134 + n0_08 * z167;
    const Scalar z193 = s_rear_right_knee * z168 + c_rear_right_knee * z166;
    const Scalar z194 = s_rear_right_knee * z149 + c_rear_right_knee * z150;
    const Scalar z195 = z149 * z150;
    const Scalar z196 = z149 * z149;
    const Scalar z197 = z158 * z158;
    const Scalar z198 = z196 + z197;
    const Scalar z199 = v_rear_left_knee + z178;  // angular velocity of rear_left_shank_link, y
    const Scalar z200 = z136 + n0_08 * z179;
    const Scalar z201 = s_rear_right_thigh * z182 - c_rear_right_thigh * z191;
    const Scalar z202 = s_rear_right_thigh * z191 + c_rear_right_thigh * z182;
    const Scalar z203 = z160 * z160;
    const Scalar z204 = z178 * z178;
    const Scalar z205 = z203 + z204;
    const Scalar z206 = z176 - n0_2 * z184;
    const Scalar z207 = z186 - z195;
    const Scalar z208 = s_rear_left_thigh * z192 - c_rear_left_thigh * z200;
    const Scalar z209 = s_rear_left_thigh * z200 + c_rear_left_thigh * z192;
    const Scalar z210 = v_rear_right_knee * z194 + z193;  // angular acceleration of rear_right_shank_link, x
    const Scalar z211 = z201 + n0_2 * z198;
    const Scalar z212 = z208 + n0_2 * z205;
    const Scalar z213 = v_rear_right_knee + z158;  // angular velocity of rear_right_shank_link, y
    const Scalar z214 = z181 * z194;
    const Scalar z215 = z164 - n0_2 * z180;
    const Scalar z216 = z137 - z189;
    const Scalar z217 = z194 * z213;
    const Scalar z218 = z186 + z214;
    const Scalar z219 = z181 * z181;
    const Scalar z220 = n0_032 * z218;  // force on rear_right_shank_link, x
    const Scalar z221 = z181 * z213;
    const Scalar z222 = z213 * z213;
    const Scalar z223 = z219 + z222;
    const Scalar z224 = z210 + z217;
    const Scalar z225 = n0_032 * z224;  // force on rear_right_shank_link, y
    const Scalar z226 = z202 + n0_2 * z207;
    const Scalar z227 = s_rear_right_knee * z211 - c_rear_right_knee * z226;
    const Scalar z228 = z209 + n0_2 * z216;
    const Scalar z229 = n0_032 * z215 - k7 * z217 - k8 * z210;  // moment on rear_right_shank_link, x
    const Scalar z230 = s_rear_left_knee * z212 - c_rear_left_knee * z228;
    const Scalar z231 = z149 * z158;
    const Scalar z232 = z168 + z231;
    const Scalar z233 = k7 * z186 + k8 * z214 - n0_032 * z227;  // moment on rear_right_shank_link, y
    const Scalar z234 = z146 * z144;
    const Scalar z235 = z160 * z178;
    const Scalar z236 = z175 + z235;
    const Scalar z237 = n0_032 * z223;  // force on rear_right_shank_link, z
    const Scalar z238 = z130 * z129;
    const Scalar z239 = k9 * z221;  // moment on rear_right_shank_link, z
    const Scalar z240 = z186 + z234;
    const Scalar z241 = z137 + z238;
    const Scalar z242 = z187 * z188;
    const Scalar z243 = z188 * z199;
    const Scalar z244 = n0_032 * z206 - k7 * z243 - k8 * z190;  // moment on rear_left_shank_link, x
    const Scalar z245 = z190 + z243;
    const Scalar z246 = n0_032 * z245;  // force on rear_left_shank_link, y
    const Scalar z247 = k7 * z137 + k8 * z242 - n0_032 * z230;  // moment on rear_left_shank_link, y
    const Scalar z248 = z137 + z242;
    const Scalar z249 = n0_032 * z248;  // force on rear_left_shank_link, x
    const Scalar z250 = z187 * z187;
    const Scalar z251 = z187 * z199;
    const Scalar z252 = z199 * z199;
    const Scalar z253 = z250 + z252;
    const Scalar z254 = k9 * z251;  // moment on rear_left_shank_link, z
    const Scalar z255 = s_rear_right_knee * z220 - c_rear_right_knee * z237;
    const Scalar z256 = s_rear_right_knee * z237 + c_rear_right_knee * z220;
    // moment on rear_right_thigh_link, y
    const Scalar z257 = k10 * z186 - k11 * z195 + n0_124 * z202 + n0_2 * z256 + z233;
    const Scalar z258 = n0_124 * z198 - z255;  // force on rear_right_thigh_link, z
    const Scalar z259 = n0_124 * z207 + z256;  // force on rear_right_thigh_link, x
    const Scalar z260 = n0_032 * z253;  // force on rear_left_shank_link, z
    const Scalar z261 = s_rear_left_knee * z249 - c_rear_left_knee * z260;
    const Scalar z262 = s_rear_left_knee * z260 + c_rear_left_knee * z249;
    const Scalar z263 = z257 + n0_0002 * z240;  // moment on rear_right_hip_link, y
    const Scalar z264 = n0_124 * z205 - z261;  // force on rear_left_thigh_link, z
    const Scalar z265 = s_rear_right_knee * z239 - c_rear_right_knee * z229;
    const Scalar z266 = c_rear_right_knee * z239 + s_rear_right_knee * z229;
    // moment on rear_left_thigh_link, y
    const Scalar z267 = k10 * z137 - k11 * z189 + n0_124 * z209 + n0_2 * z262 + z247;
    const Scalar z268 = n0_124 * z164 - k14 * z180 - n0_2 * z225 - z265;  // moment on rear_right_thigh_link, x
    const Scalar z269 = n0_124 * z180 + z225;  // force on rear_right_thigh_link, y
    const Scalar z270 = z266 - n0_0002 * z232;  // moment on rear_right_thigh_link, z
    const Scalar z271 = n0_124 * z216 + z262;  // force on rear_left_thigh_link, x
    const Scalar z272 = n0_1048 * z155 - z269;  // force on rear_right_hip_link, y
    const Scalar z273 = z267 + n0_0002 * z241;  // moment on rear_left_hip_link, y
    const Scalar z274 = z93 * z105;
    const Scalar z275 = z102 + z274;
    const Scalar z276 = s_rear_left_knee * z254 - c_rear_left_knee * z244;
    const Scalar z277 = c_rear_left_knee * z254 + s_rear_left_knee * z244;
    const Scalar z278 = n0_124 * z176 - k14 * z184 - n0_2 * z246 - z276;  // moment on rear_left_thigh_link, x
    const Scalar z279 = n0_124 * z184 + z246;  // force on rear_left_thigh_link, y
    const Scalar z280 = z277 - n0_0002 * z236;  // moment on rear_left_thigh_link, z
    const Scalar z281 = n0_1048 * z171 + z279;  // force on rear_left_hip_link, y
    const Scalar z282 = s_rear_right_thigh * z258 + c_rear_right_thigh * z259;
    const Scalar z283 = s_rear_right_thigh * z259 - c_rear_right_thigh * z258;
    const Scalar z284 = z105 * z125;
    const Scalar z285 = z121 + z284;
    const Scalar z286 = s_rear_right_thigh * z268 + c_rear_right_thigh * z270;
    const Scalar z287 = n0_1048 * z143 - k16 * z152 + n0_08 * z282 - z286;  // moment on rear_right_hip_link, z
    const Scalar z288 = n0_1048 * z152 - z282;  // force on rear_right_hip_link, x
    const Scalar z289 = s_rear_right_thigh * z270 - c_rear_right_thigh * z268;
    const Scalar z290 = n0_1048 * z163 - k17 * z159 + n0_08 * z283 - z289;  // moment on rear_right_hip_link, x
    const Scalar z291 = n0_1048 * z159 - z283;  // force on rear_right_hip_link, z
    const Scalar z292 = n0_032 * z126 - k7 * z284 - k8 * z121;  // moment on front_right_shank_link, x
    const Scalar z293 = k7 * z102 + k8 * z274 - n0_032 * z139;  // moment on front_right_shank_link, y
    const Scalar z294 = n0_032 * z275;  // force on front_right_shank_link, x
    const Scalar z295 = n0_032 * z285;  // force on front_right_shank_link, y
    const Scalar z296 = z93 * z93;
    const Scalar z297 = z93 * z125;
    const Scalar z298 = z125 * z125;
    const Scalar z299 = z296 + z298;
    const Scalar z300 = k9 * z297;  // moment on front_right_shank_link, z
    const Scalar z301 = s_rear_left_thigh * z264 + c_rear_left_thigh * z271;
    const Scalar z302 = s_rear_left_thigh * z271 - c_rear_left_thigh * z264;
    const Scalar z303 = n0_032 * z299;  // force on front_right_shank_link, z
    const Scalar z304 = s_rear_left_thigh * z278 + c_rear_left_thigh * z280;
    const Scalar z305 = n0_1048 * z134 + k16 * z167 + n0_08 * z301 + z304;  // moment on rear_left_hip_link, z
    const Scalar z306 = n0_1048 * z167 + z301;  // force on rear_left_hip_link, x
    const Scalar z307 = s_rear_left_thigh * z280 - c_rear_left_thigh * z278;
    const Scalar z308 = n0_1048 * z136 + k17 * z179 + n0_08 * z302 + z307;  // moment on rear_left_hip_link, x
    const Scalar z309 = n0_1048 * z179 + z302;  // force on rear_left_hip_link, z
    const Scalar z310 = s_rear_right_hip * z272 + c_rear_right_hip * z291;
    const Scalar z311 = s_rear_right_hip * z291 - c_rear_right_hip * z272;
    const Scalar z312 = s_front_right_knee * z294 - c_front_right_knee * z303;
    const Scalar z313 = s_front_right_knee * z303 + c_front_right_knee * z294;
    const Scalar z314 = s_rear_right_hip * z263 - c_rear_right_hip * z287;
    const Scalar z315 = c_rear_right_hip * z263 + s_rear_right_hip * z287;
    const Scalar z316 = z69 * z85;
    const Scalar z317 = n0_124 * z111 - z312;  // force on front_right_thigh_link, z
    const Scalar z318 = z81 + z316;
    const Scalar z319 = z51 * z57;
    // moment on front_right_thigh_link, y
    const Scalar z320 = k10 * z102 - k11 * z106 + n0_124 * z118 + n0_2 * z313 + z293;
    const Scalar z321 = n0_124 * z127 + z313;  // force on front_right_thigh_link, x
    const Scalar z322 = z102 + z319;
    const Scalar z323 = z320 + n0_0002 * z322;  // moment on front_right_hip_link, y
    const Scalar z324 = z98 * z99;
    const Scalar z325 = z99 * z108;
    const Scalar z326 = n0_032 * z116 - k7 * z325 - k8 * z101;  // moment on front_left_shank_link, x
    const Scalar z327 = z101 + z325;
    const Scalar z328 = n0_032 * z327;  // force on front_left_shank_link, y
    const Scalar z329 = k7 * z62 + k8 * z324 - n0_032 * z141;  // moment on front_left_shank_link, y
    const Scalar z330 = z62 + z324;
    const Scalar z331 = n0_032 * z330;  // force on front_left_shank_link, x
    const Scalar z332 = z98 * z98;
    const Scalar z333 = z98 * z108;
    const Scalar z334 = z108 * z108;
    const Scalar z335 = z332 + z334;
    const Scalar z336 = k9 * z333;  // moment on front_left_shank_link, z
    const Scalar z337 = s_front_right_knee * z300 - c_front_right_knee * z292;
    const Scalar z338 = c_front_right_knee * z300 + s_front_right_knee * z292;
    const Scalar z339 = n0_124 * z82 - k14 * z92 - n0_2 * z295 - z337;  // moment on front_right_thigh_link, x
    const Scalar z340 = n0_124 * z92 + z295;  // force on front_right_thigh_link, y
    const Scalar z341 = z338 - n0_0002 * z318;  // moment on front_right_thigh_link, z
    const Scalar z342 = n0_1048 * z77 - z340;  // force on front_right_hip_link, y
    const Scalar z343 = n0_032 * z335;  // force on front_left_shank_link, z
    const Scalar z344 = s_front_right_thigh * z317 + c_front_right_thigh * z321;
    const Scalar z345 = s_front_right_thigh * z321 - c_front_right_thigh * z317;
    const Scalar z346 = s_front_right_thigh * z339 + c_front_right_thigh * z341;
    const Scalar z347 = n0_1048 * z53 - k16 * z74 + n0_08 * z344 - z346;  // moment on front_right_hip_link, z
    const Scalar z348 = n0_1048 * z74 - z344;  // force on front_right_hip_link, x
    const Scalar z349 = s_front_right_thigh * z341 - c_front_right_thigh * z339;
    const Scalar z350 = n0_1048 * z61 - k17 * z86 + n0_08 * z345 - z349;  // moment on front_right_hip_link, x
    const Scalar z351 = n0_1048 * z86 - z345;  // force on front_right_hip_link, z
    const Scalar z352 = s_rear_left_hip * z281 + c_rear_left_hip * z309;
    const Scalar z353 = s_rear_left_hip * z309 - c_rear_left_hip * z281;
    const Scalar z354 = s_front_left_knee * z331 - c_front_left_knee * z343;
    const Scalar z355 = s_front_left_knee * z343 + c_front_left_knee * z331;
    const Scalar z356 = s_rear_left_hip * z273 + c_rear_left_hip * z305;
    const Scalar z357 = s_rear_left_hip * z305 - c_rear_left_hip * z273;
    const Scalar z358 = z45 - z320;
    const Scalar z359 = z83 * z67;
    const Scalar z360 = n0_124 * z115 - z354;  // force on front_left_thigh_link, z
    const Scalar z361 = z90 + z359;
    const Scalar z362 = z27 * z22;
    // moment on front_left_thigh_link, y
    const Scalar z363 = k10 * z62 - k11 * z100 + n0_124 * z120 + n0_2 * z355 + z329;
    const Scalar z364 = z43 - z329;
    const Scalar z365 = n0_124 * z128 + z355;  // force on front_left_thigh_link, x
    const Scalar z366 = z62 + z362;
    const Scalar z367 = z42 - z363;
    const Scalar z368 = z363 + n0_0002 * z366;  // moment on front_left_hip_link, y
    const Scalar z369 = z44 + z350;
    const Scalar z370 = s_front_left_knee * z336 - c_front_left_knee * z326;
    const Scalar z371 = c_front_left_knee * z336 + s_front_left_knee * z326;
    const Scalar z372 = n0_124 * z75 - k14 * z95 - n0_2 * z328 - z370;  // moment on front_left_thigh_link, x
    const Scalar z373 = n0_124 * z95 + z328;  // force on front_left_thigh_link, y
    const Scalar z374 = z371 - n0_0002 * z361;  // moment on front_left_thigh_link, z
    const Scalar z375 = n0_1048 * z71 + z373;  // force on front_left_hip_link, y
    const Scalar z376 = s_front_left_thigh * z360 + c_front_left_thigh * z365;
    const Scalar z377 = s_front_left_thigh * z365 - c_front_left_thigh * z360;
    const Scalar z378 = s_front_left_thigh * z372 + c_front_left_thigh * z374;
    const Scalar z379 = n0_1048 * z32 + k16 * z72 + n0_08 * z376 + z378;  // moment on front_left_hip_link, z
    const Scalar z380 = n0_1048 * z72 + z376;  // force on front_left_hip_link, x
    const Scalar z381 = s_front_left_thigh * z374 - c_front_left_thigh * z372;
    const Scalar z382 = n0_1048 * z34 + k17 * z66 + n0_08 * z377 + z381;  // moment on front_left_hip_link, x
    const Scalar z383 = n0_1048 * z66 + z377;  // force on front_left_hip_link, z
    const Scalar z384 = z41 - z382;
    const Scalar z385 = n12_24 * z19 - z288 + z306 - z348 + z380;  // force on trunk, x
    const Scalar z386 = s_front_right_hip * z342 + c_front_right_hip * z351;
    const Scalar z387 = s_front_right_hip * z351 - c_front_right_hip * z342;
    const Scalar z388 = z46 - z293;
    const Scalar z389 = z47 - z308;
    const Scalar z390 = s_front_right_hip * z323 - c_front_right_hip * z347;
    const Scalar z391 = c_front_right_hip * z323 + s_front_right_hip * z347;
    const Scalar z392 = z48 - z267;
    const Scalar z393 = z50 - z247;
    const Scalar z394 = z54 - z257;
    const Scalar z395 = z56 - z233;
    const Scalar z396 = z52 + z290;
    const Scalar z397 = s_front_left_hip * z375 + c_front_left_hip * z383;
    // moment on trunk, x
    const Scalar z398 = n0_0306 * z18 + z290 - z308 + z350 - z382 - n0_05 * (z310 + z352 + z386 + z397);
    const Scalar z399 = s_front_left_hip * z383 - c_front_left_hip * z375;
    const Scalar z400 = n12_24 * z23 + z310 - z352 + z386 - z397;  // force on trunk, z
    const Scalar z401 = n12_24 * z17 - z311 + z353 - z387 + z399;  // force on trunk, y
    const Scalar z402 = z37 * z385 + z26 * z400 + z40 * z401;
    const Scalar z403 = z39 * z385 + z24 * z400 + z38 * z401;
    const Scalar z404 = z14 * z385 + z12 * z400 + z13 * z401;
    const Scalar z405 = s_front_left_hip * z368 + c_front_left_hip * z379;
    // moment on trunk, z
    const Scalar z406 = n0_2948 * z4 - z314 - z356 - z390 - z405 - n0_05 * (z288 + z306 + z348 + z380) + n0_2 * (z311
        - z353 - z387 + z399);
    const Scalar z407 = s_front_left_hip * z379 - c_front_left_hip * z368;
    // moment on trunk, y
    const Scalar z408 = n0_3254 * z3 + z315 + z391 - z357 - z407 - n0_2 * (z310 - z352 - z386 + z397);
    forces.trunk_x = z402;
    forces.trunk_y = z403;
    forces.trunk_z = z404;
    forces.trunk_attitude_omega_x = z398;
    forces.trunk_attitude_omega_y = -z408;
    forces.trunk_attitude_omega_z = z406;
    forces.front_left_hip = z384;
    forces.front_left_thigh = z367;
    forces.front_left_knee = z364;
    forces.front_right_hip = z369;
    forces.front_right_thigh = z358;
    forces.front_right_knee = z388;
    forces.rear_left_hip = z389;
    forces.rear_left_thigh = z392;
    forces.rear_left_knee = z393;
    forces.rear_right_hip = z396;
    forces.rear_right_thigh = z394;
    forces.rear_right_knee = z395;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// the articulated-body recursion. Returns singular when a pivot is not
  /// positive relative to its diagonal entry.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs& inputs,
      Accelerations& accelerations, Multipliers&) noexcept {
    const Scalar k0 = traits::constant(0.00507, 0.00507f, "507/100000");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_124 = traits::constant(0.124, 0.124f, "31/250");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar k7 = traits::constant(0.01928, 0.01928f, "241/12500");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k9 = traits::constant(0.20040707687490214, 0.20040707f, "1280/6387");
    const Scalar k10 = traits::constant(0.01968, 0.01968f, "123/6250");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_1048 = traits::constant(0.1048, 0.1048f, "131/1250");
    const Scalar k13 = traits::constant(0.0086236, 0.0086236f, "21559/2500000");
    const Scalar k14 = traits::constant(0.0082236, 0.0082236f, "20559/2500000");
    const Scalar n12_24 = traits::constant(12.24, 12.24f, "306/25");
    const Scalar n0_3668 = traits::constant(0.3668, 0.3668f, "917/2500");
    const Scalar n0_3362 = traits::constant(0.3362, 0.3362f, "1681/5000");
    const Scalar n0_0406 = traits::constant(0.0406, 0.0406f, "203/5000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k20 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar k21 = traits::constant(3.96e-05, 3.96e-05f, "99/2500000");
    const Scalar k22 = traits::constant(6.262721152340692, 6.262721f, "40000/6387");
    const Scalar k23 = traits::constant(195.71003601064663, 195.71004f, "1250000/6387");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar k25 = traits::constant(0.01948, 0.01948f, "487/25000");
    const Scalar k26 = traits::constant(0.0080236, 0.0080236f, "20059/2500000");
    const Scalar n0_2948 = traits::constant(0.2948, 0.2948f, "737/2500");
    const Scalar n0_0306 = traits::constant(0.0306, 0.0306f, "153/5000");
    const Scalar n0_3254 = traits::constant(0.3254, 0.3254f, "1627/5000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar u_front_left_hip_torque = inputs.front_left_hip_torque;
    const Scalar u_front_left_thigh_torque = inputs.front_left_thigh_torque;
    const Scalar u_front_left_knee_torque = inputs.front_left_knee_torque;
    const Scalar u_front_right_hip_torque = inputs.front_right_hip_torque;
    const Scalar u_front_right_thigh_torque = inputs.front_right_thigh_torque;
    const Scalar u_front_right_knee_torque = inputs.front_right_knee_torque;
    const Scalar u_rear_left_hip_torque = inputs.rear_left_hip_torque;
    const Scalar u_rear_left_thigh_torque = inputs.rear_left_thigh_torque;
    const Scalar u_rear_left_knee_torque = inputs.rear_left_knee_torque;
    const Scalar u_rear_right_hip_torque = inputs.rear_right_hip_torque;
    const Scalar u_rear_right_thigh_torque = inputs.rear_right_thigh_torque;
    const Scalar u_rear_right_knee_torque = inputs.rear_right_knee_torque;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee};
    Scalar sines_[12], cosines_[12];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z0 = k0 * c_rear_right_knee;
    const Scalar z1 = k0 * c_rear_left_knee;
    const Scalar z2 = n0_032 * c_rear_right_knee;
    const Scalar z3 = n0_032 * c_rear_left_knee;
    const Scalar z4 = k0 * s_rear_right_knee;
    const Scalar z5 = n0_032 * s_rear_right_knee;
    const Scalar z6 = k0 * s_rear_left_knee;
    const Scalar z7 = n0_032 * s_rear_left_knee;
    const Scalar z8 = n2 * q_trunk_attitude_y;
    const Scalar z9 = n2 * q_trunk_attitude_x;
    const Scalar z10 = q_trunk_attitude_y * z8;
    const Scalar z11 = n0_032 * c_front_right_knee;
    const Scalar z12 = q_trunk_attitude_z * z8;
    const Scalar z13 = q_trunk_attitude_w * z9;
    const Scalar z14 = n2 * q_trunk_attitude_z;
    const Scalar z15 = n0_032 * s_front_right_knee;
    const Scalar z16 = q_trunk_attitude_x * z9;
    const Scalar z17 = z12 + z13;
    const Scalar z18 = q_trunk_attitude_x * z14;
    const Scalar z19 = q_trunk_attitude_w * z8;
    const Scalar z20 = n1 - z10 - z16;
    const Scalar z21 = z12 - z13;
    const Scalar z22 = z18 - z19;
    const Scalar z23 = z18 + z19;
    const Scalar z24 = q_trunk_attitude_z * z14;
    const Scalar z25 = q_trunk_attitude_x * z8;
    const Scalar z26 = q_trunk_attitude_w * z14;
    const Scalar z27 = n1 - z24 - z16;
    const Scalar z28 = n1 - z10 - z24;
    const Scalar z29 = k0 * c_front_right_knee;
    const Scalar z30 = k0 * s_front_right_knee;
    const Scalar z31 = z25 + z26;
    const Scalar z32 = z25 - z26;
    const Scalar z33 = k0 * c_front_left_knee;
    const Scalar z34 = n0_032 * c_front_left_knee;
    const Scalar z35 = k0 * s_front_left_knee;
    const Scalar z36 = n0_032 * s_front_left_knee;
    const Scalar z37 = c_rear_right_knee * z0;
    const Scalar z38 = s_rear_right_knee * z4;
    const Scalar z39 = s_rear_right_knee * z0;
    const Scalar z40 = n0_124 + z2;
    const Scalar z41 = c_rear_left_knee * z1;
    const Scalar z42 = s_rear_left_knee * z6;
    const Scalar z43 = s_rear_left_knee * z1;
    const Scalar z44 = n0_124 + z3;
    const Scalar z45 = c_front_right_knee * z29;
    const Scalar z46 = s_front_right_knee * z30;
    const Scalar z47 = s_front_right_knee * z29;
    const Scalar z48 = n0_124 + z11;
    const Scalar z49 = c_front_left_knee * z33;
    const Scalar z50 = s_front_left_knee * z35;
    const Scalar z51 = s_front_left_knee * z33;
    const Scalar z52 = n0_4 * z2 + z37;
    const Scalar z53 = n0_2 * z5 + z39;
    const Scalar z54 = n0_124 + z34;
    const Scalar z55 = s_rear_right_thigh * z5 - c_rear_right_thigh * z40;
    const Scalar z56 = c_rear_right_thigh * z5 + s_rear_right_thigh * z40;
    const Scalar z57 = n0_4 * z3 + z41;
    const Scalar z58 = n0_2 * z7 + z43;
    const Scalar z59 = s_rear_left_thigh * z7 - c_rear_left_thigh * z44;
    const Scalar z60 = c_rear_left_thigh * z7 + s_rear_left_thigh * z44;
    const Scalar z61 = n0_4 * z11 + z45;
    const Scalar z62 = n0_2 * z15 + z47;
    const Scalar z63 = s_front_right_thigh * z15 - c_front_right_thigh * z48;
    const Scalar z64 = c_front_right_thigh * z15 + s_front_right_thigh * z48;
    const Scalar z65 = n0_4 * z34 + z49;
    const Scalar z66 = n0_2 * z36 + z51;
    const Scalar z67 = k7 + z52;
    const Scalar z68 = s_front_left_thigh * z36 - c_front_left_thigh * z54;
    const Scalar z69 = c_front_left_thigh * z36 + s_front_left_thigh * z54;
    const Scalar z70 = n2 * z53;
    const Scalar z71 = k7 + z57;
    const Scalar z72 = n2 * z58;
    const Scalar z73 = k7 + z61;
    const Scalar z74 = n2 * z62;
    const Scalar z75 = k7 + z65;
    const Scalar z76 = z38 - z67;
    const Scalar z77 = n2 * z66;
    const Scalar z78 = z42 - z71;
    const Scalar z79 = z46 - z73;
    const Scalar z80 = z50 - z75;
    const Scalar z81 = s_rear_right_thigh * z76 - c_rear_right_thigh * z70;
    const Scalar z82 = s_rear_left_thigh * z78 - c_rear_left_thigh * z72;
    const Scalar z83 = s_front_right_thigh * z79 - c_front_right_thigh * z74;
    const Scalar z84 = s_front_left_thigh * z80 - c_front_left_thigh * z77;
    const Scalar z85 = s_rear_right_thigh * z81;
    const Scalar z86 = c_rear_right_thigh * z81 + z53;
    const Scalar z87 = s_rear_left_thigh * z82;
    const Scalar z88 = c_rear_left_thigh * z82 + z58;
    const Scalar z89 = s_front_right_thigh * z83;
    const Scalar z90 = c_front_right_thigh * z83 + z62;
    const Scalar z91 = s_front_left_thigh * z84;
    const Scalar z92 = z38 - z85;
    const Scalar z93 = z67 + z85;
    const Scalar z94 = c_front_left_thigh * z84 + z66;
    const Scalar z95 = n0_05 * v_rear_right_knee;
    const Scalar z96 = n0_05 * v_rear_left_knee;
    const Scalar z97 = n0_05 * v_front_right_knee;
    const Scalar z98 = n0_05 * v_front_left_knee;
    const Scalar z99 = u_front_left_knee_torque - z98;
    const Scalar z100 = n0_05 * v_rear_right_thigh;
    const Scalar z101 = n0_05 * v_rear_left_thigh;
    const Scalar z102 = n0_05 * v_front_right_thigh;
    const Scalar z103 = z71 + z87;
    const Scalar z104 = z42 - z87;
    const Scalar z105 = z73 + z89;
    const Scalar z106 = z46 - z89;
    const Scalar z107 = z75 + z91;
    const Scalar z108 = z50 - z91;
    const Scalar z109 = u_rear_right_knee_torque - z95;
    const Scalar z110 = u_rear_left_knee_torque - z96;
    const Scalar z111 = u_front_right_knee_torque - z97;
    const Scalar z112 = u_rear_right_thigh_torque - z100;
    const Scalar z113 = u_rear_left_thigh_torque - z101;
    const Scalar z114 = u_front_right_thigh_torque - z102;
    const Scalar z115 = k9 * c_rear_right_knee;
    const Scalar z116 = c_rear_right_knee * z115;
    const Scalar z117 = s_rear_right_knee * z115;
    const Scalar z118 = k9 * s_rear_right_knee;
    const Scalar z119 = s_rear_right_knee * z118;
    const Scalar z120 = n0_05 * v_front_left_thigh;
    const Scalar z121 = u_front_left_thigh_torque - z120;
    const Scalar z122 = n0_2 * z116;
    const Scalar z123 = n0_2 * z117;
    const Scalar z124 = n0_05 * v_rear_right_hip;
    const Scalar z125 = u_rear_right_hip_torque - z124;
    const Scalar z126 = n0_05 * v_rear_left_hip;
    const Scalar z127 = u_rear_left_hip_torque - z126;
    const Scalar z128 = n0_2 * z122;
    const Scalar z129 = n0_124 - z122;
    const Scalar z130 = n0_05 * v_front_right_hip;
    const Scalar z131 = u_front_right_hip_torque - z130;
    const Scalar z132 = n0_05 * v_front_left_hip;
    const Scalar z133 = u_front_left_hip_torque - z132;
    const Scalar z134 = k10 - z128;
    const Scalar z135 = n1 / z134;
    const Scalar z136 = z129 * z135;
    const Scalar z137 = z123 * z135;
    const Scalar z138 = z116 + z129 * z136;
    const Scalar z139 = z117 - z129 * z137;
    const Scalar z140 = z119 + z123 * z137;
    const Scalar z141 = z138 - z140;
    const Scalar z142 = n2 * z139;
    const Scalar z143 = s_rear_right_thigh * z141 + c_rear_right_thigh * z142;
    const Scalar z144 = s_rear_right_thigh * z143;
    const Scalar z145 = c_rear_right_thigh * z143 - z139;
    const Scalar z146 = z140 + z144;
    const Scalar z147 = z138 - z144;
    const Scalar z148 = n0_08 * z145;
    const Scalar z149 = n0_08 * z146;
    const Scalar z150 = n0_08 * z147;
    const Scalar z151 = z86 - n0_08 * z148;
    const Scalar z152 = z93 - n0_08 * z149;
    const Scalar z153 = z92 - n0_08 * z150;
    const Scalar z154 = n0_1048 - z149;
    const Scalar z155 = n0_1048 - z150;
    const Scalar z156 = k13 + z152;
    const Scalar z157 = k9 * s_rear_left_knee;
    const Scalar z158 = k14 + z153;
    const Scalar z159 = s_rear_left_knee * z157;
    const Scalar z160 = k9 * c_rear_left_knee;
    const Scalar z161 = c_rear_left_knee * z160;
    const Scalar z162 = n1 / z156;
    const Scalar z163 = s_rear_left_knee * z160;
    const Scalar z164 = z151 * z162;
    const Scalar z165 = n0_2 * z161;
    const Scalar z166 = z148 * z162;
    const Scalar z167 = n0_2 * z163;
    const Scalar z168 = z55 * z162;
    const Scalar z169 = n0_2 * z165;
    const Scalar z170 = z154 * z162;
    const Scalar z171 = k10 - z169;
    const Scalar z172 = z147 + z148 * z166;
    const Scalar z173 = n0_124 - z165;
    const Scalar z174 = z148 * z168;
    const Scalar z175 = n1 / z171;
    const Scalar z176 = z55 * z168;
    const Scalar z177 = z173 * z175;
    const Scalar z178 = z148 * z164 + z155;
    const Scalar z179 = z167 * z175;
    const Scalar z180 = z145 - z148 * z170;
    const Scalar z181 = z161 + z173 * z177;
    const Scalar z182 = z55 * z164 - z56;
    const Scalar z183 = z163 - z173 * z179;
    const Scalar z184 = z55 * z170;
    const Scalar z185 = z159 + z167 * z179;
    const Scalar z186 = z148 + z154 * z164;
    const Scalar z187 = z181 - z185;
    const Scalar z188 = z151 * z164 - z158;
    const Scalar z189 = n2 * z183;
    const Scalar z190 = z146 + z154 * z170;
    const Scalar z191 = s_rear_left_thigh * z187 + c_rear_left_thigh * z189;
    const Scalar z192 = n2 * z184;
    const Scalar z193 = s_rear_right_hip * z188;
    const Scalar z194 = s_rear_right_hip * z178;
    const Scalar z195 = c_rear_right_hip * z178;
    const Scalar z196 = s_rear_right_hip * z186 - c_rear_right_hip * z182;
    const Scalar z197 = z176 - z190;
    const Scalar z198 = c_rear_right_hip * z174 + s_rear_right_hip * z180;
    const Scalar z199 = s_rear_right_hip * z174 - c_rear_right_hip * z180;
    const Scalar z200 = n12_24 - z172;
    const Scalar z201 = s_rear_left_thigh * z191;
    const Scalar z202 = s_rear_right_hip * z193;
    const Scalar z203 = c_rear_right_hip * z193;
    const Scalar z204 = c_rear_right_hip * z192 + s_rear_right_hip * z197;
    const Scalar z205 = z185 + z201;
    const Scalar z206 = z188 - z202;
    const Scalar z207 = c_rear_left_thigh * z191 - z183;
    const Scalar z208 = z181 - z201;
    const Scalar z209 = n0_08 * z207;
    const Scalar z210 = n0_05 * z199;
    const Scalar z211 = z194 + n0_2 * z199;
    const Scalar z212 = n0_05 * z172 - z195 - n0_2 * z198;
    const Scalar z213 = n0_08 * z205;
    const Scalar z214 = n0_08 * z208;
    const Scalar z215 = s_rear_right_hip * z196;
    const Scalar z216 = c_rear_right_hip * z196 + z182;
    const Scalar z217 = c_rear_right_hip * z196;
    const Scalar z218 = s_rear_right_hip * z204;
    const Scalar z219 = c_rear_right_hip * z204 - z184;
    const Scalar z220 = z103 - n0_08 * z213;
    const Scalar z221 = z186 - z215;
    const Scalar z222 = n0_1048 - z213;
    const Scalar z223 = z88 - n0_08 * z209;
    const Scalar z224 = z104 - n0_08 * z214;
    const Scalar z225 = n0_1048 - z214;
    const Scalar z226 = z176 - z218;
    const Scalar z227 = z190 + z218;
    const Scalar z228 = n0_05 * z219;
    const Scalar z229 = z215 - n0_2 * z219;
    const Scalar z230 = z221 + n0_2 * z219 - z210;
    const Scalar z231 = k13 + z220;
    const Scalar z232 = k14 + z224;
    const Scalar z233 = n0_05 * z227;
    const Scalar z234 = z216 + n0_2 * z227;
    const Scalar z235 = n12_24 - z227;
    const Scalar z236 = n1 / z231;
    const Scalar z237 = z217 + n0_05 * z198 - n0_2 * z226;
    const Scalar z238 = z203 - n0_05 * z211 + n0_2 * (z221 - z229);
    const Scalar z239 = z206 - n0_05 * (z195 - z212) - n0_2 * (z217 + z237);
    const Scalar z240 = n0_2 * (z216 + z234) + z202;
    const Scalar z241 = n0_05 * z216 + n0_2 * z233;
    const Scalar z242 = n0_3668 - z239;
    const Scalar z243 = n0_3362 - z240;
    const Scalar z244 = n0_05 * (z221 - z210) + n0_2 * z228;
    const Scalar z245 = n12_24 - z226;
    const Scalar z246 = z222 * z236;
    const Scalar z247 = z59 * z236;
    const Scalar z248 = z223 * z236;
    const Scalar z249 = z223 * z248 - z232;
    const Scalar z250 = z205 + z222 * z246;
    const Scalar z251 = z209 + z222 * z248;
    const Scalar z252 = z209 * z248 + z225;
    const Scalar z253 = z207 - z209 * z246;
    const Scalar z254 = z59 * z248 - z60;
    const Scalar z255 = z59 * z247;
    const Scalar z256 = z59 * z246;
    const Scalar z257 = z209 * z236;
    const Scalar z258 = z208 + z209 * z257;
    const Scalar z259 = z209 * z247;
    const Scalar z260 = n0_05 * z233;
    const Scalar z261 = n0_0406 - z260;
    const Scalar z262 = k9 * c_front_right_knee;
    const Scalar z263 = c_front_right_knee * z262;
    const Scalar z264 = k9 * s_front_right_knee;
    const Scalar z265 = s_front_right_knee * z264;
    const Scalar z266 = z200 - z258;
    const Scalar z267 = z255 - z250;
    const Scalar z268 = n2 * z256;
    const Scalar z269 = s_rear_left_hip * z267 - c_rear_left_hip * z268;
    const Scalar z270 = c_rear_left_hip * z252;
    const Scalar z271 = s_rear_left_hip * z252;
    const Scalar z272 = s_rear_left_hip * z251 + c_rear_left_hip * z254;
    const Scalar z273 = c_rear_left_hip * z272 - z254;
    const Scalar z274 = c_rear_left_hip * z272;
    const Scalar z275 = s_rear_left_hip * z272;
    const Scalar z276 = s_rear_left_hip * z253 - c_rear_left_hip * z259;
    const Scalar z277 = s_rear_left_hip * z259 + c_rear_left_hip * z253;
    const Scalar z278 = n0_05 * z258 - z270 + n0_2 * z276;
    const Scalar z279 = c_rear_left_hip * z269 + z256;
    const Scalar z280 = s_rear_left_hip * z269;
    const Scalar z281 = z255 - z280;
    const Scalar z282 = z250 + z280;
    const Scalar z283 = z271 + n0_2 * z277;
    const Scalar z284 = z251 - z275;
    const Scalar z285 = z275 + n0_2 * z279;
    const Scalar z286 = z229 - z285;
    const Scalar z287 = z245 - z281;
    const Scalar z288 = z274 + n0_05 * z276 + n0_2 * z281;
    const Scalar z289 = z198 + z276;
    const Scalar z290 = z237 - z288;
    const Scalar z291 = z219 + z279;
    const Scalar z292 = z235 - z282;
    const Scalar z293 = z211 - z283;
    const Scalar z294 = z212 - z278;
    const Scalar z295 = z199 - z277;
    const Scalar z296 = n0_05 * z277;
    const Scalar z297 = z210 + z296;
    const Scalar z298 = s_rear_left_hip * z249;
    const Scalar z299 = s_front_right_knee * z262;
    const Scalar z300 = s_rear_left_hip * z298;
    const Scalar z301 = c_rear_left_hip * z298;
    const Scalar z302 = n0_2 * z263;
    const Scalar z303 = z273 - n0_2 * z282;
    const Scalar z304 = z301 - n0_05 * z283 - n0_2 * (z284 - z285);
    const Scalar z305 = z249 - z300;
    const Scalar z306 = z305 - n0_05 * (z270 - z278) + n0_2 * (z274 + z288);
    const Scalar z307 = z300 - n0_2 * (z273 + z303);
    const Scalar z308 = z243 - z307;
    const Scalar z309 = z238 + z304;
    const Scalar z310 = z234 - z303;
    const Scalar z311 = n0_05 * z282;
    const Scalar z312 = n0_05 * z273 - n0_2 * z311;
    const Scalar z313 = z242 - z306;
    const Scalar z314 = z233 - z311;
    const Scalar z315 = n0_05 * z311;
    const Scalar z316 = z261 - z315;
    const Scalar z317 = n0_2 * z302;
    const Scalar z318 = z241 + z312;
    const Scalar z319 = k10 - z317;
    const Scalar z320 = n0_124 - z302;
    const Scalar z321 = n0_2 * z299;
    const Scalar z322 = n0_05 * z279;
    const Scalar z323 = z296 + z284 - n0_2 * z279;
    const Scalar z324 = n0_05 * (z284 + z296) - n0_2 * z322;
    const Scalar z325 = z228 - z322;
    const Scalar z326 = z244 + z324;
    const Scalar z327 = z230 - z323;
    const Scalar z328 = n1 / z319;
    const Scalar z329 = z320 * z328;
    const Scalar z330 = z321 * z328;
    const Scalar z331 = z263 + z320 * z329;
    const Scalar z332 = z299 - z320 * z330;
    const Scalar z333 = z265 + z321 * z330;
    const Scalar z334 = z331 - z333;
    const Scalar z335 = n2 * z332;
    const Scalar z336 = s_front_right_thigh * z334 + c_front_right_thigh * z335;
    const Scalar z337 = s_front_right_thigh * z336;
    const Scalar z338 = c_front_right_thigh * z336 - z332;
    const Scalar z339 = z333 + z337;
    const Scalar z340 = z331 - z337;
    const Scalar z341 = n0_08 * z338;
    const Scalar z342 = n0_08 * z339;
    const Scalar z343 = n0_08 * z340;
    const Scalar z344 = z90 - n0_08 * z341;
    const Scalar z345 = z105 - n0_08 * z342;
    const Scalar z346 = z106 - n0_08 * z343;
    const Scalar z347 = n0_1048 - z342;
    const Scalar z348 = n0_1048 - z343;
    const Scalar z349 = k13 + z345;
    const Scalar z350 = k14 + z346;
    const Scalar z351 = n1 / z349;
    const Scalar z352 = z344 * z351;
    const Scalar z353 = z341 * z351;
    const Scalar z354 = z63 * z351;
    const Scalar z355 = z347 * z351;
    const Scalar z356 = z340 + z341 * z353;
    const Scalar z357 = z341 * z354;
    const Scalar z358 = z63 * z354;
    const Scalar z359 = z341 * z352 + z348;
    const Scalar z360 = z338 - z341 * z355;
    const Scalar z361 = z63 * z352 - z64;
    const Scalar z362 = z63 * z355;
    const Scalar z363 = k9 * s_front_left_knee;
    const Scalar z364 = z341 + z347 * z352;
    const Scalar z365 = k9 * c_front_left_knee;
    const Scalar z366 = z344 * z352 - z350;
    const Scalar z367 = c_front_left_knee * z365;
    const Scalar z368 = z339 + z347 * z355;
    const Scalar z369 = s_front_left_knee * z363;
    const Scalar z370 = n2 * z362;
    const Scalar z371 = s_front_right_hip * z366;
    const Scalar z372 = s_front_left_knee * z365;
    const Scalar z373 = s_front_right_hip * z359;
    const Scalar z374 = c_front_right_hip * z359;
    const Scalar z375 = s_front_right_hip * z364 - c_front_right_hip * z361;
    const Scalar z376 = z358 - z368;
    const Scalar z377 = c_front_right_hip * z357 + s_front_right_hip * z360;
    const Scalar z378 = s_front_right_hip * z357 - c_front_right_hip * z360;
    const Scalar z379 = z266 - z356;
    const Scalar z380 = s_front_right_hip * z371;
    const Scalar z381 = n0_2 * z367;
    const Scalar z382 = c_front_right_hip * z371;
    const Scalar z383 = c_front_right_hip * z370 + s_front_right_hip * z376;
    const Scalar z384 = z366 - z380;
    const Scalar z385 = n0_2 * z381;
    const Scalar z386 = k10 - z385;
    const Scalar z387 = n0_124 - z381;
    const Scalar z388 = n0_2 * z372;
    const Scalar z389 = n1 / z386;
    const Scalar z390 = n0_05 * z378;
    const Scalar z391 = z373 - n0_2 * z378;
    const Scalar z392 = n0_05 * z356 - z374 + n0_2 * z377;
    const Scalar z393 = z289 + z377;
    const Scalar z394 = z295 + z378;
    const Scalar z395 = s_front_right_hip * z375;
    const Scalar z396 = z387 * z389;
    const Scalar z397 = c_front_right_hip * z375 + z361;
    const Scalar z398 = c_front_right_hip * z375;
    const Scalar z399 = s_front_right_hip * z383;
    const Scalar z400 = c_front_right_hip * z383 - z362;
    const Scalar z401 = z297 + z390;
    const Scalar z402 = z364 - z395;
    const Scalar z403 = z367 + z387 * z396;
    const Scalar z404 = z388 * z389;
    const Scalar z405 = z372 - z387 * z404;
    const Scalar z406 = z369 + z388 * z404;
    const Scalar z407 = z293 + z391;
    const Scalar z408 = z294 + z392;
    const Scalar z409 = z403 - z406;
    const Scalar z410 = n2 * z405;
    const Scalar z411 = z358 - z399;
    const Scalar z412 = z368 + z399;
    const Scalar z413 = n0_05 * z400;
    const Scalar z414 = z395 + n0_2 * z400;
    const Scalar z415 = z402 - n0_2 * z400 - z390;
    const Scalar z416 = z291 + z400;
    const Scalar z417 = s_front_left_thigh * z409 + c_front_left_thigh * z410;
    const Scalar z418 = n0_05 * z412;
    const Scalar z419 = z397 - n0_2 * z412;
    const Scalar z420 = z398 + n0_05 * z377 + n0_2 * z411;
    const Scalar z421 = z287 - z411;
    const Scalar z422 = z292 - z412;
    const Scalar z423 = n0_05 * (z402 - z390) - n0_2 * z413;
    const Scalar z424 = z382 - n0_05 * z391 - n0_2 * (z402 - z414);
    const Scalar z425 = z384 - n0_05 * (z374 - z392) + n0_2 * (z398 + z420);
    const Scalar z426 = z326 + z423;
    const Scalar z427 = z309 + z424;
    const Scalar z428 = z325 + z413;
    const Scalar z429 = z286 + z414;
    const Scalar z430 = z290 + z420;
    const Scalar z431 = z313 - z425;
    const Scalar z432 = z327 + z415;
    const Scalar z433 = c_front_left_thigh * z417 - z405;
    const Scalar z434 = s_front_left_thigh * z417;
    const Scalar z435 = z406 + z434;
    const Scalar z436 = z403 - z434;
    const Scalar z437 = z380 - n0_2 * (z397 + z419);
    const Scalar z438 = z308 - z437;
    const Scalar z439 = z310 + z419;
    const Scalar z440 = n0_05 * z397 - n0_2 * z418;
    const Scalar z441 = z318 + z440;
    const Scalar z442 = z314 + z418;
    const Scalar z443 = n0_05 * z418;
    const Scalar z444 = z316 - z443;
    const Scalar z445 = n0_08 * z435;
    const Scalar z446 = z107 - n0_08 * z445;
    const Scalar z447 = n0_1048 - z445;
    const Scalar z448 = n0_08 * z433;
    const Scalar z449 = z94 - n0_08 * z448;
    const Scalar z450 = n0_08 * z436;
    const Scalar z451 = z108 - n0_08 * z450;
    const Scalar z452 = k13 + z446;
    const Scalar z453 = n0_1048 - z450;
    const Scalar z454 = n1 / z452;
    const Scalar z455 = k14 + z451;
    const Scalar z456 = z449 * z454;
    const Scalar z457 = z448 * z454;
    const Scalar z458 = z68 * z454;
    const Scalar z459 = z447 * z454;
    const Scalar z460 = z436 + z448 * z457;
    const Scalar z461 = z448 * z458;
    const Scalar z462 = z68 * z458;
    const Scalar z463 = z448 * z456 + z453;
    const Scalar z464 = z433 - z448 * z459;
    const Scalar z465 = z68 * z456 - z69;
    const Scalar z466 = z68 * z459;
    const Scalar z467 = z448 + z447 * z456;
    const Scalar z468 = z449 * z456 - z455;
    const Scalar z469 = z435 + z447 * z459;
    const Scalar z470 = n2 * z466;
    const Scalar z471 = s_front_left_hip * z468;
    const Scalar z472 = s_front_left_hip * z463;
    const Scalar z473 = c_front_left_hip * z463;
    const Scalar z474 = s_front_left_hip * z467 + c_front_left_hip * z465;
    const Scalar z475 = z462 - z469;
    const Scalar z476 = s_front_left_hip * z464 - c_front_left_hip * z461;
    const Scalar z477 = s_front_left_hip * z461 + c_front_left_hip * z464;
    const Scalar z478 = z379 - z460;
    const Scalar z479 = s_front_left_hip * z471;
    const Scalar z480 = c_front_left_hip * z471;
    const Scalar z481 = s_front_left_hip * z475 - c_front_left_hip * z470;
    const Scalar z482 = z468 - z479;
    const Scalar z483 = n0_05 * z477;
    const Scalar z484 = z472 - n0_2 * z477;
    const Scalar z485 = z394 - z477;
    const Scalar z486 = s_front_left_hip * z474;
    const Scalar z487 = c_front_left_hip * z474 - z465;
    const Scalar z488 = c_front_left_hip * z474;
    const Scalar z489 = n0_05 * z460 - z473 - n0_2 * z476;
    const Scalar z490 = z393 + z476;
    const Scalar z491 = z401 + z483;
    const Scalar z492 = z467 - z486;
    const Scalar z493 = s_front_left_hip * z481;
    const Scalar z494 = c_front_left_hip * z481 + z466;
    const Scalar z495 = z407 - z484;
    const Scalar z496 = z408 - z489;
    const Scalar z497 = z462 - z493;
    const Scalar z498 = z469 + z493;
    const Scalar z499 = n0_05 * z494;
    const Scalar z500 = z486 - n0_2 * z494;
    const Scalar z501 = z483 + z492 + n0_2 * z494;
    const Scalar z502 = z416 + z494;
    const Scalar z503 = n0_05 * z498;
    const Scalar z504 = z487 + n0_2 * z498;
    const Scalar z505 = z422 - z498;
    const Scalar z506 = z488 + n0_05 * z476 - n0_2 * z497;
    const Scalar z507 = z480 - n0_05 * z484 + n0_2 * (z492 - z500);
    const Scalar z508 = z482 - n0_05 * (z473 - z489) - n0_2 * (z488 + z506);
    const Scalar z509 = n0_05 * (z492 + z483) + n0_2 * z499;
    const Scalar z510 = z427 + z507;
    const Scalar z511 = z431 - z508;
    const Scalar z512 = z426 + z509;
    const Scalar z513 = z428 - z499;
    const Scalar z514 = z429 - z500;
    const Scalar z515 = z430 - z506;
    const Scalar z516 = z432 - z501;
    const Scalar z517 = z421 - z497;
    const Scalar z518 = n0_2 * (z487 + z504) + z479;
    const Scalar z519 = z438 - z518;
    const Scalar z520 = z439 - z504;
    const Scalar z521 = n1 / z511;
    const Scalar z522 = n0_05 * z487 + n0_2 * z503;
    const Scalar z523 = z441 + z522;
    const Scalar z524 = z442 - z503;
    const Scalar z525 = n0_05 * z503;
    const Scalar z526 = z444 - z525;
    const Scalar z527 = z512 * z521;
    const Scalar z528 = z510 * z521;
    const Scalar z529 = z496 * z521;
    const Scalar z530 = z515 * z521;
    const Scalar z531 = z516 * z521;
    const Scalar z532 = z491 - z496 * z527;
    const Scalar z533 = z526 - z512 * z527;
    const Scalar z534 = z496 * z529 - z478;
    const Scalar z535 = z513 - z515 * z527;
    const Scalar z536 = z524 + z516 * z527;
    const Scalar z537 = z495 - z496 * z528;
    const Scalar z538 = n9_81 * z22;
    const Scalar z539 = z519 - z510 * z528;
    const Scalar z540 = z523 + z512 * z528;
    const Scalar z541 = z514 + z515 * z528;
    const Scalar z542 = z515 * z530 - z517;
    const Scalar z543 = z515 * z531 - z502;
    const Scalar z544 = n1 / z539;
    const Scalar z545 = z520 + z516 * z528;
    const Scalar z546 = z516 * z531 - z505;
    const Scalar z547 = z496 * z530 + z490;
    const Scalar z548 = z496 * z531 - z485;
    const Scalar z549 = n9_81 * z17;
    const Scalar z550 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_y;
    const Scalar z551 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_y;
    const Scalar z552 = v_trunk_attitude_omega_z * v_trunk_attitude_omega_z;
    const Scalar z553 = z551 + z552;
    const Scalar z554 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_x;
    const Scalar z555 = z552 + z554;
    const Scalar z556 = n9_81 * z20;
    const Scalar z557 = v_trunk_attitude_omega_x * v_trunk_attitude_omega_z;
    const Scalar z558 = v_trunk_attitude_omega_y * v_trunk_attitude_omega_z;
    const Scalar z559 = z540 * z544;
    const Scalar z560 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z561 = z537 * z544;
    const Scalar z562 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z563 = z541 * z544;
    const Scalar z564 = z538 - n0_2 * z553 + n0_05 * z550;
    const Scalar z565 = z533 - z540 * z559;
    const Scalar z566 = z535 - z541 * z559;
    const Scalar z567 = z536 + z545 * z559;
    const Scalar z568 = n1 / z565;
    const Scalar z569 = z541 * z563 + z542;
    const Scalar z570 = z532 + z537 * z559;
    const Scalar z571 = z537 * z563 - z547;
    const Scalar z572 = z534 + z537 * z561;
    const Scalar z573 = z545 * z544;
    const Scalar z574 = z541 * z573 + z543;
    const Scalar z575 = z545 * z573 + z546;
    const Scalar z576 = z537 * z573 - z548;
    const Scalar z577 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z578 = z549 + n0_2 * z550 - n0_05 * z555;
    const Scalar z579 = v_front_left_hip * z560;  // angular acceleration of front_left_hip_link, z
    const Scalar z580 = z560 * z577;
    const Scalar z581 = z579 + z580;
    const Scalar z582 = z556 + n0_2 * z557 + n0_05 * z558;
    const Scalar z583 = s_front_left_hip * z578 - c_front_left_hip * z582;
    const Scalar z584 = s_front_left_hip * z582 + c_front_left_hip * z578;
    const Scalar z585 = z562 * z562;
    const Scalar z586 = z577 * z577;
    const Scalar z587 = z585 + z586;
    const Scalar z588 = z566 * z568;
    const Scalar z589 = z566 * z588 + z569;
    const Scalar z590 = z570 * z588 - z571;
    const Scalar z591 = z567 * z568;
    const Scalar z592 = z566 * z591 - z574;
    const Scalar z593 = z567 * z591 + z575;
    const Scalar z594 = z570 * z591 + z576;
    const Scalar z595 = z570 * z568;
    const Scalar z596 = z570 * z595 + z572;
    const Scalar z597 = z584 - n0_08 * z587;
    const Scalar z598 = z560 * z562;
    const Scalar z599 = z564 + n0_08 * z581;
    const Scalar z600 = c_front_left_thigh * z577 + s_front_left_thigh * z562;
    const Scalar z601 = z583 + n0_08 * z598;
    const Scalar z602 = s_front_left_thigh * z577 - c_front_left_thigh * z562;
    const Scalar z603 = s_front_left_thigh * z579;
    const Scalar z604 = c_front_left_thigh * z579;
    const Scalar z605 = s_front_left_thigh * z601 + c_front_left_thigh * z599;
    const Scalar z606 = z17 * z589 + z20 * z592 + z22 * z590;
    const Scalar z607 = z17 * z592 + z20 * z593 + z22 * z594;
    const Scalar z608 = z17 * z590 + z20 * z594 + z22 * z596;
    const Scalar z609 = z17 * z606 + z20 * z607 + z22 * z608;
    const Scalar z610 = v_front_left_hip * z562;  // angular acceleration of front_left_hip_link, y
    const Scalar z611 = z31 * z590 + z27 * z589 + z21 * z592;
    const Scalar z612 = z28 * z590 + z32 * z589 + z23 * z592;
    const Scalar z613 = n1 / z609;
    const Scalar z614 = z31 * z596 + z27 * z590 + z21 * z594;
    const Scalar z615 = z28 * z596 + z32 * z590 + z23 * z594;
    const Scalar z616 = s_front_left_thigh * z599 - c_front_left_thigh * z601;
    const Scalar z617 = v_front_left_thigh + z560;  // angular velocity of front_left_thigh_link, y
    const Scalar z618 = z31 * z594 + z27 * z592 + z21 * z593;
    const Scalar z619 = z28 * z594 + z32 * z592 + z23 * z593;
    const Scalar z620 = v_front_left_thigh * z602 - z603;  // angular acceleration of front_left_thigh_link, x
    const Scalar z621 = v_front_left_thigh * z600 - z604;  // angular acceleration of front_left_thigh_link, z
    const Scalar z622 = z600 * z600;
    const Scalar z623 = z617 * z617;
    const Scalar z624 = z600 * z602;
    const Scalar z625 = z602 * z617;
    const Scalar z626 = z620 + z625;
    const Scalar z627 = z17 * z611 + z20 * z618 + z22 * z614;
    const Scalar z628 = z31 * z614 + z27 * z611 + z21 * z618;
    const Scalar z629 = z28 * z614 + z32 * z611 + z23 * z618;
    const Scalar z630 = z627 * z613;
    const Scalar z631 = z628 - z627 * z630;
    const Scalar z632 = z17 * z612 + z20 * z619 + z22 * z615;
    const Scalar z633 = z28 * z615 + z32 * z612 + z23 * z619;
    const Scalar z634 = z622 + z623;
    const Scalar z635 = z616 + n0_2 * z634;
    const Scalar z636 = s_front_left_knee * z621 + c_front_left_knee * z620;
    const Scalar z637 = z632 * z630 - z629;
    const Scalar z638 = n1 / z631;
    const Scalar z639 = z605 - n0_2 * z624;
    const Scalar z640 = s_front_left_knee * z602 - c_front_left_knee * z600;
    const Scalar z641 = s_front_left_knee * z600 + c_front_left_knee * z602;
    const Scalar z642 = z597 - n0_2 * z626;
    const Scalar z643 = z632 * z613;
    const Scalar z644 = s_front_left_knee * z635 - c_front_left_knee * z639;
    const Scalar z645 = z633 - z632 * z643;
    const Scalar z646 = v_front_left_knee * z641 + z636;  // angular acceleration of front_left_shank_link, x
    const Scalar z647 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z648 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z649 = z538 - n0_2 * z553 - n0_05 * z550;
    const Scalar z650 = v_front_left_knee + z617;  // angular velocity of front_left_shank_link, y
    const Scalar z651 = z637 * z638;
    const Scalar z652 = z645 - z637 * z651;
    const Scalar z653 = z549 + n0_2 * z550 + n0_05 * z555;
    const Scalar z654 = z556 + n0_2 * z557 - n0_05 * z558;
    const Scalar z655 = n1 / z652;
    const Scalar z656 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z657 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z658 = z549 - n0_2 * z550 - n0_05 * z555;
    const Scalar z659 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z660 = v_rear_left_hip * z656;  // angular acceleration of rear_left_hip_link, z
    const Scalar z661 = z656 * z657;
    const Scalar z662 = z660 + z661;
    const Scalar z663 = z556 - n0_2 * z557 + n0_05 * z558;
    const Scalar z664 = v_front_right_hip * z647;  // angular acceleration of front_right_hip_link, z
    const Scalar z665 = z647 * z659;
    const Scalar z666 = z664 + z665;
    const Scalar z667 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z668 = z538 + n0_2 * z553 + n0_05 * z550;
    const Scalar z669 = s_rear_left_hip * z658 - c_rear_left_hip * z663;
    const Scalar z670 = s_rear_left_hip * z663 + c_rear_left_hip * z658;
    const Scalar z671 = z656 * z667;
    const Scalar z672 = z668 + n0_08 * z662;
    const Scalar z673 = c_rear_left_thigh * z657 + s_rear_left_thigh * z667;
    const Scalar z674 = s_front_right_hip * z653 - c_front_right_hip * z654;
    const Scalar z675 = s_front_right_hip * z654 + c_front_right_hip * z653;
    const Scalar z676 = z647 * z648;
    const Scalar z677 = v_front_right_thigh + z647;  // angular velocity of front_right_thigh_link, y
    const Scalar z678 = z649 - n0_08 * z666;
    const Scalar z679 = z669 + n0_08 * z671;
    const Scalar z680 = c_front_right_thigh * z659 + s_front_right_thigh * z648;
    const Scalar z681 = z674 - n0_08 * z676;
    const Scalar z682 = z680 * z680;
    const Scalar z683 = z677 * z677;
    const Scalar z684 = s_rear_left_thigh * z657 - c_rear_left_thigh * z667;
    const Scalar z685 = z682 + z683;
    const Scalar z686 = s_rear_left_thigh * z672 - c_rear_left_thigh * z679;
    const Scalar z687 = s_rear_left_thigh * z679 + c_rear_left_thigh * z672;
    const Scalar z688 = z667 * z667;
    const Scalar z689 = z657 * z657;
    const Scalar z690 = z688 + z689;
    const Scalar z691 = s_rear_left_thigh * z660;
    const Scalar z692 = c_rear_left_thigh * z660;
    const Scalar z693 = s_front_right_thigh * z659 - c_front_right_thigh * z648;
    const Scalar z694 = z670 - n0_08 * z690;
    const Scalar z695 = s_front_right_thigh * z678 - c_front_right_thigh * z681;
    const Scalar z696 = s_front_right_thigh * z681 + c_front_right_thigh * z678;
    const Scalar z697 = z695 + n0_2 * z685;
    const Scalar z698 = z648 * z648;
    const Scalar z699 = z659 * z659;
    const Scalar z700 = z698 + z699;
    const Scalar z701 = s_front_right_thigh * z664;
    const Scalar z702 = c_front_right_thigh * z664;
    const Scalar z703 = v_front_right_thigh * z693 - z701;  // angular acceleration of front_right_thigh_link, x
    const Scalar z704 = v_front_right_thigh * z680 - z702;  // angular acceleration of front_right_thigh_link, z
    const Scalar z705 = z675 + n0_08 * z700;
    const Scalar z706 = z680 * z693;
    const Scalar z707 = z693 * z677;
    const Scalar z708 = z703 + z707;
    const Scalar z709 = s_front_right_knee * z704 + c_front_right_knee * z703;
    const Scalar z710 = z696 - n0_2 * z706;
    const Scalar z711 = s_front_right_knee * z693 - c_front_right_knee * z680;
    const Scalar z712 = s_front_right_knee * z697 - c_front_right_knee * z710;
    const Scalar z713 = s_front_right_knee * z680 + c_front_right_knee * z693;
    const Scalar z714 = v_front_right_knee * z713 + z709;  // angular acceleration of front_right_shank_link, x
    const Scalar z715 = z705 - n0_2 * z708;
    const Scalar z716 = v_front_right_knee + z677;  // angular velocity of front_right_shank_link, y
    const Scalar z717 = v_rear_left_hip * z667;  // angular acceleration of rear_left_hip_link, y
    const Scalar z718 = v_front_right_hip * z648;  // angular acceleration of front_right_hip_link, y
    const Scalar z719 = z549 - n0_2 * z550 + n0_05 * z555;
    const Scalar z720 = z538 + n0_2 * z553 - n0_05 * z550;
    const Scalar z721 = v_rear_left_thigh + z656;  // angular velocity of rear_left_thigh_link, y
    const Scalar z722 = v_rear_left_thigh * z684 - z691;  // angular acceleration of rear_left_thigh_link, x
    const Scalar z723 = v_rear_left_thigh * z673 - z692;  // angular acceleration of rear_left_thigh_link, z
    const Scalar z724 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z725 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z726 = v_rear_right_hip * z724;  // angular acceleration of rear_right_hip_link, z
    const Scalar z727 = z724 * z725;
    const Scalar z728 = z556 - n0_2 * z557 - n0_05 * z558;
    const Scalar z729 = z726 + z727;
    const Scalar z730 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z731 = s_rear_right_hip * z719 - c_rear_right_hip * z728;
    const Scalar z732 = s_rear_right_hip * z728 + c_rear_right_hip * z719;
    const Scalar z733 = z724 * z730;
    const Scalar z734 = v_rear_right_thigh + z724;  // angular velocity of rear_right_thigh_link, y
    const Scalar z735 = z720 - n0_08 * z729;
    const Scalar z736 = c_rear_right_thigh * z725 + s_rear_right_thigh * z730;
    const Scalar z737 = z731 - n0_08 * z733;
    const Scalar z738 = z736 * z736;
    const Scalar z739 = z734 * z734;
    const Scalar z740 = s_rear_right_thigh * z725 - c_rear_right_thigh * z730;
    const Scalar z741 = z738 + z739;
    const Scalar z742 = s_rear_right_thigh * z735 - c_rear_right_thigh * z737;
    const Scalar z743 = s_rear_right_thigh * z737 + c_rear_right_thigh * z735;
    const Scalar z744 = z742 + n0_2 * z741;
    const Scalar z745 = z673 * z673;
    const Scalar z746 = z721 * z721;
    const Scalar z747 = z745 + z746;
    const Scalar z748 = z730 * z730;
    const Scalar z749 = z725 * z725;
    const Scalar z750 = z748 + z749;
    const Scalar z751 = s_rear_right_thigh * z726;
    const Scalar z752 = c_rear_right_thigh * z726;
    const Scalar z753 = v_rear_right_thigh * z740 - z751;  // angular acceleration of rear_right_thigh_link, x
    const Scalar z754 = z686 + n0_2 * z747;
    const Scalar z755 = z732 + n0_08 * z750;
    const Scalar z756 = v_rear_right_thigh * z736 - z752;  // angular acceleration of rear_right_thigh_link, z
    const Scalar z757 = z736 * z740;
    const Scalar z758 = z740 * z734;
    const Scalar z759 = z753 + z758;
    const Scalar z760 = s_rear_right_knee * z756 + c_rear_right_knee * z753;
    const Scalar z761 = z673 * z684;
    const Scalar z762 = z743 - n0_2 * z757;
    const Scalar z763 = s_rear_right_knee * z744 - c_rear_right_knee * z762;
    const Scalar z764 = z684 * z721;
    const Scalar z765 = z722 + z764;
    const Scalar z766 = s_rear_left_knee * z723 + c_rear_left_knee * z722;
    const Scalar z767 = z687 - n0_2 * z761;
    const Scalar z768 = s_rear_left_knee * z754 - c_rear_left_knee * z767;
    const Scalar z769 = s_rear_right_knee * z740 - c_rear_right_knee * z736;
    const Scalar z770 = s_rear_right_knee * z736 + c_rear_right_knee * z740;
    const Scalar z771 = v_rear_right_knee * z770 + z760;  // angular acceleration of rear_right_shank_link, x
    const Scalar z772 = z755 - n0_2 * z759;
    const Scalar z773 = v_rear_right_knee + z734;  // angular velocity of rear_right_shank_link, y
    const Scalar z774 = z769 * z770;
    const Scalar z775 = z770 * z773;
    const Scalar z776 = s_rear_left_knee * z684 - c_rear_left_knee * z673;
    const Scalar z777 = s_rear_left_knee * z673 + c_rear_left_knee * z684;
    const Scalar z778 = n0_032 * z763 - k0 * z774;
    const Scalar z779 = n0_032 * z774;
    const Scalar z780 = v_rear_left_knee * z777 + z766;  // angular acceleration of rear_left_shank_link, x
    const Scalar z781 = n0_032 * z772 - k20 * z775 - k0 * z771;
    const Scalar z782 = z771 + z775;
    const Scalar z783 = n0_032 * z782;
    const Scalar z784 = z769 * z769;
    const Scalar z785 = z769 * z773;
    const Scalar z786 = z773 * z773;
    const Scalar z787 = z784 + z786;
    const Scalar z788 = z694 - n0_2 * z765;
    const Scalar z789 = k21 * z785;
    const Scalar z790 = z109 - z778;
    const Scalar z791 = v_rear_left_knee + z721;  // angular velocity of rear_left_shank_link, y
    const Scalar z792 = z736 * z734;
    const Scalar z793 = z756 + z792;
    const Scalar z794 = n0_032 * z787;
    const Scalar z795 = z779 - k22 * z790;
    const Scalar z796 = k23 * z790;
    const Scalar z797 = c_rear_right_knee * z789 + s_rear_right_knee * z781;
    const Scalar z798 = s_rear_right_knee * z789 - c_rear_right_knee * z781;
    const Scalar z799 = s_rear_right_knee * z794 + c_rear_right_knee * z795;
    const Scalar z800 = s_rear_right_knee * z795 - c_rear_right_knee * z794;
    const Scalar z801 = v_rear_right_hip * z730;  // angular acceleration of rear_right_hip_link, y
    const Scalar z802 = z673 * z721;
    const Scalar z803 = z797 - n0_0002 * z793;
    const Scalar z804 = z723 + z802;
    const Scalar z805 = z109 - n0_124 * z743 + k7 * z757 - n0_2 * z799;
    const Scalar z806 = n0_124 * z755 - k25 * z759 - n0_2 * z783 - z798;
    const Scalar z807 = n0_124 * z757 - z799;
    const Scalar z808 = n0_124 * z741 - z800;
    const Scalar z809 = z730 * z725;
    const Scalar z810 = n0_124 * z759 + z783;
    const Scalar z811 = n0_1048 * z750 - z810;
    const Scalar z812 = z112 - z805;
    const Scalar z813 = z136 * z812 + z807;
    const Scalar z814 = z137 * z812 - z808;
    const Scalar z815 = z135 * z812;
    const Scalar z816 = z667 * z657;
    const Scalar z817 = z801 + z809;
    const Scalar z818 = z112 - n0_0002 * z817;
    const Scalar z819 = z717 + z816;
    const Scalar z820 = z776 * z777;
    const Scalar z821 = z777 * z791;
    const Scalar z822 = n0_032 * z768 - k0 * z820;
    const Scalar z823 = n0_032 * z820;
    const Scalar z824 = n0_032 * z788 - k20 * z821 - k0 * z780;
    const Scalar z825 = z780 + z821;
    const Scalar z826 = z110 - z822;
    const Scalar z827 = n0_032 * z825;
    const Scalar z828 = z776 * z776;
    const Scalar z829 = z776 * z791;
    const Scalar z830 = z791 * z791;
    const Scalar z831 = z828 + z830;
    const Scalar z832 = k21 * z829;
    const Scalar z833 = z823 - k22 * z826;
    const Scalar z834 = k23 * z826;
    const Scalar z835 = c_rear_left_knee * z832 + s_rear_left_knee * z824;
    const Scalar z836 = s_rear_left_knee * z832 - c_rear_left_knee * z824;
    const Scalar z837 = n0_032 * z831;
    const Scalar z838 = s_rear_left_knee * z837 + c_rear_left_knee * z833;
    const Scalar z839 = s_rear_left_knee * z833 - c_rear_left_knee * z837;
    const Scalar z840 = s_rear_right_thigh * z803 - c_rear_right_thigh * z806;
    const Scalar z841 = z835 - n0_0002 * z804;
    const Scalar z842 = n0_124 * z694 - k25 * z765 - n0_2 * z827 - z836;
    const Scalar z843 = z110 - n0_124 * z687 + k7 * z761 - n0_2 * z838;
    const Scalar z844 = n0_124 * z761 - z838;
    const Scalar z845 = s_rear_right_thigh * z806 + c_rear_right_thigh * z803;
    const Scalar z846 = n0_124 * z747 - z839;
    const Scalar z847 = n0_124 * z765 + z827;
    const Scalar z848 = z113 - z843;
    const Scalar z849 = z177 * z848 + z844;
    const Scalar z850 = z179 * z848 - z846;
    const Scalar z851 = z175 * z848;
    const Scalar z852 = s_rear_left_thigh * z841 - c_rear_left_thigh * z842;
    const Scalar z853 = s_rear_left_thigh * z842 + c_rear_left_thigh * z841;
    const Scalar z854 = s_rear_right_thigh * z813 - c_rear_right_thigh * z814;
    const Scalar z855 = s_rear_right_thigh * z814 + c_rear_right_thigh * z813;
    const Scalar z856 = n0_1048 * z731 - z840 - k26 * z733 - n0_08 * z854;
    const Scalar z857 = n0_1048 * z720 - z845 - k14 * z729 - n0_08 * z855;
    const Scalar z858 = n0_1048 * z733 + z854;
    const Scalar z859 = n0_1048 * z690 + z847;
    const Scalar z860 = z113 - n0_0002 * z819;
    const Scalar z861 = n0_1048 * z729 + z855;
    const Scalar z862 = z125 - z856;
    const Scalar z863 = z164 * z862 + z857;
    const Scalar z864 = z168 * z862 - z811;
    const Scalar z865 = z170 * z862 - z858;
    const Scalar z866 = z166 * z862 + z861;
    const Scalar z867 = z162 * z862;
    const Scalar z868 = z711 * z713;
    const Scalar z869 = z713 * z716;
    const Scalar z870 = s_rear_left_thigh * z849 - c_rear_left_thigh * z850;
    const Scalar z871 = s_rear_left_thigh * z850 + c_rear_left_thigh * z849;
    const Scalar z872 = z852 + n0_1048 * z669 + k26 * z671 - n0_08 * z870;
    const Scalar z873 = z853 + n0_1048 * z668 + k14 * z662 - n0_08 * z871;
    const Scalar z874 = n0_1048 * z671 - z870;
    const Scalar z875 = n0_1048 * z662 - z871;
    const Scalar z876 = z127 + z872;
    const Scalar z877 = z248 * z876 - z873;
    const Scalar z878 = z247 * z876 + z859;
    const Scalar z879 = z246 * z876 - z874;
    const Scalar z880 = z257 * z876 + z875;
    const Scalar z881 = z236 * z876;
    const Scalar z882 = s_rear_right_hip * z818 + c_rear_right_hip * z863;
    const Scalar z883 = s_rear_right_hip * z863 - c_rear_right_hip * z818;
    const Scalar z884 = s_rear_left_hip * z860 + c_rear_left_hip * z877;
    const Scalar z885 = s_rear_left_hip * z877 - c_rear_left_hip * z860;
    const Scalar z886 = s_rear_right_hip * z865 - c_rear_right_hip * z864;
    const Scalar z887 = s_rear_right_hip * z864 + c_rear_right_hip * z865;
    const Scalar z888 = z680 * z677;
    const Scalar z889 = z704 + z888;
    const Scalar z890 = z648 * z659;
    const Scalar z891 = n0_032 * z712 - k0 * z868;
    const Scalar z892 = n0_032 * z868;
    const Scalar z893 = z111 - z891;
    const Scalar z894 = n0_032 * z715 - k20 * z869 - k0 * z714;
    const Scalar z895 = z714 + z869;
    const Scalar z896 = z892 - k22 * z893;
    const Scalar z897 = n0_032 * z895;
    const Scalar z898 = z718 + z890;
    const Scalar z899 = z114 - n0_0002 * z898;
    const Scalar z900 = k23 * z893;
    const Scalar z901 = z711 * z711;
    const Scalar z902 = z711 * z716;
    const Scalar z903 = z716 * z716;
    const Scalar z904 = z901 + z903;
    const Scalar z905 = k21 * z902;
    const Scalar z906 = z640 * z641;
    const Scalar z907 = z641 * z650;
    const Scalar z908 = n0_124 * z708 + z897;
    const Scalar z909 = n0_1048 * z700 - z908;
    const Scalar z910 = n0_032 * z904;
    const Scalar z911 = c_front_right_knee * z905 + s_front_right_knee * z894;
    const Scalar z912 = s_front_right_knee * z905 - c_front_right_knee * z894;
    const Scalar z913 = s_front_right_knee * z910 + c_front_right_knee * z896;
    const Scalar z914 = s_front_right_knee * z896 - c_front_right_knee * z910;
    const Scalar z915 = n0_124 * z705 - k25 * z708 - n0_2 * z897 - z912;
    const Scalar z916 = z911 - n0_0002 * z889;
    const Scalar z917 = z111 - n0_124 * z696 + k7 * z706 - n0_2 * z913;
    const Scalar z918 = n0_124 * z706 - z913;
    const Scalar z919 = z114 - z917;
    const Scalar z920 = n0_124 * z685 - z914;
    const Scalar z921 = s_front_right_thigh * z916 - c_front_right_thigh * z915;
    const Scalar z922 = s_front_right_thigh * z915 + c_front_right_thigh * z916;
    const Scalar z923 = z329 * z919 + z918;
    const Scalar z924 = z330 * z919 - z920;
    const Scalar z925 = z328 * z919;
    const Scalar z926 = s_front_right_thigh * z923 - c_front_right_thigh * z924;
    const Scalar z927 = s_front_right_thigh * z924 + c_front_right_thigh * z923;
    const Scalar z928 = s_rear_left_hip * z879 + c_rear_left_hip * z878;
    const Scalar z929 = s_rear_left_hip * z878 - c_rear_left_hip * z879;
    const Scalar z930 = z600 * z617;
    const Scalar z931 = z621 + z930;
    const Scalar z932 = n0_1048 * z674 - z921 - k26 * z676 - n0_08 * z926;
    const Scalar z933 = z562 * z577;
    const Scalar z934 = n0_1048 * z649 - z922 - k14 * z666 - n0_08 * z927;
    const Scalar z935 = n0_1048 * z676 + z926;
    const Scalar z936 = n0_1048 * z666 + z927;
    const Scalar z937 = n0_032 * z644 - k0 * z906;
    const Scalar z938 = n0_032 * z906;
    const Scalar z939 = z99 - z937;
    const Scalar z940 = n0_032 * z642 - k20 * z907 - k0 * z646;
    const Scalar z941 = z646 + z907;
    const Scalar z942 = z938 - k22 * z939;
    const Scalar z943 = n0_032 * z941;
    const Scalar z944 = z131 - z932;
    const Scalar z945 = z610 + z933;
    const Scalar z946 = z352 * z944 + z934;
    const Scalar z947 = z121 - n0_0002 * z945;
    const Scalar z948 = z354 * z944 - z909;
    const Scalar z949 = z355 * z944 - z935;
    const Scalar z950 = z353 * z944 + z936;
    const Scalar z951 = z351 * z944;
    const Scalar z952 = k23 * z939;
    const Scalar z953 = z640 * z640;
    const Scalar z954 = z640 * z650;
    const Scalar z955 = z650 * z650;
    const Scalar z956 = z953 + z955;
    const Scalar z957 = k21 * z954;
    const Scalar z958 = n0_124 * z626 + z943;
    const Scalar z959 = n0_1048 * z587 + z958;
    const Scalar z960 = n0_032 * z956;
    const Scalar z961 = c_front_left_knee * z957 + s_front_left_knee * z940;
    const Scalar z962 = s_front_left_knee * z957 - c_front_left_knee * z940;
    const Scalar z963 = s_front_left_knee * z960 + c_front_left_knee * z942;
    const Scalar z964 = s_front_left_knee * z942 - c_front_left_knee * z960;
    const Scalar z965 = n0_124 * z597 - k25 * z626 - n0_2 * z943 - z962;
    const Scalar z966 = z961 - n0_0002 * z931;
    const Scalar z967 = z99 - n0_124 * z605 + k7 * z624 - n0_2 * z963;
    const Scalar z968 = n0_124 * z624 - z963;
    const Scalar z969 = z121 - z967;
    const Scalar z970 = n0_124 * z634 - z964;
    const Scalar z971 = s_front_left_thigh * z966 - c_front_left_thigh * z965;
    const Scalar z972 = s_front_left_thigh * z965 + c_front_left_thigh * z966;
    const Scalar z973 = z396 * z969 + z968;
    const Scalar z974 = z404 * z969 - z970;
    const Scalar z975 = z389 * z969;
    const Scalar z976 = s_front_left_thigh * z973 - c_front_left_thigh * z974;
    const Scalar z977 = s_front_left_thigh * z974 + c_front_left_thigh * z973;
    const Scalar z978 = s_front_right_hip * z899 + c_front_right_hip * z946;
    const Scalar z979 = s_front_right_hip * z946 - c_front_right_hip * z899;
    const Scalar z980 = s_front_right_hip * z949 - c_front_right_hip * z948;
    const Scalar z981 = z971 + n0_1048 * z583 + k26 * z598 - n0_08 * z976;
    const Scalar z982 = z972 + n0_1048 * z564 + k14 * z581 - n0_08 * z977;
    const Scalar z983 = n0_1048 * z598 - z976;
    const Scalar z984 = n0_1048 * z581 - z977;
    const Scalar z985 = s_front_right_hip * z948 + c_front_right_hip * z949;
    const Scalar z986 = z133 + z981;
    const Scalar z987 = z456 * z986 - z982;
    const Scalar z988 = z458 * z986 + z959;
    const Scalar z989 = z459 * z986 - z983;
    const Scalar z990 = z457 * z986 + z984;
    const Scalar z991 = z454 * z986;
    const Scalar z992 = n12_24 * z538 - z866 + z880 - z950 + z990;
    const Scalar z993 = s_front_left_hip * z947 + c_front_left_hip * z987;
    const Scalar z994 = s_front_left_hip * z987 - c_front_left_hip * z947;
    const Scalar z995 = s_front_left_hip * z989 + c_front_left_hip * z988;
    const Scalar z996 = n0_2948 * z550 + z882 + z884 + z978 + z993 - n0_05 * (z866 + z880 + z950 + z990) - n0_2 * (z886
        - z928 - z980 + z995);
    const Scalar z997 = n12_24 * z549 + z886 - z928 + z980 - z995;
    const Scalar z998 = s_front_left_hip * z988 - c_front_left_hip * z989;
    const Scalar z999 = n0_0306 * z558 + z133 + z131 + z127 + z125 + n0_05 * (z887 - z929 + z985 - z998);
    const Scalar z1000 = n0_3254 * z557 + z883 + z885 + z979 + z994 + n0_2 * (z887 + z929 - z985 - z998);
    const Scalar z1001 = n12_24 * z556 - z887 - z929 - z985 - z998;
    const Scalar z1002 = z527 * z996 + z999;
    const Scalar z1003 = z528 * z996 + z1000;
    const Scalar z1004 = z529 * z996 + z992;
    const Scalar z1005 = z530 * z996 + z997;
    const Scalar z1006 = z531 * z996 - z1001;
    const Scalar z1007 = z521 * z996;
    const Scalar z1008 = z559 * z1003 + z1002;
    const Scalar z1009 = z561 * z1003 - z1004;
    const Scalar z1010 = z563 * z1003 + z1005;
    const Scalar z1011 = z573 * z1003 + z1006;
    const Scalar z1012 = z544 * z1003;
    const Scalar z1013 = z595 * z1008 + z1009;
    const Scalar z1014 = z588 * z1008 - z1010;
    const Scalar z1015 = z591 * z1008 + z1011;
    const Scalar z1016 = z568 * z1008;
    const Scalar z1017 = z28 * z1013 + z32 * z1014 + z23 * z1015;
    const Scalar z1018 = z31 * z1013 + z27 * z1014 + z21 * z1015;
    const Scalar z1019 = z17 * z1014 + z20 * z1015 + z22 * z1013;
    const Scalar z1020 = z613 * z1019;
    const Scalar z1021 = z643 * z1019 - z1017;
    const Scalar z1022 = z630 * z1019 - z1018;
    const Scalar z1023 = z638 * z1022;
    const Scalar z1024 = z651 * z1022 + z1021;
    const Scalar z1025 = z655 * z1024;
    const Scalar z1026 = z651 * z1025 + z1023;
    const Scalar z1027 = z1020 + z643 * z1025 + z630 * z1026;
    const Scalar z1028 = z28 * z1025 + z31 * z1026 - z22 * z1027;
    const Scalar z1029 = z32 * z1025 + z27 * z1026 - z17 * z1027;
    const Scalar z1030 = z23 * z1025 + z21 * z1026 - z20 * z1027;
    const Scalar z1031 = z1016 + z595 * z1028 + z588 * z1029 + z591 * z1030;
    const Scalar z1032 = z1012 + z561 * z1028 - z563 * z1029 + z573 * z1030 + z559 * z1031;
    const Scalar z1033 = z1007 - z529 * z1028 - z530 * z1029 + z531 * z1030 + z527 * z1031 + z528 * z1032;
    const Scalar z1034 = z1030 - n0_05 * z1031 - n0_2 * z1032;
    const Scalar z1035 = z1030 + n0_05 * z1031 - n0_2 * z1032;
    const Scalar z1036 = z1030 - n0_05 * z1031 + n0_2 * z1032;
    const Scalar z1037 = z1030 + n0_05 * z1031 + n0_2 * z1032;
    const Scalar z1038 = z1028 + n0_05 * z1033;
    const Scalar z1039 = z1029 - n0_2 * z1033;
    const Scalar z1040 = s_front_left_hip * z1033 - c_front_left_hip * z1032;
    const Scalar z1041 = s_front_left_hip * z1032 + c_front_left_hip * z1033;
    const Scalar z1042 = z1028 - n0_05 * z1033;
    const Scalar z1043 = s_front_right_hip * z1033 - c_front_right_hip * z1032;
    const Scalar z1044 = s_front_right_hip * z1032 + c_front_right_hip * z1033;
    const Scalar z1045 = z1029 + n0_2 * z1033;
    const Scalar z1046 = s_rear_left_hip * z1033 - c_rear_left_hip * z1032;
    const Scalar z1047 = s_rear_left_hip * z1032 + c_rear_left_hip * z1033;
    const Scalar z1048 = s_rear_right_hip * z1032 + c_rear_right_hip * z1033;
    const Scalar z1049 = s_rear_right_hip * z1033 - c_rear_right_hip * z1032;
    const Scalar z1050 = s_front_left_hip * z1034 + c_front_left_hip * z1039;
    const Scalar z1051 = s_front_left_hip * z1039 - c_front_left_hip * z1034;
    const Scalar z1052 = s_front_right_hip * z1035 + c_front_right_hip * z1039;
    const Scalar z1053 = s_front_right_hip * z1039 - c_front_right_hip * z1035;
    const Scalar z1054 = z991 + z456 * z1041 - z457 * z1038 + z458 * z1050 + z459 * z1051;
    const Scalar z1055 = z951 + z352 * z1044 + z353 * z1042 + z354 * z1052 - z355 * z1053;
    const Scalar z1056 = z1038 + n0_08 * z1041;
    const Scalar z1057 = z1042 - n0_08 * z1044;
    const Scalar z1058 = z1051 - n0_08 * z1054;
    const Scalar z1059 = z1031 + z1054;
    const Scalar z1060 = z1053 + n0_08 * z1055;
    const Scalar z1061 = z1031 + z1055;
    const Scalar z1062 = s_rear_left_hip * z1036 + c_rear_left_hip * z1045;
    const Scalar z1063 = s_rear_left_hip * z1045 - c_rear_left_hip * z1036;
    const Scalar z1064 = z881 + z248 * z1047 - z257 * z1038 + z247 * z1062 + z246 * z1063;
    const Scalar z1065 = z1038 + n0_08 * z1047;
    const Scalar z1066 = s_rear_right_hip * z1037 + c_rear_right_hip * z1045;
    const Scalar z1067 = s_rear_right_hip * z1045 - c_rear_right_hip * z1037;
    const Scalar z1068 = z867 + z164 * z1048 + z166 * z1042 + z168 * z1066 - z170 * z1067;
    const Scalar z1069 = z1042 - n0_08 * z1048;
    const Scalar z1070 = z1063 - n0_08 * z1064;
    const Scalar z1071 = z1031 + z1064;
    const Scalar z1072 = z1031 + z1068;
    const Scalar z1073 = z1067 + n0_08 * z1068;
    const Scalar z1074 = c_front_left_thigh * z1056 + s_front_left_thigh * z1058;
    const Scalar z1075 = s_front_left_thigh * z1056 - c_front_left_thigh * z1058;
    const Scalar z1076 = z975 + z396 * z1074 + z404 * z1075;
    const Scalar z1077 = c_front_right_thigh * z1057 + s_front_right_thigh * z1060;
    const Scalar z1078 = s_front_right_thigh * z1057 - c_front_right_thigh * z1060;
    const Scalar z1079 = z925 + z329 * z1077 + z330 * z1078;
    const Scalar z1080 = z1074 - n0_2 * z1076;
    const Scalar z1081 = z1040 + z1076;
    const Scalar z1082 = c_rear_left_thigh * z1065 + s_rear_left_thigh * z1070;
    const Scalar z1083 = z610 + z1081;  // acceleration of joint front_left_thigh_link
    const Scalar z1084 = s_rear_left_thigh * z1065 - c_rear_left_thigh * z1070;
    const Scalar z1085 = z851 + z177 * z1082 + z179 * z1084;
    const Scalar z1086 = s_front_left_knee * z1075 - c_front_left_knee * z1080;
    const Scalar z1087 = z952 - k22 * z1086;
    const Scalar z1088 = z1077 - n0_2 * z1079;
    const Scalar z1089 = s_front_right_knee * z1078 - c_front_right_knee * z1088;
    const Scalar z1090 = z1082 - n0_2 * z1085;
    const Scalar z1091 = z1076 - z1087;
    const Scalar z1092 = c_rear_right_thigh * z1069 + s_rear_right_thigh * z1073;
    const Scalar z1093 = s_rear_right_thigh * z1069 - c_rear_right_thigh * z1073;
    const Scalar z1094 = z815 + z136 * z1092 + z137 * z1093;
    const Scalar z1095 = s_rear_left_knee * z1084 - c_rear_left_knee * z1090;
    const Scalar z1096 = z1043 + z1079;
    const Scalar z1097 = z900 - k22 * z1089;
    const Scalar z1098 = z1046 + z1085;
    const Scalar z1099 = z834 - k22 * z1095;
    const Scalar z1100 = z1092 - n0_2 * z1094;
    const Scalar z1101 = z1049 + z1094;
    const Scalar z1102 = z718 + z1096;  // acceleration of joint front_right_thigh_link
    const Scalar z1103 = z1079 - z1097;
    const Scalar z1104 = z717 + z1098;  // acceleration of joint rear_left_thigh_link
    const Scalar z1105 = z1085 - z1099;
    const Scalar z1106 = z801 + z1101;  // acceleration of joint rear_right_thigh_link
    const Scalar z1107 = s_rear_right_knee * z1093 - c_rear_right_knee * z1100;
    const Scalar z1108 = z796 - k22 * z1107;
    const Scalar z1109 = z1094 - z1108;
    accelerations.trunk_x = z1025;
    accelerations.trunk_y = z1026;
    accelerations.trunk_z = -z1027;
    accelerations.trunk_attitude_omega_x = -z1031;
    accelerations.trunk_attitude_omega_y = z1032;
    accelerations.trunk_attitude_omega_z = -z1033;
    accelerations.front_left_hip = z1059;
    accelerations.front_left_thigh = z1083;
    accelerations.front_left_knee = -z1091;
    accelerations.front_right_hip = z1061;
    accelerations.front_right_thigh = z1102;
    accelerations.front_right_knee = -z1103;
    accelerations.rear_left_hip = z1071;
    accelerations.rear_left_thigh = z1104;
    accelerations.rear_left_knee = -z1105;
    accelerations.rear_right_hip = z1072;
    accelerations.rear_right_thigh = z1106;
    accelerations.rear_right_knee = -z1109;
    if (!(traits::regular(z134, z134) && traits::regular(z156, z156) && traits::regular(z171, z171)
        && traits::regular(z231, z231) && traits::regular(z319, z319) && traits::regular(z349, z349)
        && traits::regular(z386, z386) && traits::regular(z452, z452) && traits::regular(z511, z511)
        && traits::regular(z539, z539) && traits::regular(z565, z565) && traits::regular(-z609, -z609)
        && traits::regular(-z631, -z631) && traits::regular(-z652, -z652))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (n0 * accelerations.trunk_x * accelerations.trunk_y * accelerations.trunk_z
        * accelerations.trunk_attitude_omega_x * accelerations.trunk_attitude_omega_y
        * accelerations.trunk_attitude_omega_z * accelerations.front_left_hip * accelerations.front_left_thigh
        * accelerations.front_left_knee) * (n0 * accelerations.front_right_hip * accelerations.front_right_thigh
        * accelerations.front_right_knee * accelerations.rear_left_hip * accelerations.rear_left_thigh
        * accelerations.rear_left_knee * accelerations.rear_right_hip * accelerations.rear_right_thigh
        * accelerations.rear_right_knee);
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs& inputs, Accelerations& accelerations) noexcept {
    Multipliers multipliers{};
    return Mechanism::forward_dynamics(precomputed, state, inputs, accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs& inputs,
      Energy& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_0014 = traits::constant(0.0014, 0.0014f, "7/5000");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n0_072 = traits::constant(0.072, 0.072f, "9/125");
    const Scalar k10 = traits::constant(0.00928, 0.00928f, "29/3125");
    const Scalar n0_032 = traits::constant(0.032, 0.032f, "4/125");
    const Scalar n0_26 = traits::constant(0.26, 0.26f, "13/50");
    const Scalar k13 = traits::constant(0.0051096, 0.0051096f, "6387/1250000");
    const Scalar n0_0125 = traits::constant(0.0125, 0.0125f, "1/80");
    const Scalar n0_0425 = traits::constant(0.0425, 0.0425f, "17/400");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar k19 = traits::constant(1.98e-05, 1.98e-05f, "99/5000000");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0_13 = traits::constant(0.13, 0.13f, "13/100");
    const Scalar n58_86 = traits::constant(58.86, 58.86f, "2943/50");
    const Scalar n4_905 = traits::constant(4.905, 4.905f, "981/200");
    const Scalar n7_848 = traits::constant(7.848, 7.848f, "981/125");
    const Scalar n2_5506 = traits::constant(2.5506, 2.5506f, "12753/5000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_trunk_x = state.v.trunk_x;
    const Scalar v_trunk_y = state.v.trunk_y;
    const Scalar q_trunk_z = state.q.trunk_z;
    const Scalar v_trunk_z = state.v.trunk_z;
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar u_front_left_hip_torque = inputs.front_left_hip_torque;
    const Scalar u_front_left_thigh_torque = inputs.front_left_thigh_torque;
    const Scalar u_front_left_knee_torque = inputs.front_left_knee_torque;
    const Scalar u_front_right_hip_torque = inputs.front_right_hip_torque;
    const Scalar u_front_right_thigh_torque = inputs.front_right_thigh_torque;
    const Scalar u_front_right_knee_torque = inputs.front_right_knee_torque;
    const Scalar u_rear_left_hip_torque = inputs.rear_left_hip_torque;
    const Scalar u_rear_left_thigh_torque = inputs.rear_left_thigh_torque;
    const Scalar u_rear_left_knee_torque = inputs.rear_left_knee_torque;
    const Scalar u_rear_right_hip_torque = inputs.rear_right_hip_torque;
    const Scalar u_rear_right_thigh_torque = inputs.rear_right_thigh_torque;
    const Scalar u_rear_right_knee_torque = inputs.rear_right_knee_torque;
    const Scalar z0 = q_front_left_thigh + q_front_left_knee;
    const Scalar z1 = q_front_right_thigh + q_front_right_knee;
    const Scalar z2 = q_rear_left_thigh + q_rear_left_knee;
    const Scalar z3 = q_rear_right_thigh + q_rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee, z0, z1, z2, z3};
    Scalar sines_[16], cosines_[16];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z4 = sines_[12], z5 = cosines_[12];
    const Scalar z6 = sines_[13], z7 = cosines_[13];
    const Scalar z8 = sines_[14], z9 = cosines_[14];
    const Scalar z10 = sines_[15], z11 = cosines_[15];
    const Scalar z12 = n2 * q_trunk_attitude_y;
    const Scalar z13 = n2 * q_trunk_attitude_z;
    const Scalar z14 = n2 * q_trunk_attitude_x;
    const Scalar z15 = n0_05 * v_trunk_attitude_omega_z;
    const Scalar z16 = v_trunk_attitude_omega_x + v_front_left_hip;  // angular velocity of front_left_hip_link, x
    const Scalar z17 = v_trunk_attitude_omega_x + v_front_right_hip;  // angular velocity of front_right_hip_link, x
    const Scalar z18 = q_trunk_attitude_x * z13;
    const Scalar z19 = q_trunk_attitude_w * z12;
    const Scalar z20 = q_trunk_attitude_z * z13;
    const Scalar z21 = q_trunk_attitude_x * z12;
    const Scalar z22 = q_trunk_attitude_w * z13;
    const Scalar z23 = q_trunk_attitude_z * z12;
    const Scalar z24 = q_trunk_attitude_w * z14;
    const Scalar z25 = z18 + z19;
    const Scalar z26 = q_trunk_attitude_y * z12;
    const Scalar z27 = z21 - z22;
    const Scalar z28 = q_trunk_attitude_x * z14;
    const Scalar z29 = z23 - z24;
    const Scalar z30 = n1 - z20 - z28;
    const Scalar z31 = n1 - z26 - z28;
    const Scalar z32 = z23 + z24;
    const Scalar z33 = z21 + z22;
    const Scalar z34 = v_trunk_x * z27 + v_trunk_y * z30 + v_trunk_z * z32;
    const Scalar z35 = v_trunk_x * z25 + v_trunk_y * z29 + v_trunk_z * z31;
    const Scalar z36 = z18 - z19;
    const Scalar z37 = n1 - z26 - z20;
    const Scalar z38 = v_trunk_y * z33 + v_trunk_z * z36 + v_trunk_x * z37;
    const Scalar z39 = n0_2 * v_trunk_attitude_omega_z + z34;
    const Scalar z40 = n0_2 * v_trunk_attitude_omega_z - z34;
    const Scalar z41 = z35 + n0_05 * v_trunk_attitude_omega_x - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z42 = n0_05 * v_trunk_attitude_omega_x - z35 + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z43 = z35 + n0_05 * v_trunk_attitude_omega_x + n0_2 * v_trunk_attitude_omega_y;
    const Scalar z44 = s_front_left_hip * z39 - c_front_left_hip * z41;
    const Scalar z45 = s_front_right_hip * z39 + c_front_right_hip * z42;
    const Scalar z46 = s_rear_left_hip * z40 + c_rear_left_hip * z43;
    const Scalar z47 = v_trunk_attitude_omega_x + v_rear_left_hip;  // angular velocity of rear_left_hip_link, x
    const Scalar z48 = z38 - z15;
    const Scalar z49 = v_trunk_attitude_omega_y * s_front_left_hip - v_trunk_attitude_omega_z * c_front_left_hip;
    const Scalar z50 = z38 + z15;
    const Scalar z51 = v_trunk_attitude_omega_y * s_front_right_hip - v_trunk_attitude_omega_z * c_front_right_hip;
    const Scalar z52 = v_trunk_attitude_omega_y * s_rear_left_hip - v_trunk_attitude_omega_z * c_rear_left_hip;
    const Scalar z53 = s_front_left_hip * z41 + c_front_left_hip * z39;
    const Scalar z54 = s_front_right_hip * z42 - c_front_right_hip * z39;
    const Scalar z55 = v_trunk_attitude_omega_y * c_front_left_hip + v_trunk_attitude_omega_z * s_front_left_hip;
    const Scalar z56 = n0_05 * v_trunk_attitude_omega_x - z35 - n0_2 * v_trunk_attitude_omega_y;
    const Scalar z57 = s_rear_left_hip * z43 - c_rear_left_hip * z40;
    const Scalar z58 = v_trunk_attitude_omega_y * s_rear_right_hip - v_trunk_attitude_omega_z * c_rear_right_hip;
    const Scalar z59 = v_trunk_attitude_omega_y * c_front_right_hip + v_trunk_attitude_omega_z * s_front_right_hip;
    const Scalar z60 = v_trunk_attitude_omega_y * c_rear_left_hip + v_trunk_attitude_omega_z * s_rear_left_hip;
    const Scalar z61 = v_front_left_thigh + z55;  // angular velocity of front_left_thigh_link, y
    const Scalar z62 = v_front_right_thigh + z59;  // angular velocity of front_right_thigh_link, y
    const Scalar z63 = v_rear_left_thigh + z60;  // angular velocity of rear_left_thigh_link, y
    const Scalar z64 = z44 - n0_08 * z16;
    const Scalar z65 = z45 + n0_08 * z17;
    const Scalar z66 = z46 + n0_08 * z47;
    const Scalar z67 = z48 + n0_08 * z49;
    const Scalar z68 = s_rear_right_hip * z40 - c_rear_right_hip * z56;
    const Scalar z69 = s_rear_right_hip * z56 + c_rear_right_hip * z40;
    const Scalar z70 = v_trunk_attitude_omega_x + v_rear_right_hip;  // angular velocity of rear_right_hip_link, x
    const Scalar z71 = z50 - n0_08 * z51;
    const Scalar z72 = z48 + n0_08 * z52;
    const Scalar z73 = v_trunk_attitude_omega_y * c_rear_right_hip + v_trunk_attitude_omega_z * s_rear_right_hip;
    const Scalar z74 = s_front_left_thigh * z64 + c_front_left_thigh * z67;
    const Scalar z75 = s_front_left_thigh * z67 - c_front_left_thigh * z64;
    const Scalar z76 = s_front_right_thigh * z65 + c_front_right_thigh * z71;
    const Scalar z77 = s_front_right_thigh * z71 - c_front_right_thigh * z65;
    const Scalar z78 = s_rear_left_thigh * z66 - c_rear_left_thigh * z72;
    const Scalar z79 = s_rear_left_thigh * z72 + c_rear_left_thigh * z66;
    const Scalar z80 = c_front_left_thigh * z16 + s_front_left_thigh * z49;
    const Scalar z81 = z50 - n0_08 * z58;
    const Scalar z82 = s_front_left_thigh * z16 - c_front_left_thigh * z49;
    const Scalar z83 = s_front_left_knee * z80 + c_front_left_knee * z82;
    const Scalar z84 = s_front_left_knee * z82 - c_front_left_knee * z80;
    const Scalar z85 = z68 - n0_08 * z70;
    const Scalar z86 = s_rear_right_thigh * z85 - c_rear_right_thigh * z81;
    const Scalar z87 = c_front_right_thigh * z17 + s_front_right_thigh * z51;
    const Scalar z88 = s_front_right_thigh * z17 - c_front_right_thigh * z51;
    const Scalar z89 = s_front_right_knee * z87 + c_front_right_knee * z88;
    const Scalar z90 = s_front_right_knee * z88 - c_front_right_knee * z87;
    const Scalar z91 = c_rear_left_thigh * z47 + s_rear_left_thigh * z52;
    const Scalar z92 = s_rear_left_thigh * z47 - c_rear_left_thigh * z52;
    const Scalar z93 = s_rear_left_knee * z91 + c_rear_left_knee * z92;
    const Scalar z94 = s_rear_left_knee * z92 - c_rear_left_knee * z91;
    const Scalar z95 = c_rear_right_thigh * z70 + s_rear_right_thigh * z58;
    const Scalar z96 = s_rear_right_thigh * z70 - c_rear_right_thigh * z58;
    const Scalar z97 = z74 - n0_2 * z61;
    const Scalar z98 = s_rear_right_thigh * z81 + c_rear_right_thigh * z85;
    const Scalar z99 = c_front_left_knee * z75 + s_front_left_knee * z97;
    const Scalar z100 = s_front_left_knee * z75 - c_front_left_knee * z97;
    const Scalar z101 = z76 - n0_2 * z62;
    const Scalar z102 = c_front_right_knee * z77 + s_front_right_knee * z101;
    const Scalar z103 = s_front_right_knee * z77 - c_front_right_knee * z101;
    const Scalar z104 = z78 + n0_2 * z63;
    const Scalar z105 = s_rear_left_knee * z104 - c_rear_left_knee * z79;
    const Scalar z106 = s_rear_left_knee * z79 + c_rear_left_knee * z104;
    const Scalar z107 = z53 + n0_2 * z80;
    const Scalar z108 = v_rear_right_thigh + z73;  // angular velocity of rear_right_thigh_link, y
    const Scalar z109 = s_rear_right_knee * z95 + c_rear_right_knee * z96;
    const Scalar z110 = s_rear_right_knee * z96 - c_rear_right_knee * z95;
    const Scalar z111 = z86 + n0_2 * z108;
    const Scalar z112 = v_front_left_knee + z61;  // angular velocity of front_left_shank_link, y
    const Scalar z113 = s_rear_right_knee * z111 - c_rear_right_knee * z98;
    const Scalar z114 = s_rear_right_knee * z98 + c_rear_right_knee * z111;
    const Scalar z115 = n0_5 * z44 - n0_02 * z16;
    const Scalar z116 = n0_02 * z44 - n0_0014 * z16;
    const Scalar z117 = n0_8 * z74 - n0_072 * z61;
    const Scalar z118 = n0_072 * z74 - k10 * z61;
    const Scalar z119 = n0_8 * z53 + n0_072 * z80;
    const Scalar z120 = n0_072 * z53 + k10 * z80;
    const Scalar z121 = n0_032 * z112 + n0_26 * z100;
    const Scalar z122 = n0_26 * z107 - n0_032 * z84;
    const Scalar z123 = n0_032 * z107 - k13 * z84;
    const Scalar z124 = z54 - n0_2 * z87;
    const Scalar z125 = k13 * z112 + n0_032 * z100;
    const Scalar z126 = n0_02 * z17 + n0_5 * z45;
    const Scalar z127 = n0_0014 * z17 + n0_02 * z45;
    const Scalar z128 = v_front_right_knee + z62;  // angular velocity of front_right_shank_link, y
    const Scalar z129 = n0_8 * z76 - n0_072 * z62;
    const Scalar z130 = n0_072 * z76 - k10 * z62;
    const Scalar z131 = n0_8 * z54 - n0_072 * z87;
    const Scalar z132 = n0_072 * z54 - k10 * z87;
    const Scalar z133 = n0_032 * z128 + n0_26 * z103;
    const Scalar z134 = k13 * z128 + n0_032 * z103;
    const Scalar z135 = n0_26 * z124 + n0_032 * z90;
    const Scalar z136 = n0_032 * z124 + k13 * z90;
    const Scalar z137 = n0_02 * z47 + n0_5 * z46;
    const Scalar z138 = n0_0014 * z47 + n0_02 * z46;
    const Scalar z139 = n0_072 * z63 + n0_8 * z78;
    const Scalar z140 = n0_8 * z57 + n0_072 * z91;
    const Scalar z141 = z57 + n0_2 * z91;
    const Scalar z142 = n0_072 * z57 + k10 * z91;
    const Scalar z143 = k10 * z63 + n0_072 * z78;
    const Scalar z144 = v_rear_left_knee + z63;  // angular velocity of rear_left_shank_link, y
    const Scalar z145 = n0_032 * z144 + n0_26 * z106;
    const Scalar z146 = k13 * z144 + n0_032 * z106;
    const Scalar z147 = n0_2 * z36;
    const Scalar z148 = n0_26 * z141 - n0_032 * z94;
    const Scalar z149 = n0_032 * z141 - k13 * z94;
    const Scalar z150 = z69 - n0_2 * z95;
    const Scalar z151 = n0_08 * c_front_left_hip;
    const Scalar z152 = n0_5 * z68 - n0_02 * z70;
    const Scalar z153 = n0_02 * z68 - n0_0014 * z70;
    const Scalar z154 = v_rear_right_knee + z108;  // angular velocity of rear_right_shank_link, y
    const Scalar z155 = n0_08 * s_front_left_hip;
    const Scalar z156 = n0_072 * z108 + n0_8 * z86;
    const Scalar z157 = k10 * z108 + n0_072 * z86;
    const Scalar z158 = n0_02 * c_front_left_hip;
    const Scalar z159 = n0_5 * z48;
    const Scalar z160 = n0_02 * z48;
    const Scalar z161 = n0_02 * z49 + z159;
    const Scalar z162 = n0_0014 * z49 + z160;
    const Scalar z163 = n0_2 * s_front_left_thigh;
    const Scalar z164 = n0_02 * z52 + z159;
    const Scalar z165 = n0_2 * c_front_left_thigh;
    const Scalar z166 = n0_0014 * z52 + z160;
    const Scalar z167 = n0_072 * c_front_left_thigh;
    const Scalar z168 = n0_2 - z163;
    const Scalar z169 = s_front_left_hip * z167;
    const Scalar z170 = c_front_left_hip * z167;
    const Scalar z171 = n0_8 * z69 - n0_072 * z95;
    const Scalar z172 = n0_072 * z69 - k10 * z95;
    const Scalar z173 = c_front_left_hip * z165 - z155;
    const Scalar z174 = s_front_left_hip * z165 + z151;
    const Scalar z175 = n0_05 + z151;
    const Scalar z176 = n0_05 + z174;
    const Scalar z177 = n0_5 * z50;
    const Scalar z178 = z147 + z31 * z155 + z32 * z175;
    const Scalar z179 = n0_02 * z50;
    const Scalar z180 = n0_02 * s_front_left_hip;
    const Scalar z181 = z36 * z168 - z31 * z173 + z32 * z176;
    const Scalar z182 = n0_072 * s_front_left_thigh;
    const Scalar z183 = n0_05 * z32 + z147;
    const Scalar z184 = z32 * z169 - z31 * z170 - z36 * z182;
    const Scalar z185 = n0_02 * z51 - z177;
    const Scalar z186 = n0_032 * z5;
    const Scalar z187 = s_front_left_hip * z186;
    const Scalar z188 = n0_032 * z4;
    const Scalar z189 = z32 * z158 + z31 * z180;
    const Scalar z190 = n0_0014 * z51 - z179;
    const Scalar z191 = n0_08 * s_front_right_hip;
    const Scalar z192 = n0_2 * c_front_right_thigh;
    const Scalar z193 = n0_08 * c_front_right_hip;
    const Scalar z194 = n0_02 * z58 - z177;
    const Scalar z195 = n0_072 * c_front_right_thigh;
    const Scalar z196 = n0_0014 * z58 - z179;
    const Scalar z197 = n0_2 * s_front_right_thigh;
    const Scalar z198 = c_front_right_hip * z192 + z191;
    const Scalar z199 = q_trunk_z + z178;
    const Scalar z200 = n0_032 * z7;
    const Scalar z201 = q_trunk_z + z181;
    const Scalar z202 = s_front_right_hip * z195;
    const Scalar z203 = n0_2 - z197;
    const Scalar z204 = s_front_right_hip * z192 - z193;
    const Scalar z205 = c_front_left_hip * z186;
    const Scalar z206 = z32 * z187 - z31 * z205 - z36 * z188;
    const Scalar z207 = s_front_right_hip * z200;
    const Scalar z208 = c_front_right_hip * z195;
    const Scalar z209 = c_front_right_hip * z200;
    const Scalar z210 = n0_02 * c_front_right_hip;
    const Scalar z211 = n0_05 + z193;
    const Scalar z212 = n0_05 - z204;
    const Scalar z213 = n0_02 * s_front_right_hip;
    const Scalar z214 = z31 * z198 - z36 * z203 + z32 * z212;
    const Scalar z215 = n0_072 * s_front_right_thigh;
    const Scalar z216 = n0_032 * z6;
    const Scalar z217 = z32 * z202 - z31 * z208 - z36 * z215;
    const Scalar z218 = n0_05 * z32 - z147;
    const Scalar z219 = z31 * z191 - z147 + z32 * z211;
    const Scalar z220 = n0_032 * z154 + n0_26 * z114;
    const Scalar z221 = n0_26 * z150 + n0_032 * z110;
    const Scalar z222 = n0_032 * z150 + k13 * z110;
    const Scalar z223 = n0_02 * c_rear_left_hip;
    const Scalar z224 = k13 * z154 + n0_032 * z114;
    const Scalar z225 = n0_08 * c_rear_left_hip;
    const Scalar z226 = n0_02 * s_rear_left_hip;
    const Scalar z227 = q_trunk_z + z183;
    const Scalar z228 = n0_2 * c_rear_left_thigh;
    const Scalar z229 = s_rear_left_hip * z228 + z225;
    const Scalar z230 = n0_08 * s_rear_left_hip;
    const Scalar z231 = n0_08 * s_rear_right_hip;
    const Scalar z232 = z32 * z207 - z31 * z209 - z36 * z216;
    const Scalar z233 = n0_072 * c_rear_left_thigh;
    const Scalar z234 = n0_05 + z229;
    const Scalar z235 = n0_032 * z9;
    const Scalar z236 = n0_08 * c_rear_right_hip;
    const Scalar z237 = z32 * z210 + z31 * z213;
    const Scalar z238 = s_rear_left_hip * z233;
    const Scalar z239 = c_rear_left_hip * z228 - z230;
    const Scalar z240 = s_rear_left_hip * z235;
    const Scalar z241 = z32 * z223 + z31 * z226;
    const Scalar z242 = n0_2 * s_rear_left_thigh;
    const Scalar z243 = c_rear_left_hip * z233;
    const Scalar z244 = c_rear_left_hip * z235;
    const Scalar z245 = n0_05 + z225;
    const Scalar z246 = n0_2 + z242;
    const Scalar z247 = n0_02 * c_rear_right_hip;
    const Scalar z248 = z31 * z230 - z147 + z32 * z245;
    const Scalar z249 = n0_072 * s_rear_left_thigh;
    const Scalar z250 = z32 * z238 - z31 * z243 - z36 * z249;
    const Scalar z251 = n0_032 * z8;
    const Scalar z252 = n0_02 * s_rear_right_hip;
    const Scalar z253 = z32 * z234 - z31 * z239 - z36 * z246;
    const Scalar z254 = q_trunk_z - z218;
    const Scalar z255 = n0_072 * c_rear_right_thigh;
    const Scalar z256 = s_rear_right_hip * z255;
    const Scalar z257 = c_rear_right_hip * z255;
    const Scalar z258 = n0_05 + z236;
    const Scalar z259 = z32 * z240 - z31 * z244 - z36 * z251;
    const Scalar z260 = n0_072 * s_rear_right_thigh;
    const Scalar z261 = z147 + z31 * z231 + z32 * z258;
    const Scalar z262 = q_trunk_z - z219;
    const Scalar z263 = n0_2 * s_rear_right_thigh;
    const Scalar z264 = n0_2 * c_rear_right_thigh;
    const Scalar z265 = n0_2 + z263;
    const Scalar z266 = n0_032 * z11;
    const Scalar z267 = c_rear_right_hip * z264 + z231;
    const Scalar z268 = s_rear_right_hip * z266;
    const Scalar z269 = z32 * z256 - z31 * z257 - z36 * z260;
    const Scalar z270 = s_rear_right_hip * z264 - z236;
    const Scalar z271 = c_rear_right_hip * z266;
    const Scalar z272 = n0_05 - z270;
    const Scalar z273 = n0_032 * z10;
    const Scalar z274 = q_trunk_z - z214;
    const Scalar z275 = q_trunk_z + z218;
    const Scalar z276 = q_trunk_z + z248;
    const Scalar z277 = z36 * z265 + z31 * z267 + z32 * z272;
    const Scalar z278 = q_trunk_z + z253;
    const Scalar z279 = q_trunk_z - z183;
    const Scalar z280 = z32 * z247 + z31 * z252;
    const Scalar z281 = q_trunk_z - z261;
    const Scalar z282 = q_trunk_z - z277;
    const Scalar z283 = z32 * z268 - z31 * z271 - z36 * z273;
    const Scalar z284 = n0_05 * v_front_left_hip;
    const Scalar z285 = n0_05 * v_front_left_thigh;
    const Scalar z286 = n0_05 * v_front_left_knee;
    const Scalar z287 = n0_05 * v_front_right_hip;
    const Scalar z288 = n0_05 * v_front_right_thigh;
    const Scalar z289 = n0_05 * v_front_right_knee;
    const Scalar z290 = n0_05 * v_rear_left_hip;
    const Scalar z291 = n0_05 * v_rear_left_thigh;
    const Scalar z292 = n0_05 * v_rear_left_knee;
    const Scalar z293 = n0_05 * v_rear_right_hip;
    const Scalar z294 = n0_05 * v_rear_right_thigh;
    const Scalar z295 = n0_05 * v_rear_right_knee;
    result.kinetic = n0_0125 * v_trunk_attitude_omega_x * v_trunk_attitude_omega_x + n0_0425 * v_trunk_attitude_omega_y
        * v_trunk_attitude_omega_y + v_trunk_attitude_omega_z * z15 + n3 * (z38 * z38 + z34 * z34 + z35 * z35) + n0_25
        * (z53 * z53 + z54 * z54 + z57 * z57 + z69 * z69) + n0_4 * (z75 * z75 + z77 * z77 + z79 * z79 + z98 * z98) + k19
        * (z83 * z83 + z89 * z89 + z93 * z93 + z109 * z109) + n0_0002 * (z55 * z55 + z59 * z59 + z60 * z60 + z73 * z73
        + z82 * z82 + z88 * z88 + z92 * z92 + z96 * z96) + n0_13 * (z99 * z99 + z102 * z102 + z105 * z105 + z113 * z113)
        + n0_5 * (z49 * z162 + z51 * z190 + z45 * z126 + z17 * z127 + z52 * z166 + z46 * z137 + z47 * z138 + z58 * z196
        + z48 * (z161 + z164) - z50 * (z185 + z194) + z44 * z115 - z16 * z116 + z68 * z152 - z70 * z153 + z53 * z119
        + z80 * z120 + z54 * z131 - z87 * z132 + z57 * z140 + z91 * z142 + z69 * z171 - z95 * z172 + z107 * z122 - z84
        * z123 + z124 * z135 + z90 * z136 + z78 * z139 + z63 * z143 + z141 * z148 - z94 * z149 + z86 * z156 + z108
        * z157 + z150 * z221 + z110 * z222 + z74 * z117 - z61 * z118 + z76 * z129 - z62 * z130 + z100 * z121 + z112
        * z125 + z103 * z133 + z128 * z134 + z106 * z145 + z144 * z146 + z114 * z220 + z154 * z224);
    result.force_function = -n58_86 * q_trunk_z - n4_905 * (z227 + z254 + z275 + z279) - n7_848 * (z199 + z262 + z276
        + z281) - n2_5506 * (z201 + z282 + z274 + z278) - n9_81 * (z189 - z237 + z241 - z280 + z184 + z217 + z250 + z269
        + z206 + z232 + z259 + z283);
    result.power = v_front_left_hip * (u_front_left_hip_torque - z284) + v_front_left_thigh * (u_front_left_thigh_torque
        - z285) + v_front_left_knee * (u_front_left_knee_torque - z286) + v_front_right_hip * (u_front_right_hip_torque
        - z287) + v_front_right_thigh * (u_front_right_thigh_torque - z288) + v_front_right_knee
        * (u_front_right_knee_torque - z289) + v_rear_left_hip * (u_rear_left_hip_torque - z290) + v_rear_left_thigh
        * (u_rear_left_thigh_torque - z291) + v_rear_left_knee * (u_rear_left_knee_torque - z292) + v_rear_right_hip
        * (u_rear_right_hip_torque - z293) + v_rear_right_thigh * (u_rear_right_thigh_torque - z294) + v_rear_right_knee
        * (u_rear_right_knee_torque - z295);
  }

  /// Contacts that open and close, in the order front_left_foot_ground, front_right_foot_ground, rear_left_foot_ground, rear_right_foot_ground.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_trunk_x = state.v.trunk_x;
    const Scalar v_trunk_y = state.v.trunk_y;
    const Scalar q_trunk_z = state.q.trunk_z;
    const Scalar v_trunk_z = state.v.trunk_z;
    const Scalar q_trunk_attitude_y = state.q.trunk_attitude_y;
    const Scalar q_trunk_attitude_z = state.q.trunk_attitude_z;
    const Scalar q_trunk_attitude_x = state.q.trunk_attitude_x;
    const Scalar q_trunk_attitude_w = state.q.trunk_attitude_w;
    const Scalar v_trunk_attitude_omega_x = state.v.trunk_attitude_omega_x;
    const Scalar v_trunk_attitude_omega_y = state.v.trunk_attitude_omega_y;
    const Scalar v_trunk_attitude_omega_z = state.v.trunk_attitude_omega_z;
    const Scalar q_front_left_hip = state.q.front_left_hip;
    const Scalar v_front_left_hip = state.v.front_left_hip;
    const Scalar q_front_left_thigh = state.q.front_left_thigh;
    const Scalar v_front_left_thigh = state.v.front_left_thigh;
    const Scalar q_front_left_knee = state.q.front_left_knee;
    const Scalar v_front_left_knee = state.v.front_left_knee;
    const Scalar q_front_right_hip = state.q.front_right_hip;
    const Scalar v_front_right_hip = state.v.front_right_hip;
    const Scalar q_front_right_thigh = state.q.front_right_thigh;
    const Scalar v_front_right_thigh = state.v.front_right_thigh;
    const Scalar q_front_right_knee = state.q.front_right_knee;
    const Scalar v_front_right_knee = state.v.front_right_knee;
    const Scalar q_rear_left_hip = state.q.rear_left_hip;
    const Scalar v_rear_left_hip = state.v.rear_left_hip;
    const Scalar q_rear_left_thigh = state.q.rear_left_thigh;
    const Scalar v_rear_left_thigh = state.v.rear_left_thigh;
    const Scalar q_rear_left_knee = state.q.rear_left_knee;
    const Scalar v_rear_left_knee = state.v.rear_left_knee;
    const Scalar q_rear_right_hip = state.q.rear_right_hip;
    const Scalar v_rear_right_hip = state.v.rear_right_hip;
    const Scalar q_rear_right_thigh = state.q.rear_right_thigh;
    const Scalar v_rear_right_thigh = state.v.rear_right_thigh;
    const Scalar q_rear_right_knee = state.q.rear_right_knee;
    const Scalar v_rear_right_knee = state.v.rear_right_knee;
    const Scalar angles_[] = {q_front_left_hip, q_front_left_thigh, q_front_left_knee, q_front_right_hip,
        q_front_right_thigh, q_front_right_knee, q_rear_left_hip, q_rear_left_thigh, q_rear_left_knee, q_rear_right_hip,
        q_rear_right_thigh, q_rear_right_knee};
    Scalar sines_[12], cosines_[12];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_front_left_hip = sines_[0], c_front_left_hip = cosines_[0];
    const Scalar s_front_left_thigh = sines_[1], c_front_left_thigh = cosines_[1];
    const Scalar s_front_left_knee = sines_[2], c_front_left_knee = cosines_[2];
    const Scalar s_front_right_hip = sines_[3], c_front_right_hip = cosines_[3];
    const Scalar s_front_right_thigh = sines_[4], c_front_right_thigh = cosines_[4];
    const Scalar s_front_right_knee = sines_[5], c_front_right_knee = cosines_[5];
    const Scalar s_rear_left_hip = sines_[6], c_rear_left_hip = cosines_[6];
    const Scalar s_rear_left_thigh = sines_[7], c_rear_left_thigh = cosines_[7];
    const Scalar s_rear_left_knee = sines_[8], c_rear_left_knee = cosines_[8];
    const Scalar s_rear_right_hip = sines_[9], c_rear_right_hip = cosines_[9];
    const Scalar s_rear_right_thigh = sines_[10], c_rear_right_thigh = cosines_[10];
    const Scalar s_rear_right_knee = sines_[11], c_rear_right_knee = cosines_[11];
    const Scalar z0 = n0_2 * s_front_left_knee;
    const Scalar z1 = n0_2 * c_front_left_knee;
    const Scalar z2 = n2 * q_trunk_attitude_y;
    const Scalar z3 = n0_08 * c_front_left_hip;
    const Scalar z4 = n2 * q_trunk_attitude_z;
    const Scalar z5 = n2 * q_trunk_attitude_x;
    const Scalar z6 = q_trunk_attitude_y * z2;
    const Scalar z7 = q_trunk_attitude_z * z4;
    const Scalar z8 = q_trunk_attitude_x * z4;
    const Scalar z9 = q_trunk_attitude_w * z2;
    const Scalar z10 = n0_08 * s_front_left_hip;
    const Scalar z11 = q_trunk_attitude_z * z2;
    const Scalar z12 = n1 - z6 - z7;
    const Scalar z13 = q_trunk_attitude_w * z5;
    const Scalar z14 = q_trunk_attitude_x * z2;
    const Scalar z15 = q_trunk_attitude_w * z4;
    const Scalar z16 = n0_5 * (q_trunk_attitude_z * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_z + q_trunk_attitude_w * v_trunk_attitude_omega_y);
    const Scalar z17 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_x - q_trunk_attitude_x
        * v_trunk_attitude_omega_y - q_trunk_attitude_w * v_trunk_attitude_omega_z);
    const Scalar z18 = q_trunk_attitude_x * z5;
    const Scalar z19 = z8 - z9;
    const Scalar z20 = z11 + z13;
    const Scalar z21 = z14 + z15;
    const Scalar z22 = n1 - z6 - z18;
    const Scalar z23 = z11 - z13;
    const Scalar z24 = z8 + z9;
    const Scalar z25 = z14 - z15;
    const Scalar z26 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_z - q_trunk_attitude_z
        * v_trunk_attitude_omega_y + q_trunk_attitude_w * v_trunk_attitude_omega_x);
    const Scalar z27 = n0_5 * (q_trunk_attitude_y * v_trunk_attitude_omega_y + q_trunk_attitude_z
        * v_trunk_attitude_omega_z + q_trunk_attitude_x * v_trunk_attitude_omega_x);
    const Scalar z28 = n2 * (q_trunk_attitude_y * z17 - q_trunk_attitude_z * z16);
    const Scalar z29 = n2 * (q_trunk_attitude_x * z27 - q_trunk_attitude_w * z26);
    const Scalar z30 = n1 - z7 - z18;
    const Scalar z31 = v_front_left_thigh * c_front_left_thigh;
    const Scalar z32 = v_front_left_knee * c_front_left_knee;
    const Scalar z33 = v_front_left_thigh * s_front_left_thigh;
    const Scalar z34 = v_front_left_knee * s_front_left_knee;
    const Scalar z35 = v_front_left_hip * s_front_left_hip;
    const Scalar z36 = v_front_left_hip * c_front_left_hip;
    const Scalar z37 = q_trunk_attitude_y * q_trunk_attitude_y;
    const Scalar z38 = q_trunk_attitude_z * q_trunk_attitude_z;
    const Scalar z39 = q_trunk_attitude_x * q_trunk_attitude_x;
    const Scalar z40 = z38 - z39;
    const Scalar z41 = z37 - z38;
    const Scalar z42 = q_trunk_attitude_w * q_trunk_attitude_w - z37;
    const Scalar z43 = q_trunk_attitude_w * q_trunk_attitude_w - z39;
    const Scalar z44 = z40 + z42;
    const Scalar z45 = z28 + z29;
    const Scalar z46 = z41 - z43;
    const Scalar z47 = q_trunk_attitude_y * q_trunk_attitude_w - q_trunk_attitude_z * q_trunk_attitude_x;
    const Scalar z48 = n2 * z47;
    const Scalar z49 = q_trunk_attitude_y * q_trunk_attitude_z + q_trunk_attitude_x * q_trunk_attitude_w;
    const Scalar z50 = n2 * z49;
    const Scalar z51 = n0_2 + z1;
    const Scalar z52 = n4 * q_trunk_attitude_y * z16;
    const Scalar z53 = c_front_left_thigh * z0;
    const Scalar z54 = n4 * q_trunk_attitude_x * z26;
    const Scalar z55 = s_front_left_thigh * z0;
    const Scalar z56 = n0_2 * z32;
    const Scalar z57 = n0_2 * z34;
    const Scalar z58 = n0_08 * z35;
    const Scalar z59 = s_front_left_thigh * z51 + z53;
    const Scalar z60 = z52 + z54;
    const Scalar z61 = n0_08 * z36;
    const Scalar z62 = c_front_left_thigh * z51 - z55;
    const Scalar z63 = s_front_left_thigh * z1 + z53;
    const Scalar z64 = c_front_left_thigh * z1 - z55;
    const Scalar z65 = n2 * (q_trunk_attitude_z * z26 - q_trunk_attitude_x * z17);
    const Scalar z66 = s_front_left_hip * z62 + z3;
    const Scalar z67 = n2 * (q_trunk_attitude_y * z27 - q_trunk_attitude_w * z16);
    const Scalar z68 = n0_2 - z59;
    const Scalar z69 = z65 + z67;
    const Scalar z70 = n0_05 + z66;
    const Scalar z71 = c_front_left_hip * z62 - z10;
    const Scalar z72 = z68 * z44 + z19 * z71;
    const Scalar z73 = z68 * z50 + z70 * z48;
    const Scalar z74 = z0 * z31 + s_front_left_thigh * z56 + c_front_left_thigh * z57 + z51 * z33;
    const Scalar z75 = z0 * z33 + s_front_left_thigh * z57 - c_front_left_thigh * z56 - z51 * z31;
    const Scalar z76 = z58 - z62 * z36 + s_front_left_hip * z74;
    const Scalar z77 = z12 * z68 - z24 * z71 + z25 * z70;
    const Scalar z78 = v_front_left_knee * z34;
    const Scalar z79 = z21 * z68 - z23 * z71 + z30 * z70;
    const Scalar z80 = n0_2 * z78;
    const Scalar z81 = z19 * z68 - z22 * z71 + z20 * z70;
    const Scalar z82 = v_front_left_knee * z32;
    const Scalar z83 = z61 + z62 * z35 + c_front_left_hip * z74;
    const Scalar z84 = z70 * z45 - z68 * z69 - z71 * z60 - z19 * z75 + z20 * z76 - z22 * z83;
    const Scalar z85 = v_trunk_z - z84;
    const Scalar z86 = s_front_left_hip * z59;
    const Scalar z87 = c_front_left_hip * z59;
    const Scalar z88 = z19 * z62 + z20 * z86 - z22 * z87;
    const Scalar z89 = s_front_left_hip * z63;
    const Scalar z90 = c_front_left_hip * z63;
    const Scalar z91 = z19 * z64 + z20 * z89 - z22 * z90;
    const Scalar z92 = z20 * z71;
    const Scalar z93 = z22 * z66 + z92;
    const Scalar z94 = z70 * z46 - z92;
    const Scalar z95 = q_trunk_z + z81;
    const Scalar z96 = n0_02 - z95;
    const Scalar z97 = n0_2 * z82;
    const Scalar z98 = n2 * z74;
    const Scalar z99 = v_front_left_thigh * z31;
    const Scalar z100 = n0_2 * s_front_left_thigh;
    const Scalar z101 = v_front_left_thigh * z33;
    const Scalar z102 = n0_2 * z21;
    const Scalar z103 = n0_2 * z19;
    const Scalar z104 = n0_2 * c_front_left_thigh;
    const Scalar z105 = n0_5 * (v_trunk_attitude_omega_x * z27 - v_trunk_attitude_omega_y * z17
        - v_trunk_attitude_omega_z * z16);
    const Scalar z106 = n0_5 * (v_trunk_attitude_omega_x * z16 - v_trunk_attitude_omega_y * z26
        + v_trunk_attitude_omega_z * z27);
    const Scalar z107 = n0_5 * (v_trunk_attitude_omega_x * z26 + v_trunk_attitude_omega_y * z16
        - v_trunk_attitude_omega_z * z17);
    const Scalar z108 = n0_5 * (v_trunk_attitude_omega_x * z17 + v_trunk_attitude_omega_y * z27
        + v_trunk_attitude_omega_z * z26);
    const Scalar z109 = n0_05 * z25;
    const Scalar z110 = n0_05 * z30 + z102;
    const Scalar z111 = n0_05 * z20 + z103;
    const Scalar z112 = n0_2 * z12;
    const Scalar z113 = c_front_left_hip * z104 - z10;
    const Scalar z114 = n4 * z26;
    const Scalar z115 = n4 * z16;
    const Scalar z116 = s_front_left_hip * z104 + z3;
    const Scalar z117 = n0_05 + z3;
    const Scalar z118 = n0_02 - z81;
    const Scalar z119 = z79 - z110;
    const Scalar z120 = z81 - z111;
    const Scalar z121 = n0_02 - z120;
    const Scalar z122 = n0_2 * z12 + z109;
    const Scalar z123 = z17 * z114 + n2 * (q_trunk_attitude_z * z105 + q_trunk_attitude_x * z106);
    const Scalar z124 = z17 * z115 + n2 * (q_trunk_attitude_y * z106 + q_trunk_attitude_z * z108);
    const Scalar z125 = z27 * z115 + n2 * (q_trunk_attitude_y * z107 + q_trunk_attitude_w * z108);
    const Scalar z126 = z27 * z114 + n2 * (q_trunk_attitude_x * z107 + q_trunk_attitude_w * z105);
    const Scalar z127 = z123 - z125;
    const Scalar z128 = z124 + z126;
    const Scalar z129 = n4 * (q_trunk_attitude_y * z108 - z16 * z16);
    const Scalar z130 = n4 * (q_trunk_attitude_x * z105 - z26 * z26);
    const Scalar z131 = z129 + z130;
    const Scalar z132 = z103 + z22 * z10 + z20 * z117;
    const Scalar z133 = z81 - z132;
    const Scalar z134 = z0 * z99 + z51 * z101 + s_front_left_thigh * z97 + c_front_left_thigh * z80 + n2 * (z31 * z57
        + z56 * z33);
    const Scalar z135 = z0 * z101 - z51 * z99 + s_front_left_thigh * z80 - c_front_left_thigh * z97 - n2 * (z31 * z56
        - z33 * z57);
    const Scalar z136 = n0_2 - z100;
    const Scalar z137 = n0_02 - z133;
    const Scalar z138 = z77 - z122;
    const Scalar z139 = z19 * z79 + z21 * z118;
    const Scalar z140 = z19 * z77 + z12 * z118;
    const Scalar z141 = v_front_left_hip * z35;
    const Scalar z142 = n0_05 + z116;
    const Scalar z143 = s_front_left_hip * z22 + c_front_left_hip * z20;
    const Scalar z144 = z112 + z24 * z10 + z25 * z117;
    const Scalar z145 = z77 - z144;
    const Scalar z146 = z102 + z23 * z10 + z30 * z117;
    const Scalar z147 = z79 - z146;
    const Scalar z148 = v_front_left_hip * z36;
    const Scalar z149 = z20 * z79 + z30 * z118;
    const Scalar z150 = z20 * z77 + z25 * z118;
    const Scalar z151 = z12 * z136 - z24 * z113 + z25 * z142;
    const Scalar z152 = z21 * z136 - z23 * z113 + z30 * z142;
    const Scalar z153 = z22 * z79 + z23 * z118;
    const Scalar z154 = z22 * z77 + z24 * z118;
    const Scalar z155 = s_front_left_hip * z24 + c_front_left_hip * z25;
    const Scalar z156 = z19 * z119 + z21 * z121;
    const Scalar z157 = z19 * z138 + z12 * z121;
    const Scalar z158 = s_front_left_hip * z23 + c_front_left_hip * z30;
    const Scalar z159 = n0_08 * z141 - z62 * z148 + z35 * z98 + c_front_left_hip * z135;
    const Scalar z160 = s_front_left_hip * z135 - z62 * z141 - z36 * z98 - n0_08 * z148;
    const Scalar z161 = z19 * z134 - z68 * z127 - z71 * z131 - z70 * z128 + n2 * (z69 * z75 + z45 * z76 - z60 * z83)
        - z22 * z159 + z20 * z160;
    const Scalar z162 = n2 * (q_trunk_attitude_y * z26 + q_trunk_attitude_x * z16);
    const Scalar z163 = z28 - z29;
    const Scalar z164 = z65 - z67;
    const Scalar z165 = n2 * (q_trunk_attitude_z * z27 + q_trunk_attitude_w * z17);
    const Scalar z166 = n4 * q_trunk_attitude_z * z17;
    const Scalar z167 = z54 - z166;
    const Scalar z168 = z52 - z166;
    const Scalar z169 = n0_2 * z31;
    const Scalar z170 = n0_2 * z33;
    const Scalar z171 = z77 - z151;
    const Scalar z172 = z79 - z152;
    const Scalar z173 = z162 - z165;
    const Scalar z174 = z162 + z165;
    const Scalar z175 = n0_2 * z173;
    const Scalar z176 = n0_2 * z69;
    const Scalar z177 = n0_05 * z167;
    const Scalar z178 = z68 * z173 + z71 * z163 - z70 * z167 + z21 * z75 - z30 * z76 + z23 * z83;
    const Scalar z179 = z70 * z174 - z68 * z168 - z71 * z164 + z12 * z75 - z25 * z76 + z24 * z83;
    const Scalar z180 = z175 - z177;
    const Scalar z181 = z58 + s_front_left_hip * z170 - z36 * z104;
    const Scalar z182 = z61 + z35 * z104 + c_front_left_hip * z170;
    const Scalar z183 = n0_05 * z45 - z176;
    const Scalar z184 = z10 * z163 - z175 + z30 * z58 - z23 * z61 + z117 * z167;
    const Scalar z185 = z19 * z136 - z22 * z113 + z20 * z142;
    const Scalar z186 = z81 - z185;
    const Scalar z187 = z178 + z184;
    const Scalar z188 = z178 - z180;
    const Scalar z189 = z84 - z183;
    const Scalar z190 = z69 * z119 + z121 * z173 + z19 * z188 + z21 * z189;
    const Scalar z191 = n0_02 - z186;
    const Scalar z192 = z79 * z69 + z118 * z173 + z19 * z178 + z21 * z84;
    const Scalar z193 = z77 * z69 - z118 * z168 + z12 * z84 + z19 * z179;
    const Scalar z194 = z21 * z169 - z136 * z173 - z113 * z163 + z142 * z167 + z30 * z181 - z23 * z182;
    const Scalar z195 = z178 + z194;
    const Scalar z196 = s_front_left_hip * z60 + c_front_left_hip * z45 + z20 * z35 - z22 * z36;
    const Scalar z197 = z118 * z174 - z77 * z45 + z25 * z84 + z20 * z179;
    const Scalar z198 = z10 * z60 - z176 + z20 * z58 - z22 * z61 + z45 * z117;
    const Scalar z199 = z84 - z198;
    const Scalar z200 = z20 * z178 - z79 * z45 - z118 * z167 + z30 * z84;
    const Scalar z201 = z22 * z178 - z79 * z60 - z118 * z163 + z23 * z84;
    const Scalar z202 = s_front_left_hip * z163 + c_front_left_hip * z167 + z30 * z35 - z23 * z36;
    const Scalar z203 = z143 * z187 - z147 * z196 - z137 * z202 + z158 * z199;
    const Scalar z204 = z143 * z147 + z158 * z137;
    const Scalar z205 = z118 * z164 - z77 * z60 + z22 * z179 + z24 * z84;
    const Scalar z206 = z19 * z169 - z69 * z136 - z60 * z113 + z45 * z142 + z20 * z181 - z22 * z182;
    const Scalar z207 = z84 - z206;
    const Scalar z208 = z143 * z145 + z155 * z137;
    const Scalar z209 = z12 * z169 + z136 * z168 + z113 * z164 - z142 * z174 + z25 * z181 - z24 * z182;
    const Scalar z210 = s_front_left_hip * z164 + c_front_left_hip * z174 - z25 * z35 + z24 * z36;
    const Scalar z211 = z143 * z195 - z172 * z196 - z191 * z202 + z158 * z207;
    const Scalar z212 = v_trunk_attitude_omega_x * z192 + v_front_left_hip * z190 + v_trunk_attitude_omega_y * z200
        + v_trunk_attitude_omega_z * z201 + v_front_left_thigh * z203 + v_front_left_knee * z211;
    const Scalar z213 = z143 * z172 + z158 * z191;
    const Scalar z214 = v_trunk_x - v_trunk_attitude_omega_x * z139 - v_trunk_attitude_omega_y * z149
        - v_trunk_attitude_omega_z * z153 - v_front_left_hip * z156 - v_front_left_thigh * z204 - v_front_left_knee
        * z213;
    const Scalar z215 = z179 + z209;
    const Scalar z216 = z191 * z210 - z171 * z196 + z155 * z207 + z143 * z215;
    const Scalar z217 = z143 * z171 + z155 * z191;
    const Scalar z218 = v_trunk_y + v_trunk_attitude_omega_x * z140 + v_trunk_attitude_omega_y * z150
        + v_trunk_attitude_omega_z * z154 + v_front_left_hip * z157 + v_front_left_thigh * z208 + v_front_left_knee
        * z217;
    const Scalar z219 = n0_2 * s_front_right_knee;
    const Scalar z220 = v_front_right_thigh * c_front_right_thigh;
    const Scalar z221 = v_front_right_knee * c_front_right_knee;
    const Scalar z222 = n0_2 * z221;
    const Scalar z223 = v_front_right_thigh * s_front_right_thigh;
    const Scalar z224 = v_front_right_knee * s_front_right_knee;
    const Scalar z225 = n0_2 * c_front_right_knee;
    const Scalar z226 = n0_2 * z224;
    const Scalar z227 = v_front_right_knee * z224;
    const Scalar z228 = n0_2 + z225;
    const Scalar z229 = c_front_right_thigh * z219;
    const Scalar z230 = s_front_right_thigh * z219;
    const Scalar z231 = v_front_right_hip * s_front_right_hip;
    const Scalar z232 = s_front_right_thigh * z228 + z229;
    const Scalar z233 = s_front_right_thigh * z225 + z229;
    const Scalar z234 = c_front_right_thigh * z225 - z230;
    const Scalar z235 = c_front_right_thigh * z228 - z230;
    const Scalar z236 = n0_08 * s_front_right_hip;
    const Scalar z237 = n0_08 * c_front_right_hip;
    const Scalar z238 = n0_2 - z232;
    const Scalar z239 = v_front_right_hip * c_front_right_hip;
    const Scalar z240 = z219 * z220 + s_front_right_thigh * z222 + c_front_right_thigh * z226 + z228 * z223;
    const Scalar z241 = n0_08 * z231;
    const Scalar z242 = c_front_right_hip * z235 + z236;
    const Scalar z243 = z44 * z238 + z19 * z242;
    const Scalar z244 = n0_08 * z239;
    const Scalar z245 = s_front_right_hip * z235 - z237;
    const Scalar z246 = z219 * z223 + s_front_right_thigh * z226 - c_front_right_thigh * z222 - z228 * z220;
    const Scalar z247 = n0_05 - z245;
    const Scalar z248 = z48 * z247 - z50 * z238;
    const Scalar z249 = s_front_right_hip * z240 - z241 - z235 * z239;
    const Scalar z250 = z235 * z231 - z244 + c_front_right_hip * z240;
    const Scalar z251 = z12 * z238 - z24 * z242 - z25 * z247;
    const Scalar z252 = z21 * z238 - z23 * z242 - z30 * z247;
    const Scalar z253 = z22 * z242 - z19 * z238 + z20 * z247;
    const Scalar z254 = n0_2 * z168;
    const Scalar z255 = z254 - z10 * z164 + z25 * z58 - z24 * z61 - z117 * z174;
    const Scalar z256 = n0_2 * z227;
    const Scalar z257 = z20 * z249 - z22 * z250 - z19 * z246 - z45 * z247 - z60 * z242 - z69 * z238;
    const Scalar z258 = n0_05 * z174 - z254;
    const Scalar z259 = v_front_right_knee * z221;
    const Scalar z260 = z179 - z258;
    const Scalar z261 = n0_2 * z259;
    const Scalar z262 = s_front_right_hip * z232;
    const Scalar z263 = c_front_right_hip * z232;
    const Scalar z264 = z19 * z235 + z20 * z262 - z22 * z263;
    const Scalar z265 = z69 * z138 - z121 * z168 + z12 * z189 + z19 * z260;
    const Scalar z266 = z179 + z255;
    const Scalar z267 = z137 * z210 - z145 * z196 + z155 * z199 + z143 * z266;
    const Scalar z268 = n2 * z240;
    const Scalar z269 = v_trunk_attitude_omega_x * z193 + v_trunk_attitude_omega_y * z197 + v_trunk_attitude_omega_z
        * z205 + v_front_left_hip * z265 + v_front_left_thigh * z267 + v_front_left_knee * z216;
    const Scalar z270 = z109 - z112;
    const Scalar z271 = v_trunk_z - z257;
    const Scalar z272 = v_front_right_thigh * z220;
    const Scalar z273 = n0_02 + z253;
    const Scalar z274 = n0_05 * z20 - z103;
    const Scalar z275 = v_front_right_thigh * z223;
    const Scalar z276 = n0_05 * z30 - z102;
    const Scalar z277 = z251 + z270;
    const Scalar z278 = z252 + z276;
    const Scalar z279 = z253 - z274;
    const Scalar z280 = n0_02 + z279;
    const Scalar z281 = z19 * z252 + z21 * z273;
    const Scalar z282 = z19 * z251 + z12 * z273;
    const Scalar z283 = v_front_right_hip * z239;
    const Scalar z284 = v_front_right_hip * z231;
    const Scalar z285 = z20 * z252 + z30 * z273;
    const Scalar z286 = z20 * z251 + z25 * z273;
    const Scalar z287 = z219 * z272 + z228 * z275 + s_front_right_thigh * z261 + c_front_right_thigh * z256 + n2 * (z220
        * z226 + z222 * z223);
    const Scalar z288 = z219 * z275 - z228 * z272 + s_front_right_thigh * z256 - c_front_right_thigh * z261 - n2 * (z220
        * z222 - z223 * z226);
    const Scalar z289 = z22 * z252 + z23 * z273;
    const Scalar z290 = z22 * z251 + z24 * z273;
    const Scalar z291 = z19 * z278 + z21 * z280;
    const Scalar z292 = s_front_right_hip * z233;
    const Scalar z293 = c_front_right_hip * z233;
    const Scalar z294 = z19 * z234 + z20 * z292 - z22 * z293;
    const Scalar z295 = n0_08 * z283 - z235 * z284 - z239 * z268 + s_front_right_hip * z288;
    const Scalar z296 = z231 * z268 - n0_08 * z284 - z235 * z283 + c_front_right_hip * z288;
    const Scalar z297 = z128 * z247 - z127 * z238 - z131 * z242 + z19 * z287 + n2 * (z69 * z246 - z60 * z250 + z45
        * z249) + z20 * z295 - z22 * z296;
    const Scalar z298 = z20 * z242;
    const Scalar z299 = z22 * z245 + z298;
    const Scalar z300 = z46 * z247 + z298;
    const Scalar z301 = q_trunk_z - z253;
    const Scalar z302 = n0_02 - z301;
    const Scalar z303 = n0_2 * z220;
    const Scalar z304 = n0_2 * z223;
    const Scalar z305 = n0_2 * z173 + z177;
    const Scalar z306 = n0_2 * s_front_right_thigh;
    const Scalar z307 = n0_2 - z306;
    const Scalar z308 = n0_2 * c_front_right_thigh;
    const Scalar z309 = c_front_right_hip * z308 + z236;
    const Scalar z310 = s_front_right_hip * z308 - z237;
    const Scalar z311 = n0_05 + z237;
    const Scalar z312 = z173 * z238 + z163 * z242 + z167 * z247 + z21 * z246 + z23 * z250 - z30 * z249;
    const Scalar z313 = z12 * z246 - z168 * z238 - z164 * z242 - z174 * z247 + z24 * z250 - z25 * z249;
    const Scalar z314 = n0_05 - z310;
    const Scalar z315 = s_front_right_hip * z304 - z241 - z239 * z308;
    const Scalar z316 = z231 * z308 - z244 + c_front_right_hip * z304;
    const Scalar z317 = z22 * z236 - z103 + z20 * z311;
    const Scalar z318 = z253 - z317;
    const Scalar z319 = n0_05 * z45 + z176;
    const Scalar z320 = z175 + z163 * z236 + z30 * z241 - z23 * z244 + z167 * z311;
    const Scalar z321 = n0_02 + z318;
    const Scalar z322 = z312 - z320;
    const Scalar z323 = z22 * z309 - z19 * z307 + z20 * z314;
    const Scalar z324 = z253 - z323;
    const Scalar z325 = s_front_right_hip * z22 + c_front_right_hip * z20;
    const Scalar z326 = z24 * z236 - z112 + z25 * z311;
    const Scalar z327 = z251 + z326;
    const Scalar z328 = n0_02 + z324;
    const Scalar z329 = z23 * z236 - z102 + z30 * z311;
    const Scalar z330 = z252 + z329;
    const Scalar z331 = z69 * z252 + z173 * z273 + z19 * z312 + z21 * z257;
    const Scalar z332 = z69 * z251 - z168 * z273 + z19 * z313 + z12 * z257;
    const Scalar z333 = z21 * z303 - z173 * z307 - z163 * z309 - z167 * z314 + z30 * z315 - z23 * z316;
    const Scalar z334 = z312 + z333;
    const Scalar z335 = z20 * z312 - z45 * z252 - z167 * z273 + z30 * z257;
    const Scalar z336 = z312 - z305;
    const Scalar z337 = z22 * z312 - z60 * z252 - z163 * z273 + z23 * z257;
    const Scalar z338 = s_front_right_hip * z60 + c_front_right_hip * z45 + z20 * z231 - z22 * z239;
    const Scalar z339 = z174 * z273 - z45 * z251 + z20 * z313 + z25 * z257;
    const Scalar z340 = z12 * z307 - z24 * z309 - z25 * z314;
    const Scalar z341 = z251 - z340;
    const Scalar z342 = z21 * z307 - z23 * z309 - z30 * z314;
    const Scalar z343 = z252 - z342;
    const Scalar z344 = z257 + z319;
    const Scalar z345 = z69 * z278 + z173 * z280 + z19 * z336 + z21 * z344;
    const Scalar z346 = s_front_right_hip * z163 + c_front_right_hip * z167 + z30 * z231 - z23 * z239;
    const Scalar z347 = z176 + z60 * z236 + z20 * z241 - z22 * z244 + z45 * z311;
    const Scalar z348 = z257 + z347;
    const Scalar z349 = z19 * z277 + z12 * z280;
    const Scalar z350 = z164 * z273 - z60 * z251 + z22 * z313 + z24 * z257;
    const Scalar z351 = s_front_right_hip * z24 + c_front_right_hip * z25;
    const Scalar z352 = n0_05 * z174 + z254;
    const Scalar z353 = s_front_right_hip * z23 + c_front_right_hip * z30;
    const Scalar z354 = z25 * z241 - z254 - z164 * z236 - z24 * z244 - z174 * z311;
    const Scalar z355 = s_front_right_hip * z164 + c_front_right_hip * z174 - z25 * z231 + z24 * z239;
    const Scalar z356 = z313 - z354;
    const Scalar z357 = z325 * z322 - z330 * z338 - z321 * z346 + z353 * z348;
    const Scalar z358 = z321 * z355 - z327 * z338 + z325 * z356 + z351 * z348;
    const Scalar z359 = z325 * z330 + z353 * z321;
    const Scalar z360 = z325 * z327 + z351 * z321;
    const Scalar z361 = n0_2 * s_rear_left_knee;
    const Scalar z362 = n0_2 * c_rear_left_knee;
    const Scalar z363 = n0_2 + z362;
    const Scalar z364 = c_rear_left_thigh * z361;
    const Scalar z365 = s_rear_left_thigh * z361;
    const Scalar z366 = n0_08 * c_rear_left_hip;
    const Scalar z367 = n0_08 * s_rear_left_hip;
    const Scalar z368 = z313 + z352;
    const Scalar z369 = z69 * z277 - z168 * z280 + z19 * z368 + z12 * z344;
    const Scalar z370 = s_rear_left_thigh * z363 + z364;
    const Scalar z371 = c_rear_left_thigh * z363 - z365;
    const Scalar z372 = n0_2 + z370;
    const Scalar z373 = s_rear_left_hip * z371 + z366;
    const Scalar z374 = c_rear_left_hip * z371 - z367;
    const Scalar z375 = z12 * z303 + z168 * z307 + z164 * z309 + z174 * z314 + z25 * z315 - z24 * z316;
    const Scalar z376 = z19 * z303 - z69 * z307 - z60 * z309 - z45 * z314 + z20 * z315 - z22 * z316;
    const Scalar z377 = z313 + z375;
    const Scalar z378 = z257 - z376;
    const Scalar z379 = n0_05 + z373;
    const Scalar z380 = z12 * z372 + z24 * z374 - z25 * z379;
    const Scalar z381 = z325 * z334 - z343 * z338 - z328 * z346 + z353 * z378;
    const Scalar z382 = v_trunk_attitude_omega_x * z331 + v_trunk_attitude_omega_y * z335 + v_trunk_attitude_omega_z
        * z337 + v_front_right_hip * z345 + v_front_right_thigh * z357 + v_front_right_knee * z381;
    const Scalar z383 = z328 * z355 - z341 * z338 + z325 * z377 + z351 * z378;
    const Scalar z384 = v_trunk_attitude_omega_x * z332 + v_trunk_attitude_omega_y * z339 + v_trunk_attitude_omega_z
        * z350 + v_front_right_hip * z369 + v_front_right_thigh * z358 + v_front_right_knee * z383;
    const Scalar z385 = z325 * z343 + z353 * z328;
    const Scalar z386 = v_trunk_x - v_trunk_attitude_omega_x * z281 - v_trunk_attitude_omega_y * z285
        - v_trunk_attitude_omega_z * z289 - v_front_right_hip * z291 - v_front_right_thigh * z359 - v_front_right_knee
        * z385;
    const Scalar z387 = z325 * z341 + z351 * z328;
    const Scalar z388 = v_trunk_y + v_trunk_attitude_omega_x * z282 + v_trunk_attitude_omega_y * z286
        + v_trunk_attitude_omega_z * z290 + v_front_right_hip * z349 + v_front_right_thigh * z360 + v_front_right_knee
        * z387;
    const Scalar z389 = z270 + z380;
    const Scalar z390 = s_rear_left_thigh * z362 + z364;
    const Scalar z391 = c_rear_left_thigh * z362 - z365;
    const Scalar z392 = z19 * z374 - z44 * z372;
    const Scalar z393 = z48 * z379 - z50 * z372;
    const Scalar z394 = v_rear_left_thigh * c_rear_left_thigh;
    const Scalar z395 = v_rear_left_knee * c_rear_left_knee;
    const Scalar z396 = v_rear_left_thigh * s_rear_left_thigh;
    const Scalar z397 = v_rear_left_knee * s_rear_left_knee;
    const Scalar z398 = n0_2 * z395;
    const Scalar z399 = v_rear_left_knee * z395;
    const Scalar z400 = n0_2 * z397;
    const Scalar z401 = v_rear_left_knee * z397;
    const Scalar z402 = n0_2 * z399;
    const Scalar z403 = v_rear_left_hip * s_rear_left_hip;
    const Scalar z404 = n0_2 * z401;
    const Scalar z405 = v_rear_left_hip * c_rear_left_hip;
    const Scalar z406 = n0_08 * z403;
    const Scalar z407 = z361 * z394 + s_rear_left_thigh * z398 + c_rear_left_thigh * z400 + z363 * z396;
    const Scalar z408 = n0_08 * z405;
    const Scalar z409 = z361 * z396 + s_rear_left_thigh * z400 - c_rear_left_thigh * z398 - z363 * z394;
    const Scalar z410 = z21 * z372 + z23 * z374 - z30 * z379;
    const Scalar z411 = z276 + z410;
    const Scalar z412 = z406 - z371 * z405 + s_rear_left_hip * z407;
    const Scalar z413 = z20 * z379 - z22 * z374 - z19 * z372;
    const Scalar z414 = z274 - z413;
    const Scalar z415 = v_rear_left_thigh * z396;
    const Scalar z416 = z408 + z371 * z403 + c_rear_left_hip * z407;
    const Scalar z417 = n0_02 + z414;
    const Scalar z418 = n2 * z407;
    const Scalar z419 = v_rear_left_thigh * z394;
    const Scalar z420 = n0_02 - z413;
    const Scalar z421 = z69 * z372 - z60 * z374 + z45 * z379 - z19 * z409 + z20 * z412 - z22 * z416;
    const Scalar z422 = v_trunk_z - z421;
    const Scalar z423 = z21 * z420 - z19 * z410;
    const Scalar z424 = z22 * z380 - z24 * z420;
    const Scalar z425 = v_rear_left_hip * z403;
    const Scalar z426 = v_rear_left_hip * z405;
    const Scalar z427 = z12 * z420 - z19 * z380;
    const Scalar z428 = z30 * z420 - z20 * z410;
    const Scalar z429 = s_rear_left_hip * z24 + c_rear_left_hip * z25;
    const Scalar z430 = z361 * z415 - z363 * z419 + s_rear_left_thigh * z404 - c_rear_left_thigh * z402 - n2 * (z394
        * z398 - z396 * z400);
    const Scalar z431 = z361 * z419 + z363 * z415 + s_rear_left_thigh * z402 + c_rear_left_thigh * z404 + n2 * (z394
        * z400 + z398 * z396);
    const Scalar z432 = z25 * z420 - z20 * z380;
    const Scalar z433 = z23 * z420 - z22 * z410;
    const Scalar z434 = s_rear_left_hip * z23 + c_rear_left_hip * z30;
    const Scalar z435 = z21 * z417 - z19 * z411;
    const Scalar z436 = z12 * z417 - z19 * z389;
    const Scalar z437 = s_rear_left_hip * z370;
    const Scalar z438 = c_rear_left_hip * z370;
    const Scalar z439 = z19 * z371 + z20 * z437 - z22 * z438;
    const Scalar z440 = s_rear_left_hip * z390;
    const Scalar z441 = c_rear_left_hip * z390;
    const Scalar z442 = z19 * z391 + z20 * z440 - z22 * z441;
    const Scalar z443 = n0_08 * z425 - z371 * z426 + z403 * z418 + c_rear_left_hip * z430;
    const Scalar z444 = s_rear_left_hip * z430 - z371 * z425 - z405 * z418 - n0_08 * z426;
    const Scalar z445 = z127 * z372 - z131 * z374 - z128 * z379 + z19 * z431 + n2 * (z69 * z409 + z45 * z412 - z60
        * z416) - z22 * z443 + z20 * z444;
    const Scalar z446 = z20 * z374;
    const Scalar z447 = z22 * z373 + z446;
    const Scalar z448 = z46 * z379 - z446;
    const Scalar z449 = q_trunk_z + z413;
    const Scalar z450 = n0_02 - z449;
    const Scalar z451 = n0_2 * z394;
    const Scalar z452 = n0_2 * z396;
    const Scalar z453 = z319 - z421;
    const Scalar z454 = n0_2 * c_rear_left_thigh;
    const Scalar z455 = n0_2 * s_rear_left_thigh;
    const Scalar z456 = n0_2 + z455;
    const Scalar z457 = s_rear_left_hip * z454 + z366;
    const Scalar z458 = n0_05 + z366;
    const Scalar z459 = c_rear_left_hip * z454 - z367;
    const Scalar z460 = z24 * z367 - z112 + z25 * z458;
    const Scalar z461 = n0_05 + z457;
    const Scalar z462 = z22 * z367 - z103 + z20 * z458;
    const Scalar z463 = z380 + z460;
    const Scalar z464 = z413 - z462;
    const Scalar z465 = z168 * z372 - z164 * z374 + z174 * z379 + z12 * z409 - z25 * z412 + z24 * z416;
    const Scalar z466 = z163 * z374 - z173 * z372 - z167 * z379 + z21 * z409 - z30 * z412 + z23 * z416;
    const Scalar z467 = n0_02 - z464;
    const Scalar z468 = z352 - z465;
    const Scalar z469 = z69 * z389 + z168 * z417 + z12 * z453 + z19 * z468;
    const Scalar z470 = z305 + z466;
    const Scalar z471 = z69 * z411 - z173 * z417 + z21 * z453 - z19 * z470;
    const Scalar z472 = s_rear_left_hip * z60 + c_rear_left_hip * z45 + z20 * z403 - z22 * z405;
    const Scalar z473 = z406 + s_rear_left_hip * z452 - z405 * z454;
    const Scalar z474 = z408 + z403 * z454 + c_rear_left_hip * z452;
    const Scalar z475 = z23 * z367 - z102 + z30 * z458;
    const Scalar z476 = z410 + z475;
    const Scalar z477 = z12 * z456 + z24 * z459 - z25 * z461;
    const Scalar z478 = z380 - z477;
    const Scalar z479 = z20 * z461 - z22 * z459 - z19 * z456;
    const Scalar z480 = z413 - z479;
    const Scalar z481 = s_rear_left_hip * z164 + c_rear_left_hip * z174 - z25 * z403 + z24 * z405;
    const Scalar z482 = s_rear_left_hip * z163 + c_rear_left_hip * z167 + z30 * z403 - z23 * z405;
    const Scalar z483 = n0_02 - z480;
    const Scalar z484 = z45 * z410 - z167 * z420 + z30 * z421 + z20 * z466;
    const Scalar z485 = z176 + z60 * z367 + z20 * z406 - z22 * z408 + z45 * z458;
    const Scalar z486 = z421 - z485;
    const Scalar z487 = z45 * z380 + z174 * z420 + z25 * z421 + z20 * z465;
    const Scalar z488 = z21 * z456 + z23 * z459 - z30 * z461;
    const Scalar z489 = z410 - z488;
    const Scalar z490 = z60 * z410 - z163 * z420 + z23 * z421 + z22 * z466;
    const Scalar z491 = z173 * z420 - z69 * z410 + z21 * z421 + z19 * z466;
    const Scalar z492 = z60 * z380 + z164 * z420 + z22 * z465 + z24 * z421;
    const Scalar z493 = z12 * z421 + z19 * z465 - z69 * z380 - z168 * z420;
    const Scalar z494 = z19 * z451 + z69 * z456 - z60 * z459 + z45 * z461 + z20 * z473 - z22 * z474;
    const Scalar z495 = z421 - z494;
    const Scalar z496 = z25 * z406 - z254 - z164 * z367 - z24 * z408 - z174 * z458;
    const Scalar z497 = z175 + z163 * z367 + z30 * z406 - z23 * z408 + z167 * z458;
    const Scalar z498 = z466 + z497;
    const Scalar z499 = s_rear_left_hip * z22 + c_rear_left_hip * z20;
    const Scalar z500 = z465 + z496;
    const Scalar z501 = z463 * z472 + z467 * z481 + z429 * z486 + z499 * z500;
    const Scalar z502 = z476 * z472 - z467 * z482 + z434 * z486 + z499 * z498;
    const Scalar z503 = z434 * z467 - z499 * z476;
    const Scalar z504 = z429 * z467 - z499 * z463;
    const Scalar z505 = n0_2 * s_rear_right_knee;
    const Scalar z506 = n0_2 * c_rear_right_knee;
    const Scalar z507 = n0_2 + z506;
    const Scalar z508 = c_rear_right_thigh * z505;
    const Scalar z509 = s_rear_right_thigh * z505;
    const Scalar z510 = n0_08 * s_rear_right_hip;
    const Scalar z511 = n0_08 * c_rear_right_hip;
    const Scalar z512 = z12 * z451 - z168 * z456 + z164 * z459 - z174 * z461 + z25 * z473 - z24 * z474;
    const Scalar z513 = z21 * z451 + z173 * z456 - z163 * z459 + z167 * z461 + z30 * z473 - z23 * z474;
    const Scalar z514 = z465 + z512;
    const Scalar z515 = z466 + z513;
    const Scalar z516 = z478 * z472 + z483 * z481 + z429 * z495 + z499 * z514;
    const Scalar z517 = v_trunk_attitude_omega_y * z487 + v_trunk_attitude_omega_z * z492 - v_rear_left_hip * z469
        + v_rear_left_thigh * z501 + v_rear_left_knee * z516 + v_trunk_attitude_omega_x * z493;
    const Scalar z518 = z489 * z472 - z483 * z482 + z434 * z495 + z499 * z515;
    const Scalar z519 = v_trunk_attitude_omega_y * z484 + v_trunk_attitude_omega_z * z490 + v_trunk_attitude_omega_x
        * z491 - v_rear_left_hip * z471 + v_rear_left_thigh * z502 + v_rear_left_knee * z518;
    const Scalar z520 = z434 * z483 - z499 * z489;
    const Scalar z521 = v_trunk_x - v_trunk_attitude_omega_x * z423 - v_trunk_attitude_omega_y * z428
        - v_trunk_attitude_omega_z * z433 - v_rear_left_hip * z435 - v_rear_left_thigh * z503 - v_rear_left_knee * z520;
    const Scalar z522 = z429 * z483 - z499 * z478;
    const Scalar z523 = v_trunk_y - v_trunk_attitude_omega_z * z424 + v_trunk_attitude_omega_x * z427
        + v_trunk_attitude_omega_y * z432 + v_rear_left_hip * z436 + v_rear_left_thigh * z504 + v_rear_left_knee * z522;
    const Scalar z524 = v_rear_right_thigh * c_rear_right_thigh;
    const Scalar z525 = v_rear_right_knee * c_rear_right_knee;
    const Scalar z526 = v_rear_right_thigh * s_rear_right_thigh;
    const Scalar z527 = v_rear_right_knee * s_rear_right_knee;
    const Scalar z528 = s_rear_right_thigh * z507 + z508;
    const Scalar z529 = s_rear_right_thigh * z506 + z508;
    const Scalar z530 = c_rear_right_thigh * z506 - z509;
    const Scalar z531 = c_rear_right_thigh * z507 - z509;
    const Scalar z532 = n0_2 * z525;
    const Scalar z533 = v_rear_right_knee * z525;
    const Scalar z534 = n0_2 * z533;
    const Scalar z535 = n0_2 * z527;
    const Scalar z536 = v_rear_right_knee * z527;
    const Scalar z537 = n0_2 * z536;
    const Scalar z538 = n0_2 + z528;
    const Scalar z539 = c_rear_right_hip * z531 + z510;
    const Scalar z540 = z19 * z539 - z44 * z538;
    const Scalar z541 = s_rear_right_hip * z531 - z511;
    const Scalar z542 = v_rear_right_hip * c_rear_right_hip;
    const Scalar z543 = n0_05 - z541;
    const Scalar z544 = v_rear_right_hip * s_rear_right_hip;
    const Scalar z545 = n0_08 * z542;
    const Scalar z546 = z505 * z524 + s_rear_right_thigh * z532 + c_rear_right_thigh * z535 + z507 * z526;
    const Scalar z547 = z50 * z538 + z48 * z543;
    const Scalar z548 = n0_08 * z544;
    const Scalar z549 = z505 * z526 + s_rear_right_thigh * z535 - c_rear_right_thigh * z532 - z507 * z524;
    const Scalar z550 = z19 * z538 + z22 * z539 + z20 * z543;
    const Scalar z551 = z111 - z550;
    const Scalar z552 = z531 * z544 - z545 + c_rear_right_hip * z546;
    const Scalar z553 = z12 * z538 + z24 * z539 + z25 * z543;
    const Scalar z554 = z122 - z553;
    const Scalar z555 = n0_02 - z551;
    const Scalar z556 = n0_02 + z550;
    const Scalar z557 = z21 * z538 + z23 * z539 + z30 * z543;
    const Scalar z558 = z110 - z557;
    const Scalar z559 = s_rear_right_hip * z546 - z548 - z531 * z542;
    const Scalar z560 = n2 * z546;
    const Scalar z561 = v_rear_right_thigh * z524;
    const Scalar z562 = v_rear_right_thigh * z526;
    const Scalar z563 = z69 * z538 - z60 * z539 - z45 * z543 - z19 * z549 - z22 * z552 + z20 * z559;
    const Scalar z564 = v_trunk_z - z563;
    const Scalar z565 = z21 * z556 - z19 * z557;
    const Scalar z566 = z22 * z553 - z24 * z556;
    const Scalar z567 = v_rear_right_hip * z542;
    const Scalar z568 = v_rear_right_hip * z544;
    const Scalar z569 = z12 * z556 - z19 * z553;
    const Scalar z570 = z30 * z556 - z20 * z557;
    const Scalar z571 = s_rear_right_hip * z24 + c_rear_right_hip * z25;
    const Scalar z572 = z505 * z561 + z507 * z562 + s_rear_right_thigh * z534 + c_rear_right_thigh * z537 + n2 * (z524
        * z535 + z532 * z526);
    const Scalar z573 = z505 * z562 - z507 * z561 + s_rear_right_thigh * z537 - c_rear_right_thigh * z534 - n2 * (z524
        * z532 - z526 * z535);
    const Scalar z574 = z25 * z556 - z20 * z553;
    const Scalar z575 = z23 * z556 - z22 * z557;
    const Scalar z576 = s_rear_right_hip * z23 + c_rear_right_hip * z30;
    const Scalar z577 = z19 * z558 + z21 * z555;
    const Scalar z578 = z19 * z554 + z12 * z555;
    const Scalar z579 = s_rear_right_hip * z528;
    const Scalar z580 = c_rear_right_hip * z528;
    const Scalar z581 = z19 * z531 + z20 * z579 - z22 * z580;
    const Scalar z582 = s_rear_right_hip * z529;
    const Scalar z583 = c_rear_right_hip * z529;
    const Scalar z584 = z19 * z530 + z20 * z582 - z22 * z583;
    const Scalar z585 = n0_08 * z567 - z531 * z568 - z542 * z560 + s_rear_right_hip * z573;
    const Scalar z586 = z544 * z560 - n0_08 * z568 - z531 * z567 + c_rear_right_hip * z573;
    const Scalar z587 = z127 * z538 - z131 * z539 + z128 * z543 + z19 * z572 + n2 * (z69 * z549 - z60 * z552 + z45
        * z559) + z20 * z585 - z22 * z586;
    const Scalar z588 = z20 * z539;
    const Scalar z589 = z46 * z543 + z588;
    const Scalar z590 = z22 * z541 + z588;
    const Scalar z591 = q_trunk_z - z550;
    const Scalar z592 = n0_02 - z591;
    const Scalar z593 = n0_2 * z524;
    const Scalar z594 = n0_2 * z526;
    const Scalar z595 = z183 + z563;
    const Scalar z596 = n0_2 * s_rear_right_thigh;
    const Scalar z597 = n0_2 + z596;
    const Scalar z598 = n0_2 * c_rear_right_thigh;
    const Scalar z599 = c_rear_right_hip * z598 + z510;
    const Scalar z600 = n0_05 + z511;
    const Scalar z601 = s_rear_right_hip * z598 - z511;
    const Scalar z602 = z112 + z24 * z510 + z25 * z600;
    const Scalar z603 = n0_05 - z601;
    const Scalar z604 = z103 + z22 * z510 + z20 * z600;
    const Scalar z605 = z553 - z602;
    const Scalar z606 = z550 - z604;
    const Scalar z607 = z102 + z23 * z510 + z30 * z600;
    const Scalar z608 = n0_02 + z606;
    const Scalar z609 = z557 - z607;
    const Scalar z610 = z60 * z510 - z176 + z20 * z548 - z22 * z545 + z45 * z600;
    const Scalar z611 = z563 + z610;
    const Scalar z612 = z254 - z164 * z510 + z25 * z548 - z24 * z545 - z174 * z600;
    const Scalar z613 = z163 * z510 - z175 + z30 * z548 - z23 * z545 + z167 * z600;
    const Scalar z614 = s_rear_right_hip * z594 - z548 - z542 * z598;
    const Scalar z615 = z544 * z598 - z545 + c_rear_right_hip * z594;
    const Scalar z616 = z168 * z538 - z164 * z539 - z174 * z543 + z12 * z549 + z24 * z552 - z25 * z559;
    const Scalar z617 = z163 * z539 - z173 * z538 + z167 * z543 + z21 * z549 + z23 * z552 - z30 * z559;
    const Scalar z618 = z258 + z616;
    const Scalar z619 = z69 * z554 - z168 * z555 + z12 * z595 + z19 * z618;
    const Scalar z620 = z180 + z617;
    const Scalar z621 = z69 * z558 + z173 * z555 + z21 * z595 + z19 * z620;
    const Scalar z622 = z617 - z613;
    const Scalar z623 = s_rear_right_hip * z60 + c_rear_right_hip * z45 + z20 * z544 - z22 * z542;
    const Scalar z624 = z12 * z597 + z24 * z599 + z25 * z603;
    const Scalar z625 = z553 - z624;
    const Scalar z626 = z19 * z597 + z22 * z599 + z20 * z603;
    const Scalar z627 = z550 - z626;
    const Scalar z628 = s_rear_right_hip * z164 + c_rear_right_hip * z174 - z25 * z544 + z24 * z542;
    const Scalar z629 = s_rear_right_hip * z163 + c_rear_right_hip * z167 + z30 * z544 - z23 * z542;
    const Scalar z630 = n0_02 + z627;
    const Scalar z631 = z173 * z556 - z69 * z557 + z21 * z563 + z19 * z617;
    const Scalar z632 = z21 * z593 + z173 * z597 - z163 * z599 - z167 * z603 + z30 * z614 - z23 * z615;
    const Scalar z633 = z21 * z597 + z23 * z599 + z30 * z603;
    const Scalar z634 = z45 * z557 - z167 * z556 + z30 * z563 + z20 * z617;
    const Scalar z635 = z60 * z557 - z163 * z556 + z23 * z563 + z22 * z617;
    const Scalar z636 = z557 - z633;
    const Scalar z637 = z617 + z632;
    const Scalar z638 = z45 * z553 + z174 * z556 + z25 * z563 + z20 * z616;
    const Scalar z639 = z19 * z593 + z69 * z597 - z60 * z599 - z45 * z603 + z20 * z614 - z22 * z615;
    const Scalar z640 = z12 * z563 + z19 * z616 - z69 * z553 - z168 * z556;
    const Scalar z641 = z60 * z553 + z164 * z556 + z22 * z616 + z24 * z563;
    const Scalar z642 = s_rear_right_hip * z22 + c_rear_right_hip * z20;
    const Scalar z643 = z12 * z593 - z168 * z597 + z164 * z599 + z174 * z603 + z25 * z614 - z24 * z615;
    const Scalar z644 = z563 - z639;
    const Scalar z645 = z616 - z612;
    const Scalar z646 = z616 + z643;
    const Scalar z647 = z605 * z623 + z608 * z628 + z571 * z611 + z642 * z645;
    const Scalar z648 = z609 * z623 - z608 * z629 + z576 * z611 + z642 * z622;
    const Scalar z649 = z625 * z623 + z630 * z628 + z571 * z644 + z642 * z646;
    const Scalar z650 = v_trunk_attitude_omega_y * z638 + v_trunk_attitude_omega_z * z641 + v_rear_right_hip * z619
        + v_rear_right_thigh * z647 + v_rear_right_knee * z649 + v_trunk_attitude_omega_x * z640;
    const Scalar z651 = z636 * z623 - z630 * z629 + z576 * z644 + z642 * z637;
    const Scalar z652 = v_trunk_attitude_omega_x * z631 + v_trunk_attitude_omega_y * z634 + v_trunk_attitude_omega_z
        * z635 + v_rear_right_hip * z621 + v_rear_right_thigh * z648 + v_rear_right_knee * z651;
    const Scalar z653 = z576 * z608 - z642 * z609;
    const Scalar z654 = z571 * z608 - z642 * z605;
    const Scalar z655 = z576 * z630 - z642 * z636;
    const Scalar z656 = z571 * z630 - z642 * z625;
    const Scalar z657 = v_trunk_x - v_trunk_attitude_omega_x * z565 - v_trunk_attitude_omega_y * z570
        - v_trunk_attitude_omega_z * z575 - v_rear_right_hip * z577 - v_rear_right_thigh * z653 - v_rear_right_knee
        * z655;
    const Scalar z658 = v_trunk_y - v_trunk_attitude_omega_z * z566 + v_trunk_attitude_omega_x * z569
        + v_trunk_attitude_omega_y * z574 + v_rear_right_hip * z578 + v_rear_right_thigh * z654 + v_rear_right_knee
        * z656;
    result.gap[0] = -z96;
    result.rate[0] = z85;
    result.drift[0] = z161;
    result.rate[1] = z214;
    result.drift[1] = -z212;
    result.rate[2] = z218;
    result.drift[2] = z269;
    result.gap[1] = -z302;
    result.rate[3] = z271;
    result.drift[3] = z297;
    result.rate[4] = z386;
    result.drift[4] = -z382;
    result.rate[5] = z388;
    result.drift[5] = z384;
    result.gap[2] = -z450;
    result.rate[6] = z422;
    result.drift[6] = z445;
    result.rate[7] = z521;
    result.drift[7] = -z519;
    result.rate[8] = z523;
    result.drift[8] = z517;
    result.gap[3] = -z592;
    result.rate[9] = z564;
    result.drift[9] = z587;
    result.rate[10] = z657;
    result.drift[10] = -z652;
    result.rate[11] = z658;
    result.drift[11] = z650;
    result.jacobian[0] = n0;
    result.jacobian[1] = n1;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = n1;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = n1;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = n1;
    result.jacobian[11] = n0;
    result.jacobian[12] = n0;
    result.jacobian[13] = n0;
    result.jacobian[14] = n1;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n1;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = n1;
    result.jacobian[21] = n0;
    result.jacobian[22] = n0;
    result.jacobian[23] = n1;
    result.jacobian[24] = n1;
    result.jacobian[25] = n0;
    result.jacobian[26] = n0;
    result.jacobian[27] = n1;
    result.jacobian[28] = n0;
    result.jacobian[29] = n0;
    result.jacobian[30] = n1;
    result.jacobian[31] = n0;
    result.jacobian[32] = n0;
    result.jacobian[33] = n1;
    result.jacobian[34] = n0;
    result.jacobian[35] = n0;
    result.jacobian[36] = -z94;
    result.jacobian[37] = -z139;
    result.jacobian[38] = z140;
    result.jacobian[39] = z300;
    result.jacobian[40] = -z281;
    result.jacobian[41] = z282;
    result.jacobian[42] = -z448;
    result.jacobian[43] = -z423;
    result.jacobian[44] = z427;
    result.jacobian[45] = z589;
    result.jacobian[46] = -z565;
    result.jacobian[47] = z569;
    result.jacobian[48] = -z72;
    result.jacobian[49] = -z149;
    result.jacobian[50] = z150;
    result.jacobian[51] = -z243;
    result.jacobian[52] = -z285;
    result.jacobian[53] = z286;
    result.jacobian[54] = -z392;
    result.jacobian[55] = -z428;
    result.jacobian[56] = z432;
    result.jacobian[57] = -z540;
    result.jacobian[58] = -z570;
    result.jacobian[59] = z574;
    result.jacobian[60] = z73;
    result.jacobian[61] = -z153;
    result.jacobian[62] = z154;
    result.jacobian[63] = -z248;
    result.jacobian[64] = -z289;
    result.jacobian[65] = z290;
    result.jacobian[66] = z393;
    result.jacobian[67] = -z433;
    result.jacobian[68] = -z424;
    result.jacobian[69] = -z547;
    result.jacobian[70] = -z575;
    result.jacobian[71] = -z566;
    result.jacobian[72] = z93;
    result.jacobian[73] = -z156;
    result.jacobian[74] = z157;
    result.jacobian[75] = n0;
    result.jacobian[76] = n0;
    result.jacobian[77] = n0;
    result.jacobian[78] = n0;
    result.jacobian[79] = n0;
    result.jacobian[80] = n0;
    result.jacobian[81] = n0;
    result.jacobian[82] = n0;
    result.jacobian[83] = n0;
    result.jacobian[84] = -z88;
    result.jacobian[85] = -z204;
    result.jacobian[86] = z208;
    result.jacobian[87] = n0;
    result.jacobian[88] = n0;
    result.jacobian[89] = n0;
    result.jacobian[90] = n0;
    result.jacobian[91] = n0;
    result.jacobian[92] = n0;
    result.jacobian[93] = n0;
    result.jacobian[94] = n0;
    result.jacobian[95] = n0;
    result.jacobian[96] = -z91;
    result.jacobian[97] = -z213;
    result.jacobian[98] = z217;
    result.jacobian[99] = n0;
    result.jacobian[100] = n0;
    result.jacobian[101] = n0;
    result.jacobian[102] = n0;
    result.jacobian[103] = n0;
    result.jacobian[104] = n0;
    result.jacobian[105] = n0;
    result.jacobian[106] = n0;
    result.jacobian[107] = n0;
    result.jacobian[108] = n0;
    result.jacobian[109] = n0;
    result.jacobian[110] = n0;
    result.jacobian[111] = z299;
    result.jacobian[112] = -z291;
    result.jacobian[113] = z349;
    result.jacobian[114] = n0;
    result.jacobian[115] = n0;
    result.jacobian[116] = n0;
    result.jacobian[117] = n0;
    result.jacobian[118] = n0;
    result.jacobian[119] = n0;
    result.jacobian[120] = n0;
    result.jacobian[121] = n0;
    result.jacobian[122] = n0;
    result.jacobian[123] = -z264;
    result.jacobian[124] = -z359;
    result.jacobian[125] = z360;
    result.jacobian[126] = n0;
    result.jacobian[127] = n0;
    result.jacobian[128] = n0;
    result.jacobian[129] = n0;
    result.jacobian[130] = n0;
    result.jacobian[131] = n0;
    result.jacobian[132] = n0;
    result.jacobian[133] = n0;
    result.jacobian[134] = n0;
    result.jacobian[135] = -z294;
    result.jacobian[136] = -z385;
    result.jacobian[137] = z387;
    result.jacobian[138] = n0;
    result.jacobian[139] = n0;
    result.jacobian[140] = n0;
    result.jacobian[141] = n0;
    result.jacobian[142] = n0;
    result.jacobian[143] = n0;
    result.jacobian[144] = n0;
    result.jacobian[145] = n0;
    result.jacobian[146] = n0;
    result.jacobian[147] = n0;
    result.jacobian[148] = n0;
    result.jacobian[149] = n0;
    result.jacobian[150] = z447;
    result.jacobian[151] = -z435;
    result.jacobian[152] = z436;
    result.jacobian[153] = n0;
    result.jacobian[154] = n0;
    result.jacobian[155] = n0;
    result.jacobian[156] = n0;
    result.jacobian[157] = n0;
    result.jacobian[158] = n0;
    result.jacobian[159] = n0;
    result.jacobian[160] = n0;
    result.jacobian[161] = n0;
    result.jacobian[162] = -z439;
    result.jacobian[163] = -z503;
    result.jacobian[164] = z504;
    result.jacobian[165] = n0;
    result.jacobian[166] = n0;
    result.jacobian[167] = n0;
    result.jacobian[168] = n0;
    result.jacobian[169] = n0;
    result.jacobian[170] = n0;
    result.jacobian[171] = n0;
    result.jacobian[172] = n0;
    result.jacobian[173] = n0;
    result.jacobian[174] = -z442;
    result.jacobian[175] = -z520;
    result.jacobian[176] = z522;
    result.jacobian[177] = n0;
    result.jacobian[178] = n0;
    result.jacobian[179] = n0;
    result.jacobian[180] = n0;
    result.jacobian[181] = n0;
    result.jacobian[182] = n0;
    result.jacobian[183] = n0;
    result.jacobian[184] = n0;
    result.jacobian[185] = n0;
    result.jacobian[186] = n0;
    result.jacobian[187] = n0;
    result.jacobian[188] = n0;
    result.jacobian[189] = z590;
    result.jacobian[190] = -z577;
    result.jacobian[191] = z578;
    result.jacobian[192] = n0;
    result.jacobian[193] = n0;
    result.jacobian[194] = n0;
    result.jacobian[195] = n0;
    result.jacobian[196] = n0;
    result.jacobian[197] = n0;
    result.jacobian[198] = n0;
    result.jacobian[199] = n0;
    result.jacobian[200] = n0;
    result.jacobian[201] = -z581;
    result.jacobian[202] = -z653;
    result.jacobian[203] = z654;
    result.jacobian[204] = n0;
    result.jacobian[205] = n0;
    result.jacobian[206] = n0;
    result.jacobian[207] = n0;
    result.jacobian[208] = n0;
    result.jacobian[209] = n0;
    result.jacobian[210] = n0;
    result.jacobian[211] = n0;
    result.jacobian[212] = n0;
    result.jacobian[213] = -z584;
    result.jacobian[214] = -z655;
    result.jacobian[215] = z656;
  }

  /// What the surfaces of each contact are made of, in the order front_left_foot_ground, front_right_foot_ground, rear_left_foot_ground, rear_right_foot_ground:
  /// |T| <= f N + b while it slides, f_s and b_s while it sticks.
  TORSOR_DEVICE static void contact_coefficients(const Precomputed& precomputed, const State&,
      ContactCoefficients& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_ground_friction = precomputed.parameters.ground_friction;
    const Scalar p_ground_restitution = precomputed.parameters.ground_restitution;
    result.friction[0] = p_ground_friction;
    result.static_friction[0] = p_ground_friction;
    result.restitution[0] = p_ground_restitution;
    result.bound[0] = n0;
    result.static_bound[0] = n0;
    result.friction[1] = p_ground_friction;
    result.static_friction[1] = p_ground_friction;
    result.restitution[1] = p_ground_restitution;
    result.bound[1] = n0;
    result.static_bound[1] = n0;
    result.friction[2] = p_ground_friction;
    result.static_friction[2] = p_ground_friction;
    result.restitution[2] = p_ground_restitution;
    result.bound[2] = n0;
    result.static_bound[2] = n0;
    result.friction[3] = p_ground_friction;
    result.static_friction[3] = p_ground_friction;
    result.restitution[3] = p_ground_restitution;
    result.bound[3] = n0;
    result.static_bound[3] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 19>&>(coordinate_rates));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 324>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[4], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[5], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[6], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace quadruped_on_its_feet
