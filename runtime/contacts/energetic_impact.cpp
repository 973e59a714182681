// SPDX-License-Identifier: MIT
#include "torsor/runtime/contacts/energetic_impact.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "torsor/runtime/contacts/circle_roots.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/events.hpp"

namespace torsor::runtime {
namespace {

using Two = Eigen::Vector2d;

Two unit(double angle) { return {std::cos(angle), std::sin(angle)}; }
double cross(const Two& a, const Two& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The way of one impact, in pieces of constant or of turning direction.
class ImpactPath {
 public:
  ImpactPath(const ContactProblem& problem, double restitution) noexcept
      : problem_(problem), law_(problem.law(0)), e_(restitution) {
    for (int k = 0; k < law_.tangents; ++k) {
      b_(k) = problem.W(0, 1 + k);
      for (int j = 0; j < law_.tangents; ++j) T_(k, j) = problem.W(1 + k, 1 + j);
      slip_(k) = problem.q(1 + k);
    }
    normal_ = problem.q(0);
    a_ = problem.W(0, 0);
    compressing_ = normal_ <= 0;
  }

  [[nodiscard]] EnergeticImpact run() noexcept {
    for (int piece = 0; piece < 100 && !ended_; ++piece) {
      const double speed = slip_.norm();
      if (!(speed > rest())) {
        if (!from_rest()) break;
      } else if (law_.tangents < 2) {
        along_constant(-law_.friction * slip_ / speed, true);
      } else if (!turning()) {
        break;
      }
    }
    EnergeticImpact result;
    result.P.resize(law_.rows());
    result.w.resize(law_.rows());
    result.P(0) = p_;
    result.w(0) = normal_;
    for (int k = 0; k < law_.tangents; ++k) {
      result.P(1 + k) = impulse_(k);
      result.w(1 + k) = slip_(k);
    }
    result.sticks = sticks_;
    result.ended = ended_;
    return result;
  }

 private:
  /// A slip below this is rounding.
  [[nodiscard]] double rest() const noexcept {
    double size = 0;
    for (int k = 0; k < law_.tangents; ++k) {
      size += std::abs(problem_.q(1 + k)) + std::abs(b_(k)) * p_ + T_.row(k).cwiseAbs().dot(impulse_.cwiseAbs());
    }
    return 16 * std::numeric_limits<double>::epsilon() * size;
  }

  // From w_T = 0: it sticks where friction can hold it, or slips in the direction that it gives itself.
  bool from_rest() noexcept {
    slip_.setZero();
    sticks_ = true;
    if (law_.tangents == 0) return along_constant(Two::Zero(), false);
    const Two holds = law_.tangents == 1 ? Two(-b_(0) / T_(0, 0), 0) : Two(-T_.llt().solve(b_));
    if (holds.norm() <= law_.static_friction) return along_constant(holds, false);
    sticks_ = false;
    if (law_.tangents == 1) return along_constant({b_(0) > 0 ? -law_.friction : law_.friction, 0}, false);
    std::array<double, 8> values{};
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = turn(std::numbers::pi / 4 * static_cast<double>(k));
    const CircleRoots roots(values);
    for (std::size_t i = 0; i < roots.count(); ++i) {
      if (growth(roots[i]) > 0) return along_constant(-law_.friction * unit(roots[i]), false);
    }
    return false;
  }

  // A piece on which dw/dp is constant: to the end of restitution, of the slip, or of compression.
  bool along_constant(const Two& friction, bool slips) noexcept {
    const double rate = a_ + b_.dot(friction);
    const Two change = b_ + T_ * friction;
    double length = std::numeric_limits<double>::infinity();
    bool stops = false;
    if (slips) {
      sticks_ = false;
      const double along = slip_.dot(change) / slip_.squaredNorm();
      if (along < 0) {
        length = -1 / along;
        stops = true;
      }
    }
    constexpr double never = std::numeric_limits<double>::infinity();
    // To w_N = 0 where it is compressed, else to the work that is missing: w_N l + rate l²/2, the first l > 0.
    double last = never;
    if (compressing_) {
      if (rate > 0) last = -normal_ / rate;
    } else if (const double root = normal_ * normal_ + 2 * rate * missing(); root >= 0) {
      last = 2 * missing() / (normal_ + std::sqrt(root));
    }
    if (last <= length) {
      move(last, rate, change, friction);
      pass_on();
      return true;
    }
    if (!std::isfinite(length)) return false;
    move(length, rate, change, friction);
    if (stops) slip_.setZero();
    return true;
  }

  /// Work that the normal force has still to give back.
  [[nodiscard]] double missing() const noexcept { return std::max(0.0, -e_ * e_ * taken_ - given_); }

  // Compression has ended, or restitution.
  void pass_on() noexcept {
    if (!compressing_) {
      ended_ = true;
      return;
    }
    compressing_ = false;
    normal_ = 0;
    ended_ = !(missing() > 0);
  }

  void move(double length, double rate, const Two& change, const Two& friction) noexcept {
    (compressing_ ? taken_ : given_) += length * (normal_ + rate * length / 2);
    normal_ += rate * length;
    slip_ += length * change;
    impulse_ += length * friction;
    p_ += length;
  }

  /// dθ/ds and dλ/ds of a slip e^λ (cos θ, sin θ), with dp = e^λ ds.
  [[nodiscard]] double turn(double angle) const noexcept { return cross(unit(angle), b_ - law_.friction * (T_ * unit(angle))); }
  [[nodiscard]] double growth(double angle) const noexcept {
    return unit(angle).dot(b_ - law_.friction * (T_ * unit(angle)));
  }

  // A piece on which the slip turns, integrated: (θ, λ, p, w_N, work, impulses).
  bool turning() noexcept {
    using Vector = std::array<double, 7>;
    const double first = std::log(slip_.norm()), goal = missing();
    const auto slope = [&](double, const Vector& y, Vector& dydt) {
      const Two d = unit(y[0]);
      const double speed = std::exp(y[1]), rate = a_ - law_.friction * b_.dot(d);
      dydt = {turn(y[0]),    growth(y[0]), speed, speed * rate, speed * y[3], -law_.friction * speed * d.x(),
              -law_.friction * speed * d.y()};
      return Evaluation::ok;
    };
    const Events ends(
        stop_at([&](double, const Vector& y) { return compressing_ ? -y[3] : goal - y[4]; }, Crossing::falling),
        stop_at([&](double, const Vector& y) { return y[1] - first + 42; }, Crossing::falling));  // e^-42 is rounding
    Vector y{std::atan2(slip_.y(), slip_.x()), first, 0, normal_, 0, 0, 0};
    constexpr DormandPrince853 method{.relative_tolerance = 1e-14, .absolute_tolerance = 1e-16};
    const auto result = integrate_with_events(slope, y, 0.0, 1e9, method, ends);
    if (result.status != EventStatus::stopped_at_event) return false;
    sticks_ = false;
    p_ += y[2];
    normal_ = y[3];
    impulse_ += Two(y[5], y[6]);
    (compressing_ ? taken_ : given_) += y[4];
    slip_ = result.guard == 0 ? Two(std::exp(y[1]) * unit(y[0])) : Two(0, 0);
    if (result.guard == 0) pass_on();
    return true;
  }

  const ContactProblem& problem_;
  const ContactLaw law_;
  const double e_;
  double a_ = 0;                         ///< W of the normal
  Two b_{0, 0};                          ///< W between normal and tangents
  Eigen::Matrix2d T_ = Eigen::Matrix2d::Zero();
  double normal_ = 0, p_ = 0, taken_ = 0, given_ = 0;
  Two slip_{0, 0}, impulse_{0, 0};
  bool compressing_ = true, sticks_ = false, ended_ = false;
};

}  // namespace

EnergeticImpact energetic_impact(const ContactProblem& problem, double restitution) noexcept {
  return ImpactPath(problem, restitution).run();
}

}  // namespace torsor::runtime
