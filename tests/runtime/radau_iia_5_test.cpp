// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/integration/radau_iia_5.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "generated/flyball_governor.hpp"
#include "generated/torque_free_body.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/runtime/static_mechanisms.hpp"

namespace radau_iia_5_test {
namespace {

using namespace torsor::runtime;
using Governor = flyball_governor::Mechanism<double>;
using State = std::array<double, 2>;

RadauIia5 with_tolerance(double tolerance) {
  return {.relative_tolerance = tolerance, .absolute_tolerance = tolerance};
}
// Steps of the length given: the tolerance is so loose that only the largest step limits.
RadauIia5 of_step(double h) {
  return {.relative_tolerance = 1e3, .absolute_tolerance = 1.0, .first_step = h, .largest_step = h};
}

template <std::size_t size>
double largest_difference(const std::array<double, size>& a, const std::array<double, size>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < size; ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(RadauTableau, DiagonalisesTheInverseOfTheTableOfTheBook) {
  // Hairer-Wanner II, table IV.5.6.
  const double s = std::sqrt(6.0);
  const double A[3][3] = {{(88 - 7 * s) / 360, (296 - 169 * s) / 1800, (-2 + 3 * s) / 225},
                          {(296 + 169 * s) / 1800, (88 + 7 * s) / 360, (-2 - 3 * s) / 225},
                          {(16 - s) / 36, (16 + s) / 36, 1.0 / 9}};
  using R = RadauTableau<double>;
  const double T[3][3] = {{R::t11, R::t12, R::t13}, {R::t21, R::t22, R::t23}, {R::t31, 1.0, 0.0}};
  const double I[3][3] = {{R::i11, R::i12, R::i13}, {R::i21, R::i22, R::i23}, {R::i31, R::i32, R::i33}};
  const double L[3][3] = {{R::real, 0, 0}, {0, R::pair_re, -R::pair_im}, {0, R::pair_im, R::pair_re}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double inverse = 0.0, product = 0.0;
      for (int k = 0; k < 3; ++k) {
        inverse += T[i][k] * I[k][j];
        for (int l = 0; l < 3; ++l) {
          for (int m = 0; m < 3; ++m) product += A[i][k] * T[k][l] * L[l][m] * I[m][j];
        }
      }
      EXPECT_NEAR(inverse, i == j ? 1.0 : 0.0, 1e-14);
      EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-14);
    }
  }
  EXPECT_NEAR(R::c1, A[0][0] + A[0][1] + A[0][2], 1e-16);
  EXPECT_NEAR(R::c2, A[1][0] + A[1][1] + A[1][2], 1e-16);
  // The error's weights: e = γ₀ (b̂ - b) A⁻¹ with the embedded formula of the book, (8.16) to (8.19).
  EXPECT_NEAR(R::e1, -(13 + 7 * s) / 3, 1e-14);
  EXPECT_NEAR(R::e2, (-13 + 7 * s) / 3, 1e-14);
  EXPECT_NEAR(R::e3, -1.0 / 3, 1e-15);
}

/// x'' = -x - x'/5 + cos(2 t), with or without the word that it is of second order.
template <bool says_second_order>
struct ForcedOscillator {
  static constexpr bool second_order = says_second_order;
  Evaluation operator()(double t, const State& y, State& dydt) const noexcept {
    dydt = {y[1], -y[0] - y[1] / 5 + std::cos(2 * t)};
    return Evaluation::ok;
  }
  // x = e^(-t/10) (a cos wt + b sin wt) + forced, from rest at 0: forced = (-3 cos 2t + 0.4 sin 2t)/(9 + 0.16).
  static State exact(double t) {
    const double w = std::sqrt(0.99), p = -3.0 / 9.16, q = 0.4 / 9.16;
    const double a = -p, b = (0.1 * a - 2 * q) / w, decay = std::exp(-0.1 * t);
    const double c = std::cos(w * t), s = std::sin(w * t);
    return {
        decay * (a * c + b * s) + p * std::cos(2 * t) + q * std::sin(2 * t),
        decay * ((-0.1 * a + b * w) * c - (0.1 * b + a * w) * s) - 2 * p * std::sin(2 * t) + 2 * q * std::cos(2 * t)};
  }
};

// The next term of the error changes the order seen by O(h), 0.2 at most at these steps; an order wrong by one would be
// off by 1. The problem is linear: two iterations leave nothing of Newton's error.
TEST(RadauIia5, HasOrderFive) {
  const auto error = [](double h) {
    State y{0.0, 0.0};
    EXPECT_TRUE(integrate(ForcedOscillator<true>{}, y, 0, 8, of_step(h)));
    return largest_difference(y, ForcedOscillator<true>::exact(8));
  };
  EXPECT_NEAR(std::log2(error(1.0 / 8) / error(1.0 / 16)), 5.0, 0.2);
}

TEST(RadauIia5, InterpolatesByTheCollocationPolynomial) {
  // One step from an exact value: h^6 at its end, and inside a cubic through the start and three stages: h^4.
  const double start = 0.3;
  const auto errors_of = [&](double h) {
    State errors{};
    const auto compare = [&](const DenseStep<double, 2>& step) {
      for (int i = 1; i < 10; ++i) {
        const double t = step.start + h * i / 10;
        errors[0] = std::max(errors[0], largest_difference(step(t), ForcedOscillator<true>::exact(t)));
      }
      errors[1] = largest_difference(step(step.end), ForcedOscillator<true>::exact(step.end));
    };
    State y = ForcedOscillator<true>::exact(start);
    EXPECT_TRUE(integrate(ForcedOscillator<true>{}, y, start, start + h, of_step(h), compare));
    return errors;
  };
  const State coarse = errors_of(0.2), fine = errors_of(0.1);
  EXPECT_NEAR(std::log2(coarse[0] / fine[0]), 4.0, 0.3);
  EXPECT_NEAR(std::log2(coarse[1] / fine[1]), 6.0, 0.3);
}

TEST(RadauIia5, SolvesForHalfTheUnknownsOfASecondOrderSystemAlike) {
  State half{0.0, 0.0}, whole{0.0, 0.0};
  ASSERT_TRUE(integrate(ForcedOscillator<true>{}, half, 0, 8, of_step(0.125)));
  // `second_order = false` is taken at its word.
  ASSERT_TRUE(integrate(ForcedOscillator<false>{}, whole, 0, 8, of_step(0.125)));
  EXPECT_LT(largest_difference(half, whole), 64 * 2.2e-16 * 4);  // roundings of 64 steps
}

TEST(RadauIia5, MeetsThePublishedGovernorAtEachTolerance) {
  // Quadruple precision, Gauss collocation with 6 and 8 stages: psi, s, two beta, spin, s', two beta' at t = 10. The
  // published demand is 1e-3 m of s.
  const std::array<double, 8> truth{5.59354099091023787e+01, 6.19622917061365658e-01, 3.90073701844645080e-01,
                                    3.90073701844645080e-01, 5.54820362265492658,     -7.4760335416433246e-01,
                                    8.08467051345577400e-01, 8.08467051345577400e-01};
  const auto motion = equations_of_motion<Governor>();
  double last = 1.0;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    auto y = motion.initial();
    const auto result = integrate(motion, y, 0, 10, with_tolerance(tolerance));
    ASSERT_TRUE(result) << describe(result);
    const double error = largest_difference(y, truth);
    // Errors of one step are below the tolerance; psi (56) and spin sum those of 10 s, some hundred slow times, and the
    // tolerance counts |y| too.
    EXPECT_LT(error, 200 * tolerance * 5.6);
    EXPECT_LT(error, last);
    last = error;
    EXPECT_GT(result.statistics.jacobians, 0);
    EXPECT_GE(result.statistics.decompositions, 2);
    // Stability would take an explicit method of 3/2e4 s and less a step, 7e4 steps.
    EXPECT_LT(result.statistics.accepted, 3000);
  }
}

