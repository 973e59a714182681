// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "torsor/generator/verification/evaluated_motion.hpp"

namespace torsor {

/// How far two states of one mechanism are apart, and the one nearest to a start that closes the constraints.
///
/// Displacements are measured in radians, lengths over the size of the mechanism: the longest arm that a constraint has
/// of a coordinate that turns. Turns of an attitude are vectors of rotation.
class NearestState {
 public:
  NearestState(EvaluatedMotion& motion, std::vector<double> start);

  double distance(const std::vector<double>& y);

  /// Positions that fulfil the holonomic constraints at t = 0, those at the places of `kept` as they are at the start:
  /// of what the search finds from the start and from a fixed set of places around it, the nearest. Nothing where it
  /// finds none.
  ///
  /// Gauss-Newton steps onto the constraints, δ = −J⁺ f, none longer than a quarter of a radian and each of them a
  /// descent of |f|; then steps along them towards the start, P (q₀ − q) with P = 1 − J⁺ J, each closed anew and each
  /// of them nearer.
  std::optional<std::vector<double>> find(const std::vector<std::size_t>& kept);

 private:
  using Numbers = std::vector<double>;

  void measure();
  Numbers to_start(const Numbers& y) const;  ///< by velocity, in the metric
  Numbers moved(const Numbers& y, const Numbers& displacement);
  Numbers residual(const Numbers& y);
  Numbers least(const Numbers& y, const Numbers& right);         ///< J⁺ right
  Numbers along(const Numbers& y, const Numbers& displacement);  ///< J displacement
  Numbers free_part(Numbers displacement) const;
  bool close(Numbers& y);
  void approach(Numbers& y);
  void unwind(Numbers& y);

  EvaluatedMotion& motion_;
  Numbers start_;
  struct Freedom {
    std::size_t position = 0;  ///< of its coordinate, or of the first component of its quaternion
    int component = -1;        ///< of the three of an attitude
    double unit = 1;           ///< a displacement of 1 in the metric
    bool turns = false;
  };
  std::vector<Freedom> freedoms_;
  struct Row {
    std::size_t constraint;
    double size;  ///< its gradient in the metric, at the longest of some places
  };
  std::vector<Row> rows_;
  std::vector<bool> free_;
};

}  // namespace torsor
