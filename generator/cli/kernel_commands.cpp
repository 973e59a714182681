// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "generator/cli/command_set.hpp"
#include "generator/cli/command_texts.hpp"
#include "generator/cli/kernel_options.hpp"
#include "generator/dynamics/equations/massless.hpp"
#include "generator/emission/c_header.hpp"
#include "generator/emission/header.hpp"
#include "generator/emission/javascript_module.hpp"
#include "generator/emission/kernel.hpp"
#include "generator/expression/error.hpp"

namespace torsor {
namespace {

struct KernelRequest : KernelOptions {
  StateOptions states;
  bool json = false;
  std::string language = "c++";
};

CommandResult generate(const Scene& scene, const KernelRequest& request) {
  const MechanismListing mechanism = lower_mechanism(scene, request.names(), request.model(scene));
  CommandResult result;
  std::vector<std::string> unsolved;
  for (const AskedKernel& kernel : mechanism.asked) {
    if (kernel.skipped.empty()) continue;
    if (solves_with_mass_matrix(kernel.name) && !mechanism.equations->massless().empty()) {
      if (request.kernels != "all") throw SceneError(fmt::format("there is no kernel {}: {}", kernel.name, kernel.skipped));
      unsolved.push_back(kernel.name);
      continue;
    }
    if (request.kernels == "all") continue;  // all that there are: what is absent was not asked for
    result.notes.push_back(fmt::format("the kernel {} is absent: {}", kernel.name, kernel.skipped));
  }
  if (!unsolved.empty()) {
    result.notes.push_back(
        fmt::format("the kernels {} are absent: {}", fmt::join(unsolved, ", "), lack_of_mass(*mechanism.equations)));
  }
  result.text = request.language == "javascript" ? emit_javascript(mechanism)
                : request.language == "c99"      ? emit_c(mechanism)
                                                 : emit_header(mechanism);
  return result;
}

CommandResult counts(const Scene& scene, const KernelRequest& request) {
  const SceneCounts counted = count_scene(scene, request.names(), request.model(scene));
  return {request.json ? counts_json({counted}) : counts_table({counted})};
}

CommandResult passes(const Scene& scene, const KernelRequest& request) {
  const StateOptions& states = request.states;
  const PassReport report =
      report_passes(scene, request.names(), request.model(scene), {states.digits, states.states, states.seed});
  return {request.json ? passes_json(report) : passes_table(report), report.equal()};
}

}  // namespace

void add_kernel_commands(CommandSet& commands) {
  const auto request = std::make_shared<KernelRequest>();
  CLI::App& generating = commands.add("generate", "write the specialised header, or module",
                                      [request](const Scene& scene) { return generate(scene, *request); });
  add_kernel_options(generating, *request);
  generating.add_option("--language", request->language, "c++ (a header), c99 (a header) or javascript (an ES module)")
      ->capture_default_str()
      ->check(CLI::IsMember({"c++", "c99", "javascript"}));
  generating.get_option("--output")->required()->description("file to write; - for the standard output");

  CLI::App& counting = commands.add("counts", "count the operations of the emitted kernels, tests of their Status left out",
                                    [request](const Scene& scene) { return counts(scene, *request); });
  add_kernel_options(counting, *request);
  counting.add_flag("--json", request->json, "print JSON");

  CLI::App& comparing =
      commands.add("passes", "tell what each pass saves, that it changes no result, and what it does to errors",
                   [request](const Scene& scene) { return passes(scene, *request); });
  add_kernel_options(comparing, *request);
  add_state_options(comparing, request->states);
  comparing.add_flag("--json", request->json, "print JSON");
}

}  // namespace torsor
