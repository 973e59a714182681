// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <concepts>
#include <cstddef>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include "runtime/forced_response.hpp"

namespace torsor::runtime {

/// A real periodic vector, F(t) = Re(c_0 + 2 Σ_{n≥1} c_n e^{inωt}) with c_n = (ω/2π) ∫ F e^{−inωt} dt over a period:
/// ω is that of F itself in both exponents (Pommier, §7.3.2, corrected).
struct FourierSeries {
  double angular_frequency = 1.0;              ///< ω [rad/s]; the period is 2π/ω
  std::vector<Eigen::VectorXcd> coefficients;  ///< c_0, c_1, ...

  [[nodiscard]] Eigen::VectorXd operator()(double t) const {
    Eigen::VectorXd sum = coefficients.front().real();
    for (std::size_t n = 1; n < coefficients.size(); ++n) {
      const std::complex<double> turn = std::polar(1.0, static_cast<double>(n) * angular_frequency * t);
      sum += 2.0 * (coefficients[n] * turn).real();
    }
    return sum;
  }
};

/// Coefficients c_0 ... c_harmonics of a function of period 2π/ω from equidistant samples: exact within rounding for a
/// trigonometric polynomial of a degree below samples − harmonics, else right to the size of the coefficients of that
/// degree. A jump counts with its mean value if the function gives it. Throws std::invalid_argument when samples do not
/// exceed twice the harmonics.
template <std::invocable<double> Function>
[[nodiscard]] FourierSeries fourier_series(const Function& function, double angular_frequency, int harmonics,
                                           int samples = 1024) {
  if (harmonics < 0 || samples <= 2 * harmonics || !(angular_frequency > 0.0)) {
    throw std::invalid_argument("a Fourier series needs a positive frequency and more than two samples a harmonic");
  }
  FourierSeries series{angular_frequency, {}};
  for (int k = 0; k < samples; ++k) {
    const Eigen::VectorXd value = function(2.0 * std::numbers::pi * k / (samples * angular_frequency));
    for (int n = 0; n <= harmonics; ++n) {
      if (k == 0) series.coefficients.emplace_back(Eigen::VectorXcd::Zero(value.size()));
      // n k is reduced before it becomes an angle, so that high harmonics lose no digit.
      const auto remainder = (static_cast<long>(n) * k) % samples;
      const std::complex<double> turn =
          std::polar(1.0 / samples, -2.0 * std::numbers::pi * static_cast<double>(remainder) / samples);
      series.coefficients[static_cast<std::size_t>(n)] += turn * value;
    }
  }
  return series;
}

/// The steady motion of M x'' + C x' + K x = F(t) under a periodic F: harmonic by harmonic,
/// X_n = (K − n²ω² M + i n ω C)⁻¹ c_n. Nothing when a harmonic that F has meets an undamped resonance.
[[nodiscard]] inline std::optional<FourierSeries> periodic_response(const LinearSystem& system,
                                                                    const FourierSeries& force) {
  FourierSeries response{force.angular_frequency, {}};
  for (std::size_t n = 0; n < force.coefficients.size(); ++n) {
    if (force.coefficients[n].isZero(0.0)) {
      response.coefficients.emplace_back(Eigen::VectorXcd::Zero(system.size()));
      continue;
    }
    const auto amplitude =
        FrequencyResponse(system, force.coefficients[n])(static_cast<double>(n) * force.angular_frequency);
    if (!amplitude) return std::nullopt;
    response.coefficients.push_back(*amplitude);
  }
  return response;
}

}  // namespace torsor::runtime
