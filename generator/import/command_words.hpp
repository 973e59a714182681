// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "torsor/generator/base/number.hpp"
#include "torsor/generator/import/surfaces.hpp"

namespace torsor {

/// A rational number as the command line reads it back, to the last digit: a decimal where its double's shortest one is
/// the number itself, else a quotient ("1/3").
std::string number_word(const Number& value);

/// The name without folders: headers hold no path.
std::string name_of_file(const std::string& path);

/// The name of a file as one word of a shell; one that begins with a dash would be an option.
std::string file_word(const std::string& name);

/// " --friction file,elbow=2": the numbers of joints behind the words of an option; empty where there are none of both.
std::string joint_numbers(const std::string& option, const std::vector<std::pair<std::string, Number>>& values,
                          const std::string& words = "");

/// Throws UsageError where such a number is of a joint that is not among those `known`, which turn or slide, or is negative.
void check_joint_numbers(const std::string& option, const std::vector<std::pair<std::string, Number>>& values,
                         const std::vector<std::string>& known);

/// " --ground foot --ground-friction 0.8"; empty where nothing is named.
std::string surface_words(const std::string& option, const Surfaces& surfaces);

}  // namespace torsor
