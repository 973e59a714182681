// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/cli/report.hpp"
#include "torsor/generator/dynamics/motion/model.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/printing/html_text.hpp"
#include "torsor/generator/printing/print_equations.hpp"
#include "torsor/runtime/events/event_memory.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::french_test {
namespace {

using testing_programs::expect_failure;
using testing_programs::run;

/// Scenes without an English name: what is left of English on their pages is torsor's.
Scene loop() {
  Scene s("quadrilatere");
  const Expression l = s.parameter("l", "m", 1), m = s.parameter("m", "kg", 2), g = s.parameter("g", "m/s^2", 10);
  const Expression a = s.coordinate("a", "rad"), b = s.coordinate("b", "rad"), c = s.coordinate("c", "rad");
  const FrameHandle first = s.revolute("un", s.ground(), axis::x, a);
  const FrameHandle second = s.revolute("deux", first, axis::x, b, {.origin = {0, l, 0}});
  const FrameHandle third = s.revolute("trois", second, axis::x, c, {.origin = {0, 2 * l, 0}});
  s.body("un", first, Inertia::rod(m, l, 1));
  s.body("deux", second, Inertia::rod(m, 2 * l, 1));
  s.body("trois", third, Inertia::rod(m, l, 1));
  const FrameHandle fixed = s.weld("fixe", s.ground(), {.origin = {0, 2 * l, 0}});
  const FrameHandle end = s.weld("bout", third, {.origin = {0, l, 0}});
  s.loop_joint("ferme", {JointType::revolute, fixed, end});
  s.gravity({0, -g, 0});
  s.damper("amorti", a, s.parameter("k", "N m s", 1));
  s.motor("couple", a);
  s.initial(a, pi() / 2);
  s.initial(b, -pi() / 2);
  s.initial(c, -pi() / 2);
  return s;
}

Scene free_body() {
  Scene s("libre");
  const Expression m = s.parameter("m", "kg", 2), g = s.parameter("g", "m/s^2", 10), J = s.parameter("J", "kg m^2", 1);
  const FrameHandle body = s.free("corps", s.ground(), {s.coordinate("x", "m"), s.coordinate("y", "m"), s.coordinate("z", "m")}, s.attitude("e"));
  s.body("corps", body, Inertia::general({.mass = m, .xx = J, .yy = 2 * J, .zz = 3 * J}));
  s.gravity({0, 0, -g});
  return s;
}

Scene driven() {
  Scene s("entraine");
  const Expression m = s.parameter("m", "kg", 2), g = s.parameter("g", "m/s^2", 10), l = s.run_time_parameter("l", "m", 1);
  const Expression w = s.parameter("w", "rad/s", 3), phi = s.coordinate("phi", "rad"), q = s.coordinate("q", "rad");
  s.drive(phi, w * s.time());
  const FrameHandle rotor = s.revolute("rotor", s.ground(), axis::z, phi);
  const FrameHandle arm = s.revolute("bras", rotor, axis::y, q);
  s.body("bras", arm, Inertia::point(m).at({0, 0, -l}));
  s.gravity({0, 0, -g});
  s.motor("moteur", q);
  s.point("P", arm, {0, 0, -l});
  return s;
}

Scene sled() {
  Scene s("luge");
  const Expression m = s.parameter("m", "kg", 2), I = s.parameter("I", "kg m^2", 1);
  const Expression x = s.coordinate("x", "m"), y = s.coordinate("y", "m"), psi = s.coordinate("psi", "rad");
  const FrameHandle along = s.prismatic("long", s.ground(), axis::x, x);
  const FrameHandle across = s.prismatic("large", along, axis::y, y);
  const FrameHandle body = s.revolute("corps", across, axis::z, psi);
  s.body("corps", body, Inertia::general({.mass = m, .zz = I}));
  s.nonholonomic("lame", cos(psi) * rate(y) - sin(psi) * rate(x));
  return s;
}

/// A ball that bounces and rolls between two walls, with dry friction of its lift.
Scene contacts() {
  Scene s("rebond");
  const Expression m = s.parameter("m", "kg", 2), g = s.parameter("g", "m/s^2", 10), r = s.parameter("r", "m", Expression(Number::rational(1, 10)));
  const Expression x = s.coordinate("x", "m"), z = s.coordinate("z", "m"), phi = s.coordinate("phi", "rad");
  s.initial(x, 0, 1);
  s.initial(z, 1);
  const FrameHandle slide = s.prismatic("long", s.ground(), axis::x, x);
  const FrameHandle lift = s.prismatic("haut", slide, axis::z, z);
  const FrameHandle ball = s.revolute("balle", lift, axis::y, phi);
  s.body("balle", ball, Inertia::solid_sphere(m, r));
  s.gravity({0, 0, -g});
  s.contact("sol", shape::Sphere{.frame = ball, .radius = r}, shape::Plane{.frame = s.ground()},
            {.friction = Expression(Number::rational(1, 5)), .restitution = Expression(Number::rational(1, 2)), .rolling = r / 100});
  s.stop(x, std::nullopt, 20 * r);
  s.dry_friction("glissiere", z, {.bound = Expression::quantity("0.5", "N")});
  return s;
}

const std::vector<Scene (*)()> scenes{loop, free_body, driven, sled, contacts};

/// What stands on a page outside its scripts and styles.
std::string outside_scripts(std::string page) {
  for (const auto& [begin, end] :
       std::map<std::string, std::string>{{"<style>", "</style>"}, {"<script", "</script>"}}) {
    for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
      page.erase(at, page.find(end, at) + end.size() - at);
    }
  }
  return page;
}

