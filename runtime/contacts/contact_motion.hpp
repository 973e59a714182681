// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "torsor/runtime/constraints/change_point_bounds.hpp"
#include "torsor/runtime/contacts/contact_dynamics.hpp"
#include "torsor/runtime/contacts/contact_state.hpp"
#include "torsor/runtime/contacts/gap_rounding.hpp"
#include "torsor/runtime/contacts/regime_system.hpp"

namespace torsor::runtime {

/// y' = f(t, y) of a mechanism while the regimes of its contacts last: closed contacts keep w_N = 0, sticking ones w_T
/// = 0, and sliding ones have T = -(f N + b) d, d the direction of the slip w_T. Settling puts gaps and these
/// velocities back to zero, in the metric of the masses.
///
/// In space w_T passes through zero without a change of sign. So d is followed from step to step: s = d_last · w_T
/// changes sign where the slip ends, and beyond it d = sign(s) w_T/|w_T| goes on smoothly. Near s = 0, where w_T is
/// rounding, d is d_last. A slip that has just begun has its direction from the forces (slip_direction.hpp) until it
/// has a speed: equations with d = w_T/|w_T| are too stiff before.
class ContactMotion {
 public:
  /// The mechanism must live as long.
  explicit ContactMotion(const ContactMechanism& mechanism);

  PerContact<ContactState> states{};

  [[nodiscard]] Evaluation slope(double t, std::span<const double> y, std::span<double> dydt);

  /// Loops, gaps of closed contacts, their velocities and those of sticking ones back to zero, in at most `steps` steps
  /// of Newton's method.
  [[nodiscard]] Evaluation project(double t, std::span<double> y, int steps = 3);
  /// The same at the end of a step of the integration. Refused where a velocity that is held, or a gap, is none of its errors but
  /// jumps: `jumping`.
  [[nodiscard]] Evaluation hold(double t, std::span<double> y);
  /// Where the integration is going: one that cannot go on ends within roundings of the time and of the way that is left.
  void head_for(double end) noexcept { end_ = end; }
  /// Whether the normal velocity of a contact that touches, at the state read last, parts it, and is none of the errors of the
  /// integration.
  [[nodiscard]] bool parts_by_a_jump(int i) const noexcept {
    return normal_has_jumped(i) && reading_.w(first_row(i)) > 0;
  }
  /// The contact whose normal, gap or surface jumps within a million roundings of the time behind t, by the step refused last.
  [[nodiscard]] std::optional<int> jumping(double t) const noexcept {
    const bool near = std::abs(jumped_ - t) <= 1e6 * rounding_of_time(jumped_);
    return near ? jumping_ : std::nullopt;
  }
  /// Whether an open gap above zero is below zero a moment later, before its velocity, or its acceleration, changes it by a
  /// thousandth: what falls there is no body. The state is that read last.
  [[nodiscard]] bool gap_jumps(int i);
  /// Where the gap of a contact that touches rises by a jump right behind t, as over the edge of a table: takes the
  /// state there in the present regimes. Says how much later that is; nothing where no gap rises so.
  [[nodiscard]] std::optional<double> pass_edge(int i, double t, std::span<double> y);
  /// The same where the rate of the gap rises by a jump, as over the peak of a cam.
  [[nodiscard]] std::optional<double> pass_ridge(int i, double t, std::span<double> y);
  /// Steps have ended within a million roundings of the time before a jump: takes the state right behind it, in the present
  /// regimes, and says how much later that is; nothing where `is_beyond(later, state)` is so of none.
  template <class Beyond>
  [[nodiscard]] std::optional<double> pass_to(double t, std::span<double> y, const Beyond& is_beyond) {
    if (slope(t, y, way_) != Evaluation::ok) return std::nullopt;
    const auto is_at = [&](double later) {
      for (std::size_t k = 0; k < there_.size(); ++k) there_[k] = y[k] + later * way_[k];
      mechanism_.normalise(there_);
      return is_beyond(later, std::span<const double>(there_));
    };
    const double rounding = rounding_of_time(t);
    double low = 0, high = 2e6 * rounding;
    if (!is_at(high)) return std::nullopt;
    while (high - low > 4 * rounding) {
      const double middle = low + (high - low) / 2;
      (is_at(middle) ? high : low) = middle;
    }
    if (!is_at(high)) return std::nullopt;
    std::copy_n(there_.begin(), there_.size(), y.begin());
    return high;
  }
  /// Where the surface of a contact that sticks jumps along itself right behind t, as a belt that starts at once: takes the state
  /// there, whose velocities are those before. Says how much later that is; nothing where none does so.
  [[nodiscard]] std::optional<double> pass_jump_of_slip(int i, double t, std::span<double> y);
  /// Whether a contact that sticks has a slip, at the state read last, that is none of the errors of the integration.
  [[nodiscard]] bool slip_has_jumped(int i) const noexcept;
  /// The same of the normal velocity of a contact that touches.
  [[nodiscard]] bool normal_has_jumped(int i) const noexcept {
    return at(i).touches && rule(i).normal && has_jumped(first_row(i));
  }
  /// A contact that touches and whose rows are others, by an eighth, where coordinates change by some errors of the
  /// integration: it has no single point that could be followed, as where a disc has all but fallen flat.
  [[nodiscard]] std::optional<int> without_point(double t, std::span<const double> y);
  /// Whether the gap that was read last, of a contact that touched, is off by more than the rounding of a way of this
  /// duration.
  [[nodiscard]] bool off_by_a_jump(int i, double duration) const noexcept;
  /// The open contact whose gap has jumped below zero since the last step's end.
  [[nodiscard]] std::optional<int> falls_by_a_jump(double t, std::span<const double> y);
  /// A step has ended at (t, y): slips have the directions that they have there. Within a step they are compared with those of
  /// its start. Where the state cannot be read nothing follows.
  void follow_slips(double t, std::span<const double> y);
  /// The same of loops and gaps alone.
  [[nodiscard]] Evaluation project_positions(double t, std::span<double> y, int steps);

