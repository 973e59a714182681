// SPDX-License-Identifier: MIT-0
// tumbler_rough_table: Tumbler on a table whose friction may not suffice
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: f
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   1                3          0             0                  1       0      6       6
//   bias                          4               15          0             0                  1       0     21      21
//   energy                       14               28          0             0                  3       0     48      51
//   contacts                     28               52          0             0                  2       0     84      84
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 36 results 28 vanish identically, 1 repeat another up to sign
//   bias: of 6 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   contacts: of 25 results 8 vanish identically
//   contact_coefficients: of 5 results 3 vanish identically, 1 repeat another up to sign
//
// To write this file again:
//   tumbler_rough_table_scene generate --kernels mass_matrix,bias,energy,contacts,contact_coefficients --support torsor_support.hpp --output tumbler_rough_table.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace tumbler_rough_table {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 6> coordinates{{{"x", "m"}, {"y", "m"}, {"z", "m"}, {"psi",
      "rad"}, {"theta", "rad"}, {"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 6> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"},
      {"psi", "rad/s"}, {"theta", "rad/s"}, {"phi", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 1> parameters{{{"f", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 14> results{{{"mass", "", 6, 6, 2, ""}, {"forces", "", 6, 1, 1,
      "0, 0, N, N m, N m, N m"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"},
      {"result", "power", 1, 1, 0, "W"}, {"result", "gap", 1, 1, 1, "m"}, {"result", "rate", 3, 1, 1, "m/s"}, {"result",
      "jacobian", 3, 6, 2, ""}, {"result", "drift", 3, 1, 1, "m/s^2"}, {"result", "friction", 1, 1, 1, "1"}, {"result",
      "static_friction", 1, 1, 1, "1"}, {"result", "restitution", 1, 1, 1, "1"}, {"result", "bound", 1, 1, 1, ""},
      {"result", "static_bound", 1, 1, 1, ""}}};
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
  using Description = ::tumbler_rough_table::Description;

  static constexpr const char* name = "tumbler_rough_table";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x338b7af28ac503bcULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 1;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar f;  ///< parameter [1]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::f};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar psi;  ///< coordinate [rad]
    Scalar theta;  ///< coordinate [rad]
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::z, &Coordinates::psi,
          &Coordinates::theta, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::z, &Velocities::psi,
          &Velocities::theta, &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::z,
          &Accelerations::psi, &Accelerations::theta, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::z, &GeneralizedForces::psi, &GeneralizedForces::theta, &GeneralizedForces::phi};
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
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    parameters.f = n0_5;
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
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar z0 = n1;
    const Scalar z1 = traits::formula(0.8414709848078965, 0.84147096f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.5403023058681398, 0.5403023f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0_02 * z1;
    state.q.z = n0_05 - n0_02 * z2;
    state.q.psi = n0;
    state.q.theta = n1;
    state.q.phi = n0;
    state.v.x = -n0_25 * z1;
    state.v.y = n0;
    state.v.z = n0;
    state.v.psi = n5;
    state.v.theta = n0;
    state.v.phi = n3;
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
    std::array<Scalar, 1> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 3> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 18> jacobian;  ///< J, stored column by column (3 x 6)
    std::array<Scalar, 3> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 1;
  static constexpr int contact_row_count = 3;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[1] = {1};
  static constexpr int contact_tangents[1] = {2};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 1> friction;  ///< f [1]
    std::array<Scalar, 1> static_friction;  ///< f_s [1]
    std::array<Scalar, 1> restitution;  ///< e [1]
    std::array<Scalar, 1> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 1> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 36>& mass) noexcept {
    const Scalar k0 = traits::constant(5e-05, 5e-05f, "1/20000");
    const Scalar k1 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar q_theta = state.q.theta;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = k0 * s_theta;
    const Scalar z1 = k1 * c_theta;
    const Scalar z2 = k1 + s_theta * z0;
    mass[0] = n0_2;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0_2;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0_2;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = z2;
    mass[22] = n0;
    mass[23] = z1;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = n0_0002;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = z1;
    mass[34] = n0;
    mass[35] = k1;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar k0 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_0002 = traits::constant(2e-04, 2e-04f, "1/5000");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1_962 = traits::constant(1.962, 1.962f, "981/500");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_psi * c_theta;
    const Scalar z1 = v_psi * s_theta;
    const Scalar z2 = v_theta * z0;  // angular acceleration of tumbler.2, y
    const Scalar z3 = v_theta * z1;  // angular acceleration of tumbler.2, z
    const Scalar z4 = v_phi + z0;  // angular velocity of tumbler, z
    const Scalar z5 = z1 * z0;
    const Scalar z6 = z1 * z4;
    const Scalar z7 = v_theta * z4;
    const Scalar z8 = k0 * z3;  // moment on tumbler, z
    const Scalar z9 = n2 * z2;
    const Scalar z10 = k0 * z6;  // moment on tumbler, x
    const Scalar z11 = k0 * z7;  // moment on tumbler, y
    const Scalar z12 = z10 - n0_0002 * z5;  // moment on tumbler.2, x
    const Scalar z13 = z11 - n0_0002 * z9;  // moment on tumbler.2, y
    const Scalar z14 = c_theta * z8 + s_theta * z13;
    forces.x = n0;
    forces.y = n0;
    forces.z = n1_962;
    forces.psi = -z14;
    forces.theta = z12;
    forces.phi = -z8;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar k0 = traits::constant(7.5e-05, 7.5e-05f, "3/40000");
    const Scalar n0_0001 = traits::constant(1e-04, 1e-04f, "1/10000");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1_962 = traits::constant(1.962, 1.962f, "981/500");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = v_x * s_psi - v_y * c_psi;
    const Scalar z1 = v_x * c_psi + v_y * s_psi;
    const Scalar z2 = v_psi * s_theta;
    const Scalar z3 = v_psi * c_theta;
    const Scalar z4 = v_theta * c_phi + s_phi * z2;
    const Scalar z5 = v_theta * s_phi - c_phi * z2;
    const Scalar z6 = v_phi + z3;  // angular velocity of tumbler, z
    const Scalar z7 = v_z * s_theta - c_theta * z0;
    const Scalar z8 = v_z * c_theta + s_theta * z0;
    const Scalar z9 = c_phi * z1 + s_phi * z7;
    const Scalar z10 = s_phi * z1 - c_phi * z7;
    result.kinetic = k0 * z6 * z6 + n0_0001 * (z4 * z4 + z5 * z5) + n0_1 * (z8 * z8 + z9 * z9 + z10 * z10);
    result.force_function = -n1_962 * q_z;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Contacts that open and close, in the order table.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n0_02 = traits::constant(0.02, 0.02f, "1/50");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = v_theta * s_theta;
    const Scalar z1 = v_theta * c_theta;
    const Scalar z2 = n0_02 * s_theta;
    const Scalar z3 = s_psi * s_theta;
    const Scalar z4 = c_psi * s_theta;
    const Scalar z5 = v_psi * c_psi;
    const Scalar z6 = v_psi * s_psi;
    const Scalar z7 = n0_02 * c_theta;
    const Scalar z8 = s_psi * z2;
    const Scalar z9 = c_psi * z2;
    const Scalar z10 = q_z + z7;
    const Scalar z11 = n0_02 * z0;
    const Scalar z12 = v_theta * z1;
    const Scalar z13 = n0_05 - z7;
    const Scalar z14 = n0_02 * z1;
    const Scalar z15 = c_psi * z1 - s_theta * z6;
    const Scalar z16 = s_psi * z1 + s_theta * z5;
    const Scalar z17 = n0_05 - z10;
    const Scalar z18 = v_z - z11;
    const Scalar z19 = n0_02 * z12;
    const Scalar z20 = s_psi * z13;
    const Scalar z21 = c_psi * z13;
    const Scalar z22 = c_theta * z9 + z13 * z4;
    const Scalar z23 = c_theta * z8 + z13 * z3;
    const Scalar z24 = c_psi * z14 - z2 * z6;
    const Scalar z25 = s_psi * z11 + z13 * z5;
    const Scalar z26 = z2 * z5 + s_psi * z14;
    const Scalar z27 = c_psi * z11 - z13 * z6;
    const Scalar z28 = z11 * z3 - z8 * z0 + c_theta * z26 + z13 * z16;
    const Scalar z29 = v_x + v_psi * z9 - v_theta * z20 + v_phi * z22;
    const Scalar z30 = v_y + v_psi * z8 + v_theta * z21 + v_phi * z23;
    const Scalar z31 = z11 * z4 - z9 * z0 + z13 * z15 + c_theta * z24;
    const Scalar z32 = v_psi * z24 - v_theta * z25 + v_phi * z31;
    const Scalar z33 = v_psi * z26 + v_theta * z27 + v_phi * z28;
    result.gap[0] = -z17;
    result.rate[0] = z18;
    result.drift[0] = -z19;
    result.rate[1] = z29;
    result.drift[1] = z32;
    result.rate[2] = z30;
    result.drift[2] = z33;
    result.jacobian[0] = n0;
    result.jacobian[1] = n1;
    result.jacobian[2] = n0;
    result.jacobian[3] = n0;
    result.jacobian[4] = n0;
    result.jacobian[5] = n1;
    result.jacobian[6] = n1;
    result.jacobian[7] = n0;
    result.jacobian[8] = n0;
    result.jacobian[9] = n0;
    result.jacobian[10] = z9;
    result.jacobian[11] = z8;
    result.jacobian[12] = -z2;
    result.jacobian[13] = -z20;
    result.jacobian[14] = z21;
    result.jacobian[15] = n0;
    result.jacobian[16] = z22;
    result.jacobian[17] = z23;
  }

  /// What the surfaces of each contact are made of, in the order table:
  /// |T| <= f N + b while it slides, f_s and b_s while it sticks.
  TORSOR_DEVICE static void contact_coefficients(const Precomputed& precomputed, const State&,
      ContactCoefficients& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar p_f = precomputed.parameters.f;
    result.friction[0] = p_f;
    result.static_friction[0] = p_f;
    result.restitution[0] = n0;
    result.bound[0] = n0;
    result.static_bound[0] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 36>&>(mass_matrix));
    visitor(Description::kernels[1], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[2], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[3], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[4], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace tumbler_rough_table
