// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "torsor/runtime/contacts/contact_solver.hpp"
#include "tests/long_tests.hpp"

namespace random_contacts_test {
namespace {

using namespace torsor::runtime;
using torsor::wanted;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most = 4;

// u = J v of a mechanism of 2 to 7 freedoms with unit masses: few freedoms make reactions indeterminate. Some contacts
// slide already: then motions may be several or none.
ContactProblem random_problem(std::mt19937& source, int tangents) {
  std::normal_distribution<double> normal;
  ContactProblem problem;
  problem.count = 1 + static_cast<int>(source() % most);
  const int rows = problem.count * (1 + tangents), freedoms = 2 + static_cast<int>(source() % 6);
  MatrixXd J(rows, freedoms);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < freedoms; ++j) J(i, j) = normal(source);
  }
  VectorXd v(freedoms);
  for (int j = 0; j < freedoms; ++j) v(j) = normal(source);
  problem.W = J * J.transpose();
  problem.q = J * v;
  for (int i = 0; i < problem.count; ++i) {
    ContactLaw& law = problem.laws[static_cast<std::size_t>(i)];
    law = coulomb(tangents, std::abs(normal(source)));
    if (source() % 4 == 0) {
      law.slips = true;
      const double angle = 2 * std::numbers::pi * static_cast<double>(source() % 1000) / 1000;
      law.slip = tangents == 1 ? std::array<double, 2>{angle > 3 ? 1.0 : -1.0, 0}
                               : std::array<double, 2>{std::cos(angle), std::sin(angle)};
    }
  }
  return problem;
}

// All solutions of a planar problem by its polyhedra: in each combination of pieces of the laws, A r = b and G r >= h;
// vertices and extreme rays by trying which inequalities hold as equations.
class Polyhedra {
 public:
  explicit Polyhedra(const ContactProblem& problem) : problem_(problem), n_(2 * problem.count) {
    std::vector<int> piece(static_cast<std::size_t>(problem.count), 0);
    for (bool more = true; more;) {
      visit(piece);
      more = false;
      for (std::size_t i = 0; i < piece.size() && !more; ++i) {
        more = ++piece[i] < (problem.laws[i].slips ? 2 : 4);
        if (!more) piece[i] = 0;
      }
    }
  }

  ContactVerdict verdict() const {
    if (vertices.empty()) return ContactVerdict::none;
    bool several = moving_ray_, many = ray_;
    for (const VectorXd& r : vertices) {
      several = several || far(motion(r), motion(vertices[0]));
      many = many || far(r, vertices[0]);
    }
    return several ? ContactVerdict::several : many ? ContactVerdict::indeterminate : ContactVerdict::unique;
  }

  bool has_motion(const VectorXd& u) const {
    return moving_ray_ ||
           std::any_of(vertices.begin(), vertices.end(), [&](const VectorXd& r) { return !far(motion(r), u); });
  }

  std::vector<VectorXd> vertices;

 private:
  VectorXd motion(const VectorXd& r) const { return problem_.W * r + problem_.q; }
  static bool far(const VectorXd& a, const VectorXd& b) { return (a - b).norm() > 1e-6 * (1 + a.norm()); }

