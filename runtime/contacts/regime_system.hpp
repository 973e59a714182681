// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "runtime/contacts/contact_problem.hpp"

namespace torsor::runtime {

/// What is assumed of one contact: whether its normal force acts, and what its friction does.
struct AssumedRegime {
  enum class Friction : unsigned char { none, sticks, slides };
  bool pressed = false;
  Friction friction = Friction::none;
  std::array<double, 2> direction{1, 0};  ///< of slip, where it slides
  bool direction_given = false;           ///< by the law: the contact slips already
  bool direction_sought = false;          ///< in space: u_T along it is a condition of its own

  [[nodiscard]] ContactRegime regime() const noexcept {
    if (friction == Friction::sticks) return ContactRegime::sticks;
    return pressed || friction == Friction::slides ? ContactRegime::slides : ContactRegime::open;
  }
};

/// The equations of assumed regimes. Reactions are r = B x + c in the unknowns x (N of pressed contacts, T of sticking
/// ones), and E x = e says that u_N = 0 where a contact is pressed and u_T = 0 where it sticks.
template <int most>
class RegimeSystem {
 public:
  using Problem = ContactProblem<most>;
  using Vector = typename Problem::Vector;
  using Matrix = typename Problem::Matrix;
  using Regimes = std::array<AssumedRegime, static_cast<std::size_t>(most)>;
  using Friction = AssumedRegime::Friction;

  RegimeSystem(const Problem& problem, const Regimes& regimes) noexcept : problem_(problem), regimes_(regimes) {
    const int rows = problem.rows();
    B_.setZero(rows, unknowns());
    c_.setZero(rows);
    rows_.fill(0);
    int column = 0;
    std::array<int, static_cast<std::size_t>(most)> normal_column{};
    for (int i = 0; i < problem.count; ++i) {
      const ContactLaw& law = problem.law(i);
      const AssumedRegime& assumed = at(i);
      const int t = problem.tangent_row(i);
      normal_column[as(i)] = -1;
      if (assumed.pressed) {
        B_(problem.first_row(i), column) = 1;
        normal_column[as(i)] = column;
        rows_[as(column++)] = problem.first_row(i);
      }
      const int by = law.normal ? i : law.pressed_by;
      const int pressing = by < 0 ? -1 : normal_column[as(by)];
      for (int k = 0; assumed.friction == Friction::slides && k < law.tangents; ++k) {
        c_(t + k) = -law.bound * assumed.direction[as(k)];
        if (pressing >= 0) B_(t + k, pressing) = -law.friction * assumed.direction[as(k)];
      }
      for (int k = 0; assumed.friction == Friction::sticks && k < law.tangents; ++k) {
        B_(t + k, column) = 1;
        rows_[as(column++)] = t + k;
      }
    }
    const Matrix WB = problem.W * B_;
    const Vector rest = problem.W * c_ + problem.q;
    E_.resize(column, column);
    e_.resize(column);
    for (int i = 0; i < column; ++i) {
      E_.row(i) = WB.row(rows_[as(i)]);
      e_(i) = -rest(rows_[as(i)]);
    }
  }

  [[nodiscard]] int unknowns() const noexcept {
    int n = 0;
    for (int i = 0; i < problem_.count; ++i) {
      n += (at(i).pressed ? 1 : 0) + (at(i).friction == Friction::sticks ? problem_.law(i).tangents : 0);
    }
    return n;
  }

  /// Solves E x = e; false where there is no solution. `kernel()` then holds what may be added to x.
  [[nodiscard]] bool solve() noexcept {
    const int n = static_cast<int>(E_.cols());
    kernel_.resize(n, 0);
    x_.setZero(n);
    if (n == 0) return true;
    lu_.compute(E_);
    // A pivot below this share of the largest is what rounding leaves of a row that depends on others.
    lu_.setThreshold(1e-11);
    x_ = lu_.solve(e_);
    if (lu_.rank() < n) {
      kernel_ = lu_.kernel();
      const Vector left = E_ * x_ - e_;
      const double size = E_.cwiseAbs().maxCoeff() * x_.cwiseAbs().maxCoeff() + e_.cwiseAbs().maxCoeff();
      return left.cwiseAbs().maxCoeff() <= 1e-10 * size;
    }
    return x_.allFinite();
  }

  [[nodiscard]] const Matrix& kernel() const noexcept { return kernel_; }
  [[nodiscard]] Vector& x() noexcept { return x_; }
  [[nodiscard]] Vector reactions() const noexcept { return B_ * x_ + c_; }
  [[nodiscard]] Vector motion() const noexcept { return problem_.W * reactions() + problem_.q; }
  [[nodiscard]] const Matrix& B() const noexcept { return B_; }

  [[nodiscard]] double determinant() const noexcept { return E_.cols() == 0 ? 1.0 : lu_.determinant(); }

  /// du/dα where the direction of contact i turns by α: B and c turn with it, and x follows.
  [[nodiscard]] Vector motion_by_turning(int i) const noexcept {
    const ContactLaw& law = problem_.law(i);
    const int t = problem_.tangent_row(i);
    const Vector r = reactions();
    const double pull = law.friction * problem_.pressing(i, r) + law.bound;
    Vector dr = Vector::Zero(problem_.rows());
    dr(t) = pull * at(i).direction[1];
    dr(t + 1) = -pull * at(i).direction[0];
    const Vector du = problem_.W * dr;
    const int n = static_cast<int>(E_.cols());
    if (n == 0) return du;
    Vector right(n);
    for (int k = 0; k < n; ++k) right(k) = -du(rows_[as(k)]);
    const Vector dx = lu_.solve(right);
    return du + problem_.W * (B_ * dx);
  }

  [[nodiscard]] const AssumedRegime& at(int contact) const noexcept { return regimes_[as(contact)]; }

 private:
  static std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

  const Problem& problem_;
  const Regimes& regimes_;
  Matrix B_, E_, kernel_;
  Vector c_, e_, x_;
  std::array<int, static_cast<std::size_t>(Problem::capacity)> rows_{};
  Eigen::FullPivLU<Matrix> lu_;
};

}  // namespace torsor::runtime
