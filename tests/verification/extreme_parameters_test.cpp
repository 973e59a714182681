// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels, as headers compute them, at mass ratios to 10^±12, lengths from 1e-6 m to 1e6 m and nearly parallel axes.
// TORSOR_LONG_TESTS: twenty times as many states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/long_tests.hpp"
#include "torsor/generator/program/evaluation.hpp"
#include "torsor/generator/verification/ball.hpp"
#include "torsor/generator/verification/condition.hpp"
#include "torsor/generator/verification/verify.hpp"
#include "tests/scenes/at_run_time.hpp"
#include "tests/scenes/pendulums.hpp"

namespace torsor::extreme_parameters_test {
namespace {

using namespace testing_mechanisms;

constexpr const char* kernels =
    "kinematics,mass_matrix,bias,inverse_dynamics,forward_dynamics,energy,constraints,linearisation,"
    "inverse_dynamics_derivatives,forward_dynamics_derivatives,jets";

int states_of(int states) { return wanted(states, 20 * states); }

/// 10^power, with all bits.
double decade(std::mt19937_64& random, int power) {
  return std::pow(10.0, power) * (1.0 + static_cast<double>(random() >> 11U) * 0x1p-54);
}

/// An ordinary or a stressed state with rates to 2^±6. By turns masses, lengths and both are of any size, and the axes
/// nearly parallel beside masses of any size: for `angle`, a parameter or a coordinate, down to 1e-12.
StressState extreme_state(const Scene& scene, const KernelAccuracy& accuracy, Precision precision, int number,
                          const std::string& angle) {
  StateFormat format = precision == Precision::in_double ? double_states : float_states;
  format.large = 6;
  const auto seed = static_cast<std::uint64_t>(number);
  StressState state(scene, accuracy.symbols(), seed, format);
  std::mt19937_64 random(seed + 77);
  const int turn = number % 4;
  for (const SymbolPointer& symbol : accuracy.symbols()) {
    const int step = static_cast<int>((random() >> 11U) % 5) - 2;
    const double fraction = decade(random, -static_cast<int>((random() >> 11U) % 13));
    if (symbol->name == angle && turn >= 2) state = state.with(angle, fraction);
    if (symbol->kind != SymbolKind::parameter) continue;
    if (symbol->name[0] == 'm' && turn != 1) state = state.with(symbol->name, decade(random, 6 * step));
    if (symbol->name[0] == 'l' && turn != 0 && turn != 3) state = state.with(symbol->name, decade(random, 3 * step));
  }
  return state;
}

/// ‖r‖ of what accelerations and multipliers miss M a + h = E u + Aᵀ λ by, in the metric of the diagonal of M and
/// relative to its terms, exactly: what of M and h would have to be changed for them to be right.
class BackwardError {
 public:
  BackwardError(const Scene& scene, const ModelOptions& options)
      : equations_(scene, options), exact_(equations_.program(), {}) {}

  double operator()(const StressState& state, const std::vector<double>& solution) {
    exact_.move_to([&state](const SymbolPointer& symbol) {
      if (symbol->kind == SymbolKind::pi) return Real::pi();
      const auto& known = state.symbols();
      const auto place = std::find_if(known.begin(), known.end(), [&](const auto& s) { return s->name == symbol->name; });
      return place == known.end() ? Real(0) : Real::from_double(state.value(*place));
    });
    const std::size_t n = equations_.mass().size();
    const auto& inputs = equations_.model().inputs();
    double missed = 0, size = 0, of_solution = 0;
    std::vector<double> root(n);
    for (std::size_t i = 0; i < n; ++i) {
      root[i] = std::sqrt(exact_(equations_.mass()[i][i]).to_double());
      of_solution += root[i] * std::abs(solution[i]);
    }
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<Real> terms{exact_(equations_.bias()[i])};
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        terms.push_back(-(exact_(equations_.actions().inputs[k][i]) * exact_(equations_.program().symbol(inputs[k]))));
      }
      for (std::size_t j = 0; j < equations_.constraints().size(); ++j) {
        terms.push_back(-(exact_(equations_.constraints()[j].column[i]) * Real::from_double(solution[n + j])));
      }
      Real sum(0);
      double sizes = 0;
      for (const Real& term : terms) sum += term, sizes += abs(term).to_double();
      for (std::size_t j = 0; j < n; ++j) sum += exact_(equations_.mass()[i][j]) * Real::from_double(solution[j]);
      missed = std::max(missed, abs(sum).to_double() / root[i]);
      size = std::max(size, sizes / root[i]);
    }
    return missed == 0 ? 0 : missed / (size + of_solution);
  }
  /// Condition of the matrix at that state where there are constraints.
  double growth() { return equations_.constraints().empty() ? 1 : motion_condition(equations_, exact_); }

