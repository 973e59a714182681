// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/definitions_view.hpp"

namespace torsor::printing {

DefinitionsView::DefinitionsView(const Program& program, const std::vector<Value>& results) {
  for (const ValueNumber value_number : program.live(results)) {
    const Definition& definition = program[value_number];
    if (definition.symbol) {
      value_numbers_.emplace(value_number, Sum::symbol(definition.symbol));
    } else if (definition.function) {
      // A function is written where it is used: cos(theta) says more than a number.
      std::vector<Sum> arguments;
      for (const ValueNumber argument : definition.arguments) {
        const Definition& inner = program[argument];
        const bool number = !inner.symbol && !inner.function && inner.polynomial.is_constant();
        arguments.push_back(number ? of_polynomial(inner.polynomial) : value_numbers_.at(argument));
      }
      value_numbers_.emplace(value_number, Sum::function(*definition.function, arguments));
    } else {
      const int number = static_cast<int>(lines_.size()) + 1;
      lines_.push_back({number, collected(of_polynomial(definition.polynomial)), definition.name});
      value_numbers_.emplace(value_number, Sum::definition(number));
    }
  }
}

Sum DefinitionsView::of_polynomial(const Polynomial& polynomial) const {
  Sum sum;
  for (const Term& term : polynomial.terms()) {
    Sum product{term.coefficient};
    for (const Factor& factor : term.monomial)
      product = product * power(value_numbers_.at(factor.value_number), 2 * factor.exponent);
    sum += product;
  }
  return sum;
}

std::string meaning_of(const DefinitionsView::Line& line, const NaturalLanguage& say) {
  // Programs name their definitions in English, "WHAT of WHOM, x"; WHOM is a name of the scene.
  static constexpr std::string_view of = " of ", joint = "acceleration of joint ";
  if (say.is_english()) return line.name;
  if (line.name.starts_with(joint)) return say("acceleration of joint {}", line.name.substr(joint.size()));
  const std::size_t at = line.name.find(of);
  if (at == std::string::npos) return say.known(line.name);
  return say("{} of {}", say.known(line.name.substr(0, at)), line.name.substr(at + of.size()));
}

}  // namespace torsor::printing
