// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "torsor/runtime/contacts/contact_problem.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// What a surface is made of: the coefficients of one contact.
struct ContactRule {
  int tangents = 2;                         ///< 0: a stop, 1: in the plane, 2: in space
  bool normal = true;                       ///< false: dry friction in a joint, bounded by `bound`, or resistance to rolling
  std::optional<int> pressed_by{};          ///< of resistance to rolling or spinning: the contact, earlier in order, that rolls
  int bearing = 0;                          ///< of friction in proportion to a joint's reaction: how many components that has
  double friction = 0;                      ///< f while it slides; of resistance to rolling a length [m]
  std::optional<double> static_friction{};  ///< f_s while it sticks; f where none is given
  double bound = 0;                         ///< b [N]: |T| <= f N + b
  std::optional<double> static_bound{};     ///< b_s, the same; b where none is given
  double restitution = 0;                   ///< e, in [0, 1]

  [[nodiscard]] int rows() const noexcept { return (normal ? 1 : 0) + tangents; }
  /// Whether the rule of a contact, by its place among all, says what is possible; a number that is none is not.
  [[nodiscard]] bool valid(int contact) const noexcept {
    return friction >= 0 && sticking() >= friction && bound >= 0 && sticking_bound() >= bound &&
           std::isfinite(sticking() + sticking_bound()) && restitution >= 0 && restitution <= 1 && tangents >= 0 && tangents <= 2 && rows() > 0 &&
           (!pressed_by || (!normal && *pressed_by >= 0 && *pressed_by < contact)) && bearing >= 0 && bearing <= 2 &&
           (bearing == 0 || (!normal && !pressed_by && tangents == 1));
  }
  /// Its law of forces while it does not slip already.
  [[nodiscard]] ContactLaw law() const noexcept {
    return {.normal = normal,
            .pressed_by = pressed_by,
            .bearing = bearing,
            .tangents = tangents,
            .friction = friction,
            .static_friction = sticking(),
            .bound = bound,
            .static_bound = sticking_bound()};
  }
  [[nodiscard]] bool operator==(const ContactRule&) const = default;
  [[nodiscard]] double sticking() const noexcept { return static_friction.value_or(friction); }
  [[nodiscard]] double sticking_bound() const noexcept { return static_bound.value_or(bound); }
};

/// Whether the rule of a contact among all is possible, and what presses it a contact with a normal force.
[[nodiscard]] inline bool valid_rule(std::span<const ContactRule> rules, int contact) noexcept {
  const ContactRule& rule = rules[static_cast<std::size_t>(contact)];
  return rule.valid(contact) && (!rule.pressed_by || rules[static_cast<std::size_t>(*rule.pressed_by)].normal);
}

/// Numbers of coordinates, velocities, contacts and constraints that repeat no other.
struct ContactSizes {
  int coordinates = 0, velocities = 0, contacts = 0, constraints = 0;
};

/// A mechanism with contacts at one state: M a = F + J^T r + A^T λ, w = J v + b, dw/dt = J a + drift, A a + γ = 0. The
/// rows of J are contact by contact, the normal first (n from the other body to this one, so that w_N > 0 opens), then
/// the tangents. Of each constraint too: f(q, t), 0 where it is not holonomic, and its rate A v - b. All have their sizes
/// before a mechanism fills them.
///
/// Of joints whose friction is in proportion to their reactions, those: R = B a + C r + D λ + R0, in the order of the
/// contacts that have a `bearing`.
struct ContactReading {
  Eigen::MatrixXd M;
  Eigen::VectorXd F;
  std::vector<double> gap;
  Eigen::MatrixXd J;
  Eigen::VectorXd w, drift;
  Eigen::MatrixXd A;
  Eigen::VectorXd gamma, value, rate;
  Eigen::MatrixXd B, C, D;
  Eigen::VectorXd R0;

  ContactReading() = default;
  ContactReading(const ContactSizes& sizes, int rows, int bearings = 0);
  /// Whether these rows are numbers. They are none where a contact has no single point or normal.
  [[nodiscard]] bool has_rows(int first, int count) const {
    return J.middleRows(first, count).allFinite() && w.segment(first, count).allFinite() && drift.segment(first, count).allFinite();
  }
};

/// What rounding of the coordinates may make of a gap or of a constraint whose rate is this row times the velocities.
[[nodiscard]] double rounding_of_position(const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& rates,
                                          std::span<const double> y, const ContactSizes& sizes) noexcept;

