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
//   forward_dynamics       1016             1367         26             2                  5       0   2421    2487
//   energy                  109              161          0             0                  6       0    282     302
//   first_integrals         110              161          0             0                  6       0    283     303
//   constraints             339              520         14             2                  4       0    883     941
//   linearisation          2634             3464        104             2                  7       0   6218    6618
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
  static constexpr unsigned long long fingerprint = 0xe830582695e5d76bULL ^ torsor::support_fingerprint;
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
  /// 2^-40 of those of its unit (a change point).
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
    const Scalar n0_12 = traits::constant(0.12, 0.12f, "3/25");
    const Scalar k11 = traits::constant(0.20061665139658788, 0.20061666f,
        "1382180435281049145907121109643576521220371021393405956792663939457042810632956483/6889659585378552357172375771275447678187583839499477142856648645759486220845080125");
    const Scalar n0_28 = traits::constant(0.28, 0.28f, "7/25");
    const Scalar k13 = traits::constant(0.9534570696121847, 0.95345706f,
        "525519571112042718940803777777202731020156921024515291029654726624274787160578631/551172766830284188573790061702035814255006707159958171428531891660758897667606410");
    const Scalar k14 = traits::constant(0.005950872541725462, 0.0059508723f,
        "11298900081976005488039590346701483956312571499395628412519783507493819739182003600879011813971315003255906388553830486116652719658788633777063662087724795679803439/1898696368095942639087092253868002940016956219669453150142723260368036152458294888778615521037238951749780791102237100178156974029401684305956122807236616706800625000");
    const Scalar k15 = traits::constant(0.010397316014267795, 0.010397316f,
        "9870673077118022362064038943628123859779194979891059919709477732499388673643976711565585013906694661093800952941105542740091657643756066142827550216880165139488051/949348184047971319543546126934001470008478109834726575071361630184018076229147444389307760518619475874890395551118550089078487014700842152978061403618308353400312500");
    const Scalar k16 = traits::constant(46.686007365934024, 46.68601f,
        "12866027926070442963751385859967080732345328859301894534751105534737425465833752936/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
    const Scalar k17 = traits::constant(40.23024469547104, 40.230244f,
        "1108690763953106891919173818010564632270624322560169545605282827304553786348861088751/27558638341514209428689503085101790712750335357997908571426594583037944883380320500");
    const Scalar n0_1435 = traits::constant(0.1435, 0.1435f, "287/2000");
    const Scalar k19 = traits::constant(0.14689731601426778, 0.14689732f,
        "557826800798664429919032341080477298063745827889324949667801361010471424315690411482824377298793012472065359782675150519597220540601684080097331727243117021514522829/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k20 = traits::constant(0.13310268398573222, 0.13310269f,
        "505443165335063447969739321085604348345749655125568814412123664795628821060954726233200314482060800507811883234577625580170684915863259131238097044809388334293827171/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k21 = traits::constant(0.1538973160142678, 0.15389732f,
        "584408549952007626866251632634629339223983214964697293769799486655623930450106539925724994593314357796562290858106469922091418177013307660380717446544429655409731579/3797392736191885278174184507736005880033912439338906300285446520736072304916589777557231042074477903499561582204474200356313948058803368611912245614473233413601250000");
    const Scalar k22 = traits::constant(29.520037258278602, 29.520037f,
        "22419835011340195864938008360375209703633812617890927422714863973332510398067221674363493503543408565365030137642361868510789955371931686079970032045188759748777393/759478547238377055634836901547201176006782487867781260057089304147214460983317955511446208414895580699912316440894840071262789611760673722382449122894646682720250");
    const Scalar k23 = traits::constant(22.569969249659824, 22.56997f,
        "342828149138929719688783421449433478383028442784206544289031539175655916942927043559135766444260552962888647402643521015968905122464918622479097614868309626665425561/15189570944767541112696738030944023520135649757355625201141786082944289219666359110228924168297911613998246328817896801425255792235213474447648982457892933654405000");
    const Scalar k24 = traits::constant(1.9069141392243694, 1.9069141f,
        "525519571112042718940803777777202731020156921024515291029654726624274787160578631/275586383415142094286895030851017907127503353579979085714265945830379448833803205");
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
    const Scalar z15 = n1 - s_roll * s_roll;
    const Scalar z16 = c_yaw * c_roll;
    const Scalar z17 = v_roll * s_roll;
    const Scalar z18 = v_yaw * c_yaw;
    const Scalar z19 = v_roll * c_roll;
    const Scalar z20 = v_yaw * s_yaw;
    const Scalar z21 = s_yaw * s_roll;
    const Scalar z22 = n2 * s_roll;
    const Scalar z23 = c_yaw * s_roll;
    const Scalar z24 = s_roll * z14;
    const Scalar z25 = s_roll * z16;
    const Scalar z26 = s_yaw * z17 - c_roll * z18;
    const Scalar z27 = c_yaw * z17 + c_roll * z20;
    const Scalar z28 = z19 * z22;
    const Scalar z29 = s_roll * z21 - c_roll * z14;
    const Scalar z30 = s_roll * z23 - c_roll * z16;
    const Scalar z31 = c_roll * z22;
    const Scalar z32 = v_roll * z19;
    const Scalar z33 = v_yaw * z20;
    const Scalar z34 = n2 * z17;
    const Scalar z35 = v_roll * z17;
    const Scalar z36 = n2 * z19;
    const Scalar z37 = v_yaw * z18;
    const Scalar z38 = n0_08 * z9 - n0_35 * z10;
    const Scalar z39 = s_pitch * z10 - c_pitch * z9;
    const Scalar z40 = s_pitch * z9 + c_pitch * z10;
    const Scalar z41 = z15 * z15 + z24 * z24 + z25 * z25;
    const Scalar z42 = s_yaw * z32 + c_roll * z33 + z18 * z34;
    const Scalar z43 = c_yaw * z32 + c_roll * z37 - z20 * z34;
    const Scalar z44 = n2 * (s_roll * z35 - z19 * z19);
    const Scalar z45 = n0_08 * z11 - n0_35 * z12;
    const Scalar z46 = n0_08 * z12 - n0_35 * z13;
    const Scalar z47 = s_roll * z26 - z14 * z19;
    const Scalar z48 = s_roll * z27 - z16 * z19;
    const Scalar z49 = n2 * (z15 * z31 + z24 * z29 + z25 * z30);
    const Scalar z50 = s_roll * z40 - c_roll * c_steer;
    const Scalar z51 = s_roll * c_steer + c_roll * z40;
    const Scalar z52 = n0_3 + z46;
    const Scalar z53 = n1_1 - z45;
    const Scalar z54 = traits::sqrt(z41);
    const Scalar z55 = n2 * (z15 * z28 + z24 * z47 + z25 * z48);
    const Scalar z56 = z14 * z35 + z26 * z36 + s_roll * z42;
    const Scalar z57 = z16 * z35 + z27 * z36 + s_roll * z43;
    const Scalar z58 = c_yaw * z39 + s_yaw * z50;
    const Scalar z59 = n2 * (z24 * z56 + z25 * z57 - z15 * z44 - z47 * z47 - z48 * z48 - z28 * z28);
    const Scalar z60 = z51 * z58;
    const Scalar z61 = s_yaw * z39 - c_yaw * z50;
    const Scalar z62 = z51 * z61;
    const Scalar z63 = s_pitch * z53 - c_pitch * z52;
    const Scalar z64 = s_roll * z63 - c_roll * z38;
    const Scalar z65 = s_pitch * z52 + c_pitch * z53;
    const Scalar z66 = n0_5 * z49 / z54;
    const Scalar z67 = s_roll * z38 + c_roll * z63;
    const Scalar z68 = q_z - z67;
    const Scalar z69 = n0_3 / z54;
    const Scalar z70 = n1 - z51 * z51;
    const Scalar z71 = s_yaw * z64 - c_yaw * z65;
    const Scalar z72 = s_yaw * z65 + c_yaw * z64;
    const Scalar z73 = n0_5 * z55 / z54;
    const Scalar z74 = q_y + z72;
    const Scalar z75 = q_x - z71;
    const Scalar z76 = q_x + z24 * z69;
    const Scalar z77 = z70 * z70 + z60 * z60 + z62 * z62;
    const Scalar z78 = n0_5 * (z55 * z73 / (z54 * z54) + z59 / z54);
    const Scalar z79 = n0_3 * z66;
    const Scalar z80 = q_z + z15 * z69;
    const Scalar z81 = q_y - z25 * z69;
    const Scalar z82 = traits::sqrt(z77);
    const Scalar z83 = c_yaw * z51;
    const Scalar z84 = n2 * z51;
    const Scalar z85 = v_pitch * c_pitch;
    const Scalar z86 = v_pitch * s_pitch;
    const Scalar z87 = v_steer * c_steer;
    const Scalar z88 = v_steer * s_steer;
    const Scalar z89 = s_yaw * z51;
    const Scalar z90 = z50 * z58 - z51 * z89;
    const Scalar z91 = z5 * z87;
    const Scalar z92 = z4 * z87;
    const Scalar z93 = z9 * z85 - z10 * z86 + s_pitch * z91 + c_pitch * z92;
    const Scalar z94 = z9 * z86 + z10 * z85 + s_pitch * z92 - c_pitch * z91;
    const Scalar z95 = z7 * z88;
    const Scalar z96 = -z88 * (n1 - z6);
    const Scalar z97 = n0_35 * z95 + n0_08 * z96;
    const Scalar z98 = n0_3 * z78;
    const Scalar z99 = z51 * z83 + z50 * z61;
    const Scalar z100 = n0_35 / z82;
    const Scalar z101 = z5 * c_steer;
    const Scalar z102 = z4 * c_steer;
    const Scalar z103 = s_roll * z39;
    const Scalar z104 = s_pitch * z101 + c_pitch * z102;
    const Scalar z105 = s_yaw * z103 - c_yaw * z40;
    const Scalar z106 = s_yaw * z40 + c_yaw * z103;
    const Scalar z107 = c_roll * z39;
    const Scalar z108 = z51 * z106 - z61 * z107;
    const Scalar z109 = z50 * z84;
    const Scalar z110 = n2 * (z62 * z99 - z70 * z109 + z60 * z90);
    const Scalar z111 = z51 * z105 + z58 * z107;
    const Scalar z112 = z84 * z107;
    const Scalar z113 = z75 - z60 * z100;
    const Scalar z114 = z68 + z70 * z100;
    const Scalar z115 = n2 * (z60 * z111 - z62 * z108 - z70 * z112);
    const Scalar z116 = z74 - z62 * z100;
    const Scalar z117 = n0_5 * z110 / z82;
    const Scalar z118 = s_pitch * z102 - c_pitch * z101;
    const Scalar z119 = n0_08 * z101 - n0_35 * z102;
    const Scalar z120 = c_roll * s_steer + s_roll * z104;
    const Scalar z121 = s_roll * s_steer - c_roll * z104;
    const Scalar z122 = c_yaw * z118 + s_yaw * z120;
    const Scalar z123 = s_yaw * z118 - c_yaw * z120;
    const Scalar z124 = z51 * z122 - z58 * z121;
    const Scalar z125 = n0_5 * z115 / z82;
    const Scalar z126 = s_steer * z7;
    const Scalar z127 = s_steer * (n1 - z6);
    const Scalar z128 = n0_08 * z127 - n0_35 * z126;
    const Scalar z129 = s_steer * (n1 - z8);
    const Scalar z130 = n0_08 * z126 - n0_35 * z129;
    const Scalar z131 = z64 - n0_35 * z117;
    const Scalar z132 = c_roll * z88 + c_steer * z17 + z19 * z40 + s_roll * z93;
    const Scalar z133 = c_pitch * z130 + s_pitch * z128;
    const Scalar z134 = z18 * z39 + z20 * z50 + s_yaw * z94 - c_yaw * z132;
    const Scalar z135 = s_roll * z119 + c_roll * z133;
    const Scalar z136 = s_roll * z88 - c_steer * z19 + z17 * z40 - c_roll * z93;
    const Scalar z137 = z18 * z50 - z20 * z39 + c_yaw * z94 + s_yaw * z132;
    const Scalar z138 = z136 * z84;
    const Scalar z139 = z51 * z134 - z61 * z136;
    const Scalar z140 = -z88 * (n1 - z8);
    const Scalar z141 = n0_08 * z95 + n0_35 * z140;
    const Scalar z142 = c_roll * z65;
    const Scalar z143 = z142 + n0_35 * z125;
    const Scalar z144 = z51 * z137 - z58 * z136;
    const Scalar z145 = n0_08 * z91 - n0_35 * z92;
    const Scalar z146 = z84 * z121;
    const Scalar z147 = z51 * z123 - z61 * z121;
    const Scalar z148 = n2 * (z70 * z146 + z60 * z124 + z62 * z147);
    const Scalar z149 = v_steer * z88;
    const Scalar z150 = z5 * z149;
    const Scalar z151 = z4 * z149;
    const Scalar z152 = n2 * (z70 * z138 + z62 * z139 + z60 * z144);
    const Scalar z153 = s_pitch * z97 - c_pitch * z141 - z53 * z85 - z52 * z86;
    const Scalar z154 = v_steer * z87;
    const Scalar z155 = n0_5 * z152 / z82;
    const Scalar z156 = n0_5 * z148 / z82;
    const Scalar z157 = z19 * z38 + s_roll * z145 - z17 * z63 - c_roll * z153;
    const Scalar z158 = v_z - z157;
    const Scalar z159 = n0_3 * z73 / (z54 * z54);
    const Scalar z160 = v_z - z69 * z28 + z15 * z159;
    const Scalar z161 = v_y + z69 * z48 - z25 * z159;
    const Scalar z162 = v_x - z69 * z47 + z24 * z159;
    const Scalar z163 = q_z - z80;
    const Scalar z164 = q_x - z76;
    const Scalar z165 = q_y - z81;
    const Scalar z166 = v_z - z160;
    const Scalar z167 = v_y - z161;
    const Scalar z168 = v_x - z162;
    const Scalar z169 = s_pitch * z4 - c_pitch * z5;
    const Scalar z170 = z135 - n0_35 * z156;
    const Scalar z171 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z172 = s_roll * z171;
    const Scalar z173 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z174 = s_roll * z169;
    const Scalar z175 = s_pitch * z5 + c_pitch * z4;
    const Scalar z176 = q_x - z113;
    const Scalar z177 = c_roll * z169;
    const Scalar z178 = q_z - z114;
    const Scalar z179 = s_yaw * z174 - c_yaw * z175;
    const Scalar z180 = c_yaw * z178;
    const Scalar z181 = s_roll * z176 + z14 * z178;
    const Scalar z182 = q_y - z116;
    const Scalar z183 = s_yaw * z175 + c_yaw * z174;
    const Scalar z184 = s_yaw * z178;
    const Scalar z185 = s_roll * z182 - z16 * z178;
    const Scalar z186 = c_yaw * z163;
    const Scalar z187 = s_yaw * z163;
    const Scalar z188 = v_pitch * z86;
    const Scalar z189 = v_pitch * z85;
    const Scalar z190 = z9 * z188 + z10 * z189 + s_pitch * z150 + c_pitch * z151 - n2 * (z91 * z85 - z92 * z86);
    const Scalar z191 = z10 * z188 - z9 * z189 + s_pitch * z151 - c_pitch * z150 - n2 * (z91 * z86 + z92 * z85);
    const Scalar z192 = n0_08 * z150 - n0_35 * z151;
    const Scalar z193 = s_yaw * z172 - c_yaw * z173;
    const Scalar z194 = c_roll * z171;
    const Scalar z195 = s_roll * z164 + z14 * z163;
    const Scalar z196 = n2 * z136;
    const Scalar z197 = s_roll * z165 - z16 * z163;
    const Scalar z198 = z35 * z40 - c_roll * z154 - c_steer * z32 - n2 * (z19 * z93 - z17 * z88) + s_roll * z190;
    const Scalar z199 = s_roll * z154 + c_steer * z35 + z32 * z40 + n2 * (z19 * z88 + z17 * z93) + c_roll * z190;
    const Scalar z200 = z33 * z39 - z37 * z50 - n2 * (z18 * z94 + z20 * z132) + s_yaw * z191 - c_yaw * z198;
    const Scalar z201 = z37 * z39 + z33 * z50 - n2 * (z18 * z132 - z20 * z94) + c_yaw * z191 + s_yaw * z198;
    const Scalar z202 = z134 * z196 + z61 * z199 + z51 * z200;
    const Scalar z203 = z137 * z196 + z58 * z199 + z51 * z201;
    const Scalar z204 = n2 * (z51 * z199 - z136 * z136);
    const Scalar z205 = n2 * (z62 * z202 - z138 * z138 - z139 * z139 - z144 * z144 - z70 * z204 + z60 * z203);
    const Scalar z206 = z7 * z154;
    const Scalar z207 = -z154 * (n1 - z6);
    const Scalar z208 = q_z - z194;
    const Scalar z209 = n0_35 * z206 + n0_08 * z207;
    const Scalar z210 = -z154 * (n1 - z8);
    const Scalar z211 = n0_08 * z206 + n0_35 * z210;
    const Scalar z212 = q_x - z193;
    const Scalar z213 = z113 - z212;
    const Scalar z214 = z114 - z208;
    const Scalar z215 = s_yaw * z173 + c_yaw * z172;
    const Scalar z216 = s_pitch * z209 - z52 * z189 - c_pitch * z211 + z53 * z188 + n2 * (z85 * z97 + z86 * z141);
    const Scalar z217 = q_y + z215;
    const Scalar z218 = n0_5 * (z152 * z155 / (z82 * z82) + z205 / z82);
    const Scalar z219 = z116 - z217;
    const Scalar z220 = z177 * z219 + z183 * z214;
    const Scalar z221 = z18 * z163 + s_yaw * z166;
    const Scalar z222 = c_yaw * z166 - z20 * z163;
    const Scalar z223 = z19 * z165 + z27 * z163 + s_roll * z167 - z16 * z166;
    const Scalar z224 = z35 * z38 + s_roll * z192 + z32 * z63 - n2 * (z19 * z145 + z17 * z153) + c_roll * z216;
    const Scalar z225 = c_roll * z145 - z17 * z38 - z19 * z63 + s_roll * z153;
    const Scalar z226 = s_pitch * z141 + c_pitch * z97 + z53 * z86 - z52 * z85;
    const Scalar z227 = v_yaw * z167 - v_roll * z221 + z223 * (v_pitch + v_rear);
    const Scalar z228 = z75 - z113;
    const Scalar z229 = z68 - z114;
    const Scalar z230 = z74 - z116;
    const Scalar z231 = n0_35 * z155 / (z82 * z82);
    const Scalar z232 = z19 * z164 - z26 * z163 + s_roll * z168 + z14 * z166;
    const Scalar z233 = v_yaw * z168 - v_roll * z222 + z232 * (v_pitch + v_rear);
    const Scalar z234 = z224 - n0_35 * z218;
    const Scalar z235 = z70 * z231 - z158 - z100 * z138;
    const Scalar z236 = z158 + z235;
    const Scalar z237 = z177 * z213 - z179 * z214;
    const Scalar z238 = z51 * z228 - z58 * z229;
    const Scalar z239 = z51 * z230 - z61 * z229;
    const Scalar z240 = v_yaw * c_roll;
    const Scalar z241 = v_yaw * s_roll;
    const Scalar z242 = v_roll * z2 - z1 * z240;
    const Scalar z243 = v_pitch + z241;  // angular velocity of frame, z
    const Scalar z244 = v_roll * z241;  // angular acceleration of frame.2, y
    const Scalar z245 = v_roll * z1 + z2 * z240;
    const Scalar z246 = z2 * z244;
    const Scalar z247 = z1 * z244;
    const Scalar z248 = v_roll * z240;  // angular acceleration of frame.2, x
    const Scalar z249 = n9_81 * c_roll;
    const Scalar z250 = v_pitch * z242 - z246;  // angular acceleration of frame, y
    const Scalar z251 = v_pitch * z245 - z247;  // angular acceleration of frame, x
    const Scalar z252 = z2 * z249;
    const Scalar z253 = z1 * z249;
    const Scalar z254 = z245 * z245;
    const Scalar z255 = z243 * z243;
    const Scalar z256 = v_rear + z243;  // angular velocity of rear_wheel, z
    const Scalar z257 = n9_81 * s_roll;
    const Scalar z258 = n0_3 * z85 - n1_1 * z86;
    const Scalar z259 = s_yaw * z225 - c_yaw * z226 - z18 * z64 - z20 * z65;
    const Scalar z260 = s_yaw * z226 - z18 * z65 + z20 * z64 + c_yaw * z225;
    const Scalar z261 = v_x + z259;
    const Scalar z262 = z261 - z100 * z144 + z60 * z231;
    const Scalar z263 = v_y - z260;
    const Scalar z264 = z263 - z100 * z139 + z62 * z231;
    const Scalar z265 = z242 * z245;
    const Scalar z266 = z248 - z265;
    const Scalar z267 = z254 + z255;
    const Scalar z268 = z242 * z243;
    const Scalar z269 = z4 * z86 - z5 * z85;
    const Scalar z270 = z261 - z262;
    const Scalar z271 = z4 * z85 + z5 * z86;
    const Scalar z272 = n1_1 * z85 + n0_3 * z86;
    const Scalar z273 = z51 * z270 - z136 * z228 - z137 * z229 - z58 * z236;
    const Scalar z274 = z263 - z264;
    const Scalar z275 = z51 * z274 - z136 * z230 - z134 * z229 - z61 * z236;
    const Scalar z276 = z19 * z171 + s_roll * z272;
    const Scalar z277 = c_roll * z272 - z17 * z171;
    const Scalar z278 = c_roll * z271 - z17 * z169;
    const Scalar z279 = z19 * z169 + s_roll * z271;
    const Scalar z280 = v_z - z277;
    const Scalar z281 = z235 + z280;
    const Scalar z282 = v_z + z235;
    const Scalar z283 = z20 * z173 - c_yaw * z258 + z18 * z172 + s_yaw * z276;
    const Scalar z284 = z18 * z173 + s_yaw * z258 - z20 * z172 + c_yaw * z276;
    const Scalar z285 = v_x - z283;
    const Scalar z286 = z262 - z285;
    const Scalar z287 = v_x - z262;
    const Scalar z288 = z19 * z176 - z26 * z178 + s_roll * z287 + z14 * z282;
    const Scalar z289 = v_y + z284;
    const Scalar z290 = z264 - z289;
    const Scalar z291 = v_y - z264;
    const Scalar z292 = z19 * z182 + z27 * z178 + s_roll * z291 - z16 * z282;
    const Scalar z293 = z250 + z268;
    const Scalar z294 = s_steer * z243 + c_steer * z242;
    const Scalar z295 = s_steer * z242 - c_steer * z243;
    const Scalar z296 = z20 * z175 + c_yaw * z269 + z18 * z174 + s_yaw * z279;
    const Scalar z297 = s_yaw * z269 - z18 * z175 + z20 * z174 - c_yaw * z279;
    const Scalar z298 = z213 * z278 - z214 * z296 + z177 * z286 + z179 * z281;
    const Scalar z299 = z219 * z278 - z214 * z297 + z177 * z290 - z183 * z281;
    const Scalar z300 = z18 * z178 + s_yaw * z282;
    const Scalar z301 = c_yaw * z282 - z20 * z178;
    const Scalar z302 = v_yaw * z287 + v_pitch * z288 + v_steer * z298 - v_roll * z301 + v_front * z273;
    const Scalar z303 = v_yaw * z291 - v_roll * z300 + v_pitch * z292 + v_steer * z299 + v_front * z275;
    const Scalar z304 = z241 * z240;
    const Scalar z305 = z245 * z243;
    const Scalar z306 = z251 + z305;
    const Scalar z307 = n2 * z244;
    const Scalar z308 = v_steer + z245;  // angular velocity of fork, z
    const Scalar z309 = z245 * z256;
    const Scalar z310 = z242 * z256;
    const Scalar z311 = n0_12 * z310;  // moment on rear_wheel, y
    const Scalar z312 = z242 * z242;
    const Scalar z313 = n0_12 * z309;  // moment on rear_wheel, x
    const Scalar z314 = z255 + z312;
    const Scalar z315 = z254 - z312;
    const Scalar z316 = z294 * z295;
    const Scalar z317 = z295 * z295;
    const Scalar z318 = z308 * z308;
    const Scalar z319 = z317 + z318;
    const Scalar z320 = z250 - z316;
    const Scalar z321 = c_steer * z248 + s_steer * z251;
    const Scalar z322 = v_steer * z294 - z321;  // angular acceleration of fork, y
    const Scalar z323 = k11 * z319;  // force on fork, x
    const Scalar z324 = s_steer * z248 - c_steer * z251;
    const Scalar z325 = v_steer * z295 - z324;  // angular acceleration of fork, x
    const Scalar z326 = k11 * z320;  // force on fork, y
    const Scalar z327 = v_front - z295;  // angular velocity of front_wheel, z
    const Scalar z328 = z295 * z308;
    const Scalar z329 = z294 * z308;
    const Scalar z330 = z308 * z327;
    const Scalar z331 = z322 + z329;
    const Scalar z332 = z294 * z327;
    const Scalar z333 = n0_28 * z322;  // moment on front_wheel, z
    const Scalar z334 = z294 * z294;
    const Scalar z335 = z318 - z334;
    const Scalar z336 = n0_28 * z330;  // moment on front_wheel, x
    const Scalar z337 = n0_28 * z332;  // moment on front_wheel, y
    const Scalar z338 = n0_12 * z248;  // moment on rear_wheel, z
    const Scalar z339 = s_steer * z326 + c_steer * z323;
    const Scalar z340 = s_steer * z323 - c_steer * z326;
    const Scalar z341 = z252 + k13 * z266;
    const Scalar z342 = k11 * z341 - z333 - k14 * z335 - k15 * z331;  // moment on fork, y
    const Scalar z343 = k11 * z331;  // force on fork, z
    const Scalar z344 = k16 * z266 - z343 - k17 * z314;  // force on frame, y
    const Scalar z345 = z248 + z265;
    const Scalar z346 = k16 * z267 + z339 + k17 * z345;  // force on frame, x
    const Scalar z347 = z253 - k13 * z267;
    const Scalar z348 = z325 + z328;
    const Scalar z349 = k14 * z320 + z336 + n0_1435 * z348;  // moment on fork, x
    const Scalar z350 = z325 - z328;
    const Scalar z351 = z257 - k13 * z293;
    const Scalar z352 = s_steer * z347 + c_steer * z351;
    const Scalar z353 = k19 * c_steer;
    const Scalar z354 = k19 * s_steer;
    const Scalar z355 = k20 + s_steer * z354;
    const Scalar z356 = k11 * c_steer;
    const Scalar z357 = z337 + k21 * z250 + k20 * z316 + k14 * z350 - k11 * z352;  // moment on fork, z
    const Scalar z358 = k16 * z257 - z311 - k22 * z293 + k23 * z306 + k13 * z340 - z357;  // moment on frame, y
    const Scalar z359 = k16 * z293 - z340 - k17 * z306;  // force on frame, z
    const Scalar z360 = k14 * c_steer;
    const Scalar z361 = k20 + c_steer * z353;
    const Scalar z362 = k24 * z356 + z361;
    const Scalar z363 = s_steer * z353;
    const Scalar z364 = k21 + k24 * z356;
    const Scalar z365 = n0_28 * c_steer;
    const Scalar z366 = k11 * s_steer;
    const Scalar z367 = k13 * z366 + z363;
    const Scalar z368 = k14 * s_steer;
    const Scalar z369 = n0_28 * s_steer;
    const Scalar z370 = k21 + k13 * z356;
    const Scalar z371 = z2 * z369;
    const Scalar z372 = z1 * z369;
    const Scalar z373 = z1 * z370 - z2 * z360;
    const Scalar z374 = s_roll * z365 + c_roll * z372;
    const Scalar z375 = z1 * z360 + z2 * z370;
    const Scalar z376 = s_roll * z368 - c_roll * z375;
    const Scalar z377 = z1 * z366;
    const Scalar z378 = s_roll * z356 + c_roll * z377;
    const Scalar z379 = s_roll * z377 - c_roll * z356;
    const Scalar z380 = z2 * z366;
    const Scalar z381 = z1 * z346 - z2 * z344;
    const Scalar z382 = z1 * z344 + z2 * z346;
    const Scalar z383 = c_steer * z349 + s_steer * z342;
    const Scalar z384 = k17 * z257 + z313 - k23 * z293 + k25 * z306 + z383;  // moment on frame, x
    const Scalar z385 = s_steer * z349 - c_steer * z342;
    // moment on frame, z
    const Scalar z386 = z338 + k26 * z248 - k17 * z253 + k16 * z252 - k27 * z265 + k23 * z315 - k13 * z343 - z385;
    const Scalar z387 = k23 - z360;
    const Scalar z388 = k28 - z355;
    const Scalar z389 = k29 + z362;
    const Scalar z390 = k16 + z356;
    const Scalar z391 = n2 * z387;
    const Scalar z392 = z364 + z388;
    const Scalar z393 = z1 * z367 - z2 * z368;
    const Scalar z394 = z1 * z391 - z2 * z392;
    const Scalar z395 = z1 * z368 + z2 * z367;
    const Scalar z396 = n0_12 + z389;
    const Scalar z397 = s_roll * z396 + c_roll * z393;
    const Scalar z398 = n0_12 * s_roll;
    const Scalar z399 = k17 * z2 + z1 * z390;
    const Scalar z400 = k17 * z1 - z2 * z390;
    const Scalar z401 = z2 * z394;
    const Scalar z402 = z388 + z401;
    const Scalar z403 = z364 + z401;
    const Scalar z404 = c_roll * z400;
    const Scalar z405 = s_roll * z400;
    const Scalar z406 = s_yaw * z380 + c_yaw * z379;
    const Scalar z407 = s_yaw * z379 - c_yaw * z380;
    const Scalar z408 = s_yaw * z399 + c_yaw * z405;
    const Scalar z409 = s_yaw * z405 - c_yaw * z399;
    const Scalar z410 = s_roll * z381 - c_roll * z359;
    const Scalar z411 = s_roll * z359 + c_roll * z381;
    const Scalar z412 = n922_14 - z411;  // force on frame.z, z
    const Scalar z413 = z2 * z384 + z1 * z358;
    const Scalar z414 = z1 * z384 - z2 * z358;
    const Scalar z415 = z1 * z394 - z387;
    const Scalar z416 = z413 - n0_5603 * z304;  // moment on frame.2, z
    const Scalar z417 = z414 - n0_5603 * z307;  // moment on frame.2, y
    const Scalar z418 = k32 - z402;
    const Scalar z419 = k32 + z403;
    const Scalar z420 = s_roll * z395 + c_roll * z415;
    const Scalar z421 = s_roll * z386 + c_roll * z417;
    const Scalar z422 = z396 - z418;
    const Scalar z423 = c_roll * z366 + s_roll * z399;
    const Scalar z424 = s_roll * z366 - c_roll * z399;
    const Scalar z425 = c_yaw * z424;
    const Scalar z426 = s_yaw * z424;
    const Scalar z427 = s_yaw * z410 - c_yaw * z382;
    const Scalar z428 = s_yaw * z382 + c_yaw * z410;
    const Scalar z429 = c_steer * z365 - z389;
    const Scalar z430 = n25_over_7 * z365;
    const Scalar z431 = n2 * z393;
    const Scalar z432 = c_roll * z431 + s_roll * z422;
    const Scalar z433 = z371 * z430 - z395;
    const Scalar z434 = z374 * z430 - z397;
    const Scalar z435 = z398 + z434;
    const Scalar z436 = k34 * z368;
    const Scalar z437 = z368 * z436 + z429;
    const Scalar z438 = z373 * z436 + z433;
    const Scalar z439 = z376 * z436 + z435;
    const Scalar z440 = s_roll * z432;
    const Scalar z441 = z378 * z436 + z404;
    const Scalar z442 = n1 / z437;
    const Scalar z443 = z406 * z436 + z408;
    const Scalar z444 = z418 + z440;
    const Scalar z445 = z407 * z436 + z409;
    const Scalar z446 = n25_over_7 * z371;
    const Scalar z447 = z371 * z446 - z419;
    const Scalar z448 = z374 * z446 - z420;
    const Scalar z449 = k34 * z373;
    const Scalar z450 = z406 * z449 - z425;
    const Scalar z451 = z407 * z449 - z426;
    const Scalar z452 = z373 * z449 + z447;
    const Scalar z453 = z376 * z449 + z448;
    const Scalar z454 = n25_over_7 * z374;
    const Scalar z455 = z374 * z454 - z444;
    const Scalar z456 = n25_over_3 * z398;
    const Scalar z457 = k34 * z376;
    const Scalar z458 = z438 * z442;
    const Scalar z459 = z439 * z442;
    const Scalar z460 = k34 * z378;
    const Scalar z461 = z378 * z457;
    const Scalar z462 = z398 * z456 + z455;
    const Scalar z463 = z461 - z441 * z459;
    const Scalar z464 = z450 - z443 * z458;
    const Scalar z465 = z451 - z445 * z458;
    const Scalar z466 = z376 * z457 + z462;
    const Scalar z467 = z378 * z449 - z423;
    const Scalar z468 = n94 - z378 * z460;
    const Scalar z469 = z467 - z441 * z458;
    const Scalar z470 = z466 - z439 * z459;
    const Scalar z471 = z441 * z442;
    const Scalar z472 = z468 + z441 * z471;
    const Scalar z473 = c_yaw * z400 + s_yaw * z423;
    const Scalar z474 = s_yaw * z400 - c_yaw * z423;
    const Scalar z475 = z452 - z438 * z458;
    const Scalar z476 = z453 - z439 * z458;
    const Scalar z477 = n1 / z475;
    const Scalar z478 = z406 * z457 + z473;
    const Scalar z479 = z478 - z443 * z459;
    const Scalar z480 = z407 * z457 + z474;
    const Scalar z481 = z480 - z445 * z459;
    const Scalar z482 = k34 * z406;
    const Scalar z483 = z406 * z460;
    const Scalar z484 = n94 - z406 * z482;
    const Scalar z485 = z483 - z443 * z471;
    const Scalar z486 = z443 * z442;
    const Scalar z487 = k34 * z407;
    const Scalar z488 = z407 * z482;
    const Scalar z489 = z484 + z443 * z486;
    const Scalar z490 = z488 - z445 * z486;
    const Scalar z491 = z407 * z460;
    const Scalar z492 = n94 - z407 * z487;
    const Scalar z493 = z491 - z445 * z471;
    const Scalar z494 = z476 * z477;
    const Scalar z495 = z469 * z477;
    const Scalar z496 = z464 * z477;
    const Scalar z497 = z470 - z476 * z494;
    const Scalar z498 = z463 - z469 * z494;
    const Scalar z499 = z472 + z469 * z495;
    const Scalar z500 = z485 - z464 * z495;
    const Scalar z501 = n1 / z497;
    const Scalar z502 = z479 - z464 * z494;
    const Scalar z503 = z489 + z464 * z496;
    const Scalar z504 = z490 - z465 * z496;
    const Scalar z505 = z493 - z465 * z495;
    const Scalar z506 = z481 - z465 * z494;
    const Scalar z507 = z445 * z442;
    const Scalar z508 = z492 + z445 * z507;
    const Scalar z509 = z465 * z477;
    const Scalar z510 = z187 * z494;
    const Scalar z511 = z143 + z170 * z436;
    const Scalar z512 = z131 + z170 * z449 - z458 * z511;
    const Scalar z513 = z508 + z465 * z509;
    const Scalar z514 = z79 * z494;
    const Scalar z515 = z506 * z501;
    const Scalar z516 = z498 * z501;
    const Scalar z517 = z502 * z501;
    const Scalar z518 = z186 * z494;
    const Scalar z519 = z170 * z457 - z459 * z511 - z494 * z512;
    const Scalar z520 = z499 + z498 * z516;
    const Scalar z521 = z500 - z502 * z516;
    const Scalar z522 = z503 + z502 * z517;
    const Scalar z523 = n1 / z520;
    const Scalar z524 = z504 - z506 * z517;
    const Scalar z525 = z505 - z506 * z516;
    const Scalar z526 = z513 + z506 * z515;
    const Scalar z527 = z186 * z495 - z516 * z518;
    const Scalar z528 = z187 * z495 - z516 * z510;
    const Scalar z529 = n1 + z170 * z460 - z471 * z511 - z495 * z512 - z516 * z519;
    const Scalar z530 = n1 + z79 * z495 - z516 * z514;
    const Scalar z531 = z525 * z523;
    const Scalar z532 = z521 * z523;
    const Scalar z533 = z526 - z525 * z531;
    const Scalar z534 = z524 + z525 * z532;
    const Scalar z535 = z185 + z220 * z436 - z239 * z430;
    const Scalar z536 = z522 - z521 * z532;
    const Scalar z537 = z184 + z220 * z449 - z239 * z446 - z458 * z535;
    const Scalar z538 = n1 / z536;
    const Scalar z539 = z182 + z220 * z457 - z239 * z454 - z459 * z535 - z494 * z537;
    const Scalar z540 = n1 + z186 * z496 - z517 * z518 + z532 * z527;
    const Scalar z541 = z187 * z496 - z517 * z510 + z532 * z528;
    const Scalar z542 = z170 * z482 - z486 * z511 - z496 * z512 - z517 * z519 + z532 * z529;
    const Scalar z543 = z534 * z538;
    const Scalar z544 = z533 - z534 * z543;
    const Scalar z545 = z220 * z460 - z471 * z535 - z495 * z537 - z516 * z539;
    const Scalar z546 = n1 / z544;
    const Scalar z547 = z220 * z482 - z486 * z535 - z496 * z537 - z517 * z539 + z532 * z545;
    const Scalar z548 = n1 - z220 * z487 + z507 * z535 + z509 * z537 + z515 * z539 - z531 * z545 - z543 * z547;
    const Scalar z549 = z186 * z509 - z515 * z518 + z531 * z527 + z543 * z540;
    const Scalar z550 = z546 * z548;
    const Scalar z551 = z546 * z549;
    const Scalar z552 = z538 * z547 - z543 * z550;
    const Scalar z553 = n1 + z187 * z509 - z515 * z510 + z531 * z528 + z543 * z541;
    const Scalar z554 = z538 * z540 + z543 * z551;
    const Scalar z555 = z523 * z527 + z531 * z551 + z532 * z554;
    const Scalar z556 = z546 * z553;
    const Scalar z557 = z538 * z541 + z543 * z556;
    const Scalar z558 = z501 * z518 + z515 * z551 + z517 * z554 + z516 * z555;
    const Scalar z559 = z523 * z528 + z531 * z556 + z532 * z557;
    const Scalar z560 = z186 * z477 - z509 * z551 - z496 * z554 - z495 * z555 + z494 * z558;
    const Scalar z561 = z501 * z510 + z515 * z556 + z517 * z557 + z516 * z559;
    const Scalar z562 = z507 * z551 + z486 * z554 + z471 * z555 - z459 * z558 + z458 * z560;
    const Scalar z563 = z487 * z551 + z482 * z554 + z460 * z555 - z457 * z558 + z449 * z560 - z436 * z562;
    const Scalar z564 = n25_over_3 * z195 - z562 - z456 * z558;
    const Scalar z565 = z454 * z558 - z446 * z560 + z430 * z562;
    const Scalar z566 = z170 * z487 - z507 * z511 - z509 * z512 - z515 * z519 + z531 * z529 + z543 * z542;
    const Scalar z567 = z546 * z566;
    const Scalar z568 = z187 * z477 - z509 * z556 - z496 * z557 - z495 * z559 + z494 * z561;
    const Scalar z569 = z538 * z542 + z543 * z567;
    const Scalar z570 = z507 * z556 + z486 * z557 + z471 * z559 - z459 * z561 + z458 * z568;
    const Scalar z571 = z523 * z529 + z531 * z567 + z532 * z569;
    const Scalar z572 = z501 * z519 + z515 * z567 + z517 * z569 + z516 * z571;
    const Scalar z573 = z487 * z556 + z482 * z557 + z460 * z559 - z457 * z561 + z449 * z568 - z436 * z570;
    const Scalar z574 = z477 * z512 + z509 * z567 + z496 * z569 + z495 * z571 - z494 * z572;
    const Scalar z575 = z442 * z511 + z507 * z567 + z486 * z569 + z471 * z571 - z459 * z572 - z458 * z574;
    const Scalar z576 = z79 * z496 - z517 * z514 + z532 * z530;
    const Scalar z577 = z523 * z545 - z531 * z550 + z532 * z552;
    const Scalar z578 = n25_over_3 * z197 - z570 - z456 * z561;
    const Scalar z579 = z454 * z561 - z446 * z568 + z430 * z570;
    const Scalar z580 = z79 * z509 - z515 * z514 + z531 * z530 + z543 * z576;
    const Scalar z581 = z501 * z539 - z515 * z550 + z517 * z552 + z516 * z577;
    const Scalar z582 = z546 * z580;
    const Scalar z583 = z477 * z537 - z509 * z550 + z496 * z552 + z495 * z577 - z494 * z581;
    const Scalar z584 = z538 * z576 + z543 * z582;
    const Scalar z585 = z442 * z535 - z507 * z550 + z486 * z552 + z471 * z577 - z459 * z581 - z458 * z583;
    const Scalar z586 = z523 * z530 + z531 * z582 + z532 * z584;
    const Scalar z587 = z501 * z514 + z515 * z582 + z517 * z584 + z516 * z586;
    const Scalar z588 = k34 * z220 - z487 * z550 + z482 * z552 + z460 * z577 - z457 * z581 - z449 * z583 - z436 * z585;
    const Scalar z589 = k34 * z170 + z487 * z567 + z482 * z569 + z460 * z571 - z457 * z572 - z449 * z574 - z436 * z575;
    const Scalar z590 = z456 * z572 + z575;
    const Scalar z591 = z454 * z572 + z446 * z574 + z430 * z575;
    const Scalar z592 = z79 * z477 - z509 * z582 - z496 * z584 - z495 * z586 + z494 * z587;
    const Scalar z593 = n25_over_7 * z239 + z454 * z581 + z446 * z583 + z430 * z585;
    const Scalar z594 = z507 * z582 + z486 * z584 + z471 * z586 - z459 * z587 + z458 * z592;
    const Scalar z595 = z181 + z237 * z436 - z238 * z430;
    const Scalar z596 = z487 * z582 + z482 * z584 + z460 * z586 - z457 * z587 + z449 * z592 - z436 * z594;
    const Scalar z597 = z180 + z237 * z449 - z238 * z446 - z458 * z595;
    const Scalar z598 = z456 * z587 + z594;
    const Scalar z599 = z176 + z237 * z457 - z238 * z454 - z459 * z595 - z494 * z597;
    const Scalar z600 = z454 * z587 - z446 * z592 + z430 * z594;
    const Scalar z601 = z237 * z460 - z471 * z595 - z495 * z597 - z516 * z599;
    const Scalar z602 = n1 - z237 * z482 + z486 * z595 + z496 * z597 + z517 * z599 - z532 * z601;
    const Scalar z603 = z237 * z487 - z507 * z595 - z509 * z597 - z515 * z599 + z531 * z601 - z543 * z602;
    const Scalar z604 = z546 * z603;
    const Scalar z605 = z552 + z176 * z581 + z180 * z583 + z181 * z585 - z237 * z588 - z238 * z593;
    const Scalar z606 = z538 * z602 - z543 * z604;
    const Scalar z607 = z523 * z601 + z531 * z604 - z532 * z606;
    const Scalar z608 = z182 * z581 - z550 + z184 * z583 + z185 * z585 - z220 * z588 - z239 * z593;
    const Scalar z609 = z501 * z599 + z515 * z604 - z517 * z606 + z516 * z607;
    const Scalar z610 = z477 * z597 + z509 * z604 - z496 * z606 + z495 * z607 - z494 * z609;
    const Scalar z611 = z442 * z595 + z507 * z604 - z486 * z606 + z471 * z607 - z459 * z609 - z458 * z610;
    const Scalar z612 = k34 * z237 + z487 * z604 - z482 * z606 + z460 * z607 - z457 * z609 - z449 * z610 - z436 * z611;
    const Scalar z613 = n25_over_7 * z238 + z454 * z609 + z446 * z610 + z430 * z611;
    const Scalar z614 = z176 * z609 - z606 + z180 * z610 + z181 * z611 - z237 * z612 - z238 * z613;
    const Scalar z615 = n1 / z614;
    const Scalar z616 = z551 + z182 * z558 - z184 * z560 + z185 * z562 - z220 * z563 - z239 * z565;
    const Scalar z617 = z554 + z176 * z558 - z180 * z560 + z181 * z562 - z237 * z563 - z238 * z565;
    const Scalar z618 = z554 + z164 * z558 - z186 * z560 + z195 * (z562 + z564);
    const Scalar z619 = z605 * z615;
    const Scalar z620 = z617 * z615;
    const Scalar z621 = z557 + z164 * z561 - z186 * z568 + z195 * (z570 + z578);
    const Scalar z622 = z608 - z605 * z619;
    const Scalar z623 = z616 - z617 * z619;
    const Scalar z624 = n1 / z622;
    const Scalar z625 = z618 + z617 * z620;
    const Scalar z626 = z556 + z182 * z561 - z184 * z568 + z185 * z570 - z220 * z573 - z239 * z579;
    const Scalar z627 = z557 + z176 * z561 - z180 * z568 + z181 * z570 - z237 * z573 - z238 * z579;
    const Scalar z628 = z621 + z627 * z620;
    const Scalar z629 = z626 - z627 * z619;
    const Scalar z630 = z556 + z165 * z561 - z187 * z568 + z197 * (z570 + z578);
    const Scalar z631 = z627 * z615;
    const Scalar z632 = z630 + z627 * z631;
    const Scalar z633 = z567 + z165 * z572 + z187 * z574 + z197 * (z575 - z590);
    const Scalar z634 = z569 + z164 * z572 + z186 * z574 + z195 * (z575 - z590);
    const Scalar z635 = z567 + z182 * z572 + z184 * z574 + z185 * z575 - z220 * z589 - z239 * z591;
    const Scalar z636 = z569 + z176 * z572 + z180 * z574 + z181 * z575 - z237 * z589 - z238 * z591;
    const Scalar z637 = z633 + z636 * z631;
    const Scalar z638 = z634 + z636 * z620;
    const Scalar z639 = z635 - z636 * z619;
    const Scalar z640 = z131 * z574 - z571 + z143 * z575 - z170 * z589;
    const Scalar z641 = z636 * z615;
    const Scalar z642 = z640 - z636 * z641;
    const Scalar z643 = z586 + z131 * z592 - z143 * z594 + z170 * z596;
    const Scalar z644 = z582 + z165 * z587 - z187 * z592 + z197 * (z594 - z598);
    const Scalar z645 = z584 + z164 * z587 - z186 * z592 + z195 * (z594 - z598);
    const Scalar z646 = z582 + z182 * z587 - z184 * z592 + z185 * z594 - z220 * z596 - z239 * z600;
    const Scalar z647 = z584 + z176 * z587 - z180 * z592 + z181 * z594 - z237 * z596 - z238 * z600;
    const Scalar z648 = z643 + z647 * z641;
    const Scalar z649 = z644 + z647 * z631;
    const Scalar z650 = z645 + z647 * z620;
    const Scalar z651 = z646 - z647 * z619;
    const Scalar z652 = z79 * z592 - z586;
    const Scalar z653 = z647 * z615;
    const Scalar z654 = z652 - z647 * z653;
    const Scalar z655 = z456 * z581 + z585;
    const Scalar z656 = z623 * z624;
    const Scalar z657 = z625 + z623 * z656;
    const Scalar z658 = z628 + z629 * z656;
    const Scalar z659 = z638 + z639 * z656;
    const Scalar z660 = z650 + z651 * z656;
    const Scalar z661 = n1 / z657;
    const Scalar z662 = z629 * z624;
    const Scalar z663 = z632 + z629 * z662;
    const Scalar z664 = z637 + z639 * z662;
    const Scalar z665 = z649 + z651 * z662;
    const Scalar z666 = z639 * z624;
    const Scalar z667 = z642 - z639 * z666;
    const Scalar z668 = z648 + z651 * z666;
    const Scalar z669 = z651 * z624;
    const Scalar z670 = z654 - z651 * z669;
    const Scalar z671 = z456 * z609 + z611;
    const Scalar z672 = z652 + z640 - z630 - z618 + z608 + z614;
    const Scalar z673 = n4096 * z672;
    const Scalar z674 = z333 * z430 - z338 + z357 * z436 + z386;
    const Scalar z675 = z333 * z446 + z357 * z449 - z458 * z674 + z416;
    const Scalar z676 = z658 * z661;
    const Scalar z677 = z663 - z658 * z676;
    const Scalar z678 = z664 - z659 * z676;
    const Scalar z679 = z665 - z660 * z676;
    const Scalar z680 = z659 * z661;
    const Scalar z681 = z667 + z659 * z680;
    const Scalar z682 = z333 * z454 - z338 * z456 + z357 * z457 - z459 * z674 - z494 * z675 + z421;
    const Scalar z683 = n1 / z677;
    const Scalar z684 = z668 - z660 * z680;
    const Scalar z685 = z357 * z460 + z412 - z471 * z674 - z495 * z675 - z516 * z682;
    const Scalar z686 = z357 * z482 - z428 - z486 * z674 - z496 * z675 - z517 * z682 + z532 * z685;
    const Scalar z687 = z357 * z487 - z427 - z507 * z674 - z509 * z675 - z515 * z682 + z531 * z685 + z543 * z686;
    const Scalar z688 = z546 * z687;
    const Scalar z689 = z678 * z683;
    const Scalar z690 = z681 + z678 * z689;
    const Scalar z691 = z684 - z679 * z689;
    const Scalar z692 = z538 * z686 + z543 * z688;
    const Scalar z693 = z660 * z661;
    const Scalar z694 = z670 + z660 * z693;
    const Scalar z695 = n1 / z690;
    const Scalar z696 = z679 * z683;
    const Scalar z697 = z523 * z685 + z531 * z688 + z532 * z692;
    const Scalar z698 = z694 + z679 * z696;
    const Scalar z699 = z501 * z682 + z515 * z688 + z517 * z692 + z516 * z697;
    const Scalar z700 = z477 * z675 + z509 * z688 + z496 * z692 + z495 * z697 - z494 * z699;
    const Scalar z701 = z691 * z695;
    const Scalar z702 = z442 * z674 + z507 * z688 + z486 * z692 + z471 * z697 - z459 * z699 - z458 * z700;
    const Scalar z703 = k34 * z357 + z487 * z688 + z482 * z692 + z460 * z697 - z457 * z699 - z449 * z700 - z436 * z702;
    const Scalar z704 = n25_over_7 * z333 - z454 * z699 - z446 * z700 - z430 * z702;
    const Scalar z705 = z303 + z688 + z182 * z699 + z184 * z700 + z185 * z702 - z220 * z703 + z239 * z704;
    const Scalar z706 = z302 + z692 + z176 * z699 + z180 * z700 + z181 * z702 - z237 * z703 + z238 * z704;
    const Scalar z707 = z131 * z700 - z234 - z697 + z143 * z702 - z170 * z703;
    const Scalar z708 = z702 + n25_over_3 * z338 + z456 * z699;
    const Scalar z709 = z227 + z688 + z165 * z699 + z187 * z700 + z197 * (z702 - z708);
    const Scalar z710 = z233 + z692 + z164 * z699 + z186 * z700 + z195 * (z702 - z708);
    const Scalar z711 = z697 - z98 + z79 * z700;
    const Scalar z712 = z698 - z691 * z701;
    const Scalar z713 = z619 * z706 - z705;
    const Scalar z714 = z710 + z620 * z706 - z656 * z713;
    const Scalar z715 = n1 / z712;
    const Scalar z716 = z709 + z631 * z706 - z662 * z713 - z676 * z714;
    const Scalar z717 = z641 * z706 - z707 - z666 * z713 - z680 * z714 - z689 * z716;
    const Scalar z718 = z711 + z653 * z706 - z669 * z713 - z693 * z714 - z696 * z716 + z701 * z717;
    const Scalar z719 = z715 * z718;
    const Scalar z720 = z695 * z717 + z701 * z719;
    const Scalar z721 = z683 * z716 + z696 * z719 + z689 * z720;
    const Scalar z722 = z661 * z714 + z693 * z719 + z680 * z720 - z676 * z721;
    const Scalar z723 = z624 * z713 - z669 * z719 - z666 * z720 + z662 * z721 + z656 * z722;
    const Scalar z724 = z615 * z706 + z653 * z719 + z641 * z720 - z631 * z721 - z620 * z722 + z619 * z723;
    const Scalar z725 = z688 + z582 * z719 + z567 * z720 - z556 * z721 - z551 * z722 - z550 * z723 - z604 * z724;
    const Scalar z726 = z692 + z584 * z719 + z569 * z720 - z557 * z721 - z554 * z722 + z552 * z723 + z606 * z724;
    const Scalar z727 = z697 + z586 * z719 + z571 * z720 - z559 * z721 - z555 * z722 + z577 * z723 - z607 * z724;
    const Scalar z728 = z699 + z587 * z719 + z572 * z720 - z561 * z721 - z558 * z722 + z581 * z723 - z609 * z724;
    const Scalar z729 = z592 * z719 - z700 - z574 * z720 - z568 * z721 - z560 * z722 - z583 * z723 + z610 * z724;
    const Scalar z730 = z702 + z594 * z719 + z575 * z720 - z570 * z721 - z562 * z722 + z585 * z723 - z611 * z724;
    const Scalar z731 = z703 + z596 * z719 + z589 * z720 - z573 * z721 - z563 * z722 + z588 * z723 - z612 * z724;
    const Scalar z732 = z708 + z598 * z719 + z590 * z720 + z578 * z721 + z564 * z722 + z655 * z723 - z671 * z724;
    const Scalar z733 = z600 * z719 - z704 + z591 * z720 - z579 * z721 - z565 * z722 + z593 * z723 - z613 * z724;
    accelerations.x = z725;
    accelerations.y = -z726;
    accelerations.z = z727;
    accelerations.yaw = z728;
    accelerations.roll = z729;
    accelerations.pitch = z730;
    accelerations.steer = -z731;
    accelerations.rear = -z732;
    accelerations.front = -z733;
    multipliers.lambda_rear_touches = -z719;
    multipliers.lambda_front_touches = -z720;
    multipliers.lambda_rear_rolls_x = -z721;
    multipliers.lambda_rear_rolls_y = -z722;
    multipliers.lambda_front_rolls_x = -z723;
    multipliers.lambda_front_rolls_y = z724;
    if (!(traits::regular(z544, n94) && traits::regular(z536, n94) && traits::regular(z520, n94)
        && traits::regular(-z497, z444) && traits::regular(-z475, z419) && traits::regular(-z437, z396)
        && traits::regular(-z712, -z673) && traits::regular(-z690, -z673) && traits::regular(z677, -z673)
        && traits::regular(z657, -z673) && traits::regular(-z622, -z673) && traits::regular(-z614,
        -z673))) return torsor::Status::singular;
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
    const Scalar n4 = traits::constant(4.0, 4.0f, "4/1");
    const Scalar n0_7 = traits::constant(0.7, 0.7f, "7/10");
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
    const Scalar z19 = v_roll * s_roll;
    const Scalar z20 = z11 * z11 * (n1 - c_steer) + c_steer;
    const Scalar z21 = v_yaw * c_yaw;
    const Scalar z22 = v_roll * c_roll;
    const Scalar z23 = v_yaw * s_yaw;
    const Scalar z24 = s_yaw * c_roll;
    const Scalar z25 = n1 - s_roll * s_roll;
    const Scalar z26 = c_yaw * c_roll;
    const Scalar z27 = s_yaw * s_roll;
    const Scalar z28 = n2 * s_roll;
    const Scalar z29 = c_yaw * s_roll;
    const Scalar z30 = s_roll * z24;
    const Scalar z31 = s_roll * z26;
    const Scalar z32 = s_yaw * z19 - c_roll * z21;
    const Scalar z33 = c_yaw * z19 + c_roll * z23;
    const Scalar z34 = z22 * z28;
    const Scalar z35 = s_roll * z27 - c_roll * z24;
    const Scalar z36 = s_roll * z29 - c_roll * z26;
    const Scalar z37 = c_roll * z28;
    const Scalar z38 = v_roll * z22;
    const Scalar z39 = v_yaw * z23;
    const Scalar z40 = n2 * z19;
    const Scalar z41 = v_roll * z19;
    const Scalar z42 = n2 * z22;
    const Scalar z43 = v_yaw * z21;
    const Scalar z44 = n0_08 * z15 - n0_35 * z16;
    const Scalar z45 = s_pitch * z16 - c_pitch * z15;
    const Scalar z46 = s_pitch * z15 + c_pitch * z16;
    const Scalar z47 = z25 * z25 + z30 * z30 + z31 * z31;
    const Scalar z48 = s_yaw * z38 + c_roll * z39 + z21 * z40;
    const Scalar z49 = c_yaw * z38 + c_roll * z43 - z23 * z40;
    const Scalar z50 = n2 * (s_roll * z41 - z22 * z22);
    const Scalar z51 = n0_08 * z17 - n0_35 * z18;
    const Scalar z52 = n0_08 * z18 - n0_35 * z20;
    const Scalar z53 = s_roll * z32 - z24 * z22;
    const Scalar z54 = s_roll * z33 - z26 * z22;
    const Scalar z55 = n2 * (z25 * z37 + z30 * z35 + z31 * z36);
    const Scalar z56 = s_roll * z44;
    const Scalar z57 = s_roll * z46;
    const Scalar z58 = s_roll * c_steer + c_roll * z46;
    const Scalar z59 = c_yaw * z45;
    const Scalar z60 = n0_3 + z52;
    const Scalar z61 = c_roll * c_steer - z57;
    const Scalar z62 = n1_1 - z51;
    const Scalar z63 = traits::sqrt(z47);
    const Scalar z64 = n2 * (z25 * z34 + z30 * z53 + z31 * z54);
    const Scalar z65 = z24 * z41 + z32 * z42 + s_roll * z48;
    const Scalar z66 = s_yaw * z61 - z59;
    const Scalar z67 = s_pitch * z62 - c_pitch * z60;
    const Scalar z68 = s_pitch * z60 + c_pitch * z62;
    const Scalar z69 = z26 * z41 + z33 * z42 + s_roll * z49;
    const Scalar z70 = s_roll * z67 - c_roll * z44;
    const Scalar z71 = c_roll * z67 + z56;
    const Scalar z72 = n2 * (z30 * z65 + z31 * z69 - z25 * z50 - z53 * z53 - z54 * z54 - z34 * z34);
    const Scalar z73 = s_yaw * z68 + c_yaw * z70;
    const Scalar z74 = q_z - z71;
    const Scalar z75 = q_y + z73;
    const Scalar z76 = s_yaw * z70 - c_yaw * z68;
    const Scalar z77 = n0_3 / z63;
    const Scalar z78 = s_yaw * z45;
    const Scalar z79 = q_x - z76;
    const Scalar z80 = n0_5 * z55 / z63;
    const Scalar z81 = n0_5 * z64 / z63;
    const Scalar z82 = q_x + z30 * z77;
    const Scalar z83 = c_yaw * z61 + z78;
    const Scalar z84 = q_y - z31 * z77;
    const Scalar z85 = z58 * z66;
    const Scalar z86 = q_z + z25 * z77;
    const Scalar z87 = n1 - z58 * z58;
    const Scalar z88 = z58 * z83;
    const Scalar z89 = z87 * z87 + z85 * z85 + z88 * z88;
    const Scalar z90 = v_pitch * c_pitch;
    const Scalar z91 = v_pitch * s_pitch;
    const Scalar z92 = v_steer * c_steer;
    const Scalar z93 = v_steer * s_steer;
    const Scalar z94 = z11 * z92;
    const Scalar z95 = z10 * z92;
    const Scalar z96 = z13 * z93;
    const Scalar z97 = -z93 * (n1 - z14);
    const Scalar z98 = -z93 * (n1 - z12);
    const Scalar z99 = n0_08 * z96 + n0_35 * z97;
    const Scalar z100 = n0_35 * z96 + n0_08 * z98;
    const Scalar z101 = traits::sqrt(z89);
    const Scalar z102 = n0_08 * z94 - n0_35 * z95;
    const Scalar z103 = n0_3 * z80;
    const Scalar z104 = c_roll * z93;
    const Scalar z105 = z15 * z90 - z16 * z91 + s_pitch * z94 + c_pitch * z95;
    const Scalar z106 = z15 * z91 + z16 * z90 + s_pitch * z95 - c_pitch * z94;
    const Scalar z107 = c_steer * z19 + z104 + z22 * z46 + s_roll * z105;
    const Scalar z108 = n2 * z58;
    const Scalar z109 = s_roll * z93 - c_steer * z22 + z19 * z46 - c_roll * z105;
    const Scalar z110 = z21 * z45 - z23 * z61 + s_yaw * z106 - c_yaw * z107;
    const Scalar z111 = n0_35 / z101;
    const Scalar z112 = z58 * z110 - z83 * z109;
    const Scalar z113 = c_yaw * z106 - z23 * z45 - z21 * z61 + s_yaw * z107;
    const Scalar z114 = z66 * z109 + z58 * z113;
    const Scalar z115 = s_pitch * z100 - c_pitch * z99 - z62 * z90 - z60 * z91;
    const Scalar z116 = z74 + z87 * z111;
    const Scalar z117 = z75 - z88 * z111;
    const Scalar z118 = z79 + z85 * z111;
    const Scalar z119 = z22 * z44 + s_roll * z102 - z19 * z67 - c_roll * z115;
    const Scalar z120 = v_z - z119;
    const Scalar z121 = n0_5 * (z64 * z81 / (z63 * z63) + z72 / z63);
    const Scalar z122 = n0_3 * z121;
    const Scalar z123 = z11 * c_steer;
    const Scalar z124 = z10 * c_steer;
    const Scalar z125 = s_pitch * z123 + c_pitch * z124;
    const Scalar z126 = s_pitch * z124 - c_pitch * z123;
    const Scalar z127 = s_roll * z45;
    const Scalar z128 = s_yaw * z46 + c_yaw * z127;
    const Scalar z129 = c_roll * z45;
    const Scalar z130 = s_yaw * z58;
    const Scalar z131 = s_yaw * z127 - c_yaw * z46;
    const Scalar z132 = c_roll * s_steer + s_roll * z125;
    const Scalar z133 = s_roll * s_steer - c_roll * z125;
    const Scalar z134 = c_yaw * z126 + s_yaw * z132;
    const Scalar z135 = s_yaw * z126 - c_yaw * z132;
    const Scalar z136 = z108 * z129;
    const Scalar z137 = c_yaw * z58;
    const Scalar z138 = v_pitch * z91;
    const Scalar z139 = z61 * z66 - z58 * z130;
    const Scalar z140 = z58 * z128 - z83 * z129;
    const Scalar z141 = z58 * z134 + z66 * z133;
    const Scalar z142 = v_pitch * z90;
    const Scalar z143 = z61 * z83 - z58 * z137;
    const Scalar z144 = v_steer * z93;
    const Scalar z145 = v_steer * z92;
    const Scalar z146 = z58 * z135 - z83 * z133;
    const Scalar z147 = z58 * z131 - z66 * z129;
    const Scalar z148 = z11 * z144;
    const Scalar z149 = z61 * z108;
    const Scalar z150 = z109 * z108;
    const Scalar z151 = z108 * z133;
    const Scalar z152 = z10 * z144;
    const Scalar z153 = n2 * (z87 * z136 + z88 * z140 + z85 * z147);
    const Scalar z154 = n2 * (z85 * z139 + z88 * z143 - z87 * z149);
    const Scalar z155 = n2 * (z85 * z141 - z88 * z146 - z87 * z151);
    const Scalar z156 = z15 * z138 + z16 * z142 + s_pitch * z148 + c_pitch * z152 - n2 * (z94 * z90 - z95 * z91);
    const Scalar z157 = s_steer * z13;
    const Scalar z158 = s_steer * (n1 - z12);
    const Scalar z159 = n0_08 * z158 - n0_35 * z157;
    const Scalar z160 = s_steer * (n1 - z14);
    const Scalar z161 = n0_08 * z157 - n0_35 * z160;
    const Scalar z162 = z16 * z138 - z15 * z142 + s_pitch * z152 - c_pitch * z148 - n2 * (z94 * z91 + z95 * z90);
    const Scalar z163 = n0_08 * z148 - n0_35 * z152;
    const Scalar z164 = z41 * z46 - c_roll * z145 - c_steer * z38 - n2 * (z22 * z105 - z19 * z93) + s_roll * z156;
    const Scalar z165 = n2 * (z85 * z114 - z88 * z112 - z87 * z150);
    const Scalar z166 = n0_5 * z153 / z101;
    const Scalar z167 = n0_5 * z154 / z101;
    const Scalar z168 = n0_5 * z155 / z101;
    const Scalar z169 = c_pitch * z161 + s_pitch * z159;
    const Scalar z170 = n0_08 * z123 - n0_35 * z124;
    const Scalar z171 = c_roll * z68;
    const Scalar z172 = s_roll * z170 + c_roll * z169;
    const Scalar z173 = z43 * z45 - z39 * z61 - n2 * (z21 * z107 - z23 * z106) + c_yaw * z162 + s_yaw * z164;
    const Scalar z174 = n0_5 * z165 / z101;
    const Scalar z175 = s_roll * z145 + c_steer * z41 + z38 * z46 + n2 * (z22 * z93 + z19 * z105) + c_roll * z156;
    const Scalar z176 = n2 * z109;
    const Scalar z177 = z39 * z45 + z43 * z61 - n2 * (z21 * z106 + z23 * z107) + s_yaw * z162 - c_yaw * z164;
    const Scalar z178 = n2 * (z58 * z175 - z109 * z109);
    const Scalar z179 = z110 * z176 + z83 * z175 + z58 * z177;
    const Scalar z180 = z171 - n0_35 * z166;
    const Scalar z181 = z113 * z176 - z66 * z175 + z58 * z173;
    const Scalar z182 = z70 + n0_35 * z167;
    const Scalar z183 = q_x - z82;
    const Scalar z184 = q_z - z86;
    const Scalar z185 = q_y - z84;
    const Scalar z186 = q_x - z118;
    const Scalar z187 = q_y - z117;
    const Scalar z188 = q_z - z116;
    const Scalar z189 = z13 * z145;
    const Scalar z190 = n2 * (z150 * z150 + z112 * z112 + z114 * z114 + z87 * z178 - z88 * z179 + z85 * z181);
    const Scalar z191 = s_yaw * z188;
    const Scalar z192 = -z145 * (n1 - z12);
    const Scalar z193 = n0_35 * z189 + n0_08 * z192;
    const Scalar z194 = z77 * z53;
    const Scalar z195 = s_roll * z186 + z24 * z188;
    const Scalar z196 = s_roll * z183 + z24 * z184;
    const Scalar z197 = z172 + n0_35 * z168;
    const Scalar z198 = n0_3 * s_pitch + n1_1 * c_pitch;
    const Scalar z199 = n1_1 * s_pitch - n0_3 * c_pitch;
    const Scalar z200 = s_roll * z199;
    const Scalar z201 = s_pitch * z10 - c_pitch * z11;
    const Scalar z202 = s_pitch * z11 + c_pitch * z10;
    const Scalar z203 = s_roll * z201;
    const Scalar z204 = c_roll * z201;
    const Scalar z205 = c_yaw * z188;
    const Scalar z206 = s_yaw * z202 + c_yaw * z203;
    const Scalar z207 = s_yaw * z203 - c_yaw * z202;
    const Scalar z208 = -z145 * (n1 - z14);
    const Scalar z209 = n0_08 * z189 + n0_35 * z208;
    const Scalar z210 = s_yaw * z198 + c_yaw * z200;
    const Scalar z211 = c_roll * z199;
    const Scalar z212 = s_yaw * z200 - c_yaw * z198;
    const Scalar z213 = q_z - z211;
    const Scalar z214 = n0_3 * z81 / (z63 * z63);
    const Scalar z215 = s_roll * z187 - z26 * z188;
    const Scalar z216 = z165 * z174;
    const Scalar z217 = s_yaw * z184;
    const Scalar z218 = v_x - z194 + z30 * z214;
    const Scalar z219 = v_x - z218;
    const Scalar z220 = s_roll * z185 - z26 * z184;
    const Scalar z221 = z77 * z54;
    const Scalar z222 = c_yaw * z184;
    const Scalar z223 = v_y + z221 - z31 * z214;
    const Scalar z224 = v_z - z77 * z34 + z25 * z214;
    const Scalar z225 = v_z - z224;
    const Scalar z226 = s_pitch * z193 - z60 * z142 - c_pitch * z209 + z62 * z138 + n2 * (z90 * z100 + z91 * z99);
    const Scalar z227 = v_y - z223;
    const Scalar z228 = q_y + z210;
    const Scalar z229 = c_yaw * z225 - z23 * z184;
    const Scalar z230 = z24 * z225;
    const Scalar z231 = z22 * z183 - z32 * z184 + s_roll * z219 + z230;
    const Scalar z232 = z21 * z184 + s_yaw * z225;
    const Scalar z233 = z26 * z225;
    const Scalar z234 = z41 * z44 + s_roll * z163 + z38 * z67 - n2 * (z22 * z102 + z19 * z115) + c_roll * z226;
    const Scalar z235 = z74 - z116;
    const Scalar z236 = z116 - z213;
    const Scalar z237 = z75 - z117;
    const Scalar z238 = z117 - z228;
    const Scalar z239 = z79 - z118;
    const Scalar z240 = z83 * z235;
    const Scalar z241 = q_x - z212;
    const Scalar z242 = z118 - z241;
    const Scalar z243 = z58 * z237 - z240;
    const Scalar z244 = z207 * z236;
    const Scalar z245 = z206 * z236;
    const Scalar z246 = z204 * z238 + z245;
    const Scalar z247 = z204 * z242 - z244;
    const Scalar z248 = n0_5 * (z216 / (z101 * z101) - z190 / z101);
    const Scalar z249 = z234 - n0_35 * z248;
    const Scalar z250 = s_pitch * z99;
    const Scalar z251 = z66 * z235;
    const Scalar z252 = z58 * z239 + z251;
    const Scalar z253 = c_roll * z102;
    const Scalar z254 = z250 + c_pitch * z100 - z60 * z90 + z62 * z91;
    const Scalar z255 = z253 - z19 * z44 - z22 * z67 + s_roll * z115;
    const Scalar z256 = z10 * z90 + z11 * z91;
    const Scalar z257 = n0_35 * z174 / (z101 * z101);
    const Scalar z258 = z120 + z111 * z150 + z87 * z257;
    const Scalar z259 = z33 * z188;
    const Scalar z260 = z22 * z185 + z33 * z184 + s_roll * z227 - z233;
    const Scalar z261 = s_yaw * z254 - z21 * z68 + z23 * z70 + c_yaw * z255;
    const Scalar z262 = c_roll * z256 - z19 * z201;
    const Scalar z263 = v_z - z258;
    const Scalar z264 = z21 * z188 + s_yaw * z263;
    const Scalar z265 = v_yaw * z219 + z231 * (v_pitch + v_rear) - v_roll * z229;
    const Scalar z266 = v_yaw * z227 - v_roll * z232 + z260 * (v_pitch + v_rear);
    const Scalar z267 = z120 - z258;
    const Scalar z268 = v_yaw * s_roll;
    const Scalar z269 = v_yaw * c_roll;
    const Scalar z270 = v_roll * z3 + z4 * z269;
    const Scalar z271 = v_roll * z4 - z3 * z269;
    const Scalar z272 = z10 * z91 - z11 * z90;
    const Scalar z273 = a_yaw * c_roll;
    const Scalar z274 = v_roll * z268 - z273;  // angular acceleration of frame.2, y
    const Scalar z275 = a_yaw * s_roll;
    const Scalar z276 = v_roll * z269 + z275;  // angular acceleration of frame.2, x
    const Scalar z277 = v_y - z261;
    const Scalar z278 = n0_3 * z90 - n1_1 * z91;
    const Scalar z279 = z22 * z201 + s_roll * z256;
    const Scalar z280 = n1_1 * z90 + n0_3 * z91;
    const Scalar z281 = a_roll * z4 + z3 * z274;
    const Scalar z282 = s_yaw * z255 - c_yaw * z254 - z21 * z70 - z23 * z68;
    const Scalar z283 = s_yaw * z272 - z21 * z202 + z23 * z203 - c_yaw * z279;
    const Scalar z284 = z111 * z112 - z277 + z88 * z257;
    const Scalar z285 = z277 + z284;
    const Scalar z286 = z22 * z199 + s_roll * z280;
    const Scalar z287 = v_x + z282;
    const Scalar z288 = a_x * s_yaw - a_y * c_yaw;
    const Scalar z289 = z21 * z198 + s_yaw * z278 - z23 * z200 + c_yaw * z286;
    const Scalar z290 = a_roll * z3 - z4 * z274;
    const Scalar z291 = n9_81 - a_z;
    const Scalar z292 = a_x * c_yaw + a_y * s_yaw;
    const Scalar z293 = v_y + z289;
    const Scalar z294 = z284 + z293;
    const Scalar z295 = v_y + z284;
    const Scalar z296 = v_pitch * z270 - z281;  // angular acceleration of frame, x
    const Scalar z297 = v_pitch * z271 + z290;  // angular acceleration of frame, y
    const Scalar z298 = v_pitch + z268;  // angular velocity of frame, z
    const Scalar z299 = a_pitch + z276;  // angular acceleration of frame, z
    const Scalar z300 = c_roll * z280 - z19 * z199;
    const Scalar z301 = z287 - z111 * z114 + z85 * z257;
    const Scalar z302 = z287 - z301;
    const Scalar z303 = z23 * z198 - c_yaw * z278 + z21 * z200 + s_yaw * z286;
    const Scalar z304 = s_roll * z288 - c_roll * z291;
    const Scalar z305 = v_z - z300;
    const Scalar z306 = z258 - z305;
    const Scalar z307 = v_x - z301;
    const Scalar z308 = z23 * z202 + c_yaw * z272 + z21 * z203 + s_yaw * z279;
    const Scalar z309 = v_x - z303;
    const Scalar z310 = z301 - z309;
    const Scalar z311 = z32 * z188;
    const Scalar z312 = z3 * z292 + z4 * z304;
    const Scalar z313 = z3 * z304 - z4 * z292;
    const Scalar z314 = s_roll * z291 + c_roll * z288;
    const Scalar z315 = z236 * z283;
    const Scalar z316 = z236 * z308;
    const Scalar z317 = z113 * z235;
    const Scalar z318 = z110 * z235;
    const Scalar z319 = c_yaw * z263 - z23 * z188;
    const Scalar z320 = z22 * z187 + z259 + s_roll * z295 - z26 * z263;
    const Scalar z321 = s_steer * z298 + c_steer * z271;
    const Scalar z322 = s_steer * z271 - c_steer * z298;
    const Scalar z323 = a_rear + z299;  // angular acceleration of rear_wheel, z
    const Scalar z324 = c_steer * z299 + s_steer * z296;
    const Scalar z325 = z5 * z270 + z6 * z271;
    const Scalar z326 = v_rear + z298;  // angular velocity of rear_wheel, z
    const Scalar z327 = z5 * z271 - z6 * z270;
    const Scalar z328 = z271 * z270;
    const Scalar z329 = z270 * z270;
    const Scalar z330 = s_steer * z299 - c_steer * z296;
    const Scalar z331 = z299 - z328;
    const Scalar z332 = z298 * z298;
    const Scalar z333 = z271 * z298;
    const Scalar z334 = z329 + z332;
    const Scalar z335 = z297 + z333;
    const Scalar z336 = z22 * z186 - z311 + s_roll * z307 + z24 * z263;
    const Scalar z337 = z313 + k10 * z334;
    const Scalar z338 = z315 - z238 * z262 + z204 * z294 - z206 * z306;
    const Scalar z339 = z312 - k10 * z331;
    const Scalar z340 = z314 - k10 * z335;
    const Scalar z341 = s_steer * z337 - c_steer * z340;
    const Scalar z342 = s_steer * z340 + c_steer * z337;
    const Scalar z343 = z242 * z262 - z316 + z204 * z310 - z207 * z306;
    const Scalar z344 = z58 * z285 - z318 - z109 * z237 - z83 * z267;
    const Scalar z345 = v_steer + z270;  // angular velocity of fork, z
    const Scalar z346 = z58 * z302 - z317 - z109 * z239 + z66 * z267;
    const Scalar z347 = v_yaw * z295 - v_roll * z264 + v_pitch * z320 - v_steer * z338 + v_front * z344;
    const Scalar z348 = v_steer * z321 - z324;  // angular acceleration of fork, y
    const Scalar z349 = v_steer * z322 - z330;  // angular acceleration of fork, x
    const Scalar z350 = z7 * z345 + z8 * z321;
    const Scalar z351 = z7 * z321 - z8 * z345;
    const Scalar z352 = z322 * z322;
    const Scalar z353 = z345 * z345;
    const Scalar z354 = z321 * z345;
    const Scalar z355 = z321 * z321;
    const Scalar z356 = a_steer + z297;  // angular acceleration of fork, z
    const Scalar z357 = z352 + z353;
    const Scalar z358 = z352 + z355;
    const Scalar z359 = z321 * z322;
    const Scalar z360 = z348 + z354;
    const Scalar z361 = z322 * z345;
    const Scalar z362 = z356 - z359;
    const Scalar z363 = z349 - z361;
    const Scalar z364 = z348 - z354;
    const Scalar z365 = v_yaw * z307 - v_roll * z319 + v_pitch * z336 + v_steer * z343 + v_front * z346;
    const Scalar z366 = z353 - z355;
    const Scalar z367 = n0_12 * z323;  // moment on rear_wheel, z
    const Scalar z368 = k12 * z357;  // force on fork, x
    const Scalar z369 = k12 * z360;  // force on fork, z
    const Scalar z370 = a_front - z348;  // angular acceleration of front_wheel, z
    const Scalar z371 = n0_28 * z370;  // moment on front_wheel, z
    const Scalar z372 = v_front - z322;  // angular velocity of front_wheel, z
    const Scalar z373 = k14 * c_steer;
    const Scalar z374 = k12 * c_steer;
    const Scalar z375 = k12 * s_steer;
    const Scalar z376 = z325 * z326;
    const Scalar z377 = k15 * z354 + k14 * z366 + k12 * z339 - z371;  // moment on fork, y
    const Scalar z378 = n0_12 * z376;  // moment on rear_wheel, x
    const Scalar z379 = z327 * z326;
    const Scalar z380 = n0_12 * z379;  // moment on rear_wheel, y
    const Scalar z381 = z271 * z271;
    const Scalar z382 = z332 + z381;
    const Scalar z383 = z350 * z372;
    const Scalar z384 = n0_28 * z383;  // moment on front_wheel, x
    const Scalar z385 = k14 * s_steer;
    const Scalar z386 = z329 - z381;
    const Scalar z387 = z351 * z372;
    const Scalar z388 = k16 * z331 - z369 - k17 * z382;  // force on frame, y
    const Scalar z389 = n0_28 * z387;  // moment on front_wheel, y
    const Scalar z390 = z3 * z375;
    const Scalar z391 = k12 * z362;  // force on fork, y
    const Scalar z392 = n0_28 * s_steer;
    const Scalar z393 = n0_28 * c_steer;
    const Scalar z394 = z5 * z378 - z6 * z380;
    const Scalar z395 = z5 * z380 + z6 * z378;
    const Scalar z396 = z270 * z298;
    const Scalar z397 = k18 + k10 * z374;
    const Scalar z398 = z4 * z375;
    const Scalar z399 = s_steer * z368 - c_steer * z391;
    const Scalar z400 = z3 * z392;
    const Scalar z401 = z7 * z384 - z8 * z389;
    const Scalar z402 = z8 * z384 + z7 * z389;
    const Scalar z403 = k18 * z361 + k19 * z349 + k14 * z362 + z401;  // moment on fork, x
    const Scalar z404 = k18 * z356 + k19 * z359 + k14 * z363 + k12 * z341 + z402;  // moment on fork, z
    const Scalar z405 = k20 * s_steer;
    const Scalar z406 = k20 * c_steer;
    const Scalar z407 = k19 + c_steer * z406;
    const Scalar z408 = s_roll * z390 - c_roll * z374;
    const Scalar z409 = s_steer * z391 + c_steer * z368;
    const Scalar z410 = k19 + s_steer * z405;
    const Scalar z411 = s_steer * z406;
    const Scalar z412 = z3 * z373 + z4 * z397;
    const Scalar z413 = s_yaw * z408 - c_yaw * z398;
    const Scalar z414 = z296 + z396;
    const Scalar z415 = k16 * z314 - z395 - k21 * z333 + k22 * z414 + k10 * z399 - z404;  // moment on frame, y
    const Scalar z416 = s_roll * z393 + c_roll * z400;
    const Scalar z417 = c_steer * z377;
    const Scalar z418 = z299 + z328;
    const Scalar z419 = k16 * z334 + z409 + k17 * z418;  // force on frame, x
    const Scalar z420 = s_roll * z385 - c_roll * z412;
    const Scalar z421 = k16 * z335 - z399 - k17 * z414;  // force on frame, z
    const Scalar z422 = z3 * z397 - z4 * z373;
    const Scalar z423 = s_roll * z374 + c_roll * z390;
    const Scalar z424 = s_yaw * z398 + c_yaw * z408;
    const Scalar z425 = v_roll * z268;
    const Scalar z426 = s_steer * z403 + z417;
    // moment on frame, z
    const Scalar z427 = z367 + k23 * z299 - k24 * z328 + k22 * z386 - k16 * z312 + k17 * z313 - k10 * z369 - z426;
    const Scalar z428 = s_steer * z377;
    const Scalar z429 = k10 * z375 + z411;
    const Scalar z430 = c_steer * z403 - z428;
    const Scalar z431 = k24 - z410;
    const Scalar z432 = k25 * z374 + z407;
    const Scalar z433 = k23 + z432;
    const Scalar z434 = z394 + k17 * z314 + k23 * z396 - k24 * z296 - k22 * z335 + z430;  // moment on frame, x
    const Scalar z435 = n0_12 + z433;
    const Scalar z436 = k22 - z373;
    const Scalar z437 = k18 + k25 * z374;
    const Scalar z438 = n2 * z436;
    const Scalar z439 = z437 + z431;
    const Scalar z440 = k16 + z374;
    const Scalar z441 = z3 * z429 - z4 * z385;
    const Scalar z442 = z3 * z438 - z4 * z439;
    const Scalar z443 = k17 * z4 + z3 * z440;
    const Scalar z444 = k17 * z3 - z4 * z440;
    const Scalar z445 = s_roll * z444;
    const Scalar z446 = n0_12 * s_roll;
    const Scalar z447 = z3 * z385 + z4 * z429;
    const Scalar z448 = z4 * z442;
    const Scalar z449 = c_roll * z444;
    const Scalar z450 = s_yaw * z445 - c_yaw * z443;
    const Scalar z451 = z431 + z448;
    const Scalar z452 = s_yaw * z443 + c_yaw * z445;
    const Scalar z453 = s_roll * z435 + c_roll * z441;
    const Scalar z454 = z4 * z392;
    const Scalar z455 = z3 * z419 - z4 * z388;
    const Scalar z456 = z437 + z448;
    const Scalar z457 = z3 * z434 - z4 * z415;
    const Scalar z458 = k26 * (z274 + z425) - z457;  // moment on frame.2, y
    const Scalar z459 = s_roll * z455 - c_roll * z421;
    const Scalar z460 = z3 * z388 + z4 * z419;
    const Scalar z461 = k26 - z451;
    const Scalar z462 = z3 * z442 - z436;
    const Scalar z463 = k26 + z456;
    const Scalar z464 = s_yaw * z459 - c_yaw * z460;
    const Scalar z465 = s_yaw * z460 + c_yaw * z459;
    const Scalar z466 = z268 * z269;
    const Scalar z467 = c_roll * z375 + s_roll * z443;
    const Scalar z468 = s_roll * z375 - c_roll * z443;
    const Scalar z469 = s_roll * z447 + c_roll * z462;
    const Scalar z470 = s_roll * z421 + c_roll * z455;
    const Scalar z471 = n94 * z291 - z470;  // force on frame.z, z
    const Scalar z472 = z435 - z461;
    const Scalar z473 = s_yaw * z468;
    const Scalar z474 = c_yaw * z468;
    const Scalar z475 = n94 * a_x + z464;  // force on frame.z, x
    const Scalar z476 = n2 * z441;
    const Scalar z477 = n94 * a_y - z465;  // force on frame.z, y
    const Scalar z478 = c_roll * z476 + s_roll * z472;
    const Scalar z479 = z329 + z381;
    const Scalar z480 = n2 * z350;
    const Scalar z481 = n2 * z351;
    const Scalar z482 = n0_14 * z480;
    const Scalar z483 = n0_14 * z481;
    const Scalar z484 = n2 * z298;
    const Scalar z485 = n2 * z327;
    const Scalar z486 = n2 * z325;
    const Scalar z487 = z297 - z333;
    const Scalar z488 = s_roll * z478;
    const Scalar z489 = n2 * z321;
    const Scalar z490 = n2 * z372;
    const Scalar z491 = n0_14 * z490;
    const Scalar z492 = z8 * z482 + z7 * z483;
    const Scalar z493 = z7 * z482 - z8 * z483;
    const Scalar z494 = z461 + z488;
    const Scalar z495 = n2 * z322;
    const Scalar z496 = n2 * z345;
    const Scalar z497 = n0_1435 * z489 - z492;
    const Scalar z498 = k30 * z495 - z491;
    const Scalar z499 = k30 * z495 + z491;
    const Scalar z500 = k14 * z495;
    const Scalar z501 = n0_1435 * z496 - z493;
    const Scalar z502 = k14 * z489 - z493 - k30 * z496;
    const Scalar z503 = k12 * z496;
    const Scalar z504 = k14 * z496 - z492 + k30 * z489;
    const Scalar z505 = k10 * z484;
    const Scalar z506 = s_steer * z497 - c_steer * z498;
    const Scalar z507 = z501 + z502;
    const Scalar z508 = s_steer * z500 + c_steer * z507;
    const Scalar z509 = n2 * z271;
    const Scalar z510 = c_steer * z503;
    const Scalar z511 = k12 * z495;
    const Scalar z512 = n2 * z326;
    const Scalar z513 = n0_06 * z512;
    const Scalar z514 = n2 * z270;
    const Scalar z515 = s_steer * z503;
    const Scalar z516 = s_steer * z504 - c_steer * z499;
    const Scalar z517 = s_steer * z508;
    const Scalar z518 = z506 + z374 * z505 - k10 * z511;
    const Scalar z519 = s_yaw * z444 - c_yaw * z467;
    const Scalar z520 = n0_06 * z486;
    const Scalar z521 = c_yaw * z444 + s_yaw * z467;
    const Scalar z522 = n0_06 * z485;
    const Scalar z523 = k10 * z514;
    const Scalar z524 = z500 - z517;
    const Scalar z525 = k10 * z515 + z524;
    const Scalar z526 = z375 * z523 - z517;
    const Scalar z527 = c_steer * z508 - z501;
    const Scalar z528 = c_steer * z508 - z502;
    const Scalar z529 = z374 * z523 - z527 + k10 * z510;
    const Scalar z530 = z296 - z396;
    const Scalar z531 = s_steer * z498 + c_steer * z497;
    const Scalar z532 = z375 * z505 - z531;
    const Scalar z533 = v_roll * z269;
    const Scalar z534 = z276 - z533;
    const Scalar z535 = s_steer * z499 + c_steer * z504;
    const Scalar z536 = z268 * z268;
    const Scalar z537 = z269 * z269;
    const Scalar z538 = z536 + z537;
    const Scalar z539 = z274 - z425;
    const Scalar z540 = z516 - z513;
    const Scalar z541 = z518 + z513;
    const Scalar z542 = z5 * z522 + z6 * z520;
    const Scalar z543 = z5 * z520 - z6 * z522;
    const Scalar z544 = z528 - z543;
    const Scalar z545 = z532 + z542;
    const Scalar z546 = n2 * z269;
    const Scalar z547 = n2 * z268;
    const Scalar z548 = z535 - z542;
    const Scalar z549 = z529 + z543;
    const Scalar z550 = n2 * v_roll;
    const Scalar z551 = k32 * z484 - z540;
    const Scalar z552 = k33 * z484 + z541;
    const Scalar z553 = k33 * z509 + z545;
    const Scalar z554 = k33 * z514 - z544;
    const Scalar z555 = k32 * z509 - z548 + k22 * z514;
    const Scalar z556 = z549 + k22 * z509 + k33 * z514;
    const Scalar z557 = z292 * z468;
    const Scalar z558 = k17 * z484 + z515;
    const Scalar z559 = z510 + k17 * z509 + k16 * z514;
    const Scalar z560 = k16 * z484 - z511;
    const Scalar z561 = k22 * z484;
    const Scalar z562 = z525 + z561;
    const Scalar z563 = z500 + z561;
    const Scalar z564 = z4 * z558 + z3 * z560;
    const Scalar z565 = z551 - z552;
    const Scalar z566 = z562 + z563;
    const Scalar z567 = z269 * z564 + z421 - z375 * z538 - z444 * z539;
    const Scalar z568 = z3 * z565 - z4 * z566;
    const Scalar z569 = z444 * z534 - z443 * z538 + z268 * z564 - z455;
    const Scalar z570 = z314 * z444;
    const Scalar z571 = z3 * z558 - z4 * z560;
    const Scalar z572 = z271 * z559 + z388 - z375 * z530 - k17 * z479;
    const Scalar z573 = z375 * z487 - z440 * z479 + z270 * z559 - z419;
    const Scalar z574 = z288 * z443 + z292 * z445;
    const Scalar z575 = z4 * z568;
    const Scalar z576 = z444 * z546 + z559;
    const Scalar z577 = z4 * z553 + z3 * z554;
    const Scalar z578 = k26 * z550 - z577;
    const Scalar z579 = z440 * z530 + k17 * z487 + z271 * z558 + z270 * z560;
    const Scalar z580 = z3 * z553 - z4 * z554;
    const Scalar z581 = k26 * z546 + z580;
    const Scalar z582 = z562 + z575;
    const Scalar z583 = z563 + z575;
    const Scalar z584 = z444 * z547 - z571;
    const Scalar z585 = z375 * z547 - z443 * z546;
    const Scalar z586 = z4 * z555 + z3 * z556;
    const Scalar z587 = z312 * z375;
    const Scalar z588 = z526 + z582;
    const Scalar z589 = z375 * z534 + z443 * z539 + z268 * z559 + z269 * z571;
    const Scalar z590 = s_roll * z571 - c_roll * z559;
    const Scalar z591 = s_roll * z576 - c_roll * z584;
    const Scalar z592 = c_roll * z576 + s_roll * z584;
    const Scalar z593 = z526 + z563;
    const Scalar z594 = z436 * z530 - z429 * z479 - z431 * z487 + z313 * z375 + z415 + z271 * z551 + z270 * z593;
    const Scalar z595 = z3 * z568 - z551;
    const Scalar z596 = z3 * z568 + z552;
    const Scalar z597 = z562 - z563;
    const Scalar z598 = z526 - z562;
    const Scalar z599 = z596 + z441 * z546 - z461 * z547;
    const Scalar z600 = z463 * z538 - z314 * z375 - z304 * z443 - z447 * z539 - z462 * z534 - z269 * z581 + z268 * z595;
    const Scalar z601 = s_roll * z581 + c_roll * z595;
    const Scalar z602 = z586 - z578;
    const Scalar z603 = s_roll * z588 - c_roll * z602;
    const Scalar z604 = s_roll * z567 - c_roll * z569;
    const Scalar z605 = s_roll * z569 + c_roll * z567;
    const Scalar z606 = s_roll * z603;
    const Scalar z607 = z3 * z555 - z4 * z556;
    const Scalar z608 = z587 + z385 * z479 - z437 * z530 - z436 * z487 + z434 - z270 * z552 + z271 * z598;
    const Scalar z609 = z431 * z514 - z554 + z436 * z509;
    const Scalar z610 = z553 + z437 * z509 - z436 * z514;
    const Scalar z611 = k17 * z312 - z435 * z479 + z385 * z530 + z429 * z487 + z313 * z440 + z271 * z555 + z270 * z556;
    const Scalar z612 = z375 * z509 + z560;
    const Scalar z613 = z375 * z514 - z558;
    const Scalar z614 = z440 * z509 - k17 * z514;
    const Scalar z615 = z597 + z385 * z509 - z429 * z514;
    const Scalar z616 = z526 - z606;
    const Scalar z617 = z607 + z435 * z546 - z441 * z547;
    const Scalar z618 = z583 + z616;
    const Scalar z619 = c_roll * z599 + s_roll * z617;
    const Scalar z620 = z3 * z612 - z4 * z613;
    const Scalar z621 = z3 * z572 - z4 * z573;
    const Scalar z622 = z3 * z573 + z4 * z572;
    const Scalar z623 = c_roll * z579 + s_roll * z621;
    const Scalar z624 = s_roll * z579 - c_roll * z621;
    const Scalar z625 = s_yaw * z585 - c_yaw * z591;
    const Scalar z626 = c_yaw * z585 + s_yaw * z591;
    const Scalar z627 = s_yaw * z564 + c_yaw * z590;
    const Scalar z628 = s_yaw * z590 - c_yaw * z564;
    const Scalar z629 = z3 * z613 + z4 * z612;
    const Scalar z630 = c_yaw * z589 + s_yaw * z604;
    const Scalar z631 = s_yaw * z589 - c_yaw * z604;
    const Scalar z632 = s_yaw * z623 - c_yaw * z622;
    const Scalar z633 = s_yaw * z622 + c_yaw * z623;
    const Scalar z634 = z526 + z583;
    const Scalar z635 = z304 * z444 - z427 + z441 * z539 - z462 * z538 + z461 * z534 + z269 * z578 + z268 * z634;
    const Scalar z636 = z582 - z583;
    const Scalar z637 = z526 - z582;
    const Scalar z638 = z435 * z539 - z570 - z447 * z538 + z441 * z534 - z458 + z268 * z586 + z269 * z636;
    const Scalar z639 = z435 * z539 - z570 - z447 * z538 + z441 * z534 + z269 * z597 + z268 * z586;
    const Scalar z640 = s_roll * z597 - c_roll * z586;
    const Scalar z641 = c_roll * z635 + s_roll * z638;
    const Scalar z642 = z447 * z546 - z637 - z462 * z547;
    const Scalar z643 = z292 * z444 + z288 * z467;
    const Scalar z644 = z288 * z398 + z292 * z408;
    const Scalar z645 = k14 * z364 - k18 * z358 + k12 * z342 + z322 * z498 + z321 * z497;
    const Scalar z646 = z322 * z500 - z377 - k14 * z358 + k19 * z364 + z321 * z501;
    const Scalar z647 = z375 * z523 - z500;
    const Scalar z648 = z322 * z511 - z368 - k12 * z358;
    const Scalar z649 = z321 * z511 + z391;
    const Scalar z650 = z374 * z505 + z506;
    const Scalar z651 = k19 * z495 + z499;
    const Scalar z652 = z587 + z385 * z479 + z373 * z487 - z397 * z530 + z271 * z647 - z270 * z650;
    const Scalar z653 = z532 + z373 * z514 + z397 * z509;
    const Scalar z654 = z322 * z503 + k12 * z363;
    const Scalar z655 = c_steer * z649 + s_steer * z648;
    const Scalar z656 = s_steer * z649 - c_steer * z648;
    const Scalar z657 = k12 * z489;
    const Scalar z658 = n0_28 * z363;
    const Scalar z659 = z403 - z658 + z322 * z502;
    const Scalar z660 = z3 * z655 - z4 * z654;
    const Scalar z661 = z3 * z654 + z4 * z655;
    const Scalar z662 = s_roll * z620 - c_roll * z614;
    const Scalar z663 = s_roll * z614 + c_roll * z620;
    const Scalar z664 = z3 * z647 + z4 * z650;
    const Scalar z665 = z3 * z650 - z4 * z647;
    const Scalar z666 = z385 * z539 + z314 * z390 - z412 * z534 + z304 * z374 - z422 * z538 + z269 * z532 + z268 * z665;
    const Scalar z667 = z385 * z546 - z664 + z412 * z547;
    const Scalar z668 = s_roll * z532 - c_roll * z665;
    const Scalar z669 = c_roll * z656 + s_roll * z660;
    const Scalar z670 = s_roll * z656 - c_roll * z660;
    const Scalar z671 = z645 - k10 * z656;
    const Scalar z672 = s_yaw * z662 - c_yaw * z629;
    const Scalar z673 = s_yaw * z629 + c_yaw * z662;
    const Scalar z674 = s_yaw * z669 - c_yaw * z661;
    const Scalar z675 = s_yaw * z661 + c_yaw * z669;
    const Scalar z676 = z3 * z542 - z4 * z543;
    const Scalar z677 = z3 * z543 + z4 * z542;
    const Scalar z678 = s_steer * z659 - c_steer * z646;
    const Scalar z679 = c_steer * z659 + s_steer * z646;
    const Scalar z680 = k10 * z654 - z679;
    const Scalar z681 = z3 * z594 + z4 * z608;
    const Scalar z682 = z3 * z608 - z4 * z594;
    const Scalar z683 = n0_28 * z489 + z504;
    const Scalar z684 = c_roll * z681 + s_roll * z611;
    const Scalar z685 = z4 * z657 + z3 * z510;
    const Scalar z686 = z3 * z657 - z4 * z510;
    const Scalar z687 = c_roll * z515 + s_roll * z685;
    const Scalar z688 = s_roll * z515 - c_roll * z685;
    const Scalar z689 = k10 * z515;
    const Scalar z690 = c_yaw * z686 + s_yaw * z687;
    const Scalar z691 = s_yaw * z686 - c_yaw * z687;
    const Scalar z692 = s_steer * z651 + c_steer * z683;
    const Scalar z693 = s_steer * z683 - c_steer * z651;
    const Scalar z694 = k10 * z657 + z692;
    const Scalar z695 = z3 * z609 - z4 * z610;
    const Scalar z696 = z322 * z493 + z658;
    const Scalar z697 = z3 * z610 + z4 * z609;
    const Scalar z698 = n0_28 * z489 - z492;
    const Scalar z699 = s_roll * z615 + c_roll * z695;
    const Scalar z700 = c_steer * z493;
    const Scalar z701 = z392 * z487 - z393 * z479 + z271 * z492 + z270 * z700;
    const Scalar z702 = s_steer * z493;
    const Scalar z703 = z392 * z514 - z702;
    const Scalar z704 = z3 * z492 - z4 * z700;
    const Scalar z705 = z4 * z492 + z3 * z700;
    const Scalar z706 = z393 * z539 - z454 * z538 + z400 * z534 + z269 * z702 + z268 * z705;
    const Scalar z707 = n0_12 * z539 + z268 * z677;
    const Scalar z708 = z704 + z393 * z546 - z400 * z547;
    const Scalar z709 = c_roll * z677;
    const Scalar z710 = n0_12 * z546 + z676;
    const Scalar z711 = s_roll * z702 - c_roll * z705;
    const Scalar z712 = z73 - z88 * z111;
    const Scalar z713 = z76 - z85 * z111;
    const Scalar z714 = z212 - z713;
    const Scalar z715 = s_roll * z712 + z26 * z188;
    const Scalar z716 = z31 * z77;
    const Scalar z717 = s_roll * z713 + z24 * z188;
    const Scalar z718 = z30 * z77;
    const Scalar z719 = s_roll * z716 - z26 * z184;
    const Scalar z720 = s_roll * z718 - z24 * z184;
    const Scalar z721 = l_lambda_rear_rolls_x * z222 - l_lambda_rear_rolls_y * z217 + l_lambda_front_rolls_x * z205
        - l_lambda_front_rolls_y * z191;
    const Scalar z722 = z557 + z721;
    const Scalar z723 = l_lambda_rear_rolls_x * z720;
    const Scalar z724 = z4 * z689 + z3 * z693;
    const Scalar z725 = z3 * z689 - z4 * z693;
    const Scalar z726 = s_roll * z694 + c_roll * z724;
    const Scalar z727 = z3 * z678 - z4 * z671;
    const Scalar z728 = z3 * z671 + z4 * z678;
    const Scalar z729 = z210 - z712;
    const Scalar z730 = z204 * z729 - z245;
    const Scalar z731 = z204 * z714 - z244;
    const Scalar z732 = s_roll * z680 - c_roll * z727;
    const Scalar z733 = z73 - z712;
    const Scalar z734 = z76 - z713;
    const Scalar z735 = z58 * z733 - z240;
    const Scalar z736 = z58 * z734 - z251;
    const Scalar z737 = n2 * (z61 * z61 - z58 * z58);
    const Scalar z738 = s_yaw * z61;
    const Scalar z739 = n2 * z61;
    const Scalar z740 = z130 * z739 + z58 * (z66 + z738);
    const Scalar z741 = c_yaw * z71;
    const Scalar z742 = c_yaw * z61;
    const Scalar z743 = z137 * z739 + z58 * (z83 + z742);
    const Scalar z744 = s_yaw * z71;
    const Scalar z745 = n0_35 * z167 / (z101 * z101);
    const Scalar z746 = z741 - z111 * z143 + z88 * z745;
    const Scalar z747 = z103 / (z63 * z63);
    const Scalar z748 = n2 * (z87 * z737 - z149 * z149 - z139 * z139 - z143 * z143 + z85 * z740 + z88 * z743);
    const Scalar z749 = n2 * (c_roll * z27 + z30);
    const Scalar z750 = z744 - z111 * z139 + z85 * z745;
    const Scalar z751 = n2 * (c_roll * z29 + z31);
    const Scalar z752 = z30 * z747 - z77 * z35;
    const Scalar z753 = n2 * (s_roll * s_roll - c_roll * c_roll);
    const Scalar z754 = n2 * (z30 * z749 + z31 * z751 - z25 * z753 - z35 * z35 - z36 * z36 - z37 * z37);
    const Scalar z755 = z31 * z747 - z77 * z36;
    const Scalar z756 = l_lambda_rear_rolls_x * z220;
    const Scalar z757 = l_lambda_rear_rolls_y * z719 + z723;
    const Scalar z758 = l_lambda_front_rolls_x * z717 - z723 - l_lambda_rear_rolls_y * z719 + l_lambda_front_rolls_y
        * z715;
    const Scalar z759 = z574 - z758;
    const Scalar z760 = l_lambda_front_rolls_x * z736 + l_lambda_front_rolls_y * z735;
    const Scalar z761 = l_lambda_rear_rolls_x * z755 - l_lambda_rear_rolls_y * z752 - l_lambda_front_rolls_x * z746
        + l_lambda_front_rolls_y * z750;
    const Scalar z762 = l_lambda_rear_rolls_x * z718 + l_lambda_rear_rolls_y * z716 - l_lambda_front_rolls_x * z713
        - l_lambda_front_rolls_y * z712;
    const Scalar z763 = z643 + z762;
    const Scalar z764 = n0_5 * (z55 * z80 / (z63 * z63) + z754 / z63);
    const Scalar z765 = z641 + z761;
    const Scalar z766 = l_lambda_front_rolls_x * z731 + l_lambda_front_rolls_y * z730;
    const Scalar z767 = z644 - z766;
    const Scalar z768 = l_lambda_rear_touches + l_lambda_front_touches;
    const Scalar z769 = l_lambda_rear_rolls_x * z217 - l_lambda_rear_touches * z103 + l_lambda_rear_rolls_y * z222
        + l_lambda_front_touches * z182 + l_lambda_front_rolls_x * z191 + l_lambda_front_rolls_y * z205;
    const Scalar z770 = l_lambda_rear_rolls_y * z196 + z756 + l_lambda_front_touches * z180 + l_lambda_front_rolls_x
        * z215 + l_lambda_front_rolls_y * z195;
    const Scalar z771 = l_lambda_rear_rolls_y * z196 + z756;
    const Scalar z772 = l_lambda_front_touches * z197 + l_lambda_front_rolls_x * z246 + l_lambda_front_rolls_y * z247;
    const Scalar z773 = n0_3 * z764;
    const Scalar z774 = l_lambda_rear_rolls_x + l_lambda_front_rolls_x;
    const Scalar z775 = n0_5 * (z154 * z167 / (z101 * z101) + z748 / z101);
    const Scalar z776 = l_lambda_rear_rolls_x * z185 + l_lambda_rear_rolls_y * z183 + l_lambda_front_rolls_x * z187
        + l_lambda_front_rolls_y * z186;
    const Scalar z777 = l_lambda_rear_rolls_y + l_lambda_front_rolls_y;
    const Scalar z778 = z71 - n0_35 * z775;
    const Scalar z779 = z70 - z111 * z149 - z87 * z745;
    const Scalar z780 = s_yaw * z779;
    const Scalar z781 = c_yaw * z779;
    const Scalar z782 = z25 * z747 - z77 * z37;
    const Scalar z783 = c_yaw * z782;
    const Scalar z784 = s_yaw * z782;
    const Scalar z785 = l_lambda_front_rolls_x * z243 + l_lambda_front_rolls_y * z252;
    const Scalar z786 = z200 - z779;
    const Scalar z787 = z741 - z746;
    const Scalar z788 = z70 - z779;
    const Scalar z789 = z744 - z750;
    const Scalar z790 = s_yaw * z129;
    const Scalar z791 = z58 * z790 + z130 * z129 + z61 * z131 + z66 * z127;
    const Scalar z792 = n2 * (z61 * z129 - z58 * z127);
    const Scalar z793 = c_yaw * z133;
    const Scalar z794 = z58 * z793 + z137 * z133 + z61 * z135 - z83 * z132;
    const Scalar z795 = c_yaw * z129;
    const Scalar z796 = z58 * z795 + z61 * z128 + z137 * z129 + z83 * z127;
    const Scalar z797 = n2 * (z58 * z132 + z61 * z133);
    const Scalar z798 = s_roll * z68;
    const Scalar z799 = s_roll * z169 - c_roll * z170;
    const Scalar z800 = s_yaw * z133;
    const Scalar z801 = z61 * z134 - z58 * z800 + z66 * z132 - z130 * z133;
    const Scalar z802 = n0_35 * z166 / (z101 * z101);
    const Scalar z803 = s_yaw * z67 - c_yaw * z798;
    const Scalar z804 = s_yaw * z798 + c_yaw * z67;
    const Scalar z805 = n2 * (z87 * z792 - z149 * z136 + z139 * z147 + z143 * z140 + z85 * z791 + z88 * z796);
    const Scalar z806 = n2 * (z149 * z151 - z87 * z797 + z139 * z141 - z143 * z146 - z88 * z794 + z85 * z801);
    const Scalar z807 = c_yaw * z204;
    const Scalar z808 = c_yaw * z211;
    const Scalar z809 = z746 - z808;
    const Scalar z810 = s_yaw * z204;
    const Scalar z811 = z88 * z802 - z803 - z111 * z140;
    const Scalar z812 = z171 - z111 * z136 + z87 * z802;
    const Scalar z813 = s_yaw * z211;
    const Scalar z814 = z750 - z813;
    const Scalar z815 = z804 - z111 * z147 + z85 * z802;
    const Scalar z816 = s_yaw * z812;
    const Scalar z817 = c_yaw * z812;
    const Scalar z818 = z203 * z238 - z236 * z807 - z204 * z809 + z206 * z786;
    const Scalar z819 = c_roll * z186 - z27 * z188 + s_roll * z750 - z24 * z779;
    const Scalar z820 = z61 * z237 + z137 * z235 + z58 * z787 - z83 * z788;
    const Scalar z821 = z27 * z184 - c_roll * z183 + s_roll * z752 + z24 * z782;
    const Scalar z822 = z203 * z242 + z236 * z810 + z204 * z814 - z207 * z786;
    const Scalar z823 = s_roll * z746 - c_roll * z187 - z26 * z779 - z29 * z188;
    const Scalar z824 = z61 * z239 - z130 * z235 - z58 * z789 + z66 * z788;
    const Scalar z825 = c_roll * z185 + z29 * z184 + s_roll * z755 + z26 * z782;
    const Scalar z826 = n0_5 * (z154 * z166 / (z101 * z101) - z805 / z101);
    const Scalar z827 = n0_5 * (z167 * z153 / (z101 * z101) - z805 / z101);
    const Scalar z828 = z798 - n0_35 * z826;
    const Scalar z829 = z798 - n0_35 * z827;
    const Scalar z830 = n0_5 * (z167 * z155 / (z101 * z101) - z806 / z101);
    const Scalar z831 = z799 + n0_35 * z830;
    const Scalar z832 = l_lambda_rear_rolls_x * z825;
    const Scalar z833 = l_lambda_front_rolls_x * z820 + l_lambda_front_rolls_y * z824;
    const Scalar z834 = z706 + z833;
    const Scalar z835 = l_lambda_rear_rolls_y * z821 - z832;
    const Scalar z836 = l_lambda_rear_rolls_y * z821 - z832 + l_lambda_front_touches * z829 - l_lambda_front_rolls_y
        * z819 + l_lambda_front_rolls_x * z823;
    const Scalar z837 = z707 - z835;
    const Scalar z838 = l_lambda_front_rolls_x * z811 - l_lambda_front_rolls_y * z815;
    const Scalar z839 = z684 + z838;
    const Scalar z840 = l_lambda_rear_touches * z773 + l_lambda_rear_rolls_x * z784 + l_lambda_rear_rolls_y * z783
        + l_lambda_front_rolls_x * z780 + l_lambda_front_rolls_y * z781 - l_lambda_front_touches * z778;
    const Scalar z841 = z600 + z840;
    const Scalar z842 = s_yaw * z57 + z59;
    const Scalar z843 = c_yaw * z57 - z78;
    const Scalar z844 = z639 - z836;
    const Scalar z845 = c_roll * z46;
    const Scalar z846 = c_roll * z126;
    const Scalar z847 = s_roll * z126;
    const Scalar z848 = n2 * (z58 * z845 - z129 * z129);
    const Scalar z849 = s_pitch * z161 - c_pitch * z159;
    const Scalar z850 = s_yaw * z125 + c_yaw * z847;
    const Scalar z851 = s_yaw * z847 - c_yaw * z125;
    const Scalar z852 = z58 * z850 - z128 * z133 - z129 * z135 - z83 * z846;
    const Scalar z853 = z129 * z134 + z58 * z851 - z131 * z133 - z66 * z846;
    const Scalar z854 = n2 * (z58 * z846 - z129 * z133);
    const Scalar z855 = n2 * z129;
    const Scalar z856 = z58 * z842 - z131 * z855 - z66 * z845;
    const Scalar z857 = z58 * z843 - z128 * z855 - z83 * z845;
    const Scalar z858 = n2 * (z136 * z151 + z87 * z854 + z140 * z146 - z147 * z141 + z88 * z852 + z85 * z853);
    const Scalar z859 = n2 * (z136 * z136 + z87 * z848 + z140 * z140 + z147 * z147 + z85 * z856 + z88 * z857);
    const Scalar z860 = s_roll * z202;
    const Scalar z861 = c_roll * z202;
    const Scalar z862 = s_roll * z198;
    const Scalar z863 = s_yaw * z201 - c_yaw * z860;
    const Scalar z864 = n0_5 * (z153 * z166 / (z101 * z101) - z859 / z101);
    const Scalar z865 = c_roll * z198;
    const Scalar z866 = z812 - z865;
    const Scalar z867 = s_yaw * z199 - c_yaw * z862;
    const Scalar z868 = z811 + z867;
    const Scalar z869 = z26 * z812 + s_roll * z811;
    const Scalar z870 = s_roll * z815 + z24 * z812;
    const Scalar z871 = c_roll * z67;
    const Scalar z872 = c_roll * z849;
    const Scalar z873 = n0_5 * (z166 * z155 / (z101 * z101) + z858 / z101);
    const Scalar z874 = l_lambda_front_touches * z831 + l_lambda_front_rolls_x * z818 + l_lambda_front_rolls_y * z822;
    const Scalar z875 = z666 + z874;
    const Scalar z876 = z171 - z812;
    const Scalar z877 = z804 - z815;
    const Scalar z878 = z803 + z811;
    const Scalar z879 = n0_5 * (z154 * z168 / (z101 * z101) - z806 / z101);
    const Scalar z880 = z871 - n0_35 * z864;
    const Scalar z881 = z799 + n0_35 * z879;
    const Scalar z882 = z872 + n0_35 * z873;
    const Scalar z883 = s_yaw * z849 - c_yaw * z799;
    const Scalar z884 = c_yaw * z849 + s_yaw * z799;
    const Scalar z885 = n0_35 * z168 / (z101 * z101);
    const Scalar z886 = c_yaw * z201 + s_yaw * z860;
    const Scalar z887 = z883 + z111 * z146 + z88 * z885;
    const Scalar z888 = c_yaw * z199 + s_yaw * z862;
    const Scalar z889 = z815 - z888;
    const Scalar z890 = z85 * z885 - z884 - z111 * z141;
    const Scalar z891 = z238 * z861 - z236 * z863 - z206 * z866 + z204 * z868;
    const Scalar z892 = z236 * z886 - z242 * z861 + z204 * z889 - z207 * z866;
    const Scalar z893 = z129 * z237 + z128 * z235 - z83 * z876 + z58 * z878;
    const Scalar z894 = z129 * z239 - z131 * z235 + z58 * z877 + z66 * z876;
    const Scalar z895 = l_lambda_front_rolls_x * z893 + l_lambda_front_rolls_y * z894;
    const Scalar z896 = l_lambda_front_touches * z880 - l_lambda_front_rolls_y * z870 + l_lambda_front_rolls_x * z869;
    const Scalar z897 = z701 + z895;
    const Scalar z898 = z611 + z896;
    const Scalar z899 = l_lambda_front_rolls_x * z887 - l_lambda_front_rolls_y * z890;
    const Scalar z900 = z732 - z899;
    const Scalar z901 = l_lambda_front_rolls_x * z816 + l_lambda_front_rolls_y * z817 + l_lambda_front_touches * z828;
    const Scalar z902 = z682 + z901;
    const Scalar z903 = z883 - z887;
    const Scalar z904 = z884 + z890;
    const Scalar z905 = n0_5 * (z153 * z168 / (z101 * z101) + z858 / z101);
    const Scalar z906 = z872 + n0_35 * z905;
    const Scalar z907 = z321 * z372;
    const Scalar z908 = z345 * z372;
    const Scalar z909 = z271 * z326;
    const Scalar z910 = z270 * z326;
    const Scalar z911 = n0_28 * z907;  // moment on front_wheel, y
    const Scalar z912 = n0_28 * z908;  // moment on front_wheel, x
    const Scalar z913 = n2 * (z133 * z135 + z58 * z83);
    const Scalar z914 = z911 + k18 * z356 + k19 * z359 + k14 * z363 + k12 * z341;  // moment on fork, z
    const Scalar z915 = n2 * (z58 * z58 - z133 * z133);
    const Scalar z916 = z111 * z151 - z172 + z87 * z885;
    const Scalar z917 = z172 + z916;
    const Scalar z918 = s_yaw * z916;
    const Scalar z919 = c_yaw * z916;
    const Scalar z920 = s_roll * z887 + z26 * z916;
    const Scalar z921 = z24 * z916 + s_roll * z890;
    const Scalar z922 = n2 * (z58 * z66 - z133 * z134);
    const Scalar z923 = n2 * (z88 * z913 - z151 * z151 - z87 * z915 - z141 * z141 - z146 * z146 + z85 * z922);
    const Scalar z924 = z204 * z887 - z206 * z916;
    const Scalar z925 = z204 * z890 - z207 * z916;
    const Scalar z926 = z133 * z237 + z135 * z235 + z58 * z903 - z83 * z917;
    const Scalar z927 = n0_5 * (z155 * z168 / (z101 * z101) + z923 / z101);
    const Scalar z928 = c_steer * z13;
    const Scalar z929 = z133 * z239 + z134 * z235 + z66 * z917 + z58 * z904;
    const Scalar z930 = c_steer * (n1 - z12);
    const Scalar z931 = n0_08 * z930 - n0_35 * z928;
    const Scalar z932 = c_steer * (n1 - z14);
    const Scalar z933 = n0_08 * z928 - n0_35 * z932;
    const Scalar z934 = l_lambda_front_rolls_x * z926 + l_lambda_front_rolls_y * z929;
    const Scalar z935 = z696 + z934;
    const Scalar z936 = l_lambda_front_rolls_x * z920 - l_lambda_front_rolls_y * z921 - l_lambda_front_touches * z906;
    const Scalar z937 = c_pitch * z933 + s_pitch * z931;
    const Scalar z938 = z680 - z936;
    const Scalar z939 = l_lambda_front_rolls_x * z891 - l_lambda_front_rolls_y * z892 - l_lambda_front_touches * z882;
    const Scalar z940 = z652 - z939;
    const Scalar z941 = z912 + k18 * z361 + k19 * z349 + k14 * z362;  // moment on fork, x
    const Scalar z942 = c_roll * z937 - z56;
    const Scalar z943 = z942 + n0_35 * z927;
    const Scalar z944 = z471 - z768;
    const Scalar z945 = z475 - z774;
    const Scalar z946 = z477 + z777;
    const Scalar z947 = n0_12 * z909;  // moment on rear_wheel, y
    const Scalar z948 = k16 * z314 - z947 - k21 * z333 + k22 * z414 + k10 * z399 - z914;  // moment on frame, y
    const Scalar z949 = z772 - z914;
    const Scalar z950 = n0_12 * z910;  // moment on rear_wheel, x
    const Scalar z951 = c_steer * z941 - z428;
    const Scalar z952 = z950 + k17 * z314 + k23 * z396 - k24 * z296 - k22 * z335 + z951;  // moment on frame, x
    const Scalar z953 = s_steer * z941 + z417;
    // moment on frame, z
    const Scalar z954 = z367 + k23 * z299 - k24 * z328 + k22 * z386 - k16 * z312 + k17 * z313 - k10 * z369 - z953;
    const Scalar z955 = z367 - z771;
    const Scalar z956 = z770 - z954;
    const Scalar z957 = l_lambda_front_rolls_x * z918 + l_lambda_front_rolls_y * z919 - l_lambda_front_touches * z881;
    const Scalar z958 = z728 - z957;
    const Scalar z959 = z371 - z785;
    const Scalar z960 = z31 * z214 - z221;
    const Scalar z961 = z22 * z716 + z33 * z184 + s_roll * z960 - z233;
    const Scalar z962 = a_z - a_roll * z103 - z122;
    const Scalar z963 = a_z + a_roll * z182 - a_pitch * z180 - a_steer * z197 + z249;
    const Scalar z964 = a_y - z196 * (a_pitch + a_rear) - a_yaw * z183 + a_roll * z222 - z265;
    const Scalar z965 = a_x + a_yaw * z187 - a_roll * z191 + a_pitch * z215 + a_steer * z246 + a_front * z243 + z347;
    const Scalar z966 = a_y - a_yaw * z186 + a_roll * z205 - a_pitch * z195 - a_steer * z247 - a_front * z252 - z365;
    const Scalar z967 = z220 * (a_pitch + a_rear) + a_x + a_yaw * z185 - a_roll * z217 + z266;
    const Scalar z968 = v_yaw * z713;
    const Scalar z969 = v_yaw * z716;
    const Scalar z970 = v_roll * z217 - z969 - z719 * (v_pitch + v_rear);
    const Scalar z971 = v_roll * z217 - z969 - z719 * (v_pitch + v_rear) + z219;
    const Scalar z972 = v_roll * z205 - z968 - v_pitch * z717 - v_steer * z731 + v_front * z736;
    const Scalar z973 = v_roll * z205 - z968 - v_pitch * z717 - v_steer * z731 + v_front * z736 - z295;
    const Scalar z974 = z282 - z111 * z114 + z85 * z257;
    const Scalar z975 = z311 - z22 * z713 + s_roll * z974 - z24 * z263;
    const Scalar z976 = z303 + z974;
    const Scalar z977 = z262 * z714 - z316 + z204 * z976 - z207 * z306;
    const Scalar z978 = z282 - z974;
    const Scalar z979 = z109 * z734 - z317 + z58 * z978 + z66 * z267;
    const Scalar z980 = l_lambda_front_rolls_x * z924 - l_lambda_front_touches * z943 - l_lambda_front_rolls_y * z925;
    const Scalar z981 = v_yaw * z960 - v_roll * z232 + z961 * (v_pitch + v_rear);
    const Scalar z982 = v_yaw * z974 + v_pitch * z975 + v_roll * z319 - v_steer * z977 - v_front * z979;
    const Scalar z983 = z645 + z980;
    const Scalar z984 = z719 * (a_pitch + a_rear) + a_yaw * z716 - a_roll * z217 + z981;
    const Scalar z985 = a_yaw * z713 - a_roll * z205 + a_pitch * z717 + a_steer * z731 - a_front * z736 - z982;
    const Scalar z986 = z30 * z214 - z194;
    const Scalar z987 = z22 * z718 + z32 * z184 + s_roll * z986 - z230;
    const Scalar z988 = c_yaw * z22 - s_roll * z23;
    const Scalar z989 = z22 * z27;
    const Scalar z990 = s_yaw * z22 + s_roll * z21;
    const Scalar z991 = z24 * z19 + z989 + s_roll * z990 + c_roll * z32;
    const Scalar z992 = v_yaw * z986 + z987 * (v_pitch + v_rear) + v_roll * z229;
    const Scalar z993 = v_yaw * z712;
    const Scalar z994 = v_yaw * z718;
    const Scalar z995 = z993 + v_roll * z191 + v_pitch * z715 + v_steer * z730 - v_front * z735;
    const Scalar z996 = z720 * (a_pitch + a_rear) + a_yaw * z718 + a_roll * z222 + z992;
    const Scalar z997 = z993 + v_roll * z191 + v_pitch * z715 + v_steer * z730 - v_front * z735 + z307;
    const Scalar z998 = z994 + v_roll * z222 + z720 * (v_pitch + v_rear);
    const Scalar z999 = z994 + v_roll * z222 + z720 * (v_pitch + v_rear) - z227;
    const Scalar z1000 = z261 + z111 * z112 + z88 * z257;
    const Scalar z1001 = z289 + z1000;
    const Scalar z1002 = z259 - z22 * z712 + s_roll * z1000 - z26 * z263;
    const Scalar z1003 = z262 * z729 + z315 + z204 * z1001 - z206 * z306;
    const Scalar z1004 = z261 - z1000;
    const Scalar z1005 = z109 * z733 + z318 + z58 * z1004 + z83 * z267;
    const Scalar z1006 = z3 * z948 + z4 * z952;
    const Scalar z1007 = k26 * (a_roll + z466) - z1006;  // moment on frame.2, z
    const Scalar z1008 = z3 * z952 - z4 * z948;
    const Scalar z1009 = k26 * (z274 + z425) - z1008;  // moment on frame.2, y
    const Scalar z1010 = v_yaw * z1000 - v_roll * z264 + v_pitch * z1002 - v_steer * z1003 - v_front * z1005;
    const Scalar z1011 = a_yaw * z712 + a_roll * z191 + a_pitch * z715 + a_steer * z730 - a_front * z735 - z1010;
    const Scalar z1012 = z769 + z1007;
    const Scalar z1013 = s_roll * z954 - c_roll * z1009;
    const Scalar z1014 = z776 - z1013;
    const Scalar z1015 = z41 * z67 - z38 * z44 - c_roll * z163 + n2 * (z22 * z115 - z19 * z102) + s_roll * z226;
    const Scalar z1016 = n2 * (s_roll * z115 + z253) - z40 * z44 - z42 * z67;
    const Scalar z1017 = c_steer * z40 + z42 * z46 + n2 * (s_roll * z105 + z104);
    const Scalar z1018 = c_roll * z33;
    const Scalar z1019 = z109 * z130;
    const Scalar z1020 = z26 * z19 + z22 * z29 + s_roll * z988 + z1018;
    const Scalar z1021 = z53 * z35;
    const Scalar z1022 = c_roll * z22;
    const Scalar z1023 = s_yaw * z109 - z21 * z58;
    const Scalar z1024 = z109 * z137;
    const Scalar z1025 = n2 * (z61 * z109 + z58 * z107);
    const Scalar z1026 = z150 * z149;
    const Scalar z1027 = z23 * z58 + c_yaw * z109;
    const Scalar z1028 = n2 * (s_roll * z19 - z1022);
    const Scalar z1029 = z28 * z40 - n4 * z1022;
    const Scalar z1030 = z66 * z107 - z1019 - z58 * z1023 + z61 * z113;
    const Scalar z1031 = z1024 - z83 * z107 + z58 * z1027 + z61 * z110;
    const Scalar z1032 = n4 * z109;
    const Scalar z1033 = n2 * (z31 * z1020 - z1021 - z34 * z37 - z25 * z1028 - z54 * z36 + z30 * z991);
    const Scalar z1034 = z64 * z80;
    const Scalar z1035 = n2 * (z61 * z175 - z58 * z164) - z107 * z1032;
    const Scalar z1036 = n2 * (z1026 - z87 * z1025 - z112 * z143 + z85 * z1030 - z88 * z1031 + z114 * z139);
    const Scalar z1037 = z165 * z167;
    const Scalar z1038 = z40 * z46 - c_steer * z42 + n2 * (s_roll * z93 - c_roll * z105);
    const Scalar z1039 = n4 * z22 * z19 + n2 * (s_roll * z38 + c_roll * z41);
    const Scalar z1040 = z43 * z58 - z23 * z176 + c_yaw * z175;
    const Scalar z1041 = z39 * z58 + z21 * z176 + s_yaw * z175;
    const Scalar z1042 = n2 * (z109 * z1027 + z107 * z110) - z83 * z164 - z137 * z175 + z61 * z177 - z58 * z1040;
    const Scalar z1043 = z66 * z164 + z130 * z175 - n2 * (z109 * z1023 - z107 * z113) + z61 * z173 + z58 * z1041;
    const Scalar z1044 = n4 * (z150 * z1025 + z114 * z1030 + z112 * z1031) + n2 * (z87 * z1035 - z149 * z178 - z143
        * z179 + z139 * z181 - z88 * z1042 + z85 * z1043);
    const Scalar z1045 = s_yaw * z1038 - z21 * z108;
    const Scalar z1046 = z66 * z1017 - z58 * z1045 + n2 * (z61 * z113 - z1019);
    const Scalar z1047 = z23 * z108 + c_yaw * z1038;
    const Scalar z1048 = z58 * z1047 - z83 * z1017 + n2 * (z61 * z110 + z1024);
    const Scalar z1049 = n4 * z61 * z109 + z108 * z1017;
    const Scalar z1050 = n0_7 * z174;
    const Scalar z1051 = s_yaw * z41 + s_roll * z39 - z21 * z42;
    const Scalar z1052 = z27 * z41 - z24 * z38 - n2 * (z22 * z990 - z19 * z32) + s_roll * z1051 - c_roll * z48;
    const Scalar z1053 = n4 * (z1026 - z112 * z143 + z114 * z139) + n2 * (z85 * z1046 - z88 * z1048 - z87 * z1049);
    const Scalar z1054 = n0_5 * (z1034 / (z63 * z63) + z1033 / z63);
    const Scalar z1055 = n0_5 * (z1037 / (z101 * z101) - z1053 / z101 + z174 * z154 / (z101 * z101));
    const Scalar z1056 = n0_5 * (z1037 / (z101 * z101) - z1036 / z101);
    const Scalar z1057 = n0_5 * (z1044 / z101 - z167 * z190 / (z101 * z101) - z174 * z1036 / (z101 * z101) + z165
        * z1056 / (z101 * z101)) + z167 * z216 / (z101 * z101 * z101);
    const Scalar z1058 = z167 * z1050 / (z101 * z101 * z101) + n0_35 * z1056 / (z101 * z101);
    const Scalar z1059 = z255 - n0_35 * z1056;
    const Scalar z1060 = z21 * z28 + s_yaw * z42;
    const Scalar z1061 = z24 * z40 + s_roll * z1060 + n2 * (c_roll * z32 + z989);
    const Scalar z1062 = z255 - z111 * z1025 + z150 * z745 + z149 * z257 + z87 * z1058;
    const Scalar z1063 = z1015 - n0_35 * z1057;
    const Scalar z1064 = z1016 - n0_35 * z1055;
    const Scalar z1065 = c_yaw * z42 - z23 * z28;
    const Scalar z1066 = a_roll * z778 + a_pitch * z829 + a_steer * z831 - z1063;
    const Scalar z1067 = z26 * z40 + s_roll * z1065 + n2 * (z22 * z29 + z1018);
    const Scalar z1068 = c_yaw * z41 + s_roll * z43 + z23 * z42;
    const Scalar z1069 = n2 * (z30 * z1061 + z31 * z1067 - z25 * z1029) - n4 * (z1021 + z34 * z37 + z54 * z36);
    const Scalar z1070 = z29 * z41 - z26 * z38 - n2 * (z22 * z988 - z19 * z33) + s_roll * z1068 - c_roll * z49;
    const Scalar z1071 = n4 * (z54 * z1020 - z34 * z1028 + z53 * z991) + n2 * (z25 * z1039 - z37 * z50 + z35 * z65 + z36
        * z69 + z30 * z1052 + z31 * z1070);
    const Scalar z1072 = n0_5 * (z81 * z1033 / (z63 * z63) + z80 * z72 / (z63 * z63) - z1071 / z63 + z64 * z1054 / (z63
        * z63)) + z81 * z1034 / (z63 * z63 * z63);
    const Scalar z1073 = n0_5 * (z81 * z55 / (z63 * z63) + z1034 / (z63 * z63) + z1069 / z63);
    const Scalar z1074 = n0_3 * z1054;
    const Scalar z1075 = z286 + z1062;
    const Scalar z1076 = n0_3 * z1073;
    const Scalar z1077 = n0_6 * z81 * z80 / (z63 * z63 * z63) + z1074 / (z63 * z63);
    const Scalar z1078 = z255 - z1062;
    const Scalar z1079 = v_roll * z780;
    const Scalar z1080 = v_yaw * z746 - z1079 + z264 + v_steer * z818 - v_front * z820 + v_pitch * z823;
    const Scalar z1081 = v_yaw * z746 - z1079 + v_steer * z818 - v_front * z820 + v_pitch * z823;
    const Scalar z1082 = n0_3 * z1072;
    const Scalar z1083 = a_roll * z773 + z1082;
    const Scalar z1084 = z77 * z1028 - z34 * z747 - z37 * z214 + z25 * z1077;
    const Scalar z1085 = z30 * z1077 - z77 * z991 - z53 * z747 - z35 * z214;
    const Scalar z1086 = z31 * z1077 - z77 * z1020 - z54 * z747 - z36 * z214;
    const Scalar z1087 = z23 * z46;
    const Scalar z1088 = c_roll * z106 - z19 * z45;
    const Scalar z1089 = z22 * z45 + s_roll * z106;
    const Scalar z1090 = z21 * z46 - z23 * z127 + s_yaw * z105 + c_yaw * z1089;
    const Scalar z1091 = z19 * z183 + z184 * z990 - c_roll * z219 + z22 * z752 - z32 * z782 + z27 * z225 + z24 * z1084
        + s_roll * z1085;
    const Scalar z1092 = z184 * z988 - z19 * z185 + c_roll * z227 + z22 * z755 - z33 * z782 + z29 * z225 + z26 * z1084
        + s_roll * z1086;
    const Scalar z1093 = z109 * z128;
    const Scalar z1094 = z112 * z140;
    const Scalar z1095 = z21 * z127 + z1087 - c_yaw * z105 + s_yaw * z1089;
    const Scalar z1096 = n2 * (z58 * z1088 - z109 * z129);
    const Scalar z1097 = z58 * z1090 - z1093 - z83 * z1088 - z110 * z129;
    const Scalar z1098 = z58 * z1095 - z66 * z1088 - z109 * z131 + z113 * z129;
    const Scalar z1099 = v_yaw * z750;
    const Scalar z1100 = v_roll * z781 + z1099 + v_pitch * z819 - v_steer * z822 + v_front * z824 - z319;
    const Scalar z1101 = v_roll * z781 + z1099 + v_pitch * z819 - v_steer * z822 + v_front * z824;
    const Scalar z1102 = n2 * (z1094 + z150 * z136 + z87 * z1096 - z114 * z147 + z88 * z1097 + z85 * z1098);
    const Scalar z1103 = z19 * z68 + c_roll * z254;
    const Scalar z1104 = v_yaw * z752;
    const Scalar z1105 = v_roll * z783 - z1104 - z229 - z821 * (v_pitch + v_rear);
    const Scalar z1106 = v_roll * z783 - z1104 - z821 * (v_pitch + v_rear);
    const Scalar z1107 = c_yaw * z262 - z23 * z204;
    const Scalar z1108 = c_yaw * z119 - z23 * z71;
    const Scalar z1109 = z21 * z71 + s_yaw * z119;
    const Scalar z1110 = z1108 - z111 * z1031 + z112 * z745 - z143 * z257 + z88 * z1058;
    const Scalar z1111 = z1109 + z111 * z1030 - z114 * z745 - z139 * z257 + z85 * z1058;
    const Scalar z1112 = z165 * z166;
    const Scalar z1113 = n0_5 * (z1112 / (z101 * z101) + z1102 / z101);
    const Scalar z1114 = z21 * z204 + s_yaw * z262;
    const Scalar z1115 = v_yaw * z755;
    const Scalar z1116 = v_roll * z784 + z1115 - z232 + z825 * (v_pitch + v_rear);
    const Scalar z1117 = z19 * z187 - z188 * z988 + z22 * z746 + z33 * z779 - c_roll * z295 - z29 * z263 + s_roll
        * z1110 + z26 * z1062;
    const Scalar z1118 = z22 * z750 - z19 * z186 - z188 * z990 + z32 * z779 + c_roll * z307 - z27 * z263 + s_roll
        * z1111 + z24 * z1062;
    const Scalar z1119 = v_roll * z784 + z1115 + z825 * (v_pitch + v_rear);
    const Scalar z1120 = z1108 - z1110;
    const Scalar z1121 = z61 * z285 - z107 * z237 - z235 * z1027 - z109 * z787 - z110 * z788 + z137 * z267 + z58 * z1120
        + z83 * z1078;
    const Scalar z1122 = z1109 - z1111;
    const Scalar z1123 = z235 * z1023 - z107 * z239 + z109 * z789 - z113 * z788 + z61 * z302 - z130 * z267 - z58 * z1122
        - z66 * z1078;
    const Scalar z1124 = z1103 + n0_35 * z1113;
    const Scalar z1125 = c_yaw * z300 - z23 * z211;
    const Scalar z1126 = z21 * z211 + s_yaw * z300;
    const Scalar z1127 = z1110 - z1125;
    const Scalar z1128 = z1111 - z1126;
    const Scalar z1129 = s_yaw * z1062 - z21 * z779;
    const Scalar z1130 = z236 * z1107 - z238 * z279 + z262 * z809 + z283 * z786 + z203 * z294 + z306 * z807 + z204
        * z1127 - z206 * z1075;
    const Scalar z1131 = z242 * z279 + z236 * z1114 + z262 * z814 - z308 * z786 + z203 * z310 + z306 * z810 + z204
        * z1128 - z207 * z1075;
    const Scalar z1132 = v_yaw * z1110 + v_roll * z1129 + v_pitch * z1117 - v_steer * z1130 - v_front * z1121;
    const Scalar z1133 = a_yaw * z746 - a_roll * z780 + a_pitch * z823 + a_steer * z818 - a_front * z820 + z1132;
    const Scalar z1134 = z60 * z138 + s_pitch * z209 + c_pitch * z193 + z62 * z142 + n2 * (z90 * z99 - z100 * z91);
    const Scalar z1135 = z23 * z779 + c_yaw * z1062;
    const Scalar z1136 = v_yaw * z1111 - v_roll * z1135 + v_pitch * z1118 - v_steer * z1131 + v_front * z1123;
    const Scalar z1137 = z38 * z68 - z40 * z254 + c_roll * z1134;
    const Scalar z1138 = n2 * z91;
    const Scalar z1139 = n2 * z90;
    const Scalar z1140 = z62 * z1138 - z60 * z1139 + n2 * (c_pitch * z100 + z250);
    const Scalar z1141 = z15 * z1138 + z16 * z1139 + n2 * (s_pitch * z95 - c_pitch * z94);
    const Scalar z1142 = z15 * z1139 - z16 * z1138 + n2 * (s_pitch * z94 + c_pitch * z95);
    const Scalar z1143 = a_yaw * z750 + a_roll * z781 + a_pitch * z819 - a_steer * z822 + a_front * z824 + z1136;
    const Scalar z1144 = z40 * z68 + c_roll * z1140;
    const Scalar z1145 = z42 * z45 + s_roll * z1141;
    const Scalar z1146 = n2 * (z21 * z127 + z1087) - c_yaw * z1142 + s_yaw * z1145;
    const Scalar z1147 = n2 * (z21 * z46 - z23 * z127) + s_yaw * z1142 + c_yaw * z1145;
    const Scalar z1148 = c_roll * z1141 - z40 * z45;
    const Scalar z1149 = z58 * z1147 - z83 * z1148 - n2 * (z110 * z129 + z1093);
    const Scalar z1150 = z58 * z1146 - z66 * z1148 - n2 * (z109 * z131 - z113 * z129);
    const Scalar z1151 = z108 * z1148 - z129 * z1032;
    const Scalar z1152 = c_yaw * z1084 - z23 * z782;
    const Scalar z1153 = n2 * (z87 * z1151 + z85 * z1150 + z88 * z1149) - n4 * (z114 * z147 - z1094 - z150 * z136);
    const Scalar z1154 = v_yaw * z1085 - v_roll * z1152 + z1091 * (v_pitch + v_rear);
    const Scalar z1155 = z821 * (a_pitch + a_rear) + a_yaw * z752 - a_roll * z783 + z1154;
    const Scalar z1156 = s_roll * z254 - z22 * z68;
    const Scalar z1157 = z21 * z782 + s_yaw * z1084;
    const Scalar z1158 = v_roll * z1157 + v_yaw * z1086 + z1092 * (v_pitch + v_rear);
    const Scalar z1159 = n0_5 * (z1153 / z101 + z1112 / (z101 * z101) + z174 * z153 / (z101 * z101));
    const Scalar z1160 = z38 * z45 + z40 * z106 + c_roll * z162;
    const Scalar z1161 = z41 * z45 - z42 * z106 + s_roll * z162;
    const Scalar z1162 = z825 * (a_pitch + a_rear) + a_yaw * z755 + a_roll * z784 + z1158;
    const Scalar z1163 = z11 * z93;
    const Scalar z1164 = z10 * z93;
    const Scalar z1165 = z13 * z92;
    const Scalar z1166 = -z92 * (n1 - z12);
    const Scalar z1167 = n0_35 * z1165 + n0_08 * z1166;
    const Scalar z1168 = z1032 * z1088 + n2 * (z58 * z1160 + z129 * z175);
    const Scalar z1169 = z1144 + n0_35 * z1159;
    const Scalar z1170 = z90 * z159;
    const Scalar z1171 = -z92 * (n1 - z14);
    const Scalar z1172 = n0_08 * z1165 + n0_35 * z1171;
    const Scalar z1173 = z39 * z46 + z43 * z127 - n2 * (z21 * z105 - z23 * z1089) + s_yaw * z156 + c_yaw * z1161;
    const Scalar z1174 = z39 * z127 - z43 * z46 - n2 * (z23 * z105 + z21 * z1089) - c_yaw * z156 + s_yaw * z1161;
    const Scalar z1175 = n2 * (z109 * z1090 + z110 * z1088) - z83 * z1160 + z128 * z175 + z58 * z1173 - z129 * z177;
    const Scalar z1176 = z131 * z175 - z66 * z1160 + n2 * (z109 * z1095 - z113 * z1088) + z58 * z1174 + z129 * z173;
    const Scalar z1177 = n4 * (z114 * z1098 - z112 * z1097 - z150 * z1096) + n2 * (z87 * z1168 - z136 * z178 + z140
        * z179 - z147 * z181 + z88 * z1175 + z85 * z1176);
    const Scalar z1178 = n0_5 * (z174 * z1102 / (z101 * z101) - z166 * z190 / (z101 * z101) - z1177 / z101 + z165
        * z1113 / (z101 * z101)) + z166 * z216 / (z101 * z101 * z101);
    const Scalar z1179 = z166 * z1050 / (z101 * z101 * z101) + n0_35 * z1113 / (z101 * z101);
    const Scalar z1180 = z150 * z802 - z1103 - z111 * z1096 - z136 * z257 + z87 * z1179;
    const Scalar z1181 = z1103 + z1180;
    const Scalar z1182 = z91 * z124;
    const Scalar z1183 = z90 * z124;
    const Scalar z1184 = z23 * z126;
    const Scalar z1185 = z1182 + s_pitch * z1163 - z90 * z123 + c_pitch * z1164;
    const Scalar z1186 = s_pitch * z1164 - z1183 - z91 * z123 - c_pitch * z1163;
    const Scalar z1187 = z1137 + n0_35 * z1178;
    const Scalar z1188 = s_steer * z22;
    const Scalar z1189 = a_roll * z828 + a_pitch * z880 + a_steer * z882 + z1187;
    const Scalar z1190 = z91 * z161 - z1170 + s_pitch * z1167 - c_pitch * z1172;
    const Scalar z1191 = s_roll * z92 + z1188 + z19 * z125 + c_roll * z1185;
    const Scalar z1192 = s_steer * z19 - c_roll * z92 - z22 * z125 + s_roll * z1185;
    const Scalar z1193 = z1184 - z21 * z132 + c_yaw * z1186 + s_yaw * z1192;
    const Scalar z1194 = n0_08 * z1163 - n0_35 * z1164;
    const Scalar z1195 = z22 * z170;
    const Scalar z1196 = v_yaw * z811;
    const Scalar z1197 = v_roll * z816 + z1196 + v_pitch * z869 - v_steer * z891 + v_front * z893 - z320;
    const Scalar z1198 = v_roll * z816 + z1196 + v_pitch * z869 - v_steer * z891 + v_front * z893;
    const Scalar z1199 = z109 * z134;
    const Scalar z1200 = z21 * z126;
    const Scalar z1201 = z109 * z135;
    const Scalar z1202 = z1199 - z66 * z1191 + z58 * z1193 + z113 * z133;
    const Scalar z1203 = s_yaw * z1186 - z1200 - z23 * z132 - c_yaw * z1192;
    const Scalar z1204 = v_yaw * z815;
    const Scalar z1205 = v_roll * z817 - z1204 - v_pitch * z870 + v_steer * z892 + v_front * z894 - z336;
    const Scalar z1206 = v_roll * z817 - z1204 - v_pitch * z870 + v_steer * z892 + v_front * z894;
    const Scalar z1207 = s_roll * z1194 - z1195 + z19 * z169 + c_roll * z1190;
    const Scalar z1208 = s_roll * z272 - z22 * z202;
    const Scalar z1209 = z19 * z202 + c_roll * z272;
    const Scalar z1210 = s_yaw * z115 - z21 * z67 - z23 * z798 - c_yaw * z1156;
    const Scalar z1211 = z23 * z67 - z21 * z798 + c_yaw * z115 + s_yaw * z1156;
    const Scalar z1212 = z1210 - z111 * z1097 + z112 * z802 - z140 * z257 + z88 * z1179;
    const Scalar z1213 = z85 * z1179 - z1211 - z111 * z1098 - z114 * z802 - z147 * z257;
    const Scalar z1214 = z112 * z146;
    const Scalar z1215 = n2 * (z58 * z1191 - z109 * z133);
    const Scalar z1216 = z83 * z1191 + z1201 + z110 * z133 + z58 * z1203;
    const Scalar z1217 = z1210 - z1212;
    const Scalar z1218 = z23 * z201 - c_yaw * z256 - z21 * z860 + s_yaw * z1208;
    const Scalar z1219 = z21 * z201 + s_yaw * z256 + z23 * z860 + c_yaw * z1208;
    const Scalar z1220 = z110 * z876 - z237 * z1088 - z235 * z1090 - z129 * z285 - z128 * z267 + z109 * z878 + z58
        * z1217 - z83 * z1181;
    const Scalar z1221 = z1211 + z1213;
    const Scalar z1222 = z235 * z1095 - z239 * z1088 + z109 * z877 + z113 * z876 - z129 * z302 + z131 * z267 + z66
        * z1181 + z58 * z1221;
    const Scalar z1223 = z22 * z198 + s_roll * z278;
    const Scalar z1224 = c_roll * z278 - z19 * z198;
    const Scalar z1225 = z1180 - z1224;
    const Scalar z1226 = z21 * z199 + s_yaw * z280 + z23 * z862 - c_yaw * z1223;
    const Scalar z1227 = c_yaw * z280 - z23 * z199 + z21 * z862 + s_yaw * z1223;
    const Scalar z1228 = z1212 + z1226;
    const Scalar z1229 = z283 * z866 - z238 * z1209 - z236 * z1219 - z294 * z861 - z306 * z863 + z262 * z868 + z204
        * z1228 - z206 * z1225;
    const Scalar z1230 = z1213 - z1227;
    const Scalar z1231 = z242 * z1209 - z236 * z1218 + z262 * z889 - z308 * z866 + z306 * z886 - z310 * z861 - z207
        * z1225 + z204 * z1230;
    const Scalar z1232 = z21 * z812 + s_yaw * z1180;
    const Scalar z1233 = n2 * (z1214 + z150 * z151 + z87 * z1215 + z85 * z1202 - z88 * z1216 + z114 * z141);
    const Scalar z1234 = c_yaw * z1180 - z23 * z812;
    const Scalar z1235 = z22 * z811 - z33 * z812 + s_roll * z1212 + z26 * z1180;
    const Scalar z1236 = v_yaw * z1212 + v_roll * z1232 + v_pitch * z1235 - v_steer * z1229 - v_front * z1220;
    const Scalar z1237 = z22 * z815 - z32 * z812 + z24 * z1180 + s_roll * z1213;
    const Scalar z1238 = v_yaw * z1213 - v_roll * z1234 + v_pitch * z1237 - v_steer * z1231 + v_front * z1222;
    const Scalar z1239 = a_yaw * z811 + a_roll * z816 + a_pitch * z869 - a_steer * z891 + a_front * z893 + z1236;
    const Scalar z1240 = n2 * z93;
    const Scalar z1241 = z11 * z145;
    const Scalar z1242 = z10 * z145;
    const Scalar z1243 = z10 * z1240;
    const Scalar z1244 = z11 * z1240;
    const Scalar z1245 = a_yaw * z815 - a_roll * z817 + a_pitch * z870 - a_steer * z892 - a_front * z894 + z1238;
    const Scalar z1246 = s_pitch * z1243 - n2 * (z91 * z123 + z1183) - c_pitch * z1244;
    const Scalar z1247 = s_pitch * z1244 - n2 * (z90 * z123 - z1182) + c_pitch * z1243;
    const Scalar z1248 = n0_08 * z1244 - n0_35 * z1243;
    const Scalar z1249 = z123 * z138 + z124 * z142 + s_pitch * z1241 + c_pitch * z1242 + n2 * (z90 * z1163 - z91
        * z1164);
    const Scalar z1250 = z124 * z138 - z123 * z142 + s_pitch * z1242 - c_pitch * z1241 + n2 * (z90 * z1164 + z91
        * z1163);
    const Scalar z1251 = n0_08 * z1241 - n0_35 * z1242;
    const Scalar z1252 = s_roll * z144 + s_steer * z41 - z38 * z125 - n2 * (z22 * z92 - z19 * z1185) - c_roll * z1249;
    const Scalar z1253 = c_roll * z144 + s_steer * z38 + z41 * z125 + n2 * (z19 * z92 + z22 * z1185) + s_roll * z1249;
    const Scalar z1254 = n2 * z92;
    const Scalar z1255 = n2 * (z19 * z125 + z1188) + s_roll * z1254 + c_roll * z1247;
    const Scalar z1256 = n2 * (s_steer * z19 - z22 * z125) - c_roll * z1254 + s_roll * z1247;
    const Scalar z1257 = z165 * z168;
    const Scalar z1258 = c_yaw * z1246 - n2 * (z21 * z132 - z1184) + s_yaw * z1256;
    const Scalar z1259 = s_yaw * z1246 - n2 * (z23 * z132 + z1200) - c_yaw * z1256;
    const Scalar z1260 = z58 * z1258 - z66 * z1255 + n2 * (z113 * z133 + z1199);
    const Scalar z1261 = z83 * z1255 + n2 * (z110 * z133 + z1201) + z58 * z1259;
    const Scalar z1262 = z108 * z1255 - z133 * z1032;
    const Scalar z1263 = n4 * (z1214 + z150 * z151 + z114 * z141) + n2 * (z87 * z1262 + z85 * z1260 - z88 * z1261);
    const Scalar z1264 = z1032 * z1191 + n2 * (z58 * z1252 + z133 * z175);
    const Scalar z1265 = z39 * z126 - z43 * z132 + n2 * (z21 * z1186 + z23 * z1192) + s_yaw * z1250 - c_yaw * z1253;
    const Scalar z1266 = z43 * z126 + z39 * z132 + n2 * (z21 * z1192 - z23 * z1186) + c_yaw * z1250 + s_yaw * z1253;
    const Scalar z1267 = z135 * z175 - z83 * z1252 - n2 * (z109 * z1203 - z110 * z1191) + z58 * z1265 - z133 * z177;
    const Scalar z1268 = z66 * z1252 + z134 * z175 - n2 * (z109 * z1193 - z113 * z1191) + z58 * z1266 - z133 * z173;
    const Scalar z1269 = n2 * (z151 * z178 - z87 * z1264 - z146 * z179 - z141 * z181 - z88 * z1267 + z85 * z1268) - n4
        * (z114 * z1202 + z112 * z1216 - z150 * z1215);
    const Scalar z1270 = n0_5 * (z1257 / (z101 * z101) - z1263 / z101 + z174 * z155 / (z101 * z101));
    const Scalar z1271 = n0_5 * (z1257 / (z101 * z101) - z1233 / z101);
    const Scalar z1272 = n0_5 * (z165 * z1271 / (z101 * z101) - z174 * z1233 / (z101 * z101) - z168 * z190 / (z101
        * z101) - z1269 / z101) + z168 * z216 / (z101 * z101 * z101);
    const Scalar z1273 = z168 * z1050 / (z101 * z101 * z101) + n0_35 * z1271 / (z101 * z101);
    const Scalar z1274 = z1207 - n0_35 * z1271;
    const Scalar z1275 = v_roll * z918;
    const Scalar z1276 = v_yaw * z887 + z1275 + v_pitch * z920 - v_steer * z924 - v_front * z926 - z338;
    const Scalar z1277 = z1207 + z111 * z1215 + z150 * z885 + z151 * z257 + z87 * z1273;
    const Scalar z1278 = v_yaw * z887 + z1275 + v_pitch * z920 - v_steer * z924 - v_front * z926;
    const Scalar z1279 = z1207 - z1277;
    const Scalar z1280 = v_yaw * z890;
    const Scalar z1281 = z90 * z161 + z91 * z159 + s_pitch * z1172 + c_pitch * z1167;
    const Scalar z1282 = z13 * z144;
    const Scalar z1283 = s_roll * z1190 - c_roll * z1194 - z22 * z169 - z19 * z170;
    const Scalar z1284 = -z144 * (n1 - z12);
    const Scalar z1285 = n0_35 * z1282 + n0_08 * z1284;
    const Scalar z1286 = -z144 * (n1 - z14);
    const Scalar z1287 = n0_08 * z1282 + n0_35 * z1286;
    const Scalar z1288 = z21 * z849 + z23 * z799 + s_yaw * z1281 + c_yaw * z1283;
    const Scalar z1289 = s_pitch * z1285 - z161 * z142 - z159 * z138 - c_pitch * z1287 - n2 * (z90 * z1167 + z91
        * z1172);
    const Scalar z1290 = z1288 - z111 * z1216 + z112 * z885 + z146 * z257 + z88 * z1273;
    const Scalar z1291 = z13 * z1254;
    const Scalar z1292 = -z1254 * (n1 - z12);
    const Scalar z1293 = -z1254 * (n1 - z14);
    const Scalar z1294 = n0_35 * z1291 + n0_08 * z1292;
    const Scalar z1295 = z23 * z849 - z21 * z799 - c_yaw * z1281 + s_yaw * z1283;
    const Scalar z1296 = z1295 + z111 * z1202 - z114 * z885 - z141 * z257 + z85 * z1273;
    const Scalar z1297 = z41 * z170 + s_roll * z1251 + z38 * z169 + n2 * (z22 * z1194 - z19 * z1190) - c_roll * z1289;
    const Scalar z1298 = n0_08 * z1291 + n0_35 * z1293;
    const Scalar z1299 = s_pitch * z1294 - c_pitch * z1298 + n2 * (z91 * z161 - z1170);
    const Scalar z1300 = z22 * z887 - z33 * z916 + s_roll * z1290 + z26 * z1277;
    const Scalar z1301 = z22 * z890 - z32 * z916 + s_roll * z1296 + z24 * z1277;
    const Scalar z1302 = s_roll * z1248 + n2 * (z19 * z169 - z1195) + c_roll * z1299;
    const Scalar z1303 = z262 * z887 + z283 * z916 + z204 * z1290 - z206 * z1277;
    const Scalar z1304 = z262 * z890 - z308 * z916 + z204 * z1296 - z207 * z1277;
    const Scalar z1305 = z1297 - n0_35 * z1272;
    const Scalar z1306 = a_roll * z881 + a_pitch * z906 - a_steer * z943 + z1305;
    const Scalar z1307 = z1302 - n0_35 * z1270;
    const Scalar z1308 = z21 * z916 + s_yaw * z1277;
    const Scalar z1309 = c_yaw * z1277 - z23 * z916;
    const Scalar z1310 = z1288 - z1290;
    const Scalar z1311 = z237 * z1191 - z235 * z1203 - z109 * z903 - z110 * z917 + z133 * z285 + z135 * z267 + z58
        * z1310 + z83 * z1279;
    const Scalar z1312 = z1295 - z1296;
    const Scalar z1313 = z235 * z1193 - z239 * z1191 + z113 * z917 - z133 * z302 - z134 * z267 + z109 * z904 + z58
        * z1312 + z66 * z1279;
    const Scalar z1314 = v_yaw * z1290 + v_roll * z1308 + v_pitch * z1300 - v_steer * z1303 - v_front * z1311;
    const Scalar z1315 = a_yaw * z887 + a_roll * z918 + a_pitch * z920 - a_steer * z924 - a_front * z926 + z1314;
    const Scalar z1316 = v_yaw * z1296 - v_roll * z1309 + v_pitch * z1301 - v_steer * z1304 - v_front * z1313;
    const Scalar z1317 = a_yaw * z890 - a_roll * z919 + a_pitch * z921 - a_steer * z925 + a_front * z929 + z1316;
    const Scalar z1318 = v_roll * z919 - z1280 - v_pitch * z921 + v_steer * z925 - v_front * z929 + z343;
    const Scalar z1319 = v_roll * z919 - z1280 - v_pitch * z921 + v_steer * z925 - v_front * z929;
    const Scalar z1320 = n1 / z243;
    const Scalar z1321 = z243 * z243;
    const Scalar z1322 = n1_over_94 + k38 * z246 * z246 + n25_over_7 * z1321 + z187 * z187 / z494 + z191 * z191 / z463
        + z215 * z215 / z435;
    const Scalar z1323 = z252 * z1320;
    const Scalar z1324 = n1_over_94 + k38 * z247 * z247 + n25_over_7 * z252 * z252 + z186 * z186 / z494 + z205 * z205
        / z463 + z195 * z195 / z435;
    const Scalar z1325 = n0_28 * z1322;
    const Scalar z1326 = z494 * z1324;
    const Scalar z1327 = z186 - z187 * z1323;
    const Scalar z1328 = z183 - z1327;
    const Scalar z1329 = n1 / z180;
    const Scalar z1330 = z195 * z1329;
    const Scalar z1331 = z215 * z1329;
    const Scalar z1332 = z995 - z970 + z972 * z1323;
    const Scalar z1333 = z180 * z180;
    const Scalar z1334 = z197 * z1331 - z246;
    const Scalar z1335 = n1_over_94 + k38 * z197 * z197 + z182 * z182 / z463 + z1333 / z435;
    const Scalar z1336 = z103 + z182;
    const Scalar z1337 = z191 - z1331 * z1336;
    const Scalar z1338 = z1328 * z1328;
    const Scalar z1339 = n1 / z1328;
    const Scalar z1340 = z1329 * z1336;
    const Scalar z1341 = z196 * z1329;
    const Scalar z1342 = z1059 - z1124 * z1340;
    const Scalar z1343 = z1081 + z1198 * z1340;
    const Scalar z1344 = z1101 - z1206 * z1340;
    const Scalar z1345 = z222 - z1341 * z1336;
    const Scalar z1346 = z205 - z1330 * z1336 - z1345 - z1323 * z1337;
    const Scalar z1347 = z185 * z1339;
    const Scalar z1348 = z998 - z1347 * z1332;
    const Scalar z1349 = z435 * z1335;
    const Scalar z1350 = z220 * z220 * (n25_over_3 + n1 / z435) + n1_over_94 + z185 * z185 / z494 + z217 * z217 / z463;
    const Scalar z1351 = n94 * z1350;
    const Scalar z1352 = n1 - z1323 * z1347;
    const Scalar z1353 = z1352 * z1352;
    const Scalar z1354 = n1 / z1352;
    const Scalar z1355 = z197 * z1329;
    const Scalar z1356 = z1124 * z1355 - z1274;
    const Scalar z1357 = z1198 * z1355 + z1278;
    const Scalar z1358 = z1206 * z1355 + z1319;
    const Scalar z1359 = z197 * z1341;
    const Scalar z1360 = z197 * z1330 - z247 - z1359 - z1323 * z1334;
    const Scalar z1361 = z220 * z1329;
    const Scalar z1362 = z1074 - z1342;
    const Scalar z1363 = z217 - z1361 * z1336 + z1347 * z1346;
    const Scalar z1364 = z1106 + z1341 * z1362;
    const Scalar z1365 = z220 - z196 * z1347;
    const Scalar z1366 = z197 * z1361 + z1347 * z1360;
    const Scalar z1367 = z1354 * z1365;
    const Scalar z1368 = z1331 * z1362 - z1343;
    const Scalar z1369 = z1331 * z1356 - z1357;
    const Scalar z1370 = z1354 * z1366;
    const Scalar z1371 = z1330 * z1362 - z1364 + z1344 - z1323 * z1368;
    const Scalar z1372 = z1323 * z1370 + z1360;
    const Scalar z1373 = z1354 * z1348;
    const Scalar z1374 = z1354 * z1363;
    const Scalar z1375 = z1323 * z1373 - z1332;
    const Scalar z1376 = z1323 * z1374 + z1346;
    const Scalar z1377 = z1119 + z1361 * z1362 + z1347 * z1371;
    const Scalar z1378 = z1339 * z1372;
    const Scalar z1379 = z1334 - z1370 + z187 * z1378;
    const Scalar z1380 = z1354 * z1377;
    const Scalar z1381 = z1329 * z1362;
    const Scalar z1382 = z183 * z1378 + z1359;
    const Scalar z1383 = z1339 * z1375;
    const Scalar z1384 = z972 - z1373 + z187 * z1383;
    const Scalar z1385 = z183 * z1383 - z970;
    const Scalar z1386 = z1323 * z1380 + z1371;
    const Scalar z1387 = z1320 * z1379;
    const Scalar z1388 = z1339 * z1376;
    const Scalar z1389 = z1339 * z1386;
    const Scalar z1390 = z1064 - z1169 * z1340;
    const Scalar z1391 = z1320 * z1384;
    const Scalar z1392 = z183 * z1388 + z1345;
    const Scalar z1393 = z1368 - z1380 + z187 * z1389;
    const Scalar z1394 = z183 * z1389 + z1364;
    const Scalar z1395 = z1337 - z1374 + z187 * z1388;
    const Scalar z1396 = z1320 * z1393;
    const Scalar z1397 = z1169 * z1355 - z1307;
    const Scalar z1398 = z1320 * z1395;
    const Scalar z1399 = z231 * z1340 + z1105 - z971 * z1388;
    const Scalar z1400 = z1076 - z1390;
    const Scalar z1401 = z1341 * z1400 + z1399;
    const Scalar z1402 = z973 * z1388 - z1080 - z1197 * z1340 + z344 * z1398;
    const Scalar z1403 = z1276 + z1197 * z1355 + z973 * z1378 + z344 * z1387;
    const Scalar z1404 = z1100 - z1205 * z1340 - z997 * z1388 + z346 * z1398;
    const Scalar z1405 = z1205 * z1355 + z1318 - z997 * z1378 + z346 * z1387;
    const Scalar z1406 = z260 * z1340 + z1116 + z999 * z1388;
    const Scalar z1407 = z1331 * z1400 + z1402;
    const Scalar z1408 = z1330 * z1400 - z1401 + z1404 - z1323 * z1407;
    const Scalar z1409 = z1341 * z1356;
    const Scalar z1410 = z1330 * z1356 - z1409 - z1358 - z1323 * z1369;
    const Scalar z1411 = z196 - z1323 * z1367;
    const Scalar z1412 = z1339 * z1411;
    const Scalar z1413 = z1361 * z1400 + z1406 + z1347 * z1408;
    const Scalar z1414 = z1354 * z1413;
    const Scalar z1415 = z183 * z1412 - z196;
    const Scalar z1416 = z187 * z1412 + z1367;
    const Scalar z1417 = z1329 * z1356;
    const Scalar z1418 = z1323 * z1414 + z1408;
    const Scalar z1419 = z231 * z1355 + z971 * z1378;
    const Scalar z1420 = z1361 * z1356 + z1347 * z1410;
    const Scalar z1421 = z1320 * z1416;
    const Scalar z1422 = z1341 * z1397 + z1419;
    const Scalar z1423 = z1331 * z1397 - z1403;
    const Scalar z1424 = z1354 * z1420;
    const Scalar z1425 = z1330 * z1397 - z1422 - z1405 - z1323 * z1423;
    const Scalar z1426 = z1323 * z1424 + z1410;
    const Scalar z1427 = z1329 * z1400;
    const Scalar z1428 = z1339 * z1418;
    const Scalar z1429 = z183 * z1428 + z1401;
    const Scalar z1430 = z1407 - z1414 + z187 * z1428;
    const Scalar z1431 = z1339 * z1426;
    const Scalar z1432 = z1169 * z1381;
    const Scalar z1433 = z1169 * z1417;
    const Scalar z1434 = z1320 * z1430;
    const Scalar z1435 = z1369 - z1424 + z187 * z1431;
    const Scalar z1436 = z183 * z1431 + z1409;
    const Scalar z1437 = z231 * z1381 + z971 * z1389;
    const Scalar z1438 = z1320 * z1435;
    const Scalar z1439 = z1066 + z1189 * z1340;
    const Scalar z1440 = z1189 * z1355 - z1306;
    const Scalar z1441 = z1133 + z1239 * z1340;
    const Scalar z1442 = z1239 * z1355 + z1315;
    const Scalar z1443 = z231 * z1417 + z971 * z1431;
    const Scalar z1444 = z231 - z971 * z1412;
    const Scalar z1445 = z971 * z1383;
    const Scalar z1446 = z973 * z1383 + z344 * z1391;
    const Scalar z1447 = z1197 * z1381 + z973 * z1389 + z344 * z1396;
    const Scalar z1448 = z1197 * z1417 + z973 * z1431 + z344 * z1438;
    const Scalar z1449 = z973 * z1412 + z344 * z1421;
    const Scalar z1450 = z1205 * z1381 - z997 * z1389 + z346 * z1396;
    const Scalar z1451 = z1205 * z1417 - z997 * z1431 + z346 * z1438;
    const Scalar z1452 = z346 * z1391 - z997 * z1383;
    const Scalar z1453 = z346 * z1421 - z997 * z1412;
    const Scalar z1454 = z1323 * z1449 + z1444 - z1453;
    const Scalar z1455 = z260 * z1381 - z999 * z1389;
    const Scalar z1456 = z999 * z1383;
    const Scalar z1457 = z260 * z1355 - z999 * z1378;
    const Scalar z1458 = z1143 + z1245 * z1340;
    const Scalar z1459 = z1361 * z1397 + z1457 + z1347 * z1425;
    const Scalar z1460 = z1329 * z1397;
    const Scalar z1461 = z260 * z1417 - z999 * z1431;
    const Scalar z1462 = z260 + z999 * z1412;
    const Scalar z1463 = z1432 + z1439;
    const Scalar z1464 = z1433 + z1440;
    const Scalar z1465 = z1155 - z1437;
    const Scalar z1466 = z1245 * z1355 + z1317;
    const Scalar z1467 = z984 + z1445;
    const Scalar z1468 = z985 + z1446;
    const Scalar z1469 = z1447 + z1441;
    const Scalar z1470 = z1448 + z1442;
    const Scalar z1471 = z1450 - z1458;
    const Scalar z1472 = z1451 - z1466;
    const Scalar z1473 = z1011 + z1452;
    const Scalar z1474 = z1162 + z1455;
    const Scalar z1475 = z996 - z1456;
    const Scalar z1476 = z1083 + z1463;
    const Scalar z1477 = z1341 * z1476 - z1465;
    const Scalar z1478 = z1331 * z1476 - z1469;
    const Scalar z1479 = z1323 * z1468 - z1467 - z1473;
    const Scalar z1480 = z1347 * z1454 - z1462;
    const Scalar z1481 = z1330 * z1476 - z1477 - z1471 - z1323 * z1478;
    const Scalar z1482 = z1347 * z1479 + z1475;
    const Scalar z1483 = z1354 * z1480;
    const Scalar z1484 = z1354 * z1482;
    const Scalar z1485 = z1354 * z1459;
    const Scalar z1486 = z1323 * z1483 + z1454;
    const Scalar z1487 = z1323 * z1485 + z1425;
    const Scalar z1488 = z1323 * z1484 + z1479;
    const Scalar z1489 = z1339 * z1486;
    const Scalar z1490 = z1339 * z1487;
    const Scalar z1491 = z1339 * z1488;
    const Scalar z1492 = z1361 * z1476 + z1474 + z1347 * z1481;
    const Scalar z1493 = z183 * z1489 - z1444;
    const Scalar z1494 = z183 * z1490 + z1422;
    const Scalar z1495 = z183 * z1491 + z1467;
    const Scalar z1496 = z1354 * z1492;
    const Scalar z1497 = z1423 - z1485 + z187 * z1490;
    const Scalar z1498 = z187 * z1489 - z1449 - z1483;
    const Scalar z1499 = z1323 * z1496 + z1481;
    const Scalar z1500 = z187 * z1491 - z1468 - z1484;
    const Scalar z1501 = z1320 * z1497;
    const Scalar z1502 = z1341 * z1464 + z1443;
    const Scalar z1503 = z1331 * z1464 - z1470;
    const Scalar z1504 = z1330 * z1464 - z1502 - z1472 - z1323 * z1503;
    const Scalar z1505 = z1329 * z1476;
    const Scalar z1506 = z1339 * z1499;
    const Scalar z1507 = z183 * z1506 + z1477;
    const Scalar z1508 = z1478 - z1496 + z187 * z1506;
    const Scalar z1509 = z1320 * z1498;
    const Scalar z1510 = z422 + z103 * z423 - z385 * z1340 + z413 * z1374 + z420 * z1388 + z424 * z1392;
    const Scalar z1511 = z962 - z963;
    const Scalar z1512 = z964 + z1341 * z1511;
    const Scalar z1513 = z965 - z1331 * z1511;
    const Scalar z1514 = z423 - z449 * z1355;
    const Scalar z1515 = z1361 * z1464 + z1461 + z1347 * z1504;
    const Scalar z1516 = z1330 * z1511 - z1512 + z966 + z1323 * z1513;
    const Scalar z1517 = z1354 * z1515;
    const Scalar z1518 = z1329 * z1464;
    const Scalar z1519 = z1323 * z1517 + z1504;
    const Scalar z1520 = z463 + z103 * z467 - z447 * z1340 + z473 * z1374 + z469 * z1388 + z474 * z1392 - z454 * z1398;
    const Scalar z1521 = z967 - z1361 * z1511 - z1347 * z1516;
    const Scalar z1522 = z1329 * z1511;
    const Scalar z1523 = z467 + n94 * z103 + z449 * z1340;
    const Scalar z1524 = z103 * z449 - z447 + z435 * z1340 + z450 * z1374 - z453 * z1388 + z452 * z1392 + z393 * z1398;
    const Scalar z1525 = z1354 * z1521;
    const Scalar z1526 = z1323 * z1525 - z1516;
    const Scalar z1527 = z450 * z1370 - z385 - z435 * z1355 - z453 * z1378 + z452 * z1382 + z393 * z1387;
    const Scalar z1528 = k18 + z385 * z1355 + z413 * z1370 + z420 * z1378 + z424 * z1382;
    const Scalar z1529 = z413 - z450 * z1355 + n94 * z1370 - z519 * z1378;
    const Scalar z1530 = z424 - z452 * z1355 - z521 * z1378 + n94 * z1382;
    const Scalar z1531 = z473 + z450 * z1340 + n94 * z1374 - z519 * z1388;
    const Scalar z1532 = z519 * z1370 - z420 - z453 * z1355 - z494 * z1378 + z521 * z1382 + z416 * z1387;
    const Scalar z1533 = z452 * z1340 + z474 - z521 * z1388 + n94 * z1392;
    const Scalar z1534 = n0_12 - z450 * z1367 - z453 * z1412 + z452 * z1415 + z393 * z1421;
    const Scalar z1535 = z453 * z1340 - z469 + z519 * z1374 - z494 * z1388 + z521 * z1392 + z416 * z1398;
    const Scalar z1536 = z446 - z519 * z1367 - z494 * z1412 + z521 * z1415 + z416 * z1421;
    const Scalar z1537 = n94 * z1367 + z519 * z1412;
    const Scalar z1538 = z521 * z1412 - n94 * z1415;
    const Scalar z1539 = z393 * z1340 - z454 - z416 * z1388 + n0_28 * z1398;
    const Scalar z1540 = z393 * z1355 + z416 * z1378 - n0_28 * z1387;
    const Scalar z1541 = z416 * z1412 - n0_28 * z1421;
    const Scalar z1542 = z1339 * z1519;
    const Scalar z1543 = z1339 * z1526;
    const Scalar z1544 = z103 * z1523 + z1374 * z1531 + z1392 * z1533 + z1398 * z1539 + z1340 * z1524 - z1388 * z1535
        + z1520;
    const Scalar z1545 = z183 * z1542 + z1502;
    const Scalar z1546 = z183 * z1543 - z1512;
    const Scalar z1547 = z1503 - z1517 + z187 * z1542;
    const Scalar z1548 = z1513 - z1525 + z187 * z1543;
    const Scalar z1549 = z1320 * z1500;
    const Scalar z1550 = z1387 * z1540 - z1528 - z1370 * z1529 - z1382 * z1530 + z1355 * z1527 + z1378 * z1532;
    const Scalar z1551 = z1355 * z1524 - z1510 - z1370 * z1531 - z1382 * z1533 - z1387 * z1539 + z1378 * z1535;
    const Scalar z1552 = z1320 * z1508;
    const Scalar z1553 = z592 + z663 * z1340;
    const Scalar z1554 = z663 * z1355 + z688;
    const Scalar z1555 = z672 * z1355 - z690 + z627 * z1378;
    const Scalar z1556 = z673 * z1340 - z625 + z628 * z1388;
    const Scalar z1557 = z627 * z1388 - z626 - z672 * z1340;
    const Scalar z1558 = z628 * z1378 - z691 - z673 * z1355;
    const Scalar z1559 = z1320 * z1547;
    const Scalar z1560 = z1320 * z1548;
    const Scalar z1561 = z601 * z1412 - z676 - z704 * z1421;
    const Scalar z1562 = z653 * z1340 - z667 - z668 * z1388 + z492 * z1398;
    const Scalar z1563 = z703 * z1340 + z708 + z711 * z1388;
    const Scalar z1564 = z698 + z703 * z1355 - z711 * z1378;
    const Scalar z1565 = z710 - z709 * z1388;
    const Scalar z1566 = z617 - z615 * z1340 + z640 * z1388 - z702 * z1398;
    const Scalar z1567 = z615 * z1355 - z694 + z640 * z1378 - z702 * z1387;
    const Scalar z1568 = z699 * z1340 - z619 + z618 * z1388 + z711 * z1398;
    const Scalar z1569 = z726 - z699 * z1355 + z618 * z1378 + z711 * z1387;
    const Scalar z1570 = z642 - z697 * z1340 + z601 * z1388 - z704 * z1398;
    const Scalar z1571 = z103 * z1553 + z1392 * z1556 + z1398 * z1563 - z1374 * z1557 + z1340 * z1566 + z1388 * z1568
        - z1570;
    const Scalar z1572 = z725 + z697 * z1355 + z601 * z1378 - z704 * z1387;
    const Scalar z1573 = z103 * z1554 + z1374 * z1555 + z1398 * z1564 - z1392 * z1558 - z1340 * z1567 - z1388 * z1569
        + z1572;
    const Scalar z1574 = n0_12 - z446 * z1412;
    const Scalar z1575 = z1367 * z1537 + z1574 - z1415 * z1538 - z1421 * z1541 - z1412 * z1536;
    const Scalar z1576 = n0_12 * z1355 + z446 * z1378;
    const Scalar z1577 = z446 * z1388 - n0_12 * z1340;
    const Scalar z1578 = z1370 * z1557 - z1562 - z1382 * z1556 - z1387 * z1563 + z1355 * z1566 - z1378 * z1568;
    const Scalar z1579 = z1415 * z1556 + z1565 + z1421 * z1563 + z1367 * z1557 + z1412 * z1568;
    const Scalar z1580 = z1367 * z1529 + z1576 - z1415 * z1530 + z1421 * z1540 + z1412 * z1532;
    const Scalar z1581 = z1367 * z1531 + z1577 - z1415 * z1533 - z1421 * z1539 + z1412 * z1535;
    const Scalar z1582 = z627 * z1412;
    const Scalar z1583 = z628 * z1412;
    const Scalar z1584 = z709 * z1378;
    const Scalar z1585 = z1367 * z1555 - z1584 - z1421 * z1564 + z1415 * z1558 + z1412 * z1569;
    const Scalar z1586 = z709 * z1412;
    const Scalar z1587 = z711 * z1412;
    const Scalar z1588 = z640 * z1412 - z702 * z1421;
    const Scalar z1589 = z618 * z1412 - z709 + z711 * z1421;
    const Scalar z1590 = z1392 * z1583 - z1561 - z1374 * z1582 + z1398 * z1587 + z1340 * z1588 + z1388 * z1589;
    const Scalar z1591 = z1367 * z1582 - z1586 + z1415 * z1583 + z1421 * z1587 + z1412 * z1589;
    const Scalar z1592 = z492 * z1387 - z653 * z1355 - z668 * z1378;
    const Scalar z1593 = z1370 * z1555 + z1387 * z1564 - z1382 * z1558 + z1355 * z1567 - z1378 * z1569 - z1592;
    const Scalar z1594 = z492 * z1421 - z668 * z1412;
    const Scalar z1595 = z1370 * z1582 - z1382 * z1583 - z1387 * z1587 + z1355 * z1588 - z1378 * z1589 - z1594;
    const Scalar z1596 = z1076 * z1523 + z1427 * z1524 - z1414 * z1531 + z1428 * z1535 - z1429 * z1533 - z1434 * z1539;
    const Scalar z1597 = z1596 + z1571;
    const Scalar z1598 = z1076 * z1514 + z1427 * z1527 - z1414 * z1529 + z1428 * z1532 - z1429 * z1530 + z1434 * z1540;
    const Scalar z1599 = z1427 * z1534 + z1414 * z1537 + z1428 * z1536 + z1429 * z1538 + z1434 * z1541;
    const Scalar z1600 = z1598 - z1578;
    const Scalar z1601 = z1599 + z1579;
    const Scalar z1602 = z1485 * z1531 - z1460 * z1524 - z1490 * z1535 + z1494 * z1533 + z1501 * z1539;
    const Scalar z1603 = z1602 - z1573;
    const Scalar z1604 = z1483 * z1531 - z1489 * z1535 + z1493 * z1533 + z1509 * z1539;
    const Scalar z1605 = z1604 + z1590;
    const Scalar z1606 = z672 * z1381 + z627 * z1389;
    const Scalar z1607 = z627 * z1383;
    const Scalar z1608 = z1485 * z1529 - z1460 * z1527 - z1490 * z1532 + z1494 * z1530 - z1501 * z1540;
    const Scalar z1609 = z1460 * z1534 + z1485 * z1537 + z1490 * z1536 + z1494 * z1538 + z1501 * z1541;
    const Scalar z1610 = z672 * z1417 + z627 * z1431;
    const Scalar z1611 = z1608 - z1593;
    const Scalar z1612 = z1609 - z1585;
    const Scalar z1613 = z1483 * z1529 - z1489 * z1532 + z1493 * z1530 - z1509 * z1540;
    const Scalar z1614 = z1483 * z1537 + z1489 * z1536 + z1493 * z1538 + z1509 * z1541;
    const Scalar z1615 = z465 - z1607;
    const Scalar z1616 = z1613 - z1595;
    const Scalar z1617 = z1614 - z1591;
    const Scalar z1618 = z605 - z624 * z1340;
    const Scalar z1619 = z624 * z1355 - z670;
    const Scalar z1620 = z630 + z632 * z1340;
    const Scalar z1621 = z632 * z1355 - z674;
    const Scalar z1622 = z1606 + z1620;
    const Scalar z1623 = z1610 + z1621;
    const Scalar z1624 = z834 - z897 * z1340;
    const Scalar z1625 = z897 * z1355 - z935;
    const Scalar z1626 = z631 - z633 * z1340;
    const Scalar z1627 = z633 * z1355 - z675;
    const Scalar z1628 = z844 - z898 * z1340;
    const Scalar z1629 = z898 * z1355 - z938;
    const Scalar z1630 = z765 - z839 * z1340;
    const Scalar z1631 = z839 * z1355 - z900;
    const Scalar z1632 = z841 - z902 * z1340;
    const Scalar z1633 = z902 * z1355 - z958;
    const Scalar z1634 = z875 + z940 * z1340;
    const Scalar z1635 = z940 * z1355 - z983;
    const Scalar z1636 = z663 * z1381;
    const Scalar z1637 = z1636 + z1618;
    const Scalar z1638 = z663 * z1417;
    const Scalar z1639 = z1638 - z1619;
    const Scalar z1640 = z628 * z1383;
    const Scalar z1641 = z464 - z1640;
    const Scalar z1642 = z601 * z1383 - z704 * z1391;
    const Scalar z1643 = z703 * z1381 - z711 * z1389;
    const Scalar z1644 = z703 * z1417 - z711 * z1431;
    const Scalar z1645 = z709 * z1383;
    const Scalar z1646 = z709 * z1389;
    const Scalar z1647 = z709 * z1431;
    const Scalar z1648 = z628 * z1389 - z673 * z1381;
    const Scalar z1649 = z628 * z1431 - z673 * z1417;
    const Scalar z1650 = z1648 + z1626;
    const Scalar z1651 = z1649 - z1627;
    const Scalar z1652 = z711 * z1383;
    const Scalar z1653 = z640 * z1383 - z702 * z1391;
    const Scalar z1654 = z615 * z1381 + z640 * z1389 - z702 * z1396;
    const Scalar z1655 = z615 * z1417 + z640 * z1431 - z702 * z1438;
    const Scalar z1656 = z618 * z1383 + z711 * z1391;
    const Scalar z1657 = z763 - z1656;
    const Scalar z1658 = z492 * z1391 - z668 * z1383;
    const Scalar z1659 = z618 * z1389 - z699 * z1381 + z711 * z1396;
    const Scalar z1660 = z618 * z1431 - z699 * z1417 + z711 * z1438;
    const Scalar z1661 = z601 * z1389 + z697 * z1381 - z704 * z1396;
    const Scalar z1662 = z601 * z1431 + z697 * z1417 - z704 * z1438;
    const Scalar z1663 = z492 * z1396 - z653 * z1381 - z668 * z1389;
    const Scalar z1664 = z492 * z1438 - z653 * z1417 - z668 * z1431;
    const Scalar z1665 = z1484 * z1531 - z1491 * z1535 + z1495 * z1533 + z1549 * z1539;
    const Scalar z1666 = z1659 - z1630;
    const Scalar z1667 = z1083 * z1523 + z1505 * z1524 - z1496 * z1531 + z1506 * z1535 - z1507 * z1533 - z1552 * z1539;
    const Scalar z1668 = z1660 + z1631;
    const Scalar z1669 = z1083 * z1514 + z1505 * z1527 - z1496 * z1529 + z1506 * z1532 - z1507 * z1530 + z1552 * z1540;
    const Scalar z1670 = z1505 * z1534 + z1496 * z1537 + z1506 * z1536 + z1507 * z1538 + z1552 * z1541;
    const Scalar z1671 = z1517 * z1531 - z1518 * z1524 - z1542 * z1535 + z1545 * z1533 + z1559 * z1539;
    const Scalar z1672 = z722 - z1642;
    const Scalar z1673 = z1484 * z1529 - z1491 * z1532 + z1495 * z1530 - z1549 * z1540;
    const Scalar z1674 = z1484 * z1537 + z1491 * z1536 + z1495 * z1538 + z1549 * z1541;
    const Scalar z1675 = z1661 - z1632;
    const Scalar z1676 = z1662 + z1633;
    const Scalar z1677 = z1517 * z1529 - z1518 * z1527 - z1542 * z1532 + z1545 * z1530 - z1559 * z1540;
    const Scalar z1678 = z1518 * z1534 + z1517 * z1537 + z1542 * z1536 + z1545 * z1538 + z1559 * z1541;
    const Scalar z1679 = z962 * z1523 + z1525 * z1531 + z1546 * z1533 + z1560 * z1539 - z1543 * z1535 + z1522 * z1524;
    const Scalar z1680 = z962 * z1514 + z1525 * z1529 + z1546 * z1530 - z1560 * z1540 - z1543 * z1532 + z1522 * z1527;
    const Scalar z1681 = z1525 * z1537 + z1546 * z1538 + z1560 * z1541 + z1543 * z1536 - z1522 * z1534;
    const Scalar z1682 = z1643 - z1624;
    const Scalar z1683 = z1644 + z1625;
    const Scalar z1684 = z757 - z1645;
    const Scalar z1685 = z837 - z1646;
    const Scalar z1686 = z760 + z1652;
    const Scalar z1687 = z759 + z1653;
    const Scalar z1688 = z1654 + z1628;
    const Scalar z1689 = z1655 - z1629;
    const Scalar z1690 = z767 + z1658;
    const Scalar z1691 = z1663 - z1634;
    const Scalar z1692 = z1664 - z1635;
    const Scalar z1693 = z103 * z1637 + z1374 * z1622 + z1398 * z1682 - z1392 * z1650 - z1340 * z1688 - z1388 * z1666
        + z1675;
    const Scalar z1694 = z103 * z1639 + z1374 * z1623 + z1398 * z1683 - z1392 * z1651 - z1340 * z1689 - z1388 * z1668
        + z1676;
    const Scalar z1695 = z103 * z944 - z1012 + z956 * z1340 - z945 * z1374 - z1014 * z1388 + z946 * z1392 - z959
        * z1398;
    const Scalar z1696 = z1672 + z1374 * z1615 - z1392 * z1641 + z1398 * z1686 + z1340 * z1687 - z1388 * z1657;
    const Scalar z1697 = z1695 + z1679;
    const Scalar z1698 = z1382 * z1641 - z1370 * z1615 - z1387 * z1686 + z1355 * z1687 + z1378 * z1657 - z1690;
    const Scalar z1699 = z1367 * z1615 - z1684 + z1415 * z1641 - z1421 * z1686 + z1412 * z1657;
    const Scalar z1700 = z1370 * z1622 + z1387 * z1682 - z1382 * z1650 + z1355 * z1688 - z1378 * z1666 - z1691;
    const Scalar z1701 = z1685 + z1367 * z1622 - z1421 * z1682 + z1415 * z1650 + z1412 * z1666;
    const Scalar z1702 = z1370 * z1623 + z1387 * z1683 - z1382 * z1651 + z1355 * z1689 - z1378 * z1668 - z1692;
    const Scalar z1703 = z956 * z1355 - z949 + z945 * z1370 + z1014 * z1378 - z946 * z1382 + z959 * z1387;
    const Scalar z1704 = z1367 * z1623 - z1647 - z1421 * z1683 + z1415 * z1651 + z1412 * z1668;
    const Scalar z1705 = z945 * z1367 - z955 - z1014 * z1412 + z946 * z1415 - z959 * z1421;
    const Scalar z1706 = z1703 - z1680;
    const Scalar z1707 = z1705 - z1681;
    const Scalar z1708 = z1665 + z1696;
    const Scalar z1709 = z1667 + z1693;
    const Scalar z1710 = z1671 - z1694;
    const Scalar z1711 = z1673 - z1698;
    const Scalar z1712 = z1669 + z1700;
    const Scalar z1713 = z1677 - z1702;
    const Scalar z1714 = z1674 + z1699;
    const Scalar z1715 = z1670 - z1701;
    const Scalar z1716 = z1678 - z1704;
    const Scalar z1717 = n1 / z1575;
    const Scalar z1718 = z1580 * z1717;
    const Scalar z1719 = z1581 * z1717;
    const Scalar z1720 = z1544 - z1581 * z1719;
    const Scalar z1721 = z1551 + z1581 * z1718;
    const Scalar z1722 = z1550 + z1580 * z1718;
    const Scalar z1723 = z1600 + z1601 * z1718;
    const Scalar z1724 = z1611 - z1612 * z1718;
    const Scalar z1725 = z1711 - z1714 * z1718;
    const Scalar z1726 = n1 / z1722;
    const Scalar z1727 = z1616 - z1617 * z1718;
    const Scalar z1728 = z1712 + z1715 * z1718;
    const Scalar z1729 = z1713 - z1716 * z1718;
    const Scalar z1730 = z1721 * z1726;
    const Scalar z1731 = z1720 + z1721 * z1730;
    const Scalar z1732 = z1597 + z1601 * z1719 - z1730 * z1723;
    const Scalar z1733 = z1603 - z1612 * z1719 - z1730 * z1724;
    const Scalar z1734 = z1708 - z1714 * z1719 - z1730 * z1725;
    const Scalar z1735 = z1605 - z1617 * z1719 - z1730 * z1727;
    const Scalar z1736 = z1709 + z1715 * z1719 - z1730 * z1728;
    const Scalar z1737 = z1710 - z1716 * z1719 - z1730 * z1729;
    const Scalar z1738 = n1 / z1731;
    const Scalar z1739 = z1738 * z1732;
    const Scalar z1740 = z1738 * z1733;
    const Scalar z1741 = z1738 * z1734;
    const Scalar z1742 = z1738 * z1735;
    const Scalar z1743 = z1738 * z1736;
    const Scalar z1744 = z1738 * z1737;
    const Scalar z1745 = z1726 * z1723 + z1730 * z1739;
    const Scalar z1746 = z1726 * z1724 + z1730 * z1740;
    const Scalar z1747 = z1726 * z1725 + z1730 * z1741;
    const Scalar z1748 = z1726 * z1727 + z1730 * z1742;
    const Scalar z1749 = z1726 * z1728 + z1730 * z1743;
    const Scalar z1750 = z1726 * z1729 + z1730 * z1744;
    const Scalar z1751 = z1601 * z1717 + z1719 * z1739 - z1718 * z1745;
    const Scalar z1752 = z1612 * z1717 - z1719 * z1740 + z1718 * z1746;
    const Scalar z1753 = z1714 * z1717 - z1719 * z1741 + z1718 * z1747;
    const Scalar z1754 = z1617 * z1717 - z1719 * z1742 + z1718 * z1748;
    const Scalar z1755 = z1715 * z1717 + z1719 * z1743 - z1718 * z1749;
    const Scalar z1756 = z1716 * z1717 - z1719 * z1744 + z1718 * z1750;
    result.M[0] = n94;
    result.M[1] = n0;
    result.M[2] = n0;
    result.M[3] = z519;
    result.M[4] = z473;
    result.M[5] = z450;
    result.M[6] = z413;
    result.M[7] = n0;
    result.M[8] = n0;
    result.M[9] = n0;
    result.M[10] = n94;
    result.M[11] = n0;
    result.M[12] = -z521;
    result.M[13] = -z474;
    result.M[14] = -z452;
    result.M[15] = -z424;
    result.M[16] = n0;
    result.M[17] = n0;
    result.M[18] = n0;
    result.M[19] = n0;
    result.M[20] = n94;
    result.M[21] = n0;
    result.M[22] = z467;
    result.M[23] = z449;
    result.M[24] = z423;
    result.M[25] = n0;
    result.M[26] = n0;
    result.M[27] = z519;
    result.M[28] = -z521;
    result.M[29] = n0;
    result.M[30] = z494;
    result.M[31] = -z469;
    result.M[32] = z453;
    result.M[33] = -z420;
    result.M[34] = z446;
    result.M[35] = z416;
    result.M[36] = z473;
    result.M[37] = -z474;
    result.M[38] = z467;
    result.M[39] = -z469;
    result.M[40] = z463;
    result.M[41] = -z447;
    result.M[42] = z422;
    result.M[43] = n0;
    result.M[44] = -z454;
    result.M[45] = z450;
    result.M[46] = -z452;
    result.M[47] = z449;
    result.M[48] = z453;
    result.M[49] = -z447;
    result.M[50] = z435;
    result.M[51] = -z385;
    result.M[52] = n0_12;
    result.M[53] = z393;
    result.M[54] = z413;
    result.M[55] = -z424;
    result.M[56] = z423;
    result.M[57] = -z420;
    result.M[58] = z422;
    result.M[59] = -z385;
    result.M[60] = k18;
    result.M[61] = n0;
    result.M[62] = n0;
    result.M[63] = n0;
    result.M[64] = n0;
    result.M[65] = n0;
    result.M[66] = z446;
    result.M[67] = n0;
    result.M[68] = n0_12;
    result.M[69] = n0;
    result.M[70] = n0_12;
    result.M[71] = n0;
    result.M[72] = n0;
    result.M[73] = n0;
    result.M[74] = n0;
    result.M[75] = z416;
    result.M[76] = -z454;
    result.M[77] = z393;
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
    result.C[27] = z627;
    result.C[28] = z628;
    result.C[29] = n0;
    result.C[30] = z618;
    result.C[31] = z601;
    result.C[32] = -z640;
    result.C[33] = z668;
    result.C[34] = z709;
    result.C[35] = -z711;
    result.C[36] = z626;
    result.C[37] = z625;
    result.C[38] = z592;
    result.C[39] = z619;
    result.C[40] = -z642;
    result.C[41] = z617;
    result.C[42] = -z667;
    result.C[43] = z710;
    result.C[44] = z708;
    result.C[45] = z672;
    result.C[46] = -z673;
    result.C[47] = z663;
    result.C[48] = -z699;
    result.C[49] = z697;
    result.C[50] = -z615;
    result.C[51] = z653;
    result.C[52] = n0;
    result.C[53] = z703;
    result.C[54] = z690;
    result.C[55] = z691;
    result.C[56] = -z688;
    result.C[57] = -z726;
    result.C[58] = -z725;
    result.C[59] = -z694;
    result.C[60] = n0;
    result.C[61] = n0;
    result.C[62] = -z698;
    result.C[63] = n0;
    result.C[64] = n0;
    result.C[65] = n0;
    result.C[66] = z709;
    result.C[67] = z676;
    result.C[68] = n0;
    result.C[69] = n0;
    result.C[70] = n0;
    result.C[71] = n0;
    result.C[72] = n0;
    result.C[73] = n0;
    result.C[74] = n0;
    result.C[75] = -z711;
    result.C[76] = z704;
    result.C[77] = -z702;
    result.C[78] = z492;
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
    result.K[27] = z465;
    result.K[28] = z464;
    result.K[29] = n0;
    result.K[30] = z763;
    result.K[31] = z722;
    result.K[32] = z759;
    result.K[33] = z767;
    result.K[34] = z757;
    result.K[35] = z760;
    result.K[36] = z630;
    result.K[37] = z631;
    result.K[38] = z605;
    result.K[39] = -z765;
    result.K[40] = -z841;
    result.K[41] = -z844;
    result.K[42] = z875;
    result.K[43] = -z837;
    result.K[44] = -z834;
    result.K[45] = z632;
    result.K[46] = -z633;
    result.K[47] = -z624;
    result.K[48] = z839;
    result.K[49] = z902;
    result.K[50] = z898;
    result.K[51] = z940;
    result.K[52] = n0;
    result.K[53] = z897;
    result.K[54] = z674;
    result.K[55] = -z675;
    result.K[56] = -z670;
    result.K[57] = z900;
    result.K[58] = z958;
    result.K[59] = z938;
    result.K[60] = z983;
    result.K[61] = n0;
    result.K[62] = z935;
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
    result.F[0] = -z945;
    result.F[1] = -z946;
    result.F[2] = z944;
    result.F[3] = z1014;
    result.F[4] = -z1012;
    result.F[5] = z956;
    result.F[6] = z949;
    result.F[7] = -z955;
    result.F[8] = -z959;
    result.M_r[0] = z1544;
    result.M_r[1] = -z1551;
    result.M_r[2] = -z1581;
    result.M_r[3] = -z1551;
    result.M_r[4] = -z1550;
    result.M_r[5] = -z1580;
    result.M_r[6] = -z1581;
    result.M_r[7] = -z1580;
    result.M_r[8] = z1575;
    result.C_r[0] = z1597;
    result.C_r[1] = z1600;
    result.C_r[2] = z1601;
    result.C_r[3] = z1603;
    result.C_r[4] = z1611;
    result.C_r[5] = -z1612;
    result.C_r[6] = z1605;
    result.C_r[7] = z1616;
    result.C_r[8] = -z1617;
    result.K_r[0] = n0;
    result.K_r[1] = n0;
    result.K_r[2] = n0;
    result.K_r[3] = n0;
    result.K_r[4] = n0;
    result.K_r[5] = n0;
    result.K_r[6] = z1708;
    result.K_r[7] = z1711;
    result.K_r[8] = -z1714;
    result.K_r[9] = z1709;
    result.K_r[10] = z1712;
    result.K_r[11] = z1715;
    result.K_r[12] = z1710;
    result.K_r[13] = z1713;
    result.K_r[14] = -z1716;
    result.K_r[15] = n0;
    result.K_r[16] = n0;
    result.K_r[17] = n0;
    result.K_r[18] = n0;
    result.K_r[19] = n0;
    result.K_r[20] = n0;
    result.F_r[0] = z1697;
    result.F_r[1] = -z1706;
    result.F_r[2] = z1707;
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
    result.A[20] = z1373;
    result.A[21] = -z1385;
    result.A[22] = -z1383;
    result.A[23] = n0;
    result.A[24] = n0;
    result.A[25] = n0;
    result.A[26] = z1391;
    result.A[27] = -z1741;
    result.A[28] = z1747;
    result.A[29] = z1753;
    result.A[30] = -z1380;
    result.A[31] = z1394;
    result.A[32] = z1389;
    result.A[33] = n0;
    result.A[34] = n0;
    result.A[35] = n0;
    result.A[36] = -z1396;
    result.A[37] = -z1743;
    result.A[38] = z1749;
    result.A[39] = -z1755;
    result.A[40] = z1424;
    result.A[41] = -z1436;
    result.A[42] = -z1431;
    result.A[43] = n0;
    result.A[44] = n0;
    result.A[45] = n0;
    result.A[46] = z1438;
    result.A[47] = -z1744;
    result.A[48] = z1750;
    result.A[49] = z1756;
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
    result.A[70] = z1374;
    result.A[71] = -z1392;
    result.A[72] = -z1388;
    result.A[73] = n1;
    result.A[74] = n0;
    result.A[75] = n0;
    result.A[76] = n0;
    result.A[77] = -z1739;
    result.A[78] = z1745;
    result.A[79] = -z1751;
    result.A[80] = z1370;
    result.A[81] = -z1382;
    result.A[82] = -z1378;
    result.A[83] = n0;
    result.A[84] = n1;
    result.A[85] = n0;
    result.A[86] = z1387;
    result.A[87] = -z1740;
    result.A[88] = z1746;
    result.A[89] = z1752;
    result.A[90] = -z1367;
    result.A[91] = -z1415;
    result.A[92] = -z1412;
    result.A[93] = n0;
    result.A[94] = n0;
    result.A[95] = n1;
    result.A[96] = z1421;
    result.A[97] = -z1742;
    result.A[98] = z1748;
    result.A[99] = z1754;
    if (!(traits::regular(z1333, z1349) && traits::regular(z1321, z1325) && traits::regular(z1338, z1326)
        && traits::regular(z1353, z1351) && traits::regular(z1731, z1544) && traits::regular(-z1722, -z1550)
        && traits::regular(z1575, z1575))) return torsor::Status::singular;
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
