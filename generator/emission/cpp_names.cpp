// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/cpp_names.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "generator/expression/error.hpp"
#include "generator/expression/printable.hpp"
#include "generator/mechanics/identifier.hpp"

namespace torsor {

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
    const SymbolPointer& angle = program[definition.arguments[0]].symbol;  // coordinates and parameters share no name
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
  if (reason == nullptr) reason = reserved_in_headers(name, what == "scene");
  if (reason == nullptr) return;
  throw SceneError(fmt::format("the name '{}' of a {} {} and cannot stand in a generated header: choose another name",
                               name, what, reason));
}

std::string comment_text(const std::string& text) {
  const std::string visible = printable(text);
  std::string safe;
  for (std::size_t i = 0; i < visible.size(); ++i) {
    safe += visible[i];
    constexpr std::string_view ends_of_trigraphs = "=/'()!<>-";
    const bool trigraph = visible[i] == '?' && i + 2 < visible.size() && visible[i + 1] == '?' &&
                          ends_of_trigraphs.find(visible[i + 2]) != std::string_view::npos;
    if (trigraph) safe += ' ';
  }
  // A backslash at the end, blanks behind it or not, would make the next line part of the comment.
  for (std::size_t last = safe.find_last_not_of(' '); last != std::string::npos && safe[last] == '\\'; --last) {
    safe[last] = '/';
    if (last == 0) break;
  }
  return safe;
}

}  // namespace torsor
