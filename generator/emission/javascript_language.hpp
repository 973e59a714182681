// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "torsor/generator/emission/language.hpp"
#include "torsor/generator/emission/mechanism_listing.hpp"

namespace torsor {

/// JavaScript in the terms of templates/mechanism.js.in: every argument and result is one typed array. The state is
/// time, coordinates, velocities; Precomputed the parameters and its members; a structure its members one after the
/// other.
class JavascriptLanguage final : public Language {
 public:
  /// `parameters` is the array that starts with the parameters, `results` tells what of the structure each result is.
  JavascriptLanguage(const MechanismListing& mechanism, std::string parameters,
                     std::map<std::string, const Structure*> results = {});

  bool has_floats() const override { return false; }
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
  std::map<std::string, const Structure*> results_;
};

/// Where a member of a structure begins, its members lying one after the other.
std::size_t offset_of(const Structure& structure, const std::string& member);
/// Numbers in a structure.
std::size_t size_of(const Structure& structure);

}  // namespace torsor
