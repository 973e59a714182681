// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled several times: VARIANT names the set of options. The namespace is renamed for each, so that no linker takes
// one set's functions for another's.
#define torsor VARIANT_NAMESPACE
#define heavy_top VARIANT_MECHANISM
#include "generated/heavy_top.hpp"
#include "torsor/runtime/batch/simd.hpp"
#undef torsor
#include "tests/batch/variant.hpp"

namespace {

using VARIANT_NAMESPACE::runtime::native_lanes;
using VARIANT_NAMESPACE::runtime::Simd;

template <class Number>
constexpr int lanes_of = 1;
template <class Number, int lanes>
constexpr int lanes_of<Simd<Number, lanes>> = lanes;

template <class Number>
Number lane(const Number& x, int) {
  return x;
}
template <class Number, int lanes>
Number lane(const Simd<Number, lanes>& x, int i) {
  return x[i];
}

/// The k-th scalars of consecutive rows.
template <class Scalar, class Number>
Scalar gather(const Number* rows, int stride, int k) {
  if constexpr (lanes_of<Scalar> == 1) {
    return rows[k];
  } else {
    Scalar pack;
    for (int i = 0; i < lanes_of<Scalar>; ++i) pack.set(i, rows[i * stride + k]);
    return pack;
  }
}
template <class Scalar, class Number>
void scatter(const Scalar& values, Number* rows, int stride, int k) {
  for (int i = 0; i < lanes_of<Scalar>; ++i) rows[i * stride + k] = lane(values, i);
}

template <class Scalar, class Number>
void top(const Number* states, Number* results, int* statuses) {
  using M = heavy_top::Mechanism<Scalar>;
  const auto precomputed = M::precompute(M::default_parameters());
  for (int first = 0; first < state_count; first += lanes_of<Scalar>) {
    const Number* rows = states + first * state_entries;
    typename M::State state;
    state.time = gather<Scalar>(rows, state_entries, 0);
    for (int i = 0; i < 3; ++i) state.q[i] = gather<Scalar>(rows, state_entries, 1 + i);
    for (int i = 0; i < 3; ++i) state.v[i] = gather<Scalar>(rows, state_entries, 4 + i);
    typename M::Accelerations a;
    typename M::Energy energy;
    typename M::GeneralizedForces forces;
    typename M::Multipliers none;
    const auto status = M::forward_dynamics(precomputed, state, {}, a, none);
    M::energy(precomputed, state, {}, energy);
    M::bias(precomputed, state, forces);
    Number* written = results + first * result_entries;
    int k = 0;
    for (int i = 0; i < 3; ++i) scatter(a[i], written, result_entries, k++);
    for (int i = 0; i < 3; ++i) scatter(energy[i], written, result_entries, k++);
    for (int i = 0; i < 3; ++i) scatter(forces[i], written, result_entries, k++);
    for (int i = 0; i < lanes_of<Scalar>; ++i) statuses[first + i] = static_cast<int>(status);
  }
}

template <class Scalar, class Number>
void sincos(const Number* angles, Number* sines, Number* cosines) {
  constexpr int lanes = lanes_of<Scalar>, together = 3;
  int next = 0;
  for (; next + together * lanes <= state_count; next += together * lanes) {
    Scalar x[together], s[together], c[together];
    for (int k = 0; k < together; ++k) x[k] = gather<Scalar>(angles + next + k * lanes, 1, 0);
    VARIANT_NAMESPACE::sines_and_cosines(x, s, c);
    for (int k = 0; k < together; ++k) {
      scatter(s[k], sines + next + k * lanes, 1, 0);
      scatter(c[k], cosines + next + k * lanes, 1, 0);
    }
  }
  for (; next < state_count; next += lanes) {
    Scalar s, c;
    VARIANT_NAMESPACE::scalar_traits<Scalar>::sincos(gather<Scalar>(angles + next, 1, 0), s, c);
    scatter(s, sines + next, 1, 0);
    scatter(c, cosines + next, 1, 0);
  }
}

template <class Scalar, class Number>
void operations(const Number* xs, const Number* ys, Number* results) {
  using traits = VARIANT_NAMESPACE::scalar_traits<Scalar>;
  using std::abs;
  const Scalar yes(1), no(0);
  for (int next = 0; next < state_count; next += lanes_of<Scalar>) {
    const Scalar x = gather<Scalar>(xs + next, 1, 0), y = gather<Scalar>(ys + next, 1, 0);
    const Scalar size = abs(x);
    const Scalar row[operation_count] = {x + y,
                                         x - y,
                                         x * y,
                                         x / y,
                                         -x,
                                         size,
                                         traits::sqrt(size),
                                         traits::select(x < y, x, y),
                                         traits::exp(x),
                                         traits::log(size),
                                         traits::select(x < y, yes, no),
                                         traits::select(x <= y, yes, no),
                                         traits::select(x > y, yes, no),
                                         traits::select(x >= y, yes, no)};
    for (int k = 0; k < operation_count; ++k) scatter(row[k], results + next * operation_count, operation_count, k);
  }
}

// Constants, so that nothing compiled for another processor runs before main.
template <class Scalar, class Number>
constexpr CodePath<Number> path(const char* name) {
  return {name, lanes_of<Scalar>, top<Scalar, Number>, sincos<Scalar, Number>, operations<Scalar, Number>};
}

template <class Number>
constexpr CodePaths<Number> paths() {
  constexpr int odd = sizeof(Number) == 8 ? 3 : 5;
  return {path<Number, Number>("numbers"), path<Simd<Number, native_lanes<Number>>, Number>("packs"),
          path<Simd<Number, odd>, Number>("arrays")};
}

bool runs_here() { return VARIANT_RUNS; }

}  // namespace

extern constexpr Variant VARIANT{VARIANT_NAME, runs_here, VARIANT_FUSED, paths<double>(), paths<float>()};
