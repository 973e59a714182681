// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/nearest_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/QR>

namespace torsor {
namespace {

/// Between −1 and 1, the same in each run.
class Scatter {
 public:
  double next() {
    state_ = (state_ * 1103515245ULL + 12345ULL) % 2147483648ULL;
    return static_cast<double>(state_ % 20001ULL) / 10000.0 - 1.0;
  }

 private:
  unsigned long long state_ = 20061;
};

double length_of(const std::vector<double>& displacement) {
  return std::sqrt(std::inner_product(displacement.begin(), displacement.end(), displacement.begin(), 0.0));
}

void scale(std::vector<double>& displacement, double factor) {
  for (double& entry : displacement) entry *= factor;
}

/// The vector of the rotation from a quaternion to another one, along the axes turned by the first.
std::array<double, 3> rotation_to(const double* from, const double* to) {
  const double w = from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + from[3] * to[3];
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    v[i] = from[0] * to[1 + i] - to[0] * from[1 + i] - from[1 + j] * to[1 + k] + from[1 + k] * to[1 + j];
  }
  const double s = std::hypot(v[0], v[1], v[2]);
  if (s == 0) return {};
  const double angle = 2 * std::atan2(s, std::abs(w)) * (w < 0 ? -1 : 1);
  for (double& entry : v) entry *= angle / s;
  return v;
}

}  // namespace

NearestState::NearestState(EvaluatedMotion& motion, std::vector<double> start)
    : motion_(motion), start_(std::move(start)) {
  motion_.normalise(start_);
  std::fill(start_.begin() + static_cast<std::ptrdiff_t>(motion_.position_count()), start_.end(), 0.0);
  const auto place_of = [&](const SymbolPointer& symbol) {
    const auto& symbols = motion_.symbols();
    return static_cast<std::size_t>(std::find(symbols.begin(), symbols.end(), symbol) - symbols.begin());
  };
  std::vector<int> components(motion_.equations().scene().content().attitudes.size(), 0);
  for (std::size_t i = 0; i < motion_.velocity_count(); ++i) {
    const CoordinateContent& c = motion_.equations().model().coordinates()[i];
    Freedom freedom;
    if (c.attitude) {
      const auto attitude = static_cast<std::size_t>(*c.attitude);
      freedom.position = place_of(motion_.equations().scene().content().attitudes[attitude].symbols->e[0]);
      freedom.component = components[attitude]++;
    } else {
      freedom.position = place_of(c.q);
      freedom.turns = c.q->unit.is_dimensionless() || c.q->unit == units::radian;
    }
    freedoms_.push_back(freedom);
  }
  free_.assign(freedoms_.size(), true);
  measure();
}

// Sizes at the start and at three places around it: a row may vanish at one of them.
void NearestState::measure() {
  const std::size_t n = freedoms_.size(), count = motion_.equations().constraints().size();
  std::vector<Numbers> places{start_};
  Scatter scatter;
  for (int k = 0; k < 3; ++k) {
    Numbers away(n);
    for (double& entry : away) entry = 0.4 * scatter.next();
    places.push_back(moved(start_, away));
  }
  std::vector<std::vector<Numbers>> gradients(count);
  double arm = 0, lengths = 0;
  for (const Numbers& place : places) {
    motion_.move_to(0.0, place);
    for (std::size_t j = 0; j < count; ++j) {
      const ConstraintRow& row = motion_.constraint(j);
      Numbers gradient;
      for (std::size_t i = 0; i < n; ++i) {
        gradient.push_back(motion_.value(row.jacobian[i]));
        const bool turns = freedoms_[i].turns || freedoms_[i].component >= 0;
        if (row.holonomic && turns && row.value.unit() == units::metre && std::isfinite(gradient[i]))
          arm = std::max(arm, std::abs(gradient[i]));
      }
      gradients[j].push_back(std::move(gradient));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!freedoms_[i].turns && freedoms_[i].component < 0)
      lengths = std::max(lengths, std::abs(start_[freedoms_[i].position]));
  }
  const double size = arm > 0 ? arm : lengths > 0 ? lengths : 1.0;
  for (Freedom& freedom : freedoms_) freedom.unit = freedom.turns || freedom.component >= 0 ? 1.0 : size;
  std::vector<Row> all;
  for (std::size_t j = 0; j < count; ++j) {
    if (!motion_.constraint(j).holonomic) continue;
    Row row{j, 0};
    for (const Numbers& gradient : gradients[j]) {
      double square = 0;
      for (std::size_t i = 0; i < n; ++i) square += std::pow(gradient[i] * freedoms_[i].unit, 2);
      if (std::isfinite(square)) row.size = std::max(row.size, std::sqrt(square));
    }
    all.push_back(row);
  }
  const auto unit_of = [&](const Row& row) { return motion_.constraint(row.constraint).value.unit(); };
  for (const Row& row : all) {
    // What holds in any case is zero, or rounding in double beside the others of its unit.
    const bool counts = row.size > 0 && std::none_of(all.begin(), all.end(), [&](const Row& other) {
      return unit_of(other) == unit_of(row) && row.size < 1e-12 * other.size;
    });
    if (counts) rows_.push_back(row);
  }
}

NearestState::Numbers NearestState::to_start(const Numbers& y) const {
  Numbers way(freedoms_.size());
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Freedom& freedom = freedoms_[i];
    if (freedom.component >= 0) {
      way[i] =
          rotation_to(&y[freedom.position], &start_[freedom.position])[static_cast<std::size_t>(freedom.component)];
    } else {
      way[i] = (start_[freedom.position] - y[freedom.position]) / freedom.unit;
    }
  }
  return way;
}

