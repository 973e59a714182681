// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/reference.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"
#include "torsor/generator/dynamics/equations/contact_checks.hpp"
#include "torsor/generator/dynamics/equations/massless.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/extrapolation.hpp"
#include "torsor/generator/verification/lagrange_derivation.hpp"

namespace torsor {
namespace {

/// y = (q, q̇) -> (q̇, q̈) by the Lagrange derivation.
class Motion {
 public:
  explicit Motion(const Scene& scene) : road_(scene), evaluate_(road_.equations().program(), {}) {
    const Model& model = road_.equations().model();
    positions_ = model.positions();
    for (const SymbolPointer& q : positions_) rates_.push_back(rate_of(model.program(), q));
  }

  std::vector<Real> operator()(const Real& t, const std::vector<Real>& y) {
    const Model& model = road_.equations().model();
    const auto n = static_cast<std::size_t>(model.unknown_count());
    evaluate_.move_to([&](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi();
      if (symbol->kind == SymbolKind::time) return t;
      for (std::size_t i = 0; i < positions_.size(); ++i) {
        if (symbol == positions_[i]) return y[i];
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (symbol == model.coordinates()[i].v) return y[positions_.size() + i];
      }
      for (const ParameterContent& p : model.scene().parameters) {
        if (p.symbol == symbol && p.value) return parameter_value(model.scene(), *p.value);
      }
      return Real(0);  // released coordinates, inputs
    });
    const std::vector<std::size_t>& kept = road_.equations().redundancy().kept;
    const std::size_t size = n + kept.size();
    std::vector<Real> matrix(size * size, Real(0));
    std::vector<Real> right_side(size);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) matrix[i + j * size] = evaluate_(road_.mass()[i][j]);
      right_side[i] = evaluate_(road_.forces()[i]) - evaluate_(road_.operators_at_rest()[i]);
    }
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const ConstraintRow& row = road_.equations().constraints()[kept[k]];
      for (std::size_t i = 0; i < n; ++i) {
        matrix[n + k + i * size] = evaluate_(row.jacobian[i]);
        matrix[i + (n + k) * size] = -evaluate_(row.column[i]);
      }
      right_side[n + k] = -evaluate_(row.gamma);
    }
    const std::vector<Real> solution = solve_dense(std::move(matrix), right_side);
    std::vector<Real> rate;
    for (const Value& value : rates_) rate.push_back(evaluate_(value));
    rate.insert(rate.end(), solution.begin(), solution.begin() + static_cast<std::ptrdiff_t>(n));
    return rate;
  }

  const std::vector<SymbolPointer>& positions() const { return positions_; }

 private:
  LagrangeDerivation road_;
  Evaluator<Real> evaluate_;
  std::vector<SymbolPointer> positions_;
  std::vector<Value> rates_;
};

}  // namespace

namespace {

/// What did not converge as it was asked for, by time.
std::vector<std::string> shortfalls_of(const ConvergedSolution& solution, const ReferenceOptions& options) {
  std::vector<std::string> sentences;
  for (std::size_t row = 0; row < solution.values.size(); ++row) {
    const int digits = solution.agreed_digits[row];
    if (digits >= options.digits) continue;
    sentences.push_back(digits == 0 ? fmt::format("at t = {} no digit converged: no row", options.times[row])
                                    : fmt::format("at t = {} {} digit{} converged, not {}", options.times[row], digits,
                                                  digits == 1 ? "" : "s", options.digits));
  }
  if (!solution.stopped.empty()) {
    sentences.push_back(fmt::format("from t = {} on there is no row: {}", options.times[solution.values.size()],
                                    solution.stopped));
  }
  return sentences;
}

}  // namespace

std::string reference_csv(const Scene& scene, const ReferenceOptions& options) {
  const ReferenceResult motion = integrate_reference(scene, options);
  if (motion.shortfalls.empty()) return motion.text;
  throw Error(fmt::format("the reference of '{}': {}: ask for fewer digits or a shorter time", scene.name(),
                          motion.shortfalls[0]));
}

ReferenceResult integrate_reference(const Scene& scene, const ReferenceOptions& options) {
  refuse_contacts(scene, "a reference");
  constexpr int spare_digits = 15;
  const int work_digits = options.digits + spare_digits;
  const WorkingDigits precision(work_digits);
  const std::vector<Real> start = initial_state(scene);
  if (start.empty()) {
    throw SceneError(fmt::format("the scene '{}' has parameters without a value: a reference needs all of them",
                                 scene.name()));
  }
  if (scene.content().keeps_massless) require_mass(Equations(scene));  // any acceleration of theirs would do
  std::vector<Real> times;
  for (const std::string& time : options.times) times.emplace_back(parse_decimal(time), work_digits);
  Motion motion(scene);
  ExtrapolationOptions integrator;
  integrator.tolerance_digits = options.digits + 5;
  integrator.work_digits = work_digits;
  integrator.as_far_as_it_goes = true;
  const ConvergedSolution solution = integrate_converged(
      {[&motion](const Real& t, const std::vector<Real>& y) { return motion(t, y); }, start}, times, integrator);
  ReferenceResult result;
  result.shortfalls = shortfalls_of(solution, options);
  const std::string agreement = result.shortfalls.empty()
                                    ? fmt::format("agree to {} digits", options.digits)
                                    : fmt::format("agree to the digits that are written, fewer than {}", options.digits);
  std::string& text = result.text;
  text = fmt::format(
      "# Reference motion of the scene {}: Lagrange's operator on T in {}-digit arithmetic, extrapolation at two orders\n"
      "# that {}; inputs zero, run-time parameters at their defaults.\n",
      scene.name(), work_digits, agreement);
  for (const std::string& sentence : result.shortfalls) text += fmt::format("# {}\n", sentence);
  text += fmt::format("# regenerate: {} --digits {} --times {} --output {}.reference.csv\n",
                      scene.command_line("reference"), options.digits, fmt::join(options.times, ","), scene.name());
  text += "time";
  for (const SymbolPointer& q : motion.positions()) text += "," + q->name;
  for (const CoordinateContent& c : scene.content().coordinates) {
    if (c.unknown()) text += "," + c.v->name;
  }
  text += "\n";
  for (std::size_t row = 0; row < solution.values.size(); ++row) {
    if (solution.agreed_digits[row] == 0) continue;
    text += options.times[row];
    for (std::size_t i = 0; i < solution.values[row].size(); ++i) {
      const int digits = std::min(options.digits, solution.shared_digits[row][i]);
      text += "," + (digits == 0 ? std::string("0") : solution.values[row][i].to_string(digits));
    }
    text += "\n";
  }
  return result;
}

}  // namespace torsor
