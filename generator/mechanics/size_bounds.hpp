// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "torsor/generator/base/high_precision.hpp"
#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

/// What a size of a scene, a formula of parameters, must be.
struct SizeBound {
  enum class Relation { at_least, at_most, below };

  Expression value;
  Relation relation = Relation::at_least;
  Expression bound;
  static constexpr char number = '\1';  ///< stands for one in a text, as nothing in a name does
  std::string said;  ///< where it is not so, with places for the value and the bound, or for what is shown
  std::vector<Expression> shown{};

  /// Whether numbers break it; one that is not a number breaks nothing.
  bool broken(const Real& value, const Real& bound) const;
  /// All that has to be known: the value, the bound, and what is shown.
  std::vector<Expression> formulas() const;
  /// Where among them the numbers of the text begin.
  std::size_t first_shown() const { return shown.empty() ? 0 : 2; }
};

/// Whether it is a formula of parameters and numbers alone: a stop may move in time.
bool of_parameters(const Expression& formula);

/// That of a body's mass, or of a reflected inertia.
SizeBound bound_of_mass(const SceneContent& scene, const BodyContent& body);
/// Of a body's moments of inertia about its centre of mass what `check_inertia` asks of them, as formulas: leading minors of
/// their operator, or of that of the second moments, are not negative. Errors of 10⁻⁵ of their sum are allowed.
std::vector<SizeBound> bounds_of_moments(const SceneContent& scene, const BodyContent& body);
/// Of the lengths from which inertias and surfaces that touch were made.
std::vector<SizeBound> bounds_of_stated_sizes(const SceneContent& scene);
/// Of coefficients and lengths of friction.
std::vector<SizeBound> bounds_of_frictions(const SceneContent& scene);
/// Of surfaces that touch: coefficients, radii, places of stops.
std::vector<SizeBound> bounds_of_surfaces(const SceneContent& scene);

/// Of parameters without a value: nothing is said of what needs them, or a value is made up, at which what holds for all does.
enum class WithoutValue { left_out, made_up };

/// Throws SceneError for the first bound that is broken at the values that parameters have.
void require_bounds(const SceneContent& scene, const std::vector<SizeBound>& bounds, WithoutValue how = WithoutValue::left_out);

/// All of a scene on which one of these parameters bears: who sets them later has to look.
std::vector<SizeBound> bounds_that_depend_on(const SceneContent& scene, const std::vector<SymbolPointer>& parameters);

}  // namespace torsor
