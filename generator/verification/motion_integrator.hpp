// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace torsor {

/// A motion y' = f(t, y) in `double` from t = 0 on, for states whose size is known when the program runs.
class MotionIntegrator {
 public:
  /// dy/dt; false where there is none.
  using Slope = std::function<bool(double t, const std::vector<double>& y, std::vector<double>& rates)>;
  /// Puts what a step has reached onto its constraints; false where it cannot. May be empty.
  using Settle = std::function<bool(double t, std::vector<double>& y)>;

  virtual ~MotionIntegrator() = default;

  /// Goes on to the time `end` exactly. False, with a status, where the motion cannot: it then stands at `time()`.
  virtual bool advance(double end) = 0;
  virtual std::unique_ptr<MotionIntegrator> copy() const = 0;

  double time() const { return t_; }
  const std::vector<double>& state() const { return y_; }
  const std::string& status() const { return status_; }  ///< empty while the motion goes on
  const std::string& because() const { return because_; }  ///< what may be the cause, and what to do; empty where not known
  long steps() const { return steps_; }
  /// How long the motion is to be: see `creeps`. Not told, it may take any number of steps.
  void expect(double duration) { duration_ = duration; }

 protected:
  MotionIntegrator(Slope slope, Settle settle, std::vector<double> y)
      : slope_(std::move(slope)), settle_(std::move(settle)), y_(std::move(y)) {}
  MotionIntegrator(const MotionIntegrator&) = default;
  MotionIntegrator& operator=(const MotionIntegrator&) = default;

  /// What differs by less are times that rounding does not tell apart, and no step: some roundings of the later one. Motions
  /// begin at 0, and may be as short as those of atoms.
  double shortest_step(double end) const { return 1e-14 * std::max(std::abs(t_), std::abs(end)); }

  bool fail(std::string status) {
    status_ = std::move(status);
    return false;
  }

  /// Puts the end of a step onto its constraints. What that moved over the most that it may, 100 tolerances: 1 and less is
  /// allowed; not a number where it could not. Roundings of the largest number of the state are no correction. A constraint that
  /// follows a law of time is left by whatever that law did within the step, and no other estimate sees it.
  double settled(double reached, std::vector<double>& next, double tolerance) const {
    if (!settle_) return 0.0;
    constexpr double most = 100.0, roundings = 4096.0;
    const std::vector<double> before = next;
    if (!settle_(reached, next)) return std::numeric_limits<double>::quiet_NaN();
    double largest = 0.0, sum = 0.0;
    for (const double number : before) largest = std::max(largest, std::abs(number));
    const double least = roundings * std::numeric_limits<double>::epsilon() * largest;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const double magnitude = std::max({std::abs(y_[i]), std::abs(before[i]), std::abs(next[i])});
      const double share = (next[i] - before[i]) / std::max(most * tolerance * (1.0 + magnitude), least);
      sum += share * share;
    }
    return std::sqrt(sum / static_cast<double>(next.size()));
  }
  bool fail_settling() {
    because_ =
        ": the projection of each step moves it farther than its error does. Either a law of time in a constraint jumps here, "
        "for which the motion has no impulse: give a smooth one, or make a motion that ends before and one from there on. Or the "
        "constraints nearly lose rank here, as at a change point of a closed loop, which this command does not pass";
    return fail("the steps have become too short");
  }

  /// Whether steps have been this short so long that the end is out of reach: many kept ones in a row below 1e-8 of the
  /// motion in which slopes hardly change y, `bend` = h |change of the slope| in units of the error that a step may have.
  ///
  /// A step of a smooth motion is as long as its error allows, so that it bends by far more. Below that only stability
  /// keeps steps short: of a slope that jumps, or of one that changes as fast. A start, an impact or a fast vibration of
  /// any length bends.
  bool creeps(double h, double bend) {
    constexpr double tiny = 1e-8, little = 100.0;
    constexpr int patience = 20'000;
    creeping_ = h < tiny * duration_ && bend < little ? creeping_ + 1 : 0;
    return creeping_ > patience;
  }
  bool fail_creeping() {
    because_ =
        ": the right-hand side jumps here, or is as stiff as if it did. A sign or a condition that stands for dry friction or a contact "
        "is to be said as one, dry_friction(...) or contact(...), which are moved from event to event; any other is to be made smooth. "
        "A stiff motion asks for --method radau";
    return fail("steps stay below 1e-8 of the motion");
  }

  Slope slope_;
  Settle settle_;
  double t_ = 0.0;
  std::vector<double> y_;
  std::string status_, because_;
  long steps_ = 0;

 private:
  double duration_ = 0.0;
  int creeping_ = 0;
};

}  // namespace torsor
