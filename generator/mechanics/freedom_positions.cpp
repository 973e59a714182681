// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/freedom_positions.hpp"

#include "torsor/generator/base/as_index.hpp"

namespace torsor {

std::vector<SymbolPointer> positions_with(const SceneContent& scene, const CoordinateContent& freedom) {
  if (!freedom.attitude) return {freedom.q};
  const AttitudeSymbols& symbols = *scene.attitudes[as_index(*freedom.attitude)].symbols;
  if (freedom.v != symbols.omega[0]) return {};
  return {symbols.e.begin(), symbols.e.end()};
}

}  // namespace torsor
