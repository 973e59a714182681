// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/dynamics/theorems/bearing_reactions.hpp"
#include "torsor/generator/verification/evaluated_motion.hpp"
#include "torsor/runtime/contacts/contact_system.hpp"

namespace torsor {

/// What `runtime/contacts` asks of a mechanism, evaluated in `double` from the program of a scene.
class EvaluatedContacts {
 public:
  EvaluatedContacts(const Scene& scene, const ModelOptions& options, const NamedNumbers& parameters,
                    const NamedNumbers& inputs);

  EvaluatedMotion& motion() { return motion_; }
  int count() const { return static_cast<int>(rows_.size()); }
  int constraint_count() const { return static_cast<int>(kept_.size()); }
  const std::string& name(int contact) const { return at(contact).name; }
  const runtime::ContactRule& rule(int contact) const { return rules_[static_cast<std::size_t>(contact)]; }
  std::string gap_unit(int contact) const;
  /// That of N: a force over the unit of the gap's metre.
  std::string force_unit(int contact) const;
  /// "sticks"; of a contact without friction "closed".
  std::string regime(int contact, runtime::ContactRegime regime) const;

  /// Accelerations without contacts and all that belongs to a state; false where they are not determined.
  bool read(double t, const std::vector<double>& y, std::vector<double>& rates) { return motion_.slope(t, y, rates); }
  double mass(std::size_t i, std::size_t j) { return motion_.mass(i, j); }
  const std::vector<ContactRows>& rows() const { return rows_; }
  struct ReadyRow {
    std::vector<EvaluatedMotion::Ready> jacobian;
    EvaluatedMotion::Ready rate, drift;
  };
  /// Those of all contacts, and the gap of each that has one.
  const std::vector<ReadyRow>& ready_rows() const { return ready_rows_; }
  double gap(std::size_t contact) { return rows_[contact].normal ? motion_.value(*gaps_[contact]) : 0.0; }
  const std::vector<BearingReaction>& bearings() const { return bearings_; }
  /// λ of a constraint in the accelerations without contacts.
  double multiplier(std::size_t k) { return motion_.value(motion_.equations().forward().multipliers[kept_[k]]); }
  std::size_t kept(std::size_t k) const { return kept_[k]; }
  const ConstraintRow& constraint(std::size_t k) const { return motion_.constraint(kept_[k]); }

 private:
  const ContactRows& at(int contact) const { return rows_[static_cast<std::size_t>(contact)]; }

  EvaluatedMotion motion_;
  std::vector<ContactRows> rows_;
  std::vector<ReadyRow> ready_rows_;
  std::vector<std::optional<EvaluatedMotion::Ready>> gaps_;
  std::vector<BearingReaction> bearings_;
  std::vector<runtime::ContactRule> rules_;
  std::vector<std::size_t> kept_;  ///< constraints that repeat no other
};

/// The same as the runtime asks for it.
class EvaluatedMechanism final : public runtime::ContactMechanism {
 public:
  explicit EvaluatedMechanism(EvaluatedContacts& evaluated);

  runtime::ContactRule rule(int contact) const override { return contacts_.rule(contact); }
  runtime::Evaluation read(double t, std::span<const double> y, runtime::ContactReading& reading) const override;
  void coordinate_rates(double t, std::span<const double> y, std::span<double> rates) const override;
  void normalise(std::span<double> y) const override;

 private:
  std::vector<double> state(std::span<const double> y) const;
  EvaluatedContacts& contacts_;
};

}  // namespace torsor
