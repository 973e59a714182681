// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cli/evaluated_contacts.hpp"

#include "generator/dynamics/equations/constraint_rank.hpp"

namespace torsor {

EvaluatedContacts::EvaluatedContacts(const Scene& scene, const ModelOptions& options, const NamedNumbers& parameters,
                                     const NamedNumbers& inputs)
    : motion_(scene, options, parameters, inputs), rows_(contact_rows(motion_.equations().model())) {
  if (!motion_.equations().constraints().empty()) kept_ = motion_.equations().redundancy().kept;
  motion_.move_to(0.0, {});
  for (const ContactCoefficients& of : contact_coefficients(motion_.equations().model())) {
    const ContactRows& rows = rows_[rules_.size()];
    rules_.push_back({.tangents = static_cast<int>(rows.tangents()),
                      .normal = rows.normal,
                      .friction = motion_.value(of.friction),
                      .static_friction = motion_.value(of.static_friction),
                      .bound = motion_.value(of.bound),
                      .static_bound = motion_.value(of.static_bound),
                      .restitution = motion_.value(of.restitution)});
  }
}

std::string EvaluatedContacts::force_unit(int contact) const {
  return (units::joule / (at(contact).rows[0].rate.unit() * units::second)).to_string();
}

std::string EvaluatedContacts::regime(int contact, runtime::ContactRegime regime) const {
  return rule(contact).tangents == 0 ? "is closed" : std::string(describe(regime));
}

}  // namespace torsor
