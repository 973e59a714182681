// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "torsor/generator/base/number.hpp"

namespace torsor {

/// A rational number as the command line reads it back, to the last digit: a decimal where its double's shortest one is
/// the number itself, else a quotient ("1/3").
std::string number_word(const Number& value);

/// The name without folders: headers hold no path.
std::string name_of_file(const std::string& path);

/// The name of a file as one word of a shell; one that begins with a dash would be an option.
std::string file_word(const std::string& name);

}  // namespace torsor
