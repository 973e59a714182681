// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/flyball_governor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/numerics/decompositions.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::flyball_governor_test {
namespace {

using namespace torsor::runtime;
using Governor = flyball_governor::Mechanism<double>;
using State = StateVector<Governor>;

constexpr double rounding = 1.1e-16;
constexpr DormandPrince54 precise{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};

// Independent truth: quadruple precision, Gauss collocation with 6 and with 8 stages, which agree to 16 digits; the
// equations were written by hand for one angle, the rods being symmetric.
struct Published {
  double time, beta, s, beta_rate, s_rate, spin, psi;
  State state() const { return {psi, s, beta, beta, spin, s_rate, beta_rate, beta_rate}; }
};
constexpr std::array<Published, 5> published{{
    {0.01, 5.23307454791446680e-01, 5.00232383659537679e-01, -5.7785733056479538e-02, 4.82263275521235054e-02,
     6.28119041616925134e+00, 6.28251505078465769e-02},
    {0.5, 2.59491381543413121e-01, 7.43249424786325721e-01, -5.3905218498742472e-02, 5.21197801583734170e-02,
     5.10341542197153529e+00, 2.80767948836790160e+00},
    {1.0, 5.21833301625546231e-01, 5.01420922379567650e-01, 1.40885579479526918e-01, -1.2215149289772891e-01,
     6.27112574187655479e+00, 5.58634696586900543e+00},
    {5.0, 4.82874576586939814e-01, 5.35563103721643484e-01, 6.13917047388889548e-01, -5.4368269027787306e-01,
     6.02249649975845903e+00, 2.79425319910429574e+01},
    {10.0, 3.90073701844645080e-01, 6.19622917061365658e-01, 8.08467051345577400e-01, -7.4760335416433246e-01,
     5.54820362265492658e+00, 5.59354099091023787e+01},
}};
constexpr double published_momentum = 53.8689986584184324511851575229;

// Fifteen digits are quoted; the roundings of the decimals to double come on top.
TEST(FlyballGovernor, HasACommittedReferenceThatAgreesWithThePublishedFifteenDigits) {
  const auto reference = read_reference<double>(TORSOR_SOURCE_DIR "/generated/flyball_governor.reference.csv");
  ASSERT_EQ(reference.times[0], published[0].time);
  const State found = reference.state<8>(0), expected = published[0].state();
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-15 * std::abs(expected[i]) + 2 * rounding * std::abs(expected[i])) << i;
  }
}

// Errors of the steps, 1e-13 each at most, grow by `amplification` at most, and few of them live on: what limits the
// step is stability, not the tolerance, so nearly all are far smaller. The published problem asks for 1e-3 m of s.
TEST(FlyballGovernor, MeetsThePublishedMotion) {
  const auto motion = equations_of_motion<Governor>();
  // What displaced starts come to, by a method that stability does not hold up: to 1e-10 by any step of that size.
  examples::Amplification growth(motion, motion.initial(), 0.0,
                                 RadauIia5{.relative_tolerance = 1e-11, .absolute_tolerance = 1e-11});
  State y = motion.initial();
  double t = 0.0;
  for (const Published& at : published) {
    y = examples::state_at(motion, y, t, at.time, precise);
    t = at.time;
    EXPECT_LE(examples::largest_difference(y, at.state()), 1e-13 * growth.until(t)) << "at t = " << t;
  }
}

// T has some ten terms of 170 J at most.
TEST(FlyballGovernor, KeepsItsAngularMomentumAboutTheShaft) {
  const auto motion = equations_of_motion<Governor>();
  State y = motion.initial();
  for (int second = 0; second < 3; ++second) {
    Governor::FirstIntegrals integrals{};
    Governor::first_integrals(motion.precomputed(), unpack<Governor>(second, y), integrals);
    EXPECT_NEAR(integrals.momentum_psi, published_momentum, second == 0 ? 10 * rounding * 54 : 1e-10);
    y = examples::state_at(motion, y, second, second + 1, precise);
  }
}

// At the start each spring is 0.5 m long, along (cos 30, sin 30 degrees): its length e changes by -0.433 per radian of
// its rod (of moment 5.1 and half a gram m² for the section) and by -0.5 per metre of the slider (of 3 kg). When both
// springs lengthen alike, e'' = -w (c e' + k e) with w = 0.433²/5.1 + 2 0.5²/3. Gravity and rotation add a stiffness of
// some 50 1/s², which moves the fast root by 50/8000.
TEST(FlyballGovernor, IsStiff) {
  Governor::Linearisation linear{};
  ASSERT_EQ(Governor::linearisation(Governor::precompute({}), Governor::initial_state(), {}, {}, {}, linear),
            torsor::Status::ok);
  const Eigen::Map<const Eigen::Matrix<double, 8, 8>> A(linear.A.data());
  const Eigen::VectorXcd roots = torsor::runtime::eigenpairs(A).values;
  double fastest = 0.0;
  int slow = 0;
  for (const auto& root : roots) {
    fastest = std::fmin(fastest, root.real());
    if (std::abs(root) < 10.0) ++slow;
  }
  constexpr double k = 8e5, c = 4e4, moment = 0.3 * (1.0 + 1e-4) / 12.0 + 0.3 * 0.25 + 5.0;
  const double w = 3.0 / 16.0 / moment + 2.0 * 0.25 / 3.0;
  EXPECT_NEAR(fastest, -0.5 * c * w - std::sqrt(0.25 * c * c * w * w - k * w), 0.02);
  EXPECT_GE(slow, 4);
}

TEST(FlyballGovernor, ObeysTheEnergyTheorem) {
  const auto balance = examples::energy_balance<Governor>(equations_of_motion<Governor>(), 1.0, 1e-13);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-5);
  EXPECT_GT(balance.exchanged, 10.0);
}

}  // namespace
}  // namespace torsor::flyball_governor_test
