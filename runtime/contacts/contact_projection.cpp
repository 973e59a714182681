// SPDX-License-Identifier: MIT
// How a motion with contacts is put back on its loops and on the contacts that are closed.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "torsor/runtime/contacts/contact_motion.hpp"
#include "torsor/runtime/contacts/contact_scale.hpp"

namespace torsor::runtime {
namespace {

// What rests at zero is put there anew by each step, which halves what is left of its numbers without end. Before products of
// three of them are zero for want of smaller numbers, so that decisions by their ratios fail, they are zero themselves.
void clear_traces(std::span<double> y) noexcept {
  constexpr double trace = 0x1p-300;
  for (double& each : y) {
    if (std::abs(each) < trace) each = 0;
  }
}

}  // namespace

// Rows of touching contacts for which `wanted` says so.
template <class Wanted>
void ContactMotion::select(const Wanted& wanted) {
  chosen_ = 0;
  right_.setZero(rows());
  over_.setZero(rows());
  for (int i = 0; i < count(); ++i) {
    if (!at(i).touches) continue;
    for (int k = 0; k < rule(i).rows(); ++k) {
      const int row = first_row(i) + k;
      if (!wanted(i, row, rule(i).normal && k == 0)) continue;
      over_(chosen_) = 1 / unit_of_row(dynamics_.W(row, row), rule(i).normal ? dynamics_.W(first_row(i), first_row(i)) : 0);
      row_[as(chosen_++)] = row;
    }
  }
}

// The least change of velocity, in the metric of the masses, that adds `right_` to the rows selected.
void ContactMotion::add_least_change() {
  if (chosen_ == 0) return;
  ContactMatrix W(chosen_, chosen_);
  ContactVector b(chosen_);
  const ContactVector over = over_.head(chosen_);
  for (int i = 0; i < chosen_; ++i) {
    b(i) = right_(row_[as(i)]);
    for (int j = 0; j < chosen_; ++j) W(i, j) = dynamics_.W(row_[as(i)], row_[as(j)]);
  }
  // Rows without units: which of them depend on others, or vanish, is no matter of masses.
  Eigen::FullPivLU<ContactMatrix> lu(over.asDiagonal() * W * over.asDiagonal());
  lu.setThreshold(1e-11);
  const ContactVector P = over.cwiseProduct(lu.solve(over.cwiseProduct(b)));
  ContactVector impulses = ContactVector::Zero(rows());
  for (int i = 0; i < chosen_; ++i) impulses(row_[as(i)]) = P(i);
  dynamics_.add_answer(impulses, change_);
}

Evaluation ContactMotion::project_positions(double t, std::span<double> y, int steps) {
  const bool touches = any_touches();
  mechanism_.normalise(y);  // gaps are those of unit quaternions
  for (int step = 0; step < steps; ++step) {
    if (!read(t, y) || (touches && !respond())) return Evaluation::singular;
    double worst = loops_off();
    select([&](int i, int row, bool normal) {
      if (!normal) return false;
      worst = std::max(worst, std::abs(reading_.gap[as(i)]));
      right_(row) = -reading_.gap[as(i)] - reading_.J.row(row).dot(dynamics_.closing);
      return true;
    });
    if (!(worst > 0)) break;
    change_ = dynamics_.closing;
    add_least_change();
    std::copy_n(y.begin(), there_.size(), there_.begin());  // y may have room for more
    for (int i = 0; i < sizes_.velocities; ++i) there_[as(sizes_.coordinates + i)] = change_(i);
    mechanism_.coordinate_rates(t, there_, rates_);
    double largest = 0, place = 0;
    for (std::size_t i = 0; i < rates_.size(); ++i) {
      y[i] += rates_[i];
      largest = std::max(largest, std::abs(rates_[i]));
      place = std::max(place, std::abs(y[i]));
    }
    if (largest <= 4 * std::numeric_limits<double>::epsilon() * place) break;
  }
  mechanism_.normalise(y);
  return Evaluation::ok;
}

Evaluation ContactMotion::project(double t, std::span<double> y, int steps) {
  const bool touches = any_touches();
  if (sizes_.constraints == 0 && !touches) {
    mechanism_.normalise(y);
    return Evaluation::ok;
  }
  const Evaluation placed = project_positions(t, y, steps);
  if (placed != Evaluation::ok) return placed;
  if (!read(t, y) || (touches && !respond())) return Evaluation::singular;
  select([&](int i, int row, bool normal) {
    right_(row) = -reading_.w(row) - reading_.J.row(row).dot(dynamics_.closing_rate);
    return normal || at(i).regime == ContactRegime::sticks;
  });
  change_ = dynamics_.closing_rate;
  add_least_change();
  for (int i = 0; i < sizes_.velocities; ++i) y[as(sizes_.coordinates + i)] += change_(i);
  clear_traces(y.first(there_.size()));
  return read(t, y) ? Evaluation::ok : Evaluation::singular;
}

// What a row of velocities that is held is off by, and what of that is an error of a step, or its rounding.
ContactMotion::Off ContactMotion::off(int row, std::span<const double> y) const noexcept {
  double terms = 0, own = 0;
  for (int j = 0; j < sizes_.velocities; ++j) {
    const double part = reading_.J(row, j) * y[as(sizes_.coordinates + j)];
    terms += std::abs(part);
    own += part;
  }
  terms += std::abs(reading_.w(row) - own);  // of a surface that moves
  const double unseen = 64 * rounding_of_time(t_) * terms_of_acceleration(row);
  return {std::abs(reading_.w(row)), terms, absolute_ + relative_ * terms + unseen};
}

// A step may reach over a place where the normal of a contact jumps, as that of a disc's rim does where the disc lies
// flat, or its gap, as that of a floor with a step, or the velocity of its surface, as that of a belt that starts. To project
// would be an impact that no law has decided, or move a body through a wall: a shorter step is asked for, and none is short
// enough. Where all is smooth, and the step was too long for it, the method sees it by what the projection moves.
Evaluation ContactMotion::hold(double t, std::span<double> y) {
  if (!any_touches()) return project(t, y);
  mechanism_.normalise(y);  // what is read here the projection begins with
  if (!read(t, y)) return Evaluation::singular;
  for (int i = 0; i < count(); ++i) {
    if (!at(i).touches) continue;
    const bool sticks = at(i).regime == ContactRegime::sticks;
    for (int k = 0; k < rule(i).rows(); ++k) {
      const int row = first_row(i) + k;
      const bool normal = rule(i).normal && k == 0;
      if (!normal && !sticks) continue;
      const Off now = off(row, y);
      // What is within the errors of the step, or its rounding, no projection of it can spoil.
      const bool turns = now.velocity > now.error && (now.velocity > now.terms / 16 || now.velocity > 16 * now.error);
      const auto velocity = [row](const ContactReading& reading) { return reading.w(row); };
      if (turns && jumps(t, y, velocity)) return jumps_at(i, t);
    }
    if (!rule(i).normal) continue;
    const auto moves = [&] {
      const double place = rounding_of_gap(i) / std::numeric_limits<double>::epsilon();
      return std::abs(reading_.gap[as(i)]) > 16 * (absolute_ + relative_ * place);
    };
    const auto gap = [i](const ContactReading& reading) { return reading.gap[as(i)]; };
    if (moves() && jumps(t, y, gap) && (!gaps_are_rougher() || moves())) return jumps_at(i, t);
  }
  return project(t, y);
}

Evaluation ContactMotion::jumps_at(int i, double t) noexcept {
  jumping_ = i;
  jumped_ = t;
  return Evaluation::singular;
}

bool ContactMotion::slip_has_jumped(int i) const noexcept {
  if (!at(i).touches || at(i).regime != ContactRegime::sticks) return false;
  bool any = false;
  for (int k = 0; k < rule(i).tangents; ++k) any = any || has_jumped(tangent_row(i) + k);
  return any;
}

bool ContactMotion::has_jumped(int row) const noexcept {
  const Off now = off(row, y_);
  return now.velocity > 16 * now.error + 1e4 * rounding_of(row);
}

std::optional<double> ContactMotion::pass_jump_of_slip(int i, double t, std::span<double> y) {
  return pass_to(t, y, [&](double later, std::span<const double> there) {
    return read(t + later, there) && slip_has_jumped(i);
  });
}

// Between the end of the last step and this state, whose velocities are kept.
bool ContactMotion::read_on_the_way(double part, double t, std::span<const double> y) {
  const auto nq = as(sizes_.coordinates);
  for (std::size_t k = 0; k < there_.size(); ++k) there_[k] = k < nq ? from_[k] + part * (y[k] - from_[k]) : y[k];
  mechanism_.normalise(there_);
  return mechanism_.read(from_t_ + part * (t - from_t_), there_, later_reading_) == Evaluation::ok;
}

// Whether the normal velocity that a step has left, or the gap, comes of one that jumps on its way. Where it turns smoothly, its
// change between two places, the velocity kept, halves as these come together, however large the error of the step.
template <class Number>
bool ContactMotion::jumps(double t, std::span<const double> y, const Number& number) {
  const double off = std::abs(number(reading_));
  if (!followed_) return false;
  const auto at_part = [&](double part) {
    return read_on_the_way(part, t, y) ? number(later_reading_) : std::numeric_limits<double>::quiet_NaN();
  };
  double low = 0, high = 1, below = at_part(low), above = number(reading_);
  while (std::abs(above - below) > off / 16) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high || high - low < 1e-13) return true;
    const double between = at_part(middle);
    if (!std::isfinite(between)) return true;  // no point there
    const bool later = std::abs(above - between) > std::abs(between - below);
    (later ? low : high) = middle;
    (later ? below : above) = between;
  }
  return false;
}

