// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/stretches.hpp"

#include <algorithm>

#include "torsor/generator/printing/factoring.hpp"

namespace torsor::printing {
namespace {

constexpr std::size_t most_pieces = 12, most_terms = 200;  // each choice collects the whole sum once more

bool is_coordinate(const WrittenTerm& term) {
  return std::any_of(term.factors.begin(), term.factors.end(), [](const WrittenFactor& factor) {
    return factor.base && factor.base->kind == Base::Kind::symbol && factor.base->level == Level::configuration;
  });
}

WrittenTerm as_written(const KeptPiece& piece) {
  WrittenTerm term = as_term(piece.factor);
  Written inside = collected(piece.base);
  std::stable_partition(inside.begin(), inside.end(), is_coordinate);  // x - x_0 + l sin(theta): the coordinates lead
  if (inside[0].coefficient.sign() < 0) {
    for (WrittenTerm& each : inside) each.coefficient = -each.coefficient;
    if (piece.power % 2 != 0) term.coefficient = -term.coefficient;
  }
  term.factors.push_back(parenthesised(std::move(inside)));
  term.factors.back().halves = 2 * piece.power;
  return term;
}

}  // namespace

std::vector<KeptPiece> energy_pieces(const std::vector<Stretch>& stretches, int sign) {
  std::vector<KeptPiece> pieces;
  for (const Stretch& stretch : stretches) {
    pieces.push_back({Number(-sign) * (Number::rational(1, 2) * stretch.stiffness), stretch.length, 2});
  }
  return pieces;
}

std::vector<KeptPiece> force_pieces(const std::vector<Stretch>& stretches, std::size_t i) {
  std::vector<KeptPiece> pieces;
  for (const Stretch& stretch : stretches) {
    if (!stretch.along[i].is_zero()) pieces.push_back({Number(-1) * (stretch.stiffness * stretch.along[i]), stretch.length, 1});
  }
  return pieces;
}

std::size_t symbols_to_read(const Written& written) {
  std::size_t count = 0;
  for (const WrittenTerm& term : written) {
    count += term.factors.empty() ? 1 : 0;
    for (const WrittenFactor& factor : term.factors) {
      const bool call = factor.base && factor.base->kind == Base::Kind::function;
      count += factor.base ? 1 : 0;
      if (!factor.base || call) count += symbols_to_read(factor.inside);
      for (const Written& other : factor.others) count += symbols_to_read(other);
    }
  }
  return count;
}

Written collected_around(const Sum& sum, const std::vector<KeptPiece>& pieces, InlineView& view, Layout layout) {
  Written best = collected(sum, layout);
  if (pieces.size() > most_pieces || sum.size() > most_terms) return best;
  std::size_t least = symbols_to_read(best);
  Sum rest = sum;
  for (const KeptPiece& piece : pieces) {
    if (piece.base.size() < 2 || piece.factor.is_zero()) continue;
    const GiNaC::ex value = view.expression(piece.factor) * GiNaC::power(view.expression(piece.base), piece.power);
    const Sum without = view.sum(view.expression(rest) - value);
    layout.whole.push_back(as_written(piece));
    Written written = collected(without, layout);
    const std::size_t symbols = symbols_to_read(written);
    if (symbols < least) {
      best = std::move(written);
      least = symbols;
      rest = without;
    } else {
      layout.whole.pop_back();
    }
  }
  return best;
}

}  // namespace torsor::printing
