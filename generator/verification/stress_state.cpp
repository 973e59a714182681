// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/stress_state.hpp"

#include <cmath>

#include <fmt/format.h>

#include "torsor/generator/verification/random_state.hpp"

namespace torsor {
namespace {

// The library's distributions differ from one implementation to another: integers only.
std::uint64_t below(std::mt19937_64& random, std::uint64_t count) { return (random() >> 11U) % count; }
double power_of_two(std::mt19937_64& random, int from, int to) {
  return std::ldexp(1.0, from + static_cast<int>(below(random, static_cast<std::uint64_t>(to - from + 1))));
}
double sign(std::mt19937_64& random) { return below(random, 2) == 0 ? 1.0 : -1.0; }

constexpr double quarter_turn = 1.57079632679489662;

bool is_angle(const Symbol& symbol) {
  return symbol.kind == SymbolKind::coordinate && symbol.unit == Unit() && symbol.attitude.expired();
}

enum class Kind { ordinary, near_quarter_turns, large_angles, rates, all_sizes, zeros, coincident, mixture };
constexpr std::uint64_t kind_count = 8;

}  // namespace

StressState::StressState(const Scene& scene, const std::vector<SymbolPointer>& symbols, std::uint64_t seed,
                         StateFormat format)
    : format_(format), symbols_(symbols) {
  const RandomState ordinary(scene, seed);
  std::mt19937_64 random(seed * 0x9E3779B97F4A7C15U + 1);
  const Kind of_state = static_cast<Kind>(seed % kind_count);
  const double of_rates = power_of_two(random, -format.large, format.large);
  for (std::size_t i = 0; i < symbols_.size(); ++i) {
    const Symbol& symbol = *symbols_[i];
    // All bits are used: numbers of few bits have exact products.
    double value = ordinary.value(symbols_[i]) * (1 + static_cast<double>(random() >> 11U) * 0x1p-71);
    const Kind kind = of_state == Kind::mixture ? static_cast<Kind>(below(random, kind_count - 1)) : of_state;
    const double scale = power_of_two(random, -format.large, format.large);
    const double large = power_of_two(random, 0, format.large);
    const double near = sign(random) * power_of_two(random, -format.large, -3);
    const auto turns = static_cast<double>(below(random, 5)) - 2;
    const bool chosen = below(random, 2) == 0;
    const double other = peer(i, random);
    if (symbol.kind != SymbolKind::parameter) {
      const bool rate = symbol.kind == SymbolKind::velocity || symbol.kind == SymbolKind::acceleration;
      if (kind == Kind::near_quarter_turns && is_angle(symbol)) value = turns * quarter_turn + near * value;
      if (kind == Kind::large_angles && (is_angle(symbol) || symbol.kind == SymbolKind::time)) value *= large;
      if (kind == Kind::rates && rate) value *= of_rates;
      if (kind == Kind::all_sizes && symbol.kind != SymbolKind::time) value *= scale;
      if (kind == Kind::zeros && chosen) value = 0;
      if (kind == Kind::coincident) value = other + (chosen ? 0 : near * value);
    }
    values_[symbols_[i].get()] = rounded(value);
  }
  normalise();
}

double StressState::rounded(double value) const {
  if (format_.mantissa_bits >= 53) return value;
  return static_cast<double>(static_cast<float>(value));
}

/// Of an earlier symbol of the same kind and unit; 1 if there is none.
double StressState::peer(std::size_t symbol, std::mt19937_64& random) const {
  std::vector<double> peers;
  for (std::size_t i = 0; i < symbols_.size(); ++i) {
    const auto known = values_.find(symbols_[i].get());
    if (i == symbol || known == values_.end()) continue;
    if (symbols_[i]->kind == symbols_[symbol]->kind && symbols_[i]->unit == symbols_[symbol]->unit) {
      peers.push_back(known->second);
    }
  }
  const std::uint64_t draw = random();
  return peers.empty() ? 1.0 : peers[(draw >> 11U) % peers.size()];
}

void StressState::normalise() {
  for (const SymbolPointer& symbol : symbols_) {
    const auto attitude = symbol->attitude.lock();
    if (!attitude || attitude->e[0] != symbol) continue;
    double square = 0;
    for (const SymbolPointer& e : attitude->e) square += values_.at(e.get()) * values_.at(e.get());
    if (square == 0) values_[attitude->e[0].get()] = square = 1;
    for (const SymbolPointer& e : attitude->e) values_[e.get()] = rounded(values_.at(e.get()) / std::sqrt(square));
  }
}

StressState StressState::with_step(std::size_t symbol, std::mt19937_64& random) const {
  StressState result = *this;
  const Symbol& changed = *symbols_[symbol];
  double& value = result.values_[symbols_[symbol].get()];
  const double relative = sign(random) * power_of_two(random, -20, -1);
  const double largest = std::ldexp(1.0, format_.large + 2);
  const std::uint64_t choice = changed.kind == SymbolKind::parameter ? 0 : below(random, 8);
  if (changed.kind == SymbolKind::parameter) {
    value *= 1 + relative / 4;
  } else if (choice <= 2) {
    value *= 1 + relative;
  } else if (choice == 3) {
    value *= power_of_two(random, -format_.large / 2, format_.large / 2);
  } else if (choice == 4 && is_angle(changed)) {
    const double beside = sign(random) * power_of_two(random, -format_.large, 0);
    value = std::nearbyint(value / quarter_turn) * quarter_turn + beside;
  } else if (choice == 5) {
    value = peer(symbol, random) + sign(random) * power_of_two(random, -format_.large, 0);
  } else if (choice == 6) {
    value = -value;
  } else {
    value = below(random, 4) == 0 ? 0 : value + sign(random) * power_of_two(random, -4, 2);
  }
  if (std::abs(value) > largest) value = largest;
  if (changed.kind == SymbolKind::time) value = std::abs(value);
  value = rounded(value);
  result.normalise();
  return result;
}

StressState StressState::with(const std::string& name, double value) const {
  StressState result = *this;
  for (const SymbolPointer& symbol : symbols_) {
    if (symbol->name == name) result.values_[symbol.get()] = rounded(value);
  }
  result.normalise();
  return result;
}

StressState StressState::jittered(std::mt19937_64& random) const {
  StressState result = *this;
  for (const SymbolPointer& symbol : symbols_) {
    double& value = result.values_[symbol.get()];
    const double relative = static_cast<double>(below(random, 64)) - 32;
    value = rounded(value * (1 + std::ldexp(relative, -format_.mantissa_bits)));
  }
  result.normalise();
  return result;
}

std::string StressState::to_string(const std::vector<SymbolPointer>& symbols) const {
  std::string text;
  for (const SymbolPointer& symbol : symbols) {
    text += fmt::format("{}{}={:.17g}", text.empty() ? "" : ", ", symbol->name, values_.at(symbol.get()));
  }
  return text;
}

}  // namespace torsor
