// SPDX-License-Identifier: MIT
#pragma once
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_types.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <type_traits>

#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/numerics/jacobian.hpp"
#include "torsor/runtime/status.hpp"
#include "torsor/runtime/system.hpp"

namespace torsor::runtime {

/// What all of SUNDIALS' integrators are told; as for the project's own methods.
struct SundialsOptions {
  double relative_tolerance = 1e-9;
  double absolute_tolerance = 1e-12;     ///< in the units of the state, the same for every component
  double first_step = 0.0;               ///< 0: chosen by the integrator
  double largest_step = 0.0;             ///< 0: no limit
  std::int64_t step_limit = 10'000'000;  ///< in all
};

/// What a C function of SUNDIALS is given back of us, and the objects that SUNDIALS holds for one integration.
template <class S, std::size_t size>
struct SundialsWorkplace {
  explicit SundialsWorkplace(S& system) noexcept : f(system) {}
  SundialsWorkplace(const SundialsWorkplace&) = delete;
  SundialsWorkplace& operator=(const SundialsWorkplace&) = delete;
  ~SundialsWorkplace() {
    if (nonlinear_solver != nullptr) SUNNonlinSolFree(nonlinear_solver);
    if (linear_solver != nullptr) SUNLinSolFree(linear_solver);
    if (matrix != nullptr) SUNMatDestroy(matrix);
    if (y != nullptr) N_VDestroy(y);
    if (context != nullptr) SUNContext_Free(&context);
  }

  /// The vector of `count` unknowns and, where asked for, dense linear algebra of that size.
  [[nodiscard]] bool create(std::size_t count, bool linear_algebra) noexcept {
    const auto n = static_cast<sunindextype>(count);
    if (SUNContext_Create(nullptr, &context) != 0) return false;
    y = N_VNew_Serial(n, context);
    if (y == nullptr || !linear_algebra) return y != nullptr;
    matrix = SUNDenseMatrix(n, n, context);
    linear_solver = matrix == nullptr ? nullptr : SUNLinSol_Dense(y, matrix, context);
    return linear_solver != nullptr;
  }

  static std::array<double, size> read(N_Vector vector) noexcept {
    std::array<double, size> y;
    std::copy_n(N_VGetArrayPointer(vector), size, y.begin());
    return y;
  }

  /// y' for SUNDIALS: 0, or 1 where the model cannot be evaluated, upon which a shorter step is tried.
  static int right_hand_side(realtype t, N_Vector y, N_Vector dydt, void* user) {
    auto& here = *static_cast<SundialsWorkplace*>(user);
    const std::array<double, size> at = read(y);
    std::array<double, size> slope;
    if (!here.f(t, at, slope)) return here.refuse();
    std::copy(slope.begin(), slope.end(), N_VGetArrayPointer(dydt));
    return 0;
  }

  int refuse() noexcept {
    refusal = f.evaluation;
    return 1;
  }

  static int jacobian(realtype t, N_Vector y, N_Vector, SUNMatrix J, void* user, N_Vector, N_Vector, N_Vector) {
    if constexpr (HasJacobian<S, double, size>) {
      auto& here = *static_cast<SundialsWorkplace*>(user);
      JacobianMatrix<double, size> values;
      here.f.evaluation = to_evaluation(here.f.system().jacobian(t, read(y), values));
      if (here.f.evaluation != Evaluation::ok) return here.refuse();
      std::copy(values.begin(), values.end(), SUNDenseMatrix_Data(J));
      return 0;
    } else {
      return -1;
    }
  }

