// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/regime_system.hpp"

#include <algorithm>
#include <cmath>

namespace torsor::runtime {

RegimeSystem::RegimeSystem(const ContactProblem& problem, const ContactScale& scale, const Regimes& regimes) noexcept
    : problem_(problem), scale_(scale), regimes_(regimes) {
  const int rows = problem.rows();
  B_.setZero(rows, unknowns());
  c_.setZero(rows);
  int column = 0;
  PerContact<int> normal_column{};  // of contacts that are pressed
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    const AssumedRegime& assumed = at(i);
    const int t = problem.tangent_row(i);
    if (assumed.pressed) {
      B_(problem.first_row(i), column) = 1;
      normal_column[as(i)] = column;
      rows_[as(column++)] = problem.first_row(i);
    }
    const std::optional<int> by = law.normal ? i : law.pressed_by;
    const int* const pressing = by && at(*by).pressed ? &normal_column[as(*by)] : nullptr;
    if (slides_in_bearing(i)) {
      bearings_ = true;
      for (int k = 0; k < law.tangents; ++k) B_(t + k, column) = -assumed.direction[as(k)];
      column_[as(i)] = column++;
      continue;
    }
    for (int k = 0; assumed.friction == Friction::slides && k < law.tangents; ++k) {
      c_(t + k) = -law.bound * assumed.direction[as(k)];
      if (pressing != nullptr) B_(t + k, *pressing) = -law.friction * assumed.direction[as(k)];
    }
    for (int k = 0; assumed.friction == Friction::sticks && k < law.tangents; ++k) {
      B_(t + k, column) = 1;
      rows_[as(column++)] = t + k;
    }
  }
  const ContactMatrix WB = problem.W * B_;
  const ContactVector rest = problem.W * c_ + problem.q;
  E_.resize(column, column);
  e_.resize(column);
  for (int i = 0; i < column; ++i) {
    if (!rows_[as(i)]) continue;
    E_.row(i) = WB.row(*rows_[as(i)]);
    e_(i) = -rest(*rows_[as(i)]);
  }
}

int RegimeSystem::unknowns() const noexcept {
  int n = 0;
  for (int i = 0; i < problem_.count; ++i) {
    n += (at(i).pressed ? 1 : 0) + (at(i).friction == Friction::sticks ? problem_.law(i).tangents : 0) +
         (slides_in_bearing(i) ? 1 : 0);
  }
  return n;
}

bool RegimeSystem::solve() noexcept {
  if (!bearings_) return solve_linear();
  start_along();
  double last = INFINITY;
  for (int step = 0; step < 50; ++step) {
    equate_bearings();
    if (!solve_linear()) return false;
    const double turned = turn_bearings();
    if (turned <= 4e-16 || (turned <= 1e-13 && turned >= last)) return true;
    last = turned;
  }
  return false;
}

void RegimeSystem::start_along() noexcept {
  const ContactVector none = ContactVector::Zero(problem_.rows());
  const auto set = [this](int i, const std::array<double, 2>& R) {
    const double length = std::hypot(R[0], R[1]);
    if (length > 0) along_[as(i)] = {R[0] / length, R[1] / length};
  };
  const auto is_given = [this](int i) { return at(i).along[0] != 0 || at(i).along[1] != 0; };
  for (int i = 0; i < problem_.count; ++i) {
    along_[as(i)] = {1, 0};
    if (slides_in_bearing(i)) set(i, is_given(i) ? at(i).along : problem_.bearing(i, none));
  }
  for (int i = 0; i < problem_.count; ++i) {
    if (!slides_in_bearing(i) || (is_given(i) && !at(i).reversed)) continue;
    if (problem_.law(i).bearing == 1) {  // R has two signs
      if (at(i).reversed) along_[as(i)][0] *= -1;
      continue;
    }
    // |R| - |T|/f is convex in |T|: its two zeros lie on either side of a minimum. One is found from T = 0, the other one
    // from far away, where R is what T alone makes.
    const auto [near, far] = line_of_reaction(i);
    set(i, at(i).reversed ? far : near);
  }
}

