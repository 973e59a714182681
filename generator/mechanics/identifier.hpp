// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsor {

/// Refuses a name that generated code could not carry: letters, digits and single underscores inside, a letter first, no
/// C++ keyword. `what` says what is named ("parameter"). Throws SceneError with the name and the remedy.
void require_identifier(const std::string& name, const std::string& what);

}  // namespace torsor
