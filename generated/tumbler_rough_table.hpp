// SPDX-License-Identifier: MIT
// tumbler_rough_table: Tumbler on a table whose friction may not suffice
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: f
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix                   1                9          0             0                  2       0     14      14
//   bias                         11               30          0             0                  2       0     45      45
//   energy                       19               38          0             0                  3       0     63      66
//   contacts                      9               25          0             0                  2       0     38      38
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 36 results 18 vanish identically, 6 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   contacts: of 25 results 12 vanish identically
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
  static constexpr std::array<torsor::ResultDescription, 14> results{{{"mass", "", 6, 6}, {"forces", "", 6, 1},
      {"result", "kinetic", 1, 1}, {"result", "force_function", 1, 1}, {"result", "power", 1, 1}, {"result", "gap", 1,
      1}, {"result", "rate", 3, 1}, {"result", "jacobian", 3, 6}, {"result", "drift", 3, 1}, {"result", "friction", 1,
      1}, {"result", "static_friction", 1, 1}, {"result", "restitution", 1, 1}, {"result", "bound", 1, 1}, {"result",
      "static_bound", 1, 1}}};
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
  static constexpr unsigned long long fingerprint = 0x8d63761490924a7fULL ^ torsor::support_fingerprint;
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
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n5 = traits::constant(5.0, 5.0f, "5/1");
    const Scalar n3 = traits::constant(3.0, 3.0f, "3/1");
    const Scalar z0 = n1;
    const Scalar z1 = traits::formula(0.8414709848078965, 0.84147096f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.z = n0_05;
    state.q.psi = n0;
    state.q.theta = n1;
    state.q.phi = n0;
    state.v.x = -n0_15 * z1;
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
  static constexpr int contact_normals[] = {1};
  static constexpr int contact_tangents[] = {2};

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
    const Scalar k0 = traits::constant(0.00013, 0.00013f, "13/100000");
    const Scalar n0_004 = traits::constant(0.004, 0.004f, "1/250");
    const Scalar k2 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k5 = traits::constant(0.00028, 0.00028f, "7/25000");
    const Scalar q_psi = state.q.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = k0 * s_theta;
    const Scalar z1 = n0_004 * c_theta;
    const Scalar z2 = n0_004 * s_theta;
    const Scalar z3 = k2 * c_theta;
    const Scalar z4 = s_psi * z1;
    const Scalar z5 = c_psi * z1;
    const Scalar z6 = k2 + s_theta * z0;
    const Scalar z7 = c_psi * z2;
    const Scalar z8 = s_psi * z2;
    mass[0] = n0_2;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = -z7;
    mass[4] = -z4;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0_2;
    mass[8] = n0;
    mass[9] = -z8;
    mass[10] = z5;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n0_2;
    mass[15] = n0;
    mass[16] = z2;
    mass[17] = n0;
    mass[18] = -z7;
    mass[19] = -z8;
    mass[20] = n0;
    mass[21] = z6;
    mass[22] = n0;
    mass[23] = z3;
    mass[24] = -z4;
    mass[25] = z5;
    mass[26] = z2;
    mass[27] = n0;
    mass[28] = k5;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = z3;
    mass[34] = n0;
    mass[35] = k2;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed&, const State& state, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k1 = traits::constant(0.00015, 0.00015f, "3/20000");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_004 = traits::constant(0.004, 0.004f, "1/250");
    const Scalar k4 = traits::constant(0.00028, 0.00028f, "7/25000");
    const Scalar n1_962 = traits::constant(1.962, 1.962f, "981/500");
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
    const Scalar z0 = v_psi * s_theta;
    const Scalar z1 = v_psi * c_theta;
    const Scalar z2 = v_theta * v_theta;
    const Scalar z3 = n9_81 * s_theta;
    const Scalar z4 = v_theta * z1;  // angular acceleration of tumbler.2, y
    const Scalar z5 = v_theta * z0;  // angular acceleration of tumbler.2, z
    const Scalar z6 = v_phi + z1;  // angular velocity of tumbler, z
    const Scalar z7 = z0 * z1;
    const Scalar z8 = z0 * z0;
    const Scalar z9 = z0 * z6;
    const Scalar z10 = v_theta * z6;
    const Scalar z11 = k1 * z5;  // moment on tumbler, z
    const Scalar z12 = n2 * z4;
    const Scalar z13 = z2 + z8;
    const Scalar z14 = n0_004 * z7;  // force on tumbler.2, y
    const Scalar z15 = k1 * z9;  // moment on tumbler, x
    const Scalar z16 = k1 * z10;  // moment on tumbler, y
    const Scalar z17 = n0_004 * z12;  // force on tumbler.2, x
    const Scalar z18 = n0_004 * z13;  // force on tumbler.2, z
    const Scalar z19 = n0_004 * z3 + z15 - k4 * z7;  // moment on tumbler.2, x
    const Scalar z20 = z16 - k4 * z12;  // moment on tumbler.2, y
    const Scalar z21 = c_theta * z14 + s_theta * z18;
    const Scalar z22 = s_theta * z14 - c_theta * z18;
    const Scalar z23 = c_theta * z11 + s_theta * z20;
    const Scalar z24 = s_psi * z21 - c_psi * z17;
    const Scalar z25 = s_psi * z17 + c_psi * z21;
    const Scalar z26 = n1_962 - z22;  // force on tumbler.z, z
    forces.x = z24;
    forces.y = -z25;
    forces.z = z26;
    forces.psi = -z23;
    forces.theta = z19;
    forces.phi = -z11;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_004 = traits::constant(0.004, 0.004f, "1/250");
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar k2 = traits::constant(0.00028, 0.00028f, "7/25000");
    const Scalar k3 = traits::constant(7.5e-05, 7.5e-05f, "3/40000");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1_962 = traits::constant(1.962, 1.962f, "981/500");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
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
    const Scalar z4 = n0_004 * c_theta;
    const Scalar z5 = v_theta * c_phi + s_phi * z2;
    const Scalar z6 = v_theta * s_phi - c_phi * z2;
    const Scalar z7 = v_phi + z3;  // angular velocity of tumbler, z
    const Scalar z8 = v_z * s_theta - c_theta * z0;
    const Scalar z9 = v_z * c_theta + s_theta * z0;
    const Scalar z10 = c_phi * z1 + s_phi * z8;
    const Scalar z11 = s_phi * z1 - c_phi * z8;
    const Scalar z12 = n0_004 * z6 + n0_2 * z10;
    const Scalar z13 = n0_004 * z5 - n0_2 * z11;
    const Scalar z14 = k2 * z5 - n0_004 * z11;
    const Scalar z15 = k2 * z6 + n0_004 * z10;
    result.kinetic = k3 * z7 * z7 + n0_1 * z9 * z9 + n0_5 * (z5 * z14 + z6 * z15 + z10 * z12 - z11 * z13);
    result.force_function = -n1_962 * q_z + n9_81 * z4;
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
    const Scalar z0 = v_theta * c_theta;
    const Scalar z1 = v_psi * c_psi;
    const Scalar z2 = v_psi * s_psi;
    const Scalar z3 = n0_05 * s_psi;
    const Scalar z4 = n0_05 * c_psi;
    const Scalar z5 = s_psi * s_theta;
    const Scalar z6 = c_psi * s_theta;
    const Scalar z7 = n0_05 - q_z;
    const Scalar z8 = n0_05 * z6;
    const Scalar z9 = n0_05 * z5;
    const Scalar z10 = n0_05 * z1;
    const Scalar z11 = c_psi * z0 - s_theta * z2;
    const Scalar z12 = n0_05 * z2;
    const Scalar z13 = s_psi * z0 + s_theta * z1;
    const Scalar z14 = v_x - v_theta * z3 + v_phi * z8;
    const Scalar z15 = v_y + v_theta * z4 + v_phi * z9;
    const Scalar z16 = n0_05 * z11;
    const Scalar z17 = n0_05 * z13;
    const Scalar z18 = v_theta * z10 - v_phi * z16;
    const Scalar z19 = v_theta * z12 - v_phi * z17;
    result.gap[0] = -z7;
    result.rate[0] = v_z;
    result.drift[0] = n0;
    result.rate[1] = z14;
    result.drift[1] = -z18;
    result.rate[2] = z15;
    result.drift[2] = -z19;
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
    result.jacobian[10] = n0;
    result.jacobian[11] = n0;
    result.jacobian[12] = n0;
    result.jacobian[13] = -z3;
    result.jacobian[14] = z4;
    result.jacobian[15] = n0;
    result.jacobian[16] = z8;
    result.jacobian[17] = z9;
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
