// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/provenance.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/shell_word.hpp"
#include "torsor/generator/emission/cpp_names.hpp"
#include "torsor/generator/listing/schedule.hpp"

namespace torsor {
namespace {

template <class List, class Name>
std::string joined(const List& list, const std::string& separator, const Name& name) {
  std::string text;
  for (const auto& entry : list) text += (text.empty() ? "" : separator) + name(entry);
  return text.empty() ? "none" : text;
}

std::string operations_table(const Provenance& provenance) {
  std::size_t width = 8;
  for (const FunctionOperations& function : provenance.operations) width = std::max(width, function.name.size());
  std::string text =
      fmt::format("  {:<{}}  {:>9}  {:>15}  {:>9}  {:>12}  {:>17}  {:>6}  {:>5}  {:>6}\n", "function", width, "additions",
                  "multiplications", "divisions", "square roots", "sine-cosine pairs", "others", "total", "before");
  for (const auto& [name, each, before] : provenance.operations) {
    text += fmt::format("  {:<{}}  {:>9}  {:>15}  {:>9}  {:>12}  {:>17}  {:>6}  {:>5}  {:>6}\n", name, width,
                        each.additions, each.multiplications, each.divisions, each.square_roots, each.sincos_pairs,
                        each.others, each.total(), before ? std::to_string(*before) : "-");
  }
  return text;
}

/// What the mechanism made unnecessary, kernel by kernel.
std::string skipped(const Provenance& provenance) {
  std::string text;
  for (const AskedKernel& kernel : provenance.kernels) {
    if (!kernel.skipped.empty()) {
      text += fmt::format("  {}: left out, {}\n", kernel.name, kernel.skipped);
      continue;
    }
    const auto [zeros, repeated] = std::pair(kernel.zeros, kernel.repeated);
    if (zeros == 0 && repeated == 0) continue;
    std::string what;
    if (zeros > 0) what = fmt::format("{} vanish identically", zeros);
    if (repeated > 0) what += fmt::format("{}{} repeat another up to sign", what.empty() ? "" : ", ", repeated);
    text += fmt::format("  {}: of {} results {}\n", kernel.name, kernel.results, what);
  }
  return text.empty() ? "  nothing\n" : text;
}

}  // namespace

std::string regeneration_command(const Provenance& provenance) {
  const std::string& scene = provenance.scene->name();
  std::string command = fmt::format("{} --kernels {}", provenance.scene->command_line("generate"),
                                    joined(provenance.kernels, ",", [](const AskedKernel& kernel) { return kernel.name; }));
  if (provenance.options.all_run_time || provenance.options.symbolic_parameters) {
    command += " --run-time all";
  } else if (!provenance.options.run_time.empty()) {
    command += " --run-time " + joined(provenance.options.run_time, ",", [](const std::string& name) { return name; });
  }
  if (provenance.options.forward == ForwardMethod::factorisation) command += " --forward factorisation";
  if (provenance.options.forward == ForwardMethod::articulated_body) command += " --forward articulated_body";
  if (provenance.options.forward == ForwardMethod::sums_of_squares) command += " --forward sums_of_squares";
  std::string without;
  for (const Pass& pass : all_passes()) {
    if (!(provenance.options.passes.*(pass.on))) without += (without.empty() ? " --without " : ",") + std::string(pass.name);
  }
  command += without;
  if (!provenance.language.empty()) command += " --language " + provenance.language;
  if (!provenance.support.empty()) command += " --support " + shell_word(provenance.support);
  if (!provenance.source.empty()) command += " --source " + shell_word(provenance.source);
  return command + fmt::format(" --output {}.{}", scene, provenance.extension);
}

std::string provenance_comment(const Provenance& provenance) {
  const SceneContent& scene = provenance.scene->content();
  const std::string& file = scene.origin.file;
  std::string text = fmt::format("{}{}\nMade by torsor {}{}; change {} and write the file again, do not edit it.\n",
                                 scene.name, scene.title.empty() ? "" : ": " + scene.title, TORSOR_VERSION,
                                 file.empty() ? "" : " from " + file, file.empty() ? "the scene" : "that");
  text += "Free to embed, and nothing is asked for it: MIT-0.\n\n";
  std::vector<std::string> present;
  for (const AskedKernel& kernel : provenance.kernels) {
    if (kernel.skipped.empty()) present.push_back(kernel.name);
  }
  const auto itself = [](const std::string& name) { return name; };
  text += "Kernels: " + joined(present, ", ", itself) + "\n";
  text += "Parameters set at run time: " +
          joined(provenance.parameters, ", ", [](const SymbolPointer& symbol) { return symbol->name; }) + "\n\n";
  text += "Operations in the text of each function (a sine-cosine pair counts 2 in the total; not in it is what a Status\n";
  text += "costs, one multiplication for each result and for each pivot tested); before: without products that sums\n";
  text += "share, factoring, and what is done once for a set of parameters:\n";
  text += operations_table(provenance) + "\n";
  text += "Not computed because this mechanism does not need it:\n" + skipped(provenance) + "\n";
  for (const std::string& note : scene.origin.notes) text += note + "\n";
  if (!scene.origin.notes.empty()) text += "\n";
  if (!provenance.frames.empty()) text += provenance.frames + "\n";
  if (!provenance.notes.empty()) {
    text += "Constraints:\n";
    for (const std::string& note : provenance.notes) text += "  " + note + "\n";
    text += "\n";
  }
  text += "To write this file again:\n  " + regeneration_command(provenance) + "\n";

  std::string comment;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    const std::string line = comment_text(text.substr(begin, end - begin));
    comment += line.empty() ? "//\n" : "// " + line + "\n";
    begin = end + 1;
  }
  return comment;
}

}  // namespace torsor
