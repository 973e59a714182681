// SPDX-License-Identifier: GPL-3.0-or-later
// Motions of mechanisms drawn at random, by every method that applies: the ends agree within what the methods state, or
// a method says that it failed. The energy theorem, first integrals and closures are checked at the ends.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>

#include "torsor/generator/base/error.hpp"
#include "torsor/runtime/constraints/consistent_state.hpp"
#include "torsor/runtime/constraints/partitioned_motion.hpp"
#include "torsor/runtime/constraints/projection.hpp"
#include "torsor/runtime/integration/dormand_prince_54.hpp"
#include "torsor/runtime/integration/dormand_prince_853.hpp"
#include "torsor/runtime/integration/gauss_collocation.hpp"
#include "torsor/runtime/integration/radau_iia_5.hpp"
#include "torsor/runtime/integration/stabilised_radau_iia_5.hpp"
#include "torsor/runtime/integration/taylor.hpp"
#include "torsor/runtime/mechanism.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/motions/padded_mechanism.hpp"
#include "tests/long_tests.hpp"

namespace torsor::random_motions_test {
namespace {

using namespace torsor::runtime;
using testing_mechanisms::RandomMechanismOptions;
using testing_motions::EvaluatedScene;

/// Trees and loops with q' = v, of exactly four freedoms by the idle coordinates that are held; and those with attitudes.
using Plain = testing_motions::PaddedMechanism<0, 10, 10, 7>;
using Turning = testing_motions::PaddedMechanism<2, 9, 13, 12>;
constexpr std::size_t freedoms = 5;  // four, and the work
constexpr double duration = 0.25, tolerance = 1e-9, sharp = 1e-12;

/// The first of the forty seeds of a kind: 1, or what TORSOR_FIRST_SEED says, for mechanisms that nobody has seen.
unsigned first_seed() {
  const char* given = std::getenv("TORSOR_FIRST_SEED");
  return given == nullptr ? 1U : static_cast<unsigned>(std::strtoul(given, nullptr, 10));
}

/// Every method for every mechanism where TORSOR_LONG_TESTS is set, else every third, in turns; those of constraints, which few
/// mechanisms allow, for each.
bool in_turn(unsigned seed, unsigned method) {
  return wanted(false, true) || (seed + method) % 3 == 0;
}

/// What became of the motions by one method.
struct Tally {
  int right = 0, refused = 0;
};

template <class M>
class Motions {
 public:
  using Vector = StateVector<M>;
  static constexpr std::size_t nq = coordinates_of<M>, size = nq + velocities_of<M>, work = size - 1;

  Motions(EvaluatedScene& scene, unsigned seed, std::map<std::string, Tally>& tallies)
      : scene_(scene), seed_(seed), tallies_(tallies) {
    M::current = &scene;
    M::holding = 0;
    if constexpr (M::quaternion_count == 0) {
      const int held =
          static_cast<int>(velocities_of<M>) - static_cast<int>(freedoms) - scene.sizes().independent_constraints;
      const int idle = static_cast<int>(velocities_of<M>) - 1 - scene.sizes().velocities;
      M::holding = std::clamp(held, 0, std::min(idle, M::multiplier_count - scene.sizes().constraints));
    }
  }

