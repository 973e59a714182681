// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/cpp_names.hpp"

#include <algorithm>
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
    "TORSOR_KERNEL_SUPPORT TORSOR_STD_SINCOS TORSOR_INLINED TORSOR_OUTLINED ";

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

std::string member_name(const Symbol& symbol) { return symbol.name.substr(0, symbol.name.find('\'')); }

std::string local_name(const Program& program, Atom atom) {
  const Definition& definition = program[atom];
  if (definition.symbol) {
    const std::string name = member_name(*definition.symbol);
    switch (definition.symbol->kind) {
      case SymbolKind::pi:
        return "pi";
      case SymbolKind::time:
        return "t";
      case SymbolKind::parameter:
        return "p_" + name;
      case SymbolKind::coordinate:
        return "q_" + name;
      case SymbolKind::velocity:
        return "v_" + name;
      case SymbolKind::acceleration:
        return "a_" + name;
      case SymbolKind::input:
        return "u_" + name;
      case SymbolKind::multiplier:
        return "l_" + name;
    }
  }
  if (definition.function == Function::sin || definition.function == Function::cos) {
    const SymbolPointer& angle = program[definition.argument].symbol;  // coordinates and parameters share no name
    if (angle && (angle->kind == SymbolKind::coordinate || angle->kind == SymbolKind::parameter)) {
      return (definition.function == Function::sin ? "s_" : "c_") + angle->name;
    }
  }
  return fmt::format("z{}", atom);
}

std::string symbol_access(const Symbol& symbol, const std::string& parameters) {
  const std::string name = member_name(symbol);
  switch (symbol.kind) {
    case SymbolKind::pi:
      return "traits::pi()";
    case SymbolKind::time:
      return "state.time";
    case SymbolKind::parameter:
      return parameters + name;
    case SymbolKind::coordinate:
      return "state.q." + name;
    case SymbolKind::velocity:
      return "state.v." + name;
    case SymbolKind::acceleration:
      return "accelerations." + name;
    case SymbolKind::input:
      return "inputs." + name;
    case SymbolKind::multiplier:
      return "multipliers." + name;
  }
  return name;
}

std::string constant_name(const Number& number, std::size_t index) {
  const std::string by_index = fmt::format("k{}", index);
  if (!number.is_rational() || number.sign() < 0) return by_index;
  const std::string exact = number.to_exact();
  const std::size_t slash = exact.find('/');
  if (slash > 6 || exact.size() - slash > 7) return by_index;
  const int numerator = std::stoi(exact.substr(0, slash));
  const int denominator = std::stoi(exact.substr(slash + 1));
  int power = 1;
  for (int digits = 0; digits <= 4; ++digits, power *= 10) {
    if (power % denominator != 0) continue;
    const int scaled = numerator * (power / denominator);
    if (digits == 0) return fmt::format("n{}", numerator);
    return fmt::format("n{}_{:0{}}", scaled / power, scaled % power, digits);
  }
  if (numerator > 999 || denominator > 999) return by_index;
  return fmt::format("n{}_over_{}", numerator, denominator);
}

void require_cpp_name(const std::string& name, const std::string& what) {
  const char* reason = nullptr;
  const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (!is_word || (name[0] >= '0' && name[0] <= '9') || name[0] == '_' || name.back() == '_' ||
      name.find("__") != std::string::npos) {
    reason = "is not made of letters, digits and single inner underscores, a letter first,";
  }
  if (contains(keywords, name)) reason = "is a C++ keyword";
  if (contains(macros, name)) reason = "is a macro of the standard library";
  if (contains(types, name)) reason = "is used by the header itself";
  if (what == "scene" && contains(library, name)) reason = "belongs to the C library";
  if (reason == nullptr) return;
  throw SceneError(fmt::format("the name '{}' of a {} {} and cannot stand in a generated header: choose another name",
                               name, what, reason));
}

std::string comment_text(const std::string& text) {
  std::string safe = text;
  std::replace_if(
      safe.begin(), safe.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  std::replace(safe.begin(), safe.end(), '\\', '/');
  return safe;
}

}  // namespace torsor