/// What a reader meets: that, and the strings in the templates' scripts that are more than a word.
std::string for_a_reader(const std::string& page) {
  static const std::regex string(R"re("[^"\n]* [^"\n]*"|`[^`\n]* [^`\n]*`)re");
  std::string text = outside_scripts(page);
  for (const std::string script : {"integrator", "projection", "motion", "playback", "modes", "vectors", "shapes", "viewer", "plots", "formulas", "page"}) {
    const std::size_t begin = page.find("<script id=\"script-" + script + "\">");
    EXPECT_NE(begin, std::string::npos) << script;
    const std::string body = page.substr(begin, page.find("</script>", begin) - begin);
    for (std::sregex_iterator at(body.begin(), body.end(), string), end; at != end; ++at) text += at->str() + "\n";
  }
  return text;
}

/// The pieces of a phrase between its places.
std::set<std::string> pieces(std::string_view phrase) {
  static const std::regex place(R"(\$?\{[^{}]*\})");
  const std::string whole(phrase);
  std::set<std::string> found;
  for (std::sregex_token_iterator at(whole.begin(), whole.end(), place, -1), end; at != end; ++at) {
    if (at->length() >= 9) found.insert(at->str());
  }
  return found;
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Where a piece stands as words of their own, in text or in a script.
bool says(const std::string& page, const std::string& piece) {
  for (const std::string& spelled : {piece, html_escaped(piece)}) {
    for (std::size_t at = page.find(spelled); at != std::string::npos; at = page.find(spelled, at + 1)) {
      const auto letter = [&](std::size_t k) { return k < page.size() && std::isalnum(static_cast<unsigned char>(page[k])) != 0; };
      const bool inside = (at > 0 && letter(at - 1) && letter(at)) || (letter(at + spelled.size()) && letter(at + spelled.size() - 1));
      if (!inside) return true;
    }
  }
  return false;
}

TEST(French, LeavesNoEnglishPhraseOnAPage) {
  std::set<std::string> met;
  for (Scene (*scene)() : scenes) {
    ReportOptions options;
    const std::string english = for_a_reader(report_html(scene(), options));
    options.language = NaturalLanguage::named("fr");
    const std::string french = for_a_reader(report_html(scene(), options));
    EXPECT_TRUE(contains(english, "<html lang=\"en\">"));
    EXPECT_TRUE(contains(french, "<html lang=\"fr\">"));
    std::string of_french;
    for (const Translation& each : french_phrases()) of_french += std::string(each.french) + "\n";
    for (const Translation& each : french_phrases()) {
      for (const std::string& piece : pieces(each.english)) {
        if (contains(of_french, piece)) continue;  // a formula, or the same words in both
        if (says(english, piece)) met.insert(piece);
        EXPECT_FALSE(says(french, piece)) << scene().name() << ": " << piece;
      }
    }
  }
  EXPECT_GT(met.size(), 150U);  // of some 300: the test sees what it forbids
}

// Words that every English sentence has: what has not even become a phrase.
TEST(French, LeavesNoEnglishWordOnAPage) {
  static const std::regex text_of_page(R"(>([^<>]+)<|aria-label="([^"]*)\")");
  static const std::regex english(R"((^|[ (])(the|of|is|are|and|with|for|at|by|from|their|body|joint)([ ,.:;)]|$))");
  std::size_t in_english = 0;
  for (Scene (*scene)() : scenes) {
    for (const char* code : {"en", "fr"}) {
      ReportOptions options;
      options.language = NaturalLanguage::named(code);
      const std::string page = outside_scripts(report_html(scene(), options));
      for (std::sregex_iterator at(page.begin(), page.end(), text_of_page), end; at != end; ++at) {
        const std::string words = (*at)[1].matched ? (*at)[1].str() : (*at)[2].str();
        if (!std::regex_search(words, english)) continue;
        if (!options.language.is_english()) ADD_FAILURE() << scene().name() << ": " << words;
        else ++in_english;
      }
    }
  }
  EXPECT_GT(in_english, 60U);
}

TEST(French, IsSpokenByEveryTemplateOfTheReport) {
  int phrases = 0;
  for (const std::string_view name : embedded_template_names()) {
    if (!name.starts_with("report/")) continue;
    const std::string_view text = embedded_template(name);
    for (std::size_t at = text.find(phrase_begin); at != std::string_view::npos; at = text.find(phrase_begin, at + 1)) ++phrases;
    for (const char* code : {"en", "fr"}) {
      const std::string said = NaturalLanguage::named(code).said_in(text);
      EXPECT_FALSE(contains(said, std::string(phrase_begin))) << name;
      EXPECT_FALSE(contains(said, std::string(phrase_end))) << name;
    }
  }
  EXPECT_GT(phrases, 80);
}

// Formulas, numbers and names are the same: lines with an equation, without remarks in brackets behind it.
TEST(French, KeepsFormulas) {
  static const std::regex remark(R"(    \([^()]*(\([^()]*\))?[^()]*\)\n)"), equation(R"((^|\n)  +\S+( =|:  )[^\n]*)");
  for (Scene (*scene)() : scenes) {
    PrintOptions options;
    const auto formulas = [&] {
      const std::string text = std::regex_replace(print_equations(scene(), Format::text, options), remark, "\n");
      std::vector<std::string> found;
      for (std::sregex_iterator at(text.begin(), text.end(), equation), end; at != end; ++at) found.push_back(at->str());
      std::erase_if(found, [](const std::string& line) { return contains(line, "constant") || contains(line, "P_i") || contains(line, "[[X]]"); });
      return found;
    };
    const std::vector<std::string> english = formulas();
    options.language = NaturalLanguage::named("fr");
    EXPECT_EQ(formulas(), english);
    EXPECT_GT(english.size(), 5U);
  }
}

TEST(French, IsSpokenByCommands) {
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"equations"}, {"statics"}, {"theorem"}, {"theorem", "--kind", "energy"}, {"unknowns"},
                                             {"structure"}, {"graph", "--of", "analysis"},
                                             {"unknowns", "--isolate", "bras", "--at", "P"}}) {
    std::vector<std::string> french = command, named = command;
    french.insert(french.end(), {"--language", "fr"});
    named.insert(named.end(), {"--language", "en"});
    const auto spoken = run(driven, french);
    EXPECT_EQ(spoken.code, 0) << spoken.err;
    EXPECT_NE(spoken.out, run(driven, command).out);
    EXPECT_EQ(run(driven, named).out, run(driven, command).out);
  }
  const auto screw = run(driven, {"screw", "--body", "bras", "--at", "bras", "--language", "fr"});
  EXPECT_TRUE(contains(screw.out, "Torseur cinétique")) << screw.out << screw.err;
  EXPECT_TRUE(contains(run(driven, {"equations", "--language", "fr"}).out, "Équation de Painlevé et intégrales premières"));
  const std::string latex = run(driven, {"equations", "--language", "fr", "--format", "latex", "--document"}).out;
  EXPECT_TRUE(contains(latex, "\\subsection*{Équations de Lagrange}"));
}

