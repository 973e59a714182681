// SPDX-License-Identifier: GPL-3.0-or-later
#include "generated/whipple_bicycle.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "torsor/runtime/mechanism.hpp"
#include "torsor/runtime/numerics/matrix_exponential.hpp"
#include "torsor/runtime/small_motions/modes.hpp"
#include "tests/examples/energy_theorem.hpp"
#include "tests/examples/motion.hpp"
#include "tests/examples/reference_digits.hpp"

namespace torsor::whipple_bicycle_test {
namespace {

using namespace torsor::runtime;
using Bicycle = whipple_bicycle::Mechanism<double>;
using Eigen::Matrix2d;

constexpr double g = 9.81, r_R = 0.3, r_F = 0.35;
constexpr DormandPrince54 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

// Meijaard, Papadopoulos, Ruina and Schwab 2007: M q'' + v C1 q' + (g K0 + v² K2) q = 0, q = (lean, steer). The digits
// beyond the fourteen published were recomputed from the paper's formulas in 50 digits.
Matrix2d matrix(double a, double b, double c, double d) { return (Matrix2d() << a, b, c, d).finished(); }
const Matrix2d M = matrix(80.81722, 2.3194133220870913477, 2.3194133220870913477, 0.29784188199685552999);
const Matrix2d C1 = matrix(0, 33.866413914924943883, -0.85035641456978437036, 1.6854039739755967411);
const Matrix2d K0 = matrix(-80.95, -2.5995168524987164073, -2.5995168524987164073, -0.80329488458617688081);
const Matrix2d K2 = matrix(0, 76.597345895732221519, 0, 2.6543152379460402523);

Bicycle::State steady(double speed) {
  Bicycle::State state = Bicycle::initial_state();
  for (int i = 0; i < Bicycle::velocity_count; ++i) state.v[i] = 0.0;
  state.v.x = speed;
  state.v.rear = -speed / r_R;
  state.v.front = -speed / r_F;
  return state;
}

template <std::size_t size>
std::size_t place(const int (&table)[size], int freedom) {
  return static_cast<std::size_t>(std::find(table, table + size, freedom) - table);
}

/// The generated linearisation about steady running, whole and of lean and steer.
struct Linear {
  Bicycle::Linearisation whole{};
  Bicycle::Multipliers forces{};
  LinearSystem lean_and_steer;
};

Linear linearised(double speed) {
  const auto bicycle = Bicycle::precompute({});
  Linear result;
  Bicycle::Accelerations a{};
  EXPECT_EQ(Bicycle::forward_dynamics(bicycle, steady(speed), {}, a, result.forces), torsor::Status::ok);
  EXPECT_EQ(Bicycle::linearisation(bicycle, steady(speed), a, result.forces, {}, result.whole), torsor::Status::ok);
  LinearSystem& system = result.lean_and_steer;
  system = undamped(Matrix2d::Zero(), Matrix2d::Zero());
  constexpr std::size_t rows = Bicycle::independent_velocity_count;
  constexpr std::array<int, 2> roll_and_steer{4, 6};  // places in v
  for (int j = 0; j < 2; ++j) {
    const int freedom = roll_and_steer[static_cast<std::size_t>(j)];
    const std::size_t w = place(Bicycle::independent_velocities, freedom);
    const std::size_t e = place(Bicycle::independent_coordinates, freedom);
    for (int i = 0; i < 2; ++i) {
      const std::size_t row = place(Bicycle::independent_velocities, roll_and_steer[static_cast<std::size_t>(i)]);
      system.M(i, j) = result.whole.M_r[rows * w + row];
      system.C(i, j) = result.whole.C_r[rows * w + row];
      system.K(i, j) = result.whole.K_r[rows * e + row];
    }
  }
  return result;
}

/// Largest difference of entries, relative to the entry, or to the largest entry where it is zero.
double distance(const Eigen::MatrixXd& found, const Matrix2d& expected) {
  double worst = 0.0;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const double size = expected(i, j) == 0.0 ? expected.cwiseAbs().maxCoeff() : std::abs(expected(i, j));
      worst = std::max(worst, std::abs(found(i, j) - expected(i, j)) / size);
    }
  }
  return worst;
}