  CheckedSystem<S, double, size> f;
  Evaluation refusal = Evaluation::ok;  ///< the last one since the step began
  SUNContext context = nullptr;
  N_Vector y = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear_solver = nullptr;
  SUNNonlinearSolver nonlinear_solver = nullptr;
};

/// What CVODE, ARKODE and IDA have in common under different names; null where a package has none of it. See their
/// documentation for each.
struct SundialsFunctions {
  void (*free)(void**);
  int (*set_error_file)(void*, FILE*);
  int (*set_user_data)(void*, void*);
  int (*set_tolerances)(void*, realtype relative, realtype absolute);
  int (*set_first_step)(void*, realtype);
  int (*set_largest_step)(void*, realtype);
  int (*set_stop_time)(void*, realtype);
  int (*set_linear_solver)(void*, SUNLinearSolver, SUNMatrix);
  int (*count_failed_tests)(void*, long*);
  int (*count_failed_solutions)(void*, long*);
  int (*count_jacobians)(void*, long*);
  int (*count_decompositions)(void*, long*);
};

/// What the solvers of all packages do alike: memory, options, statistics. A solver makes its `memory` in create(t, y)
/// between `prepare` and `set_options`, and takes a step.
template <class S, std::size_t size>
class SundialsSolver {
 public:
  using Work = SundialsWorkplace<S, size>;

  SundialsSolver(const SundialsFunctions& functions, S& system) : work(system), functions_(functions) {}
  SundialsSolver(const SundialsSolver&) = delete;
  SundialsSolver& operator=(const SundialsSolver&) = delete;
  ~SundialsSolver() {
    if (memory != nullptr) functions_.free(&memory);
  }

  /// Goes from a time to `end`; the first time it becomes known which way the first step goes.
  int stop_at(double from, double end) {
    const int flag = first_step_ != 0 ? functions_.set_first_step(memory, std::copysign(first_step_, end - from)) : 0;
    first_step_ = 0;
    return flag != 0 ? flag : functions_.set_stop_time(memory, end);
  }

  void add_statistics(Statistics& statistics) const noexcept {
    const auto counted = [this](int (*count)(void*, long*)) {
      long number = 0;
      if (count != nullptr) count(memory, &number);
      return number;
    };
    statistics.rejected = counted(functions_.count_failed_tests) + counted(functions_.count_failed_solutions);
    if (work.matrix == nullptr) return;
    statistics.jacobians = counted(functions_.count_jacobians);
    statistics.decompositions = counted(functions_.count_decompositions);
  }

  Work work;

 protected:
  /// The unknowns, those beyond y not yet written, and dense linear algebra where asked for.
  [[nodiscard]] bool prepare(const std::array<double, size>& y, std::size_t unknowns, bool linear_algebra) {
    if (!work.create(unknowns, linear_algebra)) return false;
    std::copy(y.begin(), y.end(), N_VGetArrayPointer(work.y));
    return true;
  }

  template <class Options>
  [[nodiscard]] bool set_options(const Options& options) {
    if (memory == nullptr || !(options.first_step >= 0)) return false;
    first_step_ = options.first_step;
    functions_.set_error_file(memory, nullptr);  // what went wrong is in the result
    return functions_.set_user_data(memory, &work) == 0 &&
           functions_.set_tolerances(memory, options.relative_tolerance, options.absolute_tolerance) == 0 &&
           functions_.set_largest_step(memory, options.largest_step) == 0 &&
           (work.matrix == nullptr || functions_.set_linear_solver(memory, work.linear_solver, work.matrix) == 0);
  }

  void* memory = nullptr;

 private:
  SundialsFunctions functions_;
  double first_step_ = 0;  ///< until its direction is known
};

/// One integration by SUNDIALS, of the same shape as those of the project's own methods. `Solver` is built from the
/// method and the system and has create(t, y), stop_at(from, to), step(end, t), add_statistics(statistics) and `work`, a
/// SundialsWorkplace.
/// SUNDIALS allocates, and a system's `project` is applied to the states handed out only.
template <class Solver, class S, std::size_t size>
class SundialsRun {
 public:
  using Vector = std::array<double, size>;

  template <class Method>
  SundialsRun(S& system, Vector& y, double t, const Method& method) : y_(y), options_(method), solver_(method, system) {
    result_.time = t;
  }