  /// False where no motion could begin or be followed to the end.
  bool run() {
    Vector start;
    if (!begin(start)) return false;
    const auto raw = unprojected_motion<M>();
    const auto motion = projected(raw);
    Vector end = start;
    const auto reference = integrate(motion, end, 0.0, duration, adaptive<DormandPrince853>(sharp));
    if (!reference) return false;
    // Errors grow as displaced starts do; two directions, of which none need be the worst.
    double growth = 1.0;
    for (int k = 0; k < 2; ++k) {
      Vector moved = start;
      for (std::size_t i = 0; i < size; ++i) moved[i] += 1e-7 * uniform();
      if (project_on_constraints<M>(motion.precomputed(), 0.0, moved).evaluation != Evaluation::ok) return false;
      Vector moved_end = moved;
      if (!integrate(motion, moved_end, 0.0, duration, adaptive<DormandPrince853>(tolerance))) return false;
      growth = std::max(growth, 5 * distance(moved_end, end) / distance(moved, start));
    }
    const auto steps = [](const auto& result) { return static_cast<double>(result.statistics.accepted + 1); };
    const double largest = std::max(1.0, std::max(size_of(start), size_of(end)));
    const auto promise = [&](double tol, double count) { return growth * count * tol * 2 * largest; };
    const double own = promise(sharp, steps(reference));

    const auto compare = [&](const std::string& name, const Vector& y, const auto& result, double stated,
                             bool knows_work = true) {
      Tally& tally = tallies_[name];
      if (!result) {
        ++tally.refused;
        return;
      }
      ++tally.right;
      double off = distance(y, end, knows_work);
      EXPECT_LE(off, stated + own) << name << ", seed " << seed_ << ", growth " << growth;
    };
    unsigned methods = 0;
    const auto always_by = [&](const std::string& name, const auto& system, const auto& method, bool knows_work = true) {
      Vector y = start;
      const auto result = integrate(system, y, 0.0, duration, method);
      compare(name, y, result, promise(tolerance, steps(result)), knows_work);
    };
    const auto by = [&](const std::string& name, const auto& system, const auto& method, bool knows_work = true) {
      if (in_turn(seed_, methods++)) always_by(name, system, method, knows_work);
    };
    conserves(start, end, own);
    closes(end);
    by("8(5,3)", motion, adaptive<DormandPrince853>(tolerance));
    by("8(5,3) default", equations_of_motion<M>(), adaptive<DormandPrince853>(tolerance));
    by("8(5,3) raw", raw, adaptive<DormandPrince853>(tolerance));
    by("5(4)", motion, adaptive<DormandPrince54>(tolerance));
    by("Radau", motion, adaptive<RadauIia5>(tolerance));
    if (scene_.has_jets()) by("Taylor", motion, adaptive<Taylor>(tolerance), false);
    if (scene_.sizes().constraints > 0 && !scene_.has_friction())
      always_by("stabilised Radau", raw, adaptive<StabilisedRadauIia5>(tolerance));
    if (in_turn(seed_, methods++)) gauss(motion, start, compare, own);
    if constexpr (M::quaternion_count == 0) {
      // Some have more freedoms, or too few idle coordinates to be held.
      const bool has_them = velocities_of<M> - freedoms ==
                            static_cast<std::size_t>(M::holding + scene_.sizes().independent_constraints);
      if (scene_.sizes().constraints > 0 && has_them) {
        Vector y = start;
        const auto result = integrate_partitioned<freedoms>(raw, y, 0.0, duration, adaptive<DormandPrince853>(tolerance));
        compare("partitioned", y, result, promise(tolerance, steps(result.integration)));
      }
    }
    return true;
  }

 private:
  template <class Method>
  static Method adaptive(double tol) {
    Method method;
    method.relative_tolerance = method.absolute_tolerance = tol;
    method.step_limit = 20000;
    return method;
  }

  double uniform() { return static_cast<double>(static_cast<std::int32_t>(random_())) * 0x1p-31; }

  bool begin(Vector& y) {
    y = pack<M>(M::initial_state());
    const bool tree = scene_.sizes().constraints == 0;
    for (std::size_t i = 0; i < scene_.positions().size(); ++i) {
      if (tree) y[static_cast<std::size_t>(M::slot(scene_, i))] += 0.5 * uniform();
    }
    for (int i = 0; i < scene_.sizes().velocities; ++i) y[nq + static_cast<std::size_t>(i)] = uniform();
    if constexpr (HasQuaternions<M>) normalise_quaternions<M>(y);
    const auto precomputed = M::precompute(M::current);
    if (!find_consistent_state<M>(precomputed, 0.0, y)) return false;
    return project_on_constraints<M>(precomputed, 0.0, y).evaluation == Evaluation::ok;
  }

