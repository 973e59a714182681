// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/kernels/kernel.hpp"

// What the builders of kernels share.

namespace torsor {

Member matrix_member(const std::string& name, std::size_t rows, std::size_t columns, const std::string& text);

/// Appends a matrix, column by column.
void assign_matrix(Kernel& kernel, const Target& target, const ValueMatrix& matrix, std::size_t columns);
/// Assigns the first n values to a vector of the header.
void assign_vector(Kernel& kernel, const Target& target, const std::vector<Value>& values, std::size_t n);

std::size_t unknowns(const Equations& equations);

}  // namespace torsor
