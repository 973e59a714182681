// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "torsor/generator/cli/command_texts.hpp"
#include "tests/cli/scene_runner.hpp"

namespace torsor::verify_command_test {
namespace {

using namespace testing_programs;

TEST(VerifyCommand, PrintsAGroupForEachResultAndPasses) {
  const Outcome text = run(pendulum, {"verify", "--kernels", "bias,energy", "--states", "8", "--all"});
  EXPECT_EQ(text.code, 0) << text.out;
  for (const char* part : {"double", "float", "bias", "forces [", "result.kinetic [", "result.power ["}) {
    EXPECT_NE(text.out.find(part), std::string::npos) << part << "\n" << text.out;
  }
  for (const char* scalar : {"double", "float"}) {
    const Outcome data = run(
        pendulum, {"verify", "--kernels", "energy", "--states", "8", "--climbs", "0", "--scalar", scalar, "--json"});
    EXPECT_EQ(data.code, 0);
    const nlohmann::json verified = nlohmann::json::parse(data.out);
    EXPECT_EQ(verified.at("passed"), true);
    for (const nlohmann::json& group : verified.at("groups")) {
      EXPECT_EQ(group.at("scalar"), scalar);
      EXPECT_EQ(group.at("searched"), false);
      EXPECT_LE(group.at("error").get<double>(), group.at("bound").get<double>());
      EXPECT_NE(group.at("state").get<std::string>().find("theta"), std::string::npos);
    }
  }
}

// A group without a number is the worst, wherever it stands among the others.
TEST(VerifyCommand, NamesAGroupThatIsNoNumberAsTheWorst) {
  std::vector<VerifyRow> rows;
  for (const double scaled : {1.0, std::nan(""), 7.0}) {
    rows.emplace_back();
    rows.back().kernel = "energy";
    rows.back().group = "group_" + std::to_string(rows.size());
    rows.back().scalar = "double";
    rows.back().worst.counted = true;
    rows.back().worst.scaled = scaled;
    rows.back().limit = 0.5;  // none passes
  }
  EXPECT_NE(verify_markdown("scene", rows).find("| energy group_2 |"), std::string::npos);
  EXPECT_NE(verify_table("scene", rows, {}).find("group_2"), std::string::npos);
  EXPECT_EQ(verify_table("scene", rows, {}).find("group_3"), std::string::npos);
}

// inf/inf was printed as -nan.
TEST(VerifyCommand, SaysWhereThereIsNoBound) {
  std::vector<VerifyRow> rows(1);
  rows[0].kernel = "energy";
  rows[0].group = "group";
  rows[0].scalar = "double";
  rows[0].worst.counted = true;
  rows[0].worst.scaled = rows[0].worst.error = rows[0].worst.bound = HUGE_VAL;
  EXPECT_NE(verify_markdown("scene", rows).find("| energy group | >1e17 | none |"), std::string::npos);
  EXPECT_EQ(verify_table("scene", rows, {}).find("nan"), std::string::npos);
  rows[0].worst.bound = 4;
  rows[0].worst.error = rows[0].worst.scaled = 1;
  EXPECT_NE(verify_markdown("scene", rows).find("| energy group | 1.00 | 0.250 |"), std::string::npos);
}

TEST(VerifyCommand, RefusesWhatItCannotDo) {
  EXPECT_EQ(run(pendulum, {"verify", "--scalar", "quad"}).code, 2);
  EXPECT_EQ(run(pendulum, {"verify", "--kernels", "no_such_kernel"}).code, 2);
  const Outcome missing = run(pendulum, {"verify", "--exceptions", "/no/such/file"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_NE(missing.err.find("/no/such/file"), std::string::npos) << missing.err;
}

TEST(VerifyCommand, FailsWhereAnExceptionIsNotNeededAndNamesIt) {
  const std::filesystem::path list = std::filesystem::path(::testing::TempDir()) / "needless_exceptions.txt";
  std::ofstream(list) << "pendulum | bias | * | double | 9 | none\n";
  std::vector<std::string> command{"verify", "--kernels", "bias", "--states", "4", "--exceptions", list.string()};
  EXPECT_EQ(run(pendulum, command).code, 0);
  command.push_back("--every-exception-needed");
  const Outcome found = run(pendulum, command);
  EXPECT_EQ(found.code, 1);
  EXPECT_NE(found.err.find("'pendulum | bias | * | double' is not needed"), std::string::npos) << found.err;
  EXPECT_EQ(run(pendulum, {"verify", "--every-exception-needed"}).code, 2);
}

}  // namespace
}  // namespace torsor::verify_command_test
