// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/regime_system.hpp"

namespace torsor::runtime {

/// For each row, the largest of q and of what bounded friction adds: of the motions that a problem starts from.
[[nodiscard]] ContactVector given_motions(const ContactProblem& problem, const ContactScale& scale) noexcept;

/// What assumed regimes ask besides their equations, each as a number >= 0: N of pressed contacts, u_N of those that
/// are not, d · u_T of those that begin to slide, and f_s N + b_s - |T| of those that stick. Forces count over the
/// largest force, motions over the largest motion of their group (ContactScale).
class RegimeInequalities {
 public:
  using Friction = AssumedRegime::Friction;

  RegimeInequalities(const ContactProblem& problem, const ContactScale& scale, const RegimeSystem& system) noexcept
      : problem_(problem), scale_(scale), system_(system) {}

  /// For each row, the largest force, and the largest sum of terms of a motion.
  struct Sizes {
    ContactVector force, motion;
  };
  [[nodiscard]] Sizes sizes(const ContactVector& r) const noexcept;

  /// What `find` found.
  struct Room {
    bool holds = false;  ///< all hold there
    bool inside = false;  ///< those that change with z hold by half of the margin at least: around x there are others
  };

  /// Whether all hold but for rounding: `slack` of the sizes.
  [[nodiscard]] bool hold(const ContactVector& r, const ContactVector& u, double slack) const noexcept;

  /// Looks for x + Z z where all hold, Z the kernel of the system: least sum of the squares of what is missing, convex
  /// in z but for joints, by Newton's method with halved steps. `margin` asks for more than 0, as a part of the sizes. The
  /// system then holds that x.
  [[nodiscard]] Room find(RegimeSystem& system, double margin) const noexcept;

 private:
  /// Directions ρ by which ρ · R stands for |R| of a joint that sticks; 0, 0: none.
  using Ways = PerContact<std::array<double, 2>>;
  [[nodiscard]] Room find_along(RegimeSystem& system, double margin, const Ways& ways) const noexcept;

  static std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }
  /// The largest of sizes of rows, of those of a contact's friction.
  [[nodiscard]] double of_friction(int contact, const ContactVector& sizes) const noexcept;

  const ContactProblem& problem_;
  const ContactScale& scale_;
  const RegimeSystem& system_;
};

}  // namespace torsor::runtime
