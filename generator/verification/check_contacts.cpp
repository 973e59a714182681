// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check_contacts.hpp"

#include "torsor/generator/dynamics/forces/contacts.hpp"
#include "torsor/generator/verification/motion_check.hpp"

namespace torsor {
namespace {

class ContactCheck : MotionCheck {
 public:
  ContactCheck(const Scene& scene, const CheckOptions& options)
      : MotionCheck(scene, options), contacts_(contact_rows(model_)) {}

  std::vector<CheckResult> run() {
    for (int k = 0; k < options_.states; ++k) {
      Moment at(*this, k + 1);
      for (const ContactRows& contact : contacts_) {
        if (contact.normal) differentiate_gap(contact, at);
        for (const ContactRow& row : contact.rows) {
          const auto [acceleration, size] = accelerate(row, at.here);
          keep(slope(row.rate, at) - acceleration, size, motion_);
        }
      }
      change_velocities(at.state, at.here);
    }
    return {{"contact_motion", "gaps and slips of contacts differentiated along a motion", motion_, bound()},
            {"contact_rows", "velocities of contacts at changed velocities against their rows", rows_, bound()}};
  }

 private:
  /// J v̇ + drift, and the size of its terms.
  std::pair<Real, Real> accelerate(const ContactRow& row, Evaluator<Real>& here) const {
    const auto [sum, size] = acceleration(row.jacobian, row.drift, here);
    return {sum, size + abs(here(row.rate))};
  }

  void differentiate_gap(const ContactRows& contact, Moment& at) {
    const auto [acceleration, size] = accelerate(contact.rows[0], at.here);
    keep(slope(contact.gap, at) - at.here(contact.rows[0].rate), size, motion_);
    keep(curvature(contact.gap, at) - acceleration, size, motion_);
  }

  void change_velocities(const RandomState& state, Evaluator<Real>& here) {
    for (int i = 0; i < model_.unknown_count(); ++i) {
      const SymbolPointer changed = model_.coordinates()[static_cast<std::size_t>(i)].v;
      Evaluator<Real> there(program_, [&, at = state.in_real()](const SymbolPointer& symbol) {
        return symbol == changed ? at(symbol) + Real(1) : at(symbol);
      });
      for (const ContactRows& contact : contacts_) {
        for (const ContactRow& row : contact.rows) {
          const Real before = here(row.rate), after = there(row.rate);
          keep(after - before - here(row.jacobian[static_cast<std::size_t>(i)]), abs(before) + abs(after), rows_);
        }
      }
    }
  }

  std::vector<ContactRows> contacts_;
  double motion_ = 0, rows_ = 0;
};

}  // namespace

std::vector<CheckResult> check_contacts(const Scene& scene, const CheckOptions& options) {
  if (scene.content().contacts.empty()) return {};
  return ContactCheck(scene, options).run();
}

}  // namespace torsor
