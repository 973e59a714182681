// SPDX-License-Identifier: GPL-3.0-or-later
// The sine-cosine of generated headers against the C library's quad precision, which 60 digits of its own sixty more
// than a double needs, and against CLN where that could not decide. TORSOR_LONG_TESTS: 10^8 doubles and every float.
#include <algorithm>
#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/long_tests.hpp"
#include "torsor/generator/verification/worst.hpp"
#include "tests/sincos/truth.hpp"
#include "tests/sincos/variant.hpp"

namespace {

constexpr double bound = 0x1p21;  // of the branch-free core
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<const Variant*> variants() {
  std::vector<const Variant*> all{&portable_variant};
#ifdef TORSOR_HAS_FUSED_VARIANT
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) all.push_back(&fused_variant);
#endif
  return all;
}

/// The greatest errors seen and where.
struct Worst {
  double sine = 0, cosine = 0, at_sine = 0, at_cosine = 0;

  void add(double angle, double of_sine, double of_cosine) {
    if (torsor::is_worse(of_sine, sine)) sine = of_sine, at_sine = angle;
    if (torsor::is_worse(of_cosine, cosine)) cosine = of_cosine, at_cosine = angle;
  }
};

void expect_one_ulp(const Worst& worst, const std::string& what) {
  std::cout << what << ": at most " << worst.sine << " ulp (sine), " << worst.cosine << " ulp (cosine)\n";
  EXPECT_LE(worst.sine, 1) << what << ", sine at " << std::hexfloat << worst.at_sine;
  EXPECT_LE(worst.cosine, 1) << what << ", cosine at " << std::hexfloat << worst.at_cosine;
}

/// What the quad value cannot decide, its own error included, CLN does.
double decided(double computed, Quad exact, double angle, bool is_sine) {
  const double error = ulps(computed, exact);
  return std::abs(error - 1) < 1e-9 ? ulps_by_cln(computed, angle, is_sine) : error;
}

/// Angles one by one, eight together, and five and three, by every variant.
void expect_one_ulp(const std::string& what, std::size_t count, const std::function<double(std::size_t)>& angle) {
  const std::vector<const Variant*> all = variants();
  std::vector<Worst> one(all.size()), eight(all.size());
  for (std::size_t first = 0; first < count; first += 8) {
    double x[8], s[8], c[8];
    Quad exact_s[8], exact_c[8];
    for (std::size_t i = 0; i < 8; ++i) {
      x[i] = angle(std::min(first + i, count - 1));
      quad_sincos(x[i], exact_s[i], exact_c[i]);
    }
    for (std::size_t v = 0; v < all.size(); ++v) {
      for (const auto together : {all[v]->eight_doubles, all[v]->five_and_three_doubles}) {
        together(x, s, c);
        for (std::size_t i = 0; i < 8; ++i) {
          eight[v].add(x[i], decided(s[i], exact_s[i], x[i], true), decided(c[i], exact_c[i], x[i], false));
        }
      }
      for (std::size_t i = 0; i < 8; ++i) {
        double sine, cosine;
        all[v]->one_double(x[i], sine, cosine);
        one[v].add(x[i], decided(sine, exact_s[i], x[i], true), decided(cosine, exact_c[i], x[i], false));
      }
    }
  }
  for (std::size_t v = 0; v < all.size(); ++v) {
    expect_one_ulp(one[v], what + ", " + all[v]->name + ", one");
    expect_one_ulp(eight[v], what + ", " + all[v]->name + ", eight");
  }
}

/// A fifth of 10^6 (10^8) each.
std::size_t share() { return torsor::wanted<std::size_t>(200'000, 20'000'000); }

TEST(Sincos, IsWithinAnUlpForAnglesOfATurn) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> angle(-6.3, 6.3);
  expect_one_ulp("a turn", share(), [&](std::size_t) { return angle(random); });
}

TEST(Sincos, IsWithinAnUlpUpToTheBoundOfTheCore) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> angle(-bound, bound);
  expect_one_ulp("the core's range", share(), [&](std::size_t) { return angle(random); });
}

