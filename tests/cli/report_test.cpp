// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/cli/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/base/base64.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/katex.hpp"
#include "torsor/generator/dynamics/equations/validation.hpp"
#include "torsor/generator/import/mesh_file.hpp"
#include "torsor/generator/printing/html_text.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::report_test {
namespace {

using testing_mechanisms::metres;
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

// Lengths come from the kernel, so that sliders change them; what stays is data.
TEST(Report, DrawsWhatTheSceneShows) {
  Scene scene = pendulum();
  const Expression length = Expression::quantity("1.5", "m");
  scene.show({.frame = "arm", .form = form::Cylinder{length / 30, length}, .placement = {{0, 0, -length / 2}, {}}});
  scene.show({.frame = "ground", .form = form::Box{{length, length, length / 10}}, .colour = Colour{0.5, 0.25, 1}});
  const std::string page = report_html(scene, {});
  EXPECT_TRUE(contains(page, R"("forms":[{"kind":"cylinder","frame":1,"rotation":[1.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,1.0]},)"));
  EXPECT_TRUE(contains(page, R"({"kind":"box","frame":0,"colour":[0.5,0.25,1.0],)"));
  EXPECT_TRUE(contains(page, "form_lengths"));
  EXPECT_FALSE(contains(report_html(pendulum(), {}), "form_lengths\""));
}

TEST(Report, RefusesWhatCannotBeShown) {
  const auto message = [](const Shown& shown) -> std::string {
    try {
      Scene scene = pendulum();
      scene.show(shown);
      validate(scene);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const Expression metre = Expression::quantity("1", "m");
  EXPECT_TRUE(contains(message({.frame = "arm", .form = form::Sphere{Expression::quantity("1", "kg")}}), "radius of a sphere"));
  EXPECT_TRUE(contains(message({.frame = "rot", .form = form::Sphere{metre}}), "'rot'"));
  EXPECT_TRUE(contains(message({.frame = "arm", .form = form::Cone{metre, -metre}}), "length of the cone that is shown on frame 'arm'"));
  EXPECT_TRUE(contains(message({.frame = "arm", .form = form::Torus{metre, 0 * metre}}), "radius of the torus's tube that is shown on frame 'arm' is 0"));
  EXPECT_TRUE(contains(message({.frame = "arm", .form = form::Torus{metre, 1}}), "radius of the tube of a torus"));
  EXPECT_TRUE(contains(message({.frame = "arm", .form = form::Sphere{metre}, .colour = Colour{2, 0, 0}}), "share 2"));
  EXPECT_EQ(message({.frame = "arm", .form = form::Sphere{metre}}), "");
}

/// A tetrahedron in a file of its own, and one of its faces cut into many.
std::string obj_file(int parts) {
  const std::string path = testing::TempDir() + fmt::format("/torsor_mesh_{}.obj", parts);
  std::ofstream file(path);
  file << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  for (int i = 0; i <= parts; ++i) {
    for (int j = 0; j <= parts; ++j) file << fmt::format("v {} {} 0\n", 1.0 * i / parts, 1.0 * j / parts);
  }
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; j < parts; ++j) {
      const int a = 5 + i * (parts + 1) + j;
      file << fmt::format("f {} {} {} {}\n", a, a + 1, a + parts + 2, a + parts + 1);
    }
  }
  return path;
}

TEST(Report, HasMeshesWhereTheyAreAskedFor) {
  Scene scene = pendulum();
  scene.show({.frame = "arm", .form = form::Mesh{obj_file(2)}});
  EXPECT_FALSE(contains(report_html(scene, {}), "<script id=\"meshes\""));
  ReportOptions options;
  options.meshes = true;
  try {
    const std::string page = report_html(scene, options);
    EXPECT_TRUE(contains(page, R"("high":[1.0,1.0,2.0])"));
    EXPECT_TRUE(contains(page, R"("forms":[{"mesh":0,"scale":[1.0,1.0,1.0]}])"));
  } catch (const FileError& error) {
    EXPECT_TRUE(contains(error.what(), "install libassimp-dev")) << error.what();
    GTEST_SKIP() << error.what();
  }
  scene.show({.frame = "arm", .form = form::Mesh{"lost.stl"}});
  EXPECT_THROW(report_html(scene, options), FileError);
}

// As many triangles as are allowed, no hole in the plane, all of the box.
TEST(Report, MakesMeshesSmaller) {
  TriangleMesh mesh;
  constexpr std::uint32_t n = 60;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t j = 0; j <= n; ++j) mesh.corners.push_back({static_cast<float>(i), static_cast<float>(j), 1.0F});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  EXPECT_EQ(simplified(mesh, 7200).triangles.size(), 7200U);
  const TriangleMesh small = simplified(mesh, 500);
  EXPECT_LE(small.triangles.size(), 500U);
  EXPECT_GE(small.triangles.size(), 200U);
  double area = 0;
  for (const auto& [a, b, c] : small.triangles) {
    const auto &p = small.corners[a], &q = small.corners[b], &r = small.corners[c];
    area += 0.5 * std::abs((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  }
  // Cells at the rim shrink to their means, half a cell at most on each side.
  EXPECT_GT(area, 0.8 * n * n);
  EXPECT_LE(area, 1.001 * n * n);
}

// Numbers of corners have 16 bits in the page.
TEST(Report, KeepsAsManyCornersAsItCanNumber) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < 3 * 22'000; ++i) {
    const float angle = 0.001F * static_cast<float>(i);
    mesh.corners.push_back({std::cos(angle), std::sin(angle), static_cast<float>(i)});
    if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  ASSERT_GT(mesh.corners.size(), most_corners);
  const TriangleMesh small = simplified(mesh, mesh.triangles.size());
  EXPECT_LE(small.corners.size(), most_corners);
  for (const auto& triangle : small.triangles) {
    for (const std::uint32_t corner : triangle) EXPECT_LT(corner, small.corners.size());
  }
  mesh.triangles.resize(1);
  EXPECT_EQ(simplified(mesh, 1).corners.size(), 3U);
}

TEST(Report, EncodesBytesAsOthersDo) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

/// A ball that falls on the ground.
Scene dropped(const std::string& contact = "floor") {
  Scene scene("dropped", "");
  const Expression z = scene.coordinate("z", "m");
  const FrameHandle ball = scene.prismatic("ball", scene.ground(), axis::z, z);
  scene.body("ball", ball, Inertia::point(Expression::quantity("2", "kg")));
  scene.gravity({0, 0, Expression::quantity("-9.81", "m/s^2")});
  scene.initial(z, Expression::quantity("1", "m"));
  scene.contact(contact, shape::Sphere{.frame = ball, .radius = Expression::quantity("0.1", "m")},
                shape::Plane{.frame = scene.ground()}, {.restitution = Expression(Number::rational(1, 2))});
  return scene;
}

// The page cannot solve contacts: it has what was moved here, and says so.
TEST(Report, PlaysBackAMotionWithContacts) {
  ReportOptions options;
  options.duration = 1.0;
  const std::string page = own_text(report_html(dropped(), options));
  EXPECT_TRUE(contains(page, "<script id=\"recording\" type=\"application/json\">{\"interval\":0.0016666666666666668,\"count\":601,"));
  EXPECT_TRUE(contains(page, "This motion is recorded: torsor moved the mechanism"));
  EXPECT_TRUE(contains(page, R"("contacts":[{"name":"floor","plane":0}])"));
  EXPECT_TRUE(contains(page, R"("regimes":[[0,"o"])"));
  EXPECT_FALSE(contains(page, "function forward_dynamics"));
  EXPECT_FALSE(contains(page, "There is no motion"));
  EXPECT_EQ(report_html(dropped(), options), report_html(dropped(), options));
  EXPECT_FALSE(contains(report_html(pendulum(), {}), "<script id=\"recording\""));
}

/// A box and a stone on the floor; a page of it moves nothing for long.
Scene stones() {
  Scene scene("stones", "");
  const Expression m = Expression::quantity("2", "kg");
  const shape::Plane floor{.frame = scene.ground()};
  const auto loose = [&](const std::string& name) {
    const auto place = [&](const char* axis) { return scene.coordinate(name + axis, "m"); };
    const FrameHandle frame = scene.free(name, scene.ground(), {place("_x"), place("_y"), place("_z")}, scene.attitude(name + "_e"));
    scene.body(name, frame, Inertia::solid_sphere(m, metres("0.1")));
    return frame;
  };
  scene.contact("edges", shape::Box{.frame = loose("box"), .half_edges = {metres("0.3"), metres("0.2"), metres("0.1")}}, floor);
  scene.contact("pebble", shape::Ellipsoid{.frame = loose("stone"), .semi_axes = {metres("0.3"), metres("0.2"), metres("0.1")}}, floor);
  scene.contact("tread", shape::Torus{.frame = loose("tyre"), .axis = axis::y, .circle_radius = metres("0.4"), .tube_radius = metres("0.05")}, floor);
  return scene;
}

TEST(Report, BeginsWithTheStartAndTheInputsThatAreGiven) {
  ReportOptions options;
  options.initial = {{"theta", 0.25}};
  EXPECT_TRUE(contains(report_html(pendulum(), options), R"(<script id="given" type="application/json">{"initial":{"theta":0.25},"inputs":{}})"));
  EXPECT_FALSE(contains(report_html(pendulum(), {}), "id=\"given\""));
  options.initial = {{"thetta", 0.25}};
  EXPECT_THROW(report_html(pendulum(), options), UsageError);

  Scene scene("pushed");  // its motion is recorded
  const Expression x = scene.coordinate("x", "m");
  const FrameHandle block = scene.prismatic("block", scene.ground(), axis::x, x);
  scene.body("block", block, Inertia::point(Expression::quantity("1", "kg")));
  scene.motor("push", x);
  scene.stop(x, std::nullopt, Expression::quantity("5", "m"));
  options = {};
  options.duration = 0.5;
  EXPECT_TRUE(contains(report_html(scene, options), "inputs are constant: push = 0"));
  options.initial = {{"x", 1.0}};
  options.inputs = {{"push", 3.0}};
  const std::string page = report_html(scene, options), title = "\"states\":\"";
  EXPECT_TRUE(contains(page, "inputs are constant: push = 3"));
  // x = 1 and x' = 0 in little-endian doubles.
  EXPECT_EQ(page.substr(page.find(title) + title.size(), 20), "AAAAAAAA8D8AAAAAAAAA");
  options.inputs = {{"pull", 3.0}};
  EXPECT_THROW(report_html(scene, options), UsageError);
}

// What touches is drawn as it is: of a box its corners are known, of a convex body points of its surface.
TEST(Report, DrawsBodiesThatTouchAPlane) {
  const nlohmann::json data = nlohmann::json::parse(report_data(stones(), 1.0));
  ASSERT_EQ(data["boxes"], nlohmann::json::parse("[[0,1,2,3,4,5,6,7]]"));
  ASSERT_EQ(data["surfaces"].size(), 2U);
  const nlohmann::json& stone = data["surfaces"][0];
  EXPECT_EQ(stone["point"], 8);
  const std::vector<double> places = stone["places"];
  ASSERT_EQ(places.size(), 3 * stone["rows"].get<std::size_t>() * stone["columns"].get<std::size_t>());
  double top = 0;
  for (std::size_t k = 0; k < places.size(); k += 3) {
    const double x = places[k] / 0.3, y = places[k + 1] / 0.2, z = places[k + 2] / 0.1;
    // Rounded to 1e-5: half of that over the least semi-axis, three times, twice for the squares.
    EXPECT_NEAR(x * x + y * y + z * z, 1.0, 3e-4);
    top = std::max(top, places[k + 2]);
  }
  EXPECT_EQ(top, 0.1);
  EXPECT_EQ(data["surfaces"][1], nlohmann::json::parse(R"({"point":9,"tube":0.05})"));
}

// Statics and forces in joints count no reaction of a contact, and say so where there are contacts.
TEST(Report, SaysWhatLeavesContactsOut) {
  ReportOptions options;
  options.duration = 0.1;
  const std::string open = "Every contact is taken to be open here: reactions of closed contacts are not counted.";
  EXPECT_EQ(count(report_html(dropped(), options), open), 3U) << "with the count of unknowns";
  EXPECT_EQ(count(report_html(pendulum(), options), open), 0U);
  const auto theorem = run([] { return dropped(); }, {"theorem", "--bodies", "ball", "--direction", "z"});
  EXPECT_TRUE(contains(theorem.out, open)) << theorem.out << theorem.err;
}

// Reasons of kernels that are absent are in the page's language.
TEST(Report, SaysInFrenchWhyThereIsNoMotion) {
  Scene scene = pendulum();
  const FrameHandle bare = scene.revolute("bare", "arm", axis::y, scene.coordinate("phi", "rad"));
  scene.weld("end", bare, {});
  scene.keep_massless();
  ReportOptions options;
  options.language = NaturalLanguage::named("fr");
  const std::string page = report_html(scene, options);
  EXPECT_TRUE(contains(page, "Il n&#39;y a pas de mouvement : la matrice de masse est singulière dans tout état, car le paramètre &#39;phi&#39; ne déplace"))
      << page.substr(std::min(page.size(), page.find("class=\"note\"")), 300);
}

// A long motion has fewer samples a second.
TEST(Report, KeepsRecordedMotionsSmall) {
  ReportOptions options;
  options.duration = 400.0;
  EXPECT_LT(report_html(dropped(), options).size(), 1'200'000U);
}

TEST(Report, TakesAReferenceOfItsSceneAlone) {
  const std::string path = testing::TempDir() + "/reference.csv";
  const auto page_of = [&](const std::string& text) {
    std::ofstream(path) << text;
    ReportOptions options;
    options.reference = path;
    return report_html(pendulum(), options);
  };
  const auto message = [&](const std::string& text) -> std::string {
    try {
      page_of(text);
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  };
  const std::string title = fmt::format("# Reference motion of the scene {}: by another way\n", pendulum().name());
  EXPECT_TRUE(contains(page_of(title + "# a comment\ntime,theta,theta'\n1,0.125000000000000000000000000000000000001,-2e-3\n"),
                       R"({"names":["time","theta","theta'"],"rows":[[1.0,0.125,-0.002]]})"));
  EXPECT_TRUE(contains(message(title + "time,phi\n1,2\n"), "has no column 'theta': it is of another scene than"));
  EXPECT_TRUE(contains(message("time,theta\n1,2,3\n"), ":2: 3 numbers for 2 columns"));
  EXPECT_TRUE(contains(message("time,theta\n1,abc\n"), ":2: 'abc' is no number"));
  EXPECT_TRUE(contains(message("time,theta\n1,nan\n"), ":2: 'nan' is no number"));
  EXPECT_TRUE(contains(message("theta\n1\n"), "is no reference"));
  EXPECT_TRUE(contains(message("time,theta\n"), "is no reference"));
  // What simulate writes is no second derivation, nor is the reference of another pendulum.
  EXPECT_TRUE(contains(message("time,theta\n1,0.1\n"), "does not say that it is of"));
  EXPECT_TRUE(contains(message("# Reference motion of the scene another: by another way\ntime,theta\n1,0.1\n"), "does not say that it is of"));
  std::ofstream(path) << "# Reference motion of the scene dropped: by another way\ntime,z\n1,0.1\n";
  ReportOptions options;
  options.reference = path;
  EXPECT_THROW(report_html(dropped(), options), UsageError);
}

// The page has no samples to show: it says why.
TEST(Report, SaysWhyAMotionWithContactsCannotStart) {
  Scene scene("sunk", "");
  const Expression z = scene.coordinate("z", "m");
  const FrameHandle ball = scene.prismatic("ball", scene.ground(), axis::z, z);
  scene.body("ball", ball, Inertia::point(Expression::quantity("2", "kg")));
  scene.stop(z, Expression::quantity("1", "m"), std::nullopt, {});
  const std::string page = own_text(report_html(scene, {}));
  EXPECT_TRUE(contains(page, "There is no motion: a contact starts below its surface"));
  EXPECT_FALSE(contains(page, "<script id=\"recording\""));
}

TEST(Report, RefusesAStateOfOtherNames) {
  EXPECT_EQ(run(pendulum, {"report", "--about", "thetta=1"}).code, 2);
  EXPECT_EQ(run(pendulum, {"report", "--about", "theta=1"}).code, 0);
  // A steady motion to linearise about is no rest: that section of the page says so.
  const auto steady = run(pendulum, {"report", "--about", "theta'=1"});
  EXPECT_EQ(steady.code, 0);
  EXPECT_NE(steady.out.find("at a rest every rate is zero"), std::string::npos);
}

TEST(Report, RefusesALengthThatIsNoTime) {
  for (const char* to : {"nan", "inf", "0", "-1"}) {
    EXPECT_EQ(run(pendulum, {"report", "--to", to}).code, 2) << to;
  }
}

TEST(Report, SaysWhyAMotionWithContactsIsMissing) {
  Scene scene = dropped();
  scene.parameter("W", "N");
  const std::string page = report_html(scene, {});
  EXPECT_TRUE(contains(page, "There is no motion: the parameter &#39;W&#39; has no value, and a page that plays a motion back needs one: give it in the scene."))
      << page.substr(page.find("There is no motion"), 200);
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
