// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace torsor::contact_peers {

/// Processor seconds of a motion, and how far it ends from the truth.
struct Outcome {
  double seconds, error;
};

/// One way to move a problem: a library with its settings.
struct Way {
  std::string who, setting;
  std::function<Outcome()> run;
};

struct Problem {
  std::string name;   ///< what moves, and where its truth comes from
  std::string error;  ///< what is measured, with its unit
  std::vector<Way> ways;
};

class Stopwatch {
 public:
  double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

}  // namespace torsor::contact_peers
