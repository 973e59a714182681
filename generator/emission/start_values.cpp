// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/emission/start_values.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "generator/emission/cpp_emitter.hpp"
#include "generator/emission/cpp_names.hpp"
#include "generator/expression/error.hpp"

namespace torsor {
namespace {

struct StartValue {
  std::string target;
  Value value;
};

Block block_of(const Program& program, const std::vector<StartValue>& entries) {
  std::vector<Polynomial> sums;
  for (const StartValue& entry : entries) sums.push_back(without_sign(entry.value.polynomial()).first);
  return whole_block(program, sums);
}

/// A plain number is understood in the parameter's own unit.
Expression value_in_unit(const ParameterContent& parameter) {
  const bool plain = parameter.value->unit().is_dimensionless();
  return plain ? *parameter.value * Expression::quantity(Number(1), parameter.symbol->unit) : *parameter.value;
}

}  // namespace

std::string default_parameters_body(const Scene& scene, const std::vector<SymbolPointer>& parameters) {
  const std::vector<ParameterContent>& all = scene.content().parameters;
  Program program([&all](const SymbolPointer& symbol) -> std::optional<Expression> {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const ParameterContent& each) { return each.symbol == symbol; });
    if (found == all.end() || !found->value) return std::nullopt;
    return value_in_unit(*found);
  });
  std::vector<StartValue> given;
  std::vector<std::string> missing;
  for (const SymbolPointer& symbol : parameters) {
    const Value value = program.symbol(symbol);
    const std::string target = "parameters." + symbol->name;
    if (program.stage(value) == Stage::generation)
      given.push_back({target, value});
    else
      missing.push_back(target);
  }
  FunctionEmitter emitter(program, "parameters.");
  emitter.compute(block_of(program, given));
  for (const StartValue& entry : given) emitter.assign(entry.target, entry.value);
  const std::string zero = missing.empty() ? "" : emitter.name(Number());
  for (const std::string& target : missing) {
    emitter.line(fmt::format("{} = {} / {};  // has no default: not a number until it is set", target, zero, zero));
  }
  return emitter.take().body;
}

InitialState initial_state(const Equations& equations, const ModelOptions& options) {
  Program program(Model::resolver(equations.scene(), options));
  std::vector<StartValue> entries;
  const Model& model = equations.model();
  const SceneContent& content = equations.scene().content();
  const auto add = [&](const std::string& target, const std::optional<Expression>& given) {
    entries.push_back({target, given ? program.lower(*given) : program.number(Number())});
  };
  for (const SymbolPointer& position : model.positions()) {
    const std::string target = "state.q." + position->name;
    if (const auto component = content.quaternion_component(position)) {
      add(target, initial_component(content.attitudes[component->first], component->second));
    }
    for (const CoordinateContent& c : model.coordinates()) {
      if (c.q == position) add(target, c.initial_value);
    }
  }
  for (int i = 0; i < model.unknown_count(); ++i) {
    const CoordinateContent& c = model.coordinates()[static_cast<std::size_t>(i)];
    add("state.v." + c.q->name, c.initial_rate);
  }
  const Block block = block_of(program, entries);
  for (const Atom atom : block.symbols) {
    if (program[atom].symbol->kind == SymbolKind::parameter) continue;
    throw SceneError(
        fmt::format("the initial state of the scene '{}' depends on '{}': give it by numbers and parameters",
                    equations.scene().name(), program[atom].symbol->name));
  }
  FunctionEmitter emitter(program, "parameters.");
  emitter.compute(block);
  emitter.line(fmt::format("state.time = {};", emitter.name(Number())));
  for (const StartValue& entry : entries) emitter.assign(entry.target, entry.value);
  return {emitter.take().body, !block.symbols.empty()};
}

}  // namespace torsor
