// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/small_motions/stability.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "tests/runtime/linear_systems.hpp"

namespace stability_test {
namespace {

using namespace torsor::runtime;
using namespace linear_systems;
using Eigen::MatrixXd;

LinearSystem one_degree(double c, double k) {
  LinearSystem system = undamped(MatrixXd::Identity(1, 1), MatrixXd::Constant(1, 1, k));
  system.C(0, 0) = c;
  return system;
}

// m = l = 1, g = 10, a torsion spring k upright: K = k − m g l.
TEST(Stability, OfAnInvertedPendulumIsDecidedByItsSpring) {
  const LinearSystem held = one_degree(0, 12 - 10.0), falling = one_degree(0, 8 - 10.0), critical = one_degree(0, 0);
  EXPECT_EQ(stability_by_lejeune_dirichlet(held.K).verdict, Stability::stable);
  EXPECT_EQ(stability_by_lejeune_dirichlet(falling.K).verdict, Stability::cannot_conclude);
  EXPECT_EQ(stability_by_lejeune_dirichlet(critical.K).verdict, Stability::cannot_conclude);
  EXPECT_EQ(stability_by_eigenvalues(held).verdict, Stability::cannot_conclude);  // ± i sqrt(2)
  EXPECT_EQ(stability_by_eigenvalues(falling).verdict, Stability::unstable);
  EXPECT_EQ(stability_by_eigenvalues(critical).verdict, Stability::cannot_conclude);
  EXPECT_EQ(stability_by_eigenvalues(one_degree(0.3, 2)).verdict, Stability::asymptotically_stable);
  EXPECT_EQ(stability_by_routh(held).verdict, Stability::cannot_conclude);
  EXPECT_EQ(stability_by_routh(falling).verdict, Stability::unstable);
  EXPECT_EQ(stability_by_routh(critical).verdict, Stability::cannot_conclude);
  EXPECT_EQ(stability_by_routh(one_degree(0.3, 2)).verdict, Stability::asymptotically_stable);
}

// x' = A x with A = [0 1; -K -C] has the same roots; a cyclic coordinate beside it adds two zeros that coalesce.
TEST(Stability, OfAStateMatrixIsThatOfItsSystem) {
  for (const auto& [c, k] : {std::pair{0.3, 2.0}, std::pair{0.0, -2.0}, std::pair{-0.1, 2.0}, std::pair{0.0, 2.0}}) {
    MatrixXd A(2, 2);
    A << 0, 1, -k, -c;
    EXPECT_EQ(stability_by_eigenvalues(A).verdict, stability_by_eigenvalues(one_degree(c, k)).verdict);
    MatrixXd beside = MatrixXd::Zero(4, 4);
    beside.topLeftCorner(2, 2) = A;
    beside(2, 3) = 1;
    beside(2, 0) = 5;  // it follows the motion
    const Stability expected = stability_by_eigenvalues(A).verdict;
    EXPECT_EQ(stability_by_eigenvalues(beside).verdict,
              expected == Stability::unstable ? expected : Stability::cannot_conclude);
  }
  // A Jordan block of three zeros that is not seen as such: rounding moves its roots by 1e-5, which proves nothing.
  MatrixXd turn(3, 3), block = MatrixXd::Zero(3, 3);
  turn << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  block(0, 1) = block(1, 2) = 1;
  const StabilityReport report = stability_by_eigenvalues(MatrixXd(turn * block * turn.transpose() / 9.0));
  EXPECT_EQ(report.verdict, Stability::cannot_conclude) << report.reason;
  EXPECT_THROW((void)stability_by_eigenvalues(MatrixXd(MatrixXd::Zero(2, 3))), std::invalid_argument);
}

// Both stiffnesses below Ω²: −(U + T0) has a maximum, the Coriolis forces hold the mass (Kelvin). Lejeune-Dirichlet and
// Liapunov say that they cannot conclude; friction in the turning axes makes it unstable (Kelvin, Tait, Chetaev).
TEST(Stability, OfAGyroscopicallyHeldMassIsNotForLejeuneDirichletToSay) {
  const double square = 1.5 * 1.5;
  LinearSystem system = rotating_mass(square - 0.2, square - 0.3, 1.5);  // K = diag(-0.2, -0.3), 4 Ω² = 9
  EXPECT_EQ(stability_by_lejeune_dirichlet(system.K).verdict, Stability::cannot_conclude);
  const StabilityReport linear = stability_by_eigenvalues(system);
  EXPECT_EQ(linear.verdict, Stability::cannot_conclude) << linear.reason;
  EXPECT_EQ(stability_by_routh(system).verdict, Stability::cannot_conclude);
  system.C += 0.05 * MatrixXd::Identity(2, 2);
  EXPECT_EQ(stability_by_eigenvalues(system).verdict, Stability::unstable);
  EXPECT_EQ(stability_by_routh(system).verdict, Stability::unstable);
}

// Ziegler's column with a follower load P (k = m = l = 1, masses 2 and 1): it flutters above 7/2 − sqrt(2) without
// damping, and already above 41/28 + c²/2 with equal dampers c in both hinges (the course of Routh's condition on
// 2 s⁴ + 7 c s³ + (7 + c² − 2P) s² + 2 c s + 1).
LinearSystem ziegler(double load, double c) {
  LinearSystem system = undamped(MatrixXd::Zero(2, 2), MatrixXd::Zero(2, 2));
  system.M << 3, 1, 1, 1;
  system.C << 2 * c, -c, -c, c;
  system.K << 2 - load, load - 1, -1, 1;
  return system;
}

TEST(Stability, OfZieglersColumnIsLostByFlutterAndByDamping) {
  const double flutter = 3.5 - std::sqrt(2.0);
  EXPECT_EQ(stability_by_eigenvalues(ziegler(flutter - 1e-6, 0)).verdict, Stability::cannot_conclude);
  EXPECT_EQ(stability_by_eigenvalues(ziegler(flutter + 1e-6, 0)).verdict, Stability::unstable);
  for (const double c : {0.01, 0.3}) {
    const double critical = 41.0 / 28.0 + 0.5 * c * c;
    for (const double change : {-1e-4, 1e-4}) {
      const Stability expected = change < 0 ? Stability::asymptotically_stable : Stability::unstable;
      EXPECT_EQ(stability_by_eigenvalues(ziegler(critical + change, c)).verdict, expected);
      EXPECT_EQ(stability_by_routh(ziegler(critical + change, c)).verdict, expected);
    }
  }
  const StabilityReport report = stability_by_lejeune_dirichlet(ziegler(1.0, 0.1).K);
  EXPECT_EQ(report.verdict, Stability::cannot_conclude);
  EXPECT_NE(report.reason.find("not symmetric"), std::string::npos);
}

// x1'' = -1e14 x1 - 1e6 x1' beside x2'' = k x2: two motions, whatever their rates are to each other.
TEST(Stability, OfAStateMatrixDoesNotMindHowFastOthersAre) {
  for (const double k : {9.0, 1.0, 25.0}) {
    MatrixXd A = MatrixXd::Zero(4, 4);
    A(0, 2) = A(1, 3) = 1;
    A(2, 0) = -1e14;
    A(2, 2) = -1e6;
    A(3, 1) = k;
    EXPECT_EQ(stability_by_eigenvalues(A, 1e-9).verdict, Stability::unstable) << k;
    for (const double unit : {1e-6, 1e6}) {  // of x2
      MatrixXd other = A;
      other.row(1) *= unit;
      other.col(1) /= unit;
      EXPECT_EQ(stability_by_eigenvalues(other, 1e-9).verdict, Stability::unstable) << k << ' ' << unit;
    }
  }
}

TEST(Stability, IsUnstableEvenIfOtherRootsAreImaginary) {
  LinearSystem system = undamped(MatrixXd::Identity(2, 2), Eigen::Vector2d(4, -1).asDiagonal());
  EXPECT_EQ(stability_by_eigenvalues(system).verdict, Stability::unstable);
  EXPECT_EQ(stability_by_routh(system).verdict, Stability::unstable);
}

TEST(Stability, ByRouthAgreesWithTheEigenvalues) {
  int stable = 0, unstable = 0;
  for (int seed = 1; seed <= 200; ++seed) {
    LinearSystem system = random_system(3, seed);
    system.C = random_matrix(3, seed + 1000) + 0.8 * MatrixXd::Identity(3, 3);
    system.K += 0.3 * random_matrix(3, seed + 2000);
    const Stability verdict = stability_by_eigenvalues(system).verdict;
    EXPECT_EQ(stability_by_routh(system).verdict, verdict) << seed;
    stable += verdict == Stability::asymptotically_stable;
    unstable += verdict == Stability::unstable;
  }
  EXPECT_GT(stable, 20);
  EXPECT_GT(unstable, 20);
}

// Definiteness does not depend on units: x in metres, y in nanometres.
TEST(LejeuneDirichlet, DoesNotMindUnits) {
  LinearSystem system = undamped(Eigen::Vector2d(1, 1e-18).asDiagonal(), MatrixXd::Zero(2, 2));
  system.K << 2, 1e-9, 1e-9, 1e-18;
  EXPECT_EQ(stability_by_lejeune_dirichlet(system).verdict, Stability::stable);
  system.K << 1, 2e-9, 2e-9, 1e-18;
  EXPECT_EQ(stability_by_lejeune_dirichlet(system).verdict, Stability::cannot_conclude);
}

TEST(LejeuneDirichlet, NeedsAStrictMinimum) {
  MatrixXd hessian(2, 2);
  hessian << 2, 1, 1, 1;
  EXPECT_EQ(stability_by_lejeune_dirichlet(hessian).verdict, Stability::stable);
  hessian << 1, 1, 1, 1;
  EXPECT_EQ(stability_by_lejeune_dirichlet(hessian).verdict, Stability::cannot_conclude);
  EXPECT_EQ(stability_by_lejeune_dirichlet(MatrixXd::Zero(2, 2)).verdict, Stability::cannot_conclude);
  EXPECT_THROW((void)stability_by_lejeune_dirichlet(MatrixXd::Zero(2, 3)), std::invalid_argument);
}

TEST(Stability, HasWordsForEveryVerdict) {
  EXPECT_EQ(describe(Stability::stable), "stable");
  EXPECT_EQ(describe(Stability::asymptotically_stable), "asymptotically stable");
  EXPECT_EQ(describe(Stability::unstable), "unstable");
  EXPECT_EQ(describe(Stability::cannot_conclude), "cannot conclude");
}

// x'' = x - x³, a mass between two wells, its rest at x = 0. Energy v²/2 - x²/2 + x⁴/4 is kept: whatever the start,
// |x0| and |v0| below λ, x² stays below 1 + sqrt(1 + 4 E), v² below 2 E + 1/2, with E = λ²/2 + λ⁴/4. With the
// quantifiers as printed in §7.4.3 (for every λ there is an ε) this rest would be stable; it is not: for ε = 1 there is
// no λ, since x reaches sqrt(2) from any start (Runge-Kutta at this step
// keeps E to 100 s h⁴ = 6e-8 at most). At x = 1 the same is true and stable: there λ = ε/2 does.
TEST(Stability, AsksForADistanceAtTheStartGivenTheOneThatIsAllowed) {
  const auto farthest = [](double rest, double lambda) {  // largest of |x - rest|, |v|, |x| and |v|
    const auto wells = [](double, const std::array<double, 2>& y, std::array<double, 2>& rates) {
      rates = {y[1], y[0] - y[0] * y[0] * y[0]};
      return Evaluation::ok;
    };
    std::array<double, 2> y{rest + lambda, 0.0};
    std::array<double, 3> largest{};
    const auto result =
        integrate(wells, y, 0.0, 100.0, RungeKutta4{.step = 5e-3}, [&](double, const std::array<double, 2>& now) {
          largest[0] = std::fmax(largest[0], std::abs(now[0] - rest));
          largest[1] = std::fmax(largest[1], std::abs(now[1]));
          largest[2] = std::fmax(largest[2], std::abs(now[0]));
        });
    EXPECT_TRUE(result) << describe(result);
    return largest;
  };
  for (const double lambda : {3.0, 0.3, 1e-3, 1e-6, 1e-12}) {
    const double energy = lambda * lambda / 2 + std::pow(lambda, 4) / 4;
    const auto from_middle = farthest(0.0, lambda);
    EXPECT_LT(from_middle[2], 1e-7 + std::sqrt(1 + std::sqrt(1 + 4 * energy)));  // the printed condition holds
    EXPECT_LT(from_middle[1], 1e-7 + std::sqrt(2 * energy + 0.5));
    EXPECT_GT(from_middle[0], 1.0);  // and the rest is unstable
    if (lambda < 0.3) {
      const auto from_well = farthest(1.0, lambda);
      EXPECT_LT(from_well[0], 2 * lambda);
      EXPECT_LT(from_well[1], 2 * lambda);
    }
  }
  EXPECT_EQ(stability_by_eigenvalues(one_degree(0, -1.0)).verdict, Stability::unstable);
  EXPECT_EQ(stability_by_lejeune_dirichlet(one_degree(0, 2.0)).verdict, Stability::stable);
}

// x1' = -x1 + c x2, x2' = -x2: both roots are -1, whatever x2 is measured in.
TEST(StabilityByEigenvalues, KeepsStatesThatFadeByThemselves) {
  for (const double c : {1.0, 1e7, 1e14}) {
    Eigen::Matrix2d A;
    A << -1, c, 0, -1;
    const StabilityReport report = stability_by_eigenvalues(Eigen::MatrixXd(A));
    EXPECT_EQ(report.reason.find("that nothing depends on"), std::string::npos) << c << ": " << report.reason;
  }
}

}  // namespace
}  // namespace stability_test
