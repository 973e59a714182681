// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/moreau_jean.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "torsor/runtime/contacts/contact_solver.hpp"

namespace torsor::runtime {

MoreauJean::MoreauJean(std::unique_ptr<const ContactMechanism> mechanism, double theta)
    : mechanism_(std::move(mechanism)), theta_(theta), gap_rounding_(*mechanism_) {
  for (int i = 0; i < count(); ++i) {
    rules_[as(i)] = mechanism_->rule(i);
    first_row_[as(i) + 1] = first_row_[as(i)] + std::clamp(rules_[as(i)].rows(), 0, 3);  // a rule may be impossible
    first_bearing_[as(i) + 1] = first_bearing_[as(i)] + std::clamp(rules_[as(i)].bearing, 0, 2);
  }
  const ContactSizes& sizes = mechanism_->sizes();
  middle_.resize(as(sizes.coordinates + sizes.velocities));
  before_ = middle_;
  rates_.resize(as(sizes.coordinates));
  damping_.resize(as(sizes.velocities));
  for (int i = 0; i < count(); ++i) {
    if (valid_rule(std::span(rules_).first(as(count())), i)) continue;
    status_ = ContactStatus::invalid_rule;
    contact_ = i;
    return;
  }
  reading_ = ContactReading(sizes, rows(), first_bearing_[as(count())]);
  impulses_.setZero(rows());
  guess_ = impulses_;
}

bool MoreauJean::end(ContactStatus status) noexcept {
  status_ = status;
  return false;
}

bool MoreauJean::step(double t, double h, std::span<double> y) {
  if (status_ == ContactStatus::invalid_rule) return false;
  const auto finite = [&y] { return std::all_of(y.begin(), y.end(), [](double each) { return std::isfinite(each); }); };
  if (!(h > 0 && std::isfinite(t + h) && theta_ >= 0 && theta_ <= 1)) return end(ContactStatus::invalid_options);
  if (!finite()) return end(ContactStatus::integration_failed);
  status_ = ContactStatus::reached_end;
  contact_.reset();
  if (!measured_) gap_rounding_.measure(t, y);
  measured_ = true;
  before_.assign(y.begin(), y.end());
  if (move_through(t, h, y) && (finite() || end(ContactStatus::integration_failed))) return true;
  std::copy(before_.begin(), before_.end(), y.begin());
  return false;
}

bool MoreauJean::move_through(double t, double h, std::span<double> y) {
  std::copy_n(y.begin(), middle_.size(), middle_.begin());
  move(t, middle_, (1 - theta_) * h);
  const double there = t + (1 - theta_) * h;
  if (!read(there, middle_, theta_ * h)) return false;
  // Loops are held as contacts are, by their velocities at q_m.
  change_ = dynamics_.closing_rate + h * dynamics_.KF;
  v_ = change_;
  const auto nq = rates_.size();
  for (int i = 0; i < mechanism_->sizes().velocities; ++i) v_(i) += y[nq + as(i)];
  ContactVector w_free = reading_.w;
  w_free.noalias() += reading_.J * change_;
  // With θ beyond 1/2 q_m is nearer to the start, where no gap is below zero: one that was closed is asked in the middle too.
  const ContactVector to_middle = std::max(theta_ - 0.5, 0.0) * h * w_free;
  ContactSelection chosen;
  for (int i = 0; i < count(); ++i) {
    const ContactRule& rule = rules_[as(i)];
    const std::optional<int> by = rule.normal ? i : rule.pressed_by;
    if (by && opens(*by, middle_, closed_[as(*by)] ? to_middle(first_row_[as(*by)]) : 0)) continue;
    ContactLaw law = rule.law();
    law.bound *= h;  // bounded forces, as impulses of the step
    law.static_bound *= h;
    const double before = reading_.w(first_row_[as(i)]);
    if (rule.normal && before < 0) w_free(first_row_[as(i)]) += rule.restitution * before;
    chosen.add(i, law, first_row_[as(i)], first_bearing_[as(i)]);
  }
  chosen.fill(dynamics_.W, w_free, dynamics_.S, h * dynamics_.R_free);
  const ContactVector start = chosen.gather(guess_);
  impulses_.setZero(rows());
  residual_ = 0;
  if (chosen.problem.count > 0) {
    const ContactAnswer answer = go_on_contacts(chosen.problem, start);
    if (!answer) return end(status_without_regimes(answer.verdict));
    residual_ = answer.best().residual;
    impulses_ = chosen.spread(answer.best().r, rows());
    // Contacts of a foot that settles are open in every other step: they keep what they had.
    for (int k = 0; k < chosen.rows; ++k) guess_(chosen.row[as(k)]) = impulses_(chosen.row[as(k)]);
    dynamics_.add_answer(impulses_, v_);
  }
  for (int i = 0; i < count(); ++i) closed_[as(i)] = rules_[as(i)].normal && impulses_(first_row_[as(i)]) > 0;
  for (int i = 0; i < mechanism_->sizes().velocities; ++i) middle_[nq + as(i)] = v_(i);
  move(there, middle_, theta_ * h);
  std::copy(middle_.begin(), middle_.end(), y.begin());
  return put_back(t + h, y);
}

void MoreauJean::move(double t, std::span<double> y, double h) {
  mechanism_->coordinate_rates(t, y, rates_);
  for (std::size_t i = 0; i < rates_.size(); ++i) y[i] += h * rates_[i];
}

bool MoreauJean::read(double t, std::span<const double> y, double damped) {
  if (mechanism_->read(t, y, reading_) != Evaluation::ok) return end(ContactStatus::integration_failed);
  if (!has_points()) return false;
  if (damped > 0 && mechanism_->damping(t, y, damping_)) {
    for (std::size_t i = 0; i < damping_.size(); ++i) reading_.M.diagonal()(static_cast<Eigen::Index>(i)) += damped * damping_[i];
  }
  return (dynamics_.compute(reading_) && dynamics_.respond(reading_)) || end(ContactStatus::integration_failed);
}

double MoreauJean::rounding_of_gap(int i, std::span<const double> y) const noexcept {
  return gap_rounding_(i, reading_.J.row(first_row_[as(i)]), y);
}

// Corners of a body that lies on a surface are above zero or below by their rounding: it would tip over those that are below.
bool MoreauJean::opens(int i, std::span<const double> y, double change) const {
  return reading_.gap[as(i)] + change > 16 * rounding_of_gap(i, y);
}

// Rows of an open contact have no part in the step, whatever they are.
bool MoreauJean::has_points() noexcept {
  for (int i = 0; i < count(); ++i) {
    const int first = first_row_[as(i)], size = rules_[as(i)].rows();
    const std::optional<int> by = rules_[as(i)].normal ? i : rules_[as(i)].pressed_by;
    if (reading_.has_rows(first, size)) continue;
    if (!by || !(reading_.gap[as(*by)] > 0)) {
      contact_ = i;
      return end(ContactStatus::no_point);
    }
    reading_.J.middleRows(first, size).setZero();
    reading_.w.segment(first, size).setZero();
  }
  return true;
}

// Whether a gap is below zero or a loop is open by more than some roundings of what it depends on.
bool MoreauJean::displaced(std::span<const double> y) const {
  const ContactSizes& sizes = mechanism_->sizes();
  for (int i = 0; i < count(); ++i) {
    const double gap = rules_[as(i)].normal ? reading_.gap[as(i)] : 0;
    if (gap < 0 && -gap > 4 * rounding_of_gap(i, y)) return true;
  }
  for (Eigen::Index k = 0; k < reading_.A.rows(); ++k) {
    const double off = std::abs(reading_.value(k));
    if (off > 0 && off > 4 * rounding_of_position(reading_.A.row(k), y, sizes)) return true;
  }
  return false;
}

// The least displacement, in the metric of the masses, after which no gap is negative and loops are closed: contacts
// without friction, whose reactions are displacements.
bool MoreauJean::put_back(double t, std::span<double> y) {
  mechanism_->normalise(y);
  for (int repeat = 0; repeat < 3; ++repeat) {
    if (!read(t, y, 0)) return false;
    if (repeat == 0) {
      depth_ = 0;
      for (int i = 0; i < count(); ++i) {
        if (rules_[as(i)].normal) depth_ = std::max(depth_, -reading_.gap[as(i)]);
      }
    }
    if (!displaced(y)) return true;
    ContactVector gaps = ContactVector::Zero(rows()), guess = gaps;
    ContactSelection chosen;
    for (int i = 0; i < count(); ++i) {
      if (!rules_[as(i)].normal) continue;
      const int n = first_row_[as(i)];
      gaps(n) = reading_.gap[as(i)] + reading_.J.row(n).dot(dynamics_.closing);
      chosen.add(i, {.tangents = rules_[as(i)].tangents}, n);
      if (gaps(n) < 0 && dynamics_.W(n, n) > 0) guess(n) = -gaps(n) / dynamics_.W(n, n);
    }
    chosen.fill(dynamics_.W, gaps);
    const ContactAnswer answer = go_on_contacts(chosen.problem, chosen.gather(guess));
    if (!answer) return true;  // contacts that exclude each other
    change_ = dynamics_.closing;
    const ContactVector raised = chosen.spread(answer.best().r, rows());
    dynamics_.add_answer(raised, change_);
    for (int i = 0; i < count(); ++i) closed_[as(i)] = closed_[as(i)] || (rules_[as(i)].normal && raised(first_row_[as(i)]) > 0);
    std::copy_n(y.begin(), middle_.size(), middle_.begin());
    for (int i = 0; i < mechanism_->sizes().velocities; ++i) middle_[rates_.size() + as(i)] = change_(i);
    mechanism_->coordinate_rates(t, middle_, rates_);
    for (std::size_t i = 0; i < rates_.size(); ++i) y[i] += rates_[i];
  }
  return true;
}

}  // namespace torsor::runtime
