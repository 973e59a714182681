// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>

#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Multiplies small values out, so that what cancels identically does so before anything is rounded: with A, C and
/// sin, cos of one angle, (A + (C − A) cos²) − C cos² becomes A sin². Computed as it stands, that difference has lost
/// all digits where sin is small, and the quotients by it with them.
///
/// Products are put back wherever they stand, sums so many levels deep (1, 2, 3, then all); what has more than `limit`
/// terms stays as it is. Every answer equals what it stands for, by sin² + cos² = 1.
class Flattening {
 public:
  explicit Flattening(Program& program, std::size_t limit = 12) : program_(&program), limit_(limit) {}

  /// For the elimination of a matrix: beyond twenty rows nothing is multiplied out, for the entries of such a matrix
  /// are too long, and trying each of n³/6 takes seconds.
  static Flattening of_matrix(Program& program, std::size_t rows) {
    return rows <= 20 ? Flattening(program) : Flattening(program, 0);
  }

  Program& program() const { return *program_; }

  /// The value as one flat sum in symbols, functions of them and quotients, in the shortest of its forms; nothing when
  /// more terms arise than the limit.
  std::optional<Value> operator()(const Value& value);

  /// a − b c: flat where that takes about as many operations and leaves no more terms than a has; the cheapest form.
  Value difference(const Value& a, const Value& b, const Value& c);

  /// The value, flat where that takes no more operations than its own formula; the cheapest of these.
  Value cheaper(const Value& value);

 private:
  static constexpr std::size_t all_levels = 4;

  std::optional<Polynomial> flat(const Polynomial& polynomial, std::size_t levels);
  const std::optional<Polynomial>& flat_definition(ValueNumber value_number, std::size_t levels);
  /// A power of one value number put back into a product: what it becomes, or that it stays, or that it is too long.
  enum class Power { put_back, stays, too_long };
  Power multiply_power(Polynomial& part, const Factor& factor, std::size_t levels);
  std::optional<Polynomial> product(const Polynomial& a, const Polynomial& b) const;
  std::optional<Polynomial> replaced(const Polynomial& polynomial, ValueNumber square_of, ValueNumber by) const;
  Polynomial shortest(Polynomial polynomial) const;
  bool mixed_signs(const Polynomial& polynomial) const;
  int operations(const Value& value) const;

  Program* program_;
  std::size_t limit_;
  std::array<std::unordered_map<ValueNumber, std::optional<Polynomial>>, all_levels + 1> known_;  ///< by levels; looked up only
};

/// The value with the sums that it adds put back, where terms of theirs cancel identically and no more are left than it
/// had: (a + b) + (c − b) becomes a + c. Computed as it stands, b would take digits of a and c with it.
Value cancelled(const Program& program, const Value& value);

}  // namespace torsor