bool ContactMotion::gap_jumps(int i) {
  const int n = first_row(i);
  const double gap = reading_.gap[as(i)], speed = std::abs(reading_.w(n)), epsilon = std::numeric_limits<double>::epsilon();
  // Events are located to roundings of the time, and of the gap.
  if (!(gap > 1e4 * (rounding_of_gap(i) + speed * epsilon * std::abs(t_)))) return false;
  const double terms = acceleration_terms(i), share = gap / 1000;
  const double changes = std::min({speed > 0 ? share / speed : 1, terms > 0 ? std::sqrt(share / terms) : 1, 1.0});
  const double later = std::max(16 * epsilon * std::abs(t_), 1e-6 * changes);  // a tooth may be narrow
  const auto nq = as(sizes_.coordinates);
  mechanism_.coordinate_rates(t_, y_, rates_);
  for (std::size_t k = 0; k < there_.size(); ++k) there_[k] = k < nq ? y_[k] + later * rates_[k] : y_[k];
  mechanism_.normalise(there_);
  if (mechanism_.read(t_ + later, there_, later_reading_) != Evaluation::ok) return false;
  return !(later_reading_.gap[as(i)] > gap / 2) && (!gaps_are_rougher() || gap_jumps(i));
}

std::optional<int> ContactMotion::without_point(double t, std::span<const double> y) {
  if (!read(t, y)) return std::nullopt;
  const auto nq = as(sizes_.coordinates);
  for (int j = 0; j < sizes_.velocities; ++j) {
    std::copy_n(y.begin(), there_.size(), there_.begin());  // y may have room for more
    for (int k = 0; k < sizes_.velocities; ++k) there_[nq + as(k)] = k == j ? 1 : 0;
    mechanism_.coordinate_rates(t, there_, rates_);
    for (const double sign : {1.0, -1.0}) {
      for (std::size_t k = 0; k < there_.size(); ++k) {
        const double error = k < nq ? 16 * (absolute_ + relative_ * std::abs(y[k])) : 0;
        there_[k] = y[k] + (k < nq ? sign * error * rates_[k] : 0);
      }
      mechanism_.normalise(there_);
      if (mechanism_.read(t, there_, later_reading_) != Evaluation::ok) continue;
      for (int i = 0; i < count(); ++i) {
        if (!at(i).touches || !rule(i).normal) continue;
        const auto rows = reading_.J.middleRows(first_row(i), rule(i).rows());
        const auto others = later_reading_.J.middleRows(first_row(i), rule(i).rows());
        if (!((rows - others).cwiseAbs().maxCoeff() <= rows.cwiseAbs().maxCoeff() / 8)) return i;
      }
    }
  }
  return std::nullopt;
}

