// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "generator/emission/kernel.hpp"
#include "generator/expression/polynomial.hpp"
#include "generator/expression/program.hpp"
#include "generator/expression/sum_table.hpp"

namespace torsor {

/// What one function of a header reads and computes, each in the program's order.
struct Block {
  std::vector<Atom> symbols;      ///< read from its arguments
  std::vector<Atom> given;        ///< computed before: members of Precomputed
  std::vector<Atom> definitions;  ///< computed here; those of the generation stage are literals
};

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
