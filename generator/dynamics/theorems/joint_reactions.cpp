// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/joint_reactions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/linear_algebra/real_rows.hpp"
#include "torsor/generator/base/linear_algebra/tolerances.hpp"
#include "torsor/generator/dynamics/forces/constraint_wrench.hpp"
#include "torsor/generator/dynamics/motion/body_set.hpp"
#include "torsor/generator/program/generic_state.hpp"

namespace torsor {
namespace {

using Row = RealRow;

/// Basis of {x : rows x = 0}, one vector for each column without a pivot, 1 there and 0 at the others; pivots are
/// sought in the columns in the given order.
RealRows motions_without(const RealRows& rows, const std::vector<std::size_t>& columns) {
  RowReduction<Real> reduction(rows, columns.size());
  reduction.take_in_order(columns, zero_tests::reactions.bound());
  return reduction.null_space();
}

/// "Z - 0.01 N", or "Z ~ N" where the factor is no number: it depends on a parameter or on the configuration, and is another
/// one at another state.
std::string name_of(const Row& component, const Row& elsewhere) {
  static constexpr const char* names[6] = {"X", "Y", "Z", "L", "M", "N"};
  std::string sum, tied;
  bool varies = false;
  for (std::size_t i = 0; i < 6; ++i) {
    if (is_negligible(component[i])) continue;
    varies = varies || !is_negligible(component[i] - elsewhere[i]);
    const double k = component[i].to_double();
    const bool one = is_negligible(abs(component[i]) - Real(1));
    const std::string size = one ? "" : fmt::format("{:.4g} ", std::abs(k));
    sum += sum.empty() ? (k < 0 ? "-" : "") : (k < 0 ? " - " : " + ");
    sum += size + names[i];
    tied += (tied.empty() ? "" : " ~ ") + std::string(names[i]);
  }
  return varies ? tied : sum;
}

class Finder {
 public:
  Finder(const Equations& equations, int state)
      : model_(equations.model()), program_(equations.program()), evaluate_(at_generic_state(equations, state)) {
    const std::size_t count = model_.links().size();
    children_.assign(count, 0);
    rotor_ = rotor_links(model_);
    stands_ = standing_links(equations);
    for (std::size_t k = 1; k < count; ++k) ++children_[static_cast<std::size_t>(model_.links()[k].parent)];
    const auto n = static_cast<std::size_t>(model_.unknown_count());
    for (std::size_t k = 0; k < count; ++k) {  // ∂s_k/∂q_i
      Row row(n, Real(0));
      for (const auto& [i, partial] : model_.links()[k].partials) {
        if (static_cast<std::size_t>(i) < n) row[static_cast<std::size_t>(i)] = evaluate_(partial);
      }
      partials_.push_back(std::move(row));
    }
  }

  std::vector<Connection> all() {
    std::vector<Connection> found;
    for (std::size_t k = 1; k < stands_.size(); ++k) {
      const auto parent = static_cast<std::size_t>(model_.links()[k].parent);
      if (rotor_[k] || passes_through(parent)) continue;
      Connection connection;
      connection.top = static_cast<int>(k);
      connection.from = static_cast<int>(parent);
      std::vector<int> chain{connection.top};
      while (passes_through(static_cast<std::size_t>(chain.back()))) chain.push_back(child_of(chain.back()));
      connection.bottom = chain.back();
      connection.name = name_of_joint(chain);
      connection.components = components(chain);
      found.push_back(std::move(connection));
    }
    return found;
  }

 private:
  bool passes_through(std::size_t link) const { return !stands_[link] && children_[link] == 1; }

  int child_of(int link) const {
    const auto& links = model_.links();
    const auto child = std::find_if(links.begin() + 1, links.end(), [link](const Link& l) { return l.parent == link; });
    return static_cast<int>(child - links.begin());
  }

  std::string name_of_joint(const std::vector<int>& chain) const {
    const std::string user = "a report on joints";
    for (const JointContent& joint : model_.scene().joints) {
      if (!joint.of_tree) continue;
      const int last = model_.place(FrameHandle{joint.of_tree->last}, user).link;
      if (last == chain.back()) return joint.name;
    }
    return model_.links()[static_cast<std::size_t>(chain.back())].name;
  }

