// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/evaluated_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/cholesky.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/dynamics/equations/massless.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

std::set<std::string> names_of(const NamedNumbers& numbers) {
  std::set<std::string> names;
  for (const auto& [name, value] : numbers) names.insert(name);
  return names;
}

ModelOptions with_run_time(ModelOptions options, const NamedNumbers& parameters) {
  options.run_time.merge(names_of(parameters));
  return options;
}

/// Of a symmetric matrix, that of 1 where it is not positive.
Cholesky<double> metric_factor(Rows<double> m) {
  const std::size_t n = m.size();
  const Cholesky<double> factor(std::move(m), 1e-14);
  return factor.positive() ? factor : Cholesky<double>(beside_identity(Rows<double>(n), 0));
}

double euclidean(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// What is less than this part of a row is rounding.
constexpr double rank_tolerance = zero_tests::constraint_part;

bool finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

void require_known(const NamedNumbers& given, const std::vector<std::string>& known, const std::string& what,
                   const std::string& option) {
  for (const auto& [name, value] : given) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw UsageError(fmt::format("there is no {} '{}' for {}: {}there {}", what, name, option, did_you_mean(name, known),
                                 known.empty() ? "are none" : fmt::format("are {}", fmt::join(known, ", "))));
  }
}

void require_whole_quaternions(const SceneContent& scene, const NamedNumbers& given) {
  for (const AttitudeContent& attitude : scene.attitudes) {
    std::vector<std::string> missing;
    for (const SymbolPointer& component : attitude.symbols->e) {
      if (!given.contains(component->name)) missing.push_back(component->name);
    }
    if (missing.empty() || missing.size() == attitude.symbols->e.size()) continue;
    throw UsageError(fmt::format("--initial gives some components of the attitude '{}' without {}: give all four, which are "
                                 "normalised, or none",
                                 attitude.name, fmt::join(missing, ", ")));
  }
}

EvaluatedMotion::EvaluatedMotion(const Scene& scene, const ModelOptions& options, const NamedNumbers& parameters,
                                 const NamedNumbers& inputs)
    : equations_(scene, with_run_time(options, parameters)), here_(equations_.program(), {}) {
  const Model& model = equations_.model();
  const SceneContent& content = scene.content();
  Program& program = equations_.program();
  symbols_ = model.positions();
  position_count_ = symbols_.size();
  for (std::size_t i = 0; i < position_count_; ++i) {
    const auto attitude = symbols_[i]->attitude.lock();
    if (attitude && attitude->e[0] == symbols_[i]) quaternions_.push_back(i);
    position_rates_.push_back(rate_of(program, symbols_[i]));
  }
  for (int i = 0; i < model.unknown_count(); ++i) symbols_.push_back(model.coordinates()[static_cast<std::size_t>(i)].v);

  std::vector<std::string> known;
  for (const ParameterContent& parameter : content.parameters) known.push_back(parameter.symbol->name);
  require_known(parameters, known, "parameter", "--run-time");
  known.clear();
  for (const SymbolPointer& input : model.inputs()) known.push_back(input->name);
  require_known(inputs, known, "input", "--input");
  for (const SymbolPointer& input : model.inputs()) {
    const auto given = inputs.find(input->name);
    values_[input.get()] = given == inputs.end() ? 0.0 : given->second;
  }
  values_[content.time.get()] = 0.0;
  for (const CoordinateContent& c : content.coordinates) {
    if (!c.released) continue;
    for (const SymbolPointer& held : {c.q, c.v, c.a}) values_[held.get()] = 0.0;
  }
  for (const ParameterContent& parameter : content.parameters) {
    const auto given = parameters.find(parameter.symbol->name);
    if (given == parameters.end() && !parameter.value) {
      throw UsageError(fmt::format("the parameter '{0}' has no value: give --run-time {0}=VALUE", parameter.symbol->name));
    }
    move_to(0.0, {});
    values_[parameter.symbol.get()] =
        given != parameters.end() ? given->second : here_(program.lower(*parameter.value));
  }
  for (const auto& [name, value] : parameters) {
    if (!std::isfinite(value)) throw UsageError(fmt::format("--run-time {} is not a finite number", name));
  }

  if (const std::string reason = why_absent("forward_dynamics", equations_); !reason.empty()) {
    throw SceneError(fmt::format("the scene '{}' cannot be simulated: {}", scene.name(), reason));
  }
  forward_ = make_kernel("forward_dynamics", equations_);
  energy_ = make_kernel("energy", equations_);
  integrals_ = make_kernel("first_integrals", equations_);
  // The formula of a definition is made once, of any other value at each state.
  for (PivotTest& test : forward_.pivots) {
    test.pivot = program.bind(test.pivot);
    test.measure = program.bind(test.measure);
  }
  for (Kernel* kernel : {&forward_, &energy_, &integrals_}) {
    for (Assignment& each : kernel->assignments) each.value = program.bind(each.value);
  }
  for (const std::vector<Value>& row : equations_.mass()) {
    mass_.emplace_back();
    for (const Value& entry : row) mass_.back().push_back(program.bind(entry));
  }
  for (Value& rate : position_rates_) rate = program.bind(rate);
  for (const PivotTest& test : forward_.pivots) ready_pivots_.push_back({ready(test.pivot), ready(test.measure)});
  for (std::size_t i = 0; i < velocity_count(); ++i) ready_accelerations_.push_back(ready(forward_.assignments[i].value));
  for (const Value& rate : position_rates_) ready_rates_.push_back(ready(rate));
  for (const std::vector<Value>& row : mass_) {
    ready_mass_.emplace_back();
    for (const Value& entry : row) ready_mass_.back().push_back(ready(entry));
  }
  rows_ = equations_.constraints();
  for (ConstraintRow& row : rows_) {
    row.value = program.bind(row.value);
    row.rate = program.bind(row.rate);
    for (Value& entry : row.jacobian) entry = program.bind(entry);
  }
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    // What holds in any case is rounding in double, and has neither a direction nor a size.
    const auto vanishes = [](const Value& entry) { return identically_zero(entry); };
    if (std::all_of(rows_[j].jacobian.begin(), rows_[j].jacobian.end(), vanishes) && vanishes(rows_[j].value)) continue;
    all_.push_back(j);
    if (rows_[j].holonomic) holonomic_.push_back(j);
  }
}

