// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The sine-cosine of generated headers as one set of compiler options makes it.
struct Variant {
  const char* name;
  void (*one_double)(double angle, double& sine, double& cosine);
  void (*one_float)(float angle, float& sine, float& cosine);
  /// Eight angles, eight results: all at once, and five and three.
  void (*eight_doubles)(const double* angles, double* sines, double* cosines);
  void (*eight_floats)(const float* angles, float* sines, float* cosines);
  void (*five_and_three_doubles)(const double* angles, double* sines, double* cosines);
  void (*five_and_three_floats)(const float* angles, float* sines, float* cosines);
};

extern const Variant portable_variant;  ///< no fused multiply-add
extern const Variant fused_variant;     ///< wide vectors, fused wherever the compiler can
extern const Variant reassociated_variant;  ///< sums may be reassociated wherever the compiler is not told otherwise
extern const Variant std_variant;       ///< TORSOR_STD_SINCOS
