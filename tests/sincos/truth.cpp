// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sincos/truth.hpp"

#include <algorithm>
#include <cmath>

#include "torsor/generator/base/high_precision.hpp"

extern "C" void sincosf128(Quad, Quad*, Quad*) noexcept;  // declared by <math.h> for some compilers only

void quad_sincos(double angle, Quad& sine, Quad& cosine) { sincosf128(angle, &sine, &cosine); }

double ulps(double computed, Quad exact, int bits, int least_exponent) {
  const Quad size = exact < 0 ? -exact : exact;
  int exponent = size > 0 ? std::ilogb(static_cast<double>(size)) : least_exponent;
  if (size < static_cast<Quad>(std::ldexp(1.0, exponent))) --exponent;  // rounded up to a power of two
  const double unit = std::ldexp(1.0, std::max(exponent, least_exponent) - bits + 1);
  const Quad error = static_cast<Quad>(computed) - exact;
  return static_cast<double>((error < 0 ? -error : error) / static_cast<Quad>(unit));
}

double ulps_by_cln(double computed, double angle, bool is_sine) {
  using torsor::Real;
  const torsor::WorkingDigits digits(std::abs(angle) < 1e10 ? 60 : 380);
  const Real exact = is_sine ? sin(Real::from_double(angle)) : cos(Real::from_double(angle));
  const Real size = abs(exact);
  int exponent = std::ilogb(size.to_double());
  if (size < Real::from_double(std::ldexp(1.0, exponent))) --exponent;
  const double unit = std::ldexp(1.0, std::max(exponent, -1022) - 52);
  return (abs(Real::from_double(computed) - exact) / Real::from_double(unit)).to_double();
}

std::vector<double> hardest_reductions() {
  using torsor::Real;
  const torsor::WorkingDigits digits(380);
  std::vector<double> found;
  const Real one(1), limit = Real::from_double(0x1p53), half = Real::from_double(0x1p52);
  const auto floor_of = [](const Real& x) { return Real(cln::ffloor(x.raw())); };
  for (int exponent = -52; exponent <= 971; ++exponent) {
    Real rest = Real(2) * Real::from_double(std::ldexp(1.0, exponent)) / Real::pi();
    rest -= floor_of(rest);
    Real before(0), denominator(1);  // of the convergents
    while (!rest.is_zero()) {
      const Real inverse = one / rest;
      const Real quotient = floor_of(inverse);
      rest = inverse - quotient;
      const Real next = quotient * denominator + before;
      before = denominator;
      denominator = next;
      if (!(denominator < limit)) break;
      // The multiple that has 53 bits, of convergents good enough to be among the hardest
      if (denominator < Real::from_double(0x1p44)) continue;
      const Real multiple = floor_of(half / denominator) + one;
      const Real integer = denominator < half ? multiple * denominator : denominator;
      if (integer < limit) found.push_back(std::ldexp(integer.to_double(), exponent));
    }
  }
  return found;
}
