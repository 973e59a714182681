// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/numerics/root_search.hpp"

namespace torsor::runtime {

/// A mechanism generated with the kernel `inverse_dynamics`.
template <class M>
concept HasInverseDynamics = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             const typename M::Accelerations& a, const typename M::Multipliers& lambda,
             typename M::GeneralizedForces& forces) {
  M::inverse_dynamics(precomputed, state, a, lambda, forces);
};

/// A mechanism generated with the kernel `linearisation`.
template <class M>
concept HasLinearisation = MechanismModel<M> &&
    requires(const typename M::Precomputed& precomputed, const typename M::State& state,
             const typename M::Accelerations& a, const typename M::Multipliers& lambda,
             const typename M::Inputs& inputs, typename M::Linearisation& linear) {
  M::linearisation(precomputed, state, a, lambda, inputs, linear);
};

/// What the equations of a state can be written with: `inverse_dynamics`, or `linearisation` where inputs act, and
/// `constraints` where there are any.
template <class M>
concept HasStateEquations = (HasInverseDynamics<M> || HasLinearisation<M>)&&(M::multiplier_count == 0 ||
                                                                             HasConstraints<M>);

/// A search for states that satisfy the equations of motion  M a + h − Aᵀλ = Q(u),  f(q, t) = 0,  A v = b,  A a + γ = 0
/// at one time: which of q, v, a are unknown, in which box, and what the others are. Multipliers are always unknown;
/// unit quaternions among the coordinates are held to their norm (their box is [-1, 1] each).
template <MechanismModel M>
struct StateProblem {
  typename M::State state{};                  ///< time, and the values of what is not unknown
  typename M::Accelerations accelerations{};  ///< values of those that are not unknown
  typename M::Inputs inputs{};
  std::vector<int> coordinates{}, velocities{}, accelerations_unknown{};  ///< indices of the unknowns
  /// Bounds of the unknowns: first the coordinates, then the velocities, then the accelerations, as listed.
  Eigen::VectorXd lower{}, upper{};
  std::vector<int> angles{};  ///< coordinates that count modulo 2π
  /// Coordinates whose equation is not asked to hold: what it leaves over is the effort that must be supplied along
  /// them.
  std::vector<int> supplied{};
  RootSearchOptions options{};
};

template <MechanismModel M>
struct FoundState {
  typename M::State state{};
  typename M::Accelerations accelerations{};
  typename M::Multipliers multipliers{};
  typename M::GeneralizedForces efforts{};  ///< along `supplied` coordinates, zero along the others
  double residual = 0.0;                    ///< largest equation left over, relative to its size over the box
  bool isolated = true;                     ///< see FoundRoot
  int found = 1;
};

template <MechanismModel M>
struct StateSearch {
  std::vector<FoundState<M>> found;
  std::vector<FailedStart> failures;  ///< their unknowns in the order of the bounds, then the multipliers
  int starts = 0;
};

namespace detail {

/// The equations of a state as a function of the unknowns.
template <HasStateEquations M>
class StateEquations {
 public:
  static constexpr Eigen::Index n = M::velocity_count, m = M::multiplier_count;
  static constexpr Eigen::Index quaternions = [] {
    if constexpr (HasQuaternions<M>) return Eigen::Index(M::quaternion_count);
    return Eigen::Index(0);
  }();

  StateEquations(const typename M::Precomputed& precomputed, const StateProblem<M>& problem)
      : precomputed_(precomputed), problem_(problem) {
    check(problem.coordinates, M::coordinate_count);
    check(problem.angles, M::coordinate_count);
    check(problem.velocities, M::velocity_count);
    check(problem.accelerations_unknown, M::velocity_count);
    check(problem.supplied, M::velocity_count);
    require_inputs();
    for (int i = 0; i < M::velocity_count; ++i) {
      bool supplied = false;
      for (const int k : problem.supplied) supplied = supplied || k == i;
      if (!supplied) kept_.push_back(i);
    }
    for (int j = 0; j < M::multiplier_count; ++j) {
      bool redundant = false;
      if constexpr (HasRedundantConstraints<M>) {
        for (const int k : M::redundant_multipliers) redundant = redundant || k == j;
      }
      if (!redundant) multipliers_.push_back(j);
    }
  }

