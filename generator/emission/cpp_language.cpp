// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/cpp_language.hpp"

#include <utility>

#include <fmt/format.h>

#include "torsor/generator/emission/cpp_names.hpp"
#include "torsor/generator/emission/formula_printer.hpp"

namespace torsor {

CppLanguage::CppLanguage(const Layout& layout, std::string parameters, std::vector<std::string> members,
                         std::map<std::string, const Structure*> vectors)
    : layout_(&layout),
      parameters_(std::move(parameters)),
      members_(std::move(members)),
      vectors_(std::move(vectors)) {}

std::string CppLanguage::constant(const Number& number) const { return constant_call(number); }

std::string CppLanguage::local(const std::string& name, const std::string& value) const {
  return fmt::format("const Scalar {} = {};", name, value);
}

std::string CppLanguage::pi() const { return "traits::pi()"; }

std::vector<CodeLine> CppLanguage::literal(const std::string& name, const Literal& literal,
                                           const std::string& value) const {
  std::vector<CodeLine> lines{
      {fmt::format("const Scalar {} = traits::formula({}, {}, [&]() -> Scalar {{", name,
                   torsor::literal(literal.rounded.in_double), torsor::literal(literal.rounded.in_float))}};
  const Formula& right = literal.right;
  if (right.kind == Formula::Kind::function && (right.function == Function::sin || right.function == Function::cos)) {
    lines.push_back({"  Scalar sine, cosine;"});
    lines.push_back({fmt::format("  traits::sincos({}, sine, cosine);", value)});
    lines.push_back({fmt::format("  return {};", right.function == Function::sin ? "sine" : "cosine")});
  } else {
    lines.push_back({fmt::format("  return {};", value)});
  }
  lines.push_back({"});", literal.meaning});
  return lines;
}

std::string CppLanguage::access(const Quantity& quantity) const {
  if (quantity.table == Table::precomputed) return "precomputed." + members_.at(quantity.index);
  if (quantity.table == Table::time) return "state.time";
  if (quantity.table == Table::coefficient) return fmt::format("coefficients[k_][{}]", quantity.index);
  if (quantity.table == Table::convolution) return fmt::format("sums_[{}]", quantity.index);
  if (quantity.table == Table::order) return name_of(static_cast<OrderQuantity>(quantity.index));
  return symbol_access(*layout_->of(quantity.table).at(quantity.index), parameters_);
}

std::string CppLanguage::access(const Target& target) const {
  if (target.result == "coefficients") {
    const std::string order = target.member == "last" ? "order" : target.member;
    return fmt::format("coefficients[{}][{}]", order, *target.entry);
  }
  const std::string vector = target.member.empty() ? target.result : target.result + "." + target.member;
  const auto structure = vectors_.find(vector);
  if (target.entry && structure != vectors_.end())
    return vector + "." + structure->second->members.at(*target.entry).name;
  return target.to_string();
}

std::string CppLanguage::function(Function function) const { return traits_of(function).emitted.cpp; }

std::vector<CodeLine> CppLanguage::sines_and_cosines(const std::vector<AngleText>& angles, int group) const {
  if (angles.size() == 1) {
    const AngleText& only = angles[0];
    return {{fmt::format("Scalar {}, {};", only.sine, only.cosine)},
            {fmt::format("traits::sincos({}, {}, {});", only.angle, only.sine, only.cosine), only.meaning}};
  }
  return sines_in_arrays(angles, group, "Scalar", [](std::size_t, const std::string& suffix) {
    return fmt::format("torsor::sines_and_cosines(angles{0}, sines{0}, cosines{0});", suffix);
  });
}

std::vector<CodeLine> CppLanguage::recurrence(const RecurrenceText& text) const {
  std::vector<CodeLine> lines;
  const std::size_t lanes = text.convolutions.size();
  if (lanes > 0) {
    const std::string type = fmt::format("torsor::Convolutions<Scalar, {}>", lanes);
    lines.push_back({type + " operations_;"});
    lines.push_back({fmt::format("typename {}::Sums sums_;", type)});
  }
  lines.push_back({fmt::format("Scalar number_ = {0}, inverse_ = {0};", text.one)});
  lines.push_back({"for (int k_ = 1; k_ < order; ++k_) {"});
  lines.push_back({fmt::format("  const Scalar following_ = number_ + {0}, next_ = {0} / following_;", text.one)});
  if (text.is_first_read)
    lines.push_back({fmt::format("  const Scalar first_ = k_ == 1 ? {} : {};", text.one, text.zero)});
  if (lanes > 0) lines.push_back({"  operations_.sum(k_, sums_);"});
  for (const CodeLine& each : text.steps) lines.push_back({"  " + each.code, each.meaning});
  for (std::size_t i = 0; i < text.next.size(); ++i) {
    lines.push_back({fmt::format("  coefficients[k_ + 1][{}] = {};", i, text.next[i])});
  }
  if (lanes > 0) {
    std::string left, right;
    for (const auto& [a, b] : text.convolutions) {
      left += (left.empty() ? "" : ", ") + a;
      right += (right.empty() ? "" : ", ") + b;
    }
    lines.push_back({"  const Scalar left_[] = {" + left + "};"});
    lines.push_back({"  const Scalar right_[] = {" + right + "};"});
    lines.push_back({"  operations_.keep(k_, left_, right_);"});
  }
  for (const char* each : {"  number_ = following_;", "  inverse_ = next_;", "}", "static_cast<void>(inverse_);"})
    lines.push_back({each});
  return lines;
}

std::string CppLanguage::regular(const std::string& pivot, const std::string& diagonal) const {
  return fmt::format("traits::regular({}, {})", pivot, diagonal);
}

std::string CppLanguage::finite(const std::string& number) const { return fmt::format("traits::finite({})", number); }

std::string CppLanguage::status(const std::string& name) const { return "torsor::Status::" + name; }

}  // namespace torsor
