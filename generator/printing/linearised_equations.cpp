// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/linearised_equations.hpp"

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/derivatives/linearisation.hpp"
#include "torsor/generator/printing/formula_text.hpp"
#include "torsor/generator/printing/written_at_state.hpp"
#include "torsor/generator/program/division_by_zero.hpp"

namespace torsor::printing {
namespace {

/// The symbol of a state that a name means: q, q' or q''.
SymbolPointer state_symbol(const Scene& scene, const std::string& name) {
  std::vector<std::string> known;
  for (const CoordinateContent& c : scene.content().coordinates) {
    if (!c.unknown()) continue;
    for (const SymbolPointer& symbol : symbols_of(c)) {
      if (symbol->name == name) return symbol;
    }
    known.push_back(symbols_of(c).front()->name);
  }
  throw UsageError(
      fmt::format("'{}' is no coordinate or velocity to linearise about: {}the unknowns are {} (a velocity "
                  "is written with a prime)",
                  name, did_you_mean(name, known), fmt::join(known, ", ")));
}

/// What replaces the symbols of the state; accelerations vanish unless they are given.
GiNaC::exmap state(LagrangeEquations& equations, const Scene& scene, const About& about) {
  InlineView& view = equations.view();
  GiNaC::exmap map;
  for (const CoordinateContent& c : scene.content().coordinates) {
    if (!c.unknown()) continue;
    map[view.symbol(c.a)] = 0;
    if (!about.empty()) map[view.symbol(c.v)] = 0;
  }
  for (const auto& [symbol, value] : named_state(scene, about)) {
    const std::optional<GiNaC::ex> written = view.expression(equations.program().lower(value));
    if (!written) throw UsageError(fmt::format("the state {} = {} is too long to be written out", symbol->name, value.to_string()));
    map[view.symbol(symbol)] = *written;
  }
  return map;
}

}  // namespace

StateValues named_state(const Scene& scene, const About& about) {
  StateValues state;
  for (const auto& [name, formula] : about) {
    const SymbolPointer symbol = state_symbol(scene, name);
    const Expression parsed = parse_formula(formula, scene);
    const bool number = parsed.unit() == Unit();
    if (!number && !(parsed.unit() == symbol->unit)) {
      throw UnitError(fmt::format("the state {} = {} has the unit {} and must be in {}", name, formula,
                                  parsed.unit().to_string(), symbol->unit.to_string()));
    }
    state.emplace_back(symbol, number && !(symbol->unit == Unit()) ? parsed * Expression::quantity(Number(1), symbol->unit) : parsed);
  }
  refuse_values_of_each_other(state);
  return state;
}

namespace {

LinearisedEquations matrices(LagrangeEquations& equations, const Scene& scene, const About& about) {
  InlineView& view = equations.view();
  const GiNaC::exmap at = state(equations, scene, about);
  GiNaC::exmap without_inputs;
  std::vector<GiNaC::ex> inputs;
  for (const ActionContent& action : scene.content().actions) {
    if (const auto* motor = std::get_if<Motor>(&action)) {
      inputs.push_back(view.symbol(motor->input));
      without_inputs[inputs.back()] = 0;
    }
  }
  const auto partial = [&](const GiNaC::ex& residual, const GiNaC::ex& symbol) {
    return view.sum(residual.diff(GiNaC::ex_to<GiNaC::symbol>(symbol)).subs(at));
  };
  LinearisedEquations result;
  for (const LagrangeEquation& row : equations.equations()) {
    if (row.coordinate.released) continue;
    const GiNaC::ex residual = view.expression(*row.inertia.sum) - view.expression(*row.force.sum);
    std::vector<Sum> m, c, k, e;
    for (const LagrangeEquation& column : equations.equations()) {
      if (column.coordinate.released) continue;
      m.push_back(partial(residual, view.symbol(column.coordinate.a)));
      c.push_back(partial(residual, view.symbol(column.coordinate.v)));
      k.push_back(view.sum(equations.along(residual, column.coordinate).subs(at)));
    }
    for (const GiNaC::ex& input : inputs) e.push_back(partial(-residual, input));
    result.M.push_back(std::move(m));
    result.C.push_back(std::move(c));
    result.K.push_back(std::move(k));
    result.E.push_back(std::move(e));
    const GiNaC::ex force = -residual;
    result.F.push_back(view.sum((inputs.empty() ? force : force.subs(without_inputs)).subs(at)));
  }
  return result;
}

/// By the program, which knows the limits that GiNaC's division by zero hides; nothing where an entry is too long.
std::optional<LinearisedEquations> limits(LagrangeEquations& equations, const Scene& scene, const About& about) {
  const Equations& definitions = equations.definitions();
  const Linearisation linear = linearisation(definitions);
  WrittenAtState write(scene, definitions, equations.view().limits(), about);
  LinearisedEquations result{write(linear.M), write(linear.C), write(linear.K), write(linear.E),
                             write(without_inputs(definitions, linear.F, linear.E))};
  if (write.too_long()) return std::nullopt;
  return result;
}

}  // namespace

LinearisedEquations linearised(LagrangeEquations& equations, const Scene& scene, const About& about) {
  try {
    return matrices(equations, scene, about);
  } catch (const GiNaC::pole_error&) {  // a limit may exist
  } catch (const DivisionByZero&) {
    throw UsageError(no_value_at_state);
  }
  try {
    if (const std::optional<LinearisedEquations> result = limits(equations, scene, about)) return *result;
  } catch (const GiNaC::pole_error&) {
    throw UsageError(no_value_at_state);
  } catch (const DivisionByZero&) {
    throw UsageError(no_value_at_state);
  }
  throw UsageError("the linearised equations about this state are too long to be written out");
}

}  // namespace torsor::printing
