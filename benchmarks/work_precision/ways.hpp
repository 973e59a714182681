// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/work_precision/problem.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/integration/variational_integrator.hpp"
#include "torsor/runtime/mechanism.hpp"
#ifdef BENCHMARK_SUNDIALS
#include "torsor/runtime/sundials/sundials.hpp"
#endif
#ifdef BENCHMARK_ODEINT
#include "benchmarks/work_precision/odeint.hpp"
#endif

namespace work_precision {

/// A motion of a generated mechanism from a state to a time, and the true end as `comparable` makes it of a state.
template <class M, std::size_t count, class InputLaw = torsor::runtime::NoInputs<M>>
struct Case {
  using Motion = torsor::runtime::EquationsOfMotion<M, InputLaw>;
  using Vector = torsor::runtime::StateVector<M>;
  Vector start;
  double end_time;
  std::array<double, count> truth;
  std::array<double, count> (*comparable)(const Vector& y);
  double energy_scale;  ///< J, how far the potential energy may vary
  Motion motion{};

  [[nodiscard]] double energy(const Vector& y) const {
    if constexpr (requires { typename M::Energy; }) {
      typename M::Energy e{};
      M::energy(motion.precomputed(), torsor::runtime::unpack<M>(0.0, y), {}, e);
      return e.kinetic - e.force_function;
    } else {
      return 0.0 * y[0];
    }
  }

  [[nodiscard]] Outcome outcome(const Vector& y, bool reached, const torsor::runtime::Statistics& statistics) const {
    Outcome result{reached, 0.0, std::abs(energy(y) - energy(start)) / energy_scale, statistics};
    const auto compared = comparable(y);
    for (std::size_t i = 0; i < count; ++i) {
      const double error = std::abs(compared[i] - truth[i]);
      result.error = std::isfinite(error) ? std::max(result.error, error) : std::numeric_limits<double>::infinity();
    }
    return result;
  }
};

/// Half a decade from one to the next.
inline std::vector<double> tolerances(double first, double last) {
  std::vector<double> result;
  for (double exponent = std::log10(first); exponent > std::log10(last) - 0.25; exponent -= 0.5)
    result.push_back(std::pow(10.0, exponent));
  return result;
}

inline std::vector<double> steps(double longest, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(longest * std::pow(2.0, -i));
  return result;
}

/// A way of our own interface; `make(setting)` gives the method.
template <class C, class Make>
Way way(const std::shared_ptr<const C>& shared, std::string library, std::string name, bool fixed_step,
        std::vector<double> settings, Make make) {
  return {std::move(library), std::move(name), fixed_step, std::move(settings), [shared, make](double setting) {
            auto y = shared->start;
            const auto result = torsor::runtime::integrate(shared->motion, y, 0.0, shared->end_time, make(setting));
            return shared->outcome(y, static_cast<bool>(result), result.statistics);
          }};
}

/// The method with the tolerance as relative and absolute one.
template <class Method>
Method of_tolerance(double tolerance, Method method = {}) {
  method.relative_tolerance = tolerance;
  method.absolute_tolerance = tolerance;
  return method;
}

template <class M, std::size_t count, class InputLaw>
std::vector<Way> all_ways(const Case<M, count, InputLaw>& problem) {
  using namespace torsor::runtime;
  using Motion = typename Case<M, count, InputLaw>::Motion;
  const auto shared = std::make_shared<const Case<M, count, InputLaw>>(problem);
  const std::vector<double> all = tolerances(1e-3, 1e-15);
  std::vector<Way> ways;
  if constexpr (HasTaylorCoefficients<const Motion, double, std::tuple_size_v<StateVector<M>>>) {
    ways.push_back(way(shared, "torsor", "Taylor", false, all, [](double s) { return of_tolerance<Taylor>(s); }));
    ways.push_back(way(shared, "torsor", "Taylor compensated", false, all,
                       [](double s) { return of_tolerance(s, Taylor{.compensated = true}); }));
  }
  ways.push_back(way(shared, "torsor", "Dormand-Prince 8(5,3)", false, all,
                     [](double s) { return of_tolerance<DormandPrince853>(s); }));
  ways.push_back(way(shared, "torsor", "Dormand-Prince 5(4)", false, all,
                     [](double s) { return of_tolerance<DormandPrince54>(s); }));
  ways.push_back(way(shared, "torsor", "Radau IIA 5", false, tolerances(1e-3, 1e-13),
                     [](double s) { return of_tolerance<RadauIia5>(s); }));
  ways.push_back(
      way(shared, "torsor", "Runge-Kutta 4", true, steps(0.1, 11), [](double s) { return RungeKutta4{.step = s}; }));
  ways.push_back(way(shared, "torsor", "midpoint", true, steps(0.1, 11), [](double s) { return Midpoint{.step = s}; }));
  ways.push_back(way(shared, "torsor", "Gauss collocation 6", true, steps(0.1, 8),
                     [](double s) { return GaussCollocation<3>{.step = s}; }));
  ways.push_back(way(shared, "torsor", "Gauss collocation 12", true, steps(0.2, 6),
                     [](double s) { return GaussCollocation<6>{.step = s}; }));
  if constexpr (HasLagrangian<const Motion>) {
    ways.push_back(way(shared, "torsor", "variational 6", true, steps(0.1, 8),
                       [](double s) { return VariationalIntegrator<3>{.step = s}; }));
  }
#ifdef BENCHMARK_ODEINT
  for (Way& each : odeint_ways(shared, all)) ways.push_back(std::move(each));
#endif
#ifdef BENCHMARK_SUNDIALS
  ways.push_back(way(shared, "SUNDIALS", "CVODE Adams", false, all, [](double s) {
    Cvode method = of_tolerance<Cvode>(s);
    method.multistep = Cvode::Multistep::adams;
    return method;
  }));
  ways.push_back(way(shared, "SUNDIALS", "CVODE BDF", false, tolerances(1e-3, 1e-12),
                     [](double s) { return of_tolerance<Cvode>(s); }));
  ways.push_back(
      way(shared, "SUNDIALS", "ARKODE 5", false, all, [](double s) { return of_tolerance<ArkodeExplicit>(s); }));
  ways.push_back(way(shared, "SUNDIALS", "ARKODE 8", false, all, [](double s) {
    ArkodeExplicit method = of_tolerance<ArkodeExplicit>(s);
    method.order = 8;
    return method;
  }));
#endif
  return ways;
}

}  // namespace work_precision