// R = near + far |T| where the other equations hold.
std::pair<std::array<double, 2>, std::array<double, 2>> RegimeSystem::line_of_reaction(int i) noexcept {
  std::array<double, 2> near{0, 0}, far{0, 0};
  const ContactVector right = e_;
  const int column = column_[as(i)];
  equate_bearings();
  E_.row(column).setZero();
  E_(column, column) = 1;
  e_(column) = 0;
  if (solve_linear()) near = problem_.bearing(i, reactions());
  e_.setZero();
  e_(column) = 1;
  if (solve_linear()) {
    const ContactVector by_friction = B_ * x_;
    for (int k = 0, row = problem_.bearing_row(i); k < problem_.law(i).bearing; ++k, ++row) {
      far[as(k)] = problem_.S.row(row).dot(by_friction);
    }
  }
  e_ = right;
  return {near, far};
}

ContactVector RegimeSystem::pull_of_bearing(int i) const noexcept {
  ContactVector pull = ContactVector::Zero(problem_.rows());
  for (int k = 0, row = problem_.bearing_row(i); k < problem_.law(i).bearing; ++k, ++row) {
    pull += problem_.law(i).friction * along_[as(i)][as(k)] * problem_.S.row(row).transpose();
  }
  return pull;
}

void RegimeSystem::equate_bearings() noexcept {
  for (int i = 0; i < problem_.count; ++i) {
    if (!slides_in_bearing(i)) continue;
    const ContactLaw& law = problem_.law(i);
    const ContactVector pull = pull_of_bearing(i);
    const int column = column_[as(i)];
    E_.row(column) = -pull.transpose() * B_;
    E_(column, column) += 1;
    e_(column) = law.bound + pull.dot(c_);
    for (int k = 0, row = problem_.bearing_row(i); k < law.bearing; ++k, ++row) {
      e_(column) += law.friction * along_[as(i)][as(k)] * problem_.c(row);
    }
    E_.row(column) *= mobility(i);
    e_(column) *= mobility(i);
  }
}

double RegimeSystem::turn_bearings() noexcept {
  const ContactVector r = reactions();
  double turned = 0;
  for (int i = 0; i < problem_.count; ++i) {
    if (!slides_in_bearing(i)) continue;
    const auto R = problem_.bearing(i, r);
    const double length = std::hypot(R[0], R[1]);
    double terms = 0;
    for (int k = 0, row = problem_.bearing_row(i); k < problem_.law(i).bearing; ++k, ++row) {
      terms += problem_.S.row(row).cwiseAbs().dot(r.cwiseAbs()) + std::abs(problem_.c(row));
    }
    if (!(length > 1e-14 * terms)) continue;  // rounding of a zero has no direction, and any ρ will do
    auto& along = along_[as(i)];
    turned = std::max({turned, std::abs(R[0] / length - along[0]), std::abs(R[1] / length - along[1])});
    along = {R[0] / length, R[1] / length};
  }
  return turned;
}

int RegimeSystem::row_of(int unknown) const noexcept {
  if (rows_[as(unknown)]) return *rows_[as(unknown)];
  // A column without a row is the reaction that a sliding bearing adds.
  int contact = 0;
  const auto is_of = [&](int i) { return slides_in_bearing(i) && column_[as(i)] == unknown; };
  while (contact + 1 < problem_.count && !is_of(contact)) ++contact;
  return problem_.tangent_row(contact);
}

ContactVector RegimeSystem::over_units() const noexcept {
  ContactVector over(E_.cols());
  for (int k = 0; k < static_cast<int>(over.size()); ++k) over(k) = 1 / scale_.unit(row_of(k));
  return over;
}

