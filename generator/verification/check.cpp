// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/base/linear_algebra/lu_factorisation.hpp"
#include "torsor/generator/base/linear_algebra/symmetric_pivots.hpp"
#include "torsor/generator/dynamics/theorems/painleve.hpp"
#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/verification/check_bearings.hpp"
#include "torsor/generator/verification/check_constraints.hpp"
#include "torsor/generator/verification/check_contacts.hpp"
#include "torsor/generator/verification/check_jets.hpp"
#include "torsor/generator/verification/check_kernels.hpp"
#include "torsor/generator/verification/check_percussions.hpp"
#include "torsor/generator/verification/lagrange_derivation.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace torsor {
namespace {

/// Largest relative difference seen so far of quantities compared one by one.
class Worst {
 public:
  /// |x − y| relative to a scale that is not zero unless both vanish.
  void compare(const Real& x, const Real& y, const Real& scale) {
    const double difference = abs(x - y).to_double();
    const double size = std::max(abs(x).to_double(), abs(scale).to_double());
    const double relative = difference == 0 ? 0 : difference / size;
    if (is_worse(relative, worst_)) worst_ = relative;
  }
  double value() const { return worst_; }

 private:
  double worst_ = 0;
};

Real sum_of_sizes(const std::vector<Real>& terms) {
  Real sum = Real(0);
  for (const Real& term : terms) sum += abs(term);
  return sum;
}

/// For each size the largest of the same unit: components of one unit share a scale, for one of them may vanish
/// identically and be nothing but rounding.
std::vector<Real> largest_of_unit(const std::vector<Real>& sizes, const std::vector<Unit>& units) {
  std::vector<Real> result = sizes;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    for (std::size_t j = 0; j < sizes.size(); ++j) {
      if (units[i] == units[j] && sizes[j] > result[i]) result[i] = sizes[j];
    }
  }
  return result;
}

/// The matrix without the rows and columns of those indices, which ascend.
std::vector<std::vector<Real>> without(std::vector<std::vector<Real>> m, const std::vector<int>& indices) {
  for (auto index = indices.rbegin(); index != indices.rend(); ++index) {
    m.erase(m.begin() + *index);
    for (std::vector<Real>& row : m) row.erase(row.begin() + *index);
  }
  return m;
}

class SceneCheck {
 public:
  SceneCheck(const Scene& scene, const CheckOptions& options)
      : scene_(scene), options_(options), precision_(options.digits + 10), kernels_(scene), road_(scene) {}

