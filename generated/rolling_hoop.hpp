// SPDX-License-Identifier: MIT-0
// rolling_hoop: Hoop rolling without slipping: five coordinates, two multipliers
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: kinematics, mass_matrix, bias, inverse_dynamics, forward_dynamics, energy, first_integrals, constraints, linearisation, inverse_dynamics_derivatives, forward_dynamics_derivatives, jets, sparse_constraint_jacobian, inverse_dynamics_sensitivities, forward_dynamics_sensitivities
// Parameters set at run time: A, C
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function                        additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   precompute                              6                5          4             0                  0       0     15       -
//   kinematics                             13               25          0             0                  3       0     44      44
//   mass_matrix                             2                4          0             0                  1       0      8       9
//   bias                                    6               18          0             0                  1       0     26      26
//   inverse_dynamics                       19               27          0             0                  2       0     50      51
//   forward_dynamics                       21               50          3             0                  2       0     78      81
//   energy                                 14               29          0             0                  3       0     49      55
//   first_integrals                        15               29          0             0                  3       0     50      56
//   constraints                             9               15          0             0                  2       0     28      29
//   linearisation                         202              290         14             0                  2       0    510     535
//   inverse_dynamics_derivatives           30               57          0             0                  2       0     91      96
//   forward_dynamics_derivatives           83              180          4             0                  2       0    271     292
//   jets                                   94              122          9             0                  2       0    229       -
//   sparse_constraint_jacobian              0                0          0             0                  2       0      4       4
//   inverse_dynamics_sensitivities          7               13          0             0                  1       0     22      22
//   forward_dynamics_sensitivities         33               74          3             0                  2       0    114     119
//
// Not computed because this mechanism does not need it:
//   kinematics: of 39 results 11 vanish identically, 2 repeat another up to sign
//   mass_matrix: of 25 results 18 vanish identically, 1 repeat another up to sign
//   bias: of 5 results 2 vanish identically
//   energy: of 3 results 1 vanish identically
//   constraints: of 16 results 5 vanish identically, 2 repeat another up to sign
//   reactions: left out, the scene releases no joint direction (released_coordinate)
//   linearisation: of 180 results 100 vanish identically, 5 repeat another up to sign
//   inverse_dynamics_derivatives: of 50 results 37 vanish identically, 1 repeat another up to sign
//   forward_dynamics_derivatives: of 105 results 40 vanish identically, 6 repeat another up to sign
//   sparse_constraint_jacobian: of 7 results 2 repeat another up to sign
//   inverse_dynamics_sensitivities: of 10 results 5 vanish identically
//   forward_dynamics_sensitivities: of 14 results 1 vanish identically
//
// To write this file again:
//   rolling_hoop_scene generate --kernels kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,first_integrals,constraints,reactions,linearisation,inverse_dynamics_derivatives,forward_dynamics_derivatives,jets,sparse_constraint_jacobian,inverse_dynamics_sensitivities,forward_dynamics_sensitivities --support torsor_support.hpp --output rolling_hoop.hpp
#pragma once

#include <array>
#include <cmath>

#include "torsor_support.hpp"
namespace rolling_hoop {

/// What vectors hold, with units, and what kernels read and write: data that cost nothing where nobody looks at them.
struct Description {
  static constexpr std::array<torsor::QuantityDescription, 5> coordinates{{{"x", "m"}, {"y", "m"}, {"psi", "rad"},
      {"theta", "rad"}, {"phi", "rad"}}};
  static constexpr std::array<torsor::QuantityDescription, 5> velocities{{{"x", "m/s"}, {"y", "m/s"}, {"psi", "rad/s"},
      {"theta", "rad/s"}, {"phi", "rad/s"}}};
  static constexpr std::array<torsor::QuantityDescription, 0> inputs{};
  static constexpr std::array<torsor::QuantityDescription, 2> multipliers{{{"lambda_along_x1", "N"}, {"lambda_along_y1",
      "N"}}};
  static constexpr std::array<torsor::QuantityDescription, 2> parameters{{{"A", "kg m^2"}, {"C", "kg m^2"}}};
  static constexpr std::array<torsor::ResultDescription, 42> results{{{"result", "hoop_position", 3, 1, 1, "m"},
      {"result", "hoop_rotation", 3, 3, 2, "1"}, {"result", "hoop_velocity", 3, 1, 1, "m/s"}, {"result",
      "hoop_angular_velocity", 3, 1, 1, "rad/s"}, {"result", "I_position", 3, 1, 1, "m"}, {"result", "I_velocity", 3, 1,
      1, "m/s"}, {"result", "I_jacobian", 3, 5, 2, ""}, {"mass", "", 5, 5, 2, ""}, {"forces", "", 5, 1, 1, "N m"},
      {"forces", "", 5, 1, 1, "N, N, N m, N m, N m"}, {"accelerations", "", 5, 1, 1,
      "m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2"}, {"multipliers", "", 2, 1, 1, "N"}, {"result", "kinetic", 1, 1, 0,
      "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1, 1, 0, "W"}, {"result", "energy", 1, 1, 0,
      "J"}, {"result", "value", 2, 1, 1, ""}, {"result", "rate", 2, 1, 1, "m/s"}, {"result", "jacobian", 2, 5, 2, ""},
      {"result", "gamma", 2, 1, 1, "m/s^2"}, {"result", "M", 5, 5, 2, ""}, {"result", "C", 5, 5, 2, "N m s"}, {"result",
      "K", 5, 5, 2, ""}, {"result", "F", 5, 1, 1, "N, N, N m, N m, N m"}, {"result", "M_r", 3, 3, 2, ""}, {"result",
      "C_r", 3, 3, 2, ""}, {"result", "K_r", 3, 5, 2, ""}, {"result", "F_r", 3, 1, 1, "N, N m, N m"}, {"result", "A", 8,
      8, 2, ""}, {"result", "by_position", 5, 5, 2, ""}, {"result", "by_velocity", 5, 5, 2, "N m s"}, {"result",
      "by_position", 5, 5, 2, ""}, {"result", "by_velocity", 5, 5, 2, ""}, {"result", "by_force", 5, 5, 2, ""},
      {"result", "multipliers_by_position", 2, 5, 2, "N"}, {"result", "multipliers_by_velocity", 2, 5, 2, ""},
      {"result", "multipliers_by_force", 2, 5, 2, ""}, {"coefficients", "", 10, 0, 2, ""}, {"result", "values", 7, 1, 1,
      "1, 1, m, m, 1, 1, m"}, {"result", "by_parameter", 5, 2, 2, "1/s^2"}, {"result", "by_parameter", 5, 2, 2, ""},
      {"result", "multipliers_by_parameter", 2, 2, 2, "1/m/s^2"}}};
  static constexpr std::array<torsor::KernelDescription, 15> kernels{{{"kinematics", false, false, false, false,
      results.data() + 0, 7}, {"mass_matrix", false, false, false, false, results.data() + 7, 1}, {"bias", false, false,
      false, false, results.data() + 8, 1}, {"inverse_dynamics", true, true, false, false, results.data() + 9, 1},
      {"forward_dynamics", false, false, true, true, results.data() + 10, 2}, {"energy", false, false, true, false,
      results.data() + 12, 3}, {"first_integrals", false, false, false, false, results.data() + 15, 1}, {"constraints",
      false, false, false, false, results.data() + 16, 4}, {"linearisation", true, true, true, true, results.data()
      + 20, 9}, {"inverse_dynamics_derivatives", true, true, false, false, results.data() + 29, 2},
      {"forward_dynamics_derivatives", false, false, true, true, results.data() + 31, 6}, {"jets", false, false, true,
      true, results.data() + 37, 1}, {"sparse_constraint_jacobian", false, false, false, false, results.data() + 38, 1},
      {"inverse_dynamics_sensitivities", true, true, false, false, results.data() + 39, 1},
      {"forward_dynamics_sensitivities", false, false, true, true, results.data() + 40, 2}}};
};

/// Every function is pure: it reads constant arguments and writes its results. Matrices are stored column by column.
/// M a + h = E u + A' lambda and A a + gamma = 0, with a the accelerations and u the inputs; units are SI.
template <class Scalar>
struct Mechanism {
  using traits = torsor::scalar_traits<Scalar>;
  using Description = ::rolling_hoop::Description;

