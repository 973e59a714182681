// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <tuple>
#include <type_traits>
#include <utility>

#include "torsor/runtime/abi.h"
#include "torsor/runtime/mechanism_model.hpp"

namespace torsor::runtime::abi {

/// Scalars of a structure of generated text, which holds nothing else.
template <class Structure, class Scalar>
inline constexpr std::size_t scalars_in = std::is_empty_v<Structure> ? 0 : sizeof(Structure) / sizeof(Scalar);

/// What kernels read, for one state or for the states of a pack.
template <class M>
struct Operands {
  typename M::State state;
  typename M::Accelerations accelerations;
  typename M::Multipliers multipliers;
  typename M::Inputs inputs;
  int order;
};

/// A kernel whose arguments are forgotten: what a table can hold. `call` gives what the kernel says as a number.
template <class M>
struct AnyKernel {
  using Forgotten = void (*)();
  Forgotten function = nullptr;
  int (*call)(Forgotten, const typename M::Precomputed&, const Operands<M>&, std::byte* results) noexcept = nullptr;
  std::size_t scalars = 0;            ///< written at each call
  std::size_t scalars_of_orders = 0;  ///< further ones, for each order
};

/// How one argument of a kernel is found again.
template <class M, class Argument>
struct Operand {
  using Value = std::remove_cvref_t<Argument>;
  static constexpr bool is_result =
      std::is_lvalue_reference_v<Argument> && !std::is_const_v<std::remove_reference_t<Argument>>;
  static constexpr std::size_t scalars = is_result ? scalars_in<Value, ScalarOf<M>> : 0;
  static constexpr std::size_t scalars_of_orders = 0;

  static Argument in(const Operands<M>& operands, [[maybe_unused]] std::byte* results) noexcept {
    if constexpr (is_result) {
      return *std::launder(reinterpret_cast<Value*>(results));
    } else if constexpr (std::is_same_v<Value, typename M::Accelerations>) {
      return operands.accelerations;
    } else if constexpr (std::is_same_v<Value, typename M::Multipliers>) {
      return operands.multipliers;
    } else if constexpr (std::is_same_v<Value, typename M::Inputs>) {
      return operands.inputs;
    } else {
      static_assert(std::is_same_v<Argument, int>, "an argument that the table does not know");
      return operands.order;
    }
  }
};
template <class M, class Scalar, std::size_t count>
struct Operand<M, std::array<Scalar, count>*> {
  static constexpr std::size_t scalars = 0, scalars_of_orders = count;
  static std::array<Scalar, count>* in(const Operands<M>&, std::byte* results) noexcept {
    return std::launder(reinterpret_cast<std::array<Scalar, count>*>(results));
  }
};

/// Where the result behind `argument` others begins, in bytes.
template <class M, class... Arguments>
[[nodiscard]] constexpr std::size_t place_of_result(std::size_t argument) noexcept {
  constexpr std::array<std::size_t, sizeof...(Arguments) + 1> sizes{Operand<M, Arguments>::scalars..., 0};
  std::size_t before = 0;
  for (std::size_t i = 0; i < argument; ++i) before += sizes[i];
  return before * sizeof(ScalarOf<M>);
}

/// Results lie one after the other, in the order of the arguments.
template <class M, class Code, class... Arguments>
[[nodiscard]] AnyKernel<M> any_kernel(Code (*kernel)(const typename M::Precomputed&, const typename M::State&,
                                                     Arguments...) noexcept) noexcept {
  using Function = decltype(kernel);
  AnyKernel<M> any;
  any.function = reinterpret_cast<typename AnyKernel<M>::Forgotten>(kernel);
  any.call = [](typename AnyKernel<M>::Forgotten function, const typename M::Precomputed& precomputed,
                const Operands<M>& operands, [[maybe_unused]] std::byte* results) noexcept {
    return [&]<std::size_t... i>(std::index_sequence<i...>) noexcept {
      const auto typed = reinterpret_cast<Function>(function);
      if constexpr (std::is_void_v<Code>) {
        typed(precomputed, operands.state,
              Operand<M, Arguments>::in(operands, results + place_of_result<M, Arguments...>(i))...);
        return 0;
      } else {
        return static_cast<int>(
            typed(precomputed, operands.state,
                  Operand<M, Arguments>::in(operands, results + place_of_result<M, Arguments...>(i))...));
      }
    }
    (std::index_sequence_for<Arguments...>{});
  };
  any.scalars = (std::size_t{0} + ... + Operand<M, Arguments>::scalars);
  any.scalars_of_orders = (std::size_t{0} + ... + Operand<M, Arguments>::scalars_of_orders);
  return any;
}

/// y' of y = [q; v]: what every method for ordinary differential equations asks for.
template <HasForwardDynamics M>
[[nodiscard]] auto state_derivative(const typename M::Precomputed& precomputed, const typename M::State& state,
                                    const typename M::Inputs& inputs, StateVector<M>& derivative) noexcept {
  typename M::Accelerations a{};
  typename M::Multipliers lambda{};
  const auto status = M::forward_dynamics(precomputed, state, inputs, a, lambda);
  write_coordinate_rates<M>(precomputed, state, derivative);
  for (std::size_t i = 0; i < velocities_of<M>; ++i) derivative[coordinates_of<M> + i] = a[static_cast<int>(i)];
  return status;
}

/// Memory for one call: on the stack as far as it goes.
class Scratch {
 public:
  /// Null: there is none.
  [[nodiscard]] std::byte* of(std::size_t bytes) noexcept {
    if (bytes <= sizeof(near_)) return near_;
    far_.reset(static_cast<std::byte*>(::operator new(bytes, alignment, std::nothrow)));
    return far_.get();
  }

 private:
  static constexpr std::align_val_t alignment{64};
  struct Free {
    void operator()(std::byte* memory) const noexcept { ::operator delete(memory, alignment); }
  };
  alignas(64) std::byte near_[16384];
  std::unique_ptr<std::byte, Free> far_;
};

}  // namespace torsor::runtime::abi
