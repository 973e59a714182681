// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "generated/woodpecker_toy.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/mechanism_with_contacts.hpp"

namespace torsor::woodpecker_toy_test {
namespace {

using namespace torsor::runtime;
using Toy = MechanismWithContacts<woodpecker_toy::Mechanism<double>>;

// The values of the scene.
constexpr double m_sleeve = 0.0003, m_bird = 0.0045, c = 0.0056, g = 9.81, l_spring = 0.01, l_bird = 0.015, h = 0.0058, r = 0.0031,
                 r_pole = 0.0025;
const DormandPrince853 method{.relative_tolerance = 1e-10, .absolute_tolerance = 1e-10};

TEST(WoodpeckerToy, PecksInACycleThatForgetsItsStart) {
  std::vector<std::vector<double>> periods;
  for (const double rate : {-7.4, -6.0}) {
    const Toy toy({.f = 0.4, .e = 0.5});
    Toy::State y = toy.initial();
    y[5] = rate;
    std::vector<double> pecks;
    const auto result = integrate_contacts(toy, y, 0, 5, method, {}, [&](const ContactEvent& event) {
      EXPECT_GE(event.energy_lost, -1e-18);  // of some 1e-5 J
      if (event.kind == ContactEventKind::impact && event.contact == 0) pecks.push_back(event.time);
      return true;
    });
    ASSERT_TRUE(result) << describe(result.status);
    EXPECT_LE(result.worst_residual, 1e-13);
    std::vector<double> between;
    for (std::size_t k = 1; k < pecks.size(); ++k) between.push_back(pecks[k] - pecks[k - 1]);
    periods.push_back(between);
  }
  const auto apart = [&](std::size_t k) { return std::abs(periods[0].at(k) - periods[1].at(k)); };
  EXPECT_GT(apart(1), 1e-5);
  EXPECT_LT(apart(40), 0.01 * apart(1));
}

/// At rest on the lower edge: the sleeve tilts by its clearance, the bird by what its weight bends the spring.
Toy::State hanging(const Toy& toy) {
  Toy::State y = toy.initial();
  double phi = 0, theta = 0;
  for (int i = 0; i < 60; ++i) {
    phi = std::asin((r_pole - r * std::cos(phi)) / h);
    theta = phi - m_bird * g * l_bird * std::cos(theta) / c;
  }
  y = {0, phi, theta, 0, 0, 0};
  return y;
}

// Equilibrium of the whole: N and T at the edge, T = (m_sleeve + m_bird) g, and the moment about the sleeve's centre.
TEST(WoodpeckerToy, HangsStillWhereFrictionHoldsIt) {
  const Toy reference;
  const Toy::State start = hanging(reference);
  const double phi = start[1], theta = start[2], T = (m_sleeve + m_bird) * g;
  const double moment = m_bird * g * (l_spring * std::cos(phi) + l_bird * std::cos(theta));
  const double N = (moment - T * (r * std::cos(phi) + h * std::sin(phi))) / (h * std::cos(phi) - r * std::sin(phi));
  const double least = T / N;
  for (const double part : {0.999, 1.001}) {
    const Toy toy({.f = part * least, .e = 0.5});
    Toy::State y = start;
    const auto result = integrate_contacts(toy, y, 0, 0.05, method);
    ASSERT_TRUE(result) << describe(result.status);
    if (part > 1) {
      EXPECT_NEAR(y[0], 0, 1e-12);
      EXPECT_NEAR(y[2], theta, 1e-9);
    } else {
      EXPECT_LT(y[0], -1e-7);  // 0.001 g t²/2 and more
    }
  }
}

}  // namespace
}  // namespace torsor::woodpecker_toy_test
