// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace torsor {

/// Text of a file of templates/, named by its path below that folder ("kernel.hpp.template"), as it stood when the
/// library was built: an installed generator needs no template path.
/// Throws Error naming the known templates when there is none of that name.
std::string_view embedded_template(std::string_view name);

/// Names of all templates, in alphabetical order.
std::vector<std::string_view> embedded_template_names();

}  // namespace torsor