TEST(WhippleBicycle, HasThePublishedMatricesToTwelveDigits) {
  const LinearSystem at_rest = linearised(0.0).lean_and_steer;
  EXPECT_LT(distance(at_rest.M, M), 1e-12);
  EXPECT_LT(distance(at_rest.K / g, K0), 1e-12);
  EXPECT_LT(at_rest.C.cwiseAbs().maxCoeff(), 1e-12);
  for (int speed = 1; speed <= 10; ++speed) {
    const double v = speed;
    const LinearSystem system = linearised(v).lean_and_steer;
    EXPECT_LT(distance(system.M, M), 1e-12) << v;
    EXPECT_LT(distance(system.C / v, C1), 1e-12) << v;
    const Eigen::MatrixXd expected = g * K0 + v * v * K2;
    EXPECT_LT((system.K - expected).cwiseAbs().maxCoeff(), 1e-12 * (g * K0.cwiseAbs() + v * v * K2).maxCoeff()) << v;
  }
  EXPECT_LT(distance((linearised(10.0).lean_and_steer.K - at_rest.K) / 100.0, K2), 1e-12);
}

// The wheels carry what statics says, and nothing else happens on a straight road: forward motion is a freedom of its
// own, and place, heading and the wheels' angles have no stiffness.
TEST(WhippleBicycle, RunsStraightByItself) {
  constexpr double mass = 2 + 85 + 4 + 3, front = (85 * 0.3 + 4 * 0.9 + 3 * 1.02) * g / 1.02;
  for (const double v : {0.0, 3.0, 10.0}) {
    const Linear linear = linearised(v);
    EXPECT_NEAR(linear.forces.lambda_front_touches, front, 1e-10);
    EXPECT_NEAR(linear.forces.lambda_rear_touches, mass * g - front, 1e-10);
    const std::size_t forward = place(Bicycle::independent_velocities, 7);
    ASSERT_LT(forward, 3U);
    // All masses move, and the wheels turn: m r_R² + I_Ryy + I_Fyy (r_R / r_F)².
    EXPECT_NEAR(linear.whole.M_r[3 * forward + forward], mass * r_R * r_R + 0.12 + 0.28 * (r_R / r_F) * (r_R / r_F),
                1e-12);
    for (std::size_t j = 0; j < Bicycle::independent_coordinate_count; ++j) {
      const int freedom = Bicycle::independent_coordinates[j];
      for (std::size_t i = 0; i < 3; ++i) {
        const bool stiff = freedom == 4 || freedom == 6;
        EXPECT_TRUE(stiff || std::abs(linear.whole.K_r[3 * j + i]) < 1e-11) << i << ", " << j;
      }
    }
    for (const double f : linear.whole.F_r) EXPECT_NEAR(f, 0.0, 1e-11);
  }
}

using Roots = std::vector<std::complex<double>>;

TEST(WhippleBicycle, HasThePublishedEigenvalues) {
  using namespace std::complex_literals;
  const std::vector<Roots> published{
      {-5.530943717653934639, -3.131643247906555668, 3.131643247906555668, 5.530943717653934639},
      {-7.110080146374407727, -3.134231250665784228, 3.526961709900694170 - 0.8077402751993100451i,
       3.526961709900694170 + 0.8077402751993100451i},
      {-8.673879848317371628, -3.071586456415142513, 2.682345175127453455 - 1.680662965906757760i,
       2.682345175127453455 + 1.680662965906757760i},
      {-10.35101467245922820, -2.633661372536652957, 1.706756056639735154 - 2.315824473843243567i,
       1.706756056639735154 + 2.315824473843243567i},
      {-12.15861426576443965, -1.429444273613257450, 0.4132533152112413208 - 3.079108186032053628i,
       0.4132533152112413208 + 3.079108186032053628i},
      {-14.07838969279824715, -0.7753418821958419254 - 4.464867713788225141i,
       -0.7753418821958419254 + 4.464867713788225141i, -0.3228664290040870776},
      {-16.08537123098028404, -1.526444865841417146 - 5.876730605987084034i,
       -1.526444865841417146 + 5.876730605987084034i, -0.004066900769703362423},
      {-18.15788466125202091, -2.138756442583634279 - 7.195259133298042550i,
       -2.138756442583634279 + 7.195259133298042550i, 0.1026817057476641588},
      {-20.27940894394566299, -2.693486835810947719 - 8.460379713969335901i,
       -2.693486835810947719 + 8.460379713969335901i, 0.1432787976571294983},
      {-22.43788559040858059, -3.216754022524907469 - 9.693773515317821953i,
       -3.216754022524907469 + 9.693773515317821953i, 0.1579018403091729823},
      {-24.62459635017400025, -3.720168404372875727 - 10.90681139476288200i,
       -3.720168404372875727 + 10.90681139476288200i, 0.1610533865317155419}};
  for (std::size_t v = 0; v < published.size(); ++v) {
    Roots found;
    for (const DampedMode& mode : damped_modes(linearised(static_cast<double>(v)).lean_and_steer)) {
      found.push_back(mode.eigenvalue);
    }
    for (const std::complex<double>& root : published[v]) {
      double nearest = 1.0;
      for (const auto& each : found) nearest = std::min(nearest, std::abs(each - root));
      EXPECT_LT(nearest, 1e-11) << "v = " << v << ", " << root;
    }
  }
}

