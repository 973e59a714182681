// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "generated/rolling_hoop.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "torsor/runtime/mechanism.hpp"

namespace {
volatile long allocations = 0;  // volatile: compilers may take it that operator new has no such effect
}

// Counts for the whole program. Not inlined: g++ 12 would see free() meet operator new and warn, which is the purpose
// here.
#define NOT_INLINED __attribute__((noinline))
NOT_INLINED void* operator new(std::size_t size) {
  allocations = allocations + 1;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
NOT_INLINED void* operator new[](std::size_t size) { return operator new(size); }
NOT_INLINED void operator delete(void* memory) noexcept { std::free(memory); }
NOT_INLINED void operator delete[](void* memory) noexcept { std::free(memory); }
NOT_INLINED void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
NOT_INLINED void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

using namespace torsor::runtime;
using Hoop = rolling_hoop::Mechanism<double>;

TEST(Allocations, AreCountedInThisProgram) {
  const long before = allocations;
  ::operator delete(::operator new(8));  // called like this, the pair may not be left out
  EXPECT_GT(allocations, before);
}

TEST(Allocations, AreNoneInAHundredThousandStepsOfAGeneratedMechanism) {
  const auto motion = equations_of_motion<Hoop>();
  auto y = motion.initial();
  const long before = allocations;
  const auto result = integrate(motion, y, 0.0, 100.0, RungeKutta4{.step = 1e-3});
  EXPECT_EQ(allocations, before);
  EXPECT_TRUE(result) << describe(result);
  EXPECT_EQ(result.statistics.accepted, 100'000);
}

}  // namespace
