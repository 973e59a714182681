// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "torsor/generator/printing/inline_view.hpp"
#include "torsor/generator/printing/written.hpp"

namespace torsor::printing {

/// A spring on e: U = -1/2 k e^2 and Q_i = -k e de/dq_i, written out.
struct Stretch {
  Sum stiffness, length;
  std::vector<Sum> along;  ///< de/dq_i of every coordinate
};

/// factor · base^power, a part of a sum.
struct KeptPiece {
  Sum factor, base;
  int power = 1;
};

/// sign · U of each spring.
std::vector<KeptPiece> energy_pieces(const std::vector<Stretch>& stretches, int sign);
/// Q_i of each spring.
std::vector<KeptPiece> force_pieces(const std::vector<Stretch>& stretches, std::size_t i);

/// The sum, collected. Multiplied out, the squares of several springs run into each other: those pieces stay whole with
/// which fewer symbols are written.
Written collected_around(const Sum& sum, const std::vector<KeptPiece>& pieces, InlineView& view, Layout layout = {});

/// How often a reader meets a symbol.
std::size_t symbols_to_read(const Written& written);

}  // namespace torsor::printing
