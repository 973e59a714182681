// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/listing/listing.hpp"

namespace torsor {

/// The variable of a recurrence.
inline const char* name_of(OrderQuantity quantity) {
  constexpr const char* names[] = {"number_", "inverse_", "next_", "first_"};
  return names[static_cast<std::size_t>(quantity)];
}

/// An angle as a text names it, and what its sine and cosine are to be called; empty for one that nothing reads.
struct AngleText {
  std::string angle, sine, cosine;
  std::string meaning;
};

/// A statement, and what it means.
struct CodeLine {
  std::string code;
  std::string meaning{};
};

/// What is done at each order of a recurrence.
struct RecurrenceText {
  std::size_t size = 0;                                           ///< of the state
  std::vector<CodeLine> steps;                                    ///< without indentation
  std::vector<std::string> next;                                  ///< coefficients of the next order
  std::vector<std::pair<std::string, std::string>> convolutions;  ///< of which pairs of series
  bool is_first_read = false;
  std::string zero, one;
};

/// How a language writes what stands in a listing. Operators, their order and the names of local variables are the same
/// in all; see listing_printer.hpp.
class Language {
 public:
  virtual ~Language() = default;

  /// Whether its text computes in float too.
  virtual bool has_floats() const { return true; }
  /// A number, rounded once.
  virtual std::string constant(const Number& number) const = 0;
  /// Declares a local variable with its value.
  virtual std::string local(const std::string& name, const std::string& value) const = 0;
  virtual std::string pi() const = 0;
  /// Declares a constant that is rounded from more than a number; `value` is the text of its formula.
  virtual std::vector<CodeLine> literal(const std::string& name, const Literal& literal,
                                        const std::string& value) const = 0;
  /// Whether such a constant is computed by its formula where literals are not exact enough.
  virtual bool computes_literals() const { return false; }
  /// Where an argument, a member of Precomputed or an output stands.
  virtual std::string access(const Quantity& quantity) const = 0;
  virtual std::string access(const Target& target) const = 0;
  /// The name of a function of numbers.
  virtual std::string function(Function function) const = 0;
  /// Declares sines and cosines of a group of angles, the first of a function or a later one; of a single angle both.
  virtual std::vector<CodeLine> sines_and_cosines(const std::vector<AngleText>& angles, int group) const = 0;
  /// The loop over orders 1 to order - 1.
  virtual std::vector<CodeLine> recurrence(const RecurrenceText& text) const = 0;
  /// Whether a pivot is regular beside another number.
  virtual std::string regular(const std::string& pivot, const std::string& diagonal) const = 0;
  /// Whether a number is finite.
  virtual std::string finite(const std::string& number) const = 0;
  /// One of "ok", "singular", "not_finite".
  virtual std::string status(const std::string& name) const = 0;
};

/// Sines and cosines of a group of several angles, in C and what is like it: into arrays of `type` by a call, which is
/// given the number of angles and the suffix of the arrays.
std::vector<CodeLine> sines_in_arrays(const std::vector<AngleText>& angles, int group, const std::string& type,
                                      const std::function<std::string(std::size_t, const std::string&)>& call);

/// Where Taylor coefficients stand, if they are one array, order after order; `size` is that of the state.
std::string coefficient_in_array(const Target& target, std::size_t size);

/// What is done at each order, behind its first lines, if coefficients and kept series are one array each.
std::vector<CodeLine> order_in_arrays(const RecurrenceText& text);

}  // namespace torsor
