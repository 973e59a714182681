// SPDX-License-Identifier: GPL-3.0-or-later

// The instances for Real, thousands of calls in one function, cost an optimiser minutes. Rounding is the same without.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O0")
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "generated/arm7.hpp"
#include "generated/double_pendulum.hpp"
#include "generated/loading_robot.hpp"
#include "generated/rolling_hoop.hpp"
#include "generated/rolling_hoop_contact_forces.hpp"
#include "generated/satellite_arms.hpp"
#include "generated/vibration_absorber.hpp"
#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"
#include "torsor/generator/base/number.hpp"
#include "tests/examples/kernel_comparison.hpp"

namespace torsor::generated_headers_test {
namespace {

using examples::Evaluated;
using examples::Results;
using testing_rounding::RightToRounding;

constexpr unsigned states = 20;

/// Runs one check over all mechanisms; the letters tell the units of their coordinates, the number their bodies.
template <class Check>
void for_all_mechanisms(const Check& check) {
  check.template operator()<arm7::Mechanism>("rrrrrrr", 7);
  check.template operator()<double_pendulum::Mechanism>("rr", 2);
  check.template operator()<loading_robot::Mechanism>("rmr", 3);
  check.template operator()<rolling_hoop::Mechanism>("mmrrr", 1);
  check.template operator()<rolling_hoop_contact_forces::Mechanism>("mmmrrr", 1);
  check.template operator()<satellite_arms::Mechanism>("rrr", 3);
  check.template operator()<vibration_absorber::Mechanism>("mr", 3);
}

/// Kernels on a machine number against the same kernels on Real at the same inputs. A kernel computes sums of products
/// whose terms may exceed the result by some tens; 900 roundings are allowed, and 90 times the condition of the mass
/// matrix where equations are solved: in double 1e-13 and 1e-14 cond(M).
constexpr double of_sums = 900, of_solutions = 90;

template <template <class> class Mechanism>
RightToRounding compared(const Evaluated<Mechanism, Real>& truth, const Results& direct, const Results& solved,
                         double unit) {
  RightToRounding check(unit);
  examples::compare(check, direct, truth.direct, of_sums);
  const double cond = condition_number(truth.mass, Mechanism<Real>::velocity_count);
  examples::compare(check, solved, truth.solved, of_solutions * cond);
  return check;
}

template <class Scalar>
void expect_close_to_real() {
  for_all_mechanisms([]<template <class> class Mechanism>(const char* units, int bodies) {
    for (unsigned seed = 1; seed <= states; ++seed) {
      const Evaluated<Mechanism, Real> truth(units, bodies, seed);
      const Evaluated<Mechanism, Scalar> found(units, bodies, seed);
      const RightToRounding check = compared(truth, found.direct, found.solved, testing_rounding::unit_of<Scalar>);
      EXPECT_TRUE(check) << Mechanism<Scalar>::name << ": " << check;
    }
  });
}

TEST(GeneratedHeaders, AreRightToRoundingInDouble) { expect_close_to_real<double>(); }

TEST(GeneratedHeaders, AreRightToRoundingInFloat) { expect_close_to_real<float>(); }

// A result that is off by twice its bound is found, in every group of every mechanism.
TEST(GeneratedHeaders, AreNotRightWhenOneResultIsOff) {
  for_all_mechanisms([]<template <class> class Mechanism>(const char* units, int bodies) {
    const Evaluated<Mechanism, Real> truth(units, bodies, 1);
    const Evaluated<Mechanism, double> found(units, bodies, 1);
    const double unit = testing_rounding::unit_of<double>;
    const double cond = condition_number(truth.mass, Mechanism<Real>::velocity_count);
    for (const bool is_solved : {false, true}) {
      const Results& right = is_solved ? found.solved : found.direct;
      for (const auto& [key, values] : right) {
        Results wrong = right;
        std::vector<Real>& changed = wrong.at(key);
        const auto largest = std::max_element(changed.begin(), changed.end(),
                                              [](const Real& a, const Real& b) { return abs(a) < abs(b); });
        // The largest of n is at least the length over √n.
        const double allowed = is_solved ? of_solutions * cond : of_sums;
        const double times = 2 * std::sqrt(static_cast<double>(values.size())) * allowed;
        *largest += largest->is_zero() ? Real(1) : *largest * Real::from_double(times * unit);
        const RightToRounding check =
            is_solved ? compared(truth, found.direct, wrong, unit) : compared(truth, wrong, found.solved, unit);
        ASSERT_EQ(check.excesses().size(), 1U) << Mechanism<double>::name << ", " << key;
        EXPECT_EQ(check.excesses()[0].entry, key);
      }
    }
  });
}

// A computation that stopped at some precision of its own would not follow from 50 digits to 70. What 50 digits lose by
// cancellation is allowed.
TEST(GeneratedHeaders, FollowThePrecisionOfReal) {
  for_all_mechanisms([]<template <class> class Mechanism>(const char* units, int bodies) {
    const auto at = [units, bodies](int digits, unsigned seed) {
      const WorkingDigits working(digits);
      return Evaluated<Mechanism, Real>(units, bodies, seed);
    };
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const auto coarse = at(50, seed), fine = at(70, seed);
      RightToRounding check(1e-50);
      examples::compare(check, coarse.direct, fine.direct, 100);
      const double cond = condition_number(fine.mass, Mechanism<Real>::velocity_count);
      examples::compare(check, coarse.solved, fine.solved, 100 * cond);
      EXPECT_TRUE(check) << Mechanism<Real>::name << ": " << check;
    }
  });
}

// Constants against their exact values: a double in place of a number would show in the 17th digit.
TEST(GeneratedHeaders, HideNoDoubleInTheInstanceForReal) {
  const WorkingDigits working(50);
  const Real tolerance = Real::parse("1e-47");
  const auto near = [&tolerance](const Real& found, const Real& expected) {
    return abs(found - expected) <= tolerance * abs(expected);
  };
  using Pendulum = double_pendulum::Mechanism<Real>;
  Pendulum::State hanging = Pendulum::initial_state();  // (2, 2.5), at rest
  Pendulum::GeneralizedForces weight{};
  Pendulum::bias(Pendulum::precompute({}), hanging, weight);
  EXPECT_TRUE(near(weight.theta_1, Real::parse("19.62") * sin(Real(2))));
  EXPECT_TRUE(near(weight.theta_2, Real::parse("9.81") * sin(Real::parse("2.5"))));

  using Hoop = rolling_hoop::Mechanism<Real>;  // numbers that no fraction gives: sine and cosine of 1.2
  const Hoop::State start = Hoop::initial_state();
  EXPECT_TRUE(near(start.q.y, cos(Real::parse("1.2"))));
  EXPECT_TRUE(near(start.v.x, Real(4) - Real::parse("0.5") * cos(Real::parse("1.2"))));

  using Satellite = satellite_arms::Mechanism<Real>;  // springs of 30 and 35 N m/rad at rest at pi/2 and -pi/2
  Satellite::State folded = Satellite::initial_state();
  folded.q.theta_2 = folded.q.theta_3 = folded.v.psi = Real(0);
  Satellite::GeneralizedForces springs{};
  Satellite::bias(Satellite::precompute({}), folded, springs);
  EXPECT_TRUE(near(springs.theta_2, -Real(15) * Real::pi()));
  EXPECT_TRUE(near(springs.theta_3, Real::parse("17.5") * Real::pi()));
}

/// Whether a fraction can only come from a binary number: its denominator is a power of two that no decimal of a scene
/// leaves without a power of five.
bool is_binary(const std::string& fraction) {
  const std::size_t slash = fraction.find('/');
  if (slash == std::string::npos || fraction.find(';') != std::string::npos) return false;  // roots come from no binary
  const torsor::Number denominator = torsor::Number::from_exact(fraction.substr(slash + 1));
  torsor::Number power = 1;
  while (power < denominator) power *= 2;
  return power == denominator && denominator > torsor::Number(1024);
}

// Every literal of every header is the number beside it, rounded once for each of the two formats.
TEST(GeneratedHeaders, HaveCorrectlyRoundedLiterals) {
  const std::regex constant(R"re(traits::constant\(([^,]+), ([^,]+)f, "([^"]+)"\))re");
  for (const auto& entry : std::filesystem::directory_iterator(TORSOR_SOURCE_DIR "/generated")) {
    if (entry.path().extension() != ".hpp" || entry.path().stem() == "torsor_support") continue;
    std::ifstream stream(entry.path());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    int constants = 0;
    for (std::sregex_iterator match(text.begin(), text.end(), constant), end; match != end; ++match, ++constants) {
      const torsor::Number exact = torsor::Number::from_exact(match->str(3));
      EXPECT_EQ(std::stod(match->str(1)), exact.to_double()) << entry.path().filename() << ": " << match->str();
      EXPECT_FALSE(is_binary(match->str(3))) << entry.path().filename() << ": " << match->str();
      EXPECT_EQ(std::stof(match->str(2)), exact.to_float()) << entry.path().filename() << ": " << match->str();
    }
    EXPECT_GT(constants, 10) << entry.path().filename();
  }
}

}  // namespace
}  // namespace torsor::generated_headers_test
