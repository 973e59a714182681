// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/regime_enumeration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/contacts/regime_inequalities.hpp"
#include "torsor/runtime/contacts/slip_direction.hpp"

namespace torsor::runtime {

ContactAnswer RegimeEnumeration::run(bool thoroughly) noexcept {
  thoroughly_ = thoroughly;
  tried_ = true;
  complete_ = bearings_ <= 3;  // of more joints R is looked for from one side
  try_all();
  // Where bounds leave one place alone, rounding may hide it in the regimes that stand for others.
  if (answer_.count == 0 && left_out_) {
    relates_ = false;
    try_all();
  }
  return finish();
}

void RegimeEnumeration::try_all() noexcept {
  PerContact<int> choice{};
  for (bool more = true; more;) {
    Regimes regimes{};
    for (int i = 0; i < problem_.count; ++i) regimes[as(i)] = choose(problem_.law(i), choice[as(i)]);
    try_regimes(regimes);
    more = false;
    for (int i = 0; i < problem_.count && !more; ++i) {
      more = ++choice[as(i)] < choices(problem_.law(i));
      if (!more) choice[as(i)] = 0;
    }
  }
}

bool RegimeEnumeration::try_from(Regimes regimes, const ContactVector& near) noexcept {
  const std::size_t before = answer_.count;
  const int sought = count_sought(regimes);
  if (sought == 0) {
    try_regimes(regimes);
    return answer_.count > before;
  }
  // Where reactions are not unique, others than those near by may give the slips other directions, and be outside their bounds.
  PerContact<bool> begins{};
  for (int i = 0; i < problem_.count; ++i) begins[as(i)] = regimes[as(i)].direction_sought;
  Regimes aligned = regimes;
  if (near.size() > 0 && align_slips(problem_, aligned, {.begins = begins, .held = near})) {
    accept(aligned, &near);
  }
  if (answer_.count == before && turn_to_slip(regimes)) accept(regimes);
  return answer_.count > before;
}

ContactAnswer RegimeEnumeration::finish() noexcept {
  auto& found = answer_.solutions;
  // The sizes of two motions that differ by rounding are equal: then the order of regimes decides.
  const ContactVector given = given_motions(problem_, scale_);
  // What slips on in all of them is not at rest: how its slip changes says nothing of what begins to move.
  PerContact<bool> slips_on{};
  for (int i = 0; i < problem_.count; ++i) {
    slips_on[as(i)] = problem_.law(i).slips;
    for (std::size_t k = 0; k < answer_.count; ++k) {
      slips_on[as(i)] = slips_on[as(i)] && found[k].regimes[as(i)] == ContactRegime::slides;
    }
  }
  const auto motion = [&](const ContactSolution& s) {
    double squares = 0;
    const auto add = [&](int row) {
      if (s.u(row) != 0) squares += s.u(row) * s.u(row) / (given(row) * given(row));
    };
    for (int i = 0; i < problem_.count; ++i) {
      const ContactLaw& law = problem_.law(i);
      if (law.normal) add(problem_.first_row(i));
      for (int k = 0; !slips_on[as(i)] && k < law.tangents; ++k) add(problem_.tangent_row(i) + k);
    }
    return std::sqrt(squares);
  };
  for (std::size_t i = 1; i < answer_.count; ++i) {
    for (std::size_t j = i; j > 0 && motion(found[j]) < motion(found[j - 1]) * (1 - 1e-9); --j) {
      std::swap(found[j], found[j - 1]);
    }
  }
  // Of motions without a gap between them one inside is taken, not an end, where a contact that closes does not press.
  for (std::size_t j = 1; j < answer_.count; ++j) {
    if (motion(found[0]) > 0 && (found[j].moves || is_close(found[0], found[j])) && ends(found[0], found[j])) {
      std::swap(found[0], found[j]);
    }
  }
  if (answer_.count == 0) {
    answer_.verdict = complete_ ? ContactVerdict::none : ContactVerdict::not_found;
  } else if (answer_.count > 1 || moves_) {
    answer_.verdict = ContactVerdict::several;
  } else if (found[0].indeterminate) {
    answer_.verdict = ContactVerdict::indeterminate;
  } else {
    answer_.verdict = tried_ || is_convex() ? ContactVerdict::unique : ContactVerdict::not_examined;
  }
  return answer_;
}

bool RegimeEnumeration::is_convex() const noexcept {
  for (int i = 0; i < problem_.count; ++i) {
    const ContactLaw& law = problem_.law(i);
    if (!law.rubs()) continue;
    if (law.friction > 0 || law.static_friction > 0 || law.static_bound > law.bound) return false;
  }
  return true;
}

// Whether one has the regimes of the other but for contacts that are open. Or what the other presses touches in it without a
// force, and none of that leaves: there reactions that the other leaves open come to their bounds, whatever sticks or slides.
bool RegimeEnumeration::ends(const ContactSolution& one, const ContactSolution& other) const noexcept {
  const ContactVector sizes = scale_.motions(problem_.W.cwiseAbs() * one.r.cwiseAbs() + problem_.q.cwiseAbs());
  bool same = true, stays = false, leaves = false;
  for (int i = 0; i < problem_.count; ++i) {
    const ContactRegime regime = one.regimes[as(i)];
    same = same && (regime == other.regimes[as(i)] || regime == ContactRegime::open);
    if (regime != ContactRegime::open || other.regimes[as(i)] == ContactRegime::open || !problem_.law(i).normal) continue;
    const int n = problem_.first_row(i);
    (one.u(n) <= slack * sizes(n) ? stays : leaves) = true;
  }
  return same || (stays && !leaves);
}

// Whether two motions are as good as one, but for what the search for directions may be off by.
bool RegimeEnumeration::is_close(const ContactSolution& one, const ContactSolution& other) const noexcept {
  const ContactVector sizes = scale_.motions(problem_.W.cwiseAbs() * one.r.cwiseAbs() + problem_.q.cwiseAbs());
  return largest_part(one.u - other.u, sizes) <= 1e-4;
}

bool RegimeEnumeration::open_rubs(const ContactLaw& law) noexcept {
  return law.tangents > 0 && (law.bound > 0 || law.static_bound > 0);
}

// What friction may do: nothing; sliding as given; sticking and sliding, in the plane to either side. Sliding in a bearing
// may have R on either side too.
int RegimeEnumeration::frictions(const ContactLaw& law) const noexcept {
  const int sides = law.bearing > 0 && bearings_ <= 3 ? 2 : 1;
  if (!law.rubs()) return 1;
  if (law.slips) return sides;
  return law.tangents == 1 ? 1 + 2 * sides : 2;
}

int RegimeEnumeration::choices(const ContactLaw& law) const noexcept {
  if (!law.normal) return frictions(law);
  return frictions(law) + (open_rubs(law) ? frictions(law) : 1);
}

double RegimeEnumeration::combinations() const noexcept {
  double product = 1;
  for (int i = 0; i < problem_.count; ++i) product *= choices(problem_.law(i));
  return product;
}

AssumedRegime RegimeEnumeration::choose(const ContactLaw& law, int choice) const noexcept {
  AssumedRegime regime;
  regime.pressed = law.normal && choice < frictions(law);
  const bool rubs = law.rubs() && (!law.normal || regime.pressed || open_rubs(law));
  if (!rubs) return regime;
  const int friction = choice % frictions(law);
  if (law.slips) {
    regime.friction = Friction::slides;
    regime.direction = law.slip;
    regime.direction_given = true;
    regime.reversed = friction == 1;
  } else if (friction == 0) {
    regime.friction = Friction::sticks;
  } else {
    regime.friction = Friction::slides;
    regime.direction = {friction % 2 == 1 ? 1.0 : -1.0, 0.0};
    regime.reversed = friction > 2;
    regime.direction_sought = law.tangents == 2;
  }
  return regime;
}

int RegimeEnumeration::count_sought(const Regimes& regimes) const noexcept {
  int sought = 0;
  for (int i = 0; i < problem_.count; ++i) sought += regimes[as(i)].direction_sought ? 1 : 0;
  return sought;
}

void RegimeEnumeration::accept(Regimes regimes, const ContactVector* near) noexcept {
  RegimeSystem system(problem_, scale_, regimes);
  if (!system.solve()) return;
  const RegimeInequalities inequalities(problem_, scale_, system);
  ContactVector r = system.reactions(), u = problem_.W * r + problem_.q;
  Family family;
  if (system.kernel().cols() > 0) {
    family = look_inside(system, inequalities);
    if (!family.found && near != nullptr) system.approach(*near);
    if (family.found || near != nullptr) {
      r = system.reactions();
      u = problem_.W * r + problem_.q;
    }
  }
  if (system.kernel().cols() > 0 && count_sought(regimes) > 0) turn_to_family(regimes, r, u, family);
  if (!inequalities.hold(r, u, slack)) return;
  ContactSolution solution;
  solution.indeterminate = family.indeterminate;
  solution.moves = family.moves;
  tidy(regimes, r, u, solution);
  if (!(solution.residual <= 1e-9)) return;
  moves_ = moves_ || family.moves;
  add(solution);
}

// Reactions inside all bounds leave room for others; where only the bounds fit, they are taken as they are. Those
// farthest inside are looked for: they will do for longest.
RegimeEnumeration::Family RegimeEnumeration::look_inside(RegimeSystem& system, const RegimeInequalities& inequalities) const noexcept {
  const ContactVector start = system.x();
  RegimeInequalities::Room room;
  const auto fits = [&](double margin) {
    system.x() = start;
    room = inequalities.find(system, margin);
    return room.holds;
  };
  Family family;
  family.found = fits(0.1);
  if (!family.found && fits(0)) {
    double margin = 1e-3;
    while (margin > 1e-12 && !fits(margin)) margin /= 10;
    family.found = margin > 1e-12 || fits(0);
  }
  if (!family.found) return family;
  // Bounds may leave one place alone, as of slips that any other reactions would turn against their direction.
  const ContactVector farthest = system.x();
  for (double margin = 0.1; !room.inside && margin > 1e-5;) fits(margin /= 10);
  family.indeterminate = room.holds && room.inside;
  system.x() = farthest;
  if (!family.indeterminate) return look_beside(system, inequalities);
  for (Eigen::Index k = 0; k < system.kernel().cols(); ++k) {
    family.moves = family.moves || moves_by(system.B() * system.kernel().col(k));
  }
  return family;
}

// Where one contact has one reaction alone, as one that no equilibrium presses, no reactions are inside all bounds, and those of
// others may vary for all that. From far away along each way that the equations leave bounds are met in other places.
RegimeEnumeration::Family RegimeEnumeration::look_beside(RegimeSystem& system,
                                                         const RegimeInequalities& inequalities) const noexcept {
  Family family{.found = true};
  const ContactVector place = system.x(), reactions = system.reactions(), force = scale_.forces(reactions);
  for (Eigen::Index k = 0; k < system.kernel().cols() && !family.indeterminate; ++k) {
    const ContactVector way = system.B() * system.kernel().col(k);
    const double reach = largest_part(way, force);
    if (!(reach > 0 && std::isfinite(reach))) continue;
    for (const double sign : {1.0, -1.0}) {
      system.x() = place + sign / reach * system.kernel().col(k);
      if (!inequalities.find(system, 0).holds) continue;
      const ContactVector change = system.reactions() - reactions;
      if (!(largest_part(change, force) > 1e-5)) continue;
      family.indeterminate = true;
      family.moves = family.moves || moves_by(change);
    }
  }
  system.x() = place;
  return family;
}

// Whether forces along these change the motion.
bool RegimeEnumeration::moves_by(const ContactVector& forces) const noexcept {
  const ContactVector change = problem_.W * forces, terms = problem_.W.cwiseAbs() * forces.cwiseAbs();
  return largest_part(change, scale_.motions(terms)) > 1e-9;
}

// Slips that begin have the directions of one choice of reactions, and others turn them. Reactions far inside all bounds are looked
// for with directions that follow. Where none are, directions follow what was found, or stay where the bounds do not hold then.
void RegimeEnumeration::turn_to_family(Regimes& regimes, ContactVector& r, ContactVector& u, Family& family) const noexcept {
  PerContact<bool> sought{};
  for (int i = 0; i < problem_.count; ++i) sought[as(i)] = regimes[as(i)].direction_sought;
  const auto takes = [&](const ContactVector& near, double margin) {
    Regimes turned = regimes;
    if (!align_slips(problem_, turned, {.begins = sought, .held = near})) return false;
    RegimeSystem system(problem_, scale_, turned);
    if (!system.solve()) return false;
    system.approach(near);
    const RegimeInequalities inequalities(problem_, scale_, system);
    const ContactVector reactions = system.reactions(), motion = problem_.W * reactions + problem_.q;
    if (!inequalities.hold(reactions, motion, slack)) return false;
    // These reactions must lie inside themselves: others would turn the slips, for which the directions were found.
    const ContactVector place = system.x();
    if (margin > 0 && !(inequalities.find(system, margin / 4).inside && system.x() == place)) return false;
    regimes = turned;
    r = reactions;
    u = motion;
    if (margin == 0) return true;
    family.found = family.indeterminate = true;
    for (Eigen::Index k = 0; k < system.kernel().cols(); ++k) {
      family.moves = family.moves || moves_by(system.B() * system.kernel().col(k));
    }
    return true;
  };
  // A motion that no reactions hold yet is looked for at two distances from their bounds: there are many such combinations.
  const double least = family.found ? 1e-6 : 1e-4, part = family.found ? 10 : 100;
  for (double margin = 0.1; margin > least; margin /= part) {
    RegimeSystem system(problem_, scale_, regimes);
    if (!system.solve()) break;
    system.approach(r);
    (void)RegimeInequalities(problem_, scale_, system).find(system, margin);
    if (takes(system.reactions(), margin)) return;
  }
  if (family.found) (void)takes(ContactVector(r), 0);
}

// What the laws give without rounding is put in place: no negative force, none outside its bound, u = 0 where it
// sticks.
void RegimeEnumeration::tidy(const Regimes& regimes, ContactVector& r, ContactVector& u, ContactSolution& solution) const noexcept {
  for (int i = 0; i < problem_.count; ++i) {
    const ContactLaw& law = problem_.law(i);
    const AssumedRegime& assumed = regimes[as(i)];
    const int n = problem_.first_row(i), t = problem_.tangent_row(i);
    solution.regimes[as(i)] = assumed.regime();
    if (law.normal) {
      r(n) = assumed.pressed ? std::max(0.0, r(n)) : 0.0;
      u(n) = assumed.pressed ? 0.0 : std::max(0.0, u(n));
    }
    const double N = problem_.pressing(i, r);
    if (assumed.friction == Friction::sticks) {
      const double radius = law.static_friction * N + law.static_bound;
      double length = 0;
      for (int k = 0; k < law.tangents; ++k) length = std::hypot(length, r(t + k));
      for (int k = 0; k < law.tangents; ++k) {
        u(t + k) = 0;
        if (length > radius) r(t + k) *= radius / length;
      }
    }
    if (assumed.friction == Friction::slides) {
      for (int k = 0; k < law.tangents; ++k) r(t + k) = -(law.friction * N + law.bound) * assumed.direction[as(k)];
    }
  }
  solution.r = r;
  solution.u = u;
  solution.residual = natural_map_residual(problem_, solution);
}

void RegimeEnumeration::add(const ContactSolution& solution) noexcept {
  if (problem_.rows() == 0) {
    answer_.solutions[0] = solution;
    answer_.count = 1;
    return;
  }
  // The motion of the larger forces is known less well, whichever was found first.
  const auto size_of = [this](const ContactSolution& s) {
    return scale_.motions(problem_.W.cwiseAbs() * s.r.cwiseAbs() + problem_.q.cwiseAbs());
  };
  const ContactVector size = size_of(solution), force = scale_.forces(solution.r);
  for (std::size_t i = 0; i < answer_.count; ++i) {
    auto& known = answer_.solutions[i];
    const ContactVector size_of_known = size_of(known);
    if (largest_part(known.u - solution.u, size.cwiseMax(size_of_known)) > 1e-9) continue;
    const bool differ = largest_part(known.r - solution.r, force.cwiseMax(scale_.forces(known.r))) > 1e-9;
    const bool indeterminate = known.indeterminate || solution.indeterminate || differ;
    // Where a slip begins slowly, a contact may stand against it with a force that rounding allows: the slip would turn
    // round at once.
    const bool worse = known.residual > 1e-14 && solution.residual < known.residual / 16;
    const bool without_need = differ && largest_part(size_of_known, size) > 1e3;
    if (worse || without_need) known = solution;
    known.indeterminate = indeterminate;
    return;
  }
  if (answer_.count < answer_.kept) answer_.solutions[answer_.count++] = solution;
}

}  // namespace torsor::runtime
