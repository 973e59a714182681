// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/verification/check_contacts.hpp"

#include "generator/dynamics/forces/contacts.hpp"
#include "generator/verification/moving_state.hpp"
#include "generator/verification/worst.hpp"

namespace torsor {
namespace {

class ContactCheck {
 public:
  ContactCheck(const Scene& scene, const CheckOptions& options)
      : scene_(scene),
        options_(options),
        // As in check_constraints: half the digits and ten more for the step of a quotient of second order.
        precision_(2 * options.digits + 50),
        h_(pow(Real(10), -options.digits / 2 - 10)),
        program_(Model::resolver(scene, {})),
        model_(scene, program_),
        contacts_(contact_rows(model_)) {}

  std::vector<CheckResult> run() {
    for (int k = 0; k < options_.states; ++k) {
      const RandomState state(scene_, static_cast<std::uint64_t>(k) + 1);
      const MovingState motion(scene_, state);
      Evaluator<Real> before(program_, motion.at(-h_)), here(program_, motion.at(Real(0))), after(program_, motion.at(h_));
      for (const ContactRows& contact : contacts_) {
        if (contact.normal) differentiate_gap(contact, before, here, after);
        for (const ContactRow& row : contact.rows) {
          const Real slope = (after(row.rate) - before(row.rate)) / (Real(2) * h_);
          const auto [acceleration, size] = accelerate(row, here);
          keep(slope - acceleration, size, motion_);
        }
      }
      change_velocities(state, here);
    }
    const double bound = pow(Real(10), 5 - options_.digits).to_double();
    return {{"contact_motion", "gaps and slips of contacts differentiated along a motion", motion_, bound},
            {"contact_rows", "velocities of contacts at changed velocities against their rows", rows_, bound}};
  }

 private:
  void keep(const Real& difference, const Real& scale, double& worst) const {
    if (abs(difference) < pow(Real(10), -options_.digits - 5)) return;
    const double relative = (abs(difference) / scale).to_double();
    if (is_worse(relative, worst)) worst = relative;
  }

  /// J v̇ + drift, and the size of its terms.
  std::pair<Real, Real> accelerate(const ContactRow& row, Evaluator<Real>& here) const {
    Real sum = here(row.drift), size = abs(sum) + abs(here(row.rate));
    for (int i = 0; i < model_.unknown_count(); ++i) {
      const Real term = here(row.jacobian[static_cast<std::size_t>(i)]) * here(model_.a(i));
      sum += term;
      size += abs(term);
    }
    return {sum, size};
  }

  void differentiate_gap(const ContactRows& contact, Evaluator<Real>& before, Evaluator<Real>& here,
                         Evaluator<Real>& after) {
    const Real earlier = before(contact.gap), middle = here(contact.gap), later = after(contact.gap);
    const Real rate = here(contact.rows[0].rate);
    const auto [acceleration, size] = accelerate(contact.rows[0], here);
    keep((later - earlier) / (Real(2) * h_) - rate, size, motion_);
    keep((later - middle - middle + earlier) / (h_ * h_) - acceleration, size, motion_);
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

  const Scene& scene_;
  CheckOptions options_;
  WorkingDigits precision_;
  Real h_;
  Program program_;
  Model model_;
  std::vector<ContactRows> contacts_;
  double motion_ = 0, rows_ = 0;
};

}  // namespace

std::vector<CheckResult> check_contacts(const Scene& scene, const CheckOptions& options) {
  if (scene.content().contacts.empty()) return {};
  return ContactCheck(scene, options).run();
}

}  // namespace torsor
