// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once for each number of links: LINKS, and LINKS_HEADER.
#include LINKS_HEADER

#include <array>
#include <memory>
#include <utility>

#include "benchmarks/work_precision/links.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#ifdef BENCHMARK_SUNDIALS
#include "torsor/runtime/sundials/sundials.hpp"
#endif
#ifdef BENCHMARK_ODEINT
#include <boost/numeric/odeint.hpp>
#endif

#define LINKS_JOIN_WORDS(a, b) a##b
#define LINKS_JOIN(a, b) LINKS_JOIN_WORDS(a, b)

namespace work_precision {
namespace {

using namespace torsor::runtime;
using Mechanism = LINKS_JOIN(work_precision_links_, LINKS)::Mechanism<double>;
using Motion = EquationsOfMotion<Mechanism>;
using State = StateVector<Mechanism>;

State start() {
  State y{};
  y[0] = 0.5;
  for (std::size_t i = 1; i < LINKS; ++i) y[i] = i % 2 == 0 ? 0.02 : -0.02;
  return y;
}

template <class Method>
LinksWay ours(std::string name, const std::shared_ptr<const Motion>& motion, Method method) {
  return {std::move(name), [motion, method](double tolerance, std::vector<double>& end) {
            Method sharp = method;
            sharp.relative_tolerance = tolerance;
            sharp.absolute_tolerance = tolerance;
            State y = start();
            const auto result = integrate(*motion, y, 0.0, links_end, sharp);
            end.assign(y.begin(), y.end());
            return static_cast<bool>(result);
          }};
}

#ifdef BENCHMARK_ODEINT
template <class Make>
LinksWay odeint(std::string name, const std::shared_ptr<const Motion>& motion, Make make) {
  return {std::move(name), [motion, make](double tolerance, std::vector<double>& end) {
            State y = start();
            const auto system = [&](const State& at, State& slope, double t) { (void)(*motion)(t, at, slope); };
            try {
              boost::numeric::odeint::integrate_adaptive(make(tolerance), system, y, 0.0, links_end, 1e-3);
            } catch (const boost::numeric::odeint::odeint_error&) {
              return false;
            }
            end.assign(y.begin(), y.end());
            return true;
          }};
}
#endif

}  // namespace

Links LINKS_JOIN(links_, LINKS)() {
  const auto motion = std::make_shared<const Motion>(equations_of_motion<Mechanism>());
  Links links{LINKS, {}};
  links.ways.push_back(ours("Taylor", motion, Taylor{.compensated = true}));
  links.ways.push_back(ours("Dormand-Prince 8(5 3)", motion, DormandPrince853{}));
#ifdef BENCHMARK_ODEINT
  links.ways.push_back(odeint("Boost.odeint fehlberg78", motion, [](double s) {
    return boost::numeric::odeint::make_controlled(s, s, boost::numeric::odeint::runge_kutta_fehlberg78<State>());
  }));
  links.ways.push_back(odeint("Boost.odeint Bulirsch-Stoer", motion,
                              [](double s) { return boost::numeric::odeint::bulirsch_stoer<State>(s, s); }));
#endif
#ifdef BENCHMARK_SUNDIALS
  Cvode adams;
  adams.multistep = Cvode::Multistep::adams;
  links.ways.push_back(ours("SUNDIALS CVODE Adams", motion, adams));
#endif
  return links;
}

}  // namespace work_precision
