// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace examples {

/// How far a run is from the energy theorem, and how far the integrator's tolerance lets it be.
struct EnergyBalance {
  double imbalance = 0.0;  ///< largest |T - U - (T - U at the start) - work of what has no force function| [J]
  double allowed = 0.0;    ///< [J]
  double work = 0.0;       ///< largest |work of what has no force function|: what the theorem had to account for [J]
  double exchanged = 0.0;  ///< largest |T - T at the start| [J]
};

/// The power of actions that the kernel `energy` does not know (motors that impose a law of time), for those who need
/// none.
struct NoOtherPower {
  template <class State, class Accelerations, class Multipliers>
  double operator()(const State&, const Accelerations&, const Multipliers&) const {
    return 0.0;
  }
};

/// The energy theorem d(T - U)/dt = P along a run of Dormand-Prince from the scene's initial state to t1, P being the
/// kernel's power plus `other_power(state, accelerations, multipliers)`. The work, integral of P, is one more component
/// of the state, so that T - U - work is a first integral of what is integrated: it changes by the local errors e_i of
/// the steps alone, each by Σ g_i e_i with g its gradient. A step is kept when its estimated error has
/// Σ (e_i / s_i)² <= n, s_i = tolerance (1 + |y_i|), so by Cauchy and Schwarz a step changes it by at most
/// sqrt(n Σ (g_i s_i)²): `allowed` is the sum of that over the steps, plus 50 roundings of the energies themselves.
template <class Mechanism, class Motion, class OtherPower = NoOtherPower>
[[nodiscard]] EnergyBalance energy_balance(const Motion& motion, double t1, double tolerance,
                                           const OtherPower& other_power = {}) {
  using namespace torsor::runtime;
  constexpr std::size_t n = coordinates_of<Mechanism> + velocities_of<Mechanism>;
  using Vector = std::array<double, n>;
  using Extended = std::array<double, n + 1>;
  const auto state_of = [](const Extended& y) {
    Vector head;
    std::copy_n(y.begin(), n, head.begin());
    return head;
  };
  const auto energy_at = [&](double t, const Vector& y) {
    const auto state = unpack<Mechanism>(t, y);
    typename Mechanism::Energy energy{};
    Mechanism::energy(motion.precomputed(), state, motion.input_law()(state), energy);
    return energy;
  };
  const auto system = [&](double t, const Extended& y, Extended& rates) {
    const Vector head = state_of(y);
    Vector head_rates;
    const Evaluation evaluation = motion(t, head, head_rates);
    std::copy(head_rates.begin(), head_rates.end(), rates.begin());
    const auto state = unpack<Mechanism>(t, head);
    typename Mechanism::Accelerations a{};
    typename Mechanism::Multipliers lambda{};
    (void)motion.accelerations(state, a, lambda);
    rates[n] = energy_at(t, head).power + other_power(state, a, lambda);
    return evaluation;
  };

  EnergyBalance balance;
  Extended y{};
  const Vector start = motion.initial();
  std::copy(start.begin(), start.end(), y.begin());
  const auto first = energy_at(motion.initial_time(), start);
  Extended before = y;
  const auto observe = [&](double t, const Extended& now) {
    const Vector head = state_of(now);
    const auto energy = energy_at(t, head);
    constexpr double rounding = 1.1e-16;
    double sum = std::pow(tolerance * (1.0 + std::abs(now[n])), 2);  // the work's own term
    for (std::size_t i = 0; i < n; ++i) {
      const double size = 1.0 + std::fmax(std::abs(now[i]), std::abs(before[i])), h = 1e-6 * size;
      Vector up = head, down = head;
      up[i] += h;
      down[i] -= h;
      const auto above = energy_at(t, up), below = energy_at(t, down);
      const double slope = (above.kinetic - above.force_function - below.kinetic + below.force_function) / (2.0 * h);
      sum += std::pow(slope * tolerance * size, 2);
    }
    balance.allowed += std::sqrt(static_cast<double>(n + 1) * sum);
    const double roundings = 50 * rounding * (energy.kinetic + std::abs(energy.force_function) + std::abs(now[n]));
    const double gain = (energy.kinetic - first.kinetic) - (energy.force_function - first.force_function);
    balance.imbalance = std::fmax(balance.imbalance, std::abs(gain - now[n]) - roundings);
    balance.work = std::fmax(balance.work, std::abs(now[n]));
    balance.exchanged = std::fmax(balance.exchanged, std::abs(energy.kinetic - first.kinetic));
    before = now;
  };
  const DormandPrince54 method{.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
  const auto result = integrate(system, y, motion.initial_time(), t1, method, observe);
  EXPECT_TRUE(result) << describe(result);
  return balance;
}

/// The theorem holds, the run exchanged something, and `allowed` is far below it, or the test would say nothing.
inline void expect_kept(const EnergyBalance& balance, double least_exchanged) {
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_GT(balance.exchanged, least_exchanged);
  EXPECT_LT(balance.allowed, 1e-6 * balance.exchanged);
}

}  // namespace examples
