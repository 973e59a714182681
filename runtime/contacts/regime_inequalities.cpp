// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/regime_inequalities.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace torsor::runtime {

ContactVector given_motions(const ContactProblem& problem, const ContactScale& scale) noexcept {
  ContactVector terms = problem.q.cwiseAbs();
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    const int t = problem.tangent_row(i);
    double bound = std::max(law.bound, law.static_bound);
    if (law.bearing > 0) bound += std::max(law.friction, law.static_friction) * problem.pressing(i, ContactVector::Zero(problem.rows()));
    for (int k = 0; k < law.tangents; ++k) terms += bound * problem.W.col(t + k).cwiseAbs();
  }
  return scale.motions(terms);
}

RegimeInequalities::Sizes RegimeInequalities::sizes(const ContactVector& r) const noexcept {
  const ContactVector terms = problem_.W.cwiseAbs() * r.cwiseAbs() + problem_.q.cwiseAbs();
  return {scale_.forces(r), scale_.motions(terms)};
}

double RegimeInequalities::of_friction(int contact, const ContactVector& sizes) const noexcept {
  double largest = 0;
  for (int k = 0, t = problem_.tangent_row(contact); k < problem_.law(contact).tangents; ++k) {
    largest = std::max(largest, sizes(t + k));
  }
  return largest;
}

bool RegimeInequalities::hold(const ContactVector& r, const ContactVector& u, double slack) const noexcept {
  const Sizes size = sizes(r);
  // Where terms cancel to a part in 1e8 the motion is no longer known: forces that run away solve nothing.
  if (!(size.motion.array() <= 1e8 * given_motions(problem_, scale_).array()).all()) return false;
  const ContactVector force = slack * size.force, motion = slack * size.motion;
  for (int i = 0; i < problem_.count; ++i) {
    const ContactLaw& law = problem_.law(i);
    const AssumedRegime& assumed = system_.at(i);
    const int n = problem_.first_row(i), t = problem_.tangent_row(i);
    if (law.normal && !(assumed.pressed ? r(n) >= -force(n) : u(n) >= -motion(n))) return false;
    if (assumed.friction == Friction::sticks) {
      const double N = problem_.pressing(i, r);
      double length = 0;
      for (int k = 0; k < law.tangents; ++k) length = std::hypot(length, r(t + k));
      if (!(length <= law.static_friction * N + law.static_bound + size_along(force, r, t, law.tangents))) return false;
    }
    if (assumed.friction == Friction::slides && !assumed.direction_given) {
      double along = 0, across = 0;
      for (int k = 0; k < law.tangents; ++k) along += assumed.direction[as(k)] * u(t + k);
      if (law.tangents == 2) across = assumed.direction[0] * u(t + 1) - assumed.direction[1] * u(t);
      const double most = of_friction(i, motion);
      if (!(along >= -most && std::abs(across) <= 64 * most)) return false;
    }
  }
  return true;
}

// |R| of a joint that sticks is no concave bound: reactions where R points one way are apart from those where it points another.
// Each way gives the bound f ρ · R, which is one, and is left for |R| where it has led to a place.
RegimeInequalities::Room RegimeInequalities::find(RegimeSystem& system, double margin) const noexcept {
  const ContactVector start = system.x();
  Ways ways{};
  Room best = find_along(system, margin, ways);
  const auto is_enough = [margin](const Room& room) { return room.holds && (room.inside || margin == 0); };
  if (is_enough(best)) return best;
  PerContact<int> count{};
  int together = 1;
  for (int i = 0; i < problem_.count; ++i) {
    const bool holds = system.at(i).friction == Friction::sticks;
    count[as(i)] = holds && problem_.law(i).bearing > 0 ? (problem_.law(i).bearing == 1 ? 2 : 8) : 1;
    together = std::min(together * count[as(i)], 1000);
  }
  if (together == 1 || together > 64) return best;
  ContactVector place = system.x();
  for (int k = 0; k < together; ++k) {
    for (int i = 0, rest = k; i < problem_.count; rest /= count[as(i++)]) {
      if (count[as(i)] == 1) continue;
      const double angle = 2 * std::numbers::pi * (rest % count[as(i)]) / count[as(i)];
      ways[as(i)] = {std::cos(angle), problem_.law(i).bearing == 1 ? 0 : std::sin(angle)};
    }
    system.x() = start;
    Room room = find_along(system, margin, ways);
    if (!is_enough(room)) room = find_along(system, margin, {});
    if (is_enough(room)) return room;
    if (!room.holds || best.holds) continue;
    best = room;
    place = system.x();
  }
  system.x() = place;
  return best;
}

