// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace torsor::runtime {

/// What one evaluation of a model says. The values agree with those of the `Status` a generated header declares
/// (larger is worse); the runtime has its own type because it includes no generated header.
enum class Evaluation : int { ok = 0, singular = 1, not_finite = 2 };

/// Any enumeration whose value 0 means "fine" may be returned by a model.
template <class Enumeration>
[[nodiscard]] constexpr Evaluation to_evaluation(Enumeration status) noexcept {
  const int value = static_cast<int>(status);
  return value == 0 ? Evaluation::ok : value == 1 ? Evaluation::singular : Evaluation::not_finite;
}

/// Why an integration ended.
enum class IntegrationStatus : int {
  reached_end = 0,
  stopped_by_observer,
  invalid_options,
  step_too_small,
  too_many_steps,
  model_failure,
  no_convergence,    ///< of the equations that an implicit method solves at each step
  unsuitable_model,  ///< the method asks for a structure that the model does not have
};

/// What an integration cost: evaluations of the model, steps kept, steps tried and thrown away; of implicit methods the
/// Jacobians (whose evaluations by differences count as calls too) and the matrices decomposed.
struct Statistics {
  std::int64_t calls = 0;
  std::int64_t accepted = 0;
  std::int64_t rejected = 0;
  std::int64_t jacobians = 0;
  std::int64_t decompositions = 0;

  constexpr Statistics& operator+=(const Statistics& more) noexcept {
    calls += more.calls;
    accepted += more.accepted;
    rejected += more.rejected;
    jacobians += more.jacobians;
    decompositions += more.decompositions;
    return *this;
  }
};

/// The end of an integration. Unless the status is `reached_end`, the state is that of the last good step, at `time`.
template <class Scalar>
struct Result {
  IntegrationStatus status = IntegrationStatus::reached_end;
  Evaluation evaluation = Evaluation::ok;  ///< what the model said, for `model_failure`, or near a step too small
  Scalar time = Scalar(0);                 ///< the time of the state that was left in y
  Statistics statistics;

  [[nodiscard]] explicit constexpr operator bool() const noexcept { return status == IntegrationStatus::reached_end; }
};

[[nodiscard]] constexpr std::string_view describe(Evaluation evaluation) noexcept {
  switch (evaluation) {
    case Evaluation::ok:
      return "the model was evaluated";
    case Evaluation::singular:
      return "the model is singular: the mass matrix or the constraints lose rank (a change point, where branches of a "
             "closed loop meet; angles at the singular position of their chart; a freedom without mass; see "
             "docs/constraints.md)";
    case Evaluation::not_finite:
      return "the model gives a value that is not finite";
  }
  return "unknown evaluation status";
}

/// The status in words, with what to do about it.
[[nodiscard]] constexpr std::string_view describe(IntegrationStatus status) noexcept {
  switch (status) {
    case IntegrationStatus::reached_end:
      return "reached the end time";
    case IntegrationStatus::stopped_by_observer:
      return "stopped because the observer returned false";
    case IntegrationStatus::invalid_options:
      return "unusable options: times and the state at the start must be finite, a fixed step positive, tolerances not "
             "negative, not both zero, "
             "and a relative tolerance at least four roundings of the scalar";
    case IntegrationStatus::step_too_small:
      return "the step fell below the resolution of time: loosen the tolerances, look for a discontinuity, or take an "
             "implicit method where a mode is fast";
    case IntegrationStatus::too_many_steps:
      return "the step limit was met: raise it or loosen the tolerances";
    case IntegrationStatus::model_failure:
      return "the model could not be evaluated";
    case IntegrationStatus::no_convergence:
      return "the equations of an implicit step did not converge: reduce the step, or choose Newton's method for them";
    case IntegrationStatus::unsuitable_model:
      return "the model lacks the structure that the method asks for (see the method's documentation)";
  }
  return "unknown integration status";
}

/// One line for a person: what happened, when, and after how many steps.
template <class Scalar>
[[nodiscard]] std::string describe(const Result<Scalar>& result) {
  std::string text(describe(result.status));
  if (result.status == IntegrationStatus::model_failure) text.append(": ").append(describe(result.evaluation));
  // Its last trials met a model that fails, although the shortest did not.
  if (result.status == IntegrationStatus::step_too_small && result.evaluation != Evaluation::ok) {
    text.append("; nearby ").append(describe(result.evaluation));
  }
  text.append(", at time ").append(std::to_string(result.time));
  text.append(" after ").append(std::to_string(result.statistics.accepted)).append(" steps");
  return text;
}

}  // namespace torsor::runtime
