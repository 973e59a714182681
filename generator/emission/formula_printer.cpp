// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/formula_printer.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/listing/local_names.hpp"

namespace torsor {
namespace {

template <class Float>
std::string with_point(Float value) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  std::string text(buffer.data(), end);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

std::string literal(double value) {
  if (std::isinf(value)) return value < 0 ? "-HUGE_VAL" : "HUGE_VAL";
  return with_point(value);
}

std::string literal(float value) {
  if (std::isinf(value)) return value < 0 ? "-HUGE_VALF" : "HUGE_VALF";
  return with_point(value) + "f";
}

std::string constant_call(const Number& number) {
  return fmt::format("traits::constant({}, {}, \"{}\")", literal(number.to_double()), literal(number.to_float()),
                     number.to_exact());
}

std::string FormulaPrinter::name(const Number& number) {
  const auto [place, added] = places_.emplace(number, constants_.size());
  if (added) constants_.push_back({number, constant_name(number, constants_.size())});
  return constants_[place->second].name;
}

std::string FormulaPrinter::print_sum(const Formula& sum, bool negated) {
  std::string text;
  for (std::size_t i = 0; i < sum.children.size(); ++i) {
    const bool minus = sum.negative[i] != negated;
    text += i == 0 ? (minus ? "-" : "") : (minus ? " - " : " + ");
    const bool nested = sum.children[i].kind == Formula::Kind::sum;
    text += nested ? print_factor(sum.children[i]) : print(sum.children[i]);
  }
  return text;
}

std::string FormulaPrinter::print_factor(const Formula& formula) {
  const bool simple = formula.kind == Formula::Kind::value_number || formula.kind == Formula::Kind::constant;
  return simple ? print(formula) : "(" + print(formula) + ")";
}

std::string FormulaPrinter::print(const Formula& formula) {
  switch (formula.kind) {
    case Formula::Kind::value_number:
      return name_of_(*formula.value_number);
    case Formula::Kind::constant:
      return formula.number.sign() < 0 ? "-" + name(-formula.number) : name(formula.number);
    case Formula::Kind::sum:
      return print_sum(formula, false);
    case Formula::Kind::product: {
      std::string text;
      for (const Formula& child : formula.children) text += (text.empty() ? "" : " * ") + print_factor(child);
      return text;
    }
    case Formula::Kind::quotient: {
      // A product on top needs no parentheses: a * b / c is (a * b) / c.
      const Formula& top = formula.children[0];
      const std::string numerator = top.kind == Formula::Kind::product ? print(top) : print_factor(top);
      return numerator + " / " + print_factor(formula.children[1]);
    }
    case Formula::Kind::function: {
      std::string text;
      for (const Formula& child : formula.children) text += (text.empty() ? "" : ", ") + print(child);
      return fmt::format("{}({})", name_of_function_(formula.function), text);
    }
  }
  return {};
}

std::string FormulaPrinter::print_negated(const Formula& formula) {
  if (formula.kind == Formula::Kind::sum) return print_sum(formula, true);
  return "-" + print(formula);
}

}  // namespace torsor
