// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "torsor/generator/dynamics/motion/body_tree.hpp"
#include "torsor/generator/listing/computation.hpp"
#include "torsor/generator/program/passes.hpp"

namespace torsor {

/// The trees of one mechanism that recursions take. Without passes each is the tree of the scene.
struct BodyTrees {
  BodyTree with_bodies;    ///< with the inertia of its bodies
  BodyTree regrouped;      ///< for composite and articulated inertias
  BodyTree without_lines;  ///< for wrenches of inertia
};

/// What a pass is, by what it works on.
using OnBodies = void (*)(BodyTrees& trees);                              ///< links and inertia, before anything is derived
using OnResults = void (*)(Program& program, Computation& computation);  ///< other definitions of the same results
/// No function of its own: asked where the program makes definitions, or where these become a listing's statements.
struct Rule {
  const char* level;  ///< "program" or "listing"
  const char* why;    ///< why no function can do the same to what has been made; a sentence
};

struct Pass {
  const char* name;
  const char* effect;  ///< half a sentence
  bool Passes::*on;
  std::variant<Rule, OnBodies, OnResults> function;
  bool Passes::*needs = nullptr;  ///< another pass without which this one does nothing

  /// What it works on: "program", "listing", "bodies" or "results".
  const char* level() const;
};

/// All passes; those that are functions in the order in which they are called.
const std::vector<Pass>& all_passes();

/// Calls those passes of the table that are on, and that are functions of these arguments.
template <class... Arguments>
void run_passes(const Passes& passes, Arguments&... arguments) {
  for (const Pass& pass : all_passes()) {
    const auto* const function = std::get_if<void (*)(Arguments&...)>(&pass.function);
    const bool on = passes.*pass.on && (pass.needs == nullptr || passes.*pass.needs);
    if (function != nullptr && on) (*function)(arguments...);
  }
}

/// All passes but those of a comma-separated list. Throws UsageError naming an unknown one and listing the known ones.
Passes passes_without(const std::string& list);

}  // namespace torsor
