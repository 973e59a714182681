// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/natural_language.hpp"

#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"

namespace torsor {

NaturalLanguage NaturalLanguage::named(const std::string& code) {
  NaturalLanguage language;
  if (code != "en" && code != "fr") {
    throw UsageError(fmt::format("unknown language '{}': {}use en (English) or fr (French)", code, did_you_mean(code, {"en", "fr"})));
  }
  language.french_ = code == "fr";
  return language;
}

std::string NaturalLanguage::known(const std::string& english) const {
  if (!french_) return english;
  const std::string_view french = find_french(english);
  return french.empty() ? english : std::string(french);
}

std::string NaturalLanguage::said_in(std::string_view text) const {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find(phrase_begin, at);
    const std::size_t end = begin == std::string_view::npos ? begin : text.find(phrase_end, begin);
    if (end == std::string_view::npos) {
      result += text.substr(at);
      break;
    }
    result += text.substr(at, begin - at);
    const std::string_view english = text.substr(begin + phrase_begin.size(), end - begin - phrase_begin.size());
    const std::string_view french = find_french(english);
    if (french.empty()) {
      throw Error(fmt::format("the phrase '{}' of a template has no French: add it to generator/base/french", english));
    }
    result += french_ ? french : english;
    at = end + phrase_end.size();
  }
  return result;
}

std::vector<Translation> french_phrases() {
  std::vector<Translation> all;
  for (const auto& part : french_parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace torsor
