// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "torsor/runtime/contacts/contact_dynamics.hpp"
#include "torsor/runtime/contacts/contact_result.hpp"
#include "torsor/runtime/contacts/contact_selection.hpp"
#include "torsor/runtime/contacts/gap_rounding.hpp"

namespace torsor::runtime {

/// Steps of Moreau and Jean, for a mechanism with contacts:
///   q_m = q + (1 - θ) h q'(v);  v+ = v + h M^-1 F + M^-1 J^T P at q_m;  q+ = q_m + θ h q'(v+),
///   0 <= w_N+ + e w_N-, P_N >= 0, |P_T| <= f P_N,
/// for the contacts whose gap is closed at q_m; where θ > 1/2, those of the step before too whose gap would be closed in the
/// middle of this one without them. No event is located: impacts, accumulations and ends of slip happen within steps, and the
/// error is of first order in h. Forces are those of q_m and v, but for damping that the mechanism tells of
/// (ContactMechanism::damping): M + θ h d stands for M then, so that what damps is taken at v + θ (v+ - v). Gaps below zero are
/// put back by displacements that do not become velocities. The last impulses of a contact are the first guess of its next.
/// Source: Acary & Brogliato 2008, chapter 10.
class MoreauJean {
 public:
  /// The system must live as long.
  template <ContactSystem S>
  explicit MoreauJean(const S& system, double theta = 0.5)
      : MoreauJean(std::make_unique<ContactMechanismOf<S>>(system), theta) {}
  template <ContactSystem S>
  explicit MoreauJean(const S&&, double = 0.5) = delete;  ///< a temporary system does not live as long
  explicit MoreauJean(std::unique_ptr<const ContactMechanism> mechanism, double theta = 0.5);

  /// One step of length h > 0 from (t, y), 0 <= θ <= 1. False with a status where it cannot be made; y is then as before.
  bool step(double t, double h, std::span<double> y);

  [[nodiscard]] ContactStatus status() const noexcept { return status_; }
  [[nodiscard]] double residual() const noexcept { return residual_; }  ///< certificate of the last step
  [[nodiscard]] double depth() const noexcept { return depth_; }  ///< [m] below zero before its end put it back
  /// The one whose rule is invalid, or without a point.
  [[nodiscard]] std::optional<int> contact() const noexcept { return contact_; }
  [[nodiscard]] const ContactVector& impulses() const noexcept { return impulses_; }  ///< of the last step, all rows

 private:
  static constexpr std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }
  bool end(ContactStatus status) noexcept;
  [[nodiscard]] int count() const noexcept { return mechanism_->sizes().contacts; }
  [[nodiscard]] int rows() const noexcept { return first_row_[as(count())]; }
  void move(double t, std::span<double> y, double h);
  /// Damping taken implicitly over this time is a part of M.
  [[nodiscard]] bool read(double t, std::span<const double> y, double damped);
  [[nodiscard]] bool has_points() noexcept;
  [[nodiscard]] double rounding_of_gap(int i, std::span<const double> y) const noexcept;
  /// Whether a gap, and its change to where it is asked, leaves a contact open.
  [[nodiscard]] bool opens(int i, std::span<const double> y, double change) const;
  [[nodiscard]] bool displaced(std::span<const double> y) const;
  bool move_through(double t, double h, std::span<double> y);
  bool put_back(double t, std::span<double> y);

  std::unique_ptr<const ContactMechanism> mechanism_;
  const double theta_;
  PerContact<ContactRule> rules_{};
  PerContact<bool> closed_{};  ///< had an impulse in the last step, or was put back
  std::array<int, static_cast<std::size_t>(most_contacts) + 1> first_row_{}, first_bearing_{};
  ContactReading reading_;
  GapRounding gap_rounding_;  ///< of lengths, as measured at the first step
  bool measured_ = false;
  ContactDynamics dynamics_;
  Eigen::VectorXd change_, v_;
  std::vector<double> middle_, before_, rates_, damping_;
  ContactVector impulses_;  ///< of the last step
  ContactVector guess_;     ///< the last impulses of each contact, kept while it is open
  ContactStatus status_ = ContactStatus::reached_end;
  double residual_ = 0, depth_ = 0;
  std::optional<int> contact_;
};

/// Steps of equal length.
struct EqualSteps {
  long count = 1;
  double theta = 0.5;  ///< 0 <= θ <= 1, see MoreauJean
};

/// Equal steps from t0 to t1; the status of the last one. invalid_options where t1 < t0 or there is no step.
template <ContactSystem S>
ContactStatus step_contacts(const S& system, std::array<double, S::nq + S::nv>& y, double t0, double t1,
                            const EqualSteps& steps) {
  MoreauJean scheme(system, steps.theta);
  if (!(t1 >= t0) || steps.count < 1) return ContactStatus::invalid_options;
  if (settle_start(system, y) != Evaluation::ok) return ContactStatus::zero_quaternion;
  if (t1 == t0) return scheme.status();
  const double h = (t1 - t0) / static_cast<double>(steps.count);
  for (long k = 0; k < steps.count; ++k) {
    if (!scheme.step(t0 + static_cast<double>(k) * h, h, y)) return scheme.status();
  }
  return ContactStatus::reached_end;
}

}  // namespace torsor::runtime
