// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/elastic_wing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/small_motions/linear_system.hpp"
#include "torsor/runtime/small_motions/modes.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"

namespace torsor::elastic_wing_test {
namespace {

using namespace torsor::runtime;
using Wing = elastic_wing::Mechanism<double>;
using Matrix = Eigen::Matrix<double, 6, 6>;
using Vector = Eigen::Matrix<double, 6, 1>;

// The values of the scene.
constexpr std::array<double, 4> mass{1300.0, 800.0, 450.0, 250.0}, stiffness{3e7, 1.4e7, 6e6, 2.5e6};
constexpr double m_fuselage = 15700.0, m_engine = 2000.0, length = 4.0, hang = 1.2, J_engine = 700.0, k_engine = 6e5;
constexpr double delay = 0.002;

/// Small motions by hand, coordinates z, beta_1 ... beta_4, gamma: the heights of all parts are linear in them.
struct Small {
  Matrix M = Matrix::Zero(), K = Matrix::Zero();
  Vector gust = Vector::Zero();  ///< of 1 N on each panel
};

Small by_hand() {
  Small small;
  const auto add = [&small](const Vector& moving, double m) { small.M += m * moving * moving.transpose(); };
  Vector height = Vector::Unit(0), turn = Vector::Zero();  // of the inner end of a panel, of the panel
  add(height, m_fuselage);
  for (int i = 0; i < 4; ++i) {
    const double m = mass[static_cast<std::size_t>(i)];
    turn += Vector::Unit(1 + i);
    const Vector middle = height + length / 2.0 * turn;
    add(middle, m);
    add(turn, m * length * length / 12.0);
    small.gust += middle;
    height += length * turn;
    if (i == 0) {
      const Vector engine = turn + Vector::Unit(5);  // it swings sideways by hang times its turn
      add(height, m_engine);
      add(engine, J_engine + m_engine * hang * hang);
    }
    small.K(1 + i, 1 + i) = stiffness[static_cast<std::size_t>(i)];
  }
  small.K(5, 5) = k_engine;
  return small;
}

LinearSystem linearised(const Wing::Parameters& parameters) {
  Wing::Linearisation linear{};
  EXPECT_EQ(Wing::linearisation(Wing::precompute(parameters), Wing::State{}, {}, {}, {}, linear), torsor::Status::ok);
  return linear_system(linear);
}

// Entries up to 3e7: thirty roundings of the largest of each matrix.
TEST(ElasticWing, HasTheMatricesOfItsSmallMotionsByHand) {
  const Small small = by_hand();
  const LinearSystem system = linearised({.gust = 100.0});
  constexpr double rounding = 30 * 1.1e-16;
  EXPECT_LE((system.M - small.M).cwiseAbs().maxCoeff(), rounding * small.M.maxCoeff());
  EXPECT_LE((system.K - small.K).cwiseAbs().maxCoeff(), rounding * 3e7);
  EXPECT_LE((system.C - delay * small.K).cwiseAbs().maxCoeff(), rounding * 3e7 * delay);
  EXPECT_LE((system.F - 100.0 * small.gust).cwiseAbs().maxCoeff(), rounding * 100.0 * small.gust.maxCoeff());
}

// Rayleigh's quotients of the modes with matrices made by hand; one mode, heaving, is free.
TEST(ElasticWing, HasTheModesOfTheMatricesMadeByHand) {
  const Small small = by_hand();
  const NaturalModes modes = natural_modes(linearised({.gust = 0.0}));
  for (int i = 0; i < 6; ++i) {
    const Vector shape = modes.shapes.col(i);
    const double square = modes.squared_frequencies(i);
    const double largest = modes.squared_frequencies(5);
    EXPECT_LE((small.K * shape - square * small.M * shape).norm(), 1e-12 * largest * (small.M * shape).norm()) << i;
  }
  EXPECT_NEAR(modes.squared_frequencies(0), 0.0, 1e-10);
  EXPECT_GT(modes.angular_frequency(1), 1.0);
}

// The damping is proportional, C = delay K: every mode moves on its own: x'' + delay w² x' + w² x = f
// from rest, f t²/2 for the free one. A gust of 1 N bends the wing by 1e-6 rad, so that what is not linear is 1e-12 of
// it.
TEST(ElasticWing, AnswersASmallGustAsItsModesDo) {
  const Small small = by_hand();
  const Wing::Parameters parameters{.gust = 1e-4};
  const auto motion = equations_of_motion<Wing>(parameters);
  const NaturalModes modes = natural_modes(undamped(small.M, small.K));
  StateVector<Wing> y{};
  double t = 0.0;
  for (const double end : {0.1, 0.5, 1.0, 3.0}) {
    y = examples::state_at(motion, y, t, end,
                           DormandPrince54{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-21});
    t = end;
    Vector expected = Vector::Zero();
    for (int i = 0; i < 6; ++i) {
      const double force = modes.shapes.col(i).dot(1e-4 * small.gust), square = modes.squared_frequencies(i);
      double answer = force * t * t / 2.0;
      if (i > 0) {
        const double decay = delay * square / 2.0, rest = square - decay * decay;
        // Overdamped modes by the same formula with hyperbolic functions.
        const double w = std::sqrt(std::abs(rest));
        const double cosine = rest > 0.0 ? std::cos(w * t) : std::cosh(w * t);
        const double sine = (rest > 0.0 ? std::sin(w * t) : std::sinh(w * t)) / w;
        answer = force / square * (1.0 - std::exp(-decay * t) * (cosine + decay * sine));
      }
      expected += answer * modes.shapes.col(i);
    }
    const double size = expected.tail<5>().cwiseAbs().maxCoeff();
    for (int i = 0; i < 6; ++i) {
      const double allowed = 1e-8 * (i == 0 ? expected.cwiseAbs().maxCoeff() : size);
      EXPECT_NEAR(y[static_cast<std::size_t>(i)], expected(i), allowed) << i << " at " << t;
    }
  }
}

TEST(ElasticWing, ObeysTheEnergyTheoremInAGust) {
  const auto balance = examples::energy_balance<Wing>(equations_of_motion<Wing>(), 3.0, 1e-12);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 0.1);  // of energies of some 1e6 J
  EXPECT_GT(balance.work, 1e5);
}

}  // namespace
}  // namespace torsor::elastic_wing_test
