// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <type_traits>

#include "torsor/generator/verification/kernel_text.hpp"
#include "torsor/generator/verification/running_error.hpp"

namespace torsor::testing_rounding {

/// What a text states in the header's scalar, double or float.
template <class Float>
NumbersOf<Running<Float>> running_numbers() {
  using Scalar = Running<Float>;
  const auto literal = [](const RoundedConstant& constant) {
    return Scalar::rounded_literal(std::is_same_v<Float, float> ? constant.in_float : static_cast<Float>(constant.in_double));
  };
  return {[](const Number& number) { return Scalar::of_number(number); }, literal,
          Scalar::rounded_literal(static_cast<Float>(std::numbers::pi))};
}

}  // namespace torsor::testing_rounding
