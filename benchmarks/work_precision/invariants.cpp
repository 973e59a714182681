// SPDX-License-Identifier: GPL-3.0-or-later
// What should not change over long runs: energy, momentum, constraints.
#include "work_precision_top.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/work_precision/drift.hpp"
#include "benchmarks/work_precision/processor_time.hpp"
#include "generated/andrews_squeezer.hpp"
#include "generated/rolling_hoop.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/observers.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/integration/variational_integrator.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/file.hpp"

namespace work_precision {
namespace {

using namespace torsor::runtime;
using Top = work_precision_top::Mechanism<double>;
using Hoop = rolling_hoop::Mechanism<double>;
using Squeezer = andrews_squeezer::Mechanism<double>;

/// Largest changes so far, of the energy and of what else should stay, at a tenth of a run and at its end.
struct Change {
  std::string motion, method;
  std::array<double, 2> energy{}, other{};
  double seconds = 0.0;
  Result<double> result{};
};

/// The energy and the momentum of the spin, dT/dpsi'.
std::array<double, 2> kept(const StateVector<Top>& y) {
  static const auto precomputed = Top::precompute(Top::default_parameters());
  Top::FirstIntegrals integrals{};
  Top::first_integrals(precomputed, unpack<Top>(0.0, y), integrals);
  return {integrals.energy, integrals.momentum_psi};
}

/// The energy and the largest rate of the contact, which should not slip.
std::array<double, 2> kept(const StateVector<Hoop>& y) {
  static const auto precomputed = Hoop::precompute(Hoop::default_parameters());
  const auto state = unpack<Hoop>(0.0, y);
  Hoop::FirstIntegrals integrals{};
  Hoop::first_integrals(precomputed, state, integrals);
  Hoop::Constraints constraints{};
  Hoop::constraints(precomputed, state, constraints);
  return {integrals.energy, std::max(std::abs(constraints.rate[0]), std::abs(constraints.rate[1]))};
}

/// The energy without what the motor has done, its constant torque times its angle, and the largest gap of the loops.
std::array<double, 2> kept(const StateVector<Squeezer>& y) {
  constexpr double torque = 0.033;
  static const auto precomputed = Squeezer::precompute(Squeezer::default_parameters());
  const auto state = unpack<Squeezer>(0.0, y);
  Squeezer::Energy energy{};
  Squeezer::energy(precomputed, state, {}, energy);
  Squeezer::Constraints constraints{};
  Squeezer::constraints(precomputed, state, constraints);
  double gap = 0.0;
  for (const double value : constraints.value) gap = std::max(gap, std::abs(value));
  return {energy.kinetic - energy.force_function - torque * state.q.beta, gap};
}

template <class Motion, class Method>
Change change_of(std::string motion_name, std::string name, const Motion& motion, double end, const Method& method) {
  auto y = motion.initial();
  const std::array<double, 2> first = kept(y);
  Change change{std::move(motion_name), std::move(name)};
  const auto watch = [&](double t, const auto& state) noexcept {
    const std::array<double, 2> now = kept(state);
    const double energy = std::abs((now[0] - first[0]) / first[0]);
    const double other = first[1] != 0.0 && Motion::Mechanism::multiplier_count == 0
                             ? std::abs((now[1] - first[1]) / first[1])
                             : std::abs(now[1]);
    for (std::size_t i = t < end / 10 ? 0 : 1; i < 2; ++i) {
      change.energy[i] = std::max(change.energy[i], energy);
      change.other[i] = std::max(change.other[i], other);
    }
  };
  Every observer(10, watch);  // so that looking costs little
  const double start = processor_seconds();
  change.result = integrate(motion, y, 0.0, end, method, observer);
  change.seconds = processor_seconds() - start;
  return change;
}

template <class Method>
Method sharp(double tolerance, Method method = {}) {
  method.relative_tolerance = tolerance;
  method.absolute_tolerance = tolerance;
  method.step_limit = 1'000'000'000;
  return method;
}

void print(const char* other, const std::vector<Change>& changes) {
  fmt::print("{:<9}{:<40}{:>24}{:>24}{:>10}{:>10}\n", "motion", "integrator", "energy, a tenth, all", other, "steps",
             "s");
  for (const Change& change : changes) {
    fmt::print("{:<9}{:<40}{:>24}{:>24}{:>10}{:>10.2f}\n", change.motion, change.method,
               change.result ? fmt::format("{:.1e} {:.1e}", change.energy[0], change.energy[1]) : "failed",
               fmt::format("{:.1e} {:.1e}", change.other[0], change.other[1]), change.result.statistics.accepted,
               change.seconds);
  }
}

}  // namespace

void measure_invariants(const std::filesystem::path& folder) {
  constexpr std::int64_t million = 1'000'000;
  constexpr double time = 1e4;
  std::vector<Change> changes;

  const auto top = equations_of_motion<Top>();
  // A million steps of a thousandth of a second, or 10^4 s.
  const auto add_top = [&](std::string name, double end, const auto& method) {
    changes.push_back(change_of("top", std::move(name), top, end, method));
  };
  const double step = 1e-3, end = step * static_cast<double>(million);
  add_top("Gauss collocation 6, h 1e-3, 10^6 steps", end, GaussCollocation<3>{.step = step});
  add_top("variational 6, h 1e-3, 10^6 steps", end, VariationalIntegrator<3>{.step = step});
  add_top("Runge-Kutta 4, h 1e-3, 10^6 steps", end, RungeKutta4{.step = step});
  add_top("Taylor compensated 1e-15, 10^4 s", time, sharp(1e-15, Taylor{.compensated = true}));
  add_top("Dormand-Prince 8(5,3) 1e-12, 10^4 s", time, sharp<DormandPrince853>(1e-12));
  fmt::print("\nheavy top: largest relative change of the energy and of the momentum of the spin\n");
  print("momentum, a tenth, all", changes);

  std::vector<Change> rolling;
  const auto hoop = unprojected_motion<Hoop>();
  const auto held = equations_of_motion<Hoop>();
  const double hoop_step = 1e-2, hoop_end = hoop_step * static_cast<double>(million);
  const auto add = [&](std::string name, const auto& motion, double until, const auto& method) {
    rolling.push_back(change_of("hoop", std::move(name), motion, until, method));
  };
  add("Runge-Kutta 4, h 1e-2, 10^6 steps", hoop, hoop_end, RungeKutta4{.step = hoop_step});
  add("the same, projected", held, hoop_end, RungeKutta4{.step = hoop_step});
  add("Gauss collocation 6, h 1e-2, 10^6 steps", hoop, hoop_end, GaussCollocation<3>{.step = hoop_step});
  add("Taylor compensated 1e-15, 10^4 s", hoop, time, sharp(1e-15, Taylor{.compensated = true}));
  add("the same, projected", held, time, sharp(1e-15, Taylor{.compensated = true}));
  add("Dormand-Prince 8(5,3) 1e-12, 10^4 s", hoop, time, sharp<DormandPrince853>(1e-12));
  add("the same, projected", held, time, sharp<DormandPrince853>(1e-12));
  fmt::print("\nrolling hoop: largest relative change of the energy, largest rate of the contact [m/s]\n");
  print("slip, a tenth, all", rolling);

  std::vector<Change> closed;
  const auto squeezer = unprojected_motion<Squeezer>();
  const auto closing = equations_of_motion<Squeezer>();
  const double short_step = 5e-8, squeezer_end = short_step * static_cast<double>(million);
  const auto add_closed = [&](std::string name, const auto& motion, const auto& method) {
    closed.push_back(change_of("squeezer", std::move(name), motion, squeezer_end, method));
  };
  add_closed("Runge-Kutta 4, h 5e-8, 10^6 steps", squeezer, RungeKutta4{.step = short_step});
  add_closed("the same, projected", closing, RungeKutta4{.step = short_step});
  add_closed("Dormand-Prince 8(5,3) 1e-12, 0.05 s", squeezer, sharp<DormandPrince853>(1e-12));
  add_closed("the same, projected", closing, sharp<DormandPrince853>(1e-12));
  fmt::print(
      "\nAndrews' squeezing mechanism: largest relative change of the energy less the motor's work, largest gap of "
      "its loops [m]\n");
  print("gap, a tenth, all", closed);

  if (folder.empty()) return;
  changes.insert(changes.end(), rolling.begin(), rolling.end());
  changes.insert(changes.end(), closed.begin(), closed.end());
  std::string text = "motion,integrator,energy_of_a_tenth,energy,other_of_a_tenth,other,steps,seconds\n";
  for (const Change& change : changes) {
    std::string method = change.method;
    std::erase(method, ',');
    text += fmt::format("{},{},{:.3e},{:.3e},{:.3e},{:.3e},{},{:.3f}\n", change.motion, method, change.energy[0],
                        change.energy[1], change.other[0], change.other[1], change.result.statistics.accepted,
                        change.seconds);
  }
  write_file(folder / "invariants.csv", text);
}

}  // namespace work_precision
