// SPDX-License-Identifier: GPL-3.0-or-later
// Packs of every set of options against numbers: bit by bit where nothing is fused, else within what rounding can do.
#include "torsor/runtime/batch/simd.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "generated/heavy_top.hpp"
#include "tests/batch/bounded.hpp"
#include "tests/batch/variant.hpp"
#include "tests/verification/right_to_rounding.hpp"

namespace {

using Number = ::testing::Types<float, double>;

/// Every set of options that this processor runs.
std::vector<const Variant*> variants() {
  std::vector<const Variant*> here;
  for (const Variant* variant : {VARIANTS}) {
    if (variant->runs_here()) here.push_back(variant);
  }
  return here;
}

template <class T>
const CodePaths<T>& paths_of(const Variant& variant) {
  if constexpr (std::is_same_v<T, float>)
    return variant.in_float;
  else
    return variant.in_double;
}

template <class T>
bool same_bits(T a, T b) {
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof(T)) == 0;
}

/// Rows are counted with int here, as lanes are.
template <class T>
class Numbers {
 public:
  explicit Numbers(int size = 0, T value = T{}) : values_(static_cast<std::size_t>(size), value) {}
  void push_back(T value) { values_.push_back(value); }
  T& operator[](int i) { return values_[static_cast<std::size_t>(i)]; }
  const T& operator[](int i) const { return values_[static_cast<std::size_t>(i)]; }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  int size() const { return static_cast<int>(values_.size()); }

 private:
  std::vector<T> values_;
};

template <class T>
Numbers<T> random_states(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<T> angle(T(-1.3), T(1.3)), rate(T(-3), T(3));
  Numbers<T> states;
  for (int i = 0; i < state_count; ++i) {
    states.push_back(rate(random));
    for (int k = 0; k < 3; ++k) states.push_back(angle(random));
    for (int k = 0; k < 3; ++k) states.push_back(rate(random));
  }
  return states;
}

template <class T>
struct TopResults {
  Numbers<T> values{state_count * result_entries};
  Numbers<int> statuses{state_count};
  TopResults(const CodePath<T>& path, const Numbers<T>& states) {
    path.top(states.data(), values.data(), statuses.data());
  }
};

template <class T>
class SimdOf : public testing::Test {};
TYPED_TEST_SUITE(SimdOf, Number);

TYPED_TEST(SimdOf, HasTheLanesOfTheRegistersItIsCompiledFor) {
  using torsor::runtime::NativeSimd;
  EXPECT_EQ(sizeof(NativeSimd<TypeParam>), std::size_t{torsor::runtime::vector_bytes});
  for (const Variant* variant : variants()) {
    const std::string name = variant->name;
    const int bytes = name == "portable" ? torsor::runtime::vector_bytes : name == "avx512" ? 64 : 32;
    EXPECT_EQ(paths_of<TypeParam>(*variant).packs.lanes * int(sizeof(TypeParam)), bytes) << name;
  }
}

TYPED_TEST(SimdOf, RoundsEveryOperationAsTheNumberDoes) {
  using T = TypeParam;
  std::mt19937 random(1);
  std::uniform_real_distribution<T> number(T(-4), T(4));
  const T special[] = {T(0),
                       T(-0.0),
                       T(1),
                       std::numeric_limits<T>::infinity(),
                       -std::numeric_limits<T>::infinity(),
                       std::numeric_limits<T>::quiet_NaN(),
                       std::numeric_limits<T>::denorm_min(),
                       std::numeric_limits<T>::max()};
  Numbers<T> x(state_count), y(state_count), expected(state_count * operation_count), found(expected);
  for (int i = 0; i < state_count; ++i) {
    x[i] = i < 64 ? special[i % 8] : number(random);
    y[i] = i < 64 ? special[i / 8] : i % 7 == 0 ? x[i] : number(random);
  }
  for (int i = 0; i < state_count; ++i) {
    const T a = x[i], b = y[i], size = std::abs(a);
    const T row[operation_count] = {a + b,    a - b,           a * b,         a / b,       -a,
                                    size,     std::sqrt(size), a < b ? a : b, std::exp(a), std::log(size),
                                    T(a < b), T(a <= b),       T(a > b),      T(a >= b)};
    std::copy(row, row + operation_count, &expected[i * operation_count]);
  }
  for (const Variant* variant : variants()) {
    const CodePaths<T>& paths = paths_of<T>(*variant);
    for (const CodePath<T>& path : {paths.packs, paths.arrays}) {
      path.operations(x.data(), y.data(), found.data());
      for (int i = 0; i < found.size(); ++i) {
        EXPECT_TRUE(same_bits(found[i], expected[i]))
            << variant->name << ' ' << path.name << ", operation " << i % operation_count << " of "
            << x[i / operation_count] << ", " << y[i / operation_count] << ": " << found[i] << ", not " << expected[i];
      }
    }
  }
}

