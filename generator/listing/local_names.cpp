// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/local_names.hpp"

#include <fmt/format.h>

namespace torsor {

std::string member_name(const Symbol& symbol) { return symbol.name.substr(0, symbol.name.find('\'')); }

std::string local_name(const Program& program, ValueNumber value_number) {
  const Definition& definition = program[value_number];
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
  return {};
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

}  // namespace torsor
