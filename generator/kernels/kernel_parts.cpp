// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/kernels/kernel_parts.hpp"

namespace torsor {

void assign_matrix(Kernel& kernel, const Target& target, const ValueMatrix& matrix, std::size_t columns) {
  for (std::size_t j = 0; j < columns; ++j) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      kernel.assignments.push_back({target[j * matrix.size() + i], matrix[i][j]});
    }
  }
}

Member vector_member(const std::string& name, std::size_t rows, const Meaning& meaning) {
  return {name, static_cast<int>(rows), 1, meaning, Shape::vector};
}

Member matrix_member(const std::string& name, std::size_t rows, std::size_t columns, const Meaning& meaning) {
  return {name, static_cast<int>(rows), static_cast<int>(columns), meaning, Shape::matrix};
}

void assign_vector(Kernel& kernel, const Target& target, const std::vector<Value>& values, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) kernel.assignments.push_back({target[i], values[i]});
}

std::size_t unknowns(const Equations& equations) {
  return static_cast<std::size_t>(equations.model().unknown_count());
}

bool has_friction(const Equations& equations) { return !equations.scene().content().frictions.empty(); }

void StructureBuilder::vector(const std::string& name, std::size_t k, const Vector& v) {
  for (int i = 0; i < 3; ++i) assign(name, 3 * k + static_cast<std::size_t>(i), v[i]);
}

void StructureBuilder::matrix(const std::string& name, std::size_t k, const Matrix& m) {
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) assign(name, 9 * k + static_cast<std::size_t>(3 * j + i), m(i, j));
  }
}

Kernel StructureBuilder::take(std::string documentation) {
  Kernel kernel;
  kernel.documentation = std::move(documentation);
  kernel.results = {{structure_.name, "result"}};
  kernel.structures = {std::move(structure_)};
  kernel.assignments = std::move(assignments_);
  return kernel;
}

void SlopesBuilder::add(const std::string& member, const ValueMatrix& rows, const std::string& text) {
  const std::size_t columns = rows.empty() ? 0 : rows[0].size();
  if (columns == 0) return;
  structure_.members.push_back(matrix_member(member, rows.size(), columns, text));
  assign_matrix(kernel_, {"result", member}, rows, columns);
}

Kernel SlopesBuilder::take(std::string documentation, std::vector<Argument> arguments) {
  kernel_.documentation = std::move(documentation);
  kernel_.arguments = std::move(arguments);
  kernel_.results = {{structure_.name, "result"}};
  kernel_.structures = {std::move(structure_)};
  return std::move(kernel_);
}

}  // namespace torsor
