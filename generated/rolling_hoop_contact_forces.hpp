// SPDX-License-Identifier: MIT-0
// rolling_hoop_contact_forces: Hoop rolling without slipping: six coordinates, the three contact forces
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: A, C
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                2                1          3             0                  0       0      6       -
//   kinematics               16               27          0             0                  3       0     49      49
//   mass_matrix               1                3          0             0                  1       0      6       7
//   bias                      4               15          0             0                  1       0     21      21
//   inverse_dynamics         22               33          0             0                  2       0     59      60
//   forward_dynamics         30               68          3             0                  2       0    105     109
//   energy                   14               28          0             0                  3       0     48      54
//   first_integrals          15               28          0             0                  3       0     49      55
//   constraints              11               16          0             0                  2       0     31      32
//   linearisation           231              342         13             0                  3       0    592     609
//
// Not computed because this mechanism does not need it:
//   kinematics: of 42 results 10 vanish identically, 2 repeat another up to sign
//   mass_matrix: of 36 results 28 vanish identically, 1 repeat another up to sign
//   bias: of 6 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 27 results 11 vanish identically, 3 repeat another up to sign
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 214 results 133 vanish identically, 5 repeat another up to sign
//
// To write this file again:
//   rolling_hoop_contact_forces_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation --support torsor_support.hpp --output rolling_hoop_contact_forces.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace rolling_hoop_contact_forces {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 6> coordinates{{{"x", "m"}, {"y", "m"}, {"z", "m"}, {"psi",
      "rad"}, {"theta", "rad"}, {"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 6> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"z", "m/s"},
      {"psi", "rad/s"}, {"theta", "rad/s"}, {"phi", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 3> multipliers{{{"X_F", "N"}, {"Y_F", "N"}, {"N", "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"A", "kg m^2"}, {"C", "kg m^2"}}};
  static constexpr std::array<torsor::ResultDescription, 29> results{{{"result", "hoop_position", 3, 1, 1, "m"},
      {"result", "hoop_rotation", 3, 3, 2, "1"}, {"result", "hoop_velocity", 3, 1, 1, "m/s"}, {"result",
      "hoop_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "I_position", 3, 1, 1, "m"}, {"result", "I_velocity", 3, 1,
      1, "m/s"}, {"result", "I_jacobian", 3, 6, 2, ""}, {"mass", "", 6, 6, 2, ""}, {"forces", "", 6, 1, 1,
      "0, 0, N, N m, N m, N m"}, {"forces", "", 6, 1, 1, "N, N, N, N m, N m, N m"}, {"accelerations", "", 6, 1, 1,
      "m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2"}, {"multipliers", "", 3, 1, 1, "N"}, {"result", "kinetic", 1, 1,
      0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "energy", 1, 1,
      0, "J"}, {"result", "value", 3, 1, 1, "m"}, {"result", "rate", 3, 1, 1, "m/s"}, {"result", "jacobian", 3, 6, 2,
      ""}, {"result", "gamma", 3, 1, 1, "m/s^2"}, {"result", "M", 6, 6, 2, ""}, {"result", "C", 6, 6, 2, "N m s"},
      {"result", "K", 6, 6, 2, ""}, {"result", "F", 6, 1, 1, "N, N, N, N m, N m, N m"}, {"result", "M_r", 3, 3, 2, ""},
      {"result", "C_r", 3, 3, 2, ""}, {"result", "K_r", 3, 5, 2, ""}, {"result", "F_r", 3, 1, 1, "N, N m, N m"},
      {"result", "A", 8, 8, 2, ""}}};
  static constexpr std::array<torsor::KernelDescription, 9> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 7}, {"mass_matrix", false, false, false, false, results.data() + 7, 1}, {"bias", false, false,
      false, false, results.data() + 8, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 9, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 10, 2}, {"energy", false, false, true, false,
      results.data() + 12, 3}, {"first_integrals", false, false, false, false, results.data() + 15, 1}, {"constraints",
      false, false, false, false, results.data() + 16, 4}, {"linearisation", true, true, true, true, results.data()
      + 20, 9}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::rolling_hoop_contact_forces::Description;

  static constexpr const char* name = "rolling_hoop_contact_forces";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0x8990a3de1527fa26ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 6;
  static constexpr int velocity_count = 6;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 3;
  static constexpr int first_integral_count = 1;

  /// Parameters that are set at run time.
  struct Parameters {
    Scalar A;  ///< parameter [kg m^2]
    Scalar C;  ///< parameter [kg m^2]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Parameters::*member_(int i_) noexcept {
      constexpr Scalar Parameters::*members_[] = {&Parameters::A, &Parameters::C};
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
  struct Multipliers {
    Scalar X_F;  ///< of the constraint along_x1 [N]
    Scalar Y_F;  ///< of the constraint along_y1 [N]
    Scalar N;  ///< of the constraint touching [N]
    static constexpr int size = 3;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::X_F, &Multipliers::Y_F, &Multipliers::N};
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
    Scalar m_8a68310a;
    Scalar m_be7541f9;
    Scalar m_aacf2d6b;
    Scalar m_d6343e7e;
    Scalar m_b4ea09ae;
    Scalar m_30f8c0dc;
  };

  /// Values of the scene.
  TORSOR_DEVICE static Parameters default_parameters() noexcept {
    Parameters parameters{};
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    parameters.A = n0_5;
    parameters.C = n1;
    return parameters;
  }

  /// To be called again when a parameter changes.
  TORSOR_DEVICE static Precomputed precompute(const Parameters& parameters) noexcept {
    Precomputed precomputed{};
    precomputed.parameters = parameters;
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar p_A = parameters.A;
    const Scalar p_C = parameters.C;
    const Scalar z0 = p_A - p_C;
    const Scalar z1 = n1 / p_C;
    const Scalar z2 = n1 / p_A;
    const Scalar z3 = n1 + z1;
    const Scalar z4 = n1 / z3;
    const Scalar z5 = n0_5 * p_C;
    precomputed.m_8a68310a = z0;
    precomputed.m_be7541f9 = z1;
    precomputed.m_aacf2d6b = z2;
    precomputed.m_d6343e7e = z3;
    precomputed.m_b4ea09ae = z4;
    precomputed.m_30f8c0dc = z5;
    return precomputed;
  }

  /// The state the scene starts from, for these parameters.
  TORSOR_DEVICE static State initial_state(const Parameters&) noexcept {
    State state{};
    const Scalar n1_2 = traits::constant(1.2, 1.2f, "6/5");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar z0 = n1_2;
    const Scalar z1 = traits::formula(0.36235775447667357, 0.36235777f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return cosine;
    });
    const Scalar z2 = traits::formula(0.9320390859672264, 0.9320391f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z0, sine, cosine);
      return sine;
    });
    state.time = n0;
    state.q.x = n0;
    state.q.y = z1;
    state.q.z = z2;
    state.q.psi = n0;
    state.q.theta = n1_2;
    state.q.phi = n0;
    state.v.x = n4 - n0_5 * z1;
    state.v.y = n0_3 * z2;
    state.v.z = -n0_3 * z1;
    state.v.psi = n0_5;
    state.v.theta = -n0_3;
    state.v.phi = -n4;
    return state;
  }
  TORSOR_DEVICE static State initial_state() noexcept { return initial_state(default_parameters()); }

  /// Poses, twists and named points in ground axes.
  struct Kinematics {
    std::array<Scalar, 3> hoop_position;  ///< centre of mass of hoop [m]
    std::array<Scalar, 9> hoop_rotation;  ///< from the axes of hoop to the ground's (3 x 3)
    std::array<Scalar, 3> hoop_velocity;  ///< velocity of the centre of mass of hoop [m/s]
    std::array<Scalar, 3> hoop_angular_velocity;  ///< angular velocity of hoop [rad/s]
    std::array<Scalar, 3> I_position;  ///< position of I [m]
    std::array<Scalar, 3> I_velocity;  ///< velocity of the material point at I [m/s]
    std::array<Scalar, 18> I_jacobian;  ///< partial velocities of I (3 x 6)
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
    std::array<Scalar, 3> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 3> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 18> jacobian;  ///< A, stored column by column (3 x 6)
    std::array<Scalar, 3> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 36> M;  ///< mass matrix (6 x 6)
    std::array<Scalar, 36> C;  ///< damping and gyroscopic terms (6 x 6)
    std::array<Scalar, 36> K;  ///< stiffness (6 x 6)
    std::array<Scalar, 6> F;  ///< right-hand side
    std::array<Scalar, 9> M_r;  ///< reduced mass matrix (3 x 3)
    std::array<Scalar, 9> C_r;  ///< reduced damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 15> K_r;  ///< reduced stiffness (3 x 5)
    std::array<Scalar, 3> F_r;  ///< reduced right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, w): x' = A x + B du (8 x 8)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 5;
  static constexpr int independent_coordinates[5] = {0, 1, 3, 4, 5};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[3] = {1, 3, 5};

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
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
    const Scalar z0 = v_psi * c_theta;
    const Scalar z1 = s_psi * c_theta;
    const Scalar z2 = s_psi * s_theta;
    const Scalar z3 = c_psi * c_theta;
    const Scalar z4 = c_psi * s_theta;
    const Scalar z5 = c_psi * v_theta;  // angular velocity of hoop.2, x
    const Scalar z6 = s_psi * v_theta;  // angular velocity of hoop.2, y
    const Scalar z7 = s_theta * s_phi;
    const Scalar z8 = s_theta * c_phi;
    const Scalar z9 = v_psi + c_theta * v_phi;  // angular velocity of hoop, z
    const Scalar z10 = v_z - v_theta * c_theta;
    const Scalar z11 = q_z - s_theta;
    const Scalar z12 = c_psi * c_phi - s_phi * z1;
    const Scalar z13 = c_psi * s_phi + c_phi * z1;
    const Scalar z14 = s_psi * c_phi + s_phi * z3;
    const Scalar z15 = s_psi * s_phi - c_phi * z3;
    const Scalar z16 = v_phi * z2 + z5;  // angular velocity of hoop, x
    const Scalar z17 = v_phi * z4 - z6;  // angular velocity of hoop, y
    const Scalar z18 = v_x + c_psi * z0 - v_theta * z2;
    const Scalar z19 = v_y + s_psi * z0 + v_theta * z4;
    const Scalar z20 = q_x + z1;
    const Scalar z21 = q_y - z3;
    const Scalar z22 = s_psi * z1 + c_psi * z3;
    result.hoop_position[0] = q_x;
    result.hoop_position[1] = q_y;
    result.hoop_position[2] = q_z;
    result.hoop_rotation[0] = z12;
    result.hoop_rotation[1] = z14;
    result.hoop_rotation[2] = z7;
    result.hoop_rotation[3] = -z13;
    result.hoop_rotation[4] = -z15;
    result.hoop_rotation[5] = z8;
    result.hoop_rotation[6] = z2;
    result.hoop_rotation[7] = -z4;
    result.hoop_rotation[8] = c_theta;
    result.hoop_velocity[0] = v_x;
    result.hoop_velocity[1] = v_y;
    result.hoop_velocity[2] = v_z;
    result.hoop_angular_velocity[0] = z16;
    result.hoop_angular_velocity[1] = -z17;
    result.hoop_angular_velocity[2] = z9;
    result.I_position[0] = z20;
    result.I_position[1] = z21;
    result.I_position[2] = z11;
    result.I_velocity[0] = z18;
    result.I_velocity[1] = z19;
    result.I_velocity[2] = z10;
    result.I_jacobian[0] = n1;
    result.I_jacobian[3] = n0;
    result.I_jacobian[6] = n0;
    result.I_jacobian[9] = z3;
    result.I_jacobian[12] = -z2;
    result.I_jacobian[15] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n1;
    result.I_jacobian[7] = n0;
    result.I_jacobian[10] = z1;
    result.I_jacobian[13] = z4;
    result.I_jacobian[16] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.I_jacobian[8] = n1;
    result.I_jacobian[11] = n0;
    result.I_jacobian[14] = -z22;
    result.I_jacobian[17] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 36>& mass) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar m0 = precomputed.m_8a68310a;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = c_theta * m0;
    const Scalar z1 = c_theta * p_C;
    const Scalar z2 = c_theta * z0 - p_A;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n0;
    mass[7] = n1;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = n0;
    mass[13] = n0;
    mass[14] = n1;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = -z2;
    mass[22] = n0;
    mass[23] = z1;
    mass[24] = n0;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = n0;
    mass[28] = p_A;
    mass[29] = n0;
    mass[30] = n0;
    mass[31] = n0;
    mass[32] = n0;
    mass[33] = z1;
    mass[34] = n0;
    mass[35] = p_C;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = v_psi * c_theta;
    const Scalar z1 = v_psi * s_theta;
    const Scalar z2 = v_theta * z0;  // angular acceleration of hoop.2, y
    const Scalar z3 = v_theta * z1;  // angular acceleration of hoop.2, z
    const Scalar z4 = v_phi + z0;  // angular velocity of hoop, z
    const Scalar z5 = z1 * z0;
    const Scalar z6 = z1 * z4;
    const Scalar z7 = v_theta * z4;
    const Scalar z8 = p_C * z3;  // moment on hoop, z
    const Scalar z9 = n2 * z2;
    const Scalar z10 = p_C * z6;  // moment on hoop, x
    const Scalar z11 = p_C * z7;  // moment on hoop, y
    const Scalar z12 = p_A * z5 - z10;  // moment on hoop.2, x
    const Scalar z13 = p_A * z9 - z11;  // moment on hoop.2, y
    const Scalar z14 = s_theta * z13 - c_theta * z8;
    forces.x = n0;
    forces.y = n0;
    forces.z = n9_81;
    forces.psi = z14;
    forces.theta = -z12;
    forces.phi = -z8;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar a_z = accelerations.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_X_F = multipliers.X_F;
    const Scalar l_Y_F = multipliers.Y_F;
    const Scalar l_N = multipliers.N;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = v_psi * s_theta;
    const Scalar z1 = v_psi * c_theta;
    const Scalar z2 = a_psi * c_theta;
    const Scalar z3 = a_psi * s_theta;
    const Scalar z4 = s_psi * c_theta;
    const Scalar z5 = c_psi * s_theta;
    const Scalar z6 = c_psi * c_theta;
    const Scalar z7 = s_psi * s_theta;
    const Scalar z8 = n9_81 + a_z;
    const Scalar z9 = v_theta * z1 + z3;  // angular acceleration of hoop.2, y
    const Scalar z10 = v_theta * z0 - z2;  // angular acceleration of hoop.2, z
    const Scalar z11 = v_phi + z1;  // angular velocity of hoop, z
    const Scalar z12 = z0 * z1;
    const Scalar z13 = v_theta * z1;
    const Scalar z14 = s_psi * z4 + c_psi * z6;
    const Scalar z15 = z4 * z5 - z6 * z7;
    const Scalar z16 = z0 * z11;
    const Scalar z17 = v_theta * z11;
    const Scalar z18 = a_phi - z10;  // angular acceleration of hoop, z
    const Scalar z19 = z9 + z13;
    const Scalar z20 = p_C * z16;  // moment on hoop, x
    const Scalar z21 = p_C * z17;  // moment on hoop, y
    const Scalar z22 = p_C * z18;  // moment on hoop, z
    const Scalar z23 = p_A * (a_theta - z12) + z20;  // moment on hoop.2, x
    const Scalar z24 = p_A * z19 - z21;  // moment on hoop.2, y
    const Scalar z25 = c_theta * z22 + s_theta * z24;
    forces.x = a_x + s_psi * l_Y_F - c_psi * l_X_F;
    forces.y = a_y - s_psi * l_X_F - c_psi * l_Y_F;
    forces.z = z8 - l_N;
    forces.psi = -c_theta * l_X_F + z25;
    forces.theta = -s_theta * l_Y_F + z23 + z14 * l_N;
    forces.phi = z22 - z15 * l_N - l_X_F;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar m0 = precomputed.m_8a68310a;
    const Scalar m1 = precomputed.m_be7541f9;
    const Scalar m2 = precomputed.m_aacf2d6b;
    const Scalar m3 = precomputed.m_d6343e7e;
    const Scalar m4 = precomputed.m_b4ea09ae;
    const Scalar angles_[] = {q_psi, q_theta};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar z0 = s_psi * c_theta;
    const Scalar z1 = c_psi * c_theta;
    const Scalar z2 = v_psi * c_theta;
    const Scalar z3 = s_theta * s_theta * p_A;
    const Scalar z4 = s_theta * m2;
    const Scalar z5 = v_psi * s_theta;
    const Scalar z6 = v_psi * c_psi;
    const Scalar z7 = v_psi * s_psi;
    const Scalar z8 = v_theta * s_theta;
    const Scalar z9 = v_theta * c_theta;
    const Scalar z10 = c_theta * p_C;
    const Scalar z11 = c_psi * s_theta;
    const Scalar z12 = s_psi * s_theta;
    const Scalar z13 = c_theta * m0;
    const Scalar z14 = v_x * z7 - v_y * z6 + v_psi * z8;
    const Scalar z15 = v_x * z6 + v_y * z7 - v_theta * z9;
    const Scalar z16 = v_theta * z8;
    const Scalar z17 = s_psi * z0 + c_psi * z1;
    const Scalar z18 = z0 * z11 - z1 * z12;
    const Scalar z19 = v_theta * z2;  // angular acceleration of hoop.2, y
    const Scalar z20 = v_theta * z5;  // angular acceleration of hoop.2, z
    const Scalar z21 = v_phi + z2;  // angular velocity of hoop, z
    const Scalar z22 = z5 * z2;
    const Scalar z23 = c_theta * z13 - p_A;
    const Scalar z24 = z10 * m1;
    const Scalar z25 = n1 + s_theta * z4;
    const Scalar z26 = c_theta * z4;
    const Scalar z27 = z5 * z21;
    const Scalar z28 = v_theta * z21;
    const Scalar z29 = p_C * z20;  // moment on hoop, z
    const Scalar z30 = n2 * z19;
    const Scalar z31 = n1 / z3;
    const Scalar z32 = p_C * z27;  // moment on hoop, x
    const Scalar z33 = p_C * z28;  // moment on hoop, y
    const Scalar z34 = z17 * m2;
    const Scalar z35 = z18 * m1;
    const Scalar z36 = p_A * z22 - z32;  // moment on hoop.2, x
    const Scalar z37 = p_A * z30 - z33;  // moment on hoop.2, y
    const Scalar z38 = n1 + c_theta * z34;
    const Scalar z39 = s_theta * z37;
    const Scalar z40 = z36 * m2;
    const Scalar z41 = n1 / z38;
    const Scalar z42 = m3 + z25 + z38;
    const Scalar z43 = z31 * z39;
    const Scalar z44 = s_theta * z40 - z15;
    const Scalar z45 = n9_81 - z16 + c_theta * z40;
    const Scalar z46 = z29 * m1 + z24 * z43;
    const Scalar z47 = c_theta * z43 + z14 - z46;
    const Scalar z48 = m4 * z47;
    const Scalar z49 = z26 * z41;
    const Scalar z50 = z25 - z26 * z49;
    const Scalar z51 = z49 * z45 - z44;
    const Scalar z52 = n1 / z50;
    const Scalar z53 = z52 * z51;
    const Scalar z54 = z41 * z45 + z49 * z53;
    const Scalar z55 = s_psi * z53 - c_psi * z48;
    const Scalar z56 = s_psi * z48 + c_psi * z53;
    const Scalar z57 = n9_81 - z54;
    const Scalar z58 = z40 + z4 * z53 - z34 * z54;
    const Scalar z59 = z46 + m1 * z48 + z35 * z54;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.x = -z55;
    accelerations.y = z56;
    accelerations.z = -z57;
    accelerations.psi = -z43;
    accelerations.theta = z58;
    accelerations.phi = z59;
    multipliers.X_F = z48;
    multipliers.Y_F = z53;
    multipliers.N = z54;
    const Scalar bound0_ = roundings_ * z42;
    if (!(traits::regular(z3, -z23) && traits::regular(p_A, p_A) && traits::regular(p_C, p_C) && traits::regular(m3,
        bound0_) && traits::regular(z50, bound0_) && traits::regular(z38, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.z * accelerations.psi
        * accelerations.theta * accelerations.phi * multipliers.X_F * multipliers.Y_F * multipliers.N;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    return Mechanism::forward_dynamics(precomputed, state, Inputs(), accelerations, multipliers);
  }

  /// Kinetic energy, force function (potential energy = -U) and power of what has no force function.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, const Inputs&,
      Energy& result) noexcept {
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
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
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
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
    const Scalar z6 = v_phi + z3;  // angular velocity of hoop, z
    const Scalar z7 = v_z * s_theta - c_theta * z0;
    const Scalar z8 = v_z * c_theta + s_theta * z0;
    const Scalar z9 = c_phi * z1 + s_phi * z7;
    const Scalar z10 = s_phi * z1 - c_phi * z7;
    result.kinetic = n0_5 * (p_C * z6 * z6 + z8 * z8 + p_A * (z4 * z4 + z5 * z5) + z9 * z9 + z10 * z10);
    result.force_function = -n9_81 * q_z;
    result.power = n0;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static void energy(const Precomputed& precomputed, const State& state, Energy& result) noexcept {
    Mechanism::energy(precomputed, state, Inputs(), result);
  }

  /// First integrals: constant along every motion.
  TORSOR_DEVICE static void first_integrals(const Precomputed& precomputed, const State& state,
      FirstIntegrals& result) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
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
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
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
    const Scalar z6 = v_phi + z3;  // angular velocity of hoop, z
    const Scalar z7 = v_z * s_theta - c_theta * z0;
    const Scalar z8 = v_z * c_theta + s_theta * z0;
    const Scalar z9 = c_phi * z1 + s_phi * z7;
    const Scalar z10 = s_phi * z1 - c_phi * z7;
    result.energy = n9_81 * q_z + n0_5 * (p_C * z6 * z6 + z8 * z8 + p_A * (z4 * z4 + z5 * z5) + z9 * z9 + z10 * z10);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
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
    const Scalar z0 = v_psi * s_psi;
    const Scalar z1 = v_psi * c_psi;
    const Scalar z2 = v_theta * s_theta;
    const Scalar z3 = v_theta * c_theta;
    const Scalar z4 = v_phi + v_x * c_psi + v_y * s_psi + v_psi * c_theta;
    const Scalar z5 = q_z - s_theta;
    const Scalar z6 = v_x * z0 - v_y * z1 + v_psi * z2;
    const Scalar z7 = v_x * s_psi - z2 - v_y * c_psi;
    const Scalar z8 = v_x * z1 + v_y * z0 - v_theta * z3;
    const Scalar z9 = v_z - z3;
    const Scalar z10 = v_theta * z2;
    result.value[0] = n0;
    result.rate[0] = z4;
    result.gamma[0] = -z6;
    result.value[1] = n0;
    result.rate[1] = -z7;
    result.gamma[1] = -z8;
    result.value[2] = z5;
    result.rate[2] = z9;
    result.gamma[2] = z10;
    result.jacobian[0] = c_psi;
    result.jacobian[1] = -s_psi;
    result.jacobian[2] = n0;
    result.jacobian[3] = s_psi;
    result.jacobian[4] = c_psi;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = n0;
    result.jacobian[8] = n1;
    result.jacobian[9] = c_theta;
    result.jacobian[10] = n0;
    result.jacobian[11] = n0;
    result.jacobian[12] = n0;
    result.jacobian[13] = s_theta;
    result.jacobian[14] = -c_theta;
    result.jacobian[15] = n1;
    result.jacobian[16] = n0;
    result.jacobian[17] = n0;
  }

  /// Linearisation about a state that satisfies the constraints. M d'' + C d' + K d = F + E du in all freedoms d, at
  /// fixed multipliers: A' dlambda and the linearised constraints come beside it. Reduced to independent freedoms:
  /// M_r w' + C_r w + K_r e = F_r + E_r du, e the deviations of x, y, psi, theta, phi,
  /// w those of the rates of y, psi, phi;
  /// the dependent freedoms follow, to first order. At the accelerations and multipliers of the motion F_r vanishes.
  /// Returns singular where the constraints do not determine the dependent freedoms.
  TORSOR_DEVICE static torsor::Status linearisation(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, const Inputs&,
      Linearisation& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar a_x = accelerations.x;
    const Scalar v_y = state.v.y;
    const Scalar a_y = accelerations.y;
    const Scalar a_z = accelerations.z;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_X_F = multipliers.X_F;
    const Scalar l_Y_F = multipliers.Y_F;
    const Scalar l_N = multipliers.N;
    const Scalar m0 = precomputed.m_8a68310a;
    const Scalar m1 = precomputed.m_30f8c0dc;
    const Scalar angles_[] = {q_psi, q_theta, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_psi = sines_[0], c_psi = cosines_[0];
    const Scalar s_theta = sines_[1], c_theta = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = v_psi * s_theta;
    const Scalar z1 = c_theta * m0;
    const Scalar z2 = c_theta * p_C;
    const Scalar z3 = v_psi * c_theta;
    const Scalar z4 = v_psi * c_psi;
    const Scalar z5 = a_psi * c_theta;
    const Scalar z6 = v_psi * s_psi;
    const Scalar z7 = v_theta * s_theta;
    const Scalar z8 = v_theta * c_theta;
    const Scalar z9 = a_psi * s_theta;
    const Scalar z10 = n2 * v_theta;
    const Scalar z11 = s_psi * s_theta;
    const Scalar z12 = c_psi * s_theta;
    const Scalar z13 = s_psi * c_theta;
    const Scalar z14 = c_psi * c_theta;
    const Scalar z15 = n9_81 + a_z;
    const Scalar z16 = v_x * z6;
    const Scalar z17 = v_theta * z8;
    const Scalar z18 = v_x * z4;
    const Scalar z19 = v_theta * z7;
    const Scalar z20 = s_psi * z13 + c_psi * z14;
    const Scalar z21 = z13 * z12 - z14 * z11;
    const Scalar z22 = v_theta * z3 + z9;  // angular acceleration of hoop.2, y
    const Scalar z23 = v_theta * z0 - z5;  // angular acceleration of hoop.2, z
    const Scalar z24 = v_theta * c_phi + s_phi * z0;
    const Scalar z25 = v_theta * s_phi - c_phi * z0;
    const Scalar z26 = v_phi + z3;  // angular velocity of hoop, z
    const Scalar z27 = z0 * z3;
    const Scalar z28 = v_theta * z3;
    const Scalar z29 = c_theta * z1 - p_A;
    const Scalar z30 = z0 * z0;
    const Scalar z31 = z3 * z3;
    const Scalar z32 = v_theta * z0;
    const Scalar z33 = n2 * z0;
    const Scalar z34 = n2 * z3;
    const Scalar z35 = v_y * z4 - z16 - v_psi * z7;
    const Scalar z36 = v_y * z6 - z17 + z18;
    const Scalar z37 = s_psi * z11 + c_psi * z12;
    const Scalar z38 = s_theta * l_X_F;
    const Scalar z39 = s_psi * l_X_F + c_psi * l_Y_F;
    const Scalar z40 = s_psi * l_Y_F - c_psi * l_X_F;
    const Scalar z41 = c_theta * l_X_F;
    const Scalar z42 = z30 + z31;
    const Scalar z43 = n2 * z26;
    const Scalar z44 = z0 * z26;
    const Scalar z45 = v_theta * z26;
    const Scalar z46 = a_phi - z23;  // angular acceleration of hoop, z
    const Scalar z47 = z25 * z26;
    const Scalar z48 = z24 * z26;
    const Scalar z49 = z23 - z32;
    const Scalar z50 = z22 - z28;
    const Scalar z51 = n2 * z24;
    const Scalar z52 = n2 * z25;
    const Scalar z53 = m1 * z43;
    const Scalar z54 = p_C * z44;  // moment on hoop, x
    const Scalar z55 = p_C * z45;  // moment on hoop, y
    const Scalar z56 = p_C * z47;  // moment on hoop, x
    const Scalar z57 = a_x + z40;
    const Scalar z58 = p_C * z48;  // moment on hoop, y
    const Scalar z59 = a_y - z39;
    const Scalar z60 = p_C * z46;  // moment on hoop, z
    const Scalar z61 = l_N - z15;
    const Scalar z62 = m1 * z52;
    const Scalar z63 = m1 * z51;
    const Scalar z64 = p_C * z50;
    const Scalar z65 = s_theta * l_Y_F - l_N * z20;
    const Scalar z66 = c_theta * l_Y_F + l_N * z37;
    const Scalar z67 = l_X_F + l_N * z21;
    const Scalar z68 = p_A * (a_theta - z27) + z54;  // moment on hoop.2, x
    const Scalar z69 = s_phi * z56 + c_phi * z58;
    const Scalar z70 = p_A * z34 - z53;
    const Scalar z71 = z65 - z68;
    const Scalar z72 = p_A * (z22 + z28) - z55;  // moment on hoop.2, y
    const Scalar z73 = c_theta * z60 + s_theta * z72;
    const Scalar z74 = p_A * (z22 + z28) - z69;  // moment on hoop.2, y
    const Scalar z75 = a_phi + a_x * c_psi + a_y * s_psi + z5 + z35;
    const Scalar z76 = z41 - z73;
    const Scalar z77 = v_y * z6 + z18;
    const Scalar z78 = v_y * z4 - z16;
    const Scalar z79 = z77 + a_x * s_psi - a_y * c_psi;
    const Scalar z80 = z78 + a_x * c_psi + a_y * s_psi;
    const Scalar z81 = a_theta * s_theta + z17;
    const Scalar z82 = a_x * s_psi - a_y * c_psi - a_theta * s_theta + z36;
    const Scalar z83 = z60 - z67;
    const Scalar z84 = n1 / c_psi;
    const Scalar z85 = n1 / s_theta;
    const Scalar z86 = v_x * s_psi;
    const Scalar z87 = v_y * c_psi - z86;
    const Scalar z88 = v_y * c_psi - z7 - z86;
    const Scalar z89 = n2 * z7;
    const Scalar z90 = s_phi * z62 + c_phi * z63;
    const Scalar z91 = s_phi * z63 - c_phi * z62;
    const Scalar z92 = z64 + z3 * z90 - z74;
    const Scalar z93 = z3 * z90 + z64;
    const Scalar z94 = v_psi * z8;
    const Scalar z95 = z9 + z94;
    const Scalar z96 = v_x * c_psi + v_y * s_psi;
    const Scalar z97 = n2 * z8;
    const Scalar z98 = p_A * z10 - z90;
    const Scalar z99 = p_A * z49 + z60 + z0 * z98;
    const Scalar z100 = z90 - z98;
    const Scalar z101 = s_theta * z90;
    const Scalar z102 = c_theta * z100;
    const Scalar z103 = a_theta * c_theta - z19;
    const Scalar z104 = s_theta * z99 + c_theta * z92;
    const Scalar z105 = s_theta * z102;
    const Scalar z106 = a_z - a_theta * c_theta + z19;
    const Scalar z107 = p_C * z33 - z91;
    const Scalar z108 = p_A * z33 - z91;
    const Scalar z109 = p_A * z42 - z3 * z53 - z0 * z108;
    const Scalar z110 = z104 - z38;
    const Scalar z111 = s_theta * z53 - c_theta * z108;
    const Scalar z112 = z109 + z66;
    const Scalar z113 = z87 * z84;
    const Scalar z114 = s_theta * z70 - c_theta * z107;
    const Scalar z115 = c_theta * z10 / (c_psi * s_theta);
    const Scalar z116 = c_psi * c_psi;
    const Scalar z117 = n1 + n1 / p_C - c_theta * c_theta / z29;
    const Scalar z118 = s_psi * z84;
    const Scalar z119 = z85 * z118;
    const Scalar z120 = c_theta * z84;
    const Scalar z121 = s_psi * z120;
    const Scalar z122 = n2 * v_psi;
    const Scalar z123 = z0 * z84;
    const Scalar z124 = s_psi * z123 - z8;
    const Scalar z125 = c_theta * z119;
    const Scalar z126 = z85 * z121;
    const Scalar z127 = v_x / c_psi;
    const Scalar z128 = z85 * z127;
    const Scalar z129 = z85 * z84;
    const Scalar z130 = z122 / c_psi;
    const Scalar z131 = z85 * z124;
    const Scalar z132 = z88 + z6 * z120 + z0 * z126;
    const Scalar z133 = s_psi * z122 / c_psi;
    const Scalar z134 = z4 * z120 - z96 - z97 * z126;
    const Scalar z135 = z84 * z132;
    const Scalar z136 = c_theta * z126;
    const Scalar z137 = z6 * z113 - z0 * z128;
    const Scalar z138 = z6 * z123 + z0 * z131;
    const Scalar z139 = z79 - z137;
    const Scalar z140 = z95 + z138;
    const Scalar z141 = z4 * z113 + z97 * z128;
    const Scalar z142 = z80 - z141;
    const Scalar z143 = z4 * z123 - z97 * z131;
    const Scalar z144 = z4 * z84 - z97 * z119;
    const Scalar z145 = z103 - z143;
    const Scalar z146 = z84 * z130;
    const Scalar z147 = z84 * z133;
    const Scalar z148 = z84 * z139;
    const Scalar z149 = z84 * z140;
    const Scalar z150 = s_psi * z146 - z115;
    const Scalar z151 = s_psi * z135 + z134;
    const Scalar z152 = s_psi * z147 + z144;
    const Scalar z153 = s_psi * z148 + z142;
    const Scalar z154 = s_psi * z149 - z145;
    const Scalar z155 = z85 * z150;
    const Scalar z156 = z85 * z151;
    const Scalar z157 = z85 * z152;
    const Scalar z158 = z85 * z153;
    const Scalar z159 = z85 * z154;
    const Scalar z160 = c_theta * z129;
    const Scalar z161 = z89 * z131;
    const Scalar z162 = z81 + z161;
    const Scalar z163 = z89 * z129;
    const Scalar z164 = c_theta * z155 - z163;
    const Scalar z165 = z89 * z126;
    const Scalar z166 = c_theta * z156 - z165;
    const Scalar z167 = z89 * z119;
    const Scalar z168 = z89 * z128;
    const Scalar z169 = c_theta * z157 - z167;
    const Scalar z170 = c_theta * z158 - z168;
    const Scalar z171 = s_theta * s_theta;
    const Scalar z172 = c_theta * z159 - z162;
    const Scalar z173 = n1 + z171 / p_A;
    const Scalar z174 = z75 * z84;
    const Scalar z175 = p_A * z173;
    const Scalar z176 = z105 + z114 * z126;
    const Scalar z177 = z111 * z126 + z176;
    const Scalar z178 = s_psi * z174 - z82;
    const Scalar z179 = p_A * z119;
    const Scalar z180 = z85 * z178;
    const Scalar z181 = p_C + z84 * z84 + z119 * z179 + z125 * z125;
    const Scalar z182 = c_theta * z180 + z106;
    const Scalar z183 = z57 * z118 - z59 - z61 * z160 - z71 * z129;
    const Scalar z184 = p_A * z126;
    const Scalar z185 = z2 + z84 * z120 + z136 * z125 + z119 * z184;
    const Scalar z186 = z29 - z120 * z120 - z126 * z184 - z136 * z136;
    const Scalar z187 = p_A * z129;
    const Scalar z188 = z76 + z57 * z120 - z71 * z126 - z61 * z136;
    const Scalar z189 = z57 * z84 - z83 - z61 * z125 - z71 * z119;
    const Scalar z190 = z118 * z120 + z126 * z187 + z160 * z136;
    const Scalar z191 = z84 * z118 + z119 * z187 + z160 * z125;
    const Scalar z192 = n1 + z118 * z118 + z129 * z187 + z160 * z160;
    const Scalar z193 = n1 / z181;
    const Scalar z194 = z114 * z131;
    const Scalar z195 = z110 - z194;
    const Scalar z196 = z107 * z131;
    const Scalar z197 = z93 + z196;
    const Scalar z198 = z114 * z119 + z101;
    const Scalar z199 = z107 * z126 - z101;
    const Scalar z200 = z91 * z126 + z198;
    const Scalar z201 = z112 * z126 - z195;
    const Scalar z202 = z91 * z129;
    const Scalar z203 = z111 * z119 - z199;
    const Scalar z204 = z112 * z119 - z197;
    const Scalar z205 = z111 * z129;
    const Scalar z206 = z112 * z129;
    const Scalar z207 = z114 * z128;
    const Scalar z208 = z107 * z128;
    const Scalar z209 = z114 * z129;
    const Scalar z210 = z107 * z129;
    const Scalar z211 = z39 * z120 - z207;
    const Scalar z212 = z39 * z84 + z208;
    const Scalar z213 = z118 * z135 + z156 * z187 + z160 * z166;
    const Scalar z214 = z213 - z205;
    const Scalar z215 = z118 * z147 + z157 * z187 + z160 * z169;
    const Scalar z216 = z215 - z202;
    const Scalar z217 = z120 * z146 + z155 * z184 + z136 * z164;
    const Scalar z218 = z217 - z209;
    const Scalar z219 = z120 * z135 + z156 * z184 + z136 * z166;
    const Scalar z220 = z84 * z135 + z156 * z179 + z125 * z166;
    const Scalar z221 = z219 - z177;
    const Scalar z222 = z220 - z203;
    const Scalar z223 = z120 * z147 + z157 * z184 + z136 * z169;
    const Scalar z224 = z84 * z147 + z157 * z179 + z125 * z169;
    const Scalar z225 = z223 - z200;
    const Scalar z226 = z84 * z146 + z155 * z179 + z125 * z164;
    const Scalar z227 = z118 * z146 + z155 * z187 + z160 * z164;
    const Scalar z228 = z226 + z210;
    const Scalar z229 = z185 * z193;
    const Scalar z230 = z186 + z185 * z229;
    const Scalar z231 = z190 - z191 * z229;
    const Scalar z232 = z218 - z228 * z229;
    const Scalar z233 = z221 - z222 * z229;
    const Scalar z234 = n1 / z230;
    const Scalar z235 = z224 * z229 - z225;
    const Scalar z236 = z191 * z193;
    const Scalar z237 = z192 - z191 * z236;
    const Scalar z238 = z118 * z148 + z158 * z187 + z160 * z170;
    const Scalar z239 = z118 * z149 + z159 * z187 + z160 * z172;
    const Scalar z240 = z118 * z174 + z180 * z187 + z160 * z182;
    const Scalar z241 = z183 - z240;
    const Scalar z242 = z239 - z206;
    const Scalar z243 = z120 * z148 + z158 * z184 + z136 * z170;
    const Scalar z244 = z84 * z148 + z158 * z179 + z125 * z170;
    const Scalar z245 = z243 + z211;
    const Scalar z246 = z244 + z212;
    const Scalar z247 = z231 * z234;
    const Scalar z248 = z237 + z231 * z247;
    const Scalar z249 = z227 - z228 * z236 + z247 * z232;
    const Scalar z250 = z245 - z246 * z229;
    const Scalar z251 = n1 / z248;
    const Scalar z252 = z214 - z222 * z236 + z247 * z233;
    const Scalar z253 = z224 * z236 - z216 + z247 * z235;
    const Scalar z254 = z120 * z149 + z159 * z184 + z136 * z172;
    const Scalar z255 = z84 * z149 + z159 * z179 + z125 * z172;
    const Scalar z256 = z120 * z174 + z180 * z184 + z136 * z182;
    const Scalar z257 = z84 * z174 + z180 * z179 + z125 * z182;
    const Scalar z258 = z188 - z256;
    const Scalar z259 = z189 - z257;
    const Scalar z260 = z254 - z201;
    const Scalar z261 = z255 - z204;
    const Scalar z262 = z260 - z261 * z229;
    const Scalar z263 = z251 * z249;
    const Scalar z264 = z251 * z252;
    const Scalar z265 = z251 * z253;
    const Scalar z266 = z234 * z232 - z247 * z263;
    const Scalar z267 = z242 - z261 * z236 + z247 * z262;
    const Scalar z268 = z228 * z193 - z236 * z263 + z229 * z266;
    const Scalar z269 = l_X_F / c_psi;
    const Scalar z270 = z238 + z269;
    const Scalar z271 = z251 * z267;
    const Scalar z272 = z234 * z233 - z247 * z264;
    const Scalar z273 = z234 * z235 - z247 * z265;
    const Scalar z274 = z270 - z246 * z236 + z247 * z250;
    const Scalar z275 = z234 * z262 - z247 * z271;
    const Scalar z276 = z222 * z193 - z236 * z264 + z229 * z272;
    const Scalar z277 = z224 * z193 + z236 * z265 - z229 * z273;
    const Scalar z278 = z251 * z274;
    const Scalar z279 = z261 * z193 - z236 * z271 + z229 * z275;
    const Scalar z280 = z234 * z250 - z247 * z278;
    const Scalar z281 = z246 * z193 - z236 * z278 + z229 * z280;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n0;
    result.M[7] = n1;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = n0;
    result.M[13] = n0;
    result.M[14] = n1;
    result.M[15] = n0;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = -z29;
    result.M[22] = n0;
    result.M[23] = z2;
    result.M[24] = n0;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = n0;
    result.M[28] = p_A;
    result.M[29] = n0;
    result.M[30] = n0;
    result.M[31] = n0;
    result.M[32] = n0;
    result.M[33] = z2;
    result.M[34] = n0;
    result.M[35] = p_C;
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
    result.C[21] = -z105;
    result.C[22] = z111;
    result.C[23] = -z101;
    result.C[24] = n0;
    result.C[25] = n0;
    result.C[26] = n0;
    result.C[27] = z114;
    result.C[28] = n0;
    result.C[29] = -z107;
    result.C[30] = n0;
    result.C[31] = n0;
    result.C[32] = n0;
    result.C[33] = -z101;
    result.C[34] = z91;
    result.C[35] = n0;
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
    result.K[18] = z39;
    result.K[19] = z40;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.K[25] = n0;
    result.K[26] = n0;
    result.K[27] = -z110;
    result.K[28] = -z112;
    result.K[29] = -z93;
    result.K[30] = n0;
    result.K[31] = n0;
    result.K[32] = n0;
    result.K[33] = n0;
    result.K[34] = n0;
    result.K[35] = n0;
    result.F[0] = -z57;
    result.F[1] = -z59;
    result.F[2] = z61;
    result.F[3] = z76;
    result.F[4] = z71;
    result.F[5] = -z83;
    result.M_r[0] = z192;
    result.M_r[1] = z190;
    result.M_r[2] = z191;
    result.M_r[3] = z190;
    result.M_r[4] = -z186;
    result.M_r[5] = z185;
    result.M_r[6] = z191;
    result.M_r[7] = z185;
    result.M_r[8] = z181;
    result.C_r[0] = z227;
    result.C_r[1] = z218;
    result.C_r[2] = z228;
    result.C_r[3] = z214;
    result.C_r[4] = z221;
    result.C_r[5] = z222;
    result.C_r[6] = z216;
    result.C_r[7] = z225;
    result.C_r[8] = z224;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = -z270;
    result.K_r[7] = -z245;
    result.K_r[8] = -z246;
    result.K_r[9] = -z242;
    result.K_r[10] = -z260;
    result.K_r[11] = -z261;
    result.K_r[12] = n0;
    result.K_r[13] = n0;
    result.K_r[14] = n0;
    result.F_r[0] = z241;
    result.F_r[1] = z258;
    result.F_r[2] = z259;
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
    result.A[16] = -z113;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = z128;
    result.A[20] = n0;
    result.A[21] = z278;
    result.A[22] = -z280;
    result.A[23] = z281;
    result.A[24] = z123;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = z131;
    result.A[28] = n0;
    result.A[29] = z271;
    result.A[30] = -z275;
    result.A[31] = z279;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = -z118;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = -z129;
    result.A[44] = n0;
    result.A[45] = -z263;
    result.A[46] = z266;
    result.A[47] = -z268;
    result.A[48] = -z120;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = -z126;
    result.A[52] = n0;
    result.A[53] = -z264;
    result.A[54] = z272;
    result.A[55] = -z276;
    result.A[56] = -z84;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = -z119;
    result.A[60] = n1;
    result.A[61] = z265;
    result.A[62] = -z273;
    result.A[63] = -z277;
    if (!(traits::regular(z171, z175) && traits::regular(z116, z117) && traits::regular(z248, z192)
        && traits::regular(-z230, -z186) && traits::regular(z181, z181))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (((n0 * result.M[21] * result.M[23] * result.M[28] * result.M[33] * result.M[35] * result.C[21]
        * result.C[22] * result.C[23] * result.C[27]) * (n0 * result.C[29] * result.C[33] * result.C[34] * result.K[18]
        * result.K[19] * result.K[27] * result.K[28] * result.K[29] * result.F[0])) * ((n0 * result.F[1] * result.F[2]
        * result.F[3] * result.F[4] * result.F[5] * result.M_r[0] * result.M_r[1] * result.M_r[2] * result.M_r[3]) * (n0
        * result.M_r[4] * result.M_r[5] * result.M_r[6] * result.M_r[7] * result.M_r[8] * result.C_r[0] * result.C_r[1]
        * result.C_r[2] * result.C_r[3] * result.C_r[4]))) * (((n0 * result.C_r[5] * result.C_r[6] * result.C_r[7]
        * result.C_r[8] * result.K_r[6] * result.K_r[7] * result.K_r[8] * result.K_r[9] * result.K_r[10]) * (n0
        * result.K_r[11] * result.F_r[0] * result.F_r[1] * result.F_r[2] * result.A[16] * result.A[19] * result.A[21]
        * result.A[22] * result.A[23] * result.A[24])) * ((n0 * result.A[27] * result.A[29] * result.A[30]
        * result.A[31] * result.A[40] * result.A[43] * result.A[45] * result.A[46] * result.A[47]) * (n0 * result.A[48]
        * result.A[51] * result.A[53] * result.A[54] * result.A[55] * result.A[56] * result.A[59] * result.A[61]
        * result.A[62] * result.A[63])));
    if (!traits::finite(zero)) return torsor::Status::not_finite;
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
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 36>&>(mass_matrix));
    visitor(Description::kernels[2], KernelFunction<void, GeneralizedForces&>(bias));
    visitor(Description::kernels[3],
        KernelFunction<void, const Accelerations&, const Multipliers&, GeneralizedForces&>(inverse_dynamics));
    visitor(Description::kernels[4],
        KernelFunction<torsor::Status, const Inputs&, Accelerations&, Multipliers&>(forward_dynamics));
    visitor(Description::kernels[5], KernelFunction<void, const Inputs&, Energy&>(energy));
    visitor(Description::kernels[6], KernelFunction<void, FirstIntegrals&>(first_integrals));
    visitor(Description::kernels[7], KernelFunction<void, Constraints&>(constraints));
    visitor(Description::kernels[8],
        KernelFunction<torsor::Status, const Accelerations&, const Multipliers&, const Inputs&, Linearisation&>(linearisation));
  }
};

}  // namespace rolling_hoop_contact_forces
