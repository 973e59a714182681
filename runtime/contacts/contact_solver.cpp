// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/regime_enumeration.hpp"

namespace torsor::runtime {
namespace {

class ContactIteration {
 public:
  using Regimes = RegimeSystem::Regimes;
  using Friction = AssumedRegime::Friction;

  ContactIteration(const ContactProblem& problem, const ContactVector& start, const ContactSolverOptions& options) noexcept
      : problem_(problem), scale_(problem), options_(options), r_(start) {}

  /// Whether what the start proposes holds: what held in the step before holds in most.
  [[nodiscard]] bool holds(RegimeEnumeration& regimes) const noexcept { return !r_.isZero(0) && tries(regimes); }

  [[nodiscard]] ContactAnswer run() noexcept {
    RegimeEnumeration regimes(problem_);
    if (holds(regimes)) return regimes.finish();
    mark();
    for (int attempt = 0; attempt < options_.attempts; ++attempt) {
      for (int sweep = 0; sweep < options_.sweeps; ++sweep) {
        if (!(this->sweep() > 1e-15)) break;
      }
      if (!r_.allFinite()) r_.setZero();
      if (tries(regimes) || stagnates()) break;
    }
    return regimes.finish();
  }

 private:
  static std::size_t as(int i) noexcept { return static_cast<std::size_t>(i); }

  // Each contact in turn; the largest change over the largest reaction of its group.
  double sweep() noexcept {
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

  void mark() noexcept {
    marked_ = r_;
    since_ = 0;
  }

  // Whether further sweeps propose nothing new. They are a map of the reactions alone: from where they have been they go the
  // same way again, which marks at doubled distances notice whatever the length of the cycle (Brent). Reactions that run away
  // until q is below the rounding of W r are multiplied by that map, and where their direction stays, it stays for ever.
  bool stagnates() noexcept {
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
  [[nodiscard]] bool tries(RegimeEnumeration& regimes) const noexcept {
    const Regimes found = proposed();
    Regimes resting = found;
    const ContactVector u = problem_.W * r_ + problem_.q;
    const ContactVector sizes = scale_.motions(problem_.W.cwiseAbs() * r_.cwiseAbs() + problem_.q.cwiseAbs());
    bool any = false;
    for (int i = 0; i < problem_.count; ++i) {
      const ContactLaw& law = problem_.law(i);
      const auto rests = [&](int row) { return std::abs(u(row)) <= 1e-9 * sizes(row); };
      const bool idle = law.normal && !found[as(i)].pressed && rests(problem_.first_row(i));
      if ((found[as(i)].friction != Friction::slides && !idle) || law.slips) continue;
      bool moves = false;
      for (int k = 0, t = problem_.tangent_row(i); k < law.tangents; ++k, ++t) moves = moves || !rests(t);
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
  [[nodiscard]] Regimes proposed() const noexcept {
    Regimes regimes{};
    const ContactVector u = problem_.W * r_ + problem_.q;
    for (int i = 0; i < problem_.count; ++i) {
      const ContactLaw& law = problem_.law(i);
      AssumedRegime& regime = regimes[as(i)];
      const int t = problem_.tangent_row(i);
      double N = 0;
      if (const std::optional<int> pressing = problem_.pressing_row(i)) {
        const double W = problem_.W(*pressing, *pressing);
        N = std::max(0.0, W > 0 ? r_(*pressing) - u(*pressing) / W : r_(*pressing));
        regime.pressed = law.normal && N > 0;
      }
      if (law.bearing > 0) {
        N = problem_.pressing(i, r_);
        regime.along = problem_.bearing(i, r_);
      }
      const double bound = std::max(law.friction * N + law.bound, law.static_friction * N + law.static_bound);
      if (!(law.tangents > 0 && bound > 0)) continue;
      if (law.slips) {
        regime.friction = Friction::slides;
        regime.direction = law.slip;
        regime.direction_given = true;
        continue;
      }
      double largest = problem_.W(t, t);
      if (law.tangents == 2) largest = std::max(largest, problem_.W(t + 1, t + 1));
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

  const ContactProblem& problem_;
  const ContactScale scale_;
  const ContactSolverOptions options_;
  ContactVector r_, marked_;
  int since_ = 0, distance_ = 1;  ///< attempts since the mark, and until the next one
};

// Whether every motion has one of the regimes that are tried one by one: where no direction is sought, which Newton's method
// may miss. Sweeps propose nothing else.
bool tries_all(const ContactProblem& problem) noexcept {
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    if (law.bearing > 0 || (law.tangents == 2 && law.rubs() && !law.slips)) return false;
  }
  return true;
}

}  // namespace

ContactAnswer iterate_contacts(const ContactProblem& problem, const ContactVector& start,
                               const ContactSolverOptions& options) noexcept {
  return ContactIteration(problem, start, options).run();
}

ContactAnswer go_on_contacts(const ContactProblem& problem, const ContactVector& start,
                             const ContactSolverOptions& options) noexcept {
  if (problem.count > options.enumerated) return iterate_contacts(problem, start, options);
  // Sweeps may take thousands to settle, or go round for ever, where to try all regimes takes as long as some ten.
  RegimeEnumeration regimes(problem);
  const bool few = tries_all(problem) && regimes.combinations() <= 256;
  if (few && ContactIteration(problem, start, options).holds(regimes)) return regimes.finish();
  ContactSolverOptions short_options = options;
  short_options.attempts = std::min(options.attempts, 4);
  const ContactAnswer answer = few ? ContactAnswer{} : iterate_contacts(problem, start, short_options);
  return answer ? answer : solve_contacts(problem, options);
}

ContactAnswer solve_contacts(const ContactProblem& problem, const ContactSolverOptions& options) noexcept {
  if (problem.count <= options.enumerated) {
    ContactAnswer answer = RegimeEnumeration(problem).run();
    if (answer || tries_all(problem)) return answer;
  }
  const ContactAnswer answer = iterate_contacts(problem, ContactVector::Zero(problem.rows()), options);
  // Where many slips begin together more starts take seconds.
  const bool few = problem.count <= std::min(options.enumerated, 4);
  return answer || !few ? answer : RegimeEnumeration(problem).run(true);
}

}  // namespace torsor::runtime
