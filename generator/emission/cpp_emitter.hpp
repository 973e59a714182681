// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/emission/cpp_function.hpp"
#include "generator/emission/formula_printer.hpp"
#include "generator/expression/formula.hpp"

namespace torsor {

/// Writes the body of one function: declares the numbers, gives what it reads local names, then computes the
/// definitions of a block and assigns results. It optimises nothing: each definition is one statement, each operator of
/// the formula trees one operator of the text. Sines and cosines come first, with what their angles need: those of all
/// angles that need no sine or cosine in one call, then those of angles that need these. What follows stands in the
/// order of issue_order.hpp. Results that are equal up to sign are computed once.
class FunctionEmitter {
 public:
  /// `parameters` is where parameters are read from: "precomputed.parameters." or "parameters.".
  FunctionEmitter(Program& program, std::string parameters)
      : program_(&program), printer_(program), parameters_(std::move(parameters)) {}

  /// Sums that stand ready under a name, e.g. precomputed.y0.
  void provide(const SumTable& ready, const std::string& prefix);
  void compute(const Block& block);
  void assign(const std::string& target, const Value& value);
  /// Returns Status::singular when a pivot is not regular, not_finite when an assigned result is not, else ok. That
  /// takes one multiplication for each of them, which the operations leave out: they are those of the equations.
  void return_status(const std::vector<std::pair<Value, Value>>& pivots);
  /// A result that return_status looks at.
  void check_finite(const std::string& target);
  void line(const std::string& code);
  std::string name(const Number& number) { return printer_.name(number); }
  /// The text that gives a sum in atoms that have been computed.
  std::string text(const Polynomial& sum);
  /// Adds to the operations that the text states.
  void add_operations(const OperationCount& operations) { operations_ += operations; }

  bool reads_ready() const { return reads_ready_; }

  FunctionText take();

 private:
  void define(Atom atom);
  void define_constant(Atom atom);
  void define_sines_and_cosines(const Block& block);
  void define_pass(const std::vector<Atom>& pass, std::size_t number, const std::vector<bool>& live);
  void statement(const std::string& code, const std::string& meaning);
  std::string text_of(const Value& value, const std::string& target);

  Program* program_;
  FormulaPrinter printer_;
  std::string parameters_;
  const SumTable* ready_ = nullptr;
  std::string ready_prefix_;
  std::vector<bool> done_;            ///< definitions that are written
  SumTable written_;                  ///< results that cost something, with
  std::vector<std::string> places_;   ///< where each was written
  std::vector<bool> place_negative_;  ///< and whether with the other sign
  std::vector<std::string> results_;  ///< targets of results that could be not finite and repeat no other
  bool repeats_ = false;  ///< whether the last result did, up to sign
  std::string bindings_, code_;
  bool reads_ready_ = false;
  OperationCount operations_;
};

}  // namespace torsor