/// Bit by bit those of numbers where nothing is fused, and within an ulp in any case.
template <class T>
void expect_sines_and_cosines(const Numbers<T>& x) {
  Numbers<T> s(state_count), c(state_count), s_one(state_count), c_one(state_count);
  for (const Variant* variant : variants()) {
    const CodePaths<T>& paths = paths_of<T>(*variant);
    paths.one.sincos(x.data(), s_one.data(), c_one.data());
    for (const CodePath<T>& path : {paths.packs, paths.arrays}) {
      path.sincos(x.data(), s.data(), c.data());
      for (int i = 0; i < state_count; ++i) {
        if (!variant->fused) {
          EXPECT_TRUE(same_bits(s[i], s_one[i]) && same_bits(c[i], c_one[i]))
              << variant->name << ' ' << path.name << " at " << x[i];
        }
        // The wider type's own error is far below a thousandth of an ulp.
        using Wide = std::conditional_t<std::is_same_v<T, float>, double, long double>;
        const Wide sine = std::sin(Wide(x[i])), cosine = std::cos(Wide(x[i]));
        const auto ulp = [](Wide value) {
          return std::ldexp(Wide(std::numeric_limits<T>::epsilon()), std::ilogb(T(value)));
        };
        EXPECT_LE(std::abs(Wide(s[i]) - sine), Wide(1.001) * ulp(sine)) << variant->name << " sine of " << x[i];
        EXPECT_LE(std::abs(Wide(c[i]) - cosine), Wide(1.001) * ulp(cosine)) << variant->name << " cosine of " << x[i];
      }
    }
  }
}

TYPED_TEST(SimdOf, TakesSinesAndCosinesWithinAnUlpAtAnySize) {
  using T = TypeParam;
  std::mt19937 random(2);
  std::uniform_real_distribution<T> exponent(T(-20), std::is_same_v<T, float> ? T(120) : T(1000)), small(T(-10), T(10));
  for (int round = 0; round < 50; ++round) {
    Numbers<T> x(state_count);
    // Rounds without an angle beyond the bound, with a few, with many
    for (int i = 0; i < state_count; ++i) {
      const bool far = round % 3 == 2 || (round % 3 == 1 && i % 31 == 5);
      x[i] = far ? std::exp2(exponent(random)) * (i % 2 == 0 ? 1 : -1) : small(random);
    }
    expect_sines_and_cosines(x);
  }
}

TYPED_TEST(SimdOf, TakesSinesBesideQuarterTurnsAsTheNumberDoes) {
  using T = TypeParam;
  std::mt19937 random(3);
  // Up to the bound of the fast core, 2^20 or 10^3 quarters of a turn; there next to nothing is left of an angle, and
  // midway between them the nearest one changes.
  std::uniform_real_distribution<double> exponent(0, std::is_same_v<T, float> ? 10 : 20);
  const long double eighth = std::atan(1.0L);
  for (int round = 0; round < 50; ++round) {
    Numbers<T> x(state_count);
    for (int i = 0; i < state_count; ++i) {
      const double quarters = std::floor(std::exp2(exponent(random)));
      x[i] = static_cast<T>((i % 3 == 0 ? 2 * quarters + 1 : 2 * quarters) * eighth);
      for (int k = 0; k < i % 5; ++k) x[i] = std::nextafter(x[i], i % 2 == 0 ? T(0) : T(1e9));
      if (i % 7 < 3) x[i] = -x[i];
    }
    expect_sines_and_cosines(x);
  }
}

TYPED_TEST(SimdOf, TakesSinesOfNoNumberLaneByLane) {
  using T = TypeParam;
  Numbers<T> x(state_count, T(0.5)), s(state_count), c(state_count);
  x[3] = std::numeric_limits<T>::infinity();
  x[8] = std::numeric_limits<T>::quiet_NaN();
  x[9] = T(-0.0);
  for (const Variant* variant : variants()) {
    const CodePaths<T>& paths = paths_of<T>(*variant);
    for (const CodePath<T>& path : {paths.packs, paths.arrays}) {
      path.sincos(x.data(), s.data(), c.data());
      for (int i = 0; i < state_count; ++i) {
        EXPECT_EQ(std::isnan(s[i]) && std::isnan(c[i]), i == 3 || i == 8) << variant->name << ' ' << path.name << i;
      }
      EXPECT_TRUE(same_bits(s[9], T(-0.0)) && c[9] == T(1)) << variant->name << ' ' << path.name;
    }
  }
}

