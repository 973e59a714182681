// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/import/xacro.hpp"

namespace torsor::testing_xacro {

/// What an expression prints.
inline std::string value_of(const std::string& expression) {
  const std::string content = "<robot name=\"r\"><a v=\"${" + expression + "}\"/></robot>";
  const std::string text = expand_xacro(content, "r.xacro", XacroOptions()).text;
  const std::size_t begin = text.find("v=\"") + 3;
  return text.substr(begin, text.rfind('"') - begin);
}

}  // namespace torsor::testing_xacro
