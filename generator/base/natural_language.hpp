// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "torsor/generator/base/french/phrases.hpp"

namespace torsor {

/// A fixed phrase of a page in each language. It is found while a file is compiled: one without a translation is an error
/// of the compiler.
struct Phrase {
  std::string_view english, french;

  consteval Phrase(const char* text) : english(text), french(french_of(text)) {}  // NOLINT: a literal stands for its phrase
};

/// The language of what a person reads. Called with a phrase and what stands in its places {}, it says the phrase:
/// `say("No momentum integral along {}: {}.", name, reasons)`. English where nothing else is asked for.
class NaturalLanguage {
 public:
  NaturalLanguage() = default;
  /// "en" or "fr". Throws UsageError naming anything else.
  static NaturalLanguage named(const std::string& code);

  std::string_view code() const { return french_ ? "fr" : "en"; }
  bool is_english() const { return !french_; }

  template <class... Arguments>
  std::string operator()(Phrase phrase, const Arguments&... arguments) const {
    const std::string_view text = french_ ? phrase.french : phrase.english;
    if constexpr (sizeof...(arguments) == 0) return std::string(text);
    return fmt::format(fmt::runtime(text), arguments...);
  }
  /// A phrase that is known at run time only: the French one, or the same text where there is none.
  std::string known(const std::string& english) const;

  /// A text in which each «phrase» is one to be said. Throws Error naming one without a translation.
  std::string said_in(std::string_view text) const;

 private:
  bool french_ = false;
};

/// The marks of phrases in templates, « and » in UTF-8.
constexpr std::string_view phrase_begin = "\xc2\xab", phrase_end = "\xc2\xbb";

/// All phrases with their French, for tests.
std::vector<Translation> french_phrases();

}  // namespace torsor
