// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/verification/stress_state.hpp"

namespace torsor {

/// Taylor coefficients of the kernel `jets` are looked at up to this order.
inline constexpr int jet_orders = 4;

/// Results of one kernel that share a name and a unit: they have a common norm.
struct OutputGroup {
  std::size_t kernel = 0;  ///< index of the kernel
  std::string name;        ///< of the result, e.g. "accelerations [rad/s^2]"
  std::vector<std::size_t> members;  ///< indices of assignments; of Taylor coefficients order by order, from order 1
};

/// How well a group of results is computed at one state, y the exact results at the very same numbers, ŷ the computed
/// ones, Euclid's norm, x_j every input, coordinate, rate and parameter, plain numbers of the scene included:
///   error     = ‖ŷ - y‖ / ulp(‖y‖)
///   condition = Σ_j ‖x_j ∂y/∂x_j‖ / ‖y‖
///   scaled    = error / max(1, condition)
struct Accuracy {
  bool counted = false;    ///< false: the kernel reports this state as singular or not finite, or there is no result
  bool undefined = false;  ///< not counted: there is no result (0/0), and the kernel has no status to say so
  /// Not counted either: ‖y‖ and all that inputs move it by are zero here, or less than a thousandth of what rounding
  /// may leave of the terms that cancel. There is no ulp to measure by; the error is within its bound.
  bool identically_zero = false;
  double error = 0;       ///< [ulp]
  double condition = 0;
  double scaled = 0;      ///< [ulp]
  double bound = 0;       ///< of the error, by running error analysis [ulp]
  bool enclosed = false;  ///< ball arithmetic proves that the error is no larger (but for a thousandth)
  double potential = 0;   ///< of `scaled`: bound / max(1, condition)
};

/// The kernels of a scene as the header computes them in `Float`, beside their exact results.
class KernelAccuracy {
 public:
  virtual ~KernelAccuracy() = default;

  virtual const std::vector<OwnKernel>& kernels() const = 0;
  virtual const std::vector<OutputGroup>& groups() const = 0;
  /// What a group depends on.
  virtual const std::vector<SymbolPointer>& symbols(std::size_t group) const = 0;
  /// What all groups depend on.
  virtual const std::vector<SymbolPointer>& symbols() const = 0;

  /// Moves to a state; measures there against `long double`: that has 11 bits more than double, so that errors come out
  /// right to some thousandths.
  virtual void move_to(const StressState& state) = 0;
  virtual Accuracy estimate(std::size_t group) = 0;
  /// What the header gives for each assignment of a kernel, or for the coefficients of orders 1 to jet_orders.
  virtual std::vector<double> computed(std::size_t kernel) = 0;
  /// Against CLN, with that many digits and as many more as the error still depends on; then against balls that surely
  /// contain the exact results, where torsor was built with Arb.
  virtual Accuracy certify(std::size_t group, int digits) = 0;
};

enum class Precision { in_double, in_float };

/// Of those of the named kernels that the scene has. Conditions count parameters that the header has as numbers too.
std::unique_ptr<KernelAccuracy> kernel_accuracy(const Scene& scene, const ModelOptions& options,
                                                const std::vector<std::string>& kernels, Precision precision);

}  // namespace torsor
