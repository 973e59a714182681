// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "generator/dynamics/forces/contacts.hpp"
#include "generator/verification/evaluated_motion.hpp"
#include "runtime/contacts/contact_problem.hpp"
#include "runtime/contacts/contact_system.hpp"

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
  std::string gap_unit(int contact) const { return at(contact).gap.unit().to_string(); }
  /// That of N: a force over the unit of the gap's metre.
  std::string force_unit(int contact) const;
  /// "sticks"; of a contact without friction "closed".
  std::string regime(int contact, runtime::ContactRegime regime) const;

  template <class System>
  bool fits() const {
    return motion_.position_count() <= System::nq && motion_.velocity_count() <= System::nv &&
           rows_.size() <= System::contacts && kept_.size() <= static_cast<std::size_t>(System::constraints);
  }

  /// Positions and velocities of a state with room for more, whose velocities begin at `room`, and back.
  template <class State>
  std::vector<double> of(const State& y, std::size_t room) const {
    std::vector<double> state(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(motion_.position_count()));
    const auto v = y.begin() + static_cast<std::ptrdiff_t>(room);
    state.insert(state.end(), v, v + static_cast<std::ptrdiff_t>(motion_.velocity_count()));
    return state;
  }
  template <class State>
  void copy(const std::vector<double>& state, State& y, std::size_t room) const {
    for (std::size_t i = 0; i < state.size(); ++i) {
      y[i < motion_.position_count() ? i : room + i - motion_.position_count()] = state[i];
    }
  }

  /// Accelerations without contacts and all that belongs to a state; false where they are not determined.
  bool read(double t, const std::vector<double>& y, std::vector<double>& rates) { return motion_.slope(t, y, rates); }
  double mass(std::size_t i, std::size_t j) { return motion_.value(motion_.equations().mass()[i][j]); }
  const std::vector<ContactRows>& rows() const { return rows_; }
  const ConstraintRow& constraint(std::size_t k) const { return motion_.equations().constraints()[kept_[k]]; }

 private:
  const ContactRows& at(int contact) const { return rows_[static_cast<std::size_t>(contact)]; }

  EvaluatedMotion motion_;
  std::vector<ContactRows> rows_;
  std::vector<runtime::ContactRule> rules_;
  std::vector<std::size_t> kept_;  ///< constraints that repeat no other
};

/// A mechanism of any size up to these: what is more has the mass 1 and stays where it is, or is open for ever.
template <std::size_t positions, std::size_t velocities, std::size_t contact_count, int constraint_count>
class RoomForContacts {
 public:
  static constexpr std::size_t nq = positions, nv = velocities, contacts = contact_count;
  static constexpr int constraints = constraint_count;
  using Reading = runtime::ContactReading<static_cast<int>(nv), static_cast<int>(contacts), constraints>;
  using State = std::array<double, nq + nv>;

  explicit RoomForContacts(EvaluatedContacts& evaluated) : contacts_(evaluated) {}

  runtime::ContactRule rule(int i) const {
    return i < contacts_.count() ? contacts_.rule(i) : runtime::ContactRule{.tangents = 0};
  }

  runtime::Evaluation read(double t, const State& y, Reading& reading) const {
    EvaluatedMotion& motion = contacts_.motion();
    const std::size_t n = motion.velocity_count();
    const std::vector<double> state = contacts_.of(y, nq);
    std::vector<double> rates(state.size());
    if (!contacts_.read(t, state, rates)) return runtime::Evaluation::singular;
    reading.M.setIdentity();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) reading.M(at(i), at(j)) = contacts_.mass(i, j);
    }
    // Accelerations hold the constraints already.
    typename runtime::ContactDynamics<Reading>::Velocity a;
    a.setZero();
    for (std::size_t i = 0; i < n; ++i) a(at(i)) = rates[motion.position_count() + i];
    reading.F = reading.M * a;
    const auto m = static_cast<std::size_t>(contacts_.constraint_count());
    reading.A.setZero(at(m), at(nv));
    for (auto* each : {&reading.gamma, &reading.value, &reading.rate}) each->resize(at(m));
    for (std::size_t k = 0; k < m; ++k) {
      const ConstraintRow& row = contacts_.constraint(k);
      for (std::size_t j = 0; j < n; ++j) reading.A(at(k), at(j)) = motion.value(row.jacobian[j]);
      reading.value(at(k)) = row.holonomic ? motion.value(row.value) : 0.0;
      reading.rate(at(k)) = motion.value(row.rate);
    }
    reading.gamma = -reading.A * a;
    reading.gap.fill(1);
    reading.J.setZero();
    reading.w.setZero();
    reading.drift.setZero();
    Eigen::Index next = 0;
    for (std::size_t i = 0; i < contacts_.rows().size(); ++i) {
      const ContactRows& contact = contacts_.rows()[i];
      reading.gap[i] = contact.normal ? motion.value(contact.gap) : 0.0;
      for (const ContactRow& row : contact.rows) {
        for (std::size_t j = 0; j < n; ++j) reading.J(next, at(j)) = motion.value(row.jacobian[j]);
        reading.w(next) = motion.value(row.rate);
        reading.drift(next++) = motion.value(row.drift);
      }
    }
    return runtime::Evaluation::ok;
  }

  void coordinate_rates(double t, const State& y, std::array<double, nq>& rates) const {
    EvaluatedMotion& motion = contacts_.motion();
    motion.move_to(t, contacts_.of(y, nq));
    rates.fill(0);
    for (std::size_t i = 0; i < motion.position_count(); ++i) rates[i] = motion.position_rate(i);
  }

  void normalise(State& y) const {
    std::vector<double> state = contacts_.of(y, nq);
    contacts_.motion().normalise(state);
    contacts_.copy(state, y, nq);
  }

 private:
  static Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }
  EvaluatedContacts& contacts_;
};

}  // namespace torsor
