// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"
#include "torsor/generator/verification/evaluated_motion.hpp"
#include "torsor/generator/verification/motion_integrator.hpp"

namespace torsor {

/// What a simulation watches: a formula that passes through zero. "hit: x - l", "x = l", "x".
struct EventRequest {
  std::string text;
  bool ends = false;  ///< the motion ends at its first zero
};

/// An event that was met.
struct MetEvent {
  std::string name;
  double time = 0.0;
  bool ends = false;
  std::unique_ptr<MotionIntegrator> motion;  ///< that stands there
};

/// Watches formulas between the rows of a simulation.
class WatchedEvents {
 public:
  /// Throws UsageError for a formula that cannot be read.
  WatchedEvents(const Scene& scene, EvaluatedMotion& motion, const std::vector<EventRequest>& requests);

  bool empty() const { return watched_.empty(); }
  /// The events after `before` and until `after`, in time. A formula that is zero at the start has its first event when it
  /// is zero again; two zeros between rows are none, and a pole is none. Throws Error where a formula is no number.
  std::vector<MetEvent> between(const MotionIntegrator& before, const MotionIntegrator& after);

 private:
  struct Watched {
    std::string name;
    Value formula;
    bool ends;
  };
  double value(const Watched& watched, const MotionIntegrator& at) const;
  std::optional<MetEvent> located(const Watched& watched, const MotionIntegrator& before, const MotionIntegrator& after) const;

  EvaluatedMotion& motion_;
  std::vector<Watched> watched_;
};

}  // namespace torsor
