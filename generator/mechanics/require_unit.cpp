// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/require_unit.hpp"

#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

std::string wanted(const Unit& unit) { return unit.is_dimensionless() ? "plain numbers" : written_unit(unit); }

/// That of a symbol as its author wrote it.
std::string unit_of(const Expression& given) {
  const SymbolPointer symbol = given.as_symbol();
  return symbol ? written_unit(*symbol) : written_unit(given.unit());
}

}  // namespace

std::string unit_remedy(const std::string& number, const Unit& given, const Unit& wanted) {
  const bool plain = given.is_dimensionless() && number.find_first_not_of("-0123456789./") == std::string::npos;
  return plain && !wanted.is_dimensionless() ? fmt::format(": write quantity(\"{}\", \"{}\")", number, written_unit(wanted)) : "";
}

void require_unit(const Expression& given, const Unit& unit, const std::string& whose) {
  if (given.is_zero() || given.unit() == unit) return;
  throw UnitError(fmt::format("{} is {} [{}] and must be in {}{}", whose, given.to_string(), unit_of(given),
                              wanted(unit), unit_remedy(given.to_string(), given.unit(), unit)));
}

// All at once: who wrote one without its unit wrote the others so too.
void require_unit(const Triple& given, const Unit& unit, const std::string& whose) {
  std::vector<std::string> wrong;
  std::string remedy;
  for (const Expression& component : given) {
    if (component.is_zero() || component.unit() == unit) continue;
    wrong.push_back(fmt::format("{} [{}]", component.to_string(), unit_of(component)));
    if (remedy.empty()) remedy = unit_remedy(component.to_string(), component.unit(), unit);
  }
  if (wrong.empty()) return;
  throw UnitError(fmt::format("{} is {} and must be in {}{}", whose, fmt::join(wrong, ", another is "), wanted(unit), remedy));
}

void require_one_unit(const Triple& given, const std::string& whose) {
  const Expression* first = nullptr;
  for (const Expression& component : given) {
    if (component.is_zero()) continue;
    if (first == nullptr) {
      first = &component;
    } else if (!(component.unit() == first->unit())) {
      throw UnitError(fmt::format("{} has components of different units, {} [{}] and {} [{}]: give all in one", whose,
                                  first->to_string(), unit_of(*first), component.to_string(), unit_of(component)));
    }
  }
}

}  // namespace torsor
