// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/identifier.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "generator/expression/error.hpp"

namespace torsor {
namespace {

constexpr std::string_view keywords =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class "
    "co_await "
    "co_return co_yield compl concept const const_cast consteval constexpr constinit continue decltype default delete "
    "do "
    "double dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable "
    "namespace new noexcept not not_eq nullptr operator or or_eq private protected public register reinterpret_cast "
    "requires return short signed sizeof static static_assert static_cast struct switch template this thread_local "
    "throw "
    "true try typedef typeid typename union unsigned using virtual void volatile wchar_t while xor xor_eq ";

constexpr std::string_view macros =
    " NULL NAN INFINITY HUGE_VAL HUGE_VALF HUGE_VALL FP_NAN FP_INFINITE FP_ZERO FP_SUBNORMAL FP_NORMAL FP_ILOGB0 "
    "FP_ILOGBNAN FP_FAST_FMA MATH_ERRNO MATH_ERREXCEPT DOMAIN SING OVERFLOW UNDERFLOW PLOSS TLOSS MAXFLOAT M_E M_LOG2E "
    "M_LOG10E M_LN2 M_LN10 M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_SQRT2 M_SQRT1_2 linux unix TORSOR_DEVICE "
    "TORSOR_KERNEL_SUPPORT TORSOR_STD_SINCOS TORSOR_INLINED TORSOR_OUTLINED TORSOR_VECTOR_TYPES ";

constexpr std::string_view types =
    " Scalar Mechanism Parameters Precomputed Coordinates Velocities Accelerations GeneralizedForces Inputs "
    "Multipliers "
    "State size ";

// A namespace cannot share its name with a function that <cmath> or <cstdlib> may declare globally.
constexpr std::string_view library =
    " std torsor main abs acos acosh asin asinh atan atan2 atanh atof atoi atol cbrt ceil copysign cos cosh div drem "
    "erf "
    "erfc exp exp2 exp10 expm1 fabs fdim finite floor fma fmax fmin fmod frexp gamma hypot ilogb index isinf isnan j0 "
    "j1 "
    "jn labs ldexp lgamma log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter pow rand random "
    "remainder "
    "remquo rint round scalb select signal signgam significand sin sincos sinh sqrt srand system tan tanh tgamma time "
    "trunc y0 y1 yn ";

bool contains(std::string_view list, const std::string& name) {
  return list.find(" " + name + " ") != std::string_view::npos;
}

}  // namespace

void require_identifier(const std::string& name, const std::string& what) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const bool well_formed = !name.empty() && std::all_of(name.begin(), name.end(), is_word) &&
                           std::isdigit(static_cast<unsigned char>(name[0])) == 0 && name[0] != '_' && name.back() != '_';
  if (!well_formed || contains(keywords, name) ||
      name.find("__") != std::string::npos || name == "size") {
    throw SceneError(fmt::format("the name '{}' of a {} cannot be a name in generated code: use letters, digits and "
                                 "single underscores inside, a letter first, and no C++ keyword",
                                 name, what));
  }
}

const char* reserved_in_headers(const std::string& name, bool names_scene) {
  if (names_scene && contains(library, name)) return "belongs to the C library";
  if (contains(types, name)) return "is used by the header itself";
  if (contains(macros, name)) return "is a macro of the standard library";
  if (contains(keywords, name)) return "is a C++ keyword";
  return nullptr;
}

}  // namespace torsor
