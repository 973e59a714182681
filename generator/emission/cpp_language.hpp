// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "torsor/generator/emission/language.hpp"
#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {

/// C++17 in the terms of templates/mechanism.hpp.in: `Scalar` and `traits`.
class CppLanguage final : public Language {
 public:
  /// `parameters` is where parameters are read from: "precomputed.parameters." or "parameters."; `members` are the
  /// names of the members of Precomputed; `vectors` tells the structures of results that have a name for each entry.
  CppLanguage(const Layout& layout, std::string parameters, std::vector<std::string> members,
              std::map<std::string, const Structure*> vectors = {});

  std::string constant(const Number& number) const override;
  std::string local(const std::string& name, const std::string& value) const override;
  std::string pi() const override;
  std::vector<CodeLine> literal(const std::string& name, const Literal& literal,
                                const std::string& value) const override;
  bool computes_literals() const override { return true; }
  std::string access(const Quantity& quantity) const override;
  std::string access(const Target& target) const override;
  std::string function(Function function) const override;
  std::vector<CodeLine> sines_and_cosines(const std::vector<AngleText>& angles, int group) const override;
  std::vector<CodeLine> recurrence(const RecurrenceText& text) const override;
  std::string regular(const std::string& pivot, const std::string& diagonal) const override;
  std::string finite(const std::string& number) const override;
  std::string status(const std::string& name) const override;

 private:
  const Layout* layout_;
  std::string parameters_;
  std::vector<std::string> members_;
  std::map<std::string, const Structure*> vectors_;
};

}  // namespace torsor
