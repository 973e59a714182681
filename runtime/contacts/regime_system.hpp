// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/LU>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "torsor/runtime/contacts/contact_scale.hpp"

namespace torsor::runtime {

/// What is assumed of one contact: whether its normal force acts, and what its friction does.
struct AssumedRegime {
  enum class Friction : unsigned char { none, sticks, slides };
  bool pressed = false;
  Friction friction = Friction::none;
  std::array<double, 2> direction{1, 0};  ///< of slip, where it slides
  bool direction_given = false;           ///< by the law: the contact slips already
  bool direction_sought = false;          ///< in space: u_T along it is a condition of its own
  std::array<double, 2> along{0, 0};      ///< of a bearing: where the direction of R is looked for from; 0, 0: from c
  bool reversed = false;                  ///< from there to the other side

  [[nodiscard]] ContactRegime regime() const noexcept {
    if (friction == Friction::sticks) return ContactRegime::sticks;
    return pressed || friction == Friction::slides ? ContactRegime::slides : ContactRegime::open;
  }
};

/// The equations of assumed regimes. Reactions are r = B x + c in the unknowns x (N of pressed contacts, T of sticking
/// ones), and E x = e says that u_N = 0 where a contact is pressed and u_T = 0 where it sticks.
///
/// A contact with a bearing that slides has the unknown |T| too, and |T| = f |R| + b. With ρ = R/|R| that is linear,
/// |T| - f ρ · S r = f ρ · c + b, and putting the ρ of the solution in is Newton's method, for d|R| = ρ · dR.
class RegimeSystem {
 public:
  using Regimes = PerContact<AssumedRegime>;
  using Friction = AssumedRegime::Friction;

  /// The scale is that of the problem.
  RegimeSystem(const ContactProblem& problem, const ContactScale& scale, const Regimes& regimes) noexcept;

  [[nodiscard]] int unknowns() const noexcept;

  /// Solves E x = e; false where there is no solution, or none that Newton's method finds. `kernel()` then holds what may
  /// be added to x.
  [[nodiscard]] bool solve() noexcept;

  [[nodiscard]] const ContactMatrix& kernel() const noexcept { return kernel_; }
  /// Adds of the kernel what brings the reactions nearest to given ones, where they are not unique.
  void approach(const ContactVector& reactions) noexcept;
  [[nodiscard]] ContactVector& x() noexcept { return x_; }
  [[nodiscard]] ContactVector reactions() const noexcept { return B_ * x_ + c_; }
  [[nodiscard]] ContactVector motion() const noexcept { return problem_.W * reactions() + problem_.q; }
  [[nodiscard]] const ContactMatrix& B() const noexcept { return B_; }

  /// But for a factor that depends on W and on which forces are unknown alone.
  [[nodiscard]] double determinant() const noexcept { return E_.cols() == 0 ? 1.0 : lu_.determinant(); }
  /// The determinant over that of the same rows of W: 1 without friction, below 0 where friction is beyond a jam (Painlevé).
  [[nodiscard]] double scaled_determinant() const noexcept;

  /// du/dα where the direction of contact i turns by α: B and c turn with it, and x follows.
  [[nodiscard]] ContactVector motion_by_turning(int i) const noexcept;

  [[nodiscard]] const AssumedRegime& at(int contact) const noexcept { return regimes_[as(contact)]; }
  /// ρ of a bearing, where R was not zero.
  [[nodiscard]] const std::array<double, 2>& along(int contact) const noexcept { return along_[as(contact)]; }

 private:
  static std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

  [[nodiscard]] bool slides_in_bearing(int contact) const noexcept {
    return at(contact).friction == Friction::slides && problem_.law(contact).bearing > 0;
  }
  void start_along() noexcept;
  std::pair<std::array<double, 2>, std::array<double, 2>> line_of_reaction(int contact) noexcept;
  /// What makes a velocity of |T|: all equations are measured alike.
  [[nodiscard]] double mobility(int contact) const noexcept {
    const int t = problem_.tangent_row(contact);
    return problem_.W(t, t) > 0 ? problem_.W(t, t) : 1;
  }
  /// f ρ · S of a bearing.
  [[nodiscard]] ContactVector pull_of_bearing(int contact) const noexcept;
  void equate_bearings() noexcept;
  /// Takes the ρ of the solution; by how much that differs from the last one.
  [[nodiscard]] double turn_bearings() noexcept;
  /// The row that measures an unknown: its own, or that of the friction of a bearing.
  [[nodiscard]] int row_of(int unknown) const noexcept;
  /// One over the unit of each unknown: E between these is without units.
  [[nodiscard]] ContactVector over_units() const noexcept;
  [[nodiscard]] bool solve_linear() noexcept;

  const ContactProblem& problem_;
  const ContactScale& scale_;
  const Regimes& regimes_;
  PerContact<std::array<double, 2>> along_{};
  PerContact<int> column_{};  ///< of |T| of a bearing that slides
  bool bearings_ = false;     ///< whether one slides
  ContactMatrix B_, E_, kernel_;
  ContactVector c_, e_, x_;
  std::array<std::optional<int>, static_cast<std::size_t>(most_rows)> rows_{};
  Eigen::FullPivLU<ContactMatrix> lu_;
};

}  // namespace torsor::runtime
