// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/dynamics/equations/singular_start.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "generator/dynamics/equations/equations.hpp"
#include "generator/mechanics/parameter_value.hpp"
#include "generator/program/evaluation.hpp"

namespace torsor {
namespace {

constexpr int digits_at_start = 50;

using Reals = std::vector<Real>;

/// Coordinates whose rates, in some proportion, move no mass: the first that depends on those before it, with those that
/// it depends on. Nothing where M is regular.
std::optional<std::vector<std::size_t>> idle_rates(std::vector<Reals> m) {
  const std::size_t n = m.size();
  const Real small(Number(10).pow(-30), digits_at_start);
  Reals diagonal;
  for (std::size_t k = 0; k < n; ++k) diagonal.push_back(abs(m[k][k]));
  for (std::size_t k = 0; k < n; ++k) {
    if (!(abs(m[k][k]) > small * diagonal[k])) {
      // The rows above are in echelon form: back substitution for the rates that undo a unit rate of k.
      std::vector<std::size_t> idle{k};
      Reals rates(k, Real(0));
      for (std::size_t i = k; i-- > 0;) {
        Real right = -m[i][k];
        for (std::size_t j = i + 1; j < k; ++j) right -= m[i][j] * rates[j];
        rates[i] = right / m[i][i];
        if (abs(rates[i]) > small) idle.push_back(i);
      }
      std::sort(idle.begin(), idle.end());
      return idle;
    }
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < n; ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> singular_start(const Scene& scene) {
  const SceneContent& content = scene.content();
  const auto valued = [](const ParameterContent& parameter) { return parameter.value.has_value(); };
  if (!std::all_of(content.parameters.begin(), content.parameters.end(), valued)) return {};
  const WorkingDigits precision(digits_at_start);
  const Equations equations(scene);
  if (!equations.massless().empty()) return {};  // singular everywhere, and named by the kernels that this concerns
  Evaluator<Real> evaluate(equations.program(),
                           [&content](const SymbolPointer& symbol) { return initial_value(content, symbol); });
  std::vector<Reals> mass;
  for (const auto& row : equations.mass()) mass.push_back(evaluate(row));
  const auto idle = idle_rates(std::move(mass));
  if (!idle) return {};
  std::string names;
  for (const std::size_t i : *idle) {
    names += (names.empty() ? "'" : i == idle->back() ? " and '" : ", '") + equations.model().coordinates()[i].q->name + "'";
  }
  return {fmt::format("at the initial state {} {} and accelerations are not determined: the coordinates are singular "
                      "there; give the orientation by attitude(...), take another sequence of angles, or start elsewhere",
                      names, idle->size() == 1 ? "moves no mass" : "can change without moving any mass")};
}

}  // namespace torsor
