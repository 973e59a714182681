// SPDX-License-Identifier: MIT
#include "torsor/runtime/small_motions/fourier_series.hpp"

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "torsor/runtime/small_motions/forced_response.hpp"

namespace torsor::runtime {

Eigen::VectorXd FourierSeries::operator()(double t) const {
  Eigen::VectorXd sum = coefficients.front().real();
  for (std::size_t n = 1; n < coefficients.size(); ++n) {
    const std::complex<double> turn = std::polar(1.0, static_cast<double>(n) * angular_frequency * t);
    sum += 2.0 * (coefficients[n] * turn).real();
  }
  return sum;
}

FourierSeries fourier_series(const std::function<Eigen::VectorXd(double)>& function, double angular_frequency,
                             int harmonics, int samples) {
  if (harmonics < 0 || samples <= 2 * harmonics || !(angular_frequency > 0.0)) {
    throw std::invalid_argument("a Fourier series needs a positive frequency and more than two samples a harmonic");
  }
  FourierSeries series{angular_frequency, {}};
  Eigen::VectorXd largest;
  for (int k = 0; k < samples; ++k) {
    const Eigen::VectorXd value = function(2.0 * std::numbers::pi * k / (samples * angular_frequency));
    largest = k == 0 ? Eigen::VectorXd(value.cwiseAbs()) : Eigen::VectorXd(largest.cwiseMax(value.cwiseAbs()));
    for (int n = 0; n <= harmonics; ++n) {
      if (k == 0) series.coefficients.emplace_back(Eigen::VectorXcd::Zero(value.size()));
      // n k is reduced before it becomes an angle, so that high harmonics lose no digit.
      const auto remainder = (static_cast<long>(n) * k) % samples;
      const std::complex<double> turn =
          std::polar(1.0 / samples, -2.0 * std::numbers::pi * static_cast<double>(remainder) / samples);
      series.coefficients[static_cast<std::size_t>(n)] += turn * value;
    }
  }
  // Angles up to 2π carry 2π ε, a product 2 ε more, and roundings of a sum add up like steps at random.
  const double rounding = (16.0 + std::sqrt(samples)) * std::numeric_limits<double>::epsilon();
  for (Eigen::VectorXcd& coefficient : series.coefficients) {
    for (Eigen::Index i = 0; i < coefficient.size(); ++i) {
      const double part = rounding * largest(i);
      const std::complex<double> c = coefficient(i);
      coefficient(i) = {std::abs(c.real()) <= part ? 0.0 : c.real(), std::abs(c.imag()) <= part ? 0.0 : c.imag()};
    }
  }
  return series;
}

std::optional<FourierSeries> periodic_response(const LinearSystem& system, const FourierSeries& force) {
  FourierSeries response{force.angular_frequency, {}};
  std::vector<Eigen::VectorXcd> forces = force.coefficients;
  if (forces.empty()) forces.emplace_back(Eigen::VectorXcd::Zero(system.size()));
  if (system.F.size() > 0) {  // none is zero
    if (system.F.size() != forces[0].size()) {
      throw std::invalid_argument("the force has " + std::to_string(forces[0].size()) + " entries and the system's own F " +
                                  std::to_string(system.F.size()) + ": give both one for each coordinate");
    }
    // What is left of balances that were found by numbers is no force.
    double largest = system.F.cwiseAbs().maxCoeff();
    for (const Eigen::VectorXcd& each : force.coefficients) largest = std::max(largest, each.cwiseAbs().maxCoeff());
    const double rounding = 64.0 * std::numeric_limits<double>::epsilon() * largest;
    forces[0] += (system.F.array().abs() <= rounding).select(0.0, system.F);
  }
  for (std::size_t n = 0; n < forces.size(); ++n) {
    if (forces[n].isZero(0.0)) {
      response.coefficients.emplace_back(Eigen::VectorXcd::Zero(system.size()));
      continue;
    }
    const auto amplitude = FrequencyResponse(system, forces[n])(static_cast<double>(n) * force.angular_frequency);
    if (!amplitude) return std::nullopt;
    response.coefficients.push_back(*amplitude);
  }
  return response;
}

}  // namespace torsor::runtime
