// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled for any processor here, for this one from measured_native.cpp; the namespaces keep the two apart.
#include "benchmarks/sincos/measured.hpp"

#ifndef BUILD_NAMESPACE
#define BUILD_NAMESPACE generic_build
#endif
#define torsor BUILD_NAMESPACE
#include "generated/double_pendulum.hpp"

namespace BUILD_NAMESPACE {
namespace {

template <class Scalar>
void by_library(const Scalar* x, Scalar* s, Scalar* c, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    s[i] = std::sin(x[i]);
    c[i] = std::cos(x[i]);
  }
}

template <class Scalar>
void one_by_one(const Scalar* x, Scalar* s, Scalar* c, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) scalar_traits<Scalar>::sincos(x[i], s[i], c[i]);
}

/// As a kernel calls it: angles from somewhere into an array, results out of two.
template <class Scalar, int N>
void several(const Scalar* x, Scalar* s, Scalar* c, std::size_t size) {
  for (std::size_t i = 0; i + N <= size; i += N) {
    Scalar angles[N], sines[N], cosines[N];
    for (std::size_t k = 0; k < N; ++k) angles[k] = x[i + k];
    sines_and_cosines(angles, sines, cosines);
    for (std::size_t k = 0; k < N; ++k) {
      s[i + k] = sines[k];
      c[i + k] = cosines[k];
    }
  }
}

template <class Scalar>
Ways<Scalar> ways() {
  static constexpr Way<Scalar> all[] = {
      {"std::sin, std::cos", 1, by_library<Scalar>}, {"torsor, 1", 1, one_by_one<Scalar>},
      {"torsor, 2", 2, several<Scalar, 2>},          {"torsor, 3", 3, several<Scalar, 3>},
      {"torsor, 4", 4, several<Scalar, 4>},          {"torsor, 7", 7, several<Scalar, 7>},
      {"torsor, 8", 8, several<Scalar, 8>}};
  return Ways<Scalar>(all);
}

}  // namespace

Ways<double> ways_in_double() { return ways<double>(); }
Ways<float> ways_in_float() { return ways<float>(); }

}  // namespace BUILD_NAMESPACE