bool ContactMotion::off_by_a_jump(int i, double duration) const noexcept {
  const double way = std::abs(reading_.w(first_row(i))) * duration + acceleration_terms(i) * duration * duration;
  return std::abs(reading_.gap[as(i)]) > 1e4 * rounding_of_gap(i) + 1e3 * way;
}

std::optional<double> ContactMotion::pass_edge(int i, double t, std::span<double> y) {
  if (!at(i).touches) return std::nullopt;
  return pass_to(t, y, [&](double later, std::span<const double> there) {
    return read(t + later, there) && reading_.gap[as(i)] > 0 && off_by_a_jump(i, later);
  });
}

std::optional<double> ContactMotion::pass_ridge(int i, double t, std::span<double> y) {
  return pass_to(t, y, [&](double later, std::span<const double> there) {
    return read(t + later, there) && parts_by_a_jump(i);
  });
}

// The gap's change where it passes zero on the way from the last step's end: 2^-40 of all of it where that is smooth.
std::optional<int> ContactMotion::falls_by_a_jump(double t, std::span<const double> y) {
  if (!followed_ || !read(t, y)) return std::nullopt;
  for (int i = 0; i < count(); ++i) {
    const double last = reading_.gap[as(i)];
    if (at(i).touches || !rule(i).normal || !(last < 0)) continue;
    const auto gap_at = [&](double part) {
      return read_on_the_way(part, t, y) ? later_reading_.gap[as(i)] : std::numeric_limits<double>::quiet_NaN();
    };
    double low = 0, high = 1, above = gap_at(low), below = last;
    const double all = above - last;
    if (!(above > 0)) continue;
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = low + (high - low) / 2, gap = gap_at(middle);
      (gap > 0 ? low : high) = middle;
      (gap > 0 ? above : below) = gap;
    }
    const auto jumps = [&] { return above - below > 1e-6 * all + 1e4 * rounding_of_gap(i); };
    if (jumps() && (!gaps_are_rougher() || jumps())) return i;
  }
  return std::nullopt;
}

double ContactMotion::loops_off() const {
  return sizes_.constraints > 0 ? dynamics_.closing.cwiseAbs().maxCoeff() : 0;
}

bool ContactMotion::loops_closed(double first) const {
  double place = 0;
  for (int i = 0; i < sizes_.coordinates; ++i) place = std::max(place, std::abs(y_[as(i)]));
  return loops_off() <= std::max(1e-6 * first, 1e-12 * place);
}

}  // namespace torsor::runtime
