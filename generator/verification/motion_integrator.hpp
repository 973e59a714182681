// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
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
  long steps() const { return steps_; }

 protected:
  MotionIntegrator(Slope slope, Settle settle, std::vector<double> y)
      : slope_(std::move(slope)), settle_(std::move(settle)), y_(std::move(y)) {}
  MotionIntegrator(const MotionIntegrator&) = default;
  MotionIntegrator& operator=(const MotionIntegrator&) = default;

  bool fail(std::string status) {
    status_ = std::move(status);
    return false;
  }

  Slope slope_;
  Settle settle_;
  double t_ = 0.0;
  std::vector<double> y_;
  std::string status_;
  long steps_ = 0;
};

}  // namespace torsor
