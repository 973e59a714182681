// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/runtime/records/reference.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "torsor/runtime/integration/integrate.hpp"
#include "torsor/runtime/integration/runge_kutta_4.hpp"
#include "tests/runtime/temporary_folder.hpp"

namespace reference_test {
namespace {

using namespace torsor::runtime;
using Two = std::array<double, 2>;

class ReferenceFile : public TemporaryFolder {
 protected:
  std::string error_for(const std::string& text) const {
    const auto path = put("bad.csv", text);
    return error_of<FileError>([&] { (void)read_reference<double>(path); });
  }
};

TEST_F(ReferenceFile, ReadsCommentsHeaderAndLongDecimals) {
  const auto path = put("true.csv",
                        "# cosine and minus sine, 50 digits\n# second comment, with a comma\n"
                        "time,x,x'\n"
                        "0,1,0\n"
                        "1, 0.54030230586813971740093660744297660373231042061792 ,"
                        "-0.84147098480789650665250232163029899962256306079837\r\n");
  const auto reference = read_reference<double>(path);
  EXPECT_EQ(reference.names, (std::vector<std::string>{"x", "x'"}));
  ASSERT_EQ(reference.rows(), 2U);
  EXPECT_EQ(reference.times, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(reference.state<2>(1), (Two{0.54030230586813971740, -0.84147098480789650665}));
}

TEST_F(ReferenceFile, RoundsOnceToFloat) {
  // Just above the middle between two floats, by less than a double can see: rounding twice would go down.
  const auto path = put("middle.csv", "time,x\n0,1.00000005960464477539062500000000000001\n");
  EXPECT_EQ(read_reference<float>(path).value(0, 0), std::nextafter(1.0F, 2.0F));
}

// The nearest float of 3.9e-48 is 0; the least one is 1.4e-45.
TEST_F(ReferenceFile, RoundsToZeroWhatIsNearerToItThanAnyNumber) {
  const auto small = read_reference<float>(
      put("small.csv", "time,a,b,c,d,e\n0,3.9e-48,-6.5E-48,0.00000000000000000000000000000000000000000000000039,1e-45,39e-49\n"));
  for (const std::size_t k : {0U, 1U, 2U, 4U}) {
    EXPECT_EQ(small.value(0, k), 0.0F) << k;
    EXPECT_EQ(std::signbit(small.value(0, k)), k == 1) << k;
  }
  EXPECT_EQ(small.value(0, 3), std::numeric_limits<float>::denorm_min());
  const std::string none(400, '0');
  const auto path = put("less.csv", "time,a,b,c\n0,1e-400,-1e-99999999999999999999,0." + none + "1\n");
  for (const std::size_t k : {0U, 1U, 2U}) EXPECT_EQ(read_reference<double>(path).value(0, k), 0.0) << k;
  const std::vector<std::string> beyond{"1e400", "-1E+99999999999999999999", "1" + none, "1" + none + ".5e-10", "0.01e500"};
  for (const std::string& huge : beyond) {
    const std::string error = error_for("time,x\n0," + huge + "\n");
    EXPECT_TRUE(mentions(error, {"line 2", huge.c_str(), "beyond the largest number"})) << error;
  }
}

TEST_F(ReferenceFile, ReadsTheReferencesOfExamplesAsFloats) {
  const std::filesystem::path folder_of_examples = std::filesystem::path(__FILE__).parent_path() / "../../generated";
  for (const char* name : {"sprung_absorber", "disk_in_a_circle", "falling_plate"}) {
    EXPECT_GT(read_reference<float>(folder_of_examples / (std::string(name) + ".reference.csv")).rows(), 0U) << name;
  }
}

TEST_F(ReferenceFile, ComparesTheLargestErrorOfEachColumn) {
  const auto path = put("true.csv", "time,x,x'\n0,1,0\n1,2,4\n2,3,9\n");
  const auto reference = read_reference<double>(path);
  ReferenceErrors<double, 2> errors(reference);
  EXPECT_EQ(errors.largest(), std::numeric_limits<double>::infinity()) << "nothing compared is no success";
  errors(0.0, Two{1.0, 0.0});
  EXPECT_EQ(errors.largest(), 0.0);
  errors(1.0, Two{2.5, 4.0});
  errors(2.0, Two{3.25, 8.0});
  EXPECT_EQ(errors.column(0), 0.5);
  EXPECT_EQ(errors.column(1), 1.0);
  EXPECT_EQ(errors.largest(), 1.0);
  EXPECT_EQ(errors.compared(), 3U);
}

TEST_F(ReferenceFile, CountsAnUnknownTimeOrAMissingNumberAsInfinitelyWrong) {
  const auto reference = read_reference<double>(put("true.csv", "time,x,x'\n0,1,0\n"));
  ReferenceErrors<double, 2> unknown_time(reference);
  unknown_time(0.5, Two{1.0, 0.0});
  EXPECT_TRUE(std::isinf(unknown_time.largest()));
  // Between two rows too, be the state that of the next one.
  const auto rows = read_reference<double>(put("rows.csv", "time,x,x'\n0,1,0\n1,2,0\n"));
  ReferenceErrors<double, 2> between(rows);
  between(0.5, Two{2.0, 0.0});
  EXPECT_TRUE(std::isinf(between.largest()));
  ReferenceErrors<double, 2> not_a_number(reference);
  not_a_number(0.0, Two{1.0, std::numeric_limits<double>::quiet_NaN()});
  EXPECT_TRUE(std::isinf(not_a_number.column(1)));
  EXPECT_EQ(not_a_number.column(0), 0.0);
}

TEST_F(ReferenceFile, IsMetByAnIntegrationThroughItsTimes) {
  const auto reference = read_reference<double>(
      put("true.csv",
          "time,x,x'\n0,1,0\n1,0.54030230586813971740093660744297660373,-0.84147098480789650665250232163029899962\n"));
  const auto oscillator = [](double, const Two& y, Two& dydt) noexcept {
    dydt = {y[1], -y[0]};
    return Evaluation::ok;
  };
  ReferenceErrors<double, 2> errors(reference);
  Two y = reference.state<2>(0);
  ASSERT_TRUE(integrate_through(oscillator, y, 0.0, reference.times, RungeKutta4{.step = 1e-3}, errors));
  EXPECT_EQ(errors.compared(), 2U);
  EXPECT_LT(errors.largest(), 1e-13);  // h^4/120 = 8e-15, and 1,000 roundings as a random walk, 4e-15
}

TEST_F(ReferenceFile, RefusesAStateOfAnotherSize) {
  const auto reference = read_reference<double>(put("true.csv", "time,x,x'\n0,1,0\n"));
  const std::string error = error_of<FileError>([&] { ReferenceErrors<double, 4> errors(reference); });
  EXPECT_TRUE(mentions(error, {"true.csv", "2 columns", "not the 4", "make the reference again"}));
}

TEST_F(ReferenceFile, NamesFileLineValueAndRemedy) {
  EXPECT_TRUE(
      mentions(error_for("# c\ntime,x\n0,1\n1,one\n"), {"bad.csv", "line 4", "'one'", "'x'", "write a decimal"}));
  EXPECT_TRUE(mentions(error_for("time,x\n0,1.5x\n"), {"line 2", "'1.5x'"}));
  EXPECT_TRUE(mentions(error_for("time,x\n0,nan\n"), {"line 2", "'nan'", "not a finite number"}));
  EXPECT_TRUE(mentions(error_for("time,x\n0,1e999\n"), {"line 2", "'1e999'"}));
  EXPECT_TRUE(mentions(error_for("time,x\n0,\n"), {"line 2", "''"}));
  EXPECT_TRUE(mentions(error_for("time,x\n0,1,2\n"), {"line 2", "3 values for 2 columns"}));
  EXPECT_TRUE(mentions(error_for("time,x\n1,1\n1,2\n"), {"line 3", "time 1", "sort the rows"}));
  EXPECT_TRUE(mentions(error_for("t,x\n0,1\n"), {"line 1", "'t'", "begin with 'time'"}));
  EXPECT_TRUE(mentions(error_for("time,x,x\n0,1,1\n"), {"line 1", "'x' occurs twice"}));
  EXPECT_TRUE(mentions(error_for("time,x,\n0,1,1\n"), {"line 1", "column 3 has no name"}));
  EXPECT_TRUE(mentions(error_for("time\n0\n"), {"line 1", "no column after 'time'"}));
  EXPECT_TRUE(mentions(error_for("time,x\n"), {"no row after the header"}));
  EXPECT_TRUE(mentions(error_for("# only\n"), {"no header line"}));
  EXPECT_TRUE(mentions(error_for(""), {"no header line"}));
}

TEST_F(ReferenceFile, NamesAFileThatIsMissing) {
  const std::string error = error_of<FileError>([&] { (void)read_reference<double>(folder / "none.csv"); });
  EXPECT_TRUE(mentions(error, {"none.csv", "No such file or directory", "check the path"}));
  const std::string is_folder = error_of<FileError>([&] { (void)read_reference<double>(folder); });
  EXPECT_TRUE(mentions(is_folder, {"Is a directory"}));
}

}  // namespace
}  // namespace reference_test
