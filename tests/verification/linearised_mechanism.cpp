// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/linearised_mechanism.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/dynamics/derivatives/forward_derivatives.hpp"
#include "torsor/generator/dynamics/derivatives/reduction.hpp"
#include "torsor/generator/mechanics/parameter_value.hpp"
#include "torsor/generator/verification/random_state.hpp"
#include "tests/dynamics/constrained_motion.hpp"

namespace torsor::testing_mechanisms {
namespace {

using State = ConstrainedMotion::State;

/// Steps of 10^(-digits/3): central differences are off by the square of it times a third derivative, and by the
/// rounding 10^-digits over it; both leave a third of the digits and more. A wrong term shows in the first digits.
struct Differences {
  Real step;
  double bound;
  explicit Differences(int digits)
      : step(Number(10).pow(-digits / 3), digits), bound(std::pow(10.0, -digits / 2 - 3)) {}
};

/// Numbers in [-1, 1] that have nothing to do with the scene.
class Direction {
 public:
  Real next() {
    state_ = (state_ * 1103515245ULL + 12345ULL) % 2147483648ULL;
    return Real(static_cast<int>(state_ >> 11U) % 2001 - 1000) / Real(1000);
  }
  std::vector<Real> next(std::size_t count) {
    std::vector<Real> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(next());
    return all;
  }

 private:
  unsigned long long state_ = 7727;
};

std::vector<Real> central(const std::vector<Real>& above, const std::vector<Real>& below, const Real& step) {
  std::vector<Real> slope;
  for (std::size_t i = 0; i < above.size(); ++i) slope.push_back((above[i] - below[i]) / (step + step));
  return slope;
}

/// Row i of matrix · x, and the size of what was added.
struct Sum {
  Real value = Real(0), size = Real(0);
  void add(const Real& term) {
    value += term;
    size += abs(term);
  }
  void add(Evaluator<Real>& at, const std::vector<Value>& row, const std::vector<Real>& x) {
    for (std::size_t j = 0; j < x.size(); ++j) add(at(row[j]) * x[j]);
  }
};

class LinearisationComparison {
 public:
  LinearisationComparison(const Scene& scene, int digits)
      : differences_(digits), equations_(scene), model_(equations_.model()), motion_(equations_) {
    n_ = static_cast<std::size_t>(model_.unknown_count());
    for (std::size_t i = 0; i < n_; ++i) outcome_.turning = outcome_.turning || model_.coordinates()[i].attitude >= 0;
  }

  LinearisationOutcome run() {
    compare_forward(forward_derivatives(equations_));
    if (equations_.constraints().empty()) {
      compare_full(linearisation(equations_));
      return outcome_;
    }
    std::optional<ReducedLinearisation> reduced;
    if (!equations_.redundancy().singular_start()) reduced = reduced_linearisation(equations_);
    compare_full(reduced ? reduced->full : linearisation(equations_));
    if (!reduced) return outcome_;
    outcome_.redundant = equations_.redundancy().redundant();
    for (const int part : {4, 16, 64, 0}) {  // further and nearer to the start, until the mechanism can be assembled
      const std::optional<State> state = consistent_state(*reduced, part);
      if (!state) continue;
      outcome_.reduced = true;
      compare_reduced(*reduced, *state);
      break;
    }
    return outcome_;
  }

 private:
  void compare(const char* what, std::size_t i, const Real& found, const Real& slope, const Real& size) {
    const double difference = abs(found - slope).to_double();
    if (!outcome_.difference.empty() || difference <= differences_.bound * (1 + size.to_double())) return;
    outcome_.difference =
        fmt::format("{}, row {}: {:.12g} and {:.12g} by differences", what, i, found.to_double(), slope.to_double());
  }

  State random_state() {
    const RandomState random(equations_.scene(), 9);
    const auto value = random.in_real();
    State state;
    for (const SymbolPointer& q : motion_.positions()) state.q.push_back(value(q));
    for (std::size_t i = 0; i < n_; ++i) state.v.push_back(value(model_.coordinates()[i].v));
    for (const SymbolPointer& u : model_.inputs()) state.u.push_back(value(u));
    state.time = value(equations_.scene().content().time);
    return state;
  }

  void displace(State& state, const std::vector<Real>& along, const Real& step) const {
    for (std::size_t i = 0; i < n_; ++i) motion_.displace(state, i, along[i] * step);
  }