/// What the non-smooth layer asks of a mechanism, whatever its type. A state y has the coordinates, then the velocities.
class ContactMechanism {
 public:
  /// Throws std::length_error for more contacts than `most_contacts`.
  explicit ContactMechanism(const ContactSizes& sizes);
  ContactMechanism(const ContactMechanism&) = delete;
  ContactMechanism& operator=(const ContactMechanism&) = delete;
  virtual ~ContactMechanism() = default;

  [[nodiscard]] const ContactSizes& sizes() const noexcept { return sizes_; }
  [[nodiscard]] virtual ContactRule rule(int contact) const = 0;
  [[nodiscard]] virtual Evaluation read(double t, std::span<const double> y, ContactReading& reading) const = 0;
  virtual void coordinate_rates(double t, std::span<const double> y, std::span<double> rates) const = 0;
  /// Puts quaternions back to the norm 1.
  virtual void normalise(std::span<double>) const {}
  /// The same of what a motion starts from, of any norm; false where one is zero.
  [[nodiscard]] virtual bool settle_start(std::span<double>) const { return true; }
  /// -∂F_j/∂v_j >= 0 of forces that damp, each its own velocity: steps of equal length take them implicitly. False: none.
  [[nodiscard]] virtual bool damping(double, std::span<const double>, std::span<double>) const { return false; }

 private:
  ContactSizes sizes_;
};

/// A type of mechanism whose sizes are known at compile time.
template <class S>
concept ContactSystem = requires(const S& system, double t, const std::array<double, S::nq + S::nv>& y,
                                 std::array<double, S::nq>& rates, ContactReading& reading) {
  requires S::contacts > 0 && S::contacts <= static_cast<std::size_t>(most_contacts);
  { system.rule(0) } -> std::convertible_to<ContactRule>;
  { system.read(t, y, reading) } -> std::same_as<Evaluation>;
  system.coordinate_rates(t, y, rates);
};

/// Such a mechanism, which must live as long, without its type.
template <ContactSystem S>
class ContactMechanismOf final : public ContactMechanism {
 public:
  explicit ContactMechanismOf(const S&&) = delete;  ///< a temporary system does not live as long
  explicit ContactMechanismOf(const S& system) : ContactMechanism(sizes_of_type()), system_(system) {}

  [[nodiscard]] ContactRule rule(int contact) const override { return system_.rule(contact); }
  [[nodiscard]] Evaluation read(double t, std::span<const double> y, ContactReading& reading) const override {
    return system_.read(t, state(y), reading);
  }
  void coordinate_rates(double t, std::span<const double> y, std::span<double> rates) const override {
    std::array<double, S::nq> values{};
    system_.coordinate_rates(t, state(y), values);
    for (std::size_t i = 0; i < S::nq; ++i) rates[i] = values[i];
  }
  void normalise(std::span<double> y) const override {
    if constexpr (requires(State& whole) { system_.normalise(whole); }) {
      State whole = state(y);
      system_.normalise(whole);
      std::copy(whole.begin(), whole.end(), y.begin());
    }
  }
  [[nodiscard]] bool settle_start(std::span<double> y) const override {
    State whole = state(y);
    if (runtime::settle_start(system_, whole) != Evaluation::ok) return false;
    std::copy(whole.begin(), whole.end(), y.begin());
    return true;
  }
  [[nodiscard]] bool damping(double t, std::span<const double> y, std::span<double> rates) const override {
    if constexpr (requires(std::array<double, S::nv>& all) { system_.damping(t, state(y), all); }) {
      std::array<double, S::nv> all{};
      system_.damping(t, state(y), all);
      for (std::size_t i = 0; i < S::nv; ++i) rates[i] = all[i];
      return true;
    }
    return false;
  }

 private:
  using State = std::array<double, S::nq + S::nv>;
  static constexpr ContactSizes sizes_of_type() noexcept {
    ContactSizes sizes{static_cast<int>(S::nq), static_cast<int>(S::nv), static_cast<int>(S::contacts), 0};
    if constexpr (requires { S::constraints; }) sizes.constraints = static_cast<int>(S::constraints);
    return sizes;
  }
  [[nodiscard]] static State state(std::span<const double> y) noexcept {
    State whole;
    for (std::size_t i = 0; i < whole.size(); ++i) whole[i] = y[i];
    return whole;
  }

  const S& system_;
};

}  // namespace torsor::runtime
