// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/emission/support.hpp"

#include <cstdint>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "torsor/generator/base/fnv.hpp"
#include "torsor/generator/emission/embedded_templates.hpp"
#include "torsor/generator/emission/text_template.hpp"

namespace torsor {

std::string template_without_licence(std::string_view name) {
  const std::string_view text = embedded_template(name);
  return std::string(text.substr(text.find('\n') + 1));
}

std::string support_text(bool selections, bool jets) {
  std::string text = fill_template("support.hpp.in", template_without_licence("support.hpp.in"),
                                   {{"sincos", template_without_licence("sincos.hpp") + template_without_licence("sincos_registers.hpp")}});
  if (selections) text += "\n" + template_without_licence("selections.hpp");
  if (jets) text += "\n" + template_without_licence("jets.hpp");
  return text;
}

std::string shared_support() {
  std::map<std::string, std::string> values = {{"version", TORSOR_VERSION}, {"support", support_text(true, true)}};
  const auto with_fingerprint = [&values](std::uint64_t bits) {
    values["fingerprint"] = fmt::format("{:016x}", bits);
    return fill_template("shared_support.hpp.in", embedded_template("shared_support.hpp.in"), values);
  };
  const std::string text = with_fingerprint(0);
  return with_fingerprint(Fnv().add(std::string_view(text).substr(text.find("#pragma once"))).value());
}

}  // namespace torsor
