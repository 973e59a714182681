// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/identifier.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "torsor/generator/base/article.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/mechanics/library_names.hpp"

namespace torsor {
namespace {

/// Of C++20, and of C99.
constexpr std::string_view keywords =
    " alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class "
    "co_await "
    "co_return co_yield compl concept const const_cast consteval constexpr constinit continue decltype default delete "
    "do "
    "double dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable "
    "namespace new noexcept not not_eq nullptr operator or or_eq private protected public register reinterpret_cast "
    "requires restrict return short signed sizeof static static_assert static_cast struct switch template this thread_local "
    "throw "
    "true try typedef typeid typename typeof union unsigned using virtual void volatile wchar_t while xor xor_eq ";

/// Macros that <cmath> and <array> bring along with some library (glibc, musl, libc++, mingw), or that the header defines
/// or looks at itself; see could_be_macro for families of them.
constexpr std::string_view macros =
    " NULL NAN SNAN INFINITY HUGE_VAL EOF RAND_MAX BYTE_ORDER MAXFLOAT MB_CUR_MAX MB_LEN_MAX NFDBITS DOMAIN SING OVERFLOW UNDERFLOW PLOSS "
    "TLOSS WCONTINUED WEXITED WEXITSTATUS WCOREDUMP WIFCONTINUED WIFEXITED WIFSIGNALED WIFSTOPPED WNOHANG WNOWAIT WSTOPPED "
    "WSTOPSIG WTERMSIG WUNTRACED alloca linux unix i386 errno assert offsetof stdin stdout stderr math_errhandling "
    "isgreater isgreaterequal isless islessequal islessgreater isunordered isfinite isinf isnan isnormal issubnormal iszero "
    "iscanonical issignaling iseqsig fpclassify signbit strdupa strndupa minor major makedev "
    "TORSOR_C_SUPPORT TORSOR_SINGLE TORSOR_LIBM TORSOR_NUMBER TORSOR_FUNCTION TORSOR_UNUSED "
    "TORSOR_C_FUNCTIONS TORSOR_VECTORS TORSOR_FLATTENED TORSOR_VECTOR_BYTES TORSOR_EACH_LANE TORSOR_LOAD TORSOR_STORE "
    "TORSOR_ADD TORSOR_SUPPORT_FINGERPRINT TORSOR_SELECTION_SUPPORT TORSOR_JET_SUPPORT "
    "TORSOR_DEVICE TORSOR_KERNEL_SUPPORT TORSOR_STD_SINCOS TORSOR_INLINED TORSOR_OUTLINED TORSOR_VECTOR_TYPES ";

constexpr std::string_view types =
    " Scalar Mechanism Parameters Precomputed Coordinates Velocities Accelerations GeneralizedForces Inputs "
    "Multipliers "
    "State size ";

/// Namespaces of others, which the scene's would open again.
constexpr std::string_view namespaces = " std torsor Eigen main ";

bool contains(std::string_view list, const std::string& name) {
  return list.find(" " + name + " ") != std::string_view::npos;
}

template <std::size_t count>
bool begins_with_one_of(std::string_view name, const std::array<std::string_view, count>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(), [name](std::string_view each) {
    return name.size() > each.size() && name.substr(0, each.size()) == each;
  });
}

template <std::size_t count>
bool ends_with_one_of(std::string_view name, const std::array<std::string_view, count>& ends) {
  return std::any_of(ends.begin(), ends.end(), [name](std::string_view each) {
    return name.size() > each.size() && name.substr(name.size() - each.size()) == each;
  });
}

/// M_PI, M_SQRT1_2f32x: a mathematical constant of <math.h>, for any type.
bool is_mathematical_constant(std::string_view name) {
  if (name.substr(0, 2) != "M_") return false;
  constexpr std::string_view constants =
      " E EGAMMA LOG2E LOG10E LN2 LN10 PHI PI PI_2 PI_4 1_PI 1_SQRT3 1_SQRTPI 2_PI 2_SQRTPI SQRT1_2 SQRT2 SQRT3 TWOPI 3PI_4 "
      "SQRTPI SQRT_PI LN2LO LN2HI IVLN10 LOG2_E INVLN2 ";
  name.remove_prefix(2);
  for (std::size_t size = name.size(); size > 0; --size) {
    const std::string_view type = name.substr(size);
    const bool of_type = type.empty() || type[0] == 'f' || type[0] == 'F' || type == "l" || type == "L" || type[0] == 'd';
    if (of_type && contains(constants, std::string(name.substr(0, size)))) return true;
  }
  return false;
}

/// A macro of a standard header, or of a family that standards keep for them.
bool could_be_macro(const std::string& name) {
  static constexpr std::array<std::string_view, 8> families{"FP_",      "FE_",  "FD_",  "MATH_",
                                                            "HUGE_VAL", "SNAN", "DEC_", "EXIT_"};
  static constexpr std::array<std::string_view, 3> ends{"_ENDIAN", "toh", "_HAS_SUBNORM"};
  static constexpr std::array<std::string_view, 2> byte_orders{"htobe", "htole"};
  static constexpr std::array<std::string_view, 20> kinds_of_numbers{
      "INT", "UINT", "CHAR", "SCHAR", "UCHAR", "SHRT", "USHRT", "LONG", "ULONG", "LLONG", "ULLONG", "PTRDIFF", "SIZE",
      "SSIZE", "WCHAR", "WINT", "SIG_ATOMIC", "FLT", "DBL", "LDBL"};
  static constexpr std::array<std::string_view, 14> limits{"_MAX", "_MIN", "_WIDTH", "_BIT", "_DIG", "_EPSILON", "_RADIX",
                                                           "_MANT_DIG", "_MAX_EXP", "_MIN_EXP", "_MAX_10_EXP",
                                                           "_MIN_10_EXP", "_C", "_TRUE_MIN"};
  if (contains(macros, name) || is_library_macro(name) || is_mathematical_constant(name)) return true;
  if (begins_with_one_of(name, families) || begins_with_one_of(name, byte_orders) || ends_with_one_of(name, ends)) return true;
  return begins_with_one_of(name, kinds_of_numbers) && ends_with_one_of(name, limits);
}

}  // namespace

void require_identifier(const std::string& name, const std::string& what) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const bool well_formed = !name.empty() && std::all_of(name.begin(), name.end(), is_word) &&
                           std::isdigit(static_cast<unsigned char>(name[0])) == 0 && name[0] != '_' && name.back() != '_';
  if (!well_formed || contains(keywords, name) ||
      name.find("__") != std::string::npos || name == "size") {
    throw SceneError(fmt::format("the name '{}' of {} cannot be a name in generated code: use letters, digits and "
                                 "single underscores inside, a letter first, and no C++ keyword",
                                 name, with_article(what)));
  }
}

const char* reserved_in_headers(const std::string& name, bool names_scene) {
  if (names_scene && contains(namespaces, name)) return "is a namespace of a library";
  if (names_scene && is_global_library_name(name)) return "belongs to the C library";
  if (contains(types, name)) return "is used by the header itself";
  if (could_be_macro(name)) return "is or may be a macro of the standard library";
  if (contains(keywords, name)) return "is a C++ keyword";
  return nullptr;
}

}  // namespace torsor
