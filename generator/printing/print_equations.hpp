// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

enum class Format {
  text,   ///< plain ASCII: theta'' for an acceleration, 1/2 M1 X'^2
  latex,  ///< align* environments
  html,   ///< folded sections of a report, without its title
};

/// How a page is written.
struct PageStyle {
  Format format = Format::text;
  bool document = false;  ///< LaTeX: a whole document instead of a fragment
  NaturalLanguage language{};
};

struct PrintOptions {
  bool document = false;      ///< LaTeX: a whole document instead of a fragment
  /// The steps that lead to the equations, in the order of a course: twists and momentum screws at the centres of mass, T
  /// body by body, its partial derivatives, generalised forces action by action, and what joints transmit.
  bool derivation = false;
  bool linearisation = true;  ///< print M, C, K, F, E
  /// State about which the equations are linearised: a coordinate, "theta", or its velocity, "theta'", and a formula of
  /// the scene's parameters, e.g. {"X", "X0"}, {"theta", "pi/2"}. Empty: a symbolic state. When it is not empty,
  /// velocities and accelerations that are not named are zero and coordinates that are not named stay symbols.
  std::vector<std::pair<std::string, std::string>> about{};
  int terms = 400;        ///< what has more terms is given by named definitions instead
  int expansion = 20000;  ///< what would have more terms before anything cancels is not even multiplied out
  NaturalLanguage language{};
};

/// The equations a person reads: symbols with units and values, T, U, one Lagrange equation per coordinate with inertia
/// P_i = d/dt ∂T/∂q̇_i − ∂T/∂q_i on the left and generalised forces Q_i + Σ λ_j a_ji on the right, constraints, and the
/// linearised equations M ε̈ + C ε̇ + K ε = F + E u. Every parameter keeps its symbol. T is differentiated by GiNaC, a
/// derivation that shares nothing with the derivatives the kernels are made of.
///
/// A quantity that is too long to read is given by the definitions of its program, and one line says so. The same scene
/// gives the same bytes in every run. Throws SceneError for a bad scene and UsageError for a bad `about`.
std::string print_equations(const Scene& scene, Format format, const PrintOptions& options = {});

/// "text" or "latex". Throws UsageError naming anything else.
Format parse_format(const std::string& name);

}  // namespace torsor
