// SPDX-License-Identifier: MIT
#pragma once
#include <Eigen/Core>
#include <functional>
#include <string_view>
#include <vector>

#include "torsor/runtime/library.hpp"

namespace torsor::runtime {

using VectorFunction = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;
using MatrixFunction = std::function<Eigen::MatrixXd(const Eigen::VectorXd&)>;

/// Equations f(x) = 0.
struct RootEquations {
  VectorFunction f;           ///< at least as many values as there are unknowns
  MatrixFunction derivative;  ///< its Jacobian
  Eigen::Index unknowns = 0;  ///< how many
};

/// Where roots are looked for: lower(i) <= x(i) <= upper(i). Unknowns that the box does not reach, the last ones, enter
/// linearly (multipliers): they have no bounds and start from zero.
struct SearchBox {
  Eigen::VectorXd lower, upper;
  std::vector<Eigen::Index> angles{};  ///< unknowns that count modulo 2π; found ones lie in [lower, lower + 2π)
};

struct RootSearchOptions {
  int starts = 200;
  int iterations = 100;
  /// A root's equations are satisfied to this part of their size over the box.
  double tolerance = 1e-12;
  /// Roots closer than this part of the box are one.
  double merge = 1e-6;
  /// The same where the derivative is singular: such a root is known to the square or cube root of rounding only.
  double degenerate_merge = 1e-3;
};

struct FoundRoot {
  Eigen::VectorXd x;
  double residual = 0.0;  ///< largest equation left over, relative to its size over the box
  bool isolated = true;   ///< the derivative has full rank; if not, a root of a curve of roots or a multiple one
  int found = 1;          ///< starts that came here
};

/// Why a start led to no root of the box.
enum class StartFailure { stalled, too_many_iterations, left_box, not_finite };

[[nodiscard]] constexpr std::string_view describe(StartFailure failure) noexcept {
  switch (failure) {
    case StartFailure::stalled:
      return "the equations have a smallest value here that is not zero";
    case StartFailure::too_many_iterations:
      return "no root was reached; allow more iterations";
    case StartFailure::left_box:
      return "the root lies outside the box";
    case StartFailure::not_finite:
      return "the equations have a value that is not finite here";
  }
  return "unknown failure";
}

struct FailedStart {
  StartFailure reason = StartFailure::stalled;
  Eigen::VectorXd start, end;
  double residual = 0.0;
};

struct RootSearch {
  std::vector<FoundRoot> roots;  ///< by increasing first unknown, then second, ...
  std::vector<FailedStart> failures;
  int starts = 0;
};

/// The roots of f(x) = 0 that damped Newton steps reach from many starts spread evenly over a box, duplicates merged.
/// More values than unknowns are solved by least squares, and a root must satisfy all. Steps come from a rank-revealing
/// decomposition, so that singular derivatives are no end: a root on a curve of roots or a multiple one is found and
/// called not isolated. No search by starts can promise that no root is missed; the failures say where the others went.
/// Throws std::invalid_argument for a box that is none.
[[nodiscard]] RootSearch find_roots(const RootEquations& equations, const SearchBox& box,
                                    const RootSearchOptions& options = {});

/// The Jacobian of f by central differences over steps of (rounding)^(1/3) times the width of the box, or times 1 for
/// unknowns without bounds: right to some ten digits where f is smooth over such steps.
[[nodiscard]] Eigen::MatrixXd central_differences(const VectorFunction& f, const Eigen::VectorXd& x,
                                                  const Eigen::VectorXd& widths);

}  // namespace torsor::runtime