  /// Whether the state read last is on its loops, where they were once off by `first` [coordinates]: what closes them is
  /// rounding, or a millionth of that.
  [[nodiscard]] bool loops_closed(double first) const;
  /// The largest change of a coordinate that closes the loops at the state read last.
  [[nodiscard]] double loops_off() const;

  /// Whether the state read last is in the neighbourhood of a change point, where branches of a loop meet and constraints lose
  /// rank, and one since the last event near it: errors e off the constraints come out as e/d² in accelerations, d the
  /// distance.
  [[nodiscard]] bool near_change_point() const noexcept {
    return nearest_ < change_point_bounds::near && dynamics_.distance() < change_point_bounds::plain;
  }
  /// Reads the mechanism at a state; false where it cannot be, and so near a change point that rounding of positions takes
  /// half of the digits.
  [[nodiscard]] bool read(double t, std::span<const double> y);

  /// Accelerations and reactions of the present regimes.
  [[nodiscard]] Evaluation solve(double t, std::span<const double> y);

  /// W at the state read last; zero where it is not finite.
  [[nodiscard]] const Eigen::MatrixXd& W();

  /// Direction of the slip at the state read last.
  [[nodiscard]] std::array<double, 2> direction(int i) const noexcept;
  /// Whether that is the direction of its velocity, with which it turns, or one that nothing turns, as in the plane. Else forces
  /// give it, or the last one has a part in it.
  [[nodiscard]] bool turns_with_velocity(int i) const noexcept;
  /// Direction of the velocity of a slip, whatever is known of it; the last one where it has none.
  [[nodiscard]] std::array<double, 2> velocity_direction(int i) const noexcept;

  /// A slip that nears its end: where friction would turn it much faster than it ends, the equations are stiff, and its
  /// direction follows from the forces again.
  void fade(int i, double t, std::span<const double> y);
  /// Goes on with that direction, as a slip that has a speed.
  void take_direction(int i) noexcept;
  /// Whether a slip has a velocity across its last direction, beyond what is left of one that ends.
  [[nodiscard]] bool slips_across(int i);
  /// d_last · w_T, which falls through zero where the slip ends.
  [[nodiscard]] double slip(int i) const noexcept;
  /// |w_T|.
  [[nodiscard]] double slip_speed(int i) const noexcept;
  /// A slip below which a contact that begins to slide is as good as at rest: some hundred roundings.
  [[nodiscard]] double least_slip(int i) const noexcept;
  /// Whether what is left of a slip is no more than errors of the integration: it ends with that of another.
  [[nodiscard]] bool ends_too(int i) const noexcept;
  /// A slip below which one that had a speed nears its end.
  [[nodiscard]] double slow(int i) const noexcept;
  /// Falls through zero where a slip that began has got a speed from which equations with d = w_T/|w_T| go on: where
  /// second order in s would have turned it by more than a hundredth of the method's tolerance since. Falls through zero too
  /// where a slip that had a speed nears its end, or has got one again.
  [[nodiscard]] double youth(int i, double t) const noexcept;
  /// R of the joint of a contact that has a bearing.
  [[nodiscard]] std::array<double, 2> bearing(int i) const noexcept;
  /// N that presses a contact, or |R| of its joint.
  [[nodiscard]] double pressing(int i) const noexcept;
  /// f_s N + b_s - |T| of a sticking contact.
  [[nodiscard]] double margin(int i) const noexcept;
  /// |T|.
  [[nodiscard]] double friction_force(int i) const noexcept;
  /// The largest force of those that act on each other with a contact's: what its rounding is a part of.
  [[nodiscard]] double force_size(int i) const;

