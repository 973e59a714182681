// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <boost/numeric/odeint.hpp>

#include "benchmarks/work_precision/problem.hpp"

namespace work_precision {

/// The largest number of steps: at tolerances below what rounding allows odeint would go on for ever.
inline constexpr std::int64_t odeint_step_limit = 1'000'000;

/// Boost.odeint's adaptive integration of a case with a controlled stepper, as its documentation shows it; first step
/// 1 ms. Its library counts no steps: kept ones are counted by its observer, tried ones follow from the calls.
template <class C, class Make>
Way odeint_way(const std::shared_ptr<const C>& shared, std::string name, std::vector<double> settings, Make make) {
  using Vector = typename C::Vector;
  return {"Boost.odeint", std::move(name), false, std::move(settings), [shared, make](double setting) {
            Vector y = shared->start;
            torsor::runtime::Statistics statistics;
            struct TooManySteps {};
            const auto system = [&](const Vector& at, Vector& slope, double t) {
              ++statistics.calls;
              (void)shared->motion(t, at, slope);
            };
            const auto observer = [&](const Vector&, double) {
              if (++statistics.accepted > odeint_step_limit) throw TooManySteps();
            };
            bool reached = true;
            try {
              boost::numeric::odeint::integrate_adaptive(make(setting), system, y, 0.0, shared->end_time, 1e-3,
                                                         observer);
            } catch (const boost::numeric::odeint::odeint_error&) {
              reached = false;
            } catch (const TooManySteps&) {
              reached = false;
            }
            --statistics.accepted;  // the observer is shown the start too
            return shared->outcome(y, reached, statistics);
          }};
}

template <class C>
std::vector<Way> odeint_ways(const std::shared_ptr<const C>& shared, const std::vector<double>& settings) {
  namespace odeint = boost::numeric::odeint;
  using Vector = typename C::Vector;
  std::vector<Way> ways;
  ways.push_back(odeint_way(shared, "dopri5", settings, [](double s) {
    return odeint::make_controlled(s, s, odeint::runge_kutta_dopri5<Vector>());
  }));
  ways.push_back(odeint_way(shared, "fehlberg78", settings, [](double s) {
    return odeint::make_controlled(s, s, odeint::runge_kutta_fehlberg78<Vector>());
  }));
  ways.push_back(
      odeint_way(shared, "Bulirsch-Stoer", settings, [](double s) { return odeint::bulirsch_stoer<Vector>(s, s); }));
  return ways;
}

}  // namespace work_precision