bool RegimeSystem::solve_linear() noexcept {
  const int n = static_cast<int>(E_.cols());
  kernel_.resize(n, 0);
  x_.setZero(n);
  if (n == 0) return true;
  const ContactVector over = over_units();
  lu_.compute(over.asDiagonal() * E_ * over.asDiagonal());
  // A pivot below this share of the largest is what rounding leaves of a row that depends on others.
  lu_.setThreshold(1e-11);
  x_ = over.cwiseProduct(lu_.solve(over.cwiseProduct(e_)));
  if (lu_.rank() < n) {
    kernel_ = over.asDiagonal() * lu_.kernel();
    const ContactVector left = E_ * x_ - e_, terms = E_.cwiseAbs() * x_.cwiseAbs() + e_.cwiseAbs();
    ContactVector off = ContactVector::Zero(problem_.rows()), size = off;
    if (problem_.noise.size() > 0) size = problem_.noise;
    for (int k = 0; k < n; ++k) {
      off(row_of(k)) = left(k);
      size(row_of(k)) += 1e-10 * terms(k);
    }
    return largest_part(off, scale_.motions(size)) <= 1;
  }
  return x_.allFinite();
}

double RegimeSystem::scaled_determinant() const noexcept {
  const int n = static_cast<int>(E_.cols());
  if (n == 0) return 1;
  ContactMatrix own(n, n);
  std::array<double, static_cast<std::size_t>(most_rows)> sizes;
  sizes.fill(1);
  for (int i = 0; i < problem_.count && bearings_; ++i) {
    if (slides_in_bearing(i)) sizes[as(column_[as(i)])] = mobility(i);
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const std::optional<int> row = rows_[as(i)], column = rows_[as(j)];
      own(i, j) = row && column ? problem_.W(*row, *column) : i == j ? sizes[as(i)] : 0;  // |T| of a bearing is 0
    }
  }
  const ContactVector over = over_units();
  const Eigen::FullPivLU<ContactMatrix> without_slips(over.asDiagonal() * own * over.asDiagonal());
  const auto sign = [](const Eigen::FullPivLU<ContactMatrix>& lu) {
    return lu.permutationP().determinant() * lu.permutationQ().determinant();
  };
  double ratio = static_cast<double>(sign(lu_) * sign(without_slips));
  for (int i = 0; i < n; ++i) ratio *= lu_.matrixLU()(i, i) / without_slips.matrixLU()(i, i);
  return std::isfinite(ratio) ? ratio : 1;
}

void RegimeSystem::approach(const ContactVector& reactions) noexcept {
  if (kernel_.cols() == 0) return;
  ContactVector missing = -x_;
  for (int i = 0; i < static_cast<int>(missing.size()); ++i) {
    if (rows_[as(i)]) missing(i) += reactions(*rows_[as(i)]);
  }
  for (int i = 0; i < problem_.count && bearings_; ++i) {
    if (!slides_in_bearing(i)) continue;
    const int t = problem_.tangent_row(i);
    for (int k = 0; k < problem_.law(i).tangents; ++k) missing(column_[as(i)]) -= at(i).direction[as(k)] * reactions(t + k);
  }
  // Nearest in the unit of each: a force and a moment have none in common.
  const ContactVector over = over_units();
  const ContactMatrix near = over.cwiseInverse().asDiagonal() * kernel_, square = near.transpose() * near;
  const ContactVector right = near.transpose() * missing.cwiseQuotient(over);
  x_ += kernel_ * square.partialPivLu().solve(right);
}

ContactVector RegimeSystem::motion_by_turning(int i) const noexcept {
  const ContactLaw& law = problem_.law(i);
  const int t = problem_.tangent_row(i);
  const ContactVector r = reactions();
  const double pull = law.friction * problem_.pressing(i, r) + law.bound;
  ContactVector dr = ContactVector::Zero(problem_.rows());
  dr(t) = pull * at(i).direction[1];
  dr(t + 1) = -pull * at(i).direction[0];
  const ContactVector du = problem_.W * dr;
  const int n = static_cast<int>(E_.cols());
  if (n == 0) return du;
  ContactVector right(n);
  for (int k = 0; k < n; ++k) right(k) = rows_[as(k)] ? -du(*rows_[as(k)]) : 0;
  for (int j = 0; j < problem_.count && bearings_; ++j) {
    if (slides_in_bearing(j)) right(column_[as(j)]) = mobility(j) * pull_of_bearing(j).dot(dr);
  }
  const ContactVector over = over_units();
  const ContactVector dx = over.cwiseProduct(lu_.solve(over.cwiseProduct(right)));
  return du + problem_.W * (B_ * dx);
}

}  // namespace torsor::runtime
