// SPDX-License-Identifier: MIT-0
// rimless_wheel: Rimless wheel that walks down a slope
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: slope, f
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                    0                4          0             0                  1       0      6       -
//   mass_matrix                   0                0          0             0                  0       0      0       0
//   bias                          0                0          0             0                  0       0      0       6
//   energy                        5               11          0             0                  1       0     18      21
//   contacts                     26               24          0             0                  1       0     52      56
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 9 results 6 vanish identically
//   bias: of 3 results 1 vanish identically
//   energy: of 3 results 1 vanish identically
//   contacts: of 66 results 12 vanish identically, 12 repeat another up to sign
//   contact_coefficients: of 30 results 18 vanish identically, 11 repeat another up to sign
//
// To write this file again:
//   rimless_wheel_scene generate --kernels mass_matrix,bias,energy,contacts,contact_coefficients --support torsor_support.hpp --output rimless_wheel.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace rimless_wheel {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 3> coordinates{{{"x", "m"}, {"z", "m"}, {"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 3> velocities{{{"x", "m/s"}, {"z", "m/s"}, {"phi",
      "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"slope", "rad"}, {"f", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 14> results{{{"mass", "", 3, 3, 2, ""}, {"forces", "", 3, 1, 1,
      "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1,
      0, "W"}, {"result", "gap", 6, 1, 1, "m"}, {"result", "rate", 12, 1, 1, "m/s"}, {"result", "jacobian", 12, 3, 2,
      ""}, {"result", "drift", 12, 1, 1, "m/s^2"}, {"result", "friction", 6, 1, 1, "1"}, {"result", "static_friction",
      6, 1, 1, "1"}, {"result", "restitution", 6, 1, 1, "1"}, {"result", "bound", 6, 1, 1, ""}, {"result",
      "static_bound", 6, 1, 1, ""}}};
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
  using Description = ::rimless_wheel::Description;

  static constexpr const char* name = "rimless_wheel";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x6fb48882ad089b39ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 3;
  static constexpr int velocity_count = 3;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar slope;  ///< parameter [rad]
    Scalar f;  ///< parameter [1]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::slope, &Parameters::f};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::z, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::z, &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::z, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::z,
          &GeneralizedForces::phi};
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
    Scalar m_09cbdff6;  ///< force on lift, x
    Scalar m_59c46082;  ///< force on lift, z
    Scalar m_5497d850;
    Scalar m_0d85e50a;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    parameters.slope = n0_15;
    parameters.f = n1;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_slope = parameters.slope;
    Scalar s_slope, c_slope;
    traits::sincos(p_slope, s_slope, c_slope);
    const Scalar z0 = n9_81 * s_slope;
    const Scalar z1 = n9_81 * c_slope;
    const Scalar z2 = n2 * z0;  // force on lift, x
    const Scalar z3 = n2 * z1;  // force on lift, z
    precomputed.m_09cbdff6 = z2;
    precomputed.m_59c46082 = z3;
    precomputed.m_5497d850 = s_slope;
    precomputed.m_0d85e50a = c_slope;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar k1 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    state.time = n0;
    state.q.x = n0;
    state.q.z = k1;
    state.q.phi = n0;
    state.v.x = k1;
    state.v.z = n0_5;
    state.v.phi = n1;
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
    std::array<Scalar, 6> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 12> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 36> jacobian;  ///< J, stored column by column (12 x 3)
    std::array<Scalar, 12> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 6;
  static constexpr int contact_row_count = 12;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[6] = {1, 1, 1, 1, 1, 1};
  static constexpr int contact_tangents[6] = {1, 1, 1, 1, 1, 1};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 6> friction;  ///< f [1]
    std::array<Scalar, 6> static_friction;  ///< f_s [1]
    std::array<Scalar, 6> restitution;  ///< e [1]
    std::array<Scalar, 6> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 6> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State&, std::array<Scalar, 9>& mass) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    mass[0] = n2;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n2;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n0;
    mass[8] = n0_5;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State&, GeneralizedForces& forces) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar m0 = precomputed.m_09cbdff6;
    const Scalar m1 = precomputed.m_59c46082;
    forces.x = -m0;
    forces.z = m1;
    forces.phi = n0;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n0_25 = traits::constant(0.25, 0.25f, "1/4");
    const Scalar n19_62 = traits::constant(19.62, 19.62f, "981/50");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar s_slope = precomputed.m_5497d850;
    const Scalar c_slope = precomputed.m_0d85e50a;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_x * c_phi - v_z * s_phi;
    const Scalar z1 = v_x * s_phi + v_z * c_phi;
    result.kinetic = n0_25 * v_phi * v_phi + z0 * z0 + z1 * z1;
    result.force_function = n19_62 * (q_x * s_slope - q_z * c_slope);
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Contacts that open and close, in the order step1, step2, step3, step4, step5, step6.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar k1 = traits::constant(0.8660254037844386, 0.8660254f, "0;0;1/2;0");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    Scalar s_phi, c_phi;
    traits::sincos(q_phi, s_phi, c_phi);
    const Scalar z0 = v_phi * c_phi;
    const Scalar z1 = v_phi * s_phi;
    const Scalar z2 = n0_5 * s_phi;
    const Scalar z3 = k1 * s_phi;
    const Scalar z4 = q_z + s_phi;
    const Scalar z5 = v_x + v_phi * s_phi;
    const Scalar z6 = q_z - s_phi;
    const Scalar z7 = v_x - v_phi * s_phi;
    const Scalar z8 = n0_5 * c_phi + z3;
    const Scalar z9 = k1 * c_phi - z2;
    const Scalar z10 = n0_5 * z0;
    const Scalar z11 = v_phi * z1;
    const Scalar z12 = v_phi * z0;
    const Scalar z13 = v_z + z0;
    const Scalar z14 = n0_5 * c_phi - z3;
    const Scalar z15 = k1 * c_phi + z2;
    const Scalar z16 = v_z - z0;
    const Scalar z17 = k1 * z1 + z10;
    const Scalar z18 = n0_5 * z11;
    const Scalar z19 = k1 * z1 - z10;
    const Scalar z20 = q_z - z9;
    const Scalar z21 = v_x - v_phi * z9;
    const Scalar z22 = q_z + z15;
    const Scalar z23 = v_x + v_phi * z15;
    const Scalar z24 = q_z + z9;
    const Scalar z25 = v_x + v_phi * z9;
    const Scalar z26 = q_z - z15;
    const Scalar z27 = v_x - v_phi * z15;
    const Scalar z28 = k1 * z12 - z18;
    const Scalar z29 = k1 * z12 + z18;
    const Scalar z30 = v_z + z17;
    const Scalar z31 = v_phi * z17;
    const Scalar z32 = v_z - z19;
    const Scalar z33 = v_phi * z19;
    const Scalar z34 = v_z - z17;
    const Scalar z35 = v_z + z19;
    result.gap[0] = z20;
    result.rate[0] = z30;
    result.drift[0] = z28;
    result.rate[1] = z21;
    result.drift[1] = z31;
    result.gap[1] = z4;
    result.rate[2] = z13;
    result.drift[2] = -z11;
    result.rate[3] = z5;
    result.drift[3] = z12;
    result.gap[2] = z22;
    result.rate[4] = z32;
    result.drift[4] = -z29;
    result.rate[5] = z23;
    result.drift[5] = -z33;
    result.gap[3] = z24;
    result.rate[6] = z34;
    result.drift[6] = -z28;
    result.rate[7] = z25;
    result.drift[7] = -z31;
    result.gap[4] = z6;
    result.rate[8] = z16;
    result.drift[8] = z11;
    result.rate[9] = z7;
    result.drift[9] = -z12;
    result.gap[5] = z26;
    result.rate[10] = z35;
    result.drift[10] = z29;
    result.rate[11] = z27;
    result.drift[11] = z33;
    result.jacobian[0] = n0;
    result.jacobian[1] = n1;
    result.jacobian[2] = n0;
    result.jacobian[3] = n1;
    result.jacobian[4] = n0;
    result.jacobian[5] = n1;
    result.jacobian[6] = n0;
    result.jacobian[7] = n1;
    result.jacobian[8] = n0;
    result.jacobian[9] = n1;
    result.jacobian[10] = n0;
    result.jacobian[11] = n1;
    result.jacobian[12] = n1;
    result.jacobian[13] = n0;
    result.jacobian[14] = n1;
    result.jacobian[15] = n0;
    result.jacobian[16] = n1;
    result.jacobian[17] = n0;
    result.jacobian[18] = n1;
    result.jacobian[19] = n0;
    result.jacobian[20] = n1;
    result.jacobian[21] = n0;
    result.jacobian[22] = n1;
    result.jacobian[23] = n0;
    result.jacobian[24] = z8;
    result.jacobian[25] = -z9;
    result.jacobian[26] = c_phi;
    result.jacobian[27] = s_phi;
    result.jacobian[28] = z14;
    result.jacobian[29] = z15;
    result.jacobian[30] = -z8;
    result.jacobian[31] = z9;
    result.jacobian[32] = -c_phi;
    result.jacobian[33] = -s_phi;
    result.jacobian[34] = -z14;
    result.jacobian[35] = -z15;
  }

  /// What the surfaces of each contact are made of, in the order step1, step2, step3, step4, step5, step6:
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
    result.friction[3] = p_f;
    result.static_friction[3] = p_f;
    result.restitution[3] = n0;
    result.bound[3] = n0;
    result.static_bound[3] = n0;
    result.friction[4] = p_f;
    result.static_friction[4] = p_f;
    result.restitution[4] = n0;
    result.bound[4] = n0;
    result.static_bound[4] = n0;
    result.friction[5] = p_f;
    result.static_friction[5] = p_f;
    result.restitution[5] = n0;
    result.bound[5] = n0;
    result.static_bound[5] = n0;
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

}  // namespace rimless_wheel
