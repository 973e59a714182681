// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/written_unit.hpp"

#include <string>

namespace torsor {
namespace {

struct Name {
  Unit unit;
  const char* text;
};

/// Of forces and motions. A torque has the dimension of an energy, and is more frequent.
constexpr Name names[] = {{Unit(0, 0, -1), "rad/s"}, {Unit(0, 0, -2), "rad/s^2"}, {units::newton, "N"},
                          {Unit(1, 2, -2), "N m"},   {Unit(1, 0, -2), "N/m"},     {Unit(1, 0, -1), "N s/m"},
                          {Unit(1, 2, -1), "N m s"}, {Unit(1, 1, -1), "N s"},     {Unit(1, -1, -2), "N/m^2"},
                          {Unit(1, 3, -2), "N m^2"}, {units::watt, "W"},          {Unit(-1, 3, -2), "N m^2/kg^2"}};

std::string power(const char* base, int half) {
  if (half % 2 != 0) return base + std::string("^(") + std::to_string(half) + "/2)";
  return half == 2 ? base : base + std::string("^") + std::to_string(half / 2);
}

}  // namespace

std::string written_unit(const Unit& unit) {
  for (const Name& name : names) {
    if (name.unit == unit) return name.text;
  }
  constexpr const char* bases[Unit::base_count] = {"kg", "m", "s", "A", "K", "mol", "cd"};
  std::string above, below;
  for (int i = 0; i < Unit::base_count; ++i) {
    const int half = unit.half_exponent(i);
    if (half > 0) above += (above.empty() ? "" : " ") + power(bases[i], half);
    if (half < 0) below += "/" + power(bases[i], -half);
  }
  return (above.empty() ? "1" : above) + below;
}

std::string written_unit(const Symbol& symbol) {
  if (!symbol.unit_text.empty()) return symbol.unit_text;
  const bool angle =
      symbol.unit.is_dimensionless() && symbol.kind == SymbolKind::coordinate && symbol.attitude.expired();
  return angle ? "rad" : written_unit(symbol.unit);
}

}  // namespace torsor
