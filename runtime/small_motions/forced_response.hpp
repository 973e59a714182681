// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "torsor/runtime/small_motions/linear_system.hpp"

namespace torsor::runtime {

/// The steady motion x(t) = Re(X e^{iωt}) under the force Re(F e^{iωt}): X(ω) = (K − ω² M + i ω C)⁻¹ F (Pommier,
/// §7.3.2). A force F cos ωt is a real F, a force F sin ωt is −i F. Made once for a system, asked at many ω.
class FrequencyResponse {
 public:
  /// Throws std::invalid_argument as `normalised` does, and for a force of another size.
  FrequencyResponse(const LinearSystem& system, const Eigen::VectorXcd& force);

  /// Amplitudes at ω [rad/s]; nothing at the resonance of an undamped mode, where no steady motion exists.
  [[nodiscard]] std::optional<Eigen::VectorXcd> operator()(double omega) const;

 private:
  NormalisedSystem normal_;
  Eigen::VectorXcd force_;
};

/// One point of a resonance curve.
struct ResonancePoint {
  double angular_frequency = 0.0;
  std::optional<Eigen::VectorXcd> amplitude;
};

/// X(ω) over a grid of ω [rad/s].
[[nodiscard]] std::vector<ResonancePoint> resonance_curve(const LinearSystem& system, const Eigen::VectorXcd& force,
                                                          const std::vector<double>& grid);

/// The speeds at which a coordinate stays still under a force although the system vibrates: ω [rad/s] with
/// X_coordinate(ω) = 0 without damping (C is not looked at), slowest first. By Cramer's rule X_j is the determinant of
/// K − ω² M with column j replaced by the force, divided by that of K − ω² M: the ω² are the finite eigenvalues of the
/// pencil of K and M whose column j is the force and zero. A speed at which numerator and denominator vanish together
/// is not listed. Throws std::invalid_argument for shapes, and for a coordinate that is not one.
[[nodiscard]] std::vector<double> antiresonances(const LinearSystem& system, const Eigen::VectorXd& force,
                                                 Eigen::Index coordinate);

/// A maximum of a coordinate's amplitude.
struct ResonancePeak {
  double angular_frequency = 0.0;
  double amplitude = 0.0;
};

/// Of which coordinate, between which speeds [rad/s], and on a grid of how many points.
struct PeakSearch {
  Eigen::Index coordinate = 0;
  double from = 0.0, to = 0.0;
  int samples = 1000;
};

/// The maxima of |X_coordinate(ω)| between two speeds: those that a grid of `samples` points sees, each refined by
/// golden section to 1e-9 of the interval, or as far as doubles go. An undamped resonance that is met exactly counts as infinite.
[[nodiscard]] std::vector<ResonancePeak> resonance_peaks(const LinearSystem& system, const Eigen::VectorXcd& force,
                                                         const PeakSearch& search);

}  // namespace torsor::runtime
