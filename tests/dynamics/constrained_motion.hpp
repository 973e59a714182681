// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/equations/independent_freedoms.hpp"
#include "torsor/generator/program/evaluation.hpp"

namespace torsor::testing_mechanisms {

/// A state of a scene in numbers, moved along its constraints by Newton's method: the derivation of the tests of the reduced
/// linearisation, which shares with it the rows of the constraints only.
class ConstrainedMotion {
 public:
  struct State {
    std::vector<Real> q, v, u;
    Real time = Real(0);
  };

  explicit ConstrainedMotion(const Equations& equations)
      : equations_(equations), positions_(equations.model().positions()), inputs_(equations.model().inputs()) {}

  const std::vector<SymbolPointer>& positions() const { return positions_; }
  std::size_t freedoms() const { return static_cast<std::size_t>(equations_.model().unknown_count()); }

  Evaluator<Real> at(const State& state, const std::vector<Real>& a = {}, const std::vector<Real>& lambda = {}) const {
    return Evaluator<Real>(equations_.program(), reader(state, a, lambda));
  }

  /// The same for Evaluator::move_to, which keeps what it knows of the program.
  Evaluator<Real>::SymbolValue reader(const State& state, const std::vector<Real>& a = {},
                                      const std::vector<Real>& lambda = {}) const {
    return [this, state, a, lambda](const SymbolPointer& symbol) {
      const auto& coordinates = equations_.model().coordinates();
      const auto& constraints = equations_.scene().content().constraints;
      if (symbol->kind == SymbolKind::pi) return Real::pi();
      if (symbol->kind == SymbolKind::time) return state.time;
      for (std::size_t i = 0; i < positions_.size(); ++i) {
        if (symbol == positions_[i]) return state.q[i];
      }
      for (std::size_t i = 0; i < freedoms(); ++i) {
        if (symbol == coordinates[i].v) return state.v[i];
        if (symbol == coordinates[i].a && !a.empty()) return a[i];
      }
      for (std::size_t k = 0; k < inputs_.size(); ++k) {
        if (symbol == inputs_[k]) return state.u[k];
      }
      for (std::size_t j = 0; j < constraints.size(); ++j) {
        if (symbol == constraints[j].multiplier && !lambda.empty()) return lambda[j];
      }
      return Real(0);
    };
  }

  /// Adds δ along one freedom: to the coordinate, or e ∘ (1, δ/2) for an attitude (to first order, normalised).
  void displace(State& state, std::size_t freedom, const Real& delta) const {
    const auto& coordinates = equations_.model().coordinates();
    std::size_t place = 0;
    for (std::size_t i = 0; i < freedoms();) {
      if (coordinates[i].attitude < 0) {
        if (i == freedom) state.q[place] += delta;
        ++i, ++place;
        continue;
      }
      if (freedom >= i && freedom < i + 3) {
        std::vector<Real> turn(4, Real(0));
        turn[0] = Real(1);
        turn[1 + freedom - i] = delta / Real(2);
        const std::vector<Real> e(state.q.begin() + static_cast<long>(place),
                                  state.q.begin() + static_cast<long>(place) + 4);
        const std::vector<Real> turned = product(e, turn);
        Real square(0);
        for (const Real& x : turned) square += x * x;
        for (std::size_t k = 0; k < 4; ++k) state.q[place + k] = turned[k] / sqrt(square);
      }
      i += 3, place += 4;
    }
  }