void EvaluatedMotion::move_to(double t, const std::vector<double>& y) {
  values_[equations_.scene().content().time.get()] = t;
  for (std::size_t i = 0; i < y.size(); ++i) values_[symbols_[i].get()] = y[i];
  here_.move_to([this](const SymbolPointer& symbol) {
    if (symbol->kind == SymbolKind::pi) return std::numbers::pi;
    const auto place = values_.find(symbol.get());
    if (place != values_.end()) return place->second;
    throw SceneError(fmt::format("the motion of '{}' needs '{}', which is no part of its state: give formulas of coordinates, "
                                 "their rates, time and parameters",
                                 equations_.scene().name(), symbol->name));
  });
}

std::vector<double> EvaluatedMotion::start(const NamedNumbers& replaced) {
  const SceneContent& content = equations_.scene().content();
  Program& program = equations_.program();
  std::vector<std::string> known;
  for (const SymbolPointer& symbol : symbols_) known.push_back(symbol->name);
  require_known(replaced, known, "coordinate or rate", "--initial");
  require_whole_quaternions(content, replaced);
  move_to(0.0, {});
  std::vector<double> y;
  for (const SymbolPointer& symbol : symbols_) {
    double value = 0.0;
    if (const auto component = content.quaternion_component(symbol)) {
      value = here_(program.lower(initial_component(content.attitudes[component->first], component->second)));
    }
    for (const CoordinateContent& c : equations_.model().coordinates()) {
      if (c.q == symbol && c.initial_value) value = here_(program.lower(*c.initial_value));
      if (c.v == symbol && c.initial_rate) value = here_(program.lower(*c.initial_rate));
    }
    const auto given = replaced.find(symbol->name);
    y.push_back(given == replaced.end() ? value : given->second);
  }
  normalise(y);
  if (!finite(y)) throw UsageError("--initial must leave finite numbers, and a quaternion that is not zero");
  return y;
}

