// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <type_traits>

namespace torsor::runtime {

/// A system that says by `static constexpr bool second_order = true` that y = [q; v] with q' = v, two halves of one
/// size: the implicit methods then solve for half as many unknowns. `equations_of_motion` says so by itself.
template <class S>
inline constexpr bool is_second_order = false;
template <class S>
requires requires { std::remove_cvref_t<S>::second_order; }
inline constexpr bool is_second_order<S> = std::remove_cvref_t<S>::second_order;

}  // namespace torsor::runtime
