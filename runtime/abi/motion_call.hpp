// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
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
    if (!start_with_unit_quaternions<M>(y)) return ended(i, torsor_motion_zero_quaternion, reached, time);
    const auto keep = [&](double, const StateVector<M>& state) noexcept {
      write_state(call_, i, reached++, state);
    };
    const std::optional<Result<double>> result = integrated(y, time, law, keep);
    if (!result) return ended(i, torsor_motion_open_loops, reached, time);
    return ended(i, static_cast<int>(result->status), reached, result->time, result->statistics.calls);
  }

  int ended(std::size_t i, int status, std::size_t reached, double time, std::int64_t calls = 0) const noexcept {
    write_nothing<M>(call_, i, reached);
    if (call_.statuses != nullptr) call_.statuses[i] = status;
    if (call_.ends != nullptr) call_.ends[i] = time;
    if (call_.calls != nullptr) call_.calls[i] = calls;
    return status;
  }

  /// Nothing where the start cannot be put on the constraints. A start that another set of parameters has opened would
  /// otherwise be closed by the first step, by what a step of its length makes of it.
  template <class Keep>
  std::optional<Result<double>> integrated(StateVector<M>& y, double time, const GivenInputs<M>& law,
                                           const Keep& keep) const {
    if constexpr (M::multiplier_count > 0) {
      if (call_.unprojected != 0) {
        return by_method(EquationsOfMotion<M, GivenInputs<M>>(parameters_, law), y, time, keep);
      }
    }
    const MotionOfLibrary<M, GivenInputs<M>> motion(parameters_, law);
    if constexpr (requires { motion.settle(time, y); }) {
      if (motion.settle(time, y) != Evaluation::ok) return std::nullopt;
      return by_method(motion, y, time, keep);
    } else if constexpr (M::multiplier_count == 0) {
      return by_method(motion, y, time, keep);
    } else {  // kernels that hold it on its constraints are missing, and drift was not asked for
      return unsuitable(time);
    }
  }

  template <class Motion, class Keep>
  Result<double> by_method(const Motion& motion, StateVector<M>& y, double time, const Keep& keep) const {
    const std::span<const double> times(call_.times, call_.time_count);
    const auto by = [&](const auto& method) { return integrate_through(motion, y, time, times, method, keep); };
    switch (call_.method) {
      case 0:
        return by(adaptive(call_, DormandPrince54{}));
      case 1:
        return by(adaptive(call_, DormandPrince853{}));
      case 2:
        return by(fixed(RungeKutta4{}));
      case 3:
        return by(fixed(Midpoint{}));
      case 4:
        return by(adaptive(call_, RadauIia5{}));
      case 5:
        if constexpr (HasJets<M>) {
          if (call_.law == nullptr) return by(adaptive(call_, Taylor{}));
        }
        return unsuitable(time);
      default:
        return unsuitable(time);
    }
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
