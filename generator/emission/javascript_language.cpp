// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/javascript_language.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/emission/formula_printer.hpp"

namespace torsor {
namespace {

std::size_t size_of(const Member& member) {
  return member.is_scalar() ? 1 : static_cast<std::size_t>(member.rows) * static_cast<std::size_t>(member.columns);
}

/// Infinity has another name than in C.
std::string number_text(double value) {
  const std::string text = literal(value);
  if (text == "HUGE_VAL") return "Infinity";
  return text == "-HUGE_VAL" ? "-Infinity" : text;
}

std::size_t place_of(const std::vector<SymbolPointer>& symbols, const std::string& name) {
  const auto place =
      std::find_if(symbols.begin(), symbols.end(), [&](const SymbolPointer& each) { return each->name == name; });
  if (place == symbols.end()) throw Error(fmt::format("there is no parameter '{}'", name));
  return static_cast<std::size_t>(place - symbols.begin());
}

}  // namespace

std::size_t offset_of(const Structure& structure, const std::string& member) {
  std::size_t offset = 0;
  for (const Member& each : structure.members) {
    if (each.name == member) return offset;
    offset += size_of(each);
  }
  throw Error(fmt::format("the structure {} has no member '{}'", structure.name, member));
}

std::size_t size_of(const Structure& structure) {
  std::size_t size = 0;
  for (const Member& each : structure.members) size += size_of(each);
  return size;
}

JavascriptLanguage::JavascriptLanguage(const MechanismListing& mechanism, std::string parameters,
                                       std::map<std::string, const Structure*> results)
    : mechanism_(&mechanism), parameters_(std::move(parameters)), results_(std::move(results)) {}

std::string JavascriptLanguage::constant(const Number& number) const { return number_text(number.to_double()); }

std::string JavascriptLanguage::local(const std::string& name, const std::string& value) const {
  return fmt::format("const {} = {};", name, value);
}

std::string JavascriptLanguage::pi() const { return "Math.PI"; }

std::vector<CodeLine> JavascriptLanguage::literal(const std::string& name, const Literal& literal,
                                                  const std::string&) const {
  return {{local(name, number_text(literal.rounded.in_double)), literal.meaning}};
}

std::string JavascriptLanguage::access(const Quantity& quantity) const {
  const Layout& layout = mechanism_->layout;
  const auto entry = [](const std::string& array, const auto& index) { return fmt::format("{}[{}]", array, index); };
  switch (quantity.table) {
    case Table::time:
      return "state[0]";
    case Table::coordinate:
      return entry("state", 1 + quantity.index);
    case Table::velocity:
      return entry("state", 1 + layout.coordinates.size() + quantity.index);
    case Table::acceleration:
      return entry("accelerations", quantity.index);
    case Table::multiplier:
      return entry("multipliers", quantity.index);
    case Table::input:
      return entry("inputs", quantity.index);
    case Table::parameter:
      return entry(parameters_, quantity.index);
    case Table::precomputed:
      return entry("precomputed", mechanism_->members.at(quantity.index).name);
    case Table::coefficient:
      return entry("coefficients",
                   fmt::format("{} * k_ + {}", layout.coordinates.size() + layout.velocities.size(), quantity.index));
    case Table::convolution:
      return entry("sums_", quantity.index);
    case Table::order:
      return name_of(static_cast<OrderQuantity>(quantity.index));
    case Table::output:
    case Table::local:
      break;
  }
  throw Error("a local variable is read where an argument stands");
}

std::string JavascriptLanguage::access(const Target& target) const {
  const Layout& layout = mechanism_->layout;
  std::size_t place = target.entry.value_or(0);
  if (target.result == "coefficients") {
    return coefficient_in_array(target, layout.coordinates.size() + layout.velocities.size());
  }
  if (target.result == "parameters") {
    place = place_of(layout.parameters, target.member);
  } else if (target.result == "precomputed") {
    return fmt::format("precomputed[{}]", target.member);
  } else if (target.result == "state") {
    if (target.member != "time") place += target.member == "q" ? 1 : 1 + layout.coordinates.size();
  } else if (!target.member.empty()) {
    place += offset_of(*results_.at(target.result), target.member);
  }
  return fmt::format("{}[{}]", target.result, place);
}

std::string JavascriptLanguage::function(Function function) const {
  const std::string name = traits_of(function).emitted.javascript;
  if (name.empty()) throw Error("sines and cosines come in pairs");
  return name;
}

std::vector<CodeLine> JavascriptLanguage::sines_and_cosines(const std::vector<AngleText>& angles, int) const {
  std::vector<CodeLine> lines;
  for (const AngleText& each : angles) {
    if (each.sine.empty() && each.cosine.empty()) continue;
    lines.push_back({fmt::format("sincos({});", each.angle)});
    std::string locals;
    const auto take = [&locals](const std::string& name, int place) {
      if (!name.empty()) locals += fmt::format("{} {} = turned[{}]", locals.empty() ? "const" : ",", name, place);
    };
    take(each.sine, 0);
    take(each.cosine, 1);
    lines.push_back({locals + ";", each.meaning});
  }
  return lines;
}

std::vector<CodeLine> JavascriptLanguage::recurrence(const RecurrenceText& text) const {
  const std::size_t lanes = text.convolutions.size();
  std::vector<CodeLine> lines{{"let number_ = 1, inverse_ = 1;"}};
  if (lanes > 0) {
    for (const char* name : {"left_", "right_"})
      lines.push_back({fmt::format("const {} = new Float64Array({} * order);", name, lanes)});
    lines.push_back({fmt::format("const sums_ = new Float64Array({});", lanes)});
  }
  lines.push_back({"for (let k_ = 1; k_ < order; ++k_) {"});
  lines.push_back({"  const following_ = number_ + 1, next_ = 1 / following_;"});
  if (text.is_first_read) lines.push_back({"  const first_ = k_ === 1 ? 1 : 0;"});
  if (lanes > 0) lines.push_back({fmt::format("  convolutions({}, k_, left_, right_, sums_);", lanes)});
  for (CodeLine& each : order_in_arrays(text)) lines.push_back(std::move(each));
  return lines;
}

std::string JavascriptLanguage::regular(const std::string& pivot, const std::string& diagonal) const {
  return fmt::format("regular({}, {})", pivot, diagonal);
}

std::string JavascriptLanguage::finite(const std::string& number) const { return fmt::format("Number.isFinite({})", number); }

std::string JavascriptLanguage::status(const std::string& name) const { return "Status." + name; }

}  // namespace torsor
