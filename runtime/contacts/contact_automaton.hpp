// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "torsor/runtime/contacts/bounce_limit.hpp"
#include "torsor/runtime/contacts/contact_motion.hpp"
#include "torsor/runtime/contacts/contact_result.hpp"
#include "torsor/runtime/contacts/contact_selection.hpp"
#include "torsor/runtime/events/event_memory.hpp"

namespace torsor::runtime {

/// Regimes of all contacts of a motion, and what changes them: the guards that end a smooth piece, the impacts there and
/// the decision which regimes follow. It moves nothing by itself: `ContactRun` integrates between its events.
class ContactAutomaton {
 public:
  /// Three guards watch each contact, in its order: gap or pressure, slip or margin, and what a slip that begins or
  /// ends asks for. One more, after those of all contacts, watches whether slips jam.
  static constexpr std::size_t guards = 3;

  ContactAutomaton(const ContactMechanism& mechanism, const ContactOptions& options);

  /// Whose the gaps below zero are: those of a start are refused. Those of a motion that was taken too far by another
  /// have their event now where they fall, and have had it where they open.
  enum class Gaps { of_a_start, of_a_late_event };
  /// Puts the state on its constraints and decides the first regimes; false where the motion cannot begin.
  bool start(double t0, std::span<double> y, Gaps gaps = Gaps::of_a_start);

  /// The mechanism may have other coefficients than before, at the same time and state: takes them, and decides the regimes
  /// anew where a law is another one. False where the motion ends.
  bool renew(std::span<double> y);

  /// Falls through zero where the present regimes end.
  [[nodiscard]] double guard(std::size_t index, double t, std::span<const double> y);
  /// Whether what it watches must not be below zero: a gap.
  [[nodiscard]] bool barrier(std::size_t index) const;

  /// Whether what a step lost sight of ends there: a gap that falls and is zero to rounding, after a flight too short to
  /// be followed; or a slip near its end, smaller than what the method's errors leave of it; or the youth of one that has a speed.
  [[nodiscard]] bool ends_unfollowed(std::size_t index, double t, std::span<const double> y);
  /// Whether a gap that fell through zero by what a step shows does not fall, by its velocity and its acceleration, beyond
  /// rounding: just after a lift-off the interpolant of a long step errs by more than the gap has risen.
  [[nodiscard]] bool does_not_fall(std::size_t index, double t, std::span<const double> y);
  /// Whether a force that a step lost sight of came to its bound by rounding alone: it is watched from above from there on.
  bool holds_on(std::size_t index, double t, std::span<const double> y);
  /// Whether steps that fell below the resolution of time did so because slips jam: then the motion ends with `jams`.
  [[nodiscard]] bool jams_nearly(double t, std::span<const double> y);
  /// Whether they did so because a joint's reaction ends: the regimes that follow, or the end of the motion where none do.
  /// Nothing where no reaction does.
  [[nodiscard]] std::optional<bool> pass_end_of_reaction(double t, std::span<double> y);
  /// Whether the steps have ended where forces jump and what holds a contact gives way: `pass` of its guard follows. Nothing where
  /// none does.
  [[nodiscard]] std::optional<bool> pass_jump_of_forces(double t, std::span<double> y);
  /// Whether the steps have ended where contacts that stick can no longer do so, as rows that depend on each other but for rounding
  /// ask for different accelerations: one of them begins to slide. Nothing where none does.
  [[nodiscard]] std::optional<bool> pass_loss_of_rank(double t, std::span<double> y);
  /// Whether the steps have ended at an edge that the contact leaves, its gap rising by a jump: it opens, and so does what leaves
  /// it with it. Or where its surface jumps along itself: then what stuck slides. The time of the result is then that behind the
  /// jump. False where the motion ends.
  bool pass_edge(int contact, double t, std::span<double> y);
  /// A smooth piece has ended at a guard, at this time: the regimes that follow. False where the motion ends.
  bool pass(std::size_t index, double t, std::span<double> y);
  /// Whether that was an event that the observer is told of.
  [[nodiscard]] bool has_event() const noexcept { return has_event_; }
  [[nodiscard]] ContactEvent event() const noexcept;
  /// Goes on to the next event of that time, if there is one: slips of other contacts that have ended too.
  void next_event() noexcept;

  bool end(ContactStatus status, std::optional<int> contact) noexcept;
  [[nodiscard]] ContactResult& result() noexcept { return result_; }
  [[nodiscard]] const ContactResult& result() const noexcept { return result_; }
  [[nodiscard]] ContactMotion& motion() noexcept { return motion_; }
  [[nodiscard]] const ContactMotion& motion() const noexcept { return motion_; }
  [[nodiscard]] const ContactOptions& options() const noexcept { return options_; }

