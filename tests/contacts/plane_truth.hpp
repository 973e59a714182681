// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tests/contacts/random_scenes.hpp"

// Why a motion in the plane ended early, asked of its last state once more in long double: all regimes of the contacts that
// touch, each by a linear solve of its own. Nothing of the runtime's solver is used.
namespace plane_truth {

using namespace random_scenes;
using Number = long double;
using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

/// The contacts that touch at a state: u = W r + q with two rows for each, N and T.
class PlaneTruth {
 public:
  PlaneTruth(const RandomScene& scene, const RandomScene::State& y) {
    const ContactReading reading = scene.reading_at(y);
    std::vector<int> rows;
    int row = 0;
    for (std::size_t i = 0; i < scene.touches.size(); ++i) {
      const Touch& touch = scene.touches[i];
      if (reading.gap[i] <= 1e-10) {  // as `ContactOptions::touch` says
        rows.insert(rows.end(), {row, touch.friction > 0 ? row + 1 : -1});
        touches.push_back(touch);
      }
      row += touch.friction > 0 ? 2 : 1;
    }
    const Matrix M = reading.M.cast<Number>(), A = reading.A.cast<Number>();
    const Vector F = reading.F.cast<Number>();
    const auto n = M.rows(), m = A.rows();
    Matrix whole = Matrix::Zero(n + m, n + m);
    whole.topLeftCorner(n, n) = M;
    whole.topRightCorner(n, m) = -A.transpose();
    whole.bottomLeftCorner(m, n) = A;
    const Eigen::FullPivLU<Matrix> lu(whole);
    Vector right(n + m);
    right << F, -reading.gamma.cast<Number>();
    const Vector free = lu.solve(right);
    const auto size = static_cast<Eigen::Index>(rows.size());
    J = Matrix::Zero(size, n);
    before = drift = Vector::Zero(size);
    for (Eigen::Index k = 0; k < size; ++k) {
      const int of = rows[static_cast<std::size_t>(k)];
      if (of < 0) continue;
      J.row(k) = reading.J.row(of).cast<Number>();
      before(k) = reading.w(of);
      drift(k) = reading.drift(of);
    }
    Matrix answers = Matrix::Zero(n + m, size);
    answers.topRows(n) = J.transpose();
    if (size > 0) answers = lu.solve(answers).eval();  // Eigen 3.4 adds to the null address of no columns
    W = J * answers.topRows(n);
    drift += J * free.head(n);
  }

  /// Whether regimes exist that go on from here: slips go on in their directions, and what neither slides nor presses yet may
  /// do either.
  [[nodiscard]] bool goes_on() const { return !solutions(drift, true).empty(); }

  /// The least energy that Newton's law takes, over all of its solutions, and the terms that it is the sum of.
  struct Loss { Number energy = INFINITY, terms = 0; };
  [[nodiscard]] Loss impact() const {
    Vector shifted = before;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const auto n = normal(i);
      if (before(n) < 0) shifted(n) *= 1 + touches[i].restitution;
    }
    Loss loss;
    for (const Vector& P : solutions(shifted, false)) {
      const Vector w = W * P + before;
      loss.energy = std::min(loss.energy, -P.dot(before + w) / 2);
      loss.terms = std::max(loss.terms, P.cwiseAbs().dot(before.cwiseAbs()));
    }
    return loss;
  }

  /// The determinant of the equations of the present regimes over that without friction.
  [[nodiscard]] Number regularity() const {
    const auto size = W.rows();
    Matrix with = Matrix::Identity(size, size), without = with;
    for (std::size_t i = 0; i < touches.size(); ++i) {
      const auto n = normal(i), t = n + 1;
      with.row(n) = without.row(n) = W.row(n);
      if (touches[i].friction > 0 && rests(t)) {
        with.row(t) = without.row(t) = W.row(t);
      } else if (touches[i].friction > 0) {
        with(t, n) = before(t) > 0 ? touches[i].friction : -touches[i].friction;
      }
    }
    return with.determinant() / without.determinant();
  }

  std::vector<Touch> touches;
  Matrix J, W;
  Vector before, drift;

 private:
  [[nodiscard]] static Eigen::Index normal(std::size_t i) { return static_cast<Eigen::Index>(2 * i); }
  [[nodiscard]] bool rests(Eigen::Index t) const { return std::abs(before(t)) <= 1e-10L; }

  // Signorini's and Coulomb's laws of u = W r + q, to 1e-9 of the largest terms. Forces whose terms cancel to a part in 1e8 are
  // none, as docs/contacts.md says.
  [[nodiscard]] std::vector<Vector> solutions(const Vector& q, bool slips) const {
    enum Regime { open, sticks, forwards, backwards, regimes };
    std::vector<Vector> found;
    const auto size = W.rows();
    std::vector<int> regime(touches.size(), open);
    for (bool more = true; more;) {
      Matrix E = Matrix::Zero(size, size);
      Vector e = Vector::Zero(size);
      bool possible = true;
      for (std::size_t i = 0; i < touches.size(); ++i) {
        const auto n = normal(i), t = n + 1;
        const Number f = touches[i].friction;
        E(n, n) = E(t, t) = 1;
        if (regime[i] == open) continue;
        E.row(n) = W.row(n);
        e(n) = -q(n);
        if (regime[i] == sticks) {
          possible = possible && (f == 0 || !slips || rests(t));
          if (f > 0) E.row(t) = W.row(t);
          if (f > 0) e(t) = -q(t);
        } else {
          const Number d = regime[i] == forwards ? 1 : -1;
          possible = possible && f > 0 && (!slips || rests(t) || d * before(t) > 0);
          E(t, n) = d * f;
        }
      }
      if (possible && size > 0) {
        const Eigen::FullPivLU<Matrix> lu(E);
        const Vector r = lu.solve(e), u = W * r + q;
        const Number terms = (W.cwiseAbs() * r.cwiseAbs() + q.cwiseAbs()).maxCoeff(), force = r.cwiseAbs().maxCoeff();
        bool holds = terms <= 1e8L * q.cwiseAbs().maxCoeff() && (E * r - e).cwiseAbs().maxCoeff() <= 1e-9L * terms;
        for (std::size_t i = 0; i < touches.size() && holds; ++i) {
          const auto n = normal(i), t = n + 1;
          holds = r(n) >= -1e-9L * force && u(n) >= -1e-9L * terms;
          if (regime[i] == sticks) holds = holds && std::abs(r(t)) <= touches[i].friction * r(n) + 1e-9L * force;
          const bool begins = regime[i] >= forwards && (!slips || rests(t));
          if (begins) holds = holds && (regime[i] == forwards ? u(t) : -u(t)) >= -1e-9L * terms;
        }
        if (holds) found.push_back(r);
      }
      more = false;
      for (std::size_t i = 0; i < touches.size() && !more; ++i) {
        more = ++regime[i] < regimes;
        if (!more) regime[i] = open;
      }
    }
    return found;
  }
};

}  // namespace plane_truth
