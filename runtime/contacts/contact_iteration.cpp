// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_iteration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace torsor::runtime {
namespace {

// Friction of a part of what the laws say.
ContactProblem with_friction(const ContactProblem& problem, double part) noexcept {
  ContactProblem less = problem;
  for (int i = 0; i < problem.count; ++i) {
    ContactLaw& law = less.laws[static_cast<std::size_t>(i)];
    for (double* each : {&law.friction, &law.static_friction, &law.bound, &law.static_bound}) *each *= part;
  }
  return less;
}

}  // namespace

ContactAnswer ContactIteration::run() noexcept {
  RegimeEnumeration regimes(problem_);
  if (!holds(regimes) && !rests(regimes)) sweep_until(regimes);
  return regimes.finish();
}

// Where all or some can rest a motion may be as well. Steps from no reactions come to rest where friction is large, though the
// regimes of a motion with less friction hold too: from those of less and less of it the first other motion is taken. From those
// of more of it, what can rest may be held where steps from nothing let it go.
ContactAnswer ContactIteration::solve() noexcept {
  RegimeEnumeration regimes(problem_), of_parts(problem_);
  const bool rest = rests(regimes);
  RegimeEnumeration& proposals = rest ? regimes : of_parts;
  bool rubs = false;
  for (int i = 0; i < problem_.count; ++i) rubs = rubs || (problem_.law(i).rubs() && !problem_.law(i).slips);
  r_.setZero(problem_.rows());
  (void)step_together(problem_, proposals, 6400);
  if (!rest && rubs) hold_what_rests(proposals);
  double part = 1;
  for (int less = 0; rubs && proposals.only_rests() && less < (rest ? 8 : 4); ++less) {
    r_.setZero();
    (void)step_together(with_friction(problem_, part *= 0.8), proposals, 800);
  }
  if (rest) return regimes.finish();
  // What rests does so on all of its contacts.
  const ContactAnswer found = of_parts.finish();
  for (std::size_t k = 0; k < found.count; ++k) {
    r_ = found.solutions[k].r;
    if (!tries(problem_, regimes)) regimes.take(found.solutions[k]);
  }
  if (found.count == 0) {
    r_.setZero(problem_.rows());
    sweep_until(regimes);
  }
  return regimes.finish();
}

// Whether reactions exist by which all contacts stay closed, and stick or go on to slide: a convex problem but for joints that
// their own reaction presses.
bool ContactIteration::rests(RegimeEnumeration& regimes) const noexcept {
  Regimes closed{};
  for (int i = 0; i < problem_.count; ++i) {
    const ContactLaw& law = problem_.law(i);
    AssumedRegime& regime = closed[as(i)];
    regime.pressed = law.normal;
    if (!law.rubs()) continue;
    regime.friction = law.slips ? Friction::slides : Friction::sticks;
    regime.direction = law.slip;
    regime.direction_given = law.slips;
  }
  return regimes.try_from(closed);
}

// Where not all can rest a part may: with more friction steps hold all that may stick, and from these reactions, with the
// friction that there is, they go on to hold what can be held.
void ContactIteration::hold_what_rests(RegimeEnumeration& proposals) noexcept {
  r_.setZero();
  (void)step_together(with_friction(problem_, 8), proposals, 400);
  if (r_.allFinite()) (void)step_together(problem_, proposals, 800);
}

