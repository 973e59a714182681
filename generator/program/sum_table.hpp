// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "torsor/generator/program/polynomial.hpp"

namespace torsor {

/// The polynomial with a positive leading coefficient; whether its sign was changed.
std::pair<Polynomial, bool> without_sign(const Polynomial& polynomial);

/// Positive sums of a program, found again by value; numbered in order of first use.
class SumTable {
 public:
  std::optional<std::size_t> find(const Polynomial& sum) const;
  /// Number of the sum and whether it is new.
  std::pair<std::size_t, bool> add(const Polynomial& sum);
  const std::vector<Polynomial>& sums() const { return sums_; }

 private:
  std::vector<Polynomial> sums_;
  std::unordered_map<std::size_t, std::vector<std::size_t>> by_hash_;  ///< looked up only
};

}  // namespace torsor