RegimeInequalities::Room RegimeInequalities::find_along(RegimeSystem& system, double margin, const Ways& ways) const noexcept {
  const auto& Z = system.kernel();
  const int n = static_cast<int>(Z.cols());
  const ContactVector start = system.x();
  const ContactMatrix R = system.B() * Z, U = problem_.W * R;
  ContactVector z = ContactVector::Zero(n);
  // A group without forces keeps none: its conditions hold as they are.
  const Sizes all = sizes(system.reactions());
  const ContactVector &force = all.force, &motion = all.motion;  // clang 14 captures no bindings
  if (!(force.size() > 0 && force.maxCoeff() > 0)) return {};
  // How far z may go before forces double: what changes by rounding until then is the same for all z.
  double reach = 0;
  for (Eigen::Index i = 0; i < R.rows(); ++i) {
    if (force(i) > 0) reach = std::max(reach, R.row(i).norm() / force(i));
  }
  ContactVector gradient(n);
  ContactMatrix hessian(n, n);
  const auto value = [&](const ContactVector& at, bool slopes) {
    system.x() = start + Z * at;
    const ContactVector r = system.reactions(), u = problem_.W * r + problem_.q;
    double sum = 0;
    if (slopes) {
      gradient.setZero(n);
      hessian.setZero(n, n);
    }
    const auto add = [&](double given, double size, const ContactVector& slopes_of_it) {
      const double missing = margin - given / size;
      if (!(size > 0 && missing > 0) || slopes_of_it.norm() <= 1e-12 * reach * size) return;
      const ContactVector row = slopes_of_it / size;
      sum += missing * missing / 2;
      if (!slopes) return;
      gradient -= missing * row;
      hessian += row * row.transpose();
    };
    for (int i = 0; i < problem_.count; ++i) {
      const ContactLaw& law = problem_.law(i);
      const AssumedRegime& assumed = system.at(i);
      const int k = problem_.first_row(i), t = problem_.tangent_row(i);
      if (law.normal && assumed.pressed) add(r(k), force(k), R.row(k).transpose());
      if (law.normal && !assumed.pressed) add(u(k), motion(k), U.row(k).transpose());
      if (assumed.friction == Friction::sticks) {
        // |T| has a kink at 0, where Newton's method would stay: a hyperboloid over its cone has none.
        const double size = of_friction(i, force);
        double length = margin * size / 4;
        for (int j = 0; j < law.tangents; ++j) length = std::hypot(length, r(t + j));
        const auto bearing = problem_.bearing(i, r);
        const auto& way = ways[as(i)];
        const bool one_way = way[0] != 0 || way[1] != 0;
        const double N = one_way ? way[0] * bearing[0] + way[1] * bearing[1] : problem_.pressing(i, r);
        const double left = law.static_friction * N + law.static_bound - length;
        const double missing = margin - left / size;
        if (!(size > 0 && missing > 0)) continue;
        ContactVector row = ContactVector::Zero(n), turn = row;
        if (const std::optional<int> pressing = problem_.pressing_row(i)) {
          row += law.static_friction * R.row(*pressing).transpose();
        }
        for (int j = 0, own = problem_.bearing_row(i); j < law.bearing && (one_way || N > 0); ++j, ++own) {
          row += law.static_friction * (one_way ? way[as(j)] : bearing[as(j)] / N) * (problem_.S.row(own) * R).transpose();
        }
        for (int j = 0; j < law.tangents && length > 0; ++j) turn += r(t + j) / length * R.row(t + j).transpose();
        row -= turn;
        add(left, size, row);
        if (slopes && length > 0) {
          const double bends = missing / (length * size);
          for (int j = 0; j < law.tangents; ++j) hessian += bends * R.row(t + j).transpose() * R.row(t + j);
          hessian -= bends * turn * turn.transpose();
        }
      }
      if (assumed.friction == Friction::slides && !assumed.direction_given) {
        double along = 0;
        ContactVector row = ContactVector::Zero(n);
        for (int j = 0; j < law.tangents; ++j) {
          along += assumed.direction[as(j)] * u(t + j);
          row += assumed.direction[as(j)] * U.row(t + j).transpose();
        }
        add(along, of_friction(i, motion), row);
      }
    }
    return sum;
  };
  // What nothing misses has no curvature, and there may be more of it than of what is missed: a part of the largest curvature
  // is added in all directions, more where a step then leads nowhere.
  double now = value(z, true), added = 1e-9;
  for (int step = 0; step < 100 && now > 0; ++step) {
    const double largest = hessian.diagonal().maxCoeff();
    ContactVector change;
    double slope = 0, part = 1, next = now;
    for (; added <= 1; added *= 1000) {
      ContactMatrix damped = hessian;
      damped.diagonal().array() += added * largest;
      change = damped.ldlt().solve(gradient);
      slope = gradient.dot(change);
      if (!(slope > 0) || !change.allFinite()) continue;
      part = 1;
      next = value(z - change, false);
      while (part > 1e-3 && !(next <= now - 0.25 * part * slope)) {
        part /= 2;
        next = value(z - part * change, false);
      }
      if (next < now) break;
    }
    if (!(next < now)) break;
    z -= part * change;
    now = value(z, true);
    added = std::max(1e-12, added / 1000);
  }
  system.x() = start + Z * z;
  const ContactVector r = system.reactions();
  const bool inside = margin > 0 && now <= margin * margin / 8;  // no part of the sum, a square over two, is more
  return {hold(r, problem_.W * r + problem_.q, 1e-12), inside};
}

}  // namespace torsor::runtime
