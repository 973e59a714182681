// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/program/sized.hpp"

namespace torsor {

/// Numbers of a scene's formulas at its initial configuration, t = 0: parameters at their values, driven coordinates at
/// their laws, released ones at zero. A parameter without a value gets a pseudo-random one in [1/2, 3/2], the same on
/// every run. At the working precision of the thread, which must not change in between.
class InitialNumbers {
 public:
  explicit InitialNumbers(const Scene& scene);

  Real operator()(const Expression& formula);
  /// Value of a symbol for an Evaluator of any program of the scene.
  Real operator()(const SymbolPointer& symbol);
  /// The same beside the terms of its formula.
  Sized sized(const SymbolPointer& symbol);

 private:
  std::optional<Expression> resolve(const SymbolPointer& symbol) const;

  const SceneContent& scene_;
  Program program_;
  Evaluator<Real> evaluate_;
  Evaluator<Sized> evaluate_sized_;
};

}  // namespace torsor
