// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled several times: VARIANT names the set of options. The namespace is renamed for each, so that no linker takes
// one set's functions for another's.
#define torsor VARIANT_NAMESPACE
#include "generated/double_pendulum.hpp"
#undef torsor
#include "tests/sincos/variant.hpp"

namespace {

template <class Scalar>
void one(Scalar angle, Scalar& sine, Scalar& cosine) {
  VARIANT_NAMESPACE::scalar_traits<Scalar>::sincos(angle, sine, cosine);
}

template <int N, class Scalar>
void several(const Scalar* angles, Scalar* sines, Scalar* cosines) {
  Scalar x[N], s[N], c[N];
  for (int i = 0; i < N; ++i) x[i] = angles[i];
  VARIANT_NAMESPACE::sines_and_cosines(x, s, c);
  for (int i = 0; i < N; ++i) sines[i] = s[i], cosines[i] = c[i];
}

/// By registers that are full, and by some with idle lanes.
template <class Scalar>
void eight(const Scalar* angles, Scalar* sines, Scalar* cosines) {
  several<8>(angles, sines, cosines);
}
template <class Scalar>
void five_and_three(const Scalar* angles, Scalar* sines, Scalar* cosines) {
  several<5>(angles, sines, cosines);
  several<3>(angles + 5, sines + 5, cosines + 5);
}

}  // namespace

const Variant VARIANT{VARIANT_NAME,  one<double>,           one<float>, eight<double>,
                      eight<float>, five_and_three<double>, five_and_three<float>};
