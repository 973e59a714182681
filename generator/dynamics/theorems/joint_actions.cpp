// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/joint_actions.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/linear_algebra/row_reduction.hpp"
#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/dynamics/motion/body_set.hpp"

namespace torsor {
namespace {

using Numbers = std::vector<Number>;

/// For each row k of a matrix some v with S v = e_k, where there is one: [S | 1] reduced.
std::vector<std::optional<Numbers>> unit_solutions(const std::vector<Numbers>& rows, std::size_t columns) {
  RowReduction<Number> reduction(beside_identity(rows, columns), columns + rows.size());
  reduction.take_in_order(in_order(columns));
  const Rows<Number> reduced = reduction.reduced();
  const std::vector<std::size_t> left = reduction.rows_left();
  std::vector<std::optional<Numbers>> solutions(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto holds = [&](std::size_t row) { return reduction(row, columns + k).is_zero(); };
    if (!std::all_of(left.begin(), left.end(), holds)) continue;
    solutions[k].emplace(columns);
    for (std::size_t i = 0; i < reduced.size(); ++i) (*solutions[k])[reduction.pivots()[i].column] = reduced[i][columns + k];
  }
  return solutions;
}

class Namer {
 public:
  Namer(const Equations& equations, const NaturalLanguage& language)
      : say(language), equations_(equations), model_(equations.model()), program_(equations.program()),
        rotor_(rotor_links(model_)) {
    next_index_ = model_.scene().symbol_count;
    find_forces();
    find_efforts();
  }

  JointAction action(const Connection& connection) {
    JointAction result{connection, {}, {}, {}};
    std::array<bool, 6> given{true, true, true, true, true, true};
    for (const ReactionComponent& component : connection.components) {
      std::vector<std::size_t> entries;
      for (std::size_t e = 0; e < 6; ++e) {
        if (!is_negligible(component.direction[e])) entries.push_back(e);
      }
      for (const std::size_t e : entries) given[e] = false;
      if (entries.size() > 1) {
        result.remarks.push_back(say("of joint {} only {} is unknown: what works in the joint gives the rest",
                                             connection.name, component.name));
      }
    }
    const std::optional<std::array<Value, 6>> efforts = efforts_along(connection, given);
    bool named_freedom = false;
    for (std::size_t e = 0; e < 6; ++e) {
      Value& place = (e < 3 ? result.wrench.resultant : result.wrench.moment)[static_cast<int>(e % 3)];
      if (given[e] && efforts) {
        place = (*efforts)[e];
      } else {
        named_freedom = named_freedom || given[e];
        result.unknowns.push_back(symbol(connection.name, e));
        place = program_.symbol(result.unknowns.back());
      }
    }
    if (named_freedom) {
      result.remarks.push_back(
          say("what motors, springs and dampers do along the freedoms of joint {} is in its named components",
                      connection.name));
    }
    return result;
  }

 private:
  SymbolPointer symbol(const std::string& joint, std::size_t entry) {
    static constexpr const char* names[6] = {"X", "Y", "Z", "L", "M", "N"};
    return std::make_shared<const Symbol>(Symbol{fmt::format("[{} {}]", joint, names[entry]),
                                                 entry < 3 ? units::newton : units::newton_metre,
                                                 SymbolKind::multiplier, next_index_++, nullptr});
  }

  /// Q_i of what works on formulas: inputs, springs, dampers, efforts, constraints whose force no wrench describes; of
  /// reflected inertias as well, which act in joints.
  void find_forces() {
    const AppliedActions& actions = equations_.actions();
    const std::vector<SymbolPointer> inputs = model_.inputs();
    for (std::size_t i = 0; i < as_index(model_.unknown_count()); ++i) {
      Value force = actions.passive[i];
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        if (!actions.inputs[k][i].is_zero()) force += actions.inputs[k][i] * program_.symbol(inputs[k]);
      }
      for (std::size_t j = 0; j < equations_.constraints().size(); ++j) {
        const ConstraintRow& row = equations_.constraints()[j];
        if (row.column[i].is_zero() || constraint_wrench(model_, static_cast<int>(j))) continue;
        force += row.column[i] * program_.symbol(row.multiplier);
      }
      forces_.push_back(force);
    }
    add_rotors();
    idle_ = std::all_of(forces_.begin(), forces_.end(), [](const Value& force) { return force.is_zero(); });
  }

  /// What reflected inertias resist with: −∂e/∂q_i a ë.
  void add_rotors() {
    for (std::size_t k = 0; k < rotor_.size(); ++k) {
      if (!rotor_[k]) continue;
      const Link& rotor = model_.links()[k];
      const Value torque = rotor.mass.inertia(2, 2) * rotor.acceleration;
      for (const auto& [i, partial] : rotor.partials) {
        if (as_index(i) < forces_.size()) forces_[as_index(i)] -= partial * torque;
      }
    }
  }

