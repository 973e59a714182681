// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator/expression/error.hpp"

#include "generator/expression/printable.hpp"

namespace torsor {

Error::Error(const std::string& message) : std::runtime_error(printable(message)) {}

}  // namespace torsor
