// SPDX-License-Identifier: MIT
#pragma once
#include <cvode/cvode.h>

#include <array>
#include <cstddef>
#include <type_traits>

#include "runtime/sundials/run.hpp"

namespace torsor::runtime {

/// SUNDIALS' CVODE: variable-order, variable-step multistep methods. Adams' (orders 1 to 12, iterated by substitution)
/// for what is not stiff; backward differentiation (orders 1 to 5, Newton's method with the system's Jacobian, else
/// CVODE's own differences) for what is. Used as the project's own methods: `integrate(motion, y, 0, 10, Cvode{...})`.
/// Source: Hindmarsh et al., SUNDIALS, ACM TOMS 31 (2005).
struct Cvode : SundialsOptions {
  enum class Multistep { adams, backward_differentiation };
  Multistep multistep = Multistep::backward_differentiation;

  template <class S, std::size_t size>
  class Solver;

  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const {
    static_assert(std::is_same_v<Scalar, double>, "SUNDIALS integrates in double");
    return SundialsRun<Solver<S, size>, S, size>(system, y, t, *this);
  }
};

template <class S, std::size_t size>
class Cvode::Solver {
 public:
  Solver(const Cvode& method, S& system) : work(system), method_(method) {}
  Solver(const Solver&) = delete;
  Solver& operator=(const Solver&) = delete;
  ~Solver() {
    if (memory_ != nullptr) CVodeFree(&memory_);
  }

  [[nodiscard]] bool create(double t, const std::array<double, size>& y) {
    const bool stiff = method_.multistep == Multistep::backward_differentiation;
    if (!work.create(size, stiff)) return false;
    std::copy(y.begin(), y.end(), N_VGetArrayPointer(work.y));
    memory_ = CVodeCreate(stiff ? CV_BDF : CV_ADAMS, work.context);
    if (memory_ == nullptr) return false;
    CVodeSetErrFile(memory_, nullptr);  // what went wrong is in the result
    bool done = CVodeInit(memory_, Work::right_hand_side, t, work.y) == 0 && CVodeSetUserData(memory_, &work) == 0 &&
                CVodeSStolerances(memory_, method_.relative_tolerance, method_.absolute_tolerance) == 0 &&
                CVodeSetInitStep(memory_, method_.first_step) == 0 &&
                CVodeSetMaxStep(memory_, method_.largest_step) == 0;
    if (stiff) {
      done = done && CVodeSetLinearSolver(memory_, work.linear_solver, work.matrix) == 0;
      if constexpr (HasJacobian<S, double, size>) done = done && CVodeSetJacFn(memory_, Work::jacobian) == 0;
    } else {
      work.nonlinear_solver = SUNNonlinSol_FixedPoint(work.y, 0, work.context);
      done = done && work.nonlinear_solver != nullptr && CVodeSetNonlinearSolver(memory_, work.nonlinear_solver) == 0;
    }
    return done;
  }

  int stop_at(double end) { return CVodeSetStopTime(memory_, end); }
  int step(double end, double& t) { return CVode(memory_, end, work.y, &t, CV_ONE_STEP); }

  void add_statistics(Statistics& statistics) const noexcept {
    long failed = 0, unsolved = 0, jacobians = 0, decompositions = 0;
    CVodeGetNumErrTestFails(memory_, &failed);
    CVodeGetNumStepSolveFails(memory_, &unsolved);
    if (work.matrix != nullptr) {
      CVodeGetNumJacEvals(memory_, &jacobians);
      CVodeGetNumLinSolvSetups(memory_, &decompositions);
    }
    statistics.rejected = failed + unsolved;
    statistics.jacobians = jacobians;
    statistics.decompositions = decompositions;
  }

  using Work = SundialsWorkplace<S, size>;
  Work work;

 private:
  Cvode method_;
  void* memory_ = nullptr;
};

}  // namespace torsor::runtime