TEST(French, IsTheOnlyOtherLanguage) {
  for (const char* command : {"report", "equations", "statics", "unknowns", "theorem", "structure", "graph"}) {
    expect_failure(run(driven, {command, "--language", "de"}), 2, "unknown language 'de': use en (English) or fr (French)");
  }
}

// What ends a motion is said by the runtime: a status without French would be English on a French page.
TEST(French, KnowsEachReasonWhyAMotionEnds) {
  const NaturalLanguage say = NaturalLanguage::named("fr");
  const auto expect_known = [&say](std::string_view words) {
    EXPECT_FALSE(words.starts_with("unknown")) << words;
    EXPECT_NE(say.known(std::string(words)), words);
  };
  std::ifstream file(TORSOR_SOURCE_DIR "/runtime/contacts/contact_result.hpp");  // its enumeration would need Eigen here
  const std::string source(std::istreambuf_iterator<char>(file), {});
  static const std::regex returned(R"re(return "([^;]*)";)re"), joint(R"("\s+")");
  int statuses = 0;
  for (std::sregex_iterator at(source.begin(), source.end(), returned), end; at != end; ++at) {
    const std::string words = std::regex_replace((*at)[1].str(), joint, "");
    if (words.starts_with("unknown")) continue;
    expect_known(words);
    ++statuses;
  }
  EXPECT_EQ(statuses, 19);
  for (int i = 0; i <= static_cast<int>(runtime::IntegrationStatus::unsuitable_model); ++i) {
    expect_known(describe(static_cast<runtime::IntegrationStatus>(i)));
  }
  for (int i = 0; i <= static_cast<int>(runtime::EventStatus::integration_failed); ++i) {
    expect_known(describe(static_cast<runtime::EventStatus>(i)));
  }
}

}  // namespace
}  // namespace torsor::french_test