  void visit(const std::vector<int>& piece) {
    MatrixXd A(0, n_), G(0, n_);
    VectorXd b(0), h(0);
    const auto add = [&](MatrixXd& rows, VectorXd& right, const VectorXd& row, double value) {
      rows.conservativeResize(rows.rows() + 1, n_);
      rows.row(rows.rows() - 1) = row.transpose();
      right.conservativeResize(rows.rows());
      right(rows.rows() - 1) = value;
    };
    for (int i = 0; i < problem_.count; ++i) {
      const ContactLaw& law = problem_.law(i);
      const VectorXd N = VectorXd::Unit(n_, 2 * i), T = VectorXd::Unit(n_, 2 * i + 1);
      const VectorXd uN = problem_.W.row(2 * i).transpose(), uT = problem_.W.row(2 * i + 1).transpose();
      const double qN = -problem_.q(2 * i), qT = -problem_.q(2 * i + 1);
      const int kind = piece[static_cast<std::size_t>(i)];
      if (kind == 0) {
        add(A, b, N, 0);
        add(A, b, T, 0);
        add(G, h, uN, qN);
        continue;
      }
      add(A, b, uN, qN);
      add(G, h, N, 0);
      const double to = law.slips ? law.slip[0] : kind == 1 ? 1 : -1;
      if (kind == 3) {
        add(A, b, uT, qT);
        add(G, h, law.friction * N - T, 0);
        add(G, h, law.friction * N + T, 0);
      } else {
        add(A, b, T + to * law.friction * N, 0);
        if (!law.slips) add(G, h, to * uT, to * qT);
      }
    }
    Eigen::FullPivLU<MatrixXd> equations(A);
    equations.setThreshold(1e-9);
    const VectorXd point = equations.solve(b);
    if ((A * point - b).norm() > 1e-7 * (1 + point.norm())) return;  // none, whatever else holds
    const auto freedoms = static_cast<int>(n_ - equations.rank());
    const Eigen::Index tight = G.rows();
    for (unsigned chosen = 0; chosen < (1U << tight); ++chosen) {
      // A vertex needs as many more equations as there are freedoms, a ray one less.
      const int more = std::popcount(chosen);
      if (more != freedoms && more != freedoms - 1) continue;
      MatrixXd C = A;
      VectorXd d = b;
      for (Eigen::Index k = 0; k < tight; ++k) {
        if (chosen >> k & 1U) add(C, d, G.row(k).transpose(), h(k));
      }
      Eigen::FullPivLU<MatrixXd> lu(C);
      lu.setThreshold(1e-9);
      const VectorXd r = lu.solve(d);
      if (lu.rank() == n_) {
        const double size = 1 + r.norm();
        if ((C * r - d).norm() < 1e-8 * size && (G * r - h).minCoeff() > -1e-8 * size && size < 1e7)
          vertices.push_back(r);
      } else if (lu.rank() == n_ - 1) {
        const VectorXd ray = lu.kernel().col(0).normalized();
        for (const double sign : {1.0, -1.0}) {
          if ((G * (sign * ray)).minCoeff() > -1e-8) {
            rays_.push_back(sign * ray);
          }
        }
      }
    }
    // A ray counts where there is a point to start from in the same piece.
    bool some = false;
    for (const VectorXd& r : vertices) {
      some = some || ((A * r - b).norm() < 1e-7 * (1 + r.norm()) && (G * r - h).minCoeff() > -1e-7 * (1 + r.norm()));
    }
    for (const VectorXd& ray : rays_) {
      ray_ = ray_ || some;
      moving_ray_ = moving_ray_ || (some && (problem_.W * ray).norm() > 1e-6);
    }
    rays_.clear();
  }

  const ContactProblem& problem_;
  const Eigen::Index n_;
  std::vector<VectorXd> rays_;
  bool ray_ = false, moving_ray_ = false;
};

void expect_lawful(const ContactProblem& problem, const ContactSolution& s) {
  EXPECT_LE(s.residual, 1e-13);
  for (int i = 0; i < problem.count; ++i) {
    const ContactLaw& law = problem.law(i);
    const int n = problem.first_row(i);
    EXPECT_GE(s.r(n), 0.0);
    EXPECT_GE(s.u(n), 0.0);
    const double T = law.tangents == 1 ? std::abs(s.r(n + 1)) : std::hypot(s.r(n + 1), s.r(n + 2));
    EXPECT_LE(T, law.friction * s.r(n) * (1 + 1e-15));
  }
  // The motion is that of the reactions, to rounding of its terms.
  const VectorXd u = problem.W * s.r + problem.q;
  const VectorXd size = problem.W.cwiseAbs() * s.r.cwiseAbs() + problem.q.cwiseAbs();
  EXPECT_LE((u - s.u).cwiseAbs().maxCoeff(), 1e-12 * size.maxCoeff());
}

// Random numbers lie within 1e-8 of a boundary, where the two could decide otherwise, in some 1e-7 of all problems.
TEST(RandomContacts, InThePlaneHaveTheVerdictOfAllTheirPolyhedra) {
  std::mt19937 source(20261122);
  std::array<int, 4> seen{};
  for (int k = 0; k < wanted(400, 100000); ++k) {
    const ContactProblem problem = random_problem(source, 1);
    const Polyhedra truth(problem);
    const auto answer = solve_contacts(problem);
    ASSERT_EQ(answer.verdict, truth.verdict()) << "problem " << k << " with " << problem.count << " contacts";
    ++seen[static_cast<std::size_t>(answer.verdict)];
    for (std::size_t i = 0; i < answer.count; ++i) {
      expect_lawful(problem, answer.solutions[i]);
      EXPECT_TRUE(truth.has_motion(answer.solutions[i].u) || answer.verdict == ContactVerdict::several) << k;
    }
  }
  for (const int count : seen) EXPECT_GT(count, 5);  // each verdict occurs
}