 private:
  enum class Watched { gap_or_pressure, slip_or_margin, youth };
  enum class Cause { none, opens, slips };
  /// What is known of the impacts of one contact.
  struct Bounces {
    AccumulationWatch<double> watch{};
    BounceLimit limit{};
    int slower = 0;         ///< impacts in succession that were slower than the one before
    double speed = 0;       ///< of approach at its last impact [m/s]
    std::int64_t last = 0;  ///< number of its last impact among all; 0: none yet
    std::int64_t struck = 0;  ///< of the last one in which it closed, whichever contact caused it
    double left = std::numeric_limits<double>::lowest();  ///< time at which its flight began: it opened, or struck
    /// Until then an impact is the end of its bounces: others with which it struck in turn have come to theirs.
    double ends_by = std::numeric_limits<double>::lowest();
    double doubt = 1;  ///< doubled by each flight that did not leave the rounding of the gap, up to `most_doubt`

    /// An accumulation has ended: the next bounces tell of another.
    void begin_anew() noexcept {
      watch = {};
      limit = {};
      slower = 0;
      speed = 0;
    }
  };

  /// Beyond it a contact would be held against forces larger than those that act. One that opens and strikes without a flight
  /// even so ends the motion by `too_many_events`.
  static constexpr double most_doubt = 1e12;

  static constexpr std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }
  [[nodiscard]] int count() const noexcept { return motion_.count(); }
  [[nodiscard]] bool valid_rules() noexcept;
  [[nodiscard]] double gap_above(int contact) const noexcept;
  [[nodiscard]] bool leaves_rounding(int contact, double speed) const noexcept;
  [[nodiscard]] double idle_slack(int contact, int row);
  bool begin(double t, Gaps gaps);
  [[nodiscard]] bool near(int i) const noexcept;
  [[nodiscard]] double reach(int i) const noexcept;
  void set_by_slip(int i, double at_rest) noexcept;
  bool settle(std::optional<int> contact);
  bool raise_open();
  bool have_points() noexcept;
  bool decide(std::optional<int> forced, Cause cause);
  [[nodiscard]] ContactLaw law_after(int i, std::optional<int> forced, Cause cause) const noexcept;
  void note_found(const ContactSelection& chosen, const ContactAnswer& answer) noexcept;
  void note_struck(const ContactSelection& chosen, const ImpactResult& shock) noexcept;
  bool take_regime(const ContactSelection& chosen, int k, const ContactSolution& solution);
  [[nodiscard]] double end_of_bounces(int i, double speed, double a) const noexcept;
  [[nodiscard]] bool accumulating(int i) const noexcept;
  bool close_what_rests(const PerContact<bool>& among, const PerContact<double>& approach, const PerContact<double>& slip);
  void without_impact() noexcept;
  bool collide(int cause, bool rests, ImpactLaw impact_law);
  bool end_slips(int contact);
  bool pass_singular();
  bool pass_jump_of_slip(int contact, double t);
  bool impact_of_slip(int contact);
  void note_regularity();
  bool strike(int contact);
  bool begin_to_slide(int contact);
  bool pass_event(std::size_t index, double t, std::span<double> y);
  [[nodiscard]] bool is_singular(double t, std::span<const double> y);
  void stand_undecided_at(double t, std::span<double> y);
  bool tell_changes(const PerContact<ContactState>& before);
  [[nodiscard]] bool still_slips(int contact, Watched watched);
  bool happened(int contact, bool normal);
  bool pass_on(bool normal);

  ContactMotion motion_;
  const ContactOptions options_;
  ContactResult result_;
  std::span<double> y_;  ///< of the call that is under way
  std::vector<double> before_;
  std::vector<Bounces> bounces_;
  PerContact<bool> touching_{};
  PerContact<bool> joins_{};  ///< contacts that end their bounces with another one
  PerContact<bool> ends_too_{};  ///< contacts that ended their slip, or left an edge, with `contact_`: to be told of
  AccumulationWatch<double> all_{};
  double side_ = 1;  ///< of zero, on which the regularity of the present regimes began
  double began_regular_ = 1;  ///< its size there
  ContactVector fastest_;  ///< of each row, the largest terms of a normal acceleration that acts on it, at recent decisions
  std::int64_t impact_number_ = 0;
  bool alone_ = false;  ///< the accumulation is that of one contact, `cause_`
  bool buried_ = false;  ///< the next flight would not leave rounding
  int cause_ = 0;
  bool has_event_ = false;
  ContactEventKind kind_ = ContactEventKind::impact;
  double told_ = 0;
  int contact_ = 0;
  ContactVector impulses_;
  double energy_lost_ = 0, residual_ = 0;
  ContactVerdict verdict_ = ContactVerdict::unique;  ///< of the last decision of regimes
  ContactVerdict impact_verdict_ = ContactVerdict::unique;  ///< of the event's impact
  bool order_matters_ = false;  ///< of the impact told next
  std::array<PerContact<ContactRegime>, ContactAnswer::kept> found_{};  ///< regimes of all motions of the last decision
  std::size_t found_count_ = 0;
  std::array<PerContact<ContactRegime>, ContactAnswer::kept> struck_{};  ///< regimes of all impulses of the event's impact
  std::size_t struck_count_ = 0;
};

}  // namespace torsor::runtime
