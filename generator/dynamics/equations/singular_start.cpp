// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/singular_start.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/linear_algebra/symmetric_pivots.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor {
namespace {

/// Coordinates whose rates, in some proportion, move no mass: the first that depends on those before it, with those that
/// it depends on. None where M is regular.
std::vector<std::size_t> idle_rates(RealRows mass) {
  const Real small = zero_tests::masses_at_start.bound();
  const SymmetricPivots pivots(std::move(mass), small);
  const std::size_t k = pivots.first_small();
  if (k == pivots.size()) return {};
  const RealRow rates = pivots.dependence();
  std::vector<std::size_t> idle;
  for (std::size_t i = 0; i < k; ++i) {
    if (abs(rates[i]) > small) idle.push_back(i);
  }
  idle.push_back(k);
  return idle;
}

}  // namespace

std::vector<std::string> singular_start(const Scene& scene) {
  const SceneContent& content = scene.content();
  const auto valued = [](const ParameterContent& parameter) { return parameter.value.has_value(); };
  if (!std::all_of(content.parameters.begin(), content.parameters.end(), valued)) return {};
  const WorkingDigits precision(zero_tests::masses_at_start.digits);
  const Equations equations(scene);
  if (!equations.massless().empty()) return {};  // singular everywhere, and named by the kernels that this concerns
  Evaluator<Real> evaluate(equations.program(),
                           [&content](const SymbolPointer& symbol) { return initial_value(content, symbol); });
  RealRows mass;
  for (const auto& row : equations.mass()) mass.push_back(evaluate(row));
  const std::vector<std::size_t> idle = idle_rates(std::move(mass));
  if (idle.empty()) return {};
  std::string names;
  for (const std::size_t i : idle) {
    names += (names.empty() ? "'" : i == idle.back() ? " and '" : ", '") + equations.model().coordinates()[i].q->name + "'";
  }
  return {fmt::format("at the initial state {} {} and accelerations are not determined: the coordinates are singular "
                      "there; give the orientation by attitude(...), take another sequence of angles, or start elsewhere",
                      names, idle.size() == 1 ? "moves no mass" : "can change without moving any mass")};
}

}  // namespace torsor