  void compare_full(const Linearisation& linear) {
    const State state = random_state();
    Direction draw;
    const std::vector<Real> a = draw.next(n_), lambda = draw.next(equations_.constraints().size());
    const std::vector<Real> dq = draw.next(n_), dv = draw.next(n_), da = draw.next(n_), du = draw.next(state.u.size());
    const auto residual = [&](const Real& step) {
      State moved = state;
      std::vector<Real> accelerations = a;
      displace(moved, dq, step);
      for (std::size_t i = 0; i < n_; ++i) moved.v[i] += step * dv[i], accelerations[i] += step * da[i];
      for (std::size_t k = 0; k < du.size(); ++k) moved.u[k] += step * du[k];
      Evaluator<Real>& at = beside_;
      at.move_to(motion_.reader(moved, accelerations, lambda));
      std::vector<Real> r;
      for (std::size_t i = 0; i < n_; ++i) {
        Real sum = at(equations_.inverse_dynamics()[i]);
        for (std::size_t k = 0; k < du.size(); ++k) sum -= at(equations_.actions().inputs[k][i]) * moved.u[k];
        r.push_back(sum);
      }
      return r;
    };
    const std::vector<Real> slope =
        central(residual(differences_.step), residual(-differences_.step), differences_.step);
    const std::vector<Real> here = residual(Real(0));
    Evaluator<Real>& at = here_;
    at.move_to(motion_.reader(state, a, lambda));
    for (std::size_t i = 0; i < n_; ++i) {
      Sum sum;
      sum.add(at, linear.M[i], da);
      sum.add(at, linear.C[i], dv);
      sum.add(at, linear.K[i], dq);
      for (std::size_t k = 0; k < du.size(); ++k) sum.add(-at(linear.E[i][k]) * du[k]);
      compare("M q̈ + C q̇ + K q − E u", i, sum.value, slope[i], sum.size);
      compare("F", i, at(linear.F[i]), -here[i], abs(here[i]));
    }
  }

  /// Accelerations and multipliers of the motion along one random direction of (q, v, u), and what generalised forces
  /// change: M δa − B δλ gives them back, A δa = 0.
  void compare_forward(const ForwardDerivatives& derivatives) {
    const State state = random_state();
    Evaluator<Real>& at = here_;
    at.move_to(motion_.reader(state));
    for (const auto& [pivot, whole, several] : derivatives.pivots) {
      if (!(at(pivot).to_double() > 1e-6 * at(whole).to_double())) return;  // as good as singular here
    }
    outcome_.forward = true;
    Direction draw;
    const std::vector<Real> dq = draw.next(n_), dv = draw.next(n_), df = draw.next(n_), du = draw.next(state.u.size());
    const ForwardSolution& forward = equations_.forward();
    const auto motion = [&](const Real& step) {
      State moved = state;
      displace(moved, dq, step);
      for (std::size_t i = 0; i < n_; ++i) moved.v[i] += step * dv[i];
      for (std::size_t k = 0; k < du.size(); ++k) moved.u[k] += step * du[k];
      beside_.move_to(motion_.reader(moved));
      std::vector<Real> all = beside_(forward.accelerations);
      for (const Real& lambda : beside_(forward.multipliers)) all.push_back(lambda);
      return all;
    };
    const std::vector<Real> slope = central(motion(differences_.step), motion(-differences_.step), differences_.step);
    const auto along = [&](const ForwardDerivatives::Of& of, std::size_t i, std::size_t first, const char* what) {
      Sum sum;
      sum.add(at, of.by_position[i], dq);
      sum.add(at, of.by_velocity[i], dv);
      sum.add(at, of.by_input[i], du);
      compare(what, i, sum.value, slope[first + i], sum.size);
    };
    std::vector<Real> a, lambda;  // changes by the forces
    for (std::size_t i = 0; i < n_; ++i) {
      along(derivatives.accelerations, i, 0, "accelerations of the motion");
      Sum sum;
      sum.add(at, derivatives.accelerations.by_force[i], df);
      a.push_back(sum.value);
    }
    for (std::size_t j = 0; j < forward.multipliers.size(); ++j) {
      along(derivatives.multipliers, j, n_, "multipliers of the motion");
      Sum sum;
      sum.add(at, derivatives.multipliers.by_force[j], df);
      lambda.push_back(sum.value);
    }
    for (std::size_t i = 0; i < n_; ++i) {
      Sum sum;
      sum.add(at, equations_.mass()[i], a);
      for (std::size_t j = 0; j < lambda.size(); ++j) sum.add(-at(equations_.constraints()[j].column[i]) * lambda[j]);
      compare("M da - B dlambda", i, sum.value, df[i], sum.size);
    }
    for (const std::size_t j : equations_.redundancy().kept) {
      Sum sum;
      sum.add(at, equations_.constraints()[j].jacobian, a);
      compare("A da", j, sum.value, Real(0), sum.size);
    }
  }