TYPED_TEST(SimdOf, GivesAKernelTheBitsOfTheSingleOneWhenNothingIsFused) {
  using T = TypeParam;
  for (int seed = 1; seed <= 20; ++seed) {
    Numbers<T> states = random_states<T>(static_cast<unsigned>(seed));
    // Angles beyond the bound of the fast sine-cosine in some lanes only
    if (seed > 10) states[seed * state_entries + 1] = T(1e9), states[(seed + 100) * state_entries + 2] = T(-3e12);
    for (const Variant* variant : variants()) {
      if (variant->fused) continue;
      const CodePaths<T>& paths = paths_of<T>(*variant);
      const TopResults<T> expected(paths.one, states);
      for (const CodePath<T>& path : {paths.packs, paths.arrays}) {
        const TopResults<T> found(path, states);
        for (int i = 0; i < found.values.size(); ++i) {
          EXPECT_TRUE(same_bits(found.values[i], expected.values[i]))
              << variant->name << ' ' << path.name << ", seed " << seed << ", state " << i / result_entries
              << ", result " << i % result_entries;
        }
      }
    }
  }
}

/// The heavy top with bounds, one state.
template <bool in_float, class T>
Numbers<Bounded<in_float>> bounded_top(const T* row) {
  using B = Bounded<in_float>;
  using M = heavy_top::Mechanism<B>;
  typename M::State state{{row[0]}, {{row[1]}, {row[2]}, {row[3]}}, {{row[4]}, {row[5]}, {row[6]}}};
  const auto precomputed = M::precompute(M::default_parameters());
  typename M::Accelerations a;
  typename M::Energy energy;
  typename M::GeneralizedForces forces;
  typename M::Multipliers none;
  (void)M::forward_dynamics(precomputed, state, {}, a, none);
  M::energy(precomputed, state, {}, energy);
  M::bias(precomputed, state, forces);
  Numbers<B> results;
  for (int i = 0; i < 3; ++i) results.push_back(a[i]);
  for (int i = 0; i < 3; ++i) results.push_back(energy[i]);
  for (int i = 0; i < 3; ++i) results.push_back(forces[i]);
  return results;
}

TYPED_TEST(SimdOf, GivesAKernelWithinTheBoundOfItsRoundings) {
  using T = TypeParam;
  constexpr bool in_float = std::is_same_v<T, float>;
  constexpr double unit = Bounded<in_float>::unit;
  double worst = 0;
  for (int seed = 1; seed <= 4; ++seed) {
    const Numbers<T> states = random_states<T>(static_cast<unsigned>(seed));
    for (const Variant* variant : variants()) {
      const CodePaths<T>& paths = paths_of<T>(*variant);
      for (const CodePath<T>& path : {paths.one, paths.packs, paths.arrays}) {
        const TopResults<T> found(path, states);
        torsor::testing_rounding::RightToRounding check(unit);
        for (int i = 0; i < state_count; ++i) {
          const auto bounds = bounded_top<in_float>(&states[i * state_entries]);
          ASSERT_EQ(bounds.size(), result_entries);
          for (int k = 0; k < result_entries; ++k) {
            // Twice: the value in the middle has roundings of its own when it is computed in the same type.
            check.entry("result " + std::to_string(k), found.values[i * result_entries + k], bounds[k].value,
                        bounds[k].bound / unit, 2);
          }
        }
        EXPECT_TRUE(check) << variant->name << ' ' << path.name << ": " << check;
        worst = std::max(worst, check.worst());
      }
    }
  }
  // A bound that nothing comes near would find nothing.
  EXPECT_GT(worst, 0.005);
}

TYPED_TEST(SimdOf, SaysOfAPackWhatHoldsOfItsWorstLane) {
  using T = TypeParam;
  Numbers<T> states = random_states<T>(5);
  // The middle axis turned so far that the outer ones agree: the cosine is 0 or less than a rounding.
  const int locked = 7, endless = 61;
  states[locked * state_entries + 2] = std::acos(T(0));
  states[endless * state_entries + 4] = std::numeric_limits<T>::max();
  for (const Variant* variant : variants()) {
    const CodePaths<T>& paths = paths_of<T>(*variant);
    const TopResults<T> one(paths.one, states);
    EXPECT_EQ(one.statuses[locked], 1) << variant->name;
    EXPECT_EQ(one.statuses[endless], 2) << variant->name;
    for (const CodePath<T>& path : {paths.packs, paths.arrays}) {
      const TopResults<T> found(path, states);
      for (int i = 0; i < state_count; ++i) {
        const int pack = i / path.lanes;
        const int expected = pack == locked / path.lanes ? 1 : pack == endless / path.lanes ? 2 : 0;
        EXPECT_EQ(found.statuses[i], expected) << variant->name << ' ' << path.name << ", state " << i;
        if (variant->fused || i == locked || i == endless) continue;
        for (int k = 0; k < result_entries; ++k) {
          EXPECT_TRUE(same_bits(found.values[i * result_entries + k], one.values[i * result_entries + k]))
              << "a neighbour's failure reached state " << i << ' ' << variant->name;
        }
      }
    }
  }
}

}  // namespace
