// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <ginac/ginac.h>

#include "torsor/generator/printing/canonical_sum.hpp"
#include "torsor/generator/printing/disc_products.hpp"
#include "torsor/generator/printing/driven_coordinates.hpp"
#include "torsor/generator/printing/roots.hpp"
#include "torsor/generator/program/program.hpp"

namespace torsor::printing {

/// When a quantity is written out and when it is given by named definitions instead.
struct InlineLimits {
  int terms = 400;        ///< of a sum that a person may be asked to read
  int expansion = 20000;  ///< terms before anything cancels, estimated, that are multiplied out at all
};

/// Values of a program written out: definitions are substituted back into one GiNaC expression, symbols one to one.
/// One view serves one program; it keeps what it has converted.
class InlineView {
 public:
  /// `positive`: the symbols whose squares leave square roots.
  InlineView(const Program& program, const InlineLimits& limits, PositiveSymbols positive = {})
      : program_(&program), limits_(limits), positive_(std::move(positive)) {}
  /// For pages that list the coordinates: a driven one and its rates stand by their names inside sines and cosines, and
  /// where that makes a sum shorter, unless their law is a single term like Ω t.
  InlineView(Program& program, const InlineLimits& limits, const SceneContent& scene);
  /// The law of a driven coordinate, its rate or its acceleration, to be listed; nothing when it is past a limit, or when a
  /// rate has no name in formulas.
  std::optional<Sum> law(const SymbolPointer& name) const { return driven_.law(name); }

  const InlineLimits& limits() const { return limits_; }

  /// Upper bound of the number of terms after multiplying out, before anything cancels; infinite when it overflows.
  double term_bound(const Value& value);

  /// From now on √(1 − k²) of one of these is written with the name of k, unless k is but one term.
  void name_products(std::vector<NamedProduct> products) { products_ = std::move(products); }
  /// Those that have been named so, to be told.
  std::vector<NamedProduct> products_in_use() const;

  /// The value as one GiNaC expression, not multiplied out; nothing when its term bound is past limits().expansion.
  /// What is past it is tried again, with every definition put in its short form before it is multiplied out.
  std::optional<GiNaC::ex> expression(const Value& value);
  /// The same with the names of products in it: to be read, not to be differentiated.
  std::optional<GiNaC::ex> expression_to_read(const Value& value);

  /// Multiplied out by GiNaC, put in canonical order and simplified; nothing when it is past a limit.
  std::optional<Sum> sum(const Value& value);
  /// The same for any expression made of this view's symbols. Not bounded.
  Sum sum(const GiNaC::ex& expression);
  std::optional<Sum> bounded_sum(const GiNaC::ex& expression);

  GiNaC::ex expression(const Sum& sum);
  GiNaC::ex symbol(const SymbolPointer& symbol);

 private:
  double term_bound(const Polynomial& polynomial);
  double term_bound(ValueNumber value_number);
  GiNaC::ex of_polynomial(const Polynomial& polynomial);
  GiNaC::ex of_value_number(ValueNumber value_number);
  GiNaC::ex of_call(const Base& call);
  /// A definition in its short form, and the terms that it then has. Nothing where a step to it is past a limit.
  struct Reduced {
    GiNaC::ex expression;
    double terms = 0;
  };
  const std::optional<Reduced>& reduced(ValueNumber value_number);
  std::optional<Reduced> reduced(const Polynomial& polynomial);
  /// The product k whose 1 − k² a definition is on every state; none for any other definition.
  std::optional<std::size_t> product_under_root(ValueNumber radicand) const;
  GiNaC::ex named_product(std::size_t k);
  Sum canonical(const GiNaC::ex& expression);
  Sum canonical_power(const GiNaC::ex& expression);
  Sum canonical_call(const GiNaC::ex& expression);
  /// Put in order and made short: unit quaternions, squares beside roots, sines and cosines.
  Sum shortened(const GiNaC::ex& expression);

  const Program* program_;
  InlineLimits limits_;
  PositiveSymbols positive_;
  DrivenCoordinates driven_;
  std::vector<NamedProduct> products_;
  std::vector<std::size_t> in_use_;
  GiNaC::exmap named_values_;  ///< of named products and driven coordinates; applied, never iterated
  std::vector<std::optional<double>> bounds_;
  std::vector<std::optional<GiNaC::ex>> value_numbers_;
  std::vector<std::optional<std::optional<Reduced>>> reduced_;
  std::map<GiNaC::ex, Sum, GiNaC::ex_is_less> written_;  ///< powers and calls in canonical order; looked up, never iterated
  std::vector<SymbolPointer> symbols_;  ///< by the number that is the name of the GiNaC symbol
  std::vector<GiNaC::ex> ginac_symbols_;
  std::unordered_map<const Symbol*, std::size_t> numbers_;  ///< looked up, never iterated
};

GiNaC::ex to_ginac(const Number& number);
GiNaC::ex called(Function function, const std::vector<GiNaC::ex>& arguments);

}  // namespace torsor::printing
