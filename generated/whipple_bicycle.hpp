// SPDX-License-Identifier: MIT
// whipple_bicycle: Whipple's bicycle: two rolling wheels, benchmark of 2007
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed under the MIT licence.
//
// Kernels: mass_matrix, forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix              87              131          0             0                  4       0    226     231
//   forward_dynamics       1097             1467         26             2                  4       0   2600    2669
//   energy                  109              161          0             0                  6       0    282     302
//   first_integrals         110              161          0             0                  6       0    283     303
//   constraints             339              520         14             2                  4       0    883     941
//   linearisation          2881             3779        107             2                  6       0   6781    7181
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 81 results 28 vanish identically, 21 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: of 72 results 30 vanish identically, 2 repeat another up to sign
//   linearisation: of 394 results 187 vanish identically, 26 repeat another up to sign
//
// To write this file again:
//   whipple_bicycle_scene generate --kernels mass_matrix,forward_dynamics,energy,first_integrals,constraints,linearisation --support torsor_support.hpp --output whipple_bicycle.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace whipple_bicycle {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 9> coordinates{{{"x", "m"}, {"y", "m"}, {"z", "m"}, {"yaw",
      "rad"}, {"roll", "rad"}, {"pitch", "rad"}, {"steer", "rad"}, {"rear", "rad"}, {"front", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 9> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"},
      {"yaw", "rad/s"}, {"roll", "rad/s"}, {"pitch", "rad/s"}, {"steer", "rad/s"}, {"rear", "rad/s"}, {"front",
      "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 6> multipliers{{{"lambda_rear_touches", "N"},
      {"lambda_front_touches", "N"}, {"lambda_rear_rolls_x", "N"}, {"lambda_rear_rolls_y", "N"},
      {"lambda_front_rolls_x", "N"}, {"lambda_front_rolls_y", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> parameters{};
  static constexpr std::array<torsor::ResultDescription, 20> results{{{"mass", "", 9, 9}, {"accelerations", "", 9, 1},
      {"multipliers", "", 6, 1}, {"result", "kinetic", 1, 1}, {"result", "force_function", 1, 1}, {"result", "power", 1,
      1}, {"result", "energy", 1, 1}, {"result", "value", 6, 1}, {"result", "rate", 6, 1}, {"result", "jacobian", 6, 9},
      {"result", "gamma", 6, 1}, {"result", "M", 9, 9}, {"result", "C", 9, 9}, {"result", "K", 9, 9}, {"result", "F", 9,
      1}, {"result", "M_r", 3, 3}, {"result", "C_r", 3, 3}, {"result", "K_r", 3, 7}, {"result", "F_r", 3, 1}, {"result",
      "A", 10, 10}}};
  static constexpr std::array<torsor::KernelDescription, 6> kernels{{{"mass_matrix", false, false, false, false,
      results.data() + 0, 1}, {"forward_dynamics", false, false, true, true, results.data() + 1, 2}, {"energy", false,
      false, true, false, results.data() + 3, 3}, {"first_integrals", false, false, false, false, results.data() + 6,
      1}, {"constraints", false, false, false, false, results.data() + 7, 4}, {"linearisation", true, true, true, true,
      results.data() + 11, 9}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::whipple_bicycle::Description;

  static constexpr const char* name = "whipple_bicycle";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x38f8c33696f2b5dfULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 9;
  static constexpr int velocity_count = 9;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 0;
  static constexpr int multiplier_count = 6;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters : torsor::NoMembers<Scalar> {};

  /// Generalised coordinates q.
  struct Coordinates {
    Scalar x;  ///< coordinate [m]
    Scalar y;  ///< coordinate [m]
    Scalar z;  ///< coordinate [m]
    Scalar yaw;  ///< coordinate [rad]
    Scalar roll;  ///< coordinate [rad]
    Scalar pitch;  ///< coordinate [rad]
    Scalar steer;  ///< coordinate [rad]
    Scalar rear;  ///< coordinate [rad]
    Scalar front;  ///< coordinate [rad]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::z, &Coordinates::yaw,
          &Coordinates::roll, &Coordinates::pitch, &Coordinates::steer, &Coordinates::rear, &Coordinates::front};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar z;  ///< its rate [m/s]
    Scalar yaw;  ///< its rate [rad/s]
    Scalar roll;  ///< its rate [rad/s]
    Scalar pitch;  ///< its rate [rad/s]
    Scalar steer;  ///< its rate [rad/s]
    Scalar rear;  ///< its rate [rad/s]
    Scalar front;  ///< its rate [rad/s]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::z, &Velocities::yaw,
          &Velocities::roll, &Velocities::pitch, &Velocities::steer, &Velocities::rear, &Velocities::front};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar z;  ///< its second rate [m/s^2]
    Scalar yaw;  ///< its second rate [rad/s^2]
    Scalar roll;  ///< its second rate [rad/s^2]
    Scalar pitch;  ///< its second rate [rad/s^2]
    Scalar steer;  ///< its second rate [rad/s^2]
    Scalar rear;  ///< its second rate [rad/s^2]
    Scalar front;  ///< its second rate [rad/s^2]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::z,
          &Accelerations::yaw, &Accelerations::roll, &Accelerations::pitch, &Accelerations::steer, &Accelerations::rear,
          &Accelerations::front};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar z;  ///< works with the rate of z [N]
    Scalar yaw;  ///< works with the rate of yaw [N m]
    Scalar roll;  ///< works with the rate of roll [N m]
    Scalar pitch;  ///< works with the rate of pitch [N m]
    Scalar steer;  ///< works with the rate of steer [N m]
    Scalar rear;  ///< works with the rate of rear [N m]
    Scalar front;  ///< works with the rate of front [N m]
    static constexpr int size = 9;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::z, &GeneralizedForces::yaw, &GeneralizedForces::roll, &GeneralizedForces::pitch,
          &GeneralizedForces::steer, &GeneralizedForces::rear, &GeneralizedForces::front};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_rear_touches;  ///< of the constraint rear_touches [N]
    Scalar lambda_front_touches;  ///< of the constraint front_touches [N]
    Scalar lambda_rear_rolls_x;  ///< of the constraint rear_rolls_x [N]
    Scalar lambda_rear_rolls_y;  ///< of the constraint rear_rolls_y [N]
    Scalar lambda_front_rolls_x;  ///< of the constraint front_rolls_x [N]
    Scalar lambda_front_rolls_y;  ///< of the constraint front_rolls_y [N]
    static constexpr int size = 6;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_rear_touches,
          &Multipliers::lambda_front_touches, &Multipliers::lambda_rear_rolls_x, &Multipliers::lambda_rear_rolls_y,
          &Multipliers::lambda_front_rolls_x, &Multipliers::lambda_front_rolls_y};
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
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n4_6 = traits::constant(4.6, 4.6f, "23/5");
    const Scalar n0_15 = traits::constant(0.15, 0.15f, "3/20");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n46_over_3 = traits::constant(15.333333333333334, 15.333333f, "46/3");
    const Scalar n92_over_7 = traits::constant(13.142857142857142, 13.142858f, "92/7");
    state.time = n0;
    state.q.x = n0;
    state.q.y = n0;
    state.q.z = -n0_3;
    state.q.yaw = n0;
    state.q.roll = n0;
    state.q.pitch = n0;
    state.q.steer = n0;
    state.q.rear = n0;
    state.q.front = n0;
    state.v.x = n4_6;
    state.v.y = n0_15;
    state.v.z = n0;
    state.v.yaw = n0;
    state.v.roll = n0_5;
    state.v.pitch = n0;
    state.v.steer = n0;
    state.v.rear = -n46_over_3;
    state.v.front = -n92_over_7;
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

  /// Quantities that every motion conserves.
  struct FirstIntegrals {
    Scalar energy;  ///< T - U [J]
    static constexpr int size = 1;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar FirstIntegrals::*member_(int i_) noexcept {
      constexpr Scalar FirstIntegrals::*members_[] = {&FirstIntegrals::energy};
      return members_[i_];
    }
  };

  /// Constraints and their derivatives, one entry per multiplier.
  struct Constraints {
    std::array<Scalar, 6> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 6> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 54> jacobian;  ///< A, stored column by column (6 x 9)
    std::array<Scalar, 6> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 81> M;  ///< mass matrix (9 x 9)
    std::array<Scalar, 81> C;  ///< damping and gyroscopic terms (9 x 9)
    std::array<Scalar, 81> K;  ///< stiffness (9 x 9)
    std::array<Scalar, 9> F;  ///< right-hand side
    std::array<Scalar, 9> M_r;  ///< reduced mass matrix (3 x 3)
    std::array<Scalar, 9> C_r;  ///< reduced damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 21> K_r;  ///< reduced stiffness (3 x 7)
    std::array<Scalar, 3> F_r;  ///< reduced right-hand side
    std::array<Scalar, 100> A;  ///< state matrix of x = (e, w): x' = A x + B du (10 x 10)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 7;
  static constexpr int independent_coordinates[] = {0, 1, 3, 4, 6, 7, 8};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[] = {4, 6, 7};

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 81>& mass) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n3_85 = traits::constant(3.85, 3.85f, "77/20");
    const Scalar n1_04 = traits::constant(1.04, 1.04f, "26/25");
    const Scalar k3 = traits::constant(2.52692, 2.52692f, "63173/25000");
    const Scalar k4 = traits::constant(0.65156, 0.65156f, "16289/25000");
    const Scalar k5 = traits::constant(0.32678, 0.32678f, "16339/50000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_yaw = state.q.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar q_steer = state.q.steer;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z1 - n1_04 * z2;
    });
    const Scalar z4 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z1 - k4 * z2;
    });
    const Scalar z5 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z1 - k5 * z2;
    });
    const Scalar z6 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z1 * z4 - z2 * z5;
    });
    const Scalar z7 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z8 = -z7 * (n1 - c_steer);
    const Scalar z9 = z1 * s_steer;
    const Scalar z10 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z11 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z12 = z2 * s_steer;
    const Scalar z13 = n2_8467 * c_steer;
    const Scalar z14 = c_steer * z3;
    const Scalar z15 = n0_28 * c_steer;
    const Scalar z16 = n0_12 * s_roll;
    const Scalar z17 = n0_28 * z12;
    const Scalar z18 = n0_28 * z9;
    const Scalar z19 = z3 * z12;
    const Scalar z20 = z3 * z9;
    const Scalar z21 = z4 * z12 + z5 * z9;
    const Scalar z22 = n1_04 * z12 - n3_85 * z9;
    const Scalar z23 = n2_8467 * z12;
    const Scalar z24 = k3 * z12 + k4 * z9;
    const Scalar z25 = k4 * z12 + k5 * z9;
    const Scalar z26 = n2_8467 * z9;
    const Scalar z27 = s_pitch * z18 - c_pitch * z17;
    const Scalar z28 = s_pitch * z17 + c_pitch * z18;
    const Scalar z29 = s_pitch * z20 - c_pitch * z19;
    const Scalar z30 = s_pitch * z19 + c_pitch * z20;
    const Scalar z31 = k4 * z8;
    const Scalar z32 = z5 * z8 + z4 * z11;
    const Scalar z33 = z4 * z8 + z5 * z10;
    const Scalar z34 = n1_04 * z11 - n3_85 * z8;
    const Scalar z35 = n1_04 * z8 - n3_85 * z10;
    const Scalar z36 = k5 * z8 + k4 * z11;
    const Scalar z37 = k3 * z8 + k4 * z10;
    const Scalar z38 = k3 * z11 + z31;
    const Scalar z39 = k5 * z10 + z31;
    const Scalar z40 = n0_3 * z19 - z21 + n1_1 * z20;
    const Scalar z41 = z11 * z24 - z12 * z13 + z8 * z25;
    const Scalar z42 = c_steer * z13 + z12 * z24 + z9 * z25;
    const Scalar z43 = s_roll * z15 + c_roll * z28;
    const Scalar z44 = n0_3 * z14 - z32;
    const Scalar z45 = n1_1 * z14 - z33;
    const Scalar z46 = s_roll * z30 - c_roll * z14;
    const Scalar z47 = s_roll * z14 + c_roll * z30;
    const Scalar z48 = z12 * z23 + z11 * z38 + z8 * z36;
    const Scalar z49 = z9 * z26 + z8 * z37 + z10 * z39;
    const Scalar z50 = z12 * z26 + z11 * z37 + z8 * z39;
    const Scalar z51 = n9_1 + n0_6 * z35 - n2_2 * z34 + z42;
    const Scalar z52 = n8_47 - n2_2 * z34 + z49;
    const Scalar z53 = n0_63 + n0_6 * z35 + z48;
    const Scalar z54 = n2_31 + n1_1 * z35 - n0_3 * z34 + z50;
    const Scalar z55 = n29_35 - z52;
    const Scalar z56 = n17_7 - z54;
    const Scalar z57 = z53 + z55;
    const Scalar z58 = c_steer * z26 - z12 * z37 - z9 * z39;
    const Scalar z59 = n2 * z56;
    const Scalar z60 = n2_1 + z35;
    const Scalar z61 = n1_1 * z22 + z41;
    const Scalar z62 = s_pitch * z57 - c_pitch * z59;
    const Scalar z63 = n49_25 + z51;
    const Scalar z64 = n7_7 - z34;
    const Scalar z65 = n51 - z60;
    const Scalar z66 = n0_3 * z22 + z58;
    const Scalar z67 = n0_12 + z63;
    const Scalar z68 = s_pitch * z62;
    const Scalar z69 = n25_5 + z64;
    const Scalar z70 = s_pitch * z61 - c_pitch * z66;
    const Scalar z71 = c_pitch * z65 + s_pitch * z69;
    const Scalar z72 = z55 - z68;
    const Scalar z73 = s_pitch * z65 - c_pitch * z69;
    const Scalar z74 = n39_8603 - z72;
    const Scalar z75 = s_pitch * z66 + c_pitch * z61;
    const Scalar z76 = s_roll * z73;
    const Scalar z77 = s_pitch * z44 + c_pitch * z45;
    const Scalar z78 = c_pitch * z62 + z56;
    const Scalar z79 = z53 - z68;
    const Scalar z80 = s_roll * z22 + c_roll * z71;
    const Scalar z81 = s_pitch * z45 - c_pitch * z44;
    const Scalar z82 = s_roll * z71 - c_roll * z22;
    const Scalar z83 = s_roll * z40 - c_roll * z77;
    const Scalar z84 = z67 - z74;
    const Scalar z85 = c_yaw * z29 + s_yaw * z46;
    const Scalar z86 = n2 * z70;
    const Scalar z87 = s_yaw * z29 - c_yaw * z46;
    const Scalar z88 = s_roll * z84 - c_roll * z86;
    const Scalar z89 = c_roll * z73;
    const Scalar z90 = s_roll * z67 - c_roll * z70;
    const Scalar z91 = s_roll * z88;
    const Scalar z92 = s_yaw * z76 - c_yaw * z71;
    const Scalar z93 = s_yaw * z71 + c_yaw * z76;
    const Scalar z94 = n39_8603 + z79;
    const Scalar z95 = s_roll * z75 - c_roll * z78;
    const Scalar z96 = s_yaw * z80;
    const Scalar z97 = c_yaw * z80;
    const Scalar z98 = z74 + z91;
    const Scalar z99 = s_yaw * z73 - c_yaw * z82;
    const Scalar z100 = c_yaw * z73 + s_yaw * z82;
    mass[0] = n94;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z99;
    mass[4] = -z96;
    mass[5] = z92;
    mass[6] = z85;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n94;
    mass[11] = n0;
    mass[12] = -z100;
    mass[13] = z97;
    mass[14] = -z93;
    mass[15] = z87;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n94;
    mass[21] = n0;
    mass[22] = z82;
    mass[23] = z89;
    mass[24] = z47;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = z99;
    mass[28] = -z100;
    mass[29] = n0;
    mass[30] = z98;
    mass[31] = z95;
    mass[32] = z90;
    mass[33] = -z83;
    mass[34] = z16;
    mass[35] = z43;
    mass[36] = -z96;
    mass[37] = z97;
    mass[38] = z82;
    mass[39] = z95;
    mass[40] = z94;
    mass[41] = z75;
    mass[42] = z81;
    mass[43] = n0;
    mass[44] = z27;
    mass[45] = z92;
    mass[46] = -z93;
    mass[47] = z89;
    mass[48] = z90;
    mass[49] = z75;
    mass[50] = z67;
    mass[51] = -z40;
    mass[52] = n0_12;
    mass[53] = z15;
    mass[54] = z85;
    mass[55] = z87;
    mass[56] = z47;
    mass[57] = -z83;
    mass[58] = z81;
    mass[59] = -z40;
    mass[60] = z6;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = n0;
    mass[66] = z16;
    mass[67] = n0;
    mass[68] = n0_12;
    mass[69] = n0;
    mass[70] = n0_12;
    mass[71] = n0;
    mass[72] = n0;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = z43;
    mass[76] = z27;
    mass[77] = z15;
    mass[78] = n0;
    mass[79] = n0;
    mass[80] = n0_28;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point).
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n3_85 = traits::constant(3.85, 3.85f, "77/20");
    const Scalar n1_04 = traits::constant(1.04, 1.04f, "26/25");
    const Scalar k3 = traits::constant(2.52692, 2.52692f, "63173/25000");
    const Scalar k4 = traits::constant(0.65156, 0.65156f, "16289/25000");
    const Scalar k5 = traits::constant(0.32678, 0.32678f, "16339/50000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar k17 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar k18 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar k19 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n9_95 = traits::constant(9.95, 9.95f, "199/20");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n39_3 = traits::constant(39.3, 39.3f, "393/10");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n0_5603 = traits::constant(0.5603, 0.5603f, "5603/10000");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z1 - n1_04 * z2;
    });
    const Scalar z4 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z1 - k4 * z2;
    });
    const Scalar z5 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z1 - k5 * z2;
    });
    const Scalar z6 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z1 * z4 - z2 * z5;
    });
    const Scalar z7 = traits::formula(6.497839117007668, 6.497839f, [&]() -> Scalar {
      return n1 / z6;
    });
    const Scalar z8 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z1 * z1;
    });
    const Scalar z9 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z10 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z2 * z2;
    });
    const Scalar z11 = -z9 * (n1 - c_steer);
    const Scalar z12 = z1 * s_steer;
    const Scalar z13 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z14 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z15 = z2 * s_steer;
    const Scalar z16 = s_yaw * c_roll;
    const Scalar z17 = n1 - s_roll * s_roll;
    const Scalar z18 = c_yaw * c_roll;
    const Scalar z19 = v_roll * s_roll;
    const Scalar z20 = v_yaw * c_yaw;
    const Scalar z21 = v_roll * c_roll;
    const Scalar z22 = v_yaw * s_yaw;
    const Scalar z23 = s_yaw * s_roll;
    const Scalar z24 = n2 * s_roll;
    const Scalar z25 = c_yaw * s_roll;
    const Scalar z26 = s_roll * z16;
    const Scalar z27 = s_roll * z18;
    const Scalar z28 = s_yaw * z19 - c_roll * z20;
    const Scalar z29 = c_yaw * z19 + c_roll * z22;
    const Scalar z30 = z21 * z24;
    const Scalar z31 = s_roll * z23 - c_roll * z16;
    const Scalar z32 = s_roll * z25 - c_roll * z18;
    const Scalar z33 = c_roll * z24;
    const Scalar z34 = v_roll * z21;
    const Scalar z35 = v_yaw * z22;
    const Scalar z36 = n2 * z19;
    const Scalar z37 = v_roll * z19;
    const Scalar z38 = n2 * z21;
    const Scalar z39 = v_yaw * z20;
    const Scalar z40 = n0_08 * z15 - n0_35 * z12;
    const Scalar z41 = s_pitch * z12 - c_pitch * z15;
    const Scalar z42 = s_pitch * z15 + c_pitch * z12;
    const Scalar z43 = z17 * z17 + z26 * z26 + z27 * z27;
    const Scalar z44 = s_yaw * z34 + c_roll * z35 + z20 * z36;
    const Scalar z45 = c_yaw * z34 + c_roll * z39 - z22 * z36;
    const Scalar z46 = n2 * (s_roll * z37 - z21 * z21);
    const Scalar z47 = n0_08 * z14 - n0_35 * z11;
    const Scalar z48 = n0_08 * z11 - n0_35 * z13;
    const Scalar z49 = s_roll * z28 - z16 * z21;
    const Scalar z50 = s_roll * z29 - z18 * z21;
    const Scalar z51 = n2 * (z17 * z33 + z26 * z31 + z27 * z32);
    const Scalar z52 = s_roll * z42 - c_roll * c_steer;
    const Scalar z53 = s_roll * c_steer + c_roll * z42;
    const Scalar z54 = n0_3 + z48;
    const Scalar z55 = n1_1 - z47;
    const Scalar z56 = traits::sqrt(z43);
    const Scalar z57 = n2 * (z17 * z30 + z26 * z49 + z27 * z50);
    const Scalar z58 = z16 * z37 + z28 * z38 + s_roll * z44;
    const Scalar z59 = z18 * z37 + z29 * z38 + s_roll * z45;
    const Scalar z60 = c_yaw * z41 + s_yaw * z52;
    const Scalar z61 = n2 * (z26 * z58 + z27 * z59 - z17 * z46 - z49 * z49 - z50 * z50 - z30 * z30);
    const Scalar z62 = z53 * z60;
    const Scalar z63 = s_yaw * z41 - c_yaw * z52;
    const Scalar z64 = z53 * z63;
    const Scalar z65 = s_pitch * z55 - c_pitch * z54;
    const Scalar z66 = s_roll * z65 - c_roll * z40;
    const Scalar z67 = s_pitch * z54 + c_pitch * z55;
    const Scalar z68 = n0_5 * z51 / z56;
    const Scalar z69 = s_roll * z40 + c_roll * z65;
    const Scalar z70 = q_z - z69;
    const Scalar z71 = n0_3 / z56;
    const Scalar z72 = n1 - z53 * z53;
    const Scalar z73 = s_yaw * z66 - c_yaw * z67;
    const Scalar z74 = s_yaw * z67 + c_yaw * z66;
    const Scalar z75 = n0_5 * z57 / z56;
    const Scalar z76 = q_y + z74;
    const Scalar z77 = q_x - z73;
    const Scalar z78 = q_x + z26 * z71;
    const Scalar z79 = z72 * z72 + z62 * z62 + z64 * z64;
    const Scalar z80 = n0_5 * (z57 * z75 / (z56 * z56) + z61 / z56);
    const Scalar z81 = n0_3 * z68;
    const Scalar z82 = q_z + z17 * z71;
    const Scalar z83 = q_y - z27 * z71;
    const Scalar z84 = traits::sqrt(z79);
    const Scalar z85 = c_yaw * z53;
    const Scalar z86 = n2 * z53;
    const Scalar z87 = v_pitch * c_pitch;
    const Scalar z88 = v_pitch * s_pitch;
    const Scalar z89 = v_steer * c_steer;
    const Scalar z90 = v_steer * s_steer;
    const Scalar z91 = s_yaw * z53;
    const Scalar z92 = z52 * z60 - z53 * z91;
    const Scalar z93 = z2 * z89;
    const Scalar z94 = z1 * z89;
    const Scalar z95 = z15 * z87 - z12 * z88 + s_pitch * z93 + c_pitch * z94;
    const Scalar z96 = z15 * z88 + z12 * z87 + s_pitch * z94 - c_pitch * z93;
    const Scalar z97 = z9 * z90;
    const Scalar z98 = -z90 * (n1 - z8);
    const Scalar z99 = n0_35 * z97 + n0_08 * z98;
    const Scalar z100 = n0_3 * z80;
    const Scalar z101 = z53 * z85 + z52 * z63;
    const Scalar z102 = n0_35 / z84;
    const Scalar z103 = z2 * c_steer;
    const Scalar z104 = z1 * c_steer;
    const Scalar z105 = s_roll * z41;
    const Scalar z106 = s_pitch * z103 + c_pitch * z104;
    const Scalar z107 = s_yaw * z105 - c_yaw * z42;
    const Scalar z108 = s_yaw * z42 + c_yaw * z105;
    const Scalar z109 = c_roll * z41;
    const Scalar z110 = z53 * z108 - z63 * z109;
    const Scalar z111 = z52 * z86;
    const Scalar z112 = n2 * (z64 * z101 - z72 * z111 + z62 * z92);
    const Scalar z113 = z53 * z107 + z60 * z109;
    const Scalar z114 = z86 * z109;
    const Scalar z115 = z77 - z62 * z102;
    const Scalar z116 = z70 + z72 * z102;
    const Scalar z117 = n2 * (z62 * z113 - z64 * z110 - z72 * z114);
    const Scalar z118 = z76 - z64 * z102;
    const Scalar z119 = n0_5 * z112 / z84;
    const Scalar z120 = s_pitch * z104 - c_pitch * z103;
    const Scalar z121 = n0_08 * z103 - n0_35 * z104;
    const Scalar z122 = c_roll * s_steer + s_roll * z106;
    const Scalar z123 = s_roll * s_steer - c_roll * z106;
    const Scalar z124 = c_yaw * z120 + s_yaw * z122;
    const Scalar z125 = s_yaw * z120 - c_yaw * z122;
    const Scalar z126 = z53 * z124 - z60 * z123;
    const Scalar z127 = n0_5 * z117 / z84;
    const Scalar z128 = s_steer * z9;
    const Scalar z129 = s_steer * (n1 - z8);
    const Scalar z130 = n0_08 * z129 - n0_35 * z128;
    const Scalar z131 = s_steer * (n1 - z10);
    const Scalar z132 = n0_08 * z128 - n0_35 * z131;
    const Scalar z133 = z66 - n0_35 * z119;
    const Scalar z134 = c_roll * z90 + c_steer * z19 + z21 * z42 + s_roll * z95;
    const Scalar z135 = c_pitch * z132 + s_pitch * z130;
    const Scalar z136 = z20 * z41 + z22 * z52 + s_yaw * z96 - c_yaw * z134;
    const Scalar z137 = s_roll * z121 + c_roll * z135;
    const Scalar z138 = s_roll * z90 - c_steer * z21 + z19 * z42 - c_roll * z95;
    const Scalar z139 = z20 * z52 - z22 * z41 + c_yaw * z96 + s_yaw * z134;
    const Scalar z140 = z138 * z86;
    const Scalar z141 = z53 * z136 - z63 * z138;
    const Scalar z142 = -z90 * (n1 - z10);
    const Scalar z143 = n0_08 * z97 + n0_35 * z142;
    const Scalar z144 = c_roll * z67;
    const Scalar z145 = z144 + n0_35 * z127;
    const Scalar z146 = z53 * z139 - z60 * z138;
    const Scalar z147 = n0_08 * z93 - n0_35 * z94;
    const Scalar z148 = z86 * z123;
    const Scalar z149 = z53 * z125 - z63 * z123;
    const Scalar z150 = n2 * (z72 * z148 + z62 * z126 + z64 * z149);
    const Scalar z151 = v_steer * z90;
    const Scalar z152 = z2 * z151;
    const Scalar z153 = z1 * z151;
    const Scalar z154 = n2 * (z72 * z140 + z64 * z141 + z62 * z146);
    const Scalar z155 = s_pitch * z99 - c_pitch * z143 - z55 * z87 - z54 * z88;
    const Scalar z156 = v_steer * z89;
    const Scalar z157 = n0_5 * z154 / z84;
    const Scalar z158 = n0_5 * z150 / z84;
    const Scalar z159 = z21 * z40 + s_roll * z147 - z19 * z65 - c_roll * z155;
    const Scalar z160 = v_z - z159;
    const Scalar z161 = n0_3 * z75 / (z56 * z56);
    const Scalar z162 = v_z - z71 * z30 + z17 * z161;
    const Scalar z163 = v_y + z71 * z50 - z27 * z161;
    const Scalar z164 = v_x - z71 * z49 + z26 * z161;
    const Scalar z165 = q_z - z82;
    const Scalar z166 = q_x - z78;
    const Scalar z167 = q_y - z83;
    const Scalar z168 = v_z - z162;
    const Scalar z169 = v_y - z163;
    const Scalar z170 = v_x - z164;
    const Scalar z171 = s_pitch * z1 - c_pitch * z2;
    const Scalar z172 = z137 - n0_35 * z158;
    const Scalar z173 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z174 = s_roll * z173;
    const Scalar z175 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z176 = s_roll * z171;
    const Scalar z177 = s_pitch * z2 + c_pitch * z1;
    const Scalar z178 = q_x - z115;
    const Scalar z179 = c_roll * z171;
    const Scalar z180 = q_z - z116;
    const Scalar z181 = s_yaw * z176 - c_yaw * z177;
    const Scalar z182 = c_yaw * z180;
    const Scalar z183 = s_roll * z178 + z16 * z180;
    const Scalar z184 = q_y - z118;
    const Scalar z185 = s_yaw * z177 + c_yaw * z176;
    const Scalar z186 = s_yaw * z180;
    const Scalar z187 = s_roll * z184 - z18 * z180;
    const Scalar z188 = c_yaw * z165;
    const Scalar z189 = s_yaw * z165;
    const Scalar z190 = v_pitch * z88;
    const Scalar z191 = v_pitch * z87;
    const Scalar z192 = z15 * z190 + z12 * z191 + s_pitch * z152 + c_pitch * z153 - n2 * (z93 * z87 - z94 * z88);
    const Scalar z193 = z12 * z190 - z15 * z191 + s_pitch * z153 - c_pitch * z152 - n2 * (z93 * z88 + z94 * z87);
    const Scalar z194 = n0_08 * z152 - n0_35 * z153;
    const Scalar z195 = s_yaw * z174 - c_yaw * z175;
    const Scalar z196 = c_roll * z173;
    const Scalar z197 = s_roll * z166 + z16 * z165;
    const Scalar z198 = n2 * z138;
    const Scalar z199 = s_roll * z167 - z18 * z165;
    const Scalar z200 = z37 * z42 - c_roll * z156 - c_steer * z34 - n2 * (z21 * z95 - z19 * z90) + s_roll * z192;
    const Scalar z201 = s_roll * z156 + c_steer * z37 + z34 * z42 + n2 * (z21 * z90 + z19 * z95) + c_roll * z192;
    const Scalar z202 = z35 * z41 - z39 * z52 - n2 * (z20 * z96 + z22 * z134) + s_yaw * z193 - c_yaw * z200;
    const Scalar z203 = z39 * z41 + z35 * z52 - n2 * (z20 * z134 - z22 * z96) + c_yaw * z193 + s_yaw * z200;
    const Scalar z204 = z136 * z198 + z63 * z201 + z53 * z202;
    const Scalar z205 = z139 * z198 + z60 * z201 + z53 * z203;
    const Scalar z206 = n2 * (z53 * z201 - z138 * z138);
    const Scalar z207 = n2 * (z64 * z204 - z140 * z140 - z141 * z141 - z146 * z146 - z72 * z206 + z62 * z205);
    const Scalar z208 = z9 * z156;
    const Scalar z209 = -z156 * (n1 - z8);
    const Scalar z210 = q_z - z196;
    const Scalar z211 = n0_35 * z208 + n0_08 * z209;
    const Scalar z212 = -z156 * (n1 - z10);
    const Scalar z213 = n0_08 * z208 + n0_35 * z212;
    const Scalar z214 = q_x - z195;
    const Scalar z215 = z115 - z214;
    const Scalar z216 = z116 - z210;
    const Scalar z217 = s_yaw * z175 + c_yaw * z174;
    const Scalar z218 = s_pitch * z211 - z54 * z191 - c_pitch * z213 + z55 * z190 + n2 * (z87 * z99 + z88 * z143);
    const Scalar z219 = q_y + z217;
    const Scalar z220 = n0_5 * (z154 * z157 / (z84 * z84) + z207 / z84);
    const Scalar z221 = z118 - z219;
    const Scalar z222 = z179 * z221 + z185 * z216;
    const Scalar z223 = z20 * z165 + s_yaw * z168;
    const Scalar z224 = c_yaw * z168 - z22 * z165;
    const Scalar z225 = z21 * z167 + z29 * z165 + s_roll * z169 - z18 * z168;
    const Scalar z226 = z37 * z40 + s_roll * z194 + z34 * z65 - n2 * (z21 * z147 + z19 * z155) + c_roll * z218;
    const Scalar z227 = c_roll * z147 - z19 * z40 - z21 * z65 + s_roll * z155;
    const Scalar z228 = s_pitch * z143 + c_pitch * z99 + z55 * z88 - z54 * z87;
    const Scalar z229 = v_yaw * z169 - v_roll * z223 + z225 * (v_pitch + v_rear);
    const Scalar z230 = z77 - z115;
    const Scalar z231 = z70 - z116;
    const Scalar z232 = z76 - z118;
    const Scalar z233 = n0_35 * z157 / (z84 * z84);
    const Scalar z234 = z21 * z166 - z28 * z165 + s_roll * z170 + z16 * z168;
    const Scalar z235 = v_yaw * z170 - v_roll * z224 + z234 * (v_pitch + v_rear);
    const Scalar z236 = z226 - n0_35 * z220;
    const Scalar z237 = z72 * z233 - z160 - z102 * z140;
    const Scalar z238 = z160 + z237;
    const Scalar z239 = z179 * z215 - z181 * z216;
    const Scalar z240 = z53 * z230 - z60 * z231;
    const Scalar z241 = z53 * z232 - z63 * z231;
    const Scalar z242 = v_yaw * s_roll;
    const Scalar z243 = v_yaw * c_roll;
    const Scalar z244 = v_pitch + z242;  // angular velocity of frame, y
    const Scalar z245 = v_roll * z242;  // angular acceleration of frame.2, z
    const Scalar z246 = v_roll * c_pitch - s_pitch * z243;
    const Scalar z247 = v_roll * s_pitch + c_pitch * z243;
    const Scalar z248 = s_pitch * z245;
    const Scalar z249 = c_pitch * z245;
    const Scalar z250 = n9_81 * c_roll;
    const Scalar z251 = v_pitch * z247 - z248;  // angular acceleration of frame, x
    const Scalar z252 = v_pitch * z246 - z249;  // angular acceleration of frame, z
    const Scalar z253 = v_roll * z243;  // angular acceleration of frame.2, y
    const Scalar z254 = z244 * z244;
    const Scalar z255 = z247 * z247;
    const Scalar z256 = s_pitch * z250;
    const Scalar z257 = c_pitch * z250;
    const Scalar z258 = n9_81 * s_roll;
    const Scalar z259 = v_rear + z244;  // angular velocity of rear_wheel, y
    const Scalar z260 = n0_3 * z87 - n1_1 * z88;
    const Scalar z261 = s_yaw * z227 - c_yaw * z228 - z20 * z66 - z22 * z67;
    const Scalar z262 = s_yaw * z228 - z20 * z67 + z22 * z66 + c_yaw * z227;
    const Scalar z263 = v_x + z261;
    const Scalar z264 = z263 - z102 * z146 + z62 * z233;
    const Scalar z265 = v_y - z262;
    const Scalar z266 = z265 - z102 * z141 + z64 * z233;
    const Scalar z267 = z254 + z255;
    const Scalar z268 = z246 * z247;
    const Scalar z269 = z246 * z244;
    const Scalar z270 = z253 + z268;
    const Scalar z271 = z1 * z88 - z2 * z87;
    const Scalar z272 = z263 - z264;
    const Scalar z273 = z1 * z87 + z2 * z88;
    const Scalar z274 = n1_1 * z87 + n0_3 * z88;
    const Scalar z275 = z53 * z272 - z138 * z230 - z139 * z231 - z60 * z238;
    const Scalar z276 = z265 - z266;
    const Scalar z277 = z53 * z276 - z138 * z232 - z136 * z231 - z63 * z238;
    const Scalar z278 = z21 * z173 + s_roll * z274;
    const Scalar z279 = c_roll * z274 - z19 * z173;
    const Scalar z280 = c_roll * z273 - z19 * z171;
    const Scalar z281 = z21 * z171 + s_roll * z273;
    const Scalar z282 = v_z - z279;
    const Scalar z283 = z237 + z282;
    const Scalar z284 = v_z + z237;
    const Scalar z285 = z22 * z175 - c_yaw * z260 + z20 * z174 + s_yaw * z278;
    const Scalar z286 = z20 * z175 + s_yaw * z260 - z22 * z174 + c_yaw * z278;
    const Scalar z287 = v_x - z285;
    const Scalar z288 = z264 - z287;
    const Scalar z289 = v_x - z264;
    const Scalar z290 = z21 * z178 - z28 * z180 + s_roll * z289 + z16 * z284;
    const Scalar z291 = v_y + z286;
    const Scalar z292 = z266 - z291;
    const Scalar z293 = v_y - z266;
    const Scalar z294 = z21 * z184 + z29 * z180 + s_roll * z293 - z18 * z284;
    const Scalar z295 = z252 + z269;
    const Scalar z296 = z247 * z244;
    const Scalar z297 = z251 + z296;
    const Scalar z298 = z22 * z177 + c_yaw * z271 + z20 * z176 + s_yaw * z281;
    const Scalar z299 = s_yaw * z271 - z20 * z177 + z22 * z176 - c_yaw * z281;
    const Scalar z300 = z215 * z280 - z216 * z298 + z179 * z288 + z181 * z283;
    const Scalar z301 = z221 * z280 - z216 * z299 + z179 * z292 - z185 * z283;
    const Scalar z302 = z20 * z180 + s_yaw * z284;
    const Scalar z303 = c_yaw * z284 - z22 * z180;
    const Scalar z304 = v_yaw * z289 + v_pitch * z290 + v_steer * z300 - v_roll * z303 + v_front * z275;
    const Scalar z305 = v_yaw * z293 - v_roll * z302 + v_pitch * z294 + v_steer * z301 + v_front * z277;
    const Scalar z306 = z12 * z244 + z11 * z246 - z13 * z247;
    const Scalar z307 = z253 - z268;
    const Scalar z308 = z2 * v_steer;
    const Scalar z309 = z246 * z246;
    const Scalar z310 = z254 + z309;
    const Scalar z311 = z255 - z309;
    const Scalar z312 = z15 * z244 - z11 * z247 + z14 * z246;
    const Scalar z313 = c_steer * z244 - z15 * z246 + z12 * z247;
    const Scalar z314 = z246 * z259;
    const Scalar z315 = z247 * z259;
    const Scalar z316 = n0_12 * z314;  // moment on rear_wheel, z
    const Scalar z317 = n0_12 * z315;  // moment on rear_wheel, x
    const Scalar z318 = z1 * v_steer;
    const Scalar z319 = z306 - z308;  // angular velocity of fork, z
    const Scalar z320 = z1 * z306 + z2 * z312;
    const Scalar z321 = z312 + z318;  // angular velocity of fork, x
    const Scalar z322 = c_steer * z253 + z15 * z251 + z12 * z252;
    const Scalar z323 = v_steer * z320 - z322;  // angular acceleration of fork, y
    const Scalar z324 = z256 - n1_1 * z267 + n0_3 * z270;
    const Scalar z325 = z313 * z313;
    const Scalar z326 = z319 * z319;
    const Scalar z327 = z258 - n1_1 * z295 - n0_3 * z297;
    const Scalar z328 = z257 + n1_1 * z307 + n0_3 * z310;
    const Scalar z329 = z325 + z326;
    const Scalar z330 = z321 * z319;
    const Scalar z331 = z11 * z251 - z12 * z253 + z13 * z252;
    const Scalar z332 = z14 * z251 - z15 * z253 + z11 * z252;
    const Scalar z333 = z313 * z318 - z331;  // angular acceleration of fork, z
    const Scalar z334 = z313 * z308 - z332;  // angular acceleration of fork, x
    const Scalar z335 = z242 * z243;
    const Scalar z336 = n2 * z245;
    const Scalar z337 = z323 + z330;
    const Scalar z338 = z323 - z330;
    const Scalar z339 = z321 * z321;
    const Scalar z340 = z325 + z339;
    const Scalar z341 = z326 - z339;
    const Scalar z342 = v_front + z313;  // angular velocity of front_wheel, y
    const Scalar z343 = z14 * z324 - z15 * z327 + z11 * z328;
    const Scalar z344 = n1_04 * z329 + n3_85 * z337 + n7 * z343;  // force on fork, x
    const Scalar z345 = z15 * z324 + z12 * z328 + c_steer * z327;
    const Scalar z346 = z11 * z324 - z12 * z327 + z13 * z328;
    const Scalar z347 = n1_04 * z338 - n3_85 * z340 + n7 * z346;  // force on fork, z
    const Scalar z348 = z3 * z15;
    const Scalar z349 = n0_28 * c_steer;
    const Scalar z350 = n0_28 * z12;
    const Scalar z351 = n0_28 * z15;
    const Scalar z352 = s_pitch * z350 - c_pitch * z351;
    const Scalar z353 = s_pitch * z351 + c_pitch * z350;
    const Scalar z354 = z313 * z321;
    const Scalar z355 = z321 * z342;
    const Scalar z356 = z313 * z319;
    const Scalar z357 = z319 * z342;
    const Scalar z358 = n0_28 * z355;  // moment on front_wheel, z
    const Scalar z359 = n0_28 * z357;  // moment on front_wheel, x
    const Scalar z360 = c_steer * z3;
    const Scalar z361 = z333 - z354;
    const Scalar z362 = s_roll * z349 + c_roll * z353;
    const Scalar z363 = n3_85 * z345 - z359 - k17 * z356 - k3 * z334 - k4 * z361;  // moment on fork, x
    const Scalar z364 = z334 + z356;
    const Scalar z365 = k18 * z354 + z358 - k5 * z333 - k4 * z364 + n1_04 * z345;  // moment on fork, z
    const Scalar z366 = n7 * z345 - n1_04 * z361 - n3_85 * z364;  // force on fork, y
    const Scalar z367 = z4 * z15 + z5 * z12;
    const Scalar z368 = z3 * z12;
    const Scalar z369 = n0_3 * z348 - z367 + n1_1 * z368;
    const Scalar z370 = z4 * z11 + z5 * z13;
    const Scalar z371 = n1_1 * z360 - z370;
    const Scalar z372 = z5 * z11 + z4 * z14;
    const Scalar z373 = n0_3 * z360 - z372;
    const Scalar z374 = s_pitch * z348 + c_pitch * z368;
    const Scalar z375 = s_pitch * z368 - c_pitch * z348;
    const Scalar z376 = s_pitch * z371 - c_pitch * z373;
    const Scalar z377 = n0_28 * z323;  // moment on front_wheel, y
    // moment on fork, y
    const Scalar z378 = z377 + k19 * z330 + k4 * z341 + n2_5667 * z323 + n3_85 * z343 + n1_04 * z346;
    const Scalar z379 = s_pitch * z373 + c_pitch * z371;
    const Scalar z380 = s_roll * z369 - c_roll * z379;
    const Scalar z381 = n1_04 * z11 - n3_85 * z13;
    const Scalar z382 = n1_04 * z14 - n3_85 * z11;
    const Scalar z383 = n1_04 * z15 - n3_85 * z12;
    const Scalar z384 = s_roll * z360 + c_roll * z374;
    const Scalar z385 = s_roll * z374 - c_roll * z360;
    const Scalar z386 = s_yaw * z375 - c_yaw * z385;
    const Scalar z387 = c_yaw * z375 + s_yaw * z385;
    const Scalar z388 = n0_12 * z253;  // moment on rear_wheel, y
    const Scalar z389 = z14 * z344 + z11 * z347 + z15 * z366;
    const Scalar z390 = n25_5 * z267 - z389 + n51 * z270;  // force on frame, x
    const Scalar z391 = k4 * z11;
    const Scalar z392 = z11 * z344 + z13 * z347 + z12 * z366;
    const Scalar z393 = c_steer * z366 - z15 * z344 - z12 * z347;
    const Scalar z394 = z392 + n25_5 * z307 - n51 * z310;  // force on frame, z
    const Scalar z395 = n2_8467 * z15;
    const Scalar z396 = k3 * z14 + z391;
    const Scalar z397 = z13 * z365 + z11 * z363 - z12 * z378;
    const Scalar z398 = n25_5 * z258 - z316 - n9_95 * z295 + n17_7 * z297 + n1_1 * z393 - z397;  // moment on frame, z
    const Scalar z399 = s_pitch * z390 - c_pitch * z394;
    const Scalar z400 = s_pitch * z394 + c_pitch * z390;
    const Scalar z401 = n25_5 * z295 - z393 - n51 * z297;  // force on frame, y
    const Scalar z402 = z11 * z365 + z14 * z363 - z15 * z378;
    const Scalar z403 = n51 * z258 + z317 - n17_7 * z295 + n39_3 * z297 - n0_3 * z393 + z402;  // moment on frame, x
    const Scalar z404 = z12 * z365 + z15 * z363 + c_steer * z378;
    // moment on frame, y
    const Scalar z405 = z388 + n49_25 * z253 - n51 * z256 + n25_5 * z257 + n29_35 * z268 + n17_7 * z311 + n0_3 * z389
        + n1_1 * z392 - z404;
    const Scalar z406 = z1 * z363 - z2 * z365;
    const Scalar z407 = k5 * z13 + z391;
    const Scalar z408 = n2_8467 * z12;
    const Scalar z409 = k3 * z11 + k4 * z13;
    const Scalar z410 = z12 * z408 + z11 * z409 + z13 * z407;
    const Scalar z411 = n2_8467 * c_steer;
    const Scalar z412 = k5 * z11 + k4 * z14;
    const Scalar z413 = z15 * z395 + z14 * z396 + z11 * z412;
    const Scalar z414 = k3 * z15 + k4 * z12;
    const Scalar z415 = n0_63 + n0_6 * z381 + z413;
    const Scalar z416 = k4 * z15 + k5 * z12;
    const Scalar z417 = z15 * z408 + z14 * z409 + z11 * z407;
    const Scalar z418 = c_steer * z408 - z15 * z409 - z12 * z407;
    const Scalar z419 = z14 * z414 - z15 * z411 + z11 * z416;
    const Scalar z420 = c_steer * z411 + z15 * z414 + z12 * z416;
    const Scalar z421 = n2_31 + n1_1 * z381 - n0_3 * z382 + z417;
    const Scalar z422 = n9_1 + n0_6 * z381 - n2_2 * z382 + z420;
    const Scalar z423 = n1_1 * z383 + z419;
    const Scalar z424 = s_roll * z399 - c_roll * z401;
    const Scalar z425 = s_roll * z401 + c_roll * z399;
    const Scalar z426 = n853_47 - z425;  // force on frame.z, z
    const Scalar z427 = s_pitch * z398 + c_pitch * z403;
    const Scalar z428 = s_pitch * z403 - c_pitch * z398;
    const Scalar z429 = z427 - n0_5603 * z335;  // moment on frame.2, x
    const Scalar z430 = z428 - n0_5603 * z336;  // moment on frame.2, z
    const Scalar z431 = n8_47 - n2_2 * z382 + z410;
    const Scalar z432 = n17_7 - z421;
    const Scalar z433 = n49_25 + z422;
    const Scalar z434 = n0_3 * z383 + z418;
    const Scalar z435 = n2_1 + z381;
    const Scalar z436 = n7_7 - z382;
    const Scalar z437 = n51 - z435;
    const Scalar z438 = n25_5 + z436;
    const Scalar z439 = s_roll * z405 + c_roll * z430;
    const Scalar z440 = n29_35 - z431;
    const Scalar z441 = s_yaw * z424 - c_yaw * z400;
    const Scalar z442 = s_yaw * z400 + c_yaw * z424;
    const Scalar z443 = z415 + z440;
    const Scalar z444 = n2 * z432;
    const Scalar z445 = s_pitch * z443 - c_pitch * z444;
    const Scalar z446 = c_steer * z349 - z433;
    const Scalar z447 = n0_12 + z433;
    const Scalar z448 = n25_over_7 * z349;
    const Scalar z449 = z7 * z369;
    const Scalar z450 = s_pitch * z434 + c_pitch * z423;
    const Scalar z451 = s_pitch * z423 - c_pitch * z434;
    const Scalar z452 = c_pitch * z445 + z432;
    const Scalar z453 = s_pitch * z445;
    const Scalar z454 = n25_over_7 * z352;
    const Scalar z455 = z352 * z448 - z450;
    const Scalar z456 = z440 - z453;
    const Scalar z457 = z415 - z453;
    const Scalar z458 = s_roll * z450 - c_roll * z452;
    const Scalar z459 = n39_8603 - z456;
    const Scalar z460 = n39_8603 + z457;
    const Scalar z461 = n2 * z451;
    const Scalar z462 = s_roll * z447 - c_roll * z451;
    const Scalar z463 = z352 * z454 - z460;
    const Scalar z464 = z447 - z459;
    const Scalar z465 = z362 * z448 - z462;
    const Scalar z466 = z362 * z454 - z458;
    const Scalar z467 = s_roll * z464 - c_roll * z461;
    const Scalar z468 = z7 * z376;
    const Scalar z469 = n25_over_7 * z362;
    const Scalar z470 = n0_12 * s_roll;
    const Scalar z471 = z470 + z465;
    const Scalar z472 = n25_over_3 * z470;
    const Scalar z473 = z7 * z380;
    const Scalar z474 = c_pitch * z437 + s_pitch * z438;
    const Scalar z475 = s_pitch * z437 - c_pitch * z438;
    const Scalar z476 = z376 * z468 + z463;
    const Scalar z477 = s_roll * z467;
    const Scalar z478 = z380 * z468 - z466;
    const Scalar z479 = z459 + z477;
    const Scalar z480 = c_roll * z475;
    const Scalar z481 = s_roll * z474 - c_roll * z383;
    const Scalar z482 = z362 * z469 - z479;
    const Scalar z483 = s_roll * z383 + c_roll * z474;
    const Scalar z484 = z7 * z384;
    const Scalar z485 = z384 * z473;
    const Scalar z486 = z384 * z468 - z481;
    const Scalar z487 = z470 * z472 + z482;
    const Scalar z488 = n94 - z384 * z484;
    const Scalar z489 = s_roll * z475;
    const Scalar z490 = z384 * z449 + z480;
    const Scalar z491 = z380 * z449 + z471;
    const Scalar z492 = z380 * z473 + z487;
    const Scalar z493 = s_yaw * z474 + c_yaw * z489;
    const Scalar z494 = s_yaw * z489 - c_yaw * z474;
    const Scalar z495 = z369 * z449 + z446;
    const Scalar z496 = z376 * z449 - z455;
    const Scalar z497 = n1 / z495;
    const Scalar z498 = z386 * z449 - z493;
    const Scalar z499 = z387 * z449 + z494;
    const Scalar z500 = c_yaw * z483;
    const Scalar z501 = z386 * z468 - z500;
    const Scalar z502 = s_yaw * z483;
    const Scalar z503 = z387 * z468 + z502;
    const Scalar z504 = c_yaw * z475 + s_yaw * z481;
    const Scalar z505 = s_yaw * z475 - c_yaw * z481;
    const Scalar z506 = z386 * z473 - z504;
    const Scalar z507 = z387 * z473 + z505;
    const Scalar z508 = z7 * z386;
    const Scalar z509 = z386 * z484;
    const Scalar z510 = n94 - z386 * z508;
    const Scalar z511 = z496 * z497;
    const Scalar z512 = z491 * z497;
    const Scalar z513 = z490 * z497;
    const Scalar z514 = z498 * z497;
    const Scalar z515 = z7 * z387;
    const Scalar z516 = z476 - z496 * z511;
    const Scalar z517 = z478 - z491 * z511;
    const Scalar z518 = z492 - z491 * z512;
    const Scalar z519 = z485 - z490 * z512;
    const Scalar z520 = n1 / z516;
    const Scalar z521 = z486 - z490 * z511;
    const Scalar z522 = z488 + z490 * z513;
    const Scalar z523 = z509 - z498 * z513;
    const Scalar z524 = z506 - z498 * z512;
    const Scalar z525 = z501 - z498 * z511;
    const Scalar z526 = z510 + z498 * z514;
    const Scalar z527 = z507 - z499 * z512;
    const Scalar z528 = z503 - z499 * z511;
    const Scalar z529 = z387 * z508;
    const Scalar z530 = z529 - z499 * z514;
    const Scalar z531 = z387 * z484;
    const Scalar z532 = n94 - z387 * z515;
    const Scalar z533 = z531 - z499 * z513;
    const Scalar z534 = z499 * z497;
    const Scalar z535 = z532 + z499 * z534;
    const Scalar z536 = z517 * z520;
    const Scalar z537 = z521 * z520;
    const Scalar z538 = z525 * z520;
    const Scalar z539 = z528 * z520;
    const Scalar z540 = z518 - z517 * z536;
    const Scalar z541 = z519 - z521 * z536;
    const Scalar z542 = z522 + z521 * z537;
    const Scalar z543 = z523 - z525 * z537;
    const Scalar z544 = n1 / z540;
    const Scalar z545 = z524 - z525 * z536;
    const Scalar z546 = z526 + z525 * z538;
    const Scalar z547 = z530 - z528 * z538;
    const Scalar z548 = z533 - z528 * z537;
    const Scalar z549 = z527 - z528 * z536;
    const Scalar z550 = z535 + z528 * z539;
    const Scalar z551 = z189 * z536;
    const Scalar z552 = z145 + z172 * z449;
    const Scalar z553 = z133 + z172 * z468 - z511 * z552;
    const Scalar z554 = z81 * z536;
    const Scalar z555 = z172 * z473 - z512 * z552 - z536 * z553;
    const Scalar z556 = z541 * z544;
    const Scalar z557 = z545 * z544;
    const Scalar z558 = z549 * z544;
    const Scalar z559 = z188 * z536;
    const Scalar z560 = z550 + z549 * z558;
    const Scalar z561 = z542 + z541 * z556;
    const Scalar z562 = z543 - z545 * z556;
    const Scalar z563 = z546 + z545 * z557;
    const Scalar z564 = z547 - z549 * z557;
    const Scalar z565 = z548 - z549 * z556;
    const Scalar z566 = n1 / z561;
    const Scalar z567 = z188 * z537 - z556 * z559;
    const Scalar z568 = z189 * z537 - z556 * z551;
    const Scalar z569 = n1 + z172 * z484 - z513 * z552 - z537 * z553 - z556 * z555;
    const Scalar z570 = n1 + z81 * z537 - z556 * z554;
    const Scalar z571 = z565 * z566;
    const Scalar z572 = z562 * z566;
    const Scalar z573 = z560 - z565 * z571;
    const Scalar z574 = z564 + z565 * z572;
    const Scalar z575 = z187 + z222 * z449 - z241 * z448;
    const Scalar z576 = z563 - z562 * z572;
    const Scalar z577 = z186 + z222 * z468 + z241 * z454 - z511 * z575;
    const Scalar z578 = n1 - z188 * z538 + z557 * z559 - z572 * z567;
    const Scalar z579 = n1 / z576;
    const Scalar z580 = z184 + z222 * z473 - z241 * z469 - z512 * z575 - z536 * z577;
    const Scalar z581 = z189 * z538 - z557 * z551 + z572 * z568;
    const Scalar z582 = z172 * z508 - z514 * z552 - z538 * z553 - z557 * z555 + z572 * z569;
    const Scalar z583 = z574 * z579;
    const Scalar z584 = z222 * z484 - z513 * z575 - z537 * z577 - z556 * z580;
    const Scalar z585 = z573 - z574 * z583;
    const Scalar z586 = z222 * z508 - z514 * z575 - z538 * z577 - z557 * z580 + z572 * z584;
    const Scalar z587 = n1 / z585;
    const Scalar z588 = n1 - z222 * z515 + z534 * z575 + z539 * z577 + z558 * z580 - z571 * z584 - z583 * z586;
    const Scalar z589 = z188 * z539 - z558 * z559 + z571 * z567 - z583 * z578;
    const Scalar z590 = z587 * z588;
    const Scalar z591 = z587 * z589;
    const Scalar z592 = n1 + z189 * z539 - z558 * z551 + z571 * z568 + z583 * z581;
    const Scalar z593 = z579 * z586 - z583 * z590;
    const Scalar z594 = z579 * z578 - z583 * z591;
    const Scalar z595 = z566 * z567 + z571 * z591 - z572 * z594;
    const Scalar z596 = z587 * z592;
    const Scalar z597 = z579 * z581 + z583 * z596;
    const Scalar z598 = z544 * z559 + z558 * z591 - z557 * z594 + z556 * z595;
    const Scalar z599 = z566 * z568 + z571 * z596 + z572 * z597;
    const Scalar z600 = z188 * z520 - z539 * z591 + z538 * z594 - z537 * z595 + z536 * z598;
    const Scalar z601 = z544 * z551 + z558 * z596 + z557 * z597 + z556 * z599;
    const Scalar z602 = z534 * z591 - z514 * z594 + z513 * z595 - z512 * z598 + z511 * z600;
    const Scalar z603 = z515 * z591 - z508 * z594 + z484 * z595 - z473 * z598 + z468 * z600 - z449 * z602;
    const Scalar z604 = n25_over_3 * z197 - z602 - z472 * z598;
    const Scalar z605 = z469 * z598 + z454 * z600 + z448 * z602;
    const Scalar z606 = z172 * z515 - z534 * z552 - z539 * z553 - z558 * z555 + z571 * z569 + z583 * z582;
    const Scalar z607 = z587 * z606;
    const Scalar z608 = z189 * z520 - z539 * z596 - z538 * z597 - z537 * z599 + z536 * z601;
    const Scalar z609 = z579 * z582 + z583 * z607;
    const Scalar z610 = z534 * z596 + z514 * z597 + z513 * z599 - z512 * z601 + z511 * z608;
    const Scalar z611 = z566 * z569 + z571 * z607 + z572 * z609;
    const Scalar z612 = z544 * z555 + z558 * z607 + z557 * z609 + z556 * z611;
    const Scalar z613 = z515 * z596 + z508 * z597 + z484 * z599 - z473 * z601 + z468 * z608 - z449 * z610;
    const Scalar z614 = z520 * z553 + z539 * z607 + z538 * z609 + z537 * z611 - z536 * z612;
    const Scalar z615 = z497 * z552 + z534 * z607 + z514 * z609 + z513 * z611 - z512 * z612 - z511 * z614;
    const Scalar z616 = z81 * z538 - z557 * z554 + z572 * z570;
    const Scalar z617 = z566 * z584 - z571 * z590 + z572 * z593;
    const Scalar z618 = n25_over_3 * z199 - z610 - z472 * z601;
    const Scalar z619 = z469 * z601 + z454 * z608 + z448 * z610;
    const Scalar z620 = z81 * z539 - z558 * z554 + z571 * z570 + z583 * z616;
    const Scalar z621 = z544 * z580 - z558 * z590 + z557 * z593 + z556 * z617;
    const Scalar z622 = z587 * z620;
    const Scalar z623 = z520 * z577 - z539 * z590 + z538 * z593 + z537 * z617 - z536 * z621;
    const Scalar z624 = z579 * z616 + z583 * z622;
    const Scalar z625 = z497 * z575 - z534 * z590 + z514 * z593 + z513 * z617 - z512 * z621 - z511 * z623;
    const Scalar z626 = z566 * z570 + z571 * z622 + z572 * z624;
    const Scalar z627 = z544 * z554 + z558 * z622 + z557 * z624 + z556 * z626;
    const Scalar z628 = z7 * z222 - z515 * z590 + z508 * z593 + z484 * z617 - z473 * z621 - z468 * z623 - z449 * z625;
    const Scalar z629 = z7 * z172 + z515 * z607 + z508 * z609 + z484 * z611 - z473 * z612 - z468 * z614 - z449 * z615;
    const Scalar z630 = z472 * z612 + z615;
    const Scalar z631 = z469 * z612 - z454 * z614 + z448 * z615;
    const Scalar z632 = z81 * z520 - z539 * z622 - z538 * z624 - z537 * z626 + z536 * z627;
    const Scalar z633 = n25_over_7 * z241 + z469 * z621 - z454 * z623 + z448 * z625;
    const Scalar z634 = z534 * z622 + z514 * z624 + z513 * z626 - z512 * z627 + z511 * z632;
    const Scalar z635 = z183 + z239 * z449 - z240 * z448;
    const Scalar z636 = z515 * z622 + z508 * z624 + z484 * z626 - z473 * z627 + z468 * z632 - z449 * z634;
    const Scalar z637 = z182 + z239 * z468 + z240 * z454 - z511 * z635;
    const Scalar z638 = z472 * z627 + z634;
    const Scalar z639 = z178 + z239 * z473 - z240 * z469 - z512 * z635 - z536 * z637;
    const Scalar z640 = z469 * z627 + z454 * z632 + z448 * z634;
    const Scalar z641 = z239 * z484 - z513 * z635 - z537 * z637 - z556 * z639;
    const Scalar z642 = n1 + z239 * z508 - z514 * z635 - z538 * z637 - z557 * z639 + z572 * z641;
    const Scalar z643 = z239 * z515 - z534 * z635 - z539 * z637 - z558 * z639 + z571 * z641 + z583 * z642;
    const Scalar z644 = z587 * z643;
    const Scalar z645 = z178 * z621 - z593 + z182 * z623 + z183 * z625 - z239 * z628 - z240 * z633;
    const Scalar z646 = z579 * z642 + z583 * z644;
    const Scalar z647 = z566 * z641 + z571 * z644 + z572 * z646;
    const Scalar z648 = z184 * z621 - z590 + z186 * z623 + z187 * z625 - z222 * z628 - z241 * z633;
    const Scalar z649 = z544 * z639 + z558 * z644 + z557 * z646 + z556 * z647;
    const Scalar z650 = z520 * z637 + z539 * z644 + z538 * z646 + z537 * z647 - z536 * z649;
    const Scalar z651 = z497 * z635 + z534 * z644 + z514 * z646 + z513 * z647 - z512 * z649 - z511 * z650;
    const Scalar z652 = z7 * z239 + z515 * z644 + z508 * z646 + z484 * z647 - z473 * z649 - z468 * z650 - z449 * z651;
    const Scalar z653 = n25_over_7 * z240 + z469 * z649 - z454 * z650 + z448 * z651;
    const Scalar z654 = z178 * z649 - z646 + z182 * z650 + z183 * z651 - z239 * z652 - z240 * z653;
    const Scalar z655 = n1 / z654;
    const Scalar z656 = z591 + z184 * z598 - z186 * z600 + z187 * z602 - z222 * z603 - z241 * z605;
    const Scalar z657 = z594 + z178 * z598 - z182 * z600 + z183 * z602 - z239 * z603 - z240 * z605;
    const Scalar z658 = z594 + z166 * z598 - z188 * z600 + z197 * (z602 + z604);
    const Scalar z659 = z645 * z655;
    const Scalar z660 = z657 * z655;
    const Scalar z661 = z166 * z601 - z597 - z188 * z608 + z197 * (z610 + z618);
    const Scalar z662 = z648 - z645 * z659;
    const Scalar z663 = z656 - z657 * z659;
    const Scalar z664 = n1 / z662;
    const Scalar z665 = z658 + z657 * z660;
    const Scalar z666 = z596 + z184 * z601 - z186 * z608 + z187 * z610 - z222 * z613 - z241 * z619;
    const Scalar z667 = z178 * z601 - z597 - z182 * z608 + z183 * z610 - z239 * z613 - z240 * z619;
    const Scalar z668 = z661 + z667 * z660;
    const Scalar z669 = z666 - z667 * z659;
    const Scalar z670 = z596 + z167 * z601 - z189 * z608 + z199 * (z610 + z618);
    const Scalar z671 = z667 * z655;
    const Scalar z672 = z670 + z667 * z671;
    const Scalar z673 = z607 + z167 * z612 + z189 * z614 + z199 * (z615 - z630);
    const Scalar z674 = z166 * z612 - z609 + z188 * z614 + z197 * (z615 - z630);
    const Scalar z675 = z607 + z184 * z612 + z186 * z614 + z187 * z615 - z222 * z629 - z241 * z631;
    const Scalar z676 = z178 * z612 - z609 + z182 * z614 + z183 * z615 - z239 * z629 - z240 * z631;
    const Scalar z677 = z673 + z676 * z671;
    const Scalar z678 = z674 + z676 * z660;
    const Scalar z679 = z675 - z676 * z659;
    const Scalar z680 = z133 * z614 - z611 + z145 * z615 - z172 * z629;
    const Scalar z681 = z676 * z655;
    const Scalar z682 = z680 - z676 * z681;
    const Scalar z683 = z626 + z133 * z632 - z145 * z634 + z172 * z636;
    const Scalar z684 = z622 + z167 * z627 - z189 * z632 + z199 * (z634 - z638);
    const Scalar z685 = z166 * z627 - z624 - z188 * z632 + z197 * (z634 - z638);
    const Scalar z686 = z622 + z184 * z627 - z186 * z632 + z187 * z634 - z222 * z636 - z241 * z640;
    const Scalar z687 = z178 * z627 - z624 - z182 * z632 + z183 * z634 - z239 * z636 - z240 * z640;
    const Scalar z688 = z683 + z687 * z681;
    const Scalar z689 = z684 + z687 * z671;
    const Scalar z690 = z685 + z687 * z660;
    const Scalar z691 = z686 - z687 * z659;
    const Scalar z692 = z81 * z632 - z626;
    const Scalar z693 = z687 * z655;
    const Scalar z694 = z692 - z687 * z693;
    const Scalar z695 = z472 * z621 + z625;
    const Scalar z696 = z663 * z664;
    const Scalar z697 = z665 + z663 * z696;
    const Scalar z698 = z668 + z669 * z696;
    const Scalar z699 = z678 + z679 * z696;
    const Scalar z700 = z690 + z691 * z696;
    const Scalar z701 = n1 / z697;
    const Scalar z702 = z669 * z664;
    const Scalar z703 = z672 + z669 * z702;
    const Scalar z704 = z677 + z679 * z702;
    const Scalar z705 = z689 + z691 * z702;
    const Scalar z706 = z679 * z664;
    const Scalar z707 = z682 - z679 * z706;
    const Scalar z708 = z688 + z691 * z706;
    const Scalar z709 = z691 * z664;
    const Scalar z710 = z694 - z691 * z709;
    const Scalar z711 = z472 * z649 + z651;
    const Scalar z712 = z692 + z680 - z670 - z658 + z648 + z654;
    const Scalar z713 = n4096 * z712;
    const Scalar z714 = z377 * z448 - z388 - z406 * z449 + z405;
    const Scalar z715 = z377 * z454 + z406 * z468 + z511 * z714 - z429;
    const Scalar z716 = z698 * z701;
    const Scalar z717 = z703 - z698 * z716;
    const Scalar z718 = z704 - z699 * z716;
    const Scalar z719 = z705 - z700 * z716;
    const Scalar z720 = z699 * z701;
    const Scalar z721 = z707 + z699 * z720;
    const Scalar z722 = z377 * z469 - z388 * z472 - z406 * z473 - z512 * z714 + z536 * z715 + z439;
    const Scalar z723 = n1 / z717;
    const Scalar z724 = z708 - z700 * z720;
    const Scalar z725 = z426 - z406 * z484 - z513 * z714 + z537 * z715 - z556 * z722;
    const Scalar z726 = z442 - z406 * z508 - z514 * z714 + z538 * z715 - z557 * z722 + z572 * z725;
    const Scalar z727 = z441 + z406 * z515 + z534 * z714 - z539 * z715 + z558 * z722 - z571 * z725 - z583 * z726;
    const Scalar z728 = z587 * z727;
    const Scalar z729 = z718 * z723;
    const Scalar z730 = z721 + z718 * z729;
    const Scalar z731 = z724 - z719 * z729;
    const Scalar z732 = z579 * z726 - z583 * z728;
    const Scalar z733 = z700 * z701;
    const Scalar z734 = z710 + z700 * z733;
    const Scalar z735 = n1 / z730;
    const Scalar z736 = z719 * z723;
    const Scalar z737 = z566 * z725 - z571 * z728 + z572 * z732;
    const Scalar z738 = z734 + z719 * z736;
    const Scalar z739 = z544 * z722 - z558 * z728 + z557 * z732 + z556 * z737;
    const Scalar z740 = z520 * z715 + z539 * z728 - z538 * z732 - z537 * z737 + z536 * z739;
    const Scalar z741 = z731 * z735;
    const Scalar z742 = z497 * z714 - z534 * z728 + z514 * z732 + z513 * z737 - z512 * z739 + z511 * z740;
    const Scalar z743 = z7 * z406 + z515 * z728 - z508 * z732 - z484 * z737 + z473 * z739 - z468 * z740 + z449 * z742;
    const Scalar z744 = n25_over_7 * z377 - z469 * z739 - z454 * z740 - z448 * z742;
    const Scalar z745 = z305 - z728 + z184 * z739 - z186 * z740 + z187 * z742 + z222 * z743 + z241 * z744;
    const Scalar z746 = z304 - z732 + z178 * z739 - z182 * z740 + z183 * z742 + z239 * z743 + z240 * z744;
    const Scalar z747 = z236 + z737 + z133 * z740 - z145 * z742 - z172 * z743;
    const Scalar z748 = z742 + n25_over_3 * z388 + z472 * z739;
    const Scalar z749 = z229 - z728 + z167 * z739 - z189 * z740 + z199 * (z742 - z748);
    const Scalar z750 = z235 - z732 + z166 * z739 - z188 * z740 + z197 * (z742 - z748);
    const Scalar z751 = z100 - z737 + z81 * z740;
    const Scalar z752 = z738 - z731 * z741;
    const Scalar z753 = z659 * z746 - z745;
    const Scalar z754 = z750 + z660 * z746 - z696 * z753;
    const Scalar z755 = n1 / z752;
    const Scalar z756 = z749 + z671 * z746 - z702 * z753 - z716 * z754;
    const Scalar z757 = z747 + z681 * z746 - z706 * z753 - z720 * z754 - z729 * z756;
    const Scalar z758 = z693 * z746 - z751 - z709 * z753 - z733 * z754 - z736 * z756 + z741 * z757;
    const Scalar z759 = z755 * z758;
    const Scalar z760 = z735 * z757 + z741 * z759;
    const Scalar z761 = z723 * z756 + z736 * z759 + z729 * z760;
    const Scalar z762 = z701 * z754 + z733 * z759 + z720 * z760 - z716 * z761;
    const Scalar z763 = z664 * z753 - z709 * z759 - z706 * z760 + z702 * z761 + z696 * z762;
    const Scalar z764 = z655 * z746 + z693 * z759 + z681 * z760 - z671 * z761 - z660 * z762 + z659 * z763;
    const Scalar z765 = z622 * z759 - z728 + z607 * z760 - z596 * z761 - z591 * z762 - z590 * z763 - z644 * z764;
    const Scalar z766 = z732 + z624 * z759 + z609 * z760 - z597 * z761 + z594 * z762 + z593 * z763 - z646 * z764;
    const Scalar z767 = z737 + z626 * z759 + z611 * z760 - z599 * z761 - z595 * z762 + z617 * z763 - z647 * z764;
    const Scalar z768 = z739 + z627 * z759 + z612 * z760 - z601 * z761 - z598 * z762 + z621 * z763 - z649 * z764;
    const Scalar z769 = z740 + z632 * z759 - z614 * z760 - z608 * z761 - z600 * z762 - z623 * z763 + z650 * z764;
    const Scalar z770 = z742 + z634 * z759 + z615 * z760 - z610 * z761 - z602 * z762 + z625 * z763 - z651 * z764;
    const Scalar z771 = z636 * z759 - z743 + z629 * z760 - z613 * z761 - z603 * z762 + z628 * z763 - z652 * z764;
    const Scalar z772 = z748 + z638 * z759 + z630 * z760 + z618 * z761 + z604 * z762 + z695 * z763 - z711 * z764;
    const Scalar z773 = z640 * z759 - z744 + z631 * z760 - z619 * z761 - z605 * z762 + z633 * z763 - z653 * z764;
    accelerations.x = z765;
    accelerations.y = z766;
    accelerations.z = z767;
    accelerations.yaw = z768;
    accelerations.roll = z769;
    accelerations.pitch = z770;
    accelerations.steer = -z771;
    accelerations.rear = -z772;
    accelerations.front = -z773;
    multipliers.lambda_rear_touches = -z759;
    multipliers.lambda_front_touches = -z760;
    multipliers.lambda_rear_rolls_x = -z761;
    multipliers.lambda_rear_rolls_y = -z762;
    multipliers.lambda_front_rolls_x = -z763;
    multipliers.lambda_front_rolls_y = z764;
    if (!(traits::regular(z585, n94) && traits::regular(z576, n94) && traits::regular(z561, n94)
        && traits::regular(-z540, z479) && traits::regular(-z516, z460) && traits::regular(-z495, z447)
        && traits::regular(z6, z6) && traits::regular(-z752, -z713) && traits::regular(-z730, -z713)
        && traits::regular(z717, -z713) && traits::regular(z697, -z713) && traits::regular(-z662, -z713)
        && traits::regular(-z654, -z713))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.z * accelerations.yaw
        * accelerations.roll * accelerations.pitch * accelerations.steer * accelerations.rear * accelerations.front
        * multipliers.lambda_rear_touches * multipliers.lambda_front_touches * multipliers.lambda_rear_rolls_x
        * multipliers.lambda_rear_rolls_y * multipliers.lambda_front_rolls_x * multipliers.lambda_front_rolls_y;
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    return Mechanism::forward_dynamics(precomputed, state, Inputs(), accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed&, const State& state, const Inputs&, Energy& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n2_8 = traits::constant(2.8, 2.8f, "14/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n85 = traits::constant(85.0, 85.0f, "85/1");
    const Scalar n39_8 = traits::constant(39.8, 39.8f, "199/5");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n10_45 = traits::constant(10.45, 10.45f, "209/20");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar k16 = traits::constant(2.01892, 2.01892f, "50473/25000");
    const Scalar k17 = traits::constant(0.56756, 0.56756f, "14189/25000");
    const Scalar n2_18 = traits::constant(2.18, 2.18f, "109/50");
    const Scalar k19 = traits::constant(0.16708, 0.16708f, "4177/25000");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar k21 = traits::constant(0.03015, 0.03015f, "603/20000");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar k23 = traits::constant(0.07025, 0.07025f, "281/4000");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n39_24 = traits::constant(39.24, 39.24f, "981/25");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar q_rear = state.q.rear;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar q_front = state.q.front;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_rear, q_steer, q_front};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_rear = sines_[3], c_rear = cosines_[3];
    const Scalar s_steer = sines_[4], c_steer = cosines_[4];
    const Scalar s_front = sines_[5], c_front = cosines_[5];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z4 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z5 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z6 = v_yaw * c_roll;
    const Scalar z7 = v_yaw * s_roll;
    const Scalar z8 = z2 * s_steer;
    const Scalar z9 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z10 = -z3 * (n1 - c_steer);
    const Scalar z11 = z1 * s_steer;
    const Scalar z12 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z13 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z14 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z15 = v_roll * c_pitch - s_pitch * z6;
    const Scalar z16 = v_roll * s_pitch + c_pitch * z6;
    const Scalar z17 = v_pitch + z7;  // angular velocity of frame, y
    const Scalar z18 = n0_8 * z8 - n2_8 * z11;
    const Scalar z19 = n0_08 * z8 - n0_35 * z11;
    const Scalar z20 = v_rear + z17;  // angular velocity of rear_wheel, y
    const Scalar z21 = v_z * s_roll - c_roll * z4;
    const Scalar z22 = v_z * c_roll + s_roll * z4;
    const Scalar z23 = s_rear * z16 - c_rear * z15;
    const Scalar z24 = s_rear * z15 + c_rear * z16;
    const Scalar z25 = z8 * z17 - z10 * z16 + z9 * z15;
    const Scalar z26 = c_steer * z17 - z8 * z15 + z11 * z16;
    const Scalar z27 = z11 * z17 + z10 * z15 - z12 * z16;
    const Scalar z28 = c_roll * z14;
    const Scalar z29 = c_roll * z13;
    const Scalar z30 = n0_8 * z9 - n2_8 * z10;
    const Scalar z31 = n0_8 * z10 - n2_8 * z12;
    const Scalar z32 = n0_08 * z9 - n0_35 * z10;
    const Scalar z33 = n0_08 * z10 - n0_35 * z12;
    const Scalar z34 = q_z - z29;
    const Scalar z35 = s_pitch * z22 - c_pitch * z5;
    const Scalar z36 = s_pitch * z5 + c_pitch * z22;
    const Scalar z37 = z21 - n0_3 * z15 + n1_1 * z16;
    const Scalar z38 = n51 * z15 + n25_5 * z16 + n85 * z21;
    const Scalar z39 = n39_8 * z15 + n17_7 * z16 + n51 * z21;
    const Scalar z40 = n17_7 * z15 + n10_45 * z16 + n25_5 * z21;
    const Scalar z41 = n0_3 + z33;
    const Scalar z42 = n1_1 - z32;
    const Scalar z43 = c_pitch * z31 + s_pitch * z30;
    const Scalar z44 = z36 - n1_1 * z17;
    const Scalar z45 = z1 * v_steer + z25;  // angular velocity of fork, x
    const Scalar z46 = z35 - n0_3 * z17;
    const Scalar z47 = z2 * v_steer - z27;  // angular velocity of fork, z
    const Scalar z48 = s_pitch * z42 - c_pitch * z41;
    const Scalar z49 = s_rear * z36 + c_rear * z35;
    const Scalar z50 = z10 * z44 - z8 * z37 + z9 * z46;
    const Scalar z51 = z12 * z44 - z11 * z37 + z10 * z46;
    const Scalar z52 = c_steer * z37 + z8 * z46 + z11 * z44;
    const Scalar z53 = n0_35 * z26 + z50;
    const Scalar z54 = n0_08 * z26 + z51;
    const Scalar z55 = s_roll * z19 + c_roll * z48;
    const Scalar z56 = s_rear * z35 - c_rear * z36;
    const Scalar z57 = z52 + n0_35 * z45 - n0_08 * z47;
    const Scalar z58 = s_front * z47 - c_front * z45;
    const Scalar z59 = s_front * z45 + c_front * z47;
    const Scalar z60 = s_front * z54 + c_front * z53;
    const Scalar z61 = s_front * z53 - c_front * z54;
    const Scalar z62 = v_front + z26;  // angular velocity of front_wheel, y
    const Scalar z63 = n51 * z17 + n85 * z35;
    const Scalar z64 = n85 * z36 - n25_5 * z17;
    const Scalar z65 = n49_25 * z17 - n25_5 * z36 + n51 * z35;
    const Scalar z66 = n2_8 * z26 + n4 * z50;
    const Scalar z67 = n2_8 * z45 - n0_8 * z47 + n4 * z52;
    const Scalar z68 = n0_8 * z26 + n4 * z51;
    const Scalar z69 = k16 * z45 - k17 * z47 + n2_8 * z52;
    const Scalar z70 = n2_18 * z26 + n2_8 * z50 + n0_8 * z51;
    const Scalar z71 = k17 * z45 - k19 * z47 + n0_8 * z52;
    const Scalar z72 = s_roll * z18 - c_roll * z43;
    const Scalar z73 = q_z - z55;
    result.kinetic = z21 * z21 + n0_06 * z20 * z20 + k21 * (z23 * z23 + z24 * z24) + z49 * z49 + n0_14 * z62 * z62 + z56
        * z56 + k23 * (z58 * z58 + z59 * z59) + n1_5 * (z57 * z57 + z60 * z60 + z61 * z61) + n0_5 * (z21 * z38 + z15
        * z39 + z16 * z40 + z35 * z63 + z36 * z64 + z17 * z65 + z26 * z70 + z50 * z66 + z52 * z67 + z51 * z68 + z45
        * z69 - z47 * z71);
    result.force_function = n853_47 * q_z + n39_24 * z34 - n9_81 * (z28 + z72) + n29_43 * z73;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed&, const State& state, FirstIntegrals& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n0_8 = traits::constant(0.8, 0.8f, "4/5");
    const Scalar n2_8 = traits::constant(2.8, 2.8f, "14/5");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n85 = traits::constant(85.0, 85.0f, "85/1");
    const Scalar n39_8 = traits::constant(39.8, 39.8f, "199/5");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n10_45 = traits::constant(10.45, 10.45f, "209/20");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar k16 = traits::constant(2.01892, 2.01892f, "50473/25000");
    const Scalar k17 = traits::constant(0.56756, 0.56756f, "14189/25000");
    const Scalar n2_18 = traits::constant(2.18, 2.18f, "109/50");
    const Scalar k19 = traits::constant(0.16708, 0.16708f, "4177/25000");
    const Scalar n853_47 = traits::constant(853.47, 853.47f, "85347/100");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n39_24 = traits::constant(39.24, 39.24f, "981/25");
    const Scalar k23 = traits::constant(0.03015, 0.03015f, "603/20000");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n29_43 = traits::constant(29.43, 29.43f, "2943/100");
    const Scalar k27 = traits::constant(0.07025, 0.07025f, "281/4000");
    const Scalar n1_5 = traits::constant(1.5, 1.5f, "3/2");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar q_rear = state.q.rear;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar q_front = state.q.front;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_rear, q_steer, q_front};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_rear = sines_[3], c_rear = cosines_[3];
    const Scalar s_steer = sines_[4], c_steer = cosines_[4];
    const Scalar s_front = sines_[5], c_front = cosines_[5];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z4 = v_x * s_yaw - v_y * c_yaw;
    const Scalar z5 = v_x * c_yaw + v_y * s_yaw;
    const Scalar z6 = v_yaw * c_roll;
    const Scalar z7 = v_yaw * s_roll;
    const Scalar z8 = z2 * s_steer;
    const Scalar z9 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z10 = -z3 * (n1 - c_steer);
    const Scalar z11 = z1 * s_steer;
    const Scalar z12 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z13 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z14 = n25_5 * s_pitch + n51 * c_pitch;
    const Scalar z15 = v_roll * c_pitch - s_pitch * z6;
    const Scalar z16 = v_roll * s_pitch + c_pitch * z6;
    const Scalar z17 = v_pitch + z7;  // angular velocity of frame, y
    const Scalar z18 = n0_8 * z8 - n2_8 * z11;
    const Scalar z19 = n0_08 * z8 - n0_35 * z11;
    const Scalar z20 = v_rear + z17;  // angular velocity of rear_wheel, y
    const Scalar z21 = v_z * s_roll - c_roll * z4;
    const Scalar z22 = v_z * c_roll + s_roll * z4;
    const Scalar z23 = s_rear * z16 - c_rear * z15;
    const Scalar z24 = s_rear * z15 + c_rear * z16;
    const Scalar z25 = z8 * z17 - z10 * z16 + z9 * z15;
    const Scalar z26 = c_steer * z17 - z8 * z15 + z11 * z16;
    const Scalar z27 = z11 * z17 + z10 * z15 - z12 * z16;
    const Scalar z28 = c_roll * z14;
    const Scalar z29 = c_roll * z13;
    const Scalar z30 = n0_8 * z9 - n2_8 * z10;
    const Scalar z31 = n0_8 * z10 - n2_8 * z12;
    const Scalar z32 = n0_08 * z9 - n0_35 * z10;
    const Scalar z33 = n0_08 * z10 - n0_35 * z12;
    const Scalar z34 = q_z - z29;
    const Scalar z35 = s_pitch * z22 - c_pitch * z5;
    const Scalar z36 = s_pitch * z5 + c_pitch * z22;
    const Scalar z37 = z21 - n0_3 * z15 + n1_1 * z16;
    const Scalar z38 = n51 * z15 + n25_5 * z16 + n85 * z21;
    const Scalar z39 = n39_8 * z15 + n17_7 * z16 + n51 * z21;
    const Scalar z40 = n17_7 * z15 + n10_45 * z16 + n25_5 * z21;
    const Scalar z41 = n0_3 + z33;
    const Scalar z42 = n1_1 - z32;
    const Scalar z43 = c_pitch * z31 + s_pitch * z30;
    const Scalar z44 = z36 - n1_1 * z17;
    const Scalar z45 = z1 * v_steer + z25;  // angular velocity of fork, x
    const Scalar z46 = z35 - n0_3 * z17;
    const Scalar z47 = z2 * v_steer - z27;  // angular velocity of fork, z
    const Scalar z48 = s_pitch * z42 - c_pitch * z41;
    const Scalar z49 = s_rear * z36 + c_rear * z35;
    const Scalar z50 = z10 * z44 - z8 * z37 + z9 * z46;
    const Scalar z51 = z12 * z44 - z11 * z37 + z10 * z46;
    const Scalar z52 = c_steer * z37 + z8 * z46 + z11 * z44;
    const Scalar z53 = n0_35 * z26 + z50;
    const Scalar z54 = n0_08 * z26 + z51;
    const Scalar z55 = s_roll * z19 + c_roll * z48;
    const Scalar z56 = s_rear * z35 - c_rear * z36;
    const Scalar z57 = z52 + n0_35 * z45 - n0_08 * z47;
    const Scalar z58 = s_front * z47 - c_front * z45;
    const Scalar z59 = s_front * z45 + c_front * z47;
    const Scalar z60 = s_front * z54 + c_front * z53;
    const Scalar z61 = s_front * z53 - c_front * z54;
    const Scalar z62 = v_front + z26;  // angular velocity of front_wheel, y
    const Scalar z63 = n51 * z17 + n85 * z35;
    const Scalar z64 = n85 * z36 - n25_5 * z17;
    const Scalar z65 = n49_25 * z17 - n25_5 * z36 + n51 * z35;
    const Scalar z66 = n2_8 * z26 + n4 * z50;
    const Scalar z67 = n2_8 * z45 - n0_8 * z47 + n4 * z52;
    const Scalar z68 = n0_8 * z26 + n4 * z51;
    const Scalar z69 = k16 * z45 - k17 * z47 + n2_8 * z52;
    const Scalar z70 = n2_18 * z26 + n2_8 * z50 + n0_8 * z51;
    const Scalar z71 = k17 * z45 - k19 * z47 + n0_8 * z52;
    const Scalar z72 = s_roll * z18 - c_roll * z43;
    const Scalar z73 = q_z - z55;
    result.energy = -n853_47 * q_z + z21 * z21 + n0_06 * z20 * z20 - n39_24 * z34 + k23 * (z23 * z23 + z24 * z24) + z49
        * z49 + n0_14 * z62 * z62 + z56 * z56 + n9_81 * (z28 + z72) - n29_43 * z73 + k27 * (z58 * z58 + z59 * z59)
        + n1_5 * (z57 * z57 + z60 * z60 + z61 * z61) + n0_5 * (z21 * z38 + z15 * z39 + z16 * z40 + z35 * z63 + z36 * z64
        + z17 * z65 + z26 * z70 + z50 * z66 + z52 * z67 + z51 * z68 + z45 * z69 - z47 * z71);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar v_rear = state.v.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar v_front = state.v.front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z1 * z1;
    });
    const Scalar z4 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z5 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z2 * z2;
    });
    const Scalar z6 = z2 * s_steer;
    const Scalar z7 = z1 * s_steer;
    const Scalar z8 = v_roll * s_roll;
    const Scalar z9 = v_yaw * c_yaw;
    const Scalar z10 = v_roll * c_roll;
    const Scalar z11 = v_yaw * s_yaw;
    const Scalar z12 = s_yaw * c_roll;
    const Scalar z13 = n1 - s_roll * s_roll;
    const Scalar z14 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z15 = c_yaw * c_roll;
    const Scalar z16 = -z4 * (n1 - c_steer);
    const Scalar z17 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z18 = n2 * s_roll;
    const Scalar z19 = s_yaw * s_roll;
    const Scalar z20 = c_yaw * s_roll;
    const Scalar z21 = s_roll * z12;
    const Scalar z22 = s_roll * z15;
    const Scalar z23 = s_yaw * z8 - c_roll * z9;
    const Scalar z24 = c_yaw * z8 + c_roll * z11;
    const Scalar z25 = z10 * z18;
    const Scalar z26 = s_roll * z19 - c_roll * z12;
    const Scalar z27 = s_roll * z20 - c_roll * z15;
    const Scalar z28 = c_roll * z18;
    const Scalar z29 = v_roll * z10;
    const Scalar z30 = v_yaw * z11;
    const Scalar z31 = n2 * z8;
    const Scalar z32 = v_roll * z8;
    const Scalar z33 = n2 * z10;
    const Scalar z34 = v_yaw * z9;
    const Scalar z35 = n0_08 * z6 - n0_35 * z7;
    const Scalar z36 = s_pitch * z7 - c_pitch * z6;
    const Scalar z37 = s_pitch * z6 + c_pitch * z7;
    const Scalar z38 = z13 * z13 + z21 * z21 + z22 * z22;
    const Scalar z39 = s_yaw * z29 + c_roll * z30 + z9 * z31;
    const Scalar z40 = c_yaw * z29 + c_roll * z34 - z11 * z31;
    const Scalar z41 = n2 * (s_roll * z32 - z10 * z10);
    const Scalar z42 = n0_08 * z14 - n0_35 * z16;
    const Scalar z43 = n0_08 * z16 - n0_35 * z17;
    const Scalar z44 = s_roll * z23 - z12 * z10;
    const Scalar z45 = s_roll * z24 - z15 * z10;
    const Scalar z46 = n2 * (z13 * z28 + z21 * z26 + z22 * z27);
    const Scalar z47 = s_roll * z37 - c_roll * c_steer;
    const Scalar z48 = s_roll * c_steer + c_roll * z37;
    const Scalar z49 = n0_3 + z43;
    const Scalar z50 = n1_1 - z42;
    const Scalar z51 = traits::sqrt(z38);
    const Scalar z52 = n2 * (z13 * z25 + z21 * z44 + z22 * z45);
    const Scalar z53 = z12 * z32 + z23 * z33 + s_roll * z39;
    const Scalar z54 = z15 * z32 + z24 * z33 + s_roll * z40;
    const Scalar z55 = c_yaw * z36 + s_yaw * z47;
    const Scalar z56 = n2 * (z21 * z53 + z22 * z54 - z13 * z41 - z44 * z44 - z45 * z45 - z25 * z25);
    const Scalar z57 = s_yaw * z36 - c_yaw * z47;
    const Scalar z58 = s_pitch * z50 - c_pitch * z49;
    const Scalar z59 = s_roll * z58 - c_roll * z35;
    const Scalar z60 = s_pitch * z49 + c_pitch * z50;
    const Scalar z61 = n0_5 * z46 / z51;
    const Scalar z62 = q_z + n0_3 * z51;
    const Scalar z63 = n0_5 * z52 / z51;
    const Scalar z64 = s_roll * z35 + c_roll * z58;
    const Scalar z65 = q_z - z64;
    const Scalar z66 = s_yaw * z59 - c_yaw * z60;
    const Scalar z67 = s_yaw * z60 + c_yaw * z59;
    const Scalar z68 = q_y + z67;
    const Scalar z69 = n0_3 / z51;
    const Scalar z70 = z48 * z55;
    const Scalar z71 = q_x - z66;
    const Scalar z72 = q_x + z21 * z69;
    const Scalar z73 = z48 * z57;
    const Scalar z74 = q_y - z22 * z69;
    const Scalar z75 = n1 - z48 * z48;
    const Scalar z76 = n0_3 * z61;
    const Scalar z77 = n0_5 * (z52 * z63 / (z51 * z51) + z56 / z51);
    const Scalar z78 = v_z - n0_3 * z63;
    const Scalar z79 = q_z + z13 * z69;
    const Scalar z80 = v_pitch * c_pitch;
    const Scalar z81 = v_pitch * s_pitch;
    const Scalar z82 = v_steer * c_steer;
    const Scalar z83 = v_steer * s_steer;
    const Scalar z84 = z2 * z82;
    const Scalar z85 = z1 * z82;
    const Scalar z86 = n2 * z48;
    const Scalar z87 = z4 * z83;
    const Scalar z88 = z75 * z75 + z70 * z70 + z73 * z73;
    const Scalar z89 = traits::sqrt(z88);
    const Scalar z90 = z6 * z80 - z7 * z81 + s_pitch * z84 + c_pitch * z85;
    const Scalar z91 = z6 * z81 + z7 * z80 + s_pitch * z85 - c_pitch * z84;
    const Scalar z92 = -z83 * (n1 - z3);
    const Scalar z93 = n0_35 * z87 + n0_08 * z92;
    const Scalar z94 = n0_3 * z77;
    const Scalar z95 = c_roll * z83 + c_steer * z8 + z10 * z37 + s_roll * z90;
    const Scalar z96 = z9 * z36 + z11 * z47 + s_yaw * z91 - c_yaw * z95;
    const Scalar z97 = s_roll * z83 - c_steer * z10 + z8 * z37 - c_roll * z90;
    const Scalar z98 = z65 + n0_35 * z89;
    const Scalar z99 = z9 * z47 - z11 * z36 + c_yaw * z91 + s_yaw * z95;
    const Scalar z100 = z97 * z86;
    const Scalar z101 = z48 * z96 - z57 * z97;
    const Scalar z102 = -z83 * (n1 - z5);
    const Scalar z103 = n0_08 * z87 + n0_35 * z102;
    const Scalar z104 = z48 * z99 - z55 * z97;
    const Scalar z105 = n0_08 * z84 - n0_35 * z85;
    const Scalar z106 = n2 * (z75 * z100 + z73 * z101 + z70 * z104);
    const Scalar z107 = s_pitch * z93 - c_pitch * z103 - z50 * z80 - z49 * z81;
    const Scalar z108 = z2 * c_steer;
    const Scalar z109 = z1 * c_steer;
    const Scalar z110 = s_roll * z36;
    const Scalar z111 = n0_5 * z106 / z89;
    const Scalar z112 = c_yaw * z48;
    const Scalar z113 = z48 * z112 + z47 * z57;
    const Scalar z114 = s_yaw * z110 - c_yaw * z37;
    const Scalar z115 = s_yaw * z37 + c_yaw * z110;
    const Scalar z116 = n0_35 / z89;
    const Scalar z117 = c_roll * z36;
    const Scalar z118 = z48 * z114 + z55 * z117;
    const Scalar z119 = z48 * z115 - z57 * z117;
    const Scalar z120 = z86 * z117;
    const Scalar z121 = z71 - z70 * z116;
    const Scalar z122 = z10 * z35 + s_roll * z105 - z8 * z58 - c_roll * z107;
    const Scalar z123 = n2 * (z70 * z118 - z73 * z119 - z75 * z120);
    const Scalar z124 = v_z - z122;
    const Scalar z125 = z124 + n0_35 * z111;
    const Scalar z126 = z65 + z75 * z116;
    const Scalar z127 = s_yaw * z48;
    const Scalar z128 = z47 * z55 - z48 * z127;
    const Scalar z129 = z47 * z86;
    const Scalar z130 = z68 - z73 * z116;
    const Scalar z131 = v_steer * z82;
    const Scalar z132 = v_pitch * z81;
    const Scalar z133 = n2 * (z73 * z113 - z75 * z129 + z70 * z128);
    const Scalar z134 = n0_5 * z123 / z89;
    const Scalar z135 = v_pitch * z80;
    const Scalar z136 = v_steer * z83;
    const Scalar z137 = z2 * z136;
    const Scalar z138 = z1 * z136;
    const Scalar z139 = n2 * z97;
    const Scalar z140 = s_pitch * z108 + c_pitch * z109;
    const Scalar z141 = z6 * z132 + z7 * z135 + s_pitch * z137 + c_pitch * z138 - n2 * (z84 * z80 - z85 * z81);
    const Scalar z142 = z7 * z132 - z6 * z135 + s_pitch * z138 - c_pitch * z137 - n2 * (z84 * z81 + z85 * z80);
    const Scalar z143 = n0_08 * z137 - n0_35 * z138;
    const Scalar z144 = n0_5 * z133 / z89;
    const Scalar z145 = z32 * z37 - c_roll * z131 - c_steer * z29 - n2 * (z10 * z90 - z8 * z83) + s_roll * z141;
    const Scalar z146 = s_roll * z131 + c_steer * z32 + z29 * z37 + n2 * (z10 * z83 + z8 * z90) + c_roll * z141;
    const Scalar z147 = z59 - n0_35 * z144;
    const Scalar z148 = z30 * z36 - z34 * z47 - n2 * (z9 * z91 + z11 * z95) + s_yaw * z142 - c_yaw * z145;
    const Scalar z149 = z34 * z36 + z30 * z47 - n2 * (z9 * z95 - z11 * z91) + c_yaw * z142 + s_yaw * z145;
    const Scalar z150 = z96 * z139 + z57 * z146 + z48 * z148;
    const Scalar z151 = z99 * z139 + z55 * z146 + z48 * z149;
    const Scalar z152 = n2 * (z48 * z146 - z97 * z97);
    const Scalar z153 = n2 * (z73 * z150 - z100 * z100 - z101 * z101 - z104 * z104 - z75 * z152 + z70 * z151);
    const Scalar z154 = s_pitch * z109 - c_pitch * z108;
    const Scalar z155 = n0_08 * z108 - n0_35 * z109;
    const Scalar z156 = c_roll * s_steer + s_roll * z140;
    const Scalar z157 = s_roll * s_steer - c_roll * z140;
    const Scalar z158 = z86 * z157;
    const Scalar z159 = c_yaw * z154 + s_yaw * z156;
    const Scalar z160 = s_yaw * z154 - c_yaw * z156;
    const Scalar z161 = z48 * z159 - z55 * z157;
    const Scalar z162 = z48 * z160 - z57 * z157;
    const Scalar z163 = z4 * z131;
    const Scalar z164 = -z131 * (n1 - z3);
    const Scalar z165 = n0_35 * z163 + n0_08 * z164;
    const Scalar z166 = n0_5 * (z106 * z111 / (z89 * z89) + z153 / z89);
    const Scalar z167 = n2 * (z75 * z158 + z70 * z161 + z73 * z162);
    const Scalar z168 = -z131 * (n1 - z5);
    const Scalar z169 = n0_08 * z163 + n0_35 * z168;
    const Scalar z170 = s_steer * z4;
    const Scalar z171 = s_steer * (n1 - z3);
    const Scalar z172 = n0_08 * z171 - n0_35 * z170;
    const Scalar z173 = s_pitch * z165 - z49 * z135 - c_pitch * z169 + z50 * z132 + n2 * (z80 * z93 + z81 * z103);
    const Scalar z174 = n0_5 * z167 / z89;
    const Scalar z175 = s_steer * (n1 - z5);
    const Scalar z176 = n0_08 * z170 - n0_35 * z175;
    const Scalar z177 = c_roll * z60;
    const Scalar z178 = z177 + n0_35 * z134;
    const Scalar z179 = n0_3 * z63 / (z51 * z51);
    const Scalar z180 = z32 * z35 + s_roll * z143 + z29 * z58 - n2 * (z10 * z105 + z8 * z107) + c_roll * z173;
    const Scalar z181 = z180 - n0_35 * z166;
    const Scalar z182 = v_z - z69 * z25 + z13 * z179;
    const Scalar z183 = v_y + z69 * z45 - z22 * z179;
    const Scalar z184 = v_x - z69 * z44 + z21 * z179;
    const Scalar z185 = c_pitch * z176 + s_pitch * z172;
    const Scalar z186 = s_roll * z155 + c_roll * z185;
    const Scalar z187 = q_x - z72;
    const Scalar z188 = q_y - z74;
    const Scalar z189 = q_z - z79;
    const Scalar z190 = v_z - z182;
    const Scalar z191 = v_y - z183;
    const Scalar z192 = z186 - n0_35 * z174;
    const Scalar z193 = c_roll * z105 - z8 * z35 - z10 * z58 + s_roll * z107;
    const Scalar z194 = s_pitch * z103 + c_pitch * z93 + z50 * z81 - z49 * z80;
    const Scalar z195 = n0_35 * z111 / (z89 * z89);
    const Scalar z196 = z75 * z195 - z124 - z116 * z100;
    const Scalar z197 = z71 - z121;
    const Scalar z198 = z68 - z130;
    const Scalar z199 = v_x - z184;
    const Scalar z200 = z65 - z126;
    const Scalar z201 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z202 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z203 = s_roll * z201;
    const Scalar z204 = s_pitch * z2 + c_pitch * z1;
    const Scalar z205 = s_pitch * z1 - c_pitch * z2;
    const Scalar z206 = s_yaw * z194 - z9 * z60 + z11 * z59 + c_yaw * z193;
    const Scalar z207 = v_y - z206;
    const Scalar z208 = s_yaw * z203 - c_yaw * z202;
    const Scalar z209 = q_x - z208;
    const Scalar z210 = s_roll * z205;
    const Scalar z211 = z207 - z116 * z101 + z73 * z195;
    const Scalar z212 = z121 - z209;
    const Scalar z213 = q_x - z121;
    const Scalar z214 = c_roll * z201;
    const Scalar z215 = q_z - z214;
    const Scalar z216 = s_yaw * z202 + c_yaw * z203;
    const Scalar z217 = q_y + z216;
    const Scalar z218 = q_z - z126;
    const Scalar z219 = z126 - z215;
    const Scalar z220 = q_y - z130;
    const Scalar z221 = c_roll * z205;
    const Scalar z222 = v_y - z211;
    const Scalar z223 = z130 - z217;
    const Scalar z224 = s_yaw * z218;
    const Scalar z225 = c_yaw * z218;
    const Scalar z226 = s_yaw * z210 - c_yaw * z204;
    const Scalar z227 = s_roll * z220 - z15 * z218;
    const Scalar z228 = s_roll * z213 + z12 * z218;
    const Scalar z229 = s_yaw * z204 + c_yaw * z210;
    const Scalar z230 = s_yaw * z189;
    const Scalar z231 = v_z + z196;
    const Scalar z232 = c_yaw * z189;
    const Scalar z233 = z9 * z218 + s_yaw * z231;
    const Scalar z234 = z9 * z189 + s_yaw * z190;
    const Scalar z235 = c_yaw * z190 - z11 * z189;
    const Scalar z236 = z221 * z223 + z229 * z219;
    const Scalar z237 = z221 * z212 - z226 * z219;
    const Scalar z238 = s_roll * z188 - z15 * z189;
    const Scalar z239 = v_x + v_yaw * z188 - v_roll * z230 + z238 * (v_pitch + v_rear);
    const Scalar z240 = z10 * z188 + z24 * z189 + s_roll * z191 - z15 * z190;
    const Scalar z241 = v_yaw * z191 - v_roll * z234 + z240 * (v_pitch + v_rear);
    const Scalar z242 = z10 * z220 + z24 * z218 + s_roll * z222 - z15 * z231;
    const Scalar z243 = z10 * z187 - z23 * z189 + s_roll * z199 + z12 * z190;
    const Scalar z244 = v_yaw * z199 - v_roll * z235 + z243 * (v_pitch + v_rear);
    const Scalar z245 = s_roll * z187 + z12 * z189;
    const Scalar z246 = v_y - v_yaw * z187 + v_roll * z232 - z245 * (v_pitch + v_rear);
    const Scalar z247 = s_yaw * z193 - c_yaw * z194 - z9 * z59 - z11 * z60;
    const Scalar z248 = v_x + z247;
    const Scalar z249 = z207 - z211;
    const Scalar z250 = z124 + z196;
    const Scalar z251 = z48 * z249 - z97 * z198 - z96 * z200 - z57 * z250;
    const Scalar z252 = z248 - z116 * z104 + z70 * z195;
    const Scalar z253 = z48 * z198 - z57 * z200;
    const Scalar z254 = v_x + v_yaw * z220 - v_roll * z224 + v_pitch * z227 + v_steer * z236 + v_front * z253;
    const Scalar z255 = z248 - z252;
    const Scalar z256 = z48 * z255 - z97 * z197 - z99 * z200 - z55 * z250;
    const Scalar z257 = z48 * z197 - z55 * z200;
    const Scalar z258 = v_y - v_yaw * z213 + v_roll * z225 - v_pitch * z228 - v_steer * z237 - v_front * z257;
    const Scalar z259 = n0_3 * z80 - n1_1 * z81;
    const Scalar z260 = z1 * z81 - z2 * z80;
    const Scalar z261 = z1 * z80 + z2 * z81;
    const Scalar z262 = n1_1 * z80 + n0_3 * z81;
    const Scalar z263 = z10 * z201 + s_roll * z262;
    const Scalar z264 = c_roll * z262 - z8 * z201;
    const Scalar z265 = c_roll * z261 - z8 * z205;
    const Scalar z266 = z10 * z205 + s_roll * z261;
    const Scalar z267 = z11 * z202 - c_yaw * z259 + z9 * z203 + s_yaw * z263;
    const Scalar z268 = z9 * z202 + s_yaw * z259 - z11 * z203 + c_yaw * z263;
    const Scalar z269 = v_x - z267;
    const Scalar z270 = z252 - z269;
    const Scalar z271 = v_x - z252;
    const Scalar z272 = z10 * z213 - z23 * z218 + s_roll * z271 + z12 * z231;
    const Scalar z273 = c_yaw * z231 - z11 * z218;
    const Scalar z274 = v_y + z268;
    const Scalar z275 = z211 - z274;
    const Scalar z276 = v_z - z264;
    const Scalar z277 = z196 + z276;
    const Scalar z278 = z11 * z204 + c_yaw * z260 + z9 * z210 + s_yaw * z266;
    const Scalar z279 = s_yaw * z260 - z9 * z204 + z11 * z210 - c_yaw * z266;
    const Scalar z280 = z212 * z265 - z219 * z278 + z221 * z270 + z226 * z277;
    const Scalar z281 = z223 * z265 - z219 * z279 + z221 * z275 - z229 * z277;
    const Scalar z282 = v_yaw * z271 + v_pitch * z272 + v_steer * z280 - v_roll * z273 + v_front * z256;
    const Scalar z283 = v_yaw * z222 - v_roll * z233 + v_pitch * z242 + v_steer * z281 + v_front * z251;
    result.value[0] = -z62;
    result.rate[0] = -z78;
    result.gamma[0] = z94;
    result.value[1] = -z98;
    result.rate[1] = -z125;
    result.gamma[1] = -z181;
    result.value[2] = n0;
    result.rate[2] = z239;
    result.gamma[2] = z241;
    result.value[3] = n0;
    result.rate[3] = -z246;
    result.gamma[3] = z244;
    result.value[4] = n0;
    result.rate[4] = z254;
    result.gamma[4] = z283;
    result.value[5] = n0;
    result.rate[5] = -z258;
    result.gamma[5] = z282;
    result.jacobian[0] = n0;
    result.jacobian[1] = n0;
    result.jacobian[2] = n1;
    result.jacobian[3] = n0;
    result.jacobian[4] = n1;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = n0;
    result.jacobian[8] = n0;
    result.jacobian[9] = -n1;
    result.jacobian[10] = n0;
    result.jacobian[11] = -n1;
    result.jacobian[12] = -n1;
    result.jacobian[13] = -n1;
    result.jacobian[14] = n0;
    result.jacobian[15] = n0;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
    result.jacobian[18] = n0;
    result.jacobian[19] = n0;
    result.jacobian[20] = z188;
    result.jacobian[21] = z187;
    result.jacobian[22] = z220;
    result.jacobian[23] = z213;
    result.jacobian[24] = z76;
    result.jacobian[25] = -z147;
    result.jacobian[26] = -z230;
    result.jacobian[27] = -z232;
    result.jacobian[28] = -z224;
    result.jacobian[29] = -z225;
    result.jacobian[30] = n0;
    result.jacobian[31] = z178;
    result.jacobian[32] = z238;
    result.jacobian[33] = z245;
    result.jacobian[34] = z227;
    result.jacobian[35] = z228;
    result.jacobian[36] = n0;
    result.jacobian[37] = z192;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z236;
    result.jacobian[41] = z237;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z238;
    result.jacobian[45] = z245;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z253;
    result.jacobian[53] = z257;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x, y, yaw, roll, steer, rear, front,
  /// w those of the rates of roll, steer, rear;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n3_85 = traits::constant(3.85, 3.85f, "77/20");
    const Scalar n1_04 = traits::constant(1.04, 1.04f, "26/25");
    const Scalar k3 = traits::constant(2.52692, 2.52692f, "63173/25000");
    const Scalar k4 = traits::constant(0.65156, 0.65156f, "16289/25000");
    const Scalar k5 = traits::constant(0.32678, 0.32678f, "16339/50000");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar k16 = traits::constant(2.20014, 2.20014f, "110007/50000");
    const Scalar n2_5667 = traits::constant(2.5667, 2.5667f, "25667/10000");
    const Scalar k18 = traits::constant(2.23992, 2.23992f, "27999/12500");
    const Scalar k19 = traits::constant(0.03978, 0.03978f, "1989/50000");
    const Scalar n7 = traits::constant(7.0, 7.0f, "7/1");
    const Scalar n25_5 = traits::constant(25.5, 25.5f, "51/2");
    const Scalar n51 = traits::constant(51.0, 51.0f, "51/1");
    const Scalar n49_25 = traits::constant(49.25, 49.25f, "197/4");
    const Scalar n29_35 = traits::constant(29.35, 29.35f, "587/20");
    const Scalar n17_7 = traits::constant(17.7, 17.7f, "177/10");
    const Scalar n78_6 = traits::constant(78.6, 78.6f, "393/5");
    const Scalar n2_8467 = traits::constant(2.8467, 2.8467f, "28467/10000");
    const Scalar n0_63 = traits::constant(0.63, 0.63f, "63/100");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n2_31 = traits::constant(2.31, 2.31f, "231/100");
    const Scalar n9_1 = traits::constant(9.1, 9.1f, "91/10");
    const Scalar n2_2 = traits::constant(2.2, 2.2f, "11/5");
    const Scalar n39_8603 = traits::constant(39.8603, 39.8603f, "398603/10000");
    const Scalar n8_47 = traits::constant(8.47, 8.47f, "847/100");
    const Scalar n7_7 = traits::constant(7.7, 7.7f, "77/10");
    const Scalar n2_1 = traits::constant(2.1, 2.1f, "21/10");
    const Scalar n87 = traits::constant(87.0, 87.0f, "87/1");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar k39 = traits::constant(2.38342, 2.38342f, "119171/50000");
    const Scalar n0_1435 = traits::constant(0.1435, 0.1435f, "287/2000");
    const Scalar k41 = traits::constant(0.18328, 0.18328f, "2291/12500");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar n39_3 = traits::constant(39.3, 39.3f, "393/10");
    const Scalar n9_95 = traits::constant(9.95, 9.95f, "199/20");
    const Scalar n0_5603 = traits::constant(0.5603, 0.5603f, "5603/10000");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n1_over_94 = traits::constant(0.010638297872340425, 0.010638298f, "1/94");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar q_z = state.q.z;
    const Scalar v_z = state.v.z;
    const Scalar a_z = accelerations.z;
    const Scalar q_yaw = state.q.yaw;
    const Scalar v_yaw = state.v.yaw;
    const Scalar a_yaw = accelerations.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar v_roll = state.v.roll;
    const Scalar a_roll = accelerations.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar v_pitch = state.v.pitch;
    const Scalar a_pitch = accelerations.pitch;
    const Scalar q_rear = state.q.rear;
    const Scalar v_rear = state.v.rear;
    const Scalar a_rear = accelerations.rear;
    const Scalar q_steer = state.q.steer;
    const Scalar v_steer = state.v.steer;
    const Scalar a_steer = accelerations.steer;
    const Scalar q_front = state.q.front;
    const Scalar v_front = state.v.front;
    const Scalar a_front = accelerations.front;
    const Scalar l_lambda_rear_rolls_x = multipliers.lambda_rear_rolls_x;
    const Scalar l_lambda_front_rolls_x = multipliers.lambda_front_rolls_x;
    const Scalar l_lambda_rear_rolls_y = multipliers.lambda_rear_rolls_y;
    const Scalar l_lambda_front_rolls_y = multipliers.lambda_front_rolls_y;
    const Scalar l_lambda_rear_touches = multipliers.lambda_rear_touches;
    const Scalar l_lambda_front_touches = multipliers.lambda_front_touches;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_rear, q_steer, q_front};
    Scalar sines_[6], cosines_[6];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_rear = sines_[3], c_rear = cosines_[3];
    const Scalar s_steer = sines_[4], c_steer = cosines_[4];
    const Scalar s_front = sines_[5], c_front = cosines_[5];
    const Scalar pi = traits::pi();
    const Scalar z0 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z1 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    const Scalar z2 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z3 = traits::formula(0.20061665139658788, 0.20061666f, [&]() -> Scalar {
      return n3_85 * z1 - n1_04 * z2;
    });
    const Scalar z4 = traits::formula(0.16119083966867187, 0.16119084f, [&]() -> Scalar {
      return k3 * z1 - k4 * z2;
    });
    const Scalar z5 = traits::formula(-0.10944313553998954, -0.109443136f, [&]() -> Scalar {
      return k4 * z1 - k5 * z2;
    });
    const Scalar z6 = traits::formula(0.1538973160142678, 0.15389732f, [&]() -> Scalar {
      return z1 * z4 - z2 * z5;
    });
    const Scalar z7 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z1 * z1;
    });
    const Scalar z8 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z1 * z2;
    });
    const Scalar z9 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z2 * z2;
    });
    const Scalar z10 = z2 * s_steer;
    const Scalar z11 = z1 * s_steer;
    const Scalar z12 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z13 = -z8 * (n1 - c_steer);
    const Scalar z14 = v_roll * s_roll;
    const Scalar z15 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z16 = v_yaw * c_yaw;
    const Scalar z17 = v_roll * c_roll;
    const Scalar z18 = v_yaw * s_yaw;
    const Scalar z19 = s_yaw * c_roll;
    const Scalar z20 = n1 - s_roll * s_roll;
    const Scalar z21 = c_yaw * c_roll;
    const Scalar z22 = s_yaw * s_roll;
    const Scalar z23 = n2 * s_roll;
    const Scalar z24 = c_yaw * s_roll;
    const Scalar z25 = s_roll * z19;
    const Scalar z26 = s_roll * z21;
    const Scalar z27 = s_yaw * z14 - c_roll * z16;
    const Scalar z28 = c_yaw * z14 + c_roll * z18;
    const Scalar z29 = z17 * z23;
    const Scalar z30 = s_roll * z22 - c_roll * z19;
    const Scalar z31 = s_roll * z24 - c_roll * z21;
    const Scalar z32 = c_roll * z23;
    const Scalar z33 = v_roll * z17;
    const Scalar z34 = v_yaw * z18;
    const Scalar z35 = n2 * z14;
    const Scalar z36 = v_roll * z14;
    const Scalar z37 = n2 * z17;
    const Scalar z38 = v_yaw * z16;
    const Scalar z39 = n0_08 * z10 - n0_35 * z11;
    const Scalar z40 = s_pitch * z11 - c_pitch * z10;
    const Scalar z41 = s_pitch * z10 + c_pitch * z11;
    const Scalar z42 = z20 * z20 + z25 * z25 + z26 * z26;
    const Scalar z43 = s_yaw * z33 + c_roll * z34 + z16 * z35;
    const Scalar z44 = c_yaw * z33 + c_roll * z38 - z18 * z35;
    const Scalar z45 = n2 * (s_roll * z36 - z17 * z17);
    const Scalar z46 = n0_08 * z12 - n0_35 * z13;
    const Scalar z47 = n0_08 * z13 - n0_35 * z15;
    const Scalar z48 = s_roll * z27 - z19 * z17;
    const Scalar z49 = s_roll * z28 - z21 * z17;
    const Scalar z50 = n2 * (z20 * z32 + z25 * z30 + z26 * z31);
    const Scalar z51 = s_roll * z39;
    const Scalar z52 = s_roll * z41;
    const Scalar z53 = s_roll * c_steer + c_roll * z41;
    const Scalar z54 = c_yaw * z40;
    const Scalar z55 = n0_3 + z47;
    const Scalar z56 = c_roll * c_steer - z52;
    const Scalar z57 = n1_1 - z46;
    const Scalar z58 = traits::sqrt(z42);
    const Scalar z59 = n2 * (z20 * z29 + z25 * z48 + z26 * z49);
    const Scalar z60 = z19 * z36 + z27 * z37 + s_roll * z43;
    const Scalar z61 = s_yaw * z56 - z54;
    const Scalar z62 = s_pitch * z57 - c_pitch * z55;
    const Scalar z63 = s_pitch * z55 + c_pitch * z57;
    const Scalar z64 = z21 * z36 + z28 * z37 + s_roll * z44;
    const Scalar z65 = s_roll * z62 - c_roll * z39;
    const Scalar z66 = c_roll * z62 + z51;
    const Scalar z67 = n2 * (z25 * z60 + z26 * z64 - z20 * z45 - z48 * z48 - z49 * z49 - z29 * z29);
    const Scalar z68 = s_yaw * z63 + c_yaw * z65;
    const Scalar z69 = q_z - z66;
    const Scalar z70 = q_y + z68;
    const Scalar z71 = s_yaw * z65 - c_yaw * z63;
    const Scalar z72 = n0_3 / z58;
    const Scalar z73 = s_yaw * z40;
    const Scalar z74 = q_x - z71;
    const Scalar z75 = n0_5 * z50 / z58;
    const Scalar z76 = n0_5 * z59 / z58;
    const Scalar z77 = q_x + z25 * z72;
    const Scalar z78 = c_yaw * z56 + z73;
    const Scalar z79 = q_y - z26 * z72;
    const Scalar z80 = z53 * z61;
    const Scalar z81 = q_z + z20 * z72;
    const Scalar z82 = n1 - z53 * z53;
    const Scalar z83 = z53 * z78;
    const Scalar z84 = z82 * z82 + z80 * z80 + z83 * z83;
    const Scalar z85 = v_pitch * c_pitch;
    const Scalar z86 = v_pitch * s_pitch;
    const Scalar z87 = v_steer * c_steer;
    const Scalar z88 = v_steer * s_steer;
    const Scalar z89 = z2 * z87;
    const Scalar z90 = z1 * z87;
    const Scalar z91 = z8 * z88;
    const Scalar z92 = -z88 * (n1 - z9);
    const Scalar z93 = -z88 * (n1 - z7);
    const Scalar z94 = n0_08 * z91 + n0_35 * z92;
    const Scalar z95 = n0_35 * z91 + n0_08 * z93;
    const Scalar z96 = traits::sqrt(z84);
    const Scalar z97 = n0_08 * z89 - n0_35 * z90;
    const Scalar z98 = n0_3 * z75;
    const Scalar z99 = c_roll * z88;
    const Scalar z100 = z10 * z85 - z11 * z86 + s_pitch * z89 + c_pitch * z90;
    const Scalar z101 = z10 * z86 + z11 * z85 + s_pitch * z90 - c_pitch * z89;
    const Scalar z102 = c_steer * z14 + z99 + z17 * z41 + s_roll * z100;
    const Scalar z103 = n2 * z53;
    const Scalar z104 = s_roll * z88 - c_steer * z17 + z14 * z41 - c_roll * z100;
    const Scalar z105 = z16 * z40 - z18 * z56 + s_yaw * z101 - c_yaw * z102;
    const Scalar z106 = n0_35 / z96;
    const Scalar z107 = z53 * z105 - z78 * z104;
    const Scalar z108 = c_yaw * z101 - z18 * z40 - z16 * z56 + s_yaw * z102;
    const Scalar z109 = z61 * z104 + z53 * z108;
    const Scalar z110 = s_pitch * z95 - c_pitch * z94 - z57 * z85 - z55 * z86;
    const Scalar z111 = z69 + z82 * z106;
    const Scalar z112 = z70 - z83 * z106;
    const Scalar z113 = z74 + z80 * z106;
    const Scalar z114 = z17 * z39 + s_roll * z97 - z14 * z62 - c_roll * z110;
    const Scalar z115 = v_z - z114;
    const Scalar z116 = n0_5 * (z59 * z76 / (z58 * z58) + z67 / z58);
    const Scalar z117 = n0_3 * z116;
    const Scalar z118 = z2 * c_steer;
    const Scalar z119 = z1 * c_steer;
    const Scalar z120 = s_pitch * z118 + c_pitch * z119;
    const Scalar z121 = s_pitch * z119 - c_pitch * z118;
    const Scalar z122 = s_roll * z40;
    const Scalar z123 = s_yaw * z41 + c_yaw * z122;
    const Scalar z124 = c_roll * z40;
    const Scalar z125 = s_yaw * z53;
    const Scalar z126 = s_yaw * z122 - c_yaw * z41;
    const Scalar z127 = c_roll * s_steer + s_roll * z120;
    const Scalar z128 = s_roll * s_steer - c_roll * z120;
    const Scalar z129 = c_yaw * z121 + s_yaw * z127;
    const Scalar z130 = s_yaw * z121 - c_yaw * z127;
    const Scalar z131 = z103 * z124;
    const Scalar z132 = c_yaw * z53;
    const Scalar z133 = v_pitch * z86;
    const Scalar z134 = z56 * z61 - z53 * z125;
    const Scalar z135 = z53 * z123 - z78 * z124;
    const Scalar z136 = z53 * z129 + z61 * z128;
    const Scalar z137 = v_pitch * z85;
    const Scalar z138 = z56 * z78 - z53 * z132;
    const Scalar z139 = v_steer * z88;
    const Scalar z140 = v_steer * z87;
    const Scalar z141 = z53 * z130 - z78 * z128;
    const Scalar z142 = z53 * z126 - z61 * z124;
    const Scalar z143 = z2 * z139;
    const Scalar z144 = z56 * z103;
    const Scalar z145 = z104 * z103;
    const Scalar z146 = z103 * z128;
    const Scalar z147 = z1 * z139;
    const Scalar z148 = n2 * (z82 * z131 + z83 * z135 + z80 * z142);
    const Scalar z149 = n2 * (z80 * z134 + z83 * z138 - z82 * z144);
    const Scalar z150 = n2 * (z80 * z136 - z83 * z141 - z82 * z146);
    const Scalar z151 = z10 * z133 + z11 * z137 + s_pitch * z143 + c_pitch * z147 - n2 * (z89 * z85 - z90 * z86);
    const Scalar z152 = s_steer * z8;
    const Scalar z153 = s_steer * (n1 - z7);
    const Scalar z154 = n0_08 * z153 - n0_35 * z152;
    const Scalar z155 = s_steer * (n1 - z9);
    const Scalar z156 = n0_08 * z152 - n0_35 * z155;
    const Scalar z157 = z11 * z133 - z10 * z137 + s_pitch * z147 - c_pitch * z143 - n2 * (z89 * z86 + z90 * z85);
    const Scalar z158 = n0_08 * z143 - n0_35 * z147;
    const Scalar z159 = z36 * z41 - c_roll * z140 - c_steer * z33 - n2 * (z17 * z100 - z14 * z88) + s_roll * z151;
    const Scalar z160 = n2 * (z80 * z109 - z83 * z107 - z82 * z145);
    const Scalar z161 = n0_5 * z148 / z96;
    const Scalar z162 = n0_5 * z149 / z96;
    const Scalar z163 = n0_5 * z150 / z96;
    const Scalar z164 = c_pitch * z156 + s_pitch * z154;
    const Scalar z165 = n0_08 * z118 - n0_35 * z119;
    const Scalar z166 = c_roll * z63;
    const Scalar z167 = s_roll * z165 + c_roll * z164;
    const Scalar z168 = z38 * z40 - z34 * z56 - n2 * (z16 * z102 - z18 * z101) + c_yaw * z157 + s_yaw * z159;
    const Scalar z169 = n0_5 * z160 / z96;
    const Scalar z170 = s_roll * z140 + c_steer * z36 + z33 * z41 + n2 * (z17 * z88 + z14 * z100) + c_roll * z151;
    const Scalar z171 = n2 * z104;
    const Scalar z172 = z34 * z40 + z38 * z56 - n2 * (z16 * z101 + z18 * z102) + s_yaw * z157 - c_yaw * z159;
    const Scalar z173 = n2 * (z53 * z170 - z104 * z104);
    const Scalar z174 = z105 * z171 + z78 * z170 + z53 * z172;
    const Scalar z175 = z166 - n0_35 * z161;
    const Scalar z176 = z108 * z171 - z61 * z170 + z53 * z168;
    const Scalar z177 = z65 + n0_35 * z162;
    const Scalar z178 = q_x - z77;
    const Scalar z179 = q_z - z81;
    const Scalar z180 = q_y - z79;
    const Scalar z181 = q_x - z113;
    const Scalar z182 = q_y - z112;
    const Scalar z183 = q_z - z111;
    const Scalar z184 = z8 * z140;
    const Scalar z185 = n2 * (z145 * z145 + z107 * z107 + z109 * z109 + z82 * z173 - z83 * z174 + z80 * z176);
    const Scalar z186 = s_yaw * z183;
    const Scalar z187 = -z140 * (n1 - z7);
    const Scalar z188 = n0_35 * z184 + n0_08 * z187;
    const Scalar z189 = z72 * z48;
    const Scalar z190 = z167 + n0_35 * z163;
    const Scalar z191 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z192 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z193 = s_roll * z192;
    const Scalar z194 = s_pitch * z1 - c_pitch * z2;
    const Scalar z195 = s_pitch * z2 + c_pitch * z1;
    const Scalar z196 = s_roll * z194;
    const Scalar z197 = c_roll * z194;
    const Scalar z198 = c_yaw * z183;
    const Scalar z199 = s_yaw * z195 + c_yaw * z196;
    const Scalar z200 = s_yaw * z196 - c_yaw * z195;
    const Scalar z201 = -z140 * (n1 - z9);
    const Scalar z202 = n0_08 * z184 + n0_35 * z201;
    const Scalar z203 = s_yaw * z191 + c_yaw * z193;
    const Scalar z204 = c_roll * z192;
    const Scalar z205 = s_yaw * z193 - c_yaw * z191;
    const Scalar z206 = q_z - z204;
    const Scalar z207 = n0_3 * z76 / (z58 * z58);
    const Scalar z208 = s_roll * z181 + z19 * z183;
    const Scalar z209 = s_roll * z178 + z19 * z179;
    const Scalar z210 = s_roll * z182 - z21 * z183;
    const Scalar z211 = z160 * z169;
    const Scalar z212 = s_yaw * z179;
    const Scalar z213 = v_x - z189 + z25 * z207;
    const Scalar z214 = v_x - z213;
    const Scalar z215 = s_roll * z180 - z21 * z179;
    const Scalar z216 = z72 * z49;
    const Scalar z217 = c_yaw * z179;
    const Scalar z218 = v_y + z216 - z26 * z207;
    const Scalar z219 = v_z - z72 * z29 + z20 * z207;
    const Scalar z220 = v_z - z219;
    const Scalar z221 = s_pitch * z188 - z55 * z137 - c_pitch * z202 + z57 * z133 + n2 * (z85 * z95 + z86 * z94);
    const Scalar z222 = v_y - z218;
    const Scalar z223 = q_y + z203;
    const Scalar z224 = c_yaw * z220 - z18 * z179;
    const Scalar z225 = z19 * z220;
    const Scalar z226 = z17 * z178 - z27 * z179 + s_roll * z214 + z225;
    const Scalar z227 = z16 * z179 + s_yaw * z220;
    const Scalar z228 = z21 * z220;
    const Scalar z229 = z36 * z39 + s_roll * z158 + z33 * z62 - n2 * (z17 * z97 + z14 * z110) + c_roll * z221;
    const Scalar z230 = z69 - z111;
    const Scalar z231 = z111 - z206;
    const Scalar z232 = z70 - z112;
    const Scalar z233 = z112 - z223;
    const Scalar z234 = z74 - z113;
    const Scalar z235 = z78 * z230;
    const Scalar z236 = q_x - z205;
    const Scalar z237 = z113 - z236;
    const Scalar z238 = z53 * z232 - z235;
    const Scalar z239 = z200 * z231;
    const Scalar z240 = z199 * z231;
    const Scalar z241 = z197 * z233 + z240;
    const Scalar z242 = z197 * z237 - z239;
    const Scalar z243 = n0_5 * (z211 / (z96 * z96) - z185 / z96);
    const Scalar z244 = z229 - n0_35 * z243;
    const Scalar z245 = s_pitch * z94;
    const Scalar z246 = z61 * z230;
    const Scalar z247 = z53 * z234 + z246;
    const Scalar z248 = c_roll * z97;
    const Scalar z249 = z245 + c_pitch * z95 - z55 * z85 + z57 * z86;
    const Scalar z250 = z248 - z14 * z39 - z17 * z62 + s_roll * z110;
    const Scalar z251 = z1 * z85 + z2 * z86;
    const Scalar z252 = n0_35 * z169 / (z96 * z96);
    const Scalar z253 = z115 + z106 * z145 + z82 * z252;
    const Scalar z254 = z28 * z183;
    const Scalar z255 = z17 * z180 + z28 * z179 + s_roll * z222 - z228;
    const Scalar z256 = s_yaw * z249 - z16 * z63 + z18 * z65 + c_yaw * z250;
    const Scalar z257 = c_roll * z251 - z14 * z194;
    const Scalar z258 = v_z - z253;
    const Scalar z259 = z16 * z183 + s_yaw * z258;
    const Scalar z260 = v_yaw * z214 + z226 * (v_pitch + v_rear) - v_roll * z224;
    const Scalar z261 = v_yaw * z222 - v_roll * z227 + z255 * (v_pitch + v_rear);
    const Scalar z262 = z115 - z253;
    const Scalar z263 = v_yaw * s_roll;
    const Scalar z264 = v_yaw * c_roll;
    const Scalar z265 = v_roll * c_pitch - s_pitch * z264;
    const Scalar z266 = v_roll * s_pitch + c_pitch * z264;
    const Scalar z267 = a_yaw * c_roll;
    const Scalar z268 = v_roll * z263 - z267;  // angular acceleration of frame.2, z
    const Scalar z269 = a_yaw * s_roll;
    const Scalar z270 = v_roll * z264 + z269;  // angular acceleration of frame.2, y
    const Scalar z271 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z272 = n9_81 - a_z;
    const Scalar z273 = s_roll * z271 - c_roll * z272;
    const Scalar z274 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z275 = z1 * z86 - z2 * z85;
    const Scalar z276 = s_roll * z272 + c_roll * z271;
    const Scalar z277 = v_y - z256;
    const Scalar z278 = a_roll * c_pitch + s_pitch * z268;
    const Scalar z279 = a_roll * s_pitch - c_pitch * z268;
    const Scalar z280 = n0_3 * z85 - n1_1 * z86;
    const Scalar z281 = z17 * z194 + s_roll * z251;
    const Scalar z282 = n1_1 * z85 + n0_3 * z86;
    const Scalar z283 = s_yaw * z250 - c_yaw * z249 - z16 * z65 - z18 * z63;
    const Scalar z284 = s_yaw * z275 - z16 * z195 + z18 * z196 - c_yaw * z281;
    const Scalar z285 = z106 * z107 - z277 + z83 * z252;
    const Scalar z286 = z277 + z285;
    const Scalar z287 = s_pitch * z273 - c_pitch * z274;
    const Scalar z288 = z17 * z192 + s_roll * z282;
    const Scalar z289 = v_x + z283;
    const Scalar z290 = z16 * z191 + s_yaw * z280 - z18 * z193 + c_yaw * z288;
    const Scalar z291 = v_y + z290;
    const Scalar z292 = c_roll * z282 - z14 * z192;
    const Scalar z293 = z289 - z106 * z109 + z80 * z252;
    const Scalar z294 = z285 + z291;
    const Scalar z295 = v_y + z285;
    const Scalar z296 = v_pitch * z266 - z278;  // angular acceleration of frame, x
    const Scalar z297 = v_pitch * z265 + z279;  // angular acceleration of frame, z
    const Scalar z298 = z289 - z293;
    const Scalar z299 = v_pitch + z263;  // angular velocity of frame, y
    const Scalar z300 = a_pitch + z270;  // angular acceleration of frame, y
    const Scalar z301 = s_pitch * z274 + c_pitch * z273;
    const Scalar z302 = z18 * z191 - c_yaw * z280 + z16 * z193 + s_yaw * z288;
    const Scalar z303 = v_z - z292;
    const Scalar z304 = z253 - z303;
    const Scalar z305 = v_x - z293;
    const Scalar z306 = z18 * z195 + c_yaw * z275 + z16 * z196 + s_yaw * z281;
    const Scalar z307 = v_x - z302;
    const Scalar z308 = z293 - z307;
    const Scalar z309 = z27 * z183;
    const Scalar z310 = z231 * z284;
    const Scalar z311 = z231 * z306;
    const Scalar z312 = z108 * z230;
    const Scalar z313 = z105 * z230;
    const Scalar z314 = c_yaw * z258 - z18 * z183;
    const Scalar z315 = z17 * z182 + z254 + s_roll * z295 - z21 * z258;
    const Scalar z316 = z265 * z299;
    const Scalar z317 = z299 * z299;
    const Scalar z318 = z266 * z266;
    const Scalar z319 = z297 + z316;
    const Scalar z320 = z265 * z266;
    const Scalar z321 = z266 * z299;
    const Scalar z322 = z317 + z318;
    const Scalar z323 = z296 + z321;
    const Scalar z324 = z300 - z320;
    const Scalar z325 = z265 * z265;
    const Scalar z326 = z317 + z325;
    const Scalar z327 = z300 + z320;
    const Scalar z328 = s_rear * z265 + c_rear * z266;
    const Scalar z329 = v_rear + z299;  // angular velocity of rear_wheel, y
    const Scalar z330 = s_rear * z266 - c_rear * z265;
    const Scalar z331 = a_rear + z300;  // angular acceleration of rear_wheel, y
    const Scalar z332 = z17 * z181 - z309 + s_roll * z305 + z19 * z258;
    const Scalar z333 = z310 - z233 * z257 + z197 * z294 - z199 * z304;
    const Scalar z334 = z11 * z299 + z13 * z265 - z15 * z266;
    const Scalar z335 = z10 * z299 - z13 * z266 + z12 * z265;
    const Scalar z336 = c_steer * z299 - z10 * z265 + z11 * z266;
    const Scalar z337 = z12 * z296 - z10 * z300 + z13 * z297;
    const Scalar z338 = z237 * z257 - z311 + z197 * z308 - z200 * z304;
    const Scalar z339 = z53 * z286 - z313 - z104 * z232 - z78 * z262;
    const Scalar z340 = c_steer * z300 + z10 * z296 + z11 * z297;
    const Scalar z341 = z53 * z298 - z312 - z104 * z234 + z61 * z262;
    const Scalar z342 = v_yaw * z295 - v_roll * z259 + v_pitch * z315 - v_steer * z333 + v_front * z339;
    const Scalar z343 = z2 * v_steer;
    const Scalar z344 = z1 * a_steer - z337 + z336 * z343;  // angular acceleration of fork, x
    const Scalar z345 = z334 - z343;  // angular velocity of fork, z
    const Scalar z346 = z1 * z334 + z2 * z335;
    const Scalar z347 = v_steer * z346 - z340;  // angular acceleration of fork, y
    const Scalar z348 = z1 * v_steer;
    const Scalar z349 = z335 + z348;  // angular velocity of fork, x
    const Scalar z350 = z276 - n1_1 * z319 - n0_3 * z323;
    const Scalar z351 = z287 + n1_1 * z322 - n0_3 * z327;
    const Scalar z352 = z13 * z296 - z11 * z300 + z15 * z297;
    const Scalar z353 = z352 + z2 * a_steer - z336 * z348;  // angular acceleration of fork, z
    const Scalar z354 = z301 - n1_1 * z324 - n0_3 * z326;
    const Scalar z355 = z336 * z336;
    const Scalar z356 = z345 * z345;
    const Scalar z357 = c_steer * z350 - z10 * z351 - z11 * z354;
    const Scalar z358 = z10 * z350 + z13 * z354 + z12 * z351;
    const Scalar z359 = z11 * z350 + z15 * z354 + z13 * z351;
    const Scalar z360 = v_yaw * z305 - v_roll * z314 + v_pitch * z332 + v_steer * z338 + v_front * z341;
    const Scalar z361 = n0_12 * z331;  // moment on rear_wheel, y
    const Scalar z362 = s_front * z345 + c_front * z349;
    const Scalar z363 = s_front * z349 - c_front * z345;
    const Scalar z364 = v_front + z336;  // angular velocity of front_wheel, y
    const Scalar z365 = a_front - z347;  // angular acceleration of front_wheel, y
    const Scalar z366 = n0_28 * z365;  // moment on front_wheel, y
    const Scalar z367 = z362 * z364;
    const Scalar z368 = z349 * z345;
    const Scalar z369 = z363 * z364;
    const Scalar z370 = z349 * z349;
    const Scalar z371 = n0_28 * z367;  // moment on front_wheel, z
    const Scalar z372 = n0_28 * z369;  // moment on front_wheel, x
    const Scalar z373 = z328 * z329;
    const Scalar z374 = n0_12 * z373;  // moment on rear_wheel, x
    const Scalar z375 = z355 + z356;
    const Scalar z376 = z356 - z370;
    const Scalar z377 = z355 + z370;
    // moment on fork, y
    const Scalar z378 = z366 - k16 * z368 - k4 * z376 - n2_5667 * z347 + n3_85 * z358 + n1_04 * z359;
    const Scalar z379 = z330 * z329;
    const Scalar z380 = n0_12 * z379;  // moment on rear_wheel, z
    const Scalar z381 = z347 + z368;
    const Scalar z382 = z347 - z368;
    const Scalar z383 = s_front * z371 - c_front * z372;
    const Scalar z384 = s_front * z372 + c_front * z371;
    const Scalar z385 = z336 * z349;
    const Scalar z386 = z353 + z385;
    const Scalar z387 = z336 * z345;
    const Scalar z388 = s_rear * z374 - c_rear * z380;
    const Scalar z389 = s_rear * z380 + c_rear * z374;
    const Scalar z390 = n3_85 * z357 - z383 - k18 * z387 - k3 * z344 + k4 * z386;  // moment on fork, x
    const Scalar z391 = z344 + z387;
    const Scalar z392 = z384 + k19 * z385 + k5 * z353 + n1_04 * z357 - k4 * z391;  // moment on fork, z
    const Scalar z393 = z3 * z10;
    const Scalar z394 = z3 * z11;
    const Scalar z395 = z318 - z325;
    const Scalar z396 = n3_85 * z377 - n1_04 * z382 + n7 * z359;  // force on fork, z
    const Scalar z397 = z4 * z10 + z5 * z11;
    const Scalar z398 = n0_3 * z393 - z397 + n1_1 * z394;
    const Scalar z399 = c_steer * z3;
    const Scalar z400 = z5 * z13 + z4 * z12;
    const Scalar z401 = n0_3 * z399 - z400;
    const Scalar z402 = s_pitch * z393 + c_pitch * z394;
    const Scalar z403 = n0_28 * z10;
    const Scalar z404 = n7 * z358 - n1_04 * z375 - n3_85 * z381;  // force on fork, x
    const Scalar z405 = n7 * z357 + n1_04 * z386 - n3_85 * z391;  // force on fork, y
    const Scalar z406 = n1_04 * z12 - n3_85 * z13;
    const Scalar z407 = n1_04 * z10 - n3_85 * z11;
    const Scalar z408 = z4 * z13 + z5 * z15;
    const Scalar z409 = n1_1 * z399 - z408;
    const Scalar z410 = n0_28 * z11;
    const Scalar z411 = s_pitch * z394 - c_pitch * z393;
    const Scalar z412 = n0_28 * c_steer;
    const Scalar z413 = s_roll * z402 - c_roll * z399;
    const Scalar z414 = s_pitch * z403 + c_pitch * z410;
    const Scalar z415 = z13 * z396 + z12 * z404 - z10 * z405;
    const Scalar z416 = z415 + n25_5 * z322 + n51 * z327;  // force on frame, x
    const Scalar z417 = n1_04 * z13 - n3_85 * z15;
    const Scalar z418 = z11 * z396 + c_steer * z405 + z10 * z404;
    const Scalar z419 = k4 * z13;
    const Scalar z420 = c_steer * z378;
    const Scalar z421 = s_pitch * z401 + c_pitch * z409;
    const Scalar z422 = c_yaw * z411 + s_yaw * z413;
    const Scalar z423 = s_yaw * z411 - c_yaw * z413;
    const Scalar z424 = s_roll * z412 + c_roll * z414;
    const Scalar z425 = z15 * z396 + z13 * z404 - z11 * z405;
    const Scalar z426 = n25_5 * z324 - z425 - n51 * z326;  // force on frame, z
    const Scalar z427 = k3 * z12 + z419;
    const Scalar z428 = z11 * z378 + z13 * z390 + z15 * z392;
    // moment on frame, z
    const Scalar z429 = n25_5 * z276 - z388 - n49_25 * z316 + n29_35 * z297 + n17_7 * z323 + n1_1 * z418 - z428;
    const Scalar z430 = v_roll * z263;
    const Scalar z431 = s_roll * z398 - c_roll * z421;
    const Scalar z432 = s_pitch * z409 - c_pitch * z401;
    const Scalar z433 = s_roll * z399 + c_roll * z402;
    const Scalar z434 = z10 * z378 + z12 * z390 + z13 * z392;
    const Scalar z435 = z389 + n78_6 * z321 + n51 * z276 - n17_7 * z319 - n0_3 * z418 + z434;  // moment on frame, x
    const Scalar z436 = n2_8467 * z10;
    const Scalar z437 = k5 * z13 + k4 * z12;
    const Scalar z438 = z10 * z390 - z420 + z11 * z392;
    const Scalar z439 = z10 * z436 + z12 * z427 + z13 * z437;
    const Scalar z440 = k5 * z15 + z419;
    // moment on frame, y
    const Scalar z441 = z361 + n49_25 * z300 + n29_35 * z320 + n17_7 * z395 - n25_5 * z301 + n51 * z287 - n0_3 * z415
        - n1_1 * z425 - z438;
    const Scalar z442 = n2_8467 * z11;
    const Scalar z443 = k3 * z13 + k4 * z15;
    const Scalar z444 = z10 * z442 + z12 * z443 + z13 * z440;
    const Scalar z445 = n2_8467 * c_steer;
    const Scalar z446 = k3 * z10 + k4 * z11;
    const Scalar z447 = k4 * z10 + k5 * z11;
    const Scalar z448 = c_steer * z445 + z10 * z446 + z11 * z447;
    const Scalar z449 = z12 * z446 - z10 * z445 + z13 * z447;
    const Scalar z450 = c_steer * z442 - z10 * z443 - z11 * z440;
    const Scalar z451 = n25_5 * z319 - z418 - n51 * z323;  // force on frame, y
    const Scalar z452 = z11 * z442 + z13 * z443 + z15 * z440;
    const Scalar z453 = n0_63 + n0_6 * z417 + z439;
    const Scalar z454 = n2_31 + n1_1 * z417 - n0_3 * z406 + z444;
    const Scalar z455 = n9_1 + n0_6 * z417 - n2_2 * z406 + z448;
    const Scalar z456 = n1_1 * z407 + z449;
    const Scalar z457 = s_pitch * z410 - c_pitch * z403;
    const Scalar z458 = s_pitch * z416 - c_pitch * z426;
    const Scalar z459 = s_pitch * z435 - c_pitch * z429;
    const Scalar z460 = n39_8603 * (z268 + z430) - z459;  // moment on frame.2, z
    const Scalar z461 = s_pitch * z426 + c_pitch * z416;
    const Scalar z462 = n8_47 - n2_2 * z406 + z452;
    const Scalar z463 = n0_3 * z407 + z450;
    const Scalar z464 = n7_7 - z406;
    const Scalar z465 = z263 * z264;
    const Scalar z466 = n25_5 + z464;
    const Scalar z467 = n2_1 + z417;
    const Scalar z468 = n51 - z467;
    const Scalar z469 = s_roll * z458 - c_roll * z451;
    const Scalar z470 = n49_25 + z455;
    const Scalar z471 = s_roll * z451 + c_roll * z458;
    const Scalar z472 = n87 * z272 - z471;  // force on frame.z, z
    const Scalar z473 = n17_7 - z454;
    const Scalar z474 = s_yaw * z469 - c_yaw * z461;
    const Scalar z475 = n29_35 - z462;
    const Scalar z476 = s_yaw * z461 + c_yaw * z469;
    const Scalar z477 = n87 * a_x + z474;  // force on frame.z, x
    const Scalar z478 = n0_12 + z470;
    const Scalar z479 = n87 * a_y - z476;  // force on frame.z, y
    const Scalar z480 = z1 * z375 + z2 * z381;
    const Scalar z481 = z1 * z382 - z2 * z377;
    const Scalar z482 = z1 * z359 + z2 * z358;
    const Scalar z483 = z296 - z321;
    const Scalar z484 = z297 - z316;
    const Scalar z485 = z318 + z325;
    const Scalar z486 = n2 * z299;
    const Scalar z487 = n2 * z330;
    const Scalar z488 = n2 * z328;
    const Scalar z489 = n2 * z349;
    const Scalar z490 = z453 + z475;
    const Scalar z491 = n2 * z473;
    const Scalar z492 = s_pitch * z490 - c_pitch * z491;
    const Scalar z493 = z2 * z336;
    const Scalar z494 = z1 * z336;
    const Scalar z495 = z1 * z345 + z2 * z349;
    const Scalar z496 = c_pitch * z468 + s_pitch * z466;
    const Scalar z497 = s_pitch * z456 - c_pitch * z463;
    const Scalar z498 = s_pitch * z492;
    const Scalar z499 = c_pitch * z492 + z473;
    const Scalar z500 = n2 * z265;
    const Scalar z501 = z2 * z357;
    const Scalar z502 = z475 - z498;
    const Scalar z503 = z453 - z498;
    const Scalar z504 = s_pitch * z468 - c_pitch * z466;
    const Scalar z505 = n2 * z497;
    const Scalar z506 = n39_8603 - z502;
    const Scalar z507 = n39_8603 + z503;
    const Scalar z508 = n2 * z266;
    const Scalar z509 = z1 * z386 - z2 * z391;
    const Scalar z510 = z478 - z506;
    const Scalar z511 = s_roll * z496 - c_roll * z407;
    const Scalar z512 = s_roll * z504;
    const Scalar z513 = z1 * z357;
    const Scalar z514 = s_roll * z510 - c_roll * z505;
    const Scalar z515 = n2 * z329;
    const Scalar z516 = n0_12 * s_roll;
    const Scalar z517 = n2 * z336;
    const Scalar z518 = n2 * z345;
    const Scalar z519 = s_yaw * z504 - c_yaw * z511;
    const Scalar z520 = z263 * z263;
    const Scalar z521 = z264 * z264;
    const Scalar z522 = z520 + z521;
    const Scalar z523 = z2 * z517;
    const Scalar z524 = s_roll * z514;
    const Scalar z525 = c_yaw * z504 + s_yaw * z511;
    const Scalar z526 = z1 * z518 + z2 * z489;
    const Scalar z527 = z506 + z524;
    const Scalar z528 = s_yaw * z496 + c_yaw * z512;
    const Scalar z529 = s_pitch * z463 + c_pitch * z456;
    const Scalar z530 = n2 * z362;
    const Scalar z531 = n2 * z364;
    const Scalar z532 = z1 * z517;
    const Scalar z533 = c_roll * z504;
    const Scalar z534 = n2 * z363;
    const Scalar z535 = s_yaw * z512 - c_yaw * z496;
    const Scalar z536 = z268 - z430;
    const Scalar z537 = v_roll * z264;
    const Scalar z538 = z270 - z537;
    const Scalar z539 = s_roll * z478 - c_roll * z497;
    const Scalar z540 = n0_14 * z530;
    const Scalar z541 = n0_14 * z534;
    const Scalar z542 = n0_14 * z531;
    const Scalar z543 = s_front * z540 - c_front * z541;
    const Scalar z544 = s_front * z541 + c_front * z540;
    const Scalar z545 = k4 * z517;
    const Scalar z546 = n1_04 * z517;
    const Scalar z547 = n3_85 * z517;
    const Scalar z548 = k39 * z517 + z542;
    const Scalar z549 = n3_85 * z489 + n1_04 * z518;
    const Scalar z550 = n0_1435 * z518 - z543;
    const Scalar z551 = z543 + k4 * z489 + k41 * z518;
    const Scalar z552 = n2 * z264;
    const Scalar z553 = s_roll * z407 + c_roll * z496;
    const Scalar z554 = k41 * z517 + z542;
    const Scalar z555 = z544 + k39 * z489 + k4 * z518;
    const Scalar z556 = n2 * z263;
    const Scalar z557 = s_yaw * z553;
    const Scalar z558 = c_yaw * z553;
    const Scalar z559 = n2 * v_roll;
    const Scalar z560 = s_roll * z529 - c_roll * z499;
    const Scalar z561 = n0_1435 * z489 - z544;
    const Scalar z562 = n0_06 * z488;
    const Scalar z563 = n0_06 * z487;
    const Scalar z564 = n0_06 * z515;
    const Scalar z565 = z13 * z545;
    const Scalar z566 = z12 * z545 + z13 * z554 + z10 * z551;
    const Scalar z567 = z565 + z15 * z554 + z11 * z551;
    const Scalar z568 = z565 + z12 * z548 + z10 * z555;
    const Scalar z569 = z12 * z550 - z13 * z561;
    const Scalar z570 = z13 * z550 - z15 * z561;
    const Scalar z571 = z10 * z550 - z11 * z561;
    const Scalar z572 = z15 * z545 + z13 * z548 + z11 * z555;
    const Scalar z573 = c_steer * z551 - z10 * z545 - z11 * z554;
    const Scalar z574 = n0_3 * z486;
    const Scalar z575 = n1_1 * z486;
    const Scalar z576 = z12 * z547 + z13 * z546 + z10 * z549;
    const Scalar z577 = n7 * z574 - z576;
    const Scalar z578 = z13 * z547 + z15 * z546 + z11 * z549;
    const Scalar z579 = n7 * z575 - z578;
    const Scalar z580 = z13 * z566 - z11 * z569 - z15 * z568;
    const Scalar z581 = z417 * z574 - z580 + n0_3 * z577;
    const Scalar z582 = z12 * z567 - z10 * z570 - z13 * z572;
    const Scalar z583 = z406 * z575 - z582 - n1_1 * z579;
    const Scalar z584 = c_steer * z555 - z10 * z548 - z11 * z545;
    const Scalar z585 = z581 + z564;
    const Scalar z586 = z12 * z566 - z10 * z569 - z13 * z568;
    const Scalar z587 = c_steer * z569 + z10 * z566 - z11 * z568;
    const Scalar z588 = z583 - z564;
    const Scalar z589 = z406 * z574 - z586 - n1_1 * z577;
    const Scalar z590 = z407 * z574 - z587;
    const Scalar z591 = n51 * z486 - z577;
    const Scalar z592 = n39_3 * z486 + z585;
    const Scalar z593 = n9_95 * z486 - z588;
    const Scalar z594 = z13 * z567 - z11 * z570 - z15 * z572;
    const Scalar z595 = c_steer * z570 + z10 * z567 - z11 * z572;
    const Scalar z596 = z417 * z575 - z594 + n0_3 * z579;
    const Scalar z597 = z407 * z575 - z595;
    const Scalar z598 = n25_5 * z486 + z579;
    const Scalar z599 = n17_7 * z486;
    const Scalar z600 = z589 + z599;
    const Scalar z601 = n0_3 * z500 - n1_1 * z508;
    const Scalar z602 = z596 - z599;
    const Scalar z603 = c_steer * z549 - z10 * z547 - z11 * z546;
    const Scalar z604 = n7 * z601 - z603;
    const Scalar z605 = z10 * z571 + z12 * z573 - z13 * z584;
    const Scalar z606 = z11 * z571 + z13 * z573 - z15 * z584;
    const Scalar z607 = c_steer * z571 - z10 * z573 + z11 * z584;
    const Scalar z608 = z406 * z601 - z605 - n1_1 * z604;
    const Scalar z609 = z417 * z601 - z606 + n0_3 * z604;
    const Scalar z610 = n51 * z500 - z604 + n25_5 * z508;
    const Scalar z611 = z407 * z601 + z607;
    const Scalar z612 = n7 * z274 + z461;
    const Scalar z613 = n7 * z271 - z469;
    const Scalar z614 = z274 * z553;
    const Scalar z615 = s_rear * z563 + c_rear * z562;
    const Scalar z616 = s_rear * z562 - c_rear * z563;
    const Scalar z617 = z590 - z615;
    const Scalar z618 = z608 + z615;
    const Scalar z619 = z597 - z616;
    const Scalar z620 = z609 + z616;
    const Scalar z621 = n39_3 * z508 - z617;
    const Scalar z622 = n39_3 * z500 - z619;
    const Scalar z623 = z618 + n17_7 * z500 + n9_95 * z508;
    const Scalar z624 = z620 + n39_3 * z500 + n17_7 * z508;
    const Scalar z625 = z600 - z602;
    const Scalar z626 = z592 - z593;
    const Scalar z627 = s_pitch * z625 + c_pitch * z626;
    const Scalar z628 = s_pitch * z598 + c_pitch * z591;
    const Scalar z629 = z407 * z522 + n7 * z276 - z504 * z536 + z264 * z628 + z451;
    const Scalar z630 = n7 * z273 - z496 * z522 + z504 * z538 + z263 * z628 - z458;
    const Scalar z631 = s_pitch * z591 - c_pitch * z598;
    const Scalar z632 = z504 * z552 + z610;
    const Scalar z633 = z276 * z504;
    const Scalar z634 = s_pitch * z627;
    const Scalar z635 = z504 * z556 - z631;
    const Scalar z636 = s_pitch * z622 - c_pitch * z621;
    const Scalar z637 = n39_8603 * z552 + z636;
    const Scalar z638 = s_pitch * z621 + c_pitch * z622;
    const Scalar z639 = n39_8603 * z559 - z638;
    const Scalar z640 = z271 * z496 + z274 * z512;
    const Scalar z641 = z602 + z634;
    const Scalar z642 = z600 - z634;
    const Scalar z643 = s_roll * z632 - c_roll * z635;
    const Scalar z644 = s_roll * z635 + c_roll * z632;
    const Scalar z645 = s_pitch * z623 + c_pitch * z624;
    const Scalar z646 = s_roll * z631 - c_roll * z610;
    const Scalar z647 = z496 * z536 - z407 * z538 + z264 * z631 + z263 * z610;
    const Scalar z648 = z611 + z641;
    const Scalar z649 = z600 + z602;
    const Scalar z650 = z611 - z602;
    const Scalar z651 = z611 - z600;
    const Scalar z652 = z407 * z556 + z496 * z552;
    const Scalar z653 = s_pitch * z624 - c_pitch * z623;
    const Scalar z654 = z429 + z453 * z484 - z287 * z407 + z456 * z485 + z473 * z483 + z266 * z650 + z265 * z592;
    const Scalar z655 = z435 + z475 * z483 - z301 * z407 - z463 * z485 - z473 * z484 + z265 * z651 - z266 * z593;
    const Scalar z656 = z301 * z468 + z287 * z466 - z463 * z483 - z456 * z484 - z478 * z485 + z265 * z624 + z266 * z623;
    const Scalar z657 = z649 + z456 * z508 - z463 * z500;
    const Scalar z658 = n7 * z301 + z407 * z483 - z468 * z485 + z265 * z610 + z426;
    const Scalar z659 = n7 * z287 - z407 * z484 - z466 * z485 + z266 * z610 - z416;
    const Scalar z660 = c_pitch * z627 + z593;
    const Scalar z661 = c_pitch * z627 - z592;
    const Scalar z662 = z653 + z478 * z552 + z497 * z556;
    const Scalar z663 = z661 + z497 * z552 + z506 * z556;
    const Scalar z664 = z273 * z496 - z276 * z407 - z529 * z536 + z499 * z538 - z507 * z522 + z264 * z637 + z263 * z660;
    const Scalar z665 = s_roll * z637 - c_roll * z660;
    const Scalar z666 = s_roll * z662 - c_roll * z663;
    const Scalar z667 = z468 * z484 + z466 * z483 + z265 * z591 + z266 * z598;
    const Scalar z668 = s_pitch * z658 - c_pitch * z659;
    const Scalar z669 = s_pitch * z659 + c_pitch * z658;
    const Scalar z670 = z645 - z639;
    const Scalar z671 = s_roll * z648 - c_roll * z670;
    const Scalar z672 = z407 * z500 - z598;
    const Scalar z673 = s_roll * z629 - c_roll * z630;
    const Scalar z674 = c_roll * z629 + s_roll * z630;
    const Scalar z675 = s_roll * z671;
    const Scalar z676 = z466 * z500 - z468 * z508;
    const Scalar z677 = z611 - z675;
    const Scalar z678 = z407 * z508 + z591;
    const Scalar z679 = c_roll * z667 + s_roll * z668;
    const Scalar z680 = s_roll * z667 - c_roll * z668;
    const Scalar z681 = z642 - z677;
    const Scalar z682 = s_yaw * z643 - c_yaw * z652;
    const Scalar z683 = s_yaw * z652 + c_yaw * z643;
    const Scalar z684 = s_yaw * z646 - c_yaw * z628;
    const Scalar z685 = z621 + z453 * z508 - z473 * z500;
    const Scalar z686 = s_yaw * z628 + c_yaw * z646;
    const Scalar z687 = z473 * z508 - z622 + z475 * z500;
    const Scalar z688 = s_pitch * z678 + c_pitch * z672;
    const Scalar z689 = s_yaw * z647 - c_yaw * z673;
    const Scalar z690 = c_yaw * z647 + s_yaw * z673;
    const Scalar z691 = s_roll * z649 - c_roll * z645;
    const Scalar z692 = z478 * z536 - z633 + z529 * z522 - z497 * z538 + z264 * z649 + z263 * z645;
    const Scalar z693 = s_yaw * z669 + c_yaw * z679;
    const Scalar z694 = s_yaw * z679 - c_yaw * z669;
    const Scalar z695 = z611 - z642;
    const Scalar z696 = z273 * z504 - z441 - z497 * z536 - z499 * z522 + z506 * z538 + z264 * z639 + z263 * z695;
    const Scalar z697 = z641 + z642;
    const Scalar z698 = z478 * z536 - z633 + z529 * z522 - z497 * z538 - z460 + z263 * z645 + z264 * z697;
    const Scalar z699 = z611 - z641;
    const Scalar z700 = c_roll * z696 + s_roll * z698;
    const Scalar z701 = z699 + z529 * z552 + z499 * z556;
    const Scalar z702 = z274 * z504 + z271 * z511;
    const Scalar z703 = s_pitch * z672 - c_pitch * z678;
    const Scalar z704 = s_yaw * z612 - c_yaw * z613;
    const Scalar z705 = c_yaw * z612 + s_yaw * z613;
    const Scalar z706 = z274 * z413 - z271 * z411;
    const Scalar z707 = z493 * z546 - z494 * z547 + n3_85 * z480 + n1_04 * z481 + z1 * z396 - n7 * z482 + z2 * z404;
    const Scalar z708 = z494 * z555 - n3_85 * z501 - n1_04 * z513 - n2_8467 * z509 - z493 * z551 + z1 * z392 + z2
        * z390;
    const Scalar z709 = z494 * z549 - z495 * z546 - n7 * z501 - n3_85 * z509 + z2 * z405;
    const Scalar z710 = z495 * z547 - z493 * z549 - n7 * z513 - n1_04 * z509 + z1 * z405;
    const Scalar z711 = z1 * z545;
    const Scalar z712 = z2 * z545;
    const Scalar z713 = z2 * z554 - z711;
    const Scalar z714 = z1 * z548 - z712;
    const Scalar z715 = z1 * z550 + z2 * z561;
    const Scalar z716 = z493 * z545 - z494 * z548 + k3 * z480 + k4 * z481 - z495 * z550 - n3_85 * z482 + z2 * z378;
    const Scalar z717 = z493 * z554 - z494 * z545 + k4 * z480 + k5 * z481 + z495 * z561 - n1_04 * z482 + z1 * z378;
    const Scalar z718 = z493 * z713 + z494 * z714 - z4 * z480 - z5 * z481 + z3 * z482 + z495 * z715;
    const Scalar z719 = z13 * z713 + z15 * z714 + z11 * z715;
    const Scalar z720 = z719 + z393 * z601 - z399 * z574;
    const Scalar z721 = z12 * z713 + z13 * z714 + z10 * z715;
    const Scalar z722 = c_steer * z715 - z10 * z713 - z11 * z714;
    const Scalar z723 = z721 + z399 * z575 - z394 * z601;
    const Scalar z724 = z393 * z575 - z722 - z394 * z574;
    const Scalar z725 = z12 * z709 + z10 * z707 + z13 * z710;
    const Scalar z726 = z409 * z483 - z301 * z393 - z401 * z484 - z398 * z485 + z287 * z394 + z265 * z720 + z266 * z723;
    const Scalar z727 = z724 + z401 * z508 + z409 * z500;
    const Scalar z728 = z13 * z709 + z11 * z707 + z15 * z710;
    const Scalar z729 = c_steer * z707 - z10 * z709 - z11 * z710;
    const Scalar z730 = s_pitch * z720 - c_pitch * z723;
    const Scalar z731 = s_pitch * z723 + c_pitch * z720;
    const Scalar z732 = z276 * z402 + z273 * z399 + z398 * z536 - z432 * z522 - z421 * z538 + z263 * z731 + z264 * z724;
    const Scalar z733 = z730 + z398 * z552 + z421 * z556;
    const Scalar z734 = s_roll * z724 - c_roll * z731;
    const Scalar z735 = c_roll * z676 + s_roll * z703;
    const Scalar z736 = s_roll * z676 - c_roll * z703;
    const Scalar z737 = s_yaw * z688 + c_yaw * z735;
    const Scalar z738 = s_yaw * z735 - c_yaw * z688;
    const Scalar z739 = z12 * z716 + z13 * z717 - z10 * z708;
    const Scalar z740 = n0_3 * z729 - z739;
    const Scalar z741 = z10 * z716 + z11 * z717 + c_steer * z708;
    const Scalar z742 = z13 * z716 + z15 * z717 - z11 * z708;
    const Scalar z743 = n0_3 * z725 - z741 + n1_1 * z728;
    const Scalar z744 = s_pitch * z616 - c_pitch * z615;
    const Scalar z745 = s_pitch * z615 + c_pitch * z616;
    const Scalar z746 = s_pitch * z685 - c_pitch * z687;
    const Scalar z747 = s_pitch * z687 + c_pitch * z685;
    const Scalar z748 = s_roll * z657 - c_roll * z746;
    const Scalar z749 = n0_12 * z536 + z263 * z745;
    const Scalar z750 = c_roll * z745;
    const Scalar z751 = s_pitch * z654 + c_pitch * z655;
    const Scalar z752 = s_pitch * z655 - c_pitch * z654;
    const Scalar z753 = n1_1 * z729 - z742;
    const Scalar z754 = s_roll * z656 + c_roll * z751;
    const Scalar z755 = z1 * z546 + z2 * z547 - n3_85 * z523 - n1_04 * z532;
    const Scalar z756 = z711 - k3 * z523 - k4 * z532 + z2 * z548;
    const Scalar z757 = z712 - k4 * z523 - k5 * z532 + z1 * z554;
    const Scalar z758 = z1 * z551 + z2 * z555 - n2_8467 * z526;
    const Scalar z759 = z2 * z549 - n3_85 * z526;
    const Scalar z760 = z1 * z549 - n1_04 * z526;
    const Scalar z761 = z12 * z759 - z10 * z755 + z13 * z760;
    const Scalar z762 = z13 * z759 - z11 * z755 + z15 * z760;
    const Scalar z763 = z10 * z759 + z11 * z760 + c_steer * z755;
    const Scalar z764 = s_pitch * z725 + c_pitch * z728;
    const Scalar z765 = s_pitch * z728 - c_pitch * z725;
    const Scalar z766 = z12 * z756 + z13 * z757 + z10 * z758;
    const Scalar z767 = n0_3 * z763 - z766;
    const Scalar z768 = s_roll * z764 - c_roll * z729;
    const Scalar z769 = s_roll * z729 + c_roll * z764;
    const Scalar z770 = z13 * z756 + z15 * z757 + z11 * z758;
    const Scalar z771 = c_steer * z758 - z10 * z756 - z11 * z757;
    const Scalar z772 = n0_3 * z761 - z771 + n1_1 * z762;
    const Scalar z773 = s_yaw * z765 - c_yaw * z768;
    const Scalar z774 = c_yaw * z765 + s_yaw * z768;
    const Scalar z775 = s_pitch * z740 + c_pitch * z753;
    const Scalar z776 = s_pitch * z753 - c_pitch * z740;
    const Scalar z777 = s_roll * z743 - c_roll * z775;
    const Scalar z778 = n0_12 * z552 + z744;
    const Scalar z779 = z493 * z543 - z494 * z544 + n0_28 * z509;
    const Scalar z780 = n1_1 * z763 - z770;
    const Scalar z781 = c_yaw * z66;
    const Scalar z782 = s_yaw * z66;
    const Scalar z783 = n0_35 * z162 / (z96 * z96);
    const Scalar z784 = z781 - z106 * z138 + z83 * z783;
    const Scalar z785 = z98 / (z58 * z58);
    const Scalar z786 = z782 - z106 * z134 + z80 * z783;
    const Scalar z787 = z68 - z83 * z106;
    const Scalar z788 = z203 - z787;
    const Scalar z789 = z68 - z787;
    const Scalar z790 = z25 * z785 - z72 * z30;
    const Scalar z791 = z71 - z80 * z106;
    const Scalar z792 = z205 - z791;
    const Scalar z793 = z197 * z788 - z240;
    const Scalar z794 = z71 - z791;
    const Scalar z795 = z53 * z789 - z235;
    const Scalar z796 = z197 * z792 - z239;
    const Scalar z797 = z53 * z794 - z246;
    const Scalar z798 = s_roll * z787 + z21 * z183;
    const Scalar z799 = z26 * z72;
    const Scalar z800 = s_roll * z791 + z19 * z183;
    const Scalar z801 = z26 * z785 - z72 * z31;
    const Scalar z802 = z25 * z72;
    const Scalar z803 = s_roll * z799 - z21 * z179;
    const Scalar z804 = s_roll * z802 - z19 * z179;
    const Scalar z805 = z10 * z543 - z11 * z544;
    const Scalar z806 = z805 + z403 * z508 + z410 * z500;
    const Scalar z807 = z12 * z543 - z13 * z544;
    const Scalar z808 = s_pitch * z761 + c_pitch * z762;
    const Scalar z809 = s_pitch * z762 - c_pitch * z761;
    const Scalar z810 = n2 * (c_roll * z22 + z25);
    const Scalar z811 = n2 * (c_roll * z24 + z26);
    const Scalar z812 = z13 * z543 - z15 * z544;
    const Scalar z813 = z412 * z485 - z403 * z484 + z410 * z483 + z265 * z812 + z266 * z807;
    const Scalar z814 = z1 * z543;
    const Scalar z815 = z814 + z2 * z544 - n0_28 * z526;
    const Scalar z816 = z2 * z544 + z814;
    const Scalar z817 = l_lambda_rear_rolls_x * z804;
    const Scalar z818 = c_roll * z763 + s_roll * z808;
    const Scalar z819 = s_roll * z763 - c_roll * z808;
    const Scalar z820 = s_pitch * z807 + c_pitch * z812;
    const Scalar z821 = z264 * z805 - z412 * z536 - z457 * z522 - z414 * z538 + z263 * z820;
    const Scalar z822 = s_pitch * z812 - c_pitch * z807;
    const Scalar z823 = z412 * z552 - z822 - z414 * z556;
    const Scalar z824 = s_roll * z805 - c_roll * z820;
    const Scalar z825 = s_yaw * z809 - c_yaw * z818;
    const Scalar z826 = c_yaw * z809 + s_yaw * z818;
    const Scalar z827 = s_pitch * z767 + c_pitch * z780;
    const Scalar z828 = s_pitch * z780 - c_pitch * z767;
    const Scalar z829 = c_roll * z827 + s_roll * z772;
    const Scalar z830 = n2 * (z56 * z56 - z53 * z53);
    const Scalar z831 = s_yaw * z124;
    const Scalar z832 = z53 * z831 + z125 * z124 + z56 * z126 + z61 * z122;
    const Scalar z833 = c_yaw * z124;
    const Scalar z834 = s_roll * z63;
    const Scalar z835 = s_yaw * z56;
    const Scalar z836 = n2 * z56;
    const Scalar z837 = z125 * z836 + z53 * (z61 + z835);
    const Scalar z838 = c_yaw * z56;
    const Scalar z839 = z132 * z836 + z53 * (z78 + z838);
    const Scalar z840 = z65 - z106 * z144 - z82 * z783;
    const Scalar z841 = s_yaw * z840;
    const Scalar z842 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z843 = n2 * (z25 * z810 + z26 * z811 - z20 * z842 - z30 * z30 - z31 * z31 - z32 * z32);
    const Scalar z844 = n2 * (z82 * z830 - z144 * z144 - z134 * z134 - z138 * z138 + z80 * z837 + z83 * z839);
    const Scalar z845 = n0_5 * (z149 * z162 / (z96 * z96) + z844 / z96);
    const Scalar z846 = c_yaw * z840;
    const Scalar z847 = z20 * z785 - z72 * z32;
    const Scalar z848 = c_yaw * z847;
    const Scalar z849 = s_yaw * z847;
    const Scalar z850 = l_lambda_rear_rolls_x * z217 - l_lambda_rear_rolls_y * z212 + l_lambda_front_rolls_x * z198
        - l_lambda_front_rolls_y * z186;
    const Scalar z851 = z614 - z850;
    const Scalar z852 = n0_5 * (z50 * z75 / (z58 * z58) + z843 / z58);
    const Scalar z853 = l_lambda_front_rolls_x * z800 - z817 - l_lambda_rear_rolls_y * z803 + l_lambda_front_rolls_y
        * z798;
    const Scalar z854 = z640 - z853;
    const Scalar z855 = l_lambda_rear_rolls_y * z803 + z817;
    const Scalar z856 = l_lambda_front_rolls_x * z796 + l_lambda_front_rolls_y * z793;
    const Scalar z857 = z706 - z856;
    const Scalar z858 = z66 - n0_35 * z845;
    const Scalar z859 = l_lambda_rear_rolls_x * z801 - l_lambda_rear_rolls_y * z790 - l_lambda_front_rolls_x * z784
        + l_lambda_front_rolls_y * z786;
    const Scalar z860 = z700 + z859;
    const Scalar z861 = l_lambda_front_rolls_x * z797 + l_lambda_front_rolls_y * z795;
    const Scalar z862 = n0_3 * z852;
    const Scalar z863 = l_lambda_rear_rolls_x * z802 + l_lambda_rear_rolls_y * z799 - l_lambda_front_rolls_x * z791
        - l_lambda_front_rolls_y * z787;
    const Scalar z864 = z702 + z863;
    const Scalar z865 = z53 * z833 + z56 * z123 + z132 * z124 + z78 * z122;
    const Scalar z866 = z193 - z840;
    const Scalar z867 = z781 - z784;
    const Scalar z868 = z65 - z840;
    const Scalar z869 = z782 - z786;
    const Scalar z870 = n2 * (z56 * z124 - z53 * z122);
    const Scalar z871 = n2 * (z82 * z870 - z144 * z131 + z134 * z142 + z138 * z135 + z80 * z832 + z83 * z865);
    const Scalar z872 = c_yaw * z128;
    const Scalar z873 = z53 * z872 + z132 * z128 + z56 * z130 - z78 * z127;
    const Scalar z874 = n2 * (z53 * z127 + z56 * z128);
    const Scalar z875 = s_roll * z164 - c_roll * z165;
    const Scalar z876 = s_yaw * z128;
    const Scalar z877 = z56 * z129 - z53 * z876 + z61 * z127 - z125 * z128;
    const Scalar z878 = n0_35 * z161 / (z96 * z96);
    const Scalar z879 = s_yaw * z62 - c_yaw * z834;
    const Scalar z880 = s_yaw * z834 + c_yaw * z62;
    const Scalar z881 = c_yaw * z197;
    const Scalar z882 = c_yaw * z204;
    const Scalar z883 = z784 - z882;
    const Scalar z884 = s_yaw * z197;
    const Scalar z885 = z83 * z878 - z879 - z106 * z135;
    const Scalar z886 = n2 * (z144 * z146 - z82 * z874 + z134 * z136 - z138 * z141 - z83 * z873 + z80 * z877);
    const Scalar z887 = z166 - z106 * z131 + z82 * z878;
    const Scalar z888 = s_yaw * z204;
    const Scalar z889 = z786 - z888;
    const Scalar z890 = z880 - z106 * z142 + z80 * z878;
    const Scalar z891 = s_yaw * z887;
    const Scalar z892 = c_yaw * z887;
    const Scalar z893 = z196 * z233 - z231 * z881 - z197 * z883 + z199 * z866;
    const Scalar z894 = c_roll * z181 - z22 * z183 + s_roll * z786 - z19 * z840;
    const Scalar z895 = z56 * z232 + z132 * z230 + z53 * z867 - z78 * z868;
    const Scalar z896 = z22 * z179 - c_roll * z178 + s_roll * z790 + z19 * z847;
    const Scalar z897 = z196 * z237 + z231 * z884 + z197 * z889 - z200 * z866;
    const Scalar z898 = s_roll * z784 - c_roll * z182 - z21 * z840 - z24 * z183;
    const Scalar z899 = z56 * z234 - z125 * z230 - z53 * z869 + z61 * z868;
    const Scalar z900 = c_roll * z180 + z24 * z179 + s_roll * z801 + z21 * z847;
    const Scalar z901 = n0_5 * (z149 * z161 / (z96 * z96) - z871 / z96);
    const Scalar z902 = n0_5 * (z162 * z148 / (z96 * z96) - z871 / z96);
    const Scalar z903 = z834 - n0_35 * z901;
    const Scalar z904 = z834 - n0_35 * z902;
    const Scalar z905 = n0_5 * (z162 * z150 / (z96 * z96) - z886 / z96);
    const Scalar z906 = z875 + n0_35 * z905;
    const Scalar z907 = l_lambda_rear_rolls_x * z900;
    const Scalar z908 = l_lambda_front_rolls_x * z895 + l_lambda_front_rolls_y * z899;
    const Scalar z909 = z821 - z908;
    const Scalar z910 = l_lambda_rear_rolls_y * z896 - z907;
    const Scalar z911 = l_lambda_rear_rolls_y * z896 - z907 + l_lambda_front_touches * z904 - l_lambda_front_rolls_y
        * z894 + l_lambda_front_rolls_x * z898;
    const Scalar z912 = z749 - z910;
    const Scalar z913 = l_lambda_front_touches * z906 + l_lambda_front_rolls_x * z893 + l_lambda_front_rolls_y * z897;
    const Scalar z914 = l_lambda_front_rolls_x * z885 - l_lambda_front_rolls_y * z890;
    const Scalar z915 = z754 + z914;
    const Scalar z916 = l_lambda_rear_touches * z862 + l_lambda_rear_rolls_x * z849 + l_lambda_rear_rolls_y * z848
        + l_lambda_front_rolls_x * z841 + l_lambda_front_rolls_y * z846 - l_lambda_front_touches * z858;
    const Scalar z917 = z732 + z913;
    const Scalar z918 = z692 - z911;
    const Scalar z919 = z664 - z916;
    const Scalar z920 = s_yaw * z52 + z54;
    const Scalar z921 = c_yaw * z52 - z73;
    const Scalar z922 = z166 - z887;
    const Scalar z923 = z880 - z890;
    const Scalar z924 = z879 + z885;
    const Scalar z925 = n0_5 * (z149 * z163 / (z96 * z96) - z886 / z96);
    const Scalar z926 = z875 + n0_35 * z925;
    const Scalar z927 = c_roll * z41;
    const Scalar z928 = c_roll * z121;
    const Scalar z929 = s_roll * z121;
    const Scalar z930 = n2 * (z53 * z927 - z124 * z124);
    const Scalar z931 = s_pitch * z156 - c_pitch * z154;
    const Scalar z932 = s_yaw * z120 + c_yaw * z929;
    const Scalar z933 = s_yaw * z929 - c_yaw * z120;
    const Scalar z934 = z53 * z932 - z123 * z128 - z124 * z130 - z78 * z928;
    const Scalar z935 = z124 * z129 + z53 * z933 - z126 * z128 - z61 * z928;
    const Scalar z936 = n2 * (z53 * z928 - z124 * z128);
    const Scalar z937 = n2 * z124;
    const Scalar z938 = z53 * z920 - z126 * z937 - z61 * z927;
    const Scalar z939 = z53 * z921 - z123 * z937 - z78 * z927;
    const Scalar z940 = n2 * (z131 * z146 + z82 * z936 + z135 * z141 - z142 * z136 + z83 * z934 + z80 * z935);
    const Scalar z941 = n2 * (z131 * z131 + z82 * z930 + z135 * z135 + z142 * z142 + z80 * z938 + z83 * z939);
    const Scalar z942 = s_yaw * z931 - c_yaw * z875;
    const Scalar z943 = s_roll * z195;
    const Scalar z944 = n0_5 * (z148 * z161 / (z96 * z96) - z941 / z96);
    const Scalar z945 = c_yaw * z931 + s_yaw * z875;
    const Scalar z946 = n0_35 * z163 / (z96 * z96);
    const Scalar z947 = c_roll * z195;
    const Scalar z948 = s_roll * z191;
    const Scalar z949 = c_yaw * z194 + s_yaw * z943;
    const Scalar z950 = s_yaw * z194 - c_yaw * z943;
    const Scalar z951 = c_roll * z191;
    const Scalar z952 = z887 - z951;
    const Scalar z953 = z942 + z106 * z141 + z83 * z946;
    const Scalar z954 = c_yaw * z192 + s_yaw * z948;
    const Scalar z955 = z890 - z954;
    const Scalar z956 = z80 * z946 - z945 - z106 * z136;
    const Scalar z957 = s_yaw * z192 - c_yaw * z948;
    const Scalar z958 = z885 + z957;
    const Scalar z959 = z21 * z887 + s_roll * z885;
    const Scalar z960 = s_roll * z890 + z19 * z887;
    const Scalar z961 = z233 * z947 - z231 * z950 - z199 * z952 + z197 * z958;
    const Scalar z962 = z231 * z949 - z237 * z947 + z197 * z955 - z200 * z952;
    const Scalar z963 = z124 * z232 + z123 * z230 - z78 * z922 + z53 * z924;
    const Scalar z964 = z124 * z234 - z126 * z230 + z53 * z923 + z61 * z922;
    const Scalar z965 = c_roll * z62;
    const Scalar z966 = z965 - n0_35 * z944;
    const Scalar z967 = c_roll * z931;
    const Scalar z968 = n0_5 * (z161 * z150 / (z96 * z96) + z940 / z96);
    const Scalar z969 = z967 + n0_35 * z968;
    const Scalar z970 = l_lambda_front_rolls_x * z963 + l_lambda_front_rolls_y * z964;
    const Scalar z971 = z813 - z970;
    const Scalar z972 = l_lambda_front_touches * z966 - l_lambda_front_rolls_y * z960 + l_lambda_front_rolls_x * z959;
    const Scalar z973 = l_lambda_front_rolls_x * z961 - l_lambda_front_rolls_y * z962 - l_lambda_front_touches * z969;
    const Scalar z974 = z726 + z973;
    const Scalar z975 = l_lambda_front_rolls_x * z953 - l_lambda_front_rolls_y * z956;
    const Scalar z976 = z777 - z975;
    const Scalar z977 = z656 + z972;
    const Scalar z978 = l_lambda_front_rolls_x * z891 + l_lambda_front_rolls_y * z892 + l_lambda_front_touches * z903;
    const Scalar z979 = z752 + z978;
    const Scalar z980 = z268 + z430;
    const Scalar z981 = z942 - z953;
    const Scalar z982 = z945 + z956;
    const Scalar z983 = z349 * z364;
    const Scalar z984 = z345 * z364;
    const Scalar z985 = n0_28 * z983;  // moment on front_wheel, z
    const Scalar z986 = n0_5 * (z148 * z163 / (z96 * z96) + z940 / z96);
    const Scalar z987 = k19 * z385 + z985 + k5 * z353 + n1_04 * z357 - k4 * z391;  // moment on fork, z
    const Scalar z988 = z967 + n0_35 * z986;
    const Scalar z989 = n0_28 * z984;  // moment on front_wheel, x
    const Scalar z990 = n3_85 * z357 - z989 - k18 * z387 - k3 * z344 + k4 * z386;  // moment on fork, x
    const Scalar z991 = z265 * z329;
    const Scalar z992 = z266 * z329;
    const Scalar z993 = n0_12 * z991;  // moment on rear_wheel, z
    const Scalar z994 = n0_12 * z992;  // moment on rear_wheel, x
    const Scalar z995 = a_z - a_roll * z98 - z117;
    const Scalar z996 = a_z + a_roll * z177 - a_pitch * z175 - a_steer * z190 + z244;
    const Scalar z997 = n2 * (z128 * z130 + z53 * z78);
    const Scalar z998 = n2 * (z53 * z53 - z128 * z128);
    const Scalar z999 = z106 * z146 - z167 + z82 * z946;
    const Scalar z1000 = z167 + z999;
    const Scalar z1001 = z15 * z987 + z13 * z990 + z11 * z378;
    const Scalar z1002 = z13 * z987 + z12 * z990 + z10 * z378;
    const Scalar z1003 = z11 * z987 - z420 + z10 * z990;
    // moment on frame, y
    const Scalar z1004 = z361 + n49_25 * z300 + n29_35 * z320 + n17_7 * z395 - n25_5 * z301 + n51 * z287 - n0_3 * z415
        - n1_1 * z425 - z1003;
    const Scalar z1005 = n25_5 * z276 - z993 - n9_95 * z319 + n17_7 * z323 + n1_1 * z418 - z1001;  // moment on frame, z
    const Scalar z1006 = n51 * z276 + z994 - n17_7 * z319 + n39_3 * z323 - n0_3 * z418 + z1002;  // moment on frame, x
    const Scalar z1007 = z1 * z990 - z2 * z987;
    const Scalar z1008 = a_x + a_yaw * z182 - a_roll * z186 + a_pitch * z210 + a_steer * z241 + a_front * z238 + z342;
    const Scalar z1009 = s_yaw * z999;
    const Scalar z1010 = a_y - z209 * (a_pitch + a_rear) - a_yaw * z178 + a_roll * z217 - z260;
    const Scalar z1011 = c_yaw * z999;
    const Scalar z1012 = a_y - a_yaw * z181 + a_roll * z198 - a_pitch * z208 - a_steer * z242 - a_front * z247 - z360;
    const Scalar z1013 = s_roll * z953 + z21 * z999;
    const Scalar z1014 = z19 * z999 + s_roll * z956;
    const Scalar z1015 = n2 * (z53 * z61 - z128 * z129);
    const Scalar z1016 = n2 * (z83 * z997 - z146 * z146 - z82 * z998 - z136 * z136 - z141 * z141 + z80 * z1015);
    const Scalar z1017 = z197 * z953 - z199 * z999;
    const Scalar z1018 = n0_5 * (z150 * z163 / (z96 * z96) + z1016 / z96);
    const Scalar z1019 = z197 * z956 - z200 * z999;
    const Scalar z1020 = z128 * z232 + z130 * z230 + z53 * z981 - z78 * z1000;
    const Scalar z1021 = c_steer * z8;
    const Scalar z1022 = z128 * z234 + z129 * z230 + z61 * z1000 + z53 * z982;
    const Scalar z1023 = c_steer * (n1 - z7);
    const Scalar z1024 = n0_08 * z1023 - n0_35 * z1021;
    const Scalar z1025 = c_steer * (n1 - z9);
    const Scalar z1026 = n0_08 * z1021 - n0_35 * z1025;
    const Scalar z1027 = l_lambda_front_rolls_x * z1020 + l_lambda_front_rolls_y * z1022;
    const Scalar z1028 = z779 + z1027;
    const Scalar z1029 = s_pitch * z1005 + c_pitch * z1006;
    const Scalar z1030 = c_pitch * z1026 + s_pitch * z1024;
    const Scalar z1031 = n0_5603 * (a_roll + z465) - z1029;  // moment on frame.2, x
    const Scalar z1032 = s_pitch * z1006 - c_pitch * z1005;
    const Scalar z1033 = z1032 - n0_5603 * z980;  // moment on frame.2, z
    const Scalar z1034 = l_lambda_front_rolls_x * z1013 - l_lambda_front_rolls_y * z1014 - l_lambda_front_touches
        * z988;
    const Scalar z1035 = c_roll * z1030 - z51;
    const Scalar z1036 = z743 - z1034;
    const Scalar z1037 = s_roll * z1004 + c_roll * z1033;
    const Scalar z1038 = z1035 + n0_35 * z1018;
    const Scalar z1039 = l_lambda_front_rolls_x * z1009 + l_lambda_front_rolls_y * z1011 - l_lambda_front_touches
        * z926;
    const Scalar z1040 = z776 + z1039;
    const Scalar z1041 = z26 * z207 - z216;
    const Scalar z1042 = z17 * z799 + z28 * z179 + s_roll * z1041 - z228;
    const Scalar z1043 = z215 * (a_pitch + a_rear) + a_x + a_yaw * z180 - a_roll * z212 + z261;
    const Scalar z1044 = v_yaw * z1041 - v_roll * z227 + z1042 * (v_pitch + v_rear);
    const Scalar z1045 = v_yaw * z787;
    const Scalar z1046 = v_yaw * z791;
    const Scalar z1047 = z803 * (a_pitch + a_rear) + a_yaw * z799 - a_roll * z212 + z1044;
    const Scalar z1048 = v_yaw * z799;
    const Scalar z1049 = v_roll * z212 - z1048 - z803 * (v_pitch + v_rear);
    const Scalar z1050 = v_roll * z212 - z1048 - z803 * (v_pitch + v_rear) + z214;
    const Scalar z1051 = z1045 + v_roll * z186 + v_pitch * z798 + v_steer * z793 - v_front * z795;
    const Scalar z1052 = z1045 + v_roll * z186 + v_pitch * z798 + v_steer * z793 - v_front * z795 + z305;
    const Scalar z1053 = v_roll * z198 - z1046 - v_pitch * z800 - v_steer * z796 + v_front * z797;
    const Scalar z1054 = v_roll * z198 - z1046 - v_pitch * z800 - v_steer * z796 + v_front * z797 - z295;
    const Scalar z1055 = z283 - z106 * z109 + z80 * z252;
    const Scalar z1056 = z309 - z17 * z791 + s_roll * z1055 - z19 * z258;
    const Scalar z1057 = z302 + z1055;
    const Scalar z1058 = z257 * z792 - z311 + z197 * z1057 - z200 * z304;
    const Scalar z1059 = z283 - z1055;
    const Scalar z1060 = z104 * z794 - z312 + z53 * z1059 + z61 * z262;
    const Scalar z1061 = z256 + z106 * z107 + z83 * z252;
    const Scalar z1062 = l_lambda_front_rolls_x * z1017 - l_lambda_front_touches * z1038 - l_lambda_front_rolls_y
        * z1019;
    const Scalar z1063 = z718 + z1062;
    const Scalar z1064 = v_yaw * z1055 + v_pitch * z1056 + v_roll * z314 - v_steer * z1058 - v_front * z1060;
    const Scalar z1065 = z290 + z1061;
    const Scalar z1066 = z257 * z788 + z310 + z197 * z1065 - z199 * z304;
    const Scalar z1067 = z254 - z17 * z787 + s_roll * z1061 - z21 * z258;
    const Scalar z1068 = a_yaw * z791 - a_roll * z198 + a_pitch * z800 + a_steer * z796 - a_front * z797 - z1064;
    const Scalar z1069 = c_steer * z35 + z37 * z41 + n2 * (s_roll * z100 + z99);
    const Scalar z1070 = n2 * (s_roll * z110 + z248) - z35 * z39 - z37 * z62;
    const Scalar z1071 = z256 - z1061;
    const Scalar z1072 = z104 * z789 + z313 + z53 * z1071 + z78 * z262;
    const Scalar z1073 = z25 * z207 - z189;
    const Scalar z1074 = z17 * z802 + z27 * z179 + s_roll * z1073 - z225;
    const Scalar z1075 = c_yaw * z17 - s_roll * z18;
    const Scalar z1076 = v_yaw * z1061 - v_roll * z259 + v_pitch * z1067 - v_steer * z1066 - v_front * z1072;
    const Scalar z1077 = a_yaw * z787 + a_roll * z186 + a_pitch * z798 + a_steer * z793 - a_front * z795 - z1076;
    const Scalar z1078 = v_yaw * z1073 + z1074 * (v_pitch + v_rear) + v_roll * z224;
    const Scalar z1079 = z804 * (a_pitch + a_rear) + a_yaw * z802 + a_roll * z217 + z1078;
    const Scalar z1080 = v_yaw * z802;
    const Scalar z1081 = z36 * z62 - z33 * z39 - c_roll * z158 + n2 * (z17 * z110 - z14 * z97) + s_roll * z221;
    const Scalar z1082 = c_roll * z28;
    const Scalar z1083 = z104 * z125;
    const Scalar z1084 = z21 * z14 + z17 * z24 + s_roll * z1075 + z1082;
    const Scalar z1085 = z48 * z30;
    const Scalar z1086 = c_roll * z17;
    const Scalar z1087 = s_yaw * z104 - z16 * z53;
    const Scalar z1088 = z104 * z132;
    const Scalar z1089 = n2 * (z56 * z104 + z53 * z102);
    const Scalar z1090 = z145 * z144;
    const Scalar z1091 = z17 * z22;
    const Scalar z1092 = z18 * z53 + c_yaw * z104;
    const Scalar z1093 = s_yaw * z17 + s_roll * z16;
    const Scalar z1094 = n2 * (s_roll * z14 - z1086);
    const Scalar z1095 = z23 * z35 - n4 * z1086;
    const Scalar z1096 = z61 * z102 - z1083 - z53 * z1087 + z56 * z108;
    const Scalar z1097 = z1088 - z78 * z102 + z53 * z1092 + z56 * z105;
    const Scalar z1098 = z19 * z14 + z1091 + s_roll * z1093 + c_roll * z27;
    const Scalar z1099 = n2 * (z26 * z1084 - z1085 - z29 * z32 - z20 * z1094 - z49 * z31 + z25 * z1098);
    const Scalar z1100 = z59 * z75;
    const Scalar z1101 = n2 * (z1090 - z82 * z1089 - z107 * z138 + z80 * z1096 - z83 * z1097 + z109 * z134);
    const Scalar z1102 = z160 * z162;
    const Scalar z1103 = z35 * z41 - c_steer * z37 + n2 * (s_roll * z88 - c_roll * z100);
    const Scalar z1104 = n4 * z17 * z14 + n2 * (s_roll * z33 + c_roll * z36);
    const Scalar z1105 = s_yaw * z1103 - z16 * z103;
    const Scalar z1106 = z18 * z103 + c_yaw * z1103;
    const Scalar z1107 = z53 * z1106 - z78 * z1069 + n2 * (z56 * z105 + z1088);
    const Scalar z1108 = z61 * z1069 - z53 * z1105 + n2 * (z56 * z108 - z1083);
    const Scalar z1109 = n4 * z56 * z104 + z103 * z1069;
    const Scalar z1110 = s_yaw * z36 + s_roll * z34 - z16 * z37;
    const Scalar z1111 = n4 * (z1090 - z107 * z138 + z109 * z134) + n2 * (z80 * z1108 - z83 * z1107 - z82 * z1109);
    const Scalar z1112 = z22 * z36 - z19 * z33 - n2 * (z17 * z1093 - z14 * z27) + s_roll * z1110 - c_roll * z43;
    const Scalar z1113 = n0_5 * (z1102 / (z96 * z96) - z1111 / z96 + z169 * z149 / (z96 * z96));
    const Scalar z1114 = n0_5 * (z1102 / (z96 * z96) - z1101 / z96);
    const Scalar z1115 = n0_5 * (z1100 / (z58 * z58) + z1099 / z58);
    const Scalar z1116 = z16 * z23 + s_yaw * z37;
    const Scalar z1117 = z19 * z35 + s_roll * z1116 + n2 * (c_roll * z27 + z1091);
    const Scalar z1118 = c_yaw * z37 - z18 * z23;
    const Scalar z1119 = z21 * z35 + s_roll * z1118 + n2 * (z17 * z24 + z1082);
    const Scalar z1120 = c_yaw * z36 + s_roll * z38 + z18 * z37;
    const Scalar z1121 = z24 * z36 - z21 * z33 - n2 * (z17 * z1075 - z14 * z28) + s_roll * z1120 - c_roll * z44;
    const Scalar z1122 = n2 * (z25 * z1117 + z26 * z1119 - z20 * z1095) - n4 * (z1085 + z29 * z32 + z49 * z31);
    const Scalar z1123 = n4 * (z49 * z1084 - z29 * z1094 + z48 * z1098) + n2 * (z20 * z1104 - z32 * z45 + z30 * z60
        + z31 * z64 + z25 * z1112 + z26 * z1121);
    const Scalar z1124 = n0_5 * (z76 * z1099 / (z58 * z58) + z75 * z67 / (z58 * z58) - z1123 / z58 + z59 * z1115 / (z58
        * z58)) + z76 * z1100 / (z58 * z58 * z58);
    const Scalar z1125 = n0_5 * (z76 * z50 / (z58 * z58) + z1100 / (z58 * z58) + z1122 / z58);
    const Scalar z1126 = z1070 - n0_35 * z1113;
    const Scalar z1127 = n0_3 * z1115;
    const Scalar z1128 = n0_3 * z1125;
    const Scalar z1129 = z250 - n0_35 * z1114;
    const Scalar z1130 = z1080 + v_roll * z217 + z804 * (v_pitch + v_rear);
    const Scalar z1131 = z1080 + v_roll * z217 + z804 * (v_pitch + v_rear) - z222;
    const Scalar z1132 = n0_6 * z76 * z75 / (z58 * z58 * z58) + z1127 / (z58 * z58);
    const Scalar z1133 = n0_3 * z1124;
    const Scalar z1134 = a_roll * z862 + z1133;
    const Scalar z1135 = n4 * z104;
    const Scalar z1136 = n2 * (z56 * z170 - z53 * z159) - z102 * z1135;
    const Scalar z1137 = z72 * z1094 - z29 * z785 - z32 * z207 + z20 * z1132;
    const Scalar z1138 = z25 * z1132 - z72 * z1098 - z48 * z785 - z30 * z207;
    const Scalar z1139 = z26 * z1132 - z72 * z1084 - z49 * z785 - z31 * z207;
    const Scalar z1140 = z38 * z53 - z18 * z171 + c_yaw * z170;
    const Scalar z1141 = z34 * z53 + z16 * z171 + s_yaw * z170;
    const Scalar z1142 = n2 * (z104 * z1092 + z102 * z105) - z78 * z159 - z132 * z170 + z56 * z172 - z53 * z1140;
    const Scalar z1143 = z61 * z159 + z125 * z170 - n2 * (z104 * z1087 - z102 * z108) + z56 * z168 + z53 * z1141;
    const Scalar z1144 = n4 * (z145 * z1089 + z109 * z1096 + z107 * z1097) + n2 * (z82 * z1136 - z144 * z173 - z138
        * z174 + z134 * z176 - z83 * z1142 + z80 * z1143);
    const Scalar z1145 = n0_5 * (z1144 / z96 - z162 * z185 / (z96 * z96) - z169 * z1101 / (z96 * z96) + z160 * z1114
        / (z96 * z96)) + z162 * z211 / (z96 * z96 * z96);
    const Scalar z1146 = z14 * z178 + z179 * z1093 - c_roll * z214 + z17 * z790 - z27 * z847 + z22 * z220 + z19 * z1137
        + s_roll * z1138;
    const Scalar z1147 = z179 * z1075 - z14 * z180 + c_roll * z222 + z17 * z801 - z28 * z847 + z24 * z220 + z21 * z1137
        + s_roll * z1139;
    const Scalar z1148 = z18 * z41;
    const Scalar z1149 = c_roll * z101 - z14 * z40;
    const Scalar z1150 = z1081 - n0_35 * z1145;
    const Scalar z1151 = z17 * z40 + s_roll * z101;
    const Scalar z1152 = z16 * z122 + z1148 - c_yaw * z100 + s_yaw * z1151;
    const Scalar z1153 = a_roll * z858 + a_pitch * z904 + a_steer * z906 - z1150;
    const Scalar z1154 = z16 * z41 - z18 * z122 + s_yaw * z100 + c_yaw * z1151;
    const Scalar z1155 = z53 * z1152 - z61 * z1149 - z104 * z126 + z108 * z124;
    const Scalar z1156 = n0_7 * z169;
    const Scalar z1157 = z162 * z1156 / (z96 * z96 * z96) + n0_35 * z1114 / (z96 * z96);
    const Scalar z1158 = v_roll * z841;
    const Scalar z1159 = v_yaw * z784 - z1158 + z259 + v_steer * z893 - v_front * z895 + v_pitch * z898;
    const Scalar z1160 = v_yaw * z784 - z1158 + v_steer * z893 - v_front * z895 + v_pitch * z898;
    const Scalar z1161 = z104 * z123;
    const Scalar z1162 = z107 * z135;
    const Scalar z1163 = n2 * (z53 * z1149 - z104 * z124);
    const Scalar z1164 = z53 * z1154 - z1161 - z78 * z1149 - z105 * z124;
    const Scalar z1165 = z250 - z106 * z1089 + z145 * z783 + z144 * z252 + z82 * z1157;
    const Scalar z1166 = z288 + z1165;
    const Scalar z1167 = z250 - z1165;
    const Scalar z1168 = v_yaw * z786;
    const Scalar z1169 = v_roll * z846 + z1168 + v_pitch * z894 - v_steer * z897 + v_front * z899 - z314;
    const Scalar z1170 = v_roll * z846 + z1168 + v_pitch * z894 - v_steer * z897 + v_front * z899;
    const Scalar z1171 = n2 * (z1162 + z145 * z131 + z82 * z1163 - z109 * z142 + z83 * z1164 + z80 * z1155);
    const Scalar z1172 = z14 * z63 + c_roll * z249;
    const Scalar z1173 = v_yaw * z790;
    const Scalar z1174 = v_roll * z848 - z1173 - z224 - z896 * (v_pitch + v_rear);
    const Scalar z1175 = v_roll * z848 - z1173 - z896 * (v_pitch + v_rear);
    const Scalar z1176 = c_yaw * z257 - z18 * z197;
    const Scalar z1177 = c_yaw * z114 - z18 * z66;
    const Scalar z1178 = z16 * z66 + s_yaw * z114;
    const Scalar z1179 = z1177 - z106 * z1097 + z107 * z783 - z138 * z252 + z83 * z1157;
    const Scalar z1180 = z1178 + z106 * z1096 - z109 * z783 - z134 * z252 + z80 * z1157;
    const Scalar z1181 = z160 * z161;
    const Scalar z1182 = n0_5 * (z1181 / (z96 * z96) + z1171 / z96);
    const Scalar z1183 = z16 * z197 + s_yaw * z257;
    const Scalar z1184 = v_yaw * z801;
    const Scalar z1185 = v_roll * z849 + z1184 - z227 + z900 * (v_pitch + v_rear);
    const Scalar z1186 = z14 * z182 - z183 * z1075 + z17 * z784 + z28 * z840 - c_roll * z295 - z24 * z258 + s_roll
        * z1179 + z21 * z1165;
    const Scalar z1187 = z17 * z786 - z14 * z181 - z183 * z1093 + z27 * z840 + c_roll * z305 - z22 * z258 + s_roll
        * z1180 + z19 * z1165;
    const Scalar z1188 = v_roll * z849 + z1184 + z900 * (v_pitch + v_rear);
    const Scalar z1189 = z1177 - z1179;
    const Scalar z1190 = z56 * z286 - z102 * z232 - z230 * z1092 - z104 * z867 - z105 * z868 + z132 * z262 + z53 * z1189
        + z78 * z1167;
    const Scalar z1191 = z1178 - z1180;
    const Scalar z1192 = z230 * z1087 - z102 * z234 + z104 * z869 - z108 * z868 + z56 * z298 - z125 * z262 - z53 * z1191
        - z61 * z1167;
    const Scalar z1193 = z1172 + n0_35 * z1182;
    const Scalar z1194 = c_yaw * z292 - z18 * z204;
    const Scalar z1195 = z16 * z204 + s_yaw * z292;
    const Scalar z1196 = z1179 - z1194;
    const Scalar z1197 = z1180 - z1195;
    const Scalar z1198 = s_yaw * z1165 - z16 * z840;
    const Scalar z1199 = z231 * z1176 - z233 * z281 + z257 * z883 + z284 * z866 + z196 * z294 + z304 * z881 + z197
        * z1196 - z199 * z1166;
    const Scalar z1200 = z237 * z281 + z231 * z1183 + z257 * z889 - z306 * z866 + z196 * z308 + z304 * z884 + z197
        * z1197 - z200 * z1166;
    const Scalar z1201 = v_yaw * z1179 + v_roll * z1198 + v_pitch * z1186 - v_steer * z1199 - v_front * z1190;
    const Scalar z1202 = a_yaw * z784 - a_roll * z841 + a_pitch * z898 + a_steer * z893 - a_front * z895 + z1201;
    const Scalar z1203 = z55 * z133 + s_pitch * z202 + c_pitch * z188 + z57 * z137 + n2 * (z85 * z94 - z95 * z86);
    const Scalar z1204 = z18 * z840 + c_yaw * z1165;
    const Scalar z1205 = v_yaw * z1180 - v_roll * z1204 + v_pitch * z1187 - v_steer * z1200 + v_front * z1192;
    const Scalar z1206 = z33 * z63 - z35 * z249 + c_roll * z1203;
    const Scalar z1207 = n2 * z86;
    const Scalar z1208 = n2 * z85;
    const Scalar z1209 = z57 * z1207 - z55 * z1208 + n2 * (c_pitch * z95 + z245);
    const Scalar z1210 = z10 * z1207 + z11 * z1208 + n2 * (s_pitch * z90 - c_pitch * z89);
    const Scalar z1211 = z10 * z1208 - z11 * z1207 + n2 * (s_pitch * z89 + c_pitch * z90);
    const Scalar z1212 = a_yaw * z786 + a_roll * z846 + a_pitch * z894 - a_steer * z897 + a_front * z899 + z1205;
    const Scalar z1213 = z35 * z63 + c_roll * z1209;
    const Scalar z1214 = z37 * z40 + s_roll * z1210;
    const Scalar z1215 = n2 * (z16 * z122 + z1148) - c_yaw * z1211 + s_yaw * z1214;
    const Scalar z1216 = n2 * (z16 * z41 - z18 * z122) + s_yaw * z1211 + c_yaw * z1214;
    const Scalar z1217 = c_roll * z1210 - z35 * z40;
    const Scalar z1218 = z53 * z1216 - z78 * z1217 - n2 * (z105 * z124 + z1161);
    const Scalar z1219 = z53 * z1215 - z61 * z1217 - n2 * (z104 * z126 - z108 * z124);
    const Scalar z1220 = z103 * z1217 - z124 * z1135;
    const Scalar z1221 = c_yaw * z1137 - z18 * z847;
    const Scalar z1222 = n2 * (z82 * z1220 + z80 * z1219 + z83 * z1218) - n4 * (z109 * z142 - z1162 - z145 * z131);
    const Scalar z1223 = v_yaw * z1138 - v_roll * z1221 + z1146 * (v_pitch + v_rear);
    const Scalar z1224 = z896 * (a_pitch + a_rear) + a_yaw * z790 - a_roll * z848 + z1223;
    const Scalar z1225 = s_roll * z249 - z17 * z63;
    const Scalar z1226 = z16 * z847 + s_yaw * z1137;
    const Scalar z1227 = v_roll * z1226 + v_yaw * z1139 + z1147 * (v_pitch + v_rear);
    const Scalar z1228 = n0_5 * (z1222 / z96 + z1181 / (z96 * z96) + z169 * z148 / (z96 * z96));
    const Scalar z1229 = z33 * z40 + z35 * z101 + c_roll * z157;
    const Scalar z1230 = z36 * z40 - z37 * z101 + s_roll * z157;
    const Scalar z1231 = z900 * (a_pitch + a_rear) + a_yaw * z801 + a_roll * z849 + z1227;
    const Scalar z1232 = z2 * z88;
    const Scalar z1233 = z1 * z88;
    const Scalar z1234 = z8 * z87;
    const Scalar z1235 = -z87 * (n1 - z7);
    const Scalar z1236 = n0_35 * z1234 + n0_08 * z1235;
    const Scalar z1237 = z1135 * z1149 + n2 * (z53 * z1229 + z124 * z170);
    const Scalar z1238 = z1213 + n0_35 * z1228;
    const Scalar z1239 = z85 * z154;
    const Scalar z1240 = -z87 * (n1 - z9);
    const Scalar z1241 = n0_08 * z1234 + n0_35 * z1240;
    const Scalar z1242 = z34 * z41 + z38 * z122 - n2 * (z16 * z100 - z18 * z1151) + s_yaw * z151 + c_yaw * z1230;
    const Scalar z1243 = z34 * z122 - z38 * z41 - n2 * (z18 * z100 + z16 * z1151) - c_yaw * z151 + s_yaw * z1230;
    const Scalar z1244 = n2 * (z104 * z1154 + z105 * z1149) - z78 * z1229 + z123 * z170 + z53 * z1242 - z124 * z172;
    const Scalar z1245 = z126 * z170 - z61 * z1229 + n2 * (z104 * z1152 - z108 * z1149) + z53 * z1243 + z124 * z168;
    const Scalar z1246 = n4 * (z109 * z1155 - z107 * z1164 - z145 * z1163) + n2 * (z82 * z1237 - z131 * z173 + z135
        * z174 - z142 * z176 + z83 * z1244 + z80 * z1245);
    const Scalar z1247 = n0_5 * (z169 * z1171 / (z96 * z96) - z161 * z185 / (z96 * z96) - z1246 / z96 + z160 * z1182
        / (z96 * z96)) + z161 * z211 / (z96 * z96 * z96);
    const Scalar z1248 = z161 * z1156 / (z96 * z96 * z96) + n0_35 * z1182 / (z96 * z96);
    const Scalar z1249 = z145 * z878 - z1172 - z106 * z1163 - z131 * z252 + z82 * z1248;
    const Scalar z1250 = z1172 + z1249;
    const Scalar z1251 = z86 * z119;
    const Scalar z1252 = z85 * z119;
    const Scalar z1253 = z18 * z121;
    const Scalar z1254 = z1251 + s_pitch * z1232 - z85 * z118 + c_pitch * z1233;
    const Scalar z1255 = s_pitch * z1233 - z1252 - z86 * z118 - c_pitch * z1232;
    const Scalar z1256 = z1206 + n0_35 * z1247;
    const Scalar z1257 = s_steer * z17;
    const Scalar z1258 = a_roll * z903 + a_pitch * z966 + a_steer * z969 + z1256;
    const Scalar z1259 = z86 * z156 - z1239 + s_pitch * z1236 - c_pitch * z1241;
    const Scalar z1260 = s_roll * z87 + z1257 + z14 * z120 + c_roll * z1254;
    const Scalar z1261 = s_steer * z14 - c_roll * z87 - z17 * z120 + s_roll * z1254;
    const Scalar z1262 = z1253 - z16 * z127 + c_yaw * z1255 + s_yaw * z1261;
    const Scalar z1263 = n0_08 * z1232 - n0_35 * z1233;
    const Scalar z1264 = z17 * z165;
    const Scalar z1265 = v_yaw * z885;
    const Scalar z1266 = v_roll * z891 + z1265 + v_pitch * z959 - v_steer * z961 + v_front * z963 - z315;
    const Scalar z1267 = v_roll * z891 + z1265 + v_pitch * z959 - v_steer * z961 + v_front * z963;
    const Scalar z1268 = z104 * z129;
    const Scalar z1269 = z16 * z121;
    const Scalar z1270 = z104 * z130;
    const Scalar z1271 = z1268 - z61 * z1260 + z53 * z1262 + z108 * z128;
    const Scalar z1272 = s_yaw * z1255 - z1269 - z18 * z127 - c_yaw * z1261;
    const Scalar z1273 = v_yaw * z890;
    const Scalar z1274 = v_roll * z892 - z1273 - v_pitch * z960 + v_steer * z962 + v_front * z964 - z332;
    const Scalar z1275 = v_roll * z892 - z1273 - v_pitch * z960 + v_steer * z962 + v_front * z964;
    const Scalar z1276 = s_roll * z1263 - z1264 + z14 * z164 + c_roll * z1259;
    const Scalar z1277 = s_roll * z275 - z17 * z195;
    const Scalar z1278 = z14 * z195 + c_roll * z275;
    const Scalar z1279 = s_yaw * z110 - z16 * z62 - z18 * z834 - c_yaw * z1225;
    const Scalar z1280 = z18 * z62 - z16 * z834 + c_yaw * z110 + s_yaw * z1225;
    const Scalar z1281 = z1279 - z106 * z1164 + z107 * z878 - z135 * z252 + z83 * z1248;
    const Scalar z1282 = z80 * z1248 - z1280 - z106 * z1155 - z109 * z878 - z142 * z252;
    const Scalar z1283 = z107 * z141;
    const Scalar z1284 = n2 * (z53 * z1260 - z104 * z128);
    const Scalar z1285 = z78 * z1260 + z1270 + z105 * z128 + z53 * z1272;
    const Scalar z1286 = z1279 - z1281;
    const Scalar z1287 = z18 * z194 - c_yaw * z251 - z16 * z943 + s_yaw * z1277;
    const Scalar z1288 = z16 * z194 + s_yaw * z251 + z18 * z943 + c_yaw * z1277;
    const Scalar z1289 = z105 * z922 - z232 * z1149 - z230 * z1154 - z124 * z286 - z123 * z262 + z104 * z924 + z53
        * z1286 - z78 * z1250;
    const Scalar z1290 = z1280 + z1282;
    const Scalar z1291 = z230 * z1152 - z234 * z1149 + z104 * z923 + z108 * z922 - z124 * z298 + z126 * z262 + z61
        * z1250 + z53 * z1290;
    const Scalar z1292 = z17 * z191 + s_roll * z280;
    const Scalar z1293 = c_roll * z280 - z14 * z191;
    const Scalar z1294 = z1249 - z1293;
    const Scalar z1295 = z16 * z192 + s_yaw * z282 + z18 * z948 - c_yaw * z1292;
    const Scalar z1296 = c_yaw * z282 - z18 * z192 + z16 * z948 + s_yaw * z1292;
    const Scalar z1297 = z1281 + z1295;
    const Scalar z1298 = z284 * z952 - z233 * z1278 - z231 * z1288 - z294 * z947 - z304 * z950 + z257 * z958 + z197
        * z1297 - z199 * z1294;
    const Scalar z1299 = z1282 - z1296;
    const Scalar z1300 = z237 * z1278 - z231 * z1287 + z257 * z955 - z306 * z952 + z304 * z949 - z308 * z947 - z200
        * z1294 + z197 * z1299;
    const Scalar z1301 = z16 * z887 + s_yaw * z1249;
    const Scalar z1302 = n2 * (z1283 + z145 * z146 + z82 * z1284 + z80 * z1271 - z83 * z1285 + z109 * z136);
    const Scalar z1303 = c_yaw * z1249 - z18 * z887;
    const Scalar z1304 = z17 * z885 - z28 * z887 + s_roll * z1281 + z21 * z1249;
    const Scalar z1305 = v_yaw * z1281 + v_roll * z1301 + v_pitch * z1304 - v_steer * z1298 - v_front * z1289;
    const Scalar z1306 = z17 * z890 - z27 * z887 + z19 * z1249 + s_roll * z1282;
    const Scalar z1307 = v_yaw * z1282 - v_roll * z1303 + v_pitch * z1306 - v_steer * z1300 + v_front * z1291;
    const Scalar z1308 = a_yaw * z885 + a_roll * z891 + a_pitch * z959 - a_steer * z961 + a_front * z963 + z1305;
    const Scalar z1309 = n2 * z88;
    const Scalar z1310 = z2 * z140;
    const Scalar z1311 = z1 * z140;
    const Scalar z1312 = z1 * z1309;
    const Scalar z1313 = z2 * z1309;
    const Scalar z1314 = a_yaw * z890 - a_roll * z892 + a_pitch * z960 - a_steer * z962 - a_front * z964 + z1307;
    const Scalar z1315 = s_pitch * z1312 - n2 * (z86 * z118 + z1252) - c_pitch * z1313;
    const Scalar z1316 = s_pitch * z1313 - n2 * (z85 * z118 - z1251) + c_pitch * z1312;
    const Scalar z1317 = n0_08 * z1313 - n0_35 * z1312;
    const Scalar z1318 = z118 * z133 + z119 * z137 + s_pitch * z1310 + c_pitch * z1311 + n2 * (z85 * z1232 - z86
        * z1233);
    const Scalar z1319 = z119 * z133 - z118 * z137 + s_pitch * z1311 - c_pitch * z1310 + n2 * (z85 * z1233 + z86
        * z1232);
    const Scalar z1320 = n0_08 * z1310 - n0_35 * z1311;
    const Scalar z1321 = s_roll * z139 + s_steer * z36 - z33 * z120 - n2 * (z17 * z87 - z14 * z1254) - c_roll * z1318;
    const Scalar z1322 = c_roll * z139 + s_steer * z33 + z36 * z120 + n2 * (z14 * z87 + z17 * z1254) + s_roll * z1318;
    const Scalar z1323 = n2 * z87;
    const Scalar z1324 = n2 * (z14 * z120 + z1257) + s_roll * z1323 + c_roll * z1316;
    const Scalar z1325 = n2 * (s_steer * z14 - z17 * z120) - c_roll * z1323 + s_roll * z1316;
    const Scalar z1326 = z160 * z163;
    const Scalar z1327 = c_yaw * z1315 - n2 * (z16 * z127 - z1253) + s_yaw * z1325;
    const Scalar z1328 = s_yaw * z1315 - n2 * (z18 * z127 + z1269) - c_yaw * z1325;
    const Scalar z1329 = z53 * z1327 - z61 * z1324 + n2 * (z108 * z128 + z1268);
    const Scalar z1330 = z78 * z1324 + n2 * (z105 * z128 + z1270) + z53 * z1328;
    const Scalar z1331 = z103 * z1324 - z128 * z1135;
    const Scalar z1332 = n4 * (z1283 + z145 * z146 + z109 * z136) + n2 * (z82 * z1331 + z80 * z1329 - z83 * z1330);
    const Scalar z1333 = z1135 * z1260 + n2 * (z53 * z1321 + z128 * z170);
    const Scalar z1334 = z34 * z121 - z38 * z127 + n2 * (z16 * z1255 + z18 * z1261) + s_yaw * z1319 - c_yaw * z1322;
    const Scalar z1335 = z38 * z121 + z34 * z127 + n2 * (z16 * z1261 - z18 * z1255) + c_yaw * z1319 + s_yaw * z1322;
    const Scalar z1336 = z130 * z170 - z78 * z1321 - n2 * (z104 * z1272 - z105 * z1260) + z53 * z1334 - z128 * z172;
    const Scalar z1337 = z61 * z1321 + z129 * z170 - n2 * (z104 * z1262 - z108 * z1260) + z53 * z1335 - z128 * z168;
    const Scalar z1338 = n2 * (z146 * z173 - z82 * z1333 - z141 * z174 - z136 * z176 - z83 * z1336 + z80 * z1337) - n4
        * (z109 * z1271 + z107 * z1285 - z145 * z1284);
    const Scalar z1339 = n0_5 * (z1326 / (z96 * z96) - z1332 / z96 + z169 * z150 / (z96 * z96));
    const Scalar z1340 = n0_5 * (z1326 / (z96 * z96) - z1302 / z96);
    const Scalar z1341 = n0_5 * (z160 * z1340 / (z96 * z96) - z169 * z1302 / (z96 * z96) - z163 * z185 / (z96 * z96)
        - z1338 / z96) + z163 * z211 / (z96 * z96 * z96);
    const Scalar z1342 = z163 * z1156 / (z96 * z96 * z96) + n0_35 * z1340 / (z96 * z96);
    const Scalar z1343 = z1276 - n0_35 * z1340;
    const Scalar z1344 = v_roll * z1009;
    const Scalar z1345 = v_yaw * z953 + z1344 + v_pitch * z1013 - v_steer * z1017 - v_front * z1020 - z333;
    const Scalar z1346 = z1276 + z106 * z1284 + z145 * z946 + z146 * z252 + z82 * z1342;
    const Scalar z1347 = v_yaw * z953 + z1344 + v_pitch * z1013 - v_steer * z1017 - v_front * z1020;
    const Scalar z1348 = z1276 - z1346;
    const Scalar z1349 = v_yaw * z956;
    const Scalar z1350 = z85 * z156 + z86 * z154 + s_pitch * z1241 + c_pitch * z1236;
    const Scalar z1351 = z8 * z139;
    const Scalar z1352 = s_roll * z1259 - c_roll * z1263 - z17 * z164 - z14 * z165;
    const Scalar z1353 = -z139 * (n1 - z7);
    const Scalar z1354 = n0_35 * z1351 + n0_08 * z1353;
    const Scalar z1355 = -z139 * (n1 - z9);
    const Scalar z1356 = n0_08 * z1351 + n0_35 * z1355;
    const Scalar z1357 = z16 * z931 + z18 * z875 + s_yaw * z1350 + c_yaw * z1352;
    const Scalar z1358 = s_pitch * z1354 - z156 * z137 - z154 * z133 - c_pitch * z1356 - n2 * (z85 * z1236 + z86
        * z1241);
    const Scalar z1359 = z1357 - z106 * z1285 + z107 * z946 + z141 * z252 + z83 * z1342;
    const Scalar z1360 = z8 * z1323;
    const Scalar z1361 = -z1323 * (n1 - z7);
    const Scalar z1362 = -z1323 * (n1 - z9);
    const Scalar z1363 = n0_35 * z1360 + n0_08 * z1361;
    const Scalar z1364 = z18 * z931 - z16 * z875 - c_yaw * z1350 + s_yaw * z1352;
    const Scalar z1365 = z1364 + z106 * z1271 - z109 * z946 - z136 * z252 + z80 * z1342;
    const Scalar z1366 = z36 * z165 + s_roll * z1320 + z33 * z164 + n2 * (z17 * z1263 - z14 * z1259) - c_roll * z1358;
    const Scalar z1367 = n0_08 * z1360 + n0_35 * z1362;
    const Scalar z1368 = s_pitch * z1363 - c_pitch * z1367 + n2 * (z86 * z156 - z1239);
    const Scalar z1369 = z17 * z953 - z28 * z999 + s_roll * z1359 + z21 * z1346;
    const Scalar z1370 = z17 * z956 - z27 * z999 + s_roll * z1365 + z19 * z1346;
    const Scalar z1371 = s_roll * z1317 + n2 * (z14 * z164 - z1264) + c_roll * z1368;
    const Scalar z1372 = z257 * z953 + z284 * z999 + z197 * z1359 - z199 * z1346;
    const Scalar z1373 = z257 * z956 - z306 * z999 + z197 * z1365 - z200 * z1346;
    const Scalar z1374 = z1366 - n0_35 * z1341;
    const Scalar z1375 = a_roll * z926 + a_pitch * z988 - a_steer * z1038 + z1374;
    const Scalar z1376 = z1371 - n0_35 * z1339;
    const Scalar z1377 = z16 * z999 + s_yaw * z1346;
    const Scalar z1378 = c_yaw * z1346 - z18 * z999;
    const Scalar z1379 = z1357 - z1359;
    const Scalar z1380 = z232 * z1260 - z230 * z1272 - z104 * z981 - z105 * z1000 + z128 * z286 + z130 * z262 + z53
        * z1379 + z78 * z1348;
    const Scalar z1381 = z1364 - z1365;
    const Scalar z1382 = z230 * z1262 - z234 * z1260 + z108 * z1000 - z128 * z298 - z129 * z262 + z104 * z982 + z53
        * z1381 + z61 * z1348;
    const Scalar z1383 = v_yaw * z1359 + v_roll * z1377 + v_pitch * z1369 - v_steer * z1372 - v_front * z1380;
    const Scalar z1384 = a_yaw * z953 + a_roll * z1009 + a_pitch * z1013 - a_steer * z1017 - a_front * z1020 + z1383;
    const Scalar z1385 = v_yaw * z1365 - v_roll * z1378 + v_pitch * z1370 - v_steer * z1373 - v_front * z1382;
    const Scalar z1386 = a_yaw * z956 - a_roll * z1011 + a_pitch * z1014 - a_steer * z1019 + a_front * z1022 + z1385;
    const Scalar z1387 = v_roll * z1011 - z1349 - v_pitch * z1014 + v_steer * z1019 - v_front * z1022 + z338;
    const Scalar z1388 = v_roll * z1011 - z1349 - v_pitch * z1014 + v_steer * z1019 - v_front * z1022;
    const Scalar z1389 = n1 / z238;
    const Scalar z1390 = z247 * z1389;
    const Scalar z1391 = n1 / z175;
    const Scalar z1392 = z98 + z177;
    const Scalar z1393 = z1391 * z1392;
    const Scalar z1394 = z190 * z1391;
    const Scalar z1395 = z208 * z1391;
    const Scalar z1396 = z181 - z182 * z1390;
    const Scalar z1397 = z1193 * z1394 - z1343;
    const Scalar z1398 = z1129 - z1193 * z1393;
    const Scalar z1399 = z1160 + z1267 * z1393;
    const Scalar z1400 = z1267 * z1394 + z1347;
    const Scalar z1401 = z178 - z1396;
    const Scalar z1402 = z1170 - z1275 * z1393;
    const Scalar z1403 = z1275 * z1394 + z1388;
    const Scalar z1404 = z1401 * z1401;
    const Scalar z1405 = n1 / z1401;
    const Scalar z1406 = z209 * z1391;
    const Scalar z1407 = z210 * z1391;
    const Scalar z1408 = z1051 - z1049 + z1053 * z1390;
    const Scalar z1409 = z190 * z1406;
    const Scalar z1410 = z190 * z1407 - z241;
    const Scalar z1411 = z215 * z1391;
    const Scalar z1412 = z1127 - z1398;
    const Scalar z1413 = z190 * z1395 - z242 - z1409 - z1390 * z1410;
    const Scalar z1414 = z217 - z1406 * z1392;
    const Scalar z1415 = z186 - z1407 * z1392;
    const Scalar z1416 = z198 - z1395 * z1392 - z1414 - z1390 * z1415;
    const Scalar z1417 = z180 * z1405;
    const Scalar z1418 = z1407 * z1412 - z1399;
    const Scalar z1419 = z175 * z175;
    const Scalar z1420 = n1_over_94 + z190 * z190 / z6 + z177 * z177 / z507 + z1419 / z478;
    const Scalar z1421 = z1130 - z1417 * z1408;
    const Scalar z1422 = z212 - z1411 * z1392 + z1417 * z1416;
    const Scalar z1423 = n1 - z1390 * z1417;
    const Scalar z1424 = z1175 + z1406 * z1412;
    const Scalar z1425 = z1423 * z1423;
    const Scalar z1426 = n1 / z1423;
    const Scalar z1427 = z1395 * z1412 - z1424 + z1402 - z1390 * z1418;
    const Scalar z1428 = z215 - z209 * z1417;
    const Scalar z1429 = z190 * z1411 + z1417 * z1413;
    const Scalar z1430 = z238 * z238;
    const Scalar z1431 = n1_over_94 + n25_over_7 * z1430 + z182 * z182 / z527 + z186 * z186 / z507 + z241 * z241 / z6
        + z210 * z210 / z478;
    const Scalar z1432 = z478 * z1420;
    const Scalar z1433 = z1426 * z1428;
    const Scalar z1434 = z1426 * z1429;
    const Scalar z1435 = z1188 + z1411 * z1412 + z1417 * z1427;
    const Scalar z1436 = z1390 * z1434 + z1413;
    const Scalar z1437 = z1426 * z1421;
    const Scalar z1438 = z1426 * z1435;
    const Scalar z1439 = z1405 * z1436;
    const Scalar z1440 = z1426 * z1422;
    const Scalar z1441 = z1390 * z1437 - z1408;
    const Scalar z1442 = z1390 * z1438 + z1427;
    const Scalar z1443 = z178 * z1439 + z1409;
    const Scalar z1444 = n0_28 * z1431;
    const Scalar z1445 = z1390 * z1440 + z1416;
    const Scalar z1446 = z1405 * z1441;
    const Scalar z1447 = z1405 * z1442;
    const Scalar z1448 = z1053 - z1437 + z182 * z1446;
    const Scalar z1449 = z1418 - z1438 + z182 * z1447;
    const Scalar z1450 = z178 * z1446 - z1049;
    const Scalar z1451 = z178 * z1447 + z1424;
    const Scalar z1452 = z1405 * z1445;
    const Scalar z1453 = z1410 - z1434 + z182 * z1439;
    const Scalar z1454 = z1389 * z1453;
    const Scalar z1455 = z1389 * z1448;
    const Scalar z1456 = z178 * z1452 + z1414;
    const Scalar z1457 = z1415 - z1440 + z182 * z1452;
    const Scalar z1458 = z1389 * z1449;
    const Scalar z1459 = z1389 * z1457;
    const Scalar z1460 = z209 - z1390 * z1433;
    const Scalar z1461 = z1405 * z1460;
    const Scalar z1462 = n1_over_94 + n25_over_7 * z247 * z247 + z181 * z181 / z527 + z198 * z198 / z507 + z242 * z242
        / z6 + z208 * z208 / z478;
    const Scalar z1463 = z527 * z1462;
    const Scalar z1464 = z1407 * z1397 - z1400;
    const Scalar z1465 = z1391 * z1412;
    const Scalar z1466 = z1406 * z1397;
    const Scalar z1467 = z178 * z1461 - z209;
    const Scalar z1468 = z182 * z1461 + z1433;
    const Scalar z1469 = z1389 * z1468;
    const Scalar z1470 = n1_over_94 + z215 * z215 * (n25_over_3 + n1 / z478) + z212 * z212 / z507 + z180 * z180 / z527;
    const Scalar z1471 = n94 * z1470;
    const Scalar z1472 = z1395 * z1397 - z1466 - z1403 - z1390 * z1464;
    const Scalar z1473 = z1126 - z1238 * z1393;
    const Scalar z1474 = z1238 * z1394 - z1376;
    const Scalar z1475 = z226 * z1393 + z1174 - z1050 * z1452;
    const Scalar z1476 = z1128 - z1473;
    const Scalar z1477 = z1406 * z1476 + z1475;
    const Scalar z1478 = z1054 * z1452 - z1159 - z1266 * z1393 + z339 * z1459;
    const Scalar z1479 = z1345 + z1266 * z1394 + z1054 * z1439 + z339 * z1454;
    const Scalar z1480 = z1169 - z1274 * z1393 - z1052 * z1452 + z341 * z1459;
    const Scalar z1481 = z1274 * z1394 + z1387 - z1052 * z1439 + z341 * z1454;
    const Scalar z1482 = z255 * z1393 + z1185 + z1131 * z1452;
    const Scalar z1483 = z1407 * z1476 + z1478;
    const Scalar z1484 = z1407 * z1474 - z1479;
    const Scalar z1485 = z1395 * z1476 - z1477 + z1480 - z1390 * z1483;
    const Scalar z1486 = z1411 * z1397 + z1417 * z1472;
    const Scalar z1487 = z1426 * z1486;
    const Scalar z1488 = z1391 * z1397;
    const Scalar z1489 = z1411 * z1476 + z1482 + z1417 * z1485;
    const Scalar z1490 = z1390 * z1487 + z1472;
    const Scalar z1491 = z1391 * z1476;
    const Scalar z1492 = z1426 * z1489;
    const Scalar z1493 = z1238 * z1465;
    const Scalar z1494 = z1238 * z1488;
    const Scalar z1495 = z1390 * z1492 + z1485;
    const Scalar z1496 = z1405 * z1490;
    const Scalar z1497 = z226 * z1465 + z1050 * z1447;
    const Scalar z1498 = z226 * z1394 + z1050 * z1439;
    const Scalar z1499 = z1464 - z1487 + z182 * z1496;
    const Scalar z1500 = z178 * z1496 + z1466;
    const Scalar z1501 = z1406 * z1474 + z1498;
    const Scalar z1502 = z1389 * z1499;
    const Scalar z1503 = z1153 + z1258 * z1393;
    const Scalar z1504 = z1258 * z1394 - z1375;
    const Scalar z1505 = z1202 + z1308 * z1393;
    const Scalar z1506 = z1308 * z1394 + z1384;
    const Scalar z1507 = z1395 * z1474 - z1501 - z1481 - z1390 * z1484;
    const Scalar z1508 = z1405 * z1495;
    const Scalar z1509 = z178 * z1508 + z1477;
    const Scalar z1510 = z1483 - z1492 + z182 * z1508;
    const Scalar z1511 = z226 * z1488 + z1050 * z1496;
    const Scalar z1512 = z226 - z1050 * z1461;
    const Scalar z1513 = z1050 * z1446;
    const Scalar z1514 = z1389 * z1510;
    const Scalar z1515 = z1054 * z1446 + z339 * z1455;
    const Scalar z1516 = z1266 * z1465 + z1054 * z1447 + z339 * z1458;
    const Scalar z1517 = z1266 * z1488 + z1054 * z1496 + z339 * z1502;
    const Scalar z1518 = z1054 * z1461 + z339 * z1469;
    const Scalar z1519 = z1274 * z1465 - z1052 * z1447 + z341 * z1458;
    const Scalar z1520 = z1274 * z1488 - z1052 * z1496 + z341 * z1502;
    const Scalar z1521 = z341 * z1455 - z1052 * z1446;
    const Scalar z1522 = z341 * z1469 - z1052 * z1461;
    const Scalar z1523 = z1390 * z1518 + z1512 - z1522;
    const Scalar z1524 = z255 * z1465 - z1131 * z1447;
    const Scalar z1525 = z1131 * z1446;
    const Scalar z1526 = z255 * z1394 - z1131 * z1439;
    const Scalar z1527 = z1212 + z1314 * z1393;
    const Scalar z1528 = z1411 * z1474 + z1526 + z1417 * z1507;
    const Scalar z1529 = z1391 * z1474;
    const Scalar z1530 = z255 * z1488 - z1131 * z1496;
    const Scalar z1531 = z255 + z1131 * z1461;
    const Scalar z1532 = z1493 + z1503;
    const Scalar z1533 = z1494 + z1504;
    const Scalar z1534 = z1224 - z1497;
    const Scalar z1535 = z1314 * z1394 + z1386;
    const Scalar z1536 = z1047 + z1513;
    const Scalar z1537 = z1068 + z1515;
    const Scalar z1538 = z1516 + z1505;
    const Scalar z1539 = z1517 + z1506;
    const Scalar z1540 = z1519 - z1527;
    const Scalar z1541 = z1520 - z1535;
    const Scalar z1542 = z1077 + z1521;
    const Scalar z1543 = z1231 + z1524;
    const Scalar z1544 = z1079 - z1525;
    const Scalar z1545 = z1134 + z1532;
    const Scalar z1546 = z1406 * z1545 - z1534;
    const Scalar z1547 = z1407 * z1545 - z1538;
    const Scalar z1548 = z1390 * z1537 - z1536 - z1542;
    const Scalar z1549 = z1417 * z1523 - z1531;
    const Scalar z1550 = z1395 * z1545 - z1546 - z1540 - z1390 * z1547;
    const Scalar z1551 = z1417 * z1548 + z1544;
    const Scalar z1552 = z1426 * z1549;
    const Scalar z1553 = z1426 * z1551;
    const Scalar z1554 = z1426 * z1528;
    const Scalar z1555 = z1390 * z1552 + z1523;
    const Scalar z1556 = z1390 * z1554 + z1507;
    const Scalar z1557 = z1390 * z1553 + z1548;
    const Scalar z1558 = z1405 * z1555;
    const Scalar z1559 = z1405 * z1556;
    const Scalar z1560 = z1405 * z1557;
    const Scalar z1561 = z1411 * z1545 + z1543 + z1417 * z1550;
    const Scalar z1562 = z178 * z1558 - z1512;
    const Scalar z1563 = z178 * z1559 + z1501;
    const Scalar z1564 = z178 * z1560 + z1536;
    const Scalar z1565 = z1426 * z1561;
    const Scalar z1566 = z1484 - z1554 + z182 * z1559;
    const Scalar z1567 = z182 * z1558 - z1518 - z1552;
    const Scalar z1568 = z1390 * z1565 + z1550;
    const Scalar z1569 = z182 * z1560 - z1537 - z1553;
    const Scalar z1570 = z1389 * z1566;
    const Scalar z1571 = z1406 * z1533 + z1511;
    const Scalar z1572 = z1407 * z1533 - z1539;
    const Scalar z1573 = z1395 * z1533 - z1571 - z1541 - z1390 * z1572;
    const Scalar z1574 = z1391 * z1545;
    const Scalar z1575 = z1405 * z1568;
    const Scalar z1576 = z178 * z1575 + z1546;
    const Scalar z1577 = z1547 - z1565 + z182 * z1575;
    const Scalar z1578 = z1389 * z1567;
    const Scalar z1579 = z432 + z98 * z433 - z398 * z1393 + z422 * z1440 + z431 * z1452 - z423 * z1456;
    const Scalar z1580 = z995 - z996;
    const Scalar z1581 = z1010 + z1406 * z1580;
    const Scalar z1582 = z1008 - z1407 * z1580;
    const Scalar z1583 = z433 - z533 * z1394;
    const Scalar z1584 = z1411 * z1533 + z1530 + z1417 * z1573;
    const Scalar z1585 = z1395 * z1580 - z1581 + z1012 + z1390 * z1582;
    const Scalar z1586 = z1426 * z1584;
    const Scalar z1587 = z1391 * z1533;
    const Scalar z1588 = z1390 * z1586 + z1573;
    const Scalar z1589 = z507 + z98 * z511 + z529 * z1393 - z557 * z1440 - z560 * z1452 - z558 * z1456 + z457 * z1459;
    const Scalar z1590 = z1043 - z1411 * z1580 - z1417 * z1585;
    const Scalar z1591 = z1391 * z1580;
    const Scalar z1592 = z511 + n94 * z98 + z533 * z1393;
    const Scalar z1593 = z529 + z98 * z533 + z478 * z1393 + z535 * z1440 - z539 * z1452 + z528 * z1456 + z412 * z1459;
    const Scalar z1594 = z1426 * z1590;
    const Scalar z1595 = z1390 * z1594 - z1585;
    const Scalar z1596 = z535 * z1434 - z398 - z478 * z1394 - z539 * z1439 + z528 * z1443 + z412 * z1454;
    const Scalar z1597 = z6 + z398 * z1394 + z422 * z1434 + z431 * z1439 - z423 * z1443;
    const Scalar z1598 = z423 + z528 * z1394 + z525 * z1439 - n94 * z1443;
    const Scalar z1599 = z422 - z535 * z1394 + n94 * z1434 - z519 * z1439;
    const Scalar z1600 = z535 * z1393 - z557 + n94 * z1440 - z519 * z1452;
    const Scalar z1601 = z519 * z1434 - z431 - z539 * z1394 - z527 * z1439 + z525 * z1443 + z424 * z1454;
    const Scalar z1602 = z528 * z1393 - z558 - z525 * z1452 + n94 * z1456;
    const Scalar z1603 = n0_12 - z535 * z1433 - z539 * z1461 + z528 * z1467 + z412 * z1469;
    const Scalar z1604 = z560 + z539 * z1393 + z519 * z1440 - z527 * z1452 + z525 * z1456 + z424 * z1459;
    const Scalar z1605 = z516 - z519 * z1433 - z527 * z1461 + z525 * z1467 + z424 * z1469;
    const Scalar z1606 = n94 * z1433 + z519 * z1461;
    const Scalar z1607 = z525 * z1461 - n94 * z1467;
    const Scalar z1608 = z412 * z1393 + z457 - z424 * z1452 + n0_28 * z1459;
    const Scalar z1609 = z412 * z1394 + z424 * z1439 - n0_28 * z1454;
    const Scalar z1610 = z424 * z1461 - n0_28 * z1469;
    const Scalar z1611 = z1405 * z1588;
    const Scalar z1612 = z1405 * z1595;
    const Scalar z1613 = z98 * z1592 + z1440 * z1600 + z1456 * z1602 + z1459 * z1608 + z1393 * z1593 - z1452 * z1604
        + z1589;
    const Scalar z1614 = z178 * z1611 + z1571;
    const Scalar z1615 = z1572 - z1586 + z182 * z1611;
    const Scalar z1616 = z1389 * z1569;
    const Scalar z1617 = z1443 * z1598 - z1597 - z1434 * z1599 + z1454 * z1609 + z1394 * z1596 + z1439 * z1601;
    const Scalar z1618 = z1394 * z1593 - z1579 - z1434 * z1600 - z1443 * z1602 - z1454 * z1608 + z1439 * z1604;
    const Scalar z1619 = z1389 * z1577;
    const Scalar z1620 = z644 + z736 * z1393;
    const Scalar z1621 = z736 * z1394 + z819;
    const Scalar z1622 = z738 * z1393 - z682 + z686 * z1452;
    const Scalar z1623 = z737 * z1394 - z825 + z684 * z1439;
    const Scalar z1624 = z686 * z1439 - z826 - z738 * z1394;
    const Scalar z1625 = z683 - z737 * z1393 + z684 * z1452;
    const Scalar z1626 = z1389 * z1615;
    const Scalar z1627 = z665 * z1461 - z744 + z822 * z1469;
    const Scalar z1628 = z727 * z1393 - z733 - z734 * z1452 + z816 * z1459;
    const Scalar z1629 = z662 - z657 * z1393 + z691 * z1452 + z805 * z1459;
    const Scalar z1630 = z657 * z1394 - z772 + z691 * z1439 + z805 * z1454;
    const Scalar z1631 = z666 - z748 * z1393 + z681 * z1452 + z824 * z1459;
    const Scalar z1632 = z748 * z1394 - z829 + z681 * z1439 + z824 * z1454;
    const Scalar z1633 = z747 * z1393 - z701 + z665 * z1452 + z822 * z1459;
    const Scalar z1634 = z828 - z747 * z1394 + z665 * z1439 + z822 * z1454;
    const Scalar z1635 = z178 * z1612 - z1581;
    const Scalar z1636 = z1582 - z1594 + z182 * z1612;
    const Scalar z1637 = z1389 * z1636;
    const Scalar z1638 = z815 - z806 * z1394 - z824 * z1439;
    const Scalar z1639 = z98 * z1621 - z1456 * z1623 - z1459 * z1638 + z1440 * z1624 - z1393 * z1630 + z1452 * z1632
        + z1634;
    const Scalar z1640 = z778 - z750 * z1452;
    const Scalar z1641 = z806 * z1393 + z823 - z824 * z1452;
    const Scalar z1642 = z98 * z1620 - z1440 * z1622 + z1456 * z1625 + z1459 * z1641 + z1393 * z1629 - z1452 * z1631
        - z1633;
    const Scalar z1643 = n0_12 - z516 * z1461;
    const Scalar z1644 = z1433 * z1606 + z1643 - z1467 * z1607 - z1469 * z1610 - z1461 * z1605;
    const Scalar z1645 = n0_12 * z1394 + z516 * z1439;
    const Scalar z1646 = z516 * z1452 - n0_12 * z1393;
    const Scalar z1647 = z1434 * z1622 - z1628 - z1443 * z1625 - z1454 * z1641 + z1394 * z1629 + z1439 * z1631;
    const Scalar z1648 = z1640 + z1433 * z1622 + z1467 * z1625 + z1469 * z1641 - z1461 * z1631;
    const Scalar z1649 = z1433 * z1599 + z1645 + z1467 * z1598 + z1469 * z1609 + z1461 * z1601;
    const Scalar z1650 = z1433 * z1600 + z1646 - z1467 * z1602 - z1469 * z1608 + z1461 * z1604;
    const Scalar z1651 = z686 * z1461;
    const Scalar z1652 = z684 * z1461;
    const Scalar z1653 = z727 * z1394 + z734 * z1439 - z816 * z1454;
    const Scalar z1654 = z1653 + z1434 * z1624 - z1443 * z1623 - z1454 * z1638 + z1394 * z1630 + z1439 * z1632;
    const Scalar z1655 = z734 * z1461 - z816 * z1469;
    const Scalar z1656 = z750 * z1439;
    const Scalar z1657 = z1467 * z1623 - z1656 + z1469 * z1638 + z1433 * z1624 - z1461 * z1632;
    const Scalar z1658 = z750 * z1461;
    const Scalar z1659 = z824 * z1461;
    const Scalar z1660 = z691 * z1461 + z805 * z1469;
    const Scalar z1661 = z681 * z1461 + z750 + z824 * z1469;
    const Scalar z1662 = z1456 * z1652 - z1627 - z1440 * z1651 - z1459 * z1659 + z1393 * z1660 - z1452 * z1661;
    const Scalar z1663 = z1655 + z1434 * z1651 - z1443 * z1652 + z1454 * z1659 + z1394 * z1660 + z1439 * z1661;
    const Scalar z1664 = z1433 * z1651 - z1658 + z1467 * z1652 - z1469 * z1659 - z1461 * z1661;
    const Scalar z1665 = z1128 * z1592 + z1491 * z1593 - z1492 * z1600 + z1508 * z1604 - z1509 * z1602 - z1514 * z1608;
    const Scalar z1666 = z1665 + z1642;
    const Scalar z1667 = z1128 * z1583 + z1491 * z1596 - z1492 * z1599 + z1508 * z1601 + z1509 * z1598 + z1514 * z1609;
    const Scalar z1668 = z1491 * z1603 + z1492 * z1606 + z1508 * z1605 + z1509 * z1607 + z1514 * z1610;
    const Scalar z1669 = z1667 - z1647;
    const Scalar z1670 = z1668 + z1648;
    const Scalar z1671 = z1554 * z1600 - z1529 * z1593 - z1559 * z1604 + z1563 * z1602 + z1570 * z1608;
    const Scalar z1672 = z1671 - z1639;
    const Scalar z1673 = z1552 * z1600 - z1558 * z1604 + z1562 * z1602 + z1578 * z1608;
    const Scalar z1674 = z1673 + z1662;
    const Scalar z1675 = z686 * z1446;
    const Scalar z1676 = z686 * z1447 - z738 * z1465;
    const Scalar z1677 = z1554 * z1599 - z1529 * z1596 - z1559 * z1601 - z1563 * z1598 - z1570 * z1609;
    const Scalar z1678 = z1529 * z1603 + z1554 * z1606 + z1559 * z1605 + z1563 * z1607 + z1570 * z1610;
    const Scalar z1679 = z686 * z1496 - z738 * z1488;
    const Scalar z1680 = z1677 - z1654;
    const Scalar z1681 = z1678 - z1657;
    const Scalar z1682 = z1552 * z1599 - z1558 * z1601 - z1562 * z1598 - z1578 * z1609;
    const Scalar z1683 = z1552 * z1606 + z1558 * z1605 + z1562 * z1607 + z1578 * z1610;
    const Scalar z1684 = z704 - z1675;
    const Scalar z1685 = z1682 - z1663;
    const Scalar z1686 = z1683 - z1664;
    const Scalar z1687 = z674 - z680 * z1393;
    const Scalar z1688 = z680 * z1394 - z769;
    const Scalar z1689 = z689 - z693 * z1393;
    const Scalar z1690 = z693 * z1394 - z773;
    const Scalar z1691 = z917 - z974 * z1393;
    const Scalar z1692 = z974 * z1394 + z1063;
    const Scalar z1693 = z909 - z971 * z1393;
    const Scalar z1694 = z971 * z1394 + z1028;
    const Scalar z1695 = z690 + z694 * z1393;
    const Scalar z1696 = z694 * z1394 + z774;
    const Scalar z1697 = z1676 + z1695;
    const Scalar z1698 = z1679 + z1696;
    const Scalar z1699 = z918 - z977 * z1393;
    const Scalar z1700 = z977 * z1394 - z1036;
    const Scalar z1701 = z860 - z915 * z1393;
    const Scalar z1702 = z915 * z1394 - z976;
    const Scalar z1703 = z919 + z979 * z1393;
    const Scalar z1704 = z979 * z1394 + z1040;
    const Scalar z1705 = z736 * z1465;
    const Scalar z1706 = z1705 + z1687;
    const Scalar z1707 = z736 * z1488;
    const Scalar z1708 = z1707 - z1688;
    const Scalar z1709 = z737 * z1465 + z684 * z1447;
    const Scalar z1710 = z1709 + z1689;
    const Scalar z1711 = z737 * z1488 + z684 * z1496;
    const Scalar z1712 = z1711 - z1690;
    const Scalar z1713 = z684 * z1446;
    const Scalar z1714 = z705 + z1713;
    const Scalar z1715 = z665 * z1446 + z822 * z1455;
    const Scalar z1716 = z691 * z1446 + z805 * z1455;
    const Scalar z1717 = z734 * z1446 - z816 * z1455;
    const Scalar z1718 = z681 * z1446 + z824 * z1455;
    const Scalar z1719 = z864 + z1718;
    const Scalar z1720 = z727 * z1465 + z734 * z1447 - z816 * z1458;
    const Scalar z1721 = z727 * z1488 + z734 * z1496 - z816 * z1502;
    const Scalar z1722 = z806 * z1465 + z824 * z1447;
    const Scalar z1723 = z806 * z1488 + z824 * z1496;
    const Scalar z1724 = z750 * z1446;
    const Scalar z1725 = z824 * z1446;
    const Scalar z1726 = z750 * z1447;
    const Scalar z1727 = z750 * z1496;
    const Scalar z1728 = z657 * z1465 + z691 * z1447 + z805 * z1458;
    const Scalar z1729 = z657 * z1488 + z691 * z1496 + z805 * z1502;
    const Scalar z1730 = z681 * z1447 + z748 * z1465 + z824 * z1458;
    const Scalar z1731 = z681 * z1496 + z748 * z1488 + z824 * z1502;
    const Scalar z1732 = z665 * z1447 - z747 * z1465 + z822 * z1458;
    const Scalar z1733 = z665 * z1496 - z747 * z1488 + z822 * z1502;
    const Scalar z1734 = z1553 * z1600 - z1560 * z1604 + z1564 * z1602 + z1616 * z1608;
    const Scalar z1735 = z1730 + z1701;
    const Scalar z1736 = z1134 * z1592 + z1574 * z1593 - z1565 * z1600 + z1575 * z1604 - z1576 * z1602 - z1619 * z1608;
    const Scalar z1737 = z1731 - z1702;
    const Scalar z1738 = z1134 * z1583 + z1574 * z1596 - z1565 * z1599 + z1575 * z1601 + z1576 * z1598 + z1619 * z1609;
    const Scalar z1739 = z1574 * z1603 + z1565 * z1606 + z1575 * z1605 + z1576 * z1607 + z1619 * z1610;
    const Scalar z1740 = z1586 * z1600 - z1587 * z1593 - z1611 * z1604 + z1614 * z1602 + z1626 * z1608;
    const Scalar z1741 = z851 + z1715;
    const Scalar z1742 = z1553 * z1599 - z1560 * z1601 - z1564 * z1598 - z1616 * z1609;
    const Scalar z1743 = z1553 * z1606 + z1560 * z1605 + z1564 * z1607 + z1616 * z1610;
    const Scalar z1744 = z1732 + z1703;
    const Scalar z1745 = z1733 + z1704;
    const Scalar z1746 = z1586 * z1599 - z1587 * z1596 - z1611 * z1601 - z1614 * z1598 - z1626 * z1609;
    const Scalar z1747 = z1587 * z1603 + z1586 * z1606 + z1611 * z1605 + z1614 * z1607 + z1626 * z1610;
    const Scalar z1748 = z995 * z1592 + z1594 * z1600 + z1635 * z1602 + z1637 * z1608 - z1612 * z1604 + z1591 * z1593;
    const Scalar z1749 = z995 * z1583 + z1594 * z1599 - z1635 * z1598 - z1637 * z1609 - z1612 * z1601 + z1591 * z1596;
    const Scalar z1750 = z1594 * z1606 + z1635 * z1607 + z1637 * z1610 + z1612 * z1605 - z1591 * z1603;
    const Scalar z1751 = l_lambda_rear_rolls_x * z180 + l_lambda_rear_rolls_y * z178 + l_lambda_front_rolls_x * z182
        + l_lambda_front_rolls_y * z181 - z1037;
    const Scalar z1752 = l_lambda_rear_rolls_x * z215 - z1004 + l_lambda_rear_rolls_y * z209 + l_lambda_front_touches
        * z175 + l_lambda_front_rolls_x * z210 + l_lambda_front_rolls_y * z208;
    const Scalar z1753 = l_lambda_front_rolls_x * z238 - z366 + l_lambda_front_rolls_y * z247;
    const Scalar z1754 = z854 + z1716;
    const Scalar z1755 = z857 - z1717;
    const Scalar z1756 = z1720 + z1691;
    const Scalar z1757 = z1721 - z1692;
    const Scalar z1758 = z1722 + z1693;
    const Scalar z1759 = z1723 - z1694;
    const Scalar z1760 = z855 - z1724;
    const Scalar z1761 = z912 - z1726;
    const Scalar z1762 = z861 - z1725;
    const Scalar z1763 = z1728 + z1699;
    const Scalar z1764 = z1729 - z1700;
    const Scalar z1765 = z98 * z1706 - z1456 * z1710 + z1459 * z1758 + z1440 * z1697 - z1393 * z1763 + z1452 * z1735
        + z1744;
    const Scalar z1766 = z98 * z1708 - z1456 * z1712 + z1459 * z1759 + z1440 * z1698 - z1393 * z1764 + z1452 * z1737
        + z1745;
    const Scalar z1767 = z1756 + z1454 * z1758 - z1443 * z1710 + z1434 * z1697 + z1394 * z1763 + z1439 * z1735;
    const Scalar z1768 = z1761 + z1467 * z1710 - z1469 * z1758 + z1433 * z1697 - z1461 * z1735;
    const Scalar z1769 = z1757 + z1454 * z1759 - z1443 * z1712 + z1434 * z1698 + z1394 * z1764 + z1439 * z1737;
    const Scalar z1770 = z1467 * z1712 - z1727 - z1469 * z1759 + z1433 * z1698 - z1461 * z1737;
    const Scalar z1771 = z1736 + z1765;
    const Scalar z1772 = z1740 - z1766;
    const Scalar z1773 = z1738 + z1767;
    const Scalar z1774 = z1746 - z1769;
    const Scalar z1775 = z1739 - z1768;
    const Scalar z1776 = z1747 - z1770;
    const Scalar z1777 = n1 / z1644;
    const Scalar z1778 = l_lambda_rear_touches + l_lambda_front_touches - z472;
    const Scalar z1779 = z1440 * z1684 - z1741 + z1456 * z1714 + z1459 * z1762 + z1393 * z1754 - z1452 * z1719;
    const Scalar z1780 = z1394 * z1754 - z1755 - z1434 * z1684 - z1443 * z1714 - z1454 * z1762 + z1439 * z1719;
    const Scalar z1781 = z1433 * z1684 - z1760 - z1467 * z1714 - z1469 * z1762 + z1461 * z1719;
    const Scalar z1782 = z1734 + z1779;
    const Scalar z1783 = z1742 - z1780;
    const Scalar z1784 = z1743 + z1781;
    const Scalar z1785 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z477;
    const Scalar z1786 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y + z479;
    const Scalar z1787 = z1031 + l_lambda_rear_rolls_x * z212 + l_lambda_rear_rolls_y * z217 + l_lambda_front_touches
        * z177 + l_lambda_front_rolls_x * z186 + l_lambda_front_rolls_y * z198 - z98 * (l_lambda_rear_touches - z1778)
        - z1393 * z1752 - z1440 * z1785 + z1452 * z1751 - z1456 * z1786 - z1459 * z1753;
    const Scalar z1788 = z1007 + l_lambda_front_touches * z190 + l_lambda_front_rolls_x * z241 + l_lambda_front_rolls_y
        * z242 - z1394 * z1752 + z1434 * z1785 - z1439 * z1751 + z1443 * z1786 + z1454 * z1753;
    const Scalar z1789 = l_lambda_rear_rolls_x * z215 - z361 + l_lambda_rear_rolls_y * z209 - z1433 * z1785 - z1461
        * z1751 + z1467 * z1786 + z1469 * z1753;
    const Scalar z1790 = z1787 - z1748;
    const Scalar z1791 = z1788 + z1749;
    const Scalar z1792 = z1789 - z1750;
    const Scalar z1793 = z1649 * z1777;
    const Scalar z1794 = z1617 + z1649 * z1793;
    const Scalar z1795 = z1618 + z1650 * z1793;
    const Scalar z1796 = z1669 + z1670 * z1793;
    const Scalar z1797 = z1680 - z1681 * z1793;
    const Scalar z1798 = n1 / z1794;
    const Scalar z1799 = z1783 - z1784 * z1793;
    const Scalar z1800 = z1685 - z1686 * z1793;
    const Scalar z1801 = z1773 + z1775 * z1793;
    const Scalar z1802 = z1774 - z1776 * z1793;
    const Scalar z1803 = z1650 * z1777;
    const Scalar z1804 = z1613 - z1650 * z1803;
    const Scalar z1805 = z1795 * z1798;
    const Scalar z1806 = z1804 + z1795 * z1805;
    const Scalar z1807 = z1666 + z1670 * z1803 - z1805 * z1796;
    const Scalar z1808 = z1672 - z1681 * z1803 - z1805 * z1797;
    const Scalar z1809 = z1782 - z1784 * z1803 - z1805 * z1799;
    const Scalar z1810 = z1674 - z1686 * z1803 - z1805 * z1800;
    const Scalar z1811 = z1771 + z1775 * z1803 - z1805 * z1801;
    const Scalar z1812 = z1772 - z1776 * z1803 - z1805 * z1802;
    const Scalar z1813 = n1 / z1806;
    const Scalar z1814 = z1813 * z1807;
    const Scalar z1815 = z1813 * z1808;
    const Scalar z1816 = z1813 * z1809;
    const Scalar z1817 = z1813 * z1810;
    const Scalar z1818 = z1813 * z1811;
    const Scalar z1819 = z1813 * z1812;
    const Scalar z1820 = z1798 * z1796 + z1805 * z1814;
    const Scalar z1821 = z1798 * z1797 + z1805 * z1815;
    const Scalar z1822 = z1798 * z1799 + z1805 * z1816;
    const Scalar z1823 = z1798 * z1800 + z1805 * z1817;
    const Scalar z1824 = z1798 * z1801 + z1805 * z1818;
    const Scalar z1825 = z1798 * z1802 + z1805 * z1819;
    const Scalar z1826 = z1670 * z1777 + z1803 * z1814 - z1793 * z1820;
    const Scalar z1827 = z1681 * z1777 - z1803 * z1815 + z1793 * z1821;
    const Scalar z1828 = z1784 * z1777 - z1803 * z1816 + z1793 * z1822;
    const Scalar z1829 = z1686 * z1777 - z1803 * z1817 + z1793 * z1823;
    const Scalar z1830 = z1775 * z1777 + z1803 * z1818 - z1793 * z1824;
    const Scalar z1831 = z1776 * z1777 - z1803 * z1819 + z1793 * z1825;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z519;
    result.M[4] = -z557;
    result.M[5] = z535;
    result.M[6] = z422;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z525;
    result.M[13] = z558;
    result.M[14] = -z528;
    result.M[15] = z423;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z511;
    result.M[23] = z533;
    result.M[24] = z433;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z519;
    result.M[28] = -z525;
    result.M[29] = n0;
    result.M[30] = z527;
    result.M[31] = z560;
    result.M[32] = z539;
    result.M[33] = -z431;
    result.M[34] = z516;
    result.M[35] = z424;
    result.M[36] = -z557;
    result.M[37] = z558;
    result.M[38] = z511;
    result.M[39] = z560;
    result.M[40] = z507;
    result.M[41] = z529;
    result.M[42] = z432;
    result.M[43] = n0;
    result.M[44] = z457;
    result.M[45] = z535;
    result.M[46] = -z528;
    result.M[47] = z533;
    result.M[48] = z539;
    result.M[49] = z529;
    result.M[50] = z478;
    result.M[51] = -z398;
    result.M[52] = n0_12;
    result.M[53] = z412;
    result.M[54] = z422;
    result.M[55] = z423;
    result.M[56] = z433;
    result.M[57] = -z431;
    result.M[58] = z432;
    result.M[59] = -z398;
    result.M[60] = z6;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z516;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z424;
    result.M[76] = z457;
    result.M[77] = z412;
    result.M[78] = n0;
    result.M[79] = n0;
    result.M[80] = n0_28;
    result.C[0] = n0;
    result.C[1] = n0;
    result.C[2] = n0;
    result.C[3] = n0;
    result.C[4] = n0;
    result.C[5] = n0;
    result.C[6] = n0;
    result.C[7] = n0;
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
    result.C[25] = n0;
    result.C[26] = n0;
    result.C[27] = z686;
    result.C[28] = z684;
    result.C[29] = n0;
    result.C[30] = -z681;
    result.C[31] = z665;
    result.C[32] = -z691;
    result.C[33] = z734;
    result.C[34] = z750;
    result.C[35] = z824;
    result.C[36] = z682;
    result.C[37] = -z683;
    result.C[38] = z644;
    result.C[39] = z666;
    result.C[40] = z701;
    result.C[41] = z662;
    result.C[42] = -z733;
    result.C[43] = z778;
    result.C[44] = z823;
    result.C[45] = -z738;
    result.C[46] = z737;
    result.C[47] = z736;
    result.C[48] = -z748;
    result.C[49] = -z747;
    result.C[50] = -z657;
    result.C[51] = z727;
    result.C[52] = n0;
    result.C[53] = z806;
    result.C[54] = z826;
    result.C[55] = z825;
    result.C[56] = -z819;
    result.C[57] = -z829;
    result.C[58] = -z828;
    result.C[59] = -z772;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = z815;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z750;
    result.C[67] = z744;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = z824;
    result.C[76] = -z822;
    result.C[77] = z805;
    result.C[78] = z816;
    result.C[79] = n0;
    result.C[80] = n0;
    result.K[0] = n0;
    result.K[1] = n0;
    result.K[2] = n0;
    result.K[3] = n0;
    result.K[4] = n0;
    result.K[5] = n0;
    result.K[6] = n0;
    result.K[7] = n0;
    result.K[8] = n0;
    result.K[9] = n0;
    result.K[10] = n0;
    result.K[11] = n0;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = n0;
    result.K[17] = n0;
    result.K[18] = n0;
    result.K[19] = n0;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.K[25] = n0;
    result.K[26] = n0;
    result.K[27] = z704;
    result.K[28] = -z705;
    result.K[29] = n0;
    result.K[30] = z864;
    result.K[31] = -z851;
    result.K[32] = z854;
    result.K[33] = z857;
    result.K[34] = z855;
    result.K[35] = z861;
    result.K[36] = z690;
    result.K[37] = z689;
    result.K[38] = z674;
    result.K[39] = -z860;
    result.K[40] = z919;
    result.K[41] = -z918;
    result.K[42] = z917;
    result.K[43] = -z912;
    result.K[44] = z909;
    result.K[45] = z694;
    result.K[46] = -z693;
    result.K[47] = -z680;
    result.K[48] = z915;
    result.K[49] = z979;
    result.K[50] = z977;
    result.K[51] = -z974;
    result.K[52] = n0;
    result.K[53] = -z971;
    result.K[54] = -z774;
    result.K[55] = -z773;
    result.K[56] = -z769;
    result.K[57] = z976;
    result.K[58] = -z1040;
    result.K[59] = z1036;
    result.K[60] = z1063;
    result.K[61] = n0;
    result.K[62] = z1028;
    result.K[63] = n0;
    result.K[64] = n0;
    result.K[65] = n0;
    result.K[66] = n0;
    result.K[67] = n0;
    result.K[68] = n0;
    result.K[69] = n0;
    result.K[70] = n0;
    result.K[71] = n0;
    result.K[72] = n0;
    result.K[73] = n0;
    result.K[74] = n0;
    result.K[75] = n0;
    result.K[76] = n0;
    result.K[77] = n0;
    result.K[78] = n0;
    result.K[79] = n0;
    result.K[80] = n0;
    result.F[0] = l_lambda_rear_rolls_x + l_lambda_front_rolls_x - z477;
    result.F[1] = -l_lambda_rear_rolls_y - l_lambda_front_rolls_y - z479;
    result.F[2] = -l_lambda_rear_touches - l_lambda_front_touches + z472;
    result.F[3] = l_lambda_rear_rolls_x * z180 + l_lambda_rear_rolls_y * z178 + l_lambda_front_rolls_x * z182
        + l_lambda_front_rolls_y * z181 - z1037;
    result.F[4] = -l_lambda_rear_rolls_x * z212 + l_lambda_rear_touches * z98 - l_lambda_rear_rolls_y * z217
        - l_lambda_front_touches * z177 - l_lambda_front_rolls_x * z186 - l_lambda_front_rolls_y * z198 - z1031;
    result.F[5] = l_lambda_rear_rolls_x * z215 - z1004 + l_lambda_rear_rolls_y * z209 + l_lambda_front_touches * z175
        + l_lambda_front_rolls_x * z210 + l_lambda_front_rolls_y * z208;
    result.F[6] = z1007 + l_lambda_front_touches * z190 + l_lambda_front_rolls_x * z241 + l_lambda_front_rolls_y * z242;
    result.F[7] = l_lambda_rear_rolls_x * z215 - z361 + l_lambda_rear_rolls_y * z209;
    result.F[8] = l_lambda_front_rolls_x * z238 - z366 + l_lambda_front_rolls_y * z247;
    result.M_r[0] = z1613;
    result.M_r[1] = -z1618;
    result.M_r[2] = -z1650;
    result.M_r[3] = -z1618;
    result.M_r[4] = -z1617;
    result.M_r[5] = -z1649;
    result.M_r[6] = -z1650;
    result.M_r[7] = -z1649;
    result.M_r[8] = z1644;
    result.C_r[0] = z1666;
    result.C_r[1] = z1669;
    result.C_r[2] = z1670;
    result.C_r[3] = z1672;
    result.C_r[4] = z1680;
    result.C_r[5] = -z1681;
    result.C_r[6] = z1674;
    result.C_r[7] = z1685;
    result.C_r[8] = -z1686;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z1782;
    result.K_r[7] = z1783;
    result.K_r[8] = -z1784;
    result.K_r[9] = z1771;
    result.K_r[10] = z1773;
    result.K_r[11] = z1775;
    result.K_r[12] = z1772;
    result.K_r[13] = z1774;
    result.K_r[14] = -z1776;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = -z1790;
    result.F_r[1] = z1791;
    result.F_r[2] = z1792;
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
    result.A[13] = n0;
    result.A[14] = n0;
    result.A[15] = n0;
    result.A[16] = n0;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = n0;
    result.A[20] = z1437;
    result.A[21] = -z1450;
    result.A[22] = -z1446;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z1455;
    result.A[27] = -z1816;
    result.A[28] = z1822;
    result.A[29] = z1828;
    result.A[30] = -z1438;
    result.A[31] = z1451;
    result.A[32] = z1447;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z1458;
    result.A[37] = -z1818;
    result.A[38] = z1824;
    result.A[39] = -z1830;
    result.A[40] = z1487;
    result.A[41] = -z1500;
    result.A[42] = -z1496;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z1502;
    result.A[47] = -z1819;
    result.A[48] = z1825;
    result.A[49] = z1831;
    result.A[50] = n0;
    result.A[51] = n0;
    result.A[52] = n0;
    result.A[53] = n0;
    result.A[54] = n0;
    result.A[55] = n0;
    result.A[56] = n0;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = n0;
    result.A[60] = n0;
    result.A[61] = n0;
    result.A[62] = n0;
    result.A[63] = n0;
    result.A[64] = n0;
    result.A[65] = n0;
    result.A[66] = n0;
    result.A[67] = n0;
    result.A[68] = n0;
    result.A[69] = n0;
    result.A[70] = z1440;
    result.A[71] = -z1456;
    result.A[72] = -z1452;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z1814;
    result.A[78] = z1820;
    result.A[79] = -z1826;
    result.A[80] = z1434;
    result.A[81] = -z1443;
    result.A[82] = -z1439;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z1454;
    result.A[87] = -z1815;
    result.A[88] = z1821;
    result.A[89] = z1827;
    result.A[90] = -z1433;
    result.A[91] = -z1467;
    result.A[92] = -z1461;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z1469;
    result.A[97] = -z1817;
    result.A[98] = z1823;
    result.A[99] = z1829;
    if (!(traits::regular(z1419, z1432) && traits::regular(z1430, z1444) && traits::regular(z1404, z1463)
        && traits::regular(z1425, z1471) && traits::regular(z1806, z1613) && traits::regular(-z1794, -z1617)
        && traits::regular(z1644, z1644))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((((n0 * result.M[3] * result.M[4] * result.M[5] * result.M[6] * result.M[12] * result.M[13]
        * result.M[14] * result.M[15] * result.M[22] * result.M[23] * result.M[24] * result.M[27]) * (n0 * result.M[28]
        * result.M[30] * result.M[31] * result.M[32] * result.M[33] * result.M[34] * result.M[35] * result.M[36]
        * result.M[37] * result.M[38] * result.M[39] * result.M[40])) * ((n0 * result.M[41] * result.M[42]
        * result.M[44] * result.M[45] * result.M[46] * result.M[47] * result.M[48] * result.M[49] * result.M[50]
        * result.M[51] * result.M[53] * result.M[54]) * (n0 * result.M[55] * result.M[56] * result.M[57] * result.M[58]
        * result.M[59] * result.M[60] * result.M[66] * result.M[75] * result.M[76] * result.M[77] * result.C[27]
        * result.C[28] * result.C[30]))) * (((n0 * result.C[31] * result.C[32] * result.C[33] * result.C[34]
        * result.C[35] * result.C[36] * result.C[37] * result.C[38] * result.C[39] * result.C[40] * result.C[41]
        * result.C[42]) * (n0 * result.C[43] * result.C[44] * result.C[45] * result.C[46] * result.C[47] * result.C[48]
        * result.C[49] * result.C[50] * result.C[51] * result.C[53] * result.C[54] * result.C[55])) * ((n0
        * result.C[56] * result.C[57] * result.C[58] * result.C[59] * result.C[62] * result.C[66] * result.C[67]
        * result.C[75] * result.C[76] * result.C[77] * result.C[78] * result.K[27]) * (n0 * result.K[28] * result.K[30]
        * result.K[31] * result.K[32] * result.K[33] * result.K[34] * result.K[35] * result.K[36] * result.K[37]
        * result.K[38] * result.K[39] * result.K[40] * result.K[41])))) * ((((n0 * result.K[42] * result.K[43]
        * result.K[44] * result.K[45] * result.K[46] * result.K[47] * result.K[48] * result.K[49] * result.K[50]
        * result.K[51] * result.K[53] * result.K[54]) * (n0 * result.K[55] * result.K[56] * result.K[57] * result.K[58]
        * result.K[59] * result.K[60] * result.K[62] * result.F[0] * result.F[1] * result.F[2] * result.F[3]
        * result.F[4])) * ((n0 * result.F[5] * result.F[6] * result.F[7] * result.F[8] * result.M_r[0] * result.M_r[1]
        * result.M_r[2] * result.M_r[3] * result.M_r[4] * result.M_r[5] * result.M_r[6] * result.M_r[7]) * (n0
        * result.M_r[8] * result.C_r[0] * result.C_r[1] * result.C_r[2] * result.C_r[3] * result.C_r[4] * result.C_r[5]
        * result.C_r[6] * result.C_r[7] * result.C_r[8] * result.K_r[6] * result.K_r[7] * result.K_r[8]))) * (((n0
        * result.K_r[9] * result.K_r[10] * result.K_r[11] * result.K_r[12] * result.K_r[13] * result.K_r[14]
        * result.F_r[0] * result.F_r[1] * result.F_r[2] * result.A[20] * result.A[21] * result.A[22]) * (n0
        * result.A[26] * result.A[27] * result.A[28] * result.A[29] * result.A[30] * result.A[31] * result.A[32]
        * result.A[36] * result.A[37] * result.A[38] * result.A[39] * result.A[40] * result.A[41])) * ((n0
        * result.A[42] * result.A[46] * result.A[47] * result.A[48] * result.A[49] * result.A[70] * result.A[71]
        * result.A[72] * result.A[77] * result.A[78] * result.A[79] * result.A[80]) * (n0 * result.A[81] * result.A[82]
        * result.A[86] * result.A[87] * result.A[88] * result.A[89] * result.A[90] * result.A[91] * result.A[92]
        * result.A[96] * result.A[97] * result.A[98] * result.A[99]))));
    if (!traits::regular(n1, zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, Linearisation& result) noexcept {
    return Mechanism::linearisation(precomputed, state, accelerations, multipliers, Inputs(), result);
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, std::array<Scalar, 81>&>(mass_matrix));
    visitor(Description::kernels[1],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[2], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[3], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[4], KernelFunction<void, Constraints&>(constraints));
    visitor(Description::kernels[5],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace whipple_bicycle
