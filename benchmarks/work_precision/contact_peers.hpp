// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "benchmarks/work_precision/contact_motions.hpp"
#ifdef BENCHMARK_SUNDIALS
#include "torsor/runtime/sundials/sundials.hpp"
#endif
#ifdef BENCHMARK_ODEINT
#include <boost/numeric/odeint.hpp>
#endif

namespace work_precision {

#ifdef BENCHMARK_SUNDIALS
/// What CVODE and ARKODE call alike under different names.
struct RootFunctions {
  int (*watch)(void*, int count, int (*guard)(realtype, N_Vector, realtype*, void*));
  int (*set_direction)(void*, int*);
};

template <class Motion>
using Workplace = torsor::runtime::SundialsWorkplace<const Motion, std::tuple_size_v<typename Motion::State>>;

/// SUNDIALS' own location of a root that a guard falls through; after it the integrator starts again.
template <class Motion, class Base>
class WithRoot : public Base {
 public:
  using State = typename Motion::State;
  using Base::Base;

  [[nodiscard]] bool create(const State& y, const RootFunctions& functions) {
    int falling = -1;
    return Base::create(0.0, y) && this->stop_at(contact_end) == 0 &&
           functions.watch(this->memory, 1, &WithRoot::guard) == 0 &&
           functions.set_direction(this->memory, &falling) == 0;
  }

  template <class Restart>
  [[nodiscard]] bool start_again(double t, const State& y, Restart restart) {
    std::copy(y.begin(), y.end(), N_VGetArrayPointer(this->work.y));
    return restart(this->memory, t, this->work.y) == 0;
  }

 private:
  static int guard(realtype, N_Vector y, realtype* value, void*) {
    *value = Motion::guard(Workplace<Motion>::read(y));
    return 0;
  }
};

/// A motion by a method of SUNDIALS; `restart(memory, t, y)` is the package's.
template <class Motion, class Method, class Restart>
ContactEnd<Motion> by_sundials(const Method& method, const RootFunctions& functions, Restart restart) {
  using State = typename Motion::State;
  constexpr int at_root = 2;  // CV_ROOT_RETURN, ARK_ROOT_RETURN
  constexpr std::size_t size = std::tuple_size_v<State>;
  const Motion motion;
  ContactEnd<Motion> end{0.0, Motion::start};
  WithRoot<Motion, typename Method::template Solver<const Motion, size>> solver(method, motion);
  bool goes_on = solver.create(end.y, functions);
  while (goes_on && end.time < contact_end) {
    const int flag = solver.step(contact_end, end.time);
    if (flag < 0 || end.statistics.accepted >= method.step_limit) break;
    ++end.statistics.accepted;
    if (flag != at_root) continue;
    end.y = solver.work.read(solver.work.y);
    torsor::runtime::Statistics piece;
    solver.add_statistics(piece);
    end.statistics.rejected += piece.rejected;
    end.reached = !Motion::after(end.y, ++end.events);
    goes_on = !end.reached && solver.start_again(end.time, end.y, restart);
  }
  end.statistics.calls = solver.work.f.calls;
  return end;
}
#endif

#ifdef BENCHMARK_ODEINT
/// A motion by a stepper of Boost.odeint with dense output. The library has no events: as its users do, the sign of the
/// guard is looked at after each step, and a change of it is bisected on the dense output down to neighbouring times.
template <class Motion, class Stepper>
ContactEnd<Motion> by_odeint(Stepper stepper) {
  using State = typename Motion::State;
  constexpr double first_step = 1e-3;
  constexpr long long step_limit = 1'000'000;
  const Motion motion;
  ContactEnd<Motion> end{0.0, Motion::start};
  const auto system = [&](const State& y, State& slope, double t) {
    ++end.statistics.calls;
    (void)motion(t, y, slope);
  };
  stepper.initialize(end.y, 0.0, first_step);
  try {
    while (!end.reached && stepper.current_time() < contact_end && end.statistics.accepted < step_limit) {
      auto [before, beyond] = stepper.do_step(system);
      ++end.statistics.accepted;
      if (Motion::guard(stepper.current_state()) >= 0.0) continue;
      State y{};
      for (double t = (before + beyond) / 2; before < t && t < beyond; t = (before + beyond) / 2) {
        stepper.calc_state(t, y);
        (Motion::guard(y) >= 0.0 ? before : beyond) = t;
      }
      stepper.calc_state(beyond, end.y);
      end.time = beyond;
      end.reached = !Motion::after(end.y, ++end.events);
      stepper.initialize(end.y, beyond, first_step);
    }
  } catch (const boost::numeric::odeint::odeint_error&) {
    end.reached = false;
  }
  return end;
}
#endif

}  // namespace work_precision
