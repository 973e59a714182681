// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/contact_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "torsor/runtime/contacts/contact_scale.hpp"
#include "torsor/runtime/contacts/slip_direction.hpp"

namespace torsor::runtime {
namespace {

// The terms of an acceleration along a row of J, without reactions.
double terms_along(const ContactReading& reading, const ContactDynamics& dynamics, int row) noexcept {
  double sum = std::abs(reading.drift(row));
  for (Eigen::Index j = 0; j < dynamics.a0.size(); ++j) sum += std::abs(reading.J(row, j) * dynamics.a0(j));
  return sum;
}

}  // namespace

ContactMotion::ContactMotion(const ContactMechanism& mechanism)
    : mechanism_(mechanism), sizes_(mechanism.sizes()), gap_rounding_(mechanism) {
  for (int i = 0; i < count(); ++i) {
    rules_[as(i)] = mechanism.rule(i);
    first_row_[as(i) + 1] = first_row_[as(i)] + std::clamp(rule(i).rows(), 0, 3);  // a rule may be impossible
    first_bearing_[as(i) + 1] = first_bearing_[as(i)] + std::clamp(rule(i).bearing, 0, 2);
  }
  reading_ = later_reading_ = ContactReading(sizes_, rows(), first_bearing(count()));
  a_.setZero(sizes_.velocities);
  change_.setZero(sizes_.velocities);
  r_.setZero(rows());
  held_ = r_;
  there_.resize(static_cast<std::size_t>(sizes_.coordinates + sizes_.velocities));
  y_ = there_;
  from_ = there_;
  way_ = there_;
  loops_.setZero(sizes_.constraints);
  rates_.resize(static_cast<std::size_t>(sizes_.coordinates));
}

void ContactMotion::forget() {
  for (int i = 0; i < count(); ++i) rules_[as(i)] = mechanism_.rule(i);
  states.fill({});
  across_.fill(0);
  lag_.fill(0);
  stiff_.fill(false);
  undetermined_.fill(false);
  along_.fill({});
  held_.setZero(rows());
  jumping_.reset();
  followed_ = false;
  known_ = responded_ = solved_ = false;
  nearest_ = 1;
  dynamics_.forget();
  later_dynamics_.forget();
}

bool ContactMotion::take_rule(int i) {
  ContactRule now = mechanism_.rule(i);
  const bool other = !(now == rule(i));
  if (now.rows() != rule(i).rows() || now.bearing != rule(i).bearing) now.tangents = -1;  // there is no room for it
  if (other) rules_[as(i)] = now;
  return other;
}

Evaluation ContactMotion::slope(double t, std::span<const double> y, std::span<double> dydt) {
  const Evaluation evaluation = solve(t, y);
  const auto nq = as(sizes_.coordinates);
  mechanism_.coordinate_rates(t, y, dydt.first(nq));
  for (int i = 0; i < sizes_.velocities; ++i) dydt[nq + as(i)] = a_(i);
  return evaluation;
}

bool ContactMotion::any_touches() const noexcept {
  for (int i = 0; i < count(); ++i) {
    if (at(i).touches) return true;
  }
  return false;
}

bool ContactMotion::read(double t, std::span<const double> y) {
  if (known_ && t == t_ && std::equal(y_.begin(), y_.end(), y.begin())) return true;
  known_ = responded_ = solved_ = false;
  if (mechanism_.read(t, y, reading_) != Evaluation::ok) return false;
  const bool regular = dynamics_.compute(reading_);
  nearest_ = std::min(nearest_, dynamics_.distance());
  if (!regular || dynamics_.distance() < change_point_bounds::blind) return false;
  t_ = t;
  std::copy_n(y.begin(), y_.size(), y_.begin());
  // Rounding of rows asks for what loops do to them.
  if (sizes_.constraints > 0 && any_touches() && !respond()) return false;
  return known_ = true;
}

bool ContactMotion::respond() {
  if (responded_) return true;
  responded_ = dynamics_.respond(reading_);
  for (Eigen::Index k = 0; k < reading_.A.rows(); ++k) {
    loops_(k) = 0;
    for (int j = 0; j < sizes_.velocities; ++j) loops_(k) += std::abs(reading_.A(k, j) * y_[as(sizes_.coordinates + j)]);
  }
  return responded_;
}

const Eigen::MatrixXd& ContactMotion::W() {
  if (!respond()) dynamics_.W.setZero();
  return dynamics_.W;
}

void ContactMotion::add_answer(const ContactVector& impulses, std::span<double> y) {
  change_.setZero(sizes_.velocities);
  dynamics_.add_answer(impulses, change_);
  for (int i = 0; i < sizes_.velocities; ++i) y[as(sizes_.coordinates + i)] += change_(i);
}

bool ContactMotion::follows_forces(int i) const noexcept {
  return at(i).touches && at(i).regime == ContactRegime::slides && at(i).begins && rule(i).tangents == 2;
}

Evaluation ContactMotion::solve(double t, std::span<const double> y) {
  if (!read(t, y)) return Evaluation::singular;
  if (solved_) return Evaluation::ok;
  undetermined_.fill(false);
  regularity_ = 1;
  if (!any_touches()) {
    r_.setZero(rows());
    a_ = dynamics_.a0;
    solved_ = true;
    return Evaluation::ok;
  }
  if (!respond()) return Evaluation::singular;
  const ContactProblem problem = problem_of(reading_, dynamics_);
  Alignment alignment{.problem = problem};
  Regimes regimes{};
  bool any = false;
  for (int i = 0; i < count(); ++i) {
    const ContactState& state = at(i);
    AssumedRegime& regime = regimes[as(i)];
    if (!state.touches) continue;
    regime.pressed = problem.law(i).normal;
    if (problem.law(i).tangents == 0 || state.regime == ContactRegime::open) continue;
    regime.friction =
        state.regime == ContactRegime::sticks ? AssumedRegime::Friction::sticks : AssumedRegime::Friction::slides;
    regime.direction = direction(i);
    regime.along = along_[as(i)];
    alignment.begins[as(i)] = follows_forces(i);
    any = any || alignment.begins[as(i)];
  }
  unaligned_.fill(false);
  if (any) {
    const Evaluation aligned = align_or_keep(t, y, alignment, regimes);
    if (aligned != Evaluation::ok) return aligned;
  }
  const ContactScale scale(problem);
  RegimeSystem equations(problem, scale, regimes);
  if (!equations.solve()) return Evaluation::singular;
  equations.approach(held_);
  note_undetermined(equations, scale);
  for (int i = 0; i < count(); ++i) {
    if (rule(i).bearing > 0) along_[as(i)] = equations.along(i);
  }
  r_ = equations.reactions();
  if (busiest_slip() && equations.kernel().cols() == 0) regularity_ = equations.scaled_determinant();
  a_ = dynamics_.a0;
  dynamics_.add_answer(r_, a_);
  solved_ = true;
  return a_.allFinite() ? Evaluation::ok : Evaluation::not_finite;
}

std::optional<int> ContactMotion::busiest_slip() const noexcept {
  std::optional<int> busiest;
  double most = -1;
  for (int i = 0; i < count(); ++i) {
    if (!at(i).touches || at(i).regime != ContactRegime::slides || rule(i).tangents == 0) continue;
    const double power = friction_force(i) * slip_speed(i);
    if (power > most) {
      most = power;
      busiest = i;
    }
  }
  return busiest;
}

// A contact counts where its force, or the normal force that presses it, may be another.
void ContactMotion::note_undetermined(const RegimeSystem& equations, const ContactScale& scale) noexcept {
  if (equations.kernel().cols() == 0) return;
  ContactMatrix others = equations.B() * equations.kernel();
  ContactVector units(rows());
  for (int row = 0; row < rows(); ++row) units(row) = scale.unit(row);
  for (Eigen::Index k = 0; k < others.cols(); ++k) others.col(k) /= others.col(k).cwiseProduct(units).cwiseAbs().maxCoeff();
  for (int i = 0; i < count(); ++i) {
    const auto differs = [&](int row) { return units(row) * others.row(row).cwiseAbs().maxCoeff() > 1e-9; };
    bool any = rule(i).pressed_by && differs(first_row(*rule(i).pressed_by));
    for (int k = first_bearing(i); k < first_bearing(i + 1); ++k) {
      const ContactVector change = (dynamics_.S.row(k) * others).transpose();
      any = any || change.cwiseAbs().maxCoeff() > 1e-9 * dynamics_.S.row(k).transpose().cwiseQuotient(units).cwiseAbs().maxCoeff();
    }
    for (int k = 0; k < rule(i).rows(); ++k) any = any || differs(first_row(i) + k);
    undetermined_[as(i)] = any;
  }
}

// Of accelerations, all contacts taking part.
ContactProblem ContactMotion::problem_of(const ContactReading& reading, const ContactDynamics& dynamics) const {
  ContactProblem problem;
  problem.count = count();
  for (int i = 0; i < count(); ++i) problem.laws[as(i)] = rule(i).law();
  problem.W = dynamics.W;
  problem.q = reading.drift;
  problem.q.noalias() += reading.J * dynamics.a0;
  if (first_bearing(count()) > 0) {
    problem.S = dynamics.S;
    problem.c = dynamics.R_free;
  }
  problem.noise.resize(rows());
  for (int row = 0; row < rows(); ++row) problem.noise(row) = 1e-13 * terms_along(reading, dynamics, row);
  return problem;
}

double ContactMotion::directionless(int i) const noexcept {
  return std::max({64 * rounding_of(tangent_row(i)), 1e-12 * at(i).fastest, at(i).fades ? blur(i) : 0});
}

bool ContactMotion::turns_with_velocity(int i) const noexcept {
  return rule(i).tangents < 2 || (!at(i).begins && slip_speed(i) >= 2 * directionless(i));
}

std::array<double, 2> ContactMotion::direction(int i) const noexcept {
  const auto& last = at(i).direction;
  if (rule(i).tangents < 2 || at(i).begins) return last;
  const int t = tangent_row(i);
  const double x = reading_.w(t), y = reading_.w(t + 1), length = slip_speed(i);
  const double none = directionless(i);
  if (!(length > none)) return last;
  const double sign = (x * last[0] + y * last[1] < 0 ? -1 : 1) / length;
  if (length >= 2 * none) return {sign * x, sign * y};
  // In between it comes to the last one smoothly: no step could follow a jump.
  const double part = length / none - 1, own = part * part * part * (10 - part * (15 - 6 * part));
  const double mixed_x = own * sign * x + (1 - own) * last[0], mixed_y = own * sign * y + (1 - own) * last[1];
  const double mixed = std::hypot(mixed_x, mixed_y);
  return {mixed_x / mixed, mixed_y / mixed};
}

std::array<double, 2> ContactMotion::velocity_direction(int i) const noexcept {
  const int t = tangent_row(i);
  const double length = slip_speed(i);
  if (rule(i).tangents < 2 || !(length > least_slip(i))) return at(i).direction;
  return {reading_.w(t) / length, reading_.w(t + 1) / length};
}

void ContactMotion::fade(int i, double t, std::span<const double> y) {
  ContactState& state = states[as(i)];
  state.fades = state.begins = true;
  state.begun = t;
  changed();
  state.begins = solve(t, y) == Evaluation::ok && stiff_[as(i)] && !strays(i);
  changed();
}

// Forces pull a slip into the direction that they give it: one that has a velocity well off that direction has not got there, and
// forces may soon give it none.
bool ContactMotion::strays(int i) const noexcept {
  const auto& aligned = aligned_[as(i)];
  const auto own = velocity_direction(i);
  return slip_speed(i) > 2 * blur(i) && !(aligned[0] * own[0] + aligned[1] * own[1] > 0.9);
}

void ContactMotion::take_direction(int i) noexcept {
  ContactState& state = states[as(i)];
  state.direction = velocity_direction(i);
  if (rule(i).tangents == 1) state.direction[0] = std::copysign(1, reading_.w(tangent_row(i)));
  state.begins = false;
  state.fastest = std::max(state.fastest, slip(i));
  changed();
}

bool ContactMotion::slips_across(int i) {
  // The end of a slip is located to roundings of the time, in which it goes on to change.
  double change = 0;
  for (int k = 0; k < rule(i).tangents; ++k) {
    const int row = tangent_row(i) + k;
    change = std::hypot(change, terms_of_acceleration(row) + W().row(row).cwiseAbs().dot(r_.cwiseAbs()));
  }
  return slip_speed(i) > std::max({4 * least_slip(i), 1e-11 * at(i).fastest, 2 * blur(i), 64 * rounding_of_time(t_) * change});
}

double ContactMotion::slip(int i) const noexcept {
  const int t = tangent_row(i);
  double sum = 0;
  for (int k = 0; k < rule(i).tangents; ++k) sum += at(i).direction[as(k)] * reading_.w(t + k);
  return sum;
}

double ContactMotion::slip_speed(int i) const noexcept {
  double length = 0;
  for (int k = 0; k < rule(i).tangents; ++k) length = std::hypot(length, reading_.w(tangent_row(i) + k));
  return length;
}

double ContactMotion::least_slip(int i) const noexcept {
  // Velocities that have been put to zero again and again have roundings far below what is left of them. Where all that moves does
  // so by rounding, as a body that no force is left for beyond friction, roundings of that tell nothing: 1e-6 of an error does.
  double largest = std::max(at(i).residue, 1e-6 / 256 * absolute_);
  for (int k = 0; k < rule(i).tangents; ++k) largest = std::max(largest, rounding_of(tangent_row(i) + k));
  return 256 * largest;
}

// Some hundred errors of the integration: a slip slower than that, once it fades, keeps its direction.
double ContactMotion::blur(int i) const noexcept { return 100 * (absolute_ + relative_ * at(i).fastest); }

double ContactMotion::slow(int i) const noexcept { return std::max(1e-6 * at(i).fastest, 16 * blur(i)); }

// In space a slip has faded before. In the plane, where its direction cannot change, it has lost half of its speed: one that
// has just begun is slow too.
bool ContactMotion::ends_too(int i) const noexcept {
  const bool late = rule(i).tangents == 1 ? !at(i).begins && slip_speed(i) <= at(i).fastest / 2 : at(i).fades;
  return late && rule(i).law().rubs() && slip_speed(i) <= blur(i) / 8;
}

double ContactMotion::youth(int i, double t) const noexcept {
  const double s = slip(i), enough = 1e4 * least_slip(i);
  if (!at(i).begins) return s - slow(i);
  if (at(i).fades) return 4 * slow(i) - s;
  if (rule(i).tangents < 2) return enough - s;
  // Both as parts of their bounds: rounding is then alike on either side of where they are equal.
  const double turned = across_[as(i)] * lag_[as(i)] * (t - at(i).begun) / 5;
  return 1 - std::min(std::abs(turned) / (absolute_ / 128), s / enough);
}

std::array<double, 2> ContactMotion::bearing(int i) const noexcept {
  std::array<double, 2> R{};
  for (int k = first_bearing(i); k < first_bearing(i + 1); ++k) {
    R[as(k - first_bearing(i))] = dynamics_.S.row(k).dot(r_) + dynamics_.R_free(k);
  }
  return R;
}

double ContactMotion::pressing(int i) const noexcept {
  if (rule(i).bearing > 0) {
    const auto R = bearing(i);
    return std::hypot(R[0], R[1]);
  }
  const std::optional<int> by = carrier(i);
  return by ? r_(first_row(*by)) : 0;
}

double ContactMotion::margin(int i) const noexcept {
  const double N = pressing(i);
  return rule(i).sticking() * N + rule(i).sticking_bound() - friction_force(i);
}

double ContactMotion::friction_force(int i) const noexcept {
  double length = 0;
  for (int k = 0; k < rule(i).tangents; ++k) length = std::hypot(length, r_(tangent_row(i) + k));
  return length;
}

double ContactMotion::force_size(int i) const {
  const ContactVector forces = ContactScale(problem_of(reading_, dynamics_)).forces(r_);
  return std::max(rule(i).normal ? forces(first_row(i)) : 0, size_along(forces, r_, tangent_row(i), rule(i).tangents));
}

double ContactMotion::rounding_of(int row) const noexcept {
  double sum = 0;
  for (int j = 0; j < sizes_.velocities; ++j) sum += std::abs(reading_.J(row, j) * y_[as(sizes_.coordinates + j)]);
  // The rounding of a loop's rate, which moves all bodies of the loop when it is taken away.
  for (Eigen::Index k = 0; responded_ && k < reading_.A.rows(); ++k) sum += std::abs(dynamics_.AKJ(k, row)) * loops_(k);
  return std::numeric_limits<double>::epsilon() * (sum + std::abs(reading_.w(row)));
}

double ContactMotion::gap_acceleration(int i) const noexcept {
  return reading_.J.row(first_row(i)).dot(a_) + reading_.drift(first_row(i));
}

double ContactMotion::terms_of_acceleration(int row) const noexcept { return terms_along(reading_, dynamics_, row); }

double ContactMotion::acceleration_terms(int i) const noexcept { return terms_of_acceleration(first_row(i)); }

ContactVector ContactMotion::acceleration_sizes() const {
  ContactVector terms = ContactVector::Zero(rows());
  for (int i = 0; i < count(); ++i) {
    if (rule(i).normal) terms(first_row(i)) = acceleration_terms(i);
  }
  return ContactScale(problem_of(reading_, dynamics_)).motions(terms);
}

double ContactMotion::rounding_of_gap(int i) const noexcept {
  return gap_rounding_(i, reading_.J.row(first_row(i)), y_);
}

// Directions of slips that have just begun, to first order in the slip: the rate of those of order zero is taken over a part of the
// time s/s' that the slip has lasted, or that is left of it. Rounding ε of a direction is then ε of its acceleration, and what the
// rate itself changes in that time is of second order in the slip.
Evaluation ContactMotion::align(double t, std::span<const double> y, const Alignment& of, Regimes& regimes) {
  const auto& [problem, begins] = of;
  BeginningSlips slips{.begins = begins, .held = held_};
  if (!align_slips(problem, regimes, slips)) return Evaluation::singular;
  const ContactScale scale(problem);
  RegimeSystem equations(problem, scale, regimes);
  if (!equations.solve()) return Evaluation::singular;
  equations.approach(held_);
  change_ = dynamics_.a0;
  dynamics_.add_answer(equations.reactions(), change_);
  const ContactVector u = equations.motion();
  const ContactVector sizes = scale.motions(problem.W.cwiseAbs() * equations.reactions().cwiseAbs() + problem.q.cwiseAbs());
  double later = 0;
  for (int i = 0; i < count(); ++i) {
    if (!begins[as(i)]) continue;
    const auto& d = regimes[as(i)].direction;
    const int k = tangent_row(i);
    const double speed = std::abs(d[0] * reading_.w(k) + d[1] * reading_.w(k + 1)), size = std::max(sizes(k), sizes(k + 1));
    const double rate = std::max(std::abs(d[0] * u(k) + d[1] * u(k + 1)), size / 1024);
    if (rate > 0) later = std::max(later, speed / rate / 16);
  }
  if (!(later > 0)) later = std::numeric_limits<double>::min();
  std::copy_n(y.begin(), there_.size(), there_.begin());  // y may have room for more
  mechanism_.coordinate_rates(t, y, rates_);
  for (std::size_t i = 0; i < rates_.size(); ++i) there_[i] += later * rates_[i];
  for (int i = 0; i < sizes_.velocities; ++i) there_[as(sizes_.coordinates + i)] += later * change_(i);
  if (mechanism_.read(t + later, there_, later_reading_) != Evaluation::ok) return Evaluation::singular;
  if (!later_dynamics_.compute(later_reading_) || !later_dynamics_.respond(later_reading_)) return Evaluation::singular;
  // Slips that go along their own velocity turn too, the sooner the slower they are.
  Regimes turned = regimes;
  for (int i = 0; i < count(); ++i) {
    const bool turns = rule(i).tangents == 2 && turned[as(i)].friction == AssumedRegime::Friction::slides;
    if (!turns || begins[as(i)] || !turns_with_velocity(i)) continue;
    auto& d = turned[as(i)].direction;
    const int k = tangent_row(i);
    const double along_x = later_reading_.w(k), along_y = later_reading_.w(k + 1);
    const double length = std::copysign(std::hypot(along_x, along_y), d[0] * along_x + d[1] * along_y);
    if (length != 0) d = {along_x / length, along_y / length};
  }
  if (!align_slips(problem_of(later_reading_, later_dynamics_), turned, slips)) return Evaluation::singular;
  for (int i = 0; i < count(); ++i) {
    if (!begins[as(i)]) continue;
    const auto& d = regimes[as(i)].direction;
    const auto& e = turned[as(i)].direction;
    const int k = tangent_row(i);
    const double s = d[0] * reading_.w(k) + d[1] * reading_.w(k + 1);
    slips.across[as(i)] = across_[as(i)] = s * (d[0] * e[1] - d[1] * e[0]) / later;
    // s κ over the force that turns the slip back: the angle by which it lags.
    const ContactVector du = equations.motion_by_turning(i);
    const double stiffness = d[0] * (u(k) - du(k + 1)) + d[1] * (u(k + 1) + du(k));
    lag_[as(i)] = stiffness > 0 ? across_[as(i)] / stiffness : 1;
    stiff_[as(i)] = stiffness > 8 * std::abs(d[0] * u(k) + d[1] * u(k + 1));
  }
  return align_slips(problem, regimes, slips) ? Evaluation::ok : Evaluation::singular;
}

// Forces may stop giving a slip that fades a direction, as where another one that fades with it passes zero at a distance. Such a
// slip goes on in the direction of its velocity.
Evaluation ContactMotion::align_or_keep(double t, std::span<const double> y, Alignment of, Regimes& regimes) {
  PerContact<bool>& begins = of.begins;
  Regimes aligned = regimes;
  Evaluation evaluation = align(t, y, of, aligned);
  if (evaluation != Evaluation::ok) {
    bool any = false, more = false;
    for (int i = 0; i < count(); ++i) {
      if (!begins[as(i)]) continue;
      unaligned_[as(i)] = at(i).fades && slip_speed(i) > least_slip(i);
      begins[as(i)] = !unaligned_[as(i)];
      any = any || unaligned_[as(i)];
      more = more || begins[as(i)];
      if (!unaligned_[as(i)]) continue;
      regimes[as(i)].direction = velocity_direction(i);
      stiff_[as(i)] = false;
    }
    if (!any) return evaluation;
    aligned = regimes;
    evaluation = more ? align(t, y, of, aligned) : Evaluation::ok;
  }
  regimes = aligned;
  for (int i = 0; i < count(); ++i) aligned_[as(i)] = regimes[as(i)].direction;
  return evaluation;
}

void ContactMotion::follow_slips(double t, std::span<const double> y) {
  if (!read(t, y)) return;
  from_t_ = t;
  std::copy_n(y.begin(), from_.size(), from_.begin());
  followed_ = true;
  for (int i = 0; i < count(); ++i) {
    if (!at(i).touches || at(i).regime != ContactRegime::slides || rule(i).tangents == 0) continue;
    ContactState& state = states[as(i)];
    if (follows_forces(i) && state.fades && solve(t, y) == Evaluation::ok && (unaligned_[as(i)] || strays(i))) take_direction(i);
    const double now = slip(i);
    state.fastest = std::max(state.fastest, now);
    // Near its end the slip has no direction of its own that is worth following.
    if (rule(i).tangents == 2 && now > slow(i) && !state.begins) state.direction = direction(i);
  }
  changed();
}

}  // namespace torsor::runtime
