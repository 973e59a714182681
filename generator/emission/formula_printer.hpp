// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "torsor/generator/base/wrapped_line.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Prints formulas as C, C++ and JavaScript write them: the very trees that are counted, so that each operator of the text
/// is one operation. Numbers become names, gathered in order of first use; the caller declares them.
class FormulaPrinter {
 public:
  using NameOf = std::function<std::string(ValueNumber)>;
  using NameOfFunction = std::function<std::string(Function)>;

  FormulaPrinter(NameOf name_of, NameOfFunction name_of_function)
      : name_of_(std::move(name_of)), name_of_function_(std::move(name_of_function)) {}

  std::string print(const Formula& formula);
  /// −formula, with the signs of a sum turned round instead of a minus before it.
  std::string print_negated(const Formula& formula);
  /// In parentheses where it is more than a name.
  std::string print_factor(const Formula& formula);
  /// Name of a number; from then on it is in the list.
  std::string name(const Number& number);

  struct Constant {
    Number number;
    std::string name;
  };
  const std::vector<Constant>& constants() const { return constants_; }

 private:
  std::string print_sum(const Formula& sum, bool negated);

  NameOf name_of_;
  NameOfFunction name_of_function_;
  std::vector<Constant> constants_;
  std::unordered_map<Number, std::size_t> places_;  ///< looked up only
};

/// Shortest decimal that reads back as the same double ("9.81", "2.0", "1e+20").
std::string literal(double value);
/// The same for float ("9.81f").
std::string literal(float value);

/// `traits::constant(9.81, 9.81f, "981/100")`, rounded once for each format.
std::string constant_call(const Number& number);

}  // namespace torsor
