// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/slip_relations.hpp"

#include <cmath>
#include <optional>

namespace torsor::runtime {
namespace {

// Rows are without units here, W has about 1 in its diagonal: what is left of a row below the root of this is rounding.
constexpr double nothing = 1e-12;

/// Symmetric elimination of rows of u = W r + q that are zero.
class Elimination {
 public:
  Elimination(const ContactProblem& problem, const ContactScale& scale) noexcept {
    const int rows = problem.rows();
    const ContactVector sizes = scale.motions(problem.q.cwiseAbs());
    W_.resize(rows, rows);
    q_.resize(rows);
    error_.resize(rows);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < rows; ++j) W_(i, j) = problem.W(i, j) / (scale.unit(i) * scale.unit(j));
      q_(i) = problem.q(i) / scale.unit(i);
      error_(i) = (nothing * sizes(i) + (problem.noise.size() > 0 ? problem.noise(i) : 0)) / scale.unit(i);
    }
    least_ = nothing * W_.diagonal();
  }

  /// Whether forces move the row, but for rounding.
  [[nodiscard]] bool moves(int row) const noexcept { return W_(row, row) > least_(row); }
  /// Whether it is zero without forces.
  [[nodiscard]] bool rests(int row) const noexcept { return std::abs(q_(row)) <= error_(row); }
  /// The row of a list that forces move most, where they move one.
  template <class List>
  [[nodiscard]] std::optional<int> largest(const List& list, int count) const noexcept {
    std::optional<int> row;
    for (int k = 0; k < count; ++k) {
      const int each = list[static_cast<std::size_t>(k)];
      if (moves(each) && (!row || W_(each, each) > W_(*row, *row))) row = each;
    }
    return row;
  }
  /// W of two rows over the root of that of the second.
  [[nodiscard]] double part(int row, int of) const noexcept { return W_(row, of) / std::sqrt(W_(of, of)); }
  /// What is left of all rows where this one is zero.
  void eliminate(int row) noexcept {
    const ContactVector column = W_.col(row) / W_(row, row);
    const double q = q_(row), error = error_(row);
    q_ -= q * column;
    error_ += error * column.cwiseAbs();
    const ContactVector across = W_.row(row).transpose();
    W_.noalias() -= column * across.transpose();
    W_.row(row).setZero();
    W_.col(row).setZero();
  }

 private:
  ContactMatrix W_;
  ContactVector q_, error_, least_;
};

}  // namespace

SlipRelations::SlipRelations(const ContactProblem& problem, const ContactScale& scale,
                             const RegimeSystem::Regimes& regimes) noexcept {
  using Friction = AssumedRegime::Friction;
  std::array<int, static_cast<std::size_t>(most_rows)> zero{}, sought{};
  int zeros = 0, slips = 0;
  const auto add = [](auto& list, int& count, int row) { list[static_cast<std::size_t>(count++)] = row; };
  for (int i = 0; i < problem.count; ++i) {
    const AssumedRegime& regime = regimes[static_cast<std::size_t>(i)];
    const int t = problem.tangent_row(i);
    if (regime.pressed) add(zero, zeros, problem.first_row(i));
    for (int k = 0; k < problem.law(i).tangents; ++k) {
      if (regime.friction == Friction::sticks) add(zero, zeros, t + k);
      if (regime.direction_sought) add(sought, slips, t + k);
    }
  }
  Elimination left(problem, scale);
  while (const std::optional<int> row = left.largest(zero, zeros)) left.eliminate(*row);
  bool all_move = true;
  for (int k = 0; k < slips; k += 2) {
    const int x = sought[static_cast<std::size_t>(k)], y = sought[static_cast<std::size_t>(k) + 1];
    const bool moves = left.moves(x) || left.moves(y);
    all_move = all_move && moves;
    if (!moves && left.rests(x) && left.rests(y)) holds_one_ = true;
  }
  if (!all_move) return;
  const std::optional<int> first = left.largest(sought, slips);
  if (!first) return;
  ContactVector parts = ContactVector::Zero(problem.rows());
  for (int k = 0; k < slips; ++k) {
    const auto i = sought[static_cast<std::size_t>(k)];
    parts(i) = left.part(i, *first);
  }
  left.eliminate(*first);
  for (int k = 0; k < slips; ++k) {
    const int row = sought[static_cast<std::size_t>(k)];
    if (left.moves(row) || !left.rests(row)) return;
  }
  one_number_ = true;
  for (int i = 0; i < problem.count; ++i) {
    if (!regimes[static_cast<std::size_t>(i)].direction_sought) continue;
    const int t = problem.tangent_row(i);
    const double x = scale.unit(t) * parts(t), y = scale.unit(t + 1) * parts(t + 1), length = std::hypot(x, y);
    directions_[static_cast<std::size_t>(i)] = {x / length, y / length};
  }
}

}  // namespace torsor::runtime
