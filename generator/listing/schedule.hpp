// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/program/polynomial.hpp"
#include "torsor/generator/program/program.hpp"
#include "torsor/generator/program/sum_table.hpp"

namespace torsor {

/// What one function reads and computes, each in the program's order.
struct Block {
  std::vector<ValueNumber> symbols;      ///< read from its arguments
  std::vector<ValueNumber> given;        ///< computed before: members of Precomputed
  std::vector<ValueNumber> definitions;  ///< computed here; those of the generation stage are literals
};

/// Distributes the work of a function: what depends on parameters only is done once, in `precompute`.
struct Schedule {
  Block precompute;
  std::vector<ValueNumber> members;  ///< definitions that the function reads from Precomputed
  SumTable results;           ///< its results that depend on parameters only: more members of Precomputed
  Block function;
};
/// `values` are what the function must compute.
Schedule make_schedule(const Program& program, const std::vector<Value>& values);

/// Everything the sums need, computed in one block.
Block whole_block(const Program& program, const std::vector<Polynomial>& sums);

}  // namespace torsor
