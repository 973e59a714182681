// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "torsor/generator/cli/command_texts.hpp"
#include "torsor/generator/verification/ball.hpp"
#include "torsor/generator/verification/worst.hpp"

namespace torsor {
namespace {

std::string figure(double value) {
  if (value > 1e17) return ">1e17";  // no digit is right
  return value < 1e5 ? fmt::format("{:.2f}", value) : fmt::format("{:.1e}", value);
}

/// Of the bound; an infinite one says nothing.
std::string share_of_bound(const VerifyRow& row) {
  if (!std::isfinite(row.worst.bound)) return "none";
  return fmt::format("{:.3f}", row.worst.bound == 0 ? 0 : row.worst.error / row.worst.bound);
}

const char* verdict(const VerifyRow& row) {
  if (!row.worst.counted) return "NONE";
  if (!row.bounded()) return "BOUND";
  if (!row.passed()) return "FAIL";
  return row.worst.scaled > accuracy_bar ? "excpt" : "ok";
}

/// Of each kernel in each format the group with the largest scaled error.
std::vector<VerifyRow> worst_of_kernels(const std::vector<VerifyRow>& rows) {
  std::vector<VerifyRow> worst;
  for (const VerifyRow& row : rows) {
    const auto same = [&](const VerifyRow& each) { return each.kernel == row.kernel && each.scalar == row.scalar; };
    const auto place = std::find_if(worst.begin(), worst.end(), same);
    if (place == worst.end()) {
      worst.push_back(row);
    } else if (row.passed() != place->passed() ? place->passed() : is_worse(row.worst.scaled, place->worst.scaled)) {
      *place = row;
    }
  }
  return worst;
}

}  // namespace

std::string verify_table(const std::string& scene, const std::vector<VerifyRow>& all, const VerifyLayout& layout) {
  const std::vector<VerifyRow> rows = layout.every_group ? all : worst_of_kernels(all);
  std::string text =
      fmt::format("{}: worst errors in ulp, scaled by max(1, condition); at most {} are allowed\n"
                  "{:<6}{:<7}{:<37}{:<44}{:>9}{:>10}{:>9}{:>9}{:>9}  {}\n",
                  scene, accuracy_bar, "", "scalar", "kernel", "group", "error", "condition", "scaled", "of bound",
                  "at most", "seed");
  for (const VerifyRow& row : rows) {
    text += fmt::format("{:<6}{:<7}{:<37}{:<44}{:>9}{:>10}{:>9}{:>9}{:>9}  {}{}\n", verdict(row), row.scalar,
                        row.kernel, row.group, figure(row.worst.error), figure(row.worst.condition),
                        figure(row.worst.scaled), share_of_bound(row), figure(row.potential), row.seed,
                        row.searched ? " searched" : "");
    if (layout.with_states || !row.passed()) text += fmt::format("      at {}\n", row.state);
    if (!row.remark.empty()) text += fmt::format("      {}\n", row.remark);
    if (row.undefined > 0) {
      text += fmt::format("      without a result (0/0) and without a status at {} more states\n", row.undefined);
    }
    if (row.worst.scaled > accuracy_bar && !row.reason.empty()) {
      text += fmt::format("      exception, up to {}: {}\n", row.limit, row.reason);
    }
  }
  const auto counted = [&](auto belongs) { return std::count_if(all.begin(), all.end(), belongs); };
  text += fmt::format("{} of {} groups pass", counted([](const VerifyRow& row) { return row.passed(); }), all.size());
  if (Ball::available()) {
    text += fmt::format("; balls enclose the exact results of {}",
                        counted([](const VerifyRow& row) { return row.worst.enclosed; }));
  }
  return text + "\n";
}

std::string verify_markdown(const std::string& scene, const std::vector<VerifyRow>& rows) {
  const auto counted = [&](auto belongs) { return std::count_if(rows.begin(), rows.end(), belongs); };
  const auto within = [](const VerifyRow& row) { return row.worst.scaled <= accuracy_bar; };
  std::string text =
      fmt::format("| {} | {} | {} | {} |", scene, rows.size(), counted(within),
                  counted([](const VerifyRow& row) { return row.worst.enclosed; }));
  for (const char* scalar : {"double", "float"}) {
    const VerifyRow* worst = nullptr;
    for (const VerifyRow& row : rows) {
      if (row.scalar == scalar && (worst == nullptr || is_worse(row.worst.scaled, worst->worst.scaled))) worst = &row;
    }
    if (worst == nullptr) {
      text += " | | |";
      continue;
    }
    text += fmt::format(" {} {} | {} | {} |", worst->kernel, worst->group, figure(worst->worst.scaled),
                        share_of_bound(*worst));
  }
  return text + "\n";
}

std::string verify_json(const std::string& scene, const std::vector<VerifyRow>& rows) {
  // JSON has neither infinity nor NaN: null says that there is no number.
  const auto number = [](double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
  };
  nlohmann::ordered_json groups = nlohmann::ordered_json::array();
  for (const VerifyRow& row : rows) {
    groups.push_back({{"scalar", row.scalar},
                      {"kernel", row.kernel},
                      {"group", row.group},
                      {"error", number(row.worst.error)},
                      {"condition", number(row.worst.condition)},
                      {"scaled", number(row.worst.scaled)},
                      {"bound", number(row.worst.bound)},
                      {"enclosed", row.worst.enclosed},
                      {"potential", number(row.potential)},
                      {"limit", row.limit},
                      {"reason", row.reason},
                      {"seed", row.seed},
                      {"searched", row.searched},
                      {"state", row.state},
                      {"states", row.states},
                      {"undefined", row.undefined},
                      {"remark", row.remark},
                      {"passed", row.passed()}});
  }
  const bool passed = std::all_of(rows.begin(), rows.end(), [](const VerifyRow& row) { return row.passed(); });
  return nlohmann::ordered_json{{"name", scene}, {"passed", passed}, {"groups", groups}}.dump(2) + "\n";
}

}  // namespace torsor
