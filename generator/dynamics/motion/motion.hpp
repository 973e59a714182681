// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/mechanics/screw.hpp"

namespace torsor {

/// Twists of all links by composition along the chains, one joint at a time; each result is bound.
std::vector<Twist> twists(const BodyTree& tree);

/// Momentum screw at O: {m V_O + Ω ∧ h, J Ω + h ∧ V_O}, h = m OG.
MomentumScrew momentum(const MassProperties& body, const Twist& twist);

/// Accelerations of one link: Ω̇ and Γ(O) − g, in the link's axes, and the array U = [Ω̇] + [Ω][Ω] that gives the
/// acceleration of any point P of the link: Γ(P) = Γ(O) + U OP. Entries of U are made when first wanted.
class Acceleration {
 public:
  Acceleration() = default;
  Acceleration(Program& program, std::string name, Vector omega, Vector angular, Vector linear);

  const Vector& omega() const { return omega_; }
  const Vector& angular() const { return angular_; }
  const Vector& linear() const { return linear_; }
  const Value& u(int row, int column);
  Vector u_times(const Vector& v);
  Value product(int i, int j);  ///< Ω_i Ω_j

 private:
  Program* program_ = nullptr;
  std::string name_;
  Vector omega_, angular_, linear_;
  std::array<std::optional<Value>, 9> u_;
};

/// Which accelerations q̈ the recursion is run with.
enum class AccelerationInput {
  symbols,  ///< q̈ as symbols
  zero,     ///< q̈ = 0: what remains is the bias
};

/// Axes in which a link's vectors are written: its own, or its joint's fixed axes, which do not turn with the angle.
enum class Axes { own, unturned };

/// Accelerations of all links at (q, q̇, q̈), gravity included as an upward acceleration of the ground; those of points
/// are over the tree's length unit, where it has one. `axes` of each
/// link (only a link without children may have unturned ones).
std::vector<Acceleration> accelerations(const BodyTree& tree, AccelerationInput input, const std::vector<Axes>& axes);

/// A motion of the joints that makes accelerations cheap, for those who find another one by its difference: of a turn
/// with an unknown about an aligned axis, q̈ cancels the link's angular acceleration along it; of any other joint with
/// an unknown it is zero. Zero for all at rest.
struct ReferenceMotion {
  std::vector<Acceleration> links;
  std::vector<Value> joints;  ///< q̈, by link
};
ReferenceMotion reference_motion(const BodyTree& tree, const std::vector<Axes>& axes);

}  // namespace torsor
