// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/emitted_sincos.hpp"

#include <cmath>

// Under another name, so that no linker takes these functions for those of a generated header in the same program,
// which may be compiled with other options.
#define TORSOR_DEVICE
#define torsor torsor_emitted
#include "templates/sincos.hpp"

namespace torsor {
template <>
struct scalar_traits<double> {
  static constexpr double constant(double in_double, float, const char*) noexcept { return in_double; }
};
template <>
struct scalar_traits<float> {
  static constexpr float constant(double, float in_float, const char*) noexcept { return in_float; }
};
}  // namespace torsor
#undef torsor
#undef TORSOR_DEVICE

namespace torsor {

void emitted_sincos(double angle, double& sine, double& cosine) {
  torsor_emitted::sincos_of_one(angle, sine, cosine);
}
void emitted_sincos(float angle, float& sine, float& cosine) { torsor_emitted::sincos_of_one(angle, sine, cosine); }

}  // namespace torsor