  /// What rounding may make of a velocity: some parts of its terms.
  [[nodiscard]] double rounding_of(int row) const noexcept;
  /// d²g/dt² of a gap in the present regimes, solved last.
  [[nodiscard]] double gap_acceleration(int i) const noexcept;
  /// The terms of a normal acceleration at the state read last, of which rounding is a part.
  [[nodiscard]] double acceleration_terms(int i) const noexcept;
  /// For each row, the largest of these of the normal rows that act on it, open contacts among them.
  [[nodiscard]] ContactVector acceleration_sizes() const;
  /// Measures the rounding of gaps anew at the state read last; whether it has grown: what seemed to be more was none.
  [[nodiscard]] bool gaps_are_rougher() { return gap_rounding_.measure_anew(t_, y_); }
  /// What rounding may make of a gap, of the coordinates that it depends on and of its own lengths.
  [[nodiscard]] double rounding_of_gap(int i) const noexcept;

  [[nodiscard]] std::span<const ContactRule> rules() const noexcept { return std::span(rules_).first(as(count())); }
  [[nodiscard]] const ContactSizes& sizes() const noexcept { return sizes_; }
  [[nodiscard]] int count() const noexcept { return sizes_.contacts; }
  [[nodiscard]] const ContactRule& rule(int i) const noexcept { return rules_[as(i)]; }
  /// The contact whose gap decides whether this one touches: itself, or the one that rolls; none: it always does.
  [[nodiscard]] std::optional<int> carrier(int i) const noexcept { return rule(i).normal ? i : rule(i).pressed_by; }
  [[nodiscard]] int rows() const noexcept { return first_row_[as(count())]; }
  [[nodiscard]] int first_row(int i) const noexcept { return first_row_[as(i)]; }
  [[nodiscard]] bool has_point(int i) const { return reading_.has_rows(first_row(i), rule(i).rows()); }
  [[nodiscard]] int tangent_row(int i) const noexcept { return first_row(i) + (rule(i).normal ? 1 : 0); }
  /// First component of the reaction of its joint.
  [[nodiscard]] int first_bearing(int i) const noexcept { return first_bearing_[as(i)]; }

  [[nodiscard]] const ContactReading& reading() const noexcept { return reading_; }
  [[nodiscard]] const ContactDynamics& dynamics() const noexcept { return dynamics_; }
  /// Adds the answer to impulses to the velocities of a state; the state read last is that before.
  void add_answer(const ContactVector& impulses, std::span<double> y);
  [[nodiscard]] const ContactVector& reactions() const noexcept { return r_; }
  /// From which direction of a joint's reaction the next one is sought.
  void press_along(int i, const std::array<double, 2>& reaction) noexcept { along_[as(i)] = reaction; }
  /// Where reactions are not unique, those nearest to these, of all rows, are taken from now on.
  void lean_on(const ContactVector& reactions) noexcept { held_ = reactions; }
  /// Whether others than the reactions of a contact solved last give the same motion.
  [[nodiscard]] bool undetermined(int i) const noexcept { return undetermined_[as(i)]; }
  /// Determinant of the equations of the regimes solved last, over that without friction. Where slips jam it passes zero:
  /// beyond, there is no solution or one of several (Painlevé). 1 where nothing slides or reactions are not unique.
  [[nodiscard]] double regularity() const noexcept { return regularity_; }
  /// The sliding contact on whose friction most power is spent, where one slides.
  [[nodiscard]] std::optional<int> busiest_slip() const noexcept;
  /// Errors of the integration: what they leave of a slip that ends, across its direction, has no direction.
  void tolerate(double absolute, double relative) noexcept {
    absolute_ = absolute;
    relative_ = relative;
  }
  /// Back to what a motion knows before it starts, with the rules that the mechanism has now: coefficients may be others,
  /// numbers of rows are as they were.
  void forget();
  /// Regimes were changed: what was solved is no longer valid.
  void changed() noexcept { solved_ = false; }
  /// An event begins: places that were passed before are forgotten.
  void leave_change_point() noexcept { nearest_ = dynamics_.distance(); }
  /// Quaternions of a start have norm 1 behind it; false where one is zero.
  [[nodiscard]] bool settle_start(double t, std::span<double> y) {
    if (!mechanism_.settle_start(y)) return false;
    gap_rounding_.measure(t, y);
    return true;
  }
  /// What the mechanism says at a state has changed: it is read again.
  void renew() noexcept { known_ = false; }
  /// Takes the rule that the mechanism has now for a contact; whether it is another one. Its rows are as many as before.
  bool take_rule(int i);