/// A unit mass on a spring from the origin, rest length 1, in the plane under gravity.
struct ElasticPendulum {
  static constexpr bool second_order = true;
  double stiffness;
  Evaluation operator()(double, const std::array<double, 4>& y, std::array<double, 4>& dydt) const noexcept {
    const double r = std::hypot(y[0], y[1]), pull = -stiffness * (r - 1) / r;
    dydt = {y[2], y[3], pull * y[0], pull * y[1] - 9.81};
    return Evaluation::ok;
  }
};

TEST(RadauIia5, MeetsTheElasticPendulumWithItsFastModeResolved) {
  const std::array<double, 4> truth{0.78716337934128783673767423, -0.61969057482201185317075261,
                                    2.1477596957501236496262230, 2.7408659966747509639371353};
  std::array<double, 4> y{1, 0, 0, 0};
  const auto result = integrate(ElasticPendulum{1e4}, y, 0, 2, with_tolerance(1e-13));
  ASSERT_TRUE(result) << describe(result);
  // Some 1500 steps of 1e-13 times |v| = 4 and the 32 turns of the fast mode, whose phase the error shifts.
  EXPECT_LT(largest_difference(y, truth), 1500 * 4 * 1e-13);
}

TEST(RadauIia5, FollowsTheSlowMotionOfAStifferElasticPendulum) {
  // 3200 periods of the fast mode, whose amplitude is g/k = 1e-7; at a tolerance of 1e-5 it is damped, not followed.
  // What may be lost is its share of y (1e-7) and, at ws = 1e4, of the velocities (1e-3); the slow angle is right to
  // the tolerance's own error and 1/ws².
  const std::array<double, 4> truth{0.79356556126269921386207737, -0.60848505169155606162579651,
                                    2.1024423862766915008686121, 2.7419353602363155999197867};
  std::array<double, 4> y{1, 0, 0, 0};
  const auto result = integrate(ElasticPendulum{1e8}, y, 0, 2, with_tolerance(1e-5));
  ASSERT_TRUE(result) << describe(result);
  EXPECT_LT(result.statistics.accepted, 3200);
  EXPECT_NEAR(std::atan2(y[0], -y[1]), std::atan2(truth[0], -truth[1]), 1e-3);
  y = {1, 0, 0, 0};
  ASSERT_TRUE(integrate(ElasticPendulum{1e8}, y, 0, 2, with_tolerance(1e-9)));
  // The fast mode is held to the tolerance of 1e-9 where it is as large as that; what it may lose is its amplitude.
  EXPECT_NEAR(std::atan2(y[0], -y[1]), std::atan2(truth[0], -truth[1]), 9.81 / 1e8);
}

