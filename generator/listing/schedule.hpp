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

/// Distributes the work of several functions: what depends on parameters only is done once, in `precompute`.
struct Schedule {
  Block precompute;
  std::vector<Atom> members;     ///< definitions that functions read from Precomputed
  SumTable results;              ///< results of functions that depend on parameters only: more members of Precomputed
  std::vector<Block> functions;  ///< one for each
};
/// `values` are what each function must compute.
Schedule make_schedule(const Program& program, const std::vector<std::vector<Value>>& values);

/// Everything the sums need, computed in one block.
Block whole_block(const Program& program, const std::vector<Polynomial>& sums);

}  // namespace torsor
