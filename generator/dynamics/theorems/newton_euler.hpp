// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/dynamics/motion/body_screws.hpp"

namespace torsor {

/// Newton-Euler's theorems for isolated bodies (course, §6.3): dynamic = weight + applied + inertia + constraints +
/// transmitted, all reduced at the query's point along its axes. Accelerations, multipliers and inputs are symbols.
struct NewtonEuler {
  DynamicScrew dynamic;  ///< of the bodies relative to the query's observer R
  Wrench weight;
  Wrench applied;      ///< known actions from outside; those between the bodies cancel
  Wrench inertia;      ///< transport and Coriolis wrenches when R moves; else null
  Wrench constraints;  ///< Σ λ_j × wrench of a unit multiplier, friction included
  /// What the joints across the boundary transmit to the bodies: dynamic less all the others. In it is what works on a
  /// formula of coordinates (motors, springs and dampers on an elongation, formulas as constraints): these act in
  /// joints.
  Wrench transmitted;
};

/// The bodies asked for must be all that is welded together: a weld in one rigid body is no joint of the model. Links
/// without mass go with them as `isolated_links` says. Throws SceneError naming the missing bodies.
NewtonEuler newton_euler(const Equations& equations, const BodyNames& bodies, const ScrewQuery& query);

/// Which of the two theorems.
enum class Theorem { resultant, moment };

/// One theorem along one direction.
struct NewtonEulerEquation {
  Value dynamic;      ///< m Γ_G · u or δ_A · u
  Value known;        ///< weight, applied actions and inertia wrenches
  Value constraints;  ///< with the multipliers
  Value transmitted;  ///< by the joints: dynamic − known − constraints
};

/// One of the theorems along a direction, taken as it is given (not normalised), with components along the axes of
/// `screw`.
struct TheoremQuery {
  ScrewQuery screw;
  Theorem theorem = Theorem::resultant;
  Triple direction;
};
NewtonEulerEquation newton_euler_along(const Equations& equations, const BodyNames& bodies, const TheoremQuery& query);

/// For each link the wrench that its parent exerts on it through the joint (and through what works on a formula), in
/// the link's axes at its origin: Newton-Euler for the isolated sub-tree, from the tips to the ground. Entry 0 is null.
std::vector<Wrench> transmitted_wrenches(const Equations& equations);

/// The same for the joint that carries a frame, reduced and written as asked. Throws SceneError for the ground.
Wrench transmitted_wrench(const Equations& equations, const FrameReference& frame, const ScrewQuery& query);
/// In the axes of the joint's link, at its origin.
Wrench transmitted_wrench(const Equations& equations, const FrameReference& frame);

/// By link: whether it belongs to the isolated bodies. A link without mass on which nothing acts goes with what it carries; one
/// on which something acts belongs to them where it lies between them.
std::vector<bool> isolated_links(const Equations& equations, const BodyNames& bodies, const std::string& user);

}  // namespace torsor
