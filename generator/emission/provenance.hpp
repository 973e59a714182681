// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/formula.hpp"

namespace torsor {

/// Operations that the text of one function states, and their number before any were saved.
struct FunctionOperations {
  std::string name;
  OperationCount after;
  std::optional<int> before;  ///< none for what exists only because some were saved
};

/// A kernel that was asked for, and what the mechanism made unnecessary of it.
struct AskedKernel {
  std::string name;
  std::string skipped;  ///< not empty: why it is absent
  std::size_t results = 0, zeros = 0, repeated = 0;
};

/// What the head comment of a generated header tells about it.
struct Provenance {
  const Scene* scene = nullptr;
  ModelOptions options;
  std::vector<AskedKernel> kernels;                                ///< all that were asked for, skipped ones included
  std::vector<SymbolPointer> parameters;                           ///< set at run time
  std::vector<FunctionOperations> operations;                      ///< of each function of the text
  std::vector<std::string> notes{};                                ///< on the constraints, a sentence each
  std::string frames{};                                            ///< what links have other frames than the scene's for
  std::string language{};                                          ///< as --language has it; empty for C++
  std::string extension = "hpp";                                   ///< of the file
  std::string support{};                                           ///< the file it includes, where there is one
  std::string source{};                                            ///< the file written with it, where there is one
};

/// The head comment: scene, version, licence, kernels, operations, what was skipped and why, how to regenerate. No
/// date, no path: the same bytes each time.
std::string provenance_comment(const Provenance& provenance);

/// The command that writes the header again, e.g. "hoop_scene generate --kernels bias --output hoop.hpp".
std::string regeneration_command(const Provenance& provenance);

}  // namespace torsor
