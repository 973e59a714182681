// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/derivatives/reduction.hpp"

#include <algorithm>

#include "torsor/generator/program/identically_zero.hpp"

namespace torsor {
namespace {

ValueMatrix zeros(std::size_t rows, std::size_t columns) { return ValueMatrix(rows, std::vector<Value>(columns)); }

ValueMatrix product(Flattening& flattening, const ValueMatrix& x, const ValueMatrix& y, std::size_t columns) {
  ValueMatrix result = zeros(x.size(), columns);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      Value sum;
      for (std::size_t k = 0; k < y.size(); ++k) {
        if (!x[i][k].is_zero() && !y[k][j].is_zero()) sum += x[i][k] * y[k][j];
      }
      result[i][j] = flattening.program().bind(flattening.cheaper(sum));
    }
  }
  return result;
}

ValueMatrix sum(Program& program, const ValueMatrix& x, const ValueMatrix& y) {
  ValueMatrix result = x;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x[i].size(); ++j) result[i][j] = program.bind(x[i][j] + y[i][j]);
  }
  return result;
}

ValueMatrix transposed(const ValueMatrix& x, std::size_t columns) {
  ValueMatrix result = zeros(columns, x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < columns; ++j) result[j][i] = x[i][j];
  }
  return result;
}

/// Solves the first constraints of the order of elimination for the dependent freedoms.
class DependentFreedoms {
 public:
  /// Of the first `count` constraints of the elimination, at least one.
  DependentFreedoms(Program& program, const ValueMatrix& rows, const IndependentFreedoms& freedoms, std::size_t count)
      : program_(program),
        freedoms_(freedoms),
        n_(freedoms.velocities.size() + freedoms.pivots.size()),
        lu_(program, square(rows, freedoms, count)),
        count_(count) {}

  /// (pivot², m_c Σ_i a_i² / m_i) for each: a the row, m the diagonal of M, c the freedom it is solved for. In the
  /// metric of that diagonal the pivot is compared with its row.
  std::vector<PivotTest> pivots(const ValueMatrix& rows, const ValueMatrix& mass) const {
    std::vector<PivotTest> all;
    for (std::size_t k = 0; k < count_; ++k) {
      const auto& [row, freedom] = freedoms_.pivots[k];
      const Value pivot = program_.bind(lu_.pivots()[k].pivot);
      if (pivot.is_constant()) continue;  // regular once and for all
      const Value square = program_.bind(pow(pivot, 2));
      Value sum;
      for (std::size_t i = 0; i < n_; ++i) {
        if (rows[row][i].is_zero()) continue;
        const Value diagonal = program_.bind(mass[i][i]);
        const Value entry = program_.bind(rows[row][i]);
        sum += pow(entry, 2) * pow(diagonal, -1);
      }
      all.push_back({square, program_.bind(program_.bind(sum) * mass[freedom][freedom])});
    }
    return all;
  }

  /// Dependent entries x with A x = −right_side where the independent ones are zero; full length n, by columns.
  ValueMatrix solve(const ValueMatrix& right_side, std::size_t columns) const {
    ValueMatrix result = zeros(n_, columns);
    for (std::size_t j = 0; j < columns; ++j) {
      std::vector<Value> column;
      for (std::size_t k = 0; k < count_; ++k) column.push_back(-right_side[freedoms_.pivots[k].row][j]);
      const std::vector<Value> x = lu_.solve(column);
      for (std::size_t k = 0; k < count_; ++k) result[freedoms_.pivots[k].column][j] = x[k];
    }
    return result;
  }

  /// The basis of A x = 0 with unit independent entries.
  ValueMatrix null_basis(const ValueMatrix& rows, const std::vector<std::size_t>& independent) const {
    ValueMatrix right_side = zeros(rows.size(), independent.size());
    for (std::size_t r = 0; r < rows.size(); ++r) {
      for (std::size_t k = 0; k < independent.size(); ++k) right_side[r][k] = rows[r][independent[k]];
    }
    ValueMatrix basis = solve(right_side, independent.size());
    for (std::size_t k = 0; k < independent.size(); ++k) basis[independent[k]][k] = program_.number(Number(1));
    return basis;
  }

 private:
  static ValueMatrix square(const ValueMatrix& rows, const IndependentFreedoms& freedoms, std::size_t count) {
    ValueMatrix matrix = zeros(count, count);
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t l = 0; l < count; ++l) matrix[k][l] = rows[freedoms.pivots[k].row][freedoms.pivots[l].column];
    }
    return matrix;
  }

  Program& program_;
  const IndependentFreedoms& freedoms_;
  std::size_t n_;
  UnsymmetricFactorisation lu_;
  std::size_t count_;
};

}  // namespace

std::vector<Value> turned_row(const Model& model, std::size_t i, const ValueMatrix& x) {
  const std::size_t columns = x.empty() ? 0 : x[0].size();
  std::vector<Value> row(columns);
  if (!model.coordinates()[i].attitude) return row;
  std::size_t first = i;
  while (first > 0 && model.coordinates()[first - 1].attitude == model.coordinates()[i].attitude) --first;
  const std::size_t y = first + (i - first + 1) % 3;
  const std::size_t z = first + (i - first + 2) % 3;
  for (std::size_t j = 0; j < columns; ++j) {
    if (!x[z][j].is_zero()) row[j] += model.v(static_cast<int>(y)) * x[z][j];
    if (!x[y][j].is_zero()) row[j] -= model.v(static_cast<int>(z)) * x[y][j];
  }
  return row;
}