double NearestState::distance(const std::vector<double>& y) { return length_of(to_start(y)); }

NearestState::Numbers NearestState::moved(const Numbers& y, const Numbers& displacement) {
  Numbers turning = y;
  for (std::size_t i = 0; i < displacement.size(); ++i)
    turning[motion_.position_count() + i] = displacement[i] * freedoms_[i].unit;
  motion_.move_to(0.0, turning);
  Numbers result = y;
  for (std::size_t i = 0; i < motion_.position_count(); ++i) result[i] += motion_.position_rate(i);
  motion_.normalise(result);
  return result;
}

NearestState::Numbers NearestState::residual(const Numbers& y) {
  motion_.move_to(0.0, y);
  Numbers f;
  for (const Row& row : rows_) f.push_back(motion_.value(motion_.constraint(row.constraint).value) / row.size);
  return f;
}

namespace {

/// Rows that repeat others have no direction of their own.
constexpr double repeats = 1e-9;

}  // namespace

NearestState::Numbers NearestState::least(const Numbers& y, const Numbers& right) {
  motion_.move_to(0.0, y);
  const auto m = static_cast<Eigen::Index>(rows_.size()), n = static_cast<Eigen::Index>(freedoms_.size());
  Eigen::MatrixXd J(m, n);
  Eigen::VectorXd b(m);
  for (Eigen::Index k = 0; k < m; ++k) {
    const Row& row = rows_[static_cast<std::size_t>(k)];
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      J(k, i) = free_[at]
                    ? motion_.value(motion_.constraint(row.constraint).jacobian[at]) * freedoms_[at].unit / row.size
                    : 0.0;
    }
    b(k) = right[static_cast<std::size_t>(k)];
  }
  if (!J.allFinite()) return Numbers(freedoms_.size(), 0.0);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(repeats);
  decomposition.compute(J);
  const Eigen::VectorXd x = decomposition.solve(b);
  return Numbers(x.data(), x.data() + n);
}

NearestState::Numbers NearestState::along(const Numbers& y, const Numbers& displacement) {
  motion_.move_to(0.0, y);
  Numbers change;
  for (const Row& row : rows_) {
    double sum = 0;
    for (std::size_t i = 0; i < displacement.size(); ++i) {
      if (displacement[i] == 0) continue;
      sum += motion_.value(motion_.constraint(row.constraint).jacobian[i]) * freedoms_[i].unit * displacement[i];
    }
    change.push_back(sum / row.size);
  }
  return change;
}

NearestState::Numbers NearestState::free_part(Numbers displacement) const {
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    if (!free_[i]) displacement[i] = 0;
  }
  return displacement;
}

bool NearestState::close(Numbers& y) {
  constexpr double longest = 0.25, closed = 1e-11;
  Numbers f = residual(y);
  for (int round = 0; round < 80; ++round) {
    const double before = length_of(f);
    if (!(before > closed)) return std::isfinite(before);
    Numbers step = least(y, f);
    const double size = length_of(step);
    scale(step, size > longest ? -longest / size : -1.0);
    bool descends = false;
    for (int half = 0; half < 6 && !descends; ++half, scale(step, 0.5)) {
      const Numbers next = moved(y, step);
      Numbers there = residual(next);
      descends = length_of(there) < before * (1 - 1e-4);
      if (!descends) continue;
      y = next;
      f = std::move(there);
    }
    if (!descends) return false;
  }
  return false;
}

void NearestState::approach(Numbers& y) {
  for (int round = 0; round < 60; ++round) {
    Numbers way = free_part(to_start(y));
    const double before = distance(y);
    const Numbers across = least(y, along(y, way));
    for (std::size_t i = 0; i < way.size(); ++i) way[i] -= across[i];
    const double size = length_of(way);
    if (!(size > 1e-7)) return;
    scale(way, std::min(1.0, 0.5 / size));
    bool nearer = false;
    for (int half = 0; half < 5 && !nearer; ++half, scale(way, 0.5)) {
      Numbers next = moved(y, way);
      nearer = close(next) && distance(next) < before - 1e-12;
      if (nearer) y = std::move(next);
    }
    if (!nearer) return;
  }
}

/// Whole turns of a joint, where the constraints are the same without them.
void NearestState::unwind(Numbers& y) {
  for (std::size_t i = 0; i < freedoms_.size(); ++i) {
    const Freedom& freedom = freedoms_[i];
    if (!freedom.turns || !free_[i]) continue;
    const double turn = 2 * std::numbers::pi,
                 turns = std::round((y[freedom.position] - start_[freedom.position]) / turn);
    if (turns == 0) continue;
    Numbers less = y;
    less[freedom.position] -= turns * turn;
    if (close(less) && distance(less) < distance(y)) y = std::move(less);
  }
}

std::optional<std::vector<double>> NearestState::find(const std::vector<std::size_t>& kept) {
  if (rows_.empty()) return start_;
  free_.assign(freedoms_.size(), true);
  for (const std::size_t i : kept) free_[i] = false;
  std::optional<Numbers> best;
  Scatter scatter;
  constexpr int places = 16;
  constexpr double near = 0.1;  // beside which another branch is not worth a search
  for (int k = 0; k <= places && !(best && distance(*best) < near); ++k) {
    Numbers away(freedoms_.size());
    for (double& entry : away) entry = k == 0 ? 0.0 : (k % 2 == 0 ? 1.2 : 0.5) * scatter.next();
    Numbers y = moved(start_, free_part(std::move(away)));
    if (!close(y)) continue;
    unwind(y);
    approach(y);
    if (!best || distance(y) < distance(*best) - 1e-6) best = std::move(y);
  }
  return best;
}

}  // namespace torsor
