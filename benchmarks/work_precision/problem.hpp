// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "torsor/runtime/status.hpp"

namespace work_precision {

/// What one run with one setting gave.
struct Outcome {
  bool reached = false;  ///< the end, as the integrator says
  double error = 0.0;    ///< largest absolute one over all components, at the end
  double energy = 0.0;   ///< |change of energy| as a part of the problem's scale
  torsor::runtime::Statistics statistics{};
};

/// One integrator on one problem.
struct Way {
  std::string library;  ///< torsor, Boost.odeint, SUNDIALS
  std::string name;
  bool fixed_step = false;
  std::vector<double> settings;  ///< tolerances, relative and absolute alike, or steps in s; the cheapest first
  std::function<Outcome(double setting)> run;

  [[nodiscard]] std::string label() const { return library == "torsor" ? name : library + " " + name; }
};

/// A motion whose state at the end is known to more digits than a double has.
struct Problem {
  std::string name, text;
  std::vector<Way> ways;
};

Problem double_pendulum_mild();
Problem double_pendulum_easy();
Problem double_pendulum_hard();
Problem top();
Problem hoop();
Problem chain5();
Problem ur5();
Problem governor();
Problem elastic_pendulum();
Problem stiffer_pendulum();
Problem squeezer();
Problem bouncing();
Problem resting();
Problem sliding();

}  // namespace work_precision