  /// (v, ω) at the bottom's origin for a unit rate of one joint, in the top's axes.
  Row twist_of(int link, const Vector& at, int axes) {
    const Link& joint = model_.links()[static_cast<std::size_t>(link)];
    const Vector axis = bound(program_, model_.express(model_.axis_in_parent(joint), joint.parent, axes));
    Vector linear = axis;
    Vector angular;
    if (joint.joint != JointKind::prismatic) {
      const Vector origin = model_.locate(model_.origin_in_parent(joint), joint.parent, axes);
      linear = cross(axis, bound(program_, at - origin));
      angular = axis;
    }
    Row row;
    for (const Vector& part : {linear, angular}) {
      for (int i = 0; i < 3; ++i) row.push_back(evaluate_(part[i]));
    }
    return row;
  }

  std::vector<ReactionComponent> components(const std::vector<int>& chain) {
    const int top = chain.front();
    const Vector at = bound(program_, model_.locate(Vector(), chain.back(), top));
    RealRows own;
    for (const int link : chain) own.push_back(twist_of(link, at, top));
    // Virtual motions in which no other joint moves, and the twists they give the body.
    RealRows others;
    for (std::size_t k = 1; k < partials_.size(); ++k) {
      if (rotor_[k]) continue;  // it goes along, and its torque acts in the joint
      if (std::find(chain.begin(), chain.end(), static_cast<int>(k)) == chain.end()) others.push_back(partials_[k]);
    }
    RealRows twists;
    for (const Row& motion : motions_without(others, in_order(static_cast<std::size_t>(model_.unknown_count())))) {
      Row twist(6, Real(0));
      for (std::size_t c = 0; c < chain.size(); ++c) {
        Real rate(0);
        const Row& partials = partials_[static_cast<std::size_t>(chain[c])];
        for (std::size_t i = 0; i < motion.size(); ++i) rate += partials[i] * motion[i];
        for (std::size_t j = 0; j < 6; ++j) twist[j] += rate * own[c][j];
      }
      twists.push_back(std::move(twist));
    }
    // R·V + M·Ω = 0; moments are expressed by forces where a twist ties both (helical joints).
    std::vector<ReactionComponent> result;
    for (const Row& wrench : motions_without(twists, {3, 4, 5, 0, 1, 2})) {
      ReactionComponent component;
      std::copy(wrench.begin(), wrench.end(), component.direction.begin());
      result.push_back(std::move(component));
    }
    return result;
  }

  const Model& model_;
  Program& program_;
  Evaluator<Real> evaluate_;
  std::vector<bool> rotor_;   ///< whether it is no body, but a reflected inertia
  std::vector<bool> stands_;  ///< standing_links
  std::vector<int> children_;
  std::vector<Row> partials_;
};

}  // namespace

std::vector<bool> standing_links(const Equations& equations) {
  const Model& model = equations.model();
  std::vector<bool> stands(model.links().size(), false);
  stands[0] = true;
  for (const BodyContent& body : model.scene().bodies) stands[as_index(model.place(body.frame, body.name).link)] = true;
  for (const auto& [link, wrench] : equations.actions().wrenches) stands[as_index(link)] = true;
  for (std::size_t j = 0; j < equations.constraints().size(); ++j) {
    const auto unit = constraint_wrench(model, static_cast<int>(j));
    if (!unit) continue;
    for (const auto& [link, wrench] : *unit) stands[as_index(link)] = true;
  }
  return stands;
}

Evaluator<Real> at_generic_state(const Equations& equations, int state) {
  return {equations.program(), [state](const SymbolPointer& symbol) { return generic_value(symbol, state); }};
}

bool is_negligible(const Real& x) { return abs(x) < zero_tests::reactions.bound(); }

std::vector<Connection> connections(const Equations& equations) {
  const WorkingDigits precision(zero_tests::reactions.digits);
  std::vector<Connection> found = Finder(equations, 0).all();
  const std::vector<Connection> elsewhere = Finder(equations, 1).all();
  for (std::size_t k = 0; k < found.size(); ++k) {
    for (std::size_t c = 0; c < found[k].components.size(); ++c) {
      const auto row = [&](const Connection& connection) {
        const auto& direction = connection.components[c].direction;
        return Row(direction.begin(), direction.end());
      };
      const bool alike = found[k].components.size() == elsewhere[k].components.size();
      found[k].components[c].name = name_of(row(found[k]), row(alike ? elsewhere[k] : found[k]));
    }
  }
  return found;
}

}  // namespace torsor
