// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace torsor {

/// What all C++ headers have in common, without includes: sines and cosines, what kernels need of their scalar,
/// conventions. With `selections` also functions that take one of several forms, with `jets` convolutions.
std::string support_text(bool selections, bool jets);

/// All of it as one file, which headers include that were made with its name.
std::string shared_support();

/// Text of a template behind its first line, the licence.
std::string template_without_licence(std::string_view name);

}  // namespace torsor
