// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/identifier.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "generator/expression/error.hpp"

namespace torsor {
namespace {

constexpr std::array<std::string_view, 92> reserved{
    "alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool", "break", "case", "catch",
    "char", "char8_t", "char16_t", "char32_t", "class", "compl", "concept", "const", "consteval", "constexpr",
    "constinit", "const_cast", "continue", "co_await", "co_return", "co_yield", "decltype", "default", "delete",
    "do", "double", "dynamic_cast", "else", "enum", "explicit", "export", "extern", "false", "float", "for",
    "friend", "goto", "if", "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq",
    "nullptr", "operator", "or", "or_eq", "private", "protected", "public", "register", "reinterpret_cast",
    "requires", "return", "short", "signed", "sizeof", "static", "static_assert", "static_cast", "struct",
    "switch", "template", "this", "thread_local", "throw", "true", "try", "typedef", "typeid", "typename", "union",
    "unsigned", "using", "virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq"};

}  // namespace

void require_identifier(const std::string& name, const std::string& what) {
  const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  const bool well_formed = !name.empty() && std::all_of(name.begin(), name.end(), is_word) &&
                           std::isdigit(static_cast<unsigned char>(name[0])) == 0 && name[0] != '_' && name.back() != '_';
  if (!well_formed || std::find(reserved.begin(), reserved.end(), name) != reserved.end() ||
      name.find("__") != std::string::npos || name == "size") {
    throw SceneError(fmt::format("the name '{}' of a {} cannot be a name in generated code: use letters, digits and "
                                 "single underscores inside, a letter first, and no C++ keyword",
                                 name, what));
  }
}

}  // namespace torsor
