// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/start_values.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/listing/lowering.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"

namespace torsor {
namespace {

Block block_of(const Program& program, const std::vector<Assignment>& results) {
  std::vector<Polynomial> sums;
  for (const Assignment& each : results) sums.push_back(without_sign(each.value.polynomial()).first);
  return whole_block(program, sums);
}

/// A plain number is understood in the parameter's own unit.
Expression value_in_unit(const ParameterContent& parameter) {
  const bool plain = parameter.value->unit().is_dimensionless();
  return plain ? *parameter.value * Expression::quantity(Number(1), parameter.symbol->unit) : *parameter.value;
}

}  // namespace

Listing default_parameters(const Scene& scene, const std::vector<SymbolPointer>& parameters) {
  const std::vector<ParameterContent>& all = scene.content().parameters;
  Program program([&all](const SymbolPointer& symbol) -> std::optional<Expression> {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const ParameterContent& each) { return each.symbol == symbol; });
    if (found == all.end() || !found->value) return std::nullopt;
    return value_in_unit(*found);
  });
  std::vector<Assignment> given;
  std::vector<Target> missing;
  for (const SymbolPointer& symbol : parameters) {
    const Value value = program.symbol(symbol);
    const auto parameter = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.symbol == symbol; });
    if (parameter != all.end()) require_double(scene.content(), *parameter);
    const Target target{"parameters", symbol->name};
    if (program.stage(value) == Stage::generation)
      given.push_back({target, value});
    else
      missing.push_back(target);
  }
  Listing listing = lower(program, block_of(program, given), {given}, {});
  Formula not_a_number;
  not_a_number.kind = Formula::Kind::quotient;
  not_a_number.children.assign(2, Formula::of_number(Number()));
  for (const Target& target : missing) {
    listing.outputs.push_back({target, {not_a_number}, false, "has no default: not a number until it is set"});
  }
  return listing;
}

Listing initial_state(const Equations& equations, const ModelOptions& options, const Layout& layout) {
  Program program(Model::resolver(equations.scene(), options));
  std::vector<Assignment> results{{{"state", "time"}, program.number(Number())}};
  const Model& model = equations.model();
  const SceneContent& content = equations.scene().content();
  const auto add = [&](const Target& target, const std::optional<Expression>& given) {
    results.push_back({target, given ? program.lower(*given) : program.number(Number())});
  };
  const std::vector<SymbolPointer> positions = model.positions();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Target target{"state", "q", i};
    if (const auto component = content.quaternion_component(positions[i])) {
      add(target, initial_component(content.attitudes[component->first], component->second));
    }
    for (const CoordinateContent& c : model.coordinates()) {
      if (c.q == positions[i]) add(target, c.initial_value);
    }
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.unknown_count()); ++i) {
    add({"state", "v", i}, model.coordinates()[i].initial_rate);
  }
  const Block block = block_of(program, results);
  for (const ValueNumber value_number : block.symbols) {
    if (program[value_number].symbol->kind == SymbolKind::parameter) continue;
    throw SceneError(
        fmt::format("the initial state of the scene '{}' depends on '{}': give it by numbers and parameters",
                    equations.scene().name(), program[value_number].symbol->name));
  }
  return lower(program, block, {results}, {&layout, nullptr, "initial_state"});
}

}  // namespace torsor