  /// The state of the scene at its start, displaced by a fraction of the random direction (none: 0) and assembled.
  std::optional<State> consistent_state(const ReducedLinearisation& reduced, int part) {
    State state = random_state();
    state.time = part == 0 ? Real(0) : state.time / Real(part);
    const SceneContent& content = equations_.scene().content();
    for (std::size_t i = 0; i < state.q.size(); ++i) state.q[i] = initial_value(content, motion_.positions()[i]);
    Direction draw;
    if (part != 0) displace(state, draw.next(n_), Real(1) / Real(part));
    try {
      motion_.satisfy(state, reduced.freedoms);
    } catch (const Error&) {
      return std::nullopt;  // no step of Newton's method: too far from where the mechanism can be assembled
    }
    Evaluator<Real>& at = here_;
    at.move_to(motion_.reader(state));
    // What repeats others holds with them as long as the mechanism was assembled in the same way.
    for (const ConstraintRow& row : equations_.constraints()) {
      for (const Value& residual : {row.value, row.rate}) {
        if (!(abs(at(residual)).to_double() < differences_.bound)) return std::nullopt;
      }
    }
    // Newton's method also ends where the dependent freedoms are not determined: nothing is differentiable there.
    for (const auto& [square, whole, several] : reduced.pivots) {
      if (!(at(square).to_double() > 1e-6 * at(whole).to_double())) return std::nullopt;
    }
    return state;
  }

  void compare_reduced(const ReducedLinearisation& reduced, const State& state) {
    const std::vector<std::size_t>& coordinates = reduced.freedoms.coordinates;
    const std::vector<std::size_t>& velocities = reduced.freedoms.velocities;
    beside_.move_to(motion_.reader(state));
    const std::vector<Real> a = beside_(equations_.forward().accelerations);
    const std::vector<Real> lambda = beside_(equations_.forward().multipliers);
    Evaluator<Real>& at = here_;
    at.move_to(motion_.reader(state, a, lambda));
    Direction draw;
    const std::vector<Real> e = draw.next(coordinates.size()), w = draw.next(velocities.size()),
                            du = draw.next(state.u.size());
    // Rates of the deviations, then accelerations, of the independent freedoms.
    const auto flow = [&](const Real& step) {
      State moved = state;
      for (std::size_t j = 0; j < e.size(); ++j) motion_.displace(moved, coordinates[j], step * e[j]);
      for (std::size_t j = 0; j < w.size(); ++j) moved.v[velocities[j]] += step * w[j];
      for (std::size_t k = 0; k < du.size(); ++k) moved.u[k] += step * du[k];
      motion_.satisfy(moved, reduced.freedoms);
      const std::vector<Real> rates = motion_.rates_of_deviation(state, moved);
      beside_.move_to(motion_.reader(moved));
      const std::vector<Real> accelerations = beside_(equations_.forward().accelerations);
      std::vector<Real> all;
      for (const std::size_t i : coordinates) all.push_back(rates[i]);
      for (const std::size_t i : velocities) all.push_back(accelerations[i]);
      return all;
    };
    const std::vector<Real> slope = central(flow(differences_.step), flow(-differences_.step), differences_.step);
    for (std::size_t i = 0; i < e.size(); ++i) {
      Sum sum;
      sum.add(at, reduced.e_rates_e[i], e);
      sum.add(at, reduced.e_rates_w[i], w);
      compare("rate of the deviation", i, sum.value, slope[i], sum.size);
    }
    const std::vector<Real> w_rates(slope.begin() + static_cast<long>(e.size()), slope.end());
    for (std::size_t i = 0; i < w.size(); ++i) {
      Sum sum;
      sum.add(at, reduced.M[i], w_rates);
      sum.add(at, reduced.C[i], w);
      sum.add(at, reduced.K[i], e);
      for (std::size_t k = 0; k < du.size(); ++k) sum.add(-at(reduced.E[i][k]) * du[k]);
      compare("M_r w' + C_r w + K_r e − E_r u", i, sum.value, Real(0), sum.size);
      compare("F_r", i, at(reduced.F[i]), Real(0), sum.size);
    }
  }

  Differences differences_;
  Equations equations_;
  const Model& model_;
  ConstrainedMotion motion_;
  Evaluator<Real> here_{equations_.program(), {}}, beside_{equations_.program(), {}};
  std::size_t n_ = 0;
  LinearisationOutcome outcome_;
};

}  // namespace

LinearisationOutcome compare_linearisation(const Scene& scene, int digits) {
  const WorkingDigits precision(digits + 10);
  return LinearisationComparison(scene, digits + 10).run();
}

}  // namespace torsor::testing_mechanisms