TEST(RadauIia5, MeetsThePublishedValuesOfStiffProblems) {
  // Hairer-Wanner II, IV.10, and their test set: van der Pol with ε = 1e-6 at t = 2, Robertson at t = 1e11.
  const auto van_der_pol = [](double, const State& y, State& dydt) noexcept {
    dydt = {y[1], ((1 - y[0] * y[0]) * y[1] - y[0]) / 1e-6};
    return Evaluation::ok;
  };
  State v{2.0, 0.0};
  auto result = integrate(van_der_pol, v, 0, 2, with_tolerance(1e-9));
  ASSERT_TRUE(result) << describe(result);
  // Slow branches forget; a jump off the fold, of width ε^(2/3) in time, delays by ε^(-1/3) = 100 times what the state
  // is off there by the tolerance.
  EXPECT_NEAR(v[0], 1.706167732170483, 100 * 1e-9);
  EXPECT_NEAR(v[1], -0.8928097010247975, 100 * 1e-9);
  // The authors' own code takes 242 steps at 1e-4 with 162 Jacobians and 254 decompositions of each kind.
  v = {2.0, 0.0};
  result = integrate(van_der_pol, v, 0, 2, with_tolerance(1e-4));
  EXPECT_NEAR(static_cast<double>(result.statistics.accepted), 242, 25);
  EXPECT_NEAR(static_cast<double>(result.statistics.jacobians), 162, 25);
  EXPECT_NEAR(static_cast<double>(result.statistics.decompositions), 2 * 254, 50);

  const auto robertson = [](double, const std::array<double, 3>& y, std::array<double, 3>& dydt) noexcept {
    dydt[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
    dydt[2] = 3e7 * y[1] * y[1];
    dydt[1] = -dydt[0] - dydt[2];
    return Evaluation::ok;
  };
  std::array<double, 3> c{1.0, 0.0, 0.0};
  result = integrate(robertson, c, 0, 1e11, RadauIia5{.relative_tolerance = 1e-7, .absolute_tolerance = 1e-18});
  ASSERT_TRUE(result) << describe(result);
  EXPECT_NEAR(c[0], 0.2083340149701255e-7, 1e-5 * 0.2083e-7);
  EXPECT_NEAR(c[1], 0.8333360770334713e-13, 1e-5 * 0.8333e-13);
  EXPECT_NEAR(c[2], 0.9999999791665050, 1e-13);
}

/// y' = -1e8 (y - cos t) - sin t, of which y = cos t is the slow solution.
struct FastDecay {
  using One = std::array<double, 1>;
  Evaluation operator()(double t, const One& y, One& dydt) const noexcept {
    dydt[0] = -1e8 * (y[0] - std::cos(t)) - std::sin(t);
    return Evaluation::ok;
  }
  Evaluation jacobian(double, const One&, One& J) const noexcept {
    J[0] = -1e8;
    return Evaluation::ok;
  }
};
TEST(RadauIia5, ForgetsAtOnceWhatDecaysFast) {
  // Of an excess of 1 a step of 0.1 leaves |R(-1e7)| = 3/1e7, as R is L-stable of degrees (2, 3), and the next step as
  // much of that. A method that is A-stable only would keep all of it. The slow solution's own error is that of the
  // stages, h⁴/24, over h λ.
  FastDecay::One y{2.0};
  ASSERT_TRUE(integrate(FastDecay{}, y, 0.0, 0.1, of_step(0.1)));
  EXPECT_NEAR(y[0] - std::cos(0.1), 3e-7, 0.1e-7);
  ASSERT_TRUE(integrate(FastDecay{}, y, 0.1, 0.2, of_step(0.1)));
  EXPECT_NEAR(y[0], std::cos(0.2), 1e-11);
}

struct WithoutJacobian {
  static constexpr bool second_order = true;
  const EquationsOfMotion<Governor>& inside;
  Evaluation operator()(double t, const std::array<double, 8>& y, std::array<double, 8>& dydt) const noexcept {
    return inside(t, y, dydt);
  }
};
TEST(RadauIia5, TakesDifferencesWhereNoJacobianIsOffered) {
  const auto motion = equations_of_motion<Governor>();
  auto offered = motion.initial(), differences = motion.initial();
  const auto one = integrate(motion, offered, 0, 1, with_tolerance(1e-9));
  const auto other = integrate(WithoutJacobian{motion}, differences, 0, 1, with_tolerance(1e-9));
  ASSERT_TRUE(one && other);
  // Each of some 180 steps of both errs by less than the tolerance times the size, |ψ| <= 6, at random; eight calls a
  // Jacobian come on top.
  const auto steps = static_cast<double>(one.statistics.accepted + other.statistics.accepted);
  EXPECT_LT(largest_difference(offered, differences), 1e-9 * 6 * std::sqrt(steps));
  EXPECT_LT(steps, 200);
  EXPECT_GT(other.statistics.calls, one.statistics.calls + 7 * other.statistics.jacobians);
}

TEST(RadauIia5, TurnsABodyByItsQuaternion) {
  // Where q' is not v the whole state is solved for, and the quaternion gets its norm back. The truth is an explicit
  // method's, at its sharpest; over 10 s the flow amplifies an error of 1e-9 by some 10².
  const auto motion = equations_of_motion<torque_free_body::Mechanism<double>>();
  static_assert(!is_second_order<decltype(motion)>);
  auto truth = motion.initial(), y = motion.initial();
  ASSERT_TRUE(
      integrate(motion, truth, 0, 10, DormandPrince853{.relative_tolerance = 1e-13, .absolute_tolerance = 1e-13}));
  ASSERT_TRUE(integrate(motion, y, 0, 10, with_tolerance(1e-9)));
  EXPECT_LT(largest_difference(y, truth), 1e-7);
  EXPECT_NEAR(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3], 1.0, 8 * 1.1e-16);
}