  std::vector<CheckResult> run() {
    const Program& program = kernels_.program();
    Program& road_program = road_.equations().program();
    const Model& model = kernels_.model();
    const auto n = static_cast<std::size_t>(model.unknown_count());
    const std::size_t all = model.coordinates().size();
    const std::vector<int>& massless = kernels_.massless();
    const ForwardSolution* forward = massless.empty() ? &kernels_.forward() : nullptr;
    const std::vector<Value>& inverse = kernels_.inverse_dynamics();
    const PainleveReport report = painleve(kernels_);
    const Value power = time_derivative(report.t2_minus_t0);
    std::vector<Value> momenta;
    if (power.program() != nullptr) {
      std::vector<SymbolPointer> velocities;
      for (std::size_t i = 0; i < n; ++i) velocities.push_back(model.coordinates()[i].v);
      momenta = gradient(report.t2_minus_t0, velocities);
    }

    for (int k = 0; k < options_.states; ++k) {
      const RandomState state(scene_, static_cast<std::uint64_t>(k) + 1);
      Evaluator<Real> here(program, state.in_real());
      // On the Lagrange derivation the released coordinates are symbols: held at zero there too.
      Evaluator<Real> there(road_program, [&](const SymbolPointer& symbol) {
        for (std::size_t i = n; i < all; ++i) {
          const CoordinateContent& c = model.coordinates()[i];
          if (symbol == c.q || symbol == c.v || symbol == c.a) return Real(0);
        }
        return state.in_real()(symbol);
      });

      // 1. Lagrange's operator on T against virtual power.
      std::vector<Real> lefts, sizes;
      std::vector<Unit> units;
      for (std::size_t i = 0; i < all; ++i) {
        const Real operator_side = there(road_.operators()[i]);
        const Real force_side = there(road_.forces()[i]);
        std::vector<Real> terms{operator_side, force_side};
        Real left = operator_side - force_side;
        for (std::size_t j = 0; j < kernels_.constraints().size(); ++j) {
          const ConstraintRow& row = road_.equations().constraints()[j];
          const Real reaction = there(row.column[i]) * there(road_program.symbol(row.multiplier));
          left -= reaction;
          terms.push_back(reaction);
        }
        lefts.push_back(left);
        sizes.push_back(sum_of_sizes(terms));
        units.push_back(model.coordinates()[i].q->unit);
      }
      sizes = largest_of_unit(sizes, units);
      for (std::size_t i = 0; i < all; ++i) derivations_.compare(here(inverse[i]), lefts[i], sizes[i]);

      // 2. Mass matrices: composite bodies against ∂P_i/∂q̈_j; symmetry of the latter; positiveness.
      std::vector<std::vector<Real>> m(n, std::vector<Real>(n));
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) m[i][j] = there(road_.mass()[i][j]);
      }
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          const Real scale = sqrt(abs(m[i][i] * m[j][j]));
          masses_.compare(here(kernels_.mass()[i][j]), m[i][j], scale);
          symmetry_.compare(m[i][j], m[j][i], scale);
        }
      }
      if (!SymmetricPivots(without(m, massless), Real(0)).all_positive()) ++not_positive_;

      // 3. Forward dynamics put back into the equations: M a + h − E u − Aᵀλ = 0 and A a + γ = 0. Where M is singular any
      // accelerations and multipliers are those of a motion, under the forces of inverse dynamics in place of E u.
      std::vector<Real> a, lambda, driving;
      if (forward != nullptr) {
        a = here(forward->accelerations);
        lambda = here(forward->multipliers);
        check_forward(here, a, lambda, m);
        driving = forces_of_inputs(here);
      } else {
        for (std::size_t i = 0; i < n; ++i) a.push_back(here(model.a(static_cast<int>(i))));
        for (const ConstraintRow& row : kernels_.constraints()) lambda.push_back(here(kernels_.program().symbol(row.multiplier)));
        driving = here(std::vector<Value>(inverse.begin(), inverse.begin() + static_cast<std::ptrdiff_t>(n)));
      }
      check_columns(here);

      // 4. Energy theorem in Painlevé's form: d(T2 − T0)/dt + ∂T/∂t = Σ (Q_i + E u_i + Σ λ_j a_ji) q̇_i.
      if (power.program() != nullptr) {
        Evaluator<Real> moving(program, [&](const SymbolPointer& symbol) {
          for (std::size_t i = 0; i < n; ++i) {
            if (symbol == model.coordinates()[i].a) return a[i];
          }
          return state.in_real()(symbol);
        });
        // A body left to itself has no power, but its parts do: the size of what cancels is that of Σ |∂T2/∂q̇_i q̈_i|.
        Real exchanged = Real(0);
        for (std::size_t i = 0; i < n; ++i) exchanged += abs(here(momenta[i]) * a[i]);
        std::vector<Real> terms_of_power = opposite_powers(here, there(road_.forces()), driving, lambda);
        terms_of_power.push_back(moving(power));
        terms_of_power.push_back(moving(report.explicit_rate));
        check_energy(terms_of_power, exchanged);
      }
    }
    return collect();
  }

 private:
  /// E u.
  std::vector<Real> forces_of_inputs(Evaluator<Real>& here) const {
    const Model& model = kernels_.model();
    const std::vector<SymbolPointer> inputs = model.inputs();
    std::vector<Real> forces(static_cast<std::size_t>(model.unknown_count()), Real(0));
    for (std::size_t i = 0; i < forces.size(); ++i) {
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        forces[i] += here(kernels_.actions().inputs[k][i]) * here(kernels_.program().symbol(inputs[k]));
      }
    }
    return forces;
  }

  /// Generalised forces of reactions against the gradients of the constraints.
  void check_columns(Evaluator<Real>& here) {
    if (kernels_.constraints().empty()) return;
    const auto n = static_cast<std::size_t>(kernels_.model().unknown_count());
    for (const std::size_t j : kernels_.redundancy().kept) {
      const ConstraintRow& row = kernels_.constraints()[j];
      std::vector<Real> gradient;
      for (std::size_t i = 0; i < n; ++i) gradient.push_back(here(row.jacobian[i]));
      const Real size = sum_of_sizes(gradient);
      for (std::size_t i = 0; i < n; ++i) columns_.compare(here(row.ideal[i]), gradient[i], size);
    }
  }

  void check_forward(Evaluator<Real>& here, const std::vector<Real>& a, const std::vector<Real>& lambda,
                     const std::vector<std::vector<Real>>& mass) {
    const auto& inputs = kernels_.model().inputs();
    std::vector<Real> lefts, sizes;
    std::vector<std::vector<Real>> forces(1 + inputs.size() + lambda.size(), std::vector<Real>(a.size()));
    for (std::size_t i = 0; i < a.size(); ++i) {
      std::vector<Real> terms{here(kernels_.bias()[i])};
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        terms.push_back(-(here(kernels_.actions().inputs[k][i]) * here(kernels_.program().symbol(inputs[k]))));
      }
      for (std::size_t j = 0; j < lambda.size(); ++j)
        terms.push_back(-(here(kernels_.constraints()[j].column[i]) * lambda[j]));
      for (std::size_t f = 0; f < forces.size(); ++f) forces[f][i] = terms[f];
      for (std::size_t j = 0; j < a.size(); ++j) terms.push_back(here(kernels_.mass()[i][j]) * a[j]);
      Real sum = Real(0);
      for (const Real& term : terms) sum += term;
      lefts.push_back(sum);
      sizes.push_back(sum_of_sizes(terms));
    }
    // Where every term of an equation is nothing beside those of the others, all of them vanish (the resultant along a
    // direction without forces) and only their rounding is left.
    const Real nothing = sum_of_sizes(sizes) * pow(Real(10), -options_.digits);
    for (std::size_t i = 0; i < lefts.size(); ++i) {
      if (sizes[i] > nothing) forward_.compare(lefts[i], Real(0), sizes[i]);
    }
    if (kernels_.constraints().empty()) return;
    lefts.clear();
    sizes.clear();
    std::vector<Unit> units;
    const std::vector<Real> made_of = accelerations_without_signs(mass, forces);
    for (const std::size_t j : kernels_.redundancy().kept) {  // a random state violates constraints that repeat others
      const ConstraintRow& row = kernels_.constraints()[j];
      std::vector<Real> terms{here(row.gamma)};
      std::vector<Real> gradient;
      for (std::size_t i = 0; i < a.size(); ++i) {
        gradient.push_back(here(row.jacobian[i]));
        terms.push_back(gradient[i] * a[i]);
      }
      Real sum = Real(0);
      for (const Real& term : terms) sum += term;
      lefts.push_back(sum);
      for (std::size_t i = 0; i < a.size(); ++i) terms.push_back(gradient[i] * made_of[i]);
      sizes.push_back(sum_of_sizes(terms));
      units.push_back(row.multiplier->unit);
    }
    sizes = largest_of_unit(sizes, units);
    for (std::size_t j = 0; j < lefts.size(); ++j) constraints_.compare(lefts[j], Real(0), sizes[j]);
  }

  /// Σ_f |M⁻¹ f|: what each acceleration is made of. A contact that holds a body up leaves of it nothing but rounding.
  static std::vector<Real> accelerations_without_signs(const std::vector<std::vector<Real>>& mass,
                                                       const std::vector<std::vector<Real>>& forces) {
    const std::size_t n = mass.size();
    std::vector<Real> sums(n, Real(0)), columns;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) columns.push_back(mass[i][j]);
    }
    const bool undefined = std::any_of(columns.begin(), columns.end(), [](const Real& m) { return m.is_nan(); });
    if (undefined) return sums;  // the comparison fails by itself
    const LuFactorisation factors(std::move(columns), static_cast<int>(n));
    for (const std::vector<Real>& force : forces) {
      const std::vector<Real> part = factors.solve(force);
      for (std::size_t i = 0; i < n; ++i) sums[i] += abs(part[i]);
    }
    return sums;
  }

  /// Of all forces, with the sign of the left-hand side.
  std::vector<Real> opposite_powers(Evaluator<Real>& here, const std::vector<Real>& forces,
                                    const std::vector<Real>& driving, const std::vector<Real>& lambda) const {
    const Model& model = kernels_.model();
    std::vector<Real> terms;
    for (std::size_t i = 0; i < static_cast<std::size_t>(model.unknown_count()); ++i) {
      const Real v = here(model.v(static_cast<int>(i)));
      terms.push_back(-(forces[i] * v));
      terms.push_back(-(driving[i] * v));
      for (std::size_t j = 0; j < lambda.size(); ++j) {
        terms.push_back(-(here(kernels_.constraints()[j].column[i]) * lambda[j] * v));
      }
    }
    return terms;
  }

  void check_energy(const std::vector<Real>& terms, const Real& exchanged) {
    Real sum = Real(0);
    for (const Real& term : terms) sum += term;
    energy_.compare(sum, Real(0), sum_of_sizes(terms) + exchanged);
  }

  std::vector<CheckResult> collect() const {
    const double bound = std::pow(10.0, 5 - options_.digits);  // five digits for rounding and cancellation
    std::vector<CheckResult> results{
        {"derivations", "Lagrange's operator on T against virtual power", derivations_.value(), bound},
        {"mass_matrix", "second derivatives of T against composite bodies", masses_.value(), bound},
        {"symmetry", "symmetry of the mass matrix", symmetry_.value(), bound},
        {"positiveness", "states where the mass matrix is not positive definite", not_positive_, 0},
        {"forward_dynamics", "accelerations and multipliers put back into the equations", forward_.value(), bound},
        {"energy_theorem", "d(T2 - T0)/dt + dT/dt|explicit against the power of all forces", energy_.value(), bound}};
    const bool solved = kernels_.massless().empty();
    if (!solved) std::erase_if(results, [](const CheckResult& result) { return result.name == "forward_dynamics"; });
    if (!kernels_.constraints().empty() && solved) {
      results.push_back({"constraints", "acceleration form of the constraints", constraints_.value(), bound});
    }
    if (!kernels_.constraints().empty()) {
      results.push_back(
          {"reactions", "generalised forces of reactions against constraint gradients", columns_.value(), bound});
    }
    return results;
  }

  const Scene& scene_;
  CheckOptions options_;
  WorkingDigits precision_;
  Equations kernels_;
  LagrangeDerivation road_;
  Worst derivations_, masses_, symmetry_, forward_, energy_, constraints_, columns_;
  double not_positive_ = 0;
};

}  // namespace

std::vector<CheckResult> check_derivations(const Scene& scene, const CheckOptions& options) {
  std::vector<CheckResult> results = SceneCheck(scene, options).run();
  for (CheckResult& result : check_constraints(scene, options)) results.push_back(std::move(result));
  for (CheckResult& result : check_contacts(scene, options)) results.push_back(std::move(result));
  for (CheckResult& result : check_bearings(scene, options)) results.push_back(std::move(result));
  for (CheckResult& result : check_percussions(scene, options)) results.push_back(std::move(result));
  return results;
}

std::vector<CheckResult> check_scene(const Scene& scene, const CheckOptions& options) {
  std::vector<CheckResult> results = check_derivations(scene, options);
  for (CheckResult& result : check_kernels(scene, options)) results.push_back(std::move(result));
  for (CheckResult& result : check_jets(scene, options)) results.push_back(std::move(result));
  return results;
}

}  // namespace torsor
