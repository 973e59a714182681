// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "torsor/generator/geometry/rotation.hpp"
#include "torsor/generator/geometry/triple.hpp"
#include "torsor/generator/program/identically_zero.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor {

/// Components of a vector along the axes of one frame, inside a program.
class Vector {
 public:
  Vector() = default;
  Vector(Value x, Value y, Value z) : components_{std::move(x), std::move(y), std::move(z)} {}

  const Value& operator[](int i) const { return components_[static_cast<std::size_t>(i)]; }
  Value& operator[](int i) { return components_[static_cast<std::size_t>(i)]; }
  bool is_zero() const { return components_[0].is_zero() && components_[1].is_zero() && components_[2].is_zero(); }

  Vector& operator+=(const Vector& other);
  friend Vector operator+(Vector a, const Vector& b) { return a += b; }
  friend Vector operator-(const Vector& a, const Vector& b);
  friend Vector operator-(const Vector& a);
  friend Vector operator*(const Value& k, const Vector& v);

 private:
  std::array<Value, 3> components_;
};

Value dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
Vector operator*(const Rotation& r, const Vector& v);

Vector lower(Program& program, const Triple& triple);

/// Rates of the components: the derivative of the vector in the frame along whose axes they are given.
Vector time_derivative(const Vector& v);

/// Whether all components vanish identically.
bool identically_zero(const Vector& v);

/// Binds each component; the name gets the suffix ", x" and so on.
Vector bound(Program& program, const Vector& v, const std::string& name = {});

/// A 3 x 3 array of values: a rotation, an inertia operator, or Ω̇ + ΩΩ of a body.
class Matrix {
 public:
  const Value& operator()(int row, int column) const { return entries_[static_cast<std::size_t>(3 * row + column)]; }
  Value& operator()(int row, int column) { return entries_[static_cast<std::size_t>(3 * row + column)]; }
  Matrix& operator+=(const Matrix& other);
  friend Matrix operator+(Matrix a, const Matrix& b) { return a += b; }
  friend Matrix operator-(const Matrix& a, const Matrix& b);
  friend Matrix operator*(const Value& k, const Matrix& m);
  friend Vector operator*(const Matrix& m, const Vector& v);

 private:
  std::array<Value, 9> entries_;
};

Matrix operator*(const Matrix& a, const Matrix& b);
Matrix transpose(const Matrix& m);
Value trace(const Matrix& m);
Matrix identity(Program& program);
Matrix constant_matrix(Program& program, const Rotation& rotation);
Matrix bound(Program& program, const Matrix& m, const std::string& name = {});

}  // namespace torsor
