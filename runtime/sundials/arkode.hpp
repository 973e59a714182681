// SPDX-License-Identifier: MIT
#pragma once
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include <array>
#include <cstddef>
#include <type_traits>

#include "runtime/sundials/run.hpp"

namespace torsor::runtime {

/// SUNDIALS' ARKODE, explicit Runge-Kutta pairs of its own choice for an order from 2 to 8 (of 8: Fehlberg's 8(7)).
/// Source: Reynolds et al., ARKODE: a flexible IVP solver infrastructure, ACM TOMS 49 (2023).
struct ArkodeExplicit : SundialsOptions {
  int order = 5;

  template <class S, std::size_t size>
  class Solver;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const {
    static_assert(std::is_same_v<Scalar, double>, "SUNDIALS integrates in double");
    return SundialsRun<Solver<S, size>, S, size>(system, y, t, *this);
  }
};

template <class S, std::size_t size>
class ArkodeExplicit::Solver {
 public:
  Solver(const ArkodeExplicit& method, S& system) : work(system), method_(method) {}
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    if (memory_ != nullptr) ERKStepFree(&memory_);
  }

  [[nodiscard]] bool create(double t, const std::array<double, size>& y) {
    if (!work.create(size, false)) return false;
    std::copy(y.begin(), y.end(), N_VGetArrayPointer(work.y));
    memory_ = ERKStepCreate(Work::right_hand_side, t, work.y, work.context);
    if (memory_ == nullptr) return false;
    ERKStepSetErrFile(memory_, nullptr);
    return ERKStepSetUserData(memory_, &work) == 0 && ERKStepSetOrder(memory_, method_.order) == 0 &&
           ERKStepSStolerances(memory_, method_.relative_tolerance, method_.absolute_tolerance) == 0 &&
           ERKStepSetInitStep(memory_, method_.first_step) == 0 &&
           ERKStepSetMaxStep(memory_, method_.largest_step) == 0;
  }

  int stop_at(double end) { return ERKStepSetStopTime(memory_, end); }
  int step(double end, double& t) { return ERKStepEvolve(memory_, end, work.y, &t, ARK_ONE_STEP); }

  void add_statistics(Statistics& statistics) const noexcept {
    long failed = 0;
    ERKStepGetNumErrTestFails(memory_, &failed);
    statistics.rejected = failed;
  }

  using Work = SundialsWorkplace<S, size>;
  Work work;

 private:
  ArkodeExplicit method_;
  void* memory_ = nullptr;
};

/// SUNDIALS' ARKODE, diagonally implicit Runge-Kutta of order 2 to 5 with Newton's method and the system's Jacobian,
/// else ARKODE's own differences.
struct ArkodeImplicit : SundialsOptions {
  int order = 5;

  template <class S, std::size_t size>
  class Solver;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const {
    static_assert(std::is_same_v<Scalar, double>, "SUNDIALS integrates in double");
    return SundialsRun<Solver<S, size>, S, size>(system, y, t, *this);
  }
};

template <class S, std::size_t size>
class ArkodeImplicit::Solver {
 public:
  Solver(const ArkodeImplicit& method, S& system) : work(system), method_(method) {}
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    if (memory_ != nullptr) ARKStepFree(&memory_);
  }

  [[nodiscard]] bool create(double t, const std::array<double, size>& y) {
    if (!work.create(size, true)) return false;
    std::copy(y.begin(), y.end(), N_VGetArrayPointer(work.y));
    memory_ = ARKStepCreate(nullptr, Work::right_hand_side, t, work.y, work.context);
    if (memory_ == nullptr) return false;
    ARKStepSetErrFile(memory_, nullptr);
    bool done = ARKStepSetUserData(memory_, &work) == 0 && ARKStepSetOrder(memory_, method_.order) == 0 &&
                ARKStepSStolerances(memory_, method_.relative_tolerance, method_.absolute_tolerance) == 0 &&
                ARKStepSetInitStep(memory_, method_.first_step) == 0 &&
                ARKStepSetMaxStep(memory_, method_.largest_step) == 0 &&
                ARKStepSetLinearSolver(memory_, work.linear_solver, work.matrix) == 0;
    if constexpr (HasJacobian<S, double, size>) done = done && ARKStepSetJacFn(memory_, Work::jacobian) == 0;
    return done;
  }

  int stop_at(double end) { return ARKStepSetStopTime(memory_, end); }
  int step(double end, double& t) { return ARKStepEvolve(memory_, end, work.y, &t, ARK_ONE_STEP); }

  void add_statistics(Statistics& statistics) const noexcept {
    long failed = 0, unsolved = 0, jacobians = 0, decompositions = 0;
    ARKStepGetNumErrTestFails(memory_, &failed);
    ARKStepGetNumStepSolveFails(memory_, &unsolved);
    ARKStepGetNumJacEvals(memory_, &jacobians);
    ARKStepGetNumLinSolvSetups(memory_, &decompositions);
    statistics.rejected = failed + unsolved;
    statistics.jacobians = jacobians;
    statistics.decompositions = decompositions;
  }

  using Work = SundialsWorkplace<S, size>;
  Work work;

 private:
  ArkodeImplicit method_;
  void* memory_ = nullptr;
};

}  // namespace torsor::runtime