bool EvaluatedMotion::slope(double t, const std::vector<double>& y, std::vector<double>& rates) {
  move_to(t, y);
  lost_ = nullptr;
  const std::vector<std::size_t>& kept = equations_.redundancy().kept;
  for (std::size_t k = 0; k < forward_.pivots.size(); ++k) {
    const PivotTest& test = forward_.pivots[k];
    const double pivot = here_(ready_pivots_[k].pivot), measure = std::abs(here_(ready_pivots_[k].measure));
    constexpr double one = std::numeric_limits<double>::epsilon();
    if (pivot > (test.of_several_rows ? many_roundings::in_double : 1) * one * measure) continue;
    if (!test.of_several_rows) return false;
    // Other rows of its unit may be larger than this one ever is. Pivots of rows come last, those of constraints kept in order.
    const std::size_t j = kept[k + kept.size() - forward_.pivots.size()];
    if (usual_.empty()) look_around(t, y);
    Rows<double> mass;
    for (const std::vector<Value>& row : mass_) mass.push_back(here_(row));
    const std::vector<double> usual = metric_factor(std::move(mass)).forward(usual_[j]);
    if (pivot > many_roundings::in_double * one * euclidean(usual, usual)) continue;
    lost_ = &rows_[j];
    return false;
  }
  for (std::size_t i = 0; i < position_count_; ++i) rates[i] = here_(ready_rates_[i]);
  for (std::size_t i = 0; i < velocity_count(); ++i) rates[position_count_ + i] = here_(ready_accelerations_[i]);
  return finite(rates);
}

void EvaluatedMotion::normalise(std::vector<double>& y) const {
  for (const std::size_t first : quaternions_) {
    const double norm = std::hypot(std::hypot(y[first], y[first + 1]), std::hypot(y[first + 2], y[first + 3]));
    for (std::size_t i = first; i < first + 4; ++i) y[i] /= norm;
  }
}

void EvaluatedMotion::displace(double t, std::vector<double>& y, const std::vector<double>& change) {
  std::vector<double> turning = y;
  std::copy(change.begin(), change.end(), turning.begin() + static_cast<std::ptrdiff_t>(position_count_));
  move_to(t, turning);
  for (std::size_t i = 0; i < position_count_; ++i) y[i] += here_(position_rates_[i]);
  normalise(y);
  move_to(t, y);
}

// Sizes that the entries of rows have here and at three states around.
void EvaluatedMotion::look_around(double t, const std::vector<double>& y) {
  for (int k = 0; k < 4; ++k) {
    std::vector<double> there = y;
    for (std::size_t i = 0; i < position_count_; ++i) {
      double size = symbols_[i]->unit.is_dimensionless() || symbols_[i]->unit == units::radian ? 1.0 : 0.0;
      for (std::size_t j = 0; j < position_count_ && size < 1; ++j) {
        if (symbols_[j]->unit == symbols_[i]->unit) size = std::max(size, std::abs(y[j]));
      }
      there[i] += k * 0.2 * size * std::sin(1.0 + k + 2.7 * static_cast<double>(i));
    }
    normalise(there);
    move_to(t, there);
    usual_.resize(rows_.size(), std::vector<double>(velocity_count(), 0.0));
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      const std::vector<double> entries = here_(rows_[j].jacobian);
      for (std::size_t i = 0; i < entries.size(); ++i) {
        if (std::isfinite(entries[i])) usual_[j][i] = std::max(usual_[j][i], std::abs(entries[i]));
      }
    }
  }
  move_to(t, y);
}

std::vector<double> EvaluatedMotion::least_change(const std::vector<std::size_t>& rows, const std::vector<double>& right,
                                                  const std::vector<std::size_t>& kept) {
  const std::size_t n = velocity_count();
  Rows<double> mass;
  for (const std::vector<Value>& row : mass_) mass.push_back(here_(row));
  for (const std::size_t i : kept) {  // out of the problem: nothing couples with it, and no row acts on it
    for (std::size_t j = 0; j < n; ++j) mass[i][j] = mass[j][i] = i == j ? 1.0 : 0.0;
  }
  const Cholesky<double> factor = metric_factor(std::move(mass));
  struct Row {
    std::vector<double> direction;  // of A L⁻ᵀ
    double right, size;
  };
  std::vector<Row> left;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::vector<double> a = here_(rows_[rows[k]].jacobian);
    for (const std::size_t i : kept) a[i] = 0.0;
    std::vector<double> b = factor.forward(std::move(a));
    const double size = std::sqrt(euclidean(b, b));
    const std::vector<double> usual = factor.forward(usual_[rows[k]]);
    // Below its usual size by so much a row is rounding: it has no direction.
    if (size > rank_tolerance * std::sqrt(euclidean(usual, usual))) left.push_back({std::move(b), right[k], size});
  }
  // The rows made orthonormal, the longest remainder first; what others leave of a repeated row is rounding.
  std::vector<double> change(n, 0.0);
  std::vector<std::vector<double>> basis;
  const auto share = [](const Row& row) { return std::sqrt(euclidean(row.direction, row.direction)) / row.size; };
  while (!left.empty()) {
    const auto best = std::max_element(left.begin(), left.end(), [&](const Row& a, const Row& b) { return share(a) < share(b); });
    if (share(*best) < rank_tolerance) break;
    Row row = std::move(*best);
    left.erase(best);
    for (const std::vector<double>& e : basis) {
      const double along = euclidean(row.direction, e);
      for (std::size_t i = 0; i < n; ++i) row.direction[i] -= along * e[i];
    }
    const double length = std::sqrt(euclidean(row.direction, row.direction));
    for (double& entry : row.direction) entry /= length;
    const double coefficient = row.right / length;
    for (std::size_t i = 0; i < n; ++i) change[i] += coefficient * row.direction[i];
    for (Row& other : left) {
      const double along = euclidean(other.direction, row.direction);
      for (std::size_t i = 0; i < n; ++i) other.direction[i] -= along * row.direction[i];
      other.right -= along * coefficient;
    }
    basis.push_back(std::move(row.direction));
  }
  return factor.backward(std::move(change));
}

