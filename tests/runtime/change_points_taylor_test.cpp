// SPDX-License-Identifier: GPL-3.0-or-later
// Taylor's method where the constraints of a closed loop lose rank: its coefficients lose a digit with every order
// there, so that it steps over the place or ends with a status.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "torsor/runtime/constraints/closed_motion.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/windows.hpp"

namespace change_points_taylor_test {
namespace {

using namespace torsor::runtime;
using mechanisms::Windows;
constexpr double pi = std::numbers::pi;

/// With the Taylor coefficients of its motions: at every order n the constraints give A q_n, and the equations of
/// motion give M q_n n (n - 1) up to Aᵀ λ_(n-2); everything else is known from lower orders.
template <int windows>
struct WindowsWithJets : Windows<windows> {
  using Base = Windows<windows>;
  using Base::m;
  using Base::n;
  using typename Base::Inputs;
  using typename Base::Precomputed;
  using typename Base::State;
  using Vector = std::array<double, 2 * Base::size>;

  static mechanisms::Status jets(const Precomputed&, const State& state, const Inputs&, int order, Vector* c) noexcept {
    std::array<std::array<double, 33>, Base::size> q{}, sine{}, cosine{};
    std::array<std::array<double, 33>, Base::rows> lambda{};
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    const auto angle_functions = [&](int k) {
      for (std::size_t i = 0; i < Base::size; ++i) {
        for (int j = 1; j <= k; ++j) {
          sine[i][at(k)] += j * q[i][at(j)] * cosine[i][at(k - j)] / k;
          cosine[i][at(k)] -= j * q[i][at(j)] * sine[i][at(k - j)] / k;
        }
      }
    };
    for (std::size_t i = 0; i < Base::size; ++i) {
      q[i][0] = state.q[static_cast<int>(i)];
      q[i][1] = state.v[static_cast<int>(i)];
      sine[i][0] = std::sin(q[i][0]);
      cosine[i][0] = std::cos(q[i][0]);
    }
    angle_functions(1);
    // Row r's derivative with respect to coordinate i, of which there are three each, of order l.
    const auto entry = [&](int r, int which, int& coordinate, int l) {
      const int window = r / 2 + 1;
      const bool x = r % 2 == 0;
      coordinate = which == 0 ? window - 1 : which == 1 ? windows + window : window;
      const double s = sine[at(coordinate)][at(l)], k = cosine[at(coordinate)][at(l)];
      if (which == 1) return x ? -s : k;
      return (x ? k : s) * (which == 0 ? 1 : -1);
    };
    for (int k = 2; k <= order + 1; ++k) {
      angle_functions(k);  // with q_k = 0
      const double twice = k * (k - 1);
      std::array<double, Base::size> force{};
      for (int i = 0; i <= windows; ++i)
        force[at(i)] = -Base::mass_of(i) * mechanisms::gravity<double> * sine[at(i)][at(k - 2)];
      for (int r = 0; r < m; ++r) {
        for (int which = 0; which < 3; ++which) {
          for (int l = 1; l <= k - 2; ++l) {
            int i = 0;
            const double part = entry(r, which, i, l);
            force[at(i)] += part * lambda[at(r)][at(k - 2 - l)];
          }
        }
      }
      std::array<std::array<double, Base::rows + 1>, Base::rows> S{};
      for (int r = 0; r < m; ++r) {
        const int window = r / 2 + 1, coupler = windows + window;
        const double rest = r % 2 == 0
                                ? sine[at(window - 1)][at(k)] + cosine[at(coupler)][at(k)] - sine[at(window)][at(k)]
                                : -cosine[at(window - 1)][at(k)] + sine[at(coupler)][at(k)] + cosine[at(window)][at(k)];
        S[at(r)][Base::rows] = -rest * twice;
        for (int which = 0; which < 3; ++which) {
          int i = 0;
          const double a = entry(r, which, i, 0) / Base::mass_of(i);
          S[at(r)][Base::rows] -= a * force[at(i)];
          for (int other = 0; other < m; ++other) {
            for (int its = 0; its < 3; ++its) {
              int j = 0;
              const double b = entry(other, its, j, 0);
              if (i == j) S[at(r)][at(other)] += a * b;
            }
          }
        }
      }
      for (std::size_t p = 0; p < Base::rows; ++p) {
        if (!(S[p][p] > 2.2e-16)) return mechanisms::Status::singular;
        for (std::size_t r = p + 1; r < Base::rows; ++r) {
          const double factor = S[r][p] / S[p][p];
          for (std::size_t j = p; j <= Base::rows; ++j) S[r][j] -= factor * S[p][j];
        }
      }
      for (std::size_t p = Base::rows; p-- > 0;) {
        double sum = S[p][Base::rows];
        for (std::size_t j = p + 1; j < Base::rows; ++j) sum -= S[p][j] * lambda[j][at(k - 2)];
        lambda[p][at(k - 2)] = sum / S[p][p];
      }
      for (int r = 0; r < m; ++r) {
        for (int which = 0; which < 3; ++which) {
          int i = 0;
          const double a = entry(r, which, i, 0);
          force[at(i)] += a * lambda[at(r)][at(k - 2)];
        }
      }
      for (int i = 0; i < n; ++i) {
        q[at(i)][at(k)] = force[at(i)] / (Base::mass_of(i) * twice);
        sine[at(i)][at(k)] += cosine[at(i)][0] * q[at(i)][at(k)];
        cosine[at(i)][at(k)] -= sine[at(i)][0] * q[at(i)][at(k)];
      }
    }
    for (int k = 0; k <= order; ++k) {
      for (std::size_t i = 0; i < Base::size; ++i) {
        c[k][i] = q[i][at(k)];
        c[k][Base::size + i] = (k + 1) * q[i][at(k + 1)];
      }
    }
    return mechanisms::Status::ok;
  }
};

struct Pendulum {
  [[nodiscard]] Evaluation operator()(double, const std::array<double, 2>& y,
                                      std::array<double, 2>& dydt) const noexcept {
    dydt = {y[1], -mechanisms::gravity<double> * std::sin(y[0])};
    return Evaluation::ok;
  }
};

/// From any start and at any tolerance: the pendulum's motion, or a status that names the change point, in few steps.
template <int windows>
void expect_right_or_told(int count, int& passed, int& told) {
  using M = WindowsWithJets<windows>;
  std::mt19937 random(windows);
  std::uniform_real_distribution<double> angle(-pi, pi), rate(-4.0, 4.0);
  for (int i = 0; i < count; ++i) {
    typename M::Parameters start{angle(random), i % 3 == 0 ? 0.0 : rate(random)};
    if (i % 5 == 4) start = {pi / 2 - 1e-2 * angle(random), 3.5};  // right before a change point, from time zero
    for (const double tolerance : {1e-4, 1e-7, 1e-10, 1e-12}) {
      const auto motion = equations_of_motion<M>(start);
      auto y = motion.initial();
      std::array<double, 2> pendulum{start.angle, start.rate};
      const DormandPrince853 sharp{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13};
      ASSERT_TRUE(integrate(Pendulum{}, pendulum, 0, 3, sharp));
      const auto result =
          integrate(motion, y, 0, 3, Taylor{.relative_tolerance = tolerance, .absolute_tolerance = tolerance});
      EXPECT_LT(result.statistics.accepted + result.statistics.rejected, 1000) << start.angle << ' ' << start.rate;
      if (!result) {
        ++told;
        EXPECT_NE(describe(result).find("change point"), std::string::npos) << describe(result);
        continue;
      }
      ++passed;
      // From near the upper equilibrium errors grow by exp(3 sqrt 9.81) = 1e4.
      const double allowed = 1e5 * tolerance + 1e-9;
      EXPECT_NEAR(y[0], pendulum[0], allowed) << start.angle << ' ' << start.rate << ' ' << tolerance;
      EXPECT_NEAR(y[M::velocity_count], pendulum[1], allowed) << start.angle << ' ' << start.rate << ' ' << tolerance;
    }
  }
}

TEST(TaylorThroughChangePoints, IsRightOrTellsThem) {
  int passed = 0, told = 0;
  expect_right_or_told<1>(40, passed, told);
  expect_right_or_told<2>(20, passed, told);
  EXPECT_GT(passed, 60);
  EXPECT_GT(told, 0);
}

TEST(TaylorThroughChangePoints, MeetsThePendulumBesideThem) {
  using M = WindowsWithJets<2>;
  const auto motion = equations_of_motion<M>({0.5, 0.0});  // swings to 0.5 rad
  auto y = motion.initial();
  std::array<double, 2> pendulum{0.5, 0.0};
  ASSERT_TRUE(integrate(Pendulum{}, pendulum, 0, 3,
                        DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13}));
  ASSERT_TRUE(integrate(motion, y, 0, 3, Taylor{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12}));
  EXPECT_NEAR(y[0], pendulum[0], 1e-10);  // some thirty steps, no error of which grows
  EXPECT_NEAR(y[5], pendulum[1], 1e-10);
}

}  // namespace
}  // namespace change_points_taylor_test
