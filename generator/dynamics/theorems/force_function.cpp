// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/theorems/force_function.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

/// ∫ s^0..s^(n−1) over 0..1 exactly: weights of the nodes (2 m + 1)/(2 n), none of which is 0, where a force may be
/// infinite.
std::vector<Number> quadrature_weights(int n) {
  std::vector<Number> nodes;
  for (int m = 0; m < n; ++m) nodes.push_back(Number::rational(2 * m + 1, 2 * n));
  std::vector<Number> weights;
  for (int m = 0; m < n; ++m) {
    std::vector<Number> polynomial{Number(1)};  // Π (s − s_j)/(s_m − s_j), by powers of s
    for (int j = 0; j < n; ++j) {
      if (j == m) continue;
      const Number scale = Number(1) / (nodes[static_cast<std::size_t>(m)] - nodes[static_cast<std::size_t>(j)]);
      std::vector<Number> next(polynomial.size() + 1);
      for (std::size_t k = 0; k < polynomial.size(); ++k) {
        next[k + 1] += polynomial[k] * scale;
        next[k] -= polynomial[k] * scale * nodes[static_cast<std::size_t>(j)];
      }
      polynomial = std::move(next);
    }
    Number weight_of_node;
    for (std::size_t k = 0; k < polynomial.size(); ++k) weight_of_node += polynomial[k] / Number(k + 1);
    weights.push_back(weight_of_node);
  }
  return weights;
}

class Classifier {
 public:
  Classifier(const Equations& equations, SelectedActions actions)
      : model_(equations.model()), program_(equations.program()), actions_(std::move(actions)) {
    report_.forces = actions_.forces;
    report_.power = actions_.power;
  }

  ForceFunctionReport classify() {
    if (judge() != ForceFunctionCase::none) find_force_function();
    return std::move(report_);
  }

  ForceFunctionCase judge() {
    look_at_frictions();
    look_at_velocities();
    look_at_cross_derivatives();
    if (!report_.reasons.empty()) return report_.kind;
    look_at_power();
    return report_.kind = report_.reasons.empty() ? ForceFunctionCase::potential_energy : ForceFunctionCase::force_function;
  }

 private:
  std::size_t count() const { return actions_.forces.size(); }
  const std::string& name(std::size_t i) const { return model_.coordinates()[i].q->name; }

  void look_at_frictions() {
    for (const std::string& friction : actions_.frictions) {
      report_.reasons.push_back(
          fmt::format("'{}' depends on the normal force of its contact, and is left out of forces and power", friction));
    }
  }

  void look_at_velocities() {
    std::vector<Value> derivatives;
    std::vector<std::string> sentences;
    for (std::size_t j = 0; j < count(); ++j) {
      Derivation by_velocity = partial_derivation(program_, model_.coordinates()[j].v);
      for (std::size_t i = 0; i < count(); ++i) {
        derivatives.push_back(by_velocity(actions_.forces[i]));
        sentences.push_back(fmt::format("Q_{} depends on the velocity {}'", name(i), name(j)));
      }
    }
    for (const SymbolPointer& input : model_.inputs()) {
      Derivation by_input = partial_derivation(program_, input);
      for (std::size_t i = 0; i < count(); ++i) {
        derivatives.push_back(by_input(actions_.forces[i]));
        sentences.push_back(fmt::format("Q_{} depends on the input {}", name(i), input->name));
      }
    }
    say_where_not_zero(derivatives, sentences);
  }

