// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/mechanics/require_unit.hpp"

#include <fmt/format.h>

#include "generator/base/error.hpp"

namespace torsor {

void require_unit(const Expression& given, const Unit& unit, const std::string& whose) {
  if (given.is_zero() || given.unit() == unit) return;
  throw UnitError(fmt::format("{} is {} [{}] and must be in {}", whose, given.to_string(), given.unit().to_string(),
                              unit.is_dimensionless() ? "plain numbers" : unit.to_string()));
}

void require_unit(const Triple& given, const Unit& unit, const std::string& whose) {
  for (const Expression& component : given) require_unit(component, unit, whose);
}

void require_one_unit(const Triple& given, const std::string& whose) {
  const Expression* first = nullptr;
  for (const Expression& component : given) {
    if (component.is_zero()) continue;
    if (first == nullptr) {
      first = &component;
    } else if (!(component.unit() == first->unit())) {
      throw UnitError(fmt::format("{} has components of different units, {} [{}] and {} [{}]: give all in one", whose,
                                  first->to_string(), first->unit().to_string(), component.to_string(),
                                  component.unit().to_string()));
    }
  }
}

}  // namespace torsor
