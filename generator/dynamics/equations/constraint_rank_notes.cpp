// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/dynamics/equations/constraint_rank.hpp"

namespace torsor {

std::vector<std::string> notes(const ConstraintRank& rank, const Scene& scene, const NaturalLanguage& say) {
  const SceneContent& content = scene.content();
  std::vector<std::string> sentences;
  if (rank.redundant()) {
    std::string dropped, shared, reactions;
    const auto add = [](std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; };
    for (const std::size_t j : rank.dropped) add(dropped, content.constraints[j].name);
    for (const std::size_t j : rank.kept) {
      if (!rank.determinate[j]) add(shared, content.constraints[j].multiplier->name);
    }
    std::size_t released = 0;
    for (const CoordinateContent& c : content.coordinates) {
      if (c.released && !c.law && !rank.determinate_released[released++]) add(reactions, c.q->name);
    }
    sentences.push_back(
        say("Constraints that repeat others are left out, their multipliers are 0: {}.", dropped));
    if (rank.loses_rank()) {
      sentences.push_back(
          say("Those kept lose rank at places of the motion where one left out counts; these are no change points, and "
              "accelerations lose digits near them."));
    }
    if (!shared.empty()) {
      sentences.push_back(
          say("Indeterminate, as they are shared with those in a way that no motion tells: {}.", shared));
    }
    if (!reactions.empty())
      sentences.push_back(say("Indeterminate reactions for the same reason: {}.", reactions));
  }
  if (rank.singular_start()) {
    sentences.push_back(
        say("The initial configuration is singular: {} of {} constraints are independent there.",
            rank.rank_at_start, rank.kept.size()));
  }
  return sentences;
}

}  // namespace torsor
