// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/records/table.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/runtime/temporary_folder.hpp"

namespace table_test {
namespace {

using namespace torsor::runtime;

TEST(Table, AlignsTextLeftAndNumbersRightCountingCharacters) {
  Table table({"method", "error", "time"});
  table.add({"Nørsett", scientific(1.25e-9), "12 µs"});
  table.add({"Runge-Kutta 4", scientific(0.5, 1), "3 µs"});
  std::ostringstream text;
  text << table;
  EXPECT_EQ(text.str(),
            "method            error   time\n"
            "------------------------------\n"
            "Nørsett        1.25e-09  12 µs\n"
            "Runge-Kutta 4   5.0e-01   3 µs\n");
}

TEST(Table, RefusesARowOfAnotherLength) {
  Table table({"a", "b"});
  const std::string error = error_of<std::invalid_argument>([&] { table.add({"1"}); });
  EXPECT_TRUE(mentions(error, {"1 cells for 2 columns"}));
}

class TableFile : public TemporaryFolder {};

TEST_F(TableFile, IsAlsoWrittenAsCommaSeparatedValues) {
  Table table({"steps", "error"});
  table.add({"100", "1e-3"});
  table.write_csv(folder / "table.csv");
  EXPECT_EQ(contents(folder / "table.csv"), "steps,error\n100,1e-3\n");
}

TEST_F(TableFile, NamesTheCellThatIsNoValue) {
  for (const std::string& bad : {std::string("2,5"), std::string("#3"), std::string("a\nb")}) {
    Table table({"steps", "error"});
    table.add({"", "1"});
    table.add({"100", bad});
    const std::string error = error_of<FileError>([&] { table.write_csv(folder / "table.csv"); });
    EXPECT_TRUE(mentions(error, {"table.csv", bad.c_str(), "row 2", "column 'error'"})) << error;
  }
  Table table({"steps", "error"});
  table.add({"", "1"});
  table.write_csv(folder / "table.csv");
  EXPECT_EQ(contents(folder / "table.csv"), "steps,error\n,1\n");
  Table alone({"steps"});
  alone.add({""});
  EXPECT_TRUE(mentions(error_of<FileError>([&] { alone.write_csv(folder / "table.csv"); }), {"row 1", "'steps'"}));
  Table names({"a,b"});
  EXPECT_TRUE(mentions(error_of<FileError>([&] { names.write_csv(folder / "table.csv"); }), {"the column name 'a,b'"}));
}

TEST(Table, WritesAsManyDigitsAsAreAskedFor) {
  EXPECT_EQ(scientific(0.5, 300), "5." + std::string(300, '0') + "e-01");
  EXPECT_EQ(scientific(-1.0, 0), "-1e+00");
}

}  // namespace
}  // namespace table_test