 private:
  Equations equations_;
  Evaluator<Real> exact_;
};

constexpr double unit_of(Precision precision) { return precision == Precision::in_double ? 0x1p-52 : 0x1p-23; }

struct Mechanism {
  Scene scene;
  ModelOptions options;
  const char* angle;
  const char* kernels;
};

/// A kernel's number among those of the mechanism.
std::size_t number_of(const KernelAccuracy& accuracy, const std::string& name) {
  const auto& all = accuracy.kernels();
  const auto place = std::find_if(all.begin(), all.end(), [&name](const OwnKernel& each) { return each.kernel.name == name; });
  return static_cast<std::size_t>(place - all.begin());
}

class ExtremeParameters {
 public:
  ExtremeParameters(const Mechanism& mechanism, Precision precision)
      : mechanism_(mechanism),
        precision_(precision),
        accuracy_(kernel_accuracy(mechanism.scene, mechanism.options, parse_kernel_list(mechanism.kernels), precision)),
        missed_(mechanism.scene, mechanism.options),
        forward_(number_of(*accuracy_, "forward_dynamics")),
        worst_(accuracy_->groups().size()) {}

  void run(int states) {
    for (int number = 0; number < states; ++number) {
      const StressState state = extreme_state(mechanism_.scene, *accuracy_, precision_, number, mechanism_.angle);
      SCOPED_TRACE(state.to_string(state.symbols()));
      accuracy_->move_to(state);
      at(state);
    }
    // A pivot of multipliers below 2^12 roundings of those of its unit is singular: in float 5e-4, which more of these
    // masses and lengths go below.
    EXPECT_GE((precision_ == Precision::in_double ? 2 : 3) * solved_, states) << "statuses that are ok";
    certify();
  }

 private:
  void at(const StressState& state) {
    bool ok = true;
    for (std::size_t g = 0; g < worst_.size(); ++g) {
      const OutputGroup& group = accuracy_->groups()[g];
      const Accuracy found = accuracy_->estimate(g);
      EXPECT_FALSE(found.undefined) << name(g);  // no number, and nothing says so
      if (group.kernel == forward_ && !found.counted && !found.identically_zero) ok = false;
      if (!found.counted) continue;
      // `long double` errs by 2^-11 of what double does.
      EXPECT_LE(found.error, found.bound * 1.001) << name(g);
      if (accuracy_->kernels()[group.kernel].kernel.pivots.empty() && !cancels(g)) {
        EXPECT_LE(found.scaled, accuracy_bar) << name(g);
      }
      if (!worst_[g] || found.scaled > worst_[g]->first) worst_[g].emplace(found.scaled, state);
    }
    if (!ok) return;
    ++solved_;
    // Backward stable whatever the condition (Higham 10.1): some roundings for each unknown. With constraints the free
    // accelerations are such a solution, and what the constraints take from them as large as the condition.
    const WorkingDigits precision(60);
    const std::vector<double> solution = accuracy_->computed(forward_);
    const double allowed = accuracy_bar * static_cast<double>(solution.size()) * unit_of(precision_);
    const double missed = missed_(state, solution);
    EXPECT_LE(missed, allowed * missed_.growth()) << "forward_dynamics";
  }

  /// Coriolis terms of joints whose axes are parallel cancel identically, and nearly where they nearly are
  /// (docs/accuracy.md): held to the running bound alone.
  bool cancels(std::size_t g) const {
    return mechanism_.scene.name() == "extreme_chain" &&
           name(g) == "inverse_dynamics_derivatives result.by_velocity [kg m^2 s^-1]";
  }