TEST(Sincos, IsWithinAnUlpForEveryExponent) {
  std::mt19937_64 random(3);
  expect_one_ulp("every exponent", share(), [&](std::size_t) {
    const double x = std::bit_cast<double>(random());
    return std::isfinite(x) ? x : 1.0;
  });
}

TEST(Sincos, IsWithinAnUlpBesideMultiplesOfHalfPi) {
  std::mt19937_64 random(4);
  const Quad half_pi = static_cast<Quad>(0x1.921fb54442d18p+0) + static_cast<Quad>(0x1.1a62633145c07p-54);
  expect_one_ulp("beside multiples of pi/2", share(), [&](std::size_t) {
    // 106 bits times up to 32 bits: the nearest double and its neighbours
    const std::uint64_t n = random() >> (32 + random() % 32);
    double x = static_cast<double>(static_cast<Quad>(n) * half_pi);
    for (std::uint64_t steps = random() % 3; steps > 0; --steps) x = std::nextafter(x, infinity);
    for (std::uint64_t steps = random() % 3; steps > 0; --steps) x = std::nextafter(x, -infinity);
    return random() % 2 == 0 ? x : -x;
  });
}

TEST(Sincos, IsWithinAnUlpBeyondTheBound) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> mantissa(1, 2);
  expect_one_ulp("beyond the bound", share(), [&](std::size_t) {
    const int exponent = 21 + static_cast<int>(random() % 1003);
    const double x = std::ldexp(mantissa(random), exponent);
    return random() % 2 == 0 ? x : -x;
  });
}

TEST(Sincos, IsWithinAnUlpWhereReductionIsHardest) {
  std::vector<double> hardest = hardest_reductions();
  // The double that comes nearest of all to a multiple of pi/2 must be among them.
  const double nearest = std::ldexp(6381956970095103.0, 797);
  EXPECT_NE(std::find(hardest.begin(), hardest.end(), nearest), hardest.end());
  ASSERT_GT(hardest.size(), 1000u);
  for (const double limit : {bound, 0.7853981633974483, 0x1p20 * 1.5707963267948966}) {
    for (const double x : {std::nextafter(limit, 0.0), limit, std::nextafter(limit, infinity)}) hardest.push_back(x);
  }
  hardest.push_back(std::numeric_limits<double>::max());
  hardest.push_back(std::numeric_limits<double>::min());
  hardest.push_back(std::numeric_limits<double>::denorm_min());
  expect_one_ulp("hardest", hardest.size(), [&](std::size_t i) { return hardest[i]; });
}

TEST(Sincos, IsComparedWithATruthThatClnConfirms) {
  std::vector<double> angles = hardest_reductions();
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> angle(-bound, bound);
  for (int i = 0; i < 1000; ++i) angles.push_back(angle(random));
  for (std::size_t i = 0; i < angles.size(); i += 3) {
    Quad sine, cosine;
    quad_sincos(angles[i], sine, cosine);
    const double s = static_cast<double>(sine), c = static_cast<double>(cosine);
    // In ulps of a double, quad numbers have errors of 2^-60.
    EXPECT_NEAR(ulps(s, sine), ulps_by_cln(s, angles[i], true), 1e-15) << angles[i];
    EXPECT_NEAR(ulps(c, cosine), ulps_by_cln(c, angles[i], false), 1e-15) << angles[i];
  }
}

/// |computed - exact| in ulps of a float.
double float_ulps(float computed, double exact) {
  const int exponent = static_cast<int>((std::bit_cast<std::uint64_t>(exact) >> 52) & 0x7ff) - 1023;
  const std::uint64_t unit = static_cast<std::uint64_t>(std::max(exponent, -126) - 23 + 1023) << 52;
  return std::abs(static_cast<double>(computed) - exact) / std::bit_cast<double>(unit);
}

