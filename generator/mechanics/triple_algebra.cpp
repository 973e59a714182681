// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/mechanics/triple_algebra.hpp"

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/number.hpp"
#include "torsor/generator/expression/expression_node.hpp"

namespace torsor {
namespace {

bool is_one(const Expression& x) {
  const auto* number = std::get_if<Number>(&x.node().content);
  return number != nullptr && number->is_one() && x.unit().is_dimensionless();
}

}  // namespace

Expression folded_product(const Expression& a, const Expression& b) {
  if (a.is_zero() || b.is_zero()) return 0;
  if (is_one(a)) return b;
  return is_one(b) ? a : a * b;
}

Expression dot(const Triple& a, const Triple& b) {
  Expression sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum = sum + folded_product(a[i], b[i]);
  return sum;
}

Triple operator+(const Triple& a, const Triple& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Triple operator-(const Triple& a, const Triple& b) {
  Triple difference = a;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!b[i].is_zero()) difference[i] = a[i] - b[i];
  }
  return difference;
}

Triple operator*(const Expression& k, const Triple& v) {
  return {folded_product(k, v[0]), folded_product(k, v[1]), folded_product(k, v[2])};
}

Triple operator*(const Tableau& m, const Triple& v) { return {dot(m[0], v), dot(m[1], v), dot(m[2], v)}; }

Tableau turned(const Tableau& rotation, const Tableau& j) {
  Tableau half, result;  // half = R Jᵀ, row by row of J; J is symmetric
  for (std::size_t row = 0; row < 3; ++row) half[row] = rotation * j[row];
  for (std::size_t a = 0; a < 3; ++a) {
    Triple column;
    for (std::size_t k = 0; k < 3; ++k) column[k] = half[k][a];
    result[a] = rotation * column;
  }
  return result;
}

Tableau operator_of_point(const Expression& k, const Triple& v) {
  Tableau j;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    const std::size_t c = (a + 2) % 3;
    const Expression square = folded_product(v[b], v[b]) + folded_product(v[c], v[c]);
    j[a][a] = folded_product(k, square);
    const Expression product = folded_product(k, folded_product(v[a], v[b]));
    j[a][b] = product.is_zero() ? product : -product;
    j[b][a] = j[a][b];
  }
  return j;
}

Triple unit_vector(const Triple& axis, const std::string& where_null) {
  const Expression square = dot(axis, axis);
  if (square.is_zero()) throw SceneError(where_null);
  return is_one(square) ? axis : Expression(pow(sqrt(square), -1)) * axis;
}

Tableau rotation_about(const Triple& axis, const Expression& angle) {
  const Triple n = unit_vector(axis, "a body cannot be turned about the null vector: give the axis a direction");
  const Expression sine = sin(angle);
  const Expression cosine = cos(angle);
  Tableau r;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Expression ii = folded_product(n[i], n[i]);
    r[i][i] = is_one(ii) ? Expression(1) : cosine + folded_product(1 - cosine, ii);
    const Expression ij = folded_product(1 - cosine, folded_product(n[i], n[j]));
    const Expression turn = folded_product(sine, n[k]);
    r[i][j] = turn.is_zero() ? ij : ij - turn;
    r[j][i] = ij + turn;
  }
  return r;
}

Expression difference(const Expression& a, const Expression& b) { return b.is_zero() ? a : a - b; }

}  // namespace torsor