/// The body in two constant fields with forward dynamics (J = 1), q' = ½ q ω, and its linearisation by hand: a vector u
/// of the ground, seen from the body, changes by u ∧ e when the body turns by e, so that a = (3 z_y, -3 z_x - x_z, x_y)
/// has the derivatives below.
struct TurningBody : mechanisms::HeldBody {
  struct Linearisation {
    std::array<double, 36> A;
  };
  static mechanisms::Status forward_dynamics(const Precomputed& p, const State& s, const Inputs&, Accelerations& a,
                                             Multipliers& lambda) noexcept {
    GeneralizedForces r{};
    inverse_dynamics(p, s, {}, lambda, r);
    for (int i = 0; i < 3; ++i) a[i] = -r[i];
    return mechanisms::Status::ok;
  }
  static void coordinate_rates(const Precomputed&, const State& s, std::array<double, 4>& rates) noexcept {
    const double w = s.q[0], x = s.q[1], y = s.q[2], z = s.q[3], p = s.v[0], q = s.v[1], r = s.v[2];
    rates = {(-x * p - y * q - z * r) / 2, (w * p + y * r - z * q) / 2, (w * q + z * p - x * r) / 2,
             (w * r + x * q - y * p) / 2};
  }
  static mechanisms::Status linearisation(const Precomputed&, const State& s, const Accelerations&, const Multipliers&,
                                          const Inputs&, Linearisation& linear) noexcept {
    const double w = s.q[0], x = s.q[1], y = s.q[2], z = s.q[3];
    const std::array<double, 3> u{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)};
    const std::array<double, 3> v{2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z};
    const std::array<double, 9> by_turn{3 * v[2], u[1], u[2], 0, 3 * v[2] - u[0], 0, -3 * v[0], -3 * v[1], -u[0]};
    linear.A = {};
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t i = 0; i < 3; ++i) linear.A[j * 6 + 3 + i] = by_turn[j * 3 + i];
    }
    return mechanisms::Status::ok;
  }
};

