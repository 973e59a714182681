// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/fmi_variables.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/entities.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/unit.hpp"
#include "torsor/generator/emission/description.hpp"
#include "torsor/generator/kernels/kernel_energy.hpp"
#include "torsor/generator/listing/local_names.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {
namespace {

double start_value(const MechanismListing& mechanism, const SymbolPointer& symbol, const char* what) {
  try {
    return initial_value(mechanism.scene().content(), symbol).to_double();
  } catch (const SceneError&) {
    throw SceneError(fmt::format("the {} '{}' has no value, and a unit of FMI starts with one: give it in the scene",
                                 what, symbol->name));
  }
}

/// Whether a parameter that is set at run time stands in a formula, or in the value of one that does.
bool depends_on_parameters(const MechanismListing& mechanism, const Expression& formula) {
  const std::vector<SymbolPointer>& open = mechanism.layout.parameters;
  const std::vector<SymbolPointer> symbols = formula.symbols();
  return std::any_of(symbols.begin(), symbols.end(), [&](const SymbolPointer& symbol) {
    if (std::find(open.begin(), open.end(), symbol) != open.end()) return true;
    const auto& all = mechanism.scene().content().parameters;
    const auto found = std::find_if(all.begin(), all.end(), [&](const ParameterContent& p) { return p.symbol == symbol; });
    return found != all.end() && found->value && depends_on_parameters(mechanism, *found->value);
  });
}

/// "m" becomes "m/s", "rad" "rad/s".
std::string unit_of_rate(const std::string& unit) {
  if (unit == "rad") return "rad/s";
  if (unit == "1") return "1/s";  // of a ratio, or of a component of a quaternion
  return written_unit(Unit::parse(unit) / Unit(0, 0, 1));
}

/// Twice the exponent of rad in a unit as it is written, "N m/rad": that of cd, beyond what it has of its own, when each rad is
/// written cd. A unit of this tool has no dimension for angles, and one of FMI has.
int half_exponent_of_radian(const std::string& text) {
  const auto is_letter = [&text](std::size_t i) { return i < text.size() && std::isalpha(static_cast<unsigned char>(text[i])); };
  std::string other;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool whole = text.compare(i, 3, "rad") == 0 && !is_letter(i + 3) && (i == 0 || !is_letter(i - 1));
    other += whole ? "cd" : text.substr(i, 1);
    if (whole) i += 2;
  }
  constexpr int candela = Unit::base_count - 1;
  return Unit::parse(other).half_exponent(candela) - Unit::parse(text).half_exponent(candela);
}

std::string unit_definition(const std::string& text) {
  const Unit unit = Unit::parse(text);
  static constexpr const char* bases[] = {"kg", "m", "s", "A", "K", "mol", "cd"};
  std::string attributes;
  for (int i = 0; i < Unit::base_count; ++i) {
    const int half = unit.half_exponent(i);
    if (half % 2 != 0) return fmt::format("    <Unit name=\"{}\"/>\n", xml_escaped(text));  // a root: FMI has none
    if (half != 0) attributes += fmt::format(" {}=\"{}\"", bases[i], half / 2);
  }
  const int half = half_exponent_of_radian(text);
  if (half % 2 != 0) return fmt::format("    <Unit name=\"{}\"/>\n", xml_escaped(text));
  if (half != 0) attributes += fmt::format(" rad=\"{}\"", half / 2);
  return fmt::format("    <Unit name=\"{}\"><BaseUnit{}/></Unit>\n", xml_escaped(text), attributes);
}

}  // namespace

std::vector<std::string> fmi_indicators(const MechanismListing& mechanism) {
  std::vector<std::string> names;
  for (const ContactContent& contact : mechanism.scene().content().contacts) {
    for (const char* what : {"opens_or_closes", "sticks_or_slips", "slip_begins_or_fades"}) {
      names.push_back(fmt::format("indicator.{}.{}", contact.name, what));
    }
  }
  return names;
}

namespace {

/// Variables as they are declared, one reference after the other.
class VariableList {
 public:
  using Role = FmiVariable::Role;

  void add(const std::string& name, const std::string& unit, Role role, std::optional<double> start = {}) {
    all_.push_back({name, unit, role, start, next_++});
  }
  void follow_parameters() { all_.back().follows_parameters = true; }
  void add_derivative(std::size_t state, const std::string& unit) {
    all_.push_back({fmt::format("der({})", all_[state].name), unit, Role::derivative, {}, next_++, state});
  }
  void leave_out(std::size_t count) { next_ += count; }
  const FmiVariable& operator[](std::size_t i) const { return all_[i]; }
  std::vector<FmiVariable> take() { return std::move(all_); }

