// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/command_words.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/did_you_mean.hpp"
#include "torsor/generator/base/error.hpp"
#include "torsor/generator/base/shell_word.hpp"

namespace torsor {

std::string number_word(const Number& value) {
  std::string text = shortest(value.to_double());
  return parse_decimal(text) == value ? text : value.to_exact();
}

std::string name_of_file(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::string joint_numbers(const std::string& option, const std::vector<std::pair<std::string, Number>>& values,
                          const std::string& words) {
  std::vector<std::string> all;
  if (!words.empty()) all.push_back(words);
  for (const auto& [joint, value] : values) all.push_back(joint + "=" + number_word(value));
  return all.empty() ? "" : fmt::format(" {} {}", option, shell_word(fmt::format("{}", fmt::join(all, ","))));
}

void check_joint_numbers(const std::string& option, const std::vector<std::pair<std::string, Number>>& values,
                         const std::vector<std::string>& known) {
  for (const auto& [name, value] : values) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      throw UsageError(fmt::format("unknown joint '{}' in {}: {}those that turn or slide are {}", name, option,
                                   did_you_mean(name, known), fmt::join(known, ", ")));
    }
    if (value.sign() < 0) {
      throw UsageError(fmt::format("{} of the joint '{}' is {}; it is never negative", option, name,
                                   shortest(value.to_double())));
    }
  }
}

std::string surface_words(const std::string& option, const Surfaces& surfaces) {
  if (surfaces.named.empty()) return "";
  std::string text = fmt::format(" {} {}", option, shell_word(fmt::format("{}", fmt::join(surfaces.named, ","))));
  if (!(surfaces.friction == Surfaces().friction)) text += fmt::format(" {}-friction {}", option, number_word(surfaces.friction));
  if (!surfaces.restitution.is_zero()) text += fmt::format(" {}-restitution {}", option, number_word(surfaces.restitution));
  return text;
}

std::string file_word(const std::string& name) { return shell_word(name.starts_with('-') ? "./" + name : name); }

}  // namespace torsor