  [[nodiscard]] Eigen::Index unknowns() const {
    return static_cast<Eigen::Index>(problem_.coordinates.size() + problem_.velocities.size() +
                                     problem_.accelerations_unknown.size() + multipliers_.size());
  }

  [[nodiscard]] Eigen::Index multipliers() const { return static_cast<Eigen::Index>(multipliers_.size()); }

  [[nodiscard]] FoundState<M> at(const Eigen::VectorXd& x) const {
    FoundState<M> s{problem_.state, problem_.accelerations};
    Eigen::Index k = 0;
    for (const int i : problem_.coordinates) s.state.q[i] = x(k++);
    for (const int i : problem_.velocities) s.state.v[i] = x(k++);
    for (const int i : problem_.accelerations_unknown) s.accelerations[i] = x(k++);
    if constexpr (m > 0) {
      for (int j = 0; j < M::multiplier_count; ++j) s.multipliers[j] = 0;
      for (const int j : multipliers_) s.multipliers[j] = x(k++);
    }
    return s;
  }

  /// M a + h − Aᵀλ − Q(u) along every coordinate.
  [[nodiscard]] Eigen::VectorXd forces(const FoundState<M>& s) const {
    Eigen::VectorXd result(n);
    if constexpr (HasLinearisation<M> && (M::input_count > 0 || !HasInverseDynamics<M>)) {
      typename M::Linearisation linear{};
      M::linearisation(precomputed_, s.state, s.accelerations, s.multipliers, problem_.inputs, linear);
      for (Eigen::Index i = 0; i < n; ++i) result(i) = -linear.F[static_cast<std::size_t>(i)];
    } else {
      typename M::GeneralizedForces values{};
      M::inverse_dynamics(precomputed_, s.state, s.accelerations, s.multipliers, values);
      for (int i = 0; i < M::velocity_count; ++i) result(i) = values[i];
    }
    return result;
  }

  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& x) const {
    const FoundState<M> s = at(x);
    const Eigen::VectorXd all = forces(s);
    Eigen::VectorXd result(static_cast<Eigen::Index>(kept_.size()) + 3 * m + quaternions);
    Eigen::Index row = 0;
    for (const int i : kept_) result(row++) = all(i);
    if constexpr (HasQuaternions<M>) {
      for (const int first : M::quaternions) {
        double square = 0.0;
        for (int i = first; i < first + 4; ++i) square += s.state.q[i] * s.state.q[i];
        result(row++) = square - 1.0;
      }
    }
    if constexpr (m > 0) {
      typename M::Constraints c{};
      M::constraints(precomputed_, s.state, c);
      for (std::size_t j = 0; j < static_cast<std::size_t>(m); ++j) {
        result(row++) = c.value[j];
        result(row++) = c.rate[j];
        double acceleration = c.gamma[j];
        for (int i = 0; i < M::velocity_count; ++i) {
          acceleration += c.jacobian[static_cast<std::size_t>(i * m) + j] * s.accelerations[i];
        }
        result(row++) = acceleration;
      }
    }
    return result;
  }

  /// By the kernel `linearisation` where coordinates are independent, else by central differences.
  [[nodiscard]] Eigen::MatrixXd derivative(const Eigen::VectorXd& x) const {
    if constexpr (HasLinearisation<M> && m == 0 && quaternions == 0) {
      const FoundState<M> s = at(x);
      typename M::Linearisation linear{};
      M::linearisation(precomputed_, s.state, s.accelerations, s.multipliers, problem_.inputs, linear);
      Eigen::MatrixXd result(static_cast<Eigen::Index>(kept_.size()), x.size());
      Eigen::Index column = 0;
      const auto fill = [&](const auto& matrix, const std::vector<int>& list) {
        for (const int j : list) {
          Eigen::Index row = 0;
          for (const int i : kept_) result(row++, column) = matrix[static_cast<std::size_t>(j * n + i)];
          ++column;
        }
      };
      fill(linear.K, problem_.coordinates);
      fill(linear.C, problem_.velocities);
      fill(linear.M, problem_.accelerations_unknown);
      return result;
    } else {
      return central_differences([this](const Eigen::VectorXd& at) { return (*this)(at); }, x,
                                 problem_.upper - problem_.lower);
    }
  }

