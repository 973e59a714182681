// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/cpp_emitter.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

#include <fmt/format.h>

#include "generator/emission/cpp_names.hpp"
#include "generator/listing/generation_constant.hpp"
#include "generator/listing/issue_order.hpp"
#include "generator/emission/series_emitter.hpp"
#include "generator/emission/text_template.hpp"
#include "generator/expression/error.hpp"

namespace torsor {
namespace {

constexpr std::size_t function_indentation = 4;

/// So many products in the check that results are finite wait for each other.
constexpr std::size_t finite_group = 16;

/// 0 times some results; of many a product of such products.
std::string zero_times(const std::string& zero, const std::vector<std::string>& of, std::size_t begin, std::size_t end) {
  if (end - begin > finite_group) {
    const std::size_t middle = begin + (end - begin) / 2;
    const std::string first = zero_times(zero, of, begin, middle);
    return "(" + first + ") * (" + zero_times(zero, of, middle, end) + ")";
  }
  std::string product = zero;
  for (std::size_t i = begin; i < end; ++i) product += " * " + of[i];
  return product;
}

bool is_trigonometric(const Definition& definition) {
  return definition.function == Function::sin || definition.function == Function::cos;
}

/// Calls for each earlier atom of the program that a definition reads.
template <class Call>
void for_each_operand(const Definition& definition, const Call& call) {
  for (const Term& term : definition.polynomial.terms()) {
    for (const Factor& factor : term.monomial) call(factor.atom);
  }
  for (const Atom argument : definition.arguments) call(argument);
}

}  // namespace

void FunctionEmitter::provide(const SumTable& ready, const std::string& prefix) {
  ready_ = &ready;
  ready_prefix_ = prefix;
}

void FunctionEmitter::line(const std::string& code) { code_ += wrapped(code, function_indentation) + "\n"; }

void FunctionEmitter::statement(const std::string& code, const std::string& meaning) {
  const std::string text = wrapped(code, function_indentation);
  if (meaning.empty()) {
    code_ += text + "\n";
    return;
  }
  const std::string comment = "// " + comment_text(meaning);
  const bool fits = text.find('\n') == std::string::npos && text.size() + comment.size() + 6 <= 120;
  code_ += fits ? text + "  " + comment + "\n" : comment + "\n" + text + "\n";
}

void FunctionEmitter::compute(const Block& block) {
  for (const Atom atom : block.symbols) {
    const Symbol& symbol = *(*program_)[atom].symbol;
    bindings_ +=
        fmt::format("const Scalar {} = {};\n", local_name(*program_, atom), symbol_access(symbol, parameters_));
  }
  for (const Atom atom : block.given) {
    const std::string name = local_name(*program_, atom);
    bindings_ += fmt::format("const Scalar {} = precomputed.{};\n", name, name);
  }
  done_.assign(program_->size(), false);
  define_sines_and_cosines(block);
  std::vector<Atom> left;
  for (const Atom atom : block.definitions) {
    if (!done_[static_cast<std::size_t>(atom)]) left.push_back(atom);
  }
  for (const Atom atom : issue_order(*program_, left)) define(atom);
}

void FunctionEmitter::define(Atom atom) {
  if (done_[static_cast<std::size_t>(atom)]) return;
  done_[static_cast<std::size_t>(atom)] = true;
  const Definition& definition = (*program_)[atom];
  if (definition.stage == Stage::generation) return define_constant(atom);
  const Formula tree = formula(*program_, definition);
  operations_ += count(tree);
  statement(fmt::format("const Scalar {} = {};", local_name(*program_, atom), printer_.print(tree)), definition.name);
}

void FunctionEmitter::define_sines_and_cosines(const Block& block) {
  // How many sines or cosines stand one behind the other before and in each definition.
  std::vector<std::size_t> depth(program_->size(), 0);
  std::vector<bool> live(program_->size(), false);
  std::vector<std::vector<Atom>> passes;
  for (const Atom atom : block.definitions) {
    live[static_cast<std::size_t>(atom)] = true;
    const Definition& definition = (*program_)[atom];
    std::size_t& own = depth[static_cast<std::size_t>(atom)];
    for_each_operand(definition, [&](Atom operand) { own = std::max(own, depth[static_cast<std::size_t>(operand)]); });
    if (!is_trigonometric(definition) || definition.stage == Stage::generation) continue;
    if (++own > passes.size()) passes.emplace_back();
    std::vector<Atom>& pass = passes[own - 1];
    const bool with_partner = std::find(pass.begin(), pass.end(), definition.partner) != pass.end();
    if (!with_partner) pass.push_back(atom);
  }
  for (std::size_t i = 0; i < passes.size(); ++i) {
    std::vector<bool> needed(program_->size(), false);
    for (const Atom atom : passes[i]) needed[static_cast<std::size_t>((*program_)[atom].arguments[0])] = true;
    for (auto each = block.definitions.rbegin(); each != block.definitions.rend(); ++each) {
      if (!needed[static_cast<std::size_t>(*each)]) continue;
      for_each_operand((*program_)[*each], [&](Atom operand) { needed[static_cast<std::size_t>(operand)] = true; });
    }
    for (const Atom atom : block.definitions) {
      if (needed[static_cast<std::size_t>(atom)]) define(atom);
    }
    define_pass(passes[i], i + 1, live);
  }
}

void FunctionEmitter::define_pass(const std::vector<Atom>& pass, std::size_t number, const std::vector<bool>& live) {
  const auto atom_of = [this](Atom atom, Function function) {
    const Definition& definition = (*program_)[atom];
    return definition.function == function ? atom : definition.partner;
  };
  std::string angles;
  for (const Atom atom : pass) {
    const Definition& definition = (*program_)[atom];
    angles += (angles.empty() ? "" : ", ") + local_name(*program_, definition.arguments[0]);
    operations_.sincos_pairs += 1;
    done_[static_cast<std::size_t>(atom)] = true;
    done_[static_cast<std::size_t>(definition.partner)] = true;
  }
  if (pass.size() == 1) {
    const std::string sine = local_name(*program_, atom_of(pass[0], Function::sin));
    const std::string cosine = local_name(*program_, atom_of(pass[0], Function::cos));
    line(fmt::format("Scalar {}, {};", sine, cosine));
    return statement(fmt::format("traits::sincos({}, {}, {});", angles, sine, cosine), (*program_)[pass[0]].name);
  }
  const std::string suffix = number == 1 ? "_" : fmt::format("{}_", number);
  line(fmt::format("const Scalar angles{}[] = {{{}}};", suffix, angles));
  line(fmt::format("Scalar sines{0}[{1}], cosines{0}[{1}];", suffix, pass.size()));
  line(fmt::format("torsor::sines_and_cosines(angles{0}, sines{0}, cosines{0});", suffix));
  for (std::size_t i = 0; i < pass.size(); ++i) {
    std::string locals;
    for (const Function function : {Function::sin, Function::cos}) {
      const Atom atom = atom_of(pass[i], function);
      if (!live[static_cast<std::size_t>(atom)]) continue;
      locals += fmt::format("{} {} = {}{}[{}]", locals.empty() ? "const Scalar" : ",", local_name(*program_, atom),
                            function == Function::sin ? "sines" : "cosines", suffix, i);
    }
    statement(locals + ";", (*program_)[pass[i]].name);
  }
}

void FunctionEmitter::define_constant(Atom atom) {
  const Definition& definition = (*program_)[atom];
  const std::string name = local_name(*program_, atom);
  if (definition.symbol) return line(fmt::format("const Scalar {} = traits::pi();", name));
  if (!definition.function && definition.polynomial.is_constant()) {
    return line(fmt::format("const Scalar {} = {};", name, printer_.print(formula(*program_, definition))));
  }
  const RoundedConstant rounded = rounded_constant(*program_, atom);
  line(fmt::format("const Scalar {} = traits::formula({}, {}, [&]() -> Scalar {{", name, literal(rounded.in_double),
                   literal(rounded.in_float)));
  if (is_trigonometric(definition)) {
    line("  Scalar sine, cosine;");
    line(fmt::format("  traits::sincos({}, sine, cosine);", local_name(*program_, definition.arguments[0])));
    line(fmt::format("  return {};", definition.function == Function::sin ? "sine" : "cosine"));
  } else {
    line(fmt::format("  return {};", printer_.print(formula(*program_, definition))));
  }
  statement("});", definition.name);
}

/// The text that gives a value; a formula that costs something is remembered under the target it is about to be
/// assigned to.
std::string FunctionEmitter::text_of(const Value& value, const std::string& target) {
  repeats_ = false;
  const auto [sum, negative] = without_sign(value.polynomial());
  const auto signed_name = [](const std::string& name, bool minus) { return minus ? "-" + name : name; };
  const Formula tree = formula(*program_, sum);
  const OperationCount cost = count(tree);
  if (cost.total() > 0) {
    if (const auto place = ready_ != nullptr ? ready_->find(sum) : std::nullopt) {
      reads_ready_ = true;
      return signed_name(fmt::format("{}{}", ready_prefix_, *place), negative);
    }
    const auto [place, added] = written_.add(sum);
    repeats_ = !added;
    if (!added) return signed_name(places_[place], negative != place_negative_[place]);
    places_.push_back(target);
    place_negative_.push_back(negative);
    operations_ += cost;
  }
  return negative ? printer_.print_negated(tree) : printer_.print(tree);
}

std::string FunctionEmitter::text(const Polynomial& sum) {
  const auto [positive, negative] = without_sign(sum);
  const Formula tree = formula(*program_, positive);
  if (const auto place = ready_ != nullptr ? ready_->find(positive) : std::nullopt) {
    reads_ready_ = true;
    return fmt::format("{}{}{}", negative ? "-" : "", ready_prefix_, *place);
  }
  operations_ += count(tree);
  return negative ? printer_.print_negated(tree) : printer_.print(tree);
}

void FunctionEmitter::assign(const std::string& target, const Value& value) {
  line(fmt::format("{} = {};", target, text_of(value, target)));
  if (!value.is_constant() && !repeats_) results_.push_back(target);
}

void FunctionEmitter::check_finite(const std::string& target) { results_.push_back(target); }

void FunctionEmitter::return_status(const std::vector<std::pair<Value, Value>>& pivots) {
  const auto operand = [this](const Value& value) {
    const std::size_t before = places_.size();
    const std::string local = fmt::format("y{}", before);
    const std::string text = text_of(value, local);
    if (places_.size() == before) return text;
    line(fmt::format("const Scalar {} = {};", local, text));
    return local;
  };
  std::string condition;
  for (const auto& [pivot, diagonal] : pivots) {
    if (pivot.is_constant() && pivot.polynomial().constant().sign() > 0) continue;  // regular once and for all
    const std::string d = operand(pivot);
    const std::string m = operand(diagonal);
    condition += fmt::format("{}traits::regular({}, {})", condition.empty() ? "" : " && ", d, m);
  }
  if (!condition.empty()) line(fmt::format("if (!({})) return torsor::Status::singular;", condition));
  if (!results_.empty()) {
    const std::string product = zero_times(name(Number()), results_, 0, results_.size());
    line("// 0 x is 0 for every finite x and not a number for any other.");
    line(fmt::format("const Scalar zero = {};", product));
    line(fmt::format("if (!traits::regular({}, zero)) return torsor::Status::not_finite;", name(Number(1))));
  }
  line("return torsor::Status::ok;");
}

FunctionText FunctionEmitter::take() {
  std::string constants;
  for (const FormulaPrinter::Constant& constant : printer_.constants()) {
    constants += wrapped(fmt::format("const Scalar {} = {};", constant.name, constant_call(constant.number)),
                         function_indentation) +
                 "\n";
  }
  return {constants + bindings_ + code_, operations_};
}

}  // namespace torsor