  template <class Observer>
  void advance(double end, Observer& observer) {
    if (result_.status != IntegrationStatus::reached_end) return;
    if (!std::isfinite(end) || !std::isfinite(result_.time) || !all_finite(y_)) {
      return fail(IntegrationStatus::invalid_options);
    }
    if (end == result_.time) return;
    if (!created_ && !create()) return;
    if (solver_.stop_at(result_.time, end) != 0) return fail(IntegrationStatus::invalid_options);
    while (result_.time != end) {
      if (result_.statistics.accepted >= options_.step_limit) return fail(IntegrationStatus::too_many_steps);
      double t = result_.time;
      solver_.work.refusal = Evaluation::ok;
      const int flag = solver_.step(end, t);
      if (flag < 0) return fail(meaning(flag));
      // SUNDIALS would creep up to a place where the model ends for as many steps as it is given.
      if (t != end && !(std::abs(t - result_.time) > smallest_step(t))) return fail(IntegrationStatus::step_too_small);
      y_ = solver_.work.read(solver_.work.y);
      result_.time = t;
      if (!solver_.work.f.settle(t, y_)) {
        result_.evaluation = solver_.work.f.evaluation;
        return fail(IntegrationStatus::model_failure);
      }
      ++result_.statistics.accepted;
      if (!notify(observer, t, y_)) return stop();
    }
  }

  void stop() noexcept { result_.status = IntegrationStatus::stopped_by_observer; }

  [[nodiscard]] Result<double> result() const noexcept {
    Result<double> result = result_;
    if (created_) solver_.add_statistics(result.statistics);
    result.statistics.calls = solver_.work.f.calls;
    return result;
  }

 private:
  bool create() {
    const bool options = options_.relative_tolerance >= 0.0 && options_.absolute_tolerance >= 0.0 &&
                         options_.relative_tolerance + options_.absolute_tolerance > 0.0 && options_.step_limit > 0 &&
                         options_.first_step >= 0.0 && options_.largest_step >= 0.0;
    // The start is tried beforehand, so that a model which fails there is told from a bad option.
    Vector slope;
    if (options && !solver_.work.f(result_.time, y_, slope)) {
      solver_.work.refuse();
      fail(IntegrationStatus::model_failure);
      return false;
    }
    created_ = options && solver_.create(result_.time, y_);
    if (!created_) fail(IntegrationStatus::invalid_options);
    return created_;
  }

  // The codes below 0 of CVODE, ARKODE and IDA mean the same as far as they matter here.
  static IntegrationStatus meaning(int flag) noexcept {
    if (flag == -1) return IntegrationStatus::too_many_steps;
    if (flag >= -3) return IntegrationStatus::step_too_small;
    if (flag >= -7) return IntegrationStatus::no_convergence;
    if (flag >= -12) return IntegrationStatus::model_failure;
    return IntegrationStatus::invalid_options;
  }

  static double smallest_step(double t) noexcept { return 10.0 * std::numeric_limits<double>::epsilon() * std::abs(t); }

  void fail(IntegrationStatus status) noexcept {
    const Evaluation refusal = solver_.work.refusal;
    const bool by_model = status == IntegrationStatus::step_too_small && refusal != Evaluation::ok;
    result_.status = by_model ? IntegrationStatus::model_failure : status;
    if (result_.status == IntegrationStatus::model_failure) result_.evaluation = refusal;
  }

  Vector& y_;
  SundialsOptions options_;
  Solver solver_;
  bool created_ = false;
  Result<double> result_;
};

/// A method of SUNDIALS is a value with options and a class template `Solver<S, size>`.
template <class Method>
struct SundialsMethod : SundialsOptions {
  template <class S, class Scalar, std::size_t size>
  [[nodiscard]] auto start(S& system, std::array<Scalar, size>& y, Scalar t) const {
    static_assert(std::is_same_v<Scalar, double>, "SUNDIALS integrates in double");
    return SundialsRun<typename Method::template Solver<S, size>, S, size>(system, y, t,
                                                                           static_cast<const Method&>(*this));
  }
};

}  // namespace torsor::runtime
