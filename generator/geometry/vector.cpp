// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/geometry/vector.hpp"

#include "torsor/generator/program/derivative.hpp"
#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {
constexpr const char* suffix[3] = {", x", ", y", ", z"};
}

Vector& Vector::operator+=(const Vector& other) {
  for (int i = 0; i < 3; ++i) (*this)[i] += other[i];
  return *this;
}
Vector operator-(const Vector& a) { return {-a[0], -a[1], -a[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(const Value& k, const Vector& v) {
  Vector product;
  for (int i = 0; i < 3; ++i) product[i] = k * v[i];  // one by one: a product may create definitions
  return product;
}

Value dot(const Vector& a, const Vector& b) {
  Value sum;
  for (int i = 0; i < 3; ++i) sum += a[i] * b[i];
  return sum;
}

Vector cross(const Vector& a, const Vector& b) {
  Vector product;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    product[i] = a[j] * b[k];
    product[i] -= a[k] * b[j];
  }
  return product;
}

Vector operator*(const Rotation& r, const Vector& v) {
  Vector product;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!r(i, j).is_zero()) product[i] += r(i, j) * v[j];
    }
  }
  return product;
}

Vector lower(Program& program, const Triple& triple) {
  Vector v;
  for (int i = 0; i < 3; ++i) v[i] = program.lower(triple[static_cast<std::size_t>(i)]);
  return v;
}

Vector time_derivative(const Vector& v) {
  Vector rates;
  for (int i = 0; i < 3; ++i) {
    if (!v[i].is_zero()) rates[i] = time_derivative(v[i]);
  }
  return rates;
}

bool identically_zero(const Vector& v) {
  const std::vector<bool> zero = identically_zero_entries({v[0], v[1], v[2]});
  return zero[0] && zero[1] && zero[2];
}

Vector bound(Program& program, const Vector& v, const std::string& name) {
  Vector bound;
  for (int i = 0; i < 3; ++i) bound[i] = program.bind(v[i], name.empty() ? name : name + suffix[i]);
  return bound;
}

Matrix& Matrix::operator+=(const Matrix& other) {
  for (std::size_t i = 0; i < 9; ++i) entries_[i] += other.entries_[i];
  return *this;
}

Matrix operator-(const Matrix& a, const Matrix& b) {
  Matrix difference = a;
  for (std::size_t i = 0; i < 9; ++i) difference.entries_[i] -= b.entries_[i];
  return difference;
}

Matrix operator*(const Value& k, const Matrix& m) {
  Matrix product;
  for (std::size_t i = 0; i < 9; ++i) {
    if (!m.entries_[i].is_zero()) product.entries_[i] = k * m.entries_[i];
  }
  return product;
}

Vector operator*(const Matrix& m, const Vector& v) {
  Vector product;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!m(i, j).is_zero()) product[i] += m(i, j) * v[j];
    }
  }
  return product;
}

Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        if (!a(i, k).is_zero() && !b(k, j).is_zero()) product(i, j) += a(i, k) * b(k, j);
      }
    }
  }
  return product;
}

Matrix transpose(const Matrix& m) {
  Matrix result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = m(j, i);
  }
  return result;
}

Value trace(const Matrix& m) { return m(0, 0) + m(1, 1) + m(2, 2); }

Matrix identity(Program& program) { return constant_matrix(program, Rotation()); }

Matrix constant_matrix(Program& program, const Rotation& rotation) {
  Matrix result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result(i, j) = program.number(rotation(i, j));
  }
  return result;
}

Matrix bound(Program& program, const Matrix& m, const std::string& name) {
  Matrix result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result(i, j) = program.bind(m(i, j), name.empty() ? name : name + suffix[i] + (suffix[j] + 1));
    }
  }
  return result;
}

}  // namespace torsor
