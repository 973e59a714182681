// SPDX-License-Identifier: MIT-0
// clock_escapement: A weight, a wheel of pins, an anchor and a pendulum: a clock
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, bias, energy, contacts, contact_coefficients
// Parameters set at run time: weight, f
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function              additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                    1                5          0             0                  0       0      6       -
//   mass_matrix                   0                0          0             0                  0       0      0       3
//   bias                          1                3          0             0                  1       0      6       8
//   energy                        5               13          0             0                  1       0     20      22
//   contacts                    722             1028        220            20                  2       0   1994    2220
//   contact_coefficients          0                0          0             0                  0       0      0       0
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 4 results 2 vanish identically
//   contact_coefficients: of 100 results 60 vanish identically, 39 repeat another up to sign
//
// To write this file again:
//   clock_escapement_scene generate --kernels mass_matrix,bias,energy,contacts,contact_coefficients --support torsor_support.hpp --output clock_escapement.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace clock_escapement {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 2> coordinates{{{"psi", "rad"}, {"theta", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> velocities{{{"psi", "rad/s"}, {"theta", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 0> multipliers{};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"weight", "kg"}, {"f", "1"}}};
  static constexpr std::array<torsor::ResultDescription, 14> results{{{"mass", "", 2, 2, 2, "kg m^2"}, {"forces", "", 2,
      1, 1, "N m"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power",
      1, 1, 0, "W"}, {"result", "gap", 20, 1, 1, "m"}, {"result", "rate", 40, 1, 1, "m/s"}, {"result", "jacobian", 40,
      2, 2, "m"}, {"result", "drift", 40, 1, 1, "m/s^2"}, {"result", "friction", 20, 1, 1, "1"}, {"result",
      "static_friction", 20, 1, 1, "1"}, {"result", "restitution", 20, 1, 1, "1"}, {"result", "bound", 20, 1, 1, ""},
      {"result", "static_bound", 20, 1, 1, ""}}};
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
  using Description = ::clock_escapement::Description;

  static constexpr const char* name = "clock_escapement";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x16240e40d54abd53ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 2;
  static constexpr int velocity_count = 2;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 0;
  static constexpr int first_integral_count = 0;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar weight;  ///< parameter [kg]
    Scalar f;  ///< parameter [1]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::weight, &Parameters::f};
      return members_[i_];
    }
  };

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar psi;  ///< coordinate [rad]
    Scalar theta;  ///< coordinate [rad]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::psi, &Coordinates::theta};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::psi, &Velocities::theta};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::psi, &Accelerations::theta};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::psi, &GeneralizedForces::theta};
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
    Scalar m_6d355c94;
    Scalar m_80db5a0a;
    Scalar m_53b8ac8e;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    parameters.weight = n0_1;
    parameters.f = n0_1;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n0_0015 = traits::constant(0.0015, 0.0015f, "3/2000");
    const Scalar k1 = traits::constant(5e-06, 5e-06f, "1/200000");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar p_weight = parameters.weight;
    const Scalar z0 = n0_0015 * p_weight;
    const Scalar z1 = k1 + n0_0015 * z0;
    const Scalar z2 = n9_81 * p_weight;  // force on hung, z
    const Scalar z3 = n0_0015 * z2;
    const Scalar z4 = n0_5 * p_weight;
    precomputed.m_6d355c94 = z1;
    precomputed.m_80db5a0a = z3;
    precomputed.m_53b8ac8e = z4;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1_over_36 = traits::constant(0.027777777777777776, 0.027777778f, "1/36");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar pi = traits::pi();
    state.time = n0;
    state.q.psi = -n1_over_36 * pi;
    state.q.theta = n0_12;
    state.v.psi = n0;
    state.v.theta = n0;
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
    std::array<Scalar, 20> gap;  ///< of each contact, falls to 0 where it closes; 0 of dry friction
    std::array<Scalar, 40> rate;  ///< w, of normals d(gap)/dt, of tangents the slip
    std::array<Scalar, 80> jacobian;  ///< J, stored column by column (40 x 2)
    std::array<Scalar, 40> drift;  ///< dw/dt at zero accelerations
  };
  /// Contacts, and their rows.
  static constexpr int contact_count = 20;
  static constexpr int contact_row_count = 40;
  /// How many normals and tangents each contact has: dry friction has no normal.
  static constexpr int contact_normals[20] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  static constexpr int contact_tangents[20] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

  /// Coefficients of contacts.
  struct ContactCoefficients {
    std::array<Scalar, 20> friction;  ///< f [1]
    std::array<Scalar, 20> static_friction;  ///< f_s [1]
    std::array<Scalar, 20> restitution;  ///< e [1]
    std::array<Scalar, 20> bound;  ///< b of dry friction, 0 of others
    std::array<Scalar, 20> static_bound;  ///< b_s of dry friction, 0 of others
  };

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State&,
      std::array<Scalar, 4>& mass) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n0_0125 = traits::constant(0.0125, 0.0125f, "1/80");
    const Scalar m0 = precomputed.m_6d355c94;
    mass[0] = m0;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0_0125;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_0015 = traits::constant(0.0015, 0.0015f, "3/2000");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar m0 = precomputed.m_80db5a0a;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = n9_81 * s_theta;
    const Scalar z1 = n0_0015 * v_theta;
    const Scalar z2 = n0_05 * z0;  // moment on anchor, y
    const Scalar z3 = z1 + z2;
    forces.psi = -m0;
    forces.theta = z3;
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n0_0015 = traits::constant(0.0015, 0.0015f, "3/2000");
    const Scalar n0_05 = traits::constant(0.05, 0.05f, "1/20");
    const Scalar k3 = traits::constant(2.5e-06, 2.5e-06f, "1/400000");
    const Scalar n1_over_160 = traits::constant(0.00625, 0.00625f, "1/160");
    const Scalar k5 = traits::constant(0.08324061028128038, 0.08324061f, "0;2943/50000;0;0");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar p_weight = precomputed.parameters.weight;
    const Scalar m0 = precomputed.m_53b8ac8e;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = n0_06 + n0_0015 * q_psi;
    const Scalar z1 = n0_0015 * v_psi;  // velocity of hung, z
    const Scalar z2 = n0_05 * c_theta;
    const Scalar z3 = n0_0015 * v_theta;
    result.kinetic = k3 * v_psi * v_psi + n1_over_160 * v_theta * v_theta + m0 * z1 * z1;
    result.force_function = -k5 + n9_81 * (p_weight * z0 + z2);
    result.power = -v_theta * z3;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// Contacts that open and close, in the order entry1, exit1, entry2, exit2, entry3, exit3, entry4, exit4, entry5, exit5, entry6, exit6, entry7, exit7, entry8, exit8, entry9, exit9, entry10, exit10.
  /// Rows are contact by contact, the normal first (n from the second body to the first, so that w > 0 opens), then
  /// the tangents: w = J v + b, dw/dt = J a + drift. M a + h = E u + A' lambda + J' r with the reactions r.
  TORSOR_DEVICE static void contacts(const Precomputed&, const State& state, Contacts& result) noexcept {
    const Scalar n0_2 = traits::constant(0.2, 0.2f, "1/5");
    const Scalar n0_4 = traits::constant(0.4, 0.4f, "2/5");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n1_4 = traits::constant(1.4, 1.4f, "7/5");
    const Scalar n1_6 = traits::constant(1.6, 1.6f, "8/5");
    const Scalar n1_8 = traits::constant(1.8, 1.8f, "9/5");
    const Scalar n0_03 = traits::constant(0.03, 0.03f, "3/100");
    const Scalar k9 = traits::constant(0.017960512242138307, 0.017960513f, "0;127/10000;0;0");
    const Scalar k10 = traits::constant(0.024465894629054543, 0.024465894f, "0;173/10000;0;0");
    const Scalar k11 = traits::constant(0.042426406871192854, 0.042426407f, "0;3/100;0;0");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_0066 = traits::constant(0.0066, 0.0066f, "33/5000");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_0016 = traits::constant(0.0016, 0.0016f, "1/625");
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.6283185307179586, 0.62831855f, [&]() -> Scalar {
      return n0_2 * pi;
    });
    const Scalar z1 = traits::formula(0.5877852522924731, 0.58778524f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.8090169943749475, 0.809017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(1.2566370614359172, 1.2566371f, [&]() -> Scalar {
      return n0_4 * pi;
    });
    const Scalar z4 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z3, sine, cosine);
      return sine;
    });
    const Scalar z5 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z3, sine, cosine);
      return cosine;
    });
    const Scalar z6 = traits::formula(1.8849555921538759, 1.8849556f, [&]() -> Scalar {
      return n0_6 * pi;
    });
    const Scalar z7 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z6, sine, cosine);
      return sine;
    });
    const Scalar z8 = traits::formula(-0.30901699437494745, -0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z6, sine, cosine);
      return cosine;
    });
    const Scalar z9 = traits::formula(2.5132741228718345, 2.5132742f, [&]() -> Scalar {
      return n0_8 * pi;
    });
    const Scalar z10 = traits::formula(0.5877852522924731, 0.58778524f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z9, sine, cosine);
      return sine;
    });
    const Scalar z11 = traits::formula(-0.8090169943749475, -0.809017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z9, sine, cosine);
      return cosine;
    });
    const Scalar z12 = traits::formula(3.7699111843077517, 3.7699113f, [&]() -> Scalar {
      return n1_2 * pi;
    });
    const Scalar z13 = traits::formula(-0.5877852522924731, -0.58778524f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z12, sine, cosine);
      return sine;
    });
    const Scalar z14 = traits::formula(-0.8090169943749475, -0.809017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z12, sine, cosine);
      return cosine;
    });
    const Scalar z15 = traits::formula(4.39822971502571, 4.3982296f, [&]() -> Scalar {
      return n1_4 * pi;
    });
    const Scalar z16 = traits::formula(-0.9510565162951535, -0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z15, sine, cosine);
      return sine;
    });
    const Scalar z17 = traits::formula(-0.30901699437494745, -0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z15, sine, cosine);
      return cosine;
    });
    const Scalar z18 = traits::formula(5.026548245743669, 5.0265484f, [&]() -> Scalar {
      return n1_6 * pi;
    });
    const Scalar z19 = traits::formula(-0.9510565162951535, -0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z18, sine, cosine);
      return sine;
    });
    const Scalar z20 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z18, sine, cosine);
      return cosine;
    });
    const Scalar z21 = traits::formula(5.654866776461628, 5.6548667f, [&]() -> Scalar {
      return n1_8 * pi;
    });
    const Scalar z22 = traits::formula(-0.5877852522924731, -0.58778524f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z21, sine, cosine);
      return sine;
    });
    const Scalar z23 = traits::formula(0.8090169943749475, 0.809017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z21, sine, cosine);
      return cosine;
    });
    const Scalar z24 = traits::formula(0.017633557568774196, 0.017633557f, [&]() -> Scalar {
      return n0_03 * z1;
    });
    const Scalar z25 = traits::formula(0.024270509831248423, 0.02427051f, [&]() -> Scalar {
      return n0_03 * z2;
    });
    const Scalar z26 = traits::formula(0.02853169548885461, 0.028531695f, [&]() -> Scalar {
      return n0_03 * z4;
    });
    const Scalar z27 = traits::formula(0.009270509831248422, 0.00927051f, [&]() -> Scalar {
      return n0_03 * z5;
    });
    const Scalar z28 = traits::formula(0.02853169548885461, 0.028531695f, [&]() -> Scalar {
      return n0_03 * z7;
    });
    const Scalar z29 = traits::formula(-0.009270509831248422, -0.00927051f, [&]() -> Scalar {
      return n0_03 * z8;
    });
    const Scalar z30 = traits::formula(0.017633557568774196, 0.017633557f, [&]() -> Scalar {
      return n0_03 * z10;
    });
    const Scalar z31 = traits::formula(-0.024270509831248423, -0.02427051f, [&]() -> Scalar {
      return n0_03 * z11;
    });
    const Scalar z32 = traits::formula(-0.017633557568774196, -0.017633557f, [&]() -> Scalar {
      return n0_03 * z13;
    });
    const Scalar z33 = traits::formula(-0.024270509831248423, -0.02427051f, [&]() -> Scalar {
      return n0_03 * z14;
    });
    const Scalar z34 = traits::formula(-0.02853169548885461, -0.028531695f, [&]() -> Scalar {
      return n0_03 * z16;
    });
    const Scalar z35 = traits::formula(-0.009270509831248422, -0.00927051f, [&]() -> Scalar {
      return n0_03 * z17;
    });
    const Scalar z36 = traits::formula(-0.02853169548885461, -0.028531695f, [&]() -> Scalar {
      return n0_03 * z19;
    });
    const Scalar z37 = traits::formula(0.009270509831248422, 0.00927051f, [&]() -> Scalar {
      return n0_03 * z20;
    });
    const Scalar z38 = traits::formula(-0.017633557568774196, -0.017633557f, [&]() -> Scalar {
      return n0_03 * z22;
    });
    const Scalar z39 = traits::formula(0.024270509831248423, 0.02427051f, [&]() -> Scalar {
      return n0_03 * z23;
    });
    const Scalar z40 = k9 * s_theta;
    const Scalar z41 = k10 * s_theta;
    const Scalar z42 = n0_03 * s_psi;
    const Scalar z43 = n0_03 * c_psi;
    const Scalar z44 = v_theta * c_theta;
    const Scalar z45 = v_psi * s_psi;
    const Scalar z46 = v_psi * c_psi;
    const Scalar z47 = v_theta * s_theta;
    const Scalar z48 = k10 * c_theta + z40;
    const Scalar z49 = k9 * c_theta - z41;
    const Scalar z50 = n0_03 * z46;
    const Scalar z51 = k9 * z44;
    const Scalar z52 = n0_03 * z45;
    const Scalar z53 = k10 * z44;
    const Scalar z54 = v_psi * z45;
    const Scalar z55 = v_theta * z47;
    const Scalar z56 = v_theta * z44;
    const Scalar z57 = v_psi * z46;
    const Scalar z58 = k10 * c_theta - z40;
    const Scalar z59 = k9 * c_theta + z41;
    const Scalar z60 = k10 * z47 - z51;
    const Scalar z61 = k9 * z47 + z53;
    const Scalar z62 = n0_03 * z54;
    const Scalar z63 = k9 * z55;
    const Scalar z64 = n0_03 * z57;
    const Scalar z65 = k10 * z55;
    const Scalar z66 = k11 - z49;
    const Scalar z67 = z42 + z48;
    const Scalar z68 = k11 - z59;
    const Scalar z69 = z42 - z58;
    const Scalar z70 = k10 * z56 + z63;
    const Scalar z71 = k9 * z56 - z65;
    const Scalar z72 = z43 - z66;
    const Scalar z73 = z50 - z60;
    const Scalar z74 = z52 + z61;
    const Scalar z75 = z43 - z68;
    const Scalar z76 = z67 * z67 + z72 * z72;
    const Scalar z77 = n2 * (z42 * z72 - z43 * z67);
    const Scalar z78 = n2 * (z48 * z72 - z49 * z67);
    const Scalar z79 = n2 * (z67 * z73 - z72 * z74);
    const Scalar z80 = z62 + z70;
    const Scalar z81 = z64 + z71;
    const Scalar z82 = z69 * z69 + z75 * z75;
    const Scalar z83 = n2 * (z67 * z80 + z72 * z81 - z73 * z73 - z74 * z74);
    const Scalar z84 = traits::sqrt(z76);
    const Scalar z85 = n2 * (z42 * z75 - z43 * z69);
    const Scalar z86 = traits::sqrt(z82);
    const Scalar z87 = n0_0066 - z84;
    const Scalar z88 = n2 * (z59 * z69 + z58 * z75);
    const Scalar z89 = n0_5 * z77 / z84;
    const Scalar z90 = k10 * z47 + z51;
    const Scalar z91 = n0_5 * z78 / z84;
    const Scalar z92 = k9 * z47 - z53;
    const Scalar z93 = k10 * z56 - z63;
    const Scalar z94 = k9 * z56 + z65;
    const Scalar z95 = z50 + z90;
    const Scalar z96 = z52 + z92;
    const Scalar z97 = n2 * (z69 * z95 - z75 * z96);
    const Scalar z98 = z62 - z93;
    const Scalar z99 = z64 + z94;
    const Scalar z100 = n2 * (z69 * z98 + z75 * z99 - z95 * z95 - z96 * z96);
    const Scalar z101 = n0_5 * z79 / z84;
    const Scalar z102 = z67 / z84;
    const Scalar z103 = z72 / z84;
    const Scalar z104 = n0_0066 - z86;
    const Scalar z105 = n0_5 * z85 / z86;
    const Scalar z106 = n0_5 * z88 / z86;
    const Scalar z107 = n0_5 * z97 / z86;
    const Scalar z108 = z69 / z86;
    const Scalar z109 = z75 / z86;
    const Scalar z110 = n0_5 * (z79 * z101 / (z84 * z84) + z83 / z84);
    const Scalar z111 = s_psi * z25 + c_psi * z24;
    const Scalar z112 = s_psi * z24 - c_psi * z25;
    const Scalar z113 = z42 - n0_0016 * z102;
    const Scalar z114 = z48 + z111;
    const Scalar z115 = z43 - n0_0016 * z103;
    const Scalar z116 = z66 + z112;
    const Scalar z117 = k11 - z43 + n0_0016 * z103;
    const Scalar z118 = z114 * z114 + z116 * z116;
    const Scalar z119 = z67 * z101 / (z84 * z84) - z73 / z84;
    const Scalar z120 = z72 * z101 / (z84 * z84) + z74 / z84;
    const Scalar z121 = n0_5 * (z97 * z107 / (z86 * z86) + z100 / z86);
    const Scalar z122 = z69 * z107 / (z86 * z86) - z95 / z86;
    const Scalar z123 = z75 * z107 / (z86 * z86) + z96 / z86;
    const Scalar z124 = z43 - n0_0016 * z109;
    const Scalar z125 = k11 - z43 + n0_0016 * z109;
    const Scalar z126 = z42 - n0_0016 * z108;
    const Scalar z127 = v_psi * z115 + v_theta * z117;
    const Scalar z128 = traits::sqrt(z118);
    const Scalar z129 = v_psi * z124 + v_theta * z125;
    const Scalar z130 = z113 * (v_psi - v_theta);
    const Scalar z131 = z102 * z113;
    const Scalar z132 = z103 * z115 + z131;
    const Scalar z133 = z103 * z117 - z131;
    const Scalar z134 = z102 * z130 + z103 * z127;
    const Scalar z135 = n0_0066 - z128;
    const Scalar z136 = z24 * z45 - z25 * z46;
    const Scalar z137 = z50 + n0_0016 * z119;
    const Scalar z138 = z137 * (v_psi - v_theta);
    const Scalar z139 = z60 + z136;
    const Scalar z140 = z24 * z46 + z25 * z45;
    const Scalar z141 = z61 + z140;
    const Scalar z142 = z50 + n0_0016 * z122;
    const Scalar z143 = z142 * (v_psi - v_theta);
    const Scalar z144 = n2 * (z111 * z116 - z112 * z114);
    const Scalar z145 = n0_5 * z144 / z128;
    const Scalar z146 = n2 * (z49 * z114 + z48 * z116);
    const Scalar z147 = n0_5 * z146 / z128;
    const Scalar z148 = z52 - n0_0016 * z120;
    const Scalar z149 = z148 * (v_psi - v_theta);
    const Scalar z150 = n2 * (z114 * z139 - z116 * z141);
    const Scalar z151 = z102 * z138 - z103 * z149 - z127 * z120 - z130 * z119;
    const Scalar z152 = z58 - z111;
    const Scalar z153 = z68 + z112;
    const Scalar z154 = z152 * z152 + z153 * z153;
    const Scalar z155 = n0_5 * z150 / z128;
    const Scalar z156 = z24 * z57 + z25 * z54;
    const Scalar z157 = z70 + z156;
    const Scalar z158 = z24 * z54 - z25 * z57;
    const Scalar z159 = z71 - z158;
    const Scalar z160 = traits::sqrt(z154);
    const Scalar z161 = z116 / z128;
    const Scalar z162 = n2 * (z112 * z152 + z111 * z153);
    const Scalar z163 = n2 * (z114 * z157 - z116 * z159 - z139 * z139 - z141 * z141);
    const Scalar z164 = z116 * z155 / (z128 * z128) + z141 / z128;
    const Scalar z165 = z114 * z155 / (z128 * z128) - z139 / z128;
    const Scalar z166 = z114 / z128;
    const Scalar z167 = z52 - n0_0016 * z123;
    const Scalar z168 = z167 * (v_psi - v_theta);
    const Scalar z169 = z112 - n0_0016 * z161;
    const Scalar z170 = k11 + z112 - n0_0016 * z161;
    const Scalar z171 = z111 - n0_0016 * z166;
    const Scalar z172 = n0_5 * z162 / z160;
    const Scalar z173 = n0_5 * (z150 * z155 / (z128 * z128) + z163 / z128);
    const Scalar z174 = n0_0066 - z160;
    const Scalar z175 = v_psi * z169 - v_theta * z170;
    const Scalar z176 = z136 + n0_0016 * z165;
    const Scalar z177 = z140 - n0_0016 * z164;
    const Scalar z178 = z126 * (v_psi - v_theta);
    const Scalar z179 = z108 * z143 - z109 * z168 - z129 * z123 - z178 * z122;
    const Scalar z180 = z108 * z178 + z109 * z129;
    const Scalar z181 = z108 * z126;
    const Scalar z182 = z109 * z124 + z181;
    const Scalar z183 = z109 * z125 - z181;
    const Scalar z184 = z93 - z156;
    const Scalar z185 = z94 - z158;
    const Scalar z186 = z176 * (v_psi - v_theta);
    const Scalar z187 = z177 * (v_psi - v_theta);
    const Scalar z188 = s_psi * z27 + c_psi * z26;
    const Scalar z189 = s_psi * z26 - c_psi * z27;
    const Scalar z190 = z48 + z188;
    const Scalar z191 = z66 + z189;
    const Scalar z192 = z26 * z45 - z27 * z46;
    const Scalar z193 = z60 + z192;
    const Scalar z194 = z190 * z190 + z191 * z191;
    const Scalar z195 = z90 - z136;
    const Scalar z196 = z92 + z140;
    const Scalar z197 = n2 * (z152 * z184 - z153 * z185 - z195 * z195 - z196 * z196);
    const Scalar z198 = traits::sqrt(z194);
    const Scalar z199 = n2 * (z152 * z195 - z153 * z196);
    const Scalar z200 = z153 / z160;
    const Scalar z201 = z112 - n0_0016 * z200;
    const Scalar z202 = k11 + z112 - n0_0016 * z200;
    const Scalar z203 = n0_5 * z199 / z160;
    const Scalar z204 = z152 / z160;
    const Scalar z205 = z111 + n0_0016 * z204;
    const Scalar z206 = n2 * (z59 * z152 + z58 * z153);
    const Scalar z207 = n0_5 * z206 / z160;
    const Scalar z208 = n2 * (z188 * z191 - z189 * z190);
    const Scalar z209 = n2 * (z49 * z190 + z48 * z191);
    const Scalar z210 = v_psi * z201 - v_theta * z202;
    const Scalar z211 = z205 * (v_psi - v_theta);
    const Scalar z212 = n0_5 * z208 / z198;
    const Scalar z213 = n0_5 * z209 / z198;
    const Scalar z214 = z204 * z205;
    const Scalar z215 = z200 * z201 - z214;
    const Scalar z216 = z200 * z202 - z214;
    const Scalar z217 = n0_5 * (z199 * z203 / (z160 * z160) + z197 / z160);
    const Scalar z218 = z152 * z203 / (z160 * z160) - z195 / z160;
    const Scalar z219 = z153 * z203 / (z160 * z160) + z196 / z160;
    const Scalar z220 = z204 * z211 - z200 * z210;
    const Scalar z221 = n0_0066 - z198;
    const Scalar z222 = z171 * (v_psi - v_theta);
    const Scalar z223 = z166 * z186 - z161 * z187 - z175 * z164 - z222 * z165;
    const Scalar z224 = z166 * z222 + z161 * z175;
    const Scalar z225 = z166 * z171;
    const Scalar z226 = z161 * z169 + z225;
    const Scalar z227 = z161 * z170 + z225;
    const Scalar z228 = z136 - n0_0016 * z218;
    const Scalar z229 = z140 - n0_0016 * z219;
    const Scalar z230 = z58 - z188;
    const Scalar z231 = z68 + z189;
    const Scalar z232 = z26 * z46 + z27 * z45;
    const Scalar z233 = z228 * (v_psi - v_theta);
    const Scalar z234 = z229 * (v_psi - v_theta);
    const Scalar z235 = z230 * z230 + z231 * z231;
    const Scalar z236 = z210 * z219 - z211 * z218 + z204 * z233 + z200 * z234;
    const Scalar z237 = traits::sqrt(z235);
    const Scalar z238 = z61 + z232;
    const Scalar z239 = z90 - z192;
    const Scalar z240 = n2 * (z190 * z193 - z191 * z238);
    const Scalar z241 = z92 + z232;
    const Scalar z242 = n2 * (z230 * z239 - z231 * z241);
    const Scalar z243 = z26 * z57 + z27 * z54;
    const Scalar z244 = z70 + z243;
    const Scalar z245 = z93 - z243;
    const Scalar z246 = n0_5 * z240 / z198;
    const Scalar z247 = s_psi * z29 + c_psi * z28;
    const Scalar z248 = s_psi * z28 - c_psi * z29;
    const Scalar z249 = z48 + z247;
    const Scalar z250 = z26 * z54 - z27 * z57;
    const Scalar z251 = z66 + z248;
    const Scalar z252 = z71 - z250;
    const Scalar z253 = z94 - z250;
    const Scalar z254 = n0_0066 - z237;
    const Scalar z255 = z249 * z249 + z251 * z251;
    const Scalar z256 = n2 * (z190 * z244 - z191 * z252 - z193 * z193 - z238 * z238);
    const Scalar z257 = n2 * (z230 * z245 - z231 * z253 - z239 * z239 - z241 * z241);
    const Scalar z258 = traits::sqrt(z255);
    const Scalar z259 = z190 * z246 / (z198 * z198) - z193 / z198;
    const Scalar z260 = z191 * z246 / (z198 * z198) + z238 / z198;
    const Scalar z261 = z191 / z198;
    const Scalar z262 = z190 / z198;
    const Scalar z263 = n0_5 * (z240 * z246 / (z198 * z198) + z256 / z198);
    const Scalar z264 = n0_5 * z242 / z237;
    const Scalar z265 = n0_5 * (z242 * z264 / (z237 * z237) + z257 / z237);
    const Scalar z266 = z230 * z264 / (z237 * z237) - z239 / z237;
    const Scalar z267 = z231 * z264 / (z237 * z237) + z241 / z237;
    const Scalar z268 = n0_0066 - z258;
    const Scalar z269 = z231 / z237;
    const Scalar z270 = z189 - n0_0016 * z269;
    const Scalar z271 = z230 / z237;
    const Scalar z272 = k11 + z189 - n0_0016 * z269;
    const Scalar z273 = z192 + n0_0016 * z259;
    const Scalar z274 = z273 * (v_psi - v_theta);
    const Scalar z275 = n2 * (z189 * z230 + z188 * z231);
    const Scalar z276 = n2 * (z59 * z230 + z58 * z231);
    const Scalar z277 = n0_5 * z275 / z237;
    const Scalar z278 = n0_5 * z276 / z237;
    const Scalar z279 = z192 - n0_0016 * z266;
    const Scalar z280 = n2 * (z247 * z251 - z248 * z249);
    const Scalar z281 = n0_5 * z280 / z258;
    const Scalar z282 = z279 * (v_psi - v_theta);
    const Scalar z283 = z189 - n0_0016 * z261;
    const Scalar z284 = k11 + z189 - n0_0016 * z261;
    const Scalar z285 = z232 - n0_0016 * z260;
    const Scalar z286 = z285 * (v_psi - v_theta);
    const Scalar z287 = z232 - n0_0016 * z267;
    const Scalar z288 = z287 * (v_psi - v_theta);
    const Scalar z289 = z188 + n0_0016 * z271;
    const Scalar z290 = z188 - n0_0016 * z262;
    const Scalar z291 = z28 * z45 - z29 * z46;
    const Scalar z292 = n2 * (z49 * z249 + z48 * z251);
    const Scalar z293 = n0_5 * z292 / z258;
    const Scalar z294 = v_psi * z270 - v_theta * z272;
    const Scalar z295 = z289 * (v_psi - v_theta);
    const Scalar z296 = z294 * z267 - z295 * z266 + z271 * z282 + z269 * z288;
    const Scalar z297 = z271 * z295 - z269 * z294;
    const Scalar z298 = z271 * z289;
    const Scalar z299 = z269 * z270 - z298;
    const Scalar z300 = z269 * z272 - z298;
    const Scalar z301 = v_psi * z283 - v_theta * z284;
    const Scalar z302 = z60 + z291;
    const Scalar z303 = z290 * (v_psi - v_theta);
    const Scalar z304 = z262 * z274 - z261 * z286 - z301 * z260 - z303 * z259;
    const Scalar z305 = z262 * z303 + z261 * z301;
    const Scalar z306 = z262 * z290;
    const Scalar z307 = z261 * z283 + z306;
    const Scalar z308 = z261 * z284 + z306;
    const Scalar z309 = z58 - z247;
    const Scalar z310 = z68 + z248;
    const Scalar z311 = z28 * z46 + z29 * z45;
    const Scalar z312 = z309 * z309 + z310 * z310;
    const Scalar z313 = z61 + z311;
    const Scalar z314 = z90 - z291;
    const Scalar z315 = z92 + z311;
    const Scalar z316 = n2 * (z249 * z302 - z251 * z313);
    const Scalar z317 = traits::sqrt(z312);
    const Scalar z318 = n2 * (z309 * z314 - z310 * z315);
    const Scalar z319 = z28 * z57 + z29 * z54;
    const Scalar z320 = z70 + z319;
    const Scalar z321 = z93 - z319;
    const Scalar z322 = n0_5 * z316 / z258;
    const Scalar z323 = s_psi * z31 + c_psi * z30;
    const Scalar z324 = s_psi * z30 - c_psi * z31;
    const Scalar z325 = z48 + z323;
    const Scalar z326 = z28 * z54 - z29 * z57;
    const Scalar z327 = z66 + z324;
    const Scalar z328 = z71 - z326;
    const Scalar z329 = z94 - z326;
    const Scalar z330 = z325 * z325 + z327 * z327;
    const Scalar z331 = n2 * (z249 * z320 - z251 * z328 - z302 * z302 - z313 * z313);
    const Scalar z332 = n2 * (z309 * z321 - z310 * z329 - z314 * z314 - z315 * z315);
    const Scalar z333 = traits::sqrt(z330);
    const Scalar z334 = z249 * z322 / (z258 * z258) - z302 / z258;
    const Scalar z335 = z251 * z322 / (z258 * z258) + z313 / z258;
    const Scalar z336 = z251 / z258;
    const Scalar z337 = z249 / z258;
    const Scalar z338 = n0_0066 - z317;
    const Scalar z339 = n0_5 * (z316 * z322 / (z258 * z258) + z331 / z258);
    const Scalar z340 = n0_5 * z318 / z317;
    const Scalar z341 = n0_5 * (z318 * z340 / (z317 * z317) + z332 / z317);
    const Scalar z342 = z309 * z340 / (z317 * z317) - z314 / z317;
    const Scalar z343 = z310 * z340 / (z317 * z317) + z315 / z317;
    const Scalar z344 = n0_0066 - z333;
    const Scalar z345 = z310 / z317;
    const Scalar z346 = z248 - n0_0016 * z345;
    const Scalar z347 = z309 / z317;
    const Scalar z348 = k11 + z248 - n0_0016 * z345;
    const Scalar z349 = z291 + n0_0016 * z334;
    const Scalar z350 = z349 * (v_psi - v_theta);
    const Scalar z351 = n2 * (z248 * z309 + z247 * z310);
    const Scalar z352 = n2 * (z59 * z309 + z58 * z310);
    const Scalar z353 = n0_5 * z351 / z317;
    const Scalar z354 = n0_5 * z352 / z317;
    const Scalar z355 = z291 - n0_0016 * z342;
    const Scalar z356 = n2 * (z323 * z327 - z324 * z325);
    const Scalar z357 = n0_5 * z356 / z333;
    const Scalar z358 = z355 * (v_psi - v_theta);
    const Scalar z359 = z248 - n0_0016 * z336;
    const Scalar z360 = k11 + z248 - n0_0016 * z336;
    const Scalar z361 = z311 - n0_0016 * z335;
    const Scalar z362 = z361 * (v_psi - v_theta);
    const Scalar z363 = z311 - n0_0016 * z343;
    const Scalar z364 = z363 * (v_psi - v_theta);
    const Scalar z365 = z247 + n0_0016 * z347;
    const Scalar z366 = z247 - n0_0016 * z337;
    const Scalar z367 = z30 * z45 - z31 * z46;
    const Scalar z368 = n2 * (z49 * z325 + z48 * z327);
    const Scalar z369 = n0_5 * z368 / z333;
    const Scalar z370 = v_psi * z346 - v_theta * z348;
    const Scalar z371 = z365 * (v_psi - v_theta);
    const Scalar z372 = z370 * z343 - z371 * z342 + z347 * z358 + z345 * z364;
    const Scalar z373 = z347 * z371 - z345 * z370;
    const Scalar z374 = z347 * z365;
    const Scalar z375 = z345 * z346 - z374;
    const Scalar z376 = z345 * z348 - z374;
    const Scalar z377 = v_psi * z359 - v_theta * z360;
    const Scalar z378 = z60 + z367;
    const Scalar z379 = z366 * (v_psi - v_theta);
    const Scalar z380 = z337 * z350 - z336 * z362 - z377 * z335 - z379 * z334;
    const Scalar z381 = z337 * z379 + z336 * z377;
    const Scalar z382 = z337 * z366;
    const Scalar z383 = z336 * z359 + z382;
    const Scalar z384 = z336 * z360 + z382;
    const Scalar z385 = z58 - z323;
    const Scalar z386 = z68 + z324;
    const Scalar z387 = z30 * z46 + z31 * z45;
    const Scalar z388 = z385 * z385 + z386 * z386;
    const Scalar z389 = z61 + z387;
    const Scalar z390 = z90 - z367;
    const Scalar z391 = z92 + z387;
    const Scalar z392 = n2 * (z325 * z378 - z327 * z389);
    const Scalar z393 = traits::sqrt(z388);
    const Scalar z394 = n2 * (z385 * z390 - z386 * z391);
    const Scalar z395 = z30 * z57 + z31 * z54;
    const Scalar z396 = z70 + z395;
    const Scalar z397 = z93 - z395;
    const Scalar z398 = n0_5 * z392 / z333;
    const Scalar z399 = z42 - z48;
    const Scalar z400 = z43 + z66;
    const Scalar z401 = z399 * z399 + z400 * z400;
    const Scalar z402 = z30 * z54 - z31 * z57;
    const Scalar z403 = z71 - z402;
    const Scalar z404 = z94 - z402;
    const Scalar z405 = z327 / z333;
    const Scalar z406 = n2 * (z324 * z385 + z323 * z386);
    const Scalar z407 = n2 * (z325 * z396 - z327 * z403 - z378 * z378 - z389 * z389);
    const Scalar z408 = n2 * (z385 * z397 - z386 * z404 - z390 * z390 - z391 * z391);
    const Scalar z409 = z327 * z398 / (z333 * z333) + z389 / z333;
    const Scalar z410 = n0_5 * z406 / z393;
    const Scalar z411 = traits::sqrt(z401);
    const Scalar z412 = z325 * z398 / (z333 * z333) - z378 / z333;
    const Scalar z413 = n0_5 * (z392 * z398 / (z333 * z333) + z407 / z333);
    const Scalar z414 = z325 / z333;
    const Scalar z415 = n0_0066 - z393;
    const Scalar z416 = n0_0066 - z411;
    const Scalar z417 = n0_5 * z394 / z393;
    const Scalar z418 = n0_5 * (z394 * z417 / (z393 * z393) + z408 / z393);
    const Scalar z419 = z385 * z417 / (z393 * z393) - z390 / z393;
    const Scalar z420 = z386 * z417 / (z393 * z393) + z391 / z393;
    const Scalar z421 = z386 / z393;
    const Scalar z422 = n2 * (z59 * z385 + z58 * z386);
    const Scalar z423 = n0_5 * z422 / z393;
    const Scalar z424 = z385 / z393;
    const Scalar z425 = z324 - n0_0016 * z421;
    const Scalar z426 = k11 + z324 - n0_0016 * z421;
    const Scalar z427 = z367 + n0_0016 * z412;
    const Scalar z428 = z427 * (v_psi - v_theta);
    const Scalar z429 = n2 * (z42 * z400 - z43 * z399);
    const Scalar z430 = n0_5 * z429 / z411;
    const Scalar z431 = z367 - n0_0016 * z419;
    const Scalar z432 = n2 * (z48 * z400 - z49 * z399);
    const Scalar z433 = n0_5 * z432 / z411;
    const Scalar z434 = z431 * (v_psi - v_theta);
    const Scalar z435 = z324 - n0_0016 * z405;
    const Scalar z436 = k11 + z324 - n0_0016 * z405;
    const Scalar z437 = z387 - n0_0016 * z409;
    const Scalar z438 = z437 * (v_psi - v_theta);
    const Scalar z439 = z387 - n0_0016 * z420;
    const Scalar z440 = z439 * (v_psi - v_theta);
    const Scalar z441 = z323 + n0_0016 * z424;
    const Scalar z442 = z323 - n0_0016 * z414;
    const Scalar z443 = z50 + z60;
    const Scalar z444 = z52 - z61;
    const Scalar z445 = n2 * (z399 * z443 - z400 * z444);
    const Scalar z446 = v_psi * z425 - v_theta * z426;
    const Scalar z447 = z441 * (v_psi - v_theta);
    const Scalar z448 = z446 * z420 - z447 * z419 + z424 * z434 + z421 * z440;
    const Scalar z449 = z424 * z447 - z421 * z446;
    const Scalar z450 = z424 * z441;
    const Scalar z451 = z421 * z425 - z450;
    const Scalar z452 = z421 * z426 - z450;
    const Scalar z453 = v_psi * z435 - v_theta * z436;
    const Scalar z454 = n0_5 * z445 / z411;
    const Scalar z455 = z442 * (v_psi - v_theta);
    const Scalar z456 = z414 * z428 - z405 * z438 - z453 * z409 - z455 * z412;
    const Scalar z457 = z414 * z455 + z405 * z453;
    const Scalar z458 = z414 * z442;
    const Scalar z459 = z405 * z435 + z458;
    const Scalar z460 = z405 * z436 + z458;
    const Scalar z461 = s_psi * z33 + c_psi * z32;
    const Scalar z462 = z42 + z58;
    const Scalar z463 = s_psi * z32 - c_psi * z33;
    const Scalar z464 = z48 + z461;
    const Scalar z465 = z43 + z68;
    const Scalar z466 = z462 * z462 + z465 * z465;
    const Scalar z467 = z50 - z90;
    const Scalar z468 = z52 - z92;
    const Scalar z469 = n2 * (z462 * z467 - z465 * z468);
    const Scalar z470 = traits::sqrt(z466);
    const Scalar z471 = z62 - z70;
    const Scalar z472 = z62 + z93;
    const Scalar z473 = z66 + z463;
    const Scalar z474 = z64 - z71;
    const Scalar z475 = n2 * (z399 * z471 + z400 * z474 - z443 * z443 - z444 * z444);
    const Scalar z476 = z64 - z94;
    const Scalar z477 = n2 * (z462 * z472 + z465 * z476 - z467 * z467 - z468 * z468);
    const Scalar z478 = z399 * z454 / (z411 * z411) - z443 / z411;
    const Scalar z479 = z400 * z454 / (z411 * z411) + z444 / z411;
    const Scalar z480 = z400 / z411;
    const Scalar z481 = z399 / z411;
    const Scalar z482 = z464 * z464 + z473 * z473;
    const Scalar z483 = traits::sqrt(z482);
    const Scalar z484 = n0_5 * (z445 * z454 / (z411 * z411) + z475 / z411);
    const Scalar z485 = n0_0066 - z470;
    const Scalar z486 = n0_5 * z469 / z470;
    const Scalar z487 = z465 / z470;
    const Scalar z488 = z50 + n0_0016 * z478;
    const Scalar z489 = z488 * (v_psi - v_theta);
    const Scalar z490 = n2 * (z42 * z465 - z43 * z462);
    const Scalar z491 = n0_5 * z490 / z470;
    const Scalar z492 = n2 * (z59 * z462 + z58 * z465);
    const Scalar z493 = n0_5 * (z469 * z486 / (z470 * z470) + z477 / z470);
    const Scalar z494 = z465 * z486 / (z470 * z470) + z468 / z470;
    const Scalar z495 = z462 * z486 / (z470 * z470) - z467 / z470;
    const Scalar z496 = n0_5 * z492 / z470;
    const Scalar z497 = z462 / z470;
    const Scalar z498 = n0_0066 - z483;
    const Scalar z499 = n2 * (z461 * z473 - z463 * z464);
    const Scalar z500 = n0_5 * z499 / z483;
    const Scalar z501 = z43 - n0_0016 * z480;
    const Scalar z502 = z52 - n0_0016 * z479;
    const Scalar z503 = z502 * (v_psi - v_theta);
    const Scalar z504 = z43 - n0_0016 * z487;
    const Scalar z505 = k11 + z43 - n0_0016 * z480;
    const Scalar z506 = k11 + z43 - n0_0016 * z487;
    const Scalar z507 = z50 + n0_0016 * z495;
    const Scalar z508 = z52 - n0_0016 * z494;
    const Scalar z509 = z42 - n0_0016 * z481;
    const Scalar z510 = z507 * (v_psi - v_theta);
    const Scalar z511 = z508 * (v_psi - v_theta);
    const Scalar z512 = z42 - n0_0016 * z497;
    const Scalar z513 = z32 * z45 - z33 * z46;
    const Scalar z514 = n2 * (z49 * z464 + z48 * z473);
    const Scalar z515 = n0_5 * z514 / z483;
    const Scalar z516 = v_psi * z501 - v_theta * z505;
    const Scalar z517 = z60 + z513;
    const Scalar z518 = v_psi * z504 - v_theta * z506;
    const Scalar z519 = z509 * (v_psi - v_theta);
    const Scalar z520 = z481 * z489 - z480 * z503 - z516 * z479 - z519 * z478;
    const Scalar z521 = z481 * z519 + z480 * z516;
    const Scalar z522 = z481 * z509;
    const Scalar z523 = z480 * z501 + z522;
    const Scalar z524 = z480 * z505 + z522;
    const Scalar z525 = z58 - z461;
    const Scalar z526 = z68 + z463;
    const Scalar z527 = z32 * z46 + z33 * z45;
    const Scalar z528 = z525 * z525 + z526 * z526;
    const Scalar z529 = z61 + z527;
    const Scalar z530 = z32 * z57 + z33 * z54;
    const Scalar z531 = n2 * (z464 * z517 - z473 * z529);
    const Scalar z532 = traits::sqrt(z528);
    const Scalar z533 = z70 + z530;
    const Scalar z534 = z32 * z54 - z33 * z57;
    const Scalar z535 = z71 - z534;
    const Scalar z536 = z473 / z483;
    const Scalar z537 = n2 * (z463 * z525 + z461 * z526);
    const Scalar z538 = n2 * (z464 * z533 - z473 * z535 - z517 * z517 - z529 * z529);
    const Scalar z539 = n0_5 * z531 / z483;
    const Scalar z540 = z464 / z483;
    const Scalar z541 = z463 - n0_0016 * z536;
    const Scalar z542 = k11 + z463 - n0_0016 * z536;
    const Scalar z543 = z461 - n0_0016 * z540;
    const Scalar z544 = v_psi * z541 - v_theta * z542;
    const Scalar z545 = z512 * (v_psi - v_theta);
    const Scalar z546 = z497 * z510 - z487 * z511 - z518 * z494 - z545 * z495;
    const Scalar z547 = z497 * z545 + z487 * z518;
    const Scalar z548 = n0_5 * (z531 * z539 / (z483 * z483) + z538 / z483);
    const Scalar z549 = z464 * z539 / (z483 * z483) - z517 / z483;
    const Scalar z550 = z473 * z539 / (z483 * z483) + z529 / z483;
    const Scalar z551 = z497 * z512;
    const Scalar z552 = z487 * z504 + z551;
    const Scalar z553 = z487 * z506 + z551;
    const Scalar z554 = n0_5 * z537 / z532;
    const Scalar z555 = z93 - z530;
    const Scalar z556 = z94 - z534;
    const Scalar z557 = n0_0066 - z532;
    const Scalar z558 = s_psi * z35 + c_psi * z34;
    const Scalar z559 = s_psi * z34 - c_psi * z35;
    const Scalar z560 = z48 + z558;
    const Scalar z561 = z66 + z559;
    const Scalar z562 = z34 * z45 - z35 * z46;
    const Scalar z563 = z60 + z562;
    const Scalar z564 = z560 * z560 + z561 * z561;
    const Scalar z565 = z90 - z513;
    const Scalar z566 = z92 + z527;
    const Scalar z567 = n2 * (z525 * z555 - z526 * z556 - z565 * z565 - z566 * z566);
    const Scalar z568 = traits::sqrt(z564);
    const Scalar z569 = n2 * (z525 * z565 - z526 * z566);
    const Scalar z570 = z526 / z532;
    const Scalar z571 = z463 - n0_0016 * z570;
    const Scalar z572 = k11 + z463 - n0_0016 * z570;
    const Scalar z573 = n0_5 * z569 / z532;
    const Scalar z574 = z525 / z532;
    const Scalar z575 = z461 + n0_0016 * z574;
    const Scalar z576 = z513 + n0_0016 * z549;
    const Scalar z577 = z576 * (v_psi - v_theta);
    const Scalar z578 = n2 * (z59 * z525 + z58 * z526);
    const Scalar z579 = n0_5 * z578 / z532;
    const Scalar z580 = n2 * (z558 * z561 - z559 * z560);
    const Scalar z581 = n2 * (z49 * z560 + z48 * z561);
    const Scalar z582 = n0_5 * z580 / z568;
    const Scalar z583 = n0_5 * z581 / z568;
    const Scalar z584 = n0_0066 - z568;
    const Scalar z585 = z527 - n0_0016 * z550;
    const Scalar z586 = z585 * (v_psi - v_theta);
    const Scalar z587 = n0_5 * (z569 * z573 / (z532 * z532) + z567 / z532);
    const Scalar z588 = z525 * z573 / (z532 * z532) - z565 / z532;
    const Scalar z589 = z526 * z573 / (z532 * z532) + z566 / z532;
    const Scalar z590 = v_psi * z571 - v_theta * z572;
    const Scalar z591 = z575 * (v_psi - v_theta);
    const Scalar z592 = z574 * z575;
    const Scalar z593 = z570 * z571 - z592;
    const Scalar z594 = z570 * z572 - z592;
    const Scalar z595 = z574 * z591 - z570 * z590;
    const Scalar z596 = z543 * (v_psi - v_theta);
    const Scalar z597 = z540 * z577 - z536 * z586 - z544 * z550 - z596 * z549;
    const Scalar z598 = z540 * z596 + z536 * z544;
    const Scalar z599 = z540 * z543;
    const Scalar z600 = z536 * z541 + z599;
    const Scalar z601 = z536 * z542 + z599;
    const Scalar z602 = z513 - n0_0016 * z588;
    const Scalar z603 = z602 * (v_psi - v_theta);
    const Scalar z604 = z527 - n0_0016 * z589;
    const Scalar z605 = z604 * (v_psi - v_theta);
    const Scalar z606 = z58 - z558;
    const Scalar z607 = z68 + z559;
    const Scalar z608 = z34 * z46 + z35 * z45;
    const Scalar z609 = z590 * z589 - z591 * z588 + z574 * z603 + z570 * z605;
    const Scalar z610 = z606 * z606 + z607 * z607;
    const Scalar z611 = traits::sqrt(z610);
    const Scalar z612 = z61 + z608;
    const Scalar z613 = z90 - z562;
    const Scalar z614 = n2 * (z560 * z563 - z561 * z612);
    const Scalar z615 = z92 + z608;
    const Scalar z616 = n2 * (z606 * z613 - z607 * z615);
    const Scalar z617 = z34 * z57 + z35 * z54;
    const Scalar z618 = z70 + z617;
    const Scalar z619 = z93 - z617;
    const Scalar z620 = n0_5 * z614 / z568;
    const Scalar z621 = s_psi * z37 + c_psi * z36;
    const Scalar z622 = s_psi * z36 - c_psi * z37;
    const Scalar z623 = z48 + z621;
    const Scalar z624 = z34 * z54 - z35 * z57;
    const Scalar z625 = z66 + z622;
    const Scalar z626 = z71 - z624;
    const Scalar z627 = z94 - z624;
    const Scalar z628 = z623 * z623 + z625 * z625;
    const Scalar z629 = n2 * (z560 * z618 - z561 * z626 - z563 * z563 - z612 * z612);
    const Scalar z630 = n2 * (z606 * z619 - z607 * z627 - z613 * z613 - z615 * z615);
    const Scalar z631 = traits::sqrt(z628);
    const Scalar z632 = z560 * z620 / (z568 * z568) - z563 / z568;
    const Scalar z633 = z561 * z620 / (z568 * z568) + z612 / z568;
    const Scalar z634 = z561 / z568;
    const Scalar z635 = z560 / z568;
    const Scalar z636 = n0_0066 - z611;
    const Scalar z637 = n0_5 * (z614 * z620 / (z568 * z568) + z629 / z568);
    const Scalar z638 = n0_5 * z616 / z611;
    const Scalar z639 = n0_5 * (z616 * z638 / (z611 * z611) + z630 / z611);
    const Scalar z640 = z606 * z638 / (z611 * z611) - z613 / z611;
    const Scalar z641 = z607 * z638 / (z611 * z611) + z615 / z611;
    const Scalar z642 = n0_0066 - z631;
    const Scalar z643 = z607 / z611;
    const Scalar z644 = z559 - n0_0016 * z643;
    const Scalar z645 = z606 / z611;
    const Scalar z646 = k11 + z559 - n0_0016 * z643;
    const Scalar z647 = z562 + n0_0016 * z632;
    const Scalar z648 = z647 * (v_psi - v_theta);
    const Scalar z649 = n2 * (z559 * z606 + z558 * z607);
    const Scalar z650 = n2 * (z59 * z606 + z58 * z607);
    const Scalar z651 = n0_5 * z649 / z611;
    const Scalar z652 = n0_5 * z650 / z611;
    const Scalar z653 = z562 - n0_0016 * z640;
    const Scalar z654 = n2 * (z621 * z625 - z622 * z623);
    const Scalar z655 = n0_5 * z654 / z631;
    const Scalar z656 = z653 * (v_psi - v_theta);
    const Scalar z657 = z559 - n0_0016 * z634;
    const Scalar z658 = k11 + z559 - n0_0016 * z634;
    const Scalar z659 = z608 - n0_0016 * z633;
    const Scalar z660 = z659 * (v_psi - v_theta);
    const Scalar z661 = z608 - n0_0016 * z641;
    const Scalar z662 = z661 * (v_psi - v_theta);
    const Scalar z663 = z558 + n0_0016 * z645;
    const Scalar z664 = z558 - n0_0016 * z635;
    const Scalar z665 = z36 * z45 - z37 * z46;
    const Scalar z666 = n2 * (z49 * z623 + z48 * z625);
    const Scalar z667 = n0_5 * z666 / z631;
    const Scalar z668 = v_psi * z644 - v_theta * z646;
    const Scalar z669 = z663 * (v_psi - v_theta);
    const Scalar z670 = z668 * z641 - z669 * z640 + z645 * z656 + z643 * z662;
    const Scalar z671 = z645 * z669 - z643 * z668;
    const Scalar z672 = z645 * z663;
    const Scalar z673 = z643 * z644 - z672;
    const Scalar z674 = z643 * z646 - z672;
    const Scalar z675 = v_psi * z657 - v_theta * z658;
    const Scalar z676 = z60 + z665;
    const Scalar z677 = z664 * (v_psi - v_theta);
    const Scalar z678 = z635 * z648 - z634 * z660 - z675 * z633 - z677 * z632;
    const Scalar z679 = z635 * z677 + z634 * z675;
    const Scalar z680 = z635 * z664;
    const Scalar z681 = z634 * z657 + z680;
    const Scalar z682 = z634 * z658 + z680;
    const Scalar z683 = z58 - z621;
    const Scalar z684 = z68 + z622;
    const Scalar z685 = z36 * z46 + z37 * z45;
    const Scalar z686 = z683 * z683 + z684 * z684;
    const Scalar z687 = z61 + z685;
    const Scalar z688 = z90 - z665;
    const Scalar z689 = z92 + z685;
    const Scalar z690 = n2 * (z623 * z676 - z625 * z687);
    const Scalar z691 = traits::sqrt(z686);
    const Scalar z692 = n2 * (z683 * z688 - z684 * z689);
    const Scalar z693 = z36 * z57 + z37 * z54;
    const Scalar z694 = z70 + z693;
    const Scalar z695 = z93 - z693;
    const Scalar z696 = n0_5 * z690 / z631;
    const Scalar z697 = s_psi * z39 + c_psi * z38;
    const Scalar z698 = s_psi * z38 - c_psi * z39;
    const Scalar z699 = z48 + z697;
    const Scalar z700 = z36 * z54 - z37 * z57;
    const Scalar z701 = z66 + z698;
    const Scalar z702 = z71 - z700;
    const Scalar z703 = z94 - z700;
    const Scalar z704 = z699 * z699 + z701 * z701;
    const Scalar z705 = n2 * (z623 * z694 - z625 * z702 - z676 * z676 - z687 * z687);
    const Scalar z706 = n2 * (z683 * z695 - z684 * z703 - z688 * z688 - z689 * z689);
    const Scalar z707 = traits::sqrt(z704);
    const Scalar z708 = z623 * z696 / (z631 * z631) - z676 / z631;
    const Scalar z709 = z625 * z696 / (z631 * z631) + z687 / z631;
    const Scalar z710 = z625 / z631;
    const Scalar z711 = z623 / z631;
    const Scalar z712 = n0_0066 - z691;
    const Scalar z713 = n0_5 * (z690 * z696 / (z631 * z631) + z705 / z631);
    const Scalar z714 = n0_5 * z692 / z691;
    const Scalar z715 = n0_5 * (z692 * z714 / (z691 * z691) + z706 / z691);
    const Scalar z716 = z683 * z714 / (z691 * z691) - z688 / z691;
    const Scalar z717 = z684 * z714 / (z691 * z691) + z689 / z691;
    const Scalar z718 = n0_0066 - z707;
    const Scalar z719 = z684 / z691;
    const Scalar z720 = z622 - n0_0016 * z719;
    const Scalar z721 = z683 / z691;
    const Scalar z722 = k11 + z622 - n0_0016 * z719;
    const Scalar z723 = z665 + n0_0016 * z708;
    const Scalar z724 = z723 * (v_psi - v_theta);
    const Scalar z725 = n2 * (z622 * z683 + z621 * z684);
    const Scalar z726 = n2 * (z59 * z683 + z58 * z684);
    const Scalar z727 = n0_5 * z725 / z691;
    const Scalar z728 = n0_5 * z726 / z691;
    const Scalar z729 = z665 - n0_0016 * z716;
    const Scalar z730 = n2 * (z697 * z701 - z698 * z699);
    const Scalar z731 = n0_5 * z730 / z707;
    const Scalar z732 = z729 * (v_psi - v_theta);
    const Scalar z733 = z622 - n0_0016 * z710;
    const Scalar z734 = k11 + z622 - n0_0016 * z710;
    const Scalar z735 = z685 - n0_0016 * z709;
    const Scalar z736 = z735 * (v_psi - v_theta);
    const Scalar z737 = z685 - n0_0016 * z717;
    const Scalar z738 = z737 * (v_psi - v_theta);
    const Scalar z739 = z621 + n0_0016 * z721;
    const Scalar z740 = z621 - n0_0016 * z711;
    const Scalar z741 = n2 * (z49 * z699 + z48 * z701);
    const Scalar z742 = n0_5 * z741 / z707;
    const Scalar z743 = z38 * z45 - z39 * z46;
    const Scalar z744 = v_psi * z720 - v_theta * z722;
    const Scalar z745 = z739 * (v_psi - v_theta);
    const Scalar z746 = z744 * z717 - z745 * z716 + z721 * z732 + z719 * z738;
    const Scalar z747 = z721 * z745 - z719 * z744;
    const Scalar z748 = z721 * z739;
    const Scalar z749 = z719 * z720 - z748;
    const Scalar z750 = z719 * z722 - z748;
    const Scalar z751 = v_psi * z733 - v_theta * z734;
    const Scalar z752 = z60 + z743;
    const Scalar z753 = z740 * (v_psi - v_theta);
    const Scalar z754 = z711 * z724 - z710 * z736 - z751 * z709 - z753 * z708;
    const Scalar z755 = z711 * z753 + z710 * z751;
    const Scalar z756 = z38 * z46 + z39 * z45;
    const Scalar z757 = z711 * z740;
    const Scalar z758 = z710 * z733 + z757;
    const Scalar z759 = z710 * z734 + z757;
    const Scalar z760 = z68 + z698;
    const Scalar z761 = z61 + z756;
    const Scalar z762 = z90 - z743;
    const Scalar z763 = z92 + z756;
    const Scalar z764 = z58 - z697;
    const Scalar z765 = n2 * (z59 * z764 + z58 * z760);
    const Scalar z766 = z764 * z764 + z760 * z760;
    const Scalar z767 = n2 * (z699 * z752 - z701 * z761);
    const Scalar z768 = n2 * (z764 * z762 - z760 * z763);
    const Scalar z769 = traits::sqrt(z766);
    const Scalar z770 = n0_5 * z767 / z707;
    const Scalar z771 = z38 * z57 + z39 * z54;
    const Scalar z772 = z38 * z54 - z39 * z57;
    const Scalar z773 = z70 + z771;
    const Scalar z774 = z93 - z771;
    const Scalar z775 = z71 - z772;
    const Scalar z776 = z94 - z772;
    const Scalar z777 = z701 / z707;
    const Scalar z778 = n2 * (z698 * z764 + z697 * z760);
    const Scalar z779 = n2 * (z699 * z773 - z701 * z775 - z752 * z752 - z761 * z761);
    const Scalar z780 = n2 * (z764 * z774 - z760 * z776 - z762 * z762 - z763 * z763);
    const Scalar z781 = z701 * z770 / (z707 * z707) + z761 / z707;
    const Scalar z782 = n0_5 * z778 / z769;
    const Scalar z783 = n0_5 * z765 / z769;
    const Scalar z784 = n0_5 * z768 / z769;
    const Scalar z785 = z699 * z770 / (z707 * z707) - z752 / z707;
    const Scalar z786 = n0_5 * (z767 * z770 / (z707 * z707) + z779 / z707);
    const Scalar z787 = z760 / z769;
    const Scalar z788 = z764 / z769;
    const Scalar z789 = z699 / z707;
    const Scalar z790 = z698 - n0_0016 * z777;
    const Scalar z791 = z698 - n0_0016 * z787;
    const Scalar z792 = n0_5 * (z768 * z784 / (z769 * z769) + z780 / z769);
    const Scalar z793 = k11 + z698 - n0_0016 * z787;
    const Scalar z794 = z743 + n0_0016 * z785;
    const Scalar z795 = z764 * z784 / (z769 * z769) - z762 / z769;
    const Scalar z796 = z794 * (v_psi - v_theta);
    const Scalar z797 = z756 - n0_0016 * z781;
    const Scalar z798 = z760 * z784 / (z769 * z769) + z763 / z769;
    const Scalar z799 = z697 + n0_0016 * z788;
    const Scalar z800 = v_psi * z791 - v_theta * z793;
    const Scalar z801 = n0_0066 - z769;
    const Scalar z802 = k11 + z698 - n0_0016 * z777;
    const Scalar z803 = z797 * (v_psi - v_theta);
    const Scalar z804 = z799 * (v_psi - v_theta);
    const Scalar z805 = z743 - n0_0016 * z795;
    const Scalar z806 = z697 - n0_0016 * z789;
    const Scalar z807 = z756 - n0_0016 * z798;
    const Scalar z808 = z805 * (v_psi - v_theta);
    const Scalar z809 = z788 * z799;
    const Scalar z810 = z787 * z791 - z809;
    const Scalar z811 = v_psi * z790 - v_theta * z802;
    const Scalar z812 = z787 * z793 - z809;
    const Scalar z813 = z806 * (v_psi - v_theta);
    const Scalar z814 = z789 * z806;
    const Scalar z815 = z807 * (v_psi - v_theta);
    const Scalar z816 = z789 * z813 + z777 * z811;
    const Scalar z817 = z777 * z790 + z814;
    const Scalar z818 = z777 * z802 + z814;
    const Scalar z819 = z789 * z796 - z777 * z803 - z811 * z781 - z813 * z785;
    const Scalar z820 = z788 * z804 - z787 * z800;
    const Scalar z821 = z800 * z798 - z804 * z795 + z788 * z808 + z787 * z815;
    result.gap[0] = -z87;
    result.rate[0] = z101;
    result.drift[0] = -z110;
    result.rate[1] = z134;
    result.drift[1] = z151;
    result.gap[1] = -z104;
    result.rate[2] = z107;
    result.drift[2] = -z121;
    result.rate[3] = z180;
    result.drift[3] = z179;
    result.gap[2] = -z135;
    result.rate[4] = -z155;
    result.drift[4] = -z173;
    result.rate[5] = z224;
    result.drift[5] = -z223;
    result.gap[3] = -z174;
    result.rate[6] = -z203;
    result.drift[6] = -z217;
    result.rate[7] = -z220;
    result.drift[7] = z236;
    result.gap[4] = -z221;
    result.rate[8] = -z246;
    result.drift[8] = -z263;
    result.rate[9] = z305;
    result.drift[9] = -z304;
    result.gap[5] = -z254;
    result.rate[10] = -z264;
    result.drift[10] = -z265;
    result.rate[11] = -z297;
    result.drift[11] = z296;
    result.gap[6] = -z268;
    result.rate[12] = -z322;
    result.drift[12] = -z339;
    result.rate[13] = z381;
    result.drift[13] = -z380;
    result.gap[7] = -z338;
    result.rate[14] = -z340;
    result.drift[14] = -z341;
    result.rate[15] = -z373;
    result.drift[15] = z372;
    result.gap[8] = -z344;
    result.rate[16] = -z398;
    result.drift[16] = -z413;
    result.rate[17] = z457;
    result.drift[17] = -z456;
    result.gap[9] = -z415;
    result.rate[18] = -z417;
    result.drift[18] = -z418;
    result.rate[19] = -z449;
    result.drift[19] = z448;
    result.gap[10] = -z416;
    result.rate[20] = z454;
    result.drift[20] = -z484;
    result.rate[21] = z521;
    result.drift[21] = z520;
    result.gap[11] = -z485;
    result.rate[22] = z486;
    result.drift[22] = -z493;
    result.rate[23] = z547;
    result.drift[23] = z546;
    result.gap[12] = -z498;
    result.rate[24] = -z539;
    result.drift[24] = -z548;
    result.rate[25] = z598;
    result.drift[25] = -z597;
    result.gap[13] = -z557;
    result.rate[26] = -z573;
    result.drift[26] = -z587;
    result.rate[27] = -z595;
    result.drift[27] = z609;
    result.gap[14] = -z584;
    result.rate[28] = -z620;
    result.drift[28] = -z637;
    result.rate[29] = z679;
    result.drift[29] = -z678;
    result.gap[15] = -z636;
    result.rate[30] = -z638;
    result.drift[30] = -z639;
    result.rate[31] = -z671;
    result.drift[31] = z670;
    result.gap[16] = -z642;
    result.rate[32] = -z696;
    result.drift[32] = -z713;
    result.rate[33] = z755;
    result.drift[33] = -z754;
    result.gap[17] = -z712;
    result.rate[34] = -z714;
    result.drift[34] = -z715;
    result.rate[35] = -z747;
    result.drift[35] = z746;
    result.gap[18] = -z718;
    result.rate[36] = -z770;
    result.drift[36] = -z786;
    result.rate[37] = z816;
    result.drift[37] = -z819;
    result.gap[19] = -z801;
    result.rate[38] = -z784;
    result.drift[38] = -z792;
    result.rate[39] = -z820;
    result.drift[39] = z821;
    result.jacobian[0] = -z89;
    result.jacobian[1] = z132;
    result.jacobian[2] = -z105;
    result.jacobian[3] = z182;
    result.jacobian[4] = z145;
    result.jacobian[5] = z226;
    result.jacobian[6] = z172;
    result.jacobian[7] = z215;
    result.jacobian[8] = z212;
    result.jacobian[9] = z307;
    result.jacobian[10] = z277;
    result.jacobian[11] = z299;
    result.jacobian[12] = z281;
    result.jacobian[13] = z383;
    result.jacobian[14] = z353;
    result.jacobian[15] = z375;
    result.jacobian[16] = z357;
    result.jacobian[17] = z459;
    result.jacobian[18] = z410;
    result.jacobian[19] = z451;
    result.jacobian[20] = -z430;
    result.jacobian[21] = z523;
    result.jacobian[22] = -z491;
    result.jacobian[23] = z552;
    result.jacobian[24] = z500;
    result.jacobian[25] = z600;
    result.jacobian[26] = z554;
    result.jacobian[27] = z593;
    result.jacobian[28] = z582;
    result.jacobian[29] = z681;
    result.jacobian[30] = z651;
    result.jacobian[31] = z673;
    result.jacobian[32] = z655;
    result.jacobian[33] = z758;
    result.jacobian[34] = z727;
    result.jacobian[35] = z749;
    result.jacobian[36] = z731;
    result.jacobian[37] = z817;
    result.jacobian[38] = z782;
    result.jacobian[39] = z810;
    result.jacobian[40] = -z91;
    result.jacobian[41] = z133;
    result.jacobian[42] = z106;
    result.jacobian[43] = z183;
    result.jacobian[44] = z147;
    result.jacobian[45] = -z227;
    result.jacobian[46] = -z207;
    result.jacobian[47] = -z216;
    result.jacobian[48] = z213;
    result.jacobian[49] = -z308;
    result.jacobian[50] = -z278;
    result.jacobian[51] = -z300;
    result.jacobian[52] = z293;
    result.jacobian[53] = -z384;
    result.jacobian[54] = -z354;
    result.jacobian[55] = -z376;
    result.jacobian[56] = z369;
    result.jacobian[57] = -z460;
    result.jacobian[58] = -z423;
    result.jacobian[59] = -z452;
    result.jacobian[60] = z433;
    result.jacobian[61] = -z524;
    result.jacobian[62] = -z496;
    result.jacobian[63] = -z553;
    result.jacobian[64] = z515;
    result.jacobian[65] = -z601;
    result.jacobian[66] = -z579;
    result.jacobian[67] = -z594;
    result.jacobian[68] = z583;
    result.jacobian[69] = -z682;
    result.jacobian[70] = -z652;
    result.jacobian[71] = -z674;
    result.jacobian[72] = z667;
    result.jacobian[73] = -z759;
    result.jacobian[74] = -z728;
    result.jacobian[75] = -z750;
    result.jacobian[76] = z742;
    result.jacobian[77] = -z818;
    result.jacobian[78] = -z783;
    result.jacobian[79] = -z812;
  }

  /// What the surfaces of each contact are made of, in the order entry1, exit1, entry2, exit2, entry3, exit3, entry4, exit4, entry5, exit5, entry6, exit6, entry7, exit7, entry8, exit8, entry9, exit9, entry10, exit10:
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
    result.friction[6] = p_f;
    result.static_friction[6] = p_f;
    result.restitution[6] = n0;
    result.bound[6] = n0;
    result.static_bound[6] = n0;
    result.friction[7] = p_f;
    result.static_friction[7] = p_f;
    result.restitution[7] = n0;
    result.bound[7] = n0;
    result.static_bound[7] = n0;
    result.friction[8] = p_f;
    result.static_friction[8] = p_f;
    result.restitution[8] = n0;
    result.bound[8] = n0;
    result.static_bound[8] = n0;
    result.friction[9] = p_f;
    result.static_friction[9] = p_f;
    result.restitution[9] = n0;
    result.bound[9] = n0;
    result.static_bound[9] = n0;
    result.friction[10] = p_f;
    result.static_friction[10] = p_f;
    result.restitution[10] = n0;
    result.bound[10] = n0;
    result.static_bound[10] = n0;
    result.friction[11] = p_f;
    result.static_friction[11] = p_f;
    result.restitution[11] = n0;
    result.bound[11] = n0;
    result.static_bound[11] = n0;
    result.friction[12] = p_f;
    result.static_friction[12] = p_f;
    result.restitution[12] = n0;
    result.bound[12] = n0;
    result.static_bound[12] = n0;
    result.friction[13] = p_f;
    result.static_friction[13] = p_f;
    result.restitution[13] = n0;
    result.bound[13] = n0;
    result.static_bound[13] = n0;
    result.friction[14] = p_f;
    result.static_friction[14] = p_f;
    result.restitution[14] = n0;
    result.bound[14] = n0;
    result.static_bound[14] = n0;
    result.friction[15] = p_f;
    result.static_friction[15] = p_f;
    result.restitution[15] = n0;
    result.bound[15] = n0;
    result.static_bound[15] = n0;
    result.friction[16] = p_f;
    result.static_friction[16] = p_f;
    result.restitution[16] = n0;
    result.bound[16] = n0;
    result.static_bound[16] = n0;
    result.friction[17] = p_f;
    result.static_friction[17] = p_f;
    result.restitution[17] = n0;
    result.bound[17] = n0;
    result.static_bound[17] = n0;
    result.friction[18] = p_f;
    result.static_friction[18] = p_f;
    result.restitution[18] = n0;
    result.bound[18] = n0;
    result.static_bound[18] = n0;
    result.friction[19] = p_f;
    result.static_friction[19] = p_f;
    result.restitution[19] = n0;
    result.bound[19] = n0;
    result.static_bound[19] = n0;
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 4>&>(mass_matrix));
    visitor(Description::kernels[1], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[2], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[3], KernelFunction<void, Contacts&>(contacts));
    visitor(Description::kernels[4], KernelFunction<void, ContactCoefficients&>(contact_coefficients));
  }
};

}  // namespace clock_escapement