TEST(Sincos, IsWithinAnUlpInFloat) {
  // The double's own error is below 1e-8 ulp of a float.
  const std::uint64_t step = torsor::wanted<std::uint64_t>(1009, 1);
  const std::vector<const Variant*> all = variants();
  std::vector<Worst> one(all.size()), eight(all.size());
  std::uint64_t bits = 0;
  while (bits < 0x100000000u) {
    float x[8], s[8], c[8];
    double sine[8], cosine[8];
    for (int i = 0; i < 8; ++i, bits += step) {
      x[i] = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
      if (!std::isfinite(x[i])) x[i] = 1;
      sine[i] = std::sin(static_cast<double>(x[i]));
      cosine[i] = std::cos(static_cast<double>(x[i]));
    }
    for (std::size_t v = 0; v < all.size(); ++v) {
      for (const auto together : {all[v]->eight_floats, all[v]->five_and_three_floats}) {
        together(x, s, c);
        for (int i = 0; i < 8; ++i) {
          eight[v].add(static_cast<double>(x[i]), float_ulps(s[i], sine[i]), float_ulps(c[i], cosine[i]));
        }
      }
      for (int i = 0; i < 8; ++i) {
        const double at = static_cast<double>(x[i]);
        float alone_s, alone_c;
        all[v]->one_float(x[i], alone_s, alone_c);
        one[v].add(at, float_ulps(alone_s, sine[i]), float_ulps(alone_c, cosine[i]));
      }
    }
  }
  for (std::size_t v = 0; v < all.size(); ++v) {
    expect_one_ulp(one[v], std::string("floats, ") + all[v]->name + ", one");
    expect_one_ulp(eight[v], std::string("floats, ") + all[v]->name + ", eight");
  }
}

// Under another rounding each operation errs by up to an ulp where it errs by half of one to nearest.
TEST(Sincos, IsWithinTwoUlpsWhateverTheRoundingMode) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> turn(-6.3, 6.3), range(-bound, bound);
  const auto angle = [&](std::size_t i) {
    const double far = std::ldexp(turn(random), static_cast<int>(random() % 900));
    return i % 3 == 0 ? turn(random) : i % 3 == 1 ? range(random) : random() % 2 == 0 ? far : 1 / far;
  };
  Worst doubles, floats;
  for (std::size_t first = 0; first < 20'000; first += 8) {
    double x[8], s[8], c[8];
    float xf[8], sf[8], cf[8];
    for (std::size_t i = 0; i < 8; ++i) {
      x[i] = first % 16 == 0 ? turn(random) : angle(i);
      xf[i] = static_cast<float>(std::clamp(x[i], -1e30, 1e30));
    }
    for (const Variant* variant : variants()) {
      for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        double alone_s[8], alone_c[8];
        float alone_sf[8], alone_cf[8];
        std::fesetround(mode);
        variant->eight_doubles(x, s, c);
        variant->eight_floats(xf, sf, cf);
        for (std::size_t i = 0; i < 8; ++i) {
          variant->one_double(x[i], alone_s[i], alone_c[i]);
          variant->one_float(xf[i], alone_sf[i], alone_cf[i]);
        }
        std::fesetround(FE_TONEAREST);
        for (std::size_t i = 0; i < 8; ++i) {
          Quad exact_s, exact_c;
          quad_sincos(x[i], exact_s, exact_c);
          doubles.add(x[i], ulps(s[i], exact_s), ulps(c[i], exact_c));
          doubles.add(x[i], ulps(alone_s[i], exact_s), ulps(alone_c[i], exact_c));
          const double of_float = static_cast<double>(xf[i]), sine = std::sin(of_float), cosine = std::cos(of_float);
          floats.add(of_float, float_ulps(sf[i], sine), float_ulps(cf[i], cosine));
          floats.add(of_float, float_ulps(alone_sf[i], sine), float_ulps(alone_cf[i], cosine));
        }
      }
    }
  }
  for (const Worst* worst : {&doubles, &floats}) {
    EXPECT_LE(worst->sine, 2) << std::hexfloat << worst->at_sine;
    EXPECT_LE(worst->cosine, 2) << std::hexfloat << worst->at_cosine;
  }
}