// The 65284th of the long test: forces of 1e7 that cancel give the same motion to 3e-9, once told as another one.
TEST(RandomContacts, HaveOneMotionWhereForcesWithoutNeedBlurIt) {
  std::mt19937 source(20261122);
  for (int k = 0; k < 65283; ++k) static_cast<void>(random_problem(source, 1));
  const ContactAnswer answer = solve_contacts(random_problem(source, 1));
  EXPECT_EQ(answer.verdict, ContactVerdict::indeterminate);
  EXPECT_LT(answer.best().r.cwiseAbs().maxCoeff(), 10);
}

// In space another algorithm, started anywhere, finds nothing that was not found; and finds nothing where none is.
TEST(RandomContacts, InSpaceHaveNoMotionThatWasNotFound) {
  std::mt19937 source(1122);
  std::normal_distribution<double> normal;
  int moving = 0, compared = 0;
  for (int k = 0; k < wanted(100, 2000); ++k) {
    const ContactProblem problem = random_problem(source, 2);
    if (problem.count > 2) continue;
    const auto answer = solve_contacts(problem);
    for (std::size_t i = 0; i < answer.count; ++i) expect_lawful(problem, answer.solutions[i]);
    for (int start = 0; start < 6; ++start) {
      ContactVector r(problem.rows());
      for (int i = 0; i < r.size(); ++i) r(i) = normal(source);
      const auto other = iterate_contacts(problem, r, {.sweeps = 20, .attempts = 6});
      if (!other) continue;
      ++compared;
      bool found = false;
      for (std::size_t i = 0; i < answer.count; ++i) {
        found = found || (answer.solutions[i].u - other.best().u).norm() < 1e-7;
      }
      EXPECT_TRUE(found) << "problem " << k << ": " << describe(answer.verdict);
    }
    moving += answer.count > 0 && answer.best().u.norm() > 0 ? 1 : 0;
  }
  EXPECT_GT(compared, 50);
  EXPECT_GT(moving, 10);
}

// One contact in space: slip along every direction in turn is a scan that needs no algebra.
TEST(RandomContacts, AloneInSpaceHaveAsManySlipsAsAScanOfDirectionsFinds) {
  std::mt19937 source(77);
  std::normal_distribution<double> normal;
  int several = 0;
  for (int k = 0; k < wanted(100, 2000); ++k) {
    ContactProblem problem;
    problem.count = 1;
    Eigen::Matrix3d J;
    for (int i = 0; i < 9; ++i) J(i / 3, i % 3) = normal(source);
    J.row(0) *= 0.3;  // coupled so that slips may be several
    problem.W = J * J.transpose();
    problem.q.resize(3);
    for (int i = 0; i < 3; ++i) problem.q(i) = normal(source);
    const double f = 4 * std::abs(normal(source));
    problem.laws[0] = coulomb(2, f);
    int slips = 0;
    constexpr int steps = 20000;
    double before = 0;
    for (int j = 0; j <= steps; ++j) {
      const double angle = 2 * std::numbers::pi * j / steps, c = std::cos(angle), s = std::sin(angle);
      const Eigen::Vector3d pull(1, -f * c, -f * s);
      const Eigen::Vector3d column = problem.W * pull;
      const double N = -problem.q(0) / column(0);
      const Eigen::Vector3d u = column * N + problem.q;
      const double across = (c * u(2) - s * u(1)) * column(0);
      if (j > 0 && (across > 0) != (before > 0) && N > 0 && c * u(1) + s * u(2) > 0) ++slips;
      before = across;
    }
    const auto answer = solve_contacts(problem);
    int found = 0;
    for (std::size_t i = 0; i < answer.count; ++i)
      found += answer.solutions[i].regimes[0] == ContactRegime::slides ? 1 : 0;
    EXPECT_EQ(found, slips) << "problem " << k;
    several += answer.verdict == ContactVerdict::several ? 1 : 0;
  }
  EXPECT_GT(several, 0);
}

}  // namespace
}  // namespace random_contacts_test
