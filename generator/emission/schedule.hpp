// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "generator/emission/kernel.hpp"
#include "generator/expression/polynomial.hpp"
#include "generator/expression/program.hpp"

namespace torsor {

/// What one function of a header reads and computes, each in the program's order.
struct Block {
  std::vector<Atom> symbols;      ///< read from its arguments
  std::vector<Atom> given;        ///< computed before: members of Precomputed
  std::vector<Atom> definitions;  ///< computed here; those of the generation stage are literals
};

/// Positive sums of a program, found again by value; numbered in order of arrival.
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

/// The polynomial with a positive leading coefficient; whether its sign was changed.
std::pair<Polynomial, bool> without_sign(const Polynomial& polynomial);

/// Distributes the work of several kernels: what depends on parameters only is done once, in `precompute`.
struct Schedule {
  Block precompute;
  std::vector<Atom> members;   ///< definitions that kernels read from Precomputed
  SumTable results;            ///< results of kernels that depend on parameters only: more members of Precomputed
  std::vector<Block> kernels;  ///< one for each
};
Schedule make_schedule(const Program& program, const std::vector<Kernel>& kernels);

/// Everything the sums need, computed in one block.
Block whole_block(const Program& program, const std::vector<Polynomial>& sums);

}  // namespace torsor
