// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/pass_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/kernels/kernel.hpp"
#include "torsor/generator/program/formula.hpp"
#include "tests/dynamics/random_mechanism.hpp"
#include "tests/long_tests.hpp"

namespace torsor::pass_report_test {
namespace {

using testing_mechanisms::random_mechanism;

int operations(const Equations& equations) {
  return count(equations.program(), make_kernel("inverse_dynamics", equations).values()).total();
}

const PassEffect& without(const KernelPasses& kernel, bool Passes::*pass) {
  const auto& names = all_passes();
  const auto place = std::find_if(names.begin(), names.end(), [pass](const Pass& each) { return each.on == pass; });
  return kernel.without.at(static_cast<std::size_t>(place - names.begin()));
}

TEST(Passes, LeavesOutThoseOfAList) {
  const Passes passes = passes_without("factoring,length_unit");
  EXPECT_FALSE(passes.factoring);
  EXPECT_FALSE(passes.length_unit);
  EXPECT_TRUE(passes.sharing);
  EXPECT_TRUE(passes_without("").factoring);
}

// On the page that tells where each stands, and on the one that tells what each saves.
TEST(Passes, AreAllInTheManual) {
  for (const char* page : {"/docs/architecture.md", "/docs/kernels.md"}) {
    std::ifstream file(std::string(TORSOR_SOURCE_DIR) + page);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (const Pass& pass : all_passes()) {
      const std::string name = pass.name;
      EXPECT_TRUE(text.find("`" + name + "`") != std::string::npos || text.find("**" + name + "**") != std::string::npos)
          << name << " is not on " << page;
    }
  }
}

TEST(Passes, RefusesAnUnknownOneAndListsTheKnownOnes) {
  try {
    passes_without("sharing,magic");
    FAIL() << "no error";
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("'magic'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("off_axis"), std::string::npos) << error.what();
  }
}

// cos(b) (p + q) with p + q known twice: sharing saves an addition, factoring a multiplication.
TEST(Passes, OfAProgramSaveWhatTheySay) {
  const auto total = [](const Passes& passes) {
    Program program({}, passes);
    const auto symbol = [](const char* name, int index) {
      return std::make_shared<const Symbol>(Symbol{name, Unit(), SymbolKind::coordinate, index, {}});
    };
    const Value p = program.symbol(symbol("p", 0)), q = program.symbol(symbol("q", 1)), r = program.symbol(symbol("r", 2));
    const Value first = program.bind(p + q), second = program.bind(p + q);
    return count(program, {first * r, second * q, p * r + q * r}).total();
  };
  Passes passes;
  const int all = total(passes);
  passes.sharing = false;
  EXPECT_EQ(total(passes), all + 1);
  passes.sharing = true;
  passes.factoring = false;
  EXPECT_EQ(total(passes), all + 1);
}

TEST(PassReport, FindsThatNoPassChangesAResultOfRandomMechanisms) {
  for (unsigned seed = 900; seed < wanted(902U, 906U); ++seed) {
    const Scene scene = random_mechanism(seed);
    const PassReport report = report_passes(scene, {"mass_matrix", "inverse_dynamics", "energy"}, {}, {.states = 2});
    ASSERT_EQ(report.passes.size(), all_passes().size());
    EXPECT_TRUE(report.equal()) << "seed " << seed;
    for (const KernelPasses& kernel : report.kernels) {
      // Factoring, sharing and common products never cost anything; what moves inertia may, for one kernel.
      for (bool Passes::*pass : {&Passes::sharing, &Passes::factoring, &Passes::products})
        EXPECT_GE(without(kernel, pass).operations, kernel.all.operations) << kernel.kernel << " of seed " << seed;
    }
  }
}

TEST(PassReport, TellsResultsThatDiffer) {
  PassReport report{"scene", {"sharing"}, {{"energy", {}, {{1, 1, 1e-40, 0}}}}, 50};
  EXPECT_TRUE(report.equal());
  report.kernels[0].without[0].difference = 1e-30;
  EXPECT_FALSE(report.equal());
}

TEST(PassReport, ComparesAllStatesThatAreAskedFor) {
  const Scene scene = random_mechanism(910);
  const auto differences = [&scene](int states, std::uint64_t seed) {
    const PassReport report =
        report_passes(scene, {"mass_matrix"}, {}, {.digits = 20, .states = states, .seed = seed});
    std::vector<double> found;
    for (const PassEffect& effect : report.kernels[0].without) found.push_back(effect.difference);
    return found;
  };
  // Of roundings, that are others at each state.
  const std::vector<double> first = differences(1, 1), second = differences(1, 2), both = differences(2, 1);
  EXPECT_NE(first, second);
  for (std::size_t i = 0; i < both.size(); ++i) EXPECT_EQ(both[i], std::max(first[i], second[i])) << i;
}

TEST(PassReport, CountsWhatEquationsWithoutThePassCount) {
  const Scene scene = random_mechanism(910);
  const PassReport report = report_passes(scene, {"inverse_dynamics"}, {}, {.states = 1});
  ModelOptions options;
  EXPECT_EQ(report.kernels[0].all.operations, operations(Equations(scene, options)));
  options.passes.regrouping = false;
  EXPECT_EQ(without(report.kernels[0], &Passes::regrouping).operations, operations(Equations(scene, options)));
}

}  // namespace
}  // namespace torsor::pass_report_test
