// SPDX-License-Identifier: GPL-3.0-or-later
// On a Cortex-M4F: sines and cosines in float, of C++ and of C, over all exponents, against those in double (which
// sincos.* compares with the truth). And how many instructions an angle takes, by the clock that counts them in QEMU.
#include <cstdint>

#include "examples/cortex_m/board.hpp"
#include "generated/torsor_support.hpp"

#if !defined(WITHOUT_C)
extern "C" void sine_in_c(float angle, float* sine, float* cosine);
#endif

namespace {

__attribute__((noinline)) void sine_in_cpp(float angle, float* sine, float* cosine) {
  torsor::scalar_traits<float>::sincos(angle, *sine, *cosine);
}

/// In ulps of a float. A double's own error, 1 ulp of a double, is 2^-29 of them.
float error(float computed, double exact) {
  std::uint64_t bits;
  __builtin_memcpy(&bits, &exact, sizeof bits);
  const int exponent = static_cast<int>((bits >> 52) & 0x7ff) - 1023;
  const std::uint64_t unit_bits = static_cast<std::uint64_t>((exponent < -126 ? -126 : exponent) - 23 + 1023) << 52;
  double unit;
  __builtin_memcpy(&unit, &unit_bits, sizeof unit);
  const double difference = (static_cast<double>(computed) - exact) / unit;
  return static_cast<float>(difference < 0 ? -difference : difference);
}

using Sine = void (*)(float, float*, float*);

float worst(Sine sine_of) {
  float greatest = 0;
  std::uint32_t random = 1;
  for (std::uint32_t exponent = 0; exponent < 255; ++exponent) {
    for (int trial = 0; trial < 64; ++trial) {
      random = random * 1664525U + 1013904223U;
      const std::uint32_t bits = (random & 0x80000000U) | (exponent << 23) | ((random >> 7) & 0x7fffffU);
      float x, s, c;
      __builtin_memcpy(&x, &bits, sizeof x);
      sine_of(x, &s, &c);
      double sine, cosine;
      torsor::scalar_traits<double>::sincos(static_cast<double>(x), sine, cosine);
      const float of_sine = error(s, sine), of_cosine = error(c, cosine);
      if (!(of_sine <= greatest)) greatest = of_sine;
      if (!(of_cosine <= greatest)) greatest = of_cosine;
    }
  }
  return greatest;
}

/// Of one call, the most over exponents: 40 instructions are a tick of the clock.
float instructions(Sine sine_of, int first_exponent, int end_exponent) {
  constexpr int repetitions = 400;
  float most = 0;
  for (int exponent = first_exponent; exponent < end_exponent; ++exponent) {
    const std::uint32_t bits = static_cast<std::uint32_t>(exponent) << 23 | 0x2aaaaaU;
    float x, s, c;
    __builtin_memcpy(&x, &bits, sizeof x);
    const std::uint32_t begin = Clock::now();
    for (int k = 0; k < repetitions; ++k) sine_of(k % 2 == 0 ? x : -x, &s, &c);
    const float of_one = static_cast<float>((begin - Clock::now()) & 0xffffffU) * 40.0f / repetitions;
    if (of_one > most) most = of_one;
  }
  return most;
}

bool report(const char* what, float number, const char* unit, float bound) {
  say(what);
  say_number(number, 3);
  say(unit);
  return number <= bound;
}

}  // namespace

int main() {
  Clock::start(0x1000000, false);
  bool good = report("C++: at most ", worst(sine_in_cpp), " ulp\n", 1.0f);
  // Exponents of 0.5 to 1,024, and of those beyond. The bound is that of docs/microcontrollers.md.
  good = report("C++, up to 1,600 rad: ", instructions(sine_in_cpp, 126, 137), " instructions\n", 120.0f) && good;
  good = report("C++, beyond: ", instructions(sine_in_cpp, 138, 255), " instructions\n", 350.0f) && good;
#if !defined(WITHOUT_C)
  good = report("C: at most ", worst(sine_in_c), " ulp\n", 1.0f) && good;
  good = report("C, beyond: ", instructions(sine_in_c, 138, 255), " instructions\n", 350.0f) && good;
#endif
  return good ? 0 : 1;
}