  static constexpr const char* name = "rolling_hoop";
  /// 64 bits (FNV-1a) of this file from "#pragma once" on, with zeros in their own place: another mechanism, other bits.
  static constexpr unsigned long long fingerprint = 0xcf7c50885172b7f2ULL ^ torsor::support_fingerprint;
  static constexpr int coordinate_count = 5;
  static constexpr int velocity_count = 5;
  static constexpr int input_count = 0;
  static constexpr int parameter_count = 2;
  static constexpr int multiplier_count = 2;
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
    Scalar psi;  ///< coordinate [rad]
    Scalar theta;  ///< coordinate [rad]
    Scalar phi;  ///< coordinate [rad]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Coordinates::*member_(int i_) noexcept {
      constexpr Scalar Coordinates::*members_[] = {&Coordinates::x, &Coordinates::y, &Coordinates::psi,
          &Coordinates::theta, &Coordinates::phi};
      return members_[i_];
    }
  };

  /// Generalised velocities v = dq/dt.
  struct Velocities {
    Scalar x;  ///< its rate [m/s]
    Scalar y;  ///< its rate [m/s]
    Scalar psi;  ///< its rate [rad/s]
    Scalar theta;  ///< its rate [rad/s]
    Scalar phi;  ///< its rate [rad/s]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Velocities::*member_(int i_) noexcept {
      constexpr Scalar Velocities::*members_[] = {&Velocities::x, &Velocities::y, &Velocities::psi, &Velocities::theta,
          &Velocities::phi};
      return members_[i_];
    }
  };

  /// Generalised accelerations dv/dt.
  struct Accelerations {
    Scalar x;  ///< its second rate [m/s^2]
    Scalar y;  ///< its second rate [m/s^2]
    Scalar psi;  ///< its second rate [rad/s^2]
    Scalar theta;  ///< its second rate [rad/s^2]
    Scalar phi;  ///< its second rate [rad/s^2]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Accelerations::*member_(int i_) noexcept {
      constexpr Scalar Accelerations::*members_[] = {&Accelerations::x, &Accelerations::y, &Accelerations::psi,
          &Accelerations::theta, &Accelerations::phi};
      return members_[i_];
    }
  };

  /// Generalised forces, one along each coordinate.
  struct GeneralizedForces {
    Scalar x;  ///< works with the rate of x [N]
    Scalar y;  ///< works with the rate of y [N]
    Scalar psi;  ///< works with the rate of psi [N m]
    Scalar theta;  ///< works with the rate of theta [N m]
    Scalar phi;  ///< works with the rate of phi [N m]
    static constexpr int size = 5;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar GeneralizedForces::*member_(int i_) noexcept {
      constexpr Scalar GeneralizedForces::*members_[] = {&GeneralizedForces::x, &GeneralizedForces::y,
          &GeneralizedForces::psi, &GeneralizedForces::theta, &GeneralizedForces::phi};
      return members_[i_];
    }
  };

  /// Forces and torques of motors, set at each call.
  struct Inputs : torsor::NoMembers<Scalar> {};

  /// Multipliers of the constraints, or the reactions that enforce them.
  struct Multipliers {
    Scalar lambda_along_x1;  ///< of the constraint along_x1 [N]
    Scalar lambda_along_y1;  ///< of the constraint along_y1 [N]
    static constexpr int size = 2;
    TORSOR_DEVICE Scalar& operator[](int i_) noexcept { return this->*member_(i_); }
    TORSOR_DEVICE const Scalar& operator[](int i_) const noexcept { return this->*member_(i_); }

   private:
    TORSOR_DEVICE static constexpr Scalar Multipliers::*member_(int i_) noexcept {
      constexpr Scalar Multipliers::*members_[] = {&Multipliers::lambda_along_x1, &Multipliers::lambda_along_y1};
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
    Scalar m_d6343e7e;
    Scalar m_b4ea09ae;
    Scalar m_876988c5;
    Scalar m_e4106fa2;
    Scalar m_74dc511b;
    Scalar m_249c8b11;
    Scalar m_4cbeeeaa;
    Scalar m_e5f5debb;
    Scalar m_b58c0c23;
    Scalar m_1e49e888;
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
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar p_A = parameters.A;
    const Scalar p_C = parameters.C;
    const Scalar z0 = p_A - p_C;
    const Scalar z1 = n1 / p_C;
    const Scalar z2 = n1 + z1;
    const Scalar z3 = n1 / z2;
    const Scalar z4 = z1 * z3;
    const Scalar z5 = z1 * z4;
    precomputed.m_8a68310a = z0;
    precomputed.m_be7541f9 = z1;
    precomputed.m_d6343e7e = z2;
    precomputed.m_b4ea09ae = z3;
    precomputed.m_876988c5 = z4;
    precomputed.m_e4106fa2 = z5;
    precomputed.m_74dc511b = n1 + p_A;
    precomputed.m_249c8b11 = p_C / p_A;
    precomputed.m_4cbeeeaa = n2 - p_C / p_A;
    precomputed.m_e5f5debb = p_A - p_C;
    precomputed.m_b58c0c23 = p_C * z1;
    precomputed.m_1e49e888 = -z3 * (n1 - p_C * z1);
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
    state.q.psi = n0;
    state.q.theta = n1_2;
    state.q.phi = n0;
    state.v.x = n4 - n0_5 * z1;
    state.v.y = n0_3 * z2;
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
    std::array<Scalar, 15> I_jacobian;  ///< partial velocities of I (3 x 5)
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
    std::array<Scalar, 2> value;  ///< f(q, t) of holonomic constraints, 0 for the others
    std::array<Scalar, 2> rate;  ///< A v - b, df/dt for holonomic ones
    std::array<Scalar, 10> jacobian;  ///< A, stored column by column (2 x 5)
    std::array<Scalar, 2> gamma;  ///< d(A v - b)/dt at zero acceleration: A a + gamma = 0
  };

  /// Matrices of the linearised equations, stored column by column.
  struct Linearisation {
    std::array<Scalar, 25> M;  ///< mass matrix (5 x 5)
    std::array<Scalar, 25> C;  ///< damping and gyroscopic terms (5 x 5)
    std::array<Scalar, 25> K;  ///< stiffness (5 x 5)
    std::array<Scalar, 5> F;  ///< right-hand side
    std::array<Scalar, 9> M_r;  ///< reduced mass matrix (3 x 3)
    std::array<Scalar, 9> C_r;  ///< reduced damping and gyroscopic terms (3 x 3)
    std::array<Scalar, 15> K_r;  ///< reduced stiffness (3 x 5)
    std::array<Scalar, 3> F_r;  ///< reduced right-hand side
    std::array<Scalar, 64> A;  ///< state matrix of x = (e, w): x' = A x + B du (8 x 8)
  };
  /// Freedoms that e of the linearisation runs along: places in v (and in q, but for attitudes).
  static constexpr int independent_coordinate_count = 5;
  static constexpr int independent_coordinates[5] = {0, 1, 2, 3, 4};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[3] = {1, 2, 4};

  /// Derivatives of generalised forces, stored column by column.
  struct InverseDynamicsDerivatives {
    std::array<Scalar, 25> by_position;  ///< df_i/dq_j (5 x 5)
    std::array<Scalar, 25> by_velocity;  ///< df_i/dv_j (5 x 5)
  };

  /// Derivatives of accelerations and multipliers, stored column by column.
  struct ForwardDynamicsDerivatives {
    std::array<Scalar, 25> by_position;  ///< da_i/dq_j (5 x 5)
    std::array<Scalar, 25> by_velocity;  ///< da_i/dv_j (5 x 5)
    std::array<Scalar, 25> by_force;  ///< da_i/df_j, f generalised forces added to E u (5 x 5)
    std::array<Scalar, 10> multipliers_by_position;  ///< dlambda_i/dq_j (2 x 5)
    std::array<Scalar, 10> multipliers_by_velocity;  ///< dlambda_i/dv_j (2 x 5)
    std::array<Scalar, 10> multipliers_by_force;  ///< dlambda_i/df_j, f generalised forces added to E u (2 x 5)
  };

  /// Entries of A in compressed rows.
  struct SparseConstraintJacobian {
    std::array<Scalar, 7> values;  ///< entries of A, row by row
  };
  /// Where the values of SparseConstraintJacobian stand: those of row i, in the order of the multipliers, from
  /// row_start[i] to row_start[i + 1], each in its column, an index in v.
  static constexpr int constraint_jacobian_nonzeros = 7;
  static constexpr int constraint_jacobian_row_start[3] = {0, 4, 7};
  static constexpr int constraint_jacobian_column[7] = {0, 1, 2, 4, 0, 1, 3};

  /// Derivatives by the run-time parameters, a column for each, in the order of Parameters.
  struct InverseDynamicsSensitivities {
    std::array<Scalar, 10> by_parameter;  ///< df_i/dp_k (5 x 2)
  };

  /// Derivatives by the run-time parameters, a column for each, in the order of Parameters.
  struct ForwardDynamicsSensitivities {
    std::array<Scalar, 10> by_parameter;  ///< da_i/dp_k (5 x 2)
    std::array<Scalar, 4> multipliers_by_parameter;  ///< dlambda_i/dp_k (2 x 2)
  };

  /// Poses and twists of all bodies, positions, velocities and Jacobians of named points, in ground axes;
  /// matrices column by column.
  TORSOR_DEVICE static void kinematics(const Precomputed&, const State& state, Kinematics& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_x = state.q.x;
    const Scalar v_x = state.v.x;
    const Scalar q_y = state.q.y;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = s_theta * s_psi;
    const Scalar z1 = s_theta * c_psi;
    const Scalar z2 = c_theta * s_psi;
    const Scalar z3 = c_theta * c_psi;
    const Scalar z4 = c_theta * v_psi;
    const Scalar z5 = v_theta * c_psi;  // angular velocity of hoop.2, x
    const Scalar z6 = v_theta * s_psi;  // angular velocity of hoop.2, y
    const Scalar z7 = c_theta * v_theta;
    const Scalar z8 = s_theta * s_phi;
    const Scalar z9 = s_theta * c_phi;
    const Scalar z10 = c_theta * v_phi + v_psi;  // angular velocity of hoop, z
    const Scalar z11 = c_psi * c_phi - s_phi * z2;
    const Scalar z12 = c_psi * s_phi + c_phi * z2;
    const Scalar z13 = s_psi * c_phi + s_phi * z3;
    const Scalar z14 = s_psi * s_phi - c_phi * z3;
    const Scalar z15 = v_phi * z0 + z5;  // angular velocity of hoop, x
    const Scalar z16 = v_phi * z1 - z6;  // angular velocity of hoop, y
    const Scalar z17 = v_x - v_theta * z0 + c_psi * z4;
    const Scalar z18 = v_y + v_theta * z1 + s_psi * z4;
    const Scalar z19 = q_x + z2;
    const Scalar z20 = q_y - z3;
    result.hoop_position[0] = q_x;
    result.hoop_position[1] = q_y;
    result.hoop_position[2] = s_theta;
    result.hoop_rotation[0] = z11;
    result.hoop_rotation[1] = z13;
    result.hoop_rotation[2] = z8;
    result.hoop_rotation[3] = -z12;
    result.hoop_rotation[4] = -z14;
    result.hoop_rotation[5] = z9;
    result.hoop_rotation[6] = z0;
    result.hoop_rotation[7] = -z1;
    result.hoop_rotation[8] = c_theta;
    result.hoop_velocity[0] = v_x;
    result.hoop_velocity[1] = v_y;
    result.hoop_velocity[2] = z7;
    result.hoop_angular_velocity[0] = z15;
    result.hoop_angular_velocity[1] = -z16;
    result.hoop_angular_velocity[2] = z10;
    result.I_position[0] = z19;
    result.I_position[1] = z20;
    result.I_position[2] = n0;
    result.I_velocity[0] = z17;
    result.I_velocity[1] = z18;
    result.I_velocity[2] = n0;
    result.I_jacobian[0] = n1;
    result.I_jacobian[3] = n0;
    result.I_jacobian[6] = z3;
    result.I_jacobian[9] = -z0;
    result.I_jacobian[12] = n0;
    result.I_jacobian[1] = n0;
    result.I_jacobian[4] = n1;
    result.I_jacobian[7] = z2;
    result.I_jacobian[10] = z1;
    result.I_jacobian[13] = n0;
    result.I_jacobian[2] = n0;
    result.I_jacobian[5] = n0;
    result.I_jacobian[8] = n0;
    result.I_jacobian[11] = n0;
    result.I_jacobian[14] = n0;
  }

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed& precomputed, const State& state,
      std::array<Scalar, 25>& mass) noexcept {
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
    const Scalar z2 = c_theta * c_theta + p_A;
    const Scalar z3 = c_theta * z0 - p_A;
    mass[0] = n1;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = n0;
    mass[4] = n0;
    mass[5] = n0;
    mass[6] = n1;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n0;
    mass[11] = n0;
    mass[12] = -z3;
    mass[13] = n0;
    mass[14] = z1;
    mass[15] = n0;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = z2;
    mass[19] = n0;
    mass[20] = n0;
    mass[21] = n0;
    mass[22] = z1;
    mass[23] = n0;
    mass[24] = p_C;
  }

  /// Bias h(q, v, t): inverse dynamics at zero acceleration without inputs and multipliers; gravity and passive
  /// actions included. M a + h = E u + A' lambda.
  TORSOR_DEVICE static void bias(const Precomputed& precomputed, const State& state,
      GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = c_theta * v_psi;
    const Scalar z1 = s_theta * v_psi;
    const Scalar z2 = s_theta * v_theta;
    const Scalar z3 = v_theta * z2;
    const Scalar z4 = v_theta * z0;  // angular acceleration of hoop.2, y
    const Scalar z5 = v_theta * z1;  // angular acceleration of hoop.2, z
    const Scalar z6 = v_phi + z0;  // angular velocity of hoop, z
    const Scalar z7 = z1 * z0;
    const Scalar z8 = n9_81 - z3;
    const Scalar z9 = z1 * z6;
    const Scalar z10 = v_theta * z6;
    const Scalar z11 = p_C * z5;  // moment on hoop, z
    const Scalar z12 = n2 * z4;
    const Scalar z13 = p_C * z9;  // moment on hoop, x
    const Scalar z14 = p_C * z10;  // moment on hoop, y
    const Scalar z15 = p_A * z7 - z13;  // moment on hoop.2, x
    const Scalar z16 = p_A * z12 - z14;  // moment on hoop.2, y
    const Scalar z17 = s_theta * z16 - c_theta * z11;
    const Scalar z18 = c_theta * z8 - z15;
    forces.x = n0;
    forces.y = n0;
    forces.psi = z17;
    forces.theta = z18;
    forces.phi = -z11;
  }

  /// Inverse dynamics: the generalised forces M a + h - A' lambda that motors must supply for the accelerations a.
  TORSOR_DEVICE static void inverse_dynamics(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, GeneralizedForces& forces) noexcept {
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z0 = s_theta * v_psi;
    const Scalar z1 = c_theta * v_psi;
    const Scalar z2 = c_theta * a_psi;
    const Scalar z3 = s_theta * a_psi;
    const Scalar z4 = s_theta * v_theta;
    const Scalar z5 = c_theta * a_theta - v_theta * z4;
    const Scalar z6 = v_theta * z1 + z3;  // angular acceleration of hoop.2, y
    const Scalar z7 = v_theta * z0 - z2;  // angular acceleration of hoop.2, z
    const Scalar z8 = v_phi + z1;  // angular velocity of hoop, z
    const Scalar z9 = z0 * z1;
    const Scalar z10 = v_theta * z1;
    const Scalar z11 = z0 * z8;
    const Scalar z12 = v_theta * z8;
    const Scalar z13 = n9_81 + z5;
    const Scalar z14 = a_phi - z7;  // angular acceleration of hoop, z
    const Scalar z15 = z6 + z10;
    const Scalar z16 = p_C * z11;  // moment on hoop, x
    const Scalar z17 = p_C * z12;  // moment on hoop, y
    const Scalar z18 = p_C * z14;  // moment on hoop, z
    const Scalar z19 = p_A * (a_theta - z9) + z16;  // moment on hoop.2, x
    const Scalar z20 = p_A * z15 - z17;  // moment on hoop.2, y
    const Scalar z21 = c_theta * z18 + s_theta * z20;
    const Scalar z22 = c_theta * z13 + z19;
    forces.x = a_x + s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    forces.y = a_y - s_psi * l_lambda_along_x1 - c_psi * l_lambda_along_y1;
    forces.psi = -c_theta * l_lambda_along_x1 + z21;
    forces.theta = -s_theta * l_lambda_along_y1 + z22;
    forces.phi = z18 - l_lambda_along_x1;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed& precomputed, const State& state,
      const Inputs&, Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar m0 = precomputed.m_8a68310a;
    const Scalar m1 = precomputed.m_be7541f9;
    const Scalar m2 = precomputed.m_d6343e7e;
    const Scalar m3 = precomputed.m_b4ea09ae;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z0 = c_theta * c_theta + p_A;
    const Scalar z1 = c_theta * v_psi;
    const Scalar z2 = s_theta * s_theta * p_A;
    const Scalar z3 = s_theta * v_psi;
    const Scalar z4 = v_psi * s_psi;
    const Scalar z5 = s_theta * v_theta;
    const Scalar z6 = v_psi * c_psi;
    const Scalar z7 = c_theta * p_C;
    const Scalar z8 = c_theta * v_theta;
    const Scalar z9 = c_theta * m0;
    const Scalar z10 = v_x * z4 - v_y * z6 + z5 * v_psi;
    const Scalar z11 = v_x * z6 + v_y * z4 - v_theta * z8;
    const Scalar z12 = v_theta * z5;
    const Scalar z13 = v_theta * z1;  // angular acceleration of hoop.2, y
    const Scalar z14 = v_theta * z3;  // angular acceleration of hoop.2, z
    const Scalar z15 = v_phi + z1;  // angular velocity of hoop, z
    const Scalar z16 = z3 * z1;
    const Scalar z17 = c_theta * z9 - p_A;
    const Scalar z18 = z7 * m1;
    const Scalar z19 = n1 / z0;
    const Scalar z20 = n9_81 - z12;
    const Scalar z21 = z3 * z15;
    const Scalar z22 = v_theta * z15;
    const Scalar z23 = p_C * z14;  // moment on hoop, z
    const Scalar z24 = n2 * z13;
    const Scalar z25 = n1 / z2;
    const Scalar z26 = p_C * z21;  // moment on hoop, x
    const Scalar z27 = p_C * z22;  // moment on hoop, y
    const Scalar z28 = p_A * z16 - z26;  // moment on hoop.2, x
    const Scalar z29 = p_A * z24 - z27;  // moment on hoop.2, y
    const Scalar z30 = c_theta * z20 - z28;
    const Scalar z31 = s_theta * z29;
    const Scalar z32 = s_theta * z19;
    const Scalar z33 = z25 * z31;
    const Scalar z34 = n1 + s_theta * z32;
    const Scalar z35 = z30 * z19;
    const Scalar z36 = z23 * m1 + z18 * z33;
    const Scalar z37 = s_theta * z35 + z11;
    const Scalar z38 = n1 / z34;
    const Scalar z39 = m2 + z34;
    const Scalar z40 = c_theta * z33 + z10 - z36;
    const Scalar z41 = m3 * z40;
    const Scalar z42 = m1 * z41 + z36;
    const Scalar z43 = z38 * z37;
    const Scalar z44 = s_psi * z43 - c_psi * z41;
    const Scalar z45 = s_psi * z41 + c_psi * z43;
    const Scalar z46 = z32 * z43 - z35;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.x = -z44;
    accelerations.y = z45;
    accelerations.psi = -z33;
    accelerations.theta = z46;
    accelerations.phi = z42;
    multipliers.lambda_along_x1 = z41;
    multipliers.lambda_along_y1 = z43;
    const Scalar bound0_ = roundings_ * z39;
    if (!(traits::regular(z2, -z17) && traits::regular(z0, z0) && traits::regular(p_C, p_C) && traits::regular(m2,
        bound0_) && traits::regular(z34, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.psi * accelerations.theta
        * accelerations.phi * multipliers.lambda_along_x1 * multipliers.lambda_along_y1;
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
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = c_theta * v_theta;
    const Scalar z1 = v_x * s_psi - v_y * c_psi;
    const Scalar z2 = v_x * c_psi + v_y * s_psi;
    const Scalar z3 = s_theta * v_psi;
    const Scalar z4 = c_theta * v_psi;
    const Scalar z5 = v_theta * c_phi + s_phi * z3;
    const Scalar z6 = v_theta * s_phi - c_phi * z3;
    const Scalar z7 = v_phi + z4;  // angular velocity of hoop, z
    const Scalar z8 = s_theta * z0 - c_theta * z1;
    const Scalar z9 = c_theta * z0 + s_theta * z1;
    const Scalar z10 = c_phi * z2 + s_phi * z8;
    const Scalar z11 = s_phi * z2 - c_phi * z8;
    result.kinetic = n0_5 * (p_C * z7 * z7 + z9 * z9 + p_A * (z5 * z5 + z6 * z6) + z10 * z10 + z11 * z11);
    result.force_function = -n9_81 * s_theta;
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
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar q_phi = state.q.phi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar angles_[] = {q_theta, q_psi, q_phi};
    Scalar sines_[3], cosines_[3];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar s_phi = sines_[2], c_phi = cosines_[2];
    const Scalar z0 = c_theta * v_theta;
    const Scalar z1 = v_x * s_psi - v_y * c_psi;
    const Scalar z2 = v_x * c_psi + v_y * s_psi;
    const Scalar z3 = s_theta * v_psi;
    const Scalar z4 = c_theta * v_psi;
    const Scalar z5 = v_theta * c_phi + s_phi * z3;
    const Scalar z6 = v_theta * s_phi - c_phi * z3;
    const Scalar z7 = v_phi + z4;  // angular velocity of hoop, z
    const Scalar z8 = s_theta * z0 - c_theta * z1;
    const Scalar z9 = c_theta * z0 + s_theta * z1;
    const Scalar z10 = c_phi * z2 + s_phi * z8;
    const Scalar z11 = s_phi * z2 - c_phi * z8;
    result.energy = n9_81 * s_theta + n0_5 * (p_C * z7 * z7 + z9 * z9 + p_A * (z5 * z5 + z6 * z6) + z10 * z10 + z11
        * z11);
  }

  /// Constraints A(q, t) v - b(q, t) = 0, in the order of the multipliers.
  TORSOR_DEVICE static void constraints(const Precomputed&, const State& state, Constraints& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z0 = v_psi * s_psi;
    const Scalar z1 = v_psi * c_psi;
    const Scalar z2 = s_theta * v_theta;
    const Scalar z3 = c_theta * v_theta;
    const Scalar z4 = v_phi + v_x * c_psi + v_y * s_psi + c_theta * v_psi;
    const Scalar z5 = v_x * z0 - v_y * z1 + v_psi * z2;
    const Scalar z6 = v_x * s_psi - z2 - v_y * c_psi;
    const Scalar z7 = v_x * z1 + v_y * z0 - v_theta * z3;
    result.value[0] = n0;
    result.rate[0] = z4;
    result.gamma[0] = -z5;
    result.value[1] = n0;
    result.rate[1] = -z6;
    result.gamma[1] = -z7;
    result.jacobian[0] = c_psi;
    result.jacobian[1] = -s_psi;
    result.jacobian[2] = s_psi;
    result.jacobian[3] = c_psi;
    result.jacobian[4] = c_theta;
    result.jacobian[5] = n0;
    result.jacobian[6] = n0;
    result.jacobian[7] = s_theta;
    result.jacobian[8] = n1;
    result.jacobian[9] = n0;
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
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar m0 = precomputed.m_8a68310a;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z0 = c_theta * c_theta + p_A;
    const Scalar z1 = c_theta * m0;
    const Scalar z2 = c_theta * p_C;
    const Scalar z3 = s_theta * v_psi;
    const Scalar z4 = c_theta * v_psi;
    const Scalar z5 = c_theta * a_psi;
    const Scalar z6 = s_theta * v_theta;
    const Scalar z7 = v_psi * s_psi;
    const Scalar z8 = s_theta * a_psi;
    const Scalar z9 = c_theta * v_theta;
    const Scalar z10 = v_psi * c_psi;
    const Scalar z11 = c_theta * a_theta;
    const Scalar z12 = s_psi * l_lambda_along_x1;
    const Scalar z13 = s_psi * l_lambda_along_y1;
    const Scalar z14 = v_theta * z6 - z11;
    const Scalar z15 = s_theta * a_theta;
    const Scalar z16 = v_x * z7;
    const Scalar z17 = v_x * z10;
    const Scalar z18 = v_theta * z4 + z8;  // angular acceleration of hoop.2, y
    const Scalar z19 = v_theta * z3 - z5;  // angular acceleration of hoop.2, z
    const Scalar z20 = v_phi + z4;  // angular velocity of hoop, z
    const Scalar z21 = z3 * z4;
    const Scalar z22 = v_theta * z4;
    const Scalar z23 = c_theta * z1 - p_A;
    const Scalar z24 = v_theta * z6;
    const Scalar z25 = v_theta * z3;  // angular acceleration of hoop.2, z
    const Scalar z26 = c_psi * l_lambda_along_y1 + z12;
    const Scalar z27 = c_psi * l_lambda_along_x1 - z13;
    const Scalar z28 = n2 * z9;
    const Scalar z29 = p_C * z9;
    const Scalar z30 = p_C * z6;
    const Scalar z31 = c_theta * z3;
    const Scalar z32 = n2 * z4;
    const Scalar z33 = p_C * z3;
    const Scalar z34 = n2 * z6;
    const Scalar z35 = v_theta * z9 + z15;
    const Scalar z36 = z3 * z3;
    const Scalar z37 = v_y * z10 - z16 - v_psi * z6;
    const Scalar z38 = z17 + v_y * z7 - v_theta * z9;
    const Scalar z39 = z3 * z20;
    const Scalar z40 = v_theta * z20;
    const Scalar z41 = p_C * z25;  // moment on hoop, z
    const Scalar z42 = p_A * z28 - z29;
    const Scalar z43 = s_theta * z4 + z31;
    const Scalar z44 = s_theta * z20 + z31;
    const Scalar z45 = p_C * z20;
    const Scalar z46 = c_theta * z34;
    const Scalar z47 = z4 * z4 - z36;
    const Scalar z48 = z4 * z20 - z36;
    const Scalar z49 = n9_81 - z14;
    const Scalar z50 = a_x * s_psi;
    const Scalar z51 = v_theta * p_C;
    const Scalar z52 = s_theta * z51;
    const Scalar z53 = a_phi - z19;  // angular acceleration of hoop, z
    const Scalar z54 = v_y * z10 - z16;
    const Scalar z55 = v_x * c_psi + v_y * s_psi;
    const Scalar z56 = z18 + z22;
    const Scalar z57 = z19 + z25;
    const Scalar z58 = p_C * z18;
    const Scalar z59 = p_C * z39;  // moment on hoop, x
    const Scalar z60 = v_x * s_psi;
    const Scalar z61 = p_C * z40;  // moment on hoop, y
    const Scalar z62 = v_y * c_psi - z60;
    const Scalar z63 = p_A * z32 - z45;
    const Scalar z64 = p_C * z53;  // moment on hoop, z
    const Scalar z65 = v_y * c_psi - z6 - z60;
    const Scalar z66 = p_A * z57 - z41;
    const Scalar z67 = p_A * z56 - z61;  // moment on hoop.2, y
    const Scalar z68 = z11 - z24;
    const Scalar z69 = p_A * (a_theta - z21) + z59;  // moment on hoop.2, x
    const Scalar z70 = a_phi + a_x * c_psi + a_y * s_psi + z5 + z37;
    const Scalar z71 = a_y * c_psi + z15 - z50 - z38;
    const Scalar z72 = p_C * z48;
    const Scalar z73 = p_A * z47 - z72;
    const Scalar z74 = v_y * z7 + z17;
    const Scalar z75 = a_y * c_psi - z50 - z74;
    const Scalar z76 = z54 + a_x * c_psi + a_y * s_psi;
    const Scalar z77 = z73 + c_theta * z35 + s_theta * z49;
    const Scalar z78 = c_theta * z49 + z69;
    const Scalar z79 = p_C * z44;
    const Scalar z80 = p_A * z43 - z79;
    const Scalar z81 = s_theta * z63 - c_theta * z33;
    const Scalar z82 = s_theta * (z64 + z66) - c_theta * (z67 - z58);
    const Scalar z83 = s_theta * z42 - c_theta * z30;
    const Scalar z84 = s_theta * l_lambda_along_x1 - z82;
    const Scalar z85 = c_theta * l_lambda_along_y1 + z77;
    const Scalar z86 = c_theta * z64 + s_theta * z67;
    const Scalar z87 = c_psi * c_psi;
    const Scalar z88 = n1 + n1 / p_C - c_theta * c_theta / z23;
    const Scalar z89 = n1 / c_psi;
    const Scalar z90 = z62 * z89;
    const Scalar z91 = z70 * z89;
    const Scalar z92 = n1 / s_theta;
    const Scalar z93 = s_psi * z89;
    const Scalar z94 = c_theta * z89;
    const Scalar z95 = n2 * v_psi;
    const Scalar z96 = s_psi * z91 + z71;
    const Scalar z97 = z92 * z93;
    const Scalar z98 = s_psi * z94;
    const Scalar z99 = z3 * z89;
    const Scalar z100 = v_x / c_psi;
    const Scalar z101 = z92 * z98;
    const Scalar z102 = z92 * z100;
    const Scalar z103 = z92 * z96;
    const Scalar z104 = z0 * z97;
    const Scalar z105 = s_psi * z99 - z9;
    const Scalar z106 = v_psi * z9;
    const Scalar z107 = z8 + z106;
    const Scalar z108 = z92 * z105;
    const Scalar z109 = z65 + z7 * z94 + z3 * z101;
    const Scalar z110 = z10 * z94 - z55 - z28 * z101;
    const Scalar z111 = z89 * z109;
    const Scalar z112 = p_C + z89 * z89 + z97 * z104;
    const Scalar z113 = s_psi * z111 + z110;
    const Scalar z114 = z0 * z101;
    const Scalar z115 = z2 + z89 * z94 + z97 * z114;
    const Scalar z116 = z23 - z94 * z94 - z101 * z114;
    const Scalar z117 = z92 * z113;
    const Scalar z118 = z92 * z89;
    const Scalar z119 = z7 * z90 - z3 * z102;
    const Scalar z120 = z7 * z99 + z3 * z108;
    const Scalar z121 = z75 + z119;
    const Scalar z122 = z107 + z120;
    const Scalar z123 = z10 * z90 + z28 * z102;
    const Scalar z124 = z76 - z123;
    const Scalar z125 = z10 * z99 - z28 * z108;
    const Scalar z126 = z68 - z125;
    const Scalar z127 = z10 * z89 - z28 * z97;
    const Scalar z128 = z28 / (s_theta * c_psi);
    const Scalar z129 = z89 * z121;
    const Scalar z130 = z89 * z122;
    const Scalar z131 = s_psi * z129 - z124;
    const Scalar z132 = s_psi * z130 - z126;
    const Scalar z133 = z0 * z118;
    const Scalar z134 = z95 / c_psi;
    const Scalar z135 = s_psi * z95 / c_psi;
    const Scalar z136 = z89 * z134;
    const Scalar z137 = z89 * z135;
    const Scalar z138 = z92 * z131;
    const Scalar z139 = z92 * z132;
    const Scalar z140 = s_psi * z136 - z128;
    const Scalar z141 = s_psi * z137 + z127;
    const Scalar z142 = z93 * z94 + z101 * z133;
    const Scalar z143 = z89 * z93 + z97 * z133;
    const Scalar z144 = z92 * z140;
    const Scalar z145 = z92 * z141;
    const Scalar z146 = n1 + z93 * z93 + z118 * z133;
    const Scalar z147 = z93 * z136 + z144 * z133;
    const Scalar z148 = s_theta * s_theta;
    const Scalar z149 = n1 + z148 / z0;
    const Scalar z150 = z93 * z111 + z117 * z133;
    const Scalar z151 = z93 * z137 + z145 * z133;
    const Scalar z152 = z0 * z149;
    const Scalar z153 = z83 - z81 * z101;
    const Scalar z154 = z81 * z97 + z52;
    const Scalar z155 = z80 - z46 * z101;
    const Scalar z156 = z30 - z33 * z101;
    const Scalar z157 = z101 * z155 + z153;
    const Scalar z158 = z97 * z155 - z156;
    const Scalar z159 = z118 * z155;
    const Scalar z160 = z150 + z159;
    const Scalar z161 = z81 * z102;
    const Scalar z162 = z33 * z102;
    const Scalar z163 = z46 * z102;
    const Scalar z164 = z26 * z93 + z27 - z118 * z163;
    const Scalar z165 = z26 * z94 - z161 - z101 * z163;
    const Scalar z166 = z162 + z26 * z89 - z97 * z163;
    const Scalar z167 = z81 * z108;
    const Scalar z168 = z84 + z167;
    const Scalar z169 = z81 * z118;
    const Scalar z170 = z46 * z108;
    const Scalar z171 = z85 + z170;
    const Scalar z172 = z33 * z108;
    const Scalar z173 = z58 + z172;
    const Scalar z174 = z46 * z118;
    const Scalar z175 = z33 + z46 * z97;
    const Scalar z176 = z101 * z174 + z169;
    const Scalar z177 = z101 * z175 + z154;
    const Scalar z178 = z101 * z171 + z168;
    const Scalar z179 = z97 * z171 - z173;
    const Scalar z180 = z118 * z171;
    const Scalar z181 = z33 * z118;
    const Scalar z182 = z33 * z97;
    const Scalar z183 = z97 * z174 - z181;
    const Scalar z184 = z118 * z174;
    const Scalar z185 = z147 - z184;
    const Scalar z186 = z118 * z175;
    const Scalar z187 = z97 * z175 - z182;
    const Scalar z188 = z151 - z186;
    const Scalar z189 = z94 * z136 + z144 * z114;
    const Scalar z190 = z89 * z136 + z144 * z104;
    const Scalar z191 = z189 - z176;
    const Scalar z192 = z190 - z183;
    const Scalar z193 = a_x - c_psi * l_lambda_along_x1 + z13;
    const Scalar z194 = z94 * z111 + z117 * z114;
    const Scalar z195 = z89 * z111 + z117 * z104;
    const Scalar z196 = z194 + z157;
    const Scalar z197 = z195 + z158;
    const Scalar z198 = z94 * z137 + z145 * z114;
    const Scalar z199 = z89 * z137 + z145 * z104;
    const Scalar z200 = z198 - z177;
    const Scalar z201 = z199 - z187;
    const Scalar z202 = n1 / z112;
    const Scalar z203 = a_y - z50 / c_psi - z78 / (s_theta * c_psi);
    const Scalar z204 = s_theta * l_lambda_along_y1 - z78;
    const Scalar z205 = c_theta * l_lambda_along_x1 - z86 + z94 * z193 - z101 * z204;
    const Scalar z206 = l_lambda_along_x1 - z64 + z89 * z193 - z97 * z204;
    const Scalar z207 = z115 * z202;
    const Scalar z208 = z116 + z115 * z207;
    const Scalar z209 = z142 - z143 * z207;
    const Scalar z210 = z191 - z192 * z207;
    const Scalar z211 = z196 - z197 * z207;
    const Scalar z212 = n1 / z208;
    const Scalar z213 = z143 * z202;
    const Scalar z214 = z146 - z143 * z213;
    const Scalar z215 = z93 * z129 + z138 * z133;
    const Scalar z216 = z215 - z164;
    const Scalar z217 = z93 * z130 + z139 * z133;
    const Scalar z218 = z217 - z180;
    const Scalar z219 = z93 * z91 + z103 * z133;
    const Scalar z220 = z203 + z219;
    const Scalar z221 = z94 * z129 + z138 * z114;
    const Scalar z222 = z89 * z129 + z138 * z104;
    const Scalar z223 = z221 - z165;
    const Scalar z224 = z222 - z166;
    const Scalar z225 = z94 * z130 + z139 * z114;
    const Scalar z226 = z89 * z130 + z139 * z104;
    const Scalar z227 = z225 - z178;
    const Scalar z228 = z226 - z179;
    const Scalar z229 = z94 * z91 + z103 * z114;
    const Scalar z230 = z89 * z91 + z103 * z104;
    const Scalar z231 = z205 - z229;
    const Scalar z232 = z206 - z230;
    const Scalar z233 = z223 - z224 * z207;
    const Scalar z234 = z200 - z201 * z207;
    const Scalar z235 = z227 - z228 * z207;
    const Scalar z236 = z209 * z212;
    const Scalar z237 = z214 + z209 * z236;
    const Scalar z238 = z185 - z192 * z213 + z236 * z210;
    const Scalar z239 = z160 - z197 * z213 + z236 * z211;
    const Scalar z240 = n1 / z237;
    const Scalar z241 = z216 - z224 * z213 + z236 * z233;
    const Scalar z242 = z188 - z201 * z213 + z236 * z234;
    const Scalar z243 = z218 - z228 * z213 + z236 * z235;
    const Scalar z244 = z240 * z238;
    const Scalar z245 = z240 * z239;
    const Scalar z246 = z240 * z241;
    const Scalar z247 = z240 * z242;
    const Scalar z248 = z240 * z243;
    const Scalar z249 = z212 * z210 - z236 * z244;
    const Scalar z250 = z212 * z211 - z236 * z245;
    const Scalar z251 = z212 * z233 - z236 * z246;
    const Scalar z252 = z212 * z234 - z236 * z247;
    const Scalar z253 = z212 * z235 - z236 * z248;
    const Scalar z254 = z192 * z202 - z213 * z244 + z207 * z249;
    const Scalar z255 = z197 * z202 - z213 * z245 + z207 * z250;
    const Scalar z256 = z224 * z202 - z213 * z246 + z207 * z251;
    const Scalar z257 = z201 * z202 - z213 * z247 + z207 * z252;
    const Scalar z258 = z228 * z202 - z213 * z248 + z207 * z253;
    result.M[0] = n1;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = n0;
    result.M[4] = n0;
    result.M[5] = n0;
    result.M[6] = n1;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n0;
    result.M[11] = n0;
    result.M[12] = -z23;
    result.M[13] = n0;
    result.M[14] = z2;
    result.M[15] = n0;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = z0;
    result.M[19] = n0;
    result.M[20] = n0;
    result.M[21] = n0;
    result.M[22] = z2;
    result.M[23] = n0;
    result.M[24] = p_C;
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
    result.C[12] = z83;
    result.C[13] = -z80;
    result.C[14] = -z30;
    result.C[15] = n0;
    result.C[16] = n0;
    result.C[17] = z81;
    result.C[18] = -z46;
    result.C[19] = -z33;
    result.C[20] = n0;
    result.C[21] = n0;
    result.C[22] = -z52;
    result.C[23] = z33;
    result.C[24] = n0;
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
    result.K[10] = z26;
    result.K[11] = -z27;
    result.K[12] = n0;
    result.K[13] = n0;
    result.K[14] = n0;
    result.K[15] = n0;
    result.K[16] = n0;
    result.K[17] = z84;
    result.K[18] = -z85;
    result.K[19] = -z58;
    result.K[20] = n0;
    result.K[21] = n0;
    result.K[22] = n0;
    result.K[23] = n0;
    result.K[24] = n0;
    result.F[0] = -a_x + c_psi * l_lambda_along_x1 - z13;
    result.F[1] = -a_y + c_psi * l_lambda_along_y1 + z12;
    result.F[2] = c_theta * l_lambda_along_x1 - z86;
    result.F[3] = s_theta * l_lambda_along_y1 - z78;
    result.F[4] = l_lambda_along_x1 - z64;
    result.M_r[0] = z146;
    result.M_r[1] = z142;
    result.M_r[2] = z143;
    result.M_r[3] = z142;
    result.M_r[4] = -z116;
    result.M_r[5] = z115;
    result.M_r[6] = z143;
    result.M_r[7] = z115;
    result.M_r[8] = z112;
    result.C_r[0] = z185;
    result.C_r[1] = z191;
    result.C_r[2] = z192;
    result.C_r[3] = z160;
    result.C_r[4] = z196;
    result.C_r[5] = z197;
    result.C_r[6] = z188;
    result.C_r[7] = z200;
    result.C_r[8] = z201;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z216;
    result.K_r[7] = z223;
    result.K_r[8] = z224;
    result.K_r[9] = -z218;
    result.K_r[10] = -z227;
    result.K_r[11] = -z228;
    result.K_r[12] = n0;
    result.K_r[13] = n0;
    result.K_r[14] = n0;
    result.F_r[0] = -z220;
    result.F_r[1] = z231;
    result.F_r[2] = z232;
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
    result.A[16] = -z90;
    result.A[17] = n0;
    result.A[18] = n0;
    result.A[19] = z102;
    result.A[20] = n0;
    result.A[21] = -z246;
    result.A[22] = z251;
    result.A[23] = -z256;
    result.A[24] = z99;
    result.A[25] = n0;
    result.A[26] = n0;
    result.A[27] = z108;
    result.A[28] = n0;
    result.A[29] = z248;
    result.A[30] = -z253;
    result.A[31] = z258;
    result.A[32] = n0;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = n0;
    result.A[37] = n0;
    result.A[38] = n0;
    result.A[39] = n0;
    result.A[40] = -z93;
    result.A[41] = n1;
    result.A[42] = n0;
    result.A[43] = -z118;
    result.A[44] = n0;
    result.A[45] = -z244;
    result.A[46] = z249;
    result.A[47] = -z254;
    result.A[48] = -z94;
    result.A[49] = n0;
    result.A[50] = n1;
    result.A[51] = -z101;
    result.A[52] = n0;
    result.A[53] = -z245;
    result.A[54] = z250;
    result.A[55] = -z255;
    result.A[56] = -z89;
    result.A[57] = n0;
    result.A[58] = n0;
    result.A[59] = -z97;
    result.A[60] = n1;
    result.A[61] = -z247;
    result.A[62] = z252;
    result.A[63] = -z257;
    if (!(traits::regular(z148, z152) && traits::regular(z87, z88) && traits::regular(z237, z146)
        && traits::regular(-z208, -z116) && traits::regular(z112, z112))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = (((n0 * result.M[12] * result.M[14] * result.M[18] * result.M[22] * result.M[24] * result.C[12]
        * result.C[13] * result.C[14] * result.C[17]) * (n0 * result.C[18] * result.C[19] * result.C[22] * result.C[23]
        * result.K[10] * result.K[11] * result.K[17] * result.K[18] * result.K[19])) * ((n0 * result.F[0] * result.F[1]
        * result.F[2] * result.F[3] * result.F[4] * result.M_r[0] * result.M_r[1] * result.M_r[2] * result.M_r[3]) * (n0
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

  /// Derivatives of inverse_dynamics at (q, v, a, lambda). That by accelerations is the mass matrix.
  TORSOR_DEVICE static void inverse_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      const Accelerations& accelerations, const Multipliers& multipliers, InverseDynamicsDerivatives& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar l_lambda_along_x1 = multipliers.lambda_along_x1;
    const Scalar l_lambda_along_y1 = multipliers.lambda_along_y1;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z0 = s_theta * v_psi;
    const Scalar z1 = c_theta * v_psi;
    const Scalar z2 = c_theta * a_psi;
    const Scalar z3 = s_theta * a_psi;
    const Scalar z4 = c_theta * v_theta;
    const Scalar z5 = s_theta * v_theta;
    const Scalar z6 = v_theta * p_C;
    const Scalar z7 = s_psi * l_lambda_along_x1 + c_psi * l_lambda_along_y1;
    const Scalar z8 = s_psi * l_lambda_along_y1 - c_psi * l_lambda_along_x1;
    const Scalar z9 = s_theta * z6;
    const Scalar z10 = c_theta * a_theta - v_theta * z5;
    const Scalar z11 = v_theta * z1 + z3;  // angular acceleration of hoop.2, y
    const Scalar z12 = v_theta * z0 - z2;  // angular acceleration of hoop.2, z
    const Scalar z13 = v_phi + z1;  // angular velocity of hoop, z
    const Scalar z14 = v_theta * z1;
    const Scalar z15 = v_theta * z0;  // angular acceleration of hoop.2, z
    const Scalar z16 = n2 * z4;
    const Scalar z17 = p_C * z4;
    const Scalar z18 = p_C * z5;
    const Scalar z19 = c_theta * z0;
    const Scalar z20 = n2 * z1;
    const Scalar z21 = p_C * z0;
    const Scalar z22 = n2 * z5;
    const Scalar z23 = s_theta * a_theta + v_theta * z4;
    const Scalar z24 = z0 * z0;
    const Scalar z25 = v_theta * z13;
    const Scalar z26 = p_C * z15;  // moment on hoop, z
    const Scalar z27 = p_A * z16 - z17;
    const Scalar z28 = s_theta * z1 + z19;
    const Scalar z29 = s_theta * z13 + z19;
    const Scalar z30 = p_C * z13;
    const Scalar z31 = c_theta * z22;
    const Scalar z32 = z1 * z1 - z24;
    const Scalar z33 = z1 * z13 - z24;
    const Scalar z34 = n9_81 + z10;
    const Scalar z35 = a_phi - z12;  // angular acceleration of hoop, z
    const Scalar z36 = z11 + z14;
    const Scalar z37 = z12 + z15;
    const Scalar z38 = p_C * z11;
    const Scalar z39 = p_C * z25;  // moment on hoop, y
    const Scalar z40 = p_A * z20 - z30;
    const Scalar z41 = p_C * z35;  // moment on hoop, z
    const Scalar z42 = s_theta * z27 - c_theta * z18;
    const Scalar z43 = p_C * z29;
    const Scalar z44 = p_A * z37 - z26;
    const Scalar z45 = p_C * z33;
    const Scalar z46 = p_A * z36 - z39;  // moment on hoop.2, y
    const Scalar z47 = p_A * z28 - z43;
    const Scalar z48 = s_theta * z40 - c_theta * z21;
    const Scalar z49 = p_A * z32 - z45;
    const Scalar z50 = s_theta * (z41 + z44) - c_theta * (z46 - z38);
    const Scalar z51 = z49 + c_theta * z23 + s_theta * z34;
    const Scalar z52 = s_theta * l_lambda_along_x1 - z50;
    const Scalar z53 = c_theta * l_lambda_along_y1 + z51;
    result.by_position[0] = n0;
    result.by_position[1] = n0;
    result.by_position[2] = n0;
    result.by_position[3] = n0;
    result.by_position[4] = n0;
    result.by_position[5] = n0;
    result.by_position[6] = n0;
    result.by_position[7] = n0;
    result.by_position[8] = n0;
    result.by_position[9] = n0;
    result.by_position[10] = z7;
    result.by_position[11] = z8;
    result.by_position[12] = n0;
    result.by_position[13] = n0;
    result.by_position[14] = n0;
    result.by_position[15] = n0;
    result.by_position[16] = n0;
    result.by_position[17] = z52;
    result.by_position[18] = -z53;
    result.by_position[19] = -z38;
    result.by_position[20] = n0;
    result.by_position[21] = n0;
    result.by_position[22] = n0;
    result.by_position[23] = n0;
    result.by_position[24] = n0;
    result.by_velocity[0] = n0;
    result.by_velocity[1] = n0;
    result.by_velocity[2] = n0;
    result.by_velocity[3] = n0;
    result.by_velocity[4] = n0;
    result.by_velocity[5] = n0;
    result.by_velocity[6] = n0;
    result.by_velocity[7] = n0;
    result.by_velocity[8] = n0;
    result.by_velocity[9] = n0;
    result.by_velocity[10] = n0;
    result.by_velocity[11] = n0;
    result.by_velocity[12] = z42;
    result.by_velocity[13] = -z47;
    result.by_velocity[14] = -z18;
    result.by_velocity[15] = n0;
    result.by_velocity[16] = n0;
    result.by_velocity[17] = z48;
    result.by_velocity[18] = -z31;
    result.by_velocity[19] = -z21;
    result.by_velocity[20] = n0;
    result.by_velocity[21] = n0;
    result.by_velocity[22] = -z9;
    result.by_velocity[23] = z21;
    result.by_velocity[24] = n0;
  }

  /// Derivatives of forward_dynamics at (q, v, u), the accelerations and multipliers being those of the motion, by
  /// solving with the factorisation of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      const Inputs&, ForwardDynamicsDerivatives& result) noexcept {
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar m0 = precomputed.m_8a68310a;
    const Scalar m1 = precomputed.m_be7541f9;
    const Scalar m2 = precomputed.m_d6343e7e;
    const Scalar m3 = precomputed.m_b4ea09ae;
    const Scalar m4 = precomputed.m_876988c5;
    const Scalar m5 = precomputed.m_e4106fa2;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z0 = c_theta * c_theta + p_A;
    const Scalar z1 = c_theta * v_psi;
    const Scalar z2 = s_theta * s_theta * p_A;
    const Scalar z3 = s_theta * v_psi;
    const Scalar z4 = v_psi * s_psi;
    const Scalar z5 = s_theta * v_theta;
    const Scalar z6 = v_psi * c_psi;
    const Scalar z7 = c_theta * p_C;
    const Scalar z8 = c_theta * v_theta;
    const Scalar z9 = v_theta * p_C;
    const Scalar z10 = s_theta * z9;
    const Scalar z11 = c_theta * m0;
    const Scalar z12 = v_x * z4 - v_y * z6 + v_psi * z5;
    const Scalar z13 = v_x * z6;
    const Scalar z14 = v_theta * z8;
    const Scalar z15 = v_phi + z1;  // angular velocity of hoop, z
    const Scalar z16 = z3 * z1;
    const Scalar z17 = v_theta * z1;
    const Scalar z18 = c_theta * z11 - p_A;
    const Scalar z19 = v_theta * z5;
    const Scalar z20 = v_theta * z3;  // angular acceleration of hoop.2, z
    const Scalar z21 = n2 * z8;
    const Scalar z22 = p_C * z8;
    const Scalar z23 = p_C * z5;
    const Scalar z24 = c_theta * z3;
    const Scalar z25 = n2 * z1;
    const Scalar z26 = p_C * z3;
    const Scalar z27 = n2 * z5;
    const Scalar z28 = z3 * z3;
    const Scalar z29 = m1 * z7;
    const Scalar z30 = n1 / z0;
    const Scalar z31 = v_y * z4 + z13 - z14;
    const Scalar z32 = z3 * z15;
    const Scalar z33 = m3 * z4;
    const Scalar z34 = v_theta * z15;
    const Scalar z35 = n9_81 - z19;
    const Scalar z36 = p_C * z20;  // moment on hoop, z
    const Scalar z37 = n2 * z17;
    const Scalar z38 = p_A * z21 - z22;
    const Scalar z39 = s_theta * z1 + z24;
    const Scalar z40 = s_theta * z15 + z24;
    const Scalar z41 = p_C * z15;
    const Scalar z42 = c_theta * z27;
    const Scalar z43 = z1 * z1 - z28;
    const Scalar z44 = z1 * z15 - z28;
    const Scalar z45 = n1 / z2;
    const Scalar z46 = p_C * z32;  // moment on hoop, x
    const Scalar z47 = p_C * z34;  // moment on hoop, y
    const Scalar z48 = m1 * z33;
    const Scalar z49 = c_psi * m3;
    const Scalar z50 = m3 * z6;
    const Scalar z51 = m1 * z50;
    const Scalar z52 = p_A * z25 - z41;
    const Scalar z53 = p_C * z40;
    const Scalar z54 = p_C * z44;
    const Scalar z55 = p_A * z16 - z46;  // moment on hoop.2, x
    const Scalar z56 = s_psi * m3;
    const Scalar z57 = p_A * z37 - z47;  // moment on hoop.2, y
    const Scalar z58 = p_A * z39 - z53;
    const Scalar z59 = p_A * z43 - z54;
    const Scalar z60 = c_theta * z35 - z55;
    const Scalar z61 = v_y * z4 + z13;
    const Scalar z62 = s_theta * z38;
    const Scalar z63 = v_y * c_psi;
    const Scalar z64 = v_psi * (v_x * s_psi - z63);
    const Scalar z65 = v_x * s_psi - z63;
    const Scalar z66 = v_x * c_psi + v_y * s_psi;
    const Scalar z67 = m3 * z65;
    const Scalar z68 = s_theta * z57;
    const Scalar z69 = s_theta * z30;
    const Scalar z70 = z58 * z30;
    const Scalar z71 = z45 * z68;
    const Scalar z72 = z45 * z62;
    const Scalar z73 = z29 * z45;
    const Scalar z74 = n1 + s_theta * z69;
    const Scalar z75 = z60 * z30;
    const Scalar z76 = s_theta * z70 - z66;
    const Scalar z77 = m1 * z36 + z29 * z71;
    const Scalar z78 = m1 * z23 + z29 * z72;
    const Scalar z79 = c_theta * z71;
    const Scalar z80 = s_theta * z75 + z31;
    const Scalar z81 = n1 / z74;
    const Scalar z82 = m2 + z74;
    const Scalar z83 = z20 + z79;  // angular acceleration of hoop.2, z
    const Scalar z84 = c_theta * z71 + z12 - z77;
    const Scalar z85 = m1 * z67 + z78;
    const Scalar z86 = s_theta * z71;
    const Scalar z87 = z17 - z86;  // angular acceleration of hoop.2, y
    const Scalar z88 = z20 + z83;
    const Scalar z89 = m3 * z84;
    const Scalar z90 = z17 + z87;
    const Scalar z91 = p_A * z88 - z36;
    const Scalar z92 = m1 * z89 + z77;
    const Scalar z93 = z92 - z83;  // angular acceleration of hoop, z
    const Scalar z94 = z81 * z80;
    const Scalar z95 = p_A * z90 - z47;  // moment on hoop.2, y
    const Scalar z96 = p_C * z87;
    const Scalar z97 = z6 * z81;
    const Scalar z98 = s_psi * z81;
    const Scalar z99 = z4 * z81;
    const Scalar z100 = c_psi * z81;
    const Scalar z101 = z81 * z64;
    const Scalar z102 = z81 * z76;
    const Scalar z103 = p_C * z93;  // moment on hoop, z
    const Scalar z104 = s_psi * z94 - c_psi * z89;
    const Scalar z105 = s_psi * z89 + c_psi * z94;
    const Scalar z106 = n1 - c_psi * z49 - s_psi * z98;
    const Scalar z107 = s_theta * (z103 + z91) - c_theta * (z95 - z96);
    const Scalar z108 = z69 * z102 - z70;
    const Scalar z109 = z69 * z94 - z75;
    const Scalar z110 = s_theta * z109 + z14;
    const Scalar z111 = c_theta * z109 - z19;
    const Scalar z112 = c_psi * z105 - z61 + s_psi * z104;
    const Scalar z113 = s_psi * z97 - c_psi * z33;
    const Scalar z114 = s_theta * z89 - z107;
    const Scalar z115 = s_psi * z33 + c_psi * z97;
    const Scalar z116 = z69 * z97;
    const Scalar z117 = c_psi * z105 - z112 + s_psi * z104;
    const Scalar z118 = z29 * z96 + z114;
    const Scalar z119 = c_psi * z50 + s_psi * z99;
    const Scalar z120 = s_psi * z50 - c_psi * z99;
    const Scalar z121 = z69 * z99;
    const Scalar z122 = z42 * z30;
    const Scalar z123 = s_theta * z122 + z21;
    const Scalar z124 = m3 * z117;
    const Scalar z125 = s_psi * z101 - z105 + c_psi * z124;
    const Scalar z126 = s_psi * z124 - z104 - c_psi * z101;
    const Scalar z127 = z69 * z101;
    const Scalar z128 = m1 * z124;
    const Scalar z129 = s_theta * z52;
    const Scalar z130 = z45 * z118;
    const Scalar z131 = m1 * z96 + z29 * z130;
    const Scalar z132 = n9_81 + z111;
    const Scalar z133 = z59 + c_theta * z110 + s_theta * z132;
    const Scalar z134 = z45 * z129;
    const Scalar z135 = z81 * z123;
    const Scalar z136 = s_psi * z100 - c_psi * z56;
    const Scalar z137 = c_theta * z94 + z133;
    const Scalar z138 = n1 - s_psi * z56 - c_psi * z100;
    const Scalar z139 = z26 * z30;
    const Scalar z140 = z30 * z137;
    const Scalar z141 = s_theta / z0;
    const Scalar z142 = s_theta * z139;
    const Scalar z143 = z81 * z141;
    const Scalar z144 = z10 * z45;
    const Scalar z145 = m1 + z29 * z73;
    const Scalar z146 = s_theta * z140 + z111;
    const Scalar z147 = z81 * z142;
    const Scalar z148 = c_psi * z67 + s_psi * z102;
    const Scalar z149 = s_psi * z67 - c_psi * z102;
    const Scalar z150 = z81 * z146;
    const Scalar z151 = m1 * z26 + z29 * z134;
    const Scalar z152 = s_psi * z150;
    const Scalar z153 = c_psi * z150;
    const Scalar z154 = z69 * z150 - z140;
    const Scalar z155 = s_psi * z135;
    const Scalar z156 = c_psi * z135;
    const Scalar z157 = s_psi * z143;
    const Scalar z158 = c_psi * z143;
    const Scalar z159 = z30 - z69 * z143;
    const Scalar z160 = z29 * z144;
    const Scalar z161 = s_psi * z147;
    const Scalar z162 = c_psi * z147;
    const Scalar z163 = z69 * z147 - z139;
    const Scalar z164 = c_psi * m4;
    const Scalar z165 = s_psi * m4;
    const Scalar z166 = m5 - z145;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    result.by_position[0] = n0;
    result.by_position[1] = n0;
    result.by_position[2] = n0;
    result.by_position[3] = n0;
    result.by_position[4] = n0;
    result.by_position[5] = n0;
    result.by_position[6] = n0;
    result.by_position[7] = n0;
    result.by_position[8] = n0;
    result.by_position[9] = n0;
    result.by_position[10] = z125;
    result.by_position[11] = z126;
    result.by_position[12] = n0;
    result.by_position[13] = -z127;
    result.by_position[14] = z128;
    result.by_position[15] = z152;
    result.by_position[16] = -z153;
    result.by_position[17] = -z130;
    result.by_position[18] = -z154;
    result.by_position[19] = z131;
    result.by_position[20] = n0;
    result.by_position[21] = n0;
    result.by_position[22] = n0;
    result.by_position[23] = n0;
    result.by_position[24] = n0;
    result.by_velocity[0] = -z113;
    result.by_velocity[1] = z115;
    result.by_velocity[2] = n0;
    result.by_velocity[3] = z116;
    result.by_velocity[4] = z48;
    result.by_velocity[5] = -z119;
    result.by_velocity[6] = -z120;
    result.by_velocity[7] = n0;
    result.by_velocity[8] = z121;
    result.by_velocity[9] = -z51;
    result.by_velocity[10] = z148;
    result.by_velocity[11] = z149;
    result.by_velocity[12] = -z72;
    result.by_velocity[13] = -z108;
    result.by_velocity[14] = z85;
    result.by_velocity[15] = z155;
    result.by_velocity[16] = -z156;
    result.by_velocity[17] = -z134;
    result.by_velocity[18] = n0;
    result.by_velocity[19] = z151;
    result.by_velocity[20] = -z161;
    result.by_velocity[21] = z162;
    result.by_velocity[22] = z144;
    result.by_velocity[23] = z163;
    result.by_velocity[24] = -z160;
    result.by_force[0] = z106;
    result.by_force[1] = z136;
    result.by_force[2] = n0;
    result.by_force[3] = z157;
    result.by_force[4] = -z164;
    result.by_force[5] = z136;
    result.by_force[6] = z138;
    result.by_force[7] = n0;
    result.by_force[8] = -z158;
    result.by_force[9] = -z165;
    result.by_force[10] = n0;
    result.by_force[11] = n0;
    result.by_force[12] = z45;
    result.by_force[13] = n0;
    result.by_force[14] = -z73;
    result.by_force[15] = z157;
    result.by_force[16] = -z158;
    result.by_force[17] = n0;
    result.by_force[18] = z159;
    result.by_force[19] = n0;
    result.by_force[20] = -z164;
    result.by_force[21] = -z165;
    result.by_force[22] = -z73;
    result.by_force[23] = n0;
    result.by_force[24] = -z166;
    result.multipliers_by_position[0] = n0;
    result.multipliers_by_position[1] = n0;
    result.multipliers_by_position[2] = n0;
    result.multipliers_by_position[3] = n0;
    result.multipliers_by_position[4] = z124;
    result.multipliers_by_position[5] = -z101;
    result.multipliers_by_position[6] = n0;
    result.multipliers_by_position[7] = -z150;
    result.multipliers_by_position[8] = n0;
    result.multipliers_by_position[9] = n0;
    result.multipliers_by_velocity[0] = z33;
    result.multipliers_by_velocity[1] = z97;
    result.multipliers_by_velocity[2] = -z50;
    result.multipliers_by_velocity[3] = z99;
    result.multipliers_by_velocity[4] = z67;
    result.multipliers_by_velocity[5] = -z102;
    result.multipliers_by_velocity[6] = n0;
    result.multipliers_by_velocity[7] = -z135;
    result.multipliers_by_velocity[8] = n0;
    result.multipliers_by_velocity[9] = z147;
    result.multipliers_by_force[0] = -z49;
    result.multipliers_by_force[1] = z98;
    result.multipliers_by_force[2] = -z56;
    result.multipliers_by_force[3] = -z100;
    result.multipliers_by_force[4] = n0;
    result.multipliers_by_force[5] = n0;
    result.multipliers_by_force[6] = n0;
    result.multipliers_by_force[7] = -z143;
    result.multipliers_by_force[8] = -m4;
    result.multipliers_by_force[9] = n0;
    const Scalar bound0_ = roundings_ * z82;
    if (!(traits::regular(z2, -z18) && traits::regular(z0, z0) && traits::regular(p_C, p_C) && traits::regular(m2,
        bound0_) && traits::regular(z74, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((n0 * result.by_position[10] * result.by_position[11] * result.by_position[13]
        * result.by_position[14] * result.by_position[15] * result.by_position[16] * result.by_position[17]
        * result.by_position[18] * result.by_position[19] * result.by_velocity[0] * result.by_velocity[1]
        * result.by_velocity[3] * result.by_velocity[4] * result.by_velocity[5] * result.by_velocity[6]
        * result.by_velocity[8]) * (n0 * result.by_velocity[9] * result.by_velocity[10] * result.by_velocity[11]
        * result.by_velocity[12] * result.by_velocity[13] * result.by_velocity[14] * result.by_velocity[15]
        * result.by_velocity[16] * result.by_velocity[17] * result.by_velocity[19] * result.by_velocity[20]
        * result.by_velocity[21] * result.by_velocity[22] * result.by_velocity[23] * result.by_velocity[24]
        * result.by_force[0])) * ((n0 * result.by_force[1] * result.by_force[3] * result.by_force[4]
        * result.by_force[5] * result.by_force[6] * result.by_force[8] * result.by_force[9] * result.by_force[12]
        * result.by_force[14] * result.by_force[15] * result.by_force[16] * result.by_force[18] * result.by_force[20]
        * result.by_force[21] * result.by_force[22] * result.by_force[24]) * ((n0 * result.multipliers_by_position[4]
        * result.multipliers_by_position[5] * result.multipliers_by_position[7] * result.multipliers_by_velocity[0]
        * result.multipliers_by_velocity[1] * result.multipliers_by_velocity[2] * result.multipliers_by_velocity[3]
        * result.multipliers_by_velocity[4]) * (n0 * result.multipliers_by_velocity[5]
        * result.multipliers_by_velocity[7] * result.multipliers_by_velocity[9] * result.multipliers_by_force[0]
        * result.multipliers_by_force[1] * result.multipliers_by_force[2] * result.multipliers_by_force[3]
        * result.multipliers_by_force[7] * result.multipliers_by_force[8])));
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics_derivatives(const Precomputed& precomputed, const State& state,
      ForwardDynamicsDerivatives& result) noexcept {
    return Mechanism::forward_dynamics_derivatives(precomputed, state, Inputs(), result);
  }

  /// Taylor coefficients of the motion: coefficients[k] = y^(k)/k! for k = 0..order, 1 <= order <= 30, y positions
  /// then velocities, the inputs being constant. 32 operations take a convolution at each order.
  /// Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed& precomputed, const State& state, const Inputs&, int order,
      std::array<Scalar, 10>* coefficients) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar m0 = precomputed.m_8a68310a;
    const Scalar m1 = precomputed.m_be7541f9;
    const Scalar m2 = precomputed.m_d6343e7e;
    const Scalar m3 = precomputed.m_b4ea09ae;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z0 = c_theta * c_theta + p_A;
    const Scalar z1 = c_theta * m0;
    const Scalar z2 = s_theta * s_theta * p_A;
    const Scalar z3 = c_theta * z1 - p_A;
    const Scalar z4 = n1 / z0;
    const Scalar z5 = s_theta * z4;
    const Scalar z6 = n1 + s_theta * z5;
    const Scalar z7 = m2 + z6;
    const Scalar b5 = state.v.theta;
    const Scalar b9 = state.v.psi;
    const Scalar b16 = c_theta * c_theta;
    const Scalar b17 = p_A + b16;
    const Scalar i18 = n1 / b17;
    const Scalar i19 = n1 / b17;
    const Scalar f0 = precomputed.m_74dc511b;
    const Scalar f1 = precomputed.m_249c8b11;
    const Scalar f2 = precomputed.m_4cbeeeaa;
    const Scalar b12 = state.v.phi;
    const Scalar b15 = c_theta * b9;
    const Scalar b21 = f1 * b12 - f2 * b15;
    const Scalar b22 = b5 * b21;
    const Scalar b23 = b22 / s_theta;
    const Scalar i23 = n1 / s_theta;
    const Scalar f3 = precomputed.m_e5f5debb;
    const Scalar b24 = p_C * b12 - f3 * b15;
    const Scalar b25 = b9 * b24;
    const Scalar b6 = c_theta * b5;
    const Scalar b7 = s_theta * b5;
    const Scalar b27 = b6 * b7;
    const Scalar b26 = s_theta * b25;
    const Scalar b28 = n9_81 * c_theta - b27 + b26;
    const Scalar b29 = b28 / b17;
    const Scalar i29 = n1 / b17;
    const Scalar f4 = precomputed.m_b58c0c23;
    const Scalar b13 = b9 * s_psi;
    const Scalar b0 = state.v.x;
    const Scalar b14 = b9 * c_psi;
    const Scalar b1 = state.v.y;
    const Scalar b36 = b0 * b14;
    const Scalar b37 = b1 * b13;
    const Scalar b38 = b5 * b6;
    const Scalar b35 = s_theta * b29;
    const Scalar b39 = b36 + b37 - b38 + b35;
    const Scalar b20 = f0 * z4;
    const Scalar b40 = b39 / b20;
    const Scalar i40 = n1 / b20;
    const Scalar f5 = precomputed.m_1e49e888;
    const Scalar b30 = b7 * b9;
    const Scalar b33 = b0 * b13;
    const Scalar b34 = b1 * b14;
    const Scalar b31 = c_theta * b23;
    const Scalar b41 = f5 * b30 - m3 * b33 + m3 * b34 - f5 * b31;
    const Scalar b43 = c_psi * b41;
    const Scalar b42 = s_psi * b40;
    const Scalar b44 = s_psi * b41;
    const Scalar b45 = c_psi * b40;
    const Scalar b46 = z5 * b40;
    const Scalar b32 = f4 * b30 - f4 * b31;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    coefficients[0][0] = state.q.x;
    coefficients[0][1] = state.q.y;
    coefficients[0][2] = state.q.psi;
    coefficients[0][3] = state.q.theta;
    coefficients[0][4] = state.q.phi;
    coefficients[0][5] = state.v.x;
    coefficients[0][6] = state.v.y;
    coefficients[0][7] = state.v.psi;
    coefficients[0][8] = state.v.theta;
    coefficients[0][9] = state.v.phi;
    coefficients[1][0] = b0;
    coefficients[1][1] = b1;
    coefficients[1][2] = b9;
    coefficients[1][3] = b5;
    coefficients[1][4] = b12;
    coefficients[1][5] = -b43 - b42;
    coefficients[1][6] = -b44 + b45;
    coefficients[1][7] = b23;
    coefficients[1][8] = -b29 + b46;
    coefficients[1][9] = b32 - m1 * b41;
    torsor::Convolutions<Scalar, 32> operations_;
    typename torsor::Convolutions<Scalar, 32>::Sums sums_;
    Scalar number_ = n1, inverse_ = n1;
    for (int k_ = 1; k_ < order; ++k_) {
      const Scalar following_ = number_ + n1, next_ = n1 / following_;
      operations_.sum(k_, sums_);
      const Scalar x0 = coefficients[k_][5];
      const Scalar x1 = coefficients[k_][6];
      const Scalar x2 = coefficients[k_][3];
      const Scalar x3 = inverse_ * sums_[0] + c_theta * x2;
      const Scalar w2 = number_ * x2;
      const Scalar x4 = -inverse_ * sums_[1] - s_theta * x2;
      const Scalar x5 = coefficients[k_][8];
      const Scalar x6 = sums_[2] + c_theta * x5 + b5 * x4;
      const Scalar x7 = sums_[3] + s_theta * x5 + b5 * x3;
      const Scalar x8 = coefficients[k_][2];
      const Scalar x9 = coefficients[k_][7];
      const Scalar x10 = inverse_ * sums_[4] + c_psi * x8;
      const Scalar w8 = number_ * x8;
      const Scalar x11 = -inverse_ * sums_[5] - s_psi * x8;
      const Scalar x12 = coefficients[k_][9];
      const Scalar x13 = sums_[6] + s_psi * x9 + b9 * x10;
      const Scalar x14 = sums_[7] + c_psi * x9 + b9 * x11;
      const Scalar x15 = sums_[8] + c_theta * x9 + b9 * x4;
      const Scalar x16 = sums_[9] + (c_theta + c_theta) * x4;
      const Scalar x17 = x16;
      const Scalar x18 = -(sums_[10] + z4 * x17) * i18;
      const Scalar x19 = (x3 - sums_[11] - z5 * x17) * i19;
      const Scalar x20 = f0 * x18;
      const Scalar x21 = f1 * x12 - f2 * x15;
      const Scalar x22 = sums_[12] + b21 * x5 + b5 * x21;
      const Scalar x23 = (x22 - (sums_[13] + b23 * x3)) * i23;
      const Scalar x24 = p_C * x12 - f3 * x15;
      const Scalar x25 = sums_[14] + b24 * x9 + b9 * x24;
      const Scalar x26 = sums_[15] + b25 * x3 + s_theta * x25;
      const Scalar x27 = sums_[16] + b6 * x7 + b7 * x6;
      const Scalar x28 = n9_81 * x4 - x27 + x26;
      const Scalar x29 = (x28 - (sums_[17] + b29 * x17)) * i29;
      const Scalar x30 = sums_[18] + b7 * x9 + b9 * x7;
      const Scalar x31 = sums_[19] + b23 * x4 + c_theta * x23;
      const Scalar x32 = f4 * x30 - f4 * x31;
      const Scalar x33 = sums_[20] + b13 * x0 + b0 * x13;
      const Scalar x34 = sums_[21] + b14 * x1 + b1 * x14;
      const Scalar x35 = sums_[22] + b29 * x3 + s_theta * x29;
      const Scalar x36 = sums_[23] + b14 * x0 + b0 * x14;
      const Scalar x37 = sums_[24] + b13 * x1 + b1 * x13;
      const Scalar x38 = sums_[25] + b6 * x5 + b5 * x6;
      const Scalar x39 = x36 + x37 - x38 + x35;
      const Scalar x40 = (x39 - (sums_[26] + b40 * x20)) * i40;
      const Scalar x41 = f5 * x30 - m3 * x33 + m3 * x34 - f5 * x31;
      const Scalar x42 = sums_[27] + b40 * x10 + s_psi * x40;
      const Scalar x43 = sums_[28] + b41 * x11 + c_psi * x41;
      const Scalar x44 = sums_[29] + b41 * x10 + s_psi * x41;
      const Scalar x45 = sums_[30] + b40 * x11 + c_psi * x40;
      const Scalar x46 = sums_[31] + b40 * x19 + z5 * x40;
      coefficients[k_ + 1][0] = next_ * x0;
      coefficients[k_ + 1][1] = next_ * x1;
      coefficients[k_ + 1][2] = next_ * x9;
      coefficients[k_ + 1][3] = next_ * x5;
      coefficients[k_ + 1][4] = next_ * x12;
      coefficients[k_ + 1][5] = next_ * (-x43 - x42);
      coefficients[k_ + 1][6] = next_ * (-x44 + x45);
      coefficients[k_ + 1][7] = next_ * x23;
      coefficients[k_ + 1][8] = next_ * (-x29 + x46);
      coefficients[k_ + 1][9] = next_ * (x32 - m1 * x41);
      const Scalar left_[] = {w2, w2, x4, x3, w8, w8, x9, x9, x4, x4, x18, x19, x5, x23, x9, x3, x6, x29, x7, x4, x0,
        x1, x3, x0, x1, x5, x40, x10, x11, x10, x11, x19};
      const Scalar right_[] = {x4, x3, x5, x5, x11, x10, x10, x11, x9, x4, x17, x17, x21, x3, x24, x25, x7, x17, x9,
        x23, x13, x14, x29, x14, x13, x6, x20, x40, x41, x41, x40, x40};
      operations_.keep(k_, left_, right_);
      number_ = following_;
      inverse_ = next_;
    }
    static_cast<void>(inverse_);
    const Scalar bound0_ = roundings_ * z7;
    if (!(traits::regular(z2, -z3) && traits::regular(z0, z0) && traits::regular(p_C, p_C) && traits::regular(m2,
        bound0_) && traits::regular(z6, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * coefficients[order][0] * coefficients[order][1] * coefficients[order][2]
        * coefficients[order][3] * coefficients[order][4] * coefficients[order][5] * coefficients[order][6]
        * coefficients[order][7] * coefficients[order][8] * coefficients[order][9];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status jets(const Precomputed& precomputed, const State& state, int order,
      std::array<Scalar, 10>* coefficients) noexcept {
    return Mechanism::jets(precomputed, state, Inputs(), order, coefficients);
  }

  /// Jacobian A(q, t) of the constraints without the entries that vanish identically: `values` of compressed rows.
  TORSOR_DEVICE static void sparse_constraint_jacobian(const Precomputed&, const State& state,
      SparseConstraintJacobian& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar q_theta = state.q.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    result.values[0] = c_psi;
    result.values[1] = s_psi;
    result.values[2] = c_theta;
    result.values[3] = n1;
    result.values[4] = -s_psi;
    result.values[5] = c_psi;
    result.values[6] = s_theta;
  }

  /// Derivatives of inverse_dynamics by the run-time parameters p at fixed (q, v, a, lambda).
  TORSOR_DEVICE static void inverse_dynamics_sensitivities(const Precomputed&, const State& state,
      const Accelerations& accelerations, const Multipliers&, InverseDynamicsSensitivities& result) noexcept {
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar a_theta = accelerations.theta;
    const Scalar v_psi = state.v.psi;
    const Scalar a_psi = accelerations.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar a_phi = accelerations.phi;
    Scalar s_theta, c_theta;
    traits::sincos(q_theta, s_theta, c_theta);
    const Scalar z0 = c_theta * v_psi;
    const Scalar z1 = s_theta * v_psi;
    const Scalar z2 = c_theta * a_psi;
    const Scalar z3 = s_theta * a_psi;
    const Scalar z4 = v_theta * z0 + z3;  // angular acceleration of hoop.2, y
    const Scalar z5 = v_theta * z1 - z2;  // angular acceleration of hoop.2, z
    const Scalar z6 = v_phi + z0;  // angular velocity of hoop, z
    const Scalar z7 = z1 * z0;
    const Scalar z8 = v_theta * z0;
    const Scalar z9 = z1 * z6;
    const Scalar z10 = v_theta * z6;
    const Scalar z11 = a_theta - z7;
    const Scalar z12 = a_phi - z5;  // angular acceleration of hoop, z
    const Scalar z13 = z4 + z8;
    const Scalar z14 = s_theta * z13;
    const Scalar z15 = s_theta * z10 - c_theta * z12;
    result.by_parameter[0] = n0;
    result.by_parameter[1] = n0;
    result.by_parameter[2] = z14;
    result.by_parameter[3] = z11;
    result.by_parameter[4] = n0;
    result.by_parameter[5] = n0;
    result.by_parameter[6] = n0;
    result.by_parameter[7] = -z15;
    result.by_parameter[8] = z9;
    result.by_parameter[9] = z12;
  }

  /// Derivatives of forward_dynamics by the run-time parameters p at fixed (q, v, u), the accelerations and
  /// multipliers being those of the motion. Returns singular where forward_dynamics does.
  TORSOR_DEVICE static torsor::Status forward_dynamics_sensitivities(const Precomputed& precomputed, const State& state,
      const Inputs&, ForwardDynamicsSensitivities& result) noexcept {
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar v_x = state.v.x;
    const Scalar v_y = state.v.y;
    const Scalar q_theta = state.q.theta;
    const Scalar v_theta = state.v.theta;
    const Scalar q_psi = state.q.psi;
    const Scalar v_psi = state.v.psi;
    const Scalar v_phi = state.v.phi;
    const Scalar p_A = precomputed.parameters.A;
    const Scalar p_C = precomputed.parameters.C;
    const Scalar m0 = precomputed.m_8a68310a;
    const Scalar m1 = precomputed.m_be7541f9;
    const Scalar m2 = precomputed.m_d6343e7e;
    const Scalar m3 = precomputed.m_b4ea09ae;
    const Scalar angles_[] = {q_theta, q_psi};
    Scalar sines_[2], cosines_[2];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_theta = sines_[0], c_theta = cosines_[0];
    const Scalar s_psi = sines_[1], c_psi = cosines_[1];
    const Scalar z0 = c_theta * v_psi;
    const Scalar z1 = s_theta * s_theta * p_A;
    const Scalar z2 = v_psi * s_psi;
    const Scalar z3 = c_theta * c_theta + p_A;
    const Scalar z4 = s_theta * v_psi;
    const Scalar z5 = v_psi * c_psi;
    const Scalar z6 = s_theta * v_theta;
    const Scalar z7 = c_theta * p_C;
    const Scalar z8 = c_theta * v_theta;
    const Scalar z9 = c_theta * m0;
    const Scalar z10 = v_theta * z6;
    const Scalar z11 = v_theta * z0;  // angular acceleration of hoop.2, y
    const Scalar z12 = v_theta * z4;  // angular acceleration of hoop.2, z
    const Scalar z13 = v_phi + z0;  // angular velocity of hoop, z
    const Scalar z14 = z4 * z0;
    const Scalar z15 = v_x * z2 - v_y * z5 + v_psi * z6;
    const Scalar z16 = v_x * z5 + v_y * z2 - v_theta * z8;
    const Scalar z17 = c_theta * z9 - p_A;
    const Scalar z18 = m1 * z7;
    const Scalar z19 = n1 / z3;
    const Scalar z20 = n9_81 - z10;
    const Scalar z21 = z4 * z13;
    const Scalar z22 = v_theta * z13;
    const Scalar z23 = p_C * z12;  // moment on hoop, z
    const Scalar z24 = n2 * z11;
    const Scalar z25 = n1 / z1;
    const Scalar z26 = p_C * z21;  // moment on hoop, x
    const Scalar z27 = p_C * z22;  // moment on hoop, y
    const Scalar z28 = p_A * z14 - z26;  // moment on hoop.2, x
    const Scalar z29 = p_A * z24 - z27;  // moment on hoop.2, y
    const Scalar z30 = c_theta * z20 - z28;
    const Scalar z31 = s_theta * z29;
    const Scalar z32 = s_theta * z19;
    const Scalar z33 = z21 * z19;
    const Scalar z34 = z25 * z31;
    const Scalar z35 = n1 + s_theta * z32;
    const Scalar z36 = z30 * z19;
    const Scalar z37 = s_theta * z33;
    const Scalar z38 = m1 * z23 + z18 * z34;
    const Scalar z39 = s_theta * z34;
    const Scalar z40 = c_theta * z34;
    const Scalar z41 = s_theta * z36 + z16;
    const Scalar z42 = n1 / z35;
    const Scalar z43 = m2 + z35;
    const Scalar z44 = z11 - z39;  // angular acceleration of hoop.2, y
    const Scalar z45 = z12 + z40;  // angular acceleration of hoop.2, z
    const Scalar z46 = c_theta * z34 + z15 - z38;
    const Scalar z47 = z11 + z44;
    const Scalar z48 = m3 * z46;
    const Scalar z49 = s_theta * z47;
    const Scalar z50 = m1 * z48 + z38;
    const Scalar z51 = z25 * z49;
    const Scalar z52 = z50 - z45;  // angular acceleration of hoop, z
    const Scalar z53 = z42 * z41;
    const Scalar z54 = z18 * z51;
    const Scalar z55 = z42 * z37;
    const Scalar z56 = s_theta * z22 - c_theta * z52;
    const Scalar z57 = z32 * z53 - z36;
    const Scalar z58 = z32 * z55 - z33;
    const Scalar z59 = z18 * z52 + z56;
    const Scalar z60 = z14 - z57;
    const Scalar z61 = z19 * z60;
    const Scalar z62 = z25 * z59;
    const Scalar z63 = s_theta * z61;
    const Scalar z64 = m1 * z52 + z18 * z62;
    const Scalar z65 = z42 * z63;
    const Scalar z66 = c_theta * z62 - z64;
    const Scalar z67 = s_psi * z65;
    const Scalar z68 = c_psi * z65;
    const Scalar z69 = z32 * z65 - z61;
    const Scalar z70 = m3 * z66;
    const Scalar z71 = s_psi * z55 + c_psi * z70;
    const Scalar z72 = s_psi * z70 - c_psi * z55;
    const Scalar z73 = m1 * z70 + z64;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    result.by_parameter[0] = z67;
    result.by_parameter[1] = -z68;
    result.by_parameter[2] = -z51;
    result.by_parameter[3] = -z69;
    result.by_parameter[4] = z54;
    result.by_parameter[5] = -z71;
    result.by_parameter[6] = -z72;
    result.by_parameter[7] = z62;
    result.by_parameter[8] = z58;
    result.by_parameter[9] = -z73;
    result.multipliers_by_parameter[0] = n0;
    result.multipliers_by_parameter[1] = -z65;
    result.multipliers_by_parameter[2] = -z70;
    result.multipliers_by_parameter[3] = z55;
    const Scalar bound0_ = roundings_ * z43;
    if (!(traits::regular(z1, -z17) && traits::regular(z3, z3) && traits::regular(p_C, p_C) && traits::regular(m2,
        bound0_) && traits::regular(z35, bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * result.by_parameter[0] * result.by_parameter[1] * result.by_parameter[2]
        * result.by_parameter[3] * result.by_parameter[4] * result.by_parameter[5] * result.by_parameter[6]
        * result.by_parameter[7] * result.by_parameter[8] * result.by_parameter[9] * result.multipliers_by_parameter[1]
        * result.multipliers_by_parameter[2] * result.multipliers_by_parameter[3];
    if (!traits::finite(zero)) return torsor::Status::not_finite;
    return torsor::Status::ok;
  }

  /// The same for this mechanism, which has nothing in the arguments left out.
  TORSOR_DEVICE static torsor::Status forward_dynamics_sensitivities(const Precomputed& precomputed, const State& state,
      ForwardDynamicsSensitivities& result) noexcept {
    return Mechanism::forward_dynamics_sensitivities(precomputed, state, Inputs(), result);
  }

  /// A kernel with all its arguments.
  template <class Code, class... Arguments>
  using KernelFunction = Code (*)(const Precomputed&, const State&, Arguments...) noexcept;

  /// Calls visitor(description, function) for each kernel: whatever walks them meets a new one by itself.
  template <class Visitor>
  static constexpr void for_each_kernel(Visitor&& visitor) {
    static_cast<void>(visitor);
    visitor(Description::kernels[0], KernelFunction<void, Kinematics&>(kinematics));
    visitor(Description::kernels[1], KernelFunction<void, std::array<Scalar, 25>&>(mass_matrix));
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
    visitor(Description::kernels[9],
        KernelFunction<void, const Accelerations&, const Multipliers&, InverseDynamicsDerivatives&>(inverse_dynamics_derivatives));
    visitor(Description::kernels[10],
        KernelFunction<torsor::Status, const Inputs&, ForwardDynamicsDerivatives&>(forward_dynamics_derivatives));
    visitor(Description::kernels[11],
        KernelFunction<torsor::Status, const Inputs&, int, std::array<Scalar, 10>*>(jets));
    visitor(Description::kernels[12], KernelFunction<void, SparseConstraintJacobian&>(sparse_constraint_jacobian));
    visitor(Description::kernels[13],
        KernelFunction<void, const Accelerations&, const Multipliers&, InverseDynamicsSensitivities&>(inverse_dynamics_sensitivities));
    visitor(Description::kernels[14],
        KernelFunction<torsor::Status, const Inputs&, ForwardDynamicsSensitivities&>(forward_dynamics_sensitivities));
  }
};

}  // namespace rolling_hoop
