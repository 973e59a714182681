// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/expression/polynomial.hpp"
#include "generator/expression/program.hpp"
#include "generator/expression/sum_table.hpp"

namespace torsor {

/// What one function reads and computes, each in the program's order.
struct Block {
  std::vector<Atom> symbols;      ///< read from its arguments
  std::vector<Atom> given;        ///< computed before: members of Precomputed
  std::vector<Atom> definitions;  ///< computed here; those of the generation stage are literals
};

/// Distributes the work of a function: what depends on parameters only is done once, in `precompute`.
struct Schedule {
  Block precompute;
  std::vector<Atom> members;  ///< definitions that the function reads from Precomputed
  SumTable results;           ///< its results that depend on parameters only: more members of Precomputed
  Block function;
};
/// `values` are what the function must compute.
Schedule make_schedule(const Program& program, const std::vector<Value>& values);

/// Everything the sums need, computed in one block.
Block whole_block(const Program& program, const std::vector<Polynomial>& sums);

}  // namespace torsor
