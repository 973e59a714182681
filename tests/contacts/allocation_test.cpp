// SPDX-License-Identifier: GPL-3.0-or-later
// A program of its own: it counts every allocation of the C library, which operator new and Eigen come to.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "torsor/runtime/contacts/moreau_jean.hpp"
#include "tests/contacts/rod_over_table.hpp"
#include "tests/contacts/rows_of_discs.hpp"
#include "tests/contacts/simple_systems.hpp"

namespace {
long allocations = 0;
}

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
}

namespace contact_allocation_test {
namespace {

using namespace simple_systems;

constexpr DormandPrince853 precise{.relative_tolerance = 1e-12, .absolute_tolerance = 1e-12};

TEST(ContactAllocations, AreCounted) {
  const long before = allocations;
  ::operator delete(::operator new(40));
  const Eigen::MatrixXd zeros = Eigen::MatrixXd::Zero(40, 40);
  const double* volatile first = zeros.data();
  const long after = allocations;
  EXPECT_EQ(*first, 0);
  EXPECT_EQ(after - before, 2);
}

struct Events {
  long impacts = 0, opens = 0, slips = 0;
  bool operator()(const ContactEvent& event) {
    impacts += event.kind == ContactEventKind::impact || event.kind == ContactEventKind::accumulation ? 1 : 0;
    opens += event.kind == ContactEventKind::opens ? 1 : 0;
    slips += event.kind == ContactEventKind::slips ? 1 : 0;
    return true;
  }
};

// Steps and events after the first second allocate nothing.
template <class S, std::size_t size>
Events expect_none(const S& system, std::array<double, size> y, std::int64_t steps) {
  const ContactMechanismOf<S> mechanism(system);
  Events events;
  ContactRun<size, S::contacts, DormandPrince853, Events> run(mechanism, y, precise, {}, events);
  EXPECT_TRUE(run.start(0) && run.advance(1)) << describe(run.result().status);
  events = {};
  const long before = allocations;
  const std::int64_t first = run.result().integration.statistics.accepted;
  for (int k = 2; run.result() && run.result().integration.statistics.accepted < first + steps; ++k) run.advance(k);
  const long after = allocations;
  EXPECT_TRUE(run.result()) << describe(run.result().status) << " at " << run.result().time;
  EXPECT_EQ(after - before, 0);
  return events;
}

TEST(ContactAllocations, AreNoneWhereAJointRubsByItsOwnReaction) {
  const Events events = expect_none(pendulum_in_a_journal(0.45, 5), std::array{0.0, 0.0}, 2'000);
  EXPECT_GT(events.slips, 10);
}

TEST(ContactAllocations, AreNoneInStepsOfAMotionWhoseContactOpensAndCloses) {
  constexpr double A = 0.04, w = 20;
  const Events events = expect_none(ball_on_table(0.3, A, w), std::array{0.0, A * w}, 100'000);
  EXPECT_GT(events.impacts, 1000);
  EXPECT_GT(events.opens, 1000);
}

TEST(ContactAllocations, AreNoneInStepsOfABlockThatSticksAndSlides) {
  const Events events = expect_none(block_on_belt(1, 100, 0.5, 10, 0.5, 0.3), std::array{0.0, 0.5}, 20'000);
  EXPECT_GT(events.slips, 100);
}

// Its slip begins, turns and ends in space: a block on a plane, pushed round by a force on an ellipse.
TEST(ContactAllocations, AreNoneInStepsOfABlockThatIsPushedRound) {
  auto block = block_on_plane(0.4);
  block.fill = [still = block.fill](double t, const auto& y, auto& r) {
    still(t, y, r);
    r.F(0) = 5 * std::cos(3 * t);
    r.F(1) = 2 * std::sin(3 * t);
  };
  const Events events = expect_none(block, std::array<double, 6>{}, 20'000);
  EXPECT_GT(events.slips, 20);
}

// A closed loop, two contacts with two tangents each, which stick and slide in turn.
TEST(ContactAllocations, AreNoneInStepsOfALoopOnAShakenTable) {
  const rod_over_table::Rod rod;
  const Events events = expect_none(rod, rod.above(0.3), 1'000);
  EXPECT_GT(events.slips, 10);
}

TEST(ContactAllocations, AreNoneInStepsOfEqualLength) {
  const auto ball = billiard_ball(0.2, 0.03, 0.2, 0.6);
  std::array<double, 9> y{0, 0, 0.5, 1, 0, 0, 3, 40, -20};
  MoreauJean scheme(ball);
  for (int k = 0; k < 10; ++k) ASSERT_TRUE(scheme.step(1e-3 * k, 1e-3, y));
  const long before = allocations;
  bool made = true;
  for (int k = 10; k < 10'000; ++k) made = made && scheme.step(1e-3 * k, 1e-3, y);
  EXPECT_EQ(allocations, before);
  EXPECT_TRUE(made);
  EXPECT_NEAR(y[2], 0.03, 1e-5);
}

// Rest, a motion that is possible as well, and reactions that are not unique, of 22 contacts and of seven.
TEST(ContactAllocations, AreNoneWhereRestOfManyContactsIsFound) {
  for (const std::vector<int>& rows : {std::vector<int>{4, 3, 2, 1}, {3, 1}}) {
    const ContactProblem problem = rows_of_discs::problem_of(rows_of_discs::touches(rows), rows_of_discs::discs(rows), 0.5);
    const long before = allocations;
    const ContactAnswer answer = solve_contacts(problem);
    EXPECT_EQ(allocations, before);
    EXPECT_TRUE(answer.best().indeterminate);
  }
}

}  // namespace
}  // namespace contact_allocation_test
