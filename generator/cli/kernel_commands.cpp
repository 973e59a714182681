// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/cli/command_set.hpp"
#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/cli/kernel_options.hpp"
#include "torsor/generator/dynamics/equations/massless.hpp"
#include "torsor/generator/emission/c_header.hpp"
#include "torsor/generator/emission/header.hpp"
#include "torsor/generator/emission/javascript_module.hpp"
#include "torsor/generator/emission/support.hpp"
#include "torsor/generator/kernels/kernel.hpp"

namespace torsor {
namespace {

struct KernelRequest : KernelOptions {
  StateOptions states;
  bool json = false;
  std::string language = "c++";
  std::string support, source;
};

/// How a file includes another one that is written with it: by the way from its folder, or from the current one where it
/// goes to the standard output.
std::string included_from(const std::string& output, const std::string& file) {
  namespace fs = std::filesystem;
  const fs::path folder = output == "-" ? fs::current_path() : fs::absolute(output).parent_path();
  return fs::absolute(file).lexically_normal().lexically_relative(folder.lexically_normal()).generic_string();
}

void check_options(const KernelRequest& request, const std::string& output) {
  if (!request.support.empty() && request.language == "javascript") {
    throw UsageError("--support is for --language c++ and c99: a module of JavaScript has its own support");
  }
  if (!request.source.empty() && request.language != "c99") {
    throw UsageError("--source is for --language c99: nothing else is written as a header and a source file");
  }
  for (const auto& [option, file] : {std::pair("--support", request.support), std::pair("--source", request.source)}) {
    if (!request.source.empty() && output == "-") {
      throw UsageError("--source needs a header that it can include: give --output a file");
    }
    if (file == "-") throw UsageError(fmt::format("{} takes a file: the standard output is for --output", option));
    if (!file.empty() && (file == output || (option == std::string("--source") && file == request.support))) {
      throw UsageError(fmt::format("{} {} is written by another option too: give it a file of its own", option, file));
    }
  }
}

/// What is said of kernels that are absent. Throws where one that was named would need the inverse of a singular mass matrix.
std::vector<std::string> absence_notes(const MechanismListing& mechanism, const KernelOptions& request) {
  std::vector<std::string> notes, unsolved;
  // Those that `all` brings: what is absent was not asked for.
  const auto by_all = [words = "," + request.kernels + ","](const std::string& kernel) {
    return words.find(",all,") != std::string::npos && words.find("," + kernel + ",") == std::string::npos;
  };
  for (const AskedKernel& kernel : mechanism.asked) {
    if (kernel.skipped.empty()) continue;
    if (solves_with_mass_matrix(kernel.name) && !mechanism.equations->massless().empty()) {
      if (!by_all(kernel.name)) throw SceneError(fmt::format("there is no kernel {}: {}", kernel.name, kernel.skipped));
      unsolved.push_back(kernel.name);
      continue;
    }
    if (by_all(kernel.name)) continue;
    notes.push_back(fmt::format("the kernel {} is absent: {}", kernel.name, kernel.skipped));
  }
  if (!unsolved.empty()) {
    notes.push_back(
        fmt::format("the kernels {} are absent: {}", fmt::join(unsolved, ", "), lack_of_mass(*mechanism.equations)));
  }
  return notes;
}

CommandResult generate(const Scene& scene, const KernelRequest& request, const std::string& output) {
  check_options(request, output);
  const MechanismListing mechanism = lower_mechanism(scene, request.names(), request.model(scene));
  CommandResult result{.text = {}, .notes = absence_notes(mechanism, request)};
  const std::string support = request.support.empty() ? "" : included_from(output, request.support);
  if (request.language == "javascript") {
    result.text = emit_javascript(mechanism);
  } else if (request.language == "c99") {
    const std::string header = request.source.empty() ? "" : included_from(request.source, output);
    CText text = emit_c(mechanism, {support, std::filesystem::path(request.source).filename().string(), header});
    result.text = std::move(text.header);
    if (!support.empty()) result.files.push_back({request.support, shared_c_support()});
    if (!header.empty()) result.files.push_back({request.source, std::move(text.source)});
  } else {
    result.text = emit_header(mechanism, support);
    if (!support.empty()) result.files.push_back({request.support, shared_support()});
  }
  return result;
}

CommandResult counts(const Scene& scene, const KernelRequest& request) {
  const MechanismListing mechanism = lower_mechanism(scene, request.names(), request.model(scene));
  const SceneCounts counted = count_mechanism(mechanism);
  return {.text = request.json ? counts_json({counted}) : counts_table({counted}), .notes = absence_notes(mechanism, request)};
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
  CLI::App& generating = commands.add("generate", "write the kernels as a C++ or C header, or as a JavaScript module",
                                      [request, &commands](const Scene& scene) {
                                        return generate(scene, *request, commands.output());
                                      });
  add_kernel_options(generating, *request);
  generating.add_option("--language", request->language, "c++ (a header), c99 (a header) or javascript (an ES module)")
      ->capture_default_str()
      ->check(CLI::IsMember({"c++", "c99", "javascript"}));
  generating.add_option("--support", request->support,
                        "also write to this file the text that all headers have in common; the header includes it");
  generating.add_option("--source", request->source,
                        "for c99: also write functions and tables to this file; the header then declares them");
  generating.get_option("--output")->required()->description("file to write; - for the standard output");

  CLI::App& counting = commands.add("counts", "count the operations of the generated kernels, without the tests of their Status",
                                    [request](const Scene& scene) { return counts(scene, *request); });
  add_kernel_options(counting, *request);
  counting.add_flag("--json", request->json, "print JSON");

  CLI::App& comparing =
      commands.add("passes", "print the operations that each pass saves, its effect on errors, and that it changes no result",
                   [request](const Scene& scene) { return passes(scene, *request); });
  add_kernel_options(comparing, *request);
  add_state_options(comparing, request->states);
  comparing.add_flag("--json", request->json, "print JSON");
}

}  // namespace torsor