// Rows in the metric of the masses, each over its usual size.
std::vector<std::vector<double>> EvaluatedMotion::scaled_rows(double t, const std::vector<double>& y) {
  if (usual_.empty()) look_around(t, y);
  move_to(t, y);
  Rows<double> mass;
  for (const std::vector<Value>& row : mass_) mass.push_back(here_(row));
  const Cholesky<double> factor = metric_factor(std::move(mass));
  std::vector<std::vector<double>> rows;
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    std::vector<double> row = factor.forward(here_(rows_[j].jacobian));
    const std::vector<double> usual = factor.forward(usual_[j]);
    const double size = std::sqrt(std::max(euclidean(row, row), euclidean(usual, usual)));
    if (size > 0) {
      for (double& entry : row) entry /= size;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

double EvaluatedMotion::independence(double t, const std::vector<double>& y) {
  const std::vector<std::vector<double>> rows = scaled_rows(t, y);
  double least = 1.0;
  std::vector<std::vector<double>> basis;
  for (const std::size_t j : equations_.redundancy().kept) {
    std::vector<double> row = rows[j];
    for (const std::vector<double>& e : basis) {
      const double along = euclidean(row, e);
      for (std::size_t i = 0; i < row.size(); ++i) row[i] -= along * e[i];
    }
    const double left = std::sqrt(euclidean(row, row));
    if (!(left > 0)) return 0.0;
    least = std::min(least, left);
    for (double& entry : row) entry /= left;
    basis.push_back(std::move(row));
  }
  return least;
}

double EvaluatedMotion::independence_of_all(double t, const std::vector<double>& y) {
  std::vector<std::vector<double>> rows = scaled_rows(t, y);
  double least = 1.0;
  for (std::size_t step = 0; step < equations_.redundancy().kept.size(); ++step) {
    const auto best = std::max_element(rows.begin(), rows.end(),
                                       [](const auto& a, const auto& b) { return euclidean(a, a) < euclidean(b, b); });
    const double left = std::sqrt(euclidean(*best, *best));
    if (!(left > 0)) return 0.0;
    least = std::min(least, left);
    std::vector<double> direction = std::move(*best);
    rows.erase(best);
    for (double& entry : direction) entry /= left;
    for (std::vector<double>& row : rows) {
      const double along = euclidean(row, direction);
      for (std::size_t i = 0; i < row.size(); ++i) row[i] -= along * direction[i];
    }
  }
  return least;
}

double EvaluatedMotion::open(std::size_t j, bool rates) {
  const ConstraintRow& row = rows_[j];
  double scale = std::numeric_limits<double>::min(), usual = 0.0;
  for (std::size_t i = 0; i < velocity_count(); ++i) scale += std::abs(here_(row.jacobian[i]));
  if (!usual_.empty()) usual = std::accumulate(usual_[j].begin(), usual_[j].end(), 0.0);
  if (scale < rank_tolerance * usual) scale = usual;  // it vanishes here, and is no measure
  const double value = std::abs(here_(rates ? row.rate : row.value)) / scale;
  return std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
}

double EvaluatedMotion::open(const std::vector<std::size_t>& rows, bool rates) {
  double most = 0.0;
  for (const std::size_t j : rows) most = std::max(most, open(j, rates));
  return most;
}

std::string EvaluatedMotion::most_open(double t, const std::vector<double>& y) {
  move_to(t, y);
  const ConstraintRow* worst = nullptr;
  bool of_rates = false;
  double most = 0.0;
  // Rates come after positions: they can be closed wherever these are.
  for (const bool rates : {false, true}) {
    for (const std::size_t j : rates ? all_ : holonomic_) {
      const double here = open(j, rates);
      if ((rates && worst != nullptr && !of_rates) || !(here > most)) continue;
      worst = &rows_[j];
      of_rates = rates;
      most = here;
    }
  }
  if (worst == nullptr) return "no constraint is open";
  const Value& left = of_rates ? worst->rate : worst->value;
  const Unit& unit = left.unit();
  return fmt::format("constraint '{}' has the {} {:.6g}{}", worst->name, of_rates ? "rate" : "value", here_(left),
                     unit.is_dimensionless() ? "" : " " + unit.to_string());
}

bool EvaluatedMotion::settle(double t, std::vector<double>& y, const Kept& kept) {
  normalise(y);
  if (!finite(y)) return false;
  move_to(t, y);
  if (rows_.empty()) return true;
  if (usual_.empty()) look_around(t, y);
  const auto largest = [&](std::size_t begin, std::size_t end) {
    double most = 1.0;
    for (std::size_t i = begin; i < end; ++i) most = std::max(most, std::abs(y[i]));
    return most;
  };
  const auto opposite = [&](const std::vector<std::size_t>& rows, bool rates) {
    std::vector<double> right;
    for (const std::size_t j : rows) right.push_back(-here_(rates ? rows_[j].rate : rows_[j].value));
    return right;
  };
  // What is written keeps 1e-9 of the positions and of the velocities at the worst; Newton's steps end where rounding does.
  constexpr double rounding = 1e-15, may_be_rounding = 1e-12, closed = 1e-9;
  const double positions = largest(0, position_count_);
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 40; ++round) {
    const double now = open(holonomic_, false);
    if (now <= rounding * positions || (now >= before / 2 && now <= may_be_rounding * positions)) break;
    if (round > 20 && !(now < before)) return false;
    before = now;
    displace(t, y, least_change(holonomic_, opposite(holonomic_, false), kept.positions));
    if (!finite(y)) return false;
  }
  if (!(open(holonomic_, false) <= closed * positions)) return false;
  for (int round = 0; round < 2; ++round) {
    const std::vector<double> change = least_change(all_, opposite(all_, true), kept.rates);
    for (std::size_t i = 0; i < change.size(); ++i) y[position_count_ + i] += change[i];
    move_to(t, y);
  }
  return finite(y) && open(all_, true) <= closed * largest(position_count_, y.size());
}

Value EvaluatedMotion::watched(const Expression& formula, const std::string& text) {
  for (const CoordinateContent& c : equations_.scene().content().coordinates) {
    if (!formula.depends_on(c.a)) continue;
    throw UsageError(fmt::format("the formula '{}' has the acceleration {}: what is watched is a formula of coordinates, rates "
                                 "and time",
                                 text, c.a->name));
  }
  return equations_.program().lower(formula);
}

double EvaluatedMotion::value(double t, const std::vector<double>& y, const Value& formula) {
  move_to(t, y);
  return here_(formula);
}

std::vector<EvaluatedMotion::Observed> EvaluatedMotion::observed() const {
  std::vector<Observed> all{{"kinetic_energy", "J"}, {"potential_energy", "J"}, {"mechanical_energy", "J"}};
  if (!integrals_.skipped.empty()) return all;
  // Contacts change what the mechanism would conserve without them.
  const std::string kind = equations_.scene().content().contacts.empty() ? "first_integral_" : "without_contacts_";
  for (const Member& each : integrals_.structures.at(0).members) all.push_back({kind + each.name, each.meaning.unit});
  return all;
}

std::vector<double> EvaluatedMotion::observe(double t, const std::vector<double>& y) {
  move_to(t, y);
  const double kinetic = here_(energy_.assignments[0].value);
  const double potential = 0 - here_(energy_.assignments[1].value);  // where nothing has one it is 0, not -0
  std::vector<double> numbers{kinetic, potential, kinetic + potential};
  if (integrals_.skipped.empty()) {
    for (const Assignment& each : integrals_.assignments) numbers.push_back(here_(each.value));
  }
  return numbers;
}

}  // namespace torsor