/// The speed between two others where a property of the eigenvalues changes.
template <class Property>
double critical_speed(double below, double above, const Property& property) {
  const auto holds = [&](double v) { return property(damped_modes(linearised(v).lean_and_steer)); };
  const bool first = holds(below);
  EXPECT_NE(first, holds(above));
  for (int i = 0; i < 55; ++i) {
    const double middle = 0.5 * (below + above);
    (holds(middle) == first ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

TEST(WhippleBicycle, HasThePublishedCriticalSpeeds) {
  const auto oscillates = [](const DampedMode& mode) { return std::abs(mode.eigenvalue.imag()) > 1e-12; };
  const auto grows = [&](bool oscillating) {
    return [=](const std::vector<DampedMode>& modes) {
      return std::any_of(modes.begin(), modes.end(), [&](const DampedMode& mode) {
        return oscillates(mode) == oscillating && mode.eigenvalue.real() > 0.0;
      });
    };
  };
  const auto weaves = [&](const std::vector<DampedMode>& modes) {
    return std::any_of(modes.begin(), modes.end(), oscillates);
  };
  EXPECT_NEAR(critical_speed(0.5, 1.0, weaves), 0.68428307889245579629, 1e-11);
  EXPECT_NEAR(critical_speed(4.0, 5.0, grows(true)), 4.292382536341103958687, 1e-11);
  EXPECT_NEAR(critical_speed(5.5, 7.0, grows(false)), 6.024262015388358889874, 1e-11);
}

// The equations of motion themselves, started with a tiny rate of lean, against the published linear ones: what is left
// out is of the third order in 1e-5, by symmetry.
TEST(WhippleBicycle, MovesAsThePublishedEquationsSayWhileItLeansLittle) {
  constexpr double v = 4.6, rate = 1e-5;
  const auto motion = equations_of_motion<Bicycle>();
  Bicycle::State start = steady(v);
  start.v.roll = rate;
  start.v.y = r_R * rate;
  const auto y = examples::state_at(motion, pack<Bicycle>(start), 0.0, 1.0, precise);
  const auto end = unpack<Bicycle>(1.0, y);
  Eigen::Matrix4d state = Eigen::Matrix4d::Zero();
  state.topRightCorner<2, 2>().setIdentity();
  state.bottomLeftCorner<2, 2>() = -M.inverse() * (g * K0 + v * v * K2);
  state.bottomRightCorner<2, 2>() = -M.inverse() * (v * C1);
  const Eigen::Vector4d linear = matrix_exponential(state) * Eigen::Vector4d(0, 0, rate, 0);
  EXPECT_NEAR(end.q.roll, linear(0), 1e-6 * rate);
  EXPECT_NEAR(end.q.steer, linear(1), 1e-6 * rate);
  EXPECT_NEAR(end.v.roll, linear(2), 1e-6 * rate);
  EXPECT_NEAR(end.v.steer, linear(3), 1e-6 * rate);
}

TEST(WhippleBicycle, ObeysTheEnergyTheoremOnTheRoad) {
  const auto motion = equations_of_motion<Bicycle>();
  const auto balance = examples::energy_balance<Bicycle>(motion, 2.0, 1e-11);
  EXPECT_LE(balance.imbalance, balance.allowed);
  EXPECT_LT(balance.allowed, 1e-4);  // of the 1000 J of its motion
  EXPECT_GT(balance.exchanged, 1.0);
  const auto y = examples::state_at(motion, motion.initial(), 0.0, 2.0, precise);
  Bicycle::Constraints constraints{};
  Bicycle::constraints(motion.precomputed(), unpack<Bicycle>(2.0, y), constraints);
  // Held: rounding of places of some metres and of velocities of some metres a second.
  for (const double height : constraints.value) EXPECT_NEAR(height, 0.0, 1e-14);
  for (const double slip : constraints.rate) EXPECT_NEAR(slip, 0.0, 1e-13);
}

}  // namespace
}  // namespace torsor::whipple_bicycle_test
