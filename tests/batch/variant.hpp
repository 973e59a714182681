// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// How many states one call is given: a multiple of the lanes of every pack.
constexpr int state_count = 240;

/// Results of one evaluation of a mechanism: accelerations, energies and bias of the heavy top.
constexpr int state_entries = 7;
constexpr int result_entries = 3 + 3 + 3;

/// One way to evaluate many states: a number after the other, or packs of so many lanes.
template <class Number>
struct CodePath {
  const char* name;
  int lanes;
  /// States (time, coordinates, velocities) one after the other; the same for results and the status of every state,
  /// which is that of its pack.
  void (*top)(const Number* states, Number* results, int* statuses);
  /// `state_count` angles, three at a time.
  void (*sincos)(const Number* angles, Number* sines, Number* cosines);
  /// For each pair: sum, difference, product, quotient, -x, |x|, root of |x|, the lesser, exp x, log |x|, and 1 or 0
  /// for x < y, x <= y, x > y, x >= y.
  void (*operations)(const Number* x, const Number* y, Number* results);
};
constexpr int operation_count = 14;

template <class Number>
struct CodePaths {
  CodePath<Number> one, packs, arrays;  ///< numbers; packs of a register; packs that fit none
};

/// What one set of compiler options makes.
struct Variant {
  const char* name;
  bool (*runs_here)();
  bool fused;  ///< products and sums may be fused, and then round differently from one path to the other
  CodePaths<double> in_double;
  CodePaths<float> in_float;
};

extern const Variant portable_variant;
extern const Variant avx2_variant;
extern const Variant avx512_variant;
extern const Variant fused_variant;