  /// By link: the action along its joint, of those that can move alone. Coordinates that enter any displacement in
  /// another way than with a constant factor are held still.
  void find_efforts() {
    const std::size_t n = forces_.size();
    std::vector<bool> still(n, false);
    for (std::size_t k = 0; k < rotor_.size(); ++k) {
      const Link& link = model_.links()[k];
      if (rotor_[k]) continue;
      const bool constant = std::all_of(link.partials.begin(), link.partials.end(),
                                        [](const auto& entry) { return entry.second.is_constant(); });
      for (const auto& [i, partial] : link.partials) {
        if (!constant && as_index(i) < n) still[as_index(i)] = true;
      }
    }
    std::vector<Numbers> rows;
    for (std::size_t k = 0; k < rotor_.size(); ++k) {
      const Link& link = model_.links()[k];
      rows.emplace_back(n);
      if (rotor_[k]) continue;
      for (const auto& [i, partial] : link.partials) {
        if (as_index(i) < n && !still[as_index(i)]) rows.back()[as_index(i)] = partial.polynomial().constant();
      }
    }
    for (const std::optional<Numbers>& motion : unit_solutions(rows, n)) {
      efforts_.emplace_back();
      if (!motion) continue;
      Value effort;
      for (std::size_t i = 0; i < n; ++i) {
        if (!(*motion)[i].is_zero()) effort += (*motion)[i] * forces_[i];
      }
      efforts_.back() = program_.bind(effort);
    }
  }

  /// The components along the freedoms, zero for the others; nothing when they are not seen one by one.
  std::optional<std::array<Value, 6>> efforts_along(const Connection& connection, std::array<bool, 6> open) {
    std::array<Value, 6> result;
    std::vector<int> chain;
    for (int link = connection.bottom; link != connection.from; link = model_.links()[as_index(link)].parent) {
      chain.insert(chain.begin(), link);
    }
    if (idle_) return result;
    const Vector at = bound(program_, model_.locate(Vector(), connection.bottom, connection.top));
    for (const int link : chain) {
      if (!efforts_[as_index(link)]) continue;
      const auto place = single_component(link, at, connection.top);
      if (!place || !open[place->first]) return std::nullopt;
      const Value& effort = *efforts_[as_index(link)];
      result[place->first] = place->second ? effort : -effort;
      open[place->first] = false;
    }
    if (std::any_of(open.begin(), open.end(), [](bool each) { return each; })) return std::nullopt;
    return result;
  }

  /// Where the twist of one joint is ± one unit component at the bottom's origin: which, and whether its sign is plus.
  std::optional<std::pair<std::size_t, bool>> single_component(int link, const Vector& at, int axes) const {
    const Link& joint = model_.links()[as_index(link)];
    const Vector axis = bound(program_, model_.express(model_.axis_in_parent(joint), joint.parent, axes));
    const bool slides = joint.joint == JointKind::prismatic;
    if (!slides) {
      const Vector origin = model_.locate(model_.origin_in_parent(joint), joint.parent, axes);
      if (!identically_zero(cross(axis, bound(program_, at - origin)))) return std::nullopt;
    }
    std::optional<std::pair<std::size_t, bool>> found;
    for (int i = 0; i < 3; ++i) {
      if (identically_zero(axis[i])) continue;
      const Value one = program_.number(Number(1), axis[i].unit());
      const bool plus = identically_zero(axis[i] - one), minus = identically_zero(axis[i] + one);
      if (found || (!plus && !minus)) return std::nullopt;
      found.emplace(as_index(slides ? i : i + 3), plus);
    }
    return found;
  }

  const NaturalLanguage& say;
  const Equations& equations_;
  const Model& model_;
  Program& program_;
  const std::vector<bool> rotor_;  ///< by link: whether it is a reflected inertia
  int next_index_ = 0;
  bool idle_ = true;  ///< nothing works on formulas
  std::vector<Value> forces_;
  std::vector<std::optional<Value>> efforts_;
};

}  // namespace

std::vector<JointAction> joint_actions(const Equations& equations, const NaturalLanguage& say) {
  std::vector<JointAction> result;
  Namer namer(equations, say);
  for (const Connection& connection : connections(equations)) result.push_back(namer.action(connection));
  return result;
}

Wrench as_asked(const Model& model, const JointAction& action, const ScrewQuery& query) {
  const Connection& joint = action.connection;
  const Vector at = bound(model.program(), model.locate(Vector(), joint.bottom, joint.top));
  return as_asked(model, reduced_at(action.wrench, -at), joint.top, query);  // that starts from the origin of the link
}

}  // namespace torsor
