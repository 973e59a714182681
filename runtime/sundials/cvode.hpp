// SPDX-License-Identifier: MIT
#pragma once
#include <cvode/cvode.h>

#include <array>
#include <cstddef>

#include "torsor/runtime/sundials/run.hpp"

namespace torsor::runtime {

/// SUNDIALS' CVODE: variable-order, variable-step multistep methods. Adams' (orders 1 to 12, iterated by substitution)
/// for what is not stiff; backward differentiation (orders 1 to 5, Newton's method with the system's Jacobian, else
/// CVODE's own differences) for what is. Used as the project's own methods: `integrate(motion, y, 0, 10, Cvode{...})`.
/// Source: Hindmarsh et al., SUNDIALS, ACM TOMS 31 (2005).
struct Cvode : SundialsMethod<Cvode> {
  enum class Multistep { adams, backward_differentiation };
  Multistep multistep = Multistep::backward_differentiation;

  template <class S, std::size_t size>
  class Solver;
};

inline constexpr SundialsFunctions cvode_functions{CVodeFree,
                                                   CVodeSetErrFile,
                                                   CVodeSetUserData,
                                                   CVodeSStolerances,
                                                   CVodeSetInitStep,
                                                   CVodeSetMaxStep,
                                                   CVodeSetStopTime,
                                                   CVodeSetLinearSolver,
                                                   CVodeGetNumErrTestFails,
                                                   CVodeGetNumStepSolveFails,
                                                   CVodeGetNumJacEvals,
                                                   CVodeGetNumLinSolvSetups};

template <class S, std::size_t size>
class Cvode::Solver : public SundialsSolver<S, size> {
  using Base = SundialsSolver<S, size>;
  using typename Base::Work;

 public:
  Solver(const Cvode& method, S& system) : Base(cvode_functions, system), method_(method) {}

  [[nodiscard]] bool create(double t, const std::array<double, size>& y) {
    const bool stiff = method_.multistep == Multistep::backward_differentiation;
    if (!this->prepare(y, size, stiff)) return false;
    this->memory = CVodeCreate(stiff ? CV_BDF : CV_ADAMS, work.context);
    if (this->memory == nullptr || CVodeInit(this->memory, Work::right_hand_side, t, work.y) != 0) return false;
    if (!this->set_options(method_)) return false;
    if (stiff) {
      if constexpr (HasJacobian<S, double, size>) return CVodeSetJacFn(this->memory, Work::jacobian) == 0;
      return true;
    }
    work.nonlinear_solver = SUNNonlinSol_FixedPoint(work.y, 0, work.context);
    return work.nonlinear_solver != nullptr && CVodeSetNonlinearSolver(this->memory, work.nonlinear_solver) == 0;
  }

  int step(double end, double& t) { return CVode(this->memory, end, work.y, &t, CV_ONE_STEP); }

  using Base::work;

 private:
  Cvode method_;
};

}  // namespace torsor::runtime
