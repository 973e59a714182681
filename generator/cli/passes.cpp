// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "generator/cli/command_texts.hpp"

namespace torsor {
namespace {

nlohmann::ordered_json to_json(const PassEffect& effect) {
  return {{"operations", effect.operations}, {"cycles", effect.cycles}, {"difference", effect.difference}, {"error", effect.error}};
}

}  // namespace

std::string passes_table(const PassReport& report) {
  std::string head = fmt::format("{:<37}{:>12}", "", "all passes");
  for (const std::string& pass : report.passes) head += fmt::format("{:>13}", pass);
  std::string text = fmt::format("{}: operations with all passes, and how many more without each\n{}\n", report.scene, head);
  for (const KernelPasses& kernel : report.kernels) {
    text += fmt::format("{:<37}{:>12}", kernel.kernel, kernel.all.operations);
    for (const PassEffect& effect : kernel.without) text += fmt::format("{:>+13}", effect.operations - kernel.all.operations);
    text += "\n";
  }
  text += fmt::format("cycles from the state to the last result, waiting for nothing else, and how many more without each\n{}\n", head);
  for (const KernelPasses& kernel : report.kernels) {
    text += fmt::format("{:<37}{:>12}", kernel.kernel, kernel.all.cycles);
    for (const PassEffect& effect : kernel.without) text += fmt::format("{:>+13}", effect.cycles - kernel.all.cycles);
    text += "\n";
  }
  text += fmt::format("worst errors in double with all passes, and without each, in ulp scaled by max(1, condition)\n{}\n", head);
  for (const KernelPasses& kernel : report.kernels) {
    text += fmt::format("{:<37}{:>12.2f}", kernel.kernel, kernel.all.error);
    for (const PassEffect& effect : kernel.without) text += fmt::format("{:>13.2f}", effect.error);
    text += "\n";
  }
  text += fmt::format("relative difference of the results, in CLN at {} digits\n{}\n", report.digits, head);
  for (const KernelPasses& kernel : report.kernels) {
    text += fmt::format("{:<37}{:>12}", kernel.kernel, "");
    for (const PassEffect& effect : kernel.without) text += fmt::format("{:>13.0e}", effect.difference);
    text += "\n";
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
