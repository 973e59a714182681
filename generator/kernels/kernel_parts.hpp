// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/geometry/vector.hpp"
#include "torsor/generator/kernels/kernel.hpp"

// What the builders of kernels share.

namespace torsor {

Member vector_member(const std::string& name, std::size_t rows, const Meaning& meaning);
/// A matrix, whatever the number of its columns.
Member matrix_member(const std::string& name, std::size_t rows, std::size_t columns, const Meaning& meaning);

/// Appends a matrix, column by column.
void assign_matrix(Kernel& kernel, const Target& target, const ValueMatrix& matrix, std::size_t columns);
/// Assigns the first n values to a vector of the header.
void assign_vector(Kernel& kernel, const Target& target, const std::vector<Value>& values, std::size_t n);

std::size_t unknowns(const Equations& equations);

/// Whether friction works in proportion to multipliers.
bool has_friction(const Equations& equations);

/// Fills the structure `result` of a kernel; entry 3 k + i of a member is component i of its vector k.
class StructureBuilder {
 public:
  StructureBuilder(std::string name, std::string documentation)
      : structure_{std::move(name), std::move(documentation), {}} {}

  void member(const std::string& name, std::size_t rows, const Meaning& meaning) {
    structure_.members.push_back(vector_member(name, rows, meaning));
  }
  void member(const std::string& name, std::size_t rows, std::size_t columns, const Meaning& meaning) {
    structure_.members.push_back(matrix_member(name, rows, columns, meaning));
  }
  void assign(const std::string& name, std::size_t index, const Value& value) {
    assignments_.push_back({{"result", name, index}, value});
  }
  void vector(const std::string& name, std::size_t k, const Vector& v);
  /// Column by column.
  void matrix(const std::string& name, std::size_t k, const Matrix& m);

  /// The kernel that gives the structure.
  Kernel take(std::string documentation);

 private:
  Structure structure_;
  std::vector<Assignment> assignments_;
};

/// Fills the structure `result` with matrices of derivatives; what has no column is left out.
class SlopesBuilder {
 public:
  SlopesBuilder(std::string structure, std::string documentation)
      : structure_{std::move(structure), std::move(documentation), {}} {}

  void add(const std::string& member, const ValueMatrix& rows, const std::string& text);
  /// The kernel that gives the structure.
  Kernel take(std::string documentation, std::vector<Argument> arguments = {});

 private:
  Structure structure_;
  Kernel kernel_;
};

}  // namespace torsor
