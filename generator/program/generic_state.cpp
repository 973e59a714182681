// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/program/generic_state.hpp"

#include <cstdint>

namespace torsor {
namespace {

/// Finaliser of splitmix64 (Steele, Lea & Flood, Fast splittable pseudorandom number generators, 2014): values that
/// grow with the index would leave q_1 − 2 q_2 + q_3 zero.
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

}  // namespace

Real at_unit_quaternions(const SymbolPointer& symbol, const std::function<Real(const SymbolPointer&)>& numbers) {
  if (symbol->kind == SymbolKind::pi) return Real::pi();
  const auto attitude = symbol->attitude.lock();
  if (!attitude) return numbers(symbol);
  Real square(0), own(0);
  for (const SymbolPointer& e : attitude->e) {
    const Real component = numbers(e);
    if (e == symbol) own = component;
    square += component * component;
  }
  if (square.is_zero()) return Real(symbol == attitude->e[0] ? 1 : 0);
  return own / sqrt(square);
}

Real generic_value(const SymbolPointer& symbol, int trial) {
  return at_unit_quaternions(symbol, [trial](const SymbolPointer& each) {
    const auto key = static_cast<std::uint64_t>(each->index) * 64U + static_cast<std::uint64_t>(trial);
    const auto part = static_cast<long>(scrambled(key) % 4001U);
    return Real(Number::rational(1000 + part, 3001), Real::working_digits());
  });
}

}  // namespace torsor
