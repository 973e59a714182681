// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/command_words.hpp"

#include "torsor/generator/base/decimal.hpp"
#include "torsor/generator/base/shell_word.hpp"

namespace torsor {

std::string number_word(const Number& value) {
  std::string text = shortest(value.to_double());
  return parse_decimal(text) == value ? text : value.to_exact();
}

std::string name_of_file(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::string file_word(const std::string& name) { return shell_word(name.starts_with('-') ? "./" + name : name); }

}  // namespace torsor
