// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/listing/listing.hpp"

namespace torsor {

/// How a language writes what stands in a listing. Operators, their order and the names of local variables are the same
/// in all; see listing_printer.hpp.
class Language {
 public:
  virtual ~Language() = default;

  /// A number, rounded once.
  virtual std::string constant(const Number& number) const = 0;
  /// Declares a local variable with its value.
  virtual std::string local(const std::string& name, const std::string& value) const = 0;
  virtual std::string pi() const = 0;
  /// Declares a constant that is rounded from more than a number; `value` is the text of its formula.
  virtual std::vector<std::string> literal(const std::string& name, const Literal& literal,
                                           const std::string& value) const = 0;
  /// Where an argument, a member of Precomputed or an output stands.
  virtual std::string access(const Quantity& quantity) const = 0;
  virtual std::string access(const Target& target) const = 0;
  /// The name of a function of numbers.
  virtual std::string function(Function function) const = 0;
  /// Sine and cosine of one angle, which are both declared here.
  virtual std::vector<std::string> sine_and_cosine(const std::string& angle, const std::string& sine,
                                                   const std::string& cosine) const = 0;
  /// Of several angles, into arrays.
  virtual std::vector<std::string> sines_and_cosines(const std::vector<std::string>& angles, const std::string& suffix) const = 0;
  /// Whether a pivot is regular beside another number.
  virtual std::string regular(const std::string& pivot, const std::string& diagonal) const = 0;
  /// One of "ok", "singular", "not_finite".
  virtual std::string status(const std::string& name) const = 0;
};

}  // namespace torsor