ReducedLinearisation reduced_linearisation(const Equations& equations) {
  const Model& model = equations.model();
  Program& program = equations.program();
  const auto n = static_cast<std::size_t>(model.unknown_count());
  const std::vector<ConstraintRow>& rows = equations.constraints();
  const std::size_t m = rows.size();
  Flattening flattening(program);
  ReducedLinearisation result;
  result.freedoms = independent_freedoms(equations);
  const IndependentFreedoms& freedoms = result.freedoms;
  const std::size_t k = freedoms.coordinates.size();
  const std::size_t p = freedoms.velocities.size();

  result.full = linearisation(equations);
  Linearisation& full = result.full;
  ValueMatrix a_matrix = zeros(m, n), columns = zeros(m, n), of_rate = zeros(m, n), gamma_v = zeros(m, n),
              of_acceleration = zeros(m, n), left_over = zeros(m, 1);
  for (const IndependentFreedoms::Pivot& pivot : freedoms.pivots) {
    const std::size_t j = pivot.row;
    const ConstraintRow& row = rows[j];
    Value acceleration = row.gamma;
    for (std::size_t i = 0; i < n; ++i) {
      a_matrix[j][i] = row.jacobian[i];
      columns[j][i] = row.column[i];
      result.symmetric = result.symmetric && !row.friction;
      if (!row.jacobian[i].is_zero()) acceleration += row.jacobian[i] * model.a(static_cast<int>(i));
    }
    left_over[j][0] = program.bind(acceleration);
  }
  for (std::size_t i = 0; i < n; ++i) {
    Derivation by_velocity = partial_derivation(program, model.coordinates()[i].v);
    Derivation by_position = model.along(static_cast<int>(i));
    for (const IndependentFreedoms::Pivot& pivot : freedoms.pivots) {
      const std::size_t j = pivot.row;
      of_rate[j][i] = program.bind(by_position(rows[j].rate));
      gamma_v[j][i] = program.bind(by_velocity(rows[j].gamma));
      of_acceleration[j][i] = program.bind(by_position(left_over[j][0]));
    }
  }
  for (ValueMatrix* matrix : {&full.C, &full.K, &of_rate, &gamma_v, &of_acceleration}) clear_identically_zero(*matrix);

  const DependentFreedoms holonomic(program, a_matrix, freedoms, freedoms.holonomic);
  const DependentFreedoms all(program, a_matrix, freedoms, freedoms.pivots.size());
  result.pivots = all.pivots(a_matrix, full.M);
  const ValueMatrix z = holonomic.null_basis(a_matrix, freedoms.coordinates);
  const ValueMatrix basis = all.null_basis(a_matrix, freedoms.velocities);
  const ValueMatrix v = all.solve(product(flattening, of_rate, z, k), k);
  const ValueMatrix along_w = all.solve(product(flattening, gamma_v, basis, p), p);
  const ValueMatrix gamma_e = product(flattening, gamma_v, v, k);
  const ValueMatrix acceleration_e = product(flattening, of_acceleration, z, k);
  const ValueMatrix along_e = all.solve(sum(program, gamma_e, acceleration_e), k);
  const ValueMatrix rest = all.solve(left_over, 1);

  ValueMatrix left = transposed(basis, p);
  if (!result.symmetric) {
    const DependentFreedoms reactions(program, columns, freedoms, freedoms.pivots.size());
    left = transposed(reactions.null_basis(columns, freedoms.velocities), p);
    const auto more = reactions.pivots(columns, full.M);
    result.pivots.insert(result.pivots.end(), more.begin(), more.end());
  }
  const ValueMatrix left_mass = product(flattening, left, full.M, n);
  result.M = product(flattening, left_mass, basis, p);
  for (std::size_t i = 0; result.symmetric && i < p; ++i) {
    for (std::size_t j = 0; j < i; ++j) result.M[i][j] = result.M[j][i];
  }
  const ValueMatrix inertia_w = product(flattening, left_mass, along_w, p);
  const ValueMatrix damping_w = product(flattening, left, product(flattening, full.C, basis, p), p);
  result.C = sum(program, inertia_w, damping_w);
  const ValueMatrix inertia_e = product(flattening, left_mass, along_e, k);
  const ValueMatrix damping_e = product(flattening, full.C, v, k);
  const ValueMatrix stiffness_e = product(flattening, full.K, z, k);
  result.K = sum(program, inertia_e, product(flattening, left, sum(program, damping_e, stiffness_e), k));
  ValueMatrix force = zeros(n, 1);
  for (std::size_t i = 0; i < n; ++i) force[i][0] = full.F[i];
  const ValueMatrix reduced_force = product(flattening, left, force, 1);
  const ValueMatrix reduced_rest = product(flattening, left_mass, rest, 1);
  for (std::size_t i = 0; i < p; ++i) result.F.push_back(program.bind(flattening.cheaper(reduced_force[i][0] - reduced_rest[i][0])));
  result.E = product(flattening, left, full.E, model.inputs().size());

  for (const std::size_t i : freedoms.coordinates) {
    const std::vector<Value> turned = turned_row(model, i, z);
    std::vector<Value> row;
    for (std::size_t j = 0; j < k; ++j) row.push_back(program.bind(v[i][j] - turned[j]));
    result.e_rates_e.push_back(std::move(row));
    result.e_rates_w.push_back(basis[i]);
  }
  return result;
}

}  // namespace torsor
