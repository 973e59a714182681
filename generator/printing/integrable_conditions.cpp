// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/integrable_conditions.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "torsor/generator/base/linear_algebra/row_reduction.hpp"
#include "torsor/generator/printing/factoring.hpp"

namespace torsor::printing {
namespace {

/// A quotient of polynomials of parameters, in lowest terms.
class Ratio {
 public:
  explicit Ratio(int number) : value_(number) {}
  explicit Ratio(const GiNaC::ex& value) : value_(value.normal()) {}

  const GiNaC::ex& value() const { return value_; }
  bool is_zero() const { return value_.is_zero(); }
  Ratio operator-() const { return Ratio(-value_); }
  Ratio& operator-=(const Ratio& other) { return *this = Ratio(value_ - other.value_); }
  Ratio& operator/=(const Ratio& other) { return *this = Ratio(value_ / other.value_); }
  friend Ratio operator*(const Ratio& a, const Ratio& b) { return Ratio(a.value_ * b.value_); }

 private:
  GiNaC::ex value_;
};

/// What multiplies a velocity in a constraint: a function of the configuration and time, or none.
struct Place {
  const CoordinateContent* coordinate = nullptr;  ///< null of what multiplies no velocity
  Product configuration;
};
struct PlaceOrder {
  bool operator()(const Place& a, const Place& b) const {
    const auto index = [](const Place& place) {
      return place.coordinate ? std::optional(place.coordinate->v->index) : std::nullopt;
    };
    const auto i = index(a), j = index(b);  // none comes first
    return i != j ? i < j : compare(a.configuration, b.configuration) < 0;
  }
};
/// Where the factors of parameters in a constraint stand.
using Coefficients = std::map<Place, Sum, PlaceOrder>;

/// Nothing where it is no sum of velocities times factors.
std::optional<Coefficients> coefficients(const Sum& left, LagrangeEquations& equations) {
  // Rates of driven coordinates are functions of time.
  const auto is_driven = [&](const Base& base) { return base.kind == Base::Kind::symbol && equations.view().law(base.symbol); };
  Coefficients result;
  for (const auto& [product, number] : left.terms()) {
    Place place;
    Product factor;
    for (const Power& power : product) {
      if (power.base->level <= Level::definition) {
        factor.push_back(power);
      } else if (power.base->level == Level::configuration || is_driven(*power.base)) {
        place.configuration.push_back(power);
      } else {
        if (power.base->kind != Base::Kind::symbol || power.halves != 2) return std::nullopt;
        for (const LagrangeEquation& equation : equations.equations()) {
          if (equation.coordinate.v == power.base->symbol) place.coordinate = &equation.coordinate;
        }
        if (!place.coordinate) return std::nullopt;
      }
    }
    result[place].add(factor, number);
  }
  return result;
}

/// An entry that must vanish in a combination that can be integrated at sight.
bool must_vanish(const Place& place) {
  return !place.coordinate || place.coordinate->attitude || !place.configuration.empty();
}

/// Combinations that leave no entry of these rows; none where the rows are too many to be looked through.
Rows<Ratio> combinations(const Rows<Ratio>& rows, std::size_t columns) {
  constexpr std::size_t most_rows = 300;
  if (rows.size() > most_rows) return {};
  RowReduction<Ratio> reduction({}, columns);
  for (const std::vector<Ratio>& row : rows) {
    Rows<Ratio> independent = reduction.reduced();
    independent.push_back(row);
    reduction = RowReduction<Ratio>(std::move(independent), columns);
    for (std::size_t column = 0; column < columns; ++column) {
      for (const std::size_t left : reduction.rows_left()) {
        if (reduction(left, column).is_zero()) continue;
        reduction.take({left, column});
        break;
      }
    }
    if (reduction.rank() == columns) return {};
  }
  return reduction.null_space();
}

/// Without common factors and denominators.
std::vector<GiNaC::ex> primitive(std::vector<GiNaC::ex> values) {
  GiNaC::exmap names;
  GiNaC::ex denominator = 1, factor = 0;
  for (GiNaC::ex& value : values) {
    value = value.to_rational(names).normal();
    denominator = GiNaC::lcm(denominator, value.denom());
  }
  for (GiNaC::ex& value : values) {
    value = (value * denominator).normal();
    factor = GiNaC::gcd(factor, value);
  }
  for (GiNaC::ex& value : values) value = (value / factor).normal().subs(names, GiNaC::subs_options::no_pattern);
  return values;
}

/// Σ λ_k of some constraints, integrated; nothing where they only repeat each other.
std::optional<Sum> integrated(const std::map<Place, std::vector<Ratio>, PlaceOrder>& entries, const std::vector<Ratio>& combination,
                              InlineView& view) {
  std::vector<SymbolPointer> coordinates;
  std::vector<GiNaC::ex> factors;
  for (const auto& [place, row] : entries) {
    if (must_vanish(place)) continue;
    GiNaC::ex factor = 0;
    for (std::size_t k = 0; k < row.size(); ++k) factor += combination[k].value() * row[k].value();
    factor = factor.normal();
    if (view.sum(factor).is_zero()) continue;
    coordinates.push_back(place.coordinate->q);
    factors.push_back(factor);
  }
  if (factors.empty()) return std::nullopt;
  factors = primitive(std::move(factors));
  Sum constant;
  for (std::size_t i = 0; i < factors.size(); ++i) constant += view.sum(factors[i]) * Sum::symbol(coordinates[i]);
  if (constant.is_zero()) return std::nullopt;
  const bool negative = constant.terms().begin()->second.sign() < 0;
  return (Number(negative ? -1 : 1) / shared_number(constant)) * constant;
}

}  // namespace

std::vector<IntegrableCondition> integrable_conditions(LagrangeEquations& equations) {
  constexpr std::size_t most_combined = 12;
  std::vector<std::string> names;
  std::vector<Coefficients> constraints;
  for (const ConstraintEquation& constraint : equations.constraints()) {
    if (constraint.holonomic || !constraint.left.sum || constraint.left.sum->is_zero()) continue;
    std::optional<Coefficients> of = coefficients(*constraint.left.sum, equations);
    if (!of) continue;
    names.push_back(constraint.name);
    constraints.push_back(std::move(*of));
  }

  // Those that are integrable alone need no others; the others are combined.
  std::vector<std::vector<std::size_t>> groups;
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < constraints.size(); ++k) {
    const auto& of = constraints[k];
    const bool alone = std::none_of(of.begin(), of.end(), [](const auto& entry) { return must_vanish(entry.first); });
    if (alone) groups.push_back({k});
    if (!alone) others.push_back(k);
  }
  if (others.size() > 1 && others.size() <= most_combined) groups.push_back(others);

  std::vector<IntegrableCondition> conditions;
  for (const std::vector<std::size_t>& group : groups) {
    std::map<Place, std::vector<Ratio>, PlaceOrder> entries;
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (const auto& [place, factor] : constraints[group[i]]) {
        const std::vector<Ratio> empty(group.size(), Ratio(0));
        entries.try_emplace(place, empty).first->second[i] = Ratio(equations.view().expression(factor));
      }
    }
    Rows<Ratio> to_vanish;
    for (const auto& [place, row] : entries) {
      if (must_vanish(place)) to_vanish.push_back(row);
    }
    for (const std::vector<Ratio>& combination : combinations(to_vanish, group.size())) {
      std::optional<Sum> constant = integrated(entries, combination, equations.view());
      if (!constant) continue;
      IntegrableCondition condition{{}, std::move(*constant)};
      for (std::size_t i = 0; i < group.size(); ++i) {
        if (!combination[i].is_zero()) condition.constraints.push_back(names[group[i]]);
      }
      conditions.push_back(std::move(condition));
    }
  }
  return conditions;
}

}  // namespace torsor::printing
