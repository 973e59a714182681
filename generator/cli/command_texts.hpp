// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/natural_language.hpp"
#include "torsor/generator/dynamics/equations/equations.hpp"
#include "torsor/generator/emission/mechanism_listing.hpp"
#include "torsor/generator/program/formula.hpp"
#include "torsor/generator/verification/check.hpp"
#include "torsor/generator/verification/pass_report.hpp"
#include "torsor/generator/verification/verify.hpp"

namespace torsor {

// What the commands of a scene program print. Each returns the text; the caller writes it.

/// Operation counts of one scene: each kernel on its own, and all asked for as one program.
struct SceneCounts {
  std::string name;
  std::vector<std::pair<std::string, OperationCount>> kernels;
  OperationCount joint;
  OperationCount precompute;  ///< once for a set of run-time parameters, all kernels together
};

/// Of the functions as they are written: those of kernels that are absent are left out.
SceneCounts count_mechanism(const MechanismListing& mechanism);
SceneCounts count_scene(const Scene& scene, const std::vector<std::string>& kernels, const ModelOptions& options);

std::string counts_table(const std::vector<SceneCounts>& scenes);
/// {"name", "kernels": {kernel: {...}}, "joint": {...}} for one scene, a list of those under "models" for several.
std::string counts_json(const std::vector<SceneCounts>& scenes);

std::string passes_table(const PassReport& report);
std::string passes_json(const PassReport& report);

std::string check_table(const std::string& scene, const std::vector<CheckResult>& results);
std::string check_json(const std::string& scene, const std::vector<CheckResult>& results);

/// How the rows of `verify` are shown: every group of results, or of each kernel the worst; the states in words.
struct VerifyLayout {
  bool every_group = false;
  bool with_states = false;
};

std::string verify_table(const std::string& scene, const std::vector<VerifyRow>& rows, const VerifyLayout& layout);
/// One row of the table in docs/accuracy.md: groups, those within the bar, those proved by balls, and for each format the
/// worst scaled error with its kernel.
std::string verify_markdown(const std::string& scene, const std::vector<VerifyRow>& rows);
std::string verify_json(const std::string& scene, const std::vector<VerifyRow>& rows);

/// What the scene contains and which kernels it offers.
std::string list_text(const Scene& scene);
/// With the shapes of what these kernels write, and the fingerprint of the header with them.
std::string list_json(const Scene& scene, const std::vector<std::string>& kernels);

/// Loops, ranks, mobility, redundancy, internal motions, indeterminate reactions and the reduced graph of the scene's
/// joints. `inputs_outputs` names the joints that count as those with the outside; empty: those of the ground.
std::string structure_text(const Scene& scene, const std::vector<std::string>& inputs_outputs, const NaturalLanguage& say = {});
std::string structure_json(const Scene& scene, const std::vector<std::string>& inputs_outputs);

struct GraphRequest {
  std::string kind = "structure";             ///< structure, analysis or reduced
  std::string format = "dot";                 ///< dot or svg
  std::vector<std::string> inputs_outputs{};  ///< of the reduced graph, as above
};

/// A graph of bodies and joints; a kind or format of another name is a UsageError.
std::string graph_text(const Scene& scene, const GraphRequest& request, const NaturalLanguage& say = {});

}  // namespace torsor
