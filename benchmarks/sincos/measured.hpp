// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

/// One way of making sines and cosines of a whole table, so many angles at a time.
template <class Scalar>
struct Way {
  const char* name;
  int angles;  ///< in one call
  void (*run)(const Scalar* angles, Scalar* sines, Scalar* cosines, std::size_t size);
};

/// What one set of compiler options makes: the standard library, one angle, and several at a time.
template <class Scalar>
using Ways = std::span<const Way<Scalar>>;

namespace generic_build {
Ways<double> ways_in_double();
Ways<float> ways_in_float();
}  // namespace generic_build
namespace native_build {
Ways<double> ways_in_double();
Ways<float> ways_in_float();
}  // namespace native_build
