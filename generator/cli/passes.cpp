// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/cli/command_texts.hpp"

namespace torsor {
namespace {

nlohmann::ordered_json to_json(const PassEffect& effect) {
  return {{"operations", effect.operations},
          {"cycles", effect.cycles},
          {"difference", effect.difference},
          {"error", effect.error}};
}

}  // namespace

std::string passes_table(const PassReport& report) {
  std::string head = fmt::format("{:<37}{:>12}", "", "all passes");
  for (const std::string& pass : report.passes) head += fmt::format("{:>13}", pass);
  std::string text;
  const auto add = [&](const std::string& title, const auto& with_all, const auto& without) {
    text += fmt::format("{}\n{}\n", title, head);
    for (const KernelPasses& kernel : report.kernels) {
      text += fmt::format("{:<37}{:>12}", kernel.kernel, with_all(kernel.all));
      for (const PassEffect& effect : kernel.without) text += fmt::format("{:>13}", without(effect, kernel.all));
      text += "\n";
    }
  };
  add(report.scene + ": operations with all passes, and how many more without each",
      [](const PassEffect& all) { return fmt::format("{}", all.operations); },
      [](const PassEffect& effect, const PassEffect& all) { return fmt::format("{:+}", effect.operations - all.operations); });
  add("cycles from the state to the last result, waiting for nothing else, and how many more without each",
      [](const PassEffect& all) { return fmt::format("{}", all.cycles); },
      [](const PassEffect& effect, const PassEffect& all) { return fmt::format("{:+}", effect.cycles - all.cycles); });
  add("worst errors in double with all passes, and without each, in ulp scaled by max(1, condition)",
      [](const PassEffect& all) { return fmt::format("{:.2f}", all.error); },
      [](const PassEffect& effect, const PassEffect&) { return fmt::format("{:.2f}", effect.error); });
  add(fmt::format("relative difference of the results, in CLN at {} digits", report.digits),
      [](const PassEffect&) { return std::string(); },
      [](const PassEffect& effect, const PassEffect&) { return fmt::format("{:.0e}", effect.difference); });
  text += "what each pass works on, and what it does\n";
  for (const Pass& pass : all_passes()) {
    const bool reported = std::find(report.passes.begin(), report.passes.end(), pass.name) != report.passes.end();
    if (!reported) continue;
    text += fmt::format("{:<12}{:<8}  {}\n", pass.name, pass.level(), pass.effect);
    const Rule* const rule = std::get_if<Rule>(&pass.function);
    if (rule != nullptr) text += fmt::format("{:<22}a rule, not a function: {}\n", "", rule->why);
  }
  return text + (report.equal() ? "no pass changes a result\n" : "FAIL: a pass changes a result\n");
}

std::string passes_json(const PassReport& report) {
  nlohmann::ordered_json kernels = nlohmann::ordered_json::object();
  for (const KernelPasses& kernel : report.kernels) {
    nlohmann::ordered_json& entry = kernels[kernel.kernel];
    entry["all"] = to_json(kernel.all);
    for (std::size_t p = 0; p < report.passes.size(); ++p) entry["without"][report.passes[p]] = to_json(kernel.without[p]);
  }
  return nlohmann::ordered_json{{"name", report.scene}, {"equal", report.equal()}, {"kernels", kernels}}.dump(2) + "\n";
}

}  // namespace torsor
