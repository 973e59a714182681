// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/evaluated_contacts.hpp"

#include "torsor/generator/dynamics/equations/constraint_rank.hpp"
#include "torsor/generator/program/written_unit.hpp"

namespace torsor {

EvaluatedContacts::EvaluatedContacts(const Scene& scene, const ModelOptions& options, const NamedNumbers& parameters,
                                     const NamedNumbers& inputs)
    : motion_(scene, options, parameters, inputs), rows_(contact_rows(motion_.equations().model())) {
  Program& program = motion_.equations().program();
  for (ContactRows& contact : rows_) {
    if (contact.normal) contact.gap = program.bind(contact.gap);
    for (ContactRow& row : contact.rows) {
      for (Value& entry : row.jacobian) entry = program.bind(entry);
      row.rate = program.bind(row.rate);
      row.drift = program.bind(row.drift);
    }
  }
  for (const ContactRows& contact : rows_) {
    gaps_.push_back(contact.normal ? std::optional(motion_.ready(contact.gap)) : std::nullopt);
    for (const ContactRow& row : contact.rows) {
      ReadyRow& ready = ready_rows_.emplace_back(ReadyRow{{}, motion_.ready(row.rate), motion_.ready(row.drift)});
      for (const Value& entry : row.jacobian) ready.jacobian.push_back(motion_.ready(entry));
    }
  }
  std::vector<int> components;
  for (std::vector<BearingReaction>& of_contact : bearing_reactions(motion_.equations())) {
    components.push_back(static_cast<int>(of_contact.size()));
    for (BearingReaction& component : of_contact) bearings_.push_back(std::move(component));
  }
  if (!motion_.equations().constraints().empty()) kept_ = motion_.equations().redundancy().kept;
  motion_.move_to(0.0, {});
  for (const ContactCoefficients& of : contact_coefficients(motion_.equations().model())) {
    const std::size_t contact = rules_.size();
    const ContactRows& rows = rows_[contact];
    rules_.push_back({.tangents = static_cast<int>(rows.tangents()),
                      .normal = rows.normal,
                      .pressed_by = rows.pressed_by ? std::optional(static_cast<int>(*rows.pressed_by)) : std::nullopt,
                      .bearing = components[contact],
                      .friction = motion_.value(of.friction),
                      .static_friction = motion_.value(of.static_friction),
                      .bound = motion_.value(of.bound),
                      .static_bound = motion_.value(of.static_bound),
                      .restitution = motion_.value(of.restitution)});
  }
}

std::string EvaluatedContacts::gap_unit(int contact) const {
  const Unit& unit = at(contact).gap.unit();
  return unit.is_dimensionless() ? "rad" : written_unit(unit);
}

std::string EvaluatedContacts::force_unit(int contact) const {
  return written_unit(units::joule / (at(contact).rows[0].rate.unit() * units::second));
}

std::string EvaluatedContacts::regime(int contact, runtime::ContactRegime regime) const {
  const runtime::ContactRule of = rule(contact);
  // What has no normal, as dry friction in a joint, cannot come apart: nothing presses it.
  if (regime == runtime::ContactRegime::open) return of.normal ? "is open" : "is free";
  return of.tangents == 0 ? "is closed" : std::string(describe(regime));
}

EvaluatedMechanism::EvaluatedMechanism(EvaluatedContacts& evaluated)
    : ContactMechanism({static_cast<int>(evaluated.motion().position_count()),
                        static_cast<int>(evaluated.motion().velocity_count()), evaluated.count(),
                        evaluated.constraint_count()}),
      contacts_(evaluated) {}

runtime::Evaluation EvaluatedMechanism::read(double t, std::span<const double> y,
                                             runtime::ContactReading& reading) const {
  EvaluatedMotion& motion = contacts_.motion();
  const auto at = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
  const std::size_t n = motion.velocity_count();
  const std::vector<double> now = state(y);
  std::vector<double> rates(now.size());
  if (!contacts_.read(t, now, rates)) return runtime::Evaluation::singular;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) reading.M(at(i), at(j)) = contacts_.mass(i, j);
  }
  // Accelerations hold the constraints already.
  Eigen::VectorXd a(at(n));
  for (std::size_t i = 0; i < n; ++i) a(at(i)) = rates[motion.position_count() + i];
  reading.F.noalias() = reading.M * a;
  for (std::size_t k = 0; k < static_cast<std::size_t>(contacts_.constraint_count()); ++k) {
    const ConstraintRow& row = contacts_.constraint(k);
    for (std::size_t j = 0; j < n; ++j) reading.A(at(k), at(j)) = motion.value(row.jacobian[j]);
    reading.value(at(k)) = row.holonomic ? motion.value(row.value) : 0.0;
    reading.rate(at(k)) = motion.value(row.rate);
  }
  reading.gamma.noalias() = -reading.A * a;
  for (std::size_t i = 0; i < contacts_.rows().size(); ++i) reading.gap[i] = contacts_.gap(i);
  Eigen::Index next = 0;
  for (const EvaluatedContacts::ReadyRow& row : contacts_.ready_rows()) {
    for (std::size_t j = 0; j < n; ++j) reading.J(next, at(j)) = motion.value(row.jacobian[j]);
    reading.w(next) = motion.value(row.rate);
    reading.drift(next++) = motion.value(row.drift);
  }
  for (std::size_t k = 0; k < contacts_.bearings().size(); ++k) {
    const BearingReaction& bearing = contacts_.bearings()[k];
    reading.R0(at(k)) = motion.value(bearing.rest);
    for (std::size_t j = 0; j < n; ++j) reading.B(at(k), at(j)) = motion.value(bearing.by_accelerations[j]);
    for (std::size_t j = 0; j < bearing.by_reactions.size(); ++j) {
      reading.C(at(k), at(j)) = motion.value(bearing.by_reactions[j]);
    }
    for (std::size_t j = 0; j < static_cast<std::size_t>(contacts_.constraint_count()); ++j) {
      reading.D(at(k), at(j)) = motion.value(bearing.by_multipliers[contacts_.kept(j)]);
      // F has the multipliers of these accelerations in it.
      reading.R0(at(k)) += reading.D(at(k), at(j)) * contacts_.multiplier(j);
    }
  }
  return runtime::Evaluation::ok;
}

void EvaluatedMechanism::coordinate_rates(double t, std::span<const double> y, std::span<double> rates) const {
  EvaluatedMotion& motion = contacts_.motion();
  motion.move_to(t, state(y));
  for (std::size_t i = 0; i < motion.position_count(); ++i) rates[i] = motion.position_rate(i);
}

void EvaluatedMechanism::normalise(std::span<double> y) const {
  std::vector<double> now = state(y);
  contacts_.motion().normalise(now);
  for (std::size_t i = 0; i < now.size(); ++i) y[i] = now[i];
}

// A state may have room for more.
std::vector<double> EvaluatedMechanism::state(std::span<const double> y) const {
  const auto some = y.first(static_cast<std::size_t>(sizes().coordinates + sizes().velocities));
  return {some.begin(), some.end()};
}

}  // namespace torsor
