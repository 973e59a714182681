// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

#include "runtime/abi.h"
#include "runtime/abi/motion_type.hpp"
#include "runtime/batch/parallel.hpp"
#include "runtime/integration/dormand_prince_54.hpp"
#include "runtime/integration/dormand_prince_853.hpp"
#include "runtime/integration/integrate.hpp"
#include "runtime/integration/midpoint.hpp"
#include "runtime/integration/radau_iia_5.hpp"
#include "runtime/integration/runge_kutta_4.hpp"
#include "runtime/integration/taylor.hpp"

namespace torsor::runtime::abi {

/// In the order of the table of methods.
inline constexpr std::array<torsor_method, 6> methods{{{"dormand_prince_54", 0},
                                                       {"dormand_prince_853", 0},
                                                       {"runge_kutta_4", 1},
                                                       {"midpoint", 1},
                                                       {"radau_iia_5", 0},
                                                       {"taylor", 0}}};

/// Inputs that stay, or the caller's law. Taylor series are only asked for where they stay.
template <MechanismModel M>
struct GivenInputs {
  static constexpr bool constant_inputs = true;
  typename M::Inputs held{};
  torsor_input_law* law = nullptr;
  void* context = nullptr;

  [[nodiscard]] typename M::Inputs operator()(const typename M::State& state) const noexcept {
    if constexpr (M::input_count > 0) {
      if (law != nullptr) {
        const StateVector<M> y = pack<M>(state);
        std::array<double, static_cast<std::size_t>(M::input_count)> numbers{};
        law(context, state.time, y.data(), numbers.data());
        typename M::Inputs inputs{};
        for (int i = 0; i < M::input_count; ++i) inputs[i] = numbers[static_cast<std::size_t>(i)];
        return inputs;
      }
    }
    return held;
  }
};

template <HasForwardDynamics M>
class MotionCall {
  static constexpr std::size_t n = std::tuple_size_v<StateVector<M>>;

 public:
  MotionCall(const typename M::Parameters& parameters, const torsor_motion& call) noexcept
      : parameters_(parameters), call_(call) {}

  std::int64_t operator()() const {
    if (call_.start.data == nullptr || (call_.times == nullptr && call_.time_count > 0) ||
        call_.states.data == nullptr) {
      return torsor_call_without_argument;
    }
    const unsigned parts = std::min<unsigned>(thread_count(call_.threads), max_parts);
    std::array<std::int64_t, max_parts> failed{};
    in_parts(call_.motions, parts, [&](std::size_t part, std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) failed[part] += motion(i) == torsor_motion_reached_end ? 0 : 1;
    });
    std::int64_t total = 0;
    for (const std::int64_t each : failed) total += each;
    return total;
  }

 private:
  static double number(const torsor_view& view, std::size_t motion, std::size_t row) noexcept {
    if (view.data == nullptr) return 0.0;
    double value;
    std::memcpy(&value,
                static_cast<const char*>(view.data) + static_cast<std::ptrdiff_t>(motion) * view.state +
                    static_cast<std::ptrdiff_t>(row) * view.row,
                sizeof(value));
    return value;
  }

  int motion(std::size_t i) const {
    StateVector<M> y;
    for (std::size_t k = 0; k < n; ++k) y[k] = number(call_.start, i, k);
    const double time = number(call_.time, i, 0);
    GivenInputs<M> law;
    law.law = call_.law;
    law.context = call_.context;
    if constexpr (M::input_count > 0) {
      for (int k = 0; k < M::input_count; ++k) law.held[k] = number(call_.inputs, i, static_cast<std::size_t>(k));
    }
    std::size_t reached = 0;
    const auto keep = [&](double, const StateVector<M>& state) noexcept { write(i, reached++, state); };
    const Result<double> result = integrated(y, time, law, keep);
    StateVector<M> nothing;
    nothing.fill(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t k = reached; k < call_.time_count; ++k) write(i, k, nothing);
    const int status = static_cast<int>(result.status);
    if (call_.statuses != nullptr) call_.statuses[i] = status;
    if (call_.ends != nullptr) call_.ends[i] = result.time;
    if (call_.calls != nullptr) call_.calls[i] = result.statistics.calls;
    return status;
  }

  void write(std::size_t motion, std::size_t row, const StateVector<M>& y) const noexcept {
    char* const data = static_cast<char*>(call_.states.data) +
                       static_cast<std::ptrdiff_t>(motion) * call_.states.state +
                       static_cast<std::ptrdiff_t>(row) * call_.states.row;
    for (std::size_t k = 0; k < n; ++k) {
      std::memcpy(data + static_cast<std::ptrdiff_t>(k) * call_.states.column, &y[k], sizeof(double));
    }
  }

  template <class Keep>
  Result<double> integrated(StateVector<M>& y, double time, const GivenInputs<M>& law, const Keep& keep) const {
    if constexpr (M::multiplier_count > 0) {
      if (call_.unprojected != 0)
        return by_method(EquationsOfMotion<M, GivenInputs<M>>(parameters_, law), y, time, keep);
    }
    return by_method(MotionOfLibrary<M, GivenInputs<M>>(parameters_, law), y, time, keep);
  }

  template <class Motion, class Keep>
  Result<double> by_method(const Motion& motion, StateVector<M>& y, double time, const Keep& keep) const {
    switch (call_.method) {
      case 0:
        return through(motion, y, time, adaptive(DormandPrince54{}), keep);
      case 1:
        return through(motion, y, time, adaptive(DormandPrince853{}), keep);
      case 2:
        return through(motion, y, time, fixed(RungeKutta4{}), keep);
      case 3:
        return through(motion, y, time, fixed(Midpoint{}), keep);
      case 4:
        return through(motion, y, time, adaptive(RadauIia5{}), keep);
      case 5:
        if constexpr (HasJets<M>) {
          if (call_.law == nullptr) return through(motion, y, time, adaptive(Taylor{}), keep);
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
  Method adaptive(Method method) const noexcept {
    method.relative_tolerance = call_.relative_tolerance;
    method.absolute_tolerance = call_.absolute_tolerance;
    method.first_step = call_.first_step;
    method.largest_step = call_.largest_step;
    return fixed_limit(method);
  }
  template <class Method>
  Method fixed(Method method) const noexcept {
    method.step = call_.step;
    return fixed_limit(method);
  }
  template <class Method>
  Method fixed_limit(Method method) const noexcept {
    if (call_.step_limit > 0) method.step_limit = call_.step_limit;
    return method;
  }

  static constexpr unsigned max_parts = 256;
  const typename M::Parameters& parameters_;
  const torsor_motion& call_;
};

}  // namespace torsor::runtime::abi
