// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/motion/body_screws.hpp"
#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/lagrange_equations.hpp"
#include "torsor/generator/printing/page.hpp"

namespace torsor::printing {

/// The steps that lead to Lagrange's equations, in the order of the course (Pommier, §4.2, §4.3, §6.3, §6.4), each a
/// step of the page. What is too long to be read is left out, and a sentence says so.
class Derivation {
 public:
  Derivation(const Scene& scene, const InlineLimits& limits, Page& page);

  /// Ω, V(G) and σ_G of each body at its centre of mass, along the axes in which they are shortest.
  void screws();
  /// T = ½ (momentum screw · twist), body by body.
  void kinetic_energies();
  /// ∂T/∂q̇_i, its time derivative and ∂T/∂q_i.
  void partial_derivatives(const std::vector<LagrangeEquation>& equations);
  /// Q_i of each action apart, with its force function where it has one.
  void forces();
  /// What each joint transmits, by Newton-Euler.
  void reactions();

 private:
  struct BodyAtCentre {
    std::string name;
    int link = 0;
    ScrewQuery query;  ///< at the centre of mass, along the shortest axes
    std::string axes;  ///< their name
  };

  bool too_many(std::size_t count, std::size_t most, const std::string& what);
  void choose_axes(BodyAtCentre& body, const FrameReference& frame);
  std::size_t length(const Vector& vector);
  void vector(const Spelling& name, const std::string& entry, const Vector& vector);
  void formula(const Spelling& left, const Value& value, const std::string& remark = {});

  Scene scene_;  ///< with points at the centres of mass
  std::vector<PointHandle> centres_;
  Equations equations_;
  InlineView view_;
  Page& page_;
};

}  // namespace torsor::printing
