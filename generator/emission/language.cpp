// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/language.hpp"

#include <fmt/format.h>

namespace torsor {

std::vector<CodeLine> sines_in_arrays(const std::vector<AngleText>& angles, int group, const std::string& type,
                                      const std::function<std::string(std::size_t, const std::string&)>& call) {
  const std::string suffix = group == 1 ? "_" : fmt::format("{}_", group);
  std::string all;
  for (const AngleText& each : angles) all += (all.empty() ? "" : ", ") + each.angle;
  std::vector<CodeLine> lines{{fmt::format("const {} angles{}[] = {{{}}};", type, suffix, all)},
                              {fmt::format("{0} sines{1}[{2}], cosines{1}[{2}];", type, suffix, angles.size())},
                              {call(angles.size(), suffix)}};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    std::string locals;
    const auto take = [&](const std::string& name, const char* array) {
      if (name.empty()) return;
      locals += fmt::format("{} {} = {}{}[{}]", locals.empty() ? "const " + type : ",", name, array, suffix, i);
    };
    take(angles[i].sine, "sines");
    take(angles[i].cosine, "cosines");
    if (!locals.empty()) lines.push_back({locals + ";", angles[i].meaning});
  }
  return lines;
}

std::string coefficient_in_array(const Target& target, std::size_t size) {
  if (target.member == "last") return fmt::format("coefficients[{} * order + {}]", size, *target.entry);
  return fmt::format("coefficients[{}]", (target.member == "0" ? 0 : size) + *target.entry);
}

std::vector<CodeLine> order_in_arrays(const RecurrenceText& text) {
  std::vector<CodeLine> lines;
  for (const CodeLine& each : text.steps) lines.push_back({"  " + each.code, each.meaning});
  for (std::size_t i = 0; i < text.next.size(); ++i) {
    lines.push_back({fmt::format("  coefficients[{} * (k_ + 1) + {}] = {};", text.size, i, text.next[i])});
  }
  const std::size_t lanes = text.convolutions.size();
  for (std::size_t i = 0; i < lanes; ++i) {
    const auto& [left, right] = text.convolutions[i];
    lines.push_back(
        {fmt::format("  left_[{0} * k_ + {1}] = {2}, right_[{0} * k_ + {1}] = {3};", lanes, i, left, right)});
  }
  for (const char* each : {"  number_ = following_;", "  inverse_ = next_;", "}"}) lines.push_back({each});
  return lines;
}

}  // namespace torsor
