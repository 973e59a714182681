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

template <class Scalar>
void eight(const Scalar* angles, Scalar* sines, Scalar* cosines) {
  Scalar x[8], s[8], c[8];
  for (int i = 0; i < 8; ++i) x[i] = angles[i];
  VARIANT_NAMESPACE::sines_and_cosines(x, s, c);
  for (int i = 0; i < 8; ++i) sines[i] = s[i], cosines[i] = c[i];
}

}  // namespace

const Variant VARIANT{VARIANT_NAME, one<double>, one<float>, eight<double>, eight<float>};