 private:
  using Regimes = RegimeSystem::Regimes;
  static constexpr std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }
  [[nodiscard]] double rounding_of_time(double t) const noexcept {
    return std::numeric_limits<double>::epsilon() * std::max({std::abs(t), std::abs(end_ - t), std::numeric_limits<double>::min()});
  }
  [[nodiscard]] const ContactState& at(int i) const noexcept { return states[as(i)]; }
  [[nodiscard]] bool any_touches() const noexcept;
  [[nodiscard]] bool read_on_the_way(double part, double t, std::span<const double> y);
  /// What is left of a velocity that is held, the sizes of its terms, J v and that of the surface, and what a step may leave.
  struct Off {
    double velocity, terms, error;
  };
  [[nodiscard]] double terms_of_acceleration(int row) const noexcept;
  [[nodiscard]] Off off(int row, std::span<const double> y) const noexcept;
  [[nodiscard]] bool has_jumped(int row) const noexcept;
  Evaluation jumps_at(int i, double t) noexcept;
  template <class Number>
  [[nodiscard]] bool jumps(double t, std::span<const double> y, const Number& number);
  [[nodiscard]] bool follows_forces(int i) const noexcept;
  /// A slip below which its velocity has no direction.
  [[nodiscard]] double directionless(int i) const noexcept;
  [[nodiscard]] bool respond();
  /// Slips whose directions are sought from forces, and the problem that these solve.
  struct Alignment {
    const ContactProblem& problem;
    PerContact<bool> begins{};
  };
  [[nodiscard]] Evaluation align(double t, std::span<const double> y, const Alignment& of, Regimes& regimes);
  [[nodiscard]] Evaluation align_or_keep(double t, std::span<const double> y, Alignment of, Regimes& regimes);
  [[nodiscard]] ContactProblem problem_of(const ContactReading& reading, const ContactDynamics& dynamics) const;
  [[nodiscard]] double blur(int i) const noexcept;
  [[nodiscard]] bool strays(int i) const noexcept;
  void note_undetermined(const RegimeSystem& equations, const ContactScale& scale) noexcept;
  template <class Wanted>
  void select(const Wanted& wanted);
  void add_least_change();

  const ContactMechanism& mechanism_;
  ContactSizes sizes_;
  PerContact<ContactRule> rules_{};
  std::array<int, static_cast<std::size_t>(most_contacts) + 1> first_row_{}, first_bearing_{};
  ContactReading reading_, later_reading_;
  ContactDynamics dynamics_, later_dynamics_;
  Eigen::VectorXd a_, change_;
  Eigen::VectorXd loops_;  ///< the terms of the rates of loops
  ContactVector r_, right_, held_, over_;  ///< `over_` of the rows chosen: one over the unit of each
  PerContact<double> across_{}, lag_{};  ///< s κ and the angle of lag of slips that begin
  PerContact<bool> stiff_{}, undetermined_{};
  PerContact<std::array<double, 2>> aligned_{};  ///< directions that forces give to slips that begin or fade
  PerContact<bool> unaligned_{};  ///< slips that fade to which forces give no direction
  PerContact<std::array<double, 2>> along_{};  ///< directions of the reactions of joints, from which the next are sought
  std::array<int, static_cast<std::size_t>(most_rows)> row_{};
  int chosen_ = 0;
  std::optional<int> jumping_;
  double jumped_ = 0;  ///< when
  double end_ = 0;
  double regularity_ = 1;
  double t_ = 0, absolute_ = 1e-13, relative_ = 1e-13;
  std::vector<double> y_, there_, rates_;
  GapRounding gap_rounding_;  ///< of lengths, as measured at the start, and anew where a gap seems to jump
  std::vector<double> way_;   ///< rates at an edge
  std::vector<double> from_;  ///< the state at `from_t_`, where slips were followed last
  double from_t_ = 0;
  bool followed_ = false;
  bool known_ = false, responded_ = false, solved_ = false;
  double nearest_ = 1;  ///< the least distance from a change point since the last event
};

}  // namespace torsor::runtime