 private:
  std::vector<FmiVariable> all_;
  std::size_t next_ = 0;
};

/// In apostrophes, as the standard's structured names have what is no identifier.
std::string quoted(const std::string& part) {
  std::string text = "'";
  for (const char c : part) {
    if (c == '\'' || c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + "'";
}

/// Names of several parts, "hoop.2", as the standard's structured names have them. A part that is no identifier is
/// quoted; none may be empty, so that "hoop..2" is quoted as a whole.
std::string structured(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string text;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    if (part.empty()) return quoted(name);
    const bool plain = is_letter(part[0]) &&
                       std::all_of(part.begin(), part.end(), [&](char c) { return is_letter(c) || is_digit(c); });
    text += (begin == 0 ? "" : ".") + (plain ? part : quoted(part));
    begin = end + 1;
  }
  return text;
}

void add_outputs(const FmiUnit& unit, VariableList& all) {
  constexpr auto output = FmiVariable::Role::output;
  const Layout& layout = unit.mechanism.layout;
  if (unit.has_contacts()) {
    all.leave_out(layout.multipliers.size());
  } else {
    for (const auto& [name, text] : named_units(layout.multipliers)) all.add("multiplier." + name, text, output);
  }
  for (const char* kind : {"kinetic", "potential", "total"}) all.add(fmt::format("energy.{}", kind), "J", output);
  const auto add_place = [&](const std::string& owner) {
    for (const char axis : {'x', 'y', 'z'}) all.add(fmt::format("{}.{}", owner, axis), "m", output);
  };
  for (const std::string& name : unit.outputs.points) add_place("point." + structured(name));
  for (const std::string& name : unit.outputs.frames) {
    add_place("frame." + structured(name));
    for (int i = 1; i <= 3; ++i) {
      for (int j = 1; j <= 3; ++j) all.add(fmt::format("frame.{}.rotation[{},{}]", structured(name), i, j), "1", output);
    }
  }
  for (const std::string& name : unit.outputs.reactions) {
    for (const CoordinateContent& coordinate : unit.scene().content().coordinates) {
      if (coordinate.q->name != name) continue;
      all.add("reaction." + member_name(*coordinate.q), written_unit(units::joule / coordinate.q->unit), output);
    }
  }
}

}  // namespace

std::vector<FmiVariable> fmi_variables(const FmiUnit& unit) {
  using Role = FmiVariable::Role;
  const MechanismListing& mechanism = unit.mechanism;
  const Layout& layout = mechanism.layout;
  VariableList all;
  const auto states = [&](const std::string& prefix, const std::vector<SymbolPointer>& symbols) {
    const std::vector<NamedUnit> named = named_units(symbols);
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      all.add(prefix + named[i].name, named[i].unit, Role::state, start_value(mechanism, symbols[i], "state"));
      const auto formula = initial_formula(mechanism.scene().content(), symbols[i]);
      if (formula && depends_on_parameters(mechanism, *formula)) all.follow_parameters();
    }
  };
  states("q.", layout.coordinates);
  states("v.", layout.velocities);
  const std::size_t nq = layout.coordinates.size();
  for (std::size_t i = 0; i < nq; ++i) all.add_derivative(i, unit_of_rate(all[i].unit));
  for (std::size_t i = 0; i < layout.velocities.size(); ++i)
    all.add_derivative(nq + i, written_unit(*layout.accelerations[i]));
  for (const auto& [name, text] : named_units(layout.inputs)) all.add("input." + name, text, Role::input, 0.0);
  const std::vector<NamedUnit> parameters = named_units(layout.parameters);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    all.add("parameter." + parameters[i].name, written_unit(*layout.parameters[i]), Role::parameter,
            start_value(mechanism, layout.parameters[i], "parameter"));
  }
  add_outputs(unit, all);
  for (const std::string& name : fmi_indicators(mechanism)) all.add(name, "1", Role::indicator);
  if (unit.version == FmiVersion::three) all.add("time", "s", Role::time);
  return all.take();
}

std::vector<FmiDependency> fmi_dependencies(const FmiUnit& unit, const std::vector<FmiVariable>& variables) {
  const Equations& equations = *unit.mechanism.equations;
  equations.start_over();
  const Energies energies = energies_of(equations);
  std::vector<Value> values = {energies.kinetic, energies.force_function, energies.kinetic - energies.force_function};
  for (const Value& place : output_places(equations, unit.outputs)) values.push_back(place);
  const Program& program = equations.program();
  const Layout& layout = unit.mechanism.layout;
  const auto known = [&](const FmiVariable& variable, const SymbolPointer& symbol) {
    using Role = FmiVariable::Role;
    const std::size_t nq = layout.coordinates.size(), nx = nq + layout.velocities.size(), k = variable.reference;
    switch (variable.role) {
      case Role::state:
        return symbol == (k < nq ? layout.coordinates[k] : layout.velocities[k - nq]);
      case Role::input:
        return symbol == layout.inputs[k - 2 * nx];
      case Role::parameter:
        return symbol == layout.parameters[k - 2 * nx - layout.inputs.size()];
      case Role::time:
        return symbol->kind == SymbolKind::time;
      default:
        return false;
    }
  };
  std::vector<FmiDependency> all;
  const std::size_t multipliers = unit.has_contacts() ? 0 : layout.multipliers.size();
  for (const FmiVariable& output : variables) {
    if (output.role != FmiVariable::Role::output) continue;
    const std::size_t place = all.size();
    all.push_back({output.reference, {}});
    if (place < multipliers || place - multipliers >= values.size()) continue;
    std::vector<std::size_t> on;
    const std::vector<ValueNumber> live = program.live({values[place - multipliers]});
    for (const FmiVariable& variable : variables) {
      const bool reads = std::any_of(live.begin(), live.end(), [&](ValueNumber number) {
        return program[number].symbol && known(variable, program[number].symbol);
      });
      if (reads) on.push_back(variable.reference);
    }
    all.back().on = on;
  }
  equations.start_over();
  return all;
}

std::string fmi_naming(const std::vector<FmiVariable>& variables) {
  const bool all = std::all_of(variables.begin(), variables.end(), [](const FmiVariable& variable) {
    return std::all_of(variable.name.begin(), variable.name.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x80 && c != '`'; });
  });
  return all ? "structured" : "flat";
}

std::string fmi_unit_definitions(const std::vector<FmiVariable>& variables) {
  std::vector<std::string> names;
  std::string text;
  for (const FmiVariable& variable : variables) {
    if (variable.unit == "1" || std::find(names.begin(), names.end(), variable.unit) != names.end()) continue;
    names.push_back(variable.unit);
    text += unit_definition(variable.unit);
  }
  return text;
}

std::string xml_escaped(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return with_entities(text, "&<>\"");
}

}  // namespace torsor
