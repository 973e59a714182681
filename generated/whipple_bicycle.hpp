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
//   forward_dynamics        978             1299         26             2                  5       0   2315    2361
//   energy                  109              161          0             0                  6       0    282     302
//   first_integrals         110              161          0             0                  6       0    283     303
//   constraints             301              452         14             2                  4       0    777     816
//   linearisation          2437             3166        104             2                  7       0   5723    5996
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
  static constexpr unsigned long long fingerprint = 0x96f22d2c9ef254e3ULL ^ torsor::support_fingerprint;
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
    const Scalar z16 = v_steer * c_steer;
    const Scalar z17 = v_roll * s_roll;
    const Scalar z18 = v_yaw * c_yaw;
    const Scalar z19 = v_yaw * s_yaw;
    const Scalar z20 = v_roll * c_roll;
    const Scalar z21 = s_yaw * s_roll;
    const Scalar z22 = c_yaw * s_roll;
    const Scalar z23 = s_roll * z14;
    const Scalar z24 = s_roll * z15;
    const Scalar z25 = z14 * z14 + z15 * z15;
    const Scalar z26 = v_pitch * c_pitch;
    const Scalar z27 = s_yaw * z17 - c_roll * z18;
    const Scalar z28 = c_yaw * z17 + c_roll * z19;
    const Scalar z29 = n2 * (z14 * z21 + z15 * z22);
    const Scalar z30 = v_roll * z20;
    const Scalar z31 = v_yaw * z19;
    const Scalar z32 = n2 * z17;
    const Scalar z33 = v_yaw * z18;
    const Scalar z34 = n0_08 * z9 - n0_35 * z10;
    const Scalar z35 = s_pitch * z10 - c_pitch * z9;
    const Scalar z36 = s_pitch * z9 + c_pitch * z10;
    const Scalar z37 = z5 * z16;
    const Scalar z38 = z4 * z16;
    const Scalar z39 = s_yaw * z30 + c_roll * z31 + z18 * z32;
    const Scalar z40 = c_yaw * z30 + c_roll * z33 - z19 * z32;
    const Scalar z41 = n0_08 * z37 - n0_35 * z38;
    const Scalar z42 = n0_08 * z11 - n0_35 * z12;
    const Scalar z43 = n0_08 * z12 - n0_35 * z13;
    const Scalar z44 = traits::sqrt(z25);
    const Scalar z45 = v_steer * s_steer;
    const Scalar z46 = n2 * (z14 * z27 + z15 * z28);
    const Scalar z47 = s_roll * z36 - c_roll * c_steer;
    const Scalar z48 = s_roll * c_steer + c_roll * z36;
    const Scalar z49 = n0_3 + z43;
    const Scalar z50 = n1_1 - z42;
    const Scalar z51 = n2 * (z14 * z39 + z15 * z40 - z27 * z27 - z28 * z28);
    const Scalar z52 = s_pitch * z49 + c_pitch * z50;
    const Scalar z53 = s_pitch * z50 - c_pitch * z49;
    const Scalar z54 = c_yaw * z35 + s_yaw * z47;
    const Scalar z55 = s_yaw * z35 - c_yaw * z47;
    const Scalar z56 = z48 * z54;
    const Scalar z57 = z48 * z55;
    const Scalar z58 = z54 * z54 + z55 * z55;
    const Scalar z59 = s_roll * z53 - c_roll * z34;
    const Scalar z60 = s_roll * z34 + c_roll * z53;
    const Scalar z61 = n0_3 / z44;
    const Scalar z62 = -z45 * (n1 - z6);
    const Scalar z63 = n0_5 * z46 / z44;
    const Scalar z64 = n0_5 * z29 / z44;
    const Scalar z65 = q_z - z60;
    const Scalar z66 = traits::sqrt(z58);
    const Scalar z67 = s_yaw * z59 - c_yaw * z52;
    const Scalar z68 = s_yaw * z52 + c_yaw * z59;
    const Scalar z69 = q_y + z68;
    const Scalar z70 = q_x - z67;
    const Scalar z71 = q_x + z23 * z61;
    const Scalar z72 = z7 * z45;
    const Scalar z73 = q_y - z24 * z61;
    const Scalar z74 = n0_35 * z72 + n0_08 * z62;
    const Scalar z75 = q_z + z25 * z61;
    const Scalar z76 = v_pitch * s_pitch;
    const Scalar z77 = z9 * z26 - z10 * z76 + s_pitch * z37 + c_pitch * z38;
    const Scalar z78 = z9 * z76 + z10 * z26 + s_pitch * z38 - c_pitch * z37;
    const Scalar z79 = n0_3 * z64;
    const Scalar z80 = n0_5 * (z46 * z63 / (z44 * z44) + z51 / z44);
    const Scalar z81 = s_roll * z35;
    const Scalar z82 = s_yaw * z48;
    const Scalar z83 = n0_35 / z66;
    const Scalar z84 = s_yaw * z81 - c_yaw * z36;
    const Scalar z85 = s_yaw * z36 + c_yaw * z81;
    const Scalar z86 = c_yaw * z48;
    const Scalar z87 = n2 * (z54 * z82 - z55 * z86);
    const Scalar z88 = c_roll * z45 + c_steer * z17 + z20 * z36 + s_roll * z77;
    const Scalar z89 = -z45 * (n1 - z8);
    const Scalar z90 = n0_08 * z72 + n0_35 * z89;
    const Scalar z91 = n0_5 * z87 / z66;
    const Scalar z92 = z70 - z56 * z83;
    const Scalar z93 = z65 + z58 * z83;
    const Scalar z94 = z69 - z57 * z83;
    const Scalar z95 = z18 * z35 + z19 * z47 + s_yaw * z78 - c_yaw * z88;
    const Scalar z96 = n0_3 * z80;
    const Scalar z97 = n2 * (z54 * z84 - z55 * z85);
    const Scalar z98 = n0_5 * z97 / z66;
    const Scalar z99 = v_steer * z16;
    const Scalar z100 = z5 * c_steer;
    const Scalar z101 = z4 * c_steer;
    const Scalar z102 = s_pitch * z100 + c_pitch * z101;
    const Scalar z103 = s_pitch * z101 - c_pitch * z100;
    const Scalar z104 = n0_08 * z100 - n0_35 * z101;
    const Scalar z105 = z59 + n0_35 * z91;
    const Scalar z106 = s_steer * z7;
    const Scalar z107 = s_steer * (n1 - z6);
    const Scalar z108 = c_roll * s_steer + s_roll * z102;
    const Scalar z109 = n0_08 * z107 - n0_35 * z106;
    const Scalar z110 = s_steer * (n1 - z8);
    const Scalar z111 = n0_08 * z106 - n0_35 * z110;
    const Scalar z112 = c_yaw * z103 + s_yaw * z108;
    const Scalar z113 = s_yaw * z103 - c_yaw * z108;
    const Scalar z114 = n2 * (z54 * z112 + z55 * z113);
    const Scalar z115 = c_pitch * z111 + s_pitch * z109;
    const Scalar z116 = c_roll * z52;
    const Scalar z117 = z116 + n0_35 * z98;
    const Scalar z118 = z18 * z47 - z19 * z35 + c_yaw * z78 + s_yaw * z88;
    const Scalar z119 = s_roll * z104 + c_roll * z115;
    const Scalar z120 = n0_5 * z114 / z66;
    const Scalar z121 = n2 * (z55 * z95 + z54 * z118);
    const Scalar z122 = v_pitch * z76;
    const Scalar z123 = s_pitch * z74 - c_pitch * z90 - z50 * z26 - z49 * z76;
    const Scalar z124 = v_pitch * z26;
    const Scalar z125 = v_steer * z45;
    const Scalar z126 = v_roll * z17;
    const Scalar z127 = z5 * z125;
    const Scalar z128 = z4 * z125;
    const Scalar z129 = n0_5 * z121 / z66;
    const Scalar z130 = z20 * z34 + s_roll * z41 - z17 * z53 - c_roll * z123;
    const Scalar z131 = v_z - z130;
    const Scalar z132 = n0_3 * z63 / (z44 * z44);
    const Scalar z133 = z119 - n0_35 * z120;
    const Scalar z134 = v_z - z61 * z46 + z25 * z132;
    const Scalar z135 = q_z - z75;
    const Scalar z136 = q_x - z71;
    const Scalar z137 = q_y - z73;
    const Scalar z138 = v_z - z134;
    const Scalar z139 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z140 = s_roll * z139;
    const Scalar z141 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z142 = s_pitch * z4 - c_pitch * z5;
    const Scalar z143 = s_yaw * z140 - c_yaw * z141;
    const Scalar z144 = s_roll * z142;
    const Scalar z145 = c_roll * z139;
    const Scalar z146 = s_pitch * z5 + c_pitch * z4;
    const Scalar z147 = q_x - z92;
    const Scalar z148 = c_roll * z142;
    const Scalar z149 = q_z - z93;
    const Scalar z150 = s_yaw * z144 - c_yaw * z146;
    const Scalar z151 = c_yaw * z149;
    const Scalar z152 = s_roll * z147 + z14 * z149;
    const Scalar z153 = q_y - z94;
    const Scalar z154 = s_yaw * z146 + c_yaw * z144;
    const Scalar z155 = s_yaw * z149;
    const Scalar z156 = s_roll * z153 - z15 * z149;
    const Scalar z157 = c_yaw * z135;
    const Scalar z158 = s_yaw * z135;
    const Scalar z159 = s_roll * z136 + z14 * z135;
    const Scalar z160 = z9 * z122 + z10 * z124 + s_pitch * z127 + c_pitch * z128 - n2 * (z37 * z26 - z38 * z76);
    const Scalar z161 = z10 * z122 - z9 * z124 + s_pitch * z128 - c_pitch * z127 - n2 * (z37 * z76 + z38 * z26);
    const Scalar z162 = n0_08 * z127 - n0_35 * z128;
    const Scalar z163 = q_z - z145;
    const Scalar z164 = z36 * z126 - c_roll * z99 - c_steer * z30 + n2 * (z17 * z45 - z20 * z77) + s_roll * z160;
    const Scalar z165 = s_yaw * z141 + c_yaw * z140;
    const Scalar z166 = s_roll * z137 - z15 * z135;
    const Scalar z167 = z33 * z35 + z31 * z47 - n2 * (z18 * z88 - z19 * z78) + c_yaw * z161 + s_yaw * z164;
    const Scalar z168 = z31 * z35 - z33 * z47 - n2 * (z18 * z78 + z19 * z88) + s_yaw * z161 - c_yaw * z164;
    const Scalar z169 = n2 * (z54 * z167 + z55 * z168 - z118 * z118 - z95 * z95);
    const Scalar z170 = z7 * z99;
    const Scalar z171 = -z99 * (n1 - z6);
    const Scalar z172 = q_x - z143;
    const Scalar z173 = q_y + z165;
    const Scalar z174 = n0_35 * z170 + n0_08 * z171;
    const Scalar z175 = z92 - z172;
    const Scalar z176 = -z99 * (n1 - z8);
    const Scalar z177 = n0_08 * z170 + n0_35 * z176;
    const Scalar z178 = z93 - z163;
    const Scalar z179 = z94 - z173;
    const Scalar z180 = z148 * z175 - z150 * z178;
    const Scalar z181 = s_pitch * z174 - z49 * z124 - c_pitch * z177 + z50 * z122 + n2 * (z26 * z74 + z76 * z90);
    const Scalar z182 = z70 - z92;
    const Scalar z183 = z69 - z94;
    const Scalar z184 = n0_5 * (z121 * z129 / (z66 * z66) + z169 / z66);
    const Scalar z185 = z148 * z179 + z154 * z178;
    const Scalar z186 = s_roll * z28 - z15 * z20;
    const Scalar z187 = v_y + z61 * z186 - z24 * z132;
    const Scalar z188 = s_roll * z27 - z14 * z20;
    const Scalar z189 = v_x - z61 * z188 + z23 * z132;
    const Scalar z190 = z34 * z126 + s_roll * z162 + z30 * z53 - n2 * (z20 * z41 + z17 * z123) + c_roll * z181;
    const Scalar z191 = c_roll * z41 - z17 * z34 - z20 * z53 + s_roll * z123;
    const Scalar z192 = s_pitch * z90 + c_pitch * z74 + z50 * z76 - z49 * z26;
    const Scalar z193 = s_roll * z45 - c_steer * z20 + z17 * z36 - c_roll * z77;
    const Scalar z194 = z65 - z93;
    const Scalar z195 = z190 - n0_35 * z184;
    const Scalar z196 = n0_35 * z129 / (z66 * z66);
    const Scalar z197 = z58 * z196 - z131 - z83 * z121;
    const Scalar z198 = v_y - z187;
    const Scalar z199 = v_x - z189;
    const Scalar z200 = z48 * z182 - z54 * z194;
    const Scalar z201 = z48 * z183 - z55 * z194;
    const Scalar z202 = n0_3 * z26 - n1_1 * z76;
    const Scalar z203 = s_yaw * z192 - z18 * z52 + z19 * z59 + c_yaw * z191;
    const Scalar z204 = v_y - z203;
    const Scalar z205 = z4 * z26 + z5 * z76;
    const Scalar z206 = n1_1 * z26 + n0_3 * z76;
    const Scalar z207 = z48 * z95 - z55 * z193;
    const Scalar z208 = z204 - z83 * z207 + z57 * z196;
    const Scalar z209 = z20 * z139 + s_roll * z206;
    const Scalar z210 = c_roll * z205 - z17 * z142;
    const Scalar z211 = z18 * z141 + s_yaw * z202 - z19 * z140 + c_yaw * z209;
    const Scalar z212 = v_y - z208;
    const Scalar z213 = v_z + z197;
    const Scalar z214 = z18 * z149 + s_yaw * z213;
    const Scalar z215 = z28 * z149 + z20 * z153 + s_roll * z212 - z15 * z213;
    const Scalar z216 = z28 * z135 + z20 * z137 + s_roll * z198 - z15 * z138;
    const Scalar z217 = z18 * z135 + s_yaw * z138;
    const Scalar z218 = v_yaw * z198 - v_roll * z217 + z216 * (v_pitch + v_rear);
    const Scalar z219 = c_roll * z206 - z17 * z139;
    const Scalar z220 = z4 * z76 - z5 * z26;
    const Scalar z221 = z20 * z142 + s_roll * z205;
    const Scalar z222 = v_y + z211;
    const Scalar z223 = z208 - z222;
    const Scalar z224 = s_yaw * z220 - z18 * z146 + z19 * z144 - c_yaw * z221;
    const Scalar z225 = c_yaw * z138 - z19 * z135;
    const Scalar z226 = z20 * z136 - z27 * z135 + s_roll * z199 + z14 * z138;
    const Scalar z227 = v_yaw * z199 - v_roll * z225 + z226 * (v_pitch + v_rear);
    const Scalar z228 = s_yaw * z191 - c_yaw * z192 - z18 * z59 - z19 * z52;
    const Scalar z229 = z19 * z141 - c_yaw * z202 + z18 * z140 + s_yaw * z209;
    const Scalar z230 = z19 * z146 + c_yaw * z220 + z18 * z144 + s_yaw * z221;
    const Scalar z231 = z204 - z208;
    const Scalar z232 = v_x + z228;
    const Scalar z233 = v_x - z229;
    const Scalar z234 = v_z - z219;
    const Scalar z235 = z197 + z234;
    const Scalar z236 = z131 + z197;
    const Scalar z237 = z48 * z231 - z95 * z194 - z183 * z193 - z55 * z236;
    const Scalar z238 = z179 * z210 - z178 * z224 + z148 * z223 - z154 * z235;
    const Scalar z239 = c_yaw * z213 - z19 * z149;
    const Scalar z240 = v_yaw * c_roll;
    const Scalar z241 = v_yaw * s_roll;
    const Scalar z242 = v_roll * z2 - z1 * z240;
    const Scalar z243 = v_pitch + z241;  // angular velocity of frame, z
    const Scalar z244 = v_roll * z241;  // angular acceleration of frame.2, y
    const Scalar z245 = v_roll * z1 + z2 * z240;
    const Scalar z246 = v_yaw * z212 - v_roll * z214 + v_pitch * z215 + v_steer * z238 + v_front * z237;
    const Scalar z247 = z2 * z244;
    const Scalar z248 = v_pitch * z242 - z247;  // angular acceleration of frame, y
    const Scalar z249 = s_steer * z243 + c_steer * z242;
    const Scalar z250 = s_steer * z242 - c_steer * z243;
    const Scalar z251 = z1 * z244;
    const Scalar z252 = v_pitch * z245 - z251;  // angular acceleration of frame, x
    const Scalar z253 = v_roll * z240;  // angular acceleration of frame.2, x
    const Scalar z254 = v_steer + z245;  // angular velocity of fork, z
    const Scalar z255 = z249 * z250;
    const Scalar z256 = z250 * z250;
    const Scalar z257 = z254 * z254;
    const Scalar z258 = z248 - z255;
    const Scalar z259 = c_steer * z253 + s_steer * z252;
    const Scalar z260 = z256 + z257;
    const Scalar z261 = n9_81 * c_roll;
    const Scalar z262 = z242 * z245;
    const Scalar z263 = v_front - z250;  // angular velocity of front_wheel, z
    const Scalar z264 = z2 * z261;
    const Scalar z265 = z1 * z261;
    const Scalar z266 = v_steer * z249 - z259;  // angular acceleration of fork, y
    const Scalar z267 = z245 * z245;
    const Scalar z268 = z243 * z243;
    const Scalar z269 = z253 - z262;
    const Scalar z270 = z249 * z254;
    const Scalar z271 = v_rear + z243;  // angular velocity of rear_wheel, z
    const Scalar z272 = s_steer * z253 - c_steer * z252;
    const Scalar z273 = z266 + z270;
    const Scalar z274 = v_steer * z250 - z272;  // angular acceleration of fork, x
    const Scalar z275 = z250 * z254;
    const Scalar z276 = z254 * z263;
    const Scalar z277 = z249 * z263;
    const Scalar z278 = z249 * z249;
    const Scalar z279 = z267 + z268;
    const Scalar z280 = z264 + k10 * z269;
    const Scalar z281 = n9_81 * s_roll;
    const Scalar z282 = z242 * z243;
    const Scalar z283 = z248 + z282;
    const Scalar z284 = z265 - k10 * z279;
    const Scalar z285 = z274 - z275;
    const Scalar z286 = z48 * z118 - z54 * z193;
    const Scalar z287 = z232 - z83 * z286 + z56 * z196;
    const Scalar z288 = n0_28 * z276;  // moment on front_wheel, x
    const Scalar z289 = n0_28 * z277;  // moment on front_wheel, y
    const Scalar z290 = z281 - k10 * z283;
    const Scalar z291 = s_steer * z284 + c_steer * z290;
    const Scalar z292 = v_x - z287;
    const Scalar z293 = z274 + z275;
    const Scalar z294 = n0_28 * z266;  // moment on front_wheel, z
    const Scalar z295 = z287 - z233;
    const Scalar z296 = z232 - z287;
    const Scalar z297 = z20 * z147 - z27 * z149 + s_roll * z292 + z14 * z213;
    const Scalar z298 = z175 * z210 - z178 * z230 + z148 * z295 + z150 * z235;
    const Scalar z299 = z48 * z296 - z118 * z194 - z182 * z193 - z54 * z236;
    const Scalar z300 = z289 + k12 * z248 + k13 * z255 + k14 * z285 - k15 * z291;  // moment on fork, z
    const Scalar z301 = z257 - z278;
    const Scalar z302 = k14 * z258 + z288 + n0_1435 * z293;  // moment on fork, x
    const Scalar z303 = k15 * z280 - z294 - k14 * z301 - k17 * z273;  // moment on fork, y
    const Scalar z304 = v_yaw * z292 + v_pitch * z297 + v_steer * z298 - v_roll * z239 + v_front * z299;
    const Scalar z305 = z241 * z240;
    const Scalar z306 = k15 * z258;  // force on fork, y
    const Scalar z307 = k15 * z260;  // force on fork, x
    const Scalar z308 = k15 * z273;  // force on fork, z
    const Scalar z309 = z245 * z243;
    const Scalar z310 = z252 + z309;
    const Scalar z311 = z245 * z271;
    const Scalar z312 = z242 * z271;
    const Scalar z313 = n0_12 * z312;  // moment on rear_wheel, y
    const Scalar z314 = z242 * z242;
    const Scalar z315 = n0_12 * z311;  // moment on rear_wheel, x
    const Scalar z316 = z268 + z314;
    const Scalar z317 = z267 - z314;
    const Scalar z318 = n2 * z244;
    const Scalar z319 = k19 * c_steer;
    const Scalar z320 = k19 * s_steer;
    const Scalar z321 = k20 * z269 - z308 - k21 * z316;  // force on frame, y
    const Scalar z322 = k13 + s_steer * z320;
    const Scalar z323 = k15 * c_steer;
    const Scalar z324 = k14 * c_steer;
    const Scalar z325 = k13 + c_steer * z319;
    const Scalar z326 = s_steer * z319;
    const Scalar z327 = n0_28 * c_steer;
    const Scalar z328 = k15 * s_steer;
    const Scalar z329 = k10 * z328 + z326;
    const Scalar z330 = k14 * s_steer;
    const Scalar z331 = n0_28 * s_steer;
    const Scalar z332 = k12 + k10 * z323;
    const Scalar z333 = z2 * z331;
    const Scalar z334 = z1 * z331;
    const Scalar z335 = z1 * z332 - z2 * z324;
    const Scalar z336 = s_roll * z327 + c_roll * z334;
    const Scalar z337 = z1 * z324 + z2 * z332;
    const Scalar z338 = s_roll * z330 - c_roll * z337;
    const Scalar z339 = z1 * z328;
    const Scalar z340 = s_roll * z323 + c_roll * z339;
    const Scalar z341 = s_roll * z339 - c_roll * z323;
    const Scalar z342 = z2 * z328;
    const Scalar z343 = n0_12 * z253;  // moment on rear_wheel, z
    const Scalar z344 = s_steer * z306 + c_steer * z307;
    const Scalar z345 = s_steer * z307 - c_steer * z306;
    const Scalar z346 = k22 * z323 + z325;
    const Scalar z347 = k20 * z281 - z313 - k23 * z283 + k24 * z310 + k10 * z345 - z300;  // moment on frame, y
    const Scalar z348 = k20 * z283 - z345 - k21 * z310;  // force on frame, z
    const Scalar z349 = k12 + k22 * z323;
    const Scalar z350 = s_yaw * z342 + c_yaw * z341;
    const Scalar z351 = s_yaw * z341 - c_yaw * z342;
    const Scalar z352 = z253 + z262;
    const Scalar z353 = k20 * z279 + z344 + k21 * z352;  // force on frame, x
    const Scalar z354 = c_steer * z302 + s_steer * z303;
    const Scalar z355 = k21 * z281 + z315 - k24 * z283 + k25 * z310 + z354;  // moment on frame, x
    const Scalar z356 = s_steer * z302 - c_steer * z303;
    // moment on frame, z
    const Scalar z357 = z343 + k26 * z253 - k21 * z265 + k20 * z264 - k27 * z262 + k24 * z317 - k10 * z308 - z356;
    const Scalar z358 = k24 - z324;
    const Scalar z359 = k28 - z322;
    const Scalar z360 = k29 + z346;
    const Scalar z361 = k20 + z323;
    const Scalar z362 = n2 * z358;
    const Scalar z363 = z349 + z359;
    const Scalar z364 = z1 * z329 - z2 * z330;
    const Scalar z365 = z1 * z362 - z2 * z363;
    const Scalar z366 = z1 * z330 + z2 * z329;
    const Scalar z367 = n0_12 + z360;
    const Scalar z368 = s_roll * z367 + c_roll * z364;
    const Scalar z369 = n0_12 * s_roll;
    const Scalar z370 = k21 * z2 + z1 * z361;
    const Scalar z371 = k21 * z1 - z2 * z361;
    const Scalar z372 = z2 * z365;
    const Scalar z373 = c_roll * z371;
    const Scalar z374 = s_roll * z371;
    const Scalar z375 = z1 * z353 - z2 * z321;
    const Scalar z376 = z1 * z321 + z2 * z353;
    const Scalar z377 = z359 + z372;
    const Scalar z378 = z349 + z372;
    const Scalar z379 = s_yaw * z370 + c_yaw * z374;
    const Scalar z380 = s_yaw * z374 - c_yaw * z370;
    const Scalar z381 = s_roll * z375 - c_roll * z348;
    const Scalar z382 = s_roll * z348 + c_roll * z375;
    const Scalar z383 = n922_14 - z382;  // force on frame.z, z
    const Scalar z384 = z2 * z355 + z1 * z347;
    const Scalar z385 = z1 * z355 - z2 * z347;
    const Scalar z386 = z1 * z365 - z358;
    const Scalar z387 = z384 - n0_5603 * z305;  // moment on frame.2, z
    const Scalar z388 = z385 - n0_5603 * z318;  // moment on frame.2, y
    const Scalar z389 = k32 - z377;
    const Scalar z390 = k32 + z378;
    const Scalar z391 = s_roll * z366 + c_roll * z386;
    const Scalar z392 = s_roll * z357 + c_roll * z388;
    const Scalar z393 = z367 - z389;
    const Scalar z394 = c_roll * z328 + s_roll * z370;
    const Scalar z395 = s_roll * z328 - c_roll * z370;
    const Scalar z396 = c_yaw * z395;
    const Scalar z397 = s_yaw * z395;
    const Scalar z398 = s_yaw * z381 - c_yaw * z376;
    const Scalar z399 = s_yaw * z376 + c_yaw * z381;
    const Scalar z400 = c_steer * z327 - z360;
    const Scalar z401 = n25_over_7 * z327;
    const Scalar z402 = n2 * z364;
    const Scalar z403 = c_roll * z402 + s_roll * z393;
    const Scalar z404 = z333 * z401 - z366;
    const Scalar z405 = z336 * z401 - z368;
    const Scalar z406 = z369 + z405;
    const Scalar z407 = k34 * z330;
    const Scalar z408 = z330 * z407 + z400;
    const Scalar z409 = z335 * z407 + z404;
    const Scalar z410 = z338 * z407 + z406;
    const Scalar z411 = s_roll * z403;
    const Scalar z412 = z340 * z407 + z373;
    const Scalar z413 = n1 / z408;
    const Scalar z414 = z350 * z407 + z379;
    const Scalar z415 = z389 + z411;
    const Scalar z416 = z351 * z407 + z380;
    const Scalar z417 = n25_over_7 * z333;
    const Scalar z418 = z333 * z417 - z390;
    const Scalar z419 = z336 * z417 - z391;
    const Scalar z420 = k34 * z335;
    const Scalar z421 = z350 * z420 - z396;
    const Scalar z422 = z351 * z420 - z397;
    const Scalar z423 = z335 * z420 + z418;
    const Scalar z424 = z338 * z420 + z419;
    const Scalar z425 = n25_over_7 * z336;
    const Scalar z426 = z336 * z425 - z415;
    const Scalar z427 = n25_over_3 * z369;
    const Scalar z428 = k34 * z338;
    const Scalar z429 = z409 * z413;
    const Scalar z430 = z410 * z413;
    const Scalar z431 = k34 * z340;
    const Scalar z432 = z340 * z428;
    const Scalar z433 = z369 * z427 + z426;
    const Scalar z434 = z432 - z412 * z430;
    const Scalar z435 = z421 - z414 * z429;
    const Scalar z436 = z422 - z416 * z429;
    const Scalar z437 = z338 * z428 + z433;
    const Scalar z438 = z340 * z420 - z394;
    const Scalar z439 = n94 - z340 * z431;
    const Scalar z440 = z438 - z412 * z429;
    const Scalar z441 = z437 - z410 * z430;
    const Scalar z442 = z412 * z413;
    const Scalar z443 = z439 + z412 * z442;
    const Scalar z444 = c_yaw * z371 + s_yaw * z394;
    const Scalar z445 = s_yaw * z371 - c_yaw * z394;
    const Scalar z446 = z423 - z409 * z429;
    const Scalar z447 = z424 - z410 * z429;
    const Scalar z448 = n1 / z446;
    const Scalar z449 = z350 * z428 + z444;
    const Scalar z450 = z449 - z414 * z430;
    const Scalar z451 = z351 * z428 + z445;
    const Scalar z452 = z451 - z416 * z430;
    const Scalar z453 = k34 * z350;
    const Scalar z454 = z350 * z431;
    const Scalar z455 = n94 - z350 * z453;
    const Scalar z456 = z454 - z414 * z442;
    const Scalar z457 = z414 * z413;
    const Scalar z458 = k34 * z351;
    const Scalar z459 = z351 * z453;
    const Scalar z460 = z455 + z414 * z457;
    const Scalar z461 = z459 - z416 * z457;
    const Scalar z462 = z351 * z431;
    const Scalar z463 = n94 - z351 * z458;
    const Scalar z464 = z462 - z416 * z442;
    const Scalar z465 = z447 * z448;
    const Scalar z466 = z440 * z448;
    const Scalar z467 = z435 * z448;
    const Scalar z468 = z441 - z447 * z465;
    const Scalar z469 = z434 - z440 * z465;
    const Scalar z470 = z443 + z440 * z466;
    const Scalar z471 = z456 - z435 * z466;
    const Scalar z472 = n1 / z468;
    const Scalar z473 = z450 - z435 * z465;
    const Scalar z474 = z460 + z435 * z467;
    const Scalar z475 = z461 - z436 * z467;
    const Scalar z476 = z464 - z436 * z466;
    const Scalar z477 = z452 - z436 * z465;
    const Scalar z478 = z416 * z413;
    const Scalar z479 = z463 + z416 * z478;
    const Scalar z480 = z436 * z448;
    const Scalar z481 = z158 * z465;
    const Scalar z482 = z117 + z133 * z407;
    const Scalar z483 = z105 + z133 * z420 - z429 * z482;
    const Scalar z484 = z479 + z436 * z480;
    const Scalar z485 = z79 * z465;
    const Scalar z486 = z477 * z472;
    const Scalar z487 = z469 * z472;
    const Scalar z488 = z473 * z472;
    const Scalar z489 = z157 * z465;
    const Scalar z490 = z133 * z428 - z430 * z482 - z465 * z483;
    const Scalar z491 = z470 + z469 * z487;
    const Scalar z492 = z471 - z473 * z487;
    const Scalar z493 = z474 + z473 * z488;
    const Scalar z494 = n1 / z491;
    const Scalar z495 = z475 - z477 * z488;
    const Scalar z496 = z476 - z477 * z487;
    const Scalar z497 = z484 + z477 * z486;
    const Scalar z498 = z157 * z466 - z487 * z489;
    const Scalar z499 = z158 * z466 - z487 * z481;
    const Scalar z500 = n1 + z133 * z431 - z442 * z482 - z466 * z483 - z487 * z490;
    const Scalar z501 = n1 + z79 * z466 - z487 * z485;
    const Scalar z502 = z496 * z494;
    const Scalar z503 = z492 * z494;
    const Scalar z504 = z497 - z496 * z502;
    const Scalar z505 = z495 + z496 * z503;
    const Scalar z506 = z156 + z185 * z407 - z201 * z401;
    const Scalar z507 = z493 - z492 * z503;
    const Scalar z508 = z155 + z185 * z420 - z201 * z417 - z429 * z506;
    const Scalar z509 = n1 / z507;
    const Scalar z510 = z153 + z185 * z428 - z201 * z425 - z430 * z506 - z465 * z508;
    const Scalar z511 = n1 + z157 * z467 - z488 * z489 + z503 * z498;
    const Scalar z512 = z158 * z467 - z488 * z481 + z503 * z499;
    const Scalar z513 = z133 * z453 - z457 * z482 - z467 * z483 - z488 * z490 + z503 * z500;
    const Scalar z514 = z505 * z509;
    const Scalar z515 = z504 - z505 * z514;
    const Scalar z516 = z185 * z431 - z442 * z506 - z466 * z508 - z487 * z510;
    const Scalar z517 = n1 / z515;
    const Scalar z518 = z185 * z453 - z457 * z506 - z467 * z508 - z488 * z510 + z503 * z516;
    const Scalar z519 = n1 - z185 * z458 + z478 * z506 + z480 * z508 + z486 * z510 - z502 * z516 - z514 * z518;
    const Scalar z520 = z157 * z480 - z486 * z489 + z502 * z498 + z514 * z511;
    const Scalar z521 = z517 * z519;
    const Scalar z522 = z517 * z520;
    const Scalar z523 = z509 * z518 - z514 * z521;
    const Scalar z524 = n1 + z158 * z480 - z486 * z481 + z502 * z499 + z514 * z512;
    const Scalar z525 = z509 * z511 + z514 * z522;
    const Scalar z526 = z494 * z498 + z502 * z522 + z503 * z525;
    const Scalar z527 = z517 * z524;
    const Scalar z528 = z509 * z512 + z514 * z527;
    const Scalar z529 = z472 * z489 + z486 * z522 + z488 * z525 + z487 * z526;
    const Scalar z530 = z494 * z499 + z502 * z527 + z503 * z528;
    const Scalar z531 = z157 * z448 - z480 * z522 - z467 * z525 - z466 * z526 + z465 * z529;
    const Scalar z532 = z472 * z481 + z486 * z527 + z488 * z528 + z487 * z530;
    const Scalar z533 = z478 * z522 + z457 * z525 + z442 * z526 - z430 * z529 + z429 * z531;
    const Scalar z534 = z458 * z522 + z453 * z525 + z431 * z526 - z428 * z529 + z420 * z531 - z407 * z533;
    const Scalar z535 = n25_over_3 * z159 - z533 - z427 * z529;
    const Scalar z536 = z425 * z529 - z417 * z531 + z401 * z533;
    const Scalar z537 = z133 * z458 - z478 * z482 - z480 * z483 - z486 * z490 + z502 * z500 + z514 * z513;
    const Scalar z538 = z517 * z537;
    const Scalar z539 = z158 * z448 - z480 * z527 - z467 * z528 - z466 * z530 + z465 * z532;
    const Scalar z540 = z509 * z513 + z514 * z538;
    const Scalar z541 = z478 * z527 + z457 * z528 + z442 * z530 - z430 * z532 + z429 * z539;
    const Scalar z542 = z494 * z500 + z502 * z538 + z503 * z540;
    const Scalar z543 = z472 * z490 + z486 * z538 + z488 * z540 + z487 * z542;
    const Scalar z544 = z458 * z527 + z453 * z528 + z431 * z530 - z428 * z532 + z420 * z539 - z407 * z541;
    const Scalar z545 = z448 * z483 + z480 * z538 + z467 * z540 + z466 * z542 - z465 * z543;
    const Scalar z546 = z413 * z482 + z478 * z538 + z457 * z540 + z442 * z542 - z430 * z543 - z429 * z545;
    const Scalar z547 = z79 * z467 - z488 * z485 + z503 * z501;
    const Scalar z548 = z494 * z516 - z502 * z521 + z503 * z523;
    const Scalar z549 = n25_over_3 * z166 - z541 - z427 * z532;
    const Scalar z550 = z425 * z532 - z417 * z539 + z401 * z541;
    const Scalar z551 = z79 * z480 - z486 * z485 + z502 * z501 + z514 * z547;
    const Scalar z552 = z472 * z510 - z486 * z521 + z488 * z523 + z487 * z548;
    const Scalar z553 = z517 * z551;
    const Scalar z554 = z448 * z508 - z480 * z521 + z467 * z523 + z466 * z548 - z465 * z552;
    const Scalar z555 = z509 * z547 + z514 * z553;
    const Scalar z556 = z413 * z506 - z478 * z521 + z457 * z523 + z442 * z548 - z430 * z552 - z429 * z554;
    const Scalar z557 = z494 * z501 + z502 * z553 + z503 * z555;
    const Scalar z558 = z472 * z485 + z486 * z553 + z488 * z555 + z487 * z557;
    const Scalar z559 = k34 * z185 - z458 * z521 + z453 * z523 + z431 * z548 - z428 * z552 - z420 * z554 - z407 * z556;
    const Scalar z560 = k34 * z133 + z458 * z538 + z453 * z540 + z431 * z542 - z428 * z543 - z420 * z545 - z407 * z546;
    const Scalar z561 = z427 * z543 + z546;
    const Scalar z562 = z425 * z543 + z417 * z545 + z401 * z546;
    const Scalar z563 = z79 * z448 - z480 * z553 - z467 * z555 - z466 * z557 + z465 * z558;
    const Scalar z564 = n25_over_7 * z201 + z425 * z552 + z417 * z554 + z401 * z556;
    const Scalar z565 = z478 * z553 + z457 * z555 + z442 * z557 - z430 * z558 + z429 * z563;
    const Scalar z566 = z152 + z180 * z407 - z200 * z401;
    const Scalar z567 = z458 * z553 + z453 * z555 + z431 * z557 - z428 * z558 + z420 * z563 - z407 * z565;
    const Scalar z568 = z151 + z180 * z420 - z200 * z417 - z429 * z566;
    const Scalar z569 = z427 * z558 + z565;
    const Scalar z570 = z147 + z180 * z428 - z200 * z425 - z430 * z566 - z465 * z568;
    const Scalar z571 = z425 * z558 - z417 * z563 + z401 * z565;
    const Scalar z572 = z180 * z431 - z442 * z566 - z466 * z568 - z487 * z570;
    const Scalar z573 = n1 - z180 * z453 + z457 * z566 + z467 * z568 + z488 * z570 - z503 * z572;
    const Scalar z574 = z180 * z458 - z478 * z566 - z480 * z568 - z486 * z570 + z502 * z572 - z514 * z573;
    const Scalar z575 = z517 * z574;
    const Scalar z576 = z523 + z147 * z552 + z151 * z554 + z152 * z556 - z180 * z559 - z200 * z564;
    const Scalar z577 = z509 * z573 - z514 * z575;
    const Scalar z578 = z494 * z572 + z502 * z575 - z503 * z577;
    const Scalar z579 = z153 * z552 - z521 + z155 * z554 + z156 * z556 - z185 * z559 - z201 * z564;
    const Scalar z580 = z472 * z570 + z486 * z575 - z488 * z577 + z487 * z578;
    const Scalar z581 = z448 * z568 + z480 * z575 - z467 * z577 + z466 * z578 - z465 * z580;
    const Scalar z582 = z413 * z566 + z478 * z575 - z457 * z577 + z442 * z578 - z430 * z580 - z429 * z581;
    const Scalar z583 = k34 * z180 + z458 * z575 - z453 * z577 + z431 * z578 - z428 * z580 - z420 * z581 - z407 * z582;
    const Scalar z584 = n25_over_7 * z200 + z425 * z580 + z417 * z581 + z401 * z582;
    const Scalar z585 = z147 * z580 - z577 + z151 * z581 + z152 * z582 - z180 * z583 - z200 * z584;
    const Scalar z586 = n1 / z585;
    const Scalar z587 = z522 + z153 * z529 - z155 * z531 + z156 * z533 - z185 * z534 - z201 * z536;
    const Scalar z588 = z525 + z147 * z529 - z151 * z531 + z152 * z533 - z180 * z534 - z200 * z536;
    const Scalar z589 = z525 + z136 * z529 - z157 * z531 + z159 * (z533 + z535);
    const Scalar z590 = z576 * z586;
    const Scalar z591 = z588 * z586;
    const Scalar z592 = z528 + z136 * z532 - z157 * z539 + z159 * (z541 + z549);
    const Scalar z593 = z579 - z576 * z590;
    const Scalar z594 = z587 - z588 * z590;
    const Scalar z595 = n1 / z593;
    const Scalar z596 = z589 + z588 * z591;
    const Scalar z597 = z527 + z153 * z532 - z155 * z539 + z156 * z541 - z185 * z544 - z201 * z550;
    const Scalar z598 = z528 + z147 * z532 - z151 * z539 + z152 * z541 - z180 * z544 - z200 * z550;
    const Scalar z599 = z592 + z598 * z591;
    const Scalar z600 = z597 - z598 * z590;
    const Scalar z601 = z527 + z137 * z532 - z158 * z539 + z166 * (z541 + z549);
    const Scalar z602 = z598 * z586;
    const Scalar z603 = z601 + z598 * z602;
    const Scalar z604 = z538 + z137 * z543 + z158 * z545 + z166 * (z546 - z561);
    const Scalar z605 = z540 + z136 * z543 + z157 * z545 + z159 * (z546 - z561);
    const Scalar z606 = z538 + z153 * z543 + z155 * z545 + z156 * z546 - z185 * z560 - z201 * z562;
    const Scalar z607 = z540 + z147 * z543 + z151 * z545 + z152 * z546 - z180 * z560 - z200 * z562;
    const Scalar z608 = z604 + z607 * z602;
    const Scalar z609 = z605 + z607 * z591;
    const Scalar z610 = z606 - z607 * z590;
    const Scalar z611 = z105 * z545 - z542 + z117 * z546 - z133 * z560;
    const Scalar z612 = z607 * z586;
    const Scalar z613 = z611 - z607 * z612;
    const Scalar z614 = z557 + z105 * z563 - z117 * z565 + z133 * z567;
    const Scalar z615 = z553 + z137 * z558 - z158 * z563 + z166 * (z565 - z569);
    const Scalar z616 = z555 + z136 * z558 - z157 * z563 + z159 * (z565 - z569);
    const Scalar z617 = z553 + z153 * z558 - z155 * z563 + z156 * z565 - z185 * z567 - z201 * z571;
    const Scalar z618 = z555 + z147 * z558 - z151 * z563 + z152 * z565 - z180 * z567 - z200 * z571;
    const Scalar z619 = z614 + z618 * z612;
    const Scalar z620 = z615 + z618 * z602;
    const Scalar z621 = z616 + z618 * z591;
    const Scalar z622 = z617 - z618 * z590;
    const Scalar z623 = z79 * z563 - z557;
    const Scalar z624 = z618 * z586;
    const Scalar z625 = z623 - z618 * z624;
    const Scalar z626 = z427 * z552 + z556;
    const Scalar z627 = z594 * z595;
    const Scalar z628 = z596 + z594 * z627;
    const Scalar z629 = z599 + z600 * z627;
    const Scalar z630 = z609 + z610 * z627;
    const Scalar z631 = z621 + z622 * z627;
    const Scalar z632 = n1 / z628;
    const Scalar z633 = z600 * z595;
    const Scalar z634 = z603 + z600 * z633;
    const Scalar z635 = z608 + z610 * z633;
    const Scalar z636 = z620 + z622 * z633;
    const Scalar z637 = z610 * z595;
    const Scalar z638 = z613 - z610 * z637;
    const Scalar z639 = z619 + z622 * z637;
    const Scalar z640 = z622 * z595;
    const Scalar z641 = z625 - z622 * z640;
    const Scalar z642 = z427 * z580 + z582;
    const Scalar z643 = z623 + z611 - z601 - z589 + z579 + z585;
    const Scalar z644 = z294 * z401 - z343 + z300 * z407 + z357;
    const Scalar z645 = z294 * z417 + z300 * z420 - z429 * z644 + z387;
    const Scalar z646 = z629 * z632;
    const Scalar z647 = z634 - z629 * z646;
    const Scalar z648 = z635 - z630 * z646;
    const Scalar z649 = z636 - z631 * z646;
    const Scalar z650 = z630 * z632;
    const Scalar z651 = z638 + z630 * z650;
    const Scalar z652 = z294 * z425 - z343 * z427 + z300 * z428 - z430 * z644 - z465 * z645 + z392;
    const Scalar z653 = n1 / z647;
    const Scalar z654 = z639 - z631 * z650;
    const Scalar z655 = z300 * z431 + z383 - z442 * z644 - z466 * z645 - z487 * z652;
    const Scalar z656 = z300 * z453 - z399 - z457 * z644 - z467 * z645 - z488 * z652 + z503 * z655;
    const Scalar z657 = z300 * z458 - z398 - z478 * z644 - z480 * z645 - z486 * z652 + z502 * z655 + z514 * z656;
    const Scalar z658 = z517 * z657;
    const Scalar z659 = z648 * z653;
    const Scalar z660 = z651 + z648 * z659;
    const Scalar z661 = z654 - z649 * z659;
    const Scalar z662 = z509 * z656 + z514 * z658;
    const Scalar z663 = z631 * z632;
    const Scalar z664 = z641 + z631 * z663;
    const Scalar z665 = n1 / z660;
    const Scalar z666 = z649 * z653;
    const Scalar z667 = z494 * z655 + z502 * z658 + z503 * z662;
    const Scalar z668 = z664 + z649 * z666;
    const Scalar z669 = z472 * z652 + z486 * z658 + z488 * z662 + z487 * z667;
    const Scalar z670 = z448 * z645 + z480 * z658 + z467 * z662 + z466 * z667 - z465 * z669;
    const Scalar z671 = z661 * z665;
    const Scalar z672 = z413 * z644 + z478 * z658 + z457 * z662 + z442 * z667 - z430 * z669 - z429 * z670;
    const Scalar z673 = k34 * z300 + z458 * z658 + z453 * z662 + z431 * z667 - z428 * z669 - z420 * z670 - z407 * z672;
    const Scalar z674 = n25_over_7 * z294 - z425 * z669 - z417 * z670 - z401 * z672;
    const Scalar z675 = z246 + z658 + z153 * z669 + z155 * z670 + z156 * z672 - z185 * z673 + z201 * z674;
    const Scalar z676 = z304 + z662 + z147 * z669 + z151 * z670 + z152 * z672 - z180 * z673 + z200 * z674;
    const Scalar z677 = z105 * z670 - z195 - z667 + z117 * z672 - z133 * z673;
    const Scalar z678 = z672 + n25_over_3 * z343 + z427 * z669;
    const Scalar z679 = z218 + z658 + z137 * z669 + z158 * z670 + z166 * (z672 - z678);
    const Scalar z680 = z227 + z662 + z136 * z669 + z157 * z670 + z159 * (z672 - z678);
    const Scalar z681 = z667 - z96 + z79 * z670;
    const Scalar z682 = z668 - z661 * z671;
    const Scalar z683 = z590 * z676 - z675;
    const Scalar z684 = z680 + z591 * z676 - z627 * z683;
    const Scalar z685 = n1 / z682;
    const Scalar z686 = z679 + z602 * z676 - z633 * z683 - z646 * z684;
    const Scalar z687 = z612 * z676 - z677 - z637 * z683 - z650 * z684 - z659 * z686;
    const Scalar z688 = z681 + z624 * z676 - z640 * z683 - z663 * z684 - z666 * z686 + z671 * z687;
    const Scalar z689 = z685 * z688;
    const Scalar z690 = z665 * z687 + z671 * z689;
    const Scalar z691 = z653 * z686 + z666 * z689 + z659 * z690;
    const Scalar z692 = z632 * z684 + z663 * z689 + z650 * z690 - z646 * z691;
    const Scalar z693 = z595 * z683 - z640 * z689 - z637 * z690 + z633 * z691 + z627 * z692;
    const Scalar z694 = z586 * z676 + z624 * z689 + z612 * z690 - z602 * z691 - z591 * z692 + z590 * z693;
    const Scalar z695 = z658 + z553 * z689 + z538 * z690 - z527 * z691 - z522 * z692 - z521 * z693 - z575 * z694;
    const Scalar z696 = z662 + z555 * z689 + z540 * z690 - z528 * z691 - z525 * z692 + z523 * z693 + z577 * z694;
    const Scalar z697 = z667 + z557 * z689 + z542 * z690 - z530 * z691 - z526 * z692 + z548 * z693 - z578 * z694;
    const Scalar z698 = z669 + z558 * z689 + z543 * z690 - z532 * z691 - z529 * z692 + z552 * z693 - z580 * z694;
    const Scalar z699 = z563 * z689 - z670 - z545 * z690 - z539 * z691 - z531 * z692 - z554 * z693 + z581 * z694;
    const Scalar z700 = z672 + z565 * z689 + z546 * z690 - z541 * z691 - z533 * z692 + z556 * z693 - z582 * z694;
    const Scalar z701 = z673 + z567 * z689 + z560 * z690 - z544 * z691 - z534 * z692 + z559 * z693 - z583 * z694;
    const Scalar z702 = z678 + z569 * z689 + z561 * z690 + z549 * z691 + z535 * z692 + z626 * z693 - z642 * z694;
    const Scalar z703 = z571 * z689 - z674 + z562 * z690 - z550 * z691 - z536 * z692 + z564 * z693 - z584 * z694;
    const Scalar roundings_ = traits::formula(4096.0, 8.0f, [&]() -> Scalar {
      return n4096;
    });
    accelerations.x = z695;
    accelerations.y = -z696;
    accelerations.z = z697;
    accelerations.yaw = z698;
    accelerations.roll = z699;
    accelerations.pitch = z700;
    accelerations.steer = -z701;
    accelerations.rear = -z702;
    accelerations.front = -z703;
    multipliers.lambda_rear_touches = -z689;
    multipliers.lambda_front_touches = -z690;
    multipliers.lambda_rear_rolls_x = -z691;
    multipliers.lambda_rear_rolls_y = -z692;
    multipliers.lambda_front_rolls_x = -z693;
    multipliers.lambda_front_rolls_y = z694;
    const Scalar bound0_ = roundings_ * z643;
    if (!(traits::regular(z515, n94) && traits::regular(z507, n94) && traits::regular(z491, n94)
        && traits::regular(-z468, z415) && traits::regular(-z446, z390) && traits::regular(-z408, z367)
        && traits::regular(-z682, -bound0_) && traits::regular(-z660, -bound0_) && traits::regular(z647, -bound0_)
        && traits::regular(z628, -bound0_) && traits::regular(-z593, -bound0_) && traits::regular(-z585,
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
    const Scalar z10 = v_yaw * s_yaw;
    const Scalar z11 = v_roll * c_roll;
    const Scalar z12 = z1 * z1 * (n1 - c_steer) + c_steer;
    const Scalar z13 = s_yaw * c_roll;
    const Scalar z14 = -z4 * (n1 - c_steer);
    const Scalar z15 = c_yaw * c_roll;
    const Scalar z16 = z2 * z2 * (n1 - c_steer) + c_steer;
    const Scalar z17 = s_yaw * s_roll;
    const Scalar z18 = c_yaw * s_roll;
    const Scalar z19 = s_roll * z13;
    const Scalar z20 = s_roll * z15;
    const Scalar z21 = v_steer * c_steer;
    const Scalar z22 = z13 * z13 + z15 * z15;
    const Scalar z23 = s_yaw * z8 - c_roll * z9;
    const Scalar z24 = c_yaw * z8 + c_roll * z10;
    const Scalar z25 = n2 * (z13 * z17 + z15 * z18);
    const Scalar z26 = v_roll * z11;
    const Scalar z27 = v_yaw * z10;
    const Scalar z28 = n2 * z8;
    const Scalar z29 = v_yaw * z9;
    const Scalar z30 = n0_08 * z6 - n0_35 * z7;
    const Scalar z31 = s_pitch * z7 - c_pitch * z6;
    const Scalar z32 = s_pitch * z6 + c_pitch * z7;
    const Scalar z33 = z2 * z21;
    const Scalar z34 = s_yaw * z26 + c_roll * z27 + z9 * z28;
    const Scalar z35 = c_yaw * z26 + c_roll * z29 - z10 * z28;
    const Scalar z36 = n0_08 * z12 - n0_35 * z14;
    const Scalar z37 = n0_08 * z14 - n0_35 * z16;
    const Scalar z38 = traits::sqrt(z22);
    const Scalar z39 = z1 * z21;
    const Scalar z40 = n2 * (z13 * z23 + z15 * z24);
    const Scalar z41 = s_roll * z32 - c_roll * c_steer;
    const Scalar z42 = s_roll * c_steer + c_roll * z32;
    const Scalar z43 = n0_3 + z37;
    const Scalar z44 = n1_1 - z36;
    const Scalar z45 = n2 * (z13 * z34 + z15 * z35 - z23 * z23 - z24 * z24);
    const Scalar z46 = s_pitch * z43 + c_pitch * z44;
    const Scalar z47 = s_pitch * z44 - c_pitch * z43;
    const Scalar z48 = c_yaw * z31 + s_yaw * z41;
    const Scalar z49 = s_yaw * z31 - c_yaw * z41;
    const Scalar z50 = z42 * z48;
    const Scalar z51 = z42 * z49;
    const Scalar z52 = z48 * z48 + z49 * z49;
    const Scalar z53 = s_roll * z47 - c_roll * z30;
    const Scalar z54 = s_roll * z30 + c_roll * z47;
    const Scalar z55 = n0_3 / z38;
    const Scalar z56 = n0_08 * z33 - n0_35 * z39;
    const Scalar z57 = q_z + n0_3 * z38;
    const Scalar z58 = n0_5 * z40 / z38;
    const Scalar z59 = n0_5 * z25 / z38;
    const Scalar z60 = q_z - z54;
    const Scalar z61 = traits::sqrt(z52);
    const Scalar z62 = s_yaw * z53 - c_yaw * z46;
    const Scalar z63 = s_yaw * z46 + c_yaw * z53;
    const Scalar z64 = q_y + z63;
    const Scalar z65 = q_x - z62;
    const Scalar z66 = q_x + z19 * z55;
    const Scalar z67 = v_pitch * c_pitch;
    const Scalar z68 = q_y - z20 * z55;
    const Scalar z69 = v_steer * s_steer;
    const Scalar z70 = q_z + z22 * z55;
    const Scalar z71 = v_pitch * s_pitch;
    const Scalar z72 = z4 * z69;
    const Scalar z73 = -z69 * (n1 - z3);
    const Scalar z74 = n0_35 * z72 + n0_08 * z73;
    const Scalar z75 = -z69 * (n1 - z5);
    const Scalar z76 = n0_08 * z72 + n0_35 * z75;
    const Scalar z77 = v_z - n0_3 * z58;
    const Scalar z78 = z6 * z67 - z7 * z71 + s_pitch * z33 + c_pitch * z39;
    const Scalar z79 = n0_3 * z59;
    const Scalar z80 = n0_5 * (z40 * z58 / (z38 * z38) + z45 / z38);
    const Scalar z81 = z60 + n0_35 * z61;
    const Scalar z82 = z6 * z71 + z7 * z67 + s_pitch * z39 - c_pitch * z33;
    const Scalar z83 = c_roll * z69 + c_steer * z8 + z11 * z32 + s_roll * z78;
    const Scalar z84 = z9 * z31 + z10 * z41 + s_yaw * z82 - c_yaw * z83;
    const Scalar z85 = z9 * z41 - z10 * z31 + c_yaw * z82 + s_yaw * z83;
    const Scalar z86 = n2 * (z49 * z84 + z48 * z85);
    const Scalar z87 = n0_3 * z80;
    const Scalar z88 = v_steer * z69;
    const Scalar z89 = z2 * z88;
    const Scalar z90 = s_pitch * z74 - c_pitch * z76 - z44 * z67 - z43 * z71;
    const Scalar z91 = z2 * c_steer;
    const Scalar z92 = n0_5 * z86 / z61;
    const Scalar z93 = z1 * c_steer;
    const Scalar z94 = n0_35 / z61;
    const Scalar z95 = z1 * z88;
    const Scalar z96 = s_pitch * z91 + c_pitch * z93;
    const Scalar z97 = s_roll * z31;
    const Scalar z98 = s_pitch * z93 - c_pitch * z91;
    const Scalar z99 = n0_08 * z91 - n0_35 * z93;
    const Scalar z100 = c_roll * s_steer + s_roll * z96;
    const Scalar z101 = z65 - z50 * z94;
    const Scalar z102 = z11 * z30 + s_roll * z56 - z8 * z47 - c_roll * z90;
    const Scalar z103 = v_z - z102;
    const Scalar z104 = z60 + z52 * z94;
    const Scalar z105 = s_yaw * z42;
    const Scalar z106 = s_yaw * z97 - c_yaw * z32;
    const Scalar z107 = s_yaw * z32 + c_yaw * z97;
    const Scalar z108 = n2 * (z48 * z106 - z49 * z107);
    const Scalar z109 = z103 + n0_35 * z92;
    const Scalar z110 = c_yaw * z98 + s_yaw * z100;
    const Scalar z111 = s_yaw * z98 - c_yaw * z100;
    const Scalar z112 = n2 * (z48 * z110 + z49 * z111);
    const Scalar z113 = z64 - z51 * z94;
    const Scalar z114 = v_steer * z21;
    const Scalar z115 = q_x - z66;
    const Scalar z116 = q_z - z70;
    const Scalar z117 = q_y - z68;
    const Scalar z118 = n0_5 * z108 / z61;
    const Scalar z119 = v_pitch * z71;
    const Scalar z120 = v_pitch * z67;
    const Scalar z121 = v_roll * z8;
    const Scalar z122 = z6 * z119 + z7 * z120 + s_pitch * z89 + c_pitch * z95 - n2 * (z33 * z67 - z39 * z71);
    const Scalar z123 = z7 * z119 - z6 * z120 + s_pitch * z95 - c_pitch * z89 - n2 * (z33 * z71 + z39 * z67);
    const Scalar z124 = n0_08 * z89 - n0_35 * z95;
    const Scalar z125 = n0_5 * z112 / z61;
    const Scalar z126 = z4 * z114;
    const Scalar z127 = -z114 * (n1 - z3);
    const Scalar z128 = n0_35 * z126 + n0_08 * z127;
    const Scalar z129 = c_yaw * z42;
    const Scalar z130 = n2 * (z48 * z105 - z49 * z129);
    const Scalar z131 = n0_3 * z58 / (z38 * z38);
    const Scalar z132 = z32 * z121 - c_roll * z114 - c_steer * z26 + n2 * (z8 * z69 - z11 * z78) + s_roll * z122;
    const Scalar z133 = -z114 * (n1 - z5);
    const Scalar z134 = n0_08 * z126 + n0_35 * z133;
    const Scalar z135 = n0_5 * z130 / z61;
    const Scalar z136 = z29 * z31 + z27 * z41 - n2 * (z9 * z83 - z10 * z82) + c_yaw * z123 + s_yaw * z132;
    const Scalar z137 = z27 * z31 - z29 * z41 - n2 * (z9 * z82 + z10 * z83) + s_yaw * z123 - c_yaw * z132;
    const Scalar z138 = s_pitch * z128 - z43 * z120 - c_pitch * z134 + z44 * z119 + n2 * (z67 * z74 + z71 * z76);
    const Scalar z139 = z30 * z121 + s_roll * z124 + z26 * z47 - n2 * (z11 * z56 + z8 * z90) + c_roll * z138;
    const Scalar z140 = n2 * (z48 * z136 + z49 * z137 - z85 * z85 - z84 * z84);
    const Scalar z141 = z53 + n0_35 * z135;
    const Scalar z142 = n0_5 * (z86 * z92 / (z61 * z61) + z140 / z61);
    const Scalar z143 = s_roll * z24 - z15 * z11;
    const Scalar z144 = v_y + z55 * z143 - z20 * z131;
    const Scalar z145 = s_steer * z4;
    const Scalar z146 = s_steer * (n1 - z3);
    const Scalar z147 = n0_08 * z146 - n0_35 * z145;
    const Scalar z148 = s_steer * (n1 - z5);
    const Scalar z149 = n0_08 * z145 - n0_35 * z148;
    const Scalar z150 = s_yaw * z116;
    const Scalar z151 = v_y - z144;
    const Scalar z152 = c_yaw * z116;
    const Scalar z153 = c_roll * z46;
    const Scalar z154 = z153 + n0_35 * z118;
    const Scalar z155 = v_z - z55 * z40 + z22 * z131;
    const Scalar z156 = c_pitch * z149 + s_pitch * z147;
    const Scalar z157 = z139 - n0_35 * z142;
    const Scalar z158 = v_z - z155;
    const Scalar z159 = q_x - z101;
    const Scalar z160 = q_z - z104;
    const Scalar z161 = q_y - z113;
    const Scalar z162 = s_roll * z99 + c_roll * z156;
    const Scalar z163 = s_pitch * z2 + c_pitch * z1;
    const Scalar z164 = s_pitch * z1 - c_pitch * z2;
    const Scalar z165 = z162 - n0_35 * z125;
    const Scalar z166 = c_roll * z56 - z8 * z30 - z11 * z47 + s_roll * z90;
    const Scalar z167 = s_pitch * z76 + c_pitch * z74 + z44 * z71 - z43 * z67;
    const Scalar z168 = s_roll * z69 - c_steer * z11 + z8 * z32 - c_roll * z78;
    const Scalar z169 = n0_35 * z92 / (z61 * z61);
    const Scalar z170 = z60 - z104;
    const Scalar z171 = z65 - z101;
    const Scalar z172 = z64 - z113;
    const Scalar z173 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z174 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z175 = s_roll * z173;
    const Scalar z176 = s_yaw * z167 - z9 * z46 + z10 * z53 + c_yaw * z166;
    const Scalar z177 = s_yaw * z175 - c_yaw * z174;
    const Scalar z178 = v_y - z176;
    const Scalar z179 = s_roll * z164;
    const Scalar z180 = z42 * z84 - z49 * z168;
    const Scalar z181 = c_roll * z173;
    const Scalar z182 = z178 - z94 * z180 + z51 * z169;
    const Scalar z183 = q_x - z177;
    const Scalar z184 = q_z - z181;
    const Scalar z185 = z101 - z183;
    const Scalar z186 = z104 - z184;
    const Scalar z187 = s_yaw * z174 + c_yaw * z175;
    const Scalar z188 = q_y + z187;
    const Scalar z189 = s_roll * z23 - z13 * z11;
    const Scalar z190 = v_x - z55 * z189 + z19 * z131;
    const Scalar z191 = z113 - z188;
    const Scalar z192 = c_roll * z164;
    const Scalar z193 = s_yaw * z160;
    const Scalar z194 = c_yaw * z160;
    const Scalar z195 = s_yaw * z179 - c_yaw * z163;
    const Scalar z196 = s_roll * z161 - z15 * z160;
    const Scalar z197 = s_roll * z159 + z13 * z160;
    const Scalar z198 = v_x - z190;
    const Scalar z199 = s_yaw * z163 + c_yaw * z179;
    const Scalar z200 = z9 * z116 + s_yaw * z158;
    const Scalar z201 = c_yaw * z158 - z10 * z116;
    const Scalar z202 = z192 * z191 + z199 * z186;
    const Scalar z203 = z192 * z185 - z195 * z186;
    const Scalar z204 = s_roll * z117 - z15 * z116;
    const Scalar z205 = v_x + v_yaw * z117 - v_roll * z150 + z204 * (v_pitch + v_rear);
    const Scalar z206 = z24 * z116 + z11 * z117 + s_roll * z151 - z15 * z158;
    const Scalar z207 = v_yaw * z151 - v_roll * z200 + z206 * (v_pitch + v_rear);
    const Scalar z208 = z11 * z115 - z23 * z116 + s_roll * z198 + z13 * z158;
    const Scalar z209 = v_yaw * z198 - v_roll * z201 + z208 * (v_pitch + v_rear);
    const Scalar z210 = s_roll * z115 + z13 * z116;
    const Scalar z211 = v_y - v_yaw * z115 + v_roll * z152 - z210 * (v_pitch + v_rear);
    const Scalar z212 = s_yaw * z166 - c_yaw * z167 - z9 * z53 - z10 * z46;
    const Scalar z213 = z52 * z169 - z103 - z94 * z86;
    const Scalar z214 = v_x + z212;
    const Scalar z215 = z178 - z182;
    const Scalar z216 = z103 + z213;
    const Scalar z217 = n0_3 * z67 - n1_1 * z71;
    const Scalar z218 = z42 * z215 - z84 * z170 - z172 * z168 - z49 * z216;
    const Scalar z219 = z42 * z172 - z49 * z170;
    const Scalar z220 = v_x + v_yaw * z161 - v_roll * z193 + v_pitch * z196 + v_steer * z202 + v_front * z219;
    const Scalar z221 = z1 * z71 - z2 * z67;
    const Scalar z222 = z42 * z85 - z48 * z168;
    const Scalar z223 = z214 - z94 * z222 + z50 * z169;
    const Scalar z224 = z1 * z67 + z2 * z71;
    const Scalar z225 = n1_1 * z67 + n0_3 * z71;
    const Scalar z226 = z11 * z173 + s_roll * z225;
    const Scalar z227 = c_roll * z225 - z8 * z173;
    const Scalar z228 = c_roll * z224 - z8 * z164;
    const Scalar z229 = z11 * z164 + s_roll * z224;
    const Scalar z230 = z214 - z223;
    const Scalar z231 = z42 * z230 - z85 * z170 - z171 * z168 - z48 * z216;
    const Scalar z232 = z42 * z171 - z48 * z170;
    const Scalar z233 = v_y - v_yaw * z159 + v_roll * z194 - v_pitch * z197 - v_steer * z203 - v_front * z232;
    const Scalar z234 = v_z - z227;
    const Scalar z235 = z213 + z234;
    const Scalar z236 = v_z + z213;
    const Scalar z237 = z10 * z174 - c_yaw * z217 + z9 * z175 + s_yaw * z226;
    const Scalar z238 = z9 * z174 + s_yaw * z217 - z10 * z175 + c_yaw * z226;
    const Scalar z239 = v_x - z237;
    const Scalar z240 = z223 - z239;
    const Scalar z241 = v_x - z223;
    const Scalar z242 = z11 * z159 - z23 * z160 + s_roll * z241 + z13 * z236;
    const Scalar z243 = v_y + z238;
    const Scalar z244 = z182 - z243;
    const Scalar z245 = v_y - z182;
    const Scalar z246 = z24 * z160 + z11 * z161 + s_roll * z245 - z15 * z236;
    const Scalar z247 = z10 * z163 + c_yaw * z221 + z9 * z179 + s_yaw * z229;
    const Scalar z248 = s_yaw * z221 - z9 * z163 + z10 * z179 - c_yaw * z229;
    const Scalar z249 = z185 * z228 - z186 * z247 + z192 * z240 + z195 * z235;
    const Scalar z250 = z9 * z160 + s_yaw * z236;
    const Scalar z251 = z191 * z228 - z186 * z248 + z192 * z244 - z199 * z235;
    const Scalar z252 = c_yaw * z236 - z10 * z160;
    const Scalar z253 = v_yaw * z241 + v_pitch * z242 + v_steer * z249 - v_roll * z252 + v_front * z231;
    const Scalar z254 = v_yaw * z245 - v_roll * z250 + v_pitch * z246 + v_steer * z251 + v_front * z218;
    result.value[0] = -z57;
    result.rate[0] = -z77;
    result.gamma[0] = z87;
    result.value[1] = -z81;
    result.rate[1] = -z109;
    result.gamma[1] = -z157;
    result.value[2] = n0;
    result.rate[2] = z205;
    result.gamma[2] = z207;
    result.value[3] = n0;
    result.rate[3] = -z211;
    result.gamma[3] = z209;
    result.value[4] = n0;
    result.rate[4] = z220;
    result.gamma[4] = z254;
    result.value[5] = n0;
    result.rate[5] = -z233;
    result.gamma[5] = z253;
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
    result.jacobian[20] = z117;
    result.jacobian[21] = z115;
    result.jacobian[22] = z161;
    result.jacobian[23] = z159;
    result.jacobian[24] = z79;
    result.jacobian[25] = -z141;
    result.jacobian[26] = -z150;
    result.jacobian[27] = -z152;
    result.jacobian[28] = -z193;
    result.jacobian[29] = -z194;
    result.jacobian[30] = n0;
    result.jacobian[31] = z154;
    result.jacobian[32] = z204;
    result.jacobian[33] = z210;
    result.jacobian[34] = z196;
    result.jacobian[35] = z197;
    result.jacobian[36] = n0;
    result.jacobian[37] = z165;
    result.jacobian[38] = n0;
    result.jacobian[39] = n0;
    result.jacobian[40] = z202;
    result.jacobian[41] = z203;
    result.jacobian[42] = n0;
    result.jacobian[43] = n0;
    result.jacobian[44] = z204;
    result.jacobian[45] = z210;
    result.jacobian[46] = n0;
    result.jacobian[47] = n0;
    result.jacobian[48] = n0;
    result.jacobian[49] = n0;
    result.jacobian[50] = n0;
    result.jacobian[51] = n0;
    result.jacobian[52] = z219;
    result.jacobian[53] = z232;
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
    const Scalar k14 = traits::constant(0.005950872541725462, 0.0059508723f,
        "11298900081976005488039590346701483956312571499395628412519783507493819739182003600879011813971315003255906388553830486116652719658788633777063662087724795679803439/1898696368095942639087092253868002940016956219669453150142723260368036152458294888778615521037238951749780791102237100178156974029401684305956122807236616706800625000");
    const Scalar k15 = traits::constant(0.02079463202853559, 0.020794632f,
        "9870673077118022362064038943628123859779194979891059919709477732499388673643976711565585013906694661093800952941105542740091657643756066142827550216880165139488051/474674092023985659771773063467000735004239054917363287535680815092009038114573722194653880259309737937445197775559275044539243507350421076489030701809154176700156250");
    const Scalar k16 = traits::constant(46.686007365934024, 46.68601f,
        "12866027926070442963751385859967080732345328859301894534751105534737425465833752936/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
    const Scalar k17 = traits::constant(40.23024469547104, 40.230244f,
        "1108690763953106891919173818010564632270624322560169545605282827304553786348861088751/27558638341514209428689503085101790712750335357997908571426594583037944883380320500");
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
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_6 = traits::constant(0.6, 0.6f, "3/5");
    const Scalar n1_over_94 = traits::constant(0.010638297872340425, 0.010638298f, "1/94");
    const Scalar k38 = traits::constant(6.497839117007668, 6.497839f,
        "3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000/584408549952007626866251632634629339223983214964697293769799486655623930450106539925724994593314357796562290858106469922091418177013307660380717446544429655409731579");
    const Scalar n25_over_7 = traits::constant(3.5714285714285716, 3.5714285f, "25/7");
    const Scalar n25_over_3 = traits::constant(8.333333333333334, 8.333333f, "25/3");
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
    const Scalar z17 = z10 * z10 * (n1 - c_steer) + c_steer;
    const Scalar z18 = -z13 * (n1 - c_steer);
    const Scalar z19 = z11 * z11 * (n1 - c_steer) + c_steer;
    const Scalar z20 = s_yaw * c_roll;
    const Scalar z21 = c_yaw * c_roll;
    const Scalar z22 = v_yaw * s_yaw;
    const Scalar z23 = v_yaw * c_yaw;
    const Scalar z24 = v_roll * s_roll;
    const Scalar z25 = v_roll * c_roll;
    const Scalar z26 = s_yaw * s_roll;
    const Scalar z27 = c_yaw * s_roll;
    const Scalar z28 = s_roll * z20;
    const Scalar z29 = s_roll * z21;
    const Scalar z30 = z20 * z20;
    const Scalar z31 = s_yaw * z24 - c_roll * z23;
    const Scalar z32 = c_yaw * z24 + c_roll * z22;
    const Scalar z33 = n2 * (z20 * z26 + z21 * z27);
    const Scalar z34 = v_roll * z25;
    const Scalar z35 = v_yaw * z22;
    const Scalar z36 = n2 * z23;
    const Scalar z37 = v_yaw * z23;
    const Scalar z38 = n2 * z22;
    const Scalar z39 = n0_08 * z15 - n0_35 * z16;
    const Scalar z40 = s_pitch * z16 - c_pitch * z15;
    const Scalar z41 = s_pitch * z15 + c_pitch * z16;
    const Scalar z42 = z21 * z21 + z30;
    const Scalar z43 = s_yaw * z34 + c_roll * z35 + z24 * z36;
    const Scalar z44 = c_yaw * z34 + c_roll * z37 - z24 * z38;
    const Scalar z45 = n0_08 * z17 - n0_35 * z18;
    const Scalar z46 = n0_08 * z18 - n0_35 * z19;
    const Scalar z47 = traits::sqrt(z42);
    const Scalar z48 = n2 * (z20 * z31 + z21 * z32);
    const Scalar z49 = s_roll * z39;
    const Scalar z50 = s_roll * z41;
    const Scalar z51 = s_roll * c_steer + c_roll * z41;
    const Scalar z52 = c_yaw * z40;
    const Scalar z53 = s_yaw * z40;
    const Scalar z54 = n0_3 + z46;
    const Scalar z55 = c_roll * c_steer - z50;
    const Scalar z56 = n1_1 - z45;
    const Scalar z57 = n2 * (z20 * z43 + z21 * z44 - z31 * z31 - z32 * z32);
    const Scalar z58 = s_pitch * z54 + c_pitch * z56;
    const Scalar z59 = s_pitch * z56 - c_pitch * z54;
    const Scalar z60 = s_yaw * z55 - z52;
    const Scalar z61 = c_yaw * z55 + z53;
    const Scalar z62 = z51 * z60;
    const Scalar z63 = z51 * z61;
    const Scalar z64 = z60 * z60;
    const Scalar z65 = s_roll * z59 - c_roll * z39;
    const Scalar z66 = c_roll * z59 + z49;
    const Scalar z67 = z61 * z61 + z64;
    const Scalar z68 = n0_3 / z47;
    const Scalar z69 = v_steer * c_steer;
    const Scalar z70 = n0_5 * z48 / z47;
    const Scalar z71 = n0_5 * z33 / z47;
    const Scalar z72 = q_z - z66;
    const Scalar z73 = traits::sqrt(z67);
    const Scalar z74 = s_yaw * z65 - c_yaw * z58;
    const Scalar z75 = s_yaw * z58 + c_yaw * z65;
    const Scalar z76 = q_y + z75;
    const Scalar z77 = q_x - z74;
    const Scalar z78 = q_x + z28 * z68;
    const Scalar z79 = z11 * z69;
    const Scalar z80 = q_y - z29 * z68;
    const Scalar z81 = z10 * z69;
    const Scalar z82 = q_z + z42 * z68;
    const Scalar z83 = v_pitch * s_pitch;
    const Scalar z84 = v_pitch * c_pitch;
    const Scalar z85 = v_steer * s_steer;
    const Scalar z86 = z13 * z85;
    const Scalar z87 = -z85 * (n1 - z12);
    const Scalar z88 = -z85 * (n1 - z14);
    const Scalar z89 = n0_08 * z79 - n0_35 * z81;
    const Scalar z90 = n0_35 * z86 + n0_08 * z87;
    const Scalar z91 = n0_08 * z86 + n0_35 * z88;
    const Scalar z92 = n0_3 * z71;
    const Scalar z93 = z15 * z83 + z16 * z84 + s_pitch * z81 - c_pitch * z79;
    const Scalar z94 = z15 * z84 - z16 * z83 + s_pitch * z79 + c_pitch * z81;
    const Scalar z95 = s_yaw * z51;
    const Scalar z96 = n0_35 / z73;
    const Scalar z97 = c_roll * z85 + c_steer * z24 + z25 * z41 + s_roll * z94;
    const Scalar z98 = c_yaw * z51;
    const Scalar z99 = c_yaw * z93 - z22 * z40 - z23 * z55 + s_yaw * z97;
    const Scalar z100 = z23 * z40 - z22 * z55 + s_yaw * z93 - c_yaw * z97;
    const Scalar z101 = n2 * (z60 * z95 + z61 * z98);
    const Scalar z102 = z72 + z67 * z96;
    const Scalar z103 = z76 - z63 * z96;
    const Scalar z104 = n2 * (z60 * z99 - z61 * z100);
    const Scalar z105 = z77 + z62 * z96;
    const Scalar z106 = s_pitch * z90 - c_pitch * z91 - z56 * z84 - z54 * z83;
    const Scalar z107 = z25 * z39 + s_roll * z89 - z24 * z59 - c_roll * z106;
    const Scalar z108 = n0_5 * z104 / z73;
    const Scalar z109 = v_z - z107;
    const Scalar z110 = n0_5 * (z48 * z70 / (z47 * z47) + z57 / z47);
    const Scalar z111 = n0_3 * z110;
    const Scalar z112 = q_x - z78;
    const Scalar z113 = q_z - z82;
    const Scalar z114 = q_y - z80;
    const Scalar z115 = z11 * c_steer;
    const Scalar z116 = z10 * c_steer;
    const Scalar z117 = s_roll * z40;
    const Scalar z118 = s_pitch * z115 + c_pitch * z116;
    const Scalar z119 = s_pitch * z116 - c_pitch * z115;
    const Scalar z120 = s_yaw * z117 - c_yaw * z41;
    const Scalar z121 = s_yaw * z41 + c_yaw * z117;
    const Scalar z122 = c_roll * s_steer + s_roll * z118;
    const Scalar z123 = n2 * (z60 * z120 + z61 * z121);
    const Scalar z124 = v_pitch * z83;
    const Scalar z125 = c_yaw * z119 + s_yaw * z122;
    const Scalar z126 = s_yaw * z119 - c_yaw * z122;
    const Scalar z127 = v_pitch * z84;
    const Scalar z128 = s_steer * z13;
    const Scalar z129 = n2 * (z60 * z125 - z61 * z126);
    const Scalar z130 = v_steer * z85;
    const Scalar z131 = s_steer * (n1 - z12);
    const Scalar z132 = n0_08 * z131 - n0_35 * z128;
    const Scalar z133 = n0_5 * z123 / z73;
    const Scalar z134 = s_steer * (n1 - z14);
    const Scalar z135 = n0_08 * z128 - n0_35 * z134;
    const Scalar z136 = z11 * z130;
    const Scalar z137 = z10 * z130;
    const Scalar z138 = v_steer * z69;
    const Scalar z139 = n0_5 * z129 / z73;
    const Scalar z140 = v_roll * z24;
    const Scalar z141 = n0_5 * z101 / z73;
    const Scalar z142 = c_pitch * z135 + s_pitch * z132;
    const Scalar z143 = n0_08 * z115 - n0_35 * z116;
    const Scalar z144 = z15 * z124 + z16 * z127 + s_pitch * z136 + c_pitch * z137 - n2 * (z79 * z84 - z81 * z83);
    const Scalar z145 = z16 * z124 - z15 * z127 + s_pitch * z137 - c_pitch * z136 - n2 * (z79 * z83 + z81 * z84);
    const Scalar z146 = n0_08 * z136 - n0_35 * z137;
    const Scalar z147 = c_roll * z58;
    const Scalar z148 = s_roll * z143 + c_roll * z142;
    const Scalar z149 = z147 - n0_35 * z133;
    const Scalar z150 = z41 * z140 - c_roll * z138 - c_steer * z34 + n2 * (z24 * z85 - z25 * z94) + s_roll * z144;
    const Scalar z151 = z37 * z40 - z35 * z55 - n2 * (z23 * z97 - z22 * z93) + c_yaw * z145 + s_yaw * z150;
    const Scalar z152 = z35 * z40 + z37 * z55 - n2 * (z23 * z93 + z22 * z97) + s_yaw * z145 - c_yaw * z150;
    const Scalar z153 = z65 - n0_35 * z141;
    const Scalar z154 = q_x - z105;
    const Scalar z155 = q_y - z103;
    const Scalar z156 = s_pitch * z11 + c_pitch * z10;
    const Scalar z157 = s_pitch * z10 - c_pitch * z11;
    const Scalar z158 = q_z - z102;
    const Scalar z159 = z13 * z138;
    const Scalar z160 = s_roll * z31 - z20 * z25;
    const Scalar z161 = s_yaw * z158;
    const Scalar z162 = -z138 * (n1 - z12);
    const Scalar z163 = n0_35 * z159 + n0_08 * z162;
    const Scalar z164 = z68 * z160;
    const Scalar z165 = s_roll * z154 + z20 * z158;
    const Scalar z166 = n2 * (z100 * z100 + z99 * z99 + z60 * z151 - z61 * z152);
    const Scalar z167 = s_roll * z112 + z20 * z113;
    const Scalar z168 = z148 + n0_35 * z139;
    const Scalar z169 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z170 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z171 = s_roll * z169;
    const Scalar z172 = c_roll * z169;
    const Scalar z173 = s_roll * z157;
    const Scalar z174 = s_yaw * z171 - c_yaw * z170;
    const Scalar z175 = c_roll * z157;
    const Scalar z176 = s_yaw * z156 + c_yaw * z173;
    const Scalar z177 = s_yaw * z173 - c_yaw * z156;
    const Scalar z178 = c_yaw * z158;
    const Scalar z179 = -z138 * (n1 - z14);
    const Scalar z180 = n0_08 * z159 + n0_35 * z179;
    const Scalar z181 = s_yaw * z170 + c_yaw * z171;
    const Scalar z182 = q_y + z181;
    const Scalar z183 = q_z - z172;
    const Scalar z184 = q_x - z174;
    const Scalar z185 = n0_3 * z70 / (z47 * z47);
    const Scalar z186 = s_roll * z155 - z21 * z158;
    const Scalar z187 = z104 * z108;
    const Scalar z188 = s_yaw * z113;
    const Scalar z189 = v_x - z164 + z28 * z185;
    const Scalar z190 = v_x - z189;
    const Scalar z191 = s_roll * z114 - z21 * z113;
    const Scalar z192 = s_roll * z32 - z21 * z25;
    const Scalar z193 = z68 * z192;
    const Scalar z194 = c_yaw * z113;
    const Scalar z195 = v_z - z68 * z48 + z42 * z185;
    const Scalar z196 = v_z - z195;
    const Scalar z197 = v_y + z193 - z29 * z185;
    const Scalar z198 = s_pitch * z163 - z54 * z127 - c_pitch * z180 + z56 * z124 + n2 * (z84 * z90 + z83 * z91);
    const Scalar z199 = z103 - z182;
    const Scalar z200 = z105 - z184;
    const Scalar z201 = v_y - z197;
    const Scalar z202 = c_yaw * z196 - z22 * z113;
    const Scalar z203 = z20 * z196;
    const Scalar z204 = z25 * z112 - z31 * z113 + s_roll * z190 + z203;
    const Scalar z205 = z23 * z113 + s_yaw * z196;
    const Scalar z206 = z21 * z196;
    const Scalar z207 = z39 * z140 + s_roll * z146 + z34 * z59 - n2 * (z25 * z89 + z24 * z106) + c_roll * z198;
    const Scalar z208 = z76 - z103;
    const Scalar z209 = z77 - z105;
    const Scalar z210 = z72 - z102;
    const Scalar z211 = z102 - z183;
    const Scalar z212 = z177 * z211;
    const Scalar z213 = z176 * z211;
    const Scalar z214 = n0_5 * (z187 / (z73 * z73) - z166 / z73);
    const Scalar z215 = z207 - n0_35 * z214;
    const Scalar z216 = z61 * z210;
    const Scalar z217 = z51 * z208 - z216;
    const Scalar z218 = s_roll * z85 - c_steer * z25 + z24 * z41 - c_roll * z94;
    const Scalar z219 = s_pitch * z91;
    const Scalar z220 = z60 * z210;
    const Scalar z221 = c_roll * z89;
    const Scalar z222 = z51 * z209 + z220;
    const Scalar z223 = z219 + c_pitch * z90 - z54 * z84 + z56 * z83;
    const Scalar z224 = z221 - z24 * z39 - z25 * z59 + s_roll * z106;
    const Scalar z225 = z51 * z100 - z61 * z218;
    const Scalar z226 = n0_35 * z108 / (z73 * z73);
    const Scalar z227 = z175 * z200 - z212;
    const Scalar z228 = z175 * z199 + z213;
    const Scalar z229 = s_yaw * z223 - z23 * z58 + z22 * z65 + c_yaw * z224;
    const Scalar z230 = z109 - z96 * z104 + z67 * z226;
    const Scalar z231 = v_z - z230;
    const Scalar z232 = z32 * z113 + z25 * z114 + s_roll * z201 - z206;
    const Scalar z233 = z32 * z158;
    const Scalar z234 = z23 * z158 + s_yaw * z231;
    const Scalar z235 = v_yaw * z190 + z204 * (v_pitch + v_rear) - v_roll * z202;
    const Scalar z236 = v_y - z229;
    const Scalar z237 = v_yaw * z201 - v_roll * z205 + z232 * (v_pitch + v_rear);
    const Scalar z238 = z109 - z230;
    const Scalar z239 = v_yaw * s_roll;
    const Scalar z240 = v_yaw * c_roll;
    const Scalar z241 = v_roll * z3 + z4 * z240;
    const Scalar z242 = v_roll * z4 - z3 * z240;
    const Scalar z243 = z10 * z83 - z11 * z84;
    const Scalar z244 = z10 * z84 + z11 * z83;
    const Scalar z245 = n0_3 * z84 - n1_1 * z83;
    const Scalar z246 = a_yaw * c_roll;
    const Scalar z247 = v_roll * z239 - z246;  // angular acceleration of frame.2, y
    const Scalar z248 = a_yaw * s_roll;
    const Scalar z249 = v_roll * z240 + z248;  // angular acceleration of frame.2, x
    const Scalar z250 = c_roll * z244 - z24 * z157;
    const Scalar z251 = n1_1 * z84 + n0_3 * z83;
    const Scalar z252 = s_yaw * z224 - c_yaw * z223 - z23 * z65 - z22 * z58;
    const Scalar z253 = z25 * z157 + s_roll * z244;
    const Scalar z254 = z25 * z169 + s_roll * z251;
    const Scalar z255 = v_x + z252;
    const Scalar z256 = z60 * z218 + z51 * z99;
    const Scalar z257 = a_roll * z4 + z3 * z247;
    const Scalar z258 = s_yaw * z243 - z23 * z156 + z22 * z173 - c_yaw * z253;
    const Scalar z259 = z96 * z225 - z236 + z63 * z226;
    const Scalar z260 = z236 + z259;
    const Scalar z261 = z23 * z170 + s_yaw * z245 - z22 * z171 + c_yaw * z254;
    const Scalar z262 = z22 * z170 - c_yaw * z245 + z23 * z171 + s_yaw * z254;
    const Scalar z263 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z264 = v_y + z261;
    const Scalar z265 = z259 + z264;
    const Scalar z266 = v_y + z259;
    const Scalar z267 = v_pitch * z241 - z257;  // angular acceleration of frame, x
    const Scalar z268 = v_pitch + z239;  // angular velocity of frame, z
    const Scalar z269 = z255 - z96 * z256 + z62 * z226;
    const Scalar z270 = z255 - z269;
    const Scalar z271 = v_x - z262;
    const Scalar z272 = z269 - z271;
    const Scalar z273 = v_x - z269;
    const Scalar z274 = a_roll * z3 - z4 * z247;
    const Scalar z275 = v_pitch * z242 + z274;  // angular acceleration of frame, y
    const Scalar z276 = c_roll * z251 - z24 * z169;
    const Scalar z277 = n9_81 - a_z;
    const Scalar z278 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z279 = v_z - z276;
    const Scalar z280 = s_roll * z263 - c_roll * z277;
    const Scalar z281 = z230 - z279;
    const Scalar z282 = z31 * z158;
    const Scalar z283 = z3 * z278 + z4 * z280;
    const Scalar z284 = z22 * z156 + c_yaw * z243 + z23 * z173 + s_yaw * z253;
    const Scalar z285 = z211 * z284;
    const Scalar z286 = z3 * z280 - z4 * z278;
    const Scalar z287 = s_roll * z277 + c_roll * z263;
    const Scalar z288 = z211 * z258;
    const Scalar z289 = z99 * z210;
    const Scalar z290 = c_yaw * z231 - z22 * z158;
    const Scalar z291 = z100 * z210;
    const Scalar z292 = z200 * z250 - z285 + z175 * z272 - z177 * z281;
    const Scalar z293 = z25 * z155 + z233 + s_roll * z266 - z21 * z231;
    const Scalar z294 = s_steer * z268 + c_steer * z242;
    const Scalar z295 = s_steer * z242 - c_steer * z268;
    const Scalar z296 = a_pitch + z249;  // angular acceleration of frame, z
    const Scalar z297 = a_rear + z296;  // angular acceleration of rear_wheel, z
    const Scalar z298 = c_steer * z296 + s_steer * z267;
    const Scalar z299 = z5 * z241 + z6 * z242;
    const Scalar z300 = v_rear + z268;  // angular velocity of rear_wheel, z
    const Scalar z301 = z5 * z242 - z6 * z241;
    const Scalar z302 = z242 * z241;
    const Scalar z303 = z241 * z241;
    const Scalar z304 = s_steer * z296 - c_steer * z267;
    const Scalar z305 = z296 - z302;
    const Scalar z306 = z268 * z268;
    const Scalar z307 = z242 * z268;
    const Scalar z308 = z303 + z306;
    const Scalar z309 = z275 + z307;
    const Scalar z310 = z25 * z154 - z282 + s_roll * z273 + z20 * z231;
    const Scalar z311 = z288 - z199 * z250 + z175 * z265 - z176 * z281;
    const Scalar z312 = z283 - k10 * z305;
    const Scalar z313 = z286 + k10 * z308;
    const Scalar z314 = z287 - k10 * z309;
    const Scalar z315 = z51 * z260 - z291 - z208 * z218 - z61 * z238;
    const Scalar z316 = s_steer * z313 - c_steer * z314;
    const Scalar z317 = s_steer * z314 + c_steer * z313;
    const Scalar z318 = z51 * z270 - z289 - z209 * z218 + z60 * z238;
    const Scalar z319 = v_yaw * z266 - v_roll * z234 + v_pitch * z293 - v_steer * z311 + v_front * z315;
    const Scalar z320 = v_steer * z294 - z298;  // angular acceleration of fork, y
    const Scalar z321 = v_steer * z295 - z304;  // angular acceleration of fork, x
    const Scalar z322 = v_steer + z241;  // angular velocity of fork, z
    const Scalar z323 = z7 * z322 + z8 * z294;
    const Scalar z324 = z7 * z294 - z8 * z322;
    const Scalar z325 = z295 * z295;
    const Scalar z326 = z322 * z322;
    const Scalar z327 = z294 * z322;
    const Scalar z328 = z294 * z294;
    const Scalar z329 = a_steer + z275;  // angular acceleration of fork, z
    const Scalar z330 = z325 + z326;
    const Scalar z331 = z325 + z328;
    const Scalar z332 = z294 * z295;
    const Scalar z333 = z320 + z327;
    const Scalar z334 = z295 * z322;
    const Scalar z335 = z329 - z332;
    const Scalar z336 = z321 - z334;
    const Scalar z337 = z320 - z327;
    const Scalar z338 = v_yaw * z273 - v_roll * z290 + v_pitch * z310 + v_steer * z292 + v_front * z318;
    const Scalar z339 = z326 - z328;
    const Scalar z340 = n0_12 * z297;  // moment on rear_wheel, z
    const Scalar z341 = k12 * z330;  // force on fork, x
    const Scalar z342 = k12 * z333;  // force on fork, z
    const Scalar z343 = a_front - z320;  // angular acceleration of front_wheel, z
    const Scalar z344 = n0_28 * z343;  // moment on front_wheel, z
    const Scalar z345 = v_front - z295;  // angular velocity of front_wheel, z
    const Scalar z346 = k14 * c_steer;
    const Scalar z347 = k12 * c_steer;
    const Scalar z348 = k12 * s_steer;
    const Scalar z349 = z299 * z300;
    const Scalar z350 = k15 * z327 + k14 * z339 + k12 * z312 - z344;  // moment on fork, y
    const Scalar z351 = n0_12 * z349;  // moment on rear_wheel, x
    const Scalar z352 = z301 * z300;
    const Scalar z353 = n0_12 * z352;  // moment on rear_wheel, y
    const Scalar z354 = z242 * z242;
    const Scalar z355 = z306 + z354;
    const Scalar z356 = z323 * z345;
    const Scalar z357 = n0_28 * z356;  // moment on front_wheel, x
    const Scalar z358 = k14 * s_steer;
    const Scalar z359 = z303 - z354;
    const Scalar z360 = z324 * z345;
    const Scalar z361 = k16 * z305 - z342 - k17 * z355;  // force on frame, y
    const Scalar z362 = n0_28 * z360;  // moment on front_wheel, y
    const Scalar z363 = z3 * z348;
    const Scalar z364 = k12 * z335;  // force on fork, y
    const Scalar z365 = n0_28 * s_steer;
    const Scalar z366 = n0_28 * c_steer;
    const Scalar z367 = z5 * z351 - z6 * z353;
    const Scalar z368 = z5 * z353 + z6 * z351;
    const Scalar z369 = z241 * z268;
    const Scalar z370 = k18 + k10 * z347;
    const Scalar z371 = z4 * z348;
    const Scalar z372 = s_steer * z341 - c_steer * z364;
    const Scalar z373 = z3 * z365;
    const Scalar z374 = z7 * z357 - z8 * z362;
    const Scalar z375 = z8 * z357 + z7 * z362;
    const Scalar z376 = k18 * z334 + k19 * z321 + k14 * z335 + z374;  // moment on fork, x
    const Scalar z377 = k18 * z329 + k19 * z332 + k14 * z336 + k12 * z316 + z375;  // moment on fork, z
    const Scalar z378 = k20 * s_steer;
    const Scalar z379 = k20 * c_steer;
    const Scalar z380 = k19 + c_steer * z379;
    const Scalar z381 = s_roll * z363 - c_roll * z347;
    const Scalar z382 = s_steer * z364 + c_steer * z341;
    const Scalar z383 = k19 + s_steer * z378;
    const Scalar z384 = s_steer * z379;
    const Scalar z385 = z3 * z346 + z4 * z370;
    const Scalar z386 = s_yaw * z381 - c_yaw * z371;
    const Scalar z387 = z267 + z369;
    const Scalar z388 = k16 * z287 - z368 - k21 * z307 + k22 * z387 + k10 * z372 - z377;  // moment on frame, y
    const Scalar z389 = s_roll * z366 + c_roll * z373;
    const Scalar z390 = c_steer * z350;
    const Scalar z391 = z296 + z302;
    const Scalar z392 = k16 * z308 + z382 + k17 * z391;  // force on frame, x
    const Scalar z393 = s_roll * z358 - c_roll * z385;
    const Scalar z394 = k16 * z309 - z372 - k17 * z387;  // force on frame, z
    const Scalar z395 = z3 * z370 - z4 * z346;
    const Scalar z396 = s_roll * z347 + c_roll * z363;
    const Scalar z397 = s_yaw * z371 + c_yaw * z381;
    const Scalar z398 = v_roll * z239;
    const Scalar z399 = s_steer * z376 + z390;
    // moment on frame, z
    const Scalar z400 = z340 + k23 * z296 - k24 * z302 + k22 * z359 - k16 * z283 + k17 * z286 - k10 * z342 - z399;
    const Scalar z401 = s_steer * z350;
    const Scalar z402 = k10 * z348 + z384;
    const Scalar z403 = c_steer * z376 - z401;
    const Scalar z404 = k24 - z383;
    const Scalar z405 = k25 * z347 + z380;
    const Scalar z406 = k23 + z405;
    const Scalar z407 = z367 + k17 * z287 + k23 * z369 - k24 * z267 - k22 * z309 + z403;  // moment on frame, x
    const Scalar z408 = n0_12 + z406;
    const Scalar z409 = k22 - z346;
    const Scalar z410 = k18 + k25 * z347;
    const Scalar z411 = n2 * z409;
    const Scalar z412 = z410 + z404;
    const Scalar z413 = k16 + z347;
    const Scalar z414 = z3 * z402 - z4 * z358;
    const Scalar z415 = z3 * z411 - z4 * z412;
    const Scalar z416 = k17 * z4 + z3 * z413;
    const Scalar z417 = k17 * z3 - z4 * z413;
    const Scalar z418 = s_roll * z417;
    const Scalar z419 = n0_12 * s_roll;
    const Scalar z420 = z3 * z358 + z4 * z402;
    const Scalar z421 = z4 * z415;
    const Scalar z422 = c_roll * z417;
    const Scalar z423 = s_yaw * z418 - c_yaw * z416;
    const Scalar z424 = z404 + z421;
    const Scalar z425 = s_yaw * z416 + c_yaw * z418;
    const Scalar z426 = s_roll * z408 + c_roll * z414;
    const Scalar z427 = z4 * z365;
    const Scalar z428 = z3 * z392 - z4 * z361;
    const Scalar z429 = z410 + z421;
    const Scalar z430 = z3 * z407 - z4 * z388;
    const Scalar z431 = k26 * (z247 + z398) - z430;  // moment on frame.2, y
    const Scalar z432 = s_roll * z428 - c_roll * z394;
    const Scalar z433 = z3 * z361 + z4 * z392;
    const Scalar z434 = k26 - z424;
    const Scalar z435 = z3 * z415 - z409;
    const Scalar z436 = k26 + z429;
    const Scalar z437 = s_yaw * z432 - c_yaw * z433;
    const Scalar z438 = s_yaw * z433 + c_yaw * z432;
    const Scalar z439 = z239 * z240;
    const Scalar z440 = c_roll * z348 + s_roll * z416;
    const Scalar z441 = s_roll * z348 - c_roll * z416;
    const Scalar z442 = s_roll * z420 + c_roll * z435;
    const Scalar z443 = s_roll * z394 + c_roll * z428;
    const Scalar z444 = n94 * z277 - z443;  // force on frame.z, z
    const Scalar z445 = z408 - z434;
    const Scalar z446 = s_yaw * z441;
    const Scalar z447 = c_yaw * z441;
    const Scalar z448 = n94 * a_x + z437;  // force on frame.z, x
    const Scalar z449 = n2 * z414;
    const Scalar z450 = n94 * a_y - z438;  // force on frame.z, y
    const Scalar z451 = c_roll * z449 + s_roll * z445;
    const Scalar z452 = z303 + z354;
    const Scalar z453 = n2 * z323;
    const Scalar z454 = n2 * z324;
    const Scalar z455 = n0_14 * z453;
    const Scalar z456 = n0_14 * z454;
    const Scalar z457 = n2 * z268;
    const Scalar z458 = n2 * z301;
    const Scalar z459 = n2 * z299;
    const Scalar z460 = z275 - z307;
    const Scalar z461 = s_roll * z451;
    const Scalar z462 = n2 * z294;
    const Scalar z463 = n2 * z345;
    const Scalar z464 = n0_14 * z463;
    const Scalar z465 = z8 * z455 + z7 * z456;
    const Scalar z466 = z7 * z455 - z8 * z456;
    const Scalar z467 = z434 + z461;
    const Scalar z468 = n2 * z295;
    const Scalar z469 = n2 * z322;
    const Scalar z470 = n0_1435 * z462 - z465;
    const Scalar z471 = k30 * z468 - z464;
    const Scalar z472 = k30 * z468 + z464;
    const Scalar z473 = k14 * z468;
    const Scalar z474 = n0_1435 * z469 - z466;
    const Scalar z475 = k14 * z462 - z466 - k30 * z469;
    const Scalar z476 = k12 * z469;
    const Scalar z477 = k14 * z469 - z465 + k30 * z462;
    const Scalar z478 = k10 * z457;
    const Scalar z479 = s_steer * z470 - c_steer * z471;
    const Scalar z480 = z474 + z475;
    const Scalar z481 = s_steer * z473 + c_steer * z480;
    const Scalar z482 = n2 * z242;
    const Scalar z483 = c_steer * z476;
    const Scalar z484 = k12 * z468;
    const Scalar z485 = n2 * z300;
    const Scalar z486 = n0_06 * z485;
    const Scalar z487 = n2 * z241;
    const Scalar z488 = s_steer * z476;
    const Scalar z489 = s_steer * z477 - c_steer * z472;
    const Scalar z490 = s_steer * z481;
    const Scalar z491 = z479 + z347 * z478 - k10 * z484;
    const Scalar z492 = s_yaw * z417 - c_yaw * z440;
    const Scalar z493 = n0_06 * z459;
    const Scalar z494 = c_yaw * z417 + s_yaw * z440;
    const Scalar z495 = n0_06 * z458;
    const Scalar z496 = k10 * z487;
    const Scalar z497 = z473 - z490;
    const Scalar z498 = k10 * z488 + z497;
    const Scalar z499 = z348 * z496 - z490;
    const Scalar z500 = c_steer * z481 - z474;
    const Scalar z501 = c_steer * z481 - z475;
    const Scalar z502 = z347 * z496 - z500 + k10 * z483;
    const Scalar z503 = z267 - z369;
    const Scalar z504 = s_steer * z471 + c_steer * z470;
    const Scalar z505 = z348 * z478 - z504;
    const Scalar z506 = v_roll * z240;
    const Scalar z507 = z249 - z506;
    const Scalar z508 = s_steer * z472 + c_steer * z477;
    const Scalar z509 = z239 * z239;
    const Scalar z510 = z240 * z240;
    const Scalar z511 = z509 + z510;
    const Scalar z512 = z247 - z398;
    const Scalar z513 = z489 - z486;
    const Scalar z514 = z491 + z486;
    const Scalar z515 = z5 * z495 + z6 * z493;
    const Scalar z516 = z5 * z493 - z6 * z495;
    const Scalar z517 = z501 - z516;
    const Scalar z518 = z505 + z515;
    const Scalar z519 = n2 * z240;
    const Scalar z520 = n2 * z239;
    const Scalar z521 = z508 - z515;
    const Scalar z522 = z502 + z516;
    const Scalar z523 = n2 * v_roll;
    const Scalar z524 = k32 * z457 - z513;
    const Scalar z525 = k33 * z457 + z514;
    const Scalar z526 = k33 * z482 + z518;
    const Scalar z527 = k33 * z487 - z517;
    const Scalar z528 = k32 * z482 - z521 + k22 * z487;
    const Scalar z529 = z522 + k22 * z482 + k33 * z487;
    const Scalar z530 = z278 * z441;
    const Scalar z531 = k17 * z457 + z488;
    const Scalar z532 = z483 + k17 * z482 + k16 * z487;
    const Scalar z533 = k16 * z457 - z484;
    const Scalar z534 = k22 * z457;
    const Scalar z535 = z498 + z534;
    const Scalar z536 = z473 + z534;
    const Scalar z537 = z4 * z531 + z3 * z533;
    const Scalar z538 = z524 - z525;
    const Scalar z539 = z535 + z536;
    const Scalar z540 = z240 * z537 + z394 - z348 * z511 - z417 * z512;
    const Scalar z541 = z3 * z538 - z4 * z539;
    const Scalar z542 = z417 * z507 - z416 * z511 + z239 * z537 - z428;
    const Scalar z543 = z287 * z417;
    const Scalar z544 = z3 * z531 - z4 * z533;
    const Scalar z545 = z242 * z532 + z361 - z348 * z503 - k17 * z452;
    const Scalar z546 = z348 * z460 - z413 * z452 + z241 * z532 - z392;
    const Scalar z547 = z263 * z416 + z278 * z418;
    const Scalar z548 = z4 * z541;
    const Scalar z549 = z417 * z519 + z532;
    const Scalar z550 = z4 * z526 + z3 * z527;
    const Scalar z551 = k26 * z523 - z550;
    const Scalar z552 = z413 * z503 + k17 * z460 + z242 * z531 + z241 * z533;
    const Scalar z553 = z3 * z526 - z4 * z527;
    const Scalar z554 = k26 * z519 + z553;
    const Scalar z555 = z535 + z548;
    const Scalar z556 = z536 + z548;
    const Scalar z557 = z417 * z520 - z544;
    const Scalar z558 = z348 * z520 - z416 * z519;
    const Scalar z559 = z4 * z528 + z3 * z529;
    const Scalar z560 = z283 * z348;
    const Scalar z561 = z499 + z555;
    const Scalar z562 = z348 * z507 + z416 * z512 + z239 * z532 + z240 * z544;
    const Scalar z563 = s_roll * z544 - c_roll * z532;
    const Scalar z564 = s_roll * z549 - c_roll * z557;
    const Scalar z565 = c_roll * z549 + s_roll * z557;
    const Scalar z566 = z499 + z536;
    const Scalar z567 = z409 * z503 - z402 * z452 - z404 * z460 + z286 * z348 + z388 + z242 * z524 + z241 * z566;
    const Scalar z568 = z3 * z541 - z524;
    const Scalar z569 = z3 * z541 + z525;
    const Scalar z570 = z535 - z536;
    const Scalar z571 = z499 - z535;
    const Scalar z572 = z569 + z414 * z519 - z434 * z520;
    const Scalar z573 = z436 * z511 - z287 * z348 - z280 * z416 - z420 * z512 - z435 * z507 - z240 * z554 + z239 * z568;
    const Scalar z574 = s_roll * z554 + c_roll * z568;
    const Scalar z575 = z559 - z551;
    const Scalar z576 = s_roll * z561 - c_roll * z575;
    const Scalar z577 = s_roll * z540 - c_roll * z542;
    const Scalar z578 = s_roll * z542 + c_roll * z540;
    const Scalar z579 = s_roll * z576;
    const Scalar z580 = z3 * z528 - z4 * z529;
    const Scalar z581 = z560 + z358 * z452 - z410 * z503 - z409 * z460 + z407 - z241 * z525 + z242 * z571;
    const Scalar z582 = z404 * z487 - z527 + z409 * z482;
    const Scalar z583 = z526 + z410 * z482 - z409 * z487;
    const Scalar z584 = k17 * z283 - z408 * z452 + z358 * z503 + z402 * z460 + z286 * z413 + z242 * z528 + z241 * z529;
    const Scalar z585 = z348 * z482 + z533;
    const Scalar z586 = z348 * z487 - z531;
    const Scalar z587 = z413 * z482 - k17 * z487;
    const Scalar z588 = z570 + z358 * z482 - z402 * z487;
    const Scalar z589 = z499 - z579;
    const Scalar z590 = z580 + z408 * z519 - z414 * z520;
    const Scalar z591 = z556 + z589;
    const Scalar z592 = c_roll * z572 + s_roll * z590;
    const Scalar z593 = z3 * z585 - z4 * z586;
    const Scalar z594 = z3 * z545 - z4 * z546;
    const Scalar z595 = z3 * z546 + z4 * z545;
    const Scalar z596 = c_roll * z552 + s_roll * z594;
    const Scalar z597 = s_roll * z552 - c_roll * z594;
    const Scalar z598 = s_yaw * z558 - c_yaw * z564;
    const Scalar z599 = c_yaw * z558 + s_yaw * z564;
    const Scalar z600 = s_yaw * z537 + c_yaw * z563;
    const Scalar z601 = s_yaw * z563 - c_yaw * z537;
    const Scalar z602 = z3 * z586 + z4 * z585;
    const Scalar z603 = c_yaw * z562 + s_yaw * z577;
    const Scalar z604 = s_yaw * z562 - c_yaw * z577;
    const Scalar z605 = s_yaw * z596 - c_yaw * z595;
    const Scalar z606 = s_yaw * z595 + c_yaw * z596;
    const Scalar z607 = z499 + z556;
    const Scalar z608 = z280 * z417 - z400 + z414 * z512 - z435 * z511 + z434 * z507 + z240 * z551 + z239 * z607;
    const Scalar z609 = z555 - z556;
    const Scalar z610 = z499 - z555;
    const Scalar z611 = z408 * z512 - z543 - z420 * z511 + z414 * z507 - z431 + z239 * z559 + z240 * z609;
    const Scalar z612 = z408 * z512 - z543 - z420 * z511 + z414 * z507 + z240 * z570 + z239 * z559;
    const Scalar z613 = s_roll * z570 - c_roll * z559;
    const Scalar z614 = c_roll * z608 + s_roll * z611;
    const Scalar z615 = z420 * z519 - z610 - z435 * z520;
    const Scalar z616 = z278 * z417 + z263 * z440;
    const Scalar z617 = z263 * z371 + z278 * z381;
    const Scalar z618 = k14 * z337 - k18 * z331 + k12 * z317 + z295 * z471 + z294 * z470;
    const Scalar z619 = z295 * z473 - z350 - k14 * z331 + k19 * z337 + z294 * z474;
    const Scalar z620 = z348 * z496 - z473;
    const Scalar z621 = z295 * z484 - z341 - k12 * z331;
    const Scalar z622 = z294 * z484 + z364;
    const Scalar z623 = z347 * z478 + z479;
    const Scalar z624 = k19 * z468 + z472;
    const Scalar z625 = z560 + z358 * z452 + z346 * z460 - z370 * z503 + z242 * z620 - z241 * z623;
    const Scalar z626 = z505 + z346 * z487 + z370 * z482;
    const Scalar z627 = z295 * z476 + k12 * z336;
    const Scalar z628 = c_steer * z622 + s_steer * z621;
    const Scalar z629 = s_steer * z622 - c_steer * z621;
    const Scalar z630 = k12 * z462;
    const Scalar z631 = n0_28 * z336;
    const Scalar z632 = z376 - z631 + z295 * z475;
    const Scalar z633 = z3 * z628 - z4 * z627;
    const Scalar z634 = z3 * z627 + z4 * z628;
    const Scalar z635 = s_roll * z593 - c_roll * z587;
    const Scalar z636 = s_roll * z587 + c_roll * z593;
    const Scalar z637 = z3 * z620 + z4 * z623;
    const Scalar z638 = z3 * z623 - z4 * z620;
    const Scalar z639 = z358 * z512 + z287 * z363 - z385 * z507 + z280 * z347 - z395 * z511 + z240 * z505 + z239 * z638;
    const Scalar z640 = z358 * z519 - z637 + z385 * z520;
    const Scalar z641 = s_roll * z505 - c_roll * z638;
    const Scalar z642 = c_roll * z629 + s_roll * z633;
    const Scalar z643 = s_roll * z629 - c_roll * z633;
    const Scalar z644 = z618 - k10 * z629;
    const Scalar z645 = s_yaw * z635 - c_yaw * z602;
    const Scalar z646 = s_yaw * z602 + c_yaw * z635;
    const Scalar z647 = s_yaw * z642 - c_yaw * z634;
    const Scalar z648 = s_yaw * z634 + c_yaw * z642;
    const Scalar z649 = z3 * z515 - z4 * z516;
    const Scalar z650 = z3 * z516 + z4 * z515;
    const Scalar z651 = s_steer * z632 - c_steer * z619;
    const Scalar z652 = c_steer * z632 + s_steer * z619;
    const Scalar z653 = k10 * z627 - z652;
    const Scalar z654 = z3 * z567 + z4 * z581;
    const Scalar z655 = z3 * z581 - z4 * z567;
    const Scalar z656 = n0_28 * z462 + z477;
    const Scalar z657 = c_roll * z654 + s_roll * z584;
    const Scalar z658 = z4 * z630 + z3 * z483;
    const Scalar z659 = z3 * z630 - z4 * z483;
    const Scalar z660 = c_roll * z488 + s_roll * z658;
    const Scalar z661 = s_roll * z488 - c_roll * z658;
    const Scalar z662 = k10 * z488;
    const Scalar z663 = c_yaw * z659 + s_yaw * z660;
    const Scalar z664 = s_yaw * z659 - c_yaw * z660;
    const Scalar z665 = s_steer * z624 + c_steer * z656;
    const Scalar z666 = s_steer * z656 - c_steer * z624;
    const Scalar z667 = k10 * z630 + z665;
    const Scalar z668 = z3 * z582 - z4 * z583;
    const Scalar z669 = z295 * z466 + z631;
    const Scalar z670 = z3 * z583 + z4 * z582;
    const Scalar z671 = n0_28 * z462 - z465;
    const Scalar z672 = s_roll * z588 + c_roll * z668;
    const Scalar z673 = c_steer * z466;
    const Scalar z674 = z365 * z460 - z366 * z452 + z242 * z465 + z241 * z673;
    const Scalar z675 = s_steer * z466;
    const Scalar z676 = z365 * z487 - z675;
    const Scalar z677 = z3 * z465 - z4 * z673;
    const Scalar z678 = z4 * z465 + z3 * z673;
    const Scalar z679 = z366 * z512 - z427 * z511 + z373 * z507 + z240 * z675 + z239 * z678;
    const Scalar z680 = n0_12 * z512 + z239 * z650;
    const Scalar z681 = z677 + z366 * z519 - z373 * z520;
    const Scalar z682 = c_roll * z650;
    const Scalar z683 = n0_12 * z519 + z649;
    const Scalar z684 = s_roll * z675 - c_roll * z678;
    const Scalar z685 = z75 - z63 * z96;
    const Scalar z686 = z74 - z62 * z96;
    const Scalar z687 = z174 - z686;
    const Scalar z688 = s_roll * z685 + z21 * z158;
    const Scalar z689 = z29 * z68;
    const Scalar z690 = s_roll * z686 + z20 * z158;
    const Scalar z691 = z28 * z68;
    const Scalar z692 = s_roll * z689 - z21 * z113;
    const Scalar z693 = s_roll * z691 - z20 * z113;
    const Scalar z694 = l_lambda_rear_rolls_x * z194 - l_lambda_rear_rolls_y * z188 + l_lambda_front_rolls_x * z178
        - l_lambda_front_rolls_y * z161;
    const Scalar z695 = z530 + z694;
    const Scalar z696 = l_lambda_rear_rolls_x * z693;
    const Scalar z697 = z4 * z662 + z3 * z666;
    const Scalar z698 = z3 * z662 - z4 * z666;
    const Scalar z699 = s_roll * z667 + c_roll * z697;
    const Scalar z700 = z3 * z651 - z4 * z644;
    const Scalar z701 = z3 * z644 + z4 * z651;
    const Scalar z702 = z181 - z685;
    const Scalar z703 = z175 * z702 - z213;
    const Scalar z704 = z175 * z687 - z212;
    const Scalar z705 = s_roll * z653 - c_roll * z700;
    const Scalar z706 = z75 - z685;
    const Scalar z707 = z74 - z686;
    const Scalar z708 = z51 * z706 - z216;
    const Scalar z709 = z51 * z707 - z220;
    const Scalar z710 = n2 * (z21 * z21 + z30 - z26 * z26 - z27 * z27);
    const Scalar z711 = n0_5 * (z33 * z71 / (z47 * z47) + z710 / z47);
    const Scalar z712 = s_yaw * z55;
    const Scalar z713 = c_yaw * z55;
    const Scalar z714 = n2 * (z60 * z712 + z61 * z713 - z95 * z95 - z98 * z98);
    const Scalar z715 = c_yaw * z66;
    const Scalar z716 = z55 * z61 - z51 * z98;
    const Scalar z717 = s_yaw * z66;
    const Scalar z718 = z55 * z60 - z51 * z95;
    const Scalar z719 = n0_35 * z141 / (z73 * z73);
    const Scalar z720 = z92 / (z47 * z47);
    const Scalar z721 = z96 * z716 - z715 + z63 * z719;
    const Scalar z722 = s_roll * z26 - c_roll * z20;
    const Scalar z723 = z96 * z718 - z717 + z62 * z719;
    const Scalar z724 = n0_3 * z711;
    const Scalar z725 = z28 * z720 - z68 * z722;
    const Scalar z726 = n0_5 * (z101 * z141 / (z73 * z73) + z714 / z73);
    const Scalar z727 = z42 * z720 - z68 * z33;
    const Scalar z728 = s_roll * z27 - c_roll * z21;
    const Scalar z729 = z29 * z720 - z68 * z728;
    const Scalar z730 = l_lambda_rear_rolls_x * z191;
    const Scalar z731 = l_lambda_rear_rolls_y * z692 + z696;
    const Scalar z732 = l_lambda_front_rolls_x * z690 - z696 - l_lambda_rear_rolls_y * z692 + l_lambda_front_rolls_y
        * z688;
    const Scalar z733 = z547 - z732;
    const Scalar z734 = l_lambda_front_rolls_x * z709 + l_lambda_front_rolls_y * z708;
    const Scalar z735 = l_lambda_rear_rolls_x * z729 - l_lambda_rear_rolls_y * z725 + l_lambda_front_rolls_x * z721
        - l_lambda_front_rolls_y * z723;
    const Scalar z736 = l_lambda_rear_rolls_x * z691 + l_lambda_rear_rolls_y * z689 - l_lambda_front_rolls_x * z686
        - l_lambda_front_rolls_y * z685;
    const Scalar z737 = z616 + z736;
    const Scalar z738 = z66 - n0_35 * z726;
    const Scalar z739 = l_lambda_front_rolls_x * z704 + l_lambda_front_rolls_y * z703;
    const Scalar z740 = z617 - z739;
    const Scalar z741 = l_lambda_rear_touches + l_lambda_front_touches;
    const Scalar z742 = z614 + z735;
    const Scalar z743 = l_lambda_rear_rolls_x * z188 - l_lambda_rear_touches * z92 + l_lambda_rear_rolls_y * z194
        + l_lambda_front_touches * z153 + l_lambda_front_rolls_x * z161 + l_lambda_front_rolls_y * z178;
    const Scalar z744 = l_lambda_rear_rolls_y * z167 + z730 + l_lambda_front_touches * z149 + l_lambda_front_rolls_x
        * z186 + l_lambda_front_rolls_y * z165;
    const Scalar z745 = l_lambda_rear_rolls_y * z167 + z730;
    const Scalar z746 = l_lambda_front_touches * z168 + l_lambda_front_rolls_x * z228 + l_lambda_front_rolls_y * z227;
    const Scalar z747 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x;
    const Scalar z748 = s_yaw * z727;
    const Scalar z749 = l_lambda_rear_rolls_x * z114 + l_lambda_rear_rolls_y * z112 + l_lambda_front_rolls_x * z155
        + l_lambda_front_rolls_y * z154;
    const Scalar z750 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y;
    const Scalar z751 = c_roll * z40;
    const Scalar z752 = s_roll * z58;
    const Scalar z753 = z65 - z96 * z101 + z67 * z719;
    const Scalar z754 = s_yaw * z753;
    const Scalar z755 = c_yaw * z753;
    const Scalar z756 = c_yaw * z727;
    const Scalar z757 = l_lambda_front_rolls_x * z217 + l_lambda_front_rolls_y * z222;
    const Scalar z758 = z171 - z753;
    const Scalar z759 = z715 + z721;
    const Scalar z760 = z717 + z723;
    const Scalar z761 = z65 - z753;
    const Scalar z762 = s_yaw * z751;
    const Scalar z763 = s_roll * z142 - c_roll * z143;
    const Scalar z764 = s_roll * s_steer - c_roll * z118;
    const Scalar z765 = c_yaw * z751;
    const Scalar z766 = n2 * (z60 * z762 + z61 * z765 - z95 * z120 - z98 * z121);
    const Scalar z767 = n0_35 * z133 / (z73 * z73);
    const Scalar z768 = s_yaw * z59 - c_yaw * z752;
    const Scalar z769 = s_yaw * z752 + c_yaw * z59;
    const Scalar z770 = z51 * z120 - z60 * z751;
    const Scalar z771 = z51 * z121 - z61 * z751;
    const Scalar z772 = s_yaw * z764;
    const Scalar z773 = c_yaw * z175;
    const Scalar z774 = c_yaw * z172;
    const Scalar z775 = z721 + z774;
    const Scalar z776 = s_yaw * z175;
    const Scalar z777 = z63 * z767 - z768 - z96 * z771;
    const Scalar z778 = z147 - z96 * z123 + z67 * z767;
    const Scalar z779 = c_yaw * z764;
    const Scalar z780 = n2 * (z95 * z125 - z98 * z126 + z60 * z772 + z61 * z779);
    const Scalar z781 = s_yaw * z172;
    const Scalar z782 = z723 + z781;
    const Scalar z783 = z769 - z96 * z770 + z62 * z767;
    const Scalar z784 = s_yaw * z778;
    const Scalar z785 = c_yaw * z778;
    const Scalar z786 = c_roll * z155 + z27 * z158 + s_roll * z721 + z21 * z753;
    const Scalar z787 = z26 * z158 - c_roll * z154 + s_roll * z723 + z20 * z753;
    const Scalar z788 = z173 * z199 - z211 * z773 + z175 * z775 + z176 * z758;
    const Scalar z789 = z26 * z113 - c_roll * z112 + s_roll * z725 + z20 * z727;
    const Scalar z790 = z173 * z200 + z211 * z776 - z175 * z782 - z177 * z758;
    const Scalar z791 = z55 * z208 + z98 * z210 + z51 * z759 - z61 * z761;
    const Scalar z792 = z55 * z209 - z95 * z210 - z51 * z760 + z60 * z761;
    const Scalar z793 = c_roll * z114 + z27 * z113 + s_roll * z729 + z21 * z727;
    const Scalar z794 = n0_5 * (z101 * z133 / (z73 * z73) + z766 / z73);
    const Scalar z795 = n0_5 * (z141 * z123 / (z73 * z73) + z766 / z73);
    const Scalar z796 = z752 + n0_35 * z794;
    const Scalar z797 = z752 + n0_35 * z795;
    const Scalar z798 = c_roll * z59;
    const Scalar z799 = n0_5 * (z141 * z129 / (z73 * z73) - z780 / z73);
    const Scalar z800 = z763 - n0_35 * z799;
    const Scalar z801 = l_lambda_rear_rolls_x * z793;
    const Scalar z802 = l_lambda_front_rolls_x * z791 + l_lambda_front_rolls_y * z792;
    const Scalar z803 = z679 + z802;
    const Scalar z804 = l_lambda_rear_rolls_y * z789 - z801;
    const Scalar z805 = z801 - l_lambda_rear_rolls_y * z789 - l_lambda_front_touches * z797 + l_lambda_front_rolls_x
        * z786 - l_lambda_front_rolls_y * z787;
    const Scalar z806 = z680 - z804;
    const Scalar z807 = l_lambda_front_rolls_x * z777 - l_lambda_front_rolls_y * z783;
    const Scalar z808 = z657 + z807;
    const Scalar z809 = l_lambda_rear_touches * z724 + l_lambda_rear_rolls_x * z748 + l_lambda_rear_rolls_y * z756
        + l_lambda_front_rolls_x * z754 + l_lambda_front_rolls_y * z755 - l_lambda_front_touches * z738;
    const Scalar z810 = z573 + z809;
    const Scalar z811 = s_yaw * z50 + z52;
    const Scalar z812 = c_yaw * z50 - z53;
    const Scalar z813 = n2 * (z121 * z121 + z120 * z120 + z60 * z811 + z61 * z812);
    const Scalar z814 = z612 + z805;
    const Scalar z815 = s_pitch * z135 - c_pitch * z132;
    const Scalar z816 = s_roll * z119;
    const Scalar z817 = s_roll * z156;
    const Scalar z818 = c_roll * z156;
    const Scalar z819 = s_roll * z170;
    const Scalar z820 = c_yaw * z157 + s_yaw * z817;
    const Scalar z821 = s_yaw * z157 - c_yaw * z817;
    const Scalar z822 = n0_5 * (z123 * z133 / (z73 * z73) - z813 / z73);
    const Scalar z823 = s_yaw * z816 - c_yaw * z118;
    const Scalar z824 = s_yaw * z118 + c_yaw * z816;
    const Scalar z825 = n2 * (z121 * z126 - z120 * z125 + z60 * z823 + z61 * z824);
    const Scalar z826 = c_roll * z170;
    const Scalar z827 = z778 - z826;
    const Scalar z828 = c_yaw * z169 + s_yaw * z819;
    const Scalar z829 = z783 - z828;
    const Scalar z830 = s_yaw * z169 - c_yaw * z819;
    const Scalar z831 = z777 + z830;
    const Scalar z832 = z21 * z778 + s_roll * z777;
    const Scalar z833 = s_roll * z783 + z20 * z778;
    const Scalar z834 = z798 - n0_35 * z822;
    const Scalar z835 = z199 * z818 - z211 * z821 - z176 * z827 + z175 * z831;
    const Scalar z836 = z211 * z820 - z200 * z818 + z175 * z829 - z177 * z827;
    const Scalar z837 = c_roll * z815;
    const Scalar z838 = n0_5 * (z133 * z129 / (z73 * z73) + z825 / z73);
    const Scalar z839 = l_lambda_front_touches * z834 - l_lambda_front_rolls_y * z833 + l_lambda_front_rolls_x * z832;
    const Scalar z840 = l_lambda_front_touches * z800 + l_lambda_front_rolls_x * z788 + l_lambda_front_rolls_y * z790;
    const Scalar z841 = z584 + z839;
    const Scalar z842 = z639 + z840;
    const Scalar z843 = z147 - z778;
    const Scalar z844 = z769 - z783;
    const Scalar z845 = z768 + z777;
    const Scalar z846 = n0_5 * (z101 * z139 / (z73 * z73) - z780 / z73);
    const Scalar z847 = n0_5 * (z123 * z139 / (z73 * z73) + z825 / z73);
    const Scalar z848 = z763 - n0_35 * z846;
    const Scalar z849 = z837 + n0_35 * z847;
    const Scalar z850 = z837 + n0_35 * z838;
    const Scalar z851 = n0_35 * z139 / (z73 * z73);
    const Scalar z852 = s_yaw * z815 - c_yaw * z763;
    const Scalar z853 = z51 * z126 - z61 * z764;
    const Scalar z854 = c_yaw * z815 + s_yaw * z763;
    const Scalar z855 = z51 * z125 + z60 * z764;
    const Scalar z856 = z67 * z851 - z148 - z96 * z129;
    const Scalar z857 = z852 + z96 * z853 + z63 * z851;
    const Scalar z858 = s_yaw * z856;
    const Scalar z859 = z62 * z851 - z854 - z96 * z855;
    const Scalar z860 = c_yaw * z856;
    const Scalar z861 = z121 * z210 + z208 * z751 - z61 * z843 + z51 * z845;
    const Scalar z862 = z209 * z751 - z120 * z210 + z51 * z844 + z60 * z843;
    const Scalar z863 = l_lambda_front_rolls_x * z861 + l_lambda_front_rolls_y * z862;
    const Scalar z864 = l_lambda_front_rolls_x * z857 - l_lambda_front_rolls_y * z859;
    const Scalar z865 = z705 - z864;
    const Scalar z866 = l_lambda_front_rolls_x * z784 + l_lambda_front_rolls_y * z785 + l_lambda_front_touches * z796;
    const Scalar z867 = z674 + z863;
    const Scalar z868 = z655 + z866;
    const Scalar z869 = z852 - z857;
    const Scalar z870 = z854 + z859;
    const Scalar z871 = z148 + z856;
    const Scalar z872 = n2 * (z61 * z61 + z64 - z125 * z125 - z126 * z126);
    const Scalar z873 = n0_5 * (z129 * z139 / (z73 * z73) + z872 / z73);
    const Scalar z874 = z294 * z345;
    const Scalar z875 = z322 * z345;
    const Scalar z876 = z242 * z300;
    const Scalar z877 = z241 * z300;
    const Scalar z878 = n0_28 * z874;  // moment on front_wheel, y
    const Scalar z879 = n0_28 * z875;  // moment on front_wheel, x
    const Scalar z880 = n0_12 * z877;  // moment on rear_wheel, x
    const Scalar z881 = z878 + k18 * z329 + k19 * z332 + k14 * z336 + k12 * z316;  // moment on fork, z
    const Scalar z882 = s_roll * z857 + z21 * z856;
    const Scalar z883 = s_roll * z859 + z20 * z856;
    const Scalar z884 = z175 * z857 - z176 * z856;
    const Scalar z885 = z175 * z859 - z177 * z856;
    const Scalar z886 = z126 * z210 + z208 * z764 + z51 * z869 - z61 * z871;
    const Scalar z887 = c_steer * z13;
    const Scalar z888 = z125 * z210 + z209 * z764 + z51 * z870 + z60 * z871;
    const Scalar z889 = c_steer * (n1 - z12);
    const Scalar z890 = n0_08 * z889 - n0_35 * z887;
    const Scalar z891 = c_steer * (n1 - z14);
    const Scalar z892 = n0_08 * z887 - n0_35 * z891;
    const Scalar z893 = l_lambda_front_rolls_x * z886 + l_lambda_front_rolls_y * z888;
    const Scalar z894 = z669 + z893;
    const Scalar z895 = l_lambda_front_rolls_x * z882 - l_lambda_front_rolls_y * z883 - l_lambda_front_touches * z849;
    const Scalar z896 = c_pitch * z892 + s_pitch * z890;
    const Scalar z897 = z653 - z895;
    const Scalar z898 = l_lambda_front_rolls_x * z835 - l_lambda_front_rolls_y * z836 - l_lambda_front_touches * z850;
    const Scalar z899 = z625 - z898;
    const Scalar z900 = z879 + k18 * z334 + k19 * z321 + k14 * z335;  // moment on fork, x
    const Scalar z901 = c_roll * z896 - z49;
    const Scalar z902 = z901 + n0_35 * z873;
    const Scalar z903 = z444 - z741;
    const Scalar z904 = z448 - z747;
    const Scalar z905 = z450 + z750;
    const Scalar z906 = z344 - z757;
    const Scalar z907 = n0_12 * z876;  // moment on rear_wheel, y
    const Scalar z908 = k16 * z287 - z907 - k21 * z307 + k22 * z387 + k10 * z372 - z881;  // moment on frame, y
    const Scalar z909 = z746 - z881;
    const Scalar z910 = a_z - a_roll * z92 - z111;
    const Scalar z911 = a_z + a_roll * z153 - a_pitch * z149 - a_steer * z168 + z215;
    const Scalar z912 = c_steer * z900 - z401;
    const Scalar z913 = z880 + k17 * z287 + k23 * z369 - k24 * z267 - k22 * z309 + z912;  // moment on frame, x
    const Scalar z914 = s_steer * z900 + z390;
    // moment on frame, z
    const Scalar z915 = z340 + k23 * z296 - k24 * z302 + k22 * z359 - k16 * z283 + k17 * z286 - k10 * z342 - z914;
    const Scalar z916 = z340 - z745;
    const Scalar z917 = z744 - z915;
    const Scalar z918 = l_lambda_front_rolls_x * z858 + l_lambda_front_rolls_y * z860 - l_lambda_front_touches * z848;
    const Scalar z919 = z701 - z918;
    const Scalar z920 = z29 * z185 - z193;
    const Scalar z921 = z25 * z689 + z32 * z113 + s_roll * z920 - z206;
    const Scalar z922 = a_y - z167 * (a_pitch + a_rear) - a_yaw * z112 + a_roll * z194 - z235;
    const Scalar z923 = a_x + a_yaw * z155 - a_roll * z161 + a_pitch * z186 + a_steer * z228 + a_front * z217 + z319;
    const Scalar z924 = a_y - a_yaw * z154 + a_roll * z178 - a_pitch * z165 - a_steer * z227 - a_front * z222 - z338;
    const Scalar z925 = z191 * (a_pitch + a_rear) + a_x + a_yaw * z114 - a_roll * z188 + z237;
    const Scalar z926 = v_yaw * z686;
    const Scalar z927 = v_yaw * z689;
    const Scalar z928 = v_roll * z188 - z927 - z692 * (v_pitch + v_rear);
    const Scalar z929 = v_roll * z188 - z927 - z692 * (v_pitch + v_rear) + z190;
    const Scalar z930 = v_roll * z178 - z926 - v_pitch * z690 - v_steer * z704 + v_front * z709;
    const Scalar z931 = v_roll * z178 - z926 - v_pitch * z690 - v_steer * z704 + v_front * z709 - z266;
    const Scalar z932 = z252 - z96 * z256 + z62 * z226;
    const Scalar z933 = z282 - z25 * z686 + s_roll * z932 - z20 * z231;
    const Scalar z934 = z262 + z932;
    const Scalar z935 = z250 * z687 - z285 + z175 * z934 - z177 * z281;
    const Scalar z936 = z252 - z932;
    const Scalar z937 = z218 * z707 - z289 + z51 * z936 + z60 * z238;
    const Scalar z938 = l_lambda_front_rolls_x * z884 - l_lambda_front_rolls_y * z885 - l_lambda_front_touches * z902;
    const Scalar z939 = v_yaw * z920 - v_roll * z205 + z921 * (v_pitch + v_rear);
    const Scalar z940 = v_yaw * z932 + v_pitch * z933 + v_roll * z290 - v_steer * z935 - v_front * z937;
    const Scalar z941 = z618 + z938;
    const Scalar z942 = z692 * (a_pitch + a_rear) + a_yaw * z689 - a_roll * z188 + z939;
    const Scalar z943 = a_yaw * z686 - a_roll * z178 + a_pitch * z690 + a_steer * z704 - a_front * z709 - z940;
    const Scalar z944 = z28 * z185 - z164;
    const Scalar z945 = z25 * z691 + z31 * z113 + s_roll * z944 - z203;
    const Scalar z946 = s_yaw * z25 + s_roll * z23;
    const Scalar z947 = z31 * z26;
    const Scalar z948 = c_yaw * z25 - s_roll * z22;
    const Scalar z949 = n2 * (z20 * z946 - z947 + z21 * z948 - z32 * z27);
    const Scalar z950 = v_yaw * z944 + z945 * (v_pitch + v_rear) + v_roll * z202;
    const Scalar z951 = v_yaw * z685;
    const Scalar z952 = v_yaw * z691;
    const Scalar z953 = z951 + v_roll * z161 + v_pitch * z688 + v_steer * z703 - v_front * z708;
    const Scalar z954 = z693 * (a_pitch + a_rear) + a_yaw * z691 + a_roll * z194 + z950;
    const Scalar z955 = z951 + v_roll * z161 + v_pitch * z688 + v_steer * z703 - v_front * z708 + z273;
    const Scalar z956 = z952 + v_roll * z194 + z693 * (v_pitch + v_rear);
    const Scalar z957 = z952 + v_roll * z194 + z693 * (v_pitch + v_rear) - z201;
    const Scalar z958 = z229 + z96 * z225 + z63 * z226;
    const Scalar z959 = z261 + z958;
    const Scalar z960 = z233 - z25 * z685 + s_roll * z958 - z21 * z231;
    const Scalar z961 = z250 * z702 + z288 + z175 * z959 - z176 * z281;
    const Scalar z962 = z229 - z958;
    const Scalar z963 = z218 * z706 + z291 + z51 * z962 + z61 * z238;
    const Scalar z964 = z3 * z908 + z4 * z913;
    const Scalar z965 = k26 * (a_roll + z439) - z964;  // moment on frame.2, z
    const Scalar z966 = z3 * z913 - z4 * z908;
    const Scalar z967 = k26 * (z247 + z398) - z966;  // moment on frame.2, y
    const Scalar z968 = v_yaw * z958 - v_roll * z234 + v_pitch * z960 - v_steer * z961 - v_front * z963;
    const Scalar z969 = a_yaw * z685 + a_roll * z161 + a_pitch * z688 + a_steer * z703 - a_front * z708 - z968;
    const Scalar z970 = z743 + z965;
    const Scalar z971 = s_roll * z915 - c_roll * z967;
    const Scalar z972 = z749 - z971;
    const Scalar z973 = z59 * z140 - z34 * z39 - c_roll * z146 - n2 * (z24 * z89 - z25 * z106) + s_roll * z198;
    const Scalar z974 = z22 * z51 + c_yaw * z218;
    const Scalar z975 = z100 * z98;
    const Scalar z976 = s_yaw * z218 - z23 * z51;
    const Scalar z977 = z48 * z71;
    const Scalar z978 = n2 * z25;
    const Scalar z979 = n2 * (z61 * z974 - z975 + z60 * z976 + z99 * z95);
    const Scalar z980 = z104 * z141;
    const Scalar z981 = s_roll * z138 + c_steer * z140 + z34 * z41 + n2 * (z25 * z85 + z24 * z94) + c_roll * z144;
    const Scalar z982 = n0_7 * z108;
    const Scalar z983 = n2 * z24;
    const Scalar z984 = n2 * (s_roll * z106 + z221) - z39 * z983 - z59 * z978;
    const Scalar z985 = z35 * z51 + z36 * z218 + s_yaw * z981;
    const Scalar z986 = z37 * z51 - z38 * z218 + c_yaw * z981;
    const Scalar z987 = n2 * (z60 * z985 + z61 * z986 - z95 * z151 + z98 * z152) - n4 * (z99 * z976 - z100 * z974);
    const Scalar z988 = n0_5 * (z977 / (z47 * z47) + z949 / z47);
    const Scalar z989 = s_yaw * z140 + s_roll * z35 - z25 * z36;
    const Scalar z990 = n0_3 * z988;
    const Scalar z991 = c_yaw * z140 + s_roll * z37 + z25 * z38;
    const Scalar z992 = n4 * (z31 * z946 + z32 * z948) + n2 * (z20 * z989 + z21 * z991 + z26 * z43 + z27 * z44);
    const Scalar z993 = v_yaw * z721;
    const Scalar z994 = v_roll * z754 + z993 - z234 + v_pitch * z786 - v_steer * z788 + v_front * z791;
    const Scalar z995 = v_roll * z754 + z993 + v_pitch * z786 - v_steer * z788 + v_front * z791;
    const Scalar z996 = n0_5 * (z980 / (z73 * z73) - z979 / z73);
    const Scalar z997 = n0_5 * (z70 * z949 / (z47 * z47) - z992 / z47 + z71 * z57 / (z47 * z47) + z48 * z988 / (z47
        * z47)) + z70 * z977 / (z47 * z47 * z47);
    const Scalar z998 = n0_6 * z70 * z71 / (z47 * z47 * z47) + z990 / (z47 * z47);
    const Scalar z999 = n0_5 * (z104 * z996 / (z73 * z73) - z108 * z979 / (z73 * z73) - z141 * z166 / (z73 * z73) - z987
        / z73) + z141 * z187 / (z73 * z73 * z73);
    const Scalar z1000 = z141 * z982 / (z73 * z73 * z73) + n0_35 * z996 / (z73 * z73);
    const Scalar z1001 = z224 + n0_35 * z996;
    const Scalar z1002 = z96 * z979 - z224 - z104 * z719 - z101 * z226 + z67 * z1000;
    const Scalar z1003 = z973 + n0_35 * z999;
    const Scalar z1004 = a_roll * z738 + a_pitch * z797 + a_steer * z800 - z1003;
    const Scalar z1005 = z254 - z1002;
    const Scalar z1006 = z224 + z1002;
    const Scalar z1007 = n0_3 * z997;
    const Scalar z1008 = a_roll * z724 + z1007;
    const Scalar z1009 = z41 * z983 - c_steer * z978 + n2 * (s_roll * z85 - c_roll * z94);
    const Scalar z1010 = s_yaw * z1009 - z36 * z51;
    const Scalar z1011 = z38 * z51 + c_yaw * z1009;
    const Scalar z1012 = c_yaw * z978 - s_roll * z38;
    const Scalar z1013 = v_yaw * z725;
    const Scalar z1014 = v_roll * z756 - z1013 - z202 - z789 * (v_pitch + v_rear);
    const Scalar z1015 = n2 * (z61 * z1011 + z60 * z1010) + n4 * (z99 * z95 - z975);
    const Scalar z1016 = v_roll * z756 - z1013 - z789 * (v_pitch + v_rear);
    const Scalar z1017 = c_yaw * z250 - z22 * z175;
    const Scalar z1018 = n2 * s_roll * z23 + s_yaw * z978;
    const Scalar z1019 = n2 * (z20 * z1018 + z21 * z1012) - n4 * (z32 * z27 + z947);
    const Scalar z1020 = z42 * z998 - z68 * z949 - z48 * z720 - z33 * z185;
    const Scalar z1021 = n0_5 * (z108 * z101 / (z73 * z73) + z980 / (z73 * z73) - z1015 / z73);
    const Scalar z1022 = z98 * z218 - z61 * z97 + z51 * z974 + z55 * z100;
    const Scalar z1023 = n0_5 * (z70 * z33 / (z47 * z47) + z977 / (z47 * z47) + z1019 / z47);
    const Scalar z1024 = z984 + n0_35 * z1021;
    const Scalar z1025 = c_yaw * z107 - z22 * z66;
    const Scalar z1026 = z96 * z1022 - z1025 + z225 * z719 + z226 * z716 + z63 * z1000;
    const Scalar z1027 = z20 * z24 + z26 * z25 + s_roll * z946 + c_roll * z31;
    const Scalar z1028 = z28 * z998 - z68 * z1027 - z185 * z722 - z160 * z720;
    const Scalar z1029 = n0_3 * z1023;
    const Scalar z1030 = z23 * z66 + s_yaw * z107;
    const Scalar z1031 = z22 * z41;
    const Scalar z1032 = z25 * z40 + s_roll * z93;
    const Scalar z1033 = z23 * z117 + z1031 - c_yaw * z94 + s_yaw * z1032;
    const Scalar z1034 = z158 * z948 - z24 * z155 - z32 * z753 + z25 * z721 + c_roll * z266 + z27 * z231 + s_roll
        * z1026 + z21 * z1002;
    const Scalar z1035 = z1025 + z1026;
    const Scalar z1036 = z55 * z260 - z97 * z208 - z210 * z974 - z100 * z761 + z98 * z238 - z218 * z759 + z51 * z1035
        + z61 * z1006;
    const Scalar z1037 = z24 * z112 + z113 * z946 - c_roll * z190 - z31 * z727 + z26 * z196 + z25 * z725 + s_roll
        * z1028 + z20 * z1020;
    const Scalar z1038 = z23 * z41 - z22 * z117 + s_yaw * z94 + c_yaw * z1032;
    const Scalar z1039 = n2 * (z60 * z1033 + z61 * z1038 - z99 * z120 + z100 * z121);
    const Scalar z1040 = z104 * z133;
    const Scalar z1041 = n2 * z83;
    const Scalar z1042 = n2 * z84;
    const Scalar z1043 = z56 * z1041 - z54 * z1042 + n2 * (c_pitch * z90 + z219);
    const Scalar z1044 = v_yaw * z723;
    const Scalar z1045 = v_roll * z755 - z1044 - v_pitch * z787 - z290 - v_steer * z790 + v_front * z792;
    const Scalar z1046 = v_roll * z755 - z1044 - v_pitch * z787 - v_steer * z790 + v_front * z792;
    const Scalar z1047 = n0_5 * (z1040 / (z73 * z73) + z1039 / z73);
    const Scalar z1048 = z24 * z58 + c_roll * z223;
    const Scalar z1049 = z23 * z175 + s_yaw * z250;
    const Scalar z1050 = z60 * z97 - z95 * z218 - z51 * z976 + z55 * z99;
    const Scalar z1051 = z226 * z718 - z1030 - z96 * z1050 - z256 * z719 + z62 * z1000;
    const Scalar z1052 = v_yaw * z729;
    const Scalar z1053 = v_roll * z748 + z1052 - z205 + z793 * (v_pitch + v_rear);
    const Scalar z1054 = v_roll * z748 + z1052 + z793 * (v_pitch + v_rear);
    const Scalar z1055 = z1048 + n0_35 * z1047;
    const Scalar z1056 = c_yaw * z276 - z22 * z172;
    const Scalar z1057 = z24 * z154 + z158 * z946 - z31 * z753 + z25 * z723 - c_roll * z273 + z26 * z231 + s_roll
        * z1051 + z20 * z1002;
    const Scalar z1058 = z23 * z172 + s_yaw * z276;
    const Scalar z1059 = z1026 + z1056;
    const Scalar z1060 = z211 * z1017 - z199 * z253 + z173 * z265 - z250 * z775 + z258 * z758 + z281 * z773 - z175
        * z1059 - z176 * z1005;
    const Scalar z1061 = z1051 + z1058;
    const Scalar z1062 = z200 * z253 + z211 * z1049 + z173 * z272 - z250 * z782 + z281 * z776 - z284 * z758 - z175
        * z1061 - z177 * z1005;
    const Scalar z1063 = z1030 + z1051;
    const Scalar z1064 = z210 * z976 - z97 * z209 + z55 * z270 - z99 * z761 - z95 * z238 + z218 * z760 - z51 * z1063
        - z60 * z1006;
    const Scalar z1065 = z23 * z753 + s_yaw * z1002;
    const Scalar z1066 = z54 * z124 + s_pitch * z180 + c_pitch * z163 + z56 * z127 + n2 * (z84 * z91 - z90 * z83);
    const Scalar z1067 = v_yaw * z1026 + v_roll * z1065 + v_pitch * z1034 + v_steer * z1060 + v_front * z1036;
    const Scalar z1068 = c_yaw * z1002 - z22 * z753;
    const Scalar z1069 = v_yaw * z1051 - v_roll * z1068 + v_pitch * z1057 + v_steer * z1062 - v_front * z1064;
    const Scalar z1070 = a_yaw * z721 + a_roll * z754 + a_pitch * z786 - a_steer * z788 + a_front * z791 + z1067;
    const Scalar z1071 = z40 * z140 - z93 * z978 + s_roll * z145;
    const Scalar z1072 = z34 * z58 - z223 * z983 + c_roll * z1066;
    const Scalar z1073 = z58 * z983 + c_roll * z1043;
    const Scalar z1074 = a_yaw * z723 - a_roll * z755 + a_pitch * z787 + a_steer * z790 - a_front * z792 + z1069;
    const Scalar z1075 = z35 * z117 - z37 * z41 - n2 * (z22 * z94 + z23 * z1032) - c_yaw * z144 + s_yaw * z1071;
    const Scalar z1076 = z35 * z41 + z37 * z117 - n2 * (z23 * z94 - z22 * z1032) + s_yaw * z144 + c_yaw * z1071;
    const Scalar z1077 = n4 * (z99 * z1033 - z100 * z1038) + n2 * (z60 * z1075 + z61 * z1076 - z120 * z151 + z121
        * z152);
    const Scalar z1078 = z15 * z1041 + z16 * z1042 + n2 * (s_pitch * z81 - c_pitch * z79);
    const Scalar z1079 = z15 * z1042 - z16 * z1041 + n2 * (s_pitch * z79 + c_pitch * z81);
    const Scalar z1080 = z40 * z978 + s_roll * z1078;
    const Scalar z1081 = n2 * (z23 * z117 + z1031) - c_yaw * z1079 + s_yaw * z1080;
    const Scalar z1082 = n2 * (z23 * z41 - z22 * z117) + s_yaw * z1079 + c_yaw * z1080;
    const Scalar z1083 = n2 * (z60 * z1081 + z61 * z1082) - n4 * (z99 * z120 - z100 * z121);
    const Scalar z1084 = n0_5 * (z108 * z1039 / (z73 * z73) - z1077 / z73 - z133 * z166 / (z73 * z73) + z104 * z1047
        / (z73 * z73)) + z133 * z187 / (z73 * z73 * z73);
    const Scalar z1085 = n0_5 * (z108 * z123 / (z73 * z73) + z1040 / (z73 * z73) + z1083 / z73);
    const Scalar z1086 = z1072 + n0_35 * z1084;
    const Scalar z1087 = v_yaw * z777;
    const Scalar z1088 = z21 * z24 + z27 * z25 + s_roll * z948 + c_roll * z32;
    const Scalar z1089 = z29 * z998 - z68 * z1088 - z192 * z720 - z185 * z728;
    const Scalar z1090 = a_roll * z796 + a_pitch * z834 + a_steer * z850 + z1086;
    const Scalar z1091 = c_yaw * z1020 - z22 * z727;
    const Scalar z1092 = v_yaw * z1028 - v_roll * z1091 + z1037 * (v_pitch + v_rear);
    const Scalar z1093 = z133 * z982 / (z73 * z73 * z73) + n0_35 * z1047 / (z73 * z73);
    const Scalar z1094 = z113 * z948 - z24 * z114 + c_roll * z201 - z32 * z727 + z27 * z196 + z25 * z729 + s_roll
        * z1089 + z21 * z1020;
    const Scalar z1095 = z789 * (a_pitch + a_rear) + a_yaw * z725 - a_roll * z756 + z1092;
    const Scalar z1096 = c_roll * z93 - z24 * z40;
    const Scalar z1097 = s_roll * z223 - z25 * z58;
    const Scalar z1098 = z67 * z1093 - z1048 - z96 * z1039 - z104 * z767 - z123 * z226;
    const Scalar z1099 = z1073 + n0_35 * z1085;
    const Scalar z1100 = z23 * z727 + s_yaw * z1020;
    const Scalar z1101 = v_yaw * z1089 + v_roll * z1100 + z1094 * (v_pitch + v_rear);
    const Scalar z1102 = z1048 + z1098;
    const Scalar z1103 = v_roll * z784 + z1087 + v_pitch * z832 - v_steer * z835 + v_front * z861 - z293;
    const Scalar z1104 = z793 * (a_pitch + a_rear) + a_yaw * z729 + a_roll * z748 + z1101;
    const Scalar z1105 = v_roll * z784 + z1087 + v_pitch * z832 - v_steer * z835 + v_front * z861;
    const Scalar z1106 = z11 * z85;
    const Scalar z1107 = z10 * z85;
    const Scalar z1108 = z83 * z116;
    const Scalar z1109 = z84 * z116;
    const Scalar z1110 = z22 * z119;
    const Scalar z1111 = z1108 + s_pitch * z1106 - z84 * z115 + c_pitch * z1107;
    const Scalar z1112 = s_pitch * z1107 - z1109 - z83 * z115 - c_pitch * z1106;
    const Scalar z1113 = z23 * z119;
    const Scalar z1114 = z100 * z126;
    const Scalar z1115 = z13 * z69;
    const Scalar z1116 = -z69 * (n1 - z12);
    const Scalar z1117 = n0_35 * z1115 + n0_08 * z1116;
    const Scalar z1118 = z84 * z132;
    const Scalar z1119 = -z69 * (n1 - z14);
    const Scalar z1120 = n0_08 * z1115 + n0_35 * z1119;
    const Scalar z1121 = s_steer * z24 - c_roll * z69 - z25 * z118 + s_roll * z1111;
    const Scalar z1122 = z1110 - z23 * z122 + c_yaw * z1112 + s_yaw * z1121;
    const Scalar z1123 = s_yaw * z1112 - z1113 - z22 * z122 - c_yaw * z1121;
    const Scalar z1124 = z83 * z135 - z1118 + s_pitch * z1117 - c_pitch * z1120;
    const Scalar z1125 = n2 * (z1114 + z60 * z1122 - z61 * z1123 + z99 * z125);
    const Scalar z1126 = n0_08 * z1106 - n0_35 * z1107;
    const Scalar z1127 = z25 * z143;
    const Scalar z1128 = v_yaw * z783;
    const Scalar z1129 = v_roll * z785 - z1128 - v_pitch * z833 + v_steer * z836 + v_front * z862 - z310;
    const Scalar z1130 = v_roll * z785 - z1128 - v_pitch * z833 + v_steer * z836 + v_front * z862;
    const Scalar z1131 = s_roll * z1126 - z1127 + z24 * z142 + c_roll * z1124;
    const Scalar z1132 = s_roll * z243 - z25 * z156;
    const Scalar z1133 = z24 * z156 + c_roll * z243;
    const Scalar z1134 = z51 * z1038 - z61 * z1096 - z100 * z751 - z121 * z218;
    const Scalar z1135 = z104 * z139;
    const Scalar z1136 = n0_5 * (z1135 / (z73 * z73) - z1125 / z73);
    const Scalar z1137 = s_yaw * z106 - z23 * z59 - z22 * z752 - c_yaw * z1097;
    const Scalar z1138 = z22 * z59 - z23 * z752 + c_yaw * z106 + s_yaw * z1097;
    const Scalar z1139 = z1137 - z96 * z1134 + z225 * z767 - z226 * z771 + z63 * z1093;
    const Scalar z1140 = n2 * z85;
    const Scalar z1141 = z11 * z1140;
    const Scalar z1142 = z22 * z157 - c_yaw * z244 - z23 * z817 + s_yaw * z1132;
    const Scalar z1143 = z23 * z157 + s_yaw * z244 + z22 * z817 + c_yaw * z1132;
    const Scalar z1144 = z1131 - n0_35 * z1136;
    const Scalar z1145 = z1137 - z1139;
    const Scalar z1146 = z51 * z1033 - z60 * z1096 + z99 * z751 - z120 * z218;
    const Scalar z1147 = z62 * z1093 - z1138 - z96 * z1146 - z226 * z770 - z256 * z767;
    const Scalar z1148 = z100 * z843 - z208 * z1096 - z210 * z1038 - z121 * z238 - z260 * z751 + z218 * z845 + z51
        * z1145 - z61 * z1102;
    const Scalar z1149 = z25 * z170 + s_roll * z245;
    const Scalar z1150 = c_roll * z245 - z24 * z170;
    const Scalar z1151 = z1098 - z1150;
    const Scalar z1152 = z1138 + z1147;
    const Scalar z1153 = z210 * z1033 - z209 * z1096 + z99 * z843 + z120 * z238 + z218 * z844 - z270 * z751 + z51
        * z1152 + z60 * z1102;
    const Scalar z1154 = z23 * z169 + s_yaw * z251 + z22 * z819 - c_yaw * z1149;
    const Scalar z1155 = c_yaw * z251 - z22 * z169 + z23 * z819 + s_yaw * z1149;
    const Scalar z1156 = z1139 + z1154;
    const Scalar z1157 = z258 * z827 - z199 * z1133 - z211 * z1143 - z265 * z818 - z281 * z821 + z250 * z831 + z175
        * z1156 - z176 * z1151;
    const Scalar z1158 = z1147 - z1155;
    const Scalar z1159 = z200 * z1133 - z211 * z1142 + z250 * z829 + z281 * z820 - z272 * z818 - z284 * z827 + z175
        * z1158 - z177 * z1151;
    const Scalar z1160 = z23 * z778 + s_yaw * z1098;
    const Scalar z1161 = z10 * z1140;
    const Scalar z1162 = c_yaw * z1098 - z22 * z778;
    const Scalar z1163 = z25 * z777 - z32 * z778 + s_roll * z1139 + z21 * z1098;
    const Scalar z1164 = v_yaw * z1139 + v_roll * z1160 + v_pitch * z1163 - v_steer * z1157 - v_front * z1148;
    const Scalar z1165 = z25 * z783 - z31 * z778 + s_roll * z1147 + z20 * z1098;
    const Scalar z1166 = v_yaw * z1147 - v_roll * z1162 + v_pitch * z1165 - v_steer * z1159 + v_front * z1153;
    const Scalar z1167 = a_yaw * z777 + a_roll * z784 + a_pitch * z832 - a_steer * z835 + a_front * z861 + z1164;
    const Scalar z1168 = s_pitch * z1161 - n2 * (z83 * z115 + z1109) - c_pitch * z1141;
    const Scalar z1169 = a_yaw * z783 - a_roll * z785 + a_pitch * z833 - a_steer * z836 - a_front * z862 + z1166;
    const Scalar z1170 = s_pitch * z1141 - n2 * (z84 * z115 - z1108) + c_pitch * z1161;
    const Scalar z1171 = n0_08 * z1141 - n0_35 * z1161;
    const Scalar z1172 = z139 * z982 / (z73 * z73 * z73) + n0_35 * z1136 / (z73 * z73);
    const Scalar z1173 = z1131 + z96 * z1125 - z104 * z851 - z129 * z226 + z67 * z1172;
    const Scalar z1174 = z1131 - z1173;
    const Scalar z1175 = z11 * z138;
    const Scalar z1176 = z10 * z138;
    const Scalar z1177 = z115 * z124 + z116 * z127 + s_pitch * z1175 + c_pitch * z1176 + n2 * (z84 * z1106 - z83
        * z1107);
    const Scalar z1178 = z116 * z124 - z115 * z127 + s_pitch * z1176 - c_pitch * z1175 + n2 * (z84 * z1107 + z83
        * z1106);
    const Scalar z1179 = n0_08 * z1175 - n0_35 * z1176;
    const Scalar z1180 = c_roll * z130 + s_steer * z34 + z118 * z140 + n2 * (z24 * z69 + z25 * z1111) + s_roll * z1177;
    const Scalar z1181 = s_roll * z69 + s_steer * z25 + z24 * z118 + c_roll * z1111;
    const Scalar z1182 = n2 * z69;
    const Scalar z1183 = n2 * (s_steer * z24 - z25 * z118) - c_roll * z1182 + s_roll * z1170;
    const Scalar z1184 = z37 * z119 + z35 * z122 + n2 * (z23 * z1121 - z22 * z1112) + c_yaw * z1178 + s_yaw * z1180;
    const Scalar z1185 = z35 * z119 - z37 * z122 + n2 * (z23 * z1112 + z22 * z1121) + s_yaw * z1178 - c_yaw * z1180;
    const Scalar z1186 = n2 * (z60 * z1184 - z61 * z1185 - z125 * z151 - z126 * z152) - n4 * (z100 * z1123 + z99
        * z1122);
    const Scalar z1187 = c_yaw * z1168 - n2 * (z23 * z122 - z1110) + s_yaw * z1183;
    const Scalar z1188 = s_yaw * z1168 - n2 * (z22 * z122 + z1113) - c_yaw * z1183;
    const Scalar z1189 = n4 * (z99 * z125 + z1114) + n2 * (z60 * z1187 - z61 * z1188);
    const Scalar z1190 = v_roll * z858;
    const Scalar z1191 = z1190 + v_yaw * z857 + v_pitch * z882 - v_steer * z884 - v_front * z886 - z311;
    const Scalar z1192 = n0_5 * (z104 * z1136 / (z73 * z73) - z108 * z1125 / (z73 * z73) - z139 * z166 / (z73 * z73)
        - z1186 / z73) + z139 * z187 / (z73 * z73 * z73);
    const Scalar z1193 = n0_5 * (z108 * z129 / (z73 * z73) + z1135 / (z73 * z73) - z1189 / z73);
    const Scalar z1194 = z1190 + v_yaw * z857 + v_pitch * z882 - v_steer * z884 - v_front * z886;
    const Scalar z1195 = v_yaw * z859;
    const Scalar z1196 = v_roll * z860 - z1195 - v_pitch * z883 + v_steer * z885 + z292 - v_front * z888;
    const Scalar z1197 = v_roll * z860 - z1195 - v_pitch * z883 + v_steer * z885 - v_front * z888;
    const Scalar z1198 = z84 * z135 + z83 * z132 + s_pitch * z1120 + c_pitch * z1117;
    const Scalar z1199 = z13 * z130;
    const Scalar z1200 = s_roll * z1124 - c_roll * z1126 - z24 * z143 - z25 * z142;
    const Scalar z1201 = -z130 * (n1 - z12);
    const Scalar z1202 = n0_35 * z1199 + n0_08 * z1201;
    const Scalar z1203 = -z130 * (n1 - z14);
    const Scalar z1204 = n0_08 * z1199 + n0_35 * z1203;
    const Scalar z1205 = z61 * z1181 + z126 * z218 + z100 * z764 + z51 * z1123;
    const Scalar z1206 = s_pitch * z1202 - z135 * z127 - z132 * z124 - c_pitch * z1204 - n2 * (z84 * z1117 + z83
        * z1120);
    const Scalar z1207 = z23 * z815 + z22 * z763 + s_yaw * z1198 + c_yaw * z1200;
    const Scalar z1208 = z22 * z815 - z23 * z763 - c_yaw * z1198 + s_yaw * z1200;
    const Scalar z1209 = z1207 - z96 * z1205 + z225 * z851 + z226 * z853 + z63 * z1172;
    const Scalar z1210 = z143 * z140 + s_roll * z1179 + z34 * z142 - n2 * (z24 * z1124 - z25 * z1126) - c_roll * z1206;
    const Scalar z1211 = z1210 - n0_35 * z1192;
    const Scalar z1212 = z23 * z856 + s_yaw * z1173;
    const Scalar z1213 = z25 * z857 - z32 * z856 + s_roll * z1209 + z21 * z1173;
    const Scalar z1214 = a_roll * z848 + a_pitch * z849 - a_steer * z902 + z1211;
    const Scalar z1215 = z250 * z857 + z258 * z856 + z175 * z1209 - z176 * z1173;
    const Scalar z1216 = c_yaw * z1173 - z22 * z856;
    const Scalar z1217 = z1207 - z1209;
    const Scalar z1218 = z208 * z1181 - z210 * z1123 + z126 * z238 - z218 * z869 + z260 * z764 - z100 * z871 + z51
        * z1217 + z61 * z1174;
    const Scalar z1219 = z125 * z218 - z60 * z1181 + z51 * z1122 + z99 * z764;
    const Scalar z1220 = z1208 + z96 * z1219 - z226 * z855 - z256 * z851 + z62 * z1172;
    const Scalar z1221 = v_yaw * z1209 + v_roll * z1212 + v_pitch * z1213 - v_steer * z1215 - v_front * z1218;
    const Scalar z1222 = a_yaw * z857 + a_roll * z858 + a_pitch * z882 - a_steer * z884 - a_front * z886 + z1221;
    const Scalar z1223 = z13 * z1182;
    const Scalar z1224 = -z1182 * (n1 - z12);
    const Scalar z1225 = -z1182 * (n1 - z14);
    const Scalar z1226 = z250 * z859 - z284 * z856 + z175 * z1220 - z177 * z1173;
    const Scalar z1227 = z25 * z859 - z31 * z856 + s_roll * z1220 + z20 * z1173;
    const Scalar z1228 = n0_35 * z1223 + n0_08 * z1224;
    const Scalar z1229 = n0_08 * z1223 + n0_35 * z1225;
    const Scalar z1230 = s_pitch * z1228 - c_pitch * z1229 + n2 * (z83 * z135 - z1118);
    const Scalar z1231 = z1208 - z1220;
    const Scalar z1232 = z210 * z1122 - z209 * z1181 - z125 * z238 - z270 * z764 + z99 * z871 + z218 * z870 + z51
        * z1231 + z60 * z1174;
    const Scalar z1233 = s_roll * z1171 + n2 * (z24 * z142 - z1127) + c_roll * z1230;
    const Scalar z1234 = v_yaw * z1220 - v_roll * z1216 + v_pitch * z1227 - v_steer * z1226 - v_front * z1232;
    const Scalar z1235 = a_yaw * z859 - a_roll * z860 + a_pitch * z883 - a_steer * z885 + a_front * z888 + z1234;
    const Scalar z1236 = z1233 - n0_35 * z1193;
    const Scalar z1237 = n1 / z217;
    const Scalar z1238 = z217 * z217;
    const Scalar z1239 = n1_over_94 + k38 * z228 * z228 + n25_over_7 * z1238 + z155 * z155 / z467 + z161 * z161 / z436
        + z186 * z186 / z408;
    const Scalar z1240 = z222 * z1237;
    const Scalar z1241 = n1_over_94 + k38 * z227 * z227 + n25_over_7 * z222 * z222 + z154 * z154 / z467 + z178 * z178
        / z436 + z165 * z165 / z408;
    const Scalar z1242 = n0_28 * z1239;
    const Scalar z1243 = z467 * z1241;
    const Scalar z1244 = z154 - z155 * z1240;
    const Scalar z1245 = z112 - z1244;
    const Scalar z1246 = n1 / z149;
    const Scalar z1247 = z165 * z1246;
    const Scalar z1248 = z186 * z1246;
    const Scalar z1249 = z953 - z928 + z930 * z1240;
    const Scalar z1250 = z149 * z149;
    const Scalar z1251 = z168 * z1248 - z228;
    const Scalar z1252 = n1_over_94 + k38 * z168 * z168 + z153 * z153 / z436 + z1250 / z408;
    const Scalar z1253 = z92 + z153;
    const Scalar z1254 = z161 - z1248 * z1253;
    const Scalar z1255 = z1245 * z1245;
    const Scalar z1256 = n1 / z1245;
    const Scalar z1257 = z1246 * z1253;
    const Scalar z1258 = z167 * z1246;
    const Scalar z1259 = z1001 - z1055 * z1257;
    const Scalar z1260 = z995 - z1105 * z1257;
    const Scalar z1261 = z1046 - z1130 * z1257;
    const Scalar z1262 = z194 - z1258 * z1253;
    const Scalar z1263 = z178 - z1247 * z1253 - z1262 - z1240 * z1254;
    const Scalar z1264 = z114 * z1256;
    const Scalar z1265 = z956 - z1264 * z1249;
    const Scalar z1266 = z408 * z1252;
    const Scalar z1267 = z191 * z191 * (n25_over_3 + n1 / z408) + n1_over_94 + z114 * z114 / z467 + z188 * z188 / z436;
    const Scalar z1268 = n94 * z1267;
    const Scalar z1269 = n1 - z1240 * z1264;
    const Scalar z1270 = z1269 * z1269;
    const Scalar z1271 = n1 / z1269;
    const Scalar z1272 = z168 * z1246;
    const Scalar z1273 = z1055 * z1272 - z1144;
    const Scalar z1274 = z1105 * z1272 + z1194;
    const Scalar z1275 = z1130 * z1272 + z1197;
    const Scalar z1276 = z168 * z1258;
    const Scalar z1277 = z168 * z1247 - z227 - z1276 - z1240 * z1251;
    const Scalar z1278 = z191 * z1246;
    const Scalar z1279 = z990 - z1259;
    const Scalar z1280 = z188 - z1278 * z1253 + z1264 * z1263;
    const Scalar z1281 = z1016 + z1258 * z1279;
    const Scalar z1282 = z191 - z167 * z1264;
    const Scalar z1283 = z168 * z1278 + z1264 * z1277;
    const Scalar z1284 = z1271 * z1282;
    const Scalar z1285 = z1248 * z1279 + z1260;
    const Scalar z1286 = z1248 * z1273 - z1274;
    const Scalar z1287 = z1271 * z1283;
    const Scalar z1288 = z1247 * z1279 - z1281 + z1261 - z1240 * z1285;
    const Scalar z1289 = z1240 * z1287 + z1277;
    const Scalar z1290 = z1271 * z1265;
    const Scalar z1291 = z1271 * z1280;
    const Scalar z1292 = z1240 * z1290 - z1249;
    const Scalar z1293 = z1240 * z1291 + z1263;
    const Scalar z1294 = z1054 + z1278 * z1279 + z1264 * z1288;
    const Scalar z1295 = z1256 * z1289;
    const Scalar z1296 = z1251 - z1287 + z155 * z1295;
    const Scalar z1297 = z1271 * z1294;
    const Scalar z1298 = z1246 * z1279;
    const Scalar z1299 = z112 * z1295 + z1276;
    const Scalar z1300 = z1256 * z1292;
    const Scalar z1301 = z930 - z1290 + z155 * z1300;
    const Scalar z1302 = z112 * z1300 - z928;
    const Scalar z1303 = z1240 * z1297 + z1288;
    const Scalar z1304 = z1237 * z1296;
    const Scalar z1305 = z1256 * z1293;
    const Scalar z1306 = z1256 * z1303;
    const Scalar z1307 = z1024 - z1099 * z1257;
    const Scalar z1308 = z1237 * z1301;
    const Scalar z1309 = z112 * z1305 + z1262;
    const Scalar z1310 = z1285 - z1297 + z155 * z1306;
    const Scalar z1311 = z112 * z1306 + z1281;
    const Scalar z1312 = z1254 - z1291 + z155 * z1305;
    const Scalar z1313 = z1237 * z1310;
    const Scalar z1314 = z1099 * z1272 - z1236;
    const Scalar z1315 = z1237 * z1312;
    const Scalar z1316 = z204 * z1257 + z1014 - z929 * z1305;
    const Scalar z1317 = z1029 - z1307;
    const Scalar z1318 = z1258 * z1317 + z1316;
    const Scalar z1319 = z994 - z1103 * z1257 + z931 * z1305 + z315 * z1315;
    const Scalar z1320 = z1103 * z1272 + z1191 + z931 * z1295 + z315 * z1304;
    const Scalar z1321 = z1045 - z1129 * z1257 - z955 * z1305 + z318 * z1315;
    const Scalar z1322 = z1129 * z1272 + z1196 - z955 * z1295 + z318 * z1304;
    const Scalar z1323 = z232 * z1257 + z1053 + z957 * z1305;
    const Scalar z1324 = z1248 * z1317 + z1319;
    const Scalar z1325 = z1247 * z1317 - z1318 + z1321 - z1240 * z1324;
    const Scalar z1326 = z1258 * z1273;
    const Scalar z1327 = z1247 * z1273 - z1326 - z1275 - z1240 * z1286;
    const Scalar z1328 = z167 - z1240 * z1284;
    const Scalar z1329 = z1256 * z1328;
    const Scalar z1330 = z1278 * z1317 + z1323 + z1264 * z1325;
    const Scalar z1331 = z1271 * z1330;
    const Scalar z1332 = z112 * z1329 - z167;
    const Scalar z1333 = z155 * z1329 + z1284;
    const Scalar z1334 = z1246 * z1273;
    const Scalar z1335 = z1240 * z1331 + z1325;
    const Scalar z1336 = z204 * z1272 + z929 * z1295;
    const Scalar z1337 = z1278 * z1273 + z1264 * z1327;
    const Scalar z1338 = z1237 * z1333;
    const Scalar z1339 = z1258 * z1314 + z1336;
    const Scalar z1340 = z1248 * z1314 - z1320;
    const Scalar z1341 = z1271 * z1337;
    const Scalar z1342 = z1247 * z1314 - z1339 - z1322 - z1240 * z1340;
    const Scalar z1343 = z1240 * z1341 + z1327;
    const Scalar z1344 = z1246 * z1317;
    const Scalar z1345 = z1256 * z1335;
    const Scalar z1346 = z112 * z1345 + z1318;
    const Scalar z1347 = z1324 - z1331 + z155 * z1345;
    const Scalar z1348 = z1256 * z1343;
    const Scalar z1349 = z1099 * z1298;
    const Scalar z1350 = z1099 * z1334;
    const Scalar z1351 = z1237 * z1347;
    const Scalar z1352 = z1286 - z1341 + z155 * z1348;
    const Scalar z1353 = z112 * z1348 + z1326;
    const Scalar z1354 = z204 * z1298 + z929 * z1306;
    const Scalar z1355 = z1237 * z1352;
    const Scalar z1356 = z1004 + z1090 * z1257;
    const Scalar z1357 = z1090 * z1272 - z1214;
    const Scalar z1358 = z1070 - z1167 * z1257;
    const Scalar z1359 = z1167 * z1272 + z1222;
    const Scalar z1360 = z204 * z1334 + z929 * z1348;
    const Scalar z1361 = z204 - z929 * z1329;
    const Scalar z1362 = z929 * z1300;
    const Scalar z1363 = z931 * z1300 + z315 * z1308;
    const Scalar z1364 = z1103 * z1298 + z931 * z1306 + z315 * z1313;
    const Scalar z1365 = z1103 * z1334 + z931 * z1348 + z315 * z1355;
    const Scalar z1366 = z931 * z1329 + z315 * z1338;
    const Scalar z1367 = z1129 * z1298 - z955 * z1306 + z318 * z1313;
    const Scalar z1368 = z1129 * z1334 - z955 * z1348 + z318 * z1355;
    const Scalar z1369 = z318 * z1308 - z955 * z1300;
    const Scalar z1370 = z318 * z1338 - z955 * z1329;
    const Scalar z1371 = z1240 * z1366 + z1361 - z1370;
    const Scalar z1372 = z232 * z1298 - z957 * z1306;
    const Scalar z1373 = z957 * z1300;
    const Scalar z1374 = z232 * z1272 - z957 * z1295;
    const Scalar z1375 = z1074 - z1169 * z1257;
    const Scalar z1376 = z1278 * z1314 + z1374 + z1264 * z1342;
    const Scalar z1377 = z1246 * z1314;
    const Scalar z1378 = z232 * z1334 - z957 * z1348;
    const Scalar z1379 = z232 + z957 * z1329;
    const Scalar z1380 = z1349 + z1356;
    const Scalar z1381 = z1350 + z1357;
    const Scalar z1382 = z1095 - z1354;
    const Scalar z1383 = z1169 * z1272 + z1235;
    const Scalar z1384 = z942 + z1362;
    const Scalar z1385 = z943 + z1363;
    const Scalar z1386 = z1364 - z1358;
    const Scalar z1387 = z1365 + z1359;
    const Scalar z1388 = z1367 + z1375;
    const Scalar z1389 = z1368 - z1383;
    const Scalar z1390 = z969 + z1369;
    const Scalar z1391 = z1104 + z1372;
    const Scalar z1392 = z954 - z1373;
    const Scalar z1393 = z1008 + z1380;
    const Scalar z1394 = z1258 * z1393 - z1382;
    const Scalar z1395 = z1248 * z1393 - z1386;
    const Scalar z1396 = z1240 * z1385 - z1384 - z1390;
    const Scalar z1397 = z1264 * z1371 - z1379;
    const Scalar z1398 = z1247 * z1393 - z1394 - z1388 - z1240 * z1395;
    const Scalar z1399 = z1264 * z1396 + z1392;
    const Scalar z1400 = z1271 * z1397;
    const Scalar z1401 = z1271 * z1399;
    const Scalar z1402 = z1271 * z1376;
    const Scalar z1403 = z1240 * z1400 + z1371;
    const Scalar z1404 = z1240 * z1402 + z1342;
    const Scalar z1405 = z1240 * z1401 + z1396;
    const Scalar z1406 = z1256 * z1403;
    const Scalar z1407 = z1256 * z1404;
    const Scalar z1408 = z1256 * z1405;
    const Scalar z1409 = z1278 * z1393 + z1391 + z1264 * z1398;
    const Scalar z1410 = z112 * z1406 - z1361;
    const Scalar z1411 = z112 * z1407 + z1339;
    const Scalar z1412 = z112 * z1408 + z1384;
    const Scalar z1413 = z1271 * z1409;
    const Scalar z1414 = z1340 - z1402 + z155 * z1407;
    const Scalar z1415 = z155 * z1406 - z1366 - z1400;
    const Scalar z1416 = z1240 * z1413 + z1398;
    const Scalar z1417 = z155 * z1408 - z1385 - z1401;
    const Scalar z1418 = z1237 * z1414;
    const Scalar z1419 = z1258 * z1381 + z1360;
    const Scalar z1420 = z1248 * z1381 - z1387;
    const Scalar z1421 = z1247 * z1381 - z1419 - z1389 - z1240 * z1420;
    const Scalar z1422 = z1246 * z1393;
    const Scalar z1423 = z1256 * z1416;
    const Scalar z1424 = z112 * z1423 + z1394;
    const Scalar z1425 = z1395 - z1413 + z155 * z1423;
    const Scalar z1426 = z1237 * z1415;
    const Scalar z1427 = z395 + z92 * z396 - z358 * z1257 + z386 * z1291 + z393 * z1305 + z397 * z1309;
    const Scalar z1428 = z910 - z911;
    const Scalar z1429 = z922 + z1258 * z1428;
    const Scalar z1430 = z923 - z1248 * z1428;
    const Scalar z1431 = z396 - z422 * z1272;
    const Scalar z1432 = z1278 * z1381 + z1378 + z1264 * z1421;
    const Scalar z1433 = z1247 * z1428 - z1429 + z924 + z1240 * z1430;
    const Scalar z1434 = z1271 * z1432;
    const Scalar z1435 = z1246 * z1381;
    const Scalar z1436 = z1240 * z1434 + z1421;
    const Scalar z1437 = z436 + z92 * z440 - z420 * z1257 + z446 * z1291 + z442 * z1305 + z447 * z1309 - z427 * z1315;
    const Scalar z1438 = z925 - z1278 * z1428 - z1264 * z1433;
    const Scalar z1439 = z1246 * z1428;
    const Scalar z1440 = z440 + n94 * z92 + z422 * z1257;
    const Scalar z1441 = z92 * z422 - z420 + z408 * z1257 + z423 * z1291 - z426 * z1305 + z425 * z1309 + z366 * z1315;
    const Scalar z1442 = z1271 * z1438;
    const Scalar z1443 = z1240 * z1442 - z1433;
    const Scalar z1444 = z423 * z1287 - z358 - z408 * z1272 - z426 * z1295 + z425 * z1299 + z366 * z1304;
    const Scalar z1445 = k18 + z358 * z1272 + z386 * z1287 + z393 * z1295 + z397 * z1299;
    const Scalar z1446 = z386 - z423 * z1272 + n94 * z1287 - z492 * z1295;
    const Scalar z1447 = z397 - z425 * z1272 - z494 * z1295 + n94 * z1299;
    const Scalar z1448 = z446 + z423 * z1257 + n94 * z1291 - z492 * z1305;
    const Scalar z1449 = z492 * z1287 - z393 - z426 * z1272 - z467 * z1295 + z494 * z1299 + z389 * z1304;
    const Scalar z1450 = z425 * z1257 + z447 - z494 * z1305 + n94 * z1309;
    const Scalar z1451 = n0_12 - z423 * z1284 - z426 * z1329 + z425 * z1332 + z366 * z1338;
    const Scalar z1452 = z426 * z1257 - z442 + z492 * z1291 - z467 * z1305 + z494 * z1309 + z389 * z1315;
    const Scalar z1453 = z419 - z492 * z1284 - z467 * z1329 + z494 * z1332 + z389 * z1338;
    const Scalar z1454 = n94 * z1284 + z492 * z1329;
    const Scalar z1455 = z494 * z1329 - n94 * z1332;
    const Scalar z1456 = z366 * z1257 - z427 - z389 * z1305 + n0_28 * z1315;
    const Scalar z1457 = z366 * z1272 + z389 * z1295 - n0_28 * z1304;
    const Scalar z1458 = z389 * z1329 - n0_28 * z1338;
    const Scalar z1459 = z1256 * z1436;
    const Scalar z1460 = z1256 * z1443;
    const Scalar z1461 = z92 * z1440 + z1291 * z1448 + z1309 * z1450 + z1315 * z1456 + z1257 * z1441 - z1305 * z1452
        + z1437;
    const Scalar z1462 = z112 * z1459 + z1419;
    const Scalar z1463 = z112 * z1460 - z1429;
    const Scalar z1464 = z1420 - z1434 + z155 * z1459;
    const Scalar z1465 = z1430 - z1442 + z155 * z1460;
    const Scalar z1466 = z1237 * z1417;
    const Scalar z1467 = z1304 * z1457 - z1445 - z1287 * z1446 - z1299 * z1447 + z1272 * z1444 + z1295 * z1449;
    const Scalar z1468 = z1272 * z1441 - z1427 - z1287 * z1448 - z1299 * z1450 - z1304 * z1456 + z1295 * z1452;
    const Scalar z1469 = z1237 * z1425;
    const Scalar z1470 = z565 + z636 * z1257;
    const Scalar z1471 = z636 * z1272 + z661;
    const Scalar z1472 = z645 * z1272 - z663 + z600 * z1295;
    const Scalar z1473 = z646 * z1257 - z598 + z601 * z1305;
    const Scalar z1474 = z600 * z1305 - z599 - z645 * z1257;
    const Scalar z1475 = z601 * z1295 - z664 - z646 * z1272;
    const Scalar z1476 = z1237 * z1464;
    const Scalar z1477 = z1237 * z1465;
    const Scalar z1478 = z574 * z1329 - z649 - z677 * z1338;
    const Scalar z1479 = z626 * z1257 - z640 - z641 * z1305 + z465 * z1315;
    const Scalar z1480 = z676 * z1257 + z681 + z684 * z1305;
    const Scalar z1481 = z671 + z676 * z1272 - z684 * z1295;
    const Scalar z1482 = z683 - z682 * z1305;
    const Scalar z1483 = z590 - z588 * z1257 + z613 * z1305 - z675 * z1315;
    const Scalar z1484 = z588 * z1272 - z667 + z613 * z1295 - z675 * z1304;
    const Scalar z1485 = z672 * z1257 - z592 + z591 * z1305 + z684 * z1315;
    const Scalar z1486 = z699 - z672 * z1272 + z591 * z1295 + z684 * z1304;
    const Scalar z1487 = z615 - z670 * z1257 + z574 * z1305 - z677 * z1315;
    const Scalar z1488 = z92 * z1470 + z1309 * z1473 + z1315 * z1480 - z1291 * z1474 + z1257 * z1483 + z1305 * z1485
        - z1487;
    const Scalar z1489 = z698 + z670 * z1272 + z574 * z1295 - z677 * z1304;
    const Scalar z1490 = z92 * z1471 + z1291 * z1472 + z1315 * z1481 - z1309 * z1475 - z1257 * z1484 - z1305 * z1486
        + z1489;
    const Scalar z1491 = n0_12 - z419 * z1329;
    const Scalar z1492 = z1284 * z1454 + z1491 - z1332 * z1455 - z1338 * z1458 - z1329 * z1453;
    const Scalar z1493 = n0_12 * z1272 + z419 * z1295;
    const Scalar z1494 = z419 * z1305 - n0_12 * z1257;
    const Scalar z1495 = z1287 * z1474 - z1479 - z1299 * z1473 - z1304 * z1480 + z1272 * z1483 - z1295 * z1485;
    const Scalar z1496 = z1332 * z1473 + z1482 + z1338 * z1480 + z1284 * z1474 + z1329 * z1485;
    const Scalar z1497 = z1284 * z1446 + z1493 - z1332 * z1447 + z1338 * z1457 + z1329 * z1449;
    const Scalar z1498 = z1284 * z1448 + z1494 - z1332 * z1450 - z1338 * z1456 + z1329 * z1452;
    const Scalar z1499 = z600 * z1329;
    const Scalar z1500 = z601 * z1329;
    const Scalar z1501 = z682 * z1295;
    const Scalar z1502 = z1284 * z1472 - z1501 - z1338 * z1481 + z1332 * z1475 + z1329 * z1486;
    const Scalar z1503 = z682 * z1329;
    const Scalar z1504 = z684 * z1329;
    const Scalar z1505 = z613 * z1329 - z675 * z1338;
    const Scalar z1506 = z591 * z1329 - z682 + z684 * z1338;
    const Scalar z1507 = z1309 * z1500 - z1478 - z1291 * z1499 + z1315 * z1504 + z1257 * z1505 + z1305 * z1506;
    const Scalar z1508 = z1284 * z1499 - z1503 + z1332 * z1500 + z1338 * z1504 + z1329 * z1506;
    const Scalar z1509 = z465 * z1304 - z626 * z1272 - z641 * z1295;
    const Scalar z1510 = z1287 * z1472 + z1304 * z1481 - z1299 * z1475 + z1272 * z1484 - z1295 * z1486 - z1509;
    const Scalar z1511 = z465 * z1338 - z641 * z1329;
    const Scalar z1512 = z1287 * z1499 - z1299 * z1500 - z1304 * z1504 + z1272 * z1505 - z1295 * z1506 - z1511;
    const Scalar z1513 = z1029 * z1440 + z1344 * z1441 - z1331 * z1448 + z1345 * z1452 - z1346 * z1450 - z1351 * z1456;
    const Scalar z1514 = z1513 + z1488;
    const Scalar z1515 = z1029 * z1431 + z1344 * z1444 - z1331 * z1446 + z1345 * z1449 - z1346 * z1447 + z1351 * z1457;
    const Scalar z1516 = z1344 * z1451 + z1331 * z1454 + z1345 * z1453 + z1346 * z1455 + z1351 * z1458;
    const Scalar z1517 = z1515 - z1495;
    const Scalar z1518 = z1516 + z1496;
    const Scalar z1519 = z1402 * z1448 - z1377 * z1441 - z1407 * z1452 + z1411 * z1450 + z1418 * z1456;
    const Scalar z1520 = z1519 - z1490;
    const Scalar z1521 = z1400 * z1448 - z1406 * z1452 + z1410 * z1450 + z1426 * z1456;
    const Scalar z1522 = z1521 + z1507;
    const Scalar z1523 = z645 * z1298 + z600 * z1306;
    const Scalar z1524 = z600 * z1300;
    const Scalar z1525 = z1402 * z1446 - z1377 * z1444 - z1407 * z1449 + z1411 * z1447 - z1418 * z1457;
    const Scalar z1526 = z1377 * z1451 + z1402 * z1454 + z1407 * z1453 + z1411 * z1455 + z1418 * z1458;
    const Scalar z1527 = z645 * z1334 + z600 * z1348;
    const Scalar z1528 = z1525 - z1510;
    const Scalar z1529 = z1526 - z1502;
    const Scalar z1530 = z1400 * z1446 - z1406 * z1449 + z1410 * z1447 - z1426 * z1457;
    const Scalar z1531 = z1400 * z1454 + z1406 * z1453 + z1410 * z1455 + z1426 * z1458;
    const Scalar z1532 = z438 - z1524;
    const Scalar z1533 = z1530 - z1512;
    const Scalar z1534 = z1531 - z1508;
    const Scalar z1535 = z578 - z597 * z1257;
    const Scalar z1536 = z597 * z1272 - z643;
    const Scalar z1537 = z603 + z605 * z1257;
    const Scalar z1538 = z605 * z1272 - z647;
    const Scalar z1539 = z1523 + z1537;
    const Scalar z1540 = z1527 + z1538;
    const Scalar z1541 = z803 - z867 * z1257;
    const Scalar z1542 = z867 * z1272 - z894;
    const Scalar z1543 = z604 - z606 * z1257;
    const Scalar z1544 = z606 * z1272 - z648;
    const Scalar z1545 = z814 - z841 * z1257;
    const Scalar z1546 = z841 * z1272 - z897;
    const Scalar z1547 = z742 - z808 * z1257;
    const Scalar z1548 = z808 * z1272 - z865;
    const Scalar z1549 = z810 - z868 * z1257;
    const Scalar z1550 = z868 * z1272 - z919;
    const Scalar z1551 = z842 + z899 * z1257;
    const Scalar z1552 = z899 * z1272 - z941;
    const Scalar z1553 = z636 * z1298;
    const Scalar z1554 = z1553 + z1535;
    const Scalar z1555 = z636 * z1334;
    const Scalar z1556 = z1555 - z1536;
    const Scalar z1557 = z601 * z1300;
    const Scalar z1558 = z437 - z1557;
    const Scalar z1559 = z574 * z1300 - z677 * z1308;
    const Scalar z1560 = z676 * z1298 - z684 * z1306;
    const Scalar z1561 = z676 * z1334 - z684 * z1348;
    const Scalar z1562 = z682 * z1300;
    const Scalar z1563 = z682 * z1306;
    const Scalar z1564 = z682 * z1348;
    const Scalar z1565 = z601 * z1306 - z646 * z1298;
    const Scalar z1566 = z601 * z1348 - z646 * z1334;
    const Scalar z1567 = z1565 + z1543;
    const Scalar z1568 = z1566 - z1544;
    const Scalar z1569 = z684 * z1300;
    const Scalar z1570 = z613 * z1300 - z675 * z1308;
    const Scalar z1571 = z588 * z1298 + z613 * z1306 - z675 * z1313;
    const Scalar z1572 = z588 * z1334 + z613 * z1348 - z675 * z1355;
    const Scalar z1573 = z591 * z1300 + z684 * z1308;
    const Scalar z1574 = z737 - z1573;
    const Scalar z1575 = z465 * z1308 - z641 * z1300;
    const Scalar z1576 = z591 * z1306 - z672 * z1298 + z684 * z1313;
    const Scalar z1577 = z591 * z1348 - z672 * z1334 + z684 * z1355;
    const Scalar z1578 = z574 * z1306 + z670 * z1298 - z677 * z1313;
    const Scalar z1579 = z574 * z1348 + z670 * z1334 - z677 * z1355;
    const Scalar z1580 = z465 * z1313 - z626 * z1298 - z641 * z1306;
    const Scalar z1581 = z465 * z1355 - z626 * z1334 - z641 * z1348;
    const Scalar z1582 = z1401 * z1448 - z1408 * z1452 + z1412 * z1450 + z1466 * z1456;
    const Scalar z1583 = z1576 - z1547;
    const Scalar z1584 = z1008 * z1440 + z1422 * z1441 - z1413 * z1448 + z1423 * z1452 - z1424 * z1450 - z1469 * z1456;
    const Scalar z1585 = z1577 + z1548;
    const Scalar z1586 = z1008 * z1431 + z1422 * z1444 - z1413 * z1446 + z1423 * z1449 - z1424 * z1447 + z1469 * z1457;
    const Scalar z1587 = z1422 * z1451 + z1413 * z1454 + z1423 * z1453 + z1424 * z1455 + z1469 * z1458;
    const Scalar z1588 = z1434 * z1448 - z1435 * z1441 - z1459 * z1452 + z1462 * z1450 + z1476 * z1456;
    const Scalar z1589 = z695 - z1559;
    const Scalar z1590 = z1401 * z1446 - z1408 * z1449 + z1412 * z1447 - z1466 * z1457;
    const Scalar z1591 = z1401 * z1454 + z1408 * z1453 + z1412 * z1455 + z1466 * z1458;
    const Scalar z1592 = z1578 - z1549;
    const Scalar z1593 = z1579 + z1550;
    const Scalar z1594 = z1434 * z1446 - z1435 * z1444 - z1459 * z1449 + z1462 * z1447 - z1476 * z1457;
    const Scalar z1595 = z1435 * z1451 + z1434 * z1454 + z1459 * z1453 + z1462 * z1455 + z1476 * z1458;
    const Scalar z1596 = z910 * z1440 + z1442 * z1448 + z1463 * z1450 + z1477 * z1456 - z1460 * z1452 + z1439 * z1441;
    const Scalar z1597 = z910 * z1431 + z1442 * z1446 + z1463 * z1447 - z1477 * z1457 - z1460 * z1449 + z1439 * z1444;
    const Scalar z1598 = z1442 * z1454 + z1463 * z1455 + z1477 * z1458 + z1460 * z1453 - z1439 * z1451;
    const Scalar z1599 = z1560 - z1541;
    const Scalar z1600 = z1561 + z1542;
    const Scalar z1601 = z731 - z1562;
    const Scalar z1602 = z806 - z1563;
    const Scalar z1603 = z734 + z1569;
    const Scalar z1604 = z733 + z1570;
    const Scalar z1605 = z1571 + z1545;
    const Scalar z1606 = z1572 - z1546;
    const Scalar z1607 = z740 + z1575;
    const Scalar z1608 = z1580 - z1551;
    const Scalar z1609 = z1581 - z1552;
    const Scalar z1610 = z92 * z1554 + z1291 * z1539 + z1315 * z1599 - z1309 * z1567 - z1257 * z1605 - z1305 * z1583
        + z1592;
    const Scalar z1611 = z92 * z1556 + z1291 * z1540 + z1315 * z1600 - z1309 * z1568 - z1257 * z1606 - z1305 * z1585
        + z1593;
    const Scalar z1612 = z92 * z903 - z970 + z917 * z1257 - z904 * z1291 - z972 * z1305 + z905 * z1309 - z906 * z1315;
    const Scalar z1613 = z1589 + z1291 * z1532 - z1309 * z1558 + z1315 * z1603 + z1257 * z1604 - z1305 * z1574;
    const Scalar z1614 = z1612 + z1596;
    const Scalar z1615 = z1299 * z1558 - z1287 * z1532 - z1304 * z1603 + z1272 * z1604 + z1295 * z1574 - z1607;
    const Scalar z1616 = z1284 * z1532 - z1601 + z1332 * z1558 - z1338 * z1603 + z1329 * z1574;
    const Scalar z1617 = z1287 * z1539 + z1304 * z1599 - z1299 * z1567 + z1272 * z1605 - z1295 * z1583 - z1608;
    const Scalar z1618 = z1602 + z1284 * z1539 - z1338 * z1599 + z1332 * z1567 + z1329 * z1583;
    const Scalar z1619 = z1287 * z1540 + z1304 * z1600 - z1299 * z1568 + z1272 * z1606 - z1295 * z1585 - z1609;
    const Scalar z1620 = z917 * z1272 - z909 + z904 * z1287 + z972 * z1295 - z905 * z1299 + z906 * z1304;
    const Scalar z1621 = z1284 * z1540 - z1564 - z1338 * z1600 + z1332 * z1568 + z1329 * z1585;
    const Scalar z1622 = z904 * z1284 - z916 - z972 * z1329 + z905 * z1332 - z906 * z1338;
    const Scalar z1623 = z1620 - z1597;
    const Scalar z1624 = z1622 - z1598;
    const Scalar z1625 = z1582 + z1613;
    const Scalar z1626 = z1584 + z1610;
    const Scalar z1627 = z1588 - z1611;
    const Scalar z1628 = z1590 - z1615;
    const Scalar z1629 = z1586 + z1617;
    const Scalar z1630 = z1594 - z1619;
    const Scalar z1631 = z1591 + z1616;
    const Scalar z1632 = z1587 - z1618;
    const Scalar z1633 = z1595 - z1621;
    const Scalar z1634 = n1 / z1492;
    const Scalar z1635 = z1497 * z1634;
    const Scalar z1636 = z1498 * z1634;
    const Scalar z1637 = z1461 - z1498 * z1636;
    const Scalar z1638 = z1468 + z1498 * z1635;
    const Scalar z1639 = z1467 + z1497 * z1635;
    const Scalar z1640 = z1517 + z1518 * z1635;
    const Scalar z1641 = z1528 - z1529 * z1635;
    const Scalar z1642 = z1628 - z1631 * z1635;
    const Scalar z1643 = n1 / z1639;
    const Scalar z1644 = z1533 - z1534 * z1635;
    const Scalar z1645 = z1629 + z1632 * z1635;
    const Scalar z1646 = z1630 - z1633 * z1635;
    const Scalar z1647 = z1638 * z1643;
    const Scalar z1648 = z1637 + z1638 * z1647;
    const Scalar z1649 = z1514 + z1518 * z1636 - z1647 * z1640;
    const Scalar z1650 = z1520 - z1529 * z1636 - z1647 * z1641;
    const Scalar z1651 = z1625 - z1631 * z1636 - z1647 * z1642;
    const Scalar z1652 = z1522 - z1534 * z1636 - z1647 * z1644;
    const Scalar z1653 = z1626 + z1632 * z1636 - z1647 * z1645;
    const Scalar z1654 = z1627 - z1633 * z1636 - z1647 * z1646;
    const Scalar z1655 = n1 / z1648;
    const Scalar z1656 = z1655 * z1649;
    const Scalar z1657 = z1655 * z1650;
    const Scalar z1658 = z1655 * z1651;
    const Scalar z1659 = z1655 * z1652;
    const Scalar z1660 = z1655 * z1653;
    const Scalar z1661 = z1655 * z1654;
    const Scalar z1662 = z1643 * z1640 + z1647 * z1656;
    const Scalar z1663 = z1643 * z1641 + z1647 * z1657;
    const Scalar z1664 = z1643 * z1642 + z1647 * z1658;
    const Scalar z1665 = z1643 * z1644 + z1647 * z1659;
    const Scalar z1666 = z1643 * z1645 + z1647 * z1660;
    const Scalar z1667 = z1643 * z1646 + z1647 * z1661;
    const Scalar z1668 = z1518 * z1634 + z1636 * z1656 - z1635 * z1662;
    const Scalar z1669 = z1529 * z1634 - z1636 * z1657 + z1635 * z1663;
    const Scalar z1670 = z1631 * z1634 - z1636 * z1658 + z1635 * z1664;
    const Scalar z1671 = z1534 * z1634 - z1636 * z1659 + z1635 * z1665;
    const Scalar z1672 = z1632 * z1634 + z1636 * z1660 - z1635 * z1666;
    const Scalar z1673 = z1633 * z1634 - z1636 * z1661 + z1635 * z1667;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z492;
    result.M[4] = z446;
    result.M[5] = z423;
    result.M[6] = z386;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z494;
    result.M[13] = -z447;
    result.M[14] = -z425;
    result.M[15] = -z397;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z440;
    result.M[23] = z422;
    result.M[24] = z396;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z492;
    result.M[28] = -z494;
    result.M[29] = n0;
    result.M[30] = z467;
    result.M[31] = -z442;
    result.M[32] = z426;
    result.M[33] = -z393;
    result.M[34] = z419;
    result.M[35] = z389;
    result.M[36] = z446;
    result.M[37] = -z447;
    result.M[38] = z440;
    result.M[39] = -z442;
    result.M[40] = z436;
    result.M[41] = -z420;
    result.M[42] = z395;
    result.M[43] = n0;
    result.M[44] = -z427;
    result.M[45] = z423;
    result.M[46] = -z425;
    result.M[47] = z422;
    result.M[48] = z426;
    result.M[49] = -z420;
    result.M[50] = z408;
    result.M[51] = -z358;
    result.M[52] = n0_12;
    result.M[53] = z366;
    result.M[54] = z386;
    result.M[55] = -z397;
    result.M[56] = z396;
    result.M[57] = -z393;
    result.M[58] = z395;
    result.M[59] = -z358;
    result.M[60] = k18;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z419;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z389;
    result.M[76] = -z427;
    result.M[77] = z366;
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
    result.C[27] = z600;
    result.C[28] = z601;
    result.C[29] = n0;
    result.C[30] = z591;
    result.C[31] = z574;
    result.C[32] = -z613;
    result.C[33] = z641;
    result.C[34] = z682;
    result.C[35] = -z684;
    result.C[36] = z599;
    result.C[37] = z598;
    result.C[38] = z565;
    result.C[39] = z592;
    result.C[40] = -z615;
    result.C[41] = z590;
    result.C[42] = -z640;
    result.C[43] = z683;
    result.C[44] = z681;
    result.C[45] = z645;
    result.C[46] = -z646;
    result.C[47] = z636;
    result.C[48] = -z672;
    result.C[49] = z670;
    result.C[50] = -z588;
    result.C[51] = z626;
    result.C[52] = n0;
    result.C[53] = z676;
    result.C[54] = z663;
    result.C[55] = z664;
    result.C[56] = -z661;
    result.C[57] = -z699;
    result.C[58] = -z698;
    result.C[59] = -z667;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = -z671;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z682;
    result.C[67] = z649;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = -z684;
    result.C[76] = z677;
    result.C[77] = -z675;
    result.C[78] = z465;
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
    result.K[27] = z438;
    result.K[28] = z437;
    result.K[29] = n0;
    result.K[30] = z737;
    result.K[31] = z695;
    result.K[32] = z733;
    result.K[33] = z740;
    result.K[34] = z731;
    result.K[35] = z734;
    result.K[36] = z603;
    result.K[37] = z604;
    result.K[38] = z578;
    result.K[39] = -z742;
    result.K[40] = -z810;
    result.K[41] = -z814;
    result.K[42] = z842;
    result.K[43] = -z806;
    result.K[44] = -z803;
    result.K[45] = z605;
    result.K[46] = -z606;
    result.K[47] = -z597;
    result.K[48] = z808;
    result.K[49] = z868;
    result.K[50] = z841;
    result.K[51] = z899;
    result.K[52] = n0;
    result.K[53] = z867;
    result.K[54] = z647;
    result.K[55] = -z648;
    result.K[56] = -z643;
    result.K[57] = z865;
    result.K[58] = z919;
    result.K[59] = z897;
    result.K[60] = z941;
    result.K[61] = n0;
    result.K[62] = z894;
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
    result.F[0] = -z904;
    result.F[1] = -z905;
    result.F[2] = z903;
    result.F[3] = z972;
    result.F[4] = -z970;
    result.F[5] = z917;
    result.F[6] = z909;
    result.F[7] = -z916;
    result.F[8] = -z906;
    result.M_r[0] = z1461;
    result.M_r[1] = -z1468;
    result.M_r[2] = -z1498;
    result.M_r[3] = -z1468;
    result.M_r[4] = -z1467;
    result.M_r[5] = -z1497;
    result.M_r[6] = -z1498;
    result.M_r[7] = -z1497;
    result.M_r[8] = z1492;
    result.C_r[0] = z1514;
    result.C_r[1] = z1517;
    result.C_r[2] = z1518;
    result.C_r[3] = z1520;
    result.C_r[4] = z1528;
    result.C_r[5] = -z1529;
    result.C_r[6] = z1522;
    result.C_r[7] = z1533;
    result.C_r[8] = -z1534;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z1625;
    result.K_r[7] = z1628;
    result.K_r[8] = -z1631;
    result.K_r[9] = z1626;
    result.K_r[10] = z1629;
    result.K_r[11] = z1632;
    result.K_r[12] = z1627;
    result.K_r[13] = z1630;
    result.K_r[14] = -z1633;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = z1614;
    result.F_r[1] = -z1623;
    result.F_r[2] = z1624;
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
    result.A[20] = z1290;
    result.A[21] = -z1302;
    result.A[22] = -z1300;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z1308;
    result.A[27] = -z1658;
    result.A[28] = z1664;
    result.A[29] = z1670;
    result.A[30] = -z1297;
    result.A[31] = z1311;
    result.A[32] = z1306;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z1313;
    result.A[37] = -z1660;
    result.A[38] = z1666;
    result.A[39] = -z1672;
    result.A[40] = z1341;
    result.A[41] = -z1353;
    result.A[42] = -z1348;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z1355;
    result.A[47] = -z1661;
    result.A[48] = z1667;
    result.A[49] = z1673;
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
    result.A[70] = z1291;
    result.A[71] = -z1309;
    result.A[72] = -z1305;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z1656;
    result.A[78] = z1662;
    result.A[79] = -z1668;
    result.A[80] = z1287;
    result.A[81] = -z1299;
    result.A[82] = -z1295;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z1304;
    result.A[87] = -z1657;
    result.A[88] = z1663;
    result.A[89] = z1669;
    result.A[90] = -z1284;
    result.A[91] = -z1332;
    result.A[92] = -z1329;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z1338;
    result.A[97] = -z1659;
    result.A[98] = z1665;
    result.A[99] = z1671;
    if (!(traits::regular(z1250, z1266) && traits::regular(z1238, z1242) && traits::regular(z1255, z1243)
        && traits::regular(z1270, z1268) && traits::regular(z1648, z1461) && traits::regular(-z1639, -z1467)
        && traits::regular(z1492, z1492))) return torsor::Status::singular;
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
