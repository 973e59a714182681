// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/regime_inequalities.hpp"
#include "torsor/runtime/contacts/regime_system.hpp"

namespace torsor::runtime {

/// Tries every combination of regimes: open, sticking, sliding; in the plane to either side. In space the direction of
/// a slip that begins is found too: all directions where one contact or two begin to slide, by trigonometric polynomials;
/// where more do, those that Newton's method reaches from three or six directions of each. The directions of the reactions that
/// press joints are found from T = 0 and, of up to three joints, from a large T too: of one component both signs are tried.
class RegimeEnumeration {
 public:
  using Regimes = RegimeSystem::Regimes;
  using Friction = AssumedRegime::Friction;

  /// `relates`: regimes whose slips others hold, or give a direction, are not searched (SlipRelations).
  explicit RegimeEnumeration(const ContactProblem& problem, bool relates = true) noexcept
      : problem_(problem), scale_(problem), relates_(relates) {
    for (int i = 0; i < problem.count; ++i) bearings_ += problem.law(i).bearing > 0 ? 1 : 0;
  }

  /// `thoroughly`: where three or four slips begin together, from more directions of each.
  [[nodiscard]] ContactAnswer run(bool thoroughly = false) noexcept;

  /// One combination; directions that are sought start from those given. For solvers that know where to look: where reactions
  /// are not unique, beside those that are `near`, if there are any.
  bool try_from(Regimes regimes, const ContactVector& near = {}) noexcept;

  /// One that is known already.
  void take(const ContactSolution& solution) noexcept {
    moves_ = moves_ || solution.moves;
    add(solution);
  }

  /// Whether one motion is known, and some contact sticks in it.
  [[nodiscard]] bool only_rests() const noexcept {
    const auto& regimes = answer_.solutions[0].regimes;
    return answer_.count == 1 && std::find(regimes.begin(), regimes.end(), ContactRegime::sticks) != regimes.end();
  }

  [[nodiscard]] ContactAnswer finish() noexcept;

  /// How many combinations `run` tries.
  [[nodiscard]] double combinations() const noexcept;

 private:
  /// What the kernel of a system allows besides one solution.
  struct Family {
    bool found = false;          ///< the system holds one that fits
    bool indeterminate = false;  ///< with others around it
    bool moves = false;          ///< which give other motions
  };
  static constexpr double slack = 1e-12;  ///< of the sizes, for what has to hold

  /// Whether the laws make one convex problem, which has one motion: where no force bounds another.
  [[nodiscard]] bool is_convex() const noexcept;
  [[nodiscard]] bool ends(const ContactSolution& one, const ContactSolution& other) const noexcept;
  [[nodiscard]] bool is_close(const ContactSolution& one, const ContactSolution& other) const noexcept;
  static std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

  [[nodiscard]] static bool open_rubs(const ContactLaw& law) noexcept;
  [[nodiscard]] int frictions(const ContactLaw& law) const noexcept;
  [[nodiscard]] int choices(const ContactLaw& law) const noexcept;
  [[nodiscard]] AssumedRegime choose(const ContactLaw& law, int choice) const noexcept;
  [[nodiscard]] int count_sought(const Regimes& regimes) const noexcept;
  void try_all() noexcept;
  void try_regimes(Regimes& regimes) noexcept;
  [[nodiscard]] bool try_related(Regimes& regimes) noexcept;
  void try_all_directions(Regimes& regimes) noexcept;
  [[nodiscard]] bool try_all_pairs(Regimes& regimes) noexcept;
  [[nodiscard]] bool turn_to_slip(Regimes& regimes) noexcept;
  void accept(Regimes regimes, const ContactVector* near = nullptr) noexcept;
  [[nodiscard]] Family look_inside(RegimeSystem& system, const RegimeInequalities& inequalities) const noexcept;
  [[nodiscard]] Family look_beside(RegimeSystem& system, const RegimeInequalities& inequalities) const noexcept;
  [[nodiscard]] bool moves_by(const ContactVector& forces) const noexcept;
  void turn_to_family(Regimes& regimes, ContactVector& r, ContactVector& u, Family& family) const noexcept;
  void tidy(const Regimes& regimes, ContactVector& r, ContactVector& u, ContactSolution& solution) const noexcept;
  void add(const ContactSolution& solution) noexcept;

  const ContactProblem& problem_;
  const ContactScale scale_;
  ContactAnswer answer_;
  int bearings_ = 0;
  bool relates_;
  bool thoroughly_ = false;
  bool left_out_ = false;  ///< regimes that others stand for
  bool tried_ = false;     ///< all combinations were
  bool complete_ = false;  ///< and whatever the directions, each motion is among them
  bool moves_ = false;     ///< reactions that fit give different motions without end
};

}  // namespace torsor::runtime
