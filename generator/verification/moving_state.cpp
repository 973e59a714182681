// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/moving_state.hpp"

namespace torsor {
namespace {

using RealQuaternion = std::array<Real, 4>;

/// Product of quaternions (w, x, y, z), the right one without a real part.
RealQuaternion product(const RealQuaternion& e, const std::array<Real, 3>& v) {
  return {-(e[1] * v[0] + e[2] * v[1] + e[3] * v[2]), e[0] * v[0] + e[2] * v[2] - e[3] * v[1],
          e[0] * v[1] + e[3] * v[0] - e[1] * v[2], e[0] * v[2] + e[1] * v[1] - e[2] * v[0]};
}

}  // namespace

MovingState::MovingState(const Scene& scene, const RandomState& state) : start_(state.in_real()) {
  const SceneContent& content = scene.content();
  const Real half = Real(1) / Real(2);
  motions_[content.time.get()] = {start_(content.time), Real(1), Real(0)};
  for (const CoordinateContent& c : content.coordinates) {
    motions_[c.v.get()] = {start_(c.v), start_(c.a), Real(0)};
    if (!c.attitude) motions_[c.q.get()] = {start_(c.q), start_(c.v), start_(c.a)};
  }
  for (const AttitudeContent& attitude : content.attitudes) {
    RealQuaternion e;
    std::array<Real, 3> omega, slope;
    for (std::size_t k = 0; k < 4; ++k) e[k] = start_(attitude.symbols->e[k]);
    for (std::size_t k = 0; k < 3; ++k) {
      omega[k] = start_(attitude.symbols->omega[k]);
      slope[k] = start_(attitude.symbols->omega[k]->rate);
    }
    RealQuaternion first = product(e, omega);
    for (Real& component : first) component *= half;
    const RealQuaternion turning = product(first, omega), speeding = product(e, slope);
    for (std::size_t k = 0; k < 4; ++k) {
      motions_[attitude.symbols->e[k].get()] = {e[k], first[k], half * (turning[k] + speeding[k])};
    }
  }
}

Evaluator<Real>::SymbolValue MovingState::at(const Real& h) const {
  return [this, h](const SymbolPointer& symbol) {
    const auto place = motions_.find(symbol.get());
    if (place == motions_.end()) return start_(symbol);
    const auto& [value, first, second] = place->second;
    return value + h * (first + h * second / Real(2));
  };
}

}  // namespace torsor
