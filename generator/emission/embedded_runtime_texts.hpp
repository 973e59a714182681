// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace torsor {

/// A file of runtime/, by its path below that folder: headers that shared libraries of mechanisms are compiled with, and
/// with contacts/ those of units of FMI with contacts.
/// Throws Error for a name that is none.
std::string_view embedded_runtime_text(std::string_view name);

/// Their names, in alphabetical order.
std::vector<std::string_view> embedded_runtime_text_names();

}  // namespace torsor