TEST(Sincos, KeepsTheSignOfZero) {
  for (const Variant* variant : variants()) {
    double x[8] = {0.0, -0.0, 1, -1, -0.0, 0.0, 2, 1e300}, s[8], c[8];
    float xf[8] = {0.0f, -0.0f, 1, -1, -0.0f, 0.0f, 2, 1e30f}, sf[8], cf[8];
    variant->eight_doubles(x, s, c);
    variant->eight_floats(xf, sf, cf);
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(s[i] == 0, x[i] == 0) << variant->name << " at " << x[i];
      EXPECT_EQ(sf[i] == 0, xf[i] == 0) << variant->name << " at " << xf[i];
      if (x[i] != 0) continue;
      EXPECT_EQ(std::signbit(s[i]), std::signbit(x[i])) << variant->name << " at " << x[i];
      EXPECT_EQ(std::signbit(sf[i]), std::signbit(xf[i])) << variant->name << " at " << xf[i];
      EXPECT_EQ(c[i], 1) << variant->name;
      EXPECT_EQ(cf[i], 1) << variant->name;
      double sine, cosine;
      variant->one_double(x[i], sine, cosine);
      EXPECT_EQ(std::signbit(sine), std::signbit(x[i])) << variant->name << " at " << x[i];
      float sine_f, cosine_f;
      variant->one_float(xf[i], sine_f, cosine_f);
      EXPECT_EQ(std::signbit(sine_f), std::signbit(xf[i])) << variant->name << " at " << xf[i];
    }
  }
}

TEST(Sincos, IsNoNumberForWhatIsNotFinite) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Variant* variant : variants()) {
    double x[8] = {nan, infinity, -infinity, 1, 1e300, nan, 3, 0}, s[8], c[8];
    float xf[8], sf[8], cf[8];
    for (int i = 0; i < 8; ++i) xf[i] = static_cast<float>(i == 4 ? 1e30 : x[i]);
    variant->eight_doubles(x, s, c);
    variant->eight_floats(xf, sf, cf);
    for (int i = 0; i < 8; ++i) {
      double sine, cosine;
      variant->one_double(x[i], sine, cosine);
      float sine_f, cosine_f;
      variant->one_float(xf[i], sine_f, cosine_f);
      for (const double result : {s[i], c[i], sine, cosine}) {
        EXPECT_EQ(std::isnan(result), !std::isfinite(x[i])) << variant->name << " at " << x[i];
      }
      for (const float result : {sf[i], cf[i], sine_f, cosine_f}) {
        EXPECT_EQ(std::isnan(result), !std::isfinite(xf[i])) << variant->name << " at " << xf[i];
      }
    }
    // The others are as if alone: a neighbour beyond the bound or without a value changes nothing.
    Quad exact_s, exact_c;
    for (const int i : {3, 4, 6}) {
      quad_sincos(x[i], exact_s, exact_c);
      EXPECT_LE(ulps(s[i], exact_s), 1) << x[i];
      EXPECT_LE(ulps(c[i], exact_c), 1) << x[i];
    }
  }
}

TEST(Sincos, IsTheStandardLibrarysOnRequest) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> angle(-100, 100);
  for (int trial = 0; trial < 100; ++trial) {
    double x[8], s[8], c[8], sine, cosine;
    for (double& each : x) each = angle(random);
    std_variant.eight_doubles(x, s, c);
    std_variant.one_double(x[0], sine, cosine);
    EXPECT_EQ(sine, s[0]);
    EXPECT_EQ(cosine, c[0]);
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(s[i], std::sin(x[i]));
      EXPECT_EQ(c[i], std::cos(x[i]));
    }
  }
}

// Options that let sums be reassociated leave those of sines as they are, or the library's functions are taken. They also take
// the sign of a zero for nothing, and no other rounding into account.
TEST(Sincos, IsRightWhereSumsAreReassociated) {
  double worst = 0;
  for (int k = -4000; k < 4000; ++k) {
    double x[8], s[8], c[8];
    float xf[8], sf[8], cf[8];
    for (int i = 0; i < 8; ++i) xf[i] = static_cast<float>(x[i] = 0.371 * k + i);
    reassociated_variant.eight_doubles(x, s, c);
    reassociated_variant.eight_floats(xf, sf, cf);
    for (int i = 0; i < 8; ++i) {
      const double angle = static_cast<double>(xf[i]);
      worst = std::max({worst, std::abs(s[i] - std::sin(x[i])), std::abs(c[i] - std::cos(x[i])),
                        1e-9 * std::abs(static_cast<double>(sf[i]) - std::sin(angle)),
                        1e-9 * std::abs(static_cast<double>(cf[i]) - std::cos(angle))});
    }
  }
  EXPECT_LE(worst, 3e-16);
}

}  // namespace
