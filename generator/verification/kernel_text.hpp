// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "torsor/generator/emission/mechanism_listing.hpp"
#include "torsor/generator/listing/listing_evaluator.hpp"
#include "torsor/generator/program/series_evaluation.hpp"

namespace torsor {

/// Taylor coefficients of the orders 0 to `order`, by order, of what the program says.
template <class Scalar>
std::vector<std::vector<Scalar>> taylor_coefficients(const SeriesResult& series, Evaluator<Scalar>& here, int order) {
  SeriesEvaluation<Scalar> evaluation(series.program, series.state, here);
  if (const auto& solve = series.solve) {
    evaluation.solve_for(solve->unknowns, solve->start, solve->lower, solve->inverse_pivots);
  }
  return evaluation(order);
}

/// Those of the orders from 1, one order after the other.
template <class Scalar>
std::vector<Scalar> from_order_one(const std::vector<std::vector<Scalar>>& by_order) {
  std::vector<Scalar> all;
  for (std::size_t k = 1; k < by_order.size(); ++k) all.insert(all.end(), by_order[k].begin(), by_order[k].end());
  return all;
}

/// A kernel as it is emitted, and what its text gives at one state after the other.
template <class Scalar>
class KernelText {
 public:
  using SymbolValue = std::function<Scalar(const SymbolPointer&)>;

  /// Of a kernel with equations of its own; of a series the coefficients of the orders from 1 to `order`.
  KernelText(const Scene& scene, const ModelOptions& options, const OwnKernel& own, const NumbersOf<Scalar>& numbers,
             int order = 1)
      : time_(scene.time().as_symbol()),
        layout_(layout_of(*own.equations, run_time_parameters(scene, options))),
        kernel_(std::make_unique<const LoweredKernel>(lower_kernel(own.equations->program(), own.kernel, layout_))),
        once_(kernel_->once, numbers),
        compute_(kernel_->listing, numbers),
        order_(order) {}

  void move_to(SymbolValue value) {
    value_ = std::move(value);
    results_.clear();
  }

  /// In the order of the kernel's assignments.
  const std::vector<Scalar>& results() {
    if (!results_.empty()) return results_;
    const auto argument = [this](Table table, std::size_t place) {
      return value_(table == Table::time ? time_ : layout_.of(table)[place]);
    };
    once_(argument);
    compute_([&](Table table, std::size_t place) {
      return table == Table::precomputed ? once_.outputs()[place] : argument(table, place);
    }, order_);
    results_ = kernel_->listing.recurrence ? from_order_one(compute_.coefficients()) : compute_.outputs();
    return results_;
  }

  /// Whether each pivot stands out of the rounding of what it is measured against, as traits::regular of a header.
  template <class Regular>
  bool is_regular(const Regular& regular) {
    results();
    const auto& pivots = compute_.pivots();
    return std::all_of(pivots.begin(), pivots.end(), [&](const auto& each) { return regular(each.first, each.second); });
  }

 private:
  SymbolPointer time_;
  Layout layout_;
  std::unique_ptr<const LoweredKernel> kernel_;
  ListingEvaluator<Scalar> once_, compute_;
  int order_;
  SymbolValue value_;
  std::vector<Scalar> results_;  ///< none: not yet computed at this state
};

}  // namespace torsor
