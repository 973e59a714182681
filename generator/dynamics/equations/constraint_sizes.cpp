// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/constraint_sizes.hpp"

#include <algorithm>

#include "torsor/generator/dynamics/equations/configuration_sample.hpp"

namespace torsor {
namespace {

using Reals = std::vector<Real>;

/// Largest |A_ji| at the initial configuration and at neighbours whose angles differ.
std::vector<Reals> usual_entries(const Model& model, const std::vector<ConstraintRow>& rows) {
  const auto n = static_cast<std::size_t>(model.unknown_count());
  std::vector<Reals> usual(rows.size(), Reals(n, Real(0)));
  unsigned long long random = 4099;
  for (int place = 0; place < 4; ++place) {
    ConfigurationSample sample(model);
    if (place > 0) {
      Reals turn(n, Real(0));
      for (std::size_t i = 0; i < n; ++i) {
        random = (random * 1103515245ULL + 12345ULL) % 2147483648ULL;
        if (freedom_turns(model, i)) turn[i] = Real(static_cast<int>(random % 1001ULL) - 500) / Real(1000);
      }
      sample.displace(turn);
    }
    for (std::size_t j = 0; j < rows.size(); ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        const Real entry = abs(sample(rows[j].jacobian[i]));
        if (entry > usual[j][i]) usual[j][i] = entry;  // never where it is not a number
      }
    }
  }
  return usual;
}

/// How far freedoms of that unit go, as the rows weigh them against what turns.
Real reach_of(const Unit& unit, const Model& model, const std::vector<Reals>& usual) {
  Reals levers;
  for (const Reals& row : usual) {
    Real turned(0);
    for (std::size_t i = 0; i < row.size(); ++i) turned += freedom_turns(model, i) ? row[i] : Real(0);
    Real largest(0);
    for (const Real& entry : row) largest = std::max(largest, entry);
    const Real rounding = largest * Real::parse("1e-30");
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool of_unit = !freedom_turns(model, i) && model.coordinates()[i].q->unit == unit;
      if (of_unit && row[i] > rounding && turned > rounding) levers.push_back(turned / row[i]);
    }
  }
  if (!levers.empty()) {
    std::sort(levers.begin(), levers.end());
    return levers[levers.size() / 2];
  }
  const Real extent = ConfigurationSample(model).extent(unit);
  return extent > Real(0) ? extent : Real(1);
}

}  // namespace

bool freedom_turns(const Model& model, std::size_t freedom) {
  const auto& coordinate = model.coordinates()[freedom];
  return coordinate.attitude || coordinate.q->unit.is_dimensionless();
}

ConstraintSizes constraint_sizes(const Model& model, const std::vector<ConstraintRow>& rows) {
  const std::vector<Reals> usual = usual_entries(model, rows);
  ConstraintSizes sizes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(model.unknown_count()); ++i)
    sizes.reach.push_back(freedom_turns(model, i) ? Real(1) : reach_of(model.coordinates()[i].q->unit, model, usual));
  for (const Reals& row : usual) {
    Real size(0);
    for (std::size_t i = 0; i < row.size(); ++i) size += row[i] * sizes.reach[i];
    sizes.size.push_back(size);
  }
  // A row that is rounding only, or that nothing changes, is judged as the others are.
  const Real largest = sizes.size.empty() ? Real(0) : *std::max_element(sizes.size.begin(), sizes.size.end());
  for (Real& size : sizes.size) {
    if (size <= largest * Real::parse("1e-30")) size = largest.is_zero() ? Real(1) : largest;
  }
  return sizes;
}

}  // namespace torsor
