// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/work_precision/drift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/work_precision/processor_time.hpp"
#include "generated/double_pendulum.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/observers.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/records/file.hpp"
#include "torsor/runtime/records/plot.hpp"
#include "torsor/runtime/steps/angles_within_a_turn.hpp"

namespace work_precision {
namespace {

using namespace torsor::runtime;
using Mechanism = double_pendulum::Mechanism<double>;
constexpr double end_time = 1e4;
constexpr std::size_t samples = Drift::samples;

template <class Method>
Drift drift_of(std::string name, const Method& method) {
  const auto motion = equations_of_motion<Mechanism>();
  // The lower rod turns over a hundred times, which would take three digits off its angle.
  const auto within_a_turn = angles_within_a_turn(motion, std::array<std::size_t, 2>{0, 1});
  const auto energy = [&](const std::array<double, 4>& y) {
    Mechanism::Energy e{};
    Mechanism::energy(motion.precomputed(), unpack<Mechanism>(0.0, y), {}, e);
    return e.kinetic - e.force_function;
  };
  std::array<double, 4> y{2.0, 2.5, 0.0, 0.0};
  const double first = energy(y);
  Drift drift;
  drift.name = std::move(name);
  const auto watch = [&](double t, const std::array<double, 4>& state) noexcept {
    const auto sample = static_cast<std::size_t>(t / end_time * samples);
    double& largest = drift.largest[std::min(sample, samples - 1)];
    largest = std::max(largest, std::abs((energy(state) - first) / first));
  };
  Every observer(10, watch);  // so that the energy itself costs little
  const double start = processor_seconds();
  drift.result = integrate(within_a_turn, y, 0.0, end_time, method, observer);
  drift.seconds = processor_seconds() - start;
  for (std::size_t i = 1; i < samples; ++i) drift.largest[i] = std::max(drift.largest[i], drift.largest[i - 1]);
  return drift;
}

template <class Method>
Drift at_tolerance(std::string name, double tolerance, Method method) {
  method.relative_tolerance = tolerance;
  method.absolute_tolerance = tolerance;
  method.step_limit = 1'000'000'000;
  return drift_of(fmt::format("{} {:.0e}", name, tolerance), method);
}

}  // namespace

std::vector<Drift> measure_drift(const std::filesystem::path& folder) {
  std::vector<Drift> drifts;
  drifts.push_back(at_tolerance("Taylor compensated", 1e-15, Taylor{.compensated = true}));
  drifts.push_back(at_tolerance("Taylor", 1e-15, Taylor{}));
  drifts.push_back(at_tolerance("Dormand-Prince 8(5 3) compensated", 1e-15, DormandPrince853{.compensated = true}));
  drifts.push_back(at_tolerance("Dormand-Prince 8(5 3)", 1e-15, DormandPrince853{}));
  drifts.push_back(at_tolerance("Dormand-Prince 8(5 3)", 1e-13, DormandPrince853{}));
  drifts.push_back(at_tolerance("Dormand-Prince 8(5 3)", 1e-12, DormandPrince853{}));
  drifts.push_back(at_tolerance("Dormand-Prince 8(5 3)", 1e-11, DormandPrince853{}));
  drifts.push_back(at_tolerance("Dormand-Prince 5(4)", 1e-12, DormandPrince54{}));
  drifts.push_back(drift_of("Runge-Kutta 4 h 1e-3", RungeKutta4{.step = 1e-3}));
  drifts.push_back(drift_of("Gauss collocation 12 h 1e-2", GaussCollocation<6>{.step = 1e-2}));
  fmt::print("\ndouble pendulum from (2, 2.5), {:.0e} s: relative error of the energy\n{:<42}{:>12}{:>10}{:>12}\n",
             end_time, "integrator", "largest", "s", "steps");
  for (const Drift& drift : drifts) {
    fmt::print("{:<42}{:>12}{:>10.2f}{:>12}\n", drift.name,
               drift.result ? fmt::format("{:.1e}", drift.largest.back()) : "failed", drift.seconds,
               drift.result.statistics.accepted);
  }
  if (folder.empty()) return drifts;
  std::string text = "time";
  for (const Drift& drift : drifts) text += "," + drift.name;
  for (std::size_t i = 0; i < samples; ++i) {
    text += fmt::format("\n{:g}", end_time * static_cast<double>(i + 1) / samples);
    for (const Drift& drift : drifts) text += fmt::format(",{:.3e}", drift.largest[i]);
  }
  write_file(folder / "drift.csv", text + "\n");
  Plot plot{"Energy of the double pendulum from (2, 2.5)", "s", "largest relative error so far", {}, true, true};
  for (const Drift& drift : drifts) {
    // These two lie on their neighbours.
    if (drift.name == "Taylor 1e-15" || drift.name == "Dormand-Prince 8(5 3) 1e-15") continue;
    plot.curves.push_back({folder / "drift.csv", "time", drift.name, drift.name});
  }
  write_plot(plot, folder / "drift.svg");
  return drifts;
}

}  // namespace work_precision
