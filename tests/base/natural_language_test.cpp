// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/natural_language.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"

namespace torsor::natural_language_test {
namespace {

std::vector<std::string> matches(std::string_view text, const std::regex& pattern) {
  const std::string whole(text);
  std::vector<std::string> found;
  for (std::sregex_iterator at(whole.begin(), whole.end(), pattern), end; at != end; ++at) found.push_back(at->str());
  return found;
}

// A place that is lost, added or out of order would put a name where another belongs, or throw when a page is written.
TEST(NaturalLanguage, KeepsThePlacesOfEachPhrase) {
  static const std::regex script(R"(\$\{[^}]*\})"), place(R"(\{\{|\}\}|\{:?[^{}]*\})");
  for (const Translation& each : french_phrases()) {
    EXPECT_FALSE(each.french.empty()) << each.english;
    EXPECT_EQ(matches(each.english, script), matches(each.french, script)) << each.english;
    const auto places = [](std::string_view text) {
      std::vector<std::string> found = matches(text, place);
      std::erase_if(found, [](const std::string& one) { return one != "{}" && !one.starts_with("{:"); });
      return found;
    };
    EXPECT_EQ(places(each.english), places(each.french)) << each.english;
    EXPECT_EQ(std::count(each.english.begin(), each.english.end(), '$') % 2, std::count(each.french.begin(), each.french.end(), '$') % 2)
        << each.english;
    EXPECT_EQ(each.english.find('\\') == std::string_view::npos, each.french.find('\\') == std::string_view::npos) << each.english;
    EXPECT_EQ(std::isspace(static_cast<unsigned char>(each.english.back())) != 0,
              std::isspace(static_cast<unsigned char>(each.french.back())) != 0)
        << each.english;
  }
}

TEST(NaturalLanguage, HasEachPhraseOnce) {
  std::set<std::string_view> known;
  for (const Translation& each : french_phrases()) EXPECT_TRUE(known.insert(each.english).second) << each.english;
  EXPECT_GT(known.size(), 250U);
}

/// The string literals of a source, neighbours put together, escapes as they are written.
std::vector<std::string> literals(const std::string& source) {
  std::vector<std::string> found;
  bool together = false;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source[i] == '\'' && i + 2 < source.size() && source[i + 2] == '\'') {
      i += 2;  // a character, '"' above all
    } else if (source[i] == '"') {
      std::string text;
      for (++i; source[i] != '"'; ++i) {
        text += source[i];
        if (source[i] == '\\') text += source[++i];
      }
      if (together) found.back() += text;
      else found.push_back(text);
      together = true;
    } else if (std::isspace(static_cast<unsigned char>(source[i])) == 0) {
      together = false;
    }
  }
  return found;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A phrase that nothing says is a translation of a sentence that has changed.
TEST(NaturalLanguage, HasNoPhraseThatNothingSays) {
  const std::filesystem::path root(TORSOR_SOURCE_DIR);
  std::set<std::string> said;
  std::string templates;
  for (const auto& file : std::filesystem::recursive_directory_iterator(root / "generator")) {
    const std::string path = file.path().generic_string();
    if (!path.ends_with(".cpp") || path.find("/french/") != std::string::npos) continue;
    for (const std::string& each : literals(text_of(file.path()))) said.insert(each);
  }
  // What describe says of a status.
  for (const char* file : {"runtime/status.hpp", "runtime/contacts/contact_result.hpp", "runtime/events/event_memory.hpp"}) {
    for (const std::string& each : literals(text_of(root / file))) said.insert(each);
  }
  for (const auto& file : std::filesystem::directory_iterator(root / "templates/report")) templates += text_of(file.path());
  const auto escaped = [](std::string_view text) {
    std::string result;
    for (const char c : text) {
      if (c == '\\' || c == '"') result += '\\';
      result += c;
    }
    return result;
  };
  for (const Translation& each : french_phrases()) {
    const std::string literal = escaped(each.english);
    // Programs name their definitions "velocity of forearm, x".
    const bool found = said.contains(literal) || said.contains(literal + " of ") ||
                       templates.find("\xc2\xab" + std::string(each.english) + "\xc2\xbb") != std::string::npos;
    EXPECT_TRUE(found) << each.english;
  }
}

TEST(NaturalLanguage, SaysTheSamePhraseInBoth) {
  const NaturalLanguage english, french = NaturalLanguage::named("fr");
  EXPECT_EQ(english("No momentum integral along {}: {}.", "x", "U depends on it"), "No momentum integral along x: U depends on it.");
  EXPECT_EQ(french("T depends on it"), "T en dépend");
  EXPECT_EQ(english.code(), "en");
  EXPECT_EQ(french.code(), "fr");
}

TEST(NaturalLanguage, ReadsPhrasesOfTemplates) {
  const std::string text = "<b title='\xc2\xabSpeed\xc2\xbb'>\xc2\xabPlay\xc2\xbb</b> \xc2\xabopen";
  EXPECT_EQ(NaturalLanguage().said_in(text), "<b title='Speed'>Play</b> \xc2\xabopen");
  EXPECT_EQ(NaturalLanguage::named("fr").said_in(text), "<b title='Vitesse'>Lecture</b> \xc2\xabopen");
  EXPECT_THROW(NaturalLanguage().said_in("\xc2\xabnobody says this\xc2\xbb"), Error);
}

TEST(NaturalLanguage, NamesALanguageThatItDoesNotKnow) {
  try {
    NaturalLanguage::named("de");
    FAIL() << "German was accepted";
  } catch (const UsageError& error) {
    EXPECT_STREQ(error.what(), "unknown language 'de': use en (English) or fr (French)");
  }
}

}  // namespace
}  // namespace torsor::natural_language_test
