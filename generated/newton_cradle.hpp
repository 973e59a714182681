// SPDX-License-Identifier: MIT-0
// newton_cradle: Newton's cradle of five balls
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: e
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   0                0          0             0                  0       0      0       0
//   bias                          0               10          0             0                  5       0     20      20
//   energy                        8               12          0             0                  5       0     30      38
//   contacts                     64              108         20             4                  5       0    206     234
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 25 results 20 vanish identically
//   energy: of 3 results 1 vanish identically
//   contacts: of 32 results 12 vanish identically
//   contact_coefficients: of 20 results 16 vanish identically, 3 repeat another up to sign
//
// To write this file again:
//   newton_cradle_scene generate --kernels mass_matrix,bias,energy,contacts,contact_coefficients --support torsor_support.hpp --output newton_cradle.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace newton_cradle {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 5> coordinates{{{"a1", "rad"}, {"a2", "rad"}, {"a3", "rad"},
      {"a4", "rad"}, {"a5", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 5> velocities{{{"a1", "rad/s"}, {"a2", "rad/s"}, {"a3",
      "rad/s"}, {"a4", "rad/s"}, {"a5", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"e", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 14> results{{{"mass", "", 5, 5, 2, "kg m^2"}, {"forces", "", 5,
      1, 1, "N m"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power",
      1, 1, 0, "W"}, {"result", "gap", 4, 1, 1, "m"}, {"result", "rate", 4, 1, 1, "m/s"}, {"result", "jacobian", 4, 5,
      2, "m"}, {"result", "drift", 4, 1, 1, "m/s^2"}, {"result", "friction", 4, 1, 1, "1"}, {"result",
      "static_friction", 4, 1, 1, "1"}, {"result", "restitution", 4, 1, 1, "1"}, {"result", "bound", 4, 1, 1, ""},
      {"result", "static_bound", 4, 1, 1, ""}}};
  static constexpr std::array<torsor::KernelDescription, 5> kernels{{{"mass_matrix", false, false, false, false,
      results.data() + 0, 1}, {"bias", false, false, false, false, results.data() + 1, 1}, {"energy", false, false,
      true, false, results.data() + 2, 3}, {"contacts", false, false, false, false, results.data() + 5, 4},
      {"contact_coefficients", false, false, false, false, results.data() + 9, 5}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::newton_cradle::Description;

  static constexpr const char* name = "newton_cradle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x633ea12fe2d39da6ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 5;
  static constexpr int velocity_count = 5;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar e;  ///< parameter [1]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::e};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar a1;  ///< coordinate [rad]
    Scalar a2;  ///< coordinate [rad]
    Scalar a3;  ///< coordinate [rad]
    Scalar a4;  ///< coordinate [rad]
    Scalar a5;  ///< coordinate [rad]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::a1, &Coordinates::a2, &Coordinates::a3,
          &Coordinates::a4, &Coordinates::a5};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar a1;  ///< its rate [rad/s]
    Scalar a2;  ///< its rate [rad/s]
    Scalar a3;  ///< its rate [rad/s]
    Scalar a4;  ///< its rate [rad/s]
    Scalar a5;  ///< its rate [rad/s]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::a1, &Velocities::a2, &Velocities::a3, &Velocities::a4,
          &Velocities::a5};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar a1;  ///< its second rate [rad/s^2]
    Scalar a2;  ///< its second rate [rad/s^2]
    Scalar a3;  ///< its second rate [rad/s^2]
    Scalar a4;  ///< its second rate [rad/s^2]
    Scalar a5;  ///< its second rate [rad/s^2]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::a1, &Accelerations::a2, &Accelerations::a3,
          &Accelerations::a4, &Accelerations::a5};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar a1;  ///< works with the rate of a1 [N m]
    Scalar a2;  ///< works with the rate of a2 [N m]
    Scalar a3;  ///< works with the rate of a3 [N m]
    Scalar a4;  ///< works with the rate of a4 [N m]
    Scalar a5;  ///< works with the rate of a5 [N m]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::a1, &GeneralizedForces::a2,
          &GeneralizedForces::a3, &GeneralizedForces::a4, &GeneralizedForces::a5};
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
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    parameters.e = n1;
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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    state.time = n0;
    state.q.a1 = n0_3;
    state.q.a2 = n0;
    state.q.a3 = n0;
    state.q.a4 = n0;
    state.q.a5 = n0;
    state.v.a1 = n0;
    state.v.a2 = n0;
    state.v.a3 = n0;
    state.v.a4 = n0;
    state.v.a5 = n0;
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
    std::array<Scalar, 4> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 20> jacobian;  ///< J, stored column by column (4 x 5)
    std::array<Scalar, 4> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 4;
  static constexpr int contact_row_count = 4;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[4] = {1, 1, 1, 1};
  static constexpr int contact_tangents[4] = {0, 0, 0, 0};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 4> friction;  ///< f [1]
    std::array<Scalar, 4> static_friction;  ///< f_s [1]
    std::array<Scalar, 4> restitution;  ///< e [1]
    std::array<Scalar, 4> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 4> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 25>& mass) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    mass[0] = n0_5;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0_5;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0_5;
    mass[13] = n0;
    mass[14] = n0;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0_5;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = n0;
    mass[23] = n0;
    mass[24] = n0_5;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar q_a1 = state.q.a1;
    const Scalar q_a2 = state.q.a2;
    const Scalar q_a3 = state.q.a3;
    const Scalar q_a4 = state.q.a4;
    const Scalar q_a5 = state.q.a5;
    const Scalar angles_[] = {q_a1, q_a2, q_a3, q_a4, q_a5};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_a1 = sines_[0];
    const Scalar s_a2 = sines_[1];
    const Scalar s_a3 = sines_[2];
    const Scalar s_a4 = sines_[3];
    const Scalar s_a5 = sines_[4];
    const Scalar z0 = n9_81 * s_a1;
    const Scalar z1 = n9_81 * s_a2;
    const Scalar z2 = n9_81 * s_a3;
    const Scalar z3 = n9_81 * s_a4;
    const Scalar z4 = n9_81 * s_a5;
    const Scalar z5 = n0_5 * z4;  // moment on thread5, y
    const Scalar z6 = n0_5 * z3;  // moment on thread4, y
    const Scalar z7 = n0_5 * z2;  // moment on thread3, y
    const Scalar z8 = n0_5 * z1;  // moment on thread2, y
    const Scalar z9 = n0_5 * z0;  // moment on thread1, y
    forces.a1 = z9;
    forces.a2 = z8;
    forces.a3 = z7;
    forces.a4 = z6;
    forces.a5 = z5;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a1 = state.q.a1;
    const Scalar v_a1 = state.v.a1;
    const Scalar q_a2 = state.q.a2;
    const Scalar v_a2 = state.v.a2;
    const Scalar q_a3 = state.q.a3;
    const Scalar v_a3 = state.v.a3;
    const Scalar q_a4 = state.q.a4;
    const Scalar v_a4 = state.v.a4;
    const Scalar q_a5 = state.q.a5;
    const Scalar v_a5 = state.v.a5;
    const Scalar angles_[] = {q_a1, q_a2, q_a3, q_a4, q_a5};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar c_a1 = cosines_[0];
    const Scalar c_a2 = cosines_[1];
    const Scalar c_a3 = cosines_[2];
    const Scalar c_a4 = cosines_[3];
    const Scalar c_a5 = cosines_[4];
    const Scalar z0 = n0_5 * c_a1;
    const Scalar z1 = n0_5 * c_a2;
    const Scalar z2 = n0_5 * c_a3;
    const Scalar z3 = n0_5 * c_a4;
    const Scalar z4 = n0_5 * c_a5;
    result.kinetic = n0_25 * (v_a1 * v_a1 + v_a2 * v_a2 + v_a3 * v_a3 + v_a4 * v_a4 + v_a5 * v_a5);
    result.force_function = n9_81 * (z0 + z1 + z2 + z3 + z4);
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Contacts that open and close, in the order touch1, touch2, touch3, touch4.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_a1 = state.q.a1;
    const Scalar v_a1 = state.v.a1;
    const Scalar q_a2 = state.q.a2;
    const Scalar v_a2 = state.v.a2;
    const Scalar q_a3 = state.q.a3;
    const Scalar v_a3 = state.v.a3;
    const Scalar q_a4 = state.q.a4;
    const Scalar v_a4 = state.v.a4;
    const Scalar q_a5 = state.q.a5;
    const Scalar v_a5 = state.v.a5;
    const Scalar angles_[] = {q_a1, q_a2, q_a3, q_a4, q_a5};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_a1 = sines_[0], c_a1 = cosines_[0];
    const Scalar s_a2 = sines_[1], c_a2 = cosines_[1];
    const Scalar s_a3 = sines_[2], c_a3 = cosines_[2];
    const Scalar s_a4 = sines_[3], c_a4 = cosines_[3];
    const Scalar s_a5 = sines_[4], c_a5 = cosines_[4];
    const Scalar z0 = n0_1 - s_a2;
    const Scalar z1 = c_a1 - c_a2;
    const Scalar z2 = n0_2 - s_a3;
    const Scalar z3 = c_a2 - c_a3;
    const Scalar z4 = n0_3 - s_a4;
    const Scalar z5 = c_a3 - c_a4;
    const Scalar z6 = v_a1 * c_a1;
    const Scalar z7 = v_a2 * c_a2;
    const Scalar z8 = v_a3 * c_a3;
    const Scalar z9 = v_a4 * c_a4;
    const Scalar z10 = v_a1 * s_a1;
    const Scalar z11 = v_a2 * s_a2;
    const Scalar z12 = v_a3 * s_a3;
    const Scalar z13 = v_a4 * s_a4;
    const Scalar z14 = s_a1 + z0;
    const Scalar z15 = z6 - z7;
    const Scalar z16 = z10 - z11;
    const Scalar z17 = v_a1 * z10;
    const Scalar z18 = v_a2 * z11;
    const Scalar z19 = v_a1 * z6;
    const Scalar z20 = v_a2 * z7;
    const Scalar z21 = z0 - z2;
    const Scalar z22 = z7 - z8;
    const Scalar z23 = z11 - z12;
    const Scalar z24 = v_a3 * z12;
    const Scalar z25 = v_a3 * z8;
    const Scalar z26 = z2 - z4;
    const Scalar z27 = z8 - z9;
    const Scalar z28 = z12 - z13;
    const Scalar z29 = z1 * z1 + z14 * z14;
    const Scalar z30 = n2 * (s_a1 * z1 - c_a1 * z14);
    const Scalar z31 = n2 * (s_a2 * z1 - c_a2 * z14);
    const Scalar z32 = n2 * (z14 * z15 - z1 * z16);
    const Scalar z33 = z17 - z18;
    const Scalar z34 = z19 - z20;
    const Scalar z35 = z3 * z3 + z21 * z21;
    const Scalar z36 = n2 * (s_a2 * z3 + c_a2 * z21);
    const Scalar z37 = n2 * (s_a3 * z3 + c_a3 * z21);
    const Scalar z38 = n2 * (z21 * z22 + z3 * z23);
    const Scalar z39 = z18 - z24;
    const Scalar z40 = z20 - z25;
    const Scalar z41 = z5 * z5 + z26 * z26;
    const Scalar z42 = n2 * (s_a3 * z5 + c_a3 * z26);
    const Scalar z43 = n2 * (s_a4 * z5 + c_a4 * z26);
    const Scalar z44 = n2 * (z26 * z27 + z5 * z28);
    const Scalar z45 = n2 * (z14 * z33 + z1 * z34 - z15 * z15 - z16 * z16);
    const Scalar z46 = n2 * (z22 * z22 + z23 * z23 + z21 * z39 - z3 * z40);
    const Scalar z47 = traits::sqrt(z29);
    const Scalar z48 = traits::sqrt(z35);
    const Scalar z49 = traits::sqrt(z41);
    const Scalar z50 = v_a4 * z13;
    const Scalar z51 = n0_1 - z47;
    const Scalar z52 = z24 - z50;
    const Scalar z53 = v_a4 * z9;
    const Scalar z54 = n0_5 * z30 / z47;
    const Scalar z55 = z25 - z53;
    const Scalar z56 = n2 * (z27 * z27 + z28 * z28 + z26 * z52 - z5 * z55);
    const Scalar z57 = n0_5 * z31 / z47;
    const Scalar z58 = n0_4 - s_a5;
    const Scalar z59 = c_a4 - c_a5;
    const Scalar z60 = z4 - z58;
    const Scalar z61 = z59 * z59 + z60 * z60;
    const Scalar z62 = n2 * (s_a4 * z59 + c_a4 * z60);
    const Scalar z63 = n0_5 * z36 / z48;
    const Scalar z64 = n0_5 * z37 / z48;
    const Scalar z65 = n0_5 * z32 / z47;
    const Scalar z66 = n0_5 * z42 / z49;
    const Scalar z67 = v_a5 * c_a5;
    const Scalar z68 = n0_5 * z43 / z49;
    const Scalar z69 = z9 - z67;
    const Scalar z70 = v_a5 * s_a5;
    const Scalar z71 = z13 - z70;
    const Scalar z72 = traits::sqrt(z61);
    const Scalar z73 = n0_1 - z48;
    const Scalar z74 = n0_1 - z49;
    const Scalar z75 = n0_5 * z38 / z48;
    const Scalar z76 = n2 * (z60 * z69 + z59 * z71);
    const Scalar z77 = n0_5 * z44 / z49;
    const Scalar z78 = n2 * (s_a5 * z59 + c_a5 * z60);
    const Scalar z79 = n0_5 * (z32 * z65 / (z47 * z47) + z45 / z47);
    const Scalar z80 = n0_5 * (z38 * z75 / (z48 * z48) - z46 / z48);
    const Scalar z81 = v_a5 * z70;
    const Scalar z82 = z50 - z81;
    const Scalar z83 = v_a5 * z67;
    const Scalar z84 = z53 - z83;
    const Scalar z85 = n0_5 * z76 / z72;
    const Scalar z86 = n0_5 * (z44 * z77 / (z49 * z49) - z56 / z49);
    const Scalar z87 = n2 * (z69 * z69 + z71 * z71 + z60 * z82 - z59 * z84);
    const Scalar z88 = n0_1 - z72;
    const Scalar z89 = n0_5 * z62 / z72;
    const Scalar z90 = n0_5 * z78 / z72;
    const Scalar z91 = n0_5 * (z76 * z85 / (z72 * z72) - z87 / z72);
    result.gap[0] = -z51;
    result.rate[0] = z65;
    result.drift[0] = -z79;
    result.gap[1] = -z73;
    result.rate[1] = -z75;
    result.drift[1] = -z80;
    result.gap[2] = -z74;
    result.rate[2] = -z77;
    result.drift[2] = -z86;
    result.gap[3] = -z88;
    result.rate[3] = -z85;
    result.drift[3] = -z91;
    result.jacobian[0] = -z54;
    result.jacobian[1] = n0;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = z57;
    result.jacobian[5] = -z63;
    result.jacobian[6] = n0;
    result.jacobian[7] = n0;
    result.jacobian[8] = n0;
    result.jacobian[9] = z64;
    result.jacobian[10] = -z66;
    result.jacobian[11] = n0;
    result.jacobian[12] = n0;
    result.jacobian[13] = n0;
    result.jacobian[14] = z68;
    result.jacobian[15] = -z89;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = z90;
  }

  /// What the surfaces of each contact are made of, in the order touch1, touch2, touch3, touch4:
  /// |T| <= f N + b while it slides, f_s and b_s while it sticks.
  TORSOR_DEVICE static void contact_coefficients(const Precomputed& precomputed, const State&,
      ContactCoefficients& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_e = precomputed.parameters.e;
    result.friction[0] = n0;
    result.static_friction[0] = n0;
    result.restitution[0] = p_e;
    result.bound[0] = n0;
    result.static_bound[0] = n0;
    result.friction[1] = n0;
    result.static_friction[1] = n0;
    result.restitution[1] = p_e;
    result.bound[1] = n0;
    result.static_bound[1] = n0;
    result.friction[2] = n0;
    result.static_friction[2] = n0;
    result.restitution[2] = p_e;
    result.bound[2] = n0;
    result.static_bound[2] = n0;
    result.friction[3] = n0;
    result.static_friction[3] = n0;
    result.restitution[3] = p_e;
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
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 25>&>(mass_matrix));
    visitor(Description::kernels[1], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[2], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[3], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[4], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace newton_cradle
