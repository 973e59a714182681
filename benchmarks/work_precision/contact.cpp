// SPDX-License-Identifier: GPL-3.0-or-later
// Contact: a ball that bounces, and bounces until it rests, and one that slides until it rolls. Events by ours, by the
// root finding of SUNDIALS, and by hand on the dense output of Boost.odeint.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/work_precision/contact_motions.hpp"
#include "benchmarks/work_precision/contact_peers.hpp"
#include "benchmarks/work_precision/ways.hpp"
#include "torsor/runtime/integration/events.hpp"

namespace work_precision {
namespace {

using namespace torsor::runtime;

template <class Motion, class Method>
Outcome by_events(const Method& method) {
  ContactEnd<Motion> end{0.0, Motion::start};
  const auto event =
      barrier([](double, const typename Motion::State& y) noexcept { return Motion::guard(y); },
              [&](double, typename Motion::State& y) noexcept { return Motion::after(y, ++end.events); });
  const auto result = integrate_with_events(Motion(), end.y, 0.0, contact_end, method, Events(event));
  end.reached = result.status == EventStatus::stopped_at_event;
  end.time = result.time;
  end.statistics = result.integration.statistics;
  return Motion::outcome(end);
}

/// The bouncing that ends in 4.06 s after infinitely many impacts: the error of that time, relative.
template <class Method>
Outcome until_rest(const Method& method) {
  constexpr double rest = 4.0637127688715781400573;  // √(2 h/g) (1 + e)/(1 - e)
  auto y = BouncingBall::start;
  const auto floor = barrier([](double, const BouncingBall::State& at) noexcept { return BouncingBall::guard(at); },
                             [](double, BouncingBall::State& at) noexcept { (void)BouncingBall::after(at, 0); });
  const auto result = integrate_with_events(BouncingBall(), y, 0.0, contact_end, method, Events(floor));
  const double energy = y[1] * y[1] / 2 + BouncingBall::gravity * y[0];
  return {result.status == EventStatus::accumulation, std::abs(result.accumulation_time / rest - 1),
          std::abs(energy) / BouncingBall::gravity, result.integration.statistics};
}

// What fits a plain right-hand side; `run(method)` gives the outcome.
template <class Run>
std::vector<Way> our_ways(Run run) {
  const std::vector<double> all = tolerances(1e-3, 1e-13);
  std::vector<Way> ways;
  const auto add = [&](std::string name, bool fixed_step, const std::vector<double>& settings, auto make) {
    ways.push_back({"torsor", std::move(name), fixed_step, settings, [=](double s) { return run(make(s)); }});
  };
  add("Taylor", false, all, [](double s) { return of_tolerance<Taylor>(s); });
  add("Dormand-Prince 8(5,3)", false, all, [](double s) { return of_tolerance<DormandPrince853>(s); });
  add("Dormand-Prince 5(4)", false, all, [](double s) { return of_tolerance<DormandPrince54>(s); });
  add("Radau IIA 5", false, all, [](double s) { return of_tolerance<RadauIia5>(s); });
  add("Runge-Kutta 4", true, steps(0.1, 6), [](double s) { return RungeKutta4{.step = s}; });
  add("midpoint", true, steps(0.1, 6), [](double s) { return Midpoint{.step = s}; });
  add("Gauss collocation 6", true, steps(0.1, 6), [](double s) { return GaussCollocation<3>{.step = s}; });
  add("Gauss collocation 12", true, steps(0.1, 6), [](double s) { return GaussCollocation<6>{.step = s}; });
  return ways;
}

template <class Motion>
std::vector<Way> contact_ways() {
  std::vector<Way> ways = our_ways([](const auto& method) { return by_events<Motion>(method); });
  [[maybe_unused]] const auto add = [&](std::string library, std::string name, auto run) {
    ways.push_back({std::move(library), std::move(name), false, tolerances(1e-3, 1e-13),
                    [=](double s) { return Motion::outcome(run(s)); }});
  };
#ifdef BENCHMARK_ODEINT
  namespace odeint = boost::numeric::odeint;
  using State = typename Motion::State;
  add("Boost.odeint", "dopri5",
      [](double s) { return by_odeint<Motion>(odeint::make_dense_output(s, s, odeint::runge_kutta_dopri5<State>())); });
  add("Boost.odeint", "Bulirsch-Stoer",
      [](double s) { return by_odeint<Motion>(odeint::bulirsch_stoer_dense_out<State>(s, s)); });
#endif
#ifdef BENCHMARK_SUNDIALS
  const auto cvode = [](double s, Cvode::Multistep multistep) {
    Cvode method = of_tolerance<Cvode>(s);
    method.multistep = multistep;
    return by_sundials<Motion>(method, {CVodeRootInit, CVodeSetRootDirection}, CVodeReInit);
  };
  add("SUNDIALS", "CVODE Adams", [=](double s) { return cvode(s, Cvode::Multistep::adams); });
  add("SUNDIALS", "CVODE BDF", [=](double s) { return cvode(s, Cvode::Multistep::backward_differentiation); });
  const auto arkode = [](double s, int order) {
    ArkodeExplicit method = of_tolerance<ArkodeExplicit>(s);
    method.order = order;
    return by_sundials<Motion>(method, {ERKStepRootInit, ERKStepSetRootDirection},
                               [](void* memory, double t, N_Vector y) {
                                 return ERKStepReInit(memory, Workplace<Motion>::right_hand_side, t, y);
                               });
  };
  add("SUNDIALS", "ARKODE 5", [=](double s) { return arkode(s, 5); });
  add("SUNDIALS", "ARKODE 8", [=](double s) { return arkode(s, 8); });
#endif
  return ways;
}

}  // namespace

Problem bouncing() {
  return {"bouncing", "ball dropped from 1 m, restitution 0.8, to the tenth impact", contact_ways<BouncingBall>()};
}

Problem resting() {
  return {"resting", "the same ball until it rests after infinitely many impacts",
          our_ways([](const auto& method) { return until_rest(method); })};
}

Problem sliding() {
  return {"sliding", "billiard ball from 2 m/s without spin until it rolls", contact_ways<SlidingBall>()};
}

}  // namespace work_precision
