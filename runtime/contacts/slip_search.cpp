// SPDX-License-Identifier: MIT
// The directions of slips that begin, of one combination of regimes.
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "torsor/runtime/contacts/circle_roots.hpp"
#include "torsor/runtime/contacts/regime_enumeration.hpp"
#include "torsor/runtime/contacts/slip_direction.hpp"
#include "torsor/runtime/contacts/slip_relations.hpp"
#include "torsor/runtime/contacts/torus_roots.hpp"

namespace torsor::runtime {
namespace {

/// Directions that a search of one combination has come to: many starts lead to the same, which is judged once.
class DirectionsMet {
 public:
  /// Whether these are new, as far as motions are told apart.
  bool add(const RegimeSystem::Regimes& regimes, int contacts) noexcept {
    for (std::size_t k = 0; k < count_; ++k) {
      double most = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(contacts); ++i) {
        if (!regimes[i].direction_sought) continue;
        for (std::size_t j = 0; j < 2; ++j) most = std::max(most, std::abs(regimes[i].direction[j] - met_[k][i][j]));
      }
      if (most <= 1e-9) return false;
    }
    if (count_ == met_.size()) return true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(contacts); ++i) met_[count_][i] = regimes[i].direction;
    ++count_;
    return true;
  }

 private:
  std::array<PerContact<std::array<double, 2>>, 16> met_;
  std::size_t count_ = 0;
};

}  // namespace

void RegimeEnumeration::try_regimes(Regimes& regimes) noexcept {
  const int sought = count_sought(regimes);
  if (sought == 0) return accept(regimes);
  if (try_related(regimes)) return;
  if (sought == 1) return try_all_directions(regimes);
  if (sought == 2 && try_all_pairs(regimes)) return;
  complete_ = false;
  const int starts = sought == 2 ? 8 : thoroughly_ ? (sought == 3 ? 12 : 5) : problem_.count == 3 ? 6 : 3;
  DirectionsMet met;
  int total = 1;
  for (int i = 0; i < sought; ++i) total *= starts;
  for (int start = 0; start < total; ++start) {
    int digits = start;
    for (int i = 0; i < problem_.count; ++i) {
      if (!regimes[as(i)].direction_sought) continue;
      const double angle = 0.3 + 2 * std::numbers::pi * (digits % starts) / starts;
      digits /= starts;
      regimes[as(i)].direction = {std::cos(angle), std::sin(angle)};
    }
    if (turn_to_slip(regimes) && met.add(regimes, problem_.count)) accept(regimes);
  }
}

// Whether the slips depend on each other so that there is no direction to look for, or one of all.
bool RegimeEnumeration::try_related(Regimes& regimes) noexcept {
  if (!relates_ || bearings_ > 0 || problem_.count < 2) return false;
  const SlipRelations relations(problem_, scale_, regimes);
  const bool related = relations.holds_one() || relations.leaves_one_number();
  left_out_ = left_out_ || related;
  if (!related || relations.holds_one()) return related;
  for (const double sign : {1.0, -1.0}) {
    for (int i = 0; i < problem_.count; ++i) {
      if (regimes[as(i)].direction_sought) {
        regimes[as(i)].direction = {sign * relations.direction(i)[0], sign * relations.direction(i)[1]};
      }
    }
    accept(regimes);
  }
  return true;
}

// u_T across the direction, times det E, is a trigonometric polynomial of degree 3 in the direction's angle, unless a
// joint's reaction changes its direction with it.
void RegimeEnumeration::try_all_directions(Regimes& regimes) noexcept {
  int contact = 0;
  while (!regimes[as(contact)].direction_sought) ++contact;
  auto& direction = regimes[as(contact)].direction;
  const int t = problem_.tangent_row(contact);
  std::array<double, 8> values{};
  for (std::size_t j = 0; j < values.size(); ++j) {
    const double angle = std::numbers::pi / 4 * static_cast<double>(j);
    direction = {std::cos(angle), std::sin(angle)};
    RegimeSystem system(problem_, scale_, regimes);
    if (!system.solve() || system.kernel().cols() > 0 || bearings_ > 0) {
      // E is singular in this very direction: others do as well, turned by Newton's method.
      complete_ = false;
      DirectionsMet met;
      for (int k = 0; k < 8; ++k) {
        const double start = 0.3 + std::numbers::pi / 4 * k;
        direction = {std::cos(start), std::sin(start)};
        if (turn_to_slip(regimes) && met.add(regimes, problem_.count)) accept(regimes);
      }
      return;
    }
    const ContactVector u = system.motion();
    values[j] = system.determinant() * (direction[0] * u(t + 1) - direction[1] * u(t));
  }
  const CircleRoots roots(values);
  for (std::size_t i = 0; i < roots.count(); ++i) {
    direction = {std::cos(roots[i]), std::sin(roots[i])};
    if (turn_to_slip(regimes)) accept(regimes);
  }
}

// The same of two contacts, each of degree 3 in both angles. False where not all pairs of directions are found so.
bool RegimeEnumeration::try_all_pairs(Regimes& regimes) noexcept {
  if (bearings_ > 0) return false;
  std::array<int, 2> who{};
  for (int i = 0, k = 0; i < problem_.count; ++i) {
    if (regimes[as(i)].direction_sought) who[as(k++)] = i;
  }
  const auto turn = [&](std::size_t k, double angle) { regimes[as(who[k])].direction = {std::cos(angle), std::sin(angle)}; };
  constexpr std::size_t n = TorusRoots::samples;
  TorusRoots::Values values{};
  for (std::size_t place = 0; place < values.size(); ++place) {
    turn(0, std::numbers::pi / 4 * static_cast<double>(place / n));
    turn(1, std::numbers::pi / 4 * static_cast<double>(place % n));
    RegimeSystem system(problem_, scale_, regimes);
    if (!system.solve() || system.kernel().cols() > 0) return false;
    const ContactVector u = system.motion();
    for (std::size_t k = 0; k < 2; ++k) {
      const int t = problem_.tangent_row(who[k]);
      const auto& d = regimes[as(who[k])].direction;
      values[place][k] = system.determinant() * (d[0] * u(t + 1) - d[1] * u(t));
    }
  }
  const TorusRoots roots(values);
  for (std::size_t i = 0; i < roots.count(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) turn(k, roots[i][k]);
    if (turn_to_slip(regimes)) accept(regimes);
  }
  return roots.complete();
}

// Newton's method for u_T across d = 0 in all directions sought.
bool RegimeEnumeration::turn_to_slip(Regimes& regimes) noexcept {
  const int sought = count_sought(regimes);
  PerContact<int> who{};
  for (int i = 0, k = 0; i < problem_.count; ++i) {
    if (regimes[as(i)].direction_sought) who[as(k++)] = i;
  }
  double last = INFINITY;
  for (int step = 0; step < 40; ++step) {
    RegimeSystem system(problem_, scale_, regimes);
    if (!system.solve()) return false;
    const ContactVector u = system.motion();
    const ContactVector size = RegimeInequalities(problem_, scale_, system).sizes(system.reactions()).motion;
    const SlipsAcross slips(problem_, system, u, std::span(who).first(as(sought)));
    const double off = slips.largest(problem_, size);
    // Down to rounding, or as far as it falls.
    if (off <= 1e-15 || (off <= 1e-12 && off >= last)) return true;
    last = off;
    if (!turn_slips(regimes, who, -slips.slopes.partialPivLu().solve(slips.across), 0.7)) return false;
  }
  return false;
}

}  // namespace torsor::runtime
