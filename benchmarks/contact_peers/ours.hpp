// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "benchmarks/contact_peers/problem.hpp"
#include "torsor/runtime/contacts/integrate_contacts.hpp"
#include "torsor/runtime/contacts/moreau_jean.hpp"

namespace torsor::contact_peers {

inline std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// From event to event at a tolerance. A motion that ends early has an error without end.
template <class System, class Error>
Way with_events(const System& system, double end, double tolerance, const Error& error) {
  return {"torsor", "events, tolerance " + number("%.0e", tolerance), [&system, end, tolerance, error]() -> Outcome {
            auto y = system.initial();
            const Stopwatch watch;
            const auto result = runtime::integrate_contacts(
                system, y, 0, end,
                runtime::DormandPrince853{.relative_tolerance = tolerance, .absolute_tolerance = tolerance});
            const double seconds = watch.seconds();
            return {seconds, result.status == runtime::ContactStatus::reached_end ? error(y) : INFINITY};
          }};
}

/// By Moreau and Jean's steps of equal length.
template <class System, class Error>
Way with_steps(const System& system, double end, double step, const Error& error) {
  return {"torsor", "steps of " + number("%.0e s", step), [&system, end, step, error]() -> Outcome {
            auto y = system.initial();
            const Stopwatch watch;
            const auto status = runtime::step_contacts(system, y, 0, end, {.count = std::lround(end / step)});
            const double seconds = watch.seconds();
            return {seconds, status == runtime::ContactStatus::reached_end ? error(y) : INFINITY};
          }};
}

}  // namespace torsor::contact_peers
