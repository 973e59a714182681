// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace torsor {

/// A motion y' = f(t, y) in `double` by Dormand and Prince's method of order 8 with steps that a tolerance chooses, for
/// states whose size is known when the program runs. Source: Hairer-Norsett-Wanner I, II.5, II.10 (10.17).
class DormandPrince853 {
 public:
  /// dy/dt; false where there is none.
  using Slope = std::function<bool(double t, const std::vector<double>& y, std::vector<double>& rates)>;
  /// Puts what a step has reached onto its constraints; false where it cannot. May be empty.
  using Settle = std::function<bool(double t, std::vector<double>& y)>;

  /// Errors of a step stay below tolerance · (1 + |y_i|).
  DormandPrince853(Slope slope, Settle settle, std::vector<double> y, double tolerance);

  /// Goes on to the time `end` exactly. False, with a status, where the motion cannot: it then stands at `time()`.
  bool advance(double end);

  double time() const { return t_; }
  const std::vector<double>& state() const { return y_; }
  const std::string& status() const { return status_; }  ///< empty while the motion goes on
  long steps() const { return steps_; }

 private:
  bool fail(std::string status);
  double attempt(double h);  ///< the weighted error; not a number where there is no slope
  double first_step(double span) const;

  Slope slope_;
  Settle settle_;
  double t_ = 0.0, h_ = 0.0, tolerance_;
  std::vector<double> y_, trial_, next_;
  std::array<std::vector<double>, 12> slopes_;
  std::string status_;
  long steps_ = 0;
};

}  // namespace torsor
