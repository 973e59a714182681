// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

#include <cln/integer_io.h>
#include <cln/rational_io.h>

#include "torsor/generator/base/decimal.hpp"
#include "tests/base/error_of.hpp"

namespace torsor::number_test {
namespace {

const Number s2 = Number::sqrt2();
const Number s3 = Number::sqrt3();
const Number s6 = s2 * s3;

class RandomNumbers {
 public:
  Number rational() { return Number::rational(numerator_(engine_), denominator_(engine_)); }
  Number element() {
    const Number a = rational(), b = rational(), c = rational(), d = rational();
    return a + b * s2 + c * s3 + d * s6;
  }

 private:
  std::mt19937_64 engine_{20240607};
  std::uniform_int_distribution<long> numerator_{-50, 50};
  std::uniform_int_distribution<long> denominator_{1, 12};
};

using testing_errors::error_of;

TEST(Number, IsNotMadeFromFloatingPoint) {
  static_assert(std::is_convertible_v<int, Number> && std::is_convertible_v<long, Number>);
  static_assert(!std::is_constructible_v<Number, double> && !std::is_constructible_v<Number, float>);
  EXPECT_TRUE(Number().is_zero());
}

TEST(Number, KeepsTheRulesOfAField) {
  RandomNumbers random;
  for (int round = 0; round < 500; ++round) {
    const Number x = random.element(), y = random.element(), z = random.element();
    EXPECT_EQ((x + y) * z, x * z + y * z);
    EXPECT_EQ((x * y) * z, x * (y * z));
    EXPECT_EQ(x * y, y * x);
    EXPECT_EQ(x - y, -(y - x));
    if (!y.is_zero()) {
      EXPECT_EQ(x / y * y, x);
      EXPECT_EQ(y.pow(-3) * y * y * y, 1);
    }
  }
}

TEST(Number, MultipliesTheSurdsOfItsBasis) {
  EXPECT_EQ(s2 * s2, 2);
  EXPECT_EQ(s3 * s3, 3);
  EXPECT_EQ(s2 * s3, Number::from_parts(0, 0, 0, 1));
  EXPECT_EQ(s2 * s6, 2 * s3);
  EXPECT_EQ(s3 * s6, 3 * s2);
  EXPECT_EQ(s6 * s6, 6);
  EXPECT_EQ((1 + s2) / (1 + s2), 1);
  EXPECT_EQ(1 / (s2 + s3), s3 - s2);
}

TEST(Number, AllowsAnOperandToBeTheResult) {
  Number x = 1 + s2 + s6;
  const Number& itself = x;
  const Number square = x * Number(x);
  x *= itself;
  EXPECT_EQ(x, square);
  x /= itself;
  EXPECT_TRUE(x.is_one());
  x *= 3;
  x /= itself;
  EXPECT_TRUE(x.is_one());
  x -= itself;
  EXPECT_TRUE(x.is_zero());
}

TEST(Number, KnowsWhatItIs) {
  EXPECT_TRUE(Number(7).is_integer());
  EXPECT_TRUE((s2 * s2).is_integer());
  EXPECT_FALSE(Number::rational(1, 2).is_integer());
  EXPECT_TRUE(Number::rational(1, 2).is_rational());
  EXPECT_FALSE(s2.is_rational());
  EXPECT_FALSE(s2.is_integer());
  EXPECT_FALSE((1 + s2).is_one());
  EXPECT_FALSE((s3 - 1).is_zero());
  EXPECT_EQ(Number::rational(-6, -4), Number::rational(3, 2));
}

TEST(Number, FindsTheSignOfNearlyVanishingDifferences) {
  // p² − 2q² = ±1 for the convergents p/q of √2: p − q√2 = ±1/(p + q√2), of alternating sign and ever smaller.
  Number p = 1, q = 1;
  for (int index = 0; index < 300; ++index) {
    const Number difference = p - q * s2;
    EXPECT_EQ(difference.sign(), index % 2 == 0 ? -1 : 1);
    EXPECT_EQ(difference.abs().sign(), 1);
    const Number next = p + 2 * q;
    q = p + q;
    p = next;
  }
  EXPECT_EQ((s2 * s3 - s6).sign(), 0);
  EXPECT_EQ((s2 + s3 - Number::rational(31462643699419, 10000000000000)).sign(), 1);
  EXPECT_EQ((s2 + s3 - Number::rational(31462643699420, 10000000000000)).sign(), -1);
}

TEST(Number, IsOrderedByValue) {
  std::vector<Number> numbers{s6, -s2, 0, s3, Number::rational(7, 5), s2, 1, -1};
  std::sort(numbers.begin(), numbers.end(), [](const Number& a, const Number& b) { return compare(a, b) < 0; });
  EXPECT_EQ(numbers, (std::vector<Number>{-s2, -1, 0, 1, Number::rational(7, 5), s2, s3, s6}));
  RandomNumbers random;
  for (int round = 0; round < 500; ++round) {
    const Number x = random.element(), y = random.element();
    EXPECT_EQ(compare(x, y) < 0, compare(y, x) > 0);
    EXPECT_EQ(compare(x, y) == 0, x == y);
    EXPECT_TRUE(x < x + Number::rational(1, 1000000));
  }
}

TEST(Number, HashesTheSameOnEveryRun) {
  // Two values from a separate program of the mixing function: they must not move between runs, compilers or machines.
  EXPECT_EQ(Number(0).hash(), Number::rational(0, 5).hash());
  EXPECT_EQ((s2 * s2).hash(), Number(2).hash());
  EXPECT_NE(Number(2).hash(), Number(-2).hash());
  EXPECT_NE(Number::rational(1, 2).hash(), Number(2).hash());
  EXPECT_NE(s2.hash(), s3.hash());
  static_assert(sizeof(std::size_t) == 8);
  EXPECT_EQ(Number::rational(-3, 4).hash(), 1823158844281902738u);
  EXPECT_EQ((Number(1) / 3 + s2 * Number(10).pow(40)).hash(), 213100777020647994u);
}

TEST(Number, HasARootOnlyWhereItLiesInTheField) {
  const auto root = [](long numerator, long denominator) {
    return Number::rational(numerator, denominator).square_root();
  };
  EXPECT_EQ(root(0, 1), Number(0));
  EXPECT_EQ(root(4, 9), Number::rational(2, 3));
  EXPECT_EQ(root(2, 1), s2);
  EXPECT_EQ(root(1, 2), s2 / 2);
  EXPECT_EQ(root(3, 4), s3 / 2);
  EXPECT_EQ(root(6, 1), s6);
  EXPECT_EQ(root(27, 50), 3 * s6 / 10);
  EXPECT_EQ(root(5, 1), std::nullopt);
  EXPECT_EQ(root(-4, 1), std::nullopt);
  EXPECT_EQ((2 + s3).square_root(), (s6 + s2) / 2);
  EXPECT_EQ((3 - 2 * s2).square_root(), s2 - 1);
  EXPECT_EQ((1 + s2).square_root(), std::nullopt);
  EXPECT_EQ((1 - s2).square_root(), std::nullopt);
  RandomNumbers random;
  for (int round = 0; round < 300; ++round) {
    const Number x = random.element();
    EXPECT_EQ((x * x).square_root(), x.abs()) << x.to_string();
    const auto maybe = x.square_root();
    if (maybe) {
      EXPECT_EQ(*maybe * *maybe, x);
    }
  }
}

TEST(Number, IsPrintedForPeople) {
  EXPECT_EQ(Number().to_string(), "0");
  EXPECT_EQ(Number::rational(-3, 4).to_string(), "-3/4");
  EXPECT_EQ((s2 / 2).to_string(), "1/2*sqrt(2)");
  EXPECT_EQ((-s3).to_string(), "-sqrt(3)");
  EXPECT_EQ((1 - s6 / 2).to_string(), "1 - 1/2*sqrt(6)");
  EXPECT_EQ((s2 + 5 * s3).to_string(), "sqrt(2) + 5*sqrt(3)");
}

TEST(Number, ComesBackFromItsExactText) {
  EXPECT_EQ(Number(2).to_exact(), "2/1");
  EXPECT_EQ(Number::rational(-3, 4).to_exact(), "-3/4");
  EXPECT_EQ((Number::rational(1, 2) - s6).to_exact(), "1/2;0;0;-1");
  EXPECT_EQ(Number::from_exact("7"), 7);
  EXPECT_EQ(Number::from_exact("0;1/2;0;-3"), s2 / 2 - 3 * s6);
  RandomNumbers random;
  for (int round = 0; round < 300; ++round) {
    const Number x = random.element() * Number(10).pow(30);
    EXPECT_EQ(Number::from_exact(x.to_exact()), x);
    EXPECT_EQ(Number::from_exact(Number(x.part(0)).to_exact()), Number(x.part(0)));
  }
}

TEST(Number, RefusesATextThatIsNotExact) {
  for (const char* text : {"", "1/0", "1.5", "1;2;3", "1;2;3;4;5", "1;2;3;", "/2", "3/", "+1", "--1", "1/2/3", "x"}) {
    EXPECT_EQ(error_of([text] { Number::from_exact(text); }),
              "cannot read \"" + std::string(text) + "\" as an exact number: write num/den or a;b;c;d");
  }
}

// ((2^99)^99)^99 took minutes and gigabytes.
TEST(Number, RefusesPowersBeyondAllUse) {
  EXPECT_EQ(Number(10).pow(10000).pow(2), Number(10).pow(20000));
  EXPECT_EQ(Number(1).pow(2000000000), Number(1));
  EXPECT_EQ(Number(-1).pow(2000000001), Number(-1));
  EXPECT_EQ(Number(0).pow(2000000000), Number(0));
  const Number large = Number(2).pow(99).pow(99);
  EXPECT_THROW(static_cast<void>(large.pow(99)), Error);
  EXPECT_THROW(static_cast<void>(large.pow(-99)), Error);
  EXPECT_THROW(static_cast<void>((Number(1) / large).pow(99)), Error);
  EXPECT_THROW(static_cast<void>(Number(2).pow(2000000000)), Error);
}

TEST(Number, RefusesToDivideByZero) {
  EXPECT_EQ(error_of([] { Number::rational(3, 0); }),
            "the fraction 3/0 has no value: give a denominator other than zero");
  EXPECT_EQ(error_of([] { static_cast<void>(s2 / (s6 - s2 * s3)); }),
            "division of sqrt(2) by zero: the divisor must not vanish");
  EXPECT_EQ(error_of([] { Number().pow(-2); }), "zero to the power -2 has no value: the base must not vanish");
  EXPECT_EQ(Number().pow(0), 1);
}

TEST(Number, HasExactSinesOfTwelfthsOfPi) {
  for (long k = -30; k <= 30; ++k) {
    const auto here = sin_cos_of_pi_twelfths(k);
    ASSERT_TRUE(here);
    // Rounded once each, and the library's sine within 1 ulp of 1 plus the error of the rounded angle (8 · 1.1e-16).
    EXPECT_NEAR(here->first.to_double(), std::sin(static_cast<double>(k) * 3.14159265358979323846 / 12), 2e-15);
    EXPECT_NEAR(here->second.to_double(), std::cos(static_cast<double>(k) * 3.14159265358979323846 / 12), 2e-15);
    const auto& [s, c] = *here;
    EXPECT_EQ(s * s + c * c, 1);
    const auto step = sin_cos_of_pi_twelfths(k + 1), by = sin_cos_of_pi_twelfths(1);
    EXPECT_EQ(step->first, s * by->second + c * by->first);
    EXPECT_EQ(step->second, c * by->second - s * by->first);
  }
  EXPECT_EQ(sin_cos_of_pi_twelfths(Number::rational(1, 2)), std::nullopt);
  EXPECT_EQ(sin_cos_of_pi_twelfths(s2), std::nullopt);
}

TEST(Decimal, IsReadExactly) {
  EXPECT_EQ(parse_decimal("12"), 12);
  EXPECT_EQ(parse_decimal("-1.5e-3"), Number::rational(-3, 2000));
  EXPECT_EQ(parse_decimal("3/4"), Number::rational(3, 4));
  EXPECT_EQ(parse_decimal("-6/8"), Number::rational(-3, 4));
  EXPECT_EQ(parse_decimal("+.5"), Number::rational(1, 2));
  EXPECT_EQ(parse_decimal("2."), 2);
  EXPECT_EQ(parse_decimal("007.50E+2"), 750);
  EXPECT_EQ(parse_decimal("1e30"), Number(10).pow(30));
  EXPECT_EQ(parse_decimal("0.1"), Number::rational(1, 10));
}

TEST(Decimal, NamesTheTextItCannotRead) {
  for (const char* text : {"", "-", ".", "1 ", " 1", "1e", "1e+", "1.2.3", "0x10", "1/2.5", "1/-2", "nan", "1e20000",
                           "1/0", "1/", "1e99999999999999999999", "1,5"}) {
    EXPECT_NE(error_of([text] { parse_decimal(text); }).find("cannot read \"" + std::string(text) + "\" as a number: "),
              std::string::npos)
        << text;
  }
  EXPECT_EQ(error_of([] { parse_decimal("1/0"); }), "cannot read \"1/0\" as a number: the denominator is zero");
}

TEST(Decimal, ReadsADoubleAsItsShortestDecimal) {
  EXPECT_EQ(from_double(0.1), Number::rational(1, 10));
  EXPECT_EQ(from_double(9.81), Number::rational(981, 100));
  EXPECT_EQ(from_double(-0.0), 0);
  EXPECT_EQ(from_double(1e22), Number(10).pow(22));
  EXPECT_EQ(from_double(5e-324), 5 * Number(10).pow(-324));
  EXPECT_EQ(error_of([] { from_double(1.0 / 0.0); }), "the value inf is not a finite number: give a finite one");
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(0.1f), "0.1");
  EXPECT_EQ(shortest(2.0), "2");
}

}  // namespace
}  // namespace torsor::number_test
