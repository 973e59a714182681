// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Cycles from operands to result, about those of today's processors (Zen 2 to 4, Skylake to Golden Cove: Fog,
/// Instruction tables); a product that is added at once is fused with the sum.
struct Latency {
  static constexpr int addition = 3;
  static constexpr int multiplication = 3;
  static constexpr int fused = 4;
  static constexpr int division = 13;
  static constexpr int square_root = 18;
  static constexpr int sine_cosine = 45;
  static constexpr int other = 60;
};

/// When results of a program are there, in cycles after all symbols are, with as many units as it takes.
///
/// Definitions may be appended to the program meanwhile.
class EarliestStarts {
 public:
  explicit EarliestStarts(const Program& program) : program_(&program) {}

  /// Of a definition from its sum as it stands, nothing taken out.
  int operator()(ValueNumber value_number) const;
  int operator()(const Formula& formula) const;

  /// Calls for each value number that a formula reads, with the cycles from there to the formula's result; a value number that stands
  /// in it several times is told several times.
  void for_each_delay(const Formula& formula, const std::function<void(ValueNumber, int)>& call) const;

  /// The terms of all sums in the order in which they are known where that makes a sum known earlier, as they stand
  /// elsewhere. A term that is no product comes before two products, with which both are fused, unless the sum waits
  /// for it: one instruction less for eight cycles. The first term is not subtracted where another is not.
  Formula in_order(Formula formula) const;

  /// The right-hand side as it is emitted: in this order, unless the program has no pass `scheduling`.
  Formula scheduled(const Polynomial& sum) const;
  Formula scheduled(const Definition& definition) const;

 private:
  int of(const Definition& definition) const;

  const Program* program_;
  mutable std::vector<int> known_;  ///< by value number
};

}  // namespace torsor