 private:
  // The kernel inverse_dynamics knows no inputs.
  void require_inputs() const {
    if constexpr (M::input_count > 0 && !HasLinearisation<M>) {
      for (int i = 0; i < M::input_count; ++i) {
        if (problem_.inputs[i] == 0) continue;
        throw std::invalid_argument("input " + std::to_string(i) + " is " +
                                    std::to_string(static_cast<double>(problem_.inputs[i])) +
                                    ", and the kernel inverse_dynamics takes none: generate the header with the kernel "
                                    "linearisation, or give inputs of 0");
      }
    }
  }

  static void check(const std::vector<int>& list, int count) {
    for (const int i : list) {
      if (i < 0 || i >= count) {
        throw std::invalid_argument("coordinate " + std::to_string(i) + " is listed, of " + std::to_string(count) +
                                    " that the mechanism has");
      }
    }
  }

  const typename M::Precomputed& precomputed_;
  const StateProblem<M>& problem_;
  std::vector<int> kept_;         // equations
  std::vector<int> multipliers_;  // unknown ones
};

/// A quaternion and its opposite are one attitude: its largest component is made positive.
template <class M>
void choose_signs([[maybe_unused]] typename M::State& state) {
  if constexpr (HasQuaternions<M>) {
    for (const int first : M::quaternions) {
      int largest = first;
      for (int i = first; i < first + 4; ++i) {
        if (std::abs(state.q[i]) > std::abs(state.q[largest]) + 1e-9) largest = i;
      }
      if (state.q[largest] > 0) continue;
      for (int i = first; i < first + 4; ++i) state.q[i] = -state.q[i];
    }
  }
}

template <class M>
[[nodiscard]] double largest_difference_of_coordinates(const typename M::State& a, const typename M::State& b) {
  double largest = 0.0;
  for (int i = 0; i < M::coordinate_count; ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(a.q[i] - b.q[i])));
  }
  return largest;
}

}  // namespace detail

/// All states of the problem that Newton steps reach from many starts in its box; see `find_roots` for what that means
/// and for the failures. A mechanism with inputs whose kernel `linearisation` is absent is taken without input.
/// Throws std::invalid_argument for bounds or indices that do not fit, and for inputs that would not be looked at.
template <HasStateEquations M>
[[nodiscard]] StateSearch<M> find_states(const typename M::Precomputed& precomputed, const StateProblem<M>& problem) {
  const detail::StateEquations<M> equations(precomputed, problem);
  const Eigen::Index bounded = equations.unknowns() - equations.multipliers();
  if (problem.lower.size() != bounded || problem.upper.size() != bounded) {
    throw std::invalid_argument("the box has " + std::to_string(problem.lower.size()) + " lower and " +
                                std::to_string(problem.upper.size()) + " upper bounds for " + std::to_string(bounded) +
                                " unknown coordinates, velocities and accelerations");
  }
  SearchBox box{problem.lower, problem.upper};
  for (const int angle : problem.angles) {
    for (std::size_t k = 0; k < problem.coordinates.size(); ++k) {
      if (problem.coordinates[k] == angle) box.angles.push_back(static_cast<Eigen::Index>(k));
    }
  }
  const auto values = [&equations](const Eigen::VectorXd& x) { return equations(x); };
  const auto derivative = [&equations](const Eigen::VectorXd& x) { return equations.derivative(x); };
  RootSearch search =
      find_roots({.f = values, .derivative = derivative, .unknowns = equations.unknowns()}, box, problem.options);
  StateSearch<M> result{{}, std::move(search.failures), search.starts};
  for (const FoundRoot& root : search.roots) {
    FoundState<M> state = equations.at(root.x);
    const Eigen::VectorXd forces = equations.forces(state);
    for (int i = 0; i < M::velocity_count; ++i) state.efforts[i] = 0;
    for (const int i : problem.supplied) state.efforts[i] = forces(i);
    state.residual = root.residual;
    state.isolated = root.isolated;
    state.found = root.found;
    if constexpr (HasQuaternions<M>) {
      detail::choose_signs<M>(state.state);
      const auto known = std::find_if(result.found.begin(), result.found.end(), [&](const FoundState<M>& other) {
        return detail::largest_difference_of_coordinates<M>(state.state, other.state) <= 2 * problem.options.merge;
      });
      if (known != result.found.end()) {
        known->found += state.found;
        continue;
      }
    }
    result.found.push_back(state);
  }
  return result;
}

