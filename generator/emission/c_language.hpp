// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/emission/language.hpp"
#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

/// C99 in the terms of templates/mechanism.h.in: numbers are `torsor_real`, arguments come by pointers, vectors are
/// arrays.
class CLanguage final : public Language {
 public:
  /// `parameters` is the array that holds them.
  CLanguage(const MechanismListing& mechanism, std::string parameters)
      : mechanism_(&mechanism), parameters_(std::move(parameters)) {}

  std::string constant(const Number& number) const override;
  std::string local(const std::string& name, const std::string& value) const override;
  std::string pi() const override;
  std::vector<CodeLine> literal(const std::string& name, const Literal& literal,
                                const std::string& value) const override;
  std::string access(const Quantity& quantity) const override;
  std::string access(const Target& target) const override;
  std::string function(Function function) const override;
  std::vector<CodeLine> sines_and_cosines(const std::vector<AngleText>& angles, int group) const override;
  std::vector<CodeLine> recurrence(const RecurrenceText& text) const override;
  std::string regular(const std::string& pivot, const std::string& diagonal) const override;
  std::string finite(const std::string& number) const override;
  std::string status(const std::string& name) const override;

 private:
  const MechanismListing* mechanism_;
  std::string parameters_;
};

}  // namespace torsor
