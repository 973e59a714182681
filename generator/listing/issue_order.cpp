// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/issue_order.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>

#include "torsor/generator/listing/earliest_start.hpp"

namespace torsor {
namespace {

/// Values that registers hold, of 16 (AVX2) or 32 (AVX-512, ARM).
constexpr int held_values = 20;
/// Only so many definitions after the first that waits are looked at: what is near in the program shares its operands.
constexpr std::size_t horizon = 60;
/// Operations begun in a cycle, and the cycles that a processor looks ahead of one that waits.
constexpr double operations_in_a_cycle = 2.0, window = 30.0;

using NodeNumber = std::size_t;  // among the definitions

struct IssueNode {
  std::map<NodeNumber, int> operands;  ///< and the most cycles from there to its result
  std::vector<NodeNumber> users;
  int from_outside = 0;  ///< the cycle from which on other operands let its result be known
  int to_the_end = 0;    ///< cycles from its result to the last result of all
  int operations = 0;
  std::size_t missing = 0;  ///< operands not yet issued
  std::size_t uses = 0;     ///< users not yet issued
  double known = 0;         ///< the cycle of its result, once issued
};

std::vector<IssueNode> nodes_of(const Program& program, const EarliestStarts& starts,
                                const std::vector<ValueNumber>& definitions) {
  std::unordered_map<ValueNumber, NodeNumber> places;
  for (NodeNumber k = 0; k < definitions.size(); ++k) places.emplace(definitions[k], k);
  std::vector<IssueNode> nodes(definitions.size());
  // Users come after operands in the program: backwards, each one's way to the end is known when it is looked at.
  for (NodeNumber k = definitions.size(); k-- > 0;) {
    IssueNode& node = nodes[k];
    const Formula right_side = starts.scheduled(program[definitions[k]]);
    node.operations = std::max(1, count(right_side).total());
    starts.for_each_delay(right_side, [&](ValueNumber value_number, int cycles) {
      const auto place = places.find(value_number);
      if (place == places.end()) {
        node.from_outside = std::max(node.from_outside, starts(value_number) + cycles);
        return;
      }
      int& longest = node.operands[place->second];
      longest = std::max(longest, cycles);
    });
    node.missing = node.operands.size();
    for (const auto& [number, cycles] : node.operands) {
      IssueNode& operand = nodes[number];
      operand.to_the_end = std::max(operand.to_the_end, node.to_the_end + cycles);
      operand.users.push_back(k);
      ++operand.uses;
    }
  }
  return nodes;
}

class ListScheduling {
 public:
  explicit ListScheduling(std::vector<IssueNode> nodes) : nodes_(std::move(nodes)), issued_(nodes_.size(), false) {}

  std::vector<NodeNumber> run() {
    for (NodeNumber k = 0; k < nodes_.size(); ++k) {
      if (nodes_[k].missing == 0) waiting_.emplace(start(k), k);
    }
    while (order_.size() < nodes_.size()) {
      while (issued_[first_]) ++first_;
      while (!far_.empty() && far_.top() < first_ + horizon) {
        available_.insert(urgency(far_.top()));
        far_.pop();
      }
      while (!waiting_.empty() && waiting_.top().first <= cycle_) make_available();
      std::optional<NodeNumber> next = choice();
      while (!next) {
        make_available();
        next = choice();
      }
      issue(*next);
    }
    return order_;
  }

 private:
  using Urgency = std::pair<int, NodeNumber>;  ///< the smaller, the more urgent; ties in the program's order
  Urgency urgency(NodeNumber k) const { return {-nodes_[k].to_the_end, k}; }

  /// When its operands are there.
  double start(NodeNumber k) const {
    double time = 0;
    for (const auto& [operand, cycles] : nodes_[k].operands) time = std::max(time, nodes_[operand].known);
    return time;
  }

  /// Values that are live because of it, less those it is the last to use. A result goes to memory.
  int growth(NodeNumber k) const {
    int change = nodes_[k].uses > 0 ? 1 : 0;
    for (const auto& [operand, cycles] : nodes_[k].operands) change -= nodes_[operand].uses == 1 ? 1 : 0;
    return change;
  }

  void make_available() {
    const NodeNumber k = waiting_.top().second;
    waiting_.pop();
    if (k < first_ + horizon)
      available_.insert(urgency(k));
    else
      far_.push(k);
  }

  /// The most urgent of those that are available; where too many values are live the one that frees most.
  std::optional<NodeNumber> choice() const {
    std::optional<NodeNumber> best;
    int least = 0;
    for (const auto& [urgency, k] : available_) {
      if (live_ < held_values) return k;
      const int change = growth(k);
      if (!best || change < least) best = k, least = change;
    }
    return best;
  }

  void issue(NodeNumber k) {
    IssueNode& node = nodes_[k];
    available_.erase(urgency(k));
    order_.push_back(k);
    issued_[k] = true;
    live_ += growth(k);
    const double from = start(k);
    cycle_ = std::max(cycle_, from - window) + node.operations / operations_in_a_cycle;
    node.known = std::max(cycle_, static_cast<double>(node.from_outside));
    for (const auto& [operand, cycles] : node.operands) {
      node.known = std::max(node.known, nodes_[operand].known + cycles);
      --nodes_[operand].uses;
    }
    for (const NodeNumber user : node.users) {
      if (--nodes_[user].missing == 0) waiting_.emplace(start(user), user);
    }
  }

  std::vector<IssueNode> nodes_;
  std::vector<NodeNumber> order_;
  std::vector<bool> issued_;
  NodeNumber first_ = 0;         ///< the first in the program's order that is not issued
  std::set<Urgency> available_;  ///< near, and their operands are there
  std::priority_queue<NodeNumber, std::vector<NodeNumber>, std::greater<>> far_;  ///< the others whose operands are
  using Arrival = std::pair<double, NodeNumber>;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> waiting_;  ///< until their operands are
  double cycle_ = 0;
  int live_ = 0;
};

}  // namespace

std::vector<ValueNumber> issue_order(const Program& program, const EarliestStarts& starts,
                              const std::vector<ValueNumber>& definitions) {
  if (!program.passes().scheduling) return definitions;
  // Constants of the generation stage are literals; what is computed once for all states needs no haste.
  const auto is_urgent = [&](ValueNumber value_number) { return program[value_number].stage > Stage::parameters; };
  std::vector<ValueNumber> order, urgent;
  for (const ValueNumber value_number : definitions) (is_urgent(value_number) ? urgent : order).push_back(value_number);
  for (const NodeNumber k : ListScheduling(nodes_of(program, starts, urgent)).run()) order.push_back(urgent[k]);
  return order;
}

}  // namespace torsor
