// SPDX-License-Identifier: MIT-0
// whipple_bicycle: Whipple's bicycle: two rolling wheels, benchmark of 2007
// Made by torsor 0.1.0; change the scene and write the file again, do not edit it.
// Free to embed, and nothing is asked for it: MIT-0.
//
// Kernels: mass_matrix, forward_dynamics, energy, first_integrals, constraints, linearisation
// Parameters set at run time: none
//
// Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status
// costs, one multiplication for each result and for each pivot tested); before: without products that sums
// share, factoring, and what is done once for a set of parameters:
//   function          additions  multiplications  divisions  square roots  sine-cosine pairs  others  total  before
//   mass_matrix              42               73          0             0                  4       0    123     123
//   forward_dynamics        945             1311         31             2                  5       0   2299    2351
//   energy                  109              161          0             0                  6       0    282     302
//   first_integrals         110              161          0             0                  6       0    283     303
//   constraints             279              464         14             2                  4       0    767     812
//   linearisation          2405             3176        104             2                  7       0   5701    5994
//
// Not computed because this mechanism does not need it:
//   mass_matrix: of 81 results 28 vanish identically, 21 repeat another up to sign
//   energy: of 3 results 1 vanish identically
//   constraints: of 72 results 30 vanish identically, 2 repeat another up to sign
//   linearisation: of 394 results 187 vanish identically, 26 repeat another up to sign
//
// Frames: in here links have their own, in which turns between joints cost less (--without reframing: those of the
// scene). Coordinates, inputs, parameters and results are those of the scene. An angle to which a constant is added
// is rounded once more than its coordinate, by half a unit in the last place of the sum.
// Of the constants 4 directions and angles are irrational: rational numbers stand for them, within 1e-80 rad each.
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
  static constexpr std::array<torsor::ResultDescription, 20> results{{{"mass", "", 9, 9, 2, ""}, {"accelerations", "",
      9, 1, 1, "m/s^2, m/s^2, m/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2, rad/s^2"}, {"multipliers", "", 6, 1,
      1, "N"}, {"result", "kinetic", 1, 1, 0, "J"}, {"result", "force_function", 1, 1, 0, "J"}, {"result", "power", 1,
      1, 0, "W"}, {"result", "energy", 1, 1, 0, "J"}, {"result", "value", 6, 1, 1, "m"}, {"result", "rate", 6, 1, 1,
      "m/s"}, {"result", "jacobian", 6, 9, 2, ""}, {"result", "gamma", 6, 1, 1, "m/s^2"}, {"result", "M", 9, 9, 2, ""},
      {"result", "C", 9, 9, 2, ""}, {"result", "K", 9, 9, 2, ""}, {"result", "F", 9, 1, 1,
      "N, N, N, N m, N m, N m, N m, N m, N m"}, {"result", "M_r", 3, 3, 2, "kg m^2"}, {"result", "C_r", 3, 3, 2,
      "N m s"}, {"result", "K_r", 3, 7, 2, "N m"}, {"result", "F_r", 3, 1, 1, "N m"}, {"result", "A", 10, 10, 2, ""}}};
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
  static constexpr unsigned long long fingerprint = 0x03c4a752a7367cfdULL ^ torsor::support_fingerprint;
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
  static constexpr int independent_coordinates[7] = {0, 1, 3, 4, 6, 7, 8};
  /// Velocities that w of the linearisation deviates: places in v.
  static constexpr int independent_velocity_count = 3;
  static constexpr int independent_velocities[3] = {4, 6, 7};

  /// Mass matrix M(q), symmetric, stored column by column: T2 = 1/2 v' M v.
  TORSOR_DEVICE static void mass_matrix(const Precomputed&, const State& state, std::array<Scalar, 81>& mass) noexcept {
    const Scalar k0 = traits::constant(0.3141592653589793, 0.31415927f,
        "4427007044615115050034854648525685871587/14091601085062767830857184402523750996530");
    const Scalar k1 = traits::constant(0.14689731601426778, 0.14689732f,
        "557826800798664429919032341080477298063745827889324949667801361010471424315690411482824377298793012472065359782675150519597220540601684080097331727243117021514522829/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k2 = traits::constant(0.005950872541725462, 0.0059508723f,
        "11298900081976005488039590346701483956312571499395628412519783507493819739182003600879011813971315003255906388553830486116652719658788633777063662087724795679803439/1898696368095942639087092253868002940016956219669453150142723260368036152458294888778615521037238951749780791102237100178156974029401684305956122807236616706800625000");
    const Scalar k3 = traits::constant(0.20061665139658788, 0.20061666f,
        "1382180435281049145907121109643576521220371021393405956792663939457042810632956483/6889659585378552357172375771275447678187583839499477142856648645759486220845080125");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar k6 = traits::constant(0.1538973160142678, 0.15389732f,
        "584408549952007626866251632634629339223983214964697293769799486655623930450106539925724994593314357796562290858106469922091418177013307660380717446544429655409731579/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k7 = traits::constant(0.9534570696121847, 0.95345706f,
        "525519571112042718940803777777202731020156921024515291029654726624274787160578631/551172766830284188573790061702035814255006707159958171428531891660758897667606410");
    const Scalar k8 = traits::constant(0.13310268398573222, 0.13310269f,
        "505443165335063447969739321085604348345749655125568814412123664795628821060954726233200314482060800507811883234577625580170684915863259131238097044809388334293827171/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k9 = traits::constant(1.9069141392243694, 1.9069141f,
        "525519571112042718940803777777202731020156921024515291029654726624274787160578631/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
    const Scalar k10 = traits::constant(46.686007365934024, 46.68601f,
        "12866027926070442963751385859967080732345328859301894534751105534737425465833752936/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
    const Scalar k11 = traits::constant(22.569969249659824, 22.56997f,
        "342828149138929719688783421449433478383028442784206544289031539175655916942927043559135766444260552962888647402643521015968905122464918622479097614868309626665425561/15189570944767541112696738030944023520135649757355625201141786082944289219666359110228924168297911613998246328817896801425255792235213474447648982457892933654405000");
    const Scalar k12 = traits::constant(40.23024469547104, 40.230244f,
        "1108690763953106891919173818010564632270624322560169545605282827304553786348861088751/27558638341514209428689503085101790712750335357997908571426594583037944883380320500");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar k14 = traits::constant(3.1039332456692037, 3.1039333f,
        "94294828485829889317736294250019993012932147565240731892034734741183025522173748034742114229107663347573171864650415277122396595468847664802188578031255519060950061/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar k15 = traits::constant(55.936141270888, 55.936142f,
        "1699291972421385779877304374579996783277772861866033461925154383125417806323203985914337366054365021881629239146738534203740799834285687221595413985583845260841241379/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar k16 = traits::constant(30.0803372582786, 30.080338f,
        "913814833654314341168408299052484260902016513833729810508994044417847786422246988993462272564730982369247640341767809896108739855656047662664836731549865211404221963/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar q_yaw = state.q.yaw;
    const Scalar q_roll = state.q.roll;
    const Scalar q_pitch = state.q.pitch;
    const Scalar q_steer = state.q.steer;
    const Scalar z0 = k0 + q_pitch;
    const Scalar angles_[] = {q_yaw, q_roll, q_steer, z0};
    Scalar sines_[4], cosines_[4];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_steer = sines_[2], c_steer = cosines_[2];
    const Scalar z1 = sines_[3], z2 = cosines_[3];
    const Scalar z3 = k1 * s_steer;
    const Scalar z4 = k2 * c_steer;
    const Scalar z5 = k3 * c_steer;
    const Scalar z6 = k1 * c_steer;
    const Scalar z7 = k3 * s_steer;
    const Scalar z8 = k2 * s_steer;
    const Scalar z9 = n0_28 * s_steer;
    const Scalar z10 = n0_28 * c_steer;
    const Scalar z11 = n0_12 * s_roll;
    const Scalar z12 = z1 * z9;
    const Scalar z13 = z2 * z9;
    const Scalar z14 = k6 + k7 * z5;
    const Scalar z15 = z1 * z7;
    const Scalar z16 = z2 * z7;
    const Scalar z17 = k8 + c_steer * z6;
    const Scalar z18 = k8 + s_steer * z3;
    const Scalar z19 = s_steer * z6;
    const Scalar z20 = k6 + k9 * z5;
    const Scalar z21 = k10 + z5;
    const Scalar z22 = k11 - z4;
    const Scalar z23 = s_roll * z10 + c_roll * z12;
    const Scalar z24 = s_roll * z15 - c_roll * z5;
    const Scalar z25 = s_roll * z5 + c_roll * z15;
    const Scalar z26 = k7 * z7 + z19;
    const Scalar z27 = k12 * z1 - z2 * z21;
    const Scalar z28 = k12 * z2 + z1 * z21;
    const Scalar z29 = n2 * z22;
    const Scalar z30 = z1 * z4 + z2 * z14;
    const Scalar z31 = z1 * z14 - z2 * z4;
    const Scalar z32 = k9 * z5 + z17;
    const Scalar z33 = k14 - z18;
    const Scalar z34 = z1 * z26 - z2 * z8;
    const Scalar z35 = z1 * z8 + z2 * z26;
    const Scalar z36 = s_roll * z27;
    const Scalar z37 = c_roll * z27;
    const Scalar z38 = z20 + z33;
    const Scalar z39 = s_roll * z7 - c_roll * z28;
    const Scalar z40 = c_roll * z7 + s_roll * z28;
    const Scalar z41 = s_roll * z8 - c_roll * z30;
    const Scalar z42 = k15 + z32;
    const Scalar z43 = s_yaw * z24 - c_yaw * z16;
    const Scalar z44 = s_yaw * z16 + c_yaw * z24;
    const Scalar z45 = s_yaw * z36 - c_yaw * z28;
    const Scalar z46 = s_yaw * z28 + c_yaw * z36;
    const Scalar z47 = z1 * z29 - z2 * z38;
    const Scalar z48 = n0_12 + z42;
    const Scalar z49 = s_yaw * z39;
    const Scalar z50 = c_yaw * z39;
    const Scalar z51 = s_yaw * z27 - c_yaw * z40;
    const Scalar z52 = c_yaw * z27 + s_yaw * z40;
    const Scalar z53 = s_roll * z48 + c_roll * z34;
    const Scalar z54 = z2 * z47;
    const Scalar z55 = n2 * z34;
    const Scalar z56 = z1 * z47 - z22;
    const Scalar z57 = z33 + z54;
    const Scalar z58 = z20 + z54;
    const Scalar z59 = s_roll * z35 + c_roll * z56;
    const Scalar z60 = k16 - z57;
    const Scalar z61 = k16 + z58;
    const Scalar z62 = z48 - z60;
    const Scalar z63 = c_roll * z55 + s_roll * z62;
    const Scalar z64 = s_roll * z63;
    const Scalar z65 = z60 + z64;
    mass[0] = n94;
    mass[1] = n0;
    mass[2] = n0;
    mass[3] = z51;
    mass[4] = z49;
    mass[5] = z45;
    mass[6] = z43;
    mass[7] = n0;
    mass[8] = n0;
    mass[9] = n0;
    mass[10] = n94;
    mass[11] = n0;
    mass[12] = -z52;
    mass[13] = -z50;
    mass[14] = -z46;
    mass[15] = -z44;
    mass[16] = n0;
    mass[17] = n0;
    mass[18] = n0;
    mass[19] = n0;
    mass[20] = n94;
    mass[21] = n0;
    mass[22] = z40;
    mass[23] = z37;
    mass[24] = z25;
    mass[25] = n0;
    mass[26] = n0;
    mass[27] = z51;
    mass[28] = -z52;
    mass[29] = n0;
    mass[30] = z65;
    mass[31] = -z59;
    mass[32] = z53;
    mass[33] = -z41;
    mass[34] = z11;
    mass[35] = z23;
    mass[36] = z49;
    mass[37] = -z50;
    mass[38] = z40;
    mass[39] = -z59;
    mass[40] = z61;
    mass[41] = -z35;
    mass[42] = z31;
    mass[43] = n0;
    mass[44] = -z13;
    mass[45] = z45;
    mass[46] = -z46;
    mass[47] = z37;
    mass[48] = z53;
    mass[49] = -z35;
    mass[50] = z48;
    mass[51] = -z8;
    mass[52] = n0_12;
    mass[53] = z10;
    mass[54] = z43;
    mass[55] = -z44;
    mass[56] = z25;
    mass[57] = -z41;
    mass[58] = z31;
    mass[59] = -z8;
    mass[60] = k6;
    mass[61] = n0;
    mass[62] = n0;
    mass[63] = n0;
    mass[64] = n0;
    mass[65] = n0;
    mass[66] = z11;
    mass[67] = n0;
    mass[68] = n0_12;
    mass[69] = n0;
    mass[70] = n0_12;
    mass[71] = n0;
    mass[72] = n0;
    mass[73] = n0;
    mass[74] = n0;
    mass[75] = z23;
    mass[76] = -z13;
    mass[77] = z10;
    mass[78] = n0;
    mass[79] = n0;
    mass[80] = n0_28;
  }

  /// Forward dynamics: accelerations a and multipliers lambda from M a + h = E u + A' lambda, A a + gamma = 0, by
  /// an unrolled L D L' of M and of the Schur complement A M^-1 A'. Returns singular when a pivot is not
  /// positive relative to its diagonal entry, or one of the Schur complement is below
  /// 2^-40 of those of its unit (a change point), in float 2^-20.
  TORSOR_DEVICE static torsor::Status forward_dynamics(const Precomputed&, const State& state, const Inputs&,
      Accelerations& accelerations, Multipliers& multipliers) noexcept {
    const Scalar k0 = traits::constant(0.3141592653589793, 0.31415927f,
        "4427007044615115050034854648525685871587/14091601085062767830857184402523750996530");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k10 = traits::constant(0.9534570696121847, 0.95345706f,
        "525519571112042718940803777777202731020156921024515291029654726624274787160578631/551172766830284188573790061702035814255006707159958171428531891660758897667606410");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar k12 = traits::constant(0.1538973160142678, 0.15389732f,
        "584408549952007626866251632634629339223983214964697293769799486655623930450106539925724994593314357796562290858106469922091418177013307660380717446544429655409731579/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k13 = traits::constant(0.13310268398573222, 0.13310269f,
        "505443165335063447969739321085604348345749655125568814412123664795628821060954726233200314482060800507811883234577625580170684915863259131238097044809388334293827171/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k14 = traits::constant(0.005950872541725462, 0.0059508723f,
        "11298900081976005488039590346701483956312571499395628412519783507493819739182003600879011813971315003255906388553830486116652719658788633777063662087724795679803439/1898696368095942639087092253868002940016956219669453150142723260368036152458294888778615521037238951749780791102237100178156974029401684305956122807236616706800625000");
    const Scalar k15 = traits::constant(0.20061665139658788, 0.20061666f,
        "1382180435281049145907121109643576521220371021393405956792663939457042810632956483/6889659585378552357172375771275447678187583839499477142856648645759486220845080125");
    const Scalar n0_1435 = traits::constant(0.1435, 0.1435f, "287/2000");
    const Scalar k17 = traits::constant(0.010397316014267795, 0.010397316f,
        "9870673077118022362064038943628123859779194979891059919709477732499388673643976711565585013906694661093800952941105542740091657643756066142827550216880165139488051/949348184047971319543546126934001470008478109834726575071361630184018076229147444389307760518619475874890395551118550089078487014700842152978061403618308353400312500");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar k19 = traits::constant(0.14689731601426778, 0.14689732f,
        "557826800798664429919032341080477298063745827889324949667801361010471424315690411482824377298793012472065359782675150519597220540601684080097331727243117021514522829/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k20 = traits::constant(46.686007365934024, 46.68601f,
        "12866027926070442963751385859967080732345328859301894534751105534737425465833752936/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
    const Scalar k21 = traits::constant(40.23024469547104, 40.230244f,
        "1108690763953106891919173818010564632270624322560169545605282827304553786348861088751/27558638341514209428689503085101790712750335357997908571426594583037944883380320500");
    const Scalar k22 = traits::constant(1.9069141392243694, 1.9069141f,
        "525519571112042718940803777777202731020156921024515291029654726624274787160578631/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
    const Scalar k23 = traits::constant(29.520037258278602, 29.520037f,
        "22419835011340195864938008360375209703633812617890927422714863973332510398067221674363493503543408565365030137642361868510789955371931686079970032045188759748777393/759478547238377055634836901547201176006782487867781260057089304147214460983317955511446208414895580699912316440894840071262789611760673722382449122894646682720250");
    const Scalar k24 = traits::constant(22.569969249659824, 22.56997f,
        "342828149138929719688783421449433478383028442784206544289031539175655916942927043559135766444260552962888647402643521015968905122464918622479097614868309626665425561/15189570944767541112696738030944023520135649757355625201141786082944289219666359110228924168297911613998246328817896801425255792235213474447648982457892933654405000");
    const Scalar k25 = traits::constant(26.405706696595132, 26.405706f,
        "100272838803663771070524748864849036896113427863879981387391140113084676245369813960628440899022958129734129001318743010742689835795477448035005277771169338200710255171/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k26 = traits::constant(55.92574395487373, 55.925743f,
        "212372013860364750395214790666725085414282490953334618500965459979747228235705922332445908416740000956559279689530552353296639612655135878434855437997113136944597220171/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k27 = traits::constant(3.1143305616834716, 3.1143305f,
        "11826336253037208254165292937027011622055635225574655726183179753577875744966294411189026618694084697091021686893066331811259941064180982364844882454774460543176709829/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k28 = traits::constant(3.1039332456692037, 3.1039333f,
        "94294828485829889317736294250019993012932147565240731892034734741183025522173748034742114229107663347573171864650415277122396595468847664802188578031255519060950061/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar k29 = traits::constant(55.936141270888, 55.936142f,
        "1699291972421385779877304374579996783277772861866033461925154383125417806323203985914337366054365021881629239146738534203740799834285687221595413985583845260841241379/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar n922_14 = traits::constant(922.14, 922.14f, "46107/50");
    const Scalar n0_5603 = traits::constant(0.5603, 0.5603f, "5603/10000");
    const Scalar k32 = traits::constant(30.0803372582786, 30.080338f,
        "913814833654314341168408299052484260902016513833729810508994044417847786422246988993462272564730982369247640341767809896108739855656047662664836731549865211404221963/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar k34 = traits::constant(6.497839117007668, 6.497839f,
        "3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000/584408549952007626866251632634629339223983214964697293769799486655623930450106539925724994593314357796562290858106469922091418177013307660380717446544429655409731579");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n4096 = traits::constant(4096.0, 4096.0f, "4096/1");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
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
    const Scalar z0 = k0 + q_pitch;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer, z0};
    Scalar sines_[5], cosines_[5];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar z1 = sines_[4], z2 = cosines_[4];
    const Scalar pi = traits::pi();
    const Scalar z3 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z4 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z3, sine, cosine);
      return sine;
    });
    const Scalar z5 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z3, sine, cosine);
      return cosine;
    });
    const Scalar z6 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z4 * z4;
    });
    const Scalar z7 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z4 * z5;
    });
    const Scalar z8 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z5 * z5;
    });
    const Scalar z9 = z5 * s_steer;
    const Scalar z10 = z4 * s_steer;
    const Scalar z11 = z4 * z4 * (n1 - c_steer) + c_steer;
    const Scalar z12 = -z7 * (n1 - c_steer);
    const Scalar z13 = z5 * z5 * (n1 - c_steer) + c_steer;
    const Scalar z14 = s_yaw * c_roll;
    const Scalar z15 = c_yaw * c_roll;
    const Scalar z16 = v_pitch * c_pitch;
    const Scalar z17 = v_pitch * s_pitch;
    const Scalar z18 = v_steer * c_steer;
    const Scalar z19 = v_steer * s_steer;
    const Scalar z20 = v_roll * s_roll;
    const Scalar z21 = v_yaw * c_yaw;
    const Scalar z22 = v_yaw * s_yaw;
    const Scalar z23 = v_roll * c_roll;
    const Scalar z24 = s_yaw * s_roll;
    const Scalar z25 = c_yaw * s_roll;
    const Scalar z26 = z14 * z14 + z15 * z15;
    const Scalar z27 = s_yaw * z20 - c_roll * z21;
    const Scalar z28 = c_yaw * z20 + c_roll * z22;
    const Scalar z29 = n2 * (z14 * z24 + z15 * z25);
    const Scalar z30 = s_roll * z14;
    const Scalar z31 = s_roll * z15;
    const Scalar z32 = v_roll * z23;
    const Scalar z33 = v_yaw * z22;
    const Scalar z34 = n2 * z20;
    const Scalar z35 = v_yaw * z21;
    const Scalar z36 = n0_08 * z9 - n0_35 * z10;
    const Scalar z37 = s_pitch * z10 - c_pitch * z9;
    const Scalar z38 = s_pitch * z9 + c_pitch * z10;
    const Scalar z39 = z5 * z18;
    const Scalar z40 = z4 * z18;
    const Scalar z41 = -z19 * (n1 - z6);
    const Scalar z42 = z7 * z19;
    const Scalar z43 = -z19 * (n1 - z8);
    const Scalar z44 = s_yaw * z32 + c_roll * z33 + z21 * z34;
    const Scalar z45 = c_yaw * z32 + c_roll * z35 - z22 * z34;
    const Scalar z46 = n0_08 * z39 - n0_35 * z40;
    const Scalar z47 = n0_35 * z42 + n0_08 * z41;
    const Scalar z48 = n0_08 * z42 + n0_35 * z43;
    const Scalar z49 = z9 * z16 - z10 * z17 + s_pitch * z39 + c_pitch * z40;
    const Scalar z50 = n0_08 * z11 - n0_35 * z12;
    const Scalar z51 = n0_08 * z12 - n0_35 * z13;
    const Scalar z52 = traits::sqrt(z26);
    const Scalar z53 = z9 * z17 + z10 * z16 + s_pitch * z40 - c_pitch * z39;
    const Scalar z54 = s_roll * z38 - c_roll * c_steer;
    const Scalar z55 = s_roll * c_steer + c_roll * z38;
    const Scalar z56 = n0_3 + z51;
    const Scalar z57 = n1_1 - z50;
    const Scalar z58 = n2 * (z14 * z27 + z15 * z28);
    const Scalar z59 = s_yaw * z55;
    const Scalar z60 = n2 * (z14 * z44 + z15 * z45 - z27 * z27 - z28 * z28);
    const Scalar z61 = c_yaw * z37 + s_yaw * z54;
    const Scalar z62 = s_yaw * z37 - c_yaw * z54;
    const Scalar z63 = z61 * z61 + z62 * z62;
    const Scalar z64 = s_pitch * z57 - c_pitch * z56;
    const Scalar z65 = s_roll * z64 - c_roll * z36;
    const Scalar z66 = n0_5 * z29 / z52;
    const Scalar z67 = traits::sqrt(z63);
    const Scalar z68 = s_pitch * z56 + c_pitch * z57;
    const Scalar z69 = s_roll * z36 + c_roll * z64;
    const Scalar z70 = n0_3 / z52;
    const Scalar z71 = c_roll * z19 + c_steer * z20 + z23 * z38 + s_roll * z49;
    const Scalar z72 = s_yaw * z65 - c_yaw * z68;
    const Scalar z73 = s_yaw * z68 + c_yaw * z65;
    const Scalar z74 = z21 * z37 + z22 * z54 + s_yaw * z53 - c_yaw * z71;
    const Scalar z75 = n0_3 * z66;
    const Scalar z76 = z21 * z54 - z22 * z37 + c_yaw * z53 + s_yaw * z71;
    const Scalar z77 = n2 * (z62 * z74 + z61 * z76);
    const Scalar z78 = s_pitch * z47 - c_pitch * z48 - z57 * z16 - z56 * z17;
    const Scalar z79 = n0_5 * z58 / z52;
    const Scalar z80 = n0_5 * (z58 * z79 / (z52 * z52) + z60 / z52);
    const Scalar z81 = z5 * c_steer;
    const Scalar z82 = z4 * c_steer;
    const Scalar z83 = s_roll * z37;
    const Scalar z84 = s_yaw * z83 - c_yaw * z38;
    const Scalar z85 = s_yaw * z38 + c_yaw * z83;
    const Scalar z86 = c_yaw * z55;
    const Scalar z87 = n2 * (z61 * z59 - z62 * z86);
    const Scalar z88 = s_steer * z7;
    const Scalar z89 = s_steer * (n1 - z6);
    const Scalar z90 = n2 * (z61 * z84 - z62 * z85);
    const Scalar z91 = n0_08 * z89 - n0_35 * z88;
    const Scalar z92 = n0_5 * z87 / z67;
    const Scalar z93 = s_steer * (n1 - z8);
    const Scalar z94 = n0_08 * z81 - n0_35 * z82;
    const Scalar z95 = c_roll * z68;
    const Scalar z96 = n0_5 * z77 / z67;
    const Scalar z97 = z23 * z36 + s_roll * z46 - z20 * z64 - c_roll * z78;
    const Scalar z98 = n0_5 * z90 / z67;
    const Scalar z99 = n0_3 * z80;
    const Scalar z100 = n0_08 * z88 - n0_35 * z93;
    const Scalar z101 = c_pitch * z100 + s_pitch * z91;
    const Scalar z102 = v_steer * z18;
    const Scalar z103 = z55 * z61;
    const Scalar z104 = n0_35 / z67;
    const Scalar z105 = z55 * z62;
    const Scalar z106 = s_pitch * z81 + c_pitch * z82;
    const Scalar z107 = s_pitch * z82 - c_pitch * z81;
    const Scalar z108 = c_roll * s_steer + s_roll * z106;
    const Scalar z109 = s_roll * z94 + c_roll * z101;
    const Scalar z110 = z65 + n0_35 * z92;
    const Scalar z111 = n0_3 * z79 / (z52 * z52);
    const Scalar z112 = z95 + n0_35 * z98;
    const Scalar z113 = z26 * z111 - z58 * z70;
    const Scalar z114 = z26 * z70;
    const Scalar z115 = s_pitch * z4 - c_pitch * z5;
    const Scalar z116 = s_roll * z115;
    const Scalar z117 = s_pitch * z5 + c_pitch * z4;
    const Scalar z118 = z72 + z103 * z104;
    const Scalar z119 = z69 - z63 * z104;
    const Scalar z120 = c_yaw * z119;
    const Scalar z121 = s_roll * z118 + z14 * z119;
    const Scalar z122 = z73 - z105 * z104;
    const Scalar z123 = s_yaw * z119;
    const Scalar z124 = s_roll * z122 + z15 * z119;
    const Scalar z125 = c_yaw * z107 + s_yaw * z108;
    const Scalar z126 = s_yaw * z107 - c_yaw * z108;
    const Scalar z127 = n2 * (z61 * z125 + z62 * z126);
    const Scalar z128 = c_roll * z115;
    const Scalar z129 = s_yaw * z116 - c_yaw * z117;
    const Scalar z130 = s_yaw * z117 + c_yaw * z116;
    const Scalar z131 = c_yaw * z114;
    const Scalar z132 = s_yaw * z114;
    const Scalar z133 = v_pitch * z17;
    const Scalar z134 = z30 * z70;
    const Scalar z135 = v_pitch * z16;
    const Scalar z136 = v_steer * z19;
    const Scalar z137 = n0_5 * z127 / z67;
    const Scalar z138 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z139 = v_roll * z20;
    const Scalar z140 = z5 * z136;
    const Scalar z141 = z4 * z136;
    const Scalar z142 = s_roll * z134 + z14 * z114;
    const Scalar z143 = z31 * z70;
    const Scalar z144 = z9 * z133 + z10 * z135 + s_pitch * z140 + c_pitch * z141 - n2 * (z39 * z16 - z40 * z17);
    const Scalar z145 = z10 * z133 - z9 * z135 + s_pitch * z141 - c_pitch * z140 - n2 * (z39 * z17 + z40 * z16);
    const Scalar z146 = z109 - n0_35 * z137;
    const Scalar z147 = n0_08 * z140 - n0_35 * z141;
    const Scalar z148 = z38 * z139 - c_roll * z102 - c_steer * z32 + n2 * (z20 * z19 - z23 * z49) + s_roll * z144;
    const Scalar z149 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z150 = s_roll * z149;
    const Scalar z151 = c_roll * z149;
    const Scalar z152 = s_roll * z143 + z15 * z114;
    const Scalar z153 = z35 * z37 + z33 * z54 - n2 * (z21 * z71 - z22 * z53) + c_yaw * z145 + s_yaw * z148;
    const Scalar z154 = z33 * z37 - z35 * z54 - n2 * (z21 * z53 + z22 * z71) + s_yaw * z145 - c_yaw * z148;
    const Scalar z155 = z69 - z151;
    const Scalar z156 = n2 * (z61 * z153 + z62 * z154 - z76 * z76 - z74 * z74);
    const Scalar z157 = s_yaw * z150 - c_yaw * z138;
    const Scalar z158 = z72 - z157;
    const Scalar z159 = s_yaw * z138 + c_yaw * z150;
    const Scalar z160 = z73 - z159;
    const Scalar z161 = z7 * z102;
    const Scalar z162 = z103 * z104 + z158;
    const Scalar z163 = -z102 * (n1 - z6);
    const Scalar z164 = z63 * z104 - z155;
    const Scalar z165 = z105 * z104 - z160;
    const Scalar z166 = n0_35 * z161 + n0_08 * z163;
    const Scalar z167 = -z102 * (n1 - z8);
    const Scalar z168 = n0_08 * z161 + n0_35 * z167;
    const Scalar z169 = n0_5 * (z77 * z96 / (z67 * z67) + z156 / z67);
    const Scalar z170 = s_pitch * z166 - z56 * z135 - c_pitch * z168 + z57 * z133 + n2 * (z16 * z47 + z17 * z48);
    const Scalar z171 = z103 * z104;
    const Scalar z172 = z128 * z162 + z129 * z164;
    const Scalar z173 = z63 * z104;
    const Scalar z174 = z55 * z171 + z61 * z173;
    const Scalar z175 = z105 * z104;
    const Scalar z176 = z128 * z165 - z130 * z164;
    const Scalar z177 = z55 * z175 + z62 * z173;
    const Scalar z178 = s_roll * z28 - z15 * z23;
    const Scalar z179 = z36 * z139 + s_roll * z147 + z32 * z64 - n2 * (z23 * z46 + z20 * z78) + c_roll * z170;
    const Scalar z180 = c_roll * z46 - z20 * z36 - z23 * z64 + s_roll * z78;
    const Scalar z181 = s_pitch * z48 + c_pitch * z47 + z57 * z17 - z56 * z16;
    const Scalar z182 = s_roll * z19 - c_steer * z23 + z20 * z38 - c_roll * z49;
    const Scalar z183 = n0_35 * z96 / (z67 * z67);
    const Scalar z184 = z31 * z111 - z70 * z178;
    const Scalar z185 = z179 - n0_35 * z169;
    const Scalar z186 = z77 * z104;
    const Scalar z187 = n0_3 * z16 - n1_1 * z17;
    const Scalar z188 = n1_1 * z16 + n0_3 * z17;
    const Scalar z189 = z23 * z149 + s_roll * z188;
    const Scalar z190 = z55 * z74 - z62 * z182;
    const Scalar z191 = z104 * z190;
    const Scalar z192 = s_yaw * z181 - z21 * z68 + z22 * z65 + c_yaw * z180;
    const Scalar z193 = z21 * z138 + s_yaw * z187 - z22 * z150 + c_yaw * z189;
    const Scalar z194 = z192 + z193;
    const Scalar z195 = z105 * z183 - z192 - z191;
    const Scalar z196 = z97 - z186 + z63 * z183;
    const Scalar z197 = z105 * z183 - z191 - z194;
    const Scalar z198 = z4 * z16 + z5 * z17;
    const Scalar z199 = z21 * z119 + s_yaw * z196;
    const Scalar z200 = c_roll * z198 - z20 * z115;
    const Scalar z201 = z23 * z122 - z28 * z119 + z15 * z196 + s_roll * z195;
    const Scalar z202 = z23 * z143 - z28 * z114 + s_roll * z184 + z15 * z113;
    const Scalar z203 = s_roll * z27 - z14 * z23;
    const Scalar z204 = z30 * z111 - z70 * z203;
    const Scalar z205 = z21 * z114 + s_yaw * z113;
    const Scalar z206 = v_yaw * z184 + v_roll * z205 + z202 * (v_pitch + v_rear);
    const Scalar z207 = c_roll * z188 - z20 * z149;
    const Scalar z208 = z97 - z207;
    const Scalar z209 = z4 * z17 - z5 * z16;
    const Scalar z210 = z23 * z115 + s_roll * z198;
    const Scalar z211 = s_yaw * z209 - z21 * z117 + z22 * z116 - c_yaw * z210;
    const Scalar z212 = c_yaw * z113 - z22 * z114;
    const Scalar z213 = z23 * z134 - z27 * z114 + s_roll * z204 + z14 * z113;
    const Scalar z214 = v_yaw * z204 - v_roll * z212 + z213 * (v_pitch + v_rear);
    const Scalar z215 = s_yaw * z180 - c_yaw * z181 - z21 * z65 - z22 * z68;
    const Scalar z216 = z22 * z138 - c_yaw * z187 + z21 * z150 + s_yaw * z189;
    const Scalar z217 = z22 * z117 + c_yaw * z209 + z21 * z116 + s_yaw * z210;
    const Scalar z218 = z105 * z183 - z191;
    const Scalar z219 = z215 + z216;
    const Scalar z220 = z208 - z186 + z63 * z183;
    const Scalar z221 = z128 * z197 - z130 * z220 - z165 * z200 - z164 * z211;
    const Scalar z222 = z63 * z183 - z186;
    const Scalar z223 = z175 * z182 - z74 * z173 + z55 * z218 + z62 * z222;
    const Scalar z224 = c_yaw * z196 - z22 * z119;
    const Scalar z225 = v_yaw * c_roll;
    const Scalar z226 = v_yaw * s_roll;
    const Scalar z227 = v_roll * z2 - z1 * z225;
    const Scalar z228 = v_yaw * z195 + v_roll * z199 + v_pitch * z201 + v_front * z223 - v_steer * z221;
    const Scalar z229 = v_pitch + z226;  // angular velocity of frame, z
    const Scalar z230 = v_roll * z226;  // angular acceleration of frame.2, y
    const Scalar z231 = z2 * z230;
    const Scalar z232 = v_roll * z1 + z2 * z225;
    const Scalar z233 = s_steer * z229 + c_steer * z227;
    const Scalar z234 = v_pitch * z227 - z231;  // angular acceleration of frame, y
    const Scalar z235 = s_steer * z227 - c_steer * z229;
    const Scalar z236 = z1 * z230;
    const Scalar z237 = v_pitch * z232 - z236;  // angular acceleration of frame, x
    const Scalar z238 = v_roll * z225;  // angular acceleration of frame.2, x
    const Scalar z239 = v_steer + z232;  // angular velocity of fork, z
    const Scalar z240 = z233 * z235;
    const Scalar z241 = z235 * z235;
    const Scalar z242 = z239 * z239;
    const Scalar z243 = z234 - z240;
    const Scalar z244 = c_steer * z238 + s_steer * z237;
    const Scalar z245 = z241 + z242;
    const Scalar z246 = n9_81 * c_roll;
    const Scalar z247 = z227 * z232;
    const Scalar z248 = v_front - z235;  // angular velocity of front_wheel, z
    const Scalar z249 = z2 * z246;
    const Scalar z250 = z1 * z246;
    const Scalar z251 = v_steer * z233 - z244;  // angular acceleration of fork, y
    const Scalar z252 = z232 * z232;
    const Scalar z253 = z229 * z229;
    const Scalar z254 = z238 - z247;
    const Scalar z255 = z233 * z239;
    const Scalar z256 = v_rear + z229;  // angular velocity of rear_wheel, z
    const Scalar z257 = s_steer * z238 - c_steer * z237;
    const Scalar z258 = z251 + z255;
    const Scalar z259 = v_steer * z235 - z257;  // angular acceleration of fork, x
    const Scalar z260 = z235 * z239;
    const Scalar z261 = z239 * z248;
    const Scalar z262 = z233 * z248;
    const Scalar z263 = z233 * z233;
    const Scalar z264 = z252 + z253;
    const Scalar z265 = z249 + k10 * z254;
    const Scalar z266 = n9_81 * s_roll;
    const Scalar z267 = z227 * z229;
    const Scalar z268 = z234 + z267;
    const Scalar z269 = z250 - k10 * z264;
    const Scalar z270 = z259 - z260;
    const Scalar z271 = z55 * z76 - z61 * z182;
    const Scalar z272 = z104 * z271;
    const Scalar z273 = n0_28 * z261;  // moment on front_wheel, x
    const Scalar z274 = n0_28 * z262;  // moment on front_wheel, y
    const Scalar z275 = z266 - k10 * z268;
    const Scalar z276 = z215 - z272 + z103 * z183;
    const Scalar z277 = z259 + z260;
    const Scalar z278 = s_steer * z269 + c_steer * z275;
    const Scalar z279 = n0_28 * z251;  // moment on front_wheel, z
    const Scalar z280 = z219 - z272 + z103 * z183;
    const Scalar z281 = z103 * z183 - z272;
    const Scalar z282 = z171 * z182 - z76 * z173 + z55 * z281 + z61 * z222;
    const Scalar z283 = z128 * z280 + z129 * z220 - z162 * z200 - z164 * z217;
    const Scalar z284 = z27 * z119 - z23 * z118 + s_roll * z276 - z14 * z196;
    const Scalar z285 = z274 + k12 * z234 + k13 * z240 + k14 * z270 - k15 * z278;  // moment on fork, z
    const Scalar z286 = z242 - z263;
    const Scalar z287 = k14 * z243 + z273 + n0_1435 * z277;  // moment on fork, x
    const Scalar z288 = v_yaw * z276 + v_roll * z224 + v_pitch * z284 - v_steer * z283 + v_front * z282;
    const Scalar z289 = k15 * z265 - z279 - k14 * z286 - k17 * z258;  // moment on fork, y
    const Scalar z290 = z226 * z225;
    const Scalar z291 = k15 * z243;  // force on fork, y
    const Scalar z292 = k15 * z245;  // force on fork, x
    const Scalar z293 = k15 * z258;  // force on fork, z
    const Scalar z294 = z232 * z229;
    const Scalar z295 = z237 + z294;
    const Scalar z296 = z232 * z256;
    const Scalar z297 = z227 * z256;
    const Scalar z298 = n0_12 * z297;  // moment on rear_wheel, y
    const Scalar z299 = z227 * z227;
    const Scalar z300 = n0_12 * z296;  // moment on rear_wheel, x
    const Scalar z301 = z253 + z299;
    const Scalar z302 = z252 - z299;
    const Scalar z303 = n2 * z230;
    const Scalar z304 = k19 * c_steer;
    const Scalar z305 = k19 * s_steer;
    const Scalar z306 = k20 * z254 - z293 - k21 * z301;  // force on frame, y
    const Scalar z307 = k13 + s_steer * z305;
    const Scalar z308 = k15 * c_steer;
    const Scalar z309 = k14 * c_steer;
    const Scalar z310 = k13 + c_steer * z304;
    const Scalar z311 = s_steer * z304;
    const Scalar z312 = n0_28 * c_steer;
    const Scalar z313 = k15 * s_steer;
    const Scalar z314 = k10 * z313 + z311;
    const Scalar z315 = k14 * s_steer;
    const Scalar z316 = n0_28 * s_steer;
    const Scalar z317 = k12 + k10 * z308;
    const Scalar z318 = z2 * z316;
    const Scalar z319 = z1 * z316;
    const Scalar z320 = z1 * z317 - z2 * z309;
    const Scalar z321 = s_roll * z312 + c_roll * z319;
    const Scalar z322 = z1 * z309 + z2 * z317;
    const Scalar z323 = s_roll * z315 - c_roll * z322;
    const Scalar z324 = z1 * z313;
    const Scalar z325 = s_roll * z308 + c_roll * z324;
    const Scalar z326 = s_roll * z324 - c_roll * z308;
    const Scalar z327 = z2 * z313;
    const Scalar z328 = n0_12 * z238;  // moment on rear_wheel, z
    const Scalar z329 = s_steer * z291 + c_steer * z292;
    const Scalar z330 = s_steer * z292 - c_steer * z291;
    const Scalar z331 = k22 * z308 + z310;
    const Scalar z332 = k20 * z266 - z298 - k23 * z268 + k24 * z295 + k10 * z330 - z285;  // moment on frame, y
    const Scalar z333 = k20 * z268 - z330 - k21 * z295;  // force on frame, z
    const Scalar z334 = k12 + k22 * z308;
    const Scalar z335 = s_yaw * z327 + c_yaw * z326;
    const Scalar z336 = s_yaw * z326 - c_yaw * z327;
    const Scalar z337 = z238 + z247;
    const Scalar z338 = k20 * z264 + z329 + k21 * z337;  // force on frame, x
    const Scalar z339 = c_steer * z287 + s_steer * z289;
    const Scalar z340 = k21 * z266 + z300 - k24 * z268 + k25 * z295 + z339;  // moment on frame, x
    const Scalar z341 = s_steer * z287 - c_steer * z289;
    // moment on frame, z
    const Scalar z342 = z328 + k26 * z238 - k21 * z250 + k20 * z249 - k27 * z247 + k24 * z302 - k10 * z293 - z341;
    const Scalar z343 = k24 - z309;
    const Scalar z344 = k28 - z307;
    const Scalar z345 = k29 + z331;
    const Scalar z346 = k20 + z308;
    const Scalar z347 = n2 * z343;
    const Scalar z348 = z334 + z344;
    const Scalar z349 = z1 * z314 - z2 * z315;
    const Scalar z350 = z1 * z347 - z2 * z348;
    const Scalar z351 = z1 * z315 + z2 * z314;
    const Scalar z352 = n0_12 + z345;
    const Scalar z353 = s_roll * z352 + c_roll * z349;
    const Scalar z354 = n0_12 * s_roll;
    const Scalar z355 = k21 * z2 + z1 * z346;
    const Scalar z356 = k21 * z1 - z2 * z346;
    const Scalar z357 = z2 * z350;
    const Scalar z358 = c_roll * z356;
    const Scalar z359 = s_roll * z356;
    const Scalar z360 = z1 * z338 - z2 * z306;
    const Scalar z361 = z1 * z306 + z2 * z338;
    const Scalar z362 = z344 + z357;
    const Scalar z363 = z334 + z357;
    const Scalar z364 = s_yaw * z355 + c_yaw * z359;
    const Scalar z365 = s_yaw * z359 - c_yaw * z355;
    const Scalar z366 = s_roll * z360 - c_roll * z333;
    const Scalar z367 = s_roll * z333 + c_roll * z360;
    const Scalar z368 = n922_14 - z367;  // force on frame.z, z
    const Scalar z369 = z2 * z340 + z1 * z332;
    const Scalar z370 = z1 * z340 - z2 * z332;
    const Scalar z371 = z1 * z350 - z343;
    const Scalar z372 = z369 - n0_5603 * z290;  // moment on frame.2, z
    const Scalar z373 = z370 - n0_5603 * z303;  // moment on frame.2, y
    const Scalar z374 = k32 - z362;
    const Scalar z375 = k32 + z363;
    const Scalar z376 = s_roll * z351 + c_roll * z371;
    const Scalar z377 = s_roll * z342 + c_roll * z373;
    const Scalar z378 = z352 - z374;
    const Scalar z379 = c_roll * z313 + s_roll * z355;
    const Scalar z380 = s_roll * z313 - c_roll * z355;
    const Scalar z381 = c_yaw * z380;
    const Scalar z382 = s_yaw * z380;
    const Scalar z383 = s_yaw * z366 - c_yaw * z361;
    const Scalar z384 = s_yaw * z361 + c_yaw * z366;
    const Scalar z385 = c_steer * z312 - z345;
    const Scalar z386 = n25_over_7 * z312;
    const Scalar z387 = n2 * z349;
    const Scalar z388 = c_roll * z387 + s_roll * z378;
    const Scalar z389 = z318 * z386 - z351;
    const Scalar z390 = z321 * z386 - z353;
    const Scalar z391 = z354 + z390;
    const Scalar z392 = k34 * z315;
    const Scalar z393 = z315 * z392 + z385;
    const Scalar z394 = z320 * z392 + z389;
    const Scalar z395 = z323 * z392 + z391;
    const Scalar z396 = s_roll * z388;
    const Scalar z397 = z325 * z392 + z358;
    const Scalar z398 = n1 / z393;
    const Scalar z399 = z335 * z392 + z364;
    const Scalar z400 = z374 + z396;
    const Scalar z401 = z336 * z392 + z365;
    const Scalar z402 = n25_over_7 * z318;
    const Scalar z403 = z318 * z402 - z375;
    const Scalar z404 = z321 * z402 - z376;
    const Scalar z405 = k34 * z320;
    const Scalar z406 = z335 * z405 - z381;
    const Scalar z407 = z336 * z405 - z382;
    const Scalar z408 = z320 * z405 + z403;
    const Scalar z409 = z323 * z405 + z404;
    const Scalar z410 = n25_over_7 * z321;
    const Scalar z411 = z321 * z410 - z400;
    const Scalar z412 = n25_over_3 * z354;
    const Scalar z413 = k34 * z323;
    const Scalar z414 = z394 * z398;
    const Scalar z415 = z395 * z398;
    const Scalar z416 = k34 * z325;
    const Scalar z417 = z325 * z413;
    const Scalar z418 = z354 * z412 + z411;
    const Scalar z419 = z417 - z397 * z415;
    const Scalar z420 = z406 - z399 * z414;
    const Scalar z421 = z407 - z401 * z414;
    const Scalar z422 = z323 * z413 + z418;
    const Scalar z423 = z325 * z405 - z379;
    const Scalar z424 = n94 - z325 * z416;
    const Scalar z425 = z423 - z397 * z414;
    const Scalar z426 = z422 - z395 * z415;
    const Scalar z427 = z397 * z398;
    const Scalar z428 = z424 + z397 * z427;
    const Scalar z429 = c_yaw * z356 + s_yaw * z379;
    const Scalar z430 = s_yaw * z356 - c_yaw * z379;
    const Scalar z431 = z408 - z394 * z414;
    const Scalar z432 = z409 - z395 * z414;
    const Scalar z433 = n1 / z431;
    const Scalar z434 = z335 * z413 + z429;
    const Scalar z435 = z434 - z399 * z415;
    const Scalar z436 = z336 * z413 + z430;
    const Scalar z437 = z436 - z401 * z415;
    const Scalar z438 = k34 * z335;
    const Scalar z439 = z335 * z416;
    const Scalar z440 = n94 - z335 * z438;
    const Scalar z441 = z439 - z399 * z427;
    const Scalar z442 = z399 * z398;
    const Scalar z443 = k34 * z336;
    const Scalar z444 = z336 * z438;
    const Scalar z445 = z440 + z399 * z442;
    const Scalar z446 = z444 - z401 * z442;
    const Scalar z447 = z336 * z416;
    const Scalar z448 = n94 - z336 * z443;
    const Scalar z449 = z447 - z401 * z427;
    const Scalar z450 = z432 * z433;
    const Scalar z451 = z425 * z433;
    const Scalar z452 = z420 * z433;
    const Scalar z453 = z426 - z432 * z450;
    const Scalar z454 = z419 - z425 * z450;
    const Scalar z455 = z428 + z425 * z451;
    const Scalar z456 = z441 - z420 * z451;
    const Scalar z457 = n1 / z453;
    const Scalar z458 = z435 - z420 * z450;
    const Scalar z459 = z445 + z420 * z452;
    const Scalar z460 = z446 - z421 * z452;
    const Scalar z461 = z449 - z421 * z451;
    const Scalar z462 = z437 - z421 * z450;
    const Scalar z463 = z401 * z398;
    const Scalar z464 = z448 + z401 * z463;
    const Scalar z465 = z421 * z433;
    const Scalar z466 = z132 * z450;
    const Scalar z467 = z112 + z146 * z392;
    const Scalar z468 = z110 + z146 * z405 - z414 * z467;
    const Scalar z469 = z464 + z421 * z465;
    const Scalar z470 = z75 * z450;
    const Scalar z471 = z462 * z457;
    const Scalar z472 = z454 * z457;
    const Scalar z473 = z458 * z457;
    const Scalar z474 = z131 * z450;
    const Scalar z475 = z146 * z413 - z415 * z467 - z450 * z468;
    const Scalar z476 = z455 + z454 * z472;
    const Scalar z477 = z456 - z458 * z472;
    const Scalar z478 = z459 + z458 * z473;
    const Scalar z479 = n1 / z476;
    const Scalar z480 = z460 - z462 * z473;
    const Scalar z481 = z461 - z462 * z472;
    const Scalar z482 = z469 + z462 * z471;
    const Scalar z483 = z131 * z451 - z472 * z474;
    const Scalar z484 = z132 * z451 - z472 * z466;
    const Scalar z485 = n1 + z146 * z416 - z427 * z467 - z451 * z468 - z472 * z475;
    const Scalar z486 = n1 + z75 * z451 - z472 * z470;
    const Scalar z487 = z481 * z479;
    const Scalar z488 = z477 * z479;
    const Scalar z489 = z482 - z481 * z487;
    const Scalar z490 = z480 + z481 * z488;
    const Scalar z491 = z124 + z176 * z392 + z177 * z386;
    const Scalar z492 = z478 - z477 * z488;
    const Scalar z493 = z123 - z176 * z405 - z177 * z402 + z414 * z491;
    const Scalar z494 = n1 / z492;
    const Scalar z495 = z122 + z176 * z413 + z177 * z410 - z415 * z491 + z450 * z493;
    const Scalar z496 = n1 - z131 * z452 + z473 * z474 - z488 * z483;
    const Scalar z497 = z132 * z452 - z473 * z466 + z488 * z484;
    const Scalar z498 = z146 * z438 - z442 * z467 - z452 * z468 - z473 * z475 + z488 * z485;
    const Scalar z499 = z490 * z494;
    const Scalar z500 = z489 - z490 * z499;
    const Scalar z501 = z176 * z416 - z427 * z491 + z451 * z493 - z472 * z495;
    const Scalar z502 = n1 / z500;
    const Scalar z503 = z176 * z438 - z442 * z491 + z452 * z493 - z473 * z495 + z488 * z501;
    const Scalar z504 = n1 + z176 * z443 - z463 * z491 + z465 * z493 - z471 * z495 + z487 * z501 + z499 * z503;
    const Scalar z505 = z131 * z465 - z471 * z474 + z487 * z483 - z499 * z496;
    const Scalar z506 = z502 * z504;
    const Scalar z507 = z502 * z505;
    const Scalar z508 = z494 * z503 + z499 * z506;
    const Scalar z509 = n1 - z132 * z465 + z471 * z466 - z487 * z484 - z499 * z497;
    const Scalar z510 = z494 * z496 - z499 * z507;
    const Scalar z511 = z479 * z483 + z487 * z507 - z488 * z510;
    const Scalar z512 = z502 * z509;
    const Scalar z513 = z494 * z497 - z499 * z512;
    const Scalar z514 = z457 * z474 + z471 * z507 - z473 * z510 + z472 * z511;
    const Scalar z515 = z479 * z484 - z487 * z512 + z488 * z513;
    const Scalar z516 = z131 * z433 - z465 * z507 + z452 * z510 - z451 * z511 + z450 * z514;
    const Scalar z517 = z457 * z466 - z471 * z512 + z473 * z513 + z472 * z515;
    const Scalar z518 = z463 * z507 - z442 * z510 + z427 * z511 - z415 * z514 + z414 * z516;
    const Scalar z519 = z443 * z507 - z438 * z510 + z416 * z511 - z413 * z514 + z405 * z516 - z392 * z518;
    const Scalar z520 = z146 * z443 - z463 * z467 - z465 * z468 - z471 * z475 + z487 * z485 + z499 * z498;
    const Scalar z521 = n25_over_3 * z142 - z518 - z412 * z514;
    const Scalar z522 = z410 * z514 - z402 * z516 + z386 * z518;
    const Scalar z523 = z502 * z520;
    const Scalar z524 = z494 * z498 + z499 * z523;
    const Scalar z525 = z132 * z433 + z465 * z512 - z452 * z513 - z451 * z515 + z450 * z517;
    const Scalar z526 = z479 * z485 + z487 * z523 + z488 * z524;
    const Scalar z527 = z457 * z475 + z471 * z523 + z473 * z524 + z472 * z526;
    const Scalar z528 = z463 * z512 - z442 * z513 - z427 * z515 + z415 * z517 - z414 * z525;
    const Scalar z529 = z433 * z468 + z465 * z523 + z452 * z524 + z451 * z526 - z450 * z527;
    const Scalar z530 = z398 * z467 + z463 * z523 + z442 * z524 + z427 * z526 - z415 * z527 - z414 * z529;
    const Scalar z531 = z75 * z452 - z473 * z470 + z488 * z486;
    const Scalar z532 = z479 * z501 + z487 * z506 + z488 * z508;
    const Scalar z533 = z443 * z512 - z438 * z513 - z416 * z515 + z413 * z517 - z405 * z525 - z392 * z528;
    const Scalar z534 = n25_over_3 * z152 - z528 + z412 * z517;
    const Scalar z535 = z75 * z465 - z471 * z470 + z487 * z486 + z499 * z531;
    const Scalar z536 = z457 * z495 + z471 * z506 + z473 * z508 + z472 * z532;
    const Scalar z537 = z410 * z517 - z402 * z525 - z386 * z528;
    const Scalar z538 = z502 * z535;
    const Scalar z539 = z433 * z493 - z465 * z506 - z452 * z508 - z451 * z532 + z450 * z536;
    const Scalar z540 = z494 * z531 + z499 * z538;
    const Scalar z541 = z398 * z491 + z463 * z506 + z442 * z508 + z427 * z532 - z415 * z536 + z414 * z539;
    const Scalar z542 = z479 * z486 + z487 * z538 + z488 * z540;
    const Scalar z543 = z457 * z470 + z471 * z538 + z473 * z540 + z472 * z542;
    const Scalar z544 = k34 * z176 + z443 * z506 + z438 * z508 + z416 * z532 - z413 * z536 + z405 * z539 - z392 * z541;
    const Scalar z545 = k34 * z146 + z443 * z523 + z438 * z524 + z416 * z526 - z413 * z527 - z405 * z529 - z392 * z530;
    const Scalar z546 = z412 * z527 + z530;
    const Scalar z547 = z410 * z527 + z402 * z529 + z386 * z530;
    const Scalar z548 = z75 * z433 - z465 * z538 - z452 * z540 - z451 * z542 + z450 * z543;
    const Scalar z549 = n25_over_7 * z177 - z410 * z536 + z402 * z539 - z386 * z541;
    const Scalar z550 = z463 * z538 + z442 * z540 + z427 * z542 - z415 * z543 + z414 * z548;
    const Scalar z551 = z121 - z172 * z392 - z174 * z386;
    const Scalar z552 = z443 * z538 + z438 * z540 + z416 * z542 - z413 * z543 + z405 * z548 - z392 * z550;
    const Scalar z553 = z120 - z172 * z405 - z174 * z402 - z414 * z551;
    const Scalar z554 = z410 * z543 - z402 * z548 + z386 * z550;
    const Scalar z555 = z412 * z543 + z550;
    const Scalar z556 = n0_3 * c_roll * z14 * z529 / z52 - z520 / z500;
    const Scalar z557 = n0_3 * c_roll * z14 * z548 / z52 + z535 / z500;
    const Scalar z558 = n0_3 * c_roll * z15 * z548 / z52 + z540;
    const Scalar z559 = z118 - z172 * z413 - z174 * z410 - z415 * z551 - z450 * z553;
    const Scalar z560 = z172 * z416 + z427 * z551 + z451 * z553 + z472 * z559;
    const Scalar z561 = z508 + z118 * z536 - z120 * z539 + z121 * z541 + z172 * z544 + z174 * z549;
    const Scalar z562 = n1 + z172 * z438 + z442 * z551 + z452 * z553 + z473 * z559 + z488 * z560;
    const Scalar z563 = z172 * z443 + z463 * z551 + z465 * z553 + z471 * z559 + z487 * z560 + z499 * z562;
    const Scalar z564 = z502 * z563;
    const Scalar z565 = z122 * z536 - z506 + z123 * z539 + z124 * z541 - z176 * z544 - z177 * z549;
    const Scalar z566 = z494 * z562 + z499 * z564;
    const Scalar z567 = z479 * z560 + z487 * z564 + z488 * z566;
    const Scalar z568 = z122 * z514 - z507 + z123 * z516 + z124 * z518 - z176 * z519 + z177 * z522;
    const Scalar z569 = z457 * z559 - z471 * z564 - z473 * z566 - z472 * z567;
    const Scalar z570 = z433 * z553 - z465 * z564 - z452 * z566 - z451 * z567 - z450 * z569;
    const Scalar z571 = z398 * z551 - z463 * z564 - z442 * z566 - z427 * z567 - z415 * z569 - z414 * z570;
    const Scalar z572 = k34 * z172 + z443 * z564 + z438 * z566 + z416 * z567 + z413 * z569 + z405 * z570 + z392 * z571;
    const Scalar z573 = n25_over_7 * z174 + z410 * z569 + z402 * z570 + z386 * z571;
    const Scalar z574 = z118 * z569 - z566 + z120 * z570 + z121 * z571 - z172 * z572 - z174 * z573;
    const Scalar z575 = n1 / z574;
    const Scalar z576 = z118 * z514 - z510 - z120 * z516 + z121 * z518 + z172 * z519 - z174 * z522;
    const Scalar z577 = z510 + z134 * z514 - z131 * z516 + z142 * (z518 + z521);
    const Scalar z578 = z134 * z517 - z513 - z131 * z525 - z142 * (z528 + z534);
    const Scalar z579 = z512 + z122 * z517 + z123 * z525 - z124 * z528 + z176 * z533 + z177 * z537;
    const Scalar z580 = z561 * z575;
    const Scalar z581 = z565 - z561 * z580;
    const Scalar z582 = z568 - z576 * z580;
    const Scalar z583 = z576 * z575;
    const Scalar z584 = z577 + z576 * z583;
    const Scalar z585 = z513 + z118 * z517 - z120 * z525 - z121 * z528 - z172 * z533 - z174 * z537;
    const Scalar z586 = n1 / z581;
    const Scalar z587 = z578 + z585 * z583;
    const Scalar z588 = z579 - z585 * z580;
    const Scalar z589 = z143 * z517 - z512 + z132 * z525 - z152 * (z528 + z534);
    const Scalar z590 = z585 * z575;
    const Scalar z591 = z589 - z585 * z590;
    const Scalar z592 = z134 * z527 - z524 + z131 * z529 + z142 * (z530 - z546);
    const Scalar z593 = z122 * z527 - z523 - z123 * z529 + z124 * z530 - z176 * z545 + z177 * z547;
    const Scalar z594 = z524 + z118 * z527 + z120 * z529 + z121 * z530 + z172 * z545 - z174 * z547;
    const Scalar z595 = z556 + z594 * z590;
    const Scalar z596 = z592 + z594 * z583;
    const Scalar z597 = z593 - z594 * z580;
    const Scalar z598 = z110 * z529 - z526 + z112 * z530 - z146 * z545;
    const Scalar z599 = z594 * z575;
    const Scalar z600 = z598 - z594 * z599;
    const Scalar z601 = z542 + z110 * z548 - z112 * z550 + z146 * z552;
    const Scalar z602 = z122 * z543 - z538 + z123 * z548 + z124 * z550 - z176 * z552 + z177 * z554;
    const Scalar z603 = z540 + z118 * z543 - z120 * z548 + z121 * z550 + z172 * z552 - z174 * z554;
    const Scalar z604 = z601 + z603 * z599;
    const Scalar z605 = z557 - z603 * z590;
    const Scalar z606 = z558 - z603 * z583;
    const Scalar z607 = z602 - z603 * z580;
    const Scalar z608 = z75 * z548 - z542;
    const Scalar z609 = z603 * z575;
    const Scalar z610 = z608 - z603 * z609;
    const Scalar z611 = z412 * z536 + z541;
    const Scalar z612 = z582 * z586;
    const Scalar z613 = z584 + z582 * z612;
    const Scalar z614 = z587 + z588 * z612;
    const Scalar z615 = z596 + z597 * z612;
    const Scalar z616 = z606 - z607 * z612;
    const Scalar z617 = n1 / z613;
    const Scalar z618 = z588 * z586;
    const Scalar z619 = z591 - z588 * z618;
    const Scalar z620 = z595 + z597 * z618;
    const Scalar z621 = z605 - z607 * z618;
    const Scalar z622 = z597 * z586;
    const Scalar z623 = z600 - z597 * z622;
    const Scalar z624 = z604 + z607 * z622;
    const Scalar z625 = z607 * z586;
    const Scalar z626 = z610 - z607 * z625;
    const Scalar z627 = z412 * z569 + z571;
    const Scalar z628 = z608 + z598 + z589 - z577 + z565 + z574;
    const Scalar z629 = z279 * z386 - z328 + z285 * z392 + z342;
    const Scalar z630 = z279 * z402 + z285 * z405 - z414 * z629 + z372;
    const Scalar z631 = z614 * z617;
    const Scalar z632 = z619 + z614 * z631;
    const Scalar z633 = z620 - z615 * z631;
    const Scalar z634 = z621 - z616 * z631;
    const Scalar z635 = z615 * z617;
    const Scalar z636 = z623 + z615 * z635;
    const Scalar z637 = z279 * z410 - z328 * z412 + z285 * z413 - z415 * z629 - z450 * z630 + z377;
    const Scalar z638 = n1 / z632;
    const Scalar z639 = z624 + z616 * z635;
    const Scalar z640 = z285 * z416 + z368 - z427 * z629 - z451 * z630 - z472 * z637;
    const Scalar z641 = z285 * z438 - z384 - z442 * z629 - z452 * z630 - z473 * z637 + z488 * z640;
    const Scalar z642 = z285 * z443 - z383 - z463 * z629 - z465 * z630 - z471 * z637 + z487 * z640 + z499 * z641;
    const Scalar z643 = z502 * z642;
    const Scalar z644 = z633 * z638;
    const Scalar z645 = z636 - z633 * z644;
    const Scalar z646 = z639 - z634 * z644;
    const Scalar z647 = z494 * z641 + z499 * z643;
    const Scalar z648 = z616 * z617;
    const Scalar z649 = z626 + z616 * z648;
    const Scalar z650 = n1 / z645;
    const Scalar z651 = z634 * z638;
    const Scalar z652 = z479 * z640 + z487 * z643 + z488 * z647;
    const Scalar z653 = z649 - z634 * z651;
    const Scalar z654 = z457 * z637 + z471 * z643 + z473 * z647 + z472 * z652;
    const Scalar z655 = z433 * z630 + z465 * z643 + z452 * z647 + z451 * z652 - z450 * z654;
    const Scalar z656 = z646 * z650;
    const Scalar z657 = z398 * z629 + z463 * z643 + z442 * z647 + z427 * z652 - z415 * z654 - z414 * z655;
    const Scalar z658 = k34 * z285 + z443 * z643 + z438 * z647 + z416 * z652 - z413 * z654 - z405 * z655 - z392 * z657;
    const Scalar z659 = n25_over_7 * z279 - z410 * z654 - z402 * z655 - z386 * z657;
    const Scalar z660 = z228 - z643 + z122 * z654 - z123 * z655 + z124 * z657 - z176 * z658 - z177 * z659;
    const Scalar z661 = z647 - z288 + z118 * z654 + z120 * z655 + z121 * z657 + z172 * z658 + z174 * z659;
    const Scalar z662 = z110 * z655 - z185 - z652 + z112 * z657 - z146 * z658;
    const Scalar z663 = z657 + n25_over_3 * z328 + z412 * z654;
    const Scalar z664 = z206 + z643 + z143 * z654 - z132 * z655 + z152 * (z657 - z663);
    const Scalar z665 = z214 - z647 + z134 * z654 + z131 * z655 + z142 * (z657 - z663);
    const Scalar z666 = z652 - z99 + z75 * z655;
    const Scalar z667 = z653 - z646 * z656;
    const Scalar z668 = z580 * z661 - z660;
    const Scalar z669 = z665 + z583 * z661 - z612 * z668;
    const Scalar z670 = n1 / z667;
    const Scalar z671 = z590 * z661 - z664 - z618 * z668 - z631 * z669;
    const Scalar z672 = z599 * z661 - z662 - z622 * z668 - z635 * z669 + z644 * z671;
    const Scalar z673 = z666 + z609 * z661 - z625 * z668 + z648 * z669 - z651 * z671 + z656 * z672;
    const Scalar z674 = z670 * z673;
    const Scalar z675 = z650 * z672 + z656 * z674;
    const Scalar z676 = z638 * z671 - z651 * z674 + z644 * z675;
    const Scalar z677 = z617 * z669 - z648 * z674 + z635 * z675 + z631 * z676;
    const Scalar z678 = z586 * z668 - z625 * z674 - z622 * z675 - z618 * z676 + z612 * z677;
    const Scalar z679 = z575 * z661 + z609 * z674 + z599 * z675 + z590 * z676 - z583 * z677 + z580 * z678;
    const Scalar z680 = z643 + z538 * z674 + z523 * z675 - z512 * z676 - z507 * z677 + z506 * z678 + z564 * z679;
    const Scalar z681 = z647 + z540 * z674 + z524 * z675 + z513 * z676 + z510 * z677 + z508 * z678 + z566 * z679;
    const Scalar z682 = z652 + z542 * z674 + z526 * z675 + z515 * z676 - z511 * z677 + z532 * z678 + z567 * z679;
    const Scalar z683 = z654 + z543 * z674 + z527 * z675 + z517 * z676 - z514 * z677 + z536 * z678 - z569 * z679;
    const Scalar z684 = z548 * z674 - z655 - z529 * z675 + z525 * z676 - z516 * z677 + z539 * z678 + z570 * z679;
    const Scalar z685 = z657 + z550 * z674 + z530 * z675 - z528 * z676 - z518 * z677 + z541 * z678 - z571 * z679;
    const Scalar z686 = z658 + z552 * z674 + z545 * z675 - z533 * z676 - z519 * z677 + z544 * z678 + z572 * z679;
    const Scalar z687 = z663 + z555 * z674 + z546 * z675 + z534 * z676 + z521 * z677 + z611 * z678 - z627 * z679;
    const Scalar z688 = z554 * z674 - z659 + z547 * z675 + z537 * z676 - z522 * z677 - z549 * z678 - z573 * z679;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.x = z680;
    accelerations.y = -z681;
    accelerations.z = z682;
    accelerations.yaw = z683;
    accelerations.roll = z684;
    accelerations.pitch = z685;
    accelerations.steer = -z686;
    accelerations.rear = -z687;
    accelerations.front = -z688;
    multipliers.lambda_rear_touches = -z674;
    multipliers.lambda_front_touches = -z675;
    multipliers.lambda_rear_rolls_x = -z676;
    multipliers.lambda_rear_rolls_y = z677;
    multipliers.lambda_front_rolls_x = z678;
    multipliers.lambda_front_rolls_y = z679;
    const Scalar bound0_ = roundings_ * z628;
    if (!(traits::regular(z500, n94) && traits::regular(z492, n94) && traits::regular(z476, n94)
        && traits::regular(-z453, z400) && traits::regular(-z431, z375) && traits::regular(-z393, z352)
        && traits::regular(-z667, -bound0_) && traits::regular(-z645, -bound0_) && traits::regular(-z632, -bound0_)
        && traits::regular(z613, -bound0_) && traits::regular(-z581, -bound0_) && traits::regular(-z574,
        -bound0_))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = n0 * accelerations.x * accelerations.y * accelerations.z * accelerations.yaw
        * accelerations.roll * accelerations.pitch * accelerations.steer * accelerations.rear * accelerations.front
        * multipliers.lambda_rear_touches * multipliers.lambda_front_touches * multipliers.lambda_rear_rolls_x
        * multipliers.lambda_rear_rolls_y * multipliers.lambda_front_rolls_x * multipliers.lambda_front_rolls_y;
    if (!traits::finite(zero)) return torsor::Status::not_finite;
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
    const Scalar z8 = v_steer * c_steer;
    const Scalar z9 = v_roll * s_roll;
    const Scalar z10 = v_yaw * c_yaw;
    const Scalar z11 = v_yaw * s_yaw;
    const Scalar z12 = v_roll * c_roll;
    const Scalar z13 = s_yaw * c_roll;
    const Scalar z14 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z15 = v_pitch * c_pitch;
    const Scalar z16 = c_yaw * c_roll;
    const Scalar z17 = -z4 * (n1 - c_steer);
    const Scalar z18 = v_steer * s_steer;
    const Scalar z19 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z20 = v_pitch * s_pitch;
    const Scalar z21 = s_yaw * s_roll;
    const Scalar z22 = c_yaw * s_roll;
    const Scalar z23 = z13 * z13 + z16 * z16;
    const Scalar z24 = s_yaw * z9 - c_roll * z10;
    const Scalar z25 = c_yaw * z9 + c_roll * z11;
    const Scalar z26 = n2 * (z13 * z21 + z16 * z22);
    const Scalar z27 = s_roll * z13;
    const Scalar z28 = s_roll * z16;
    const Scalar z29 = v_roll * z12;
    const Scalar z30 = v_yaw * z11;
    const Scalar z31 = n2 * z9;
    const Scalar z32 = v_yaw * z10;
    const Scalar z33 = n0_08 * z6 - n0_35 * z7;
    const Scalar z34 = s_pitch * z7 - c_pitch * z6;
    const Scalar z35 = s_pitch * z6 + c_pitch * z7;
    const Scalar z36 = z2 * z8;
    const Scalar z37 = z1 * z8;
    const Scalar z38 = -z18 * (n1 - z3);
    const Scalar z39 = z4 * z18;
    const Scalar z40 = -z18 * (n1 - z5);
    const Scalar z41 = s_yaw * z29 + c_roll * z30 + z10 * z31;
    const Scalar z42 = c_yaw * z29 + c_roll * z32 - z11 * z31;
    const Scalar z43 = n0_08 * z36 - n0_35 * z37;
    const Scalar z44 = n0_35 * z39 + n0_08 * z38;
    const Scalar z45 = n0_08 * z14 - n0_35 * z17;
    const Scalar z46 = n0_08 * z17 - n0_35 * z19;
    const Scalar z47 = traits::sqrt(z23);
    const Scalar z48 = n0_08 * z39 + n0_35 * z40;
    const Scalar z49 = n2 * (z13 * z24 + z16 * z25);
    const Scalar z50 = s_roll * z35 - c_roll * c_steer;
    const Scalar z51 = s_roll * c_steer + c_roll * z35;
    const Scalar z52 = n0_3 + z46;
    const Scalar z53 = n1_1 - z45;
    const Scalar z54 = n2 * (z13 * z41 + z16 * z42 - z24 * z24 - z25 * z25);
    const Scalar z55 = s_pitch * z52 + c_pitch * z53;
    const Scalar z56 = s_pitch * z53 - c_pitch * z52;
    const Scalar z57 = c_yaw * z34 + s_yaw * z50;
    const Scalar z58 = s_yaw * z34 - c_yaw * z50;
    const Scalar z59 = z57 * z57 + z58 * z58;
    const Scalar z60 = s_roll * z56 - c_roll * z33;
    const Scalar z61 = s_roll * z33 + c_roll * z56;
    const Scalar z62 = q_z + n0_3 * z47;
    const Scalar z63 = z6 * z15 - z7 * z20 + s_pitch * z36 + c_pitch * z37;
    const Scalar z64 = n0_5 * z26 / z47;
    const Scalar z65 = z6 * z20 + z7 * z15 + s_pitch * z37 - c_pitch * z36;
    const Scalar z66 = c_roll * z18 + c_steer * z9 + z12 * z35 + s_roll * z63;
    const Scalar z67 = z10 * z50 - z11 * z34 + c_yaw * z65 + s_yaw * z66;
    const Scalar z68 = traits::sqrt(z59);
    const Scalar z69 = s_pitch * z44 - c_pitch * z48 - z53 * z15 - z52 * z20;
    const Scalar z70 = n0_3 * z64;
    const Scalar z71 = n0_5 * z49 / z47;
    const Scalar z72 = n0_5 * (z49 * z71 / (z47 * z47) + z54 / z47);
    const Scalar z73 = v_z - n0_3 * z71;
    const Scalar z74 = z10 * z34 + z11 * z50 + s_yaw * z65 - c_yaw * z66;
    const Scalar z75 = n2 * (z58 * z74 + z57 * z67);
    const Scalar z76 = s_yaw * z55 + c_yaw * z60;
    const Scalar z77 = z12 * z33 + s_roll * z43 - z9 * z56 - c_roll * z69;
    const Scalar z78 = s_yaw * z51;
    const Scalar z79 = s_yaw * z60 - c_yaw * z55;
    const Scalar z80 = c_yaw * z51;
    const Scalar z81 = n2 * (z57 * z78 - z58 * z80);
    const Scalar z82 = n0_5 * z75 / z68;
    const Scalar z83 = n0_3 / z47;
    const Scalar z84 = z2 * c_steer;
    const Scalar z85 = z1 * c_steer;
    const Scalar z86 = s_roll * z34;
    const Scalar z87 = n0_3 * z72;
    const Scalar z88 = s_pitch * z84 + c_pitch * z85;
    const Scalar z89 = s_pitch * z85 - c_pitch * z84;
    const Scalar z90 = n0_08 * z84 - n0_35 * z85;
    const Scalar z91 = n0_5 * z81 / z68;
    const Scalar z92 = c_roll * s_steer + s_roll * z88;
    const Scalar z93 = s_yaw * z86 - c_yaw * z35;
    const Scalar z94 = s_yaw * z35 + c_yaw * z86;
    const Scalar z95 = n2 * (z57 * z93 - z58 * z94);
    const Scalar z96 = c_yaw * z89 + s_yaw * z92;
    const Scalar z97 = s_yaw * z89 - c_yaw * z92;
    const Scalar z98 = s_steer * z4;
    const Scalar z99 = s_steer * (n1 - z3);
    const Scalar z100 = n0_08 * z99 - n0_35 * z98;
    const Scalar z101 = s_steer * (n1 - z5);
    const Scalar z102 = n0_08 * z98 - n0_35 * z101;
    const Scalar z103 = z60 + n0_35 * z91;
    const Scalar z104 = n0_5 * z95 / z68;
    const Scalar z105 = q_z - z61;
    const Scalar z106 = n2 * (z57 * z96 + z58 * z97);
    const Scalar z107 = c_pitch * z102 + s_pitch * z100;
    const Scalar z108 = z105 + n0_35 * z68;
    const Scalar z109 = v_steer * z8;
    const Scalar z110 = n0_5 * z106 / z68;
    const Scalar z111 = v_pitch * z20;
    const Scalar z112 = v_pitch * z15;
    const Scalar z113 = s_roll * z90 + c_roll * z107;
    const Scalar z114 = v_steer * z18;
    const Scalar z115 = v_roll * z9;
    const Scalar z116 = z2 * z114;
    const Scalar z117 = z1 * z114;
    const Scalar z118 = z4 * z109;
    const Scalar z119 = n0_35 / z68;
    const Scalar z120 = z51 * z58;
    const Scalar z121 = z6 * z111 + z7 * z112 + s_pitch * z116 + c_pitch * z117 - n2 * (z36 * z15 - z37 * z20);
    const Scalar z122 = z7 * z111 - z6 * z112 + s_pitch * z117 - c_pitch * z116 - n2 * (z36 * z20 + z37 * z15);
    const Scalar z123 = z113 - n0_35 * z110;
    const Scalar z124 = n0_08 * z116 - n0_35 * z117;
    const Scalar z125 = z35 * z115 - c_roll * z109 - c_steer * z29 + n2 * (z9 * z18 - z12 * z63) + s_roll * z121;
    const Scalar z126 = -z109 * (n1 - z3);
    const Scalar z127 = n0_35 * z118 + n0_08 * z126;
    const Scalar z128 = -z109 * (n1 - z5);
    const Scalar z129 = n0_08 * z118 + n0_35 * z128;
    const Scalar z130 = z51 * z57;
    const Scalar z131 = v_z - z77;
    const Scalar z132 = z131 + n0_35 * z82;
    const Scalar z133 = z32 * z34 + z30 * z50 - n2 * (z10 * z66 - z11 * z65) + c_yaw * z122 + s_yaw * z125;
    const Scalar z134 = z30 * z34 - z32 * z50 - n2 * (z10 * z65 + z11 * z66) + s_yaw * z122 - c_yaw * z125;
    const Scalar z135 = s_pitch * z127 - z52 * z112 - c_pitch * z129 + z53 * z111 + n2 * (z15 * z44 + z20 * z48);
    const Scalar z136 = z33 * z115 + s_roll * z124 + z29 * z56 - n2 * (z12 * z43 + z9 * z69) + c_roll * z135;
    const Scalar z137 = n2 * (z57 * z133 + z58 * z134 - z67 * z67 - z74 * z74);
    const Scalar z138 = n0_5 * (z75 * z82 / (z68 * z68) + z137 / z68);
    const Scalar z139 = z27 * z83;
    const Scalar z140 = z28 * z83;
    const Scalar z141 = z23 * z83;
    const Scalar z142 = s_roll * z25 - z16 * z12;
    const Scalar z143 = s_yaw * z141;
    const Scalar z144 = c_yaw * z141;
    const Scalar z145 = c_roll * z55;
    const Scalar z146 = z145 + n0_35 * z104;
    const Scalar z147 = c_roll * z43 - z9 * z33 - z12 * z56 + s_roll * z69;
    const Scalar z148 = s_pitch * z48 + c_pitch * z44 + z53 * z20 - z52 * z15;
    const Scalar z149 = s_roll * z18 - c_steer * z12 + z9 * z35 - c_roll * z63;
    const Scalar z150 = z136 - n0_35 * z138;
    const Scalar z151 = n0_35 * z82 / (z68 * z68);
    const Scalar z152 = n0_3 * z71 / (z47 * z47);
    const Scalar z153 = z23 * z152 - z49 * z83;
    const Scalar z154 = z28 * z152 - z83 * z142;
    const Scalar z155 = z75 * z119;
    const Scalar z156 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z157 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z158 = s_roll * z157;
    const Scalar z159 = s_pitch * z1 - c_pitch * z2;
    const Scalar z160 = z51 * z74 - z58 * z149;
    const Scalar z161 = z119 * z160;
    const Scalar z162 = z76 - z120 * z119;
    const Scalar z163 = z61 - z59 * z119;
    const Scalar z164 = s_pitch * z2 + c_pitch * z1;
    const Scalar z165 = s_roll * z159;
    const Scalar z166 = s_yaw * z148 - z10 * z55 + z11 * z60 + c_yaw * z147;
    const Scalar z167 = z79 + z130 * z119;
    const Scalar z168 = c_roll * z159;
    const Scalar z169 = s_yaw * z158 - c_yaw * z156;
    const Scalar z170 = z79 - z169;
    const Scalar z171 = z120 * z119;
    const Scalar z172 = z77 - z155 + z59 * z151;
    const Scalar z173 = s_yaw * z156 + c_yaw * z158;
    const Scalar z174 = z76 - z173;
    const Scalar z175 = z130 * z119 + z170;
    const Scalar z176 = s_yaw * z165 - c_yaw * z164;
    const Scalar z177 = z120 * z119 - z174;
    const Scalar z178 = z59 * z119;
    const Scalar z179 = c_roll * z157;
    const Scalar z180 = z61 - z179;
    const Scalar z181 = z130 * z119;
    const Scalar z182 = z120 * z151 - z166 - z161;
    const Scalar z183 = s_roll * z24 - z13 * z12;
    const Scalar z184 = z27 * z152 - z83 * z183;
    const Scalar z185 = z59 * z119 - z180;
    const Scalar z186 = s_yaw * z163;
    const Scalar z187 = c_yaw * z163;
    const Scalar z188 = s_yaw * z164 + c_yaw * z165;
    const Scalar z189 = z10 * z163 + s_yaw * z172;
    const Scalar z190 = s_roll * z162 + z16 * z163;
    const Scalar z191 = s_roll * z167 + z13 * z163;
    const Scalar z192 = z10 * z141 + s_yaw * z153;
    const Scalar z193 = c_yaw * z153 - z11 * z141;
    const Scalar z194 = z168 * z177 - z188 * z185;
    const Scalar z195 = z168 * z175 + z176 * z185;
    const Scalar z196 = s_roll * z140 + z16 * z141;
    const Scalar z197 = v_x + v_yaw * z140 + v_roll * z143 + z196 * (v_pitch + v_rear);
    const Scalar z198 = z12 * z140 - z25 * z141 + s_roll * z154 + z16 * z153;
    const Scalar z199 = v_yaw * z154 + v_roll * z192 + z198 * (v_pitch + v_rear);
    const Scalar z200 = z12 * z162 - z25 * z163 + z16 * z172 + s_roll * z182;
    const Scalar z201 = z12 * z139 - z24 * z141 + s_roll * z184 + z13 * z153;
    const Scalar z202 = v_yaw * z184 - v_roll * z193 + z201 * (v_pitch + v_rear);
    const Scalar z203 = s_roll * z139 + z13 * z141;
    const Scalar z204 = v_y + v_yaw * z139 - v_roll * z144 + z203 * (v_pitch + v_rear);
    const Scalar z205 = s_yaw * z147 - c_yaw * z148 - z10 * z60 - z11 * z55;
    const Scalar z206 = n0_3 * z15 - n1_1 * z20;
    const Scalar z207 = n1_1 * z15 + n0_3 * z20;
    const Scalar z208 = z12 * z157 + s_roll * z207;
    const Scalar z209 = c_roll * z207 - z9 * z157;
    const Scalar z210 = z51 * z67 - z57 * z149;
    const Scalar z211 = z119 * z210;
    const Scalar z212 = z11 * z156 - c_yaw * z206 + z10 * z158 + s_yaw * z208;
    const Scalar z213 = z10 * z156 + s_yaw * z206 - z11 * z158 + c_yaw * z208;
    const Scalar z214 = z77 - z209;
    const Scalar z215 = z166 + z213;
    const Scalar z216 = z205 + z212;
    const Scalar z217 = z216 - z211 + z130 * z151;
    const Scalar z218 = z214 - z155 + z59 * z151;
    const Scalar z219 = z59 * z151 - z155;
    const Scalar z220 = z205 - z211 + z130 * z151;
    const Scalar z221 = z24 * z163 - z12 * z167 + s_roll * z220 - z13 * z172;
    const Scalar z222 = c_yaw * z172 - z11 * z163;
    const Scalar z223 = z130 * z151 - z211;
    const Scalar z224 = z181 * z149 - z67 * z178 + z51 * z223 + z57 * z219;
    const Scalar z225 = z51 * z181 + z57 * z178;
    const Scalar z226 = v_y - v_yaw * z167 + v_roll * z187 - v_pitch * z191 + v_steer * z195 - v_front * z225;
    const Scalar z227 = z120 * z151 - z161 - z215;
    const Scalar z228 = z120 * z151 - z161;
    const Scalar z229 = z171 * z149 - z74 * z178 + z51 * z228 + z58 * z219;
    const Scalar z230 = z51 * z171 + z58 * z178;
    const Scalar z231 = v_x - v_yaw * z162 - v_roll * z186 - v_pitch * z190 - v_steer * z194 + v_front * z230;
    const Scalar z232 = z1 * z20 - z2 * z15;
    const Scalar z233 = z1 * z15 + z2 * z20;
    const Scalar z234 = c_roll * z233 - z9 * z159;
    const Scalar z235 = z12 * z159 + s_roll * z233;
    const Scalar z236 = s_yaw * z232 - z10 * z164 + z11 * z165 - c_yaw * z235;
    const Scalar z237 = z11 * z164 + c_yaw * z232 + z10 * z165 + s_yaw * z235;
    const Scalar z238 = z168 * z217 + z176 * z218 - z175 * z234 - z185 * z237;
    const Scalar z239 = z168 * z227 - z188 * z218 - z177 * z234 - z185 * z236;
    const Scalar z240 = v_yaw * z220 + v_roll * z222 + v_pitch * z221 - v_steer * z238 + v_front * z224;
    const Scalar z241 = v_yaw * z182 + v_roll * z189 + v_pitch * z200 + v_front * z229 - v_steer * z239;
    result.value[0] = -z62;
    result.rate[0] = -z73;
    result.gamma[0] = z87;
    result.value[1] = -z108;
    result.rate[1] = -z132;
    result.gamma[1] = -z150;
    result.value[2] = n0;
    result.rate[2] = z197;
    result.gamma[2] = z199;
    result.value[3] = n0;
    result.rate[3] = -z204;
    result.gamma[3] = -z202;
    result.value[4] = n0;
    result.rate[4] = z231;
    result.gamma[4] = -z241;
    result.value[5] = n0;
    result.rate[5] = -z226;
    result.gamma[5] = -z240;
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
    result.jacobian[20] = z140;
    result.jacobian[21] = -z139;
    result.jacobian[22] = -z162;
    result.jacobian[23] = z167;
    result.jacobian[24] = z70;
    result.jacobian[25] = -z103;
    result.jacobian[26] = z143;
    result.jacobian[27] = z144;
    result.jacobian[28] = -z186;
    result.jacobian[29] = -z187;
    result.jacobian[30] = n0;
    result.jacobian[31] = z146;
    result.jacobian[32] = z196;
    result.jacobian[33] = -z203;
    result.jacobian[34] = -z190;
    result.jacobian[35] = z191;
    result.jacobian[36] = n0;
    result.jacobian[37] = z123;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = -z194;
    result.jacobian[41] = -z195;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z196;
    result.jacobian[45] = -z203;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z230;
    result.jacobian[53] = z225;
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
    const Scalar k0 = traits::constant(0.3141592653589793, 0.31415927f,
        "4427007044615115050034854648525685871587/14091601085062767830857184402523750996530");
    const Scalar n0_1 = traits::constant(0.1, 0.1f, "1/10");
    const Scalar n1 = traits::constant(1.0, 1.0f, "1/1");
    const Scalar n2 = traits::constant(2.0, 2.0f, "2/1");
    const Scalar n0_08 = traits::constant(0.08, 0.08f, "2/25");
    const Scalar n0_35 = traits::constant(0.35, 0.35f, "7/20");
    const Scalar n0_3 = traits::constant(0.3, 0.3f, "3/10");
    const Scalar n1_1 = traits::constant(1.1, 1.1f, "11/10");
    const Scalar n0_5 = traits::constant(0.5, 0.5f, "1/2");
    const Scalar n9_81 = traits::constant(9.81, 9.81f, "981/100");
    const Scalar k10 = traits::constant(0.9534570696121847, 0.95345706f,
        "525519571112042718940803777777202731020156921024515291029654726624274787160578631/551172766830284188573790061702035814255006707159958171428531891660758897667606410");
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar k12 = traits::constant(0.20061665139658788, 0.20061666f,
        "1382180435281049145907121109643576521220371021393405956792663939457042810632956483/6889659585378552357172375771275447678187583839499477142856648645759486220845080125");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar k14 = traits::constant(46.686007365934024, 46.68601f,
        "12866027926070442963751385859967080732345328859301894534751105534737425465833752936/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
    const Scalar k15 = traits::constant(40.23024469547104, 40.230244f,
        "1108690763953106891919173818010564632270624322560169545605282827304553786348861088751/27558638341514209428689503085101790712750335357997908571426594583037944883380320500");
    const Scalar k16 = traits::constant(0.02079463202853559, 0.020794632f,
        "9870673077118022362064038943628123859779194979891059919709477732499388673643976711565585013906694661093800952941105542740091657643756066142827550216880165139488051/474674092023985659771773063467000735004239054917363287535680815092009038114573722194653880259309737937445197775559275044539243507350421076489030701809154176700156250");
    const Scalar k17 = traits::constant(0.005950872541725462, 0.0059508723f,
        "11298900081976005488039590346701483956312571499395628412519783507493819739182003600879011813971315003255906388553830486116652719658788633777063662087724795679803439/1898696368095942639087092253868002940016956219669453150142723260368036152458294888778615521037238951749780791102237100178156974029401684305956122807236616706800625000");
    const Scalar k18 = traits::constant(0.1538973160142678, 0.15389732f,
        "584408549952007626866251632634629339223983214964697293769799486655623930450106539925724994593314357796562290858106469922091418177013307660380717446544429655409731579/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k19 = traits::constant(0.13310268398573222, 0.13310269f,
        "505443165335063447969739321085604348345749655125568814412123664795628821060954726233200314482060800507811883234577625580170684915863259131238097044809388334293827171/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k20 = traits::constant(0.14689731601426778, 0.14689732f,
        "557826800798664429919032341080477298063745827889324949667801361010471424315690411482824377298793012472065359782675150519597220540601684080097331727243117021514522829/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k21 = traits::constant(59.040074516557205, 59.040073f,
        "22419835011340195864938008360375209703633812617890927422714863973332510398067221674363493503543408565365030137642361868510789955371931686079970032045188759748777393/379739273619188527817418450773600588003391243933890630028544652073607230491658977755723104207447790349956158220447420035631394805880336861191224561447323341360125");
    const Scalar k22 = traits::constant(22.569969249659824, 22.56997f,
        "342828149138929719688783421449433478383028442784206544289031539175655916942927043559135766444260552962888647402643521015968905122464918622479097614868309626665425561/15189570944767541112696738030944023520135649757355625201141786082944289219666359110228924168297911613998246328817896801425255792235213474447648982457892933654405000");
    const Scalar k23 = traits::constant(55.936141270888, 55.936142f,
        "1699291972421385779877304374579996783277772861866033461925154383125417806323203985914337366054365021881629239146738534203740799834285687221595413985583845260841241379/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar k24 = traits::constant(3.1039332456692037, 3.1039333f,
        "94294828485829889317736294250019993012932147565240731892034734741183025522173748034742114229107663347573171864650415277122396595468847664802188578031255519060950061/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar k25 = traits::constant(1.9069141392243694, 1.9069141f,
        "525519571112042718940803777777202731020156921024515291029654726624274787160578631/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
    const Scalar k26 = traits::constant(30.0803372582786, 30.080338f,
        "913814833654314341168408299052484260902016513833729810508994044417847786422246988993462272564730982369247640341767809896108739855656047662664836731549865211404221963/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar n94 = traits::constant(94.0, 94.0f, "94/1");
    const Scalar n0_14 = traits::constant(0.14, 0.14f, "7/50");
    const Scalar n0_1435 = traits::constant(0.1435, 0.1435f, "287/2000");
    const Scalar k30 = traits::constant(0.010397316014267795, 0.010397316f,
        "9870673077118022362064038943628123859779194979891059919709477732499388673643976711565585013906694661093800952941105542740091657643756066142827550216880165139488051/949348184047971319543546126934001470008478109834726575071361630184018076229147444389307760518619475874890395551118550089078487014700842152978061403618308353400312500");
    const Scalar n0_06 = traits::constant(0.06, 0.06f, "3/50");
    const Scalar k32 = traits::constant(26.4161040126094, 26.416103f,
        "802498571967777945279784040164988395132420357150396365016559824192117390400515118939797625912628679267028033641044059463309201619408419778396612703776294870890145659/30379141889535082225393476061888047040271299514711250402283572165888578439332718220457848336595823227996492657635793602850511584470426948895297964915785867308810000");
    const Scalar k33 = traits::constant(29.520037258278602, 29.520037f,
        "22419835011340195864938008360375209703633812617890927422714863973332510398067221674363493503543408565365030137642361868510789955371931686079970032045188759748777393/759478547238377055634836901547201176006782487867781260057089304147214460983317955511446208414895580699912316440894840071262789611760673722382449122894646682720250");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n1_over_94 = traits::constant(0.010638297872340425, 0.010638298f, "1/94");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar k39 = traits::constant(6.497839117007668, 6.497839f,
        "3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000/584408549952007626866251632634629339223983214964697293769799486655623930450106539925724994593314357796562290858106469922091418177013307660380717446544429655409731579");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
    const Scalar n0 = traits::constant(0.0, 0.0f, "0/1");
    const Scalar a_x = accelerations.x;
    const Scalar a_y = accelerations.y;
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
    const Scalar z0 = k0 + q_pitch;
    const Scalar z1 = k0 - q_rear;
    const Scalar z2 = k0 - q_front;
    const Scalar angles_[] = {q_yaw, q_roll, q_pitch, q_steer, z0, z1, z2};
    Scalar sines_[7], cosines_[7];
    torsor::sines_and_cosines(angles_, sines_, cosines_);
    const Scalar s_yaw = sines_[0], c_yaw = cosines_[0];
    const Scalar s_roll = sines_[1], c_roll = cosines_[1];
    const Scalar s_pitch = sines_[2], c_pitch = cosines_[2];
    const Scalar s_steer = sines_[3], c_steer = cosines_[3];
    const Scalar z3 = sines_[4], z4 = cosines_[4];
    const Scalar z5 = sines_[5], z6 = cosines_[5];
    const Scalar z7 = sines_[6], z8 = cosines_[6];
    const Scalar pi = traits::pi();
    const Scalar z9 = traits::formula(0.3141592653589793, 0.31415927f, [&]() -> Scalar {
      return n0_1 * pi;
    });
    const Scalar z10 = traits::formula(0.30901699437494745, 0.309017f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z9, sine, cosine);
      return sine;
    });
    const Scalar z11 = traits::formula(0.9510565162951535, 0.95105654f, [&]() -> Scalar {
      Scalar sine, cosine;
      traits::sincos(z9, sine, cosine);
      return cosine;
    });
    const Scalar z12 = traits::formula(0.09549150281252629, 0.095491506f, [&]() -> Scalar {
      return z10 * z10;
    });
    const Scalar z13 = traits::formula(0.29389262614623657, 0.29389262f, [&]() -> Scalar {
      return z10 * z11;
    });
    const Scalar z14 = traits::formula(0.9045084971874737, 0.9045085f, [&]() -> Scalar {
      return z11 * z11;
    });
    const Scalar z15 = z11 * s_steer;
    const Scalar z16 = z10 * s_steer;
    const Scalar z17 = s_yaw * c_roll;
    const Scalar z18 = c_yaw * c_roll;
    const Scalar z19 = v_yaw * s_yaw;
    const Scalar z20 = v_roll * s_roll;
    const Scalar z21 = z10 * z10 * (n1 - c_steer) + c_steer;
    const Scalar z22 = v_steer * c_steer;
    const Scalar z23 = v_yaw * c_yaw;
    const Scalar z24 = v_roll * c_roll;
    const Scalar z25 = s_yaw * s_roll;
    const Scalar z26 = -z13 * (n1 - c_steer);
    const Scalar z27 = c_yaw * s_roll;
    const Scalar z28 = z11 * z11 * (n1 - c_steer) + c_steer;
    const Scalar z29 = v_pitch * c_pitch;
    const Scalar z30 = v_steer * s_steer;
    const Scalar z31 = z17 * z17;
    const Scalar z32 = s_yaw * z20 - c_roll * z23;
    const Scalar z33 = c_yaw * z20 + c_roll * z19;
    const Scalar z34 = n2 * (z17 * z25 + z18 * z27);
    const Scalar z35 = s_roll * z17;
    const Scalar z36 = s_roll * z18;
    const Scalar z37 = v_roll * z24;
    const Scalar z38 = v_yaw * z19;
    const Scalar z39 = n2 * z23;
    const Scalar z40 = v_yaw * z23;
    const Scalar z41 = n2 * z19;
    const Scalar z42 = n0_08 * z15 - n0_35 * z16;
    const Scalar z43 = s_pitch * z16 - c_pitch * z15;
    const Scalar z44 = s_pitch * z15 + c_pitch * z16;
    const Scalar z45 = z11 * z22;
    const Scalar z46 = z10 * z22;
    const Scalar z47 = -z30 * (n1 - z12);
    const Scalar z48 = z13 * z30;
    const Scalar z49 = z18 * z18 + z31;
    const Scalar z50 = s_yaw * z37 + c_roll * z38 + z20 * z39;
    const Scalar z51 = c_yaw * z37 + c_roll * z40 - z20 * z41;
    const Scalar z52 = n0_08 * z45 - n0_35 * z46;
    const Scalar z53 = n0_35 * z48 + n0_08 * z47;
    const Scalar z54 = n0_08 * z21 - n0_35 * z26;
    const Scalar z55 = n0_08 * z26 - n0_35 * z28;
    const Scalar z56 = traits::sqrt(z49);
    const Scalar z57 = v_pitch * s_pitch;
    const Scalar z58 = -z30 * (n1 - z14);
    const Scalar z59 = n0_08 * z48 + n0_35 * z58;
    const Scalar z60 = z15 * z29 - z16 * z57 + s_pitch * z45 + c_pitch * z46;
    const Scalar z61 = n2 * (z17 * z32 + z18 * z33);
    const Scalar z62 = s_roll * z44;
    const Scalar z63 = c_yaw * z43;
    const Scalar z64 = s_yaw * z43;
    const Scalar z65 = s_roll * c_steer + c_roll * z44;
    const Scalar z66 = n0_3 + z55;
    const Scalar z67 = c_roll * c_steer - z62;
    const Scalar z68 = n1_1 - z54;
    const Scalar z69 = s_roll * z42;
    const Scalar z70 = n2 * (z17 * z50 + z18 * z51 - z32 * z32 - z33 * z33);
    const Scalar z71 = s_yaw * z67 - z63;
    const Scalar z72 = c_yaw * z67 + z64;
    const Scalar z73 = z71 * z71;
    const Scalar z74 = c_roll * z30 + c_steer * z20 + z24 * z44 + s_roll * z60;
    const Scalar z75 = z72 * z72 + z73;
    const Scalar z76 = s_pitch * z68 - c_pitch * z66;
    const Scalar z77 = traits::sqrt(z75);
    const Scalar z78 = s_pitch * z66 + c_pitch * z68;
    const Scalar z79 = s_roll * z76 - c_roll * z42;
    const Scalar z80 = n0_5 * z34 / z56;
    const Scalar z81 = c_roll * z76 + z69;
    const Scalar z82 = n0_3 / z56;
    const Scalar z83 = n0_5 * z61 / z56;
    const Scalar z84 = z15 * z57 + z16 * z29 + s_pitch * z46 - c_pitch * z45;
    const Scalar z85 = z23 * z43 - z19 * z67 + s_yaw * z84 - c_yaw * z74;
    const Scalar z86 = c_yaw * z84 - z19 * z43 - z23 * z67 + s_yaw * z74;
    const Scalar z87 = n0_3 * z80;
    const Scalar z88 = z11 * c_steer;
    const Scalar z89 = s_roll * z43;
    const Scalar z90 = s_yaw * z89 - c_yaw * z44;
    const Scalar z91 = s_yaw * z65;
    const Scalar z92 = s_yaw * z44 + c_yaw * z89;
    const Scalar z93 = c_yaw * z65;
    const Scalar z94 = n2 * (z71 * z91 + z72 * z93);
    const Scalar z95 = s_yaw * z79 - c_yaw * z78;
    const Scalar z96 = n2 * (z71 * z90 + z72 * z92);
    const Scalar z97 = n2 * (z71 * z86 - z72 * z85);
    const Scalar z98 = s_yaw * z78 + c_yaw * z79;
    const Scalar z99 = n0_5 * z94 / z77;
    const Scalar z100 = c_roll * z78;
    const Scalar z101 = s_pitch * z53 - c_pitch * z59 - z68 * z29 - z66 * z57;
    const Scalar z102 = n0_5 * z96 / z77;
    const Scalar z103 = n0_5 * z97 / z77;
    const Scalar z104 = z24 * z42 + s_roll * z52 - z20 * z76 - c_roll * z101;
    const Scalar z105 = n0_5 * (z61 * z83 / (z56 * z56) + z70 / z56);
    const Scalar z106 = n0_3 * z105;
    const Scalar z107 = z10 * c_steer;
    const Scalar z108 = s_pitch * z88 + c_pitch * z107;
    const Scalar z109 = s_pitch * z107 - c_pitch * z88;
    const Scalar z110 = z65 * z72;
    const Scalar z111 = n0_35 / z77;
    const Scalar z112 = c_roll * s_steer + s_roll * z108;
    const Scalar z113 = s_steer * z13;
    const Scalar z114 = v_pitch * z57;
    const Scalar z115 = s_steer * (n1 - z12);
    const Scalar z116 = n0_08 * z115 - n0_35 * z113;
    const Scalar z117 = c_yaw * z109 + s_yaw * z112;
    const Scalar z118 = s_yaw * z109 - c_yaw * z112;
    const Scalar z119 = s_steer * (n1 - z14);
    const Scalar z120 = n0_08 * z113 - n0_35 * z119;
    const Scalar z121 = n2 * (z71 * z117 - z72 * z118);
    const Scalar z122 = v_pitch * z29;
    const Scalar z123 = v_steer * z30;
    const Scalar z124 = z65 * z71;
    const Scalar z125 = z11 * z123;
    const Scalar z126 = z10 * z123;
    const Scalar z127 = v_steer * z22;
    const Scalar z128 = v_roll * z20;
    const Scalar z129 = c_pitch * z120 + s_pitch * z116;
    const Scalar z130 = n0_08 * z88 - n0_35 * z107;
    const Scalar z131 = z15 * z114 + z16 * z122 + s_pitch * z125 + c_pitch * z126 - n2 * (z45 * z29 - z46 * z57);
    const Scalar z132 = n0_5 * z121 / z77;
    const Scalar z133 = z16 * z114 - z15 * z122 + s_pitch * z126 - c_pitch * z125 - n2 * (z45 * z57 + z46 * z29);
    const Scalar z134 = n0_08 * z125 - n0_35 * z126;
    const Scalar z135 = s_roll * z130 + c_roll * z129;
    const Scalar z136 = z35 * z82;
    const Scalar z137 = z100 - n0_35 * z102;
    const Scalar z138 = z44 * z128 - c_roll * z127 - c_steer * z37 + n2 * (z20 * z30 - z24 * z60) + s_roll * z131;
    const Scalar z139 = z49 * z82;
    const Scalar z140 = z79 - n0_35 * z99;
    const Scalar z141 = z95 - z124 * z111;
    const Scalar z142 = z98 - z110 * z111;
    const Scalar z143 = s_pitch * z11 + c_pitch * z10;
    const Scalar z144 = s_pitch * z10 - c_pitch * z11;
    const Scalar z145 = z81 - z75 * z111;
    const Scalar z146 = s_roll * z144;
    const Scalar z147 = c_roll * z144;
    const Scalar z148 = z40 * z43 - z38 * z67 - n2 * (z23 * z74 - z19 * z84) + c_yaw * z133 + s_yaw * z138;
    const Scalar z149 = z38 * z43 + z40 * z67 - n2 * (z23 * z84 + z19 * z74) + s_yaw * z133 - c_yaw * z138;
    const Scalar z150 = s_yaw * z143 + c_yaw * z146;
    const Scalar z151 = z36 * z82;
    const Scalar z152 = s_yaw * z146 - c_yaw * z143;
    const Scalar z153 = z135 + n0_35 * z132;
    const Scalar z154 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z155 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z156 = s_roll * z154;
    const Scalar z157 = c_roll * z154;
    const Scalar z158 = n0_3 * z83 / (z56 * z56);
    const Scalar z159 = s_yaw * z155 + c_yaw * z156;
    const Scalar z160 = s_yaw * z156 - c_yaw * z155;
    const Scalar z161 = z81 - z157;
    const Scalar z162 = z13 * z127;
    const Scalar z163 = s_roll * z136 + z17 * z139;
    const Scalar z164 = z98 - z159;
    const Scalar z165 = z95 - z160;
    const Scalar z166 = c_yaw * z145;
    const Scalar z167 = s_roll * z32 - z17 * z24;
    const Scalar z168 = -z127 * (n1 - z12);
    const Scalar z169 = z110 * z111 - z164;
    const Scalar z170 = z124 * z111 - z165;
    const Scalar z171 = n0_35 * z162 + n0_08 * z168;
    const Scalar z172 = z75 * z111 - z161;
    const Scalar z173 = n2 * (z85 * z85 + z86 * z86 + z71 * z148 - z72 * z149);
    const Scalar z174 = s_yaw * z145;
    const Scalar z175 = s_roll * z141 + z17 * z145;
    const Scalar z176 = -z127 * (n1 - z14);
    const Scalar z177 = n0_08 * z162 + n0_35 * z176;
    const Scalar z178 = z110 * z111;
    const Scalar z179 = z124 * z111;
    const Scalar z180 = z35 * z158 - z82 * z167;
    const Scalar z181 = s_roll * z142 + z18 * z145;
    const Scalar z182 = s_yaw * z139;
    const Scalar z183 = z147 * z170 - z152 * z172;
    const Scalar z184 = z97 * z103;
    const Scalar z185 = s_roll * z151 + z18 * z139;
    const Scalar z186 = z147 * z169 - z150 * z172;
    const Scalar z187 = s_roll * z33 - z18 * z24;
    const Scalar z188 = c_yaw * z139;
    const Scalar z189 = z36 * z158 - z82 * z187;
    const Scalar z190 = z49 * z158 - z61 * z82;
    const Scalar z191 = s_pitch * z171 - z66 * z122 - c_pitch * z177 + z68 * z114 + n2 * (z29 * z53 + z57 * z59);
    const Scalar z192 = z75 * z111;
    const Scalar z193 = z65 * z178 + z72 * z192;
    const Scalar z194 = c_yaw * z190 - z19 * z139;
    const Scalar z195 = z24 * z136 - z32 * z139 + s_roll * z180 + z17 * z190;
    const Scalar z196 = z23 * z139 + s_yaw * z190;
    const Scalar z197 = z24 * z151 - z33 * z139 + s_roll * z189 + z18 * z190;
    const Scalar z198 = z42 * z128 + s_roll * z134 + z37 * z76 - n2 * (z24 * z52 + z20 * z101) + c_roll * z191;
    const Scalar z199 = s_roll * z30 - c_steer * z24 + z20 * z44 - c_roll * z60;
    const Scalar z200 = z65 * z179 + z71 * z192;
    const Scalar z201 = s_pitch * z59;
    const Scalar z202 = c_roll * z52;
    const Scalar z203 = z201 + c_pitch * z53 - z66 * z29 + z68 * z57;
    const Scalar z204 = z202 - z20 * z42 - z24 * z76 + s_roll * z101;
    const Scalar z205 = z65 * z85 - z72 * z199;
    const Scalar z206 = n0_5 * (z184 / (z77 * z77) - z173 / z77);
    const Scalar z207 = z198 - n0_35 * z206;
    const Scalar z208 = n0_3 * z29 - n1_1 * z57;
    const Scalar z209 = z10 * z29 + z11 * z57;
    const Scalar z210 = n1_1 * z29 + n0_3 * z57;
    const Scalar z211 = z24 * z154 + s_roll * z210;
    const Scalar z212 = s_yaw * z203 - z23 * z78 + z19 * z79 + c_yaw * z204;
    const Scalar z213 = z111 * z205;
    const Scalar z214 = c_roll * z209 - z20 * z144;
    const Scalar z215 = z23 * z155 + s_yaw * z208 - z19 * z156 + c_yaw * z211;
    const Scalar z216 = n0_35 * z103 / (z77 * z77);
    const Scalar z217 = z212 + z215;
    const Scalar z218 = z212 + z213 + z110 * z216;
    const Scalar z219 = z217 + z213 + z110 * z216;
    const Scalar z220 = z97 * z111;
    const Scalar z221 = z75 * z216 - z104 - z220;
    const Scalar z222 = v_yaw * z189 + v_roll * z196 + z197 * (v_pitch + v_rear);
    const Scalar z223 = z10 * z57 - z11 * z29;
    const Scalar z224 = c_roll * z210 - z20 * z154;
    const Scalar z225 = z24 * z144 + s_roll * z209;
    const Scalar z226 = s_yaw * z223 - z23 * z143 + z19 * z146 - c_yaw * z225;
    const Scalar z227 = z104 - z224;
    const Scalar z228 = z33 * z145 - z24 * z142 + s_roll * z218 + z18 * z221;
    const Scalar z229 = s_yaw * z221 - z23 * z145;
    const Scalar z230 = v_yaw * z180 - v_roll * z194 + z195 * (v_pitch + v_rear);
    const Scalar z231 = z110 * z216 + z213;
    const Scalar z232 = z75 * z216 - z220 - z227;
    const Scalar z233 = z75 * z216 - z220;
    const Scalar z234 = v_yaw * s_roll;
    const Scalar z235 = v_yaw * c_roll;
    const Scalar z236 = v_pitch + z234;  // angular velocity of frame, z
    const Scalar z237 = v_roll * z3 + z4 * z235;
    const Scalar z238 = v_roll * z4 - z3 * z235;
    const Scalar z239 = a_yaw * c_roll;
    const Scalar z240 = v_roll * z234 - z239;  // angular acceleration of frame.2, y
    const Scalar z241 = s_steer * z236 + c_steer * z238;
    const Scalar z242 = a_yaw * s_roll;
    const Scalar z243 = v_roll * z235 + z242;  // angular acceleration of frame.2, x
    const Scalar z244 = z71 * z199 + z65 * z86;
    const Scalar z245 = s_steer * z238 - c_steer * z236;
    const Scalar z246 = s_yaw * z204 - c_yaw * z203 - z23 * z79 - z19 * z78;
    const Scalar z247 = z111 * z244;
    const Scalar z248 = a_roll * z4 + z3 * z240;
    const Scalar z249 = v_pitch * z237 - z248;  // angular acceleration of frame, x
    const Scalar z250 = z19 * z155 - c_yaw * z208 + z23 * z156 + s_yaw * z211;
    const Scalar z251 = z246 + z250;
    const Scalar z252 = z246 - z247 + z124 * z216;
    const Scalar z253 = a_pitch + z243;  // angular acceleration of frame, z
    const Scalar z254 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z255 = z251 - z247 + z124 * z216;
    const Scalar z256 = z124 * z216 - z247;
    const Scalar z257 = a_roll * z3 - z4 * z240;
    const Scalar z258 = v_pitch * z238 + z257;  // angular acceleration of frame, y
    const Scalar z259 = a_rear + z253;  // angular acceleration of rear_wheel, z
    const Scalar z260 = c_steer * z253 + s_steer * z249;
    const Scalar z261 = n9_81 - a_z;
    const Scalar z262 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z263 = z5 * z237 + z6 * z238;
    const Scalar z264 = v_rear + z236;  // angular velocity of rear_wheel, z
    const Scalar z265 = z5 * z238 - z6 * z237;
    const Scalar z266 = s_roll * z254 - c_roll * z261;
    const Scalar z267 = z19 * z143 + c_yaw * z223 + z23 * z146 + s_yaw * z225;
    const Scalar z268 = z238 * z237;
    const Scalar z269 = z237 * z237;
    const Scalar z270 = s_steer * z253 - c_steer * z249;
    const Scalar z271 = z3 * z262 + z4 * z266;
    const Scalar z272 = z253 - z268;
    const Scalar z273 = z236 * z236;
    const Scalar z274 = z169 * z214 + z172 * z226 + z147 * z219 - z150 * z232;
    const Scalar z275 = v_steer * z241 - z260;  // angular acceleration of fork, y
    const Scalar z276 = v_steer * z245 - z270;  // angular acceleration of fork, x
    const Scalar z277 = v_steer + z237;  // angular velocity of fork, z
    const Scalar z278 = z271 - k10 * z272;
    const Scalar z279 = z238 * z236;
    const Scalar z280 = z3 * z266 - z4 * z262;
    const Scalar z281 = z269 + z273;
    const Scalar z282 = s_roll * z261 + c_roll * z254;
    const Scalar z283 = z258 + z279;
    const Scalar z284 = z19 * z145 + c_yaw * z221;
    const Scalar z285 = z170 * z214 - z172 * z267 + z147 * z255 - z152 * z232;
    const Scalar z286 = z280 + k10 * z281;
    const Scalar z287 = z282 - k10 * z283;
    const Scalar z288 = s_steer * z286 - c_steer * z287;
    const Scalar z289 = s_steer * z287 + c_steer * z286;
    const Scalar z290 = z32 * z145 - z24 * z141 + s_roll * z252 + z17 * z221;
    const Scalar z291 = z85 * z192 - z178 * z199 + z65 * z231 + z72 * z233;
    const Scalar z292 = a_steer + z258;  // angular acceleration of fork, z
    const Scalar z293 = z65 * z256 + z71 * z233 - z86 * z192 - z179 * z199;
    const Scalar z294 = v_yaw * z252 - v_roll * z284 + v_pitch * z290 - v_steer * z285 + v_front * z293;
    const Scalar z295 = v_yaw * z218 + v_pitch * z228 - v_steer * z274 + v_front * z291 + v_roll * z229;
    const Scalar z296 = n0_12 * z259;  // moment on rear_wheel, z
    const Scalar z297 = z7 * z277 + z8 * z241;
    const Scalar z298 = z7 * z241 - z8 * z277;
    const Scalar z299 = v_front - z245;  // angular velocity of front_wheel, z
    const Scalar z300 = z245 * z245;
    const Scalar z301 = z277 * z277;
    const Scalar z302 = z241 * z277;
    const Scalar z303 = z241 * z241;
    const Scalar z304 = z263 * z264;
    const Scalar z305 = n0_12 * z304;  // moment on rear_wheel, x
    const Scalar z306 = z300 + z301;
    const Scalar z307 = z301 - z303;
    const Scalar z308 = z300 + z303;
    const Scalar z309 = k12 * z306;  // force on fork, x
    const Scalar z310 = z241 * z245;
    const Scalar z311 = z275 + z302;
    const Scalar z312 = k12 * z311;  // force on fork, z
    const Scalar z313 = z265 * z264;
    const Scalar z314 = n0_12 * z313;  // moment on rear_wheel, y
    const Scalar z315 = z238 * z238;
    const Scalar z316 = z273 + z315;
    const Scalar z317 = z245 * z277;
    const Scalar z318 = z292 - z310;
    const Scalar z319 = z297 * z299;
    const Scalar z320 = n0_28 * z319;  // moment on front_wheel, x
    const Scalar z321 = z269 - z315;
    const Scalar z322 = k14 * z272 - z312 - k15 * z316;  // force on frame, y
    const Scalar z323 = z298 * z299;
    const Scalar z324 = n0_28 * z323;  // moment on front_wheel, y
    const Scalar z325 = k12 * z318;  // force on fork, y
    const Scalar z326 = a_front - z275;  // angular acceleration of front_wheel, z
    const Scalar z327 = n0_28 * z326;  // moment on front_wheel, z
    const Scalar z328 = z275 - z302;
    const Scalar z329 = z5 * z305 - z6 * z314;
    const Scalar z330 = z5 * z314 + z6 * z305;
    const Scalar z331 = k16 * z302 + k17 * z307 + k12 * z278 - z327;  // moment on fork, y
    const Scalar z332 = z237 * z236;
    const Scalar z333 = s_steer * z309 - c_steer * z325;
    const Scalar z334 = v_roll * z234;
    const Scalar z335 = z7 * z320 - z8 * z324;
    const Scalar z336 = z8 * z320 + z7 * z324;
    const Scalar z337 = k18 * z317 + k19 * z276 + k17 * z318 + z335;  // moment on fork, x
    const Scalar z338 = s_steer * z325 + c_steer * z309;
    const Scalar z339 = z249 + z332;
    const Scalar z340 = z276 - z317;
    const Scalar z341 = k18 * z292 + k19 * z310 + k17 * z340 + k12 * z288 + z336;  // moment on fork, z
    const Scalar z342 = k20 * s_steer;
    const Scalar z343 = k19 + s_steer * z342;
    const Scalar z344 = k17 * c_steer;
    const Scalar z345 = k12 * c_steer;
    const Scalar z346 = k20 * c_steer;
    const Scalar z347 = k12 * s_steer;
    const Scalar z348 = s_steer * z346;
    const Scalar z349 = k19 + c_steer * z346;
    const Scalar z350 = k17 * s_steer;
    const Scalar z351 = z3 * z347;
    const Scalar z352 = n0_28 * s_steer;
    const Scalar z353 = s_roll * z351 - c_roll * z345;
    const Scalar z354 = k14 * z282 - z330 - k21 * z279 + k22 * z339 + k10 * z333 - z341;  // moment on frame, y
    const Scalar z355 = n0_28 * c_steer;
    const Scalar z356 = k18 + k10 * z345;
    const Scalar z357 = z4 * z347;
    const Scalar z358 = z3 * z352;
    const Scalar z359 = z3 * z344 + z4 * z356;
    const Scalar z360 = s_yaw * z353 - c_yaw * z357;
    const Scalar z361 = s_roll * z355 + c_roll * z358;
    const Scalar z362 = c_steer * z331;
    const Scalar z363 = z253 + z268;
    const Scalar z364 = k14 * z281 + z338 + k15 * z363;  // force on frame, x
    const Scalar z365 = s_roll * z350 - c_roll * z359;
    const Scalar z366 = s_yaw * z357 + c_yaw * z353;
    const Scalar z367 = k14 * z283 - z333 - k15 * z339;  // force on frame, z
    const Scalar z368 = z3 * z356 - z4 * z344;
    const Scalar z369 = s_roll * z345 + c_roll * z351;
    const Scalar z370 = s_steer * z337 + z362;
    // moment on frame, z
    const Scalar z371 = z296 + k23 * z253 - k24 * z268 + k22 * z321 - k14 * z271 + k15 * z280 - k10 * z312 - z370;
    const Scalar z372 = s_steer * z331;
    const Scalar z373 = k10 * z347 + z348;
    const Scalar z374 = c_steer * z337 - z372;
    const Scalar z375 = k24 - z343;
    const Scalar z376 = k25 * z345 + z349;
    const Scalar z377 = k23 + z376;
    const Scalar z378 = z329 + k15 * z282 + k23 * z332 - k24 * z249 - k22 * z283 + z374;  // moment on frame, x
    const Scalar z379 = n0_12 + z377;
    const Scalar z380 = k22 - z344;
    const Scalar z381 = k18 + k25 * z345;
    const Scalar z382 = n2 * z380;
    const Scalar z383 = z381 + z375;
    const Scalar z384 = k14 + z345;
    const Scalar z385 = z3 * z373 - z4 * z350;
    const Scalar z386 = z3 * z382 - z4 * z383;
    const Scalar z387 = k15 * z4 + z3 * z384;
    const Scalar z388 = k15 * z3 - z4 * z384;
    const Scalar z389 = s_roll * z388;
    const Scalar z390 = n0_12 * s_roll;
    const Scalar z391 = s_roll * z379 + c_roll * z385;
    const Scalar z392 = z4 * z386;
    const Scalar z393 = s_yaw * z389 - c_yaw * z387;
    const Scalar z394 = z375 + z392;
    const Scalar z395 = s_yaw * z387 + c_yaw * z389;
    const Scalar z396 = z4 * z352;
    const Scalar z397 = z3 * z350 + z4 * z373;
    const Scalar z398 = c_roll * z388;
    const Scalar z399 = z3 * z364 - z4 * z322;
    const Scalar z400 = z381 + z392;
    const Scalar z401 = z3 * z378 - z4 * z354;
    const Scalar z402 = k26 * (z240 + z334) - z401;  // moment on frame.2, y
    const Scalar z403 = z3 * z322 + z4 * z364;
    const Scalar z404 = k26 - z394;
    const Scalar z405 = z3 * z386 - z380;
    const Scalar z406 = k26 + z400;
    const Scalar z407 = s_roll * z399 - c_roll * z367;
    const Scalar z408 = s_yaw * z403 + c_yaw * z407;
    const Scalar z409 = s_yaw * z407 - c_yaw * z403;
    const Scalar z410 = z234 * z235;
    const Scalar z411 = c_roll * z347 + s_roll * z387;
    const Scalar z412 = s_roll * z347 - c_roll * z387;
    const Scalar z413 = s_roll * z397 + c_roll * z405;
    const Scalar z414 = s_roll * z367 + c_roll * z399;
    const Scalar z415 = n94 * z261 - z414;  // force on frame.z, z
    const Scalar z416 = z379 - z404;
    const Scalar z417 = s_yaw * z412;
    const Scalar z418 = c_yaw * z412;
    const Scalar z419 = n94 * a_x + z409;  // force on frame.z, x
    const Scalar z420 = n2 * z385;
    const Scalar z421 = n94 * a_y - z408;  // force on frame.z, y
    const Scalar z422 = c_roll * z420 + s_roll * z416;
    const Scalar z423 = z269 + z315;
    const Scalar z424 = n2 * z297;
    const Scalar z425 = n2 * z298;
    const Scalar z426 = n0_14 * z424;
    const Scalar z427 = n0_14 * z425;
    const Scalar z428 = n2 * z236;
    const Scalar z429 = n2 * z265;
    const Scalar z430 = n2 * z263;
    const Scalar z431 = z258 - z279;
    const Scalar z432 = s_roll * z422;
    const Scalar z433 = n2 * z241;
    const Scalar z434 = n2 * z299;
    const Scalar z435 = n0_14 * z434;
    const Scalar z436 = z8 * z426 + z7 * z427;
    const Scalar z437 = z7 * z426 - z8 * z427;
    const Scalar z438 = z404 + z432;
    const Scalar z439 = n2 * z245;
    const Scalar z440 = n2 * z277;
    const Scalar z441 = n0_1435 * z433 - z436;
    const Scalar z442 = k30 * z439 - z435;
    const Scalar z443 = k30 * z439 + z435;
    const Scalar z444 = k17 * z439;
    const Scalar z445 = n0_1435 * z440 - z437;
    const Scalar z446 = k17 * z433 - z437 - k30 * z440;
    const Scalar z447 = k12 * z440;
    const Scalar z448 = k17 * z440 - z436 + k30 * z433;
    const Scalar z449 = k10 * z428;
    const Scalar z450 = s_steer * z441 - c_steer * z442;
    const Scalar z451 = z445 + z446;
    const Scalar z452 = s_steer * z444 + c_steer * z451;
    const Scalar z453 = n2 * z238;
    const Scalar z454 = c_steer * z447;
    const Scalar z455 = k12 * z439;
    const Scalar z456 = n2 * z264;
    const Scalar z457 = n0_06 * z456;
    const Scalar z458 = n2 * z237;
    const Scalar z459 = s_steer * z447;
    const Scalar z460 = s_steer * z448 - c_steer * z443;
    const Scalar z461 = s_steer * z452;
    const Scalar z462 = z450 + z345 * z449 - k10 * z455;
    const Scalar z463 = s_yaw * z388 - c_yaw * z411;
    const Scalar z464 = n0_06 * z430;
    const Scalar z465 = c_yaw * z388 + s_yaw * z411;
    const Scalar z466 = n0_06 * z429;
    const Scalar z467 = k10 * z458;
    const Scalar z468 = z444 - z461;
    const Scalar z469 = k10 * z459 + z468;
    const Scalar z470 = z347 * z467 - z461;
    const Scalar z471 = c_steer * z452 - z445;
    const Scalar z472 = c_steer * z452 - z446;
    const Scalar z473 = z345 * z467 - z471 + k10 * z454;
    const Scalar z474 = z249 - z332;
    const Scalar z475 = s_steer * z442 + c_steer * z441;
    const Scalar z476 = z347 * z449 - z475;
    const Scalar z477 = z240 - z334;
    const Scalar z478 = v_roll * z235;
    const Scalar z479 = z243 - z478;
    const Scalar z480 = z460 - z457;
    const Scalar z481 = s_steer * z443 + c_steer * z448;
    const Scalar z482 = z5 * z466 + z6 * z464;
    const Scalar z483 = z5 * z464 - z6 * z466;
    const Scalar z484 = z234 * z234;
    const Scalar z485 = z472 - z483;
    const Scalar z486 = z235 * z235;
    const Scalar z487 = z462 + z457;
    const Scalar z488 = z484 + z486;
    const Scalar z489 = z476 + z482;
    const Scalar z490 = n2 * z235;
    const Scalar z491 = n2 * z234;
    const Scalar z492 = z481 - z482;
    const Scalar z493 = z473 + z483;
    const Scalar z494 = n2 * v_roll;
    const Scalar z495 = k32 * z428 - z480;
    const Scalar z496 = k33 * z428 + z487;
    const Scalar z497 = k33 * z453 + z489;
    const Scalar z498 = k33 * z458 - z485;
    const Scalar z499 = k32 * z453 - z492 + k22 * z458;
    const Scalar z500 = z493 + k22 * z453 + k33 * z458;
    const Scalar z501 = z262 * z412;
    const Scalar z502 = k15 * z428 + z459;
    const Scalar z503 = z454 + k15 * z453 + k14 * z458;
    const Scalar z504 = k14 * z428 - z455;
    const Scalar z505 = k22 * z428;
    const Scalar z506 = z469 + z505;
    const Scalar z507 = z444 + z505;
    const Scalar z508 = z4 * z502 + z3 * z504;
    const Scalar z509 = z495 - z496;
    const Scalar z510 = z506 + z507;
    const Scalar z511 = z235 * z508 + z367 - z347 * z488 - z388 * z477;
    const Scalar z512 = z3 * z509 - z4 * z510;
    const Scalar z513 = z388 * z479 - z387 * z488 + z234 * z508 - z399;
    const Scalar z514 = z282 * z388;
    const Scalar z515 = z3 * z502 - z4 * z504;
    const Scalar z516 = z238 * z503 + z322 - z347 * z474 - k15 * z423;
    const Scalar z517 = z347 * z431 - z384 * z423 + z237 * z503 - z364;
    const Scalar z518 = z254 * z387 + z262 * z389;
    const Scalar z519 = z4 * z512;
    const Scalar z520 = z388 * z490 + z503;
    const Scalar z521 = z4 * z497 + z3 * z498;
    const Scalar z522 = k26 * z494 - z521;
    const Scalar z523 = z384 * z474 + k15 * z431 + z238 * z502 + z237 * z504;
    const Scalar z524 = z3 * z497 - z4 * z498;
    const Scalar z525 = k26 * z490 + z524;
    const Scalar z526 = z506 + z519;
    const Scalar z527 = z507 + z519;
    const Scalar z528 = z388 * z491 - z515;
    const Scalar z529 = z347 * z491 - z387 * z490;
    const Scalar z530 = z4 * z499 + z3 * z500;
    const Scalar z531 = z271 * z347;
    const Scalar z532 = z470 + z526;
    const Scalar z533 = z347 * z479 + z387 * z477 + z234 * z503 + z235 * z515;
    const Scalar z534 = s_roll * z515 - c_roll * z503;
    const Scalar z535 = s_roll * z520 - c_roll * z528;
    const Scalar z536 = c_roll * z520 + s_roll * z528;
    const Scalar z537 = z470 + z507;
    const Scalar z538 = z380 * z474 - z373 * z423 - z375 * z431 + z280 * z347 + z354 + z238 * z495 + z237 * z537;
    const Scalar z539 = z3 * z512 - z495;
    const Scalar z540 = z3 * z512 + z496;
    const Scalar z541 = z506 - z507;
    const Scalar z542 = z470 - z506;
    const Scalar z543 = z540 + z385 * z490 - z404 * z491;
    const Scalar z544 = z406 * z488 - z282 * z347 - z266 * z387 - z397 * z477 - z405 * z479 - z235 * z525 + z234 * z539;
    const Scalar z545 = s_roll * z525 + c_roll * z539;
    const Scalar z546 = z530 - z522;
    const Scalar z547 = s_roll * z532 - c_roll * z546;
    const Scalar z548 = s_roll * z511 - c_roll * z513;
    const Scalar z549 = s_roll * z513 + c_roll * z511;
    const Scalar z550 = s_roll * z547;
    const Scalar z551 = z3 * z499 - z4 * z500;
    const Scalar z552 = z531 + z350 * z423 - z381 * z474 - z380 * z431 + z378 - z237 * z496 + z238 * z542;
    const Scalar z553 = z375 * z458 - z498 + z380 * z453;
    const Scalar z554 = z497 + z381 * z453 - z380 * z458;
    const Scalar z555 = k15 * z271 - z379 * z423 + z350 * z474 + z373 * z431 + z280 * z384 + z238 * z499 + z237 * z500;
    const Scalar z556 = z347 * z453 + z504;
    const Scalar z557 = z347 * z458 - z502;
    const Scalar z558 = z384 * z453 - k15 * z458;
    const Scalar z559 = z541 + z350 * z453 - z373 * z458;
    const Scalar z560 = z470 - z550;
    const Scalar z561 = z551 + z379 * z490 - z385 * z491;
    const Scalar z562 = z527 + z560;
    const Scalar z563 = c_roll * z543 + s_roll * z561;
    const Scalar z564 = z3 * z556 - z4 * z557;
    const Scalar z565 = z3 * z516 - z4 * z517;
    const Scalar z566 = z3 * z517 + z4 * z516;
    const Scalar z567 = c_roll * z523 + s_roll * z565;
    const Scalar z568 = s_roll * z523 - c_roll * z565;
    const Scalar z569 = c_yaw * z529 + s_yaw * z535;
    const Scalar z570 = s_yaw * z529 - c_yaw * z535;
    const Scalar z571 = s_yaw * z508 + c_yaw * z534;
    const Scalar z572 = s_yaw * z534 - c_yaw * z508;
    const Scalar z573 = z3 * z557 + z4 * z556;
    const Scalar z574 = c_yaw * z533 + s_yaw * z548;
    const Scalar z575 = s_yaw * z533 - c_yaw * z548;
    const Scalar z576 = s_yaw * z567 - c_yaw * z566;
    const Scalar z577 = s_yaw * z566 + c_yaw * z567;
    const Scalar z578 = z470 + z527;
    const Scalar z579 = z266 * z388 - z371 + z385 * z477 - z405 * z488 + z404 * z479 + z235 * z522 + z234 * z578;
    const Scalar z580 = z526 - z527;
    const Scalar z581 = z470 - z526;
    const Scalar z582 = z379 * z477 - z514 - z397 * z488 + z385 * z479 - z402 + z234 * z530 + z235 * z580;
    const Scalar z583 = z379 * z477 - z514 - z397 * z488 + z385 * z479 + z235 * z541 + z234 * z530;
    const Scalar z584 = s_roll * z541 - c_roll * z530;
    const Scalar z585 = c_roll * z579 + s_roll * z582;
    const Scalar z586 = z397 * z490 - z581 - z405 * z491;
    const Scalar z587 = z262 * z388 + z254 * z411;
    const Scalar z588 = z254 * z357 + z262 * z353;
    const Scalar z589 = k17 * z328 - k18 * z308 + k12 * z289 + z245 * z442 + z241 * z441;
    const Scalar z590 = z245 * z444 - z331 - k17 * z308 + k19 * z328 + z241 * z445;
    const Scalar z591 = z347 * z467 - z444;
    const Scalar z592 = z245 * z455 - z309 - k12 * z308;
    const Scalar z593 = z241 * z455 + z325;
    const Scalar z594 = z345 * z449 + z450;
    const Scalar z595 = k19 * z439 + z443;
    const Scalar z596 = z531 + z350 * z423 + z344 * z431 - z356 * z474 + z238 * z591 - z237 * z594;
    const Scalar z597 = z476 + z344 * z458 + z356 * z453;
    const Scalar z598 = z245 * z447 + k12 * z340;
    const Scalar z599 = c_steer * z593 + s_steer * z592;
    const Scalar z600 = s_steer * z593 - c_steer * z592;
    const Scalar z601 = k12 * z433;
    const Scalar z602 = n0_28 * z340;
    const Scalar z603 = z337 - z602 + z245 * z446;
    const Scalar z604 = z3 * z599 - z4 * z598;
    const Scalar z605 = z3 * z598 + z4 * z599;
    const Scalar z606 = s_roll * z564 - c_roll * z558;
    const Scalar z607 = s_roll * z558 + c_roll * z564;
    const Scalar z608 = z3 * z591 + z4 * z594;
    const Scalar z609 = z3 * z594 - z4 * z591;
    const Scalar z610 = z350 * z477 + z282 * z351 - z359 * z479 + z266 * z345 - z368 * z488 + z235 * z476 + z234 * z609;
    const Scalar z611 = z350 * z490 - z608 + z359 * z491;
    const Scalar z612 = s_roll * z476 - c_roll * z609;
    const Scalar z613 = c_roll * z600 + s_roll * z604;
    const Scalar z614 = s_roll * z600 - c_roll * z604;
    const Scalar z615 = z589 - k10 * z600;
    const Scalar z616 = s_yaw * z606 - c_yaw * z573;
    const Scalar z617 = s_yaw * z573 + c_yaw * z606;
    const Scalar z618 = s_yaw * z613 - c_yaw * z605;
    const Scalar z619 = s_yaw * z605 + c_yaw * z613;
    const Scalar z620 = z3 * z482 - z4 * z483;
    const Scalar z621 = z3 * z483 + z4 * z482;
    const Scalar z622 = s_steer * z603 - c_steer * z590;
    const Scalar z623 = c_steer * z603 + s_steer * z590;
    const Scalar z624 = k10 * z598 - z623;
    const Scalar z625 = z3 * z538 + z4 * z552;
    const Scalar z626 = z3 * z552 - z4 * z538;
    const Scalar z627 = n0_28 * z433 + z448;
    const Scalar z628 = c_roll * z625 + s_roll * z555;
    const Scalar z629 = z4 * z601 + z3 * z454;
    const Scalar z630 = z3 * z601 - z4 * z454;
    const Scalar z631 = c_roll * z459 + s_roll * z629;
    const Scalar z632 = s_roll * z459 - c_roll * z629;
    const Scalar z633 = k10 * z459;
    const Scalar z634 = c_yaw * z630 + s_yaw * z631;
    const Scalar z635 = s_yaw * z630 - c_yaw * z631;
    const Scalar z636 = s_steer * z595 + c_steer * z627;
    const Scalar z637 = s_steer * z627 - c_steer * z595;
    const Scalar z638 = k10 * z601 + z636;
    const Scalar z639 = z3 * z553 - z4 * z554;
    const Scalar z640 = z245 * z437 + z602;
    const Scalar z641 = z3 * z554 + z4 * z553;
    const Scalar z642 = n0_28 * z433 - z436;
    const Scalar z643 = s_roll * z559 + c_roll * z639;
    const Scalar z644 = c_steer * z437;
    const Scalar z645 = z352 * z431 - z355 * z423 + z238 * z436 + z237 * z644;
    const Scalar z646 = s_steer * z437;
    const Scalar z647 = z352 * z458 - z646;
    const Scalar z648 = z3 * z436 - z4 * z644;
    const Scalar z649 = z4 * z436 + z3 * z644;
    const Scalar z650 = z355 * z477 - z396 * z488 + z358 * z479 + z235 * z646 + z234 * z649;
    const Scalar z651 = n0_12 * z477 + z234 * z621;
    const Scalar z652 = z648 + z355 * z490 - z358 * z491;
    const Scalar z653 = c_roll * z621;
    const Scalar z654 = n0_12 * z490 + z620;
    const Scalar z655 = s_roll * z646 - c_roll * z649;
    const Scalar z656 = z87 / (z56 * z56);
    const Scalar z657 = s_roll * z25 - c_roll * z17;
    const Scalar z658 = z35 * z656 - z82 * z657;
    const Scalar z659 = s_roll * z27 - c_roll * z18;
    const Scalar z660 = z36 * z656 - z82 * z659;
    const Scalar z661 = l_lambda_rear_rolls_x * z188 - l_lambda_rear_rolls_y * z182 - l_lambda_front_rolls_x * z166
        + l_lambda_front_rolls_y * z174;
    const Scalar z662 = z501 - z661;
    const Scalar z663 = l_lambda_rear_rolls_y * z185;
    const Scalar z664 = l_lambda_front_rolls_x * z183 + l_lambda_front_rolls_y * z186;
    const Scalar z665 = z588 - z664;
    const Scalar z666 = z4 * z633 + z3 * z637;
    const Scalar z667 = z3 * z633 - z4 * z637;
    const Scalar z668 = s_roll * z638 + c_roll * z666;
    const Scalar z669 = l_lambda_front_rolls_x * z200 + l_lambda_front_rolls_y * z193;
    const Scalar z670 = z3 * z622 - z4 * z615;
    const Scalar z671 = z3 * z615 + z4 * z622;
    const Scalar z672 = s_roll * z624 - c_roll * z670;
    const Scalar z673 = n2 * (z18 * z18 + z31 - z25 * z25 - z27 * z27);
    const Scalar z674 = n0_5 * (z34 * z80 / (z56 * z56) + z673 / z56);
    const Scalar z675 = c_roll * z43;
    const Scalar z676 = s_roll * z78;
    const Scalar z677 = z67 * z72 - z65 * z93;
    const Scalar z678 = z67 * z71 - z65 * z91;
    const Scalar z679 = c_yaw * z81;
    const Scalar z680 = z111 * z677;
    const Scalar z681 = s_yaw * z81;
    const Scalar z682 = z111 * z678;
    const Scalar z683 = z94 * z111;
    const Scalar z684 = s_yaw * z67;
    const Scalar z685 = s_yaw * z675;
    const Scalar z686 = n0_35 * z99 / (z77 * z77);
    const Scalar z687 = c_yaw * z67;
    const Scalar z688 = n2 * (z71 * z684 + z72 * z687 - z91 * z91 - z93 * z93);
    const Scalar z689 = c_yaw * z675;
    const Scalar z690 = n2 * (z71 * z685 + z72 * z689 - z91 * z90 - z93 * z92);
    const Scalar z691 = n0_3 * z674;
    const Scalar z692 = z680 - z679 + z110 * z686;
    const Scalar z693 = z682 - z681 + z124 * z686;
    const Scalar z694 = z79 - z683 + z75 * z686;
    const Scalar z695 = s_yaw * z694;
    const Scalar z696 = c_yaw * z694;
    const Scalar z697 = z49 * z656 - z34 * z82;
    const Scalar z698 = n0_5 * (z94 * z99 / (z77 * z77) + z688 / z77);
    const Scalar z699 = c_yaw * z697;
    const Scalar z700 = s_yaw * z697;
    const Scalar z701 = n0_5 * (z99 * z96 / (z77 * z77) + z690 / z77);
    const Scalar z702 = l_lambda_rear_rolls_x * z185;
    const Scalar z703 = l_lambda_rear_rolls_x * z163 + z663;
    const Scalar z704 = l_lambda_rear_rolls_x * z163 + z663 - l_lambda_front_rolls_x * z175 - l_lambda_front_rolls_y
        * z181;
    const Scalar z705 = z518 + z704;
    const Scalar z706 = l_lambda_rear_rolls_x * z660 - l_lambda_rear_rolls_y * z658 + l_lambda_front_rolls_x * z692
        - l_lambda_front_rolls_y * z693;
    const Scalar z707 = z585 + z706;
    const Scalar z708 = l_lambda_rear_rolls_x * z136 + l_lambda_rear_rolls_y * z151 - l_lambda_front_rolls_x * z141
        - l_lambda_front_rolls_y * z142;
    const Scalar z709 = z587 + z708;
    const Scalar z710 = z81 - n0_35 * z698;
    const Scalar z711 = l_lambda_rear_touches + l_lambda_front_touches;
    const Scalar z712 = l_lambda_rear_touches * z87 + l_lambda_rear_rolls_x * z182 + l_lambda_rear_rolls_y * z188
        - l_lambda_front_touches * z140 - l_lambda_front_rolls_x * z174 - l_lambda_front_rolls_y * z166;
    const Scalar z713 = l_lambda_rear_touches * z691 + l_lambda_rear_rolls_x * z700 + l_lambda_rear_rolls_y * z699
        + l_lambda_front_rolls_x * z695 + l_lambda_front_rolls_y * z696 - l_lambda_front_touches * z710;
    const Scalar z714 = z544 + z713;
    const Scalar z715 = l_lambda_rear_rolls_y * z163 - z702 - l_lambda_front_touches * z137 + l_lambda_front_rolls_x
        * z181 - l_lambda_front_rolls_y * z175;
    const Scalar z716 = l_lambda_rear_rolls_y * z163 - z702;
    const Scalar z717 = l_lambda_front_rolls_x * z186 - l_lambda_front_rolls_y * z183 - l_lambda_front_touches * z153;
    const Scalar z718 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x;
    const Scalar z719 = z676 + n0_35 * z701;
    const Scalar z720 = l_lambda_rear_rolls_x * z151 - l_lambda_rear_rolls_y * z136 - l_lambda_front_rolls_x * z142
        + l_lambda_front_rolls_y * z141;
    const Scalar z721 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y;
    const Scalar z722 = s_roll * z129 - c_roll * z130;
    const Scalar z723 = z27 * z145 - c_roll * z142 + s_roll * z692 + z18 * z694;
    const Scalar z724 = z25 * z145 - c_roll * z141 + s_roll * z693 + z17 * z694;
    const Scalar z725 = c_roll * z136 - z25 * z139 + s_roll * z658 + z17 * z697;
    const Scalar z726 = c_roll * z151 - z27 * z139 + s_roll * z660 + z18 * z697;
    const Scalar z727 = l_lambda_rear_rolls_x * z726;
    const Scalar z728 = l_lambda_front_rolls_x * z193 - l_lambda_front_rolls_y * z200;
    const Scalar z729 = z79 - z156;
    const Scalar z730 = s_yaw * z62 + z63;
    const Scalar z731 = c_yaw * z62 - z64;
    const Scalar z732 = n2 * (z92 * z92 + z90 * z90 + z71 * z730 + z72 * z731);
    const Scalar z733 = z729 - z683 + z75 * z686;
    const Scalar z734 = z75 * z686 - z683;
    const Scalar z735 = n0_5 * (z94 * z102 / (z77 * z77) + z690 / z77);
    const Scalar z736 = z676 + n0_35 * z735;
    const Scalar z737 = n0_5 * (z96 * z102 / (z77 * z77) - z732 / z77);
    const Scalar z738 = s_roll * s_steer - c_roll * z108;
    const Scalar z739 = z65 * z92 - z72 * z675;
    const Scalar z740 = z65 * z90 - z71 * z675;
    const Scalar z741 = c_yaw * z157;
    const Scalar z742 = z679 - z741;
    const Scalar z743 = n0_35 * z102 / (z77 * z77);
    const Scalar z744 = s_yaw * z76 - c_yaw * z676;
    const Scalar z745 = z680 - z742 + z110 * z686;
    const Scalar z746 = z110 * z686 + z680;
    const Scalar z747 = z111 * z739;
    const Scalar z748 = z96 * z111;
    const Scalar z749 = s_yaw * z157;
    const Scalar z750 = z681 - z749;
    const Scalar z751 = s_yaw * z676 + c_yaw * z76;
    const Scalar z752 = z111 * z740;
    const Scalar z753 = c_yaw * z147;
    const Scalar z754 = z682 - z750 + z124 * z686;
    const Scalar z755 = z124 * z686 + z682;
    const Scalar z756 = s_yaw * z147;
    const Scalar z757 = z110 * z743 - z744 - z747;
    const Scalar z758 = z100 - z748 + z75 * z743;
    const Scalar z759 = z751 - z752 + z124 * z743;
    const Scalar z760 = s_yaw * z758;
    const Scalar z761 = s_yaw * z738;
    const Scalar z762 = c_yaw * z758;
    const Scalar z763 = z18 * z758 + s_roll * z757;
    const Scalar z764 = c_yaw * z738;
    const Scalar z765 = n2 * (z91 * z117 - z93 * z118 + z71 * z761 + z72 * z764);
    const Scalar z766 = s_roll * z759 + z17 * z758;
    const Scalar z767 = z146 * z169 + z172 * z753 - z147 * z745 + z150 * z733;
    const Scalar z768 = z146 * z170 + z172 * z756 - z147 * z754 + z152 * z733;
    const Scalar z769 = z67 * z178 - z93 * z192 + z65 * z746 + z72 * z734;
    const Scalar z770 = z67 * z179 - z91 * z192 + z65 * z755 + z71 * z734;
    const Scalar z771 = c_roll * z76;
    const Scalar z772 = z771 - n0_35 * z737;
    const Scalar z773 = n0_5 * (z99 * z121 / (z77 * z77) - z765 / z77);
    const Scalar z774 = l_lambda_front_rolls_x * z769 - l_lambda_front_rolls_y * z770;
    const Scalar z775 = z650 + z774;
    const Scalar z776 = l_lambda_rear_rolls_y * z725 - z727;
    const Scalar z777 = z651 - z776;
    const Scalar z778 = z722 - n0_35 * z773;
    const Scalar z779 = z727 - l_lambda_rear_rolls_y * z725 - l_lambda_front_touches * z719 + l_lambda_front_rolls_x
        * z723 - l_lambda_front_rolls_y * z724;
    const Scalar z780 = z583 + z779;
    const Scalar z781 = s_pitch * z120 - c_pitch * z116;
    const Scalar z782 = s_roll * z155;
    const Scalar z783 = s_roll * z143;
    const Scalar z784 = c_roll * z155;
    const Scalar z785 = z100 - z784;
    const Scalar z786 = s_yaw * z154 - c_yaw * z782;
    const Scalar z787 = c_yaw * z154 + s_yaw * z782;
    const Scalar z788 = z744 - z786;
    const Scalar z789 = z785 - z748 + z75 * z743;
    const Scalar z790 = s_roll * z109;
    const Scalar z791 = z110 * z743 - z747 - z788;
    const Scalar z792 = c_roll * z143;
    const Scalar z793 = s_yaw * z790 - c_yaw * z108;
    const Scalar z794 = s_yaw * z108 + c_yaw * z790;
    const Scalar z795 = s_yaw * z144 - c_yaw * z783;
    const Scalar z796 = z147 * z791 - z150 * z789 - z169 * z792 - z172 * z795;
    const Scalar z797 = n2 * (z92 * z118 - z90 * z117 + z71 * z793 + z72 * z794);
    const Scalar z798 = c_roll * z781;
    const Scalar z799 = l_lambda_front_rolls_x * z767 - l_lambda_front_rolls_y * z768 - l_lambda_front_touches * z778;
    const Scalar z800 = z751 - z787;
    const Scalar z801 = z610 - z799;
    const Scalar z802 = z110 * z743 - z747;
    const Scalar z803 = z800 - z752 + z124 * z743;
    const Scalar z804 = z75 * z743 - z748;
    const Scalar z805 = z124 * z743 - z752;
    const Scalar z806 = n0_35 * z132 / (z77 * z77);
    const Scalar z807 = z65 * z118 - z72 * z738;
    const Scalar z808 = s_yaw * z781 - c_yaw * z722;
    const Scalar z809 = c_yaw * z781 + s_yaw * z722;
    const Scalar z810 = z65 * z117 + z71 * z738;
    const Scalar z811 = c_yaw * z144 + s_yaw * z783;
    const Scalar z812 = z111 * z810;
    const Scalar z813 = z178 * z675 - z92 * z192 + z65 * z802 + z72 * z804;
    const Scalar z814 = z124 * z806 - z809 - z812;
    const Scalar z815 = z172 * z811 - z170 * z792 + z147 * z803 - z152 * z789;
    const Scalar z816 = z179 * z675 - z90 * z192 + z65 * z805 + z71 * z804;
    const Scalar z817 = n0_5 * (z102 * z121 / (z77 * z77) + z797 / z77);
    const Scalar z818 = z798 + n0_35 * z817;
    const Scalar z819 = l_lambda_front_rolls_x * z813 - l_lambda_front_rolls_y * z816;
    const Scalar z820 = z645 + z819;
    const Scalar z821 = l_lambda_front_touches * z772 + l_lambda_front_rolls_x * z763 - l_lambda_front_rolls_y * z766;
    const Scalar z822 = z555 + z821;
    const Scalar z823 = l_lambda_front_rolls_x * z796 - l_lambda_front_rolls_y * z815 - l_lambda_front_touches * z818;
    const Scalar z824 = z596 - z823;
    const Scalar z825 = l_lambda_front_rolls_x * z757 - l_lambda_front_rolls_y * z759;
    const Scalar z826 = z628 + z825;
    const Scalar z827 = n0_5 * (z94 * z132 / (z77 * z77) - z765 / z77);
    const Scalar z828 = z722 - n0_35 * z827;
    const Scalar z829 = z111 * z807;
    const Scalar z830 = z808 + z829 + z110 * z806;
    const Scalar z831 = z121 * z111;
    const Scalar z832 = z75 * z806 - z135 - z831;
    const Scalar z833 = l_lambda_front_rolls_x * z760 + l_lambda_front_rolls_y * z762 + l_lambda_front_touches * z736;
    const Scalar z834 = z626 + z833;
    const Scalar z835 = z415 - z711;
    const Scalar z836 = z419 - z718;
    const Scalar z837 = z421 + z721;
    const Scalar z838 = z124 * z806 - z812;
    const Scalar z839 = z75 * z806 - z831;
    const Scalar z840 = z110 * z806 + z829;
    const Scalar z841 = n2 * (z72 * z72 + z73 - z117 * z117 - z118 * z118);
    const Scalar z842 = n0_5 * (z96 * z132 / (z77 * z77) + z797 / z77);
    const Scalar z843 = z798 + n0_35 * z842;
    const Scalar z844 = n0_5 * (z121 * z132 / (z77 * z77) + z841 / z77);
    const Scalar z845 = z241 * z299;
    const Scalar z846 = z277 * z299;
    const Scalar z847 = z238 * z264;
    const Scalar z848 = z237 * z264;
    const Scalar z849 = n0_28 * z845;  // moment on front_wheel, y
    const Scalar z850 = n0_12 * z847;  // moment on rear_wheel, y
    const Scalar z851 = n0_28 * z846;  // moment on front_wheel, x
    const Scalar z852 = z849 + k18 * z292 + k19 * z310 + k17 * z340 + k12 * z288;  // moment on fork, z
    const Scalar z853 = z851 + k18 * z317 + k19 * z276 + k17 * z318;  // moment on fork, x
    const Scalar z854 = n0_12 * z848;  // moment on rear_wheel, x
    const Scalar z855 = s_yaw * z832;
    const Scalar z856 = c_yaw * z832;
    const Scalar z857 = s_roll * z830 + z18 * z832;
    const Scalar z858 = s_roll * z814 + z17 * z832;
    const Scalar z859 = z147 * z830 - z150 * z832;
    const Scalar z860 = c_steer * z853 - z372;
    const Scalar z861 = s_steer * z853 + z362;
    const Scalar z862 = z147 * z814 - z152 * z832;
    // moment on frame, z
    const Scalar z863 = z296 + k23 * z253 - k24 * z268 + k22 * z321 - k14 * z271 + k15 * z280 - k10 * z312 - z861;
    const Scalar z864 = z854 + k15 * z282 + k23 * z332 - k24 * z249 - k22 * z283 + z860;  // moment on frame, x
    const Scalar z865 = k14 * z282 - z850 - k21 * z279 + k22 * z339 + k10 * z333 - z852;  // moment on frame, y
    const Scalar z866 = z118 * z192 - z178 * z738 + z65 * z840 + z72 * z839;
    const Scalar z867 = z65 * z838 + z71 * z839 - z117 * z192 - z179 * z738;
    const Scalar z868 = c_steer * z13;
    const Scalar z869 = c_steer * (n1 - z12);
    const Scalar z870 = n0_08 * z869 - n0_35 * z868;
    const Scalar z871 = c_steer * (n1 - z14);
    const Scalar z872 = n0_08 * z868 - n0_35 * z871;
    const Scalar z873 = l_lambda_front_rolls_x * z866 - l_lambda_front_rolls_y * z867;
    const Scalar z874 = z640 - z873;
    const Scalar z875 = l_lambda_front_rolls_x * z857 - l_lambda_front_rolls_y * z858 - l_lambda_front_touches * z843;
    const Scalar z876 = c_pitch * z872 + s_pitch * z870;
    const Scalar z877 = z624 - z875;
    const Scalar z878 = l_lambda_front_rolls_x * z830 - l_lambda_front_rolls_y * z814;
    const Scalar z879 = z672 - z878;
    const Scalar z880 = z717 + z852;
    const Scalar z881 = z296 + z716;
    const Scalar z882 = c_roll * z876 - z69;
    const Scalar z883 = z327 - z728;
    const Scalar z884 = a_z - a_roll * z87 - z106;
    const Scalar z885 = a_z + a_roll * z140 - a_pitch * z137 - a_steer * z153 + z207;
    const Scalar z886 = z882 + n0_35 * z844;
    const Scalar z887 = z715 + z863;
    const Scalar z888 = l_lambda_front_rolls_x * z859 - l_lambda_front_rolls_y * z862 - l_lambda_front_touches * z886;
    const Scalar z889 = l_lambda_front_rolls_x * z855 + l_lambda_front_rolls_y * z856 - l_lambda_front_touches * z828;
    const Scalar z890 = z589 + z888;
    const Scalar z891 = z671 - z889;
    const Scalar z892 = s_yaw * z24 + s_roll * z23;
    const Scalar z893 = z32 * z25;
    const Scalar z894 = z19 * z65 + c_yaw * z199;
    const Scalar z895 = z85 * z93;
    const Scalar z896 = c_yaw * z24 - s_roll * z19;
    const Scalar z897 = s_yaw * z199 - z23 * z65;
    const Scalar z898 = n2 * (z17 * z892 - z893 + z18 * z896 - z33 * z27);
    const Scalar z899 = z61 * z80;
    const Scalar z900 = n2 * z24;
    const Scalar z901 = n2 * (z72 * z894 - z895 + z71 * z897 + z86 * z91);
    const Scalar z902 = z97 * z99;
    const Scalar z903 = s_yaw * z128 + s_roll * z38 - z24 * z39;
    const Scalar z904 = n0_5 * (z899 / (z56 * z56) + z898 / z56);
    const Scalar z905 = c_yaw * z128 + s_roll * z40 + z24 * z41;
    const Scalar z906 = n4 * (z32 * z892 + z33 * z896) + n2 * (z17 * z903 + z18 * z905 + z25 * z50 + z27 * z51);
    const Scalar z907 = v_yaw * z141;
    const Scalar z908 = v_yaw * z142;
    const Scalar z909 = n2 * s_roll * z23 + s_yaw * z900;
    const Scalar z910 = v_yaw * z151;
    const Scalar z911 = c_yaw * z900 - s_roll * z41;
    const Scalar z912 = n2 * (z17 * z909 + z18 * z911) - n4 * (z33 * z27 + z893);
    const Scalar z913 = n0_3 * z904;
    const Scalar z914 = n0_5 * (z83 * z898 / (z56 * z56) - z906 / z56 + z80 * z70 / (z56 * z56) + z61 * z904 / (z56
        * z56)) + z83 * z899 / (z56 * z56 * z56);
    const Scalar z915 = n0_5 * (z83 * z34 / (z56 * z56) + z899 / (z56 * z56) + z912 / z56);
    const Scalar z916 = v_yaw * z136;
    const Scalar z917 = v_roll * z166 - z907 + v_front * z200 - v_pitch * z175 - v_steer * z183;
    const Scalar z918 = v_roll * z166 - z907 + v_front * z200 - v_pitch * z175 - v_steer * z183 - z218;
    const Scalar z919 = v_roll * z182 + z910 + z185 * (v_pitch + v_rear);
    const Scalar z920 = v_roll * z182 + z910 + z185 * (v_pitch + v_rear) + z180;
    const Scalar z921 = n0_3 * z914;
    const Scalar z922 = a_roll * z691 + z921;
    const Scalar z923 = n0_3 * z915;
    const Scalar z924 = v_roll * z174 + z908 - v_front * z193 + v_pitch * z181 + v_steer * z186;
    const Scalar z925 = v_roll * z174 + z908 - v_front * z193 + v_pitch * z181 + v_steer * z186 - z252;
    const Scalar z926 = v_roll * z188 - z916 - z163 * (v_pitch + v_rear);
    const Scalar z927 = v_roll * z188 - z916 - z163 * (v_pitch + v_rear) + z189;
    const Scalar z928 = a_yaw * z141 - a_roll * z166 + a_pitch * z175 + a_steer * z183 - a_front * z200 - z294;
    const Scalar z929 = a_y - a_yaw * z141 + a_roll * z166 - a_pitch * z175 - a_steer * z183 + a_front * z200 + z294;
    const Scalar z930 = z185 * (a_pitch + a_rear) + a_yaw * z151 + a_roll * z182 + z222;
    const Scalar z931 = z185 * (a_pitch + a_rear) + a_x + a_yaw * z151 + a_roll * z182 + z222;
    const Scalar z932 = a_yaw * z142 + a_roll * z174 + a_pitch * z181 + a_steer * z186 - a_front * z193 - z295;
    const Scalar z933 = a_x - a_yaw * z142 - a_roll * z174 - a_pitch * z181 - a_steer * z186 + a_front * z193 + z295;
    const Scalar z934 = z163 * (a_pitch + a_rear) + a_y + a_yaw * z136 - a_roll * z188 + z230;
    const Scalar z935 = z163 * (a_pitch + a_rear) + a_yaw * z136 - a_roll * z188 + z230;
    const Scalar z936 = z3 * z865 + z4 * z864;
    const Scalar z937 = k26 * (a_roll + z410) - z936;  // moment on frame.2, z
    const Scalar z938 = z3 * z864 - z4 * z865;
    const Scalar z939 = k26 * (z240 + z334) - z938;  // moment on frame.2, y
    const Scalar z940 = z712 - z937;
    const Scalar z941 = n2 * z20;
    const Scalar z942 = n2 * (s_roll * z101 + z202) - z42 * z941 - z76 * z900;
    const Scalar z943 = s_roll * z863 - c_roll * z939;
    const Scalar z944 = n0_5 * (z902 / (z77 * z77) - z901 / z77);
    const Scalar z945 = z720 - z943;
    const Scalar z946 = z76 * z128 - z37 * z42 - c_roll * z134 - n2 * (z20 * z52 - z24 * z101) + s_roll * z191;
    const Scalar z947 = n0_6 * z83 * z80 / (z56 * z56 * z56) + z913 / (z56 * z56);
    const Scalar z948 = z49 * z947 - z61 * z656 - z34 * z158 - z82 * z898;
    const Scalar z949 = z204 + z211;
    const Scalar z950 = s_roll * z127 + c_steer * z128 + z37 * z44 + n2 * (z24 * z30 + z20 * z60) + c_roll * z131;
    const Scalar z951 = z38 * z65 + z39 * z199 + s_yaw * z950;
    const Scalar z952 = z40 * z65 - z41 * z199 + c_yaw * z950;
    const Scalar z953 = n2 * (z71 * z951 + z72 * z952 - z91 * z148 + z93 * z149) - n4 * (z86 * z897 - z85 * z894);
    const Scalar z954 = n0_7 * z103;
    const Scalar z955 = v_yaw * z692;
    const Scalar z956 = v_roll * z695 + z955 + v_pitch * z723 + v_steer * z767 + v_front * z769 + z229;
    const Scalar z957 = v_roll * z695 + z955 + v_pitch * z723 + v_steer * z767 + v_front * z769;
    const Scalar z958 = v_yaw * z693;
    const Scalar z959 = v_roll * z696 - z958 + z284 - v_pitch * z724 - v_steer * z768 - v_front * z770;
    const Scalar z960 = v_roll * z696 - z958 - v_pitch * z724 - v_steer * z768 - v_front * z770;
    const Scalar z961 = n0_5 * (z97 * z944 / (z77 * z77) - z103 * z901 / (z77 * z77) - z99 * z173 / (z77 * z77) - z953
        / z77) + z99 * z184 / (z77 * z77 * z77);
    const Scalar z962 = z99 * z954 / (z77 * z77 * z77) + n0_35 * z944 / (z77 * z77);
    const Scalar z963 = z204 + n0_35 * z944;
    const Scalar z964 = v_yaw * z658;
    const Scalar z965 = v_roll * z699 - z964 + z194 - z725 * (v_pitch + v_rear);
    const Scalar z966 = z946 + n0_35 * z961;
    const Scalar z967 = v_roll * z699 - z964 - z725 * (v_pitch + v_rear);
    const Scalar z968 = a_roll * z710 + a_pitch * z719 + a_steer * z778 - z966;
    const Scalar z969 = z44 * z941 - c_steer * z900 + n2 * (s_roll * z30 - c_roll * z60);
    const Scalar z970 = z41 * z65 + c_yaw * z969;
    const Scalar z971 = s_yaw * z969 - z39 * z65;
    const Scalar z972 = z93 * z199 - z72 * z74 + z65 * z894 + z67 * z85;
    const Scalar z973 = z111 * z972;
    const Scalar z974 = n2 * (z72 * z970 + z71 * z971) + n4 * (z86 * z91 - z895);
    const Scalar z975 = c_yaw * z214 - z19 * z147;
    const Scalar z976 = c_yaw * z104 - z19 * z81;
    const Scalar z977 = z23 * z81 + s_yaw * z104;
    const Scalar z978 = z23 * z147 + s_yaw * z214;
    const Scalar z979 = c_yaw * z224 - z19 * z157;
    const Scalar z980 = z23 * z157 + s_yaw * z224;
    const Scalar z981 = n0_5 * (z103 * z94 / (z77 * z77) + z902 / (z77 * z77) - z974 / z77);
    const Scalar z982 = z976 - z979;
    const Scalar z983 = z977 - z980;
    const Scalar z984 = z973 - z976 + z205 * z686 + z216 * z677 + z110 * z962;
    const Scalar z985 = z973 - z982 + z205 * z686 + z216 * z677 + z110 * z962;
    const Scalar z986 = z973 + z205 * z686 + z216 * z677 + z110 * z962;
    const Scalar z987 = z71 * z74 - z91 * z199 - z65 * z897 + z67 * z86;
    const Scalar z988 = z942 + n0_35 * z981;
    const Scalar z989 = z111 * z987;
    const Scalar z990 = z19 * z44;
    const Scalar z991 = z24 * z43 + s_roll * z84;
    const Scalar z992 = z216 * z678 - z977 - z989 - z244 * z686 + z124 * z962;
    const Scalar z993 = z216 * z678 - z983 - z989 - z244 * z686 + z124 * z962;
    const Scalar z994 = z216 * z678 - z989 - z244 * z686 + z124 * z962;
    const Scalar z995 = z97 * z686;
    const Scalar z996 = z111 * z901 - z204 - z94 * z216 - z995 + z75 * z962;
    const Scalar z997 = z111 * z901 - z949 - z94 * z216 - z995 + z75 * z962;
    const Scalar z998 = z169 * z225 + z172 * z975 + z146 * z219 - z214 * z745 - z226 * z733 + z232 * z753 - z147 * z985
        + z150 * z997;
    const Scalar z999 = z170 * z225 + z172 * z978 + z146 * z255 - z214 * z754 + z267 * z733 + z232 * z756 - z147 * z993
        + z152 * z997;
    const Scalar z1000 = z111 * z901 - z995 - z94 * z216 + z75 * z962;
    const Scalar z1001 = z192 * z894 - z74 * z178 + z67 * z231 + z85 * z734 - z93 * z233 - z199 * z746 + z65 * z986
        + z72 * z1000;
    const Scalar z1002 = z192 * z897 - z74 * z179 + z67 * z256 - z86 * z734 - z91 * z233 - z199 * z755 + z65 * z994
        + z71 * z1000;
    const Scalar z1003 = z20 * z142 + z145 * z896 + c_roll * z218 - z33 * z694 + z24 * z692 - z27 * z221 + s_roll * z984
        + z18 * z996;
    const Scalar z1004 = z20 * z141 + z145 * z892 + c_roll * z252 - z32 * z694 + z24 * z693 - z25 * z221 + s_roll * z992
        + z17 * z996;
    const Scalar z1005 = z23 * z89 + z990 - c_yaw * z60 + s_yaw * z991;
    const Scalar z1006 = z23 * z44 - z19 * z89 + s_yaw * z60 + c_yaw * z991;
    const Scalar z1007 = n2 * (z71 * z1005 + z72 * z1006 - z86 * z90 + z85 * z92);
    const Scalar z1008 = z97 * z102;
    const Scalar z1009 = z20 * z78 + c_roll * z203;
    const Scalar z1010 = v_yaw * z660;
    const Scalar z1011 = v_roll * z700 + z1010 + z196 + z726 * (v_pitch + v_rear);
    const Scalar z1012 = v_roll * z700 + z1010 + z726 * (v_pitch + v_rear);
    const Scalar z1013 = z17 * z20 + z25 * z24 + s_roll * z892 + c_roll * z32;
    const Scalar z1014 = z35 * z947 - z82 * z1013 - z158 * z657 - z167 * z656;
    const Scalar z1015 = n0_5 * (z1008 / (z77 * z77) + z1007 / z77);
    const Scalar z1016 = z23 * z694 + s_yaw * z996;
    const Scalar z1017 = v_yaw * z984 + v_roll * z1016 + v_pitch * z1003 + v_steer * z998 + v_front * z1001;
    const Scalar z1018 = c_roll * z180 - z20 * z136 - z139 * z892 - z32 * z697 - z25 * z190 + z24 * z658 + s_roll
        * z1014 + z17 * z948;
    const Scalar z1019 = c_yaw * z996 - z19 * z694;
    const Scalar z1020 = v_yaw * z992 - v_roll * z1019 + v_pitch * z1004 + v_steer * z999 + v_front * z1002;
    const Scalar z1021 = a_yaw * z692 + a_roll * z695 + a_pitch * z723 + a_steer * z767 + a_front * z769 + z1017;
    const Scalar z1022 = z66 * z114 + s_pitch * z177 + c_pitch * z171 + z68 * z122 + n2 * (z29 * z59 - z53 * z57);
    const Scalar z1023 = z43 * z128 - z84 * z900 + s_roll * z133;
    const Scalar z1024 = a_yaw * z693 - a_roll * z696 + a_pitch * z724 + a_steer * z768 + a_front * z770 + z1020;
    const Scalar z1025 = z37 * z78 - z203 * z941 + c_roll * z1022;
    const Scalar z1026 = n2 * z57;
    const Scalar z1027 = n2 * z29;
    const Scalar z1028 = z68 * z1026 - z66 * z1027 + n2 * (c_pitch * z53 + z201);
    const Scalar z1029 = z38 * z89 - z40 * z44 - n2 * (z19 * z60 + z23 * z991) - c_yaw * z131 + s_yaw * z1023;
    const Scalar z1030 = z38 * z44 + z40 * z89 - n2 * (z23 * z60 - z19 * z991) + s_yaw * z131 + c_yaw * z1023;
    const Scalar z1031 = n4 * (z86 * z1005 - z85 * z1006) + n2 * (z71 * z1029 + z72 * z1030 - z90 * z148 + z92 * z149);
    const Scalar z1032 = z78 * z941 + c_roll * z1028;
    const Scalar z1033 = z15 * z1026 + z16 * z1027 + n2 * (s_pitch * z46 - c_pitch * z45);
    const Scalar z1034 = z15 * z1027 - z16 * z1026 + n2 * (s_pitch * z45 + c_pitch * z46);
    const Scalar z1035 = z43 * z900 + s_roll * z1033;
    const Scalar z1036 = n2 * (z23 * z89 + z990) - c_yaw * z1034 + s_yaw * z1035;
    const Scalar z1037 = n2 * (z23 * z44 - z19 * z89) + s_yaw * z1034 + c_yaw * z1035;
    const Scalar z1038 = n2 * (z71 * z1036 + z72 * z1037) - n4 * (z86 * z90 - z85 * z92);
    const Scalar z1039 = n0_5 * (z103 * z1007 / (z77 * z77) - z1031 / z77 - z102 * z173 / (z77 * z77) + z97 * z1015
        / (z77 * z77)) + z102 * z184 / (z77 * z77 * z77);
    const Scalar z1040 = n0_5 * (z103 * z96 / (z77 * z77) + z1008 / (z77 * z77) + z1038 / z77);
    const Scalar z1041 = z1025 + n0_35 * z1039;
    const Scalar z1042 = z1009 + n0_35 * z1015;
    const Scalar z1043 = z18 * z20 + z27 * z24 + s_roll * z896 + c_roll * z33;
    const Scalar z1044 = z36 * z947 - z82 * z1043 - z187 * z656 - z158 * z659;
    const Scalar z1045 = c_yaw * z948 - z19 * z697;
    const Scalar z1046 = a_roll * z736 + a_pitch * z772 + a_steer * z818 + z1041;
    const Scalar z1047 = v_yaw * z1014 - v_roll * z1045 + z1018 * (v_pitch + v_rear);
    const Scalar z1048 = z1032 + n0_35 * z1040;
    const Scalar z1049 = c_roll * z189 - z20 * z151 - z139 * z896 - z33 * z697 - z27 * z190 + z24 * z660 + s_roll
        * z1044 + z18 * z948;
    const Scalar z1050 = z725 * (a_pitch + a_rear) + a_yaw * z658 - a_roll * z699 + z1047;
    const Scalar z1051 = c_roll * z84 - z20 * z43;
    const Scalar z1052 = s_roll * z203 - z24 * z78;
    const Scalar z1053 = z102 * z954 / (z77 * z77 * z77) + n0_35 * z1015 / (z77 * z77);
    const Scalar z1054 = z23 * z697 + s_yaw * z948;
    const Scalar z1055 = v_yaw * z1044 + v_roll * z1054 + z1049 * (v_pitch + v_rear);
    const Scalar z1056 = v_yaw * z757;
    const Scalar z1057 = v_roll * z760 + z1056 + v_pitch * z763 + v_front * z813 - z228 - v_steer * z796;
    const Scalar z1058 = z726 * (a_pitch + a_rear) + a_yaw * z660 + a_roll * z700 + z1055;
    const Scalar z1059 = v_roll * z760 + z1056 + v_pitch * z763 + v_front * z813 - v_steer * z796;
    const Scalar z1060 = z11 * z30;
    const Scalar z1061 = z10 * z30;
    const Scalar z1062 = z57 * z107;
    const Scalar z1063 = z29 * z107;
    const Scalar z1064 = z1062 + s_pitch * z1060 - z29 * z88 + c_pitch * z1061;
    const Scalar z1065 = s_pitch * z1061 - z1063 - z57 * z88 - c_pitch * z1060;
    const Scalar z1066 = z13 * z22;
    const Scalar z1067 = -z22 * (n1 - z12);
    const Scalar z1068 = n0_35 * z1066 + n0_08 * z1067;
    const Scalar z1069 = z29 * z116;
    const Scalar z1070 = -z22 * (n1 - z14);
    const Scalar z1071 = n0_08 * z1066 + n0_35 * z1070;
    const Scalar z1072 = s_steer * z20 - c_roll * z22 - z24 * z108 + s_roll * z1064;
    const Scalar z1073 = n0_08 * z1060 - n0_35 * z1061;
    const Scalar z1074 = z24 * z130;
    const Scalar z1075 = z57 * z120 - z1069 + s_pitch * z1068 - c_pitch * z1071;
    const Scalar z1076 = v_yaw * z759;
    const Scalar z1077 = v_roll * z762 - z1076 - v_pitch * z766 + v_steer * z815 - v_front * z816 + z290;
    const Scalar z1078 = v_roll * z762 - z1076 - v_pitch * z766 + v_steer * z815 - v_front * z816;
    const Scalar z1079 = s_roll * z1073 - z1074 + z20 * z129 + c_roll * z1075;
    const Scalar z1080 = z65 * z1006 - z72 * z1051 - z85 * z675 - z92 * z199;
    const Scalar z1081 = z111 * z1080;
    const Scalar z1082 = z19 * z109;
    const Scalar z1083 = z1082 - z23 * z112 + c_yaw * z1065 + s_yaw * z1072;
    const Scalar z1084 = z65 * z1005 - z71 * z1051 + z86 * z675 - z90 * z199;
    const Scalar z1085 = z111 * z1084;
    const Scalar z1086 = s_roll * z223 - z24 * z143;
    const Scalar z1087 = z20 * z143 + c_roll * z223;
    const Scalar z1088 = s_yaw * z101 - z23 * z76 - z19 * z676 - c_yaw * z1052;
    const Scalar z1089 = z19 * z76 - z23 * z676 + c_yaw * z101 + s_yaw * z1052;
    const Scalar z1090 = z23 * z109;
    const Scalar z1091 = s_yaw * z1065 - z1090 - z19 * z112 - c_yaw * z1072;
    const Scalar z1092 = z24 * z155 + s_roll * z208;
    const Scalar z1093 = c_roll * z208 - z20 * z155;
    const Scalar z1094 = z1009 + z1093;
    const Scalar z1095 = z97 * z743;
    const Scalar z1096 = z75 * z1053 - z1009 - z111 * z1007 - z96 * z216 - z1095;
    const Scalar z1097 = z75 * z1053 - z1094 - z111 * z1007 - z96 * z216 - z1095;
    const Scalar z1098 = z75 * z1053 - z1095 - z111 * z1007 - z96 * z216;
    const Scalar z1099 = z23 * z144 + s_yaw * z209 + z19 * z783 + c_yaw * z1086;
    const Scalar z1100 = z19 * z144 - c_yaw * z209 - z23 * z783 + s_yaw * z1086;
    const Scalar z1101 = z23 * z154 + s_yaw * z210 + z19 * z782 - c_yaw * z1092;
    const Scalar z1102 = c_yaw * z210 - z19 * z154 + z23 * z782 + s_yaw * z1092;
    const Scalar z1103 = z1088 + z1101;
    const Scalar z1104 = z1089 + z1102;
    const Scalar z1105 = z1088 - z1081 + z205 * z743 - z216 * z739 + z110 * z1053;
    const Scalar z1106 = z124 * z1053 - z1089 - z1085 - z216 * z740 - z244 * z743;
    const Scalar z1107 = z1103 - z1081 + z205 * z743 - z216 * z739 + z110 * z1053;
    const Scalar z1108 = z205 * z743 - z1081 - z216 * z739 + z110 * z1053;
    const Scalar z1109 = z178 * z1051 - z192 * z1006 + z85 * z804 - z92 * z233 - z199 * z802 + z231 * z675 + z65 * z1108
        + z72 * z1098;
    const Scalar z1110 = z169 * z1087 - z172 * z1099 - z219 * z792 + z226 * z789 + z214 * z791 - z232 * z795 + z147
        * z1107 - z150 * z1097;
    const Scalar z1111 = z124 * z1053 - z1104 - z1085 - z216 * z740 - z244 * z743;
    const Scalar z1112 = z170 * z1087 - z172 * z1100 + z214 * z803 - z255 * z792 - z267 * z789 + z232 * z811 + z147
        * z1111 - z152 * z1097;
    const Scalar z1113 = z124 * z1053 - z1085 - z216 * z740 - z244 * z743;
    const Scalar z1114 = z179 * z1051 - z192 * z1005 - z86 * z804 - z90 * z233 - z199 * z805 + z256 * z675 + z65 * z1113
        + z71 * z1098;
    const Scalar z1115 = z85 * z118;
    const Scalar z1116 = n2 * (z1115 + z71 * z1083 - z72 * z1091 + z86 * z117);
    const Scalar z1117 = z97 * z132;
    const Scalar z1118 = z23 * z758 + s_yaw * z1096;
    const Scalar z1119 = c_yaw * z1096 - z19 * z758;
    const Scalar z1120 = z24 * z757 - z33 * z758 + s_roll * z1105 + z18 * z1096;
    const Scalar z1121 = v_yaw * z1105 + v_front * z1109 + v_roll * z1118 + v_pitch * z1120 - v_steer * z1110;
    const Scalar z1122 = z24 * z759 - z32 * z758 + s_roll * z1106 + z17 * z1096;
    const Scalar z1123 = a_yaw * z757 + a_roll * z760 + a_pitch * z763 - a_steer * z796 + a_front * z813 + z1121;
    const Scalar z1124 = v_yaw * z1106 + v_front * z1114 - v_roll * z1119 + v_pitch * z1122 - v_steer * z1112;
    const Scalar z1125 = a_yaw * z759 - a_roll * z762 + a_pitch * z766 - a_steer * z815 + a_front * z816 + z1124;
    const Scalar z1126 = n2 * z30;
    const Scalar z1127 = z11 * z127;
    const Scalar z1128 = z10 * z127;
    const Scalar z1129 = z88 * z114 + z107 * z122 + s_pitch * z1127 + c_pitch * z1128 + n2 * (z29 * z1060 - z57
        * z1061);
    const Scalar z1130 = z107 * z114 - z88 * z122 + s_pitch * z1128 - c_pitch * z1127 + n2 * (z29 * z1061 + z57
        * z1060);
    const Scalar z1131 = n0_08 * z1127 - n0_35 * z1128;
    const Scalar z1132 = c_roll * z123 + s_steer * z37 + z108 * z128 + n2 * (z20 * z22 + z24 * z1064) + s_roll * z1129;
    const Scalar z1133 = s_roll * z22 + s_steer * z24 + z20 * z108 + c_roll * z1064;
    const Scalar z1134 = n2 * z22;
    const Scalar z1135 = z10 * z1126;
    const Scalar z1136 = z11 * z1126;
    const Scalar z1137 = s_pitch * z1135 - n2 * (z57 * z88 + z1063) - c_pitch * z1136;
    const Scalar z1138 = s_pitch * z1136 - n2 * (z29 * z88 - z1062) + c_pitch * z1135;
    const Scalar z1139 = n0_08 * z1136 - n0_35 * z1135;
    const Scalar z1140 = z40 * z109 + z38 * z112 + n2 * (z23 * z1072 - z19 * z1065) + c_yaw * z1130 + s_yaw * z1132;
    const Scalar z1141 = z38 * z109 - z40 * z112 + n2 * (z23 * z1065 + z19 * z1072) + s_yaw * z1130 - c_yaw * z1132;
    const Scalar z1142 = n2 * (z71 * z1140 - z72 * z1141 - z117 * z148 - z118 * z149) - n4 * (z85 * z1091 + z86
        * z1083);
    const Scalar z1143 = n2 * (s_steer * z20 - z24 * z108) - c_roll * z1134 + s_roll * z1138;
    const Scalar z1144 = c_yaw * z1137 - n2 * (z23 * z112 - z1082) + s_yaw * z1143;
    const Scalar z1145 = s_yaw * z1137 - n2 * (z19 * z112 + z1090) - c_yaw * z1143;
    const Scalar z1146 = n4 * (z86 * z117 + z1115) + n2 * (z71 * z1144 - z72 * z1145);
    const Scalar z1147 = v_roll * z855;
    const Scalar z1148 = v_yaw * z830 - z274 + v_pitch * z857 - v_steer * z859 + v_front * z866 + z1147;
    const Scalar z1149 = z1147 + v_yaw * z830 + v_pitch * z857 - v_steer * z859 + v_front * z866;
    const Scalar z1150 = n0_5 * (z103 * z121 / (z77 * z77) + z1117 / (z77 * z77) - z1146 / z77);
    const Scalar z1151 = n0_5 * (z1117 / (z77 * z77) - z1116 / z77);
    const Scalar z1152 = n0_5 * (z97 * z1151 / (z77 * z77) - z103 * z1116 / (z77 * z77) - z132 * z173 / (z77 * z77)
        - z1142 / z77) + z132 * z184 / (z77 * z77 * z77);
    const Scalar z1153 = z132 * z954 / (z77 * z77 * z77) + n0_35 * z1151 / (z77 * z77);
    const Scalar z1154 = z1079 - n0_35 * z1151;
    const Scalar z1155 = z97 * z806;
    const Scalar z1156 = v_yaw * z814;
    const Scalar z1157 = v_roll * z856 - z1156 + z285 - v_pitch * z858 + v_steer * z862 - v_front * z867;
    const Scalar z1158 = v_roll * z856 - z1156 - v_pitch * z858 + v_steer * z862 - v_front * z867;
    const Scalar z1159 = z1079 + z111 * z1116 - z121 * z216 - z1155 + z75 * z1153;
    const Scalar z1160 = z111 * z1116 - z1155 - z121 * z216 + z75 * z1153;
    const Scalar z1161 = z29 * z120 + z57 * z116 + s_pitch * z1071 + c_pitch * z1068;
    const Scalar z1162 = z13 * z123;
    const Scalar z1163 = s_roll * z1075 - c_roll * z1073 - z20 * z130 - z24 * z129;
    const Scalar z1164 = -z123 * (n1 - z12);
    const Scalar z1165 = n0_35 * z1162 + n0_08 * z1164;
    const Scalar z1166 = -z123 * (n1 - z14);
    const Scalar z1167 = n0_08 * z1162 + n0_35 * z1166;
    const Scalar z1168 = z72 * z1133 + z118 * z199 + z85 * z738 + z65 * z1091;
    const Scalar z1169 = s_pitch * z1165 - z120 * z122 - z116 * z114 - c_pitch * z1167 - n2 * (z29 * z1068 + z57
        * z1071);
    const Scalar z1170 = z111 * z1168;
    const Scalar z1171 = z117 * z199 - z71 * z1133 + z65 * z1083 + z86 * z738;
    const Scalar z1172 = z23 * z781 + z19 * z722 + s_yaw * z1161 + c_yaw * z1163;
    const Scalar z1173 = z19 * z781 - z23 * z722 - c_yaw * z1161 + s_yaw * z1163;
    const Scalar z1174 = z130 * z128 + s_roll * z1131 + z37 * z129 - n2 * (z20 * z1075 - z24 * z1073) - c_roll * z1169;
    const Scalar z1175 = z1174 - n0_35 * z1152;
    const Scalar z1176 = z1172 - z1170 + z205 * z806 + z216 * z807 + z110 * z1153;
    const Scalar z1177 = z205 * z806 - z1170 + z216 * z807 + z110 * z1153;
    const Scalar z1178 = z85 * z839 - z178 * z1133 - z192 * z1091 + z118 * z233 - z199 * z840 - z231 * z738 + z65
        * z1177 + z72 * z1160;
    const Scalar z1179 = a_roll * z828 + a_pitch * z843 - a_steer * z886 + z1175;
    const Scalar z1180 = z24 * z830 - z33 * z832 + s_roll * z1176 + z18 * z1159;
    const Scalar z1181 = z214 * z830 + z226 * z832 + z147 * z1176 - z150 * z1159;
    const Scalar z1182 = z23 * z832 + s_yaw * z1159;
    const Scalar z1183 = v_yaw * z1176 + v_roll * z1182 + v_pitch * z1180 - v_steer * z1181 + v_front * z1178;
    const Scalar z1184 = z13 * z1134;
    const Scalar z1185 = -z1134 * (n1 - z12);
    const Scalar z1186 = z111 * z1171;
    const Scalar z1187 = -z1134 * (n1 - z14);
    const Scalar z1188 = n0_35 * z1184 + n0_08 * z1185;
    const Scalar z1189 = n0_08 * z1184 + n0_35 * z1187;
    const Scalar z1190 = z1173 + z1186 - z216 * z810 - z244 * z806 + z124 * z1153;
    const Scalar z1191 = s_pitch * z1188 - c_pitch * z1189 + n2 * (z57 * z120 - z1069);
    const Scalar z1192 = z1186 - z216 * z810 - z244 * z806 + z124 * z1153;
    const Scalar z1193 = a_yaw * z830 + a_roll * z855 + a_pitch * z857 - a_steer * z859 + a_front * z866 + z1183;
    const Scalar z1194 = s_roll * z1139 + n2 * (z20 * z129 - z1074) + c_roll * z1191;
    const Scalar z1195 = z192 * z1083 - z179 * z1133 - z86 * z839 - z117 * z233 - z199 * z838 - z256 * z738 + z65
        * z1192 + z71 * z1160;
    const Scalar z1196 = z214 * z814 - z267 * z832 + z147 * z1190 - z152 * z1159;
    const Scalar z1197 = z24 * z814 - z32 * z832 + s_roll * z1190 + z17 * z1159;
    const Scalar z1198 = c_yaw * z1159 - z19 * z832;
    const Scalar z1199 = v_yaw * z1190 - v_roll * z1198 + v_pitch * z1197 - v_steer * z1196 + v_front * z1195;
    const Scalar z1200 = z1194 - n0_35 * z1150;
    const Scalar z1201 = n1 / z193;
    const Scalar z1202 = z193 * z193;
    const Scalar z1203 = n1_over_94 + n25_over_7 * z1202 + k39 * z186 * z186 + z142 * z142 / z438 + z174 * z174 / z406
        + z181 * z181 / z379;
    const Scalar z1204 = z200 * z1201;
    const Scalar z1205 = n1_over_94 + n25_over_7 * z200 * z200 + k39 * z183 * z183 + z141 * z141 / z438 + z166 * z166
        / z406 + z175 * z175 / z379;
    const Scalar z1206 = a_yaw * z814 - a_roll * z856 + a_pitch * z858 - a_steer * z862 + a_front * z867 + z1199;
    const Scalar z1207 = n0_28 * z1203;
    const Scalar z1208 = z438 * z1205;
    const Scalar z1209 = z141 - z142 * z1204;
    const Scalar z1210 = z136 + z1209;
    const Scalar z1211 = n1 / z137;
    const Scalar z1212 = z175 * z1211;
    const Scalar z1213 = z181 * z1211;
    const Scalar z1214 = z917 * z1204 - z919 - z924;
    const Scalar z1215 = z137 * z137;
    const Scalar z1216 = z153 * z1213 - z186;
    const Scalar z1217 = n1_over_94 + k39 * z153 * z153 + z140 * z140 / z406 + z1215 / z379;
    const Scalar z1218 = z87 + z140;
    const Scalar z1219 = z174 + z1213 * z1218;
    const Scalar z1220 = z1210 * z1210;
    const Scalar z1221 = n1 / z1210;
    const Scalar z1222 = z1211 * z1218;
    const Scalar z1223 = z153 * z1211;
    const Scalar z1224 = z963 - z1042 * z1222;
    const Scalar z1225 = z1042 * z1223 - z1154;
    const Scalar z1226 = z957 - z1059 * z1222;
    const Scalar z1227 = z1059 * z1223 + z1149;
    const Scalar z1228 = z960 - z1078 * z1222;
    const Scalar z1229 = z1078 * z1223 + z1158;
    const Scalar z1230 = z151 * z1221;
    const Scalar z1231 = z185 * z185 * (n25_over_3 + n1 / z379) + n1_over_94 + z151 * z151 / z438 + z182 * z182 / z406;
    const Scalar z1232 = z379 * z1217;
    const Scalar z1233 = n94 * z1231;
    const Scalar z1234 = n1 - z1204 * z1230;
    const Scalar z1235 = z1234 * z1234;
    const Scalar z1236 = n1 / z1234;
    const Scalar z1237 = z163 * z1211;
    const Scalar z1238 = z188 - z1237 * z1218;
    const Scalar z1239 = z926 + z1230 * z1214;
    const Scalar z1240 = z153 * z1237;
    const Scalar z1241 = z185 * z1211;
    const Scalar z1242 = z913 - z1224;
    const Scalar z1243 = z967 - z1237 * z1242;
    const Scalar z1244 = z1213 * z1242 - z1226;
    const Scalar z1245 = z1213 * z1225 + z1227;
    const Scalar z1246 = z185 - z163 * z1230;
    const Scalar z1247 = z1212 * z1242 - z1243 + z1228 - z1204 * z1244;
    const Scalar z1248 = z153 * z1212 - z183 + z1240 - z1204 * z1216;
    const Scalar z1249 = z1236 * z1246;
    const Scalar z1250 = z153 * z1241 - z1230 * z1248;
    const Scalar z1251 = z166 - z1212 * z1218 + z1238 + z1204 * z1219;
    const Scalar z1252 = z182 + z1241 * z1218 + z1230 * z1251;
    const Scalar z1253 = z1012 + z1241 * z1242 - z1230 * z1247;
    const Scalar z1254 = z1236 * z1250;
    const Scalar z1255 = z1204 * z1254 - z1248;
    const Scalar z1256 = z1236 * z1253;
    const Scalar z1257 = z1236 * z1239;
    const Scalar z1258 = z1204 * z1257 + z1214;
    const Scalar z1259 = z1236 * z1252;
    const Scalar z1260 = z1211 * z1242;
    const Scalar z1261 = z1204 * z1256 - z1247;
    const Scalar z1262 = z1221 * z1255;
    const Scalar z1263 = z1204 * z1259 + z1251;
    const Scalar z1264 = z1221 * z1258;
    const Scalar z1265 = z136 * z1262 + z1240;
    const Scalar z1266 = z1221 * z1261;
    const Scalar z1267 = z1216 + z1254 + z142 * z1262;
    const Scalar z1268 = z917 + z1257 + z142 * z1264;
    const Scalar z1269 = z1244 + z1256 + z142 * z1266;
    const Scalar z1270 = z136 * z1264 + z919;
    const Scalar z1271 = z136 * z1266 - z1243;
    const Scalar z1272 = z1201 * z1269;
    const Scalar z1273 = z1201 * z1267;
    const Scalar z1274 = z1221 * z1263;
    const Scalar z1275 = z988 - z1048 * z1222;
    const Scalar z1276 = z1201 * z1268;
    const Scalar z1277 = z1219 + z1259 + z142 * z1274;
    const Scalar z1278 = z1048 * z1223 - z1200;
    const Scalar z1279 = z1201 * z1277;
    const Scalar z1280 = z136 * z1274 - z1238;
    const Scalar z1281 = z195 * z1222 - z965 + z920 * z1274;
    const Scalar z1282 = z923 - z1275;
    const Scalar z1283 = z1237 * z1282 + z1281;
    const Scalar z1284 = z956 - z1057 * z1222 - z918 * z1274 + z291 * z1279;
    const Scalar z1285 = z291 * z1273 - z1148 - z1057 * z1223 - z918 * z1262;
    const Scalar z1286 = z1077 * z1222 - z959 - z925 * z1274 + z293 * z1279;
    const Scalar z1287 = z1077 * z1223 + z1157 - z925 * z1262 + z293 * z1273;
    const Scalar z1288 = z197 * z1222 + z1011 + z927 * z1274;
    const Scalar z1289 = z1213 * z1282 - z1284;
    const Scalar z1290 = z1212 * z1282 + z1283 - z1286 - z1204 * z1289;
    const Scalar z1291 = z1237 * z1225;
    const Scalar z1292 = z1212 * z1225 + z1291 - z1229 - z1204 * z1245;
    const Scalar z1293 = z163 - z1204 * z1249;
    const Scalar z1294 = z1221 * z1293;
    const Scalar z1295 = z1241 * z1282 + z1288 - z1230 * z1290;
    const Scalar z1296 = z1236 * z1295;
    const Scalar z1297 = z136 * z1294 - z163;
    const Scalar z1298 = z142 * z1294 - z1249;
    const Scalar z1299 = z1211 * z1225;
    const Scalar z1300 = z1204 * z1296 - z1290;
    const Scalar z1301 = z195 * z1223 + z920 * z1262;
    const Scalar z1302 = z1241 * z1225 - z1230 * z1292;
    const Scalar z1303 = z1201 * z1298;
    const Scalar z1304 = z1237 * z1278 + z1301;
    const Scalar z1305 = z1213 * z1278 - z1285;
    const Scalar z1306 = z1236 * z1302;
    const Scalar z1307 = z1212 * z1278 + z1304 - z1287 - z1204 * z1305;
    const Scalar z1308 = z1204 * z1306 - z1292;
    const Scalar z1309 = z1211 * z1282;
    const Scalar z1310 = z1221 * z1300;
    const Scalar z1311 = z136 * z1310 + z1283;
    const Scalar z1312 = z1289 + z1296 + z142 * z1310;
    const Scalar z1313 = z1221 * z1308;
    const Scalar z1314 = z1048 * z1260;
    const Scalar z1315 = z1048 * z1299;
    const Scalar z1316 = z1201 * z1312;
    const Scalar z1317 = z1245 + z1306 + z142 * z1313;
    const Scalar z1318 = z136 * z1313 + z1291;
    const Scalar z1319 = z195 * z1260 + z920 * z1266;
    const Scalar z1320 = z1201 * z1317;
    const Scalar z1321 = z968 + z1046 * z1222;
    const Scalar z1322 = z1046 * z1223 - z1179;
    const Scalar z1323 = z1021 - z1123 * z1222;
    const Scalar z1324 = z1123 * z1223 + z1193;
    const Scalar z1325 = z195 * z1299 + z920 * z1313;
    const Scalar z1326 = z195 - z920 * z1294;
    const Scalar z1327 = z920 * z1264;
    const Scalar z1328 = z291 * z1272 - z918 * z1266 - z1057 * z1260;
    const Scalar z1329 = z291 * z1320 - z918 * z1313 - z1057 * z1299;
    const Scalar z1330 = z291 * z1276 - z918 * z1264;
    const Scalar z1331 = z291 * z1303 - z918 * z1294;
    const Scalar z1332 = z1077 * z1260 - z925 * z1266 + z293 * z1272;
    const Scalar z1333 = z1077 * z1299 - z925 * z1313 + z293 * z1320;
    const Scalar z1334 = z197 * z1260 + z927 * z1266;
    const Scalar z1335 = z293 * z1276 - z925 * z1264;
    const Scalar z1336 = z293 * z1303 - z925 * z1294;
    const Scalar z1337 = z1204 * z1331 - z1326 - z1336;
    const Scalar z1338 = z197 * z1223 + z927 * z1262;
    const Scalar z1339 = z1024 - z1125 * z1222;
    const Scalar z1340 = z1241 * z1278 + z1338 - z1230 * z1307;
    const Scalar z1341 = z1211 * z1278;
    const Scalar z1342 = z197 * z1299 + z927 * z1313;
    const Scalar z1343 = z197 - z927 * z1294;
    const Scalar z1344 = z1314 + z1321;
    const Scalar z1345 = z1315 + z1322;
    const Scalar z1346 = z1050 + z1319;
    const Scalar z1347 = z1125 * z1223 + z1206;
    const Scalar z1348 = z1328 + z1323;
    const Scalar z1349 = z1329 - z1324;
    const Scalar z1350 = z930 + z1327;
    const Scalar z1351 = z928 + z1330;
    const Scalar z1352 = z1332 + z1339;
    const Scalar z1353 = z1333 - z1347;
    const Scalar z1354 = z1058 + z1334;
    const Scalar z1355 = z932 - z1335;
    const Scalar z1356 = z922 + z1344;
    const Scalar z1357 = z1237 * z1356 + z1346;
    const Scalar z1358 = z1213 * z1356 - z1348;
    const Scalar z1359 = z927 * z1264;
    const Scalar z1360 = z935 - z1359;
    const Scalar z1361 = z1204 * z1351 + z1350 + z1355;
    const Scalar z1362 = z1212 * z1356 + z1357 - z1352 - z1204 * z1358;
    const Scalar z1363 = z1230 * z1337 + z1343;
    const Scalar z1364 = z1230 * z1361 + z1360;
    const Scalar z1365 = z1236 * z1340;
    const Scalar z1366 = z1236 * z1363;
    const Scalar z1367 = z1236 * z1364;
    const Scalar z1368 = z1204 * z1365 - z1307;
    const Scalar z1369 = z1204 * z1366 + z1337;
    const Scalar z1370 = z1204 * z1367 + z1361;
    const Scalar z1371 = z1221 * z1368;
    const Scalar z1372 = z1221 * z1369;
    const Scalar z1373 = z1241 * z1356 + z1354 - z1230 * z1362;
    const Scalar z1374 = z1221 * z1370;
    const Scalar z1375 = z136 * z1371 + z1304;
    const Scalar z1376 = z136 * z1372 + z1326;
    const Scalar z1377 = z1236 * z1373;
    const Scalar z1378 = z136 * z1374 - z1350;
    const Scalar z1379 = z1305 + z1365 + z142 * z1371;
    const Scalar z1380 = z1204 * z1377 - z1362;
    const Scalar z1381 = z1331 + z1366 + z142 * z1372;
    const Scalar z1382 = z1351 + z1367 + z142 * z1374;
    const Scalar z1383 = z1221 * z1380;
    const Scalar z1384 = z1201 * z1379;
    const Scalar z1385 = z1237 * z1345 + z1325;
    const Scalar z1386 = z1213 * z1345 - z1349;
    const Scalar z1387 = z1212 * z1345 + z1385 - z1353 - z1204 * z1386;
    const Scalar z1388 = z1211 * z1356;
    const Scalar z1389 = z136 * z1383 + z1357;
    const Scalar z1390 = z1358 + z1377 + z142 * z1383;
    const Scalar z1391 = z1201 * z1381;
    const Scalar z1392 = z368 + z87 * z369 - z350 * z1222 - z360 * z1259 - z365 * z1274 + z366 * z1280;
    const Scalar z1393 = z884 - z885;
    const Scalar z1394 = z934 - z1237 * z1393;
    const Scalar z1395 = z933 + z1213 * z1393;
    const Scalar z1396 = z369 - z398 * z1223;
    const Scalar z1397 = z1241 * z1345 + z1342 - z1230 * z1387;
    const Scalar z1398 = z1212 * z1393 - z1394 + z929 - z1204 * z1395;
    const Scalar z1399 = z1236 * z1397;
    const Scalar z1400 = z1211 * z1345;
    const Scalar z1401 = z1204 * z1399 - z1387;
    const Scalar z1402 = z406 + z87 * z411 - z397 * z1222 - z417 * z1259 - z413 * z1274 + z418 * z1280 - z396 * z1279;
    const Scalar z1403 = z931 - z1241 * z1393 + z1230 * z1398;
    const Scalar z1404 = z1211 * z1393;
    const Scalar z1405 = z411 + n94 * z87 + z398 * z1222;
    const Scalar z1406 = z87 * z398 - z397 + z379 * z1222 - z393 * z1259 + z391 * z1274 + z395 * z1280 + z355 * z1279;
    const Scalar z1407 = z1236 * z1403;
    const Scalar z1408 = z1204 * z1407 + z1398;
    const Scalar z1409 = z350 + z379 * z1223 - z393 * z1254 + z391 * z1262 + z395 * z1265 + z355 * z1273;
    const Scalar z1410 = k18 + z350 * z1223 + z360 * z1254 + z365 * z1262 - z366 * z1265;
    const Scalar z1411 = z360 - z393 * z1223 + n94 * z1254 - z463 * z1262;
    const Scalar z1412 = z366 - z395 * z1223 - z465 * z1262 - n94 * z1265;
    const Scalar z1413 = z417 + z393 * z1222 - n94 * z1259 + z463 * z1274;
    const Scalar z1414 = z395 * z1222 + z418 + z465 * z1274 + n94 * z1280;
    const Scalar z1415 = n0_12 - z393 * z1249 - z391 * z1294 - z395 * z1297 - z355 * z1303;
    const Scalar z1416 = z365 + z391 * z1223 - z463 * z1254 + z438 * z1262 + z465 * z1265 + z361 * z1273;
    const Scalar z1417 = z391 * z1222 - z413 - z463 * z1259 + z438 * z1274 + z465 * z1280 + z361 * z1279;
    const Scalar z1418 = z463 * z1249 - z390 + z438 * z1294 + z465 * z1297 + z361 * z1303;
    const Scalar z1419 = n94 * z1249 + z463 * z1294;
    const Scalar z1420 = z465 * z1294 + n94 * z1297;
    const Scalar z1421 = z355 * z1222 - z396 + z361 * z1274 + n0_28 * z1279;
    const Scalar z1422 = z355 * z1223 + z361 * z1262 + n0_28 * z1273;
    const Scalar z1423 = z361 * z1294 + n0_28 * z1303;
    const Scalar z1424 = z1221 * z1401;
    const Scalar z1425 = z1221 * z1408;
    const Scalar z1426 = z87 * z1405 - z1259 * z1413 + z1280 * z1414 + z1279 * z1421 + z1222 * z1406 + z1274 * z1417
        + z1402;
    const Scalar z1427 = z136 * z1424 + z1385;
    const Scalar z1428 = z136 * z1425 + z1394;
    const Scalar z1429 = z1386 + z1399 + z142 * z1424;
    const Scalar z1430 = z1407 - z1395 + z142 * z1425;
    const Scalar z1431 = z1201 * z1382;
    const Scalar z1432 = z1410 + z1254 * z1411 - z1265 * z1412 + z1273 * z1422 + z1223 * z1409 + z1262 * z1416;
    const Scalar z1433 = z1265 * z1414 - z1392 - z1254 * z1413 + z1273 * z1421 + z1223 * z1406 + z1262 * z1417;
    const Scalar z1434 = z1201 * z1390;
    const Scalar z1435 = z536 + z607 * z1222;
    const Scalar z1436 = z607 * z1223 + z632;
    const Scalar z1437 = z569 + z616 * z1222 + z571 * z1274;
    const Scalar z1438 = z616 * z1223 - z634 + z571 * z1262;
    const Scalar z1439 = z570 - z617 * z1222 + z572 * z1274;
    const Scalar z1440 = z572 * z1262 - z635 - z617 * z1223;
    const Scalar z1441 = z1201 * z1429;
    const Scalar z1442 = z1201 * z1430;
    const Scalar z1443 = z545 * z1294 - z620 + z648 * z1303;
    const Scalar z1444 = z597 * z1222 - z611 + z612 * z1274 + z436 * z1279;
    const Scalar z1445 = z647 * z1222 + z652 - z655 * z1274;
    const Scalar z1446 = z642 + z647 * z1223 - z655 * z1262;
    const Scalar z1447 = z654 + z653 * z1274;
    const Scalar z1448 = z561 - z559 * z1222 - z584 * z1274 - z646 * z1279;
    const Scalar z1449 = z559 * z1223 - z638 + z584 * z1262 + z646 * z1273;
    const Scalar z1450 = z563 - z643 * z1222 + z562 * z1274 - z655 * z1279;
    const Scalar z1451 = z668 - z643 * z1223 + z562 * z1262 - z655 * z1273;
    const Scalar z1452 = z641 * z1222 - z586 + z545 * z1274 + z648 * z1279;
    const Scalar z1453 = z87 * z1435 - z1259 * z1437 - z1280 * z1439 + z1279 * z1445 + z1222 * z1448 + z1274 * z1450
        + z1452;
    const Scalar z1454 = z667 + z641 * z1223 + z545 * z1262 + z648 * z1273;
    const Scalar z1455 = z87 * z1436 - z1259 * z1438 + z1279 * z1446 - z1280 * z1440 - z1222 * z1449 + z1274 * z1451
        + z1454;
    const Scalar z1456 = n0_12 - z390 * z1294;
    const Scalar z1457 = z1249 * z1419 + z1456 + z1297 * z1420 + z1303 * z1423 + z1294 * z1418;
    const Scalar z1458 = n0_12 * z1223 + z390 * z1262;
    const Scalar z1459 = n0_12 * z1222 + z390 * z1274;
    const Scalar z1460 = z1273 * z1445 - z1444 - z1254 * z1437 - z1265 * z1439 + z1223 * z1448 + z1262 * z1450;
    const Scalar z1461 = z1249 * z1437 - z1447 - z1297 * z1439 + z1303 * z1445 + z1294 * z1450;
    const Scalar z1462 = z1249 * z1411 + z1458 + z1297 * z1412 - z1303 * z1422 - z1294 * z1416;
    const Scalar z1463 = z1249 * z1413 - z1459 + z1297 * z1414 + z1303 * z1421 + z1294 * z1417;
    const Scalar z1464 = z571 * z1294;
    const Scalar z1465 = z597 * z1223 + z612 * z1262 + z436 * z1273;
    const Scalar z1466 = z1465 + z1254 * z1438 - z1273 * z1446 + z1265 * z1440 + z1223 * z1449 - z1262 * z1451;
    const Scalar z1467 = z612 * z1294 + z436 * z1303;
    const Scalar z1468 = z572 * z1294;
    const Scalar z1469 = z653 * z1262;
    const Scalar z1470 = z1249 * z1438 - z1469 + z1303 * z1446 - z1297 * z1440 + z1294 * z1451;
    const Scalar z1471 = z653 * z1294;
    const Scalar z1472 = z655 * z1294;
    const Scalar z1473 = z584 * z1294 + z646 * z1303;
    const Scalar z1474 = z562 * z1294 - z653 - z655 * z1303;
    const Scalar z1475 = z1259 * z1464 - z1443 + z1280 * z1468 + z1279 * z1472 + z1222 * z1473 - z1274 * z1474;
    const Scalar z1476 = z1467 + z1254 * z1464 + z1265 * z1468 + z1273 * z1472 + z1223 * z1473 - z1262 * z1474;
    const Scalar z1477 = z1249 * z1464 - z1471 - z1297 * z1468 - z1303 * z1472 + z1294 * z1474;
    const Scalar z1478 = z923 * z1405 + z1309 * z1406 - z1296 * z1413 + z1310 * z1417 + z1311 * z1414 + z1316 * z1421;
    const Scalar z1479 = z1478 + z1453;
    const Scalar z1480 = z923 * z1396 - z1309 * z1409 - z1296 * z1411 - z1310 * z1416 + z1311 * z1412 - z1316 * z1422;
    const Scalar z1481 = z1309 * z1415 + z1296 * z1419 - z1310 * z1418 - z1311 * z1420 - z1316 * z1423;
    const Scalar z1482 = z1480 - z1460;
    const Scalar z1483 = z1481 - z1461;
    const Scalar z1484 = z1365 * z1413 - z1341 * z1406 - z1371 * z1417 - z1375 * z1414 - z1384 * z1421;
    const Scalar z1485 = z1484 - z1455;
    const Scalar z1486 = z1366 * z1413 - z1372 * z1417 - z1376 * z1414 - z1391 * z1421;
    const Scalar z1487 = z1486 - z1475;
    const Scalar z1488 = z616 * z1260 + z571 * z1266;
    const Scalar z1489 = z571 * z1264;
    const Scalar z1490 = z1341 * z1409 + z1365 * z1411 + z1371 * z1416 - z1375 * z1412 + z1384 * z1422;
    const Scalar z1491 = z1341 * z1415 + z1365 * z1419 - z1371 * z1418 - z1375 * z1420 - z1384 * z1423;
    const Scalar z1492 = z616 * z1299 + z571 * z1313;
    const Scalar z1493 = z1490 - z1466;
    const Scalar z1494 = z1491 - z1470;
    const Scalar z1495 = z1366 * z1411 + z1372 * z1416 - z1376 * z1412 + z1391 * z1422;
    const Scalar z1496 = z1366 * z1419 - z1372 * z1418 - z1376 * z1420 - z1391 * z1423;
    const Scalar z1497 = z408 + z1489;
    const Scalar z1498 = z1495 + z1476;
    const Scalar z1499 = z1496 + z1477;
    const Scalar z1500 = z549 - z568 * z1222;
    const Scalar z1501 = z568 * z1223 - z614;
    const Scalar z1502 = z574 + z576 * z1222;
    const Scalar z1503 = z576 * z1223 - z618;
    const Scalar z1504 = z1488 + z1502;
    const Scalar z1505 = z1492 + z1503;
    const Scalar z1506 = z801 + z824 * z1222;
    const Scalar z1507 = z824 * z1223 - z890;
    const Scalar z1508 = z775 - z820 * z1222;
    const Scalar z1509 = z820 * z1223 - z874;
    const Scalar z1510 = z575 - z577 * z1222;
    const Scalar z1511 = z577 * z1223 - z619;
    const Scalar z1512 = z780 - z822 * z1222;
    const Scalar z1513 = z822 * z1223 - z877;
    const Scalar z1514 = z707 - z826 * z1222;
    const Scalar z1515 = z826 * z1223 - z879;
    const Scalar z1516 = z714 - z834 * z1222;
    const Scalar z1517 = z834 * z1223 - z891;
    const Scalar z1518 = z607 * z1260;
    const Scalar z1519 = z1518 + z1500;
    const Scalar z1520 = z607 * z1299;
    const Scalar z1521 = z1520 - z1501;
    const Scalar z1522 = z545 * z1264 + z648 * z1276;
    const Scalar z1523 = z612 * z1264 + z436 * z1276;
    const Scalar z1524 = z597 * z1260 + z612 * z1266 + z436 * z1272;
    const Scalar z1525 = z597 * z1299 + z612 * z1313 + z436 * z1320;
    const Scalar z1526 = z655 * z1264;
    const Scalar z1527 = z647 * z1260 - z655 * z1266;
    const Scalar z1528 = z647 * z1299 - z655 * z1313;
    const Scalar z1529 = z653 * z1264;
    const Scalar z1530 = z653 * z1266;
    const Scalar z1531 = z653 * z1313;
    const Scalar z1532 = z572 * z1266 - z617 * z1260;
    const Scalar z1533 = z1532 + z1510;
    const Scalar z1534 = z572 * z1313 - z617 * z1299;
    const Scalar z1535 = z1534 - z1511;
    const Scalar z1536 = z572 * z1264;
    const Scalar z1537 = z409 + z1536;
    const Scalar z1538 = z559 * z1260 + z584 * z1266 + z646 * z1272;
    const Scalar z1539 = z559 * z1299 + z584 * z1313 + z646 * z1320;
    const Scalar z1540 = z584 * z1264 + z646 * z1276;
    const Scalar z1541 = z562 * z1264 - z655 * z1276;
    const Scalar z1542 = z709 + z1541;
    const Scalar z1543 = z562 * z1266 - z643 * z1260 - z655 * z1272;
    const Scalar z1544 = z562 * z1313 - z643 * z1299 - z655 * z1320;
    const Scalar z1545 = z545 * z1266 + z641 * z1260 + z648 * z1272;
    const Scalar z1546 = z545 * z1313 + z641 * z1299 + z648 * z1320;
    const Scalar z1547 = z1367 * z1413 - z1374 * z1417 - z1378 * z1414 - z1431 * z1421;
    const Scalar z1548 = z1543 - z1514;
    const Scalar z1549 = z922 * z1405 + z1388 * z1406 - z1377 * z1413 + z1383 * z1417 + z1389 * z1414 + z1434 * z1421;
    const Scalar z1550 = z1544 + z1515;
    const Scalar z1551 = z922 * z1396 - z1388 * z1409 - z1377 * z1411 - z1383 * z1416 + z1389 * z1412 - z1434 * z1422;
    const Scalar z1552 = z1388 * z1415 + z1377 * z1419 - z1383 * z1418 - z1389 * z1420 - z1434 * z1423;
    const Scalar z1553 = z1399 * z1413 - z1400 * z1406 - z1424 * z1417 - z1427 * z1414 - z1441 * z1421;
    const Scalar z1554 = z662 + z1522;
    const Scalar z1555 = z1367 * z1411 + z1374 * z1416 - z1378 * z1412 + z1431 * z1422;
    const Scalar z1556 = z1367 * z1419 - z1374 * z1418 - z1378 * z1420 - z1431 * z1423;
    const Scalar z1557 = z1545 - z1516;
    const Scalar z1558 = z1546 + z1517;
    const Scalar z1559 = z1400 * z1409 + z1399 * z1411 + z1424 * z1416 - z1427 * z1412 + z1441 * z1422;
    const Scalar z1560 = z1400 * z1415 + z1399 * z1419 - z1424 * z1418 - z1427 * z1420 - z1441 * z1423;
    const Scalar z1561 = z884 * z1405 + z1407 * z1413 - z1428 * z1414 - z1442 * z1421 - z1425 * z1417 + z1404 * z1406;
    const Scalar z1562 = z884 * z1396 + z1407 * z1411 - z1428 * z1412 + z1442 * z1422 + z1425 * z1416 - z1404 * z1409;
    const Scalar z1563 = z1407 * z1419 - z1428 * z1420 - z1442 * z1423 - z1425 * z1418 - z1404 * z1415;
    const Scalar z1564 = z665 + z1523;
    const Scalar z1565 = z1524 + z1506;
    const Scalar z1566 = z1525 + z1507;
    const Scalar z1567 = z669 - z1526;
    const Scalar z1568 = z1527 - z1508;
    const Scalar z1569 = z1528 + z1509;
    const Scalar z1570 = z703 + z1529;
    const Scalar z1571 = z777 - z1530;
    const Scalar z1572 = z1538 + z1512;
    const Scalar z1573 = z1539 - z1513;
    const Scalar z1574 = z705 - z1540;
    const Scalar z1575 = z87 * z1519 - z1259 * z1504 + z1279 * z1568 - z1280 * z1533 - z1222 * z1572 + z1274 * z1548
        + z1557;
    const Scalar z1576 = z87 * z1521 - z1259 * z1505 + z1279 * z1569 - z1280 * z1535 - z1222 * z1573 + z1274 * z1550
        + z1558;
    const Scalar z1577 = z87 * z835 + z940 - z887 * z1222 + z836 * z1259 + z945 * z1274 + z837 * z1280 - z883 * z1279;
    const Scalar z1578 = z1554 + z1279 * z1567 - z1259 * z1497 - z1280 * z1537 + z1222 * z1574 + z1274 * z1542;
    const Scalar z1579 = z1577 + z1561;
    const Scalar z1580 = z1273 * z1567 - z1564 - z1254 * z1497 - z1265 * z1537 + z1223 * z1574 + z1262 * z1542;
    const Scalar z1581 = z1249 * z1497 - z1570 - z1297 * z1537 + z1303 * z1567 + z1294 * z1542;
    const Scalar z1582 = z1565 + z1254 * z1504 - z1273 * z1568 + z1265 * z1533 + z1223 * z1572 - z1262 * z1548;
    const Scalar z1583 = z1571 + z1249 * z1504 + z1303 * z1568 - z1297 * z1533 + z1294 * z1548;
    const Scalar z1584 = z1566 + z1254 * z1505 - z1273 * z1569 + z1265 * z1535 + z1223 * z1573 - z1262 * z1550;
    const Scalar z1585 = z880 - z887 * z1223 + z836 * z1254 + z945 * z1262 + z837 * z1265 - z883 * z1273;
    const Scalar z1586 = z1249 * z1505 - z1531 + z1303 * z1569 - z1297 * z1535 + z1294 * z1550;
    const Scalar z1587 = z836 * z1249 - z881 - z945 * z1294 - z837 * z1297 + z883 * z1303;
    const Scalar z1588 = z1585 - z1562;
    const Scalar z1589 = z1587 - z1563;
    const Scalar z1590 = z1547 + z1578;
    const Scalar z1591 = z1549 + z1575;
    const Scalar z1592 = z1553 - z1576;
    const Scalar z1593 = z1555 - z1580;
    const Scalar z1594 = z1551 + z1582;
    const Scalar z1595 = z1559 - z1584;
    const Scalar z1596 = z1556 + z1581;
    const Scalar z1597 = z1552 - z1583;
    const Scalar z1598 = z1560 - z1586;
    const Scalar z1599 = n1 / z1457;
    const Scalar z1600 = z1462 * z1599;
    const Scalar z1601 = z1463 * z1599;
    const Scalar z1602 = z1426 - z1463 * z1601;
    const Scalar z1603 = z1433 + z1463 * z1600;
    const Scalar z1604 = z1432 - z1462 * z1600;
    const Scalar z1605 = z1482 + z1483 * z1600;
    const Scalar z1606 = z1493 - z1494 * z1600;
    const Scalar z1607 = z1593 - z1596 * z1600;
    const Scalar z1608 = n1 / z1604;
    const Scalar z1609 = z1498 - z1499 * z1600;
    const Scalar z1610 = z1594 + z1597 * z1600;
    const Scalar z1611 = z1595 - z1598 * z1600;
    const Scalar z1612 = z1603 * z1608;
    const Scalar z1613 = z1602 - z1603 * z1612;
    const Scalar z1614 = z1479 + z1483 * z1601 + z1612 * z1605;
    const Scalar z1615 = z1485 - z1494 * z1601 + z1612 * z1606;
    const Scalar z1616 = z1590 - z1596 * z1601 + z1612 * z1607;
    const Scalar z1617 = z1487 - z1499 * z1601 + z1612 * z1609;
    const Scalar z1618 = z1591 + z1597 * z1601 + z1612 * z1610;
    const Scalar z1619 = z1592 - z1598 * z1601 + z1612 * z1611;
    const Scalar z1620 = n1 / z1613;
    const Scalar z1621 = z1620 * z1614;
    const Scalar z1622 = z1620 * z1615;
    const Scalar z1623 = z1620 * z1616;
    const Scalar z1624 = z1620 * z1617;
    const Scalar z1625 = z1620 * z1618;
    const Scalar z1626 = z1620 * z1619;
    const Scalar z1627 = z1608 * z1605 + z1612 * z1621;
    const Scalar z1628 = z1608 * z1606 + z1612 * z1622;
    const Scalar z1629 = z1608 * z1607 + z1612 * z1623;
    const Scalar z1630 = z1608 * z1609 + z1612 * z1624;
    const Scalar z1631 = z1608 * z1610 + z1612 * z1625;
    const Scalar z1632 = z1608 * z1611 + z1612 * z1626;
    const Scalar z1633 = z1483 * z1599 + z1601 * z1621 + z1600 * z1627;
    const Scalar z1634 = z1494 * z1599 - z1601 * z1622 - z1600 * z1628;
    const Scalar z1635 = z1596 * z1599 - z1601 * z1623 - z1600 * z1629;
    const Scalar z1636 = z1499 * z1599 - z1601 * z1624 - z1600 * z1630;
    const Scalar z1637 = z1597 * z1599 + z1601 * z1625 + z1600 * z1631;
    const Scalar z1638 = z1598 * z1599 - z1601 * z1626 - z1600 * z1632;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z463;
    result.M[4] = z417;
    result.M[5] = z393;
    result.M[6] = z360;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z465;
    result.M[13] = -z418;
    result.M[14] = -z395;
    result.M[15] = -z366;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z411;
    result.M[23] = z398;
    result.M[24] = z369;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z463;
    result.M[28] = -z465;
    result.M[29] = n0;
    result.M[30] = z438;
    result.M[31] = -z413;
    result.M[32] = z391;
    result.M[33] = -z365;
    result.M[34] = z390;
    result.M[35] = z361;
    result.M[36] = z417;
    result.M[37] = -z418;
    result.M[38] = z411;
    result.M[39] = -z413;
    result.M[40] = z406;
    result.M[41] = -z397;
    result.M[42] = z368;
    result.M[43] = n0;
    result.M[44] = -z396;
    result.M[45] = z393;
    result.M[46] = -z395;
    result.M[47] = z398;
    result.M[48] = z391;
    result.M[49] = -z397;
    result.M[50] = z379;
    result.M[51] = -z350;
    result.M[52] = n0_12;
    result.M[53] = z355;
    result.M[54] = z360;
    result.M[55] = -z366;
    result.M[56] = z369;
    result.M[57] = -z365;
    result.M[58] = z368;
    result.M[59] = -z350;
    result.M[60] = k18;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z390;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z361;
    result.M[76] = -z396;
    result.M[77] = z355;
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
    result.C[27] = z571;
    result.C[28] = z572;
    result.C[29] = n0;
    result.C[30] = z562;
    result.C[31] = z545;
    result.C[32] = -z584;
    result.C[33] = z612;
    result.C[34] = z653;
    result.C[35] = -z655;
    result.C[36] = z569;
    result.C[37] = z570;
    result.C[38] = z536;
    result.C[39] = z563;
    result.C[40] = -z586;
    result.C[41] = z561;
    result.C[42] = -z611;
    result.C[43] = z654;
    result.C[44] = z652;
    result.C[45] = z616;
    result.C[46] = -z617;
    result.C[47] = z607;
    result.C[48] = -z643;
    result.C[49] = z641;
    result.C[50] = -z559;
    result.C[51] = z597;
    result.C[52] = n0;
    result.C[53] = z647;
    result.C[54] = z634;
    result.C[55] = z635;
    result.C[56] = -z632;
    result.C[57] = -z668;
    result.C[58] = -z667;
    result.C[59] = -z638;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = -z642;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z653;
    result.C[67] = z620;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = -z655;
    result.C[76] = z648;
    result.C[77] = -z646;
    result.C[78] = z436;
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
    result.K[27] = z408;
    result.K[28] = z409;
    result.K[29] = n0;
    result.K[30] = z709;
    result.K[31] = z662;
    result.K[32] = z705;
    result.K[33] = z665;
    result.K[34] = z703;
    result.K[35] = z669;
    result.K[36] = z574;
    result.K[37] = z575;
    result.K[38] = z549;
    result.K[39] = -z707;
    result.K[40] = -z714;
    result.K[41] = -z780;
    result.K[42] = z801;
    result.K[43] = -z777;
    result.K[44] = -z775;
    result.K[45] = z576;
    result.K[46] = -z577;
    result.K[47] = -z568;
    result.K[48] = z826;
    result.K[49] = z834;
    result.K[50] = z822;
    result.K[51] = z824;
    result.K[52] = n0;
    result.K[53] = z820;
    result.K[54] = z618;
    result.K[55] = -z619;
    result.K[56] = -z614;
    result.K[57] = z879;
    result.K[58] = z891;
    result.K[59] = z877;
    result.K[60] = z890;
    result.K[61] = n0;
    result.K[62] = z874;
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
    result.F[0] = -z836;
    result.F[1] = -z837;
    result.F[2] = z835;
    result.F[3] = z945;
    result.F[4] = z940;
    result.F[5] = -z887;
    result.F[6] = -z880;
    result.F[7] = -z881;
    result.F[8] = -z883;
    result.M_r[0] = z1426;
    result.M_r[1] = -z1433;
    result.M_r[2] = -z1463;
    result.M_r[3] = -z1433;
    result.M_r[4] = z1432;
    result.M_r[5] = -z1462;
    result.M_r[6] = -z1463;
    result.M_r[7] = -z1462;
    result.M_r[8] = z1457;
    result.C_r[0] = z1479;
    result.C_r[1] = z1482;
    result.C_r[2] = z1483;
    result.C_r[3] = z1485;
    result.C_r[4] = z1493;
    result.C_r[5] = -z1494;
    result.C_r[6] = -z1487;
    result.C_r[7] = -z1498;
    result.C_r[8] = z1499;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z1590;
    result.K_r[7] = z1593;
    result.K_r[8] = -z1596;
    result.K_r[9] = z1591;
    result.K_r[10] = z1594;
    result.K_r[11] = z1597;
    result.K_r[12] = z1592;
    result.K_r[13] = z1595;
    result.K_r[14] = -z1598;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = z1579;
    result.F_r[1] = -z1588;
    result.F_r[2] = z1589;
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
    result.A[20] = -z1257;
    result.A[21] = -z1270;
    result.A[22] = z1264;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z1276;
    result.A[27] = -z1623;
    result.A[28] = -z1629;
    result.A[29] = z1635;
    result.A[30] = -z1256;
    result.A[31] = -z1271;
    result.A[32] = z1266;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = z1272;
    result.A[37] = -z1625;
    result.A[38] = -z1631;
    result.A[39] = -z1637;
    result.A[40] = z1306;
    result.A[41] = z1318;
    result.A[42] = -z1313;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = -z1320;
    result.A[47] = -z1626;
    result.A[48] = -z1632;
    result.A[49] = z1638;
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
    result.A[70] = -z1259;
    result.A[71] = -z1280;
    result.A[72] = z1274;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z1621;
    result.A[78] = -z1627;
    result.A[79] = -z1633;
    result.A[80] = z1254;
    result.A[81] = z1265;
    result.A[82] = -z1262;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = -z1273;
    result.A[87] = -z1622;
    result.A[88] = -z1628;
    result.A[89] = z1634;
    result.A[90] = -z1249;
    result.A[91] = z1297;
    result.A[92] = -z1294;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = -z1303;
    result.A[97] = z1624;
    result.A[98] = z1630;
    result.A[99] = -z1636;
    if (!(traits::regular(z1215, z1232) && traits::regular(z1202, z1207) && traits::regular(z1220, z1208)
        && traits::regular(z1235, z1233) && traits::regular(z1613, z1426) && traits::regular(z1604, z1432)
        && traits::regular(z1457, z1457))) return torsor::Status::singular;
    // 0 x is 0 for every finite x and not a number for any other.
    const Scalar zero = ((((n0 * result.M[3] * result.M[4] * result.M[5] * result.M[6] * result.M[12] * result.M[13]
        * result.M[14] * result.M[15] * result.M[22] * result.M[23] * result.M[24] * result.M[27]) * (n0 * result.M[28]
        * result.M[30] * result.M[31] * result.M[32] * result.M[33] * result.M[34] * result.M[35] * result.M[36]
        * result.M[37] * result.M[38] * result.M[39] * result.M[40])) * ((n0 * result.M[41] * result.M[42]
        * result.M[44] * result.M[45] * result.M[46] * result.M[47] * result.M[48] * result.M[49] * result.M[50]
        * result.M[51] * result.M[53] * result.M[54]) * (n0 * result.M[55] * result.M[56] * result.M[57] * result.M[58]
        * result.M[59] * result.M[66] * result.M[75] * result.M[76] * result.M[77] * result.C[27] * result.C[28]
        * result.C[30] * result.C[31]))) * (((n0 * result.C[32] * result.C[33] * result.C[34] * result.C[35]
        * result.C[36] * result.C[37] * result.C[38] * result.C[39] * result.C[40] * result.C[41] * result.C[42]
        * result.C[43]) * (n0 * result.C[44] * result.C[45] * result.C[46] * result.C[47] * result.C[48] * result.C[49]
        * result.C[50] * result.C[51] * result.C[53] * result.C[54] * result.C[55] * result.C[56])) * ((n0
        * result.C[57] * result.C[58] * result.C[59] * result.C[62] * result.C[66] * result.C[67] * result.C[75]
        * result.C[76] * result.C[77] * result.C[78] * result.K[27] * result.K[28]) * (n0 * result.K[30] * result.K[31]
        * result.K[32] * result.K[33] * result.K[34] * result.K[35] * result.K[36] * result.K[37] * result.K[38]
        * result.K[39] * result.K[40] * result.K[41] * result.K[42])))) * ((((n0 * result.K[43] * result.K[44]
        * result.K[45] * result.K[46] * result.K[47] * result.K[48] * result.K[49] * result.K[50] * result.K[51]
        * result.K[53] * result.K[54] * result.K[55]) * (n0 * result.K[56] * result.K[57] * result.K[58] * result.K[59]
        * result.K[60] * result.K[62] * result.F[0] * result.F[1] * result.F[2] * result.F[3] * result.F[4]
        * result.F[5])) * ((n0 * result.F[6] * result.F[7] * result.F[8] * result.M_r[0] * result.M_r[1] * result.M_r[2]
        * result.M_r[3] * result.M_r[4] * result.M_r[5] * result.M_r[6] * result.M_r[7] * result.M_r[8]) * (n0
        * result.C_r[0] * result.C_r[1] * result.C_r[2] * result.C_r[3] * result.C_r[4] * result.C_r[5] * result.C_r[6]
        * result.C_r[7] * result.C_r[8] * result.K_r[6] * result.K_r[7] * result.K_r[8] * result.K_r[9]))) * (((n0
        * result.K_r[10] * result.K_r[11] * result.K_r[12] * result.K_r[13] * result.K_r[14] * result.F_r[0]
        * result.F_r[1] * result.F_r[2] * result.A[20] * result.A[21] * result.A[22] * result.A[26]) * (n0
        * result.A[27] * result.A[28] * result.A[29] * result.A[30] * result.A[31] * result.A[32] * result.A[36]
        * result.A[37] * result.A[38] * result.A[39] * result.A[40] * result.A[41])) * ((n0 * result.A[42]
        * result.A[46] * result.A[47] * result.A[48] * result.A[49] * result.A[70] * result.A[71] * result.A[72]
        * result.A[77] * result.A[78] * result.A[79] * result.A[80]) * (n0 * result.A[81] * result.A[82] * result.A[86]
        * result.A[87] * result.A[88] * result.A[89] * result.A[90] * result.A[91] * result.A[92] * result.A[96]
        * result.A[97] * result.A[98] * result.A[99]))));
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
