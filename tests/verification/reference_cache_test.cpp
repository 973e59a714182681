// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/verification/reference_cache.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/scenes/sliding.hpp"

namespace torsor::reference_cache_test {
namespace {

using namespace testing_mechanisms;

/// A block on a spring of that stiffness, starting half a metre from rest.
Scene block(const char* stiffness, const char* start) {
  return block_on_a_spring({.mass = kilograms("2"), .stiffness = quantity(stiffness, "N/m"), .rest = metres("1"),
                            .start = metres(start)});
}

std::string read(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ReferenceDigest, ChangesWithEveryPartOfTheQuestionOnly) {
  const ReferenceOptions options{20, {"1", "2"}};
  const std::uint64_t digest = reference_digest(block("4", "1.5"), options);
  EXPECT_EQ(digest, reference_digest(block("4", "1.5"), options));
  EXPECT_EQ(digest, reference_digest(block("4.0", "1.50"), options));
  EXPECT_NE(digest, reference_digest(block("4.000001", "1.5"), options));
  EXPECT_NE(digest, reference_digest(block("4", "1.500001"), options));
  EXPECT_NE(digest, reference_digest(block("4", "1.5"), {21, {"1", "2"}}));
  EXPECT_NE(digest, reference_digest(block("4", "1.5"), {20, {"1", "2.5"}}));
  EXPECT_NE(digest, reference_digest(block("4", "1.5"), {20, {"12"}}));
}

// A parameter that is set at run time stays a symbol in the equations: its value is part of the question all the same.
TEST(ReferenceDigest, ChangesWithTheValueOfARunTimeParameter) {
  const auto block_of = [](const char* mass) {
    Scene scene("block");
    const Expression x = scene.coordinate("x", "m");
    const Expression m = scene.run_time_parameter("m", "kg", kilograms(mass));
    scene.body("block", scene.prismatic("slide", scene.ground(), axis::x, x), Inertia::point(m));
    scene.spring("spring", x, Expression::quantity("4", "N/m"), metres("1"));
    return scene;
  };
  const ReferenceOptions options{20, {"1"}};
  EXPECT_EQ(reference_digest(block_of("2"), options), reference_digest(block_of("2.0"), options));
  EXPECT_NE(reference_digest(block_of("2"), options), reference_digest(block_of("2.000001"), options));
}

TEST(ReferenceCache, KeepsWhatWasIntegratedAndDistrustsWhatWasChanged) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "torsor_reference_cache";
  std::filesystem::remove_all(folder);
  const ReferenceOptions options{20, {"1"}};
  const std::string text = reference_csv(block("4", "1.5"), options);
  const auto cached = [&](const char* stiffness) {
    return integrate_cached_reference(block(stiffness, "1.5"), options, folder.string()).text;
  };
  EXPECT_EQ(cached("4"), text);
  ASSERT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
  const std::filesystem::path file = std::filesystem::directory_iterator(folder)->path();
  const std::string kept = read(file);
  EXPECT_TRUE(kept.starts_with(text));

  EXPECT_EQ(cached("4"), text);
  for (const std::string& damaged : {kept.substr(0, kept.size() / 2), "x" + kept}) {
    std::ofstream(file) << damaged;
    EXPECT_EQ(cached("4"), text);
    EXPECT_EQ(read(file), kept);
  }
  // It is the file that answers: one that is whole but of another question would be believed.
  const std::string other = cached("5");
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto replaced = std::filesystem::copy_options::overwrite_existing;
    if (entry.path() != file) std::filesystem::copy_file(entry.path(), file, replaced);
  }
  EXPECT_NE(other, text);
  EXPECT_EQ(cached("4"), other);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace torsor::reference_cache_test
