// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/schedule.hpp"

#include "torsor/generator/program/formula.hpp"

namespace torsor {
namespace {

/// Goes backwards through the program from some sums and stops at what is given.
template <class IsGiven>
Block collect(const Program& program, const std::vector<Polynomial>& roots, const IsGiven& is_given) {
  std::vector<bool> needed(program.size(), false);
  const auto mark = [&needed](const Polynomial& polynomial) {
    for (const Term& term : polynomial.terms()) {
      for (const Factor& factor : term.monomial) needed[static_cast<std::size_t>(factor.value_number)] = true;
    }
  };
  for (const Polynomial& root : roots) mark(root);
  for (std::size_t k = program.size(); k-- > 0;) {
    const auto value_number = static_cast<ValueNumber>(k);
    if (!needed[k] || is_given(value_number)) continue;
    mark(program[value_number].polynomial);
    for (const ValueNumber argument : program[value_number].arguments)
      needed[static_cast<std::size_t>(argument)] = true;
  }
  Block block;
  for (std::size_t k = 0; k < program.size(); ++k) {
    const auto value_number = static_cast<ValueNumber>(k);
    if (!needed[k]) continue;
    const SymbolPointer& symbol = program[value_number].symbol;
    if (symbol && symbol->kind != SymbolKind::pi)
      block.symbols.push_back(value_number);
    else if (is_given(value_number))
      block.given.push_back(value_number);
    else
      block.definitions.push_back(value_number);
  }
  return block;
}

Stage stage_of(const Program& program, const Polynomial& polynomial) {
  Stage latest = Stage::generation;
  for (const Term& term : polynomial.terms()) {
    for (const Factor& factor : term.monomial) latest = std::max(latest, program[factor.value_number].stage);
  }
  return latest;
}

}  // namespace

Block whole_block(const Program& program, const std::vector<Polynomial>& sums) {
  return collect(program, sums, [](ValueNumber) { return false; });
}

Schedule make_schedule(const Program& program, const std::vector<Value>& values) {
  Schedule schedule;
  const auto is_precomputed = [&program](ValueNumber value_number) {
    return !program[value_number].symbol && program[value_number].stage == Stage::parameters;
  };
  std::vector<Polynomial> roots;
  for (const Value& value : values) {
    auto [sum, negative] = without_sign(value.polynomial());
    const bool once = stage_of(program, sum) == Stage::parameters && count(formula(program, sum)).total() > 0;
    if (once)
      schedule.results.add(sum);
    else
      roots.push_back(std::move(sum));
  }
  schedule.function = collect(program, roots, is_precomputed);
  schedule.members = schedule.function.given;
  std::vector<Polynomial> members = schedule.results.sums();
  for (const ValueNumber value_number : schedule.members) members.emplace_back(value_number);
  schedule.precompute = whole_block(program, members);
  return schedule;
}

}  // namespace torsor
