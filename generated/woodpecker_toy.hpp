// SPDX-License-Identifier: MIT-0
// woodpecker_toy: A woodpecker slides down its pole in jerks
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: f, e
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   4                6          0             0                  2       0     14      15
//   bias                          9               17          0             0                  2       0     30      30
//   energy                       15               28          0             0                  3       0     49      51
//   contacts                     39               58          0             0                  2       0    101     107
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 9 results 3 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   contacts: of 33 results 7 vanish identically
//   contact_coefficients: of 15 results 8 vanish identically, 5 repeat another up to sign
//
// To write this file again:
//   woodpecker_toy_scene generate --kernels mass_matrix,bias,energy,contacts,contact_coefficients --support torsor_support.hpp --output woodpecker_toy.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace woodpecker_toy {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"z", "m"}, {"phi", "rad"}, {"theta",
      "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"z", "m/s"}, {"phi", "rad/s"}, {"theta",
      "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"f", "1"}, {"e", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 14> results{{{"mass", "", 3, 3, 2, ""}, {"forces", "", 3, 1, 1,
      "N, N m, N m"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result",
      "power", 1, 1, 0, "W"}, {"result", "gap", 3, 1, 1, "m"}, {"result", "rate", 6, 1, 1, "m/s"}, {"result",
      "jacobian", 6, 3, 2, ""}, {"result", "drift", 6, 1, 1, "m/s^2"}, {"result", "friction", 3, 1, 1, "1"}, {"result",
      "static_friction", 3, 1, 1, "1"}, {"result", "restitution", 3, 1, 1, "1"}, {"result", "bound", 3, 1, 1, ""},
      {"result", "static_bound", 3, 1, 1, ""}}};
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
  using Description = ::woodpecker_toy::Description;

  static constexpr const char* name = "woodpecker_toy";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x36b0dff24279eb72ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 3;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar f;  ///< parameter [1]
    Scalar e;  ///< parameter [1]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::f, &Parameters::e};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar z;  ///< coordinate [m]
    Scalar phi;  ///< coordinate [rad]
    Scalar theta;  ///< coordinate [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::z, &Coordinates::phi, &Coordinates::theta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar z;  ///< its rate [m/s]
    Scalar phi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::z, &Velocities::phi, &Velocities::theta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar z;  ///< its second rate [m/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::z, &Accelerations::phi, &Accelerations::theta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar z;  ///< works with the rate of z [N]
    Scalar phi;  ///< works with the rate of phi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::z, &GeneralizedForces::phi,
          &GeneralizedForces::theta};
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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    parameters.f = n0_3;
    parameters.e = n0_5;
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
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar n0_34 = traits::constant(0.34, 0.34f, "17/50");
    const Scalar n7_4 = traits::constant(7.4, 7.4f, "37/5");
    state.time = n0;
    state.q.z = n0;
    state.q.phi = n0;
    state.q.theta = -n0_28;
    state.v.z = -n0_34;
    state.v.phi = n0;
    state.v.theta = -n7_4;
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
    std::array<Scalar, 3> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 6> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 18> jacobian;  ///< J, stored column by column (6 x 3)
    std::array<Scalar, 6> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 3;
  static constexpr int contact_row_count = 6;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[3] = {1, 1, 1};
  static constexpr int contact_tangents[3] = {1, 1, 1};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 3> friction;  ///< f [1]
    std::array<Scalar, 3> static_friction;  ///< f_s [1]
    std::array<Scalar, 3> restitution;  ///< e [1]
    std::array<Scalar, 3> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 3> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 9>& mass) noexcept {
    const Scalar k0 = traits::constant(6.75e-05, 6.75e-05f, "27/400000");
    const Scalar k1 = traits::constant(4.5e-05, 4.5e-05f, "9/200000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_0048 = traits::constant(0.0048, 0.0048f, "3/625");
    const Scalar k4 = traits::constant(4.55e-07, 4.55e-07f, "91/200000000");
    const Scalar k5 = traits::constant(1.7125e-06, 1.7125e-06f, "137/80000000");
    const Scalar q_phi = state.q.phi;
    const Scalar q_theta = state.q.theta;
    const Scalar z0 = q_phi - q_theta;
    const Scalar angles_[] = {q_phi, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = k0 * z2;
    const Scalar z4 = k0 * z1;
    const Scalar z5 = s_phi * z4 + c_phi * z3;
    const Scalar z6 = k1 + z3;
    const Scalar z7 = n0_01 * z3;
    const Scalar z8 = c_phi * (z3 - z6);
    mass[0] = n0_0048;
    mass[1] = -z8;
    mass[2] = z5;
    mass[3] = -z8;
    mass[4] = k4;
    mass[5] = z7;
    mass[6] = z5;
    mass[7] = z7;
    mass[8] = k5;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_0056 = traits::constant(0.0056, 0.0056f, "7/1250");
    const Scalar k2 = traits::constant(6.75e-05, 6.75e-05f, "27/400000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar k4 = traits::constant(4.5e-05, 4.5e-05f, "9/200000");
    const Scalar k5 = traits::constant(0.047088, 0.047088f, "2943/62500");
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar z0 = q_phi - q_theta;
    const Scalar angles_[] = {q_phi, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = v_theta * v_theta;
    const Scalar z4 = n9_81 * s_phi;
    const Scalar z5 = v_phi * v_phi;
    const Scalar z6 = n9_81 * c_phi;
    const Scalar z7 = n0_0056 * z0;
    const Scalar z8 = k2 * z3;  // force on bird, x
    const Scalar z9 = z2 * z8;
    const Scalar z10 = z1 * z8;
    const Scalar z11 = z4 - n0_01 * z5;
    const Scalar z12 = k4 * z5 + z9;  // force on sleeve, x
    const Scalar z13 = z7 + k4 * z6 + n0_01 * z10;
    const Scalar z14 = z2 * z6 + z1 * z11;
    const Scalar z15 = s_phi * z12 - c_phi * z10;
    const Scalar z16 = k2 * z14;  // moment on bird, y
    const Scalar z17 = z7 - z16;
    const Scalar z18 = k5 - z15;  // force on slide, z
    forces.z = z18;
    forces.phi = z13;
    forces.theta = -z17;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar k1 = traits::constant(6.75e-05, 6.75e-05f, "27/400000");
    const Scalar n0_0045 = traits::constant(0.0045, 0.0045f, "9/2000");
    const Scalar k3 = traits::constant(1.7125e-06, 1.7125e-06f, "137/80000000");
    const Scalar k4 = traits::constant(2.5e-09, 2.5e-09f, "1/400000000");
    const Scalar k5 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar k6 = traits::constant(0.00225, 0.00225f, "9/4000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k8 = traits::constant(0.002943, 0.002943f, "2943/1000000");
    const Scalar n0_0028 = traits::constant(0.0028, 0.0028f, "7/2500");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k11 = traits::constant(0.044145, 0.044145f, "8829/200000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar z0 = q_phi - q_theta;
    const Scalar angles_[] = {q_phi, z0, q_theta};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar s_theta = sines_[2];
    const Scalar z3 = v_z * c_phi;
    const Scalar z4 = v_z * s_phi;
    const Scalar z5 = n0_01 * s_phi;
    const Scalar z6 = k1 * s_theta;
    const Scalar z7 = n0_01 * v_phi + z3;
    const Scalar z8 = q_z + z5;
    const Scalar z9 = z1 * z7 - z2 * z4;
    const Scalar z10 = z1 * z4 + z2 * z7;
    const Scalar z11 = k1 * v_theta + n0_0045 * z10;
    const Scalar z12 = k3 * v_theta + k1 * z10;
    result.kinetic = k4 * v_phi * v_phi + k5 * (z4 * z4 + z3 * z3) + k6 * z9 * z9 + n0_5 * (v_theta * z12 + z10 * z11);
    result.force_function = -k8 * q_z - n0_0028 * z0 * z0 - n9_81 * z6 - k11 * z8;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Contacts that open and close, in the order peck, low, high.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n0_0051 = traits::constant(0.0051, 0.0051f, "51/10000");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_0058 = traits::constant(0.0058, 0.0058f, "29/5000");
    const Scalar n0_01 = traits::constant(0.01, 0.01f, "1/100");
    const Scalar n0_0031 = traits::constant(0.0031, 0.0031f, "31/10000");
    const Scalar n0_0025 = traits::constant(0.0025, 0.0025f, "1/400");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_z = state.v.z;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar z0 = q_phi - q_theta;
    const Scalar angles_[] = {q_phi, z0};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_phi = sines_[0], c_phi = cosines_[0];
    const Scalar z1 = sines_[1], z2 = cosines_[1];
    const Scalar z3 = v_phi - v_theta;
    const Scalar z4 = n0_0051 * z1 + n0_02 * z2;
    const Scalar z5 = v_phi * c_phi;
    const Scalar z6 = v_phi * s_phi;
    const Scalar z7 = z2 * z3;
    const Scalar z8 = z1 * z3;
    const Scalar z9 = n0_02 * z1 - n0_0051 * z2;
    const Scalar z10 = n0_0058 * s_phi;
    const Scalar z11 = n0_01 * c_phi;
    const Scalar z12 = n0_0031 * s_phi;
    const Scalar z13 = v_phi * z6;
    const Scalar z14 = v_phi * z5;
    const Scalar z15 = n0_01 * z6;
    const Scalar z16 = n0_0031 * c_phi + z10;
    const Scalar z17 = n0_0058 * c_phi - z12;
    const Scalar z18 = n0_0058 * z5;
    const Scalar z19 = n0_0031 * c_phi - z10;
    const Scalar z20 = n0_0058 * c_phi + z12;
    const Scalar z21 = n0_0051 * z7 - n0_02 * z8;
    const Scalar z22 = n0_02 * z7 + n0_0051 * z8;
    const Scalar z23 = z3 * z8;
    const Scalar z24 = z3 * z7;
    const Scalar z25 = n0_0031 * z6 - z18;
    const Scalar z26 = n0_0058 * z13;
    const Scalar z27 = n0_0031 * z6 + z18;
    const Scalar z28 = n0_0025 - z16;
    const Scalar z29 = v_z + v_phi * z16;
    const Scalar z30 = n0_0025 - z19;
    const Scalar z31 = v_z + v_phi * z19;
    const Scalar z32 = n0_0051 * z23 + n0_02 * z24;
    const Scalar z33 = n0_02 * z23 - n0_0051 * z24;
    const Scalar z34 = n0_0031 * z14 + z26;
    const Scalar z35 = n0_0031 * z14 - z26;
    const Scalar z36 = n0_01 + z9;
    const Scalar z37 = s_phi * z9 + c_phi * z4;
    const Scalar z38 = v_phi * z25;
    const Scalar z39 = v_phi * z27;
    const Scalar z40 = s_phi * z4 - c_phi * z36;
    const Scalar z41 = s_phi * (z9 - z36);
    const Scalar z42 = z4 * z5 + s_phi * z21 - c_phi * z22 + z36 * z6;
    const Scalar z43 = z4 * z13 - z36 * z14 + s_phi * z32 - c_phi * z33 - n2 * (z5 * z21 + z6 * z22);
    const Scalar z44 = n0_0025 + z40;
    const Scalar z45 = z40 + z11;
    const Scalar z46 = v_z - v_phi * z40 + z3 * z45;
    const Scalar z47 = z40 - z45;
    const Scalar z48 = z42 - z15;
    const Scalar z49 = v_phi * z42 - z3 * z48;
    result.gap[0] = -z44;
    result.rate[0] = -z42;
    result.drift[0] = z43;
    result.rate[1] = -z46;
    result.drift[1] = z49;
    result.gap[1] = -z28;
    result.rate[2] = -z25;
    result.drift[2] = -z34;
    result.rate[3] = -z29;
    result.drift[3] = z38;
    result.gap[2] = -z30;
    result.rate[4] = -z27;
    result.drift[4] = -z35;
    result.rate[5] = -z31;
    result.drift[5] = z39;
    result.jacobian[0] = n0;
    result.jacobian[1] = -n1;
    result.jacobian[2] = n0;
    result.jacobian[3] = -n1;
    result.jacobian[4] = n0;
    result.jacobian[5] = -n1;
    result.jacobian[6] = z41;
    result.jacobian[7] = z47;
    result.jacobian[8] = z17;
    result.jacobian[9] = -z16;
    result.jacobian[10] = -z20;
    result.jacobian[11] = -z19;
    result.jacobian[12] = -z37;
    result.jacobian[13] = z45;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
  }

  /// What the surfaces of each contact are made of, in the order peck, low, high:
  /// |T| <= f N + b while it slides, f_s and b_s while it sticks.
  TORSOR_DEVICE static void contact_coefficients(const Precomputed& precomputed, const State&,
      ContactCoefficients& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_f = precomputed.parameters.f;
    const Scalar p_e = precomputed.parameters.e;
    result.friction[0] = p_f;
    result.static_friction[0] = p_f;
    result.restitution[0] = p_e;
    result.bound[0] = n0;
    result.static_bound[0] = n0;
    result.friction[1] = p_f;
    result.static_friction[1] = p_f;
    result.restitution[1] = n0;
    result.bound[1] = n0;
    result.static_bound[1] = n0;
    result.friction[2] = p_f;
    result.static_friction[2] = p_f;
    result.restitution[2] = n0;
    result.bound[2] = n0;
    result.static_bound[2] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 9>&>(mass_matrix));
    visitor(Description::kernels[1], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[2], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[3], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[4], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace woodpecker_toy
