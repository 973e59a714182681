// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/sum_table.hpp"

namespace torsor {

std::pair<Polynomial, bool> without_sign(const Polynomial& polynomial) {
  if (polynomial.sign() >= 0) return {polynomial, false};
  Polynomial positive = polynomial;
  positive *= Number(-1);
  return {std::move(positive), true};
}

std::optional<std::size_t> SumTable::find(const Polynomial& sum) const {
  const auto bucket = by_hash_.find(sum.hash());
  if (bucket == by_hash_.end()) return std::nullopt;
  for (const std::size_t place : bucket->second) {
    if (sums_[place] == sum) return place;
  }
  return std::nullopt;
}

std::pair<std::size_t, bool> SumTable::add(const Polynomial& sum) {
  if (const std::optional<std::size_t> known = find(sum)) return {*known, false};
  by_hash_[sum.hash()].push_back(sums_.size());
  sums_.push_back(sum);
  return {sums_.size() - 1, true};
}

}  // namespace torsor
