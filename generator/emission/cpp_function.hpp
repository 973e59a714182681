// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emission/kernel.hpp"
#include "generator/listing/lowering.hpp"

namespace torsor {

/// A function of a header, and the operations it states.
struct FunctionText {
  std::string body;
  OperationCount operations;
};

/// What functions of one header have in common.
struct HeaderParts {
  Program* program = nullptr;
  const Schedule* schedule = nullptr;
  Layout layout;
  std::vector<Structure> structures;
  std::vector<std::string> members{};  ///< of Precomputed, behind the parameters
};

/// A kernel as a listing. Throws Error when it reads a symbol that it is not given.
Listing lower_kernel(const HeaderParts& parts, const Kernel& kernel, const Block& block);

/// The whole function of a kernel with its documentation.
FunctionText cpp_function(const HeaderParts& parts, const Kernel& kernel, const Block& block);

}  // namespace torsor
