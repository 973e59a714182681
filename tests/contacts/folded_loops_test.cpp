// SPDX-License-Identifier: GPL-3.0-or-later
// Parallelograms with contacts that swing over the place where they lie flat and the branches of their loops meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "tests/contacts/simple_systems.hpp"

namespace folded_loops_test {
namespace {

using namespace torsor::runtime;
using simple_systems::g;

/// Cranks of length 1 from a level base to a coupler, with masses at their ends: on the branch of the parallelogram a pendulum
/// of length 1. Angles θ_k from the downward vertical, then ψ of the coupler. The first crank has a stop, and dry friction.
template <std::size_t windows>
struct Parallelogram {
  static constexpr std::size_t cranks = windows + 1, nq = cranks + 1, nv = nq, contacts = 2;
  static constexpr int constraints = static_cast<int>(cranks);  ///< of 2 windows one repeats others, and is left out
  using State = std::array<double, nq + nv>;
  static constexpr std::array<double, 3> mass{1, 2, 0.5};
  double lower, bound;

  [[nodiscard]] ContactRule rule(int i) const {
    return i == 0 ? ContactRule{.tangents = 0, .restitution = 0.8} : ContactRule{.tangents = 1, .normal = false, .bound = bound};
  }
  [[nodiscard]] Evaluation read(double, const State& y, ContactReading& r) const {
    const auto at = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    r.M.setZero();
    r.F.setZero();
    r.A.setZero();
    r.J.setZero();
    r.drift.setZero();
    for (std::size_t k = 0; k < cranks; ++k) {
      r.M(at(k), at(k)) = mass[k];
      r.F(at(k)) = -mass[k] * g * std::sin(y[k]);
    }
    r.M(at(cranks), at(cranks)) = 0.3;
    const double psi = y[cranks], p = y[nq + cranks], s0 = std::sin(y[0]), c0 = std::cos(y[0]), w0 = y[nq];
    Eigen::Index row = 0;
    for (std::size_t k = 1; k < cranks; ++k) {
      const double L = windows == 2 && k == 1 ? 0.75 : 2, s = std::sin(y[k]), c = std::cos(y[k]), w = y[nq + k];
      const double x = L * std::cos(psi), z = L * std::sin(psi);
      const auto add = [&](double value, double first, double own, double coupler, double gamma) {
        r.value(row) = value;
        r.A(row, 0) = first;
        r.A(row, at(k)) = own;
        r.A(row, at(cranks)) = coupler;
        r.gamma(row) = gamma;
        r.rate(row++) = first * w0 + own * w + coupler * p;
      };
      add(s0 + x - L - s, c0, -c, -z, -s0 * w0 * w0 - x * p * p + s * w * w);
      if (k == 1) add(-c0 + z + c, s0, -s, x, c0 * w0 * w0 - z * p * p - c * w * w);
    }
    r.gap[0] = y[0] - lower;
    r.gap[1] = 0;
    r.J.col(0).setOnes();
    r.w.setConstant(w0);
    return Evaluation::ok;
  }
  static void coordinate_rates(double, const State& y, std::array<double, nq>& rates) {
    std::copy_n(y.begin() + nq, nq, rates.begin());
  }
};

/// Moves one and the pendulum. Steps are some hundred, each within the tolerance of numbers up to 6.
template <std::size_t windows>
ContactStatus compare(double lower, double bound, double tolerance) {
  SCOPED_TRACE(std::to_string(windows) + " windows, stop " + std::to_string(lower) + ", bound " + std::to_string(bound) +
               ", tolerance " + std::to_string(tolerance));
  using System = Parallelogram<windows>;
  const System loop{lower, bound};
  typename System::State y{};
  std::fill_n(y.begin(), System::cranks, 2.0);
  double total = 0;
  for (std::size_t k = 0; k < System::cranks; ++k) total += System::mass[k];
  const simple_systems::ByHand<1, 1, 2> pendulum{
      {loop.rule(0), loop.rule(1)}, [&](double, const auto& at, auto& r) {
        r.M(0, 0) = total;
        r.F(0) = -total * g * std::sin(at[0]);
        r.gap[0] = at[0] - lower;
        r.gap[1] = 0;
        r.J.setOnes();
        r.w.setConstant(at[1]);
        r.drift.setZero();
      }};
  const DormandPrince853 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
  long steps = 0;
  const ContactResult result = integrate_contacts(loop, y, 0, 6, method, {}, [&](double, const auto&) { return ++steps < 2000; });
  EXPECT_TRUE(result || result.status == ContactStatus::change_point) << describe(result.status) << " at " << result.time;
  std::array<double, 2> exact{2, 0};
  EXPECT_TRUE(integrate_contacts(pendulum, exact, 0, result.time, method));
  EXPECT_NEAR(y[0], exact[0], 600 * tolerance);
  for (std::size_t k = 1; k < System::cranks; ++k) EXPECT_NEAR(y[k], y[0], 600 * tolerance);
  EXPECT_NEAR(y[System::cranks], 0, 600 * tolerance);
  if (!result) {
    EXPECT_LT(std::abs(std::cos(y[0])), 0.3);
  }
  return result.status;
}

// On the branch of the parallelogram to the end, or to a status that says why not.
TEST(FoldedLoops, GoOnAlongTheirBranchOrSayThatTheyDoNot) {
  int reached = 0, ended = 0;
  for (const double tolerance : {1e-12, 1e-9, 1e-6}) {
    for (const double bound : {0.0, 0.5}) {
      for (const double lower : {-1.8, -3.0, -1.2}) {
        for (const ContactStatus status : {compare<1>(lower, bound, tolerance), compare<2>(lower, bound, tolerance)}) {
          (status == ContactStatus::reached_end ? reached : ended) += 1;
        }
      }
    }
  }
  EXPECT_GT(reached, ended);
}

// A stop where it lies flat: the motion comes to rest there.
TEST(FoldedLoops, EndAtAStopWhereBranchesMeet) {
  const Parallelogram<1> loop{-std::acos(0.0), 0};
  Parallelogram<1>::State y{2, 2};
  const ContactResult result = integrate_contacts(loop, y, 0, 6);
  EXPECT_EQ(result.status, ContactStatus::change_point);
  EXPECT_NE(describe(result.status).find("change point"), std::string::npos);
  EXPECT_NEAR(std::abs(y[0]), std::acos(0.0), 0.015);
}

}  // namespace
}  // namespace folded_loops_test
