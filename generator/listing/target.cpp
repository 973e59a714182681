// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/listing/target.hpp"

namespace torsor {

std::string Target::to_string() const {
  std::string text = member.empty() ? result : result + "." + member;
  if (entry) text += "[" + std::to_string(*entry) + "]";
  return text;
}

}  // namespace torsor
