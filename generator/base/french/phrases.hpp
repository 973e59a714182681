// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "torsor/generator/base/french/contacts.hpp"
#include "torsor/generator/base/french/equations.hpp"
#include "torsor/generator/base/french/report.hpp"
#include "torsor/generator/base/french/statics.hpp"
#include "torsor/generator/base/french/structure.hpp"

namespace torsor {

/// The table of phrases, in the words of S. Pommier's course, Dynamique des systèmes de solides.
constexpr std::array<std::span<const Translation>, 5> french_parts{french_of_equations, french_of_statics, french_of_structure,
                                                                   french_of_report, french_of_contacts};

/// Empty where there is none.
constexpr std::string_view find_french(std::string_view english) {
  for (const std::span<const Translation>& part : french_parts) {
    for (const Translation& each : part) {
      if (each.english == english) return each.french;
    }
  }
  return {};
}

/// The same while a file is compiled, where a missing one is an error.
consteval std::string_view french_of(std::string_view english) {
  const std::string_view french = find_french(english);
  if (french.empty()) throw "the phrase has no French: add it to generator/base/french";
  return french;
}

}  // namespace torsor