// Steps of all contacts at once, r = the projection of r - ρ u on what the laws allow. They do not depend on the order of
// contacts. ρ is one over the sum of sizes in the row of W, which makes them converge where W is all: D - W is positive
// semidefinite. Whether the regimes of a motion that is not yet known were found. They are looked at after 200 steps, and after
// twice as many, up to the longest run.
bool ContactIteration::step_together(const ContactProblem& problem, RegimeEnumeration& regimes, int longest) noexcept {
  const int rows = problem.rows();
  ContactVector rho = ContactVector::Zero(rows), u(rows), before(rows);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) rho(i) += std::abs(problem.W(i, j)) / scale_.unit(j);
    rho(i) = rho(i) > 0 ? 1 / (rho(i) * scale_.unit(i)) : 0;
  }
  PerContact<int> first{};  // its first tangential row
  for (int i = 0; i < problem.count; ++i) first[as(i)] = problem.tangent_row(i);
  for (int steps = 200; steps <= longest; steps *= 2) {
    bool moves = true;
    for (int step = 1; step <= steps && moves; ++step) {
      before = r_;
      u.noalias() = problem.W * r_;
      u += problem.q;
      for (int i = 0; i < problem.count; ++i) step_one(problem, i, first[as(i)], u, rho);
      if (step % 16 == 0) moves = largest_part(r_ - before, scale_.forces(r_)) > 1e-15;
    }
    if (!r_.allFinite()) return false;
    if (tries(problem, regimes)) return true;
    if (!moves) return false;
  }
  return false;
}

void ContactIteration::step_one(const ContactProblem& problem, int i, int t, const ContactVector& u,
                                const ContactVector& rho) noexcept {
  const ContactLaw& law = problem.law(i);
  if (law.normal) r_(t - 1) = std::max(0.0, r_(t - 1) - rho(t - 1) * u(t - 1));
  if (law.tangents == 0) return;
  const double N = law.normal ? r_(t - 1) : problem.pressing(i, r_), bound = law.friction * N + law.bound;
  if (law.slips) {
    for (int k = 0; k < law.tangents; ++k) r_(t + k) = -bound * law.slip[as(k)];
    return;
  }
  const double rate = law.tangents == 2 ? std::min(rho(t), rho(t + 1)) : rho(t);
  for (int k = 0; k < law.tangents; ++k) r_(t + k) -= rate * u(t + k);
  const double length = law.tangents == 2 ? std::hypot(r_(t), r_(t + 1)) : std::abs(r_(t));
  if (length <= law.static_friction * N + law.static_bound) return;
  for (int k = 0; k < law.tangents; ++k) r_(t + k) *= bound / length;
}

void ContactIteration::sweep_until(RegimeEnumeration& regimes) noexcept {
  mark();
  for (int attempt = 0; attempt < options_.attempts; ++attempt) {
    for (int sweep = 0; sweep < options_.sweeps; ++sweep) {
      if (!(this->sweep() > 1e-15)) break;
    }
    if (!r_.allFinite()) r_.setZero();
    if (tries(problem_, regimes) || stagnates()) break;
  }
}

// Each contact in turn; the largest change over the largest reaction of its group.
double ContactIteration::sweep() noexcept {
  const ContactVector before = r_;
  for (int i = 0; i < problem_.count; ++i) {
    const int first = problem_.first_row(i), rows = problem_.law(i).rows();
    ContactProblem one;
    one.count = 1;
    one.laws[0] = problem_.law(i);
    if (one.laws[0].pressed_by || one.laws[0].bearing > 0) {  // by a force that is held, too
      const double N = problem_.pressing(i, r_);
      one.laws[0].pressed_by.reset();
      one.laws[0].bearing = 0;
      one.laws[0].bound += one.laws[0].friction * N;
      one.laws[0].static_bound += one.laws[0].static_friction * N;
      one.laws[0].friction = one.laws[0].static_friction = 0;
    }
    one.W = problem_.W.block(first, first, rows, rows);
    one.q =
        problem_.q.segment(first, rows) + problem_.W.middleRows(first, rows) * r_ - one.W * r_.segment(first, rows);
    const ContactAnswer answer = RegimeEnumeration(one).run();
    if (!answer) continue;
    r_.segment(first, rows) = answer.best().r;
  }
  return largest_part(r_ - before, scale_.forces(r_));
}

void ContactIteration::mark() noexcept {
  marked_ = r_;
  since_ = 0;
}