  void look_at_cross_derivatives() {
    std::vector<Derivation> along;
    for (std::size_t j = 0; j < count(); ++j) along.push_back(model_.along(static_cast<int>(j)));
    std::vector<Value> differences;
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < count(); ++i) {
      for (std::size_t j = i + 1; j < count(); ++j) {
        const Value first = along[j](actions_.forces[i]);
        const Value second = along[i](actions_.forces[j]);
        differences.push_back(first - second + of_commutator(i, j));
        sentences.push_back(fmt::format("dQ_{}/d{} is not dQ_{}/d{}", name(i), name(j), name(j), name(i)));
      }
    }
    say_where_not_zero(differences, sentences);
  }

  /// Derivatives along the components of an angular velocity do not commute: with ω in the axes of the body,
  /// X_i X_j U − X_j X_i U = ε_ijk X_k U. Zero for any other pair.
  Value of_commutator(std::size_t i, std::size_t j) const {
    const auto& all = model_.coordinates();
    if (!all[i].attitude || all[i].attitude != all[j].attitude) return {};
    std::size_t first = i;
    while (first > 0 && all[first - 1].attitude == all[i].attitude) --first;
    const std::size_t k = 3 - (i - first) - (j - first);
    const Value& force = actions_.forces[first + k];
    return j - i == 1 ? force : -force;
  }

  /// R = P − Σ Q_i q̇_i must be ∂U/∂t for some U with these Q_i.
  void look_at_power() {
    rest_ = actions_.power;
    for (std::size_t i = 0; i < count(); ++i) rest_ -= actions_.forces[i] * model_.v(static_cast<int>(i));
    rest_ = program_.bind(rest_);
    Derivation by_time = partial_derivation(program_, model_.scene().time);
    const bool silent = identically_zero(rest_);
    std::vector<Value> differences;
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < count(); ++i) {
      Derivation by_position = model_.along(static_cast<int>(i));
      Derivation by_velocity = partial_derivation(program_, model_.coordinates()[i].v);
      const Value explicit_rate = by_time(actions_.forces[i]);
      differences.push_back(explicit_rate - by_position(rest_));
      sentences.push_back(
          silent
              ? fmt::format("Q_{} changes with time at fixed coordinates, and all the power is sum Q_i q_i': nothing "
                            "supplies dU/dt|explicit",
                            name(i))
              : fmt::format("the power beyond sum Q_i q_i' cannot be dU/dt|explicit: its derivative along {} is not "
                            "dQ_{}/dt|explicit",
                            name(i), name(i)));
      differences.push_back(by_velocity(rest_));
      sentences.push_back(fmt::format("the power beyond sum Q_i q_i' depends on the velocity {}'", name(i)));
    }
    say_where_not_zero(differences, sentences);
  }

  void say_where_not_zero(const std::vector<Value>& values, const std::vector<std::string>& sentences) {
    const std::vector<bool> zero = identically_zero_entries(values);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (!zero[k]) report_.reasons.push_back(sentences[k]);
    }
  }

  bool has_these_forces(const Value& u) const {
    std::vector<SymbolPointer> velocities;
    for (std::size_t i = 0; i < count(); ++i) velocities.push_back(model_.coordinates()[i].v);
    std::vector<Value> differences =
        u.program() == nullptr ? std::vector<Value>(count()) : gradient_along(u, velocities);
    for (std::size_t i = 0; i < count(); ++i) differences[i] -= actions_.forces[i];
    const std::vector<bool> zero = identically_zero_entries(differences);
    return std::all_of(zero.begin(), zero.end(), [](bool z) { return z; });
  }

  /// Whether −U is a potential energy as it stands, without a further function of time.
  bool answers_for_power(const Value& u) const {
    Value difference = rest_;
    if (u.program() != nullptr) difference -= partial_derivation(program_, model_.scene().time)(u);
    return identically_zero(difference);
  }

  void found(const Value& u, const std::string& where) {
    report_.force_function = u;
    report_.remark = where;
    if (report_.kind == ForceFunctionCase::potential_energy && !answers_for_power(u)) {
      report_.remark += "; the potential energy is -U plus a function of time";
    }
  }

  void find_force_function() {
    const Value own = program_.bind(actions_.force_function);
    if (has_these_forces(own)) return found(own, "U of the springs, attractions, given functions and weight");
    const bool quaternions = model_.positions().size() != count();
    for (int n = 1; n <= 9 && !quaternions; ++n) {
      const Value u = along_straight_lines(n);
      if (has_these_forces(u)) return found(u, "U by integration along straight lines from q = 0");
    }
    report_.remark = "U exists locally; the forces are no polynomials of the coordinates and it is not written down";
  }

  /// U(q) = ∫ Σ q_i Q_i(s q, t) ds over 0..1, exact for polynomials of degree n − 1 (n when n is odd).
  Value along_straight_lines(int n) const {
    const std::vector<Number> weights = quadrature_weights(n);
    Value u;
    for (int m = 0; m < n; ++m) {
      const Number s = Number::rational(2 * m + 1, 2 * n);
      Substitution scaled(program_, [&](const SymbolPointer& symbol) -> std::optional<Value> {
        for (std::size_t i = 0; i < count(); ++i) {
          if (symbol == model_.coordinates()[i].q) return s * program_.symbol(symbol);
        }
        return std::nullopt;
      });
      for (std::size_t i = 0; i < count(); ++i) {
        if (actions_.forces[i].is_zero()) continue;
        const Value force = scaled(actions_.forces[i]);
        u += weights[static_cast<std::size_t>(m)] * (model_.q(static_cast<int>(i)) * force);
      }
    }
    return program_.bind(u);
  }

  const Model& model_;
  Program& program_;
  SelectedActions actions_;
  Value rest_;
  ForceFunctionReport report_;
};

}  // namespace

ForceFunctionReport classify_force_function(const Equations& equations, const ActionSelection& selection) {
  return Classifier(equations, selected_actions(equations.model(), selection)).classify();
}

ForceFunctionCase force_function_case(const Equations& equations, const ActionSelection& selection) {
  return Classifier(equations, selected_actions(equations.model(), selection)).judge();
}

std::string to_string(ForceFunctionCase kind) {
  switch (kind) {
    case ForceFunctionCase::potential_energy:
      return "potential energy";
    case ForceFunctionCase::force_function:
      return "force function without potential energy";
    case ForceFunctionCase::none:
      break;
  }
  return "no force function";
}

}  // namespace torsor
