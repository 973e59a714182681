// SPDX-License-Identifier: MIT
#pragma once
#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>

#include <array>
#include <cstddef>

#include "torsor/runtime/sundials/run.hpp"

namespace torsor::runtime {

/// SUNDIALS' ARKODE, explicit Runge-Kutta pairs of its own choice for an order from 2 to 8 (of 8: Fehlberg's 8(7)).
/// Source: Reynolds et al., ARKODE: a flexible IVP solver infrastructure, ACM TOMS 49 (2023).
struct ArkodeExplicit : SundialsMethod<ArkodeExplicit> {
  int order = 5;

  template <class S, std::size_t size>
  class Solver;
};

/// SUNDIALS' ARKODE, diagonally implicit Runge-Kutta of order 2 to 5 with Newton's method and the system's Jacobian,
/// else ARKODE's own differences.
struct ArkodeImplicit : SundialsMethod<ArkodeImplicit> {
  int order = 5;

  template <class S, std::size_t size>
  class Solver;
};

inline constexpr SundialsFunctions erkstep_functions{ERKStepFree,
                                                     ERKStepSetErrFile,
                                                     ERKStepSetUserData,
                                                     ERKStepSStolerances,
                                                     ERKStepSetInitStep,
                                                     ERKStepSetMaxStep,
                                                     ERKStepSetStopTime,
                                                     nullptr,
                                                     ERKStepGetNumErrTestFails,
                                                     nullptr,
                                                     nullptr,
                                                     nullptr};
inline constexpr SundialsFunctions arkstep_functions{ARKStepFree,
                                                     ARKStepSetErrFile,
                                                     ARKStepSetUserData,
                                                     ARKStepSStolerances,
                                                     ARKStepSetInitStep,
                                                     ARKStepSetMaxStep,
                                                     ARKStepSetStopTime,
                                                     ARKStepSetLinearSolver,
                                                     ARKStepGetNumErrTestFails,
                                                     ARKStepGetNumStepSolveFails,
                                                     ARKStepGetNumJacEvals,
                                                     ARKStepGetNumLinSolvSetups};

template <class S, std::size_t size>
class ArkodeExplicit::Solver : public SundialsSolver<S, size> {
  using Base = SundialsSolver<S, size>;
  using typename Base::Work;

 public:
  Solver(const ArkodeExplicit& method, S& system) : Base(erkstep_functions, system), method_(method) {}

  [[nodiscard]] bool create(double t, const std::array<double, size>& y) {
    if (!this->prepare(y, size, false)) return false;
    this->memory = ERKStepCreate(Work::right_hand_side, t, work.y, work.context);
    return this->set_options(method_) && ERKStepSetOrder(this->memory, method_.order) == 0;
  }

  int step(double end, double& t) { return ERKStepEvolve(this->memory, end, work.y, &t, ARK_ONE_STEP); }

  using Base::work;

 private:
  ArkodeExplicit method_;
};

template <class S, std::size_t size>
class ArkodeImplicit::Solver : public SundialsSolver<S, size> {
  using Base = SundialsSolver<S, size>;
  using typename Base::Work;

 public:
  Solver(const ArkodeImplicit& method, S& system) : Base(arkstep_functions, system), method_(method) {}

  [[nodiscard]] bool create(double t, const std::array<double, size>& y) {
    if (!this->prepare(y, size, true)) return false;
    this->memory = ARKStepCreate(nullptr, Work::right_hand_side, t, work.y, work.context);
    if (!this->set_options(method_) || ARKStepSetOrder(this->memory, method_.order) != 0) return false;
    if constexpr (HasJacobian<S, double, size>) return ARKStepSetJacFn(this->memory, Work::jacobian) == 0;
    return true;
  }

  int step(double end, double& t) { return ARKStepEvolve(this->memory, end, work.y, &t, ARK_ONE_STEP); }

  using Base::work;

 private:
  ArkodeImplicit method_;
};

}  // namespace torsor::runtime