  /// Newton's method on the dependent freedoms until the rows hold, then A v = b for the dependent velocities.
  void satisfy(State& state, const std::vector<std::size_t>& holonomic, const std::vector<std::size_t>& dependent_q,
               const std::vector<std::size_t>& rows, const std::vector<std::size_t>& dependent_v) const {
    Evaluator<Real>& here = solver_;
    // The error left is about the square of the last step: nothing of the working digits.
    const Real enough(Number(10).pow(-Real::working_digits() / 2 - 5), Real::working_digits());
    for (int iteration = 0; iteration < 12 && !holonomic.empty(); ++iteration) {
      here.move_to(reader(state));
      std::vector<Real> matrix, right_side;
      for (const std::size_t i : dependent_q) {
        for (const std::size_t j : holonomic) matrix.push_back(here(equations_.constraints()[j].jacobian[i]));
      }
      for (const std::size_t j : holonomic) right_side.push_back(-here(equations_.constraints()[j].value));
      const std::vector<Real> delta = solve_dense(matrix, right_side);
      Real longest(0);
      for (std::size_t k = 0; k < delta.size(); ++k) {
        displace(state, dependent_q[k], delta[k]);
        longest += abs(delta[k]);
      }
      if (longest < enough) break;
    }
    if (rows.empty()) return;
    for (const std::size_t i : dependent_v) state.v[i] = Real(0);
    here.move_to(reader(state));
    std::vector<Real> matrix, right_side;
    for (const std::size_t i : dependent_v) {
      for (const std::size_t j : rows) matrix.push_back(here(equations_.constraints()[j].jacobian[i]));
    }
    for (const std::size_t j : rows) right_side.push_back(-here(equations_.constraints()[j].rate));
    const std::vector<Real> v = solve_dense(matrix, right_side);
    for (std::size_t k = 0; k < v.size(); ++k) state.v[dependent_v[k]] = v[k];
  }

  /// For the freedoms that depend on others.
  void satisfy(State& state, const IndependentFreedoms& freedoms) const {
    std::vector<std::size_t> rows, dependent;
    for (const IndependentFreedoms::Pivot& pivot : freedoms.pivots) {
      rows.push_back(pivot.row);
      dependent.push_back(pivot.column);
    }
    const auto first = [&](const std::vector<std::size_t>& all) {
      return std::vector<std::size_t>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(freedoms.holonomic));
    };
    satisfy(state, first(rows), first(dependent), rows, dependent);
  }

  /// Rate of the deviation from `from` along each freedom, at a neighbouring state: q̇ of a coordinate; of an attitude
  /// 2 d(e0* e)/dt with both quaternions moving, e0* the conjugate.
  std::vector<Real> rates_of_deviation(const State& from, const State& state) const {
    const auto& coordinates = equations_.model().coordinates();
    std::vector<Real> rates;
    std::size_t place = 0;
    for (std::size_t i = 0; i < freedoms();) {
      if (coordinates[i].attitude < 0) {
        rates.push_back(state.v[i] - from.v[i]);
        ++i, ++place;
        continue;
      }
      const auto quaternion = [&](const State& s) {
        return std::vector<Real>(s.q.begin() + static_cast<long>(place), s.q.begin() + static_cast<long>(place) + 4);
      };
      const auto rate = [&](const State& s) {
        std::vector<Real> half{Real(0)};
        for (std::size_t k = 0; k < 3; ++k) half.push_back(s.v[i + k] / Real(2));
        return product(quaternion(s), half);
      };
      const auto conjugate = [](std::vector<Real> e) {
        for (std::size_t k = 1; k < 4; ++k) e[k] = -e[k];
        return e;
      };
      const std::vector<Real> first = product(conjugate(rate(from)), quaternion(state));
      const std::vector<Real> second = product(conjugate(quaternion(from)), rate(state));
      for (std::size_t k = 1; k < 4; ++k) rates.push_back(Real(2) * (first[k] + second[k]));
      i += 3, place += 4;
    }
    return rates;
  }

  static std::vector<Real> product(const std::vector<Real>& a, const std::vector<Real>& b) {
    return {
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3], a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
  }

 private:
  const Equations& equations_;
  std::vector<SymbolPointer> positions_, inputs_;
  mutable Evaluator<Real> solver_{equations_.program(), {}};
};

}  // namespace torsor::testing_mechanisms
