// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "torsor/runtime/small_motions/linear_system.hpp"

namespace torsor::runtime {

/// A real periodic vector, F(t) = Re(c_0 + 2 Σ_{n≥1} c_n e^{inωt}) with c_n = (ω/2π) ∫ F e^{−inωt} dt over a period:
/// ω is that of F itself in both exponents (Pommier, §7.3.2, corrected).
struct FourierSeries {
  double angular_frequency = 1.0;              ///< ω [rad/s]; the period is 2π/ω
  std::vector<Eigen::VectorXcd> coefficients;  ///< c_0, c_1, ...

  [[nodiscard]] Eigen::VectorXd operator()(double t) const;
};

/// Coefficients c_0 ... c_harmonics of a function of period 2π/ω from equidistant samples: exact within rounding for a
/// trigonometric polynomial of a degree below samples − harmonics, else right to the size of the coefficients of that
/// degree. A jump counts with its mean value if the function gives it. An entry that is rounding of the samples alone,
/// below (16 + √samples) ε of the largest, is 0: a harmonic that the function lacks is none. Throws
/// std::invalid_argument when samples do not exceed twice the harmonics.
[[nodiscard]] FourierSeries fourier_series(const std::function<Eigen::VectorXd(double)>& function,
                                           double angular_frequency, int harmonics, int samples = 1024);

/// The steady motion of M x'' + C x' + K x = F(t) under a periodic F: harmonic by harmonic,
/// X_n = (K − n²ω² M + i n ω C)⁻¹ c_n. The system's own F counts with c_0. Nothing when a harmonic that F has meets an
/// undamped resonance, or a constant force a free motion. Throws std::invalid_argument where shapes do not fit.
[[nodiscard]] std::optional<FourierSeries> periodic_response(const LinearSystem& system, const FourierSeries& force);

}  // namespace torsor::runtime