// Whether further sweeps propose nothing new. They are a map of the reactions alone: from where they have been they go the
// same way again, which marks at doubled distances notice whatever the length of the cycle (Brent). Reactions that run away
// until q is below the rounding of W r are multiplied by that map, and where their direction stays, it stays for ever.
bool ContactIteration::stagnates() noexcept {
  if (r_ == marked_) return true;
  ContactVector now = r_, before = marked_, given = problem_.q;
  for (int i = 0; i < static_cast<int>(now.size()); ++i) {
    now(i) *= scale_.unit(i);
    before(i) *= scale_.unit(i);
    given(i) /= scale_.unit(i);
  }
  const double size = now.cwiseAbs().maxCoeff(), least = before.cwiseAbs().maxCoeff();
  const bool runs_away = least * 1e-16 > given.cwiseAbs().maxCoeff() && size > 2 * least;
  if (runs_away && (now / size - before / least).cwiseAbs().maxCoeff() <= 1e-13) return true;
  if (++since_ < distance_) return false;
  distance_ *= 2;
  mark();
  return false;
}

// Reactions that are not unique may be at their bounds where nothing moves. A contact that slides at no speed sticks as
// well, and one that does not open presses as well: no slip begins of a body that rests, on as many supports as it has.
bool ContactIteration::tries(const ContactProblem& problem, RegimeEnumeration& regimes) const noexcept {
  const Regimes found = proposed(problem);
  Regimes resting = found;
  const ContactVector u = problem.W * r_ + problem.q;
  const ContactVector sizes = scale_.motions(problem.W.cwiseAbs() * r_.cwiseAbs() + problem.q.cwiseAbs());
  bool any = false;
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    const auto rests = [&](int row) { return std::abs(u(row)) <= 1e-9 * sizes(row); };
    const bool idle = law.normal && !found[as(i)].pressed && rests(problem.first_row(i));
    if ((found[as(i)].friction != Friction::slides && !idle) || law.slips) continue;
    bool moves = false;
    for (int k = 0, t = problem.tangent_row(i); k < law.tangents; ++k, ++t) moves = moves || !rests(t);
    if (moves && law.rubs()) continue;
    if (idle) resting[as(i)].pressed = any = true;
    if (!law.rubs()) continue;
    resting[as(i)].friction = Friction::sticks;
    resting[as(i)].direction_sought = false;
    any = true;
  }
  return (any && regimes.try_from(resting, r_)) || regimes.try_from(found, r_);
}

// What the natural map says of each contact at the present reactions.
ContactIteration::Regimes ContactIteration::proposed(const ContactProblem& problem) const noexcept {
  Regimes regimes{};
  const ContactVector u = problem.W * r_ + problem.q;
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    AssumedRegime& regime = regimes[as(i)];
    const int t = problem.tangent_row(i);
    double N = 0;
    if (const std::optional<int> pressing = problem.pressing_row(i)) {
      const double W = problem.W(*pressing, *pressing);
      N = std::max(0.0, W > 0 ? r_(*pressing) - u(*pressing) / W : r_(*pressing));
      regime.pressed = law.normal && N > 0;
    }
    if (law.bearing > 0) {
      N = problem.pressing(i, r_);
      regime.along = problem.bearing(i, r_);
    }
    const double bound = std::max(law.friction * N + law.bound, law.static_friction * N + law.static_bound);
    if (!(law.tangents > 0 && bound > 0)) continue;
    if (law.slips) {
      regime.friction = Friction::slides;
      regime.direction = law.slip;
      regime.direction_given = true;
      continue;
    }
    double largest = problem.W(t, t);
    if (law.tangents == 2) largest = std::max(largest, problem.W(t + 1, t + 1));
    std::array<double, 2> trial{};
    for (int k = 0; k < law.tangents; ++k) trial[as(k)] = r_(t + k) - (largest > 0 ? u(t + k) / largest : 0);
    const double length = std::hypot(trial[0], trial[1]);
    if (length <= law.static_friction * N + law.static_bound || !(length > 0)) {
      regime.friction = Friction::sticks;
    } else {
      regime.friction = Friction::slides;
      regime.direction = {-trial[0] / length, -trial[1] / length};
      regime.direction_sought = law.tangents == 2;
    }
  }
  return regimes;
}

}  // namespace torsor::runtime