/// A box of coordinates, one pair of bounds each, and which of them count modulo 2π.
struct CoordinateBox {
  Eigen::VectorXd lower, upper;
  std::vector<int> angles{};
};

/// What acts at rest, and when.
template <MechanismModel M>
struct RestConditions {
  typename M::Inputs inputs{};
  double time = 0.0;  ///< [s]
};

/// Equilibria: q and λ with  h(q, v = 0) − Aᵀλ = Q(u),  f(q, t) = 0  (Pommier, §7.4). With a driven joint h at rest
/// holds −∂T0/∂q and these are the relative equilibria, roots of ∂(U + T0)/∂q. A coordinate on which
/// nothing depends makes curves of equilibria, called not isolated: leave it out with `find_states`.
template <HasStateEquations M>
[[nodiscard]] StateSearch<M> find_equilibria(const typename M::Precomputed& precomputed, const CoordinateBox& box,
                                             const RestConditions<M>& at = {}, const RootSearchOptions& options = {}) {
  StateProblem<M> problem;
  problem.state.time = at.time;
  problem.inputs = at.inputs;
  for (int i = 0; i < M::coordinate_count; ++i) problem.coordinates.push_back(i);
  problem.lower = box.lower;
  problem.upper = box.upper;
  problem.angles = box.angles;
  problem.options = options;
  return find_states<M>(precomputed, problem);
}

/// Which coordinates of a steady motion turn, how fast, and what acts.
template <MechanismModel M>
struct SteadyRates {
  typename M::State state{};  ///< the time, the rates of the cyclic coordinates, their values (which do not matter)
  std::vector<int> cyclic{};  ///< indices of those coordinates
  typename M::Inputs inputs{};
};

/// Steady motions: the cyclic coordinates turn at given constant rates, the others rest (Pommier, §7.4). `box` bounds
/// those, in order. Along a cyclic coordinate the equation is not asked to hold: what it leaves over is the effort that
/// keeps the rate, zero when nothing dissipates.
template <HasStateEquations M>
[[nodiscard]] StateSearch<M> find_steady_motions(const typename M::Precomputed& precomputed,
                                                 const SteadyRates<M>& rates, const CoordinateBox& box,
                                                 const RootSearchOptions& options = {}) {
  const std::vector<int>& cyclic = rates.cyclic;
  StateProblem<M> problem;
  problem.state = rates.state;
  problem.inputs = rates.inputs;
  static_assert(M::coordinate_count == M::velocity_count, "with quaternions, say by find_states what is unknown");
  for (int i = 0; i < M::coordinate_count; ++i) {
    if (std::find(cyclic.begin(), cyclic.end(), i) != cyclic.end()) continue;
    problem.coordinates.push_back(i);
    problem.state.v[i] = 0;
  }
  problem.supplied = cyclic;
  problem.lower = box.lower;
  problem.upper = box.upper;
  problem.angles = box.angles;
  problem.options = options;
  return find_states<M>(precomputed, problem);
}

}  // namespace torsor::runtime
