// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check_jets.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "torsor/generator/kernels/kernel_jets.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/verification/condition.hpp"
#include "torsor/generator/verification/kernel_text.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace torsor {
namespace {

constexpr int digits = 140;
constexpr int degree = 9;
constexpr int states_at_most = 3;
constexpr int digits_of_step = 10;

using Coefficients = std::vector<std::vector<Real>>;

double largest(const std::vector<Real>& values) {
  double size = 0;
  for (const Real& value : values) size = std::max(size, abs(value).to_double());
  return size;
}

/// The least ρ with |c_k| <= max(1, |y|) ρ^k.
double growth(const Coefficients& coefficients) {
  const double size = std::max(1.0, largest(coefficients[0]));
  double rho = 0;
  for (std::size_t k = 1; k < coefficients.size(); ++k) {
    rho = std::max(rho, std::pow(largest(coefficients[k]) / size, 1.0 / static_cast<double>(k)));
  }
  return rho;
}

/// dy/dt in the order of the state, evaluated without recurrences.
std::vector<Value> rates_of(const Equations& equations, const std::vector<SymbolPointer>& state) {
  const ForwardSolution& forward = equations.forward();
  const std::size_t positions = state.size() - forward.accelerations.size();
  std::vector<Value> rates;
  for (std::size_t i = 0; i < positions; ++i) rates.push_back(rate_of(equations.program(), state[i]));
  rates.insert(rates.end(), forward.accelerations.begin(), forward.accelerations.end());
  return rates;
}

class JetCheck {
 public:
  explicit JetCheck(const Scene& scene)
      : scene_(scene), precision_(digits), equations_(scene), kernel_(make_kernel("jets", equations_)) {}

  std::vector<CheckResult> run(int states) {
    if (!kernel_.series) return {};
    for (int k = 0; k < std::min(states, states_at_most); ++k)
      at(RandomState(scene_, static_cast<std::uint64_t>(k) + 1));
    return {{"jets", "Taylor polynomial put into the forward dynamics against its next term", residual_, 1e-7},
            {"double.jets", "double against CLN, as a multiple of max(1, condition/10)", rounding_, 1e-12}};
  }

 private:
  void at(const RandomState& state) {
    const SeriesResult& series = *kernel_.series;
    Evaluator<Real> exact(equations_.program(), state.in_real());
    const Coefficients c = taylor_coefficients(series, exact, degree + 1);
    const double rho = growth(c);
    const double size = std::max(1.0, largest(c[0]));
    compare_in_double(state, {.coefficients = c, .rho = rho, .size = size}, exact);
    if (rho == 0) return;
    const Real h = pow(Real(10), -digits_of_step) / Real::from_double(rho);

    // y_N(h), y_N'(h)
    const std::size_t n = series.state.size();
    std::map<const Symbol*, Real> moved;
    std::vector<Real> rate(n, Real(0));
    for (std::size_t i = 0; i < n; ++i) {
      Real y = Real(0);
      for (int k = degree; k >= 0; --k) y = y * h + c[static_cast<std::size_t>(k)][i];
      for (int k = degree; k >= 1; --k) rate[i] = rate[i] * h + Real(k) * c[static_cast<std::size_t>(k)][i];
      moved.emplace(series.state[i].get(), y);
    }
    Evaluator<Real> there(equations_.program(), [&](const SymbolPointer& symbol) {
      const auto place = moved.find(symbol.get());
      if (place != moved.end()) return place->second;
      const Real value = state.in_real()(symbol);
      return symbol->kind == SymbolKind::time ? value + h : value;
    });
    const std::vector<Real> f = there(rates_of(equations_, series.state));
    // Errors of relative size hρ = 1e-10, times what higher coefficients exceed ρ by
    const double scale = (degree + 1) * size * std::pow(rho, degree + 1);
    for (std::size_t i = 0; i < n; ++i) {
      const Real difference = (rate[i] - f[i]) / pow(h, degree) + Real(degree + 1) * c[degree + 1][i];
      keep(residual_, abs(difference).to_double() / scale);
    }
  }

  struct ExactSeries {
    const Coefficients& coefficients;
    double rho;   ///< their growth from one to the next
    double size;  ///< of the state, 1 at least
  };

  void compare_in_double(const RandomState& state, const ExactSeries& series_of, Evaluator<Real>& here) {
    const auto& [exact, rho, size] = series_of;
    const SeriesResult& series = *kernel_.series;
    Evaluator<double> fast(equations_.program(), state.in_double());
    const auto c = taylor_coefficients(series, fast, degree + 1);
    const double allowance = std::max(1.0, motion_condition(equations_, here) / 10);
    for (std::size_t k = 1; k < c.size(); ++k) {
      for (std::size_t i = 0; i < c[k].size(); ++i) {
        const double error = abs(Real::from_double(c[k][i]) - exact[k][i]).to_double();
        if (!(error == 0)) keep(rounding_, error / (size * std::pow(rho, static_cast<double>(k))) / allowance);
      }
    }
  }

  static void keep(double& worst, double value) {
    if (is_worse(value, worst)) worst = value;
  }

  const Scene& scene_;
  WorkingDigits precision_;
  Equations equations_;
  Kernel kernel_;
  double residual_ = 0, rounding_ = 0;
};

}  // namespace

std::vector<CheckResult> check_jets(const Scene& scene, const CheckOptions& options) {
  return JetCheck(scene).run(options.states);
}

}  // namespace torsor
