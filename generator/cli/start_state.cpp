// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/start_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include <Eigen/Cholesky>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/nearest_state.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"

namespace torsor {
namespace {

/// The number given for a symbol, else what the scene says.
Expression given_or(const NamedNumbers& values, const Symbol& symbol, const Expression& otherwise) {
  const auto given = values.find(symbol.name);
  return given == values.end() ? otherwise : Expression::quantity(from_double(given->second), symbol.unit);
}

bool any_given(const NamedNumbers& values, const std::vector<SymbolPointer>& symbols) {
  for (const SymbolPointer& symbol : symbols) {
    if (values.contains(symbol->name)) return true;
  }
  return false;
}

NamedNumbers numbers_of(const EvaluatedMotion& motion, const std::vector<double>& y) {
  NamedNumbers numbers;
  for (std::size_t i = 0; i < y.size(); ++i) numbers[motion.symbols()[i]->name] = y[i];
  return numbers;
}

/// The velocities that go with positions that are given, all three of a quaternion, and those that are given themselves.
EvaluatedMotion::Kept kept_of(const EvaluatedMotion& motion, const NamedNumbers& given) {
  EvaluatedMotion::Kept kept;
  const std::vector<AttitudeContent>& attitudes = motion.equations().scene().content().attitudes;
  for (std::size_t i = 0; i < motion.velocity_count(); ++i) {
    const CoordinateContent& c = motion.equations().model().coordinates()[i];
    std::vector<SymbolPointer> position{c.q};
    if (c.attitude) {
      const auto& e = attitudes[static_cast<std::size_t>(*c.attitude)].symbols->e;
      position.assign(e.begin(), e.end());
    }
    if (any_given(given, position)) kept.positions.push_back(i);
    if (any_given(given, {c.v})) kept.rates.push_back(i);
  }
  return kept;
}

/// What the scene gives itself, of coordinates: as --initial would.
NamedNumbers given_by_scene(const EvaluatedMotion& motion, const std::vector<double>& start) {
  const NamedNumbers numbers = numbers_of(motion, start);
  NamedNumbers given;
  for (const CoordinateContent& c : motion.equations().scene().content().coordinates) {
    if (!c.unknown() || c.attitude) continue;
    if (c.initial_value) given[c.q->name] = numbers.at(c.q->name);
    // initial(q, value) says no more of the rate than that it is zero by default.
    if (const double rate = numbers.at(c.v->name); rate != 0) given[c.v->name] = rate;
  }
  return given;
}

}  // namespace

Scene with_start(Scene scene, const NamedNumbers& values) {
  const SceneContent given = scene.content();
  for (const CoordinateContent& c : given.coordinates) {
    if (!c.unknown() || c.attitude || !any_given(values, {c.q, c.v})) continue;
    scene.initial(Expression(c.q), given_or(values, *c.q, c.initial_value.value_or(Expression(0))),
                  given_or(values, *c.v, c.initial_rate.value_or(Expression(0))));
  }
  for (std::size_t a = 0; a < given.attitudes.size(); ++a) {
    const AttitudeContent& attitude = given.attitudes[a];
    std::vector<SymbolPointer> symbols(attitude.symbols->e.begin(), attitude.symbols->e.end());
    std::array<Expression, 4> e;
    for (std::size_t k = 0; k < 4; ++k) e[k] = given_or(values, *symbols[k], initial_component(attitude, k));
    Triple rates{Expression(0), Expression(0), Expression(0)};
    std::size_t k = 0;
    for (const CoordinateContent& c : given.coordinates) {
      if (c.attitude != static_cast<int>(a)) continue;
      symbols.push_back(c.v);
      rates[k++] = given_or(values, *c.v, c.initial_rate.value_or(Expression(0)));
    }
    if (any_given(values, symbols)) scene.initial(AttitudeHandle{static_cast<int>(a)}, e, rates);
  }
  return scene;
}

namespace {

/// How far from the start, in the metric of NearestState, a state may be that Newton's method finds without a search for a
/// nearer one. What is proposed is searched for in any case. What a command starts from is left to Newton's method within
/// about a quarter of a turn: its steps lead there to the branch on which the start was meant, mostly.
constexpr double none_is_near = 0, quarter_of_a_turn = 1.5;

/// Newton's method from the start, and where that leads far, or nowhere, a search for what is nearest.
bool settle_near(EvaluatedMotion& motion, std::vector<double>& y, const EvaluatedMotion::Kept& kept, double far) {
  const std::vector<double> given = y;
  NearestState nearest(motion, given);
  std::vector<double> newton = given;
  const bool closes = motion.settle(0.0, newton, kept);
  if (closes && nearest.distance(newton) <= far) {
    y = std::move(newton);
    return true;
  }
  const auto found = nearest.find(kept.positions);
  if (found) {
    y = *found;
    std::copy(given.begin() + static_cast<std::ptrdiff_t>(motion.position_count()), given.end(),
              y.begin() + static_cast<std::ptrdiff_t>(motion.position_count()));
    if (motion.settle(0.0, y, kept) && (!closes || nearest.distance(y) < nearest.distance(newton))) return true;
  }
  if (closes) y = std::move(newton);
  return closes;
}

/// The same with what is given kept where the others can close the constraints.
std::vector<double> closed_within(EvaluatedMotion& motion, const NamedNumbers& replaced, double far) {
  const std::vector<double> given = motion.start(replaced);
  std::vector<double> y = given;
  if (!motion.needs_settling() || settle_near(motion, y, kept_of(motion, replaced), far)) return y;
  y = given;
  if (settle_near(motion, y, {}, far)) return y;  // what is given does not fit together by itself: it gives way as well
  throw Error(fmt::format("the constraints of '{}' cannot be closed near the start: {} there, and no search finds a state nearby "
                          "that closes all of them; give other values by --initial",
                          motion.equations().scene().name(), motion.most_open(0.0, given)));
}

}  // namespace

std::vector<double> closed_start(EvaluatedMotion& motion, const NamedNumbers& replaced) {
  return closed_within(motion, replaced, quarter_of_a_turn);
}

NamedNumbers with_defaults(const Scene& scene, NamedNumbers given) {
  const SceneContent& content = scene.content();
  if (given.empty()) return given;
  for (const ParameterContent& parameter : content.parameters) {
    if (!parameter.run_time || !parameter.value || parameter.value->symbols().empty()) continue;
    try {
      given.emplace(parameter.symbol->name, parameter_value(content, *parameter.value).to_double());
    } catch (const SceneError&) {  // a parameter without a default stands in it: only what is given decides
    }
  }
  return given;
}

namespace {

/// What is wrong with a scene whose parameters have these numbers; empty: nothing.
std::string fault_at(Scene scene, const NamedNumbers& given) {
  const NamedNumbers numbers = with_defaults(scene, given);
  const std::vector<ParameterContent> parameters = scene.content().parameters;
  ModelOptions options;
  for (const ParameterContent& each : parameters) {
    const auto number = numbers.find(each.symbol->name);
    if (number == numbers.end() || !std::isfinite(number->second)) continue;  // refused where the numbers are used
    scene.set_parameter(Expression(each.symbol), Expression(from_double(number->second)));
    options.run_time.insert(each.symbol->name);
  }
  try {
    check_values(scene.content());
    check_masses(scene, options);
  } catch (const SceneError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

void require_possible(const Scene& scene, const NamedNumbers& given) {
  if (given.empty()) return;
  const std::string fault = fault_at(scene, given);
  if (fault.empty()) return;
  std::vector<std::string> alone, all;
  for (const auto& [name, number] : given) {
    NamedNumbers others = given;
    others.erase(name);
    all.push_back(fmt::format("{}={}", name, shortest(number)));
    if (fault_at(scene, others).empty()) alone.push_back(all.back());
  }
  throw UsageError(fmt::format("{}; that is so with --run-time {}: give another value", fault,
                               fmt::join(alone.empty() ? all : alone, ",")));
}

Scene with_closed_start(const Scene& scene, const GivenStart& start) {
  EvaluatedMotion motion(scene, start.model, with_defaults(scene, start.parameters), {});
  return with_start(scene, numbers_of(motion, closed_start(motion, start.values)));
}

std::string nearest_closed_start(const Scene& scene, bool for_command_line) {
  try {
    EvaluatedMotion motion(scene, {}, {}, {});
    const std::vector<double> given = motion.start({});
    const std::vector<double> closed = closed_within(motion, given_by_scene(motion, given), none_is_near);
    validate(with_start(scene, numbers_of(motion, closed)));  // a contact may be in the way
    NamedNumbers changed;
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (given[i] != closed[i]) changed[motion.symbols()[i]->name] = closed[i];
    }
    std::vector<std::string> words;
    if (for_command_line) {
      for (const auto& [name, value] : changed) words.push_back(name + "=" + shortest(value));
      return words.empty() ? "" : fmt::format("; a state nearby that fulfils all: --initial \"{}\"", fmt::join(words, ","));
    }
    const NamedNumbers all = numbers_of(motion, closed);
    const SceneContent& content = scene.content();
    for (const CoordinateContent& c : content.coordinates) {
      if (!c.unknown() || c.attitude || !any_given(changed, {c.q, c.v})) continue;
      const double rate = all.at(c.v->name);
      words.push_back(fmt::format("initial({}, {}{})", c.q->name, shortest(all.at(c.q->name)),
                                  rate == 0 ? "" : ", " + shortest(rate)));
    }
    for (std::size_t a = 0; a < content.attitudes.size(); ++a) {
      std::vector<SymbolPointer> symbols(content.attitudes[a].symbols->e.begin(), content.attitudes[a].symbols->e.end());
      for (const CoordinateContent& c : content.coordinates) {
        if (c.attitude == static_cast<int>(a)) symbols.push_back(c.v);
      }
      if (!any_given(changed, symbols)) continue;
      std::vector<std::string> numbers;
      for (const SymbolPointer& symbol : symbols) numbers.push_back(shortest(all.at(symbol->name)));
      words.push_back(fmt::format("initial({}, {{{}}}, {{{}}})", content.attitudes[a].name,
                                  fmt::join(numbers.begin(), numbers.begin() + 4, ", "),
                                  fmt::join(numbers.begin() + 4, numbers.end(), ", ")));
    }
    return words.empty() ? "" : fmt::format("; a state nearby that fulfils all: {}", fmt::join(words, ", "));
  } catch (const Error&) {
    return {};  // the error that led here says what is wrong
  }
}

namespace {

/// Coordinates that a force along them hardly moves at a state.
std::set<std::string> held_coordinates(EvaluatedMotion& motion, double t, const std::vector<double>& y) {
  motion.move_to(t, y);
  const auto n = static_cast<Eigen::Index>(motion.velocity_count());
  const std::vector<std::size_t>& kept = motion.equations().redundancy().kept;
  Eigen::MatrixXd M(n, n), A(static_cast<Eigen::Index>(kept.size()), n);
  const auto at = [](Eigen::Index i) { return static_cast<std::size_t>(i); };
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) M(i, j) = motion.mass(at(i), at(j));
    for (Eigen::Index k = 0; k < A.rows(); ++k) A(k, i) = motion.value(motion.constraint(kept[at(k)]).jacobian[at(i)]);
  }
  // What a force along a coordinate moves: without the constraints, and with them.
  const Eigen::MatrixXd free = M.llt().solve(Eigen::MatrixXd::Identity(n, n)), answers = A * free;
  const Eigen::MatrixXd held = free - answers.transpose() * (A * answers.transpose()).ldlt().solve(answers);
  std::set<std::string> names;
  for (Eigen::Index i = 0; i < n; ++i) {
    // It grows with the square of the distance from the dead centre.
    if (!(held(i, i) < change_point_is_near * change_point_is_near * free(i, i))) continue;
    names.insert("'" + motion.equations().model().coordinates()[at(i)].q->name + "'");
  }
  return names;
}

}  // namespace

std::vector<std::string> at_dead_centre(EvaluatedMotion& motion, double t, const std::vector<double>& y) {
  const std::set<std::string> there = held_coordinates(motion, t, y);
  // What is held elsewhere too is held always. The start itself may be a dead centre.
  std::vector<double> elsewhere = motion.start({});
  for (std::size_t i = 0; i < elsewhere.size(); ++i) elsewhere[i] += 0.1 + 0.01 * static_cast<double>(i % 7);
  std::set<std::string> always;
  if (motion.settle(0.0, elsewhere)) always = held_coordinates(motion, 0.0, elsewhere);
  std::vector<std::string> names;
  std::set_difference(there.begin(), there.end(), always.begin(), always.end(), std::back_inserter(names));
  return names;
}

std::vector<std::string> left_out_that_count(EvaluatedMotion& motion, double t, const std::vector<double>& y) {
  std::vector<std::string> names;
  const ConstraintRank& rank = motion.equations().redundancy();
  if (!rank.redundant() || motion.independence_of_all(t, y) < change_point_is_near) return names;
  for (const std::size_t j : rank.dropped) names.push_back(fmt::format("'{}'", motion.equations().constraints()[j].name));
  return names;
}

std::string near_change_point(EvaluatedMotion& motion, double t, const std::vector<double>& y) {
  if (!(motion.independence(t, y) < change_point_is_near)) return {};
  if (const std::vector<std::string> left_out = left_out_that_count(motion, t, y); !left_out.empty()) {
    return fmt::format(": the constraints that are kept nearly lose rank there, and all together do not: what repeats others "
                       "near the start and is left out ({}) counts there. It is no change point; close the loop at another joint",
                       fmt::join(left_out, ", "));
  }
  return ": the constraints nearly lose rank there, a change point, which this command does not pass. The motion of a compiled "
         "header does (equations_of_motion; docs/constraints.md)";
}

}  // namespace torsor
