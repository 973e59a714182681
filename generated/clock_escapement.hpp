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
//   contacts                    712             1028        220            20                  2       0   1984    2210
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
  static constexpr unsigned long long fingerprint = 0x29838f66eec38dabULL ^ torsor::support_fingerprint;
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
    const Scalar z46 = v_theta * s_theta;
    const Scalar z47 = v_psi * c_psi;
    const Scalar z48 = k10 * c_theta + z40;
    const Scalar z49 = k9 * c_theta - z41;
    const Scalar z50 = k9 * z44;
    const Scalar z51 = n0_03 * z47;
    const Scalar z52 = k10 * z44;
    const Scalar z53 = n0_03 * z45;
    const Scalar z54 = v_theta * z46;
    const Scalar z55 = v_theta * z44;
    const Scalar z56 = v_psi * z45;
    const Scalar z57 = v_psi * z47;
    const Scalar z58 = k11 - z43;
    const Scalar z59 = k10 * c_theta - z40;
    const Scalar z60 = k10 * z46 - z50;
    const Scalar z61 = k9 * z46 + z52;
    const Scalar z62 = k9 * z54;
    const Scalar z63 = n0_03 * z56;
    const Scalar z64 = k10 * z54;
    const Scalar z65 = n0_03 * z57;
    const Scalar z66 = k11 - z49;
    const Scalar z67 = k9 * c_theta + z41;
    const Scalar z68 = z48 + z42;
    const Scalar z69 = k11 - z67;
    const Scalar z70 = z42 - z59;
    const Scalar z71 = k10 * z55 + z62;
    const Scalar z72 = k9 * z55 - z64;
    const Scalar z73 = z66 - z43;
    const Scalar z74 = z60 - z51;
    const Scalar z75 = z61 + z53;
    const Scalar z76 = z43 - z69;
    const Scalar z77 = z68 * z68 + z73 * z73;
    const Scalar z78 = n2 * (z43 * z68 + z42 * z73);
    const Scalar z79 = n2 * (z49 * z68 + z48 * z73);
    const Scalar z80 = n2 * (z68 * z74 - z73 * z75);
    const Scalar z81 = z71 + z63;
    const Scalar z82 = z72 + z65;
    const Scalar z83 = z70 * z70 + z76 * z76;
    const Scalar z84 = n2 * (z68 * z81 - z73 * z82 - z74 * z74 - z75 * z75);
    const Scalar z85 = traits::sqrt(z77);
    const Scalar z86 = traits::sqrt(z83);
    const Scalar z87 = n0_0066 - z85;
    const Scalar z88 = n2 * (z42 * z76 - z43 * z70);
    const Scalar z89 = n0_5 * z78 / z85;
    const Scalar z90 = n2 * (z67 * z70 + z59 * z76);
    const Scalar z91 = n0_5 * z79 / z85;
    const Scalar z92 = k10 * z46 + z50;
    const Scalar z93 = k9 * z46 - z52;
    const Scalar z94 = k10 * z55 - z62;
    const Scalar z95 = k9 * z55 + z64;
    const Scalar z96 = z51 + z92;
    const Scalar z97 = z53 + z93;
    const Scalar z98 = n2 * (z70 * z96 - z76 * z97);
    const Scalar z99 = z63 - z94;
    const Scalar z100 = z65 + z95;
    const Scalar z101 = n2 * (z70 * z99 + z76 * z100 - z96 * z96 - z97 * z97);
    const Scalar z102 = n0_5 * z80 / z85;
    const Scalar z103 = z68 / z85;
    const Scalar z104 = z73 / z85;
    const Scalar z105 = n0_0066 - z86;
    const Scalar z106 = n0_5 * z88 / z86;
    const Scalar z107 = n0_5 * z90 / z86;
    const Scalar z108 = n0_5 * z98 / z86;
    const Scalar z109 = z70 / z86;
    const Scalar z110 = z76 / z86;
    const Scalar z111 = n0_5 * (z80 * z102 / (z85 * z85) + z84 / z85);
    const Scalar z112 = s_psi * z25 + c_psi * z24;
    const Scalar z113 = z42 - n0_0016 * z103;
    const Scalar z114 = s_psi * z24 - c_psi * z25;
    const Scalar z115 = z43 + n0_0016 * z104;
    const Scalar z116 = z48 + z112;
    const Scalar z117 = z66 + z114;
    const Scalar z118 = n0_0016 * z104 - z58;
    const Scalar z119 = z116 * z116 + z117 * z117;
    const Scalar z120 = z68 * z102 / (z85 * z85) - z74 / z85;
    const Scalar z121 = z73 * z102 / (z85 * z85) + z75 / z85;
    const Scalar z122 = n0_5 * (z98 * z108 / (z86 * z86) + z101 / z86);
    const Scalar z123 = z70 * z108 / (z86 * z86) - z96 / z86;
    const Scalar z124 = z76 * z108 / (z86 * z86) + z97 / z86;
    const Scalar z125 = z58 + n0_0016 * z110;
    const Scalar z126 = z113 * (v_psi - v_theta);
    const Scalar z127 = z103 * z113;
    const Scalar z128 = z104 * z115 - z127;
    const Scalar z129 = z104 * z118 - z127;
    const Scalar z130 = v_psi * z115 - v_theta * z118;
    const Scalar z131 = traits::sqrt(z119);
    const Scalar z132 = z103 * z126 - z104 * z130;
    const Scalar z133 = z24 * z45 - z25 * z47;
    const Scalar z134 = n0_0066 - z131;
    const Scalar z135 = n2 * (z112 * z117 - z114 * z116);
    const Scalar z136 = n0_5 * z135 / z131;
    const Scalar z137 = z51 + n0_0016 * z123;
    const Scalar z138 = n2 * (z49 * z116 + z48 * z117);
    const Scalar z139 = n0_5 * z138 / z131;
    const Scalar z140 = z137 * (v_psi - v_theta);
    const Scalar z141 = z43 - n0_0016 * z110;
    const Scalar z142 = z53 - n0_0016 * z124;
    const Scalar z143 = z142 * (v_psi - v_theta);
    const Scalar z144 = z51 - n0_0016 * z120;
    const Scalar z145 = z144 * (v_psi - v_theta);
    const Scalar z146 = z60 + z133;
    const Scalar z147 = z24 * z47 + z25 * z45;
    const Scalar z148 = z61 + z147;
    const Scalar z149 = z42 - n0_0016 * z109;
    const Scalar z150 = v_psi * z141 + v_theta * z125;
    const Scalar z151 = z53 - n0_0016 * z121;
    const Scalar z152 = z151 * (v_psi - v_theta);
    const Scalar z153 = n2 * (z116 * z146 - z117 * z148);
    const Scalar z154 = z126 * z120 - z130 * z121 + z103 * z145 + z104 * z152;
    const Scalar z155 = z59 - z112;
    const Scalar z156 = z69 + z114;
    const Scalar z157 = z155 * z155 + z156 * z156;
    const Scalar z158 = n0_5 * z153 / z131;
    const Scalar z159 = z24 * z57 + z25 * z56;
    const Scalar z160 = z71 + z159;
    const Scalar z161 = z24 * z56 - z25 * z57;
    const Scalar z162 = z72 - z161;
    const Scalar z163 = traits::sqrt(z157);
    const Scalar z164 = k11 + z114;
    const Scalar z165 = z117 / z131;
    const Scalar z166 = n2 * (z114 * z155 + z112 * z156);
    const Scalar z167 = n2 * (z116 * z160 - z117 * z162 - z146 * z146 - z148 * z148);
    const Scalar z168 = z116 / z131;
    const Scalar z169 = z116 * z158 / (z131 * z131) - z146 / z131;
    const Scalar z170 = z117 * z158 / (z131 * z131) + z148 / z131;
    const Scalar z171 = z114 - n0_0016 * z165;
    const Scalar z172 = n0_0016 * z165 - z164;
    const Scalar z173 = z112 - n0_0016 * z168;
    const Scalar z174 = v_psi * z171 + v_theta * z172;
    const Scalar z175 = z149 * (v_psi - v_theta);
    const Scalar z176 = z109 * z140 - z110 * z143 - z150 * z124 - z175 * z123;
    const Scalar z177 = n0_5 * (z153 * z158 / (z131 * z131) + z167 / z131);
    const Scalar z178 = z109 * z175 + z110 * z150;
    const Scalar z179 = z109 * z149;
    const Scalar z180 = z110 * z141 + z179;
    const Scalar z181 = z110 * z125 - z179;
    const Scalar z182 = n0_5 * z166 / z163;
    const Scalar z183 = z94 - z159;
    const Scalar z184 = z95 - z161;
    const Scalar z185 = n0_0066 - z163;
    const Scalar z186 = s_psi * z27 + c_psi * z26;
    const Scalar z187 = s_psi * z26 - c_psi * z27;
    const Scalar z188 = z48 + z186;
    const Scalar z189 = z66 + z187;
    const Scalar z190 = z26 * z45 - z27 * z47;
    const Scalar z191 = z60 + z190;
    const Scalar z192 = z188 * z188 + z189 * z189;
    const Scalar z193 = z92 - z133;
    const Scalar z194 = z93 + z147;
    const Scalar z195 = n2 * (z155 * z183 - z156 * z184 - z193 * z193 - z194 * z194);
    const Scalar z196 = traits::sqrt(z192);
    const Scalar z197 = n2 * (z155 * z193 - z156 * z194);
    const Scalar z198 = z156 / z163;
    const Scalar z199 = z114 - n0_0016 * z198;
    const Scalar z200 = z164 - n0_0016 * z198;
    const Scalar z201 = z155 / z163;
    const Scalar z202 = z112 + n0_0016 * z201;
    const Scalar z203 = n0_5 * z197 / z163;
    const Scalar z204 = z133 + n0_0016 * z169;
    const Scalar z205 = z204 * (v_psi - v_theta);
    const Scalar z206 = n2 * (z67 * z155 + z59 * z156);
    const Scalar z207 = n0_5 * z206 / z163;
    const Scalar z208 = n2 * (z186 * z189 - z187 * z188);
    const Scalar z209 = n2 * (z49 * z188 + z48 * z189);
    const Scalar z210 = z147 - n0_0016 * z170;
    const Scalar z211 = n0_5 * z208 / z196;
    const Scalar z212 = n0_5 * z209 / z196;
    const Scalar z213 = z210 * (v_psi - v_theta);
    const Scalar z214 = n0_0066 - z196;
    const Scalar z215 = v_psi * z199 - v_theta * z200;
    const Scalar z216 = n0_5 * (z197 * z203 / (z163 * z163) + z195 / z163);
    const Scalar z217 = z155 * z203 / (z163 * z163) - z193 / z163;
    const Scalar z218 = z156 * z203 / (z163 * z163) + z194 / z163;
    const Scalar z219 = z202 * (v_psi - v_theta);
    const Scalar z220 = z201 * z202;
    const Scalar z221 = z198 * z199 - z220;
    const Scalar z222 = z198 * z200 - z220;
    const Scalar z223 = z201 * z219 - z198 * z215;
    const Scalar z224 = z173 * (v_psi - v_theta);
    const Scalar z225 = z168 * z205 - z165 * z213 - z174 * z170 - z224 * z169;
    const Scalar z226 = z168 * z224 + z165 * z174;
    const Scalar z227 = z168 * z173;
    const Scalar z228 = z165 * z171 + z227;
    const Scalar z229 = z165 * z172 - z227;
    const Scalar z230 = z133 - n0_0016 * z217;
    const Scalar z231 = z230 * (v_psi - v_theta);
    const Scalar z232 = z147 - n0_0016 * z218;
    const Scalar z233 = z232 * (v_psi - v_theta);
    const Scalar z234 = z59 - z186;
    const Scalar z235 = z69 + z187;
    const Scalar z236 = z26 * z47 + z27 * z45;
    const Scalar z237 = z215 * z218 - z219 * z217 + z201 * z231 + z198 * z233;
    const Scalar z238 = z234 * z234 + z235 * z235;
    const Scalar z239 = traits::sqrt(z238);
    const Scalar z240 = z61 + z236;
    const Scalar z241 = z92 - z190;
    const Scalar z242 = n2 * (z188 * z191 - z189 * z240);
    const Scalar z243 = z93 + z236;
    const Scalar z244 = n2 * (z234 * z241 - z235 * z243);
    const Scalar z245 = z26 * z57 + z27 * z56;
    const Scalar z246 = z71 + z245;
    const Scalar z247 = z94 - z245;
    const Scalar z248 = n0_5 * z242 / z196;
    const Scalar z249 = s_psi * z29 + c_psi * z28;
    const Scalar z250 = s_psi * z28 - c_psi * z29;
    const Scalar z251 = z26 * z56 - z27 * z57;
    const Scalar z252 = z48 + z249;
    const Scalar z253 = z72 - z251;
    const Scalar z254 = z95 - z251;
    const Scalar z255 = z66 + z250;
    const Scalar z256 = k11 + z187;
    const Scalar z257 = z189 / z196;
    const Scalar z258 = n2 * (z188 * z246 - z189 * z253 - z191 * z191 - z240 * z240);
    const Scalar z259 = n2 * (z234 * z247 - z235 * z254 - z241 * z241 - z243 * z243);
    const Scalar z260 = z189 * z248 / (z196 * z196) + z240 / z196;
    const Scalar z261 = z188 * z248 / (z196 * z196) - z191 / z196;
    const Scalar z262 = z188 / z196;
    const Scalar z263 = n0_0066 - z239;
    const Scalar z264 = z252 * z252 + z255 * z255;
    const Scalar z265 = n0_5 * (z242 * z248 / (z196 * z196) + z258 / z196);
    const Scalar z266 = traits::sqrt(z264);
    const Scalar z267 = n0_5 * z244 / z239;
    const Scalar z268 = n0_5 * (z244 * z267 / (z239 * z239) + z259 / z239);
    const Scalar z269 = z234 * z267 / (z239 * z239) - z241 / z239;
    const Scalar z270 = z235 * z267 / (z239 * z239) + z243 / z239;
    const Scalar z271 = z235 / z239;
    const Scalar z272 = z187 - n0_0016 * z271;
    const Scalar z273 = z234 / z239;
    const Scalar z274 = z256 - n0_0016 * z271;
    const Scalar z275 = n0_0016 * z257 - z256;
    const Scalar z276 = z190 + n0_0016 * z261;
    const Scalar z277 = z276 * (v_psi - v_theta);
    const Scalar z278 = n0_0066 - z266;
    const Scalar z279 = n2 * (z187 * z234 + z186 * z235);
    const Scalar z280 = n2 * (z67 * z234 + z59 * z235);
    const Scalar z281 = n0_5 * z279 / z239;
    const Scalar z282 = n0_5 * z280 / z239;
    const Scalar z283 = z187 - n0_0016 * z257;
    const Scalar z284 = z190 - n0_0016 * z269;
    const Scalar z285 = n2 * (z249 * z255 - z250 * z252);
    const Scalar z286 = z284 * (v_psi - v_theta);
    const Scalar z287 = z236 - n0_0016 * z260;
    const Scalar z288 = z287 * (v_psi - v_theta);
    const Scalar z289 = z236 - n0_0016 * z270;
    const Scalar z290 = z289 * (v_psi - v_theta);
    const Scalar z291 = z186 + n0_0016 * z273;
    const Scalar z292 = z186 - n0_0016 * z262;
    const Scalar z293 = n0_5 * z285 / z266;
    const Scalar z294 = z28 * z45 - z29 * z47;
    const Scalar z295 = n2 * (z49 * z252 + z48 * z255);
    const Scalar z296 = n0_5 * z295 / z266;
    const Scalar z297 = v_psi * z272 - v_theta * z274;
    const Scalar z298 = z291 * (v_psi - v_theta);
    const Scalar z299 = z297 * z270 - z298 * z269 + z273 * z286 + z271 * z290;
    const Scalar z300 = z273 * z298 - z271 * z297;
    const Scalar z301 = z273 * z291;
    const Scalar z302 = z271 * z272 - z301;
    const Scalar z303 = z271 * z274 - z301;
    const Scalar z304 = v_psi * z283 + v_theta * z275;
    const Scalar z305 = z60 + z294;
    const Scalar z306 = z292 * (v_psi - v_theta);
    const Scalar z307 = z262 * z277 - z257 * z288 - z304 * z260 - z306 * z261;
    const Scalar z308 = z262 * z306 + z257 * z304;
    const Scalar z309 = z262 * z292;
    const Scalar z310 = z257 * z283 + z309;
    const Scalar z311 = z257 * z275 - z309;
    const Scalar z312 = z59 - z249;
    const Scalar z313 = z69 + z250;
    const Scalar z314 = z28 * z47 + z29 * z45;
    const Scalar z315 = z312 * z312 + z313 * z313;
    const Scalar z316 = z61 + z314;
    const Scalar z317 = z92 - z294;
    const Scalar z318 = z93 + z314;
    const Scalar z319 = n2 * (z252 * z305 - z255 * z316);
    const Scalar z320 = traits::sqrt(z315);
    const Scalar z321 = n2 * (z312 * z317 - z313 * z318);
    const Scalar z322 = z28 * z57 + z29 * z56;
    const Scalar z323 = z71 + z322;
    const Scalar z324 = z94 - z322;
    const Scalar z325 = n0_5 * z319 / z266;
    const Scalar z326 = s_psi * z31 + c_psi * z30;
    const Scalar z327 = s_psi * z30 - c_psi * z31;
    const Scalar z328 = z28 * z56 - z29 * z57;
    const Scalar z329 = z48 + z326;
    const Scalar z330 = z72 - z328;
    const Scalar z331 = z95 - z328;
    const Scalar z332 = z66 + z327;
    const Scalar z333 = k11 + z250;
    const Scalar z334 = z255 / z266;
    const Scalar z335 = n2 * (z252 * z323 - z255 * z330 - z305 * z305 - z316 * z316);
    const Scalar z336 = n2 * (z312 * z324 - z313 * z331 - z317 * z317 - z318 * z318);
    const Scalar z337 = z255 * z325 / (z266 * z266) + z316 / z266;
    const Scalar z338 = z252 * z325 / (z266 * z266) - z305 / z266;
    const Scalar z339 = z252 / z266;
    const Scalar z340 = n0_0066 - z320;
    const Scalar z341 = z329 * z329 + z332 * z332;
    const Scalar z342 = n0_5 * (z319 * z325 / (z266 * z266) + z335 / z266);
    const Scalar z343 = traits::sqrt(z341);
    const Scalar z344 = n0_5 * z321 / z320;
    const Scalar z345 = n0_5 * (z321 * z344 / (z320 * z320) + z336 / z320);
    const Scalar z346 = z312 * z344 / (z320 * z320) - z317 / z320;
    const Scalar z347 = z313 * z344 / (z320 * z320) + z318 / z320;
    const Scalar z348 = z313 / z320;
    const Scalar z349 = z250 - n0_0016 * z348;
    const Scalar z350 = z312 / z320;
    const Scalar z351 = z333 - n0_0016 * z348;
    const Scalar z352 = n0_0016 * z334 - z333;
    const Scalar z353 = z294 + n0_0016 * z338;
    const Scalar z354 = z353 * (v_psi - v_theta);
    const Scalar z355 = n0_0066 - z343;
    const Scalar z356 = n2 * (z250 * z312 + z249 * z313);
    const Scalar z357 = n2 * (z67 * z312 + z59 * z313);
    const Scalar z358 = n0_5 * z356 / z320;
    const Scalar z359 = n0_5 * z357 / z320;
    const Scalar z360 = z250 - n0_0016 * z334;
    const Scalar z361 = z294 - n0_0016 * z346;
    const Scalar z362 = n2 * (z326 * z332 - z327 * z329);
    const Scalar z363 = z361 * (v_psi - v_theta);
    const Scalar z364 = z314 - n0_0016 * z337;
    const Scalar z365 = z364 * (v_psi - v_theta);
    const Scalar z366 = z314 - n0_0016 * z347;
    const Scalar z367 = z366 * (v_psi - v_theta);
    const Scalar z368 = z249 + n0_0016 * z350;
    const Scalar z369 = z249 - n0_0016 * z339;
    const Scalar z370 = n0_5 * z362 / z343;
    const Scalar z371 = z30 * z45 - z31 * z47;
    const Scalar z372 = n2 * (z49 * z329 + z48 * z332);
    const Scalar z373 = n0_5 * z372 / z343;
    const Scalar z374 = v_psi * z349 - v_theta * z351;
    const Scalar z375 = z368 * (v_psi - v_theta);
    const Scalar z376 = z374 * z347 - z375 * z346 + z350 * z363 + z348 * z367;
    const Scalar z377 = z350 * z375 - z348 * z374;
    const Scalar z378 = z350 * z368;
    const Scalar z379 = z348 * z349 - z378;
    const Scalar z380 = z348 * z351 - z378;
    const Scalar z381 = v_psi * z360 + v_theta * z352;
    const Scalar z382 = z60 + z371;
    const Scalar z383 = z369 * (v_psi - v_theta);
    const Scalar z384 = z339 * z354 - z334 * z365 - z381 * z337 - z383 * z338;
    const Scalar z385 = z339 * z383 + z334 * z381;
    const Scalar z386 = z339 * z369;
    const Scalar z387 = z334 * z360 + z386;
    const Scalar z388 = z334 * z352 - z386;
    const Scalar z389 = z59 - z326;
    const Scalar z390 = z69 + z327;
    const Scalar z391 = z30 * z47 + z31 * z45;
    const Scalar z392 = z389 * z389 + z390 * z390;
    const Scalar z393 = z61 + z391;
    const Scalar z394 = z92 - z371;
    const Scalar z395 = z93 + z391;
    const Scalar z396 = n2 * (z329 * z382 - z332 * z393);
    const Scalar z397 = traits::sqrt(z392);
    const Scalar z398 = n2 * (z389 * z394 - z390 * z395);
    const Scalar z399 = z30 * z57 + z31 * z56;
    const Scalar z400 = z71 + z399;
    const Scalar z401 = z94 - z399;
    const Scalar z402 = n0_5 * z396 / z343;
    const Scalar z403 = z48 - z42;
    const Scalar z404 = z66 + z43;
    const Scalar z405 = z30 * z56 - z31 * z57;
    const Scalar z406 = z403 * z403 + z404 * z404;
    const Scalar z407 = z72 - z405;
    const Scalar z408 = z95 - z405;
    const Scalar z409 = k11 + z327;
    const Scalar z410 = n2 * (z329 * z400 - z332 * z407 - z382 * z382 - z393 * z393);
    const Scalar z411 = n2 * (z389 * z401 - z390 * z408 - z394 * z394 - z395 * z395);
    const Scalar z412 = traits::sqrt(z406);
    const Scalar z413 = n0_0066 - z397;
    const Scalar z414 = n0_5 * z398 / z397;
    const Scalar z415 = z329 * z402 / (z343 * z343) - z382 / z343;
    const Scalar z416 = z332 * z402 / (z343 * z343) + z393 / z343;
    const Scalar z417 = n0_5 * (z396 * z402 / (z343 * z343) + z410 / z343);
    const Scalar z418 = z332 / z343;
    const Scalar z419 = z329 / z343;
    const Scalar z420 = z390 / z397;
    const Scalar z421 = n0_5 * (z398 * z414 / (z397 * z397) + z411 / z397);
    const Scalar z422 = z389 * z414 / (z397 * z397) - z394 / z397;
    const Scalar z423 = z390 * z414 / (z397 * z397) + z395 / z397;
    const Scalar z424 = n0_0066 - z412;
    const Scalar z425 = z327 - n0_0016 * z420;
    const Scalar z426 = z389 / z397;
    const Scalar z427 = z409 - n0_0016 * z420;
    const Scalar z428 = n0_0016 * z418 - z409;
    const Scalar z429 = z371 + n0_0016 * z415;
    const Scalar z430 = z429 * (v_psi - v_theta);
    const Scalar z431 = n2 * (z327 * z389 + z326 * z390);
    const Scalar z432 = n2 * (z67 * z389 + z59 * z390);
    const Scalar z433 = n0_5 * z431 / z397;
    const Scalar z434 = n0_5 * z432 / z397;
    const Scalar z435 = z327 - n0_0016 * z418;
    const Scalar z436 = z371 - n0_0016 * z422;
    const Scalar z437 = n2 * (z43 * z403 + z42 * z404);
    const Scalar z438 = n0_5 * z437 / z412;
    const Scalar z439 = z436 * (v_psi - v_theta);
    const Scalar z440 = n2 * (z49 * z403 + z48 * z404);
    const Scalar z441 = z391 - n0_0016 * z416;
    const Scalar z442 = z441 * (v_psi - v_theta);
    const Scalar z443 = z391 - n0_0016 * z423;
    const Scalar z444 = z443 * (v_psi - v_theta);
    const Scalar z445 = z326 + n0_0016 * z426;
    const Scalar z446 = z326 - n0_0016 * z419;
    const Scalar z447 = n0_5 * z440 / z412;
    const Scalar z448 = z60 + z51;
    const Scalar z449 = z61 - z53;
    const Scalar z450 = n2 * (z403 * z448 - z404 * z449);
    const Scalar z451 = v_psi * z425 - v_theta * z427;
    const Scalar z452 = z445 * (v_psi - v_theta);
    const Scalar z453 = z451 * z423 - z452 * z422 + z426 * z439 + z420 * z444;
    const Scalar z454 = z426 * z452 - z420 * z451;
    const Scalar z455 = z426 * z445;
    const Scalar z456 = z420 * z425 - z455;
    const Scalar z457 = z420 * z427 - z455;
    const Scalar z458 = v_psi * z435 + v_theta * z428;
    const Scalar z459 = n0_5 * z450 / z412;
    const Scalar z460 = z446 * (v_psi - v_theta);
    const Scalar z461 = z419 * z430 - z418 * z442 - z458 * z416 - z460 * z415;
    const Scalar z462 = z419 * z460 + z418 * z458;
    const Scalar z463 = z419 * z446;
    const Scalar z464 = z418 * z435 + z463;
    const Scalar z465 = z418 * z428 - z463;
    const Scalar z466 = s_psi * z33 + c_psi * z32;
    const Scalar z467 = z42 + z59;
    const Scalar z468 = s_psi * z32 - c_psi * z33;
    const Scalar z469 = z43 + z69;
    const Scalar z470 = z467 * z467 + z469 * z469;
    const Scalar z471 = z51 - z92;
    const Scalar z472 = z53 - z93;
    const Scalar z473 = n2 * (z467 * z471 - z469 * z472);
    const Scalar z474 = z71 - z63;
    const Scalar z475 = traits::sqrt(z470);
    const Scalar z476 = z63 + z94;
    const Scalar z477 = z48 + z466;
    const Scalar z478 = z72 - z65;
    const Scalar z479 = n2 * (z403 * z474 - z404 * z478 - z448 * z448 - z449 * z449);
    const Scalar z480 = z65 - z95;
    const Scalar z481 = n2 * (z467 * z476 + z469 * z480 - z471 * z471 - z472 * z472);
    const Scalar z482 = z403 * z459 / (z412 * z412) - z448 / z412;
    const Scalar z483 = z403 / z412;
    const Scalar z484 = z404 * z459 / (z412 * z412) + z449 / z412;
    const Scalar z485 = z404 / z412;
    const Scalar z486 = z66 + z468;
    const Scalar z487 = z477 * z477 + z486 * z486;
    const Scalar z488 = n0_5 * (z450 * z459 / (z412 * z412) + z479 / z412);
    const Scalar z489 = traits::sqrt(z487);
    const Scalar z490 = n0_0066 - z475;
    const Scalar z491 = n0_5 * z473 / z475;
    const Scalar z492 = k11 + z43;
    const Scalar z493 = z43 - n0_0016 * z485;
    const Scalar z494 = z469 / z475;
    const Scalar z495 = z42 + n0_0016 * z483;
    const Scalar z496 = n0_0016 * z485 - z492;
    const Scalar z497 = z32 * z45 - z33 * z47;
    const Scalar z498 = n2 * (z42 * z469 - z43 * z467);
    const Scalar z499 = n0_5 * (z473 * z491 / (z475 * z475) + z481 / z475);
    const Scalar z500 = n0_5 * z498 / z475;
    const Scalar z501 = z467 * z491 / (z475 * z475) - z471 / z475;
    const Scalar z502 = z469 * z491 / (z475 * z475) + z472 / z475;
    const Scalar z503 = n2 * (z67 * z467 + z59 * z469);
    const Scalar z504 = n0_5 * z503 / z475;
    const Scalar z505 = z467 / z475;
    const Scalar z506 = z43 - n0_0016 * z494;
    const Scalar z507 = z492 - n0_0016 * z494;
    const Scalar z508 = z42 - n0_0016 * z505;
    const Scalar z509 = n0_0066 - z489;
    const Scalar z510 = n2 * (z466 * z486 - z468 * z477);
    const Scalar z511 = n0_5 * z510 / z489;
    const Scalar z512 = z51 + n0_0016 * z501;
    const Scalar z513 = z51 + n0_0016 * z482;
    const Scalar z514 = z513 * (v_psi - v_theta);
    const Scalar z515 = n2 * (z49 * z477 + z48 * z486);
    const Scalar z516 = n0_5 * z515 / z489;
    const Scalar z517 = z512 * (v_psi - v_theta);
    const Scalar z518 = z495 * (v_psi - v_theta);
    const Scalar z519 = z483 * z495;
    const Scalar z520 = z485 * z493 - z519;
    const Scalar z521 = z485 * z496 + z519;
    const Scalar z522 = v_psi * z493 + v_theta * z496;
    const Scalar z523 = z483 * z518 - z485 * z522;
    const Scalar z524 = z60 + z497;
    const Scalar z525 = z32 * z47 + z33 * z45;
    const Scalar z526 = z61 + z525;
    const Scalar z527 = z32 * z57 + z33 * z56;
    const Scalar z528 = z71 + z527;
    const Scalar z529 = z32 * z56 - z33 * z57;
    const Scalar z530 = n2 * (z477 * z524 - z486 * z526);
    const Scalar z531 = z72 - z529;
    const Scalar z532 = z53 - n0_0016 * z502;
    const Scalar z533 = n2 * (z477 * z528 - z486 * z531 - z524 * z524 - z526 * z526);
    const Scalar z534 = z532 * (v_psi - v_theta);
    const Scalar z535 = z53 + n0_0016 * z484;
    const Scalar z536 = z535 * (v_psi - v_theta);
    const Scalar z537 = n0_5 * z530 / z489;
    const Scalar z538 = z477 / z489;
    const Scalar z539 = v_psi * z506 - v_theta * z507;
    const Scalar z540 = z518 * z482 - z522 * z484 + z483 * z514 + z485 * z536;
    const Scalar z541 = z59 - z466;
    const Scalar z542 = z69 + z468;
    const Scalar z543 = z541 * z541 + z542 * z542;
    const Scalar z544 = k11 + z468;
    const Scalar z545 = z486 / z489;
    const Scalar z546 = n2 * (z468 * z541 + z466 * z542);
    const Scalar z547 = n0_5 * (z530 * z537 / (z489 * z489) + z533 / z489);
    const Scalar z548 = z477 * z537 / (z489 * z489) - z524 / z489;
    const Scalar z549 = z486 * z537 / (z489 * z489) + z526 / z489;
    const Scalar z550 = traits::sqrt(z543);
    const Scalar z551 = z468 - n0_0016 * z545;
    const Scalar z552 = n0_0016 * z545 - z544;
    const Scalar z553 = z466 - n0_0016 * z538;
    const Scalar z554 = v_psi * z551 + v_theta * z552;
    const Scalar z555 = z508 * (v_psi - v_theta);
    const Scalar z556 = z505 * z517 - z494 * z534 - z539 * z502 - z555 * z501;
    const Scalar z557 = z505 * z555 + z494 * z539;
    const Scalar z558 = z505 * z508;
    const Scalar z559 = z494 * z506 + z558;
    const Scalar z560 = z494 * z507 + z558;
    const Scalar z561 = n0_5 * z546 / z550;
    const Scalar z562 = z94 - z527;
    const Scalar z563 = z95 - z529;
    const Scalar z564 = n0_0066 - z550;
    const Scalar z565 = s_psi * z35 + c_psi * z34;
    const Scalar z566 = s_psi * z34 - c_psi * z35;
    const Scalar z567 = z48 + z565;
    const Scalar z568 = z66 + z566;
    const Scalar z569 = z34 * z45 - z35 * z47;
    const Scalar z570 = z60 + z569;
    const Scalar z571 = z567 * z567 + z568 * z568;
    const Scalar z572 = z92 - z497;
    const Scalar z573 = z93 + z525;
    const Scalar z574 = n2 * (z541 * z562 - z542 * z563 - z572 * z572 - z573 * z573);
    const Scalar z575 = traits::sqrt(z571);
    const Scalar z576 = n2 * (z541 * z572 - z542 * z573);
    const Scalar z577 = z542 / z550;
    const Scalar z578 = z468 - n0_0016 * z577;
    const Scalar z579 = z544 - n0_0016 * z577;
    const Scalar z580 = z541 / z550;
    const Scalar z581 = z466 + n0_0016 * z580;
    const Scalar z582 = n0_5 * z576 / z550;
    const Scalar z583 = z497 + n0_0016 * z548;
    const Scalar z584 = z583 * (v_psi - v_theta);
    const Scalar z585 = n2 * (z67 * z541 + z59 * z542);
    const Scalar z586 = n0_5 * z585 / z550;
    const Scalar z587 = n2 * (z565 * z568 - z566 * z567);
    const Scalar z588 = n2 * (z49 * z567 + z48 * z568);
    const Scalar z589 = z525 - n0_0016 * z549;
    const Scalar z590 = n0_5 * z587 / z575;
    const Scalar z591 = n0_5 * z588 / z575;
    const Scalar z592 = z589 * (v_psi - v_theta);
    const Scalar z593 = n0_0066 - z575;
    const Scalar z594 = v_psi * z578 - v_theta * z579;
    const Scalar z595 = n0_5 * (z576 * z582 / (z550 * z550) + z574 / z550);
    const Scalar z596 = z541 * z582 / (z550 * z550) - z572 / z550;
    const Scalar z597 = z542 * z582 / (z550 * z550) + z573 / z550;
    const Scalar z598 = z581 * (v_psi - v_theta);
    const Scalar z599 = z580 * z581;
    const Scalar z600 = z577 * z578 - z599;
    const Scalar z601 = z577 * z579 - z599;
    const Scalar z602 = z580 * z598 - z577 * z594;
    const Scalar z603 = z553 * (v_psi - v_theta);
    const Scalar z604 = z538 * z584 - z545 * z592 - z554 * z549 - z603 * z548;
    const Scalar z605 = z538 * z603 + z545 * z554;
    const Scalar z606 = z538 * z553;
    const Scalar z607 = z545 * z551 + z606;
    const Scalar z608 = z545 * z552 - z606;
    const Scalar z609 = z497 - n0_0016 * z596;
    const Scalar z610 = z609 * (v_psi - v_theta);
    const Scalar z611 = z525 - n0_0016 * z597;
    const Scalar z612 = z611 * (v_psi - v_theta);
    const Scalar z613 = z59 - z565;
    const Scalar z614 = z69 + z566;
    const Scalar z615 = z34 * z47 + z35 * z45;
    const Scalar z616 = z594 * z597 - z598 * z596 + z580 * z610 + z577 * z612;
    const Scalar z617 = z613 * z613 + z614 * z614;
    const Scalar z618 = traits::sqrt(z617);
    const Scalar z619 = z61 + z615;
    const Scalar z620 = z92 - z569;
    const Scalar z621 = n2 * (z567 * z570 - z568 * z619);
    const Scalar z622 = z93 + z615;
    const Scalar z623 = n2 * (z613 * z620 - z614 * z622);
    const Scalar z624 = z34 * z57 + z35 * z56;
    const Scalar z625 = z71 + z624;
    const Scalar z626 = z94 - z624;
    const Scalar z627 = n0_5 * z621 / z575;
    const Scalar z628 = s_psi * z37 + c_psi * z36;
    const Scalar z629 = s_psi * z36 - c_psi * z37;
    const Scalar z630 = z34 * z56 - z35 * z57;
    const Scalar z631 = z48 + z628;
    const Scalar z632 = z72 - z630;
    const Scalar z633 = z95 - z630;
    const Scalar z634 = z66 + z629;
    const Scalar z635 = k11 + z566;
    const Scalar z636 = z568 / z575;
    const Scalar z637 = n2 * (z567 * z625 - z568 * z632 - z570 * z570 - z619 * z619);
    const Scalar z638 = n2 * (z613 * z626 - z614 * z633 - z620 * z620 - z622 * z622);
    const Scalar z639 = z568 * z627 / (z575 * z575) + z619 / z575;
    const Scalar z640 = z567 * z627 / (z575 * z575) - z570 / z575;
    const Scalar z641 = z567 / z575;
    const Scalar z642 = n0_0066 - z618;
    const Scalar z643 = z631 * z631 + z634 * z634;
    const Scalar z644 = n0_5 * (z621 * z627 / (z575 * z575) + z637 / z575);
    const Scalar z645 = traits::sqrt(z643);
    const Scalar z646 = n0_5 * z623 / z618;
    const Scalar z647 = n0_5 * (z623 * z646 / (z618 * z618) + z638 / z618);
    const Scalar z648 = z613 * z646 / (z618 * z618) - z620 / z618;
    const Scalar z649 = z614 * z646 / (z618 * z618) + z622 / z618;
    const Scalar z650 = z614 / z618;
    const Scalar z651 = z566 - n0_0016 * z650;
    const Scalar z652 = z613 / z618;
    const Scalar z653 = z635 - n0_0016 * z650;
    const Scalar z654 = n0_0016 * z636 - z635;
    const Scalar z655 = z569 + n0_0016 * z640;
    const Scalar z656 = z655 * (v_psi - v_theta);
    const Scalar z657 = n0_0066 - z645;
    const Scalar z658 = n2 * (z566 * z613 + z565 * z614);
    const Scalar z659 = n2 * (z67 * z613 + z59 * z614);
    const Scalar z660 = n0_5 * z658 / z618;
    const Scalar z661 = n0_5 * z659 / z618;
    const Scalar z662 = z566 - n0_0016 * z636;
    const Scalar z663 = z569 - n0_0016 * z648;
    const Scalar z664 = n2 * (z628 * z634 - z629 * z631);
    const Scalar z665 = z663 * (v_psi - v_theta);
    const Scalar z666 = z615 - n0_0016 * z639;
    const Scalar z667 = z666 * (v_psi - v_theta);
    const Scalar z668 = z615 - n0_0016 * z649;
    const Scalar z669 = z668 * (v_psi - v_theta);
    const Scalar z670 = z565 + n0_0016 * z652;
    const Scalar z671 = z565 - n0_0016 * z641;
    const Scalar z672 = n0_5 * z664 / z645;
    const Scalar z673 = z36 * z45 - z37 * z47;
    const Scalar z674 = n2 * (z49 * z631 + z48 * z634);
    const Scalar z675 = n0_5 * z674 / z645;
    const Scalar z676 = v_psi * z651 - v_theta * z653;
    const Scalar z677 = z670 * (v_psi - v_theta);
    const Scalar z678 = z676 * z649 - z677 * z648 + z652 * z665 + z650 * z669;
    const Scalar z679 = z652 * z677 - z650 * z676;
    const Scalar z680 = z652 * z670;
    const Scalar z681 = z650 * z651 - z680;
    const Scalar z682 = z650 * z653 - z680;
    const Scalar z683 = v_psi * z662 + v_theta * z654;
    const Scalar z684 = z60 + z673;
    const Scalar z685 = z671 * (v_psi - v_theta);
    const Scalar z686 = z641 * z656 - z636 * z667 - z683 * z639 - z685 * z640;
    const Scalar z687 = z641 * z685 + z636 * z683;
    const Scalar z688 = z641 * z671;
    const Scalar z689 = z636 * z662 + z688;
    const Scalar z690 = z636 * z654 - z688;
    const Scalar z691 = z59 - z628;
    const Scalar z692 = z69 + z629;
    const Scalar z693 = z36 * z47 + z37 * z45;
    const Scalar z694 = z691 * z691 + z692 * z692;
    const Scalar z695 = z61 + z693;
    const Scalar z696 = z92 - z673;
    const Scalar z697 = z93 + z693;
    const Scalar z698 = n2 * (z631 * z684 - z634 * z695);
    const Scalar z699 = traits::sqrt(z694);
    const Scalar z700 = n2 * (z691 * z696 - z692 * z697);
    const Scalar z701 = z36 * z57 + z37 * z56;
    const Scalar z702 = z71 + z701;
    const Scalar z703 = z94 - z701;
    const Scalar z704 = n0_5 * z698 / z645;
    const Scalar z705 = s_psi * z39 + c_psi * z38;
    const Scalar z706 = s_psi * z38 - c_psi * z39;
    const Scalar z707 = z36 * z56 - z37 * z57;
    const Scalar z708 = z48 + z705;
    const Scalar z709 = z72 - z707;
    const Scalar z710 = z66 + z706;
    const Scalar z711 = z95 - z707;
    const Scalar z712 = k11 + z629;
    const Scalar z713 = z634 / z645;
    const Scalar z714 = n2 * (z631 * z702 - z634 * z709 - z684 * z684 - z695 * z695);
    const Scalar z715 = n2 * (z691 * z703 - z692 * z711 - z696 * z696 - z697 * z697);
    const Scalar z716 = z634 * z704 / (z645 * z645) + z695 / z645;
    const Scalar z717 = z631 * z704 / (z645 * z645) - z684 / z645;
    const Scalar z718 = z631 / z645;
    const Scalar z719 = n0_0066 - z699;
    const Scalar z720 = z708 * z708 + z710 * z710;
    const Scalar z721 = n0_5 * (z698 * z704 / (z645 * z645) + z714 / z645);
    const Scalar z722 = traits::sqrt(z720);
    const Scalar z723 = n0_5 * z700 / z699;
    const Scalar z724 = n0_5 * (z700 * z723 / (z699 * z699) + z715 / z699);
    const Scalar z725 = z691 * z723 / (z699 * z699) - z696 / z699;
    const Scalar z726 = z692 * z723 / (z699 * z699) + z697 / z699;
    const Scalar z727 = z692 / z699;
    const Scalar z728 = z629 - n0_0016 * z727;
    const Scalar z729 = z691 / z699;
    const Scalar z730 = z712 - n0_0016 * z727;
    const Scalar z731 = n0_0016 * z713 - z712;
    const Scalar z732 = z673 + n0_0016 * z717;
    const Scalar z733 = z732 * (v_psi - v_theta);
    const Scalar z734 = n0_0066 - z722;
    const Scalar z735 = n2 * (z629 * z691 + z628 * z692);
    const Scalar z736 = n2 * (z67 * z691 + z59 * z692);
    const Scalar z737 = n0_5 * z735 / z699;
    const Scalar z738 = n0_5 * z736 / z699;
    const Scalar z739 = z629 - n0_0016 * z713;
    const Scalar z740 = z673 - n0_0016 * z725;
    const Scalar z741 = n2 * (z705 * z710 - z706 * z708);
    const Scalar z742 = z740 * (v_psi - v_theta);
    const Scalar z743 = z693 - n0_0016 * z716;
    const Scalar z744 = z743 * (v_psi - v_theta);
    const Scalar z745 = z693 - n0_0016 * z726;
    const Scalar z746 = z745 * (v_psi - v_theta);
    const Scalar z747 = z628 + n0_0016 * z729;
    const Scalar z748 = z628 - n0_0016 * z718;
    const Scalar z749 = n2 * (z49 * z708 + z48 * z710);
    const Scalar z750 = n0_5 * z741 / z722;
    const Scalar z751 = n0_5 * z749 / z722;
    const Scalar z752 = z38 * z45 - z39 * z47;
    const Scalar z753 = v_psi * z728 - v_theta * z730;
    const Scalar z754 = z747 * (v_psi - v_theta);
    const Scalar z755 = z753 * z726 - z754 * z725 + z729 * z742 + z727 * z746;
    const Scalar z756 = z729 * z754 - z727 * z753;
    const Scalar z757 = z729 * z747;
    const Scalar z758 = z727 * z728 - z757;
    const Scalar z759 = z727 * z730 - z757;
    const Scalar z760 = v_psi * z739 + v_theta * z731;
    const Scalar z761 = z60 + z752;
    const Scalar z762 = z748 * (v_psi - v_theta);
    const Scalar z763 = z718 * z733 - z713 * z744 - z760 * z716 - z762 * z717;
    const Scalar z764 = z718 * z762 + z713 * z760;
    const Scalar z765 = z38 * z47 + z39 * z45;
    const Scalar z766 = z718 * z748;
    const Scalar z767 = z713 * z739 + z766;
    const Scalar z768 = z713 * z731 - z766;
    const Scalar z769 = z69 + z706;
    const Scalar z770 = z61 + z765;
    const Scalar z771 = z92 - z752;
    const Scalar z772 = z93 + z765;
    const Scalar z773 = z59 - z705;
    const Scalar z774 = n2 * (z67 * z773 + z59 * z769);
    const Scalar z775 = z773 * z773 + z769 * z769;
    const Scalar z776 = n2 * (z708 * z761 - z710 * z770);
    const Scalar z777 = n2 * (z773 * z771 - z769 * z772);
    const Scalar z778 = traits::sqrt(z775);
    const Scalar z779 = n0_5 * z776 / z722;
    const Scalar z780 = z38 * z57 + z39 * z56;
    const Scalar z781 = z38 * z56 - z39 * z57;
    const Scalar z782 = z71 + z780;
    const Scalar z783 = z94 - z780;
    const Scalar z784 = z72 - z781;
    const Scalar z785 = z95 - z781;
    const Scalar z786 = k11 + z706;
    const Scalar z787 = z710 / z722;
    const Scalar z788 = n2 * (z708 * z782 - z710 * z784 - z761 * z761 - z770 * z770);
    const Scalar z789 = n2 * (z773 * z783 - z769 * z785 - z771 * z771 - z772 * z772);
    const Scalar z790 = z710 * z779 / (z722 * z722) + z770 / z722;
    const Scalar z791 = n0_5 * z774 / z778;
    const Scalar z792 = z708 * z779 / (z722 * z722) - z761 / z722;
    const Scalar z793 = z708 / z722;
    const Scalar z794 = n0_0066 - z778;
    const Scalar z795 = n0_5 * z777 / z778;
    const Scalar z796 = z769 / z778;
    const Scalar z797 = n0_5 * (z776 * z779 / (z722 * z722) + z788 / z722);
    const Scalar z798 = z773 / z778;
    const Scalar z799 = n2 * (z706 * z773 + z705 * z769);
    const Scalar z800 = n0_5 * z799 / z778;
    const Scalar z801 = z706 - n0_0016 * z796;
    const Scalar z802 = n0_5 * (z777 * z795 / (z778 * z778) + z789 / z778);
    const Scalar z803 = z786 - n0_0016 * z796;
    const Scalar z804 = z752 + n0_0016 * z792;
    const Scalar z805 = z773 * z795 / (z778 * z778) - z771 / z778;
    const Scalar z806 = z706 - n0_0016 * z787;
    const Scalar z807 = z804 * (v_psi - v_theta);
    const Scalar z808 = z765 - n0_0016 * z790;
    const Scalar z809 = z769 * z795 / (z778 * z778) + z772 / z778;
    const Scalar z810 = z705 + n0_0016 * z798;
    const Scalar z811 = v_psi * z801 - v_theta * z803;
    const Scalar z812 = n0_0016 * z787 - z786;
    const Scalar z813 = z808 * (v_psi - v_theta);
    const Scalar z814 = z810 * (v_psi - v_theta);
    const Scalar z815 = z752 - n0_0016 * z805;
    const Scalar z816 = z705 - n0_0016 * z793;
    const Scalar z817 = z765 - n0_0016 * z809;
    const Scalar z818 = z798 * z810;
    const Scalar z819 = z796 * z801 - z818;
    const Scalar z820 = v_psi * z806 + v_theta * z812;
    const Scalar z821 = z796 * z803 - z818;
    const Scalar z822 = z815 * (v_psi - v_theta);
    const Scalar z823 = z816 * (v_psi - v_theta);
    const Scalar z824 = z793 * z816;
    const Scalar z825 = z817 * (v_psi - v_theta);
    const Scalar z826 = z793 * z823 + z787 * z820;
    const Scalar z827 = z787 * z806 + z824;
    const Scalar z828 = z787 * z812 - z824;
    const Scalar z829 = z793 * z807 - z787 * z813 - z820 * z790 - z823 * z792;
    const Scalar z830 = z798 * z814 - z796 * z811;
    const Scalar z831 = z811 * z809 - z814 * z805 + z798 * z822 + z796 * z825;
    result.gap[0] = -z87;
    result.rate[0] = -z102;
    result.drift[0] = -z111;
    result.rate[1] = z132;
    result.drift[1] = z154;
    result.gap[1] = -z105;
    result.rate[2] = z108;
    result.drift[2] = -z122;
    result.rate[3] = z178;
    result.drift[3] = z176;
    result.gap[2] = -z134;
    result.rate[4] = -z158;
    result.drift[4] = -z177;
    result.rate[5] = z226;
    result.drift[5] = -z225;
    result.gap[3] = -z185;
    result.rate[6] = -z203;
    result.drift[6] = -z216;
    result.rate[7] = -z223;
    result.drift[7] = z237;
    result.gap[4] = -z214;
    result.rate[8] = -z248;
    result.drift[8] = -z265;
    result.rate[9] = z308;
    result.drift[9] = -z307;
    result.gap[5] = -z263;
    result.rate[10] = -z267;
    result.drift[10] = -z268;
    result.rate[11] = -z300;
    result.drift[11] = z299;
    result.gap[6] = -z278;
    result.rate[12] = -z325;
    result.drift[12] = -z342;
    result.rate[13] = z385;
    result.drift[13] = -z384;
    result.gap[7] = -z340;
    result.rate[14] = -z344;
    result.drift[14] = -z345;
    result.rate[15] = -z377;
    result.drift[15] = z376;
    result.gap[8] = -z355;
    result.rate[16] = -z402;
    result.drift[16] = -z417;
    result.rate[17] = z462;
    result.drift[17] = -z461;
    result.gap[9] = -z413;
    result.rate[18] = -z414;
    result.drift[18] = -z421;
    result.rate[19] = -z454;
    result.drift[19] = z453;
    result.gap[10] = -z424;
    result.rate[20] = -z459;
    result.drift[20] = -z488;
    result.rate[21] = -z523;
    result.drift[21] = -z540;
    result.gap[11] = -z490;
    result.rate[22] = z491;
    result.drift[22] = -z499;
    result.rate[23] = z557;
    result.drift[23] = z556;
    result.gap[12] = -z509;
    result.rate[24] = -z537;
    result.drift[24] = -z547;
    result.rate[25] = z605;
    result.drift[25] = -z604;
    result.gap[13] = -z564;
    result.rate[26] = -z582;
    result.drift[26] = -z595;
    result.rate[27] = -z602;
    result.drift[27] = z616;
    result.gap[14] = -z593;
    result.rate[28] = -z627;
    result.drift[28] = -z644;
    result.rate[29] = z687;
    result.drift[29] = -z686;
    result.gap[15] = -z642;
    result.rate[30] = -z646;
    result.drift[30] = -z647;
    result.rate[31] = -z679;
    result.drift[31] = z678;
    result.gap[16] = -z657;
    result.rate[32] = -z704;
    result.drift[32] = -z721;
    result.rate[33] = z764;
    result.drift[33] = -z763;
    result.gap[17] = -z719;
    result.rate[34] = -z723;
    result.drift[34] = -z724;
    result.rate[35] = -z756;
    result.drift[35] = z755;
    result.gap[18] = -z734;
    result.rate[36] = -z779;
    result.drift[36] = -z797;
    result.rate[37] = z826;
    result.drift[37] = -z829;
    result.gap[19] = -z794;
    result.rate[38] = -z795;
    result.drift[38] = -z802;
    result.rate[39] = -z830;
    result.drift[39] = z831;
    result.jacobian[0] = z89;
    result.jacobian[1] = -z128;
    result.jacobian[2] = -z106;
    result.jacobian[3] = z180;
    result.jacobian[4] = z136;
    result.jacobian[5] = z228;
    result.jacobian[6] = z182;
    result.jacobian[7] = z221;
    result.jacobian[8] = z211;
    result.jacobian[9] = z310;
    result.jacobian[10] = z281;
    result.jacobian[11] = z302;
    result.jacobian[12] = z293;
    result.jacobian[13] = z387;
    result.jacobian[14] = z358;
    result.jacobian[15] = z379;
    result.jacobian[16] = z370;
    result.jacobian[17] = z464;
    result.jacobian[18] = z433;
    result.jacobian[19] = z456;
    result.jacobian[20] = -z438;
    result.jacobian[21] = z520;
    result.jacobian[22] = -z500;
    result.jacobian[23] = z559;
    result.jacobian[24] = z511;
    result.jacobian[25] = z607;
    result.jacobian[26] = z561;
    result.jacobian[27] = z600;
    result.jacobian[28] = z590;
    result.jacobian[29] = z689;
    result.jacobian[30] = z660;
    result.jacobian[31] = z681;
    result.jacobian[32] = z672;
    result.jacobian[33] = z767;
    result.jacobian[34] = z737;
    result.jacobian[35] = z758;
    result.jacobian[36] = z750;
    result.jacobian[37] = z827;
    result.jacobian[38] = z800;
    result.jacobian[39] = z819;
    result.jacobian[40] = z91;
    result.jacobian[41] = z129;
    result.jacobian[42] = z107;
    result.jacobian[43] = z181;
    result.jacobian[44] = z139;
    result.jacobian[45] = z229;
    result.jacobian[46] = -z207;
    result.jacobian[47] = -z222;
    result.jacobian[48] = z212;
    result.jacobian[49] = z311;
    result.jacobian[50] = -z282;
    result.jacobian[51] = -z303;
    result.jacobian[52] = z296;
    result.jacobian[53] = z388;
    result.jacobian[54] = -z359;
    result.jacobian[55] = -z380;
    result.jacobian[56] = z373;
    result.jacobian[57] = z465;
    result.jacobian[58] = -z434;
    result.jacobian[59] = -z457;
    result.jacobian[60] = z447;
    result.jacobian[61] = z521;
    result.jacobian[62] = -z504;
    result.jacobian[63] = -z560;
    result.jacobian[64] = z516;
    result.jacobian[65] = z608;
    result.jacobian[66] = -z586;
    result.jacobian[67] = -z601;
    result.jacobian[68] = z591;
    result.jacobian[69] = z690;
    result.jacobian[70] = -z661;
    result.jacobian[71] = -z682;
    result.jacobian[72] = z675;
    result.jacobian[73] = z768;
    result.jacobian[74] = -z738;
    result.jacobian[75] = -z759;
    result.jacobian[76] = z751;
    result.jacobian[77] = z828;
    result.jacobian[78] = -z791;
    result.jacobian[79] = -z821;
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
