// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "torsor/runtime/abi.h"
#include "torsor/runtime/abi/motion_numbers.hpp"
#include "torsor/runtime/abi/motion_type.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"

namespace torsor::runtime::abi {

template <HasForwardDynamics M>
class MotionCall {
 public:
  MotionCall(const typename M::Parameters& parameters, const torsor_motion& call) noexcept
      : parameters_(parameters), call_(call) {}

  std::int64_t operator()() const {
    return move_all(call_, [this](std::size_t i) { return motion(i); });
  }

 private:
  int motion(std::size_t i) const {
    StateVector<M> y = start_of<M>(call_, i);
    const double time = number_of(call_.time, i, 0);
    const GivenInputs<M> law = inputs_of<M>(call_, i);
    std::size_t reached = 0;
    const auto keep = [&](double, const StateVector<M>& state) noexcept {
      write_state(call_, i, reached++, state);
    };
    Result<double> result;
    result.time = time;
    const bool closed = integrated(y, time, law, keep, result);
    write_nothing<M>(call_, i, reached);
    const int status = closed ? static_cast<int>(result.status) : static_cast<int>(torsor_motion_open_loops);
    if (call_.statuses != nullptr) call_.statuses[i] = status;
    if (call_.ends != nullptr) call_.ends[i] = result.time;
    if (call_.calls != nullptr) call_.calls[i] = result.statistics.calls;
    return status;
  }

  /// False where the start cannot be put on the constraints. A start that another set of parameters has opened would
  /// otherwise be closed by the first step, by what a step of its length makes of it.
  template <class Keep>
  bool integrated(StateVector<M>& y, double time, const GivenInputs<M>& law, const Keep& keep,
                  Result<double>& result) const {
    if constexpr (M::multiplier_count > 0) {
      if (call_.unprojected != 0) {
        result = by_method(EquationsOfMotion<M, GivenInputs<M>>(parameters_, law), y, time, keep);
        return true;
      }
    }
    const MotionOfLibrary<M, GivenInputs<M>> motion(parameters_, law);
    if constexpr (requires { motion.settle(time, y); }) {
      if (motion.settle(time, y) != Evaluation::ok) return false;
      result = by_method(motion, y, time, keep);
    } else if constexpr (M::multiplier_count == 0) {
      result = by_method(motion, y, time, keep);
    } else {  // kernels that hold it on its constraints are missing, and drift was not asked for
      result = unsuitable(time);
    }
    return true;
  }

  template <class Motion, class Keep>
  Result<double> by_method(const Motion& motion, StateVector<M>& y, double time, const Keep& keep) const {
    switch (call_.method) {
      case 0:
        return through(motion, y, time, adaptive(call_, DormandPrince54{}), keep);
      case 1:
        return through(motion, y, time, adaptive(call_, DormandPrince853{}), keep);
      case 2:
        return through(motion, y, time, fixed(RungeKutta4{}), keep);
      case 3:
        return through(motion, y, time, fixed(Midpoint{}), keep);
      case 4:
        return through(motion, y, time, adaptive(call_, RadauIia5{}), keep);
      case 5:
        if constexpr (HasJets<M>) {
          if (call_.law == nullptr) return through(motion, y, time, adaptive(call_, Taylor{}), keep);
        }
        return unsuitable(time);
      default:
        return unsuitable(time);
    }
  }

  template <class Motion, class Method, class Keep>
  Result<double> through(const Motion& motion, StateVector<M>& y, double time, const Method& method,
                         const Keep& keep) const {
    return integrate_through(motion, y, time, std::span<const double>(call_.times, call_.time_count), method, keep);
  }

  static Result<double> unsuitable(double time) noexcept {
    Result<double> result;
    result.status = IntegrationStatus::unsuitable_model;
    result.time = time;
    return result;
  }

  template <class Method>
  Method fixed(Method method) const noexcept {
    method.step = call_.step;
    return with_limit(call_, method);
  }

  const typename M::Parameters& parameters_;
  const torsor_motion& call_;
};

}  // namespace torsor::runtime::abi
