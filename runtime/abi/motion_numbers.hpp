// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "torsor/runtime/abi.h"
#include "torsor/runtime/batch/parallel.hpp"
#include "torsor/runtime/mechanism_model.hpp"

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

/// Number `row` of a motion.
[[nodiscard]] inline double number_of(const torsor_view& view, std::size_t motion, std::size_t row) noexcept {
  if (view.data == nullptr) return 0.0;
  double value;
  std::memcpy(&value,
              static_cast<const char*>(view.data) + static_cast<std::ptrdiff_t>(motion) * view.state +
                  static_cast<std::ptrdiff_t>(row) * view.row,
              sizeof(value));
  return value;
}

template <MechanismModel M>
[[nodiscard]] StateVector<M> start_of(const torsor_motion& call, std::size_t motion) noexcept {
  StateVector<M> y;
  for (std::size_t k = 0; k < y.size(); ++k) y[k] = number_of(call.start, motion, k);
  return y;
}

template <MechanismModel M>
[[nodiscard]] GivenInputs<M> inputs_of(const torsor_motion& call, std::size_t motion) noexcept {
  GivenInputs<M> inputs;
  inputs.law = call.law;
  inputs.context = call.context;
  if constexpr (M::input_count > 0) {
    for (int k = 0; k < M::input_count; ++k) {
      inputs.held[k] = number_of(call.inputs, motion, static_cast<std::size_t>(k));
    }
  }
  return inputs;
}

/// The state of a motion at the time of this row.
template <std::size_t n>
void write_state(const torsor_motion& call, std::size_t motion, std::size_t row, const std::array<double, n>& y) noexcept {
  char* const data = static_cast<char*>(call.states.data) + static_cast<std::ptrdiff_t>(motion) * call.states.state +
                     static_cast<std::ptrdiff_t>(row) * call.states.row;
  for (std::size_t k = 0; k < n; ++k) {
    std::memcpy(data + static_cast<std::ptrdiff_t>(k) * call.states.column, &y[k], sizeof(double));
  }
}

/// What a motion did not reach, from this row on, is not a number.
template <MechanismModel M>
void write_nothing(const torsor_motion& call, std::size_t motion, std::size_t row) noexcept {
  StateVector<M> nothing;
  nothing.fill(std::numeric_limits<double>::quiet_NaN());
  for (; row < call.time_count; ++row) write_state(call, motion, row, nothing);
}

template <class Method>
[[nodiscard]] Method with_limit(const torsor_motion& call, Method method) noexcept {
  if (call.step_limit != 0) method.step_limit = call.step_limit;
  return method;
}

/// A method with the tolerances and steps of the call.
template <class Method>
[[nodiscard]] Method adaptive(const torsor_motion& call, Method method) noexcept {
  method.relative_tolerance = call.relative_tolerance;
  method.absolute_tolerance = call.absolute_tolerance;
  method.first_step = call.first_step;
  method.largest_step = call.largest_step;
  return with_limit(call, method);
}

/// Moves each by `move`, which gives its status and does not throw; how many did not reach the last time.
template <class Move>
std::int64_t move_all(const torsor_motion& call, const Move& move) {
  constexpr unsigned max_parts = 256;
  if (call.start.data == nullptr || (call.times == nullptr && call.time_count > 0) || call.states.data == nullptr) {
    return torsor_call_without_argument;
  }
  const unsigned parts = std::min<unsigned>(thread_count(call.threads), max_parts);
  std::array<std::int64_t, max_parts> failed{};
  in_parts(call.motions, parts, [&](std::size_t part, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) failed[part] += move(i) == torsor_motion_reached_end ? 0 : 1;
  });
  std::int64_t total = 0;
  for (const std::int64_t each : failed) total += each;
  return total;
}

}  // namespace torsor::runtime::abi
