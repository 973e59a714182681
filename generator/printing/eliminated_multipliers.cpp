// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/eliminated_multipliers.hpp"

#include <algorithm>

namespace torsor::printing {
namespace {

using Rows = std::vector<unsigned>;

/// The columns of the multipliers, as they stand on the right, in those rows.
GiNaC::matrix rows_of(const GiNaC::matrix& columns, const Rows& rows) {
  GiNaC::matrix square(static_cast<unsigned>(rows.size()), columns.cols());
  for (unsigned i = 0; i < rows.size(); ++i) {
    for (unsigned j = 0; j < columns.cols(); ++j) square(i, j) = columns(rows[i], j);
  }
  return square;
}

/// All choices of `count` rows of n, the last ones first: the first coordinates of a scene are the ones that stay.
std::vector<Rows> choices(unsigned n, unsigned count) {
  std::vector<Rows> all;
  for (unsigned bits = (1U << n) - 1; bits > 0; --bits) {
    Rows rows;
    for (unsigned i = 0; i < n; ++i) {
      if ((bits >> i & 1U) != 0) rows.push_back(i);
    }
    if (rows.size() == count) all.push_back(std::move(rows));
  }
  return all;
}

}  // namespace

bool FreeEquations::can_fail() const {
  if (determinant.size() != 1) return true;
  const Product& product = determinant.terms().begin()->first;
  return std::any_of(product.begin(), product.end(), [](const Power& power) {
    return power.base->kind != Base::Kind::symbol || power.base->level > Level::parameter;
  });
}

std::optional<FreeEquations> without_multipliers(LagrangeEquations& equations) {
  constexpr std::size_t most_constraints = 3, most_coordinates = 8;
  const std::vector<LagrangeEquation>& rows = equations.equations();
  std::vector<SymbolPointer> multipliers;  // but those of conditions that hold whatever the motion
  for (const ConstraintEquation& constraint : equations.constraints()) {
    if (!constraint.left.sum || !constraint.left.sum->is_zero()) multipliers.push_back(constraint.multiplier);
  }
  const std::size_t n = rows.size(), m = multipliers.size();
  if (m == 0 || m > most_constraints || m >= n || n > most_coordinates || !equations.written_out()) return std::nullopt;
  if (std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.coordinate.released; })) return std::nullopt;
  InlineView& view = equations.view();
  GiNaC::matrix columns(static_cast<unsigned>(n), static_cast<unsigned>(m));
  std::vector<GiNaC::ex> residuals;
  GiNaC::exmap without;
  for (const ConstraintEquation& constraint : equations.constraints()) without[view.symbol(constraint.multiplier)] = 0;
  for (unsigned i = 0; i < n; ++i) {
    const GiNaC::ex residual = view.expression(*rows[i].inertia.sum) - view.expression(*rows[i].force.sum);
    for (unsigned j = 0; j < m; ++j) {
      const GiNaC::ex multiplier = view.symbol(multipliers[j]);
      columns(i, j) = -residual.diff(GiNaC::ex_to<GiNaC::symbol>(multiplier));
    }
    residuals.push_back(residual.subs(without));
  }
  // The rows with the shortest determinant that is not zero.
  std::optional<Rows> dependent;
  Sum of_dependent;
  for (const Rows& choice : choices(static_cast<unsigned>(n), static_cast<unsigned>(m))) {
    const Sum determinant = view.sum(rows_of(columns, choice).determinant());
    if (determinant.is_zero() || (dependent && determinant.size() >= of_dependent.size())) continue;
    dependent = choice;
    of_dependent = determinant;
  }
  if (!dependent) return std::nullopt;
  const GiNaC::matrix inverse = rows_of(columns, *dependent).inverse();
  FreeEquations result;
  result.determinant = of_dependent;
  for (const unsigned i : *dependent) result.dependent.push_back(rows[i].coordinate.q->name);
  for (unsigned i = 0; i < n; ++i) {
    if (std::find(dependent->begin(), dependent->end(), i) != dependent->end()) continue;
    const GiNaC::matrix share = rows_of(columns, {i}).mul(inverse);
    GiNaC::ex left = residuals[i];
    for (unsigned k = 0; k < m; ++k) left -= share(0, k) * residuals[(*dependent)[k]];
    std::optional<Sum> sum = view.bounded_sum(left);
    if (!sum) return std::nullopt;
    result.equations.push_back({rows[i].coordinate, std::move(*sum)});
  }
  return result;
}

}  // namespace torsor::printing
