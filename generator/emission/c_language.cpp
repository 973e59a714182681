// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/c_language.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/emission/formula_printer.hpp"

namespace torsor {

std::string CLanguage::constant(const Number& number) const {
  return fmt::format("TORSOR_NUMBER({}, {})", torsor::literal(number.to_double()), torsor::literal(number.to_float()));
}

std::string CLanguage::local(const std::string& name, const std::string& value) const {
  return fmt::format("const torsor_real {} = {};", name, value);
}

std::string CLanguage::pi() const { return "TORSOR_NUMBER(3.141592653589793, 3.1415927f)"; }

std::vector<CodeLine> CLanguage::literal(const std::string& name, const Literal& literal, const std::string&) const {
  const std::string value = fmt::format("TORSOR_NUMBER({}, {})", torsor::literal(literal.rounded.in_double),
                                        torsor::literal(literal.rounded.in_float));
  return {{local(name, value), literal.meaning}};
}

std::string CLanguage::access(const Quantity& quantity) const {
  const auto entry = [&quantity](const char* array) { return fmt::format("{}[{}]", array, quantity.index); };
  switch (quantity.table) {
    case Table::time:
      return "state->time";
    case Table::coordinate:
      return entry("state->q");
    case Table::velocity:
      return entry("state->v");
    case Table::acceleration:
      return entry("accelerations");
    case Table::multiplier:
      return entry("multipliers");
    case Table::input:
      return entry("inputs");
    case Table::parameter:
      return entry(parameters_.c_str());
    case Table::precomputed:
      return "precomputed->" + mechanism_->members.at(quantity.index).name;
    case Table::coefficient: {
      const Layout& layout = mechanism_->layout;
      return fmt::format("coefficients[{} * k_ + {}]", layout.coordinates.size() + layout.velocities.size(),
                         quantity.index);
    }
    case Table::convolution:
      return entry("sums_");
    case Table::order:
      return name_of(static_cast<OrderQuantity>(quantity.index));
    case Table::output:
    case Table::local:
      break;
  }
  throw Error("a local variable is read where an argument stands");
}

std::string CLanguage::access(const Target& target) const {
  const Layout& layout = mechanism_->layout;
  if (target.result == "coefficients") {
    return coefficient_in_array(target, layout.coordinates.size() + layout.velocities.size());
  }
  if (target.result == "parameters") {
    const auto& all = layout.parameters;
    const auto place =
        std::find_if(all.begin(), all.end(), [&](const SymbolPointer& each) { return each->name == target.member; });
    if (place == all.end()) throw Error(fmt::format("there is no parameter '{}'", target.member));
    return fmt::format("parameters[{}]", place - all.begin());
  }
  const std::string entry = target.entry ? fmt::format("[{}]", *target.entry) : "";
  return target.member.empty() ? target.result + entry : fmt::format("{}->{}{}", target.result, target.member, entry);
}

std::string CLanguage::function(Function function) const {
  const std::string name = traits_of(function).emitted.c;
  if (name.empty()) throw Error("sines and cosines come in pairs");
  return name;
}

std::vector<CodeLine> CLanguage::sines_and_cosines(const std::vector<AngleText>& angles, int group) const {
  if (angles.size() == 1) {
    const AngleText& only = angles[0];
    return {{fmt::format("torsor_real {}, {};", only.sine, only.cosine)},
            {fmt::format("torsor_sincos({}, &{}, &{});", only.angle, only.sine, only.cosine), only.meaning}};
  }
  return sines_in_arrays(angles, group, "torsor_real", [](std::size_t count, const std::string& suffix) {
    return fmt::format("torsor_sines_and_cosines({1}, angles{0}, sines{0}, cosines{0});", suffix, count);
  });
}

std::vector<CodeLine> CLanguage::recurrence(const RecurrenceText& text) const {
  const std::size_t lanes = text.convolutions.size();
  std::vector<CodeLine> lines;
  if (lanes > 0) {
    lines.push_back(
        {fmt::format("torsor_real left_[{0} * torsor_order_max], right_[{0} * torsor_order_max], sums_[{0}];", lanes)});
  }
  lines.push_back({fmt::format("torsor_real number_ = {0}, inverse_ = {0};", text.one)});
  lines.push_back({"for (int k_ = 1; k_ < order; ++k_) {"});
  lines.push_back({fmt::format("  const torsor_real following_ = number_ + {0}, next_ = {0} / following_;", text.one)});
  if (text.is_first_read) {
    lines.push_back({fmt::format("  const torsor_real first_ = k_ == 1 ? {} : {};", text.one, text.zero)});
  }
  if (lanes > 0) lines.push_back({fmt::format("  torsor_convolutions({}, k_, left_, right_, sums_);", lanes)});
  for (CodeLine& each : order_in_arrays(text)) lines.push_back(std::move(each));
  lines.push_back({"(void)inverse_;"});
  return lines;
}

std::string CLanguage::regular(const std::string& pivot, const std::string& diagonal) const {
  return fmt::format("torsor_regular({}, {})", pivot, diagonal);
}

std::string CLanguage::finite(const std::string& number) const { return fmt::format("torsor_finite({})", number); }

std::string CLanguage::status(const std::string& name) const { return "torsor_" + name; }

}  // namespace torsor
