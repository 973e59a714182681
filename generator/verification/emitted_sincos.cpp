// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/emitted_sincos.hpp"

#include <cmath>

// Under another name, so that no linker takes these functions for those of a generated header in the same program,
// which may be compiled with other options.
#define TORSOR_DEVICE
#define torsor torsor_emitted
#include "templates/sincos.hpp"
#include "templates/selections.hpp"

namespace torsor {
template <>
struct scalar_traits<double> {
  static constexpr bool is_float = false;
  static constexpr double constant(double in_double, float, const char*) noexcept { return in_double; }
  static constexpr double select(bool condition, double a, double b) noexcept { return condition ? a : b; }
};
template <>
struct scalar_traits<float> {
  static constexpr bool is_float = true;
  static constexpr float constant(double, float in_float, const char*) noexcept { return in_float; }
  static constexpr float select(bool condition, float a, float b) noexcept { return condition ? a : b; }
};
}  // namespace torsor
#undef torsor
#undef TORSOR_DEVICE

namespace torsor {

void emitted_sincos(double angle, double& sine, double& cosine) {
  torsor_emitted::sincos_of_one(angle, sine, cosine);
}
double emitted_arctangent(double y, double x) { return torsor_emitted::Selections<double>::arctangent(y, x); }
float emitted_arctangent(float y, float x) { return torsor_emitted::Selections<float>::arctangent(y, x); }

void emitted_sincos(float angle, float& sine, float& cosine) { torsor_emitted::sincos_of_one(angle, sine, cosine); }

}  // namespace torsor
