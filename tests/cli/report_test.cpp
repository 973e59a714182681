// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/cli/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "generator/cli/katex.hpp"
#include "generator/printing/html_text.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::report_test {
namespace {

using testing_programs::pendulum;
using testing_programs::run;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// The page without the text of one of its scripts.
std::string without(const std::string& script, std::string page) {
  const std::string begin = "<script id=\"" + script + "\">";
  if (const std::size_t at = page.find(begin); at != std::string::npos) {
    const std::size_t inside = at + begin.size();
    page.erase(inside, page.find("</script>", inside) - inside);
  }
  return page;
}

/// The page without KaTeX, which knows of pictures and addresses.
std::string own_text(const std::string& page) { return without("katex", page); }

TEST(Report, IsOneFileThatAsksForNoOther) {
  const std::string whole = report_html(pendulum(), {}), page = own_text(whole);
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  for (const char* outside : {"<link", "<img", "<iframe", "src=", "@import", "url(http", "url(fonts"}) {
    EXPECT_FALSE(contains(page, outside)) << outside;
  }
  EXPECT_TRUE(contains(page, "default-src 'none'"));
  EXPECT_EQ(count(page, "<svg "), 2U);
  EXPECT_TRUE(contains(page, "data-latex=\"\\begin{aligned}T &amp;= "));
  EXPECT_LT(whole.size(), 1'200'000U);
  EXPECT_EQ(contains(page, "KaTeX was not there"), katex_script().empty());
  EXPECT_EQ(count(page, "font/woff2;base64,"), katex_fonts().size());
}

TEST(Report, HasTheSameBytesEachTime) { EXPECT_EQ(report_html(pendulum(), {}), report_html(pendulum(), {})); }

// All parameters can be changed on the page; those of a robot, of which there are hundreds, where the scene says so.
TEST(Report, LetsTheReaderChangeParameters) {
  EXPECT_TRUE(contains(report_html(pendulum(), {}), R"({"name":"mass","unit":"kg"})"));
  ReportOptions options;
  options.model.run_time = {"length"};
  EXPECT_FALSE(contains(report_html(pendulum(), options), R"({"name":"mass","unit":"kg"})"));
}

Scene hostile() {
  const std::string bad = "</script><script>hacked()</script><!--\"' onload=x \\href{javascript:x} $(x) */ ]]>";
  Scene scene("hostile", bad);
  const Expression q = scene.coordinate("q", "rad");
  const FrameHandle arm = scene.revolute("<b>arm</b>\"", scene.ground(), axis::y, q);
  scene.body("body", arm, Inertia::point(Expression::quantity("1", "kg")).at({0, 0, Expression::quantity("-1", "m")}));
  scene.weld("</textarea><img src=x>", arm, {});
  scene.damper("\"><svg onload=x>", q, Expression::quantity("1", "N m s"));
  return scene;
}

// Titles and names are data wherever they stand: in text, in attributes, in scripts, in pictures.
TEST(Report, TakesNoNameForMarkup) {
  const std::string page = own_text(report_html(hostile(), {})), other = own_text(report_html(pendulum(), {}));
  for (const char* tag : {"<script>", "<b>", "<img", "<svg onload", "</textarea>", "<!--\""}) {
    // In a script only what would end it or begin a comment matters.
    EXPECT_FALSE(contains(without("mechanism", page), tag)) << tag;
  }
  EXPECT_EQ(count(page, "<script "), count(other, "<script "));
  EXPECT_EQ(count(page, "</script>"), count(other, "</script>"));
  EXPECT_TRUE(contains(page, "&lt;/script&gt;&lt;script&gt;hacked()"));
}

TEST(Report, KeepsScriptsInTheirElement) {
  EXPECT_EQ(inside_script("a = \"</script>\" < b; // <!--"), "a = \"<\\/script>\" < b; // <\\!--");
  EXPECT_EQ(inside_json("{\"a\":\"</script>\"}"), "{\"a\":\"\\u003c/script>\"}");
  EXPECT_EQ(html_escaped("<a b='c' d=\"e\">&"), "&lt;a b=&#39;c&#39; d=&quot;e&quot;&gt;&amp;");
  EXPECT_EQ(html_lines("a\n<b>\n"), "a\n&lt;b&gt;\n");
}

TEST(Report, MakesAModuleAnObject) {
  EXPECT_EQ(module_as_object("export const one = 1;\n// export nothing\nexport function two() {\n}\n"),
            "(() => {\n\"use strict\";\nconst one = 1;\n// export nothing\nfunction two() {\n}\nreturn { one, two };\n})()");
}

TEST(Report, IsACommandOfEveryProgram) {
  const auto outcome = run(pendulum, {"report", "--to", "3", "--about", "theta=0"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(contains(outcome.out, "\"duration\":3.0"));
  EXPECT_EQ(run(pendulum, {"report", "--run-time", "masse"}).code, 2);
}

}  // namespace
}  // namespace torsor::report_test
