// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/cpp_language.hpp"

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "generator/emission/cpp_names.hpp"
#include "generator/emission/formula_printer.hpp"

namespace torsor {

CppLanguage::CppLanguage(const Layout& layout, std::string parameters, std::vector<std::string> members,
                         std::map<std::string, const Structure*> vectors)
    : layout_(&layout), parameters_(std::move(parameters)), members_(std::move(members)), vectors_(std::move(vectors)) {}

std::string CppLanguage::constant(const Number& number) const { return constant_call(number); }

std::string CppLanguage::local(const std::string& name, const std::string& value) const {
  return fmt::format("const Scalar {} = {};", name, value);
}

std::string CppLanguage::pi() const { return "traits::pi()"; }

std::vector<std::string> CppLanguage::literal(const std::string& name, const Literal& literal,
                                              const std::string& value) const {
  std::vector<std::string> lines{fmt::format("const Scalar {} = traits::formula({}, {}, [&]() -> Scalar {{", name,
                                             torsor::literal(literal.rounded.in_double),
                                             torsor::literal(literal.rounded.in_float))};
  const Formula& right = literal.right;
  if (right.kind == Formula::Kind::function && (right.function == Function::sin || right.function == Function::cos)) {
    lines.emplace_back("  Scalar sine, cosine;");
    lines.push_back(fmt::format("  traits::sincos({}, sine, cosine);", value));
    lines.push_back(fmt::format("  return {};", right.function == Function::sin ? "sine" : "cosine"));
  } else {
    lines.push_back(fmt::format("  return {};", value));
  }
  lines.emplace_back("});");
  return lines;
}

std::string CppLanguage::access(const Quantity& quantity) const {
  if (quantity.table == Table::precomputed) return "precomputed." + members_.at(quantity.index);
  if (quantity.table == Table::time) return "state.time";
  return symbol_access(*layout_->of(quantity.table).at(quantity.index), parameters_);
}

std::string CppLanguage::access(const Target& target) const {
  const std::string vector = target.member.empty() ? target.result : target.result + "." + target.member;
  const auto structure = vectors_.find(vector);
  if (target.entry && structure != vectors_.end()) return vector + "." + structure->second->members.at(*target.entry).name;
  return target.to_string();
}

std::string CppLanguage::function(Function function) const { return traits_of(function).emitted; }

std::vector<std::string> CppLanguage::sine_and_cosine(const std::string& angle, const std::string& sine,
                                                      const std::string& cosine) const {
  return {fmt::format("Scalar {}, {};", sine, cosine), fmt::format("traits::sincos({}, {}, {});", angle, sine, cosine)};
}

std::vector<std::string> CppLanguage::sines_and_cosines(const std::vector<std::string>& angles,
                                                        const std::string& suffix) const {
  return {fmt::format("const Scalar angles{}[] = {{{}}};", suffix, fmt::join(angles, ", ")),
          fmt::format("Scalar sines{0}[{1}], cosines{0}[{1}];", suffix, angles.size()),
          fmt::format("torsor::sines_and_cosines(angles{0}, sines{0}, cosines{0});", suffix)};
}

std::string CppLanguage::regular(const std::string& pivot, const std::string& diagonal) const {
  return fmt::format("traits::regular({}, {})", pivot, diagonal);
}

std::string CppLanguage::status(const std::string& name) const { return "torsor::Status::" + name; }

}  // namespace torsor