  static double size_of(const Vector& y) {
    double largest = 0.0;
    for (const double value : y) largest = std::max(largest, std::abs(value));
    return largest;
  }
  /// Quaternions e and −e are one attitude. The integral of the work's velocity is nobody's.
  static double distance(const Vector& a, const Vector& b, bool knows_work = true) {
    double largest = 0.0;
    for (int k = 0; k < M::quaternion_count; ++k) {
      double same = 0.0, turned = 0.0;
      for (std::size_t i = static_cast<std::size_t>(4 * k); i < static_cast<std::size_t>(4 * k + 4); ++i) {
        same = std::max(same, std::abs(a[i] - b[i]));
        turned = std::max(turned, std::abs(a[i] + b[i]));
      }
      largest = std::max(largest, std::min(same, turned));
    }
    for (std::size_t i = static_cast<std::size_t>(4 * M::quaternion_count); i < size; ++i) {
      if (i + 1 != nq && (knows_work || i != work)) largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
  }

  /// Twice the step is off by so much more that the difference of both bounds the finer's error, where h is small enough.
  template <class Motion, class Compare>
  void gauss(const Motion& motion, const Vector& start, const Compare& compare, double own) {
    Vector coarse = start, fine = start, finest = start;
    const auto first = integrate(motion, coarse, 0.0, duration, GaussCollocation<3>{.step = duration / 32});
    const auto second = integrate(motion, fine, 0.0, duration, GaussCollocation<3>{.step = duration / 64});
    const auto third = integrate(motion, finest, 0.0, duration, GaussCollocation<3>{.step = duration / 128});
    const double between = distance(coarse, fine), beyond = distance(fine, finest);
    if (first && second && third && (beyond < between / 8 || beyond < own)) compare("Gauss", finest, third, beyond);
  }

  template <class Quantity>
  double at(double t, const Vector& y, const Quantity& quantity) {
    M::move(M::precompute(M::current), unpack<M>(t, y));
    return quantity();
  }
  /// What a quantity may be off where each number of the state is.
  template <class Quantity>
  double slack(const Vector& y, double off, const Quantity& quantity) {
    const double here = at(duration, y, quantity);
    double sum = 1e-13 * (1 + std::abs(here));
    for (std::size_t i = 0; i < size; ++i) {
      Vector moved = y;
      moved[i] += off;
      sum += std::abs(at(duration, moved, quantity) - here);
    }
    return sum;
  }
  void conserves(const Vector& start, const Vector& end, double own) {
    const auto energy = [&] { return scene_.energy(); };
    const double change = at(duration, end, energy) - at(0.0, start, energy);
    EXPECT_NEAR(change, end[work], slack(end, own, energy) + own) << "energy, seed " << seed_;
    for (const Value& integral : scene_.first_integrals()) {
      const auto value = [&] { return scene_.evaluate(integral); };
      EXPECT_NEAR(at(duration, end, value), at(0.0, start, value), slack(end, own, value)) << "integral, seed " << seed_;
    }
  }
  void closes(const Vector& end) {
    M::move(M::precompute(M::current), unpack<M>(duration, end));
    for (int j = 0; j < scene_.sizes().constraints; ++j) {
      double sum = 1.0;
      for (int i = 0; i < scene_.sizes().velocities; ++i) sum += std::abs(scene_.constraint_jacobian(j, i));
      EXPECT_LE(std::abs(scene_.constraint(j)), 1e-12 * sum * std::max(1.0, size_of(end))) << "seed " << seed_;
      EXPECT_LE(std::abs(scene_.constraint_rate(j)), 1e-12 * sum * std::max(1.0, size_of(end))) << "seed " << seed_;
    }
  }

  EvaluatedScene& scene_;
  unsigned seed_;
  std::map<std::string, Tally>& tallies_;
  std::mt19937 random_{seed_};
};

struct Kind {
  const char* name;
  RandomMechanismOptions options;
};

class RandomMotions : public testing::TestWithParam<Kind> {};

// Forty of each kind: two hundred.
TEST_P(RandomMotions, AgreeByAllMethodsOrSaySo) {
  std::map<std::string, Tally> tallies;
  int followed = 0, drawn = 0;
  for (unsigned seed = first_seed(), last = seed + 39; seed <= last; ++seed) {
    const Scene scene = testing_mechanisms::random_mechanism(seed, GetParam().options);
    SCOPED_TRACE(testing_mechanisms::call_of(seed, GetParam().options));
    try {
      EvaluatedScene evaluated(scene);
      const auto& sizes = evaluated.sizes();
      if (sizes.velocities == 0) continue;
      if (Plain::holds(sizes)) {
        ++drawn;
        followed += Motions<Plain>(evaluated, seed, tallies).run() ? 1 : 0;
      } else if (Turning::holds(sizes)) {
        ++drawn;
        followed += Motions<Turning>(evaluated, seed, tallies).run() ? 1 : 0;
      }
    } catch (const SceneError&) {
      continue;  // drawn without matter, or with constraints that contradict each other
    }
  }
  std::printf("%s: %d drawn, %d followed\n", GetParam().name, drawn, followed);
  for (const auto& [name, tally] : tallies) std::printf("  %-18s %d right, %d refused\n", name.c_str(), tally.right, tally.refused);
  // A test of nothing would pass: most motions are followed, and most methods follow most of them.
  EXPECT_GE(drawn, 20);
  EXPECT_GE(followed, drawn / 2);
  for (const auto& [name, tally] : tallies) EXPECT_GE(tally.right, 2 * tally.refused) << name;
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, RandomMotions,
    testing::Values(Kind{"Trees", {.released = false, .constraints = false, .most_bodies = 4}},
                    Kind{"Attitudes", {.released = false, .constraints = false, .joints = true, .most_bodies = 3}},
                    Kind{"Constrained", {.driven = false, .released = false, .most_bodies = 4}},
                    Kind{"Loops", {.released = false, .constraints = false, .loops = true, .most_bodies = 1}},
                    Kind{"Chains", {.released = false, .constraints = false, .chains = true, .most_bodies = 1}}),
    [](const auto& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace torsor::random_motions_test
