// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "torsor/generator/listing/lowering.hpp"
#include "torsor/generator/mechanics/scene.hpp"

namespace torsor::division_count_test {
namespace {

// The example of docs/architecture.md, word by word.
int divisions(const Formula& formula) {
  int number = formula.kind == Formula::Kind::quotient ? 1 : 0;
  for (const Formula& child : formula.children) number += divisions(child);
  return number;
}

int divisions(const Listing& listing) {
  int number = 0;
  const std::vector<bool> read = read_quantities(listing, true);
  for (const Statement& each : listing.statements) {
    const auto* assigned = std::get_if<Assigned>(&each);
    if (assigned != nullptr && is_needed(each, read)) number += divisions(assigned->right);
  }
  for (const Statement& each : listing.of_pivots) {
    if (const auto* assigned = std::get_if<Assigned>(&each)) number += divisions(assigned->right);
  }
  for (const Output& output : listing.outputs) number += divisions(output.value.formula);
  if (listing.recurrence) {
    for (const Statement& each : listing.recurrence->steps) number += divisions(std::get<Assigned>(each).right);
    for (const Formula& rate : listing.recurrence->rates) number += divisions(rate);
  }
  return number;
}

TEST(DivisionCount, IsThatOfTheOperations) {
  Scene scene("divided");
  const Expression x = scene.coordinate("x", "1"), y = scene.coordinate("y", "1");
  const Layout layout{{x.as_symbol(), y.as_symbol()}, {}, {}, {}, {}, {}};
  Program program;
  const Value quotient = program.lower(x / (1 + y * y));
  const Value other = program.lower(1 / (2 + cos(x)));
  const Computation computation{{{{"r", "", 0}, quotient}, {{"r", "", 1}, other}, {{"r", "", 2}, program.lower(x * y)}}};
  const Schedule schedule = make_schedule(program, {quotient, other});
  const Listing listing = lower(program, schedule.function, computation, {&layout, &schedule, "divided"});
  EXPECT_EQ(divisions(listing), 2);
  EXPECT_EQ(divisions(listing), count(listing).divisions);
}

TEST(DivisionCount, StandsInThePage) {
  const auto text_of = [](const std::string& path) {
    std::ifstream file(std::string(TORSOR_SOURCE_DIR "/") + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  };
  const std::string source = text_of("tests/listing/division_count_test.cpp");
  const std::size_t begin = source.find("int divisions(const Formula"), end = source.find("TEST(DivisionCount, Is");
  EXPECT_NE(text_of("docs/architecture.md").find(source.substr(begin, end - begin - 1) + "```"), std::string::npos);
}

}  // namespace
}  // namespace torsor::division_count_test
