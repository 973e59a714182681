// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <concepts>
#include <cstddef>
#include <string>
#include <tuple>

#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/midpoint.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/records/reference.hpp"
#include "torsor/runtime/records/table.hpp"
#include "torsor/runtime/status.hpp"

namespace torsor::runtime {

/// Name and setting of a method, as they stand in a table.
struct MethodLabel {
  std::string name, setting;
};
inline MethodLabel label(const Midpoint& method) { return {"midpoint", "h = " + scientific(method.step, 1) + " s"}; }
inline MethodLabel label(const RungeKutta4& method) {
  return {"Runge-Kutta 4", "h = " + scientific(method.step, 1) + " s"};
}
inline MethodLabel label(const DormandPrince54& method) {
  return {"Dormand-Prince 5(4)", "tolerance " + scientific(method.relative_tolerance, 1)};
}
inline MethodLabel label(const DormandPrince853& method) {
  return {"Dormand-Prince 8(5,3)", "tolerance " + scientific(method.relative_tolerance, 1)};
}
inline MethodLabel label(const Taylor& method) {
  return {"Taylor", "tolerance " + scientific(method.relative_tolerance, 1)};
}

/// Integrates a motion (see `equations_of_motion`) from its initial state through the times of a reference by each
/// method, and tabulates what it cost and how far it ended from the truth: the largest absolute error over all times
/// and all components of the state, each in its SI unit. Times are those of one run on this machine.
template <class Motion, std::floating_point Scalar, class... Methods>
[[nodiscard]] Table work_precision(const Motion& motion, const Reference<Scalar>& reference,
                                   const Methods&... methods) {
  Table table({"integrator", "step or tolerance", "largest error", "steps", "evaluations", "time"});
  const auto add = [&](const auto& method) {
    auto y = motion.initial();
    ReferenceErrors<Scalar, std::tuple_size_v<decltype(y)>> errors(reference);
    const auto start = std::chrono::steady_clock::now();
    const Result<Scalar> result = integrate_through(motion, y, motion.initial_time(), reference.times, method, errors);
    const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
    const MethodLabel text = label(method);
    const Statistics& statistics = result.statistics;
    table.add({text.name, text.setting, result ? scientific(errors.largest()) : describe(result),
               std::to_string(statistics.accepted + statistics.rejected), std::to_string(statistics.calls),
               scientific(elapsed.count()) + " ms"});
  };
  (add(methods), ...);
  return table;
}

}  // namespace torsor::runtime