TEST(EquationsOfMotion, OfferTheJacobianByVirtualTurnsOfAQuaternion) {
  const auto motion = equations_of_motion<TurningBody>();
  static_assert(HasJacobian<decltype(motion), double, 7>);
  std::array<double, 7> y{0.1, -0.7, 0.5, 0.5, 0.8, -1.1, 0.4};
  std::array<double, 49> J;
  ASSERT_EQ(motion.jacobian(0.0, y, J), Evaluation::ok);
  const TurningBody::State state{0.0, {{y[0], y[1], y[2], y[3]}}, {}};
  for (int k = 0; k < 6; ++k) {
    // Along turns about the body's axes, and along its velocities; a quaternion's length is not the motion's business.
    std::array<double, 7> direction{}, product{};
    if (k < 3) {
      TurningBody::State turning = state;
      turning.v[k] = 1.0;
      std::array<double, 4> rates;
      TurningBody::coordinate_rates({}, turning, rates);
      std::copy(rates.begin(), rates.end(), direction.begin());
    } else {
      direction[static_cast<std::size_t>(k) + 1] = 1.0;
    }
    std::array<double, 7> up = y, down = y, at_up, at_down;
    for (std::size_t j = 0; j < 7; ++j) {
      up[j] += 1e-5 * direction[j];
      down[j] -= 1e-5 * direction[j];
      for (std::size_t i = 0; i < 7; ++i) product[i] += J[j * 7 + i] * direction[j];
    }
    ASSERT_EQ(motion(0.0, up, at_up), Evaluation::ok);
    ASSERT_EQ(motion(0.0, down, at_down), Evaluation::ok);
    // Central differences of quadratic functions: roundings of 1e-16 times 10 over 2e-5 alone.
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(product[i], (at_up[i] - at_down[i]) / 2e-5, 1e-9) << k << " " << i;
  }
}

TEST(RadauIia5, ReportsAJacobianThatIsNotFinite) {
  struct Broken {
    Evaluation operator()(double, const std::array<double, 1>& y, std::array<double, 1>& dydt) const noexcept {
      dydt[0] = -y[0];
      return Evaluation::ok;
    }
    Evaluation jacobian(double, const std::array<double, 1>&, std::array<double, 1>& J) const noexcept {
      J[0] = std::nan("");
      return Evaluation::ok;
    }
  };
  std::array<double, 1> y{1.0};
  const auto result = integrate(Broken{}, y, 0, 1, RadauIia5{});
  EXPECT_EQ(result.status, IntegrationStatus::model_failure);
  EXPECT_EQ(result.evaluation, Evaluation::not_finite);
  EXPECT_EQ(y[0], 1.0);
}

}  // namespace
}  // namespace radau_iia_5_test