  /// The worst of each group against CLN, and in balls.
  void certify() {
    for (std::size_t g = 0; g < worst_.size(); ++g) {
      if (!worst_[g]) continue;
      accuracy_->move_to(worst_[g]->second);
      const Accuracy sure = accuracy_->certify(g, 40);
      EXPECT_TRUE(sure.counted || sure.identically_zero) << name(g);
      EXPECT_LE(sure.error, sure.bound) << name(g);
      if (sure.counted) {
        EXPECT_EQ(sure.enclosed, Ball::available()) << name(g);
      }
    }
  }

  std::string name(std::size_t g) const {
    const OutputGroup& group = accuracy_->groups()[g];
    return accuracy_->kernels()[group.kernel].kernel.name + " " + group.name;
  }

  const Mechanism& mechanism_;
  Precision precision_;
  std::unique_ptr<KernelAccuracy> accuracy_;
  BackwardError missed_;
  std::size_t forward_;
  std::vector<std::optional<std::pair<double, StressState>>> worst_;  ///< by group: scaled error, where
  int solved_ = 0;
};

void expect_within_bounds(const Mechanism& mechanism, int states) {
  for (const Precision precision : {Precision::in_double, Precision::in_float}) {
    SCOPED_TRACE(precision == Precision::in_double ? "double" : "float");
    ExtremeParameters(mechanism, precision).run(states_of(states));
  }
}

ModelOptions by(ForwardMethod method) { return {.forward = method}; }

TEST(ExtremeParameters, OfADoublePendulumWithJets) {
  expect_within_bounds({double_pendulum({.second = Angle::of_the_joint, .at_run_time = true}), {}, "", kernels}, 24);
}

// A force along an absolute angle is the difference of the moments in two joints.
TEST(ExtremeParameters, OfADoublePendulumWithAbsoluteAngles) {
  expect_within_bounds({double_pendulum({.at_run_time = true}), {}, "", kernels}, 24);
}

TEST(ExtremeParameters, OfAGimbalNearItsLock) { expect_within_bounds({extreme_gimbal(), {}, "q2", kernels}, 24); }

TEST(ExtremeParameters, OfAFourBar) { expect_within_bounds({extreme_four_bar(), {}, "", kernels}, 24); }

TEST(ExtremeParameters, OfAChainByFactorisation) {
  expect_within_bounds({extreme_chain(3), by(ForwardMethod::factorisation), "tilt", kernels}, 24);
}

TEST(ExtremeParameters, OfAChainByArticulatedBodies) {
  expect_within_bounds({extreme_chain(3), by(ForwardMethod::articulated_body), "tilt",
                        "forward_dynamics,forward_dynamics_derivatives"},
                       24);
}

// A body on massless rings: M loses its rank like sin² q2.
TEST(NearlySingularMass, IsReportedOrSolvedAsWellAsItCanBe) {
  const Scene scene = extreme_gimbal();
  for (const Precision precision : {Precision::in_double, Precision::in_float}) {
    const auto accuracy = kernel_accuracy(scene, {}, {"forward_dynamics", "forward_dynamics_derivatives"}, precision);
    BackwardError missed(scene, {});
    bool refused = false;
    for (int power = 0; power <= 16; ++power) {
      StressState state(scene, accuracy->symbols(), 8, precision == Precision::in_double ? double_states : float_states);
      state = state.with("m1", 0).with("q2", power == 16 ? 0 : std::pow(10.0, -power));
      accuracy->move_to(state);
      const std::vector<double> solution = accuracy->computed(0);
      const Accuracy accelerations = accuracy->estimate(0), derivatives = accuracy->estimate(1);
      const bool ok = accelerations.counted || accelerations.identically_zero;
      EXPECT_FALSE(accelerations.undefined || derivatives.undefined);
      EXPECT_FALSE(refused && ok) << "solved at 1e-" << power << ", nearer than where it was refused";
      refused = refused || !ok;
      if (!ok) continue;
      const WorkingDigits digits(60);
      EXPECT_LE(missed(state, solution), accuracy_bar * 3 * unit_of(precision)) << power;
      EXPECT_LE(accelerations.error, accelerations.bound * 1.001) << power;
    }
    EXPECT_TRUE(refused);
  }
}

}  // namespace
}  // namespace torsor::extreme_parameters_test
