// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene.hpp"

namespace torsor {

/// The formats in which a state can be given exactly, and how far it may go there.
struct StateFormat {
  int mantissa_bits = 53;
  int large = 26;  ///< numbers grow and shrink up to 2^±large, at least 4: squares of rates stay far from overflow
};
inline constexpr StateFormat double_states{53, 26};
inline constexpr StateFormat float_states{24, 10};

/// A state and parameters at which kernels are tried, exact in its format. Drawn from a seed: in turn an ordinary one
/// (that of RandomState, with all bits), angles next to multiples of π/2, large angles, rates that are all large or all
/// small, numbers of all sizes, many zeros, coordinates that coincide, and any mixture of these. The same for every
/// compiler. Parameters stay near their values; quaternions have the norm 1 but for rounding.
class StressState {
 public:
  /// Of these symbols: time, run-time parameters, coordinates, rates, accelerations, inputs, multipliers.
  StressState(const Scene& scene, const std::vector<SymbolPointer>& symbols, std::uint64_t seed, StateFormat format);

  double value(const SymbolPointer& symbol) const { return values_.at(symbol.get()); }
  const std::vector<SymbolPointer>& symbols() const { return symbols_; }

  /// The same state but for one symbol, which takes a step: a little, by a power of two, to a multiple of π/2, to what
  /// another one of its kind has, to zero, to the other sign.
  StressState with_step(std::size_t symbol, std::mt19937_64& random) const;
  /// The same state but for the symbol of this name, exact in the format.
  StressState with(const std::string& name, double value) const;
  /// The same state but for the last bits of all numbers.
  StressState jittered(std::mt19937_64& random) const;

  /// NAME=VALUE of some symbols, with the digits that give the same bits again.
  std::string to_string(const std::vector<SymbolPointer>& symbols) const;

 private:
  double rounded(double value) const;
  void normalise();
  double peer(std::size_t symbol, std::mt19937_64& random) const;

  StateFormat format_;
  std::vector<SymbolPointer> symbols_;
  std::map<const Symbol*, double> values_;  // looked up only
};

}  // namespace torsor
