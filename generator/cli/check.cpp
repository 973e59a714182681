// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/cli/command_texts.hpp"

namespace torsor {

std::string check_table(const std::string& scene, const std::vector<CheckResult>& results) {
  std::string text = fmt::format("{}\n{:<6}{:<44}{:>12}{:>12}  {}\n", scene, "", "check", "worst", "bound", "what");
  for (const CheckResult& result : results) {
    text += fmt::format("{:<6}{:<44}{:>12.2e}{:>12.2e}  {}\n", result.passed() ? "ok" : "FAIL", result.name, result.worst,
                        result.bound, result.description);
  }
  return text;
}

std::string check_json(const std::string& scene, const std::vector<CheckResult>& results) {
  nlohmann::ordered_json checks = nlohmann::ordered_json::array();
  for (const CheckResult& result : results) {
    checks.push_back({{"name", result.name},
                      {"description", result.description},
                      // JSON has no NaN: null says that a comparison gave no number.
                      {"worst", std::isfinite(result.worst) ? nlohmann::ordered_json(result.worst) : nlohmann::ordered_json()},
                      {"bound", result.bound},
                      {"passed", result.passed()}});
  }
  const bool passed = std::all_of(results.begin(), results.end(), [](const CheckResult& r) { return r.passed(); });
  return nlohmann::ordered_json{{"name", scene}, {"passed", passed}, {"checks", checks}}.dump(2) + "\n";
}

}  // namespace torsor
