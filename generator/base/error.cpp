// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/base/error.hpp"

#include "torsor/generator/base/printable.hpp"

namespace torsor {

Error::Error(const std::string& message) : std::runtime_error(printable(message)) {}

}  // namespace torsor
